// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/action_panel.h"

#include "ui/style/contrast.h"
#include "ui/style/plain_label.h"
#include "ui/style/symbols.h"

#include <QAction>
#include <QBoxLayout>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>

namespace axiscomp::ui {

namespace {

constexpr int actionSymbolSize = 16;

QPushButton* pushButton(const char* name)
{
    auto* button = new QPushButton;
    button->setObjectName(QLatin1StringView(name));
    button->setAutoDefault(true);
    return button;
}

} // namespace

ActionPanel::ActionPanel(WizardController& controller, QWidget* parent)
    : QWidget(parent)
    , m_controller(controller)
    , m_write(pushButton("writeButton"))
    , m_revert(pushButton("revertAllButton"))
    , m_activate(pushButton("activateButton"))
    , m_activateMore(pushButton("activateMenuButton"))
    , m_deactivate(pushButton("deactivateButton"))
    , m_menu(new QMenu(this))
    , m_evaluate(m_menu->addAction(QString()))
    , m_restore(m_menu->addAction(QString()))
    , m_backups(m_menu->addAction(QString()))
    , m_delete(m_menu->addAction(QString()))
    , m_hintSymbol(new PlainLabel)
    , m_hint(new PlainLabel)
{
    setObjectName(QStringLiteral("actionPanel"));
    m_menu->setObjectName(QStringLiteral("activateMenu"));
    m_menu->setToolTipsVisible(true);
    m_evaluate->setObjectName(QStringLiteral("evaluateAction"));
    m_restore->setObjectName(QStringLiteral("restoreAction"));
    m_backups->setObjectName(QStringLiteral("backupsAction"));
    m_delete->setObjectName(QStringLiteral("deleteAction"));
    m_activateMore->setMenu(m_menu);
    m_revert->setIcon(symbolIcon(Symbol::Revert));
    m_hint->setObjectName(QStringLiteral("hint"));
    m_hint->setWordWrap(true);
    m_hint->setMinimumHeight(2 * m_hint->fontMetrics().lineSpacing());
    m_hint->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_hint->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);

    auto* activation = new QHBoxLayout;
    activation->setSpacing(0);
    activation->addWidget(m_activate, 1);
    activation->addWidget(m_activateMore);
    auto* hint = new QHBoxLayout;
    hint->setSpacing(8);
    hint->addWidget(m_hintSymbol, 0, Qt::AlignTop);
    hint->addWidget(m_hint, 1);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(8);
    grid->setColumnStretch(0, 3);
    grid->setColumnStretch(1, 2);
    grid->addWidget(m_write, 0, 0);
    grid->addWidget(m_revert, 0, 1);
    grid->addLayout(activation, 1, 0);
    grid->addWidget(m_deactivate, 1, 1);
    grid->addLayout(hint, 2, 0, 1, 2);
    connectActions();
    retranslate();
}

void ActionPanel::connectActions()
{
    connect(m_write, &QPushButton::clicked, this, &ActionPanel::writeRequested);
    connect(m_revert, &QPushButton::clicked, this, [this] { m_controller.setup().revert(); });
    connect(m_activate, &QPushButton::clicked, &m_controller, &WizardController::activate);
    connect(m_deactivate, &QPushButton::clicked, &m_controller, &WizardController::deactivate);
    connect(m_evaluate, &QAction::triggered, &m_controller, &WizardController::evaluate);
    connect(m_restore, &QAction::triggered, this, &ActionPanel::restoreRequested);
    connect(m_backups, &QAction::triggered, this, &ActionPanel::backupsRequested);
    connect(m_delete, &QAction::triggered, this, &ActionPanel::deleteRequested);
    connect(&m_controller, &WizardController::actionsChanged, this, &ActionPanel::showActions);
}

void ActionPanel::retranslate()
{
    m_write->setText(tr("&Write Compensation"));
    m_revert->setText(tr("Re&vert All"));
    m_activate->setText(tr("&Activate"));
    m_activateMore->setAccessibleName(tr("More actions"));
    m_activateMore->setToolTip(tr("Evaluate, restore a backup, or delete the table"));
    m_deactivate->setText(tr("D&eactivate"));
    m_evaluate->setText(tr("&Evaluate (Adds Nothing)"));
    m_restore->setText(tr("Restore &Previous Table…"));
    m_backups->setText(tr("Restore &Backup…"));
    m_delete->setText(tr("&Delete Table…"));
    m_hint->setAccessibleName(tr("Next step"));
    showActions();
}

void ActionPanel::apply(QPushButton& button, Action action, const QString& toolTip)
{
    const ActionState state = m_controller.action(action);
    const bool hadFocus = button.hasFocus();
    button.setEnabled(state.isEnabled);
    const QString reason = state.reason.isEmpty() ? toolTip : state.reason;
    button.setToolTip(state.isEnabled ? toolTip : reason);
    button.setAccessibleDescription(reason);
    if (hadFocus && !state.isEnabled)
        setFocus();
}

void ActionPanel::apply(QAction& menuEntry, Action action, const QString& toolTip)
{
    const ActionState state = m_controller.action(action);
    menuEntry.setEnabled(state.isEnabled);
    menuEntry.setToolTip(state.isEnabled || state.reason.isEmpty() ? toolTip : state.reason);
}

void ActionPanel::setPreviewing(bool isPreviewing)
{
    m_isPreviewing = isPreviewing;
    showActions();
}

void ActionPanel::showActions()
{
    apply(*m_write, Action::Write,
        tr("Writes table and settings to the drive and verifies them (Ctrl+Return)"));
    apply(*m_revert, Action::Revert, tr("Resets all fields to the drive's values (Ctrl+Shift+R)"));
    apply(*m_activate, Action::Activate,
        tr("Switches the compensation on, then compares the drive's output with the table"));
    apply(*m_deactivate, Action::Deactivate, tr("Switches the compensation off"));
    apply(*m_evaluate, Action::Evaluate,
        tr("The drive looks up the table and shows the indices, but adds nothing"));
    apply(*m_restore, Action::RestorePrevious,
        tr("Writes back the table and settings from before the last write"));
    m_backups->setEnabled(m_controller.status().has_value());
    m_backups->setToolTip(tr("Shows the backups of this drive and restores the one you choose"));
    apply(*m_delete, Action::DeleteTable,
        tr("Deletes the axis's table from the drive and frees its slot"));
    if (m_isPreviewing) {
        m_write->setEnabled(false);
        m_write->setToolTip(tr("Continue in the preview on the right"));
    }
    // The next step is the one that Return stands for.
    m_write->setDefault(m_write->isEnabled());
    m_activate->setDefault(!m_isPreviewing && !m_write->isEnabled() && m_activate->isEnabled());

    const QString hint = m_controller.hint();
    m_hint->setText(hint);
    m_hintSymbol->setPixmap(hint.isEmpty()
            ? QPixmap()
            : symbolPixmap(Symbol::Information, mutedTextColor(palette()), actionSymbolSize,
                devicePixelRatioF()));
}

} // namespace axiscomp::ui
