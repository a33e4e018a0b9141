// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/table_samples.h"
#include "tests/ui/support/window_test.h"
#include "ui/data/table_view_model.h"
#include "ui/plot/table_plot.h"

#include <QTest>

#include <cmath>

#include "ui/drawing/custom_plot.h"

namespace tst_provedpart {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::sharedTable;

namespace {

/// The picture of the table on the drive.
struct Fixture {
    explicit Fixture(
        const TableViewModel::Table& onDrive, const TableViewModel::Table& selected = {})
    {
        shown.setTables(selected ? selected : onDrive, onDrive);
        proved = view.findChild<QCPGraph*>(QStringLiteral("provedPart"));
    }
    /// Keys and values as drawn, without the gaps.
    [[nodiscard]] std::vector<std::pair<double, double>> drawn() const
    {
        std::vector<std::pair<double, double>> points;
        for (const QCPGraphData& point : *proved->data())
            if (!std::isnan(point.value))
                points.emplace_back(point.key, point.value);
        return points;
    }

    TableViewModel shown;
    TablePlot view{shown};
    QCPGraph* proved = nullptr;
};

/// Seen in the middle of some cells.
ProvedPart seenAt(const Grid& grid, const std::vector<std::array<double, 3>>& indices)
{
    ProvedPart part(grid);
    for (const std::array<double, 3>& index : indices) {
        std::array<double, 3> place{};
        for (std::size_t n = 0; n < grid.axes.size(); ++n)
            place[n] = grid.axes[n].start + index[n] * grid.axes[n].distance;
        part.add(place);
    }
    return part;
}

} // namespace

class TestProvedPart : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void theCurveIsMarkedBetweenThePointsThatWerePassed()
    {
        const auto table = sharedTable({9});
        Fixture bench(table);
        const ProvedPart part = seenAt(table->grid, {{5.5}, {1.2}});
        bench.view.setProved(&part);
        std::vector<std::pair<double, double>> expected;
        for (const std::size_t point : {1U, 2U, 5U, 6U})
            expected.emplace_back(
                table->grid.axes[0].position(point), static_cast<double>(table->values[point]));
        QCOMPARE(bench.drawn(), expected);
        bench.view.setProved(nullptr);
        QVERIFY(bench.drawn().empty());
    }

    void theMapIsMarkedInTheCellsThatWerePassed()
    {
        const auto table = sharedTable({8, 7});
        Fixture bench(table);
        const ProvedPart part = seenAt(table->grid, {{2.4, 3.6}});
        bench.view.setProved(&part);
        const auto middle = [&](std::size_t axis, double index) {
            return table->grid.axes[axis].start + index * table->grid.axes[axis].distance;
        };
        QCOMPARE(bench.drawn(),
            (std::vector<std::pair<double, double>>{{middle(0, 2.5), middle(1, 3.5)}}));
    }

    void aSliceHasTheCellsOnBothSidesOfIt()
    {
        const auto table = sharedTable({6, 5, 4});
        Fixture bench(table);
        const ProvedPart part =
            seenAt(table->grid, {{0.5, 0.5, 0.5}, {1.5, 0.5, 1.5}, {2.5, 0.5, 2.5}});
        bench.view.setProved(&part);
        bench.shown.setSlice(3, 1);
        QCOMPARE(bench.drawn().size(), std::size_t{2});
        bench.shown.setSlice(3, 3);
        QCOMPARE(bench.drawn().size(), std::size_t{1});
    }

    /// A file that is not on the drive yet has not been proved.
    void anotherTableThanTheDrivesIsNotMarked()
    {
        const auto onDrive = sharedTable({9});
        const auto selected = std::make_shared<CompensationTable>(*onDrive);
        selected->values[4] += 1.0F;
        Fixture bench(onDrive, selected);
        const ProvedPart part = seenAt(onDrive->grid, {{5.5}});
        bench.view.setProved(&part);
        QVERIFY(bench.drawn().empty());
        bench.shown.setContent(TableContent::Drive);
        QCOMPARE(bench.drawn().size(), std::size_t{2});
    }
};

AXISCOMP_WINDOW_TEST(TestProvedPart)

} // namespace tst_provedpart

#include "tst_provedpart.moc"
