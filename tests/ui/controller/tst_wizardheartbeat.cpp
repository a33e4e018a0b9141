// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "tests/ui/support/brackets.h"
#include "tests/ui/support/controller_fixture.h"
#include "tests/ui/support/heartbeat.h"

#include <QEventLoop>
#include <QTest>
#include <QTimer>

#include <cmath>
#include <functional>

namespace tst_wizardheartbeat {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::ControllerFixture;
using test::DriveGate;
using test::Heartbeat;

namespace {

/// AddressSanitizer looks at every access: the same work takes several times as long.
#ifdef __SANITIZE_ADDRESS__
constexpr int slowness = 8;
#else
constexpr int slowness = 1;
#endif

/// One frame: what the window's thread may compute between two turns of its event loop.
constexpr std::chrono::milliseconds longestWork{16 * slowness};
/// It must not wait for anything either. A drive, a file or a worker that it waited for would hold
/// it for longer than this (DriveGate's timeouts are 300 ms and more); a machine with other work
/// can hold it for more than a frame through no fault of the program, at the heap's lock for
/// example.
constexpr std::chrono::milliseconds longestGap{slowness == 1 ? 100 : 250};

/// As QTRY_VERIFY, but the event loop turns all the time: that one sleeps in between.
template <typename Condition> bool waitFor(const Condition& condition)
{
    QEventLoop loop;
    QTimer poll;
    QObject::connect(&poll, &QTimer::timeout, &loop, [&] {
        if (condition())
            loop.quit();
    });
    QTimer::singleShot(120'000, &loop, &QEventLoop::quit);
    poll.start(1);
    loop.exec();
    return condition();
}

/// About 20 MB: 2D, two tables.
QByteArray largeCalibration()
{
    QByteArray text = "X [mm],Y [mm],first [mm],second [mm]\n";
    constexpr int size = 720;
    text.reserve(22'000'000);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const double value = 0.002 * std::sin(0.01 * x) * std::cos(0.013 * y);
            text += QByteArray::number(0.25 * x, 'f', 4) + ','
                + QByteArray::number(0.25 * y, 'f', 4) + ',' + QByteArray::number(value, 'f', 12)
                + ',' + QByteArray::number(-value, 'f', 12) + '\n';
        }
    }
    return text;
}

/// Whether the thread computed and waited no longer than it may while this was done. Tried up to
/// three times: a block of our own comes back each time, one of the machine's does not.
bool staysSmooth(const char* what, const std::function<void(Heartbeat&)>& scenario)
{
    for (int attempt = 1; attempt <= 3; ++attempt) {
        Heartbeat heart;
        scenario(heart);
        const int beats = heart.beats();
        const bool isAlive = waitFor([&] { return heart.beats() > beats + 20; });
        qInfo("%s: worked %.1f ms, stopped %.1f ms at the longest in %d beats", what,
            static_cast<double>(heart.longestBusy().count()) / 1000.0,
            static_cast<double>(heart.longest().count()) / 1000.0, heart.beats());
        if (QTest::currentTestFailed() || !isAlive)
            return false;
        if (heart.longestBusy() < longestWork && heart.longest() < longestGap)
            return true;
    }
    return false;
}

/// A controller that reads live values, with the large file open and chosen for axis X.
bool openLargeFile(ControllerFixture& bench)
{
    bench.options.liveInterval = std::chrono::milliseconds(100);
    if (!bench.connect())
        return false;
    bench.chooseMasterSources();
    bench->openData(bench.file(QStringLiteral("large.csv"), largeCalibration()));
    return waitFor([&] { return bench->action(Action::Write).isEnabled; });
}

} // namespace

