// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/file_kind.h"
#include "core/csv/calibration_csv.h"
#include "tests/core/formats/format_sample.h"
#include "tests/core/metrology/measurement_reading.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTemporaryDir>
#include <QTest>

#include <fstream>

namespace tst_filekind {

using namespace axiscomp;

namespace {

const std::string runs = "target [mm],direction,run,deviation [um]\n0,up,1,0.1\n10,up,1,0.4\n"
                         "10,down,1,0.9\n0,down,1,0.3\n";

} // namespace

class TestFileKind : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theNameTellsInUpperAndLowerCase_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("kind");
        const auto row = [](const char* name, FileKind kind) {
            QTest::newRow(name) << QString::fromUtf8(name) << static_cast<int>(kind);
        };
        row("job.axcal", FileKind::Record);
        row("JOB.AXCAL", FileKind::Record);
        row("machine.toml", FileKind::MachineFile);
        row("mill.machine.TOML", FileKind::MachineFile);
        row("drives.TAMcfg", FileKind::Configuration);
        row("drives.tamcfg", FileKind::Configuration);
        row("Small1.TAMtbl", FileKind::Table);
        row("small1.tamtbl", FileKind::Table);
    }
    void theNameTellsInUpperAndLowerCase()
    {
        QFETCH(const QString, name);
        QFETCH(const int, kind);
        const auto found = kindOfFile("\x01\x02\x03", name.toStdString());
        VERIFY_RESULT(found);
        QCOMPARE(static_cast<int>(*found), kind);
    }

    void recordsAndConfigurationsAreKnownByTheirContentToo()
    {
        const auto record =
            kindOfFile(R"({"format": "axiscomp-record", "version": 1})", "job.json");
        VERIFY_RESULT(record);
        QVERIFY(*record == FileKind::Record);
        const auto configuration =
            kindOfFile("<?xml version=\"1.0\"?>\n<TamTopology Version=\"Tam.3\">", "drives.xml");
        VERIFY_RESULT(configuration);
        QVERIFY(*configuration == FileKind::Configuration);
    }

    void theFilesOfEveryControllerAreTables()
    {
        int tried = 0;
        for (const auto& [format, describe] : test::describedFormats()) {
            test::FormatSample sample;
            describe(sample);
            if (sample.text.empty())
                continue;
            const std::string name = "file" + std::string(format->facts.extensions.front());
            const auto kind = kindOfFile(sample.text, name);
            ++tried;
            if (sample.isOnlyNamed)
                VERIFY_ERROR(kind, ErrorCode::UnknownFormat);
            else
                QVERIFY2(kind && *kind == FileKind::Table, format->facts.name.data());
        }
        QVERIFY(tried > 20);
        for (int dimensions = 1; dimensions <= 3; ++dimensions) {
            const auto kind = kindOfFile(exampleCalibrationCsv(dimensions), "calibration.csv");
            QVERIFY(kind && *kind == FileKind::Table);
        }
    }

    void aFileOfRunsIsAMeasurementAndNoTable()
    {
        const auto kind = kindOfFile(runs, "before.csv");
        VERIFY_RESULT(kind);
        QVERIFY(*kind == FileKind::Measurement);
        const auto published = kindOfFile(test::publicMeasurement("ess_mcu1025.csv"), "x.csv");
        VERIFY_RESULT(published);
        QVERIFY(*published == FileKind::Measurement);
    }

    void whatIsNothingOfAllThatIsSaidWithItsName_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("name");
        QTest::newRow("picture") << QByteArray("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16) << "plot.png";
        QTest::newRow("prose") << QByteArray("Dear customer,\nthank you.\n") << "letter.txt";
        QTest::newRow("other JSON") << QByteArray("{\"name\": \"backup\"}") << "backup.json";
        QTest::newRow("empty") << QByteArray() << "empty";
    }
    void whatIsNothingOfAllThatIsSaidWithItsName()
    {
        QFETCH(const QByteArray, content);
        QFETCH(const QString, name);
        const auto kind =
            kindOfFile(std::string_view(content.data(), static_cast<std::size_t>(content.size())),
                name.toStdString());
        QVERIFY(!kind);
        QCOMPARE(kind.error().code, ErrorCode::UnknownFormat);
        const QString sentence = QString::fromStdString(textOf(kind.error()).english());
        QVERIFY2(sentence.startsWith(name + QStringLiteral(" is no record (.axcal)")),
            qPrintable(sentence));
    }

    void aFileThatIsNotThereIsNotOfAnUnknownFormat()
    {
        const QTemporaryDir folder;
        const std::filesystem::path root = folder.path().toStdString();
        const auto missing = kindOfFile(root / "missing.axcal");
        QVERIFY(!missing);
        QCOMPARE(missing.error().code, ErrorCode::FileNotReadable);
        const auto aFolder = kindOfFile(root);
        QVERIFY(!aFolder);
        QCOMPARE(aFolder.error().code, ErrorCode::FileNotReadable);
        std::ofstream(root / "before.csv") << runs;
        const auto there = kindOfFile(root / "before.csv");
        VERIFY_RESULT(there);
        QVERIFY(*there == FileKind::Measurement);
    }
};

AXISCOMP_TEST(TestFileKind)

} // namespace tst_filekind

#include "tst_filekind.moc"
