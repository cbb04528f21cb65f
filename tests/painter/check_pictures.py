"""Files of the painter, read by others: PNG by zlib, SVG by an XML parser.
check_pictures.py <painter_pictures>"""
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import xml.etree.ElementTree
import zlib

BLUE, VERMILION, PINK = (0x00, 0x72, 0xb2), (0xd5, 0x5e, 0x00), (0xcc, 0x79, 0xa7)
GREEN, BACKGROUND = (0x00, 0x9e, 0x73), (0xf6, 0xf7, 0xf9)
SVG = "{http://www.w3.org/2000/svg}"


# ---- PNG

def chunks(data):
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "no PNG"
    at = 8
    while at < len(data):
        size, = struct.unpack(">I", data[at:at + 4])
        body, (crc,) = data[at + 4:at + 8 + size], struct.unpack(">I", data[at + 8 + size:at + 12 + size])
        assert zlib.crc32(body) == crc, "a chunk's checksum is wrong"
        yield body[:4], body[4:]
        at += 12 + size


def nearest(left, up, corner):
    guess = left + up - corner
    to_left, to_up, to_corner = abs(guess - left), abs(guess - up), abs(guess - corner)
    return left if to_left <= to_up and to_left <= to_corner else up if to_up <= to_corner else corner


def unfiltered(kind, row, above):
    if kind == 0:
        return row
    if kind == 2:
        return bytes(map(lambda a, b: a + b & 255, row, above))
    row = bytearray(row)
    for i, value in enumerate(row):
        left, corner = (row[i - 3], above[i - 3]) if i >= 3 else (0, 0)
        row[i] = value + (left if kind == 1 else (left + above[i]) // 2 if kind == 3 else
                          nearest(left, above[i], corner)) & 255
    return bytes(row)


class Png:
    def __init__(self, path, decode=True):
        self.size = path.stat().st_size
        parts = list(chunks(path.read_bytes()))
        assert [name for name, _ in parts] == [b"IHDR", b"IDAT", b"IEND"], "other chunks"
        head = struct.unpack(">IIBBBBB", parts[0][1])
        assert head[2:] == (8, 2, 0, 0, 0), "another kind of PNG"
        self.width, self.height = head[:2]
        size = 3 * self.width + 1
        unpacker = zlib.decompressobj()
        raw = unpacker.decompress(parts[1][1])
        assert unpacker.eof and not unpacker.unused_data, "the stream does not end where it should"
        assert len(raw) == size * self.height, "too few or too many bytes"
        rows, above = [], bytes(size - 1)
        for at in range(0, len(raw) if decode else 0, size):
            above = unfiltered(raw[at], raw[at + 1:at + size], above)
            rows.append(above)
        self.pixels = b"".join(rows)

    def at(self, x, y):
        first = 3 * (y * self.width + x)
        return tuple(self.pixels[first:first + 3])


def hue(colour):
    light = [(code / 255) ** 2 for code in colour]  # lit, it is a multiple of this, and some grey
    return [value - min(light) for value in light]


def matches(pixel, colour):
    a, b = hue(pixel), hue(colour)
    return sum(x * y for x, y in zip(a, b)) > 0.98 * (sum(x * x for x in a) * sum(x * x for x in b)) ** 0.5 > 0.01


def pattern(width, height, number):
    out, random = bytearray(), 1
    for i in range(3 * width * height):
        random = (random * 1664525 + 1013904223) & 0xffffffff
        noise = random >> 24
        out.append((noise, 7, noise if i % 40000 < 20000 else i % 251,
                    noise if i < 36000 else out[i - 36000])[number])
    return bytes(out)


def check_encoder(folder):
    for name, width, height, number in (("noise", 97, 61, 0), ("flat", 350, 250, 1), ("mixed", 301, 200, 2),
                                        ("repeat", 100, 360, 3), ("one", 1, 1, 0)):
        png = Png(folder / f"{name}.png")
        assert (png.width, png.height) == (width, height), f"{name}: another size"
        assert png.pixels == pattern(width, height, number), f"{name}: other pixels"
    assert (folder / "flat.png").stat().st_size < 3000, "what is flat does not pack"


