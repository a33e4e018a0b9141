// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/tam_table.h"
#include "tests/support/verify.h"
#include "tests/ui/support/controller_fixture.h"
#include "tests/ui/support/page_fixture.h"
#include "tests/ui/support/window_test.h"
#include "ui/controller/axis_overview.h"
#include "ui/dialogs/multi_axis_dialog.h"

#include <QComboBox>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>

#include <algorithm>

namespace tst_multiaxis {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::CompensatorFixture;
using test::ControllerFixture;
using test::DriveGate;
using test::GatedDrive;
using test::LinkFault;

namespace {

constexpr int columns = 5;
constexpr int rows = 4;
constexpr float largestOfX = 0.003F;
constexpr float largestOfY = -0.007F;

/// Two columns of errors over X and Y, each with one value that the other does not have.
QByteArray errorsOfXAndY()
{
    QByteArray text = "X [mm],Y [mm],X error [mm],Y error [mm]\n";
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            const bool isPeak = x == 2 && y == 1;
            text += QByteArray::number(10 * x) + ',' + QByteArray::number(10 * y) + ','
                + (isPeak ? "0.003" : "0.001") + ',' + (isPeak ? "-0.007" : "0.002") + '\n';
        }
    }
    return text;
}

/// The dialog on a controller that has such a file, 2D and both sources in its page.
class Stage {
public:
    [[nodiscard]] bool open(bool withSources = true)
    {
        if (!bench.connect())
            return false;
        if (withSources)
            bench.chooseMasterSources();
        else
            bench->setup().setDimensionality(2);
        bench->openData(bench.file(QStringLiteral("plane.csv"), errorsOfXAndY()));
        const bool isReady = bench.fileRead() && QTest::qWaitFor([this] {
            return bench->action(Action::WriteSeveral).isEnabled && !bench->isSourceBeingChecked(1)
                && !bench->isSourceBeingChecked(2);
        });
        if (!isReady)
            return false;
        dialog = new MultiAxisDialog(bench.controller());
        dialog->QDialog::show();
        return true;
    }
    ~Stage() { delete dialog; }

    template <typename T> T& the(const char* name)
    {
        auto* found = dialog->findChild<T*>(QLatin1StringView(name));
        if (!found)
            qFatal("there is no %s", name);
        return *found;
    }
    QPushButton& write() { return the<QPushButton>("writeSeveralButton"); }
    QString reason() { return the<QLabel>("multiAxisReason").text(); }
    void choose(int column, const QString& axis)
    {
        auto& combo = the<QComboBox>(column == 1 ? "axisOfColumn1" : "axisOfColumn2");
        combo.setCurrentIndex(combo.findText(axis));
    }
    [[nodiscard]] bool mayWrite()
    {
        return QTest::qWaitFor([this] { return write().isEnabled(); }, test::patienceMs);
    }
    [[nodiscard]] bool ended()
    {
        return QTest::qWaitFor([this] { return !write().isVisible(); }, test::patienceMs)
            && bench.idle();
    }
    /// Something happens at the beginning of an upload, on the session's thread.
    void atUpload(int number, const std::function<void(test::FaultyLink&)>& act)
    {
        test::FaultyLink* link = bench.drive().faults;
        link->beginning = [link, number, act, count = 0](std::string_view what) mutable {
            if (what == "upload" && ++count == number)
                act(*link);
        };
    }
    CompensatorFixture::State state(int axis)
    {
        return CompensatorFixture::stateOf(bench.drive().drive, axis);
    }
    /// Whether the table of an axis on the drive has a value.
    [[nodiscard]] bool holds(int axis, float value)
    {
        const auto file = decodeTamTable(state(axis).table, drivecomm::genericProfile().layout);
        return file && std::ranges::count(file->table.values, value) == 1;
    }

    ControllerFixture bench;
    QPointer<MultiAxisDialog> dialog;
};

} // namespace

class TestMultiAxis : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void theActionSaysWhatIsMissing();
    void theMenuOpensTheDialog();
    void whatIsProposedIsPlannedAndNothingIsChanged();
    void noAxisAndTheSameAxisTwiceCannotBeWritten();
    void eachAxisGetsItsOwnColumn();
    void theOverviewNamesTheFileAndColumnOfEachAxis();
    void eachAxisCanBeLookedUpByItsOwnPosition();
    void theRefusalOfOneAxisNamesItAndPreventsAll();
    void whatChangedSinceThePlanIsNotWrittenToAnyAxis();
    void aFailureInTheSecondWriteSaysWhichAxisHoldsWhat();
    void stoppedWritesSayWhichAxisHoldsWhat();
    void cancelledBeforeTheWriteNothingIsChanged();
};

