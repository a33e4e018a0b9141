#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs the benchmarks and what they are compared with, one beside the other, and prints the tables of
# docs/performance.md: what was measured, what is asked for, and what others take in the same run. What is
# not installed is left out of them.
#     tests/bench/compare.sh [--build FOLDER] [--peers FOLDER] [--rounds N] [ROW ...]
#   --build   has bin/bench_* and the programs (build/release)
#   --peers   where `npm install nodejs-polars @duckdb/node-api` was run; npm 11 wants polars' own part by its
#             name, too: nodejs-polars-linux-x64-gnu
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
    -*) sed -n '3,13s/^# \{0,1\}//p' "$0"; exit 2 ;;
    *) rows+=("$1") ;;
    esac
    shift
done

work=$(mktemp -d)
drive= # of start_drive
trap '[ -z "$drive" ] || kill "$drive"; rm -rf "$work"' EXIT
export QT_QPA_PLATFORM=offscreen XDG_CONFIG_HOME="$work/config" XDG_STATE_HOME="$work/state"

# row WHAT OURS GOAL PEERS: one line of the table.
row() { printf '| %s | %s | %s | %s |\n' "$1" "$2" "${3:--}" "${4:--}"; }
heading() { printf '\n%s\n\n| what | measured | asked for | beside it |\n|---|---|---|---|\n' "$1"; }

# bench PROGRAM FILTER [FIELD]: of the best round the milliseconds, or another field.
bench() {
    AXISCOMP_BENCH_CSV=${sample:-} "$build/bin/$1" --benchmark_filter="$2" \
        --benchmark_min_time=0.05 --benchmark_repetitions="$rounds" --benchmark_format=json \
        2>/dev/null | python3 -c '
import json, sys
unit = {"ns": 1e-6, "us": 1e-3, "ms": 1.0, "s": 1e3}
runs = [run for run in json.load(sys.stdin)["benchmarks"] if run["run_type"] == "iteration"]
best = min(runs, key=lambda run: run["real_time"])
if "error_message" in best:
    sys.exit(best["error_message"])
field = sys.argv[1]
value = best[field] if field else best["real_time"] * unit[best["time_unit"]]
print("%.0f" % value if value > 1e4 else "%.4g" % value)' "${3:-}"
}

# process COMMAND...: milliseconds of the best of the rounds, as a whole process.
process() {
    python3 - "$rounds" "$@" <<'PY'
import subprocess, sys, time
best = float("inf")
for _ in range(int(sys.argv[1])):
    begin = time.perf_counter()
    subprocess.run(sys.argv[2:], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    best = min(best, time.perf_counter() - begin)
print("%.4g" % (1e3 * best))
PY
}

# calculate EXPRESSION FORMAT: a number, in words.
calculate() { python3 -c 'import sys; print(sys.argv[2] % eval(sys.argv[1]))' "$1" "$2"; }

# sample NAME [ORDER]: a calibration file, its path in $sample.
sample() {
    sample=$work/$1.csv
    [ -e "$sample" ] || "$build/bin/bench_csv" --sample "$sample" "${2:-}"
}

# speed MILLISECONDS: of reading the sample, "10.3 ms, 1423 MB/s".
speed() { echo "$1 ms, $(calculate "$(stat -c %s "$sample") / 1e3 / $1" '%.0f') MB/s"; }

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
        "$(speed "$(bench bench_csv '^fileToTable/threads:0/')")" '1200 MB/s' "$(peer_times)"
    row 'the same on one' "$(speed "$(bench bench_csv '^fileToTable/threads:1/')")" '800 MB/s'
}

row_random() {
    sample random random
    row 'lines in random order' "$(speed "$(bench bench_csv '^fileToTable/threads:0/')")" '600 MB/s' \
        "$(peer_times)"
}

row_scattered() {
    sample scattered scattered
    row 'every position another one: to the refusal' \
        "$(speed "$(bench bench_csv '^scatteredPositions/threads:0/')")" '300 MB/s' "$(peer_times)"
}

row_write() {
    sample grid
    row 'writing it' "$(speed "$(bench bench_csv '^writeText/threads:0/')")" '800 MB/s'
}

