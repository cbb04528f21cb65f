"""The trainer against the stand-ins of the vendors' libraries: check_trainer.py SUBJECT TRAINER OPENHAPTICS NIDAQ FOLDER
[LOG or SURGEON]

Time is simulated, but for `real_time` and `interrupted`, and nothing is asserted of how long anything takes."""
import pathlib
import random
import re
import signal
import subprocess
import sys

GOOD, FAULTY, WRONG_WORD, NOT_THERE = 0, 1, 2, 3


class Bench:
    def __init__(self, trainer, arms, lines, folder):
        self.trainer, self.folder = trainer, pathlib.Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        self.arms = ["--openhaptics", "--openhaptics-library", arms]
        self.lines = ["--nidaq", "--nidaq-library", lines]
        self.file = str(self.folder / "calibration.txt")

    def run(self, wanted, *words):
        done = subprocess.run([self.trainer, *words], capture_output=True, text=True, stdin=subprocess.DEVNULL)
        text = done.stdout + done.stderr
        assert done.returncode in wanted if isinstance(wanted, tuple) else done.returncode == wanted, \
            f"{words}: ended with {done.returncode}, not {wanted}\n{text}"
        for line in text.splitlines():
            if line.startswith(("slots", "wall misses", "fault", "left:", "right:", "task:")):
                print(line)
        return text

    def rehearse(self, wanted, *words):
        text = self.run(wanted, *self.arms, *self.lines, "--simulated", "--calibration", self.file, *words)
        assert "illegal calls: 0" in text or "--calibrate" in words, text
        return text

    def calibrate(self):
        self.rehearse(GOOD, "--calibrate")


def facts(path):
    return {line.split()[0]: [float(x) for x in line.split()[1:]]
            for line in pathlib.Path(path).read_text().splitlines() if not line.startswith("#")}


def calibrated(b, _):
    """What the guide finds of the stand-ins is how they are: turned by acos 0.8 about their z, 0.6 V closed, 1.2 V open."""
    b.calibrate()
    found = facts(b.file)
    step = 20 / 2**11  # of the converter, V
    for side in ("left", "right"):
        assert found[f"{side}.axes"] == [1, -3, 2], found
        want = [0.9**0.5, 0, 0.1**0.5, 0]  # half of that angle, back, about the world's -y
        assert all(abs(a - w) < 1e-9 for a, w in zip(found[f"{side}.mount"], want)), found
        closed, opened = found[f"{side}.jaw_closed_open"]
        assert abs(closed - 0.6) < step and abs(opened - 1.2) < step, found
        for low, high in zip(found[f"{side}.workspace_low"], found[f"{side}.workspace_high"]):
            assert 0.14 <= high - low < 0.16, found
    before = pathlib.Path(b.file).read_text()
    b.rehearse(NOT_THERE, "--calibrate", "--calibration", str(b.folder / "no/such/file"))
    assert pathlib.Path(b.file).read_text() == before


def pulses(b, _):
    """Solenoids go on as often as the script closes its jaws on the needle: on the lines, not only in our books."""
    b.calibrate()
    text = b.rehearse(GOOD, "--scene", "table", "--seconds", "12")
    right = re.search(r"right: .*wanted (\d+), let through (\d+), on the line (\d+), script (\d+)", text)
    left = re.search(r"left: .*wanted (\d+), let through (\d+), on the line (\d+), script (\d+)", text)
    assert right and set(right.groups()) == {"9"}, text
    assert left and set(left.groups()) == {"0"}, text
    assert float(re.search(r"right: .*most force ([\d.]+) N", text)[1]) > 0.0, text


def task(b, _):
    """The scene of the task, with both arms."""
    b.calibrate()
    text = b.rehearse(GOOD, "--scene", "stitch", "--seconds", "1.8")
    assert "slots: 1800," in text, text
    assert float(re.search(r"left: .*most force ([\d.]+) N", text)[1]) > 0.0, text


