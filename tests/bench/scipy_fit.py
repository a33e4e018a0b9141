#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits of scattered points and curves beside scipy: scipy_fit.py PATH/bench_fit

Both make points of the same field and noise; the time is that of the processor, the error the rms against the field on
the grid. scipy's griddata leaves holes, which do not count. Prints a table of docs/performance.md.
"""
import json
import subprocess
import sys
import time

NAMES = {
    "scatteredPoints/2/100000/200/0": "1e5 points to 200 x 200, smoothness given",
    "scatteredPoints/2/100000/200/1": "the same, smoothness searched for",
    "scatteredPoints/2/1000000/200/1": "1e6 points to 200 x 200, smoothness searched for",
    "scatteredPoints/3/100000/80/1": "1e5 points to 80 x 80 x 80, smoothness searched for",
    "scatteredPoints/3/1000000/80/0": "1e6 points to 80 x 80 x 80, smoothness given",
    "scatteredPoints/3/1000000/80/1": "the same, smoothness searched for",
    "automaticSmoothingSpline/81": "automatic smoothing spline, 81 points",
    "automaticSmoothingSpline/10000": "1e4 points",
    "automaticSmoothingSpline/100000": "1e5 points",
}


def field(np, x, y, z):
    turn = 2 * np.pi / 100
    return (5 * np.sin(0.9 * turn * x + 0.4) * np.cos(0.8 * turn * y) + 3.5 * np.sin(turn * (0.9 * y + 0.7 * z) + 1)
            + 2 * np.cos(turn * (1.4 * x - z)) + 6 * x * y / 1e4)


def row(name, seconds, error, holes=0):
    print(f"| {name} | {seconds:.3g} s | {error:.3f} um" + (f", {holes} holes |" if holes else " |"))


def timed(name, job):
    begin = time.process_time()
    error, holes = job()
    row(f"scipy: {name}", time.process_time() - begin, error, holes)


def compare_scipy():
    import numpy as np
    from scipy.interpolate import LSQBivariateSpline, griddata, make_smoothing_spline
    rng = np.random.default_rng(5)

    def scatter(dimensions, count):
        p = rng.uniform(0, 100, (count, dimensions))
        return p, field(np, p[:, 0], p[:, 1], p[:, 2] if dimensions == 3 else 0) + rng.normal(0, 0.5, count)

    def linear(dimensions, count, size):
        def job():
            axis = np.linspace(0, 100, size)
            mesh = np.meshgrid(*[axis] * dimensions, indexing="ij")
            p, v = scatter(dimensions, count)
            off = griddata(p, v, tuple(mesh)) - field(np, mesh[0], mesh[1], mesh[2] if dimensions == 3 else 0)
            return np.sqrt(np.nanmean(off ** 2)), int(np.isnan(off).sum())
        return job

    def spline(count, knots):
        def job():
            axis = np.linspace(0, 100, 200)
            p, v = scatter(2, count)
            inner = np.linspace(0, 100, knots + 2)[1:-1]
            fit = LSQBivariateSpline(p[:, 0], p[:, 1], v, inner, inner)
            x, y = np.meshgrid(axis, axis, indexing="ij")
            return np.sqrt(np.mean((fit(axis, axis) - field(np, x, y, 0)) ** 2)), 0
        return job

    def curve():
        x = np.linspace(0, 500, 10000)
        truth = 3 * np.sin(2 * np.pi * x / 430 + 0.7) + 1.2 * np.sin(2 * np.pi * x / 97)
        return np.sqrt(np.mean((make_smoothing_spline(x, truth + rng.normal(0, 0.5, len(x)))(x) - truth) ** 2)), 0

    timed("griddata linear, 1e5 points to 200 x 200", linear(2, 100_000, 200))
    timed("LSQBivariateSpline with 20 knots, 1e5 points to 200 x 200", spline(100_000, 20))
    timed("griddata linear, 1e5 points to 80 x 80 x 80", linear(3, 100_000, 80))
    timed("make_smoothing_spline, 1e4 points", curve)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    print("| what | time | rms to the truth |\n|---|---|---|")
    out = subprocess.run([sys.argv[1], "--benchmark_format=json"], check=True, capture_output=True, text=True)
    for result in json.loads(out.stdout)["benchmarks"]:
        row(NAMES.get(result["name"], result["name"]), result["cpu_time"] / 1e3, result["rmsToTruth_um"])
    try:
        compare_scipy()
    except ImportError:
        print("\nscipy is not installed (Debian: python3-scipy): only bench_fit was measured")


if __name__ == "__main__":
    main()
