#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The main job on a virtual drive, every step shown: from a calibration file to a compensation that
# is active and proved. Usage: tour.sh FOLDER-OF-THE-PROGRAMS
set -euo pipefail

programs=$(cd "${1:?usage: tour.sh FOLDER-OF-THE-PROGRAMS}" && pwd)
for program in axiscomp axiscomp-virtualdrive; do
    if [[ ! -x $programs/$program ]]; then
        echo "tour: there is no program $program in $programs" >&2
        exit 2
    fi
done
PATH=$programs:$PATH

work=$(mktemp -d "${TMPDIR:-/tmp}/axiscomp-tour-XXXXXX")
drive_process=""
finish()
{
    local code=$?
    if [[ -n $drive_process ]]; then
        kill "$drive_process" 2>/dev/null || true
        wait "$drive_process" 2>/dev/null || true
    fi
    rm -rf "$work"
    exit "$code"
}
trap finish EXIT
trap 'exit 130' INT TERM

bold="" normal=""
if [[ -t 1 && ${TERM:-dumb} != dumb ]]; then
    bold=$'\033[1m' normal=$'\033[0m'
fi

say()
{
    printf '\n%s%s%s\n\n' "$bold" "$1" "$normal"
}

# Prints a command as a person would type it, then runs it.
show()
{
    printf '%s$' "$bold"
    local word
    for word in "$@"; do
        if [[ $word =~ ^[A-Za-z0-9_./:=-]+$ ]]; then
            printf ' %s' "$word"
        else
            printf " '%s'" "$word"
        fi
    done
    printf '%s\n' "$normal"
    "$@" 2>&1
    echo
}

cd "$work"
# What the program remembers of this drive is of no use after the tour.
export XDG_STATE_HOME=$work/state

say "A virtual drive with two axes starts on this computer."
mkfifo ready
axiscomp-virtualdrive --http 127.0.0.1:0 --axes 2 --name Tour >ready &
drive_process=$!
if ! read -r -t 30 ready_line <ready; then
    echo "tour: the virtual drive did not start" >&2
    exit 1
fi
echo "$ready_line"
address=${ready_line#ready http=}
export AXISCOMP_DRIVE=${address%% *}

say "1. What is there? (the address of the drive is in AXISCOMP_DRIVE)"
show axiscomp axes

say "2. A calibration file: errors of axis X, measured over X and Y."
show axiscomp example --dims 2 -o calibration.csv
show axiscomp inspect calibration.csv --dims 2

say "3. The second table of the file goes to axis X, and stays there after a reboot."
show axiscomp write --axis X --data calibration.csv --dims 2 --table 2 \
    --source1 'Axes[0]/Signals/PathPlanner/Position' \
    --source2 'Axes[1]/Signals/PathPlanner/Position' --persistent

say "4. The drive checks table and sources, and looks up without adding anything yet."
show axiscomp evaluate --axis X
show axiscomp monitor --axis X --rate 10 --count 3
show axiscomp status --axis X

say "5. The compensation is switched on, and the drive's own output proves it."
show axiscomp activate --axis X

state=$(axiscomp status --axis X --json | sed -n 's/^  "state": "\(.*\)",$/\1/p')
if [[ $state != Active ]]; then
    echo "tour: the compensation is $state, it should be Active" >&2
    exit 1
fi
