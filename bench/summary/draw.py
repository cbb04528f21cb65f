"""The plot "speed against error": a panel a subject, best at the lower left."""
import math
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
from plot_suite import COLOURS, MARKERS, plt, set_log  # noqa: E402

OURS = COLOURS[0]
PEERS = COLOURS[1:] + ["#999933", "#882255"]
COLUMNS = 4


def styles(points):
    """Colour and marker of each method, the same in all panels."""
    made, number = {}, 0
    for point in points:
        if point.method not in made:
            if point.ours:
                made[point.method] = (OURS, MARKERS[0])
            else:
                made[point.method] = (PEERS[number % len(PEERS)], MARKERS[1:][(number + number // len(PEERS)) % (len(MARKERS) - 1)])
                number += 1
    return made


def draw_panel(axes, subject, points, style):
    positive = [q.error for q in points if q.error > 0.0]
    floor = min(positive, default=1.0) / 4.0
    for method in dict.fromkeys(q.method for q in points):
        of = sorted((q for q in points if q.method == method), key=lambda q: q.cost)
        colour, marker = style[method]
        axes.plot([q.cost for q in of], [max(q.error, floor) for q in of], color=colour, linewidth=0.9, alpha=0.6)
        for q in of:
            whole = q.error > 0.0 and not q.note
            axes.plot(q.cost, max(q.error, floor), marker, color=colour, markersize=5.5,
                      markerfacecolor=colour if whole else "white", label="ours" if q.ours else method)
    set_log(axes.xaxis, [q.cost for q in points])
    set_log(axes.yaxis, [max(q.error, floor) for q in points])
    axes.set_title(subject.title, loc="left", fontsize=9, fontweight="bold")
    axes.set_xlabel(subject.cost, fontsize=8)
    axes.set_ylabel(subject.error, fontsize=8)
    axes.tick_params(labelsize=7)
    axes.grid(which="major", color="#EEEEEE")


def draw(subjects, points, stem):
    """Writes stem.svg and stem.png."""
    plt.rcParams.update({"font.size": 9, "axes.spines.top": False, "axes.spines.right": False, "svg.hashsalt": "vbss",
                         "axes.axisbelow": True})
    shown = [s for s in subjects if any(q.subject == s.name for q in points)]
    rows = math.ceil((len(shown) + 1) / COLUMNS)
    figure, grid = plt.subplots(rows, COLUMNS, squeeze=False, figsize=(3.5 * COLUMNS, 3.0 * rows), layout="constrained")
    panels, style, handles = list(grid.flat), styles(points), {}
    for axes, subject in zip(panels, shown):
        draw_panel(axes, subject, [q for q in points if q.subject == subject.name], style)
        handles.update((label, handle) for handle, label in zip(*axes.get_legend_handles_labels()))
    for axes in panels[len(shown):]:
        axes.axis("off")
    if len(panels) > len(shown):
        panels[len(shown)].legend(handles.values(), handles.keys(), loc="upper left", fontsize=7, frameon=False,
                                  title="hollow: no error, or the knot is lost", title_fontsize=7)
    for kind, options in (("svg", {"metadata": {"Date": None}}), ("png", {"dpi": 110})):
        figure.savefig(f"{stem}.{kind}", **options)
    plt.close(figure)
