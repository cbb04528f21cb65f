"""A Firefox whose requests go to a proxy that refuses and counts them, on a screen of its own (Xvfb: without one it has no WebGL), spoken to by its own protocol (Marionette): a socket of this
machine, lengths and JSON."""
import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import tempfile
import time

from counting_proxy import CountingProxy

PATIENCE = 120.0  # s
# It asks for nothing by itself, and draws in software.
PREFERENCES = {"browser.shell.checkDefaultBrowser": False, "datareporting.policy.dataSubmissionEnabled": False, "app.update.auto": False,
               "app.normandy.enabled": False, "browser.safebrowsing.downloads.remote.enabled": False, "network.captive-portal-service.enabled": False,
               "network.connectivity-service.enabled": False, "toolkit.telemetry.enabled": False, "webgl.force-enabled": True,
               "webgl.disable-fail-if-major-performance-caveat": True, "browser.aboutwelcome.enabled": False,
               "services.settings.server": "data:,", "extensions.update.enabled": False, "extensions.getAddons.cache.enabled": False,
               "browser.search.update": False, "browser.region.network.url": "", "app.normandy.api_url": "", "dom.push.connection.enabled": False,
               "media.gmp-manager.updateEnabled": False, "app.update.url": "", "dom.security.https_first": False}
OWN = (".mozilla.com", ".mozilla.org", ".mozilla.net", ".firefox.com")  # hosts that the browser asks by itself


def find():
    return shutil.which("firefox-esr") or shutil.which("firefox")


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


class Firefox:
    def __init__(self, size):
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        port = free_port()
        self.proxy = CountingProxy()
        wanted = {**PREFERENCES, "marionette.port": port, "network.proxy.type": 1, "network.proxy.no_proxies_on": "",
                  "network.proxy.allow_hijacking_localhost": True}
        for kind in ("http", "ssl"):
            wanted |= {f"network.proxy.{kind}": "127.0.0.1", f"network.proxy.{kind}_port": self.proxy.port}
        (pathlib.Path(self.profile.name) / "user.js").write_text("".join(f"user_pref({json.dumps(k)}, {json.dumps(v)});\n" for k, v in wanted.items()))
        command = [find(), "--marionette", "--no-remote", "--profile", self.profile.name, f"--width={size[0]}", f"--height={size[1]}"]
        self.process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True,
                                        env={**os.environ, "HOME": self.profile.name, "MOZ_DISABLE_CONTENT_SANDBOX": "1", "DISPLAY": self.open_screen()})
        self.number, self.buffer = 0, b""
        self.socket = self.connect(port)
        self.receive()  # who it is
        self.version = self.ask("WebDriver:NewSession", capabilities={"alwaysMatch": {}})["capabilities"]["browserVersion"]
        self.ask("WebDriver:SetTimeouts", script=int(1e3 * PATIENCE), pageLoad=int(1e3 * PATIENCE))

    def open_screen(self):
        number, write = os.pipe()
        self.screen = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1024x768x24", "-nolisten", "tcp"],
                                       pass_fds=(write,), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(number) as answer:
            return f":{answer.readline().strip()}"

    def connect(self, port):
        end = time.monotonic() + PATIENCE
        while True:
            try:
                s = socket.create_connection(("127.0.0.1", port), 5.0)
                s.settimeout(PATIENCE)
                return s
            except OSError:
                assert self.process.poll() is None, "Firefox has ended"
                assert time.monotonic() < end, "Firefox does not answer"
                time.sleep(0.2)

    def __enter__(self):
        return self

    def __exit__(self, *what):
        self.socket.close()
        os.killpg(self.process.pid, signal.SIGTERM)
        try:
            self.process.wait(10.0)
        except subprocess.TimeoutExpired:
            os.killpg(self.process.pid, signal.SIGKILL)
            self.process.wait()
        self.screen.terminate()
        self.screen.wait()
        self.proxy.close()
        self.profile.cleanup()

    def hosts(self):
        """That pages have asked for something."""
        hosts = [address.rpartition("://")[2].split("/")[0].split(":")[0] for address in self.proxy.asked]
        return [host for host in hosts if not f".{host}".endswith(OWN)]

    def receive(self):
        while b":" not in self.buffer:
            self.more()
        length, _, self.buffer = self.buffer.partition(b":")
        while len(self.buffer) < int(length):
            self.more()
        message, self.buffer = self.buffer[:int(length)], self.buffer[int(length):]
        return json.loads(message)

    def more(self):
        piece = self.socket.recv(1 << 16)
        assert piece, "Firefox has closed"
        self.buffer += piece

    def ask(self, command, **parameters):
        self.number += 1
        text = json.dumps([0, self.number, command, parameters]).encode()
        self.socket.sendall(str(len(text)).encode() + b":" + text)
        _, number, error, result = self.receive()
        assert number == self.number and error is None, (command, error)
        return result

    def open(self, url):
        self.ask("WebDriver:Navigate", url=url)

    def run(self, script):
        """The value of an expression, of the page's own window."""
        return self.ask("WebDriver:ExecuteScript", script=f"return {script}", args=[], sandbox=None)["value"]

    def picture(self):
        return self.ask("WebDriver:TakeScreenshot", full=False)["value"]
