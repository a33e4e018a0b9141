// SPDX-License-Identifier: GPL-3.0-or-later
//
// Drives that say yes and do something else, or lack what others have.
#include "core/write/previous_state.h"
#include "tests/support/compensator_fixture.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

namespace tst_stubborndrive {

using namespace axiscomp;
using namespace axiscomp::test;

namespace {

const std::string axisFolder = "Axes[0]/Parameters/Compensations/Axis/";

const DriveProfile& profileOf(bool isOneByOne)
{
    static const DriveProfile oneByOne = [] {
        DriveProfile changed = drivecomm::genericProfile();
        changed.writesAtOneInstant = false;
        return changed;
    }();
    return isOneByOne ? oneByOne : drivecomm::genericProfile();
}

const DriveProfile& profileWithoutCounters()
{
    static const DriveProfile profile = [] {
        DriveProfile changed = drivecomm::genericProfile();
        changed.registers.tableEraseCount = "Application/Tables/{slot}/NoSuchCount";
        return changed;
    }();
    return profile;
}

/// A slip of whoever wrote the profile: all CRCs fit all the same.
const DriveProfile& profileWithExchangedFields()
{
    static const DriveProfile profile = [] {
        DriveProfile changed = drivecomm::genericProfile();
        std::swap(
            changed.layout.place(TableField::Start), changed.layout.place(TableField::Distance));
        return changed;
    }();
    return profile;
}

/// As of a drive whose table files have positions of single precision.
const DriveProfile& profileWithRoundedPositions()
{
    static const DriveProfile profile = [] {
        DriveProfile changed = drivecomm::genericProfile();
        for (const TableField field : {TableField::Start, TableField::Distance})
            changed.layout.place(field)->type = FieldType::F32;
        return changed;
    }();
    return profile;
}

/// A table from 30 on, at 30, 40 ... 80; the other way round at 10, 40 ... 160.
WriteRequest requestFrom30()
{
    WriteRequest request = exampleRequest();
    for (GridAxis& axis : request.table->grid.axes) {
        axis.start = 30.0;
        axis.distance = 10.0;
    }
    return request;
}

/// Whose start and distance are no numbers of single precision.
WriteRequest requestOfFinePositions()
{
    WriteRequest request = exampleRequest();
    request.table->grid.axes[0].start = 12345.6789;
    request.table->grid.axes[0].distance = 0.01;
    request.acceptsLarge = true;
    return request;
}

/// A drive that shows the positions of its tables in single precision, or not at all.
std::function<void(RegisterReading&)> positionsShown(bool isShown)
{
    return [isShown](RegisterReading& reading) {
        const bool isPosition = reading.path.find("/Header/") != std::string::npos
            && std::holds_alternative<double>(reading.value);
        if (isPosition)
            reading.value = isShown
                ? static_cast<double>(static_cast<float>(toDouble(reading.value)))
                : std::numeric_limits<double>::quiet_NaN();
    };
}

bool isCommit(const RegisterWrite& write)
{
    return write.path.ends_with("/Command") && toText(write.value) == "Commit";
}

bool switchesOff(const RegisterWrite& write)
{
    return write.path == axisFolder + "Table" && toText(write.value) == "Disabled";
}

/// Other sources than exampleRequest's, in a slot of its own.
WriteRequest swapped(int seed, Persistency persistency, const char* slot)
{
    WriteRequest request = exampleRequest(seed, persistency);
    std::swap(request.sources[0], request.sources[1]);
    request.slot = slot;
    return request;
}

WriteRequest into(WriteRequest request, const char* slot)
{
    request.slot = slot;
    return request;
}

struct Written : CompensatorFixture {
    explicit Written(const DriveProfile& profile, Persistency persistency = Persistency::Volatile)
        : CompensatorFixture(inProcess(), profile)
    {
        VERIFY_RESULT(compensator.write(0, into(exampleRequest(1, persistency), "Small1")));
        old = state();
        link.beginning = [this](std::string_view what) { uploads += what == "upload" ? 1 : 0; };
    }
    [[nodiscard]] bool isUnfinished() { return store.journal(4711, 0).value().has_value(); }
    [[nodiscard]] std::uint64_t operations() { return store.flashHistory(4711)->total; }

