#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks conversions of tables between the formats of controllers, with none of the program's code.

    check_conversions.py FILE

FILE has a line of JSON for each conversion: the texts of both files, and what a person has to say of them.
Each text is read here by a few lines of its own. A table f, linear between its knots and held beyond them,
(KMotion's geometric correction goes on instead as in its first and last cells) becomes -f(z) in the other
convention, where z + f(z) is the knot; z is found by halving an interval. The
second file must hold that, to the rounding of its text.
"""

import csv
import json
import re
import sys
from bisect import bisect_right

UNITS = {"m": 1.0, "mm": 1e-3, "um": 1e-6, "nm": 1e-9, "inch": 0.0254, "deg": 1.0, "mdeg": 1e-3, "arcsec": 1 / 3600}
FEEDBACK = {"csv", "siemens-eec", "isg-ssfk", "power-pmac", "weihong", "heidenhain-com", "heidenhain-com-530"}
BOTH, POSITIVE, NEGATIVE = "both", "positive", "negative"


class Table:
    """Knots of each axis and values, the first axis fastest, in metres or degrees."""

    def __init__(self, axes, columns, step=0.0, relative=1e-11, wraps=False):
        self.axes, self.columns = axes, columns  # columns: by direction
        self.step, self.relative = step, relative  # rounding of the values
        self.period = axes[0][-1] - axes[0][0] if wraps else None
        self.position_step = 0.0
        self.goes_on = False  # beyond the knots


def spaced(start, step, count):
    return [start + i * step for i in range(count)]


def scaled(numbers, factor):
    return [number * factor for number in numbers]


def read_csv(side, case):
    lines = [line for line in side["text"].splitlines() if line and not line.startswith("//")]
    n = case["dimensions"]
    header, *cells = csv.reader(lines)
    units = [UNITS[re.findall(r"\[([^][]*)\]", name)[-1]] for name in header]
    rows = [[float(cell) * unit for cell, unit in zip(line, units)] for line in cells]
    axes = [sorted({row[k] for row in rows}) for k in range(n)]
    place = {tuple(row[:n]): row[n:] for row in rows}
    points = [[]]
    for axis in reversed(axes):
        points = [[x] + rest for rest in points for x in axis]
    values = [place[tuple(point)] for point in points]
    columns = {BOTH: [row[0] for row in values]}
    if len(values[0]) == 2:
        columns = {POSITIVE: [row[0] for row in values], NEGATIVE: [row[1] for row in values]}
    return Table(axes, columns, relative=1.2e-7)  # float32, and the shortest text that is read as the same


def metric(case):
    return UNITS["deg" if case["rotary"] else "mm"]


def read_acs_1d(side, case):
    text = side["text"]
    call = (re.search(r"ERRORMAP1D (\w+), \w+, (\S+), (\S+), (\w+)\n", text)
            or re.search(r"RPOS\((\w+)\) = APOS\(\1\) \+ MAP\(APOS\(\1\), ()()(\w+), (\S+), (\S+)\)\n", text))
    base, step = map(float, (call[2] or call[5], call[3] or call[6]))
    found = {int(i): float(v) for i, v in re.findall(r"^" + call[4] + r"\((\d+)\) = (\S+)$", text, re.M)}
    unit, _ = setting_units(side)
    return Table([scaled(spaced(base, step, len(found)), unit)],
                 {BOTH: [found[i] * unit for i in range(len(found))]})


def read_acs_2d(side, case):
    text = side["text"]
    call = re.search(r"RPOS\((\w+)\) = APOS\(\1\) \+ MAP2\(APOS\(1\), APOS\(2\), (\w+), "
                     r"(\S+), (\S+), (\S+), (\S+)\)\n", text)
    if call[1] != str(case["own"] + 1 if "own" in case else 9):
        raise ValueError("another axis")
    found = {(int(i), int(j)): float(v)
             for i, j, v in re.findall(r"^" + call[2] + r"\((\d+)\)\((\d+)\) = (\S+)$", text, re.M)}
    position, value = setting_units(side)
    rows, columns = (max(index[n] for index in found) + 1 for n in (0, 1))
    axes = [scaled(spaced(float(call[3]), float(call[4]), columns), position),
            scaled(spaced(float(call[5]), float(call[6]), rows), position)]
    return Table(axes, {BOTH: [found[i, j] * value for i in range(rows) for j in range(columns)]})


def aerotech(text):
    words = [re.split(r"[;']", line)[0].split() for line in text.splitlines()]
    heads = [line[1:] for line in words if line and line[0].startswith(":START")]
    options = dict(word.split("=") for head in heads for word in head if "=" in word)
    numbers = [word for word in heads[0] if "=" not in word]
    values = [float(word) for line in words if line and line[0][0] != ":" for word in line]
    return numbers, options, values


def read_aerotech_1d(side, case):
    _, options, values = aerotech(side["text"])
    unit = metric(case)
    knots = spaced(-float(options["OFFSET"]), float(options["SAMPLEDIST"]), len(values))
    return Table([scaled(knots, unit)], {BOTH: scaled(values, unit)})


def read_aerotech_2d(side, case):
    numbers, options, values = aerotech(side["text"])
    row, column, width = float(numbers[4]), float(numbers[5]), int(numbers[6])
    first, second = values[::2], values[1::2]
    if any(second):
        raise ValueError("the second output is not 0")
    x = spaced(-float(options["OFFSETCOL"]), column, width)
    y = spaced(-float(options["OFFSETROW"]), row, len(first) // width)
    unit = metric(case)
    return Table([scaled(x, unit), scaled(y, unit)], {BOTH: scaled(first, unit)})


def siemens(text, prefix):
    found = {}
    for name, indices, value in re.findall(re.escape(prefix) + r"(\w*)\[([^\]]*)\]=(\S+)", text):
        found[name, tuple(indices.split(","))] = value.strip("()")
    return found


def siemens_curve(found, values, key, case):
    unit = metric(case)
    low, high, step = (float(found[name, key]) for name in ("_MIN", "_MAX", "_STEP"))
    count = round((high - low) / step) + 1
    if sorted(values) != list(range(count)):
        raise ValueError("points are missing")
    knots = scaled(spaced(low, step, count), unit)
    return knots, [values[i] * unit for i in range(count)], found["_IS_MODULO", key] == "1"


def read_siemens_eec(side, case):
    found = siemens(side["text"], "$AA_ENC_COMP")
    values = {int(key[1]): float(value) for (name, key), value in found.items() if not name}
    knots, numbers, wraps = siemens_curve(found, values, ("0", "X1"), case)
    return Table([knots], {BOTH: numbers}, wraps=wraps)


def read_siemens_cec(side, case):
    found = siemens(side["text"], "$AN_CEC")
    columns = {}
    for index in sorted({key[0] for _, key in found}):
        if (found["_INPUT_AXIS", (index,)] == found["_OUTPUT_AXIS", (index,)]) != ("own" in case):
            raise ValueError("another output axis")
        values = {int(key[1]): float(v) for (name, key), v in found.items() if not name and key[0] == index}
        knots, numbers, wraps = siemens_curve(found, values, (index,), case)
        columns[{"0": BOTH, "1": POSITIVE, "-1": NEGATIVE}[found["_DIRECTION", (index,)]]] = numbers
    return Table([knots], columns, wraps=wraps)


def isg(side, section):
    head, cells = {}, {}
    for line in side["text"].splitlines():
        words = line.split()
        if len(words) < 2 or not words[0].startswith("kw." + section):
            continue
        name = words[0].removeprefix("kw." + section + ".")
        if cell := re.fullmatch(r"table((?:\[\d+\])+)\.(\w+)", name):
            index = tuple(map(int, re.findall(r"\d+", cell[1])))
            cells.setdefault(cell[2], {})[index] = float(words[1])
        else:
            head[name] = float(words[1])
    if head["unit"] != 1:
        raise ValueError("not metric")
    return head, {name: [values[key] for key in sorted(values)] for name, values in cells.items()}


def whole(table, step):
    table.step, table.position_step = step, step
    return table


def read_isg_ssfk(side, case):
    head, cells = isg(side, "ssfk")
    unit = metric(case) * 1e-4
    knots = cells.get("setpoint") or spaced(head["kw_startpos"], head["interval"], int(head["kw_nr_max"]))
    columns = {BOTH: cells["pos"]} if not head["bilateral"] else {POSITIVE: cells["pos"], NEGATIVE: cells["neg"]}
    return whole(Table([scaled(knots, unit)], {name: scaled(v, unit) for name, v in columns.items()},
                       wraps=head["modulo"] == 1), unit)


def read_isg_crosscomp(side, case):
    _, cells = isg(side, "crosscomp")
    unit = metric(case) * 1e-4
    return whole(Table([scaled(cells["setpoint"], unit)], {BOTH: scaled(cells["correction"], unit)},
                       wraps=side["settings"].get("modulo") == "yes"), unit)


def read_isg_crosscomp2(side, case):
    head, cells = isg(side, "crosscomp2")
    unit = metric(case) * 1e-4
    axes = [scaled(spaced(head[f"start_position_master{n}"], head["interval"], int(head[f"last_index_master{n}"]) + 1),
                   unit) for n in (1, 2)]
    return whole(Table(axes, {BOTH: scaled(cells["correction"], unit)}), unit)


def setting_units(side):
    position = UNITS[side["settings"]["position-unit"]]
    return position, UNITS[side["settings"].get("value-unit", side["settings"]["position-unit"])]


def read_softmc(side, case):
    lines = [line.split() for line in side["text"].splitlines() if line.split()]
    n, sizes = int(lines[0][0]), [int(word) for word in lines[0][1:]]
    position, value = setting_units(side)
    rows = [[float(word) for word in line] for line in lines[1:]]
    axes, stride = [], 1
    for k in range(n):
        axes.append([rows[i * stride][k] * position for i in range(sizes[k])])
        stride *= sizes[k]
    columns = {BOTH: [row[n] * value for row in rows]}
    return Table(axes, columns)


def read_icube(side, case):
    unit, _ = setting_units(side)
    rows = [[float(cell) * unit for cell in line.split(",")] for line in side["text"].splitlines()]
    return Table([[row[0] for row in rows]], {BOTH: [row[1] for row in rows]}, wraps="wrap-range" in side["settings"])


def read_linuxcnc(side, case):
    unit, _ = setting_units(side)
    rows = [[float(word) for word in line.split()] for line in side["text"].splitlines()]
    measured = side["settings"]["type"] == "0"
    trims = [[(row[0] - row[k] if measured else row[k]) * unit for row in rows] for k in (1, 2)]
    columns = {BOTH: trims[0]} if trims[0] == trims[1] else {POSITIVE: trims[0], NEGATIVE: trims[1]}
    return Table([[row[0] * unit for row in rows]], columns)


def read_weihong(side, case):
    unit, header, *lines = side["text"].splitlines()
    if (unit, header) != (";unit=mm", "[X]"):
        raise ValueError("another axis or unit")
    rows = [[float(cell) * UNITS["mm"] for cell in line.split(",")] for line in lines]
    forward, backward = ([row[k] for row in rows] for k in (1, 2))
    columns = {BOTH: forward} if forward == backward else {POSITIVE: forward, NEGATIVE: backward}
    return Table([[row[0] for row in rows]], columns)


def read_heidenhain(side, case, name, start):
    first, header, *lines = side["text"].splitlines()
    moving = "C" if case["rotary"] else "X"
    if not first.startswith("BEGIN " + name + moving + ".COM") or lines.pop() != "[END]":
        raise ValueError("another axis, or no end")
    unit = metric(case)
    column = header.index(moving if "own" in case else "Z", 15)
    rows = [(float(line[start:].split()[0]) * unit, float(line[column:].split()[0]) * unit) for line in lines]
    return whole(Table([[x for x, _ in rows]], {BOTH: [value for _, value in rows]}), unit * 1e-4)


def read_heidenhain_com(side, case):
    return read_heidenhain(side, case, "AXIS_", 5)


def read_heidenhain_com_530(side, case):
    datum, distance = map(float, re.search(r"DATUM:(\S+) DISTANCE:(\S+)", side["text"]).groups())
    table = read_heidenhain(side, case, "AXIS-", 8)
    even = scaled(spaced(datum, distance, len(table.axes[0])), metric(case))
    if any(abs(x - y) > 0.51e-4 * metric(case) for x, y in zip(table.axes[0], even)):
        raise ValueError("positions that do not fit")
    table.axes = [even]
    return table


def read_rapidcode(side, case):
    said = dict(re.findall(r"^# ([\w.-]+) = (.*)$", side["text"], re.M))
    counts = [float(cell) for line in side["text"].splitlines() if not line.startswith("#") for cell in line.split(",")]
    axes = []
    for n in range(1, case["dimensions"] + 1):
        low, high, delta = (float(said[f"input.{n}.{word}"]) for word in ("min", "max", "delta"))
        axes.append(scaled(spaced(low, delta, round((high - low) / delta) + 1), UNITS[said[f"input.{n}.unit"]]))
    unit = UNITS[said["output.unit"]] / float(said["output.counts-per-unit"])
    return Table(axes, {BOTH: scaled(counts, unit)}, step=abs(unit))


def read_pmac_1d(side, case):
    lines = [line for line in side["text"].splitlines() if not line.startswith(";")]
    at = next(i for i, line in enumerate(lines) if line.startswith("DEFINE COMP"))
    arguments = lines[at].removeprefix("DEFINE COMP ").split(",")
    entries = [0.0] + [float(word) for line in lines[at + 1:] for word in line.split()]
    position, value = setting_units(side)
    per = float(side["settings"]["counts-per-unit"])
    knots = [i * float(arguments[-1]) / int(arguments[0]) / per * position for i in range(len(entries))]
    return Table([knots], {BOTH: scaled(entries, value / per / 16)}, step=value / per / 16, wraps=True)


def read_kmotion_geo(side, case):
    numbers = [float(word) for word in re.split(r"[\s,]+", side["text"].strip())]
    rows, columns, dx, dy, x0, y0 = int(numbers[0]), int(numbers[1]), *numbers[2:6]
    unit = UNITS[side["settings"]["unit"]]
    axes = [spaced(x0, dx, columns), spaced(y0, dy, rows)]
    corrections = [[None] * (rows * columns) for _ in range(3)]
    for k in range(6, len(numbers), 5):
        row, column = int(numbers[k]), int(numbers[k + 1])
        for n, place in enumerate((axes[0][column], axes[1][row], 0.0)):
            corrections[n][row * columns + column] = (numbers[k + 2 + n] - place) * unit
    own = case.get("own", 2)
    if side is case["to"] and any(any(values) for n, values in enumerate(corrections) if n != own):
        raise ValueError("another axis is moved as well")
    table = Table([scaled(axis, unit) for axis in axes], {BOTH: corrections[own]})
    table.goes_on = True
    return table


def read_kmotion_linear(side, case):
    unit, _ = setting_units(side)
    count, size, start, *lines = side["text"].split()
    knots = spaced(float(start), float(size), int(count))
    places = [float(line.split(",")[1]) for line in lines]
    return Table([scaled(knots, unit)], {BOTH: [(place - x) * unit for place, x in zip(places, knots)]})


def read_power_pmac(side, case):
    said = dict(re.findall(r"^CompTable\[0\]\.(\S+) = (.*);$", side["text"], re.M))
    if (said["Source[0]"] == re.search(r"\d+", said["Target[0]"])[0]) != ("own" in case):
        raise ValueError("another motor")
    position, value = setting_units(side)
    per = float(side["settings"]["counts-per-unit"])
    segments, start, span = int(said["Nx[0]"]), float(said["X0[0]"]), float(said["Dx[0]"])
    lists = sorted((int(name[5:-1]), text) for name, text in said.items() if name.startswith("Data["))
    values = [float(cell) * value / per for _, text in lists for cell in text.split(",")]
    return Table([scaled([start + span * i / segments for i in range(segments + 1)], position / per)], {BOTH: values})


def read_twincat_nc(side, case):
    unit, _ = setting_units(side)
    pairs = re.findall(r"Position:=(\S+), Compensation:=([^)\s]+)\)", side["text"])
    return Table([[float(x) * unit for x, _ in pairs]], {BOTH: [float(value) * unit for _, value in pairs]},
                 wraps="Modulo:=TRUE" in side["text"])


def read_fanuc(side, case):
    said = side["settings"]
    values = {int(number) - 10000: int(steps) for number, steps in re.findall(r"^N(\d+)P(-?\d+)$", side["text"], re.M)}
    unit, _ = setting_units(side)
    reference, interval = int(said["reference-number"]), float(said["interval"])
    amounts = {0: 0}
    if "wrap-range" in said:
        count = len(values) - 1
        if sum(values[reference + k] for k in range(1, count + 1)) or values[reference] != values[reference + count]:
            raise ValueError("the turn does not close")
        del values[reference]
    for k in range(max(values) - reference):
        amounts[k + 1] = amounts[k] + values[reference + k + 1]
    for k in range(reference - min(values) + 1):
        amounts[-k - 1] = amounts[-k] - values[reference - k]
    step = int(said["magnification"]) * float(said["detection-unit"]) * unit
    knots = sorted(amounts)
    if len(knots) != len(values) + 1:
        raise ValueError("numbers are missing")
    return Table([[(float(said["reference-position"]) + k * interval) * unit for k in knots]],
                 {BOTH: [amounts[k] * step for k in knots]}, step=step, wraps="wrap-range" in said)


UNEVEN = {"isg-crosscomp", "isg-ssfk", "icube", "linuxcnc", "weihong", "heidenhain-com"}

READERS = {"csv": read_csv, "acs-1d": read_acs_1d, "acs-2d": read_acs_2d, "aerotech-1d": read_aerotech_1d, "aerotech-2d": read_aerotech_2d,
           "siemens-eec": read_siemens_eec, "siemens-cec": read_siemens_cec, "isg-ssfk": read_isg_ssfk,
           "isg-crosscomp": read_isg_crosscomp, "isg-crosscomp2": read_isg_crosscomp2, "softmc": read_softmc,
           "icube": read_icube, "linuxcnc": read_linuxcnc, "rapidcode": read_rapidcode, "pmac-1d": read_pmac_1d,
           "weihong": read_weihong, "heidenhain-com": read_heidenhain_com,
           "heidenhain-com-530": read_heidenhain_com_530,
           "kmotion-geo": read_kmotion_geo, "kmotion-linear": read_kmotion_linear,
           "power-pmac": read_power_pmac, "twincat-nc": read_twincat_nc,
           "fanuc": read_fanuc}


def lookup(axes, values, period, point, goes_on=False):
    """Linear in each dimension, outside held or as in the cell at that end; a first axis with a period rolls over."""
    total, corners = 0.0, [(0, 1.0)]
    stride = 1
    for n, (knots, x) in enumerate(zip(axes, point)):
        if period and n == 0:
            x = knots[0] + (x - knots[0]) % period
        x = x if goes_on else min(max(x, knots[0]), knots[-1])
        i = max(0, min(bisect_right(knots, x) - 1, len(knots) - 2))
        part = (x - knots[i]) / (knots[i + 1] - knots[i])
        corners = [(index + stride * (i + k), weight * (part if k else 1 - part))
                   for index, weight in corners for k in (0, 1)]
        stride *= len(knots)
    for index, weight in corners:
        total += weight * values[index]
    return total


def converted(table, values, point, own, changes):
    """What the other file says at this position."""
    def f(x):
        return lookup(table.axes, values, table.period, x, table.goes_on)

    if not changes:
        return f(point)
    if own is None:
        return -f(point)
    reach = (2 if table.goes_on else 1.01) * max(map(abs, values)) + 1e-12
    low, high = point[own] - reach, point[own] + reach
    for _ in range(100):
        middle = (low + high) / 2
        place = [*point[:own], middle, *point[own + 1:]]
        if middle + f(place) < point[own]:
            low = middle
        else:
            high = middle
    return -f([*point[:own], (low + high) / 2, *point[own + 1:]])


def steepest(axes, values):
    slope, stride = 0.0, 1
    for knots in axes:
        for i in range(len(values) - stride):
            k = i // stride % len(knots)
            if k + 1 < len(knots):
                slope = max(slope, abs(values[i + stride] - values[i]) / (knots[k + 1] - knots[k]))
        stride *= len(knots)
    return slope


def merged(columns, choice):
    if choice and POSITIVE in columns:
        positive, negative = columns[POSITIVE], columns[NEGATIVE]
        return {BOTH: {"positive": positive, "negative": negative}.get(
            choice, [(a + b) / 2 for a, b in zip(positive, negative)])}
    return columns


def positions(table, columns, own, to):
    """Where the points of the other file stand: x + f(x) where it takes uneven positions."""
    if own is None or len(table.axes) > 1 or table.period or set(columns) != {BOTH}:
        return table.axes
    knots = table.axes[0]
    distance = (knots[-1] - knots[0]) / (len(knots) - 1)
    even = all(abs(x - knots[0] - i * distance) < 1e-9 * abs(distance) for i, x in enumerate(knots))
    if even and to not in UNEVEN:
        return table.axes
    return [[x + value for x, value in zip(knots, columns[BOTH])]]


def problem_of(case):
    """What the second file says wrongly; None: nothing."""
    if "refused" in case:
        return case["refused"]
    a, b = (READERS[case[side]["format"]](case[side], case) for side in ("from", "to"))
    if case["dropsWrap"]:
        a.period = None
    columns = merged(a.columns, case.get("direction"))
    own = case.get("own")
    changes = (case["from"]["format"] in FEEDBACK) != (case["to"]["format"] in FEEDBACK)
    for side in ("from", "to"):
        if (case[side]["sign"] == "feedback") != (case[side]["format"] in FEEDBACK):
            return "the program says another convention of " + case[side]["format"]
    pmac = case["to"]["format"] == "pmac-1d"
    expected = positions(a, columns, own if changes else None, case["to"]["format"])
    for n, (knots, others) in enumerate(zip(expected, b.axes)):
        others = others[:len(knots)] if pmac else others  # which may have a way back to its beginning
        allowed = 0.5001 * b.position_step + 1e-10 * (abs(knots[0]) + abs(knots[-1]))
        if len(knots) != len(others) or any(abs(x - y) > allowed for x, y in zip(knots, others)):
            return f"the positions of source {n + 1} are others"
    if len(a.axes) != len(b.axes) or (set(b.columns) != set(columns) and set(b.columns) != {BOTH}):
        return "other axes or directions"
    if a.period and b.period and abs(a.period - b.period) > 1e-9 * a.period:
        return "another period"
    if bool(a.period) != bool(b.period) and not pmac:
        return "one of them rolls over"
    size = max(abs(knot) for knots in a.axes for knot in knots)  # positions are rounded to it, that of 0 too
    for name, values in columns.items():
        written = b.columns[name if name in b.columns else BOTH]
        slope = steepest(a.axes, values)
        spread = 1 / (1 - slope) if slope < 1 else float("inf")
        for index, value in enumerate(written):
            point, rest = [], index
            for knots in b.axes:
                point.append(knots[rest % len(knots)])
                rest //= len(knots)
            if pmac and point[0] > a.axes[0][-1] + 1e-10:
                continue
            due = converted(a, values, point, own, changes)
            allowed = (0.5001 * b.step + b.relative * abs(due) + 1e-13 * size
                       + (1e-10 * size + 0.5001 * b.position_step) * slope * spread)
            if not abs(value - due) <= allowed:
                return f"at {point} it says {value:.12g} instead of {due:.12g}"
    return None


def main():
    wrong, count = [], 0
    with open(sys.argv[1], encoding="utf-8") as lines:
        for count, line in enumerate(lines, 1):
            case = json.loads(line)
            try:
                problem = problem_of(case)
            except (ValueError, KeyError, IndexError, TypeError, StopIteration) as unreadable:
                problem = f"it cannot be read: {unreadable!r}"
            if problem:
                names = " to ".join(case[side]["format"] for side in ("from", "to")) if "from" in case else "a table"
                wrong.append(f"{count}: {names} is silently wrong: {problem}")
    print(f"{count} conversions, {len(wrong)} wrong")
    print("\n".join(wrong[:40]))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
