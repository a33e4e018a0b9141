// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/compensation_table.h"

#include <QWidget>

#include <memory>

class QLabel;

namespace axiscomp::ui {

class PlotCanvas;

/// A small picture of a table to look at: a title, the curve or map, and a line about it.
class TableThumbnail : public QWidget {
    Q_OBJECT

public:
    explicit TableThumbnail(QWidget* parent = nullptr);
    ~TableThumbnail() override;

    /// drawn: 1 or 2 dimensions; null leaves the picture empty. scale: the picture is symmetric
    /// about zero, this far. unit: of the values, a symbol.
    void setPicture(const std::shared_ptr<const CompensationTable>& drawn, double scale,
        const std::string& unit);
    void setTexts(const QString& title, const QString& line);

protected:
    void changeEvent(QEvent* event) override;

private:
    QLabel* m_title;
    PlotCanvas* m_canvas;
    QLabel* m_line;
};

} // namespace axiscomp::ui
