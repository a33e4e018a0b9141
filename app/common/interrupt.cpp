// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/interrupt.h"

#include <utility>

namespace axiscomp::app {

Interrupt::Interrupt() : Interrupt(Signals::AreTaken) { }

void Interrupt::setListener(std::function<void(int count)> listener)
{
    const std::lock_guard lock(m_mutex);
    m_listener = std::move(listener);
}

void Interrupt::request()
{
    m_source.request_stop();
    wake();
    const std::lock_guard lock(m_mutex);
    ++m_requests;
    if (m_listener)
        m_listener(m_requests);
}

} // namespace axiscomp::app
