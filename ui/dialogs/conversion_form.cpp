// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/conversion_form.h"

#include "core/formats/formats.h"
#include "ui/dialogs/file_filters.h"
#include "ui/dialogs/setting_fields.h"
#include "ui/style/plain_label.h"
#include "ui/text/free_key.h"
#include "ui/text/typed_number.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QSignalBlocker>

#include <cmath>

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

QString numbersText(const std::vector<double>& numbers)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    QStringList texts;
    for (const double number : numbers)
        texts += locale.toString(number, 'g', QLocale::FloatingPointShortest);
    return texts.join(QStringLiteral("; "));
}

void nameRow(QFormLayout& form, QWidget* field, const QString& text)
{
    auto* label = qobject_cast<QLabel*>(form.labelForField(field));
    if (label)
        label->setText(text);
    field->setAccessibleName(withoutKey(text));
}

void describe(QWidget& field, const QString& text)
{
    field.setToolTip(text);
    field.setAccessibleDescription(text);
}

const std::array<std::string, 5> targetItems{
    "", sourceTarget(0), sourceTarget(1), sourceTarget(2), std::string(otherAxis)};

int targetIndex(const std::string& target)
{
    const auto item = std::ranges::find(targetItems, target);
    return item == targetItems.end() ? 0 : static_cast<int>(item - targetItems.begin());
}

} // namespace

ConversionForm::ConversionForm(Purpose purpose, QWidget* parent)
    : QWidget(parent)
    , m_purpose(purpose)
    , m_form(new QFormLayout(this))
    , m_format(combo("conversionFormat", 0))
    , m_target(combo("targetField", 5))
    , m_sign(combo("signField", 3))
    , m_direction(combo("directionField", 4))
    , m_dropsWrap(new QCheckBox)
    , m_missing(combo("missingField", 5))
    , m_snap(new QLineEdit)
    , m_grid(combo("gridField", 4))
    , m_number(new QLineEdit)
    , m_method(combo("methodField", 4))
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
    m_snap->setObjectName(QStringLiteral("snapField"));
    m_number->setObjectName(QStringLiteral("gridNumberField"));
    m_holds->setObjectName(QStringLiteral("holdsEndsField"));
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    for (QWidget* field :
        std::initializer_list<QWidget*>{m_format, m_target, m_sign, m_direction}) {
        auto* label = new PlainLabel;
        label->setBuddy(field);
        m_form->addRow(label, field);
    }
    m_form->addRow(QString(), m_dropsWrap);
    for (QWidget* field :
        std::initializer_list<QWidget*>{m_missing, m_snap, m_grid, m_number, m_method}) {
        auto* label = new PlainLabel;
        label->setBuddy(field);
        m_form->addRow(label, field);
    }
    m_form->addRow(QString(), m_holds);
}

void ConversionForm::connectFields()
{
    connect(m_format, &QComboBox::currentIndexChanged, this, &ConversionForm::chooseFormat);
    // A sign is stated of files of one format.
    connect(
        m_format, &QComboBox::currentIndexChanged, this, [this] { m_sign->setCurrentIndex(0); });
    connect(m_grid, &QComboBox::currentIndexChanged, this, &ConversionForm::showGridRows);
    for (QComboBox* box : {m_format, m_target, m_sign, m_direction, m_missing, m_grid, m_method})
        connect(box, &QComboBox::currentIndexChanged, this, &ConversionForm::changed);
    for (QCheckBox* box : {m_dropsWrap, m_holds})
        connect(box, &QCheckBox::toggled, this, &ConversionForm::changed);
    for (QLineEdit* field : {m_snap, m_number})
        connect(field, &QLineEdit::textChanged, this, &ConversionForm::changed);
    connect(m_settings, &SettingFields::changed, this, &ConversionForm::changed);
}

void ConversionForm::setFormats(
    const std::vector<const TableFormat*>& formats, const TableFormat* current)
{
    const QSignalBlocker blocker(m_format);
    m_format->clear();
    for (const TableFormat* format : formats)
        m_format->addItem(
            formatText(*format), QVariant::fromValue(static_cast<const void*>(format)));
    m_format->setCurrentIndex(
        m_format->findData(QVariant::fromValue(static_cast<const void*>(current))));
    chooseFormat();
}

const TableFormat* ConversionForm::format() const
{
    return static_cast<const TableFormat*>(m_format->currentData().value<const void*>());
}

void ConversionForm::chooseFormat()
{
    m_settings->setFormat(format());
    QWidget* before = m_format;
    for (QWidget* field : m_settings->fields()) {
        setTabOrder(before, field);
        before = field;
    }
    setTabOrder(before, m_target);
    const bool isImport = m_purpose == Purpose::Import && format() != nullptr;
    m_form->setRowVisible(m_missing, isImport && format()->facts.marksMissing);
    m_form->setRowVisible(m_snap, isImport && format() == &calibration_csv::format());
    fillItems();
    nameSettings();
}

