// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/report/plot_ink.h"

namespace axiscomp::report {

std::string_view inkColour(PlotInk ink)
{
    switch (ink) {
    case PlotInk::Frame:
        return "#202020";
    case PlotInk::Grid:
        return "#c8c8c8";
    case PlotInk::Run:
        return "#909090";
    case PlotInk::Up:
        return "#1f4e8c";
    case PlotInk::Down:
        return "#c05a00";
    case PlotInk::Mean:
        break;
    }
    return "#000000";
}

std::string_view bandColour(PlotInk ink)
{
    return ink == PlotInk::Down ? "#f6e3d2" : "#d9e4f2";
}

std::vector<PlotPoint> markerOutline(const PlotMarker& marker)
{
    const double half = marker.size / 2.0;
    const double tip = marker.shape == PlotMarkerShape::TriangleUp ? -half : half;
    const PlotPoint& centre = marker.centre;
    return {{centre.x, centre.y + tip}, {centre.x - half, centre.y - tip},
        {centre.x + half, centre.y - tip}};
}

} // namespace axiscomp::report