void TestMultiAxis::theActionSaysWhatIsMissing()
{
    ControllerFixture bench;
    drivecomm::VirtualDriveOptions one = ControllerFixture::xyDrive();
    one.axes.resize(1);
    QVERIFY(bench.connect());
    QVERIFY(!bench->action(Action::WriteSeveral).isEnabled);
    QCOMPARE(bench->action(Action::WriteSeveral).reason,
        QStringLiteral("Open a file with several columns of values first."));
    bench->setup().setDimensionality(2);
    bench->openData(bench.file(QStringLiteral("plane.csv"), errorsOfXAndY()));
    QVERIFY(bench.fileRead());
    QVERIFY(bench->action(Action::WriteSeveral).isEnabled);

    ControllerFixture single;
    single.addDrive("http://x", one);
    QVERIFY(single.connect());
    single->setup().setDimensionality(2);
    single->openData(single.file(QStringLiteral("plane.csv"), errorsOfXAndY()));
    QVERIFY(single.fileRead());
    QCOMPARE(single->action(Action::WriteSeveral).reason,
        QStringLiteral("The drive has no second axis with compensation registers."));
}

void TestMultiAxis::theMenuOpensTheDialog()
{
    test::PageFixture bench;
    QVERIFY(bench.open());
    auto& entry = bench.user.the<QAction>("writeSeveralAction");
    QVERIFY(!entry.isEnabled());
    QCOMPARE(entry.toolTip(), bench.controller().action(Action::WriteSeveral).reason);
    QVERIFY(bench.choose2D());
    QVERIFY(entry.isEnabled());
    entry.trigger();
    QTRY_VERIFY(bench.user.sees("multiAxisDialog"));
    QCOMPARE(bench.user.the<QLabel>("multiAxisReason").text(),
        QStringLiteral("Select at least one axis."));
}

void TestMultiAxis::whatIsProposedIsPlannedAndNothingIsChanged()
{
    Stage stage;
    QVERIFY(stage.open());
    const auto before = stage.state(0);
    QVERIFY(stage.mayWrite());
    auto& plan = stage.the<QTableWidget>("multiAxisPlanRows");
    QCOMPARE(plan.rowCount(), 2);
    QCOMPARE(plan.item(0, 0)->text(), QStringLiteral("X"));
    QCOMPARE(plan.item(1, 0)->text(), QStringLiteral("Y"));
    QCOMPARE(plan.item(1, 1)->text(), QStringLiteral("no table"));
    QVERIFY2(plan.item(1, 2)->text().startsWith(QStringLiteral("Y error")),
        qPrintable(plan.item(1, 2)->text()));
    QVERIFY2(plan.item(1, 2)->text().contains(QStringLiteral("MasterPosition")),
        qPrintable(plan.item(1, 2)->text()));
    QCOMPARE(plan.item(1, 3)->text(), QStringLiteral("Small2 (empty)"));
    QCOMPARE(stage.reason(), QStringLiteral("Uses no flash operation."));
    QTRY_VERIFY(stage.the<QTableWidget>("columnAxes").item(0, 1)->text()
        == QStringLiteral("+0.001 … +0.003 mm"));
    QVERIFY(stage.state(0) == before);
}

void TestMultiAxis::noAxisAndTheSameAxisTwiceCannotBeWritten()
{
    Stage stage;
    QVERIFY(stage.open());
    QVERIFY(stage.mayWrite());
    stage.choose(2, QStringLiteral("X"));
    QVERIFY(!stage.write().isEnabled());
    QCOMPARE(stage.reason(), QStringLiteral("X is selected twice; an axis has only one table."));
    QCOMPARE(stage.write().toolTip(), stage.reason());
    QCOMPARE(stage.the<QTableWidget>("multiAxisPlanRows").rowCount(), 0);
    stage.choose(1, QStringLiteral("none"));
    // The errors of Y are not written to X.
    QTRY_VERIFY2(stage.reason().contains(QLatin1String("Y error")), qPrintable(stage.reason()));
    QVERIFY(!stage.write().isEnabled());
    stage.choose(2, QStringLiteral("Y"));
    QVERIFY(stage.mayWrite());
    stage.choose(2, QStringLiteral("none"));
    QVERIFY(!stage.write().isEnabled());
    QCOMPARE(stage.reason(), QStringLiteral("Select at least one axis."));
}

