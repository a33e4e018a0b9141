// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/data/data_file_loader.h"
#include "ui/data/data_file_state.h"

#include <QFileSystemWatcher>
#include <QObject>

#include <map>

namespace axiscomp::ui {

/// An open file with all that was read of it.
struct OpenedFile {
    DataFile file;
    std::vector<LoadedTable> tables;
    ImportChoices readWith;
    ImportChoices readingWith; ///< of what was being read
    FileStamp stamp;
    int dimensions = 1;
};

/// The open file of compensation data: opens, reads again and watches it. A file with errors leaves
/// the data of the one before.
class DataFileModel : public QObject {
    Q_OBJECT

public:
    /// layout must outlive the model.
    explicit DataFileModel(const TableLayout& layout, QObject* parent = nullptr);

    [[nodiscard]] const DataFile& file() const { return m_file; }
    /// The table of that index, kept as long as it is used; null when there is none.
    [[nodiscard]] LoadedTable table(int index) const;

    void open(const QString& path, int dimensions, const ImportChoices& choices = {});
    /// In place of the open file.
    void show(const MadeTables& made);
    /// The CSV file that was refused last, else the open one, again, when its columns mean
    /// something else now; other files know their own dimensions.
    void setDimensions(int dimensions);
    /// The open file again, when its tables were made for another place. What cannot be read in
    /// that way is no question to the user, who has not asked for it.
    void setPlace(const AxisPlace& place);
    /// What the user has said about the file so far, also where it could not be read in that way.
    [[nodiscard]] ImportChoices choicesFor(const QString& path) const;
    /// With which the open file was read: reading it again means the same by it.
    [[nodiscard]] const ImportChoices& readWith() const { return m_readWith; }
    void close();
    void cancelReading();
    [[nodiscard]] OpenedFile opened() const;
    /// As it was, without reading it again; what was being read then is read now. changed()
    /// follows, dataReplaced() does not.
    void putBack(const OpenedFile& opened);

Q_SIGNALS:
    void changed();
    /// New data: of another file or the same one again. before: what there was, may be null.
    void dataReplaced(std::shared_ptr<const axiscomp::CalibrationData> before, bool isSameFile);
    void failed(const axiscomp::ui::LoadedFile& file);
    /// The file cannot be used without other choices.
    void choiceNeeded(const QString& path);

private:
    void load(const QString& path, int dimensions, const ImportChoices& choices);
    void take(const LoadedFile& loaded);
    void takeNotes();
    void watch();
    void lookAtDisk();

    DataFile m_file;
    std::vector<LoadedTable> m_tables; ///< of m_file.data
    FileStamp m_stamp;
    std::map<QString, ImportChoices> m_choices; ///< by file
    ImportChoices m_readWith; ///< of m_file.path
    ImportChoices m_readingWith; ///< of m_file.readingPath
    bool m_isUnasked = false; ///< nobody has asked for what is being read
    int m_dimensions = 1; ///< with which the data was read, or is being read
    DataFileLoader m_loader;
    QFileSystemWatcher m_watcher;
};

} // namespace axiscomp::ui
