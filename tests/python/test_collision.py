"""Closest points, continuous tests, shapes."""
import math

import pytest

import vblast_ss as vb

CROSSED = [[-1, 0, 0], [1, 0, 0], [0, -1, 1], [0, 1, 1]]  # edge b one above edge a
BELOW = [[-1, 0, 0], [1, 0, 0], [0, -1, -1], [0, 1, -1]]


def test_closest_points():
    assert vb.closest_segments(CROSSED[:2], CROSSED[2:]).distance == 1.0
    assert vb.closest_capsules(CROSSED[:2], 0.25, CROSSED[2:], 0.5).distance == 0.25
    triangle = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    assert vb.closest_point_triangle((0.25, 0.25, 2.0), triangle).point_b == (0.25, 0.25, 0.0)
    assert vb.closest_segment_triangle([[0.25, 0.25, -1], [0.25, 0.25, 1]], triangle).distance == 0.0
    with pytest.raises(ValueError):
        vb.closest_segments([0, 0, 0], [0, 0, 0])
    with pytest.raises(vb.NotFiniteError):
        vb.closest_segments([math.nan] * 6, [0] * 6)


def test_moving_features_meet_or_not():
    hit = vb.test_edges(CROSSED, BELOW)
    assert hit.hit == 1 and hit.time == pytest.approx(0.5) and hit.decision is vb.CollisionDecision.EXACT
    assert vb.test_edges(CROSSED, CROSSED).hit == 0
    assert vb.test_edges(CROSSED, CROSSED, thickness=1.5, method="vblast").decision is vb.CollisionDecision.CLAIMED
    point = [[0.2, 0.2, 1], [0, 0, 0], [1, 0, 0], [0, 1, 0]]
    assert vb.test_point_triangle(point, [[0.2, 0.2, -1], *point[1:]]).hit == 1
    with pytest.raises(TypeError, match="did you mean 'thickness'"):
        vb.test_edges(CROSSED, BELOW, thicknes=1.0)


def test_the_papers_response_pushes_apart():
    impact = vb.test_edges(CROSSED, BELOW, thickness=0.1, method="vblast")
    response = vb.vblast_response("edge_edge", "end_of_step", impact, CROSSED, BELOW, 0.1)
    assert response.depth == pytest.approx(1.1) and len(response.displacement) == 12
    assert vb.vblast_response("edge_edge", 0, None, CROSSED, BELOW, 0.1).depth == response.depth


def test_batches_have_the_answers_of_single_tests(context):
    collision = vb.Collision(context, thickness=0.1)
    answers = collision.test_batch("edge_edge", [CROSSED] * 5, [BELOW, CROSSED] * 2 + [BELOW], thickness=[0.1] * 5)
    single = collision.test("edge_edge", CROSSED, BELOW)
    assert list(answers.hit) == [True, False, True, False, True] and answers.time[0] == single.time
    assert tuple(answers.normal[0]) == single.normal and tuple(answers.weights[2]) == single.weights
    assert collision.statistics.queries == 6
    assert len(collision.test_batch("edge_edge", [], []).hit) == 0
    with pytest.raises(ValueError):
        collision.test_batch("edge_edge", [CROSSED], [BELOW] * 2)


def test_shapes_are_searched(context):
    collision = vb.Collision(context, thickness=0.0)
    chain = collision.add_chain(3, 0.1, rest_lengths=[1.0, 1.0])
    rods = collision.add_capsules(1, 0.1)
    sheet = collision.add_mesh(4, [[0, 1, 2], [1, 3, 2]], 0.01)
    places = [[0, 0, 0], [1, 0, 0], [2, 0, 0]]
    collision.set_motion(chain, places, start=places)
    collision.set_motion(rods, [[0.5, -1, -0.5], [0.5, 1, -0.5]], start=[[0.5, -1, 1], [0.5, 1, 1]])
    collision.set_motion(sheet, [[0, 0, 9], [1, 0, 9], [0, 1, 9], [1, 1, 9]])
    collision.set_motion(sheet, [[0, 0, 9], [1, 0, 9], [0, 1, 9], [1, 1, 9]])
    collision.set_filter(sheet, category=2)
    assert collision.edge(sheet, 0) == (0, 1)
    assert len(collision.find_candidates()) == collision.statistics.candidates > 0
    impacts = collision.find_impacts()
    assert len(impacts) == len(collision.times) == len(collision.distances) == len(collision.decisions) == 1
    assert len(collision.normals[0]) == 3 and len(collision.weights[0]) == 4
    assert collision.candidates[impacts[0]].tolist()[1::2] == [chain, rods]
    saved, wanted = collision.save(), collision.state_hash
    collision.set_motion(chain, [[0, 0, 5], [1, 0, 5], [2, 0, 5]])
    collision.restore(saved)
    assert collision.state_hash == wanted
    collision.remove(sheet)
    with pytest.raises(vb.NotFoundError):
        collision.remove(sheet)
    with pytest.raises(vb.OutOfRangeError):
        collision.add_mesh(3, [[0, 1, 7]])
    with pytest.raises(ValueError):
        collision.add_mesh(3, [0, 1])
    with pytest.raises(ValueError):
        collision.add_mesh(3, [[0, 1, -1]])
    assert "impacts" in repr(collision)
