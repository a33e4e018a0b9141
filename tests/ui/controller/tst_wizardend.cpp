// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/link_factory.h"
#include "tests/support/end_watch.h"
#include "tests/support/raw_responder.h"
#include "tests/support/verify.h"
#include "tests/ui/support/controller_fixture.h"
#include "tests/ui/support/window_test.h"
#include "ui/compensation_wizard.h"

#include <QSignalSpy>
#include <QTest>

namespace tst_wizardend {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::ControllerFixture;
using test::DriveGate;
using test::EndWatch;

namespace {

constexpr std::chrono::milliseconds deadline{2'000};
/// Less than a second deadline, which is what a drive that is asked twice would take.
constexpr std::chrono::milliseconds limit{3'500};

} // namespace

/// The end takes no longer than one deadline, whatever the drive does.
class TestWizardEnd : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void whileADriveIsLookedForThatNeverAnswers()
    {
        const test::RawResponder silent(test::neverAnswer);
        ControllerFixture bench;
        bench.options.timeout = deadline;
        bench.options.linkFactory = drivecomm::linkFactory(drivecomm::genericProfile());
        bench->setEndpoints({QString::fromStdString(silent.url())});
        QTRY_COMPARE(silent.requests(), 1);
        EndWatch end(limit);
        bench.endController();
        QVERIFY(end.ended());
    }

    void whileADriveIsWrittenToThatHangs_data()
    {
        QTest::addColumn<int>("exchange");
        for (int exchange = 2; exchange <= 20; exchange += 3)
            QTest::addRow("at exchange %d", exchange) << exchange;
    }
    void whileADriveIsWrittenToThatHangs()
    {
        QFETCH(int, exchange);
        ControllerFixture bench;
        bench.options.timeout = deadline;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        bench->planWrite();
        QVERIFY(bench.idle());
        bench.drive().gate.setAt(exchange, DriveGate::Mode::Deaf);
        bench->write();
        QTRY_COMPARE(bench.drive().gate.waiting(), 1);
        EndWatch end(limit);
        bench.endController();
        QVERIFY(end.ended());
        QCOMPARE(bench.drive().gate.timeouts(), 1);
    }

    void theWindowClosesAtOnceWhileItsDriveHangs()
    {
        ControllerFixture bench;
        bench.options.timeout = deadline;
        auto wizard = std::make_unique<CompensationWizard>(bench.options, nullptr);
        WizardController& controller = wizard->controller();
        controller.setEndpoints({QStringLiteral("http://x")});
        QTRY_VERIFY(controller.status().has_value());
        controller.setup().setDimensionality(2);
        controller.chooseSource(1, QString::fromStdString(test::masterX));
        controller.chooseSource(2, QString::fromStdString(test::masterY));
        controller.openData(
            bench.file(QStringLiteral("2d.csv"), ControllerFixture::calibration2D(1)));
        QTRY_VERIFY(controller.action(Action::Write).isEnabled);
        QSignalSpy ready(&controller, &WizardController::planReady);
        controller.planWrite();
        QTRY_COMPARE(ready.count(), 1);
        QTRY_VERIFY(!controller.busy().isBusy);
        bench.drive().gate.setAt(14, DriveGate::Mode::Deaf);
        controller.write();
        QTRY_COMPARE(bench.drive().gate.waiting(), 1);
        QVERIFY(!wizard->mayClose()); // that would ask
        QSignalSpy closed(wizard.get(), &CompensationWizard::closeRequested);
        EndWatch end(limit);
        wizard->closeNow();
        QCOMPARE(closed.count(), 1);
        QVERIFY(wizard->mayClose());
        wizard.reset();
        QVERIFY(end.ended());
    }
};

AXISCOMP_WINDOW_TEST(TestWizardEnd)

} // namespace tst_wizardend

#include "tst_wizardend.moc"
