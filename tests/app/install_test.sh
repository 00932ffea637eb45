#!/bin/sh
# Installs the Debian package of a build with apt, starts its programs as a user would, and removes
# it. All of this happens to a copy of the running system that is gone afterwards (an overlay in
# memory, in a mount namespace of its own), so it needs root on Debian; elsewhere it is skipped.
# install_test.sh BUILD_FOLDER
set -eu
skip() { echo "skipped: $1"; exit 77; }
build=$1
if [ "${2:-}" != inside ]; then
    [ "$(id -u)" -eq 0 ] || skip "only root can install"
    command -v apt-get >/dev/null || skip "there is no apt"
    unshare --mount true 2>/dev/null || skip "no mount namespaces here"
    exec unshare --mount --propagation private "$0" "$build" inside
fi
root=$(mktemp -d)
trap 'umount -l "$root" 2>/dev/null || true; rmdir "$root"' EXIT
mount -t tmpfs tmpfs "$root" || skip "no file system in memory"
mkdir "$root/changes" "$root/work" "$root/system" "$root/package"
mount -t overlay overlay -o "lowerdir=/,upperdir=$root/changes,workdir=$root/work" "$root/system" 2>/dev/null ||
    skip "no overlay of the system"
mount --rbind /proc "$root/system/proc"
mount --rbind /dev "$root/system/dev"
cpack -G DEB --config "$build/CPackConfig.cmake" -B "$root/package" >"$root/log" 2>&1 ||
    { cat "$root/log"; exit 1; }
mkdir -p "$root/system/var/install_test/home" "$root/system/var/install_test/runtime"
chmod 700 "$root/system/var/install_test/runtime"
cp "$root"/package/*.deb "$root/system/var/install_test/roverstudio.deb"

# Only what the package brings is on the path and in the home folder.
within() {
    chroot "$root/system" env -i PATH=/usr/bin:/usr/sbin:/bin:/sbin LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
        HOME=/var/install_test/home XDG_RUNTIME_DIR=/var/install_test/runtime QT_QPA_PLATFORM=offscreen "$@"
}
has() { within sh -c "command -v $1" >/dev/null; }
fail() { echo "$1"; exit 1; }

if has roverstudio; then within apt-get remove -y -qq roverstudio >/dev/null; fi
within apt-get install -y -qq -o Dpkg::Use-Pty=0 --no-install-recommends /var/install_test/roverstudio.deb
within dpkg --verify roverstudio
within ldd /usr/bin/roverstudio /usr/bin/roversim | grep 'not found' && fail "libraries are missing"
within roversim new shrimp --output /var/install_test/shrimp.rover
within roversim validate /var/install_test/shrimp.rover
within roverstudio /usr/share/roverstudio/projects/solero.rover --size 800x600 \
    --screenshot /var/install_test/studio.png
[ "$(stat -c %s "$root/system/var/install_test/studio.png")" -gt 20000 ] || fail "the picture is empty"
within apt-get purge -y -qq -o Dpkg::Use-Pty=0 roverstudio
if has roverstudio || has roversim; then fail "programs are left"; fi
[ ! -e "$root/system/usr/share/roverstudio" ] || fail "files are left"
