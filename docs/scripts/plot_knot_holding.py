#!/usr/bin/python3
"""Makes the tables of docs/explanation/knot-holding.md and draws docs/pictures/contact-knot-holding.svg from what bench/knots_hold/run.py
has written, and checks the order that is claimed there.

    plot_knot_holding.py build/bench/knots-hold.json [docs/pictures/contact-knot-holding.svg]

Exits with 1 when the order does not hold. Forces at the limit are at least that, not equal to it: medians and their
intervals go by rank, so that does not matter below the limit.
"""
import json
import math
import random
import sys

KNOTS = ["square", "granny", "surgeon's", "fls", "half hitches", "reversed half hitches"]
SPRUNG = 3.0  # mm of a tail, drawn in while nothing but the thread itself pulled
SERIES = (0.25, 0.4)  # frictions at which the seating force is varied
PUBLISHED = 1.6
LEAST = 1e-3  # N: what is below is drawn there
# Where square > granny > half hitches is claimed, by friction: elsewhere many have sprung open before they are loaded.
CLAIMED = (0.3, 0.4)
COLOURS = {"square": "#0072B2", "granny": "#D55E00", "surgeon's": "#009E73", "fls": "#CC79A7",
           "half hitches": "#E69F00", "reversed half hitches": "#56B4E9"}


# ---- statistics

def quantile(values, share):
    ordered, at = sorted(values), share * (len(values) - 1)
    low = int(at)
    high = min(low + 1, len(ordered) - 1)
    return ordered[low] + (at - low) * (ordered[high] - ordered[low])


def interval(values):
    """Of the median, at least 95 %, by rank: no distribution is assumed."""
    n, below, rank = len(values), 0.0, 0
    while below + math.comb(n, rank) / 2 ** n <= 0.025:
        below += math.comb(n, rank) / 2 ** n
        rank += 1
    ordered = sorted(values)
    return ordered[max(rank - 1, 0)], ordered[min(n - rank, n - 1)]


def slope(points):
    """Of log force against log load."""
    logs = [(math.log(x), math.log(y)) for x, y in points]
    mx, my = (sum(p[i] for p in logs) / len(logs) for i in range(2))
    return (sum((x - mx) * (y - my) for x, y in logs) / sum((x - mx) ** 2 for x, _ in logs))


def exponent(cells):
    """With its 95 % interval: runs are drawn again within each load, two thousand times."""
    chance = random.Random(1)
    points = [[(r["seated_N"], r["holds_N"]) for r in cell] for cell in cells]
    drawn = sorted(slope([p for cell in points for p in chance.choices(cell, k=len(cell))])
                   for _ in range(2000))
    return slope([p for cell in points for p in cell]), drawn[50], drawn[1949]


# ---- what was measured

class Runs:
    """Without those that got stuck, which say nothing about the knot."""

    def __init__(self, rows):
        self.stuck = [r for r in rows if r["end"] in ("stuck", "not seated", "failed")]
        self.rows = [dict(r, holds_N=min(r["holds_N"], r["limit_N"]),
                          through_N=min(r["through_N"], r["limit_N"]))
                     for r in rows if r not in self.stuck]

    def cell(self, knot, friction, force, variant=""):
        return [r for r in self.rows if (r["knot"], r["friction"], r["force"], r["variant"]) ==
                (knot, friction, force, variant)]

    def cells(self):
        return sorted({(r["friction"], r["force"]) for r in self.rows if not r["variant"]})

    def variants(self):
        seen = {(r["knot"], r["friction"], r["force"], r["variant"]): None
                for r in self.rows if r["variant"]}
        return list(seen)


def write(force, limit=10.0):
    if force < 5e-4:
        return "0"
    return f"≥ {limit:g}" if force >= limit else f"{force:.2f}" if force >= 0.1 else f"{force:.3f}"


def write_interval(values):
    low, high = interval(values)
    return f"{write(low)} to {write(high)}"


def of(rows, name):
    return [r[name] for r in rows]


def sprung(rows):
    return [r for r in rows if r["let_go_slip_mm"] >= SPRUNG]


def comes_apart(row):
    return row["end"] == "open" or not row["type_kept"]


# ---- tables

def table(header, rows):
    print("| " + " | ".join(header) + " |\n|" + "---|" * len(header))
    for row in rows:
        print("| " + " | ".join(str(x) for x in row) + " |")
    print()


def print_all(runs):
    rows = []
    for friction, force in runs.cells():
        for knot in KNOTS:
            cell = runs.cell(knot, friction, force)
            holds, through = of(cell, "holds_N"), of(cell, "through_N")
            slips = [r for r in cell if r["end"] != "held"]
            kept = f"{sum(r['type_kept'] for r in slips)} of {len(slips)}" if slips else "-"
            rows.append([f"{friction:g}", f"{force:g}", knot, len(cell), write(quantile(holds, 0.5)),
                         f"{write(quantile(holds, 0.25))} to {write(quantile(holds, 0.75))}",
                         write_interval(holds),
                         f"{write(quantile(through, 0.5))} ({write_interval(through)})",
                         sum(r["end"] == "held" for r in cell), len(sprung(cell)),
                         sum(comes_apart(r) for r in cell), kept])
    table(["µ", "seated, N", "knot", "runs", "holds, N", "quartiles", "95 %", "through, N", "held", "sprung",
           "apart", "type kept"], rows)


