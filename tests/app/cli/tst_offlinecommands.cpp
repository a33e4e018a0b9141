// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program_run.h"

#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

namespace tst_offlinecommands {

using namespace axiscomp;
using test::ProgramRun;
using test::Sandbox;

namespace {

const QByteArray line1D = "X [mm],Error [mm]\n0,0.001\n10,0.002\n20,-0.004\n";
const QByteArray twoTables = "X,Cold,Warm\n0,0,1\n1000,0.1,2\n2000,0.2,3\n";

} // namespace

class tst_OfflineCommands : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void exampleIsValidInput_data()
    {
        QTest::addColumn<QString>("dimensions");
        QTest::addColumn<int>("points");
        QTest::newRow("1D") << "1" << 11;
        QTest::newRow("2D") << "2" << 20;
        QTest::newRow("3D") << "3" << 36;
    }
    void exampleIsValidInput()
    {
        QFETCH(const QString, dimensions);
        QFETCH(const int, points);
        const Sandbox box;
        const ProgramRun written = box.run({"example", "--dims", dimensions, "-o", "e.csv"});
        VERIFY_CODE(written, 0);
        QCOMPARE(written.out, "Wrote e.csv.\n");
        const ProgramRun inspected = box.run({"inspect", "e.csv", "--dims", dimensions, "--json"});
        VERIFY_CODE(inspected, 0);
        const QJsonObject json = inspected.json();
        QCOMPARE(json.value("dimensions").toInt(), dimensions.toInt());
        QCOMPARE(json.value("tables").toArray().size(), 2);
        QCOMPARE(json.value("warnings").toArray().size(), 0);
        QCOMPARE(json.value("errors").toArray().size(), 0);
        QVERIFY(json.value("notes").toArray().size() >= 2);
        int product = 1;
        for (const QJsonValue& axis : json.value("axes").toArray())
            product *= axis.toObject().value("size").toInt();
        QCOMPARE(product, points);
    }

    void exampleGoesToStandardOutputWithoutAFile()
    {
        const Sandbox box;
        const ProgramRun plain = box.run({"example", "--dims", "1", "--tables", "3"});
        VERIFY_CODE(plain, 0);
        const ProgramRun inspected = box.run({"inspect", "-", "--dims", "1", "--json"}, plain.out);
        VERIFY_CODE(inspected, 0);
        QCOMPARE(inspected.json().value("tables").toArray().size(), 3);
    }

    void aMeasurementIsNotReadAsATable()
    {
        const Sandbox box;
        const QByteArray runs = "target [mm],direction,run,deviation [mm]\n0,1,1,0.001\n"
                                "10,1,1,0.002\n20,1,1,0.003\n";
        box.file("m.csv", runs);
        const QList<QStringList> commands{{"inspect", "m.csv"}, {"inspect", "m.csv", "--dims", "1"},
            {"inspect", "-", "--dims", "1"},
            {"convert", "m.csv", "x.TAMtbl", "--dims", "1", "--table", "deviation"}};
        for (const QStringList& command : commands) {
            const ProgramRun refused = box.run(command, runs);
            QVERIFY2(refused.code != 0, qPrintable(command.join(u' ')));
            QVERIFY2(refused.err.contains("error: UnknownFormat: ")
                    && refused.err.contains(" is a measurement, not a table; "),
                refused.text().constData());
        }
        QVERIFY(!QFile::exists(box.path("x.TAMtbl")));
        // As which somebody insists to read it.
        const ProgramRun named = box.run({"inspect", "m.csv", "--dims", "1", "--from", "csv"});
        VERIFY_CODE(named, 0);
    }

