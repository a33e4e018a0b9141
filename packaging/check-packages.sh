#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the Debian packages in build/packages and checks them: lintian, what is in them, what they
# depend on, and that the packed programs run.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
export QT_QPA_PLATFORM=${QT_QPA_PLATFORM:-offscreen}

fail() {
    echo "$*" >&2
    exit 1
}

build=build/run # of ./run: the same programs
packaging/build-programs.sh axiscomp
# What is built for the packages alone; ./run does not need it. The package of the documentation is made where there
# is what makes the site that is in it (packages-develop.txt); ./test --all installs that.
names=(axis-compensation-wizard axiscomp axiscomp-report-pdf libaxiscomp-dev python3-axiscomp)
site=OFF
if command -v doxygen >/dev/null && command -v sphinx-build >/dev/null; then
    site=ON
    names+=(axiscomp-doc)
fi
cmake -DAXISCOMP_PYTHON=ON -DAXISCOMP_DOCUMENTATION=$site "$build" >"$build/python.log" 2>&1 || {
    cat "$build/python.log" >&2
    exit 1
}
packaging/build-programs.sh all

output=$PWD/build/packages
packaging/make-packages.sh "$build" "$output"
mapfile -t names < <(printf '%s\n' "${names[@]}" | sort)
mapfile -t made < <(cd "$output" && printf '%s\n' *.deb | sed 's/_.*//' | sort)
[ "${made[*]}" = "${names[*]}" ] || fail "other packages than ${names[*]} are in $output: ${made[*]}"

