"""Logs and their replay."""
import pytest

import vblast_ss as vb


def make(context, settings=None):
    scene = vb.Scene(context, **(settings or {"mode": "offline"}))
    thread = vb.Thread(context, segment_count=10, cut_capacity=1, attachment_capacity=8)
    body = scene.add(thread)
    ball = scene.add_rigid([((0, 0, 0), (0, 0, 0), 2e-3)], position=(0, 0.05, 0))
    tool = vb.Grasper(context)
    tool.set_target((0.0, 0.1, 0.0))
    scene.add(tool)
    return scene, body, ball, tool


def recorded(context):
    scene, body, ball, tool = make(context)
    record = vb.Record(scene, note=b"a thread and a ball", hash_interval=1, snapshot_interval=3)
    record.attach_to_scene()
    log = record.take()
    scene.set_rigid_target(ball, (0, 0.051, 0), (1, 0, 0, 0))
    tool.set_target((0.001, 0.1, 0.0))
    tool.set_opening(0.5)
    tool.exchange("shears")
    pin = scene.pin_thread(body, 0)
    scene.step()
    scene.unpin_thread(pin)
    thread = scene.thread(body)
    name = thread.attach("force", 5, force=(0, 0, 1e-3))
    scene.step()
    thread.set_attachment_target(name, (0, 0, 2e-3))
    log += record.take()
    scene.step()
    thread.detach(name)
    scene.cut_thread(body, 0.07)
    for _ in range(5):
        scene.step()
    record.end()
    return log + record.take(), scene.state_hash


def test_a_log_is_replayed_to_the_bit(context):
    log, wanted = recorded(context)
    with vb.Context() as other:
        replay = vb.Replay(log, other)
        assert replay.info.note == b"a thread and a ball" and replay.info.log_bytes == len(log)
        assert replay.check() == 8
        scene, *_ = make(other, replay.scene_settings)
        replay.begin(scene)
        assert replay.step().step == 1
        report = replay.run()
        assert report.outcome is vb.ReplayOutcome.ENDED and report.agreed_step == 8
        assert scene.state_hash == wanted


def test_an_attached_record_logs_ordinary_calls(context):
    scene, body, ball, tool = make(context)
    record = vb.Record(scene)
    record.attach_to_scene()
    scene.set_rigid_target(ball, (0, 0.051, 0))
    pin = scene.pin_thread(body, 0)
    scene.step()
    scene.unpin_thread(pin)
    piece = scene.cut_thread(body, 0.07)
    scene.step()
    scene.remove(piece)
    scene.step()
    scene.add_rigid([((0, 0, 0), (0, 0, 0), 2e-3)], position=(0, 0.5, 0))
    scene.step()
    record.end()
    scene.step()  # the end has detached the record
    log, wanted = record.take(), scene.state_hash
    with vb.Context() as other:
        replay = vb.Replay(log, other)
        loaded = replay.load_scene()
        report = replay.run()
        assert report.outcome is vb.ReplayOutcome.ENDED and report.agreed_step == 4
        loaded.step()
        assert loaded.state_hash == wanted


def test_a_record_with_missed_edits_is_refused(context):
    scene, _, ball, _ = make(context)
    record = vb.Record(scene)
    record.attach_to_scene()
    scene.step()
    record.detach_from_scene()
    scene.step()
    with pytest.raises(vb.WrongStateError):
        record.attach_to_scene()


def test_damaged_logs_are_refused(context):
    log, _ = recorded(context)
    with pytest.raises(vb.TruncatedError):
        vb.Replay(log[:-9], context).check()
    broken = bytearray(log)
    broken[-40] ^= 1
    with pytest.raises((vb.CorruptError, vb.TruncatedError)):
        vb.Replay(broken, context).check()
    with pytest.raises((vb.CorruptError, vb.TruncatedError)):
        vb.Replay(b"", context)
    with pytest.raises(TypeError):
        vb.Replay(None, context)


def test_a_replay_goes_to_any_step(context):
    log, wanted = recorded(context)
    with vb.Context() as other:
        replay = vb.Replay(log, other)
        scene, *_ = make(other, replay.scene_settings)
        replay.begin(scene)
        for step in (7, 2, 0, 5):
            assert replay.seek(step).step == step
            assert step == 0 or scene.state_hash == replay.read(step).hash
        with pytest.raises(vb.NotFoundError):
            replay.seek(9)
        assert replay.run().outcome is vb.ReplayOutcome.ENDED and scene.state_hash == wanted


