// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/data/table_change.h"

#include <QWidget>

#include <string>

namespace axiscomp::ui {

class TableThumbnail;

/// The table on the drive, the new one and their difference, side by side; only those there are.
class ChangePictures : public QWidget {
    Q_OBJECT

public:
    explicit ChangePictures(QWidget* parent = nullptr);

    /// unit: of the axis, as the drive names it.
    void setChange(const TableChange& change, const std::string& unit);

private:
    void setPicture(TableThumbnail& thumbnail, const TablePicture& picture, double scale,
        const QString& title, const std::string& unit);

    TableThumbnail* m_before;
    TableThumbnail* m_after;
    TableThumbnail* m_difference;
};

/// "largest +4.1 µm at X 40, Y 0", and which slice is drawn
[[nodiscard]] QString pictureText(const TablePicture& picture, const std::string& unit);

/// "+4.1 µm at X 40, Y 0", "up to +4.1 µm" where it is a bound
[[nodiscard]] QString changeText(
    const LargestChange& change, const Grid& grid, const std::string& unit);

} // namespace axiscomp::ui
