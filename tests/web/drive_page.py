"""The page in Chromium, from the disk: a mouse and keys that a script moves, and what other files drive it by."""
import base64
import gzip
import json
import math
import pathlib
import re
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "replay_page"))
sys.path.insert(0, str(HERE.parent / "viewer"))
import blocks  # noqa: E402
import browser  # noqa: E402
import hands  # noqa: E402

SIZE = (480, 360)
PATIENCE = 120.0  # s
COUNT = 1e-4  # m


class Page:
    """The page, by its elements and by what its pictures say."""

    def __init__(self, chromium, page, before=None):
        self.browser = chromium
        if before:
            chromium.ask("Page.addScriptToEvaluateOnNewDocument", source=before)
        chromium.open(page.as_uri())
        self.until("!document.getElementById('scenes').hidden && suturing.frames > 1")

    def run(self, script):
        return self.browser.run(script)

    def until(self, condition, seconds=PATIENCE):
        end = time.monotonic() + seconds
        while not self.run(f"Boolean({condition})"):
            problem = self.run("document.getElementById('problem').textContent")
            assert not problem, problem
            assert time.monotonic() < end, (condition, self.run("suturing.shown"))
            time.sleep(0.05)

    def state(self):
        """Of a picture that was asked for after this call."""
        self.run("suturing.seen = suturing.frames")
        self.until("suturing.frames > suturing.seen + 1")
        return self.run("suturing.shown.state")

    def tool(self, side=hands.RIGHT):
        return self.state()["tools"][side]

    def click(self, selector):
        self.run(f"document.querySelector('{selector}').scrollIntoView({{ block: 'nearest' }})")
        x, y, width, height = self.browser.box(selector)
        for kind in ("mousePressed", "mouseReleased"):
            self.browser.mouse(kind, x + width / 2, y + height / 2)

    def key(self, kind, key):
        self.browser.ask("Input.dispatchKeyEvent", type=kind, key=key, code=key)

    def press_key(self, key, text=""):
        """As a keyboard does it: a character where the key has one."""
        numbers = {"Tab": 9, "Enter": 13, " ": 32}
        code = "Space" if key == " " else key
        self.browser.ask("Input.dispatchKeyEvent", type="keyDown", key=key, code=code, windowsVirtualKeyCode=numbers[key],
                         nativeVirtualKeyCode=numbers[key], text=text)
        self.browser.ask("Input.dispatchKeyEvent", type="keyUp", key=key, code=code, windowsVirtualKeyCode=numbers[key],
                         nativeVirtualKeyCode=numbers[key])

    def start(self, scene):
        self.click(f'[data-scene="{scene}"]')
        self.until("suturing.shown.state.steps > 10")

    def begin_again(self):
        """By the button. The page counts the sessions that begin: on a slow machine the time between two questions of this
        script is longer than a short replay."""
        self.run("(suturing.sessions = 0, suturing.hearBegun = begun => { suturing.sessions++;"
                 " Object.getPrototypeOf(suturing).hearBegun.call(suturing, begun); }, 0)")
        self.click("#again")
        self.until("suturing.sessions > 0")
        return self.state()

    def pass_time(self, steps):
        """Of the session, whatever the machine makes of it."""
        begin = self.state()["steps"]
        self.until(f"suturing.shown.state.steps >= {begin + steps}")

    def picture(self, path):
        self.browser.picture(path)
        return blocks.read_png(path)


def distance(a, b):
    return math.sqrt(sum((p - q) ** 2 for p, q in zip(a, b)))


def lit(rows):
    """Share of the picture that is no black."""
    bright = [max(row[i:i + 3]) > 40 for row in rows for i in range(0, len(row), 3)]
    return sum(bright) / len(bright)


# ---- mouse and keys


