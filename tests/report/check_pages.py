#!/usr/bin/env python3
"""Pages of logs: well-formed, with the right figures, nothing of a hostile log taken for markup, cut logs up to the cut.

    check_pages.py VBSS_REPORT WRITE_SESSION
"""
import base64
import pathlib
import subprocess
import sys
import tempfile

from pages import Page, report

TOOL, WRITER = sys.argv[1:3]
HOSTILE = "</bdi></dd><script>alert(1)</script><img src=x onerror=alert(2)>\"'&\x01\x7f\xe4 ]]>"


def near(found, wanted, tolerance, what):
    assert abs(found - wanted) <= tolerance, f"{what}: {found}, not {wanted}"


def check_figures(folder):
    log, path = folder / "known.vbss", folder / "known.html"
    subprocess.run([WRITER, log, "of a test"], check=True)
    assert report(TOOL, log, path, 0) == ""
    page = Page(path)
    text, cards = page.text(), page.cards()
    assert "1500 steps, 1.50 s on the session clock, 1.50 s of it simulated" in text
    assert "Simulated time was lost." not in text
    near(page.number("implausible samples left out, left"), 0, 0, "outliers")
    # A reach of least jerk over 50 mm in 1 s: its path, and 15/8 of its mean speed at most.
    near(page.number("path, left"), 0.050, 5e-4, "path")
    near(page.number("path, right"), 0.0, 5e-4, "path")
    near(page.number("peak speed, left"), 0.09375, 1e-3, "peak speed")
    near(page.number("time"), 1.2, 0.051, "time to the second cut")
    assert cards["Time"][0].startswith("1.20 "), cards
    assert cards["Task"][0] == "In part" and "both tails were cut" in cards["Task"][1], cards
    near(float(cards["Score"][0]), 598.8, 0.051, "600 - 1.2")
    assert "provisional" in cards["Score"][1] and cards["Knot"][0] == "unknown"
    near(float(page.rows("score")[0][-1]), 598.8, 0.051, "the sum of the table")
    # What was not played back is not made up.
    for name in ("largest of all, left", "left hole off its mark", "tightness by pull test"):
        assert page.rows(name)[0][0] == "not known", name
    assert "the note of the log names no scene" in text and "a thread is cut: 2" in text
    left = [e for e in page.elements("dd") if "body 2 of the scene" in "".join(e.itertext())]
    assert len(left) == 1 and "to the left" in "".join(left[0].itertext())
    return log


def check_lost(folder):
    """Limits of work that no step can keep: the page has the loss that the steps reported."""
    log, path = folder / "lost.vbss", folder / "lost.html"
    done = subprocess.run([WRITER, log, "of a test", "lossy"], check=True, capture_output=True, text=True)
    lost = float(done.stdout)
    assert 0.1 < lost < 1.5, done.stdout
    report(TOOL, log, path, 0)
    page = Page(path)
    text, cards = page.text(), page.cards()
    assert f"1.50 s on the session clock, {1.5 - lost:.2f} s of it simulated" in text
    assert f"Of 1.50 s on the session clock {lost:.2f} s (" in text
    assert f"on the session clock, {1.5 - lost:.2f} s of it simulated" in cards["Time"][1], cards
    assert "lost time included" in text and "Simulated time was lost." in text
    near(float(page.rows("simulated time was lost, which the clock of the score includes")[0][0]), lost, 0.006,
         "the reason beside the score")
    assert f"Simulated time lost in steps cut short or paused: {1e3 * lost:.2f} ms." in text


def check_hostile(folder):
    log, path = folder / "a<b>&\"'.vbss", folder / "hostile.html"
    subprocess.run([WRITER, log, HOSTILE.encode("latin-1"), "hostile"], check=True)
    pictures = folder / "pic\"<i>tures"
    pictures.mkdir()
    png = base64.b64decode("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAQAAAC1HAwCAAAAC0lEQVR42mNk+A8AAQUBAScY42YAAAAASUVORK5CYII=")
    (pictures / "1<s>.png").write_bytes(png)
    (pictures / "2.png").write_bytes(b"<script>alert(3)</script>")
    report(TOOL, log, path, 0, "--pictures", pictures)
    page = Page(path)  # which refuses scripts, handlers and sources from elsewhere
    text = page.text()
    assert "<script>alert(1)</script>" in text and "\ufffd" in text, "shown as it is"
    assert "<img src=x onerror=alert(1)>" in text, "the build text"
    assert page.elements("title")[0].text.endswith("a<b>&\"'.vbss")
    assert all(word not in page.source for word in ("<script", "<img src=x", "alert(3)", "\x01"))
    images = page.elements("img")
    assert len(images) == 1 and images[0].get("alt") == "picture 1<s>.png"
    assert base64.b64decode(images[0].get("src").partition(",")[2]) == png
    assert "1 more were left out" in text


def check_broken(folder, whole):
    log, path = folder / "cut.vbss", folder / "cut.html"
    bytes_of = whole.read_bytes()
    log.write_bytes(bytes_of[:len(bytes_of) // 2])
    assert "VBSS_ERROR_TRUNCATED" in report(TOOL, log, path, 1)
    page = Page(path)
    steps = int(page.text().partition(" steps, ")[0].rpartition(" ")[2])
    assert 500 < steps < 1000, steps
    cards = page.cards()
    assert cards["Task"] == ["Not completed", "the log is cut off before both tails were cut"]
    assert cards["Score"][0] == "unknown" and page.rows("score")[-1][0] == "not known"
    near(float(cards["Time"][0].split()[0]), 1e-3 * steps, 0.006, "time")
    near(float(page.rows("the whole log")[0][-1]), 1e-3 * steps, 0.006, "the one phase")

    changed = bytearray(bytes_of)
    changed[len(changed) // 2] ^= 1
    log.write_bytes(changed)
    report(TOOL, log, path, 1)
    assert "The log is damaged" in Page(path).text()

    log.write_bytes(b"no log")
    path.unlink()
    assert "VBSS_ERROR_" in report(TOOL, log, path, 2)
    assert "cannot be read" in report(TOOL, folder / "missing.vbss", path, 2)
    assert "cannot be read" in report(TOOL, whole, path, 2, "--pictures", folder / "missing")
    assert not path.exists(), "no page of nothing"
    assert "cannot be written" in report(TOOL, whole, folder / "missing" / "page.html", 2)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        whole = check_figures(folder)
        check_lost(folder)
        check_hostile(folder)
        check_broken(folder, whole)


if __name__ == "__main__":
    main()
