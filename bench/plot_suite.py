"""What the plots of bench/plot.py share: a suite's cases as read from its file, colours, axes."""
import json
import math
import os
import re

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend comes first)
from matplotlib.ticker import LogLocator, MaxNLocator, NullFormatter  # noqa: E402

# Okabe and Ito's palette, told apart by colour-blind readers too; markers say the same again.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"]
MARKERS = ["o", "s", "^", "D", "v", "P", "X"]
ERROR_NAMES = re.compile(r"error|_ulp|^(fp|fn|undecided)$")
COUNTS = {"fp": "false positives", "fn": "false negatives", "undecided": "undecided queries"}
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
        self.colour, self.marker, self.line = {}, {}, {}
        for i, method in enumerate(methods):
            # When the colours have run out they come again with another marker, dashed.
            lap = i // len(COLOURS)
            self.colour[method] = COLOURS[i % len(COLOURS)]
            self.marker[method] = MARKERS[(i + lap) % len(MARKERS)]
            self.line[method] = "--" if lap % 2 else "-"

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


def draw_curve(suite, axes, method, xs, ys, label):
    axes.plot(xs, ys, suite.line[method], color=suite.colour[method], marker=suite.marker[method],
              markersize=5, linewidth=1.3, label=label)


def legend_beside(axes):
    axes.legend(frameon=False, fontsize=8, loc="center left", bbox_to_anchor=(1, 0.5))
