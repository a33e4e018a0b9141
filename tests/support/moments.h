// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

namespace axiscomp::test {

/// `./test --all` takes every case of the tests that try all moments; `./test` a part.
inline bool takesEveryMoment()
{
    return qEnvironmentVariableIsSet("AXISCOMP_EVERY_MOMENT");
}

/// One case in so many; number counts moments and what happens then, so that all of both have their
/// turn.
inline bool hasTurn(int number, int oneIn)
{
    return takesEveryMoment() || number % oneIn == 0;
}

} // namespace axiscomp::test