    void inspectReportsEveryKeyOfTheSpecification()
    {
        const Sandbox box;
        const QString file = box.file("t.csv", "// measured at 20 C\n" + line1D);
        const ProgramRun run = box.run({"inspect", file, "--dims", "1", "--json"});
        VERIFY_CODE(run, 0);
        const QJsonObject json = run.json();
        QCOMPARE(json.keys(),
            (QStringList{"axes", "dimensions", "errors", "format", "notes", "tables", "warnings"}));
        QCOMPARE(json.value("format").toString(), "csv");
        const QJsonObject axis = json.value("axes").toArray().at(0).toObject();
        QCOMPARE(axis.keys(), (QStringList{"distance", "name", "size", "start", "unit"}));
        QCOMPARE(axis.value("name").toString(), "X");
        QCOMPARE(axis.value("unit").toString(), "mm");
        QCOMPARE(axis.value("start").toDouble(), 0.0);
        QCOMPARE(axis.value("distance").toDouble(), 10.0);
        QCOMPARE(axis.value("size").toInt(), 3);
        const QJsonObject table = json.value("tables").toArray().at(0).toObject();
        QCOMPARE(
            table.keys(), (QStringList{"filled", "max", "min", "name", "rms", "target", "unit"}));
        QCOMPARE(table.value("min").toDouble(), static_cast<double>(-0.004F));
        QCOMPARE(table.value("max").toDouble(), static_cast<double>(0.002F));
        QCOMPARE(json.value("notes").toArray(), (QJsonArray{"measured at 20 C"}));
    }

    void inspectShowsUnitsAndFiguresToPeople()
    {
        const Sandbox box;
        box.file("t.csv", line1D);
        const ProgramRun run = box.run({"inspect", "t.csv", "--dims", "1"});
        VERIFY_CODE(run, 0);
        QVERIFY2(run.out.startsWith("t.csv: csv, 1 dimension, 3 points, 1 table\n"),
            run.out.constData());
        QVERIFY2(run.out.contains("-0.004  0.002"), run.out.constData());
        QCOMPARE(run.err, QByteArray());
    }

    void aBadFileIsReportedAsCompilersDo()
    {
        const Sandbox box;
        box.file("bad.csv", "X,T\n0,1\n10,abc\n20,2,3\n");
        const ProgramRun run = box.run({"inspect", "bad.csv", "--dims", "1"});
        VERIFY_CODE(run, 3);
        QVERIFY2(run.err.contains("bad.csv:3:2: error: "), run.err.constData());
        QVERIFY2(run.err.contains("abc"), run.err.constData());
        QVERIFY2(run.err.contains("bad.csv:4"), run.err.constData());
        QCOMPARE(run.out, QByteArray());

        const ProgramRun json = box.run({"inspect", "bad.csv", "--dims", "1", "--json"});
        VERIFY_CODE(json, 3);
        const QJsonArray errors = json.json().value("errors").toArray();
        QCOMPARE(errors.size(), 2);
        const QJsonObject first = errors.at(0).toObject();
        QCOMPARE(first.keys(), (QStringList{"code", "column", "line", "message"}));
        QCOMPARE(first.value("code").toString(), "NotANumber");
        QCOMPARE(first.value("line").toInt(), 3);
        QCOMPARE(first.value("column").toInt(), 2);
        QVERIFY(json.json().value("tables").toArray().isEmpty());
    }

    void warningsDoNotStop()
    {
        const Sandbox box;
        box.file("flat.csv", "X,T\n0,1\n10,1\n20,1\n");
        const ProgramRun run = box.run({"inspect", "flat.csv", "--dims", "1", "--json"});
        VERIFY_CODE(run, 0);
        QVERIFY2(
            run.err.contains("flat.csv") && run.err.contains("warning: "), run.err.constData());
        const QJsonArray warnings = run.json().value("warnings").toArray();
        QCOMPARE(warnings.size(), 1);
        QCOMPARE(warnings.at(0).toObject().value("code").toString(), "ConstantTable");
    }

