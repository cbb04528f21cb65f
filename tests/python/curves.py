"""Polylines with known knots."""
import math


def trefoil(nodes=120, size=0.01, mirrored=False):
    """A trefoil, opened where it is farthest out; both ends go on outward. Closed outside it is 3_1."""
    gap, begin = 0.06, math.pi / 3.0
    points = []
    for i in range(nodes + 1):
        t = begin + gap + (2.0 * math.pi - 2.0 * gap) * i / nodes
        z = math.sin(3.0 * t)
        points.append([math.sin(t) + 2.0 * math.sin(2.0 * t), math.cos(t) - 2.0 * math.cos(2.0 * t),
                       z if mirrored else -z])
    first, last = points[0], points[-1]
    points = [[3.0 * first[0], 3.0 * first[1], first[2]], *points, [3.0 * last[0], 3.0 * last[1], last[2]]]
    return [[size * c for c in point] for point in points]


def helix(nodes=60):
    """No knot."""
    return [[0.01 * math.cos(0.3 * i), 0.01 * math.sin(0.3 * i), 0.001 * i] for i in range(nodes)]


def turned(points, axis, angle):
    """Rotated about an axis through the origin (Rodrigues)."""
    length = math.sqrt(sum(a * a for a in axis))
    k = [a / length for a in axis]
    c, s = math.cos(angle), math.sin(angle)
    out = []
    for p in points:
        cross = [k[1] * p[2] - k[2] * p[1], k[2] * p[0] - k[0] * p[2], k[0] * p[1] - k[1] * p[0]]
        dot = sum(a * b for a, b in zip(k, p))
        out.append([c * p[i] + s * cross[i] + (1.0 - c) * dot * k[i] for i in range(3)])
    return out
