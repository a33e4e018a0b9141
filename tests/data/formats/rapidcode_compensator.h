// Table of a RapidCode compensator, for CompensatorConfigSet.
// Input: "X" in user units (mm), "Y" in user units (mm).
// Output: "Z" in raw counts, 1000 for 1 mm.
// Note: the inputs are other axes: their command or their actual positions can be the inputs.
#pragma once

namespace z_flatness {

constexpr double firstMinimum = 0;
constexpr double firstMaximum = 200000;
constexpr double firstDelta = 50000;
constexpr int firstPoints = 5;

constexpr double secondMinimum = 25000;
constexpr double secondMaximum = 225000;
constexpr double secondDelta = 10000;
constexpr int secondPoints = 21;

constexpr int points = 105;

// The first axis changes fastest.
constexpr double table[points] = {
    421, 455, 71, -378, -479,
    -140, 328, 495, 206, -272,
    -500, -268, 210, 495, 325,
    -144, -481, -375, 75, 456,
    418, -4, -423, -453, -66,
    381, 478, 135, -332, -494,
    -202, 276, 500, 265, -214,
    -496, -322, 148, 482, 373,
    -79, -458, -416, 9, 425,
    451, 62, -384, -477, -131,
    335, 493, 198, -279, -500,
    -261, 218, 496, 318, -152,
    -483, -370, 84, 460, 413,
    -13, -428, -449, -57, 387,
    476, 127, -338, -493, -194,
    283, 500, 257, -222, -497,
    -315, 157, 484, 367, -88,
    -462, -411, 18, 430, 447,
    53, -390, -474, -123, 342,
    492, 190, -287, -500, -253,
    226, 497, 311, -161, -485,
};

} // namespace z_flatness
