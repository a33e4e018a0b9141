// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program_run.h"

#include "tests/support/patience.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QFile>
#include <QMap>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

#include <memory>

namespace tst_snapshotcommands {

using namespace axiscomp;
using test::ProgramRun;
using test::Sandbox;
using test::VirtualDriveProcess;

namespace {

// Steps that no decimal number is exactly, and numbers that are no shorter than a float32.
const QByteArray uneven1D = "X [mm],Error [um]\n0.1,0.333333343\n0.4,-2.71828175\n0.7,1e-7\n";
const QByteArray plane = "X,Y,T\n0,0,0\n50,0,0.001\n0,50,0.002\n50,50,-0.003\n";

/// OpenMetrics 1.0, of gauges alone: each metric once, with TYPE and HELP before its samples, no
/// sample twice, `# EOF` at the end. Values by "name{labels}"; what is wrong is in problem.
struct ParsedMetrics {
    QMap<QString, double> values;
    QString problem;

    explicit ParsedMetrics(const QByteArray& text)
    {
        static const QRegularExpression sample(
            QStringLiteral("^([a-z_]+)\\{((?:[a-z]+=\"(?:[^\"\\\\\\n]|\\\\[\\\\\"n])*\",?)*)\\} "
                           "(NaN|[+-]Inf|-?[0-9.]+(?:e[+-]?[0-9]+)?)$"));
        if (!text.endsWith("\n# EOF\n"))
            problem = QStringLiteral("no EOF");
        QStringList lines = QString::fromUtf8(text).split(u'\n');
        lines.removeLast();
        lines.removeLast();
        QSet<QString> families;
        QString family;
        for (const QString& line : lines) {
            if (line.startsWith("# TYPE ")) {
                const QStringList words = line.split(u' ');
                family = words.value(2);
                if (words.size() != 4 || words[3] != "gauge" || families.contains(family))
                    problem = line;
                families.insert(family);
                continue;
            }
            if (line.startsWith("# HELP " + family + " "))
                continue;
            const auto match = sample.match(line);
            const QString key = match.captured(1) + "{" + match.captured(2) + "}";
            if (!match.hasMatch() || match.captured(1) != family || values.contains(key))
                problem = line;
            bool isNumber = false;
            values.insert(key, match.captured(3).toDouble(&isNumber));
            if (!isNumber)
                problem = line;
        }
    }

    /// Of the one sample whose labels have all of these; NaN where there is none, or several.
    [[nodiscard]] double value(const QString& name, const QStringList& labels = {}) const
    {
        QList<double> found;
        for (auto it = values.begin(); it != values.end(); ++it) {
            bool fits = it.key().startsWith(name + "{");
            for (const QString& label : labels)
                fits = fits && it.key().contains(label);
            if (fits)
                found.append(it.value());
        }
        return found.size() == 1 ? found.first() : qQNaN();
    }
};

ProgramRun write(const Sandbox& box, const VirtualDriveProcess& drive, int axis,
    const QString& file, const QStringList& sources, const QStringList& more = {})
{
    QStringList arguments{"write", "--drive", drive.url(), "--axis", QString::number(axis),
        "--data", file, "--dims", QString::number(sources.size())};
    for (int n = 0; n < sources.size(); ++n)
        arguments << QStringLiteral("--source%1").arg(n + 1) << sources[n];
    return box.run(arguments + more);
}

} // namespace

class TestSnapshotCommands : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aSnapshotThatIsAppliedToFreshDrivesGivesTheSameBytes()
    {
        const Sandbox box;
        box.file("uneven.csv", uneven1D);
        box.file("plane.csv", plane);
        auto drive = std::make_unique<VirtualDriveProcess>(box, QStringList{"--axes", "3"});
        const QString address = drive->url().section('/', -1);
        const QStringList own{test::positionSource(0)};
        // In another slot than the first one.
        VERIFY_CODE(
            write(box, *drive, 0, "uneven.csv", own, {"--slot", "Small3", "--persistent"}), 0);
        VERIFY_CODE(
            write(box, *drive, 2, "plane.csv", {test::positionSource(0), test::positionSource(1)}),
            0);
        VERIFY_CODE(box.run({"activate", "--drive", drive->url(), "--axis", "0"}), 0);
        const ProgramRun first =
            box.run({"snapshot", "--drive", drive->url(), "-o", "one", "--name", "Mill"});
        VERIFY_CODE(first, 0);
        VERIFY_CODE(box.run({"plan", "one/machine.toml"}), 0);

