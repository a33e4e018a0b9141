// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

enum class Severity { Warning, Error };

/// docs/calibration-csv.md, "What goes wrong"; further ones for the tables of other controllers.
enum class DiagnosticCode {
    EmptyFile,
    NoHeader,
    TooFewColumns,
    ColumnCount,
    NotANumber,
    NotFinite,
    MixedDecimals,
    UnterminatedQuote,
    DuplicatePoint,
    MissingPoint,
    UnevenSpacing,
    OtherDimensionality,
    TooFewPoints,
    TooLarge,
    NotText,
    IoError,
    // tables of other controllers (docs/formats.md)
    Syntax,
    Contradiction,
    NotMonotonic,
    NotPeriodic,
    LimitExceeded,
    // measurements (docs/metrology.md)
    MissingColumn,
    UnitMissing,
    UnitMixed,
    BadDirection,
    BadRun,
    DuplicateValue,
    CountMismatch,
    TooFewTargets,
    UnknownTargetNumber,
    InstrumentScale,
    // warnings
    IncompleteRuns,
    UnequalRuns,
    ValuesLookLikePositions,
    UnitSuspicious,
    DirectionsDoubtful,
    PublishedContradiction,
    LeftOut,
    Encoding,
    RoundedSpacing,
    FloatPrecision,
    LargeGradient,
    ConstantTable,
    FilledPoints,
    CroppedGrid,
    SnappedPositions,
    DroppedComments,
    UnknownKey,
    UnitNotGiven,
    TargetNotKnown,
    Assumption,
};

/// One problem of a file. `line` and `column` are 1-based; 0 means the whole file or the whole
/// line. For a table row, `column` is the column of the table (1 = first field), not the character.
struct Diagnostic {
    Severity severity = Severity::Error;
    DiagnosticCode code = DiagnosticCode::IoError;
    std::size_t line = 0;
    std::size_t column = 0;
    Text found; ///< characters of the file, or a description: quotesFile(code)
    Text expected;
    std::string controllerError =
        {}; ///< "4900": the number that the controller itself gives this error

    friend bool operator==(const Diagnostic&, const Diagnostic&) = default;
};

/// "NotANumber"
[[nodiscard]] std::string_view diagnosticName(DiagnosticCode code);

/// Whether `found` are characters of the file, which are shown in quotation marks.
[[nodiscard]] bool quotesFile(DiagnosticCode code);

/// "this is not a number: found "1,5x", expected a number such as 0.5"
[[nodiscard]] Text textOf(const Diagnostic& diagnostic);

/// The same in English, with the name and the controller's number: what follows FILE:LINE:COLUMN:
/// error:
[[nodiscard]] std::string message(const Diagnostic& diagnostic);

/// Collects the problems of one file, up to a maximum; further errors are counted.
class DiagnosticList {
public:
    explicit DiagnosticList(std::size_t maximum) : m_maximum(maximum) { }

    void error(
        DiagnosticCode code, std::size_t line, std::size_t column, Text found, Text expected);
    void warning(
        DiagnosticCode code, std::size_t line, std::size_t column, Text found, Text expected);
    /// With the number that the controller itself gives this error.
    void error(Diagnostic diagnostic);
    /// Counts errors that are not worth a diagnostic each.
    void countErrors(std::size_t count);

    /// Adds what another list of the same maximum holds, as if it had been found after all of this.
    void append(DiagnosticList following);

    [[nodiscard]] std::size_t maximum() const { return m_maximum; }
    /// True when a further error would only be counted.
    [[nodiscard]] bool isFull() const { return m_items.size() >= m_maximum; }
    [[nodiscard]] bool hasErrors() const { return m_hasErrors; }
    [[nodiscard]] std::size_t suppressed() const { return m_suppressed; }

    /// In the order of the file, what concerns the whole file last.
    [[nodiscard]] std::vector<Diagnostic> take();

private:
    std::size_t m_maximum;
    std::vector<Diagnostic> m_items;
    std::vector<Diagnostic> m_warnings;
    std::size_t m_suppressed = 0;
    bool m_hasErrors = false;
};

} // namespace axiscomp
