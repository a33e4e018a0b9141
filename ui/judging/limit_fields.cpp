// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/judging/limit_fields.h"

#include "ui/fields/wrong_mark.h"
#include "ui/record/record_model.h"
#include "ui/style/plain_label.h"
#include "ui/style/tone_label.h"
#include "ui/text/fine_scale.h"
#include "ui/text/message_text.h"
#include "ui/text/translated_text.h"

#include <QGridLayout>
#include <QLineEdit>

#include <algorithm>
#include <array>
#include <utility>

namespace axiscomp::ui {

namespace {

using F = Iso230Figure;
constexpr std::array<std::optional<F>, 6> limitedFigures{
    F::A, F::E, F::M, F::B, F::R, std::nullopt};
constexpr int fieldsInARow = 2;
/// In the same order; each has a key of its own on the page.
constexpr std::array labels{QT_TRANSLATE_NOOP("axiscomp::ui::LimitFields", "&Accuracy A"),
    QT_TRANSLATE_NOOP("axiscomp::ui::LimitFields", "Systematic &E"),
    QT_TRANSLATE_NOOP("axiscomp::ui::LimitFields", "Range of means &M"),
    QT_TRANSLATE_NOOP("axiscomp::ui::LimitFields", "Reversal &B"),
    QT_TRANSLATE_NOOP("axiscomp::ui::LimitFields", "Repeatab&ility R"),
    QT_TRANSLATE_NOOP("axiscomp::ui::LimitFields", "&Uncertainty U")};

} // namespace

LimitFields::LimitFields(RecordModel& record, QWidget* parent)
    : QWidget(parent)
    , m_record(record)
    , m_problem(new ToneLabel)
{
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    for (const auto& figure : limitedFigures) {
        const int number = static_cast<int>(m_fields.size());
        Field field{figure, new PlainLabel, new QLineEdit, {}};
        field.label->setBuddy(field.edit);
        field.edit->setObjectName(figure
                ? QStringLiteral("tolerance%1").arg(QLatin1StringView(figureName(*figure).data()))
                : QStringLiteral("uncertainty"));
        field.edit->setMinimumWidth(
            field.edit->fontMetrics().horizontalAdvance(QStringLiteral("100.5 µm")) + 12);
        const int row = number / fieldsInARow;
        const int column = 2 * (number % fieldsInARow);
        layout->addWidget(field.label, row, column);
        layout->addWidget(field.edit, row, column + 1);
        layout->setColumnStretch(column + 1, 1);
        const auto index = m_fields.size();
        connect(field.edit, &QLineEdit::editingFinished, this,
            [this, index] { take(m_fields[index]); });
        m_fields.push_back(std::move(field));
    }
    m_problem->setObjectName(QStringLiteral("limitProblem"));
    m_problem->setTone(Tone::Error);
    m_problem->setWordWrap(true);
    layout->addWidget(m_problem, layout->rowCount(), 0, 1, 2 * fieldsInARow);
    m_problem->hide();
    connect(&record, &RecordModel::opened, this, &LimitFields::forgetTyped);
    connect(&record, &RecordModel::changed, this, &LimitFields::follow);
    connect(&record, &RecordModel::stateChanged, this, &LimitFields::follow);
    retranslate();
}

bool LimitFields::isAngular() const
{
    return m_record.isMeasurementShown() ? m_record.state().measurement->isAngular
                                         : m_record.record().areLimitsAngles;
}

/// A limit in mm is none of an angle: it is not shown as if it were.
std::optional<double> LimitFields::valueOf(const Field& field) const
{
    const Record& record = m_record.record();
    if (record.areLimitsAngles != isAngular())
        return std::nullopt;
    if (!field.figure)
        return record.uncertainty;
    const auto found = std::ranges::find(record.tolerances, *field.figure, &Tolerance::figure);
    return found == record.tolerances.end() ? std::nullopt : std::optional(found->value);
}

void LimitFields::follow()
{
    // The unit is that of the measurement, which is not known while it is being read.
    const bool hasTargets =
        m_record.isMeasurementShown() && m_record.state().measurement->hasTargets();
    for (const Field& field : m_fields) {
        field.edit->setEnabled(hasTargets);
        // What is being typed is the user's, until it is done.
        if (field.edit->isModified())
            continue;
        const auto value = valueOf(field);
        field.edit->setText(value ? amountText(*value, isAngular()) : QString());
    }
}

void LimitFields::forgetTyped()
{
    for (Field& field : m_fields) {
        field.edit->setModified(false);
        field.problem.reset();
    }
    showProblems();
}

void LimitFields::take(Field& field)
{
    if (!field.edit->isModified() || !m_record.isMeasurementShown())
        return;
    const QString text = field.edit->text().trimmed();
    std::optional<double> value;
    field.problem.reset();
    if (!text.isEmpty()) {
        const auto amount = amountOf(text, isAngular());
        if (amount)
            value = *amount;
        else
            field.problem = amount.error();
    }
    showProblems();
    if (field.problem)
        return;
    field.edit->setModified(false);
    if (field.figure)
        m_record.setTolerance(*field.figure, value);
    else
        m_record.setUncertainty(value);
    follow();
}

/// One sentence has room: the first field that was not taken. The others are marked, and say theirs
/// themselves.
void LimitFields::showProblems()
{
    const auto first = std::ranges::find_if(
        m_fields, [](const Field& field) { return field.problem.has_value(); });
    const bool isOpen = first != m_fields.end();
    m_problem->setText(isOpen ? errorText(*first->problem) : QString());
    m_problem->setVisible(isOpen);
    for (const Field& field : m_fields) {
        markWrong(*field.edit, field.problem.has_value());
        describe(field);
    }
}

void LimitFields::describe(const Field& field)
{
    const QString purpose = field.figure
        ? tr("The largest value that is allowed, such as 10 µm; empty: no tolerance")
        : tr("Uncertainty of the measurement with k = 2, such as 2.1 µm; empty: not stated");
    const QString said = field.problem ? errorText(*field.problem) : purpose;
    field.edit->setToolTip(said);
    field.edit->setAccessibleDescription(said);
}

void LimitFields::retranslate()
{
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        const Field& field = m_fields[i];
        field.label->setText(tr(labels.at(i)));
        field.edit->setAccessibleName(field.figure
                ? tr("Tolerance: %1").arg(translated(figureText(*field.figure)))
                : tr("Uncertainty U, k = 2"));
    }
    showProblems();
    follow();
}

} // namespace axiscomp::ui
