"""The page of a session in a browser: what it shows against stills that were looked at, what its controls do, and that it
asks for nothing and complains of nothing.

    check_page.py logs <vbss-replay-page> <log of pass_needle -s 1> <folder>   without a browser
    check_page.py page <vbss-replay-page> <log of pass_needle -s 1> <folder>
    check_page.py surgeon <vbss-replay-page> <log of surgeon -s 0> <folder>    the knot, without a browser

With VBSS_UPDATE_STILLS=1 stills.txt is written instead: look at the pictures before it is committed."""
import os
import pathlib
import re
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "viewer"))
import blocks  # noqa: E402
import browser  # noqa: E402
import film  # noqa: E402

TIMES = (1.6, 4.8)  # s
VIEW = (320, 240)


def write(tool, log, page, wanted, *options):
    run = subprocess.run([tool, log, "-o", page, *options], capture_output=True, text=True)
    assert run.returncode == wanted, (run.returncode, run.stdout, run.stderr)
    return run.stdout + run.stderr


class Player:
    """The page, by its controls."""

    def __init__(self, chromium, page):
        self.browser = chromium
        chromium.open(page.as_uri())
        # Fonts differ from machine to machine, and what is left for the view with them.
        chromium.run("document.getElementById('view').style.cssText = "
                     f"'flex: none; width: {VIEW[0]}px; height: {VIEW[1]}px'")
        chromium.run("window.dispatchEvent(new Event('resize'))")
        chromium.wait_until_idle()

    def text(self, name):
        return self.browser.run(f"document.getElementById('{name}').textContent")

    def time(self):
        return float(self.text("time").split()[0])

    def seek(self, seconds):
        self.browser.run(f"(s => {{ s.value = {seconds}; s.dispatchEvent(new Event('input')); }})"
                         "(document.getElementById('scrub'))")
        self.browser.wait_until_idle()

    def click(self, selector):
        self.browser.run(f"document.querySelector('{selector}').scrollIntoView({{ block: 'nearest' }})")
        x, y, width, height = self.browser.box(selector)
        for kind in ("mousePressed", "mouseReleased"):
            self.browser.mouse(kind, x + width / 2, y + height / 2)
        self.browser.wait_until_idle()

    def key(self, name, modifiers=0):
        self.browser.key(name, modifiers)
        self.browser.wait_until_idle()

    def still(self, path):
        self.browser.wait_until_idle()
        self.browser.picture(path, (*self.browser.box("#canvas")[:2], *VIEW))
        return blocks.blocks(blocks.read_png(path))


def check_stills(player, folder):
    """Two times from the first view, and the second one from elsewhere."""
    found = []
    for i, seconds in enumerate(TIMES):
        player.seek(seconds)
        found.append(player.still(folder / f"still-{i}.png"))
    x, y, width, height = player.browser.box("#canvas")
    middle = (x + width / 2, y + height / 2)
    player.browser.drag(middle, (middle[0] + 90, middle[1] - 30))
    player.browser.mouse("mouseWheel", *middle, button="none", deltaX=0, deltaY=-300)
    found.append(player.still(folder / "still-2.png"))
    if os.environ.get("VBSS_UPDATE_STILLS"):
        blocks.write(HERE / "stills.txt", found)
    complaints = blocks.compare(HERE / "stills.txt", found)
    player.click("#home")
    if blocks.apart(player.still(folder / "home.png"), found[1]) > 0.5:
        complaints.append("the first view is not the one it began with")
    return complaints


def check_controls(player, end):
    player.seek(0.0)
    assert player.time() == 0.0 and player.text("step") == "0" and player.text("phase") == "taking the needle"
    player.click("#forth")
    player.click("#forth")
    assert player.text("step") == "67", player.text("step")  # the third of 30 frames a second
    player.click("#back")
    assert player.text("step") == "34"
    player.key("ArrowRight", modifiers=8)  # with shift: to the event
    assert player.browser.run("document.querySelector('#events .last').textContent").endswith("the right tool takes the needle")
    assert 1.0 < player.time() < 1.5
    player.click("#events li:nth-child(2) button")
    assert player.text("phase") == "inside the drain" and 3.0 < player.time() < 4.0
    assert 0.5 < float(player.text("force-right").split()[0]) < 3.0  # that the wall was entered with
    assert player.text("gap").endswith(" mm open") and player.text("knot") == "no knot"
    player.key("End")
    assert round(player.time(), 2) == end and player.text("play") == "play"
    ticks = player.browser.run("document.querySelectorAll('#ticks span').length")
    assert ticks == 3, ticks


