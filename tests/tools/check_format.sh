#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Checks the form of every file that git knows or would add: clang-format 14, no tabs, no carriage
# returns, no blanks at line ends, a line break at the end, the licence in front; shellcheck for
# scripts. Prints what is wrong and fails. With --fix it formats the C++ files first.
set -euo pipefail
shopt -s lastpipe # complain counts in this shell, not in a child
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."

failures=0
# Prints a complaint and the lines of standard input, if there are any.
complain() {
    local lines
    lines=$(cat)
    if [ -n "$lines" ]; then
        printf '%s\n%s\n' "$1:" "$lines" >&2
        failures=1
    fi
}

# A checkout without git (an archive of the sources) is looked through as it is.
list_files() {
    if git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
        git ls-files --cached --others --exclude-standard -z
    else
        find . \( -path ./build -o -path ./.git \) -prune -o -type f -printf '%P\0'
    fi
}

files=() sources=() scripts=()
while IFS= read -r -d '' file; do
    # Deleted but not yet committed; data are whatever they have to be.
    case $file in
    tests/fuzz/corpus/* | tests/data/*) continue ;;
    esac
    [ -f "$file" ] || continue
    files+=("$file")
    case $file in
    *.cpp | *.h) sources+=("$file") ;;
    esac
    # A process for each of thousands of files would take longer than all else.
    first=
    IFS= read -r first <"$file" || true
    case $first in
    '#!/bin/sh'* | '#!/bin/bash'*) scripts+=("$file") ;;
    esac
done < <(list_files) 2>/dev/null
# An empty file has no text; grep -I takes what has a zero byte for binary.
mapfile -d '' -t texts < <(printf '%s\0' "${files[@]}" | xargs -0 grep -lIZ .)

if [ "${1:-}" = --fix ]; then
    printf '%s\0' "${sources[@]}" | xargs -0 -n 20 -P "$(nproc)" clang-format-14 -i
fi

printf '%s\0' "${sources[@]}" | xargs -0 -n 20 -P "$(nproc)" clang-format-14 --dry-run 2>&1 |
    sed -n 's/^\([^:]*\):.*code should be clang-formatted.*/\1/p' | sort -u |
    complain "Not as clang-format 14 has it (tests/tools/check_format.sh --fix)"
with_lines() {
    grep -nP "$1" "${texts[@]}" || true # finding none is what is wanted
}
with_lines '\t' | complain "A tab"
with_lines '\r$' | complain "A carriage return"
with_lines '[ \t]+$' | complain "Blanks at the end of a line"
{ printf '%s\0' "${texts[@]}" | xargs -0 grep -LzP '\n\z' || true; } | complain "No line break at the end"
for file in "${sources[@]}"; do
    IFS= read -r first <"$file" || true
    [ "$first" = '// SPDX-License-Identifier: GPL-3.0-or-later' ] || echo "$file"
done | complain "The first line is not // SPDX-License-Identifier: GPL-3.0-or-later"
licence='# SPDX-License-Identifier: GPL-3.0-or-later'
for file in "${texts[@]}"; do
    case $file in
    *CMakeLists.txt | *.cmake | *.sh | *.py | run | test | .ci/run)
        { IFS= read -r first && IFS= read -r second; } <"$file" || true
        [[ "$first" == "$licence" || "$second" == "$licence" ]] || echo "$file"
        ;;
    esac
done | complain "No # SPDX-License-Identifier: GPL-3.0-or-later in the first two lines"
{ shellcheck "${scripts[@]}" || true; } | complain "shellcheck"
for file in "${scripts[@]}"; do
    [ -x "$file" ] || echo "$file"
done | complain "A script that cannot be executed"

if [ "$failures" -eq 0 ]; then
    echo "${#sources[@]} C++ files, ${#texts[@]} text files, ${#scripts[@]} scripts: all in order"
fi
exit "$failures"
