#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the packages of build/packages in a bare Debian 12 with apt, uses them as a stranger would, removes
# them, and compares the files before and after. Needs root and Debian's packages; where these come from is what
# the apt of this computer has. The log and pictures of the window are in build/installation.
#   packaging/check-installation.sh [PACKAGES-FOLDER]
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
exec </dev/null # nobody answers a question
packages=$(readlink -f "${1:-build/packages}")
output=$PWD/build/installation

fail() {
    echo "failed: $*" >&2
    exit 1
}
[ "$(id -u)" -eq 0 ] || fail "only root can make a bare system: sudo $0"
for name in axiscomp axiscomp-doc; do
    compgen -G "$packages/${name}_*.deb" >/dev/null ||
        fail "no $name in $packages: packaging/install-packages.sh packaging/packages-develop.txt, then packaging/check-packages.sh"
done

rm -rf "$output"
mkdir -p "$output"
work=$(mktemp -d "${TMPDIR:-/var/tmp}/axiscomp-installation-XXXXXX")
root=$work/root
home=$root/tmp/user
trap 'rm -rf --one-file-system "$work"' EXIT

# in_root COMMAND ...: in the bare system, as root. Its mounts and whatever it started end with it.
in_root() {
    # shellcheck disable=SC2016 # the inner shell expands its own arguments
    unshare --mount --pid --fork --kill-child --propagation private bash -c '
        set -e
        mount -t proc proc "$1/proc"
        mount --rbind /dev "$1/dev"
        mount -t tmpfs tmpfs "$1/run"
        exec chroot "$@"' bash "$root" \
        env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"
}
# as_user: the script of standard input, in a folder of an ordinary user.
as_user() {
    in_root setpriv --reuid 1000 --regid 1000 --clear-groups \
        env HOME=/tmp/user XDG_RUNTIME_DIR=/tmp/user bash -euo pipefail -c "cd; $(cat)"
}
step() {
    printf '\n== %s (%d:%02d)\n' "$1" $((SECONDS / 60)) $((SECONDS % 60))
}
apt_get() {
    in_root apt-get --quiet=2 --yes -o Acquire::Retries=3 -o Dpkg::Use-Pty=0 "$@"
}
# install NAME ...: of the packages that are checked, as apt installs them for anybody.
install() {
    local name files=()
    for name in "$@"; do
        files+=("/packages/$(basename "$packages/${name}"_*.deb)")
    done
    apt_get install "${files[@]}"
}
installed() {
    in_root dpkg --get-selections | awk '$2 == "install" {print $1}' | sort
}
# Without what changes whatever is installed: lists, caches and logs of Debian's own tools.
list_files() {
    (cd "$root" && find . \( -path ./packages -o -path ./tmp -o -path ./proc -o -path ./sys -o -path ./dev -o -path ./run \
        -o -path ./var/cache -o -path ./var/lib/apt -o -path ./var/lib/dpkg -o -path ./var/log \) \
        -prune -o -printf '%p %y %m %l\n' | sort)
}
# expect TEXT PART
expect() {
    [[ $1 == *"$2"* ]] || fail "\"$2\" is expected in: $1"
}

