"""The newest state of a scene for another thread."""
from __future__ import annotations

import ctypes
from typing import Any, NamedTuple

from ._api.base import vbss_view
from ._api.replica import (ReplicaField, ReplicaKind, ReplicaState, vbss_replica, vbss_replica_config,
                           vbss_replica_state)
from ._library import lib
from ._objects import Configured, Viewed, created
from ._values import initialised, value_of
from .errors import InvalidHandleError, check
from .scene import Scene
from .views import Array, array_of, empty_view

__all__ = ["Replica", "ReplicaBody", "ReplicaField", "ReplicaKind", "ReplicaState"]


class ReplicaBody(NamedTuple):
    """A body of a state: its rows of nodes, triangles and capsules. `number` is that of the body in its scene."""
    kind: ReplicaKind
    number: int
    nodes: slice
    triangles: slice
    capsules: slice


class Replica(Configured, Viewed):
    """Passes the newest state of a scene from the thread that steps it to one reader thread. The stepping thread
    publishes; the reader takes, and then uses the arrays until its next take. Neither waits for the other. Keywords
    are the settings of vbss_replica_config (Replica.settings_help(), Replica.defaults())."""
    _prefix, _noun = "vbss_replica", "replica"
    _config, _init, _fields = vbss_replica_config, "vbss_replica_config_init", ReplicaField

    def __init__(self, scene: Scene, **settings: Any) -> None:
        if not isinstance(scene, Scene):
            raise TypeError(f"a replica is of a Scene, not of {type(scene).__name__}")
        config = initialised(vbss_replica_config, lib.vbss_replica_config_init, settings, "a replica")
        super().__init__(scene.context, created(scene.context, vbss_replica, lib.vbss_replica_create, scene._handle,
                                                ctypes.byref(config)))

    def publish(self, scene: Scene) -> None:
        """Publishes the state of a scene of the same context. For the stepping thread."""
        if not isinstance(scene, Scene):
            raise TypeError(f"a replica is of a Scene, not of {type(scene).__name__}")
        self._call(lib.vbss_replica_publish, scene._handle)

    def take(self) -> ReplicaState:
        """Takes the newest state. For the reader thread, also while the stepping thread is in a call."""
        state = vbss_replica_state()
        check(lib.vbss_replica_take(self._open(), ctypes.byref(state), ctypes.sizeof(state)))
        return value_of(ReplicaState, state)

    def _open(self) -> Any:
        if self.closed:
            raise InvalidHandleError("the replica is closed")
        return self._handle

    def _look(self, field: int) -> tuple[vbss_view, Array]:  # without the lock of the context, which a step may have
        view, size = empty_view()
        check(lib.vbss_replica_get_view(self._open(), field, ctypes.byref(view), size))
        return view, array_of(self._context._memory, view)

    @property
    def bodies(self) -> list[ReplicaBody]:
        """Bodies of the state, in the order of the rows of poses and sizes."""
        return [ReplicaBody(ReplicaKind(kind), number, slice(node, node + nodes), slice(triangle, triangle + triangles),
                            slice(capsule, capsule + capsules))
                for kind, number, node, nodes, triangle, triangles, capsule, capsules
                in self._array(ReplicaField.BODIES).tolist()]

    def array(self, field: ReplicaField) -> Array:
        """One of the arrays of the state: ReplicaField says what each has. It shows this state until the next take."""
        return self._array(int(ReplicaField(field)))

    def _describe(self) -> str:
        return f"state {self._look(ReplicaField.BODIES)[0].generation}"
