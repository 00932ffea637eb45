#!/usr/bin/env python3
"""Draws docs/pictures/cost.svg and prints docs/engines.md's table from the scale benchmark.

    build/bench/bin/scale_bench --benchmark_out=cost.json --benchmark_out_format=json
    docs/plot-cost.py cost.json
"""

import json
import pathlib
import re
import sys

PANELS = [("Wheels", "wheels", "wheels"), ("Bodies", "bodies", "bodies"), ("Step", "step_ms", "step [ms]")]
COLOURS = {"Reduced": "#1f6fb2", "Ode": "#c2571a"}
NAMES = {"Reduced": "reduced", "Ode": "ODE"}
WIDTH, HEIGHT, LEFT, TOP, GAP = 250, 220, 60, 40, 50


def measured(path):
    """{panel: {engine: [(x, us)]}}, medians over repetitions."""
    found = {}
    for run in json.load(open(path))["benchmarks"]:
        name = re.match(r"stepAgainst(\w+)<(\w+)>", run["name"])
        if not name or run.get("error_occurred") or run.get("run_type") == "aggregate":
            continue
        key = next(key for title, key, _ in PANELS if title == name[1])
        found.setdefault(name[1], {}).setdefault(name[2], {}).setdefault(run[key], []).append(run["us_median"])
    return {
        panel: {
            engine: sorted((x, sorted(values)[len(values) // 2]) for x, values in points.items())
            for engine, points in engines.items()
        }
        for panel, engines in found.items()
    }


def table(data):
    for title, _, label in PANELS:
        xs = [x for x, _ in data[title]["Reduced"]]
        print(f"| {label} | " + " | ".join(f"{x:g}" for x in xs) + " |")
        print("| --- |" + " ---: |" * len(xs))
        for engine in COLOURS:
            values = dict(data[title].get(engine, []))
            print(f"| {NAMES[engine]} [us] | " + " | ".join(f"{values[x]:.0f}" if x in values else "" for x in xs) + " |")
        print()


def draw(data):
    import math

    all_us = [us for engines in data.values() for points in engines.values() for _, us in points]
    low = 10 ** math.floor(math.log10(min(all_us)))
    high = 10 ** math.ceil(math.log10(max(all_us)))
    height_of = lambda us: TOP + HEIGHT * (1 - math.log10(us / low) / math.log10(high / low))
    total = LEFT + 3 * WIDTH + 2 * GAP + 20
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{total}" height="{TOP + HEIGHT + 60}" '
        'font-family="sans-serif" font-size="12" fill="#333">',
        f'<rect width="{total}" height="{TOP + HEIGHT + 60}" fill="white"/>',
        f'<text x="{LEFT}" y="20">time of a step [us]</text>',
    ]
    for i, engine in enumerate(COLOURS):
        x = total - 180 + 90 * i
        out.append(f'<line x1="{x}" x2="{x + 20}" y1="16" y2="16" stroke="{COLOURS[engine]}" stroke-width="2"/>')
        out.append(f'<text x="{x + 26}" y="20">{NAMES[engine]}</text>')
    for p, (title, _, label) in enumerate(PANELS):
        x0 = LEFT + p * (WIDTH + GAP)
        xs = [x for x, _ in data[title]["Reduced"]]
        logarithmic = title == "Step"
        scale = (lambda x: math.log(x)) if logarithmic else (lambda x: x)
        first, last = scale(xs[0]), scale(xs[-1])
        place = lambda x: x0 + 10 + (WIDTH - 20) * (scale(x) - first) / (last - first)
        out.append(f'<rect x="{x0}" y="{TOP}" width="{WIDTH}" height="{HEIGHT}" fill="none" stroke="#999"/>')
        us = low
        while us <= high * 1.001:
            y = height_of(us)
            out.append(f'<line x1="{x0}" x2="{x0 + WIDTH}" y1="{y:.1f}" y2="{y:.1f}" stroke="#ddd"/>')
            if p == 0:
                out.append(f'<text x="{x0 - 8}" y="{y + 4:.1f}" text-anchor="end">{us:g}</text>')
            us *= 10
        for x in xs:
            out.append(f'<text x="{place(x):.1f}" y="{TOP + HEIGHT + 18}" text-anchor="middle">{x:g}</text>')
        out.append(f'<text x="{x0 + WIDTH / 2}" y="{TOP + HEIGHT + 40}" text-anchor="middle">{label}</text>')
        for engine, points in data[title].items():
            path = " ".join(f"{place(x):.1f},{height_of(us):.1f}" for x, us in points)
            out.append(f'<polyline points="{path}" fill="none" stroke="{COLOURS[engine]}" stroke-width="2"/>')
            for x, us in points:
                out.append(f'<circle cx="{place(x):.1f}" cy="{height_of(us):.1f}" r="3" fill="{COLOURS[engine]}"/>')
    out.append("</svg>\n")
    picture = pathlib.Path(__file__).parent / "pictures" / "cost.svg"
    picture.write_text("\n".join(out))
    print(f"wrote {picture}", file=sys.stderr)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    numbers = measured(sys.argv[1])
    if {title for title, _, _ in PANELS} - set(numbers):
        sys.exit(f"{sys.argv[1]} does not hold all of the scale benchmark's results; run all of it")
    table(numbers)
    draw(numbers)
