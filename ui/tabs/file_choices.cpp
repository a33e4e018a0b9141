// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tabs/file_choices.h"

#include "ui/dialogs/file_filters.h"
#include "ui/style/plain_label.h"
#include "ui/text/free_key.h"
#include "ui/text/value_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QSpinBox>

#include <array>

namespace axiscomp::ui {

namespace {

constexpr std::array fileUnits{"nm", "um", "mm", "m", "inch", "deg", "arcsec", "mrad", "rad"};

void describe(QWidget& field, const QString& name, const QString& description)
{
    field.setAccessibleName(name);
    field.setToolTip(description);
    field.setAccessibleDescription(description);
}

} // namespace

FileChoices::FileChoices(QWidget* parent)
    : QWidget(parent)
    , m_form(new QFormLayout(this))
    , m_format(new QComboBox)
    , m_values(new QComboBox)
    , m_unit(new QComboBox)
    , m_valueUnit(new QComboBox)
    , m_skippedLines(new QSpinBox)
    , m_fromOrder(new QCheckBox)
    , m_invert(new QCheckBox)
{
    setObjectName(QStringLiteral("fileChoices"));
    build();
    retranslate();
}

void FileChoices::build()
{
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_format->addItem(QString(), QString());
    for (const MeasurementFormat* format : measurementFormats())
        m_format->addItem(QString(), qString(format->facts.name));
    for (int n = 0; n < 3; ++n)
        m_values->addItem(QString());
    for (QComboBox* units : {m_unit, m_valueUnit}) {
        units->addItem(QString(), QString());
        for (const char* unit : fileUnits)
            units->addItem(QLatin1StringView(unit), QLatin1StringView(unit));
    }
    for (QComboBox* list : {m_format, m_values, m_unit, m_valueUnit}) {
        list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        list->setMinimumContentsLength(16);
        connect(list, &QComboBox::activated, this, &FileChoices::report);
    }
    constexpr int mostLines = 100'000;
    m_skippedLines->setMaximum(mostLines);
    m_skippedLines->setKeyboardTracking(false);
    connect(m_skippedLines, &QSpinBox::valueChanged, this, &FileChoices::report);
    for (QCheckBox* box : {m_fromOrder, m_invert})
        connect(box, &QCheckBox::clicked, this, &FileChoices::report);
    addRow(m_formatLabel, m_format, "measurementFormat");
    addRow(m_valuesLabel, m_values, "measurementValues");
    addRow(m_unitLabel, m_unit, "targetUnit");
    addRow(m_valueUnitLabel, m_valueUnit, "valueUnit");
    addRow(m_skippedLinesLabel, m_skippedLines, "skippedLines");
    m_fromOrder->setObjectName(QStringLiteral("directionFromOrder"));
    m_invert->setObjectName(QStringLiteral("invertReference"));
    m_form->addRow(m_fromOrder);
    m_form->addRow(m_invert);
}

void FileChoices::addRow(QLabel*& label, QWidget* field, const char* name)
{
    label = new PlainLabel;
    label->setBuddy(field);
    field->setObjectName(QLatin1StringView(name));
    m_form->addRow(label, field);
}

void FileChoices::show(const MeasurementChoices& choices)
{
    m_shown = choices;
    m_format->setCurrentIndex(std::max(0, m_format->findData(qString(choices.format))));
    m_values->setCurrentIndex(static_cast<int>(choices.values));
    m_unit->setCurrentIndex(std::max(0, m_unit->findData(qString(choices.unit))));
    m_valueUnit->setCurrentIndex(std::max(0, m_valueUnit->findData(qString(choices.valueUnit))));
    // A number that is being typed is left to the user.
    if (m_skippedLines->value() != static_cast<int>(choices.skippedLines)) {
        const QSignalBlocker blocker(m_skippedLines);
        m_skippedLines->setValue(static_cast<int>(choices.skippedLines));
    }
    m_fromOrder->setChecked(choices.takesDirectionFromOrder);
    m_invert->setChecked(choices.invertsReference);
}

void FileChoices::report()
{
    MeasurementChoices choices = m_shown;
    choices.format = m_format->currentData().toString().toStdString();
    choices.values = static_cast<MeasurementReadOptions::Values>(m_values->currentIndex());
    choices.unit = m_unit->currentData().toString().toStdString();
    choices.valueUnit = m_valueUnit->currentData().toString().toStdString();
    choices.skippedLines = static_cast<std::size_t>(m_skippedLines->value());
    choices.takesDirectionFromOrder = m_fromOrder->isChecked();
    choices.invertsReference = m_invert->isChecked();
    if (choices != m_shown)
        Q_EMIT chosen(choices);
}

void FileChoices::retranslate()
{
    m_formatLabel->setText(tr("&Format"));
    m_format->setItemText(0, tr("by its content"));
    int item = 0;
    for (const MeasurementFormat* format : measurementFormats())
        m_format->setItemText(++item, measurementFormatText(*format));
    m_valuesLabel->setText(tr("&Values"));
    m_values->setItemText(0, tr("as the file says"));
    m_values->setItemText(1, tr("deviations from the target"));
    m_values->setItemText(2, tr("positions of the reference"));
    m_unitLabel->setText(tr("&Unit of targets"));
    m_valueUnitLabel->setText(tr("Unit &of values"));
    m_skippedLinesLabel->setText(tr("Lines &before the header"));
    for (QComboBox* units : {m_unit, m_valueUnit})
        units->setItemText(0, tr("as the file says"));
    m_fromOrder->setText(tr("D&irections by the order of targets"));
    m_invert->setText(tr("The reference counts the other &way"));
    describe(*m_format, withoutKey(m_formatLabel->text()), tr("The format of the file"));
    describe(*m_values, withoutKey(m_valuesLabel->text()),
        tr("A deviation is the reference position minus the target"));
    describe(*m_unit, withoutKey(m_unitLabel->text()), tr("For a file that does not name it"));
    describe(
        *m_valueUnit, withoutKey(m_valueUnitLabel->text()), tr("For a file that does not name it"));
    describe(*m_skippedLines, withoutKey(m_skippedLinesLabel->text()),
        tr("Lines of a CSV file that come before the names of its columns"));
    describe(*m_fromOrder, withoutKey(m_fromOrder->text()),
        tr("For a file without directions: a run is up while its targets rise"));
    describe(*m_invert, withoutKey(m_invert->text()),
        tr("For an instrument that counts down while the axis moves up"));
}

} // namespace axiscomp::ui
