// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/dropped_files.h"
#include "tests/ui/support/page_states.h"
#include "tests/ui/support/window_test.h"

#include <QCheckBox>
#include <QDir>
#include <QDragEnterEvent>
#include <QMimeData>
#include <QTableView>
#include <QTest>
#include <QTreeView>

namespace tst_wizardfiles {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::drop;
using test::Drop;
using test::PageFixture;

namespace {

QStringList cellsOf(const QAbstractItemModel& model)
{
    QStringList cells;
    for (int row = 0; row < model.rowCount(); ++row) {
        for (int column = 0; column < model.columnCount(); ++column)
            cells += model.index(row, column).data().toString();
    }
    return cells;
}

QMimeData* urls(const QList<QUrl>& list, QMimeData& data)
{
    data.setUrls(list);
    return &data;
}

} // namespace

/// Files: dropped, bad, changed on disk, remembered.
class TestWizardFiles : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void largeCorrectionsAreConfirmedInThePreviewBeforeTheyAreWritten()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        QVERIFY(bench.choose2D());
        user.the<QCheckBox>("skipPreviewForVolatile").setChecked(true);
        bench.picked = bench.file(
            QStringLiteral("um.csv"), "X [mm],Y [mm],E [mm]\n0,0,0\n40,0,2\n0,30,1\n40,30,0\n");
        QVERIFY(user.click("openButton"));
        QTRY_VERIFY(bench.controller().dataFile().path == bench.picked);
        const auto before = bench.state();
        QVERIFY(user.click("writeButton"));
        QTRY_VERIFY(user.sees("acceptLargeCorrections"));
        QVERIFY(!user.the("confirmWriteButton").isEnabled());
        const auto warnings =
            user.the("previewWarnings").findChildren<QLabel*>(QStringLiteral("warningText"));
        QCOMPARE(warnings.size(), 2); // one for each dimension
        QVERIFY(warnings.front()->text().contains(
            QStringLiteral("The largest correction, 2 mm, is 5 % of the range")));
        QVERIFY(warnings.back()->text().contains(QStringLiteral("dimension 2, 30 mm")));
        test::PageUser::press(Qt::Key_Return, Qt::ControlModifier);
        QVERIFY(bench.idle());
        QVERIFY(bench.state() == before);
        QVERIFY(user.click("acceptLargeCorrections"));
        QTRY_VERIFY(user.the("confirmWriteButton").isEnabled());
        QVERIFY(user.click("confirmWriteButton"));
        QVERIFY(bench.saysOutcome(QStringLiteral("the drive holds the new state")));
    }

    void aDroppedFileIsOpened()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        QVERIFY(bench.user.choose("dimensionalityField", QStringLiteral("2D")));
        QMimeData data;
        const QString file = bench.superData();
        const Drop result = drop(bench, *urls({QUrl::fromLocalFile(file)}, data));
        QVERIFY(result.isWelcome);
        QVERIFY(result.showsFrame);
        QVERIFY(result.isTaken);
        QVERIFY(!bench.user.sees("dropFrame"));
        QTRY_VERIFY(bench.controller().dataFile().data);
        QCOMPARE(bench.controller().dataFile().path, file);
        QCOMPARE(bench.user.the<QLineEdit>("dataFile").text(), QStringLiteral("super-1.csv"));
    }

    void whatIsNotOneFileIsNotWelcome()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        const QUrl first = QUrl::fromLocalFile(bench.superData(1));
        const QUrl second = QUrl::fromLocalFile(bench.superData(2));
        QMimeData text;
        text.setText(QStringLiteral("0,0,1\n"));
        QVERIFY(!drop(bench, text).isWelcome);
        QMimeData two;
        QVERIFY(!drop(bench, *urls({first, second}, two)).isWelcome);
        QMimeData folder;
        QVERIFY(!drop(bench, *urls({QUrl::fromLocalFile(bench.folder.path())}, folder)).isWelcome);
        QMimeData missing;
        QVERIFY(!drop(
            bench, *urls({QUrl::fromLocalFile(bench.path(QStringLiteral("none.csv")))}, missing))
                     .isWelcome);
        QMimeData remote;
        QVERIFY(!drop(bench, *urls({QUrl(QStringLiteral("http://example.org/a.csv"))}, remote))
                     .isWelcome);
        QVERIFY(!bench.user.sees("dropFrame"));
        QVERIFY(!bench.controller().dataFile().isReading);
        QVERIFY(bench.controller().dataFile().path.isEmpty());
    }

    void whileTheDriveIsWrittenNothingIsWelcome()
    {
        PageFixture bench;
        QVERIFY(test::page_states::writing(bench));
        QMimeData data;
        QVERIFY(!drop(bench, *urls({QUrl::fromLocalFile(bench.superData(2))}, data)).isWelcome);
        bench.served.faults.clear();
        QVERIFY(bench.idle());
    }

    void aDragThatGoesAwayLeavesNothing()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(bench.superData())});
        QDragEnterEvent enter({300, 300}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&bench.wizard, &enter);
        QVERIFY(bench.user.sees("dropFrame"));
        QDragLeaveEvent leave;
        QApplication::sendEvent(&bench.wizard, &leave);
        QVERIFY(!bench.user.sees("dropFrame"));
        QVERIFY(!bench.controller().dataFile().isReading);
    }

    void aBadFileIsAListOfProblemsAndTheOldTableStays()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(test::page_states::unwritten(bench));
        const auto table = bench.controller().selectedTable();
        QVERIFY(test::page_states::openBadFile(bench));
        auto& list = user.the<QTreeView>("problems");
        const QAbstractItemModel& problems = *list.model();
        QVERIFY(problems.rowCount() >= 3);
        QCOMPARE(problems.index(0, 0).data().toString(), QStringLiteral("3"));
        QVERIFY(problems.index(0, 2).data().toString().contains(QStringLiteral("0.0O2")));
        const QString note = user.note("dataField");
        const QString bad =
            bench.controller().dataFile().problemsPath.section(QLatin1Char('/'), -1);
        QVERIFY2(note.startsWith(bad + QStringLiteral(" is not used, problems: ")),
            qPrintable(note)); // the field above it names the file that is
        QVERIFY(bench.controller().selectedTable() == table);
        QVERIFY(user.the<QComboBox>("tableField").currentText().contains(QStringLiteral("first")));
        QVERIFY(user.the("writeButton").isEnabled());
        // A click leads to the file's line.
        const QRect row = list.visualRect(problems.index(0, 0));
        QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, row.center());
        QTRY_VERIFY(user.sees("fileLines"));
        const auto& lines = *user.the<QTableView>("fileLines").model();
        QTRY_VERIFY(cellsOf(lines).contains(QStringLiteral("0.0O2")));
        // A good file takes the list away.
        bench.picked = bench.superData(2);
        QVERIFY(user.click("openButton"));
        QTRY_VERIFY(user.note("dataField").startsWith(QStringLiteral("tables: ")));
        QTRY_VERIFY(!user.sees("problems"));
    }

    void theFirstFileMayBeTheBadOne()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        bench.picked = bench.file(QStringLiteral("nonsense.csv"), "hello\nworld\n");
        QVERIFY(user.click("openButton"));
        QTRY_VERIFY(user.sees("problems"));
        QCOMPARE(
            user.the<QComboBox>("tableField").currentText(), QStringLiteral("none on the drive"));
        QVERIFY(!bench.controller().setup().isDirty(Field::Table));
        QVERIFY(!user.the("writeButton").isEnabled());
    }

    void aFileThatHasChangedIsOfferedToBeReadAgain()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(test::page_states::unwritten(bench));
        QVERIFY(user.choose("tableField", QStringLiteral("second")));
        bench.picked = bench.file(QStringLiteral("super-1.csv"),
            "X [mm],Y [mm],other [mm],second [mm]\n"
            "0,0,1,2\n10,0,1,2\n0,10,1,2\n10,10,1,2\n");
        QTRY_VERIFY(user.message("fileChangedMessage").contains(QStringLiteral("super-1.csv")));
        QVERIFY(user.click("readAgainButton"));
        QTRY_COMPARE(bench.controller().dataFile().data->grid.pointCount(), std::size_t{4});
        QVERIFY(user.message("fileChangedMessage").isEmpty());
        // The table of that name stays chosen.
        QVERIFY(user.the<QComboBox>("tableField").currentText().contains(QStringLiteral("second")));
    }

    void filesAndFolderAreRemembered()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(test::page_states::unwritten(bench));
        bench.picked.clear(); // given up this time
        QVERIFY(user.click("openButton"));
        QCOMPARE(QDir(bench.questions.back().start), QDir(bench.folder.path()));
        const QString second = bench.superData(2);
        bench.picked = second;
        QVERIFY(user.click("openButton"));
        QTRY_COMPARE(bench.controller().dataFile().path, second);
        // The newest is the first of the menu.
        QVERIFY(user.pickFromMenu("recentButton", "recentMenu", Qt::Key_2));
        QTRY_COMPARE(bench.controller().dataFile().path, bench.superData(1));
    }
};

AXISCOMP_WINDOW_TEST(TestWizardFiles)

} // namespace tst_wizardfiles

#include "tst_wizardfiles.moc"