make_bare_system() {
    # apt.conf.d may say how the mirror is reached; nothing else of it belongs to a bare system.
    apt-config dump | grep -E '^Acquire::(https?|ftp)(::| )' >"$work/apt.conf" || true
    local sources=()
    mapfile -t sources < <(grep -ls bookworm /etc/apt/sources.list /etc/apt/sources.list.d/*.{list,sources} || true)
    # It mounts there, too, and a mount that is left behind could not be deleted.
    unshare --mount --pid --fork --kill-child --mount-proc --propagation private \
        mmdebstrap --quiet --mode=root --variant=minbase --aptopt="$work/apt.conf" --skip=cleanup/apt/lists \
        bookworm "$root" "${sources[@]}"
    cp /etc/resolv.conf "$root/etc/resolv.conf"
    mkdir -p "$root/packages" "$home"
    cp "$packages"/*.deb "$root/packages"
    chown -R 1000:1000 "$home"
    list_files >"$work/before"
    installed >"$work/installed"
}

# doctor: what it says; it changes nothing, and the computer may have problems.
doctor() {
    # shellcheck disable=SC2016 # the shell in there expands it
    as_user <<<'axiscomp doctor --drive demo: || [ $? -eq 10 ]'
}

check_command_line() {
    install axiscomp
    if installed | grep -E '^libqt6(gui|widgets)'; then
        fail "axiscomp brings a desktop"
    fi
    as_user <<'END'
axiscomp --version
axiscomp axes --drive demo:
END
    step "What doctor says"
    local said
    said=$(doctor)
    echo "$said"
    expect "$said" "install the package axis-compensation-wizard"
    expect "$said" "install the package axiscomp-report-pdf"
    step "The tour"
    as_user <<<"/usr/share/axiscomp/examples/tour.sh"
}

check_report() {
    as_user <<'END'
axiscomp targets --from 0 --to 200 --count 9 --cycles 2 --overrun 20 --feed 100 --dwell 60 -o plan.csv
axiscomp-virtualdrive --machine /usr/share/axiscomp/machines/screw.json --program plan.csv \
    --program-after 3 --speed 60 --http 127.0.0.1:8123 >ready &
until [ -s ready ]; do sleep 0.1; done
export AXISCOMP_DRIVE=http://127.0.0.1:8123
axiscomp capture --axis 0 --plan plan.csv --dwell 0.1 --average 3 --rate 50 -o before.csv \
    --reference 'Machine/Axes[0]/ReferencePosition' >capture.log
axiscomp fit before.csv --lookup-at encoder --points 21 -o table.csv --record x.axcal >fit.log
axiscomp report x.axcal -o x.html
END
    expect "$(as_user <<<'axiscomp report x.axcal -o x.pdf 2>&1 || true')" "install the package axiscomp-report-pdf"
    install axiscomp-report-pdf
    as_user <<<'axiscomp report x.axcal -o x.pdf'
    expect "$(head -c 5 "$home/x.pdf")" "%PDF-"
    cp "$home/x.pdf" "$output/report.pdf"
}

check_https() {
    apt_get install --no-install-recommends openssl
    local said
    said=$(as_user <<'END'
openssl req -x509 -newkey rsa:2048 -nodes -keyout key.pem -out drive.pem -days 2 -subj /CN=localhost 2>openssl.log
axiscomp-virtualdrive --http 127.0.0.1:8124 --certificate drive.pem --key key.pem >ready2 &
until [ -s ready2 ]; do sleep 0.1; done
axiscomp axes --drive https://127.0.0.1:8124 2>&1 || true
print=$(openssl x509 -in drive.pem -noout -fingerprint -sha256 | cut -d= -f2)
axiscomp axes --drive https://127.0.0.1:8124 --trust-certificate "$print"
END
    )
    echo "$said"
    expect "$said" "ertificate"
    expect "$said" "Virtual-1"
}

# open_on_display FILE: as a double click does it; a picture of what is seen then.
open_on_display() {
    as_user <<END
rm -f /tmp/.X7-lock /tmp/.X11-unix/X7 # of the display before, which ended with its processes
Xvfb :7 -screen 0 1280x800x24 >xvfb.log 2>&1 &
export DISPLAY=:7
for ((i = 0; i < 100; i++)); do
    xdpyinfo >/dev/null 2>&1 && break
    sleep 0.2
done
xdg-open $1 &
for ((i = 0; i < 100; i++)); do
    xwininfo -root -tree | grep -q 'Axis Compensation Wizard' && break
    sleep 0.2
done
xwininfo -root -tree | grep -m 1 'Axis Compensation Wizard'
sleep 5
xwd -root -silent | xwdtopnm 2>netpbm.log | pnmtopng 2>>netpbm.log >window.png
END
    cp "$home/window.png" "$output/${1%.*}.png"
}

check_window() {
    install axis-compensation-wizard axiscomp-doc
    apt_get install --no-install-recommends desktop-file-utils libfile-mimeinfo-perl netpbm x11-apps x11-utils xdg-utils xvfb
    local said
    said=$(doctor)
    expect "$said" /usr/bin/axis-compensation-wizard
    expect "$said" "HTML, PDF"
    [ -e "$root/usr/share/doc/axiscomp-doc/html/index.html" ] || fail "the window's Help has nothing to open"
    local types
    types=$(as_user <<'END'
axiscomp example --dims 1 -o e.csv
axiscomp convert e.csv Small1.TAMtbl --dims 1 --table 1 >convert.log
sed 's#http://[^"]*#http://127.0.0.1:9#' /usr/share/axiscomp/examples/machine.toml >machine.toml # nothing but loopback is asked
for file in x.axcal Small1.TAMtbl machine.toml e.csv; do
    type=$(xdg-mime query filetype "$file")
    echo "$file: $type, $(xdg-mime query default "$type")."
done
END
    )
    echo "$types"
    expect "$types" "x.axcal: application/vnd.axiscomp.record+json, axis-compensation-wizard.desktop."
    expect "$types" "Small1.TAMtbl: application/x-tamtbl, axis-compensation-wizard.desktop."
    expect "$types" "machine.toml: application/vnd.axiscomp.machine, axis-compensation-wizard.desktop."
    expect "$types" "e.csv: text/csv, ."
    local file
    for file in x.axcal Small1.TAMtbl machine.toml; do
        open_on_display "$file"
    done
}

check_libraries() {
    install python3-axiscomp libaxiscomp-dev
    as_user <<<'python3 -c "import axiscomp; print(axiscomp.example(dims=1, output=\"py.csv\"))"'
    apt_get install --no-install-recommends cmake g++ make
    cp -a tests/packaging/consumer "$home/consumer"
    chown -R 1000:1000 "$home/consumer"
    as_user <<<'cmake -S consumer -B consumer/build >cmake.log; cmake --build consumer/build; consumer/build/consumer state'
}

check_removal() {
    apt_get purge axis-compensation-wizard axiscomp axiscomp-doc axiscomp-report-pdf libaxiscomp-dev python3-axiscomp
    list_files >"$work/without"
    if grep -iE 'axiscomp|axis-compensation|tamtbl|tamcfg' "$work/without"; then
        fail "these files are left behind"
    fi
    local added=()
    mapfile -t added < <(comm -13 "$work/installed" <(installed))
    apt_get purge "${added[@]}"
    list_files >"$work/after"
    diff "$work/before" "$work/after" || true
}

check() {
    step "A bare Debian 12"
    make_bare_system
    step "The command line alone"
    check_command_line
    step "A report as PDF, without its package and with it"
    check_report
    step "https"
    check_https
    step "The window, and files that are opened by double click"
    check_window
    step "Python and the development files"
    check_libraries
    step "Removed"
    check_removal
    step "Done"
}

check 2>&1 | tee "$output/log"
