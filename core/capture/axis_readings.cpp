// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/axis_readings.h"

#include "core/axis/state_words.h"
#include "core/table/position_unit.h"
#include "core/text/number_text.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace axiscomp {

namespace {

/// In m_paths; behind these the CRC of the table with its sources and positions, and the reference,
/// where there are any.
enum ReadingPlace : std::size_t { AtEncoder, AtOutput, AtState, AtHoming, AtTable, AtCrc, AtPlace };

tl::unexpected<Error> notCaptured(Text reason)
{
    return fail(ErrorCode::InvalidArgument, {{"reason", std::move(reason)}});
}

std::string unitOfPlan(const MeasuringPlan& plan)
{
    return plan.isAngular ? "deg" : "mm";
}

std::string axisShown(const AxisInfo& axis)
{
    return axis.name.empty() ? std::to_string(axis.index) : axis.name;
}

Result<void> checkAxisOf(const AxisStatus& status, const MeasuringPlan& plan)
{
    if (!status.axis.name.empty() && !sameLetters(status.axis.name, plan.axis))
        return notCaptured(AXISCOMP_TEXT("Error",
            "the plan is for axis {planned}, and this is axis {axis}: choose the other axis, or "
            "make a plan for this one")
                               .with("planned", plan.axis)
                               .with("axis", status.axis.name));
    if (!status.axis.isHomed)
        return fail(ErrorCode::NotHomed, {{"axis", axisShown(status.axis)}});
    return {};
}

tl::unexpected<Error> notSwitched(const AxisStatus& status, const std::string& state)
{
    return fail(ErrorCode::MeasurementState,
        {{"reason",
            AXISCOMP_TEXT("Error",
                "the compensation of axis {axis} is neither on nor off (the drive says {state}): "
                "activate or deactivate it first")
                .with("axis", axisShown(status.axis))
                .with("state", state)}});
}

/// "Axes[0]/.../MasterPosition from 0, 11 points every 10; ..."
std::string placeText(const AxisStatus& status)
{
    std::string text;
    for (std::size_t n = 0; status.table && n < status.table->grid.axes.size(); ++n) {
        const GridAxis& axis = status.table->grid.axes[n];
        text += (n == 0 ? "" : "; ") + status.setup.sources[n].path + " from " + toText(axis.start)
            + ", " + std::to_string(axis.size) + " points every " + toText(axis.distance);
    }
    return text;
}

/// What an axis does that is switched neither on nor off gives no deviations of either.
Result<void> checkSwitched(const AxisStatus& status)
{
    switch (status.axis.state) {
    case CompensationState::Disabled:
    case CompensationState::Evaluating:
    case CompensationState::Active:
        return {};
    default:
        return notSwitched(status, status.axis.stateWord);
    }
}

} // namespace

Result<AxisReadings> AxisReadings::open(DriveLink& link, const DriveProfile& profile,
    const AxisStatus& status, const MeasuringPlan& plan, CaptureRegisters registers,
    ReferenceScale scale, const Exchange& exchange)
{
    AXISCOMP_CHECK(checkAxisOf(status, plan));
    AXISCOMP_CHECK(checkSwitched(status));
    AxisReadings made(profile);
    made.m_registers = std::move(registers);
    made.m_scale = std::move(scale);
    AXISCOMP_CHECK(made.setUnits(status, plan));
    AXISCOMP_CHECK(made.checkReference(status));
    AXISCOMP_CHECK(made.checkEncoder(status));
    made.choosePaths(status);
    AXISCOMP_TRY(const auto readings, link.readRegisters(made.m_paths, exchange));
    made.m_state = made.stateOf(readings);
    made.m_place = made.placeIn(readings);
    if (made.m_state.starts_with("crc:"))
        made.m_tablePlace = placeText(status);
    // It may have changed since, and is what the file of the values says.
    if (made.m_state.starts_with("on, "))
        return fail(ErrorCode::MeasurementState,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "the compensation of axis {axis} is on, and the drive does not say with which "
                    "table: deactivate it first")
                    .with("axis", axisShown(status.axis))}});
    if (made.m_state != "off" && !made.m_state.starts_with("crc:"))
        return notSwitched(status, made.m_state);
    for (const std::string& path : {made.m_registers.encoder, made.m_registers.reference}) {
        const auto reading = std::ranges::find(readings, path, &RegisterReading::path);
        if (reading == readings.end())
            continue;
        if (std::holds_alternative<std::string>(reading->value)
            || std::holds_alternative<bool>(reading->value))
            return notCaptured(AXISCOMP_TEXT(
                "Error", "the register {path} is of type {type}, which is no position")
                                   .with("path", path)
                                   .with("type", reading->type));
        made.m_isSingle =
            path == made.m_registers.reference && std::holds_alternative<float>(reading->value);
    }
    if (made.m_tablePlace.empty())
        made.dropPlacePaths();
    return made;
}

