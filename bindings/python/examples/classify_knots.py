"""Says which knot is in each polyline of a CSV file.

    python3 bindings/python/examples/classify_knots.py [file.csv]

A row is a point: the name of the line, x, y, z in m; the points of a line stand one below the other. Without a file,
three lines are made here, written to knots.csv in a temporary folder, and read again."""
import csv
import math
import pathlib
import sys
import tempfile

import vblast_ss as vb


def throw(sign, nodes=160, size=0.01):
    """An overhand knot: two strands that turn about each other, closed by a loop; the trefoil of the torus, opened
    where it is farthest out."""
    points = []
    for i in range(nodes + 1):
        t = math.pi / 3.0 + 0.06 + (2.0 * math.pi - 0.12) * i / nodes
        points.append((math.sin(t) + 2.0 * math.sin(2.0 * t), math.cos(t) - 2.0 * math.cos(2.0 * t),
                       sign * math.sin(3.0 * t)))
    ends = [tuple(3.0 * c for c in point[:2]) + (point[2],) for point in (points[0], points[-1])]
    return [[size * c for c in point] for point in (ends[0], *points, ends[1])]


def straight(nodes=20):
    return [[0.005 * i, 1e-3 * math.sin(i), 0.0] for i in range(nodes)]


def write(path, lines):
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["line", "x", "y", "z"])
        for name, points in lines.items():
            writer.writerows([name, *map(repr, point)] for point in points)


def read(path):
    lines = {}
    with path.open(newline="") as file:
        for row in csv.DictReader(file):
            lines.setdefault(row["line"], []).append([float(row[axis]) for axis in "xyz"])
    return lines


def main():
    with tempfile.TemporaryDirectory() as folder:
        if len(sys.argv) > 1:
            path = pathlib.Path(sys.argv[1])
        else:
            path = pathlib.Path(folder) / "knots.csv"
            write(path, {"right overhand": throw(1), "left overhand": throw(-1), "no knot": straight()})
        for name, points in read(path).items():
            knot = vb.classify(points)
            hands = ", ".join("right" if one.handedness > 0 else "left" for one in knot.throws)
            print(f"{name}: {knot.notation or '-'} ({knot.name.name.lower()}, {knot.verdict.name.lower()}"
                  f"{', ' + hands if hands else ''})")


if __name__ == "__main__":
    main()
