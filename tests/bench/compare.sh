#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs the benchmarks and what they are compared with, one beside the other, and prints the tables of
# docs/performance.md. What is not installed is left out of them.
#     tests/bench/compare.sh [--build FOLDER] [--peers FOLDER] [--rounds N] [ROW ...]
#   --build   has bin/bench_*, and bin/axiscomp (build/release)
#   --peers   where `npm install nodejs-polars @duckdb/node-api` was run
#   --rounds  of each measurement, of which the best counts (7)
#   ROW       a row by its name below; without one, all of them
# A row is a function row_NAME; it calls `row` once for each line of the table that it prints.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "$here/../.." && pwd)/build/release
peers=
rounds=7
rows=()
while [ $# -gt 0 ]; do
    case $1 in
    --build) build=$2; shift ;;
    --peers) peers=$2; shift ;;
    --rounds) rounds=$2; shift ;;
    -*) sed -n '3,10s/^# \{0,1\}//p' "$0"; exit 2 ;;
    *) rows+=("$1") ;;
    esac
    shift
done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# row WHAT OURS PEERS: one line of the table.
row() { printf '| %s | %s | %s |\n' "$1" "$2" "${3:--}"; }
heading() { printf '\n%s\n\n| what | measured | beside it |\n|---|---|---|\n' "$1"; }

# bench PROGRAM BENCHMARK [THREADS]: milliseconds of the best round.
bench() {
    AXISCOMP_BENCH_CSV=${sample:-} "$build/bin/$1" --benchmark_filter="^$2/threads:${3:-0}/" \
        --benchmark_min_time=0.05 --benchmark_repetitions="$rounds" --benchmark_format=json \
        2>/dev/null | python3 -c '
import json, sys
unit = {"ns": 1e-6, "us": 1e-3, "ms": 1.0, "s": 1e3}
runs = [run for run in json.load(sys.stdin)["benchmarks"] if run["run_type"] == "iteration"]
print("%.2f" % min(run["real_time"] * unit[run["time_unit"]] for run in runs))'
}

# process COMMAND...: milliseconds of the best of the rounds, as a whole process.
process() {
    python3 - "$rounds" "$@" <<'PY'
import subprocess, sys, time
best = float("inf")
for _ in range(int(sys.argv[1])):
    begin = time.perf_counter()
    subprocess.run(sys.argv[2:], check=True, stdout=subprocess.DEVNULL)
    best = min(best, time.perf_counter() - begin)
print("%.2f" % (1e3 * best))
PY
}

# sample NAME [ORDER]: a calibration file, its path in $sample.
sample() {
    sample=$work/$1.csv
    [ -e "$sample" ] || "$build/bin/bench_csv" --sample "$sample" "${2:-}"
}

# speed MILLISECONDS: of reading the sample, "10.3 ms, 1423 MB/s".
speed() {
    python3 -c 'import os, sys
print("%s ms, %.0f MB/s" % (sys.argv[1], os.path.getsize(sys.argv[2]) / 1e3 / float(sys.argv[1])))' \
        "$1" "$sample"
}

# peer_times: what pandas, polars and DuckDB take for the sample.
peer_times() {
    local list=
    if python3 -c 'import pandas' 2>/dev/null; then
        list+=", pandas $(python3 "$here/csv_peers.py" "$sample" "$rounds") ms"
    fi
    for peer in polars duckdb; do
        if [ -n "$peers" ] && time=$(node "$here/csv_peers.mjs" $peer "$peers" "$sample" "$rounds"); then
            list+=", $peer $time ms"
        fi
    done
    echo "${list#, }"
}

row_csv() {
    sample grid
    row 'calibration file to verified table, all processors' \
        "$(speed "$(bench bench_csv fileToTable)")" "$(peer_times)"
    row 'the same on one' "$(speed "$(bench bench_csv fileToTable 1)")"
}

row_random() {
    sample random random
    row 'lines in random order' "$(speed "$(bench bench_csv fileToTable)")" "$(peer_times)"
}

row_scattered() {
    sample scattered scattered
    row 'every position another one: to the refusal' \
        "$(speed "$(bench bench_csv scatteredPositions)")" "$(peer_times)"
}

row_write() {
    sample grid
    row 'writing it' "$(speed "$(bench bench_csv writeText)")"
}

# shellcheck disable=SC2016 # the backquotes are those of Markdown
row_convert() {
    sample grid
    row '`axiscomp convert` of it to a .TAMtbl, the whole process' \
        "$(process "$build/bin/axiscomp" convert "$sample" "$work/out.TAMtbl" --dims 3) ms"
    row '`axiscomp convert` of it to a CSV' \
        "$(process "$build/bin/axiscomp" convert "$sample" "$work/out.csv" --dims 3) ms"
}

# shellcheck disable=SC2016 # the backquotes are those of Markdown
row_version() {
    row '`axiscomp --version`' "$(process "$build/bin/axiscomp" --version) ms"
}

row_measurements() {
    local time
    time=$("$build/bin/bench_measurements" --benchmark_filter='^read/points' \
        --benchmark_repetitions="$rounds" --benchmark_format=json 2>/dev/null | python3 -c '
import json, sys
runs = [run for run in json.load(sys.stdin)["benchmarks"] if run["run_type"] == "iteration"]
best = min(run["real_time"] for run in runs)
print("%.1f ms, %.0f MB/s" % (best, 1e3 * runs[0]["MB"] / best))')
    row 'measurements of a million points' "$time"
}

# growth TITLE PROGRAM FILTER: time by size, and the exponent from one size to the next.
growth() {
    printf '\n%s\n\n| cells | time | exponent |\n|---:|---:|---:|\n' "$1"
    "$build/bin/$2" --benchmark_filter="$3" --benchmark_format=json 2>/dev/null | python3 -c '
import json, math, sys
unit = {"ns": 1e-6, "us": 1e-3, "ms": 1.0, "s": 1e3}
before = None
for run in json.load(sys.stdin)["benchmarks"]:
    cells, time = run["cells"], run["real_time"] * unit[run["time_unit"]]
    slope = "-"
    if before:
        slope = "%.2f" % (math.log(time / before[1]) / math.log(cells / before[0]))
    print("| %.3g | %.3g ms | %s |" % (cells, time, slope))
    before = cells, time'
}

table_growth() {
    growth 'Reading a calibration file of other sizes' bench_csv '^growth/'
}

if [ ${#rows[@]} -gt 0 ]; then
    heading 'Chosen rows'
    for name in "${rows[@]}"; do "row_$name"; done
    exit
fi
heading 'Calibration files and measurements'
for name in csv random scattered write measurements; do "row_$name"; done
heading 'Whole processes'
for name in convert version; do "row_$name"; done
table_growth
