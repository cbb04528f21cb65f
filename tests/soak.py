#!/usr/bin/env python3
"""Runs soaks: long checks split into seeds, each a process of its own.

    soak.py --build DIR [NAME ...] [--seeds N] [--shard I/M]   every seed 0 .. N-1 not yet done
    soak.py --build DIR --sample NAME                          1 % of the seeds, for CI; keeps nothing

Results are appended to DIR/../soak/NAME.jsonl, one line a seed, and a seed that passed with the same
executable is not run again: a soak that was stopped goes on where it was.
"""
import argparse
import concurrent.futures
import hashlib
import json
import math
import os
import pathlib
import random
import subprocess
import sys
import time


def read_list(build):
    """Name -> default number of seeds, as CMake wrote it."""
    rows = (line.split() for line in (build / "soaks.txt").read_text().splitlines() if line)
    return {name: int(seeds) for name, seeds in rows}


def find_executable(build, name):
    plain = build / "tests" / f"soak_{name}"
    for_windows = plain.with_suffix(".exe")
    return for_windows if for_windows.exists() else plain


def run_seed(executable, digest, seed):
    start = time.monotonic()
    emulator = ["wine"] if executable.suffix == ".exe" else []
    done = subprocess.run([*emulator, executable, "--seed", str(seed)], capture_output=True, text=True)
    try:
        row = json.loads(done.stdout)
    except json.JSONDecodeError:
        row = {"seed": seed, "failures": 1}
    if done.returncode != 0:
        row["failures"] = max(1, row["failures"])
        row["exit"] = done.returncode
        row["said"] = done.stderr[-2000:]
    row["seconds"] = round(time.monotonic() - start, 3)
    row["executable"] = digest
    return row


def run_seeds(executable, digest, seeds, keep):
    """The rows of these seeds, each handed to `keep` as soon as it is there."""
    workers = os.cpu_count() or 1
    with concurrent.futures.ThreadPoolExecutor(workers) as pool:
        running = [pool.submit(run_seed, executable, digest, seed) for seed in seeds]
        for done in concurrent.futures.as_completed(running):
            keep(done.result())
            yield done.result()


def read_rows(file):
    """What earlier runs found; a last line that was cut off is as if its seed had not run."""
    rows = []
    for line in file.read_text().splitlines() if file.exists() else []:
        try:
            rows.append(json.loads(line))
        except json.JSONDecodeError:
            continue
    return rows


def ends_with_newline(file):
    text = file.read_bytes()
    return not text or text.endswith(b"\n")


def extremes(rows):
    """Smallest and largest of every figure that is a number."""
    found = {}
    for row in rows:
        for name, value in row.items():
            if name not in ("seed", "failures", "executable") and isinstance(value, (int, float)):
                low, high = found.get(name, (value, value))
                found[name] = (min(low, value), max(high, value))
    return "; ".join(f"{name} {low:g} .. {high:g}" for name, (low, high) in found.items())


def soak(build, name, seeds, kept_file):
    executable = find_executable(build, name)
    digest = hashlib.sha256(executable.read_bytes()).hexdigest()[:12]
    rows = []
    if kept_file is not None:
        passed = {r["seed"]: r for r in read_rows(kept_file)
                  if r["executable"] == digest and not r["failures"]}
        rows = [passed[seed] for seed in seeds if seed in passed]
        seeds = [seed for seed in seeds if seed not in passed]

    def keep(row):
        if kept_file is not None:
            kept_file.parent.mkdir(exist_ok=True)
            with kept_file.open("a") as out:
                # On a line of its own, even after one that was cut off.
                out.write(("" if ends_with_newline(kept_file) else "\n") + json.dumps(row) + "\n")
        if row["failures"]:
            print(f"soak {name}: seed {row['seed']} FAILED {row.get('said', '')}", flush=True)

    resumed = len(rows)
    rows += run_seeds(executable, digest, seeds, keep)
    failed = sum(1 for row in rows if row["failures"])
    print(f"soak {name}: {len(rows)} seeds ({resumed} from earlier runs), {failed} failed; "
          f"{extremes(rows)}", flush=True)
    return failed == 0 and len(rows) > 0


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--seeds", type=int)
    parser.add_argument("--shard", default="0/1")
    parser.add_argument("--sample", action="store_true")
    options = parser.parse_args()

    known = read_list(options.build)
    unknown = [name for name in options.names if name not in known]
    if unknown:
        sys.exit(f"no soak {', '.join(unknown)}; there are: {', '.join(sorted(known))}")
    if options.seeds is not None and options.seeds < 1:
        sys.exit("a soak needs at least one seed")
    kept_folder = options.build.parent / "soak"
    index, shards = map(int, options.shard.split("/"))
    good = True
    for name in options.names or sorted(known):
        count = options.seeds or known[name]
        if options.sample:
            # The same seeds every time, from anywhere in the range.
            seeds = sorted(random.Random(name).sample(range(count), math.ceil(count / 100)))
            good &= soak(options.build, name, seeds, None)
        else:
            seeds = [seed for seed in range(count) if seed % shards == index]
            good &= soak(options.build, name, seeds, kept_folder / f"{name}.jsonl")
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
