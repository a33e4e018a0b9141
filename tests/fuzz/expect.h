// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <cstdlib>

/// Ends a fuzzer with a finding when a property does not hold; unlike assert, in every build.
#define FUZZ_EXPECT(property)                                                                      \
    do {                                                                                           \
        if (!(property)) {                                                                         \
            std::fprintf(stderr, "%s:%d: does not hold: %s\n", __FILE__, __LINE__, #property);     \
            std::abort();                                                                          \
        }                                                                                          \
    } while (false)
