// SPDX-License-Identifier: GPL-3.0-or-later
// The words of the form, in the language of the window.
#include "ui/dialogs/conversion_form.h"
#include "ui/dialogs/file_filters.h"
#include "ui/dialogs/setting_fields.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>

namespace axiscomp::ui {

namespace {

void nameRow(QFormLayout& form, QWidget* field, const QString& text)
{
    auto* label = qobject_cast<QLabel*>(form.labelForField(field));
    if (label)
        label->setText(text);
    field->setAccessibleName(QString(text).remove(u'&'));
}

void describe(QWidget& field, const QString& text)
{
    field.setToolTip(text);
    field.setAccessibleDescription(text);
}

} // namespace

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
    nameRow(*m_form, m_sign, tr("&Sign"));
    nameRow(*m_form, m_direction, tr("&Direction"));
    nameRow(*m_form, m_grid, tr("Even &grid"));
    nameRow(*m_form, m_method, tr("&Between points"));
    m_dropsWrap->setText(tr("Treat a modulo axis as a &plain one"));
    m_holds->setText(tr("&Hold the end values beyond the data"));
    m_dropsWrap->setAccessibleName(m_dropsWrap->text().remove(u'&'));
    m_holds->setAccessibleName(m_holds->text().remove(u'&'));
}

void ConversionForm::describeFields()
{
    const bool isImport = m_purpose == Purpose::Import;
    describe(*m_format,
        isImport ? tr("The format that the file is read as") : tr("The format of the new file"));
    describe(*m_sign,
        isImport ? tr("What the values of the file are: added to the encoder position (feedback) "
                      "or added to the commanded position (command)")
                 : tr("What the values of the new file shall be: added to the encoder position "
                      "(feedback) or added to the commanded position (command)"));
    describe(*m_direction,
        tr("The drive has one value for both directions of motion: which one it shall have"));
    describe(*m_dropsWrap,
        tr("The table is used as it is, for an axis that stays within one revolution"));
    describe(*m_grid, tr("Brings the table onto evenly spaced positions"));
    describe(*m_method, tr("How the values between the positions of the table are made"));
    describe(*m_holds, tr("The even grid may end beyond the last position"));
}

void ConversionForm::fillItems()
{
    for (int i = 0; i < m_format->count(); ++i) {
        const auto* family =
            static_cast<const TableFamily*>(m_format->itemData(i).value<const void*>());
        m_format->setItemText(i, familyText(*family));
    }
    m_format->setPlaceholderText(tr("choose the format"));
    const TableFamily* const chosen = family();
    const QString usual = !chosen                        ? tr("as the format says")
        : chosen->facts.sign == SignConvention::Feedback ? tr("as the format says: feedback")
                                                         : tr("as the format says: command");
    m_sign->setItemText(0, usual);
    m_sign->setItemText(1, tr("feedback: added to the encoder position"));
    m_sign->setItemText(2, tr("command: added to the commanded position"));
    m_direction->setItemText(0, tr("choose one"));
    m_direction->setItemText(1, tr("the mean of both directions"));
    m_direction->setItemText(2, tr("the values of the positive direction"));
    m_direction->setItemText(3, tr("the values of the negative direction"));
    m_grid->setItemText(0, tr("the positions of the table"));
    m_grid->setItemText(1, tr("a number of points"));
    m_grid->setItemText(2, tr("a distance"));
    m_grid->setItemText(3, tr("as coarse as a deviation allows"));
    m_method->setItemText(0, tr("linear, as controllers do"));
    m_method->setItemText(1, tr("smooth (monotone cubic)"));
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
        describe(*m_number,
            tr("In the unit of the values; the fewest points that keep it are looked for"));
        return;
    }
}

void ConversionForm::nameSettings()
{
    QSet<QChar> used = m_usedKeys;
    const auto use = [&used](const QString& text) { used.insert(keyOf(text)); };
    for (QWidget* field :
        std::initializer_list<QWidget*>{m_format, m_sign, m_direction, m_grid, m_number, m_method})
        use(qobject_cast<QLabel*>(m_form->labelForField(field))->text());
    use(m_dropsWrap->text());
    use(m_holds->text());
    m_settings->retranslate(used);
}

} // namespace axiscomp::ui
