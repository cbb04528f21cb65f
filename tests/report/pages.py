"""Runs vbss-report and looks at its page as a tree."""
import re
import subprocess
import sys
import xml.etree.ElementTree

CELL = {"td", "th"}
REPLAY = "replay.html#t="  # a moment of the page beside it that plays the session


def fail(text):
    sys.exit(text)


def report(tool, log, page, wanted, *options):
    """What it says, when it ends with that code."""
    done = subprocess.run([tool, log, "-o", page, *options], capture_output=True, text=True)
    if done.returncode != wanted:
        fail(f"{log}: exit {done.returncode}, not {wanted}: {done.stderr}")
    return done.stderr


class Page:
    def __init__(self, path):
        self.source = path.read_bytes().decode("utf-8")
        if not self.source.startswith("<!DOCTYPE html>"):
            fail("no document type")
        self.root = xml.etree.ElementTree.fromstring(self.source)
        self.check_self_contained()
        self.check_accessible()

    def elements(self, name):
        return [e for e in self.root.iter() if e.tag.rpartition("}")[2] == name]

    def check_self_contained(self):
        for element in self.root.iter():
            for name, value in element.attrib.items():
                assert not name.lower().startswith("on"), (element.tag, name)
                if name in ("href", "src"):
                    assert value.startswith(("#", "data:image/png;base64,", REPLAY)), value
        for name in ("script", "iframe", "object", "embed", "link", "base", "form"):
            assert not self.elements(name), name
        styles = "".join(e.text for e in self.elements("style"))
        assert "url(" not in styles and "@import" not in styles

    def check_accessible(self):
        assert self.root.get("lang") == "en" and len(self.elements("h1")) == 1
        for table in self.elements("table"):
            assert table.find("caption") is not None and table.find("caption").text
        for header in self.elements("th"):
            assert header.get("scope"), "".join(header.itertext())
        for drawing in self.elements("svg"):
            if drawing.get("aria-hidden") != "true":
                kinds = [e.tag.rpartition("}")[2] for e in drawing]
                assert drawing.get("role") == "img" and kinds[:2] == ["title", "desc"], kinds
        for image in self.elements("img"):
            assert image.get("alt")
        names = [e.get("id") for e in self.root.iter() if e.get("id")]
        assert len(names) == len(set(names))
        for link in self.elements("a"):
            assert link.get("href")[1:] in names or link.get("href").startswith(REPLAY)
        for section in self.elements("section"):
            assert section.get("aria-labelledby") in names

    def text(self):
        """All that is read, blanks as one; what styles say is not."""
        words = [t for e in self.root.find("body").iter() for t in (e.text, e.tail) if t]
        return re.sub(r"\s+", " ", " ".join(words))

    def rows(self, name):
        """The cells behind a row's header, in all tables."""
        found = []
        for row in self.elements("tr"):
            cells = ["".join(c.itertext()).strip() for c in row if c.tag in CELL]
            heads = [i for i, c in enumerate(c for c in row if c.tag in CELL) if c.tag == "th"]
            if heads and cells[heads[0]] == name:
                found.append(cells[:heads[0]] + cells[heads[0] + 1:])
        return found

    def number(self, name, column=0):
        rows = self.rows(name)
        assert len(rows) == 1, (name, rows)
        return float(rows[0][column].split()[0].replace("\u2212", "-"))

    def cards(self):
        cards = [e for e in self.elements("div") if e.get("class") == "card"]
        words = [["".join(p.itertext()).strip() for p in card] for card in cards]
        return {card[0]: card[1:] for card in words}