void ConversionForm::setChoices(const ImportChoices& choices)
{
    const QSignalBlocker blocker(this);
    if (choices.format)
        m_format->setCurrentIndex(
            m_format->findData(QVariant::fromValue(static_cast<const void*>(choices.format))));
    m_settings->setValues(choices.settings);
    m_target->setCurrentIndex(targetIndex(choices.target));
    m_sign->setCurrentIndex(choices.sign ? static_cast<int>(*choices.sign) + 1 : 0);
    m_direction->setCurrentIndex(choices.direction ? static_cast<int>(*choices.direction) + 1 : 0);
    m_dropsWrap->setChecked(choices.dropsWrap);
    m_missing->setCurrentIndex(static_cast<int>(choices.missing));
    m_snap->setText(choices.snap > 0.0 ? numbersText({choices.snap}) : QString());
    m_grid->setCurrentIndex(static_cast<int>(choices.resampling.kind));
    m_number->setText(numbersText(choices.resampling.numbers));
    m_method->setCurrentIndex(static_cast<int>(choices.resampling.method));
    m_holds->setChecked(choices.resampling.holdsEnds);
}

ImportChoices ConversionForm::choices() const
{
    ImportChoices choices;
    choices.format = format();
    choices.settings = m_settings->values();
    choices.target = targetItems[static_cast<std::size_t>(std::max(m_target->currentIndex(), 0))];
    if (m_sign->currentIndex() > 0)
        choices.sign = static_cast<SignConvention>(m_sign->currentIndex() - 1);
    if (m_direction->currentIndex() > 0)
        choices.direction = static_cast<DirectionChoice>(m_direction->currentIndex() - 1);
    choices.dropsWrap = m_dropsWrap->isChecked();
    if (format() != nullptr && format()->facts.marksMissing)
        choices.missing = static_cast<MissingPoints>(std::max(m_missing->currentIndex(), 0));
    if (format() == &calibration_csv::format())
        choices.snap = snap().value_or(0.0);
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
    const auto parts = typedList(m_number->text(), locale.decimalPoint() != QStringLiteral(","));
    if (!parts)
        return std::nullopt;
    std::vector<double> numbers;
    for (const QString& part : *parts) {
        bool isNumber = false;
        numbers.push_back(locale.toDouble(part, &isNumber));
        if (!isNumber)
            return std::nullopt;
    }
    return numbers.empty() ? std::nullopt : std::optional(numbers);
}

std::optional<double> ConversionForm::snap() const
{
    const QString text = m_snap->text().trimmed();
    if (text.isEmpty())
        return 0.0;
    QLocale locale;
    locale.setNumberOptions(QLocale::RejectGroupSeparator);
    bool isNumber = false;
    const double tolerance = locale.toDouble(text, &isNumber);
    return isNumber && tolerance > 0.0 && std::isfinite(tolerance) ? std::optional(tolerance)
                                                                   : std::nullopt;
}

