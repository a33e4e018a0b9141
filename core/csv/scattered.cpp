// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/scattered.h"

#include "core/csv/header.h"
#include "core/text/number_text.h"

namespace axiscomp::csv {

namespace {

/// The dimensions that are enough for a point of each row; 0: all are needed.
int fewerDimensions(const Scan& scan, const std::vector<double>& counts)
{
    double points = 1.0;
    for (std::size_t d = 0; d + 1 < counts.size(); ++d) {
        points *= counts[d];
        if (points >= static_cast<double>(scan.rows))
            return static_cast<int>(d) + 1;
    }
    return 0;
}

} // namespace

bool isScattered(
    const Scan& scan, double snap, std::size_t maximumRows, DiagnosticList& diagnostics)
{
    if (scan.dimensions == 1 || scan.rows == 0)
        return false;
    const auto most = static_cast<double>(maximumRows);
    const auto dimensions = static_cast<std::size_t>(scan.dimensions);
    double texts = 1.0; // which may be several of one position
    for (std::size_t d = 0; d < dimensions; ++d)
        texts *= static_cast<double>(scan.positionsOf(d).size());
    if (texts <= most)
        return false;
    std::vector<double> counts;
    double points = 1.0;
    for (std::size_t d = 0; d < dimensions; ++d) {
        const SortedPositions sorted(scan.positionsOf(d));
        if (suggestedSnap(sorted, true) > 0.0)
            return false;
        counts.push_back(static_cast<double>(gridLines(sorted, snap).positions.size()));
        points *= counts.back();
    }
    if (points <= most)
        return false;
    diagnostics.error(DiagnosticCode::MissingPoint, 0, 0,
        AXISCOMP_TEXT("Error", "positions with {all} combinations in the first {count} data lines")
            .with("all", Quantity{roundedText(points)})
            .with("count", scan.rows),
        withDimensionalityHint(
            AXISCOMP_TEXT("Error",
                "a line for every combination of the positions; fit makes a table of scattered "
                "points"),
            fewerDimensions(scan, counts)));
    return true;
}

} // namespace axiscomp::csv
