// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/write_preview.h"

#include "ui/async/background_job.h"
#include "ui/plot/change_pictures.h"
#include "ui/session/axis_list.h"
#include "ui/style/plain_label.h"
#include "ui/style/symbols.h"
#include "ui/style/warning_list.h"
#include "ui/text/message_text.h"
#include "ui/text/sign_sentence.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTableWidget>

namespace axiscomp::ui {

namespace {

constexpr int largestChangeRow = 0; // of the table's rows: the first after the table itself

QLabel* noteLabel(const char* name)
{
    auto* label = new PlainLabel;
    label->setObjectName(QLatin1StringView(name));
    label->setWordWrap(true);
    return label;
}

QString persistencyText(Persistency persistency)
{
    return persistency == Persistency::Persistent ? WritePreview::tr("persistent")
                                                  : WritePreview::tr("volatile");
}

} // namespace

WritePreview::WritePreview(WizardController& controller, QWidget* parent)
    : QWidget(parent)
    , m_controller(controller)
    , m_title(new PlainLabel)
    , m_scroll(new QScrollArea)
    , m_introduction(noteLabel("previewIntroduction"))
    , m_warnings(new WarningList)
    , m_rows(new QTableWidget)
    , m_pictures(new ChangePictures)
    , m_sign(noteLabel("previewSign"))
    , m_cost(noteLabel("previewCost"))
    , m_remarks(noteLabel("previewRemarks"))
    , m_accept(new QCheckBox)
    , m_skip(new QCheckBox)
    , m_write(new QPushButton)
    , m_back(new QPushButton)
{
    setObjectName(QStringLiteral("writePreview"));
    build();
    connect(m_write, &QPushButton::clicked, this, &WritePreview::confirmed);
    connect(m_back, &QPushButton::clicked, this, &WritePreview::backRequested);
    connect(m_accept, &QCheckBox::toggled, this, &WritePreview::showAcceptance);
    connect(m_skip, &QCheckBox::toggled, this, &WritePreview::skipForVolatileChanged);
    connect(&m_controller, &WizardController::statusChanged, this, [this] {
        // The old table may still have been on its way when the plan was there.
        const auto& plan = m_controller.plan();
        if (isVisible() && plan && m_controller.driveTable() != m_oldTable)
            fillRows(*plan);
    });
    retranslate();
}

void WritePreview::build()
{
    m_title->setObjectName(QStringLiteral("previewTitle"));
    QFont titleFont = m_title->font();
    titleFont.setPointSizeF(titleFont.pointSizeF() * 1.2);
    titleFont.setBold(true);
    m_title->setFont(titleFont);
    m_title->setWordWrap(true);
    m_rows->setObjectName(QStringLiteral("previewRows"));
    m_rows->setColumnCount(3);
    m_rows->verticalHeader()->hide();
    m_rows->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_rows->setSelectionMode(QAbstractItemView::NoSelection);
    m_rows->setFocusPolicy(Qt::TabFocus);
    m_rows->setTabKeyNavigation(false);
    m_rows->setWordWrap(true);
    m_rows->setSizeAdjustPolicy(QAbstractItemView::AdjustToContents);
    m_rows->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Maximum);
    m_rows->verticalHeader()->setMinimumSectionSize(qRound(1.7 * m_rows->fontMetrics().height()));
    m_rows->setAlternatingRowColors(true);
    m_rows->setShowGrid(false);
    m_rows->horizontalHeader()->setHighlightSections(false);
    m_rows->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_rows->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_rows->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    m_rows->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_accept->setObjectName(QStringLiteral("acceptLargeCorrections"));
    m_skip->setObjectName(QStringLiteral("skipPreviewForVolatile"));
    m_write->setObjectName(QStringLiteral("confirmWriteButton"));
    m_write->setAutoDefault(true);
    m_write->setDefault(true);
    m_back->setObjectName(QStringLiteral("backButton"));
    m_back->setAutoDefault(true);
    buildScrolled();
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(m_back);
    buttons->addWidget(m_write);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_title);
    layout->addWidget(m_scroll, 1);
    layout->addWidget(m_accept);
    layout->addWidget(m_skip);
    layout->addLayout(buttons);
    setTabOrder(m_scroll, m_rows);
    setTabOrder(m_rows, m_accept);
    setTabOrder(m_accept, m_skip);
    setTabOrder(m_skip, m_back);
    setTabOrder(m_back, m_write);
}

/// What there is to read scrolls where the window is small; what there is to press stays.
void WritePreview::buildScrolled()
{
    m_warnings->setObjectName(QStringLiteral("previewWarnings"));
    QFont italic = m_sign->font();
    italic.setItalic(true);
    m_sign->setFont(italic);
    auto* scrolled = new QWidget;
    auto* layout = new QVBoxLayout(scrolled);
    layout->setContentsMargins(0, 0, 8, 0);
    layout->setSpacing(8);
    layout->addWidget(m_introduction);
    layout->addWidget(m_warnings);
    layout->addWidget(m_rows);
    layout->addWidget(m_pictures);
    layout->addWidget(m_sign);
    layout->addWidget(m_remarks);
    layout->addWidget(m_cost);
    layout->addStretch(1);
    m_scroll->setObjectName(QStringLiteral("previewScroll"));
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setFocusPolicy(Qt::TabFocus);
    m_scroll->setWidget(scrolled);
}