ARMS = {"unplugged": "communication failed", "communication": "emergency stop", "nan": "a sample was refused",
        "warm": "refuses forces", "too_fast": "refuses forces", "stale": "the pose is old",
        "lines_timeout": "no sample in time", "lines_removed": "device removed"}
MOCKS = {"unplugged": "unplugged by a fault", "communication": "a read fails by a fault", "nan": "a sample was refused",
         "warm": "refuses forces", "stale": "the pose is old"}


def faults(b, _):
    """Each fault, while force and solenoid are on, ends in safe outputs within 10 ms, is told, and tells by the exit."""
    b.calibrate()
    for name, word in ARMS.items():
        expect_safe(b.rehearse(FAULTY, "--scene", "table", "--seconds", "3.4", "--fault", f"{name}@3.15+0.2"), name, word)
    for name, word in MOCKS.items():
        expect_safe(b.run(FAULTY, "--mock", "--simulated", "--scene", "table", "--seconds", "3.4", "--fault",
                          f"{name}@3.15+0.2"), name, word)


def constant(b, _):
    """An arm that gives the same pose for ever is reported, gets no force, and is not calibrated."""
    b.calibrate()
    before = pathlib.Path(b.file).read_text()
    text = b.rehearse(FAULTY, "--scene", "table", "--seconds", "3.4", "--fault", "constant@1.5")
    assert "the arm gives a constant pose" in text and "ended with faults, outputs off" in text, text
    text = b.rehearse(FAULTY, "--calibrate", "--fault", "constant@0")
    assert "again: the arm gives a constant pose" in text and "nothing was written" in text, text
    assert pathlib.Path(b.file).read_text() == before


def clocks(b, _):
    """The clock steps back: the run ends with its outputs off. It jumps: outputs are off for a moment."""
    b.calibrate()
    for words in ([*b.arms, *b.lines, "--simulated", "--calibration", b.file], ["--mock", "--simulated"]):
        text = b.run(FAULTY, *words, "--scene", "table", "--seconds", "3.4", "--fault", "clock_back@3.15")
        expect_safe(text, "clock_back", "the clock stepped back")
        text = b.run((GOOD, FAULTY), *words, "--scene", "table", "--seconds", "3.4", "--fault", "clock_ahead@3.15")
        found = re.search(r"fault clock_ahead: safe after (\d+) ms", text)
        assert found and int(found[1]) <= 10, text


def random_faults(b, _):
    """Any fault at any moment of the scene, on one arm or two: safe within 10 ms, told, no illegal call."""
    b.calibrate()
    chance, counts = random.Random(14), {}
    for _ in range(60):
        name = chance.choice(sorted(ARMS))
        begin = chance.uniform(0.1, 4.0)
        arms = [b.arms[0], *chance.choice([[], ["Left"]]), *b.arms[1:], "--mock"]
        text = b.run(FAULTY, *arms, *b.lines, "--simulated", "--calibration", b.file, "--scene", "table", "--seconds",
                     f"{begin + 0.3:.3f}", "--fault", f"{name}@{begin:.4f}+{chance.uniform(0.03, 0.2):.3f}")
        found = re.search(rf"fault {name}: safe after (\d+) ms", text)
        assert found and int(found[1]) <= 10 and ARMS[name] in text and "illegal calls: 0" in text, text
        counts[name] = counts.get(name, 0) + 1
    print(counts)


def expect_safe(text, name, word):
    found = re.search(rf"fault {name}: safe after (\d+) ms$", text, re.MULTILINE)
    assert found and int(found[1]) <= 10, text
    assert word in text and "ended with faults, outputs off" in text, text


