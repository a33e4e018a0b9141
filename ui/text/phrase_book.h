// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <span>
#include <string>

namespace axiscomp::ui {

/// The sentences that core and drivecomm make, in English and with {placeholders}, as the
/// translations (context "Error") have them. tests/ui compares them with core's.
[[nodiscard]] std::span<const char* const> knownPhrases();

// Its parts, a file of phrases each.
[[nodiscard]] std::span<const char* const> errorPhrases();
[[nodiscard]] std::span<const char* const> planPhrases();
[[nodiscard]] std::span<const char* const> filePhrases();
[[nodiscard]] std::span<const char* const> calibrationPhrases();
[[nodiscard]] std::span<const char* const> linkPhrases();
[[nodiscard]] std::span<const char* const> formatPhrases(); ///< of the registry of formats
[[nodiscard]] std::span<const char* const> conversionPhrases();
[[nodiscard]] std::span<const char* const> tablePhrases(); ///< what all formats have in common
[[nodiscard]] std::span<const char* const> gridPhrases();
[[nodiscard]] std::span<const char* const> motionPhrases();
[[nodiscard]] std::span<const char* const> machinePhrases();

/// The keys of the settings of formats, with blanks in place of "-", and what can be chosen for
/// them (context "Setting").
[[nodiscard]] std::span<const char* const> settingPhrases();

/// Whether the text says what is wrong with a file, or what to do about it (context "Problem").
[[nodiscard]] bool isProblemPhrase(const QString& english);

/// An English text that was made from one of the phrases, in the language of the window; what its
/// placeholders hold is translated in the same way. {number}, {number2} ... stand for numbers only,
/// the others for any text; what stands between quotation marks is a quotation and stays as it is.
/// A text that is not known stays as it is, but for the decimal sign of a number ("0.5 mm").
[[nodiscard]] QString translatedPhrase(const std::string& english);

/// What a placeholder holds, in the language of the window. Names, and what a person shall write
/// like this, keep their decimal point.
[[nodiscard]] QString placeholderText(const QString& name, const std::string& english);

} // namespace axiscomp::ui
