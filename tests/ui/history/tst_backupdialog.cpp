// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/page_fixture.h"
#include "tests/ui/support/window_test.h"

#include <QAction>
#include <QCheckBox>
#include <QTest>
#include <QTreeWidget>

namespace tst_backupdialog {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageFixture;

namespace {

/// Of the fixture's drive.
constexpr int serialNumber = 1559;

enum Column { Date, Axis, Table, Crc, Before };

std::vector<std::filesystem::path> filesOf(PageFixture& bench, int axis)
{
    DriveStore store(std::filesystem::path(bench.folder.path().toStdString()) / "store");
    return store.backups(serialNumber, axis);
}

bool openList(PageFixture& bench)
{
    bench.user.the<QAction>("backupsAction").trigger();
    return test::PageUser::waitFor([&] {
        return bench.user.sees("backups")
            && bench.user.the<QTreeWidget>("backups").topLevelItemCount() > 0;
    });
}

void replaceIn(const std::filesystem::path& path, const QByteArray& before, const QByteArray& after)
{
    QFile file(QString::fromStdString(path.string()));
    QVERIFY(file.open(QIODevice::ReadWrite));
    const QByteArray text = file.readAll().replace(before, after);
    QVERIFY(file.resize(0) && file.seek(0) && file.write(text) == text.size());
}

} // namespace

/// The list of the drive's backups, and what becomes of the one that is chosen.
class TestBackupDialog : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void anOlderBackupComesBackAfterItsPreview()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.openWritten());
        const auto first = bench.state();
        const std::uint32_t firstCrc = bench.controller().setup().baseline().tableCrc;
        QVERIFY(user.choose("tableField", QStringLiteral("second")));
        QVERIFY(bench.write());
        bench.picked = bench.superData(3);
        QVERIFY(user.click("openButton"));
        QTRY_VERIFY(bench.controller().dataFile().path == bench.picked);
        QVERIFY(bench.write());
        const auto third = bench.state();

        // Before the first write there was no table, before the second the first, ...
        QVERIFY(openList(bench));
        auto& list = user.the<QTreeWidget>("backups");
        QCOMPARE(list.topLevelItemCount(), 3);
        const QString before = QStringLiteral("new table");
        QCOMPARE(list.topLevelItem(0)->text(Before), QStringLiteral("last write"));
        QCOMPARE(list.topLevelItem(1)->text(Before), before);
        QCOMPARE(list.topLevelItem(2)->text(Before), before);
        QCOMPARE(list.topLevelItem(2)->text(Table), QStringLiteral("none"));
        QCOMPARE(list.topLevelItem(1)->text(Crc).toUInt(nullptr, 16), firstCrc);
        QCOMPARE(list.topLevelItem(1)->text(Axis), QStringLiteral("X"));
        QVERIFY(list.topLevelItem(1)->text(Table).contains(QStringLiteral("11 × 7 points")));
        list.setCurrentItem(list.topLevelItem(1));
        QTRY_VERIFY(user.the("backupPicture")
                        .findChild<QLabel*>(QStringLiteral("thumbnailLine"))
                        ->text()
                        .contains(QStringLiteral("µm at Dim 1 ")));
        QVERIFY(user.click("restoreBackupButton"));
        QTRY_VERIFY(!user.find("backupDialog"));
        QVERIFY(user.isThere());
        QTRY_VERIFY(user.sees("confirmWriteButton"));
        QVERIFY(user.the<QLabel>("previewTitle").text().contains(QStringLiteral("restored")));
        QVERIFY(user.the<QLabel>("previewRemarks")
                    .text()
                    .startsWith(QStringLiteral("This is what the axis had before the write of ")));
        QVERIFY(bench.state() == third); // nothing has been written yet
        QVERIFY(user.click("confirmWriteButton"));
        QVERIFY(bench.saysOutcome(QStringLiteral("Restored")));
        // In another slot: the one that it had been in holds the table that was replaced now.
        const auto now = bench.state();
        QVERIFY(now.table == first.table);
        QCOMPARE(now.persistent, first.persistent);
        for (const std::size_t source : {1U, 2U, 3U})
            QCOMPARE(now.registers[source], first.registers[source]);
    }

    void aBackupOfTheOtherAxisGoesToThatAxis()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.openWritten());
        const auto written = bench.state(0);
        QVERIFY(user.choose("axisField", QStringLiteral("Y · ")));
        QTRY_VERIFY(
            bench.controller().currentAxis() == 1 && bench.controller().status().has_value());
        const auto other = bench.state(1);
        QVERIFY(openList(bench)); // the only one is of X, from before it had a table
        QVERIFY(user.click("restoreBackupButton"));
        QTRY_COMPARE(bench.controller().currentAxis(), 0);
        QVERIFY(user.isThere());
        QTRY_VERIFY(user.sees("confirmWriteButton"));
        QVERIFY(user.the<QLabel>("previewTitle").text().contains(QStringLiteral("X · ")));
        QVERIFY(bench.state(0) == written);
        QVERIFY(user.click("confirmWriteButton"));
        QVERIFY(bench.saysOutcome(QStringLiteral("Restored")));
        QVERIFY(!(bench.state(0) == written));
        QCOMPARE(bench.served.text("Axes[0]/Parameters/Compensations/Axis/Table"),
            std::string("Disabled"));
        QVERIFY(bench.state(1) == other);
    }

    void aDamagedBackupIsListedAndCannotBeChosen()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.openWritten());
        replaceIn(filesOf(bench, 0).front(), "\"format\"", "\"farmat\"");
        QVERIFY(openList(bench));
        auto& list = user.the<QTreeWidget>("backups");
        QCOMPARE(list.topLevelItem(0)->text(Before), QStringLiteral("damaged"));
        QVERIFY(!list.topLevelItem(0)->text(Date).endsWith(QStringLiteral(".json")));
        QVERIFY(user.sees("backupWarnings"));
        QVERIFY(!user.the("restoreBackupButton").isEnabled());
        QVERIFY(!user.sees("acceptOtherDrive"));
    }

    void aBackupOfAnotherDriveHasToBeConfirmed()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.openWritten());
        const auto before = bench.state();
        const auto file = filesOf(bench, 0).front();
        const QString moved = bench.path(QStringLiteral("replaced.json"));
        QVERIFY(QFile::copy(QString::fromStdString(file.string()), moved));
        QVERIFY(QFile::setPermissions(moved, QFile::ReadOwner | QFile::WriteOwner));
        replaceIn(moved.toStdString(), "1559", "7007");
        QVERIFY(openList(bench));
        bench.picked = moved;
        QVERIFY(user.click("openBackupButton"));
        QCOMPARE(bench.questions.back().purpose, FileQuestion::Purpose::OpenBackup);
        auto& list = user.the<QTreeWidget>("backups");
        QTRY_COMPARE(list.topLevelItemCount(), 2);
        QVERIFY(list.topLevelItem(0)->text(Axis).contains(QStringLiteral("7007")));
        QVERIFY(!user.the("restoreBackupButton").isEnabled());
        QVERIFY(user.click("acceptOtherDrive"));
        QVERIFY(user.click("restoreBackupButton"));
        QVERIFY(user.isThere());
        QTRY_VERIFY(user.sees("confirmWriteButton"));
        const auto warnings =
            user.the("previewWarnings").findChildren<QLabel*>(QStringLiteral("warningText"));
        QCOMPARE(warnings.size(), 1);
        QVERIFY2(warnings.front()->text().contains(QStringLiteral("7007")),
            qPrintable(warnings.front()->text()));
        // What this axis had before a write is something else.
        QVERIFY(user.the<QLabel>("previewRemarks")
                    .text()
                    .startsWith(QStringLiteral("This is the state in the backup file of ")));
        QVERIFY(bench.state() == before);
        QVERIFY(user.click("confirmWriteButton"));
        QVERIFY(bench.saysOutcome(QStringLiteral("made of the drive with the serial number 7007")));
        QVERIFY(!(bench.state() == before));
    }

    void aTableIsShownInTheUnitThatItWasKeptIn()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.openWritten());
        QVERIFY(user.choose("tableField", QStringLiteral("second")));
        QVERIFY(bench.write());
        const auto file = filesOf(bench, 0).front();
        const QString moved = bench.path(QStringLiteral("turned.json"));
        QVERIFY(QFile::copy(QString::fromStdString(file.string()), moved));
        QVERIFY(QFile::setPermissions(moved, QFile::ReadOwner | QFile::WriteOwner));
        replaceIn(moved.toStdString(), "\"Millimeter\"", "\"Degree\"");
        QVERIFY(openList(bench));
        bench.picked = moved;
        QVERIFY(user.click("openBackupButton"));
        QTRY_COMPARE(user.the<QTreeWidget>("backups").topLevelItemCount(), 3);
        const auto& line =
            *user.the("backupPicture").findChild<QLabel*>(QStringLiteral("thumbnailLine"));
        QTRY_VERIFY2(line.text().contains(QStringLiteral("° at Dim 1 ")), qPrintable(line.text()));
    }

    void aBackupFileOfThisDriveIsNotSaidToBeFromBeforeAWrite()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.openWritten());
        const auto file = filesOf(bench, 0).front();
        const QString kept = bench.path(QStringLiteral("kept.json"));
        QVERIFY(QFile::copy(QString::fromStdString(file.string()), kept));
        QVERIFY(openList(bench));
        bench.picked = kept;
        QVERIFY(user.click("openBackupButton"));
        QTRY_COMPARE(user.the<QTreeWidget>("backups").topLevelItemCount(), 2);
        QVERIFY(user.click("restoreBackupButton"));
        QVERIFY(user.isThere());
        QTRY_VERIFY(user.sees("confirmWriteButton"));
        QVERIFY(user.the<QLabel>("previewRemarks")
                    .text()
                    .startsWith(QStringLiteral("This is the state in the backup file of ")));
        QVERIFY(user.click("confirmWriteButton"));
        QVERIFY(bench.saysOutcome(QStringLiteral("the state in the backup file of ")));
    }
};

AXISCOMP_WINDOW_TEST(TestBackupDialog)

} // namespace tst_backupdialog

#include "tst_backupdialog.moc"
