"""The measured speed of the core, and the limits of work that fit it."""
import itertools

import pytest
import vblast_ss as vb


def ticking(step):
    ticks = itertools.count()
    return lambda: step * next(ticks)


def test_slow_clock_is_a_slow_core():
    with vb.Context() as context:
        usual, slow = (vb.budget_speed(context, ticking(step)) for step in (2.0**-11, 2.0**-9))
    assert usual.operations_per_microsecond == 4 * slow.operations_per_microsecond > 0
    assert usual.steps == 48 and usual.spread == 1.0 and usual.duration == 48 * 2.0**-11


def test_bad_clocks_are_refused():
    class Broken(Exception):
        pass

    def broken():
        raise Broken

    with vb.Context() as context:
        with pytest.raises(vb.ClockStoppedError):
            vb.budget_speed(context, lambda: 1.0)
        with pytest.raises(vb.ClockJumpedError):
            vb.budget_speed(context, ticking(-1e-3))
        tick = ticking(2.0**-11)
        with pytest.raises(vb.ClockCoarseError):
            vb.budget_speed(context, lambda: 0.01 * (tick() // 0.01))
        with pytest.raises(vb.NotFiniteError):
            vb.budget_speed(context, lambda: float("inf"))
        with pytest.raises(Broken):
            vb.budget_speed(context, broken)


def test_limits_fit_the_speed():
    assert vb.fitted_limits(336) == {"step_budget": 200000, "call_budget": 168000}
    assert vb.fitted_limits(1e4) == {"step_budget": 250000, "call_budget": 210000}
    assert vb.fitted_limits(1e4, share=0.042, allows_more=1) == {"step_budget": 500000, "call_budget": 420000}
    assert vb.fitted_limits(1) == {"step_budget": 50000, "call_budget": 42000}
    with pytest.raises(vb.OutOfRangeError):
        vb.fitted_limits(0)
    with vb.Scene(**vb.fitted_limits(168, slot=0.5e-3)) as scene:
        scene.step()
