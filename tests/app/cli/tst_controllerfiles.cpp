// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program_run.h"

#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>

namespace tst_controllerfiles {

using namespace axiscomp;
using test::ProgramRun;
using test::Sandbox;

namespace {

/// A linear error of 0.1 um per mm: what the command must be moved by is known in closed form.
const QByteArray linearError = "X [mm],Table 1 [mm]\n0,0\n100,0.01\n200,0.02\n";
const QByteArray unevenError = "X [mm],Table 1 [um]\n0,0\n1,0.5\n2.5,1.5\n10,-1\n";
const QByteArray softmcTable = "1 3\n0 0\n100 -0.01\n200 -0.02\n";
const QString encoderOfX = QStringLiteral("Axes[0]/Signals/PositionController/MasterPosition");
const QStringList unitsIn{"--set-in", "position-unit=mm", "--set-in", "value-unit=mm"};

double firstValue(const ProgramRun& run)
{
    return run.json().value("results").toArray().at(0).toObject().value("value").toDouble();
}

} // namespace

class tst_ControllerFiles : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theSignIsConvertedExactly()
    {
        const Sandbox box;
        box.file("x.csv", linearError);
        const ProgramRun run = box.run(
            {"convert", "x.csv", "x.txt", "--dims", "1", "--to", "softmc", "--target", "X"});
        VERIFY_CODE(run, 0);
        // c = -e / (1 + slope): 100 mm - 0.01 / 1.0001
        const QList<QByteArray> lines = box.content("x.txt").split('\n');
        QCOMPARE(lines.at(0), QByteArray("1 3"));
        QCOMPARE(lines.at(2).split(' ').at(0), QByteArray("100"));
        const double offset = lines.at(2).split(' ').at(1).toDouble();
        QVERIFY2(std::abs(offset + 0.01 / 1.0001) < 1e-9, lines.at(2).constData());
        QVERIFY2(run.out.contains("sign: csv holds feedback values, softmc holds command values"),
            run.out.constData());
        QVERIFY2(run.out.contains("where the encoder reads"), run.out.constData());
        QVERIFY2(run.out.contains("they differ by at most"), run.out.constData());
    }

    void whatAConversionToStandardOutputDidIsSaidBesideIt()
    {
        const Sandbox box;
        box.file("x.csv", "// target: X\nX,EX\n0,1\n10000,2\n20000,3\n");
        const ProgramRun run = box.run({"convert", "x.csv", "-", "--dims", "1", "--to",
            "siemens-eec", "--target", "X", "--distance", "15000"});
        VERIFY_CODE(run, 0);
        QVERIFY2(run.err.contains("no unit"), run.err.constData());
        QVERIFY2(run.err.contains("15000"), run.err.constData());
        QVERIFY2(!run.out.contains("no unit"), run.out.constData());
    }

    void theSignCanBeOverruled()
    {
        const Sandbox box;
        box.file("x.txt", softmcTable);
        const ProgramRun run =
            box.run(QStringList{"convert", "x.txt", "x.csv", "--sign", "feedback"} + unitsIn);
        VERIFY_CODE(run, 0);
        QVERIFY2(box.content("x.csv").contains("100,-0.01"), box.content("x.csv").constData());
        QVERIFY2(run.out.contains("as you say"), run.out.constData());
    }

    void aFormatWithOneMoreColumnIsComparedByTheOrder()
    {
        // Aerotech's 2D tables hold a pair of corrections; the second one is 0 here.
        const Sandbox box;
        box.file("p.csv", "1 [mm],2 [mm],T [mm]\n0,0,0\n10,0,0.001\n0,10,-0.002\n10,10,0.003\n");
        const ProgramRun run = box.run({"convert", "p.csv", "p.cal", "--dims", "2", "--to",
            "aerotech-2d", "--set-out", "output-axis-1=1", "--target", "1"});
        VERIFY_CODE(run, 0);
        QVERIFY2(run.out.contains("compared at"), run.out.constData());
    }

    void profilesOfWhichOneCountsAreNotWrittenWhereTheyAreAdded()
    {
        const Sandbox box;
        const QByteArray mesh =
            "version = 1\npoints =\n  0.1, 0.2\n  0.3, 0.4\nx_count = 2\ny_count = 2\n"
            "min_x = 0\nmax_x = 100\nmin_y = 0\nmax_y = 100\n";
        box.file("mesh.cfg", "[bed_mesh default]\n" + mesh + "[bed_mesh hot]\n" + mesh);
        const QStringList words{"convert", "mesh.cfg", "mesh.cal", "--to", "aerotech-2d",
            "--set-out", "column-axis=1", "--set-out", "row-axis=2", "--set-out",
            "output-axis-1=3"};
        const ProgramRun refused = box.run(words);
        VERIFY_CODE(refused, 2);
        QVERIFY2(refused.err.contains("there are two tables for axis 3, and the controller adds "
                                      "their corrections; choose one of them"),
            refused.err.constData());
        QVERIFY(!QFile::exists(box.path("mesh.cal")));
        VERIFY_CODE(box.run(words + QStringList{"--table", "hot"}), 0);
        QVERIFY2(
            box.content("mesh.cal").count(":START2D") == 3, box.content("mesh.cal").constData());
    }