def print_exponents(runs):
    rows = []
    for friction in SERIES:
        forces = [force for mu, force in runs.cells() if mu == friction]
        for knot in KNOTS:
            cells = [runs.cell(knot, friction, force) for force in forces]
            flat = [r for cell in cells for r in cell]
            held, opened = sum(r["end"] == "held" for r in flat), len(sprung(flat))
            fits = held == 0 and opened == 0
            rows.append([f"{friction:g}", knot] +
                        [write(quantile(of(cell, "holds_N"), 0.5)) for cell in cells] +
                        [held, opened, "{:.2f} ({:.2f} to {:.2f})".format(*exponent(cells)) if fits else "-"])
    table(["µ", "knot"] + [f"{force:g} N" for force in forces] + ["held", "sprung", "exponent"], rows)


def print_variants(runs):
    rows = []
    for knot, friction, force, variant in runs.variants():
        usual = of(runs.cell(knot, friction, force), "holds_N")
        other = of(runs.cell(knot, friction, force, variant), "holds_N")
        rows.append([knot, f"{friction:g}", f"{force:g}", variant,
                     f"{write(quantile(usual, 0.5))} ({write_interval(usual)})",
                     f"{write(quantile(other, 0.5))} ({write_interval(other)})"])
    table(["knot", "µ", "seated, N", "changed", "usual", "so"], rows)


def print_surgeons(runs):
    rows = []
    for friction, force in runs.cells():
        row = [f"{friction:g}", f"{force:g}"]
        for name in ("holds_N", "through_N"):
            for knot in ("square", "surgeon's"):
                values = of(runs.cell(knot, friction, force), name)
                row.append(f"{write(quantile(values, 0.5))} ({write_interval(values)})")
        rows.append(row)
    table(["µ", "seated, N", "square holds, N", "surgeon's holds, N", "square, through", "surgeon's, through"], rows)


def check(runs):
    """The order, cell by cell; with non-overlapping intervals."""
    good, rows = True, []
    for friction, force in runs.cells():
        by_knot = {k: interval(of(runs.cell(k, friction, force), "holds_N")) for k in KNOTS}
        above = [(a, b, by_knot[a][0] > by_knot[b][1]) for a, b in
                 (("square", "granny"), ("granny", "half hitches"), ("granny", "reversed half hitches"),
                  ("surgeon's", "square"), ("square", "surgeon's"))]
        claimed = friction in CLAIMED
        good &= not claimed or all(true for _, _, true in above[:2])
        rows.append([f"{friction:g}", f"{force:g}"] + ["yes" if true else "no" for _, _, true in above])
    table(["µ", "seated, N"] + [f"{a} > {b}" for a, b, _ in above], rows)
    return good


# ---- the plot

def draw_series(runs, axes, friction):
    forces = [force for mu, force in runs.cells() if mu == friction]
    for knot in KNOTS:
        cells = [of(runs.cell(knot, friction, force), "holds_N") for force in forces]
        middles = [max(quantile(c, 0.5), LEAST) for c in cells]
        ends = [interval(c) for c in cells]
        axes.errorbar(forces, middles,
                      yerr=[[m - max(low, LEAST) for m, (low, _) in zip(middles, ends)],
                            [max(high, LEAST) - m for m, (_, high) in zip(middles, ends)]],
                      color=COLOURS[knot], marker="o", ms=4, lw=1.0, capsize=2, label=knot)
    axes.plot(forces, [0.02 * f ** PUBLISHED for f in forces], "--", color="black", lw=1.0,
              label=f"slope {PUBLISHED}")
    axes.set_xscale("log")
    axes.set_xticks(forces, [f"{f:g}" for f in forces])
    axes.minorticks_off()
    axes.set_xlabel("seated with, N")
    axes.set_title(f"µ = {friction:g}", fontsize=9)


def draw(runs, file):
    import matplotlib
    matplotlib.use("Agg")
    matplotlib.rcParams["svg.hashsalt"] = "knot-holding"
    import matplotlib.pyplot as plt

    frictions = (0.2, 0.3, 0.4)
    figure, panels = plt.subplots(1, len(frictions) + len(SERIES), figsize=(15.0, 4.6), sharey=True)
    chance = random.Random(2)
    for axes, friction in zip(panels, frictions):
        for i, knot in enumerate(KNOTS):
            for k, force in enumerate((1.0, 5.0)):
                values = [max(v, LEAST) for v in of(runs.cell(knot, friction, force), "holds_N")]
                x = i - 0.18 + 0.36 * k
                axes.plot([x + 0.12 * (chance.random() - 0.5) for _ in values], values, ".", ms=3,
                          color=COLOURS[knot], alpha=0.6)
                low, high = interval(values)
                axes.plot([x, x], [low, high], color="black", lw=1.0)
                axes.plot(x, quantile(values, 0.5), "o" if k == 0 else "s", ms=5, color="black",
                          mfc="white" if k == 0 else "black")
        axes.set_xticks(range(len(KNOTS)), [k.replace("reversed half", "rev. half") for k in KNOTS],
                        rotation=60, ha="right", fontsize=8)
        axes.set_title(f"µ = {friction:g}", fontsize=9)
    for series, friction in zip(panels[len(frictions):], SERIES):
        draw_series(runs, series, friction)
    panels[-2].legend(fontsize=6, loc="lower right", framealpha=0.9)
    for axes in panels:
        axes.set_yscale("log")
        axes.grid(True, which="major", lw=0.3)
        axes.axhline(10.0, color="black", lw=0.6)
    panels[0].set_ylabel("holds, N (below 1 mN drawn there; line: limit)")
    figure.tight_layout()
    figure.savefig(file, metadata={"Date": None})


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        runs = Runs(json.load(file)["runs"])
    print_all(runs)
    print_exponents(runs)
    print_surgeons(runs)
    print_variants(runs)
    good = check(runs)
    if len(sys.argv) > 2:
        draw(runs, sys.argv[2])
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
