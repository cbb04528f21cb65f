"""The same performance everywhere: seeds of the scripted surgeon (C) and of the scripted throw (Python), hashed on this
processor, on it with features masked (tests/masked.sh), and built for another machine and emulated.

    performances.py --work FOLDER --program vbss_performance --library libvblast_ss.so [--python FILE]
                    [--seeds N] [--hashes N] [--emulated N] [--machine NAME] [--root FOLDER]

--seeds     seeds 0 to N - 1
--hashes    hashes of a native performance: one after each second, and one at its end; 600 is always the whole
--emulated  hashes of one on the other machine, which are the first of these; 0: none
--machine   a row of matrix.py's table for another machine. i686 and wasm32-simd take minutes for a whole performance,
            those that QEMU emulates take an hour
--python    an interpreter with numpy; default: this one or, if it has none, the system's
--root      the root of a system of the other machine with Python and numpy, which make-root.sh makes: throws are emulated
            too, each as a whole

Prints a table; fails if a hash differs, or if the masking hides nothing although the processor has something to hide.
"""
import argparse
import hashlib
import os
import pathlib
import subprocess
import sys
import time

from matrix import BUILDS, MACHINES, Broken, build, run

HERE = pathlib.Path(__file__).resolve().parent
MASKED = HERE.parent / "masked.sh"
BINDING = HERE.parent.parent / "bindings/python"
THROW = """
import sys
from vblast_ss.environment import ScriptedThrow, ThrowEnvironment
with ThrowEnvironment() as environment:
    policy, over = ScriptedThrow(), False
    seen, _ = environment.reset(seed=int(sys.argv[1]))
    while not over:
        seen, _, terminated, truncated, _ = environment.step(policy(seen))
        over = terminated or truncated
        print(f"{environment.scene.scene.state_hash:016x}")
"""
# libm's and numpy's sines, which are not ours: where masking hides something, some of them differ.
SINES = """
import math, numpy
angles = [1e-3 * i for i in range(20000)]
print([math.sin(angle).hex() for angle in angles], numpy.sin(numpy.array(angles)).tobytes().hex())
"""


def with_numpy():
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", "import numpy"], stderr=subprocess.DEVNULL).returncode == 0:
            return python
    sys.exit("performances: FAIL, numpy is not installed")


def surgeon(program, seed, limit, before=()):
    return [line.split()[1] for line in run([*before, program, seed, limit]).splitlines()]


def throw(arguments, seed, before=()):
    return run([*before, arguments.python, "-B", "-c", THROW, seed], env=python_environment(arguments)).split()


def emulated_throw(arguments, library, seed):
    # Debian keeps BLAS and LAPACK in folders of their own.
    libraries = [str(path.parent) for name in ("libblas", "liblapack") for path in arguments.root.rglob(name + ".so.3")]
    variables = {"PYTHONPATH": f"{BINDING}:{arguments.root / 'usr/lib/python3/dist-packages'}",
                 "LD_LIBRARY_PATH": ":".join(libraries), "VBLAST_SS_LIBRARY": library}
    settings = [word for name, value in variables.items() for word in ("-E", f"{name}={value}")]
    emulator = MACHINES[BUILDS[arguments.machine][2]].emulator
    return run([emulator, "-L", arguments.root, *settings, arguments.root / "usr/bin/python3", "-B", "-c", THROW, seed]).split()


def python_environment(arguments):
    return {**os.environ, "PYTHONPATH": str(BINDING), "VBLAST_SS_LIBRARY": str(arguments.library)}


def digest(hashes):
    return hashlib.sha256("\n".join(hashes).encode()).hexdigest()[:12]


def first_difference(found, wanted):
    """The index of the first of `found` that is not as wanted, or None."""
    if not found or len(found) > len(wanted):
        return min(len(found), len(wanted))
    return next((i for i, pair in enumerate(zip(found, wanted)) if pair[0] != pair[1]), None)


