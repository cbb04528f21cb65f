"""Drain, needle and grasper alone."""
import math

import pytest

import vblast_ss as vb


def test_a_drain_rests_and_is_pulled(context):
    drain = vb.Drain(context, attachment_capacity=4)
    places, gap = drain.places, drain.gap.gap
    assert len(drain.positions) == len(drain.velocities) == len(drain.rest_positions) == places.node_count == 137
    assert len(drain.triangles) == len(drain.strains) == len(drain.curvatures) == places.triangle_count
    assert len(drain.slit_left) == len(drain.slit_right) and len(drain.anchors) == len(drain.anchor_forces)
    force = drain.attach("force", places.marks[0], force=(0.0, 0.0, -0.3))
    pin = drain.attach("pin", places.marks[1], position=drain.positions[places.marks[1]])
    for _ in range(50):
        drain.step()
    assert drain.gap.gap > gap and drain.energies.total > 0.0
    assert drain.reaction(force) == pytest.approx((0.0, 0.0, -0.3)) and drain.reaction(pin)[2] > 0.01
    drain.set_attachment_target(force, (0.0, 0.0, 0.0))
    drain.detach(pin)
    saved, wanted = drain.save(), drain.state_hash
    drain.step()
    drain.restore(saved)
    assert drain.state_hash == wanted and drain.statistics.steps == 50
    drain.set_state(velocities=[[0.0] * 3] * 137)
    with pytest.raises(ValueError):
        drain.set_state(positions=[[0.0] * 3], velocities=[[0.0] * 3] * 2)
    with pytest.raises(vb.InUseError):
        drain.attach("pin", drain.anchors[0], position=(0, 0, 0))
    assert "137 nodes" in repr(drain)


def square(cells=4, side=0.02):
    """Positions and triangles of a flat sheet in the plane y = 0."""
    at = [(side * i / cells, 0.0, side * j / cells) for i in range(cells + 1) for j in range(cells + 1)]
    corners = [(i * (cells + 1) + j, (i + 1) * (cells + 1) + j) for i in range(cells) for j in range(cells)]
    return at, [t for a, b in corners for t in ((a, a + 1, b + 1), (a, b + 1, b))]


def test_a_drain_may_be_a_sheet_of_the_host(context):
    positions, triangles = square()
    stiff = [2e6] * len(triangles)
    sheet = vb.Drain(context, surface=dict(positions=positions, triangles=triangles, anchors=range(10), young_modulus=stiff))
    assert sheet.places.node_count == 25 and len(sheet.triangles) == 32 and list(sheet.anchors) == list(range(10))
    force = sheet.attach("force", 24, force=(0.0, 0.01, 0.0))
    for _ in range(20):
        sheet.step()
    assert sheet.positions[24][1] > 1e-5 and sheet.reaction(force)[1] == pytest.approx(0.01)
    assert "25 nodes" in repr(sheet)
    with pytest.raises(vb.IncompatibleError):
        sheet.gap
    with pytest.raises(TypeError, match="a surface has no 'corners'"):
        vb.Drain(context, surface=dict(positions=positions, corners=triangles))
    with pytest.raises(ValueError, match="numbers for 32 triangles"):
        vb.Drain(context, surface=dict(positions=positions, triangles=triangles, thickness=[1e-3]))
    with pytest.raises(vb.OutOfRangeError, match="is in no triangle"):
        vb.Drain(context, surface=dict(positions=positions + [(0.1, 0, 0)], triangles=triangles))
    assert vb.Drain(context).places.node_count == 137  # the tube


def test_a_needle_flies(context):
    needle = vb.Needle(context, preset="sh", velocity=(1.0, 0.0, 0.0), gravity=(0, -9.81, 0))
    assert needle.state.tip[0] == pytest.approx(8.28e-3)
    assert needle.mass.length == pytest.approx(math.pi * 8.28e-3)
    total = needle.energies.total
    for _ in range(10):
        needle.step()
    assert needle.energies.total == pytest.approx(total, abs=1e-6)
    position, direction = needle.place(0.0)
    assert position == pytest.approx(needle.state.tip) and direction == pytest.approx(needle.state.tip_direction)
    assert needle.points[0].tolist() == pytest.approx(needle.state.tip)
    saved, wanted = needle.save(), needle.state_hash
    needle.set_state((0, 0, 0), orientation=(1, 0, 0, 0), velocity=(0, 0, 0), angular_velocity=(0, 0, 1))
    assert needle.state.velocity == (0.0, 0.0, 0.0)
    needle.restore(saved)
    assert needle.state_hash == wanted
    with pytest.raises(vb.NotFiniteError):
        needle.set_state((math.nan, 0, 0))
    with pytest.raises(ValueError):
        needle.set_state((0, 0))
    with pytest.raises(TypeError):
        needle.set_state(None)
    assert "tip at" in repr(needle)


def test_a_grasper_is_commanded(context):
    grasper = vb.Grasper(context, preset="angled", kind="needle_driver")
    grasper.set_target((0.0, 0.1, 0.0), orientation=(1, 0, 0, 0))
    grasper.set_opening(0.5)
    grasper.exchange("shears")
    assert grasper.state.target_position == (0.0, 0.1, 0.0) and grasper.state.kind is vb.GrasperKind.NEEDLE_DRIVER
    assert grasper.capsules.shape == (4, 7)
    with pytest.raises(vb.OutOfRangeError):
        grasper.set_opening(2.0)
    with pytest.raises(vb.NotFiniteError):
        grasper.set_target((0.0, math.inf, 0.0))
    assert "needle driver" in repr(grasper)
