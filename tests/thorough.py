#!/usr/bin/env python3
"""The bounded thorough part of continuous integration, after the default suite.

    tests/thorough.py                 all parts
    tests/thorough.py PART ...        these parts: asan tsan gates changed tenth masked
    tests/thorough.py --list          what each part would run, and nothing happens

asan     the default suite under AddressSanitizer and UndefinedBehaviorSanitizer
tsan     the tests with threads under ThreadSanitizer
gates    all gates; clang-tidy looks at the files that the last COMMITS commits changed
masked   the default suite's scripted hands with the processor's newer instructions hidden
changed  the slow tests of the modules that the last COMMITS commits changed
tenth    a tenth of the other slow tests and of the determinism matrix: every tenth of them, from the number of commits
         modulo ten on

`changed` and `tenth` start no test when MINUTES have passed since VBSS_CI_START (seconds since 1970; default: now). The
tests left out are named. build/thorough.json keeps when each part was last run in this folder.
"""
import argparse
import datetime
import json
import os
import pathlib
import re
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
LEDGER = ROOT / "build/thorough.json"
COMMITS = 40
MINUTES = 33
MAX_TIDY_FILES = 200
THREADED = r"^(base|device|replica|trainer|examples\.(threads|trainer))"
THREADED_PROGRAMS = ["test_base", "test_device", "test_replica", "test_trainer", "threads", "trainer", "pass_needle", "surgeon"]
HANDS = r"^(examples\.(throw|pass_needle)|throw\.|python\.tests)"
# Slow tests whose name does not begin with their module: a pattern, and the folders that they prove.
FOLDERS_OF = [
    (r"^examples\.(surgeon|trainer_surgeon|viewer_surgeon|replay_surgeon)", {"surgeon"}),
    (r"^examples\.throw", {"throw"}),
    (r"^examples\.pass_needle", {"needle"}),
    (r"^examples\.viewer", {"viewer"}),
    (r"^examples\.trainer", {"trainer"}),
    (r"^examples\.replay", {"replay_page"}),
    (r"^examples\.web", {"web", "page"}),
    (r"^examples\.report", {"report"}),
    (r"^examples\.demo", {"demo"}),
    (r"^soak-sample\.(tight_knots|pokes|pricks|stabs|tugs|knot_holding)", {"scene", "contact"}),
    (r"^soak-sample\.(degenerate|families)", {"collision"}),
    (r"^soak-sample\.(elementary|snapshot)", {"base"}),
    (r"^soak-sample\.(tugging|undriven)", {"thread"}),
    (r"^soak-sample\.knots", {"knot"}),
    (r"^soak-sample\.power_cut", {"record"}),
    (r"^soak-sample\.throws", {"throw"}),
    (r"^soak-sample\.trainer", {"trainer"}),
    (r"^soak-sample\.hardware_faults", {"device"}),
    (r"^bench-quick\.tissue", {"tissue", "drain"}),
    (r"^bench-quick\.task", {"task", "surgeon"}),
    (r"^docs\.site$", {"start", "guides", "reference", "explanation", "notebook", "decisions"}),
    (r"^consumer\.", {"consumers", "pkgconfig"}),
]


def output(*command):
    return subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout


def commit_count():
    return int(output("git", "rev-list", "--count", "HEAD"))


def changed_folders():
    """Names of the folders below lib, tests, examples, bench and bindings that the last commits changed."""
    paths = output("git", "log", f"-{COMMITS}", "--name-only", "--format=").split()
    paths += output("git", "diff", "--name-only", "HEAD").split()
    folders = set()
    for path in paths:
        words = path.split("/")
        if words[0] == "include":
            folders.add(words[-1].removesuffix(".h"))
        elif len(words) > 2:
            folders.add(words[1])
    return folders


def folders_of(test):
    for pattern, folders in FOLDERS_OF:
        if re.search(pattern, test):
            return folders
    word = test.split(".")[1 if test.startswith("bench-quick.") else 0]
    return {word}


def slow_tests():
    """Names of the slow tests that are no gates, in a fixed order; a matrix row's gate goes with the row. Wheels and
    packages are left out: each compiles the library again, some with their C library, which takes longer than this part has."""
    text = output("ctest", "--preset", "default", "--label-regex", "slow", "--show-only=json-v1")
    names = []
    for test in json.loads(text)["tests"]:
        properties = {p["name"]: p["value"] for p in test.get("properties", [])}
        labels = properties.get("LABELS", [])
        if "slow" in labels and not {"wheels", "packages"} & set(labels) and (not test["name"].startswith("gate.") or "presets" in labels):
            names.append(test["name"])
    return sorted(names)


def choose(names, folders, count):
    """The slow tests of changed modules, and a tenth of the others."""
    changed = [name for name in names if folders_of(name) & folders and not name.startswith("determinism.matrix.")]
    rest = [name for name in names if name not in changed]
    return changed, [name for index, name in enumerate(rest) if index % 10 == count % 10]