def test_steps_are_read_without_a_scene(context):
    log, wanted = recorded(context)
    replay = vb.Replay(log, context)
    first = replay.read(1)
    assert [one.kind.name for one in first.inputs] == ["RIGID_TARGET", "GRASPER_TARGET", "SET_OPENING", "EXCHANGE", "PIN"]
    assert first.inputs[0].numbers[:3] == (0.0, 0.051, 0.0) and first.inputs[2].numbers == (0.5,)
    cut = replay.read(4)
    assert [one.kind for one in cut.inputs] == [vb.RecordInputKind.DETACH, vb.RecordInputKind.CUT]
    last = replay.read(8)
    assert (last.number, last.hash, last.h) == (8, wanted, 1e-3) and last.time == pytest.approx(8e-3)
    assert last.position < len(log)
    with pytest.raises(vb.NotFoundError):
        replay.read(9)


def test_events_are_in_the_log(context):
    scene = vb.Scene(context, floor=True, mode="offline")
    scene.add(vb.Thread(context, segment_count=5, start=(0, 1e-4, 0)))
    record, seen = vb.Record(scene), []
    record.attach_to_scene()
    for _ in range(20):
        scene.step()
        seen.append([(event.kind, event.body_a, event.body_b, event.id) for event in scene.take_events()])
    replay = vb.Replay(record.take(), context)
    assert [list(replay.read(number + 1).events) for number in range(20)] == seen
    assert vb.SceneEventKind.TOUCH in {event[0] for events in seen for event in events}


def test_a_record_goes_on_with_a_log_that_is_cut_off(context):
    log, _ = recorded(context)
    half = vb.check_log(log).good_bytes // 2
    with vb.Context() as other:
        replay = vb.Replay(log[:half], other)
        with pytest.raises(vb.WrongStateError):
            vb.Record.resume(replay)
        scene, *_ = make(other, replay.scene_settings)
        replay.begin(scene)
        record, position = vb.Record.resume(replay, buffer_bytes=1 << 16)
        replay.close()
        steps = vb.check_log(log[:half]).steps
        assert position <= half and record.take() == b""
        record.attach_to_scene()
        scene.step()
        record.end()
        whole, wanted = log[:position] + record.take(), scene.state_hash
        again = vb.Replay(whole, other)
        again.begin(scene)
        report = again.run()
        assert (report.step, report.outcome, scene.state_hash) == (steps + 1, vb.ReplayOutcome.ENDED, wanted)
    with pytest.raises(TypeError):
        vb.Record.resume(None)


def test_a_log_is_checked_whatever_it_is(context):
    log, _ = recorded(context)
    good = vb.check_log(log, context)
    assert (good.result, good.ended, good.steps, good.faults) == (0, True, 8, ())
    assert good.good_bytes == good.log_bytes == len(log) and good.snapshots == 3 and good.inputs == 10
    broken = bytearray(log)
    broken[-40] ^= 1
    bad = vb.check_log(broken)
    assert bad.result == bad.faults[0].result != 0 and len(bad.faults) == bad.fault_count == 1
    assert bad.good_bytes <= bad.faults[0].position < len(log) and bad.faults[0].problem
    assert vb.check_log(b"").steps == 0
    with pytest.raises(TypeError):
        vb.check_log(None)


def test_what_a_record_refuses(context):
    scene, *_ = make(context)
    with pytest.raises(TypeError):
        vb.Record(None)
    with pytest.raises(TypeError, match="give the note"):
        vb.Record(scene, note_bytes=4)
    record = vb.Record(scene)
    record.end()
    with pytest.raises(vb.WrongStateError):
        record.attach_to_scene()
    with pytest.raises(vb.WrongStateError):
        record.apply_input("unpin", (1,))
    scene.close()
    with pytest.raises(vb.InvalidHandleError):
        vb.Record(scene)
    with pytest.raises(vb.InvalidHandleError):
        vb.Replay(recorded(context)[0], context).begin(scene)
