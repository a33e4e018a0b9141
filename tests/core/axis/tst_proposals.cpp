// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/axis/proposals.h"
#include "drivecomm/profile/profile_loader.h"
#include "tests/support/compensator_fixture.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

namespace tst_proposals {

using namespace axiscomp;
using test::CompensatorFixture;

namespace {

const std::string masterX = "Axes[0]/Signals/PositionController/MasterPosition";
const std::string masterY = "Axes[1]/Signals/PositionController/MasterPosition";
const std::string masterC = "Axes[2]/Signals/PositionController/MasterPosition";
const std::string warmthX = "Axes[0]/Signals/General/MotorTemperature";
const std::string warmthY = "Axes[1]/Signals/General/MotorTemperature";

/// A drive of the axes X and Y in millimetres and C in degrees, whose motors have temperatures.
struct Machine {
    Machine()
    {
        const std::array names{
            std::pair("X", "Millimeter"), std::pair("Y", "Millimeter"), std::pair("C", "Degree")};
        for (const auto& [name, unit] : names) {
            AxisInfo axis;
            axis.index = static_cast<int>(axes.size());
            axis.folder = "Axes[" + std::to_string(axis.index) + "]/";
            axis.name = name;
            axis.unit = unit;
            axes.push_back(axis);
        }
        // The position after the compensation comes first, to be passed over.
        for (const AxisInfo& axis : axes)
            add(axis.folder + "Signals/PositionController/ActualPosition");
        for (const AxisInfo& axis : axes) {
            add(axis.folder + "Signals/PositionController/MasterPosition");
            add(axis.folder + "Signals/PathPlanner/Position");
            add(axis.folder + "Signals/General/MotorTemperature");
        }
    }
    void add(const std::string& path)
    {
        sources.push_back({static_cast<std::uint32_t>(sources.size() + 1), path});
    }
    /// columns: "X [mm], T".
    [[nodiscard]] QStringList proposed(const QString& columns, int axis = 0) const
    {
        const DriveRegisters drive{drivecomm::genericProfile(), sources, axes};
        QStringList paths;
        for (const DimSource& source : proposedSources(drive, axis, gridOf(columns)))
            paths += source.isSet() ? QString::fromStdString(source.path) : QStringLiteral("-");
        return paths;
    }
    /// "refused: " before what is certain.
    [[nodiscard]] std::string doubt(
        const QString& column, const std::string& source, bool isStated = false) const
    {
        const auto text = sourceDoubt(
            drivecomm::genericProfile(), gridOf(column).axes.front(), 2, {1, source}, isStated,
            [this](int axis) { return axes.at(static_cast<std::size_t>(axis)).name; },
            [this](int axis) {
                std::vector<std::string> others;
                for (const AxisInfo& info : axes)
                    if (info.index != axis)
                        others.push_back(info.name);
                return others;
            });
        if (!text)
            return {};
        return text->refusal ? "refused: " + sentence(*text->refusal) : text->text.english();
    }
    static Grid gridOf(const QString& columns)
    {
        Grid grid;
        for (const QString& column : columns.split(QStringLiteral(", "))) {
            GridAxis axis;
            axis.name = column.section(QStringLiteral(" ["), 0, 0).toStdString();
            axis.unit =
                column.section(u'[', 1).chopped(column.contains(u'[') ? 1 : 0).toStdString();
            grid.axes.push_back(axis);
        }
        return grid;
    }

    std::vector<AxisInfo> axes;
    std::vector<DimSource> sources;
};

} // namespace

class TestProposals : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aColumnGetsTheRegisterThatItsNameAndUnitSay_data()
    {
        QTest::addColumn<QString>("columns");
        QTest::addColumn<QStringList>("expected");
        const auto row = [](const char* columns, const QStringList& expected) {
            QTest::newRow(columns) << QString::fromUtf8(columns) << expected;
        };
        const QString x = QString::fromStdString(masterX);
        const QString y = QString::fromStdString(masterY);
        const QString c = QString::fromStdString(masterC);
        const QString t = QString::fromStdString(warmthX);
        const QString none = QStringLiteral("-");
        row("", {x}); // without a name the axis's own, in 1D
        row("Position [mm]", {x});
        row("Position [deg]", {none}); // a length is no angle
        row("y position [um]", {y});
        row("Z [mm]", {none}); // there is no such axis
        row("X [mm], Y [mm], T [\302\260C]", {x, y, t});
        row("Y, X", {y, x});
        row("X [mm], Temp", {x, t});
        row("X [mm], Motor temperature [K]", {x, t});
        row("X [mm], T [mm]", {x, none});
        row("X [deg], C [deg]", {none, c});
        row("a, b", {none, none}); // in 2D nothing says which is which
        row("X, x", {x, none}); // each register once
    }
    void aColumnGetsTheRegisterThatItsNameAndUnitSay()
    {
        QFETCH(QString, columns);
        QFETCH(QStringList, expected);
        QCOMPARE(Machine().proposed(columns), expected);
    }

