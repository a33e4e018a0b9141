// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <stop_token>
#include <string>

namespace axiscomp {

/// How far an operation is: a step in words and a fraction of the whole.
struct Progress {
    std::string step; ///< "verify": an id, translated by the window
    double fraction = 0.0;
};

struct OperationOptions {
    std::chrono::milliseconds timeout{5000}; ///< of each exchange
    std::stop_token stop;
    std::function<void(const Progress&)> progress;
};

} // namespace axiscomp
