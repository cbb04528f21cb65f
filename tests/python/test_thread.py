"""Threads alone."""
import math

import pytest

import vblast_ss as vb


def test_a_falling_thread_falls_as_it_should(context):
    thread = vb.Thread(context, segment_count=20)
    for _ in range(100):
        thread.step(1e-3)
    assert thread.positions[7][1] == pytest.approx(-0.5 * 9.81 * 0.1**2, rel=1e-6)
    assert thread.momentum.linear[1] == pytest.approx(-9.81 * 0.1 * thread.momentum.mass, rel=1e-9)
    assert thread.statistics.steps == 100 and thread.statistics.nodes == thread.node_count == 21


def test_a_hanging_thread_weighs_what_it_weighs(context):
    thread = vb.Thread(context, preset="vblast", direction=(0, -1, 0), segment_count=10, drag=50.0)
    pin = thread.attach("pin")
    for _ in range(2000):
        thread.step()
    weight = thread.momentum.mass * 9.81
    assert thread.reaction(pin).force[1] == pytest.approx(weight, rel=1e-5)
    assert thread.tensions[0] == pytest.approx(0.95 * weight, rel=0.02)
    assert thread.energies.kinetic < 1e-12
    assert thread.lengths[0] > thread.rest_lengths[0]


def test_a_clamp_rolls_a_thread_with_torsional_stiffness(context):
    thread = vb.Thread(context, segment_count=20, length=0.02, torsional_stiffness=2e-8, gravity=(0, 0, 0))
    ends = [thread.attach("clamp", node, direction=(1, 0, 0)) for node in (0, 20)]
    thread.set_roll(ends[1], 0.5)
    thread.step()
    torques = [thread.reaction(end).torque[0] for end in ends]
    assert torques[1] == pytest.approx(2e-8 * 0.5 / 0.02, rel=1e-9) and torques[0] == pytest.approx(-torques[1], rel=1e-9)
    plain = vb.Thread(context, segment_count=4)
    with pytest.raises(vb.Error):
        plain.set_roll(plain.attach("clamp", 0, direction=(1, 0, 0)), 0.5)


def test_a_thread_with_friction_torque_rolls_where_another_sticks(context):
    scene = vb.Scene(context, floor=True, floor_friction=0.3, thread_capacity=2, node_capacity=50)
    threads = [vb.Thread(context, segment_count=10, length=0.01, radius=1e-4, start=(0, 1e-4, 0.01 * k),
                         gravity=(0, -9.7, 1.5), torsional_stiffness=1e-8, friction_torque=k) for k in range(2)]
    for thread in threads:
        scene.add(thread)
    for _ in range(100):
        scene.step(1e-3)
    assert threads[0].positions[5][2] == pytest.approx(0.0, abs=2e-5)
    assert threads[1].positions[5][2] == pytest.approx(0.01 + 0.5 * 1.5 * 0.1**2, rel=0.02)
    with pytest.raises(vb.IncompatibleError):
        vb.Thread(context, friction_torque=1)


def test_attachments_move_and_go(context):
    thread = vb.Thread(context, segment_count=10, gravity=(0, 0, 0))
    pin = thread.attach(vb.ThreadAttachmentKind.PIN, 10)
    thread.set_attachment_target(pin, (0.15, 0.001, 0.0))
    thread.step()
    assert thread.positions[10][1] == pytest.approx(0.001, abs=1e-12)
    clamp = thread.attach("clamp", 0, position=(0, 0, 0), direction=(1, 0, 0))
    thread.set_attachment_target(clamp, (0, 0, 0), direction=(1, 1, 0))
    force = thread.attach("force", 5, force=(0, 0, 1e-3))
    thread.step()
    assert thread.velocities[5][2] > 0.0
    thread.detach(force)
    with pytest.raises(vb.NotFoundError):
        thread.detach(force)
    with pytest.raises(vb.OutOfRangeError):
        thread.attach("pin", 99)
    with pytest.raises(vb.NotFoundError):
        thread.set_attachment_target(77, (0, 0, 0))
    with pytest.raises(vb.NotFiniteError):
        thread.set_attachment_target(clamp, (math.nan, 0, 0))


