#!/usr/bin/python3
"""Draws docs/pictures/knots-literature.svg: ratios of the first table of docs/notebook/knots-literature.md, the forces that knots of
sutures hold, from the lines that bench/knots_hold/materials.py has written, and the published scatter beside that of our seeds. Prints the
table of these knots. The letters in brackets are those of the page's table of scatter.

    plot_knots_literature.py docs/notebook/knots-literature.jsonl docs/pictures/knots-literature.svg
"""
import json
import pathlib
import re
import statistics
import sys

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams["svg.hashsalt"] = "knots-literature"
import matplotlib.pyplot as plt  # noqa: E402  (the backend comes first)

PAGE = pathlib.Path(__file__).resolve().parent.parent / "notebook" / "knots-literature.md"
KNOTS = ["square", "granny", "surgeon's", "three throws", "fls"]
NAMES = ["square\n1=1", "granny\n1x1", "surgeon's\n2=1", "three throws\n1=1=1", "three throws\n2=1=1"]
MATERIALS = ["silk", "polyglactin", "polypropylene", "polypropylene, plastic", "nylon", "nylon, plastic"]
COLOURS = ["#0072B2", "#56B4E9", "#D55E00", "#E69F00", "#009E73", "#CC79A7"]
# Whether such knots break before they slip: Text Res J 71:435 (2001) for silk, Vet Surg 18:269 (1989) for the others.
PUBLISHED = {("square", "silk"): True, ("square", "polyglactin"): False, ("square", "polypropylene"): False,
             ("square", "nylon"): False, ("surgeon's", "polyglactin"): False, ("surgeon's", "polypropylene"): False,
             ("surgeon's", "nylon"): False, ("three throws", "silk"): True, ("three throws", "polyglactin"): True,
             ("three throws", "polypropylene"): True, ("three throws", "nylon"): False}
# Mean and standard deviation of published strengths, N: knot, of which suture; the numbers are those of the page's table.
SCATTER = [("flat square, two turns", 41.21, 2.69, "a"), ("sliding square", 27.81, 16.27, "a"), ("4S slip knot", 28.01, 11.45, "a"),
           ("fisherman's", 22.45, 6.89, "a"), ("modified Roeder", 19.86, 9.30, "a"), ("Roeder", 15.77, 7.02, "a"),
           ("Weston", 7.28, 7.96, "a"), ("Duncan", 6.55, 0.95, "a"), ("half knot, three throws", 14.7, 3.0, "b"),
           ("two sliding half hitches", 15.4, 2.4, "b"), ("four sliding half hitches", 28.3, 10.0, "b")]
# Published share of knots that slipped or untied, and of how many knots: flat reef, surgeon's and square knots.
SHARES = [("flat reef, polyglactin 2-0", 11, 30, "c"), ("flat reef, nylon 1", 10, 30, "c"), ("flat reef, polydioxanone 3-0", 3, 30, "c"),
          ("flat reef, poliglecaprone 4-0", 0, 30, "c")]
FLOOR = 1e-2  # N: smaller forces are drawn here
LIMIT = 10.0  # N: the test ends at this force
ABOVE = 16.0  # N: the words of publications are drawn here
FRICTION, SEATING = 0.3, 5.0


def read_ratios():
    """Name, smallest and largest ratio of each row of the first table that has one."""
    rows = []
    for line in PAGE.read_text().split("## Bends")[0].splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) == 6 and re.match(r"-?[\d.]+( to -?[\d.]+)?$", cells[2].replace("−", "-")):
            ratio = [float(x) for x in cells[2].replace("−", "-").split(" to ")]
            rows.append((cells[0], ratio[0], ratio[-1]))
    return rows


def name_of(row):
    material = re.search(r"material=(\w+)", row["variant"])[1]
    return material + (", plastic" if "yield=" in row["variant"] else "")


def draw_ratios(axes, rows):
    for i, (_, low, high) in enumerate(reversed(rows)):
        axes.plot([low, high], [i, i], "o-", color="#0072B2", ms=4, lw=1.5)
    axes.axvline(1.0, color="black", lw=0.8)
    axes.set_yticks(range(len(rows)), [row[0] for row in reversed(rows)], fontsize=6)
    axes.set_xlabel("ours over published", fontsize=8)
    axes.tick_params(axis="x", labelsize=7)
    axes.grid(True, axis="x", lw=0.3)


def draw_knots(axes, runs):
    for m, material in enumerate(MATERIALS):
        for k, knot in enumerate(KNOTS):
            forces = [min(r["holds_N"], LIMIT) for r in runs
                      if (name_of(r), r["knot"], r["friction"], r["force"]) == (material, knot, FRICTION, SEATING)]
            axes.plot([k + 0.13 * (m - 2.5)] * len(forces), [max(f, FLOOR) for f in forces], "o", color=COLOURS[m], ms=4)
        axes.plot([], [], "o", color=COLOURS[m], ms=4, label=material)
        for k, knot in enumerate(KNOTS):
            if (knot, material) in PUBLISHED:
                axes.plot(k + 0.13 * (m - 2.5), ABOVE, "^" if PUBLISHED[knot, material] else "x", color=COLOURS[m], ms=5)
    axes.plot([], [], "^", color="black", ms=5, label="published: breaks before it slips")
    axes.plot([], [], "x", color="black", ms=5, label="published: slips or unties first")
    axes.axhline(LIMIT, color="black", lw=0.6, ls="--")
    axes.set_yscale("log")
    axes.set_ylim(0.8 * FLOOR, 25.0)
    axes.set_xticks(range(len(KNOTS)), NAMES, fontsize=6.5)
    axes.set_xlim(-0.6, len(KNOTS) - 0.4)
    axes.set_ylabel(f"held, N (friction {FRICTION}, seated with {SEATING:g} N; {LIMIT:g}: the test ends)", fontsize=7)
    axes.legend(fontsize=6, loc="lower right")
    axes.grid(True, axis="y", lw=0.3)


