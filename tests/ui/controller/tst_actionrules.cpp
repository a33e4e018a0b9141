// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "ui/controller/action_rules.h"
#include "ui/text/message_text.h"

#include <QTest>

#include <functional>
#include <random>

namespace tst_actionrules {

using namespace axiscomp;
using namespace axiscomp::ui;

namespace {

using Unfinished = ActionSnapshot::Unfinished;

/// An axis that is ready: connected, homed, with a table on the drive, nothing changed.
ActionSnapshot ready()
{
    ActionSnapshot now;
    now.hasDrives = true;
    now.hasAxis = true;
    now.isConnected = true;
    now.isKnown = true;
    now.isHomed = true;
    now.hasDriveTable = true;
    now.hasTable = true;
    now.tableDimensions = 2;
    now.dimensionality = 2;
    now.largestSlotBytes = 63360;
    now.flashOperationsLeft = 8;
    now.hasBackup = true;
    return now;
}

/// The same with a table of a file that can be written.
ActionSnapshot changed()
{
    ActionSnapshot now = ready();
    now.isDirty = true;
    now.isNewTable = true;
    now.tableBytes = 208;
    return now;
}

const Error damagedTable{ErrorCode::CompensationError,
    {{"axis", 0}, {"error", Verbatim{"TableBad"}}, {"hint", Verbatim{"write it again"}}}, {}};
const Error damagedJournal{ErrorCode::FileNotReadable,
    {{"file", Verbatim{"journal.json"}}, {"reason", Verbatim{"the disk reports an error"}}}, {}};

/// docs/user-guide.md, "What the line under the buttons says", once more, as plain conditions.
bool mayWrite(const ActionSnapshot& s)
{
    const bool hasAxis = s.hasDrives && s.hasAxis && s.isConnected && s.hasCompensation;
    const bool isReason = s.isDirty || s.unfinished == Unfinished::Unsaved;
    const bool fits = s.hasTable && s.tableDimensions == s.dimensionality && s.missingSource == 0
        && s.repeatedSource == 0 && !s.isSourceBeingChecked
        && (!s.isNewTable || s.tableBytes <= s.largestSlotBytes);
    return hasAxis && s.isKnown && !s.task && !s.isActive && isReason && !s.isReadingFile && fits
        && s.flashOperationsNeeded <= s.flashOperationsLeft;
}

bool mayActivate(const ActionSnapshot& s)
{
    const bool hasAxis = s.hasDrives && s.hasAxis && s.isConnected && s.hasCompensation;
    const bool fits = s.hasTable && s.hasDriveTable && s.tableDimensions == s.dimensionality
        && s.missingSource == 0 && s.repeatedSource == 0 && !s.isSourceBeingChecked
        && (!s.isNewTable || s.tableBytes <= s.largestSlotBytes);
    return hasAxis && s.isKnown && !s.task && !s.isActive && !s.isDirty && fits && s.isHomed
        && s.unfinished != Unfinished::Mixture && s.unfinished != Unfinished::Unknown;
}

bool isSentence(const QString& text)
{
    return !text.isEmpty() && (text.endsWith(u'.') || text.endsWith(QStringLiteral("...")))
        && text.front().isUpper();
}

} // namespace

class TestActionRules : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void reasons_data();
    void reasons()
    {
        QFETCH(ActionSnapshot, now);
        QFETCH(int, action);
        QFETCH(QString, reason);
        const ActionState state = decideActions(now)[static_cast<Action>(action)];
        QCOMPARE(state.reason, reason);
        QVERIFY(!state.isEnabled);
    }

    void consequences_data();
    void consequences()
    {
        QFETCH(ActionSnapshot, now);
        QFETCH(int, action);
        QFETCH(QString, consequence);
        const ActionState state = decideActions(now)[static_cast<Action>(action)];
        QVERIFY2(state.isEnabled, qPrintable(state.reason));
        QCOMPARE(state.reason, consequence);
    }

    void hints_data();
    void hints()
    {
        QFETCH(ActionSnapshot, now);
        QFETCH(QString, hint);
        QCOMPARE(decideActions(now).hint, hint);
    }

