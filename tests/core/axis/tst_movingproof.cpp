// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/axis/moving_proof.h"

#include "tests/support/compensator_fixture.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <cmath>
#include <set>

namespace tst_movingproof {

using namespace axiscomp;
using namespace std::chrono_literals;
using test::CompensatorFixture;

namespace {

/// Ten cells of 10 mm over the travel of X, 0 to 100, with an output nearly everywhere.
WriteRequest tenCells()
{
    WriteRequest request;
    request.dimensionality = 1;
    request.sources = {test::masterX};
    request.table = test::exampleTable(1, 1, 11);
    return request;
}

/// An axis with a table, active, and its proof.
struct Active : CompensatorFixture {
    explicit Active(const WriteRequest& request = tenCells(), bool readsAtOneInstant = true)
    {
        const auto report = compensator.write(0, request);
        if (!report)
            qFatal("%s", test::describe(report.error()).c_str());
        switchOn();
        proof.emplace(std::make_shared<const CompensationTable>(*request.table),
            report->now.table->crc, readsAtOneInstant);
    }
    void switchOn()
    {
        const auto on = compensator.activate(0);
        if (!on)
            qFatal("%s", test::describe(on.error()).c_str());
        pass(50ms); // the ramp
    }
    AxisStatus look()
    {
        const auto status = compensator.status(0);
        if (!status)
            qFatal("%s", test::describe(status.error()).c_str());
        proof->add(*status);
        return *status;
    }

    std::optional<MovingProof> proof;
};

} // namespace

class TestMovingProof : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void whatTheAxisHasPassedIsProved()
    {
        Active f;
        std::set<int> cells;
        for (int i = 0; i < 40; ++i) {
            const AxisStatus status = f.look();
            cells.insert(std::min(static_cast<int>(status.sourceValues[0] / 10.0), 9));
            QVERIFY(!f.proof->failure());
            QCOMPARE(f.proof->part().share(), static_cast<double>(cells.size()) / 10.0);
            f.pass(1s);
        }
        QVERIFY(f.proof->hasContent());
        QVERIFY2(cells.size() == 10, "the axis has been everywhere");
        for (const std::size_t cell : f.proof->part().seen())
            QCOMPARE(f.proof->part().middleOf(cell)[0], 10.0 * static_cast<double>(cell) + 5.0);
    }

    void aDriveThatAddsSomethingElseIsFound()
    {
        Active f;
        f.look();
        QVERIFY(!f.proof->failure());
        f.link.altersReading = [](RegisterReading& reading) {
            if (reading.path == "Axes[0]/Signals/Compensations/Axis/Output")
                reading.value = std::get<float>(reading.value) + 1e-5F;
        };
        const double share = f.proof->part().share();
        f.pass(10s);
        f.look();
        QVERIFY(f.proof->failure());
        QVERIFY(f.proof->failure()->code == ErrorCode::ProofFailed);
        // It is over: what follows proves nothing any more.
        f.link.altersReading = {};
        f.pass(10s);
        f.look();
        QVERIFY(f.proof->failure());
        QCOMPARE(f.proof->part().share(), share);
    }

    void beyondTheTableNothingIsProved()
    {
        WriteRequest request = tenCells();
        request.table->grid.axes[0].start = 200.0;
        Active f(request);
        for (int i = 0; i < 10; ++i) {
            f.look();
            f.pass(3s);
        }
        QVERIFY(!f.proof->failure());
        QVERIFY(!f.proof->isWithinTable());
        QVERIFY(!f.proof->hasContent());
        QCOMPARE(f.proof->part().share(), 0.0);
    }

    void zerosHaveNoContent()
    {
        WriteRequest request = tenCells();
        std::ranges::fill(request.table->values, 0.0F);
        Active f(request);
        f.look();
        QVERIFY(!f.proof->hasContent());
        QVERIFY(f.proof->part().share() > 0.0);
    }

    /// A drive that adds nothing at all is within what the axis may have moved meanwhile.
    void whatTheMotionHidesHasNoContent()
    {
        Active f(tenCells(), false);
        AxisStatus status = f.look();
        // sin(0.7 * x / 10 + 1) is 0 near 30.6: the table has the opposite values on either side.
        f.proof.emplace(
            std::make_shared<const CompensationTable>(*tenCells().table), status.table->crc, false);
        status.sourceValues[0] = 25.0;
        f.proof->add(status); // the first of all: where the next one comes from
        status.sourceValues[0] = 35.0;
        status.output = 0.0;
        status.indices[0] = 3.5;
        f.proof->add(status);
        QVERIFY(!f.proof->failure());
        QVERIFY(f.proof->isWithinTable());
        QVERIFY(!f.proof->hasContent());
    }

    void whatIsNotActiveIsLeftOut()
    {
        Active f;
        VERIFY_RESULT(f.compensator.deactivate(0));
        f.pass(50ms);
        f.look();
        QCOMPARE(f.proof->part().share(), 0.0);
        VERIFY_RESULT(f.compensator.evaluate(0));
        f.look();
        QVERIFY(!f.proof->failure());
        QCOMPARE(f.proof->part().share(), 0.0);
    }

    void anotherTableIsNotTakenForThisOne()
    {
        Active f;
        VERIFY_RESULT(f.compensator.deactivate(0));
        WriteRequest another = tenCells();
        another.table = test::exampleTable(1, 2, 11); // the same grid
        VERIFY_RESULT(f.compensator.write(0, another));
        f.switchOn();
        f.look();
        QVERIFY(!f.proof->failure());
        QCOMPARE(f.proof->part().share(), 0.0);
    }

    /// Register by register, an axis moves while it is read: as far as since the last reading.
    void aReadingThatIsNotOfOneInstantMayHaveMoved()
    {
        Active f(tenCells(), false);
        f.look();
        QCOMPARE(f.proof->part().share(), 0.0); // nothing to compare its motion with
        f.pass(100ms);
        const AxisStatus before = f.look();
        QVERIFY(f.proof->part().share() > 0.0);
        AxisStatus late = before;
        late.sourceValues[0] += 0.5;
        f.proof->add(late); // output and index of 0.5 mm before
        QVERIFY(!f.proof->failure());
        f.proof->add(late); // and now at rest
        QVERIFY(f.proof->failure());
    }

    void cellsOfSeveralDimensionsAreCountedOnce()
    {
        ProvedPart part(Grid{{{{}, {}, 0.0, 10.0, 3}, {{}, {}, -5.0, 1.0, 4}}});
        part.add({0.0, -5.0, 0.0});
        part.add({9.9, -4.1, 0.0});
        QCOMPARE(part.seen(), (std::vector<std::size_t>{0}));
        part.add({20.0, -2.0, 0.0}); // the last corner belongs to the last cell
        QCOMPARE(part.seen(), (std::vector<std::size_t>{0, 5}));
        QCOMPARE(part.share(), 2.0 / 6.0);
        part.add({20.1, -2.0, 0.0});
        part.add({-0.1, -2.0, 0.0});
        part.add({std::nan(""), -2.0, 0.0});
        QCOMPARE(part.seen().size(), std::size_t{2});
        QCOMPARE(part.middleOf(5)[0], 15.0);
        QCOMPARE(part.middleOf(5)[1], -2.5);
    }
};

AXISCOMP_TEST(TestMovingProof)

} // namespace tst_movingproof

#include "tst_movingproof.moc"
