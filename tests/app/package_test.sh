#!/bin/sh
# Makes the Debian package of a build, unpacks it into an empty folder and starts its programs there.
# package_test.sh BUILD_FOLDER
set -eu
build=$1
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
mkdir "$root/package" "$root/tree" "$root/home" "$root/runtime"
chmod 700 "$root/runtime"
cpack -G DEB --config "$build/CPackConfig.cmake" -B "$root/package" >"$root/log" 2>&1 ||
    { cat "$root/log"; exit 1; }
deb=$(echo "$root"/package/*.deb)
dpkg-deb -f "$deb" Depends | grep -q libode || { echo "depends on no engine"; exit 1; }
dpkg-deb -x "$deb" "$root/tree"
usr=$root/tree/usr
for file in share/applications/roverstudio.desktop share/mime/packages/roverstudio.xml \
    share/icons/hicolor/scalable/apps/roverstudio.svg share/man/man1/roverstudio.1 \
    share/man/man1/roversim.1 share/doc/roverstudio/copyright share/roverstudio/docs/studio.md \
    share/roverstudio/docs/pictures/guide-statics.png; do
    [ -f "$usr/$file" ] || { echo "missing: $file"; exit 1; }
done
# Every verb has its line in the manual.
"$usr/bin/roversim" --help | sed -n 's/^  \([a-z][a-z-]*\)  .*/\1/p' | grep -v '^worker$' | while read -r verb; do
    grep -q "^\.It.*Cm $verb" "$usr/share/man/man1/roversim.1" || { echo "no manual: $verb"; exit 1; }
done
"$usr/bin/roversim" --version
"$usr/bin/roversim" mobility "$usr/share/roverstudio/projects/solero.rover" | grep -q redundant
# The templates that are found are those of the package.
rm "$usr/share/roverstudio/templates/rocker_bogie_gear.rover"
if "$usr/bin/roversim" new | grep -q rocker_bogie_gear; then echo "templates from elsewhere"; exit 1; fi
"$usr/bin/roversim" new shrimp --output "$root/shrimp.rover"
"$usr/bin/roversim" validate "$root/shrimp.rover"
HOME=$root/home XDG_RUNTIME_DIR=$root/runtime "$usr/bin/roverstudio" \
    "$usr/share/roverstudio/projects/solero.rover" --size 800x600 --screenshot "$root/studio.png"
[ "$(stat -c %s "$root/studio.png")" -gt 20000 ]
