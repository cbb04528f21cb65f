"""The suturing task over a scene."""
import pytest

import vblast_ss as vb


class Rig:
    """All that a session wants, at rest."""

    def __init__(self, context):
        self.scene = vb.Scene(context)
        self.drain = vb.Drain(context)
        self.needle = vb.Needle(context, position=(0.08, 0.08, 0.0))
        self.thread = vb.Thread(context, segment_count=30, gravity=(0.0, 0.0, 0.0), start=(0.0, 0.08, 0.04))
        self.tools = [vb.Grasper(context), vb.Grasper(context)]
        for side, tool in zip((-1, 1), self.tools):
            tool.set_target((-0.08, 0.08, 0.08 * side), (0.70710678118654752, -0.70710678118654752, 0.0, 0.0))
        self.bodies = {"drain": self.scene.add(self.drain), "thread": self.scene.add(self.thread),
                       "needle": self.scene.add(self.needle), "tools": [self.scene.add(tool) for tool in self.tools]}

    def session(self, **settings):
        return vb.Session(self.scene, **self.bodies, **settings)


def test_the_task_begins_with_the_needle(context):
    rig = Rig(context)
    heard = []
    metrics, knots = vb.Metrics(context, duration=10.0), vb.KnotDetector(context)
    session = rig.session(metrics=metrics, knots=knots, listen=heard.append)
    assert session.status.phase is vb.SessionPhase.IDLE and session.events == []
    for _ in range(5):
        session.step()
    status = session.status
    assert status.phase is vb.SessionPhase.LOADING and status.steps == 5 and status.time == pytest.approx(4e-3)
    assert status.failure is vb.SessionFailure.NONE and status.stage is vb.SessionStage.NONE
    assert [event.kind for event in session.events] == [vb.SessionEventKind.APPEARED, vb.SessionEventKind.PHASE]
    assert heard == session.events
    assert metrics.report.flags & vb.MetricsFlagBits.STARTED and metrics.report.samples == 5
    assert "LOADING" in repr(session)
    with pytest.raises(vb.errors.NotFoundError):
        session.event(2)


def test_a_limit_fails_it(context):
    session = Rig(context).session(time_limit=2e-3)
    for _ in range(4):
        session.step()
    assert session.status.failure is vb.SessionFailure.TIMEOUT
    assert session.events[-1].phase is vb.SessionPhase.FAILED


def test_a_session_goes_on_from_where_it_was_saved(context):
    rig = Rig(context)
    session = rig.session(metrics=vb.Metrics(context, duration=10.0))
    session.step()
    scene, state = rig.scene.save(), session.save()
    session.step()
    wanted = session.state_hash
    with pytest.raises(vb.errors.CorruptError):
        session.restore(state)  # its scene is further on
    rig.scene.restore(scene)
    session.restore(state)
    session.step()
    assert session.state_hash == wanted


def test_a_log_replays_and_goes_on(context):
    rig = Rig(context)
    record = vb.Record(rig.scene)
    session = rig.session(record=record, hash_interval=1)
    record.attach_to_scene()
    log = b""
    for i in range(6):
        rig.tools[0].set_target((-0.08, 0.08, -0.08 + 1e-4 * i))
        session.step()
        log += record.take()
    with vb.Context() as other:
        again = Rig(other)
        replay = vb.Replay(log, other)
        replay.begin(again.scene)
        second = again.session(replay=replay, hash_interval=1)
        for _ in range(6):
            second.step()
        assert second.state_hash == session.state_hash and second.events == session.events
        with pytest.raises(vb.errors.TruncatedError):
            second.step()
        second.seek(2)
        assert second.status.steps == 2
        with pytest.raises(vb.errors.TruncatedError):
            second.seek(7)  # the log has no end
        second.seek(6)
        assert second.state_hash == session.state_hash and second.events == session.events
        going_on, position = vb.Record.resume(replay)
        assert position <= len(log)
        second.set_record(going_on)
        second.step()
        assert second.status.steps == 7 and len(going_on.take()) > 0
        second.set_record(None)
        second.step()
        assert going_on.take() == b""


def test_devices_move_the_tools(context):
    rig = Rig(context)
    mock = vb.Mock(context, measure=lambda time: {"position": (-0.08, 0.08, -0.08 + time), "jaw": 1.0})
    session = rig.session(devices=(vb.Device(mock, context=context), None))
    for i in range(10):
        session.step(now=1e-3 * i)
    assert rig.tools[0].state.target_position[2] == pytest.approx(-0.08 + 9e-3)
    assert rig.tools[1].state.target_position[2] == pytest.approx(0.08)