def check_mouse(page):
    middle = (SIZE[0] / 2, SIZE[1] / 2)
    page.browser.mouse("mouseMoved", *middle, button="none")
    start = page.tool()
    page.browser.mouse("mousePressed", *middle)  # takes it
    page.browser.mouse("mouseReleased", *middle)
    page.until("suturing.desk.taken")
    assert page.tool()["closes"] == start["closes"], "the click that takes the mouse closes the jaws"
    page.browser.mouse("mouseMoved", middle[0] - 60, middle[1] + 40, button="none")
    page.pass_time(400)
    moved = page.tool()["target"]
    along = (moved[0] - start["target"][0], distance(moved, start["target"]))
    assert abs(along[0] + 60 * COUNT) < 1e-4, along
    assert abs(along[1] - math.hypot(60, 40) * COUNT) < 1e-4, along
    page.browser.mouse("mouseWheel", middle[0] - 60, middle[1] + 40, button="none", deltaX=0, deltaY=-200)  # two notches of 2 mm
    page.pass_time(400)
    assert abs(distance(page.tool()["target"], moved) - 4e-3) < 1e-4
    return moved


def check_jaws_and_sides(page):
    middle = (SIZE[0] / 2 - 60, SIZE[1] / 2 + 40)
    closes = page.tool()["closes"]
    for wanted in (not closes, closes):
        for kind in ("mousePressed", "mouseReleased"):
            page.browser.mouse(kind, *middle)
        page.pass_time(500)
        assert page.tool()["closes"] == wanted and (page.tool()["opening"] < 0.1) == wanted
    right, left = page.tool(1)["target"], page.tool(0)["target"]
    page.key("keyDown", "Tab")
    page.key("keyUp", "Tab")
    page.key("keyDown", "d")
    begin = page.state()["steps"]
    page.pass_time(300)
    page.key("keyUp", "d")
    page.pass_time(400)
    went = page.tool(0)["target"][0] - left[0]
    print(f"held for {page.state()['steps'] - begin - 400} steps or more, a key moved the left tool by {1e3 * went:.1f} mm")
    assert went > 2e-3 and distance(page.tool(1)["target"], right) < 1e-6
    page.key("keyDown", " ")  # the clutch
    here = page.tool(0)["target"]
    page.browser.mouse("mouseMoved", middle[0] + 50, middle[1], button="none")
    page.pass_time(300)
    assert distance(page.tool(0)["target"], here) < 1e-6 and page.tool(0)["clutched"]
    page.key("keyUp", " ")
    page.pass_time(100)
    assert not page.tool(0)["clutched"]


def check_gamepad(page):
    """Of the standard mapping, which a test puts there: the left tool goes to the right, its jaws close and open, the right one
    is next, and a stick that is let go moves nothing."""
    page.run("suturing.buttons = Array.from({ length: 17 }, () => ({ pressed: false, value: 0 })); suturing.axes = [0, 0, 0, 0];"
             "navigator.getGamepads = () => [{ mapping: 'standard', axes: suturing.axes, buttons: suturing.buttons }]")

    def press(button, value):
        page.run(f"suturing.buttons[{button}] = {{ pressed: {'true' if value else 'false'}, value: {value} }}")
        page.state()
        page.state()

    before = page.tool(0)
    page.run("suturing.axes = [1, 0, 0, 0]")
    page.pass_time(300)
    page.run("suturing.axes = [0.1, 0, 0, 0]")  # worn sticks do not rest in the middle
    page.state()
    page.pass_time(400)
    after = page.tool(0)
    went = after["target"][0] - before["target"][0]
    assert went > 2e-3, went
    page.pass_time(200)
    assert distance(page.tool(0)["target"], after["target"]) < 1e-6, "a stick that was let go moves the tool"
    press(7, 1)
    press(7, 0)
    assert page.tool(0)["closes"] != before["closes"]
    press(0, 1)
    press(0, 0)
    assert page.tool(0)["closes"] == before["closes"]
    press(5, 1)
    press(5, 0)
    assert page.run("suturing.desk.side") == 1
    print(f"a gamepad moved the left tool by {1e3 * went:.1f} mm")
    page.run("navigator.getGamepads = () => []")


