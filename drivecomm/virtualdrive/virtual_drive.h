// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/bytes.h"
#include "core/drive_link.h"
#include "core/drive_profile.h"
#include "core/result.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace axiscomp::drivecomm {

/// One axis of a virtual drive: a slow sine over its range.
struct VirtualAxis {
    std::string name;
    std::string unit = "Millimeter"; ///< PositionUnit
    double low = 0.0; ///< position units
    double high = 100.0;
    double periodSeconds = 60.0;
    bool homed = true;
};

struct VirtualDriveOptions {
    std::string name = "Virtual-1";
    std::int32_t serialNumber = 100001;
    std::vector<VirtualAxis> axes;
    std::vector<RegisterWrite>
        parameters; ///< initial register values, for instance of a TAM configuration
    std::filesystem::path stateFolder; ///< keeps flash and parameters across runs; empty: not kept
    /// Simulated time since power-on, monotonic; the drive has no thread, it is a function of this
    /// time.
    std::function<std::chrono::nanoseconds()> clock;
};

/// A drive with the behaviour of spec/drive.md ("Behaviour"): registers with addresses, RAM and
/// flash tables, commit and delete, flash wear, homing, moving axes, 10 kHz lookup, 10 ms ramp,
/// reboot. Every member function may be called from any thread. Errors carry the codes that
/// DriveLink documents.
class VirtualDrive {
public:
    /// profile must outlive the drive.
    VirtualDrive(const DriveProfile& profile, VirtualDriveOptions options);
    ~VirtualDrive();

    [[nodiscard]] DriveIdentity identity() const;
    /// Up to DriveLink::maximumReads paths, read at one instant.
    [[nodiscard]] Result<std::vector<RegisterReading>> readRegisters(
        const std::vector<std::string>& paths);
    [[nodiscard]] std::vector<RegisterReading> readTree(const std::string& prefix);
    /// Up to DriveLink::maximumWrites, at one instant, all or none.
    [[nodiscard]] Result<void> writeRegisters(const std::vector<RegisterWrite>& writes);
    [[nodiscard]] std::vector<DriveFile> listFiles();
    [[nodiscard]] Result<Bytes> download(const std::string& path);
    [[nodiscard]] Result<void> upload(const std::string& path, ByteView bytes);
    void reboot();

    /// For tests and faults: the next stored table gets a wrong byte, the next register write a
    /// wrong value.
    void storeNextWrong();

private:
    struct Private;
    std::unique_ptr<Private> d;
};

/// DriveLink to a virtual drive in the same process. drive must outlive the link.
[[nodiscard]] std::unique_ptr<DriveLink> makeDirectLink(VirtualDrive& drive);

/// The drive behind "demo:": two axes, named and homed, the first with an active example table.
[[nodiscard]] VirtualDriveOptions demoDriveOptions();
void loadDemoState(VirtualDrive& drive);

} // namespace axiscomp::drivecomm
