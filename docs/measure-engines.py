#!/usr/bin/env python3
"""Prints the measured tables of docs/engines.md, each as it stands there.

Usage, from anywhere: docs/measure-engines.py [TABLE...] [--engine ENGINE] [--roversim PROGRAM]
All tables take about two hours on one core; those of the reduced engine alone a few minutes.
"""

import argparse
import itertools
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
STEPS = {"2": "0.002", "1": "0.001", "0.5": "0.0005"}  # [ms]: [s]
SHIPPED = ("solero", "shrimp", "bench_rover", "rocker_bogie")
ENGINES = ("ode", "reduced")
roversim = ROOT / "build/release/bin/roversim"
engine = ENGINES[0]


def ask(verb, project, *options):
    """The JSON that a verb prints; a run that does not complete prints one, too."""
    command = [roversim, verb, ROOT / f"assets/projects/{project}.rover", *options, "--engine", engine,
               "--json"]
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True)
    if not done.stdout:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stderr}")
    return json.loads(done.stdout)


def run(project, scenario, controller, *options):
    return ask("run", project, "--scenario", scenario, "--controller", controller, *options)


def heading(*names):
    row(*names)
    row(*["---"] * len(names))


def row(*cells):
    print("| " + " | ".join(str(cell) for cell in cells) + " |", flush=True)


COLUMNS = {
    "end": ("stop_reason", "{}"),
    "slip_abs [m]": ("slip_abs_m", "{:.3f}"),
    "slip_signed [m]": ("slip_signed_m", "{:.3f}"),
    "energy [J]": ("energy_J", "{:.2f}"),
    "violation [%]": ("friction_violation_pct", "{:.2f}"),
    "worst [%]": ("friction_worst_pct", "{:.0f}"),
    "loop [mm]": ("loop_error_max_mm", "{:.4f}"),
    "penetration [mm]": ("penetration_max_mm", "{:.2f}"),
    "solves/step": ("solves_per_step", "{:.2f}"),
    "rtf": ("rtf", "{:.1f}"),
}


def cells(report, names):
    return [COLUMNS[name][1].format(report[COLUMNS[name][0]]) for name in names]


def scenarios():
    """Every shipped project on every common scenario."""
    names = ("end", "slip_abs [m]", "violation [%]", "worst [%]", "loop [mm]", "penetration [mm]",
             "solves/step", "rtf")
    heading("project", "scenario", "controller", *names)
    for project, scenario, controller in itertools.product(
            SHIPPED, ("rough-profile", "rough-3d", "step", "flat"), ("speed", "equal-torque")):
        row(project, scenario, controller, *cells(run(project, scenario, controller), names))


def grounds():
    """The shipped kinds of ground."""
    names = ("end", "slip_abs [m]", "violation [%]", "worst [%]", "penetration [mm]", "rtf")
    heading("ground", *names)
    for scenario in ("flat", "image", "ascii-grid", "mesh", "rocks", "cross-slope", "one-side"):
        row(scenario, *cells(run("terrains", scenario, "speed"), names))


def violation():
    """Friction violation against the step."""
    names = ("violation [%]", "worst [%]", "solves/step")
    heading("project, ground", *(f"{name}, {step} ms" for step in ("2", "1") for name in names))
    for project, scenario in (("solero", "rough-profile"), ("solero", "rough-3d"),
                              ("solero", "step"), ("terrains", "cross-slope"),
                              ("rocker_bogie", "rough-profile"), ("rocker_bogie", "rough-3d"),
                              ("rocker_bogie", "step")):
        found = []
        for step in ("2", "1"):
            found += cells(run(project, scenario, "speed", "--dt", STEPS[step]), names)
        row(f"{project}, {scenario}", *found)


