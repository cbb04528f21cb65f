"""PyElastica: a Cosserat rod by position Verlet, in mm, mg and ms.

The rod is homogeneous: its EA follows from EI and the radius, as PyElastica builds it. The turning inertia of a thin
rod would limit the step; elements get that of rigid links, m l^2 / 12, which changes the motion by the order of the
mesh's own error. Self-contact is a penalty without friction, so its trefoil is pulled without."""
import elastica as ea
import numpy as np

import problem as p

VERSION = f"PyElastica {ea.__version__ if hasattr(ea, '__version__') else ''}".strip()
NOTE = "Cosserat rod, explicit in time; no friction between strands"
CASES = {
    "thread": [(15, 20e-6), (30, 10e-6), (60, 5e-6)],
    "capstan": [(30, 1e-6), (30, 0.5e-6)],
    "trefoil": [(90, 1e-6)],
}
MM, MG, MS = 1e3, 1e6, 1e3
MILLINEWTON = 1e3  # mg mm/ms^2 in a newton
RADIUS = MM * p.RADIUS
YOUNG = MILLINEWTON * MM**2 * p.BENDING / (np.pi * RADIUS**4 / 4.0)
DENSITY = p.LINEAR_DENSITY * MG / MM / (np.pi * RADIUS**2)


class World(ea.BaseSystemCollection, ea.Constraints, ea.Forcing, ea.Damping, ea.Contact):
    pass


def link_inertia(rod):
    factor = max(1.0, (rod.rest_lengths[0] / RADIUS) ** 2 / 3.0)
    rod.mass_second_moment_of_inertia *= factor
    rod.inv_mass_second_moment_of_inertia /= factor
    return rod


class Rod:
    """The world, its stepper and the time, which the three problems share."""

    def begin(self, h):
        self.world.finalize()
        self.stepper, self.h, self.time = ea.PositionVerlet(), MS * h, np.float64(0.0)

    def advance(self, seconds):
        for _ in range(round(MS * seconds / self.h)):
            self.time = self.stepper.step(self.world, self.time, self.h)

    def positions(self):
        return self.rod.position_collection.T / MM


class Thread(Rod):
    def __init__(self, segments, h):
        self.world = World()
        x, z = np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0])
        self.rod = link_inertia(ea.CosseratRod.straight_rod(segments, 0.0 * x, x, z, MM * p.LENGTH, RADIUS, DENSITY,
                                                            youngs_modulus=YOUNG))
        self.world.append(self.rod)
        self.world.constrain(self.rod).using(ea.OneEndFixedBC, constrained_position_idx=(0,), constrained_director_idx=(0,))
        self.world.add_forcing_to(self.rod).using(ea.GravityForces, acc_gravity=np.array([0.0, -p.GRAVITY * MM / MS**2, 0.0]))
        self.begin(h)


class LedEnds(ea.ConstraintBase):
    """Nodes of the rod that move at given velocities, mm/ms."""

    def __init__(self, *arguments, led, **keywords):
        super().__init__(*arguments, **keywords)
        self.led = led  # node -> [position, velocity]

    def constrain_values(self, system, time):
        for node, (place, _) in self.led.items():
            system.position_collection[:, node] = place

    def constrain_rates(self, system, time):
        for node, (_, velocity) in self.led.items():
            system.velocity_collection[:, node] = velocity


class EndLoad(ea.NoForces):
    def __init__(self, load):
        super().__init__()
        self.load = load

    def apply_forces(self, system, time=np.float64(0.0)):
        system.external_forces[:, 0] += self.load


class LedRod(Rod):
    """A rod through given points, straight at rest, whose ends are led against drag."""

    def set_points(self, points, nodes, h):
        self.world = World()
        points = MM * points
        edges = np.diff(points, axis=0)
        lengths = np.linalg.norm(edges, axis=1)
        rod = ea.CosseratRod.straight_rod(len(edges), points[0], edges[0] / lengths[0], frames(edges)[0, :, 0],
                                          lengths.sum(), RADIUS, DENSITY, youngs_modulus=YOUNG,
                                          position=points.T.copy(), directors=frames(edges))
        self.rod = link_inertia(rod)
        self.led = {node: [points[node].copy(), np.zeros(3)] for node in nodes}
        self.world.append(self.rod)
        self.world.constrain(self.rod).using(LedEnds, constrained_position_idx=tuple(nodes), led=self.led)
        self.world.dampen(self.rod).using(ea.AnalyticalLinearDamper, uniform_damping_constant=p.DRAG / MS,
                                          time_step=MS * h)

    def lead(self, seconds, velocities):
        for end, velocity in zip(self.led.values(), velocities):
            end[1][:] = velocity
        for _ in range(round(MS * seconds / self.h)):
            for place, velocity in self.led.values():
                place += self.h * velocity
            self.time = self.stepper.step(self.world, self.time, self.h)

    def pull(self):
        return float(np.linalg.norm(self.rod.internal_stress[:, -1])) / MILLINEWTON


def frames(edges):
    """Directors (3, 3, n) that follow the edges without twist."""
    tangents = edges / np.linalg.norm(edges, axis=1, keepdims=True)
    normal = np.cross(tangents[0], np.eye(3)[np.argmin(np.abs(tangents[0]))])
    made = np.empty((3, 3, len(edges)))
    for i, tangent in enumerate(tangents):
        normal = normal - (normal @ tangent) * tangent
        normal = normal / np.linalg.norm(normal)
        made[:, :, i] = normal, np.cross(tangent, normal), tangent
    return made


class Capstan(LedRod):
    # mN/mm: a chord of the first shape lies 0.05 mm inside, and a stiffer post throws it off. mN ms/mm, twice: below SLIP
    # friction is that of a viscous layer, which at PULL_SPEED must exceed Coulomb's.
    STIFFNESS, DAMPING, SLIP = 2e2, 0.1, 2e2

    def __init__(self, segments, h):
        self.set_points(p.capstan_points(segments), (segments,), h)
        z, x = np.array([0.0, 0.0, 1.0]), np.array([1.0, 0.0, 0.0])
        post = ea.Cylinder(-20.0 * z, z, x, 40.0, MM * p.CYLINDER, 1.0)
        self.world.append(post)
        self.world.constrain(post).using(ea.OneEndFixedBC, constrained_position_idx=(0,), constrained_director_idx=(0,))
        self.load = np.zeros(3)
        self.world.add_forcing_to(self.rod).using(EndLoad, load=self.load)
        self.world.detect_contact_between(self.rod, post).using(
            ea.RodCylinderContact, k=self.STIFFNESS, nu=self.DAMPING, velocity_damping_coefficient=self.SLIP,
            friction_coefficient=p.FRICTION)
        self.begin(h)

    def advance(self, seconds, load, speed):
        self.load[1] = -load * MILLINEWTON
        self.lead(seconds, [(0.0, -speed, 0.0)])


class Trefoil(LedRod):
    STIFFNESS, DAMPING = 4e4, 5.0

    def __init__(self, segments, h):
        self.set_points(p.trefoil_points(segments), (0, segments), h)
        self.world.detect_contact_between(self.rod, self.rod).using(ea.RodSelfContact, k=self.STIFFNESS, nu=self.DAMPING)
        self.begin(h)

    def advance(self, seconds, speed):
        self.lead(seconds, [(0.0, 0.0, -speed), (0.0, 0.0, speed)])
