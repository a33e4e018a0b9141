#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the pictures of the README and of the user guide again, from the states that the target
# wizard-pictures renders. Usage: docs/pictures/make.sh [BUILD-FOLDER]
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."

build=${1:-build/dev}
# STATE-PALETTE-LANGUAGE-SIZE, as wizard-pictures names them, and the name here
pictures=(
    first-start-light-en-1280x720:first-start
    unwritten-2d-light-en-1280x720:unwritten-2d
    write-preview-light-en-1280x720:write-preview
    active-light-en-1280x720:active
    bad-file-light-en-1280x720:bad-file
    table-3d-light-en-1280x720:table-3d
    unwritten-2d-dark-de-1280x720:unwritten-2d-dark-german
    measure-values-light-en-1280x720:measure-values
    fit-light-en-1280x720:fit
    judge-figures-light-en-1280x720:judge-figures
    prove-kept-light-en-1280x720:prove-kept
)
cmake --build "$build" --target axiscomp-wizard-pictures
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
QT_QPA_PLATFORM=offscreen LC_ALL=C.UTF-8 "$build/bin/axiscomp-wizard-pictures" "$work" \
    first-start unwritten-2d write-preview active bad-file table-3d measure-values judge-figures fit prove-kept
for picture in "${pictures[@]}"; do
    target=docs/pictures/${picture#*:}.png
    cp "$work/${picture%%:*}.png" "$target"
    size=$(stat --format=%s "$target")
    if [ "$size" -gt 200000 ]; then
        echo "$target has $size bytes, more than 200000" >&2
        exit 1
    fi
done
ls -l docs/pictures/*.png
