"""elementary.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import c_double
from typing import Any


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_sin": (c_double, (c_double,)),
    "vbss_cos": (c_double, (c_double,)),
    "vbss_atan2": (c_double, (c_double, c_double)),
    "vbss_acos": (c_double, (c_double,)),
}