Result<void> AxisReadings::setUnits(const AxisStatus& status, const MeasuringPlan& plan)
{
    const std::string wanted = unitOfPlan(plan);
    const std::string unit = unitSymbol(status.axis.unit);
    m_isUnitAssumed = unit.empty();
    const auto factor = unitFactor(m_isUnitAssumed ? wanted : unit, wanted);
    if (!factor)
        return notCaptured(
            AXISCOMP_TEXT("Error",
                "the plan is in {planned}, and axis {axis} of the drive in {unit}: make a plan in "
                "{needed}, or choose another axis")
                .with("planned", wanted)
                .with("axis", axisShown(status.axis))
                .with("unit", unit)
                .with("needed", std::string(unitFactor(unit, "deg") ? "deg" : "mm")));
    m_axisFactor = *factor;
    if (m_scale.unit.empty())
        m_scale.unit = m_isUnitAssumed ? wanted : unit;
    const auto reference = unitFactor(m_scale.unit, wanted);
    if (!reference)
        return notCaptured(AXISCOMP_TEXT("Error",
            "the instrument is in {unit}, which cannot be converted to {planned}, the unit of the "
            "plan: state the unit of the instrument")
                               .with("unit", m_scale.unit)
                               .with("planned", wanted));
    m_referenceFactor = *reference;
    return {};
}

/// An encoder that is measured with itself has no error.
Result<void> AxisReadings::checkReference(const AxisStatus& status) const
{
    if (m_registers.reference.empty())
        return {};
    const bool isOwn = m_registers.reference == m_registers.encoder
        || (m_profile->axisOfPosition(m_registers.reference) == status.axis.index
            && !m_profile->isBeforeCompensation(m_registers.reference));
    if (isOwn)
        return notCaptured(AXISCOMP_TEXT("Error",
            "{path} follows the encoder of the axis itself: name the register of an instrument")
                               .with("path", m_registers.reference));
    return {};
}

/// Behind the compensation the axis stands at its target whatever the table does: a table made of
/// such readings would hold what is left of the error only.
Result<void> AxisReadings::checkEncoder(const AxisStatus& status) const
{
    const std::string& path = m_registers.encoder;
    const auto axis = m_profile->axisOfPosition(path);
    // A profile that knows no raw position leaves it to the user to know one.
    if (!axis && m_profile->positionKinds.before.empty())
        return {};
    if (axis == status.axis.index && m_profile->isBeforeCompensation(path))
        return {};
    return notCaptured(AXISCOMP_TEXT("Error",
        "{path} is no position of axis {axis} before its compensation: name the register of its "
        "encoder")
                           .with("path", path)
                           .with("axis", axisShown(status.axis)));
}

void AxisReadings::addPlacePaths(const AxisStatus& status)
{
    const RegisterPaths& names = m_profile->registers;
    const std::size_t before = m_paths.size();
    for (int n = 0; n < status.table->grid.dimensions(); ++n) {
        m_paths.push_back(
            expandPath(names.source, {.axis = status.axis.index, .slot = {}, .n = n + 1}));
        for (const std::string& name : {names.tableSize, names.tableStart, names.tableDistance})
            m_paths.push_back(expandPath(name, {.axis = {}, .slot = m_slot, .n = n}));
    }
    m_placePaths = m_paths.size() - before;
}

/// A table that is switched on later ends the capture by its state.
void AxisReadings::dropPlacePaths()
{
    if (m_placePaths == 0)
        return;
    const auto first = m_paths.begin() + AtPlace;
    m_paths.erase(first, first + static_cast<std::ptrdiff_t>(m_placePaths));
    m_placePaths = 0;
}

