// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/calibration_csv.h"
#include "tests/support/test_registry.h"
#include "ui/data/vector_columns.h"

#include <QTest>

namespace tst_vectorcolumns {

using namespace axiscomp;
using namespace axiscomp::ui;

namespace {

using Columns = std::vector<std::size_t>;

/// A file of two points in each dimension with these columns of values.
CalibrationData dataOf(const std::string& header, int dimensions)
{
    std::string text = header + '\n';
    const auto columns = static_cast<int>(std::ranges::count(header, ','));
    for (int point = 0; point < 1 << dimensions; ++point) {
        for (int n = 0; n < dimensions; ++n)
            text += std::to_string((point >> n & 1) * 10) + ',';
        for (int n = dimensions; n <= columns; ++n)
            text += n < columns ? "0.5," : "0.5\n";
    }
    CsvOptions options;
    options.dimensions = dimensions;
    auto reading = parseCalibrationCsv(text, options);
    if (!reading.data)
        qFatal("the test's file is no calibration file");
    return *reading.data;
}

} // namespace

class TestVectorColumns : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theErrorsOfTwoSourcesAreAPlane()
    {
        const auto columns =
            vectorColumns(dataOf("X [mm],Y [mm],Z error,Y error [um],X error [um]", 2).tables);
        QCOMPARE(columns.ofDimension[0], Columns{2});
        QCOMPARE(columns.ofDimension[1], Columns{1});
        QVERIFY(columns.hasPlane(0, 1) && columns.hasAnyPlane());
    }

    void oneAxisAloneIsNone()
    {
        QVERIFY(!vectorColumns(dataOf("X [mm],Y [mm],X error,Z error", 2).tables).hasAnyPlane());
        QVERIFY(!vectorColumns(dataOf("X [mm],X error,Y error", 1).tables).hasAnyPlane());
        QVERIFY(!vectorColumns(dataOf("X [mm],Y [mm],table 1,table 2", 2).tables).hasAnyPlane());
    }

    void ofAVolumeEachPlaneThatHasBoth()
    {
        const auto columns =
            vectorColumns(dataOf("X [mm],Y [mm],Z [mm],X error,Z error,dX", 3).tables);
        QCOMPARE(columns.ofDimension[0], (Columns{0, 2}));
        QVERIFY(columns.hasPlane(0, 2) && !columns.hasPlane(0, 1) && !columns.hasPlane(1, 2));
    }

    void anAngleAlongALengthIsLeftOut()
    {
        QVERIFY(!vectorColumns(dataOf("X [mm],Y [mm],X error [arcsec],Y error [um]", 2).tables)
                     .hasAnyPlane());
        QVERIFY(vectorColumns(dataOf("X [mm],C [deg],X error [um],C error [arcsec]", 2).tables)
                    .hasAnyPlane());
    }

    void errorsAreBroughtToTheUnitOfTheirPositions()
    {
        const auto data = dataOf("X [mm],C [deg],X error [um],C error [arcsec],X error", 2);
        QCOMPARE(positionsPerValue(data.tables[0], 0), 0.001);
        QVERIFY(std::abs(positionsPerValue(data.tables[1], 1) * 3600.0 - 1.0) < 1e-12);
        QCOMPARE(positionsPerValue(data.tables[2], 0), 1.0);
    }
};

AXISCOMP_TEST(TestVectorColumns)

} // namespace tst_vectorcolumns

#include "tst_vectorcolumns.moc"
