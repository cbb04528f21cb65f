"""The examples do what they say."""
import os
import re
import subprocess
import sys

import pytest

import vblast_ss as vb
from conftest import BINDING


def run(name, *arguments):
    done = subprocess.run([sys.executable, "-B", str(BINDING / "examples" / name), *arguments], capture_output=True,
                          text=True, timeout=120,
                          env={**os.environ, "PYTHONPATH": str(BINDING), "VBLAST_SS_LIBRARY": vb.library_path})
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_the_hanging_thread_meets_the_elastica():
    off = float(re.search(r"apart by ([\d.e+-]+) um", run("hang_thread.py")).group(1))
    assert off < 10.0  # 0.02 % of the length
    assert 3.0 * off < float(re.search(r"apart by ([\d.e+-]+) um", run("hang_thread.py", "12")).group(1))


def test_the_hanging_thread_is_drawn(tmp_path):
    pytest.importorskip("matplotlib")
    run("hang_thread.py", "--plot", str(tmp_path / "hanging.png"))
    assert (tmp_path / "hanging.png").stat().st_size > 10000


def test_knots_are_identified_from_a_file(tmp_path):
    assert run("classify_knots.py").splitlines() == [
        "right overhand: 1 (single, certified, right)", "left overhand: 1 (single, certified, left)",
        "no knot: - (none, none)"]
    path = tmp_path / "one.csv"
    path.write_text("line,x,y,z\n" + "".join(f"a,{i},0,0\n" for i in range(5)))
    assert run("classify_knots.py", str(path)) == "a: - (none, none)\n"


def test_a_knot_is_still_there_when_it_is_pulled_tight():
    said = run("pull_knot.py").splitlines()
    assert len(said) == 7 and all(": 1 (certified), " in line for line in said[:-1])


@pytest.mark.parametrize("name", ["README.md", "docs/guides/python.md", "docs/guides/learning-environments.md", "docs/start/python.md",
                                  "docs/guides/knots-from-a-polyline.md"])
def test_the_pages_examples_run(name, tmp_path):
    from conftest import ROOT
    blocks = re.findall(r"```python\n(.*?)```", (ROOT / name).read_text(), re.S)
    assert blocks
    for block in blocks:
        done = subprocess.run([sys.executable, "-B", "-c", block], capture_output=True, text=True, timeout=120,
                              cwd=tmp_path, env={**os.environ, "PYTHONPATH": str(BINDING),
                                                 "VBLAST_SS_LIBRARY": vb.library_path})
        assert done.returncode == 0, f"{block}\n{done.stderr}"


def test_a_knots_force_is_the_published_one(tmp_path):
    pytest.importorskip("matplotlib")
    said = run("overhand_force.py", "--steps", "1600", "--plot", str(tmp_path / "force.png"))
    assert "knot in the end: 1" in said and (tmp_path / "force.png").stat().st_size > 10000
    ratios = [float(line.split()[-1]) for line in said.splitlines() if re.match(r" +\d", line)]
    assert len(ratios) == 24 and all(1.0 < ratio < 1.2 for ratio in ratios)


def test_a_sweep_without_dask_says_what_is_missing(tmp_path):
    (tmp_path / "dask").mkdir()
    (tmp_path / "dask" / "__init__.py").write_text("raise ImportError\n")
    done = subprocess.run([sys.executable, "-B", str(BINDING / "examples" / "sweep_throws.py")], capture_output=True,
                          text=True, timeout=60, env={**os.environ, "PYTHONPATH": f"{tmp_path}:{BINDING}"})
    assert done.returncode == 1 and "python3-distributed" in done.stderr and "Traceback" not in done.stderr
