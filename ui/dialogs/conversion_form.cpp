// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/conversion_form.h"

#include "ui/dialogs/file_filters.h"
#include "ui/dialogs/setting_fields.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QRegularExpression>
#include <QSignalBlocker>

namespace axiscomp::ui {

namespace {

using Kind = ResamplingChoice::Kind;

/// Whole sentences stand in the list; the field may be narrower.
QComboBox* combo(const char* name, int items)
{
    auto* box = new QComboBox;
    box->setObjectName(QLatin1StringView(name));
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(30);
    for (int i = 0; i < items; ++i)
        box->addItem(QString());
    return box;
}

QString listText(const std::vector<double>& numbers)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    QStringList texts;
    for (const double number : numbers)
        texts += locale.toString(number, 'g', QLocale::FloatingPointShortest);
    return texts.join(QStringLiteral("; "));
}

} // namespace

ConversionForm::ConversionForm(Purpose purpose, QWidget* parent)
    : QWidget(parent)
    , m_purpose(purpose)
    , m_form(new QFormLayout(this))
    , m_format(combo("conversionFormat", 0))
    , m_sign(combo("signField", 3))
    , m_direction(combo("directionField", 4))
    , m_dropsWrap(new QCheckBox)
    , m_grid(combo("gridField", 4))
    , m_number(new QLineEdit)
    , m_method(combo("methodField", 2))
    , m_holds(new QCheckBox)
    , m_settings(new SettingFields(*m_form, 1, purpose == Purpose::Export, this))
{
    build();
    connectFields();
    setQuestions(false, false);
    showGridRows();
}

void ConversionForm::build()
{
    m_dropsWrap->setObjectName(QStringLiteral("dropsWrapField"));
    m_number->setObjectName(QStringLiteral("gridNumberField"));
    m_holds->setObjectName(QStringLiteral("holdsEndsField"));
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    for (QWidget* field : std::initializer_list<QWidget*>{m_format, m_sign, m_direction}) {
        auto* label = new QLabel;
        label->setBuddy(field);
        m_form->addRow(label, field);
    }
    m_form->addRow(QString(), m_dropsWrap);
    for (QWidget* field : std::initializer_list<QWidget*>{m_grid, m_number, m_method}) {
        auto* label = new QLabel;
        label->setBuddy(field);
        m_form->addRow(label, field);
    }
    m_form->addRow(QString(), m_holds);
}

void ConversionForm::connectFields()
{
    connect(m_format, &QComboBox::currentIndexChanged, this, &ConversionForm::chooseFamily);
    connect(m_grid, &QComboBox::currentIndexChanged, this, &ConversionForm::showGridRows);
    for (QComboBox* box : {m_format, m_sign, m_direction, m_grid, m_method})
        connect(box, &QComboBox::currentIndexChanged, this, &ConversionForm::changed);
    for (QCheckBox* box : {m_dropsWrap, m_holds})
        connect(box, &QCheckBox::toggled, this, &ConversionForm::changed);
    connect(m_number, &QLineEdit::textChanged, this, &ConversionForm::changed);
    connect(m_settings, &SettingFields::changed, this, &ConversionForm::changed);
}

void ConversionForm::setFamilies(
    const std::vector<const TableFamily*>& families, const TableFamily* current)
{
    const QSignalBlocker blocker(m_format);
    m_format->clear();
    for (const TableFamily* family : families)
        m_format->addItem(
            familyText(*family), QVariant::fromValue(static_cast<const void*>(family)));
    m_format->setCurrentIndex(
        m_format->findData(QVariant::fromValue(static_cast<const void*>(current))));
    chooseFamily();
}

const TableFamily* ConversionForm::family() const
{
    return static_cast<const TableFamily*>(m_format->currentData().value<const void*>());
}

void ConversionForm::chooseFamily()
{
    m_settings->setFamily(family());
    QWidget* before = m_format;
    for (QWidget* field : m_settings->fields()) {
        setTabOrder(before, field);
        before = field;
    }
    setTabOrder(before, m_sign);
    fillItems();
    nameSettings();
}