def refused(b, _):
    """What is not there, and what is no word, is told, and nothing runs."""
    b.calibrate()
    mock = ["--mock", "--simulated", "--seconds", "1"]
    nowhere = "/nowhere/library.so"
    for status, words, text in [
            (NOT_THERE, ["--openhaptics", "--openhaptics-library", nowhere], f"no library {nowhere}"),
            (NOT_THERE, ["--mock", "--nidaq", "--nidaq-library", nowhere], f"no library {nowhere}"),
            (NOT_THERE, ["--list", "--openhaptics", "--openhaptics-library", nowhere], f"no library {nowhere}"),
            (NOT_THERE, ["--list", "--nidaq", "--nidaq-library", nowhere], f"no library {nowhere}"),
            (NOT_THERE, [*b.arms[:1], "Left,Device9", *b.arms[1:]], "Device9"),
            (NOT_THERE, ["--mock", "--nidaq", "Dev7/ai0:Dev7/port0/line0", *b.lines[1:]], "Dev7/ai0"),
            (NOT_THERE, [*mock, "--calibration", "/nowhere/file"], "cannot be opened"),
            (NOT_THERE, ["--replay", "/nowhere/log"], "cannot be read"),
            (NOT_THERE, ["--replay", b.file], b.file),
            (NOT_THERE, ["--openhaptics", "--openhaptics-library", b.lines[2]], "has no hdInitDevice"),
            (NOT_THERE, [*mock, "--fault", "too_fast@0.5"], "too_fast"),
            (WRONG_WORD, [], "--openhaptics"),
            (WRONG_WORD, ["--mack"], "--mack"),
            (WRONG_WORD, [*mock, "--scene", "theatre"], "theatre"),
            (WRONG_WORD, [*mock, "--fault", "flood@0.5"], "no such fault")]:
        assert text in b.run(status, *words), words
    listed = b.run(GOOD, "--list", *b.arms, *b.lines)
    assert "Touch (stand-in)" in listed and "USB-6008" in listed and "scene stitch" in listed, listed


def replayed(b, log):
    """A log's hands, with the handles' real lines or without, until its end."""
    b.calibrate()
    text = b.run(GOOD, "--replay", log, "--simulated", "--scene", "table")
    seconds = float(re.search(r"scene table, ([\d.]+) s", text)[1])
    assert seconds > 5.0 and "right: log," in text, text
    b.run(GOOD, "--replay", log, *b.lines, "--calibration", b.file, "--simulated", "--scene", "table", "--seconds", "2")
    text = b.run(GOOD, *b.arms[:1], "Left", *b.arms[1:], "--replay", log, "--simulated", "--calibration", b.file, "--scene",
                 "table", "--seconds", "2")
    assert "right: log," in text and "left: Touch" in text, text


def spread(b):
    """The calibration such that a surgeon's hands, which go over 22 cm, stay in the 16 cm of an arm: a metre of the arm is two of
    the world."""
    b.calibrate()
    facts_of_all = {"scale": "2", "offset": "0 0 0.05", "workspace_low": "-0.16 -0.07 -0.07", "workspace_high": "0.16 0.07 0.17"}
    file = pathlib.Path(b.file)
    lines = [line.split() for line in file.read_text().splitlines()]
    for words in lines[1:]:
        fact = words[0].split(".")[1]
        words[1:] = [facts_of_all[fact]] if fact in facts_of_all else words[1:]
    file.write_text("".join(" ".join(words) + "\n" for words in lines))


def lead(b, log, wanted=GOOD, *words):
    """Both stand-ins' hands through what a surgeon's log told the tools, in his scene."""
    return b.rehearse(wanted, "--scene", "surgeon", "--replay", log, *words)


def expect_pulses(text):
    """What solenoids the tools want, the output stage lets through, and the lines have."""
    counts = {}
    for side in ("left", "right"):
        found = re.search(rf"^{side}: .*wanted (\d+), let through (\d+), on the line (\d+)$", text, re.MULTILINE)
        assert found and len(set(found.groups())) == 1, text
        counts[side] = int(found[1])
    return counts


