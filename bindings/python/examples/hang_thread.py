"""Hangs a thread from a clamp and compares its shape with the heavy elastica.

    python3 bindings/python/examples/hang_thread.py [segments] [--plot hanging.png]

A rod that does not stretch, clamped horizontally, under its own weight w per length: with the angle a below the
horizontal at arc length s,  EI a'' = -w (L - s) cos a,  a(0) = 0,  a'(L) = 0  (Frisch-Fay, Flexible Bars, 1962).
Solved here by shooting; the thread gets there by stepping with drag until it rests."""
import argparse
import math

import vblast_ss as vb

LENGTH = 0.05  # m
WEIGHT = 1.05e-4 * 9.81  # N/m, as the preset silk_2_0 has it
BENDING = 2.7e-8  # N m^2, likewise


def curve(weight, bending, length, parts=2000):
    """Points (x, y) of the closed problem: Runge-Kutta from the clamp, the curvature there by bisection."""
    def shoot(curvature):
        a, k, x, y, h = 0.0, curvature, 0.0, 0.0, length / parts
        points = [(x, y)]
        for i in range(parts):
            s = i * h

            def rate(s, a, k):
                return k, -weight / bending * (length - s) * math.cos(a), math.cos(a), -math.sin(a)

            r1 = rate(s, a, k)
            r2 = rate(s + h / 2, a + h / 2 * r1[0], k + h / 2 * r1[1])
            r3 = rate(s + h / 2, a + h / 2 * r2[0], k + h / 2 * r2[1])
            r4 = rate(s + h, a + h * r3[0], k + h * r3[1])
            a, k, x, y = (v + h / 6 * (p + 2 * q + 2 * r + t) for v, p, q, r, t in zip((a, k, x, y), r1, r2, r3, r4))
            points.append((x, y))
        return k, points

    low, high = 0.0, weight * length**2 / bending
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (low, middle) if shoot(middle)[0] > 0.0 else (middle, high)
    return shoot(low)[1]


def elastica(weight, bending, length, parts=2000):
    """Its tip."""
    return curve(weight, bending, length, parts)[-1]


def draw(positions):
    from matplotlib.figure import Figure
    figure = Figure(figsize=(5.6, 3.6), layout="constrained")
    axes = figure.subplots()
    points = curve(WEIGHT, BENDING, LENGTH)
    axes.plot([1e3 * x for x, _ in points], [1e3 * y for _, y in points], "k-", label="heavy elastica")
    axes.plot([1e3 * p[0] for p in positions], [1e3 * p[1] for p in positions], "o", markersize=4,
              label="nodes of the thread")
    axes.set_aspect("equal")
    axes.set_xlabel("x, mm")
    axes.set_ylabel("y, mm")
    axes.grid(alpha=0.3)
    axes.legend()
    axes.set_title(f"silk 2-0, {1e3 * LENGTH:.0f} mm, clamped at the left")
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("segments", nargs="?", type=int, default=50)
    parser.add_argument("--plot")
    chosen = parser.parse_args()
    segments = chosen.segments
    with vb.Thread(preset="silk_2_0", length=LENGTH, segment_count=segments, drag=40.0) as thread:
        thread.attach("clamp", 0, direction=(1, 0, 0))
        while thread.statistics.time < 2.0:
            thread.step(1e-3)
        x, y, _ = thread.positions[-1]
        wanted = elastica(WEIGHT, BENDING, LENGTH)
        off = math.hypot(x - wanted[0], y - wanted[1])
        print(f"tip of the thread   ({1e3 * x:.4f}, {1e3 * y:.4f}) mm, {segments} segments, {thread.statistics.steps} steps")
        print(f"tip of the elastica ({1e3 * wanted[0]:.4f}, {1e3 * wanted[1]:.4f}) mm")
        print(f"apart by {1e6 * off:.3g} um, {100 * off / LENGTH:.2g} % of the length")
        if chosen.plot:
            draw(thread.positions).savefig(chosen.plot)
            print(f"drawn: {chosen.plot}")


if __name__ == "__main__":
    main()
