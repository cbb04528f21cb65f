"""What docs/notebook/task.md promises and shows, read off build/bench/task.json; bench/run.sh runs it after the suite.

Prints a line a promise with the measured value, and the tables of the page. Times depend on the machine and what else it does,
so a promise that is not kept is told, not made an error."""
import json
import sys

# Qi et al. 2017, doi 10.1016/j.jbi.2017.09.010, section 8: on a desktop CPU of 2013 (Core i7-4930K).
PAPER_SEGMENTS, PAPER_FRAMES = 30, 150
PAPER_GROWN_SEGMENTS, PAPER_GROWN_MS = 120, 10.0

STEP = [("mean_us", "mean us", "{:.1f}"), ("p50", "p50", "{:.1f}"), ("p99_us", "p99", "{:.0f}"), ("p999_us", "p99.9", "{:.0f}"),
        ("max_us", "longest", "{:.0f}")]


def read(path):
    cases = {}
    for row in json.load(open(path))["benchmarks"]:
        row["p50"] = row.get("median_us", row.get("p50_us"))
        if row["p50"] is not None:
            cases[tuple(row["name"].split("/")[1:])] = row
    return cases


def line(cells):
    print("| " + " | ".join(str(c) for c in cells) + " |")


def table(rows, first, columns):
    if rows:
        line(first + [head for _, head, _ in columns])
        print("|---" * (len(first) + len(columns)) + "|")
        for names, row in rows:
            line(list(names) + [text.format(row[key]) if key in row else "" for key, _, text in columns])
        print()


def bars(cases):
    for skill in ("expert", "resident", "novice"):
        row = cases.get(("fls", skill))
        if row:
            yield f"{skill}: completed", row["completed"], "1", lambda v: v == 1.0
            yield f"{skill}: p99.9 of a step, us", row["p999_us"], "< 1000", lambda v: v < 1000.0
            yield f"{skill}: real-time factor", row["real_time_factor"], "> 2", lambda v: v > 2.0
            if "pass_throughs" in row:
                yield f"{skill}: pass-throughs", row["pass_throughs"], "0", lambda v: v == 0.0
    empty = cases.get(("at-rest", "0-empty"))
    if empty:
        yield "empty scene, us a step", empty["mean_us"], "< 1", lambda v: v < 1.0
    thirty = cases.get(("double-throw-drawn", "ours", str(PAPER_SEGMENTS)))
    if thirty:
        yield f"double throw, {PAPER_SEGMENTS} segments, mean us a step", thirty["mean_us"], \
            f"< {1e6 / PAPER_FRAMES:.0f}, the paper's frame", lambda v: v < 1e6 / PAPER_FRAMES
    grown = cases.get(("double-throw-drawn", "ours", str(PAPER_GROWN_SEGMENTS)))
    if grown:
        yield f"double throw, {PAPER_GROWN_SEGMENTS} segments, mean us a step", grown["mean_us"], \
            f"< {1e3 * PAPER_GROWN_MS:.0f}, the paper's", lambda v: v < 1e3 * PAPER_GROWN_MS


def parts(cases, scene):
    rows, before = [], 0.0
    for (s, *rest), row in sorted(cases.items()):
        if s == scene:
            rows.append((rest[:1], dict(row, more=row["mean_us"] - before)))
            before = row["mean_us"]
    columns = STEP + [("more", "more than before, us", "{:.1f}"), ("contacts", "contacts", "{:.0f}")]
    table(rows, [f"{scene}, with"], columns)


def double_throws(cases):
    names = lambda scene: [((m, n), row) for (s, m, *rest), row in cases.items() if s == scene and rest for n in rest]
    table(names("double-throw-drawn"), ["drawn tight", "segments"],
          STEP + [("us_per_ms", "us/ms", "{:.1f}"), ("topology_kept", "knot kept", "{:.0f}"), ("stretch_max", "stretch", "{:.1e}"),
                  ("broken", "broken", "{:.0f}")])


def performances(cases):
    rows = [((m,), row) for (s, m, *_), row in cases.items() if s == "fls"]
    table(rows, ["skill"],
          [("seeds", "seeds", "{:.0f}"), ("completed", "completed", "{:.2f}"), ("hands_done", "hands done", "{:.2f}"),
           ("certified", "2=1=1 certified", "{:.2f}"), ("pass_throughs", "pass-throughs", "{:.0f}"), ("repeats", "repeats", "{:.2f}"),
           ("real_time_factor", "real-time factor", "{:.2f}"), ("p50", "p50 us", "{:.0f}"), ("p99_us", "p99", "{:.0f}"),
           ("p999_us", "p99.9", "{:.0f}"), ("max_us", "longest", "{:.0f}"), ("gap_mm", "slit mm, most", "{:.2f}"),
           ("force_N", "N, most", "{:.1f}"), ("clamped", "cut short", "{:.0f}"), ("paused", "paused", "{:.0f}")])


def main():
    cases = read(sys.argv[1])
    for text, value, bar, kept in bars(cases):
        print(f"{'kept' if kept(value) else 'NOT KEPT':9}{text}: {value:.4g} (bar {bar})")
    print()
    parts(cases, "at-rest")
    parts(cases, "tying")
    double_throws(cases)
    performances(cases)


if __name__ == "__main__":
    main()
