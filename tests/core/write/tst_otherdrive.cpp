// SPDX-License-Identifier: GPL-3.0-or-later
//
// A reply is lost, and from then on another drive has the address: half of an operation must not go
// on there.
#include "tests/support/compensator_fixture.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

namespace tst_otherdrive {

using namespace axiscomp;
using test::CompensatorFixture;
using test::exampleRequest;
using test::exampleTable;

namespace {

const std::string activation = "Axes[0]/Commands/Compensations/Axis/Activation";

/// A link to one drive until a reply is lost, and to another drive after that.
class ReroutedLink final : public DriveLink {
public:
    ReroutedLink(drivecomm::VirtualDrive& first, drivecomm::VirtualDrive& second)
        : m_first(drivecomm::makeDirectLink(first))
        , m_second(drivecomm::makeDirectLink(second))
    {
    }

    /// number counts from 1.
    void loseReply(int number) { m_loseAt = m_exchanges + number; }
    /// The same, without a reply that is lost: a gateway keeps the connection.
    void reroute(int number)
    {
        loseReply(number);
        m_isSilent = true;
    }
    [[nodiscard]] int exchanges() const { return m_exchanges; }
    [[nodiscard]] bool isRerouted() const { return m_isRerouted; }

    [[nodiscard]] std::string endpoint() const override { return "test:"; }
    [[nodiscard]] Result<DriveIdentity> identify(const Exchange& e) override
    {
        return pass([&](DriveLink& link) { return link.identify(e); });
    }
    [[nodiscard]] Result<std::vector<RegisterReading>> readRegisters(
        std::span<const std::string> paths, const Exchange& e) override
    {
        return pass([&](DriveLink& link) { return link.readRegisters(paths, e); });
    }
    [[nodiscard]] Result<std::vector<RegisterReading>> readTree(
        const std::string& prefix, const Exchange& e) override
    {
        return pass([&](DriveLink& link) { return link.readTree(prefix, e); });
    }
    [[nodiscard]] Result<void> writeRegisters(
        std::span<const RegisterWrite> writes, const Exchange& e) override
    {
        return pass([&](DriveLink& link) { return link.writeRegisters(writes, e); });
    }
    [[nodiscard]] Result<std::vector<DriveFile>> listFiles(const Exchange& e) override
    {
        return pass([&](DriveLink& link) { return link.listFiles(e); });
    }
    [[nodiscard]] Result<Bytes> download(const std::string& path, const Exchange& e) override
    {
        return pass([&](DriveLink& link) { return link.download(path, e); });
    }
    [[nodiscard]] Result<void> upload(
        const std::string& path, ByteView bytes, const Exchange& e) override
    {
        return pass([&](DriveLink& link) { return link.upload(path, bytes, e); });
    }

private:
    template <typename Call> auto pass(const Call& call) -> decltype(call(*this))
    {
        ++m_exchanges;
        auto result = call(m_isRerouted ? *m_second : *m_first);
        if (m_exchanges != m_loseAt)
            return result;
        m_isRerouted = true;
        if (m_isSilent)
            return result;
        return fail(ErrorCode::ConnectionLost,
            {{"endpoint", Verbatim{"test:"}}, {"reason", Verbatim{"cut"}}});
    }

