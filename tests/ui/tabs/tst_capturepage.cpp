// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/local_file.h"
#include "core/metrology/formats/measurement_format.h"
#include "drivecomm/virtualdrive/machine/machine_file.h"
#include "drivecomm/virtualdrive/machine/program_motion.h"
#include "tests/ui/support/page_fixture.h"
#include "tests/ui/support/record_files.h"
#include "tests/ui/support/window_test.h"
#include "ui/page/page_tabs.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>

#include <atomic>
#include <cmath>
#include <limits>

namespace tst_capturepage {

using namespace axiscomp;
using namespace axiscomp::ui;
using namespace std::chrono_literals;
using test::PageFixture;

namespace {

/// A straight error of 12 um/m, so that every deviation is known: without waves, noise and map.
const std::string straight =
    R"({"axes": {"X": {"slope": 12e-6}, "Y": {}}, "instrument": {"axis": "X"}})";
constexpr auto programStart = 500ms;
const QString referenceRegister = QStringLiteral("Machine/Axes[0]/ReferencePosition");

MeasuringPlan planOf(const std::string& axis = "X", int count = 3)
{
    MeasuringPlanRequest request;
    request.axis = axis;
    request.to = 30.0;
    request.count = count;
    request.cycles = 1;
    request.overrun = 1.0;
    request.dwellSeconds = 2.5;
    return makeMeasuringPlan(request).value();
}

std::string contentOf(const QString& file)
{
    const auto bytes = loadFile(file.toStdString(), 1'000'000);
    return bytes ? std::string(asText(*bytes)) : std::string();
}

/// When the axis of the program has come to the target of its first step.
std::chrono::nanoseconds firstArrival()
{
    const drivecomm::ProgramMotion motion(planOf(), 0.0);
    const double seconds = motion.movementEnds(0.0, motion.endSeconds()).at(1);
    return programStart + std::chrono::nanoseconds(std::llround(seconds * 1e9));
}

/// The window on a machine that plays the plan, at the tab Measure. Time passes by 50 ms at each
/// reading of a capture, and only then: it stands still at a moment or when so many values have
/// been taken, however late the test is there to see it.
struct CaptureBench {
    explicit CaptureBench(
        const QString& valuesFile = {}, const QString& language = QStringLiteral("en"))
        : page(machine(), language, drivecomm::genericProfile(),
            [this](WizardOptions& options) {
                options.captureInterval = 1ms;
                options.captureClock = [this] {
                    if (time < holdAt && taken() < holdAfter)
                        time += std::chrono::nanoseconds(50ms).count();
                    return std::chrono::nanoseconds(time);
                };
            })
        , values(valuesFile.isEmpty() ? page.path(QStringLiteral("runs.csv")) : valuesFile)
    {
    }