    void aDoubtfulFileIsRefusedUntilSomebodySaysWhatItIs_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("from");
        // Two columns without a header may be an iCube file: position and offset, of the other
        // sign.
        QTest::newRow("numbers in a .csv")
            << "x.csv" << QByteArray("0,0\n100,0.01\n200,0.02\n") << "icube";
        QTest::newRow("numbers in a .txt")
            << "x.txt" << QByteArray("0,0\n100,0.01\n200,0.02\n") << "icube";
    }
    void aDoubtfulFileIsRefusedUntilSomebodySaysWhatItIs()
    {
        QFETCH(const QString, name);
        QFETCH(const QByteArray, content);
        QFETCH(const QString, from);
        const Sandbox box;
        box.file(name, content);
        for (const QStringList& command : {QStringList{"inspect", name},
                 QStringList{"convert", name, "y.csv"}, QStringList{"lookup", name, "50"}}) {
            const ProgramRun run = box.run(command);
            VERIFY_CODE(run, 2);
            QVERIFY2(run.err.contains("FormatAmbiguous") && run.err.contains(from.toUtf8()),
                run.err.constData());
        }
        QVERIFY(!QFile::exists(box.path("y.csv")));
        const ProgramRun said = box.run({"inspect", name, "--from", from});
        VERIFY_CODE(said, 0);
    }

    void standardInputIsKnownByItsContent()
    {
        const Sandbox box;
        const QByteArray program =
            "$AA_ENC_COMP[0,0,X1]=0.003\n$AA_ENC_COMP[0,1,X1]=0.01\n$AA_ENC_COMP_STEP[0,X1]=10\n"
            "$AA_ENC_COMP_MIN[0,X1]=0\n$AA_ENC_COMP_MAX[0,X1]=10\n$AA_ENC_COMP_IS_MODULO[0,X1]=0\n"
            "M17\n";
        for (const QStringList& command :
            {QStringList{"inspect", "-"}, QStringList{"inspect", "-", "--dims", "1"},
                QStringList{"convert", "-", "x.csv"}, QStringList{"lookup", "-", "5"}}) {
            const ProgramRun run = box.run(command, program);
            VERIFY_CODE(run, 0);
            QVERIFY2(run.err.contains("<stdin>: read as siemens-eec"), run.err.constData());
        }
        QCOMPARE(box.run({"lookup", "-", "50", "--dims", "1"}, linearError).out.trimmed(),
            QByteArray("0.005"));
        // What content leaves open is a calibration file, unless somebody says it.
        for (const QByteArray& open : {linearError, QByteArray("0,0\n100,0.01\n200,0.02\n")}) {
            const ProgramRun run = box.run({"inspect", "-"}, open);
            VERIFY_CODE(run, 2);
            QVERIFY2(run.err.contains("give --dims 1, 2 or 3")
                    && run.err.contains("it could be icube as well: say it with --from"),
                run.err.constData());
        }
        const ProgramRun unknown = box.run({"inspect", "-"}, "nothing\n");
        VERIFY_CODE(unknown, 2);
        QVERIFY2(unknown.err.contains("say it with --from if it is no calibration file"),
            unknown.err.constData());
    }

    /// There is no file called "-", and no number of dimensions would help.
    void utf16IsSaidOfStandardInputAsOfAFile()
    {
        const Sandbox box;
        QByteArray text = "\xFF\xFE";
        for (const char c : linearError)
            text += QByteArray(1, c) + '\0';
        box.file("x.csv", text);
        for (const QByteArray& utf16 : {text, text.mid(2)})
            for (const QStringList& command :
                {QStringList{"inspect", "-"}, QStringList{"lookup", "-", "50"},
                    QStringList{"lookup", "-", "50", "--dims", "1"}}) {
                const ProgramRun run = box.run(command, utf16);
                VERIFY_CODE(run, 3);
                QVERIFY2(run.err.contains("<stdin>: error: this is not a text file: found UTF-16 "
                                          "text"),
                    run.err.constData());
            }
        const ProgramRun file = box.run({"lookup", "x.csv", "50"});
        VERIFY_CODE(file, 3);
        QVERIFY2(file.err.contains("x.csv: error: this is not a text file: found UTF-16 text"),
            file.err.constData());
    }

    void aFileOfAnotherControllerIsInspected()
    {
        const Sandbox box;
        box.file("x.txt", softmcTable);
        const ProgramRun run = box.run(QStringList{"inspect", "x.txt", "--json"} + unitsIn);
        VERIFY_CODE(run, 0);
        const QJsonObject document = run.json();
        QCOMPARE(document.value("format").toString(), "softmc");
        const QJsonObject table = document.value("tables").toArray().at(0).toObject();
        QCOMPARE(table.value("sign").toString(), "command");
        QCOMPARE(table.value("signEvidence").toString(), "published");
        QCOMPARE(table.value("axes").toArray().at(0).toObject().value("unit").toString(), "mm");
        QCOMPARE(table.value("columns").toArray().at(0).toObject().value("min").toDouble(), -0.02);
    }

    void aProblemOfSuchAFileNamesItsPlace()
    {
        const Sandbox box;
        box.file("x.txt", "1 3\n0 0\n100 -0.01\n200 x\n");
        const ProgramRun run = box.run({"inspect", "x.txt", "--from", "softmc"});
        VERIFY_CODE(run, 3);
        QVERIFY2(run.err.contains("x.txt:4:5: error: "), run.err.constData());
    }

    void lookupAnswersAsTheControllerDoes()
    {
        const Sandbox box;
        box.file("x.txt", "1 3\n10 1\n20 2\n30 3\n");
        const auto at = [&](const char* position) {
            const ProgramRun run =
                box.run(QStringList{"lookup", "x.txt", position, "--json"} + unitsIn);
            return run.code == 0 ? firstValue(run) : std::nan("");
        };
        QCOMPARE(at("15"), 1.5);
        QCOMPARE(at("40"), 3.0); // held
        QCOMPARE(at("9.9"), 0.0); // softMC has not begun yet
    }

    void lookupSaysThatItsValueIsOneOfCommands()
    {
        const Sandbox box;
        box.file("x.txt", "1 3\n10 1\n20 2\n30 3\n");
        const QStringList arguments = QStringList{"lookup", "x.txt", "20"} + unitsIn;
        const ProgramRun own = box.run(arguments);
        VERIFY_CODE(own, 0);
        QCOMPARE(own.out, QByteArray("2\n"));
        QVERIFY2(own.err.contains("--as csv"), own.err.constData());
        const ProgramRun drive = box.run(arguments + QStringList{"--as", "csv", "--target", "#1"});
        VERIFY_CODE(drive, 0);
        QVERIFY2(drive.out.startsWith("-"), drive.out.constData());
        QVERIFY2(!drive.err.contains("--as csv"), drive.err.constData());
    }

    /// Both outputs correct a source, so that each moves the place where the other is looked up.
    void oneTableOfAFileHasTheNumbersOfTheWholeFile()
    {
        const Sandbox box;
        box.file("g.cal",
            ":START2D 2 1 1 2 100 100 3\n:START2D POSUNIT=METRIC CORUNIT=METRIC/1000\n"
            "0 0  100 -50  200 40\n300 10 -400 600 100 0\n0 500 200 -300 100 100\n:END\n");
        VERIFY_CODE(box.run({"convert", "g.cal", "all.csv"}), 0);
        const auto at100 = [&](const QString& file, const QStringList& options) {
            const ProgramRun run = box.run(QStringList{"lookup", file, "100", "100"} + options);
            return run.code == 0 ? run.out.toDouble() : std::nan("");
        };
        for (const char* number : {"#1", "#2"}) {
            const QStringList table{"--table", number};
            const double expected = at100("all.csv", QStringList{"--dims", "2"} + table);
            VERIFY_CODE(box.run(QStringList{"convert", "g.cal", "one.csv"} + table), 0);
            const QStringList as = table + QStringList{"--as", "csv"};
            QVERIFY(std::abs(at100("one.csv", {"--dims", "2"}) - expected) < 1e-6);
            QVERIFY(std::abs(at100("g.cal", as) - expected) < 1e-6);
        }
    }

    /// The file has finer numbers than one that is written of it, and no setting for writing
    /// counts.
    void lookupOfWhatIsStatedAnswersWhatTheFileSays()
    {
        const Sandbox box;
        box.file("x.lis",
            "kopf.achs_nr 1\nkw.ssfk.unit 1\nkw.ssfk.interval 100000\nkw.ssfk.kw_startpos 0\n"
            "kw.ssfk.kw_nr_max 2\nkw.ssfk.bilateral 1\nkw.ssfk.modulo 0\n"
            "kw.ssfk.table[0].pos 0\nkw.ssfk.table[0].neg 0.45\n"
            "kw.ssfk.table[1].pos 0.4\nkw.ssfk.table[1].neg 1.45\nEnd\n");
        const QStringList ofLis{"lookup", "x.lis", "10", "--set-in", "axis-kind=linear"};
        const auto isAlong = [&](const char* direction, double expected) {
            const ProgramRun run = box.run(ofLis + QStringList{"--direction", direction});
            return run.code == 0 && std::abs(run.out.toDouble() - expected) < 1e-10;
        };
        QVERIFY(isAlong("positive", 4e-5));
        QVERIFY(isAlong("negative", 14.5e-5));
        QVERIFY(isAlong("mean", 9.25e-5));
        const QStringList positive = ofLis + QStringList{"--direction", "positive"};
        const ProgramRun setOut = box.run(positive + QStringList{"--set-out", "unit=mm"});
        VERIFY_CODE(setOut, 2);
        QVERIFY2(setOut.err.contains("--as"), setOut.err.constData());

        box.file("x.txt", softmcTable);
        const ProgramRun stated = box.run(
            QStringList{"lookup", "x.txt", "100", "--sign", "feedback", "--json"} + unitsIn);
        VERIFY_CODE(stated, 0);
        QCOMPARE(firstValue(stated), -0.01);
        QCOMPARE(stated.json().value("sign").toString(), "feedback");
    }

    void lookupAsAnotherControllerConvertsFirst()
    {
        const Sandbox box;
        box.file("x.csv", linearError);
        const ProgramRun run = box.run(
            {"lookup", "x.csv", "100", "--dims", "1", "--as", "softmc", "--target", "X", "--json"});
        VERIFY_CODE(run, 0);
        QVERIFY(std::abs(firstValue(run) + 0.01 / 1.0001) < 1e-9);
        const ProgramRun before = box.run(
            {"lookup", "x.csv", "-1", "--dims", "1", "--as", "softmc", "--target", "X", "--json"});
        QCOMPARE(firstValue(before), 0.0);
    }

    void unevenPositionsAreResampledWithinADeviation()
    {
        const Sandbox box;
        box.file("uneven.csv", unevenError);
        const ProgramRun refused = box.run({"convert", "uneven.csv", "even.TAMtbl", "--dims", "1"});
        VERIFY_CODE(refused, 3);
        QVERIFY2(refused.err.contains("UnevenSpacing"), refused.err.constData());
        const ProgramRun run = box.run(
            {"convert", "uneven.csv", "even.csv", "--dims", "1", "--within", "0.05", "--json"});
        VERIFY_CODE(run, 0);
        const QJsonObject table = run.json().value("tables").toArray().at(0).toObject();
        QVERIFY(table.value("points").toInt() > 4);
        const QJsonArray report = run.json().value("report").toArray();
        bool hasDeviation = false;
        for (const QJsonValue& line : report)
            hasDeviation = hasDeviation || line.toString().contains("rms");
        QVERIFY2(hasDeviation, run.out.constData());
        VERIFY_CODE(box.run({"inspect", "even.csv", "--dims", "1"}), 0);
    }

    void whatWasFilledIsSaidWhileThePointsStay()
    {
        const Sandbox box;
        box.file("gaps.csv", "X [mm],a [um],b [um]\n0,1,1\n10,,2\n20,3,\n30,4,4\n");
        const auto filledWith = [&](const QStringList& options) {
            const ProgramRun run = box.run(
                QStringList{"convert", "gaps.csv", "o.csv", "--dims", "1", "--fill", "nearest"}
                + options + QStringList{"--json"});
            QJsonArray filled;
            for (const QJsonValue& column :
                run.json().value("tables").toArray().at(0).toObject().value("columns").toArray())
                filled.append(column.toObject().value("filled"));
            return QJsonDocument(filled).toJson(QJsonDocument::Compact);
        };
        QCOMPARE(filledWith({"--scale", "2"}), QByteArray("[[[1]],[[2]]]"));
        QCOMPARE(filledWith({"--points", "7"}), QByteArray("[[],[]]"));
    }

    void anOptionThatDoesNothingToAFileIsRefusedOrSaid()
    {
        const Sandbox box;
        box.file("x.mpf",
            "$AA_ENC_COMP[0,0,X1]=0\n$AA_ENC_COMP[0,1,X1]=0.001\n$AA_ENC_COMP_STEP[0,X1]=10\n"
            "$AA_ENC_COMP_MIN[0,X1]=0\n$AA_ENC_COMP_MAX[0,X1]=10\nM17\n");
        box.file("grid.csv", "X [mm],a [um]\n0,1\n10,2\n20,3\n");
        const auto run = [&](const char* file, const QStringList& options) {
            return box.run(QStringList{"inspect", file} + options);
        };
        const ProgramRun snapped = run("x.mpf", {"--snap", "0.001"});
        VERIFY_CODE(snapped, 2);
        QVERIFY2(snapped.err.contains("InvalidArgument: --snap takes positions of a calibration "
                                      "file for those of a grid, and x.mpf is read as siemens-eec"),
            snapped.err.constData());
        const ProgramRun filled = run("x.mpf", {"--fill", "nearest"});
        VERIFY_CODE(filled, 0);
        QVERIFY2(filled.err.contains("warning: x.mpf: --fill does nothing: a file of the format "
                                     "siemens-eec has a value for each point\n"),
            filled.err.constData());
        const ProgramRun cropped = run("x.mpf", {"--crop"});
        VERIFY_CODE(cropped, 0);
        QVERIFY2(cropped.err.contains("--crop does nothing"), cropped.err.constData());
        for (const QStringList& options : {QStringList{"--snap", "0.001"},
                 QStringList{"--fill", "plane"}, QStringList{"--crop"}}) {
            const ProgramRun own = run("grid.csv", QStringList{"--dims", "1"} + options);
            VERIFY_CODE(own, 0);
            QVERIFY2(!own.err.contains("does nothing"), own.err.constData());
        }
    }

    void pointsAndDistancesAreAskedFor_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<int>("points");
        QTest::newRow("points") << QStringList{"--points", "21"} << 21;
        QTest::newRow("distance") << QStringList{"--distance", "0.5"} << 21;
        QTest::newRow("cubic") << QStringList{"--points", "11", "--method", "cubic"} << 11;
    }
    void pointsAndDistancesAreAskedFor()
    {
        QFETCH(const QStringList, options);
        QFETCH(int, points);
        const Sandbox box;
        box.file("uneven.csv", unevenError);
        const ProgramRun run = box.run(
            QStringList{"convert", "uneven.csv", "even.csv", "--dims", "1", "--json"} + options);
        VERIFY_CODE(run, 0);
        QCOMPARE(
            run.json().value("tables").toArray().at(0).toObject().value("points").toInt(), points);
    }

    void aDenserTableSaysWhatIsLeftOfTheCurve()
    {
        const Sandbox box;
        box.file("uneven.csv", unevenError);
        const QStringList words{"convert", "uneven.csv", "dense.csv", "--dims", "1", "--within",
            "0.001", "--method", "spline", "--speed", "100"};
        const ProgramRun run = box.run(words + QStringList{"--json"});
        VERIFY_CODE(run, 0);
        const QJsonObject table = run.json().value("tables").toArray().at(0).toObject();
        const QJsonObject density =
            table.value("density").toArray().at(0).toArray().at(0).toObject();
        QCOMPARE(density.keys(),
            (QStringList{
                "axis", "largestDistance", "largestSlopeChange", "points", "velocityStep"}));
        QCOMPARE(density.value("points").toInt(), table.value("points").toInt());
        QVERIFY(density.value("largestDistance").toDouble() <= 0.001);
        QCOMPARE(density.value("velocityStep").toDouble(),
            100.0 * density.value("largestSlopeChange").toDouble());
        const ProgramRun text = box.run(words);
        VERIFY_CODE(text, 0);
        QVERIFY2(text.out.contains("from the curve; at a point its slope changes by up to")
                && text.out.contains("which at 100 mm/s is a step of the velocity of"),
            text.out.constData());
    }

    void aMethodWithoutAGridIsRefused()
    {
        const Sandbox box;
        box.file("x.csv", "X,A\n0,1\n1,2\n2,1\n");
        for (const QStringList& options :
            {QStringList{"--method", "spline"}, QStringList{"--speed", "10"}}) {
            const ProgramRun run =
                box.run(QStringList{"convert", "x.csv", "y.csv", "--dims", "1"} + options);
            VERIFY_CODE(run, 2);
            QVERIFY(!QFile::exists(box.path("y.csv")));
        }
    }

    void aTextThatIsNoTableIsNotRecognised()
    {
        const Sandbox box;
        box.file("readme.txt", "Compensation of the left gantry\nsee the protocol of May\n");
        box.file("motion.prg", "program\nmove x 5\nend program\n");
        for (const char* const name : {"readme.txt", "motion.prg"}) {
            const ProgramRun run = box.run({"inspect", name});
            VERIFY_CODE(run, 2);
            QVERIFY2(run.err.contains("error: UnknownFormat: "), run.err.constData());
        }
        for (const QStringList& more : {QStringList{}, QStringList{"--dims", "1"}}) {
            const ProgramRun run = box.run(QStringList{"inspect", "no/such"} + more);
            VERIFY_CODE(run, 3);
            QVERIFY2(run.err.contains("error: FileNotReadable: "), run.err.constData());
        }
    }

    void whatAFormatCannotHoldIsRefusedWithTheWayOut()
    {
        const Sandbox box;
        box.file("x.csv", "X,A,B\n0,1,2\n1,2,3\n3,1,1\n");
        const ProgramRun run =
            box.run({"convert", "x.csv", "x.txt", "--dims", "1", "--table", "A", "--to", "softmc"});
        QVERIFY(run.code != 0);
        QVERIFY2(run.err.contains("resample"), run.err.constData());
        QVERIFY(!QFile::exists(box.path("x.txt")));
    }

    void aGridOfNothingIsRefusedByName_data()
    {
        QTest::addColumn<QStringList>("options");
        for (const char* const points : {"0", "1", "-3", "5,0"})
            QTest::newRow(points) << QStringList{"--points", points};
        for (const char* const distance : {"0", "-1", "0.0"})
            QTest::addRow("distance %s", distance) << QStringList{"--distance", distance};
    }
    void aGridOfNothingIsRefusedByName()
    {
        QFETCH(QStringList, options);
        const Sandbox box;
        box.file("x.csv", linearError);
        const ProgramRun run =
            box.run(QStringList{"convert", "x.csv", "y.csv", "--dims", "1"} + options);
        VERIFY_CODE(run, 2);
        QVERIFY2(run.err.contains(options.front().toUtf8()), run.err.constData());
        QVERIFY(!QFile::exists(box.path("y.csv")));
    }

    /// A unit that is stated and not heeded is a wrong number.
    void aStatedUnitComesBeforeThatOfTheFile()
    {
        const Sandbox box;
        box.file("x.csv", "X [mm],E [um]\n0,1\n10,2\n");
        const QStringList stated{
            "--dims", "1", "--set-in", "value-unit=nm", "--set-in", "position-unit=m"};
        const ProgramRun inspected = box.run(QStringList{"inspect", "x.csv", "--json"} + stated);
        VERIFY_CODE(inspected, 0);
        QCOMPARE(inspected.json()["tables"][0]["unit"].toString(), QStringLiteral("nm"));
        QCOMPARE(inspected.json()["axes"][0]["unit"].toString(), QStringLiteral("m"));
        VERIFY_CODE(box.run(QStringList{"convert", "x.csv", "y.csv"} + stated), 0);
        QVERIFY(box.content("y.csv").contains("X [m],E [nm]"));
        VERIFY_CODE(box.run({"convert", "x.csv", "x.TAMtbl", "--dims", "1"}), 0);
        const ProgramRun table =
            box.run({"inspect", "x.TAMtbl", "--json", "--set-in", "value-unit=um"});
        VERIFY_CODE(table, 0);
        QCOMPARE(table.json()["tables"][0]["unit"].toString(), QStringLiteral("um"));
    }

    void aSettingThatACalibrationFileDoesNotHaveIsRefused()
    {
        const Sandbox box;
        box.file("x.csv", linearError);
        for (const QStringList& command :
            {QStringList{"inspect", "x.csv"}, QStringList{"convert", "x.csv", "y.TAMtbl"},
                QStringList{"lookup", "x.csv", "5"}}) {
            const ProgramRun run =
                box.run(command + QStringList{"--dims", "1", "--set-in", "colour=um"});
            VERIFY_CODE(run, 2);
            QVERIFY2(run.err.contains("csv has no setting colour"), run.err.constData());
        }
    }

    void settingsAreCheckedByName()
    {
        const Sandbox box;
        box.file("x.csv", linearError);
        const ProgramRun run = box.run({"convert", "x.csv", "x.txt", "--dims", "1", "--to",
            "softmc", "--target", "X", "--set-out", "colour=red"});
        VERIFY_CODE(run, 2);
        QVERIFY2(run.err.contains("has no setting colour"), run.err.constData());
        const ProgramRun malformed = box.run(
            {"convert", "x.csv", "x.txt", "--dims", "1", "--to", "softmc", "--set-out", "colour"});
        VERIFY_CODE(malformed, 2);
    }

    void aFileOfAnotherControllerIsWrittenToADrive()
    {
        const Sandbox box;
        box.file("x.txt", softmcTable);
        const test::VirtualDriveProcess drive(box);
        const QStringList axis{"--drive", drive.url(), "--axis", "0"};
        const ProgramRun run =
            box.run(QStringList{"write", "--data", "x.txt", "--source1", test::positionSource(0)}
                + unitsIn + axis);
        VERIFY_CODE(run, 0);
        QVERIFY2(run.err.contains("softmc holds command values"), run.err.constData());
        const ProgramRun read = box.run(QStringList{"read", "-o", "read.csv", "--json"} + axis);
        VERIFY_CODE(read, 0);
        const QJsonObject table = read.json().value("table").toObject();
        QVERIFY(table.value("max").toDouble() > 0.0199); // the sign of the drive
        QVERIFY(table.value("min").toDouble() >= -1e-9);
        const ProgramRun other =
            box.run(QStringList{"read", "-o", "again.txt", "--to", "softmc"} + axis);
        VERIFY_CODE(other, 0);
        QVERIFY2(other.err.contains("softmc holds command values"), other.err.constData());
        const QByteArray last = box.content("again.txt").split('\n').at(3);
        QVERIFY2(std::abs(last.split(' ').at(1).toDouble() + 0.02) < 1e-5, last.constData());
    }

    /// e of the controller in um over mm becomes c = -e(x + c); in closed form at the middle knot.
    void whatIsStatedOfUnitsIsTakenBeforeTheSignIsConverted_data()
    {
        QTest::addColumn<QStringList>("units");
        QTest::newRow("as the file says") << QStringList{};
        QTest::newRow("as it says, once more")
            << QStringList{"--value-unit", "um", "--position-unit", "mm"};
    }
    void whatIsStatedOfUnitsIsTakenBeforeTheSignIsConverted()
    {
        QFETCH(QStringList, units);
        const Sandbox box;
        box.file("x.csv", "X [mm],X error [um]\n0,0\n10,-500\n20,250\n30,-500\n40,0\n");
        const test::VirtualDriveProcess drive(box);
        const QStringList axis{"--drive", drive.url(), "--axis", "0"};
        VERIFY_CODE(box.run(QStringList{"write", "--data", "x.csv", "--dims", "1", "--sign",
                                "command", "--source1", encoderOfX, "--accept-large"}
                        + units + axis),
            0);
        const ProgramRun read = box.run(QStringList{"read"} + axis);
        QVERIFY2(read.out.contains("\n10,0.465116"), read.out.constData()); // 0.5 / 1.075
    }

    /// The values of LinuxCNC are positions, so that one of two units is wrong by a factor.
    void twoUnitsThatAreStatedForOneAxisAreRefused()
    {
        const Sandbox box;
        box.file("x.txt", "0 0 0\n100 0.02 0.02\n");
        const test::VirtualDriveProcess drive(box);
        const QStringList write{"write", "--data", "x.txt", "--from", "linuxcnc", "--set-in",
            "type=1", "--position-unit", "mm", "--source1", encoderOfX, "--drive", drive.url(),
            "--axis", "0"};
        const ProgramRun refused = box.run(write + QStringList{"--value-unit", "um"});
        VERIFY_CODE(refused, 3);
        QVERIFY2(refused.err.contains("positions in mm and values in um"), refused.err.constData());
        QVERIFY2(refused.err.contains("expected one unit"), refused.err.constData());
        VERIFY_CODE(box.run(write + QStringList{"--value-unit", "mm"}), 0);
    }

    /// As a setting the unit of the drive counted as no unit, and the values as mm.
    void theUnitOfTheDriveIsNoSetting()
    {
        const Sandbox box;
        box.file("x.csv", "X [um],E [um]\n0,0\n50000,2\n100000,-3\n");
        const test::VirtualDriveProcess drive(box);
        const QStringList write{"write", "--data", "x.csv", "--dims", "1", "--target", "#1",
            "--source1", encoderOfX, "--drive", drive.url(), "--axis", "0", "--accept-large"};
        const ProgramRun refused = box.run(write + QStringList{"--set-in", "value-unit=drive"});
        VERIFY_CODE(refused, 2);
        QVERIFY2(refused.err.contains("value-unit is \"drive\", expected a unit"),
            refused.err.constData());
        QVERIFY2(refused.err.contains("--value-unit of axiscomp write"), refused.err.constData());
        VERIFY_CODE(box.run(write + QStringList{"--value-unit", "drive"}), 0);
        const ProgramRun read =
            box.run({"read", "--drive", drive.url(), "--axis", "0"}); // as its mm
        QVERIFY2(read.out.contains("\n50,2\n100,-3\n"), read.out.constData());
    }

    void oneUnitIsStatedOnce()
    {
        const Sandbox box;
        box.file("x.csv", "X,E\n0,0\n50,2\n100,-3\n");
        const test::VirtualDriveProcess drive(box);
        const QStringList write{"write", "--data", "x.csv", "--dims", "1", "--source1", encoderOfX,
            "--drive", drive.url(), "--axis", "0", "--dry-run", "--set-in", "value-unit=nm"};
        const ProgramRun both = box.run(write + QStringList{"--value-unit", "um"});
        VERIFY_CODE(both, 2);
        QVERIFY2(both.err.contains("the unit um is stated, and the setting value-unit says nm"),
            both.err.constData());
        const ProgramRun twice = box.run(write + QStringList{"--set-in", "value-unit=um"});
        VERIFY_CODE(twice, 2);
        QVERIFY2(
            twice.err.contains("the setting value-unit is given twice"), twice.err.constData());
        VERIFY_CODE(box.run(write + QStringList{"--value-unit", "nm"}), 0);
    }

    /// Before the compensation its values are as the file has them; behind it they have to be
    /// converted, for which it has to be known what they correct.
    void whatTheSetPositionCorrectsIsTakenFromTheAxis()
    {
        const Sandbox box;
        box.file("x.txt", "1 3\n0 0\n100 0.0025\n200 -0.00125\n");
        const test::VirtualDriveProcess drive(box);
        VERIFY_CODE(box.run({"write", "--data", "x.txt", "--from", "softmc", "--sign", "feedback",
                        "--source1", "Axes[0]/Signals/PathPlanner/Position", "--drive", drive.url(),
                        "--axis", "0"}),
            0);
        const ProgramRun read = box.run({"read", "--drive", drive.url(), "--axis", "0"});
        QVERIFY2(
            read.out.contains("\n100,0.0024999375\n"), read.out.constData()); // 0.0025 / 1.000025
    }

    /// um added to positions whose unit nobody has said would be a wrong number.
    void valuesWithAUnitAreNotAddedToPositionsWithoutOne()
    {
        const Sandbox box;
        box.file("x.csv", "X,X error [um]\n0,0\n10,-500\n20,250\n30,-500\n40,0\n");
        const test::VirtualDriveProcess drive(box);
        const QStringList write{"write", "--data", "x.csv", "--dims", "1", "--sign", "command",
            "--source1", encoderOfX, "--accept-large", "--drive", drive.url(), "--axis", "0"};
        const ProgramRun refused = box.run(write);
        VERIFY_CODE(refused, 2);
        QVERIFY2(
            refused.err.contains("have no unit; state it in the header"), refused.err.constData());
        VERIFY_CODE(box.run(write + QStringList{"--position-unit", "mm"}), 0);
        const ProgramRun read = box.run({"read", "--drive", drive.url(), "--axis", "0"});
        QVERIFY2(read.out.contains("\n10,0.465116"), read.out.constData());

        box.file("furlong.csv", "X [mm],X error [furlong]\n0,0\n10,5\n");
        const ProgramRun unknown =
            box.run({"convert", "furlong.csv", "y.csv", "--dims", "1", "--to-sign", "command"});
        VERIFY_CODE(unknown, 2);
        QVERIFY2(
            unknown.err.contains("furlong, which cannot be given in mm"), unknown.err.constData());
    }

    void eachColumnOfAnAdjustedFileIsATable()
    {
        const Sandbox box;
        box.file("x.csv", "X [mm],Table 1 [um],Table 2 [um]\n0,0,2\n10,1,3\n20,4,5\n");
        const ProgramRun run =
            box.run({"convert", "x.csv", "o.csv", "--dims", "1", "--scale", "-2", "--zero", "10"});
        VERIFY_CODE(run, 0);
        QVERIFY2(run.out.startsWith("Wrote o.csv: csv, 2 tables, "), run.out.constData());
        QVERIFY2(
            run.out.contains("the values of Table 1 are shifted by 2 um"), run.out.constData());
        QVERIFY2(
            run.out.contains("the values of Table 2 are shifted by 6 um"), run.out.constData());
    }

    void lookupDoesWhatItIsAskedToDoWithATableOfTheDrive()
    {
        const Sandbox box;
        box.file("x.csv", "X [mm],X error [mm]\n0,0\n100,0.004\n");
        const auto at50 = [&](const QStringList& options) {
            const ProgramRun run =
                box.run(QStringList{"lookup", "x.csv", "50", "--dims", "1"} + options);
            return run.code == 0 ? run.out.trimmed() : run.err;
        };
        QCOMPARE(at50({}), QByteArray("0.002"));
        QCOMPARE(at50({"--scale", "-10", "--offset", "5"}), QByteArray("4.98"));
        QCOMPARE(at50({"--zero", "100"}), QByteArray("-0.002"));
        VERIFY_CODE(box.run({"lookup", "x.csv", "50", "--dims", "1", "--set-out", "a=b"}), 2);
        // Command values are turned: -e(x + c), with e = 4e-5 x.
        const double command = at50({"--sign", "command"}).toDouble();
        QVERIFY2(std::abs(command + 0.002 / 1.00004) < 1e-9, std::to_string(command).c_str());
    }

    void aValueInAnotherUnitThanThatOfTheFileIsSaidToBe()
    {
        const Sandbox box;
        box.file("um.csv", "X [mm],X error [um]\n0,0\n100,4\n");
        box.file("mm.csv", "X [mm],X error [mm]\n0,0\n100,0.004\n");
        const auto noteOf = [&](const QString& file, const QString& as) {
            const ProgramRun run = box.run({"lookup", file, "50", "--dims", "1", "--as", as});
            return run.code == 0 ? run.err : QByteArray("failed: " + run.err);
        };
        const QByteArray note = "um.csv: the unit of the value is mm; that of the file is um\n";
        QVERIFY2(noteOf("um.csv", "softmc").contains(note), noteOf("um.csv", "softmc").constData());
        for (const QByteArray& err : {noteOf("um.csv", "csv"), noteOf("mm.csv", "softmc")})
            QVERIFY2(
                !err.contains("the unit of the value") && !err.contains("failed"), err.constData());
    }

    void whatATamTableDoesNotHoldIsSaid()
    {
        const Sandbox box;
        box.file("x.csv", "// lookup: set\nX [mm],X error [mm]\n0,0\n100,0.004\n");
        const ProgramRun run = box.run({"convert", "x.csv", "x.TAMtbl", "--dims", "1"});
        VERIFY_CODE(run, 0);
        QVERIFY2(run.err.contains("look it up at the set position"), run.err.constData());
        QVERIFY2(run.err.contains("does not say what it corrects (X)"), run.err.constData());
    }

    /// The axis has one unit, so that values in mm over positions in um are of no drive.
    void theUnitOfTheAxisIsThatOfItsPositionsToo()
    {
        const Sandbox box;
        box.file("x.csv", "X [um],X error [um]\n0,0\n100000,4\n");
        VERIFY_CODE(
            box.run({"convert", "x.csv", "x.TAMtbl", "--dims", "1", "--value-unit", "mm"}), 0);
        const ProgramRun table = box.run({"inspect", "x.TAMtbl", "--json"});
        QCOMPARE(table.json()["axes"][0]["distance"].toDouble(), 100.0);
        QCOMPARE(table.json()["tables"][0]["max"].toDouble(), double(0.004F));
    }

    /// The same file for a source after the compensation and for one before it, there and back.
    void theFileOfAnotherControllerIsMadeForTheSourceOfTheAxis()
    {
        const Sandbox box;
        const QByteArray file = "1 5\n0 0\n10 -0.5\n20 0.25\n30 -0.5\n40 0\n";
        box.file("x.txt", file);
        const test::VirtualDriveProcess drive(box);
        const QStringList axis{"--drive", drive.url(), "--axis", "0"};
        const auto heldWith = [&](const QString& source) {
            const ProgramRun run = box.run(
                QStringList{"write", "--data", "x.txt", "--source1", source, "--accept-large"}
                + unitsIn + axis);
            return run.code == 0 ? box.run(QStringList{"read"} + axis).out : run.err;
        };
        const QByteArray set = heldWith("Axes[0]/Signals/PathPlanner/Position");
        QVERIFY2(set.contains("// lookup: set\n") && set.contains("X [mm],")
                && set.contains("\n10,0.5\n20,-0.25\n"),
            set.constData());
        VERIFY_CODE(box.run(QStringList{"read", "-o", "again.txt", "--to", "softmc"} + axis), 0);
        QCOMPARE(box.content("again.txt"), file);

        const QByteArray encoder = heldWith("Axes[0]/Signals/PositionController/MasterPosition");
        QVERIFY2(encoder.contains("// lookup: encoder\n") && encoder.contains("\n10,0.4651163\n"),
            encoder.constData());
    }

    void lookupSaysWhereItTakesTheDriveToLookTheTableUp()
    {
        const Sandbox box;
        box.file("x.csv", "X [mm],X error [mm]\n0,0\n10,0.5\n20,0.2\n30,0\n");
        const QStringList words{
            "lookup", "x.csv", "10", "--dims", "1", "--as", "softmc", "--target", "X"};
        const ProgramRun assumed = box.run(words);
        VERIFY_CODE(assumed, 0);
        QVERIFY2(assumed.err.contains("at the set position (lookup: set) its corrections would"),
            assumed.err.constData());
        const ProgramRun set = box.run(words + QStringList{"--lookup-at", "set"});
        VERIFY_CODE(set, 0);
        QVERIFY2(set.out.trimmed() == "-0.5", set.out.constData());
        QVERIFY(assumed.out != set.out);
    }

    /// Refused for the encoder, since its knots are not even then.
    void whatFitsTheSetPositionAloneIsWrittenThere()
    {
        const Sandbox box;
        box.file("set.csv", "// lookup: set\nX [mm],X error [mm]\n0,0\n10,0.5\n20,0.2\n30,0\n");
        VERIFY_CODE(box.run({"convert", "set.csv", "x.comp", "--dims", "1", "--target", "#1",
                        "--to", "linuxcnc", "--set-out", "type=0", "--to-sign", "feedback"}),
            0);
        const test::VirtualDriveProcess drive(box);
        const QStringList write{"write", "--data", "x.comp", "--drive", drive.url(), "--axis", "0",
            "--sign", "feedback", "--accept-large", "--set-in", "position-unit=mm", "--source1"};
        VERIFY_CODE(box.run(write + QStringList{"Axes[0]/Signals/PathPlanner/Position"}), 0);
        const ProgramRun read = box.run({"read", "--drive", drive.url(), "--axis", "0"});
        QVERIFY2(read.out.contains("\n10,0.5\n20,0.2\n"), read.out.constData());
    }

    void aCalibrationFileOfCommandValuesIsNotWrittenAsItIs()
    {
        const Sandbox box;
        box.file("set.csv", "// lookup: set\nX [mm],X error [mm]\n0,0\n10,0.5\n20,0.2\n30,0\n");
        VERIFY_CODE(box.run({"convert", "set.csv", "c.csv", "--dims", "1", "--target", "#1",
                        "--to-sign", "command"}),
            0);
        QVERIFY2(box.content("c.csv").contains("// sign: command\n")
                && box.content("c.csv").contains("\n10,-0.5\n"),
            box.content("c.csv").constData());
        const test::VirtualDriveProcess drive(box);
        const QStringList write{"write", "--data", "c.csv", "--dims", "1", "--drive", drive.url(),
            "--axis", "0", "--accept-large", "--source1", "Axes[0]/Signals/PathPlanner/Position"};
        const ProgramRun refused = box.run(write + QStringList{"--sign", "feedback"});
        VERIFY_CODE(refused, 2);
        QVERIFY2(refused.err.contains("the file says sign: command, and stated is feedback"),
            refused.err.constData());
        VERIFY_CODE(box.run(write), 0);
        const ProgramRun read = box.run({"read", "--drive", drive.url(), "--axis", "0"});
        QVERIFY2(read.out.contains("\n10,0.5\n20,0.2\n"), read.out.constData());
    }

    void whatIsReadInTwoDimensionsCanBecomeTheFileOfAnotherController()
    {
        const Sandbox box;
        box.file(
            "xy.csv", "X [mm],Y [mm],X error [mm]\n0,0,0\n10,0,0.001\n0,10,-0.002\n10,10,0.003\n");
        const test::VirtualDriveProcess drive(box, {"--axes", "2"});
        const QStringList axis{"--drive", drive.url(), "--axis", "0"};
        VERIFY_CODE(box.run(QStringList{"write", "--data", "xy.csv", "--dims", "2", "--source1",
                                test::positionSource(0), "--source2", test::positionSource(1)}
                        + axis),
            0);
        const ProgramRun read =
            box.run(QStringList{"read", "-o", "again.txt", "--to", "softmc"} + axis);
        VERIFY_CODE(read, 0);
        VERIFY_CODE(box.run({"convert", "xy.csv", "converted.txt", "--dims", "2", "--to", "softmc",
                        "--target", "X", "--lookup-at", "set"}),
            0);
        QVERIFY(!box.content("again.txt").isEmpty());
        QCOMPARE(box.content("again.txt"), box.content("converted.txt"));
    }

    void theColumnsOfOneFileAreWrittenToTheirAxes()
    {
        const Sandbox box;
        box.file("plane.csv",
            "X,Y,Cold,Warm\n0,0,0.001,0.01\n50,0,0.002,0.02\n"
            "0,50,0.003,0.03\n50,50,0.004,0.04\n");
        const test::VirtualDriveProcess drive(box, {"--axes", "2"});
        const QStringList write{"write", "--drive", drive.url(), "--data", "plane.csv", "--dims",
            "2", "--source1", test::positionSource(0), "--source2", test::positionSource(1)};
        const ProgramRun run =
            box.run(write + QStringList{"--map", "Cold=X", "--map", "Warm=1", "--json"});
        VERIFY_CODE(run, 0);
        QCOMPARE(run.json().value("writes").toArray().size(), 2);
        const auto largest = [&](const char* axis) {
            const ProgramRun read = box.run(
                {"read", "--drive", drive.url(), "--axis", axis, "-o", "read.csv", "--json"});
            return read.json().value("table").toObject().value("max").toDouble();
        };
        QCOMPARE(static_cast<float>(largest("0")), 0.004F);
        QCOMPARE(static_cast<float>(largest("1")), 0.04F);
    }

    void nothingIsWrittenWhenOneOfTheAxesCannotBe()
    {
        const Sandbox box;
        box.file("plane.csv", "X,Cold,Warm\n0,0.001,0.01\n50,0.002,0.02\n");
        const test::VirtualDriveProcess drive(box, {"--axes", "2"});
        const QStringList write{"write", "--drive", drive.url(), "--data", "plane.csv", "--dims",
            "1", "--source1", test::positionSource(0)};
        const ProgramRun twice = box.run(write + QStringList{"--map", "Cold=X", "--map", "Warm=0"});
        VERIFY_CODE(twice, 2);
        QVERIFY2(twice.err.contains("is named twice"), twice.err.constData());
        const ProgramRun unknown =
            box.run(write + QStringList{"--map", "Cold=X", "--map", "Hot=1"});
        VERIFY_CODE(unknown, 2);
        QVERIFY2(unknown.err.startsWith("error: TableNotFound: "), unknown.err.constData());
        const ProgramRun status =
            box.run({"status", "--drive", drive.url(), "--axis", "0", "--json"});
        QVERIFY(status.json().value("slot").isNull());
    }

    void oneFormatIsDescribedInFull()
    {
        const Sandbox box;
        const ProgramRun run = box.run({"formats", "softmc"});
        VERIFY_CODE(run, 0);
        QVERIFY2(run.out.contains("the first source fastest"), run.out.constData());
        QVERIFY2(run.out.contains("Assumptions"), run.out.constData());
    }

    /// What is looked up outside of a table is what is said of its controller.
    void aFormatWhoseTablesRollOverSaysSo()
    {
        const Sandbox box;
        box.file("x.pmc", "#1\nDEFINE COMP 4,#1D,#1,4000\n160 -80 32 0\n");
        const ProgramRun run = box.run({"lookup", "x.pmc", "--sign", "command", "--", "-1000"});
        VERIFY_CODE(run, 0);
        QCOMPARE(run.out.trimmed(), QByteArray("2"));
        for (const char* name : {"pmac-1d", "pmac-2d"}) {
            const ProgramRun facts = box.run({"formats", name, "--json"});
            QCOMPARE(facts.json().value("outside").toString(),
                QStringLiteral("outside of the table the position rolls over to its other end"));
            QCOMPARE(facts.json().value("outsideEvidence").toString(), QStringLiteral("published"));
        }
    }

    void completionKnowsEveryFormat()
    {
        const Sandbox box;
        const ProgramRun completed = box.runProgram("bash",
            {"-c",
                "source " AXISCOMP_SOURCE_FOLDER "/packaging/completion/axiscomp.bash; "
                "echo $_axiscomp_formats"});
        VERIFY_CODE(completed, 0);
        QStringList names;
        for (const QJsonValue& format :
            box.run({"formats", "--json"}).json().value("formats").toArray())
            names += format.toObject().value("name").toString();
        QCOMPARE(QString::fromUtf8(completed.out).simplified().split(' '), names);
    }

    void thePageOfTheDocumentationIsUpToDate()
    {
        const Sandbox box;
        const ProgramRun run = box.run({"formats", "--markdown"});
        VERIFY_CODE(run, 0);
        QFile page(QStringLiteral(AXISCOMP_SOURCE_FOLDER "/docs/formats.md"));
        QVERIFY(page.open(QIODevice::ReadOnly));
        QVERIFY2(page.readAll() == run.out,
            "docs/formats.md differs: axiscomp formats --markdown > docs/formats.md");
    }
};

AXISCOMP_TEST(tst_ControllerFiles)

} // namespace tst_controllerfiles

#include "tst_controllerfiles.moc"
