#!/usr/bin/python3
"""Draws SVG plots of bench results: plot.py build/bench/<suite>.json ...

For each file, beside it:
  <suite>-work-precision.svg  time against error, a curve a method   (scenes with N and an error)
  <suite>-methods.svg         time and errors, a dot a method        (scenes without N)
  <suite>-growth.svg          time against N, a curve a method       (scenes with several N)
  <suite>-percentiles.svg     median, p99, p99.9, max of a step      (stepped cases)
A plot without data is not made, and one left from an earlier run is removed.
"""
import json
import math
import os
import re
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend comes first)
from matplotlib.ticker import LogLocator, MaxNLocator, NullFormatter  # noqa: E402

# Okabe and Ito's palette, told apart by colour-blind readers too; markers say the same again.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"]
MARKERS = ["o", "s", "^", "D", "v", "P", "X"]
# One hue, light to dark: the tail is lightest.
PERCENTILES = [("max", "max_us", "#DCE6F1"), ("p99.9", "p999_us", "#A6C3DF"),
               ("p99", "p99_us", "#5B94C4"), ("median", "median_us", "#08519C")]
ERROR_NAMES = re.compile(r"error|_ulp|^(fp|fn|undecided)$")
COUNTS = {"fp": "false positives", "fn": "false negatives", "undecided": "undecided queries"}
KINDS = ["work-precision", "methods", "growth", "percentiles"]
UNITS = {"us": "µs", "ns": "ns", "mm": "mm", "um": "µm", "rad": "rad", "ulp": "ulp"}


class Case:
    """One entry of benchmarks[] that has a time."""

    def __init__(self, entry):
        parts = entry["name"].split("/")
        self.entry = entry
        self.scene, self.method = parts[1], parts[2]
        self.label = parts[3] if len(parts) > 3 else ""
        digits = re.match(r"\d+", self.label)
        self.n = int(digits.group()) if digits else None
        self.growth = entry["run_type"] == "aggregate"
        self.unit = entry["time_unit"]

    def number(self, counter):
        """The counter as a number, None when it is absent or null."""
        value = self.entry.get(counter)
        return float(value) if isinstance(value, (int, float)) else None

    def errors(self):
        return [name for name, value in self.entry.items()
                if ERROR_NAMES.search(name) and isinstance(value, (int, float))
                and not isinstance(value, bool)]


def unique(values):
    return list(dict.fromkeys(values))


def times(cases):
    """The times to compare these cases by, and the label of their axis."""
    if all(c.number("us_per_ms") is not None for c in cases):
        return [c.number("us_per_ms") for c in cases], "CPU time (µs per simulated ms)"
    unit = cases[0].unit
    what = "step" if unit == "us" else "item"
    return [c.number("cpu_time") for c in cases], f"CPU time per {what} ({UNITS.get(unit, unit)})"


def axis_name(counter):
    if counter in COUNTS:
        return COUNTS[counter]
    words = counter.split("_")
    unit = UNITS.get(words[-1])
    if unit and len(words) > 1:
        return f"{' '.join(words[:-1])} ({unit})"
    return " ".join(words)


def short(value):
    return f"{value:.3g}" if value < 1000 else f"{value:.0f}"


