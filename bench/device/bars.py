"""What docs/explanation/graspers.md promises of hands and graspers, read off build/bench/device.json; bench/run.sh runs it after
the suite.

Prints a line a promise with the measured value, and the tables of the page. Times depend on the machine and what
else it does, so a promise that is not kept is told, not made an error."""
import json
import sys

MEETINGS = ["free", "wall-below", "wall-beside", "thread-held", "thread-sliding"]
COUPLINGS = [("400-5", "400, 5 (default)"), ("1000-5", "1000, 5"), ("2000-5", "2000, 5"), ("2000-10", "2000, 10")]
ARMS, DELAYS = (0, 2, 10), (0, 1, 2)
DEFAULT = "400-5"


def read(path):
    return {row["name"].split("/", 1)[1]: row for row in json.load(open(path))["benchmarks"]
            if not row.get("error_occurred")}


def gains(row, arm):
    return [row[f"mj_arm{arm}_late{d}"] for d in DELAYS]


def bars(cases):
    default = {m: cases[f"tool-path-{DEFAULT}/{m}"] for m in MEETINGS if f"tool-path-{DEFAULT}/{m}" in cases}
    for meeting, row in default.items():
        yield (f"default coupling, {meeting}, most gained by any hand at any delay, mJ",
               max(max(gains(row, arm)) for arm in ARMS), "<= 1", lambda v: v <= 1.0)
    torn = [row["mj_torn"] for row in default.values() if "mj_torn" in row]
    if torn:
        yield "default coupling, paths on which the thread was torn out, mJ", max(torn), "<= 1", lambda v: v <= 1.0


def format_values(values):
    """One word if none of them gains."""
    return "none" if max(values) <= 1e-3 else ", ".join("none" if v <= 1e-3 else f"{v:.2f}" for v in values)


def passivity(cases):
    print("| coupling, N/m, N s/m | hand's damping | " + " | ".join(MEETINGS) + " |")
    print("|" + "---|" * (2 + len(MEETINGS)))
    for name, title in COUPLINGS:
        rows = [cases.get(f"tool-path-{name}/{m}") for m in MEETINGS]
        if all(rows):
            for arm in ARMS:
                print(f"| {title} | {arm} | " + " | ".join(format_values(gains(row, arm)) for row in rows) + " |")
    print("\nmost gained of all delays, undamped hand, mJ / largest force, N / paths drawn, torn:")
    for name, title in COUPLINGS:
        for m in MEETINGS:
            row = cases.get(f"tool-path-{name}/{m}")
            if row:
                print(f"  {title} {m}: {max(gains(row, 0)):.4f} / {row['largest_N']:.2f} / "
                      f"{row['paths_drawn']:.0f}, {row['paths_torn']:.0f}")


def rest(cases):
    print("\n| at rest | mean N | rms N | peak to peak N |\n|---|---|---|---|")
    for name, row in cases.items():
        if name.startswith("tool-rest/"):
            print(f"| {name.split('/')[1]} | {row['mean_N']:.3f} | {row['rms_N']:.1e} | {row['peak_to_peak_N']:.1e} |")


def walls(cases):
    hands = [(mass, arm) for arm in ("0", "5") for mass in ("0.1", "0.2")]
    print("\n| coupling's damping N s/m, steps late | " +
          " | ".join(f"{mass} kg, {arm} N s/m" for mass, arm in hands) + " |")
    print("|" + "---|" * (1 + len(hands)))
    for damping in (2, 5, 10):
        for late in (1, 2):
            rows = [cases.get(f"tool-wall-{damping}-late-{late}/{mass}kg-arm-{arm}") for mass, arm in hands]
            if all(rows):
                print(f"| {damping}, {late} | " + " | ".join(f"{row['stiffest_N_per_m']:.0f}" for row in rows) + " |")


def costs(cases):
    kinds = ["thread-alone", "tool-far-away", "held", "held-twice"]
    print("\n| nodes | " + " | ".join(kinds) + " |  median, p99 us\n|" + "---|" * (1 + len(kinds)))
    for nodes in (61, 301):
        rows = [cases.get(f"tool-step/{kind}/{nodes}") for kind in kinds]
        if all(rows):
            print(f"| {nodes} | " + " | ".join(f"{row['median_us']:.1f}, {row['p99_us']:.1f}" for row in rows) + " |")
    for name, row in cases.items():
        if name.startswith("tool-looking/"):
            print(f"looking for strands, {name.split('/', 1)[1]}: {1e-3 * row['ns']:.1f} us")


def main():
    cases = read(sys.argv[1])
    for text, value, bar, kept in bars(cases):
        print(f"{'kept' if kept(value) else 'NOT KEPT':9}{text}: {value:.4g} (bar {bar})")
    print()
    passivity(cases)
    rest(cases)
    walls(cases)
    costs(cases)


if __name__ == "__main__":
    main()
