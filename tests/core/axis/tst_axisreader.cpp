// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/axis/axis_reader.h"
#include "drivecomm/profile/profile_loader.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

namespace tst_axisreader {

using namespace axiscomp;

/// What the words of a drive mean is decided here and nowhere else.
class TestAxisReader : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theProfileSaysWhichWordIsWhichState()
    {
        RegisterEnums enums = drivecomm::genericProfile().enums;
        QCOMPARE(compensationState(enums, "Disabled"), CompensationState::Disabled);
        QCOMPARE(compensationState(enums, "Evaluating"), CompensationState::Evaluating);
        QCOMPARE(compensationState(enums, "Ramping"), CompensationState::Ramping);
        QCOMPARE(compensationState(enums, "Active"), CompensationState::Active);
        QCOMPARE(compensationState(enums, "Error"), CompensationState::Error);
        enums.stateActive = "Ein";
        QCOMPARE(compensationState(enums, "Ein"), CompensationState::Active);
        QCOMPARE(compensationState(enums, "Active"), CompensationState::Unknown);
    }

    void aWordThatTheProfileDoesNotHaveIsNoStateAtAll()
    {
        const RegisterEnums& enums = drivecomm::genericProfile().enums;
        QCOMPARE(compensationState(enums, "active"), CompensationState::Unknown);
        QCOMPARE(compensationState(enums, ""), CompensationState::Unknown);
        QCOMPARE(compensationFault(enums, "Overheated"), CompensationFault::Other);
    }

    void aFaultThatTheProfileDoesNotNameIsStillAFault()
    {
        RegisterEnums enums = drivecomm::genericProfile().enums;
        QCOMPARE(compensationFault(enums, "None"), CompensationFault::None);
        QCOMPARE(compensationFault(enums, "NotHomed"), CompensationFault::NotHomed);
        enums.errorNotHomed.clear(); // an older profile does not have the key
        QCOMPARE(compensationFault(enums, "NotHomed"), CompensationFault::Other);
        QCOMPARE(compensationFault(enums, ""), CompensationFault::None);
    }
};

AXISCOMP_TEST(TestAxisReader)

} // namespace tst_axisreader

#include "tst_axisreader.moc"
