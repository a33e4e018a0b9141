// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/write/slot_choice.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

namespace tst_slotchoice {

using namespace axiscomp;

namespace {

SlotFacts small(const char* name, std::uint32_t size = 0)
{
    SlotFacts facts;
    facts.slot = {name, std::string("tables/") + name, 1000};
    facts.size = size;
    return facts;
}

SlotFacts large(const char* name, std::uint32_t size = 0)
{
    SlotFacts facts = small(name, size);
    facts.slot.maximumSize = 100000;
    return facts;
}

} // namespace

class TestSlotChoice : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void anEmptySlotIsTakenTheSmallestThatFits()
    {
        const auto choice =
            chooseSlot(500, {}, {large("Large1"), small("Small1"), small("Small2")});
        VERIFY_RESULT(choice);
        QCOMPARE(choice->slot.name, "Small1");
        QCOMPARE(choice->reason, SlotReason::Empty);
        const auto big = chooseSlot(5000, {}, {small("Small1"), large("Large1")});
        VERIFY_RESULT(big);
        QCOMPARE(big->slot.name, "Large1");
    }

    void theAxisOwnPreviousSlotComesBeforeAnEmptyOne()
    {
        SlotFacts previous = large("Large1", 700);
        previous.isOwnPrevious = true;
        const auto choice = chooseSlot(500, {}, {small("Small1"), previous});
        VERIFY_RESULT(choice);
        QCOMPARE(choice->slot.name, "Large1");
        QCOMPARE(choice->reason, SlotReason::OwnPrevious);
    }

    void aSlotThatARebootMayBringBackIsTakenLast()
    {
        SlotFacts kept = small("Small1", 700);
        kept.isOwnPrevious = kept.isKept = true;
        SlotFacts current = small("Small2", 700);
        current.isCurrent = true;
        QCOMPARE(chooseSlot(500, {}, {kept, current, small("Small3")})->slot.name, "Small3");
        QCOMPARE(chooseSlot(500, {}, {kept, current})->slot.name, "Small2");
        current.isKept = true;
        QCOMPARE(chooseSlot(500, {}, {kept, current})->slot.name, "Small1");
    }

    void theSlotInUseIsNeverTakenAsPrevious()
    {
        SlotFacts current = small("Small1", 700);
        current.isCurrent = true;
        current.isOwnPrevious = true;
        const auto choice = chooseSlot(500, {}, {current, small("Small2")});
        VERIFY_RESULT(choice);
        QCOMPARE(choice->slot.name, "Small2");
    }

    void withNoFreeSlotTheOwnOneIsOverwritten()
    {
        SlotFacts current = small("Small1", 700);
        current.isCurrent = true;
        SlotFacts unknown = small("Small2", 700);
        const auto choice = chooseSlot(500, {}, {current, unknown});
        VERIFY_RESULT(choice);
        QCOMPARE(choice->slot.name, "Small1");
        QCOMPARE(choice->reason, SlotReason::OverwriteOwn);
    }

    void aSlotThatSomethingElseUsesIsRefusedEvenWhenNamed()
    {
        SlotFacts used = small("Small1", 700);
        used.otherUser = Verbatim{"the cogging compensation of axis 1"};
        const auto choice = chooseSlot(500, "Small1", {used, small("Small2")});
        VERIFY_ERROR(choice, ErrorCode::SlotInUse);
        QCOMPARE(sentence(choice.error()),
            "slot Small1 is in use by the cogging compensation of axis 1: name another slot, or "
            "none, and a free one is chosen");
    }

    void aSlotThatTheAxisSharesIsNotOverwritten()
    {
        SlotFacts shared = small("Small1", 700);
        shared.isCurrent = true;
        shared.otherUser = Verbatim{"axis 1"};
        VERIFY_ERROR(chooseSlot(500, {}, {shared}), ErrorCode::NoFreeSlot);
    }

    void anUnknownTableIsTakenOnlyWhenNamed()
    {
        const auto refused = chooseSlot(500, {}, {small("Small1", 700)});
        VERIFY_ERROR(refused, ErrorCode::NoFreeSlot);
        QVERIFY(sentence(refused.error()).find("Small1 holds a table that is not this axis's")
            != std::string::npos);
        const auto named = chooseSlot(500, "Small1", {small("Small1", 700)});
        VERIFY_RESULT(named);
        QCOMPARE(named->reason, SlotReason::Named);
    }

    void aNamedSlotIsOverwrittenOnlyIfSomethingIsInIt()
    {
        const auto full = chooseSlot(500, "Small1", {small("Small1", 700)});
        VERIFY_RESULT(full);
        QVERIFY(!full->isEmpty);
        const auto empty = chooseSlot(500, "Small1", {small("Small1")});
        VERIFY_RESULT(empty);
        QVERIFY(empty->isEmpty);
    }

    void aTableThatFitsNowhereNamesItsSizeAndTheLargestSlot()
    {
        const auto choice = chooseSlot(100001, {}, {small("Small1"), large("Large1")});
        VERIFY_ERROR(choice, ErrorCode::TableTooLarge);
        QVERIFY(sentence(choice.error()).find("100001") != std::string::npos);
        QVERIFY(sentence(choice.error()).find("Large1, holds 100000") != std::string::npos);
    }

    void aNamedSlotMustExistAndHoldTheTable()
    {
        VERIFY_ERROR(chooseSlot(5, "Medium", {small("Small1")}), ErrorCode::SlotNotFound);
        VERIFY_ERROR(chooseSlot(5000, "Small1", {small("Small1"), large("Large1")}),
            ErrorCode::TableTooLarge);
    }
};

AXISCOMP_TEST(TestSlotChoice)

} // namespace tst_slotchoice

#include "tst_slotchoice.moc"
