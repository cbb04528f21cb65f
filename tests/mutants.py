#!/usr/bin/env python3
"""Seeded random faults in lib/, each run against the default suite: which does the suite find?

    tests/mutants.py --tree CLONE --work FILE.jsonl [--seed 1] [--count 30] [--only N ...] [--tests REGEX]

CLONE is a clone of this repository that this command may change: it builds there (build/default), plants one fault at a time
and takes it back. Four kinds of fault, chosen in turn: a sign (+ for -), a bound (< for <=), a missing check (a condition
that is never true, or a VBSS_TRY of a check that is gone) and an index or count that is off by one. The suite runs in
two stages that both stop at the first failure: golden scenes, the contract of bodies and the tests of the file's module,
then all others. FILE gets one line a fault; a fault that has a line is not run again. --tests runs these tests only, for
a comparison of two suites that share the others.
"""
import argparse
import json
import os
import pathlib
import random
import re
import subprocess
import sys
import time

KINDS = ["sign", "bound", "check", "off by one"]


def code_lines(path):
    """(number, text) of lines of function bodies: indented, and neither comment, string, macro nor declaration alone."""
    inside = False
    for number, line in enumerate(path.read_text().split("\n")):
        stripped = line.strip()
        if inside or stripped.startswith("/*"):
            inside = "*/" not in stripped
            continue
        if line.startswith("    ") and '"' not in line and "/*" not in line and not stripped.startswith(("*", "#")):
            yield number, line


def sites(path, kind):
    """All (line number, new line) of that kind of fault in a file."""
    found = []

    def swap(pattern, replace):
        for number, line in code_lines(path):
            for match in re.finditer(pattern, line):
                found.append((number, line[:match.start()] + replace(match) + line[match.end():]))

    if kind == "sign":
        swap(r"(?<=[\w)\]] )[+-](?= [\w(])", lambda m: "-" if m.group() == "+" else "+")
        swap(r" (\+|-)= ", lambda m: " -= " if m.group(1) == "+" else " += ")
    elif kind == "bound":
        swap(r"(?<=[\w)\]] )(<=|>=|<|>)(?= [\w(-])",
             lambda m: {"<": "<=", "<=": "<", ">": ">=", ">=": ">"}[m.group()])
    elif kind == "check":
        swap(r"\bif \((?=[^;]*\) \{$)", lambda m: "if (0 && ")
        swap(r"^    VBSS_TRY\(vbss_check_\w+\(.*\)\);$", lambda m: "    (void)0;")
    else:
        swap(r"(?<=\[)\w+(?=\])", lambda m: m.group() + " + 1")
        swap(r"(?<= = )0(?=; )", lambda m: "1")
        swap(r" [+-] 1(?=[;)\],])", lambda m: "")
    return found


def plan(tree, seed, count):
    """The faults: files weighted by their length, so that every line is as likely as another."""
    rng = random.Random(seed)
    files = sorted((tree / "lib").rglob("*.c"))
    weights = [len(path.read_text().split("\n")) for path in files]
    faults = []
    while len(faults) < count:
        path, kind = rng.choices(files, weights)[0], KINDS[len(faults) % len(KINDS)]
        if choices := sites(path, kind):
            number, new = rng.choice(choices)
            # An `if` over a condition with && keeps its meaning only in parentheses.
            if kind == "check" and "0 && " in new:
                head, _, tail = new.partition("if (0 && ")
                new = f"{head}if (0 && ({tail.removesuffix(') {')})) {{"
            faults.append({"kind": kind, "file": str(path.relative_to(tree)), "line": number + 1,
                           "old": path.read_text().split("\n")[number], "new": new})
    return faults


def plant(tree, fault):
    """Changes the line, looked up by its text so that a tree of another revision can be used; the original text."""
    path = tree / fault["file"]
    text = path.read_text()
    lines = text.split("\n")
    places = [i for i, line in enumerate(lines) if line == fault["old"]]
    if not places:
        return None
    nearest = min(places, key=lambda i: abs(i - (fault["line"] - 1)))
    lines[nearest] = fault["new"]
    path.write_text("\n".join(lines))
    return text


def quiet(tree, *command):
    return subprocess.run(command, cwd=tree, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")


def first_failures(said):
    return re.findall(r"^\s*\d+ - (\S+) \((?:Failed|Timeout|SEGFAULT|Subprocess aborted|ILLEGAL|Exception|BAD_COMMAND).*\)",
                      said, flags=re.M)


def judge(tree, fault, tests):
    """What the suite says of the tree as it is now."""
    build = quiet(tree, "cmake", "--build", "--preset", "default")
    if build.returncode != 0:
        return {"found": "does not compile", "by": []}
    module = fault["file"].split("/")[1]
    near = rf"^(determinism\.golden$|contract\.|{module}\.)"
    stages = [["--tests-regex", tests]] if tests else [["--tests-regex", near], ["--exclude-regex", near]]
    for options in stages:
        done = quiet(tree, "ctest", "--preset", "default", "--label-exclude", "slow", "--stop-on-failure", "--timeout", "120",
                     "--parallel", str(os.cpu_count() or 1), *options)
        if done.returncode != 0 and "No tests were found" not in done.stdout:
            return {"found": "test fails", "by": first_failures(done.stdout)}
    return {"found": "", "by": []}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--tree", required=True, type=pathlib.Path)
    parser.add_argument("--work", required=True, type=pathlib.Path)
    parser.add_argument("--plan", type=pathlib.Path, help="faults of another run's FILE instead of new ones")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=30)
    parser.add_argument("--only", type=int, nargs="+")
    parser.add_argument("--tests")
    parser.add_argument("--list", action="store_true", help="prints the faults, and nothing happens")
    options = parser.parse_args()
    if options.plan:
        faults = [json.loads(line) for line in options.plan.read_text().splitlines()]
    else:
        faults = plan(options.tree, options.seed, options.count)
    if options.list:
        for number, fault in enumerate(faults):
            print(f"{number:2} {fault['kind']:<10} {fault['file']}:{fault['line']}\n     {fault['old'].strip()}\n     {fault['new'].strip()}")
        return
    done = {}
    if options.work.is_file():
        done = {row["number"]: row for row in map(json.loads, options.work.read_text().splitlines())}
    for number, fault in enumerate(faults):
        if number in done or (options.only and number not in options.only):
            continue
        begin = time.monotonic()
        original = plant(options.tree, fault)
        if original is None:
            result = {"found": "not planted: the line is not there", "by": []}
        else:
            try:
                result = judge(options.tree, fault, options.tests)
            finally:
                (options.tree / fault["file"]).write_text(original)
        row = {**fault, "number": number, **result, "seconds": round(time.monotonic() - begin)}
        with options.work.open("a") as file:
            file.write(json.dumps(row) + "\n")
        print(f"{number:2} {row['kind']:<10} {row['file']}:{row['line']}  {row['found'] or 'MISSED'}  {' '.join(row['by'][:2])}  "
              f"{row['seconds']} s", flush=True)
    sys.exit(0)


if __name__ == "__main__":
    main()
