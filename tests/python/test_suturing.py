"""The whole task as an environment: the interface, the same numbers by seed, rewards, and two policies."""
import weakref

import pytest

np = pytest.importorskip("numpy")

import vblast_ss as vb  # noqa: E402
from vblast_ss import analysis  # noqa: E402
from vblast_ss.suturing import (ACTIONS, FIELDS, HIGH, JAWS, LOW, MOVE, ROTATE, SHEARS, RandomHands,  # noqa: E402
                                ScriptedStitch, SutureEnvironment, played_back)

SHORT = {"segments": 60}  # enough for the needle's way
STEADY = {**SHORT, "tremor": 0.0, "scatter": 0.0, "turn_scatter": 0.0}
RIGHT = ACTIONS // 2


@pytest.fixture
def environment():
    with SutureEnvironment(time_limit=0.2) as made:
        yield made


def still(jaws=0.12):
    action = np.zeros(ACTIONS)
    action[[JAWS, RIGHT + JAWS]] = jaws
    return action


def follow(environment, policy, seed):
    seen, _ = environment.reset(seed=seed, options=SHORT)
    rows, over = [seen], False
    while not over:
        seen, reward, terminated, truncated, _ = environment.step(policy(seen))
        rows.append(np.append(seen, reward))
        over = terminated or truncated
    return np.concatenate(rows), environment.scene.scene.state_hash, environment.session.state_hash


def test_it_has_the_interface_of_gymnasium(environment):
    seen, info = environment.reset(seed=3, options=SHORT)
    assert environment.observation_space.contains(seen) and info["task"]["segments"] == 60
    assert info["phase"] == "IDLE" and info["events"] == []
    action = environment.action_space.sample()
    assert action in environment.action_space and action.shape == (ACTIONS,)
    seen, reward, terminated, truncated, info = environment.step(action)
    assert environment.observation_space.contains(seen) and isinstance(reward, float)
    assert (terminated, truncated) == (False, False) and info["steps"] == environment.control
    assert info["phase"] == "LOADING" and seen[FIELDS["phase"]] == vb.SessionPhase.LOADING
    assert [event.kind.name for event in info["events"]] == ["APPEARED", "PHASE"]
    assert environment.render() is None and "render_modes" in environment.metadata
    with pytest.raises(TypeError):
        environment.reset(options={"gravity": 1.0})
    with pytest.raises(ValueError):
        SutureEnvironment(event_points={"applause": 1.0})


def test_time_costs_a_point_a_second_and_ends_an_episode(environment):
    environment.reset(seed=0, options=SHORT)
    rewards = []
    for i in range(20):
        _, reward, terminated, truncated, _ = environment.step(still())
        rewards.append(reward)
        assert not terminated and truncated == (i == 19)
    assert rewards[0] == pytest.approx(-0.009)  # the clock starts with the first step
    assert rewards[1:] == pytest.approx([-0.01] * 19)
    with pytest.raises(RuntimeError):
        environment.step(still())
    environment.close()
    with pytest.raises(RuntimeError):
        environment.take_log()


def test_bad_actions_change_nothing(environment):
    environment.reset(seed=0, options=SHORT)
    before = environment.scene.scene.state_hash
    for bad in (np.zeros(ACTIONS - 1), np.full(ACTIONS, np.nan), np.zeros((2, 8))):
        with pytest.raises(ValueError):
            environment.step(bad)
    assert environment.scene.scene.state_hash == before
    with pytest.raises(ValueError):
        SutureEnvironment(control=0)


def test_any_list_is_an_action_or_refused(environment):
    hypothesis = pytest.importorskip("hypothesis")
    st = hypothesis.strategies
    environment.reset(seed=0, options=SHORT)
    number = st.floats(allow_nan=True, allow_infinity=True)

    @hypothesis.settings(max_examples=15, deadline=None, derandomize=True)
    @hypothesis.given(action=st.one_of(st.lists(number, max_size=20), st.lists(st.floats(-1e300, 1e300),
                                                                               min_size=ACTIONS, max_size=ACTIONS)))
    def take(action):
        steps = environment.scene.steps
        try:
            seen, *_ = environment.step(action)
        except ValueError:
            assert environment.scene.steps == steps
        else:
            assert np.isfinite(seen).all() and len(action) == ACTIONS and np.isfinite(action).all()

    take()