    void invariantsHoldInARandomWalkOf10000Steps()
    {
        std::mt19937 random(616);
        ActionSnapshot now = ready();
        int writable = 0;
        int activatable = 0;
        for (int step = 0; step < 10'000; ++step) {
            mutate(now, random);
            const ActionStates decision = decideActions(now);
            QVERIFY(decision == decideActions(now));
            QCOMPARE(decision[Action::Write].isEnabled, mayWrite(now));
            QCOMPARE(decision[Action::Activate].isEnabled, mayActivate(now));
            for (const Action action : allActions)
                QVERIFY2(isSentence(decision[action].reason), qPrintable(decision[action].reason));
            QVERIFY2(isSentence(decision.hint), qPrintable(decision.hint));
            checkPairs(now, decision);
            if (QTest::currentTestFailed())
                return;
            writable += decision[Action::Write].isEnabled;
            activatable += decision[Action::Activate].isEnabled;
        }
        // The walk has been on both sides of every rule.
        QVERIFY2(writable > 200, qPrintable(QString::number(writable)));
        QVERIFY2(activatable > 200, qPrintable(QString::number(activatable)));
    }

private:
    static void mutate(ActionSnapshot& now, std::mt19937& random);
    static void checkPairs(const ActionSnapshot& now, const ActionStates& decision)
    {
        if (now.task) {
            for (const Action action : allActions)
                QVERIFY(action == Action::Cancel || !decision[action].isEnabled);
        }
        if (now.isDirty)
            QVERIFY(!decision[Action::Activate].isEnabled && !decision[Action::Evaluate].isEnabled);
        if (now.isActive)
            QVERIFY(!decision[Action::Write].isEnabled && !decision[Action::Activate].isEnabled
                && !decision[Action::RestorePrevious].isEnabled
                && !decision[Action::DeleteTable].isEnabled);
        if (!now.isConnected)
            QVERIFY(!decision[Action::Deactivate].isEnabled);
        // Who can deactivate has something to deactivate.
        if (decision[Action::Deactivate].isEnabled)
            QVERIFY(now.isActive || now.isEvaluating || now.problem);
        QCOMPARE(
            decision[Action::Cancel].isEnabled, now.isReadingFile || (now.task && now.canCancel));
        if (decision[Action::Write].isEnabled && now.isDirty
            && now.unfinished != Unfinished::Mixture)
            QCOMPARE(decision.hint, QStringLiteral("The parameters still have to be saved."));
    }
};

