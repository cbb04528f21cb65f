"""What holds for all inputs."""
import math

import pytest

import vblast_ss as vb
from curves import helix, trefoil, turned

hypothesis = pytest.importorskip("hypothesis")
from hypothesis import given, settings, strategies as st  # noqa: E402

few = settings(max_examples=25, deadline=None, derandomize=True)
part = st.floats(-1.0, 1.0).filter(lambda x: abs(x) > 1e-3)
axes = st.tuples(part, part, part)


@few
@given(axis=axes, angle=st.floats(-math.pi, math.pi), mirrored=st.booleans(), nodes=st.integers(60, 200))
def test_a_turned_knot_is_the_same_knot(axis, angle, mirrored, nodes):
    points = turned(trefoil(nodes, mirrored=mirrored), axis, angle)
    for line in (points, points[::-1]):
        knot = vb.classify(line)
        assert (knot.notation, knot.verdict) == ("1", vb.KnotVerdict.CERTIFIED)
        assert knot.throws[0].handedness == (1 if mirrored else -1)


@few
@given(axis=axes, angle=st.floats(-math.pi, math.pi), size=st.floats(0.1, 10.0))
def test_a_turned_helix_stays_without_a_knot(axis, angle, size):
    assert vb.classify([[size * c for c in p] for p in turned(helix(), axis, angle)]).name is vb.KnotName.NONE


anything = st.one_of(st.floats(allow_nan=True, allow_infinity=True), st.integers(-2**70, 2**70), st.none(), st.text(max_size=4),
                     st.lists(st.floats(), max_size=4), st.booleans())


@settings(max_examples=200, deadline=None, derandomize=True)
@given(changes=st.dictionaries(st.sampled_from(sorted(vb.Thread.defaults())), anything, min_size=1, max_size=3))
def test_a_thread_is_made_or_refused_and_nothing_else(changes):
    changes = {name: min(value, 10**4) if name in ("segment_count", "node_capacity", "attachment_capacity")
               and isinstance(value, int) else value for name, value in changes.items()}
    with vb.Context() as context:
        try:
            thread = vb.Thread(context, **changes)
        except (TypeError, ValueError, OverflowError, vb.Error):
            assert context.statistics.objects_alive == 0
        else:
            assert thread.node_count >= 2 and all(map(math.isfinite, thread.positions[0].tolist()))


@few
@given(values=st.lists(st.floats(-1e3, 1e3), min_size=33, max_size=33))
def test_states_come_back_as_they_were_set(values):
    rows = [values[3 * i:3 * i + 3] for i in range(11)]
    thread = vb.Thread(segment_count=10)
    thread.set_state(positions=rows)
    assert thread.positions.tolist() == rows


@few
@given(shift=st.tuples(part, part, part))
def test_closest_points_move_with_their_segments(shift):
    a, b = [[0, 0, 0], [1, 0, 0]], [[0, 1, 1], [1, 2, 1]]
    there = vb.closest_segments(a, b)
    moved = vb.closest_segments(*([[c + s for c, s in zip(p, shift)] for p in line] for line in (a, b)))
    assert moved.distance == pytest.approx(there.distance, rel=1e-12)
