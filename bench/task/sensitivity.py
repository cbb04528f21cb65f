#!/usr/bin/env python3
"""Runs the scripted surgeon with several seeds at each setting of the bending stiffness, friction and yield of the thread, one changed at a
time, and counts the tasks that it completes. docs/notebook/knots-literature.md tells why these ranges.

    sensitivity.py [--build build/release] [--out build/bench/sensitivity.jsonl] [--seeds 20] [--first 0] [--seconds S] [-j N]
    sensitivity.py --table [--out ...]      prints tables of the finished performances

Resumable: each finished performance is a line of the output, and the next call begins with the first that is missing. --seconds ends the
run after the performances that are under way then. Budgets are the default operations, so results do not depend on the machine.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import time

# The defaults are EI = 1e-8 N m^2, friction 0.3, no yield.
SETTINGS = {
    "defaults": {},
    "EI / 5": {"bending": 2e-9},
    "EI x 5": {"bending": 5e-8},
    "friction 0.2": {"friction": 0.2},
    "friction 0.4": {"friction": 0.4},
    "yield at 310 /m": {"yield": 310.0, "hardening": 0.2},
    "yield at 60 /m": {"yield": 60.0, "hardening": 0.2},
}
UNKNOWN = {"bending stiffness": ("EI / 5", "EI x 5"), "friction": ("friction 0.2", "friction 0.4"),
           "yield": ("yield at 310 /m", "yield at 60 /m")}

PATTERNS = {
    "stage": r"the hands: \S+, ([^:;]*?)(?:: .*)? after",
    "seconds": r"after ([\d.]+) s; the session",
    "failure": r"the session: phase '[^']*', (.*)",
    "slit_mm": r"slit ([\d.]+) mm in the end",
    "knot": r"knot: (\S+), ",
    "tied": r"(\d+) throws tied",
    "seated": r"throws tied, (\d+) seated",
    "score": r"score ([-\d.]+) of 600",
}
NUMBERS = ("seconds", "slit_mm", "tied", "seated", "score")


def read_report(text):
    row = {"complete": "the task is complete" in text}
    for name, pattern in PATTERNS.items():
        match = re.search(pattern, text)
        row[name] = None if match is None else float(match[1]) if name in NUMBERS else match[1].strip()
    return row


def perform(surgeon, setting, seed):
    command = [surgeon, "-s", str(seed)]
    for name, value in SETTINGS[setting].items():
        command += ["-x", f"{name}={value:g}"]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode not in (0, 1) or f"seed {seed}:" not in done.stdout:
        sys.exit(f"{' '.join(map(str, command))}: {done.returncode}\n{done.stderr}")
    return {"setting": setting, "seed": seed, **read_report(done.stdout)}


def rows_of(path):
    return [json.loads(line) for line in path.read_text().splitlines()] if path.exists() else []


def median_of(rows, name):
    values = [row[name] for row in rows if row[name] is not None]
    return f"{statistics.median(values):.2f}" if values else "-"


def share(rows, holds):
    return sum(holds(row) for row in rows) / len(rows)


def is_tied(row):
    return row["tied"] is not None and row["tied"] >= 3


def print_tables(rows):
    cells = {name: [row for row in rows if row["setting"] == name] for name in SETTINGS}
    print("| setting | seeds | complete | three throws tied | three seated | slit, mm, median | score, median |")
    print("|---|---|---|---|---|---|---|")
    for name, cell in cells.items():
        if cell:
            print(f'| {name} | {len(cell)} | {sum(r["complete"] for r in cell)} | {sum(map(is_tied, cell))} | '
                  f'{sum((r["seated"] or 0) >= 3 for r in cell)} | '
                  f'{median_of(cell, "slit_mm")} | {median_of(cell, "score")} |')
    print("\n| unknown | spread of the share complete | standard error |\n|---|---|---|")
    for unknown, names in UNKNOWN.items():
        group = [cells[name] for name in ("defaults", *names) if cells[name]]
        if len(group) == 3:
            shares = [share(cell, lambda r: r["complete"]) for cell in group]
            error = (0.5 / min(map(len, group))) ** 0.5  # of a difference of two shares, at most
            print(f"| {unknown} | {max(shares) - min(shares):.2f} | {error:.2f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build/release"))
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("build/bench/sensitivity.jsonl"))
    parser.add_argument("--seeds", type=int, default=20)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seconds", type=float, default=float("inf"))
    parser.add_argument("-j", type=int, default=1, dest="jobs")
    parser.add_argument("--table", action="store_true")
    options = parser.parse_args()
    rows = rows_of(options.out)
    if options.table:
        print_tables(rows)
        return
    surgeon = options.build / "examples" / "surgeon" / "surgeon"
    if not surgeon.exists():
        sys.exit(f"no {surgeon}: cmake --preset release && cmake --build --preset release --target surgeon")
    done = {(row["setting"], row["seed"]) for row in rows}
    jobs = [(setting, seed) for seed in range(options.first, options.first + options.seeds)
            for setting in SETTINGS if (setting, seed) not in done]
    os.nice(10)
    options.out.parent.mkdir(parents=True, exist_ok=True)
    start = time.monotonic()

    def run(job):
        return perform(surgeon, *job) if time.monotonic() - start < options.seconds else None

    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool, options.out.open("a") as file:
        for future in concurrent.futures.as_completed([pool.submit(run, job) for job in jobs]):
            row = future.result()
            if row is not None:
                file.write(json.dumps(row) + "\n")
                file.flush()
                print(f'{row["setting"]}, seed {row["seed"]}: {"complete" if row["complete"] else "not complete"}, knot {row["knot"]}, '
                      f'{row["slit_mm"]} mm', flush=True)


if __name__ == "__main__":
    main()
