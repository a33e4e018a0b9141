// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/axis_status.h"
#include "core/capture/capture_session.h"
#include "core/drive/drive_profile.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace axiscomp {

/// How a number of an instrument becomes a position: reference = direction x number x unit + zero.
struct ReferenceScale {
    std::string unit; ///< "um"; empty: not said
    bool isInverted = false; ///< the instrument counts the other way
    double zeroAt = 0.0; ///< where the axis is when the instrument says 0, in mm or deg

    /// In mm or deg; unitFactor: of the number's unit to mm or deg.
    [[nodiscard]] double position(double number, double unitFactor) const
    {
        return (isInverted ? -1.0 : 1.0) * number * unitFactor + zeroAt;
    }
};

/// Which registers say where the axis is.
struct CaptureRegisters {
    std::string encoder; ///< raw: of the axis, before its compensation
    std::string reference; ///< empty: the instrument is none of the drive's registers
};

/// Reads what a capture needs of an axis, in one request, and changes nothing on the drive.
class AxisReadings {
public:
    /// status: of the axis, as it is now. What is read is in the unit of the axis; a reference
    /// register is so unless `scale` names another unit. Reads once. profile must outlive what is
    /// made. Errors: InvalidArgument for
    /// the plan of another axis, an encoder that is taken for the instrument, one that is no raw
    /// position of the axis, a register that holds no position; UnitMismatch; NotHomed;
    /// MeasurementState while the compensation is neither on nor off; those of readRegisters.
    [[nodiscard]] static Result<AxisReadings> open(DriveLink& link, const DriveProfile& profile,
        const AxisStatus& status, const MeasuringPlan& plan, CaptureRegisters registers,
        ReferenceScale scale, const Exchange& exchange);

    /// link: to the same drive, another one than at first when that was lost. All at one instant,
    /// as far as the profile allows; without `time`, and without a reference (NaN) where the
    /// instrument is none of the registers. The state is that of the beginning, or what has become
    /// of it. Errors: those of readRegisters.
    [[nodiscard]] Result<CaptureReading> read(DriveLink& link, const Exchange& exchange) const;

    /// Empty: the instrument is none of the drive's registers.
    [[nodiscard]] const std::string& referenceRegister() const { return m_registers.reference; }
    /// "off" or "crc:1c291ca3", when this was opened.
    [[nodiscard]] const std::string& state() const { return m_state; }
    /// Over which sources and positions the table that is active lies, as one line, in the units of
    /// the drive: the CRC of `state` is that of its values alone. Empty: none is active.
    [[nodiscard]] const std::string& tablePlace() const { return m_tablePlace; }
    /// The unit of the axis is not known: the plan's is taken, since the axis must stand at its
    /// targets.
    [[nodiscard]] bool isUnitAssumed() const { return m_isUnitAssumed; }
    /// How far neighbouring numbers of the reference register are apart at a position, in mm or
    /// deg; none: too little to matter, as it is no Single, or the instrument is no register.
    [[nodiscard]] std::optional<double> resolutionAt(double position) const;

private:
    explicit AxisReadings(const DriveProfile& profile) : m_profile(&profile) { }
    [[nodiscard]] Result<void> setUnits(const AxisStatus& status, const MeasuringPlan& plan);
    [[nodiscard]] Result<void> checkReference(const AxisStatus& status) const;
    [[nodiscard]] Result<void> checkEncoder(const AxisStatus& status) const;
    void choosePaths(const AxisStatus& status);
    [[nodiscard]] bool isHomedIn(const std::vector<RegisterReading>& readings) const;
    void addPlacePaths(const AxisStatus& status);
    void dropPlacePaths();
    [[nodiscard]] std::vector<std::string> placeIn(
        const std::vector<RegisterReading>& readings) const;
    [[nodiscard]] std::string stateOf(const std::vector<RegisterReading>& readings) const;

    const DriveProfile* m_profile;
    CaptureRegisters m_registers;
    ReferenceScale m_scale;
    double m_axisFactor = 1.0; ///< of the axis's unit to mm or deg
    double m_referenceFactor = 1.0;
    bool m_isUnitAssumed = false;
    bool m_isSingle = false; ///< the reference register
    std::string m_slot; ///< of the axis's table, empty without one
    std::vector<std::string> m_paths; ///< in the order in which readings are used
    std::size_t m_placePaths =
        0; ///< of sources and positions, behind the CRC; none while it is off
    std::vector<std::string> m_place; ///< what they said when this was opened
    std::string m_tablePlace;
    std::string m_state;
};

/// The first register of the profile's shortlist that says where the axis is before its
/// compensation; empty: none.
[[nodiscard]] std::string encoderRegister(
    const DriveProfile& profile, const std::vector<DimSource>& shortlist, int axis);

/// "Machine/Axes[0]/ReferencePosition [mm], inverted, 0 at 12.5": for the file of the values.
[[nodiscard]] std::string referenceText(const std::string& source, const ReferenceScale& scale);

} // namespace axiscomp