    drivecomm::VirtualDriveOptions machine()
    {
        drivecomm::VirtualDriveOptions options;
        options.name = "Mill-1";
        options.serialNumber = 1559;
        options.machine = drivecomm::parseMachine(straight, "straight").value();
        options.program = planOf();
        options.programStart = programStart;
        options.clock = [this] { return std::chrono::nanoseconds(time); };
        return options;
    }
    [[nodiscard]] bool open()
    {
        if (!page.open())
            return false;
        page.user.the<PageTabs>("pageTabs").setCurrentIndex(PageTabs::Measure);
        return page.user.sees("measurePage");
    }
    /// Everything that the dialog asks, but for the reference.
    [[nodiscard]] bool fillDialog(const std::string& axis = "X")
    {
        const std::string plan = measuringPlanCsv(planOf(axis));
        page.picked = page.file(QStringLiteral("plan.csv"),
            QByteArray(plan.data(), static_cast<qsizetype>(plan.size())));
        if (!page.user.click("captureValues") || !page.user.click("choosePlanButton"))
            return false;
        page.picked = values;
        return page.user.click("chooseValuesButton");
    }
    [[nodiscard]] bool beginWithRegister(const std::string& axis = "X")
    {
        return fillDialog(axis) && page.user.enter("referenceRegisterField", referenceRegister)
            && page.user.click("beginCaptureButton");
    }
    [[nodiscard]] bool chooseKind(const QString& kind)
    {
        auto& field = page.user.the<QComboBox>("referenceKindField");
        field.setCurrentIndex(field.findText(kind));
        return field.currentText() == kind;
    }
    [[nodiscard]] bool beginTyped()
    {
        return fillDialog() && chooseKind(QStringLiteral("typed by hand"))
            && page.user.click("beginCaptureButton") && says(QStringLiteral("Step 1 is due"))
            && page.user.isThere();
    }
    [[nodiscard]] QString state() { return page.user.the<QLabel>("captureState").text(); }
    [[nodiscard]] bool says(const QString& part)
    {
        const bool isSaid = QTest::qWaitFor(
            [&] { return page.user.sees("captureState") && state().contains(part); },
            test::patienceMs);
        if (!isSaid)
            qInfo("it says: %s", qPrintable(page.user.sees("captureState") ? state() : QString()));
        return isSaid;
    }
    void goOn()
    {
        holdAt = std::numeric_limits<std::int64_t>::max();
        holdAfter = std::numeric_limits<int>::max();
    }
    /// Where the axis stands at the target of the first step.
    void holdSoLongAfterArrival(std::chrono::nanoseconds after)
    {
        holdAt = (firstArrival() + after).count();
    }
    [[nodiscard]] int taken() const
    {
        const std::string text = contentOf(values);
        return static_cast<int>(std::ranges::count(text, '\n')) - 10; // of the header
    }
    [[nodiscard]] bool hasTaken(int count)
    {
        return QTest::qWaitFor([&] { return taken() >= count; }, test::patienceMs);
    }

    std::atomic<std::int64_t> time = 0;
    std::atomic<std::int64_t> holdAt = std::numeric_limits<std::int64_t>::max();
    std::atomic<int> holdAfter = std::numeric_limits<int>::max();
    PageFixture page;
    QString values;
};

/// Every value of the plan once, and right.
void verifyComplete(const QString& file)
{
    const std::string text = contentOf(file);
    const auto reading = chooseMeasurementFormat(text, "runs.csv", {}).value()->read(text, {});
    QVERIFY(reading.measurement.has_value());
    QCOMPARE(reading.measurement->values.size(), planOf().steps.size());
    for (const RunValue& value : reading.measurement->values) {
        const double target = reading.measurement->targets[value.target];
        QVERIFY(std::abs(value.deviation - 12e-6 * target) < 1e-7);
    }
}

int filesOf(CaptureBench& bench)
{
    return bench.page.user.the<QTableView>("measurementFiles").model()->rowCount();
}

} // namespace

/// The tab Measure while values are taken.
class TestCapturePage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void theValuesOfAPlanAreTakenAndTheirFileIsAdded()
    {
        CaptureBench bench;
        QVERIFY(bench.open() && bench.beginWithRegister());
        QVERIFY(bench.says(QStringLiteral("Every step has its value: 6 values are in runs.csv.")));
        verifyComplete(bench.values);
        const auto& files = bench.page.user.the<QTableView>("measurementFiles");
        QTRY_COMPARE(files.model()->rowCount(), 1);
        QTRY_COMPARE(files.model()->index(0, 1).data().toString(), QStringLiteral("ready"));
        const auto& steps = bench.page.user.the<QTableView>("planSteps");
        QCOMPARE(steps.model()->rowCount(), 6);
        // 12 um/m at 0 and 30 mm
        QCOMPARE(steps.model()->index(0, 3).data().toString(), QStringLiteral("0.00"));
        QCOMPARE(steps.model()->index(2, 3).data().toString(), QStringLiteral("0.36"));
        QVERIFY(bench.page.user.the("captureValues").isEnabled());
    }

