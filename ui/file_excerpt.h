// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <cstddef>

namespace axiscomp::ui {

/// Some lines of a text file.
struct FileExcerpt {
    std::size_t firstLine = 1; ///< number of lines.front(), counted from 1
    QStringList lines; ///< without line ends; long ones are cut
    friend bool operator==(const FileExcerpt&, const FileExcerpt&) = default;
};

/// A line with its neighbours, at most `around` on each side; no lines when the file cannot be read
/// or is shorter. Lines end as in calibration files: LF, CRLF or CR. Reads up to the line: not for
/// the window's thread.
[[nodiscard]] FileExcerpt excerptOf(const QString& path, std::size_t line, std::size_t around);

} // namespace axiscomp::ui
