"""Copies and pickles of scenes, sessions and environments, in this process and in others."""
import copy
import multiprocessing
import os
import pickle

import pytest

import vblast_ss as vb

COPIES = {"copy": copy.copy, "deepcopy": copy.deepcopy, "pickle": lambda one: pickle.loads(pickle.dumps(one))}


@pytest.fixture(params=COPIES)
def copied(request):
    return COPIES[request.param]


@pytest.fixture
def stage(context):
    """A scene with a body of each kind, and a thread pinned to a tool."""
    scene = vb.Scene(context, floor=True, floor_height=-0.05, mode="offline")
    scene.add(vb.Thread(context, segment_count=20, start=(0, 0.02, 0.04)))
    scene.add(vb.Drain(context))
    scene.add(vb.Needle(context, position=(0.06, 0.05, 0.0)))
    scene.add(vb.Grasper(context))
    ball = scene.add_rigid([((0, 0, 0), (0, 0, 0), 2e-3)], kind="coupled", position=(0.0, 0.02, 0.04))
    scene.pin_thread(1, 0, ball)
    for _ in range(5):
        scene.step()
    return scene


def hashes(scene, count=10):
    found = []
    for _ in range(count):
        scene.step()
        found.append(scene.state_hash)
    return found


# ---- scenes

def test_a_copy_of_a_scene_goes_on_with_the_same_bits(stage, copied):
    before = stage.state_hash
    other = copied(stage)
    assert other.state_hash == before and other.statistics.steps == 5
    found = hashes(other)
    assert stage.state_hash == before  # the copy was stepped, the scene was not
    assert hashes(stage) == found


def test_a_copy_stays_in_its_context_and_a_deep_copy_has_its_own(stage):
    context = stage.context
    assert copy.copy(stage).context is context
    deep = copy.deepcopy(stage)
    assert deep.context is not context
    context.close()
    assert len(hashes(deep)) == 10


def test_the_bodies_of_a_copy_are_found_by_number(stage, copied):
    other = copied(stage)
    assert [type(other.body(number)) for number in (1, 2, 3, 4)] == [vb.Thread, vb.Drain, vb.Needle, vb.Grasper]
    assert other.body(3).state == stage.body(3).state and other.body(3) is other.body(3)
    assert other.body(1).positions.tolist() == stage.body(1).positions.tolist()
    other.body(4).set_target((0.0, 0.1, 0.0))
    assert other.grasps(4) == [] and other.lost_events == 0
    other.step()
    assert isinstance(other.take_events(), list)
    other.remove(3)
    assert 3 not in other.bodies
    with pytest.raises(vb.Error):
        other.body(5)  # rigid bodies have no object


def test_a_copy_keeps_what_was_stored_in_it(stage, copied):
    stage.marker = [1, 2]
    assert copied(stage).marker == [1, 2]


def test_objects_that_are_pickled_together_share_a_context(stage):
    detector, metrics = vb.KnotDetector(stage.context, point_capacity=64), vb.Metrics(stage.context, throws_wanted=1)
    metrics.add_event("needle_appears", 0.0)
    metrics.add_sample(0.0, left=(0, 0, 0))
    metrics.add_sample(0.5, left=(0, 0, 1e-3))
    detector.step(stage.body(1).positions)
    scene, again, measured = pickle.loads(pickle.dumps((stage, detector, metrics)))
    assert scene.context is again.context is measured.context and scene.context is not stage.context
    assert again.state_hash == detector.state_hash and measured.state_hash == metrics.state_hash
    assert measured.report == metrics.report
    again.step(scene.body(1).positions)
    detector.step(stage.body(1).positions)
    assert again.state_hash == detector.state_hash


def test_a_copy_of_a_context_is_empty_and_has_its_settings():
    heard = []
    with vb.Context(log=heard.append, log_level="error") as context:
        vb.Thread(context)
        with copy.deepcopy(context) as other:
            assert other.statistics.objects_alive == 0 and other._settings == context._settings


