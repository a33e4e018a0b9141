#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The main job on a virtual drive, every step shown: from a calibration file to a compensation that
# is active and proved. Usage: tour.sh [FOLDER-OF-THE-PROGRAMS], without it the installed ones.
set -euo pipefail

programs=${1:-$(dirname "$(command -v axiscomp || echo "$0")")}
programs=$(cd "$programs" && pwd)
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

# Prints a command as a person would type it.
print_command()
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
}

# The same, and runs it.
show()
{
    print_command "$@"
    timeout --foreground 300 "$@" 2>&1
    echo
}

cd "$work"
# What the program remembers of this drive is of no use after the tour.
export XDG_STATE_HOME=$work/state

# start_drive ARGUMENT ...: the virtual drive in the background; its address is in AXISCOMP_DRIVE.
start_drive()
{
    rm -f ready
    mkfifo ready
    print_command axiscomp-virtualdrive "$@" --http 127.0.0.1:0
    axiscomp-virtualdrive "$@" --http 127.0.0.1:0 >ready &
    drive_process=$!
    local line address
    if ! read -r -t 30 line <ready; then
        echo "tour: the virtual drive did not start" >&2
        exit 1
    fi
    echo "$line"
    address=${line#ready http=}
    export AXISCOMP_DRIVE=${address%% *}
}

stop_drive()
{
    kill "$drive_process"
    wait "$drive_process" || true
    drive_process=""
}

expect_active()
{
    local state
    state=$(axiscomp status --axis X --json | sed -n 's/^  "state": "\(.*\)",$/\1/p')
    if [[ $state != Active ]]; then
        echo "tour: the compensation is $state, it should be Active" >&2
        exit 1
    fi
}

say "A virtual drive with two axes starts on this computer."
start_drive --axes 2 --name Tour

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

expect_active
stop_drive

say "And where does a calibration file come from? Another drive moves a machine with errors that nobody knows."
# A screw of 200 mm that does not warm up meanwhile; a minute of it passes in a second.
cat >machine.json <<'END'
{"axes": {"X": {"travel": [0, 200], "slope": 50e-6,
    "waves": [{"period": 430, "amplitude": 0.003, "phase": 0.7}, {"period": 97, "amplitude": 0.0012}],
    "reversal": 0.0024, "reversalWidth": 0.01, "noise": {"approach": 0.0001, "reading": 0.00002}}}}
END
machine=(--machine machine.json --name Machine --state flash --speed 60)
measure()
{
    show axiscomp capture --axis X --plan "$1" --dwell 0.4 --average 3 --rate 50 -o "$2" \
        --reference 'Machine/Axes[0]/ReferencePosition'
}

say "6. A plan: 9 uneven targets, two runs in each direction. The machine's control plays it; capture only reads."
show axiscomp targets --from 0 --to 200 --count 9 --cycles 2 --overrun 20 --feed 100 --dwell 60 -o plan.csv
start_drive "${machine[@]}" --program plan.csv --program-after 3
measure plan.csv before.csv

say "7. The figures of ISO 230-2, and a table for the drive with what it promises."
show axiscomp judge before.csv
show axiscomp fit before.csv --lookup-at encoder --method spline --points 81 --zero mean --tolerance A=5um \
    -o table.csv --record screw.axcal

say "8. The table of the record is written, switched on and proved."
show axiscomp write --axis X --record screw.axcal --own-position --persistent
show axiscomp activate --axis X --record screw.axcal
expect_active

say "9. Measured again at other targets, after the machine was switched off and on."
stop_drive
show axiscomp targets --from 0 --to 200 --count 9 --cycles 2 --overrun 20 --feed 100 --dwell 60 --seed 2 -o again.csv
start_drive "${machine[@]}" --program again.csv --program-after 3
show axiscomp activate --axis X --record screw.axcal
measure again.csv after.csv

say "10. Before and after, against what was promised; and one page for the file of the machine."
show axiscomp compare before.csv after.csv --record screw.axcal --keep
show axiscomp report screw.axcal -o screw.html
show axiscomp status --axis X
