"""The knot detector."""
import math

import pytest

import vblast_ss as vb
from curves import helix, trefoil


@pytest.mark.parametrize("mirrored, handedness, signature", [(False, -1, 2), (True, 1, -2)])
def test_a_trefoil_is_a_certified_single_throw(mirrored, handedness, signature):
    knot = vb.classify(trefoil(mirrored=mirrored))
    assert (knot.notation, knot.name, knot.verdict) == ("1", vb.KnotName.SINGLE, vb.KnotVerdict.CERTIFIED)
    assert knot.throws[0].handedness == handedness and knot.state.signature == signature
    assert vb.KnotFaultBits.FEW in knot.state.faults


def test_a_helix_is_no_knot():
    knot = vb.classify(helix())
    assert knot.notation == "" and knot.name is vb.KnotName.NONE and knot.throws == ()


def test_readings_are_spread_over_steps(context):
    detector = vb.KnotDetector(context, step_budget=2000)
    points, kinds = trefoil(), []
    while not any(kind is vb.KnotEvent.READ for kind in kinds):
        detector.step(points)
        kinds += [event.kind for event in detector.events]
        assert len(kinds) < 1000
    assert vb.KnotEvent.FORMED in kinds or vb.KnotEvent.CERTIFIED in kinds
    assert detector.state.steps > 1 and detector.statistics.readings == 1
    saved, wanted = detector.save(), detector.state_hash
    detector.reset()
    assert detector.notation == ""
    detector.restore(saved)
    assert detector.state_hash == wanted and detector.notation == "1"
    assert "'1'" in repr(detector)


def test_winding_about_a_tool_is_counted(context):
    detector = vb.KnotDetector(context)
    tool = vb.KnotTool(axis=[[0, 0, -0.05], [0, 0, 0.1]], radius=2e-3, held="nothing")
    detector.step(helix(), tools=[tool], holes=[(0.0, 0.0, 0.0)], hole_places=[0.0], reversed=False)
    assert abs(detector.winding(0).turns) == pytest.approx(0.3 * 59 / (2 * math.pi), rel=0.02)
    assert detector.winding(0).wrapped == 1
    with pytest.raises(vb.NotFoundError):
        detector.winding(1)
    with pytest.raises(vb.NotFoundError):
        detector.throw(0)


def test_the_papers_method_reports_its_loops(context):
    detector = vb.KnotDetector(context, method="projection")
    knot = detector.judge(trefoil(), tools=[vb.KnotTool([[0, 0, -0.05], [0, 0, 0.05]], [1e-3])])
    assert knot.state.crossings == 0 and detector.loops.dtype.kind == "u"


@pytest.mark.parametrize("points, error", [
    ([], vb.OutOfRangeError), ([[0, 0, 0]], vb.OutOfRangeError), ([1.0, 2.0], ValueError), (None, TypeError),
    ([[0, 0, 0], [0, 0, math.nan]], vb.NotFiniteError), ([[0, 0, 0]] * 2000, vb.CapacityError)])
def test_bad_polylines_are_refused(context, points, error):
    detector = vb.KnotDetector(context)
    with pytest.raises(error):
        detector.judge(points)
    assert detector.state.steps == 0


def test_bad_tools_are_refused(context):
    detector = vb.KnotDetector(context)
    for tool in (vb.KnotTool([[0, 0, 0]]), vb.KnotTool([[0, 0, 0]] * 5), vb.KnotTool([[0, 0, 0], [0, 0, 1]], [1, 2])):
        with pytest.raises(ValueError):
            detector.step(helix(), tools=[tool])
    with pytest.raises(ValueError):
        detector.step(helix(), holes=[(0, 0, 0)] * 3)
    with pytest.raises(vb.CapacityError):
        detector.step(helix(), tools=[vb.KnotTool([[0, 0, 0], [0, 0, 1]])] * 9)
