// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/compensator_fixture.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "tests/ui/support/brackets.h"
#include "ui/session/axis_list.h"
#include "ui/text/endpoint_text.h"
#include "ui/text/message_text.h"
#include "ui/text/sign_sentence.h"

#include <QTest>

namespace tst_wizardtexts {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::Brackets;

namespace {

LoadedTable kept(CompensationTable table)
{
    return loaded(std::make_shared<const CompensationTable>(std::move(table)));
}

LoadedTable table1D(std::vector<float> values, const char* unit = "mm")
{
    CompensationTable table;
    table.unit = unit;
    table.grid.axes = {{.name = "X",
        .unit = "mm",
        .start = 0.0,
        .distance = 10.0,
        .size = static_cast<std::uint32_t>(values.size())}};
    table.values = std::move(values);
    return kept(std::move(table));
}

AxisInfo axisX(const char* unit = "Millimeter")
{
    AxisInfo axis;
    axis.folder = "Axes[0]/";
    axis.name = "X";
    axis.unit = unit;
    return axis;
}

DriveAxes drive(const char* endpoint, const char* name, int serial, std::vector<std::string> names)
{
    DriveAxes drive;
    drive.endpoint = QString::fromUtf8(endpoint);
    drive.isConnected = true;
    drive.drive = {name, serial, static_cast<int>(names.size())};
    for (std::size_t i = 0; i < names.size(); ++i) {
        AxisInfo axis;
        axis.index = static_cast<int>(i);
        axis.name = names[i];
        axis.stateWord = "Disabled";
        drive.axes.push_back(axis);
    }
    return drive;
}

} // namespace

class TestWizardTexts : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void anErrorIsASentenceWithItsNumbers()
    {
        QCOMPARE(errorText({ErrorCode::TableTooLarge,
                     {{"size", 70000}, {"largest", 63360}, {"slot", Verbatim{"Small1"}}}, {}}),
            QStringLiteral("The table needs 70000 bytes, but the largest slot that may be taken, "
                           "Small1, holds 63360."));
        // An address stays as it is written.
        QCOMPARE(errorText({ErrorCode::Timeout,
                     {{"endpoint", Verbatim{"http://x"}}, {"seconds", 5}}, {}}),
            QStringLiteral("http://x did not answer within 5 s."));
    }

    void everyWarningOfAPlanIsKnown()
    {
        test::CompensatorFixture fixture;
        VERIFY_RESULT(
            fixture.compensator.write(0, test::exampleRequest(1, Persistency::Persistent)));
        WriteRequest other = test::exampleRequest(3);
        VERIFY_RESULT(fixture.compensator.write(1, other));
        const auto toVolatile = fixture.compensator.plan(0, test::exampleRequest(2));
        VERIFY_RESULT(toVolatile);
        const auto saved =
            fixture.compensator.plan(0, test::exampleRequest(2, Persistency::Persistent));
        VERIFY_RESULT(saved);
        WriteRequest named = test::exampleRequest(2);
        named.slot = "Small5";
        const auto intoSlot = fixture.compensator.plan(0, named);
        VERIFY_RESULT(intoSlot);
        WriteRequest wrongUnit = test::exampleRequest(2);
        wrongUnit.table->unit = "um";
        const auto tooLarge = fixture.compensator.plan(0, wrongUnit);
        VERIFY_RESULT(tooLarge);
        wrongUnit.table->unit = "m";
        const auto tooSmall = fixture.compensator.plan(0, wrongUnit);
        VERIFY_RESULT(tooSmall);
        const Brackets translation;
        int warnings = 0;
        for (const auto* plan : {&toVolatile, &saved, &intoSlot, &tooLarge, &tooSmall}) {
            std::vector<Text> said = (*plan)->warnings;
            for (const auto& more : {(*plan)->unitRemarks, (*plan)->largeCorrections})
                said.insert(said.end(), more.begin(), more.end());
            for (const Text& warning : said) {
                QVERIFY2(sentenceText(warning).startsWith(u'\u2039'), warning.english().c_str());
                ++warnings;
            }
        }
        QVERIFY(warnings >= 9);
    }

