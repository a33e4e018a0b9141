// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/backup.h"
#include "tests/ui/support/page_fixture.h"
#include "tests/ui/support/window_test.h"

#include <QAction>
#include <QCheckBox>
#include <QPushButton>
#include <QTableWidget>

namespace tst_restoredrive {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageFixture;

namespace {

const std::string activationY = "Axes[1]/Commands/Compensations/Axis/Activation";

/// A window on a drive whose axis X has a table, and a backup of that.
struct Stage : PageFixture {
    [[nodiscard]] bool backUp()
    {
        picked = path(QStringLiteral("drive.json"));
        user.the<QAction>("backUpDriveAction").trigger();
        return saysOutcome(QStringLiteral("Wrote drive.json: axes: 2, tables: 1."));
    }
    /// X gets the other table of the file.
    [[nodiscard]] bool change()
    {
        return user.choose("tableField", QStringLiteral("second")) && write()
            && saysOutcome(QStringLiteral("the drive holds the new state"));
    }
    [[nodiscard]] bool beginRestoration()
    {
        picked = path(QStringLiteral("drive.json"));
        user.the<QAction>("restoreDriveAction").trigger();
        return test::PageUser::waitFor([this] { return user.sees("restoreDriveDialog"); });
    }
    [[nodiscard]] QString reason() { return user.the<QLabel>("multiAxisReason").text(); }
};

} // namespace

class TestRestoreDrive : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void aWholeDriveIsBackedUpAndBroughtBack()
    {
        Stage stage;
        QVERIFY(stage.openWritten());
        const auto old = stage.state();
        QVERIFY(stage.backUp());
        QFile file(stage.path(QStringLiteral("drive.json")));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const auto backup = readBackup(file.readAll().toStdString(), "drive.json");
        VERIFY_RESULT(backup);
        QCOMPARE(backup->axes.size(), std::size_t{2});
        QVERIFY(stage.change());
        QVERIFY(stage.state().table != old.table);

        QVERIFY(stage.beginRestoration());
        QTRY_VERIFY(stage.user.the("writeSeveralButton").isEnabled());
        const auto& rows = stage.user.the<QTableWidget>("multiAxisPlanRows");
        QCOMPARE(rows.rowCount(), 2);
        QVERIFY(stage.state().table != old.table); // only planned
        QVERIFY(stage.user.the<QLabel>("driveBackupContent")
                    .text()
                    .startsWith(QStringLiteral("Backup of Stage-7, serial number 1559; axes: 2")));
        QVERIFY(stage.user.click("writeSeveralButton"));
        QTRY_VERIFY_WITH_TIMEOUT(
            stage.reason().startsWith(QStringLiteral("Written and verified: X. This is ")),
            test::patienceMs); // and not Y, which had what the backup says: no table
        QVERIFY(stage.state().table == old.table);
        QVERIFY(!stage.controller().setup().isDirty());
    }

    void oneAxisThatCannotBeWrittenPreventsAll()
    {
        Stage stage;
        QVERIFY(stage.openWritten());
        QVERIFY(stage.backUp());
        QVERIFY(stage.change());
        const auto before = stage.state();
        QVERIFY(stage.beginRestoration());
        QTRY_VERIFY(stage.user.the("writeSeveralButton").isEnabled());
        stage.user.press(Qt::Key_Escape);
        QTRY_VERIFY(!stage.user.sees("restoreDriveDialog"));
        // Y gets a table of its own and is switched on.
        QFile file(stage.path(QStringLiteral("drive.json")));
        QVERIFY(file.open(QIODevice::ReadOnly));
        auto backup = readBackup(file.readAll().toStdString(), "drive.json");
        VERIFY_RESULT(backup);
        file.close();
        QVERIFY(stage.user.choose("axisField", QStringLiteral("Y")));
        QTRY_VERIFY(stage.controller().status() && stage.controller().status()->axis.index == 1);
        QVERIFY(stage.choose2D() && stage.write());
        VERIFY_RESULT(
            stage.served.drive.writeRegisters({{activationY, std::string("AddToEncoders")}}));
        QVERIFY(stage.beginRestoration());
        QTRY_VERIFY_WITH_TIMEOUT(
            stage.reason().startsWith(QStringLiteral("Y: ")), test::patienceMs);
        QVERIFY(!stage.user.the("writeSeveralButton").isEnabled());
        QVERIFY(stage.state().table == before.table);
        QVERIFY(stage.state().registers == before.registers);
    }

    void theBackupOfAnotherDriveHasToBeConfirmed()
    {
        Stage stage;
        QVERIFY(stage.openWritten());
        QVERIFY(stage.backUp());
        QVERIFY(stage.change());
        QFile file(stage.path(QStringLiteral("drive.json")));
        QVERIFY(file.open(QIODevice::ReadOnly));
        auto backup = readBackup(file.readAll().toStdString(), "drive.json");
        VERIFY_RESULT(backup);
        file.close();
        for (AxisBackup& axis : backup->axes)
            axis.drive.serialNumber = 7;
        QVERIFY(!stage
                     .file(QStringLiteral("drive.json"),
                         QByteArray::fromStdString(writeBackup(*backup)))
                     .isEmpty());
        QVERIFY(stage.beginRestoration());
        QTRY_COMPARE(
            stage.reason(), QStringLiteral("The backup is of another drive: confirm it first."));
        QVERIFY(!stage.user.the("writeSeveralButton").isEnabled());
        QVERIFY(stage.user.click("acceptOtherDrive"));
        QTRY_VERIFY(stage.user.the("writeSeveralButton").isEnabled());
    }

    void aFileThatIsNoBackupIsSaid()
    {
        Stage stage;
        QVERIFY(stage.openWritten());
        QVERIFY(!stage.file(QStringLiteral("drive.json"), "{}").isEmpty());
        QVERIFY(stage.beginRestoration());
        QTRY_VERIFY2(
            stage.reason().contains(QStringLiteral("drive.json")), qPrintable(stage.reason()));
        QVERIFY(!stage.user.the("writeSeveralButton").isEnabled());
    }
};

AXISCOMP_WINDOW_TEST(TestRestoreDrive)

} // namespace tst_restoredrive

#include "tst_restoredrive.moc"
