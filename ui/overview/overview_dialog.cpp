// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/overview/overview_dialog.h"

#include "ui/controller/axis_overview.h"
#include "ui/controller/machine_controller.h"
#include "ui/controller/wizard_controller.h"
#include "ui/overview/drift_details.h"
#include "ui/overview/machine_pane.h"
#include "ui/overview/overview_model.h"
#include "ui/style/contrast.h"
#include "ui/style/plain_label.h"
#include "ui/style/symbols.h"
#include "ui/text/message_text.h"

#include <QAction>
#include <QBoxLayout>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>
#include <QTableView>

#include <algorithm>
#include <iterator>

namespace axiscomp::ui {

namespace {

/// The state stands on its colour; what is not live is less important.
class OverviewDelegate final : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        const bool isOfFile = index.column() == OverviewModel::Machine;
        const QVariant tone =
            index.data(isOfFile ? OverviewModel::DriftToneRole : OverviewModel::ToneRole);
        if ((index.column() == OverviewModel::State || isOfFile) && tone.isValid()) {
            option->backgroundBrush = fillColor(static_cast<Tone>(tone.toInt()), option->palette);
            option->font.setBold(!isOfFile);
        } else if (!index.data(OverviewModel::IsLiveRole).toBool()) {
            option->palette.setColor(QPalette::Text, mutedTextColor(option->palette));
        }
    }
};

/// A cell of a spreadsheet is one line without tabs.
QString cellText(const QVariant& value)
{
    return value.toString().simplified();
}

} // namespace

OverviewDialog::OverviewDialog(WizardController& controller, QWidget* parent)
    : QDialog(parent)
    , m_controller(controller)
    , m_overview(controller.overview())
    , m_machine(controller.machine())
    , m_model(new OverviewModel(m_overview, this))
    , m_sorted(new QSortFilterProxyModel(this))
    , m_table(new QTableView)
    , m_machinePane(new MachinePane(m_machine))
    , m_drift(new DriftDetails)
    , m_note(new PlainLabel)
    , m_copy(new QAction(this))
    , m_copyButton(new QPushButton)
    , m_go(new QPushButton)
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Close))
{
    setObjectName(QStringLiteral("overviewDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    setModal(false);
    build();
    connectParts();
    retranslate();
    selectCurrentAxis();
}

OverviewDialog::~OverviewDialog() = default;

void OverviewDialog::build()
{
    m_model->showMachine(m_machine);
    m_sorted->setSourceModel(m_model);
    m_sorted->setSortRole(OverviewModel::SortRole);
    m_sorted->setSortLocaleAware(true);
    m_table->setObjectName(QStringLiteral("overview"));
    m_table->setModel(m_sorted);
    m_table->setItemDelegate(new OverviewDelegate(m_table));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setAlternatingRowColors(true);
    m_table->setShowGrid(false);
    m_table->setWordWrap(false);
    m_table->setTabKeyNavigation(false);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height() + 8);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    // As the drives stand in the connections, until a column is clicked.
    m_table->horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);
    m_table->horizontalHeader()->setSortIndicatorClearable(true);
    m_table->setSortingEnabled(true);
    m_note->setObjectName(QStringLiteral("overviewNote"));
    m_note->setWordWrap(true);
    m_copyButton->setObjectName(QStringLiteral("copyOverview"));
    m_copyButton->setIcon(symbolIcon(Symbol::Copy));
    m_go->setObjectName(QStringLiteral("goToAxis"));
    m_buttons->setObjectName(QStringLiteral("overviewButtons"));
    m_buttons->addButton(m_copyButton, QDialogButtonBox::ActionRole);
    m_buttons->addButton(m_go, QDialogButtonBox::ActionRole);
    // Enter in the table goes to its axis, once.
    for (QPushButton* button : {m_copyButton, m_go, m_buttons->button(QDialogButtonBox::Close)})
        button->setAutoDefault(false);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(10);
    layout->addWidget(m_machinePane);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_drift);
    layout->addWidget(m_note);
    layout->addWidget(m_buttons);
    resize(room());
}

