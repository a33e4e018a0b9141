// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/setting_fields.h"

#include "ui/style/plain_label.h"
#include "ui/text/free_key.h"
#include "ui/text/message_text.h"
#include "ui/text/typed_number.h"
#include "ui/text/value_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QSignalBlocker>

namespace axiscomp::ui {

namespace {

// The keys of all formats, with blanks in place of "-", and what can be chosen for them: for
// lupdate.
[[maybe_unused]] constexpr const char* settingWords[] = {
    QT_TRANSLATE_NOOP("Setting", "column axis"),
    QT_TRANSLATE_NOOP("Setting", "row axis"),
    QT_TRANSLATE_NOOP("Setting", "output axis 1"),
    QT_TRANSLATE_NOOP("Setting", "output axis 2"),
    QT_TRANSLATE_NOOP("Setting", "output axis 3"),
    QT_TRANSLATE_NOOP("Setting", "source counts per unit"),
    QT_TRANSLATE_NOOP("Setting", "target counts per unit"),
    QT_TRANSLATE_NOOP("Setting", "column counts per unit"),
    QT_TRANSLATE_NOOP("Setting", "source motor"),
    QT_TRANSLATE_NOOP("Setting", "target motor"),
    QT_TRANSLATE_NOOP("Setting", "row motor"),
    QT_TRANSLATE_NOOP("Setting", "column motor"),
    QT_TRANSLATE_NOOP("Setting", "position"),
    QT_TRANSLATE_NOOP("Setting", "desired"),
    QT_TRANSLATE_NOOP("Setting", "actual"),
    QT_TRANSLATE_NOOP("Setting", "counts per unit"),
    QT_TRANSLATE_NOOP("Setting", "source axis 1"),
    QT_TRANSLATE_NOOP("Setting", "source axis 2"),
    QT_TRANSLATE_NOOP("Setting", "target axis"),
    QT_TRANSLATE_NOOP("Setting", "zone"),
    QT_TRANSLATE_NOOP("Setting", "declare"),
    QT_TRANSLATE_NOOP("Setting", "form"),
    QT_TRANSLATE_NOOP("Setting", "errormap"),
    QT_TRANSLATE_NOOP("Setting", "connect"),
    QT_TRANSLATE_NOOP("Setting", "any distance"),
    QT_TRANSLATE_NOOP("Setting", "reference number"),
    QT_TRANSLATE_NOOP("Setting", "interval"),
    QT_TRANSLATE_NOOP("Setting", "detection unit"),
    QT_TRANSLATE_NOOP("Setting", "magnification"),
    QT_TRANSLATE_NOOP("Setting", "reference position"),
    QT_TRANSLATE_NOOP("Setting", "first number"),
    QT_TRANSLATE_NOOP("Setting", "last number"),
    QT_TRANSLATE_NOOP("Setting", "first record"),
    QT_TRANSLATE_NOOP("Setting", "largest step"),
    QT_TRANSLATE_NOOP("Setting", "unit"),
    QT_TRANSLATE_NOOP("Setting", "table"),
    QT_TRANSLATE_NOOP("Setting", "inch"),
    QT_TRANSLATE_NOOP("Setting", "position unit"),
    QT_TRANSLATE_NOOP("Setting", "value unit"),
    QT_TRANSLATE_NOOP("Setting", "wrap range"),
    QT_TRANSLATE_NOOP("Setting", "master axis"),
    QT_TRANSLATE_NOOP("Setting", "master1 axis"),
    QT_TRANSLATE_NOOP("Setting", "master2 axis"),
    QT_TRANSLATE_NOOP("Setting", "n cycles"),
    QT_TRANSLATE_NOOP("Setting", "master kind"),
    QT_TRANSLATE_NOOP("Setting", "master1 kind"),
    QT_TRANSLATE_NOOP("Setting", "master2 kind"),
    QT_TRANSLATE_NOOP("Setting", "axis kind"),
    QT_TRANSLATE_NOOP("Setting", "modulo"),
    QT_TRANSLATE_NOOP("Setting", "modulo1"),
    QT_TRANSLATE_NOOP("Setting", "modulo2"),
    QT_TRANSLATE_NOOP("Setting", "list unit"),
    QT_TRANSLATE_NOOP("Setting", "increments per unit"),
    QT_TRANSLATE_NOOP("Setting", "decimals"),
    QT_TRANSLATE_NOOP("Setting", "axis"),
    QT_TRANSLATE_NOOP("Setting", "type"),
    QT_TRANSLATE_NOOP("Setting", "name"),
    QT_TRANSLATE_NOOP("Setting", "first table"),
    QT_TRANSLATE_NOOP("Setting", "input axis"),
    QT_TRANSLATE_NOOP("Setting", "output axis"),
    QT_TRANSLATE_NOOP("Setting", "encoder"),
    QT_TRANSLATE_NOOP("Setting", "persistent"),
    QT_TRANSLATE_NOOP("Setting", "rotary axes"),
    QT_TRANSLATE_NOOP("Setting", "primary unit"),
    QT_TRANSLATE_NOOP("Setting", "secondary unit"),
    QT_TRANSLATE_NOOP("Setting", "units"),
    QT_TRANSLATE_NOOP("Setting", "primary"),
    QT_TRANSLATE_NOOP("Setting", "metric"),
    QT_TRANSLATE_NOOP("Setting", "increments"),
    QT_TRANSLATE_NOOP("Setting", "linear"),
    QT_TRANSLATE_NOOP("Setting", "rotary"),
};

QStringList choicesOf(const FormatSetting& setting)
{
    return qString(setting.choices).split(QStringLiteral(", "), Qt::SkipEmptyParts);
}

/// A key or a choice in the language of the window.
QString word(const QString& english)
{
    return QCoreApplication::translate("Setting", english.toUtf8().constData());
}

/// "Counts per unit", with a key that nothing else has yet: of its letters, or a digit behind it.
QString nameOf(const FormatSetting& setting, QSet<QChar>& usedKeys)
{
    QString name = word(qString(setting.key).replace(u'-', u' '));
    name[0] = name[0].toUpper();
    return withFreeKey(std::move(name), usedKeys);
}

/// Numbers are typed as the language writes them, and core reads them with a decimal point.
std::string plainNumber(const QString& text)
{
    const auto number = typedNumber(text);
    return number ? QString::number(*number, 'g', QLocale::FloatingPointShortest).toStdString()
                  : text.toStdString();
}

QString writtenNumber(const QString& plain)
{
    bool isNumber = false;
    const double number = plain.toDouble(&isNumber);
    QLocale language;
    language.setNumberOptions(QLocale::OmitGroupSeparator);
    return isNumber ? language.toString(number, 'g', QLocale::FloatingPointShortest) : plain;
}

} // namespace

QChar keyOf(const QString& text)
{
    const qsizetype place =
        QString(text).replace(QStringLiteral("&&"), QStringLiteral("__")).indexOf(u'&');
    return place < 0 || place + 1 >= text.size() ? QChar() : text[place + 1].toLower();
}

SettingFields::SettingFields(QFormLayout& form, int firstRow, bool isWriting, QObject* parent)
    : QObject(parent)
    , m_form(form)
    , m_firstRow(firstRow)
    , m_isWriting(isWriting)
{
}

void SettingFields::setFormat(const TableFormat* format)
{
    for (const Row& row : m_rows) {
        const std::string value = valueOf(row);
        if (value != row.shown && value.empty())
            m_given.erase(std::string(row.setting.key));
        else if (value != row.shown)
            m_given[std::string(row.setting.key)] = value;
        m_form.removeRow(row.field);
    }
    m_rows.clear();
    if (format == nullptr)
        return;
    for (const FormatSetting& setting : formatSettings(format->facts, m_isWriting))
        addRow(setting);
    setValues(m_given);
}

QWidget* SettingFields::makeField(const FormatSetting& setting)
{
    switch (setting.kind) {
    case FormatSetting::Kind::YesNo: {
        auto* box = new QCheckBox;
        connect(box, &QCheckBox::toggled, this, &SettingFields::changed);
        return box;
    }
    case FormatSetting::Kind::Choice: {
        auto* combo = new QComboBox;
        combo->addItem(QString(), QString());
        for (const QString& choice : choicesOf(setting))
            combo->addItem(choice, choice);
        connect(combo, &QComboBox::currentIndexChanged, this, &SettingFields::changed);
        return combo;
    }
    case FormatSetting::Kind::Text:
    case FormatSetting::Kind::WholeNumber:
    case FormatSetting::Kind::Number:
        break;
    }
    auto* line = new QLineEdit;
    connect(line, &QLineEdit::textChanged, this, &SettingFields::changed);
    return line;
}

void SettingFields::addRow(const FormatSetting& setting)
{
    Row row{setting, nullptr, makeField(setting), {}};
    row.field->setObjectName(QStringLiteral("setting_") + qString(setting.key));
    const int place = m_firstRow + static_cast<int>(m_rows.size());
    if (setting.kind == FormatSetting::Kind::YesNo) {
        m_form.insertRow(place, QString(), row.field);
    } else {
        row.label = new PlainLabel;
        row.label->setBuddy(row.field);
        m_form.insertRow(place, row.label, row.field);
    }
    m_rows.push_back(row);
}

void SettingFields::show(const Row& row, const std::string& value)
{
    const QSignalBlocker blocker(row.field);
    const QString text = QString::fromStdString(value);
    if (auto* box = qobject_cast<QCheckBox*>(row.field))
        box->setChecked(value.empty() ? row.setting.standard == "yes" : value == "yes");
    else if (auto* combo = qobject_cast<QComboBox*>(row.field))
        combo->setCurrentIndex(std::max(combo->findData(text), 0));
    else if (auto* line = qobject_cast<QLineEdit*>(row.field))
        line->setText(row.setting.kind == FormatSetting::Kind::Number ? writtenNumber(text) : text);
}

void SettingFields::setValues(const FormatSettings& values)
{
    m_given = values;
    for (Row& row : m_rows) {
        const auto given = values.find(row.setting.key);
        show(row, given == values.end() ? std::string() : given->second);
        row.shown = valueOf(row);
    }
}

std::string SettingFields::valueOf(const Row& row) const
{
    if (const auto* box = qobject_cast<const QCheckBox*>(row.field)) {
        const bool isStandard = box->isChecked() == (row.setting.standard == "yes");
        return isStandard ? std::string() : box->isChecked() ? "yes" : "no";
    }
    if (const auto* combo = qobject_cast<const QComboBox*>(row.field))
        return combo->currentData().toString().toStdString();
    const QString text = qobject_cast<const QLineEdit*>(row.field)->text().trimmed();
    return row.setting.kind == FormatSetting::Kind::Number ? plainNumber(text) : text.toStdString();
}

QString SettingFields::problem() const
{
    for (const Row& row : m_rows) {
        const auto* line = qobject_cast<const QLineEdit*>(row.field);
        if (line && row.setting.kind == FormatSetting::Kind::Number
            && hasThousands(line->text().trimmed()))
            return line->accessibleName() + QStringLiteral(": ")
                + sentenceText(thousandsProblem(line->text().trimmed()));
    }
    return {};
}

FormatSettings SettingFields::values() const
{
    FormatSettings values;
    for (const Row& row : m_rows) {
        if (std::string value = valueOf(row); !value.empty())
            values[std::string(row.setting.key)] = std::move(value);
    }
    return values;
}

QList<QWidget*> SettingFields::fields() const
{
    QList<QWidget*> fields;
    for (const Row& row : m_rows)
        fields += row.field;
    return fields;
}

void SettingFields::retranslate(QSet<QChar> usedKeys)
{
    const QString absent = m_isWriting ? tr("not given") : tr("as the file says");
    for (const Row& row : m_rows) {
        const QString name = nameOf(row.setting, usedKeys);
        if (row.label)
            row.label->setText(name);
        else if (auto* box = qobject_cast<QCheckBox*>(row.field))
            box->setText(name);
        row.field->setToolTip(sentenceText(row.setting.meaning));
        row.field->setAccessibleName(withoutKey(name));
        row.field->setAccessibleDescription(row.field->toolTip());
        const QString standard = qString(row.setting.standard);
        if (auto* combo = qobject_cast<QComboBox*>(row.field)) {
            combo->setItemText(
                0, standard.isEmpty() ? absent : tr("default: %1").arg(word(standard)));
            for (int i = 1; i < combo->count(); ++i)
                combo->setItemText(i, word(combo->itemData(i).toString()));
        }
        if (auto* line = qobject_cast<QLineEdit*>(row.field))
            line->setPlaceholderText(row.setting.isNeeded ? tr("needed")
                    : standard.isEmpty()                  ? absent
                                                          : tr("default: %1").arg(standard));
    }
}

} // namespace axiscomp::ui
