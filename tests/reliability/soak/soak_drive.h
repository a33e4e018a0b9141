// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/reliability/soak/drive_picture.h"

#include <QTemporaryDir>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <memory>

namespace axiscomp::test {

/// A virtual drive of three axes whose time passes only when it is asked something, one millisecond
/// each time, or when it is told to. It keeps its flash in a folder, so that one can see what a
/// reboot would bring back without rebooting it.
class SoakDrive {
public:
    static constexpr std::int32_t serialNumber = 4711;
    static constexpr int axes = 3;

    SoakDrive();

    [[nodiscard]] drivecomm::VirtualDrive& drive() { return *m_drive; }
    [[nodiscard]] DrivePicture picture() { return pictureOf(*m_drive); }
    /// What the drive would hold after a reboot: another drive is made of a copy of its flash.
    [[nodiscard]] DrivePicture pictureAfterReboot();

    [[nodiscard]] WallTime now() const;
    void pass(std::chrono::milliseconds time) { m_milliseconds += time.count(); }
    void home();
    /// A value that was to be stored wrong and was not, is stored wrong in a place that nobody
    /// uses.
    void forgetWrongStore();

    [[nodiscard]] std::filesystem::path store() const { return m_folder / "store"; }
    /// Slots with tables of a drive program, which no axis may take.
    [[nodiscard]] static const std::vector<std::string>& foreignSlots();

private:
    [[nodiscard]] drivecomm::VirtualDriveOptions options(const std::filesystem::path& flash);

    QTemporaryDir m_temporary;
    std::filesystem::path m_folder;
    std::atomic<std::int64_t> m_milliseconds = 0;
    std::unique_ptr<drivecomm::VirtualDrive> m_drive;
};

} // namespace axiscomp::test