    std::unique_ptr<DriveLink> m_first;
    std::unique_ptr<DriveLink> m_second;
    int m_exchanges = 0;
    int m_loseAt = 0;
    bool m_isRerouted = false;
    bool m_isSilent = false;
};

drivecomm::VirtualDriveOptions optionsOfOther(std::atomic<std::int64_t>& time)
{
    drivecomm::VirtualDriveOptions options = CompensatorFixture::options(time);
    options.name = "Test-2";
    options.serialNumber = 4712;
    return options;
}

/// Parameters, requests and files: what an operation could change.
struct Contents {
    std::vector<std::string> registers;
    std::vector<Bytes> files;
    friend bool operator==(const Contents&, const Contents&) = default;
};

Contents contentsOf(drivecomm::VirtualDrive& drive)
{
    Contents contents;
    for (const char* prefix : {"Axes[0]/Parameters", "Axes[0]/Commands", "Axes[1]/Parameters"})
        for (const RegisterReading& reading : drive.readTree(prefix))
            contents.registers.push_back(reading.path + " = " + toText(reading.value));
    for (const TableSlot& slot : drivecomm::genericProfile().tableSlots)
        contents.files.push_back(drive.download(slot.file).value_or(Bytes{}));
    return contents;
}

/// Two drives with the same table; the second takes the first one's place.
struct Exchanged : CompensatorFixture {
    Exchanged()
    {
        AxisCompensator there(*otherLink, drivecomm::genericProfile(), store);
        VERIFY_RESULT(compensator.write(0, wide(1)));
        VERIFY_RESULT(there.write(0, wide(1)));
        old = contentsOf(other);
    }
    static WriteRequest wide(int seed, Persistency persistency = Persistency::Volatile)
    {
        WriteRequest request = exampleRequest(seed, persistency);
        for (GridAxis& axis : request.table->grid.axes)
            axis.distance *= 2.5;
        return request;
    }
    [[nodiscard]] bool isUnfinished() { return store.journal(4711, 0).value().has_value(); }

    drivecomm::VirtualDrive other{drivecomm::genericProfile(), optionsOfOther(time)};
    std::unique_ptr<DriveLink> otherLink = drivecomm::makeDirectLink(other);
    ReroutedLink rerouted{drive, other};
    AxisCompensator operated{
        rerouted, drivecomm::genericProfile(), store, [this] { return wallTime(); }};
    Contents old; ///< of the other drive
};

} // namespace

class TestOtherDrive : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aWriteNeitherGoesOnNorIsPutBackInAnotherDrive_data()
    {
        QTest::addColumn<int>("request");
        QTest::newRow("volatile") << 0;
        QTest::newRow("persistent") << 1;
        QTest::newRow("in place") << 2;
        QTest::newRow("deletion") << 3;
    }
    void aWriteNeitherGoesOnNorIsPutBackInAnotherDrive()
    {
        QFETCH(int, request);
        WriteRequest wanted = request == 3
            ? deletionRequest()
            : Exchanged::wide(2, request == 1 ? Persistency::Persistent : Persistency::Volatile);
        if (request == 2)
            wanted.slot = "Small1";
        int unknown = 0;
        for (int exchange = 1;; ++exchange) {
            Exchanged c;
            c.rerouted.loseReply(exchange);
            const auto report = c.operated.write(0, wanted);
            if (!c.rerouted.isRerouted())
                break; // it was over before
            const std::string place = "exchange " + std::to_string(exchange) + ": "
                + (report ? "success" : test::describe(report.error()));
            QVERIFY2(!report, place.c_str());
            QVERIFY2(contentsOf(c.other) == c.old, place.c_str());
            const ErrorCode code = report.error().code;
            if (code != ErrorCode::OutcomeUnknown && code != ErrorCode::RollbackFailed)
                continue;
            ++unknown;
            QVERIFY2(c.isUnfinished(), place.c_str());
            QVERIFY2(place.find("expected serial number 4711, found 4712") != std::string::npos,
                place.c_str());
        }
        QVERIFY(unknown > 3);
    }

    void onlyTheDriveOfThePlanIsWritten()
    {
        Exchanged c;
        WriteRequest request = Exchanged::wide(2);
        const auto plan = c.compensator.plan(0, request);
        VERIFY_RESULT(plan);
        request.expected = plannedState(*plan);
        request.expectedDrive = plan->drive.serialNumber;
        AxisCompensator there(*c.otherLink, drivecomm::genericProfile(), c.store);
        const auto refused = there.write(0, request);
        VERIFY_ERROR(refused, ErrorCode::OtherDrive);
        QCOMPARE(refused.error().context.english("expected"), std::string("4711"));
        QVERIFY(contentsOf(c.other) == c.old);
        VERIFY_RESULT(c.compensator.write(0, request));
    }

