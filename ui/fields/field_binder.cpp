// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/fields/field_binder.h"

#include "ui/fields/field_row.h"
#include "ui/fields/source_combo.h"

#include <QCheckBox>
#include <QSignalBlocker>

namespace axiscomp::ui {

FieldBinder::FieldBinder(SetupModel& model, QObject* parent) : QObject(parent), m_model(model)
{
    connect(&m_model, &SetupModel::fieldChanged, this,
        qOverload<axiscomp::ui::Field>(&FieldBinder::refresh));
}

void FieldBinder::bind(Field field, FieldRow& row, QComboBox& combo,
    std::function<QVariant(const EditedSetup&)> read,
    std::function<void(SetupModel&, const QVariant&)> write, DriveText driveText)
{
    connect(&combo, &QComboBox::currentIndexChanged, this,
        [this, &combo, write = std::move(write)](int index) {
            if (index >= 0)
                write(m_model, combo.itemData(index));
        });
    const auto show = [this, &combo, read = std::move(read)] {
        const QSignalBlocker blocker(combo);
        combo.setCurrentIndex(combo.findData(read(m_model.edited())));
    };
    add({field, &row, show, std::move(driveText)});
}

void FieldBinder::bind(Field field, FieldRow& row, QCheckBox& checkBox,
    std::function<bool(const EditedSetup&)> read, std::function<void(SetupModel&, bool)> write,
    DriveText driveText)
{
    connect(&checkBox, &QCheckBox::toggled, this,
        [this, write = std::move(write)](bool isChecked) { write(m_model, isChecked); });
    const auto show = [this, &checkBox, read = std::move(read)] {
        const QSignalBlocker blocker(checkBox);
        checkBox.setChecked(read(m_model.edited()));
    };
    add({field, &row, show, std::move(driveText)});
}

void FieldBinder::bind(FieldRow& row, SourceCombo& combo, int dimension,
    std::function<QString(const DimSource&)> uri, std::function<QString(const DimSource&)> name)
{
    connect(&combo, &SourceCombo::chosen, this,
        [this, dimension](const QString& entered) { Q_EMIT sourceEntered(dimension, entered); });
    connect(
        &combo, &SourceCombo::edited, this, [this, dimension] { Q_EMIT sourceEdited(dimension); });
    const auto index = static_cast<std::size_t>(dimension - 1);
    const auto show = [this, &combo, index, uri = std::move(uri), name] {
        const DimSource& source = m_model.edited().sources.at(index);
        combo.showValue(uri(source), source.isSet() ? name(source) : QString());
    };
    const auto driveText = [index, name](const CompensationSetup& drive) {
        return name(drive.sources.at(index));
    };
    add({sourceField(dimension), &row, show, driveText});
}

void FieldBinder::refresh()
{
    for (const Binding& binding : m_bindings)
        show(m_model, binding);
}

void FieldBinder::refresh(Field field)
{
    for (const Binding& binding : m_bindings) {
        if (binding.field == field)
            show(m_model, binding);
    }
}

void FieldBinder::add(Binding binding)
{
    connect(binding.row, &FieldRow::revertRequested, this,
        [this, field = binding.field] { m_model.revert(field); });
    show(m_model, binding);
    m_bindings.push_back(std::move(binding));
}

void FieldBinder::show(const SetupModel& model, const Binding& binding)
{
    binding.show();
    const bool isDirty = model.isDirty(binding.field);
    binding.row->setDirty(isDirty, isDirty ? binding.driveText(model.baseline()) : QString());
}

} // namespace axiscomp::ui
