// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/travel_coverage.h"
#include "core/table/compensation_table.h"

#include <QColor>
#include <QString>

#include <array>
#include <memory>
#include <optional>

#include "ui/drawing/custom_plot.h"

namespace axiscomp::ui {

/// How far the axis travels, against the range of the table. 1D: the travel is tinted, a bracket
/// shows the table's range, dashed lines the end values that the drive holds beyond it. 2D: the
/// rectangle of the travel around the map.
class TravelMark {
public:
    using Spans = std::array<std::optional<Travel>, 2>; ///< none: the drive does not say

    explicit TravelMark(QCustomPlot& plot);

    /// Null: none. holdsEnds: beyond the table there are its end values.
    void setTable(std::shared_ptr<const CompensationTable> table);
    /// Of the drawn axes, in positions of the table.
    void setTravel(const Spans& travel, bool holdsEnds);
    [[nodiscard]] const Spans& travel() const { return m_travel; }
    void setTexts(const QString& travel, const QString& table, const QString& held);
    void setColors(const QColor& tint, const QColor& line, const QColor& text, const QColor& base);

    /// What a whole view shows of an axis: table and travel, but never so much travel that the
    /// table is less than a third of it.
    [[nodiscard]] QCPRange wholeRange(std::size_t drawnAxis) const;

private:
    [[nodiscard]] bool isShown() const;
    [[nodiscard]] bool isMap() const { return m_table->grid.dimensions() == 2; }
    [[nodiscard]] QRectF placeOfTravel(const QRectF& sight) const;
    [[nodiscard]] QRectF placeOfMap() const;
    void paintTint(QCPPainter& painter, const QRectF& sight) const;
    void paintLines(QCPPainter& painter, const QRectF& sight) const;
    void paintBracket(QCPPainter& painter, const QRectF& sight) const;
    void paintHeldEnds(QCPPainter& painter, const QRectF& sight) const;
    void paintHeldNote(QCPPainter& painter, const QRectF& travel, const QRectF& sight) const;

    QCustomPlot& m_plot;
    std::shared_ptr<const CompensationTable> m_table;
    Spans m_travel;
    bool m_holdsEnds = true;
    QString m_travelText;
    QString m_tableText;
    QString m_heldText;
    QColor m_tint;
    QColor m_line;
    QColor m_text;
    QColor m_base;
};

} // namespace axiscomp::ui
