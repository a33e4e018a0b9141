// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/record_file.h"

#include "core/base/sha256.h"
#include "core/io/local_file.h"
#include "core/metrology/record/kept_figures.h"
#include "ui/record/record_model.h"

#include <QFileInfo>

#include <algorithm>

namespace axiscomp::ui {

namespace {

std::shared_ptr<const CalibrationRecord> begun()
{
    auto record = std::make_shared<CalibrationRecord>();
    record->program = "axiscomp " AXISCOMP_VERSION;
    record->time = std::chrono::system_clock::now();
    return record;
}

bool isSameFile(const QString& a, const QString& b)
{
    if (a.isEmpty() || b.isEmpty())
        return false;
    return a == b || (QFileInfo::exists(a) && QFileInfo::exists(b) && QFileInfo(a) == QFileInfo(b));
}

/// All files of a record that is opened are in it.
FileDigests recordedDigests(const OpenedRecord& opened)
{
    FileDigests digests;
    for (const MeasurementFile& file : opened.record.files)
        digests[0].push_back(file.recorded->sha256);
    for (const MeasurementFile& file : opened.after.files)
        digests[1].push_back(file.recorded->sha256);
    return digests;
}

/// Whether a file has a history of a table that would be lost.
bool losesHistory(const CalibrationRecord& there, const CalibrationRecord& made)
{
    if (there.tables.empty() || (!there.write && there.after.empty()))
        return false;
    if ((there.write && !made.write) || made.after.size() < there.after.size())
        return true;
    return std::ranges::none_of(there.tables, [&](const RecordedTable& table) {
        return std::ranges::any_of(made.tables,
            [&table](const RecordedTable& other) { return isSameTable(table, other); });
    });
}

/// Whether the last measurement with the table is not that of the file.
bool hasNewAfter(const CalibrationRecord* there, const CalibrationRecord& made)
{
    const RecordedAfter* const known = there ? lastAfter(*there) : nullptr;
    const RecordedAfter* const last = lastAfter(made);
    return last && !(known && known->measurement == last->measurement);
}

} // namespace

RecordFile::RecordFile(RecordModel& record, RecordModel& after, QObject* parent)
    : QObject(parent)
    , m_record(record)
    , m_after(after)
    , m_content{begun(), {}}
    , m_known(current())
{
    for (RecordModel* model : {&record, &after}) {
        connect(model, &RecordModel::changed, this, &RecordFile::changed);
        connect(model, &RecordModel::stateChanged, this, &RecordFile::follow);
    }
}

OpenedRecord RecordFile::current() const
{
    return {m_record.record(), m_after.record()};
}

RecordParts RecordFile::parts() const
{
    RecordParts parts{m_record.state(), m_after.state(), m_content.record, isKnown()};
    parts.record.record = m_record.record();
    parts.after.record = m_after.record();
    return parts;
}

QString RecordFile::name() const
{
    return m_path.isEmpty() ? tr("not saved yet") : QFileInfo(m_path).fileName();
}

bool RecordFile::isKnown() const
{
    if (!(current() == m_known))
        return false;
    for (const RecordModel* model : {&m_record, &m_after})
        if (model->state().record.files != model->record().files)
            return true; // they are being read for the first time
    return !haveChanged(fileDigests(m_record.state(), m_after.state()), m_knownFiles);
}

bool RecordFile::isModified() const
{
    return m_isRecovered || !isKnown();
}

bool RecordFile::isEmpty() const
{
    return m_path.isEmpty() && current() == OpenedRecord{};
}

void RecordFile::setBusy(bool isBusy)
{
    m_jobs += isBusy ? 1 : -1;
    Q_EMIT changed();
}

void RecordFile::begin()
{
    show({}, {begun(), {}});
}

void RecordFile::take(
    std::shared_ptr<const CalibrationRecord> record, const QString& path, const std::string& sha256)
{
    show(path, {std::move(record), sha256});
    m_isRecovered = true;
    Q_EMIT changed();
}

void RecordFile::show(const QString& path, const Content& content)
{
    ++m_shown;
    ++m_wanted;
    m_path = path;
    m_content = content;
    m_isRecovered = false;
    m_waiting.clear(); // it was about the record before
    const OpenedRecord next = ui::opened(content.record);
    m_known = next;
    m_knownFiles = recordedDigests(next);
    m_record.open(next.record);
    m_after.open(next.after);
    Q_EMIT changed();
    Q_EMIT opened();
}

Result<RecordFile::Content> RecordFile::read(const std::filesystem::path& file)
{
    AXISCOMP_TRY(const auto bytes, loadFile(file, maximumRecordSize));
    AXISCOMP_TRY(auto record, recordFromText(asText(bytes), file.filename().string()));
    return Content{std::make_shared<const CalibrationRecord>(std::move(record)), sha256Of(bytes)};
}

void RecordFile::open(const QString& path)
{
    const QString absolute = QFileInfo(path).absoluteFilePath();
    setBusy(true);
    const auto content = inBackground<Result<Content>>(
        [file = QFileInfo(absolute).filesystemAbsoluteFilePath()] { return read(file); });
    whenDone(content, this, [this, absolute, wanted = ++m_wanted](const Result<Content>& result) {
        setBusy(false);
        if (wanted != m_wanted)
            return; // another record was begun or opened meanwhile
        if (result)
            show(absolute, *result);
        else
            Q_EMIT openFailed(result.error());
    });
}

void RecordFile::whenRead(std::function<void(const RecordParts&)> use)
{
    m_waiting.push_back(std::move(use));
    follow();
}

void RecordFile::follow()
{
    Q_EMIT changed(); // a file may be another one than the one that was saved
    if (m_waiting.empty() || m_record.isEvaluating() || m_after.isEvaluating())
        return;
    const auto waiting = std::exchange(m_waiting, {});
    for (const auto& use : waiting)
        use(parts());
}

void RecordFile::save(const QString& path, bool overwrites)
{
    whenRead([this, path, overwrites](const RecordParts&) { saveNow(path, overwrites); });
}

Result<RecordFile::Saving> RecordFile::write(const RecordParts& parts, const Target& target)
{
    AXISCOMP_TRY(auto made, assembled(parts));
    std::error_code ignored;
    const bool isThere = std::filesystem::exists(target.file, ignored);
    if (isThere && !target.overwrites) {
        if (!target.isOwn)
            return Saving{Obstacle::Exists, {}};
        AXISCOMP_TRY(const auto bytes, loadFile(target.file, maximumRecordSize));
        if (sha256Of(bytes) != target.sha256)
            return Saving{Obstacle::Changed, {}};
        if (!target.isModified)
            return Saving{{}, {parts.base, target.sha256}}; // byte for byte
        if (losesHistory(*parts.base, made))
            return Saving{Obstacle::OtherTable, {}};
    }
    const std::string text = recordText(made);
    AXISCOMP_CHECK(saveFile(target.file, asBytes(text)));
    if (!target.store.empty()) {
        DriveStore store(target.store);
        // What the drive's overview says of the table; the record has it in any case.
        static_cast<void>(keepFigures(store, made, std::chrono::system_clock::now(),
            hasNewAfter(parts.base.get(), made) ? Measuring::New : Measuring::Known));
    }
    return Saving{
        {}, {std::make_shared<const CalibrationRecord>(std::move(made)), sha256Of(asBytes(text))}};
}

void RecordFile::saveNow(const QString& path, bool overwrites)
{
    const QFileInfo info(path);
    const QString absolute = info.absoluteFilePath();
    ++m_saves;
    setBusy(true);
    const Target target{info.filesystemAbsoluteFilePath(), isSameFile(m_path, absolute),
        isModified(), m_content.sha256, overwrites, m_store};
    const OpenedRecord known = current();
    const FileDigests knownFiles = fileDigests(m_record.state(), m_after.state());
    const auto saving =
        inBackground<Result<Saving>>([parts = parts(), target] { return write(parts, target); });
    whenDone(saving, this,
        [this, absolute, known, knownFiles, shown = m_shown](const Result<Saving>& result) {
            --m_saves;
            setBusy(false);
            if (shown != m_shown)
                return; // the record was given up meanwhile, and another one has no file by this
            if (!result) {
                Q_EMIT saveFailed(result.error());
                return;
            }
            if (result->obstacle) {
                Q_EMIT obstructed(absolute, *result->obstacle);
                return;
            }
            m_path = absolute;
            m_content = result->content;
            m_known = known;
            m_knownFiles = knownFiles;
            m_isRecovered = false;
            Q_EMIT changed();
            Q_EMIT saved();
        });
}

} // namespace axiscomp::ui
