// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tabs/record_actions.h"

#include "core/compensator/drive_record.h"
#include "core/compensator/file_kind.h"
#include "core/io/local_file.h"
#include "core/metrology/report/record_report.h"
#include "core/metrology/report/report_html.h"
#include "ui/controller/wizard_controller.h"
#include "ui/page/message_stack.h"
#include "ui/page/page_menu.h"
#include "ui/page/unsaved_changes_guard.h"
#include "ui/report/report_pdf.h"
#include "ui/style/symbols.h"
#include "ui/tabs/prove_page.h"
#include "ui/tabs/record_bar.h"
#include "ui/text/document_wording.h"
#include "ui/text/message_text.h"

#include <QDir>
#include <QFileInfo>
#include <QLocale>

#include <algorithm>

namespace axiscomp::ui {

namespace {

const QLatin1StringView ending("axcal");

QString questionId()
{
    return QStringLiteral("recordQuestion");
}

QString offerId()
{
    return QStringLiteral("recoveryOffer");
}

QString changedId()
{
    return QStringLiteral("changedMeasurement");
}

QString reportId()
{
    return QStringLiteral("reportMessage");
}

/// As `axiscomp report` makes it.
Result<void> reportOf(
    const RecordParts& parts, const std::filesystem::path& file, const QLocale& locale)
{
    const auto format = reportFormatOf(file);
    if (!format)
        return fail(ErrorCode::FileNotWritable,
            {{"file", file.filename().string()},
                {"reason",
                    AXISCOMP_TEXT("Error",
                        "a report is PDF or HTML; choose a name that ends in .pdf or .html")}});
    AXISCOMP_TRY(const auto record, assembled(parts));
    AXISCOMP_TRY(const auto content, reportContent(record, AXISCOMP_VERSION));
    const ReportDocument document = inLanguageOf(reportDocument(content), locale);
    if (*format == ReportFormat::Html)
        return saveFile(file, asBytes(reportHtml(document)));
    AXISCOMP_TRY(const auto pdf, reportPdf(document));
    return saveFile(file, pdf);
}

} // namespace

RecordActions::RecordActions(RecordModel& record, WizardController& controller,
    const DriveProfile& profile, const std::filesystem::path& storeRoot, QObject* parent)
    : QObject(parent)
    , m_record(record)
    , m_after(RecordModel::HistoryOf{record})
    , m_file(record, m_after)
    , m_recovery(m_file, storeRoot / "records")
    , m_controller(controller)
    , m_profile(profile)
    , m_bar(new RecordBar(m_file))
    , m_prove(new ProvePage(record, m_after))
{
    m_file.setStore(storeRoot);
    connect(m_bar, &RecordBar::openRequested, this, &RecordActions::askAndOpen);
    connect(m_bar, &RecordBar::saveRequested, this, &RecordActions::save);
    connect(m_bar, &RecordBar::reportRequested, this, &RecordActions::report);
    const auto tell = [this](const Error& error) { Q_EMIT failed(errorText(error)); };
    connect(&m_file, &RecordFile::openFailed, this, [this, tell](const Error& error) {
        tell(error);
        goOnAfterSave(); // the record that is there was to be saved
    });
    connect(&m_file, &RecordFile::saveFailed, this, [this, tell](const Error& error) {
        m_afterSave = nullptr;
        tell(error);
    });
    connect(&m_file, &RecordFile::obstructed, this, &RecordActions::tellObstacle);
    connect(&m_file, &RecordFile::saved, this, [this] {
        forgetQuestion();
        goOnAfterSave();
    });
    connect(&m_file, &RecordFile::changed, m_prove,
        [this] { m_prove->setUnsaved(m_file.isModified()); });
    connect(&m_recovery, &RecordRecovery::found, this, &RecordActions::offerUnsaved);
    connect(&controller, &WizardController::tableWritten, this, &RecordActions::noteWrite);
    connect(&controller, &WizardController::tableActivated, this, &RecordActions::noteProof);
}

RecordActions::~RecordActions() = default;

void RecordActions::attach(const Page& page)
{
    m_page = std::make_unique<Page>(page);
    buildMenu();
    connect(&m_file, &RecordFile::changed, this, &RecordActions::showMenu);
    page.guard.watchRecord({
        [this] { return isUnsaved() ? unsavedText() : QString(); },
        [this](std::function<void()> done) { saveThen(std::move(done)); },
        [this] { m_recovery.end(); },
    });
    connect(&m_file, &RecordFile::changed, &page.guard, &UnsavedChangesGuard::followRecord);
    connect(&m_file, &RecordFile::opened, this, [this] {
        m_afterSave = nullptr;
        forgetQuestion();
        m_page->messages.remove(reportId());
        m_page->messages.remove(changedId());
    });
    for (const RecordModel* model : {&std::as_const(m_record), &std::as_const(m_after)})
        connect(model, &RecordModel::filesChanged, this, &RecordActions::tellChanged);
    retranslate();
}

void RecordActions::buildMenu()
{
    m_menu = new QMenu(&m_page->menu);
    m_menu->setObjectName(QStringLiteral("recordMenu"));
    m_menu->setToolTipsVisible(true);
    const auto add = [this](const char* name, void (RecordActions::*action)()) {
        QAction* entry = m_menu->addAction(QString());
        entry->setObjectName(QLatin1StringView(name));
        connect(entry, &QAction::triggered, this, action);
        return entry;
    };
    m_new = add("newRecordAction", &RecordActions::begin);
    m_open = add("openRecordAction", &RecordActions::askAndOpen);
    m_save = add("saveRecordAction", &RecordActions::save);
    m_saveAs = add("saveRecordAsAction", &RecordActions::saveAs);
    m_report = add("reportRecordAction", &RecordActions::report);
    m_page->menu.insertMenu(m_page->menu.actions().value(0), m_menu);
}

void RecordActions::showMenu()
{
    const bool isFree = !m_file.isBusy();
    m_new->setEnabled(isFree && !m_file.isEmpty());
    m_open->setEnabled(isFree);
    m_save->setEnabled(isFree && m_file.isModified() && !m_file.isEmpty());
    m_saveAs->setEnabled(isFree && !m_file.isEmpty());
    m_report->setEnabled(isFree && !m_file.isEmpty());
}

void RecordActions::retranslate()
{
    m_bar->retranslate();
    m_prove->retranslate();
    if (!m_menu)
        return;
    m_menu->setTitle(tr("Re&cord"));
    // The keys are the page's: those of a closed menu do nothing.
    m_new->setText(tr("&New Record"));
    m_open->setText(tr("&Open Record…") + QStringLiteral("\tCtrl+Alt+O"));
    m_save->setText(tr("&Save Record") + QStringLiteral("\tCtrl+S"));
    m_saveAs->setText(tr("Save Record &As…") + QStringLiteral("\tCtrl+Shift+S"));
    m_report->setText(tr("&Report…") + QStringLiteral("\tCtrl+P"));
    showMenu();
    const auto ask = m_question;
    if (ask && m_page->messages.contains(questionId()))
        ask();
    if (m_page->messages.contains(offerId()))
        offerUnsaved();
}

bool RecordActions::isRecord(const QString& path)
{
    return kindOfName(path.toStdString()) == FileKind::Record;
}

void RecordActions::ask(
    FileQuestion::Purpose purpose, const std::function<void(const QString&)>& answer)
{
    FileQuestion question;
    question.purpose = purpose;
    const QString records = tr("Records (*.axcal)");
    const QFileInfo file(m_file.path());
    const QString folder = m_file.path().isEmpty() ? m_page->folder() : file.absolutePath();
    QString name = m_file.path().isEmpty() ? QString() : file.completeBaseName();
    if (name.isEmpty() && !m_record.record().files.empty())
        name = QFileInfo(m_record.record().files.front().path).completeBaseName();
    if (purpose == FileQuestion::Purpose::OpenRecord) {
        question.title = tr("Open Record");
        question.filter = records;
        question.start = folder;
    } else if (purpose == FileQuestion::Purpose::SaveRecord) {
        question.title = tr("Save Record");
        question.filter = records;
        question.start = QDir(folder).filePath(name + QStringLiteral(".axcal"));
    } else {
        question.title = tr("Report");
        question.filter = tr("PDF (*.pdf)") + QStringLiteral(";;") + tr("HTML (*.html *.htm)");
        question.start = QDir(folder).filePath(name + QStringLiteral(".pdf"));
    }
    m_page->picker()(m_page->window, question, [this, purpose, answer](const QString& path) {
        if (!path.isEmpty())
            answer(path);
        else if (purpose == FileQuestion::Purpose::SaveRecord)
            m_afterSave = nullptr; // it is not saved: nothing may follow by itself later
    });
}

void RecordActions::begin()
{
    loseRecord(Reason::Begin, [this] { m_file.begin(); });
}

void RecordActions::askAndOpen()
{
    if (!m_file.isBusy())
        ask(FileQuestion::Purpose::OpenRecord, [this](const QString& path) { open(path); });
}

void RecordActions::open(const QString& path)
{
    if (m_file.isBusy())
        return;
    loseRecord(Reason::Open, [this, path] { m_file.open(path); });
}

void RecordActions::loseRecord(Reason reason, std::function<void()> action)
{
    if (!isUnsaved()) {
        action();
        return;
    }
    m_question = [this, reason, action] { loseRecord(reason, action); };
    const bool begins = reason == Reason::Begin;
    Message question;
    question.id = questionId();
    question.tone = Tone::Warning;
    question.text = unsavedText();
    question.buttons = {
        {QStringLiteral("saveFirstButton"),
            begins ? tr("Save, &Then Begin") : tr("Save, &Then Open"),
            [this, action] { saveThen(action); }},
        {QStringLiteral("loseRecordButton"),
            begins ? tr("Begin Without Savin&g") : tr("Open Without Savin&g"), action},
        {QStringLiteral("stayButton"), tr("Sta&y"), [] {}},
    };
    question.isClosable = false;
    m_page->messages.show(question);
}

/// What it was about is saved, or another record is there: an answer would be for the wrong one.
void RecordActions::forgetQuestion()
{
    if (m_page)
        m_page->messages.remove(questionId());
}

QString RecordActions::unsavedText() const
{
    return m_file.path().isEmpty() ? tr("The record has never been saved.")
                                   : tr("%1 has changes that are not saved.").arg(m_file.name());
}

bool RecordActions::isUnsaved() const
{
    return m_notes > 0 || m_file.isSaving() || (m_file.isModified() && !m_file.isEmpty());
}

void RecordActions::saveThen(std::function<void()> action)
{
    m_afterSave = std::move(action);
    goOnAfterSave();
}

/// Only when the file has everything: also what was changed while it was being saved, and what is
/// still being noted of a write.
void RecordActions::goOnAfterSave()
{
    if (!m_afterSave || m_notes > 0)
        return;
    if (isUnsaved()) {
        saveNow();
        return;
    }
    std::exchange(m_afterSave, nullptr)();
}

void RecordActions::save()
{
    m_afterSave = nullptr;
    saveNow();
}

void RecordActions::saveAs()
{
    m_afterSave = nullptr;
    askWhereToSave();
}

void RecordActions::saveNow()
{
    if (m_file.isBusy() || m_file.isEmpty() || !m_file.isModified())
        return;
    if (m_file.path().isEmpty())
        askWhereToSave();
    else
        m_file.save(m_file.path());
}

void RecordActions::askWhereToSave()
{
    if (m_file.isBusy() || m_file.isEmpty())
        return;
    ask(FileQuestion::Purpose::SaveRecord,
        [this](const QString& path) { m_file.save(isRecord(path) ? path : path + u'.' + ending); });
}

void RecordActions::tellObstacle(const QString& path, RecordFile::Obstacle obstacle)
{
    m_question = [this, path, obstacle] { tellObstacle(path, obstacle); };
    const QString name = QFileInfo(path).fileName();
    Message question;
    question.id = questionId();
    question.tone = Tone::Warning;
    switch (obstacle) {
    case RecordFile::Obstacle::Exists:
        question.text = tr("%1 is there already, and is another file.").arg(name);
        break;
    case RecordFile::Obstacle::Changed:
        question.text =
            tr("%1 has been changed by another program since it was read here.").arg(name);
        break;
    case RecordFile::Obstacle::OtherTable:
        question.text = tr("%1 says what was written and measured of its table, and this record "
                           "does not. Saving it under another name keeps both.")
                            .arg(name);
        break;
    }
    question.buttons = {
        {QStringLiteral("overwriteRecordButton"), tr("Overwri&te"),
            [this, path] { m_file.save(path, true); }},
        {QStringLiteral("otherNameButton"), tr("&Keep Both…"), [this] { askWhereToSave(); }},
        {QStringLiteral("stayButton"), tr("Sta&y"), [this] { m_afterSave = nullptr; }},
    };
    question.isClosable = false;
    m_page->messages.show(question);
}

void RecordActions::tellChanged(const QString& names)
{
    Message message;
    message.id = changedId();
    message.tone = Tone::Warning;
    message.text = tr("%1 has changed on disk. What was left out is used again; corrections, and "
                      "which table was active, are to be said anew. Ctrl+Z takes that back.")
                       .arg(names);
    m_page->messages.show(message);
}

void RecordActions::offerUnsaved()
{
    const auto& found = m_recovery.waiting();
    if (!found || !m_page)
        return;
    const QString time = QLocale().toString(found->time, QLocale::ShortFormat);
    const bool isRecord = found->path.isEmpty(); // not changes of one
    Message offer;
    offer.id = offerId();
    offer.tone = Tone::Warning;
    offer.text = isRecord
        ? tr("The program did not end well. A record that was never saved was kept at %1.")
              .arg(time)
        : tr("The program did not end well. Unsaved changes of %1 were kept at %2.")
              .arg(QFileInfo(found->path).fileName(), time);
    offer.buttons = {
        {QStringLiteral("takeUnsavedButton"), isRecord ? tr("&Take It Up") : tr("&Take Them Up"),
            [this] { loseRecord(Reason::Open, [this] { m_recovery.take(); }); }},
        {QStringLiteral("forgetUnsavedButton"), isRecord ? tr("For&get It") : tr("For&get Them"),
            [this] { m_recovery.discard(); }},
    };
    m_page->messages.show(offer);
}

void RecordActions::report()
{
    if (m_file.isBusy() || m_file.isEmpty())
        return;
    ask(FileQuestion::Purpose::SaveReport, [this](const QString& path) { writeReport(path); });
}

void RecordActions::writeReport(const QString& path)
{
    m_file.whenRead([this, path](const RecordParts& parts) {
        const auto written = inBackground<Result<void>>(
            [parts, locale = QLocale(), file = QFileInfo(path).filesystemAbsoluteFilePath()] {
                return reportOf(parts, file, locale);
            });
        whenDone(written, this, [this, path](const Result<void>& result) {
            if (!result) {
                Q_EMIT failed(errorText(result.error()));
                return;
            }
            Message message;
            message.id = reportId();
            message.tone = Tone::Success;
            message.text = tr("The report was written to %1.").arg(QFileInfo(path).fileName());
            m_page->messages.show(message);
        });
    });
}

/// Null where the chosen table is none of the record's.
std::shared_ptr<const CalibrationRecord> RecordActions::recordOfSelected() const
{
    const auto& calibration = m_record.record().calibration;
    const auto table = m_controller.selectedTable();
    const bool isOfRecord = calibration && table
        && hasTable(*calibration, {tableCrc(*table), table->grid}, m_profile.layout);
    return isOfRecord ? calibration : nullptr;
}

std::vector<Text> RecordActions::doubtsOfWrite() const
{
    const auto calibration = recordOfSelected();
    const auto& status = m_controller.status();
    const auto fits =
        calibration && status ? checkRecordAxis(*calibration, *status) : Result<void>();
    if (fits)
        return {};
    return {AXISCOMP_TEXT("Error", "The open record will not note this write: {reason}.")
                .with("reason", textOf(fits.error()))};
}

bool RecordActions::mayWrite()
{
    const auto calibration = recordOfSelected();
    const auto& status = m_controller.status();
    if (!calibration || !status)
        return true;
    const auto fits = checkRecordSources(
        *calibration, m_profile, status->axis.index, sourcePaths(m_controller.setup().edited()));
    if (!fits)
        Q_EMIT failed(errorText(fits.error()));
    return fits.has_value();
}

void RecordActions::noteWrite(const AxisStatus& now)
{
    if (!now.table)
        return;
    const auto has = [found = identityOf(*now.table), &layout = m_profile.layout](
                         const CalibrationRecord& record) {
        return hasTable(record, found, layout);
    };
    noteInRecords({has,
        [now, profile = m_profile.name, time = std::chrono::system_clock::now()](
            CalibrationRecord& record) { return recordWrite(record, now, profile, time); }});
}

void RecordActions::noteProof()
{
    const auto& status = m_controller.status();
    const auto& proof = m_controller.proof();
    if (!status || !status->table || !proof)
        return;
    const TableIdentity found = identityOf(*status->table);
    const auto isWritten = [found](const CalibrationRecord& record) {
        return record.write && isSameTable(found, record.write->table());
    };
    noteInRecords({isWritten,
        [now = *status, proof = *proof, profile = m_profile](
            CalibrationRecord& record) { return recordProof(record, now, proof, profile); }});
}

/// In every step that has the table of this record: undoing something else takes nothing of it
/// back.
void RecordActions::noteInRecords(const Note& note)
{
    using Noted = std::shared_ptr<const CalibrationRecord>;
    using Notes = std::map<Noted, Result<Noted>>;
    std::vector<Noted> concerned = m_record.calibrations();
    std::erase_if(concerned, [&](const Noted& record) {
        return !note.isDue(*record) || std::ranges::find(note.done, record) != note.done.end();
    });
    if (concerned.empty())
        return;
    ++m_notes;
    const auto noted =
        inBackground<std::shared_ptr<const Notes>>([concerned, change = note.change] {
            auto notes = std::make_shared<Notes>();
            for (const Noted& record : concerned) {
                auto copy = std::make_shared<CalibrationRecord>(*record);
                const auto changed = change(*copy);
                notes->emplace(
                    record, changed ? Result<Noted>(std::move(copy)) : fail(changed.error()));
            }
            return std::shared_ptr<const Notes>(std::move(notes));
        });
    whenDone(noted, this, [this, note](const std::shared_ptr<const Notes>& notes) {
        --m_notes;
        showNote(note, *notes);
    });
}

void RecordActions::showNote(Note note,
    const std::map<std::shared_ptr<const CalibrationRecord>,
        Result<std::shared_ptr<const CalibrationRecord>>>& noted)
{
    m_record.note([&](const std::shared_ptr<const CalibrationRecord>& record) {
        const auto found = noted.find(record);
        return found != noted.end() && found->second ? *found->second : record;
    });
    std::optional<Error> refusal;
    for (const auto& [record, result] : noted) {
        note.done.push_back(result ? *result : record);
        if (!result)
            refusal = result.error();
    }
    if (refusal)
        Q_EMIT failed(tr("The drive has the table; only the record does not say so: %1")
                          .arg(errorText(*refusal)));
    noteInRecords(note); // of steps that were made meanwhile
    goOnAfterSave();
}

} // namespace axiscomp::ui
