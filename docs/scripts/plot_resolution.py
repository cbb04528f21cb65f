#!/usr/bin/python3
"""Draws docs/pictures/contact-speed-error.svg: what an overhand knot of ours costs over mesh and step against how well its length
is known. The paper's knots have no such length: they are a table in docs/explanation/contact.md.

    bench/run.sh contact --filter resolution
    plot_resolution.py build/bench/contact.json docs/pictures/contact-speed-error.svg
"""
import json
import re
import sys

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams["svg.hashsalt"] = "contact-speed-error"
import matplotlib.pyplot as plt  # noqa: E402  (the backend comes first)

NAME = re.compile(r"contact/resolution/ours-([0-9.]+)ms/([0-9.]+)")
COLOURS = {"0.5": "#0072B2", "1": "#D55E00", "2": "#009E73"}
MARKERS = {"0.5": "s", "1": "o", "2": "^"}


def read(path):
    """Points by step: segment (um), CPU of a simulated ms (us), error (mm), whether it is a knot still."""
    lines = {}
    for case in json.load(open(path))["benchmarks"]:
        match = NAME.fullmatch(case["name"])
        if match:
            step, segment = match.groups()
            point = (float(segment), case["us_per_ms"], case["taken_up_error_mm"], case["topology_kept"] > 0.5)
            lines.setdefault(step, []).append(point)
    return {step: sorted(points) for step, points in lines.items()}


def main():
    figure, axes = plt.subplots(figsize=(7.0, 4.4))
    for step, points in sorted(read(sys.argv[1]).items(), key=lambda line: float(line[0])):
        colour, marker = COLOURS[step], MARKERS[step]
        axes.loglog([p[1] for p in points], [p[2] for p in points], "-", color=colour, lw=0.8, alpha=0.5)
        label = f"step {step} ms"
        for segment, x, y, kept in points:
            axes.loglog(x, y, marker, color=colour, ms=6, mfc=colour if kept else "white", label=label)
            label = None
            axes.annotate(f"{segment / 1e3:g}", (x, y), fontsize=6, xytext=(4, 3), textcoords="offset points")
    axes.set_xlabel("CPU of a simulated ms, μs")
    axes.set_ylabel("error of the length taken up at 2 N, mm")
    axes.set_title("Overhand knot; hollow: no knot any more; numbers: segment, mm", fontsize=9)
    axes.legend(fontsize=7)
    figure.tight_layout()
    figure.savefig(sys.argv[2], metadata={"Date": None})


if __name__ == "__main__":
    main()
