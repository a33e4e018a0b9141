// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/support/configuration_files.h"
#include "tests/ui/support/measurement_files.h"
#include "tests/ui/support/page_fixture.h"
#include "tests/ui/support/record_files.h"
#include "ui/page/page_tabs.h"

#include <QAction>
#include <QTabWidget>
#include <QTableView>

#include <functional>
#include <vector>

namespace axiscomp::test {

/// A state of the page that looks different from the others, and how a person gets there.
struct PageState {
    const char* name;
    std::function<bool(PageFixture&)> reach;
};

namespace page_states {

using drivecomm::FaultSpec;

inline bool firstStart(PageFixture& bench)
{
    return bench.user.isThere()
        && PageUser::waitFor([&] { return bench.controller().status().has_value(); });
}

inline bool unwritten(PageFixture& bench)
{
    return bench.open() && bench.choose2D();
}

inline bool preview(PageFixture& bench)
{
    return unwritten(bench) && bench.user.click("writeButton")
        && PageUser::waitFor([&] { return bench.user.sees("confirmWriteButton"); });
}

inline bool isWritten(PageFixture& bench)
{
    if (!unwritten(bench) || !bench.write())
        return false;
    const bool isWritten = !bench.controller().isOutcomeAnError();
    if (!isWritten)
        qInfo("not written: %s", qPrintable(bench.outcome()));
    return isWritten;
}

inline bool active(PageFixture& bench)
{
    return isWritten(bench) && bench.user.click("activateButton") && bench.idle();
}

/// As if the program had been killed before the last step of a write.
inline bool unfinishedWrite(PageFixture& bench)
{
    if (!isWritten(bench))
        return false;
    const CompensationSetup setup = bench.controller().setup().baseline();
    DriveStore store(std::filesystem::path(bench.folder.path().toStdString()) / "store");
    const std::string base = "Axes[0]/Parameters/Compensations/Axis/";
    JournalEntry entry{1559, 0, std::chrono::system_clock::now(), "save",
        store.backups(1559, 0).front(),
        {{base + "Table", setup.slot}, {base + "Dim1Source", setup.sources[1].address},
            {base + "Dim2Source", setup.sources[0].address},
            {base + "Dim3Source", std::uint32_t{0}}},
        setup.slot, setup.tableCrc, false};
    if (!store.openJournal(entry))
        return false;
    bench.controller().refresh();
    const bool isSeen = PageUser::waitFor([&] { return bench.user.sees("finishWriteButton"); });
    if (!isSeen)
        qInfo("the unfinished write is not shown: %s; %s", qPrintable(bench.outcome()),
            qPrintable(bench.user.hint()));
    return isSeen;
}

inline bool threeDimensions(PageFixture& bench)
{
    const std::string example = exampleCalibrationCsv(3);
    bench.picked = bench.file(QStringLiteral("volume.csv"), QByteArray::fromStdString(example));
    return bench.open() && bench.user.choose("dimensionalityField", QStringLiteral("3D"))
        && bench.user.click("openButton")
        && PageUser::waitFor([&] { return bench.user.sees("sliceIndex"); });
}

inline bool openBadFile(PageFixture& bench)
{
    bench.picked = bench.file(QStringLiteral("bad.csv"),
        "X [mm],Y [mm],table 1\n0,0,0.001\n10,0,0.0O2\n20,0,0.001\n0,10,nan\n10,10\n");
    return bench.user.click("openButton")
        && PageUser::waitFor([&] { return bench.user.sees("problems"); });
}

inline bool badFile(PageFixture& bench)
{
    return unwritten(bench) && openBadFile(bench);
}

inline bool fileChanged(PageFixture& bench)
{
    if (!unwritten(bench))
        return false;
    bench.picked = bench.file(QStringLiteral("super-1.csv"), "X,Y,first\n0,0,0\n");
    return PageUser::waitFor([&] { return bench.user.sees("readAgainButton"); });
}

inline bool connectionLost(PageFixture& bench)
{
    if (!unwritten(bench))
        return false;
    bench.served.stop();
    return PageUser::waitFor([&] { return bench.user.sees("connectionMessage"); });
}

inline bool leaveQuestion(PageFixture& bench)
{
    return unwritten(bench) && bench.user.choose("axisField", QStringLiteral("Y · "))
        && PageUser::waitFor([&] { return bench.user.sees("loseChangesButton"); });
}

inline bool closeQuestion(PageFixture& bench)
{
    return unwritten(bench) && !bench.window.close()
        && PageUser::waitFor([&] { return bench.user.sees("loseChangesButton"); });
}

/// Slow enough to be looked at: until the faults are cleared.
inline bool writing(PageFixture& bench)
{
    if (!preview(bench))
        return false;
    bench.served.faults.add({FaultSpec::Kind::Slow, 250, {}});
    return bench.user.click("confirmWriteButton")
        && PageUser::waitFor([&] { return bench.controller().isWriting(); });
}

inline bool closingWhileWriting(PageFixture& bench)
{
    return writing(bench) && !bench.window.close()
        && PageUser::waitFor([&] { return bench.user.sees("closeWhenDoneButton"); });
}

inline bool logShown(PageFixture& bench)
{
    return unwritten(bench) && bench.user.click("logButton")
        && PageUser::waitFor([&] { return bench.user.sees("logLines"); });
}

inline bool connections(PageFixture& bench)
{
    return bench.open() && bench.user.click("connectionsButton")
        && PageUser::waitFor([&] { return bench.user.sees("connectionsDialog"); });
}

/// An entry of a combo box, in whatever language.
inline bool chooseAt(PageFixture& bench, const char* combo, int index)
{
    return PageUser::waitFor([&] { return bench.user.the<QComboBox>(combo).count() > index; })
        && bench.user.choose(combo, bench.user.the<QComboBox>(combo).itemText(index));
}

/// Positions that the drive cannot have: a question by itself.
inline QString unevenFile(const PageFixture& bench)
{
    return bench.file(QStringLiteral("uneven.csv"),
        "X [mm],first [mm],second [mm]\n0,0,0\n10,0.001,-0.001\n15,0.004,-0.004\n"
        "30,0.002,-0.002\n40,0,0\n");
}

inline bool importDialog(PageFixture& bench)
{
    if (!bench.open())
        return false;
    bench.picked = unevenFile(bench);
    return bench.user.click("openButton")
        && PageUser::waitFor([&] { return bench.user.sees("importDialog"); })
        && chooseAt(bench, "gridField", 1);
}

/// Of a format with settings of every kind.
inline bool exportDialog(PageFixture& bench)
{
    if (!unwritten(bench))
        return false;
    bench.user.the<QAction>("exportAction").trigger();
    return PageUser::waitFor([&] { return bench.user.sees("exportDialog"); })
        && bench.user.choose("conversionFormat", QStringLiteral("kw.crosscomp2"));
}

/// From the menu, with a configuration whose one station is another drive.
inline bool configurationDialog(PageFixture& bench, const char* action, const char* dialog)
{
    if (!isWritten(bench))
        return false;
    bench.picked =
        bench.file(QStringLiteral("other.TAMcfg"), tamConfiguration({{"Gantry", 2207, {{}, {}}}}));
    bench.user.the<QAction>(action).trigger();
    return PageUser::waitFor([&] { return bench.user.sees(dialog); })
        && bench.user.choose("stationField", QStringLiteral("Gantry"))
        && PageUser::waitFor([&] { return bench.user.sees("acceptOtherStation"); });
}

inline bool importConfiguration(PageFixture& bench)
{
    return configurationDialog(bench, "importConfigurationAction", "importConfigurationDialog")
        && bench.user.click("acceptOtherStation")
        && PageUser::waitFor([&] { return bench.user.the("writeSeveralButton").isEnabled(); });
}

inline bool exportConfiguration(PageFixture& bench)
{
    return configurationDialog(bench, "exportConfigurationAction", "exportConfigurationDialog")
        && bench.user.click("acceptOtherStation")
        && PageUser::waitFor([&] { return bench.user.the("saveConfigurationButton").isEnabled(); });
}

/// The tab Measure with a file that can be used and one that cannot.
inline bool planDialog(PageFixture& bench)
{
    if (!bench.open())
        return false;
    bench.user.the<ui::PageTabs>("pageTabs").setCurrentIndex(ui::PageTabs::Measure);
    return bench.user.click("newProgram")
        && PageUser::waitFor([&] { return bench.user.the("savePlanButton").isEnabled(); });
}

inline bool captureDialog(PageFixture& bench)
{
    if (!bench.open())
        return false;
    bench.user.the<ui::PageTabs>("pageTabs").setCurrentIndex(ui::PageTabs::Measure);
    return bench.user.click("captureValues") && bench.user.sees("captureDialog");
}

inline bool measure(PageFixture& bench)
{
    if (!bench.user.isThere())
        return false;
    bench.user.the<ui::PageTabs>("pageTabs").setCurrentIndex(ui::PageTabs::Measure);
    bench.picked = publicMeasurement("b02_x");
    if (!bench.user.click("addMeasurement"))
        return false;
    bench.picked = bench.file(QStringLiteral("other.csv"),
        "target [mm],direction,run,deviation [um]\n0,+,1,0.2\n1,sideways,1,0.3\n");
    return bench.user.click("addMeasurement") && PageUser::waitFor([&] {
        const auto* page = bench.user.find("measurePage");
        const auto* problems = page->findChild<QWidget*>(QStringLiteral("problems"));
        return problems && problems->isVisible();
    });
}

/// The tab Judge with a measurement that has outliers, one of them excluded, and a tolerance.
inline bool judge(PageFixture& bench)
{
    if (!bench.user.isThere())
        return false;
    auto& tabs = bench.user.the<ui::PageTabs>("pageTabs");
    tabs.setCurrentIndex(ui::PageTabs::Measure);
    bench.picked = publicMeasurement("ess_mcu1025");
    if (!bench.user.click("addMeasurement"))
        return false;
    tabs.setCurrentIndex(ui::PageTabs::Judge);
    const auto& outliers = bench.user.the<QTableView>("outliers");
    if (!PageUser::waitFor([&] { return outliers.model()->rowCount() == 2; }))
        return false;
    bench.user.the<QTableView>("outliers").setCurrentIndex(outliers.model()->index(0, 0));
    return bench.user.click("excludeSelected")
        && bench.user.enter("toleranceA", QStringLiteral("10"))
        && PageUser::waitFor([&] { return bench.user.the("showAllValues").isEnabled(); });
}

/// The tab Prove with a second measurement that does not say which table was active.
inline bool prove(PageFixture& bench)
{
    if (!bench.user.isThere())
        return false;
    bench.wizard.openRecord(bench.file(
        QStringLiteral("spindle-x.axcal"), QByteArray::fromStdString(recordText(recordOfFit()))));
    bench.user.the<QTabBar>("pageTabs").setCurrentIndex(ui::PageTabs::Prove);
    bench.picked = bench.file(QStringLiteral("after.csv"), goodAfterMeasurement({}));
    return PageUser::waitFor([&] {
        return bench.user.the<QLabel>("recordName").text() == QStringLiteral("spindle-x.axcal");
    }) && bench.user.click("afterAddMeasurement")
        && PageUser::waitFor([&] { return bench.user.sees("tableStated"); });
}

/// The same, kept in the record.
inline bool proved(PageFixture& bench)
{
    return prove(bench) && bench.user.click("tableStated") && bench.user.click("keepAfter")
        && PageUser::waitFor([&] {
               return bench.user.the<QLabel>("recordName").text().endsWith(u'*')
                   && !bench.user.the("keepAfter").isEnabled();
           });
}

/// The question before a window is closed whose record is not saved.
inline bool closeUnsaved(PageFixture& bench)
{
    return proved(bench) && !bench.window.close()
        && PageUser::waitFor([&] { return bench.user.sees("saveAndCloseButton"); });
}

/// The tab Fit with a measurement and all that is asked for answered; points: of a plane.
inline bool fit(PageFixture& bench, const QString& path)
{
    if (!bench.user.isThere())
        return false;
    auto& tabs = bench.user.the<ui::PageTabs>("pageTabs");
    tabs.setCurrentIndex(ui::PageTabs::Measure);
    bench.picked = path;
    if (!bench.user.click("addMeasurement"))
        return false;
    tabs.setCurrentIndex(ui::PageTabs::Fit);
    auto& lookup = bench.user.the<QComboBox>("fitLookup");
    if (!PageUser::waitFor([&] { return lookup.isEnabled() && lookup.isVisible(); }))
        return false;
    lookup.setCurrentIndex(1);
    Q_EMIT lookup.activated(1);
    return PageUser::waitFor([&] { return bench.user.the("saveFittedTable").isEnabled(); });
}
inline bool fitCurve(PageFixture& bench)
{
    return fit(bench,
        bench.file(QStringLiteral("off.csv"),
            "// compensation: off\ntarget [mm],direction,run,deviation [um]\n"
            "0,+,1,1\n10,+,1,2\n20,+,1,4\n30,+,1,3\n0,-,1,1\n10,-,1,2\n20,-,1,4\n30,-,1,3\n"));
}
inline bool fitMap(PageFixture& bench)
{
    QByteArray text = "// compensation: off\nX [mm],Y [mm],dX [um],dY [um]\n";
    for (int y = 0; y <= 30; y += 5)
        for (int x = 0; x <= 40; x += 5)
            text += QByteArray::number(x) + ',' + QByteArray::number(y) + ','
                + QByteArray::number(0.1 * x) + ',' + QByteArray::number(-0.2 * y) + '\n';
    return fit(bench, bench.file(QStringLiteral("plane.csv"), text));
}

} // namespace page_states

inline const std::vector<PageState>& allPageStates()
{
    using namespace page_states;
    static const std::vector<PageState> all{
        {"first start", firstStart},
        {"unwritten", unwritten},
        {"preview", preview},
        {"written", isWritten},
        {"active", active},
        {"unfinished write", unfinishedWrite},
        {"three dimensions", threeDimensions},
        {"bad file", badFile},
        {"file changed", fileChanged},
        {"connection lost", connectionLost},
        {"leave question", leaveQuestion},
        {"close question", closeQuestion},
        {"writing", writing},
        {"closing while writing", closingWhileWriting},
        {"log shown", logShown},
        {"connections", connections},
        {"import dialog", importDialog},
        {"export dialog", exportDialog},
        {"import configuration", importConfiguration},
        {"export configuration", exportConfiguration},
        {"measure", measure},
        {"judge", judge},
        {"prove", prove},
        {"proved", proved},
        {"close unsaved", closeUnsaved},
        {"fit", fitCurve},
        {"fit map", fitMap},
        {"plan dialog", planDialog},
        {"capture dialog", captureDialog},
    };
    return all;
}

/// The window that has the keyboard in a state: the page's, or its dialog.
inline QWidget& shownWindow(PageFixture& bench)
{
    for (const char* name :
        {"connectionsDialog", "importDialog", "exportDialog", "importConfigurationDialog",
            "exportConfigurationDialog", "planDialog", "captureDialog"}) {
        auto* dialog = bench.user.find(name);
        if (dialog && dialog->isVisible())
            return *dialog;
    }
    return bench.window;
}

} // namespace axiscomp::test
