// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/judge/judgement.h"
#include "core/metrology/report/report_document.h"
#include "core/table/grid.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axiscomp {

// The facts that a report shows. What is empty is not on record, and the page says so.

/// A file that went into it.
struct ReportInput {
    std::string file;
    std::string format;
    std::string sha256; ///< of its bytes, in hexadecimal digits
};

/// What was measured, before or after: corrected, and with the values marked that are left out.
struct ReportMeasurement {
    Measurement measurement;
    std::vector<Text> corrections; ///< what was made of the values as read
    /// Whether it is on record what was corrected: without that an empty list says nothing.
    bool areCorrectionsKnown = false;
    /// CRC-32 of the table that was active as a person has stated it; nothing: nobody has.
    std::optional<std::uint32_t> statedTable = {};
    /// Position, in mm, that was stated as the datum; nothing: none.
    std::optional<double> datum = {};
    std::vector<std::string> files = {}; ///< names of those that it was joined of, in their order
};

struct ReportPrediction {
    /// Of the same runs with the table active; in mm or deg, by Iso230Figure.
    std::array<std::optional<double>, iso230FigureCount> figures{};
    /// What is left at targets that the table was made without, in mm or deg.
    std::optional<double> heldOutRms;
    std::optional<double> heldOutLargest;
    std::optional<double> heldOutM;
};

/// One of several tables that were made together.
struct ReportedColumn {
    std::string name; ///< "dX"
    std::string target; ///< the axis that it corrects; empty: not on record
    std::uint32_t crc = 0;
};

struct ReportedTable {
    Grid grid; ///< without axes: not on record
    std::vector<ReportedColumn> columns; ///< empty where there is but one table
    Text method;
    std::optional<std::uint32_t> crc; ///< nothing: not on record, or that of each column
    std::string slot;
    std::optional<bool> isPersistent;
    Text proof; ///< what the end-to-end proof has come to
};

struct ReportContent {
    bool isAngular = false; ///< lengths are degrees
    bool isByTemperature = false; ///< the figures are those of a fit by temperature
    std::string machine; ///< as a measurement's files say it, likewise axis and serial
    std::string axis;
    std::string corrected; ///< the axis that the table corrects, where it is not the measured one
    std::string serial;
    std::string drive;
    std::string driveSerial;
    std::string firmwareProfile;
    std::optional<ReportMeasurement> before;
    std::optional<ReportMeasurement> after;
    std::optional<ReportPrediction> prediction;
    ReportedTable table;
    Text sign; ///< what the drive will add where, in numbers
    std::vector<Tolerance> tolerances;
    std::optional<double> uncertainty; ///< U with k = 2, in mm or deg
    std::vector<JudgeWarning> warnings; ///< without which no figure is to be read
    std::vector<Text> notes;
    std::vector<ReportInput> inputs;
    std::string programVersion;
};

struct ReportOptions {
    /// A second page with every target, every value that is left out, all notes and all files.
    bool wantsLists = false;
};

/// The figures of one of its measurements by the rule that those of the prediction are made by.
[[nodiscard]] Iso230Figures figuresBy(const ReportContent& content, const Measurement& measurement);
/// As if nothing were left out. Nothing: nothing is.
[[nodiscard]] std::optional<Iso230Figures> figuresOfAllValues(
    const ReportContent& content, const Measurement& measurement);

/// The page: one of A4 without lists, however much is on record.
[[nodiscard]] ReportDocument reportDocument(
    const ReportContent& content, const ReportOptions& options = {});

} // namespace axiscomp