def check_camera_and_pause(page, folder):
    before = page.picture(folder / "before.png")
    page.key("keyDown", "ArrowRight")
    page.until("suturing.desk.look.aside > 0.3")
    page.key("keyUp", "ArrowRight")
    page.state()
    assert blocks.apart(blocks.blocks(before), blocks.blocks(page.picture(folder / "turned.png"))) > 5.0
    page.key("keyDown", "p")
    page.key("keyUp", "p")
    steps = page.state()["steps"]
    page.state()
    assert page.state()["steps"] == steps and page.run("document.getElementById('tool').textContent").endswith("paused")
    return steps


def check_same_bits(page, calls_natively):
    """In the browser the session goes the same way as natively, when it is given the same hands at the same steps."""
    script = hands.controllers(hands.STITCH)
    wanted = [line for line in calls_natively("\n".join(script) + "\n") if not line.startswith("{")]
    messages = []
    for line in script:
        word, *numbers = line.split()
        v = [float(n) for n in numbers]
        if word == "begin":
            messages.append({"name": "begin", "scene": int(v[0]), "seed": int(v[1])})
        elif word == "step":
            messages.append({"name": "steps", "count": int(v[0])})
        elif word == "pose":
            messages.append({"name": "pose", "side": int(v[0]), "position": v[1:4], "orientation": v[4:8], "jaw": v[8],
                             "clutched": v[9] != 0, "seconds": v[10]})
        elif word == "track":
            messages.append({"name": "track", "side": int(v[0]), "tracked": v[1] != 0})
        elif word == "hash":
            messages.append({"name": "steps", "count": 0})
        elif word == "state":
            break
    page.run(f"(suturing.answers = [], suturing.messages = {json.dumps(messages)}, 0)")
    page.run("void (async () => { for (const m of suturing.messages) { suturing.send(m); if (m.name === 'steps') {"
             " const hashes = await new Promise(done => { suturing.hearStepped = done; });"
             " if (m.count === 0) suturing.answers.push(hashes.join(' ')); } } suturing.finished = true; })()")
    page.until("suturing.finished")
    found = page.run("suturing.answers")
    assert len(found) > 5 and found == wanted[:len(found)], (found, wanted)
    print(f"{len(found)} hashes of scene and session in the browser are those of the native library")


def save(page, folder, name, button="#save", called="suturing.vbss"):
    """By the button, as a person saves it."""
    page.browser.ask("Page.setDownloadBehavior", behavior="allow", downloadPath=str(folder))
    target = folder / called
    target.unlink(missing_ok=True)
    page.key("keyDown", "Escape")  # the mouse is the page's again
    page.key("keyUp", "Escape")
    page.until("!suturing.desk.taken")
    page.click(button)
    end = time.monotonic() + PATIENCE
    while not target.exists() or list(folder.glob("*.crdownload")):
        assert time.monotonic() < end, "nothing was saved"
        time.sleep(0.1)
    return target.rename(folder / f"{name}{target.suffix}")


def share(page, folder, name):
    return save(page, folder, name, "#share", "suturing-session.html")


