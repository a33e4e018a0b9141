#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the fuzzers (preset fuzz: clang, libFuzzer) and runs each of them for so many seconds of
# processor time, two at a time, from corpus/ and from what earlier runs have found. Ends with the
# table of docs/reliability.md. A finding fails the run; its input is in build/fuzz/findings.
#   tests/fuzz/run.sh [SECONDS [FUZZER ...]]      600 and all of them, unless told otherwise
# Of the readers of measurements each is a run of its own: fuzz_measurement_formats:renishaw.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."

seconds=${1:-600}
shift || true
fuzzers=("$@")
if [ ${#fuzzers[@]} -eq 0 ]; then
    fuzzers=(tests/fuzz/corpus/*)
    fuzzers=("${fuzzers[@]##*/}")
    mapfile -t fuzzers < <(printf '%s\n' "${fuzzers[@]}" | grep -vx fuzz_measurement_formats)
    for format in runs wide track points renishaw api-pos ecmc ecmc-report mapped; do
        fuzzers+=("fuzz_measurement_formats:$format")
    done
fi

cmake --preset fuzz -DAXISCOMP_WINDOW=OFF >/dev/null
cmake --build --preset fuzz --target "${fuzzers[@]%%:*}" -- --quiet

fuzz() {
    local fuzzer=${1%%:*} format='' status=0
    local findings=build/fuzz/findings/$fuzzer inputs=build/fuzz/inputs/$1
    if [[ $1 == *:* ]]; then
        format=${1#*:}
    fi
    mkdir -p "$inputs" "$findings"
    # The limit on processor time ends it; a finding ends it earlier, with another status.
    {
        (
            ulimit -S -t "$seconds"
            exec env ${format:+AXISCOMP_FUZZ_FORMAT="$format"} "build/fuzz/bin/$fuzzer" -max_len=8192 -rss_limit_mb=2048 -timeout=20 \
                -artifact_prefix="$findings/" "$inputs" "tests/fuzz/corpus/$fuzzer"
        ) >"build/fuzz/$1.log" 2>&1
    } 2>/dev/null || status=$?
    if [ "$status" -ne 152 ]; then # 128 + SIGXCPU
        echo "$1 ended with status $status: see build/fuzz/$1.log" >&2
        return 1
    fi
}

status=0
running=0
for fuzzer in "${fuzzers[@]}"; do
    if [ $running -eq 2 ]; then
        wait -n || status=1
        running=1
    fi
    fuzz "$fuzzer" &
    running=$((running + 1))
done
while [ $running -gt 0 ]; do
    wait -n || status=1
    running=$((running - 1))
done

printf '\n| fuzzer | executions | edges | features | inputs kept |\n|---|---|---|---|---|\n'
for fuzzer in "${fuzzers[@]}"; do
    # "#131072 pulse  cov: 913 ft: 3405 corp: 507/98Kb ..."
    sed -n 's/^#\([0-9]*\)[^0-9].*cov: \([0-9]*\) ft: \([0-9]*\) corp: \([0-9]*\).*/| '"$fuzzer"' | \1 | \2 | \3 | \4 |/p' \
        "build/fuzz/$fuzzer.log" | tail -n 1
done
exit $status