class Suite:
    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            data = json.load(file)
        self.context = data["context"]
        self.stem = os.path.splitext(path)[0]
        self.name = self.context["executable"]
        entries = [e for e in data["benchmarks"] if e.get("time_unit")]
        self.cases = [Case(e) for e in entries if not e.get("error_occurred")]
        methods = unique(c.method for c in self.cases)
        self.colour = {m: COLOURS[i % len(COLOURS)] for i, m in enumerate(methods)}
        self.marker = {m: MARKERS[i % len(MARKERS)] for i, m in enumerate(methods)}

    def timed(self):
        return [c for c in self.cases if not c.growth]

    def scene(self, name):
        return [c for c in self.timed() if c.scene == name]

    def caption(self):
        c = self.context
        words = [c["cpu_model"], c["compiler"], c["date"][:10], "git " + c["git"]]
        if c["quick"]:
            words.append("QUICK RUN, not a measurement")
        return "   ".join(w for w in words if w)

    def save(self, figure, kind, title):
        # Inches from the edges, so that title and caption look alike at every size of figure.
        height = figure.get_figheight()
        figure.text(0.012, 1 - 0.08 / height, f"{self.name}: {title}", ha="left", va="top",
                    fontsize=11, fontweight="bold")
        figure.text(0.012, 0.07 / height, self.caption(), fontsize=7, color="#555555", ha="left",
                    va="bottom")
        figure.tight_layout(rect=(0, 0.24 / height, 1, 1 - 0.32 / height))
        path = f"{self.stem}-{kind}.svg"
        figure.savefig(path, metadata={"Date": None})
        plt.close(figure)
        return path


def grid_of_panels(count):
    columns = min(count, 3)
    rows = math.ceil(count / columns)
    figure, axes = plt.subplots(rows, columns, figsize=(max(4.6 * columns, 6.4), 3.7 * rows + 0.5),
                                squeeze=False)
    panels = list(axes.flat)
    for unused in panels[count:]:
        unused.set_visible(False)
    return figure, panels[:count]


def set_log(axis, values):
    """Log scale; a range below one decade gets readable ticks of its own."""
    name = axis.axis_name
    getattr(axis.axes, f"set_{name}scale")("log")
    low, high = min(values), max(values)
    margin = max((high / low) ** 0.08, 1.15)
    getattr(axis.axes, f"set_{name}lim")(low / margin, high * margin)
    if high / low < 30:
        narrow = high / low < 3
        axis.set_major_locator(MaxNLocator(5) if narrow else LogLocator(subs=(1.0, 2.0, 5.0)))
        axis.set_major_formatter(lambda v, _: f"{v:g}")
        axis.set_minor_formatter(NullFormatter())


def legend_or_label(axes, suite, methods):
    if len(methods) > 1:
        axes.legend(frameon=False, fontsize=8)
    else:
        axes.set_title(axes.get_title(loc="left") + f"  ({methods[0]})", loc="left", fontsize=9)


def plot_work_precision(suite):
    panels = []
    for scene in unique(c.scene for c in suite.timed() if c.label):
        cases = [c for c in suite.scene(scene) if c.label]
        for counter in unique(e for c in cases for e in c.errors()):
            having = [c for c in cases if c.number(counter) is not None]
            if any(c.number(counter) > 0 for c in having):
                panels.append((scene, counter, having))
    if not panels:
        return None
    figure, axes_list = grid_of_panels(len(panels))
    for axes, (scene, counter, cases) in zip(axes_list, panels):
        seconds, time_name = times(cases)
        errors = [c.number(counter) for c in cases]
        # An error of zero has no place on a log axis: drawn hollow at the left edge.
        floor = min(e for e in errors if e > 0) / 3
        shown = [e if e > 0 else floor for e in errors]
        methods = unique(c.method for c in cases)
        for method in methods:
            points = sorted((c.n or 0, i) for i, c in enumerate(cases) if c.method == method)
            order = [i for _, i in points]
            axes.plot([shown[i] for i in order], [seconds[i] for i in order], "-",
                      color=suite.colour[method], marker=suite.marker[method], markersize=5,
                      linewidth=1.3, label=method)
            for i in order:
                if errors[i] <= 0:
                    axes.plot(shown[i], seconds[i], marker=suite.marker[method], markersize=5,
                              color=suite.colour[method], markerfacecolor="white")
                axes.annotate(cases[i].label, (shown[i], seconds[i]), xytext=(5, 4),
                              textcoords="offset points", fontsize=7, color=suite.colour[method])
        set_log(axes.xaxis, shown)
        set_log(axes.yaxis, seconds)
        hollow = ", hollow: 0" if min(errors) <= 0 else ""
        axes.set_xlabel(axis_name(counter) + hollow)
        axes.set_ylabel(time_name)
        axes.set_title(scene, loc="left", fontsize=9)
        legend_or_label(axes, suite, methods)
    return suite.save(figure, "work-precision", "time against error (best: lower left; labels: N)")


