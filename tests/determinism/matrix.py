"""The determinism table: the golden program built by several compilers for several machines, every
hash compared with tests/golden/<scene>.txt; and logs that one build has written, replayed by each of
them, every step's hash compared with that in the log. One table, one verdict.

    matrix.py --work FOLDER [--only NAME ...] [--program FILE] [--writer FILE] [--canary]
    matrix.py --list

--list     prints the names of all rows of BUILDS, and nothing else happens
--only     these rows of BUILDS instead of all
--program  a golden program that is already built, as one more row
--writer   a vbss_replay_log that is already built: it writes the logs that are replayed; without it none are
--canary   builds that must differ, and passes only if they do and are named

What it builds stays, for gates that look at it: gate.fma at instructions, gate.stack at gcc's call graphs.
"""
import argparse
import pathlib
import shutil
import subprocess
import sys
import time

from golden_files import differences, read_golden, unrecorded

HERE = pathlib.Path(__file__).resolve().parent
V3, V4 = "-march=x86-64-v3", "-march=x86-64-v4"  # AVX2 with FMA; AVX-512, which has its own
# name: compiler, flags, machine (a key of MACHINES). Under emulation the scenes run in their short form.
BUILDS = {f"{compiler}{level}{march[-3:]}": (compiler, f"{level} {march}".strip(), "")
          for compiler in ("gcc", "clang")
          for level, march in (("-O0", ""), ("-O2", ""), ("-O3", ""), ("-O3", V3), ("-O3", V4))}
# What a host's build may hand down; our own flags take it back.
BUILDS |= {f"{compiler}-fast-math": (compiler, "-Ofast -ffast-math " + V3, "")
           for compiler in ("gcc", "clang")}
# armv8.3-a has complex products that fuse; z14 has fused operations on vectors of doubles.
for machine, flags in (("aarch64", "-O3 -march=armv8.3-a"), ("riscv64", "-O3"), ("s390x", "-O3 -march=z14")):
    BUILDS |= {machine: (f"{machine}-linux-gnu-gcc", flags, machine),
               machine + "-clang": ("clang", flags, machine)}
# Machines of 32 bits: i686 runs here as it is, in full.
BUILDS |= {"i686": ("i686-linux-gnu-gcc", "-O3", "i686"), "i686-clang": ("clang", "-O2", "i686"),
           "armhf": ("arm-linux-gnueabihf-gcc", "-O3", "armhf"), "wasm32": ("clang", "-O3", "wasm32"),
           "wasm32-simd": ("clang", "-O3 -msimd128", "wasm32")}
# Another C library on the machine at hand.
BUILDS["musl"] = ("musl-gcc", "-O3", "musl")


class Machine:
    """How clang names a machine, and how a program is linked and run for it. Without an emulator the machine at hand
    runs it."""

    def __init__(self, target, emulator, arguments=(), system="Linux", link="-static", processor=None):
        self.target, self.emulator, self.arguments, self.system, self.link = target, emulator, arguments, system, link
        self.processor = processor

    def command(self, program, *arguments):
        if not self.emulator:
            return [program, *arguments]
        path = shutil.which(self.emulator)
        if not path:
            raise Broken(f"the emulator {self.emulator} is not installed")
        return [path, *self.arguments, program, *arguments]


MACHINES = {"": Machine("", "")}
MACHINES |= {name: Machine(f"{name}-linux-gnu", f"qemu-{name}") for name in ("aarch64", "riscv64", "s390x")}
MACHINES["i686"] = Machine("i686-linux-gnu", "")
MACHINES["musl"] = Machine("x86_64-linux-musl", "", processor="x86_64")
MACHINES["armhf"] = Machine("arm-linux-gnueabihf", "qemu-arm")
# -O0 for linking only: otherwise clang calls any wasm-opt that is installed. The stack is that of Linux.
MACHINES["wasm32"] = Machine("wasm32-wasi", "node", [HERE / "wasm_run.mjs"], "Generic", "-O0 -Wl,-z,stack-size=8388608")
# Not -ffast-math: it breaks the argument reductions, and the program crashes instead of differing.
CANARIES = {f"{compiler}-fused": (compiler, "-O1 " + V3, "-ffp-contract=fast;-mfma")
            for compiler in ("gcc", "clang")}


