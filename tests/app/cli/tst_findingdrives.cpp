// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program_run.h"

#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QJsonArray>
#include <QSettings>

namespace tst_findingdrives {

using namespace axiscomp;
using test::ProgramRun;
using test::Sandbox;
using test::VirtualDriveProcess;

namespace {

QJsonArray drivesOf(const ProgramRun& run)
{
    return run.json().value("drives").toArray();
}

QJsonObject driveAt(const ProgramRun& run, const QString& endpoint)
{
    for (const QJsonValue& drive : drivesOf(run))
        if (drive.toObject().value("endpoint").toString() == endpoint)
            return drive.toObject();
    return {};
}

/// As the window keeps its connections.
void remember(const Sandbox& box, const QStringList& endpoints)
{
    QSettings settings(
        box.path("config/axiscomp/axis-compensation-wizard.conf"), QSettings::IniFormat);
    settings.setValue("compensationWizard/endpoints", endpoints);
}

} // namespace

class TestFindingDrives : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void withoutAnAddressTheConnectionsOfTheWindowAreAsked();
    void withoutAnyAddressItSaysHowToGoOn();
    void whatAnswersIsListedAndWhatDoesNotSaysWhy();
    void theBaudRateIsFound();
    void anyBaudNeedsFind();
    void nothingFoundIsNoConnection();
    void aPasswordIsNotShown();
    void aNetworkIsAskedByItsRange();
    void aRangeNeedsFindAndHasToBeOne();
};

void TestFindingDrives::withoutAnAddressTheConnectionsOfTheWindowAreAsked()
{
    const Sandbox box;
    const VirtualDriveProcess drive(box);
    remember(box, {drive.url()});
    const ProgramRun run = box.run({"axes", "--json"});
    VERIFY_CODE(run, 0);
    QCOMPARE(drivesOf(run).size(), 1);
    QCOMPARE(driveAt(run, drive.url()).value("axes").toArray().size(), 2);
}

void TestFindingDrives::withoutAnyAddressItSaysHowToGoOn()
{
    const Sandbox box;
    const ProgramRun run = box.run({"axes"});
    VERIFY_CODE(run, 2);
    QVERIFY2(run.err.contains("--find") && run.err.contains("--drive"), run.err.constData());
}

void TestFindingDrives::whatAnswersIsListedAndWhatDoesNotSaysWhy()
{
    const Sandbox box;
    const QString link = box.path("drive");
    const VirtualDriveProcess drive(box, {"--serial", link});
    const QString serial = "serial:" + link;
    const QStringList arguments{
        "axes", "--find", "--drive", serial, "--drive", "serial:/dev/no-such-port"};
    const ProgramRun text = box.run(arguments);
    VERIFY_CODE(text, 0);
    QVERIFY2(text.out.contains(serial.toUtf8()), text.text().constData());
    QVERIFY2(!text.out.contains("no-such-port"), text.text().constData());
    QVERIFY2(text.err.contains("there is no such port"), text.text().constData());

    const ProgramRun json = box.run(arguments + QStringList{"--json"});
    VERIFY_CODE(json, 0);
    QCOMPARE(driveAt(json, serial).value("axes").toArray().size(), 2);
    QVERIFY(driveAt(json, "serial:/dev/no-such-port").contains("error"));
}

void TestFindingDrives::theBaudRateIsFound()
{
    // A pty has no speed of its own: the first rate that is tried is as good as any.
    const Sandbox box;
    const QString link = box.path("drive");
    const VirtualDriveProcess drive(box, {"--serial", link});
    const QString serial = "serial:" + link + "?baud=57600";
    const ProgramRun run = box.run({"axes", "--find", "--any-baud", "--drive", serial, "--json"});
    VERIFY_CODE(run, 0);
    QCOMPARE(driveAt(run, serial).value("axes").toArray().size(), 2);
}

void TestFindingDrives::anyBaudNeedsFind()
{
    const Sandbox box;
    const ProgramRun run = box.run({"axes", "--any-baud"});
    VERIFY_CODE(run, 2);
    QVERIFY2(run.err.contains("--find"), run.err.constData());
}

void TestFindingDrives::nothingFoundIsNoConnection()
{
    const Sandbox box;
    const ProgramRun run = box.run({"axes", "--find", "--drive", "serial:/dev/no-such-port"});
    VERIFY_CODE(run, 5);
    QVERIFY2(run.err.contains("none of the places looked at"), run.err.constData());
}

void TestFindingDrives::aPasswordIsNotShown()
{
    const Sandbox box;
    const VirtualDriveProcess drive(box);
    QString address = drive.url();
    address.replace("http://", "http://user:secret@");
    const ProgramRun run = box.run({"axes", "--find", "--drive", address});
    VERIFY_CODE(run, 0);
    QVERIFY2(!run.out.contains("secret") && !run.err.contains("secret"), run.text().constData());
}

void TestFindingDrives::aNetworkIsAskedByItsRange()
{
    const Sandbox box;
    const VirtualDriveProcess drive(box);
    const QString port = drive.url().section(':', -1);
    const QStringList arguments{"axes", "--find", "--network", "127.0.0.1-4:" + port};
    const ProgramRun text = box.run(arguments);
    VERIFY_CODE(text, 0);
    QVERIFY2(text.out.contains(drive.url().toUtf8()), text.text().constData());
    QVERIFY2(text.err.contains("without an answer: 3"), text.text().constData());
    QVERIFY2(!text.err.contains("127.0.0.4"), text.text().constData());
    const ProgramRun json = box.run(arguments + QStringList{"--json"});
    VERIFY_CODE(json, 0);
    QCOMPARE(driveAt(json, drive.url()).value("axes").toArray().size(), 2);
}

void TestFindingDrives::aRangeNeedsFindAndHasToBeOne()
{
    const Sandbox box;
    const ProgramRun alone = box.run({"axes", "--network", "127.0.0.1-4"});
    VERIFY_CODE(alone, 2);
    QVERIFY2(alone.err.contains("--find"), alone.err.constData());
    const ProgramRun wrong = box.run({"axes", "--find", "--network", "10.0.0.0/8"});
    VERIFY_CODE(wrong, 2);
    QVERIFY2(wrong.err.contains("1024"), wrong.err.constData());
}

AXISCOMP_TEST(TestFindingDrives)

} // namespace tst_findingdrives

#include "tst_findingdrives.moc"
