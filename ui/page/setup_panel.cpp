// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/setup_panel.h"

#include "core/drive/drive_profile.h"
#include "ui/controller/wizard_controller.h"
#include "ui/fields/data_file_field.h"
#include "ui/fields/field_binder.h"
#include "ui/fields/field_row.h"
#include "ui/fields/source_combo.h"
#include "ui/text/state_text.h"
#include "ui/text/value_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>

#include <algorithm>

namespace axiscomp::ui {

namespace {

QComboBox* comboBox(const char* name)
{
    auto* combo = new QComboBox;
    combo->setObjectName(QLatin1StringView(name));
    combo->setFocusPolicy(Qt::StrongFocus);
    combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    combo->setMinimumContentsLength(9);
    return combo;
}

} // namespace

SetupPanel::SetupPanel(
    WizardController& controller, const DriveProfile& profile, QStyle& style, QWidget* parent)
    : QWidget(parent)
    , m_controller(controller)
    , m_profile(profile)
    , m_axis(comboBox("axisField"))
    , m_dimensionality(comboBox("dimensionalityField"))
    , m_data(new DataFileField)
    , m_table(comboBox("tableField"))
    , m_persistency(new QCheckBox)
    , m_axisRow(new FieldRow(m_axis, &style, this))
    , m_dimensionalityRow(new FieldRow(m_dimensionality, &style, this))
    , m_dataRow(nullptr)
    , m_tableRow(nullptr)
    , m_persistencyRow(nullptr)
    , m_binder(new FieldBinder(controller.setup(), this))
{
    setObjectName(QStringLiteral("setupPanel"));
    for (std::size_t n = 0; n < m_sources.size(); ++n) {
        m_sources[n] = new SourceCombo;
        m_sources[n]->setObjectName(QStringLiteral("source%1Field").arg(n + 1));
        m_sourceRows[n] = new FieldRow(m_sources[n], &style, this);
    }
    m_dataRow = new FieldRow(m_data, &style, this);
    m_dataRow->setBuddy(m_data->nameField());
    m_tableRow = new FieldRow(m_table, &style, this);
    m_persistency->setObjectName(QStringLiteral("persistencyField"));
    m_persistency->setMinimumHeight(m_table->sizeHint().height());
    m_persistencyRow = new FieldRow(m_persistency, &style, this);
    m_axisRow->setRevertible(false);
    m_dataRow->setRevertible(false);
    for (int dimensions = 1; dimensions <= 3; ++dimensions)
        m_dimensionality->addItem(QString(), dimensions);
    m_table->addItem(QString(), tableOnDrive);
    build();
    setTexts();
    bind();
    connectController();
    showAxes();
    showSources();
    showData();
}

void SetupPanel::build()
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 4, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(1);
    grid->setColumnStretch(1, 1);
    int row = 0;
    for (FieldRow* field : {m_axisRow, m_dimensionalityRow, m_sourceRows[0], m_sourceRows[1],
             m_sourceRows[2], m_dataRow, m_tableRow, m_persistencyRow}) {
        field->addTo(*grid, row);
        row += 2;
    }
    grid->setRowStretch(row, 1);
}

void SetupPanel::bind()
{
    m_binder->bind(
        Field::Dimensionality, *m_dimensionalityRow, *m_dimensionality,
        [](const EditedSetup& edited) { return QVariant(edited.dimensionality); },
        [](SetupModel& model, const QVariant& value) { model.setDimensionality(value.toInt()); },
        [](const CompensationSetup& drive) { return tr("%1D").arg(drive.dimensionality); });
    for (int dimension = 1; dimension <= 3; ++dimension) {
        const auto index = static_cast<std::size_t>(dimension - 1);
        m_binder->bind(
            *m_sourceRows[index], *m_sources[index], dimension,
            [this](const DimSource& source) { return sourceUriText(source); },
            [this](const DimSource& source) { return sourceName(source); });
    }
    m_binder->bind(
        Field::Table, *m_tableRow, *m_table,
        [](const EditedSetup& edited) {
            return QVariant(edited.table.fileTable.value_or(tableOnDrive));
        },
        [](SetupModel& model, const QVariant& value) {
            const int index = value.toInt();
            model.setTable({index == tableOnDrive ? std::nullopt : std::optional(index)});
        },
        [this](const CompensationSetup& drive) { return driveTableText(drive); });
    m_binder->bind(
        Field::Persistency, *m_persistencyRow, *m_persistency,
        [](const EditedSetup& edited) { return edited.persistency == Persistency::Persistent; },
        [](SetupModel& model, bool isPersistent) {
            model.setPersistency(isPersistent ? Persistency::Persistent : Persistency::Volatile);
        },
        [](const CompensationSetup& drive) {
            return drive.slot.empty()                          ? noTableText()
                : drive.persistency == Persistency::Persistent ? tr("persistent")
                                                               : tr("volatile");
        });
}