def check_playing(player, end):
    """Goes on by itself, as fast as it is told, and waits at the end."""
    player.seek(end - 0.45)
    player.browser.run("(s => { s.value = '0.5'; s.dispatchEvent(new Event('change')); })(document.getElementById('speed'))")
    begin = time.monotonic()
    player.key(" ")
    assert player.text("play") == "pause"
    while player.text("play") == "pause":
        assert time.monotonic() - begin < 30.0, player.time()
        time.sleep(0.05)
    took = time.monotonic() - begin
    assert round(player.time(), 2) == end and took > 0.85, took  # 0.45 s at half speed
    player.click("#play")  # from the begin again
    player.click("#play")
    here = player.time()
    assert player.text("play") == "play" and 0.0 <= here < 5.0
    player.browser.wait_until_idle()
    assert player.time() == here


def check_theme(player):
    assert player.browser.run("document.documentElement.dataset.theme") == "light"
    player.browser.ask("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark"}])
    player.browser.wait_until_idle()
    assert player.browser.run("getComputedStyle(document.body).backgroundColor") == "rgb(18, 22, 27)"
    player.click("#theme")
    assert player.browser.run("getComputedStyle(document.body).backgroundColor") == "rgb(255, 255, 255)"


def check_page(tool, log, folder):
    page = folder / "pass.html"
    said = write(tool, log, page, 0).strip()
    print(said)
    end = float(re.search(r"frames of ([\d.]+) s", said).group(1))  # as the writer of the page counts
    source = page.read_text()
    assert source.count("<script") == 2 and " src=" not in source and "default-src 'none'" in source
    with browser.Browser((800, 760)) as chromium:
        player = Player(chromium, page)
        complaints = film.check(page) + check_stills(player, folder)
        check_controls(player, end)
        check_playing(player, end)
        check_theme(player)
        if chromium.requests != [page.as_uri()]:
            complaints.append(f"it asked for {chromium.requests}")
        return complaints + chromium.complaints


def check_others(tool, log, folder):
    """A log that was cut off has a page of its good part; what is no log has none."""
    cut, page = folder / "cut.vbss", folder / "cut.html"
    whole = log.read_bytes()
    cut.write_bytes(whole[:len(whole) // 10])
    assert "not whole" in write(tool, cut, page, 1, "--rate", "5")
    assert '"fault":"the log is cut off"' in page.read_text()
    cut.write_bytes(b"no log")
    write(tool, cut, page, 2)
    write(tool, folder / "absent.vbss", page, 2)
    write(tool, log, page, 2, "--rate", "0")


def check_surgeon(tool, log, folder):
    """Its page says of the thread what the surgeon's own eyes said: a double throw, tied after the needle was through."""
    print(write(tool, log, folder / "stitch.html", 0, "--rate", "2").strip())
    session = film.read_session(folder / "stitch.html")
    last = session["knots"][-1]
    through = [e["time"] for e in session["events"] if e["words"] == "the needle is through the wall of the drain"]
    assert (last["notation"], last["verdict"]) == ("2", "certified"), session["knots"]
    assert len(through) == 2 and all(k["notation"] == "" for k in session["knots"] if k["time"] <= through[1])
    assert session["gaps"][-1] < 0.5 < 2.0 < session["gaps"][1], "the throw shuts the slit"


def main():
    part, tool, log, folder = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3]), pathlib.Path(sys.argv[4])
    folder.mkdir(parents=True, exist_ok=True)
    if part == "logs":
        check_others(tool, log, folder)
        return 0
    if part == "surgeon":
        check_surgeon(tool, log, folder)
        return 0
    if browser.find() is None:
        sys.exit("no Chromium: .ci/install-packages tests installs it")
    complaints = check_page(tool, log, folder.resolve())
    print("\n".join(complaints))
    return 1 if complaints else 0


sys.exit(main())
