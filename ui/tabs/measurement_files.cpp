// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tabs/measurement_files.h"

#include "ui/record/measurement_files_model.h"
#include "ui/record/record_model.h"
#include "ui/style/plain_label.h"
#include "ui/style/symbols.h"
#include "ui/tabs/file_choices.h"
#include "ui/tabs/widget_names.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QHeaderView>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcut>
#include <QTableView>

#include <algorithm>

namespace axiscomp::ui {

MeasurementFiles::MeasurementFiles(RecordModel& record, const QString& prefix, QWidget* parent)
    : QWidget(parent)
    , m_record(record)
    , m_model(new MeasurementFilesModel(record, this))
    , m_title(new PlainLabel)
    , m_add(new QPushButton)
    , m_files(new QTableView)
    , m_remove(new QPushButton)
    , m_swap(new QCheckBox)
    , m_choices(new FileChoices)
    , m_fields(new QWidget)
{
    build(prefix);
    connectParts();
    retranslate();
}

void MeasurementFiles::build(const QString& prefix)
{
    m_add->setObjectName(QStringLiteral("addMeasurement"));
    m_add->setIcon(symbolIcon(Symbol::Add));
    m_remove->setObjectName(QStringLiteral("removeMeasurement"));
    m_remove->setIcon(symbolIcon(Symbol::Remove));
    m_swap->setObjectName(QStringLiteral("swapDirections"));
    buildList();
    auto* fieldLayout = new QVBoxLayout(m_fields);
    fieldLayout->setContentsMargins(0, 0, 0, 0);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_title, 1);
    buttons->addWidget(m_add);
    buttons->addWidget(m_remove);
    fieldLayout->addLayout(buttons);
    fieldLayout->addWidget(m_files, 1);
    fieldLayout->addWidget(m_swap);
    fieldLayout->addWidget(m_choices);
    auto* scroll = new QScrollArea;
    scroll->setObjectName(QStringLiteral("measureScroll"));
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(m_fields);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scroll);
    prefixNames(prefix, *this);
}

void MeasurementFiles::buildList()
{
    m_files->setObjectName(QStringLiteral("measurementFiles"));
    m_files->setModel(m_model);
    m_files->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_files->setSelectionMode(QAbstractItemView::SingleSelection);
    m_files->setAlternatingRowColors(true);
    m_files->setShowGrid(false);
    m_files->setTabKeyNavigation(false);
    m_files->setWordWrap(false);
    m_files->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_files->verticalHeader()->hide();
    m_files->verticalHeader()->setDefaultSectionSize(m_files->fontMetrics().height() + 8);
    m_files->horizontalHeader()->setHighlightSections(false);
    m_files->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_files->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    // The name gives way to the rest, whose whole is in its tool tip.
    m_files->horizontalHeader()->setSectionResizeMode(
        MeasurementFilesModel::File, QHeaderView::Stretch);
    m_files->horizontalHeader()->setMinimumSectionSize(
        m_files->fontMetrics().horizontalAdvance(QStringLiteral("measured.csv")));
    m_files->setMinimumHeight(5 * m_files->verticalHeader()->defaultSectionSize());
}

void MeasurementFiles::addRow(QWidget* row)
{
    m_fields->layout()->addWidget(row);
}

void MeasurementFiles::connectParts()
{
    connect(m_add, &QPushButton::clicked, this, &MeasurementFiles::addRequested);
    connect(m_remove, &QPushButton::clicked, this, &MeasurementFiles::remove);
    auto* removeKey = new QShortcut(QKeySequence::Delete, m_files);
    removeKey->setContext(Qt::WidgetShortcut);
    connect(removeKey, &QShortcut::activated, this, &MeasurementFiles::remove);
    connect(m_swap, &QCheckBox::clicked, &m_record, &RecordModel::setDirectionsSwapped);
    connect(m_choices, &FileChoices::chosen, this, [this](const MeasurementChoices& choices) {
        if (const auto file = current())
            m_record.setChoices(*file, choices);
    });
    connect(m_files->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
        &MeasurementFiles::showFile);
    connect(&m_record, &RecordModel::changed, this, &MeasurementFiles::follow);
    connect(&m_record, &RecordModel::stateChanged, this, &MeasurementFiles::follow);
}

void MeasurementFiles::setTitle(const QString& title, const QString& spoken)
{
    m_title->setText(title);
    m_files->setAccessibleName(spoken);
}

void MeasurementFiles::retranslate()
{
    m_add->setText(tr("&Add…"));
    m_add->setToolTip(tr("Add files of a measurement; they can also be dropped here (Ctrl+O)"));
    m_add->setAccessibleDescription(m_add->toolTip());
    m_remove->setText(tr("Re&move"));
    m_remove->setToolTip(tr("Take the selected file out of the measurement (Del)"));
    m_remove->setAccessibleDescription(m_remove->toolTip());
    m_swap->setText(tr("E&xchange up and down in all files"));
    m_swap->setToolTip(tr("For files that name the directions the other way round"));
    m_swap->setAccessibleDescription(m_swap->toolTip());
    m_model->retranslate();
    m_choices->retranslate();
    follow();
}

void MeasurementFiles::mapColumns(const std::vector<ColumnMapping>& columns)
{
    const auto file = current();
    if (!file)
        return;
    MeasurementChoices choices = m_record.record().files[*file].choices;
    choices.columns = columns;
    m_record.setChoices(*file, choices);
}

std::optional<std::size_t> MeasurementFiles::current() const
{
    const int row = m_files->currentIndex().row();
    const std::size_t count = m_record.record().files.size();
    return row >= 0 && static_cast<std::size_t>(row) < count
        ? std::optional(static_cast<std::size_t>(row))
        : std::nullopt;
}

MeasurementFile MeasurementFiles::currentFile() const
{
    const auto file = current();
    return file ? m_record.record().files[*file] : MeasurementFile{};
}

const ReadMeasurement* MeasurementFiles::currentReading() const
{
    const auto file = current();
    if (!file)
        return nullptr;
    const auto& readings = m_record.state().files;
    const auto found =
        std::ranges::find(readings, m_record.record().files[*file], &ReadMeasurement::file);
    return found == readings.end() ? nullptr : &*found;
}

void MeasurementFiles::remove()
{
    if (const auto file = current())
        m_record.removeFile(*file);
}

void MeasurementFiles::follow()
{
    const std::size_t count = m_record.record().files.size();
    const bool isNew = count > m_fileCount;
    if (count > 0 && (isNew || !m_files->currentIndex().isValid()))
        m_files->setCurrentIndex(
            m_model->index(isNew ? static_cast<int>(count) - 1 : 0, MeasurementFilesModel::File));
    m_fileCount = count;
    m_swap->setChecked(m_record.record().swapsDirections);
    m_swap->setEnabled(count > 0);
    showFile();
}

void MeasurementFiles::showFile()
{
    const MeasurementFile shown = currentFile();
    const bool isThere = current().has_value();
    m_remove->setEnabled(isThere);
    // What a record holds was read already.
    m_choices->setEnabled(isThere && !shown.recorded);
    m_choices->show(shown.choices);
    Q_EMIT currentChanged();
}

} // namespace axiscomp::ui
