// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/reliability/faultmatrix/write_trial.h"

#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace axiscomp::test {

/// Something that goes wrong at one step of a write.
struct MatrixFault {
    enum class Step {
        Exchange, ///< of the program with the drive, over any attachment
        Request, ///< on the wire, as the drive sees it
        WriteRequest, ///< of these, one that changes something
    };
    const char* name;
    Step step;
    FaultTraits traits;
    /// at counts from 1.
    std::function<void(WriteTrial& trial, int at)> arm;
};
[[nodiscard]] std::span<const MatrixFault> exchangeFaults();
/// By the virtual drive's own fault plan.
[[nodiscard]] std::span<const MatrixFault> wireFaults();
/// The connection ends after so many bytes of one exchange.
[[nodiscard]] MatrixFault cutIn(int exchange);

/// The last exchange of a write is refused, so that everything is put back, and while that goes on
/// something else goes wrong.
[[nodiscard]] MatrixFault whilePuttingBack(LinkFault fault, int exchanges);

/// How long the program waits for an answer: shorter than anybody would want, because most faults
/// are waited for.
[[nodiscard]] std::chrono::milliseconds shortTimeout(const AttachmentKind& kind);

/// A write with this fault at this step, and what must be true afterwards. Gives what is wrong.
[[nodiscard]] std::string runCase(const WriteScenario& scenario, const AttachmentKind& kind,
    const HeldStates& states, const MatrixFault& fault, int at, const Aftermath& aftermath,
    std::uint32_t points = 6);

struct MatrixCase {
    std::string name;
    std::function<std::string()> run; ///< gives what is wrong
};
/// Runs cases on several threads, because most of their time is waiting. Gives what is wrong, with
/// the names of the cases.
[[nodiscard]] std::vector<std::string> runCases(std::span<const MatrixCase> cases, int threads);

/// Which cases run: all of them, or a seeded part in which every scenario, fault, attachment and
/// step is met.
class MatrixChoice {
public:
    /// AXISCOMP_FAULT_MATRIX=all; AXISCOMP_FAULT_SEED=N chooses another part.
    [[nodiscard]] static MatrixChoice ofEnvironment();
    [[nodiscard]] bool isAll() const { return m_isAll; }
    [[nodiscard]] std::size_t seed() const { return m_seed; }
    /// One in so many; number follows from the case.
    [[nodiscard]] bool has(std::size_t number, std::size_t oneIn) const
    {
        return m_isAll || (number + m_seed) % oneIn == 0;
    }

private:
    bool m_isAll = false;
    std::size_t m_seed = 0;
};

/// Cases by fault and attachment.
class MatrixTable {
public:
    void add(const std::string& fault, const std::string& attachment, std::size_t cases);
    [[nodiscard]] std::size_t total() const;
    /// For docs/reliability.md
    [[nodiscard]] std::string markdown(std::span<const std::string> attachments) const;

private:
    std::vector<std::string> m_faults; ///< in the order in which they came
    std::map<std::pair<std::string, std::string>, std::size_t> m_cases;
};

} // namespace axiscomp::test
