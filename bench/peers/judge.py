"""What became of a knot: which one it is, and how near its strands come. Uses none of the libraries that are compared."""
import math

import numpy as np


def determinant(points):
    """|Alexander polynomial at -1| of an open curve whose ends go on straight: 1 unknotted, 3 trefoil."""
    far = 10.0 * np.ptp(points, axis=0).max()
    ends = [points[0] + far * unit(points[0] - points[1]), points[-1] + far * unit(points[-1] - points[-2])]
    line = np.concatenate((ends[:1], points, ends[1:])) @ turned()
    crossings = sorted(found_crossings(line))  # (place, crossing, over)
    count = len(crossings) // 2
    if count == 0:
        return 1
    # Arcs run from one undercrossing to the next; 2 over = before + after at each.
    matrix = np.zeros((count, count + 1))
    arc = 0
    for _, crossing, over in crossings:
        if over:
            matrix[crossing, arc] += 2.0
        else:
            matrix[crossing, arc] -= 1.0
            arc += 1
            matrix[crossing, arc] -= 1.0
    return round(abs(np.linalg.det(matrix[:, 1:])))


def unit(v):
    return v / np.linalg.norm(v)


def turned():
    """A view that no symmetry of the knot prefers."""
    basis, _ = np.linalg.qr(np.array([[0.31, 0.87, 0.38], [0.71, -0.18, 0.53], [0.44, 0.29, -0.76]]))
    return basis


def found_crossings(line):
    """Both passages of every crossing of the projection along the third axis."""
    a, d = line[:-1], np.diff(line, axis=0)
    number = 0
    for i in range(len(a) - 2):
        b, e = a[i + 2:], d[i + 2:]
        r = b - a[i]
        area = d[i, 0] * e[:, 1] - d[i, 1] * e[:, 0]
        with np.errstate(divide="ignore", invalid="ignore"):
            s = (r[:, 0] * e[:, 1] - r[:, 1] * e[:, 0]) / area
            t = (r[:, 0] * d[i, 1] - r[:, 1] * d[i, 0]) / area
        for k in np.flatnonzero((s >= 0) & (s < 1) & (t >= 0) & (t < 1)):
            j = i + 2 + int(k)
            above = a[i, 2] + s[k] * d[i, 2] > a[j, 2] + t[k] * d[j, 2]
            yield i + s[k], number, bool(above)
            yield j + t[k], number, not above
            number += 1


def min_distance(points, apart):
    """Between segments of the polygon that are at least `apart` from each other along it."""
    a, d = points[:-1], np.diff(points, axis=0)
    at = np.concatenate(([0.0], np.cumsum(np.linalg.norm(d, axis=1))))
    smallest = math.inf
    for i in range(len(a)):
        later = at[:-1] - at[i + 1] >= apart
        if later.any():
            smallest = min(smallest, segments_distance(a[i], d[i], a[later], d[later]).min())
    return smallest


def segments_distance(a, d, b, e):
    """Of the segment a, a + d from each of b, b + e."""
    r = b - a
    dd, ee, de = d @ d, np.einsum("ij,ij->i", e, e), e @ d
    dr, er = r @ d, np.einsum("ij,ij->i", e, r)
    area = np.maximum(dd * ee - de**2, 1e-30 * dd * ee)
    s = np.clip((dr * ee - er * de) / area, 0.0, 1.0)
    t = np.clip((s * de - er) / ee, 0.0, 1.0)
    s = np.clip((dr + t * de) / dd, 0.0, 1.0)
    return np.linalg.norm(r + t[:, None] * e - s[:, None] * d, axis=1)
