#!/usr/bin/env python3
"""Measures this revision against another one: bench/run.sh against REV [suite|subject ...].

Both are built with the same subjects (scenes with fixed scripts) and run alternately on one core. Exit status: 0 measured,
1 the other revision does not build or a run failed, 2 the command line makes no sense."""
import argparse
import datetime
import json
import os
import platform
import subprocess
import sys

import figures
import revision
import runs
import table

PAIRS, SEEDS = 7, 10
QUICK_PAIRS, QUICK_SEEDS = 2, 1


def positive(word):
    value = int(word)
    if value < 1:
        raise argparse.ArgumentTypeError(f"{word} is not positive")
    return value


def read_options(words):
    parser = argparse.ArgumentParser(prog="bench/run.sh against",
                                     description="Ratios of CPU time, this revision by REV, step by step on one core.")
    parser.add_argument("rev", metavar="REV", help="any name of a commit that git knows")
    parser.add_argument("subjects", nargs="*", metavar="suite|subject", help="which; default: all")
    parser.add_argument("--pairs", type=positive, help=f"runs of each revision; default {PAIRS}")
    parser.add_argument("--seeds", type=positive, help=f"seeds of subjects that have them, from 0 on; default {SEEDS}")
    parser.add_argument("--quick", action="store_true", help=f"a first look: {QUICK_PAIRS} pairs, {QUICK_SEEDS} seed")
    parser.add_argument("--core", type=int, default=runs.best_core(), help="default: the last one that may be used")
    parser.add_argument("--json", metavar="FILE", help="also writes all figures there")
    o = parser.parse_intermixed_args(words)
    o.pairs = o.pairs or (QUICK_PAIRS if o.quick else PAIRS)
    o.seeds = o.seeds or (QUICK_SEEDS if o.quick else SEEDS)
    if o.core is not None and (not hasattr(os, "sched_getaffinity") or o.core not in os.sched_getaffinity(0)):
        parser.error(f"there is no core {o.core} for this process")
    return o


def list_subjects(program):
    """Names with True for those that have seeds."""
    text = subprocess.run([program, "list"], capture_output=True, text=True, check=True).stdout
    return {line.split()[0]: line.endswith(" seeded") for line in text.splitlines()}


def select(known, words):
    """The subjects that the words name, each the name of a subject or of its suite."""
    for word in words:
        if not any(word in (name, name.split("/")[0]) for name in known):
            raise LookupError(f"no suite or subject '{word}'; there are: {' '.join(known)}")
    return [name for name in known if not words or name in words or name.split("/")[0] in words]


def read_cpu():
    try:
        with open("/proc/cpuinfo") as text:
            return next(line.split(":", 1)[1].strip() for line in text if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.machine()


def measure(o, programs, commit, known, chosen):
    measured = {"date": datetime.datetime.now(datetime.timezone.utc).isoformat(timespec="seconds"), "cpu": read_cpu(),
                "core": o.core, "pairs": o.pairs, "load": os.getloadavg(),
                "reference": {"name": o.rev, "commit": commit}, "this": {"name": revision.describe()},
                "subjects": {}, "failures": []}
    share, names = runs.CoreShare(), (o.rev, "this revision")
    for subject in chosen:
        seeds = o.seeds if known[subject] else 1
        try:
            sides = runs.measure_seeds(programs, names, subject, seeds, o.pairs, o.core, share)
            measured["subjects"][subject] = figures.subject(*sides)
        except runs.RunFailed as failure:
            measured["failures"].append(str(failure))
    measured["core_share"] = share.value()
    return measured


def report(o, measured):
    if measured["subjects"]:
        print("\n".join(table.text(measured)))
    if o.json:
        with open(o.json, "w") as file:
            json.dump(measured, file, indent=1)
            file.write("\n")
    for failure in measured["failures"]:
        print(f"bench/run.sh against: failed: {failure}", file=sys.stderr)
    return 1 if measured["failures"] else 0


def main(words):
    o = read_options(words)
    try:
        commit = revision.resolve(o.rev)
        this = revision.build_this()
        known = list_subjects(this)
        chosen = select(known, o.subjects)
        other = revision.build_other(commit, o.rev)
    except (revision.UnknownRevision, LookupError) as failure:
        print(f"bench/run.sh against: {failure}", file=sys.stderr)
        return 2
    except revision.BuildFailed as failure:
        print(f"bench/run.sh against: {failure}", file=sys.stderr)
        return 1
    return report(o, measure(o, (other, this), commit, known, chosen))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
