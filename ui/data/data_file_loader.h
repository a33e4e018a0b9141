// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/conversion/import_choices.h"
#include "core/csv/calibration_csv.h"
#include "core/table/compensation_table.h"
#include "core/table/table_layout.h"
#include "ui/async/progress_relay.h"

#include <QDateTime>
#include <QObject>
#include <QThread>

#include <memory>
#include <stop_token>
#include <vector>

namespace axiscomp::ui {

/// What a file was like when it was looked at: another stamp means that it has changed.
struct FileStamp {
    bool exists = false;
    qint64 size = 0;
    QDateTime modified;
    friend bool operator==(const FileStamp&, const FileStamp&) = default;
};
[[nodiscard]] FileStamp stampOf(const QString& path);

/// What reading a file gave.
struct LoadedFile {
    QString path;
    int dimensions = 1; ///< that were asked for
    ImportChoices choices; ///< likewise
    const TableFormat* format = nullptr; ///< as which it was read
    std::vector<Text> report; ///< of its conversion
    UsedPlace usedPlace; ///< what of the axis's place it was made for
    std::optional<Error> refusal; ///< other choices are needed; among the problems, too
    FileStamp stamp; ///< from before it was read
    std::shared_ptr<const CalibrationData> data; ///< only without an error
    std::vector<LoadedTable> tables; ///< those of data, kept alive with it
    std::vector<Diagnostic> problems; ///< warnings too
    std::size_t suppressedProblems = 0;
    std::optional<FullGrid> fullGrid; ///< what it is instead
};

/// Reads and parses files of compensation data on a thread of its own: calibration CSV by the
/// chosen number of dimensions, TAM tables (.TAMtbl) with their own, and files of other
/// controllers, which are converted. One file at a time: the next one cancels the one before.
class DataFileLoader : public QObject {
    Q_OBJECT

public:
    /// layout must outlive the loader.
    explicit DataFileLoader(const TableLayout& layout, QObject* parent = nullptr);
    ~DataFileLoader() override;

    void load(const QString& path, int dimensions, const ImportChoices& choices);
    /// Nothing is reported for what is cancelled.
    void cancel();

Q_SIGNALS:
    void progressed(double fraction); ///< at most 30 times a second
    void loaded(const axiscomp::ui::LoadedFile& file);

private:
    void finish(int number, const LoadedFile& file);

    const TableLayout& m_layout;
    ProgressRelay m_relay;
    QThread m_thread;
    QObject* m_worker = nullptr; ///< deletes itself on the thread, when that ends
    std::stop_source m_stop;
    int m_number = 0; ///< of the newest request: results of others are not wanted any more
};

} // namespace axiscomp::ui