QString ConversionForm::problem() const
{
    if (!format())
        return tr("Choose the format.");
    if (const QString wrong = m_settings->problem(); !wrong.isEmpty())
        return wrong;
    if (format() == &calibration_csv::format() && !snap())
        return tr("\"%1\" is no tolerance: enter a number above 0, or nothing.")
            .arg(m_snap->text());
    if (m_grid->currentIndex() > 0 && m_number->text().trimmed().isEmpty())
        return tr("Enter a number for the even grid.");
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

void ConversionForm::retranslate(const QSet<QChar>& usedKeys)
{
    m_usedKeys = usedKeys;
    nameRows();
    describeFields();
    fillItems();
    nameNumber();
    nameSettings();
}

void ConversionForm::nameRows()
{
    nameRow(*m_form, m_format, tr("&Format"));
    nameRow(*m_form, m_target, tr("Target &axis"));
    nameRow(*m_form, m_sign, tr("&Sign"));
    nameRow(*m_form, m_direction, tr("&Direction"));
    nameRow(*m_form, m_missing, tr("Missin&g points"));
    nameRow(*m_form, m_snap, tr("Snap &tolerance"));
    nameRow(*m_form, m_grid, tr("&Even grid"));
    nameRow(*m_form, m_method, tr("&Between points"));
    m_dropsWrap->setText(tr("Treat a modulo axis as a &linear one"));
    m_holds->setText(tr("&Hold the end values beyond the data"));
    m_dropsWrap->setAccessibleName(withoutKey(m_dropsWrap->text()));
    m_holds->setAccessibleName(withoutKey(m_holds->text()));
}

void ConversionForm::describeFields()
{
    const bool isImport = m_purpose == Purpose::Import;
    describe(*m_format,
        isImport ? tr("The format that the file is read as") : tr("The format of the new file"));
    describe(*m_target,
        tr("The axis that the values correct: one of the sources, or another axis; the sign is "
           "converted accordingly"));
    describe(*m_sign,
        isImport ? tr("Whether the file's values are added to the encoder position (feedback) or "
                      "to the commanded position (command)")
                 : tr("Whether the new file's values are to be added to the encoder position "
                      "(feedback) or to the commanded position (command)"));
    describe(*m_direction,
        tr("The drive holds one value for both directions of motion; choose which one"));
    describe(*m_dropsWrap,
        tr("For an axis that stays within one revolution: the table is used as it is"));
    describe(*m_missing, tr("What becomes of points of the grid that have no value"));
    describe(*m_snap,
        tr("Positions that are this close to an even grid are taken for its positions, in their "
           "unit; empty: as they stand in the file"));
    describe(*m_grid, tr("Brings the table onto evenly spaced positions"));
    describe(*m_method, tr("How the values between the positions of the table are made"));
    describe(*m_holds, tr("The even grid may end beyond the last position"));
}

void ConversionForm::fillItems()
{
    for (int i = 0; i < m_format->count(); ++i) {
        const auto* format =
            static_cast<const TableFormat*>(m_format->itemData(i).value<const void*>());
        m_format->setItemText(i, formatText(*format));
    }
    m_format->setPlaceholderText(tr("choose the format"));
    const TableFormat* const chosen = format();
    const bool isFeedback = chosen && chosen->facts.sign == SignConvention::Feedback;
    const QString usual = !chosen   ? tr("as the format says")
        : chosen->facts.needsSign() ? (isFeedback ? tr("choose one; feedback is assumed")
                                                  : tr("choose one; command is assumed"))
        : isFeedback                ? tr("as the format says: feedback")
                                    : tr("as the format says: command");
    m_target->setItemText(
        0, m_purpose == Purpose::Import ? tr("as the file says") : tr("as the table says"));
    m_target->setItemText(1, tr("the first source"));
    m_target->setItemText(2, tr("the second source"));
    m_target->setItemText(3, tr("the third source"));
    m_target->setItemText(4, tr("another axis"));
    m_sign->setItemText(0, usual);
    m_sign->setItemText(1, tr("feedback: added to the encoder position"));
    m_sign->setItemText(2, tr("command: added to the commanded position"));
    m_direction->setItemText(0, tr("choose one"));
    m_direction->setItemText(1, tr("the mean of both directions"));
    m_direction->setItemText(2, tr("the values of the positive direction"));
    m_direction->setItemText(3, tr("the values of the negative direction"));
    m_missing->setItemText(0, tr("none may be missing"));
    m_missing->setItemText(1, tr("filled with the nearest measured value"));
    m_missing->setItemText(2, tr("filled from the plane through all points"));
    m_missing->setItemText(3, tr("filled smoothly, with the least bending"));
    m_missing->setItemText(4, tr("left out: the grid is cropped"));
    m_grid->setItemText(0, tr("the positions of the table"));
    m_grid->setItemText(1, tr("a number of points"));
    m_grid->setItemText(2, tr("a distance"));
    m_grid->setItemText(3, tr("coarsest within a deviation"));
    m_method->setItemText(0, tr("linear, as controllers do"));
    m_method->setItemText(1, tr("smooth (monotone cubic)"));
    m_method->setItemText(2, tr("spline (natural cubic)"));
    m_method->setItemText(3, tr("without noise (smoothing spline)"));
}

void ConversionForm::nameNumber()
{
    switch (static_cast<ResamplingChoice::Kind>(std::max(m_grid->currentIndex(), 0))) {
    case ResamplingChoice::Kind::None:
        return;
    case ResamplingChoice::Kind::Points:
        nameRow(*m_form, m_number, tr("&Number of points"));
        describe(*m_number, tr("At least 2; one number for all sources, or one for each: 21; 31"));
        return;
    case ResamplingChoice::Kind::Distance:
        nameRow(*m_form, m_number, tr("Dista&nce"));
        describe(*m_number,
            tr("In the unit of the positions; one number for all sources, or one for each: 5; 10"));
        return;
    case ResamplingChoice::Kind::Within:
        nameRow(*m_form, m_number, tr("Deviatio&n"));
        describe(*m_number, tr("In the unit of the values; the coarsest grid within it is used"));
        return;
    }
}

void ConversionForm::nameSettings()
{
    QSet<QChar> used = m_usedKeys;
    const auto use = [&used](const QString& text) { used.insert(keyOf(text)); };
    for (QWidget* field : std::initializer_list<QWidget*>{
             m_format, m_target, m_sign, m_direction, m_grid, m_number, m_method})
        use(qobject_cast<QLabel*>(m_form->labelForField(field))->text());
    use(m_dropsWrap->text());
    use(m_holds->text());
    m_settings->retranslate(used);
}

} // namespace axiscomp::ui