    void aSwitchNeitherGoesOnNorIsProvedInAnotherDrive()
    {
        int unknown = 0;
        for (int exchange = 1;; ++exchange) {
            Exchanged c;
            c.rerouted.loseReply(exchange);
            const auto result = c.operated.switchTo(0, Switch::Activate);
            if (!c.rerouted.isRerouted())
                break;
            const std::string place = "exchange " + std::to_string(exchange);
            QVERIFY2(!result || !*result->proof, place.c_str());
            QVERIFY2(contentsOf(c.other) == c.old, place.c_str());
            if (result)
                QVERIFY2(!result->isPutBack, place.c_str());
            const bool isSaid = !result && result.error().context.contains("compensation");
            unknown += isSaid ? 1 : 0;
            if (!result && c.text(activation) != "Disabled")
                QVERIFY2(isSaid, place.c_str());
        }
        QVERIFY(unknown > 1);
    }

    /// The other drive may have been switched then; nobody is told that it was this one.
    void aSwitchIsConfirmedByTheDriveItself_data()
    {
        QTest::addColumn<bool>("isOn");
        QTest::newRow("off") << false;
        QTest::newRow("on") << true;
    }
    void aSwitchIsConfirmedByTheDriveItself()
    {
        QFETCH(bool, isOn);
        int refused = 0;
        for (int exchange = 1;; ++exchange) {
            Exchanged c;
            if (!isOn)
                VERIFY_RESULT(c.compensator.activate(0));
            c.rerouted.reroute(exchange);
            const auto result = isOn ? c.operated.evaluate(0) : c.operated.deactivate(0);
            if (!c.rerouted.isRerouted())
                break;
            const std::string place = "exchange " + std::to_string(exchange);
            const std::string wanted = isOn ? "Evaluating" : "Disabled";
            const std::string state = c.text("Axes[0]/Signals/Compensations/Axis/State");
            QVERIFY2(!result || state == wanted, place.c_str());
            refused += !result && result.error().code == ErrorCode::OtherDrive ? 1 : 0;
        }
        QVERIFY(refused > 1);
    }

    void aFileIsConfirmedByTheDriveItself_data()
    {
        QTest::addColumn<bool>("isDeletion");
        QTest::newRow("upload") << false;
        QTest::newRow("deletion") << true;
    }
    void aFileIsConfirmedByTheDriveItself()
    {
        QFETCH(bool, isDeletion);
        const std::string path = "tables/small5.TAMtbl";
        const auto& layout = drivecomm::genericProfile().layout;
        const Bytes old = *encodeTamTable(exampleTable(1, 1), false, layout);
        const Bytes wanted =
            isDeletion ? Bytes{} : *encodeTamTable(exampleTable(1, 2), false, layout);
        int refused = 0;
        for (int exchange = 1;; ++exchange) {
            Exchanged c;
            VERIFY_RESULT(c.drive.upload(path, old));
            VERIFY_RESULT(c.other.upload(path, old));
            c.rerouted.reroute(exchange);
            const auto result = isDeletion ? c.operated.deleteSlot("Small5", {}, 4711)
                                           : c.operated.upload(path, wanted, {}, 4711);
            if (!c.rerouted.isRerouted())
                break;
            const std::string place = "exchange " + std::to_string(exchange);
            const Bytes held = c.drive.download(path).value_or(Bytes{});
            QVERIFY2(!result || held == wanted, place.c_str());
            refused += result ? 0 : 1;
        }
        QVERIFY(refused > 1);
    }

    void onlyTheDriveOfThePlanGetsAFile()
    {
        Exchanged c;
        const std::string path = "tables/small5.TAMtbl";
        const Bytes file =
            *encodeTamTable(exampleTable(1, 1), false, drivecomm::genericProfile().layout);
        VERIFY_RESULT(c.other.upload(path, file));
        c.old = contentsOf(c.other);
        const auto plan = c.compensator.planUpload(path, file);
        VERIFY_RESULT(plan);
        QCOMPARE(plan->drive.serialNumber, 4711);
        AxisCompensator there(*c.otherLink, drivecomm::genericProfile(), c.store);
        VERIFY_ERROR(there.upload(path, {}, {}, plan->drive.serialNumber), ErrorCode::OtherDrive);
        VERIFY_ERROR(there.deleteSlot("Small5", {}, 4711), ErrorCode::OtherDrive);
        QVERIFY(contentsOf(c.other) == c.old);
    }
};

AXISCOMP_TEST(TestOtherDrive)

} // namespace tst_otherdrive

#include "tst_otherdrive.moc"