def check_png(folder):
    png = Png(folder / "crossing.png")
    assert (png.width, png.height) == (800, 600)
    assert png.pixels == (folder / "crossing.raw").read_bytes(), "the file is not what was painted"
    assert matches(png.at(400, 300), VERMILION), "the far bar hides the near one"
    assert matches(png.at(240, 300), VERMILION)
    assert matches(png.at(400, 180), BLUE) and matches(png.at(400, 420), BLUE)
    assert png.at(240, 180) == BACKGROUND and png.at(790, 590) == BACKGROUND
    two = Png(folder / "crossing-two.png")
    assert (two.width, two.height) == (1600, 600)
    rows = range(40, 600)  # captions above
    assert all(two.pixels[4800 * y:4800 * y + 2390] == png.pixels[2400 * y:2400 * y + 2390] for y in rows), \
        "the left view is not the front"
    # From above: the upright bar's green end, the other one 3 mm nearer to the lower edge.
    assert matches(two.at(1200, 300), GREEN) and matches(two.at(1200, 420), VERMILION)
    assert two.at(1200, 180) == BACKGROUND
    table = Png(folder / "table.png")
    colours = {table.at(x, y) for x in range(0, 800, 3) for y in range(250, 600, 3)}
    assert not any(matches(colour, PINK) for colour in colours), "what is under the floor shows"
    for name in ("crossing", "trefoil", "table"):
        size = Png(folder / f"{name}.png", decode=False).size
        assert size < 200_000, f"{name}.png has {size} bytes"


# ---- SVG

def check_numbers(element):
    for name, value in element.attrib.items():
        if name in ("d", "points", "viewBox"):
            assert re.fullmatch(r"M?(-?\d+(\.\d{1,2})? ?)+", value), f"{name}={value[:80]}"
        elif name in ("x", "y", "cx", "cy", "r", "x1", "x2", "y1", "y2", "stroke-width") or \
                (name in ("width", "height") and value != "100%"):
            assert re.fullmatch(r"-?\d+(\.\d{1,2})?", value), f"{name}={value}"
        elif name in ("fill", "stroke"):
            assert re.fullmatch(r"#[0-9a-f]{6}|none", value), f"{name}={value}"


def parsed(path):
    root = xml.etree.ElementTree.parse(path).getroot()
    assert root.tag == SVG + "svg" and root.get("viewBox") == "0 0 800 600"
    elements = list(root.iter())
    for element in elements:
        check_numbers(element)
    return elements


def check_svg(folder):
    elements = parsed(folder / "crossing.svg")
    strokes = [e.get("stroke") for e in elements if e.tag == SVG + "path"]
    far = [i for i, colour in enumerate(strokes) if colour == "#0072b2"]
    near = [i for i, colour in enumerate(strokes) if colour == "#d55e00"]
    assert far and near and max(far) < min(near), "nearer strokes do not come later"
    texts = [e.text for e in elements if e.tag == SVG + "text"]
    assert texts == ['a<b & "c" > \u00b5 \ufffd\ufffd \u20ac'], texts
    trefoil = parsed(folder / "trefoil.svg")
    assert [e.text for e in trefoil if e.tag == SVG + "text"] == ["2 mm", "0 N", "2 N", "contact"]
    table = parsed(folder / "table.svg")
    floors = [i for i, e in enumerate(table) if e.tag == SVG + "polygon"]
    assert len(floors) == 2, "a floor and a triangle"
    under = [i for i, e in enumerate(table) if e.get("stroke") == "#cc79a7"]
    over = [i for i, e in enumerate(table) if e.get("stroke") == "#a9b4bf"]
    assert under and over and max(under) < floors[0] < floors[1] < max(over), "the floor is not between"


# ---- all

def main():
    with tempfile.TemporaryDirectory() as one, tempfile.TemporaryDirectory() as other:
        folders = [pathlib.Path(one), pathlib.Path(other)]
        for folder in folders:
            subprocess.run([sys.argv[1], str(folder)], check=True)
        names = [sorted(path.name for path in folder.iterdir()) for folder in folders]
        assert names[0] == names[1] and len(names[0]) == 14, names
        for name in names[0]:
            assert (folders[0] / name).read_bytes() == (folders[1] / name).read_bytes(), f"{name} differs"
        check_encoder(folders[0])
        check_png(folders[0])
        check_svg(folders[0])
    print(f"{len(names[0])} files are as they should be")


if __name__ == "__main__":
    main()
