"""Scenes: bodies that touch, rub and are stepped together."""
from __future__ import annotations

import ctypes
from typing import Any, Callable, Iterable, NamedTuple, Optional, Sequence, TypeVar, Union, cast

from ._api.base import Method, Result
from ._api.baseline import BaselineStatistics, vbss_baseline_statistics
from ._api.scene import (SceneBlocker, SceneBlockerCause, SceneContactKind, SceneGrasp, SceneHole, SceneOverlap, SceneOverlapPolicy, SceneRigidKind,
                         SceneRigidState, SceneField, SceneMode, SceneStatistics, vbss_scene_blocker, vbss_scene_capsule, vbss_scene_grasp, vbss_scene_hole,
                         vbss_scene_overlap, vbss_scene_rigid_config, vbss_scene_rigid_state, vbss_scene, vbss_scene_config,
                         vbss_scene_statistics)
from ._api.drain import vbss_drain
from ._api.grasper import vbss_grasper
from ._api.needle import vbss_needle
from ._api.scene_event import SceneEventFlagBits, SceneEventKind, vbss_scene_event
from ._api.scene_query import SceneBodyInfo, SceneBodyKind, SceneNearest, SceneRayHit, vbss_scene_body_info, vbss_scene_nearest, vbss_scene_ray_hit
from ._api.scene_geometry import vbss_scene_distance_field_config, vbss_scene_height_field_config, vbss_scene_plane_config, vbss_scene_static_mesh_config
from ._api.scene_surface import (SceneSurfaceField, vbss_scene_hole_place, vbss_scene_place_hole_fn,
                                 vbss_scene_surface_config)
from ._api.thread import vbss_thread
from ._library import lib
from ._objects import Configured, Object, Saved, Viewed, context_or_new, created
from ._values import constant_of, data_of, doubles, index, initialised, numbers, optional
from .context import Context
from .drain import Drain
from .errors import NotFoundError
from .grasper import Grasper
from .needle import Needle
from .thread import Thread
from .views import Array, array_of, empty_view

__all__ = ["BaselineStatistics", "SceneBlocker", "SceneBlockerCause", "SceneBodyInfo", "SceneBodyKind", "Capsule", "Contact", "SceneContactKind", "Event", "SceneEventKind", "SceneGrasp", "SceneHole", "Method",
           "SceneNearest", "SceneOverlap", "SceneOverlapPolicy", "SceneRayHit", "SceneRigidKind", "SceneRigidState", "Scene", "SceneField", "SceneMode", "SceneStatistics", "SceneSurfaceField"]

Body = Union[Thread, Drain, Needle, Grasper]
S = TypeVar("S", bound="Scene")
NO_PLACE = int(Result.ERROR_NOT_FOUND)


class Capsule(NamedTuple):
    """One capsule of a rigid body, in the frame of the body, m. Equal ends: a ball."""
    begin: Sequence[float]
    end: Sequence[float]
    radius: float


class Event(NamedTuple):
    """Something that happened in a scene. SceneEventKind and scene_event.h say what each kind has."""
    kind: SceneEventKind
    body_a: int
    body_b: int
    id: int
    step: int
    """Statistics.steps after the step that reported it."""
    time: float
    """s."""
    value: float
    """In the unit of the kind: N, s or m."""
    arc_length: float
    """m."""
    position: Optional[tuple[float, float, float]]
    """m; None: the event has no position."""


_EVENTS_AT_A_TIME = 256
_HANDLES: dict[int, tuple[type[Object], Any, Any]] = {
    SceneBodyKind.DRAIN: (Drain, lib.vbss_scene_get_drain, vbss_drain),
    SceneBodyKind.NEEDLE: (Needle, lib.vbss_scene_get_needle, vbss_needle),
    SceneBodyKind.GRASPER: (Grasper, lib.vbss_scene_get_grasper, vbss_grasper)}
"""Of bodies by kind: their class, and how a handle is had. Threads have thread()."""


def _event(kind: Callable[[int], Any], found: vbss_scene_event) -> Event:
    has_position = found.flags & SceneEventFlagBits.POSITION
    x, y, z = found.position
    return Event(kind(found.kind), found.body_a, found.body_b, found.id, found.step, found.time, found.value,
                 found.arc_length, (x, y, z) if has_position else None)