    void aMissingFileIsNoValidInput_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("csv") << QStringList{"inspect", "no.csv", "--dims", "1"};
        QTest::newRow("csv without dimensions") << QStringList{"inspect", "no.csv"};
        QTest::newRow("table") << QStringList{"inspect", "no.TAMtbl"};
        QTest::newRow("convert") << QStringList{"convert", "no.csv", "o.TAMtbl", "--dims", "1"};
        QTest::newRow("points") << QStringList{
            "lookup", "t.csv", "--dims", "1", "--points", "no.txt"};
        QTest::newRow("profile") << QStringList{
            "convert", "t.csv", "o.TAMtbl", "--dims", "1", "--profile", "no.json"};
    }
    void aMissingFileIsNoValidInput()
    {
        QFETCH(const QStringList, arguments);
        const Sandbox box;
        box.file("t.csv", line1D);
        const ProgramRun run = box.run(arguments);
        VERIFY_CODE(run, 3);
        QVERIFY2(run.err.contains("error: "), run.err.constData());
        QVERIFY2(run.err.contains("no."), run.err.constData());
    }

    void dimensionsAreNeverGuessed_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QByteArray>("suggestion");
        QTest::newRow("only 1 fits")
            << line1D << QByteArray("only --dims 1 fits t.csv; it could be icube as well");
        QTest::newRow("only 2 fits") << QByteArray("X,Y,T\n0,0,1\n1,0,2\n0,1,3\n1,1,4\n")
                                     << QByteArray("only --dims 2 fits");
        QTest::newRow("none fits") << QByteArray("X,T\n0,a\n") << QByteArray();
    }
    void dimensionsAreNeverGuessed()
    {
        QFETCH(const QByteArray, content);
        QFETCH(const QByteArray, suggestion);
        const Sandbox box;
        box.file("t.csv", content);
        const ProgramRun run = box.run({"inspect", "t.csv"});
        VERIFY_CODE(run, 2);
        QVERIFY2(run.err.startsWith("error: InvalidArgument: "), run.err.constData());
        QVERIFY2(run.err.contains("--dims 1, 2 or 3"), run.err.constData());
        QCOMPARE(run.err.contains("fits"), !suggestion.isEmpty());
        QVERIFY2(run.err.contains(suggestion), run.err.constData());
        QCOMPARE(run.err.count('\n'), 1);
    }

    void aLostEndOfTheDataIsAWarning()
    {
        const Sandbox box;
        box.file("x.csv", "X [mm],E [um]\n0,0\n50,10\n100,-4\n");
        const QByteArray lost = "the grid ends at 90 mm, 10 mm before its end";
        const QStringList options{"--to", "csv", "--dims", "1", "--distance", "30"};
        for (const char* const to : {"y.csv", "-"}) {
            const ProgramRun run = box.run(QStringList{"convert", "x.csv", to} + options);
            VERIFY_CODE(run, 0);
            QVERIFY2(run.err.contains("warning: ") && run.err.contains(lost), run.err.constData());
            QVERIFY2(!run.out.contains(lost), run.out.constData());
        }
        const ProgramRun held =
            box.run(QStringList{"convert", "x.csv", "y.csv", "--hold"} + options);
        VERIFY_CODE(held, 0);
        QCOMPARE(held.err, QByteArray());
        QVERIFY2(
            held.out.contains("the grid ends at 120 mm, 20 mm behind it"), held.out.constData());
    }

    void unitsThatNobodySaysAreAWarningWhereAFileCouldSayThem()
    {
        const Sandbox box;
        box.file("open.csv", "X,E\n0,0\n50,0.01\n100,-0.004\n");
        box.file("values.csv", "X [mm],E\n0,0\n50,0.01\n100,-0.004\n");
        VERIFY_CODE(box.run({"convert", "open.csv", "x.TAMtbl", "--dims", "1"}), 0);
        const QByteArray positions = "found positions without a unit";
        const QByteArray values = "found values without a unit";
        const auto check = [&](const QStringList& arguments, bool ofPositions, bool ofValues) {
            const ProgramRun run = box.run(QStringList{"convert"} + arguments);
            VERIFY_CODE(run, 0);
            QCOMPARE(run.err.contains(positions), ofPositions);
            QCOMPARE(run.err.contains(values), ofValues);
            QCOMPARE(run.err.count("(UnitNotGiven)"), int(ofPositions) + int(ofValues));
        };
        for (const QStringList& last : {QStringList(), QStringList{"--points", "5"}}) {
            check(QStringList{"open.csv", "y.csv", "--dims", "1"} + last, true, true);
            check(QStringList{"values.csv", "y.csv", "--dims", "1"} + last, false, true);
            check(QStringList{"x.TAMtbl", "y.csv"} + last, true, true);
            check(QStringList{"x.TAMtbl", "y.csv", "--set-in", "position-unit=mm", "--set-in",
                      "value-unit=mm"}
                    + last,
                false, false);
        }
        check({"open.csv", "y.TAMtbl", "--dims", "1"}, false, false); // it has none
    }

    void aTableForTheDriveIsInTheUnitOfItsPositions()
    {
        const Sandbox box;
        box.file("um.csv", "X [mm],E [um]\n0,0\n50,10\n100,-4\n");
        box.file("mm.csv", "X [mm],E [mm]\n0,0\n50,0.01\n100,-0.004\n");
        const ProgramRun converted = box.run({"convert", "um.csv", "um.TAMtbl", "--dims", "1"});
        VERIFY_CODE(converted, 0);
        QVERIFY2(
            converted.err.contains("converted from um to mm. The largest correction is 0.01 mm"),
            converted.err.constData());
        VERIFY_CODE(box.run({"convert", "mm.csv", "mm.TAMtbl", "--dims", "1"}), 0);
        QCOMPARE(
            box.content("um.TAMtbl").last(12).toHex(), box.content("mm.TAMtbl").last(12).toHex());
        // Also on the way over a resampled grid.
        const QStringList even{"--dims", "1", "--points", "3"};
        VERIFY_CODE(box.run(QStringList{"convert", "um.csv", "even.TAMtbl"} + even), 0);
        QCOMPARE(
            box.content("even.TAMtbl").last(12).toHex(), box.content("mm.TAMtbl").last(12).toHex());

        // Values of Y are in the unit of Y, whatever X is in.
        box.file("y.csv", "// target: Y\nX [m],Y [mm],E [um]\n0,0,0\n1,0,10\n0,50,-4\n1,50,10\n");
        const ProgramRun second = box.run({"convert", "y.csv", "y.TAMtbl", "--dims", "2"});
        VERIFY_CODE(second, 0);
        QVERIFY2(second.err.contains("converted from um to mm."), second.err.constData());

        // Which one is corrected is asked where it is another unit.
        box.file("open.csv", "Z [m],X [mm],E [um]\n0,0,0\n1,0,10\n0,50,-4\n1,50,10\n");
        const ProgramRun open = box.run({"convert", "open.csv", "open.TAMtbl", "--dims", "2"});
        VERIFY_CODE(open, 2);
        QVERIFY2(open.err.contains("--target, such as --target #1"), open.err.constData());
        VERIFY_CODE(
            box.run({"convert", "open.csv", "open.TAMtbl", "--dims", "2", "--target", "#2"}), 0);
        const QByteArray inMillimetres = box.content("open.TAMtbl").last(16);
        for (const QStringList& more :
            {QStringList{"--target", "other"}, QStringList{"--points", "2,2"}}) {
            const ProgramRun unknown =
                box.run(QStringList{"convert", "open.csv", "unknown.TAMtbl", "--dims", "2"} + more);
            VERIFY_CODE(unknown, 2);
            QVERIFY2(unknown.err.contains("convert to a .csv file first, and that one with "
                                          "--value-unit, such as --value-unit mm"),
                unknown.err.constData());
            QVERIFY(!QFile::exists(box.path("unknown.TAMtbl")));
        }
        VERIFY_CODE(
            box.run({"convert", "open.csv", "other.csv", "--dims", "2", "--target", "other"}), 0);
        const QStringList fromCsv{"convert", "other.csv", "other.TAMtbl", "--dims", "2"};
        VERIFY_CODE(box.run(fromCsv), 2);
        const ProgramRun twice =
            box.run(fromCsv + QStringList{"--value-unit", "mm", "--target", "other"});
        VERIFY_CODE(twice, 2);
        QVERIFY2(twice.err.contains("convert to a .csv file first, with --target, and that one "
                                    "with --value-unit alone"),
            twice.err.constData());
        VERIFY_CODE(box.run(fromCsv + QStringList{"--value-unit", "mm"}), 0);
        QCOMPARE(box.content("other.TAMtbl").last(16).toHex(), inMillimetres.toHex());

        box.file("deg.csv", "X [mm],E [deg]\n0,0\n50,0.01\n100,-0.004\n");
        const ProgramRun angle = box.run({"convert", "deg.csv", "deg.TAMtbl", "--dims", "1"});
        VERIFY_CODE(angle, 2);
        QVERIFY2(angle.err.contains("error: UnitMismatch: "), angle.err.constData());
        VERIFY_CODE(
            box.run({"convert", "deg.csv", "deg.TAMtbl", "--dims", "1", "--value-unit", "deg"}), 0);

        box.file("large.csv", "X [mm],E [mm]\n0,0\n50,10\n100,-4\n");
        for (const QStringList& more : {QStringList{}, QStringList{"--points", "3"}}) {
            const QStringList command =
                QStringList{"convert", "large.csv", "large.TAMtbl", "--dims", "1"} + more;
            const ProgramRun large = box.run(command);
            VERIFY_CODE(large, 2);
            QVERIFY2(large.err.contains("error: LargeCorrection: "), large.err.constData());
            QVERIFY(!QFile::exists(box.path("large.TAMtbl")));
        }
        VERIFY_CODE(
            box.run({"convert", "large.csv", "large.TAMtbl", "--dims", "1", "--accept-large"}), 0);
    }

    /// It says the unit in a .TAMtbl; a calibration file would be written as it stands.
    void theUnitOfTheValuesIsRefusedWhereItWouldBeIgnored()
    {
        const Sandbox box;
        box.file("x.csv", "X [mm],X error\n0,1\n10,2\n");
        for (const QStringList& more : {QStringList{}, QStringList{"--points", "3"}}) {
            const ProgramRun run = box.run(
                QStringList{"convert", "x.csv", "y.csv", "--dims", "1", "--value-unit", "um"}
                + more);
            VERIFY_CODE(run, 2);
            QVERIFY2(run.err.contains("; --set-in value-unit=UNIT says in which unit"),
                run.err.constData());
            QVERIFY(!QFile::exists(box.path("y.csv")));
        }
        VERIFY_CODE(
            box.run({"convert", "x.csv", "y.csv", "--dims", "1", "--set-in", "value-unit=um"}), 0);
        QVERIFY2(box.content("y.csv").contains("X error [um]"), box.content("y.csv").constData());
        // A .TAMtbl is in the unit of its axis, which is said in one way.
        for (const QString& setting :
            {QStringLiteral("position-unit"), QStringLiteral("value-unit")}) {
            const ProgramRun run = box.run({"convert", "y.csv", "y.TAMtbl", "--dims", "1",
                "--set-out", setting + QStringLiteral("=m")});
            VERIFY_CODE(run, 2);
            QVERIFY2(run.err.contains("no setting " + setting.toUtf8() + " for writing; it has: "),
                run.err.constData());
            QVERIFY(!QFile::exists(box.path("y.TAMtbl")));
        }
    }

    void convertGoesThereAndBack()
    {
        const Sandbox box;
        box.file("t.csv", twoTables);
        const ProgramRun there = box.run({"convert", "t.csv", "t.TAMtbl", "--dims", "1", "--table",
            "Warm", "--persistent", "--json"});
        VERIFY_CODE(there, 0);
        QCOMPARE(there.json().value("to").toString(), "tamtbl");
        QCOMPARE(there.json().value("persistent").toBool(), true);
        QCOMPARE(there.json().value("bytes").toInt(),
            static_cast<int>(QFileInfo(box.path("t.TAMtbl")).size()));

        const ProgramRun table = box.run({"inspect", "t.TAMtbl"});
        VERIFY_CODE(table, 0);
        QVERIFY2(table.out.contains("persistent"), table.out.constData());
        QVERIFY2(table.out.contains("Warm"), table.out.constData());

        VERIFY_CODE(box.run({"convert", "t.TAMtbl", "back.csv"}), 0);
        const ProgramRun back = box.run({"lookup", "back.csv", "500", "--dims", "1"});
        VERIFY_CODE(back, 0);
        QCOMPARE(back.out, "1.5\n");
    }

    void aTableKeepsItsPersistencyUnlessToldOtherwise()
    {
        const Sandbox box;
        box.file("t.csv", line1D);
        VERIFY_CODE(box.run({"convert", "t.csv", "p.TAMtbl", "--dims", "1", "--persistent"}), 0);
        VERIFY_CODE(box.run({"convert", "p.TAMtbl", "kept.TAMtbl", "--name", "New name"}), 0);
        QVERIFY(box.run({"inspect", "kept.TAMtbl"}).out.contains("persistent"));
        QVERIFY(box.run({"inspect", "kept.TAMtbl"}).out.contains("New name"));
        VERIFY_CODE(box.run({"convert", "p.TAMtbl", "v.TAMtbl", "--volatile"}), 0);
        QVERIFY(box.run({"inspect", "v.TAMtbl"}).out.contains("volatile"));
    }

    void persistentIsRefusedWhereTheLayoutHasNoRoomForIt()
    {
        const Sandbox box;
        QFile generic(QStringLiteral(AXISCOMP_SOURCE_FOLDER "/resources/profiles/generic.json"));
        QVERIFY(generic.open(QIODevice::ReadOnly));
        QJsonObject profile = QJsonDocument::fromJson(generic.readAll()).object();
        QJsonObject layout = profile.value("layout").toObject();
        QJsonObject fields = layout.value("fields").toObject();
        QVERIFY(fields.contains("persistent"));
        fields.remove("persistent");
        layout.insert("fields", fields);
        profile.insert("layout", layout);
        box.file("bare.json", QJsonDocument(profile).toJson());
        box.file("t.csv", twoTables);
        QStringList arguments{"convert", "t.csv", "o.TAMtbl", "--dims", "1", "--table", "#1",
            "--profile", "bare.json"};
        VERIFY_CODE(box.run(arguments), 0);
        arguments << "--persistent";
        const ProgramRun run = box.run(arguments);
        VERIFY_CODE(run, 2);
        QVERIFY2(run.err.contains("leave --persistent out"), run.err.constData());
    }

    void convertKeepsAllTablesWhereTheyFit()
    {
        const Sandbox box;
        box.file("t.csv", twoTables);
        const ProgramRun run = box.run({"convert", "t.csv", "-", "--to", "csv", "--dims", "1"});
        VERIFY_CODE(run, 0);
        const ProgramRun inspected = box.run({"inspect", "-", "--dims", "1", "--json"}, run.out);
        QCOMPARE(inspected.json().value("tables").toArray().size(), 2);
    }

    void severalTablesMustBeChosenFrom()
    {
        const Sandbox box;
        box.file("t.csv", twoTables);
        const ProgramRun unnamed = box.run({"convert", "t.csv", "o.TAMtbl", "--dims", "1"});
        VERIFY_CODE(unnamed, 2);
        QVERIFY2(unnamed.err.contains("1 (Cold), 2 (Warm)"), unnamed.err.constData());
        const ProgramRun wrong =
            box.run({"convert", "t.csv", "o.TAMtbl", "--dims", "1", "--table", "3"});
        VERIFY_CODE(wrong, 2);
        QVERIFY2(wrong.err.startsWith("error: TableNotFound: "), wrong.err.constData());
        QVERIFY(!QFile::exists(box.path("o.TAMtbl")));
    }

    void unknownFormatsAreNamed_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("extension") << QStringList{"convert", "t.csv", "t.docx", "--dims", "1"};
        QTest::newRow("no extension") << QStringList{"convert", "t.csv", "t", "--dims", "1"};
        QTest::newRow("--to") << QStringList{
            "convert", "t.csv", "t.bin", "--to", "heidenhain", "--dims", "1"};
        QTest::newRow("--from") << QStringList{"inspect", "t.csv", "--from", "heidenhain"};
    }
    void unknownFormatsAreNamed()
    {
        QFETCH(const QStringList, arguments);
        const Sandbox box;
        box.file("t.csv", line1D);
        const ProgramRun run = box.run(arguments);
        VERIFY_CODE(run, 2);
        QVERIFY2(run.err.startsWith("error: UnknownFormat: "), run.err.constData());
        QVERIFY2(run.err.contains("csv, tamtbl"), run.err.constData());
    }

    void aFormatThatIsOnlyReadIsNotProposedForWriting()
    {
        const Sandbox box;
        box.file("t.csv", line1D);
        const ProgramRun run = box.run({"convert", "t.csv", "t.docx", "--dims", "1"});
        VERIFY_CODE(run, 2);
        QVERIFY2(run.err.contains("name one with --to: csv, tamtbl"), run.err.constData());
        QVERIFY2(!run.err.contains("klipper"), run.err.constData());
    }

    void aBrokenTableNamesFieldAndOffset()
    {
        const Sandbox box;
        box.file("t.csv", line1D);
        VERIFY_CODE(box.run({"convert", "t.csv", "t.TAMtbl", "--dims", "1"}), 0);
        QByteArray bytes = box.content("t.TAMtbl");
        bytes[0] = 'X';
        box.file("broken.TAMtbl", bytes);
        const ProgramRun run = box.run({"inspect", "broken.TAMtbl", "--json"});
        VERIFY_CODE(run, 3);
        QVERIFY2(run.err.startsWith("error: InvalidTable: "), run.err.constData());
        const QJsonObject error = run.json().value("error").toObject();
        QCOMPARE(error.value("code").toString(), "InvalidTable");
        QCOMPARE(error.value("context").toObject().value("offset").toString(), "0");
    }

    void tableDimensionsMustAgree()
    {
        const Sandbox box;
        box.file("t.csv", line1D);
        VERIFY_CODE(box.run({"convert", "t.csv", "t.TAMtbl", "--dims", "1"}), 0);
        const ProgramRun run = box.run({"inspect", "t.TAMtbl", "--dims", "2"});
        VERIFY_CODE(run, 2);
        QVERIFY2(run.err.startsWith("error: DimensionMismatch: "), run.err.constData());
    }

    void aResultThatCannotBeWrittenIsAnError()
    {
        const Sandbox box;
        box.file("t.csv", line1D);
        const ProgramRun run =
            box.run({"convert", "t.csv", "no/such/folder/t.TAMtbl", "--dims", "1"});
        VERIFY_CODE(run, 1);
        QVERIFY2(run.err.startsWith("error: FileNotWritable: "), run.err.constData());
        const ProgramRun full = box.runProgram(QStringLiteral("/bin/sh"),
            {"-c", test::axiscompProgram() + QStringLiteral(" example --dims 3 > /dev/full")});
        VERIFY_CODE(full, 1);
        QVERIFY2(full.err.startsWith("error: FileNotWritable: "), full.err.constData());
    }

    void persistencyIsOnlyForFormatsThatHoldIt()
    {
        const Sandbox box;
        box.file("t.csv", line1D);
        const ProgramRun run =
            box.run({"convert", "t.csv", "o.csv", "--dims", "1", "--persistent"});
        VERIFY_CODE(run, 2);
    }

    void formatsListsWhatTheyHold()
    {
        const Sandbox box;
        const ProgramRun run = box.run({"formats", "--json"});
        VERIFY_CODE(run, 0);
        const QJsonArray formats = run.json().value("formats").toArray();
        QVERIFY(formats.size() > 2);
        QCOMPARE(formats.at(0).toObject().value("name").toString(), "csv");
        QCOMPARE(formats.at(1).toObject().value("extension").toString(), ".TAMtbl");
        QCOMPARE(formats.at(1).toObject().value("persistency").toBool(), true);
        // As `formats NAME` says it: columns of one table are no tables of their own.
        for (const QJsonValue& value : formats) {
            const QJsonObject format = value.toObject();
            const ProgramRun one = box.run({"formats", format.value("name").toString()});
            QCOMPARE(one.out.contains("several tables in a file"),
                format.value("severalTables").toBool());
            QCOMPARE(one.out.contains(", one column"), !format.value("severalColumns").toBool());
        }
        const ProgramRun text = box.run({"formats"});
        QVERIFY(text.out.contains("tamtbl"));
    }

    void progressIsOnlyForTerminals()
    {
        const Sandbox box;
        box.file("t.csv", line1D);
        const QString command = "'" + test::axiscompProgram() + "' convert t.csv t.TAMtbl --dims 1";
        const ProgramRun terminal =
            box.runProgram("script", {"--quiet", "--return", "--command", command, "/dev/null"});
        VERIFY_CODE(terminal, 0);
        QVERIFY2(terminal.out.contains("%  reading t.csv"), terminal.out.constData());
        // The line is cleared before anything else is said.
        QVERIFY2(terminal.out.contains("\r\033[KWrote t.TAMtbl"), terminal.out.constData());
        const ProgramRun plain = box.runProgram("/bin/sh", {"-c", command});
        VERIFY_CODE(plain, 0);
        QCOMPARE(plain.err, QByteArray());
    }

    void resultsAndTheDocumentCannotShareStandardOutput()
    {
        const Sandbox box;
        const ProgramRun run = box.run({"example", "--dims", "1", "--json"});
        VERIFY_CODE(run, 2);
        QCOMPARE(run.json().value("error").toObject().value("code").toString(), "InvalidArgument");
    }
};

AXISCOMP_TEST(tst_OfflineCommands)

} // namespace tst_offlinecommands

#include "tst_offlinecommands.moc"