def our_scatter(runs):
    """Knot and relative standard deviation of our seeds, of cells with two finite forces or more."""
    cells = {}
    for r in runs:
        if (r["friction"], r["force"]) == (FRICTION, SEATING) and r["holds_N"] < LIMIT:
            cells.setdefault((r["knot"], name_of(r)), []).append(r["holds_N"])
    return [(f"{knot}, {material}", statistics.stdev(f) / statistics.mean(f), len(f))
            for (knot, material), f in cells.items() if len(f) >= 2]


def draw_scatter(axes, runs):
    """Relative standard deviations: published above, ours below."""
    rows = [(f"{name} [{source}]", deviation / mean, "#D55E00") for name, mean, deviation, source in SCATTER]
    rows += [(f"ours: {name} ({count})", ratio, "#0072B2") for name, ratio, count in our_scatter(runs)]
    for i, (_, ratio, colour) in enumerate(reversed(rows)):
        axes.plot([0.0, ratio], [i, i], "-", color=colour, lw=1.0)
        axes.plot(ratio, i, "o", color=colour, ms=4)
    axes.set_yticks(range(len(rows)), [row[0] for row in reversed(rows)], fontsize=6)
    axes.set_xlabel("standard deviation over mean of the strength", fontsize=8)
    axes.tick_params(axis="x", labelsize=7)
    axes.grid(True, axis="x", lw=0.3)


def draw_shares(axes, runs):
    """Share of knots that slip, with the standard error of a share: published, and ours below 10 N."""
    rows = [(f"{name} ({slipped} of {count}) [{source}]", slipped, count, "#D55E00") for name, slipped, count, source in SHARES]
    for material in ("silk", "polyglactin", "polypropylene", "nylon"):
        for knot in ("square", "three throws"):
            forces = [r["holds_N"] for r in runs
                      if (name_of(r), r["knot"], r["friction"], r["force"]) == (material, knot, FRICTION, SEATING)]
            slipped = sum(f < LIMIT for f in forces)
            rows.append((f"ours: {knot}, {material} ({slipped} of {len(forces)})", slipped, len(forces), "#0072B2"))
    for i, (_, slipped, count, colour) in enumerate(reversed(rows)):
        share = slipped / count
        error = (share * (1.0 - share) / count) ** 0.5
        axes.errorbar(share, i, xerr=error, fmt="o", color=colour, ms=4, lw=1.0, capsize=2)
    axes.set_yticks(range(len(rows)), [row[0] for row in reversed(rows)], fontsize=6)
    axes.set_xlim(-0.1, 1.1)
    axes.set_xlabel("share that slips (ours below 10 N)", fontsize=8)
    axes.tick_params(axis="x", labelsize=7)
    axes.grid(True, axis="x", lw=0.3)


def print_table(runs):
    print("| knot | friction | seated, N | material | knots | held 10 N | force, N |\n|---|---|---|---|---|---|---|")
    cells = {}
    for r in runs:
        cells.setdefault((r["knot"], r["friction"], r["force"], name_of(r)), []).append(r)
    order = sorted(cells, key=lambda c: (KNOTS.index(c[0]), c[1], -c[2], MATERIALS.index(c[3])))
    for cell in order:
        forces = sorted(min(r["holds_N"], LIMIT) for r in cells[cell])
        held = sum(f >= LIMIT for f in forces)
        text = [f"≥ {f:g}" if f >= LIMIT else f"{f:.2g}" for f in (statistics.median(forces), forces[0], forces[-1])]
        force = text[0] if len(forces) == 1 else f"{text[0]} ({text[1]} to {text[2]})"
        print(f"| {cell[0]} | {cell[1]} | {cell[2]:g} | {cell[3]} | {len(forces)} | {held} | {force} |")


def main():
    runs = [json.loads(line) for line in pathlib.Path(sys.argv[1]).read_text().splitlines()]
    runs = [r for r in runs if r["end"] not in ("failed", "given up", "stuck", "not seated")]
    figure, axes = plt.subplots(2, 2, figsize=(10.5, 8.2), width_ratios=(1.0, 1.3), height_ratios=(1.2, 1.0))
    draw_ratios(axes[0][0], read_ratios())
    draw_knots(axes[0][1], runs)
    draw_scatter(axes[1][0], runs)
    draw_shares(axes[1][1], runs)
    figure.tight_layout()
    figure.savefig(sys.argv[2], metadata={"Date": None})
    print_table(runs)


if __name__ == "__main__":
    main()
