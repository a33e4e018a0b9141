// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <cstddef>
#include <stop_token>
#include <vector>

namespace axiscomp::ui {

/// Some lines of a calibration file, in their columns as the parser counts them.
struct FileExcerpt {
    std::size_t firstLine = 1; ///< number of lines.front(), counted from 1
    std::vector<QStringList> lines; ///< long ones are cut
    QStringList header; ///< the cells of the file's header line, if it has one
    bool hasMore = false; ///< further lines follow
    friend bool operator==(const FileExcerpt&, const FileExcerpt&) = default;
};

/// A line with its neighbours, at most `around` on each side; no lines when the file cannot be read
/// or is shorter. Line 0, the whole file, is its beginning. Lines end as in calibration files: LF,
/// CRLF or CR. Reads up to the line and some megabytes beyond, whatever the size of the file: not
/// for the window's thread.
[[nodiscard]] FileExcerpt excerptOf(
    const QString& path, std::size_t line, std::size_t around, const std::stop_token& stop);

} // namespace axiscomp::ui
