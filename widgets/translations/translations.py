"""The texts of the sources and their translations, in the root folder:

translations.py collect FILE   takes the texts into FILE, a .ts of Qt
translations.py check FILE     prints what is wrong, and fails then:
  - a text without German in FILE;
  - German of a sentence of simcore whose placeholders are not those of the English;
  - a sentence in the sources of simcore and render outside of Text::of() and Text::mark().

Texts of the window are in tr(), which lupdate finds. Those of simcore (simcore/base/text.h) it would
find in part only, under changing contexts; so they are read here and handed to it in a file.
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as tree

CONTEXT = "simcore"

# Texts with blanks that are not for people, or that are put into words elsewhere: file, pattern
# of the text, why.
EXCEPTIONS = [
    ("simcore/project/|simcore/mobility/joint_choices", "^(turn|slide) ", "free directions, as in files"),
    ("simcore/project/(resolve|scenario_values)", r"^(angular speed|torsional \w+)$",
     "dimensions, marked in units.cpp"),
    ("simcore/mobility/mobility.cpp", "^contact $", "name of a contact; the window has its own words"),
    ("simcore/statics/static_study.cpp", "^[a-z-]+ $", "flags; the window has its own words"),
    ("simcore/sensors/", "^[a-z ]+$", "names of streams of random numbers"),
    ("simcore/io/(statics_tables|experiment_json).cpp", ",", "columns of CSV"),
    ("simcore/io/terrain_export.cpp", "metres, |^ncols", "files of terrain"),
    ("simcore/run/channels.cpp", r"^\| column", "docs/csv.md"),
    ("render/look/shaders.cpp", "^#", "programs of the graphics card"),
    ("render/scene.cpp", "^[a-z ]+$", "names of nodes"),
]

TOKEN = re.compile(
    r"""(?P<skip>//[^\n]*|/\*.*?\*/|^[ \t]*\#[^\n]*|R"\w*\(.*?\)\w*"|'(?:[^'\\\n]|\\.)+'|\d[\w.']*)"""
    r"""|(?P<string>(?:"(?:[^"\\\n]|\\.)*"\s*)+)|(?P<other>\w+|\S)""", re.S | re.M)
PIECE = re.compile(r'"((?:[^"\\]|\\.)*)"')


def texts(folders):
    """(place, text as written, whether it is translated, whether it is in a throw) of all literals."""
    for folder in folders:
        for path in sorted(pathlib.Path(folder).rglob("*")):
            if path.suffix not in (".h", ".cpp"):
                continue
            source = path.read_text()
            before = []  # what stands between the last ; { or } and the text
            for token in TOKEN.finditer(source):
                if token["other"] is not None:
                    before = [] if token[0] in ";{}" else before + [token[0]]
                elif token["string"] is not None:
                    translated = before[-5:] in (["Text", ":", ":", "of", "("],
                                                 ["Text", ":", ":", "mark", "("])
                    # A caller's mistake is told to developers.
                    yield (f"{path}:{source.count(chr(10), 0, token.start()) + 1}",
                           "".join(PIECE.findall(token[0])), translated,
                           bool({"throw", "static_assert"} & set(before)))
                    before.append('"')


def is_sentence(text):
    return re.search(r"[A-Za-z]{2}[,;:.')]* +[\w('{<]|[\w}'),] +[a-z]{2}|[a-z]{2} $|[a-z]{2}\.$", text)


def bypassing():
    for place, text, translated, thrown in texts(["simcore", "render"]):
        if not translated and not thrown and is_sentence(text) and not any(
                re.search(file, place) and re.search(pattern, text) for file, pattern, _ in EXCEPTIONS):
            yield f"{place}: not in Text::of(): {text!r}"


def placeholders(pattern):
    """The arguments with their formats, {("0", ".2f"), ...}; None: no pattern."""
    plain = pattern.replace("{{", "").replace("}}", "")
    fields = re.findall(r"\{(\d*)(?::([^{}]*))?\}", plain)
    numbered = [number for number, _ in fields if number]
    if re.search(r"[{}]", re.sub(r"\{\d*(:[^{}]*)?\}", "", plain)) or len(numbered) not in (0, len(fields)):
        return None
    return {(number or str(i), form) for i, (number, form) in enumerate(fields)}


def wrong_translations(file):
    for context in tree.parse(file).getroot().iter("context"):
        for message in context.iter("message"):
            name, source = context.findtext("name"), message.findtext("source")
            german = message.findtext("translation")
            if message.find("translation").get("type") or not german:
                yield f"no German: {name}: {source!r}"
            elif name == CONTEXT and placeholders(source) != placeholders(german):
                yield f"other placeholders: {source!r} -> {german!r}"


def collect(file):
    found = sorted({text for _, text, translated, _ in texts(["simcore", "render", "widgets"]) if translated})
    with tempfile.TemporaryDirectory() as folder:
        sentences = pathlib.Path(folder) / "sentences.cpp"
        sentences.write_text("".join(f'QT_TRANSLATE_NOOP("{CONTEXT}", "{text}");\n' for text in found))
        # -I lets lupdate tell the classes' namespaces.
        subprocess.run(["/usr/lib/qt6/bin/lupdate", "-silent", "-locations", "none", "-no-obsolete", "-I", ".",
                        "widgets", "app/roverstudio", str(sentences), "-ts", file],
                       check=True, stderr=subprocess.DEVNULL)


if __name__ == "__main__":
    command, file = sys.argv[1:]
    if command == "collect":
        collect(file)
    else:
        wrong = [*wrong_translations(file), *bypassing()]
        for line in wrong:
            print(line)
        sys.exit(1 if wrong else 0)
