// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/tam_table.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "tests/ui/support/controller_fixture.h"
#include "ui/text/message_text.h"

#include <QDir>
#include <QSignalSpy>
#include <QTest>

#include <filesystem>

namespace tst_datafilemodel {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::ControllerFixture;

namespace {

const QByteArray oneDimension =
    "X [mm],first [mm],second [mm]\n0,0.001,0.004\n1,0.002,0.005\n2,0.0,0.004\n";

/// How programs save a file.
enum class Saving { InPlace, DeleteAndRename, Rename };

QByteArray tamTable(int dimensions)
{
    const CompensationTable table = test::exampleTable(dimensions);
    const auto bytes = encodeTamTable(table, true, drivecomm::genericProfile().layout);
    return {reinterpret_cast<const char*>(bytes->data()), static_cast<qsizetype>(bytes->size())};
}

} // namespace

class TestDataFileModel : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void openingAFileChoosesItsFirstTable()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QSignalSpy selected(&bench.controller(), &WizardController::selectedTableChanged);
        const QString path = bench.file(QStringLiteral("a.csv"), oneDimension);
        bench->openData(path);
        QVERIFY(bench->dataFile().isReading);
        QCOMPARE(bench->dataFile().readingPath, path);
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->dataFile().path, path);
        QVERIFY(bench->dataFile().readingPath.isEmpty());
        QCOMPARE(bench->dataFile().data->tables.size(), std::size_t{2});
        QVERIFY(bench->dataFile().problems.empty());
        QCOMPARE(bench->setup().edited().table.fileTable, std::optional(0));
        QCOMPARE(bench->selectedTable()->name, "first");
        QCOMPARE(selected.count(), 1);
        bench->setup().setTable({1});
        QCOMPARE(bench->selectedTable()->name, "second");
        bench->closeData();
        QVERIFY(!bench->selectedTable());
        QVERIFY(!bench->setup().edited().table.fileTable);
        QVERIFY(bench->dataFile().path.isEmpty());
    }

    void aBadFileKeepsTheOldSelectionAndListsItsProblems()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        const QString good = bench.file(QStringLiteral("good.csv"), oneDimension);
        const QString bad =
            bench.file(QStringLiteral("bad.csv"), "X,table\n0,1\n1,two\n2,3\n3,nan\n");
        bench->openData(good);
        QVERIFY(bench.fileRead());
        bench->setup().setTable({1});
        const auto table = bench->selectedTable();
        bench->openData(bad);
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->selectedTable(), table);
        QCOMPARE(bench->dataFile().path, good);
        QCOMPARE(bench->dataFile().problemsPath, bad);
        QCOMPARE(bench->dataFile().problems.size(), std::size_t{2});
        QCOMPARE(bench->dataFile().problems[0].line, std::size_t{3});
        QCOMPARE(bench->dataFile().problems[0].column, std::size_t{2});
        QCOMPARE(bench->dataFile().problems[1].code, DiagnosticCode::NotFinite);
        // A good one again takes the problems away.
        bench->openData(good);
        QVERIFY(bench.fileRead());
        QVERIFY(bench->dataFile().problems.empty());
        QVERIFY(bench->dataFile().problemsPath.isEmpty());
    }

    void aFileThatIsNotThereIsAProblem_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("csv") << QStringLiteral("missing.csv");
        QTest::newRow("tam table") << QStringLiteral("missing.TAMtbl");
        QTest::newRow("a folder") << QStringLiteral(".");
    }
    void aFileThatIsNotThereIsAProblem()
    {
        QFETCH(QString, name);
        ControllerFixture bench;
        bench->openData(bench.path(name));
        QVERIFY(bench.fileRead());
        QVERIFY(!bench->dataFile().data);
        QCOMPARE(bench->dataFile().problems.size(), std::size_t{1});
        QCOMPARE(bench->dataFile().problems.front().code, DiagnosticCode::IoError);
        QCOMPARE(bench->dataFile().path, QDir::cleanPath(bench.path(name)));
        QVERIFY(!problemText(bench->dataFile().problems.front()).isEmpty());
    }

    void anotherDimensionalityReadsTheColumnsAgain()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        bench->setup().setDimensionality(2);
        bench->openData(bench.file(QStringLiteral("2d.csv"), ControllerFixture::calibration2D(1)));
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->selectedTable()->grid.dimensions(), 2);
        bench->setup().setTable({1});
        bench->setup().setDimensionality(1);
        QVERIFY(bench->dataFile().isReading);
        QVERIFY(bench.fileRead());
        // As 1D the same positions occur more than once: the 2D tables stay, and do not fit.
        QVERIFY(!bench->dataFile().problems.empty());
        QCOMPARE(bench->selectedTable()->grid.dimensions(), 2);
        bench->chooseSource(1, QString::fromStdString(test::masterX));
        QCOMPARE(bench->action(Action::Write).reason,
            QStringLiteral("The table has 2 dimensions, but 1D is chosen."));
        bench->setup().setDimensionality(2);
        QVERIFY(bench.fileRead());
        QVERIFY(bench->dataFile().problems.empty());
        QCOMPARE(bench->selectedTable()->name, "table 101"); // the one that was chosen
    }

    void aFileThatWasRefusedIsReadInTheDimensionalityThatIsChosenThen()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        const QString line = bench.file(QStringLiteral("line.csv"), oneDimension);
        const QString plane = bench.file(QStringLiteral("2d.csv"),
            "X [mm],Y [mm],E [mm]\n0,0,0.001\n10,0,0.002\n0,10,0.001\n10,10,0.003\n");
        bench->openData(line);
        QVERIFY(bench.fileRead());
        bench->openData(plane);
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->dataFile().path, line);
        QCOMPARE(bench->dataFile().refusedPath, plane);
        bench->setup().setDimensionality(3); // is not its own either
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->dataFile().path, line);
        QCOMPARE(bench->dataFile().problemsPath, plane);
        bench->setup().setDimensionality(2);
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->dataFile().path, plane);
        QVERIFY(bench->dataFile().problems.empty());
        QVERIFY(bench->dataFile().refusedPath.isEmpty());
        QCOMPARE(bench->selectedTable()->grid.dimensions(), 2);
    }

    void aTamTableThatWasRefusedIsNotReadAgainForItsDimensions()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        const QString line = bench.file(QStringLiteral("line.csv"), oneDimension);
        bench->openData(line);
        QVERIFY(bench.fileRead());
        QByteArray bytes = tamTable(2);
        bytes[0] = '?';
        bench->openData(bench.file(QStringLiteral("broken.TAMtbl"), bytes));
        QVERIFY(bench.fileRead());
        QVERIFY(bench->dataFile().refusedPath.isEmpty());
        bench->setup().setDimensionality(2);
        QCOMPARE(bench->dataFile().readingPath, line);
        QVERIFY(bench.fileRead());
    }

    void aTamTableKeepsItsOwnDimensions()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        const QString path = bench.file(QStringLiteral("kept.TAMtbl"), tamTable(3));
        bench->openData(path);
        QVERIFY(bench.fileRead());
        QVERIFY2(bench->dataFile().problems.empty(),
            bench->dataFile().problems.empty()
                ? ""
                : bench->dataFile().problems[0].found.english().c_str());
        QCOMPARE(bench->selectedTable()->grid.dimensions(), 3);
        QCOMPARE(bench->action(Action::Write).reason,
            QStringLiteral("The table has 3 dimensions, but 1D is chosen."));
        bench->setup().setDimensionality(3);
        QVERIFY(!bench->dataFile().isReading);
        QCOMPARE(bench->action(Action::Write).reason, QStringLiteral("Dim1 Source is missing."));
    }

    void aBrokenTamTableSaysWhere()
    {
        ControllerFixture bench;
        QByteArray bytes = tamTable(2);
        bytes[0] = '?';
        bench->openData(bench.file(QStringLiteral("broken.tamtbl"), bytes));
        QVERIFY(bench.fileRead());
        QVERIFY(!bench->dataFile().data);
        const QString text = problemText(bench->dataFile().problems.front());
        QVERIFY2(text.contains(QStringLiteral("magic at offset 0")), qPrintable(text));
    }

    void aTableThatIsTooLargeForEverySlotSaysBothNumbers()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        CalibrationData data;
        data.tables = {test::exampleTable(2, 1, 800)};
        data.grid = data.tables.front().grid;
        bench.chooseMasterSources();
        bench->openData(bench.file(
            QStringLiteral("huge.csv"), QByteArray::fromStdString(writeCalibrationCsv(data))));
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->action(Action::Write).reason,
            QStringLiteral("The table needs 2560128 bytes, but the largest slot has 2096976."));
    }

    void aFileThatChangesOnTheDiskIsNoticed_data()
    {
        QTest::addColumn<Saving>("saving");
        QTest::newRow("written to") << Saving::InPlace;
        QTest::newRow("deleted and replaced by another") << Saving::DeleteAndRename;
        QTest::newRow("replaced in one step") << Saving::Rename;
    }
    void aFileThatChangesOnTheDiskIsNoticed()
    {
        QFETCH(Saving, saving);
        ControllerFixture bench;
        const QString path = bench.file(QStringLiteral("a.csv"), oneDimension);
        bench->openData(path);
        QVERIFY(bench.fileRead());
        QVERIFY(!bench->dataFile().hasChangedOnDisk);
        const QByteArray changed = oneDimension + "3,0.003,0.004\n";
        for (int round = 0; round < 2; ++round) {
            const QByteArray content = changed + QByteArray(round, '\n');
            if (saving == Saving::InPlace) {
                (void)bench.file(QStringLiteral("a.csv"), content);
            } else {
                const QString other = bench.file(QStringLiteral("b.csv"), content);
                if (saving == Saving::DeleteAndRename)
                    QVERIFY(QFile::remove(path));
                std::filesystem::rename(other.toStdString(), path.toStdString());
            }
            QTRY_VERIFY(bench->dataFile().hasChangedOnDisk);
            QCOMPARE(bench->dataFile().data->grid.pointCount(), std::size_t(round ? 4 : 3));
            bench->openData(path);
            QVERIFY(bench.fileRead());
            QVERIFY(!bench->dataFile().hasChangedOnDisk);
            QCOMPARE(bench->dataFile().data->grid.pointCount(), std::size_t{4});
        }
    }

    void aDeletedFileKeepsItsDataAndIsOfferedWhenItIsBack()
    {
        ControllerFixture bench;
        const QString path = bench.file(QStringLiteral("a.csv"), oneDimension);
        bench->openData(path);
        QVERIFY(bench.fileRead());
        QVERIFY(QFile::remove(path));
        (void)bench.file(QStringLiteral("other.csv"), oneDimension); // something else happens there
        QVERIFY(!bench->dataFile().hasChangedOnDisk);
        QCOMPARE(bench->selectedTable()->name, "first");
        (void)bench.file(QStringLiteral("a.csv"), oneDimension + "3,0.003,0.004\n");
        QTRY_VERIFY(bench->dataFile().hasChangedOnDisk);
        bench->openData(path);
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->dataFile().data->grid.pointCount(), std::size_t{4});
    }

    void aFileThatIsReadHalfWrittenIsOfferedAgainWhenItIsWhole()
    {
        ControllerFixture bench;
        const QString path = bench.file(QStringLiteral("a.csv"), oneDimension);
        bench->openData(path);
        QVERIFY(bench.fileRead());
        const QByteArray whole = oneDimension + "3,0.003,0.004\n";
        (void)bench.file(QStringLiteral("a.csv"), whole.chopped(10)); // within the last line
        QTRY_VERIFY(bench->dataFile().hasChangedOnDisk);
        bench->openData(path);
        QVERIFY(bench.fileRead());
        QVERIFY(!bench->dataFile().problems.empty());
        QVERIFY(!bench->dataFile().hasChangedOnDisk);
        QCOMPARE(bench->dataFile().data->grid.pointCount(), std::size_t{3}); // as it was before
        (void)bench.file(QStringLiteral("a.csv"), whole);
        QTRY_VERIFY(bench->dataFile().hasChangedOnDisk);
        bench->openData(path);
        QVERIFY(bench.fileRead());
        QVERIFY(bench->dataFile().problems.empty());
        QCOMPARE(bench->dataFile().data->grid.pointCount(), std::size_t{4});
    }

    void aFileThatGrowsWhileItIsReadIsOfferedAgain()
    {
        ControllerFixture bench;
        QByteArray large = "X,table\n";
        for (int i = 0; i < 300'000; ++i)
            large += QByteArray::number(i) + ",0." + QByteArray::number(i % 7) + '\n';
        const QString path = bench.file(QStringLiteral("large.csv"), large);
        bool hasGrown = false;
        QObject context;
        QObject::connect(&bench.controller(), &WizardController::dataFileChanged, &context, [&] {
            if (hasGrown || bench->dataFile().progress <= 0.0)
                return;
            hasGrown = bench->dataFile().isReading;
            QFile file(path);
            QVERIFY(file.open(QIODevice::Append));
            QVERIFY(file.write("300000,0.1\n") > 0);
        });
        bench->openData(path);
        QVERIFY(bench.fileRead());
        QVERIFY(hasGrown);
        QTRY_VERIFY(bench->dataFile().hasChangedOnDisk);
        bench->openData(path);
        QVERIFY(bench.fileRead());
        QVERIFY(!bench->dataFile().hasChangedOnDisk);
        QCOMPARE(bench->dataFile().data->grid.pointCount(), std::size_t{300'001});
    }

    void readAgainTheTableThatWasChosenStaysChosenByItsName()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        const QString path = bench.file(QStringLiteral("a.csv"), oneDimension);
        bench->openData(path);
        QVERIFY(bench.fileRead());
        bench->setup().setTable({1});
        (void)bench.file(QStringLiteral("a.csv"),
            "X [mm],new [mm],first [mm],second [mm]\n0,7,1,2\n1,7,3,4\n2,8,1,2\n");
        bench->readDataAgain();
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->selectedTable()->name, "second");
        QCOMPARE(bench->setup().edited().table.fileTable, std::optional(2));
        // One that is gone is replaced by the one in its place.
        (void)bench.file(QStringLiteral("a.csv"), "X [mm],only [mm]\n0,7\n1,8\n2,7\n");
        bench->openData(path);
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->selectedTable()->name, "only");
    }

    void readAgainTheDrivesTableStaysChosen()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        const QString path = bench.file(QStringLiteral("a.csv"), oneDimension);
        bench->openData(path);
        QVERIFY(bench.fileRead());
        bench->setup().setTable({});
        bench->readDataAgain();
        QVERIFY(bench.fileRead());
        QVERIFY(!bench->setup().edited().table.fileTable);
    }

    /// After a write the window chooses the table on the drive by itself.
    void readAgainWithOtherValuesTheFileIsChosen()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        bench->openData(bench.file(QStringLiteral("a.csv"), oneDimension));
        QVERIFY(bench.fileRead());
        bench->setup().setTable({});
        (void)bench.file(
            QStringLiteral("a.csv"), "X [mm],first [mm],second [mm]\n0,1,2\n1,3,5\n2,1,2\n");
        bench->readDataAgain();
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->setup().edited().table.fileTable, std::optional(0));
        QVERIFY(bench->setup().isDirty(Field::Table));
    }

    void openedAgainAfterARevertItsTableIsChosen()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        const QString path = bench.file(QStringLiteral("a.csv"), oneDimension);
        bench->openData(path);
        QVERIFY(bench.fileRead());
        bench->setup().revert();
        QVERIFY(!bench->setup().edited().table.fileTable);
        bench->openData(path);
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->setup().edited().table.fileTable, std::optional(0));
    }

    void theNextFileCancelsTheOneThatIsBeingRead()
    {
        ControllerFixture bench;
        QByteArray large = "X,table\n";
        for (int i = 0; i < 300'000; ++i)
            large += QByteArray::number(i) + ",0." + QByteArray::number(i % 7) + '\n';
        const QString first = bench.file(QStringLiteral("large.csv"), large);
        const QString second = bench.file(QStringLiteral("small.csv"), oneDimension);
        bench->openData(first);
        bench->openData(second);
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->dataFile().path, second);
        QCOMPARE(bench->dataFile().data->grid.pointCount(), std::size_t{3});
    }

    void aFileThatWasOpenBeforeTheDriveAnsweredStaysChosen()
    {
        ControllerFixture bench;
        bench->openData(bench.file(QStringLiteral("a.csv"), oneDimension));
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->selectedTable()->name, "first");
        QVERIFY(bench.connect());
        QCOMPARE(bench->setup().edited().table.fileTable, std::optional(0));
        QVERIFY(bench->setup().isDirty(Field::Table));
    }

    void anotherAxisWithAnotherDimensionalityReadsTheFileAgain()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        QVERIFY(bench.planAndWrite());
        bench->selectAxis(1);
        QTRY_VERIFY(bench->status().has_value());
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->setup().edited().dimensionality, 1);
        QVERIFY(!bench->dataFile().problems.empty()); // 2D data, read as 1D
        bench->selectAxis(0);
        QTRY_VERIFY(bench->status().has_value());
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->setup().edited().dimensionality, 2);
        QVERIFY(bench->dataFile().problems.empty());
        QVERIFY(!bench->setup().isDirty());
    }
};

AXISCOMP_TEST(TestDataFileModel)

} // namespace tst_datafilemodel

#include "tst_datafilemodel.moc"
