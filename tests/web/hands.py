"""Hands that a script moves for the page: the needle is taken where examples/needle lays it for steady hands (seed 0), and lifted,
by poses as controllers have them."""
import math

RADIUS, ALONG = 10.5e-3, 0.64 * math.pi  # of the needle; where it is taken, from its tip
PLACE = (0.035 - RADIUS * math.cos(ALONG), -0.005 - RADIUS * math.sin(ALONG))
TURN = ALONG + math.pi  # about the vertical: the jaws are astride the wire
START = (0.05, -0.05, 0.03)  # of the right tool
FRAME = 16  # steps
# Where the tool is to be, how far its jaws are open, in so many frames.
PATH = [((*PLACE, 0.0), 1.0, 60), ((*PLACE, -14.2e-3), 1.0, 25), ((*PLACE, -14.2e-3), 0.0, 20), ((*PLACE, 15e-3), 0.0, 40)]
NEEDLE, STITCH, COARSE = 1, 2, 4  # scenes
RIGHT = 1
DONE = 11  # the phase


def quaternion(angle):
    """About the vertical: w, x, y, z."""
    return (math.cos(0.5 * angle), 0.0, 0.0, math.sin(0.5 * angle))


def poses():
    """Position, orientation, jaw of each frame."""
    before, opening, frames = START, 1.0, 0
    total = PATH[0][2]
    for place, jaw, count in PATH:
        for i in range(1, count + 1):
            share = i / count
            frames += 1
            at = tuple(a + share * (b - a) for a, b in zip(before, place))
            yield at, quaternion(min(1.0, frames / total) * TURN), opening + share * (jaw - opening)
        before, opening = place, jaw


def clutch():
    """The controller goes on while its clutch is held."""
    at, turned, jaw = list(poses())[-1]
    numbers = " ".join(f"{v:.9g}" for v in (at[0], at[1] + 30e-3, at[2], *turned, jaw))
    return [f"pose {RIGHT} {' '.join(f'{v:.9g}' for v in (*at, *turned, jaw))} 1 0.001", f"step {FRAME}", f"pose {RIGHT} {numbers} 1 0.016",
            f"step {FRAME}", f"pose {RIGHT} {numbers} 0 0.016", f"step {FRAME}"]


def controllers(scene, hash_every=20):
    """As calls of calls.c: a controller takes the needle; then the mouse has the tool again, and the clutch, and the other tool."""
    lines = [f"begin {scene} 0", f"track {RIGHT} 1"]
    for i, (at, turned, jaw) in enumerate(poses()):
        numbers = " ".join(f"{v:.9g}" for v in (*at, *turned, jaw))
        lines += [f"pose {RIGHT} {numbers} 0 0.016", f"step {FRAME}"]
        if i % hash_every == 0:
            lines.append("hash")
    lines += ["state", *clutch(), "state", f"track {RIGHT} 0", "camera 0.2 0.9 0.1 1.5", f"move {RIGHT} 0 40 -10 1", f"step {FRAME}", f"clutch {RIGHT} 1",
              f"move {RIGHT} 0 100 0 0", "move 0 1 30 0 2", f"step {FRAME}", f"clutch {RIGHT} 0", "close 0 1", "pull 0 0.5 0 -1 0 0.2 0.3 0.25", "step 200", "pull 0 0 0 0 0 0 0 1", "hash", "state"]
    return lines
