"""Meshes to draw."""
import pytest

import vblast_ss as vb

np = pytest.importorskip("numpy")


def test_a_scene_is_drawn(context):
    scene = vb.Scene(context, floor=True, floor_height=-0.02)
    drain = vb.Drain(context)
    scene.add(drain)
    visual = vb.Visual(context, mark_radius=2e-3)
    source = visual.add(scene)
    visual.update()
    assert [part.kind for part in visual.parts] == [vb.VisualKind.DRAIN, vb.VisualKind.FLOOR]
    wall = visual.parts[0]
    assert wall.source == source and wall.body == 1
    vertices, triangles = visual.vertices, visual.triangles
    assert vertices.dtype == np.float32 and vertices.shape[1] == 12 and not vertices.flags.writeable
    assert triangles[wall.triangles].max() == wall.vertices.stop - 1
    radii = np.hypot(vertices[wall.vertices, 1], vertices[wall.vertices, 2])
    assert 5.8e-3 < radii.min() and radii.max() < 7.1e-3
    assert np.allclose(np.linalg.norm(vertices[:, 3:6], axis=1), 1.0, atol=1e-6)
    assert [decal.kind for decal in visual.spots] == [vb.VisualSpotKind.MARK] * 2
    marks = [drain.places.marks[side] for side in range(2)]
    assert visual.spots[0].part == 0 and visual.spots[0].radius == pytest.approx(2e-3)
    assert np.allclose(visual.spots[0].material, drain.rest_positions[marks[0]], atol=1e-9)
    assert visual.statistics.triangles == len(triangles) and "2 parts" in repr(visual)
    visual.remove(source)
    visual.update()
    assert visual.parts == [] and len(visual.vertices) == 0


def test_bodies_alone_are_drawn(context):
    visual = vb.Visual(context)
    bodies = [vb.Thread(context, segment_count=20), vb.Needle(context), vb.Grasper(context), vb.Drain(context)]
    assert [visual.add(body) for body in bodies] == [1, 2, 3, 4]
    visual.update()
    assert [part.kind.name for part in visual.parts] == ["THREAD", "NEEDLE", "DRIVER", "DRAIN"]
    bodies[1].close()
    visual.update()
    assert [part.source for part in visual.parts] == [1, 3, 4]


def test_wrong_uses_are_reported(context):
    visual = vb.Visual(context, source_capacity=1, part_capacity=1)
    with pytest.raises(TypeError, match="not Context"):
        visual.add(context)
    visual.add(vb.Needle(context))
    with pytest.raises(vb.CapacityError):
        visual.add(vb.Needle(context))
    with pytest.raises(vb.NotFoundError):
        visual.remove(3)
    with pytest.raises(vb.OutOfRangeError):
        vb.Visual(context, side_limit=3)
    with vb.Context() as other, pytest.raises(vb.InvalidHandleError):
        vb.Visual(context).add(vb.Needle(other))
