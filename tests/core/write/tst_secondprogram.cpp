// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two programs on two computers, which share no lock. An operation is run once to find its first
// change of the drive; then again for every exchange before that, with a second program that
// changes something just before it. Nothing of what the second one did may be lost.
#include "core/compensator/axis_operations.h"
#include "core/machine/snapshot.h"
#include "tests/support/compensator_fixture.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

namespace tst_secondprogram {

using namespace axiscomp;
using axiscomp::test::CompensatorFixture;
using axiscomp::test::exampleRequest;
using axiscomp::test::exampleTable;

namespace {

const std::string axis0 = "Axes[0]/Parameters/Compensations/Axis/";
const std::string axis1 = "Axes[1]/Parameters/Compensations/";

/// Everything that programs change: parameters, and the files of all slots.
struct Contents {
    std::vector<std::string> parameters;
    std::vector<Bytes> files;
    friend bool operator==(const Contents&, const Contents&) = default;
};

Contents contentsOf(drivecomm::VirtualDrive& drive)
{
    Contents contents;
    for (const char* prefix : {"Axes[0]/Parameters", "Axes[1]/Parameters"}) {
        for (const RegisterReading& reading : drive.readTree(prefix))
            contents.parameters.push_back(reading.path + " = " + toText(reading.value));
    }
    for (const TableSlot& slot : drivecomm::genericProfile().tableSlots)
        contents.files.push_back(drive.download(slot.file).value_or(Bytes{}));
    return contents;
}

Bytes tableFile(int seed)
{
    return *encodeTamTable(exampleTable(1, seed), false, drivecomm::genericProfile().layout);
}

/// An axis with one table; the write of another one takes `target`.
struct Case : CompensatorFixture {
    explicit Case(Persistency before)
    {
        const auto written = compensator.write(0, exampleRequest(1, before));
        QVERIFY2(written.has_value(), "the old table could not be written");
        const auto status = compensator.status(0);
        QVERIFY(status.has_value());
        seen = status->setup;
    }

    void upload(const std::string& slot, int seed)
    {
        QVERIFY(drive.upload(drivecomm::genericProfile().slotNamed(slot)->file, tableFile(seed))
                    .has_value());
    }

    CompensationSetup seen;
};

struct Operation {
    const char* name;
    Persistency before;
    std::function<Result<void>(Case&)> run;
};

template <typename T> Result<void> asVoid(const Result<T>& result)
{
    return result ? Result<void>{} : Result<void>(fail(result.error()));
}

Result<void> write(Case& c, WriteRequest request)
{
    request.expected = PlannedState{c.seen};
    return asVoid(c.compensator.write(0, request));
}

WriteRequest inPlace(Persistency persistency)
{
    WriteRequest request = exampleRequest(2, persistency);
    request.slot = "Small1";
    return request;
}

WriteRequest keepingTable(Persistency persistency)
{
    WriteRequest request = exampleRequest(1, persistency);
    request.table.reset();
    std::swap(request.sources[0], request.sources[1]);
    return request;
}

const std::vector<Operation> operations{
    {"replace, volatile", Persistency::Volatile,
        [](Case& c) { return write(c, exampleRequest(2, Persistency::Volatile)); }},
    {"replace, persistent", Persistency::Persistent,
        [](Case& c) { return write(c, exampleRequest(2, Persistency::Persistent)); }},
    {"in place", Persistency::Volatile,
        [](Case& c) { return write(c, inPlace(Persistency::Volatile)); }},
    {"other sources", Persistency::Volatile,
        [](Case& c) { return write(c, keepingTable(Persistency::Volatile)); }},
    {"make persistent", Persistency::Volatile,
        [](Case& c) { return write(c, keepingTable(Persistency::Persistent)); }},
    {"make volatile", Persistency::Persistent,
        [](Case& c) { return write(c, keepingTable(Persistency::Volatile)); }},
    {"plain upload", Persistency::Volatile,
        [](Case& c) { return asVoid(c.compensator.upload("tables/small2.TAMtbl", tableFile(5))); }},
    {"restore of a file", Persistency::Volatile,
        [](Case& c) {
            DriveBackup backup;
            backup.drive = c.drive.identity();
            backup.otherFiles = {{"Small2", "tables/small2.TAMtbl", tableFile(6), false}};
            return asVoid(c.compensator.restore(backup, false));
        }},
};

/// What the second program does.
struct Deed {
    const char* name;
    bool isOfAxis; ///< of the axis that is written; otherwise of the slot that the write takes
    std::function<void(Case&)> act;
};

const std::vector<Deed> deeds{
    {"another source", true, [](Case& c) { c.set(axis0 + "Dim2Source", std::uint32_t{0}); }},
    {"no table", true, [](Case& c) { c.set(axis0 + "Table", std::string("Disabled")); }},
    {"another table in its slot", true, [](Case& c) { c.upload("Small1", 8); }},
    {"a table in the other slot", false, [](Case& c) { c.upload("Small2", 9); }},
    {"another axis uses the other slot", false,
        [](Case& c) { c.set(axis1 + "Axis/Table", std::string("Small2")); }},
    {"a cogging compensation uses the other slot", false,
        [](Case& c) { c.set(axis1 + "Cogging/Table", std::string("Small2")); }},
    {"the compensation is activated", true,
        [](Case& c) {
            c.set("Axes[0]/Commands/Compensations/Axis/Activation", std::string("AddToEncoders"));
        }},
};

bool isRefusal(ErrorCode code)
{
    return code == ErrorCode::ChangedMeanwhile || code == ErrorCode::CompensationActive
        || code == ErrorCode::SlotInUse || code == ErrorCode::NoTable
        || code == ErrorCode::DimensionMismatch || code == ErrorCode::NotAllowedNow;
}

} // namespace

class TestSecondProgram : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void whatItDidIsNeverOverwritten_data()
    {
        QTest::addColumn<int>("operation");
        QTest::addColumn<int>("deed");
        for (std::size_t o = 0; o < operations.size(); ++o) {
            for (std::size_t d = 0; d < deeds.size(); ++d)
                QTest::addRow("%s: %s", operations[o].name, deeds[d].name)
                    << static_cast<int>(o) << static_cast<int>(d);
        }
    }

