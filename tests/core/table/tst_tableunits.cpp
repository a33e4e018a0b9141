// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/table_units.h"

#include "core/table/target_axis.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <cmath>
#include <limits>

namespace tst_tableunits {

using namespace axiscomp;

namespace {

/// Every unit with its size in metres or radians, as the SI brochure and the international inch
/// have it.
struct Size {
    const char* unit;
    double size;
};
constexpr double pi = 3.14159265358979323846;
constexpr Size lengths[] = {{"nm", 1e-9}, {"um", 1e-6}, {"\u00b5m", 1e-6}, {"mm", 1e-3},
    {"cm", 1e-2}, {"m", 1.0}, {"inch", 0.0254}, {"in", 0.0254}, {"mil", 0.0000254}, {"Meter", 1.0},
    {"Millimeter", 1e-3}};
constexpr Size angles[] = {{"urad", 1e-6}, {"mrad", 1e-3}, {"rad", 1.0}, {"deg", pi / 180},
    {"\u00b0", pi / 180}, {"mdeg", pi / 180000}, {"arcmin", pi / 10800}, {"arcsec", pi / 648000},
    {"turn", 2 * pi}, {"turns", 2 * pi}, {"Radian", 1.0}, {"Degree", pi / 180}};

CompensationTable tableIn(const std::string& values, const std::string& positions)
{
    CompensationTable table;
    table.name = "E";
    table.unit = values;
    table.grid.axes = {{"X", positions, -12.5, 6.25, 5}};
    table.values = {0.0F, 1.25F, -0.333333343F, 7.0e-4F, -123.456F};
    return table;
}

bool isWithinOneUlp(float value, double expected)
{
    const auto exact = static_cast<float>(expected);
    return value >= std::nextafter(exact, -std::numeric_limits<float>::infinity())
        && value <= std::nextafter(exact, std::numeric_limits<float>::infinity());
}

QStringList remarksOf(const TableInUnits& table)
{
    QStringList remarks;
    for (const Text& remark : table.remarks)
        remarks.append(QString::fromStdString(remark.english()));
    return remarks;
}

template <std::size_t N> void convertAll(const Size (&units)[N])
{
    for (const Size& from : units) {
        for (const Size& to : units) {
            const double factor = from.size / to.size;
            const CompensationTable table = tableIn(from.unit, from.unit);
            const auto result = inDriveUnits(table, {to.unit, {to.unit}});
            const QByteArray pair = QByteArray(from.unit) + " to " + to.unit;
            QVERIFY2(result.has_value(), pair.constData());
            for (std::size_t n = 0; n < table.values.size(); ++n)
                QVERIFY2(isWithinOneUlp(result->table.values[n], table.values[n] * factor),
                    (pair + ", value " + QByteArray::number(table.values[n]) + " became "
                        + QByteArray::number(result->table.values[n], 'g', 9))
                        .constData());
            const GridAxis& axis = result->table.grid.axes.front();
            QVERIFY2(
                isWithinOneUlp(static_cast<float>(axis.start), -12.5 * factor), pair.constData());
            QVERIFY2(
                isWithinOneUlp(static_cast<float>(axis.last()), 12.5 * factor), pair.constData());
        }
    }
}

} // namespace

class TestTableUnits : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void everyLengthIsConvertedToEveryOther() { convertAll(lengths); }
    void everyAngleIsConvertedToEveryOther() { convertAll(angles); }

    void aLengthIsNoAngle()
    {
        for (const Size& length : lengths) {
            for (const Size& angle : angles) {
                const auto values = inDriveUnits(tableIn(length.unit, ""), {angle.unit, {}});
                QVERIFY2(!values && values.error().code == ErrorCode::UnitMismatch, length.unit);
                const auto positions =
                    inDriveUnits(tableIn("", angle.unit), {"Millimeter", {length.unit}});
                QVERIFY2(
                    !positions && positions.error().code == ErrorCode::UnitMismatch, angle.unit);
            }
        }
    }

    void anUnknownUnitIsRefusedByName()
    {
        const auto result = inDriveUnits(tableIn("counts", ""), {"Millimeter", {}});
        VERIFY_ERROR(result, ErrorCode::UnitMismatch);
        QVERIFY2(test::describe(result.error()).find("values are in counts") != std::string::npos,
            test::describe(result.error()).c_str());
    }

    void anAxisWithoutUnitTakesNoLength()
    {
        VERIFY_ERROR(inDriveUnits(tableIn("um", ""), {"None", {}}), ErrorCode::UnitMismatch);
        VERIFY_ERROR(inDriveUnits(tableIn("", "mm"), {"None", {"None"}}), ErrorCode::UnitMismatch);
    }

