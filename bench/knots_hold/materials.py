#!/usr/bin/env python3
"""Ties and grows knots of sutures of size 3-0, for docs/notebook/knots-literature.md. Resumable: each finished knot is a line of the
output, and the next call begins with the first cell that is missing.

    materials.py [--build build/release] [--out build/bench/knots-materials.jsonl] [--seeds N] [--seconds S] [-j N] [--knot KIND] [--list]

--seconds ends the run after the knot that is being tied then. docs/scripts/plot_knots_literature.py draws the file.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import resource
import signal
import subprocess
import sys
import time

MATERIALS = ["silk", "polyglactin", "polypropylene", "nylon"]
MONOFILAMENTS = ["polypropylene", "nylon"]
KNOTS = ["square", "granny", "surgeon's", "fls", "three throws"]
FRICTION, SEATING = 0.3, 5.0  # of the library's default; N
# A choice without a measurement: the outer fibre of a monofilament yields at 2 % (docs/explanation/bending-memory.md).
PLASTIC = "yield=180 hardening=0.2"


def cells():
    """Knot, friction, seating force, options: the cells that decide most first."""
    for knot in KNOTS:
        for material in MATERIALS:
            yield knot, FRICTION, SEATING, f"material={material}"
        for material in MONOFILAMENTS:
            yield knot, FRICTION, SEATING, f"material={material} {PLASTIC}"
    for force in (1.0, 2.0):  # dependence on the force that seats the knot
        for material in MATERIALS:
            yield "square", FRICTION, force, f"material={material}"
        for material in MONOFILAMENTS:
            yield "square", FRICTION, force, f"material={material} {PLASTIC}"
    for friction in (0.2, 0.4):
        for material in MATERIALS:
            yield "square", friction, SEATING, f"material={material}"


MAX_CPU = 120  # s: a knot that takes more is given up


def limit_cpu():
    resource.setrlimit(resource.RLIMIT_CPU, (MAX_CPU, MAX_CPU + 5))


def key_of(row):
    return row["knot"], row["friction"], row["force"], row["seed"], row["variant"]


def run_job(executable, job):
    knot, friction, force, seed, variant = job
    command = [executable, knot, str(force), str(friction), str(seed)] + variant.split()
    done = subprocess.run(command, capture_output=True, text=True, preexec_fn=limit_cpu)
    if done.returncode == -signal.SIGXCPU:
        return {"knot": knot, "friction": friction, "force": force, "seed": seed, "variant": variant, "end": "given up"}
    if done.returncode != 0:
        return {"knot": knot, "friction": friction, "force": force, "seed": seed, "variant": variant,
                "end": "failed", "message": done.stderr.strip()}
    return {**json.loads(done.stdout), "variant": variant}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build/release"))
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("build/bench/knots-materials.jsonl"))
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--seconds", type=float, default=float("inf"))
    parser.add_argument("-j", type=int, default=1, dest="jobs")
    parser.add_argument("--knot", choices=KNOTS, help="only the cells of this kind")
    parser.add_argument("--list", action="store_true", help="print the missing cells and end")
    options = parser.parse_args()
    out, done = options.out, set()
    if out.exists():
        done = {key_of(json.loads(line)) for line in out.read_text().splitlines()}
    # All cells with the first seed, then all with the second.
    jobs = [job for seed in range(1, options.seeds + 1)
            for job in ((k, mu, f, seed, v) for k, mu, f, v in cells())
            if job not in done and options.knot in (None, job[0])]
    if options.list:
        print("\n".join(str(job) for job in jobs))
        return
    executable = options.build / "bench" / "knots_hold"
    if not executable.exists():
        sys.exit(f"no {executable}: cmake --preset release && cmake --build --preset release --target knots_hold")
    os.nice(10)
    out.parent.mkdir(parents=True, exist_ok=True)
    start = time.monotonic()

    def run(job):
        return run_job(executable, job) if time.monotonic() - start < options.seconds else None

    failed = 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool, out.open("a") as file:
        for future in concurrent.futures.as_completed([pool.submit(run, job) for job in jobs]):
            row = future.result()
            if row is None:
                continue
            file.write(json.dumps(row) + "\n")
            file.flush()
            failed += row["end"] == "failed"
            print(f'{row["knot"]}, {row["variant"]}, friction {row["friction"]}, seated {row["force"]} N, seed {row["seed"]}: '
                  f'{row["end"]}, {row.get("holds_N", 0):.3g} N', flush=True)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