def check_shared(shared, folder, log, recorded):
    """The page with the session in it, opened from the disk: it plays the session by itself, to the hashes of the recording, and
    what it shares in its turn has the same log. The complaints of that browser."""
    def log_of(page_file):
        return gzip.decompress(base64.b64decode(re.search(r'id="session">([^<]+)<', page_file.read_text()).group(1)))

    assert log_of(shared) == log.read_bytes(), "the log is not the one that was saved"
    with browser.Browser(SIZE) as chromium:
        page = Page(chromium, shared)
        page.until("suturing.shown.state.replay && suturing.shown.state.steps > 10")
        assert page.run("document.getElementById('start').hidden && !document.getElementById('timeline').hidden")
        length = page.state()["replay"]["steps"]
        page.run(f"suturing.timeline.ask({length})")
        page.until(f"suturing.shown.state.steps === {length} && suturing.timeline.wanted === null")
        state = page.state()
        assert not state["replay"]["differs"] and state["replay"]["whole"] and page.run("suturing.hashes") == recorded, (state["replay"], recorded)
        again = share(page, folder, f"{shared.stem}-again")
        assert log_of(again) == log.read_bytes() and again.stat().st_size == shared.stat().st_size
        print(f"shared as a page of {1e-6 * shared.stat().st_size:.2f} MB, {1e-6 * log.stat().st_size:.2f} MB of it the log before it was packed: {length} steps, "
              f"the hashes at the end are those of the session")
        return complaints_of(chromium, shared)


def check_played(page, folder):
    """The file that was saved is opened and played: by the time line to its middle, back, and to its end."""
    recorded = page.run("suturing.hashes")
    document = page.browser.ask("DOM.getDocument")["root"]["nodeId"]
    field = page.browser.ask("DOM.querySelector", nodeId=document, selector="#log")["nodeId"]
    page.click("#choose")
    page.browser.ask("DOM.setFileInputFiles", nodeId=field, files=[str((folder / "same.vbss").resolve())])
    page.until("suturing.shown.state.replay && suturing.shown.state.steps > 100")
    length = page.state()["replay"]["steps"]
    for share in (0.5, 0.25):
        page.key("keyDown", "p")
        page.until("suturing.shown.clock.paused")
        page.state()
        x, y, width, height = page.browser.box("#line")  # words beside it have their say
        for kind in ("mousePressed", "mouseReleased"):
            page.browser.mouse(kind, x + share * width, y + height / 2)
        page.until("suturing.timeline.wanted === null")
        at = page.state()["steps"]
        assert abs(at / length - share) < 0.05, (at, length)
        page.state()
        assert page.state()["steps"] == at, "it is paused"
        page.key("keyDown", "p")
        page.key("keyUp", "p")
        page.until(f"suturing.shown.state.steps >= {at + 100}")
    page.picture(folder / "timeline.png")
    for key in (" ", "x", "d"):  # hands have no say
        page.key("keyDown", key)
        page.state()
        page.key("keyUp", key)
    page.run(f"suturing.timeline.ask({length})")
    page.until(f"suturing.shown.state.steps === {length} && suturing.timeline.wanted === null")
    state = page.state()
    assert not state["replay"]["differs"] and page.run("suturing.hashes") == recorded, (state["replay"], recorded)
    assert "the end" in page.run("document.getElementById('line-time').textContent")
    state = page.begin_again()
    assert state["replay"] and not state["replay"]["differs"], state["replay"]
    print(f"played from the file: {length} steps, sought by the time line, and the hashes at the end are those of the session")


