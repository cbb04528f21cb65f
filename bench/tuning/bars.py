"""Which tuned numbers matter, read off build/bench/tuning.json; bench/run.sh runs it after the suite.

Prints the table of docs/notebook/tuning.md: for each number the scenes whose hash differs when it is halved and doubled, and
the largest changes of attempts, penetration and stretch. Numbers that change nothing follow in one list a folder."""
import collections
import json
import sys

SCENES = ["scene-tools", "scene-mesh", "graspers", "needle-hands", "session"]
FACTORS = [("halved", 1), ("doubled", 2)]
MEASURES = [("attempts", "pct"), ("penetration", "um"), ("stretch", "ppm")]


def read(path):
    for row in json.load(open(path))["benchmarks"]:
        if not row.get("error_occurred"):
            yield row["name"].split("/")[1:3], row


def differing(row, bit):
    return [scene for scene in SCENES if int(row[scene]) & bit]


def figure(value):
    return f"{value:.3g}" if value else "0"


def cells(name, row):
    yield f"`{name}`"
    for _, bit in FACTORS:
        yield ", ".join(differing(row, bit)) or "none"
    for what, unit in MEASURES:
        yield ", ".join(figure(row[f"{what}_{factor}_{unit}"]) for factor, _ in FACTORS)
    yield figure(row["failed"])


def main(path):
    idle = collections.defaultdict(list)
    print("| number | halved: scenes that differ | doubled: scenes that differ | attempts a step, % | penetration, um | "
          "stretch, ppm | failed runs of 10 |\n|---|---|---|---|---|---|---|")
    for (folder, name), row in read(path):
        if any(row[scene] for scene in SCENES):
            print("| " + " | ".join(cells(name, row)) + " |")
        else:
            idle[folder].append(name)
    print()
    for folder, names in idle.items():
        print(f"- No scene differs, {folder} ({len(names)}): " + ", ".join(f"`{name}`" for name in names) + ".")


if __name__ == "__main__":
    main(sys.argv[1])