class Contact(NamedTuple):
    """Which features touch. The other arrays of contacts are in the same order."""
    kind: SceneContactKind
    body_a: int
    feature_a: int
    body_b: int
    feature_b: int


def _rows(array: Array) -> list[list[int]]:
    rows: list[list[int]] = array.tolist()
    return rows


class Scene(Configured, Viewed, Saved):
    """Bodies and a floor, stepped as one system. Bodies are numbered from 1 on; 0 is the world.

    Keywords are the settings of vbss_scene_config (Scene.settings_help(), Scene.defaults()). Threads, drains,
    needles and graspers that were added stay usable for looking and telling; they come back with remove(), or
    when the scene is closed.
    """
    _prefix, _noun = "vbss_scene", "scene"
    _config, _init, _fields = vbss_scene_config, "vbss_scene_config_init", SceneField

    def __init__(self, context: Optional[Context] = None, **settings: Any) -> None:
        context = context_or_new(context)
        config = initialised(vbss_scene_config, lib.vbss_scene_config_init, settings, "a scene")
        self._bodies: dict[int, Object] = {}
        self._lost_events = 0
        super().__init__(context, created(context, vbss_scene, lib.vbss_scene_create, context._handle,
                                          ctypes.byref(config)))

    @classmethod
    def load(cls: type[S], state: Any, context: Optional[Context] = None) -> S:
        """The scene of saved bytes (save()), with its bodies, which belong to it and end with it."""
        context = context_or_new(context)
        data = data_of(state, "state")
        return cls._of(context, created(context, vbss_scene, lib.vbss_scene_load, context._handle, data, len(data)))

    @classmethod
    def _of(cls: type[S], context: Context, handle: Any) -> S:
        scene = super()._of(context, handle)
        scene._bodies = {}
        scene._lost_events = 0
        return scene

    def __reduce__(self) -> Any:
        """State, context, and what else was stored in the object. Events that were not taken, user data, and an attached
        record are no part of a copy."""
        others = {name: value for name, value in vars(self).items() if name not in ("_context", "_handle", "_bodies")}
        return type(self).load, (self.save(), self._context), others

    def close(self) -> None:
        super().close()
        self._bodies.clear()

    # ---- bodies

    def add(self, body: Body) -> int:
        """Adds a Thread, Drain, Needle or Grasper of the same context; returns its number."""
        functions = {Thread: lib.vbss_scene_add_thread, Drain: lib.vbss_scene_add_drain,
                     Needle: lib.vbss_scene_add_needle, Grasper: lib.vbss_scene_add_grasper}
        for kind, function in functions.items():
            if isinstance(body, kind):
                number = ctypes.c_uint32()
                if body.closed:
                    body._refuse()
                self._call(function, body._handle, ctypes.byref(number))
                self._bodies[number.value] = body
                return number.value
        raise TypeError(f"a scene takes threads, drains, needles and graspers, not {type(body).__name__}")

    def add_rigid(self, capsules: Iterable[Any], **settings: Any) -> int:
        """Adds a rigid body of capsules (begin, end, radius); returns its number. `kind` is "driven" (default),
        "coupled" or "free"; other keywords as in vbss_scene_rigid_config."""
        listed = [Capsule(*one) for one in capsules]
        array = (vbss_scene_capsule * max(1, len(listed)))()
        for struct, one in zip(array, listed):
            struct.begin[:] = doubles(one.begin, "begin of a capsule", 3)
            struct.end[:] = doubles(one.end, "end of a capsule", 3)
            struct.radius = one.radius
        config = initialised(vbss_scene_rigid_config, lib.vbss_scene_rigid_config_init, settings, "a rigid body")
        config.capsule_count, config.capsules = len(listed), array
        number = ctypes.c_uint32()
        self._call(lib.vbss_scene_add_rigid, ctypes.byref(config), ctypes.byref(number))
        return number.value

    def add_static_mesh(self, vertices: Any, triangles: Any, **settings: Any) -> int:
        """Adds a mesh that never moves; returns its number. `vertices` (n x 3, m), `triangles` (m x 3 vertices);
        keywords as in vbss_scene_static_mesh_config: friction, thickness."""
        points = doubles(vertices, "vertices", row=3)
        corners = numbers(triangles, ctypes.c_uint32, "triangles", row=3)
        config = initialised(vbss_scene_static_mesh_config, lib.vbss_scene_static_mesh_config_init, settings, "a static mesh")
        config.vertex_count, config.vertices = len(points) // 3, points
        config.triangle_count, config.triangles = len(corners) // 3, corners
        number = ctypes.c_uint32()
        self._call(lib.vbss_scene_add_static_mesh, ctypes.byref(config), ctypes.byref(number))
        return number.value

    def add_rigid_mesh(self, vertices: Any, triangles: Any, *, thickness: float | None = None, friction: float | None = None,
                       **motion: Any) -> int:
        """Adds a rigid body whose shape is a mesh; returns its number. `vertices` (n x 3, m, in the frame of the body),
        `triangles` (m x 3 vertices). `kind` is "driven" (default), "coupled" or "free"; other keywords as in
        vbss_scene_rigid_config: position, orientation, mass, gravity, stiffness."""
        points = doubles(vertices, "vertices", row=3)
        corners = numbers(triangles, ctypes.c_uint32, "triangles", row=3)
        config = initialised(vbss_scene_rigid_config, lib.vbss_scene_rigid_config_init, motion, "a rigid mesh")
        shape = {name: value for name, value in (("thickness", thickness), ("friction", friction)) if value is not None}
        geometry = initialised(vbss_scene_static_mesh_config, lib.vbss_scene_static_mesh_config_init, shape, "a rigid mesh")
        geometry.vertex_count, geometry.vertices = len(points) // 3, points
        geometry.triangle_count, geometry.triangles = len(corners) // 3, corners
        number = ctypes.c_uint32()
        self._call(lib.vbss_scene_add_rigid_mesh, ctypes.byref(config), ctypes.byref(geometry), ctypes.byref(number))
        return number.value

    def add_height_field(self, heights: Any, **settings: Any) -> int:
        """Adds a static mesh of heights (rows x columns, m) along y; returns its number. Columns are along x, rows along
        z; keywords as in vbss_scene_height_field_config: spacing, position, orientation, friction."""
        rows = [doubles(row, "a row of heights") for row in heights]
        if len({len(row) for row in rows}) != 1:
            raise ValueError("heights: the rows differ in length, or there are none")
        values = doubles([value for row in rows for value in row], "heights")
        config = initialised(vbss_scene_height_field_config, lib.vbss_scene_height_field_config_init, settings, "a height field")
        config.row_count, config.column_count, config.height_count = len(rows), len(rows[0]), len(values)
        config.heights = values
        number = ctypes.c_uint32()
        self._call(lib.vbss_scene_add_height_field, ctypes.byref(config), ctypes.byref(number))
        return number.value

    def add_distance_field(self, distances: Any, counts: tuple[int, int, int], **settings: Any) -> int:
        """Adds the surface of a solid as a static mesh; returns its number. `distances`: from the surface, m, negative
        inside, at the points of a grid with `counts` points along x, y and z, x fastest; keywords as in
        vbss_scene_distance_field_config: spacing, position, orientation, friction, thickness."""
        values = doubles(distances, "distances")
        config = initialised(vbss_scene_distance_field_config, lib.vbss_scene_distance_field_config_init, settings,
                             "a distance field")
        config.counts[:] = [index(count) for count in counts]
        config.distance_count, config.distances = len(values), values
        number = ctypes.c_uint32()
        self._call(lib.vbss_scene_add_distance_field, ctypes.byref(config), ctypes.byref(number))
        return number.value

    def add_plane(self, normal: Any = (0.0, 1.0, 0.0), height: float = 0.0, friction: float = 0.3) -> int:
        """Adds a plane that never moves, like the floor; returns its number. `normal`: out of the half-space below it;
        `height`: along the normal, m."""
        config = initialised(vbss_scene_plane_config, lib.vbss_scene_plane_config_init,
                             {"normal": normal, "height": height, "friction": friction}, "a plane")
        number = ctypes.c_uint32()
        self._call(lib.vbss_scene_add_plane, ctypes.byref(config), ctypes.byref(number))
        return number.value

    def add_surface(self, vertices: Any, triangles: Any, **settings: Any) -> int:
        """Adds a mesh whose vertices the host moves; returns its number. `vertices` (n x 3, m), `triangles` (m x 3
        vertices); keywords as in vbss_scene_surface_config: friction, thickness, jump_limit,
        compliance_size."""
        points = doubles(vertices, "vertices", row=3)
        corners = numbers(triangles, ctypes.c_uint32, "triangles", row=3)
        config = initialised(vbss_scene_surface_config, lib.vbss_scene_surface_config_init, settings, "a host surface")
        config.vertex_count, config.vertices = len(points) // 3, points
        config.triangle_count, config.triangles = len(corners) // 3, corners
        number = ctypes.c_uint32()
        self._call(lib.vbss_scene_add_surface, ctypes.byref(config), ctypes.byref(number))
        return number.value

    def move_surface(self, body: int, vertices: Any) -> None:
        """Positions of the vertices of a host surface at the end of the next step (n x 3, m)."""
        points = doubles(vertices, "vertices", row=3)
        self._call(lib.vbss_scene_move_surface, index(body), points, len(points) // 3)

    def remesh_surface(self, body: int, vertices: Any, triangles: Any,
                       place: Optional[Callable[[vbss_scene_hole_place], Optional[tuple[int, Any]]]] = None) -> None:
        """Gives a host surface another mesh: `vertices` (n x 3, m), `triangles` (m x 3 vertices). Its holes stay. `place`
        gets the fields of vbss_scene_hole_place (hole, triangle, weights, position, normal) for each hole, and returns a
        triangle of the new mesh with three weights, or None for the nearest place. What it raises refuses the mesh."""
        points = doubles(vertices, "vertices", row=3)
        corners = numbers(triangles, ctypes.c_uint32, "triangles", row=3)

        def ask(user: Any, hole: Any, triangle: Any, weights: Any) -> int:
            def work() -> int:
                assert place is not None
                found = place(hole.contents)
                if found is not None:
                    triangle[0] = index(found[0])
                    weights[0], weights[1], weights[2] = doubles(found[1], "weights", 3)
                return 0

            return int(self._context._guarded(NO_PLACE, work))

        entry = ctypes.cast(0, vbss_scene_place_hole_fn) if place is None else vbss_scene_place_hole_fn(ask)
        self._call(lib.vbss_scene_remesh_surface, index(body), points, len(points) // 3, corners, len(corners) // 3, entry,
                   None)

    def set_surface_compliance(self, body: int, compliance: Any) -> None:
        """How far each vertex of a host surface gives way to a force, m/N: a number for each vertex, or the nine numbers
        of a symmetric matrix, as compliance_size was when it was added."""
        values = doubles(compliance, "compliance")
        self._call(lib.vbss_scene_set_surface_compliance, index(body), values, len(values))

    def surface(self, body: int, field: SceneSurfaceField = SceneSurfaceField.FORCES) -> Array:
        """One of the arrays of a host surface, n x 3: SceneSurfaceField says what each has."""
        view, size = empty_view()
        with self._context._lock:  # nothing is given back between the two
            self._call(lib.vbss_scene_get_surface_view, index(body), int(SceneSurfaceField(field)), ctypes.byref(view), size)
            return array_of(self._context._memory, view)

    def remove(self, body: int) -> None:
        """Removes a body, with its pins and grasps; what was added is the caller's again."""
        self._call(lib.vbss_scene_remove, index(body))
        self._bodies.pop(body, None)

    def body(self, number: int) -> Object:
        """The thread, drain, needle or grasper of a number, also in a scene that was loaded, and a piece that was cut."""
        found = self._bodies.get(number)
        if found is not None and not isinstance(found, Thread):
            return found
        kind = self.body_info(number).kind
        if kind not in _HANDLES:
            return self.thread(number)
        made, function, struct = _HANDLES[kind]
        handle = ctypes.POINTER(struct)()
        self._call(function, index(number), ctypes.byref(handle))
        self._bodies[number] = made._of(self._context, handle)
        return self._bodies[number]

    def thread(self, body: int) -> Thread:
        """A thread in the scene, also a piece that was cut."""
        handle = ctypes.POINTER(vbss_thread)()
        self._call(lib.vbss_scene_get_thread, index(body), ctypes.byref(handle))
        known = self._bodies.get(body)
        if isinstance(known, Thread) and known._handle is not None and \
                ctypes.addressof(known._handle.contents) == ctypes.addressof(handle.contents):
            return known
        thread = Thread._of(self._context, handle)
        self._bodies[body] = thread
        return thread

    def set_rigid_target(self, body: int, position: Sequence[float], orientation: Optional[Sequence[float]] = None) -> None:
        """Says where a driven or coupled body shall be at the end of the next step."""
        self._call(lib.vbss_scene_set_rigid_target, index(body), doubles(position, "position", 3),
                   optional(orientation, "orientation", 4))

    def rigid(self, body: int) -> SceneRigidState:
        """Where a rigid body is and what acts on it."""
        return self._read("get_rigid", SceneRigidState, vbss_scene_rigid_state, index(body))

    def pin_thread(self, thread: int, node: int, body: int = 0, point: Optional[Sequence[float]] = None) -> int:
        """Pins a node of a thread to a rigid body, or to the world (0); returns the pin's name. Without a point,
        where the node is now."""
        pin = ctypes.c_uint32()
        self._call(lib.vbss_scene_pin_thread, index(thread), index(node), index(body), optional(point, "point", 3),
                   ctypes.byref(pin))
        return pin.value

    def unpin_thread(self, pin: int) -> None:
        self._call(lib.vbss_scene_unpin_thread, index(pin))

    def cut_thread(self, thread: int, arc_length: float) -> int:
        """Cuts a thread where it lies; returns the number of the piece (see thread())."""
        piece = ctypes.c_uint32()
        self._call(lib.vbss_scene_cut_thread, index(thread), arc_length, ctypes.byref(piece))
        return piece.value

    def make_hole(self, body: int, arc_length: float, drain: int, triangle: int, weights: Sequence[float]) -> int:
        """Makes a hole where a thread or a needle already goes through the wall of a drain, near an arc length of it,
        m, at a place in a triangle; returns the hole's name. From then on it is as if a needle had made it."""
        name = ctypes.c_uint32()
        self._call(lib.vbss_scene_make_hole, index(body), arc_length, index(drain), index(triangle),
                   doubles(weights, "weights", 3), ctypes.byref(name))
        return name.value

    # ---- changes of a running scene

    def set_gravity(self, gravity: Sequence[float], body: int = 0) -> None:
        """Sets the gravitational acceleration, m/s^2, of a body; 0: of all bodies that no hand carries."""
        self._call(lib.vbss_scene_set_gravity, index(body), doubles(gravity, "gravity", 3))

    def set_friction(self, body: int, friction: float) -> None:
        """Sets the coefficient of friction of a body that is no thread, or of the floor (0)."""
        self._call(lib.vbss_scene_set_friction, index(body), friction)

    def set_thread_friction(self, friction: float) -> None:
        """Sets the coefficient of friction between threads."""
        self._call(lib.vbss_scene_set_thread_friction, friction)

    def set_coupling(self, body: int, stiffness: float, damping: float, turning_stiffness: float,
                     turning_damping: float) -> None:
        """Sets the virtual coupling of a coupled body: N/m, N s/m, N m/rad, N m s/rad."""
        self._call(lib.vbss_scene_set_coupling, index(body), stiffness, damping, turning_stiffness, turning_damping)

    def set_speed_limit(self, limit: float) -> None:
        """Sets the largest speed towards a target, m/s; 0: no limit."""
        self._call(lib.vbss_scene_set_speed_limit, limit)

    def set_budgets(self, step_budget_us: float = 500.0, call_budget_us: float = 420.0,
                    operations_per_us: float = 500.0) -> None:
        """Sets the budgets of a step and of a call, us of a core of that speed; 0: no limit."""
        self._call(lib.vbss_scene_set_budgets, step_budget_us, call_budget_us, operations_per_us)

    def set_filter(self, body: int, category: int = 1, mask: int = 0xffffffff) -> None:
        """Sets the contact filter of a body, or of the floor (0): two bodies collide if each has a category that the
        mask of the other contains."""
        self._call(lib.vbss_scene_set_filter, index(body), index(category), index(mask))

    def apply_force(self, body: int, force: Sequence[float], point: Optional[Sequence[float]] = None,
                    torque: Optional[Sequence[float]] = None) -> None:
        """Applies a force, N, at a point of the world (default: the centre of mass), and a torque, N m, for the next
        step."""
        self._call(lib.vbss_scene_apply_force, index(body), doubles(force, "force", 3), optional(point, "point", 3),
                   optional(torque, "torque", 3))

    def set_rigid_velocity(self, body: int, velocity: Sequence[float],
                           angular_velocity: Optional[Sequence[float]] = None) -> None:
        """Sets the velocity, m/s, and the angular velocity, rad/s, of a free body."""
        self._call(lib.vbss_scene_set_rigid_velocity, index(body), doubles(velocity, "velocity", 3),
                   optional(angular_velocity, "angular_velocity", 3))

    def set_rigid_pose(self, body: int, position: Sequence[float],
                       orientation: Optional[Sequence[float]] = None) -> None:
        """Moves a free body to a pose at once."""
        self._call(lib.vbss_scene_set_rigid_pose, index(body), doubles(position, "position", 3),
                   optional(orientation, "orientation", 4))

    # ---- bodies by number, and queries

    @property
    def bodies(self) -> list[int]:
        """The numbers of all bodies, in ascending order."""
        count = ctypes.c_uint32()
        self._call(lib.vbss_scene_get_bodies, None, 0, ctypes.byref(count))
        numbers = (ctypes.c_uint32 * max(1, count.value))()
        self._call(lib.vbss_scene_get_bodies, numbers, count.value, ctypes.byref(count))
        return list(numbers[:count.value])

    def body_info(self, body: int) -> SceneBodyInfo:
        """Kind, filter, friction and gravity of a body, or of the floor (0)."""
        return self._read("get_body", SceneBodyInfo, vbss_scene_body_info, index(body))

    def _handle_of(self, function: Any, struct: Any, body: int) -> int:
        """The address of the handle of a body of one kind."""
        handle = ctypes.POINTER(struct)()
        self._call(function, index(body), ctypes.byref(handle))
        return ctypes.addressof(handle.contents)

    def drain_handle(self, body: int) -> int:
        """The address of a drain's handle, for other code that uses the C library."""
        return self._handle_of(lib.vbss_scene_get_drain, vbss_drain, body)

    def needle_handle(self, body: int) -> int:
        """The address of a needle's handle, for other code that uses the C library."""
        return self._handle_of(lib.vbss_scene_get_needle, vbss_needle, body)

    def grasper_handle(self, body: int) -> int:
        """The address of a grasper's handle, for other code that uses the C library."""
        return self._handle_of(lib.vbss_scene_get_grasper, vbss_grasper, body)

    def set_user_data(self, body: int, data: int) -> None:
        """Stores an integer of the size of a pointer with a body; no part of the state."""
        self._call(lib.vbss_scene_set_user_data, index(body), ctypes.c_void_p(data))

    def user_data(self, body: int) -> int:
        """The integer that set_user_data has stored, or 0."""
        data = ctypes.c_void_p()
        self._call(lib.vbss_scene_get_user_data, index(body), ctypes.byref(data))
        return data.value or 0

    def cast_ray(self, origin: Sequence[float], translation: Sequence[float], mask: int = 0xffffffff) -> SceneRayHit:
        """The first surface on a ray, of bodies with a category of the mask."""
        return self._read("cast_ray", SceneRayHit, vbss_scene_ray_hit, doubles(origin, "origin", 3),
                          doubles(translation, "translation", 3), index(mask))

    def find_nearest(self, point: Sequence[float], radius: float, mask: int = 0xffffffff) -> SceneNearest:
        """The body whose surface is nearest to a point, within a radius."""
        return self._read("find_nearest", SceneNearest, vbss_scene_nearest, doubles(point, "point", 3), radius, index(mask))

    @staticmethod
    def memory(context: Optional[Context] = None, **settings: Any) -> int:
        """Bytes that a scene of these settings takes before bodies are added."""
        config = initialised(vbss_scene_config, lib.vbss_scene_config_init, settings, "a scene")
        number = ctypes.c_uint64()
        owner = context_or_new(context)
        owner._call(lib.vbss_scene_config_get_memory, owner._handle, ctypes.byref(config), ctypes.byref(number))
        return number.value

    def prepare(self) -> None:
        """Does the work of the next step that does not depend on contacts."""
        self._call(lib.vbss_scene_prepare)

    def step(self, h: float = 1e-3) -> None:
        """Moves everything forward by h seconds."""
        self._call(lib.vbss_scene_step, h)

    # ---- what there is to see

    def grasp(self, tool: int, number: int = 0) -> SceneGrasp:
        """One of the places that a grasper holds."""
        return self._read("get_grasp", SceneGrasp, vbss_scene_grasp, index(tool), index(number))

    def grasps(self, tool: int) -> list[SceneGrasp]:
        """All of them."""
        self.grasper_handle(tool)  # fails unless the body is a grasper
        grasper = cast(Grasper, self.body(tool))
        return [self.grasp(tool, number) for number in range(grasper.state.grasp_count)]

    def overlap(self, body: int) -> SceneOverlap:
        """The deepest overlap of a body with another body or the floor, where they are now."""
        return self._read("get_overlap", SceneOverlap, vbss_scene_overlap, index(body))

    def hole(self, number: int) -> SceneHole:
        """One of the holes of needles and threads in drains."""
        return self._read("get_hole", SceneHole, vbss_scene_hole, index(number))

    @property
    def holes(self) -> list[SceneHole]:
        """All of them."""
        return self._read_all(self.hole)

    def blocker(self, number: int) -> SceneBlocker:
        """One of the pairs of bodies that hold back others."""
        return self._read("get_blocker", SceneBlocker, vbss_scene_blocker, index(number))

    @property
    def blockers(self) -> list[SceneBlocker]:
        """All of them."""
        return self._read_all(self.blocker)

    def _read_all(self, read: Callable[[int], Any]) -> list[Any]:
        """Reads by number until there is no further one."""
        found: list[Any] = []
        with self._context._lock:
            self._context._quiet = True  # where they end is told by a failure
            try:
                while True:
                    found.append(read(len(found)))
            except NotFoundError:
                return found
            finally:
                self._context._quiet = False

    @property
    def contacts(self) -> list[Contact]:
        """Which features touched at the end of the last step."""
        return [Contact(SceneContactKind(kind), *rest) for kind, *rest in _rows(self.contact_features)]

    @property
    def contact_features(self) -> Array:
        """n x 5: ContactKind, body a, feature a, body b, feature b."""
        return self._array(SceneField.CONTACTS)

    @property
    def contact_points(self) -> Array:
        """n x 3, m: between the two surfaces."""
        return self._array(SceneField.CONTACT_POINTS)

    @property
    def contact_normals(self) -> Array:
        """n x 3, unit, from b to a."""
        return self._array(SceneField.CONTACT_NORMALS)

    @property
    def contact_forces(self) -> Array:
        """n x 3, N: of b on a."""
        return self._array(SceneField.CONTACT_FORCES)

    @property
    def contact_gaps(self) -> Array:
        """n, m: distance of the surfaces, negative when they overlap."""
        return self._array(SceneField.CONTACT_GAPS)

    def take_events(self) -> list[Event]:
        """Takes all events since the last call, oldest first. At most event_capacity are kept between two calls;
        lost_events counts the older ones that were lost."""
        found: list[Event] = []
        events, count, lost = (vbss_scene_event * _EVENTS_AT_A_TIME)(), ctypes.c_uint32(), ctypes.c_uint64()
        kind = constant_of(SceneEventKind)
        while True:
            self._call(lib.vbss_scene_take_events, events, ctypes.sizeof(vbss_scene_event), _EVENTS_AT_A_TIME,
                       ctypes.byref(count), ctypes.byref(lost))
            self._lost_events += lost.value
            found += [_event(kind, event) for event in events[:count.value]]
            if count.value < _EVENTS_AT_A_TIME:
                return found

    @property
    def lost_events(self) -> int:
        """Events that were lost so far because more than event_capacity had not been taken."""
        return self._lost_events

    @property
    def statistics(self) -> SceneStatistics:
        return self._read("get_statistics", SceneStatistics, vbss_scene_statistics)

    @property
    def baseline_statistics(self) -> BaselineStatistics:
        """What only a scene of method "vblast" counts; error "incompatible" for another method."""
        return self._read("get_baseline_statistics", BaselineStatistics, vbss_baseline_statistics)

    def _describe(self) -> str:
        numbers = self.statistics
        return f"{len(self._bodies)} bodies added, {numbers.contacts} contacts, t = {numbers.time:.6g} s"