def test_equal_seeds_give_equal_numbers_and_others_do_not(environment):
    first, *hashes = follow(environment, RandomHands(7, ACTIONS), 11)
    with SutureEnvironment(time_limit=0.2) as other:
        again, *same = follow(other, RandomHands(7, ACTIONS), 11)
        elsewhere, *others = follow(other, RandomHands(7, ACTIONS), 12)
    assert hashes == same and first.tobytes() == again.tobytes()
    assert hashes != others and elsewhere.tobytes() != first.tobytes()


def test_devices_move_tools_where_actions_say(environment):
    seen, _ = environment.reset(seed=0, options=STEADY)
    action = still(1.0)
    action[MOVE], action[RIGHT + ROTATE.start] = (0.5, 0.0, 0.0), 0.25  # the left one to the right, the right one turns
    after, *_ = environment.step(action)
    assert after[FIELDS["left"]][:3] - seen[FIELDS["left"]][:3] == pytest.approx((0.5e-3, 0.0, 0.0), abs=1e-12)
    assert after[FIELDS["right"]][3:] == pytest.approx((np.cos(5e-3), np.sin(5e-3), 0.0, 0.0), abs=1e-9)
    assert after[FIELDS["jaws"]] == pytest.approx((0.64, 0.68))  # 8 a second, at most
    for side, name in enumerate(("left", "right")):
        tool = environment.scene.tools[side]
        assert tool.device.statistics.reads == 10 and tool.state.target_position == pytest.approx(after[FIELDS[name]][:3])
        assert (0.56, 0.6)[side] < tool.state.opening < after[FIELDS["jaws"]][side]  # a device smooths
        assert np.linalg.norm(np.subtract(tool.state.position, tool.state.target_position)) < 1e-3


def test_hands_reach_so_far():
    with SutureEnvironment() as environment:
        environment.reset(seed=0, options=STEADY)
        action = still()
        action[MOVE] = (0.0, 0.0, 1.0)
        for _ in range(125):
            seen, *_ = environment.step(action)
        assert seen[FIELDS["left"]][2] == HIGH[2] and (LOW < HIGH).all()


def test_a_tool_becomes_shears(environment):
    environment.reset(seed=0, options=STEADY)
    action = still()
    action[[SHEARS, RIGHT + SHEARS]] = 1.0, -1.0
    environment.step(action)
    kinds = [tool.state.kind for tool in environment.scene.tools]
    assert kinds == [vb.GrasperKind.SHEARS, vb.GrasperKind.NEEDLE_DRIVER]


def test_a_needle_that_is_taken_is_rewarded_and_one_that_is_dropped_costs():
    with SutureEnvironment(time_limit=10.0) as environment:
        policy, total = ScriptedStitch(through=False), 0.0
        seen, _ = environment.reset(seed=1, options=SHORT)
        while not policy.done:
            seen, reward, terminated, truncated, info = environment.step(policy(seen))
            total += reward
            assert not terminated and not truncated
        assert policy.why == "" and info["phase"] == "APPROACH" and seen[FIELDS["holder"]] == 1
        assert total == pytest.approx(50.0 + 5.0 - (info["time"] - 1e-3))  # phase, event, time
        lifted = seen[FIELDS["needle"]][2]
        before = info["time"]
        action = still()
        action[RIGHT + JAWS] = 1.0
        lost = []
        for _ in range(50):
            seen, reward, *_, info = environment.step(action)
            lost.append(reward)
        assert seen[FIELDS["needle"]][2] < lifted - 0.01 and seen[FIELDS["holder"]] == 2
        assert info["phase"] == "LOADING" and environment.metrics.report.drops == 1
        assert sum(lost) == pytest.approx(-50.0 - 5.0 - 5.0 - (info["time"] - before))


