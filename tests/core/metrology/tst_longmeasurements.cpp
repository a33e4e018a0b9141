// SPDX-License-Identifier: GPL-3.0-or-later
// Files that are read in pieces: what is in them, and which lines are named, as if there were none.
#include "tests/core/metrology/measurement_reading.h"
#include "tests/support/test_registry.h"

#include <array>
#include <cmath>

namespace tst_longmeasurements {

using namespace axiscomp;

namespace {

constexpr int pointCount = 60'000; // some megabytes

struct Form {
    const char* separator = ",";
    char decimal = '.';
    const char* lineEnd = "\n";
};

std::string written(double value, char decimal)
{
    std::string text = std::to_string(value);
    text[text.find('.')] = decimal;
    return text;
}

double x(int point)
{
    return 0.25 * point;
}
double y(int point)
{
    return -0.5 * (point % 977);
}
double error(int point)
{
    return 0.125 * (point % 61) - 3.0;
}

/// The lines of the points, each behind what stands before it.
template <typename Before> std::string pointsText(const Form& form, Before before)
{
    const std::string separator = form.separator;
    std::string text =
        "X [mm]" + separator + "Y [mm]" + separator + "dX [um]" + std::string(form.lineEnd);
    for (int point = 0; point < pointCount; ++point)
        text += before(point) + written(x(point), form.decimal) + separator
            + written(y(point), form.decimal) + separator + written(error(point), form.decimal)
            + form.lineEnd;
    return text;
}

bool isWhole(const MeasurementReading& reading)
{
    if (!reading.measurement)
        return false;
    const MeasuredPoints& points = reading.measurement->points;
    if (points.size() != pointCount)
        return false;
    for (int i = 0; i < pointCount; ++i) {
        const auto n = static_cast<std::size_t>(i);
        if (points.positions[0][n] != x(i) || points.positions[1][n] != y(i)
            || std::abs(points.values[0][n] - 0.001 * error(i)) > 1e-15)
            return false;
    }
    return true;
}

std::string nothing(int)
{
    return {};
}

} // namespace

class tst_LongMeasurements : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void everyPointIsRead_data()
    {
        QTest::addColumn<QString>("text");
        const auto row = [](const char* name, const std::string& text) {
            QTest::newRow(name) << QString::fromStdString(text);
        };
        row("commas", pointsText({}, nothing));
        row("blanks round the numbers", pointsText({" , "}, nothing));
        row("decimal commas", pointsText({";", ','}, nothing));
        row("CR LF", pointsText({",", '.', "\r\n"}, nothing));
        row("CR", pointsText({",", '.', "\r"}, nothing));
        row("blank lines and comments", pointsText({}, [](int point) {
            return std::string(point % 97 == 0 ? "\n" : point % 89 == 0 ? "// pause\n" : "");
        }));
        // Nowhere else does a piece end with lines that are no data.
        row("comments longer than a piece", pointsText({}, [](int point) {
            std::string comments;
            for (int i = 0; point == 30'000 && i < 40'000; ++i)
                comments += "// nothing is measured\n";
            return comments;
        }));
    }
    void everyPointIsRead()
    {
        QFETCH(const QString, text);
        QVERIFY(isWhole(test::readAs("points", text.toStdString())));
    }

    void numbersOfEveryFormAreTheSame()
    {
        std::string text = "X [mm],Y [mm],dX [um]\n";
        constexpr std::array numbers{
            "0.125", "+0.125", "\"0.125\"", "1.25e-1", ".125", "0.12500000000000000000"};
        for (std::size_t point = 0; point < pointCount; ++point)
            text += std::to_string(point) + ",7," + numbers[point % 11 % numbers.size()] + "\n";
        const MeasurementReading reading = test::readAs("points", text);
        QVERIFY(reading.measurement);
        for (const double value : reading.measurement->points.values[0])
            QCOMPARE(value, 0.125 * 0.001);
    }

    void aFaultIsNamedByItsLine_data()
    {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<DiagnosticCode>("code");
        QTest::newRow("no number") << QByteArray("10,20,about 3") << DiagnosticCode::NotANumber;
        QTest::newRow("a cell too few") << QByteArray("10,20") << DiagnosticCode::ColumnCount;
        QTest::newRow("a cell too many")
            << QByteArray("10,20,0.5,7") << DiagnosticCode::ColumnCount;
    }
    void aFaultIsNamedByItsLine()
    {
        QFETCH(const QByteArray, line);
        QFETCH(const DiagnosticCode, code);
        const std::string text = pointsText({}, [&](int point) {
            return point == 40'000 ? line.toStdString() + "\n"
                : point == 20'000  ? "// a comment\n\n"
                                   : std::string();
        });
        const MeasurementReading reading = test::readAs("points", text);
        QVERIFY(!reading.measurement);
        QCOMPARE(reading.diagnostics.size(), std::size_t{1});
        QCOMPARE(reading.diagnostics[0].code, code);
        QCOMPARE(reading.diagnostics[0].line, std::size_t{1 + 2 + 40'000 + 1});
    }
};

AXISCOMP_TEST(tst_LongMeasurements)

} // namespace tst_longmeasurements

#include "tst_longmeasurements.moc"
