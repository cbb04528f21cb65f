"""Arrays: no copies, read-only, and never freed memory."""
import gc
import subprocess
import sys

import pytest

import vblast_ss as vb
from conftest import BINDING

np = pytest.importorskip("numpy")


def test_arrays_are_no_copies_and_read_only(context):
    thread = vb.Thread(context, segment_count=10)
    first, second = thread.positions, thread.positions
    assert first.shape == (11, 3) and first.dtype == np.float64 and np.shares_memory(first, second)
    assert not first.flags.writeable and not first.flags.owndata
    for write in (lambda: first.__setitem__((0, 0), 1.0), lambda: setattr(first.flags, "writeable", True)):
        with pytest.raises(ValueError):
            write()
    assert thread.sections.dtype == np.uint32 and thread.tensions.shape == (10,)


def test_a_view_knows_when_it_is_old(context):
    thread = vb.Thread(context, segment_count=10)
    view = thread.view("positions")
    assert view.is_current and len(view) == 11 and view[3][0] == pytest.approx(0.045)
    assert np.asarray(view).shape == (11, 3) and view.tolist()[0] == [0.0, 0.0, 0.0]
    thread.step()
    assert not view.is_current
    for use in (lambda: view.array, lambda: view[0], lambda: len(view), lambda: np.asarray(view)):
        with pytest.raises(vb.StaleViewError, match="thread.positions has changed"):
            use()
    assert thread.view(vb.ThreadField.POSITIONS).is_current
    assert "thread.positions" in repr(view)
    with pytest.raises(vb.OutOfRangeError, match="there are: positions"):
        thread.view("places")
    with pytest.raises(vb.OutOfRangeError):
        thread.view(99)
    thread.close()
    with pytest.raises(vb.InvalidHandleError):
        view.array


def kept_arrays(context):
    """Arrays of everything, with what they show."""
    scene = vb.Scene(context, floor=True)
    thread = vb.Thread(context, segment_count=30, start=(0, 2e-4, 0))
    scene.add(thread)
    for _ in range(30):
        scene.step()
    collision = vb.Collision(context)
    chain, rods = collision.add_chain(3), collision.add_capsules(1)
    collision.set_motion(chain, [[0, 0, 0], [1, 0, 0], [2, 0, 0]])
    collision.set_motion(rods, [[0.5, -1, -0.5], [0.5, 1, -0.5]], start=[[0.5, -1, 1], [0.5, 1, 1]])
    collision.find_candidates()
    collision.find_impacts()
    needle, grasper, drain = vb.Needle(context), vb.Grasper(context), vb.Drain(context)
    objects = [scene, thread, collision, needle, grasper, drain]
    arrays = [getattr(thing, name) for thing, names in [
        (thread, ("positions", "velocities", "rest_lengths", "lengths", "tensions", "curvatures", "sections", "sagittas")),
        (scene, ("contact_features", "contact_points", "contact_normals", "contact_forces", "contact_gaps")),
        (collision, ("candidates", "impacts", "times", "normals", "weights", "decisions", "distances")),
        (needle, ("points",)), (grasper, ("capsules",)),
        (drain, ("positions", "triangles", "rest_positions", "anchors", "slit_left"))] for name in names]
    assert all(array.size for array in arrays)
    return objects, arrays


@pytest.mark.parametrize("end", ["close objects", "close context", "drop everything"])
def test_arrays_outlive_what_they_are_of(end):
    context = vb.Context()
    objects, arrays = kept_arrays(context)
    shown = [array.copy() for array in arrays]
    parts = [array[1:] for array in arrays]
    if end == "close objects":
        for thing in objects:
            thing.close()
    elif end == "close context":
        context.close()
    del objects, context
    gc.collect()
    # Whatever is freed is soon used again.
    noise = [np.full(3000, 7.5) for _ in range(3000)] + [bytearray(b"\xff" * n) for n in range(0, 200000, 997)]
    assert all(np.array_equal(array, was) for array, was in zip(arrays, shown))
    assert all(np.array_equal(part, was[1:]) for part, was in zip(parts, shown))
    del noise


def test_the_memory_goes_with_the_last_array():
    context = vb.Context()
    thread = vb.Thread(context, segment_count=1000)
    memory, kept = context._memory, thread.positions
    context.close()
    assert not memory.blocks and kept[3][1] == 0.0
    import weakref
    block = weakref.ref(kept.base.obj if hasattr(kept.base, "obj") else kept.base)
    del kept, thread, context, memory
    gc.collect()
    assert block() is None


def test_an_array_kept_across_steps_shows_numbers_of_the_object(context):
    thread = vb.Thread(context, segment_count=10)
    kept = thread.positions
    for _ in range(5):
        thread.step()
    assert np.isfinite(kept).all() and (kept[:, 1] <= 0.0).all()


def test_a_restored_cut_leaves_arrays_of_the_piece_readable(context):
    scene = vb.Scene(context)
    body = scene.add(vb.Thread(context, segment_count=20, cut_capacity=1))
    saved = scene.save()
    piece = scene.thread(scene.cut_thread(body, 0.05))
    kept = piece.positions
    scene.restore(saved)
    with pytest.raises(vb.InvalidHandleError):
        piece.positions
    scene.step()
    assert np.isfinite(kept).all()


SCRIPT = """
import sys
sys.modules["numpy"] = None
import vblast_ss as vb
thread = vb.Thread(segment_count=10)
thread.attach("clamp", 0)
thread.step()
places = thread.positions
assert places.memory.readonly and places.shape == (11, 3) and len(places) == 11, places
assert places[3, 0] == places.tolist()[3][0] == places[-8][0] and places[2:4] == list(places)[2:4]
try:
    places[11]
except IndexError:
    pass
else:
    raise AssertionError("row 11 of 11")
assert thread.tensions.readonly and len(thread.tensions) == 10 and thread.sections.format == "I"
thread.set_state(positions=places.tolist())
view = thread.view("positions")
assert len(view.tolist()) == 11
scene = vb.Scene(floor=True)
assert scene.contacts == [] and len(scene.contact_points) == 0 and scene.contact_points.tolist() == []
collision = vb.Collision()
answers = collision.test_batch("edge_edge", [[[-1, 0, 0], [1, 0, 0], [0, -1, 1], [0, 1, 1]]],
                               [[[-1, 0, 0], [1, 0, 0], [0, -1, -1], [0, 1, -1]]])
assert answers.hit == [True] and len(answers.weights[0]) == 4
from curves import trefoil
assert vb.classify(trefoil()).notation == "1"
thread.context.close()
assert places[3, 0] == places.tolist()[3][0]
print("fine")
"""


def test_everything_works_without_numpy(tmp_path):
    import os
    import pathlib
    path = os.pathsep.join([str(BINDING), str(pathlib.Path(__file__).parent)])
    done = subprocess.run([sys.executable, "-B", "-c", SCRIPT], env={**os.environ, "PYTHONPATH": path},
                          capture_output=True, text=True, timeout=120)
    assert done.stdout == "fine\n", done.stderr
