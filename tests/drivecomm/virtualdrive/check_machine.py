#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the instrument of a virtual machine says, computed once more.

Shares no code with the program. Reads {"machine": a machine file, "samples": [...]} from standard input
and prints one reading for each sample. A sample has the raw positions of all axes, the axis that is
measured, the way that it has gone since the sample before, its temperature, and the numbers of the
approach and of the reading.
"""

import json
import math
import sys

MASK = (1 << 64) - 1


def mixed(value):
    value = ((value ^ (value >> 30)) * 0xBF58476D1CE4E5B9) & MASK
    value = ((value ^ (value >> 27)) * 0x94D049BB133111EB) & MASK
    return value ^ (value >> 31)


class Random:
    """SplitMix64; a list of words is stirred in one by one."""

    def __init__(self, *words):
        self.state = 0
        for word in words:
            self.state = self.word(self.state ^ word)

    def word(self, state=None):
        self.state = ((self.state if state is None else state) + 0x9E3779B97F4A7C15) & MASK
        return mixed(self.state)

    def fraction(self):
        return (self.word() >> 11) / 2.0**53

    def normal(self):
        radius = math.sqrt(-2.0 * math.log(1.0 - self.fraction()))
        return radius * math.cos(2.0 * math.pi * self.fraction())


class NaturalSpline:
    """By its second derivatives M: (M[i-1] + 4 M[i] + M[i+1]) h^2 / 6 = second differences, M = 0 at the ends."""

    def __init__(self, first, distance, values):
        self.first, self.distance, self.values = first, distance, values
        count = len(values)
        rows = []  # (pivot, right side), eliminated downwards
        for i in range(1, count - 1):
            right = 6.0 * (values[i - 1] - 2.0 * values[i] + values[i + 1]) / distance**2
            pivot = 4.0
            if rows:
                pivot -= 1.0 / rows[-1][0]
                right -= rows[-1][1] / rows[-1][0]
            rows.append((pivot, right))
        self.bends = [0.0] * count
        for i in range(count - 2, 0, -1):
            self.bends[i] = (rows[i - 1][1] - self.bends[i + 1]) / rows[i - 1][0]

    def at(self, position):
        last = len(self.values) - 1
        place = min(max((position - self.first) / self.distance, 0.0), float(last))
        i = min(int(place), last - 1)
        b = place - i
        a = 1.0 - b
        bend = (a**3 - a) * self.bends[i] + (b**3 - b) * self.bends[i + 1]
        return a * self.values[i] + b * self.values[i + 1] + bend * self.distance**2 / 6.0


def usual_order(names):
    usual = ["X", "Y", "Z", "A", "B", "C"]
    return sorted(names, key=lambda name: (usual.index(name) if name in usual else 6, name))


class Machine:
    def __init__(self, description):
        self.seed = description.get("seed", 1)
        self.names = usual_order(description["axes"])
        self.axes = [description["axes"][name] for name in self.names]
        self.instrument = description.get("instrument", {})
        self.maps = {}
        self.middles = {}

    def travel(self, axis):
        return self.axes[axis].get("travel", [0, 360 if self.axes[axis].get("unit") == "deg" else 500])

    def error(self, terms, axis, source, raw):
        value = terms.get("slope", 0.0) * raw
        for wave in terms.get("waves", []):
            value += wave["amplitude"] * math.sin(2.0 * math.pi * raw / wave["period"] + wave.get("phase", 0.0))
        if "map" in terms:
            if (axis, source) not in self.maps:
                low, high = self.travel(source)
                random = Random(self.seed, 1, axis, source)
                walk = [0.0]
                while low + (len(walk) - 1) * terms["map"]["spacing"] < high - 1e-9:
                    walk.append(walk[-1] + terms["map"]["sigma"] * random.normal())
                self.maps[axis, source] = NaturalSpline(low, terms["map"]["spacing"], walk)
            value += self.maps[axis, source].at(raw)
        return value

    def side(self, axis, way):
        """Of the backlash: its middle is dragged along, half of the width behind."""
        half = max(self.axes[axis].get("reversalWidth", 0.0), 1e-9) / 2.0
        for place in way:
            middle = self.middles.get(axis, place - half)
            self.middles[axis] = min(max(middle, place - half), place + half)
        return (way[-1] - self.middles[axis]) / (2.0 * half)

    def reading(self, sample):
        axis = sample["axis"]
        truth = self.axes[axis]
        raw = sample["raw"][axis]
        value = raw + self.error(truth, axis, axis, raw)
        value += truth.get("reversal", 0.0) * self.side(axis, sample["way"])
        if "thermal" in truth:
            thermal = truth["thermal"]
            kelvin = sample["temperature"] - 20.0
            value += thermal.get("expansion", 0.0) * kelvin * (raw - thermal.get("fixedAt", 0.0))
            value += thermal.get("zeroPerKelvin", 0.0) * kelvin
        for name, terms in truth.get("from", {}).items():
            other = self.names.index(name)
            value += self.error(terms, axis, other, sample["raw"][other])
        noise = truth.get("noise", {})
        value += noise.get("approach", 0.0) * Random(self.seed, 2, axis, sample["approach"]).normal()
        value += noise.get("reading", 0.0) * Random(self.seed, 3, axis, sample["reading"]).normal()
        if self.names.index(self.instrument.get("axis", self.names[0])) == axis:
            for gross in self.instrument.get("gross", []):
                if gross["reading"] == sample["approach"]:
                    value += gross["by"]
        return self.instrument.get("sign", 1) * value + self.instrument.get("zero", 0.0)


def main():
    task = json.load(sys.stdin)
    machine = Machine(task["machine"])
    json.dump([machine.reading(sample) for sample in task["samples"]], sys.stdout)


if __name__ == "__main__":
    main()
