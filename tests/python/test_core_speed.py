"""The measured speed of the core, and the budgets for which it counts."""
import itertools

import pytest
import vblast_ss as vb


def ticking(step):
    ticks = itertools.count()
    return lambda: step * next(ticks)


def test_slow_clock_is_a_slow_core():
    with vb.Context() as context:
        usual, slow = (vb.measure_core_speed(context, ticking(step)) for step in (2.0**-11, 2.0**-9))
    assert usual.operations_per_us == 4 * slow.operations_per_us > 0
    assert usual.steps == 48 and usual.spread == 1.0 and usual.duration == 48 * 2.0**-11


def test_bad_clocks_are_refused():
    class Broken(Exception):
        pass

    def broken():
        raise Broken

    with vb.Context() as context:
        with pytest.raises(vb.ClockStoppedError):
            vb.measure_core_speed(context, lambda: 1.0)
        with pytest.raises(vb.ClockJumpedError):
            vb.measure_core_speed(context, ticking(-1e-3))
        tick = ticking(2.0**-11)
        with pytest.raises(vb.ClockCoarseError):
            vb.measure_core_speed(context, lambda: 0.01 * (tick() // 0.01))
        with pytest.raises(vb.NotFiniteError):
            vb.measure_core_speed(context, lambda: float("inf"))
        with pytest.raises(Broken):
            vb.measure_core_speed(context, broken)


def test_measured_speed_is_an_option_of_the_solver():
    with vb.Context() as context:
        speed = vb.measure_core_speed(context, ticking(2.0**-11)).operations_per_us
        scene = vb.Scene(context, solver={"operations_per_us": speed, "call_budget_us": 300.0})
        record = vb.Record(scene)
        scene.step()
        record.end()
        kept = vb.Replay(record.take(), context).scene_settings["solver"]
        assert kept["operations_per_us"] == speed and kept["call_budget_us"] == 300.0
        assert kept["step_budget_us"] == vb.solver_defaults()["step_budget_us"] == 500.0


def test_budgets_change_while_a_scene_runs(context):
    scene = vb.Scene(context)
    before = scene.state_hash
    scene.set_budgets()
    assert scene.state_hash == before
    scene.set_budgets(step_budget_us=250.0, operations_per_us=300.0)
    assert scene.state_hash != before
    scene.step()
    with pytest.raises(vb.OutOfRangeError, match="call_budget_us"):
        scene.set_budgets(call_budget_us=-1.0)


def test_options_of_the_solver_are_a_mapping(context):
    vb.Scene(context, solver=vb.solver_defaults()).close()
    vb.Scene(context, solver={}).close()
    with pytest.raises(vb.OutOfRangeError, match="step_budget_us"):
        vb.Scene(context, solver={"step_budget_us": 1e8})
    with pytest.raises(TypeError, match="no setting 'step_budget'; did you mean 'step_budget_us'"):
        vb.Scene(context, solver={"step_budget": 250000})
    with pytest.raises(TypeError, match="not a mapping"):
        vb.Scene(context, solver=7)
    with pytest.raises(TypeError, match="no setting 'solver'"):
        vb.Thread(context, solver={})
