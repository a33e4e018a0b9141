// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/capture/capture_session.h"
#include "drivecomm/virtualdrive/file_descriptor.h"

#include <filesystem>
#include <string>

namespace axiscomp::drivecomm {

/// The file of the values that are being captured: the documented CSV of runs, a line for each
/// value, in the order of the plan. It only ever has whole lines that are on the disk; what a crash
/// left of a line is cut off when it is opened again. Locked against other programs while open.
class RunFile {
public:
    /// state: of the compensation, "off", "on" or "crc:1c291ca3"; date: of now, for a new file.
    /// A file that is there goes on where it ends; its lines must be the first steps of the plan,
    /// and its state this one. Errors: FileNotReadable with the line, FileNotWritable.
    [[nodiscard]] static Result<RunFile> open(const std::filesystem::path& file,
        const MeasuringPlan& plan, const std::string& state, const std::string& date);

    /// How many steps of the plan have their value.
    [[nodiscard]] std::size_t taken() const { return m_taken; }
    /// The value of the next step; on the disk when this returns. Errors: FileNotWritable: the file
    /// is as it was before.
    [[nodiscard]] Result<void> append(const CapturedValue& value);

private:
    RunFile(std::filesystem::path file, FileDescriptor descriptor);
    [[nodiscard]] Result<void> begin(
        const MeasuringPlan& plan, const std::string& state, const std::string& date);
    [[nodiscard]] Result<void> goOn(
        const std::string& content, const MeasuringPlan& plan, const std::string& state);
    [[nodiscard]] Result<void> write(const std::string& text);

    std::filesystem::path m_file;
    FileDescriptor m_descriptor;
    std::size_t m_size = 0; ///< bytes, whole lines
    std::size_t m_taken = 0;
};

} // namespace axiscomp::drivecomm
