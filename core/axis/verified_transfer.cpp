// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/axis/verified_transfer.h"

#include <algorithm>

namespace axiscomp {

namespace {

/// Registers may come back in another number type than they were sent in.
bool sameValue(const RegisterValue& a, const RegisterValue& b)
{
    return a == b || toText(a) == toText(b);
}

/// One request where the drive takes several registers at one instant, otherwise one after the
/// other.
Result<void> writeInOrder(const RegisterAccess& access, const std::vector<RegisterWrite>& writes)
{
    if (access.profile().writesAtOneInstant || writes.size() == 1)
        return access.write(writes);
    for (const RegisterWrite& write : writes) {
        if (auto written = access.write({write}); !written)
            return written;
    }
    return {};
}

Text byteText(ByteView bytes, std::ptrdiff_t offset)
{
    const auto at = static_cast<std::size_t>(offset);
    if (at >= bytes.size())
        return AXISCOMP_TEXT("Error", "nothing");
    return AXISCOMP_TEXT("Error", "byte {value}").with("value", std::to_integer<int>(bytes[at]));
}

} // namespace

Result<void> compareRegisters(
    const RegisterAccess& access, const std::vector<RegisterWrite>& wanted)
{
    std::vector<std::string> paths;
    for (const RegisterWrite& write : wanted)
        paths.push_back(write.path);
    AXISCOMP_TRY(auto readings, access.link().readRegisters(paths, access.exchange()));
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (!sameValue(readings[i].value, wanted[i].value))
            return fail(ErrorCode::VerifyMismatch,
                {{"what", wanted[i].path}, {"found", toText(readings[i].value)},
                    {"expected", toText(wanted[i].value)}});
    }
    return {};
}

Result<void> compareFiles(const std::string& path, ByteView found, ByteView expected)
{
    const auto [at, wanted] = std::ranges::mismatch(found, expected);
    if (at == found.end() && wanted == expected.end())
        return {};
    const std::ptrdiff_t offset = at - found.begin();
    return fail(ErrorCode::VerifyMismatch,
        {{"what",
             AXISCOMP_TEXT("Error", "{path} at offset {offset}")
                 .with("path", path)
                 .with("offset", offset)},
            {"found", byteText(found, offset)}, {"expected", byteText(expected, offset)}});
}

Result<void> writeVerified(const RegisterAccess& access, const std::vector<RegisterWrite>& values,
    const std::vector<RegisterWrite>& commands)
{
    std::vector<RegisterWrite> all = values;
    all.insert(all.end(), commands.begin(), commands.end());
    auto written = writeInOrder(access, all);
    if (written || !mayHaveArrived(written.error().code))
        return written;
    // What another drive holds says nothing about this one, and the rest is not for it.
    AXISCOMP_CHECK(access.checkDrive());
    if (commands.empty() && compareRegisters(access, values))
        return {};
    return writeInOrder(access, all);
}

Result<void> uploadVerified(const RegisterAccess& access, const std::string& path, ByteView bytes,
    const std::function<void(std::string_view, double)>& progress)
{
    const auto exchangeFor = [&](std::string_view step, double begin) {
        Exchange exchange = access.exchange();
        exchange.progress = [&progress, step, begin](std::uint64_t done, std::uint64_t total) {
            if (progress && total > 0)
                progress(
                    step, begin + 0.5 * static_cast<double>(done) / static_cast<double>(total));
        };
        return exchange;
    };
    auto uploaded = access.link().upload(path, bytes, exchangeFor("upload", 0.0));
    if (!uploaded && !mayHaveArrived(uploaded.error().code))
        return uploaded;
    if (!uploaded) {
        const auto same = access.checkDrive();
        if (!same && same.error().code == ErrorCode::OtherDrive)
            return same;
    }
    auto found = access.link().download(path, exchangeFor("verify", 0.5));
    if (!found)
        return fail(uploaded ? found.error() : uploaded.error());
    auto same = compareFiles(path, *found, bytes);
    // An upload that did not arrive is its own error, not a difference.
    return uploaded || same ? same : uploaded;
}

Result<void> saveParameters(const RegisterAccess& access)
{
    return writeVerified(
        access, {}, {{access.registers().saveParameters, access.enums().saveParametersSave}});
}

Result<void> deleteTable(const RegisterAccess& access, std::string_view slot)
{
    const std::vector<RegisterWrite> command{
        {access.slotPath(access.registers().tableCommand, slot),
            access.enums().tableCommandDelete}};
    AXISCOMP_CHECK(writeVerified(access, {}, command));
    AXISCOMP_TRY(const bool isEmpty, isSlotEmpty(access, slot));
    if (isEmpty)
        return {};
    // The command may have been lost; to repeat it costs nothing where it was not.
    AXISCOMP_CHECK(access.checkDrive());
    AXISCOMP_CHECK(writeVerified(access, {}, command));
    return checkEmpty(access, slot);
}

Result<bool> isSlotEmpty(const RegisterAccess& access, std::string_view slot)
{
    const std::string elements = access.slotPath(access.registers().tableElements, slot);
    AXISCOMP_TRY(const auto readings, access.readAvailable({elements}));
    if (readings.contains(elements))
        return unsignedAt(readings, elements) == 0;
    const TableSlot* known = access.profile().slotNamed(slot);
    AXISCOMP_TRY(const auto files, access.link().listFiles(access.exchange()));
    return std::ranges::none_of(files,
        [&](const DriveFile& file) { return known && file.path == known->file && file.size > 0; });
}

Result<void> checkEmpty(const RegisterAccess& access, std::string_view slot)
{
    AXISCOMP_TRY(const bool isEmpty, isSlotEmpty(access, slot));
    if (isEmpty)
        return {};
    return fail(ErrorCode::VerifyMismatch,
        {{"what", AXISCOMP_TEXT("Error", "slot {slot}").with("slot", Verbatim{std::string(slot)})},
            {"found", AXISCOMP_TEXT("Error", "a table")},
            {"expected", AXISCOMP_TEXT("Error", "empty")}});
}

} // namespace axiscomp
