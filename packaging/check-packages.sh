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
packaging/build-programs.sh axiscomp
# What is built for the packages alone; ./run does not need it.
cmake -DAXISCOMP_PYTHON=ON "$build" >"$build/python.log" 2>&1 || {
    cat "$build/python.log" >&2
    exit 1
}
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
python=("$output"/python3-axiscomp_*.deb)
if [ ${#programs[@]} -ne 1 ] || [ ${#development[@]} -ne 1 ] || [ ${#python[@]} -ne 1 ]; then
    fail "three packages are expected in $output: $(ls "$output")"
fi

lintian --fail-on error --tag-display-limit 0 --allow-root \
    "${programs[@]}" "${development[@]}" "${python[@]}"

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

# The module as it is packed, and as a wheel of the same build; both are imported in 60 ms.
depends=$(dpkg-deb --field "${python[0]}" Depends)
for package in "python3 (<< 3.12)" python3-numpy libqt6core6 libsqlite3-0; do
    [[ $depends == *"$package"* ]] || fail "the Python module does not depend on $package, but on: $depends"
done
dpkg-deb --extract "${python[0]}" "$unpacked/module"
AXISCOMP_BUILD=$PWD/$build /usr/bin/python3 -m pip --quiet --disable-pip-version-check wheel \
    --no-index --no-deps --no-build-isolation --wheel-dir "$unpacked" .
/usr/bin/python3 -m pip --quiet --disable-pip-version-check install --no-index --no-deps \
    --target "$unpacked/wheel" "$unpacked"/axiscomp-*.whl
for folder in "$unpacked/module/usr/lib/python3/dist-packages" "$unpacked/wheel"; do
    PYTHONPATH=$folder:tests/python /usr/bin/python3 -P -m unittest -q test_import
    PYTHONPATH=$folder /usr/bin/python3 -P -c "
import axiscomp
table = axiscomp.Table([0, 0.002], [(0, 10, 'mm')], unit='mm')
assert float(table.lookup(5)) - 0.001 < 1e-9 and axiscomp.resample(table, points=3).values.size == 3"
done
sha256sum -- "${programs[@]}" "${development[@]}" "${python[@]}" | sed "s|$output/||"

# Projects of their own build on what is installed.
version=$(sed -n 's/^project(AxisCompensationWizard VERSION \([^ ]*\) .*/\1/p' CMakeLists.txt)
cmake -DPROJECT_BUILD="$PWD/$build" -DVERSION="$version" -DWORK="$PWD/build/installed_parts" \
    -DCONSUMER="$PWD/tests/packaging/consumer" -DCOMPILER="$(command -v c++)" -DWINDOW=ON \
    -DEMBEDDING="$PWD/tests/packaging/embedding" -DEXAMPLE="$PWD/docs/embedding" \
    -P tests/packaging/installed_parts.cmake