def test_a_thread_remembers_its_bend(context):
    thread = vb.Thread(context, segment_count=20, length=0.03, gravity=(0, 0, 0), yield_curvature=50.0, relaxation_ratio=0.5)
    thread.attach("clamp", 0, position=(0, 0, 0), direction=(1, 0, 0))
    thread.attach("force", 20, force=(0, 1e-4, 0))
    for _ in range(200):
        thread.step()
    assert thread.plastic_curvatures[0][1] > 10.0 and thread.viscous_curvatures[0][1] > 1.0
    assert thread.energies.dissipated > 0.0
    assert len(vb.Thread(context).plastic_curvatures) == 0
    with pytest.raises(vb.IncompatibleError):
        vb.Thread(context, method="vblast", yield_curvature=50.0)


def test_a_thread_is_cut(context):
    thread = vb.Thread(context, segment_count=10, cut_capacity=1)
    piece = thread.cut(0.075)
    assert piece.node_count + thread.node_count == 12
    piece.step()
    with pytest.raises(vb.CapacityError):
        thread.cut(0.01)
    thread.close()
    piece.step()
    assert piece.statistics.nodes == 6


def test_states_are_set_saved_and_restored(context):
    thread = vb.Thread(context, segment_count=10)
    thread.set_state(positions=[[0.015 * i, 0.0, 0.1] for i in range(11)], velocities=[[0.0, 0.0, 1.0]] * 11)
    assert thread.positions[3].tolist() == pytest.approx([0.045, 0.0, 0.1])
    thread.set_state()
    thread.step()
    saved, wanted = thread.save(), thread.state_hash
    thread.step()
    assert thread.state_hash != wanted
    thread.restore(saved)
    assert thread.state_hash == wanted
    with pytest.raises(vb.TruncatedError):
        thread.restore(saved[:-3])
    with pytest.raises(vb.CorruptError):
        thread.restore(bytearray(b"x" * len(saved)))
    assert thread.state_hash == wanted
    for bad in ([[0.0] * 3] * 10, [[0.0] * 3] * 12):
        with pytest.raises(vb.OutOfRangeError):
            thread.set_state(positions=bad)
    with pytest.raises(ValueError):
        thread.set_state(positions=[[0.0] * 3] * 11, velocities=[[0.0] * 3] * 10)
    with pytest.raises(vb.NotFiniteError):
        thread.set_state(velocities=[[math.nan] * 3] * 11)


def test_rest_lengths_are_graded():
    lengths = vb.grade_lengths(0.15, 0.05, 3e-4, 2e-3, 1.2)
    assert sum(lengths) == pytest.approx(0.15) and min(lengths) < 3.3e-4
    thread = vb.Thread(rest_lengths=lengths)
    assert thread.rest_lengths.tolist() == lengths
    with pytest.raises(vb.OutOfRangeError):
        vb.grade_lengths(-1.0, 0.0, 1e-3, 1e-3)


@pytest.mark.parametrize("h, error", [(0.0, vb.OutOfRangeError), (math.nan, vb.NotFiniteError), (-1e-3, vb.OutOfRangeError),
                                      (1.0, vb.OutOfRangeError)])
def test_bad_steps_change_nothing(context, h, error):
    thread = vb.Thread(context)
    before = thread.state_hash
    with pytest.raises(error):
        thread.step(h)
    assert thread.state_hash == before


def test_a_closed_thread_says_so(context):
    with vb.Thread(context) as thread:
        thread.step()
    thread.close()
    for use in (thread.step, thread.save, lambda: thread.positions, lambda: thread.statistics):
        with pytest.raises(vb.InvalidHandleError, match="the thread is closed"):
            use()
    assert repr(thread) == "<Thread, closed>"
