"""The log of an exercise, which begins where a state was restored. Its first still is of its begin, the next one of ten seconds
later; its report has an outcome, no score, and the phase in which the exercise begins.

    check_exercise.py <trainee> <starts> <viewer> <report> <folder>"""
import os
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "report"))
from pages import Page, report

EVERY = 10.0  # s


def check_report(tool, log, page):
    report(tool, log, page, 0)
    text = Page(page).text()
    assert "Exercise cut Passed" in text and "What to do better" in text, text
    assert "1 cutting the tails 0.00" in text and "taking the needle" not in text, text
    assert "points to the score" not in text and "throws stand" not in text, text


def main():
    trainee, starts, viewer, reporter, folder = *sys.argv[1:5], pathlib.Path(sys.argv[5])
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("frame-*.png"):
        old.unlink()
    log = folder / "cut.vbss"
    tried = subprocess.run([trainee, "cut", starts, "1", "0", str(log)], stdout=subprocess.PIPE, text=True, check=True)
    seconds = float(re.search(r"after ([0-9.]+) s", tried.stdout)[1])
    environment = dict(os.environ, LIBGL_ALWAYS_SOFTWARE="1", GALLIUM_DRIVER="llvmpipe")
    subprocess.run([viewer, "--replay", str(log), "--png", str(folder), "--every", str(EVERY), "--size", "160x120"],
                   env=environment, check=True)
    found, wanted = len(list(folder.glob("frame-*.png"))), 1 + int(seconds / EVERY)
    check_report(reporter, log, folder / "cut.html")
    print(f"an exercise of {seconds} s: {found} stills, {wanted} wanted")
    return 0 if found == wanted else 1


sys.exit(main())
