// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/formats/measurement_format.h"
#include "tests/support/file_content.h"
#include "tests/support/verify.h"

#include <QByteArrayList>

namespace axiscomp::test {

inline MeasurementReading readAs(
    std::string_view format, std::string_view text, const MeasurementReadOptions& options = {})
{
    const auto known = measurementFormatNamed(format);
    return known ? (*known)->read(text, options) : MeasurementReading{};
}

/// "3:2 BadRun found|expected"
inline QByteArrayList describe(const MeasurementReading& reading)
{
    QByteArrayList lines;
    for (const Diagnostic& d : reading.diagnostics)
        lines += QByteArray::fromStdString(std::to_string(d.line) + ':' + std::to_string(d.column)
            + ' ' + std::string(diagnosticName(d.code)) + ' ' + d.found.english() + '|'
            + d.expected.english());
    return lines;
}

inline std::string publicMeasurement(const std::string& name)
{
    return contentOf(AXISCOMP_SOURCE_FOLDER "/tests/data/metrology/" + name);
}

} // namespace axiscomp::test

/// Fails with the problems of a reading that has no measurement. Evaluates reading once.
#define VERIFY_MEASUREMENT(reading)                                                                \
    do {                                                                                           \
        const auto& verifiedReading = (reading);                                                   \
        QVERIFY2(verifiedReading.measurement.has_value(),                                          \
            axiscomp::test::describe(verifiedReading).join('\n').constData());                     \
    } while (false)