    void whatItDidIsNeverOverwritten()
    {
        QFETCH(int, operation);
        QFETCH(int, deed);
        const Operation& first = operations[static_cast<std::size_t>(operation)];
        const Deed& second = deeds[static_cast<std::size_t>(deed)];

        Case whole(first.before);
        const int begin = whole.link.exchanges();
        whole.link.forgetChange();
        VERIFY_RESULT(first.run(whole));
        const int firstChange = whole.link.firstChange() - begin;
        QVERIFY(firstChange > 3);

        Case alone(first.before);
        second.act(alone);
        const Contents others = contentsOf(alone.drive);

        int noticed = 0;
        for (int exchange = 1; exchange < firstChange; ++exchange) {
            Case c(first.before);
            c.link.actBefore(exchange, [&] { second.act(c); });
            const auto outcome = first.run(c);
            const Contents now = contentsOf(c.drive);
            const std::string said = outcome ? "success" : test::describe(outcome.error());
            const QByteArray where = "exchange " + QByteArray::number(exchange) + " of "
                + QByteArray::number(firstChange) + ": " + said.c_str();
            if (!outcome) {
                ++noticed;
                QVERIFY2(isRefusal(outcome.error().code), where);
                QVERIFY2(now == others, where + "; but something was changed");
                if (outcome.error().code == ErrorCode::ChangedMeanwhile) {
                    QVERIFY2(said.find('?') == std::string::npos, where);
                    QVERIFY2(outcome.error().context.english("before")
                            != outcome.error().context.english("now"),
                        where);
                }
                continue;
            }
            // It came in time to be planned for, or concerns nothing that this operation changes.
            QVERIFY2(isKept(first, second, others, now),
                where + "; what the second program did is lost");
        }
        if (mustBeNoticed(first, second))
            QVERIFY2(second.isOfAxis ? noticed == firstChange - 1 : noticed > 0,
                QByteArray::number(noticed) + " times noticed");
    }

    /// A drive was exchanged, or its address given to another one, while the write was planned.
    void anotherDriveThanThePlannedOneIsNotWritten()
    {
        Case c(Persistency::Volatile);
        const auto before = c.state();
        int asked = 0;
        c.link.forgetChange();
        c.link.altersIdentity = [&asked](DriveIdentity& identity) {
            if (++asked > 1)
                identity.serialNumber = 4712;
        };
        const auto refused = c.compensator.write(0, inPlace(Persistency::Volatile));
        VERIFY_ERROR(refused, ErrorCode::OtherDrive);
        QCOMPARE(refused.error().context.english("expected"), std::string("4711"));
        QCOMPARE(refused.error().context.english("found"), std::string("4712"));
        QCOMPARE(c.link.firstChange(), 0);
        QVERIFY(c.state() == before);
    }

