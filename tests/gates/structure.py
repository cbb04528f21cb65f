"""Figures of the structure and the language of lib/, with limits for those that are kept already.

    structure.py TREE BUILD [options]     prints the figures of a tree and its build folder
    structure.py gates.json [--canary]    the gate: only the limits

Options: --sections a,b   only these (terms, retired, cycles, calls, fields, baseline, constants, odd, rebuilds)
         --json FILE      saves the figures; --name TEXT names them
         --against FILE   prints two columns: the figures saved in FILE, and these
         --gate           exit code 1 and a line for each finding where a limit is exceeded
         --wanted         with --gate: the wanted limits, not the ones that hold now
         --show FOLDER    odd patterns in comments of that folder of lib/, with file and line; `.` for all folders

Sections of text need no build. Sections cycles, calls and rebuilds read the objects of a build with nm and their dependencies
with ninja, and are left out without one. Nothing is built. How each figure is counted stands in structure_text.py, structure_code.py and structure_objects.py."""
import argparse
import json
import pathlib
import shutil
import signal
import sys
from typing import NamedTuple

import c_text
import figures
import gate
import layers
import structure_code
import structure_objects
import structure_text

GLOSSARY = "docs/reference/glossary.md"


class Limit(NamedTuple):
    section: str
    now: float  # the largest value that the gate lets pass; None: no limit yet
    wanted: float


LIMITS = {
    "upward calls between folders": Limit("calls", 0, 0),
    "upward calls between sub-folders": Limit("calls", 0, 0),
    "cycles": Limit("cycles", 0, 0),                               # of more than 3 files
    "rare terms": Limit("terms", 0, 0),                            # found fewer than 5 times
    "retired words": Limit("retired", 0, 0),
    "lines that know the baseline": Limit("baseline", 0, 0),
    "constants without origin": Limit("constants", 0, 0),
    "names with several values": Limit("constants", 0, 0),
    "odd patterns per 1000 words": Limit("odd", 2, 2),
}


class Subject(NamedTuple):
    """What is looked at."""
    tree: pathlib.Path
    build: pathlib.Path = None
    glossary: str = ""
    nm: str = "nm"


SECTIONS = {
    "terms": lambda s: structure_text.terms(s.tree),
    "retired": lambda s: structure_text.retired(s.tree, s.glossary),
    "cycles": lambda s: structure_objects.cycles(s.tree, s.build, s.nm),
    "calls": lambda s: structure_objects.direction(s.tree, s.build, s.nm),
    "fields": lambda s: structure_code.fields(s.tree),
    "baseline": lambda s: structure_text.baseline(s.tree),
    "constants": lambda s: structure_code.constants_section(s.tree),
    "odd": lambda s: structure_text.odd(s.tree),
    "rebuilds": lambda s: structure_objects.rebuilds(s.tree, s.build),
}
OF_OBJECTS = ("cycles", "calls", "rebuilds")


def kept_limits(wanted):
    limits = {what: limit.wanted if wanted else limit.now for what, limit in LIMITS.items()}
    return {what: limit for what, limit in limits.items() if limit is not None}


def complaints(subject, limits):
    """A line for each finding of a measure that exceeds its limit."""
    found = []
    for name in dict.fromkeys(LIMITS[what].section for what in limits):
        found += figures.complaints(SECTIONS[name](subject), limits)
    return found


# ---- the command

def options(arguments):
    parser = argparse.ArgumentParser(description="Figures of the structure of lib/.")
    parser.add_argument("tree", type=pathlib.Path)
    parser.add_argument("build", type=pathlib.Path, nargs="?")
    parser.add_argument("--sections", default=",".join(SECTIONS))
    for name in ("--json", "--against"):
        parser.add_argument(name, type=pathlib.Path)
    parser.add_argument("--name", default="today")
    parser.add_argument("--gate", action="store_true")
    parser.add_argument("--wanted", action="store_true")
    parser.add_argument("--show", metavar="FOLDER")
    return parser.parse_args(arguments)


def chosen_sections(chosen, subject):
    names = chosen.sections.split(",")
    unknown = [name for name in names if name not in SECTIONS]
    if unknown:
        sys.exit(f"no section {', '.join(unknown)}; there are {', '.join(SECTIONS)}")
    if not subject.build and chosen.gate and set(names) & set(OF_OBJECTS):
        sys.exit(f"the limits of {', '.join(OF_OBJECTS)} need a build folder")
    return [SECTIONS[name](subject) for name in names if subject.build or name not in OF_OBJECTS]


