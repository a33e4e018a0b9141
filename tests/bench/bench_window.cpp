// SPDX-License-Identifier: GPL-3.0-or-later
// A file of 20 MB opened in the window, drawn offscreen, until its picture stands: the last
// painting of the picture before a quarter of a second without one.
#include "drivecomm/link_factory.h"
#include "drivecomm/profile/profile_loader.h"
#include "ui/compensation_wizard.h"
#include "ui/controller/wizard_controller.h"
#include "ui/drawing/custom_plot.h"

#include <benchmark/benchmark.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>

#include <cmath>
#include <functional>

namespace {

using namespace axiscomp;
using namespace axiscomp::ui;

constexpr int size = 720;
constexpr int patienceMs = 30'000;
constexpr int stillnessMs = 250;

/// When the picture was painted last.
class Paintings : public QObject {
public:
    Paintings() { qApp->installEventFilter(this); }
    void begin()
    {
        m_since.start();
        m_last = -1;
        m_isExpected = false;
    }
    /// From now on there is what is to be seen.
    void expect() { m_isExpected = true; }
    [[nodiscard]] bool stands() const
    {
        return m_last >= 0 && m_since.nsecsElapsed() - m_last > 1'000'000LL * stillnessMs;
    }
    [[nodiscard]] double seconds() const { return 1e-9 * static_cast<double>(m_last); }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (m_isExpected && event->type() == QEvent::Paint
            && qobject_cast<QCustomPlot*>(watched) != nullptr)
            QMetaObject::invokeMethod(
                this, [this] { m_last = m_since.nsecsElapsed(); }, Qt::QueuedConnection);
        return false;
    }

private:
    QElapsedTimer m_since;
    qint64 m_last = -1;
    bool m_isExpected = false;
};

bool waitFor(const std::function<bool()>& condition)
{
    QElapsedTimer timer;
    timer.start();
    while (!condition() && timer.elapsed() < patienceMs)
        QApplication::processEvents(QEventLoop::WaitForMoreEvents, 20);
    return condition();
}

QString largeFile(const QTemporaryDir& folder)
{
    QFile file(folder.filePath(QStringLiteral("large.csv")));
    QByteArray text = "X [mm],Y [mm],dX [mm],dY [mm]\n";
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const double value = 0.002 * std::sin(0.01 * x) * std::cos(0.013 * y);
            text += QByteArray::number(0.25 * x, 'f', 4) + ','
                + QByteArray::number(0.25 * y, 'f', 4) + ',' + QByteArray::number(value, 'f', 12)
                + ',' + QByteArray::number(-value, 'f', 12) + '\n';
        }
    }
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size() ? file.fileName()
                                                                              : QString();
}

WizardOptions optionsIn(const QTemporaryDir& folder)
{
    WizardOptions options;
    options.profile = &drivecomm::genericProfile();
    options.storeRoot = folder.filePath(QStringLiteral("store")).toStdString();
    options.liveInterval =
        std::chrono::milliseconds(0); // their cross-hair is painted again and again
    options.linkFactory = drivecomm::linkFactory(drivecomm::genericProfile());
    return options;
}

void openFileUntilDrawn(benchmark::State& state)
{
    const QTemporaryDir folder;
    const QString path = largeFile(folder);
    Paintings paintings;
    for (auto _ : state) {
        CompensationWizard wizard(optionsIn(folder), nullptr);
        wizard.resize(1366, 768);
        wizard.controller().setEndpoints({QStringLiteral("demo:")});
        wizard.show();
        const auto isConnected = [&] { return wizard.controller().status().has_value(); };
        if (path.isEmpty() || !waitFor(isConnected)) {
            state.SkipWithError("no file, or no drive");
            break;
        }
        paintings.begin();
        QObject::connect(
            &wizard.controller(), &WizardController::selectedTableChanged, &paintings, [&] {
                if (wizard.controller().selectedTable() != nullptr)
                    paintings.expect();
            });
        wizard.controller().openDataAs(path, 2);
        if (!waitFor([&] { return paintings.stands(); })) {
            state.SkipWithError("it was not drawn");
            break;
        }
        state.SetIterationTime(paintings.seconds());
    }
}

BENCHMARK(openFileUntilDrawn)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(1);

} // namespace

int main(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
