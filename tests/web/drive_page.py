"""The page in Chromium, from the disk: a mouse and keys that a script moves, controllers that a stand-in has (stand_in_xr.js)."""
import base64
import json
import math
import pathlib
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "replay_page"))
sys.path.insert(0, str(HERE.parent / "viewer"))
import blocks  # noqa: E402
import browser  # noqa: E402
import hands  # noqa: E402

SIZE = (480, 360)
EYES = (480, 240)  # both: they are drawn by the processor
PATIENCE = 120.0  # s
COUNT = 1e-4  # m
STRIDE = 15e-3  # m, of a tool that a controller leads, before its script looks again
REACTION = 250  # steps until it does: the tool has come there


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

    def start(self, scene):
        self.click(f'[data-scene="{scene}"]')
        self.until("suturing.shown.state.steps > 10")

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


def save(page, folder, name):
    """By the button, as a person saves it."""
    page.browser.ask("Page.setDownloadBehavior", behavior="allow", downloadPath=str(folder))
    target = folder / "suturing.vbss"
    target.unlink(missing_ok=True)
    page.key("keyDown", "Escape")  # the mouse is the page's again
    page.key("keyUp", "Escape")
    page.until("!suturing.desk.taken")
    page.click("#save")
    end = time.monotonic() + PATIENCE
    while not target.exists() or list(folder.glob("*.crdownload")):
        assert time.monotonic() < end, "nothing was saved"
        time.sleep(0.1)
    return target.rename(folder / f"{name}.vbss")


def check_played(page, folder):
    """The file that was saved is opened and played: by the time line to its middle, back, and to its end."""
    recorded = page.run("suturing.hashes")
    document = page.browser.ask("DOM.getDocument")["root"]["nodeId"]
    field = page.browser.ask("DOM.querySelector", nodeId=document, selector="#log")["nodeId"]
    page.click("#choose")
    page.browser.ask("DOM.setFileInputFiles", nodeId=field, files=[str((folder / "same.vbss").resolve())])
    page.until("suturing.shown.state.replay && suturing.shown.state.steps > 100")
    length = page.state()["replay"]["steps"]
    x, y, width, height = page.browser.box("#line")
    for share in (0.5, 0.25):
        page.key("keyDown", "p")
        page.until("suturing.shown.clock.paused")
        for kind in ("mousePressed", "mouseReleased"):
            page.browser.mouse(kind, x + share * width, y + height / 2)
        page.until("suturing.timeline.wanted === null")
        at = page.state()["steps"]
        assert abs(at / length - share) < 0.05, (at, length)
        page.state()
        assert page.state()["steps"] == at, "it is paused"
        page.key("keyDown", "p")
        page.key("keyUp", "p")
        page.pass_time(100)
    page.picture(folder / "timeline.png")
    page.run(f"suturing.timeline.ask({length})")
    page.until(f"suturing.shown.state.steps === {length} && suturing.timeline.wanted === null")
    state = page.state()
    assert not state["replay"]["differs"] and page.run("suturing.hashes") == recorded, (state["replay"], recorded)
    assert "the end" in page.run("document.getElementById('line-time').textContent")
    page.click("#again")
    page.until(f"suturing.shown.state.replay && suturing.shown.state.steps < {length // 2}")
    print(f"played from the file: {length} steps, sought by the time line, and the hashes at the end are those of the session")


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
        replay(save(page, folder, "same"))
        check_played(page, folder)
        return complaints_of(chromium, page_file)


# ---- controllers


class Controllers:
    """The right controller of the stand-in. `go` moves a tool to a place in strides and corrects what is left after each."""
    side, sign = hands.RIGHT, 1  # to the right

    def __init__(self, page):
        self.page = page
        self.at = [0.15, 1.2, -0.35]
        self.turned = 0.0

    def hold(self, is_held):
        self.page.run(f"standIn.hands.right.grip = {'true' if is_held else 'false'}")

    def put(self, trigger):
        half = math.sqrt(0.5)  # it points down, and is turned about the vertical
        c, s = math.cos(0.5 * self.turned), math.sin(0.5 * self.turned)
        q = [c * half, -c * half, s * half, s * half]
        self.page.run(f"Object.assign(standIn.hands.right, {{ position: {self.at}, orientation: {q}, trigger: {trigger} }})")

    def go(self, to, trigger, near=0.4e-3):
        scale = self.page.run("suturing.headset.scale")
        for _ in range(100):
            off = [a - b for a, b in zip(to, self.page.tool(self.side)["target"])]
            if distance(off, (0, 0, 0)) < near:
                return
            share = min(1.0, STRIDE / distance(off, (0, 0, 0)))
            for i, v in enumerate((off[0], off[2], -off[1])):  # to the right, up, away
                self.at[i] += scale * share * v
            self.put(trigger)
            self.page.pass_time(REACTION)
        raise AssertionError(f"the tool does not come to {to}")


