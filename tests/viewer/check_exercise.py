"""Stills of the log of an exercise, which begins where a state was restored: the first at its begin, and one each ten seconds.

    check_exercise.py <trainee> <starts> <viewer> <folder>"""
import os
import pathlib
import re
import subprocess
import sys

EVERY = 10.0  # s


def main():
    trainee, starts, viewer, folder = sys.argv[1], sys.argv[2], sys.argv[3], pathlib.Path(sys.argv[4])
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
    print(f"an exercise of {seconds} s: {found} stills, {wanted} wanted")
    return 0 if found == wanted else 1


sys.exit(main())
