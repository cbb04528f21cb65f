"""A throw as an environment: the interface, the same numbers by seed, rewards, and two policies."""
import hashlib
import os
import subprocess
import sys

import pytest

np = pytest.importorskip("numpy")

import vblast_ss as vb  # noqa: E402
from conftest import BINDING  # noqa: E402
from vblast_ss._throw import z_of  # noqa: E402
from vblast_ss.environment import (FIELDS, GRIP, SHOWN, SPEED, Box, RandomHands, ScriptedThrow, ThrowEnvironment, W, run)  # noqa: E402

STEADY = {"tremor": 0.0, "scatter": 0.0}


@pytest.fixture
def environment():
    with ThrowEnvironment(time_limit=0.2) as made:
        yield made


def follow(environment, policy, seed):
    seen, _ = environment.reset(seed=seed)
    rows, over = [seen], False
    while not over:
        seen, reward, terminated, truncated, _ = environment.step(policy(seen))
        rows.append(np.append(seen, reward))
        over = terminated or truncated
    return np.concatenate(rows), environment.scene.scene.state_hash


def test_it_has_the_interface_of_gymnasium(environment):
    seen, info = environment.reset(seed=3, options={"friction": 0.1})
    assert environment.observation_space.contains(seen) and seen.shape == (17 + 3 * SHOWN,)
    assert info["task"]["friction"] == 0.1
    action = environment.action_space.sample()
    assert action in environment.action_space and action.shape == (8,)
    seen, reward, terminated, truncated, info = environment.step(action)
    assert environment.observation_space.contains(seen) and isinstance(reward, float)
    assert (terminated, truncated) == (False, False) and info["steps"] == environment.control
    assert environment.render() is None and "render_modes" in environment.metadata
    with pytest.raises(TypeError):
        environment.reset(options={"gravity": 1.0})


def test_an_episode_ends_with_its_time_and_a_reset_begins_another(environment):
    environment.reset(seed=0)
    for i in range(20):
        seen, reward, terminated, truncated, _ = environment.step(np.zeros(8))
        assert reward == pytest.approx(-0.01)  # of the score: a point a second
        assert not terminated and truncated == (i == 19)
    with pytest.raises(RuntimeError):
        environment.step(np.zeros(8))
    seen, info = environment.reset()
    assert info["steps"] == 0 and seen[FIELDS["time"]] == 0.0


def test_bad_actions_change_nothing(environment):
    environment.reset(seed=0)
    before = environment.scene.scene.state_hash
    for bad in (np.zeros(7), np.full(8, np.nan), np.zeros((2, 4))):
        with pytest.raises(ValueError):
            environment.step(bad)
    assert environment.scene.scene.state_hash == before
    with pytest.raises(ValueError):
        ThrowEnvironment(control=0)


def test_equal_seeds_give_equal_numbers_and_others_do_not(environment):
    first, one = follow(environment, RandomHands(7), 11)
    with ThrowEnvironment(time_limit=0.2) as other:
        again, two = follow(other, RandomHands(7), 11)
        elsewhere, three = follow(other, RandomHands(7), 12)
    assert one == two and first.tobytes() == again.tobytes()
    assert one != three and elsewhere.tobytes() != first.tobytes()


def test_a_series_of_resets_goes_on_from_its_seed(environment):
    seeds = [environment.reset(seed=seed)[1]["task"]["seed"] for seed in (5, None, None, 5)]
    assert len(set(seeds)) == 3 and seeds[0] == seeds[3]


def test_hands_go_where_actions_say(environment):
    seen, _ = environment.reset(seed=0, options=STEADY)
    action = np.zeros(8)
    action[:6] = (0.5, 0.0, 0.0, 0.0, -0.25, 0.0)
    after, *_ = environment.step(action)
    assert after[FIELDS["w"]] - seen[FIELDS["w"]] == pytest.approx((1e-3, 0.0, 0.0), abs=1e-12)
    assert after[FIELDS["c"]] - seen[FIELDS["c"]] == pytest.approx((0.0, -0.5e-3, 0.0), abs=1e-12)


def test_jaws_hold_only_what_is_within_reach_and_a_drop_costs(environment):
    seen, _ = environment.reset(seed=0, options=STEADY)
    action = np.zeros(8)
    action[GRIP] = 1.0
    seen, *_ = environment.step(action)
    assert not seen[FIELDS["holds"]]
    with ThrowEnvironment() as longer:
        hands = ScriptedThrow()
        seen, _ = longer.reset(seed=0, options=STEADY)
        hands.phase = "travel"  # nothing is wound: it only takes the tail
        while not seen[FIELDS["holds"]]:
            seen, *_, truncated, _ = longer.step(hands(seen))
            assert not truncated
        action[GRIP] = -1.0
        seen, reward, *_ = longer.step(action)
        assert not seen[FIELDS["holds"]] and reward == pytest.approx(-5.01)