void TestActionRules::reasons_data()
{
    QTest::addColumn<ActionSnapshot>("now");
    QTest::addColumn<int>("action");
    QTest::addColumn<QString>("reason");
    const auto row = [](const char* name, ActionSnapshot now, Action action, const char* reason,
                         const std::function<void(ActionSnapshot&)>& change) {
        change(now);
        QTest::newRow(name) << now << static_cast<int>(action) << QString::fromUtf8(reason);
    };
    using S = ActionSnapshot;
    row("write: nothing changed", ready(), Action::Write, "Nothing has changed.", [](S&) {});
    row("write: no table", changed(), Action::Write, "No table is chosen: open compensation data.",
        [](S& s) { s.hasTable = false; });
    row("write: source missing", changed(), Action::Write, "Dim2 Source is missing.",
        [](S& s) { s.missingSource = 2; });
    row("write: source twice", changed(), Action::Write,
        "Dim2 Source is the same as another source.", [](S& s) { s.repeatedSource = 2; });
    row("write: dimensions", changed(), Action::Write,
        "The table has 2 dimensions, but 3D is chosen.", [](S& s) { s.dimensionality = 3; });
    row("write: one dimension", changed(), Action::Write,
        "The table has 1 dimension, but 2D is chosen.", [](S& s) { s.tableDimensions = 1; });
    row("write: too large", changed(), Action::Write,
        "The table needs 70000 bytes, but the largest slot has 63360.",
        [](S& s) { s.tableBytes = 70000; });
    row("write: active", changed(), Action::Write,
        "The compensation is active: deactivate it first.", [](S& s) { s.isActive = true; });
    row("write: not connected", changed(), Action::Write, "The drive is not connected.",
        [](S& s) { s.isConnected = false; });
    row("write: flash wear", changed(), Action::Write,
        "To spare the flash, wait 3:12 or write volatile.", [](S& s) {
            s.isPersistent = true;
            s.flashOperationsNeeded = 1;
            s.flashOperationsLeft = 0;
            s.flashWaitSeconds = 192;
        });
    row("write: flash record damaged", changed(), Action::Write,
        "The record of this drive's flash operations was damaged, so all of them count as used "
        "up. Write volatile, or run \"axiscomp status --reset-flash-count\".",
        [](S& s) {
            s.isPersistent = true;
            s.flashOperationsNeeded = 1;
            s.flashOperationsLeft = 0;
            s.isFlashRecordLost = true;
        });
    row("write: flash wear while erasing", changed(), Action::Write,
        "Removing the table from flash is a flash operation too: wait 0:05, or keep the table "
        "persistent.",
        [](S& s) {
            s.flashOperationsNeeded = 1;
            s.flashOperationsLeft = 0;
            s.flashWaitSeconds = 5;
        });
    row("several: one column", ready(), Action::WriteSeveral,
        "Open a file with several columns of values first.", [](S& s) { s.usableAxes = 2; });
    row("several: one axis", ready(), Action::WriteSeveral,
        "The drive has no second axis with compensation registers.",
        [](S& s) { s.fileTables = 2; });
    row("several: busy", ready(), Action::WriteSeveral, "Please wait: writing several axes.",
        [](S& s) { s.task = Task::WriteSeveral; });
    row("import: unfinished", ready(), Action::ImportConfiguration,
        "An earlier write was interrupted: finish or undo it first.",
        [](S& s) { s.unfinished = Unfinished::Old; });
    row("export: unfinished", ready(), Action::ExportConfiguration,
        "An earlier write was interrupted: finish or undo it first.",
        [](S& s) { s.unfinished = Unfinished::Unsaved; });
    row("import: unfinished, without its backup", ready(), Action::ImportConfiguration,
        "An earlier write was interrupted, and the backup of the state before it cannot be read: "
        "write again or restore another backup first.",
        [](S& s) {
            s.unfinished = Unfinished::Unsaved;
            s.isBackupUnread = true;
        });
    row("import: not connected", ready(), Action::ImportConfiguration,
        "The drive is not connected.", [](S& s) { s.isConnected = false; });
    row("export: busy", ready(), Action::ExportConfiguration, "Please wait: importing parameters.",
        [](S& s) { s.task = Task::Import; });
    row("write: busy", changed(), Action::Write, "Please wait: activating.",
        [](S& s) { s.task = Task::Activate; });
    row("write: no axis", changed(), Action::Write, "Choose an axis first.",
        [](S& s) { s.hasAxis = false; });
    row("write: no drive", changed(), Action::Write,
        "No drive is connected: add a connection first.", [](S& s) { s.hasDrives = false; });
    row("write: no registers", changed(), Action::Write, "This axis has no compensation registers.",
        [](S& s) { s.hasCompensation = false; });
    row("write: source checked", changed(), Action::Write, "A source is being checked.",
        [](S& s) { s.isSourceBeingChecked = true; });
    row("write: file read", changed(), Action::Write, "The file is being read.",
        [](S& s) { s.isReadingFile = true; });
    row("activate: unwritten", changed(), Action::Activate,
        "The parameters still have to be saved.", [](S&) {});
    row("activate: active", ready(), Action::Activate, "The compensation is already active.",
        [](S& s) { s.isActive = true; });
    row("activate: not homed", ready(), Action::Activate, "The axis must be homed first.",
        [](S& s) { s.isHomed = false; });
    row("activate: no table", ready(), Action::Activate,
        "The axis has no table on the drive: write one first.",
        [](S& s) { s.hasDriveTable = s.hasTable = false; });
    row("activate: does not fit", ready(), Action::Activate, "Dim1 Source is missing.",
        [](S& s) { s.missingSource = 1; });
    row("activate: mixture", ready(), Action::Activate,
        "An earlier write left the axis in neither the old nor the new state: write again or "
        "restore the previous state.",
        [](S& s) { s.unfinished = Unfinished::Mixture; });
    row("activate: nobody knows", ready(), Action::Activate,
        "What an earlier write left is not known: write again or restore another backup.",
        [](S& s) { s.unfinished = Unfinished::Unknown; });
    row("evaluate: evaluating", ready(), Action::Evaluate,
        "The compensation is already being evaluated.", [](S& s) { s.isEvaluating = true; });
    row("deactivate: off", ready(), Action::Deactivate, "The compensation is not active.",
        [](S&) {});
    row("deactivate: lost", ready(), Action::Deactivate, "The drive is not connected.", [](S& s) {
        s.isActive = true;
        s.isConnected = false;
    });
    row("revert: nothing changed", ready(), Action::Revert, "Nothing has changed.", [](S&) {});
    row("restore: no backup", ready(), Action::RestorePrevious,
        "This axis has no backup yet; every write makes one.", [](S& s) { s.hasBackup = false; });
    row("restore: active", ready(), Action::RestorePrevious,
        "The compensation is active: deactivate it first.", [](S& s) { s.isActive = true; });
    row("delete: no table", ready(), Action::DeleteTable, "The axis has no table on the drive.",
        [](S& s) { s.hasDriveTable = false; });
    row("delete: active", ready(), Action::DeleteTable,
        "The compensation is active: deactivate it first.", [](S& s) { s.isActive = true; });
    row("cancel: nothing", ready(), Action::Cancel, "Nothing is running.", [](S&) {});
    row("cancel: twice", ready(), Action::Cancel, "It is already being stopped.",
        [](S& s) { s.task = Task::Write; });
    row("not read yet", changed(), Action::Write, "The axis is being read.",
        [](S& s) { s.isKnown = false; });
    row("cannot be read", changed(), Action::Activate, qUtf8Printable(errorText(damagedJournal)),
        [](S& s) {
            s.isKnown = false;
            s.readProblem = damagedJournal;
        });
}