void WritePreview::retranslate()
{
    m_introduction->setText(tr(
        "Nothing on the drive has changed yet. The old table and settings are backed up first."));
    m_rows->setHorizontalHeaderLabels({tr("Field"), tr("On the drive"), tr("New")});
    m_rows->setAccessibleName(tr("What will be written"));
    m_scroll->setAccessibleName(tr("Preview"));
    m_accept->setText(tr("These large corrections are &right: their unit has been checked"));
    m_skip->setText(tr("Do not show this again &for volatile writes"));
    m_skip->setToolTip(tr(
        "Persistent writes always show the preview; the menu turns it back on for volatile ones"));
    m_back->setText(tr("Bac&k"));
    m_back->setToolTip(tr("Change nothing and go back (Esc)"));
    if (m_controller.plan())
        showPlan();
    else
        showAcceptance();
}

bool WritePreview::isSkippedForVolatile() const
{
    return m_skip->isChecked();
}

void WritePreview::setSkippedForVolatile(bool isSkipped)
{
    m_skip->setChecked(isSkipped);
}

bool WritePreview::isAccepted() const
{
    const auto& plan = m_controller.plan();
    return plan && (plan->largeCorrections.empty() || m_accept->isChecked());
}

void WritePreview::showAcceptance()
{
    const auto& plan = m_controller.plan();
    m_accept->setVisible(plan && !plan->largeCorrections.empty());
    m_write->setEnabled(isAccepted());
    const bool deletes = plan && !plan->deletedSlot.empty();
    const bool restores = plan && m_controller.plannedRestoration();
    m_write->setText(restores ? tr("&Restore") : deletes ? tr("&Delete") : tr("&Write"));
    m_write->setToolTip(!isAccepted() ? tr("Confirm the large corrections first")
            : deletes                 ? tr("Delete this from the drive now")
                                      : tr("Write this to the drive now"));
}

void WritePreview::showPlan()
{
    const auto& plan = m_controller.plan();
    if (!plan)
        return;
    const int axis = m_controller.currentAxis();
    const QString label =
        axis >= 0 ? m_controller.axes().at(static_cast<std::size_t>(axis)).label : QString();
    const auto restored = m_controller.plannedRestoration();
    if (!plan->table)
        m_planned.reset();
    else if (!m_planned || *m_planned != *plan->table) // the change is known of the same one
        m_planned = std::make_shared<const CompensationTable>(*plan->table);
    m_title->setText(restored ? tr("What will be restored on %1", "axis and drive").arg(label)
            : plan->deletedSlot.empty()
            ? tr("What will be written to %1", "axis and drive").arg(label)
            : tr("What will be deleted from %1", "axis and drive").arg(label));
    fillRows(*plan);
    m_cost->setText(costText(*plan));
    const QStringList list = remarks(*plan);
    m_remarks->setText(list.join(u'\n'));
    m_remarks->setVisible(!list.isEmpty());
    m_warnings->setWarnings(warnings(*plan));
    m_skip->setVisible(!restored && plan->deletedSlot.empty() && plan->flashOperations == 0
        && list.isEmpty() && m_warnings->warnings().isEmpty());
    m_accept->setChecked(false);
    showAcceptance();
    m_scroll->verticalScrollBar()->setValue(0);
    isAccepted() ? m_write->setFocus() : m_accept->setFocus();
}

void WritePreview::fillRows(const WritePlan& plan)
{
    m_rows->setRowCount(0);
    const CompensationSetup& before = plan.before;
    const CompensationSetup& after = plan.after;
    const bool isNewTable = plan.slotReason != SlotReason::KeepTable;
    ++m_request;
    m_pictures->setVisible(false);
    m_sign->setVisible(false);
    if (!plan.deletedSlot.empty())
        return fillDeletion(plan);
    if (isNewTable) {
        addRow(tr("Table"), tableText(before.slot, m_controller.driveTable().get()),
            tableText(after.slot, m_planned.get()));
        addRow(tr("Largest change"), {}, tr("computing …"));
        askForChange(m_planned, m_controller.driveTable(),
            haveSameSources(before, after) ? TableSources::Same : TableSources::Other);
    }
    if (before.dimensionality != after.dimensionality)
        addRow(tr("Dimensionality"), tr("%1D").arg(before.dimensionality),
            tr("%1D").arg(after.dimensionality));
    for (std::size_t n = 0; n < after.sources.size(); ++n) {
        if (!(before.sources[n] == after.sources[n]))
            addRow(tr("Dim%1 Source").arg(n + 1), sourceText(before.sources[n]),
                sourceText(after.sources[n]));
    }
    if (before.persistency != after.persistency || before.slot.empty())
        addRow(tr("Persistency"),
            before.slot.empty() ? tr("no table") : persistencyText(before.persistency),
            persistencyText(after.persistency));
    if (m_rows->rowCount() == 0) // an earlier write is finished
        addRow(tr("Parameters"), tr("possibly not saved"), tr("saved"));
}

