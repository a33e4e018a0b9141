// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/formats/measurement_format.h"
#include "core/metrology/record/calibration_record.h"
#include "tests/app/program_run.h"
#include "tests/support/file_content.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QFile>
#include <QJsonArray>
#include <QTest>

namespace tst_reportcommand {

using namespace axiscomp;
using test::ProgramRun;
using test::Sandbox;

namespace {

RecordedMeasurement recorded(const std::string& name, double scale)
{
    const std::string text =
        test::contentOf(AXISCOMP_SOURCE_FOLDER "/tests/data/metrology/" + name);
    const auto format = measurementFormatNamed("runs");
    RecordedFile file;
    file.measurement = (*format)->read(text, {}).measurement.value_or(Measurement{});
    for (RunValue& value : file.measurement.values)
        value.deviation *= scale;
    file.measurement.header.machine = "Mill 7";
    file.measurement.header.axis = "X";
    file.measurement.header.date = "2026-11-20";
    file.file = scale == 1.0 ? "before.csv" : "after.csv";
    file.format = "runs";
    file.sha256 = std::string(64, scale == 1.0 ? 'a' : 'b');
    RecordedMeasurement measurement;
    measurement.files = {file};
    return measurement;
}

CalibrationRecord wholeRecord()
{
    CalibrationRecord record;
    record.program = "axiscomp 0.1";
    record.before = recorded("bifrost.csv", 1.0);
    record.fit.emplace();
    record.fit->settings.zero = FitZero::Keep; // as the values of the table are
    RecordedTable table;
    table.table.unit = "mm";
    table.table.grid.axes = {{"X", "mm", 15.0, 10.2, 5}};
    table.table.values = {0.003226F, -0.001888F, 0.000615F, -0.008452F, 0.0065F};
    table.crc = tableCrc(table.table);
    record.tables = {table};
    record.prediction.emplace();
    record.prediction->predicted.values[static_cast<std::size_t>(Iso230Figure::A)] = 0.0083537;
    record.prediction->heldOut.emplace();
    record.prediction->heldOut->range = 0.0177945;
    record.drive.emplace();
    record.drive->name = "Triamec-616";
    record.drive->serialNumber = 9087;
    record.drive->profile = "generic";
    record.write.emplace();
    record.write->slot = "small3";
    record.write->isPersistent = true;
    record.write->proof = RecordedWrite::Proof{true, 12, 0.0, 1e-9, 0.83};
    RecordedAfter after;
    after.measurement = recorded("bifrost.csv", 0.1);
    record.after = {after};
    record.verdict.emplace();
    record.verdict->figures = {
        {{Iso230Figure::A, 0.005}, 0.00185713, 0.0011, VerdictResult::Passed}};
    record.notes = {"after a change of the belt"};
    return record;
}

QString recordIn(const Sandbox& box, const CalibrationRecord& record)
{
    return box.file("job.axcal", QByteArray::fromStdString(recordText(record)));
}

/// What a reader of the PDF can select as text.
QByteArray textOfPdf(const Sandbox& box, const QString& name)
{
    return box.runProgram("pdftotext", {"-layout", box.path(name), "-"}).out;
}

} // namespace

class tst_ReportCommand : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aPdfHasEverythingOfTheRecordOnOnePage()
    {
        const Sandbox box;
        const ProgramRun run = box.run({"report", recordIn(box, wholeRecord()), "-o", "r.pdf"});
        VERIFY_CODE(run, 0);
        QCOMPARE(run.out, QByteArray("Report written to r.pdf\n"));
        QCOMPARE(run.err, QByteArray());
        const QByteArray text = textOfPdf(box, "r.pdf");
        for (const char* fact : {"Compensation of axis X, machine Mill 7", "18.57", "1.86",
                 "Triamec-616", "9087", "generic", "2026-11-20", "not stated",
                 "5 targets from 15 to 55.8 mm, 5 runs ↑, 5 runs ↓", "8.35", "17.79",
                 "5 points from 15 to 55.8 mm", "linear", "small3", "persistent",
                 "passed over 83 % of the table",
                 "Where the encoder reads 45.6000 mm, the reference said 45.5915 mm: the drive "
                 "adds -8.452 µm.",
                 "after a change of the belt", "before.csv", "after.csv", "5.00 µm", "1.10 µm",
                 "passed", "Deviation in µm", "Position in mm"})
            QVERIFY2(text.contains(fact), (QByteArray(fact) + " in\n" + text).constData());
        QVERIFY(text.contains(QByteArray(64, 'a')));
        QVERIFY(text.contains(QByteArray(64, 'b')));
        const QByteArray info = box.runProgram("pdfinfo", {box.path("r.pdf")}).out;
        QVERIFY2(info.contains("Pages:           1\n"), info.constData());
        QVERIFY2(info.contains("(A4)"), info.constData());
        QVERIFY(box.content("r.pdf").contains("<pdfaid:part>1</pdfaid:part>")
            || box.content("r.pdf").contains("pdfaid:part=\"1\""));
    }