void SetupPanel::connectController()
{
    connect(m_axis, &QComboBox::activated, this, [this](int index) {
        m_axis->setCurrentIndex(m_controller.currentAxis());
        if (index != m_controller.currentAxis())
            Q_EMIT axisChosen(index);
    });
    connect(m_binder, &FieldBinder::sourceEntered, &m_controller, &WizardController::chooseSource);
    connect(m_binder, &FieldBinder::sourceEdited, &m_controller,
        &WizardController::forgetSourceProblem);
    for (int dimension = 1; dimension <= 3; ++dimension)
        connect(m_sourceRows[static_cast<std::size_t>(dimension - 1)], &FieldRow::proposalTaken,
            this, [this, dimension] { takeProposal(dimension); });
    connect(&m_controller, &WizardController::axesChanged, this, &SetupPanel::showAxes);
    connect(&m_controller, &WizardController::currentAxisChanged, this, &SetupPanel::showAxes);
    connect(&m_controller, &WizardController::currentAxisChanged, this, &SetupPanel::showSources);
    connect(&m_controller, &WizardController::statusChanged, this, &SetupPanel::showSources);
    connect(&m_controller, &WizardController::statusChanged, this, &SetupPanel::showAxisState);
    connect(&m_controller, &WizardController::statusChanged, this, &SetupPanel::showTables);
    connect(&m_controller, &WizardController::liveChanged, this, &SetupPanel::showSourceValues);
    connect(&m_controller, &WizardController::liveChanged, this, &SetupPanel::showAxisState);
    connect(&m_controller, &WizardController::sourceChecked, this, &SetupPanel::showSource);
    connect(&m_controller, &WizardController::dataFileChanged, this, &SetupPanel::showData);
    connect(&m_controller, &WizardController::selectedTableChanged, this, &SetupPanel::showTables);
    connect(&m_controller, &WizardController::selectedTableChanged, this,
        &SetupPanel::showSourceAdvice);
    connect(&m_controller, &WizardController::drivesChanged, this, &SetupPanel::showSourceValues);
    for (const auto changed : {&WizardController::actionsChanged, &WizardController::busyChanged})
        connect(&m_controller, changed, this, &SetupPanel::showAvailability);
    connect(&m_controller.setup(), &SetupModel::fieldChanged, this, [this](Field field) {
        if (field == Field::Dimensionality)
            showDimensions();
        if (field == Field::Table)
            showTableState();
        showPersistency();
        showSourceAdvice();
        showSourceValues();
    });
}

void SetupPanel::takeProposal(int dimension)
{
    const DimSource proposed = m_controller.proposedSource(dimension);
    if (!proposed.isSet())
        return;
    m_controller.chooseSource(dimension, QString::fromStdString(requestedSource(proposed)));
    m_sources[static_cast<std::size_t>(dimension - 1)]->setFocus();
}

DataFileField& SetupPanel::dataField()
{
    return *m_data;
}

bool SetupPanel::isBeingTyped() const
{
    return std::ranges::any_of(m_sources, [this](const SourceCombo* source) {
        return source->isVisibleTo(this) && source->isTyping();
    });
}

void SetupPanel::revertFocused()
{
    const std::array<std::pair<FieldRow*, Field>, allFields.size()> fields{{
        {m_dimensionalityRow, Field::Dimensionality},
        {m_sourceRows[0], Field::Source1},
        {m_sourceRows[1], Field::Source2},
        {m_sourceRows[2], Field::Source3},
        {m_tableRow, Field::Table},
        {m_persistencyRow, Field::Persistency},
    }};
    for (const auto& [row, field] : fields) {
        if (row->editor().hasFocus())
            m_controller.setup().revert(field);
    }
}

void SetupPanel::retranslate()
{
    setTexts();
    m_data->retranslate();
    showAxes();
    showSources();
    showData();
    m_binder->refresh();
}

} // namespace axiscomp::ui
