// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/export_dialog.h"

#include "core/formats/formats.h"
#include "ui/text/message_text.h"

namespace axiscomp::ui {

namespace {

/// Of other controllers first: the drive's own formats are rarely what is looked for in an export.
std::vector<const TableFormat*> writableFormats(int dimensions, bool isOwnFirst)
{
    std::vector<const TableFormat*> others;
    std::vector<const TableFormat*> own;
    for (const TableFormat* format : tableFormats()) {
        const FormatFacts& facts = format->facts;
        if (!format->write || dimensions < facts.fewestDimensions
            || dimensions > facts.mostDimensions)
            continue;
        (isTriamec(*format) ? own : others).push_back(format);
    }
    others.insert(isOwnFirst ? others.begin() : others.end(), own.begin(), own.end());
    return others;
}

} // namespace

ExportDialog::ExportDialog(Options options, QWidget* parent)
    : ConversionDialog(ConversionForm::Purpose::Export, parent)
    , m_options(std::move(options))
    , m_job([this](const Result<TableExport>& result) {
        if (result)
            showReport(result->report);
        else
            showReason(errorText(result.error()));
    })
{
    setObjectName(QStringLiteral("exportDialog"));
    const auto formats = writableFormats(m_options.table->grid.dimensions(), m_options.isFitted);
    form().setFormats(formats, formats.front());
    connect(this, &QDialog::accepted, this, [this] { Q_EMIT chosen(m_options.table, choices()); });
    retranslate();
}

ConversionDialog::Words ExportDialog::words() const
{
    if (m_options.isFitted)
        return {tr("Save Table"),
            tr("Writes the table \"%1\" to a file of the drive or of another controller. Nothing "
               "on the drive changes.")
                .arg(m_options.tableName),
            tr("S&ave…"), tr("Choose where to save the file")};
    return {tr("Export for Another Controller"),
        tr("Writes the table \"%1\" to a file for another controller. Nothing on the drive "
           "changes.")
            .arg(m_options.tableName),
        tr("E&xport…"), tr("Choose where to save the file")};
}

ImportChoices ExportDialog::choices()
{
    ImportChoices choices = form().choices();
    choices.place = m_options.place;
    return choices;
}

void ExportDialog::compute()
{
    m_job.start([table = m_options.table, choices = choices(), layout = m_options.layout,
                    facts = m_options.facts](const std::stop_token&) {
        return exportTable(*table, choices, "table", layout, facts);
    });
}

} // namespace axiscomp::ui
