// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/axis_operations.h"
#include "core/io/local_file.h"
#include "tests/support/compensator_fixture.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <map>
#include <string>

namespace tst_axiscompensator {

using namespace axiscomp;
using axiscomp::test::CompensatorFixture;
using axiscomp::test::exampleRequest;
using axiscomp::test::exampleTable;
using axiscomp::test::masterX;
using axiscomp::test::masterY;

namespace {

const std::string activation = "Axes[0]/Commands/Compensations/Axis/Activation";
const std::string tableRegister = "Axes[0]/Parameters/Compensations/Axis/Table";

} // namespace

class TestAxisCompensator : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void axesAreListedWithNameUnitAndHoming()
    {
        CompensatorFixture f;
        const auto axes = f.compensator.axes();
        VERIFY_RESULT(axes);
        QCOMPARE(axes->size(), std::size_t{2});
        QCOMPARE(axes->at(1).name, "Y");
        QCOMPARE(axes->at(1).unit, "Millimeter");
        QCOMPARE(axes->at(1).homingWord, "HomingDone");
        QVERIFY(axes->at(1).isHomed);
        QCOMPARE(axes->at(1).stateWord, "Disabled");
        QCOMPARE(axes->at(1).state, CompensationState::Disabled);
    }

    void anAxisIsFoundByIndexOrName()
    {
        CompensatorFixture f;
        QCOMPARE(f.compensator.findAxis("1").value_or(-1), 1);
        QCOMPARE(f.compensator.findAxis("Y").value_or(-1), 1);
        VERIFY_ERROR(f.compensator.findAxis("2"), ErrorCode::AxisNotFound);
        const auto missing = f.compensator.findAxis("Z");
        VERIFY_ERROR(missing, ErrorCode::AxisNotFound);
        QCOMPARE(
            sentence(missing.error()), "the drive has no axis Z; it has: axis 0 (X), axis 1 (Y)");
    }

    /// Index 1 is axis "2".
    void aNumberThatIsAnotherAxissNameIsAmbiguous()
    {
        CompensatorFixture f({"1", "2"});
        const auto refused = f.compensator.findAxis("1");
        VERIFY_ERROR(refused, ErrorCode::AxisAmbiguous);
        QCOMPARE(sentence(refused.error()),
            "1 is the name of axis 0 and the index of axis 1; say name:1 or index:1");
        QCOMPARE(f.compensator.findAxis("name:1").value_or(-1), 0);
        QCOMPARE(f.compensator.findAxis("index:1").value_or(-1), 1);
        QCOMPARE(f.compensator.findAxis("0").value_or(-1), 0);
        QCOMPARE(f.compensator.findAxis("2").value_or(-1), 1);
        VERIFY_ERROR(f.compensator.findAxis("name:0"), ErrorCode::AxisNotFound);
        VERIFY_ERROR(f.compensator.findAxis("#2"), ErrorCode::AxisNotFound);
    }

    void aNumberThatIsNameAndIndexOfOneAxisIsNoQuestion()
    {
        CompensatorFixture f({"0", "1"});
        for (const std::string asked : {"1", "index:1", "name:1"})
            QCOMPARE(f.compensator.findAxis(asked).value_or(-1), 1);
    }

    void ofAxesWithOneNameTheIndexIsTold()
    {
        CompensatorFixture same({"X", "X"});
        QCOMPARE(sentence(same.compensator.findAxis("X").error()),
            "several axes are named X: give the index, one of 0, 1");
        CompensatorFixture one({"1", "1"});
        const auto refused = one.compensator.findAxis("1");
        VERIFY_ERROR(refused, ErrorCode::AxisAmbiguous);
        QCOMPARE(sentence(refused.error()),
            "several axes are named 1: give the index, one of 0, index:1");
    }

    void aWriteLeavesExactlyWhatWasAskedFor()
    {
        CompensatorFixture f;
        const auto report = f.compensator.write(0, exampleRequest());
        VERIFY_RESULT(report);
        QCOMPARE(report->now.setup.slot, report->plan.after.slot);
        QCOMPARE(report->now.setup.dimensionality, 2);
        QCOMPARE(report->now.setup.sources[0].path, masterX);
        QCOMPARE(report->now.setup.sources[1].path, masterY);
        QCOMPARE(report->now.setup.persistency, Persistency::Volatile);
        QVERIFY(std::filesystem::exists(report->backup));
        const auto table = f.compensator.readTable(0);
        VERIFY_RESULT(table);
        QCOMPARE(table->values, exampleTable(2).values);
        QCOMPARE(f.text(activation), "Disabled");
    }