def rotate(q, v):
    def across(a, b):
        return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]

    t = [2 * n for n in across(q[1:], v)]
    return [n + q[0] * m + k for n, m, k in zip(v, t, across(q[1:], t))]


class LeftHand(Controllers):
    """A tracked left hand before the scene in a mirror, with the same movements in the mirror."""
    side, sign = 0, -1
    TILT = 0.6  # rad, as tracked_hand.js has it

    def __init__(self, page):
        super().__init__(page)
        self.at[0] *= -1

    def hold(self, is_held):
        self.page.run(f"standIn.fingers.left.fist = {1 if is_held else 0}")

    def put(self, trigger):
        half = 0.5 * (0.5 * math.pi - self.TILT)
        c, s = math.cos(0.5 * self.turned), math.sin(0.5 * self.turned)
        q = [c * math.cos(half), -c * math.sin(half), s * math.cos(half), s * math.sin(half)]
        wrist = [a - b for a, b in zip(self.at, rotate(q, (0.025, 0.0, -0.09)))]  # of stand_in_hand.js: the knuckle is at `at`
        self.page.run(f"Object.assign(standIn.fingers.left, {{ position: {wrist}, orientation: {q}, pinch: {0.06 * (1 - trigger)} }})")


def stop_tools(page):
    """The other hand is not seen: its tool stays where it is."""
    page.run("standIn.hands.left.seen = standIn.fingers.right.seen = false")


def take_needle(page, c):
    place = (c.sign * hands.PLACE[0], hands.PLACE[1])
    c.put(0)
    c.go((*place, 5e-3), 0)
    for i in range(1, 11):
        c.turned = 0.1 * i * c.sign * hands.TURN
        c.put(0)
        page.pass_time(80)
    c.go((*place, -14.2e-3), 0)
    for trigger in (0.3, 0.6, 1.0):
        c.put(trigger)
        page.pass_time(120)
    c.go((*place, 15e-3), 1.0)


def check_clutch(page, c):
    """While the grip button is held the tool stays; afterwards it goes on from there, and does not jump."""
    c.hold(True)
    page.state()
    page.pass_time(100)
    here = page.tool(c.side)["target"]
    c.at[0] -= 0.1
    c.put(1.0)
    page.state()
    page.pass_time(200)
    assert distance(page.tool(c.side)["target"], here) < 1e-4, (page.tool(c.side)["target"], here)
    c.hold(False)
    page.state()
    page.pass_time(200)
    assert distance(page.tool(c.side)["target"], here) < 1e-3, (page.tool(c.side)["target"], here)
    assert page.tool(c.side)["holds"] == "the needle"


