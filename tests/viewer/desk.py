"""A screen without a monitor, the viewer on it, and a mouse and a keyboard that a script moves: real X events, by XTEST.

The script sees what the viewer tells of each frame (--tell), where a person looks at the picture. In lockstep the viewer makes a
frame only when the script grants it, after what it did has come there, which the viewer counts: no machine is too slow then, and
the same script makes the same session. Without lockstep frames come as fast as they can."""
import math
import os
import shutil
import subprocess
import threading
import time

NEEDED = ("Xvfb", "xdotool", "ffmpeg")
COUNT = 1e-4  # m
NOTCH = 2e-3 / 4  # m, with Shift
ROLL = 0.1  # rad a notch
MAX_COUNTS = 60  # counts a frame: the pointer is warped back to the middle of a small window after it
DOWN = math.radians(50.0)  # the camera looks down by so much, along +y
RIGHT = (1.0, 0.0, 0.0)
UP = (0.0, math.sin(DOWN), math.cos(DOWN))
AWAY = (0.0, math.cos(DOWN), -math.sin(DOWN))
FRAME = 0.016  # s, of 16 steps


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def add(a, b, s=1.0):
    return tuple(p + s * q for p, q in zip(a, b))


def missing():
    """What is not installed."""
    return [name for name in NEEDED if shutil.which(name) is None]


class Tool:
    """One tool, as a frame's line has it; m, s, N."""

    def __init__(self, words):
        numbers = [float(w) for w in words if w.replace(".", "").replace("-", "").isdigit()]
        self.at = tuple(1e-3 * v for v in numbers[0:3])
        self.commanded = tuple(1e-3 * v for v in numbers[3:6])
        self.turned = tuple(numbers[6:10])
        self.jaw, self.holds, self.needle, self.force = numbers[10], int(numbers[11]), int(numbers[12]), numbers[13]

    def axis(self, v):
        """A vector of the tool's, in the world."""
        w, x, y, z = self.turned
        t = [2.0 * c for c in (y * v[2] - z * v[1], z * v[0] - x * v[2], x * v[1] - y * v[0])]
        return tuple(v[i] + w * t[i] + c for i, c in enumerate(
            (y * t[2] - z * t[1], z * t[0] - x * t[2], x * t[1] - y * t[0])))


class State:
    """A frame of --live --tell."""

    def __init__(self, line):
        words = line.split()
        at = words.index
        self.frame, self.time = int(words[1]), float(words[3])
        self.active, self.taken = words[5], words[7] == "1"
        self.motion = (float(words[9]), float(words[10]))
        self.wheel, self.events, self.renewed = float(words[12]), int(words[14]), int(words[16])
        left = words.index("left", 10)
        right = words.index("right", left)
        self.tools = {"left": Tool(words[left + 1:right]), "right": Tool(words[right + 1:at("ends")])}
        ends = [1e-3 * float(w) for w in words[at("ends") + 1:at("ends") + 7]]
        self.ends = (tuple(ends[:3]), tuple(ends[3:]))
        self.result, self.throws, self.notation = int(words[at("knot") + 1]), int(words[at("knot") + 2]), words[
            at("knot") + 3]
        self.size = tuple(int(w) for w in words[-2:])