def test_jaws_that_close_bring_the_tail_between_them():
    action = np.zeros(8)
    action[GRIP] = 1.0
    with ThrowEnvironment() as longer:
        hands = ScriptedThrow()
        hands.phase = "travel"
        seen, _ = longer.reset(seed=0, options=STEADY)
        while not seen[FIELDS["holds"]]:
            seen = longer.step(hands(seen))[0]
        for _ in range(3):
            seen = longer.step(action)[0]
        tool = longer.scene.tool(longer.scene.w)
        grasp = np.array(tool.position) + 0.5e-3 * z_of(np.array(tool.orientation))
        assert np.abs(seen[FIELDS["tail"]] - grasp).max() < 1e-5


def test_scripted_hands_meet_a_tail_that_swings():
    """A tail that nothing stops, at 8 Hz: hands that follow it stay 2 to 4 mm behind."""
    middle, amplitude = np.array((27e-3, 0.0, 17e-3)), np.array((1.0, 0.6, -1.2)) * 1.5e-3
    hands = ScriptedThrow()
    hands.phase = "travel"
    seen = np.zeros(FIELDS["thread"].stop)
    seen[FIELDS["w"]], seen[FIELDS["c"]], seen[FIELDS["held_at"]] = middle + (0.0, 6e-3, 8e-3), middle + (0.0, 0.04, 0.04), 0.085
    for i in range(100):
        seen[FIELDS["time"]] = 0.01 * i
        seen[FIELDS["tail"]] = middle + amplitude * np.sin(16.0 * np.pi * 0.01 * i)
        seen[FIELDS["w"]] += 0.01 * SPEED * hands(seen)[W]
        if hands.phase == "draw":
            break
    assert hands.phase == "draw"


def test_scripted_hands_tie_a_throw_and_are_rewarded():
    with ThrowEnvironment() as environment:
        outcome = run(environment, ScriptedThrow(), seed=0)
        assert outcome.error == "" and outcome.time <= 5.0
        assert outcome.tied and outcome.notation == "1" and outcome.wraps == 1
        assert outcome.total_reward == pytest.approx(100.0 - outcome.time)
        assert environment.metrics.report.throw_count == 1
        with pytest.raises(RuntimeError):
            environment.take_log()


def test_scripted_hands_tie_without_tremor_and_with_other_materials():
    with ThrowEnvironment() as environment:
        for options in (STEADY, {"friction": 0.1}, {"bending_stiffness": 2e-8}):
            assert run(environment, ScriptedThrow(), seed=1, options=options).tied, options


def test_nothing_begins_inside_another_body(environment):
    """A tail inside W's jaws would not move, and the whole thread with it: seed 6 had one."""
    for seed in range(12):
        seen, _ = environment.reset(seed=seed)
        scene = environment.scene
        assert scene.scene.overlap(scene.w.body).depth == 0.0
        moved = environment.step(np.zeros(8))[0][FIELDS["tail"]] - seen[FIELDS["tail"]]
        assert np.abs(moved).max() > 1e-5


def test_random_hands_are_nearly_normal_and_the_same_everywhere():
    """Hands that remember nothing: the chance in each action, before it is cut off at 1."""
    hands = RandomHands(3, 2000)
    shown = hands(None)
    assert np.mean(shown) == pytest.approx(0.0, abs=0.03) and np.std(shown) == pytest.approx(0.3, abs=0.02)
    assert np.mean(np.abs(shown) < 0.3) == pytest.approx(0.683, abs=0.04)
    assert hashlib.sha256(shown.tobytes()).hexdigest()[:8] == "387112f8"


def test_random_hands_tie_nothing_and_break_nothing():
    with ThrowEnvironment(time_limit=0.5) as environment:
        outcome = run(environment, RandomHands(1), seed=1)
    assert not outcome.tied and outcome.error == "" and outcome.steps == 500


def test_a_simulation_that_fails_ends_the_episode_as_data(environment, monkeypatch):
    def fail(*_):
        raise vb.errors.Error("it is singular")

    environment.reset(seed=0)
    environment.step(np.zeros(8))
    monkeypatch.setattr(environment.scene, "move", fail)
    seen, reward, terminated, truncated, info = environment.step(np.zeros(8))
    assert terminated and not truncated and "singular" in info["error"] and info["steps"] == environment.control
    environment.reset(seed=0)
    assert "error" not in environment.step(np.zeros(8))[4]


def test_small_boxes_stand_in_for_gymnasiums():
    from vblast_ss._episode import _Box
    box = _Box(-1.0, [1.0, 2.0], seed=4)
    assert box.shape == (2,) and box.sample().tolist() == _Box(-1.0, [1.0, 2.0], seed=4).sample().tolist()
    assert [0.0, 1.5] in box and [1.5, 0.0] not in box and [0.0] not in box
    assert all(box.contains(box.sample()) for _ in range(20))
    with pytest.raises(ValueError):
        _Box(-np.inf, np.inf, (2,)).sample()
    assert "Box(-1.0, 2.0, (2,)" in repr(box)
    assert Box is not None


