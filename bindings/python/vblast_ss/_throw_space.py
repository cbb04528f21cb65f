"""What is observed of a throw, and what hands can do."""
from __future__ import annotations

SHOWN = 32
"""Points of the thread that are observed."""
FIELDS = {"time": 0, "w": slice(1, 4), "c": slice(4, 7), "tail": slice(7, 10), "angle": 10, "holds": 11,
          "pull_w": 12, "pull_c": 13, "free": 14, "on_w": 15, "held_at": 16, "thread": slice(17, 17 + 3 * SHOWN)}
"""What is where in an observation. time: s; w, c: where the hands hold their tools, m; tail: where W is to take it, m;
angle: of C about W, rad; holds: 1, W holds the tail; pull_w, pull_c: tension of the thread there, N; free: of the limb,
from where it touches W last (or the drain) to C, m; on_w: contacts of the limb on W; held_at: the limb's length to C, m;
thread: points along it, from the tail's end on, m."""
SPEED = 0.2
"""m/s: of a hand at an action of 1."""
TURN = 10.0
"""rad/s: likewise, of C about W."""
W, C, TURNING, GRIP = slice(0, 3), slice(3, 6), 6, 7
"""What is where in an action: speeds of both hands, of C's turn about W, and W's jaws: above 0 they close."""