    void aVolatileWriteCostsNoFlashAndIsGoneAfterAReboot()
    {
        CompensatorFixture f;
        const auto report = f.compensator.write(0, exampleRequest());
        VERIFY_RESULT(report);
        QCOMPARE(report->plan.flashOperations, 0);
        f.drive.reboot();
        const auto status = f.compensator.status(0);
        VERIFY_RESULT(status);
        QVERIFY(!status->table);
    }

    void aPersistentWriteCostsOneFlashOperationAndSurvivesAReboot()
    {
        CompensatorFixture f;
        const auto report = f.compensator.write(0, exampleRequest(1, Persistency::Persistent));
        VERIFY_RESULT(report);
        QCOMPARE(report->plan.flashOperations, 1);
        const auto before = f.state();
        f.drive.reboot();
        QVERIFY(f.state() == before);
        const std::string slot = report->plan.after.slot;
        QCOMPARE(f.text("Application/Tables/" + slot + "/EraseCount"), "1");
    }

    void anAxisTakesTwoSlotsInTurn()
    {
        CompensatorFixture f;
        std::vector<std::string> slots;
        for (int seed = 1; seed <= 4; ++seed) {
            const auto report =
                f.compensator.write(0, exampleRequest(seed, Persistency::Persistent));
            VERIFY_RESULT(report);
            slots.push_back(report->now.setup.slot);
        }
        QVERIFY(slots[0] != slots[1]);
        QCOMPARE(slots[2], slots[0]);
        QCOMPARE(slots[3], slots[1]);
    }