def surgeon(b, program):
    """The needle taken, turned and driven through the first mark by hands of arms that are led through it, as the surgeon's did."""
    spread(b)
    log = str(b.folder / "pass.vbss")
    subprocess.run([program, "-s", "0", "-t", "4.3", "-l", log], stdout=subprocess.DEVNULL)  # 1: he has not done
    text = lead(b, log)
    assert expect_pulses(text) == {"left": 0, "right": 1}, text
    for event in ("right tool holds the needle", "hole in,", "phase: to the second mark"):
        assert event in text, text
    assert "old poses 0, refused 0" in text and "a hole beside" not in text, text


def exercise(b, program):
    """The surgeon's hands take the needle as courses ask: the exercise is passed, and counted in the file of progress. A file
    that is none is kept and told."""
    log, progress = str(b.folder / "take.vbss"), b.folder / "progress.txt"
    progress.unlink(missing_ok=True)
    subprocess.run([program, "-s", "0", "-t", "3", "-l", log], stdout=subprocess.DEVNULL)  # 1: he has not done
    words = ["--replay", log, "--simulated", "--exercise", "take_needle", "--progress", str(progress)]
    text = b.run(GOOD, *words)
    assert "exercise take_needle: PASSED" in text and "progress: 1 of 1 passed, 1 without aids" in text, text
    assert progress.read_text().splitlines()[2].startswith("take_needle 1 1 1 "), progress.read_text()
    text = b.run(GOOD, *words, "--seconds", "1")
    assert "exercise take_needle: not ended" in text and len(progress.read_text().splitlines()) == 3, text
    progress.write_text("a letter\n")
    text = b.run(FAULTY, *words)
    assert "this is no file of progress" in text and progress.read_text() == "a letter\n", text
    b.run(WRONG_WORD, "--mock", "--exercise", "dance")
    b.run(WRONG_WORD, "--mock", "--progress", str(progress))


def surgeon_ties(b, log):
    """On to the first throw: in and out of the drain with the thread, the needle from hand to hand and back, a throw tied. Hands
    that are led do not see, so it need not be the surgeon's."""
    spread(b)
    text = lead(b, log)
    assert expect_pulses(text) == {"left": 1, "right": 2}, text
    for event in ("left tool holds the needle", "the thread is in hole out", "throw 1 is tied"):
        assert event in text, text


def surgeon_faults(b, log):
    """Any fault at any moment of the task: safe within 10 ms, told, no illegal call."""
    spread(b)
    chance = random.Random(41)
    for _ in range(12):
        name, begin = chance.choice(sorted(ARMS)), chance.uniform(0.1, 12.0)
        text = lead(b, log, FAULTY, "--seconds", f"{begin + 0.3:.3f}", "--fault",
                    f"{name}@{begin:.4f}+{chance.uniform(0.03, 0.2):.3f}")
        found = re.search(rf"fault {name}: safe after (\d+) ms", text)
        assert found and int(found[1]) <= 10 and ARMS[name] in text, text


def real_time(b, _):
    """On the real clock, with the stand-ins' own threads. A machine that is busy may let poses grow old, which is a fault."""
    b.calibrate()
    text = b.run((GOOD, FAULTY), *b.arms, *b.lines, "--calibration", b.file, "--scene", "table", "--seconds", "0.5")
    assert "illegal calls: 0" in text and "wall misses:" in text, text


def interrupted(b, _):
    """Ctrl-C ends it as its end does."""
    run = subprocess.Popen([b.trainer, "--mock", "--scene", "table"], stdout=subprocess.PIPE, text=True)
    first = run.stdout.readline()
    run.send_signal(signal.SIGINT)
    rest = run.communicate(timeout=60)[0]
    assert run.returncode == GOOD and "ended well, outputs off" in rest, first + rest


def main():
    subject, trainer, arms, lines, folder, *log = sys.argv[1:]
    subjects = {f.__name__: f for f in (calibrated, pulses, task, faults, constant, clocks, random_faults, refused, replayed, real_time, interrupted,
                                        exercise, surgeon, surgeon_ties, surgeon_faults)}
    subjects[subject](Bench(trainer, arms, lines, folder), log[0] if log else None)


if __name__ == "__main__":
    main()
