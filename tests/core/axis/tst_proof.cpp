// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/axis/proof.h"

#include "core/table/lookup.h"
#include "tests/support/compensator_fixture.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <algorithm>
#include <cmath>

namespace tst_proof {

using namespace axiscomp;
using test::CompensatorFixture;
using test::exampleRequest;

namespace {

const std::string activation = "Axes[0]/Commands/Compensations/Axis/Activation";
const std::string output = "Axes[0]/Signals/Compensations/Axis/Output";

std::string indexPath(int dimension)
{
    return "Axes[0]/Signals/Compensations/Axis/Dim" + std::to_string(dimension) + "Index";
}

/// Adds to what a register of the drive says.
std::function<void(RegisterReading&)> adding(const std::string& path, double amount)
{
    return [path, amount](RegisterReading& reading) {
        if (reading.path != path)
            return;
        const double value = std::stod(toText(reading.value)) + amount;
        if (std::holds_alternative<float>(reading.value))
            reading.value = static_cast<float>(value);
        else
            reading.value = value;
    };
}

/// A table that covers wherever the axes are.
WriteRequest wideRequest()
{
    WriteRequest request = exampleRequest();
    for (GridAxis& axis : request.table->grid.axes)
        axis.distance *= 2.5;
    return request;
}

/// A 2D table that is written to axis 0.
struct Written : CompensatorFixture {
    explicit Written(const WriteRequest& request = wideRequest(),
        const DriveProfile& profile = drivecomm::genericProfile())
        : CompensatorFixture(test::inProcess(), profile)
    {
        const auto report = compensator.write(0, request);
        if (!report)
            qFatal("%s", test::describe(report.error()).c_str());
    }
    Result<Proof> proofOf(Switch wanted)
    {
        const auto switched = compensator.switchTo(0, wanted);
        return switched ? *switched->proof : Result<Proof>(fail(switched.error()));
    }
};

/// The largest value of a table, which the tolerance is a part of.
double tolerance()
{
    Written f;
    return f.proofOf(Switch::Activate)->tolerance;
}

} // namespace

class TestProof : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void anOutputThatDiffersIsFound_data()
    {
        QTest::addColumn<double>("tolerances");
        QTest::addColumn<bool>("isProved");
        QTest::newRow("two more") << 2.0 << false;
        QTest::newRow("two less") << -2.0 << false;
        QTest::newRow("half of one more") << 0.5 << true;
        QTest::newRow("half of one less") << -0.5 << true;
    }
    void anOutputThatDiffersIsFound()
    {
        QFETCH(double, tolerances);
        QFETCH(bool, isProved);
        const double amount = tolerances * tolerance();
        Written f;
        f.link.altersReading = adding(output, amount);
        const auto proof = f.proofOf(Switch::Activate);
        if (isProved) {
            VERIFY_RESULT(proof);
            return;
        }
        VERIFY_ERROR(proof, ErrorCode::ProofFailed);
        const std::string said = sentence(proof.error());
        QVERIFY2(said.find("the output at ") != std::string::npos, said.c_str());
        QVERIFY2(said.find("MasterPosition = ") != std::string::npos, said.c_str());
    }

    /// Eight roundings of float32, of the largest value.
    void theToleranceIsThatOfSingleNumbers()
    {
        const WriteRequest request = wideRequest();
        float largest = 0.0F;
        for (const float value : request.table->values)
            largest = std::max(largest, std::abs(value));
        QVERIFY(tolerance() == 8.0 * std::ldexp(static_cast<double>(largest), -24));
    }

    void whatIsOffCannotBeProved()
    {
        Written f;
        VERIFY_ERROR(f.compensator.prove(0), ErrorCode::CompensationError);
    }

    void anIndexThatDiffersIsFound_data()
    {
        QTest::addColumn<int>("dimension");
        QTest::addColumn<double>("amount");
        QTest::addColumn<int>("wanted");
        for (const int wanted : {0, 1})
            for (const int dimension : {1, 2})
                for (const double amount : {1e-5, -1e-5, 1.0})
                    QTest::addRow("dimension %d, %g, %s", dimension, amount,
                        wanted == 0 ? "active" : "evaluating")
                        << dimension << amount << wanted;
    }
    void anIndexThatDiffersIsFound()
    {
        QFETCH(int, dimension);
        QFETCH(double, amount);
        QFETCH(int, wanted);
        Written f;
        f.link.altersReading = adding(indexPath(dimension), amount);
        const auto proof = f.proofOf(wanted == 0 ? Switch::Activate : Switch::Evaluate);
        VERIFY_ERROR(proof, ErrorCode::ProofFailed);
        QVERIFY2(sentence(proof.error()).find("index of dimension " + std::to_string(dimension))
                != std::string::npos,
            sentence(proof.error()).c_str());
    }