void TestMultiAxis::eachAxisGetsItsOwnColumn()
{
    Stage stage;
    QVERIFY(stage.open());
    stage.bench->setup().setPersistency(Persistency::Volatile);
    QVERIFY(stage.mayWrite());
    std::vector<std::pair<int, std::uint32_t>> said;
    QObject context;
    QObject::connect(&stage.bench.controller(), &WizardController::tableWritten, &context,
        [&](const AxisStatus& now) { said.emplace_back(now.axis.index, now.setup.tableCrc); });
    stage.write().click();
    QVERIFY(stage.ended());
    QVERIFY2(!stage.bench->isOutcomeAnError(), qPrintable(stage.reason()));
    // For each axis, also the one that the page does not show.
    QCOMPARE(said.size(), std::size_t{2});
    QCOMPARE(said[0], std::pair(0, stage.bench->setup().baseline().tableCrc));
    QCOMPARE(said[1].first, 1);
    QVERIFY(said[1].second != said[0].second);
    QVERIFY2(stage.reason().contains(QStringLiteral("Written and verified: X, Y.")),
        qPrintable(stage.reason()));
    QVERIFY(stage.state(0).table != stage.state(1).table);
    QVERIFY(stage.holds(0, largestOfX));
    QVERIFY(stage.holds(1, largestOfY));
    QCOMPARE(stage.bench.store().backups(4711, 0).size(), std::size_t(1));
    QCOMPARE(stage.bench.store().backups(4711, 1).size(), std::size_t(1));
    // The page has read back what its axis has now.
    QVERIFY(!stage.bench->setup().isDirty());
    QVERIFY(stage.bench->setup().baseline().tableCrc != 0);
}

void TestMultiAxis::theOverviewNamesTheFileAndColumnOfEachAxis()
{
    Stage stage;
    QVERIFY(stage.open());
    QVERIFY(stage.mayWrite());
    stage.write().click();
    QVERIFY(stage.ended());
    const auto& rows = stage.bench->overview().rows();
    const auto areNamed = [&] {
        return rows[0].file == QStringLiteral("plane.csv")
            && rows[0].column == QStringLiteral("X error")
            && rows[1].file == QStringLiteral("plane.csv")
            && rows[1].column == QStringLiteral("Y error");
    };
    QVERIFY(areNamed());
    // Until the axis has another table.
    QSignalSpy read(&stage.bench->overview(), &AxisOverview::rowChanged);
    stage.bench->overview().readNow();
    QTRY_VERIFY(read.size() >= 2);
    QVERIFY(areNamed());
    const DimSource& other = stage.bench->status()->setup.sources[1];
    stage.bench.drive().set(
        "Axes[1]/Parameters/Compensations/Axis/Dim1Source", std::uint32_t{other.address});
    stage.bench->overview().readNow();
    QTRY_VERIFY(rows[1].file.isEmpty());
    QCOMPARE(rows[0].file, QStringLiteral("plane.csv"));
}

void TestMultiAxis::eachAxisCanBeLookedUpByItsOwnPosition()
{
    ControllerFixture bench;
    QVERIFY(bench.connect());
    bench->openData(bench.file(QStringLiteral("line.csv"),
        "Position [mm],X error [mm],Y error [mm]\n0,0.001,0.002\n100,0.003,-0.007\n"));
    QVERIFY(bench.fileRead());
    MultiAxisDialog dialog(bench.controller());
    dialog.QDialog::show();
    auto* sources = dialog.findChild<QComboBox*>(QStringLiteral("multiAxisSources"));
    const int own = sources->findText(QStringLiteral("Each axis its own position"));
    QVERIFY(own >= 0);
    sources->setCurrentIndex(own);
    Q_EMIT sources->activated(own);
    QTRY_VERIFY_WITH_TIMEOUT(bench->multiAxisPlans() && *bench->multiAxisPlans(), test::patienceMs);
    const std::vector<WritePlan>& plans = **bench->multiAxisPlans();
    QCOMPARE(plans.size(), std::size_t{2});
    QCOMPARE(plans[0].after.sources[0].path, test::masterX);
    QCOMPARE(plans[1].after.sources[0].path, test::masterY);
}

void TestMultiAxis::theRefusalOfOneAxisNamesItAndPreventsAll()
{
    Stage stage;
    QVERIFY(stage.open());
    QVERIFY(stage.mayWrite());
    stage.write().click();
    QVERIFY(stage.ended());
    delete stage.dialog;
    // Now X has sources of its own; Y's are taken away.
    const std::string base = "Axes[1]/Parameters/Compensations/Axis/";
    stage.bench.drive().set(base + "Table", std::string("Disabled"));
    for (const char* source : {"Dim1Source", "Dim2Source"})
        stage.bench.drive().set(base + source, std::uint32_t{0});
    stage.bench->openData(
        stage.bench.file(QStringLiteral("new.csv"), errorsOfXAndY().replace("0.003", "0.004")));
    QVERIFY(stage.bench.fileRead());
    const auto before = stage.state(0);
    stage.dialog = new MultiAxisDialog(stage.bench.controller());
    stage.dialog->QDialog::show();
    auto& sources = stage.the<QComboBox>("multiAxisSources");
    sources.setCurrentIndex(0);
    Q_EMIT sources.activated(0);
    QTRY_VERIFY2(stage.reason().startsWith(QStringLiteral("Y: ")), qPrintable(stage.reason()));
    QVERIFY(!stage.write().isEnabled());
    QCOMPARE(stage.write().toolTip(), stage.reason());
    QVERIFY(stage.state(0) == before);
}

