#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs those packages of the lists (files with one Debian package a line) that are missing.
# Asks nothing; does nothing, and needs no network, when all are there.
set -euo pipefail

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    echo "This is not a Debian system. Install what $* name in your own way, and call cmake yourself:" >&2
    echo "the presets are in CMakePresets.json." >&2
    exit 1
fi

mapfile -t wanted < <(sed -e 's/#.*//' -e 's/[[:space:]]//g' -e '/^$/d' "$@" | sort -u)
mapfile -t installed < <(
    # Names that dpkg has never heard of make it fail; the others are still listed.
    dpkg-query --show --showformat='${db:Status-Status} ${Package}\n' "${wanted[@]}" 2>/dev/null |
        sed -n 's/^installed //p' | sort -u
)
mapfile -t missing < <(
    comm -23 <(printf '%s\n' "${wanted[@]}") <(printf '%s\n' "${installed[@]}")
)
if [ ${#missing[@]} -eq 0 ]; then
    exit 0
fi

echo "Installing ${#missing[@]} Debian packages: ${missing[*]}"
as_root=()
if [ "$(id -u)" -ne 0 ]; then
    # Without a terminal nobody can type a password.
    if command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
        as_root=(sudo)
    else
        echo "This needs root. Run as root, then try again:" >&2
        echo "    apt-get update && apt-get install --no-install-recommends ${missing[*]}" >&2
        exit 1
    fi
fi
apt=(
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive
    apt-get --quiet=2 -o Acquire::Retries=3 -o DPkg::Lock::Timeout=600 -o Dpkg::Use-Pty=0
)
"${apt[@]}" update
"${apt[@]}" install --yes --no-install-recommends "${missing[@]}" </dev/null >/dev/null
