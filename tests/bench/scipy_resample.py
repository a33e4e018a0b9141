#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""scipy's RegularGridInterpolator on the plane of tests/bench/bench_conversion.cpp.

500 x 500 points onto 1000 x 1000. Needs python3-scipy.
"""

import time

import numpy
from scipy.interpolate import RegularGridInterpolator


def best(call, repeats=5):
    times = []
    for _ in range(repeats):
        begin = time.perf_counter()
        call()
        times.append(time.perf_counter() - begin)
    return 1e3 * min(times)


def main():
    knots = 0.5 * numpy.arange(500)
    values = 0.003 * numpy.outer(numpy.cos(0.013 * numpy.arange(500)),
                                 numpy.sin(0.01 * numpy.arange(500)))
    places = numpy.linspace(knots[0], knots[-1], 1000)
    grid = numpy.stack(numpy.meshgrid(places, places, indexing="ij"), axis=-1)
    for method in ("linear", "pchip", "cubic"):
        def resample(name=method):
            return RegularGridInterpolator((knots, knots), values, method=name)(grid)
        try:
            print(f"{method}: {best(resample, 5 if method == 'linear' else 1):.1f} ms")
        except ValueError as problem:
            print(f"{method}: {problem}")


if __name__ == "__main__":
    main()
