#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the Debian packages in build/packages and checks them: lintian, what is in them, what they
# depend on, and that the packed programs run.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."

fail() {
    echo "$*" >&2
    exit 1
}

build=build/run # of ./run: the same programs
packaging/build-programs.sh all

output=$PWD/build/packages
rm -rf "$output"
cpack --config "$build/CPackConfig.cmake" -G DEB -B "$output" >"$build/cpack.log" 2>&1 || {
    cat "$build/cpack.log" >&2
    exit 1
}
shopt -s nullglob
programs=("$output"/axis-compensation-wizard_*.deb)
development=("$output"/axis-compensation-wizard-dev_*.deb)
if [ ${#programs[@]} -ne 1 ] || [ ${#development[@]} -ne 1 ]; then
    fail "two packages are expected in $output: $(ls "$output")"
fi

lintian --fail-on error --tag-display-limit 0 --allow-root "${programs[@]}" "${development[@]}"

depends=$(dpkg-deb --field "${programs[0]}" Depends)
for library in libc6 libstdc++6 libqt6core6 libqt6widgets6 libqcustomplot2.1-qt6 libcpp-httplib0.11 \
    libsqlite3-0 qt6-translations-l10n; do
    [[ $depends == *"$library"* ]] || fail "the programs do not depend on $library, but on: $depends"
done

files=$(dpkg-deb --contents "${programs[0]}" | awk '{print $6}')
for file in bin/axiscomp bin/axiscomp-virtualdrive bin/axis-compensation-wizard \
    share/man/man1/axiscomp.1.gz share/man/man1/axiscomp-virtualdrive.1.gz \
    share/man/man1/axis-compensation-wizard.1.gz share/bash-completion/completions/axiscomp \
    share/applications/axis-compensation-wizard.desktop \
    share/axiscomp/profiles/generic.json share/axiscomp/examples/calibration-2d.csv \
    share/axiscomp/schemas/axcal.schema.json share/axiscomp/machines/screw.json \
    share/doc/axis-compensation-wizard/copyright share/doc/axis-compensation-wizard/changelog.gz; do
    grep -qx "./usr/$file" <<<"$files" || fail "the package has no /usr/$file"
done
if grep -qE '/include/|\.a$|/cmake/' <<<"$files"; then
    fail "development files are in the package of the programs"
fi

unpacked=$(mktemp -d)
trap 'rm -rf "$unpacked"' EXIT
dpkg-deb --extract "${programs[0]}" "$unpacked"
for program in axiscomp axiscomp-virtualdrive axis-compensation-wizard; do
    "$unpacked/usr/bin/$program" --version
done
sha256sum -- "${programs[@]}" "${development[@]}" | sed "s|$output/||"

# Projects of their own build on what is installed.
version=$(sed -n 's/^project(AxisCompensationWizard VERSION \([^ ]*\) .*/\1/p' CMakeLists.txt)
cmake -DPROJECT_BUILD="$PWD/$build" -DVERSION="$version" -DWORK="$PWD/build/installed_parts" \
    -DCONSUMER="$PWD/tests/packaging/consumer" -DCOMPILER="$(command -v c++)" -DWINDOW=ON \
    -DEMBEDDING="$PWD/tests/packaging/embedding" -DEXAMPLE="$PWD/docs/embedding" \
    -P tests/packaging/installed_parts.cmake