    void anOutputWhileEvaluatingIsFound()
    {
        Written f;
        f.link.altersReading = adding(output, 1e-4);
        VERIFY_ERROR(f.proofOf(Switch::Evaluate), ErrorCode::ProofFailed);
    }

    void whatMovesBetweenTheReadingsIsAllowedForAndNoMore()
    {
        DriveProfile profile = drivecomm::genericProfile();
        profile.readsAtOneInstant = false;
        {
            Written f(wideRequest(), profile);
            VERIFY_RESULT(f.proofOf(Switch::Activate));
        }
        Written f(wideRequest(), profile);
        f.link.altersReading = adding(output, 2e-3);
        VERIFY_ERROR(f.proofOf(Switch::Activate), ErrorCode::ProofFailed);
        f.link.altersReading = adding(indexPath(2), 0.1);
        VERIFY_ERROR(f.proofOf(Switch::Activate), ErrorCode::ProofFailed);
    }

    /// The axis moves by some 10 um from one request to the next.
    void aSourceThatIsReadLaterThanTheOutputIsNoError()
    {
        DriveProfile profile = drivecomm::genericProfile();
        for (const bool isOneInstant : {false, true}) {
            profile.readsAtOneInstant = isOneInstant;
            Written f(wideRequest(), profile);
            f.link.altersReading = adding(test::masterX, 1e-3);
            QCOMPARE(f.proofOf(Switch::Evaluate).has_value(), !isOneInstant);
        }
    }

    void aProofThatFailsSwitchesOffAgain()
    {
        Written f;
        f.link.altersReading = adding(output, 1e-3);
        const auto result = f.compensator.switchTo(0, Switch::Activate);
        VERIFY_RESULT(result);
        QVERIFY(!*result->proof);
        QVERIFY(result->isPutBack);
        QVERIFY(!result->status.isOn());
        QCOMPARE(f.text(activation), "Disabled");
    }

    void aProofThatFailsGoesBackToTheEvaluation()
    {
        Written f;
        VERIFY_RESULT(f.compensator.evaluate(0));
        f.link.altersReading = adding(output, 1e-3);
        const auto result = f.compensator.switchTo(0, Switch::Activate);
        VERIFY_RESULT(result);
        QVERIFY(!*result->proof);
        QVERIFY(result->isPutBack);
        QCOMPARE(f.text(activation), "Evaluate");
    }

    void whatWasOnBeforeStaysOnWhenItsProofFails()
    {
        Written f;
        VERIFY_RESULT(f.compensator.activate(0));
        f.link.altersReading = adding(output, 1e-3);
        const auto result = f.compensator.switchTo(0, Switch::Activate);
        VERIFY_RESULT(result);
        QVERIFY(!*result->proof);
        QVERIFY(!result->isPutBack);
        QCOMPARE(f.text(activation), "AddToEncoders");
    }

    void aUserWhoStopsTheProofGetsTheOldStateBack()
    {
        Written f;
        std::stop_source user;
        OperationOptions options;
        options.stop = user.get_token();
        int readings = 0;
        f.link.altersReading = [&](RegisterReading& reading) {
            const bool isSample = reading.path == indexPath(1)
                && f.text("Axes[0]/Signals/Compensations/Axis/State") == "Active";
            if (isSample && ++readings == 3)
                user.request_stop();
        };
        const auto result = f.compensator.switchTo(0, Switch::Activate, 5, options);
        VERIFY_RESULT(result);
        QVERIFY(!*result->proof);
        QCOMPARE(result->proof->error().code, ErrorCode::Cancelled);
        QVERIFY(result->isPutBack);
        QCOMPARE(f.text(activation), "Disabled");
    }

    void aUserWhoStopsTheSwitchGetsTheOldStateBack()
    {
        int stopped = 0;
        bool isDone = false;
        for (int exchange = 1; !isDone; ++exchange) {
            Written f;
            std::stop_source user;
            OperationOptions options;
            options.stop = user.get_token();
            f.link.actBefore(exchange, [&user] { user.request_stop(); });
            const int before = f.link.exchanges();
            const auto result = f.compensator.switchTo(0, Switch::Activate, 2, options);
            isDone = f.link.exchanges() - before < exchange;
            if (result && *result->proof)
                continue;
            ++stopped;
            QCOMPARE(f.text(activation), "Disabled");
        }
        QVERIFY(stopped > 5);
    }

    void aDamagedTableIsNotSwitchedOn()
    {
        for (const Switch wanted : {Switch::Activate, Switch::Evaluate}) {
            Written f;
            f.link.altersDownload = [](Bytes& bytes) { bytes.back() ^= std::byte{1}; };
            VERIFY_ERROR(f.compensator.switchTo(0, wanted), ErrorCode::InvalidTable);
            VERIFY_ERROR(f.compensator.activate(0), ErrorCode::InvalidTable);
            VERIFY_ERROR(f.compensator.evaluate(0), ErrorCode::InvalidTable);
            QCOMPARE(f.text(activation), "Disabled");
        }
    }