        drive.reset();
        drive = std::make_unique<VirtualDriveProcess>(
            box, QStringList{"--axes", "3", "--http", address});
        QVERIFY(drive->isReady());
        VERIFY_CODE(box.run({"plan", "one/machine.toml"}), 9);
        VERIFY_CODE(box.run({"apply", "one/machine.toml", "--activate"}), 0);
        VERIFY_CODE(
            box.run({"snapshot", "--drive", drive->url(), "-o", "two", "--name", "Mill"}), 0);
        for (const char* const name : {"machine.toml", "100001-axis0.csv", "100001-axis2.csv"}) {
            QVERIFY2(!box.content(QStringLiteral("one/") + name).isEmpty(), name);
            QCOMPARE(box.content(QStringLiteral("two/") + name),
                box.content(QStringLiteral("one/") + name));
        }
        const QByteArray text = box.content("one/machine.toml");
        for (const char* const part : {"name = \"Mill\"", "serial = 100001", "active = true",
                 "persistent = true", "no-table = true"})
            QVERIFY2(text.contains(part), text.constData());
    }

    void aSnapshotOfSomeOfTheDrivesIsNotWritten()
    {
        const Sandbox box;
        const VirtualDriveProcess drive(box);
        const ProgramRun run = box.run(
            {"snapshot", "--drive", drive.url(), "--drive", "http://127.0.0.1:1", "-o", "folder"});
        VERIFY_CODE(run, 5);
        QVERIFY(!QFile::exists(box.path("folder")));
        VERIFY_CODE(
            box.run({"snapshot", "--drive", drive.url(), "--drive", drive.url(), "-o", "folder"}),
            2);
        QVERIFY(!QFile::exists(box.path("folder")));
    }

    /// Of a machine of many drives and axes nobody would find it.
    void aSnapshotThatIsRefusedNamesDriveAndAxis()
    {
        const Sandbox box;
        box.file("uneven.csv", uneven1D);
        const VirtualDriveProcess first(box);
        const VirtualDriveProcess second(box, {"--name", "Two"});
        QVERIFY(first.isReady() && second.isReady());
        VERIFY_CODE(write(box, second, 0, "uneven.csv", {test::positionSource(0)}), 0);
        QVERIFY(second.writeRegister(
            "Axes[1]/Parameters/Compensations/Axis/Table", std::string("Small1")));
        const QStringList snapshot{
            "snapshot", "--drive", first.url(), "--drive", second.url(), "-o", "folder"};
        const ProgramRun run = box.run(snapshot);
        VERIFY_CODE(run, 2);
        const QByteArray drive = "because of the drive at " + second.url().toUtf8() + "\n";
        QVERIFY2(run.err.contains(drive), run.err.constData());
        QVERIFY2(run.err.contains("the source of dimension 1 of axis 1 is missing"),
            run.err.constData());
        const ProgramRun asJson = box.run(snapshot + QStringList{"--json"});
        const QJsonObject context =
            asJson.json().value("error").toObject().value("context").toObject();
        QCOMPARE(context.value("endpoint").toString(), second.url());
        QCOMPARE(context.value("ofAxis").toVariant().toInt(), 1);
    }

    void aSnapshotIsAFolderAndHasAName()
    {
        const Sandbox box;
        const VirtualDriveProcess drive(box);
        const ProgramRun stream = box.run({"snapshot", "--drive", drive.url(), "-o", "-"});
        VERIFY_CODE(stream, 2);
        QVERIFY2(stream.err.contains("a folder of several files"), stream.err.constData());
        QVERIFY(!QFile::exists(box.path("-")));
        const ProgramRun named = box.run({"snapshot", "--drive", drive.url(), "-o", "folder",
            "--name", QStringLiteral("a") + QChar(0x7f)});
        VERIFY_CODE(named, 2);
        QVERIFY2(named.err.contains("a machine cannot be called a"), named.err.constData());
        QVERIFY(!QFile::exists(box.path("folder")));
    }