    void theAxisOfAnAmbiguousNameIsNotProposed()
    {
        Machine machine;
        machine.axes[1].name = "x";
        QCOMPARE(machine.proposed(QStringLiteral("X, C")),
            (QStringList{QStringLiteral("-"), QString::fromStdString(masterC)}));
    }

    void theTemperatureIsThatOfTheAxisItself()
    {
        Machine machine;
        QCOMPARE(
            machine.proposed(QStringLiteral("X, T"), 1).at(1), QString::fromStdString(warmthY));
        std::erase_if(
            machine.sources, [](const DimSource& source) { return source.path == warmthY; });
        QCOMPARE(machine.proposed(QStringLiteral("X, T"), 1).at(1), QStringLiteral("-"));
        std::erase_if(machine.sources, [](const DimSource& source) {
            return source.path.ends_with("MotorTemperature") && source.path != warmthX;
        });
        QCOMPARE(
            machine.proposed(QStringLiteral("X, T"), 1).at(1), QString::fromStdString(warmthX));
    }

    void whatIsCertainlyWrongIsRefusedWithAWayOut()
    {
        const Machine machine;
        const std::string unit =
            " Choose another source or column, or correct the unit in the file";
        QCOMPARE(machine.doubt(QStringLiteral("Z [mm]"), warmthX),
            "refused: Column Z of the file has positions in mm, but its source " + warmthX
                + " is a temperature." + unit);
        QCOMPARE(machine.doubt(QStringLiteral(" [mm]"), warmthX),
            "refused: Column 2 of the file has positions in mm, but its source " + warmthX
                + " is a temperature." + unit);
        QCOMPARE(machine.doubt(QStringLiteral("T [\u00b0C]"), masterX, true),
            "refused: Column T of the file has temperatures, but its source " + masterX
                + " is a position." + unit);
        for (const char* const column : {"Y [mm]", "Y position", "Y2"})
            QCOMPARE(machine.doubt(QString::fromLatin1(column), masterX),
                "refused: Column "
                    + QString::fromLatin1(column).section(u'[', 0, 0).trimmed().toStdString()
                    + " of the file is not named as axis X, whose position its source " + masterX
                    + " is. Choose another source or column, or, if it is right all the same, name "
                      "the column after axis X in the file");
    }

    /// What nobody can tell for sure, and what a person states.
    void whatTheNamesSpeakAgainstIsSaid()
    {
        const Machine machine;
        QCOMPARE(machine.doubt(QStringLiteral("Z"), warmthX),
            "Column Z of the file is named as an axis, but its source " + warmthX
                + " is a temperature.");
        QCOMPARE(machine.doubt(QStringLiteral("Temperature"), masterX),
            "Column Temperature of the file has temperatures, but its source " + masterX
                + " is a position.");
        const auto otherName = [](const std::string& column) {
            return "Column " + column
                + " of the file is not named as axis X, whose position its source " + masterX
                + " is.";
        };
        QCOMPARE(machine.doubt(QStringLiteral("A [mm]"), masterX), otherName("A"));
        QCOMPARE(machine.doubt(QStringLiteral("2 [mm]"), masterX), otherName("2"));
        QCOMPARE(machine.doubt(QStringLiteral("X2 [mm]"), masterX), otherName("X2"));
        QCOMPARE(machine.doubt(QStringLiteral("Y [mm]"), masterX, true), otherName("Y"));
    }

    void whatMayBeRightIsNotDoubted()
    {
        const Machine machine;
        QCOMPARE(machine.doubt(QStringLiteral("X [mm]"), masterX), std::string());
        QCOMPARE(machine.doubt(QStringLiteral("Position [mm]"), masterY), std::string());
        QCOMPARE(machine.doubt(QString(), masterY), std::string());
        QCOMPARE(machine.doubt(QStringLiteral("T [\u00b0C]"), warmthY), std::string());
        QCOMPARE(machine.doubt(QStringLiteral("T"), warmthY), std::string());
        QCOMPARE(machine.doubt(QStringLiteral("Z [mm]"), "Application/Variables/Floats[3]"),
            std::string());
    }

    void aColumnIsNotWrittenForASourceThatCannotBeItsOwn()
    {
        CompensatorFixture fixture;
        WriteRequest request = test::exampleRequest(1);
        const auto planned = [&](const char* first, const char* second,
                                 std::vector<std::string> sources) {
            request.sources = std::move(sources);
            request.table->grid.axes[0].name = first;
            request.table->grid.axes[1].name = second;
            request.table->grid.axes[1].unit = "mm";
            return fixture.compensator.plan(0, request);
        };
        VERIFY_ERROR(planned("X", "Z", {masterX, warmthX}), ErrorCode::SourceMismatch);
        VERIFY_ERROR(planned("Y", "X", {masterX, masterY}), ErrorCode::SourceMismatch);
        const auto right = planned("X", "Y", {masterX, masterY});
        VERIFY_RESULT(right);
        for (const Text& warning : right->warnings)
            QVERIFY2(
                warning.english().find("Column") == std::string::npos, warning.english().c_str());
        const auto doubted = planned("X", "A", {masterX, masterY});
        VERIFY_RESULT(doubted);
        QVERIFY2(doubted->warnings.front().english().starts_with("Column A of the file"),
            doubted->warnings.front().english().c_str());
    }

