// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/controller_fixture.h"
#include "tests/ui/support/heartbeat.h"
#include "tests/ui/support/window_test.h"
#include "ui/data/file_excerpt.h"
#include "ui/data/problem_model.h"
#include "ui/page/file_lines_view.h"
#include "ui/page/preview_panel.h"
#include "ui/page/problem_list.h"

#include <QAbstractItemModelTester>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

namespace tst_problemlist {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::ControllerFixture;

namespace {

/// A folder of files.
class Folder {
public:
    [[nodiscard]] QString file(const QString& name, const QByteArray& content) const
    {
        QFile file(m_folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
            qFatal("cannot write %s", qPrintable(file.fileName()));
        return file.fileName();
    }

private:
    QTemporaryDir m_folder;
};

FileExcerpt excerpt(const QString& path, std::size_t line, std::size_t around)
{
    return excerptOf(path, line, around, {});
}

QByteArray manyLines(int count)
{
    QByteArray text = "X [mm],table\n";
    for (int i = 2; i <= count; ++i)
        text += QByteArray::number(i) + ",0.5\n";
    return text;
}

/// The header and two lines, then nothing but zeros up to two gigabytes, without using the disk.
QString sparseFile(const Folder& folder)
{
    const QString path = folder.file(QStringLiteral("huge.csv"), "X [mm],table\n0,1\n1,2\n");
    if (!QFile::resize(path, qint64{2} << 30))
        qFatal("cannot resize %s", qPrintable(path));
    return path;
}

template <typename T> T* child(const QObject& parent, const char* name)
{
    return parent.findChild<T*>(QLatin1StringView(name));
}

} // namespace

class TestProblemList : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void anExcerptHasTheLineAndItsNeighbours_data()
    {
        QTest::addColumn<QByteArray>("end");
        QTest::newRow("LF") << QByteArray("\n");
        QTest::newRow("CRLF") << QByteArray("\r\n");
        QTest::newRow("CR") << QByteArray("\r");
    }
    void anExcerptHasTheLineAndItsNeighbours()
    {
        QFETCH(QByteArray, end);
        const Folder folder;
        const QList<QByteArray> lines{
            "// a note, with a comma", "X [mm];Y", "1;\"a;b\"", "", " 2 ; 3;4", "5;6"};
        const QString path = folder.file(QStringLiteral("a.csv"), lines.join(end) + end);
        const FileExcerpt found = excerpt(path, 4, 1);
        QCOMPARE(found.firstLine, std::size_t{3});
        const std::vector<QStringList> wanted{{QStringLiteral("1"), QStringLiteral("a;b")},
            {QString()}, {QStringLiteral("2"), QStringLiteral("3"), QStringLiteral("4")}};
        QCOMPARE(found.lines, wanted);
        QCOMPARE(found.header, QStringList({QStringLiteral("X [mm]"), QStringLiteral("Y")}));
        QVERIFY(found.hasMore);
        const FileExcerpt all = excerpt(path, 0, 100); // the whole file: its beginning
        QCOMPARE(all.firstLine, std::size_t{1});
        QCOMPARE(all.lines.size(), std::size_t(lines.size()));
        QCOMPARE(all.lines[0], QStringList{QString::fromLatin1(lines[0])});
        QVERIFY(!all.hasMore);
        QVERIFY(!excerpt(path, 6, 0).hasMore);
        QVERIFY(excerpt(path, 20, 1).lines.empty());
        QVERIFY(excerpt(path + u'x', 1, 1).lines.empty());
    }