    /// With its zero moved, a value of the table is not what the reference showed there.
    void theReferenceIsNotSaidToHaveShownWhatWasMoved()
    {
        const Sandbox box;
        CalibrationRecord record = wholeRecord();
        record.fit->settings.zero = FitZero::First;
        VERIFY_CODE(box.run({"report", recordIn(box, record), "-o", "r.html"}), 0);
        const QByteArray html = box.content("r.html");
        QVERIFY(html.contains("Where the encoder reads 45.6000 mm, the drive adds -8.452"));
        QVERIFY(!html.contains("the reference said"));
    }

    void aFullRecordIsStillOnePage()
    {
        const Sandbox box;
        CalibrationRecord record = wholeRecord();
        record.notes.assign(12, std::string(400, 'n'));
        record.before->files.front().file = std::string(150, 'f');
        record.drive->name = std::string(150, 'd');
        VERIFY_CODE(box.run({"report", recordIn(box, record), "-o", "r.pdf"}), 0);
        QVERIFY(
            box.runProgram("pdfinfo", {box.path("r.pdf")}).out.contains("Pages:           1\n"));
        VERIFY_CODE(box.run({"report", box.path("job.axcal"), "-o", "r.pdf", "--lists"}), 0);
        QVERIFY(
            !box.runProgram("pdfinfo", {box.path("r.pdf")}).out.contains("Pages:           1\n"));
    }

    void aReportIsInTheLanguageAskedFor()
    {
        const Sandbox box;
        const QString record = recordIn(box, wholeRecord());
        VERIFY_CODE(box.run({"report", record, "-o", "r.pdf", "--language", "de"}), 0);
        const QByteArray text = textOfPdf(box, "r.pdf");
        QVERIFY2(text.contains("18,57") && text.contains("nicht angegeben"), text.constData());
        QVERIFY2(!text.contains("18.57") && !text.contains("not stated"), text.constData());
        VERIFY_CODE(box.run({"report", record, "-o", "r.html", "--language", "de"}), 0);
        QVERIFY(box.content("r.html").contains("<html lang=\"de\">"));
        QVERIFY(box.content("r.html").contains("18,57"));
        const ProgramRun unknown = box.run({"report", record, "-o", "x.pdf", "--language", "xx"});
        VERIFY_CODE(unknown, 2);
        QVERIFY2(unknown.err.contains("a report is written in en, de"), unknown.err.constData());
    }

    void htmlIsValid()
    {
        const Sandbox box;
        CalibrationRecord record = wholeRecord();
        record.notes = {"<b>&\"'</p>"};
        const QString file = recordIn(box, record);
        VERIFY_CODE(box.run({"report", file, "-o", "r.html", "--lists"}), 0);
        const ProgramRun parsed = box.runProgram("/usr/bin/python3",
            {"-c",
                "import html5lib, sys; html5lib.HTMLParser(strict=True).parse(open(sys.argv[1], "
                "encoding='utf-8'))",
                box.path("r.html")});
        QVERIFY2(parsed.code == 0, parsed.err.constData());
    }