def plot_methods(suite):
    """Scenes without N have one point a method: dots in rows are read faster than such curves."""
    groups = {}
    for scene in unique(c.scene for c in suite.timed() if not c.label):
        cases = [c for c in suite.scene(scene) if not c.label]
        key = (times(cases)[1], tuple(unique(e for c in cases for e in c.errors())))
        groups.setdefault(key, []).append((scene, cases))
    if not groups:
        return None
    columns = 1 + max(len(errors) for _, errors in groups)
    rows = [len(scenes) for scenes in groups.values()]
    figure, grid = plt.subplots(len(groups), columns, squeeze=False,
                                figsize=(2.2 + 3.6 * columns, 0.3 * sum(rows) + len(rows) + 0.7),
                                gridspec_kw={"height_ratios": [r + 1.5 for r in rows]})
    for row, ((time_name, errors), scenes) in zip(grid, groups.items()):
        for axes in row[1 + len(errors):]:
            axes.set_visible(False)
        draw_dots(suite, row[0], scenes, time_name, lambda c: times([c])[0][0])
        row[0].set_yticks(range(len(scenes)), [s for s, _ in scenes], fontsize=8)
        for axes, counter in zip(row[1:], errors):
            draw_dots(suite, axes, scenes, axis_name(counter), lambda c: c.number(counter))
            axes.set_yticks(range(len(scenes)), [])
        methods = unique(c.method for _, cases in scenes for c in cases)
        for method in methods:
            row[0].plot([], [], suite.marker[method], color=suite.colour[method], label=method)
        legend = row[0].legend(frameon=False, fontsize=8, ncol=len(methods), loc="lower left",
                               bbox_to_anchor=(0, 1), borderpad=0.1, handletextpad=0.2)
        legend.set_in_layout(False)  # it may be wider than its panel: let it, and only
        row[0].set_title(" ", fontsize=9)  # keep its line free
    return suite.save(figure, "methods", "time and error by method (left is better)")


def draw_dots(suite, axes, scenes, name, read):
    values = []
    for y, (_, cases) in enumerate(scenes):
        having = [(c, read(c)) for c in cases if read(c) is not None]
        if having:
            xs = [x for _, x in having]
            values += xs
            axes.plot([min(xs), max(xs)], [y, y], "-", color="#CCCCCC", linewidth=1.5, zorder=1)
        for i, (case, x) in enumerate(having):
            # A little apart, or equal values would hide each other.
            dodged = y + 0.18 * (i - 0.5 * (len(having) - 1)) / max(1, 0.5 * (len(having) - 1))
            axes.plot(x, dodged, suite.marker[case.method], color=suite.colour[case.method],
                      markersize=5, zorder=2)
    if values and min(values) > 0 and max(values) / min(values) > 3:
        set_log(axes.xaxis, values)
    elif values and max(values) > 0 and min(values) >= 0 and max(values) > 100:
        axes.set_xscale("symlog", linthresh=1)
        axes.set_xlim(left=-0.3)
    else:
        axes.set_xlim(0, max(values, default=1) * 1.08 or 1)
    axes.set_ylim(len(scenes) - 0.4, -0.6)
    axes.set_xlabel(name, fontsize=8)
    axes.tick_params(axis="x", labelsize=8)
    axes.tick_params(axis="y", length=0)
    axes.grid(axis="x", which="major", color="#EEEEEE")
    axes.spines["left"].set_visible(False)


