#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Judges measurements by ISO 230-2 with none of the program's code.

    check_judgement.py FILE

FILE has a line of JSON for each measurement: its CSV and what the program says of it. The CSV is read here by
a few lines of its own; figures, outliers and drift are worked out anew and compared. Prints one line for each
difference, and fails if there is one.
"""

import json
import statistics
import sys
from collections import defaultdict

FACTOR = {"mm": 1.0, "um": 1e-3}


def read(text):
    """Values in use in mm: {direction: {target: {run: deviation}}}."""
    values = {"+": defaultdict(dict), "-": defaultdict(dict)}
    rows = [line.split(",") for line in text.splitlines() if line and not line.startswith("//")]
    unit = {name.split(" [")[0]: FACTOR.get(name.partition("[")[2].rstrip("]")) for name in rows[0]}
    names = [name.split(" [")[0] for name in rows[0]]
    for row in rows[1:]:
        cell = dict(zip(names, row))
        if cell.get("use", "1") != "0":
            target = float(cell["target"]) * unit["target"]
            values[cell["direction"]][target][int(cell["run"])] = float(cell["deviation"]) * unit["deviation"]
    return values


def spread(values):
    return statistics.stdev(values) if len(values) > 1 else None


def span(pairs):
    """Largest minus smallest; None when anything is missing."""
    if any(low is None or high is None for low, high in pairs):
        return None
    return max(high for _, high in pairs) - min(low for low, _ in pairs)


def figures(values):
    targets = sorted(set(values["+"]) | set(values["-"]))
    one = {}
    for sign in "+-":
        for t in targets:
            v = list(values[sign].get(t, {}).values())
            mean, s = (statistics.fmean(v) if v else None), spread(v)
            band = (None, None) if s is None else (mean - 2 * s, mean + 2 * s)
            one[sign, t] = {"mean": mean, "s": s, "band": band}
    result = {}
    for name, sign in (("Up", "+"), ("Down", "-")):
        means = [one[sign, t]["mean"] for t in targets]
        spreads = [one[sign, t]["s"] for t in targets]
        result["E" + name] = span([(m, m) for m in means])
        result["R" + name] = None if None in spreads else 4 * max(spreads)
        result["A" + name] = span([one[sign, t]["band"] for t in targets])
    both = [(one["+", t]["mean"], one["-", t]["mean"]) for t in targets]
    hasboth = all(None not in pair for pair in both)
    result["B"] = max(abs(u - d) for u, d in both) if hasboth else None
    result["Bmean"] = statistics.fmean(u - d for u, d in both) if hasboth else None
    result["M"] = span([((u + d) / 2, (u + d) / 2) for u, d in both]) if hasboth else None
    result["E"] = span([(m, m) for pair in both for m in pair]) if hasboth else None
    result["A"] = span([one[sign, t]["band"] for t in targets for sign in "+-"])
    bands = [(one["+", t]["s"], one["-", t]["s"], u, d) for t, (u, d) in zip(targets, both)]
    hasspread = hasboth and all(a is not None and b is not None for a, b, _, _ in bands)
    result["R"] = max(max(2 * a + 2 * b + abs(u - d), 4 * a, 4 * b) for a, b, u, d in bands) if hasspread else None
    return result


def outliers(groups):
    """One after the other; None when more than a fifth would go."""
    values = [(t, run, x) for t, runs in groups.items() for run, x in runs.items()]
    total, found = len(values), []
    while True:
        by = defaultdict(list)
        for t, _, x in values:
            by[t].append(x)
        score = [(abs(x - statistics.fmean(by[t])) * (len(by[t]) / (len(by[t]) - 1)) ** 0.5, t, run)
                 for t, run, x in values if len(by[t]) > 1]
        sigma = 1.4826 * statistics.median([s for s, _, _ in score]) if score else 0.0
        if not score or not sigma > 0.0:
            return found
        worst, t, run = max(score)
        if worst <= 4 * sigma or len(by[t]) <= 3:
            return found
        if 5 * (len(found) + 1) > total:
            return None
        found.append((t, run, worst / sigma))
        values = [v for v in values if v[:2] != (t, run)]


def first_to_last(groups):
    offsets = defaultdict(list)
    for runs in groups.values():
        mean = statistics.fmean(runs.values())
        for run, x in runs.items():
            offsets[run].append(x - mean)
    if len(offsets) < 2 or len(groups) < 2:
        return None
    return statistics.fmean(offsets[max(offsets)]) - statistics.fmean(offsets[min(offsets)])


def differ(a, b):
    return (a is None) != (b is None) or (a is not None and abs(a - b) > 1e-9 + 1e-9 * abs(a))


def check(case):
    values, said = read(case["csv"]), case["said"]
    faults = [f"{name}: {said['axis'][name]} instead of {value}"
              for name, value in figures(values).items() if differ(said["axis"][name], value)]
    for sign, name in (("+", "up"), ("-", "down")):
        drift, found = first_to_last(values[sign]), outliers(values[sign])
        if differ(said["firstToLast"][name], drift):
            faults.append(f"drift {name}: {said['firstToLast'][name]} instead of {drift}")
        flagged = [tuple(one) for one in said["flagged"][name]]
        if (found is None) != said["disturbed"][name]:
            faults.append(f"disturbed {name}: {said['disturbed'][name]}")
        elif [f[:2] for f in found or []] != [f[:2] for f in flagged]:
            faults.append(f"outliers {name}: {flagged} instead of {found}")
    return faults


def main():
    wrong = count = 0
    with open(sys.argv[1], encoding="utf-8") as file:
        for count, line in enumerate(file, 1):
            for fault in check(json.loads(line)):
                wrong += 1
                print(f"measurement {count}: {fault}")
    print(f"{count} measurements, {wrong} differences")
    return 1 if wrong or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