row_measurements() {
    local time
    sample=$work/points.csv
    [ -e "$sample" ] || "$build/bin/bench_measurements" --sample "$sample"
    time=$(bench bench_measurements '^read/points')
    row 'measurements of a million points' \
        "$time ms, $(calculate "1e3 * $(bench bench_measurements '^read/points' MB) / $time" '%.0f') MB/s" \
        '300 MB/s' "$(peer_times)"
    row '1000 targets with ten runs in each direction judged' \
        "$(bench bench_measurements '^judgeThousandTargets') ms" '5 ms'
    row '81 targets with ten runs each way fitted and foretold (what a control that moves starts)' \
        "$(bench bench_measurements '^fitRuns/smooth/81') ms, smoothness searched for \
$(bench bench_measurements '^fitRuns/automatic/81') ms" '16 ms'
    row 'the same for 1000 targets' "$(bench bench_measurements '^fitRuns/smooth/1000') ms, smoothness searched for \
$(bench bench_measurements '^fitRuns/automatic/1000') ms" '500 ms'
}

row_formats() {
    local name
    for name in softMC:readFormat/softmc 'Aerotech 2D:readFormat/aerotech_2d' \
        'ISG crosscomp2:readFormat/isg_crosscomp2' RapidCode:readFormat/rapidcode \
        'RepRap height map:readHeightMap' 'Klipper bed mesh:readBedMesh'; do
        row "${name%%:*}, $(calculate "$(bench bench_formats "^${name#*:}\$" MB)" '%.2f') MB" \
            "$(calculate "$(bench bench_formats "^${name#*:}\$" bytes_per_second) / 1e6" '%.0f') MB/s" \
            '400 MB/s'
    done
}

