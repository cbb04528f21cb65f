"""Keywords over defaults, and what is refused."""
import math

import pytest

import vblast_ss as vb

KINDS = [vb.Thread, vb.Drain, vb.Needle, vb.Grasper, vb.Scene, vb.KnotDetector, vb.Collision, vb.Mock, vb.Output,
         vb.Metrics]


@pytest.mark.parametrize("kind", KINDS)
def test_defaults_are_reported_and_make_an_object(kind):
    defaults = kind.defaults()
    assert defaults and "struct_size" not in defaults
    assert all(name in kind.settings_help() for name in defaults)
    with vb.Context() as context:
        made = kind(context, **defaults)
        assert type(made).__name__ in repr(made)
        made.close()
        assert made.closed and "closed" in repr(made)


@pytest.mark.parametrize("kind", KINDS)
def test_an_unknown_keyword_is_a_type_error(kind, context):
    with pytest.raises(TypeError, match="no setting 'struct_size'"):
        kind(context, struct_size=8)
    with pytest.raises(TypeError, match="no setting 'no_such_thing'"):
        kind(context, no_such_thing=1)


def test_a_near_miss_names_the_setting(context):
    with pytest.raises(TypeError, match="did you mean 'length'"):
        vb.Thread(context, lenght=0.1)
    with pytest.raises(TypeError, match="did you mean 'log_level'"):
        vb.Context(log_leve=1)


@pytest.mark.parametrize("settings, error", [
    ({"length": math.nan}, vb.NotFiniteError), ({"length": math.inf}, vb.NotFiniteError),
    ({"length": -1.0}, vb.OutOfRangeError), ({"segment_count": 0}, vb.OutOfRangeError),
    ({"segment_count": -1}, ValueError), ({"segment_count": 2**32}, ValueError),
    ({"segment_count": 2.5}, TypeError), ({"length": "long"}, ValueError), ({"length": None}, TypeError),
    ({"gravity": (0.0, 1.0)}, ValueError), ({"gravity": (0.0, 1.0, math.nan)}, vb.NotFiniteError),
    ({"gravity": "abc"}, TypeError), ({"gravity": (0.0, 1.0, "x")}, TypeError), ({"method": "theirs"}, vb.OutOfRangeError),
    ({"method": 7}, vb.OutOfRangeError), ({"preset": "wool"}, vb.OutOfRangeError),
    ({"positions": [[0.0, 0.0, 0.0]]}, vb.OutOfRangeError), ({"positions": [1.0, 2.0]}, ValueError),
    ({"positions": [[0.0] * 3, [math.nan] * 3]}, vb.NotFiniteError),
    ({"positions": [[0.0] * 3, [1.0, 0.0, 0.0]], "segment_count": 5}, ValueError),
    ({"rest_lengths": [0.1, -0.1]}, vb.OutOfRangeError)])
def test_bad_settings_of_a_thread_are_refused(context, settings, error):
    with pytest.raises(error):
        vb.Thread(context, **settings)
    assert context.statistics.objects_alive == 0


def test_sutures_and_needles_by_size(context):
    braid = vb.Thread(context, suture=("silk", "2-0"), length=0.1)
    rod = vb.Thread(context, suture=(vb.ThreadMaterial.NYLON, vb.ThreadUspSize.USP_2_0), length=0.1)
    assert braid.momentum.mass == pytest.approx(1305.0 * math.pi * 0.16e-3**2 * 0.1)
    assert rod.momentum.mass == pytest.approx(1140.0 * math.pi * 0.16e-3**2 * 0.1)
    half = vb.Needle(context, shape=(0.5, 26e-3, 0.6e-3))
    assert math.dist(half.state.tip, half.state.swage) == pytest.approx(2.0 * 26e-3 / math.pi)
    with pytest.raises(vb.OutOfRangeError):
        vb.Thread(context, suture=("wool", "2-0"))
    with pytest.raises(vb.OutOfRangeError):
        vb.Thread(context, suture=("silk", "1-0"))
    with pytest.raises(vb.OutOfRangeError):
        vb.Needle(context, shape=(1.0, 26e-3, 0.6e-3))


@pytest.mark.parametrize("kind, name, bad", [
    (vb.Thread, "thread_damping", 1.1), (vb.Drain, "drain_stiffness", -1.0), (vb.Grasper, "grasper_distance", 0.2),
    (vb.Scene, "scene_pass_limit", 0), (vb.Collision, "collision_unit", 0.0)])
