#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the programs, and whatever else is named, in build/run: what ./run starts and what the
# packages hold. The log is build/run/build.log; its end is shown when the build fails.
#   packaging/build-programs.sh TARGET ...
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."

folder=build/run
log=$folder/build.log
mkdir -p "$folder"
configure() {
    # CMake sees by itself when its files change, but not the presets.
    if [ "$folder/build.ninja" -nt CMakePresets.json ]; then
        return
    fi
    local flags="-Wl,-z,relro,-z,now"
    if command -v mold >/dev/null; then
        flags+=" -fuse-ld=mold"
    fi
    # Libraries are installed where Debian has those of this kind of computer.
    cmake --preset run -DCMAKE_EXE_LINKER_FLAGS="-pie $flags" -DCMAKE_MODULE_LINKER_FLAGS="$flags" \
        -DCMAKE_INSTALL_LIBDIR="lib/$(c++ -print-multiarch)"
}
if ! { configure && cmake --build --preset run --target "$@"; } >"$log" 2>&1 </dev/null; then
    tail -n 40 "$log" >&2
    echo "The build failed; all of its output is in $log" >&2
    exit 1
fi