class Desk:
    """Xvfb, the viewer, and xdotool, which reads commands from a pipe."""

    def __init__(self, viewer, words, size="320x240", parse=State, screen="640x480x24", every=0.16, lockstep=True,
                 environment=None):
        self.screen = subprocess.Popen(["Xvfb", "-displayfd", "1", "-screen", "0", screen, "-nolisten", "tcp"],
                                       stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        number = self.screen.stdout.readline().strip()
        self.environment = dict(os.environ, DISPLAY=f":{number}", LIBGL_ALWAYS_SOFTWARE="1", GALLIUM_DRIVER="llvmpipe")
        self.parse, self.state, self.lines, self.lockstep = parse, None, [], lockstep
        self.changed = threading.Condition()
        self.viewer = subprocess.Popen([viewer, *words, "--tell", "--frame-steps", "16", "--every", str(every), "--size", size,
                                        *(["--lockstep"] if lockstep else [])], env={**self.environment, **(environment or {})},
                                       stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.errors = ""
        threading.Thread(target=self._listen, daemon=True).start()
        self.errors_reader = threading.Thread(target=self._listen_errors, daemon=True)
        self.errors_reader.start()
        self.hand = subprocess.Popen(["xdotool", "-"], env=self.environment, stdin=subprocess.PIPE, text=True)
        self.virtual = {}

    def _listen(self):
        for line in self.viewer.stdout:
            state = self.parse(line)
            with self.changed:
                self.state = state
                self.lines.append(line)
                self.changed.notify_all()
        with self.changed:
            self.state = None
            self.changed.notify_all()

    def _listen_errors(self):
        self.errors = self.viewer.stderr.read()

    def hear(self, until, max_seconds=120.0):
        """Until what is told is as it is wanted; grants nothing."""
        end = time.monotonic() + max_seconds
        with self.changed:
            while True:
                if self.viewer.poll() is not None:
                    raise RuntimeError(f"the viewer has ended: {self.errors}")
                s = self.state
                if s is not None and until(s):
                    return s
                self.changed.wait(timeout=1.0)
                if time.monotonic() > end:
                    raise TimeoutError(f"not within {max_seconds} s: {self.lines[-1:]}")

    def run(self, frames):
        """So many frames more."""
        first = self.state.frame if self.state is not None else 0
        if self.lockstep:
            self.viewer.stdin.write("." * frames)
            self.viewer.stdin.flush()
        return self.hear(lambda s: s.frame >= first + frames)

    def wait(self, frames=1, until=None, max_seconds=120.0):
        """For so many frames more, or until a state is as it is wanted."""
        if until is None:
            return self.run(frames)
        end = time.monotonic() + max_seconds
        while self.lockstep and (self.state is None or not until(self.state)):
            self.run(1)
            if time.monotonic() > end:
                raise TimeoutError(f"not within {max_seconds} s: {self.lines[-1:]}")
        return self.hear(until, max_seconds)

    def do(self, *commands):
        self.hand.stdin.write("".join(c + "\n" for c in commands))
        self.hand.stdin.flush()

    def press(self, *commands, count=2):
        """Keys or buttons, until they have come: that went down or up, so many."""
        before = self.state.events
        self.do(*commands)
        return self.hear(lambda s: s.events >= before + count)

    def key(self, name):
        self.press(f"key {name}")
        return self.wait(2)

    def find_window(self):
        return subprocess.run(["xdotool", "search", "--name", "vblast_ss"], env=self.environment, capture_output=True,
                              text=True, check=True).stdout.split()[0]

    def picture(self, path):
        """Of the screen."""
        width, height = self.state.size
        subprocess.run(["ffmpeg", "-loglevel", "error", "-y", "-f", "x11grab", "-video_size", f"{width}x{height}", "-i",
                        self.environment["DISPLAY"], "-frames:v", "1", str(path)], env=self.environment, check=True)

    def close(self):
        """The window's way to end: its exit code."""
        self.do("keyup shift", "key Escape")
        self.wait_end(0.5)
        if self.viewer.poll() is None:
            self.do("key Escape")
        code = self.wait_end(60.0)
        self.stop()
        return code

    def wait_end(self, seconds):
        try:
            return self.viewer.wait(timeout=seconds)
        except subprocess.TimeoutExpired:
            return None

    def stop(self):
        for process in (self.viewer, self.hand, self.screen):
            if process.poll() is None:
                process.terminate()
                process.wait(timeout=30)
        self.errors_reader.join(timeout=10)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()

    # ---- live: two tools by one mouse

    def begin(self):
        """Takes the pointer."""
        self.wait(2)
        width, height = self.state.size
        self.do(f"mousemove {width // 2} {height // 2}", "click 1")
        self.hear(lambda s: s.taken and s.events >= 2)
        self.press("keydown shift", count=1)  # fine: wheels
        self.wait(2)

    def select(self, side):
        if self.state.active != side:
            self.press("key Tab")
            self.wait(until=lambda s: s.active == side)

    def turn_wheel(self, notches):
        """Until they have come."""
        wheel = self.state.wheel + notches
        self.do(*(["click 4" if notches > 0 else "click 5"] * abs(notches)))
        self.hear(lambda s: abs(s.wheel - wheel) < 0.5)

    def roll(self, side, notches):
        """About the tool's axis."""
        self.select(side)
        self.press("keyup shift", "mousedown 3")
        self.wait(2)
        self.turn_wheel(notches)
        self.wait(20)
        self.press("mouseup 3", "keydown shift")
        self.wait(2)

    def jaws(self, side, closed):
        self.select(side)
        self.press("click 1")
        return self.wait(until=lambda s: (s.tools[side].jaw < 0.02) == closed, max_seconds=60.0)

    def nudge(self, side, displacement):
        """Of a vector in m; returns what is left of it, as counts and notches are whole. Fine counts are a quarter."""
        self.select(side)
        rest = [dot(displacement, RIGHT) / (COUNT / 4), -dot(displacement, UP) / (COUNT / 4)]
        notches = round(dot(displacement, AWAY) / NOTCH)
        counts = [round(c) for c in rest]
        if notches:
            self.turn_wheel(notches)
        sent = [0, 0]
        while sent != counts:
            step = [max(-MAX_COUNTS, min(MAX_COUNTS, c - s)) for c, s in zip(counts, sent)]
            want = add(self.state.motion, step)
            self.do(f"mousemove_relative -- {step[0]} {step[1]}")
            self.hear(lambda s, want=want: max(abs(p - q) for p, q in zip(s.motion, want)) < 0.5, max_seconds=20.0)
            self.wait(1)
            sent = [s + d for s, d in zip(sent, step)]
        return counts, notches

    def go(self, side, to, speed=0.05, near=0.5e-3, corrections=4):
        """The tool to a place, in a straight line, not faster than that; then what is missing. Returns the state."""
        s = self.wait(1)
        start = s.tools[side].commanded
        displacement = add(to, start, -1.0)
        parts = max(1, math.ceil(math.sqrt(dot(displacement, displacement)) / 4e-3))
        virtual = start
        for i in range(1, parts + 1):
            want = add(start, displacement, i / parts)
            counts, notches = self.nudge(side, add(want, virtual, -1.0))
            moved = add(add((0.0, 0.0, 0.0), RIGHT, counts[0] * COUNT / 4), UP, -counts[1] * COUNT / 4)
            virtual = add(add(virtual, moved), AWAY, notches * NOTCH)
            self.wait(max(1, math.ceil(4e-3 / speed / FRAME)))
        for _ in range(corrections):
            s = self.wait(12)
            off = add(to, s.tools[side].commanded, -1.0)
            if math.sqrt(dot(off, off)) < near:
                break
            self.nudge(side, off)
        return s

    def roll_to(self, side, direction, axis=(0.0, 1.0, 0.0)):
        """Turns a tool about its own axis until a vector of its frame, across that axis, points that way, or nearly."""
        for _ in range(2):
            tool = self.wait(1).tools[side]
            z, now = tool.axis((0.0, 0.0, 1.0)), tool.axis(axis)
            want = add(direction, z, -dot(direction, z))
            across = (z[1] * now[2] - z[2] * now[1], z[2] * now[0] - z[0] * now[2], z[0] * now[1] - z[1] * now[0])
            notches = round(math.atan2(dot(want, across), dot(want, now)) / ROLL)
            if notches == 0:
                break
            self.roll(side, notches)

    def follow(self, side, places, speed=0.08):
        """From place to place without a stop; what is missing is made good at the end."""
        for place in places[:-1]:
            self.go(side, place, speed, corrections=0)
        return self.go(side, places[-1], speed)
