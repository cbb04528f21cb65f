"""The page in a headset: controllers and tracked hands that a stand-in has (stand_in_xr.js), moved by a script."""
import math

import hands
from drive_page import HERE, Page, blocks, browser, complaints_of, distance, lit, save

EYES = (480, 240)  # both: they are drawn by the processor
STRIDE = 15e-3  # m, of a tool that a controller leads, before its script looks again
REACTION = 250  # steps until it does: the tool has come there


class Controllers:
    """The right controller of the stand-in. `go` moves a tool to a place in several moves, and corrects the error after each."""
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
        check_offset(page, c)
        check_ports(page)
        frames, pulses, strongest = page.run("[standIn.frames, standIn.pulses, standIn.strongest]")
        print(f"controllers: {state['steps']} steps, {frames} frames, {pulses} pulses, the strongest {strongest:.2f}")
        assert pulses > 0
        page.run("standIn.session.end()")
        page.until("!suturing.shown.state.tools[1].tracked")
        page.click("#pause")
        replay(save(page, folder, "controllers"))
        length = page.run("suturing.settings.rightLength")
        check_kept_offset(Page(chromium, page_file), length)
        return complaints_of(chromium, page_file)


def check_offset(page, c):
    """A press of the thumbstick begins to adjust the right tool: the stick makes it longer and turns it down, both at once led by the
    hand, and the panel says so. Another press ends it; the browser keeps the numbers, and the page shows them."""
    def stick(right, back):
        page.run(f"standIn.hands.right.axes = [0, 0, {right}, {back}]")
        page.state()
        page.state()

    def press():
        for is_down in ("true", "false"):
            page.run(f"standIn.hands.right.stick = {is_down}")
            page.state()

    def words():
        return [line["words"] for line in page.run("suturing.headset.lines()") if line["kind"] == "offset"]

    def numbers():
        return page.run("['leftLength', 'leftPitch', 'rightLength', 'rightPitch'].map(name => suturing.settings[name])")

    usual = [120, 0, 120, 0]
    stick(1, -1)
    assert numbers() == usual and not words(), "the stick by itself adjusts the tool"
    stick(0, 0)
    before = page.tool(c.side)
    press()
    assert words() and words()[0] in page.run("suturing.headset.panel.words"), words()
    stick(0, -1)
    page.until("suturing.settings.rightLength > 135")
    stick(0, 0)
    page.state()
    page.pass_time(200)
    longer, tool = numbers(), page.tool(c.side)
    ahead = rotate(before["orientation"], (0, 0, -1e-3 * (longer[2] - usual[2]) / page.run("suturing.headset.scale")))
    went = [b - a for a, b in zip(before["target"], tool["target"])]
    assert longer[:2] == usual[:2] and longer[3] == 0, longer
    assert distance(went, ahead) < 1e-4, (went, ahead)
    stick(1, 0)
    page.until("suturing.settings.rightPitch > 5")
    stick(0, 0)
    page.state()
    page.pass_time(200)
    turned, after = numbers(), page.tool(c.side)
    dot = abs(sum(a * b for a, b in zip(tool["orientation"], after["orientation"])))
    angle = math.degrees(2 * math.acos(min(1.0, dot)))
    assert turned[2] == longer[2] and abs(angle - turned[3]) < 0.5, (turned, angle)
    assert f"{turned[2]:.0f} mm" in words()[0] and f"{turned[3]:.0f}\u00b0 down" in words()[0], (words(), turned)
    press()
    assert not words()
    stick(-1, 1)
    stick(0, 0)
    assert numbers() == turned, "the adjustment has not ended"
    kept = page.run("JSON.parse(localStorage.getItem('suturing'))")
    shown = page.run("['rightLength', 'rightPitch'].map(id => Number(document.getElementById(id).value))")
    assert [kept["rightLength"], kept["rightPitch"]] == turned[2:] and shown == [round(n) for n in turned[2:]], (kept, shown, turned)
    print(f"the right tool is {turned[2]:.0f} mm ahead of its controller, turned by {turned[3]:.0f} degrees ({angle:.1f} in the scene)")


def check_kept_offset(page, length):
    """Opened once more, the page has it; a number in the form is within its limits, and keys that are pressed in it do nothing else."""
    assert page.run("suturing.settings.rightLength") == length and page.run("document.getElementById('rightLength').value") == f"{length:.0f}"
    for typed, kept in (("100", 100), ("1000", 300), ("", 120)):
        page.run(f"(box => {{ box.value = '{typed}'; box.dispatchEvent(new Event('change')); }})(document.getElementById('leftLength'))")
        assert page.run("[suturing.settings.leftLength, JSON.parse(localStorage.getItem('suturing')).leftLength]") == [kept, kept], typed
    page.run("document.getElementById('leftLength').focus()")
    for kind in ("keyDown", "keyUp"):
        page.key(kind, "3")
    assert not page.run("suturing.renderer.showsTension"), "a digit in the form changes the picture"


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