    State old;
    int uploads = 0;
};

/// The file of a table on the drive.
Bytes fileIn(CompensatorFixture& f, const char* slot)
{
    return f.drive.download(drivecomm::genericProfile().slotNamed(slot)->file).value_or(Bytes{});
}

/// What arrives in place of the table in Small1; the other slots are empty.
Bytes inPlaceOf(const Bytes& table, const std::string& what)
{
    const TableLayout& layout = drivecomm::genericProfile().layout;
    if (what == "nothing")
        return {};
    if (what == "no table")
        return Bytes(table.size() / 2, std::byte{0x8b});
    if (what == "an earlier table")
        return *encodeTamTable(exampleTable(2, 9), false, layout);
    CompensationTable moved = exampleTable(2, 1);
    moved.grid.axes.front().start += 5.0;
    return *encodeTamTable(moved, false, layout);
}

/// How many exchanges a write takes.
int exchangesOf(const WriteRequest& request)
{
    Written whole(drivecomm::genericProfile());
    const int begin = whole.link.exchanges();
    const auto written = whole.compensator.write(0, request);
    return written ? whole.link.exchanges() - begin : 0;
}

/// Uses up flash operations, by the drive's count and by the store's, until this many are left.
void leave(CompensatorFixture& f, int left)
{
    const auto& layout = drivecomm::genericProfile().layout;
    for (int seed = 100; f.compensator.flashUse()->budget.left > left; ++seed) {
        VERIFY_RESULT(f.drive.upload(
            "tables/large2.TAMtbl", *encodeTamTable(exampleTable(1, seed), true, layout)));
        VERIFY_RESULT(f.store.recordFlash(4711, f.wallTime(), 1));
    }
}

} // namespace

class TestStubbornDrive : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void anAxisThatStaysOnIsNotOverwritten_data()
    {
        QTest::addColumn<bool>("isOneByOne");
        QTest::addColumn<Persistency>("persistency");
        QTest::newRow("volatile") << false << Persistency::Volatile;
        QTest::newRow("persistent") << false << Persistency::Persistent;
        QTest::newRow("one by one, volatile") << true << Persistency::Volatile;
        QTest::newRow("one by one, persistent") << true << Persistency::Persistent;
    }
    void anAxisThatStaysOnIsNotOverwritten()
    {
        QFETCH(bool, isOneByOne);
        QFETCH(Persistency, persistency);
        Written f(profileOf(isOneByOne), persistency);
        f.link.ignoresWrite = switchesOff;
        VERIFY_ERROR(f.compensator.write(0, into(exampleRequest(2, persistency), "Small1")),
            ErrorCode::VerifyMismatch);
        QCOMPARE(f.uploads, 0);
        QVERIFY(f.state() == f.old);
        QVERIFY(!f.isUnfinished());
    }

    void whereRegistersAreTakenOneByOneAnAxisThatStaysOnKeepsItsSources()
    {
        Written f(profileOf(true));
        std::vector<std::string> written;
        f.link.ignoresWrite = [&](const RegisterWrite& write) {
            written.push_back(write.path);
            return switchesOff(write);
        };
        VERIFY_ERROR(f.compensator.write(0, swapped(2, Persistency::Volatile, "Small2")),
            ErrorCode::VerifyMismatch);
        QVERIFY(std::ranges::find(written, axisFolder + "Dim1Source") == written.end());
        QVERIFY(f.state() == f.old);
    }

    /// The drive's own header says which positions it reads.
    void aTableThatTheDriveReadsAtOtherPositionsIsPutBack()
    {
        CompensatorFixture f(inProcess(), profileWithExchangedFields());
        const auto before = f.state();
        const auto written = f.compensator.write(0, requestFrom30());
        VERIFY_ERROR(written, ErrorCode::VerifyMismatch);
        QCOMPARE(sentence(written.error()),
            "the drive does not read the table in Small1 as the layout of the profile has it: of "
            "dimension 1 the drive shows 10 where the layout has 30. Compare layout.fields.start "
            "in the profile with the drive's table file");
        QVERIFY(f.state() == before);
    }