    void everyProblemOfAFileHasItsSentence()
    {
        for (int code = 0; code <= static_cast<int>(DiagnosticCode::Assumption); ++code) {
            Diagnostic problem;
            problem.code = static_cast<DiagnosticCode>(code);
            problem.found = Verbatim{"what was found"};
            const QString text = problemText(problem);
            QVERIFY2(text.size() > 20, qPrintable(text));
            QVERIFY2(text.contains(QStringLiteral("what was found")), qPrintable(text));
            QVERIFY2(text.endsWith(u'.'), qPrintable(text));
        }
        QCOMPARE(problemText({Severity::Error, DiagnosticCode::NotANumber, 3, 2, Verbatim{"1,5x"},
                     Verbatim{"a number such as 0.5"}, {}}),
            QStringLiteral("This is not a number: found \"1,5x\", expected a number such as 0.5."));
        QCOMPARE(problemText({Severity::Error, DiagnosticCode::NotANumber, 3, 2, {}, {}, {}}),
            QStringLiteral("This is not a number: found an empty cell."));
    }

    void everyStepHasWords()
    {
        const Brackets translation;
        for (const char* step : {"plan", "backup", "begin", "switch off", "upload", "verify",
                 "commit", "switch", "save", "done", "putting back", "download"})
            QVERIFY2(stepText(QString::fromUtf8(step)).startsWith(u'\u2039'), step);
        QCOMPARE(stepText(QStringLiteral("unheard of")), QStringLiteral("unheard of"));
    }

    void signSentences_data()
    {
        QTest::addColumn<QByteArray>("values");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("positive")
            << QByteArray("0 0.001 0 0 0.0021 0")
            << QStringLiteral("where the encoder reads 40.0000 mm, the reference reads 40.0021 mm: "
                              "the drive will add +0.0021 mm");
        QTest::newRow("negative")
            << QByteArray("0 -0.0125 0")
            << QStringLiteral(
                   "where the encoder reads 10.000 mm, the reference reads 9.987 mm: the "
                   "drive will add -0.013 mm");
        QTest::newRow("nothing") << QByteArray("0 0 0")
                                 << QStringLiteral("all values are 0: the drive will add nothing");
    }
    void signSentences()
    {
        QFETCH(QByteArray, values);
        QFETCH(QString, sentence);
        std::vector<float> numbers;
        for (const QByteArray& value : values.split(' '))
            numbers.push_back(value.toFloat());
        QCOMPARE(signSentenceFor(table1D(numbers), axisX(), {0}), sentence);
    }

    /// What was smoothed, corrected or lies between the targets no reference has said.
    void whatWasComputedNoReferenceReads()
    {
        const LoadedTable table = table1D({0.0F, 0.0021F, 0.0F});
        QCOMPARE(signSentenceFor(table, axisX(), {0, LookupAt::Encoder, true}),
            QStringLiteral("where the encoder reads 10.0000 mm, the drive will add +0.0021 mm"));
        QVERIFY(
            !signSentenceFor(table, axisX(), {{}, {}, true}).contains(QStringLiteral("reference")));
    }

    void theSignSentencePromisesNothingThatCannotBeWritten()
    {
        QCOMPARE(signSentenceFor(table1D({0.0F, 2.1F, 0.0F}, "arcsec"), axisX(), {0}), QString());
        // A length, where the axis is known to have no unit.
        QCOMPARE(signSentenceFor(table1D({0.0F, 5.0F, 0.0F}, "um"), axisX("None"), {0}), QString());
        QCOMPARE(signSentenceFor(table1D({0.0F, 5.0F, 0.0F}, ""), axisX("None"), {0}), QString());
        // Positions of an angle are added to nothing in mm.
        CompensationTable turned = *table1D({0.0F, 2.1F, 0.0F}, "mm").table;
        turned.grid.axes[0].unit = "deg";
        QCOMPARE(signSentenceFor(kept(turned), axisX(), {0}), QString());
        QVERIFY(signSentenceFor(kept(turned), axisX(), {})
                    .contains(QStringLiteral("the reference reads 2.1 mm more")));
        QVERIFY(signSentenceFor(table1D({0.0F, 2.1F, 0.0F}, "mm"), axisX(), {0})
                    .contains(QStringLiteral("the drive will add +2.1 mm")));
    }

