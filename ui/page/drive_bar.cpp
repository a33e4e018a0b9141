// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/drive_bar.h"

#include "ui/controller/wizard_controller.h"
#include "ui/style/contrast.h"
#include "ui/style/plain_label.h"
#include "ui/style/symbols.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>

namespace axiscomp::ui {

namespace {

constexpr int driveSymbolSize = 16;

QString driveText(const DriveState& drive)
{
    if (drive.isDemo)
        return DriveBar::tr("%1 (demo)").arg(drive.name);
    return drive.name.isEmpty() ? drive.endpoint
                                : drive.name + QStringLiteral("   ") + drive.endpoint;
}

QPushButton* barButton(const char* name, Symbol symbol)
{
    auto* button = new QPushButton;
    button->setObjectName(QLatin1StringView(name));
    button->setIcon(symbolIcon(symbol));
    button->setAutoDefault(true);
    return button;
}

} // namespace

DriveBar::DriveBar(WizardController& controller, QMenu& menu, QWidget* parent)
    : QWidget(parent)
    , m_controller(controller)
    , m_label(new PlainLabel)
    , m_drives(new QComboBox)
    , m_connections(barButton("connectionsButton", Symbol::Connections))
    , m_refresh(barButton("refreshButton", Symbol::Refresh))
    , m_symbol(new PlainLabel)
    , m_state(new PlainLabel)
    , m_menuButton(new QToolButton)
{
    setObjectName(QStringLiteral("driveBar"));
    m_drives->setObjectName(QStringLiteral("driveField"));
    m_drives->setMinimumContentsLength(28);
    m_drives->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_label->setBuddy(m_drives);
    m_state->setObjectName(QStringLiteral("driveState"));
    m_menuButton->setObjectName(QStringLiteral("menuButton"));
    m_menuButton->setIcon(symbolIcon(Symbol::Menu));
    m_menuButton->setAutoRaise(true);
    m_menuButton->setPopupMode(QToolButton::InstantPopup);
    m_menuButton->setMenu(&menu);
    m_menuButton->setFocusPolicy(Qt::TabFocus);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(m_label);
    layout->addWidget(m_drives, 3);
    layout->addWidget(m_connections);
    layout->addWidget(m_refresh);
    layout->addSpacing(8);
    layout->addWidget(m_symbol);
    layout->addWidget(m_state, 2);
    layout->addWidget(m_menuButton);
    connect(m_drives, &QComboBox::activated, this, [this](int index) {
        Q_EMIT driveChosen(m_drives->itemData(index).toString());
        showDrives();
    });
    connect(m_connections, &QPushButton::clicked, this, &DriveBar::connectionsRequested);
    connect(m_refresh, &QPushButton::clicked, &controller, &WizardController::refresh);
    connect(&controller, &WizardController::drivesChanged, this, &DriveBar::showDrives);
    connect(&controller, &WizardController::currentAxisChanged, this, &DriveBar::showDrives);
    connect(&controller, &WizardController::actionsChanged, this, &DriveBar::showState);
    retranslate();
}

void DriveBar::retranslate()
{
    m_label->setText(tr("&Drive"));
    m_drives->setAccessibleName(tr("Drive"));
    m_drives->setAccessibleDescription(tr("The drive of the chosen axis, and its address"));
    m_drives->setToolTip(tr("The drive of the selected axis; lists all drives under Connections"));
    m_connections->setText(tr("Co&nnections…"));
    m_connections->setToolTip(tr("Add, test or remove drives"));
    m_refresh->setText(tr("&Refresh"));
    m_menuButton->setToolTip(tr("More: language, log, settings"));
    m_menuButton->setAccessibleName(tr("Menu"));
    showDrives();
}

QString DriveBar::currentEndpoint() const
{
    const int axis = m_controller.currentAxis();
    if (axis >= 0)
        return m_controller.axes().at(static_cast<std::size_t>(axis)).endpoint;
    const auto& drives = m_controller.drives();
    return drives.empty() ? QString() : drives.front().endpoint;
}

void DriveBar::showDrives()
{
    const QSignalBlocker blocker(m_drives);
    const auto& drives = m_controller.drives();
    const int count = static_cast<int>(drives.size());
    // In place: a drive that is connecting changes every second, and the list may be open.
    for (int row = 0; row < count; ++row) {
        const DriveState& drive = drives[static_cast<std::size_t>(row)];
        if (row == m_drives->count())
            m_drives->addItem(QString());
        m_drives->setItemText(row, driveText(drive));
        m_drives->setItemData(row, drive.endpoint);
    }
    while (m_drives->count() > count)
        m_drives->removeItem(count);
    m_drives->setCurrentIndex(m_drives->findData(currentEndpoint()));
    m_drives->setPlaceholderText(tr("no drive"));
    m_drives->setEnabled(m_drives->count() > 0);
    showState();
}

void DriveBar::showState()
{
    Symbol symbol = Symbol::Information;
    Tone tone = Tone::Information;
    QString text = tr("no drive: add one under Connections");
    QString problem;
    for (const DriveState& drive : m_controller.drives()) {
        if (drive.endpoint != currentEndpoint())
            continue;
        problem = drive.problem;
        switch (drive.connection) {
        case DriveState::Connection::Connecting:
            text = tr("connecting …");
            break;
        case DriveState::Connection::Connected:
            symbol = Symbol::Success;
            tone = Tone::Success;
            text = tr("connected");
            break;
        case DriveState::Connection::Lost:
            symbol = Symbol::Error;
            tone = Tone::Error;
            text = tr("connection lost, reconnecting");
            break;
        }
    }
    m_symbol->setPixmap(
        symbolPixmap(symbol, frameColor(tone, palette()), driveSymbolSize, devicePixelRatioF()));
    m_state->setText(text);
    m_state->setToolTip(problem);
    const ActionState refresh = m_controller.action(Action::Refresh);
    m_refresh->setEnabled(refresh.isEnabled);
    m_refresh->setToolTip(refresh.isEnabled || refresh.reason.isEmpty()
            ? tr("Search for axes again and read everything from the drives (F5)")
            : refresh.reason);
}

} // namespace axiscomp::ui