    void theSameAgainIsNothingToWrite()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest()));
        VERIFY_ERROR(f.compensator.write(0, exampleRequest()), ErrorCode::NothingToWrite);
    }

    void sourcesAloneCanBeChanged()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest()));
        const auto slot = f.state().registers[0];
        WriteRequest request;
        request.dimensionality = 2;
        request.sources = {masterY, masterX};
        const auto report = f.compensator.write(0, request);
        VERIFY_RESULT(report);
        QCOMPARE(report->plan.changes.size(), std::size_t{2});
        QCOMPARE(report->plan.changes[0].field, "Dim1Source");
        QCOMPARE(report->plan.changes[0].after, "tam://mc/Test-1/" + masterY);
        QCOMPARE(f.state().registers[0], slot);
    }

    /// Flash holds an earlier table, which the restart brings back.
    void aTableThatARestartTakesAwayIsNotSaidToBePersistent()
    {
        int looked = 0; // exchanges until the program knows what the axis has
        bool isOver = false;
        for (int exchange = 1; !isOver; ++exchange) {
            CompensatorFixture f;
            VERIFY_RESULT(f.compensator.write(0, exampleRequest(1, Persistency::Persistent)));
            WriteRequest request = exampleRequest(2, Persistency::Volatile);
            request.slot = f.state().registers[0];
            VERIFY_RESULT(f.compensator.write(0, request));
            int begin = f.link.exchanges();
            const auto before = f.compensator.status(0);
            VERIFY_RESULT(before);
            looked = f.link.exchanges() - begin;
            begin = f.link.exchanges();
            f.link.actBefore(exchange, [&f] { f.drive.reboot(); });
            const auto report = f.compensator.setPersistency(0, Persistency::Persistent);
            isOver = f.link.exchanges() - begin < exchange;
            const auto after = f.compensator.status(0);
            VERIFY_RESULT(after);
            const bool isIts =
                after->table && after->table->crc == before->table->crc && after->table->persistent;
            QVERIFY2(!report || isIts || exchange <= looked,
                "restart at exchange " + QByteArray::number(exchange));
        }
        QVERIFY(looked > 0);
    }

    void persistencyOfTheTableOnTheDriveCanBeChanged()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest()));
        const auto persisted = f.compensator.setPersistency(0, Persistency::Persistent);
        VERIFY_RESULT(persisted);
        QCOMPARE(persisted->plan.flashOperations, 1);
        const auto state = f.state();
        f.drive.reboot();
        QVERIFY(f.state() == state);
        VERIFY_RESULT(f.compensator.setPersistency(0, Persistency::Volatile));
        f.drive.reboot();
        QVERIFY(f.state().table.empty());
    }

    void whatFlashHoldsIsNotCommittedAgain()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest(1, Persistency::Persistent)));
        const auto again = f.compensator.setPersistency(0, Persistency::Persistent);
        VERIFY_RESULT(again);
        QCOMPARE(again->plan.flashOperations, 0);
        QCOMPARE(f.text("Application/Tables/" + again->plan.after.slot + "/EraseCount"), "1");
    }

    void aTableThatTheOtherSlotStillHoldsCostsNothing()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest(1, Persistency::Persistent)));
        VERIFY_RESULT(f.compensator.write(0, exampleRequest(2, Persistency::Persistent)));
        const auto back = f.compensator.write(0, exampleRequest(1, Persistency::Persistent));
        VERIFY_RESULT(back);
        QCOMPARE(back->plan.flashOperations, 0);
        const auto state = f.state();
        f.drive.reboot();
        QVERIFY(f.state() == state);
        const auto use = f.compensator.flashUse();
        VERIFY_RESULT(use);
        QCOMPARE(use->mostCycles, 1U);
        QCOMPARE(use->allCycles, std::uint64_t{2});
        QCOMPARE(use->operationsRecorded, std::uint64_t{2});
        QCOMPARE(use->budget.left, 6);
    }

    /// Operations of others are not in the history of this computer.
    void whatTheDriveRefusesIsRememberedByTheNextProgram()
    {
        CompensatorFixture f;
        const auto& layout = drivecomm::genericProfile().layout;
        for (int seed = 1; seed <= 8; ++seed)
            VERIFY_RESULT(f.drive.upload(
                "tables/large2.TAMtbl", *encodeTamTable(exampleTable(1, seed), true, layout)));
        const auto old = f.state();
        VERIFY_ERROR(f.compensator.write(0, exampleRequest(1, Persistency::Persistent)),
            ErrorCode::FlashWear);
        QVERIFY(f.state() == old);

        AxisCompensator next(
            f.link, drivecomm::genericProfile(), f.store, [&f] { return f.wallTime(); });
        f.link.forgetChange();
        VERIFY_ERROR(
            next.write(0, exampleRequest(1, Persistency::Persistent)), ErrorCode::FlashWear);
        VERIFY_ERROR(
            next.upload("tables/large1.TAMtbl", *encodeTamTable(exampleTable(1, 9), true, layout)),
            ErrorCode::FlashWear);
        QCOMPARE(f.link.firstChange(), 0);
        VERIFY_RESULT(next.write(0, exampleRequest(1, Persistency::Volatile)));
        f.pass(std::chrono::minutes(10));
        VERIFY_RESULT(next.write(0, exampleRequest(2, Persistency::Persistent)));
    }

    void aPlainUploadKeepsTheOldFile()
    {
        CompensatorFixture f;
        const auto& layout = drivecomm::genericProfile().layout;
        const auto first = encodeTamTable(exampleTable(1, 1), false, layout);
        const auto second = encodeTamTable(exampleTable(1, 2), false, layout);
        const std::string path = "tables/large1.TAMtbl";
        VERIFY_RESULT(f.compensator.upload(path, *first));
        const auto kept = f.compensator.upload(path, *second);
        VERIFY_RESULT(kept);
        const auto text = loadFile(*kept, maximumBackupSize);
        VERIFY_RESULT(text);
        const auto backup = readBackup(asText(*text), kept->string());
        VERIFY_RESULT(backup);
        VERIFY_RESULT(f.compensator.restore(*backup, false));
        QCOMPARE(f.drive.download(path).value_or(Bytes{}), *first);
        const auto same = f.compensator.upload(path, *first);
        VERIFY_RESULT(same);
        QVERIFY(same->empty());
    }

    void aWornFlashIsSaidBeforeTheWrite()
    {
        CompensatorFixture f;
        for (int seed = 1; seed <= 8; ++seed)
            VERIFY_RESULT(f.compensator.write(0, exampleRequest(seed, Persistency::Persistent)));
        const auto state = f.state();
        const auto refused = f.compensator.write(0, exampleRequest(9, Persistency::Persistent));
        VERIFY_ERROR(refused, ErrorCode::FlashWear);
        QVERIFY(f.state() == state);
        VERIFY_RESULT(f.compensator.write(0, exampleRequest(9, Persistency::Volatile)));
        f.pass(std::chrono::minutes(10));
        VERIFY_RESULT(f.compensator.setPersistency(0, Persistency::Persistent));
    }

    void activationIsProvedByTheDrivesOwnOutput_data()
    {
        QTest::addColumn<int>("dimensions");
        QTest::newRow("1D") << 1;
        QTest::newRow("2D") << 2;
        QTest::newRow("3D") << 3;
    }
    void activationIsProvedByTheDrivesOwnOutput()
    {
        QFETCH(int, dimensions);
        CompensatorFixture f;
        WriteRequest request;
        request.dimensionality = dimensions;
        request.sources = {masterX, masterY, "Axes[0]/Signals/General/MotorTemperature"};
        request.sources.resize(static_cast<std::size_t>(dimensions));
        request.table = exampleTable(dimensions);
        if (dimensions == 3) {
            request.table->grid.axes[2].name = "T";
            request.table->grid.axes[2].unit = "degC";
        }
        VERIFY_RESULT(f.compensator.write(0, request));
        const auto active = f.compensator.activate(0);
        VERIFY_RESULT(active);
        QCOMPARE(active->axis.stateWord, "Active");
        const auto proof = f.compensator.prove(0);
        VERIFY_RESULT(proof);
        QCOMPARE(proof->samples.size(), std::size_t{5});
        QVERIFY(proof->samples[0].output != 0.0);
        QVERIFY(proof->largestDifference <= proof->tolerance);
        const auto off = f.compensator.deactivate(0);
        VERIFY_RESULT(off);
        QCOMPARE(off->axis.stateWord, "Disabled");
        QCOMPARE(off->output, 0.0);
    }

    void aTableThatOnlyTheRegistersHoldIsWrittenAgain()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest()));
        VERIFY_ERROR(f.compensator.write(0, exampleRequest()), ErrorCode::NothingToWrite);
        const auto before = f.compensator.status(0);
        VERIFY_RESULT(before);
        f.link.altersDownload = [](Bytes& bytes) { bytes.back() ^= std::byte{1}; };
        const auto plan = f.compensator.plan(0, exampleRequest());
        VERIFY_RESULT(plan);
        QVERIFY(plan->after.slot != before->setup.slot);
        f.link.altersDownload = {};
        VERIFY_ERROR(f.compensator.write(0, exampleRequest()), ErrorCode::NothingToWrite);
    }

    void aReadBackThatEndsEarlyIsNoSuccess()
    {
        for (const std::size_t missing : {std::size_t{1}, sizeof(float), std::size_t{64}}) {
            CompensatorFixture f;
            VERIFY_RESULT(f.compensator.write(0, exampleRequest()));
            const auto before = f.state();
            bool hasUploaded = false; // and not been read back yet
            f.link.beginning = [&](std::string_view what) {
                hasUploaded = hasUploaded || what == "upload";
            };
            f.link.altersDownload = [&](Bytes& bytes) {
                if (std::exchange(hasUploaded, false))
                    bytes.resize(bytes.size() - missing);
            };
            const auto report = f.compensator.write(0, exampleRequest(2));
            QVERIFY(!report);
            QVERIFY2(report.error().code == ErrorCode::VerifyMismatch,
                test::describe(report.error()).c_str());
            QVERIFY(f.state() == before);
        }
    }

    void evaluationLooksUpAndAddsNothing()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest()));
        const auto status = f.compensator.evaluate(0);
        VERIFY_RESULT(status);
        QCOMPARE(status->axis.stateWord, "Evaluating");
        QCOMPARE(status->output, 0.0);
        VERIFY_RESULT(f.compensator.prove(0));
    }

    void anActiveCompensationIsNotEvaluated()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest()));
        VERIFY_RESULT(f.compensator.activate(0));
        VERIFY_ERROR(f.compensator.evaluate(0), ErrorCode::CompensationActive);
        QCOMPARE(f.text(activation), "AddToEncoders");
    }

    void aDriveThatRestartsWhileItIsSwitchedIsNotWaitedFor()
    {
        int restarts = 0;
        bool isDone = false;
        for (int exchange = 1; !isDone; ++exchange) {
            CompensatorFixture f;
            VERIFY_RESULT(f.compensator.write(0, exampleRequest(1, Persistency::Persistent)));
            f.link.actBefore(exchange, [&f] { f.drive.reboot(); });
            const int before = f.link.exchanges();
            const auto active = f.compensator.activate(0);
            isDone = f.link.exchanges() - before < exchange;
            if (active) {
                QCOMPARE(active->axis.stateWord, "Active");
                continue;
            }
            const std::string said = sentence(active.error());
            QVERIFY2(said.find("in time") == std::string::npos, said.c_str());
            restarts += said.find("has restarted") != std::string::npos ? 1 : 0;
        }
        QVERIFY(restarts > 0);
    }

    void anAxisThatIsNotHomedIsNotActivated()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest(1, Persistency::Persistent)));
        f.drive.reboot();
        VERIFY_ERROR(f.compensator.activate(0), ErrorCode::NotHomed);
        QCOMPARE(f.text(activation), "Disabled");
    }

    void anAxisWithoutATableIsNotActivated()
    {
        CompensatorFixture f;
        VERIFY_ERROR(f.compensator.activate(0), ErrorCode::NoTable);
        VERIFY_ERROR(f.compensator.evaluate(0), ErrorCode::NoTable);
        VERIFY_ERROR(f.compensator.setPersistency(0, Persistency::Persistent), ErrorCode::NoTable);
        VERIFY_ERROR(f.compensator.readTable(0), ErrorCode::NoTable);
    }

    void anActiveCompensationIsNotWritten()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest()));
        VERIFY_RESULT(f.compensator.activate(0));
        const auto state = f.state();
        VERIFY_ERROR(f.compensator.write(0, exampleRequest(2)), ErrorCode::CompensationActive);
        QVERIFY(f.state() == state);
    }

    void badRequestsAreNamedBeforeAnythingIsWritten_data()
    {
        QTest::addColumn<WriteRequest>("request");
        QTest::addColumn<ErrorCode>("code");
        QTest::addColumn<QString>("says");
        const auto with = [](auto&& change) {
            WriteRequest request = exampleRequest();
            change(request);
            return request;
        };
        QTest::newRow("too few sources") << with([](WriteRequest& r) { r.sources.pop_back(); })
                                         << ErrorCode::SourceMissing << "dimension 2";
        QTest::newRow("too many sources")
            << with([](WriteRequest& r) { r.sources.push_back(masterX); })
            << ErrorCode::SourceSurplus << "dimension 3";
        QTest::newRow("the same source twice")
            << with([](WriteRequest& r) { r.sources[1] = r.sources[0]; })
            << ErrorCode::SourceRepeated << "dimension 1 and dimension 2";
        QTest::newRow("a source that does not exist") << with([](WriteRequest& r) {
            r.sources[0] = "Axes[0]/Signals/PositionController/MasterPositon";
        }) << ErrorCode::SourceNotFound << QString::fromStdString(masterX);
        QTest::newRow("a source of another type")
            << with([](WriteRequest& r) { r.sources[0] = tableRegister; })
            << ErrorCode::SourceWrongType << "SourceTable";
        QTest::newRow("a source of another drive")
            << with([](WriteRequest& r) { r.sources[0] = "tam://mc/Other/" + masterX; })
            << ErrorCode::SourceOtherDrive << "Other";
        QTest::newRow("an address that no register has")
            << with([](WriteRequest& r) { r.sources[0] = "0xfffffff0"; })
            << ErrorCode::SourceNotFound << "0xfffffff0";
        QTest::newRow("a table of other dimensions")
            << with([](WriteRequest& r) { r.table = exampleTable(1); })
            << ErrorCode::DimensionMismatch << "the table is 1D, but 2D is chosen";
        QTest::newRow("a table that fits no slot")
            << with([](WriteRequest& r) { r.table = exampleTable(2, 1, 725); })
            << ErrorCode::TableTooLarge << "2096976";
        QTest::newRow("an unknown slot") << with([](WriteRequest& r) { r.slot = "Medium1"; })
                                         << ErrorCode::SlotNotFound << "Small1";
        QTest::newRow("no table anywhere")
            << with([](WriteRequest& r) { r.table.reset(); }) << ErrorCode::NoTable << "axis 0";
    }
    void badRequestsAreNamedBeforeAnythingIsWritten()
    {
        QFETCH(WriteRequest, request);
        QFETCH(ErrorCode, code);
        QFETCH(QString, says);
        CompensatorFixture f;
        const auto state = f.state();
        const auto report = f.compensator.write(0, request);
        VERIFY_ERROR(report, code);
        const QString text = QString::fromStdString(sentence(report.error()));
        QVERIFY2(text.contains(says), qPrintable(text));
        QVERIFY2(!text.contains(u'?'), qPrintable(text));
        QVERIFY(f.state() == state);
        const auto files = f.drive.listFiles();
        QVERIFY(std::ranges::all_of(files, [](const DriveFile& file) { return file.size == 0; }));
    }

    void aSourceIsGivenByPathUriOrAddress()
    {
        CompensatorFixture f;
        const auto byPath = f.compensator.resolveSource(masterX);
        VERIFY_RESULT(byPath);
        std::string dotted = masterX;
        std::ranges::replace(dotted, '/', '.');
        char hex[16];
        std::snprintf(hex, sizeof hex, "0x%X", byPath->address);
        for (const std::string& text : {dotted, "tam://mc/Test-1/" + masterX, std::string(hex)}) {
            const auto source = f.compensator.resolveSource(text);
            VERIFY_RESULT(source);
            QCOMPARE(source->address, byPath->address);
            QCOMPARE(source->path, masterX);
        }
    }

    void whatSomebodyElseChangedIsNotOverwritten()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest()));
        const auto seen = f.compensator.status(0);
        VERIFY_RESULT(seen);
        f.set("Axes[0]/Parameters/Compensations/Axis/Dim2Source", std::uint32_t{0});
        WriteRequest request = exampleRequest(2);
        request.expected = plannedState(*seen);
        const auto report = f.compensator.write(0, request);
        VERIFY_ERROR(report, ErrorCode::ChangedMeanwhile);
        QVERIFY(sentence(report.error()).find(masterY) != std::string::npos);
    }

    void slotsOfOthersAreLeftAlone()
    {
        CompensatorFixture f;
        f.set("Axes[1]/Parameters/Compensations/Cogging/Table", std::string("Small1"));
        const auto file =
            encodeTamTable(exampleTable(1, 5), false, drivecomm::genericProfile().layout);
        VERIFY_RESULT(f.drive.upload("tables/small2.TAMtbl", *file));
        const auto report = f.compensator.write(0, exampleRequest());
        VERIFY_RESULT(report);
        QCOMPARE(report->plan.after.slot, "Small3");
        QCOMPARE(f.drive.download("tables/small2.TAMtbl").value_or(Bytes{}), *file);
    }

    void savingAllParametersWarnsOfVolatileTablesOfOtherAxes()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(1, exampleRequest(3)));
        const auto report = f.compensator.write(0, exampleRequest(1, Persistency::Persistent));
        VERIFY_RESULT(report);
        QCOMPARE(report->plan.warnings.size(), std::size_t{1});
        QVERIFY(report->plan.warnings[0].english().find("axis 1 (Y)") != std::string::npos);
    }

    void plainFilesAreVerifiedAndPutBackWhenTheyDiffer()
    {
        CompensatorFixture f;
        const auto& layout = drivecomm::genericProfile().layout;
        const auto first = encodeTamTable(exampleTable(1, 1), false, layout);
        const auto second = encodeTamTable(exampleTable(1, 2), false, layout);
        const std::string path = "tables/large1.TAMtbl";
        VERIFY_RESULT(f.compensator.upload(path, *first));
        f.drive.storeNextWrong();
        VERIFY_ERROR(f.compensator.upload(path, *second), ErrorCode::VerifyMismatch);
        QCOMPARE(f.drive.download(path).value_or(Bytes{}), *first);
        VERIFY_ERROR(f.compensator.upload("tables/medium.TAMtbl", *first), ErrorCode::UnknownFile);
    }

    void aBackupBringsAllAxesBack()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest(1, Persistency::Persistent)));
        WriteRequest other = exampleRequest(2);
        VERIFY_RESULT(f.compensator.write(1, other));
        const auto backup = f.compensator.backup();
        VERIFY_RESULT(backup);
        const auto reread = readBackup(writeBackup(*backup), "test");
        VERIFY_RESULT(reread);

        VERIFY_RESULT(f.compensator.write(0, exampleRequest(7)));
        f.drive.reboot();
        const auto restored = f.compensator.restore(*reread, false);
        VERIFY_RESULT(restored);
        QCOMPARE(f.compensator.readTable(0)->values, exampleTable(2, 1).values);
        QCOMPARE(f.compensator.readTable(1)->values, exampleTable(2, 2).values);
        const auto status = f.compensator.status(0);
        QCOMPARE(status->setup.persistency, Persistency::Persistent);
        QCOMPARE(status->setup.sources[1].path, masterY);
    }

    void aRestoreThatFailsInTheMiddleSaysWhatIsWritten()
    {
        const auto prepared = [](CompensatorFixture& f) -> Result<DriveBackup> {
            AXISCOMP_CHECK(f.compensator.write(0, exampleRequest(1)));
            AXISCOMP_CHECK(f.compensator.write(1, exampleRequest(2)));
            auto backup = f.compensator.backup();
            AXISCOMP_CHECK(f.compensator.write(0, exampleRequest(7)));
            AXISCOMP_CHECK(f.compensator.write(1, exampleRequest(8)));
            return backup;
        };
        CompensatorFixture whole;
        const auto original = prepared(whole);
        VERIFY_RESULT(original);
        const int begin = whole.link.exchanges();
        VERIFY_RESULT(whole.compensator.restore(*original, false));
        const int exchanges = whole.link.exchanges() - begin;
        std::map<std::string, int> failures; // by what was written
        for (int exchange = 1; exchange <= exchanges; ++exchange) {
            CompensatorFixture f;
            const auto backup = prepared(f);
            VERIFY_RESULT(backup);
            f.link.failAt(exchange, test::LinkFault::Refused);
            const auto restored = f.compensator.restore(*backup, false);
            f.link.heal();
            if (restored || !restored.error().context.contains("written"))
                continue; // nothing was begun
            const ErrorContext& context = restored.error().context;
            const std::string written = context.english("written");
            ++failures[written];
            const bool isFirst = f.compensator.readTable(0)->values == exampleTable(2, 1).values;
            const bool isSecond = f.compensator.readTable(1)->values == exampleTable(2, 2).values;
            QCOMPARE(isFirst, !written.empty());
            QCOMPARE(isSecond, written == "X, Y");
            QCOMPARE(context.contains("lost"), written == "X, Y");
            QCOMPARE(context.english("notWritten"),
                std::string(written.empty() ? "X, Y"
                        : written == "X"    ? "Y"
                                            : ""));
            QCOMPARE(context.english("ofAxis"),
                std::string(written.empty() ? "0"
                        : written == "X"    ? "1"
                                            : ""));
        }
        QVERIFY(failures[""] > 3 && failures["X"] > 3 && failures["X, Y"] > 0);
    }

    void anActiveAxisThatHasEverythingIsNoObstacle()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest(1, Persistency::Persistent)));
        VERIFY_RESULT(f.compensator.write(1, exampleRequest(2)));
        const auto backup = f.compensator.backup();
        VERIFY_RESULT(backup);
        VERIFY_RESULT(f.compensator.write(1, exampleRequest(8)));
        VERIFY_RESULT(f.compensator.activate(0));
        const WriteRequest same = exampleRequest(1, Persistency::Persistent);
        QVERIFY(f.compensator.plan(0, same)->changes.empty());
        VERIFY_ERROR(f.compensator.write(0, same), ErrorCode::NothingToWrite);
        const auto restored = f.compensator.restore(*backup, false);
        VERIFY_RESULT(restored);
        QCOMPARE(restored->axes.size(), std::size_t{1});
        QCOMPARE(f.compensator.readTable(1)->values, exampleTable(2, 2).values);
        QVERIFY(f.compensator.status(0)->isOn());

        // Parameters are saved all the same, and what differs is written: neither while it is on.
        f.link.forgetChange();
        VERIFY_ERROR(f.compensator.setPersistency(0, Persistency::Persistent),
            ErrorCode::CompensationActive);
        WriteRequest saving;
        saving.dimensionality = 2;
        saving.persistency = Persistency::Persistent;
        VERIFY_ERROR(f.compensator.plan(0, saving), ErrorCode::CompensationActive);
        WriteRequest other = same;
        std::swap(other.sources[0], other.sources[1]);
        VERIFY_ERROR(f.compensator.plan(0, other), ErrorCode::CompensationActive);
        other.dimensionality = 1; // whatever else is wrong with it
        VERIFY_ERROR(f.compensator.plan(0, other), ErrorCode::CompensationActive);
        QCOMPARE(f.link.firstChange(), 0);
    }

    /// The second axis cannot be restored: the first one is not begun.
    void aDriveOfWhichOneAxisCannotBeRestoredIsNotChanged()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest(1)));
        VERIFY_RESULT(f.compensator.write(1, exampleRequest(2)));
        const auto backup = f.compensator.backup();
        VERIFY_RESULT(backup);
        VERIFY_RESULT(f.compensator.write(0, exampleRequest(7)));
        VERIFY_RESULT(f.compensator.write(1, exampleRequest(8)));
        VERIFY_RESULT(f.compensator.activate(1));
        const auto before = f.state(0);
        f.link.forgetChange();
        const auto planned = f.compensator.planRestore(*backup, false);
        VERIFY_ERROR(planned, ErrorCode::CompensationActive);
        QCOMPARE(planned.error().context.english("ofAxis"), std::string("1"));
        VERIFY_ERROR(f.compensator.restore(*backup, false), ErrorCode::CompensationActive);
        QCOMPARE(f.link.firstChange(), 0);
        QVERIFY(f.state(0) == before);

        VERIFY_RESULT(f.compensator.deactivate(1));
        const auto possible = f.compensator.planRestore(*backup, false);
        VERIFY_RESULT(possible);
        QCOMPARE(possible->axes.size(), std::size_t{2});
        QVERIFY(!possible->axes.front().changes.empty());
        QVERIFY(!possible->axes.back().changes.empty());
        VERIFY_RESULT(f.compensator.restore(*backup, false));
        QCOMPARE(f.compensator.readTable(0)->values, exampleTable(2, 1).values);
    }

    void aBackupOfAnotherDriveIsRefused()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest()));
        auto backup = f.compensator.backup();
        VERIFY_RESULT(backup);
        for (AxisBackup& axis : backup->axes)
            axis.drive.serialNumber = 1;
        VERIFY_ERROR(f.compensator.restore(*backup, false), ErrorCode::OtherDrive);
        VERIFY_RESULT(f.compensator.restore(*backup, true));
    }

    /// Registers and files that no longer belong together would take the table off the axis.
    void aBackupWithoutTheTableThatItNamesIsRefused()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest()));
        const auto backup = f.compensator.backup();
        VERIFY_RESULT(backup);
        const AxisBackup& axis = backup->axes[0];
        QCOMPARE(axis.files.size(), std::size_t{1});
        const std::string other = axis.files[0].slot == "Small1" ? "Small2" : "Small1";
        DriveBackup withoutFile = *backup;
        withoutFile.axes[0].files.clear();
        DriveBackup otherFile = *backup;
        otherFile.axes[0].files[0].slot = other;
        DriveBackup otherTable = *backup;
        otherTable.axes[0].registers[0].value = other;
        const auto before = f.state();
        f.link.forgetChange();
        for (const DriveBackup& edited : {withoutFile, otherFile, otherTable}) {
            const auto refused = f.compensator.restore(edited, false);
            VERIFY_ERROR(refused, ErrorCode::InvalidBackup);
            const std::string slot = toText(edited.axes[0].registers[0].value);
            QVERIFY(sentence(refused.error()).find("axis 0 used " + slot) != std::string::npos);
            VERIFY_ERROR(f.compensator.planRestore(edited, false), ErrorCode::InvalidBackup);
            VERIFY_ERROR(
                f.compensator.planRestore(edited.axes[0], false), ErrorCode::InvalidBackup);
        }
        QCOMPARE(f.link.firstChange(), 0);
        QVERIFY(f.state() == before);
    }

    void aBackupOfAnAxisThatTheDriveDoesNotHaveIsRefused()
    {
        CompensatorFixture f; // axes 0 and 1
        VERIFY_RESULT(f.compensator.write(0, exampleRequest()));
        const auto backup = f.compensator.backup();
        VERIFY_RESULT(backup);
        const auto before = f.state();
        for (const int axis : {-1, 2, 3}) {
            DriveBackup other = *backup;
            other.axes.resize(1);
            other.axes[0].axis = axis;
            for (RegisterWrite& write : other.axes[0].registers)
                write.path.replace(5, 1, std::to_string(axis)); // Axes[0]
            f.link.forgetChange();
            const auto refused = f.compensator.restore(other, true);
            VERIFY_ERROR(refused, ErrorCode::AxisNotFound);
            QVERIFY(sentence(refused.error()).find("0 to 1") != std::string::npos);
            QCOMPARE(f.link.firstChange(), 0);
        }
        QVERIFY(f.state() == before);
    }

    /// Nothing that is put back has to be known for that.
    void withoutItsJournalAnAxisIsShownAndSwitchedOffButNothingElse()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest()));
        VERIFY_RESULT(f.compensator.activate(0));
        const auto root = f.storeRoot().parent_path() / "unusable";
        std::filesystem::create_directories(root / "axiscomp.db");
        DriveStore unusable(root, {});
        AxisCompensator other(f.link, drivecomm::genericProfile(), unusable);
        VERIFY_ERROR(other.status(0), ErrorCode::FileNotReadable);
        const auto now = settledStatus(other, root, 0, {});
        VERIFY_RESULT(now);
        QVERIFY(!now->isJournalKnown());
        QVERIFY(now->status.isOn());
        VERIFY_ERROR(checkIsWhole(*now), ErrorCode::FileNotReadable);
        VERIFY_RESULT(other.readTable(now->status));
        const auto rescue = backUpDrive(other, root, {});
        VERIFY_RESULT(rescue);
        QVERIFY(!rescue->doubts.empty());

        const auto off = other.switchTo(0, Switch::Deactivate);
        VERIFY_RESULT(off);
        QCOMPARE(off->status.axis.state, CompensationState::Disabled);
        f.link.forgetChange();
        for (const Switch on : {Switch::Activate, Switch::Evaluate})
            VERIFY_ERROR(other.switchTo(0, on), ErrorCode::FileNotReadable);
        VERIFY_ERROR(other.activate(0), ErrorCode::FileNotReadable);
        VERIFY_ERROR(other.evaluate(0), ErrorCode::FileNotReadable);
        VERIFY_ERROR(other.write(0, exampleRequest(2)), ErrorCode::FileNotReadable);
        QCOMPARE(f.link.firstChange(), 0);
    }
};

AXISCOMP_TEST(TestAxisCompensator)

} // namespace tst_axiscompensator

#include "tst_axiscompensator.moc"
