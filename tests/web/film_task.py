"""A film of the whole task as both eyes of the emulated headset see it: the scripted surgeon moves the controllers (drive_task.py).

    film_task.py PAGE OUT.mp4 [--seed N] [--begin S] [--end S] [--every S] [--speed X] [--size WxH]

PAGE is performed.html of the target web_performed_page. Times are seconds of the session. Needs Chromium and ffmpeg."""
import argparse
import pathlib
import subprocess
import time

import drive_task
from drive_page import browser


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("page", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--begin", type=float, default=0.0, help="of the film; the task is performed from its start")
    parser.add_argument("--end", type=float, help="of film and task; default: when the task is done")
    parser.add_argument("--every", type=float, default=0.08, help="a picture each so many seconds; default 0.08")
    parser.add_argument("--speed", type=float, default=1.0, help="2: twice as fast as real time")
    parser.add_argument("--size", default="960x480", help="of the film, both eyes, even numbers; default 960x480")
    return parser.parse_args()


def open_film(out, rate):
    command = ["ffmpeg", "-y", "-loglevel", "error", "-f", "image2pipe", "-framerate", f"{rate:g}", "-c:v", "png", "-i", "-",
               "-c:v", "libx264", "-crf", "21", "-pix_fmt", "yuv420p", "-movflags", "+faststart", str(out)]
    return subprocess.Popen(command, stdin=subprocess.PIPE)


def main():
    wanted = arguments()
    size = tuple(int(n) for n in wanted.size.split("x"))
    film = open_film(wanted.out, wanted.speed / wanted.every)
    taken, start = [], time.monotonic()

    def take(seconds, png):
        taken.append(seconds)
        film.stdin.write(png)

    with browser.Browser(size) as chromium:
        page = drive_task.open_page(chromium, wanted.page.resolve())
        state = drive_task.perform(page, wanted.seed, take, wanted.every, wanted.begin, wanted.end)
        doing = page.run("performer.doing")
    film.stdin.close()
    task = state["task"]
    print(f"seed {wanted.seed}: {task['phase']} after {task['time']:.1f} s; the surgeon: {doing}")
    assert taken, "it ended before the film began"
    assert film.wait() == 0, "ffmpeg failed"
    print(f"{len(taken)} pictures from {taken[0]:.2f} to {taken[-1]:.2f} s, in {time.monotonic() - start:.0f} s: {wanted.out}")


main()
