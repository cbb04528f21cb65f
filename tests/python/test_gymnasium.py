"""Gymnasium from the package index, in a virtual environment of its own."""
import os
import pathlib
import shutil
import subprocess
import sys

import pytest

import vblast_ss as vb
from conftest import BINDING

HERE = pathlib.Path(__file__).parent


@pytest.fixture(scope="module")
def python(tmp_path_factory):
    folder = tmp_path_factory.mktemp("gymnasium") / "environment"
    made = subprocess.run([sys.executable, "-m", "venv", str(folder)], capture_output=True, text=True, timeout=300)
    if made.returncode != 0:
        pytest.skip("python3-venv is not there")
    python = folder / ("Scripts" if os.name == "nt" else "bin") / "python"
    got = subprocess.run([python, "-m", "pip", "install", "-q", "gymnasium", "moviepy", "pygame"], capture_output=True, text=True,
                         timeout=900)
    if got.returncode != 0:
        pytest.skip("the package index cannot be reached: " + got.stderr[-200:])
    return python


def run(python, script, *arguments, **variables):
    plain = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER")}
    done = subprocess.run([python, "-B", "-W", "ignore", HERE / script, *arguments], capture_output=True, text=True, timeout=900,
                          env={**plain, "PYTHONPATH": str(BINDING), "VBLAST_SS_LIBRARY": vb.library_path, **variables})
    assert done.returncode == 0, done.stdout + done.stderr


def test_gymnasium_accepts_renders_vectorises_and_films_the_environments(python, tmp_path):
    run(python, "gymnasium_check.py", tmp_path / "video", SDL_VIDEODRIVER="dummy")


def test_a_window_shows_the_pictures_until_it_is_closed(python, tmp_path):
    server = shutil.which("Xvfb")
    if server is None:
        pytest.skip("Xvfb is not there")
    reading, writing = os.pipe()
    display = subprocess.Popen([server, "-displayfd", str(writing), "-screen", "0", "1024x768x24", "-fbdir", tmp_path],
                               pass_fds=[writing], stderr=subprocess.DEVNULL)
    try:
        os.close(writing)
        number = os.read(reading, 16).decode().strip()
        run(python, "window_check.py", tmp_path / "Xvfb_screen0", DISPLAY=f":{number}", SDL_VIDEO_WINDOW_POS="0,0")
    finally:
        display.terminate()
        display.wait(30)
        os.close(reading)


def test_a_window_without_a_display_is_an_error(python):
    run(python, "window_check.py")