def run(*command, environment=None):
    """True if the command ends with 0."""
    print("$ " + " ".join(command), flush=True)
    return subprocess.run(command, cwd=ROOT, env={**os.environ, **(environment or {})}).returncode == 0


def build(preset, *targets):
    """Configures and builds; the output is shown if that fails."""
    log = ROOT / f"build/{preset}.log"
    log.parent.mkdir(exist_ok=True)
    commands = [["cmake", "--preset", preset],
                ["cmake", "--build", "--preset", preset, *(("--target", *targets) if targets else ())]]
    with log.open("w") as file:
        for command in commands:
            if subprocess.run(command, cwd=ROOT, stdout=file, stderr=subprocess.STDOUT).returncode != 0:
                print(log.read_text()[-20000:])
                return False
    return True


def ctest(preset, *options, environment=None):
    return run("ctest", "--preset", preset, "--parallel", str(os.cpu_count() or 1), *options, environment=environment)


def exactly(names):
    return "^(" + "|".join(re.escape(name) for name in names) + ")$"


def run_asan():
    return build("asan") and ctest("asan", "--label-exclude", "slow", "--progress",
                                   environment={"VBSS_PROPERTY_SEED": "2"})


def run_tsan():
    return build("tsan", *THREADED_PROGRAMS) and ctest("tsan", "--label-exclude", "slow", "--tests-regex", THREADED,
                                                       "--progress", environment={"VBSS_PROPERTY_SEED": "3"})


def run_gates():
    return build("default") and ctest(
        "default", "--tests-regex", r"^gate\.", "--label-regex", "slow", "--label-exclude", "matrix|presets", "--verbose",
        environment={"VBSS_TIDY_COMMITS": str(COMMITS), "VBSS_TIDY_MOST": str(MAX_TIDY_FILES)})


def run_masked():
    return build("default") and run("tests/masked.sh", "ctest", "--preset", "default", "--parallel",
                                    str(os.cpu_count() or 1), "--tests-regex", HANDS, "--label-exclude", "slow")


def run_slow(names, deadline):
    """Runs slow tests in groups until the deadline; names those that are left out."""
    if not names:
        print("No test is in this part.")
        return True
    if not build("default", "all", "slow_programs"):
        return False
    good = True
    size = 4
    for start in range(0, len(names), size):
        if time.time() > deadline:
            print(f"Left out, as {MINUTES} minutes have passed: {' '.join(names[start:])}")
            break
        # A row of the matrix and the gate that looks at its instructions go together.
        chosen = names[start:start + size]
        chosen += [name.replace("determinism.matrix.", "gate.fma.") for name in chosen if ".matrix." in name]
        good = ctest("default", "--tests-regex", exactly(chosen), "--verbose") and good
    return good


def read_ledger():
    return json.loads(LEDGER.read_text()) if LEDGER.is_file() else {}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("parts", nargs="*", metavar="PART")
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()
    count = commit_count()
    deadline = float(os.environ.get("VBSS_CI_START", time.time())) + 60 * MINUTES
    names = slow_tests()
    changed, tenth = choose(names, changed_folders(), count)
    parts = {"asan": run_asan, "tsan": run_tsan, "gates": run_gates, "masked": run_masked,
             "tenth": lambda: run_slow(tenth, deadline), "changed": lambda: run_slow(changed, deadline)}
    if unknown := [part for part in options.parts if part not in parts]:
        parser.error(f"there is no part {unknown[0]}; there are: {' '.join(parts)}")
    if options.list:
        print(f"{count} commits: tenth {count % 10}\nchanged: {' '.join(changed)}\ntenth: {' '.join(tenth)}")
        return
    ledger, results = read_ledger(), {}
    for part in options.parts or parts:
        key = f"{part} {count % 10}" if part == "tenth" else part
        print(f"\n== thorough part: {key}", flush=True)
        begin = time.monotonic()
        good = parts[part]()
        results[key] = good, time.monotonic() - begin
        ledger[key] = {"commits": count, "revision": output("git", "rev-parse", "--short", "HEAD").strip(),
                       "date": datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d %H:%M UTC"), "good": good}
        LEDGER.write_text(json.dumps(ledger, indent=1))
    print("\n== what was run")
    for key in [*(part for part in parts if part != "tenth"), *(f"tenth {i}" for i in range(10))]:
        row = ledger.get(key)
        now = f"now, {'passed' if results[key][0] else 'FAILED'}, {results[key][1]:.0f} s" if key in results else ""
        last = f"last run here {row['date']} at {row['revision']}" if row else "not run in this folder so far"
        print(f"{key:<10} {now or last}")
    sys.exit(0 if all(good for good, _ in results.values()) else 1)


if __name__ == "__main__":
    main()
