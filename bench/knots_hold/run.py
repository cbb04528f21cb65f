#!/usr/bin/env python3
"""Ties and grows many knots, and writes what came of each to one file (docs/explanation/knot-holding.md).

    run.py [--build build/release] [--out build/bench/knots-hold.json] [-j N] [--seeds N]

The tables and the plot are made of that file by docs/scripts/plot_knot_holding.py.
"""
import argparse
import concurrent.futures
import json
import pathlib
import subprocess
import sys
import time

KNOTS = ["square", "granny", "surgeon's", "fls", "half hitches", "reversed half hitches"]
CELLS = [(force, friction) for friction in (0.1, 0.2, 0.3) for force in (1.0, 5.0)]
# Against the load that seats them, where half of the knots spring open and where hardly any does.
CELLS += [(force, friction) for friction in (0.25, 0.4) for force in (0.5, 1.0, 2.0, 5.0)]
# What the numbers must not depend on; one thing at a time.
DOUBTED = [("square", 1.0, 0.25), ("granny", 1.0, 0.3), ("half hitches", 1.0, 0.3)]
# All have the work they take, but for these: what the default limit of work does to them.
LIMITED = [(knot, force, friction) for friction in (0.3, 0.4) for force in (1.0, 5.0)
           for knot in ("square", "granny", "surgeon's", "fls", "half hitches")]
VARIANTS = ["finest=0.0003", "finest=0.0002", "step=0.0005", "stiffness=100000", "stiffness=400000",
            "growth=0.0005"]


def list_jobs(seeds):
    for knot in KNOTS:
        for force, friction in CELLS:
            for seed in range(1, seeds + 1):
                yield knot, force, friction, seed, ""
    for knot, force, friction in DOUBTED:
        for variant in VARIANTS:
            for seed in range(1, seeds + 1):
                yield knot, force, friction, seed, variant
    for knot, force, friction in LIMITED:
        for seed in range(1, seeds + 1):
            yield knot, force, friction, seed, "limited"


def run_job(executable, job):
    knot, force, friction, seed, variant = job
    command = [executable, knot, str(force), str(friction), str(seed)] + variant.split()
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        return {"knot": knot, "force": force, "friction": friction, "seed": seed,
                "variant": variant, "end": "failed", "said": done.stderr.strip()}
    return {**json.loads(done.stdout), "variant": variant}


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build/release"))
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("build/bench/knots-hold.json"))
    parser.add_argument("-j", type=int, default=1, dest="jobs")
    parser.add_argument("--seeds", type=int, default=20)
    options = parser.parse_args()
    executable = options.build / "bench" / "knots_hold"
    if not executable.exists():
        sys.exit(f"no {executable}: cmake --preset release && cmake --build --preset release --target knots_hold")

    options.out.parent.mkdir(parents=True, exist_ok=True)
    start, jobs, rows = time.monotonic(), list(list_jobs(options.seeds)), []
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for row in pool.map(lambda job: run_job(executable, job), jobs):
            rows.append(row)
            if len(rows) % 100 == 0 or len(rows) == len(jobs):
                options.out.write_text(json.dumps({"runs": rows}, indent=0))
                print(f"{len(rows)} of {len(jobs)} knots, {time.monotonic() - start:.0f} s", flush=True)
    failed = [row for row in rows if row["end"] == "failed"]
    for row in failed:
        print("FAILED", row, file=sys.stderr)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
