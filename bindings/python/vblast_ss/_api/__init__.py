"""The C interface as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

from typing import Any

from . import base, collision, device, drain, grasper, knot, metrics, needle, record, scene, thread, visual

FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {}
for _header in (base, collision, device, drain, grasper, knot, metrics, needle, record, scene, thread, visual):
    FUNCTIONS.update(_header.FUNCTIONS)

__all__ = ["base", "collision", "device", "drain", "grasper", "knot", "metrics", "needle", "record", "scene", "thread", "visual", "FUNCTIONS"]
