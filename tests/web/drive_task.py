"""The whole task in the page: the scripted surgeon moves the controllers of the stand-in (perform_hands.js)."""
import base64
import time

import hands
from drive_headset import EYES
from drive_page import HERE, Page, browser, complaints_of, save

TASK = 3600.0  # s of wall time: the processor draws both eyes
STILL_EVERY = 8.0  # s of the session


def perform(page, seed, folder):
    """The surgeon's hands move the controllers until it has ended; the state then."""
    page.run(f"performer.begin({seed})")
    end, still = time.monotonic() + TASK, 0.0
    while not page.run("performer.ended"):
        problem = page.run("document.getElementById('problem').textContent")
        assert not problem, problem
        assert time.monotonic() < end, page.run("performer.doing")
        seconds = 1e-3 * page.run("suturing.shown.state.steps")
        if seconds >= still:
            page.run("standIn.asked = true")
            page.until("!standIn.asked")
            picture = page.run("standIn.picture").partition(",")[2]
            (folder / f"task-{seed}-{int(still):03d}.png").write_bytes(base64.b64decode(picture))
            still += STILL_EVERY
        time.sleep(0.5)
    return page.state()


def check_task(page_file, folder, seeds, replay):
    scripts = "\n".join((HERE / name).read_text() for name in ("stand_in_xr.js", "perform_hands.js"))
    for seed in seeds:
        with browser.Browser(EYES) as chromium:
            page = Page(chromium, page_file, scripts)
            page.until("!document.getElementById('headset').hidden")
            page.start(hands.STITCH)
            page.click("#headset")
            page.until("suturing.headset.tracked[1]")
            begin = time.monotonic()
            state = perform(page, seed, folder)
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
