// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/data/data_file_loader.h"

#include "core/conversion/table_import.h"

#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace axiscomp::ui {

namespace {

void take(LoadedFile& file, TableImport import)
{
    file.format = import.format;
    file.data = std::move(import.data);
    file.report = std::move(import.report);
    file.usedPlace = import.usedPlace;
    file.problems = std::move(import.problems);
    file.suppressedProblems = import.suppressedProblems;
    file.fullGrid = std::move(import.fullGrid);
    file.refusal = std::move(import.refusal);
    const bool isSaid = std::ranges::find(file.problems, Severity::Error, &Diagnostic::severity)
        != file.problems.end();
    if (file.refusal && !isSaid)
        file.problems.push_back(
            {Severity::Error, DiagnosticCode::IoError, 0, 0, textOf(*file.refusal), {}, {}});
    if (!file.data)
        return;
    for (const CompensationTable& table : file.data->tables)
        file.tables.push_back(loaded({file.data, &table}));
}

} // namespace

FileStamp stampOf(const QString& path)
{
    const QFileInfo info(path);
    return {info.exists(), info.size(), info.lastModified()};
}

DataFileLoader::DataFileLoader(const TableLayout& layout, QObject* parent)
    : QObject(parent)
    , m_layout(layout)
    , m_worker(new QObject)
{
    m_worker->moveToThread(&m_thread);
    connect(&m_thread, &QThread::finished, m_worker, &QObject::deleteLater);
    connect(&m_relay, &ProgressRelay::progressed, this,
        [this](const QString&, double fraction) { Q_EMIT progressed(fraction); });
    m_thread.setObjectName(QStringLiteral("calibration loader"));
    m_thread.start();
}

DataFileLoader::~DataFileLoader()
{
    cancel();
    m_thread.quit();
    m_thread.wait();
}

void DataFileLoader::load(const QString& path, int dimensions, const ImportChoices& choices)
{
    cancel();
    m_stop = std::stop_source();
    const auto read = [this, path, dimensions, choices, number = m_number,
                          stop = m_stop.get_token()] {
        LoadedFile file;
        file.path = path;
        file.dimensions = dimensions;
        file.choices = choices;
        file.stamp = stampOf(path);
        if (stop.stop_requested())
            return;
        TableImport import = importTables({QFileInfo(path).filesystemAbsoluteFilePath(), dimensions,
            choices, &m_layout, stop, [this](double fraction) { m_relay.report({}, fraction); }});
        if (import.isCancelled)
            return;
        take(file, std::move(import));
        QMetaObject::invokeMethod(
            this, [this, number, file = std::move(file)] { finish(number, file); },
            Qt::QueuedConnection);
    };
    QMetaObject::invokeMethod(m_worker, read, Qt::QueuedConnection);
}

void DataFileLoader::cancel()
{
    ++m_number;
    m_stop.request_stop();
    m_relay.clear();
}

void DataFileLoader::finish(int number, const LoadedFile& file)
{
    if (number != m_number)
        return;
    m_relay.clear();
    Q_EMIT loaded(file);
}

} // namespace axiscomp::ui
