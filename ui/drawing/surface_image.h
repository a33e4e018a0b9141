// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/compensation_table.h"

#include <QImage>
#include <QPointF>

#include "ui/drawing/custom_plot.h"

#include <array>
#include <memory>

namespace axiscomp::ui {

/// How a 2D table is seen as a surface. Parallel: equal lengths look equal near and far.
struct SurfaceSight {
    std::shared_ptr<const CompensationTable> table;
    double turn = 30.0; ///< degrees about the vertical
    double tilt = 35.0; ///< degrees of the eye above the floor, 5 to 90
    double exaggeration = 1.0; ///< heights are drawn so many times too high
    std::array<double, 2> heights{}; ///< lowest and highest value that the box holds
    QSize size; ///< of the picture, in pixels
    double ratio = 1.0; ///< of these to the window's pixels
    double zoom = 1.0; ///< so many times larger than what fits
};

/// Places of a surface as pixels.
class SurfaceProjection {
public:
    explicit SurfaceProjection(const SurfaceSight& sight);

    struct Place {
        double x = 0.0; ///< pixels
        double y = 0.0;
        double depth = 0.0; ///< larger is farther away
    };
    /// x and y in positions of the table, value in its values.
    [[nodiscard]] Place at(double x, double y, double value) const;
    [[nodiscard]] QPointF pixel(double x, double y, double value) const
    {
        const Place place = at(x, y, value);
        return {place.x, place.y};
    }

private:
    double m_middleX = 0.0;
    double m_middleY = 0.0;
    double m_middleValue = 0.0;
    double m_perX = 1.0; ///< 1 / the table's span of dimension 1, or as drawn
    double m_perY = 1.0;
    double m_perValue = 1.0;
    std::array<double, 2> m_turn{}; ///< sine and cosine
    std::array<double, 2> m_tilt{};
    double m_pixels = 1.0;
    QPointF m_centre;
};

/// Whether the positions of both dimensions and the values of a 2D table can be compared: all are
/// lengths, or angles, or have no unit of their own. Otherwise nothing is true to scale.
[[nodiscard]] bool hasOneScale(const CompensationTable& table);

/// The factor with which the surface is a third as high as it is wide.
[[nodiscard]] double fittingExaggeration(
    const CompensationTable& table, const std::array<double, 2>& heights);

/// The surface in the colours of its values, transparent around it; with the lines of the grid, or
/// of every second, fifth ... of them. Looked up at most samples times along each dimension, and
/// never less often than at every grid point if samples allows it.
[[nodiscard]] QImage surfaceImage(const SurfaceSight& sight, QCPColorGradient gradient,
    const QCPRange& colors, const QColor& lines, int samples);

} // namespace axiscomp::ui
