#!/usr/bin/env python3
"""False alarms and noise of an experiment's gates: the same run with many seeds.

    STURM=build/release/bin/sturm scripts/gate_seeds.py configs/experiments/validation.json [--seeds 20] [--first 1] [--json FILE] [sturm run options ...]

Each gate with the mean, the standard deviation, the least and the largest of its values, and how often it failed. Nothing is wrong in any of the runs, so
that every failure is a false alarm; beside their number stands the one that the gates' levels lead one to expect. Exit status 1 if there was any.
Further options go to every `sturm run`, e.g. --set '/images=[]'.
"""
import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

STURM = os.environ.get("STURM", "build/release/bin/sturm")


def gates_of(experiment, seed, folder, options):
    """The gates of one run; a run whose gates failed has a report all the same."""
    process = subprocess.run([STURM, "run", experiment, "--seed", str(seed), "--out", str(folder), "--quiet", *options], capture_output=True, text=True)
    if process.returncode not in (0, 1):
        sys.exit(process.stderr)
    return json.loads((folder / "report.json").read_text())["gates"]


def summary(runs):
    """By gate, in the report's order: values over all runs, failures, level."""
    gates = {}
    for run in runs:
        for gate in run:
            entry = gates.setdefault(gate["id"], {"values": [], "failures": 0, "level": gate.get("level"), "bound": gate["bound"]})
            entry["failures"] += not gate["passed"]
            if gate["value"] is not None:
                entry["values"].append(gate["value"])
    return gates


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("experiment")
    parser.add_argument("--seeds", type=int, default=20)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--json", type=pathlib.Path)
    arguments, options = parser.parse_known_args()
    runs = []
    for seed in range(arguments.first, arguments.first + arguments.seeds):
        with tempfile.TemporaryDirectory(prefix="sturm_seed_") as folder:
            runs.append(gates_of(arguments.experiment, seed, pathlib.Path(folder), options))
    gates = summary(runs)
    print(f"{'gate':44}{'mean':>12}{'std. dev.':>12}{'least':>12}{'largest':>12}{'bound':>10}{'failed':>8}")
    for name, gate in gates.items():
        values = gate["values"]
        numbers = [statistics.fmean(values), statistics.stdev(values) if len(values) > 1 else 0.0, min(values), max(values)] if values else []
        print(f"{name:44}" + "".join(f"{number:12.4g}" for number in numbers) + " " * 12 * (4 - len(numbers)) + f"{gate['bound']:10.4g}{gate['failures']:8}")
    failures = sum(gate["failures"] for gate in gates.values())
    levels = [gate["level"] for gate in gates.values()]
    expected = None if None in levels else len(runs) * sum(levels)
    print(f"{failures} false alarms in {len(runs)} runs" + ("" if expected is None else f"; by the gates' levels at most {expected:.2g} are expected"))
    if arguments.json:
        arguments.json.write_text(json.dumps({"runs": len(runs), "false_alarms": failures, "expected": expected, "gates": gates}, indent=1))
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
