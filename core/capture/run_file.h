// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_session.h"
#include "core/drive/drive_link.h"
#include "core/io/system.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace axiscomp {

/// Where the values of a file come from.
struct RunOrigin {
    std::string state; ///< of the compensation: "off", "on" or "crc:1c291ca3"
    std::string reference; ///< the instrument, and how its numbers are taken
    std::string date; ///< of now, for a new file
    std::string encoder = {}; ///< the register of the raw position
    std::optional<DriveIdentity> drive = {}; ///< that measures; its number of axes does not count
    std::string tablePlace = {}; ///< AxisReadings::tablePlace
};

/// The file of the values that are being captured: the documented CSV of runs, a line for each
/// value, in the order of the plan. It only ever has whole lines that are on the disk; what a crash
/// left of a line is cut off when it is opened again. Locked against other programs while open.
class RunFile {
public:
    /// A file that is there goes on where it ends; its lines must be the first steps of the plan,
    /// its feed, its dwell, its state, its reference and, where it names them, its encoder, its
    /// drive and the place of its table these. A drive is told by its serial number: its name may
    /// change. One without a value begins anew. Errors: FileNotReadable with the line,
    /// FileNotWritable.
    [[nodiscard]] static Result<RunFile> open(
        const std::filesystem::path& file, const MeasuringPlan& plan, const RunOrigin& origin);

    [[nodiscard]] const std::string& reference() const { return m_reference; } ///< of the origin
    /// How many steps of the plan have their value.
    [[nodiscard]] std::size_t taken() const { return m_values.size(); }
    /// Of the first steps of the plan.
    [[nodiscard]] std::span<const CapturedValue> values() const { return m_values; }
    /// The value of the next step; on the disk when this returns. Errors: FileNotWritable: the file
    /// is as it was before, also where another one has its name by now or somebody has changed it.
    [[nodiscard]] Result<void> append(const CapturedValue& value);
    /// Takes the last value, which there must be, off the file: its line is gone from the disk when
    /// this returns. Errors: FileNotWritable: values() says whether the file still has it, and a
    /// power cut may bring it back.
    [[nodiscard]] Result<void> removeLast();

private:
    RunFile(std::filesystem::path file, system::File opened);
    [[nodiscard]] Result<void> begin(const MeasuringPlan& plan, const RunOrigin& origin);
    [[nodiscard]] Result<void> goOn(
        const std::string& content, const MeasuringPlan& plan, const RunOrigin& origin);
    [[nodiscard]] Result<void> write(const std::string& text);
    /// What is written goes to the file of this name, and behind what is known of it.
    [[nodiscard]] Result<void> checkUnchanged() const;

    std::filesystem::path m_file;
    std::string m_reference;
    system::File m_opened;
    std::size_t m_size = 0; ///< bytes, whole lines
    bool m_mayHaveTail = false; ///< part of a line that could not be cut off
    std::vector<CapturedValue> m_values;
    std::vector<std::size_t> m_lineBegins; ///< of the values, in bytes
};

} // namespace axiscomp