    /// The CRC of the table is that of its values alone.
    void anotherGridOfTheSameValuesIsNoticedBeforeTheFirstChange()
    {
        CompensatorFixture whole;
        VERIFY_RESULT(whole.compensator.write(0, exampleRequest(1)));
        const int begin = whole.link.exchanges();
        VERIFY_RESULT(whole.compensator.write(0, exampleRequest(2)));
        const int exchanges = whole.link.exchanges() - begin;
        CompensationTable moved = exampleTable(2, 1);
        moved.grid.axes.front().start += 50.0;
        const auto theirs = encodeTamTable(moved, false, drivecomm::genericProfile().layout);
        VERIFY_RESULT(theirs);
        int noticed = 0;
        for (int exchange = 1; exchange <= exchanges; ++exchange) {
            CompensatorFixture f;
            VERIFY_RESULT(f.compensator.write(0, exampleRequest(1)));
            f.link.forgetChange();
            f.link.actBefore(
                exchange, [&] { VERIFY_RESULT(f.drive.upload("tables/small1.TAMtbl", *theirs)); });
            const auto written = f.compensator.write(0, exampleRequest(2));
            if (written || written.error().context.english("what") != "the table in Small1")
                continue;
            VERIFY_ERROR(written, ErrorCode::ChangedMeanwhile);
            QCOMPARE(f.link.firstChange(), 0);
            QCOMPARE(written.error().context.english("before"),
                std::string("6 x 6 points, dim 1 0 .. 50, dim 2 0 .. 55"));
            QCOMPARE(written.error().context.english("now"),
                std::string("6 x 6 points, dim 1 50 .. 100, dim 2 0 .. 55"));
            ++noticed;
        }
        QVERIFY(noticed > 2);
    }

    /// Whoever confirms a plan has seen where the table lies, in which units, and on which axis.
    void aConfirmedWriteIsRefusedWhereTheNumbersMeanSomethingElse()
    {
        struct Change {
            const char* what;
            const char* before;
            const char* now;
            std::function<void(CompensatorFixture&, WriteRequest&)> act;
        };
        CompensationTable moved = exampleTable(2, 1);
        moved.grid.axes.front().start += 50.0;
        const auto theirs = encodeTamTable(moved, false, drivecomm::genericProfile().layout);
        VERIFY_RESULT(theirs);
        const std::string unit = "]/Parameters/PositionController/PositionUnit";
        const std::vector<Change> changes{
            {"the table in Small1", "6 x 6 points, dim 1 0 .. 50, dim 2 0 .. 55",
                "6 x 6 points, dim 1 50 .. 100, dim 2 0 .. 55",
                [&](CompensatorFixture& f, WriteRequest&) {
                    VERIFY_RESULT(f.drive.upload("tables/small1.TAMtbl", *theirs));
                }},
            {"the units of the table of axis 0 (X)", "mm at mm, mm", "m at m, mm",
                [&](CompensatorFixture& f, WriteRequest&) {
                    f.set("Axes[0" + unit, std::string("Meter"));
                }},
            {"the units of the table of axis 0 (X)", "mm at mm, mm", "mm at mm, deg",
                [&](CompensatorFixture& f, WriteRequest&) {
                    f.set("Axes[1" + unit, std::string("Degree"));
                }},
            {"the name of axis 0", "\"Z\"", "\"X\"",
                [](CompensatorFixture&, WriteRequest& request) {
                    request.expected->axisName = "Z";
                }},
        };
        WriteRequest keeping = keepingTable(Persistency::Persistent);
        keeping.sources.clear();
        for (const WriteRequest& asked : {keeping, exampleRequest(2)})
            for (const Change& change : changes) {
                CompensatorFixture f;
                VERIFY_RESULT(f.compensator.write(0, exampleRequest(1)));
                WriteRequest request = asked;
                const auto plan = f.compensator.plan(0, request);
                VERIFY_RESULT(plan);
                expectAsPlanned(request, *plan);
                VERIFY_RESULT(f.compensator.plan(0, request));
                change.act(f, request);
                f.link.forgetChange();
                const auto refused = f.compensator.write(0, request);
                VERIFY_ERROR(refused, ErrorCode::ChangedMeanwhile);
                const auto& context = refused.error().context;
                QCOMPARE(context.english("what"), std::string(change.what));
                QCOMPARE(context.english("before"), std::string(change.before));
                QCOMPARE(context.english("now"), std::string(change.now));
                QCOMPARE(f.link.firstChange(), 0);
            }
    }

