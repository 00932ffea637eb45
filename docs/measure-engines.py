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
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
STEPS = {"2": "0.002", "1": "0.001", "0.5": "0.0005"}  # [ms]: [s]
SHIPPED = ("solero", "shrimp", "bench_rover", "rocker_bogie")
ENGINES = ("ode", "reduced")
roversim = ROOT / "build/release/bin/roversim"
engine = ENGINES[0]


def ask(verb, project, *options):
    """The JSON that a verb prints; a run that does not complete prints one, too."""
    file = project if isinstance(project, pathlib.Path) else ROOT / f"assets/projects/{project}.rover"
    command = [roversim, verb, file, *options, "--engine", engine, "--json"]
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


def reference():
    """Slip of the reduced engine against its own at 0.1 ms: sums, and the wheel that is furthest from it."""
    if engine != "reduced":
        return print("only for the reduced engine: ODE would take a day")
    heading("controller", "seed", "friction", "2 ms", "1 ms", "0.1 ms", "2 ms apart", "1 ms apart")
    for controller, friction, seed in itertools.product(("speed", "equal-torque"), ("0.7", "0.4"), range(1, 11)):
        long, middle, short = (run("solero", "rough-profile", controller, "--seed", seed, "--mu", friction,
                                   "--distance", "2.0", "--dt", seconds) for seconds in ("0.002", "0.001", "0.0001"))

        def apart(report):
            percent = 100 * abs(report["slip_abs_m"] / short["slip_abs_m"] - 1)
            wheel = 1000 * max(abs(one["slip_abs_m"] - other["slip_abs_m"])
                               for one, other in zip(report["wheels"], short["wheels"]))
            return f"{percent:.1f} %, {wheel:.1f} mm"

        ends = {report["stop_reason"] for report in (long, middle, short)}
        row(controller, seed, friction, *(f"{report['slip_abs_m']:.3f}" for report in (long, middle, short)),
            apart(long), apart(middle) + ("" if ends == {"completed"} else " (" + ", ".join(sorted(ends)) + ")"))


def reference_friction():
    """Friction that a step needs, forwards and backwards, down to 0.1 ms."""
    if engine != "reduced":
        return print("only for the reduced engine: ODE would take a day")
    project = json.loads((ROOT / "assets/projects/solero.rover").read_text())
    step = next(one for one in project["scenarios"] if one["name"] == "step")
    step.setdefault("controller", {})["speed"] = -0.1
    step["terrain"] = {"kind": "step", "start": -2.0, "height": 0.1, "length": 1.0}
    with tempfile.TemporaryDirectory() as folder:
        backwards = pathlib.Path(folder) / "backwards.rover"
        backwards.write_text(json.dumps(project))
        heading("height [m]", "direction", "2 ms", "1 ms", "0.1 ms")
        for height, (name, file) in itertools.product(
                ("0.05", "0.08", "0.10", "0.12"), (("forwards", "solero"), ("backwards", backwards))):
            low, high, found = 0.25, 1.2, []
            for seconds in ("0.002", "0.001", "0.0001"):
                one = ask("critical-friction", file, "--scenario", "step", "--height", height, "--distance", "1.55",
                          "--low", f"{low:.4f}", "--high", f"{high:.4f}", "--dt", seconds)
                found.append(f"{one['fails']:.3f}–{one['completes']:.3f}" if "fails" in one else str(one))
                if "fails" in one and not found[1:]:
                    low, high = one["fails"] - 0.03, one["completes"] + 0.03
            row(height, name, *found)


def engines():
    """The reduced engine against ODE, both at 0.5 ms, at one instant."""
    global engine
    if engine != "reduced":
        return print("stands with the reduced engine")
    heading("project, ground", "controller", "slip ODE, reduced [m]", "apart [%]", "energy apart [%]",
            "largest difference of a mean wheel load [%]", "way apart [mm]")
    for project, scenario, controller in (("solero", "rough-profile", "speed"), ("solero", "rough-profile", "equal-torque"),
                                          ("shrimp", "rough-profile", "speed"),
                                          ("bench_rover", "rough-profile", "speed"),
                                          ("rocker_bogie", "rough-profile", "speed")):
        reports = []
        for engine in ENGINES:
            reports.append(run(project, scenario, controller, "--dt", "0.0005", "--duration", "20", "--distance", "100"))
        one, other = reports
        loads = [(a["mean_normal_force_N"], b["mean_normal_force_N"]) for a, b in zip(one["wheels"], other["wheels"])]
        row(f"{project}, {scenario}", controller, f"{one['slip_abs_m']:.4f}, {other['slip_abs_m']:.4f}",
            f"{100 * abs(other['slip_abs_m'] / one['slip_abs_m'] - 1):.1f}",
            f"{100 * abs(other['energy_J'] / one['energy_J'] - 1):.1f}",
            f"{max(100 * abs(b / a - 1) for a, b in loads):.2f}",
            f"{1000 * abs(other['distance_m'] - one['distance_m']):.1f}")


def equal_torque():
    """Slip of torque-driven wheels, in flight and under load. Steps next to each other tell the scatter."""
    heading("step [ms]", "slip_abs [m]", "slip_loaded [m]", "air time [s]", "friction work [J]", "energy [J]",
            "solves/step", "rtf")
    for step in ("2", "1", "0.51", "0.5", "0.49"):
        report = run("solero", "rough-profile", "equal-torque", "--dt", f"{float(step) / 1000:g}", "--duration", "20",
                     "--distance", "100")
        row(step, f"{report['slip_abs_m']:.4f}", f"{report['slip_loaded_m']:.4f}",
            f"{sum(wheel['air_time_s'] for wheel in report['wheels']):.3f}", f"{report['friction_work_J']:.3f}",
            *cells(report, ("energy [J]", "solves/step", "rtf")))


TABLES = {"scenarios": scenarios, "grounds": grounds, "violation": violation, "step-length": step_length,
          "convergence": convergence, "critical-friction": critical_friction, "joints": joints,
          "reference": reference, "reference-friction": reference_friction, "engines": engines,
          "equal-torque": equal_torque}


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