def print_row(*cells):
    print("{:<8} {:>4}  {:<22} {:>6}  {:<12} {:<24} {:>6}".format(*cells), flush=True)


def compare(who, seed, how, make, wanted):
    """Makes a performance, prints its row; its hashes, and one complaint if they are not the wanted ones."""
    start = time.monotonic()
    try:
        found = make()
    except (Broken, OSError) as broken:
        print_row(who, seed, how, 0, "-", "cannot be made", "-")
        return [], [f"{who} {seed}, {how}: {broken}"]
    wanted = found if wanted is None else wanted
    differs = first_difference(found, wanted)
    same = f"the first {len(found)} of these" if len(found) < len(wanted) else "the same"
    result = "-" if wanted is found else same if differs is None else f"differs at index {differs}"
    print_row(who, seed, how, len(found), digest(found), result, f"{time.monotonic() - start:.1f}")
    return found, [] if differs is None else [f"{who} {seed}, {how}: differs at index {differs}"]


def masks_something(arguments):
    """What the masking shows of libm and numpy; and a complaint if it hides nothing on a processor that has AVX2."""
    plain, masked = (run([*before, arguments.python, "-c", SINES]) for before in ([], [MASKED]))
    has_avx2 = "avx2" in pathlib.Path("/proc/cpuinfo").read_text()
    unchanged = "it does not work" if has_avx2 else "this processor has nothing to mask"
    print("The masking changes sines of libm and numpy." if plain != masked
          else f"The masking changes no sine: {unchanged}.")
    return ["the masking hides nothing"] if plain == masked and has_avx2 else []


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--work", required=True, type=pathlib.Path)
    parser.add_argument("--program", required=True, type=pathlib.Path)
    parser.add_argument("--library", required=True, type=pathlib.Path)
    parser.add_argument("--python")
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--hashes", type=int, default=600)
    parser.add_argument("--emulated", type=int, default=3)
    parser.add_argument("--root", type=pathlib.Path)
    parser.add_argument("--machine", default="aarch64", choices=[name for name, row in BUILDS.items() if row[2]])
    arguments = parser.parse_args()
    arguments.python = arguments.python or with_numpy()
    bad = masks_something(arguments)
    compiler, flags, machine = BUILDS[arguments.machine]
    if arguments.emulated or arguments.root:
        folder = build(arguments.work, arguments.machine, compiler, flags, machine,
                       targets=["vbss_performance"] + ["vblast_ss_shared"] * (arguments.root is not None))
    how = f"emulated {arguments.machine}" if MACHINES[machine].emulator else arguments.machine
    print_row("who", "seed", "how", "hashes", "digest", "verdict", "s")
    for seed in range(arguments.seeds):
        plain, wrong = compare("surgeon", seed, "native",
                               lambda: surgeon(arguments.program, seed, arguments.hashes), None)
        bad += wrong
        bad += compare("surgeon", seed, "native, masked",
                       lambda: surgeon(arguments.program, seed, arguments.hashes, [MASKED]), plain)[1]
        if arguments.emulated:
            program = MACHINES[machine].command(folder / "vbss_performance")
            bad += compare("surgeon", seed, how,
                           lambda: surgeon(program[-1], seed, arguments.emulated, program[:-1]), plain)[1]
    for seed in range(arguments.seeds):
        plain, wrong = compare("throw", seed, "native", lambda: throw(arguments, seed), None)
        bad += wrong
        bad += compare("throw", seed, "native, masked", lambda: throw(arguments, seed, [MASKED]), plain)[1]
        if arguments.root:
            bad += compare("throw", seed, how,
                           lambda: emulated_throw(arguments, folder / "vblast_ss/lib/libvblast_ss.so", seed), plain)[1]
    for problem in bad:
        print("  " + problem)
    print(f"performances: {'FAIL, ' + str(len(bad)) + ' complaint(s)' if bad else 'pass'}")
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
