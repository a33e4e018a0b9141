// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reliability/faultmatrix/fault_matrix.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <mutex>
#include <thread>

namespace axiscomp::test {

namespace {

using namespace std::chrono_literals;
using drivecomm::FaultSpec;
using Step = MatrixFault::Step;

MatrixFault onExchange(const char* name, LinkFault fault, const FaultTraits& traits = {})
{
    return {name, Step::Exchange, traits,
        [fault](WriteTrial& trial, int at) { trial.link.failAt(at, fault); }};
}

MatrixFault onWire(
    const char* name, Step step, FaultSpec::Kind kind, const FaultTraits& traits = {})
{
    return {name, step, traits, [kind](WriteTrial& trial, int at) {
                trial.faults.add({kind, static_cast<std::uint64_t>(at), {}});
            }};
}

/// From one request on, until the next one or for good.
MatrixFault whileRequested(const char* name, FaultSpec fault, bool untilNext)
{
    return {
        name, Step::Request, {}, [fault = std::move(fault), untilNext](WriteTrial& trial, int at) {
            trial.requested = [&trial, fault, untilNext, at, request = 0](bool) mutable {
                ++request;
                trial.changeFaults([&](drivecomm::FaultPlan& faults) {
                    if (request == at)
                        faults.add(fault);
                    else if (untilNext && request == at + 1)
                        faults.clear();
                });
            };
        }};
}

} // namespace

std::span<const MatrixFault> exchangeFaults()
{
    static const std::array faults{
        onExchange("request lost", LinkFault::RequestLost),
        onExchange("reply lost", LinkFault::ReplyLost),
        onExchange("reply garbled", LinkFault::ReplyGarbled),
        onExchange("refused", LinkFault::Refused),
        onExchange("drive gone", LinkFault::DriveGone),
        onExchange("drive gone after the request", LinkFault::DriveGoneAfter),
        onExchange("drive reboots", LinkFault::Reboot, {.reboots = true}),
        onExchange("stores wrong", LinkFault::StoresWrong, {.losesCommands = true}),
        onExchange("carried out after the deadline", LinkFault::Late),
        onExchange("user stops", LinkFault::UserStops),
    };
    return faults;
}

std::span<const MatrixFault> wireFaults()
{
    using Kind = FaultSpec::Kind;
    static const std::array faults{
        onWire("wire: no reply", Step::Request, Kind::NoReply),
        onWire("wire: reply garbled", Step::Request, Kind::Garble),
        onWire("wire: drive reboots", Step::Request, Kind::RebootAfter, {.reboots = true}),
        onWire(
            "wire: stores wrong", Step::WriteRequest, Kind::StoresWrong, {.losesCommands = true}),
        whileRequested("wire: refused from here on",
            {Kind::Reject, 0, std::string(errorName(ErrorCode::DriveRejected))}, false),
        whileRequested("wire: reply after the deadline", {Kind::Slow, 2000, {}}, true),
        whileRequested("wire: connection cut", {Kind::DropAfter, 1, {}}, true),
    };
    return faults;
}

MatrixFault cutIn(int exchange)
{
    return {"connection cut", Step::Exchange, {}, [exchange](WriteTrial& trial, int at) {
                trial.link.beginning = [&trial, exchange, at, number = 0](
                                           std::string_view) mutable {
                    if (++number == exchange)
                        trial.faults.add(
                            {FaultSpec::Kind::DropAfter, static_cast<std::uint64_t>(at), {}});
                };
            }};
}

MatrixFault whilePuttingBack(LinkFault fault, int exchanges)
{
    return {
        "while putting back", Step::Exchange, {}, [fault, exchanges](WriteTrial& trial, int at) {
            trial.link.failAt(exchanges, LinkFault::Refused);
            trial.link.beginning = [&trial, fault, exchanges, at, number = 0](
                                       std::string_view) mutable {
                if (++number == exchanges + at)
                    trial.link.failAt(0, fault); // this one
            };
        }};
}

std::chrono::milliseconds shortTimeout(const AttachmentKind& kind)
{
    return kind.asksAgain ? 1500ms : 600ms; // a serial line takes a second to ask again
}

std::string runCase(const WriteScenario& scenario, const AttachmentKind& kind,
    const HeldStates& states, const MatrixFault& fault, int at, const Aftermath& aftermath,
    std::uint32_t points)
{
    WriteTrial trial(scenario, kind, points);
    if (!trial.unready().empty())
        return trial.unready();
    trial.options.timeout = shortTimeout(kind);
    fault.arm(trial, at);
    const auto report = trial.write();
    trial.heal();
    if (auto wrong = trial.judge(report, fault.traits, states); !wrong.empty())
        return wrong;
    return trial.judgeAftermath(report, fault.traits, states, aftermath);
}

std::vector<std::string> runCases(std::span<const MatrixCase> cases, int threads)
{
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::vector<std::string> wrong;
    {
        std::vector<std::jthread> workers;
        for (int n = 0; n < threads; ++n)
            workers.emplace_back([&] {
                for (std::size_t i = next++; i < cases.size(); i = next++) {
                    const std::string what = cases[i].run();
                    const std::scoped_lock lock(mutex);
                    if (!what.empty())
                        wrong.push_back(cases[i].name + ": " + what);
                }
            });
    }
    std::ranges::sort(wrong);
    return wrong;
}

MatrixChoice MatrixChoice::ofEnvironment()
{
    MatrixChoice choice;
    if (const char* part = std::getenv("AXISCOMP_FAULT_MATRIX"))
        choice.m_isAll = std::string_view(part) == "all";
    if (const char* seed = std::getenv("AXISCOMP_FAULT_SEED"))
        choice.m_seed = std::strtoul(seed, nullptr, 10);
    return choice;
}

void MatrixTable::add(const std::string& fault, const std::string& attachment, std::size_t cases)
{
    if (std::ranges::find(m_faults, fault) == m_faults.end())
        m_faults.push_back(fault);
    m_cases[{fault, attachment}] += cases;
}

std::size_t MatrixTable::total() const
{
    std::size_t sum = 0;
    for (const auto& [where, cases] : m_cases)
        sum += cases;
    return sum;
}

std::string MatrixTable::markdown(std::span<const std::string> attachments) const
{
    std::string head = "| fault |";
    std::string rule = "|---|";
    std::string sums = "| **all** |";
    std::string rows;
    for (const std::string& attachment : attachments) {
        head += " " + attachment + " |";
        rule += "---:|";
        std::size_t sum = 0;
        for (const std::string& fault : m_faults)
            if (const auto cases = m_cases.find({fault, attachment}); cases != m_cases.end())
                sum += cases->second;
        sums += " **" + std::to_string(sum) + "** |";
    }
    for (const std::string& fault : m_faults) {
        rows += "| " + fault + " |";
        for (const std::string& attachment : attachments) {
            const auto cases = m_cases.find({fault, attachment});
            rows += " " + (cases == m_cases.end() ? "" : std::to_string(cases->second)) + " |";
        }
        rows += "\n";
    }
    return head + "\n" + rule + "\n" + rows + sums + "\n";
}

} // namespace axiscomp::test
