// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>

class QWidget;

namespace axiscomp::ui {

/// What a file dialog is to ask.
struct FileQuestion {
    enum class Purpose {
        OpenData,
        OpenMeasurement,
        OpenDeadPath,
        OpenConfiguration,
        OpenBackup,
        SaveExample,
        SaveLog,
        ExportTable,
        SaveConfiguration,
        SaveBackup,
        SaveMeasurement,
        OpenRecord,
        SaveRecord,
        SaveReport,
        OpenActiveTable,
        SaveTable,
        OpenPlan,
        OpenMachine,
        SaveMachine, ///< a folder
        SavePlan,
        SaveProgram,
        SaveValues, ///< that are captured: a file that is there goes on where it ends
    } purpose = Purpose::OpenData;
    QString title;
    QString filter;
    QString start; ///< folder, or proposed file
};

/// Asks for a file and calls answer with its path, or not at all when the user gives up. Returns at
/// once.
using FilePicker = std::function<void(
    QWidget& parent, const FileQuestion& question, std::function<void(const QString&)> answer)>;

/// The system's own dialog, open beside the page.
[[nodiscard]] FilePicker systemFilePicker();

} // namespace axiscomp::ui
