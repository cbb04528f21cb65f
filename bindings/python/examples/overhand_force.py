"""Pulls a loose overhand knot in a thin rod tight, and compares the force with the published curves.

    python3 bindings/python/examples/overhand_force.py [--friction 0.1] [--steps 9000] [--plot overhand.png]

h is the rod's radius, B its bending stiffness, e how much shorter the knot makes it, R the radius of curvature where the
loop leaves the braid (the least there is), n = 1 the number of turns.
- Audoly, Clauvelin, Neukirch (Phys. Rev. Lett. 99, 164301, 2007), for loose knots of one turn:
  F = B / (2 R^2) + mu 0.492 B / (h^1/2 R^3/2).
- Jawed, Dieleman, Audoly, Reis (Phys. Rev. Lett. 115, 118302, 2015), for many turns, without the loop's own pull: of
  the elastica of parameter m, with the complete elliptic integrals K and E,  x = 8 (K - E) / m - 4 K,
  h / e = x^2 / (x + 4 K) / (8 sqrt3 pi^2),  F h^2 / (mu B) = x^3 / (96 sqrt3 pi^2). For n = 1 about twice too high."""
import argparse
import math

import vblast_ss as vb

RADIUS = 25e-6  # m
BENDING = 1e-8  # N m^2
LOOP = 9.5e-3  # radius in the begin, m
TAIL = 0.03
FINE, COARSE = 0.2e-3, 1e-3
SPEED = 2e-3  # m/s, of each end; at 8 mm/s the drag adds a third to the least forces


def loose_knot():
    """Nodes of two strands that wind about each other along x by three half turns, a loop below them, and tails."""
    gap = 1.5 * RADIUS
    braid = 11.7 * 0.6 * math.sqrt(RADIUS * LOOP)
    half = math.pi * LOOP
    around = braid + 2.0 * half
    whole = 2.0 * TAIL + 2.0 * braid + around

    def strand(s, side):
        angle = 3.0 * math.pi * s / braid
        return s - 0.5 * braid, side * gap * math.sin(angle), side * gap * math.cos(angle)

    def loop(s):
        low = -gap - LOOP
        if s < half:
            return 0.5 * braid + LOOP * math.sin(s / LOOP), 0.0, low + LOOP * math.cos(s / LOOP)
        if s < half + braid:
            return 0.5 * braid - (s - half), 0.0, low - LOOP
        angle = (s - half - braid) / LOOP
        return -0.5 * braid - LOOP * math.sin(angle), 0.0, low - LOOP * math.cos(angle)

    def point(s):
        s -= TAIL
        if s < 0.0:
            return s - 0.5 * braid, 0.0, gap
        if s < braid:
            return strand(s, 1.0)
        if s < braid + around:
            return loop(s - braid)
        s -= braid + around
        return strand(s, -1.0) if s < braid else (s - 0.5 * braid, 0.0, gap)

    places, s = [], 0.0
    while s < whole:
        places.append(point(s))
        s += FINE if min(s, whole - s) > TAIL - 2e-3 else COARSE
    return [*places, point(s)]