class Broken(Exception):
    """A build or a run that did not come about: a failure of its row."""


def run(command, **options):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, text=True,
                          stderr=subprocess.STDOUT, errors="replace", **options)
    if done.returncode != 0:
        raise Broken(f"{' '.join(map(str, command))} (exit code {done.returncode})\n" +
                     "\n".join(done.stdout.strip().splitlines()[-15:]))
    return done.stdout


TARGETS = ("vbss_golden", "vbss_replay_log", "vbss_fusible")


def build(work, name, compiler, flags, machine="", canary_flags="", targets=TARGETS):
    """The folder with what was built."""
    path = shutil.which(compiler) or shutil.which(compiler + "-14")
    if not path:
        raise Broken(f"the compiler {compiler} is not installed")
    # For compiling only: a program that is linked with -ffast-math flushes subnormal numbers.
    graphs = ["-fcallgraph-info=su"] if compiler.endswith("gcc") else []
    options = ["-DCMAKE_BUILD_TYPE=None", f"-DCMAKE_C_COMPILER={path}",
               f"-DVBSS_HOST_FLAGS={';'.join(flags.split() + graphs)}", f"-DVBSS_CANARY_FLAGS={canary_flags}"]
    if machine:
        to = MACHINES[machine]
        options += [f"-DCMAKE_SYSTEM_NAME={to.system}", f"-DCMAKE_SYSTEM_PROCESSOR={to.processor or machine}",
                    f"-DCMAKE_EXE_LINKER_FLAGS={to.link}"]
        if compiler == "clang":
            options.append(f"-DCMAKE_C_COMPILER_TARGET={to.target}")
    folder = work / name
    shutil.rmtree(folder, ignore_errors=True)
    run(["cmake", "-S", HERE / "standalone", "-B", folder, "-G", "Ninja", *options])
    run(["cmake", "--build", folder, "-j", "2", "--target", *targets])
    return folder


def golden_program(*arguments):
    return build(*arguments) / "vbss_golden"


def is_emulated(machine):
    return bool(MACHINES[machine].emulator)


def hashes_of(program, machine=""):
    """Scene -> hashes, in the order of the program's list."""
    return hashes_in(run(MACHINES[machine].command(program, *(["short"] if is_emulated(machine) else [])), timeout=600))


def hashes_in(text):
    found = {}
    for line in text.splitlines():
        scene, index, value = line.split()
        if int(index) != len(found.setdefault(scene, [])):
            raise Broken(f"{scene}: index {index} is out of order")
        found[scene].append(value)
    return found


