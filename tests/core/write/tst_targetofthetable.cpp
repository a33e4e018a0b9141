// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive/axis_target.h"
#include "core/metrology/fit/measurement_fit.h"
#include "core/neutral/drive_note.h"
#include "core/neutral/lookup_note.h"
#include "core/table/target_axis.h"
#include "tests/support/compensator_fixture.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <algorithm>

namespace tst_targetofthetable {

using namespace axiscomp;
using test::CompensatorFixture;

namespace {

/// A table of one dimension whose file says what it corrects, looked up by the position of X.
WriteRequest requestFor(const std::string& target, const std::string& column)
{
    WriteRequest request;
    request.dimensionality = 1;
    request.sources = {test::masterX};
    request.table = test::exampleTable(1);
    request.table->grid.axes.front().name = column;
    request.table->target = target;
    request.persistency = Persistency::Volatile;
    return request;
}

bool names(const Error& error, std::string_view words)
{
    const std::string said = sentence(error);
    if (said.find(words) == std::string::npos)
        qInfo("%s", said.c_str());
    return said.find(words) != std::string::npos;
}

/// Axis X has a table called "Y error", of which a person has said that it is right.
struct Stated : CompensatorFixture {
    explicit Stated(const std::array<std::string, 2>& names = {"X", "Y"})
        : CompensatorFixture(names)
    {
        request = requestFor("#1", "Position");
        request.table->name = names[1] + " error";
        request.persistency = Persistency::Persistent;
    }
    [[nodiscard]] Result<DriveBackup> written()
    {
        AXISCOMP_CHECK(compensator.write(0, request));
        link.forgetChange();
        return compensator.backup();
    }

    WriteRequest request;
};

} // namespace

/// What a file says of the axis that it corrects, against the axis that is written. The axes of
/// the drive are called X and Y.
class TestTargetOfTheTable : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theErrorsOfAnotherAxisAreNotWritten_data()
    {
        QTest::addColumn<QString>("target");
        QTest::newRow("its name") << "Y";
        QTest::newRow("small letters") << "y";
        QTest::newRow("one of two") << "Y2";
        QTest::newRow("an axis that the drive does not have") << "Z";
    }
    void theErrorsOfAnotherAxisAreNotWritten()
    {
        QFETCH(const QString, target);
        CompensatorFixture f;
        const auto before = f.state();
        const std::string name = target.toStdString();
        const auto refused = f.compensator.write(0, requestFor(name, name));
        VERIFY_ERROR(refused, ErrorCode::TargetMismatch);
        QVERIFY(names(
            refused.error(), "correct " + name + ", but for axis 0 the name on the drive is X"));
        QVERIFY(names(refused.error(), "state the target as #1"));
        QVERIFY(f.state() == before);
        // The way out: a person states the target.
        VERIFY_RESULT(f.compensator.write(0, requestFor("#1", name)));
    }

