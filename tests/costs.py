#!/usr/bin/env python3
"""CPU seconds of every CTest entry of a build, the costliest first.

    tests/costs.py build/default                     all entries
    tests/costs.py build/default --exclude-label slow
    tests/costs.py build/default --label slow --jobs 2 --json costs.json --top 30

Each entry runs as CTest would run it: its command, working directory and environment. User and system time of the whole
process tree count, so the figures depend little on what else the machine does. Entries that set up a fixture run before
those that need it. The verdict of a test is printed, not judged: CTest does that.
"""
import argparse
import concurrent.futures
import json
import os
import re
import subprocess
import sys
import threading
import time


def read_entries(build):
    text = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], check=True, capture_output=True,
                          text=True).stdout
    entries = []
    for test in json.loads(text)["tests"]:
        properties = {p["name"]: p["value"] for p in test.get("properties", [])}
        if "command" in test and not properties.get("DISABLED"):
            entries.append((test["name"], test["command"], properties))
    return entries


def run(entry):
    name, command, properties = entry
    environment = dict(os.environ)
    for pair in properties.get("ENVIRONMENT", []):
        key, _, value = pair.partition("=")
        environment[key] = value
    start = time.monotonic()
    process = subprocess.Popen(command, cwd=properties.get("WORKING_DIRECTORY"), env=environment,
                               stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    limit = threading.Timer(float(properties.get("TIMEOUT", 3600)), process.kill)
    limit.start()
    _, status, usage = os.wait4(process.pid, 0) # counts the children that the process has waited for, too
    limit.cancel()
    process.returncode = os.waitstatus_to_exitcode(status)
    return {"name": name, "cpu": usage.ru_utime + usage.ru_stime, "wall": time.monotonic() - start,
            "exit": process.returncode}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build")
    parser.add_argument("--label", help="only entries with a label that matches this expression")
    parser.add_argument("--exclude-label", help="no entries with a label that matches this expression")
    parser.add_argument("--regex", help="only entries whose name matches this expression, and their fixtures")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--top", type=int, default=30, help="how many rows are printed (30)")
    parser.add_argument("--json", help="file for all rows")
    options = parser.parse_args()

    def wanted(entry):
        name, _, properties = entry
        labels = properties.get("LABELS", [])
        if options.label and not any(re.search(options.label, label) for label in labels):
            return False
        if options.exclude_label and any(re.search(options.exclude_label, label) for label in labels):
            return False
        return not options.regex or re.search(options.regex, name) is not None

    entries = read_entries(options.build)
    chosen = [entry for entry in entries if wanted(entry)]
    while True: # fixtures of fixtures
        needed = {f for _, _, properties in chosen for f in properties.get("FIXTURES_REQUIRED", [])}
        more = [entry for entry in entries if entry not in chosen and needed & set(entry[2].get("FIXTURES_SETUP", []))]
        if not more:
            break
        chosen += more
    waves = []
    while chosen:
        pending = {f for _, _, properties in chosen for f in properties.get("FIXTURES_SETUP", [])}
        ready = [entry for entry in chosen if not pending & set(entry[2].get("FIXTURES_REQUIRED", []))]
        if not ready:
            sys.exit("costs.py: fixtures of these tests depend on each other: " + ", ".join(e[0] for e in chosen))
        waves.append(ready)
        chosen = [entry for entry in chosen if entry not in ready]

    rows = []
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for wave in waves:
            rows += pool.map(run, wave)
    rows.sort(key=lambda row: -row["cpu"])
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump(rows, file, indent=0)
    print(f"{len(rows)} entries, {sum(row['cpu'] for row in rows):.0f} CPU seconds")
    print(f"{'CPU s':>8} {'wall s':>8}  entry")
    for row in rows[:options.top]:
        print(f"{row['cpu']:8.1f} {row['wall']:8.1f}  {row['name']}" + (f"  (exit {row['exit']})" if row["exit"] else ""))


if __name__ == "__main__":
    main()