    /// A number that is cut is another one: "1.00" of 1.000 um.
    void theLargeNumbersFitTheWindow()
    {
        CaptureBench bench;
        bench.holdAfter = 1;
        QVERIFY(bench.open() && bench.beginWithRegister());
        QVERIFY(bench.hasTaken(1));
        QVERIFY(bench.page.user.sees("captureDifference"));
        const auto& area = bench.page.user.the<QScrollArea>("captureScroll");
        QTRY_COMPARE(area.horizontalScrollBar()->maximum(), 0);
        const auto& difference = bench.page.user.the<QLabel>("captureDifference");
        QVERIFY(difference.width() >= difference.sizeHint().width());
        bench.goOn();
        QVERIFY(bench.says(QStringLiteral("Every step has its value")));
    }

    /// Under its name would stand another plan than the one that is measured by.
    void aPlanThatHasChangedOnDiskIsReadAnew()
    {
        CaptureBench bench;
        QVERIFY(bench.open() && bench.beginWithRegister());
        QVERIFY(bench.says(QStringLiteral("Every step has its value")));
        const std::string plan = measuringPlanCsv(planOf("X", 5));
        static_cast<void>(bench.page.file(QStringLiteral("plan.csv"),
            QByteArray(plan.data(), static_cast<qsizetype>(plan.size()))));
        QVERIFY(bench.page.user.click("captureValues"));
        const auto& field = bench.page.user.the<QLineEdit>("planField");
        QTRY_VERIFY2(field.text().startsWith(QStringLiteral("plan.csv (Axis X: 5 targets")),
            qPrintable(field.text()));
    }

    /// The measurement of one machine is not that of another.
    void theValuesOfACaptureAreNotAddedToARecordThatWasOpenedMeanwhile()
    {
        CaptureBench bench;
        bench.holdAfter = 1;
        QVERIFY(bench.open() && bench.beginWithRegister());
        QVERIFY(bench.hasTaken(1));
        bench.page.picked = bench.page.file(QStringLiteral("other.axcal"),
            QByteArray::fromStdString(recordText(test::recordOfFit())));
        bench.page.user.the<QAction>("openRecordAction").trigger();
        QTRY_VERIFY(filesOf(bench) > 0);
        const int files = filesOf(bench);
        bench.goOn();
        QVERIFY(bench.hasTaken(6));
        QTRY_COMPARE(bench.page.user.the<QLabel>("measureHint").text(),
            QStringLiteral("runs.csv was captured for the record that was open before, and is not "
                           "added to this one."));
        QCOMPARE(filesOf(bench), files);
    }

    void theWindowStaysLiveAndReadyWhileValuesAreTaken()
    {
        CaptureBench bench;
        bench.holdAfter = 1;
        QVERIFY(bench.open() && bench.beginWithRegister());
        QVERIFY(bench.hasTaken(1));
        QSignalSpy live(&bench.page.controller(), &WizardController::liveChanged);
        QTRY_VERIFY(live.count() >= 3);
        QVERIFY(!bench.page.user.the("captureValues").isEnabled());
        QVERIFY(bench.page.user.the("captureValues")
                    .toolTip()
                    .contains(QStringLiteral("being captured")));
        // Something that the drive is asked for goes between two readings.
        bench.page.controller().backUpDrive(bench.page.path(QStringLiteral("drive.json")));
        QVERIFY(bench.page.idle());
        QVERIFY(QFile::exists(bench.page.path(QStringLiteral("drive.json"))));
        bench.goOn();
        QVERIFY(bench.says(QStringLiteral("Every step has its value")));
        verifyComplete(bench.values);
    }

