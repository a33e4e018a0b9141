// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/controller_fixture.h"
#include "tests/ui/support/page_fixture.h"
#include "tests/ui/support/window_test.h"
#include "ui/controller/setup_history.h"
#include "ui/controller/table_selection.h"

#include <QAction>
#include <QTest>

namespace tst_setuphistory {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageFixture;

namespace {

void undo()
{
    test::PageUser::press(Qt::Key_Z, Qt::ControlModifier);
}

void redo()
{
    test::PageUser::press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
}

} // namespace

/// Undo and redo of what the user changes on the page.
class TestSetupHistory : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void everyChangeOfAFieldIsUndoneAndDoneAgain()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        const auto onDrive = bench.state();
        const SetupModel& setup = bench.controller().setup();
        SetupHistory& history = bench.controller().history();
        std::vector<EditedSetup> states{setup.edited()};
        QVERIFY(history.undoText().isEmpty());
        bench.picked = bench.superData();
        QVERIFY(user.choose("dimensionalityField", QStringLiteral("2D")));
        QCOMPARE(history.undoText(), QStringLiteral("Dimensionality"));
        states.push_back(setup.edited());
        QVERIFY(user.click("openButton"));
        QTRY_COMPARE(history.undoText(), QStringLiteral("Compensation data"));
        states.push_back(setup.edited());
        const auto data = bench.controller().dataFile().data;
        QVERIFY(user.choose("tableField", QStringLiteral("second")));
        QCOMPARE(history.undoText(), QStringLiteral("Table"));
        states.push_back(setup.edited());
        QVERIFY(user.enter(
            "source1Field", QStringLiteral("Axes[0]/Signals/PositionController/MasterPosition")));
        QTRY_COMPARE(history.undoText(), QStringLiteral("Dim1 Source"));
        states.push_back(setup.edited());
        QVERIFY(user.click("persistencyField"));
        QCOMPARE(history.undoText(), QStringLiteral("Persistency"));
        states.push_back(setup.edited());
        QVERIFY(user.click("revertAllButton"));
        QCOMPARE(history.undoText(), QStringLiteral("Several fields"));
        QVERIFY(!setup.isDirty());

