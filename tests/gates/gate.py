"""What the gates share: settings, commands, builds, and one verdict.

A gate is a script with one subject. It finds complaints; no complaint is a pass. Its canaries feed
the same check something that must be refused, and pass only when every complaint is the expected
one: a gate that fails for another reason would hide that it no longer sees what it is for.

    python3 <gate>.py <gates.json> [--canary]

gates.json is written by tests/gates/CMakeLists.txt: folders, the libraries of this build, tools.
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys

# No compiler cache: it leaves out call graphs, and would hand one folder's object to another folder's build.
LIBRARY_ONLY = ["-DVBSS_BUILD_TESTS=OFF", "-DVBSS_BUILD_EXAMPLES=OFF", "-DVBSS_BUILD_BENCH=OFF",
                "-DCMAKE_C_COMPILER_LAUNCHER="]


class Problem(Exception):
    """The gate could not look: a missing tool, a command that failed. Counts as a complaint."""


class Gate:
    def __init__(self, name, settings_file, canary):
        self.settings = json.loads(pathlib.Path(settings_file).read_text())
        self.source = pathlib.Path(self.settings["source"])
        self.include = self.source / "include"
        self.here = self.source / "tests/gates"
        self.notes = []  # told in the verdict line
        # A folder for each case: CTest may run the gate and its canary at the same time.
        self.work = pathlib.Path(self.settings["work"]) / (name + (".canary" if canary else ""))
        shutil.rmtree(self.work, ignore_errors=True)
        self.work.mkdir(parents=True)

    def tool(self, name):
        path = self.settings["tools"].get(name, "")
        if not path or path.endswith("-NOTFOUND"):
            raise Problem(f"the tool {name} is not installed, so this gate cannot look")
        return path

    def library(self, kind):
        return pathlib.Path(self.settings[kind])

    def row(self, name):
        """The build that the test determinism.matrix.<name> leaves behind."""
        folder = pathlib.Path(self.settings["matrix"]) / name
        if not folder.is_dir():
            raise Problem(f"determinism.matrix.{name} has not been run, so there is no build to look at")
        return folder

    def run(self, *command, code=0, **options):
        """The output of a command that must end with the given code (None: any, then a pair)."""
        command = [str(word) for word in command]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              errors="replace", **options)
        if code is None:
            return done.returncode, done.stdout
        if done.returncode != code:
            tail = "\n    ".join(done.stdout.strip().splitlines()[-12:])
            raise Problem(f"exit code {done.returncode} of: {' '.join(command)}\n    {tail}")
        return done.stdout

    def build(self, folder, *options, source=None, targets=("vblast_ss_shared", "vblast_ss_static")):
        """Configures and builds the library alone; returns its build folder."""
        build = self.work / folder
        # From nothing: a changed copy may be older than the objects of the one before it.
        shutil.rmtree(build, ignore_errors=True)
        self.run(self.tool("cmake"), "-S", source or self.source, "-B", build, "-G", "Ninja",
                 *LIBRARY_ONLY, *options)
        self.run(self.tool("cmake"), "--build", build, "-j", "2", "--target", *targets)
        return build

    def compile(self, name, text, *options, compiler="cc"):
        """An object (or, with -shared, a library) from a few lines of C."""
        source = self.work / (name + ".c")
        source.write_text(text)
        out = self.work / (name + (".so" if "-shared" in options else ".o"))
        stop = () if "-shared" in options else ("-c",)
        self.run(self.tool(compiler), *stop, "-fPIC", source, "-o", out, *options)
        return out

    def copy_source(self, folder):
        """A copy of what the library is built from, for canaries that change it."""
        copy = self.work / folder
        shutil.rmtree(copy, ignore_errors=True)
        copy.mkdir()
        for part in ("include", "lib", "pkgconfig"):
            shutil.copytree(self.source / part, copy / part)
        shutil.copy(self.source / "CMakeLists.txt", copy)
        return copy

    def copy_base(self, folder):
        """A copy of the lowest layer alone, which is a library too: canaries that change it are built in no time."""
        copy = self.copy_source(folder)
        for layer in (copy / "lib").iterdir():
            if layer.is_dir() and layer.name != "base":
                shutil.rmtree(layer)
        rules = copy / "lib/CMakeLists.txt"
        listed = re.search(r"set\(sources\n(.*?)\)", rules.read_text(), re.S).group(1)
        replace_once(rules, listed, "\n".join(line for line in listed.splitlines() if line.startswith("  base/")))
        replace_once(rules, "check_c_compiler_flag(-mavx2 VBSS_HAS_mavx2)", "")  # wide sources stand higher
        return copy


def replace_once(path, old, new):
    """Changes a file for a canary; the text must be there, or the canary would test nothing."""
    path = pathlib.Path(path)
    text = path.read_text()
    if text.count(old) != 1:
        raise Problem(f"the canary is stale: {old!r} stands {text.count(old)} times in {path.name}")
    path.write_text(text.replace(old, new))


def complaints_of(inspect, gate):
    try:
        return inspect(gate)
    except (Problem, OSError) as problem:
        return [str(problem)]


def run_canaries(gate, canaries):
    """Each canary: what it is, a function that gives complaints, a pattern all of them must match
    (None: a change that must be accepted)."""
    bad = []
    for what, inspect, pattern in canaries:
        complaints = complaints_of(inspect, gate)
        if pattern is None:
            wrong = complaints
        else:
            wrong = [c for c in complaints if not re.search(pattern, c)]
        if wrong:
            bad.append(f"{what}: another complaint than expected: " + "; ".join(wrong))
        elif pattern is not None and not complaints:
            bad.append(f"{what}: was NOT refused")
        else:
            print(f"  {what}: {'refused: ' + complaints[0] if complaints else 'accepted, as it must'}")
    gate.notes = [f"{len(canaries)} canaries"]
    return bad


def main(name, inspect, canaries):
    """look(gate) gives complaints. The command line may name a part of the subject, which look finds in gate.part."""
    canary = "--canary" in sys.argv[2:]
    part = next((word for word in sys.argv[2:] if not word.startswith("--")), None)
    full_name = name + (f".{part}" if part else "") + (".canary" if canary else "")
    gate = Gate(name + (f".{part}" if part else ""), sys.argv[1], canary)
    gate.part = part
    complaints = run_canaries(gate, canaries) if canary else complaints_of(inspect, gate)
    for complaint in complaints:
        print("  " + complaint)
    result = f"FAIL, {len(complaints)} complaint(s)" if complaints else "pass"
    print(f"gate {full_name}: {result}" + (f" ({', '.join(gate.notes)})" if gate.notes else ""))
    sys.exit(1 if complaints else 0)