    void metricsSayWhatTheDrivesDo()
    {
        const Sandbox box;
        box.file("uneven.csv", uneven1D);
        const VirtualDriveProcess drive(box, {"--name", "a \"b\" \\"});
        VERIFY_CODE(write(box, drive, 0, "uneven.csv", {test::positionSource(0)}), 0);
        VERIFY_CODE(box.run({"activate", "--drive", drive.url(), "--axis", "0"}), 0);
        VERIFY_CODE(box.run({"snapshot", "--drive", drive.url(), "-o", "m"}), 0);
        const ProgramRun run = box.run(
            {"metrics", "--drive", drive.url(), "--drive", "http://127.0.0.1:1", "--prove"});
        VERIFY_CODE(run, 0);
        const ParsedMetrics metrics(run.out);
        QVERIFY2(metrics.problem.isEmpty(), qPrintable(metrics.problem));
        const QString here = "endpoint=\"" + drive.url() + "\"";
        QCOMPARE(metrics.value("axiscomp_drive_up", {here}), 1.0);
        QCOMPARE(metrics.value("axiscomp_drive_up", {"endpoint=\"http://127.0.0.1:1\""}), 0.0);
        QCOMPARE(metrics.value("axiscomp_drive_axes", {"drive=\"a \\\"b\\\" \\\\\""}), 2.0);
        QCOMPARE(metrics.value("axiscomp_axis_state", {"axis=\"0\"", "state=\"Active\""}), 1.0);
        QCOMPARE(metrics.value("axiscomp_axis_state", {"axis=\"0\"", "state=\"Disabled\""}), 0.0);
        QCOMPARE(metrics.value("axiscomp_axis_state", {"axis=\"1\"", "state=\"Disabled\""}), 1.0);
        QCOMPARE(metrics.value("axiscomp_axis_table", {"axis=\"0\""}), 1.0);
        QCOMPARE(metrics.value("axiscomp_axis_table_persistent", {"axis=\"0\""}), 0.0);
        QCOMPARE(metrics.value("axiscomp_axis_table", {"axis=\"1\""}), 0.0);
        QVERIFY(metrics.value("axiscomp_axis_last_write_timestamp_seconds") > 1.6e9);
        QVERIFY(metrics.value("axiscomp_flash_operations_left") > 0);
        QVERIFY(!qIsNaN(metrics.value("axiscomp_axis_proof_largest_difference")));
        QVERIFY(qIsNaN(metrics.value("axiscomp_axis_differs", {"axis=\"0\""})));

        const ProgramRun twice =
            box.run({"metrics", "--drive", drive.url(), "--drive", drive.url() + "/"});
        VERIFY_CODE(twice, 2);
        QVERIFY2(twice.err.contains("is named twice"), twice.err.constData());
        QVERIFY(twice.out.isEmpty());

        const QStringList ofMachine{"metrics", "--machine", "m/machine.toml"};
        const ParsedMetrics same(box.run(ofMachine).out);
        QCOMPARE(same.value("axiscomp_axis_differs", {"axis=\"0\""}), 0.0);
        VERIFY_CODE(box.run({"deactivate", "--drive", drive.url(), "--axis", "0"}), 0);
        const ParsedMetrics drifted(box.run(ofMachine).out);
        QVERIFY2(drifted.problem.isEmpty(), qPrintable(drifted.problem));
        QCOMPARE(drifted.value("axiscomp_axis_differs", {"axis=\"0\""}), 1.0);
        QCOMPARE(drifted.value("axiscomp_axis_comparable", {"axis=\"0\""}), 1.0);

        QByteArray renamed = box.content("m/machine.toml");
        QVERIFY(renamed.contains("axis = \"0\""));
        box.file("m/machine.toml", renamed.replace("axis = \"0\"", "axis = \"Q\""));
        const ProgramRun unfound = box.run(ofMachine);
        VERIFY_CODE(unfound, 0);
        QVERIFY2(unfound.err.contains("axis Q: cannot be compared"), unfound.err.constData());
        const ParsedMetrics withoutAxis(unfound.out);
        QVERIFY2(withoutAxis.problem.isEmpty(), qPrintable(withoutAxis.problem));
        QCOMPARE(withoutAxis.value("axiscomp_axis_differs", {"name=\"Q\""}), 1.0);
        QCOMPARE(withoutAxis.value("axiscomp_axis_comparable", {"name=\"Q\""}), 0.0);
    }

    void anotherDriveThanThatOfTheMachineFileIsNotUp()
    {
        const Sandbox box;
        const VirtualDriveProcess drive(box);
        VERIFY_CODE(box.run({"snapshot", "--drive", drive.url(), "-o", "m"}), 0);
        QByteArray machine = box.content("m/machine.toml");
        QVERIFY(machine.contains("serial = 100001"));
        box.file("m/machine.toml", machine.replace("serial = 100001", "serial = 100002"));
        const ProgramRun run = box.run({"metrics", "--machine", "m/machine.toml"});
        VERIFY_CODE(run, 0);
        const ParsedMetrics metrics(run.out);
        QVERIFY2(metrics.problem.isEmpty(), qPrintable(metrics.problem));
        QCOMPARE(metrics.value("axiscomp_drive_up"), 0.0);
        // It did answer.
        const QByteArray help = "# HELP axiscomp_drive_up 1: the drive answered, and is the one of "
                                "the machine file, if there is one.\n";
        QVERIFY2(run.out.contains(help), run.out.constData());
    }

    void anAddressInAMachineFileThatIsNoneDoesNotEndTheMetrics()
    {
        const Sandbox box;
        const VirtualDriveProcess drive(box);
        VERIFY_CODE(box.run({"snapshot", "--drive", drive.url(), "-o", "m"}), 0);
        QByteArray machine = box.content("m/machine.toml");
        QVERIFY(machine.contains(drive.url().toUtf8()));
        box.file("m/machine.toml", machine.replace(drive.url().toUtf8(), "ftp://mill"));
        const ProgramRun run = box.run({"metrics", "--machine", "m/machine.toml"});
        VERIFY_CODE(run, 0);
        QVERIFY(!run.err.isEmpty());
        const ParsedMetrics metrics(run.out);
        QVERIFY2(metrics.problem.isEmpty(), qPrintable(metrics.problem));
        QCOMPARE(metrics.value("axiscomp_drive_up"), 0.0);
    }
};

AXISCOMP_TEST(TestSnapshotCommands)

} // namespace tst_snapshotcommands

#include "tst_snapshotcommands.moc"
