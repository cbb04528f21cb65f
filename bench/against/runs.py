"""Runs the subjects of two revisions alternately on one core, and checks that each revision repeats itself."""
import os
import resource
import subprocess
import sys
import time
from dataclasses import dataclass, field


class RunFailed(Exception):
    pass


@dataclass
class Run:
    """One run of a subject, or the runs of several seeds after each other."""
    ns: list = field(default_factory=list)  # CPU time of each step
    step_s: float = 0.0
    counters: dict = field(default_factory=dict)
    seeds: int = 0
    done: int = 0
    hashes: list = field(default_factory=list)


def parse(text):
    run, lines = Run(seeds=1), iter(text.splitlines())
    for line in lines:
        name, value = line.split()
        if name == "times":
            run.ns = [int(line) for line in lines]
            if len(run.ns) != int(value) or not run.ns:
                raise RunFailed(f"{len(run.ns)} of {value} times arrived")
        elif name == "step_s":
            run.step_s = float(value)
        elif name == "hash":
            run.hashes = [value]
        elif name == "done":
            run.done = int(value)
        else:
            run.counters[name] = float(value)
    return run


def join(runs):
    """The runs of several seeds as one."""
    whole = Run(step_s=runs[0].step_s)
    for run in runs:
        whole.ns += run.ns
        whole.hashes += run.hashes
        whole.seeds += run.seeds
        whole.done += run.done
        for name, value in run.counters.items():
            whole.counters[name] = whole.counters.get(name, 0.0) + value
    return whole


def best_core():
    """The last of the cores that this process may use; None where a process cannot be bound to one."""
    return max(os.sched_getaffinity(0)) if hasattr(os, "sched_setaffinity") else None


def run_once(program, subject, seed, core):
    bind = (lambda: os.sched_setaffinity(0, {core})) if core is not None else None
    ended = subprocess.run([program, "run", subject, str(seed)], capture_output=True, text=True, preexec_fn=bind)
    if ended.returncode != 0:
        raise RunFailed(ended.stderr.strip() or f"ended with {ended.returncode}")
    return parse(ended.stdout)


class CoreShare:
    """The share of the wall time in which the runs had their core. Below 1, other work ran on it."""

    def __init__(self):
        self.cpu_s = self.wall_s = 0.0

    def __enter__(self):
        self.began = time.monotonic(), self.children()
        return self

    def __exit__(self, *_):
        self.wall_s += time.monotonic() - self.began[0]
        self.cpu_s += self.children() - self.began[1]

    @staticmethod
    def children():
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        return used.ru_utime + used.ru_stime

    def value(self):
        return min(self.cpu_s / self.wall_s, 1.0) if self.wall_s > 0.0 else 1.0


def check_repeats(name, run, first):
    if run.hashes != first.hashes or len(run.ns) != len(first.ns):
        raise RunFailed(f"{name} does not repeat itself: two runs end in different states")


def measure(programs, names, subject, seed, pairs, core, share):
    """Lists of runs, one a revision. Its order is A B, B A, A B, ... so that a drift of the clock rate meets both alike."""
    runs = ([], [])
    for pair in range(pairs):
        print(f"{subject} seed {seed}: pair {pair + 1} of {pairs}", file=sys.stderr)
        for side in (0, 1) if pair % 2 == 0 else (1, 0):
            try:
                with share:
                    runs[side].append(run_once(programs[side], subject, seed, core))
                check_repeats(names[side], runs[side][-1], runs[side][0])
            except RunFailed as failure:
                raise RunFailed(f"{subject} seed {seed}, {names[side]}: {failure}") from None
    return runs


def measure_seeds(programs, names, subject, seeds, pairs, core, share):
    """The same with all seeds of a subject, joined."""
    parts = [measure(programs, names, subject, seed, pairs, core, share) for seed in range(seeds)]
    return tuple([join([part[side][pair] for part in parts]) for pair in range(pairs)] for side in (0, 1))