    void aTableOfTheDriveIsNotReadAtOtherPositions()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, requestFrom30()));
        AxisCompensator other(f.link, profileWithExchangedFields(), f.store);
        const auto read = other.readTable(0);
        VERIFY_ERROR(read, ErrorCode::InvalidTable);
        QCOMPARE(sentence(read.error()),
            "the drive does not read the table in Small1 as the layout of the profile has it: of "
            "dimension 1 the drive shows 30 where the layout has 10. Compare layout.fields.start "
            "in the profile with the drive's table file");
    }

    void positionsThatTheDriveShowsRoundedOrNotAtAllAreNoOthers_data()
    {
        QTest::addColumn<bool>("isShown");
        QTest::newRow("in single precision") << true;
        QTest::newRow("not shown") << false;
    }
    void positionsThatTheDriveShowsRoundedOrNotAtAllAreNoOthers()
    {
        QFETCH(bool, isShown);
        CompensatorFixture f;
        f.link.altersReading = positionsShown(isShown);
        WriteRequest request = requestOfFinePositions();
        VERIFY_RESULT(f.compensator.write(0, request));
        const auto read = f.compensator.readTable(0);
        VERIFY_RESULT(read);
        QCOMPARE(read->grid.axes[0].start, 12345.6789);
        VERIFY_ERROR(f.compensator.write(0, request), ErrorCode::NothingToWrite);
        request.table->grid.axes[0].start += 1e-6;
        VERIFY_RESULT(f.compensator.write(0, request)); // the file says more than the registers
    }

    void aBackupOfWhatTheAxisHasIsNotItsPreviousState_data()
    {
        positionsThatTheDriveShowsRoundedOrNotAtAllAreNoOthers_data();
    }
    void aBackupOfWhatTheAxisHasIsNotItsPreviousState()
    {
        QFETCH(bool, isShown);
        CompensatorFixture f;
        f.link.altersReading = positionsShown(isShown);
        VERIFY_RESULT(f.compensator.write(0, requestOfFinePositions()));
        const auto now = f.compensator.backup();
        VERIFY_RESULT(now);
        VERIFY_RESULT(f.store.saveBackup(now->axes.at(0)));
        const auto status = f.compensator.status(0);
        VERIFY_RESULT(status);
        const auto previous = previousState(f.store, drivecomm::genericProfile(), *status);
        VERIFY_RESULT(previous);
        QVERIFY(previous->backup.files.empty()); // of before the write
    }

    void aTableWhosePositionsTheFileRoundsIsThereTheNextTime()
    {
        const DriveProfile& profile = profileWithRoundedPositions();
        CompensatorFixture f;
        drivecomm::VirtualDrive drive(profile, CompensatorFixture::options(f.time));
        const auto link = drivecomm::makeDirectLink(drive);
        AxisCompensator compensator(*link, profile, f.store, [&] { return f.wallTime(); });
        WriteRequest request = exampleRequest();
        request.table->grid.axes[0].start = 0.1;
        request.table->grid.axes[0].distance = 0.7;
        request.acceptsLarge = true;
        const auto encoded = encodeTamTable(*request.table, false, profile.layout);
        VERIFY_RESULT(encoded);
        const auto written = compensator.write(0, request);
        VERIFY_RESULT(written);
        QCOMPARE(written->plan.table->grid.axes[0].start, double(0.1F));
        QCOMPARE(written->plan.table->grid.axes[1], request.table->grid.axes[1]);
        const TableSlot* slot = profile.slotNamed(written->now.setup.slot);
        QVERIFY(drive.download(slot->file).value_or(Bytes{}) == *encoded);
        VERIFY_ERROR(compensator.write(0, request), ErrorCode::NothingToWrite);

        request.table->grid.axes[0].start = 1e7 + 0.3; // single precision has steps of 1 there
        VERIFY_ERROR(compensator.plan(0, request), ErrorCode::InvalidArgument);
    }

    void registersThatDoNotGoBackAreSaid()
    {
        const WriteRequest request = swapped(2, Persistency::Persistent, "Small2");
        const int exchanges = exchangesOf(request);
        QVERIFY(exchanges > 10);
        Written f(drivecomm::genericProfile());
        const std::string before = f.old.registers[1];
        f.link.failAt(exchanges, LinkFault::Refused);
        f.link.ignoresWrite = [&](const RegisterWrite& write) {
            return write.path == axisFolder + "Dim1Source" && toText(write.value) == before;
        };
        const auto report = f.compensator.write(0, request);
        VERIFY_ERROR(report, ErrorCode::RollbackFailed);
        QVERIFY(f.state() != f.old);
        QVERIFY(f.isUnfinished());
        QVERIFY(sentence(report.error()).find("'axiscomp recover' says how") != std::string::npos);
        // Once the drive does what it is told, the way back is still there.
        f.link.ignoresWrite = {};
        VERIFY_RESULT(f.compensator.undoUnfinished(*f.store.journal(4711, 0).value()));
        QVERIFY(f.state() == f.old);
    }

    /// A reboot would bring the mixture back, and it would have cost a flash operation.
    void registersThatDoNotGoBackAreNotSaved()
    {
        const WriteRequest request = swapped(2, Persistency::Persistent, "Small2");
        const auto countSaves = [](Written& f, int& saves, const std::string& ignored) {
            f.link.ignoresWrite = [&saves, ignored](const RegisterWrite& write) {
                saves += write.path == drivecomm::genericProfile().registers.saveParameters ? 1 : 0;
                return write.path == axisFolder + "Dim1Source" && toText(write.value) == ignored;
            };
        };
        int wanted = 0;
        Written whole(drivecomm::genericProfile());
        countSaves(whole, wanted, {});
        VERIFY_RESULT(whole.compensator.write(0, request));
        QVERIFY(wanted > 0);
        int saves = 0;
        Written f(drivecomm::genericProfile());
        countSaves(f, saves, f.old.registers[1]);
        f.link.failAt(exchangesOf(request), LinkFault::Refused);
        VERIFY_ERROR(f.compensator.write(0, request), ErrorCode::RollbackFailed);
        QCOMPARE(saves, wanted);
    }

    void anUndoWhoseRegistersDoNotGoBackStaysUnfinished()
    {
        const WriteRequest request = swapped(2, Persistency::Volatile, "Small2");
        Written f(drivecomm::genericProfile());
        const std::string before = f.old.registers[1];
        f.link.failAt(exchangesOf(request), LinkFault::DriveGone);
        QVERIFY(!f.compensator.write(0, request));
        f.link.heal();
        f.link.ignoresWrite = [&](const RegisterWrite& write) {
            return write.path == axisFolder + "Dim1Source" && toText(write.value) == before;
        };
        VERIFY_ERROR(f.compensator.undoUnfinished(*f.store.journal(4711, 0).value()),
            ErrorCode::VerifyMismatch);
        QVERIFY(f.isUnfinished());
        f.link.ignoresWrite = {};
        VERIFY_RESULT(f.compensator.undoUnfinished(*f.store.journal(4711, 0).value()));
        QVERIFY(f.state() == f.old);
    }

    void whatIsSaidOfADriveThatRefusesIsWhatStatusSays_data()
    {
        QTest::addColumn<std::string>("slot");
        QTest::addColumn<bool>("isAllRefused");
        QTest::newRow("everything, in turn") << std::string("Small2") << true;
        QTest::newRow("everything, in place") << std::string("Small1") << true;
        QTest::newRow("every change, in turn") << std::string("Small2") << false;
        QTest::newRow("every change, in place") << std::string("Small1") << false;
    }
    /// From each exchange on, as a drive does whose password or whose rights were changed.
    void whatIsSaidOfADriveThatRefusesIsWhatStatusSays()
    {
        using Outcome = AxisCompensator::UnfinishedOutcome;
        QFETCH(std::string, slot);
        QFETCH(bool, isAllRefused);
        const bool isInPlace = slot == "Small1";
        int untouched = 0;
        int complete = 0;
        bool isReached = true;
        for (int at = 1; isReached; ++at) {
            Written f(drivecomm::genericProfile());
            const int from = f.link.exchanges() + at;
            isReached = false;
            f.link.beginning = [&](std::string_view what) {
                const bool isRefused = isAllRefused || what == "write" || what == "upload";
                if (f.link.exchanges() < from || !isRefused)
                    return;
                isReached = true;
                f.link.failAt(0, LinkFault::Refused);
            };
            const auto report =
                f.compensator.write(0, swapped(2, Persistency::Persistent, slot.c_str()));
            f.link.beginning = {};
            f.link.heal();
            if (report)
                continue;
            const std::string place = std::to_string(at) + ": " + describe(report.error());
            const ErrorCode code = report.error().code;
            const auto entry = f.store.journal(4711, 0).value();
            if (!entry) {
                QVERIFY2(f.state() == f.old, place.c_str());
                continue;
            }
            const auto held = f.compensator.settleUnfinished(*entry);
            VERIFY_RESULT(held);
            const bool isNew = *held == Outcome::New || *held == Outcome::NewUnsaved;
            if (code == ErrorCode::OutcomeUnknown)
                QVERIFY2(isNew || *held == Outcome::Old, place.c_str());
            else if (code == ErrorCode::RollbackFailed)
                QVERIFY2(isInPlace && (isAllRefused || !isNew), place.c_str());
            else
                QVERIFY2(*held == Outcome::Old && f.state() == f.old, place.c_str());
            untouched += code == ErrorCode::DriveRejected ? 1 : 0;
            complete += code == ErrorCode::OutcomeUnknown && isNew ? 1 : 0;
        }
        QCOMPARE(untouched > 0, isAllRefused && !isInPlace);
        QVERIFY(complete > 0);
    }

    /// From each exchange of the way back on, after the last step of the write was refused: what is
    /// stored wrong once is put back at the second try.
    void whatIsStoredWrongWhilePuttingBackIsSaid_data()
    {
        QTest::addColumn<bool>("isInPlace");
        QTest::newRow("in turn") << false;
        QTest::newRow("in place") << true;
    }
    void whatIsStoredWrongWhilePuttingBackIsSaid()
    {
        QFETCH(bool, isInPlace);
        const WriteRequest request =
            swapped(2, Persistency::Volatile, isInPlace ? "Small1" : "Small2");
        const int exchanges = exchangesOf(request);
        QVERIFY(exchanges > 10);
        int failed = 0;
        bool isReached = true;
        for (int at = 1; isReached; ++at) {
            Written f(drivecomm::genericProfile());
            const int wrong = f.link.exchanges() + exchanges + at;
            f.link.failAt(exchanges, LinkFault::Refused);
            f.link.beginning = [&](std::string_view) {
                if (f.link.exchanges() >= wrong)
                    f.link.failAt(0, LinkFault::StoresWrong);
            };
            const auto report = f.compensator.write(0, request);
            QVERIFY(!report);
            isReached = f.link.exchanges() >= wrong;
            const std::string place = std::to_string(at) + ": " + describe(report.error());
            const bool isOld = f.state() == f.old;
            const bool isSaid = report.error().code == ErrorCode::RollbackFailed;
            QVERIFY2(isOld || isSaid, place.c_str());
            QVERIFY2(f.isUnfinished() == isSaid, place.c_str());
            if (isOld)
                continue;
            ++failed;
            f.link.beginning = {};
            f.link.heal();
            VERIFY_RESULT(f.compensator.undoUnfinished(*f.store.journal(4711, 0).value()));
            QVERIFY2(f.state() == f.old, place.c_str());
        }
        QVERIFY(failed > 0);
    }

    void aDriveWithoutEraseCountersIsWrittenAndAccountedFor()
    {
        CompensatorFixture f(inProcess(), profileWithoutCounters());
        const auto cycles = [&f](const char* slot) {
            return std::stoi(f.text("Application/Tables/" + std::string(slot) + "/EraseCount"));
        };
        VERIFY_RESULT(
            f.compensator.write(0, into(exampleRequest(1, Persistency::Persistent), "Small1")));
        QCOMPARE(cycles("Small1"), 1);
        QCOMPARE(f.store.flashHistory(4711)->total, std::uint64_t{1});
        VERIFY_RESULT(f.compensator.write(0, swapped(2, Persistency::Persistent, "Small2")));
        QCOMPARE(cycles("Small2"), 1);
        QCOMPARE(f.store.flashHistory(4711)->total, std::uint64_t{2});
        QCOMPARE(f.compensator.flashUse()->budget.left, 6);
        QVERIFY(f.compensator.flashUse()->mostUsedSlot.empty());
        VERIFY_RESULT(f.compensator.setPersistency(0, Persistency::Volatile));
        QCOMPARE(cycles("Small2"), 2);
        QCOMPARE(f.store.flashHistory(4711)->total, std::uint64_t{3});
        const Bytes file =
            *encodeTamTable(exampleTable(1, 1), true, drivecomm::genericProfile().layout);
        VERIFY_RESULT(f.compensator.upload("tables/small5.TAMtbl", file));
        QCOMPARE(f.store.flashHistory(4711)->total, std::uint64_t{4});
    }

    void aWriteThatFailsOnADriveWithoutEraseCountersIsPutBack()
    {
        const WriteRequest request = swapped(2, Persistency::Persistent, "Small2");
        Written whole(profileWithoutCounters(), Persistency::Persistent);
        const int begin = whole.link.exchanges();
        VERIFY_RESULT(whole.compensator.write(0, request));
        const int exchanges = whole.link.exchanges() - begin;
        for (int at = 1; at <= exchanges; ++at) {
            Written f(profileWithoutCounters(), Persistency::Persistent);
            f.link.failAt(at, LinkFault::Refused);
            const auto report = f.compensator.write(0, request);
            const std::string place = std::to_string(at);
            QVERIFY2(f.state() == (report ? whole.state() : f.old), place.c_str());
            QVERIFY2(!f.isUnfinished(), place.c_str());
        }
    }

    /// The new table is taken out of the flash of its slot with the very last operation.
    void puttingBackMayUseTheLastFlashOperation()
    {
        const WriteRequest request = swapped(2, Persistency::Persistent, "Small2");
        const int exchanges = exchangesOf(request);
        for (const int left : {2, 1}) {
            Written f(drivecomm::genericProfile());
            leave(f, left);
            const std::uint64_t before = f.operations();
            f.link.failAt(exchanges, LinkFault::Refused);
            VERIFY_ERROR(f.compensator.write(0, request), ErrorCode::DriveRejected);
            QVERIFY(f.state() == f.old);
            QCOMPARE(f.operations(), before + static_cast<std::uint64_t>(left));
            QCOMPARE(f.compensator.flashUse()->budget.left, 0);
            // With none left the table stays, and nothing is asked that the drive must refuse.
            f.drive.reboot();
            const Bytes stored = f.drive.download("tables/small2.TAMtbl").value_or(Bytes{});
            QCOMPARE(stored.empty(), left == 2);
            QVERIFY(!f.store.flashHistory(4711)->refusal);
        }
    }

    void undoingMayUseTheLastFlashOperationAndDoesNotBeginWithoutOne()
    {
        const WriteRequest request = swapped(2, Persistency::Persistent, "Small2");
        const int exchanges = exchangesOf(request);
        for (const int left : {1, 0}) {
            Written f(drivecomm::genericProfile());
            f.link.failAt(exchanges, LinkFault::DriveGone);
            QVERIFY(!f.compensator.write(0, request));
            f.link.heal();
            leave(f, left);
            f.link.forgetChange();
            const auto undone = f.compensator.undoUnfinished(*f.store.journal(4711, 0).value());
            if (left == 0) {
                VERIFY_ERROR(undone, ErrorCode::FlashWear);
                QCOMPARE(f.link.firstChange(), 0);
                QVERIFY(f.isUnfinished());
                continue;
            }
            VERIFY_RESULT(undone);
            QVERIFY(f.state() == f.old);
            QCOMPARE(f.compensator.flashUse()->budget.left, 0);
        }
    }

    /// By a web server's page, by somebody on the way who has kept what was there before.
    void aFileThatTheDriveDoesNotShowIsNotKept_data()
    {
        QTest::addColumn<std::string>("what");
        QTest::addColumn<ErrorCode>("code");
        QTest::newRow("empty") << std::string("nothing") << ErrorCode::ChangedMeanwhile;
        QTest::newRow("no table") << std::string("no table") << ErrorCode::ChangedMeanwhile;
        QTest::newRow("other values")
            << std::string("an earlier table") << ErrorCode::ChangedMeanwhile;
        QTest::newRow("other positions") << std::string("moved") << ErrorCode::InvalidTable;
    }
    void aFileThatTheDriveDoesNotShowIsNotKept()
    {
        QFETCH(std::string, what);
        QFETCH(ErrorCode, code);
        Written f(drivecomm::genericProfile());
        const Bytes other = inPlaceOf(f.old.table, what);
        f.link.altersDownload = [&](Bytes& bytes) {
            if (!bytes.empty())
                bytes = other;
        };
        f.link.forgetChange();
        const auto backup = f.compensator.backup();
        VERIFY_ERROR(backup, code);
        QVERIFY(sentence(backup.error()).find("Small1") != std::string::npos);
        QVERIFY(!f.compensator.write(0, swapped(2, Persistency::Volatile, "Small1")));
        VERIFY_ERROR(f.compensator.deleteSlot("Small1"), code);
        QCOMPARE(f.link.firstChange(), 0);
        // A plain download is what came, to be looked at.
        const auto file = f.compensator.download("tables/small1.TAMtbl");
        QVERIFY(file.value_or(Bytes{}) == other);
    }

    void aTableThatIsGoneIsNotKeptFromAnEarlierAnswer()
    {
        Written f(drivecomm::genericProfile());
        f.link.altersReading = [](RegisterReading& reading) {
            const bool isCount = reading.path.ends_with("Small1/Header/Elements")
                || reading.path.ends_with("Small1/Header/Crc");
            if (isCount)
                reading.value = std::uint32_t{0};
        };
        const auto backup = f.compensator.backup();
        VERIFY_ERROR(backup, ErrorCode::ChangedMeanwhile);
        QVERIFY(sentence(backup.error()).find("from empty to 36 values") != std::string::npos);
    }

    /// The drive itself shows no table then, and has no other file.
    void aDamagedTableIsKeptAndSaid()
    {
        Written f(drivecomm::genericProfile());
        Bytes damaged = f.old.table;
        damaged.back() ^= std::byte{0x40};
        f.link.altersDownload = [&](Bytes& bytes) {
            if (!bytes.empty())
                bytes = damaged;
        };
        f.link.altersReading = [](RegisterReading& reading) {
            if (reading.path.ends_with("Small1/Header/Elements"))
                reading.value = std::uint32_t{0};
        };
        const auto backup = f.compensator.backup();
        VERIFY_RESULT(backup);
        QVERIFY(backup->axes.at(0).files.at(0).bytes == damaged);
        const auto unreadable = f.compensator.unreadableTables(*backup);
        QCOMPARE(unreadable.size(), std::size_t{1});
        QCOMPARE(sentence(unreadable.front()),
            "the file in Small1 is no table that the profile can read: it is in the backup as it "
            "is, but cannot be restored as the table of an axis");
    }

    /// Somebody on the way has kept the old file, and answers with it from now on.
    void anOldFileThatTheDriveDoesNotShowIsPutBack()
    {
        const WriteRequest request = swapped(2, Persistency::Volatile, "Small1");
        const int exchanges = exchangesOf(request);
        Written f(drivecomm::genericProfile());
        int readBack = 0;
        f.link.altersDownload = [&](Bytes& bytes) {
            if (f.uploads > 0 && ++readBack > 1)
                bytes = f.old.table;
        };
        f.link.failAt(exchanges, LinkFault::Refused);
        VERIFY_ERROR(f.compensator.write(0, request), ErrorCode::DriveRejected);
        QVERIFY(readBack > 1);
        QVERIFY(f.state() == f.old);
        QVERIFY(!f.isUnfinished());
    }

    void anOldFileWhoseCrcTheDriveDoesNotShowIsNotTheOldState()
    {
        Written f(drivecomm::genericProfile());
        f.link.altersReading = [&](RegisterReading& reading) {
            if (f.uploads > 0 && reading.path.ends_with("Small1/Header/Crc"))
                reading.value = std::uint32_t{0x12345678};
        };
        VERIFY_ERROR(f.compensator.write(0, swapped(2, Persistency::Volatile, "Small1")),
            ErrorCode::RollbackFailed);
        QVERIFY(f.isUnfinished());
        f.link.altersReading = {};
        VERIFY_RESULT(f.compensator.undoUnfinished(*f.store.journal(4711, 0).value()));
        QVERIFY(f.state() == f.old);
    }

    void aCommitThatDoesNothingIsNoSuccess_data()
    {
        QTest::addColumn<Persistency>("before");
        QTest::addColumn<std::string>("slot");
        QTest::newRow("to an empty slot") << Persistency::Volatile << std::string("Small2");
        QTest::newRow("the same table") << Persistency::Volatile << std::string();
        QTest::newRow("in place") << Persistency::Persistent << std::string("Small1");
    }
    void aCommitThatDoesNothingIsNoSuccess()
    {
        QFETCH(Persistency, before);
        QFETCH(std::string, slot);
        Written f(drivecomm::genericProfile(), before);
        const std::uint64_t operations = f.operations();
        f.link.ignoresWrite = isCommit;
        const auto written = slot.empty()
            ? f.compensator.setPersistency(0, Persistency::Persistent)
            : f.compensator.write(0, swapped(2, Persistency::Persistent, slot.c_str()));
        VERIFY_ERROR(written, ErrorCode::VerifyMismatch);
        const std::string said = sentence(written.error());
        QVERIFY2(
            said.starts_with("the drive has taken the command that stores the table in "
                + (slot.empty() ? "Small1" : slot) + ", but has counted no flash cycle for it ("
                + std::to_string(operations) + " before and after)"),
            said.c_str());
        QVERIFY(f.state() == f.old);
        QVERIFY(!f.isUnfinished());
        QCOMPARE(f.operations(), operations);
        f.drive.reboot();
        QCOMPARE(f.state().table.empty(), before == Persistency::Volatile);
    }

    /// Under the volatile table, so that nothing has to be stored.
    void aTableThatFlashHoldsAlreadyNeedsNoCycle()
    {
        Written f(drivecomm::genericProfile(), Persistency::Persistent);
        VERIFY_RESULT(f.compensator.write(0, into(exampleRequest(2), "Small1")));
        VERIFY_RESULT(
            f.compensator.write(0, into(exampleRequest(1, Persistency::Persistent), "Small1")));
        QVERIFY(f.state() == f.old);
        QVERIFY(fileIn(f, "Small1") == f.old.table);
        QCOMPARE(f.text("Application/Tables/Small1/EraseCount"), "1");
        f.drive.reboot();
        QVERIFY(f.state() == f.old);
    }
};

AXISCOMP_TEST(TestStubbornDrive)

} // namespace tst_stubborndrive

#include "tst_stubborndrive.moc"