void TestActionRules::consequences_data()
{
    QTest::addColumn<ActionSnapshot>("now");
    QTest::addColumn<int>("action");
    QTest::addColumn<QString>("consequence");
    ActionSnapshot now = changed();
    const auto row = [&now](const char* name, Action action, const char* consequence) {
        QTest::newRow(name) << now << static_cast<int>(action) << QString::fromUtf8(consequence);
    };
    row("write volatile", Action::Write,
        "Writes to the drive; a reboot of the drive restores the stored state.");
    now.isPersistent = true;
    now.flashOperationsNeeded = 1;
    now.flashOperationsLeft = 7;
    row("write persistent", Action::Write,
        "Writes to the drive and stores in flash; uses 1 of the 7 flash operations available now.");
    now.isPersistent = false; // the table that the axis has
    row("remove from flash", Action::Write,
        "Removes the table from flash, which uses 1 of the 7 flash operations available now.");
    now.isReadingFile = true;
    row("cancel reading", Action::Cancel, "Stops reading the file.");
    now = ready();
    now.unfinished = Unfinished::Unsaved;
    row("finish a write", Action::Write,
        "Finishes an earlier write: saves the parameters of the drive.");
    now.canCancel = true;
    now.task = Task::Plan;
    row("cancel planning", Action::Cancel, "Stops what is running.");
    now.task = Task::Restore;
    row("cancel restoring", Action::Cancel, "Stops the write and rolls back.");
    now.task = Task::Delete;
    row("cancel deleting", Action::Cancel, "Stops the write and rolls back.");
    now.task = Task::Write;
    row("cancel writing", Action::Cancel, "Stops the write and rolls back.");
    now = ready();
    row("delete", Action::DeleteTable,
        "Deletes the axis's table from the drive; a backup is kept.");
    row("import", Action::ImportConfiguration,
        "Writes the table and source parameters of a TAM configuration to the drive.");
    row("export", Action::ExportConfiguration,
        "Puts the drive's table and source parameters into a TAM configuration.");
    now.problem = damagedTable;
    row("deactivate an error", Action::Deactivate,
        "Switches the compensation off; table and settings stay on the drive.");
    // What has been changed can be put back without the drive.
    now = changed();
    now.isConnected = false;
    row("revert while lost", Action::Revert, "Resets the fields to the drive's values.");
}

