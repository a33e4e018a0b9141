// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/data/data_file_model.h"

#include "core/formats/formats.h"
#include "core/neutral/drive_note.h"
#include "core/neutral/lookup_note.h"

#include <QDir>
#include <QFileInfo>

#include <utility>

namespace axiscomp::ui {

DataFileModel::DataFileModel(const TableLayout& layout, QObject* parent)
    : QObject(parent)
    , m_loader(layout)
{
    connect(&m_loader, &DataFileLoader::loaded, this, &DataFileModel::take);
    connect(&m_loader, &DataFileLoader::progressed, this, [this](double fraction) {
        m_file.progress = fraction;
        Q_EMIT changed();
    });
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, &DataFileModel::lookAtDisk);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, &DataFileModel::lookAtDisk);
}

LoadedTable DataFileModel::table(int index) const
{
    const bool isOne = index >= 0 && index < static_cast<int>(m_tables.size());
    return isOne ? m_tables[static_cast<std::size_t>(index)] : LoadedTable{};
}

void DataFileModel::open(const QString& path, int dimensions, const ImportChoices& choices)
{
    m_isUnasked = false;
    load(path, dimensions, choices);
}

void DataFileModel::load(const QString& path, int dimensions, const ImportChoices& choices)
{
    m_file.isReading = true;
    m_file.readingPath = QDir::cleanPath(QFileInfo(path).absoluteFilePath());
    m_file.progress = 0.0;
    m_dimensions = dimensions;
    m_readingWith = choices;
    m_loader.load(m_file.readingPath, dimensions, choices);
    Q_EMIT changed();
}

/// There is no file that could change, or be read again in another way.
void DataFileModel::show(const MadeTables& made)
{
    m_loader.cancel();
    const auto before = std::exchange(m_file, {}).data;
    m_file.path = made.name;
    m_file.data = made.data;
    m_file.format = &calibration_csv::format();
    m_file.isMade = true;
    takeNotes();
    m_file.lookupAt = made.lookupAt;
    m_file.isComputed = made.isComputed;
    m_tables = made.tables;
    m_readWith = {};
    m_stamp = {};
    watch();
    Q_EMIT dataReplaced(before, false);
    Q_EMIT changed();
}

void DataFileModel::setDimensions(int dimensions)
{
    if (dimensions == m_dimensions)
        return;
    m_dimensions = dimensions;
    if (!m_file.isReading && !m_file.refusedPath.isEmpty())
        return open(m_file.refusedPath, dimensions, choicesFor(m_file.refusedPath));
    const QString path = m_file.isReading ? m_file.readingPath : m_file.path;
    const bool knowsItsOwn = !m_file.isReading
        && (m_file.isMade || (m_file.format && m_file.format != &calibration_csv::format()));
    if (!path.isEmpty() && !knowsItsOwn)
        open(path, dimensions, m_file.isReading ? m_readingWith : m_readWith);
}

/// Compared with the place of the last try: one that failed is not tried again and again.
void DataFileModel::setPlace(const AxisPlace& place)
{
    if (m_file.isReading || m_file.isMade || !m_file.data
        || !m_file.usedPlace.differs(choicesFor(m_file.path).place, place))
        return;
    ImportChoices choices = m_readWith;
    choices.place = place;
    m_isUnasked = true;
    load(m_file.path, m_dimensions, choices);
}

ImportChoices DataFileModel::choicesFor(const QString& path) const
{
    if (m_file.isReading && path == m_file.readingPath)
        return m_readingWith;
    const auto known = m_choices.find(path);
    return known == m_choices.end() ? ImportChoices{} : known->second;
}

void DataFileModel::close()
{
    m_loader.cancel();
    const auto before = std::exchange(m_file, {}).data;
    m_tables.clear();
    watch();
    if (before)
        Q_EMIT dataReplaced(before, false);
    Q_EMIT changed();
}

void DataFileModel::cancelReading()
{
    if (!m_file.isReading)
        return;
    m_loader.cancel();
    m_file.isReading = false;
    m_file.readingPath.clear();
    Q_EMIT changed();
}

OpenedFile DataFileModel::opened() const
{
    return {m_file, m_tables, m_readWith, m_readingWith, m_stamp, m_dimensions};
}

