"""MuJoCo 3: the `cable` composite with its elasticity plugin, rigid capsules joined by balls, in mm, mg and ms.

The plugin's bending forces are explicit in time. A joint damping of 0.55 steps of the spring's stiffness, which MuJoCo
takes implicitly, makes any step stable; without it the largest stable step is eight times shorter, at like error.
Links under tension get inertia against turning, as there, and contacts an impratio of 100: friction is far too small with 1."""
import math

import mujoco
import numpy as np

import problem as p
from mujoco_steps import move_ends, stepped

VERSION = f"MuJoCo {mujoco.__version__}, cable plugin"
NOTE = "rigid capsules, ball joints, springs explicit in time"
CASES = {
    "thread": [(15, 2e-3), (15, 1e-3), (30, 1e-3), (30, 0.25e-3), (60, 0.25e-3)],
    "capstan": [(20, 0.1e-3), (20, 0.05e-3), (30, 0.05e-3)],
    "trefoil": [(60, 20e-6), (90, 10e-6)],
}
MM, MS = 1e3, 1e3
MILLINEWTON = 1e3  # mg mm/ms^2 in a newton
TWIST_SHARE = 0.02  # G over E: no twist in these problems, and a real one would limit the step
JOINT_SHARE = 0.55  # of a spring's stiffness times the step: the damping of its joint
CAPSTAN_TENSION, KNOT_TENSION = 0.1, 0.4  # N, for which links get inertia
BEND = 1.6 * p.DIAMETER  # nearer along the thread than this, links may touch: a bend is no contact
DRAG_STEPS = 1  # between which the drag is applied; more of them jerk the prescribed ends


def cable(points, h, first, tension=0.0, contact=""):
    """Text of a cable through the points, m."""
    area = math.pi * (p.RADIUS * MM) ** 4 / 4.0
    young = p.BENDING * MILLINEWTON * MM**2 / area
    density = p.LINEAR_DENSITY * 1e6 / MM / (math.pi * (p.RADIUS * MM) ** 2)  # mg/mm^3
    length = MM * np.linalg.norm(points[1] - points[0])
    damping = JOINT_SHARE * h * MS * p.BENDING * MILLINEWTON * MM**2 / length
    armature = (h * MS) ** 2 * length * tension * MILLINEWTON
    vertices = " ".join(f"{MM * x:.9g}" for x in np.ravel(points))
    return f"""<composite type="cable" prefix="c" initial="{first}" vertex="{vertices}">
      <plugin plugin="mujoco.elasticity.cable"><config key="twist" value="{TWIST_SHARE * young:.9g}"/>
      <config key="bend" value="{young:.9g}"/><config key="flat" value="true"/></plugin>
      <joint kind="main" damping="{damping:.9g}" armature="{armature:.9g}"/>
      <geom type="capsule" size="{p.RADIUS * MM}" density="{density:.9g}" condim="3" {contact}/></composite>"""


def loaded(h, gravity, body, extra="", flags=""):
    """The model and its data."""
    model = mujoco.MjModel.from_xml_string(f"""<mujoco>
      <extension><plugin plugin="mujoco.elasticity.cable"/></extension><size memory="200M"/>
      <option timestep="{h * MS:.9g}" integrator="Euler" gravity="0 {-gravity * MM / MS**2:.9g} 0" cone="elliptic"
        impratio="100" iterations="50" tolerance="1e-8"><flag {flags}/></option>
      <default><equality solref="{2 * h * MS:.9g} 1" solimp="0.9999 0.9999"/>
        <geom solref="{2 * h * MS:.9g} 1" solimp="0.999 0.999"/></default>
      <worldbody>{body}</worldbody>{extra}</mujoco>""")
    return model, mujoco.MjData(model)


def centre_line(model, data):
    """Points of the cable, m: the begins of its links, and the end of the last."""
    mujoco.mj_kinematics(model, data)
    links = [b for b in range(model.nbody) if (mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_BODY, b) or "").startswith("cB_")]
    begins = data.xpos[links]
    geom = model.body_geomadr[links[-1]]
    end = begins[-1] + 2.0 * (data.geom_xpos[geom] - begins[-1])
    return np.concatenate((begins, [end])) / MM


class Thread:
    def __init__(self, segments, h):
        length = p.LENGTH / (segments - 0.5)  # the first segment is held in its middle
        line = np.stack([length * (np.arange(segments + 1) - 0.5)] + [np.zeros(segments + 1)] * 2, axis=1)
        self.model, self.data = loaded(h, p.GRAVITY, cable(line, h, "none"), flags='constraint="disable"')
        self.h = h

    def advance(self, seconds):
        stepped(self.model, self.data, round(seconds / self.h))

    def positions(self):
        return centre_line(self.model, self.data)


class Led:
    """A cable whose ends are connected to bodies that are led."""

    def lead(self, h, points, ends, tension, body, contact, extra=""):
        """`ends`: of the two ends, 0 and -1, those that are led."""
        names = {0: "cB_first", -1: "cB_last"}
        anchors = {0: (0, 0, 0), -1: (MM * np.linalg.norm(points[-1] - points[-2]), 0, 0)}
        led = "".join(f'<body name="led{i}" mocap="true" pos="{" ".join(f"{MM * x:.9g}" for x in points[e])}"/>'
                      for i, e in enumerate(ends))
        connects = "".join(f'<connect body1="{names[e]}" body2="led{i}" anchor="{" ".join(map(str, anchors[e]))}"/>'
                           for i, e in enumerate(ends))
        self.model, self.data = loaded(h, 0.0, cable(points, h, "free", tension, contact) + led + body,
                                       f"<equality>{connects}</equality>{extra}")
        self.h = h

    def steps(self, seconds, velocities):
        move_ends(self.model, self.data, self.h, seconds, velocities, DRAG_STEPS)

    def pull(self):
        """Of the last of the led ends."""
        rows = slice(3 * self.model.neq - 3, 3 * self.model.neq)
        return float(np.linalg.norm(self.data.efc_force[rows])) / MILLINEWTON

    def positions(self):
        return centre_line(self.model, self.data)


class Capstan(Led):
    def __init__(self, segments, h):
        post = (f'<geom type="capsule" fromto="0 0 -20 0 0 20" size="{p.CYLINDER * MM}" condim="3" '
                f'friction="{p.FRICTION} 0 0" contype="0" conaffinity="1"/>')
        self.lead(h, p.capstan_points(segments), (-1,), CAPSTAN_TENSION, post,
                  f'friction="{p.FRICTION} 0 0" contype="1" conaffinity="0"')
        self.first = self.model.body("cB_first").id

    def advance(self, seconds, load, speed):
        self.data.xfrc_applied[self.first, 1] = -load * MILLINEWTON
        self.steps(seconds, [[0.0, -speed, 0.0]])


class Trefoil(Led):
    def __init__(self, segments, h):
        points = p.trefoil_points(segments)
        bend = math.ceil(BEND / np.linalg.norm(points[1] - points[0]))
        names = ["cB_first", *(f"cB_{i}" for i in range(1, segments - 1)), "cB_last"]
        pairs = "".join(f'<exclude body1="{names[i]}" body2="{names[j]}"/>' for i in range(segments)
                        for j in range(i + 1, min(i + bend + 1, segments)))
        self.lead(h, points, (0, -1), KNOT_TENSION, "", f'friction="{p.KNOT_FRICTION} 0 0"', f"<contact>{pairs}</contact>")

    def advance(self, seconds, speed):
        self.steps(seconds, [[0.0, 0.0, -speed], [0.0, 0.0, speed]])