    /// It would shift every deviation.
    void aZeroThatCanBeReadInTwoWaysKeepsTheCaptureFromBeginning()
    {
        CaptureBench bench;
        auto& user = bench.page.user;
        QVERIFY(bench.open() && bench.fillDialog());
        QVERIFY(bench.chooseKind(QStringLiteral("typed by hand")));
        QTRY_VERIFY(user.the("beginCaptureButton").isEnabled());
        QVERIFY(user.click("zeroField"));
        user.press(Qt::Key_A, Qt::ControlModifier);
        user.type(QStringLiteral("1,000"));
        user.press(Qt::Key_B, Qt::AltModifier);
        const auto& reason = user.the<QLabel>("captureReason");
        QTRY_VERIFY2(
            reason.text().startsWith(QStringLiteral("Zero at: \"1,000\" can be read in two ways")),
            qPrintable(reason.text()));
        QVERIFY(!user.the("beginCaptureButton").isEnabled());
        QVERIFY(user.click("zeroField"));
        user.press(Qt::Key_A, Qt::ControlModifier);
        user.type(QStringLiteral("1000"));
        user.press(Qt::Key_Tab);
        QCOMPARE(user.the<QDoubleSpinBox>("zeroField").value(), 1000.0);
        QVERIFY(user.the("beginCaptureButton").isEnabled());
    }

    void aTypedPositionIsTakenByTheSpaceBarAndTakenBack()
    {
        CaptureBench bench;
        bench.holdAt = 0;
        QVERIFY(bench.open() && bench.beginTyped());
        QVERIFY(bench.says(QStringLiteral("The axis moves. Step 1 is due: 0.000 mm")));
        QVERIFY(!bench.page.user.the("takeButton").isEnabled());
        bench.holdSoLongAfterArrival(1200ms);
        QVERIFY(bench.says(QStringLiteral("read the instrument, and type what it says")));
        QVERIFY(bench.page.user.click("typedReference"));
        bench.page.user.type(QStringLiteral("0.0021"));
        bench.page.user.press(Qt::Key_Space);
        QVERIFY(bench.hasTaken(1));
        QVERIFY(bench.says(QStringLiteral("Taken. Step 2 is due")));
        QVERIFY(bench.page.user.click("undoLastButton"));
        QTRY_COMPARE(bench.taken(), 0);
        QTRY_VERIFY(!bench.page.user.the("undoLastButton").isEnabled());
        // Its step is due again where the axis still stands, after another dwell.
        bench.holdSoLongAfterArrival(2400ms);
        QVERIFY(bench.says(QStringLiteral("read the instrument")));
        QVERIFY(bench.page.user.click("typedReference"));
        bench.page.user.type(QStringLiteral("0.0012"));
        QVERIFY(bench.page.user.click("takeButton"));
        QVERIFY(bench.hasTaken(1));
        QVERIFY(contentOf(bench.values).find("\n0.000,+,1,0.0012000,") != std::string::npos);
    }

    void aTypedPositionThatIsImplausibleIsTypedTwice()
    {
        CaptureBench bench;
        bench.holdSoLongAfterArrival(1200ms);
        QVERIFY(bench.open() && bench.beginTyped());
        QVERIFY(bench.says(QStringLiteral("read the instrument")));
        auto& field = bench.page.user.the<QLineEdit>("typedReference");
        QVERIFY(bench.page.user.enter("typedReference", QStringLiteral("3.2")));
        QVERIFY(bench.says(QStringLiteral("type it once more if it is right")));
        QVERIFY(field.text().isEmpty());
        QVERIFY(bench.page.user.enter("typedReference", QStringLiteral("?")));
        QVERIFY(bench.says(QStringLiteral("where a number is expected")));
        QCOMPARE(bench.taken(), 0);
        QVERIFY(bench.page.user.enter("typedReference", QStringLiteral("3.2")));
        QVERIFY(bench.hasTaken(1));
    }

    void aLostDrivePausesAndWhatItMissedIsSaid()
    {
        CaptureBench bench;
        bench.holdAfter = 2;
        QVERIFY(bench.open() && bench.beginWithRegister());
        QVERIFY(bench.hasTaken(2));
        const int before = bench.taken();
        bench.page.served.stop();
        QVERIFY(bench.says(QStringLiteral("Nothing is taken:")));
        QVERIFY(bench.state().contains(QStringLiteral("goes on when the drive answers again")));
        QVERIFY(!bench.page.user.the("undoLastButton").isEnabled());
        QCOMPARE(bench.taken(), before);
        bench.page.served.start();
        bench.goOn();
        QVERIFY(bench.says(QStringLiteral("Every step has its value")));
        verifyComplete(bench.values);
    }

