"""The whole task in the page: the scripted surgeon moves the controllers of the stand-in (perform_hands.js)."""
import base64
import time

import hands
from drive_headset import EYES
from drive_page import HERE, Page, browser, complaints_of, save

TASK = 3600.0  # s of wall time: the processor draws both eyes
STILL_EVERY = 8.0  # s of the session


def open_page(chromium, page_file):
    """In the headset, before the surgeon begins."""
    scripts = "\n".join((HERE / name).read_text() for name in ("stand_in_xr.js", "perform_hands.js"))
    page = Page(chromium, page_file, scripts)
    page.until("!document.getElementById('headset').hidden")
    page.start(hands.STITCH)
    page.click("#headset")
    page.until("suturing.headset.tracked[1]")
    return page


def perform(page, seed, take, every=STILL_EVERY, begin=0.0, end=None):
    """The surgeon's hands move the controllers until it has ended, or until `end` (s of the session). What both eyes see is
    handed to take(seconds, png), every so many seconds of the session from `begin` on."""
    page.run(f"performer.film = {{ begin: {begin}, end: {'Infinity' if end is None else end}, every: {every} }}; performer.begin({seed})")
    until = time.monotonic() + TASK
    while True:
        ended = page.run("performer.ended || performer.seconds > performer.film.end")
        for picture in page.run("performer.pictures.splice(0)"):
            take(picture["seconds"], base64.b64decode(picture["picture"].partition(",")[2]))
        if ended:
            return page.state()
        problem = page.run("document.getElementById('problem').textContent")
        assert not problem, problem
        assert time.monotonic() < until, page.run("performer.doing")
        time.sleep(0.5)


def check_task(page_file, folder, seeds, replay):
    for seed in seeds:
        def take(seconds, png, seed=seed):
            (folder / f"task-{seed}-{int(seconds):03d}.png").write_bytes(png)

        with browser.Browser(EYES) as chromium:
            page = open_page(chromium, page_file)
            begin = time.monotonic()
            state = perform(page, seed, take)
            task = state["task"]
            print(f"seed {seed}: {task['phase']}, {task['time']:.1f} s in {time.monotonic() - begin:.0f} s; score {task['score']:.0f}, "
                  f"slit {task['gap']:.2f} mm; the surgeon: {page.run('performer.doing')}; {page.run('performer.frames')} frames of the "
                  f"controllers", flush=True)
            assert task["number"] == hands.DONE and not task["failure"], task
            page.run("standIn.session.end()")
            page.until("!suturing.shown.state.tools[1].tracked")
            assert page.run("document.getElementById('result').textContent") == "Done"
            page.click("#close-report")
            replay(save(page, folder, f"task-{seed}"))
            complaints = complaints_of(chromium, page_file)
            if complaints:
                return complaints
    return []
