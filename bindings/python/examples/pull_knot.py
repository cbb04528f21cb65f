"""Lays an overhand knot into a thread, pulls it tight in a scene, and asks now and then whether it is still there.

    python3 bindings/python/examples/pull_knot.py [steps]

The knot is Shastri's polynomial trefoil (Tohoku Math. J. 44, 1992): x = t^3 - 3 t, y = t^4 - 4 t^2, z = t^5 - 10 t,
with straight ends along z."""
import math
import sys

import vblast_ss as vb

SPACING = 4e-4  # m, of nodes
SPEED = 0.1  # m/s, of each end


def overhand(size=1e-3, tail=0.03):
    """Points SPACING apart."""
    fine = [(size * (t**3 - 3.0 * t), size * (t**4 - 4.0 * t**2), 0.2 * size * (t**5 - 10.0 * t))
            for t in (-2.2 + 4.4 * i / 20000 for i in range(20001))]
    first, last = fine[0], fine[-1]
    fine = [(first[0], first[1], first[2] - tail)] + fine + [(last[0], last[1], last[2] + tail)]
    points, left = [list(fine[0])], SPACING
    for a, b in zip(fine, fine[1:]):
        length, at = math.dist(a, b), left
        while at <= length:
            points.append([p + (q - p) * at / length for p, q in zip(a, b)])
            at += SPACING
        left = at - length
    return points


def main():
    steps = int(sys.argv[1]) if len(sys.argv) > 1 else 120
    points = overhand()
    rest = [math.dist(a, b) for a, b in zip(points, points[1:])]
    with vb.Context() as context:
        scene = vb.Scene(context, mode="offline", solver={"contact_margin": 1e-4})
        thread = vb.Thread(context, positions=points, rest_lengths=rest, gravity=(0, 0, 0), drag=20.0)
        scene.add(thread)
        detector = vb.KnotDetector(context)
        ends = [thread.attach("pin", node) for node in (0, len(points) - 1)]
        for step in range(1, steps + 1):
            for end, place, side in zip(ends, (points[0], points[-1]), (-1.0, 1.0)):
                thread.set_attachment_target(end, (place[0], place[1], place[2] + side * SPEED * 1e-3 * step))
            scene.step(1e-3)
            if step % 20 == 0:
                knot = detector.judge(thread.positions)
                print(f"{step:4d} ms: {knot.notation or '-'} ({knot.verdict.name.lower()}), {len(scene.contacts)} contacts, "
                      f"pulled with {math.hypot(*thread.reaction(ends[0]).force):.3f} N")
        print(thread, scene)


if __name__ == "__main__":
    main()
