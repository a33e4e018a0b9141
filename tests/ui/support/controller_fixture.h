// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/profile/profile_loader.h"
#include "tests/support/compensator_fixture.h"
#include "tests/support/faulty_link.h"
#include "tests/support/patience.h"
#include "tests/ui/support/gate_link.h"
#include "ui/controller/wizard_controller.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <map>

namespace axiscomp::test {

/// One virtual drive with the gate in front of it. Its time passes only when it is asked something.
struct GatedDrive {
    explicit GatedDrive(drivecomm::VirtualDriveOptions options)
        : drive(drivecomm::genericProfile(), timed(std::move(options)))
    {
    }
    drivecomm::VirtualDriveOptions timed(drivecomm::VirtualDriveOptions options)
    {
        options.clock = [this] {
            return std::chrono::nanoseconds(std::chrono::milliseconds(++milliseconds));
        };
        return options;
    }

    [[nodiscard]] std::string text(const std::string& path)
    {
        const auto readings = drive.readRegisters({path});
        return readings ? toText(readings->front().value) : "no such register";
    }
    void set(const std::string& path, const RegisterValue& value)
    {
        const auto written = drive.writeRegisters({{path, value}});
        QVERIFY2(written.has_value(), path.c_str());
    }

    std::atomic<std::int64_t> milliseconds = 0;
    drivecomm::VirtualDrive drive;
    DriveGate gate;
    /// Of the link that is used now; only while nothing runs.
    std::atomic<FaultyLink*> faults = nullptr;
};

/// A controller, the drives at its endpoints, and folders for both.
class ControllerFixture {
public:
    ControllerFixture()
    {
        options = makeOptions();
        addDrive("http://x", xyDrive());
    }
    ~ControllerFixture() { m_controller.reset(); }

    static drivecomm::VirtualDriveOptions xyDrive()
    {
        drivecomm::VirtualDriveOptions options;
        options.name = "Test-1";
        options.serialNumber = 4711;
        options.axes = {{.name = "X"}, {.name = "Y", .periodSeconds = 37.0}};
        return options;
    }
    /// In place of the one that was there: links to that one stay valid.
    GatedDrive& addDrive(const std::string& endpoint, drivecomm::VirtualDriveOptions driveOptions)
    {
        const std::lock_guard lock(m_mutex);
        m_allDrives.push_back(std::make_unique<GatedDrive>(std::move(driveOptions)));
        m_drives[endpoint] = m_allDrives.back().get();
        return *m_allDrives.back();
    }
    GatedDrive& drive(const std::string& endpoint = "http://x")
    {
        const std::lock_guard lock(m_mutex);
        return *m_drives.at(endpoint);
    }

    /// Before the first use of controller().
    ui::WizardOptions options;
    ui::WizardController& controller()
    {
        if (!m_controller)
            m_controller = std::make_unique<ui::WizardController>(options);
        return *m_controller;
    }
    ui::WizardController* operator->() { return &controller(); }
    void endController() { m_controller.reset(); }

