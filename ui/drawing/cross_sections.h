// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/compensation_table.h"

#include <QPalette>

#include "ui/drawing/value_ticker.h"

#include <array>
#include <memory>

namespace axiscomp::ui {

/// Two curves beside and below a map: its values along both axes through one place, as the drive
/// interpolates them. They share the map's axes and zoom.
class CrossSections : public QObject {
public:
    /// Both rectangles are free: who lays out the plot puts them beside and below its map.
    explicit CrossSections(QCustomPlot& plot);

    [[nodiscard]] QCPAxisRect* beside() const { return m_beside; }
    [[nodiscard]] QCPAxisRect* below() const { return m_below; }
    void setVisible(bool isVisible);
    void setTable(std::shared_ptr<const CompensationTable> table);
    /// In positions of the table.
    void setPlace(const std::array<double, 2>& place);
    void setLabels(const QString& x);
    void setValueFactor(double factor); ///< shown value per value
    /// All axes, to be drawn as the map's are.
    [[nodiscard]] QList<QCPAxis*> axes() const;
    void setPen(const QPen& pen);

private:
    void share(QCPAxis* own, QCPAxis* ofMap);

    QCustomPlot& m_plot;
    QCPAxisRect* m_beside;
    QCPAxisRect* m_below;
    std::array<QSharedPointer<ValueTicker>, 2> m_tickers; ///< of the values beside and below
    QCPCurve* m_alongY;
    QCPGraph* m_alongX;
    std::shared_ptr<const CompensationTable> m_table;
};

} // namespace axiscomp::ui
