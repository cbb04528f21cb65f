"""The state of a scene for another thread."""
import threading

import pytest

import vblast_ss as vb

np = pytest.importorskip("numpy")


@pytest.fixture
def scene(context):
    scene = vb.Scene(context, floor=True, floor_height=-0.02)
    scene.add(vb.Thread(context, segment_count=20))
    scene.add(vb.Drain(context))
    return scene


def test_a_state_has_the_arrays_of_the_scene(context, scene):
    thread, drain = vb.Thread(context, segment_count=8), vb.Drain(context)
    own = vb.Scene(context)
    own.add(thread)
    own.add(drain)
    replica = vb.Replica(own)
    assert replica.take().number == 0 and replica.bodies == []
    own.step(1e-3)
    replica.publish(own)
    state = replica.take()
    assert (state.is_new, state.number, state.missed, state.steps) == (1, 1, 0, 1)
    assert state.time == pytest.approx(1e-3) and state.floor == 0
    line, wall = replica.bodies
    assert (line.kind, wall.kind) == (vb.ReplicaKind.THREAD, vb.ReplicaKind.DRAIN)
    nodes = replica.array(vb.ReplicaField.NODES)
    assert np.array_equal(nodes[line.nodes], thread.positions)
    assert np.array_equal(nodes[wall.nodes], drain.positions)
    assert np.array_equal(replica.array(vb.ReplicaField.TRIANGLES)[wall.triangles], drain.triangles)
    assert not nodes.flags.writeable and "state 1" in repr(replica)
    for _ in range(3):
        own.step(1e-3)
        replica.publish(own)
    assert replica.take().missed == 2 and replica.take().is_new == 0


def test_another_thread_draws_while_a_scene_is_stepped(scene):
    replica, parts = vb.Replica(scene), []

    def draw():
        with vb.Context() as own:
            visual = vb.Visual(own)
            visual.add(replica)
            while replica.take().steps < 20:
                visual.update()
            visual.update()
            parts.extend(visual.parts)

    reader = threading.Thread(target=draw)
    reader.start()
    for _ in range(20):
        scene.step(1e-3)
        replica.publish(scene)
    reader.join()
    assert [part.kind.name for part in parts] == ["THREAD", "DRAIN", "FLOOR"]


def test_a_replica_that_is_gone_is_not_drawn(scene):
    with vb.Context() as own:
        visual = vb.Visual(own)
        replica = vb.Replica(scene)
        replica.publish(scene)
        replica.take()
        source = visual.add(replica)
        visual.update()
        assert visual.parts[0].source == source
        scene.context.close()
        visual.update()
        assert visual.parts == []
        with pytest.raises(vb.InvalidHandleError, match="closed"):
            replica.take()


def test_wrong_uses_are_reported(context, scene):
    with pytest.raises(TypeError, match="not of Context"):
        vb.Replica(context)
    replica = vb.Replica(vb.Scene(context))
    with pytest.raises(TypeError, match="not of Context"):
        replica.publish(context)
    with pytest.raises(vb.CapacityError, match="nodes of drains"):
        replica.publish(scene)
    with pytest.raises(ValueError):
        replica.array(99)
    assert vb.Replica.defaults() == {"drain_node_capacity": 0}
