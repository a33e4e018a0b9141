// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/scene_states.h"

#include "core/capture/run_file.h"
#include "core/metrology/fit/measurement_fit.h"
#include "tests/ui/support/configuration_files.h"
#include "tests/ui/support/measurement_files.h"
#include "tests/ui/support/record_files.h"
#include "ui/controller/machine_controller.h"
#include "ui/page/page_tabs.h"
#include "ui/plot/surface_view.h"

#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QTableView>
#include <QTreeView>
#include <QTreeWidget>

#include <algorithm>
#include <cmath>

namespace axiscomp::test {

using namespace axiscomp::ui;

namespace {

void firstStart(PageScene& scene)
{
    scene.showDrive(true);
    scene.settle();
}

void unwritten2D(PageScene& scene)
{
    scene.choose2D();
    scene.settle();
}

void writePreview(PageScene& scene)
{
    unwritten2D(scene);
    scene.click("writeButton");
    wait(
        [&] {
            return scene.page().findChild<QWidget*>(QStringLiteral("writePreview"))->isVisible();
        },
        "the list");
    scene.settle();
}

void showPreview(PageScene& scene)
{
    scene.click("writeButton");
    wait(
        [&] {
            return scene.page().findChild<QWidget*>(QStringLiteral("pictureAfter"))->isVisible();
        },
        "the pictures");
    scene.settle();
}

/// A volatile table over a persistent one.
void previewWarning(PageScene& scene)
{
    scene.choose2D();
    scene.write();
    scene.openData(scene.stage().superData(5));
    scene.controller().setup().setTable({1});
    scene.controller().setup().setPersistency(Persistency::Volatile);
    showPreview(scene);
}

void showDialog(PageScene& scene, const char* action, const char* dialog)
{
    scene.page().findChild<QAction*>(QLatin1StringView(action))->trigger();
    wait([&] { return scene.page().findChild<QDialog*>(QLatin1StringView(dialog)); }, dialog);
    QTest::qWait(600);
}

void active(PageScene& scene)
{
    scene.choose2D();
    scene.write();
    scene.click("activateButton");
    wait([&] { return scene.controller().proof().has_value(); }, "the proof");
    scene.settle();
}

/// The other drive of the connections does not answer.
void overview(PageScene& scene)
{
    active(scene);
    scene.controller().setEndpoints({PageStage::endpoint(), QStringLiteral("http://127.0.0.1:9")});
    wait(
        [&] {
            return scene.controller().drives().back().connection == DriveState::Connection::Lost;
        },
        "the drive that does not answer");
    showDialog(scene, "overviewAction", "overviewDialog");
}

/// Of two axes and a drive that does not answer; one axis is as the file says.
QString machineFile(PageScene& scene, bool hasMissing)
{
    static_cast<void>(
        scene.stage().file(QStringLiteral("y.csv"), "X [mm],Y error [um]\n0,0\n20,2.1\n40,-1\n"));
    const QByteArray source =
        "[\"" + QByteArray::fromStdString(PageStage::masterPosition(0)) + "\"]\n";
    QByteArray text = "version = 1\nname = \"Milling machine 7\"\n[[drive]]\nendpoint = \""
        + PageStage::endpoint().toUtf8()
        + "\"\nserial = 1559\n[[drive.axis]]\naxis = \"X\"\nno-table = true\n"
          "[[drive.axis]]\naxis = \"Y\"\nfile = \"y.csv\"\npersistent = true\nactive = true\n"
          "sources = "
        + source;
    if (hasMissing)
        text += "[[drive]]\nendpoint = \"http://127.0.0.1:9\"\nserial = 1560\n[[drive.axis]]\n"
                "axis = \"Z\"\nfile = \"y.csv\"\nsources = "
            + source;
    return scene.stage().file(QStringLiteral("machine.toml"), text);
}

void openMachineFile(PageScene& scene, bool hasMissing)
{
    scene.showDrive();
    scene.page().setFilePicker(
        [file = machineFile(scene, hasMissing)](QWidget&, const FileQuestion&,
            const std::function<void(const QString&)>& answer) { answer(file); });
    showDialog(scene, "openMachineAction", "overviewDialog");
    const MachineController& machine = scene.controller().machine();
    wait(
        [&] {
            return machine.file() && !machine.isAsking()
                && std::ranges::all_of(machine.drives(),
                    [](const MachineDriveState& drive) { return drive.look != nullptr; });
        },
        "the comparison");
}

void machineDrift(PageScene& scene)
{
    openMachineFile(scene, true);
    scene.page().findChild<QTableView*>(QStringLiteral("overview"))->selectRow(1);
    QTest::qWait(300);
}

void machineMistakes(PageScene& scene)
{
    scene.showDrive();
    const QString file = scene.stage().file(QStringLiteral("machine.toml"),
        "version = 1\n[[drive]]\nendpoint = \"http://192.168.1.20\"\nserial = 1559\n"
        "[[drive.axis]]\naxis = \"X\"\nfyle = \"x.csv\"\npersistant = true\n");
    scene.page().setFilePicker(
        [file](QWidget&, const FileQuestion&, const std::function<void(const QString&)>& answer) {
            answer(file);
        });
    showDialog(scene, "openMachineAction", "overviewDialog");
    QTest::qWait(300);
}

void applyMachine(PageScene& scene)
{
    openMachineFile(scene, false);
    scene.page().findChild<QDialog*>(QStringLiteral("overviewDialog"))->close();
    showDialog(scene, "applyMachineAction", "applyMachineDialog");
    wait(
        [&] {
            return scene.page().findChild<QPushButton*>(QStringLiteral("applyButton"))->isEnabled();
        },
        "the plans");
}

/// Nothing is written while one drive does not answer.
void applyMachineMissing(PageScene& scene)
{
    openMachineFile(scene, true);
    scene.page().findChild<QDialog*>(QStringLiteral("overviewDialog"))->close();
    showDialog(scene, "applyMachineAction", "applyMachineDialog");
}

void appliedMachine(PageScene& scene)
{
    applyMachine(scene);
    scene.page().findChild<QPushButton*>(QStringLiteral("applyButton"))->click();
    wait(
        [&] {
            return scene.page().findChild<QPushButton*>(QStringLiteral("applyButton"))->isHidden();
        },
        "the end");
    QTest::qWait(300);
}

/// Where another file of this name is.
void saveMachine(PageScene& scene)
{
    openMachineFile(scene, false);
    scene.page().findChild<QDialog*>(QStringLiteral("overviewDialog"))->close();
    scene.page().setFilePicker(
        [folder = scene.stage().path(QString())](QWidget&, const FileQuestion&,
            const std::function<void(const QString&)>& answer) { answer(folder); });
    showDialog(scene, "saveMachineAction", "saveMachineDialog");
    scene.page().findChild<QPushButton*>(QStringLiteral("saveMachineButton"))->click();
    wait(
        [&] {
            return scene.page()
                .findChild<QPushButton*>(QStringLiteral("replaceMachineButton"))
                ->isVisible();
        },
        "the question");
}

void backups(PageScene& scene)
{
    previewWarning(scene);
    scene.click("confirmWriteButton");
    scene.settle();
    showDialog(scene, "backupsAction", "backupDialog");
    auto* list = scene.page().findChild<QTreeWidget*>(QStringLiteral("backups"));
    list->setCurrentItem(list->topLevelItem(0));
    QTest::qWait(300);
}

void guide(PageScene& scene)
{
    unwritten2D(scene);
    showDialog(scene, "guideAction", "guideWindow");
}

/// Micrometres for an axis in millimetres, more of them than are likely.
void largeCorrections(PageScene& scene)
{
    scene.choose2D();
    scene.openData(scene.stage().file(QStringLiteral("errors.csv"),
        "X [mm],Y [mm],X error [um]\n0,0,0\n40,0,800\n0,30,-20\n40,30,10\n"));
    scene.controller().setup().setTable({0});
    scene.settle();
    scene.click("writeButton");
    wait(
        [&] {
            return scene.page().findChild<QWidget*>(QStringLiteral("writePreview"))->isVisible();
        },
        "the list");
    scene.settle();
}

/// Angles for an axis in millimetres.
void refusedAngle(PageScene& scene)
{
    scene.choose2D();
    scene.openData(scene.stage().file(QStringLiteral("angles.csv"),
        "X [mm],Y [mm],X error [arcsec]\n0,0,0\n40,0,8\n0,30,-20\n40,30,10\n"));
    scene.controller().setup().setTable({0});
    scene.settle();
    scene.click("writeButton");
    wait([&] { return scene.controller().isOutcomeAnError(); }, "the refusal");
    scene.settle();
}

/// The corners of a round bed were not probed.
QByteArray roundBed()
{
    QByteArray text = "X [mm],Y [mm],X error [um]\n";
    for (int y = -60; y <= 60; y += 10)
        for (int x = -60; x <= 60; x += 10)
            if (x * x + y * y <= 65 * 65)
                text += QByteArray::number(x) + ',' + QByteArray::number(y) + ','
                    + QByteArray::number(0.004 * x * x - 0.05 * y + 3.0 * std::cos(y / 20.0))
                    + '\n';
    return text;
}

void incompleteBed(PageScene& scene)
{
    scene.showDrive();
    scene.controller().setup().setDimensionality(2);
    scene.chooseSources(2);
    scene.page().openData(scene.stage().file(QStringLiteral("bed.csv"), roundBed()));
    wait([&] { return scene.page().findChild<QDialog*>(QStringLiteral("importDialog")); },
        "the dialog");
    QTest::qWait(300);
}

void filledBed(PageScene& scene)
{
    incompleteBed(scene);
    scene.page()
        .findChild<QComboBox*>(QStringLiteral("missingField"))
        ->setCurrentIndex(static_cast<int>(MissingPoints::Smooth));
    const auto* accept = scene.page().findChild<QPushButton*>(QStringLiteral("acceptConversion"));
    wait([&] { return accept->isEnabled(); }, "the report");
    scene.click("acceptConversion");
    wait([&] { return scene.controller().dataFile().data != nullptr; }, "the data");
    scene.controller().setup().setTable({0});
    scene.page().findChild<QTabWidget*>(QStringLiteral("previewTabs"))->setCurrentIndex(0);
    scene.settle();
}

void writing(PageScene& scene)
{
    unwritten2D(scene);
    scene.stage().gate().holdUploads();
    scene.click("writeButton");
    scene.click("confirmWriteButton");
    wait([&] { return scene.controller().isWriting() && scene.controller().busy().fraction > 0.1; },
        "the upload");
    QTest::qWait(150);
}

void closingWhileWriting(PageScene& scene)
{
    writing(scene);
    static_cast<void>(scene.page().mayClose());
    QTest::qWait(50);
}

void badFile(PageScene& scene)
{
    scene.showDrive();
    scene.controller().setup().setDimensionality(2);
    scene.chooseSources(2);
    scene.openData(scene.stage().file(QStringLiteral("measurement.csv"),
        "X [mm],Y [mm],table "
        "1\n0,0,0.001\n10,0,0.0O2\n20,0,0.001\n0,10,nan\n10,10\n20,10,0.002\n"));
    scene.settle();
}

void badFileLines(PageScene& scene)
{
    badFile(scene);
    auto* problems = scene.page().findChild<QTreeView*>(QStringLiteral("problems"));
    problems->setCurrentIndex(problems->model()->index(0, 0));
    Q_EMIT problems->activated(problems->currentIndex());
    scene.settle();
}

void table3D(PageScene& scene)
{
    scene.showDrive();
    scene.controller().setup().setDimensionality(3);
    scene.chooseSources(3);
    const std::string example = exampleCalibrationCsv(3);
    scene.openData(scene.stage().file(
        QStringLiteral("volume.csv"), QByteArray(example.data(), qsizetype(example.size()))));
    scene.controller().setup().setTable({0});
    scene.settle();
}

void preview3D(PageScene& scene)
{
    table3D(scene);
    showPreview(scene);
}

/// Everything that can be drawn over a map, and its cross-sections.
void mapDetails(PageScene& scene)
{
    scene.choose2D();
    for (const char* name : {"plotPoints", "plotContours", "plotSections"})
        scene.page().findChild<QAction*>(QLatin1StringView(name))->setChecked(true);
    QTest::qWait(200);
    scene.settle();
}

void showSurface(PageScene& scene)
{
    auto* tabs = scene.page().findChild<QTabWidget*>(QStringLiteral("previewTabs"));
    auto* view = scene.page().findChild<SurfaceView*>(QStringLiteral("surfaceView"));
    tabs->setCurrentWidget(view);
    wait([&] { return view->isWhole(); }, "the surface");
    scene.settle();
}

void surface2D(PageScene& scene)
{
    scene.choose2D();
    showSurface(scene);
}

void showTab(PageScene& scene, const char* name)
{
    auto* tabs = scene.page().findChild<QTabWidget*>(QStringLiteral("previewTabs"));
    tabs->setCurrentWidget(scene.page().findChild<QWidget*>(QLatin1StringView(name)));
    QTest::qWait(400);
    scene.settle();
}

/// The errors of both axes of a plane, as a gantry has them.
void twoAxes(PageScene& scene)
{
    scene.choose2D();
    QByteArray text = "X [mm],Y [mm],X error [um],Y error [um]\n";
    for (int y = 0; y <= 30; y += 3)
        for (int x = 0; x <= 40; x += 4)
            text += QByteArray::number(x) + ',' + QByteArray::number(y) + ','
                + QByteArray::number(2.1 * std::sin(x / 6.0) + 0.05 * y, 'f', 3) + ','
                + QByteArray::number(0.002 * x * x - 1.2 * std::cos(y / 8.0), 'f', 3) + '\n';
    scene.openData(scene.stage().file(QStringLiteral("plane-errors.csv"), text));
    scene.controller().setup().setTable({0});
    showTab(scene, "vectorView");
}

void allSlices(PageScene& scene)
{
    scene.showDrive();
    scene.controller().setup().setDimensionality(3);
    scene.chooseSources(3);
    QByteArray text = "X [mm],Y [mm],T [degC],X error [um]\n";
    for (int t = 18; t <= 30; ++t)
        for (int y = 0; y <= 30; y += 3)
            for (int x = 0; x <= 40; x += 4)
                text += QByteArray::number(x) + ',' + QByteArray::number(y) + ','
                    + QByteArray::number(t) + ','
                    + QByteArray::number(
                        2.1 * std::sin(x / 6.0) + 0.01 * x * (t - 22) + 0.05 * y, 'f', 3)
                    + '\n';
    scene.openData(scene.stage().file(QStringLiteral("heat.csv"), text));
    scene.controller().setup().setTable({0});
    showTab(scene, "sliceGallery");
}

/// The demo drive says how far its axes travel: 0 to 300 and 0 to 200.
void travel1D(PageScene& scene)
{
    scene.showDrive(true);
    scene.controller().setup().setDimensionality(1);
    scene.controller().chooseSource(1, QString::fromStdString(PageStage::masterPosition(0)));
    wait([&] { return scene.controller().setup().edited().sources[0].isSet(); }, "the source");
    scene.openData(scene.stage().file(QStringLiteral("short.csv"),
        "X [mm],X error [um]\n40,1.2\n80,2.4\n120,1.9\n160,0.4\n200,-0.8\n240,-1.5\n"));
    scene.controller().setup().setTable({0});
    scene.settle();
}

void travel2D(PageScene& scene)
{
    scene.showDrive(true);
    scene.controller().setup().setDimensionality(2);
    for (int n = 0; n < 2; ++n) {
        scene.controller().chooseSource(
            n + 1, QString::fromStdString(PageStage::masterPosition(n)));
        wait(
            [&] {
                return scene.controller()
                    .setup()
                    .edited()
                    .sources.at(static_cast<std::size_t>(n))
                    .isSet();
            },
            "a source");
    }
    QByteArray text = "X [mm],Y [mm],X error [um]\n";
    for (int y = 40; y <= 160; y += 10)
        for (int x = 40; x <= 260; x += 10)
            text += QByteArray::number(x) + ',' + QByteArray::number(y) + ','
                + QByteArray::number(2.1 * std::sin(x / 40.0) + 0.01 * y, 'f', 3) + '\n';
    scene.openData(scene.stage().file(QStringLiteral("small.csv"), text));
    scene.controller().setup().setTable({0});
    scene.settle();
}

void showValues(PageScene& scene, int row, int column)
{
    scene.page().findChild<QTabWidget*>(QStringLiteral("previewTabs"))->setCurrentIndex(1);
    auto* values = scene.page().findChild<QTableView*>(QStringLiteral("values"));
    values->setCurrentIndex(values->model()->index(row, column));
    scene.settle();
}

void values2D(PageScene& scene)
{
    scene.choose2D();
    showValues(scene, 5, 2);
}

void surface3D(PageScene& scene)
{
    table3D(scene);
    showSurface(scene);
}

void values3D(PageScene& scene)
{
    table3D(scene);
    showValues(scene, 1, 1);
}

/// Table 1 is on the drive, table 2 is chosen.
void difference(PageScene& scene)
{
    scene.choose2D();
    scene.write();
    scene.controller().setup().setTable({1});
    Q_EMIT scene.page().findChild<QComboBox*>(QStringLiteral("plotContent"))->activated(2);
    scene.page().findChild<QAbstractButton*>(QStringLiteral("plotCursors"))->setChecked(true);
    scene.settle();
}

void curve1D(PageScene& scene)
{
    scene.showDrive();
    scene.chooseSources(1);
    const std::string example = exampleCalibrationCsv(1);
    scene.openData(scene.stage().file(
        QStringLiteral("line.csv"), QByteArray(example.data(), qsizetype(example.size()))));
    scene.write();
    scene.controller().setup().setTable({1});
    scene.settle();
}

void preview1D(PageScene& scene)
{
    curve1D(scene);
    showPreview(scene);
}

void curve1DValues(PageScene& scene)
{
    curve1D(scene);
    showValues(scene, 4, 1);
}

void driveRefuses(PageScene& scene)
{
    scene.choose2D();
    scene.stage().gate().refuseUploads(Error{
        ErrorCode::TableRefused, {{"reason", Verbatim{"Crc does not match the elements"}}}, {}});
    scene.click("writeButton");
    scene.click("confirmWriteButton");
    wait([&] { return scene.controller().isOutcomeAnError(); }, "the refusal");
    scene.settle();
}

void flashWear(PageScene& scene)
{
    scene.choose2D();
    for (int n = 0; scene.controller().flashOperationsLeft() > 0 && n < 20; ++n) {
        scene.controller().setup().setTable({n % 2});
        if (n > 1) // the same two tables again would cost nothing
            scene.openData(scene.stage().superData(n));
        scene.controller().setup().setTable({n % 2});
        scene.write();
    }
    scene.controller().setup().setTable({1});
    scene.controller().setup().setPersistency(Persistency::Persistent);
    scene.settle();
}

/// As if the program had been killed before its last step.
void unfinishedWrite(PageScene& scene)
{
    scene.choose2D();
    scene.write();
    const CompensationSetup setup = scene.controller().setup().baseline();
    DriveStore store(scene.stage().options().storeRoot);
    const std::string base = "Axes[0]/Parameters/Compensations/Axis/";
    JournalEntry entry{1559, 0, std::chrono::system_clock::now(), "switch",
        store.backups(1559, 0).front(),
        {{base + "Table", setup.slot}, {base + "Dim1Source", setup.sources[0].address},
            {base + "Dim2Source", setup.sources[1].address},
            {base + "Dim3Source", std::uint32_t{0}}},
        setup.slot, setup.tableCrc, true};
    if (!store.openJournal(entry))
        qFatal("the journal cannot be kept");
    scene.controller().refresh();
    wait([&] { return !scene.controller().unfinishedWrite().isEmpty(); }, "the unfinished write");
    scene.settle();
}

void notHomed(PageScene& scene)
{
    scene.choose2D(Persistency::Volatile);
    scene.write();
    scene.settle();
}

void connectionLost(PageScene& scene)
{
    unwritten2D(scene);
    scene.stage().gate().set(DriveGate::Mode::Gone);
    wait(
        [&] {
            return scene.controller().drives().front().connection == DriveState::Connection::Lost;
        },
        "the loss");
    QTest::qWait(100);
}

/// An axis without sources, and a file whose columns are called X, Y and T: the last source is
/// wrong.
void proposedSources(PageScene& scene)
{
    scene.showDrive();
    scene.controller().setup().setDimensionality(3);
    QByteArray text = "X [mm],Z [mm],T [\302\260C],X error [mm]\n";
    for (int n = 0; n < 8; ++n)
        text += QByteArray::number(40 * (n & 1)) + ',' + QByteArray::number(15 * (n & 2)) + ','
            + QByteArray::number(20 + 5 * (n & 4) / 4) + ",0.00" + QByteArray::number(n) + '\n';
    scene.openData(scene.stage().file(QStringLiteral("warm.csv"), text));
    scene.controller().chooseSource(2, QStringLiteral("Axes[0]/Signals/General/MotorTemperature"));
    scene.controller().chooseSource(3, QStringLiteral("Axes[0]/Nonsense"));
    wait([&] { return !scene.controller().sourceProblem(3).isEmpty(); }, "the refusal");
    scene.settle();
}

/// The second drive of the list does not answer, and is chosen.
void unreachableDrive(PageScene& scene)
{
    unwritten2D(scene);
    scene.controller().setEndpoints(
        {scene.controller().endpoints().front(), QStringLiteral("http://127.0.0.1:1")});
    wait(
        [&] {
            return scene.controller().drives().back().connection == DriveState::Connection::Lost;
        },
        "the drive that does not answer");
    auto* drives = scene.page().findChild<QComboBox*>(QStringLiteral("driveField"));
    drives->setCurrentIndex(1);
    Q_EMIT drives->activated(1);
    scene.settle();
}

/// A backup of a drive that this one replaces.
void restoreDrive(PageScene& scene)
{
    scene.choose2D();
    scene.write();
    const QString file = scene.stage().path(QStringLiteral("Gantry-1559.json"));
    scene.page().setFilePicker(
        [file](QWidget&, const FileQuestion&, const std::function<void(const QString&)>& answer) {
            answer(file);
        });
    scene.page().findChild<QAction*>(QStringLiteral("backUpDriveAction"))->trigger();
    scene.settle();
    scene.controller().setup().setTable({1});
    scene.write();
    scene.page().findChild<QAction*>(QStringLiteral("restoreDriveAction"))->trigger();
    auto* write = scene.page().findChild<QPushButton*>(QStringLiteral("writeSeveralButton"));
    wait([&] { return write->isEnabled(); }, "the plans");
    QTest::qWait(200);
}

void otherAxis(PageScene& scene)
{
    unwritten2D(scene);
    auto* axes = scene.page().findChild<QComboBox*>(QStringLiteral("axisField"));
    Q_EMIT axes->activated(1);
    scene.page().findChild<QAbstractButton*>(QStringLiteral("logButton"))->click();
    scene.settle();
}

void connections(PageScene& scene)
{
    unwritten2D(scene);
    scene.click("connectionsButton");
    auto* dialog = scene.page().findChild<QDialog*>(QStringLiteral("connectionsDialog"));
    dialog->findChild<QAbstractButton*>(QStringLiteral("addDemo"))->click();
    dialog->findChild<QLineEdit*>(QStringLiteral("connectionAddress"))
        ->setText(QStringLiteral("192.168.1.21/"));
    dialog->findChild<QAbstractButton*>(QStringLiteral("addConnection"))->click();
    auto* note = dialog->findChild<QLabel*>(QStringLiteral("connectionNote"));
    auto* list = dialog->findChild<QTreeWidget*>(QStringLiteral("connections"));
    wait([&] { return !list->topLevelItem(1)->text(1).isEmpty() && !note->text().isEmpty(); },
        "the answers");
    QTest::qWait(200);
}

void findDrives(PageScene& scene)
{
    unwritten2D(scene);
    scene.click("connectionsButton");
    scene.page().findChild<QAbstractButton*>(QStringLiteral("findDrives"))->click();
    auto* again = scene.page().findChild<QAbstractButton*>(QStringLiteral("searchAgain"));
    wait([&] { return again->isEnabled(); }, "the end of the search");
    QTest::qWait(200);
}

void choose(PageScene& scene, const char* combo, int index)
{
    scene.page().findChild<QComboBox*>(QLatin1StringView(combo))->setCurrentIndex(index);
}

/// An uneven file of two columns, brought onto a grid that is a little too coarse.
void importDialog(PageScene& scene)
{
    scene.showDrive();
    const QString file = scene.stage().file(QStringLiteral("uneven.csv"),
        "X [mm],first [mm],second [mm]\n0,0,0\n10,0.001,-0.001\n15,0.004,-0.004\n"
        "30,0.002,-0.002\n40,0,0\n");
    scene.page().openData(file);
    const auto* accept = [&] {
        wait([&] { return scene.page().findChild<QDialog*>(QStringLiteral("importDialog")); },
            "the dialog");
        return scene.page().findChild<QPushButton*>(QStringLiteral("acceptConversion"));
    }();
    QTest::qWait(150);
    choose(scene, "gridField", 2);
    scene.page()
        .findChild<QLineEdit*>(QStringLiteral("gridNumberField"))
        ->setText(QStringLiteral("10"));
    wait([&] { return accept->isEnabled(); }, "the report");
    QTest::qWait(150);
}

/// A compensation list of another controller in which a point is missing.
void damagedList(PageScene& scene)
{
    scene.showDrive();
    scene.openData(scene.stage().file(QStringLiteral("damaged.lis"),
        "kopf.achs_nr 1\nkw.crosscomp.unit 1\nkw.crosscomp.last_index 2\n"
        "kw.crosscomp.master_ax_nr 2\nkw.crosscomp.table[0].setpoint 0\n"
        "kw.crosscomp.table[0].correction 0\nkw.crosscomp.table[2].setpoint 20000\n"
        "kw.crosscomp.table[2].correction -15\nEnd\n"));
    scene.settle();
}

/// The same in the dialog.
void damagedImport(PageScene& scene)
{
    damagedList(scene);
    Q_EMIT scene.controller().importChoiceNeeded(scene.stage().path(QStringLiteral("damaged.lis")));
    wait([&] { return scene.page().findChild<QLabel*>(QStringLiteral("conversionReason")); },
        "the dialog");
    const auto* reason = scene.page().findChild<QLabel*>(QStringLiteral("conversionReason"));
    wait([&] { return reason->isVisible(); }, "the reason");
    QTest::qWait(150);
}

/// A format with settings, one of which is missing.
void exportDialog(PageScene& scene)
{
    curve1D(scene);
    scene.page().findChild<QAction*>(QStringLiteral("exportAction"))->trigger();
    wait([&] { return scene.page().findChild<QDialog*>(QStringLiteral("exportDialog")); },
        "the dialog");
    auto* format = scene.page().findChild<QComboBox*>(QStringLiteral("conversionFormat"));
    for (int i = 0; i < format->count(); ++i) {
        if (format->itemText(i).contains(QStringLiteral("RapidCode"))) {
            format->setCurrentIndex(i);
            break;
        }
    }
    const auto* reason = scene.page().findChild<QLabel*>(QStringLiteral("conversionReason"));
    wait([&] { return reason->isVisible(); }, "the reason");
    QTest::qWait(150);
}

/// X has a table already; the columns are proposed, and all is planned.
void multiAxisAxes(PageScene& scene)
{
    scene.choose2D();
    scene.write();
    QByteArray text = "X [mm],Y [mm],X error [mm],Y error [mm],Z error [mm]\n";
    for (int y = 0; y <= 30; y += 10) {
        for (int x = 0; x <= 40; x += 10)
            text += QByteArray::number(x) + ',' + QByteArray::number(y) + ",0.00"
                + QByteArray::number(x / 10) + ",-0.00" + QByteArray::number(y / 10) + ",0.0125\n";
    }
    scene.openData(scene.stage().file(QStringLiteral("plane-errors.csv"), text));
    scene.settle();
    scene.page().findChild<QAction*>(QStringLiteral("writeSeveralAction"))->trigger();
    auto* write = scene.page().findChild<QPushButton*>(QStringLiteral("writeSeveralButton"));
    wait([&] { return write->isEnabled(); }, "the plans");
    QTest::qWait(200);
}

/// The drive has refused the first of the writes.
void multiAxisFailed(PageScene& scene)
{
    multiAxisAxes(scene);
    scene.stage().gate().refuseUploads(Error{
        ErrorCode::TableRefused, {{"reason", Verbatim{"Crc does not match the elements"}}}, {}});
    scene.click("writeSeveralButton");
    wait([&] { return scene.controller().isOutcomeAnError(); }, "the refusal");
    scene.settle();
}

/// The table of X was taken away; the configuration, whose station has another serial number, gives
/// it back.
void importConfiguration(PageScene& scene)
{
    scene.choose2D();
    scene.write();
    const QString file = scene.stage().file(QStringLiteral("machine.TAMcfg"),
        tamConfiguration({{"Gantry", 2207, {configuredAxis(scene.stage().drive(), 0)}},
            {"Rotary Table", 2208, {{}}}}));
    const std::string compensation = "Axes[0]/Parameters/Compensations/Axis/";
    const auto written =
        scene.stage().drive().writeRegisters({{compensation + "Table", std::string("Disabled")}});
    scene.controller().refresh();
    wait(
        [&] {
            const auto& status = scene.controller().status();
            return written && status && status->setup.slot.empty()
                && scene.controller().action(Action::ImportConfiguration).isEnabled;
        },
        "the axis without a table");
    scene.beginConfiguration(file, "importConfigurationAction");
    auto* write = scene.page().findChild<QPushButton*>(QStringLiteral("writeSeveralButton"));
    wait([&] { return write->isEnabled(); }, "the plan");
    QTest::qWait(200);
}

void exportConfiguration(PageScene& scene)
{
    scene.choose2D();
    scene.write();
    scene.beginConfiguration(
        scene.stage().file(QStringLiteral("machine.TAMcfg"),
            tamConfiguration({{"Gantry", 2207, {{}, {}}}, {"Rotary Table", 2208, {{}}}})),
        "exportConfigurationAction");
    auto* save = scene.page().findChild<QPushButton*>(QStringLiteral("saveConfigurationButton"));
    wait([&] { return save->isEnabled(); }, "the parameters");
    QTest::qWait(200);
}

void showPageTab(PageScene& scene, int tab)
{
    scene.showDrive();
    scene.page().findChild<QTabBar*>(QStringLiteral("pageTabs"))->setCurrentIndex(tab);
    QTest::qWait(100);
}

void addMeasurement(PageScene& scene, const QString& path, int count)
{
    scene.page().setFilePicker(
        [path](QWidget&, const ui::FileQuestion&,
            const std::function<void(const QString&)>& answer) { answer(path); });
    scene.click("addMeasurement");
    const auto* files = scene.page().findChild<QTableView*>(QStringLiteral("measurementFiles"));
    constexpr int stateColumn = 1;
    wait(
        [&] {
            const auto state = files->model()->index(count - 1, stateColumn);
            return files->model()->rowCount() == count && state.data(Qt::DecorationRole).isValid();
        },
        "the measurement");
    QTest::qWait(200);
}

void measureEmpty(PageScene& scene)
{
    showPageTab(scene, PageTabs::Measure);
}

void measureFiles(PageScene& scene)
{
    measureEmpty(scene);
    addMeasurement(scene, publicMeasurement("ess_mcu1025"), 1);
}

void measureColumns(PageScene& scene)
{
    measureEmpty(scene);
    addMeasurement(scene,
        scene.stage().file(QStringLiteral("laser-export.csv"),
            "Position [mm];Way;Lap;Measured error [um]\n0;+;1;0.4\n20;+;1;1.9\n40;+;1;2.2\n"
            "40;-;1;1.1\n20;-;1;0.8\n0;-;1;-0.6\n"),
        1);
    scene.page().findChild<QTabWidget*>(QStringLiteral("measureTabs"))->setCurrentIndex(1);
    QTest::qWait(200);
}

/// The roles of the file before are proposed.
void measureProposedColumns(PageScene& scene)
{
    measureColumns(scene);
    auto* role = scene.page().findChild<QComboBox*>(QStringLiteral("roleOfColumn1"));
    role->setCurrentIndex(role->findData(QStringLiteral("target")));
    Q_EMIT role->activated(role->currentIndex());
    role = scene.page().findChild<QComboBox*>(QStringLiteral("roleOfColumn4"));
    role->setCurrentIndex(role->findData(QStringLiteral("deviation")));
    Q_EMIT role->activated(role->currentIndex());
    QTest::qWait(200);
    addMeasurement(scene,
        scene.stage().file(QStringLiteral("laser-export-2.csv"),
            "Position [mm];Way;Lap;Measured error [um]\n0;+;1;0.3\n20;+;1;1.7\n40;+;1;2.3\n"),
        2);
    scene.page().findChild<QTabWidget*>(QStringLiteral("measureTabs"))->setCurrentIndex(1);
    QTest::qWait(200);
}

void planDialog(PageScene& scene)
{
    measureEmpty(scene);
    scene.click("newProgram");
    const auto* save = scene.page().findChild<QPushButton*>(QStringLiteral("savePlanButton"));
    wait([&] { return save->isEnabled(); }, "the plan");
    QTest::qWait(200);
}

void planMistake(PageScene& scene)
{
    planDialog(scene);
    scene.page().findChild<QDoubleSpinBox*>(QStringLiteral("toField"))->setValue(-3.5);
    QTest::qWait(200);
}

MeasuringPlan scenePlan()
{
    MeasuringPlanRequest request;
    request.to = 36.0;
    request.from = 2.0;
    request.count = 12;
    request.cycles = 3;
    request.overrun = 1.5;
    return makeMeasuringPlan(request).value();
}

void captureDialog(PageScene& scene)
{
    measureEmpty(scene);
    const std::string plan = measuringPlanCsv(scenePlan());
    const QString planFile = scene.stage().file(
        QStringLiteral("plan-X.csv"), QByteArray(plan.data(), static_cast<qsizetype>(plan.size())));
    const QString values = scene.stage().path(QStringLiteral("runs-X.csv"));
    scene.page().setFilePicker([planFile, values](QWidget&, const ui::FileQuestion& question,
                                   const std::function<void(const QString&)>& answer) {
        answer(question.purpose == FileQuestion::Purpose::OpenPlan ? planFile : values);
    });
    scene.click("captureValues");
    scene.click("choosePlanButton");
    scene.click("chooseValuesButton");
    QTest::qWait(300);
}

void captureSerial(PageScene& scene)
{
    captureDialog(scene);
    scene.page().findChild<QComboBox*>(QStringLiteral("referenceKindField"))->setCurrentIndex(1);
    QTest::qWait(200);
}

/// Half of the values are there, and the axis stands somewhere else.
void capturing(PageScene& scene)
{
    const MeasuringPlan plan = scenePlan();
    {
        auto file = RunFile::open(scene.stage().path(QStringLiteral("runs-X.csv")).toStdString(),
            plan, {"off", "typed", "2026-11-21T09:30:00"});
        for (std::size_t n = 0; n < 30; ++n) {
            const MeasuringStep& step = plan.steps[n];
            const double reversal = step.direction == Approach::Up ? 0.0006 : -0.0006;
            const double error = 0.0021 * std::sin(step.target / 6.0) + 0.00006 * step.target
                + reversal + 0.0001 * (static_cast<double>(n % 5) - 2.0);
            if (!file->append({step, error, step.target, 0.0, std::chrono::seconds(10 * n)}))
                qFatal("no value");
        }
    }
    captureDialog(scene);
    scene.page().findChild<QComboBox*>(QStringLiteral("referenceKindField"))->setCurrentIndex(2);
    scene.click("beginCaptureButton");
    const auto* state = scene.page().findChild<QLabel*>(QStringLiteral("captureState"));
    wait([&] { return state->text().contains(QStringLiteral("17")); }, "the axis to stand");
    QTest::qWait(300);
}

void measureBadFile(PageScene& scene)
{
    measureFiles(scene);
    addMeasurement(scene,
        scene.stage().file(QStringLiteral("before-x.csv"),
            "target [mm],direction,run,deviation "
            "[um]\n0,+,1,0.2\n25,sideways,1,0.3\n50,+,one,0.1\n"),
        2);
}

void measureValues(PageScene& scene)
{
    measureFiles(scene);
    scene.page().findChild<QTabWidget*>(QStringLiteral("measureTabs"))->setCurrentIndex(3);
    auto* values = scene.page().findChild<QTableView*>(QStringLiteral("runValues"));
    // The two that axiscomp judge proposes for exclusion.
    constexpr int firstRunDown = 6;
    for (const int target : {0, 1}) {
        values->setCurrentIndex(values->model()->index(target, firstRunDown));
        scene.click("excludeValues");
    }
    wait([&] { return values->model()->index(1, firstRunDown).data().toString().startsWith(u'✕'); },
        "the exclusions");
    QTest::qWait(200);
}

void showTab(PageScene& scene, PageTabs::Tab tab)
{
    scene.page().findChild<QTabBar*>(QStringLiteral("pageTabs"))->setCurrentIndex(tab);
    QTest::qWait(200);
}

void judgeEmpty(PageScene& scene)
{
    showPageTab(scene, PageTabs::Judge);
}

QLineEdit& limitField(PageScene& scene, const char* name)
{
    return *scene.page().findChild<QLineEdit*>(QLatin1StringView(name));
}

void enterLimit(PageScene& scene, const char* name, const QString& text)
{
    QLineEdit& field = limitField(scene, name);
    wait([&] { return field.isEnabled(); }, "the field");
    field.setText(text);
    field.setModified(true);
    Q_EMIT field.editingFinished();
    QTest::qWait(200);
}

/// A machine that is good but for its screw: tolerances met, not met and undecided.
void judgeFigures(PageScene& scene)
{
    measureEmpty(scene);
    addMeasurement(scene, publicMeasurement("bifrost"), 1);
    showTab(scene, PageTabs::Judge);
    enterLimit(scene, "toleranceA", QStringLiteral("10"));
    enterLimit(scene, "toleranceR", QStringLiteral("12"));
    enterLimit(scene, "toleranceM", QStringLiteral("16"));
    enterLimit(scene, "uncertainty", QStringLiteral("2"));
}

/// Values that do not fit, one of them excluded and one selected.
void judgeOutliers(PageScene& scene)
{
    measureEmpty(scene);
    addMeasurement(scene, publicMeasurement("ess_mcu1025"), 1);
    showTab(scene, PageTabs::Judge);
    auto* outliers = scene.page().findChild<QTableView*>(QStringLiteral("outliers"));
    outliers->setCurrentIndex(outliers->model()->index(0, 0));
    scene.click("excludeSelected");
    const auto* showsAll = scene.page().findChild<QWidget*>(QStringLiteral("showAllValues"));
    wait([&] { return showsAll->isEnabled(); }, "the exclusion");
    outliers->setCurrentIndex(outliers->model()->index(0, 0));
    QTest::qWait(200);
}

/// Corrections that lack a coefficient.
void judgeCorrections(PageScene& scene)
{
    measureEmpty(scene);
    addMeasurement(scene,
        scene.stage().file(QStringLiteral("warm.csv"),
            "// material temperature: 22.5\ntarget [mm],direction,run,deviation [um]\n"
            "0,+,1,0.4\n500,+,1,1.9\n500,-,1,1.1\n0,-,1,-0.6\n"),
        1);
    showTab(scene, PageTabs::Judge);
    scene.click("corrections");
    auto* dialog = scene.page().findChild<QDialog*>(QStringLiteral("correctionsDialog"));
    dialog->findChild<QGroupBox*>(QStringLiteral("temperatureCorrection"))->setChecked(true);
    dialog->findChild<QAbstractButton*>(QStringLiteral("acceptCorrections"))->click();
    QTest::qWait(200);
}

/// Runs that lie beside each other, in the plot and in numbers.
void judgeDrift(PageScene& scene)
{
    measureEmpty(scene);
    addMeasurement(scene, publicMeasurement("b02_y"), 1);
    showTab(scene, PageTabs::Judge);
    scene.page().findChild<QTabWidget*>(QStringLiteral("judgePlots"))->setCurrentIndex(1);
    scene.page().findChild<QTabWidget*>(QStringLiteral("judgeTabs"))->setCurrentIndex(3);
    QTest::qWait(200);
}

/// A record with the table of b02_x, on the tab Prove.
void proveEmpty(PageScene& scene)
{
    scene.showDrive();
    CalibrationRecord record = recordOfFit();
    record.fit->settings.tolerances = {{Iso230Figure::A, 0.01}, {Iso230Figure::R, 0.006}};
    record.fit->settings.uncertainty = 0.0021;
    scene.page().openRecord(scene.stage().file(
        QStringLiteral("spindle-x.axcal"), QByteArray::fromStdString(recordText(record))));
    const auto* name = scene.page().findChild<QLabel*>(QStringLiteral("recordName"));
    wait([&] { return name->text() == QStringLiteral("spindle-x.axcal"); }, "the record");
    showPageTab(scene, PageTabs::Prove);
}

void addAfter(PageScene& scene, const QByteArray& content)
{
    const QString path = scene.stage().file(QStringLiteral("after-x.csv"), content);
    scene.page().setFilePicker(
        [path](QWidget&, const ui::FileQuestion&,
            const std::function<void(const QString&)>& answer) { answer(path); });
    scene.click("afterAddMeasurement");
    const auto* figures = scene.page().findChild<QTableView*>(QStringLiteral("proveFigures"));
    const auto* stated = scene.page().findChild<QWidget*>(QStringLiteral("tableStated"));
    wait([&] { return figures->model()->rowCount() > 0 || stated->isVisible(); }, "the comparison");
    QTest::qWait(200);
}

void proveStatement(PageScene& scene)
{
    proveEmpty(scene);
    addAfter(scene, goodAfterMeasurement({}));
}

void proveKept(PageScene& scene)
{
    proveEmpty(scene);
    addAfter(scene, goodAfterMeasurement(stateOf(recordOfFit())));
    scene.click("keepAfter");
    const auto* keep = scene.page().findChild<QWidget*>(QStringLiteral("keepAfter"));
    wait([&] { return !keep->isEnabled(); }, "the record");
    QTest::qWait(200);
}

void proveWrongSign(PageScene& scene)
{
    proveEmpty(scene);
    const CalibrationRecord record = recordOfFit();
    const auto figures = iso230Figures(*usedMeasurement(*record.before));
    addAfter(scene, afterMeasurement(stateOf(record), [&](int i) {
        return 2000.0 * *figures.targets[static_cast<std::size_t>(i)].mean;
    }));
}

void closingUnsaved(PageScene& scene)
{
    proveKept(scene);
    static_cast<void>(scene.page().mayClose());
    QTest::qWait(200);
}

void chooseInList(PageScene& scene, const char* name, int data)
{
    auto* list = scene.page().findChild<QComboBox*>(QLatin1StringView(name));
    list->setCurrentIndex(list->findData(data));
    Q_EMIT list->activated(list->currentIndex());
}

void fitOf(PageScene& scene, const QString& path)
{
    measureEmpty(scene);
    addMeasurement(scene, path, 1);
    scene.page().findChild<QTabBar*>(QStringLiteral("pageTabs"))->setCurrentIndex(PageTabs::Fit);
    QTest::qWait(200);
}

void waitForFit(PageScene& scene)
{
    const auto* use = scene.page().findChild<QPushButton*>(QStringLiteral("saveFittedTable"));
    wait([&] { return use->isEnabled(); }, "the table");
    QTest::qWait(200);
}

void fitAsks(PageScene& scene)
{
    fitOf(scene, publicMeasurement("b02_x"));
}

/// Off, and looked up at the encoder.
void fitCurve(PageScene& scene)
{
    fitAsks(scene);
    chooseInList(scene, "fitLookup", 1);
    chooseInList(scene, "fitMeasuredWith", 1);
    waitForFit(scene);
}

/// An error of the screw's period between 51 targets.
void fitSmooth(PageScene& scene)
{
    QByteArray text =
        "// axis: X\n// compensation: off\ntarget [mm],direction,run,deviation [um]\n";
    for (int run = 1; run <= 5; ++run)
        for (const char* direction : {"+", "-"})
            for (int n = 0; n <= 50; ++n) {
                const double x = 10.0 * n + 2.9 * std::sin(1.7 * n * n);
                const double value = 0.012 * x + 3.0 * std::sin(x / 68.0)
                    + 0.8 * std::sin(2.0 * 3.14159265 * x / 10.0)
                    + 0.1 * std::sin(12.9 * n + 7.0 * run) + (*direction == '+' ? 1.2 : -1.2);
                text += QByteArray::number(x, 'f', 3) + ',' + direction + ','
                    + QByteArray::number(run) + ',' + QByteArray::number(value, 'f', 3) + '\n';
            }
    fitOf(scene, scene.stage().file(QStringLiteral("before-x.csv"), text));
    chooseInList(scene, "fitLookup", 1);
    chooseInList(scene, "fitMethod", static_cast<int>(FitMethod::Smooth));
    auto* periods = scene.page().findChild<QLineEdit*>(QStringLiteral("fitPeriods"));
    periods->setText(QStringLiteral("10"));
    Q_EMIT periods->editingFinished();
    waitForFit(scene);
}

void fitWrongNumber(PageScene& scene)
{
    fitCurve(scene);
    auto* turn = scene.page().findChild<QLineEdit*>(QStringLiteral("fitTurn"));
    turn->setText(QStringLiteral("one turn"));
    Q_EMIT turn->editingFinished();
    QTest::qWait(200);
}

/// A plate with a hole in it, whose grid points are filled.
void fitMap(PageScene& scene)
{
    QByteArray text = "// compensation: off\nX [mm],Y [mm],dX [um],dY [um]\n";
    for (int y = 0; y <= 30; y += 2)
        for (int x = 0; x <= 40; x += 2) {
            if (std::hypot(x - 26.0, y - 12.0) < 5.0)
                continue;
            text += QByteArray::number(x) + ',' + QByteArray::number(y) + ','
                + QByteArray::number(1.8 * std::sin(x / 7.0) + 0.04 * y, 'f', 3) + ','
                + QByteArray::number(0.9 * std::cos(y / 6.0) - 0.03 * x, 'f', 3) + '\n';
        }
    fitOf(scene, scene.stage().file(QStringLiteral("plate.csv"), text));
    chooseInList(scene, "fitLookup", 1);
    waitForFit(scene);
}

void fitUsed(PageScene& scene)
{
    fitCurve(scene);
    scene.click("useAsTable");
    wait([&] { return scene.controller().dataFile().isMade; }, "the table on Write");
    scene.settle();
}

} // namespace

const std::vector<SceneState>& sceneStates()
{
    static const std::vector<SceneState> all{
        {"first-start", firstStart},
        {"unwritten-2d", unwritten2D},
        {"write-preview", writePreview},
        {"preview-warning", previewWarning},
        {"preview-1d", preview1D},
        {"preview-3d", preview3D},
        {"backups", backups},
        {"overview", overview},
        {"machine-drift", machineDrift},
        {"machine-mistakes", machineMistakes},
        {"apply-machine", applyMachine},
        {"apply-machine-missing", applyMachineMissing},
        {"applied-machine", appliedMachine},
        {"save-machine", saveMachine},
        {"guide", guide},
        {"large-corrections", largeCorrections},
        {"refused-angle", refusedAngle},
        {"incomplete-bed", incompleteBed},
        {"filled-bed", filledBed},
        {"writing", writing},
        {"closing-while-writing", closingWhileWriting},
        {"active", active},
        {"bad-file", badFile},
        {"bad-file-lines", badFileLines},
        {"map-details", mapDetails},
        {"surface-2d", surface2D},
        {"surface-3d", surface3D},
        {"values-2d", values2D},
        {"values-3d", values3D},
        {"two-axes", twoAxes},
        {"all-slices", allSlices},
        {"travel-1d", travel1D},
        {"travel-2d", travel2D},
        {"difference", difference},
        {"curve-1d", curve1D},
        {"curve-1d-values", curve1DValues},
        {"drive-refuses", driveRefuses},
        {"flash-wear", flashWear},
        {"not-homed", notHomed, false},
        {"unfinished-write", unfinishedWrite},
        {"table-3d", table3D},
        {"connection-lost", connectionLost},
        {"other-axis", otherAxis},
        {"proposed-sources", proposedSources},
        {"unreachable-drive", unreachableDrive},
        {"restore-drive", restoreDrive},
        {"connections", connections},
        {"find-drives", findDrives},
        {"import-dialog", importDialog},
        {"damaged-list", damagedList},
        {"damaged-import", damagedImport},
        {"export-dialog", exportDialog},
        {"several-axes", multiAxisAxes},
        {"several-axes-failed", multiAxisFailed},
        {"import-configuration", importConfiguration},
        {"export-configuration", exportConfiguration},
        {"measure-empty", measureEmpty},
        {"measure-files", measureFiles},
        {"measure-columns", measureColumns},
        {"measure-bad-file", measureBadFile},
        {"measure-values", measureValues},
        {"judge-empty", judgeEmpty},
        {"judge-figures", judgeFigures},
        {"judge-outliers", judgeOutliers},
        {"judge-drift", judgeDrift},
        {"judge-corrections", judgeCorrections},
        {"prove-empty", proveEmpty},
        {"prove-statement", proveStatement},
        {"prove-kept", proveKept},
        {"prove-wrong-sign", proveWrongSign},
        {"closing-unsaved", closingUnsaved},
        {"fit-asks", fitAsks},
        {"fit", fitCurve},
        {"fit-smooth", fitSmooth},
        {"fit-wrong-number", fitWrongNumber},
        {"fit-map", fitMap},
        {"fit-used", fitUsed},
        {"measure-proposed-columns", measureProposedColumns},
        {"plan-dialog", planDialog},
        {"plan-mistake", planMistake},
        {"capture-dialog", captureDialog},
        {"capture-serial", captureSerial},
        {"capturing", capturing},
    };
    return all;
}

QWidget& shownWindow(PageScene& scene)
{
    QWidget* shown = &scene.page();
    for (QDialog* dialog : scene.page().findChildren<QDialog*>()) {
        if (dialog->isVisible())
            shown = dialog; // the inner one comes last
    }
    return *shown;
}

} // namespace axiscomp::test