def test_what_does_not_fit_is_refused(context):
    rig = Rig(context)
    with pytest.raises(vb.errors.IncompatibleError):
        vb.Session(rig.scene, thread=1, needle=1, drain=1, tools=(1, 1))
    with pytest.raises(TypeError):
        rig.session(knots=rig.scene)
    with pytest.raises(ValueError):
        rig.session(devices=(None,))
    with pytest.raises(TypeError):
        rig.session(no_such_setting=1)
    session = rig.session(listen=lambda event: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        session.step()
    assert session.status.event_count == 2  # of the task all the same


def test_a_coach_gives_goals_and_names_mistakes(context):
    session = Rig(context).session(coaching=1, time_limit=0.2, dwell=0.0)
    assert session.coaching.goal is vb.SessionGoal.NONE
    session.step()
    session.step()
    coaching = session.coaching
    assert coaching.goal is vb.SessionGoal.TAKE_NEEDLE and coaching.tool is vb.MetricsTool.RIGHT
    assert "right tool" in coaching.sentence and coaching.mistake is vb.SessionMistake.NONE
    assert coaching.geometry == vb.SessionGeometryBits.POINT | vb.SessionGeometryBits.DIRECTION
    assert len(coaching.point) == 3 and coaching.distance > 0.0 and coaching.mistake_sentence == ""
    while session.status.failure is vb.SessionFailure.NONE:
        session.step()
    coaching = session.coaching
    assert coaching.goal is vb.SessionGoal.NONE and coaching.mistake is vb.SessionMistake.TIME_UP
    assert (coaching.mistake_sentence, coaching.remedy) == vb.Session.mistake_text(coaching.mistake)
    assert coaching.mistakes == 1 << vb.SessionMistake.TIME_UP
    kinds = [(event.kind, event.number) for event in session.events]
    assert (vb.SessionEventKind.GOAL, vb.SessionGoal.TAKE_NEEDLE) in kinds
    assert (vb.SessionEventKind.MISTAKE, vb.SessionMistake.TIME_UP) in kinds
    with pytest.raises(vb.errors.WrongStateError):
        Rig(context).session().coaching


def test_an_exercise_has_measures_and_an_outcome(context):
    session = Rig(context).session(exercise=vb.SessionExercise.TAKE_NEEDLE, coaching=1)
    for _ in range(3):
        session.step()
    exercise = session.exercise
    assert exercise.name == "take_needle" and exercise.sentence.startswith("Take the needle")
    assert exercise.outcome is vb.SessionOutcome.NONE and exercise.time == pytest.approx(2e-3)
    assert session.exercise_text(vb.SessionExercise.TAKE_NEEDLE) == (exercise.name, exercise.sentence)
    kinds = [measure.kind for measure in session.measures]
    assert kinds == [vb.SessionMeasureKind.GRASP_SHARE, vb.SessionMeasureKind.GRASP_ANGLE, vb.SessionMeasureKind.DROPS,
                     vb.SessionMeasureKind.TIME]
    assert [measure.is_known for measure in session.measures] == [0, 0, 1, 1] and exercise.missed == 3
    for _ in range(610):
        session.step(0.1)  # no tool takes the needle
    assert session.exercise.outcome is vb.SessionOutcome.FAILED and session.exercise.time == pytest.approx(60.0, abs=0.11)
    assert [event.kind for event in session.events].count(vb.SessionEventKind.EXERCISE) == 1
    with pytest.raises(vb.errors.OutOfRangeError):
        Rig(context).session(exercise=7)


def test_a_session_begins_where_another_one_was(context):
    rig = Rig(context)
    first = rig.session(metrics=vb.Metrics(context, duration=10.0))
    for _ in range(20):
        first.step()
    state = first.save()
    second = rig.session(metrics=vb.Metrics(context, duration=10.0), exercise=vb.SessionExercise.PASS_MARK)
    second.begin_at(state)
    status = second.status
    assert status.phase is vb.SessionPhase.LOADING and status.steps == 0 and status.event_count == 0
    second.step()
    assert second.status.time == 0.0 and second.events[0].kind is vb.SessionEventKind.APPEARED
    with pytest.raises(vb.errors.WrongStateError):
        second.begin_at(state)


def test_an_assisted_task_gets_no_score(context):
    rig = Rig(context)
    metrics = vb.Metrics(context, duration=10.0)
    session = rig.session(metrics=metrics)
    session.step()
    assert session.assistance.aids == 0 and session.status.aids_used == 0
    session.assist(vb.SessionAidBits.SLOW_MOTION | vb.SessionAidBits.HOVER, time_scale=0.25, sink_speed=3e-3)
    assert session.assistance.time_scale == 0.25 and session.assistance.sink_speed == 3e-3
    place = [0.0, 0.1, 0.0]
    for _ in range(101):
        place[1] -= 1e-6  # sinks by 1 mm/s
        session.move_hand(1, place, (0.70710678118654752, -0.70710678118654752, 0.0, 0.0), opening=0.5)
        session.step()
    assert rig.tools[1].state.target_position[1] == pytest.approx(0.08)  # where it was
    assert rig.tools[1].state.opening == 0.5
    assert session.status.time == pytest.approx(101 * 0.25e-3)
    session.assist(0)
    session.step()
    status = session.status
    assert status.aids == 0 and status.aids_used == vb.SessionAidBits.SLOW_MOTION | vb.SessionAidBits.HOVER
    aids = [(event.number, event.undone) for event in session.events if event.kind is vb.SessionEventKind.AID]
    assert aids == [(8, 0), (16, 0), (8, 1), (16, 1)]
    assert metrics.report.flags & vb.MetricsFlagBits.ASSISTED and metrics.report.score == 0.0
    with pytest.raises(vb.errors.OutOfRangeError):
        session.assist(vb.SessionAidBits.SLOW_MOTION, time_scale=2.0)