def check_headset(page_file, folder, replay):
    with browser.Browser(EYES) as chromium:
        page = Page(chromium, page_file, (HERE / "stand_in_xr.js").read_text())
        page.until("!document.getElementById('headset').hidden")
        page.start(hands.STITCH)
        stop_tools(page)
        page.click("#headset")
        page.until("suturing.headset.tracked[1]")
        c = Controllers(page)
        take_needle(page, c)
        check_panel(page, folder)
        rows = page.picture(folder / "eyes.png")
        half = [row[:len(row) // 2] for row in rows], [row[len(row) // 2:] for row in rows]
        assert all(lit(eye) > 0.1 for eye in half), [lit(eye) for eye in half]
        assert blocks.apart(blocks.blocks(half[0]), blocks.blocks(half[1])) > 1.0, "both eyes see the same"
        state = page.state()
        tool = state["tools"][hands.RIGHT]
        assert tool["holds"] == "the needle" and tool["position"][2] > 10e-3 and tool["tracked"], tool
        assert state["task"]["phase"] == "to the first mark" and not state["tools"][0]["tracked"], state["task"]
        check_clutch(page, c)
        check_again(page)
        check_ports(page)
        frames, pulses, strongest = page.run("[standIn.frames, standIn.pulses, standIn.strongest]")
        print(f"controllers: {state['steps']} steps, {frames} frames, {pulses} pulses, the strongest {strongest:.2f}")
        assert pulses > 0
        page.run("standIn.session.end()")
        page.until("!suturing.shown.state.tools[1].tracked")
        page.click("#pause")
        replay(save(page, folder, "controllers"))
        return complaints_of(chromium, page_file)


def panel_rows(page, folder, name):
    """The upper half of what both eyes see."""
    return page.picture(folder / f"{name}.png")[:EYES[1] // 2]


def check_panel(page, folder):
    """The coach's sentence and the phase are on it, in both eyes; without it the picture is another one."""
    lines = page.run("suturing.captions.lines()")
    goal = next(line["words"] for line in lines if line["kind"] == "goal")
    assert goal == page.run("document.getElementById('goal').textContent") and len(goal) > 20, lines
    assert any(line["kind"] == "phase" and line["words"].startswith("to the first mark") for line in lines), lines
    assert page.run("suturing.headset.panel.words")
    page.click("#pause")
    page.state()
    rows = panel_rows(page, folder, "panel")
    page.run("suturing.headset.panel.draw = () => {}")
    page.state()
    without = panel_rows(page, folder, "without-panel")
    page.run("delete suturing.headset.panel.draw")
    page.click("#pause")
    for eye in (0, 1):
        half = [[row[eye * len(row) // 2:(eye + 1) * len(row) // 2] for row in picture] for picture in (rows, without)]
        white = [sum(min(row[i:i + 3]) > 150 for row in picture for i in range(0, len(row), 3)) for picture in half]
        print(f"the panel has {white[0] - white[1]} bright pixels in eye {eye}")
        assert white[0] > white[1] + 40, white


def check_again(page):
    """B brings the scene before the head, wherever that looks now; standing, it is lower."""
    before = page.run("suturing.headset.placement.place")
    page.run("suturing.settings.standing = true; standIn.again = true")
    page.state()
    page.state()
    page.run("standIn.again = false")
    page.state()
    after = page.run("suturing.headset.placement.place")
    assert abs(before[1] - after[1] - 0.12) < 1e-6 and distance(before[::2], after[::2]) < 1e-6, (before, after)


def shaft_to_port(page):
    """Distance of the port from the line of the right tool's shaft, m."""
    tool = page.tool(1)
    w, x, y, z = tool["orientation"]
    along = (2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y))
    off = [a - b for a, b in zip((0.12, -0.06, 0.1), tool["position"])]
    share = sum(a * b for a, b in zip(along, off))
    return distance(off, [share * a for a in along])


def check_ports(page):
    free = shaft_to_port(page)
    page.run("suturing.settings.ports = true")
    page.state()
    page.pass_time(600)
    through = shaft_to_port(page)
    print(f"the shaft passes the port at {1e3 * free:.1f} mm, with the port switched on at {1e3 * through:.1f} mm")
    assert free > 20e-3 and through < 3e-3, (free, through)


def check_hands(page_file, folder, replay):
    """Left-handed, with tracked hands: the left one takes the needle in the mirror, by a pinch; a fist is the clutch."""
    scripts = "\n".join((HERE / name).read_text() for name in ("stand_in_hand.js", "stand_in_xr.js"))
    with browser.Browser(EYES) as chromium:
        page = Page(chromium, page_file, scripts)
        page.until("!document.getElementById('headset').hidden")
        page.click("#leftHanded")
        page.run("standIn.tracked = true")
        stop_tools(page)
        page.start(hands.STITCH)
        assert page.run("suturing.mirrored") and "left tool" in page.run("suturing.shown.state.coach.goal")
        page.click("#headset")
        page.until("suturing.headset.tracked[0]")
        c = LeftHand(page)
        take_needle(page, c)
        page.picture(folder / "hands.png")
        state = page.state()
        tool = state["tools"][0]
        assert tool["holds"] == "the needle" and tool["position"][2] > 10e-3 and tool["tracked"], tool
        assert state["task"]["phase"] == "to the first mark" and not state["tools"][1]["tracked"], state["task"]
        check_clutch(page, c)
        print(f"a tracked left hand in the mirror: {state['steps']} steps")
        page.run("standIn.session.end()")
        page.until("!suturing.shown.state.tools[0].tracked")
        page.click("#pause")
        page.state()
        page.picture(folder / "mirror.png")
        replay(save(page, folder, "hands"))
        return complaints_of(chromium, page_file)


# ---- the whole task

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