def print_sections(sections, chosen):
    before = json.loads(chosen.against.read_text()) if chosen.against else None
    for section in sections:
        lines = (figures.comparison(section, before, [before["name"], chosen.name]) if before
                 else figures.lines_of(section))
        print("\n".join(lines) + "\n")


def show_odd(tree, folder):
    for oddity in structure_text.oddities(tree):
        if folder == "." or (oddity.folder + "/").startswith(folder.removeprefix("lib/").strip("/") + "/"):
            print(f"{oddity.where}: {oddity.pattern}: {oddity.text}")


def command(chosen, glossary):
    subject = Subject(chosen.tree, chosen.build, glossary)
    if chosen.show:
        show_odd(chosen.tree, chosen.show)
        return 0
    sections = chosen_sections(chosen, subject)
    if chosen.json:
        chosen.json.write_text(figures.saved(chosen.name, sections))
    if chosen.gate:
        limits = kept_limits(chosen.wanted)
        found = [line for section in sections for line in figures.complaints(section, limits)]
        print("\n".join(found + [f"structure: {'FAIL' if found else 'pass'}"]))
        return 1 if found else 0
    print_sections(sections, chosen)
    return 0


# ---- the gate

def subject_of(g, tree, build):
    return Subject(tree, build, (g.source / GLOSSARY).read_text(), g.tool("nm"))


def inspect(g):
    build = g.library("archive").parent.parent
    missing = structure_objects.without_object(g.source, build)
    return ([f"{file} has no object in the build folder, so its calls are not seen" for file in missing] +
            complaints(subject_of(g, g.source, build), kept_limits(False)))


# ---- canaries: a small tree with objects, under the wanted limits

CLEAN = "/* Adds one; chosen because the next number is wanted. */\n"


def call(name, target=None):
    """A function that calls another one."""
    declared = f"int {target}(int n);\n" if target else ""
    return f"{declared}int {name}(int n);\nint {name}(int n)\n{{\n    return {target or ''}(n);\n}}\n"


def place_of(root, name):
    """A name begins with a folder of the tree; without one the file is below lib/."""
    return root / name if name.split("/")[0] in structure_text.COLUMNS else root / "lib" / name


def tree_of(g, files):
    """A tree with these files, and the objects of those below lib/ where a build leaves them."""
    root = g.work / "tree"
    shutil.rmtree(root, ignore_errors=True)
    (root / "include/vblast_ss").mkdir(parents=True)
    for folder in structure_text.COLUMNS:
        (root / folder).mkdir()
    for number, (name, text) in enumerate(files.items()):
        path = place_of(root, name)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        made = root / "build/lib/CMakeFiles/canary.dir" / (name + ".o")
        made.parent.mkdir(parents=True, exist_ok=True)
        if path.suffix == ".c":
            g.compile(f"canary{number}", text).rename(made)
    c_text.read.cache_clear()
    return root


def with_files(what, files, subfolders=()):
    """Complaints about one measure of a tree, with the sub-folders of lib/scene in that order."""
    def canary(g):
        root = tree_of(g, files)
        order, layers.SUBFOLDERS = layers.SUBFOLDERS, {"scene": list(subfolders)}
        try:
            return complaints(subject_of(g, root, root / "build"), {what: LIMITS[what].wanted})
        finally:
            layers.SUBFOLDERS = order
    return canary


