"""What is observed of the whole task, and what hands can do."""
from __future__ import annotations

from typing import Any, Mapping

import numpy as np

SHOWN = 32
"""Points of the thread that are observed."""
WIDTHS = {"time": 1, "phase": 1, "holder": 1, "needle": 7, "left": 7, "right": 7, "jaws": 2, "left_force": 3,
          "right_force": 3, "holds": 2, "left_mark": 3, "right_mark": 3, "pierced": 2, "depth": 2, "threaded": 2,
          "gap": 1, "tail": 1, "throws": 1, "seated": 1, "thread": 3 * SHOWN}


def _places(widths: Mapping[str, int]) -> dict[str, Any]:
    """Where each is; one number alone is no slice."""
    found: dict[str, Any] = {}
    at = 0
    for name, width in widths.items():
        found[name] = at if width == 1 else slice(at, at + width)
        at += width
    return found


FIELDS = _places(WIDTHS)
"""What is where in an observation. time: s; phase: SessionPhase; holder: of the needle, 0 left, 1 right, 2 nobody; needle:
place, m, and quaternion; left, right: where hands want their tools' tips to be, likewise; jaws: openings of the handles;
left_force, right_force: what hands feel, N; holds: 1, its jaws hold something; left_mark, right_mark: where they are, m;
pierced: 1, the needle goes through the wall inward, outward; depth: of its tip beyond each, m; threaded: 1, the thread is
in the first hole, the second; gap: of the slit, m; tail: of the thread behind the first hole, m; throws, seated: how many;
thread: points from the needle on, m."""
SPEED = 0.1
"""m/s: of a tool at an action of 1."""
TURN = 4.0
"""rad/s: likewise."""
ACTIONS = 16
MOVE, ROTATE, JAWS, SHEARS = slice(0, 3), slice(3, 6), 6, 7
"""What is where in an action, 8 numbers for the left tool, then 8 for the right: a displacement and a rotation vector,
in the world, as shares of SPEED and TURN; how far the handle shall be open, -1 closed to 1 open; above 0: shears are wanted.
"""
LOW, HIGH = np.array((-0.12, -0.12, -20e-3)), np.array((0.12, 0.12, 0.15))
"""Where hands can reach, m: up to 6 mm into the floor, against which a tool then presses."""
