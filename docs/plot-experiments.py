#!/usr/bin/env python3
"""Draws the slip of every run of an experiment and prints the tables of docs/experiments.md.

    roversim reproduce profiles --seeds 101..140 --mu 0.3,0.4,0.5,0.7 --csv out
    docs/plot-experiments.py out/profiles-runs.csv out/profiles-summary.csv docs/pictures/profiles.svg

Like Figs. 5b and 6b of Lamon et al. (2004): one column a ground, one point a controller that came over
it, in the order of the hybrid's slip. Below a millimetre nothing slips.
"""

import csv
import math
import sys

COLOURS = {
    "speed": "#c2571a", "synchronised": "#8a6d00", "common-integral": "#5b5b5b",
    "equal-torque": "#7b4fa3", "torque": "#1f6fb2", "hybrid": "#0b7a4b",
}
MARKS = {"speed": "square", "synchronised": "diamond", "common-integral": "cross", "equal-torque": "ring",
         "torque": "dot", "hybrid": "big"}
WIDTH, HEIGHT, LEFT, TOP, GAP = 420, 200, 62, 46, 58
LOW, HIGH = 1e-3, 10.0


def runs(path):
    """{mu: {seed: {controller: slip [m]}}} of completed runs."""
    found = {}
    for row in csv.DictReader(open(path)):
        slips = found.setdefault(float(row["mu [-]"]), {}).setdefault(int(row["seed"]), {})
        if row["completed"] == "1":
            slips[row["controller"]] = float(row["slip_abs [m]"])
    return found


def mark(kind, x, y, colour):
    if kind == "square":
        return f'<rect x="{x - 2.5:.1f}" y="{y - 2.5:.1f}" width="5" height="5" fill="{colour}"/>'
    if kind == "diamond":
        return f'<path d="M{x:.1f} {y - 3.4:.1f}l3.4 3.4l-3.4 3.4l-3.4 -3.4z" fill="{colour}"/>'
    if kind == "cross":
        return (f'<path d="M{x - 2.4:.1f} {y - 2.4:.1f}l4.8 4.8m0 -4.8l-4.8 4.8" stroke="{colour}" '
                'stroke-width="1.2"/>')
    if kind == "ring":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.6" fill="none" stroke="{colour}"/>'
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{3.2 if kind == "big" else 2.2}" fill="{colour}"/>'


def panel(mu, grounds, x0, y0):
    def at(slip):
        return y0 + HEIGHT * (1 - math.log(max(LOW, slip) / LOW) / math.log(HIGH / LOW))

    order = sorted(grounds, key=lambda seed: (grounds[seed].get("hybrid", math.inf), seed))
    order = [seed for seed in order if grounds[seed]]
    out = [f'<text x="{x0}" y="{y0 - 8}" font-weight="bold">friction {mu:g}</text>']
    for decade in (1e-3, 1e-2, 1e-1, 1.0, 10.0):
        y = at(decade)
        label = "≤ 0.001" if decade == 1e-3 else f"{decade:g}"
        out.append(f'<line x1="{x0}" y1="{y:.1f}" x2="{x0 + WIDTH}" y2="{y:.1f}" stroke="#ddd"/>')
        out.append(f'<text x="{x0 - 6}" y="{y + 4:.1f}" text-anchor="end">{label}</text>')
    for i, seed in enumerate(order):
        x = x0 + WIDTH * (i + 0.5) / len(order)
        for controller in COLOURS:
            if controller in grounds[seed]:
                out.append(mark(MARKS[controller], x, at(grounds[seed][controller]), COLOURS[controller]))
    out.append(f'<text x="{x0 + WIDTH / 2}" y="{y0 + HEIGHT + 16}" text-anchor="middle">'
               f'{len(order)} of {len(grounds)} grounds, by the slip of hybrid</text>')
    return out


def draw(data, path):
    columns = 2
    rows = (len(data) + 1) // 2
    width = columns * (WIDTH + LEFT) + 20
    height = TOP + rows * (HEIGHT + GAP)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
           'font-family="DejaVu Sans, sans-serif" font-size="11" fill="#222">',
           f'<rect width="{width}" height="{height}" fill="white"/>',
           '<text x="10" y="16">total slip [m]</text>']
    x = 130
    for controller, colour in COLOURS.items():
        out.append(mark(MARKS[controller], x, 12, colour))
        out.append(f'<text x="{x + 8}" y="16">{controller}</text>')
        x += 34 + 7 * len(controller)
    for k, mu in enumerate(sorted(data)):
        out += panel(mu, data[mu], LEFT + (k % columns) * (WIDTH + LEFT), TOP + 8 + (k // columns) * (HEIGHT + GAP))
    open(path, "w").write("\n".join(out + ["</svg>\n"]))


def table(path, controller):
    """Wins, ties, losses in slip; ratios of slip, loaded slip and energy, on passable and other grounds."""
    print(f"\n`{controller}` against | friction | grounds | pairs | wins | ties | losses | slip | 95 % | loaded | energy")
    print("--- | --- | --- | --- | --- | --- | --- | --- | --- | --- | ---")
    rows = [r for r in csv.DictReader(open(path)) if r["controller"] == controller and r["grounds"] != "all"]
    for row in sorted(rows, key=lambda r: (list(COLOURS).index(r["rival"]), float(r["mu [-]"]), r["grounds"] == "beyond")):
        valid = int(row["valid"])
        if valid == 0:
            continue
        wins, ties = int(row["wins"]), int(row["ties"])
        number = lambda key: f"{float(row[key]):.2f}" if row[key] else ""
        interval = f"{number('ci95_low [-]')}–{number('ci95_high [-]')}" if row["ci95_low [-]"] else ""
        pairs = f"{valid}" if valid == int(row["pairs"]) else f"{valid} of {row['pairs']}"
        print(f"{row['rival']} | {row['mu [-]']} | {row['grounds']} | {pairs} | {wins} | {ties} | {valid - wins - ties} | "
              f"{number('mean_ratio [-]')} | {interval} | {number('loaded_mean_ratio [-]')} | "
              f"{number('energy_mean_ratio [-]')}")


def completed(path):
    counts = {}
    for row in csv.DictReader(open(path)):
        key = (row["controller"], float(row["mu [-]"]))
        done, tried = counts.get(key, (0, 0))
        counts[key] = (done + (row["completed"] == "1"), tried + 1)
    frictions = sorted({mu for _, mu in counts})
    print("\ncompleted | " + " | ".join(f"{mu:g}" for mu in frictions))
    print("--- | " + " | ".join("---" for _ in frictions))
    for controller in COLOURS:
        if (controller, frictions[0]) in counts:
            print(f"`{controller}` | " + " | ".join(
                "{} of {}".format(*counts[(controller, mu)]) for mu in frictions))


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    if len(sys.argv) == 4:
        draw(runs(sys.argv[1]), sys.argv[3])
    completed(sys.argv[1])
    for own in ("hybrid", "torque"):
        table(sys.argv[2], own)
