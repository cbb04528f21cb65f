"""Logs and their replay."""
import pytest

import vblast_ss as vb


def make(context, settings=None):
    scene = vb.Scene(context, **(settings or {"mode": "offline"}))
    thread = vb.Thread(context, segment_count=10, cut_capacity=1, attachment_capacity=8)
    body = scene.add(thread)
    ball = scene.add_rigid([((0, 0, 0), (0, 0, 0), 2e-3)], position=(0, 0.05, 0))
    tool = vb.Grasper(context)
    tool.move((0.0, 0.1, 0.0))
    return scene, body, ball, scene.add(tool)


def recorded(context):
    scene, body, ball, tool = make(context)
    record = vb.Record(scene, note=b"a thread and a ball", hash_interval=1)
    log = record.take()
    record.move_rigid(ball, (0, 0.051, 0), (1, 0, 0, 0))
    record.move_grasper(tool, (0.001, 0.1, 0.0))
    record.set_opening(tool, 0.5)
    record.exchange(tool, "shears")
    pin = record.pin_thread(body, 0)
    record.step()
    record.unpin_thread(pin)
    name = record.attach(body, "force", 5, force=(0, 0, 1e-3))
    record.step()
    record.move_attachment(body, name, (0, 0, 2e-3))
    log += record.take()
    record.step()
    record.detach(body, name)
    record.cut_thread(body, 0.07)
    for _ in range(5):
        record.step()
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


def test_what_a_record_refuses(context):
    scene, *_ = make(context)
    with pytest.raises(TypeError):
        vb.Record(None)
    with pytest.raises(TypeError, match="give the note"):
        vb.Record(scene, note_bytes=4)
    record = vb.Record(scene)
    record.end()
    with pytest.raises(vb.OutOfRangeError):
        record.step()
    scene.close()
    with pytest.raises(vb.InvalidHandleError):
        vb.Record(scene)
    with pytest.raises(vb.InvalidHandleError):
        vb.Replay(recorded(context)[0], context).begin(scene)
