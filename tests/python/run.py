"""Runs a part of the tests of the Python binding, where what it needs is installed; says so plainly where not.

    run.py generated    the low-level binding is what the headers say
    run.py tests        objects, arrays, lives, properties, by pytest
    run.py sweeps       whole throws, a sweep with dask, the notebook, by pytest
    run.py package      the wheel in a fresh virtual environment, by pytest
    run.py gymnasium    the environments with gymnasium from the package index, by pytest
    run.py types        mypy over the binding"""
import importlib.util
import os
import pathlib
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
BINDING = ROOT / "bindings" / "python"
CACHE = os.environ.get("VBSS_WORK", tempfile.gettempdir())
PYTEST = ["-m", "pytest", "-q", "-p", "no:cacheprovider"]
PARTS = {
    "generated": ([], [str(BINDING / "generate.py"), "--check"]),
    "tests": (["pytest", "numpy", "hypothesis"], [*PYTEST, "--ignore", str(HERE / "test_package.py"),
                                                  "--ignore", str(HERE / "test_sweeps.py"),
                                                  "--ignore", str(HERE / "test_gymnasium.py"), str(HERE)]),
    "sweeps": (["pytest", "numpy", "matplotlib", "h5py", "distributed", "nbclient", "ipykernel"],
                 [*PYTEST, str(HERE / "test_sweeps.py")]),
    "package": (["pytest", "numpy"], [*PYTEST, str(HERE / "test_package.py")]),
    "gymnasium": (["pytest", "numpy"], [*PYTEST, str(HERE / "test_gymnasium.py")]),
    "types": (["mypy"], ["-m", "mypy", "--strict", "--cache-dir", f"{CACHE}/mypy", str(BINDING / "vblast_ss")]),
}

if len(sys.argv) != 2 or sys.argv[1] not in PARTS:
    sys.exit(__doc__)
needed, command = PARTS[sys.argv[1]]
missing = [name for name in needed if importlib.util.find_spec(name) is None]
if missing:
    packages = " ".join("mypy" if name == "mypy" else f"python3-{name}" for name in missing)
    print(f"{', '.join(missing)} is not there for {sys.executable}. To have the binding tested: sudo apt-get install "
          f"{packages}, and cmake -DVBSS_PYTHON=/usr/bin/python3")
    sys.exit(0)
os.chdir(CACHE)
os.execv(sys.executable, [sys.executable, "-B", *command])
