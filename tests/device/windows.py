"""The adapters of real hardware compile for Windows: windows.py <source folder>. Says so where there is no compiler."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

COMPILER = "x86_64-w64-mingw32-gcc"
# -Wconversion finds things in the system's own isfinite.
FLAGS = ["-std=c11", "-O2", "-Wall", "-Wextra", "-Wshadow", "-Wvla", "-Wstrict-prototypes", "-Wmissing-prototypes",
         "-Wundef", "-Werror", "-ffp-contract=off"]

if shutil.which(COMPILER) is None:
    print(f"{COMPILER} is not there: nothing is compiled. On Debian: apt-get install gcc-mingw-w64-x86-64")
    sys.exit(0)
source = pathlib.Path(sys.argv[1])
failed, files = 0, sorted((source / "lib/device").glob("*.c"))
with tempfile.TemporaryDirectory() as work:
    for file in files:
        done = subprocess.run([COMPILER, *FLAGS, "-I", source / "include", "-I", source / "lib", "-c", file, "-o",
                               pathlib.Path(work) / "object"])
        failed += done.returncode != 0
print(f"{len(files) - failed} of {len(files)} files compile")
sys.exit(1 if failed or not files else 0)