def plot_growth(suite):
    panels = []
    for scene in unique(c.scene for c in suite.timed() if c.n):
        cases = [c for c in suite.scene(scene) if c.n]
        if len({c.n for c in cases}) > 1:
            panels.append((scene, cases))
    if not panels:
        return None
    figure, axes_list = grid_of_panels(len(panels))
    for axes, (scene, cases) in zip(axes_list, panels):
        seconds, time_name = times(cases)
        methods = unique(c.method for c in cases)
        for method in methods:
            points = sorted((c.n, t) for c, t in zip(cases, seconds) if c.method == method)
            exponents = [c.number("exponent") for c in suite.cases
                         if c.growth and c.scene == scene and c.method == method]
            fit = f", $N^{{{exponents[0]:.2f}}}$" if exponents else ""
            axes.plot([n for n, _ in points], [t for _, t in points], "-", label=method + fit,
                      color=suite.colour[method], marker=suite.marker[method], markersize=5,
                      linewidth=1.3)
        set_log(axes.xaxis, [c.n for c in cases])
        set_log(axes.yaxis, seconds)
        axes.set_xlabel("N")
        axes.set_ylabel(time_name)
        axes.set_title(scene, loc="left", fontsize=9)
        axes.grid(which="major", color="#EEEEEE")
        if len(methods) > 3:  # too many for a corner
            axes.legend(frameon=False, fontsize=8, loc="center left", bbox_to_anchor=(1, 0.5))
        else:
            axes.legend(frameon=False, fontsize=8)
    return suite.save(figure, "growth", "time against N")


def plot_percentiles(suite):
    cases = [c for c in suite.timed() if c.number("p999_us") is not None]
    if not cases:
        return None
    cases.sort(key=lambda c: (c.scene, c.n or 0))  # stable: methods stay in their order
    figure, axes = plt.subplots(figsize=(8.2, 0.27 * len(cases) + 1.5))
    everything = [c.number(counter) for c in cases for _, counter, _ in PERCENTILES]
    log = max(everything) > 20 * min(everything)
    start = min(everything) / 2 if log else 0.0
    for name, counter, colour in PERCENTILES:
        lengths = [c.number(counter) - start for c in cases]
        axes.barh(range(len(cases)), lengths, left=start, height=0.72, color=colour, label=name)
    for y, case in enumerate(cases):
        axes.annotate(f"{short(case.number('median_us'))} … {short(case.number('max_us'))}",
                      (case.number("max_us"), y), xytext=(4, 0), textcoords="offset points",
                      va="center", fontsize=7, color="#333333")
    deadlines = unique(c.number("deadline_us") for c in cases if c.number("deadline_us"))
    high = max(everything + deadlines)
    for deadline in deadlines:
        axes.axvline(deadline, color="#D55E00", linewidth=1, linestyle="--")
        axes.annotate(f"deadline {deadline:g} µs", (deadline, -0.55), xytext=(-3, 0), ha="right",
                      va="center", textcoords="offset points", fontsize=7, color="#D55E00")
    if log:
        axes.set_xscale("log")
    axes.set_xlim(start, high * (2.5 if log else 1.2))
    axes.set_ylim(len(cases) - 0.5, -1.0)
    axes.set_yticks(range(len(cases)), [" / ".join(filter(None, (c.scene, c.method, c.label)))
                                        for c in cases], fontsize=8)
    axes.tick_params(axis="y", length=0)
    axes.set_xlabel("CPU time of a step (µs)")
    handles, labels = axes.get_legend_handles_labels()
    axes.legend(handles[::-1], labels[::-1], frameon=False, fontsize=8, ncol=4, loc="lower left",
                bbox_to_anchor=(0, 1), borderpad=0.1)
    return suite.save(figure, "percentiles", "step times (numbers: median … max)")


def main(paths):
    plt.rcParams.update({"font.size": 9, "axes.spines.top": False, "axes.spines.right": False,
                         "svg.hashsalt": "vbss", "axes.axisbelow": True})
    plots = [plot_work_precision, plot_methods, plot_growth, plot_percentiles]
    for path in paths:
        suite = Suite(path)
        made = {plot(suite) for plot in plots}
        for kind in KINDS:
            name = f"{suite.stem}-{kind}.svg"
            if name in made:
                print(name)
            elif os.path.exists(name):
                os.remove(name)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(sys.argv[1:])