    void theColumnOfAnotherAxisOfTheDriveIsNotLookedUpByThisOne_data()
    {
        QTest::addColumn<QString>("first");
        QTest::addColumn<QString>("second");
        QTest::addColumn<QString>("column");
        QTest::addColumn<bool>("isRefused");
        const auto row = [](const char* first, const char* second, const char* column,
                             bool isRefused) {
            QTest::addRow("%s of %s and %s", column, first, second)
                << QString::fromLatin1(first) << QString::fromLatin1(second)
                << QString::fromLatin1(column) << isRefused;
        };
        row("X1", "X2", "X2", true);
        row("X1", "X2", "X2 position", true);
        row("X1", "X2", "X1", false);
        row("X1", "X2", "X", false);
        row("X1", "X2", "X3", false);
        row("X1", "Y", "X2", false);
        row("Left", "Right", "right", true);
        row("Left", "Right", "Right position", true);
        row("Left", "Right", "Left", false);
        row("Left", "Right", "Position", false);
        row("1", "2", "2", true);
        row("1", "2", "Position 2", false);
        row("A", "B", "B", false);
        row("A", "B", "Position B", false);
        row("A", "B", "B position", true);
        row("", "Right", "Right", true);
    }
    void theColumnOfAnotherAxisOfTheDriveIsNotLookedUpByThisOne()
    {
        QFETCH(QString, first);
        QFETCH(QString, second);
        QFETCH(QString, column);
        QFETCH(bool, isRefused);
        CompensatorFixture fixture({first.toStdString(), second.toStdString()});
        WriteRequest request = test::exampleRequest(1);
        request.dimensionality = 1;
        request.table = test::exampleTable(1);
        request.table->grid.axes.front().name = column.toStdString();
        request.sources = {masterX};
        if (!isRefused) {
            VERIFY_RESULT(fixture.compensator.plan(0, request));
            return;
        }
        VERIFY_ERROR(fixture.compensator.plan(0, request), ErrorCode::SourceMismatch);
        request.table->target = "#1";
        VERIFY_RESULT(fixture.compensator.plan(0, request));
    }

    /// "#1" says of which source the values are, and that this is its column.
    void aStatementOverrulesTheNameOfAColumn()
    {
        CompensatorFixture fixture;
        WriteRequest request = test::exampleRequest(0);
        request.table->grid.axes = {{"Y", "mm", 0.0, 10.0, 3}};
        request.table->values = {0.0F, 0.001F, 0.0F};
        request.sources = {masterX};
        request.dimensionality = 1;
        VERIFY_ERROR(fixture.compensator.plan(0, request), ErrorCode::SourceMismatch);
        request.table->target = "#1";
        VERIFY_RESULT(fixture.compensator.plan(0, request));
        request.table->isTargetOfDrive = true;
        VERIFY_ERROR(fixture.compensator.plan(0, request), ErrorCode::SourceMismatch);
    }

    void aTableIsProposedForTheAxisThatItsNameSays_data()
    {
        QTest::addColumn<QString>("names");
        QTest::addColumn<QList<int>>("proposed"); // -1: none
        const auto row = [](const char* title, const char* names, const QList<int>& proposed) {
            QTest::newRow(title) << QString::fromLatin1(names) << proposed;
        };
        row("names of axes", "Y,X", {1, 0});
        row("errors of axes", "X error,y ERROR", {0, 1});
        row("exact first", "X error,X", {-1, 0});
        row("once only", "X,X", {0, -1});
        row("other names", "table 1,error", {-1, -1});
        row("of two axes", "Z,Z error", {-1, -1});
    }
    void aTableIsProposedForTheAxisThatItsNameSays()
    {
        QFETCH(QString, names);
        QFETCH(QList<int>, proposed);
        std::vector<CompensationTable> tables;
        for (const QString& name : names.split(u',')) {
            tables.emplace_back();
            tables.back().name = name.toStdString();
        }
        std::vector<AxisInfo> axes;
        for (const char* name : {"X", "Y", "Z", "Z", ""}) {
            AxisInfo axis;
            axis.index = static_cast<int>(axes.size());
            axis.name = name;
            axes.push_back(axis);
        }
        QList<int> found;
        for (const AxisChoice& choice : proposedAxes(tables, axes))
            found += choice.value_or(-1);
        QCOMPARE(found, proposed);
        const auto first = proposedTable(tables, axes, 1);
        QCOMPARE(first ? static_cast<int>(*first) : -1, static_cast<int>(proposed.indexOf(1)));
    }
};

AXISCOMP_TEST(TestProposals)

} // namespace tst_proposals

#include "tst_proposals.moc"