    void aDriveThatIsBackDuringAPauseIsSaidToBe()
    {
        CaptureBench bench;
        bench.holdAfter = 1;
        QVERIFY(bench.open() && bench.beginWithRegister());
        QVERIFY(bench.hasTaken(1));
        QVERIFY(bench.page.user.click("pauseButton"));
        QVERIFY(bench.says(QStringLiteral("Paused: nothing is taken. Step")));
        bench.page.served.stop();
        QVERIFY(bench.says(QStringLiteral("Nothing is taken:")));
        bench.page.served.start();
        QVERIFY(bench.says(QStringLiteral("Paused: nothing is taken. Step")));
        QVERIFY(bench.page.user.the("undoLastButton").isEnabled());
    }

    void aPauseTakesNothing()
    {
        CaptureBench bench;
        bench.holdAfter = 1;
        QVERIFY(bench.open() && bench.beginWithRegister());
        QVERIFY(bench.hasTaken(1));
        QVERIFY(bench.page.user.click("pauseButton"));
        QVERIFY(bench.says(QStringLiteral("Paused: nothing is taken. Step")));
        bench.goOn();
        const int before = bench.taken();
        const std::int64_t time = bench.time;
        QTest::qWait(100);
        QVERIFY(bench.time - time <= std::chrono::nanoseconds(50ms).count());
        // What was taken is taken back all the same.
        QVERIFY(bench.page.user.click("undoLastButton"));
        QTRY_COMPARE(bench.taken(), before - 1);
        QVERIFY(bench.page.user.click("stopButton"));
        QVERIFY(bench.says(QStringLiteral("Stopped. %1 of 6 values").arg(before - 1)));
    }

    void aWindowThatIsClosedLeavesAFileThatGoesOn()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("runs.csv"));
        {
            CaptureBench bench(file);
            bench.holdAfter = 2;
            QVERIFY(bench.open() && bench.beginWithRegister());
            QVERIFY(bench.hasTaken(2));
        }
        const std::string left = contentOf(file);
        QVERIFY(left.ends_with('\n'));
        CaptureBench again(file);
        const int before = again.taken();
        QVERIFY(before >= 2 && before < 6);
        QVERIFY(again.open() && again.beginWithRegister());
        QVERIFY(again.says(QStringLiteral("Every step has its value")));
        verifyComplete(file);
        QVERIFY(contentOf(file).starts_with(left));
    }

    void thePlanOfAnotherAxisIsRefused()
    {
        CaptureBench bench;
        QVERIFY(bench.open() && bench.beginWithRegister("Y"));
        const auto& reason = bench.page.user.the<QLabel>("captureReason");
        QTRY_VERIFY2(
            reason.text().contains(QStringLiteral("he plan is for axis Y, and this is axis X")),
            qPrintable(reason.text()));
        QVERIFY(!QFile::exists(bench.values));
        QVERIFY(!bench.page.user.sees("capturePanel"));
        QVERIFY(bench.page.user.the("beginCaptureButton").isEnabled());
    }

    void aDriveThatIsRemovedEndsIt()
    {
        CaptureBench bench;
        bench.holdAfter = 1;
        QVERIFY(bench.open() && bench.beginWithRegister());
        QVERIFY(bench.hasTaken(1));
        bench.page.controller().setEndpoints({});
        QVERIFY(bench.says(QStringLiteral("the connection was removed")));
        QVERIFY(contentOf(bench.values).ends_with('\n'));
    }
};

AXISCOMP_WINDOW_TEST(TestCapturePage)

} // namespace tst_capturepage

#include "tst_capturepage.moc"
