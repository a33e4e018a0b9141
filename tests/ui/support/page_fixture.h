// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/wizard/wizard_window.h"
#include "drivecomm/link_factory.h"
#include "drivecomm/profile/profile_loader.h"
#include "drivecomm/virtualdrive/web/web_server.h"
#include "tests/support/compensator_fixture.h"
#include "tests/support/patience.h"
#include "tests/support/verify.h"
#include "tests/ui/support/page_user.h"
#include "ui/controller/wizard_settings.h"

#include <QFile>
#include <QSettings>
#include <QTemporaryDir>

namespace axiscomp::test {

/// A virtual drive behind its web server on loopback, which can be stopped and started again.
class ServedDrive {
public:
    explicit ServedDrive(drivecomm::VirtualDriveOptions options)
        : drive(drivecomm::genericProfile(), std::move(options))
    {
        start();
    }

    void start()
    {
        drivecomm::WebServerOptions options;
        options.port = m_port;
        auto started =
            drivecomm::WebServer::start(drive, drivecomm::genericProfile(), faults, options);
        if (!started)
            qFatal("%s", describe(started.error()).c_str());
        m_server = std::move(*started);
        m_port = m_server->port();
    }
    void stop() { m_server.reset(); }
    [[nodiscard]] QString url() const { return QStringLiteral("http://127.0.0.1:%1").arg(m_port); }
    [[nodiscard]] std::string text(const std::string& path)
    {
        const auto readings = drive.readRegisters({path});
        return readings ? toText(readings->front().value) : "no such register";
    }

    drivecomm::VirtualDrive drive;
    drivecomm::FaultPlan faults;

private:
    std::uint16_t m_port = 0;
    std::unique_ptr<drivecomm::WebServer> m_server;
};

/// The program's window, a drive with the axes X and Y, and the person before it.
class PageFixture {
public:
    PageFixture() : PageFixture(twoAxes()) { }
    /// adjust: gets the options of the window before it is made.
    explicit PageFixture(drivecomm::VirtualDriveOptions options,
        const QString& language = QStringLiteral("en"),
        const DriveProfile& profile = drivecomm::genericProfile(),
        const std::function<void(ui::WizardOptions&)>& adjust = {})
        : served(std::move(options))
        , settings(path(QStringLiteral("settings.ini")), QSettings::IniFormat)
        , window(wizardOptions(profile, adjust), inLanguage(settings, language))
        , wizard(window.wizard())
        , user(window)
    {
        window.resize(1280, 860);
        wizard.setFilePicker([this](QWidget&, const ui::FileQuestion& question,
                                 const std::function<void(const QString&)>& answer) {
            questions.push_back(question);
            if (!picked.isEmpty())
                answer(picked);
        });
    }

    static drivecomm::VirtualDriveOptions twoAxes(bool isHomed = true)
    {
        drivecomm::VirtualDriveOptions options;
        options.name = "Stage-7";
        options.serialNumber = 1559;
        options.axes = {{"X", "Millimeter", 0.0, 40.0, 17.0, isHomed},
            {"Y", "Millimeter", 0.0, 30.0, 13.0, isHomed}};
        return options;
    }

    [[nodiscard]] ui::WizardController& controller() { return wizard.controller(); }
    /// The window on the drive, its first axis read.
    [[nodiscard]] bool open()
    {
        controller().setEndpoints({served.url()});
        return user.isThere()
            && QTest::qWaitFor([this] { return controller().status().has_value(); }, patienceMs);
    }
    [[nodiscard]] bool idle()
    {
        return QTest::qWaitFor([this] { return !controller().busy().isBusy; }, patienceMs);
    }
    /// What the page says about the last operation.
    [[nodiscard]] QString outcome() { return user.message("outcomeMessage"); }
    [[nodiscard]] bool saysOutcome(const QString& part)
    {
        return idle() && QTest::qWaitFor([&] { return outcome().contains(part); }, patienceMs);
    }

    /// 2D over both axes with the file's first table chosen, by the person; nothing is written.
    [[nodiscard]] bool choose2D()
    {
        picked = superData();
        if (!user.choose("dimensionalityField", QStringLiteral("2D")) || !user.click("openButton"))
            return false;
        for (const int n : {1, 2}) {
            const QByteArray field = "source" + QByteArray::number(n) + "Field";
            if (!user.enter(field, QString::fromStdString(n == 1 ? masterX : masterY)))
                return false;
        }
        const bool mayWrite = QTest::qWaitFor(
            [this] { return controller().action(ui::Action::Write).isEnabled; }, patienceMs);
        if (!mayWrite)
            qInfo("cannot write: %s", qPrintable(user.hint()));
        return mayWrite;
    }
    /// From the list that is shown before.
    [[nodiscard]] bool write()
    {
        return user.click("writeButton") && user.click("confirmWriteButton") && idle();
    }

    /// The axis has the first table of the file.
    [[nodiscard]] bool openWritten() { return open() && choose2D() && write(); }

    [[nodiscard]] QString path(const QString& name) const { return folder.filePath(name); }
    [[nodiscard]] QString file(const QString& name, const QByteArray& content) const
    {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
            qFatal("cannot write %s", qPrintable(file.fileName()));
        return file.fileName();
    }
    /// 2D in millimetres: "first" and "second". seed makes another one.
    [[nodiscard]] QString superData(int seed = 1) const
    {
        QByteArray text = "X [mm],Y [mm],first [mm],second [mm]\n";
        for (int y = 0; y <= 30; y += 5) {
            for (int x = 0; x <= 40; x += 4) {
                const double value = 0.002 * std::sin(x / 6.0 + y / 9.0 + seed);
                text += QByteArray::number(x) + ',' + QByteArray::number(y) + ','
                    + QByteArray::number(value, 'f', 7) + ',' + QByteArray::number(-value, 'f', 7)
                    + '\n';
            }
        }
        return file(QStringLiteral("super-%1.csv").arg(seed), text);
    }
    /// Everything that the axis has on the drive.
    [[nodiscard]] CompensatorFixture::State state(int axis = 0)
    {
        return CompensatorFixture::stateOf(served.drive, axis);
    }

    QTemporaryDir folder;
    ServedDrive served;
    QSettings settings;
    QString picked; ///< what the file dialog answers; empty: the person gives up
    std::vector<ui::FileQuestion> questions;
    app::WizardWindow window;
    ui::CompensationWizard& wizard;
    PageUser user;

private:
    static QSettings& inLanguage(QSettings& settings, const QString& language)
    {
        ui::WizardSettings(&settings).setLanguage(language);
        return settings;
    }
    [[nodiscard]] ui::WizardOptions wizardOptions(
        const DriveProfile& profile, const std::function<void(ui::WizardOptions&)>& adjust) const
    {
        ui::WizardOptions options;
        options.profile = &profile;
        options.storeRoot = std::filesystem::path(folder.path().toStdString()) / "store";
        options.timeout = std::chrono::seconds(10);
        options.liveInterval = std::chrono::milliseconds(50);
        options.reconnectInterval = std::chrono::milliseconds(100);
        options.linkFactory = drivecomm::linkFactory(drivecomm::genericProfile());
        options.portCandidates = [](const std::vector<std::string>&, bool) {
            return std::vector<DriveCandidate>();
        };
        if (adjust)
            adjust(options);
        return options;
    }
};

} // namespace axiscomp::test