    void jsonHasTheFigures()
    {
        const Sandbox box;
        const ProgramRun run =
            box.run({"report", recordIn(box, wholeRecord()), "-o", "r.html", "--json"});
        VERIFY_CODE(run, 0);
        const QJsonObject json = run.json();
        QCOMPARE(json.keys(),
            (QStringList{"after", "afterOfAllValues", "before", "beforeOfAllValues", "heldOut",
                "language", "output", "predicted", "record", "source", "unit", "verdict",
                "verdictOfAllValues", "warnings"}));
        QVERIFY(std::abs(json["before"].toObject()["A"].toDouble() - 0.0185713) < 1e-6);
        QVERIFY(std::abs(json["after"].toObject()["A"].toDouble() - 0.00185713) < 1e-6);
        QVERIFY(json["predicted"].toObject()["R"].isNull());
        QVERIFY(json["afterOfAllValues"].isNull() && json["warnings"].toArray().isEmpty());
    }

    void whatIsLeftOutIsOnTheReportWithTheVerdictOfAllValues()
    {
        const Sandbox box;
        CalibrationRecord record = wholeRecord();
        record.after[0].measurement.files[0].measurement.values[7].deviation = 0.05;
        record.after[0].measurement.exclusions = {{Approach::Up, 2, 3}};
        const ProgramRun run = box.run({"report", recordIn(box, record), "-o", "r.pdf", "--json"});
        VERIFY_CODE(run, 0);
        const QJsonObject json = run.json();
        QVERIFY(json["beforeOfAllValues"].isNull());
        QVERIFY(json["afterOfAllValues"].toObject()["A"].toDouble() > 0.05);
        const auto result = [&json](const char* verdict) {
            return json[QLatin1String(verdict)].toArray().at(0)["result"].toString();
        };
        QCOMPARE(result("verdict"), "passed");
        QCOMPARE(result("verdictOfAllValues"), "failed");
        QCOMPARE(json["warnings"].toArray().at(0)["code"].toString(), "OtherVerdict");
        const QByteArray text = textOfPdf(box, "r.pdf");
        QVERIFY2(text.contains("Warning: of all values accuracy A is "), text.constData());
        QVERIFY2(text.contains("all values"), text.constData());
        QVERIFY(
            box.runProgram("pdfinfo", {box.path("r.pdf")}).out.contains("Pages:           1\n"));
    }

    /// U+0378 is assigned to no character, so that no font has it.
    void aCharacterThatNoFontHasIsRefusedInAPdf()
    {
        const Sandbox box;
        CalibrationRecord record = wholeRecord();
        record.drive->name = "M\u00fchle \u0378";
        const QString file = recordIn(box, record);
        const ProgramRun run = box.run({"report", file, "-o", "r.pdf"});
        VERIFY_CODE(run, 2);
        QVERIFY2(run.err.contains("no installed font has \u0378, so that empty boxes"),
            run.err.constData());
        QVERIFY(!QFile::exists(box.path("r.pdf")));
        VERIFY_CODE(box.run({"report", file, "-o", "r.html"}), 0);
        QVERIFY(box.content("r.html").contains("\u0378"));
        record.drive->name = "tab\tand line\n"; // no page has them
        VERIFY_CODE(box.run({"report", recordIn(box, record), "-o", "r.pdf"}), 0);
    }

    void whatIsNoReportIsRefused()
    {
        const Sandbox box;
        const QString record = recordIn(box, wholeRecord());
        const ProgramRun run = box.run({"report", record, "-o", "r.txt"});
        VERIFY_CODE(run, 2);
        QVERIFY2(run.err.contains("ends in .pdf or .html"), run.err.constData());
        const QString broken = box.file("broken.axcal", "{\"format\": 1");
        const ProgramRun none = box.run({"report", broken, "-o", "r.html"});
        VERIFY_CODE(none, 3);
        QVERIFY2(none.err.contains("InvalidRecord"), none.err.constData());
        QVERIFY(!QFile::exists(box.path("r.html")));
    }

    void onlyAReportLoadsQtGui()
    {
        const Sandbox box;
        const QByteArray libraries = box.runProgram("ldd", {test::axiscompProgram()}).out;
        QVERIFY(libraries.contains("libQt6Core"));
        QVERIFY2(!libraries.contains("libQt6Gui"), libraries.constData());
    }
};

AXISCOMP_TEST(tst_ReportCommand)

} // namespace tst_reportcommand

#include "tst_reportcommand.moc"