    void aBackupIsOfOneState()
    {
        Case whole(Persistency::Volatile);
        const int begin = whole.link.exchanges();
        const auto old = whole.compensator.backup();
        VERIFY_RESULT(old);
        const int exchanges = whole.link.exchanges() - begin;
        const auto sameAs = [](const AxisBackup& a, const Result<DriveBackup>& b) {
            return a.registers == b->axes.front().registers && a.files == b->axes.front().files;
        };

        int noticed = 0;
        for (int exchange = 1; exchange <= exchanges; ++exchange) {
            Case c(Persistency::Volatile);
            c.link.actBefore(exchange, [&c] { writeOther(c); });
            const auto backup = c.compensator.backup();
            const QByteArray where = "exchange " + QByteArray::number(exchange);
            if (!backup) {
                ++noticed;
                QVERIFY2(backup.error().code == ErrorCode::ChangedMeanwhile, where);
                continue;
            }
            const auto now = c.compensator.backup();
            VERIFY_RESULT(now);
            QVERIFY2(sameAs(backup->axes.front(), old) || sameAs(backup->axes.front(), now), where);
        }
        QVERIFY(noticed > 0);
    }

    /// Whoever has the status says with it at which positions the table is looked up.
    void aTableIsOfTheStateThatItIsReadFor()
    {
        int noticed = 0;
        bool isOver = false;
        for (int exchange = 1; !isOver; ++exchange) {
            Case c(Persistency::Volatile);
            const auto status = c.compensator.status(0);
            VERIFY_RESULT(status);
            c.link.actBefore(exchange, [&c] { writeOther(c); });
            const int begin = c.link.exchanges();
            const auto table = c.compensator.readDescribedTable(*status);
            isOver = c.link.exchanges() - begin < exchange;
            if (table) {
                QVERIFY2(table->values == exampleTable(2, 1).values,
                    "exchange " + QByteArray::number(exchange));
                continue;
            }
            ++noticed;
            VERIFY_ERROR(table, ErrorCode::ChangedMeanwhile);
        }
        QVERIFY(noticed > 1);
    }

    /// The table itself stays as it is.
    void aTableOfOtherSourcesIsNoticed()
    {
        Case c(Persistency::Volatile);
        const auto status = c.compensator.status(0);
        VERIFY_RESULT(status);
        VERIFY_RESULT(c.compensator.checkUnchanged(*status));
        VERIFY_RESULT(c.compensator.write(0, keepingTable(Persistency::Volatile)));
        VERIFY_ERROR(c.compensator.readTable(*status), ErrorCode::ChangedMeanwhile);
        VERIFY_ERROR(c.compensator.readHeldTable(*status), ErrorCode::ChangedMeanwhile);
    }

    void aTableThatHasGoneMeanwhileIsNoticed()
    {
        Case c(Persistency::Volatile);
        const auto status = c.compensator.status(0);
        VERIFY_RESULT(status);
        VERIFY_RESULT(c.compensator.write(0, deletionRequest()));
        VERIFY_ERROR(c.compensator.readTable(*status), ErrorCode::ChangedMeanwhile);
    }

    void aTableThatWasThereForAMomentIsNotTakenForTheOneThatIs()
    {
        Case c(Persistency::Volatile);
        const auto status = c.compensator.status(0);
        VERIFY_RESULT(status);
        const std::string file = drivecomm::genericProfile().slotNamed("Small1")->file;
        const Bytes own = c.drive.download(file).value_or(Bytes{});
        const Bytes other =
            *encodeTamTable(exampleTable(2, 8), false, drivecomm::genericProfile().layout);
        c.link.beginning = [&](std::string_view what) {
            if (what == "download")
                VERIFY_RESULT(c.drive.upload(file, other));
            if (what == "identify")
                VERIFY_RESULT(c.drive.upload(file, own));
        };
        VERIFY_ERROR(c.compensator.readTable(*status), ErrorCode::ChangedMeanwhile);
        c.link.beginning = {};
        VERIFY_RESULT(c.compensator.readTable(*status));
    }

    void aSnapshotIsOfOneState()
    {
        int noticed = 0;
        bool isOver = false;
        for (int exchange = 1; !isOver; ++exchange) {
            Case c(Persistency::Volatile);
            const auto old = snapshotOf(c);
            VERIFY_RESULT(old);
            c.link.actBefore(exchange, [&c] { writeOther(c); });
            const int begin = c.link.exchanges();
            const auto snapshot = snapshotOf(c);
            isOver = c.link.exchanges() - begin < exchange;
            if (!snapshot) {
                ++noticed;
                VERIFY_ERROR(snapshot, ErrorCode::ChangedMeanwhile);
                continue;
            }
            const auto now = snapshotOf(c);
            VERIFY_RESULT(now);
            QVERIFY2(isSame(*snapshot, *old) || isSame(*snapshot, *now),
                "exchange " + QByteArray::number(exchange));
        }
        QVERIFY(noticed > 1);
    }

