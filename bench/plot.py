#!/usr/bin/python3
"""Draws SVG plots of bench results: plot.py build/bench/<suite>.json ...

For each file, beside it:
  <suite>-work-precision.svg  error against time, a curve a method   (scenes with N and an error)
  <suite>-speed-error.svg     wrong answers against time             (sets of questions: fp and fn)
  <suite>-methods.svg         time and errors, a dot a method        (scenes without N)
  <suite>-growth.svg          time against N, a curve a method       (scenes with several N)
  <suite>-percentiles.svg     median, p99, p99.9, max of a step      (stepped cases)
A plot without data is not made, and one left from an earlier run is removed.
"""
import os
import sys

sys.dont_write_bytecode = True  # nothing is left beside the scripts
from matplotlib.ticker import NullLocator  # noqa: E402
from plot_suite import (Suite, axis_name, draw_curve, grid_of_panels, legend_beside,  # noqa: E402
                        legend_or_label, plt, set_log, short, times, unique)

KINDS = ["work-precision", "speed-error", "methods", "growth", "percentiles"]
# One hue, light to dark: the tail is lightest.
PERCENTILES = [("max", "max_us", "#DCE6F1"), ("p99.9", "p999_us", "#A6C3DF"),
               ("p99", "p99_us", "#5B94C4"), ("median", "median_us", "#08519C")]


def place_labels(axes, labels):
    """Beside each point, where it is free of what stands there already; left out where nothing is."""
    to_points = 72.0 / axes.figure.dpi
    marks = [tuple(axes.transData.transform((x, y)) * to_points) for x, y, _, _ in labels]
    taken = [(px - 3, py - 3, px + 3, py + 3) for px, py in marks]
    for (px, py), (x, y, text, colour) in zip(marks, labels):
        wide = 4.2 * len(text)
        for dx, dy in [(4, 4), (-wide - 4, -10), (4, -10), (-wide - 4, 4), (-wide / 2, 5),
                       (-wide / 2, -12)]:
            box = (px + dx, py + dy, px + dx + wide, py + dy + 6)
            if not any(box[0] < other[2] and other[0] < box[2] and box[1] < other[3] and
                       other[1] < box[3] for other in taken):
                taken.append(box)
                axes.annotate(text, (x, y), xytext=(dx, dy), textcoords="offset points", fontsize=7,
                              color=colour)
                break


def draw_work_precision(suite, axes, scene, counter, cases):
    seconds, time_name = times(cases)
    errors = [c.number(counter) for c in cases]
    # An error of zero has no place on a log axis: drawn hollow at the lower edge.
    floor = min(e for e in errors if e > 0) / 3
    shown = [e if e > 0 else floor for e in errors]
    methods = unique(c.method for c in cases)
    labels = []
    for method in methods:
        points = sorted((c.n or 0, i) for i, c in enumerate(cases) if c.method == method)
        order = [i for _, i in points]
        draw_curve(suite, axes, method, [seconds[i] for i in order], [shown[i] for i in order],
                   method)
        for i in order:
            if errors[i] <= 0:
                axes.plot(seconds[i], shown[i], marker=suite.marker[method], markersize=5,
                          color=suite.colour[method], markerfacecolor="white")
            labels.append((seconds[i], shown[i], cases[i].label, suite.colour[method]))
    set_log(axes.xaxis, seconds)
    set_log(axes.yaxis, shown)
    place_labels(axes, labels)
    hollow = ", hollow: 0" if min(errors) <= 0 else ""
    axes.set_xlabel(time_name)
    axes.set_ylabel(axis_name(counter) + hollow)
    axes.set_title(scene, loc="left", fontsize=9)
    axes.grid(which="major", color="#EEEEEE")
    return methods


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
    for i, (axes, (scene, counter, cases)) in enumerate(zip(axes_list, panels)):
        methods = draw_work_precision(suite, axes, scene, counter, cases)
        last_of_scene = i + 1 == len(panels) or panels[i + 1][0] != scene
        if len(methods) > 3 and last_of_scene:  # one for the scene, and too many for a corner
            legend_beside(axes)
        elif len(methods) <= 3:
            legend_or_label(axes, suite, methods)
    return suite.save(figure, "work-precision", "error against time (best: lower left; labels: N)")


# Counter, what it is a share of, and its axis.
WRONG_ANSWERS = [("fn", lambda c: c.number("positives"), "true hits missed (%)"),
                 ("fp", lambda c: c.number("queries") - c.number("positives"),
                  "true misses told as hits (%)")]
