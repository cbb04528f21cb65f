"""MuJoCo 4: a 1D flex, a discrete elastic rod, with the integrator `discrete`, in mm, mg and ms.

It superseded the cable plugin. Bending is implicit in time. Constraints keep the lengths of edges, but their turning
is explicit: a tension T shakes the rod to pieces where the step is above l sqrt(linear density / T)."""
import math

import mujoco
import numpy as np

import problem as p
from mujoco_steps import move_ends, stepped

VERSION = f"MuJoCo {mujoco.__version__}, 1D flex"
NOTE = "discrete elastic rod, implicit in time, edges kept by constraints"
CASES = {
    "thread": [(30, 4e-3), (30, 1e-3), (60, 1e-3), (60, 0.25e-3), (120, 0.25e-3)],
    "capstan": [(30, 40e-6), (30, 20e-6), (60, 20e-6)],
    "trefoil": [(90, 8e-6), (90, 4e-6)],
}
MM, MG, MS = 1e3, 1e6, 1e3
MILLINEWTON = 1e3  # mg mm/ms^2 in a newton
RADIUS = MM * p.RADIUS
YOUNG = MILLINEWTON * MM**2 * p.BENDING / (math.pi * RADIUS**4 / 4.0)
AXIAL = 20.0 * MILLINEWTON  # EA
IMPEDANCE = 0.9999  # the hardest that MuJoCo allows
DRAG_STEPS = 1  # between which the drag is applied; more of them jerk the prescribed ends
# Softest constraints that a step may have, in steps, and contacts: softer than in the other problems, the pull trembles less.
CAPSTAN_STEPS, CAPSTAN_IMPEDANCE = 5.0, 0.99


def straight(points):
    """Points on a line with the distances of these."""
    at = np.concatenate(([0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))))
    return np.stack([at, 0.0 * at, 0.0 * at], axis=1)


def loaded(line, h, pins="", contact="", gravity=0.0, bodies="", rest="", steps=2.0, impedance=0.999):
    """Model and data of a rod that is straight at rest, along a line, m."""
    listed = " ".join(f"{MM * x:.9g}" for x in np.ravel(line))
    node = p.LINEAR_DENSITY * MG / MM * MM * np.linalg.norm(line[1] - line[0])
    hard = f'solref="{steps * h * MS:.9g} 1"'
    model = mujoco.MjModel.from_xml_string(f"""<mujoco>
      <option timestep="{h * MS:.9g}" integrator="discrete" solver="Newton" tolerance="1e-8" iterations="100" cone="elliptic"
        impratio="100" gravity="0 {-gravity * MM / MS**2:.9g} 0"/><size memory="200M"/>
      <default><geom {hard} solimp="{impedance} {impedance}"/><equality {hard} solimp="{IMPEDANCE} {IMPEDANCE}"/></default>
      <worldbody>{bodies}<flexcomp name="rod" type="direct" dim="1" radius="{RADIUS}" point="{listed}"
        element="{' '.join(f'{i} {i + 1}' for i in range(len(line) - 1))}" mass="{node * len(line):.9g}">
        <edge equality="true" {hard} solimp="{IMPEDANCE} {IMPEDANCE}"/>
        <elasticity young="{YOUNG:.9g}" poisson="0" damping="0" section="circle"/>
        <contact condim="3" {hard} solimp="{impedance} {impedance}" {contact}/>{pins}</flexcomp></worldbody>{rest}</mujoco>""")
    nodes = [i for i in (0, len(line) - 1) if mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, f"rod_{i}") >= 0]
    for i in nodes:  # the ends carry half of an edge
        model.body_mass[model.body(f"rod_{i}").id] *= 0.5
    data = mujoco.MjData(model)
    mujoco.mj_setConst(model, data)
    # An edge is as hard as its assumed inertia makes it: that of a spring AXIAL / l, whatever the step.
    model.flexedge_invweight0[:] = model.flexedge_length0 / (AXIAL * (h * MS) ** 2) / (1.0 - IMPEDANCE)
    return model, data


class Thread:
    def __init__(self, segments, h):
        length = p.LENGTH / (segments - 0.5)  # the first segment is held in its middle
        line = np.stack([length * (np.arange(segments + 1) - 0.5)] + [np.zeros(segments + 1)] * 2, axis=1)
        self.model, self.data = loaded(line, h, '<pin id="0 1"/>', 'selfcollide="none" contype="0" conaffinity="0"',
                                       p.GRAVITY)
        self.h = h

    def advance(self, seconds):
        stepped(self.model, self.data, round(seconds / self.h))

    def positions(self):
        mujoco.mj_kinematics(self.model, self.data)
        mujoco.mj_flex(self.model, self.data)
        return self.data.flexvert_xpos / MM


class Led:
    """A rod whose end nodes hang on bodies that are led."""

    def set_points(self, points, h, nodes, contact, bodies="", **hardness):
        led = "".join(f'<body name="led{i}" mocap="true"/>' for i in range(len(nodes)))
        connects = "".join(f'<connect name="led{i}" body1="rod_{node}" body2="led{i}" anchor="0 0 0"/>'
                           for i, node in enumerate(nodes))
        line = straight(points)
        self.model, self.data = loaded(line, h, contact=contact, bodies=led + bodies,
                                       rest=f"<equality>{connects}</equality>", **hardness)
        self.h, self.last = h, self.model.equality(f"led{len(nodes) - 1}").id
        for i, node in enumerate(nodes):
            self.data.mocap_pos[i] = MM * points[node]
            self.model.eq_data[self.model.equality(f"led{i}").id, :6] = 0.0
        for i, moved in enumerate(MM * (points - line)):
            joint = self.model.body(f"rod_{i}").jntadr[0]
            at = self.model.jnt_qposadr[joint]
            self.data.qpos[at:at + 3] = moved
        mujoco.mj_forward(self.model, self.data)

    def steps(self, seconds, velocities):
        move_ends(self.model, self.data, self.h, seconds, velocities, DRAG_STEPS)

    def pull(self):
        """Of the last of the led ends."""
        rows = (self.data.efc_type == mujoco.mjtConstraint.mjCNSTR_EQUALITY) & (self.data.efc_id == self.last)
        return float(np.linalg.norm(self.data.efc_force[rows])) / MILLINEWTON

    def positions(self):
        mujoco.mj_kinematics(self.model, self.data)
        mujoco.mj_flex(self.model, self.data)
        return self.data.flexvert_xpos / MM


class Capstan(Led):
    def __init__(self, segments, h):
        post = (f'<geom type="capsule" fromto="0 0 -20 0 0 20" size="{p.CYLINDER * MM}" condim="3" '
                f'friction="{p.FRICTION} 0 0"/>')
        self.set_points(p.capstan_points(segments), h, (segments,), f'selfcollide="none" friction="{p.FRICTION} 0 0"', post,
                        steps=CAPSTAN_STEPS, impedance=CAPSTAN_IMPEDANCE)
        self.first = self.model.body("rod_0").id

    def advance(self, seconds, load, speed):
        self.data.xfrc_applied[self.first, 1] = -load * MILLINEWTON
        self.steps(seconds, [[0.0, -speed, 0.0]])


class Trefoil(Led):
    def __init__(self, segments, h):
        self.set_points(p.trefoil_points(segments), h, (0, segments), f'friction="{p.KNOT_FRICTION} 0 0"')

    def advance(self, seconds, speed):
        self.steps(seconds, [[0.0, 0.0, -speed], [0.0, 0.0, speed]])
