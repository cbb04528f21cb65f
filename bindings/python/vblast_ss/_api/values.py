"""Struct -> the tuple with names that its contents become. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

from typing import Any

VALUES: dict[Any, Any] = {}