void WritePreview::fillDeletion(const WritePlan& plan)
{
    addRow(tr("Table"), tableText(plan.before.slot, m_controller.driveTable().get()),
        tableText({}, nullptr));
    addRow(QString::fromStdString(plan.deletedSlot), persistencyText(plan.before.persistency),
        tr("empty", "slot"));
    askForChange(nullptr, m_controller.driveTable(), TableSources::Same);
}

void WritePreview::addRow(const QString& field, const QString& before, const QString& after)
{
    const int row = m_rows->rowCount();
    m_rows->insertRow(row);
    int column = 0;
    for (const QString& text : {field, before, after}) {
        auto* item = new QTableWidgetItem(text);
        item->setToolTip(text);
        item->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
        m_rows->setItem(row, column++, item);
    }
}

void WritePreview::askForChange(
    const SharedTable& newTable, const SharedTable& oldTable, TableSources sources)
{
    if (!newTable && !oldTable)
        return;
    if (m_change && newTable == m_newTable && oldTable == m_oldTable && sources == m_sources) {
        showChange(*m_change);
        return;
    }
    m_newTable = newTable;
    m_oldTable = oldTable;
    m_sources = sources;
    m_change.reset();
    const auto change = inBackground<Change>([newTable, oldTable, sources] {
        return Change{
            tableChange(newTable, oldTable, sources), newTable ? loaded(newTable) : LoadedTable{}};
    });
    whenDone(change, this, [this, request = m_request](const Change& computed) {
        if (request != m_request)
            return;
        m_change = computed;
        showChange(computed);
    });
}

void WritePreview::showChange(const Change& change)
{
    const auto& plan = m_controller.plan();
    const auto& status = m_controller.status();
    if (!plan || !status)
        return;
    m_pictures->setChange(change.tables, status->axis.unit);
    m_pictures->setVisible(true);
    if (!change.newTable.table)
        return;
    const QString sign = signSentenceFor(
        change.newTable, status->axis, {plan->ownDimension, plan->lookupAt, plan->isComputed});
    m_sign->setText(sign);
    m_sign->setVisible(!sign.isEmpty());
    QTableWidgetItem* item = m_rows->item(largestChangeRow + 1, 2);
    if (!item)
        return;
    // Without an old table the whole new one is the change.
    const TablePicture& largest =
        change.tables.before.drawn ? change.tables.difference : change.tables.after;
    item->setText(changeText(largest.largest, largest.grid, status->axis.unit));
    item->setToolTip(item->text());
}

QString WritePreview::costText(const WritePlan& plan) const
{
    if (plan.flashOperations == 0 && !plan.deletedSlot.empty())
        return tr("Uses no flash operation.");
    if (plan.flashOperations == 0)
        return plan.after.persistency == Persistency::Volatile
            ? tr("Uses no flash operation. Volatile: lost on a reboot.")
            : tr("Uses no flash operation: the flash already holds it.");
    return tr("Flash operations: %1 used, %2 left right after.")
        .arg(plan.flashOperations)
        .arg(plan.flashBudget.left - plan.flashOperations);
}

QStringList WritePreview::remarks(const WritePlan& plan) const
{
    QStringList list;
    if (const auto restored = m_controller.plannedRestoration()) {
        const QString time = localTimeText(restored->backupTime);
        list += restored->isBeforeWrite
            ? tr("This is what the axis had before the write of %1.").arg(time)
            : tr("This is the state in the backup file of %1.").arg(time); // warnings() say whose
    }
    if (plan.slotReason == SlotReason::OwnPrevious)
        list += tr("%1 held an earlier table of this axis; the current one stays complete until "
                   "the axis has switched to the new one.")
                    .arg(QString::fromStdString(plan.after.slot));
    for (const Text& remark : plan.unitRemarks)
        list += sentenceText(remark);
    return list;
}

QStringList WritePreview::warnings(const WritePlan& plan)
{
    QStringList list;
    for (const auto* texts : {&plan.largeCorrections, &plan.warnings})
        for (const Text& warning : *texts)
            list += sentenceText(warning);
    return list;
}

QString WritePreview::sourceText(const DimSource& source) const
{
    if (!source.isSet())
        return tr("not set", "source");
    if (source.path.empty())
        return QStringLiteral("0x%1").arg(source.address, 8, 16, QChar(u'0'));
    std::vector<AxisEntry> axes;
    const auto& all = m_controller.axes();
    const int current = m_controller.currentAxis();
    for (const AxisEntry& entry : all) {
        if (current >= 0 && entry.endpoint == all.at(static_cast<std::size_t>(current)).endpoint)
            axes.push_back(entry);
    }
    return registerName(source.path, axes);
}

QString WritePreview::tableText(const std::string& slot, const CompensationTable* table) const
{
    if (slot.empty())
        return tr("none", "table");
    QString text = QString::fromStdString(slot);
    if (table)
        text += QStringLiteral(": ") + gridText(table->grid);
    return text;
}

} // namespace axiscomp::ui
