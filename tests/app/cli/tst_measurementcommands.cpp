// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/judge/iso230.h"
#include "core/metrology/record/calibration_record.h"
#include "tests/app/program_run.h"

#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <cmath>

namespace tst_measurementcommands {

using namespace axiscomp;
using test::ProgramRun;
using test::Sandbox;

namespace {

QString publicFile(const QString& name)
{
    return QStringLiteral(AXISCOMP_SOURCE_FOLDER "/tests/data/metrology/") + name;
}

const QByteArray small = "target [mm],direction,run,deviation [um]\n0,+,1,1\n10,+,1,2\n10,-,1,3\n"
                         "0,-,1,4\n";

/// Two runs up and down over 11 targets up to 100 mm, in um: a peak at 50 mm, seen by a scale that
/// is longer by this share; the fourth value of the second run up is gross.
QByteArray peak(const QByteArray& head, double height, double longer, double gross)
{
    QByteArray text = head + "target [mm],direction,run,deviation [um]\n";
    for (const char* direction : {"+", "-"})
        for (int run = 1; run <= 2; ++run)
            for (int i = 0; i <= 10; ++i) {
                const double position = 10.0 * i;
                double deviation = (i == 5 ? height : 0.0) * (1.0 + longer);
                deviation += 1000.0 * position * longer;
                if (i == 3 && run == 2 && *direction == '+')
                    deviation += gross;
                text += QByteArray::number(position) + ',' + direction + ','
                    + QByteArray::number(run) + ',' + QByteArray::number(deviation, 'g', 17) + '\n';
            }
    return text;
}

/// M of both measurements, in mm.
bool areErrors(const ProgramRun& run, double before, double after)
{
    const auto spread = [json = run.json()](const char* side) {
        return json.value(QLatin1String(side)).toObject().value("M").toDouble();
    };
    if (std::abs(spread("before") - before) < 1e-9 && std::abs(spread("after") - after) < 1e-9)
        return true;
    qInfo("M is %.9f before and %.9f after; %s", spread("before"), spread("after"),
        run.err.constData());
    return false;
}

} // namespace

class tst_MeasurementCommands : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    /// Two targets 10 mm apart; a stage that is good to a nanometre.
    void figuresBelowAMicrometreAreShownInNanometres()
    {
        const Sandbox box;
        const ProgramRun run = box.run({"judge",
            box.file("fine.csv",
                "target [mm],direction,run,deviation [nm]\n0,+,1,0.2\n10,+,1,0.9\n0,-,1,0.4\n"
                "10,-,1,0.5\n"),
            "--tolerance", "E=5nm"});
        VERIFY_CODE(run, 0);
        const QString text = QString::fromUtf8(run.out).simplified();
        QVERIFY2(text.contains("Figures of ISO 230-2:2014, in nm"), run.out.constData());
        QVERIFY2(text.contains("systematic deviation E 0.700 0.100 0.700"), run.out.constData());
        QVERIFY2(text.contains("Targets, in nm"), run.out.constData());
        QVERIFY2(
            text.contains("0.700 nm 5.000 nm uncertainty not stated passed"), run.out.constData());
    }

    /// A of both directions is not defined there.
    void runsOfOneDirectionHaveItsFiguresWithoutTheirOffsets()
    {
        const Sandbox box;
        const QString file = publicFile("b02_y.csv");
        const ProgramRun both = box.run({"judge", file});
        VERIFY_CODE(both, 0);
        QVERIFY2(both.out.contains("Without the offsets of the runs: A 113.987 um, R 33.085 um\n"),
            both.out.constData());
        const ProgramRun up = box.run(
            {"judge", file, "--exclude", "run:down:1,run:down:2,run:down:3,run:down:4,run:down:5"});
        VERIFY_CODE(up, 0);
        QVERIFY2(up.out.contains("Without the offsets of the runs: A up 100.680 um, R up 12.939 "
                                 "um\n"),
            up.out.constData());
    }

    /// Set to zero 12.5 mm away. Documents have the values as they were read.
    void theZeroOfTheInstrumentIsInNoList()
    {
        const Sandbox box;
        const QString file = box.file("zero.csv",
            "target [mm],direction,run,deviation [um]\n0,+,1,12500\n10,+,1,12502\n"
            "0,-,1,12501\n10,-,1,12505\n");
        const ProgramRun judged = box.run({"judge", file});
        VERIFY_CODE(judged, 0);
        const QString targets = QString::fromUtf8(judged.out).simplified();
        QVERIFY2(targets.contains("Targets, in um, 0 = mean at 0 mm"), judged.out.constData());
        QVERIFY2(targets.contains("1 0 1 -0.500 - 1 0.500 - 0.000 -1.000 - "
                                  "2 10 1 1.500 - 1 4.500 - 3.000 -3.000 -"),
            judged.out.constData());
        const ProgramRun compared = box.run({"compare", file, file});
        VERIFY_CODE(compared, 0);
        const QString left = QString::fromUtf8(compared.out).simplified();
        QVERIFY2(
            left.contains("What is left at the targets, in um, 0 = mean at 0 mm target [mm] left "
                          "standard error 0 0.000 - 10 3.000 -"),
            compared.out.constData());
        const QJsonObject json = box.run({"compare", file, file, "--json"}).json();
        const auto first = json.value("residual").toArray().at(0).toObject();
        QVERIFY(std::abs(first.value("value").toDouble() - 12.5005) < 1e-9);
    }

