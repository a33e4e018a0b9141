// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/machine/open_metrics.h"

#include "core/compensator/axis_compensator.h"
#include "core/table/position_unit.h"
#include "core/text/number_text.h"
#include "core/text/utf8.h"

#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

namespace axiscomp {

namespace {

using Labels = std::vector<std::pair<std::string_view, std::string>>;

constexpr std::array states{
    std::pair{CompensationState::Disabled, std::string_view("Disabled")},
    std::pair{CompensationState::Evaluating, std::string_view("Evaluating")},
    std::pair{CompensationState::Ramping, std::string_view("Ramping")},
    std::pair{CompensationState::Active, std::string_view("Active")},
    std::pair{CompensationState::Error, std::string_view("Error")},
    std::pair{CompensationState::Unknown, std::string_view("Unknown")},
};

/// What comes from a drive may be any bytes.
std::string labelText(std::string_view text)
{
    std::string result;
    for (const char c : cleanText(text)) {
        if (c == '"' || c == '\\')
            result += '\\';
        result += c;
    }
    return result;
}

std::string numberText(double value)
{
    if (std::isnan(value))
        return "NaN";
    if (std::isinf(value))
        return value > 0 ? "+Inf" : "-Inf";
    return shortestText(value);
}

/// All samples of one metric stand together.
class Family {
public:
    Family(std::string_view name, std::string_view help) : m_name(name)
    {
        m_text.append("# TYPE ").append(name).append(" gauge\n");
        m_text.append("# HELP ").append(name).append(" ").append(help).append("\n");
    }
    void add(const Labels& labels, double value)
    {
        m_isEmpty = false;
        m_text.append(m_name).append("{");
        for (std::size_t n = 0; n < labels.size(); ++n)
            m_text.append(n == 0 ? "" : ",")
                .append(labels[n].first)
                .append("=\"")
                .append(labelText(labels[n].second))
                .append("\"");
        m_text.append("} ").append(numberText(value)).append("\n");
    }
    /// Nothing where there are no samples.
    [[nodiscard]] std::string text() const { return m_isEmpty ? std::string() : m_text; }

private:
    std::string_view m_name;
    std::string m_text;
    bool m_isEmpty = true;
};

double seconds(WallTime time)
{
    return std::chrono::duration<double>(time.time_since_epoch()).count();
}

class Metrics {
public:
    void add(const DriveMetrics& drive);
    [[nodiscard]] std::string text() const;

private:
    void addFlash(const Labels& labels, const FlashUse& use);
    void addAxis(const Labels& labels, const AxisSummary& row);
    void addStatus(const Labels& labels, const AxisStatus& status);
    void addProof(const Labels& labels, const Result<Proof>& proof);
    void addComparison(const Labels& labels, std::optional<bool> differs);

