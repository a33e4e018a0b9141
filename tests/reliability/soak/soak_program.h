// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/drive_store.h"
#include "tests/reliability/soak/operation.h"
#include "tests/support/link_attachment.h"

#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <thread>

namespace axiscomp::test {

/// One of several programs that use a drive: a thread with its own link, its own DriveStore over
/// the shared folder and its own AxisCompensator. When the program dies it is started again.
class SoakProgram {
public:
    SoakProgram(const AttachmentKind& kind, drivecomm::VirtualDrive& drive,
        std::filesystem::path store, std::function<WallTime()> clock);
    ~SoakProgram();

    /// operation must live until finish() has returned. One at a time.
    void start(const Operation& operation);
    [[nodiscard]] Ending finish();

private:
    struct Instance;
    void run();
    [[nodiscard]] Ending perform(const Operation& operation, std::unique_ptr<Instance>& instance);

    const AttachmentKind m_kind;
    drivecomm::VirtualDrive& m_drive;
    const std::filesystem::path m_store;
    const std::function<WallTime()> m_clock;

    std::mutex m_mutex;
    std::condition_variable m_changed;
    const Operation* m_operation = nullptr;
    std::optional<Ending> m_ending;
    bool m_isEnding = false;
    std::thread m_thread;
};

} // namespace axiscomp::test
