"""This library, through its Python binding. Its thread without contacts is measured in C: ./bench/run.sh thread."""
import math

import numpy as np

import problem as p
import vblast_ss as vb

VERSION = f"libvblast_ss {vb.version()}" if callable(getattr(vb, "version", None)) else "libvblast_ss"
NOTE = "implicit rod without twist, contacts and friction in one system"
CASES = {
    "capstan": [(30, 2e-3), (30, 1e-3), (60, 1e-3), (120, 1e-3)],
    "trefoil": [(90, 2e-3), (90, 1e-3), (135, 1e-3), (180, 1e-3), (180, 0.5e-3)],
}
AXIAL = 427.0


def scene_with(context, points, h, **settings):
    scene = vb.Scene(context, mode="offline", **settings)
    rest = np.linalg.norm(np.diff(points, axis=0), axis=1)
    thread = vb.Thread(context, positions=points.tolist(), rest_lengths=rest.tolist(), radius=p.RADIUS,
                       linear_density=p.LINEAR_DENSITY, bending_stiffness=p.BENDING, axial_stiffness=AXIAL,
                       gravity=(0, 0, 0), drag=p.DRAG)
    scene.add(thread)
    return scene, thread


class Capstan:
    def __init__(self, segments, h):
        points = p.capstan_points(segments)
        self.scene, self.thread = scene_with(vb.Context(), points, h)
        self.h = h
        self.scene.add_rigid([((0, 0, -0.02), (0, 0, 0.02), p.CYLINDER)], friction=p.FRICTION)
        self.load = self.thread.attach("force", 0)
        self.end, self.at = self.thread.attach("pin", segments), points[-1].copy()

    def advance(self, seconds, load, speed):
        self.thread.set_attachment_target(self.load, (0.0, -load, 0.0))
        for _ in range(round(seconds / self.h)):
            self.at[1] -= speed * self.h
            self.thread.set_attachment_target(self.end, self.at.tolist())
            self.scene.step(self.h)

    def positions(self):
        return np.array(self.thread.positions)

    def pull(self):
        return math.hypot(*self.thread.reaction(self.end).force)


class Trefoil:
    def __init__(self, segments, h):
        points = p.trefoil_points(segments)
        self.scene, self.thread = scene_with(vb.Context(), points, h, thread_friction=p.KNOT_FRICTION)
        self.h = h
        self.ends = [self.thread.attach("pin", node) for node in (0, segments)]
        self.at = [points[0].copy(), points[-1].copy()]

    def advance(self, seconds, speed):
        for _ in range(round(seconds / self.h)):
            for end, place, direction in zip(self.ends, self.at, (-1.0, 1.0)):
                place[2] += direction * speed * self.h
                self.thread.set_attachment_target(end, place.tolist())
            self.scene.step(self.h)

    def positions(self):
        return np.array(self.thread.positions)

    def pull(self):
        return math.hypot(*self.thread.reaction(self.ends[1]).force)