        for (std::size_t n = states.size(); n-- > 0;) {
            undo();
            QVERIFY2(setup.edited() == states[n], qPrintable(QString::number(n)));
        }
        QVERIFY(history.undoText().isEmpty());
        QVERIFY(!bench.controller().dataFile().data);
        undo(); // there is nothing more
        QVERIFY(setup.edited() == states[0]);
        for (std::size_t n = 1; n < states.size(); ++n) {
            redo();
            QVERIFY2(setup.edited() == states[n], qPrintable(QString::number(n)));
        }
        QCOMPARE(bench.controller().dataFile().data, data); // it was not read again
        redo();
        QVERIFY(!setup.isDirty());
        QVERIFY(history.redoText().isEmpty());
        QVERIFY(bench.state() == onDrive);
    }

    void aTableIsFoundByItsNameInAFileThatWasReadAgain()
    {
        const auto content = [](const QByteArray& first, const QByteArray& second) -> QByteArray {
            return "Pos X [mm];" + first + " [mm];" + second + " [mm];C1 [mm]\n"
                + "0;0.001;0.002;0.003\n10;0.001;0.002;0.003\n";
        };
        test::ControllerFixture bench;
        QVERIFY(bench.connect());
        bench.chooseMasterSources(1);
        bench->openData(bench.file(QStringLiteral("t.csv"), content("A1", "B1")));
        QVERIFY(bench.fileRead());
        const auto name = [&] {
            const auto table = bench->selectedTable();
            return table ? table->name : std::string();
        };
        bench->setup().setTable({0});
        const std::string first = name();
        QVERIFY(!first.empty());
        bench->setup().setTable({2});
        const std::string third = name();
        QVERIFY(third != first);
        static_cast<void>(bench.file(QStringLiteral("t.csv"), content("Other B1", "A1")));
        bench->readDataAgain();
        QVERIFY(bench.fileRead());
        QCOMPARE(name(), third);
        bench->history().undo();
        QCOMPARE(name(), first);
        bench->history().redo();
        QCOMPARE(name(), third);
    }

    /// It was being read when the dimensionality was noted.
    void aRefusedFileThatADimensionalityHasOpenedIsTakenBack()
    {
        using test::ControllerFixture;
        ControllerFixture bench;
        QVERIFY(bench.connect());
        const QString line =
            bench.file(QStringLiteral("line.csv"), "X [mm],E [mm]\n0,0.001\n10,0.002\n20,0.001\n");
        const QString plane =
            bench.file(QStringLiteral("2d.csv"), ControllerFixture::calibration2D(1));
        for (const QString& path : {line, plane}) {
            bench->openData(path);
            QVERIFY(bench.fileRead());
        }
        bench->setup().setDimensionality(2);
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->dataFile().path, plane);
        bench->history().undo();
        QCOMPARE(bench->dataFile().path, line);
        QVERIFY(!bench->dataFile().isReading);
        bench->history().undo();
        QCOMPARE(bench->dataFile().path, line);
        QVERIFY(!bench->dataFile().isReading);
        QCOMPARE(bench->setup().edited().dimensionality, 1);
        bench->history().redo();
        bench->history().redo();
        QCOMPARE(bench->dataFile().path, plane);
        QCOMPARE(bench->setup().edited().dimensionality, 2);
    }

    void afterAWriteAndWithAnotherAxisThereIsNothingToUndo()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        QVERIFY(bench.choose2D());
        QVERIFY(!bench.controller().history().undoText().isEmpty());
        QVERIFY(bench.write());
        QVERIFY(bench.controller().history().undoText().isEmpty());
        QVERIFY(user.click("persistencyField"));
        QVERIFY(!bench.controller().history().undoText().isEmpty());
        bench.controller().selectAxis(1);
        QTRY_VERIFY(bench.controller().status().has_value()
            && bench.controller().status()->axis.index == 1);
        QVERIFY(bench.controller().history().undoText().isEmpty());
        QVERIFY(bench.controller().history().redoText().isEmpty());
        QVERIFY(!user.the<QAction>("undoAction").isEnabled());
    }

    void aFieldThatIsBeingTypedInKeepsItsOwnUndo()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        QVERIFY(user.choose("dimensionalityField", QStringLiteral("2D")));
        QVERIFY(user.click("source1Field"));
        auto* field = user.the<QComboBox>("source1Field").lineEdit();
        const QString committed = field->text();
        test::PageUser::press(Qt::Key_End);
        test::PageUser::type(QStringLiteral("qq"));
        QVERIFY(field->text() != committed);
        undo();
        QCOMPARE(field->text(), committed);
        QCOMPARE(bench.controller().setup().edited().dimensionality, 2);
        test::PageUser::press(Qt::Key_Escape); // what was typed is given up
        undo();
        QTRY_COMPARE(bench.controller().setup().edited().dimensionality, 1);
    }

    void theMenuSaysWhatIsUndone()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        auto& entry = user.the<QAction>("undoAction");
        QVERIFY(!entry.isEnabled());
        QVERIFY(user.choose("dimensionalityField", QStringLiteral("3D")));
        QVERIFY(entry.isEnabled());
        QVERIFY2(entry.text().contains(QStringLiteral("Dimensionality")), qPrintable(entry.text()));
        entry.trigger();
        QCOMPARE(bench.controller().setup().edited().dimensionality, 1);
        QVERIFY(!entry.isEnabled());
        auto& again = user.the<QAction>("redoAction");
        QVERIFY(again.text().contains(QStringLiteral("Dimensionality")));
        again.trigger();
        QCOMPARE(bench.controller().setup().edited().dimensionality, 3);
    }

    void aFieldThatTheUserHasLeftAloneFollowsTheDriveAlsoWhenAnotherIsUndone()
    {
        SetupModel setup;
        const TableLayout layout = drivecomm::genericProfile().layout;
        WizardLog log;
        TableSelection tables(layout, setup, log);
        SetupHistory history(setup, tables);
        CompensationSetup baseline;
        setup.reset(baseline);
        setup.setPersistency(Persistency::Persistent);
        baseline.sources[0] = {0x2000, "Axes[1]/Signals/PositionController/MasterPosition"};
        setup.setBaseline(baseline); // somebody else
        history.undo();
        QCOMPARE(setup.edited().persistency, Persistency::Volatile);
        QVERIFY(setup.edited().sources[0] == baseline.sources[0]);
        QVERIFY(!setup.isDirty());
    }
};

AXISCOMP_WINDOW_TEST(TestSetupHistory)

} // namespace tst_setuphistory

#include "tst_setuphistory.moc"
