#!/usr/bin/env python3
"""Reads a table as its users do and says what is wrong. Exit 0 good, 1 bad, 77 reader not there."""
import csv
import math
import os
import shutil
import subprocess
import sys
import tempfile


def fail(why):
    print(why)
    sys.exit(1)


def by_csv_module(path):
    with open(path, newline="", encoding="utf-8") as f:
        table = list(csv.reader(f, strict=True))
    header, rows = table[0], table[1:]
    numbers = [[float(c) if c else math.nan for c in row] for row in rows]
    return header, numbers


def by_pandas(path):
    try:
        import pandas
    except ImportError:
        sys.exit(77)
    # pandas' default parser may be off in the last digit; round_trip is exact.
    table = pandas.read_csv(path, float_precision="round_trip")
    if any(t.kind not in "fi" for t in table.dtypes):
        fail("pandas does not see a number in every column")
    return list(table.columns), table.astype(float).values.tolist()


def by_libreoffice(path):
    office = shutil.which("soffice") or shutil.which("libreoffice")
    if not office:
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        base = [office, "--headless", "-env:UserInstallation=file://" + folder + "/profile"]
        # As if opened by a double click: no filter options; then back to text for comparison.
        subprocess.run(base + ["--convert-to", "ods:calc8", "--outdir", folder, path], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=200)
        name = os.path.splitext(os.path.basename(path))[0]
        out = os.path.join(folder, "back")
        subprocess.run(base + ["--convert-to", 'csv:Text - txt - csv (StarCalc):44,34,76,1,,0,false,'
                               'false,false', "--outdir", out, os.path.join(folder, name + ".ods")],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=200)
        return by_csv_module(os.path.join(out, name + ".csv"))


def by_plotjuggler(path):
    """The rules of PlotJuggler's CSV loader: names in the first line, none empty or twice; comma by
    itself; as many cells in every line; a cell is a number or empty; time does not go back."""
    with open(path, encoding="utf-8") as f:
        lines = f.read().split("\n")
    if lines.pop() != "" or any(line == "" for line in lines):
        fail("a line is empty, or the last one does not end")
    header = lines[0].split(",")
    if "" in header or len(set(header)) != len(header):
        fail("a column has no name, or the name of another")
    if header[0] != "time [s]":
        fail("time does not come first")
    if any(separator in lines[0] for separator in ";\t"):
        fail("the header would be taken for another separator's")
    rows = []
    for line in lines[1:]:
        cells = line.split(",")
        if len(cells) != len(header):
            fail("a line has another number of cells than the header")
        rows.append([float(c) if c else math.nan for c in cells])
    if any(b[0] < a[0] for a, b in zip(rows, rows[1:])):
        fail("time goes back")
    return header, rows


def main():
    reader, path = sys.argv[1:3]
    want_header, want = by_csv_module(path)
    if len(want) < 20 or len(want_header) < 20:
        fail("there is too little to compare")
    header, rows = {"csv": by_csv_module, "pandas": by_pandas, "libreoffice": by_libreoffice,
                    "plotjuggler": by_plotjuggler}[reader](path)
    if header != want_header:
        fail("other columns were read")
    if len(rows) != len(want):
        fail(f"{len(rows)} rows were read, there are {len(want)}")
    # LibreOffice writes 15 digits back to text, at most 20 of them decimals; the others read every
    # bit.
    digits, decimals = (1e-14, 1e-20) if reader == "libreoffice" else (0.0, 0.0)
    for got_row, want_row in zip(rows, want):
        for got, expected in zip(got_row, want_row):
            if math.isnan(got) != math.isnan(expected):
                fail("a missing value was read as a number, or a number as missing")
            if not math.isnan(got) and abs(got - expected) > max(digits * abs(expected), decimals):
                fail(f"{expected!r} was read as {got!r}")


main()
