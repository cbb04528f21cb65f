"""DisMech on Newton: discrete elastic rods by strain-space ADMM, with contact and friction, on the CPU.

It is made for GPUs: one rod on one core pays for the launch of every kernel. Single precision; mm, mg and ms keep its
numbers near one. The rod is homogeneous, as in elastica_rod.py."""
import math

import newton
import numpy as np
import warp as wp
from newton import ParticleFlags

import problem as p


@wp.struct
class Empty:
    nothing: int


# The package has annotations `Struct | None`, which Python before 3.14 evaluates at import.
type(Empty).__or__ = lambda one, _: one
from dismech_newton import DiSMechSolver, add_rod, fix_segment  # noqa: E402

wp.config.quiet = True
wp.set_device("cpu")
VERSION = "DisMech on Newton 0.1.0"
NOTE = f"discrete elastic rod, implicit in time, single precision, Newton {newton.__version__} on a CPU"
CASES = {
    "thread": [(30, 2e-3), (30, 1e-3), (60, 1e-3)],
    # With longer steps its search finds no way on: the rod stays where it is, and the knot slips through itself.
    "capstan": [(30, 0.5e-3), (30, 0.2e-3), (60, 0.2e-3)],
    "trefoil": [(90, 0.1e-3), (90, 0.05e-3)],
}
ENGAGE_GAP = 1.0  # diameters, of strands in a knot
MM, MG, MS = 1e3, 1e6, 1e3
MILLINEWTON = 1e3  # mg mm/ms^2 in a newton
RADIUS = MM * p.RADIUS
BENDING = MILLINEWTON * MM**2 * p.BENDING
AXIAL = MILLINEWTON * p.SOFT_AXIAL
DENSITY = p.LINEAR_DENSITY * MG / MM / (math.pi * RADIUS**2)


class Rod:
    def set_points(self, points, h, gravity=0.0, friction=0.0, collide=True):
        """A builder with the rod through the points, m."""
        builder = newton.ModelBuilder(gravity=(0.0, -gravity * MM / MS**2, 0.0))
        DiSMechSolver.register_custom_attributes(builder)
        length = float(MM * np.linalg.norm(points[1] - points[0]))
        rod = newton.Rod([wp.vec3(*(MM * x).tolist()) for x in points], radius=RADIUS)
        cfg = newton.ModelBuilder.ShapeConfig(density=DENSITY, mu=friction)
        self.bodies = add_rod(builder, rod, cfg=cfg, stretch_stiffness=AXIAL / length, bend_stiffness=BENDING / length,
                              twist_stiffness=BENDING / length, collide=collide)
        self.h, self.length, self.count = MS * h, length, len(points)
        return builder

    def begin(self, builder, **options):
        builder.color()
        self.model = builder.finalize(device="cpu")
        self.solver = DiSMechSolver(self.model, **options)
        rest = self.solver.triplets.rest.numpy()
        rest[:] = 0.0  # straight, whatever the first shape is
        self.now, self.next = self.model.state(), self.model.state()

    def step(self):
        self.solver.step(self.now, self.next, None, None, self.h)
        self.now, self.next = self.next, self.now

    def places(self):
        return self.now.particle_q.numpy()

    def positions(self):
        return self.places().astype(float) / MM


class Thread(Rod):
    def __init__(self, segments, h):
        length = p.LENGTH / (segments - 0.5)  # the first segment is held in its middle
        line = np.stack([length * (np.arange(segments + 1) - 0.5)] + [np.zeros(segments + 1)] * 2, axis=1)
        builder = self.set_points(line, h, gravity=p.GRAVITY, collide=False)
        fix_segment(builder, self.bodies[0])
        self.begin(builder, theta=0.5, exact=True, iterations=4, self_contact=False)

    def advance(self, seconds):
        for _ in range(round(MS * seconds / self.h)):
            self.step()


class LedRod(Rod):
    """A rod whose end nodes are led against drag."""

    def hold(self, builder, nodes):
        self.led = nodes
        for node in nodes:
            builder.particle_flags[node] &= ~ParticleFlags.ACTIVE

    def lead(self, seconds, velocities, load=0.0):
        kept = math.exp(-p.DRAG / MS * self.h)
        for _ in range(round(MS * seconds / self.h)):
            places, speeds = self.now.particle_q.numpy(), self.now.particle_qd.numpy()
            speeds *= kept
            for node, velocity in zip(self.led, velocities):
                places[node] += self.h * np.asarray(velocity, dtype=np.float32)
            if load:
                self.now.particle_f.numpy()[0] = (0.0, -load * MILLINEWTON, 0.0)
            self.step()

    def pull(self):
        last = self.places()[-2:].astype(float)
        return AXIAL * (np.linalg.norm(last[1] - last[0]) / self.length - 1.0) / MILLINEWTON


class Capstan(LedRod):
    def __init__(self, segments, h):
        builder = self.set_points(p.capstan_points(segments), h, friction=p.FRICTION)
        cfg = newton.ModelBuilder.ShapeConfig(mu=p.FRICTION)
        builder.add_shape_capsule(-1, radius=MM * p.CYLINDER, half_height=20.0, cfg=cfg)  # along z
        self.hold(builder, (segments,))
        self.begin(builder, self_contact=False)

    def advance(self, seconds, load, speed):
        self.lead(seconds, [(0.0, -speed, 0.0)], load)


class Trefoil(LedRod):
    def __init__(self, segments, h):
        builder = self.set_points(p.trefoil_points(segments), h, friction=p.KNOT_FRICTION)
        self.hold(builder, (0, segments))
        self.begin(builder, engage_gap=ENGAGE_GAP)

    def advance(self, seconds, speed):
        self.lead(seconds, [(0.0, 0.0, -speed), (0.0, 0.0, speed)])
