"""What docs/notebook/collision.md promises, read off build/bench/collision.json; bench/run.sh runs it after the suite.

Prints a line a promise with the measured value, and the table of the page. Times depend on the machine and
what else it does, so a promise that is not kept is told, not made an error; misses are errors of the suite."""
import json
import sys

THREAD, HARD = "thread", "hard"
TABLE = ["conservative", "conservative-1e-6", "conservative-call", "conservative-batch", "conservative-batch-call",
         "conservative-batch-plain", "paper", "paper-metres", "paper-call", "cubic", "accd-0.1", "accd-0.001",
         "fcl-end", "fcl-intersect", "libccd-end", "libccd-swept"]
SETS = [THREAD, HARD, "triangles", "degenerate-edges", "degenerate-points"]


def read(path):
    cases, growth = {}, None
    for row in json.load(open(path))["benchmarks"]:
        parts = row["name"].split("/")
        if "exponent" in row:
            growth = row["exponent"]
        elif len(parts) == 3:
            cases[parts[1], parts[2]] = row
    return cases, growth


def bars(cases, growth):
    def ns(name, method):
        return cases[name, method]["ns"]
    families = sorted({s for s, _ in cases if s.startswith("hard-")} | {THREAD})
    mine = sum(ns(s, "conservative") for s in families) / len(families)
    peer = sum(ns(s, "accd-0.001") for s in families) / len(families)
    ratios = sum(ns(s, "accd-0.001") / ns(s, "conservative") for s in families) / len(families)
    ours = [row for (s, m), row in cases.items() if m.startswith("conservative") and "fn" in row]
    exact = [row for (s, m), row in cases.items() if s.startswith("degenerate") and m == "conservative"]
    clearance = max(row.get("fp_clearance", 0.0) for (s, m), row in cases.items()
                    if m == "conservative" and not s.startswith("degenerate"))
    yield "false negatives of CONSERVATIVE, all sets", sum(r["fn"] for r in ours), "= 0", lambda v: v == 0
    yield "largest clearance of a false positive, in D", clearance, "< 1e-3", lambda v: v < 1e-3
    yield "D = 0: false answers and undecided", sum(r["fp"] + r["fn"] + r["undecided"] for r in exact), "= 0", \
        lambda v: v == 0
    yield "thread scene, one at a time, of the paper's time", \
        ns(THREAD, "conservative") / ns(THREAD, "paper"), "<= 1.5", lambda v: v <= 1.5
    yield "thread scene, in rows, of the paper's time", \
        ns(THREAD, "conservative-batch") / ns(THREAD, "paper"), "< 1", lambda v: v < 1.0
    yield "ACCD s = 1e-3 over ours, mean times of hard families and thread", peer / mine, ">= 3", lambda v: v >= 3.0
    yield "the same, mean of the ratios", ratios, ">= 3", lambda v: v >= 3.0
    if growth is not None:
        yield "exponent of the search to 10 000 segments", growth, "<= 1.1", lambda v: v <= 1.1


def table(cases):
    print("| method | " + " | ".join(SETS) + " |")
    print("|" + "---|" * (len(SETS) + 1))
    for method in TABLE:
        cells = []
        for name in SETS:
            row = cases.get((name, method))
            ok = row is not None and "fn" in row
            cells.append(f"{row['fp']:.0f} / {row['fn']:.0f} / {row['ns']:.3g}" if ok else "")
        if any(cells):
            print(f"| {method} | " + " | ".join(cells) + " |")


def main():
    cases, growth = read(sys.argv[1])
    if (THREAD, "conservative") not in cases or not any(s.startswith("hard-") for s, _ in cases):
        return # a part of the suite
    for text, value, bar, kept in bars(cases, growth):
        print(f"{'kept' if kept(value) else 'NOT KEPT':8}  {value:<9.4g} {bar:8} {text}")
    print()
    table(cases)


main()