    void outsideOfTheTableNothingIsProved()
    {
        WriteRequest request = exampleRequest();
        request.table->grid.axes[0].start = -2000.0;
        for (float& value : request.table->values)
            value = 0.001F;
        Written f(request);
        for (const Switch wanted : {Switch::Evaluate, Switch::Activate}) {
            VERIFY_RESULT(f.compensator.deactivate(0));
            const auto proof = f.proofOf(wanted);
            VERIFY_RESULT(proof);
            QVERIFY(proof->extent == Proof::Extent::OutsideTable);
        }
    }

    void outsideInTheSecondDimensionNothingIsProvedEither()
    {
        WriteRequest request = wideRequest();
        request.table->grid.axes[1].start = -2000.0;
        Written f(request);
        const auto proof = f.proofOf(Switch::Evaluate);
        VERIFY_RESULT(proof);
        QVERIFY(proof->extent == Proof::Extent::OutsideTable);
    }

    void zerosProveNothingWhileActive()
    {
        WriteRequest request = wideRequest();
        std::ranges::fill(request.table->values, 0.0F);
        Written f(request);
        const auto proof = f.proofOf(Switch::Activate);
        VERIFY_RESULT(proof);
        QVERIFY(proof->extent == Proof::Extent::OnlyZeros);
        VERIFY_RESULT(f.compensator.deactivate(0));
        const auto evaluated = f.proofOf(Switch::Evaluate);
        VERIFY_RESULT(evaluated);
        QVERIFY(evaluated->extent == Proof::Extent::IndicesOnly);
    }

    /// They are all that can be seen while it evaluates, and too little of an active one.
    void indicesAloneAreWarnedOfUnlessItEvaluates()
    {
        Proof proof;
        proof.extent = Proof::Extent::IndicesOnly;
        for (const auto state : {CompensationState::Evaluating, CompensationState::Active}) {
            Activation activation;
            activation.status.axis.state = state;
            QVERIFY(!activation.notProved());
            activation.proof = Result<Proof>(proof);
            QCOMPARE(activation.notProved().has_value(), state == CompensationState::Active);
        }
    }

    /// At home a table is often 0 but for a rounding: the opposite of it is within what is allowed.
    void whatIsTooSmallToBeSeenProvesNothing_data()
    {
        QTest::addColumn<double>("factor");
        QTest::newRow("the table") << 1.0;
        QTest::newRow("the opposite") << -1.0;
        QTest::newRow("nothing") << 0.0;
    }
    void whatIsTooSmallToBeSeenProvesNothing()
    {
        QFETCH(double, factor);
        WriteRequest request = exampleRequest();
        CompensationTable& table = *request.table;
        for (GridAxis& axis : table.grid.axes)
            axis.distance = 1000.0; // the axes are in the first cell
        std::ranges::fill(table.values, 1e-12F);
        table.values.back() = 0.003F;
        Written f(request);
        f.link.altersReading = [factor](RegisterReading& reading) {
            if (reading.path == output)
                reading.value = static_cast<float>(factor) * std::get<float>(reading.value);
        };
        const auto proof = f.proofOf(Switch::Activate);
        VERIFY_RESULT(proof);
        QVERIFY(proof->extent == Proof::Extent::OnlyZeros);
        const std::string said = notProvedText(proof->extent).english();
        QVERIFY2(said.find("too small to be seen") != std::string::npos, said.c_str());
    }

    void whatIsJustLargeEnoughToBeSeenIsProved()
    {
        for (const float part : {0.5F, 2.0F}) {
            WriteRequest request = exampleRequest();
            CompensationTable& table = *request.table;
            for (GridAxis& axis : table.grid.axes)
                axis.distance = 1000.0;
            std::ranges::fill(table.values, part * 8.0F * std::ldexp(0.003F, -24));
            table.values.back() = 0.003F;
            Written f(request);
            const auto proof = f.proofOf(Switch::Activate);
            VERIFY_RESULT(proof);
            QVERIFY(
                proof->extent == (part > 1.0F ? Proof::Extent::Proved : Proof::Extent::OnlyZeros));
        }
    }

    void aTableThatIsUsedIsProved()
    {
        Written f;
        for (const Switch wanted : {Switch::Evaluate, Switch::Activate}) {
            const auto proof = f.proofOf(wanted);
            VERIFY_RESULT(proof);
            QVERIFY(proof->extent
                == (wanted == Switch::Activate ? Proof::Extent::Proved
                                               : Proof::Extent::IndicesOnly));
            QVERIFY(proof->provedShare > 0.0 && proof->provedShare < 1.0); // the axis hardly moves
        }
    }
};

AXISCOMP_TEST(TestProof)

} // namespace tst_proof

#include "tst_proof.moc"