void OverviewDialog::connectParts()
{
    m_copy->setShortcut(QKeySequence::Copy);
    m_copy->setShortcutContext(Qt::WidgetShortcut);
    m_table->addAction(m_copy);
    m_table->setContextMenuPolicy(Qt::ActionsContextMenu);
    connect(m_copy, &QAction::triggered, this, &OverviewDialog::copy);
    connect(m_copyButton, &QPushButton::clicked, this, &OverviewDialog::copy);
    connect(m_table, &QTableView::activated, this, &OverviewDialog::goToAxis);
    connect(m_go, &QPushButton::clicked, this, &OverviewDialog::goToAxis);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this,
        &OverviewDialog::showChosen);
    connect(m_model, &QAbstractItemModel::dataChanged, this, &OverviewDialog::showChosen);
    connect(m_model, &QAbstractItemModel::modelReset, this, &OverviewDialog::selectCurrentAxis);
    connect(&m_controller, &WizardController::busyChanged, this, &OverviewDialog::showChosen);
    connect(&m_machine, &MachineController::driftChanged, this, &OverviewDialog::showDrift);
    connect(&m_machine, &MachineController::fileChanged, this, &OverviewDialog::showMachineColumn);
    connect(m_machinePane, &MachinePane::applyRequested, this, &OverviewDialog::applyRequested);
    showMachineColumn();
}

void OverviewDialog::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDialog::changeEvent(event);
}

void OverviewDialog::showEvent(QShowEvent* event)
{
    QDialog::showEvent(event);
    m_overview.follow(true);
}

void OverviewDialog::hideEvent(QHideEvent* event)
{
    m_overview.follow(false);
    QDialog::hideEvent(event);
}

void OverviewDialog::retranslate()
{
    setWindowTitle(tr("Overview of All Axes"));
    m_table->setAccessibleName(tr("All axes of all drives"));
    m_copy->setText(tr("Copy"));
    m_copyButton->setText(tr("&Copy"));
    m_copyButton->setToolTip(
        tr("Copy the selected rows, or all of them, with the headings for a spreadsheet"));
    m_copyButton->setAccessibleDescription(m_copyButton->toolTip());
    m_go->setText(tr("&Go to Axis"));
    m_buttons->button(QDialogButtonBox::Close)->setText(tr("Close"));
    m_buttons->button(QDialogButtonBox::Close)->setToolTip(tr("Close the overview"));
    m_model->retranslate();
    m_machinePane->retranslate();
    m_drift->retranslate();
    showChosen();
}

void OverviewDialog::selectCurrentAxis()
{
    for (int row = 0; row < m_model->rowCount(); ++row) {
        if (axisOf(row) >= 0 && axisOf(row) == m_controller.currentAxis())
            m_table->selectRow(m_sorted->mapFromSource(m_model->index(row, 0)).row());
    }
    showChosen();
}

int OverviewDialog::chosenRow() const
{
    return m_sorted->mapToSource(m_table->currentIndex()).row();
}

int OverviewDialog::axisOf(int row) const
{
    const auto& rows = m_overview.rows();
    if (row < 0 || row >= static_cast<int>(rows.size()))
        return -1;
    const OverviewRow& chosen = rows[static_cast<std::size_t>(row)];
    const auto& axes = m_controller.axes();
    const auto found = std::ranges::find_if(axes, [&](const AxisEntry& entry) {
        return entry.endpoint == chosen.endpoint && entry.axis.index == chosen.axis;
    });
    return found == axes.end() ? -1 : static_cast<int>(found - axes.begin());
}

