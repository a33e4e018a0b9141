// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reliability/soak/soak_program.h"

#include "drivecomm/profile/profile_loader.h"

namespace axiscomp::test {

/// What dies with a program.
struct SoakProgram::Instance {
    explicit Instance(SoakProgram& program)
        : attachment(program.m_kind.attach(program.m_drive, faults))
        , link(program.m_drive, attachment->link())
        , store(program.m_store)
        , compensator(link, drivecomm::genericProfile(), store, program.m_clock)
    {
    }

    drivecomm::FaultPlan faults;
    std::unique_ptr<LinkAttachment> attachment;
    FaultyLink link;
    DriveStore store;
    AxisCompensator compensator;
};

SoakProgram::SoakProgram(const AttachmentKind& kind, drivecomm::VirtualDrive& drive,
    std::filesystem::path store, std::function<WallTime()> clock)
    : m_kind(kind)
    , m_drive(drive)
    , m_store(std::move(store))
    , m_clock(std::move(clock))
    , m_thread([this] { run(); })
{
}

SoakProgram::~SoakProgram()
{
    {
        const std::scoped_lock lock(m_mutex);
        m_isEnding = true;
    }
    m_changed.notify_all();
    m_thread.join();
}

void SoakProgram::start(const Operation& operation)
{
    {
        const std::scoped_lock lock(m_mutex);
        m_operation = &operation;
    }
    m_changed.notify_all();
}

Ending SoakProgram::finish()
{
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [this] { return m_ending.has_value(); });
    return *std::exchange(m_ending, std::nullopt);
}

void SoakProgram::run()
{
    // A link is used on the thread that made it.
    std::unique_ptr<Instance> instance;
    std::unique_lock lock(m_mutex);
    while (true) {
        m_changed.wait(lock, [this] { return m_operation || m_isEnding; });
        if (m_isEnding)
            return;
        const Operation& operation = *std::exchange(m_operation, nullptr);
        lock.unlock();
        Ending ending = perform(operation, instance);
        lock.lock();
        m_ending = std::move(ending);
        m_changed.notify_all();
    }
}

Ending SoakProgram::perform(const Operation& operation, std::unique_ptr<Instance>& instance)
{
    if (!instance)
        instance = std::make_unique<Instance>(*this);
    std::stop_source stop;
    OperationOptions options;
    options.stop = stop.get_token();
    instance->link.stopUser = [&stop] { stop.request_stop(); };
    const auto& mishap = operation.mishap;
    if (mishap && mishap->fault)
        instance->link.failAt(mishap->exchange, *mishap->fault);
    if (mishap && mishap->onTheWire)
        instance->faults.add(*mishap->onTheWire);

    Ending ending;
    try {
        carryOut(operation, instance->compensator, options, ending);
    } catch (const ProgramDied&) {
        ending.hasDied = true;
    }
    ending.hasStruck = instance->link.hasFailed() || (mishap && mishap->onTheWire);
    instance->link.heal();
    instance->faults.clear();
    if (ending.hasDied)
        instance.reset();
    return ending;
}

} // namespace axiscomp::test
