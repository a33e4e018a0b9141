// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// On Windows GCC does not align the stack for vectors of 32 and more bytes, and such code may crash
// (GCC bug 54412).
#if defined(__x86_64__) && !defined(_WIN32)
#define AXISCOMP_HAS_WIDE_VECTORS
#endif

namespace axiscomp {

/// Instructions for several numbers at a time. Whichever are used, results have the same bits.
enum class InstructionSet {
    Baseline, ///< what every processor has that the program is built for; two numbers
    Avx2, ///< four
    Avx512, ///< eight
};

/// Whether this processor has them, and the program was built with them.
[[nodiscard]] bool isSupported(InstructionSet instructions);

/// The fastest of those that are supported.
[[nodiscard]] InstructionSet bestInstructionSet();

} // namespace axiscomp
