// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/import_dialog.h"

#include "ui/text/message_text.h"

#include <QFileInfo>
#include <QSignalBlocker>

#include <algorithm>

namespace axiscomp::ui {

namespace {

/// Those that can be read, and among them first what the file may be.
std::vector<const TableFormat*> offered(const std::vector<const TableFormat*>& candidates)
{
    std::vector<const TableFormat*> formats;
    const auto add = [&formats](const TableFormat* format) {
        if (format->read && std::ranges::find(formats, format) == formats.end())
            formats.push_back(format);
    };
    std::ranges::for_each(candidates, add);
    std::ranges::for_each(tableFormats(), add);
    return formats;
}

/// What was converted, and what was done to the numbers before that: points that were filled.
std::vector<Text> reportOf(const TableImport& import)
{
    std::vector<Text> lines = import.report;
    for (const Diagnostic& warning : import.problems) {
        Text line = textOf(warning);
        if (warning.line > 0)
            line = AXISCOMP_TEXT("Problem", "line {line}: {problem}")
                       .with("line", warning.line)
                       .with("problem", line);
        lines.push_back(std::move(line));
    }
    if (lines.empty())
        lines = {AXISCOMP_TEXT("Error", "the numbers of the file are taken as they are")};
    return lines;
}

} // namespace

ImportDialog::ImportDialog(Options options, QWidget* parent)
    : ConversionDialog(ConversionForm::Purpose::Import, parent)
    , m_options(std::move(options))
    , m_job([this](const TableImport& import) { take(import); })
{
    setObjectName(QStringLiteral("importDialog"));
    form().setFormats(offered({}), m_options.choices.format);
    form().setChoices(m_options.choices);
    connect(this, &QDialog::accepted, this,
        [this] { Q_EMIT chosen(m_options.path, form().choices()); });
    retranslate();
    if (!m_options.choices.format)
        startComputing(); // which format it is
}

ConversionDialog::Words ImportDialog::words() const
{
    return {tr("Import Compensation Data"),
        tr("Choose how to read %1. The result is the table that the drive adds to the encoder "
           "position, on an even grid.")
            .arg(QFileInfo(m_options.path).fileName()),
        tr("I&mport"), tr("Use the file with these choices; nothing is written to the drive yet")};
}

void ImportDialog::compute()
{
    ImportChoices choices = form().choices();
    choices.place = m_options.choices.place;
    const auto import = [path = QFileInfo(m_options.path).filesystemAbsoluteFilePath(),
                            dimensions = m_options.dimensions, choices = std::move(choices),
                            layout = m_options.layout](const std::stop_token& stop) {
        return importTables({path, dimensions, choices, &layout, stop, {}});
    };
    m_job.start(import);
}

/// The format that was found is chosen, once.
void ImportDialog::showFormat(const TableImport& import)
{
    if (std::exchange(m_isFormatShown, true) || m_options.choices.format)
        return;
    const bool isOpen = import.refusal && import.refusal->code == ErrorCode::FormatAmbiguous;
    ImportChoices choices = form().choices();
    choices.format = isOpen ? nullptr : import.format;
    const QSignalBlocker blocker(form());
    form().setFormats(offered(import.candidates), choices.format);
    form().setChoices(choices);
}

void ImportDialog::take(const TableImport& import)
{
    if (import.isCancelled)
        return;
    showFormat(import);
    form().setQuestions(import.hasDirections, import.hasWrap);
    if (import.refusal) {
        showReason(errorText(*import.refusal));
        return;
    }
    const auto error = std::ranges::find(import.problems, Severity::Error, &Diagnostic::severity);
    if (error != import.problems.end()) {
        const QString place = error->line == 0 ? QString() : tr("Line %1: ").arg(error->line);
        showReason(place + problemText(*error));
        return;
    }
    showReport(reportOf(import));
}

} // namespace axiscomp::ui
