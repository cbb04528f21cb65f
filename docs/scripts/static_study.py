#!/usr/bin/env python3
"""Tip error of the heavy cantilever for bending energies that docs/explanation/thread.md compares: the discrete energy
is minimised directly, without the library. Needs numpy (python3-numpy); a minute.

    docs/scripts/static_study.py [SEGMENTS]
"""
import sys

import numpy as np

DENSITY, EI, EA, GRAVITY, LENGTH = 6.4e-5, 1e-8, 427.0, 9.81, 0.15
TIP = np.array([15.612192e-3, -143.708681e-3])  # boundary value problem, to 1e-11


def spline_matrix(n, h):
    """Of hat functions at the nodes 0 .. n - 1: clamped at 0, free at n."""
    a = np.diag(np.full(n, 2 * h / 3)) + np.diag(np.full(n - 1, h / 6), 1) + np.diag(np.full(n - 1, h / 6), -1)
    a[0, 0] = h / 3
    return a


def eliminated(n, h, exact, inside, close):
    """The energy's matrix in the turns: `exact` moments eliminated at the clamp; then the row sums, with
    Neumann's term if `inside`, after closing up the next moment if `close`."""
    left, rows, energy = spline_matrix(n, h), np.eye(n), np.zeros((n, n))
    for k in range(exact):
        energy += np.outer(rows[k], rows[k]) / left[k, k]
        for r in range(k + 1, n):
            rows[r] = rows[r] - left[r, k] / left[k, k] * rows[k]
        left[k + 1:, k + 1:] -= np.outer(left[k + 1:, k], left[k, k + 1:]) / left[k, k]
    link = h / 6
    low = exact
    sums = np.array([left[i, i] + (link if i > low else 0.0) + link for i in range(n)])
    if close:
        closed = rows[low] - link / sums[low + 1] * rows[low + 1]
        energy += np.outer(closed, closed) / left[low, low]
        energy += link / sums[low + 1] ** 2 * np.outer(rows[low + 1], rows[low + 1])
        low += 1
    for i in range(low, n):
        energy += np.outer(rows[i], rows[i]) / sums[i]
        if inside:
            step = rows[i] / sums[i] - (rows[i + 1] / sums[i + 1] if i + 1 < n else 0.0)
            energy += link * np.outer(step, step)
    return energy


def half_angle(n, h):
    return np.diag(np.r_[2 / h, np.full(n - 1, 1 / h)])


def linear_at_clamp(n, h, inside):
    energy = np.diag(np.full(n, 4 / 3 if inside else 1.0))
    if inside:
        energy -= (np.diag(np.ones(n - 1), 1) + np.diag(np.ones(n - 1), -1)) / 6
    energy[0, 0], energy[0, 1], energy[1, 0] = 3.0, -0.5, -0.5
    energy[1, 1] = 17 / 12 if inside else 1.25
    return energy / h


def energy_of(flat, n, h, matrix, arcs):
    x = np.vstack([np.zeros((1, 2)), flat.reshape(-1, 2)])
    e = x[1:] - x[:-1]
    t = e / h
    turns = np.vstack([t[:1] - np.array([[1.0, 0.0]]), t[1:] - t[:-1]])
    bending = 0.5 * EI * (turns * (matrix @ turns)).sum()
    lengths = np.sqrt((e * e).sum(1))
    if arcs:
        k = np.vstack([turns / h, np.zeros((1, 2))])
        k[0] = 3 * turns[0] / h - 0.5 * k[1]
        mean = 0.5 * (k[1:] + k[:-1])
        lengths = lengths + h ** 3 / 24 * (mean * mean).sum(1)
    stretching = (0.5 * EA / h * (lengths - h) ** 2).sum()
    return bending + stretching + DENSITY * GRAVITY * h * (0.5 * (x[1:, 1] + x[:-1, 1])).sum()


def slope(flat, *scene):
    g = np.empty(len(flat))
    for i in range(len(flat)):
        moved = flat.astype(complex)
        moved[i] += 1e-30j
        g[i] = energy_of(moved, *scene).imag / 1e-30
    return g


def tip_error_mm(n, matrix, arcs):
    h = LENGTH / n
    angles = -np.pi / 2 * (1 - np.exp(-(np.arange(n) + 0.5) * h / 0.0103))
    flat = np.cumsum(h * np.c_[np.cos(angles), np.sin(angles)], 0).ravel()
    scene = (n, h, matrix, arcs)
    for _ in range(80):
        g, hessian = slope(flat, *scene), np.empty((len(flat), len(flat)))
        for i in range(len(flat)):
            step = np.zeros(len(flat))
            step[i] = 1e-7
            hessian[:, i] = (slope(flat + step, *scene) - slope(flat - step, *scene)) / 2e-7
        values, vectors = np.linalg.eigh(0.5 * (hessian + hessian.T))
        move = -vectors @ ((vectors.T @ g) / np.maximum(np.abs(values), 1e-7))
        largest = np.abs(move).max()
        flat = flat + move * min(1.0, 2e-3 / largest)
        if largest < 1e-10:
            break
    return 1e3 * np.linalg.norm(flat[-2:] - TIP)


def main():
    n = int(sys.argv[1]) if len(sys.argv) > 1 else 30
    h = LENGTH / n
    cases = [
        ("half angle against the clamp, chords", half_angle(n, h), False),
        ("one eliminated, row sums, chords (LOCAL)", eliminated(n, h, 1, False, False), False),
        ("exact for linear curvature at the clamp, chords", linear_at_clamp(n, h, False), False),
        ("the same, fourth order inside, arcs", linear_at_clamp(n, h, True), True),
        ("one eliminated, fourth order inside, arcs", eliminated(n, h, 1, True, False), True),
        ("two eliminated", eliminated(n, h, 2, True, False), True),
        ("two eliminated, the third closed up (SPLINE)", eliminated(n, h, 2, True, True), True),
        ("three eliminated", eliminated(n, h, 3, True, False), True),
        ("full spline, chords", np.linalg.inv(spline_matrix(n, h)), False),
        ("full spline, arcs", np.linalg.inv(spline_matrix(n, h)), True),
    ]
    for name, matrix, arcs in cases:
        print(f"{name:50s} {tip_error_mm(n, matrix, arcs):8.4f} mm", flush=True)


if __name__ == "__main__":
    main()