QString OverviewDialog::obstacle() const
{
    const int row = chosenRow();
    if (row < 0)
        return tr("No axis is chosen.");
    const OverviewRow& chosen = m_overview.rows().at(static_cast<std::size_t>(row));
    const int axis = axisOf(row);
    if (!chosen.driveProblem.isEmpty())
        return chosen.driveProblem;
    if (axis < 0)
        return tr("This drive has not said yet which axes it has.");
    const QString& problem = m_controller.axes().at(static_cast<std::size_t>(axis)).problem;
    if (!problem.isEmpty())
        return problem;
    if (m_controller.busy().isBusy && axis != m_controller.currentAxis())
        return tr("Wait for the current operation before choosing another axis.");
    return {};
}

/// What is wrong with an axis is said where there is room for it, whether or not it can be gone to.
void OverviewDialog::showChosen()
{
    const QString reason = obstacle();
    const int row = chosenRow();
    QString note = row < 0 ? QString() : reason;
    if (note.isEmpty() && row >= 0) {
        const auto& problem = m_overview.rows().at(static_cast<std::size_t>(row)).problem;
        note = problem ? errorText(*problem) : QString();
    }
    m_note->setText(note);
    m_note->setVisible(!note.isEmpty());
    m_go->setEnabled(reason.isEmpty());
    m_go->setToolTip(reason.isEmpty() ? tr("Show this axis on the page") : reason);
    m_go->setAccessibleDescription(m_go->toolTip());
    showDrift();
}

/// For all columns of two drives, and for the differences of a machine file below them; not larger
/// than the page that it belongs to.
QSize OverviewDialog::room() const
{
    const QSize wanted(1200, m_machine.file() ? 560 : 360);
    return wanted.boundedTo(parentWidget() ? parentWidget()->size() : wanted);
}

void OverviewDialog::showMachineColumn()
{
    m_table->setColumnHidden(OverviewModel::Machine, !m_machine.file());
    resize(size().expandedTo(room()));
    showDrift();
}

/// Field by field, for the axis that is chosen.
void OverviewDialog::showDrift()
{
    const int row = chosenRow();
    if (row < 0 || !m_machine.file() || m_machine.file()->refusal)
        return m_drift->clear();
    const OverviewRow& chosen = m_overview.rows().at(static_cast<std::size_t>(row));
    const AxisDrift drift = m_machine.driftOf(chosen.endpoint, chosen.axis);
    std::vector<AxisEntry> axes;
    std::ranges::copy_if(m_controller.axes(), std::back_inserter(axes),
        [&](const AxisEntry& entry) { return entry.endpoint == chosen.endpoint; });
    const MachineTable* table = nullptr;
    if (drift.drive && drift.axis) {
        const auto place = static_cast<std::size_t>(drift.drive - m_machine.drives().data());
        table = &m_machine.file()->tables.at(place).at(*drift.axis);
    }
    const int axis = axisOf(row);
    const QString name =
        axis >= 0 ? m_controller.axes().at(static_cast<std::size_t>(axis)).label : chosen.endpoint;
    m_drift->showDrift(name, drift, table, axes);
}

void OverviewDialog::goToAxis()
{
    if (!obstacle().isEmpty())
        return;
    const int axis = axisOf(chosenRow());
    close(); // the page may have a question
    Q_EMIT axisChosen(axis);
}

void OverviewDialog::copy()
{
    const QItemSelectionModel* selection = m_table->selectionModel();
    QStringList lines;
    QStringList headings;
    const auto isShown = [this](int column) { return !m_table->isColumnHidden(column); };
    for (int column = 0; column < OverviewModel::ColumnCount; ++column)
        if (isShown(column))
            headings += cellText(m_sorted->headerData(column, Qt::Horizontal));
    lines += headings.join(u'\t');
    for (int row = 0; row < m_sorted->rowCount(); ++row) {
        if (selection->hasSelection() && !selection->isRowSelected(row))
            continue;
        QStringList cells;
        for (int column = 0; column < OverviewModel::ColumnCount; ++column)
            if (isShown(column))
                cells += cellText(m_sorted->index(row, column).data());
        lines += cells.join(u'\t');
    }
    QGuiApplication::clipboard()->setText(lines.join(u'\n') + u'\n');
}

} // namespace axiscomp::ui