    void aConversionIsSaidWithTheLargestCorrection()
    {
        const auto result = inDriveUnits(tableIn("um", "m"), {"Millimeter", {"Millimeter"}});
        VERIFY_RESULT(result);
        QCOMPARE(remarksOf(*result),
            QStringList({QStringLiteral("The values are converted from um to mm. The largest "
                                        "correction is 0.123456 mm."),
                QStringLiteral("The positions of dimension 1 are converted from m to mm: "
                               "-12500 mm to 12500 mm.")}));
        QCOMPARE(QString::fromStdString(result->table.unit), QStringLiteral("mm"));
        QCOMPARE(
            QString::fromStdString(result->table.grid.axes.front().unit), QStringLiteral("mm"));
    }

    /// AN140 3.1. Of another kind of axis they cannot be: then the drive's unit is assumed.
    void valuesWithoutAUnitAreInThatOfTheirPositions()
    {
        const auto result = inDriveUnits(tableIn("", "um"), {"Millimeter", {"Millimeter"}});
        VERIFY_RESULT(result);
        QCOMPARE(remarksOf(*result).front(),
            QStringLiteral("The table states no unit for its values; they are taken to be in um, "
                           "as its positions are, and converted to mm. The largest correction is "
                           "0.123456 mm."));
        QVERIFY(isWithinOneUlp(result->table.values[1], 1.25e-3));
        QCOMPARE(QString::fromStdString(result->table.unit), QStringLiteral("mm"));
        const auto other = inDriveUnits(tableIn("", "deg"), {"Millimeter", {"Degree"}});
        VERIFY_RESULT(other);
        QVERIFY(other->table.values == tableIn("", "").values);
        QCOMPARE(QString::fromStdString(other->table.unit), QStringLiteral("mm"));
    }

    void overThePositionOfTheAxisItselfValuesHaveItsUnit()
    {
        CompensationTable plane = tableIn("", "um");
        plane.grid.axes.push_back({"Y", "mm", 0.0, 1.0, 1});
        const TableUnits drive{"Millimeter", {"Millimeter", "Millimeter"}};
        const auto first = inUnitsOfAxis(plane, drive, 0);
        VERIFY_RESULT(first);
        QVERIFY(isWithinOneUlp(first->table.values[1], 1.25e-3));
        QVERIFY(first->table.target.empty());
        const auto second = inUnitsOfAxis(plane, drive, 1);
        VERIFY_RESULT(second);
        QCOMPARE(second->table.values[1], plane.values[1]);
        VERIFY_ERROR(inUnitsOfAxis(plane, drive, std::nullopt), ErrorCode::UnitMissing);
        plane.target = "other";
        VERIFY_ERROR(inUnitsOfAxis(plane, drive, 0), ErrorCode::UnitMissing);
    }

    /// Which of both is not guessed: the values would be a thousand times too large or too small.
    void valuesOfAnotherAxisNeedAUnitWherePositionsHaveSeveral()
    {
        CompensationTable plane = tableIn("", "um");
        plane.grid.axes.push_back({"Y", "mm", 0.0, 1.0, 1});
        plane.target = "other";
        const TableUnits drive{"Millimeter", {"Millimeter", "Millimeter"}};
        const auto refused = inDriveUnits(plane, drive);
        VERIFY_ERROR(refused, ErrorCode::UnitMissing);
        QCOMPARE(QString::fromStdString(sentence(refused.error())),
            QStringLiteral("the table states no unit for its values, and its positions are in um, "
                           "mm; state the unit of the values, in the file or with --value-unit"));
        VERIFY_RESULT(inDriveUnits(plane, drive, UnstatedUnit::OfDrive));
        plane.unit = "um";
        VERIFY_RESULT(inDriveUnits(plane, drive));
        plane.unit.clear();
        plane.target = sourceTarget(1);
        const auto own = inDriveUnits(plane, drive);
        VERIFY_RESULT(own);
        QVERIFY(own->table.values == plane.values);

        // The same unit in another spelling; one that the values cannot be in.
        plane.target = "other";
        plane.grid.axes[1].unit = "\u00b5m";
        VERIFY_RESULT(inDriveUnits(plane, drive));
        plane.grid.axes[0].unit = "degC";
        const auto only = inDriveUnits(plane, {"Millimeter", {"", "Millimeter"}});
        VERIFY_RESULT(only);
        QVERIFY(isWithinOneUlp(only->table.values[1], 1.25e-3));
    }

    void whatIsStatedCountsMoreThanTheFile()
    {
        const CompensationTable file = tableIn("um", "um");
        CompensationTable stated = file;
        takeStatedUnits(stated, {"drive", ""});
        const TableUnits drive{"Millimeter", {"Millimeter"}};
        const auto asTheyStand = inDriveUnits(stated, drive, unstatedUnit("drive"));
        VERIFY_RESULT(asTheyStand);
        QVERIFY(asTheyStand->table.values == file.values);
        QCOMPARE(QString::fromStdString(asTheyStand->table.unit), QStringLiteral("mm"));
        QCOMPARE(asTheyStand->table.grid.axes[0].start, -0.0125);
        takeStatedUnits(stated, {"nm", "drive"});
        const auto nanometres = inDriveUnits(stated, drive, unstatedUnit("nm"));
        VERIFY_RESULT(nanometres);
        QVERIFY(isWithinOneUlp(nanometres->table.values[1], 1.25e-6));
        QCOMPARE(nanometres->table.grid.axes[0].start, -12.5);
    }