def step_length():
    """One run at three steps."""
    names = ("end", "slip_abs [m]", "slip_signed [m]", "energy [J]", "violation [%]", "loop [mm]",
             "penetration [mm]", "solves/step", "rtf")
    heading("step [ms]", *names)
    for step, seconds in STEPS.items():
        row(step, *cells(run("solero", "rough-profile", "speed", "--dt", seconds), names))


def convergence():
    """Slip on random profiles at three steps, and the largest difference at any wheel."""
    heading("seed", "friction", *(f"{step} ms" for step in STEPS), "sum apart [%]",
            "a wheel apart [mm]")
    for friction, seed in itertools.product(("0.7", "0.4"), range(1, 6)):
        reports = [run("solero", "rough-profile", "speed", "--seed", seed, "--mu", friction,
                       "--distance", "2.0", "--dt", seconds) for seconds in STEPS.values()]
        sums = [report["slip_abs_m"] for report in reports]
        wheels = zip(*([wheel["slip_abs_m"] for wheel in report["wheels"]] for report in reports))
        row(seed, friction,
            *(f"{report['slip_abs_m']:.3f}" + ("" if report["completed"] else " " + report["stop_reason"])
              for report in reports),
            f"{100 * (max(sums) - min(sums)) / min(sums):.1f}",
            f"{1000 * max(max(values) - min(values) for values in wheels):.1f}")


def critical_friction():
    """Friction that a step needs, to 0.005. Shorter steps are looked for near the longest one's."""
    heading("height [m]", *(f"{step} ms" for step in STEPS))
    for height in ("0.05", "0.08", "0.10"):
        low, high = 0.3, 0.9
        found = []
        for seconds in STEPS.values():
            found.append(ask("critical-friction", "solero", "--scenario", "step", "--height", height,
                             "--distance", "1.55", "--low", f"{low:.4f}", "--high", f"{high:.4f}", "--dt", seconds))
            low, high = found[0]["fails"] - 0.03, found[0]["completes"] + 0.03
        row(height, *(f"{each['fails']:.3f}–{each['completes']:.3f}" for each in found))


def joints():
    """As built against relaxed."""
    heading("project, ground", "slip built [m]", "slip relaxed [m]", "apart [%]",
            "largest difference of a mean wheel load [%]")
    for project, scenario, distance in (("solero", "rough-profile", "3.5"), ("solero", "rough-3d", "2.0"),
                                        ("solero", "step", "1.55"), ("shrimp", "rough-profile", "2.0")):
        built, relaxed = (run(project, scenario, "speed", "--distance", distance, "--joints", kind)
                          for kind in ("built", "relaxed"))
        slip = built["slip_abs_m"], relaxed["slip_abs_m"]
        loads = [(one["mean_normal_force_N"], other["mean_normal_force_N"])
                 for one, other in zip(built["wheels"], relaxed["wheels"])]
        row(f"{project}, {scenario}", *(f"{value:.4f}" for value in slip),
            f"{100 * abs(slip[1] / slip[0] - 1):.2f}",
            f"{max(100 * abs(other / one - 1) for one, other in loads):.2f}")


TABLES = {"scenarios": scenarios, "grounds": grounds, "violation": violation, "step-length": step_length,
          "convergence": convergence, "critical-friction": critical_friction, "joints": joints}


def main():
    global roversim, engine
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("tables", nargs="*", metavar="TABLE", help=", ".join(TABLES) + " (all if none)")
    parser.add_argument("--engine", choices=ENGINES, help="both if none")
    parser.add_argument("--roversim", default=roversim, help="program to measure")
    arguments = parser.parse_args()
    roversim = pathlib.Path(arguments.roversim).resolve()
    unknown = [name for name in arguments.tables if name not in TABLES]
    if unknown:
        parser.error(f"no table '{unknown[0]}'; there are {', '.join(TABLES)}")
    for name in arguments.tables or TABLES:
        for engine in [arguments.engine] if arguments.engine else ENGINES:
            print(f"\n### {name}, {engine}\n")
            TABLES[name]()


if __name__ == "__main__":
    main()