def check_exercises(page, folder):
    """An exercise within the task begins where the task is so far; aids are switched by the keyboard alone, and are in the
    session; an outcome is counted, and a damaged count is kept."""
    page.run("(localStorage.clear(), suturing.showProgress())")
    page.click("#choose")
    page.click('[data-name="square_throw"]')
    page.until("suturing.shown.state.exercise && suturing.shown.state.exercise.name === 'square_throw' && suturing.shown.state.steps > 20")
    state = page.state()
    assert state["task"]["throws"] == 1 and state["task"]["seated"] == 1 and state["task"]["transfers"] == 1, state["task"]
    assert state["aids"] == 0 and state["tools"][1 - hands.RIGHT]["holds"] == "the needle", state
    page.run("document.getElementById('aids-button').focus()")
    page.press_key("Enter", "\r")
    assert not page.run("document.getElementById('aids').hidden") and page.run("document.getElementById('aids-button').ariaExpanded") == "true"
    page.press_key("Tab")  # past the help to the first box, and on
    while page.run("document.activeElement.dataset.aid") != "8":
        page.press_key("Tab")
    page.press_key(" ", " ")
    page.until("suturing.shown.state.aids === 8")
    assert not page.tool()["clutched"], "space in a box is no clutch"
    page.picture(folder / "aids.png")
    page.press_key(" ", " ")
    page.until("suturing.shown.state.aids === 0")
    assert page.state()["aidsUsed"] == 8
    page.click("#choose")
    page.click('[data-name="take_needle"]')
    page.until("suturing.shown.state.exercise.name === 'take_needle' && suturing.shown.state.steps > 5")
    assert page.state()["aidsUsed"] == 0
    words = page.run("suturing.note({ name: 'take_needle', time: 12.5 }, true)")
    assert words == "1 of 1 passed, 1 without aids", words
    assert page.run("document.querySelector('[data-name=take_needle] span').textContent") == "1 of 1 passed"
    page.run("localStorage.setItem('suturing-progress', 'a letter')")
    assert "damaged" in page.run("suturing.note({ name: 'take_needle', time: 12.5 }, true)")
    assert page.run("localStorage.getItem('suturing-progress')") == "a letter"
    page.run("localStorage.clear()")
    page.click("#choose")
    page.picture(folder / "exercises.png")
    print("a square throw begins with the first one seated; aids by the keyboard; progress is counted")


def check_ghost(page, folder):
    """An expert's tools are in the picture, in the next session, too, until they are switched off. The choice of scenes is open."""
    page.click('[data-name="take_needle"]')
    page.until("suturing.shown.state.exercise && suturing.shown.state.exercise.name === 'take_needle' && suturing.shown.state.steps > 20 "
               "&& !suturing.paused")
    assert page.run("suturing.renderer.ghost") == 0
    page.click("#ghost")
    page.until("suturing.renderer.ghost > 0")
    page.picture(folder / "ghost.png")
    parts = page.run("[...suturing.renderer.meshes.parts].filter((n, i) => i % 8 === 1 && n === suturing.renderer.ghost).length")
    assert parts == 2, parts
    page.begin_again()
    page.until("suturing.renderer.ghost > 0")
    page.key("keyDown", "g")
    page.until("suturing.renderer.ghost === 0")
    page.key("keyUp", "g")
    print("ghost hands: two tools, also after a new beginning, until they are switched off")


def complaints_of(chromium, page):
    """What it said, and what it asked for beside itself and its own worker."""
    asked = [url for url in chromium.requests if url != page.as_uri() and not url.startswith("blob:")]
    return chromium.complaints + [f"it asked for {url}" for url in asked]


def check_desk(page_file, folder, calls_natively, replay):
    with browser.Browser(SIZE) as chromium:
        page = Page(chromium, page_file)
        loaded = page.run("suturing.loaded")
        page.start(hands.NEEDLE)
        check_mouse(page)
        check_jaws_and_sides(page)
        check_gamepad(page)
        steps = check_camera_and_pause(page, folder)
        rows = page.picture(folder / "desk.png")
        assert 0.3 < lit(rows) < 0.95, f"{lit(rows)} of the picture is lit"
        clock = page.run("suturing.shown.clock")
        print(f"unpacked in {loaded:.0f} ms; {steps} steps, {clock['stepTime']:.2f} ms each, late {clock['late']}, "
              f"{clock['givenUp'] / 1e3:.2f} s given up, {page.run('suturing.frames')} pictures")
        replay(save(page, folder, "mouse"))
        check_same_bits(page, calls_natively)
        log = save(page, folder, "same")
        replay(log)
        recorded = page.run("suturing.hashes")
        shared = share(page, folder, "shared")
        check_played(page, folder)
        check_exercises(page, folder)
        check_ghost(page, folder)
        complaints = complaints_of(chromium, page_file)
    return complaints + check_shared(shared, folder, log, recorded)
