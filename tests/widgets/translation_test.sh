#!/bin/sh
# Every text of the window and every sentence of simcore has its German, with the same
# placeholders, and no sentence of simcore is said past simcore/base/text.h.
# translation_test.sh SOURCE_FOLDER
set -eu
cd "$1"
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
tool=widgets/translations/translations.py
cp widgets/translations/roverstudio_de.ts "$copy/de.ts"
python3 $tool collect "$copy/de.ts"
python3 $tool check "$copy/de.ts" || {
    echo "./dev translate takes texts without German into widgets/translations."
    exit 1
}
[ "$(grep -c '<translation' "$copy/de.ts")" -gt 1500 ]

# The check can fail: German that is missing, that lacks an argument, that cannot be formatted.
fails() { # fails SED_COMMAND MESSAGE
    sed "$1" "$copy/de.ts" >"$copy/broken.ts"
    if python3 $tool check "$copy/broken.ts" >"$copy/said" || ! grep -q "$2" "$copy/said"; then
        echo "not noticed: $1"
        exit 1
    fi
}
fails 's|<translation>Gelenk {}</translation>|<translation></translation>|' "no German: simcore: 'joint {}'"
fails 's|<translation>Gelenk {}</translation>|<translation>Gelenk</translation>|' 'other placeholders'
fails 's|<translation>Gelenk {}</translation>|<translation>Gelenk {0} {}</translation>|' 'other placeholders'
fails 's|<translation>Gelenk {}</translation>|<translation>Gelenk {</translation>|' 'other placeholders'
mkdir -p "$copy/simcore" "$copy/render"
printf 'return Text::of("a b c.");\nreturn "one joint" " lacks a body.";\n' >"$copy/simcore/planted.cpp"
(cd "$copy" && ! python3 "$1/$tool" check de.ts >said)
[ "$(cat "$copy/said")" = "simcore/planted.cpp:2: not in Text::of(): 'one joint lacks a body.'" ]
