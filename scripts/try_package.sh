#!/usr/bin/env bash
# Makes the Debian packages of the release build, installs them in a bare Debian 12 and runs them there: program and module solve, and
# with --development a project builds against the libraries.
# As root, with debootstrap and a network. The bare system lives in a folder of its own, which vanishes at the end.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
build="$root/build/release"
bare=$(mktemp -d -t railpem-bare-XXXXXX)
mirror=${MIRROR:-http://deb.debian.org/debian}
trap 'umount -q "$bare/proc" || true; rm -rf --one-file-system "$bare"' EXIT

(cd "$build" && cpack -B "$build/packages")
debootstrap --variant=minbase bookworm "$bare" "$mirror" > /dev/null
# Packages are read by the user of apt.
chmod 755 "$bare"
mount -t proc proc "$bare/proc"
cp "$build"/packages/*.deb "$bare/root/"
inside() { chroot "$bare" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root "$@"; }

packages=(/root/railpem_*.deb /root/python3-railpem_*.deb)
[ "${1:-}" = --development ] && packages+=(/root/librailpem-dev_*.deb cmake make)
inside apt-get -q update > /dev/null
inside sh -c "DEBIAN_FRONTEND=noninteractive apt-get -q install -y --no-install-recommends ${packages[*]}" > "$bare/install.log" || { cat "$bare/install.log"; exit 1; }

cases=/usr/share/railpem/cases
inside railpem --version
inside railpem solve $cases/wei2016/case3.toml --out /tmp/solved
inside railpem inspect $cases/concealed --case $cases/wei2016/case1.toml > /dev/null
inside python3 -c "import railpem; print('module', railpem.__version__, railpem.solve(railpem.Case('$cases/wei2016/case3.toml')).psd.max())"
if [ "${1:-}" = --development ]; then
    cp -r "$root/tests/install/dependent" "$bare/root/dependent"
    inside sh -c "cmake -S /root/dependent -B /root/built > /dev/null && cmake --build /root/built > /dev/null && /root/built/dependent $cases/wei2016/case3.toml"
fi
inside apt-get -q purge -y railpem python3-railpem > /dev/null
for trace in share/railpem bin/railpem lib/python3/dist-packages/railpem; do
    [ ! -e "$bare/usr/$trace" ] || { echo "left behind: /usr/$trace"; exit 1; }
done
echo "installed, ran and was removed without a trace"
