// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/csv/calibration_csv.h"
#include "tests/support/verify.h"

#include <QByteArrayList>

namespace axiscomp::test {

inline CsvReading parse(const QByteArray& text, int dimensions, CsvOptions options = {})
{
    options.dimensions = dimensions;
    return parseCalibrationCsv({text.constData(), static_cast<std::size_t>(text.size())}, options);
}

/// "3:2 NotANumber found|expected"
inline QByteArray describe(const Diagnostic& diagnostic)
{
    const std::string text = std::to_string(diagnostic.line) + ':'
        + std::to_string(diagnostic.column) + ' ' + std::string(diagnosticName(diagnostic.code))
        + ' ' + diagnostic.found.english() + '|' + diagnostic.expected.english();
    return QByteArray::fromStdString(text);
}

inline QByteArrayList describe(const CsvReading& reading)
{
    QByteArrayList lines;
    for (const Diagnostic& diagnostic : reading.diagnostics)
        lines += describe(diagnostic);
    return lines;
}

} // namespace axiscomp::test