void DataFileModel::putBack(const OpenedFile& opened)
{
    m_loader.cancel();
    m_file = opened.file;
    m_tables = opened.tables;
    m_readWith = opened.readWith;
    if (!m_file.path.isEmpty() && !m_file.isMade)
        m_choices[m_file.path] = m_readWith;
    m_stamp = opened.stamp;
    m_dimensions = opened.dimensions;
    watch();
    if (m_file.isReading)
        return open(m_file.readingPath, m_dimensions, opened.readingWith);
    lookAtDisk();
    Q_EMIT changed();
}

void DataFileModel::take(const LoadedFile& loaded)
{
    const bool isSameFile = loaded.path == m_file.path && !m_file.isMade;
    const bool isUnasked = m_isUnasked;
    m_file.isReading = false;
    m_file.readingPath.clear();
    m_file.problemsPath = loaded.problems.empty() ? QString() : loaded.path;
    m_file.problems = loaded.problems;
    m_file.suppressedProblems = loaded.suppressedProblems;
    m_file.fullGrid = loaded.fullGrid;
    m_choices[loaded.path] = loaded.choices;
    const auto before = m_file.data;
    if (loaded.data) {
        m_file.data = loaded.data;
        m_file.report = loaded.report;
        m_file.usedPlace = loaded.usedPlace;
        m_file.format = loaded.format;
        m_tables = loaded.tables;
    }
    if (loaded.data || !before) {
        m_file.path = loaded.path;
        m_readWith = loaded.choices;
        m_file.isMade = false;
        takeNotes();
        m_stamp = loaded.stamp;
    } else if (isSameFile) {
        m_stamp = loaded.stamp; // the offer to read it again has been taken
    }
    const bool isCalibration = loaded.format == &calibration_csv::format();
    m_file.refusedPath =
        !loaded.data && isCalibration && loaded.path != m_file.path ? loaded.path : QString();
    m_file.hasChangedOnDisk = false;
    watch();
    lookAtDisk();
    if (loaded.data)
        Q_EMIT dataReplaced(before, isSameFile);
    else
        Q_EMIT failed(loaded);
    Q_EMIT changed();
    if (loaded.refusal && !isUnasked)
        Q_EMIT choiceNeeded(loaded.path);
}

/// What they say of the tables.
void DataFileModel::takeNotes()
{
    m_file.isComputed = false;
    m_file.lookupAt.reset();
    m_file.measuredDrive.reset();
    m_file.noteProblem.reset();
    if (!m_file.data)
        return;
    const auto lookupAt = lookupInNotes(m_file.data->notes);
    const auto measured = measuredDriveInNotes(m_file.data->notes);
    if (!lookupAt)
        m_file.noteProblem = lookupAt.error();
    else if (!measured)
        m_file.noteProblem = measured.error();
    m_file.lookupAt = lookupAt.value_or(std::nullopt);
    m_file.measuredDrive = measured.value_or(std::nullopt);
}

/// The file, and its folder: many programs save by putting a new file in the old one's place.
void DataFileModel::watch()
{
    const QStringList watched = m_watcher.files() + m_watcher.directories();
    if (!watched.isEmpty())
        m_watcher.removePaths(watched);
    if (m_file.path.isEmpty() || m_file.isMade)
        return;
    const QFileInfo info(m_file.path);
    QStringList wanted;
    if (info.exists())
        wanted.append(m_file.path);
    if (QFileInfo::exists(info.absolutePath()))
        wanted.append(info.absolutePath());
    if (!wanted.isEmpty())
        m_watcher.addPaths(wanted);
}

void DataFileModel::lookAtDisk()
{
    if (m_file.path.isEmpty() || m_file.isMade)
        return;
    const FileStamp now = stampOf(m_file.path);
    // A replaced file is another one to the watcher.
    if (now.exists && !m_watcher.files().contains(m_file.path))
        m_watcher.addPath(m_file.path);
    // One that is away is being saved, or cannot be read again anyway.
    const bool hasChanged = now.exists && !(now == m_stamp);
    if (std::exchange(m_file.hasChangedOnDisk, hasChanged) != hasChanged)
        Q_EMIT changed();
}

} // namespace axiscomp::ui
