// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/drive_store.h"
#include "tests/support/verify.h"
#include "tests/ui/support/controller_fixture.h"
#include "tests/ui/support/page_fixture.h"
#include "tests/ui/support/window_test.h"
#include "ui/controller/axis_overview.h"
#include "ui/overview/overview_model.h"

#include <QAbstractItemModelTester>
#include <QAction>
#include <QClipboard>
#include <QHeaderView>
#include <QSignalSpy>
#include <QTableView>

namespace tst_overview {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::ControllerFixture;
using test::DriveGate;
using test::PageFixture;

namespace {

using Column = OverviewModel::Column;

QString cell(const QAbstractItemModel& model, int row, Column column)
{
    return model.index(row, column).data().toString();
}

/// Two drives, "Test-1" with the axes X and Y and "Table-2" with the axis C.
void connectTwo(ControllerFixture& bench)
{
    drivecomm::VirtualDriveOptions options;
    options.name = "Table-2";
    options.serialNumber = 4712;
    options.axes = {{.name = "C"}};
    bench.addDrive("http://c", options);
    QVERIFY(bench.connect());
    bench->setEndpoints({QStringLiteral("http://x"), QStringLiteral("http://c")});
    QTRY_COMPARE(bench->axes().size(), std::size_t(3));
}

/// The list has the keyboard.
bool openOverview(PageFixture& bench)
{
    bench.user.the<QAction>("overviewAction").trigger();
    if (!test::PageUser::waitFor([&] { return bench.user.sees("overview"); }))
        return false;
    QWidget& window = bench.user.the("overviewDialog");
    bench.user.the("overview").setFocus();
    return test::showActive(window) && test::PageUser::waitFor([&] {
        return QGuiApplication::focusWindow() == window.windowHandle();
    });
}

} // namespace

/// All axes of all drives: what is said of them, and what a person does with the list.
class TestOverview : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void everyAxisOfEveryDriveIsListed()
    {
        ControllerFixture bench;
        connectTwo(bench);
        OverviewModel model(bench->overview());
        const QAbstractItemModelTester tester(
            &model, QAbstractItemModelTester::FailureReportingMode::Fatal);
        QCOMPARE(model.rowCount(), 3);
        bench->overview().readNow();
        QTRY_COMPARE(cell(model, 2, Column::State), QStringLiteral("OFF"));
        QTRY_COMPARE(cell(model, 1, Column::State), QStringLiteral("OFF"));
        QCOMPARE(cell(model, 0, Column::Drive), QStringLiteral("Test-1"));
        QCOMPARE(cell(model, 1, Column::Axis), QStringLiteral("Y"));
        QCOMPARE(cell(model, 2, Column::Drive), QStringLiteral("Table-2"));
        QCOMPARE(cell(model, 2, Column::Table), QStringLiteral("no table"));
        QCOMPARE(cell(model, 2, Column::Persistence), QString());
        QCOMPARE(cell(model, 2, Column::FlashLeft).toInt(),
            drivecomm::genericProfile().flashWear.operations);
        QCOMPARE(cell(model, 2, Column::LastWrite), QString());
        bench->setEndpoints({QStringLiteral("http://c")});
        QTRY_COMPARE(model.rowCount(), 1);
        QCOMPARE(cell(model, 0, Column::Axis), QStringLiteral("C"));
    }

    /// The values are the same, and with them the CRC.
    void whatIsKnownOfATableEndsWithItsSources()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        QVERIFY(bench.planAndWrite());
        bench->activate();
        QVERIFY(bench.idle());
        QTRY_VERIFY(bench->driveTable());
        const auto& rows = bench->overview().rows();
        for (int i = 0; i < 10; ++i) {
            bench.drive().milliseconds += 3000;
            QVERIFY(bench.readLive());
        }
        bench->deactivate();
        QVERIFY(bench.idle());
        QVERIFY(rows[0].proof.has_value());
        QCOMPARE(rows[0].file, QStringLiteral("2d-1.csv"));