# It takes some bytes of machine code for misspelled words.
lintian --pedantic --display-info --fail-on error,warning,info,pedantic --tag-display-limit 0 --allow-root \
    --suppress-tags spelling-error-in-binary "$output"/*.deb

# package NAME: its file
package() {
    local files=("$output/$1"_*.deb)
    echo "${files[0]}"
}

# expect_field FIELD NAME ALTERNATIVE-OR-PART ...
expect_field() {
    local field=$1 name=$2 value part
    value=$(dpkg-deb --field "$(package "$name")" "$field")
    shift 2
    for part in "$@"; do
        [[ $value == *"$part"* ]] || fail "$name: $field has no $part, but: $value"
    done
}
expect_depends() {
    expect_field Depends "$@"
}

# expect_files NAME FILE-BELOW-USR ...
expect_files() {
    local name=$1 files file
    files=$(dpkg-deb --contents "$(package "$name")" | awk '{print $6}')
    shift
    for file in "$@" "share/doc/$name/copyright" "share/doc/$name/changelog.gz"; do
        grep -qx "./usr/$file" <<<"$files" || fail "$name has no /usr/$file"
    done
}

version=$(dpkg-deb --field "$(package axiscomp)" Version)
expect_depends axiscomp libc6 libstdc++6 libqt6core6 libqt6network6 libqt6serialport6 libcpp-httplib0.11 \
    libsqlite3-0
expect_depends axis-compensation-wizard "axiscomp (= $version)" libqt6widgets6 libqcustomplot2.1-qt6 \
    qt6-translations-l10n
expect_field Recommends axis-compensation-wizard axiscomp-report-pdf axiscomp-doc fonts-noto-cjk
expect_depends axiscomp-report-pdf "axiscomp (= $version)" libqt6gui6 fonts-dejavu-core
expect_field Recommends axiscomp-report-pdf fonts-noto-cjk
expect_depends python3-axiscomp "python3 (<< 3.12)" python3-numpy libqt6core6 libsqlite3-0
expect_depends libaxiscomp-dev qt6-base-dev libsqlite3-dev
for name in axiscomp python3-axiscomp; do
    if dpkg-deb --field "$(package $name)" Depends Recommends | grep -E 'qt6(gui|widgets)'; then
        fail "$name needs no desktop"
    fi
done

expect_files axiscomp bin/axiscomp bin/axiscomp-virtualdrive \
    share/man/man1/axiscomp.1.gz share/man/man1/axiscomp-virtualdrive.1.gz \
    share/man/de/man1/axiscomp.1.gz share/man/de/man1/axiscomp-virtualdrive.1.gz \
    share/bash-completion/completions/axiscomp share/bash-completion/completions/axiscomp-virtualdrive \
    share/fish/vendor_completions.d/axiscomp.fish share/zsh/vendor-completions/_axiscomp \
    share/axiscomp/profiles/generic.json share/axiscomp/schemas/axcal.schema.json \
    share/axiscomp/machines/screw.json share/axiscomp/examples/calibration-2d.csv \
    share/axiscomp/examples/machine.toml share/axiscomp/examples/tour.sh \
    "lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)/axiscomp/axiscomp-program.so"
expect_files axis-compensation-wizard bin/axis-compensation-wizard \
    share/man/man1/axis-compensation-wizard.1.gz share/man/de/man1/axis-compensation-wizard.1.gz \
    share/bash-completion/completions/axis-compensation-wizard \
    share/applications/axis-compensation-wizard.desktop \
    share/metainfo/org.axiscomp.wizard.metainfo.xml \
    share/mime/packages/org.axiscomp.wizard.xml \
    share/icons/hicolor/{16x16,22x22,24x24,32x32,48x48,64x64,128x128,256x256,512x512}/apps/axis-compensation-wizard.png \
    share/icons/hicolor/scalable/apps/axis-compensation-wizard.svg \
    share/icons/hicolor/symbolic/apps/axis-compensation-wizard-symbolic.svg
expect_files axiscomp-report-pdf "lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)/axiscomp/axiscomp-report-pdf.so"
if [ $site = ON ]; then
    expect_files axiscomp-doc share/doc/axiscomp-doc/user-guide.md share/doc/axiscomp-doc/pictures/active.png \
        share/doc/axiscomp-doc/html/index.html share/doc-base/axiscomp-doc.axiscomp
fi
expect_files libaxiscomp-dev "lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)/libaxiscomp_core.a" \
    include/axiscomp/core/base/result.h
expect_files python3-axiscomp lib/python3/dist-packages/axiscomp/__init__.py
for name in "${names[@]}"; do
    [ "$name" != libaxiscomp-dev ] || continue
    if dpkg-deb --contents "$(package "$name")" | grep -E '/include/|\.a$|/cmake/'; then
        fail "development files are in $name"
    fi
done
for first in "${names[@]}"; do
    dpkg-deb --contents "$(package "$first")" | awk '!/\/$/ {print $6}'
done | sort | uniq -d | { ! grep . || fail "these files are in two packages"; }

unpacked=$(mktemp -d)
trap 'rm -rf "$unpacked"' EXIT
for name in axiscomp axis-compensation-wizard axiscomp-report-pdf; do
    dpkg-deb --extract "$(package $name)" "$unpacked"
done
for program in axiscomp axiscomp-virtualdrive axis-compensation-wizard; do
    "$unpacked/usr/bin/$program" --version
done
# By itself, and by its module, which shows a language that there are no texts in as English.
"$unpacked/usr/bin/axiscomp" example --dims 1 -o "$unpacked/x.csv"
for command in --version formats "inspect $unpacked/x.csv" "convert $unpacked/x.csv $unpacked/x.TAMtbl --dims 1" \
    "convert --help"; do
    # shellcheck disable=SC2086 # words of a command
    diff <(LC_ALL=C.UTF-8 "$unpacked/usr/bin/axiscomp" $command 2>&1) \
        <(LC_ALL=fi_FI.UTF-8 "$unpacked/usr/bin/axiscomp" $command 2>&1) ||
        fail "axiscomp $command: its module says something else"
done
desktop-file-validate "$unpacked/usr/share/applications/axis-compensation-wizard.desktop"
grep -q "<release version=\"${version%-*}\"" "$unpacked"/usr/share/metainfo/*.xml ||
    fail "the metainfo has no release ${version%-*}"
appstreamcli validate --no-net --pedantic --explain "$unpacked"/usr/share/metainfo/*.xml
# Without the network nobody else looks whether the pictures are there.
while read -r width height picture; do
    [[ $(file --brief "docs/pictures/$picture") == "PNG image data, $width x $height,"* ]] ||
        fail "the metainfo names a picture $picture of $width x $height"
done < <(sed -n 's|.* width="\([0-9]*\)" height="\([0-9]*\)">.*/pictures/\(.*\)</image>|\1 \2 \3|p' \
    "$unpacked"/usr/share/metainfo/*.xml)
update-mime-database "$unpacked/usr/share/mime"

# The module as it is packed, and as a wheel of the same build; both load little when they are imported.
dpkg-deb --extract "$(package python3-axiscomp)" "$unpacked/module"
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
(cd "$output" && sha256sum -- *.deb)

# Projects of their own build on what is installed.
version=$(sed -n 's/^project(AxisCompensationWizard VERSION \([^ ]*\) .*/\1/p' CMakeLists.txt)
cmake -DPROJECT_BUILD="$PWD/$build" -DVERSION="$version" -DWORK="$PWD/build/installed_parts" \
    -DCONSUMER="$PWD/tests/packaging/consumer" -DCOMPILER="$(command -v c++)" -DWINDOW=ON \
    -DEMBEDDING="$PWD/tests/packaging/embedding" -DEXAMPLE="$PWD/docs/embedding" \
    -P tests/packaging/installed_parts.cmake
