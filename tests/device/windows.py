"""Devices on Windows, as far as another system can tell.

    windows.py SOURCE              the adapters of real hardware compile
    windows.py SOURCE soak [SEEDS] the library, the stand-ins and the tests of devices are built by MinGW and run by wine,
                                   then so many seeds of random faults

Says so where compiler or wine are not there."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

COMPILER = "x86_64-w64-mingw32-gcc"
# -Wconversion finds things in the system's own isfinite.
FLAGS = ["-std=c11", "-O2", "-Wall", "-Wextra", "-Wshadow", "-Wvla", "-Wstrict-prototypes", "-Wmissing-prototypes",
         "-Wundef", "-Werror", "-ffp-contract=off"]


def need(tool, package, without):
    if shutil.which(tool) is None:
        print(f"{tool} is not there: nothing is {without}. On Debian: apt-get install {package}")
        sys.exit(0)


def compile_adapters(source):
    failed, files = 0, sorted((source / "lib/device").glob("*.c"))
    with tempfile.TemporaryDirectory() as work:
        for file in files:
            done = subprocess.run([COMPILER, *FLAGS, "-I", source / "include", "-I", source / "lib", "-c", file, "-o",
                                   pathlib.Path(work) / "object"])
            failed += done.returncode != 0
    print(f"{len(files) - failed} of {len(files)} files compile")
    return failed == 0 and len(files) > 0


def quietly(*command, **options):
    """True if it went well; otherwise what it said is printed."""
    with tempfile.TemporaryFile("w+") as said:  # a pipe would be kept open by what goes on in the background
        done = subprocess.run(command, stdout=said, stderr=subprocess.STDOUT, **options)
        if done.returncode != 0:
            said.seek(0)
            print(f"{said.read()}\n{' '.join(command)} failed")
    return done.returncode == 0


def soak(source, *seeds):
    """`seeds`: their number, or nothing."""
    with tempfile.TemporaryDirectory() as prefix:
        # A Windows of our own, which stays up until the end: to start it takes longer than a test does.
        options = {"cwd": source, "env": {**os.environ, "WINEPREFIX": prefix, "WINEDEBUG": "-all"}}
        good = (quietly("cmake", "--preset", "windows", **options)
                and quietly("cmake", "--build", "--preset", "windows", "--target", "all", "slow_programs", **options)
                and quietly("wineserver", "--persistent", **options) and quietly("wineboot", "--init", **options))
        try:
            return (good and subprocess.run(["ctest", "--preset", "windows"], **options).returncode == 0
                    and subprocess.run([sys.executable, source / "tests/soak.py", "--build", source / "build/windows",
                                        *(("--seeds", *seeds) if seeds else ())], **options).returncode == 0)
        finally:
            subprocess.run(["wineserver", "--kill", "--wait"], **options)


def main():
    source = pathlib.Path(sys.argv[1]).resolve()
    need(COMPILER, "gcc-mingw-w64-x86-64", "compiled")
    if len(sys.argv) == 2:
        return compile_adapters(source)
    need("wine", "wine wine64", "run")
    return soak(source, *sys.argv[3:])


if __name__ == "__main__":
    sys.exit(0 if main() else 1)