void ConversionForm::setChoices(const ImportChoices& choices)
{
    const QSignalBlocker blocker(this);
    if (choices.family)
        m_format->setCurrentIndex(
            m_format->findData(QVariant::fromValue(static_cast<const void*>(choices.family))));
    m_settings->setValues(choices.settings);
    m_sign->setCurrentIndex(choices.sign ? static_cast<int>(*choices.sign) + 1 : 0);
    m_direction->setCurrentIndex(choices.direction ? static_cast<int>(*choices.direction) + 1 : 0);
    m_dropsWrap->setChecked(choices.dropsWrap);
    m_grid->setCurrentIndex(static_cast<int>(choices.resampling.kind));
    m_number->setText(listText(choices.resampling.numbers));
    m_method->setCurrentIndex(static_cast<int>(choices.resampling.method));
    m_holds->setChecked(choices.resampling.holdsEnds);
}

ImportChoices ConversionForm::choices() const
{
    ImportChoices choices;
    choices.family = family();
    choices.settings = m_settings->values();
    if (m_sign->currentIndex() > 0)
        choices.sign = static_cast<SignConvention>(m_sign->currentIndex() - 1);
    if (m_direction->currentIndex() > 0)
        choices.direction = static_cast<DirectionChoice>(m_direction->currentIndex() - 1);
    choices.dropsWrap = m_dropsWrap->isChecked();
    choices.resampling = resampling();
    return choices;
}

ResamplingChoice ConversionForm::resampling() const
{
    ResamplingChoice choice;
    choice.kind = static_cast<Kind>(std::max(m_grid->currentIndex(), 0));
    if (choice.kind == Kind::None)
        return choice;
    choice.numbers = numbers().value_or(std::vector<double>{});
    choice.method = static_cast<ResamplingMethod>(std::max(m_method->currentIndex(), 0));
    choice.holdsEnds = choice.kind != Kind::Within && m_holds->isChecked();
    return choice;
}

/// "21", "21; 31"; a comma separates where it is no decimal sign.
std::optional<std::vector<double>> ConversionForm::numbers() const
{
    QLocale locale;
    locale.setNumberOptions(QLocale::RejectGroupSeparator);
    const bool isComma = locale.decimalPoint() == QStringLiteral(",");
    const QRegularExpression separator(
        isComma ? QStringLiteral("[;\\s]+") : QStringLiteral("[;,\\s]+"));
    std::vector<double> numbers;
    const QStringList parts = m_number->text().split(separator, Qt::SkipEmptyParts);
    for (const QString& part : parts) {
        bool isNumber = false;
        numbers.push_back(locale.toDouble(part, &isNumber));
        if (!isNumber)
            return std::nullopt;
    }
    return numbers.empty() ? std::nullopt : std::optional(numbers);
}

QString ConversionForm::problem() const
{
    if (!family())
        return tr("Choose the format.");
    if (m_grid->currentIndex() > 0 && m_number->text().trimmed().isEmpty())
        return tr("Enter the number for the even grid.");
    if (m_grid->currentIndex() > 0 && !numbers())
        return tr("\"%1\" is no number, and no list such as 21; 31.").arg(m_number->text());
    return {};
}

void ConversionForm::setQuestions(bool hasDirections, bool hasWrap)
{
    m_form->setRowVisible(m_direction, hasDirections);
    m_form->setRowVisible(m_dropsWrap, hasWrap);
}

void ConversionForm::showGridRows()
{
    const Kind kind = static_cast<Kind>(std::max(m_grid->currentIndex(), 0));
    m_form->setRowVisible(m_number, kind != Kind::None);
    m_form->setRowVisible(m_method, kind != Kind::None);
    m_form->setRowVisible(m_holds, kind == Kind::Points || kind == Kind::Distance);
    nameNumber();
}

} // namespace axiscomp::ui
