#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Scattered points on small grids by dense matrices, for tests/core/metrology/fit.

    grid_reference.py make > grid_reference.json    needs python3-numpy
    grid_reference.py check grid_reference.json     the stored nodes, computed anew from the stored points; exit code 77
                                                    where numpy is not installed
"""
import itertools
import json
import sys

try:
    import numpy as np
except ImportError:
    print("python3-numpy is not installed")
    sys.exit(77)


def index(sizes, place):
    """Dimension 1 is the fastest."""
    number, stride = 0, 1
    for size, p in zip(sizes, place):
        number += p * stride
        stride *= size
    return number


def differences(sizes, distances):
    d = len(sizes)
    h = float(np.prod(distances)) ** (1 / d)
    rows = []
    for place in itertools.product(*[range(s) for s in sizes]):
        def at(*steps):
            moved = list(place)
            for axis, step in steps:
                moved[axis] += step
            return index(sizes, moved) if all(0 <= p < s for p, s in zip(moved, sizes)) else None
        for a in range(d):
            if at((a, -1)) is not None and at((a, 1)) is not None:
                row = np.zeros(int(np.prod(sizes)))
                row[at((a, -1))], row[at()], row[at((a, 1))] = 1, -2, 1
                rows.append(row * (h / distances[a]) ** 2)
            for b in range(a):
                if at((a, 1)) is not None and at((b, 1)) is not None:
                    row = np.zeros(int(np.prod(sizes)))
                    row[at()], row[at((a, 1), (b, 1))], row[at((a, 1))], row[at((b, 1))] = 1, 1, -1, -1
                    rows.append(row * np.sqrt(2) * h * h / (distances[a] * distances[b]))
    return np.array(rows)


def weights(case):
    sizes = case["sizes"]
    rows = []
    for point in zip(*case["coordinates"]):
        cells, shares = [], []
        for p, start, distance, size in zip(point, case["starts"], case["distances"], sizes):
            number = (p - start) / distance
            cell = min(max(int(np.floor(number)), 0), size - 2)
            cells.append(cell)
            shares.append(number - cell)
        row = np.zeros(int(np.prod(sizes)))
        for corner in itertools.product((0, 1), repeat=len(sizes)):
            share = np.prod([s if far else 1 - s for far, s in zip(corner, shares)])
            row[index(sizes, [c + far for c, far in zip(cells, corner)])] += share
        rows.append(row)
    return np.array(rows)


def nodes(case):
    b, v, w = weights(case), np.array(case["values"]), np.array(case["weights"])
    d = differences(case["sizes"], case["distances"])
    penalty = case["smoothness"] * w.sum() / b.shape[1]
    return np.linalg.solve(b.T @ (w[:, None] * b) + penalty * d.T @ d, b.T @ (w * v)).tolist()


def inputs():
    rng = np.random.default_rng(5)

    def case(name, sizes, distances, count, smoothness):
        starts = [float(s) for s in rng.uniform(-50, 50, len(sizes))]
        coordinates = [rng.uniform(s, s + (n - 1) * h, count).tolist() for s, h, n in zip(starts, distances, sizes)]
        return {"name": name, "sizes": sizes, "distances": distances, "starts": starts, "coordinates": coordinates,
                "values": rng.normal(3, 1, count).tolist(), "weights": rng.integers(1, 4, count).astype(float).tolist(),
                "smoothness": smoothness}

    return [
        case("line", [9], [2.5], 40, 0.3),
        case("two nodes", [2], [2.5], 5, 0.3),
        case("three nodes", [3], [2.5], 9, 2.0),
        case("plane", [7, 6], [1.0, 1.0], 120, 1.5),
        case("flat cells", [5, 8], [10.0, 2.5], 120, 0.1),
        case("narrow plane", [2, 9], [3.0, 2.0], 60, 5.0),
        case("few points", [7, 7], [2.0, 2.0], 15, 0.05),
        case("space", [5, 4, 6], [1.0, 3.0, 2.0], 400, 0.7),
        case("narrow space", [2, 3, 4], [1.0, 1.0, 4.0], 100, 20.0),
    ]


def main():
    if sys.argv[1:] == ["make"]:
        given = inputs()
        json.dump({"inputs": given, "nodes": [nodes(c) for c in given]}, sys.stdout, indent=0)
        print()
    elif len(sys.argv) == 3 and sys.argv[1] == "check":
        with open(sys.argv[2]) as file:
            stored = json.load(file)
        wrong = [c["name"] for c, n in zip(stored["inputs"], stored["nodes"]) if not np.allclose(nodes(c), n, atol=1e-10)]
        if wrong or len(stored["nodes"]) != len(stored["inputs"]):
            sys.exit("computed anew, these differ: " + ", ".join(wrong))
        print(f"{len(stored['nodes'])} grids are the same")
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