    /// Only a person says so: of a file it is the name of a unit that nobody knows.
    void aFileCannotSayThatItIsInTheUnitOfTheDrive()
    {
        VERIFY_ERROR(inDriveUnits(tableIn("drive", "mm"), {"Millimeter", {"Millimeter"}}),
            ErrorCode::UnitMismatch);
    }

    void anAssumptionIsSaidWithTheLargestCorrection()
    {
        const auto result = inDriveUnits(tableIn("", ""), {"Millimeter", {"Millimeter"}});
        VERIFY_RESULT(result);
        QCOMPARE(remarksOf(*result),
            QStringList(QStringLiteral("The table states no unit for its values; they are taken to "
                                       "be in mm. The largest correction is 123.456 mm.")));
        QVERIFY(result->table.values == tableIn("", "").values);
    }

    /// "X,E [um]" on an axis in metres: 0 to 1000 may have been meant in mm.
    void positionsWithoutAUnitInATableThatStatesSomeAreSaid()
    {
        const auto result = inDriveUnits(tableIn("um", ""), {"Meter", {"Meter"}});
        VERIFY_RESULT(result);
        QCOMPARE(remarksOf(*result).value(1),
            QStringLiteral("The table states no unit for the positions of dimension 1; they are "
                           "taken to be in m: -12.5 m to 12.5 m."));
        QCOMPARE(remarksOf(*result).size(), 2);
        CompensationTable plane = tableIn("", "mm");
        plane.grid.axes.push_back({"Y", "", 0.0, 1.0, 1});
        const auto second =
            inDriveUnits(plane, {"Millimeter", {"Millimeter", "Degree"}}, UnstatedUnit::OfDrive);
        VERIFY_RESULT(second);
        QVERIFY(remarksOf(*second).last().contains(QStringLiteral("dimension 2")));
        QVERIFY(remarksOf(*second).last().contains(QStringLiteral("in deg")));
        // Of a source that has none there is nothing to assume.
        for (const char* none : {"", "None"})
            QCOMPARE(inDriveUnits(tableIn("um", ""), {"Millimeter", {none}})->remarks.size(),
                std::size_t{1});
    }

    void aUnitThatNobodyStatesIsSaid()
    {
        const auto nobody = inDriveUnits(tableIn("", ""), {"None", {}});
        VERIFY_RESULT(nobody);
        QCOMPARE(remarksOf(*nobody),
            QStringList(QStringLiteral("Neither the table nor the drive states a unit for the "
                                       "values. The largest correction is 123.456.")));
        const auto silentDrive = inDriveUnits(tableIn("um", ""), {"", {}});
        VERIFY_RESULT(silentDrive);
        QCOMPARE(remarksOf(*silentDrive),
            QStringList(QStringLiteral("The drive states no unit for the axis; the values are "
                                       "written in um. The largest correction is 123.456 um.")));
    }

    void aUnitThatIsAnotherOneNowIsFound()
    {
        const TableUnits before{"Millimeter", {"mm", "Degree"}};
        QVERIFY(!changedUnit(before, {"mm", {"Millimeter", "deg"}}));
        QVERIFY(changedUnit(before, {"Meter", {"m", "deg"}}) == (UnitChange{{}, "mm", "m"}));
        QVERIFY(changedUnit(before, {"mm", {"mm", "Radian"}}) == (UnitChange{1, "deg", "rad"}));
        // What the drive does not say any more may be anything.
        QVERIFY(changedUnit(before, {"None", {"mm", "deg"}}) == (UnitChange{{}, "mm", "None"}));
        QVERIFY(changedUnit(before, {"mm", {"mm"}}) == (UnitChange{1, "deg", ""}));
        QCOMPARE(unitNow({1, "deg", ""}).english(), std::string("an unknown unit"));
        QVERIFY(changedUnit({"None", {}}, {"mm", {}}) == (UnitChange{{}, "None", "mm"}));
        // What was not known before tells nothing.
        QVERIFY(!changedUnit({"", {""}}, before));
        QVERIFY(!changedUnit({}, before));
    }

    void theSameUnitNeedsNoWord()
    {
        const auto result = inDriveUnits(tableIn("MM", "mm"), {"Millimeter", {"Millimeter"}});
        VERIFY_RESULT(result);
        QVERIFY(result->remarks.empty());
        QVERIFY(result->table.values == tableIn("", "").values);
    }
};

AXISCOMP_TEST(TestTableUnits)

} // namespace tst_tableunits

#include "tst_tableunits.moc"
