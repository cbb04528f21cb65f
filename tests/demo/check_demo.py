"""The demonstration makes all its files of one performance: they are what the separate programs make of its log.

    check_demo.py FOLDER DEMO --report PROGRAM [--player PROGRAM] [--viewer PROGRAM]

It performs the first stage of the task only: the needle is passed through both marks. A program that was not built is left out;
the demonstration must then say that its file is missing."""
import argparse
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

FILM_EVERY, STILLS_EVERY = 0.2, 4.0  # s, simulated
MAX_LINES = 25  # of a summary
PNG = b"\x89PNG\r\n\x1a\n"


def run(*words, wanted=0, **more):
    done = subprocess.run([str(w) for w in words], capture_output=True, text=True, **more)
    assert done.returncode == wanted, (words, done.returncode, done.stdout, done.stderr)
    return done


def perform(demo, folder, **more):
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "stages").mkdir(parents=True)
    return run(demo, folder, "-u", "pass", **more)


def length_of(details):
    """Simulated seconds of the performance."""
    return float(re.search(r"after ([0-9.]+) s; the session", details.read_text()).group(1))


def check_summary(done, folder, names):
    lines = [line for line in done.stdout.splitlines() if not line.startswith("[")]
    assert 5 < len(lines) <= MAX_LINES, lines
    assert "MISSING" not in done.stdout, done.stdout
    for name in names:
        assert f"{folder / name}\n" in done.stdout, (name, done.stdout)


def check_progress(done):
    shown = [line for line in done.stdout.splitlines() if line.startswith("[")]
    assert shown and all(re.match(r"\[#*\.*\] +\d+ % .*\S", line) for line in shown), shown


def without_simulation(page):
    """How the steps were made, and how long they took here, is all in which two reports of a session may differ."""
    text, count = re.subn(r'<section aria-labelledby="simulation">.*?</section>', "", page.read_text(),
                          flags=re.DOTALL)
    assert count == 1, count
    return text


def check_report(report, folder, log, scratch, player):
    moments = ["--replay-page", "replay.html"] if player else []
    run(report, log, "-o", scratch / "report.html", "--pictures", folder / "stages", *moments)
    mine, theirs = (without_simulation(p / "report.html") for p in (folder, scratch))
    assert mine == theirs, "the report differs from that of the log"
    assert "Watched while the hands made it" in (folder / "report.html").read_text()


def check_player(player, folder, log, scratch):
    run(player, log, "-o", scratch / "replay.html")
    assert (folder / "replay.html").read_bytes() == (scratch / "replay.html").read_bytes(), "replay page"


def check_stills(viewer, folder, log, scratch, seconds):
    run(viewer, "--replay", log, "--png", scratch, "--every", STILLS_EVERY, "--size", "640x480")
    mine, theirs = (sorted(p.glob("frame-*.png")) for p in (folder, scratch))
    assert len(mine) == math.floor(seconds / STILLS_EVERY) + 1, mine
    assert [p.name for p in mine] == [p.name for p in theirs], (mine, theirs)
    for a, b in zip(mine, theirs):
        assert a.read_bytes().startswith(PNG) and a.read_bytes() == b.read_bytes(), a


def check_film(folder, seconds):
    words = ["-v", "error", "-count_frames", "-select_streams", "v", "-show_entries",
             "stream=width,height,nb_read_frames", "-of", "csv=p=0"]
    said = run("ffprobe", *words, folder / "task.mp4").stdout.strip()
    assert said == f"480,360,{math.floor(seconds / FILM_EVERY + 1e-6) + 1}", said


def main():
    options = argparse.ArgumentParser()
    options.add_argument("folder", type=pathlib.Path)
    options.add_argument("demo")
    options.add_argument("--report", required=True)
    options.add_argument("--player")
    options.add_argument("--viewer")
    o = options.parse_args()
    done = perform(o.demo, o.folder)
    log, names = o.folder / "task.vbss", ["report.html", "stages", "task.vbss", "details.txt"]
    drawn = o.viewer is not None and "OpenGL 3.3 is missing" not in done.stderr
    seconds = length_of(o.folder / "details.txt")
    assert list((o.folder / "stages").glob("*.png")), "no key stage"
    with tempfile.TemporaryDirectory() as scratch:
        check_report(o.report, o.folder, log, pathlib.Path(scratch), o.player)
        if o.player is not None:
            names.append("replay.html")
            check_player(o.player, o.folder, log, pathlib.Path(scratch))
        else:
            assert "No replay page" in done.stderr, done.stderr
        if drawn:
            check_stills(o.viewer, o.folder, log, pathlib.Path(scratch), seconds)
    if drawn and shutil.which("ffmpeg"):
        names.append("task.mp4")
        check_film(o.folder, seconds)
    else:
        assert "No film" in done.stderr and not (o.folder / "task.mp4").exists(), done.stderr
    check_summary(done, o.folder, names)
    check_progress(done)
    if drawn:  # without ffmpeg it says so, and makes the rest
        poor = perform(o.demo, o.folder, env={**os.environ, "PATH": os.devnull})
        assert "No film" in poor.stderr and not (o.folder / "task.mp4").exists(), poor.stderr
        assert (o.folder / "frame-0001.png").exists() and (o.folder / "report.html").exists()


sys.exit(main())