        const DimSource& other = bench->status()->setup.sources[1];
        const std::uint32_t crc = bench->status()->table->crc;
        bench.drive().set(
            "Axes[0]/Parameters/Compensations/Axis/Dim1Source", std::uint32_t{other.address});
        QVERIFY(bench.readLive());
        QCOMPARE(bench->status()->table->crc, crc);
        QVERIFY(!rows[0].proof.has_value());
        QVERIFY(rows[0].file.isEmpty());
    }

    void aDriveThatIsLostSaysSinceWhenAndKeepsWhatWasRead()
    {
        ControllerFixture bench;
        connectTwo(bench);
        OverviewModel model(bench->overview());
        const QAbstractItemModelTester tester(
            &model, QAbstractItemModelTester::FailureReportingMode::Fatal);
        bench->overview().readNow();
        QTRY_COMPARE(cell(model, 2, Column::State), QStringLiteral("OFF"));
        const QDateTime before = QDateTime::currentDateTime();
        bench.drive("http://c").gate.set(DriveGate::Mode::Gone);
        bench->overview().readNow();
        const QString lost = QStringLiteral("NOT CONNECTED · since ");
        QTRY_VERIFY(cell(model, 2, Column::State).startsWith(lost));
        const QString since = cell(model, 2, Column::State).mid(lost.size());
        // The moment of the loss, not that of the newest try.
        QTest::qWait(1100);
        QCOMPARE(cell(model, 2, Column::State).mid(lost.size()), since);
        const QTime moment = QTime::fromString(since, QStringLiteral("HH:mm:ss"));
        QVERIFY2(std::abs(moment.secsTo(before.time())) <= 5, qPrintable(since));
        QCOMPARE(cell(model, 2, Column::Table), QStringLiteral("no table"));
        const QModelIndex table = model.index(2, Column::Table);
        QVERIFY(!table.data(OverviewModel::IsLiveRole).toBool());
        QVERIFY(table.data(Qt::ToolTipRole).toString().startsWith(QStringLiteral("as read at ")));
        QVERIFY(cell(model, 0, Column::State) == QStringLiteral("OFF"));
        bench.drive("http://c").gate.set(DriveGate::Mode::Open);
        QTRY_COMPARE(cell(model, 2, Column::State), QStringLiteral("OFF"));
    }

    void aDriveThatHasNeverAnsweredHasARow()
    {
        ControllerFixture bench;
        bench.drive().gate.set(DriveGate::Mode::Gone);
        bench->setEndpoints({QStringLiteral("http://x")});
        OverviewModel model(bench->overview());
        QCOMPARE(model.rowCount(), 1);
        QTRY_VERIFY(cell(model, 0, Column::State).startsWith(QStringLiteral("NOT CONNECTED")));
        QCOMPARE(cell(model, 0, Column::Drive), QStringLiteral("http://x"));
        QCOMPARE(cell(model, 0, Column::Axis), QString());
        bench.drive().gate.set(DriveGate::Mode::Open);
        QTRY_COMPARE(model.rowCount(), 2);
    }

    void aSilentDriveIsAskedOnceAndTheOthersGoOn()
    {
        ControllerFixture bench;
        connectTwo(bench);
        DriveGate& silent = bench.drive("http://c").gate;
        QTRY_COMPARE(silent.waiting(), 0);
        silent.set(DriveGate::Mode::Silent);
        const int before = silent.exchanges();
        QSignalSpy changes(&bench->overview(), &AxisOverview::rowChanged);
        for (int n = 0; n < 5; ++n) {
            bench->overview().readNow();
            changes.clear();
            QTRY_VERIFY(!changes.isEmpty()); // of the other drive
        }
        QCOMPARE(silent.exchanges(), before + 1);
        silent.set(DriveGate::Mode::Open);
    }

    void anOperationDoesNotWaitForTheOverview()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        DriveGate& gate = bench.drive().gate;
        gate.set(DriveGate::Mode::Silent);
        bench->overview().readNow();
        QTRY_COMPARE(gate.waiting(), 1);
        const int before = gate.exchanges();
        bench->planWrite();
        QTRY_VERIFY(gate.exchanges() > before); // long before the deadline of 20 s
        QCOMPARE(gate.timeouts(), 0);
        gate.set(DriveGate::Mode::Open);
        QVERIFY(bench.idle());
        QVERIFY(bench->plan().has_value());
    }

    void aWrittenAndActiveTableIsNamedProvedAndDated()
    {
        PageFixture bench;
        QVERIFY(bench.openWritten());
        QVERIFY(bench.user.click("activateButton"));
        QVERIFY(bench.idle());
        QVERIFY(openOverview(bench));
        const QAbstractItemModel& model = *bench.user.the<QTableView>("overview").model();
        QTRY_COMPARE(cell(model, 0, Column::State), QStringLiteral("ACTIVE"));
        QTRY_VERIFY2(
            cell(model, 0, Column::Table).startsWith(QStringLiteral("super-1.csv: first, CRC ")),
            qPrintable(cell(model, 0, Column::Table)));
        const QString crc = QStringLiteral("%1").arg(
            bench.controller().setup().baseline().tableCrc, 8, 16, QLatin1Char('0'));
        QVERIFY(cell(model, 0, Column::Table).endsWith(crc.toUpper()));
        QCOMPARE(cell(model, 0, Column::Persistence), QStringLiteral("volatile"));
        QTRY_VERIFY(cell(model, 0, Column::LastProof).contains(QStringLiteral(" % · ")));
        QTRY_VERIFY(!cell(model, 0, Column::LastWrite).isEmpty());
        QCOMPARE(cell(model, 0, Column::Measured), QString());
        DriveStore store(std::filesystem::path(bench.folder.path().toStdString()) / "store");
        VERIFY_RESULT(store.recordMeasured(bench.controller().status()->drive.serialNumber, 0,
            {bench.controller().setup().baseline().tableCrc, {}, "2026-11-20", false,
                {{"A", 0.0143, {}, 0.0032}}}));
        QTRY_COMPARE(
            cell(model, 0, Column::Measured), QStringLiteral("A 3.200 µm, 14.300 µm before"));
        QTRY_COMPARE(cell(model, 1, Column::State), QStringLiteral("OFF"));
        QCOMPARE(cell(model, 1, Column::LastProof), QString());
        QCOMPARE(cell(model, 1, Column::Measured), QString());
        QCOMPARE(cell(model, 1, Column::LastWrite), QString());
    }

    void enterGoesToTheAxisAndAsksWhenSomethingIsUnwritten()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        QVERIFY(openOverview(bench));
        auto* table = &user.the<QTableView>("overview");
        QCOMPARE(table->currentIndex().row(), 0); // the axis of the page
        user.press(Qt::Key_Down);
        QCOMPARE(table->currentIndex().row(), 1);
        user.press(Qt::Key_Return);
        QTRY_COMPARE(bench.controller().currentAxis(), 1);
        QTRY_VERIFY(!user.find("overviewDialog"));

        QVERIFY(user.isThere());
        QTRY_VERIFY(bench.controller().status().has_value());
        QVERIFY(bench.choose2D());
        QVERIFY(openOverview(bench));
        table = &user.the<QTableView>("overview");
        const QPoint first = table->visualRect(table->model()->index(0, 0)).center();
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, first);
        QTest::mouseDClick(table->viewport(), Qt::LeftButton, {}, first);
        QTRY_VERIFY(user.sees("loseChangesButton"));
        QCOMPARE(bench.controller().currentAxis(), 1);
        QVERIFY(user.isThere());
        QVERIFY(user.click("loseChangesButton"));
        QTRY_COMPARE(bench.controller().currentAxis(), 0);
    }

    void anAxisOfALostDriveCannotBeGoneTo()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        QVERIFY(openOverview(bench));
        QTRY_VERIFY(bench.user.the("goToAxis").isEnabled());
        bench.served.stop();
        QTRY_VERIFY(!bench.user.the("goToAxis").isEnabled());
        QVERIFY(bench.user.sees("overviewNote"));
        QCOMPARE(bench.user.the<QLabel>("overviewNote").text(),
            bench.controller().drives().front().problem);
    }

    void aColumnPutsTheRowsInOrderAndTheyAreCopiedSo()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        QVERIFY(openOverview(bench));
        auto& table = bench.user.the<QTableView>("overview");
        const QAbstractItemModel& model = *table.model();
        QTRY_COMPARE(cell(model, 1, Column::State), QStringLiteral("OFF"));
        QCOMPARE(cell(model, 0, Column::Axis), QStringLiteral("X"));
        table.sortByColumn(Column::Axis, Qt::DescendingOrder);
        QCOMPARE(cell(model, 0, Column::Axis), QStringLiteral("Y"));
        table.clearSelection();
        QVERIFY(bench.user.click("copyOverview"));
        const QStringList lines = QGuiApplication::clipboard()->text().split(u'\n');
        QCOMPARE(lines.size(), 4); // the last one is empty
        QCOMPARE(lines[0].split(u'\t'),
            (QStringList{QStringLiteral("Drive"), QStringLiteral("Axis"), QStringLiteral("State"),
                QStringLiteral("Table"), QStringLiteral("Persistency"),
                QStringLiteral("Flash left"), QStringLiteral("Measured"),
                QStringLiteral("Last proof"), QStringLiteral("Last write")}));
        QVERIFY(lines[1].startsWith(QStringLiteral("Stage-7\tY\tOFF\tno table\t")));
        QVERIFY(lines[2].startsWith(QStringLiteral("Stage-7\tX\tOFF\tno table\t")));
        table.selectRow(1);
        table.setFocus();
        bench.user.press(Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QGuiApplication::clipboard()->text().count(u'\n'), 2);
        QVERIFY(QGuiApplication::clipboard()->text().contains(QStringLiteral("\nStage-7\tX\t")));
    }
};

AXISCOMP_WINDOW_TEST(TestOverview)

} // namespace tst_overview

#include "tst_overview.moc"
