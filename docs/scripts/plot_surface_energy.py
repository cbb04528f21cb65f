"""Draws docs/pictures/surface-energy.svg: the largest energy of a ball that falls on a host surface, over its mass.

    VBSS_PRINT=1 build/default/tests/test_scene surface_energy | python3 docs/scripts/plot_surface_energy.py docs/pictures/surface-energy.svg
"""
import re
import sys

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams["svg.hashsalt"] = "surface-energy"
import matplotlib.pyplot as plt  # noqa: E402  (the backend comes first)

COLOURS = {0.0: "#D55E00", 0.5: "#E69F00", 0.75: "#0072B2", 1.0: "#009E73"}
LIMITS = {0.0: 1.0 / 3.0, 0.5: 1.0}  # 1 / (3 - 4 s): below, the closed solution is stable
MARKERS = {(0.01, 0.25): "o", (1.0, 0.25): "s", (10.0, 0.25): "D", (0.01, 1.0): "x", (1.0, 1.0): "+", (10.0, 1.0): "1"}


def main():
    pattern = re.compile(r"stated (\S+) ratio (\S+) stiffening (\S+) h (\S+) growth \S+ energy (\S+)")
    figure, axes = plt.subplots(figsize=(6.4, 4.4))
    seen = set()
    for match in map(pattern.search, sys.stdin):
        if match:
            stated, ratio, stiffening, h, energy = (float(x) for x in match.groups())
            label = None if stated in seen else f"s = {stated:g}"
            seen.add(stated)
            axes.loglog(ratio, energy, MARKERS[(stiffening, round(1e3 * h, 2))], color=COLOURS[stated], ms=6, label=label)
    for stated, limit in LIMITS.items():
        axes.axvline(limit, color=COLOURS[stated], ls="--", lw=1.0)
    axes.axhline(1.0, color="black", lw=0.8)
    axes.set_xlabel("mass of the ball / mass that a force of one step meets")
    axes.set_ylabel("largest energy / energy at the start")
    axes.legend(frameon=False)
    figure.tight_layout()
    figure.savefig(sys.argv[1], metadata={"Date": None})


main()
