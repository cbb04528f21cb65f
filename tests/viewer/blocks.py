"""Pictures compared block by block: what rasterisers round and blend otherwise stays within a block's mean."""
import zlib

BLOCK = 20
# Of 255, the mean over a block. Other moments are farther off.
TOLERANCE = 6.0


def read_png(path):
    """Rows of pixels, three bytes each; 8 bits a colour, opaque or not, any of the five filters."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", path
    width, height = (int.from_bytes(data[at:at + 4], "big") for at in (16, 20))
    bits, kind = data[24:26]
    assert bits == 8 and kind in (2, 6), path
    size = 3 if kind == 2 else 4
    at, packed = 8, b""
    while at < len(data):
        count = int.from_bytes(data[at:at + 4], "big")
        if data[at + 4:at + 8] == b"IDAT":
            packed += data[at + 8:at + 8 + count]
        at += 12 + count
    raw, stride = zlib.decompress(packed), size * width
    assert len(raw) == height * (stride + 1), path
    rows, above = [], bytearray(stride)
    for y in range(height):
        kind, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left, up, corner = (row[i - size], above[i], above[i - size]) if i >= size else (0, above[i], 0)
            guess = left + up - corner
            paeth = min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))[2]
            row[i] = (row[i] + (0, left, up, (left + up) // 2, paeth)[kind]) & 255
        rows.append(row if size == 3 else bytearray(v for i, v in enumerate(row) if i % 4 < 3))
        above = row
    return rows


def blocks(rows):
    """Mean of each colour in each block."""
    means = []
    for y in range(0, len(rows), BLOCK):
        for x in range(0, len(rows[0]) // 3, BLOCK):
            for colour in range(3):
                values = [v for row in rows[y:y + BLOCK] for v in row[3 * x + colour:3 * (x + BLOCK):3]]
                means.append(sum(values) / len(values))
    return means


def apart(a, b):
    return max(abs(p - q) for p, q in zip(a, b))


def write(reference, found):
    reference.write_text("".join(" ".join(f"{v:.0f}" for v in still) + "\n" for still in found))


def compare(reference, found):
    """Complaints about pictures that are not as they were, or could be taken for one another."""
    wanted = [[float(v) for v in line.split()] for line in reference.read_text().splitlines()]
    if [len(s) for s in found] != [len(s) for s in wanted]:
        return [f"{len(found)} pictures of {[len(s) for s in found]} numbers, not {[len(s) for s in wanted]}"]
    complaints = []
    for i, (still, want) in enumerate(zip(found, wanted)):
        print(f"still {i}: {apart(still, want):.2f} off at most")
        if apart(still, want) > TOLERANCE:
            complaints.append(f"still {i} is not as it was")
        if apart(still, wanted[(i + 1) % len(wanted)]) < 4.0 * TOLERANCE:
            complaints.append(f"still {i} would pass for another")
    return complaints
