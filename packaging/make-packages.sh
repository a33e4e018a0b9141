#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the Debian packages of a build folder that has everything built. The same sources give the same bytes:
# no file in a package is newer or older than the last commit.
#   packaging/make-packages.sh BUILD-FOLDER OUTPUT-FOLDER
set -euo pipefail
build=$(readlink -f "${1:?usage: make-packages.sh BUILD-FOLDER OUTPUT-FOLDER}")
output=$(readlink -m "${2:?usage: make-packages.sh BUILD-FOLDER OUTPUT-FOLDER}")
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."

# Sources without git are as old as the newest entry of the package's changelog.
if [ -z "${SOURCE_DATE_EPOCH:-}" ]; then
    SOURCE_DATE_EPOCH=$(git log -1 --format=%ct 2>/dev/null ||
        date --date="$(sed -n 's/^ -- .*>  //p' packaging/debian/changelog.in | head -n 1)" +%s)
fi
export SOURCE_DATE_EPOCH

rm -rf "$output"
if ! cpack --config "$build/CPackConfig.cmake" -G DEB -B "$output" >"$build/cpack.log" 2>&1; then
    cat "$build/cpack.log" >&2
    exit 1
fi
rm -rf "$output/_CPack_Packages"