    void theSignSentenceNamesTheOtherDimensions()
    {
        CompensationTable table;
        table.grid.axes = {{.name = "X", .unit = "mm", .start = 0.0, .distance = 10.0, .size = 2},
            {.name = "Y", .unit = "mm", .start = 0.0, .distance = 30.0, .size = 2}};
        table.values = {0.0F, 0.0F, 0.0F, 0.0021F};
        QCOMPARE(signSentenceFor(kept(table), axisX(), {0}),
            QStringLiteral("at Y 30 mm, where the encoder reads 10.0000 mm, the reference reads "
                           "10.0021 mm: the drive will add +0.0021 mm"));
        // Over other axes only: what the encoder of this one reads is not in the table.
        AxisInfo z = axisX();
        z.index = 2;
        z.folder = "Axes[2]/";
        QCOMPARE(signSentenceFor(kept(table), z, {}),
            QStringLiteral("at X 10 mm, Y 30 mm the reference reads 0.0021 mm more than the "
                           "encoder: the drive will add +0.0021 mm"));
    }

    void atATemperatureTheSignSentenceTellsNoReadingOfTheEncoder()
    {
        CompensationTable table;
        table.grid.axes = {
            {.name = "T", .unit = "degC", .start = 20.0, .distance = 20.0, .size = 2}};
        table.values = {0.0F, 0.0021F};
        for (const auto lookupAt : {std::optional<LookupAt>(), std::optional(LookupAt::Set)})
            QCOMPARE(signSentenceFor(kept(table), axisX(), {{}, lookupAt}),
                QStringLiteral("at T 40 degC the reference reads 0.0021 mm more than the encoder: "
                               "the drive will add +0.0021 mm"));
    }

    void labelsSayAsMuchAsIsNeeded()
    {
        const std::vector<DriveAxes> drives{drive("http://1", "A", 1, {"X", "Y"}),
            drive("http://2", "A", 2, {"X", "X", ""}), drive("http://3", "A", 2, {"X"}),
            drive("http://4", "", 0, {"Z"})};
        QStringList labels;
        for (const AxisEntry& entry : axisEntries(drives))
            labels.append(entry.label);
        QCOMPARE(labels,
            (QStringList{QStringLiteral("X [0] · A #1"), QStringLiteral("Y · A"),
                QStringLiteral("X [0] · A #2 http://2"), QStringLiteral("X [1] · A"),
                QStringLiteral("Axis 2 · A"), QStringLiteral("X [0] · A #2 http://3"),
                QStringLiteral("Z · http://4")}));
    }

    void anAxisThatCannotBeUsedSaysWhy()
    {
        std::vector<DriveAxes> drives{drive("http://1", "A", 1, {"X", ""}),
            drive("http://2", "B", 2, {"X"}), drive("demo:", "C", 3, {"X"})};
        drives[0].axes[1].stateWord.clear(); // has no compensation registers
        drives[1].isConnected = false;
        drives[2].isDemo = true;
        const std::vector<AxisEntry> entries = axisEntries(drives);
        QStringList labels;
        QStringList problems;
        for (const AxisEntry& entry : entries) {
            labels.append(entry.label);
            problems.append(entry.problem);
            QCOMPARE(entry.isUsable, entry.problem.isEmpty());
            QCOMPARE(axisLabel(entry), entry.label);
        }
        QCOMPARE(labels,
            (QStringList{QStringLiteral("X · A"), QStringLiteral("Axis 1 · A (no compensation)"),
                QStringLiteral("X · B"), QStringLiteral("X · C (demo)")}));
        QCOMPARE(problems,
            (QStringList{QString(), QStringLiteral("This axis has no compensation registers."),
                QStringLiteral("The drive B is not connected."), QString()}));
    }

    void endpointsAreShownWithoutTheirPasswords_data()
    {
        QTest::addColumn<QString>("endpoint");
        QTest::addColumn<QString>("shown");
        const auto row = [](const char* endpoint, const char* shown) {
            QTest::newRow(endpoint) << QString::fromUtf8(endpoint) << QString::fromUtf8(shown);
        };
        row("http://192.168.1.20", "http://192.168.1.20");
        row("http://user:secret@host:8080/", "http://host:8080/");
        row("https://user:se@cr@et@host", "https://host");
        row(" demo: ", "demo:");
        row("user:secret@host", "host");
        row("http://user:12/34@host", "http://host");
        row("http://user:12#34@host", "http://host");
        row("serial:/dev/a@b", "serial:/dev/a@b");
        row("serial:/dev/ttyUSB0", "serial:/dev/ttyUSB0");
    }
    void endpointsAreShownWithoutTheirPasswords()
    {
        QFETCH(QString, endpoint);
        QFETCH(QString, shown);
        QCOMPARE(shownEndpoint(endpoint), shown);
    }
};

AXISCOMP_TEST(TestWizardTexts)

} // namespace tst_wizardtexts

#include "tst_wizardtexts.moc"
