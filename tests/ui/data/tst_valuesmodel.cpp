// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/heartbeat.h"
#include "tests/ui/support/table_samples.h"
#include "tests/ui/support/window_test.h"
#include "ui/data/values_model.h"
#include "ui/drawing/table_map.h"
#include "ui/plot/values_view.h"
#include "ui/text/value_text.h"

#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLabel>
#include <QLocale>
#include <QSignalSpy>
#include <QSlider>
#include <QTableView>
#include <QTest>

#include <random>

namespace tst_valuesmodel {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::namedTable;
using test::sharedTable;

namespace {

QString textAt(const QAbstractItemModel& model, int row, int column)
{
    return model.index(row, column).data().toString();
}

/// As a table of some micrometres is shown.
QString micrometres(float millimetres)
{
    constexpr double perMillimetre = 1000.0;
    const QString text = QString::number(static_cast<double>(millimetres) * perMillimetre, 'f', 4);
    return millimetres > 0.0F ? u'+' + text : millimetres == 0.0F ? QStringLiteral("0.0000") : text;
}

QString header(const QAbstractItemModel& model, Qt::Orientation orientation, int section)
{
    return model.headerData(section, orientation).toString();
}

/// A view of a table, as the page has it.
struct Fixture {
    explicit Fixture(TableViewModel::Table selected, TableViewModel::Table onDrive = {})
    {
        shown.setTables(std::move(selected), std::move(onDrive));
        view = std::make_unique<ValuesView>(shown);
        view->resize(600, 400);
        view->show();
        table = view->findChild<QTableView*>(QStringLiteral("values"));
    }
    [[nodiscard]] const QAbstractItemModel& model() const { return *table->model(); }

