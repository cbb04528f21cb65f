"""Gymnasium from the package index, in a virtual environment of its own."""
import os
import pathlib
import subprocess
import sys

import pytest

import vblast_ss as vb
from conftest import BINDING


def test_gymnasium_accepts_renders_vectorises_and_films_the_environments(tmp_path):
    folder = tmp_path / "environment"
    made = subprocess.run([sys.executable, "-m", "venv", str(folder)], capture_output=True, text=True, timeout=300)
    if made.returncode != 0:
        pytest.skip("python3-venv is not there")
    python = folder / ("Scripts" if os.name == "nt" else "bin") / "python"
    got = subprocess.run([python, "-m", "pip", "install", "-q", "gymnasium", "moviepy"], capture_output=True, text=True, timeout=900)
    if got.returncode != 0:
        pytest.skip("the package index cannot be reached: " + got.stderr[-200:])
    done = subprocess.run([python, "-B", "-W", "ignore", pathlib.Path(__file__).with_name("gymnasium_check.py"), tmp_path / "video"],
                          capture_output=True, text=True, timeout=900,
                          env={**os.environ, "PYTHONPATH": str(BINDING), "VBLAST_SS_LIBRARY": vb.library_path})
    assert done.returncode == 0, done.stdout + done.stderr
