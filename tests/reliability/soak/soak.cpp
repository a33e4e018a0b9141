// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reliability/soak/soak.h"

namespace axiscomp::test {

namespace {

constexpr std::size_t keptHistory = 20;

} // namespace

Soak::Soak(std::uint32_t seed, const std::vector<AttachmentKind>& attachments)
    : m_seed(seed)
    , m_choice(seed, attachments.size(), m_drive)
    , m_model(m_drive)
{
    for (const AttachmentKind& kind : attachments)
        m_programs.push_back(std::make_unique<SoakProgram>(
            kind, m_drive.drive(), m_drive.store(), [this] { return m_drive.now(); }));
    m_before = look();
}

Moment Soak::look()
{
    Moment moment{m_drive.picture(), m_drive.pictureAfterReboot()};
    return moment;
}

std::string Soak::run(int operations)
{
    while (m_done < operations) {
        const auto problems = m_choice.isGroupNext() ? group() : single();
        if (problems.empty())
            continue;
        std::string text =
            "seed " + std::to_string(m_seed) + ", operation " + std::to_string(m_done) + ":\n";
        for (const std::string& problem : problems)
            text += "  " + problem + "\n";
        text += "the last operations:\n";
        for (const std::string& line : m_history)
            text += "  " + line + "\n";
        return text;
    }
    return {};
}

Ending Soak::perform(const Operation& operation)
{
    switch (operation.action) {
    case Action::Reboot:
        m_drive.drive().reboot();
        return {};
    case Action::Home:
        m_drive.home();
        return {};
    case Action::PassTime:
        m_drive.pass(operation.time);
        return {};
    default:
        break;
    }
    SoakProgram& program = *m_programs[operation.program];
    program.start(operation);
    return program.finish();
}

std::vector<std::string> Soak::single()
{
    const Operation operation = m_choice.next(m_before.now);
    const Ending ending = perform(operation);
    m_drive.forgetWrongStore();
    note(operation, ending);
    const Moment after = look();
    auto problems = m_model.check(operation, ending, m_before, after);
    if (ending.backup)
        m_choice.remember(*ending.backup);
    m_before = after;
    return problems;
}

std::vector<std::string> Soak::group()
{
    const std::vector<Operation> operations = m_choice.nextGroup(m_before.now);
    for (const Operation& operation : operations)
        m_programs[operation.program]->start(operation);
    std::vector<Ending> endings;
    for (const Operation& operation : operations)
        endings.push_back(m_programs[operation.program]->finish());
    for (std::size_t i = 0; i < operations.size(); ++i)
        note(operations[i], endings[i]);
    m_counts.addGroup();
    const Moment after = look();
    auto problems = m_model.check(operations, endings, m_before, after);
    m_before = after;
    return problems;
}

void Soak::note(const Operation& operation, const Ending& ending)
{
    ++m_done;
    m_counts.add(operation, ending);
    m_history.push_back(std::to_string(m_done) + ". " + operation.text() + " -> " + ending.text());
    if (m_history.size() > keptHistory)
        m_history.pop_front();
}

} // namespace axiscomp::test
