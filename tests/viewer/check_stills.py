"""Stills of a session, block by block, against those that were looked at when stills.txt was written:

    check_stills.py <viewer> <log> <folder>

With VBSS_UPDATE_STILLS=1 stills.txt is written instead: look at the stills before it is committed."""
import os
import pathlib
import subprocess
import sys
import zlib

HERE = pathlib.Path(__file__).resolve().parent
WIDTH, HEIGHT, BLOCK = 320, 240, 20
# Of 255, the mean over a block: what other rasterisers may round and blend otherwise. Other moments are farther off.
TOLERANCE = 6.0


def read_png(path):
    """Rows of pixels; three bytes each, any of the five filters."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", path
    at, packed = 8, b""
    while at < len(data):
        size = int.from_bytes(data[at:at + 4], "big")
        if data[at + 4:at + 8] == b"IDAT":
            packed += data[at + 8:at + 8 + size]
        at += 12 + size
    raw, stride = zlib.decompress(packed), 3 * WIDTH
    assert len(raw) == HEIGHT * (stride + 1), path
    rows, above = [], bytearray(stride)
    for y in range(HEIGHT):
        kind, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left, up, corner = (row[i - 3], above[i], above[i - 3]) if i >= 3 else (0, above[i], 0)
            guess = left + up - corner
            paeth = min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))[2]
            row[i] = (row[i] + (0, left, up, (left + up) // 2, paeth)[kind]) & 255
        rows.append(row)
        above = row
    return rows


def blocks(rows):
    """Mean of each colour in each block."""
    means = []
    for y in range(0, HEIGHT, BLOCK):
        for x in range(0, WIDTH, BLOCK):
            for colour in range(3):
                values = [v for row in rows[y:y + BLOCK] for v in row[3 * x + colour:3 * (x + BLOCK):3]]
                means.append(sum(values) / len(values))
    return means


def apart(a, b):
    return max(abs(p - q) for p, q in zip(a, b))


def main():
    viewer, log, folder = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("frame-*.png"):
        old.unlink()
    environment = dict(os.environ, LIBGL_ALWAYS_SOFTWARE="1", GALLIUM_DRIVER="llvmpipe")
    run = subprocess.run([viewer, "--replay", log, "--seed", "1", "--png", str(folder), "--every", "1.2", "--size",
                          f"{WIDTH}x{HEIGHT}"], env=environment)
    if run.returncode != 0:
        return run.returncode
    found = [blocks(read_png(path)) for path in sorted(folder.glob("frame-*.png"))]
    reference = HERE / "stills.txt"
    if os.environ.get("VBSS_UPDATE_STILLS"):
        reference.write_text("".join(" ".join(f"{v:.0f}" for v in still) + "\n" for still in found))
    wanted = [[float(v) for v in line.split()] for line in reference.read_text().splitlines()]
    complaints = [] if len(found) == len(wanted) else [f"{len(found)} stills, {len(wanted)} were wanted"]
    for i, (still, want) in enumerate(zip(found, wanted)):
        print(f"still {i}: {apart(still, want):.2f} off at most")
        if apart(still, want) > TOLERANCE:
            complaints.append(f"still {i} is not as it was")
        if apart(still, wanted[(i + 1) % len(wanted)]) < 4.0 * TOLERANCE:
            complaints.append(f"still {i} would pass for another")
        if still[0] > 3.0 or still[-1] > 3.0:
            complaints.append(f"still {i} is bright outside of the round field")
    print("\n".join(complaints))
    return 1 if complaints else 0


sys.exit(main())