def pull(friction, steps, rows=24):
    """Shortening and R, m, and force, N: means over equal parts of the pull."""
    points = loose_knot()
    rest = [math.dist(a, b) for a, b in zip(points, points[1:])]
    with vb.Context() as context:
        scene = vb.Scene(context, mode="offline", thread_friction=friction, contact_stiffness=5e3,
                         solver={"contact_margin": 30e-6}, node_capacity=len(points))
        thread = vb.Thread(context, positions=points, rest_lengths=rest, radius=RADIUS, bending_stiffness=BENDING,
                           axial_stiffness=100.0, gravity=(0, 0, 0), drag=10.0)
        scene.add(thread)
        ends = [(thread.attach("pin", node), points[node], side) for node, side in ((0, -1.0), (len(points) - 1, 1.0))]
        speed = SPEED  # m/s, of each end
        found, forces, curvatures = [], [], []
        for step in range(steps):
            moved = speed * 1e-3 * max(0, step - 300)  # after it has come to rest
            for pin, (x, y, z), side in ends:
                thread.set_attachment_target(pin, (x + side * moved, y, z))
            scene.step(1e-3)
            forces.append(0.5 * sum(math.hypot(*thread.reaction(pin).force) for pin, _, _ in ends))
            curvatures.append(max(math.hypot(*row) for row in thread.curvatures.tolist()) if step > 900 else 0.0)
            if step > 1000 and (step + 1) % ((steps - 1000) // rows) == 0:
                apart = points[-1][0] - points[0][0] + 2.0 * moved
                count = (steps - 1000) // rows
                middle = speed * 1e-3 * count  # of the part: the ends were less apart
                found.append((sum(rest) - apart + middle, count / sum(curvatures[-count:]), sum(forces[-count:]) / count))
        return found, vb.classify(thread.positions).notation


def audoly(radius, friction):
    return BENDING / (2.0 * radius**2) + friction * 0.492 * BENDING / math.sqrt(RADIUS * radius**3)


def elliptic(m):
    """Complete integrals K and E of parameter m, by the arithmetic-geometric mean."""
    a, b, total, power = 1.0, math.sqrt(1.0 - m), 0.5 * m, 1.0
    for _ in range(12):
        a, c, b = 0.5 * (a + b), 0.5 * (a - b), math.sqrt(a * b)
        total += power * c * c
        power *= 2.0
    return 0.5 * math.pi / a, 0.5 * math.pi / a * (1.0 - total)


def jawed(friction):
    """Points (e, F) of the curve."""
    curve = []
    for i in range(1, 200):
        m = (i / 200.0)**2 * 0.9
        first, second = elliptic(m)
        x, scale = 8.0 * (first - second) / m - 4.0 * first, math.sqrt(3.0) * math.pi**2
        if x > 0.0:
            curve.append((RADIUS * (x + 4.0 * first) * 8.0 * scale / x**2,
                          friction * BENDING / RADIUS**2 * x**3 / (96.0 * scale)))
    return curve


def draw(found, friction):
    from matplotlib.figure import Figure
    figure = Figure(figsize=(9.6, 4.2), layout="constrained")
    left, right = figure.subplots(1, 2, sharey=True)
    shortenings, radii, forces = zip(*found)
    left.plot([1e3 * r for r in radii], [1e3 * audoly(r, friction) for r in radii], "k-", label="Audoly et al. 2007")
    left.set_xlabel("least radius of curvature R, mm")
    left.set_ylabel("force, mN")
    near = [(e, f) for e, f in jawed(friction) if min(shortenings) <= e <= max(shortenings)]
    right.plot([1e3 * e for e, _ in near], [1e3 * f for _, f in near], "k--",
               label="Jawed et al. 2015: of many turns, without the loop's pull")
    right.set_xlabel("shortening e, mm")
    for axes, places in ((left, radii), (right, shortenings)):
        axes.plot([1e3 * place for place in places], [1e3 * force for force in forces], "o", label="simulated")
        axes.set(xscale="log", yscale="log")
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_formatter("{x:g}")
            axis.set_minor_formatter("{x:g}")
        axes.legend(loc="lower left", fontsize=8)
        axes.grid(alpha=0.3, which="both")
    figure.suptitle(f"overhand knot pulled tight, friction {friction:g}, radius {1e6 * RADIUS:g} um")
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--friction", type=float, default=0.1)
    parser.add_argument("--steps", type=int, default=9000)
    parser.add_argument("--plot")
    chosen = parser.parse_args()
    found, notation = pull(chosen.friction, chosen.steps)
    print("shortening, mm    R, mm   force, mN   Audoly et al., mN   ratio")
    for e, radius, force in found:
        wanted = audoly(radius, chosen.friction)
        print(f"{1e3 * e:14.2f} {1e3 * radius:8.2f} {1e3 * force:11.4f} {1e3 * wanted:19.4f} {force / wanted:7.3f}")
    print(f"knot in the end: {notation}")
    if chosen.plot:
        draw(found, chosen.friction).savefig(chosen.plot, dpi=110)
        print(f"drawn: {chosen.plot}")


if __name__ == "__main__":
    main()
