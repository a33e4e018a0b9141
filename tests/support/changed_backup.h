// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/local_file.h"
#include "core/store/backup.h"
#include "tests/support/verify.h"

#include <filesystem>
#include <functional>
#include <string>

namespace axiscomp::test {

/// What the file says of its first axis; the file is a valid one all the same.
inline void changeBackup(
    const std::filesystem::path& file, const std::function<void(AxisBackup&)>& change)
{
    const auto text = loadFile(file, maximumBackupSize);
    VERIFY_RESULT(text);
    auto backup = readBackup(asText(*text), file.string());
    VERIFY_RESULT(backup);
    change(backup->axes.front());
    VERIFY_RESULT(saveFile(file, asBytes(writeBackup(*backup))));
}

/// As if the axis had had this name when the backup was made.
inline void nameInBackup(const std::filesystem::path& file, const std::string& name)
{
    changeBackup(file, [&](AxisBackup& axis) { axis.axisName = name; });
}

} // namespace axiscomp::test