def write_logs(writer, folder):
    """The logs, and how many steps each has."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    run([writer, "write", folder])
    logs = {log: replay(writer, log, "") for log in sorted(folder.glob("*.vbss"))}
    if not logs or any(differs for steps, differs in logs.values()):
        raise Broken("the build that wrote the logs does not replay them")
    return {log: steps for log, (steps, differs) in logs.items()}


def replay(program, log, machine):
    """Steps made, and the first whose hash is another, or 0."""
    command = MACHINES[machine].command(program, log)
    return tuple(int(word) for word in run(command, timeout=600).split()[1:])


def replay_differences(program, machine, logs):
    """One line for each log that does not replay to its end, with the step, or that is refused; how many
    steps were made."""
    complaints, made = [], 0
    for log, wanted in logs.items():
        try:
            steps, differs = replay(program, log, machine)
        except Broken as refused:
            complaints.append(f"log {log.stem} refused: {str(refused).splitlines()[-1]}")
            continue
        made += steps
        if differs or steps != wanted:
            complaints.append(f"log {log.stem} after step {differs or steps}")
    return complaints, made


def print_row(*cells):
    print("{:<15} {:<22} {:<36} {:>6} {:>6} {:>8}  {:<32} {:>6} {:>5}".format(*cells), flush=True)


def row(name, make, golden, machine="", compiler="-", flags="-", logs=None):
    """Builds, runs, compares, prints; what is wrong with this build."""
    begin = time.monotonic()
    found, ran, replayed = {}, 0.0, 0
    try:
        program = make()
        start = time.monotonic()
        found = hashes_of(program, machine)
        ran = time.monotonic() - start
        wrong = differences(found, golden, is_emulated(machine))
        if logs:
            complaints, replayed = replay_differences(program.with_name("vbss_replay_log"), machine, logs)
            wrong += complaints
    except (Broken, subprocess.TimeoutExpired) as broken:
        wrong = [f"cannot be made: {broken}"]
    first = wrong[0].splitlines()[0] if wrong else "none"
    print_row(name, compiler, flags, len(found), sum(map(len, found.values())), replayed, first[:64],
              f"{time.monotonic() - begin - ran:.1f}", f"{ran:.1f}")
    return [f"{name}: {problem}" for problem in wrong]


def canaries(work, program, golden, logs):
    """Wrong builds and a wrong golden file must be told with scene and first differing index."""
    if not golden:
        return ["there are no golden files to differ from"]
    bad = []
    for name, (compiler, flags, extra) in CANARIES.items():
        wrong = row(name, lambda: golden_program(work, name, compiler, flags, "", extra), golden, "", compiler,
                    "-O1 v3, contraction", logs)
        replayed = [problem for problem in wrong if problem.startswith(f"{name}: log ")]
        if logs and not replayed:
            bad.append(f"{name} must differ in the replay of a log, or refuse it")
        if not any(" at index " in problem for problem in wrong) or not all(
                " at index " in problem or problem in replayed for problem in wrong):
            bad.append(f"{name} must differ in the hashes, and: {wrong or 'does not'}")
    spoiled = {scene: list(values) for scene, values in golden.items()}
    scene, values = next(iter(spoiled.items()))
    values[7] = f"{int(values[7], 16) ^ 1:016x}"
    wrong = row("one bit", lambda: program or golden_program(work, "plain", "gcc", "-O3"), spoiled)
    if wrong != [f"one bit: {scene} at index 7"]:
        bad.append(f"one bit of {scene} at index 7 was changed, and: {wrong or 'nothing told'}")
    if len(unrecorded(spoiled)) != len(unrecorded(golden)) + 1:
        bad.append("hashes that the CHANGELOG does not know must be told")
    wrong = row("no compiler", lambda: golden_program(work, "none", "no-such-cc", "-O3"), golden, "", "no-such-cc")
    if wrong != ["no compiler: cannot be made: the compiler no-such-cc is not installed"]:
        bad.append(f"a build that cannot be made must fail, and: {wrong or 'passes'}")
    return bad


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--work", type=pathlib.Path)
    parser.add_argument("--only", nargs="+", choices=BUILDS, default=[])
    parser.add_argument("--program", type=pathlib.Path)
    parser.add_argument("--writer", type=pathlib.Path)
    parser.add_argument("--canary", action="store_true")
    arguments = parser.parse_args()
    if arguments.list:
        print("\n".join(BUILDS))
        return
    if arguments.work is None:
        parser.error("--work is missing")
    golden, begin = read_golden(), time.monotonic()
    names = arguments.only or ([] if arguments.program else list(BUILDS))
    print_row("build", "compiler", "flags", "scenes", "hashes", "replayed", "first difference", "make s", "run s")
    bad, logs = [], {}
    if arguments.writer:
        logs = write_logs(arguments.writer, arguments.work / ("logs-" + "-".join(arguments.only or ["all"])))
    if arguments.canary:
        bad = canaries(arguments.work, arguments.program, golden, logs)
    else:
        bad = unrecorded(golden)
        if arguments.program:
            bad += row("this build", lambda: arguments.program, golden)
        for name in names:
            compiler, flags, machine = BUILDS[name]
            bad += row(name, lambda: golden_program(arguments.work, name, compiler, flags, machine), golden,
                       machine, compiler, flags, logs)
    for problem in bad:
        print("  " + problem)
    what = "canaries" if arguments.canary else "determinism"
    result = f"FAIL, {len(bad)} complaint(s)" if bad else "pass"
    print(f"{what}: {result} ({len(golden)} scenes, {time.monotonic() - begin:.0f} s)")
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
