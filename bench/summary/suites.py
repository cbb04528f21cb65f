"""Which cases of the C suites the summary runs, and how."""
import json
import subprocess

# Suite, filter, options. --quick leaves out the cases that take minutes; the repetitions stay those of a measurement.
CASES = [
    ("thread", "cantilever/", ["--quick", "--repetitions", "7"]),
    ("tissue", "tissue/slit/", []),
    ("knots", "knots/case-", []),
    ("knots", "knots/plain-stacks/", ["--quick", "--repetitions", "7"]),
    ("collision", "collision/hard/", []),
    ("task", "task/fls/expert", ["--seeds", "1"]),
]
LIMIT = 400.0  # s a run


def names():
    return list(dict.fromkeys(suite for suite, _, _ in CASES))


def run(programs, out, core, quick, skipped):
    """Entries of all cases by suite, and the context of the first file. `skipped` gets what did not run."""
    entries, context = {}, {}
    for number, (suite, filtered, options) in enumerate(CASES):
        if quick:
            options = ["--quick"]
            filtered = filtered.replace("fls/expert", "stitch")
        file = out / f"{suite}-{number}.json"
        file.unlink(missing_ok=True)
        command = ["taskset", "-c", str(core), str(programs / f"bench_{suite}"), "--out", str(file), "--filter", filtered]
        print(f"summary: {suite}: {filtered}", flush=True)
        try:
            subprocess.run(command + options, check=True, capture_output=True, text=True, timeout=LIMIT)
            data = json.loads(file.read_text(encoding="utf-8"))
        except (OSError, ValueError, subprocess.SubprocessError) as error:
            skipped.append((filtered, f"{type(error).__name__}"))
            continue
        context = context or data["context"]
        entries.setdefault(suite, []).extend(data["benchmarks"])
        skipped += [(one["name"], one["reason"]) for one in data["context"]["skipped"]]
    return entries, context