    void aLineDeepInALargeFileIsFound()
    {
        const Folder folder;
        const QString path = folder.file(QStringLiteral("deep.csv"), manyLines(400'000));
        const FileExcerpt found = excerpt(path, 399'000, 2);
        QCOMPARE(found.lines.size(), std::size_t{5});
        QCOMPARE(found.lines[2], QStringList({QStringLiteral("399000"), QStringLiteral("0.5")}));
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(excerptOf(path, 399'000, 2, stop.get_token()).lines.empty());
    }

    void aBrokenFileIsShownAsWellAsItCanBe()
    {
        const Folder folder;
        const QString path = folder.file(QStringLiteral("odd.csv"),
            QByteArray("X,t\xE4"
                       "ble\n1,\x01\x02"
                       "a\n")
                + QByteArray(300'000, ',') + "\n4,5");
        const FileExcerpt found = excerpt(path, 1, 10);
        QCOMPARE(found.lines.size(), std::size_t{4});
        QCOMPARE(found.lines[0][1], QStringLiteral("täble"));
        QVERIFY(!found.lines[1][1].contains(QChar(1)));
        QCOMPARE(found.lines[2].size(), 256);
        QCOMPARE(found.lines[3], QStringList({QStringLiteral("4"), QStringLiteral("5")}));
    }

    void theCellOfTheProblemIsMarkedNotByColourAlone()
    {
        const Folder folder;
        const QString path =
            folder.file(QStringLiteral("bad.csv"), "X [mm],table\n0,1\n1,two\n2,3\n3\n");
        FileLinesModel model;
        model.setExcerpt(excerpt(path, 3, 10), {3, 2, true, QStringLiteral("No number.")});
        QCOMPARE(model.columnCount(), 2);
        QCOMPARE(model.rowCount(), 5);
        QCOMPARE(model.headerData(1, Qt::Horizontal, Qt::DisplayRole).toString(),
            QStringLiteral("2: table"));
        QCOMPARE(
            model.headerData(2, Qt::Vertical, Qt::DisplayRole).toString(), QStringLiteral("3"));
        const QModelIndex place = model.placeIndex();
        QCOMPARE(place, model.index(2, 1));
        QCOMPARE(place.data().toString(), QStringLiteral("two"));
        QVERIFY(place.data(Qt::BackgroundRole).isValid());
        QVERIFY(place.data(Qt::DecorationRole).isValid());
        QVERIFY(place.data(Qt::FontRole).value<QFont>().bold());
        QCOMPARE(place.data(Qt::AccessibleTextRole).toString(),
            QStringLiteral("line 3, column 2: two; No number."));
        for (const QModelIndex& other : {model.index(2, 0), model.index(1, 1)}) {
            QVERIFY(!other.data(Qt::BackgroundRole).isValid());
            QVERIFY(!other.data(Qt::DecorationRole).isValid());
        }
        // A cell that is missing is marked where it should be; a whole line has one symbol.
        model.setExcerpt(excerpt(path, 5, 10), {5, 2, true, QString()});
        QCOMPARE(model.placeIndex(), model.index(4, 1));
        QVERIFY(model.placeIndex().data(Qt::DecorationRole).isValid());
        model.setExcerpt(excerpt(path, 2, 10), {2, 0, false, QString()});
        QVERIFY(model.index(1, 1).data(Qt::BackgroundRole).isValid());
        QVERIFY(model.index(1, 0).data(Qt::DecorationRole).isValid());
        QVERIFY(!model.index(1, 1).data(Qt::DecorationRole).isValid());
    }

    void theProblemsAreAModel()
    {
        ProblemModel model;
        const QAbstractItemModelTester tester(&model);
        model.setProblems({{Severity::Error, DiagnosticCode::NotANumber, 3, 2, Verbatim{"two"}, {}},
            {Severity::Warning, DiagnosticCode::ConstantTable, 0, 2, {}, {}}});
        QCOMPARE(model.rowCount(), 2);
        QCOMPARE(model.index(0, ProblemModel::Line).data().toString(), QStringLiteral("3"));
        QCOMPARE(model.index(1, ProblemModel::Line).data().toString(), QStringLiteral("–"));
        QCOMPARE(model.index(0, ProblemModel::Line).data(Qt::AccessibleTextRole).toString(),
            QStringLiteral("error, line 3"));
        QVERIFY(model.place(0).isError && !model.place(1).isError);
        QCOMPARE(
            model.index(0, ProblemModel::Statement).data().toString(), model.place(0).sentence);
        QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
        model.retranslate();
        QCOMPARE(changes.size(), 1);
        model.setProblems({});
        QCOMPARE(model.rowCount(), 0);
        model.retranslate();
        QCOMPARE(changes.size(), 1);
    }

    void aClickOrEnterOpensTheProblem()
    {
        ProblemList list;
        DataFile file;
        file.problemsPath = QStringLiteral("/bad.csv");
        file.problems = {{Severity::Error, DiagnosticCode::NotANumber, 3, 2, Verbatim{"two"},
                             Verbatim{"a number"}},
            {Severity::Warning, DiagnosticCode::ConstantTable, 0, 2, {}, {}}};
        list.setProblems(file);
        list.resize(500, 300);
        list.show();
        QVERIFY(QTest::qWaitForWindowActive(&list));
        QList<ProblemPlace> opened;
        connect(&list, &ProblemList::opened, this,
            [&](const QString&, const ProblemPlace& place) { opened += place; });
        auto* view = child<QTreeView>(list, "problems");
        QTest::mouseClick(view->viewport(), Qt::LeftButton, {},
            view->visualRect(view->model()->index(0, 0)).center());
        QCOMPARE(opened.size(), 1);
        QCOMPARE(opened[0].line, std::size_t{3});
        QCOMPARE(opened[0].column, std::size_t{2});
        QVERIFY(opened[0].isError && opened[0].sentence.contains(QStringLiteral("two")));
        view->setFocus();
        QTest::keyClick(view, Qt::Key_Down);
        QCOMPARE(opened.size(), 1); // moving through the list opens nothing
        QTest::keyClick(view, Qt::Key_Return);
        QCOMPARE(opened.size(), 2);
        QVERIFY(!opened[1].isError && opened[1].line == 0);
        list.step(1); // round the end
        QCOMPARE(opened.last().line, std::size_t{3});
        list.step(-1);
        QCOMPARE(opened.last().line, std::size_t{0});
    }

    void theFileOpensAtTheLineAndGoesOnFromThere()
    {
        const Folder folder;
        const QString path = folder.file(QStringLiteral("deep.csv"), manyLines(10'000));
        FileLinesView view;
        view.resize(500, 300);
        view.show();
        auto* table = child<QTableView>(view, "fileLines");
        view.showProblem(path, {5000, 2, true, QStringLiteral("No number.")});
        QTRY_COMPARE(table->currentIndex().data().toString(), QStringLiteral("0.5"));
        const auto lineOf = [table](int row) {
            return table->model()->headerData(row, Qt::Vertical).toString().remove(u',').toInt();
        };
        QCOMPARE(lineOf(table->currentIndex().row()), 5000);
        QVERIFY(table->viewport()->rect().contains(table->visualRect(table->currentIndex())));
        QCOMPARE(child<QLabel>(view, "fileLinesTitle")->text().remove(u','),
            QStringLiteral("deep.csv line 5000 column 2: No number."));
        const int last = lineOf(table->model()->rowCount() - 1);
        child<QToolButton>(view, "laterLines")->click();
        QTRY_VERIFY(lineOf(table->model()->rowCount() - 1) > last);
        QCOMPARE(lineOf(table->currentIndex().row()), last);
        while (child<QToolButton>(view, "earlierLines")->isVisible()) {
            const int first = lineOf(0);
            child<QToolButton>(view, "earlierLines")->click();
            QTRY_VERIFY(lineOf(0) < first);
        }
        QCOMPARE(lineOf(0), 1);
        view.showProblem(path + u'x', {1, 0, true, QString()});
        QTRY_COMPARE(table->model()->rowCount(), 0);
        QVERIFY(!child<QLabel>(view, "fileLinesRange")->text().isEmpty());
    }

    void aFileOf2GigabytesNeverStopsTheWindow()
    {
        const Folder folder;
        const QString path = sparseFile(folder);
        FileLinesView view;
        view.resize(500, 300);
        view.show();
        auto* table = child<QTableView>(view, "fileLines");
        QVERIFY(QTest::qWaitForWindowActive(&view));
        test::Heartbeat heart;
        view.showProblem(path, {0, 0, true, QStringLiteral("Too large.")});
        QTRY_VERIFY(table->model()->rowCount() >= 3);
        QCOMPARE(table->model()->index(1, 1).data().toString(), QStringLiteral("1"));
        // A line far behind the end: looked for until the view goes, or something else is wanted.
        view.showProblem(path, {1'000'000, 0, true, QString()});
        view.showProblem(path, {2, 1, true, QString()});
        QTRY_COMPARE(table->currentIndex(), table->model()->index(1, 0));
        QVERIFY2(heart.longest() < std::chrono::milliseconds(100),
            qPrintable(QStringLiteral("%1 us").arg(heart.longest().count())));
    }

    void onThePageAProblemOpensTheFileInTheValues()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        PreviewPanel panel(bench.controller(), drivecomm::genericProfile());
        panel.resize(600, 600);
        panel.show();
        auto* tabs = child<QTabWidget>(panel, "previewTabs");
        auto* stack = child<QStackedWidget>(panel, "valuesStack");
        auto* problems = child<QTreeView>(panel, "problems");
        const QString good =
            bench.file(QStringLiteral("good.csv"), "X,table\n0,0.001\n1,0.002\n2,0.001\n");
        bench->openData(bench.file(QStringLiteral("bad.csv"), "X,table\n0,1\n1,two\n2,nan\n"));
        QVERIFY(bench.fileRead());
        QCOMPARE(tabs->currentWidget()->objectName(), QStringLiteral("problemList"));
        problems->setCurrentIndex(problems->model()->index(0, 0));
        QTest::keyClick(problems, Qt::Key_Return);
        QCOMPARE(tabs->currentWidget(), stack);
        auto* lines = child<QTableView>(panel, "fileLines");
        QTRY_COMPARE(lines->currentIndex().data().toString(), QStringLiteral("two"));
        child<QToolButton>(panel, "nextProblem")->click();
        QTRY_COMPARE(lines->currentIndex().data().toString(), QStringLiteral("nan"));
        child<QToolButton>(panel, "closeFileLines")->click();
        QCOMPARE(stack->currentWidget()->objectName(), QStringLiteral("valuesView"));
        // With a good file nothing of the bad one is left.
        child<QToolButton>(panel, "nextProblem")->click();
        bench->openData(good);
        QVERIFY(bench.fileRead());
        QCOMPARE(stack->currentWidget()->objectName(), QStringLiteral("valuesView"));
        QCOMPARE(tabs->count(), 2);
    }

    void aFullGridOfMoreDimensionsIsReadAsThatByOneButton()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        bench->setup().setDimensionality(1);
        PreviewPanel panel(bench.controller(), drivecomm::genericProfile());
        panel.show();
        QByteArray plane = "X [mm],Y [mm],table [mm]\n";
        for (int i = 0; i < 31 * 21; ++i)
            plane += QByteArray::number(i % 31) + ',' + QByteArray::number(i / 31) + ','
                + QByteArray::number(i % 3 * 0.001) + '\n';
        bench->openData(bench.file(QStringLiteral("line.csv"), "X,table\n0,0.001\n1,0.002\n"));
        QVERIFY(bench.fileRead());
        bench->openData(bench.file(QStringLiteral("plane.csv"), plane));
        QVERIFY(bench.fileRead());
        auto* use = child<QPushButton>(panel, "useDimensions");
        auto* problems = child<QTreeView>(panel, "problems");
        QCOMPARE(problems->model()->rowCount(), 2);
        const QString statement = problems->model()->index(0, 2).data().toString();
        QVERIFY2(statement.contains(QStringLiteral("31 x 21")), qPrintable(statement));
        QVERIFY(!use->isHidden());
        QCOMPARE(use->text(), QStringLiteral("&Use 2D"));
        use->click();
        QTRY_COMPARE(bench->dataFile().path.section(u'/', -1), QStringLiteral("plane.csv"));
        QCOMPARE(bench->setup().edited().dimensionality, 2);
        QVERIFY(bench->dataFile().problems.empty());
        QCOMPARE(bench->selectedTable()->grid.pointCount(), 651U);
        bench->openData(bench.file(QStringLiteral("bad.csv"), "X,Y,table\n0,1,x\n1,2,3\n"));
        QVERIFY(bench.fileRead());
        QVERIFY(use->isHidden());
    }
};

AXISCOMP_WINDOW_TEST(TestProblemList)

} // namespace tst_problemlist

#include "tst_problemlist.moc"
