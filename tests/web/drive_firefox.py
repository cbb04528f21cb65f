"""The page in Firefox, from the disk: controllers take the needle, and hashes and log are those of the native library."""
import base64
import time

import drive_page
import hands
import marionette

SIZE = (640, 480)


class FirefoxPage:
    """As much of drive_page.Page as a script of calls needs."""

    def __init__(self, firefox, page):
        self.browser = firefox
        firefox.open(page.as_uri())
        self.until("!document.getElementById('scenes').hidden && suturing.frames > 1")

    def run(self, script):
        # A statement, or an expression with its value.
        return self.browser.run(script)

    until = drive_page.Page.until


def take_log(page):
    """What the button saves; a headless Firefox has no folder for it."""
    page.run("(suturing.hearLog = ({ blob, hashes }) => { suturing.hashes = hashes; const reader = new FileReader();"
             " reader.onload = () => { suturing.saved = reader.result; }; suturing.savedBlob = blob; reader.readAsDataURL(blob); },"
             " suturing.send({ name: 'log', end: true }), 0)")
    page.until("suturing.saved")
    return base64.b64decode(page.run("suturing.saved").partition(",")[2])


def check_proxy(firefox, folder):
    """The proxy counts what a page from the disk asks for, so that a page that asks for nothing is known."""
    asking = folder / "asking.html"
    asking.write_text("<img src='http://picture.invalid/a.png'><script>fetch('https://fetched.invalid/').catch(() => {});"
                      "new WebSocket('ws://socket.invalid/');</script>")
    firefox.open(asking.as_uri())
    wanted = {"picture.invalid", "fetched.invalid", "socket.invalid"}
    end = time.monotonic() + marionette.PATIENCE
    while not wanted <= set(firefox.hosts()):
        assert time.monotonic() < end, firefox.proxy.asked
        time.sleep(0.1)
    firefox.proxy.asked.clear()


def check_shared(firefox, page, folder):
    """The page with the session in it, opened from the disk."""
    hashes = page.run("suturing.hashes")
    page.run("(suturing.own.fileWith(suturing.savedBlob).then(file => { const reader = new FileReader();"
             " reader.onload = () => { suturing.shared = reader.result; }; reader.readAsDataURL(file); }), 0)")
    page.until("suturing.shared")
    shared = folder / "firefox-shared.html"
    shared.write_bytes(base64.b64decode(page.run("suturing.shared").partition(",")[2]))
    page = FirefoxPage(firefox, shared)
    page.until("suturing.shown.state.replay && suturing.shown.state.steps > 10")
    length = page.run("suturing.shown.state.replay.steps")
    page.run(f"(suturing.timeline.ask({length}), 0)")
    page.until(f"suturing.shown.state.steps === {length} && suturing.timeline.wanted === null")
    replay = page.run("suturing.shown.state.replay")
    assert not replay["differs"] and replay["whole"] and page.run("suturing.hashes") == hashes, (replay, hashes)
    print(f"shared: {length} steps are played to the same hashes")


def check(page_file, folder, calls_natively):
    with marionette.Firefox(SIZE) as firefox:
        check_proxy(firefox, folder)
        page = FirefoxPage(firefox, page_file)
        begin = time.monotonic()
        drive_page.check_same_bits(page, calls_natively)
        page.run("(suturing.seen = suturing.frames, 0)")
        page.until("suturing.frames > suturing.seen + 1")
        tool = page.run("suturing.shown.state")["tools"][hands.RIGHT]
        assert tool["holds"] == "the needle" and tool["position"][2] > 10e-3, tool
        page.run("(document.getElementById('start').hidden = true, 0)")
        (folder / "firefox.png").write_bytes(base64.b64decode(firefox.picture()))
        log = folder / "firefox.vbss"
        log.write_bytes(take_log(page))
        print(f"Firefox {firefox.version}: unpacked in {page.run('suturing.loaded'):.0f} ms, the needle is taken, {time.monotonic() - begin:.1f} s")
        check_shared(firefox, page, folder)
        assert not firefox.hosts(), f"asked for from the network: {firefox.hosts()}"
        print(f"no request of the page to a network; {len(firefox.proxy.asked)} of the browser itself were refused")
    return log