MIN_SHARE = 0.01  # %; below it the axis is linear, down to 0


def draw_speed_error(suite, axes, cases, counter, possible):
    seconds, _ = times(cases)
    shares = [100 * c.number(counter) / max(possible(c), 1) for c in cases]
    for i, (case, x, share) in enumerate(zip(cases, seconds, shares)):
        # The first methods lie on top.
        axes.plot(x, share, suite.marker[case.method], color=suite.colour[case.method],
                  markersize=6, linestyle="", clip_on=False, zorder=4 - i / len(cases),
                  label=case.method)
    set_log(axes.xaxis, seconds)
    axes.set_yscale("symlog", linthresh=MIN_SHARE, linscale=0.6)
    axes.set_ylim(0, 100)
    axes.set_yticks([0, 0.01, 0.1, 1, 10, 100], ["0", "0.01", "0.1", "1", "10", "100"])
    axes.yaxis.set_minor_locator(NullLocator())
    axes.grid(which="major", color="#EEEEEE")
    axes.spines["bottom"].set_color("#009E73" if counter == "fn" else "#BBBBBB")


def plot_speed_error(suite):
    """A row a set, missed hits beside invented ones: who stands on the lower edge has none."""
    scenes = []
    for scene in unique(c.scene for c in suite.timed() if not c.label):
        cases = [c for c in suite.scene(scene) if not c.label]
        if all(c.number(name) is not None for c in cases for name in ("fp", "fn", "queries")):
            scenes.append((scene, cases))
    names = [scene for scene, _ in scenes]
    # A set that is a part of another one adds nothing here.
    scenes = [(s, cases) for s, cases in scenes if not any(s.startswith(n + "-") for n in names)]
    if not scenes:
        return None
    figure, grid = plt.subplots(len(scenes), 2, squeeze=False,
                                figsize=(10.6, 2.3 * len(scenes) + 0.8))
    for row, (scene, cases) in zip(grid, scenes):
        for axes, (counter, possible, name) in zip(row, WRONG_ANSWERS):
            draw_speed_error(suite, axes, cases, counter, possible)
            axes.set_ylabel(name, fontsize=8)
            axes.set_xlabel("CPU time per question (ns)", fontsize=8)
        row[0].set_title(f"{scene}: {cases[0].number('queries'):.0f} questions, "
                         f"{cases[0].number('positives'):.0f} hits", loc="left", fontsize=9)
    shown = {}  # one legend for all: not every method takes every set
    for axes in grid.flat:
        shown.update((label, handle) for handle, label in zip(*axes.get_legend_handles_labels()))
    grid[0][1].legend(shown.values(), shown.keys(), frameon=False, fontsize=8, loc="upper left",
                      bbox_to_anchor=(1.02, 1.0))
    return suite.save(figure, "speed-error", "wrong answers against time (best: lower left)")


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
                               bbox_to_anchor=(0, 1), borderpad=0.1, handletextpad=0.2,
                               columnspacing=2.0 if len(methods) < 10 else 1.0)
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
            fits = [c for c in suite.cases if c.growth and c.scene == scene and c.method == method]
            label = method + "".join(f", $N^{{{c.number('exponent'):.2f}}}$ to "
                                     f"{c.number('n_max'):.0f}" for c in fits)
            draw_curve(suite, axes, method, [n for n, _ in points], [t for _, t in points], label)
        set_log(axes.xaxis, [c.n for c in cases])
        set_log(axes.yaxis, seconds)
        axes.set_xlabel("N")
        axes.set_ylabel(time_name)
        axes.set_title(scene, loc="left", fontsize=9)
        axes.grid(which="major", color="#EEEEEE")
        if len(methods) > 3:  # too many for a corner
            legend_beside(axes)
        else:
            axes.legend(frameon=False, fontsize=8)
    return suite.save(figure, "growth", "time against N")


def plot_percentiles(suite):
    cases = [c for c in suite.timed() if c.number("p999_us") is not None]
    if not cases:
        return None
    if len(cases) > 150:  # of each scene and method the largest stands for all sizes
        largest = {}
        for c in cases:
            key = (c.scene, c.method)
            if key not in largest or (c.n or 0) > (largest[key].n or 0):
                largest[key] = c
        cases = list(largest.values())
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
                      va="center", fontsize=7, color="#333333",
                      bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.5})
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
    plots = [plot_work_precision, plot_speed_error, plot_methods, plot_growth, plot_percentiles]
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