    /// The drive at http://x with its axis X, read.
    [[nodiscard]] bool connect()
    {
        controller().setEndpoints({QStringLiteral("http://x")});
        return QTest::qWaitFor([this] { return controller().status().has_value(); }, patienceMs);
    }
    [[nodiscard]] bool idle()
    {
        return QTest::qWaitFor([this] { return !controller().busy().isBusy; }, patienceMs);
    }
    [[nodiscard]] bool fileRead()
    {
        return QTest::qWaitFor([this] { return !controller().dataFile().isReading; }, patienceMs);
    }
    /// The result of live values that are asked for now.
    [[nodiscard]] bool readLive()
    {
        bool isRead = false;
        QObject context;
        QObject::connect(
            &controller(), &ui::WizardController::liveChanged, &context, [&] { isRead = true; });
        controller().refreshLive();
        return QTest::qWaitFor([&] { return isRead; }, patienceMs);
    }
    [[nodiscard]] bool planAndWrite()
    {
        bool isReady = false;
        QObject context;
        QObject::connect(
            &controller(), &ui::WizardController::planReady, &context, [&] { isReady = true; });
        controller().planWrite();
        if (!QTest::qWaitFor([&] { return isReady || !controller().busy().isBusy; }, patienceMs)
            || !isReady)
            return false;
        controller().write();
        return idle();
    }
    /// What restoring the previous state would change is known.
    [[nodiscard]] bool planRestoration()
    {
        controller().planRestoration();
        return idle() && controller().plan() && controller().plannedRestoration();
    }
    [[nodiscard]] bool restorePrevious()
    {
        if (!planRestoration())
            return false;
        controller().write();
        return idle();
    }
    void chooseMasterSources(int dimensions = 2)
    {
        controller().setup().setDimensionality(dimensions);
        controller().chooseSource(1, QString::fromStdString(masterX));
        if (dimensions > 1)
            controller().chooseSource(2, QString::fromStdString(masterY));
    }
    /// 2D data over masterX and masterY, chosen for the axis and ready to be written.
    [[nodiscard]] bool prepare2D(int seed = 1)
    {
        chooseMasterSources();
        controller().openData(file(QStringLiteral("2d-%1.csv").arg(seed), calibration2D(seed)));
        return fileRead() && controller().action(ui::Action::Write).isEnabled;
    }

    [[nodiscard]] static QByteArray calibration2D(int seed)
    {
        CalibrationData data;
        data.tables = {exampleTable(2, seed), exampleTable(2, seed + 100)};
        data.tables[0].unit = data.tables[1].unit = "mm";
        data.grid = data.tables[0].grid;
        for (std::size_t n = 0; n < 2; ++n) {
            data.grid.axes[n].name = n == 0 ? "X" : "Y";
            data.grid.axes[n].unit = "mm";
            data.grid.axes[n].distance *= 2.5; // wherever the axes are
        }
        for (CompensationTable& table : data.tables)
            table.grid = data.grid;
        return QByteArray::fromStdString(writeCalibrationCsv(data));
    }
    [[nodiscard]] QString path(const QString& name) const { return m_folder.filePath(name); }
    [[nodiscard]] QString file(const QString& name, const QByteArray& content) const
    {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
            qFatal("cannot write %s", qPrintable(file.fileName()));
        return file.fileName();
    }
    [[nodiscard]] DriveStore store() const { return DriveStore(storeRoot()); }

private:
    [[nodiscard]] std::filesystem::path storeRoot() const
    {
        return std::filesystem::path(m_folder.path().toStdString()) / "store";
    }
    ui::WizardOptions makeOptions()
    {
        ui::WizardOptions made;
        made.profile = &drivecomm::genericProfile();
        made.storeRoot = storeRoot();
        made.timeout = std::chrono::seconds(20);
        made.liveInterval = std::chrono::milliseconds(0);
        made.reconnectInterval = std::chrono::milliseconds(20);
        made.linkFactory = [this](const std::string& endpoint) { return link(endpoint); };
        return made;
    }
    Result<std::unique_ptr<DriveLink>> link(const std::string& endpoint)
    {
        const std::lock_guard lock(m_mutex);
        const auto found = m_drives.find(endpoint);
        if (found == m_drives.end())
            return fail(ErrorCode::InvalidEndpoint,
                {{"endpoint", endpoint}, {"reason", Verbatim{"unknown"}}});
        auto faulty = std::make_unique<FaultyLink>(found->second->drive);
        found->second->faults = faulty.get();
        return std::make_unique<GateLink>(std::move(faulty), found->second->gate);
    }

    QTemporaryDir m_folder;
    std::mutex m_mutex;
    std::vector<std::unique_ptr<GatedDrive>> m_allDrives;
    std::map<std::string, GatedDrive*> m_drives;
    std::unique_ptr<ui::WizardController> m_controller;
};

} // namespace axiscomp::test