    /// A column "Position" may be that of any axis; "Y error" over it is still not for X.
    void theNameOfATableTellsTheAxisWhereItsSourceHasNone_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("stated");
        QTest::addColumn<bool>("isOfAnother");
        QTest::newRow("Y error") << "Y error"
                                 << "" << true;
        QTest::newRow("dY2") << "dY2"
                             << "" << true;
        QTest::newRow("a comment of the file") << "E"
                                               << "Y" << true;
        QTest::newRow("the comment, not the name") << "Y error"
                                                   << "X" << false;
        QTest::newRow("X error") << "X error"
                                 << "" << false;
        QTest::newRow("a letter that counts columns") << "B"
                                                      << "" << false;
        QTest::newRow("a symbol of values") << "V"
                                            << "" << false;
        QTest::newRow("a letter with a word") << "V error"
                                              << "" << true;
        QTest::newRow("no axis") << "Mean error"
                                 << "" << false;
    }
    void theNameOfATableTellsTheAxisWhereItsSourceHasNone()
    {
        QFETCH(QString, name);
        QFETCH(QString, stated);
        QFETCH(bool, isOfAnother);
        CompensatorFixture f;
        WriteRequest request = requestFor({}, "Position");
        request.table->name = name.toStdString();
        request.table->statedAxis = stated.toStdString();
        if (!isOfAnother) {
            VERIFY_RESULT(f.compensator.plan(0, request));
            return;
        }
        VERIFY_ERROR(f.compensator.plan(0, request), ErrorCode::TargetMismatch);
        request.table->target = "#1";
        VERIFY_RESULT(f.compensator.plan(0, request));
    }

    void theErrorsOfAnotherAxisOfTheDriveAreNotWritten_data()
    {
        QTest::addColumn<QString>("own");
        QTest::addColumn<QString>("other");
        QTest::addColumn<QString>("stated"); // by a comment
        QTest::addColumn<QString>("name"); // of the column of values
        QTest::addColumn<bool>("isRefused");
        const auto row = [](const char* own, const char* other, const char* stated,
                             const char* name, bool isRefused) {
            QTest::addRow("%s, %s for %s beside %s", stated, name, own, other)
                << own << other << stated << name << isRefused;
        };
        row("X1", "X2", "X2", "E", true);
        row("X1", "X2", "", "X2 error", true);
        row("X1", "X2", "", "dX2", true);
        row("X1", "X2", "X1", "X2 error", false);
        row("X1", "X2", "X", "E", false);
        row("X1", "Y", "X2", "E", false);
        row("Left", "Right", "right", "E", true);
        row("Left", "Right", "", "Right error", true);
        row("Left", "Right", "", "Right", true);
        row("Left", "Right", "", "Left error", false);
        row("Left", "Right", "", "Mean error", false);
        row("Left Z", "Right Z", "", "Right Z error", true);
        row("1", "2", "2", "E", true);
        row("1", "2", "", "error 2", false);
        row("A", "B", "", "B", false);
        row("A", "B", "", "Error B", false);
        row("A", "B", "", "B error", true);
        row("A", "B", "", "A error", false);
        row("", "Right", "Right", "E", true);
    }
    void theErrorsOfAnotherAxisOfTheDriveAreNotWritten()
    {
        QFETCH(QString, own);
        QFETCH(QString, other);
        QFETCH(QString, stated);
        QFETCH(QString, name);
        QFETCH(bool, isRefused);
        CompensatorFixture f({own.toStdString(), other.toStdString()});
        WriteRequest request = requestFor({}, "Position");
        request.table->name = name.toStdString();
        request.table->statedAxis = stated.toStdString();
        if (!isRefused) {
            VERIFY_RESULT(f.compensator.plan(0, request));
            return;
        }
        const auto refused = f.compensator.plan(0, request);
        VERIFY_ERROR(refused, ErrorCode::TargetMismatch);
        QVERIFY(names(refused.error(),
            own.isEmpty() ? "there is no name on the drive"
                          : "the name on the drive is " + own.toStdString()));
        request.table->target = "#1";
        VERIFY_RESULT(f.compensator.plan(0, request));
    }

    /// Only a name is a question to the drive.
    void namesOfAxesAreReadWhereAFileSaysOne()
    {
        CompensatorFixture f({"X1", "X2"});
        const auto exchangesWith = [&](const std::string& stated) {
            WriteRequest request = requestFor({}, "Position");
            request.table->statedAxis = stated;
            const int begin = f.link.exchanges();
            const auto plan = f.compensator.plan(0, request);
            return plan ? f.link.exchanges() - begin : -1;
        };
        static_cast<void>(exchangesWith("")); // the directory of the drive is read once
        const int silent = exchangesWith("");
        QVERIFY(silent > 0);
        QCOMPARE(exchangesWith("X1"), silent);
        QCOMPARE(exchangesWith("X3"), silent + 1);
    }

    /// A table of the drive no longer says what a person has said of its target.
    void whatAnAxisHadComesBackWhateverItIsCalled()
    {
        Stated f;
        const auto backup = f.written();
        VERIFY_RESULT(backup);
        const auto before = f.state();
        const auto there = f.compensator.planRestore(*backup, false);
        VERIFY_RESULT(there);
        QVERIFY(there->axes.front().changes.empty());
        VERIFY_RESULT(f.compensator.write(0, deletionRequest()));
        VERIFY_RESULT(f.compensator.planRestore(backup->axes.front(), false));
        VERIFY_RESULT(f.compensator.restore(*backup, false));
        QVERIFY(f.state() == before);
    }

    /// The index alone does not tell that it is the same axis.
    void aTableOfAnotherAxisIsNotRestoredToOneOfAnotherName()
    {
        Stated f({"X1", "X2"});
        auto backup = f.written();
        VERIFY_RESULT(backup);
        const auto before = f.state();
        backup->axes.front().axisName = "X2"; // as when the order of the axes has changed
        // The axis has all of it: there is nothing to be refused.
        VERIFY_RESULT(f.compensator.restore(*backup, false));
        QCOMPARE(f.link.firstChange(), 0);
        QVERIFY(f.state() == before);
        VERIFY_RESULT(f.compensator.write(0, deletionRequest()));
        const auto deleted = f.state();
        const auto refused = f.compensator.restore(*backup, true);
        VERIFY_ERROR(refused, ErrorCode::TargetMismatch);
        QVERIFY(names(refused.error(), "write the table to this axis from its file first"));
        QVERIFY(f.state() == deleted);
        backup->axes.front().axisName = "X1";
        VERIFY_RESULT(f.compensator.restore(*backup, false));
        QVERIFY(f.state() == before);
    }

    void aWriteWhoseTargetWasStatedCanBeFinished()
    {
        Stated whole;
        const int begin = whole.link.exchanges();
        VERIFY_RESULT(whole.compensator.write(0, whole.request));
        const int exchanges = whole.link.exchanges() - begin;
        int unfinished = 0;
        for (int exchange = 1; exchange <= exchanges; ++exchange) {
            Stated f;
            f.link.failAt(exchange, test::LinkFault::DriveGone);
            static_cast<void>(f.compensator.write(0, f.request));
            f.link.heal();
            const auto status = f.compensator.status(0);
            VERIFY_RESULT(status);
            if (!status->unfinishedWrite)
                continue;
            ++unfinished;
            const auto recovery = f.compensator.recovery(*status->unfinishedWrite);
            VERIFY_RESULT(recovery);
            QVERIFY(!recovery->finishObstacle);
            VERIFY_RESULT(f.compensator.finishUnfinished(*status->unfinishedWrite));
            QVERIFY(f.state() == whole.state());
        }
        QVERIFY(unfinished > 0);
    }

    void aNameThatMayBeThatOfTheAxisIsTaken_data()
    {
        QTest::addColumn<QString>("target");
        for (const char* target : {"", "X", "x", "X1", "Spindle", "1", "#1"})
            QTest::addRow("\"%s\"", target) << target;
    }
    void aNameThatMayBeThatOfTheAxisIsTaken()
    {
        QFETCH(const QString, target);
        CompensatorFixture f;
        const std::string name = target.toStdString();
        VERIFY_RESULT(f.compensator.write(0, requestFor(name, name)));
    }

    /// The same positions before and after the compensation are not the same places.
    void aTableForTheOtherSideOfTheCompensationIsNotWritten()
    {
        CompensatorFixture f;
        WriteRequest request = requestFor("X", "X");
        request.lookupAt = LookupAt::Set;
        const auto before = f.state();
        const auto refused = f.compensator.write(0, request);
        VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
        QVERIFY(names(refused.error(), "made for a position after the compensation"));
        QVERIFY(names(refused.error(), "from its measurement or the file of its controller"));
        QVERIFY(f.state() == before);
        request.sources = {"Axes[0]/Signals/PathPlanner/Position"};
        VERIFY_RESULT(f.compensator.write(0, request));
        // The source that the axis has is asked as well.
        request.sources.clear();
        request.lookupAt = LookupAt::Encoder;
        VERIFY_ERROR(f.compensator.write(0, request), ErrorCode::InvalidArgument);
    }

    void whereATableIsLookedUpIsAskedOfTheAxisItself()
    {
        CompensatorFixture f;
        WriteRequest request = test::exampleRequest();
        request.sources = {"Axes[0]/Signals/PathPlanner/Position", test::masterY};
        request.lookupAt = LookupAt::Encoder;
        VERIFY_ERROR(f.compensator.plan(0, request), ErrorCode::InvalidArgument);
        request.lookupAt = LookupAt::Set;
        const auto plan = f.compensator.plan(0, request);
        VERIFY_RESULT(plan);
        QCOMPARE(plan->lookupAt, std::optional(LookupAt::Set));
    }

    void aTableThatStaysForASourceOnTheOtherSideIsWarnedOf()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, requestFor("X", "X")));
        WriteRequest request;
        request.dimensionality = 1;
        const auto warns = [&](const std::string& source) {
            request.sources = {source};
            const auto plan = f.compensator.plan(0, request);
            return plan && std::ranges::any_of(plan->warnings, [](const Text& warning) {
                return warning.english().find("on the other side of the compensation")
                    != std::string::npos;
            });
        };
        QVERIFY(warns("Axes[0]/Signals/PathPlanner/Position"));
        QVERIFY(!warns("Axes[0]/Signals/Encoders[0]/Position"));
    }

    void aTableThatStaysForThePositionOfAnotherAxisIsWarnedOf()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, requestFor("X", "X")));
        WriteRequest request;
        request.dimensionality = 1;
        const auto warns = [&](const std::string& source) {
            request.sources = {source};
            const auto plan = f.compensator.plan(0, request);
            return plan && std::ranges::any_of(plan->warnings, [](const Text& warning) {
                return warning.english().find("is a position of another axis") != std::string::npos;
            });
        };
        QVERIFY(warns(test::masterY));
        QVERIFY(!warns("Axes[0]/Signals/Encoders[0]/Position"));
    }

    void aFileSaysForWhichSideItsTableWasMade_data()
    {
        QTest::addColumn<QByteArray>("notes"); // a line each
        QTest::addColumn<QByteArray>("said"); // empty: nothing; "?": refused
        const auto row = [](const char* name, const std::string& notes, const char* said) {
            QTest::newRow(name) << QByteArray::fromStdString(notes) << QByteArray(said);
        };
        row("nothing", "made of x.csv\nlook up: set", "");
        row("as fit writes it", "made of x.csv\n" + lookupNote(LookupAt::Set), "set");
        row("blanks and capitals", "  Lookup:  ENCODER ", "encoder");
        row("twice", "lookup: set\nlookup: set", "set");
        row("misspelt", "lookup: encodr", "?");
        row("no side", "lookup:", "?");
        row("both", "lookup: set\nlookup: encoder", "?");
    }
    void aFileSaysForWhichSideItsTableWasMade()
    {
        QFETCH(QByteArray, notes);
        QFETCH(QByteArray, said);
        std::vector<std::string> lines;
        for (const QByteArray& note : notes.split('\n'))
            lines.push_back(note.toStdString());
        const auto found = lookupInNotes(lines);
        QCOMPARE(found.has_value(), said != "?");
        if (!found)
            QVERIFY(names(found.error(), "correct that line, or leave it out"));
        else
            QCOMPARE(std::string(*found ? lookupAtName(**found) : ""), said.toStdString());
    }

    void aFileSaysWhichDriveWasMeasured_data()
    {
        QTest::addColumn<QByteArray>("notes"); // a line each
        QTest::addColumn<int>("said"); // 0: nothing; -1: refused
        const auto row = [](const char* name, const std::string& notes, int said) {
            QTest::newRow(name) << QByteArray::fromStdString(notes) << said;
        };
        row("nothing", "made of x.csv\nthe drive: serial number 7", 0);
        row("as fit writes it", "made of x.csv\n" + driveNote("Mill, serial number 7"), 7);
        row("without a name", "  Drive:serial number 7 ", 7);
        row("a name alone", "drive: Mill", 0);
        row("no number", "drive: Mill, serial number 7a", 0);
        row("of another controller", "drive: E 7, commutated", 0);
        row("behind a spreadsheet", "drive: Mill, serial number 7,,", 7);
        row("with another name", "drive: Mill, serial number 7\ndrive: Lathe, serial number 7", 7);
        row("two", "drive: Mill, serial number 7\ndrive: Mill, serial number 8", -1);
    }
    void aFileSaysWhichDriveWasMeasured()
    {
        QFETCH(QByteArray, notes);
        QFETCH(int, said);
        std::vector<std::string> lines;
        for (const QByteArray& note : notes.split('\n'))
            lines.push_back(note.toStdString());
        const auto found = measuredDriveInNotes(lines);
        QCOMPARE(found.has_value(), said != -1);
        if (!found)
            QVERIFY(names(found.error(), "correct the wrong line, or leave it out"));
        else
            QCOMPARE(found->value_or(0), said);
    }

    /// The axis X of a twin machine has another error.
    void aTableIsNotWrittenToAnotherDriveThanTheOneThatWasMeasured()
    {
        CompensatorFixture f;
        WriteRequest request = test::exampleRequest();
        request.measuredDrive = 4712;
        const auto before = f.state();
        const auto refused = f.compensator.write(0, request);
        VERIFY_ERROR(refused, ErrorCode::OtherDrive);
        QVERIFY(names(refused.error(), "serial number 4712 was measured, and this one has 4711"));
        QVERIFY(names(refused.error(), "correct the line or remove it"));
        VERIFY_ERROR(f.compensator.plan(0, request), ErrorCode::OtherDrive);
        QVERIFY(f.state() == before);
        // Neither is it taken for one that is right, where the axis has it already.
        request.measuredDrive = 4711;
        VERIFY_RESULT(f.compensator.write(0, request));
        request.measuredDrive = 4712;
        VERIFY_ERROR(f.compensator.compare(0, request), ErrorCode::OtherDrive);
        request.table.reset(); // of the axis's own table nobody says it
        VERIFY_RESULT(f.compensator.compare(0, request));
    }

    void theErrorsOfOneSourceAreNotWrittenToTheAxisOfAnother()
    {
        CompensatorFixture f;
        WriteRequest request = test::exampleRequest();
        request.table->grid.axes[0].name = "A";
        request.table->grid.axes[1].name = "B";
        request.table->target = "#2";
        const auto refused = f.compensator.write(0, request);
        VERIFY_ERROR(refused, ErrorCode::TargetMismatch);
        QVERIFY(names(refused.error(), "dimension 1 is its own position"));
        request.table->target = otherAxis;
        VERIFY_ERROR(f.compensator.write(0, request), ErrorCode::TargetMismatch);
        request.table->target = "#1";
        VERIFY_RESULT(f.compensator.write(0, request));
    }

    void aTableThatWasConvertedForOtherSourcesIsReadAgain()
    {
        CompensatorFixture f;
        WriteRequest request = requestFor(std::string(otherAxis), "Position");
        request.table->isTargetOfDrive = true;
        const auto before = f.state();
        const auto refused = f.compensator.write(0, request);
        VERIFY_ERROR(refused, ErrorCode::TargetMismatch);
        QVERIFY(names(refused.error(), "file does not say what the values of"));
        QVERIFY(names(refused.error(), "read the file again with these sources"));
        QVERIFY(f.state() == before);
        // Nor is it one for sources that do not tell what the axis is; a person's word is.
        const DriveProfile& profile = drivecomm::genericProfile();
        const std::vector<std::string> sources{"Axes[0]/Signals/General/MotorTemperature"};
        VERIFY_ERROR(checkTarget(profile, 0, sources, *request.table), ErrorCode::TargetMismatch);
        request.table->isTargetOfDrive = false;
        VERIFY_RESULT(checkTarget(profile, 0, sources, *request.table));
    }
};

AXISCOMP_TEST(TestTargetOfTheTable)

} // namespace tst_targetofthetable

#include "tst_targetofthetable.moc"
