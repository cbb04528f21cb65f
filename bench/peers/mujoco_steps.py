"""Steps of MuJoCo that its two peers share: instability is an error, and drag slows rods whose ends are moved."""
import math

import mujoco
import numpy as np

import problem as p

MS = 1e3  # in a second


def stepped(model, data, count):
    mujoco.mj_step(model, data, nstep=count)
    if any(data.warning[w].number for w in (mujoco.mjtWarning.mjWARN_BADQPOS, mujoco.mjtWarning.mjWARN_BADQVEL,
                                            mujoco.mjtWarning.mjWARN_BADQACC)):
        raise ArithmeticError("unstable")


def move_ends(model, data, h, seconds, velocities, drag_steps):
    """Moves the prescribed ends at these velocities, mm/ms, and applies the drag every few steps."""
    count = round(seconds / h)
    for done in range(0, count, drag_steps):
        now = min(drag_steps, count - done)
        data.mocap_pos += now * h * MS * np.asarray(velocities)
        stepped(model, data, now)
        data.qvel *= math.exp(-p.DRAG * now * h)
