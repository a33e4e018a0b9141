// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration_loader.h"

#include "core/local_file.h"
#include "core/tam_table.h"

#include <QFileInfo>

#include <utility>

namespace axiscomp::ui {

namespace {

/// Far more than any drive holds.
constexpr std::uint64_t largestTableFile = 64ULL * 1024 * 1024;

std::filesystem::path filePath(const QString& path)
{
    return QFileInfo(path).filesystemAbsoluteFilePath();
}

bool isTamTable(const QString& path)
{
    return path.endsWith(QStringLiteral(".tamtbl"), Qt::CaseInsensitive);
}

void readTamTable(LoadedFile& file, const TableLayout& layout)
{
    const auto bytes = loadFile(filePath(file.path), largestTableFile);
    auto decoded = bytes ? decodeTamTable(*bytes, layout) : Result<TamTable>(fail(bytes.error()));
    if (!decoded) {
        file.problems.push_back(
            {Severity::Error, DiagnosticCode::IoError, 0, 0, sentence(decoded.error()), {}});
        return;
    }
    CalibrationData data;
    data.grid = decoded->table.grid;
    if (decoded->table.name.empty())
        decoded->table.name = QFileInfo(file.path).completeBaseName().toStdString();
    data.tables.push_back(std::move(decoded->table));
    file.data = std::make_shared<const CalibrationData>(std::move(data));
}

void survey(LoadedFile& file)
{
    if (!file.data)
        return;
    for (const CompensationTable& table : file.data->tables)
        file.tables.push_back(surveyed({file.data, &table}));
}

/// False when it was cancelled.
bool readCsv(LoadedFile& file, const std::stop_token& stop, ProgressRelay& relay)
{
    CsvOptions options;
    options.dimensions = file.dimensions;
    options.stop = stop;
    options.progress = [&relay](double fraction) { relay.report({}, fraction); };
    CsvReading reading = readCalibrationCsv(filePath(file.path), options);
    file.problems = std::move(reading.diagnostics);
    file.suppressedProblems = reading.suppressed;
    if (reading.data)
        file.data = std::make_shared<const CalibrationData>(*std::move(reading.data));
    return !reading.cancelled;
}

} // namespace

FileStamp stampOf(const QString& path)
{
    const QFileInfo info(path);
    return {info.exists(), info.size(), info.lastModified()};
}

CalibrationLoader::CalibrationLoader(const TableLayout& layout, QObject* parent)
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

CalibrationLoader::~CalibrationLoader()
{
    cancel();
    m_thread.quit();
    m_thread.wait();
}

void CalibrationLoader::load(const QString& path, int dimensions)
{
    cancel();
    m_stop = std::stop_source();
    const auto read = [this, path, dimensions, number = m_number, stop = m_stop.get_token()] {
        LoadedFile file;
        file.path = path;
        file.dimensions = dimensions;
        file.stamp = stampOf(path);
        if (stop.stop_requested())
            return;
        if (isTamTable(path))
            readTamTable(file, m_layout);
        else if (!readCsv(file, stop, m_relay))
            return;
        survey(file);
        QMetaObject::invokeMethod(
            this, [this, number, file = std::move(file)] { finish(number, file); },
            Qt::QueuedConnection);
    };
    QMetaObject::invokeMethod(m_worker, read, Qt::QueuedConnection);
}

void CalibrationLoader::cancel()
{
    ++m_number;
    m_stop.request_stop();
    m_relay.clear();
}

void CalibrationLoader::finish(int number, const LoadedFile& file)
{
    if (number != m_number)
        return;
    m_relay.clear();
    Q_EMIT loaded(file);
}

} // namespace axiscomp::ui
