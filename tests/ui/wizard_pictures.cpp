// SPDX-License-Identifier: GPL-3.0-or-later
// Renders every state of the page into PNG files, for a person to look at:
// wizard-pictures FOLDER [STATE...]. QT_SCALE_FACTOR makes them larger, AXISCOMP_LONG_TEXTS makes
// every text longer than any language needs.
#include "tests/ui/wizard_stage.h"
#include "ui/language.h"

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSettings>
#include <QStyleFactory>
#include <QTextStream>
#include <QTranslator>
#include <QTreeWidget>

using namespace axiscomp;
using namespace axiscomp::ui;
using axiscomp::test::WizardStage;

namespace {

constexpr QSize pageSize(1280, 720);
constexpr int patienceMs = 20'000;

void wait(const std::function<bool()>& condition, const char* what)
{
    if (!QTest::qWaitFor(condition, patienceMs))
        qFatal("waited in vain for %s", what);
}

class LongTexts final : public QTranslator {
public:
    [[nodiscard]] bool isEmpty() const override { return false; }
    [[nodiscard]] QString translate(
        const char* context, const char* text, const char*, int) const override
    {
        const QString source = QString::fromUtf8(text);
        const bool isOwn = QByteArray(context).startsWith("axiscomp");
        return isOwn ? source + u' ' + source.left(1 + source.size() / 3).remove(u'&').remove(u'%')
                     : QString();
    }
};

/// A page on a stage, brought into a state by what a user would do.
class Scene {
public:
    explicit Scene(bool isHomed = true)
        : m_stage(isHomed)
        , m_settings(m_stage.path(QStringLiteral("settings.ini")), QSettings::IniFormat)
        , m_wizard(std::make_unique<CompensationWizard>(m_stage.options(), &m_settings))
    {
        m_wizard->resize(pageSize);
    }

    WizardStage& stage() { return m_stage; }
    CompensationWizard& page() { return *m_wizard; }
    WizardController& controller() { return m_wizard->controller(); }

