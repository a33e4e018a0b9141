// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/patience.h"
#include "tests/ui/support/page_stage.h"

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QSettings>
#include <QTest>

#include <array>
#include <functional>

namespace axiscomp::test {

inline constexpr QSize pageSize(1280, 720);

inline void wait(const std::function<bool()>& condition, const char* what)
{
    if (!QTest::qWaitFor(condition, patienceMs))
        qFatal("waited in vain for %s", what);
}

/// A page on a stage, brought into a state by what a user would do.
class PageScene {
public:
    explicit PageScene(bool isHomed = true)
        : m_stage(isHomed)
        , m_settings(m_stage.path(QStringLiteral("settings.ini")), QSettings::IniFormat)
        , m_wizard(std::make_unique<ui::CompensationWizard>(m_stage.options(), &m_settings))
    {
        m_wizard->resize(pageSize);
    }

    PageStage& stage() { return m_stage; }
    ui::CompensationWizard& page() { return *m_wizard; }
    ui::WizardController& controller() { return m_wizard->controller(); }

    void showDrive(bool isDemo = false)
    {
        if (!isDemo)
            controller().setEndpoints({PageStage::endpoint()});
        m_wizard->show();
        wait([this] { return controller().status().has_value(); }, "the drive's state");
    }
    void click(const char* name)
    {
        auto* button = m_wizard->findChild<QAbstractButton*>(QLatin1StringView(name));
        if (!QTest::qWaitFor(
                [&] { return button && button->isEnabled() && button->isVisible(); }, patienceMs))
            qFatal("%s cannot be clicked: %s; %s", name, qPrintable(controller().hint()),
                qPrintable(controller().outcome()));
        button->click();
    }
    void chooseSources(int count)
    {
        const std::array<std::string, 3> paths{PageStage::masterPosition(0),
            PageStage::masterPosition(1), "Application/Variables/Floats[0]"};
        for (int n = 0; n < count; ++n) {
            controller().chooseSource(
                n + 1, QString::fromStdString(paths.at(static_cast<std::size_t>(n))));
            wait(
                [&] {
                    return controller()
                        .setup()
                        .edited()
                        .sources.at(static_cast<std::size_t>(n))
                        .isSet();
                },
                "a source");
        }
    }
    void openData(const QString& path)
    {
        m_wizard->openData(path);
        wait(
            [&] {
                const ui::DataFile& file = controller().dataFile();
                return !file.isReading && (file.data || !file.problems.empty());
            },
            "the file");
    }
    /// AN140 figure 2: everything chosen, nothing written.
    void choose2D(Persistency persistency = Persistency::Persistent)
    {
        showDrive();
        controller().setup().setDimensionality(2);
        chooseSources(2);
        openData(m_stage.superData());
        controller().setup().setTable({0});
        controller().setup().setPersistency(persistency);
        wait([this] { return controller().action(ui::Action::Write).isEnabled; }, "Write");
    }
    void write()
    {
        click("writeButton");
        click("confirmWriteButton");
        wait([this] { return !controller().busy().isBusy && !controller().setup().isDirty(); },
            "the end of the write");
    }
    /// The dialog for a TAM configuration, its first station confirmed to be the drive.
    void beginConfiguration(const QString& file, const char* action)
    {
        m_wizard->setFilePicker(
            [file](QWidget&, const ui::FileQuestion&,
                const std::function<void(const QString&)>& answer) { answer(file); });
        m_wizard->findChild<QAction*>(QLatin1StringView(action))->trigger();
        auto* stations = m_wizard->findChild<QComboBox*>(QStringLiteral("stationField"));
        wait([&] { return stations->isEnabled(); }, "the stations");
        stations->setCurrentIndex(0);
        Q_EMIT stations->activated(0);
        click("acceptOtherStation");
    }
    void settle()
    {
        wait([this] { return !controller().busy().isBusy; }, "the end");
        QTest::qWait(150);
    }

private:
    PageStage m_stage;
    QSettings m_settings;
    std::unique_ptr<ui::CompensationWizard> m_wizard;
};

} // namespace axiscomp::test