std::vector<std::string> AxisReadings::placeIn(const std::vector<RegisterReading>& readings) const
{
    std::vector<std::string> place;
    for (std::size_t i = AtPlace; i < AtPlace + m_placePaths; ++i)
        place.push_back(toText(readings[i].value));
    return place;
}

void AxisReadings::choosePaths(const AxisStatus& status)
{
    const RegisterPaths& names = m_profile->registers;
    const auto path = [&](const std::string& pattern) {
        return expandPath(pattern, {.axis = status.axis.index, .slot = {}, .n = {}});
    };
    m_paths = {m_registers.encoder, path(names.output), path(names.state), path(names.homingState),
        path(names.table)};
    m_slot = status.table ? status.setup.slot : std::string();
    if (!m_slot.empty()) {
        m_paths.push_back(expandPath(names.tableCrc, {.axis = {}, .slot = m_slot, .n = {}}));
        addPlacePaths(status);
    }
    if (!m_registers.reference.empty())
        m_paths.push_back(m_registers.reference);
}

bool AxisReadings::isHomedIn(const std::vector<RegisterReading>& readings) const
{
    return toText(readings[AtHoming].value) == m_profile->enums.homingDone;
}

std::string AxisReadings::stateOf(const std::vector<RegisterReading>& readings) const
{
    if (!isHomedIn(readings))
        return toText(readings[AtHoming].value);
    const std::string word = toText(readings[AtState].value);
    switch (compensationState(m_profile->enums, word)) {
    case CompensationState::Disabled:
    case CompensationState::Evaluating:
        return measuredStateText({MeasuredState::Kind::Off});
    case CompensationState::Active: {
        const std::string table = toText(readings[AtTable].value);
        const double crc =
            !m_slot.empty() && table == m_slot ? toDouble(readings[AtCrc].value) : -1.0;
        if (!(crc >= 0.0 && crc <= std::numeric_limits<std::uint32_t>::max()))
            return "on, " + table;
        return measuredStateText({MeasuredState::Kind::On, static_cast<std::uint32_t>(crc)});
    }
    default:
        return word;
    }
}

Result<CaptureReading> AxisReadings::read(DriveLink& link, const Exchange& exchange) const
{
    AXISCOMP_TRY(const auto readings, link.readRegisters(m_paths, exchange));
    CaptureReading reading;
    reading.encoder = toDouble(readings[AtEncoder].value) * m_axisFactor;
    reading.output = toDouble(readings[AtOutput].value) * m_axisFactor;
    reading.state = stateOf(readings);
    reading.isHomed = isHomedIn(readings);
    reading.isSamePlace = m_tablePlace.empty() || placeIn(readings) == m_place;
    reading.reference = m_registers.reference.empty()
        ? std::numeric_limits<double>::quiet_NaN()
        : m_scale.position(toDouble(readings.back().value), m_referenceFactor);
    return reading;
}

std::optional<double> AxisReadings::resolutionAt(double position) const
{
    if (!m_isSingle)
        return std::nullopt;
    const auto number =
        static_cast<float>(std::abs((position - m_scale.zeroAt) / m_referenceFactor));
    const float next = std::nextafter(number, std::numeric_limits<float>::infinity());
    return (static_cast<double>(next) - static_cast<double>(number)) * m_referenceFactor;
}

std::string encoderRegister(
    const DriveProfile& profile, const std::vector<DimSource>& shortlist, int axis)
{
    const auto found = std::ranges::find_if(shortlist, [&](const DimSource& source) {
        return profile.axisOfPosition(source.path) == axis
            && profile.isBeforeCompensation(source.path);
    });
    return found == shortlist.end() ? std::string() : found->path;
}

std::string referenceText(const std::string& source, const ReferenceScale& scale)
{
    std::string text = source;
    if (!scale.unit.empty())
        text += " [" + scale.unit + "]";
    if (scale.isInverted)
        text += ", inverted";
    if (scale.zeroAt != 0.0)
        text += ", 0 at " + toText(scale.zeroAt);
    return text;
}

} // namespace axiscomp