    Family m_up{"axiscomp_drive_up",
        "1: the drive answered, and is the one of the machine file, if there is one."};
    Family m_axes{"axiscomp_drive_axes", "Axes of the drive."};
    Family m_flashLeft{"axiscomp_flash_operations_left", "Flash operations that are possible now."};
    Family m_flashCycles{
        "axiscomp_flash_slot_cycles", "Flash cycles of the slot that is used most."};
    Family m_readable{"axiscomp_axis_readable", "1: the axis could be read."};
    Family m_state{"axiscomp_axis_state", "State of the compensation: 1 for the one that holds."};
    Family m_output{"axiscomp_axis_output",
        "What is added to the encoder position now, in the unit of the label."};
    Family m_homed{"axiscomp_axis_homed", "1: the axis is homed."};
    Family m_fault{"axiscomp_axis_fault", "1: the compensation reports an error."};
    Family m_table{"axiscomp_axis_table", "1: the axis has a table."};
    Family m_persistent{"axiscomp_axis_table_persistent", "1: the table is stored in flash."};
    Family m_crc{"axiscomp_axis_table_crc", "CRC-32 of the values of the table."};
    Family m_unfinished{"axiscomp_axis_unfinished_write", "1: a write did not end."};
    Family m_lastWrite{
        "axiscomp_axis_last_write_timestamp_seconds", "When this computer last wrote to the axis."};
    Family m_differs{"axiscomp_axis_differs",
        "1: the axis differs from the machine file, or cannot be compared with it."};
    Family m_comparable{
        "axiscomp_axis_comparable", "1: the axis could be compared with the machine file."};
    Family m_proved{
        "axiscomp_axis_proof_passed", "1: the output was compared with the table and is right."};
    Family m_provedShare{"axiscomp_axis_proof_share", "Share of the table that was seen, 0 to 1."};
    Family m_difference{"axiscomp_axis_proof_largest_difference",
        "Largest difference of output and table, in the unit of the axis."};
};

void Metrics::addFlash(const Labels& labels, const FlashUse& use)
{
    if (use.budget.left != std::numeric_limits<int>::max())
        m_flashLeft.add(labels, use.budget.left);
    if (use.mostUsedSlot.empty())
        return;
    Labels ofSlot = labels;
    ofSlot.emplace_back("slot", use.mostUsedSlot);
    m_flashCycles.add(ofSlot, use.mostCycles);
}

void Metrics::addStatus(const Labels& labels, const AxisStatus& status)
{
    for (const auto& [state, word] : states) {
        Labels ofState = labels;
        ofState.emplace_back("state", word);
        m_state.add(ofState, state == status.axis.state ? 1 : 0);
    }
    Labels withUnit = labels;
    withUnit.emplace_back("unit", unitSymbol(status.axis.unit));
    m_output.add(withUnit, status.output);
    m_homed.add(labels, status.axis.isHomed ? 1 : 0);
    m_fault.add(labels, status.fault == CompensationFault::None ? 0 : 1);
    m_table.add(labels, status.table ? 1 : 0);
    if (status.table) {
        m_persistent.add(labels, status.table->persistent ? 1 : 0);
        m_crc.add(labels, status.table->crc);
    }
    m_unfinished.add(labels, status.unfinishedWrite ? 1 : 0);
}

void Metrics::addProof(const Labels& labels, const Result<Proof>& proof)
{
    m_proved.add(labels, proof && proof->extent == Proof::Extent::Proved ? 1 : 0);
    if (!proof)
        return;
    m_provedShare.add(labels, proof->provedShare);
    m_difference.add(labels, proof->largestDifference);
}

/// Whoever watches for differences must also hear of an axis of which nobody knows.
void Metrics::addComparison(const Labels& labels, std::optional<bool> differs)
{
    m_differs.add(labels, differs.value_or(true) ? 1 : 0);
    m_comparable.add(labels, differs ? 1 : 0);
}

void Metrics::addAxis(const Labels& labels, const AxisSummary& row)
{
    if (!row.status && !row.problem)
        return; // it has no compensation
    m_readable.add(labels, row.status ? 1 : 0);
    if (row.status)
        addStatus(labels, *row.status);
    if (row.lastWrite)
        m_lastWrite.add(labels, seconds(*row.lastWrite));
}

void Metrics::add(const DriveMetrics& drive)
{
    const Labels place{{"endpoint", drive.endpoint}};
    m_up.add(place, drive.summary ? 1 : 0);
    if (!drive.summary)
        return;
    const DriveIdentity& identity = drive.summary->drive;
    Labels labels = place;
    labels.emplace_back("drive", identity.name);
    labels.emplace_back("serial", std::to_string(identity.serialNumber));
    m_axes.add(labels, identity.axes);
    if (drive.summary->flashUse)
        addFlash(labels, *drive.summary->flashUse);
    for (const AxisSummary& row : drive.summary->axes) {
        Labels ofAxis = labels;
        ofAxis.emplace_back("axis", std::to_string(row.axis.index));
        ofAxis.emplace_back("name", row.axis.name);
        addAxis(ofAxis, row);
        if (const auto known = drive.differs.find(row.axis.index); known != drive.differs.end())
            addComparison(ofAxis, known->second);
        if (const auto proof = drive.proofs.find(row.axis.index); proof != drive.proofs.end())
            addProof(ofAxis, proof->second);
    }
    for (const std::string& name : drive.unfoundAxes) {
        Labels ofAxis = labels;
        ofAxis.emplace_back("name", name);
        addComparison(ofAxis, std::nullopt);
    }
}

std::string Metrics::text() const
{
    std::string text;
    for (const Family* family :
        {&m_up, &m_axes, &m_flashLeft, &m_flashCycles, &m_readable, &m_state, &m_output, &m_homed,
            &m_fault, &m_table, &m_persistent, &m_crc, &m_unfinished, &m_lastWrite, &m_differs,
            &m_comparable, &m_proved, &m_provedShare, &m_difference})
        text += family->text();
    return text + "# EOF\n";
}

} // namespace

void addComparison(const DrivePlan& plan, DriveMetrics& metrics)
{
    for (const AxisPlan& axis : plan.axes) {
        if (axis.axis < 0)
            metrics.unfoundAxes.push_back(axis.name);
        else if (axis.problem)
            metrics.differs[axis.axis] = std::nullopt; // also where it is named a second time
        else
            metrics.differs.emplace(axis.axis, axis.differs());
    }
}

std::string openMetrics(std::span<const DriveMetrics> drives)
{
    Metrics metrics;
    for (const DriveMetrics& drive : drives)
        metrics.add(drive);
    return metrics.text();
}

} // namespace axiscomp