class TestWizardHeartbeat : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void readingAFileOf20MegabytesNeverStopsTheWindow()
    {
        QVERIFY(staysSmooth("reading 20 MB", [&](Heartbeat& heart) {
            ControllerFixture bench;
            bench.options.liveInterval = std::chrono::milliseconds(100);
            QVERIFY(bench.connect());
            bench.chooseMasterSources();
            const QByteArray text = largeCalibration();
            QVERIFY(text.size() > 20'000'000);
            const QString path = bench.file(QStringLiteral("large.csv"), text);
            std::vector<double> progress;
            connect(&bench.controller(), &WizardController::dataFileChanged, this,
                [&] { progress.push_back(bench->dataFile().progress); });
            heart.restart();
            bench->openData(path);
            QVERIFY(bench->dataFile().isReading);
            QVERIFY(waitFor([&] { return !bench->dataFile().isReading; }));
            QVERIFY(bench->dataFile().data);
            QCOMPARE(bench->dataFile().data->grid.pointCount(), std::size_t{720 * 720});
            QVERIFY(!bench->signSentence().isEmpty());
            // Often enough to be followed.
            QVERIFY(std::ranges::any_of(progress, [](double p) { return p > 0.0 && p < 1.0; }));
        }));
    }

    void convertingAFileOfAnotherControllerNeverStopsTheWindow()
    {
        QByteArray text = "1 100000\n";
        for (int i = 0; i < 100'000; ++i)
            text += QByteArray::number(0.01 * i, 'f', 2) + ' '
                + QByteArray::number(0.002 * std::sin(0.001 * i), 'f', 9) + '\n';
        QVERIFY(staysSmooth("converting 100000 points", [&](Heartbeat& heart) {
            ControllerFixture bench;
            const QString path = bench.file(QStringLiteral("large.txt"), text);
            heart.restart();
            ImportChoices choices;
            choices.target = sourceTarget(0);
            bench->importData(path, choices);
            QVERIFY(waitFor([&] { return !bench->dataFile().isReading; }));
            QVERIFY(bench->dataFile().data);
            QVERIFY(!bench->dataFile().report.empty());
        }));
    }

    void readingCanBeCancelled()
    {
        ControllerFixture bench;
        const QString path = bench.file(QStringLiteral("large.csv"), largeCalibration());
        bench->openData(path);
        QTRY_VERIFY(bench->dataFile().progress > 0.0);
        QVERIFY(bench->action(Action::Cancel).isEnabled);
        QCOMPARE(bench->action(Action::Cancel).reason, QStringLiteral("Stops reading the file."));
        bench->cancel();
        QVERIFY(!bench->dataFile().isReading);
        QVERIFY(!bench->dataFile().data);
        // The next file is read as if nothing had been.
        bench->openData(bench.file(QStringLiteral("1d.csv"), "X,table\n0,0.1\n1,0.2\n2,0.1\n"));
        QVERIFY(bench.fileRead());
        QVERIFY(bench->dataFile().data);
        QCOMPARE(bench->dataFile().path, bench.path(QStringLiteral("1d.csv")));
    }

    void aDriveThatNeverAnswersNeverStopsTheWindow()
    {
        QVERIFY(staysSmooth("a drive that never answers", [&](Heartbeat& heart) {
            ControllerFixture bench;
            bench.options.timeout = std::chrono::milliseconds(300);
            bench.options.liveInterval = std::chrono::milliseconds(5);
            QVERIFY(bench.connect());
            QVERIFY(bench.prepare2D());
            heart.restart();
            bench.drive().gate.set(DriveGate::Mode::Deaf);
            const auto is = [&](DriveState::Connection connection) {
                return [&bench, connection] {
                    return bench->drives().front().connection == connection;
                };
            };
            const auto idle = [&] { return !bench->busy().isBusy; };
            QVERIFY(waitFor(is(DriveState::Connection::Lost)));
            // It goes on trying.
            QVERIFY(waitFor([&] { return bench.drive().gate.timeouts() >= 3; }));
            bench.drive().gate.set(DriveGate::Mode::Open);
            QVERIFY(waitFor(is(DriveState::Connection::Connected)));
            QVERIFY(waitFor([&] { return bench->action(Action::Write).isEnabled; }));
            bench->planWrite();
            QVERIFY(waitFor(idle));
            bench.drive().gate.setAt(12, DriveGate::Mode::Deaf);
            bench->write();
            QVERIFY(waitFor(idle));
            QVERIFY(bench->isOutcomeAnError());
            bench->refresh();
            bench->setEndpoints({}); // its session ends by itself, some time
            bench.drive().gate.set(DriveGate::Mode::Open);
        }));
    }

    void writingTheLargestTableNeverStopsTheWindow()
    {
        QVERIFY(staysSmooth("writing and activating 518 400 values", [&](Heartbeat& heart) {
            ControllerFixture bench;
            QVERIFY(openLargeFile(bench));
            const auto isIdle = [&] { return !bench->busy().isBusy; };
            const auto table = bench->selectedTable();
            heart.restart();
            bench->planWrite();
            QVERIFY(waitFor(isIdle));
            QVERIFY(bench->plan().has_value());
            bench->write();
            QVERIFY(waitFor(isIdle));
            QVERIFY2(!bench->isOutcomeAnError(), qPrintable(bench->outcome()));
            QVERIFY(waitFor([&] { return bench->driveTable() == table; }));
            bench->activate();
            QVERIFY(waitFor(isIdle));
            QVERIFY(bench->proof().has_value());
            bench->deactivate();
            QVERIFY(waitFor(isIdle));
        }));
    }

    void choosingAmongLargeTablesNeverStopsTheWindow()
    {
        QVERIFY(staysSmooth("choosing tables of 518 400 values", [&](Heartbeat& heart) {
            ControllerFixture bench;
            QVERIFY(openLargeFile(bench));
            heart.restart();
            QStringList sentences;
            for (int round = 0; round < 40; ++round) {
                bench->setup().setTable({round % 2});
                sentences.append(bench->signSentence());
                QCOMPARE(bench->selectedTableBytes(), std::size_t{128 + 720 * 720 * 4});
                const int beats = heart.beats();
                QVERIFY(waitFor([&] { return heart.beats() > beats; }));
            }
            QCOMPARE(sentences.removeDuplicates(), 38);
            bench->closeData(); // and the large tables with it
        }));
    }

    void choosingAxesNeverStopsTheWindow()
    {
        QVERIFY(staysSmooth("choosing axes", [&](Heartbeat& heart) {
            ControllerFixture bench;
            QVERIFY(openLargeFile(bench));
            QVERIFY(bench.planAndWrite());
            heart.restart();
            for (int round = 1; round <= 6; ++round) {
                bench->selectAxis(round % 2);
                QVERIFY(waitFor([&] { return bench->status().has_value(); }));
                const bool hasTable = round % 2 == 0;
                QVERIFY(waitFor([&] { return (bench->driveTable() != nullptr) == hasTable; }));
            }
        }));
    }

    void anotherLanguageNeverStopsTheWindow()
    {
        QVERIFY(staysSmooth("another language", [&](Heartbeat& heart) {
            ControllerFixture bench;
            QVERIFY(openLargeFile(bench));
            QVERIFY(bench.planAndWrite());
            for (int line = 0; line < 1'000; ++line)
                bench->planWrite(); // refused: the log is full of sentences
            bench->chooseSource(1, QStringLiteral("Axes[0]/Nothing"));
            QVERIFY(waitFor([&] { return !bench->isSourceBeingChecked(1); }));
            QCOMPARE(bench->log().size(), std::size_t{1000});
            heart.restart();
            for (int round = 0; round < 5; ++round) {
                const test::Brackets language;
                bench->retranslate();
                const int beats = heart.beats();
                QVERIFY(waitFor([&] { return heart.beats() > beats; }));
            }
            bench->retranslate();
        }));
    }

    void theEndTakesNoLongerWithManyDrivesThatHang()
    {
        ControllerFixture bench;
        bench.options.timeout = std::chrono::milliseconds(1'000);
        QStringList endpoints;
        for (int i = 0; i < 8; ++i) {
            const QString endpoint = QStringLiteral("http://drive%1").arg(i);
            bench.addDrive(endpoint.toStdString(), ControllerFixture::xyDrive())
                .gate.set(DriveGate::Mode::Deaf);
            endpoints.append(endpoint);
        }
        bench->setEndpoints(endpoints);
        for (const QString& endpoint : endpoints)
            QTRY_COMPARE(bench.drive(endpoint.toStdString()).gate.waiting(), 1);
        bench.endController();
        int timeouts = 0;
        for (const QString& endpoint : endpoints)
            timeouts += bench.drive(endpoint.toStdString()).gate.timeouts();
        // Each was waited for once, all at the same time.
        QVERIFY(timeouts <= 8);
    }
};

AXISCOMP_TEST(TestWizardHeartbeat)

} // namespace tst_wizardheartbeat

#include "tst_wizardheartbeat.moc"