void TestActionRules::hints_data()
{
    QTest::addColumn<ActionSnapshot>("now");
    QTest::addColumn<QString>("hint");
    const auto row = [](const char* name, ActionSnapshot now, const char* hint,
                         const std::function<void(ActionSnapshot&)>& change) {
        change(now);
        QTest::newRow(name) << now << QString::fromUtf8(hint);
    };
    using S = ActionSnapshot;
    row("unwritten", changed(), "The parameters still have to be saved.", [](S&) {});
    row("unwritten, does not fit", changed(), "Dim1 Source is missing.",
        [](S& s) { s.missingSource = 1; });
    row("unwritten, active", changed(), "The compensation is active: deactivate it first.",
        [](S& s) { s.isActive = true; });
    row("active", ready(), "The compensation is active.", [](S& s) { s.isActive = true; });
    row("not homed", ready(), "The axis must be homed first.", [](S& s) { s.isHomed = false; });
    row("ready", ready(),
        "Adds the table to the encoder position and proves that the drive's output matches the "
        "table.",
        [](S&) {});
    row("no table at all", ready(), "No table is chosen: open compensation data.",
        [](S& s) { s.hasDriveTable = s.hasTable = false; });
    row("error", ready(), qUtf8Printable(errorText(damagedTable)),
        [](S& s) { s.problem = damagedTable; });
    row("busy", changed(), "Writing ...", [](S& s) { s.task = Task::Write; });
    row("connecting", ready(), "Reading the axes of the drives.", [](S& s) {
        s.hasAxis = false;
        s.isConnecting = true;
    });
    row("lost while changed", changed(), "The drive is not connected.",
        [](S& s) { s.isConnected = false; });
    row("unsaved", ready(),
        "An earlier write was interrupted: its parameters may not be saved. Write to finish it.",
        [](S& s) { s.unfinished = Unfinished::Unsaved; });
}

/// One thing changes, as it does when a user or a drive acts; most of the time towards a state in
/// which something can be done.
void TestActionRules::mutate(ActionSnapshot& now, std::mt19937& random)
{
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    const auto rarely = [&] { return below(6) == 0; };
    const auto mostly = [&] { return below(6) != 0; };
    const std::array<std::function<void()>, 22> changes{
        [&] { now.hasDrives = mostly(); },
        [&] { now.hasAxis = mostly(); },
        [&] { now.isConnected = mostly(); },
        [&] { now.hasCompensation = mostly(); },
        [&] { now.isKnown = mostly(); },
        [&] { now.isActive = rarely(); },
        [&] { now.isEvaluating = rarely(); },
        [&] { now.problem = rarely() ? std::optional(damagedTable) : std::nullopt; },
        [&] { now.isHomed = mostly(); },
        [&] { now.hasDriveTable = mostly(); },
        [&] { now.hasBackup = mostly(); },
        [&] { now.unfinished = rarely() ? static_cast<Unfinished>(below(3)) : Unfinished::None; },
        [&] { now.flashOperationsLeft = rarely() ? 0 : below(9); },
        [&] { now.isDirty = below(2) == 0; },
        [&] { now.dimensionality = now.tableDimensions = 1 + below(3); },
        [&] { now.missingSource = rarely() ? 1 + below(now.dimensionality) : 0; },
        [&] { now.repeatedSource = rarely() && now.dimensionality > 1 ? 2 : 0; },
        [&] { now.isSourceBeingChecked = rarely(); },
        [&] {
            now.hasTable = mostly();
            now.tableDimensions = 1 + below(3);
            now.isNewTable = below(2) == 0;
            now.tableBytes = rarely() ? 70000 : 304;
        },
        [&] {
            now.isPersistent = below(2) == 0;
            now.flashOperationsNeeded = now.isPersistent ? below(2) : 0;
        },
        [&] { now.isReadingFile = rarely(); },
        [&] {
            now.task = rarely() ? std::optional(static_cast<Task>(below(6))) : std::nullopt;
            now.canCancel = now.task && mostly();
        },
    };
    changes[static_cast<std::size_t>(below(static_cast<int>(changes.size())))]();
}

AXISCOMP_TEST(TestActionRules)

} // namespace tst_actionrules

#include "tst_actionrules.moc"
