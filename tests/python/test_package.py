"""The wheel, the editable install, and how the library is found."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import zipfile

import pytest

import vblast_ss as vb
from conftest import BINDING

SAY = ("import vblast_ss as vb, sys; t = vb.Thread(segment_count=5); t.step(); "
       "print(vb.__file__, vb.library_path, t.positions[0][1] if len(t.positions) == 6 else 'wrong', sep='\\n')")
PLAIN = {key: value for key, value in os.environ.items() if key not in ("PYTHONPATH", "VBLAST_SS_LIBRARY")}


def run(*command, **options):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=300, **options)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def build(folder, hook="build_wheel"):
    """As a front end does, but with the library that is tested."""
    script = f"import backend; print(backend.{hook}(r'{folder}'))"
    return folder / run(sys.executable, "-B", "-c", script, cwd=BINDING,
                        env={**PLAIN, "VBLAST_SS_LIBRARY": vb.library_path}).split()[-1]


@pytest.fixture(scope="module")
def environment(tmp_path_factory):
    """A fresh virtual environment with nothing but pip."""
    folder = tmp_path_factory.mktemp("environment")
    made = subprocess.run([sys.executable, "-m", "venv", str(folder)], capture_output=True, text=True, timeout=300)
    if made.returncode != 0:
        pytest.skip("python3-venv is not there")
    return folder / ("Scripts" if os.name == "nt" else "bin") / "python"


def test_wheels_are_the_same_bytes_twice_and_hold_what_they_should(tmp_path):
    (tmp_path / "a").mkdir()
    (tmp_path / "b").mkdir()
    first, second = build(tmp_path / "a"), build(tmp_path / "b")
    assert re.fullmatch(rf"vblast_ss-{re.escape(vb.version())}-py3-none-\w+\.whl", first.name)
    assert "any" not in first.name and first.read_bytes() == second.read_bytes()
    with zipfile.ZipFile(first) as archive:
        names = archive.namelist()
        library = [name for name in names if name.startswith("vblast_ss/lib/")]
        assert len(library) == 1 and archive.read(library[0]) == pathlib.Path(vb.library_path).read_bytes()
        listed = re.findall(r"^([^,]+),", archive.read([n for n in names if n.endswith("RECORD")][0]).decode(), re.M)
        assert sorted(listed) == sorted(names)
        assert {"vblast_ss/py.typed", "vblast_ss/_api/base.py", "vblast_ss/scene.py"} <= set(names)


def test_the_wheel_works_in_a_fresh_environment(environment, tmp_path):
    run(environment, "-m", "pip", "install", "--no-index", "--no-deps", build(tmp_path), env=PLAIN)
    package, library, _ = run(environment, "-c", SAY, env=PLAIN, cwd=tmp_path).splitlines()
    root = str(environment.parent.parent)
    assert package.startswith(root) and library.startswith(root)
    run(environment, "-m", "pip", "uninstall", "-y", "vblast-ss", env=PLAIN)


def test_an_editable_install_works(environment, tmp_path):
    run(environment, "-m", "pip", "install", "--no-index", "--no-deps", build(tmp_path, "build_editable"), env=PLAIN)
    package, library, _ = run(environment, "-c", SAY, cwd=tmp_path,
                              env={**PLAIN, "VBLAST_SS_LIBRARY": vb.library_path}).splitlines()
    assert package.startswith(str(BINDING)) and library == vb.library_path
    run(environment, "-m", "pip", "uninstall", "-y", "vblast-ss", env=PLAIN)


def test_pip_builds_the_wheel_itself(environment, tmp_path):
    run(environment, "-m", "pip", "wheel", "--no-index", "--no-deps", "--no-build-isolation", "-w", tmp_path, BINDING,
        env={**PLAIN, "VBLAST_SS_LIBRARY": vb.library_path})
    assert len(list(tmp_path.glob("vblast_ss-*.whl"))) == 1


@pytest.mark.parametrize("said, message", [
    ("/no/such/file", "VBLAST_SS_LIBRARY is '/no/such/file'"), (str(BINDING), "where no shared library")])
def test_a_library_that_is_not_there(said, message):
    done = subprocess.run([sys.executable, "-B", "-c", "import vblast_ss"], capture_output=True, text=True, cwd=BINDING,
                          env={**PLAIN, "VBLAST_SS_LIBRARY": said})
    assert done.returncode == 1 and message in done.stderr.splitlines()[-1]


def test_a_folder_will_do_and_a_wrong_library_will_not(tmp_path):
    shutil.copy(vb.library_path, tmp_path / "libvblast_ss.so")
    said = run(sys.executable, "-B", "-c", SAY, cwd=BINDING, env={**PLAIN, "VBLAST_SS_LIBRARY": str(tmp_path)})
    assert str(tmp_path / "libvblast_ss.so") in said
    compiler = os.environ.get("VBSS_CC") or shutil.which("cc")
    if compiler:
        (tmp_path / "other.c").write_text("int other(void) { return 0; }\n")
        run(compiler, "-shared", "-fPIC", tmp_path / "other.c", "-o", tmp_path / "other.so")
        done = subprocess.run([sys.executable, "-B", "-c", "import vblast_ss"], capture_output=True, text=True,
                              cwd=BINDING, env={**PLAIN, "VBLAST_SS_LIBRARY": str(tmp_path / "other.so")})
        assert "is not the library that this package was made for" in done.stderr
