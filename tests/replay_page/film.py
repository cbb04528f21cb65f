"""Reads a page's film for itself, and asks it what the physics promises: a thread keeps its length, and stays on its needle."""
import base64
import json
import math
import struct

THREAD, NEEDLE = 1, 3


def read_session(page):
    source = page.read_text()
    begin = source.index(">", source.index('<script type="application/json"')) + 1
    return json.loads(source[begin:source.index("</script>", begin)])


def whole_numbers(data):
    number, shift = 0, 0
    for byte in data:
        number |= (byte & 127) << shift
        shift += 7
        if byte < 128:
            yield number
            number, shift = 0, 0


def differences(numbers):
    """Of one frame after another; zeros come in runs."""
    zeros = 0
    while True:
        if zeros == 0:
            number = next(numbers)
            if number == 0:
                zeros = next(numbers) + 1
        if zeros > 0:
            zeros -= 1
            yield 0
        else:
            yield -(number + 1) // 2 if number % 2 else number // 2


def frames(film):
    """Of each frame what each model has there: rows of numbers."""
    numbers = whole_numbers(base64.b64decode(film["numbers"]))
    before, last = None, None
    for _ in range(film["frames"]):
        layout = next(numbers)
        steps = differences(numbers)
        shown = {}
        for model, count in film["layouts"][layout]:
            rigid = film["models"][model]["form"] == "rigid"
            row, rows = (7, 1) if rigid else (3, count)
            values = []
            for i in range(row * rows):
                guess = before[model][i] if layout == last else values[i - row] if i >= row else 0
                values.append(guess + next(steps))
            shown[model] = values
        before, last = shown, layout
        yield shown


def turned(q, v):
    w, x, y, z = (c / math.sqrt(sum(c * c for c in q)) for c in q)
    t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])]
    return [v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2],
            v[2] + w * t[2] + x * t[1] - y * t[0]]


def vertices_of(model):
    data = base64.b64decode(model["positions"])
    values = [v * model["positionsUnit"] for v in struct.unpack(f"<{len(data) // 2}h", data)]
    return [values[i:i + 3] for i in range(0, len(values), 3)]


def check(page):
    """Complaints."""
    film = read_session(page)["film"]
    of_kind = {m["kind"]: i for i, m in enumerate(film["models"])}
    thread, needle = of_kind[THREAD], of_kind[NEEDLE]
    vertices, swage = vertices_of(film["models"][needle]), None
    lengths, offs = [], []
    for shown in frames(film):
        line = [[v * film["place"] for v in shown[thread][i:i + 3]] for i in range(0, len(shown[thread]), 3)]
        lengths.append(sum(math.dist(a, b) for a, b in zip(line, line[1:])))
        pose = shown[needle]
        placed = lambda v: [p * film["place"] + t for p, t in zip(pose[:3], turned(pose[3:], v))]
        if swage is None:
            swage = min(((math.dist(placed(v), end), i, k) for i, v in enumerate(vertices)
                         for k, end in ((0, line[0]), (-1, line[-1]))))
        offs.append(math.dist(placed(vertices[swage[1]]), line[swage[2]]))
    spread = (max(lengths) - min(lengths)) / lengths[0]
    print(f"thread: {1e3 * lengths[0]:.2f} mm, differs by {100 * spread:.3f} %; on its needle to {1e6 * (max(offs) - min(offs)):.0f} um")
    complaints = [] if len(lengths) == film["frames"] > 100 else [f"{len(lengths)} frames"]
    if spread > 2e-3:
        complaints.append("the thread's length changes")
    if max(offs) - min(offs) > 3e-5:
        complaints.append("the thread leaves its needle")
    return complaints
