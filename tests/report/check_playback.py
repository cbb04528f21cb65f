#!/usr/bin/env python3
"""Pages of logs of the demonstrations say what these said of themselves.

    check_playback.py VBSS_REPORT THROW begin              the begin of a throw, cut off and whole
    check_playback.py VBSS_REPORT THROW whole PASS_NEEDLE  a throw and a stitch
    check_playback.py VBSS_REPORT SURGEON session          a stitch with its session
    check_playback.py VBSS_REPORT LOG pad                  a log of examples/pad
"""
import pathlib
import re
import subprocess
import sys
import tempfile

from pages import Page, report

TOOL, THROW, PART = sys.argv[1:4]


def run(*command):
    return subprocess.run(command, capture_output=True, text=True).stdout


def check_begin(folder):
    """Half a second of a throw, which ends as not tied."""
    log, path = folder / "begin.vbss", folder / "begin.html"
    run(THROW, "single", "-s", "0", "-t", "0.5", "-l", log)
    report(TOOL, log, path, 0)
    page = Page(path)
    steps = int(page.text().partition(" steps, ")[0].rpartition(" ")[2])
    assert steps >= 500 and f"Played back to the same bits through step {steps}" in page.text()
    assert float(page.rows("largest of all, right")[0][0]) > 0.0
    assert page.cards()["Knot"][0] == "none" and page.cards()["Task"][0] == "Not completed"
    log.write_bytes(log.read_bytes()[:-150])
    report(TOOL, log, path, 1)
    cut = Page(path).text()
    assert "Played back to the same bits through step" in cut and ", where the log ends;" in cut
    report(TOOL, log, path, 1, "--log-only")
    assert "Not played back: it was asked not to" in Page(path).text()
    # A note that was changed is found out.
    note = b"vbss throw single seed 0"
    log.write_bytes(log.read_bytes().replace(note, note[:-1] + b"7", 1))
    report(TOOL, log, path, 2)


def check_throw(folder):
    log, path = folder / "single.vbss", folder / "single.html"
    said = run(THROW, "single", "-s", "1", "-l", log)
    found = re.search(r"good '(.*?)' hand ([+-]1)", said)
    assert found and "the same hashes" in said, said
    report(TOOL, log, path, 0)
    page = Page(path)
    assert page.cards()["Knot"] == [found[1], "at the end, certified"], page.cards()
    rows = [row for row in page.rows("single") if len(row) == 5]  # a throw, in the order it is tied
    number, hand, order, sure, _ = rows[-1]
    assert hand == ("left-handed" if found[2] == "-1" else "right-handed"), (hand, said)
    assert (number, order, sure) == ("1", "the first", "certified"), rows
    assert 1.9 < float(page.rows("largest while tying, left")[0][0]) < 6.1, "pulls to 2 N"


def check_stitch(folder, program):
    log, path = folder / "pass.vbss", folder / "pass.html"
    said = run(program, "-s", "1", "-l", log)
    report(TOOL, log, path, 0)
    page = Page(path)
    for side in ("right", "left"):
        off = re.search(side + r": ([0-9.]+) mm off", said)[1]
        assert page.rows(f"{side} hole off its mark")[0][0] == off, (side, off)
    assert len([e for e in page.elements("circle") if e.get("class") == "hole"]) == 2
    assert any("Gap of the slit over time" in "".join(e.itertext()) for e in page.elements("svg"))
    assert [row[0] for row in page.rows("taking the needle")] == ["1"]


def check_session(folder):
    """The needle is passed: phases, holes and events are those that the session told."""
    log, path = folder / "surgeon.vbss", folder / "surgeon.html"
    said = run(THROW, "-s", "1", "-u", "pass", "--coach", "-l", log)
    phase = re.search(r"session: phase '(.*?)'", said)[1]
    assert "played back: the same hashes" in said and phase == "drawing through", said
    report(TOOL, log, path, 0)
    page = Page(path)
    assert page.cards()["Task"][1].endswith("the phase then: " + phase), page.cards()
    assert "its session was followed, and came to the same" in page.text()
    begins = [float(time) for time in re.findall(r"([0-9.]+) s  step +[0-9]+  phase: ", said)]
    names = re.findall(r"phase: (.*)", said)
    for name, begin in zip(names, begins):
        row = [r for r in page.rows(name) if len(r) == 4][0]  # of the table of phases
        assert abs(float(row[1]) - begin) < 0.006, (name, row, begin)
    for hole in ("in", "out"):
        off = re.search(f"hole {hole}, ([0-9.]+) mm off", said)[1]
        assert page.rows(f"hole {hole} off its mark")[0][0] == off, (hole, off)
    # The debrief names at most three things, the largest first, with a link to the moment.
    report(TOOL, log, path, 0, "--replay-page", "replay.html")
    debrief = [e for e in Page(path).elements("section") if e.get("aria-labelledby") == "debrief"][0]
    named = ["".join(e.itertext()) for e in debrief.iter() if e.tag.rpartition("}")[2] == "li"]
    points = [float(re.search("([0-9]+) points", words)[1]) for words in named]
    links = [e.get("href") for e in debrief.iter() if e.tag.rpartition("}")[2] == "a"]
    assert 1 <= len(named) <= 3 and points == sorted(points, reverse=True) and points[-1] >= 1.0, named
    assert "finished before both tails were cut" in named[0], named
    assert len(links) == len(named) and all(0.0 <= float(at.removeprefix("replay.html#t=")) for at in links), links
    event_count = int(re.search(r"([0-9]+) events", said)[1])
    assert f"All that the session told ({event_count})" in page.text()
    # Without playing back, and of another surgeon's hands, there is no session to tell.
    report(TOOL, log, path, 0, "--log-only")
    assert "No session was followed" in Page(path).text()
    note = b"vbss surgeon seed 1"
    log.write_bytes(log.read_bytes().replace(note, note[:-1] + b"2", 1))
    report(TOOL, log, path, 2)


def check_pad(folder):
    """No program makes this scene for the report: it is loaded from the log, bodies that come later too."""
    path = folder / "pad.html"
    report(TOOL, THROW, path, 0)
    page = Page(path)
    assert "Played back to the same bits" in page.text() and "examples/pad" in page.text()
    assert "No knot is judged in this scene" in page.text()
    for side in ("left", "right"):
        assert float(page.rows("largest of all, " + side)[0][0]) > 0.1, "a hand that drives a needle feels it"


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        if PART == "begin":
            check_begin(folder)
        elif PART == "session":
            check_session(folder)
        elif PART == "pad":
            check_pad(folder)
        else:
            check_throw(folder)
            check_stitch(folder, sys.argv[4])


if __name__ == "__main__":
    main()
