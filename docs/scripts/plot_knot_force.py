"""Draws docs/pictures/contact-knot-force.svg: the force that tightens overhand knots of one to four turns in a thin rod,
against the published curve (Jawed, Dieleman, Audoly, Reis 2015).

    build/default/tests/test_scene tightening_curve | python3 docs/scripts/plot_knot_force.py docs/pictures/contact-knot-force.svg
"""
import math
import re
import sys

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams["svg.hashsalt"] = "knot-force"
import matplotlib.pyplot as plt  # noqa: E402  (the backend comes first)

B = 1e-8  # N m^2, of the test's rod
COLOURS = {1: "#0072B2", 2: "#D55E00", 3: "#009E73", 4: "#CC79A7"}
MARKERS = {0.1: "o", 0.3: "s"}


def elliptic(m):
    a, b, total, power = 1.0, math.sqrt(1.0 - m), 0.5 * m, 1.0
    for _ in range(12):
        a, c, b = 0.5 * (a + b), 0.5 * (a - b), math.sqrt(a * b)
        total += power * c * c
        power *= 2.0
    first = 0.5 * math.pi / a
    return first, first * (1.0 - total)


def jawed(m):
    first, second = elliptic(m)
    loop = 4.0 * first
    braid = 8.0 * (first - second) / m - loop
    scale = math.sqrt(3.0) * math.pi ** 2
    return braid ** 2 / (braid + loop) / (8.0 * scale), braid ** 3 / (96.0 * scale)


def main():
    pattern = re.compile(r"turns (\d+) radius (\S+) friction (\S+) shortening (\S+) force (\S+) audoly (\S+)")
    figure, axes = plt.subplots(figsize=(6.4, 4.6))
    curve = [jawed(0.005 + 0.9 * i / 200) for i in range(201)]
    axes.loglog(*zip(*curve), color="black", lw=1.2, label="Jawed et al. 2015")
    seen = set()
    for match in map(pattern.search, sys.stdin):
        if not match:
            continue
        n, h, mu, e, force, audoly = (float(x) for x in match.groups())
        if mu == 0.0:
            continue
        x, unit = n * n * h / e, n * n * h * h / (mu * B)
        key = (int(n), mu)
        label = None if key in seen else f"n = {int(n)}, μ = {mu:g}"
        seen.add(key)
        axes.plot(x, force * unit, MARKERS.get(mu, "^"), color=COLOURS[int(n)], ms=7, label=label)
        if n == 1:
            axes.plot(x, audoly * unit, "x", color=COLOURS[1], ms=8,
                      label="Audoly et al. 2007, n = 1" if mu == 0.1 else None)
    axes.set_xlim(2e-4, 2e-2)
    axes.set_ylim(5e-5, 0.5)
    axes.set_xlabel("n² h / e")
    axes.set_ylabel("n² F h² / (μ B)")
    axes.legend(fontsize=8)
    axes.grid(True, which="both", lw=0.3)
    figure.tight_layout()
    figure.savefig(sys.argv[1], metadata={"Date": None})


if __name__ == "__main__":
    main()
