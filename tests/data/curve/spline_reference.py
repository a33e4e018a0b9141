#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves as scipy and dense matrices make them, for tests/core/curve.

    spline_reference.py make > spline_reference.json    needs python3-scipy
    spline_reference.py check spline_reference.json     the stored results, computed anew from the stored inputs;
                                                        exit code 77 where scipy is not installed
"""
import json
import sys

try:
    import numpy as np
    from scipy.interpolate import CubicSpline, PchipInterpolator, make_smoothing_spline
except ImportError:
    print("python3-scipy is not installed")
    sys.exit(77)


def differences(x, wrap):
    """Q (second differences) and R (Gram matrix of the hats) of Reinsch."""
    n = len(x)
    if wrap is None:
        h = np.diff(x)
        knots, before, behind = range(1, n - 1), lambda i: i - 1, lambda i: i + 1
    else:
        h = np.append(np.diff(x), x[0] + wrap - x[-1])
        knots, before, behind = range(n), lambda i: (i - 1) % n, lambda i: (i + 1) % n
    q, r = np.zeros((n, len(knots))), np.zeros((len(knots), len(knots)))
    for c, i in enumerate(knots):
        left, right = h[before(i)], h[i]
        q[before(i), c] += 1 / left
        q[i, c] -= 1 / left + 1 / right
        q[behind(i), c] += 1 / right
        r[c, c] += (left + right) / 3
        if wrap is not None or c + 1 < len(knots):
            d = (c + 1) % len(knots)
            r[c, d] += right / 6
            r[d, c] += right / 6
    return q, r


def design(x, periods, harmonics):
    return np.column_stack([f(2 * np.pi * k * x / p) for p in periods for k in range(1, harmonics + 1)
                            for f in (np.cos, np.sin)] or [np.zeros((len(x), 0))])


def smoothed(case):
    """Fitted values, trace, terms and score of the smoothing spline by dense matrices."""
    x, y, w = (np.array(case[k]) for k in ("x", "y", "w"))
    q, r = differences(x, case["wrap"])
    k = q @ np.linalg.solve(r, q.T)
    unit = w.sum() / np.trace(k)
    t = design(x, case["periods"], case["harmonics"])

    def solve(penalty):
        a = np.linalg.solve(np.diag(w) + penalty * k, np.diag(w))
        left = np.eye(len(x)) - a
        if t.shape[1]:
            s = t.T @ np.diag(w) @ left @ t
            b = np.linalg.solve(s, t.T @ np.diag(w) @ left)
            hat = a + left @ t @ b
        else:
            b, hat = np.zeros((0, len(x))), a
        res = y - hat @ y
        square = (w * res * res).sum()
        free = len(x) - 1.1 * np.trace(hat)
        score = len(x) * square / free ** 2 if free > 0 else np.inf
        variance = square / max(len(x) - np.trace(hat), 1)
        errors = np.sqrt(np.abs(np.diag(b @ np.diag(1 / w) @ b.T)) * variance)
        return hat @ y, np.trace(hat), b @ y, errors, score

    if case["smoothness"] is None:
        decades = np.linspace(-10, 10, 2001)
        scores = [solve(10 ** d * unit)[4] for d in decades]
        smoothness = 10 ** decades[int(np.argmin(scores))]
    else:
        smoothness = case["smoothness"]
    fitted, trace, terms, errors, score = solve(smoothness * unit)
    result = {"penalty": smoothness * unit, "bestSmoothness": smoothness, "fitted": fitted.tolist(),
              "trace": trace, "terms": terms.tolist(), "termErrors": errors.tolist(), "score": score ** 0.5 if np.isfinite(score) else None}
    if case["wrap"] is None and not case["periods"] and case["smoothness"] is not None:
        spline = make_smoothing_spline(x, y, w, lam=smoothness * unit)
        result["scipy"] = spline(np.array(case["at"])).tolist()
    return result


def through(case):
    x, y, at = (np.array(case[k]) for k in ("x", "y", "at"))
    if case["wrap"] is None:
        return {"spline": CubicSpline(x, y, bc_type="natural")(at).tolist(),
                "monotone": PchipInterpolator(x, y)(at).tolist()}
    return {"spline": CubicSpline(np.append(x, x[0] + case["wrap"]), np.append(y, y[0]),
                                  bc_type="periodic")(at).tolist()}


def results(inputs):
    return [through(c) if c["kind"] == "through" else smoothed(c) for c in inputs]


def inputs():
    rng = np.random.default_rng(7)

    def case(kind, name, x, wrap=None, noise=0.0, **more):
        x = np.asarray(x, float)
        span = wrap if wrap else x[-1] - x[0]
        y = 8 * np.sin(2 * np.pi * x / span) + 3 * np.cos(6 * np.pi * x / span + 0.4)
        for p in more.get("periods", []):
            y = y + 1.5 * np.sin(2 * np.pi * x / p + 0.3)
        y = y + rng.normal(0, noise, len(x)) if noise else y + rng.uniform(-1, 1, len(x))
        end = x[0] + wrap if wrap else x[-1]
        at = np.sort(rng.uniform(x[0], end, 40))
        base = {"kind": kind, "name": name, "x": x.tolist(), "y": y.tolist(), "wrap": wrap, "at": at.tolist(),
                "w": np.ones(len(x)).tolist(), "periods": [], "harmonics": 1, "smoothness": None}
        base.update(more)
        return base

    def uneven(n, start, step):
        return start + step * (np.arange(n) + rng.uniform(-0.3, 0.3, n))

    def counts(n):
        return rng.integers(1, 6, n).astype(float).tolist()

    return [
        case("through", "two knots", [1.0, 4.0]),
        case("through", "three knots", [-1.0, 0.5, 4.0]),
        case("through", "even", np.linspace(-20, 20, 9)),
        case("through", "uneven", uneven(31, 100.0, 16.0)),
        case("through", "ring of three", [0.0, 100.0, 230.0], wrap=360.0),
        case("through", "ring", uneven(12, 5.0, 28.0), wrap=360.0),
        case("smooth", "stiff", uneven(31, 100.0, 16.0), noise=0.5, w=counts(31), smoothness=30.0),
        case("smooth", "soft", uneven(31, 0.1, 0.016), noise=0.5, w=counts(31), smoothness=0.02),
        case("smooth", "eight knots", uneven(8, 0.0, 10.0), noise=0.5, smoothness=1.0),
        case("smooth", "ring", uneven(24, 3.0, 14.0), wrap=360.0, noise=0.5, w=counts(24), smoothness=2.0),
        case("smooth", "ring of eight", uneven(8, 3.0, 44.0), wrap=360.0, noise=0.5, w=counts(8), smoothness=0.3),
        case("smooth", "period", uneven(51, 0.0, 10.0), noise=0.3, w=counts(51), periods=[10.0], smoothness=50.0),
        case("smooth", "two periods", uneven(81, 0.0, 6.1), noise=0.3, w=counts(81), periods=[10.0, 3.7], harmonics=2,
             smoothness=20.0),
        case("smooth", "automatic", uneven(81, 0.0, 6.1), noise=0.5),
        case("smooth", "automatic ring", uneven(36, 0.0, 9.7), wrap=360.0, noise=0.5, w=counts(36)),
        case("smooth", "automatic period", uneven(81, 0.0, 6.1), noise=0.5, periods=[10.0]),
    ]


def same(a, b):
    if isinstance(a, dict):
        return a.keys() == b.keys() and all(same(a[k], b[k]) for k in a)
    if a is None or b is None:
        return a is b
    return np.allclose(a, b, rtol=1e-9, atol=1e-11)


def main():
    if sys.argv[1:] == ["make"]:
        given = inputs()
        json.dump({"inputs": given, "results": results(given)}, sys.stdout, indent=0)
        print()
    elif len(sys.argv) == 3 and sys.argv[1] == "check":
        with open(sys.argv[2]) as file:
            stored = json.load(file)
        made = results(stored["inputs"])
        wrong = [c["name"] for c, a, b in zip(stored["inputs"], stored["results"], made) if not same(a, b)]
        if wrong or len(made) != len(stored["results"]):
            sys.exit("computed anew, these differ: " + ", ".join(wrong))
        print(f"{len(made)} curves are the same")
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