def test_gymnasium_is_used_where_it_is_installed(tmp_path):
    """By a package of its name that has what is asked of it."""
    (tmp_path / "gymnasium").mkdir()
    (tmp_path / "gymnasium" / "__init__.py").write_text(
        "from . import spaces\nregistry = {}\ndef register(id, entry_point):\n    registry[id] = entry_point\nclass Env:\n    seeded = None\n"
        "    def reset(self, *, seed=None, options=None):\n        self.seeded = seed\n")
    (tmp_path / "gymnasium" / "spaces.py").write_text(
        "class Box:\n    def __init__(self, low, high, shape=None, dtype=None, seed=None):\n        self.shape = shape\n")
    script = ("import gymnasium\nfrom vblast_ss import environment, suturing\n"
              "assert gymnasium.registry == {'vblast_ss/Throw-v0': 'vblast_ss.environment:ThrowEnvironment',\n"
              "                              'vblast_ss/Suture-v0': 'vblast_ss.suturing:SutureEnvironment'}\n"
              "for made in (environment.ThrowEnvironment(), suturing.SutureEnvironment()):\n"
              "    assert isinstance(made, gymnasium.Env) and isinstance(made.action_space, gymnasium.spaces.Box)\n"
              "    seen, _ = made.reset(seed=5)\n    assert made.seeded == 5 and seen.shape == made.observation_space.shape\n"
              "    made.step([0.0] * made.action_space.shape[0])\n    made.close()\n")
    done = subprocess.run([sys.executable, "-B", "-c", script], capture_output=True, text=True, timeout=60,
                          env={**os.environ, "PYTHONPATH": f"{tmp_path}:{BINDING}", "VBLAST_SS_LIBRARY": vb.library_path})
    assert done.returncode == 0, done.stderr


def test_a_picture_shows_the_nearer_of_two_triangles():
    from vblast_ss._picture import BACKGROUND, Camera, triangles
    camera = Camera((0.0, 0.0, 0.0), 1.0, 40, 40)
    # In pixels: a large one far away, and before its middle a small one, also given in the other order.
    far = np.array(((2.0, 2.0, -5.0), (38.0, 2.0, -5.0), (2.0, 38.0, -5.0)))
    near = np.array(((8.0, 8.0, 5.0), (12.0, 8.0, 5.0), (8.0, 12.0, 5.0)))
    for order in ((0, 1), (1, 0)):
        corners, colours = np.array((far, near))[list(order)], np.array(((200, 0, 0), (0, 200, 0)))[list(order)]
        picture = triangles(camera, corners, colours)
        assert tuple(picture[9, 9]) == (0, 200, 0) and tuple(picture[20, 5]) == (200, 0, 0)
        assert tuple(picture[39, 39]) == BACKGROUND
        assert abs((picture == (200, 0, 0)).all(axis=2).sum() + (picture == (0, 200, 0)).all(axis=2).sum() - 36 * 36 / 2) < 40


def test_a_window_without_pygame_says_what_is_missing(monkeypatch):
    monkeypatch.setitem(sys.modules, "pygame", None)
    with ThrowEnvironment(render_mode="human") as environment, pytest.raises(ImportError, match="pip install pygame"):
        environment.reset(seed=0)


def test_an_unknown_render_mode_is_refused():
    with pytest.raises(ValueError):
        ThrowEnvironment(render_mode="ansi")


def test_the_tables_of_the_guide_have_the_indices_of_the_vectors():
    import re
    from conftest import ROOT
    from vblast_ss import environment, suturing
    text = (ROOT / "docs" / "guides" / "learning-environments.md").read_text()
    parts = re.split(r"^### Vectors of ", text, flags=re.M)[1:]
    for part, module, width in zip(parts, (environment, suturing), (113, 146)):
        rows = re.findall(r"^\| (\d+)(?: to (\d+))? \| `([a-z_]+)` \|", part, re.M)
        listed = {name: int(first) if last == "" else slice(int(first), int(last) + 1) for first, last, name in rows}
        assert listed == module.FIELDS and list(listed.values())[-1].stop == width
    assert len(parts) == 2
    moves = re.findall(r"^\| (\d+)(?: to (\d+))? \| `([A-Z]+)` \|", parts[0], re.M)
    assert {name: int(first) if last == "" else slice(int(first), int(last) + 1) for first, last, name in moves} == \
        {name: getattr(environment, name) for name in ("W", "C", "TURNING", "GRIP")}
    moves = re.findall(r"^\| (\d+)(?: to (\d+))? \| (\d+)(?: to \d+)? \| `([A-Z]+)` \|", parts[1], re.M)
    assert {name: int(first) if last == "" else slice(int(first), int(last) + 1) for first, last, _, name in moves} == \
        {name: getattr(suturing, name) for name in ("MOVE", "ROTATE", "JAWS", "SHEARS")}
    assert all(int(right) - int(first) == suturing.ACTIONS // 2 for first, _, right, _ in moves)
