"""Programs in a locale with a decimal comma: check_locale.py quick|galleries FOLDER PRELOAD KEY=PROGRAM ...

localedef makes the locale from a text of three lines and a character map of ASCII, so no package is needed. A preloaded
library sets the locale before `main`. A program prints and writes the same bytes as without it, but for measured times, and
reads the same values. Besides, each `main` of examples/ and bench/ must set the decimal point."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCE = """comment_char %
escape_char /
LC_NUMERIC
decimal_point ","
thousands_sep "."
grouping 3;3
END LC_NUMERIC
"""
# A minimal Debian has no character maps.
CHARACTER_MAP = """<code_set_name> ANSI_X3.4-1968
<comment_char> %
<escape_char> /
<mb_cur_min> 1
<mb_cur_max> 1
CHARMAP
{}END CHARMAP
""".format("".join(f"<U{code:04X}> /x{code:02x}\n" for code in range(128)))
POINT = re.compile(r"use_decimal_point\(\);|setlocale\(LC_NUMERIC, \"C\"\)|bench_main\(")


def make_locale(folder):
    tool = shutil.which("localedef")
    if tool is None:
        print("localedef is not there")
        sys.exit(0)
    (folder / "source").write_text(SOURCE)
    (folder / "characters").write_text(CHARACTER_MAP)
    # categories that the source leaves out give warnings and an exit of 1
    subprocess.run([tool, "-c", "-f", str(folder / "characters"), "-i", str(folder / "source"), str(folder / "comma")],
                   capture_output=True)
    assert (folder / "comma" / "LC_NUMERIC").exists(), "localedef has made no locale"


class Bench:
    def __init__(self, folder, preload, programs):
        self.folder, self.programs = folder, programs
        self.comma = {**os.environ, "LOCPATH": str(folder), "LD_PRELOAD": preload, "ASAN_OPTIONS": "verify_asan_link_order=0"}

    def run(self, kind, key, words):
        """In a folder of its own; `{}` is its name."""
        place = self.folder / f"{key}.{kind}"
        place.mkdir(exist_ok=True)
        done = subprocess.run([self.programs[key], *(str(word) for word in words)], cwd=place, capture_output=True, text=True,
                              env=self.comma if kind == "comma" else None, stdin=subprocess.DEVNULL)
        files = {p.relative_to(place): p.read_bytes() for p in sorted(place.rglob("*")) if p.is_file()}
        return done.returncode, done.stdout + done.stderr, files

    def compare(self, key, words, measured=False):
        """Both runs end alike and write the same."""
        plain, comma = self.run("plain", key, words), self.run("comma", key, words)
        assert plain[0] == comma[0], f"{key}: ends with {comma[0]}, not {plain[0]}\n{comma[1]}"
        assert shape(plain[1], measured) == shape(comma[1], measured), f"{key} prints\n{comma[1]}\nnot\n{plain[1]}"
        assert plain[2].keys() == comma[2].keys(), f"{key}: {comma[2].keys()}"
        for name, data in plain[2].items():
            other = comma[2][name]
            if data != other and measured:
                data, other = (shape(x.decode("utf-8", "replace"), True) for x in (data, other))
            assert data == other, f"{key}: {name} differs"
        return comma


def shape(text, measured):
    """Where times are measured, the text without its numbers: "0.5" becomes "0", and "0,5" becomes "0,0". Lines that are equal
    then follow each other as often as the machine is slow, and count once."""
    if not measured:
        return text
    lines = re.sub(r"\d+(\.\d+)?(e[-+]\d+)?", "0", text).splitlines()
    lines = [" ".join(line.split()) for line in lines]
    return "\n".join(line for i, line in enumerate(lines) if i == 0 or line != lines[i - 1])


def check_preload(b):
    """The library is preloaded and the locale is in force; the library's own texts have points all the same."""
    _, text, _ = b.run("comma", "library_texts", [])
    lines = text.splitlines()
    assert lines[0] == "0,5", f"the locale is not in force: {text}"
    assert "radius is -0.0625, outside" in lines[1] and "time is 1.75, after 2.5" in lines[2], text


def check_sources():
    for folder in ("examples", "bench"):
        for path in [*(ROOT / folder).rglob("*.c"), *(ROOT / folder).rglob("*.cpp")]:
            text = path.read_text()
            main = re.search(r"^int main\(.*?^}", text, re.MULTILINE | re.DOTALL)
            assert main is None or POINT.search(main[0]), f"{path}: main does not set the decimal point"


def check_log_tools(b, log):
    """Valid JSON, a table without commas in its numbers, the same report and page."""
    for word in ("info", "validate", "csv", "json"):
        status, text, _ = b.compare("vbss_log", [word, log])
        assert status == 0 and len(text) > 20, text
        if word == "json":
            json.loads(text)
    b.compare("vbss_report", [log, "-o", "report.html"], measured=True)
    if "vbss_replay_page" in b.programs:
        b.compare("vbss_replay_page", [log, "-o", "page.html", "--rate", "2.5"])


def check_trainer(b):
    """Options, the calibration file, which one locale writes and the other reads, and the report."""
    hardware = ["--openhaptics", "--openhaptics-library", b.programs["arms"], "--nidaq", "--nidaq-library",
                b.programs["lines"], "--simulated", "--calibration", "desk.txt"]
    b.compare("trainer", [*hardware, "--calibrate"])
    (b.folder / "trainer.plain/desk.txt").rename(b.folder / "swap.txt")
    (b.folder / "trainer.comma/desk.txt").rename(b.folder / "trainer.plain/desk.txt")
    (b.folder / "swap.txt").rename(b.folder / "trainer.comma/desk.txt")
    status, text, _ = b.compare("trainer", [*hardware, "--scene", "table", "--seconds", "1.25", "--fault", "nan@1.125+0.0625"],
                                measured=True)
    assert status == 1 and "1.250 s" in text and "1.125 s" in text, text


def check_bench(b):
    """The harness that all suites share: a table, and a file of results with the counter 0.5."""
    status, text, files = b.run("comma", "tiny_suite", ["--quick", "--out", "out.json"])
    assert status == 0 and not re.search(r"\d,\d+\b", text), text
    data = next(iter(files.values())).decode()
    json.loads(data)
    assert re.search(r'"half": 0\.5\b', data), data


def quick(b):
    check_sources()
    check_preload(b)
    for key in ("embed_c", "embed_cpp", "host_c", "host_cpp"):
        if key in b.programs:
            b.compare(key, [], measured=True)
    b.compare("surgeon", ["-s", "0", "-t", "0.125"], measured=True)
    b.compare("throw", ["single", "-t", "0.25"], measured=True)
    b.compare("pass_needle", ["-s", "1", "-t", "0.25", "-l", "short.vbss"], measured=True)
    check_log_tools(b, b.folder / "pass_needle.plain/short.vbss")
    check_trainer(b)
    check_bench(b)


def galleries(b):
    """Pictures, tables and pages."""
    for key in ("knot_gallery", "drain_gallery", "puncture_gallery", "stitch_gallery"):
        b.compare(key, ["."], measured=True)
    b.compare("first_throw", ["-o", ".", "single"], measured=True)
    _, text, _ = b.run("comma", "demo", [".", "-u", "pass"])  # its bar says what is left, so the lines differ
    assert re.search(r"\d\.\d+ s, simulated", text) and not re.search(r"\d,\d", text), text


def main():
    subject, folder, preload = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
    programs = dict(word.split("=", 1) for word in sys.argv[4:])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    make_locale(folder)
    {"quick": quick, "galleries": galleries}[subject](Bench(folder, preload, programs))


if __name__ == "__main__":
    main()
