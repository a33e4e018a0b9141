// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/computer/serial_findings.h"

namespace axiscomp {

namespace {

Text hardwareOf(const SerialPortFacts& port)
{
    const Text description = port.description.empty()
        ? Text(AXISCOMP_TEXT("Doctor", "a port without a name"))
        : Verbatim{port.description};
    if (port.usbId.empty())
        return AXISCOMP_TEXT("Doctor", "{hardware}, built in").with("hardware", description);
    return AXISCOMP_TEXT("Doctor", "{hardware}, USB {id}")
        .with("hardware", description)
        .with("id", port.usbId);
}

/// An adapter was plugged in to be used; most built-in ports have nothing behind them.
Finding portFinding(const SerialPortFacts& port)
{
    const Text name = Verbatim{port.device};
    if (!port.access.obstacle)
        return {name, Grade::Ok, hardwareOf(port)};
    return {name, port.usbId.empty() ? Grade::Note : Grade::Problem,
        AXISCOMP_TEXT("Doctor", "{hardware}: {problem}")
            .with("hardware", hardwareOf(port))
            .with("problem", port.access.obstacle->found),
        port.access.obstacle->wayOut};
}

} // namespace

FindingSection serialFindings(const std::vector<SerialPortFacts>& ports)
{
    FindingSection section{AXISCOMP_TEXT("Doctor", "Serial ports"), {}};
    for (const SerialPortFacts& port : ports)
        section.findings.push_back(portFinding(port));
    if (ports.empty())
        section.findings.push_back({AXISCOMP_TEXT("Doctor", "ports"), Grade::Ok,
            AXISCOMP_TEXT("Doctor", "this computer has none")});
    return section;
}

} // namespace axiscomp