RING = {f"scene/f{i}.c": call(f"f{i}", f"f{(i + 1) % 4}") for i in range(4)}
TRIANGLE = {f"scene/f{i}.c": call(f"f{i}", f"f{(i + 1) % 3}") for i in range(3)}
TWO_FOLDERS = {"scene/world/low.c": call("low", "high"), "scene/api/high.c": call("high")}
CANARIES = [
    ("a retired word in an identifier",
     with_files("retired words", {"scene/a.c": "int scene_verdict(void);\n"}),
     r"scene/a.c: scene_verdict has 'verdict'; use |retired words: 1, "),
    ("a retired word in the name of a file", with_files("retired words", {"scene/recall.c": CLEAN}),
     r"scene/recall.c: the file name has 'recall'; use |retired words: 1, "),
    ("a retired word with an ending", with_files("retired words", {"scene/a.c": "extern int settling_steps;\n"}),
     r"settling_steps has 'settling'|retired words: 1, "),
    ("words that only contain a retired one",
     with_files("retired words", {"scene/layer.c": "extern int always_relay, newsletter; /* way */\n"}), None),
    ("a retired word in a test", with_files("retired words", {"tests/a.h": "int look_at(void);\n"}),
     r"tests/a.h: look_at has 'look'; use |retired words: 1, "),
    ("a retired word in the name of a test's file", with_files("retired words", {"tests/stand.h": CLEAN}),
     r"tests/stand.h: the file name has 'stand'; use |retired words: 1, "),
    ("a retired word in a bench in Python", with_files("retired words", {"bench/a.py": "told = [1]\n"}),
     r"bench/a.py: told has 'told'; use |retired words: 1, "),
    ("a retired word in an example", with_files("retired words", {"examples/a.h": "extern int way;\n"}),
     r"examples/a.h: way has 'way'; use |retired words: 1, "),
    ("a stand-in, and a retired word in a string of Python",
     with_files("retired words", {"tests/stand_ins.h": "extern int stand_in_hand;\n",
                                  "tests/a.py": "STAND_INS = 'way'  # look\n"}), None),
    ("a cycle of four files", with_files("cycles", RING), r"4 files call each other in a cycle|cycles: 1, "),
    ("a cycle of three files", with_files("cycles", TRIANGLE), None),
    ("a call to a folder above",
     with_files("upward calls between folders", {"base/a.c": call("a", "b"), "scene/b.c": call("b")}),
     r"base/a.c calls scene/b.c \(b\)|folders: 1, "),
    ("a call to a folder below",
     with_files("upward calls between folders", {"base/a.c": call("a"), "scene/b.c": call("b", "a")}), None),
    ("a table of a method, where it is chosen",
     with_files("upward calls between folders", {"drain/drain.c": call("a", "vbss_baseline_drain"),
                                                 "baseline/b.c": call("vbss_baseline_drain")}), None),
    ("a table of a method in another file",
     with_files("upward calls between folders", {"drain/step.c": call("a", "vbss_baseline_drain"),
                                                 "baseline/b.c": call("vbss_baseline_drain")}),
     r"drain/step.c calls baseline/b.c \(vbss_baseline_drain\)|folders: 1, "),
    ("a call to a later sub-folder", with_files("upward calls between sub-folders", TWO_FOLDERS, ["world", "api"]),
     r"scene/world/low.c calls scene/api/high.c \(high\)|sub-folders: 1, "),
    ("a call to an earlier sub-folder", with_files("upward calls between sub-folders", TWO_FOLDERS, ["api", "world"]), None),
    ("a line that knows the baseline",
     with_files("lines that know the baseline", {"scene/a.c": "extern int paper_hits;\n"}),
     r"scene/a.c:1: extern int paper_hits|baseline: 1, "),
    ("the baseline's own file",
     with_files("lines that know the baseline", {"baseline/a.c": "extern int paper_hits;\n"}), None),
    ("a number without an origin", with_files("constants without origin", {"scene/a.c": "#define SHARE 0.3\n"}),
     r"scene/a.c:1: SHARE 0.3|origin: 1, "),
    ("a tuned number without an origin",
     with_files("constants without origin", {"scene/tuning.h": "#define SHARE VBSS_TUNE(SHARE, 0.3)\n"}),
     r"scene/tuning.h:1: SHARE 0.3|origin: 1, "),
    ("numbers below a comment with their origin",
     with_files("constants without origin", {"scene/a.c": CLEAN + "#define SHARE 0.3\n#define STEPS 12\n"}), None),
    ("a name with two values",
     with_files("names with several values",
                {"scene/a.c": CLEAN + "#define SHARE 0.3\n", "scene/b.c": CLEAN + "enum { SHARE = 3 };\n"}),
     r"SHARE: lib/scene/a.c 0.3, lib/scene/b.c 3|values: 1, "),
    ("a sentence without its subject",
     with_files("odd patterns per 1000 words", {"scene/a.c": "/* Of a thread only: the same of what is held. */\n"}),
     r"scene/a.c:1: |words: "),
    ("a plain sentence",
     with_files("odd patterns per 1000 words", {"scene/a.c": "/* Returns the force on the held node. */\n"}), None),
    ("no standard term", with_files("rare terms", {"scene/a.c": CLEAN}),
     r"is found 0 times in lib/, wanted are 5|rare terms: "),
]

if __name__ == "__main__":
    if len(sys.argv) > 1 and sys.argv[1].endswith(".json"):
        gate.main("structure", inspect, CANARIES)
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # readers may end early
    home = pathlib.Path(__file__).resolve().parents[2]
    try:
        sys.exit(command(options(sys.argv[1:]), (home / GLOSSARY).read_text()))
    except OSError as problem:
        sys.exit(f"structure: {problem}")