    void aComparisonHasEveryKeyOfTheDocumentation()
    {
        const Sandbox box;
        const ProgramRun run = box.run({"compare", publicFile("b02_x.csv"), publicFile("b02_x.csv"),
            "--tolerance", "A=150um,R=50um", "--json"});
        VERIFY_CODE(run, 8); // R is 55.2 um
        const QJsonObject json = run.json();
        QCOMPARE(json.keys(),
            (QStringList{"after", "afterOfAllValues", "asPredicted", "before", "beforeOfAllValues",
                "corrections", "correctionsBefore", "excluded", "heldOut", "hints",
                "largestAsPredicted", "predicted", "residual", "source", "uncertainty", "unit",
                "verdict", "verdictOfAllValues", "warnings"}));
        QVERIFY(std::abs(json.value("after").toObject().value("A").toDouble() - 0.1352711) < 1e-6);
        QCOMPARE(json.value("residual").toArray().size(), 9);
        QVERIFY(json.value("asPredicted").isNull());
        QCOMPARE(
            json.value("hints").toArray().at(0).toObject().value("name").toString(), "NotActive");
        QCOMPARE(
            json.value("verdict").toArray().at(1).toObject().value("result").toString(), "failed");
    }

    void aRecordSaysWhatWasPromisedAndKeepsWhatCameOfIt()
    {
        const Sandbox box;
        const QByteArray record = R"({"format": "axiscomp-record", "version": 1, "later": {"a": 1},
            "write": {"time": "2026-11-21T09:00:00Z", "slot": "Small1", "persistent": true,
            "crc32": "1c291ca3"}, "prediction": {"before": {}, "predicted": {"M": 0.001}, "heldOut":
            {"rms": 1, "largest": 1, "M": 0.001, "targets": [], "residuals": []}}})";
        box.file("x.axcal", record);
        box.file("before.csv", small);
        box.file("after.csv",
            "// compensation: crc:1c291ca3\ntarget [mm],direction,run,deviation [um]\n0,+,1,0.1\n"
            "10,+,1,0.2\n10,-,1,0.3\n0,-,1,0.4\n");
        const QStringList words{"compare", "before.csv", "after.csv", "--record", "x.axcal"};
        const ProgramRun off =
            box.run({"compare", "after.csv", "before.csv", "--record", "x.axcal"});
        VERIFY_CODE(off, 2);
        QVERIFY2(off.err.contains("error: MeasurementState: "), off.err.constData());
        VERIFY_CODE(box.run({"compare", "after.csv", "before.csv", "--record", "x.axcal",
                        "--measured-with", "on"}),
            0);
        const ProgramRun run = box.run(words + QStringList{"--keep", "--json"});
        VERIFY_CODE(run, 0);
        QCOMPARE(run.json().value("asPredicted").toBool(), true);
        QCOMPARE(run.json().value("predicted").toObject().value("M").toDouble(), 0.001);
        QFile kept(box.path("x.axcal"));
        QVERIFY(kept.open(QIODevice::ReadOnly));
        const QJsonObject json = QJsonDocument::fromJson(kept.readAll()).object();
        QCOMPARE(json.value("later").toObject().value("a").toInt(), 1);
        const QJsonObject after = json.value("after").toArray().at(0).toObject();
        QCOMPARE(after.value("asPredicted").toBool(), true);
        QCOMPARE(after.value("measurement")
                     .toObject()
                     .value("files")
                     .toArray()
                     .at(0)
                     .toObject()
                     .value("file")
                     .toString(),
            "after.csv");
        const ProgramRun text = box.run(words);
        VERIFY_CODE(text, 0);
        QVERIFY2(text.out.contains("As predicted: M is"), text.out.constData());
        VERIFY_CODE(box.run({"compare", "before.csv", "after.csv", "--keep"}), 2);
        box.file("new.axcal", R"({"format": "axiscomp-record", "version": 9})");
        const ProgramRun newer =
            box.run({"compare", "before.csv", "after.csv", "--record", "new.axcal"});
        VERIFY_CODE(newer, 3);
        QVERIFY2(newer.err.contains("error: InvalidRecord: "), newer.err.constData());
    }

    /// A tolerance that is met because the value that fails it is left out.
    void aComparisonSaysWhatIsLeftOut()
    {
        const Sandbox box;
        box.file("before.csv", peak({}, 4.0, 0.0, 0.0));
        box.file("after.csv", peak({}, 0.4, 0.0, 20.0));
        const QStringList words{"compare", "before.csv", "after.csv", "--tolerance", "E=5um"};
        VERIFY_CODE(box.run(words), 8);
        const QStringList chosen = words + QStringList{"--exclude", "up:4:2"};
        const ProgramRun run = box.run(chosen);
        VERIFY_CODE(run, 0);
        const QByteArray said =
            "second measurement: 1 value excluded, not an evaluation by ISO 230-2";
        QVERIFY2(run.out.contains(said) && run.err.contains(said), run.out.constData());
        QVERIFY2(run.out.contains("Figures of all values, in um"), run.out.constData());
        QVERIFY2(run.out.contains("Verdict of all values"), run.out.constData());
        QVERIFY2(run.err.contains("(tolerance 5.000 um: failed)"), run.err.constData());
        const QJsonObject json = box.run(chosen + QStringList{"--json"}).json();
        QCOMPARE(json.value("excluded").toObject().value("after").toArray().size(), 1);
        QVERIFY(json.value("beforeOfAllValues").isNull());
        QVERIFY(json.value("afterOfAllValues").toObject().value("E").toDouble() > 0.005);
        const auto verdict = json.value("verdictOfAllValues").toArray().at(0).toObject();
        QCOMPARE(verdict.value("result").toString(), "failed");
        QCOMPARE(json.value("warnings").toArray().at(0).toObject().value("code").toString(),
            "ValuesExcluded");
    }

    /// At 20 C the error is a peak of 4 um, and a tenth of that with the table. A scale
    /// of 11.5e-6/K at 25 C and 22 C adds 57.5 and 23 um/m to what is measured: the factor of the
    /// correction is 1 / (1 + a (T - 20)), by which it is undone exactly.
    void bothMeasurementsAreComparedAt20Degrees()
    {
        const Sandbox box;
        box.file(
            "before.csv", peak("// corrected: none\n// compensation: off\n", 4.0, 57.5e-6, 100.0));
        const ProgramRun fit =
            box.run({"fit", "before.csv", "--record", "x.axcal", "--lookup-at", "encoder",
                "--temperature", "25", "--expansion", "11.5e-6", "--exclude", "up:4:2", "--json"});
        VERIFY_CODE(fit, 0);
        const auto crc =
            static_cast<quint32>(fit.json().value("table").toObject().value("crc").toDouble());
        const QByteArray active = "// compensation: crc:" + QByteArray::number(crc, 16) + '\n';
        box.file("after.csv", peak("// corrected: none\n" + active, 0.4, 23e-6, 0.0));
        const QStringList both{"compare", "before.csv", "after.csv", "--record", "x.axcal"};
        const ProgramRun open = box.run(both);
        VERIFY_CODE(open, 2);
        QVERIFY2(open.err.contains("during the second one (--temperature)"), open.err.constData());
        const QStringList warm{"--temperature", "22"};
        QVERIFY(areErrors(box.run(both + warm + QStringList{"--json"}), 0.004, 0.0004));
        const QStringList alone{"compare", "after.csv", "--record", "x.axcal"};
        QVERIFY(areErrors(box.run(alone + warm + QStringList{"--json"}), 0.004, 0.0004));
        // The temperature of the second file counts where it is said.
        box.file("after-warm.csv",
            peak("// corrected: none\n// material temperature: 22\n" + active, 0.4, 23e-6, 0.0));
        QVERIFY(areErrors(box.run({"compare", "after-warm.csv", "--record", "x.axcal", "--json"}),
            0.004, 0.0004));
        box.file("after-20.csv", peak("// corrected: 20C\n" + active, 0.4, 0.0, 0.0));
        QVERIFY(areErrors(
            box.run({"compare", "after-20.csv", "--record", "x.axcal", "--json"}), 0.004, 0.0004));

        VERIFY_CODE(box.run(alone + warm + QStringList{"--keep"}), 0);
        const auto record = loadRecord(box.path("x.axcal").toStdString());
        VERIFY_RESULT(record);
        const auto kept = usedMeasurement(record->after.front().measurement);
        VERIFY_RESULT(kept);
        QVERIFY(std::abs(*iso230Figures(*kept)[Iso230Figure::M].value - 0.0004) < 1e-9);
    }

    /// A scale that is 57.5 um/m too long and nothing else: at 20 C nothing is left, wherever the
    /// second measurement begins.
    void bothMeasurementsAreCorrectedFromTheSameDatum()
    {
        const Sandbox box;
        const auto warm = [](std::initializer_list<int> targets) {
            QByteArray text = "target [mm],direction,run,deviation [um]\n";
            for (const int target : targets)
                for (const char* const run : {",+,1,", ",+,2,", ",-,1,", ",-,2,"})
                    text += QByteArray::number(target) + run
                        + QByteArray::number(target * 57.5e-3, 'g', 12) + '\n';
            return text;
        };
        box.file("before.csv", "// compensation: off\n" + warm({0, 100, 200, 300, 400, 500, 600}));
        box.file("after.csv", warm({200, 260, 310, 333, 400, 500}));
        const QStringList at25{
            "--temperature", "25", "--expansion", "11.5e-6", "--not-corrected", "--json"};
        VERIFY_CODE(box.run(QStringList{"fit", "before.csv", "--record", "x.axcal", "--lookup-at",
                                "encoder", "--zero", "keep"}
                        + at25),
            0);
        const QStringList second{"compare", "after.csv", "--record", "x.axcal"};
        const QStringList stated{"--measured-with", "on"};
        const auto datum = [](const ProgramRun& run) {
            return run.json()
                .value("corrections")
                .toObject()
                .value("temperature")
                .toObject()
                .value("datum")
                .toDouble(-1.0);
        };
        const ProgramRun run = box.run(second + stated + at25);
        VERIFY_CODE(run, 0);
        QCOMPARE(datum(run), 0.0);
        for (const QJsonValue& left : run.json().value("residual").toArray())
            QVERIFY(std::abs(left.toObject().value("value").toDouble()) < 1e-9);
        const ProgramRun own = box.run(second + stated + at25 + QStringList{"--datum", "200"});
        VERIFY_CODE(own, 0);
        QCOMPARE(datum(own), 200.0);
    }

    void aSecondMeasurementOverLessOfTheAxisIsSaidAndOneBesideItRefused()
    {
        const Sandbox box;
        const auto over = [](const char* first, const char* last) {
            QByteArray text = "target [mm],direction,run,deviation [um]\n";
            for (const char* const target : {first, last})
                for (const char* const run :
                    {",+,1,0.1\n", ",+,2,0.2\n", ",-,1,0.1\n", ",-,2,0.2\n"})
                    text += QByteArray(target) + run;
            return text;
        };
        box.file("before.csv", peak("// compensation: off\n", 4.0, 0.0, 0.0));
        box.file("short.csv", over("0", "1"));
        box.file("far.csv", over("600", "700"));
        VERIFY_CODE(
            box.run({"fit", "before.csv", "--record", "x.axcal", "--lookup-at", "encoder"}), 0);
        const QStringList proof{"--record", "x.axcal", "--measured-with", "on", "--keep"};
        const ProgramRun shorter = box.run(QStringList{"compare", "short.csv"} + proof);
        VERIFY_CODE(shorter, 0);
        const QByteArray ranges = "first measurement from 0 to 100 mm, second one from ";
        QVERIFY2(shorter.out.contains(ranges + "0 to 1 mm")
                && shorter.err.contains(ranges + "0 to 1 mm"),
            shorter.out.constData());
        const QByteArray isOpen = "Whether it is as predicted is open, since ";
        QVERIFY2(shorter.out.contains(isOpen + "less of the axis was measured: "),
            shorter.out.constData());
        QVERIFY(!box.content("x.axcal").contains("asPredicted"));
        const ProgramRun wider = box.run({"compare", box.file("wide.csv", over("0", "100")),
            "--record", "x.axcal", "--measured-with", "on"});
        VERIFY_CODE(wider, 0);
        QVERIFY2(wider.out.contains(isOpen + "its targets are farther apart than before: "),
            wider.out.constData());
        const ProgramRun far = box.run(QStringList{"compare", "far.csv"} + proof);
        VERIFY_CODE(far, 2);
        QVERIFY2(far.err.contains(ranges + "600 to 700 mm"), far.err.constData());
        VERIFY_CODE(box.run({"report", "x.axcal", "-o", "x.html"}), 0);
        QVERIFY(box.content("x.html").contains("Warning: " + ranges + "0 to 1 mm"));
    }

    /// Held out a peak at one of the targets is 6 um, though M is 4 um.
    void aTableThatDoesNothingIsNotAsPredicted()
    {
        const Sandbox box;
        box.file("before.csv", peak("// compensation: off\n", 4.0, 0.0, 0.0));
        box.file("after.csv", peak({}, 4.0, 0.0, 0.0));
        VERIFY_CODE(
            box.run({"fit", "before.csv", "--record", "x.axcal", "--lookup-at", "encoder"}), 0);
        const ProgramRun run = box.run(
            {"compare", "after.csv", "--record", "x.axcal", "--measured-with", "on", "--keep"});
        VERIFY_CODE(run, 0);
        QVERIFY2(run.out.contains("Not as predicted, since the machine is no better than before: M "
                                  "is 4.000 um after and was 4.000 um before\n"),
            run.out.constData());
        QVERIFY2(run.out.contains("the error is the same as before: the compensation was not "
                                  "active"),
            run.out.constData());
        QVERIFY(box.content("x.axcal").contains("\"asPredicted\": false"));
    }

    void theFirstMeasurementIsTheOneOfTheRecord()
    {
        const Sandbox box;
        box.file("before.csv", peak("// compensation: off\n", 4.0, 0.0, 0.0));
        box.file("other.csv", peak("// compensation: off\n", 5.0, 0.0, 0.0));
        box.file("after.csv", peak({}, 0.4, 0.0, 0.0));
        VERIFY_CODE(
            box.run({"fit", "before.csv", "--record", "x.axcal", "--lookup-at", "encoder"}), 0);
        const QStringList proof{"after.csv", "--record", "x.axcal", "--measured-with", "on"};
        VERIFY_CODE(box.run(QStringList{"compare", "before.csv"} + proof), 0);
        const ProgramRun other = box.run(QStringList{"compare", "other.csv"} + proof);
        VERIFY_CODE(other, 2);
        QVERIFY2(other.err.contains(
                     "other.csv is not the measurement that the record was made of (before.csv)"),
            other.err.constData());
        VERIFY_CODE(box.run(QStringList{"compare"} + proof), 0);
        VERIFY_CODE(box.run({"compare", "after.csv"}), 2);
    }

    void oneSideAloneIsNotCorrectedSilently()
    {
        const Sandbox box;
        box.file("warm.csv", peak("// corrected: none\n", 4.0, 57.5e-6, 0.0));
        box.file("at20.csv", peak("// corrected: 20C\n", 4.0, 0.0, 0.0));
        const ProgramRun refused = box.run({"compare", "at20.csv", "warm.csv"});
        VERIFY_CODE(refused, 2);
        QVERIFY2(refused.err.contains("--temperature and --expansion"), refused.err.constData());
        QVERIFY(areErrors(box.run({"compare", "at20.csv", "warm.csv", "--temperature", "25",
                              "--expansion", "11.5e-6", "--json"}),
            0.004, 0.004));
        const ProgramRun told = box.run({"compare", "warm.csv", "at20.csv"});
        VERIFY_CODE(told, 0);
        QVERIFY2(told.err.contains("the second measurement is corrected for temperature or dead "
                                   "path and the first is not"),
            told.err.constData());
    }

    void aJudgementHasEveryKeyOfTheDocumentation()
    {
        const Sandbox box;
        const ProgramRun run = box.run(
            {"judge", publicFile("b02_x.csv"), "--tolerance", "A=150um,R=60um", "--vdi", "--json"});
        VERIFY_CODE(run, 0);
        const QJsonObject json = run.json();
        QCOMPARE(json.keys(),
            (QStringList{"axis", "axisOfAllValues", "compliance", "contradictions", "corrections",
                "drift", "excluded", "outliers", "perTarget", "published", "runs", "source",
                "standard", "targets", "uncertainty", "unit", "vdi3441", "verdict",
                "verdictOfAllValues", "warnings", "where"}));
        const QJsonObject axis = json.value("axis").toObject();
        QVERIFY(std::abs(axis.value("A").toDouble() - 0.1352711) < 1e-6);
        QCOMPARE(json.value("where").toObject().value("B").toInt(), 5);
        QCOMPARE(json.value("where").toObject().value("E").toArray(), (QJsonArray{3, 5}));
        QCOMPARE(json.value("targets").toArray().size(), 9);
        QVERIFY(json.value("published").isNull());
        const QJsonObject verdict = json.value("verdict").toArray().at(1).toObject();
        QCOMPARE(verdict.value("figure").toString(), "R");
        QCOMPARE(verdict.value("result").toString(), "passed");
        QVERIFY(verdict.value("U").isNull());
        const QJsonObject source = json.value("source").toArray().at(0).toObject();
        QCOMPARE(source.value("format").toString(), "runs");
        QCOMPARE(source.value("sha256").toString().size(), 64);
        const QJsonObject outlier =
            json.value("outliers").toObject().value("flagged").toArray().at(0).toObject();
        QCOMPARE(outlier.value("target").toInt(), 5);
        QCOMPARE(outlier.value("direction").toString(), "up");
    }

    void aToleranceThatIsNotMetHasACodeOfItsOwn()
    {
        const Sandbox box;
        const QString file = publicFile("bifrost.csv"); // A 18.571 um
        VERIFY_CODE(box.run({"judge", file, "--tolerance", "A=19um"}), 0);
        VERIFY_CODE(box.run({"judge", file, "--tolerance", "A=18um"}), 8);
        const ProgramRun undecided =
            box.run({"judge", file, "--tolerance", "A=19um", "--uncertainty", "U=1um"});
        VERIFY_CODE(undecided, 8);
        QVERIFY2(undecided.out.contains("undecided"), undecided.out.constData());
        box.file(
            "one-way.csv", "target [mm],direction,deviation [um]\n0,+,1\n9,+,1\n0,+,2\n9,+,1\n");
        const ProgramRun notDefined = box.run({"judge", "one-way.csv", "--tolerance", "A=1000"});
        VERIFY_CODE(notDefined, 8);
        QVERIFY2(notDefined.out.contains("not defined"), notDefined.out.constData());
        QVERIFY2(notDefined.err.contains(
                     "warning: A=1000 has no unit and is taken as 1000 mm, 1000000 um"),
            notDefined.err.constData());
    }

    void aBudgetGivesTheUncertainty()
    {
        const Sandbox box;
        box.file("budget.json",
            R"({"length": 500, "device": 0.0002, "devicePpm": 0.5, "misalignment": 0.5,
                "expansion": 11.5e-6, "temperatureRange": 0.4, "temperature": 22.5,
                "expansionRange": 2e-6, "environment": 0.0006})");
        const ProgramRun run =
            box.run({"judge", publicFile("bifrost.csv"), "--uncertainty", "budget.json", "--json"});
        VERIFY_CODE(run, 0);
        const double u = run.json().value("uncertainty").toObject().value("U").toDouble();
        QVERIFY(std::abs(u - 0.0021191) < 1e-7);
    }

    void excludedValuesAreSaidWithBothVersions()
    {
        const Sandbox box;
        const QStringList words{"judge", publicFile("ess_mcu1025.csv"), "--exclude",
            "down:1:1,down:2:1", "--tolerance", "A=100um"};
        const ProgramRun run = box.run(words);
        VERIFY_CODE(run, 0);
        QVERIFY2(run.out.contains("2 values excluded, not an evaluation by ISO 230-2"),
            run.out.constData());
        QVERIFY(run.out.contains("89.265"));
        QVERIFY(run.out.contains("204.759"));
        QVERIFY2(run.err.contains("warning: 2 values excluded"), run.err.constData());
        QVERIFY2(run.err.contains("warning: of all values accuracy A is 204.759 um"),
            run.err.constData());
        QVERIFY2(run.out.contains("Verdict of all values"), run.out.constData());
        const QJsonObject json = box.run(words + QStringList{"--json"}).json();
        const auto verdict = json.value("verdictOfAllValues").toArray().at(0).toObject();
        QCOMPARE(verdict.value("result").toString(), "failed");
    }

    void filesThatSayDifferentThingsAreJoinedWithAWarning()
    {
        const Sandbox box;
        const auto file = [&box](const QString& name, const QByteArray& machine,
                              const QByteArray& celsius, const QByteArray& last) {
            return box.file(name,
                "// machine: " + machine + "\n// material temperature: " + celsius
                    + "\n// corrected: none\n// compensation: off\n"
                      "target [mm],direction,deviation [um]\n0,+,0.1\n10,+,0.2\n20,+,"
                    + last + "\n0,-,0.3\n10,-,0.1\n20,-,0.2\n");
        };
        const QStringList files{
            file("j1.csv", "M1", "20.5", "0.4"), file("j2.csv", "M2", "24.5", "0.5")};
        const QByteArray said = "the files are of different machines: M1 (file 1), M2 (file 2)";
        const QList<QStringList> commands{{"judge"}, {"runs"}, {"fit", "--lookup-at", "encoder"}};
        for (const QStringList& command : commands) {
            const ProgramRun run = box.run(command + files + QStringList{"--json"});
            VERIFY_CODE(run, 0);
            const auto warnings = run.json().value("warnings").toArray();
            QVERIFY2(std::ranges::any_of(warnings,
                         [&said](const QJsonValue& warning) {
                             return warning["code"].toString() == "OtherMachine"
                                 && warning["message"].toString().toUtf8() == said;
                         }),
                run.out.constData());
        }
        const ProgramRun runs = box.run(QStringList{"runs"} + files);
        QVERIFY2(runs.err.contains("warning: " + said), runs.err.constData());
        const ProgramRun judged = box.run(QStringList{"judge"} + files);
        QVERIFY2(judged.err.contains("warning: " + said), judged.err.constData());
        const QString conditions = QString::fromUtf8(judged.out).simplified();
        QVERIFY2(conditions.contains(" met the file states the temperature")
                && !conditions.contains("not met the file states the temperature"),
            judged.out.constData());
        const ProgramRun corrected =
            box.run(QStringList{"judge"} + files + QStringList{"--expansion", "11.5e-6"});
        VERIFY_CODE(corrected, 2);
        QVERIFY2(corrected.err.contains("the files do not agree on the temperature of the scale "
                                        "(20.5 C in file 1, 24.5 C in file 2): give --temperature"),
            corrected.err.constData());
    }

    void targetsWriteAPlanOrAProgram()
    {
        const Sandbox box;
        const QStringList ends{"targets", "--from", "-20", "--to", "60", "--count", "5", "--seed",
            "42", "--cycles", "1"};
        const ProgramRun plan = box.run(ends);
        VERIFY_CODE(plan, 0);
        QVERIFY2(plan.out.startsWith("// axiscomp plan: 1\n"), plan.out.constData());
        QVERIFY2(plan.out.contains("\n2,1,+,-5.945,-20.000\n3,1,+,17.834,-5.945\n"),
            plan.out.constData());
        const ProgramRun written = box.run(ends + QStringList{"-o", "plan.csv"});
        VERIFY_CODE(written, 0);
        QCOMPARE(box.content("plan.csv"), plan.out);
        QCOMPARE(written.out,
            "Wrote plan.csv: 5 targets, 10 positions. Axis X moves from -20.800 to 60.800 mm: "
            "check "
            "that this is within its travel, and free.\n");
        const ProgramRun program = box.run(ends
            + QStringList{
                "--dialect", "siemens", "--axis", "Y1", "--dwell", "3", "-o", "p.mpf", "--json"});
        VERIFY_CODE(program, 0);
        QVERIFY(box.content("p.mpf").contains("G1 Y1=-5.945 F1000\nG4 F3\n"));
        QCOMPARE(program.json().keys(),
            (QStringList{"axis", "cycles", "dwell", "feed", "format", "output", "overrun", "seed",
                "steps", "targets", "unit"}));
        QCOMPARE(program.json().value("targets").toArray().at(1).toDouble(), -5.945);
        QCOMPARE(program.json().value("format").toString(), "siemens");
    }

    void targetsThatCannotBeAreRefused()
    {
        const Sandbox box;
        const auto said = [&box](const QStringList& rest) {
            const ProgramRun run = box.run(QStringList{"targets", "--from", "0"} + rest);
            return run.code == 2 ? run.err : "code " + QByteArray::number(run.code) + run.err;
        };
        QVERIFY(said({"--to", "-5", "--count", "5"}).contains("exchange the two"));
        QVERIFY(said({"--to", "5"}).contains("one of the two"));
        const QByteArray name = said({"--to", "5", "--count", "5", "-o", "x.NGC"});
        QVERIFY2(name.contains("a program for a control needs --dialect"), name.constData());
        const QByteArray axis =
            said({"--to", "5", "--count", "5", "--dialect", "fanuc", "--axis", "Spindle"});
        QVERIFY2(axis.contains("cannot move an axis \"Spindle\""), axis.constData());
        QVERIFY(
            said({"--to", "5", "--count", "5", "--dialect", "heidenhain"}).contains("linuxcnc"));
    }

    void aBadFileIsReportedAsCompilersDo()
    {
        const Sandbox box;
        box.file("bad.csv", "target [mm],direction,run,deviation [um]\n0,+,1,1\n1,x,1,1\n");
        const ProgramRun run = box.run({"judge", "bad.csv"});
        VERIFY_CODE(run, 3);
        QVERIFY2(run.err.contains("bad.csv:3:2: error: "), run.err.constData());
        QVERIFY2(run.err.contains("error: InvalidMeasurement: "), run.err.constData());
        box.file("units.csv", "target,direction,deviation\n0,+,1\n1,+,1\n");
        VERIFY_CODE(box.run({"judge", "units.csv"}), 2);
        VERIFY_CODE(box.run({"judge", "units.csv", "--unit", "mm", "--value-unit", "um"}), 0);
        box.file("nothing.csv", "a,b\n1,2\n");
        const ProgramRun unknown = box.run({"runs", "nothing.csv"});
        VERIFY_CODE(unknown, 2);
        QVERIFY2(unknown.err.contains("UnknownFormat"), unknown.err.constData());
    }

    void whatTurnsValuesIsSaidWithTheFigures()
    {
        const Sandbox box;
        box.file("a.csv", small);
        box.file("b.csv", "// machine: M2\n" + small);
        const QByteArray said = "Correction: up and down exchanged\n";
        for (const char* command : {"judge", "runs"}) {
            const ProgramRun run = box.run({command, "a.csv", "--swap-directions"});
            VERIFY_CODE(run, 0);
            QVERIFY2(run.out.contains(said), run.out.constData());
            const ProgramRun json = box.run({command, "a.csv", "--swap-directions", "--json"});
            VERIFY_CODE(json, 0);
            QCOMPARE(
                json.json().value("corrections").toObject().keys(), QStringList{"swapDirections"});
            const ProgramRun plain = box.run({command, "a.csv"});
            QVERIFY2(!plain.out.contains("Correction:"), plain.out.constData());
        }
        const ProgramRun unit = box.run({"judge", "a.csv", "--value-unit", "nm"});
        VERIFY_CODE(unit, 0);
        QVERIFY2(unit.out.contains("Correction: unit of deviation taken as nm, the file says um\n"),
            unit.out.constData());
        const ProgramRun both = box.run({"compare", "a.csv", "b.csv", "--swap-directions"});
        VERIFY_CODE(both, 0);
        QCOMPARE(both.out.count(said), 2);
        const ProgramRun fitted = box.run({"fit", "a.csv", "--swap-directions", "--measured-with",
            "off", "--lookup-at", "encoder", "--record", "a.axcal"});
        VERIFY_CODE(fitted, 0);
        QVERIFY2(fitted.out.contains(said), fitted.out.constData());
        VERIFY_CODE(box.run({"report", "a.axcal", "-o", "a.html"}), 0);
        QVERIFY(box.content("a.html").contains("up and down exchanged"));
        const ProgramRun compared =
            box.run({"compare", "b.csv", "--record", "a.axcal", "--measured-with", "on", "--json"});
        QCOMPARE(compared.json().value("correctionsBefore").toObject().keys(),
            QStringList{"swapDirections"});
        QVERIFY(compared.json().value("corrections").toObject().isEmpty());
    }

    void filesAreJoinedAndWritten()
    {
        const Sandbox box;
        box.file("a.csv", small);
        box.file("b.csv", "// machine: M2\n" + small);
        const ProgramRun written =
            box.run({"runs", "a.csv", "b.csv", "--swap-directions", "-o", "both.csv"});
        VERIFY_CODE(written, 0);
        QCOMPARE(written.out, "Wrote both.csv.\n");
        const ProgramRun read = box.run({"runs", "both.csv", "--json"});
        VERIFY_CODE(read, 0);
        const QJsonObject json = read.json();
        QCOMPARE(json.value("kind").toString(), "runs");
        QCOMPARE(json.value("runs").toObject().value("up").toInt(), 2);
        QCOMPARE(json.value("values").toInt(), 8);
        QVERIFY(box.content("both.csv").contains("10,+,2,0.003\n"));
        const ProgramRun twice = box.run({"judge", "a.csv", "b.csv", "a.csv"});
        VERIFY_CODE(twice, 2);
        QVERIFY2(twice.err.contains("file 3 holds the same measurement as file 1"),
            twice.err.constData());
        const ProgramRun piped = box.run({"runs", "-", "-o", "-"}, small);
        VERIFY_CODE(piped, 0);
        QVERIFY2(piped.out.startsWith("// axiscomp runs: 1\n"), piped.out.constData());
    }

    void aStateOfSomeFilesIsNotWrittenForAll()
    {
        const Sandbox box;
        box.file("a.csv", small);
        box.file("b.csv", "// compensation: off\n" + small);
        VERIFY_CODE(box.run({"judge", "a.csv", "b.csv"}), 0);
        const ProgramRun refused = box.run({"runs", "a.csv", "b.csv", "-o", "both.csv"});
        VERIFY_CODE(refused, 2);
        QVERIFY2(refused.err.contains("// compensation: off"), refused.err.constData());
        const ProgramRun fit =
            box.run({"fit", "a.csv", "b.csv", "--lookup-at", "encoder", "--measured-with", "on"});
        VERIFY_CODE(fit, 2);
        QVERIFY2(fit.err.contains("made with the compensation off"), fit.err.constData());
        VERIFY_CODE(
            box.run({"fit", "a.csv", "b.csv", "--lookup-at", "encoder", "--measured-with", "off"}),
            0);
    }

    void aTrackIsShownAndNotJudged()
    {
        const Sandbox box;
        QByteArray text = "encoder [mm],reference [mm]\n";
        for (int i = 0; i < 30; ++i)
            text += QByteArray::number(i) + "," + QByteArray::number(i) + ".001\n";
        box.file("track.csv", text);
        const ProgramRun shown = box.run({"runs", "track.csv"});
        VERIFY_CODE(shown, 0);
        QVERIFY2(shown.out.contains("a track without targets: 29 samples over 28 mm"),
            shown.out.constData());
        const ProgramRun judged = box.run({"judge", "track.csv"});
        VERIFY_CODE(judged, 3);
        QVERIFY2(judged.err.contains("NoTargets"), judged.err.constData());
    }

    void whatIsSaidOfTheReferenceAsksForACorrection_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::newRow("reference")
            << QStringList{"--reference-temperature", "25", "--reference-expansion", "11.5e-6"};
        QTest::newRow("datum") << QStringList{"--datum", "200"};
    }
    void whatIsSaidOfTheReferenceAsksForACorrection()
    {
        QFETCH(const QStringList, options);
        const Sandbox box;
        const ProgramRun run =
            box.run(QStringList{"judge", publicFile("bifrost.csv"), "--not-corrected"} + options);
        VERIFY_CODE(run, 2);
        QVERIFY2(run.err.contains("give --temperature"), run.err.constData());
    }

    void aCorrectionIsMadeOnlyWhenItIsClear()
    {
        const Sandbox box;
        const QString file = publicFile("bifrost.csv");
        VERIFY_CODE(box.run({"judge", file, "--temperature", "22"}), 2);
        const ProgramRun open =
            box.run({"judge", file, "--temperature", "22", "--expansion", "11.5e-6"});
        VERIFY_CODE(open, 2);
        QVERIFY2(open.err.contains("(--not-corrected)"), open.err.constData());
        const ProgramRun datum = box.run({"judge", file, "--temperature", "22", "--expansion",
            "11.5e-6", "--not-corrected", "--datum", "nan"});
        VERIFY_CODE(datum, 2);
        QVERIFY2(datum.err.contains("--datum: nan is no number"), datum.err.constData());
        const ProgramRun run = box.run({"judge", file, "--temperature", "22", "--expansion",
            "11.5e-6", "--not-corrected", "--json"});
        VERIFY_CODE(run, 0);
        // A scale 2 K too warm over 40.8 mm makes 0.94 um of slope.
        const double e = run.json().value("axis").toObject().value("EUp").toDouble();
        QVERIFY2(std::abs(e - 0.0148174) < 1e-6, QByteArray::number(e, 'g', 10).constData());
        QCOMPARE(run.json().value("corrections").toObject().keys(), QStringList{"temperature"});
    }

    /// All runs up are 1 K warmer than the zero setting, all runs down are not: by Python the dead
    /// path of 1000 mm adds 0.955028 um to every B_i.
    void aDeadPathIsCorrectedByTheAirOfEachRun()
    {
        const Sandbox box;
        const QString file = publicFile("bifrost.csv");
        const QByteArray air = R"({"pressure": 101.325, "temperature": 20, "humidity": 50})";
        const QByteArray warm = R"({"pressure": 101.325, "temperature": 21, "humidity": 50})";
        QByteArray runs;
        for (int run = 1; run <= 5; ++run)
            runs += (run > 1 ? "," : "") + QByteArray(R"({"direction": "up", "run": )")
                + QByteArray::number(run) + R"(, "air": )" + warm
                + R"(}, {"direction": "down", "run": )" + QByteArray::number(run) + R"(, "air": )"
                + air + "}";
        const QByteArray begin = R"({"length": 1000, "atZero": )" + air + R"(, "runs": [)";
        const QString whole = box.file("air.json", begin + runs + "]}");
        const ProgramRun run = box.run({"judge", file, "--dead-path", whole, "--json"});
        VERIFY_CODE(run, 0);
        const QJsonObject axis = run.json().value("axis").toObject();
        QVERIFY(std::abs(axis.value("B").toDouble() - 0.005519027622650263) < 1e-9);
        QVERIFY(std::abs(axis.value("Bmean").toDouble() - 0.0016506276226514066) < 1e-9);
        const QJsonObject made =
            run.json().value("corrections").toObject().value("deadPath").toObject();
        QCOMPARE(made.value("length").toDouble(), 1000.0);
        QVERIFY(std::abs(made.value("largest").toDouble() - 0.0009550276226510945) < 1e-12);
        const ProgramRun told = box.run({"judge", file, "--dead-path", whole});
        QVERIFY2(told.out.contains(
                     "Correction: dead path of 1000 mm: values changed by up to 0.96 um\n"),
            told.out.constData());
        const QString record = box.path("x.axcal");
        const ProgramRun fitted = box.run({"fit", file, "--dead-path", whole, "--measured-with",
            "off", "--lookup-at", "encoder", "--record", record});
        VERIFY_CODE(fitted, 0);
        QVERIFY2(fitted.out.contains(
                     "Correction: dead path of 1000 mm: values changed by up to 0.96 um\n"),
            fitted.out.constData());
        const QJsonObject kept = QJsonDocument::fromJson(box.content("x.axcal")).object();
        QCOMPARE(kept.value("before").toObject().value("corrections").toObject().keys(),
            QStringList{"deadPath"});
        VERIFY_CODE(
            box.run({"report", record, "--language", "de", "-o", box.path("report.html")}), 0);
        QVERIFY(box.content("report.html")
                    .contains("Totstrecke von 1000 mm: Werte um bis zu 0,96 µm geändert"));

        const QString few = box.file("few.json", begin + "]}");
        const ProgramRun unknown = box.run({"judge", file, "--dead-path", few});
        VERIFY_CODE(unknown, 2);
        QVERIFY2(unknown.err.contains("the air of run 1 up is not known"), unknown.err.constData());
        const ProgramRun wrong =
            box.run({"judge", file, "--dead-path", box.file("wrong.json", R"({"length": 3})")});
        VERIFY_CODE(wrong, 2);
        QVERIFY2(wrong.err.contains("wrong.json does not describe a dead path: "),
            wrong.err.constData());
    }

    void thePageOfTheFormatsIsUpToDate()
    {
        const Sandbox box;
        const ProgramRun run = box.run({"formats", "--measurements", "--markdown"});
        VERIFY_CODE(run, 0);
        QFile page(QStringLiteral(AXISCOMP_SOURCE_FOLDER "/docs/measurement-formats.md"));
        QVERIFY(page.open(QIODevice::ReadOnly));
        QVERIFY2(page.readAll() == run.out,
            "axiscomp formats --measurements --markdown > docs/measurement-formats.md");
        const ProgramRun one = box.run({"formats", "renishaw", "--measurements"});
        VERIFY_CODE(one, 0);
        QVERIFY2(one.out.contains("milliradians"), one.out.constData());
    }

    void completionKnowsTheMeasurementFormats()
    {
        const Sandbox box;
        const ProgramRun completed = box.runProgram(QStringLiteral("/bin/bash"),
            {"-c",
                "source '" AXISCOMP_SOURCE_FOLDER "/packaging/completion/axiscomp.bash'; "
                "echo $_axiscomp_measurements"});
        QStringList names;
        for (const QJsonValue& format :
            box.run({"formats", "--measurements", "--json"}).json().value("formats").toArray())
            names += format.toObject().value("name").toString();
        QCOMPARE(QString::fromUtf8(completed.out).simplified().split(' '), names);
    }
};

AXISCOMP_TEST(tst_MeasurementCommands)

} // namespace tst_measurementcommands

#include "tst_measurementcommands.moc"