def test_handles_that_cannot_be_copied_say_so(stage, copied):
    context = stage.context
    mock = vb.Mock(context)
    for handle in (stage.body(1), stage.body(2), stage.body(3), stage.body(4), mock, vb.Device(mock), vb.Output(context),
                   vb.Record(stage), vb.Collision(context), vb.Visual(context), vb.Replica(stage)):
        with pytest.raises(TypeError, match="cannot be copied or pickled"):
            copied(handle)
    with pytest.raises(TypeError, match=r"body\(number\)"):
        copied(stage.body(1))
    stage.close()
    with pytest.raises(vb.InvalidHandleError, match="closed"):
        copied(stage)
    context.close()
    with pytest.raises(vb.InvalidHandleError, match="closed"):
        pickle.dumps(context)


def test_results_and_errors_go_through_pickles(stage):
    for result in (stage.statistics, stage.rigid(5), stage.body(3).state, stage.contacts):
        assert pickle.loads(pickle.dumps(result)) == result
    with pytest.raises(vb.NotFoundError) as caught:
        stage.rigid(99)
    error = pickle.loads(pickle.dumps(caught.value))
    assert type(error) is vb.NotFoundError and (error.text, error.status) == (caught.value.text, caught.value.status)


# ---- sessions

def tasked(context, **settings):
    scene = vb.Scene(context)
    tools = [scene.add(tool) for tool in (vb.Grasper(context), vb.Grasper(context))]
    for tool, side in zip(tools, (-1, 1)):
        scene.body(tool).set_target((-0.08, 0.08, 0.08 * side))
    session = vb.Session(scene, drain=scene.add(vb.Drain(context)), needle=scene.add(vb.Needle(context, position=(0.08, 0.08, 0.0))),
                         thread=scene.add(vb.Thread(context, segment_count=30, gravity=(0, 0, 0), start=(0.0, 0.08, 0.04))),
                         tools=tools, **settings)
    return scene, session


def test_a_copy_of_a_session_goes_on_with_the_same_bits(context, copied):
    scene, session = tasked(context, metrics=vb.Metrics(context, duration=10.0), knots=vb.KnotDetector(context))
    for _ in range(5):
        session.step()
    before = session.state_hash
    other = copied(session)
    assert other.state_hash == before and other.status == session.status and other.events == session.events
    for _ in range(5):
        other.step()
    assert session.state_hash == before and scene.statistics.steps == 5
    for _ in range(5):
        session.step()
    assert other.state_hash == session.state_hash


def test_a_session_with_its_scene_stays_one_whole(context):
    scene, session = pickle.loads(pickle.dumps(tasked(context)))
    session.step()
    assert scene.statistics.steps == 1


def test_a_session_with_devices_or_a_record_says_that_it_cannot_be_copied(context, copied):
    mock = vb.Mock(context, measure=lambda now: {"position": (0, 0, 0)})
    scene, session = tasked(context, devices=(vb.Device(mock), None))
    with pytest.raises(TypeError, match="devices, a record or a replay"):
        copied(session)
    session.close()
    scene, session = tasked(context)
    session.set_record(vb.Record(scene))
    with pytest.raises(TypeError, match="devices, a record or a replay"):
        copied(session)
    session.set_record(None)
    assert copied(session).state_hash == session.state_hash


# ---- environments

def made(name):
    pytest.importorskip("numpy")
    if name == "throw":
        from vblast_ss.environment import ThrowEnvironment
        return ThrowEnvironment(time_limit=1.0), {}
    from vblast_ss.suturing import SutureEnvironment
    return SutureEnvironment(time_limit=1.0), {"segments": 60}


def played(environment, actions):
    """Bytes of all that comes out of some actions, and the hash in the end."""
    found = b""
    for action in actions:
        seen, reward, terminated, truncated, info = environment.step(action)
        found += seen.tobytes() + repr((reward, terminated, truncated, info)).encode()
    return found, environment.scene.scene.state_hash


def actions_of(environment, count):
    import numpy as np
    random = np.random.default_rng(5)
    return list(random.uniform(-1.0, 1.0, (count, environment.action_space.shape[0])))


