"""What docs/explanation/contact.md promises, read off build/bench/contact.json; bench/run.sh runs it after the suite.

Prints a line a promise with the measured value, and the table of the page. Times depend on the machine and
what else it does, so a promise that is not kept is told, not made an error."""
import json
import sys

COLUMNS = [("median_us", "median us", "{:.0f}"), ("p99_us", "p99 us", "{:.0f}"), ("p999_us", "p99.9 us", "{:.0f}"),
           ("penetration_um", "overlap um", "{:.1f}"), ("stretch_max", "stretch", "{:.1e}"),
           ("topology_kept", "knot kept", "{:.0f}"), ("contacts", "contacts", "{:.0f}"),
           ("retries", "retries", "{:.0f}"), ("clamped", "cut short", "{:.0f}"), ("force_N", "N", "{:.2f}"),
           ("taken_up_mm", "taken up mm", "{:.2f}")]


def read(path):
    cases = {}
    for row in json.load(open(path))["benchmarks"]:
        parts = row["name"].split("/")
        if len(parts) == 4 and "median_us" in row:
            cases[tuple(parts[1:])] = row
    return cases


def one(cases, scene, method):
    found = [row for (s, m, _), row in cases.items() if (s, m) == (scene, method)]
    return found[0] if found else None


def bars(cases):
    held, pulled = one(cases, "double-overhand-held", "ours"), one(cases, "double-overhand", "ours")
    if held:
        yield "double overhand held at 2 N, median us", held["median_us"], "<= 40", lambda v: v <= 40.0
    if pulled:
        yield "double overhand pulled, median us, guard included", pulled["median_us"], "<= 120", lambda v: v <= 120.0
        yield "double overhand pulled, p99 us, guard included", pulled["p99_us"], "<= 400", lambda v: v <= 400.0
    uniform = one(cases, "double-overhand-uniform-held", "ours")
    if uniform:
        yield "double overhand of 120 segments held, steps/s", 1e6 / uniform["median_us"], ">= 30000", \
            lambda v: v >= 30000.0
    for scene in ("fls-knot-300", "fls-knot"):
        row = one(cases, scene, "ours")
        if row:
            yield f"{scene}, p99.9 us", row["p999_us"], "<= 1000, wanted 550", lambda v: v <= 1000.0
    for scene in ("throw-single", "throw-double"):
        row = one(cases, scene, "ours")
        if row:
            yield f"{scene}, retries a step", row["attempts_per_step"] - 1.0, "<= 0.1", lambda v: v <= 0.1
            yield f"{scene}, steps cut short", row["clamped"], "= 0", lambda v: v == 0
            yield f"{scene}, p99.9 us", row["p999_us"], "<= 1000", lambda v: v <= 1000.0
    ours = [row for (s, m, _), row in cases.items() if m == "ours" and "topology_kept" in row and s != "resolution"]
    if ours:
        yield "knots of ours that are no longer what they were", \
            sum(1 - row["topology_kept"] for row in ours), "= 0", lambda v: v == 0
        yield "largest stretch error of ours", max(row["stretch_max"] for row in ours), "<= 1e-3", lambda v: v <= 1e-3


def table(cases):
    print("| scene | method | nodes | " + " | ".join(title for _, title, _ in COLUMNS) + " |")
    print("|" + "---|" * (len(COLUMNS) + 3))
    for (scene, method, nodes), row in cases.items():
        if scene != "resolution":
            cells = [fmt.format(row[name]) if name in row else "" for name, _, fmt in COLUMNS]
            print(f"| {scene} | {method} | {nodes} | " + " | ".join(cells) + " |")


def resolution(cases):
    rows = [(m, n, row) for (s, m, n), row in cases.items() if s == "resolution"]
    if rows:
        print("\n| overhand | segment um | median us | taken up mm | error mm |\n|---|---|---|---|---|")
    for method, label, row in rows:
        print(f"| {method} | {label} | {row['median_us']:.0f} | {row['taken_up_mm']:.3f} | "
              f"{row.get('taken_up_error_mm', float('nan')):.3f} |")


def main():
    cases = read(sys.argv[1])
    for text, value, bar, kept in bars(cases):
        print(f"{'kept' if kept(value) else 'NOT KEPT':9}{text}: {value:.4g} (bar {bar})")
    print()
    table(cases)
    resolution(cases)


if __name__ == "__main__":
    main()
