"""Sine, cosine and their inverses with the same bits on every machine, which those of math and numpy do not have.

Hands that compute their ways with these, with + - * /, and with math.sqrt are the same everywhere. Sums need a written
order too: numpy's @ and sum, and Python's sum, have others on other processors and versions."""
from __future__ import annotations

from ._library import lib

__all__ = ["acos", "atan2", "cos", "sin"]


def sin(angle: float) -> float:
    """Of an angle, rad."""
    sine: float = lib.vbss_sin(angle)
    return sine


def cos(angle: float) -> float:
    """Of an angle, rad."""
    cosine: float = lib.vbss_cos(angle)
    return cosine


def atan2(y: float, x: float) -> float:
    """The angle of a point in the plane, rad, -pi to pi."""
    angle: float = lib.vbss_atan2(y, x)
    return angle


def acos(cosine: float) -> float:
    """The angle, rad, 0 to pi; NaN outside -1 to 1."""
    angle: float = lib.vbss_acos(cosine)
    return angle