    /// Half of a write of another computer, which ends before the exchange.
    void whatWasThereForAMomentIsNotKept()
    {
        int noticed = 0;
        bool isOver = false;
        for (int exchange = 1; !isOver; ++exchange) {
            Case c(Persistency::Volatile);
            c.set(axis0 + "Table", std::string("Disabled"));
            c.link.actBefore(exchange, [&c] { c.set(axis0 + "Table", std::string("Small1")); });
            const int begin = c.link.exchanges();
            const auto status = wholeStatus(c.compensator, c.storeRoot(), 0, {});
            isOver = c.link.exchanges() - begin < exchange;
            if (isOver || (status && status->setup.slot == "Small1"))
                continue;
            ++noticed;
            VERIFY_ERROR(status, ErrorCode::ChangedMeanwhile);
        }
        QVERIFY(noticed > 0);
    }

    /// One that begins after the axes were looked at.
    void aBackupOfAMomentIsNotKept()
    {
        Case whole(Persistency::Volatile);
        const auto kept = backUpDrive(whole.compensator, whole.storeRoot(), {});
        VERIFY_RESULT(kept);
        QVERIFY(kept->doubts.empty());
        const int start = whole.link.exchanges();
        VERIFY_RESULT(whole.compensator.axes());
        VERIFY_RESULT(whole.compensator.status(0));
        const int looked = whole.link.exchanges() - start; // exchanges until the axis is known
        int noticed = 0;
        bool isOver = false;
        for (int exchange = 1; !isOver; ++exchange) {
            Case c(Persistency::Volatile);
            c.link.actBefore(exchange, [&c] { c.set(axis0 + "Table", std::string("Disabled")); });
            const int begin = c.link.exchanges();
            const auto rescue = backUpDrive(c.compensator, c.storeRoot(), {});
            isOver = c.link.exchanges() - begin < exchange;
            if (!rescue) {
                ++noticed;
                VERIFY_ERROR(rescue, ErrorCode::ChangedMeanwhile);
                continue;
            }
            QVERIFY2(!rescue->backup.axes.front().files.empty() || exchange <= looked,
                "exchange " + QByteArray::number(exchange));
        }
        QVERIFY(noticed > 3);
    }

private:
    /// Another table, in the slot of the old one, and the sources in another order.
    static void writeOther(Case& c)
    {
        WriteRequest request = inPlace(Persistency::Volatile);
        std::swap(request.sources[0], request.sources[1]);
        const auto link = drivecomm::makeDirectLink(c.drive);
        AxisCompensator second(*link, drivecomm::genericProfile(), c.store);
        VERIFY_RESULT(second.write(0, request));
    }
    static Result<DriveSnapshot> snapshotOf(Case& c)
    {
        return snapshotDrive(
            c.compensator, drivecomm::genericProfile(), c.storeRoot(), "demo:", {});
    }
    static bool isSame(const DriveSnapshot& a, const DriveSnapshot& b)
    {
        return a.files == b.files && a.drive.axes.front().sources == b.drive.axes.front().sources;
    }
    static bool changesTheAxis(const Operation& operation)
    {
        return std::string_view(operation.name) != "plain upload"
            && std::string_view(operation.name) != "restore of a file";
    }
    static bool usesTheOtherSlot(const Operation& operation)
    {
        const std::string_view name = operation.name;
        return name.starts_with("replace") || !changesTheAxis(operation);
    }
    static bool mustBeNoticed(const Operation& operation, const Deed& deed)
    {
        return deed.isOfAxis ? changesTheAxis(operation) : usesTheOtherSlot(operation);
    }
    /// The slot that the second program uses is still its own. Who names a slot may overwrite a
    /// table there that was seen in time, as a copy of it is kept.
    static bool isKept(
        const Operation& operation, const Deed& deed, const Contents& others, const Contents& now)
    {
        const std::string_view name = operation.name;
        const bool isNamed = name == "plain upload"
            || (name == "restore of a file" && std::string_view(deed.name).starts_with("a table"));
        if (deed.isOfAxis || isNamed)
            return true;
        const bool hasRegisters =
            std::ranges::all_of(others.parameters, [&](const auto& parameter) {
                const bool isTheirs = parameter.starts_with("Axes[1]/");
                return !isTheirs
                    || std::ranges::find(now.parameters, parameter) != now.parameters.end();
            });
        return hasRegisters && now.files.at(1) == others.files.at(1);
    }
};

AXISCOMP_TEST(TestSecondProgram)

} // namespace tst_secondprogram

#include "tst_secondprogram.moc"
