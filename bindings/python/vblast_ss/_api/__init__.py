"""The C interface as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

from typing import Any

from . import adapter, base, baseline, collision, core_speed, device, drain, elementary, grasper, haptics, knot, mapping, metrics, mock, needle, output, record, replica, scene, scene_event, scene_geometry, scene_query, scene_settings, scene_surface, session, session_assistance, session_coaching, session_exercise, solver_options, thread, visual

FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {}
for _header in (adapter, base, baseline, collision, core_speed, device, drain, elementary, grasper, haptics, knot, mapping, metrics, mock, needle, output, record, replica, scene, scene_event, scene_geometry, scene_query, scene_settings, scene_surface, session, session_assistance, session_coaching, session_exercise, solver_options, thread, visual):
    FUNCTIONS.update(_header.FUNCTIONS)

__all__ = ["adapter", "base", "baseline", "collision", "core_speed", "device", "drain", "elementary", "grasper", "haptics", "knot", "mapping", "metrics", "mock", "needle", "output", "record", "replica", "scene", "scene_event", "scene_geometry", "scene_query", "scene_settings", "scene_surface", "session", "session_assistance", "session_coaching", "session_exercise", "solver_options", "thread", "visual", "FUNCTIONS"]
