// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/register_access.h"
#include "core/drive/compensation_setup.h"

#include <unordered_map>

namespace axiscomp {

/// Which register has which address, as far as it was needed so far. A DimSource register holds an
/// address; people read and write paths (docs/drive.md, "Registers").
class SourceDirectory {
public:
    /// Forgets everything when the drive is another one than before.
    void useDrive(const DriveIdentity& drive);

    /// A path, tam:// URI or hex address. Errors: SourceNotFound, SourceWrongType,
    /// SourceOtherDrive.
    [[nodiscard]] Result<DimSource> resolve(const RegisterAccess& access, const std::string& text);
    /// The path may come back empty: the drive has no such register, or does not tell.
    [[nodiscard]] Result<DimSource> sourceAt(const RegisterAccess& access, std::uint32_t address);
    [[nodiscard]] Result<std::vector<DimSource>> shortlist(const RegisterAccess& access);

private:
    [[nodiscard]] Result<DimSource> resolvePath(
        const RegisterAccess& access, const std::string& path, const std::string& asWritten);
    [[nodiscard]] Result<DimSource> resolveAddress(
        const RegisterAccess& access, const std::string& text);
    [[nodiscard]] Result<void> loadShortlist(const RegisterAccess& access);
    [[nodiscard]] Result<void> loadTree(const RegisterAccess& access);
    [[nodiscard]] Text nearest(const std::string& path) const;
    void remember(const RegisterReading& reading);

    struct Register {
        std::string path;
        std::string type;
    };
    DriveIdentity m_drive;
    std::unordered_map<std::uint32_t, Register> m_registers;
    std::vector<DimSource> m_shortlist;
    bool m_shortlistLoaded = false;
    bool m_treeLoaded = false;
};

} // namespace axiscomp
