"""The elementary functions: those of the library, near to those of math, and special values."""
import math

import pytest

import vblast_ss as vb
from vblast_ss import elementary

ANGLES = [0.0, 1e-300, 0.3, -0.3, 1.0, 1.5707963267948966, 3.0, -7.5, 1e6, 1e22]


@pytest.mark.parametrize("name", ["sin", "cos"])
def test_sines_are_those_of_math_to_the_last_bit_but_one(name):
    for angle in ANGLES:
        exact = getattr(math, name)(angle)
        assert abs(getattr(elementary, name)(angle) - exact) <= math.ulp(exact)
    assert math.isnan(getattr(elementary, name)(math.inf))


def test_angles_are_those_of_math_to_the_last_bit_but_one():
    for y in ANGLES:
        for x in (-2.0, -0.5, 0.0, 1.0, 1e10):
            exact = math.atan2(y, x)
            assert abs(elementary.atan2(y, x) - exact) <= math.ulp(exact)
    assert math.copysign(1.0, elementary.atan2(-0.0, 1.0)) == -1.0 and elementary.atan2(-0.0, -1.0) == -math.pi
    for cosine in (-1.0, -0.7, 0.0, 0.2, 0.999, 1.0):
        assert abs(elementary.acos(cosine) - math.acos(cosine)) <= math.ulp(math.acos(cosine))
    assert math.isnan(elementary.acos(1.5)) and math.isnan(elementary.acos(math.nan))


def test_they_take_no_texts():
    with pytest.raises(vb._library.ctypes.ArgumentError):
        elementary.sin("1")
