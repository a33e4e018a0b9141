// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"

#include <string>
#include <variant>
#include <vector>

namespace axiscomp {

// A page as values: what stands on it and in which order, in no language and for no device. Every
// renderer (HTML, PDF) draws the same document.

struct ReportHeading {
    Text text;
};

struct ReportParagraph {
    Text text;
    bool isStrong = false; ///< the sentence that is to be seen first
};

struct ReportFact {
    Text name;
    Text value;
};
/// Names with their values, beside each other in as many columns.
struct ReportFacts {
    std::vector<ReportFact> facts;
    int columns = 1;
};

struct ReportTable {
    std::vector<Text> header;
    std::vector<std::vector<Text>> rows; ///< each as long as the header
    bool hasNumbers = false; ///< all columns but the first stand at their right
};

/// Where something is in a plot: mm from its upper left corner, y downwards.
struct PlotPoint {
    double x = 0.0;
    double y = 0.0;

    friend bool operator==(const PlotPoint&, const PlotPoint&) = default;
};

/// What a line or marker belongs to. A colour has a shade of its own, so that it can be told in
/// grey print too; shapes and dashes tell the rest.
enum class PlotInk {
    Frame, ///< axes and marks
    Grid,
    Run, ///< a single run
    Up,
    Down,
    Mean, ///< of both directions
};

struct PlotLine {
    std::vector<PlotPoint> points;
    PlotInk ink = PlotInk::Frame;
    double width = 0.2; ///< mm
    std::vector<double> dashes = {}; ///< lengths of lines and gaps in mm; empty: a full line
};

enum class PlotMarkerShape {
    TriangleUp, ///< filled
    TriangleDown, ///< hollow
};
struct PlotMarker {
    PlotPoint centre;
    PlotMarkerShape shape = PlotMarkerShape::TriangleUp;
    PlotInk ink = PlotInk::Up;
    double size = 1.6; ///< mm
};

/// The area between two limits, filled with a light shade of the ink.
struct PlotBand {
    std::vector<PlotPoint> outline;
    PlotInk ink = PlotInk::Up;
};

struct PlotLabel {
    enum class Side { Left, Centre, Right }; ///< where of the text its place is
    PlotPoint place; ///< on the line on which the text stands
    Text text;
    Side side = Side::Centre;
    bool isVertical = false; ///< read from below
    double size = 2.3; ///< height of the font in mm
};

struct ReportPlot {
    Text description; ///< for those who do not see it
    double width = 0.0; ///< mm
    double height = 0.0; ///< mm
    // In the order in which they are drawn.
    std::vector<PlotBand> bands;
    std::vector<PlotLine> lines;
    std::vector<PlotMarker> markers;
    std::vector<PlotLabel> labels;
};
/// Plots beside each other.
struct ReportPlots {
    std::vector<ReportPlot> plots;
};

struct ReportPageBreak { };

using ReportBlock = std::variant<ReportHeading, ReportParagraph, ReportFacts, ReportTable,
    ReportPlots, ReportPageBreak>;

struct ReportDocument {
    Text title;
    std::string language = "en"; ///< of all texts
    std::vector<ReportBlock> blocks;
};

/// The document with every text in this language.
[[nodiscard]] ReportDocument worded(
    ReportDocument document, const Wording& wording, const std::string& language);

/// All that is written on it, a line for each text: for those who have to know its characters.
[[nodiscard]] std::string wordsOf(const ReportDocument& document);

} // namespace axiscomp