@pytest.mark.parametrize("name", ["throw", "suture"])
def test_a_copy_of_an_environment_goes_on_with_the_same_bits(name, copied):
    environment, options = made(name)
    actions = actions_of(environment, 8)
    environment.reset(seed=3, options=options)
    played(environment, actions[:4])
    before = environment.scene.scene.state_hash
    other = copied(environment)
    assert other.scene.context is not environment.scene.context
    wanted = played(other, actions[4:])
    assert environment.scene.scene.state_hash == before
    assert played(environment, actions[4:]) == wanted
    # Later episodes are the same too: the series of seeds goes on in both.
    assert environment.reset(options=options)[0].tobytes() == other.reset(options=options)[0].tobytes()
    environment.close()
    played(other, actions[:1])
    other.close()


def test_a_copy_of_a_hand_that_holds_lets_go(copied):
    np = pytest.importorskip("numpy")
    from vblast_ss.environment import FIELDS, GRIP, ScriptedThrow, ThrowEnvironment
    with ThrowEnvironment() as environment:
        hands = ScriptedThrow()
        seen, _ = environment.reset(seed=0, options={"tremor": 0.0})
        hands.phase = "travel"
        while not seen[FIELDS["holds"]]:
            seen = environment.step(hands(seen))[0]
        other, twin = copied((environment, hands)) if copied is not copy.copy else (copy.copy(environment), copy.copy(hands))
        assert other.step(twin(seen))[0].tobytes() == environment.step(hands(seen))[0].tobytes()
        action = np.zeros(8)
        action[GRIP] = -1.0
        assert not other.step(action)[0][FIELDS["holds"]] and environment.scene.holds
        other.close()


def test_environments_that_have_not_begun_or_are_closed_are_copied(copied):
    environment, options = made("throw")
    other = copied(environment)
    assert environment.reset(seed=1)[0].tobytes() == other.reset(seed=1)[0].tobytes()
    environment.close()
    with pytest.raises(RuntimeError):
        copied(environment).scene
    other.close()


@pytest.mark.parametrize("name", ["throw", "suture"])
def test_an_episode_that_is_recorded_says_that_it_cannot_be_copied(name, copied):
    environment, options = made(name)
    environment.recorded = True
    copied(environment)
    environment.reset(seed=1, options=options)
    with pytest.raises(TypeError, match="recorded"):
        copied(environment)
    environment.close()


# ---- other processes

def rollout(environment, actions):
    """In a worker."""
    return played(environment, actions)


@pytest.mark.parametrize("name", ["throw", "suture"])
def test_a_pickled_environment_gives_the_same_bits_in_a_spawned_process(name):
    environment, options = made(name)
    actions = actions_of(environment, 6)
    environment.reset(seed=3, options=options)
    played(environment, actions[:3])
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        found = pool.apply(rollout, (environment, actions[3:]))
    assert played(environment, actions[3:]) == found
    environment.close()


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork")
@pytest.mark.parametrize("name", ["throw", "suture"])
def test_a_forked_child_goes_on_with_an_environment_of_its_own(name):
    environment, options = made(name)
    actions = actions_of(environment, 6)
    environment.reset(seed=3, options=options)
    played(environment, actions[:3])
    before = environment.scene.scene.state_hash
    pipe, into = multiprocessing.get_context("fork").Pipe()

    def child():
        found = played(environment, actions[3:])
        environment.reset(seed=4, options=options)
        other = copy.deepcopy(environment)
        into.send((found, played(other, actions[:1]) == played(environment, actions[:1])))
        environment.close()

    process = multiprocessing.get_context("fork").Process(target=child)
    process.start()
    assert pipe.poll(60)
    found, equal = pipe.recv()
    process.join(60)
    assert process.exitcode == 0 and equal
    assert environment.scene.scene.state_hash == before  # what the child did changed nothing here
    assert played(environment, actions[3:]) == found
    environment.close()


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork")
def test_forked_children_step_a_scene_independently(stage):
    def child(into, push):
        if push:
            stage.set_rigid_target(5, (0.0, 0.021, 0.04))
        into.send(hashes(stage, 5))

    forked, found = multiprocessing.get_context("fork"), []
    for push in (False, True):
        pipe, into = forked.Pipe()
        process = forked.Process(target=child, args=(into, push))
        process.start()
        assert pipe.poll(60)
        found.append(pipe.recv())
        process.join(60)
        assert process.exitcode == 0
    assert found[0] != found[1] and hashes(stage, 5) == found[0]
