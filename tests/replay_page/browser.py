"""A headless Chromium that draws in software, spoken to through its pipes: the DevTools protocol, without a port."""
import base64
import json
import os
import select
import shutil
import signal
import subprocess
import tempfile
import time

PATIENCE = 60.0  # s for an answer
FLAGS = ("--headless=new --no-sandbox --no-first-run --disable-extensions --disable-background-networking --disable-sync "
         "--disable-component-update --disable-default-apps --disable-dev-shm-usage --hide-scrollbars --mute-audio "
         "--force-device-scale-factor=1 --force-color-profile=srgb --use-gl=angle --use-angle=swiftshader "
         "--enable-unsafe-swiftshader --remote-debugging-pipe").split()


def find():
    return shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")


class Browser:
    def __init__(self, size):
        self.size, self.number, self.buffer, self.session = size, 0, b"", None
        self.requests, self.complaints = [], []
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)  # its children may still be writing there
        to_it, self.to_it = os.pipe()
        self.from_it, from_it = os.pipe()
        command = [find(), *FLAGS, f"--user-data-dir={self.profile.name}", f"--window-size={size[0]},{size[1]}", "about:blank"]
        # The browser reads from 3 and writes to 4.
        script = f'exec 8<&{to_it} 9>&{from_it}; exec 3<&8 4>&9 8<&- 9>&-; exec "$@"'
        self.process = subprocess.Popen(["bash", "-c", script, "bash", *command], pass_fds=(to_it, from_it),
                                        stderr=subprocess.DEVNULL, start_new_session=True)
        os.close(to_it)
        os.close(from_it)
        target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Network", "Runtime", "Log"):
            self.ask(f"{domain}.enable")
        self.ask("Emulation.setDeviceMetricsOverride", width=size[0], height=size[1], deviceScaleFactor=1, mobile=False)

    def __enter__(self):
        return self

    def __exit__(self, *what):
        os.close(self.to_it)  # it ends with its pipe
        try:
            self.process.wait(10.0)
        except subprocess.TimeoutExpired:
            os.killpg(self.process.pid, signal.SIGKILL)
            self.process.wait()
        os.close(self.from_it)
        self.profile.cleanup()

    def ask(self, method, **parameters):
        self.number += 1
        number = self.number
        message = {"id": number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.to_it, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.receive()
            if answer.get("id") == number:
                assert "error" not in answer, (method, answer["error"])
                return answer["result"]
            self.hear(answer)

    def receive(self):
        until = time.monotonic() + PATIENCE
        while b"\0" not in self.buffer:
            ready, _, _ = select.select([self.from_it], [], [], max(0.0, until - time.monotonic()))
            piece = os.read(self.from_it, 1 << 16) if ready else b""
            assert piece, "the browser says nothing"
            self.buffer += piece
        message, _, self.buffer = self.buffer.partition(b"\0")
        return json.loads(message)

    def hear(self, event):
        params = event.get("params", {})
        if event.get("method") == "Network.requestWillBeSent":
            self.requests.append(params["request"]["url"])
        elif event.get("method") == "Runtime.exceptionThrown":
            details = params["exceptionDetails"]
            self.complaints.append(details.get("exception", {}).get("description", details["text"]))
        elif event.get("method") == "Log.entryAdded" and params["entry"]["level"] in ("error", "warning"):
            self.complaints.append(params["entry"]["text"])
        elif event.get("method") == "Runtime.consoleAPICalled" and params["type"] in ("error", "warning", "assert"):
            self.complaints.append(" ".join(str(a.get("value", a.get("description"))) for a in params["args"]))

    def open(self, url):
        self.ask("Page.navigate", url=url)
        while self.run("document.readyState") != "complete":
            time.sleep(0.05)

    def run(self, script):
        """The value of an expression, a promise's when it is kept."""
        answer = self.ask("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True)
        assert "exceptionDetails" not in answer, (script, answer)
        return answer["result"].get("value")

    def wait_until_idle(self):
        """Two pictures later all that was changed is seen."""
        self.run("new Promise(f => requestAnimationFrame(() => requestAnimationFrame(f)))")

    def mouse(self, kind, x, y, button="left", **more):
        held = {"left": 1, "right": 2, "none": 0}[button] if kind != "mouseReleased" else 0
        self.ask("Input.dispatchMouseEvent", type=kind, x=x, y=y, button=button, buttons=held, clickCount=1, **more)

    def drag(self, begin, end, button="left"):
        self.mouse("mouseMoved", *begin, button="none")
        self.mouse("mousePressed", *begin, button=button)
        for share in (0.25, 0.5, 0.75, 1.0):
            self.mouse("mouseMoved", *(a + share * (b - a) for a, b in zip(begin, end)), button=button)
        self.mouse("mouseReleased", *end, button=button)

    def key(self, key, modifiers=0):
        for kind in ("keyDown", "keyUp"):
            self.ask("Input.dispatchKeyEvent", type=kind, key=key, code=key, modifiers=modifiers)

    def box(self, selector):
        """x, y, width, height of an element."""
        return self.run(f"(r => [r.x, r.y, r.width, r.height])(document.querySelector('{selector}').getBoundingClientRect())")

    def picture(self, path, box=None):
        clip = {} if box is None else {"clip": dict(zip(("x", "y", "width", "height"), box), scale=1)}
        path.write_bytes(base64.b64decode(self.ask("Page.captureScreenshot", format="png", **clip)["data"]))
