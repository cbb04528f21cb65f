"""A scene that bindings of other languages perform too: a hanging thread after 50 steps."""
from __future__ import annotations

import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = """
from vblast_ss import Context, Scene, Thread
c = Context(); s = Scene(c); t = Thread(c, segment_count=20, length=0.1)
t.attach('pin', 0, position=(0, 0, 0)); s.add(t)
for _ in range(50): s.step(1e-3)
print(s.state_hash)
"""


def python_hash() -> str:
    """Hash of the scene, computed by the Python binding with the library of VBLAST_SS_LIBRARY."""
    env = {**os.environ, "PYTHONPATH": str(ROOT / "bindings" / "python")}
    return subprocess.run([sys.executable, "-B", "-c", PROGRAM], check=True, capture_output=True, text=True, env=env).stdout.strip()
