#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How long pandas takes to read a CSV file, in milliseconds: csv_peers.py FILE ROUNDS

The best of the rounds, by the default C engine, one thread. pandas only reads: no grid is verified.
"""
import sys
import time

import pandas


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    with open(sys.argv[1], encoding="utf-8") as file:
        comments = 1 if file.readline().startswith("//") else 0
    best = float("inf")
    for _ in range(int(sys.argv[2])):
        begin = time.perf_counter()
        table = pandas.read_csv(sys.argv[1], skiprows=comments)
        best = min(best, time.perf_counter() - begin)
        assert table.shape[1] >= 3, table.shape
    print(f"{1e3 * best:.2f}")


if __name__ == "__main__":
    main()