    void showDrive(bool isDemo = false)
    {
        if (!isDemo)
            controller().setEndpoints({WizardStage::endpoint()});
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
        const std::array<std::string, 3> paths{WizardStage::masterPosition(0),
            WizardStage::masterPosition(1), "Axes[0]/Signals/General/MotorTemperature"};
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
                const DataFile& file = controller().dataFile();
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
        wait([this] { return controller().action(Action::Write).isEnabled; }, "Write");
    }
    void write()
    {
        click("writeButton");
        click("confirmWriteButton");
        wait([this] { return !controller().busy().isBusy && !controller().setup().isChanged(); },
            "the end of the write");
    }
    void settle()
    {
        wait([this] { return !controller().busy().isBusy; }, "the end");
        QTest::qWait(150);
    }

private:
    WizardStage m_stage;
    QSettings m_settings;
    std::unique_ptr<CompensationWizard> m_wizard;
};

void firstStart(Scene& scene)
{
    scene.showDrive(true);
    scene.settle();
}

void unwritten2D(Scene& scene)
{
    scene.choose2D();
    scene.settle();
}

void writePreview(Scene& scene)
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

void writing(Scene& scene)
{
    unwritten2D(scene);
    scene.stage().gate().holdUploads();
    scene.click("writeButton");
    scene.click("confirmWriteButton");
    wait([&] { return scene.controller().isWriting() && scene.controller().busy().fraction > 0.1; },
        "the upload");
    QTest::qWait(150);
}

void closingWhileWriting(Scene& scene)
{
    writing(scene);
    static_cast<void>(scene.page().mayClose());
    QTest::qWait(50);
}

void active(Scene& scene)
{
    scene.choose2D();
    scene.write();
    scene.click("activateButton");
    wait([&] { return scene.controller().proof().has_value(); }, "the proof");
    scene.settle();
}

void badFile(Scene& scene)
{
    scene.showDrive();
    scene.controller().setup().setDimensionality(2);
    scene.chooseSources(2);
    scene.openData(scene.stage().file(QStringLiteral("measurement.csv"),
        "X [mm],Y [mm],table "
        "1\n0,0,0.001\n10,0,0.0O2\n20,0,0.001\n0,10,nan\n10,10\n20,10,0.002\n"));
    scene.settle();
}

void driveRefuses(Scene& scene)
{
    scene.choose2D();
    scene.stage().gate().refuseUploads(
        Error{ErrorCode::TableRefused, {{"reason", "Crc does not match the elements"}}, {}});
    scene.click("writeButton");
    scene.click("confirmWriteButton");
    wait([&] { return scene.controller().isOutcomeAnError(); }, "the refusal");
    scene.settle();
}

void flashWear(Scene& scene)
{
    scene.choose2D();
    for (int n = 0; scene.controller().flashOperationsLeft() > 0 && n < 20; ++n) {
        scene.controller().setup().setTable({n % 2});
        scene.write();
    }
    scene.controller().setup().setTable({1});
    scene.controller().setup().setPersistency(Persistency::Persistent);
    scene.settle();
}

void notHomed(Scene& scene)
{
    scene.choose2D(Persistency::Volatile);
    scene.write();
    scene.settle();
}

void table3D(Scene& scene)
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

void connectionLost(Scene& scene)
{
    unwritten2D(scene);
    scene.stage().gate().cut(true);
    wait(
        [&] {
            return scene.controller().drives().front().connection == DriveState::Connection::Lost;
        },
        "the loss");
    QTest::qWait(100);
}

void otherAxis(Scene& scene)
{
    unwritten2D(scene);
    auto* axes = scene.page().findChild<QComboBox*>(QStringLiteral("axisField"));
    Q_EMIT axes->activated(1);
    scene.page().findChild<QAbstractButton*>(QStringLiteral("logButton"))->click();
    scene.settle();
}

void connections(Scene& scene)
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

struct State {
    const char* name;
    std::function<void(Scene&)> make;
    bool isHomed = true;
};

const std::vector<State>& states()
{
    static const std::vector<State> all{
        {"first-start", firstStart},
        {"unwritten-2d", unwritten2D},
        {"write-preview", writePreview},
        {"writing", writing},
        {"closing-while-writing", closingWhileWriting},
        {"active", active},
        {"bad-file", badFile},
        {"drive-refuses", driveRefuses},
        {"flash-wear", flashWear},
        {"not-homed", notHomed, false},
        {"table-3d", table3D},
        {"connection-lost", connectionLost},
        {"other-axis", otherAxis},
        {"connections", connections},
    };
    return all;
}

QPalette darkPalette()
{
    QPalette palette;
    const QColor window(0x2b, 0x2d, 0x30);
    const QColor base(0x1f, 0x20, 0x23);
    const QColor text(0xe6, 0xe6, 0xe6);
    for (const auto role : {QPalette::Window, QPalette::Button})
        palette.setColor(role, window);
    for (const auto role : {QPalette::Base, QPalette::ToolTipBase})
        palette.setColor(role, base);
    palette.setColor(QPalette::AlternateBase, QColor(0x26, 0x28, 0x2b));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText,
             QPalette::ToolTipText, QPalette::BrightText})
        palette.setColor(role, text);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, QColor(0x80, 0x82, 0x86));
    palette.setColor(QPalette::PlaceholderText, QColor(0x96, 0x98, 0x9c));
    palette.setColor(QPalette::Highlight, QColor(0x3d, 0x7e, 0xd9));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Link, QColor(0x7a, 0xb0, 0xff));
    palette.setColor(QPalette::Light, QColor(0x45, 0x48, 0x4d));
    palette.setColor(QPalette::Midlight, QColor(0x3a, 0x3d, 0x41));
    palette.setColor(QPalette::Mid, QColor(0x22, 0x24, 0x27));
    palette.setColor(QPalette::Dark, QColor(0x18, 0x19, 0x1b));
    palette.setColor(QPalette::Shadow, QColor(0x0c, 0x0c, 0x0d));
    return palette;
}

void render(const State& state, const QString& file)
{
    Scene scene(state.isHomed);
    state.make(scene);
    scene.page().setFocus();
    auto* dialog = scene.page().findChild<QDialog*>();
    QWidget* shown = &scene.page();
    if (dialog && dialog->isVisible())
        shown = dialog;
    if (!shown->grab().save(file))
        qFatal("cannot write %s", qPrintable(file));
    QTextStream(stdout) << file << Qt::endl;
    scene.stage().gate().release();
}

} // namespace

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    const QStringList arguments = QApplication::arguments().mid(1);
    if (arguments.isEmpty())
        qFatal("usage: wizard-pictures FOLDER [STATE...]");
    const QDir folder(arguments.front());
    if (!folder.mkpath(QStringLiteral(".")))
        qFatal("cannot make %s", qPrintable(folder.path()));
    const QStringList wanted = arguments.mid(1);
    LongTexts longTexts;
    if (qEnvironmentVariableIsSet("AXISCOMP_LONG_TEXTS"))
        QApplication::installTranslator(&longTexts);
    const QPalette light = QApplication::palette();
    const qreal scale = application.devicePixelRatio();
    const QString suffix = scale > 1.0 ? QStringLiteral("-%1").arg(qRound(scale * 100)) : QString();
    for (const QString& language : Language::available()) {
        QLocale::setDefault(QLocale(language));
        for (const bool isDark : {false, true}) {
            QApplication::setPalette(isDark ? darkPalette() : light);
            for (const State& state : states()) {
                const QString name = QString::fromLatin1(state.name);
                if (wanted.isEmpty() || wanted.contains(name))
                    render(state,
                        folder.filePath(
                            QStringLiteral("%1-%2-%3%4.png")
                                .arg(name,
                                    isDark ? QStringLiteral("dark") : QStringLiteral("light"),
                                    language, suffix)));
            }
        }
    }
    return 0;
}