row_lookup() {
    local each='linear:2.5 bilinear:6 trilinear:11 bilinearBatch:- trilinearBatch:5' name goal
    for name in $each; do
        goal=${name#*:}
        [ "$goal" = - ] || goal+=' ns'
        row "lookup, ${name%%:*}" \
            "$(calculate "1e9 * $(bench bench_lookup "^${name%%:*}(/real_time)?\$" each)" '%.2f') ns" \
            "$goal"
    done
}

row_conversion() {
    row 'sign converted and compared under both rules, a million points' \
        "$(bench bench_conversion '^convertAndCompare/1000/') ms" '150 ms'
    local name goal scipy=
    if python3 -c 'import scipy' 2>/dev/null; then
        scipy=$(python3 "$here/scipy_resample.py")
    fi
    for name in linear:5:linear cubic:15:- spline:-:cubic; do
        goal=$(cut -d: -f2 <<<"$name")
        [ "$goal" = - ] || goal+=' ms'
        row "500 x 500 onto 1000 x 1000, ${name%%:*}" \
            "$(bench bench_conversion "^resamplePlane/${name%%:*}/") ms" "$goal" \
            "$(sed -n "s/^\(.*, ${name##*:}\): /scipy \1: /p" <<<"$scipy")"
    done
}

# shellcheck disable=SC2016 # the backquotes are those of Markdown
row_convert() {
    sample grid
    row '`axiscomp convert` of it to a .TAMtbl, the whole process' \
        "$(process "$build/bin/axiscomp" convert "$sample" "$work/out.TAMtbl" --dims 3) ms" '25 ms'
    row '`axiscomp convert` of it to a CSV' \
        "$(process "$build/bin/axiscomp" convert "$sample" "$work/out.csv" --dims 3) ms"
}

# shellcheck disable=SC2016 # the backquotes are those of Markdown
row_version() {
    row '`axiscomp --version`' "$(process "$build/bin/axiscomp" --version) ms" '3 ms' \
        "true $(process /bin/true) ms, python3 -c pass $(process python3 -I -S -c pass) ms"
}

# shellcheck disable=SC2016
row_import() {
    local bare with
    bare=$(process python3 -S -c pass)
    with=$(PYTHONPATH=$build/python process python3 -S -c 'import axiscomp')
    row '`import axiscomp` in Python' "$(calculate "$with - $bare" '%.4g') ms" '60 ms' \
        "python3 -S -c pass $bare ms"
}

# start_drive BAUD: a virtual drive, its addresses in $web and $terminal.
start_drive() {
    [ -z "$drive" ] || kill "$drive"
    "$build/bin/axiscomp-virtualdrive" --http 127.0.0.1:0 --serial "$work/terminal" --baud "$1" \
        >"$work/ready" &
    drive=$!
    until grep -q '^ready' "$work/ready"; do kill -0 "$drive" && sleep 0.05; done
    web=$(sed -n 's/^ready http=\([^ ]*\).*/\1/p' "$work/ready")
    terminal=$work/terminal
}

row_web() {
    start_drive 921600
    local rounds=$((rounds < 6 ? rounds : 6)) # more than a drive lets its flash be written to in an hour
    export AXISCOMP_BENCH_DRIVE=$web
    row 'full table over the web: uploaded, read back, verified, committed' \
        "$(bench bench_link '^transferAndCommit') ms" '25 ms'
    start_drive 921600
    export AXISCOMP_BENCH_DRIVE=$web
    row 'a whole write of it, with its plan, backup and journal' "$(bench bench_link '^writeFullTable') ms"
    curl -s -o "$work/full.TAMtbl" "$web/files/tables/large1.TAMtbl"
    row 'its upload alone' "$(bench bench_link '^upload') ms" - \
        "curl $(process curl -s -f -H Expect: -F filepath=tables/large2.TAMtbl \
            -F "file=@$work/full.TAMtbl" "$web/transfer") ms"
    row 'its download alone' "$(bench bench_link '^download') ms" - \
        "curl $(process curl -s -f -o "$work/back" "$web/files/tables/large2.TAMtbl") ms"
}

# share BYTES MILLISECONDS: of a line of 921 600 baud.
share() { calculate "100 * $1 * 10 / 921600 / ($2 / 1e3)" '%.1f %%'; }

row_serial() {
    start_drive 921600
    local rounds=1 bytes peer=()
    export AXISCOMP_BENCH_DRIVE="serial:$terminal?baud=921600"
    bytes=$(bench bench_link '^upload' bytes)
    if command -v sb >/dev/null; then
        mapfile -t peer < <(python3 "$here/serial_peer.py" "$terminal" "$bytes")
    fi
    row 'full table over a line of 921 600 baud, up' \
        "$(share "$bytes" "$(bench bench_link '^upload')") of the line" '97 %' \
        "${peer[0]:+sb $(share "$bytes" "${peer[0]}")}"
    row 'down' "$(share "$bytes" "$(bench bench_link '^download')") of the line" '97 %' \
        "${peer[1]:+rb $(share "$bytes" "${peer[1]}")}"
}

row_registers() {
    start_drive 115200
    export AXISCOMP_BENCH_DRIVE="serial:$terminal?baud=115200"
    row 'eight registers over a line of 115 200 baud' "$(bench bench_link '^readEightRegisters') ms" '100 ms'
}

row_window() {
    row 'first paint of the window, from the start of the program' "$(python3 - "$rounds" \
        "$build/bin/axis-compensation-wizard" --drive demo: <<'PY'
import os, subprocess, sys, time
best = float("inf")
for _ in range(int(sys.argv[1])):
    begin = time.perf_counter()
    window = subprocess.Popen(sys.argv[2:], stderr=subprocess.PIPE, text=True,
                              env={**os.environ, "AXISCOMP_TIMING": "1"})
    while "first paint" not in window.stderr.readline():
        if window.poll() is not None:
            sys.exit("no first paint")
    best = min(best, time.perf_counter() - begin)
    window.kill()
    window.wait()
print("%.4g ms" % (1e3 * best))
PY
    )" '220 ms'
    row 'a file of 20 MB opened until it is drawn' "$(bench bench_window '^openFileUntilDrawn') ms" '120 ms'
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

table_fit() {
    printf '\nFits of scattered points: processor time of one core, and the error to the truth\n\n'
    python3 "$here/scipy_fit.py" "$build/bin/bench_fit"
}

if [ ${#rows[@]} -gt 0 ]; then
    heading 'Chosen rows'
    for name in "${rows[@]}"; do "row_$name"; done
    exit
fi
heading 'Calibration files and measurements'
for name in csv random scattered write measurements; do "row_$name"; done
heading 'Files of other controllers'
row_formats
heading 'Lookups and conversions'
for name in lookup conversion; do "row_$name"; done
heading 'Whole processes, and the window'
for name in convert version import window; do "row_$name"; done
heading 'Links, to the virtual drive'
for name in web serial registers; do "row_$name"; done
table_growth
table_fit
