"""Runs the cases of one peer, each in a process of its own on one core, and writes a JSON line a case.

    python measure.py PEER --out FILE [--core N] [--quick]
    python measure.py PEER --case SUBJECT SEGMENTS STEP"""
import argparse
import importlib
import json
import math
import os
import pathlib
import subprocess
import sys
import time

for name in ("OMP", "OPENBLAS", "MKL", "NUMBA", "NUMEXPR"):
    os.environ[f"{name}_NUM_THREADS"] = "1"  # before numpy is loaded
os.environ["WARP_CACHE_PATH"] = str(pathlib.Path(__file__).resolve().parents[2] / "build/peers/kernels")

import numpy as np  # noqa: E402

import judge  # noqa: E402
import problem as p  # noqa: E402

CHUNK = 2e-3  # s, between which the ends' speeds are constant and the pull is read
REPEAT_BELOW = 3.0  # s of CPU time: shorter cases are run three times, and the least time is kept
CASE_LIMIT = 300.0  # s of wall time a case


class Clock:
    """Adds up CPU seconds of this process and simulated seconds, over the calls that it makes."""

    def __init__(self):
        self.cpu = self.simulated = 0.0

    def __call__(self, call, seconds, *arguments):
        begin = time.process_time()
        call(seconds, *arguments)
        self.cpu += time.process_time() - begin
        self.simulated += seconds


def run_thread(made, clock):
    clock(made.advance, p.FALL)
    return {"error_mm": 1e3 * float(np.linalg.norm(np.asarray(made.positions()[-1]) - p.FALLEN_TIP))}


def run_capstan(made, clock):
    chunks = round(p.LOADING / CHUNK)
    for i in range(chunks):
        clock(made.advance, CHUNK, p.LOAD * (i + 1) / chunks, 0.0)
    pulls = []
    for i in range(round(p.PULLED / CHUNK)):
        clock(made.advance, CHUNK, p.LOAD, p.PULL_SPEED)
        if i * CHUNK >= p.SLIDING:
            pulls.append(made.pull())
    p.check_capstan(np.asarray(made.positions()))
    return {"error_percent": p.capstan_error_percent(float(np.mean(pulls))), "pull_N": float(np.mean(pulls))}


def run_trefoil(made, clock):
    chunks = round(p.trefoil_seconds(np.asarray(made.positions())) / CHUNK)
    kept = True
    for i in range(chunks + round(p.HELD / CHUNK)):
        clock(made.advance, CHUNK, p.KNOT_SPEED if i < chunks else 0.0)
        if i % 5 == 4 or i == chunks - 1:
            kept = kept and judge.determinant(np.asarray(made.positions())) == 3
    points = np.asarray(made.positions())
    kept = kept and judge.determinant(points) == 3
    nearest = judge.min_distance(points, 3.0 * p.DIAMETER) / p.DIAMETER
    return {"error_percent": 100.0 * max(0.0, 1.0 - nearest), "nearest_D": nearest, "kept": kept, "pull_N": made.pull()}


SUBJECTS = {"thread": (run_thread, "Thread"), "capstan": (run_capstan, "Capstan"), "trefoil": (run_trefoil, "Trefoil")}

RESTING = {"thread": (), "capstan": (0.0, 0.0), "trefoil": (0.0,)}  # arguments of advance that move nothing


def run_case(peer, subject, n, h):
    module = importlib.import_module(peer)
    run, maker = SUBJECTS[subject]
    getattr(module, maker)(n, h).advance(2.0 * h, *RESTING[subject])  # some peers compile at their first step
    best, result = math.inf, {}
    for _ in range(3):
        clock = Clock()
        result = run(getattr(module, maker)(n, h), clock)
        best = min(best, clock.cpu / clock.simulated)
        if clock.cpu > REPEAT_BELOW:
            break
    if not all(math.isfinite(v) for v in result.values()):
        result = {"failed": "the state is not finite"}
    return {"cpu_per_s": best, **result, "version": module.VERSION, "note": module.NOTE}


def measured(peer, subject, n, h):
    """In a process of its own: a crash or a case without end costs this case only."""
    command = [sys.executable, "-B", os.path.abspath(__file__), peer, "--case", subject, str(n), repr(h)]
    try:
        child = subprocess.run(command, capture_output=True, text=True, timeout=CASE_LIMIT, check=False)
        lines = [line for line in child.stdout.splitlines() if line.startswith('{"cpu_per_s"')]
        found = json.loads(lines[-1]) if child.returncode == 0 and lines else {
            "failed": (child.stderr.strip().splitlines() or ["it stopped without a word"])[-1][:120]}
    except subprocess.TimeoutExpired:
        found = {"failed": f"no end within {CASE_LIMIT:g} s"}
    return {"peer": peer, "subject": subject, "segments": n, "step_us": 1e6 * h, **found}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("peer")
    parser.add_argument("--out")
    parser.add_argument("--core", type=int)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--case", nargs=3, metavar=("SUBJECT", "SEGMENTS", "STEP"))
    chosen = parser.parse_args()
    if chosen.core is not None:
        os.sched_setaffinity(0, {chosen.core})
    if chosen.case:
        subject, n, h = chosen.case
        print(json.dumps(run_case(chosen.peer, subject, int(n), float(h))))
        return
    cases = importlib.import_module(chosen.peer).CASES
    with open(chosen.out or os.devnull, "w", encoding="utf-8") as out:
        for subject, listed in cases.items():
            for n, h in listed[:1] if chosen.quick else listed:
                line = json.dumps(measured(chosen.peer, subject, n, h))
                print(line, flush=True)
                print(line, file=out, flush=True)


if __name__ == "__main__":
    main()
