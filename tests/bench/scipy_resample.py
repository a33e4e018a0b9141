#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""scipy on the plane of tests/bench/bench_conversion.cpp.

500 x 500 points onto 1000 x 1000. Needs python3-scipy.
"""

import time

import numpy
from scipy.interpolate import RectBivariateSpline, RegularGridInterpolator


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
    linear = best(lambda: RegularGridInterpolator((knots, knots), values, method="linear")(grid))
    print(f"RegularGridInterpolator, linear: {linear:.1f} ms")
    # RegularGridInterpolator's own cubic takes minutes for as many places.
    cubic = best(lambda: RectBivariateSpline(knots, knots, values)(places, places))
    print(f"RectBivariateSpline, cubic: {cubic:.1f} ms")


if __name__ == "__main__":
    main()
