// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reliability/soak/soak_drive.h"

#include "core/table/tam_table.h"
#include "drivecomm/profile/profile_loader.h"
#include "tests/support/compensator_fixture.h"

namespace axiscomp::test {

SoakDrive::SoakDrive()
    : m_folder(m_temporary.path().toStdString())
    , m_drive(
          drivecomm::VirtualDrive::create(drivecomm::genericProfile(), options(m_folder / "flash"))
              .value())
{
    for (const std::string& name : foreignSlots()) {
        const TableSlot& slot = *m_drive->profile().slotNamed(name);
        const Bytes file =
            encodeTamTable(exampleTable(1, 99), true, m_drive->profile().layout).value();
        (void)m_drive->upload(slot.file, file);
    }
    pass(m_drive->profile().flashWear.window); // no program knows of these
}

drivecomm::VirtualDriveOptions SoakDrive::options(const std::filesystem::path& flash)
{
    drivecomm::VirtualDriveOptions options;
    options.name = "Soak-1";
    options.serialNumber = serialNumber;
    options.axes = {
        {.name = "X"}, {.name = "Y", .periodSeconds = 37.0}, {.name = "Z", .periodSeconds = 23.0}};
    options.stateFolder = flash;
    options.clock = [this] {
        return std::chrono::nanoseconds(std::chrono::milliseconds(++m_milliseconds));
    };
    options.wallClock = [this] { return now(); };
    return options;
}

WallTime SoakDrive::now() const
{
    return WallTime(
        std::chrono::hours(24 * 365 * 50) + std::chrono::milliseconds(m_milliseconds.load()));
}

DrivePicture SoakDrive::pictureAfterReboot()
{
    const std::filesystem::path copy = m_folder / "copy";
    std::filesystem::remove_all(copy);
    std::filesystem::copy(m_folder / "flash", copy, std::filesystem::copy_options::recursive);
    const auto drive =
        drivecomm::VirtualDrive::create(drivecomm::genericProfile(), options(copy)).value();
    return pictureOf(*drive);
}

void SoakDrive::home()
{
    for (int axis = 0; axis < axes; ++axis)
        (void)m_drive->writeRegisters(
            {{"Axes[" + std::to_string(axis) + "]/Commands/Homing/Command", "Start"}});
    pass(std::chrono::seconds(2));
}

void SoakDrive::forgetWrongStore()
{
    (void)m_drive->writeRegisters({{"Application/Variables/Floats[255]", 1.0F}});
}

const std::vector<std::string>& SoakDrive::foreignSlots()
{
    static const std::vector<std::string> slots{"Small8", "Large2"};
    return slots;
}

} // namespace axiscomp::test
