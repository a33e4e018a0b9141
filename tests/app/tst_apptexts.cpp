// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output/status_text.h"
#include "app/cli/output/write_text.h"
#include "app/common/console.h"
#include "app/common/number_text.h"
#include "app/common/text_table.h"
#include "app/virtualdrive/drive_options.h"
#include "drivecomm/profile/profile_loader.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

namespace tst_apptexts {

using namespace axiscomp;
using namespace axiscomp::app;

class tst_AppTexts : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void numbersForPeopleAreShort_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("text");
        QTest::newRow("whole") << 40.0 << "40";
        QTest::newRow("float32") << static_cast<double>(0.0021F) << "0.0021";
        QTest::newRow("negative float32") << static_cast<double>(-0.1F) << "-0.1";
        QTest::newRow("double") << 0.1 << "0.1";
        QTest::newRow("third") << 1.0 / 3.0 << "0.3333333";
        QTest::newRow("large") << 2000000.5 << "2000000.5";
    }
    void numbersForPeopleAreShort()
    {
        QFETCH(const double, value);
        QTEST(QString::fromStdString(shortText(value)), "text");
    }

    void numbersOfAColumnHaveTheSameDecimals()
    {
        QCOMPARE(columnTexts({5.0, 12.25, -100.0}),
            (std::vector<std::string>{"5.00", "12.25", "-100.00"}));
        QCOMPARE(columnTexts({1.0 / 3.0, 20.0}), (std::vector<std::string>{"0.33333", "20.00000"}));
        QCOMPARE(columnTexts({static_cast<double>(0.0021F), 0.0}),
            (std::vector<std::string>{"0.0021", "0.0000"}));
        QCOMPARE(columnTexts({}), std::vector<std::string>{});
    }

    void numbersAreReadWithoutGuessing_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("valid");
        QTest::addColumn<double>("value");
        QTest::newRow("plain") << "12.5" << true << 12.5;
        QTest::newRow("negative") << "-0.5" << true << -0.5;
        QTest::newRow("plus") << "+3" << true << 3.0;
        QTest::newRow("exponent") << "-1e-3" << true << -0.001;
        QTest::newRow("comma") << "1,5" << false << 0.0;
        QTest::newRow("two signs") << "+-3" << false << 0.0;
        QTest::newRow("double plus") << "++3" << false << 0.0;
        QTest::newRow("infinite") << "inf" << false << 0.0;
        QTest::newRow("not a number") << "nan" << false << 0.0;
        QTest::newRow("unit") << "3mm" << false << 0.0;
        QTest::newRow("empty") << "" << false << 0.0;
    }
    void numbersAreReadWithoutGuessing()
    {
        QFETCH(const QString, text);
        QFETCH(const bool, valid);
        const auto number = numberFromText(text.toStdString());
        QCOMPARE(number.has_value(), valid);
        if (valid)
            QTEST(*number, "value");
    }

    void aSizeThatTheDriveDoesNotShowHasNoLastPosition()
    {
        AxisStatus status;
        status.axis.stateWord = "Disabled";
        status.setup.slot = "Small1";
        status.setup.dimensionality = 1;
        status.table = TableHeader{};
        GridAxis axis;
        axis.start = -10.0;
        axis.distance = 5.0;
        for (const std::uint32_t size : {3U, 0U}) {
            axis.size = size;
            status.table->grid.axes = {axis};
            const std::string text = statusText(status, drivecomm::genericProfile());
            const QString row = size == 0 ? QStringLiteral(" 1 -10 5 - - not set")
                                          : QStringLiteral(" 1 -10 5 3 0 not set");
            QVERIFY2(QString::fromStdString(text).simplified().contains(row), text.c_str());
        }
    }

    void countsAreGrouped()
    {
        QCOMPARE(countText(7), "7");
        QCOMPARE(countText(304), "304");
        QCOMPARE(countText(2096976), "2 096 976");
        QCOMPARE(plural(1, "value", "values"), "1 value");
        QCOMPARE(plural(20, "value", "values"), "20 values");
    }

    void columnsAreAlignedByCharactersNotBytes()
    {
        TextTable table({"name", ">size", "unit"});
        table.add({"Länge", "5", "µm"});
        table.add({"X", "1 000", ""});
        QCOMPARE(table.text(""), "name    size  unit\nLänge      5  µm\nX      1 000\n");
    }

    void textOfOthersCannotCommandTheTerminal()
    {
        QCOMPARE(singleLine("a\033[2Jb\nc\x7f"), "a [2Jb c ");
    }

    void signSentenceSaysWhatTheDriveAdds_data()
    {
        QTest::addColumn<QVector<float>>("values");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("positive")
            << QVector<float>{0.0F, 0.0021F, 0.001F}
            << "where the encoder reads 40.0000 the reference says 40.0021: the drive will add "
               "+0.0021 mm";
        QTest::newRow("negative")
            << QVector<float>{0.0F, 0.001F, -0.5F}
            << "where the encoder reads 80.0 the reference says 79.5: the drive will add -0.5 mm";
        QTest::newRow("zero") << QVector<float>{0.0F, 0.0F, 0.0F}
                              << "all values are 0: the drive will add nothing";
    }
    void signSentenceSaysWhatTheDriveAdds()
    {
        QFETCH(const QVector<float>, values);
        CompensationTable table;
        table.grid.axes = {{"X", "mm", 0.0, 40.0, 3}};
        table.values.assign(values.begin(), values.end());
        QTEST(QString::fromStdString(signSentence(table, "mm")), "sentence");
    }

    void atTheSetPositionNobodyKnowsWhatTheEncoderReads()
    {
        CompensationTable table;
        table.grid.axes = {{"X", "mm", 0.0, 40.0, 3}};
        table.values = {0.0F, 0.0021F, 0.001F};
        QCOMPARE(signSentence(table, "mm", {LookupAt::Set}),
            "at the set position 40.0000 the drive will add +0.0021 mm");
    }

    void atATemperatureNobodyKnowsWhatTheEncoderReads()
    {
        CompensationTable table;
        table.grid.axes = {{"T", "degC", 20.0, 20.0, 2}};
        table.values = {0.0F, 0.0021F};
        for (const auto lookupAt : {std::optional<LookupAt>(), std::optional(LookupAt::Set)})
            QCOMPARE(signSentence(table, "mm", {lookupAt, false}),
                "where the source reads 40 the reference is 0.0021 mm above the encoder: the drive "
                "will add +0.0021 mm");
    }

    /// What was smoothed, corrected or lies between the targets no reference has said.
    void whatWasComputedNoReferenceSays()
    {
        CompensationTable table;
        table.grid.axes = {{"X", "mm", 0.0, 40.0, 3}};
        table.values = {0.0F, 0.0021F, 0.001F};
        QCOMPARE(signSentence(table, "mm", {LookupAt::Encoder, true, true}),
            "where the encoder reads 40 the drive will add +0.0021 mm");
        QCOMPARE(signSentence(table, "mm", {LookupAt::Encoder, false, true}),
            "where the source reads 40 the drive will add +0.0021 mm");
    }

    void signSentenceNamesAllSources()
    {
        CompensationTable table;
        table.grid.axes = {{"X", "mm", 0.0, 10.0, 2}, {"Y", "mm", 5.0, 1.0, 2}};
        table.values = {0.0F, 0.1F, -0.25F, 0.0F};
        QCOMPARE(signSentence(table, "mm"),
            "where the sources read 0 and 6 the reference is 0.25 mm below the encoder: the drive "
            "will add -0.25 mm");
    }

    void addressOfTheVirtualDrive_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("valid");
        QTest::addColumn<QString>("host");
        QTest::addColumn<int>("port");
        QTest::newRow("IPv4") << "127.0.0.1:8080" << true << "127.0.0.1" << 8080;
        QTest::newRow("name") << "localhost:0" << true << "localhost" << 0;
        QTest::newRow("IPv6") << "[::1]:80" << true << "::1" << 80;
        QTest::newRow("no port") << "127.0.0.1" << false << "" << 0;
        QTest::newRow("no host") << ":8080" << false << "" << 0;
        QTest::newRow("large port") << "127.0.0.1:65536" << false << "" << 0;
        QTest::newRow("text") << "127.0.0.1:80x" << false << "" << 0;
    }
    void addressOfTheVirtualDrive()
    {
        QFETCH(const QString, text);
        QFETCH(const bool, valid);
        const auto address = parseHostAndPort(text.toStdString());
        if (!valid) {
            VERIFY_ERROR(address, ErrorCode::InvalidArgument);
            return;
        }
        VERIFY_RESULT(address);
        QTEST(QString::fromStdString(address->host), "host");
        QTEST(static_cast<int>(address->port), "port");
    }

    void drivesOfDifferentNamesAreDifferentDrives()
    {
        VirtualDriveArguments arguments;
        const auto usual = drivesOf(arguments);
        VERIFY_RESULT(usual);
        arguments.name = "Press 7";
        const auto first = drivesOf(arguments);
        const auto again = drivesOf(arguments);
        VERIFY_RESULT(first);
        VERIFY_RESULT(again);
        QCOMPARE(first->front().serialNumber, again->front().serialNumber);
        QVERIFY(first->front().serialNumber != usual->front().serialNumber);
    }

    void stateFolderIsNeverOutsideOfTheGivenOne()
    {
        VirtualDriveArguments arguments;
        arguments.stateFolder = "/var/state";
        arguments.name = "../../etc";
        const auto drives = drivesOf(arguments);
        VERIFY_RESULT(drives);
        QCOMPARE(drives->front().stateFolder.parent_path(), std::filesystem::path("/var/state"));
    }
};

AXISCOMP_TEST(tst_AppTexts)

} // namespace tst_apptexts

#include "tst_apptexts.moc"