def test_parameters_of_the_baseline_are_a_mapping(context, kind, name, bad):
    defaults = vb.baseline_defaults()
    assert name in defaults
    kind(context, method="vblast", baseline=defaults).close()
    kind(context, method="vblast", baseline={}).close()
    with pytest.raises(vb.OutOfRangeError, match=name):
        kind(context, method="vblast", baseline={name: bad})
    with pytest.raises(TypeError, match="no setting 'paper'"):
        kind(context, baseline={"paper": 1})
    with pytest.raises(TypeError, match="not a mapping"):
        kind(context, baseline=7)


@pytest.mark.parametrize("points", [[[0.0, 1.0], [0.0, 1.0], [0.0, 1.0]], [[0.0] * 6, [1.0] * 6], [[0.0] * 3, [1.0] * 2, [2.0] * 4]])
def test_rows_of_another_length_are_refused(context, points):
    with pytest.raises(ValueError, match="rows of 3"):
        vb.Thread(context, positions=points)
    np = pytest.importorskip("numpy")
    if len({len(point) for point in points}) == 1:
        with pytest.raises(ValueError, match="rows of 3"):
            vb.Thread(context, positions=np.array(points))


@pytest.mark.parametrize("use", [lambda t: t.step("1e-3"), lambda t: t.step(None), lambda t: t.detach(1.5), lambda t: t.restore(3),
                                 lambda t: t.set_attachment_target("a", (0, 0, 0)), lambda t: t.set_state(positions=5)])
def test_arguments_of_another_type_are_type_errors(context, use):
    with pytest.raises(TypeError):
        use(vb.Thread(context))


def test_arrays_of_other_types_are_taken_or_refused(context):
    np = pytest.importorskip("numpy")
    thread = vb.Thread(context, segment_count=2)
    places = np.arange(9).reshape(3, 3)
    for kind in (np.float32, np.int64, ">f8", np.uint8):
        thread.set_state(positions=places.astype(kind))
        assert thread.positions.tolist() == places.tolist()
    thread.set_state(positions=np.arange(18.0).reshape(3, 6)[:, ::2])
    assert thread.positions[1].tolist() == [6.0, 8.0, 10.0]
    for kind in (complex, str, object):
        with pytest.raises(TypeError):
            thread.set_state(positions=places.astype(kind))


def test_the_text_names_the_value_that_was_refused(context):
    with pytest.raises(vb.OutOfRangeError, match="length") as caught:
        vb.Thread(context, length=-2.0)
    assert caught.value.status == -2 and "-2" in caught.value.text
    assert context.last_error == (-2, caught.value.text)


def test_constants_are_taken_by_name_number_and_member(context):
    for method in ("vblast", "VBLAST", 1, vb.Method.VBLAST):
        thread = vb.Thread(context, method=method, segment_count=10)
        thread.step()
    assert vb.Thread.defaults()["method"] is vb.Method.IMPLICIT


def test_presets_come_before_keywords(context):
    silk = vb.Thread(context, preset="silk_2_0", segment_count=10)
    other = vb.Thread(context, preset=vb.ThreadPreset.SILK_2_0, linear_density=1e-3, segment_count=10)
    assert silk.momentum.mass == pytest.approx(0.15 * 1.05e-4)
    assert other.momentum.mass == pytest.approx(0.15 * 1e-3)


def test_contexts_are_checked(context):
    with pytest.raises(TypeError, match="not a Context"):
        vb.Thread(3)
    other = vb.Context()
    other.close()
    with pytest.raises(vb.InvalidHandleError, match="closed"):
        vb.Thread(other)
    with vb.Context() as foreign:
        scene, thread = vb.Scene(context), vb.Thread(foreign)
        with pytest.raises(vb.InvalidHandleError):
            scene.add(thread)


def test_every_status_has_an_exception_of_its_own():
    from vblast_ss._api.base import Result
    from vblast_ss.errors import Error, error_of
    kinds = {type(error_of(int(status))) for status in Result if status}
    assert len(kinds) == len(Result) - 1 and Error not in kinds
    assert vb.CapacityError().name == "VBSS_ERROR_CAPACITY"
    assert str(vb.CapacityError()) == "a capacity fixed at creation or a given buffer is exhausted"


def test_the_library_says_what_it_is():
    assert vb.version() == vb.__version__ and vb.version().count(".") == 2
    assert vb.version() in vb.build_info().replace("-rc", "rc")
    vb.arithmetic_check()
    assert "vblast_ss" in vb.library_path
