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
    page.run("(suturing.hearLog = ({ blob }) => { const reader = new FileReader();"
             " reader.onload = () => { suturing.saved = reader.result; }; reader.readAsDataURL(blob); },"
             " suturing.send({ name: 'log', end: true }), 0)")
    page.until("suturing.saved")
    return base64.b64decode(page.run("suturing.saved").partition(",")[2])


def check(page_file, folder, calls_natively):
    with marionette.Firefox(SIZE) as firefox:
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
    return log
