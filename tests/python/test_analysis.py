"""Logs become arrays, files and pictures that say what happened."""
import pytest

np = pytest.importorskip("numpy")

import vblast_ss as vb  # noqa: E402
from vblast_ss import analysis  # noqa: E402
from vblast_ss.environment import FIELDS, ScriptedThrow, ThrowEnvironment  # noqa: E402

W, C, THREAD = 2, 3, 1


@pytest.fixture(scope="module")
def recorded():
    """A throw's first part: what was seen meanwhile, and the log."""
    rows = []
    with ThrowEnvironment(time_limit=0.6, record=True) as environment:
        hands, (seen, _), over = ScriptedThrow(), environment.reset(seed=0), False
        while not over:
            seen, _, terminated, over, _ = environment.step(hands(seen))
            rows.append((seen[FIELDS["time"]], environment.scene.tool(environment.scene.c).position,
                         environment.scene.tool(environment.scene.c).hand_force))
        log = environment.take_log()
        assert environment.take_log() == log
    return rows, log


@pytest.fixture(scope="module")
def session(recorded):
    return analysis.trace(recorded[1])


def test_a_trace_is_what_was_seen(recorded, session):
    rows = recorded[0]
    assert session.faithful and session.info["steps"] == 600 and set(session.tools) == {W, C}
    assert session.time == pytest.approx([time for time, _, _ in rows])
    assert np.array_equal(session.tools[C].position, [place for _, place, _ in rows])
    assert np.array_equal(session.tools[C].force, [force for _, _, force in rows])
    assert set(session.tensions) == {THREAD} and session.tensions[THREAD].shape == session.time.shape
    assert len(analysis.trace(recorded[1], every=100, knots=False).time) == 6
    with pytest.raises(ValueError):
        analysis.trace(recorded[1], every=0)


def test_a_cut_log_gives_what_is_in_it(recorded):
    short = analysis.trace(recorded[1][:len(recorded[1]) // 2], knots=False)
    assert not short.faithful and "cut off" in short.problem and 100 < short.info["steps"] < 600


def loop_of(context, note=b""):
    """An overhand knot in a thread, pulled by pins: of another scene than a throw's."""
    import math
    points = [(1e-3 * (t**3 - 3 * t), 1e-3 * (t**4 - 4 * t**2), 0.2e-3 * (t**5 - 10 * t))
              for t in (-2.2 + 4.4 * i / 160 for i in range(161))]
    scene = vb.Scene(context, mode="offline", solver={"contact_margin": 1e-4})
    thread = vb.Thread(context, positions=points, gravity=(0, 0, 0),
                       rest_lengths=[math.dist(a, b) for a, b in zip(points, points[1:])])
    scene.add(thread)
    return scene


def test_other_scenes_are_made_by_a_function_and_their_knots_have_times():
    with vb.Context() as context:
        scene = loop_of(context)
        record = vb.Record(scene)
        record.attach_to_scene()
        for _ in range(20):
            scene.step(1e-3)
        record.end()
        log = record.take()
    with pytest.raises(ValueError, match="made"):
        analysis.trace(log)
    found = analysis.trace(log, loop_of, every=5)
    assert found.faithful and found.tools == {} and found.notation == "1"
    certified = [one for one in found.knots if one.kind == "certified"]
    assert certified and certified[0].time == pytest.approx(0.005) and certified[0].notation == "1"


def test_a_file_gives_back_what_went_into_it(session, tmp_path):
    pytest.importorskip("h5py")
    session = session._replace(knots=[analysis.KnotMoment(0.1, "formed", (0, 1, 2), "1")],
                               events=[analysis.SceneMoment(0.2, "clamped", 0, 0, 5)])
    analysis.write_hdf5(session, tmp_path / "session.h5")
    again = analysis.read_hdf5(tmp_path / "session.h5")
    for name in ("time", "contacts"):
        assert np.array_equal(getattr(again, name), getattr(session, name))
    for body, tool in session.tools.items():
        assert all(np.array_equal(a, b) for a, b in zip(again.tools[body], tool))
    assert np.array_equal(again.tensions[THREAD], session.tensions[THREAD])
    for name in ("events", "knots", "notation", "faithful", "problem", "info"):
        assert getattr(again, name) == getattr(session, name)


def test_pictures_show_every_tool(session, tmp_path):
    pytest.importorskip("matplotlib")
    written = analysis.plot(session, tmp_path / "plots", {W: "tool W", C: "tool C"})
    assert [path.name for path in written] == ["forces.png", "motion.png", "knots.png"]
    assert all(path.read_bytes().startswith(b"\x89PNG") for path in written)
    hands = analysis.plot_forces(session, {W: "tool W"}).axes[0]
    assert [line.get_label() for line in hands.lines] == ["tool W", "body 3"]
    longest = np.sqrt((session.tools[W].force**2).sum(axis=1)).max()
    assert hands.lines[0].get_ydata().max() == pytest.approx(longest)


def test_a_session_is_scored_anew(session):
    knots = [analysis.KnotMoment(0.2, "certified", (0, 1, 2), "1"), analysis.KnotMoment(0.3, "revoked", (0, 1, 2), ""),
             analysis.KnotMoment(0.4, "certified", (0, 1, 2), "1")]
    with analysis.score(session._replace(knots=knots), left=C, right=W, throws_wanted=1) as metrics:
        assert metrics.report.throw_count == 1 and metrics.report.time == pytest.approx(0.6)
        assert metrics.report.samples == len(session.time)
        metrics.finish()
        assert metrics.motion("left").path_length > metrics.motion("right").path_length > 0.02