    TableViewModel shown;
    std::unique_ptr<ValuesView> view;
    QTableView* table = nullptr;
};

} // namespace

class TestValuesModel : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnWindowWarnings();
        QLocale::setDefault(QLocale::c());
    }

    void withoutATableThereIsNothing()
    {
        TableViewModel shown;
        const ValuesModel model(shown);
        QCOMPARE(model.rowCount(), 0);
        QCOMPARE(model.columnCount(), 0);
    }

    void aCurveIsAListOfPositionsAndValues()
    {
        TableViewModel shown;
        const auto table = sharedTable({5});
        shown.setTables(table, nullptr);
        const ValuesModel model(shown);
        QCOMPARE(model.rowCount(), 5);
        QCOMPARE(model.columnCount(), 2);
        QCOMPARE(header(model, Qt::Horizontal, 0), QStringLiteral("X [mm]"));
        QCOMPARE(header(model, Qt::Horizontal, 1), QStringLiteral("compensation [µm]"));
        QCOMPARE(header(model, Qt::Vertical, 4), QStringLiteral("4")); // as Dim1Index counts
        QCOMPARE(textAt(model, 3, 0), QStringLiteral("7.5"));
        QCOMPARE(textAt(model, 3, 1), micrometres(table->values[3]));
    }

    void besideTheDrivesCurveStandsTheDifference()
    {
        TableViewModel shown;
        const auto table = sharedTable({5});
        auto onDrive = namedTable({3}, 1.0); // 0 to 5: its last value holds up to 10
        shown.setTables(table, std::make_shared<const CompensationTable>(onDrive));
        const ValuesModel model(shown);
        QCOMPARE(model.columnCount(), 4);
        QCOMPARE(header(model, Qt::Horizontal, 2), QStringLiteral("on the drive [µm]"));
        QCOMPARE(header(model, Qt::Horizontal, 3), QStringLiteral("difference [µm]"));
        QCOMPARE(textAt(model, 4, 2), micrometres(onDrive.values[2]));
        QCOMPARE(textAt(model, 4, 3), micrometres(table->values[4] - onDrive.values[2]));
        const CopyHeaders names{QStringLiteral("X"), QStringLiteral("new"),
            {QStringLiteral("old"), QStringLiteral("difference")}};
        const QString copied =
            copiedText({*table, shown.valueScale(), &onDrive}, {{1, 0, 1, 3}}, &names);
        QVERIFY2(copied.startsWith(QStringLiteral("X\tnew\told\tdifference\n2.5\t")),
            qPrintable(copied));
        const QStringList cells = copied.section(u'\n', 1, 1).split(u'\t');
        QCOMPARE(cells.size(), 4);
        QVERIFY(std::abs(cells[1].toDouble() - cells[2].toDouble() - cells[3].toDouble()) < 1e-6);
        QVERIFY(std::abs(cells[1].toDouble() - 1000.0 * double(table->values[1])) < 1e-6);
    }

    void theDrivesValuesAndTheDifferenceHaveTheDecimalsThatTheyNeed()
    {
        const auto curve = [](double distance, const std::vector<float>& values) {
            CompensationTable table;
            table.unit = "mm";
            table.grid.axes = {{.name = "Y",
                .unit = "mm",
                .start = 0.0,
                .distance = distance,
                .size = static_cast<std::uint32_t>(values.size())}};
            table.values = values;
            return std::make_shared<const CompensationTable>(std::move(table));
        };
        TableViewModel shown;
        const auto selected = curve(5.0, {0.001F, 0.002F, 0.009F});
        shown.setTables(selected, curve(5.0, {0.0014F, 0.0024F, 0.0094F}));
        const ValuesModel model(shown);
        const auto row = [&](int index) {
            return QStringList{
                textAt(model, index, 1), textAt(model, index, 2), textAt(model, index, 3)};
        };
        QCOMPARE(row(0).join(u' '), QStringLiteral("+1 +1.4 -0.4"));
        QCOMPARE(row(2).join(u' '), QStringLiteral("+9 +9.4 -0.4"));
        // Between the points of the drive's table, too: 1.5 at 5.
        shown.setTables(selected, curve(10.0, {0.001F, 0.002F}));
        QCOMPARE(row(1).join(u' '), QStringLiteral("+2 +1.5 +0.5"));
    }

    void aCurveOverAnotherSourceStandsAlone()
    {
        TableViewModel shown;
        const auto table = sharedTable({5});
        const auto onDrive = sharedTable({5}, 1.0);
        shown.setTables(table, onDrive);
        const ValuesModel model(shown);
        QCOMPARE(model.columnCount(), 4);
        QSignalSpy changes(&shown, &TableViewModel::changed);
        shown.setContent(TableContent::Difference);
        QTRY_COMPARE(changes.count(), 1);
        shown.setTables(table, onDrive, TableSources::Other);
        QCOMPARE(shown.content(), TableContent::Selected);
        QCOMPARE(model.columnCount(), 2);
        QVERIFY(!shown.canShow(TableContent::Difference));
        QVERIFY(shown.canShow(TableContent::Drive));
        shown.setTables(table, onDrive, TableSources::Same);
        QCOMPARE(model.columnCount(), 4);
    }

    void cellsHaveTheColourOfTheMap()
    {
        Fixture bench(sharedTable({4, 3}));
        const auto& values = bench.shown.drawn()->values;
        const auto largest =
            std::ranges::max_element(values, {}, [](float v) { return std::abs(v); });
        const auto at = static_cast<int>(largest - values.begin());
        const QModelIndex cell = bench.model().index(at / 4, at % 4);
        QCOMPARE(std::abs(cell.data(ValuesModel::ShareRole).toDouble()), 1.0);
        const QImage picture = bench.table->viewport()->grab().toImage();
        const QRect place = bench.table->visualRect(cell);
        QCPColorGradient gradient = divergingGradient(false);
        QCOMPARE(picture.pixelColor(place.topLeft() + QPoint(4, 3)),
            QColor(gradient.color(*largest > 0.0F ? 1.0 : -1.0, QCPRange(-1.0, 1.0))));
    }

    void aMapHasDimension1AcrossAndDimension2Down()
    {
        TableViewModel shown;
        const auto table = sharedTable({4, 3});
        shown.setTables(table, nullptr);
        const ValuesModel model(shown);
        QCOMPARE(model.rowCount(), 3);
        QCOMPARE(model.columnCount(), 4);
        QCOMPARE(header(model, Qt::Horizontal, 3), QStringLiteral("7.5"));
        QCOMPARE(header(model, Qt::Vertical, 2), QStringLiteral("105.0"));
        for (int j = 0; j < 3; ++j) {
            for (int i = 0; i < 4; ++i)
                QCOMPARE(textAt(model, j, i),
                    micrometres(table->values[static_cast<std::size_t>(j * 4 + i)]));
        }
        QCOMPARE(model.index(2, 3).data(Qt::AccessibleTextRole).toString(),
            QStringLiteral("X 7.5 mm, Y 105 mm, %1 µm").arg(micrometres(table->values[11])));
    }

    void aVolumeShowsTheSliceThatThePictureShows()
    {
        const auto table = sharedTable({4, 3, 5});
        Fixture bench(table);
        auto* slider = bench.view->findChild<QSlider*>(QStringLiteral("sliceIndex"));
        slider->setValue(4);
        QCOMPARE(bench.shown.sliceIndex(), 4);
        QCOMPARE(textAt(bench.model(), 2, 1), micrometres(table->values[4 * 12 + 2 * 4 + 1]));
        bench.shown.setSlice(1, 3); // X is cut: Y across, Z down
        QCOMPARE(bench.model().columnCount(), 3);
        QCOMPARE(bench.model().rowCount(), 5);
        QCOMPARE(textAt(bench.model(), 2, 1), micrometres(table->values[2 * 12 + 1 * 4 + 3]));
        QCOMPARE(header(bench.model(), Qt::Vertical, 2), QStringLiteral("205.0"));
        QCOMPARE(slider->value(), 3);
        const auto* note = bench.view->findChild<QLabel*>(QStringLiteral("valuesLayout"));
        QCOMPARE(note->text(), QStringLiteral("Y [mm] across, Z [mm] down, compensation [µm]"));
    }

    void aValueIsCopiedWithEveryDigitThatItHas()
    {
        std::mt19937 random(3); // NOLINT: the same values every time
        std::uniform_int_distribution<std::uint32_t> bits;
        for (int n = 0; n < 100'000; ++n) {
            const auto value = std::bit_cast<float>(bits(random));
            if (!std::isfinite(value))
                continue;
            QCOMPARE(plainValue(value).toFloat(), value);
        }
        QCOMPARE(plainValue(0.0021F), QByteArray("0.0021"));
        QCOMPARE(plainValue(1e-5F), QByteArray("0.00001"));
        QCOMPARE(plainValue(-0.0F), QByteArray("0"));
        QLocale::setDefault(QLocale(QLocale::German));
        QCOMPARE(plainValue(-0.0021F), QByteArray("-0.0021"));
    }

    void neighbouringPositionsDifferHoweverFarFromZeroTheyAre()
    {
        const GridAxis axis{{}, {}, 1200.0, 0.00005, 3000};
        for (std::size_t i = 1; i < axis.size; ++i)
            QVERIFY2(positionText(axis, i) != positionText(axis, i - 1),
                qPrintable(positionText(axis, i)));
        QCOMPARE(positionText(axis, 1), QStringLiteral("1200.00005"));
        const GridAxis tenths{{}, {}, -0.3, 0.1, 7};
        QCOMPARE(positionText(tenths, 3), QStringLiteral("0"));
        QCOMPARE(positionText(tenths, 6), QStringLiteral("0.3"));
    }

    void theDifferenceIsTheSelectedTableMinusTheDrives()
    {
        const auto selected = sharedTable({4, 3});
        const auto onDrive = sharedTable({4, 3}, 1.0);
        Fixture bench(selected, onDrive);
        auto* box = bench.view->findChild<QComboBox*>(QStringLiteral("valuesContent"));
        Q_EMIT box->activated(2);
        QCOMPARE(bench.shown.content(), TableContent::Difference);
        QTRY_COMPARE(textAt(bench.model(), 1, 2),
            micrometres(static_cast<float>(static_cast<double>(selected->values[6])
                - static_cast<double>(onDrive->values[6]))));
        bench.shown.setContent(TableContent::Drive);
        QCOMPARE(box->currentIndex(), 1);
        QCOMPARE(textAt(bench.model(), 1, 2), micrometres(onDrive->values[6]));
        // A table that cannot be compared leaves the choice of a difference.
        bench.shown.setContent(TableContent::Difference);
        bench.shown.setTables(sharedTable({4}), onDrive);
        QCOMPARE(bench.shown.content(), TableContent::Selected);
        QCOMPARE(bench.model().rowCount(), 4);
    }

    void anotherTableOnTheSameGridKeepsThePlace()
    {
        Fixture bench(sharedTable({40, 30}));
        bench.table->setCurrentIndex(bench.model().index(20, 7));
        QSignalSpy resets(&bench.model(), &QAbstractItemModel::modelReset);
        bench.shown.setTables(sharedTable({40, 30}, 1.0), nullptr);
        QCOMPARE(bench.table->currentIndex(), bench.model().index(20, 7));
        QCOMPARE(resets.count(), 0);
        bench.shown.setTables(sharedTable({41, 30}), nullptr);
        QCOMPARE(resets.count(), 1);
        QVERIFY(!bench.shown.current());
    }

    void theCurrentCellIsThePointOfThePicture()
    {
        Fixture bench(sharedTable({40, 30}));
        bench.table->setCurrentIndex(bench.model().index(20, 7));
        QCOMPARE(bench.shown.current(), std::optional(GridPoint{7, 20}));
        bench.shown.setCurrent(GridPoint{30, 2});
        QCOMPARE(bench.table->currentIndex(), bench.model().index(2, 30));
        const auto* readout = bench.view->findChild<QLabel*>(QStringLiteral("valuesReadout"));
        QCOMPARE(readout->text(), bench.shown.pointText({30, 2}));
        bench.shown.setCurrent(std::nullopt);
        QVERIFY(!bench.table->currentIndex().isValid());
    }

    void copiedCellsAreLinesWithTabs()
    {
        const CompensationTable map = namedTable({3, 2});
        const auto value = [&](std::size_t i) {
            return QString::fromLatin1(plainValue(map.values[i]));
        };
        const CopyHeaders headers{QStringLiteral("X [mm]"), QStringLiteral("Y [mm]")};
        QCOMPARE(copiedText({map}, {{0, 1, 1, 2}}, nullptr),
            QStringLiteral("%1\t%2\n%3\t%4\n").arg(value(1), value(2), value(4), value(5)));
        QCOMPARE(copiedText({map}, {{0, 1, 1, 2}}, &headers),
            QStringLiteral("Y [mm] \\ X [mm]\t2.5\t5\n100\t%1\t%2\n102.5\t%3\t%4\n")
                .arg(value(1), value(2), value(4), value(5)));
        // Two corners: what is not chosen stays empty.
        QCOMPARE(copiedText({map}, {{0, 0, 0, 0}, {1, 2, 1, 2}}, nullptr),
            QStringLiteral("%1\t\n\t%2\n").arg(value(0), value(5)));
        const CompensationTable curve = namedTable({3});
        const CopyHeaders names{QStringLiteral("X [mm]"), QStringLiteral("compensation [mm]")};
        QCOMPARE(copiedText({curve}, {{1, 1, 1, 1}}, &names),
            QStringLiteral("X [mm]\tcompensation [mm]\n2.5\t%1\n").arg(value(1)));
        QCOMPARE(copiedText({curve}, {{1, 0, 1, 1}}, nullptr),
            QStringLiteral("2.5\t%1\n").arg(value(1)));
    }

    void theKeyboardCopiesEverything()
    {
        QLocale::setDefault(QLocale(QLocale::German)); // and yet a decimal point
        Fixture bench(sharedTable({3, 2}));
        QVERIFY(QTest::qWaitForWindowActive(bench.view.get()));
        bench.table->setFocus();
        QTest::keyClick(bench.table, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClick(bench.table, Qt::Key_C, Qt::ControlModifier);
        const CompensationTable table = namedTable({3, 2});
        const CopiedTable copied{table, bench.shown.valueScale()};
        const QString all = copiedText(copied, {{0, 0, 1, 2}}, nullptr);
        // In the unit that is seen, with every digit.
        QVERIFY(all.contains(QString::fromLatin1(plainValue(table.values[1] * 1000.0F).left(6))));
        QTRY_COMPARE(QGuiApplication::clipboard()->text(), all);
        const CopyHeaders headers{QStringLiteral("X [mm]"), QStringLiteral("Y [mm]")};
        QTest::keyClick(bench.table, Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_COMPARE(
            QGuiApplication::clipboard()->text(), copiedText(copied, {{0, 0, 1, 2}}, &headers));
    }

    void halfAMillionPointsNeverStopTheWindow_data()
    {
        QTest::addColumn<QList<int>>("sizes");
        QTest::newRow("1D") << QList<int>{518'400};
        QTest::newRow("2D") << QList<int>{720, 720};
        QTest::newRow("flat 2D") << QList<int>{2, 259'200};
        QTest::newRow("wide 2D") << QList<int>{259'200, 2};
    }
    void halfAMillionPointsNeverStopTheWindow()
    {
        QFETCH(QList<int>, sizes);
        const std::vector<std::uint32_t> wanted(sizes.begin(), sizes.end());
        const auto selected = sharedTable(wanted);
        const auto onDrive = sharedTable(wanted, 1.0);
        Fixture bench(nullptr);
        QVERIFY(QTest::qWaitForWindowActive(bench.view.get()));
        bench.table->setFocus();
        test::Heartbeat heart;
        bench.shown.setTables(selected, onDrive);
        QTRY_VERIFY(heart.beats() > 10);
        QSignalSpy changes(&bench.shown, &TableViewModel::changed);
        bench.shown.setContent(TableContent::Difference);
        QTRY_COMPARE(changes.count(), 1);
        bench.table->scrollToBottom();
        const int beats = heart.beats();
        QTRY_VERIFY(heart.beats() > beats + 10);
        // Whatever the machine: what is on another thread since it takes too long.
        const auto longest = heart.longestBusy();
        const auto start = test::Heartbeat::busy();
        const QString all = copiedText({*bench.shown.drawn(), bench.shown.valueScale()},
            {{0, 0, bench.model().rowCount() - 1, bench.model().columnCount() - 1}}, nullptr);
        const auto copying = test::Heartbeat::busy() - start;
        QVERIFY(!all.isEmpty());
        QVERIFY2(longest < copying / 4,
            qPrintable(QStringLiteral("%1 us of %2 us").arg(longest.count()).arg(copying.count())));
        QGuiApplication::clipboard()->clear();
        QSignalSpy copied(QGuiApplication::clipboard(), &QClipboard::dataChanged);
        bench.table->selectAll();
        QTest::keyClick(bench.table, Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(copied.count(), 0); // the text is made on another thread
        QTRY_COMPARE(copied.count(), 1);
        const auto cells =
            QGuiApplication::clipboard()->text().count(u'\t') + bench.model().rowCount();
        QCOMPARE(cells, qsizetype(bench.model().rowCount()) * bench.model().columnCount());
    }
};

AXISCOMP_WINDOW_TEST(TestValuesModel)

} // namespace tst_valuesmodel

#include "tst_valuesmodel.moc"