@pytest.mark.parametrize("seed", [0, 5])
def test_scripted_hands_drive_the_needle_through_both_marks(seed):
    with SutureEnvironment(time_limit=12.0) as environment:
        policy, total, heard = ScriptedStitch(), 0.0, []
        seen, _ = environment.reset(seed=seed, options=SHORT)
        while not policy.done:
            seen, reward, terminated, truncated, info = environment.step(policy(seen))
            total += reward
            heard += info["events"]
            assert not terminated and not truncated
        assert policy.why == "" and info["phase"] == "PULL_THROUGH"
        pierced = [event.amount for event in heard if event.kind is vb.SessionEventKind.PUNCTURE]
        assert pierced == pytest.approx(info["deviation_mm"]) and max(pierced) < 2.0  # mm
        assert not any(event.undone or event.kind is vb.SessionEventKind.STRAY for event in heard)
        # Three phases and the taking; time and what the holes are off cost.
        assert total == pytest.approx(155.0 + environment.metrics.report.score - 600.0) and total > 125.0


def test_random_hands_make_no_stitch_and_break_nothing():
    with SutureEnvironment(time_limit=0.5) as environment:
        policy, over = RandomHands(1, ACTIONS), False
        seen, _ = environment.reset(seed=1)
        while not over:
            seen, reward, terminated, truncated, info = environment.step(policy(seen))
            assert environment.observation_space.contains(seen) and np.isfinite(seen).all()
            over = terminated or truncated
        assert truncated and "error" not in info and info["phase"] == "LOADING" and info["steps"] == 500


def test_each_episode_leaves_nothing_behind():
    """Also not until somebody collects: an episode has megabytes."""
    with SutureEnvironment(record=True) as environment:
        contexts = []
        for seed in range(4):
            environment.reset(seed=seed, options=SHORT)
            environment.step(still())
            contexts.append(weakref.ref(environment.scene.context))
        assert [context() is not None for context in contexts] == [False, False, False, True]


def test_a_failed_task_and_a_simulation_that_fails_end_the_episode(environment, monkeypatch):
    environment.reset(seed=0, options=SHORT)
    environment.step(still())
    environment.scene.scene.remove(environment.scene.needle_body)
    _, _, terminated, truncated, info = environment.step(still())
    assert terminated and not truncated and info["failure"] == "LOST"

    environment.reset(seed=0, options=SHORT)
    environment.step(still())
    environment.scene.scene.cut_thread(environment.scene.thread_body, 0.1)
    seen, reward, terminated, _, info = environment.step(still())
    assert terminated and info["failure"] == "CUT_EARLY" and environment.observation_space.contains(seen)
    assert info["score"] == 0.0 and reward == pytest.approx(-600.0 + 9e-3)  # what was left of the score

    def fail(*_):
        raise vb.errors.Error("it is singular")

    environment.reset(seed=0, options=SHORT)
    monkeypatch.setattr(environment.scene, "move", fail)
    seen, reward, terminated, truncated, info = environment.step(still())
    assert terminated and not truncated and "singular" in info["error"]


def test_an_episode_is_recorded_and_replayed():
    with SutureEnvironment(time_limit=0.3, record=True) as environment:
        follow(environment, RandomHands(2, ACTIONS), 4)
        log, events, score = environment.take_log(), environment.session.events, environment.metrics.report.score
        state = environment.session.state_hash
    again = played_back(log)
    assert again.session.events == events and again.metrics.report.score == score
    assert again.session.state_hash == state and again.steps == 300
    again.close()
    session = analysis.trace(log)
    assert session.faithful and session.info["steps"] == 300 and len(session.tools) == 2
    with SutureEnvironment() as other:
        other.reset(seed=0, options=SHORT)
        with pytest.raises(RuntimeError):
            other.take_log()
