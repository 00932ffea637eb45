#!/bin/sh
# Every text of the window has its German: lupdate finds nothing new, and nothing is unfinished.
# translation_test.sh SOURCE_FOLDER
set -eu
cd "$1"
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
cp widgets/translations/roverstudio_de.ts "$copy/de.ts"
/usr/lib/qt6/bin/lupdate -silent -locations none -no-obsolete -I . widgets app/roverstudio -ts "$copy/de.ts" >/dev/null 2>&1
if grep -B2 'type="unfinished"' "$copy/de.ts" | grep '<source>'; then
    echo "These have no German: ./dev translate takes them into widgets/translations."
    exit 1
fi
[ "$(grep -c '<translation' "$copy/de.ts")" -gt 800 ]