void TestMultiAxis::whatChangedSinceThePlanIsNotWrittenToAnyAxis()
{
    Stage stage;
    QVERIFY(stage.open());
    QVERIFY(stage.mayWrite());
    stage.bench.drive().set("Axes[1]/Parameters/Compensations/Axis/Dim1Source",
        stage.bench->sourcesForSeveral().front().address);
    const auto before = stage.state(0);
    stage.write().click();
    QVERIFY(stage.ended());
    QVERIFY(stage.bench->isOutcomeAnError());
    QVERIFY2(stage.reason().startsWith(QStringLiteral("Y: ")), qPrintable(stage.reason()));
    QVERIFY2(
        stage.reason().endsWith(QStringLiteral("No axis was changed. Old state, complete: X, Y.")),
        qPrintable(stage.reason()));
    QVERIFY(stage.state(0) == before);
    QVERIFY(stage.bench->setup().isDirty());
}

void TestMultiAxis::aFailureInTheSecondWriteSaysWhichAxisHoldsWhat()
{
    Stage stage;
    QVERIFY(stage.open());
    QVERIFY(stage.mayWrite());
    const auto before = stage.state(1);
    stage.atUpload(2, [](test::FaultyLink& link) { link.failAt(0, LinkFault::Refused); });
    stage.write().click();
    QVERIFY(stage.ended());
    QVERIFY(stage.bench->isOutcomeAnError());
    QVERIFY2(stage.reason().startsWith(QStringLiteral("Y: ")), qPrintable(stage.reason()));
    QVERIFY2(stage.reason().endsWith(QStringLiteral("New state: X. Old state, complete: Y.")),
        qPrintable(stage.reason()));
    QVERIFY(stage.holds(0, largestOfX));
    QCOMPARE(stage.state(1).registers, before.registers);
    QVERIFY(!stage.bench->setup().isDirty()); // the page's axis is X
}

void TestMultiAxis::stoppedWritesSayWhichAxisHoldsWhat()
{
    Stage stage;
    QVERIFY(stage.open());
    QVERIFY(stage.mayWrite());
    const auto before = stage.state(1);
    DriveGate& gate = stage.bench.drive().gate;
    stage.atUpload(2, [&gate](test::FaultyLink&) { gate.setAt(1, DriveGate::Mode::Silent); });
    stage.write().click();
    QTRY_COMPARE(gate.waiting(), 1);
    QVERIFY(stage.bench->isWriting());
    QTRY_VERIFY2(stage.reason().contains(QStringLiteral("Y")), qPrintable(stage.reason()));
    QTest::keyClick(stage.dialog, Qt::Key_Escape);
    QVERIFY(stage.dialog && stage.dialog->isVisible());
    gate.set(DriveGate::Mode::Open);
    QVERIFY(stage.ended());
    QCOMPARE(stage.reason(),
        QStringLiteral("The writes were stopped at Y. New state: X. Old state, complete: Y."));
    QVERIFY(stage.holds(0, largestOfX));
    QCOMPARE(stage.state(1).registers, before.registers);
    QTest::keyClick(stage.dialog, Qt::Key_Escape);
    QTRY_VERIFY(!stage.dialog);
}

void TestMultiAxis::cancelledBeforeTheWriteNothingIsChanged()
{
    Stage stage;
    QVERIFY(stage.open());
    const auto before = std::pair(stage.state(0), stage.state(1));
    const auto edited = stage.bench->setup().edited();
    QVERIFY(stage.mayWrite());
    stage.the<QPushButton>("closeSeveralButton").click();
    QTRY_VERIFY(!stage.dialog);
    QVERIFY(std::pair(stage.state(0), stage.state(1)) == before);
    QVERIFY(stage.bench->setup().edited() == edited);
    QVERIFY(!stage.bench->busy().isBusy);
}

AXISCOMP_WINDOW_TEST(TestMultiAxis)

} // namespace tst_multiaxis

#include "tst_multiaxis.moc"
