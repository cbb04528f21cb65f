"""Scenes and what is in them."""
import math

import pytest

import vblast_ss as vb

BALL = [((0, 0, 0), (0, 0, 0), 5e-3)]


@pytest.fixture
def lying(context):
    """A thread above a floor, and a scene."""
    scene = vb.Scene(context, floor=True, mode="offline")
    thread = vb.Thread(context, segment_count=20, start=(0, 3e-4, 0), cut_capacity=2)
    return scene, thread, scene.add(thread)


def test_a_thread_falls_on_the_floor_and_lies(lying):
    scene, thread, body = lying
    kinds = set()
    for _ in range(40):
        scene.step()
        kinds |= {event.kind for event in scene.take_events()}
    assert body == 1 and vb.SceneEventKind.TOUCH in kinds
    contacts = scene.contacts
    assert len(contacts) == scene.statistics.contacts == len(scene.contact_gaps) > 10
    assert {contact.kind for contact in contacts} == {vb.SceneContactKind.NODE_FLOOR}
    assert len(scene.contact_points) == len(scene.contact_normals) == len(scene.contact_forces) == len(contacts)
    weight = sum(abs(force[1]) for force in scene.contact_forces.tolist())
    assert weight == pytest.approx(thread.momentum.mass * 9.81, rel=0.05)


def test_a_discarded_body_goes_with_its_scene(context):
    scene = vb.Scene(context, mode="offline")
    thread = vb.Thread(context, segment_count=20)
    body = scene.add(thread)
    thread.discard()
    assert thread.closed
    scene.step()
    assert scene.bodies == [body]
    for make in (vb.Thread, vb.Drain, vb.Needle, vb.Grasper):
        alone = make(context)
        alone.discard()
        with pytest.raises(vb.InvalidHandleError):
            alone.discard()
    scene.close()


def test_what_is_in_a_scene_belongs_to_it(lying):
    scene, thread, body = lying
    for refused in (thread.step, thread.close, lambda: thread.cut(0.05)):
        with pytest.raises(vb.InSceneError):
            refused()
    assert scene.thread(body) is thread and scene.body(body) is thread
    scene.remove(body)
    thread.step()
    with pytest.raises(vb.NotFoundError):
        scene.thread(body)
    scene.add(thread)
    scene.close()
    thread.step()
    with pytest.raises(vb.InvalidHandleError):
        scene.step()


def test_a_scene_keeps_what_was_added(context):
    scene = vb.Scene(context)
    body = scene.add(vb.Thread(context, segment_count=4))
    scene.step()
    assert scene.thread(body).node_count == 5


def test_threads_are_pinned_and_cut(lying):
    scene, thread, body = lying
    ball = scene.add_rigid(BALL, position=(0.0, 0.05, 0.0))
    pin = scene.pin_thread(body, 0, 0)
    other = scene.pin_thread(body, 20, ball, (0.0, 0.0, 0.0))
    scene.set_rigid_target(ball, (0.0, 0.051, 0.0), orientation=(1, 0, 0, 0))
    scene.step()
    assert scene.rigid(ball).position == pytest.approx((0.0, 0.051, 0.0))
    assert scene.rigid(ball).kind is vb.SceneRigidKind.DRIVEN
    scene.unpin_thread(pin)
    scene.unpin_thread(other)
    piece = scene.cut_thread(body, 0.05)
    cut = scene.thread(piece)
    assert cut is scene.body(piece) and cut.node_count < 20
    (event,) = [event for event in scene.take_events() if event.kind is vb.SceneEventKind.CUT]
    assert (event.body_a, event.body_b, event.step) == (body, piece, scene.statistics.steps)
    assert event.arc_length == pytest.approx(0.05) and event.position == pytest.approx(cut.positions[0].tolist())
    assert scene.take_events() == [] and scene.lost_events == 0
    scene.step()
    assert cut.statistics.steps >= 1
    with pytest.raises(vb.NotFoundError):
        scene.unpin_thread(pin)
    with pytest.raises(vb.OutOfRangeError):
        scene.pin_thread(body, 99)


def test_a_grasper_holds_a_thread(context):
    scene = vb.Scene(context, mode="offline")
    thread = vb.Thread(context, segment_count=60, start=(-0.03, 0, 0), length=0.06, gravity=(0, 0, 0))
    tool = vb.Grasper(context)
    # The jaws open along x: turned by a quarter about z they open along y, about the thread.
    tool.set_target((0.0, 0.0, -2e-3), orientation=(math.sqrt(0.5), 0, 0, math.sqrt(0.5)))
    scene.add(thread)
    body = scene.add(tool)
    tool.set_opening(0.0)
    for _ in range(150):
        scene.step()
    grasps = scene.grasps(body)
    assert len(grasps) == tool.state.grasp_count == 1
    assert grasps[0] == scene.grasp(body, 0) and grasps[0].arc_length == pytest.approx(0.03, abs=1e-3)
    with pytest.raises(vb.NotFoundError):
        scene.grasp(body, 5)
    with pytest.raises(vb.IncompatibleError):
        scene.grasps(1)
    with pytest.raises(vb.NotFoundError):
        scene.grasps(3)


def test_needle_and_drain_are_bodies(context):
    scene = vb.Scene(context)
    drain, needle = vb.Drain(context), vb.Needle(context, position=(0.0, 0.1, 0.0))
    assert (scene.add(drain), scene.add(needle)) == (1, 2)
    scene.step()
    assert scene.holes == [] and needle.state.body == 2 and scene.body(1) is drain
    with pytest.raises(vb.NotFoundError):
        scene.hole(0)
    with pytest.raises(vb.InSceneError):
        needle.step()
    assert "2 bodies" in repr(scene)


def test_bodies_that_hold_each_other_back_are_listed(context):
    scene = vb.Scene(context, mode="offline")
    sticks = [scene.add_rigid([vb.Capsule((-0.01, 0, 0), (0.01, 0, 0), 1e-3)], kind="driven", position=(0, y, 0))
              for y in (0.0, 5e-3)]
    scene.step()
    assert scene.blockers == []
    scene.set_rigid_target(sticks[1], (0, -5e-3, 0))
    scene.step()
    (blocker,) = scene.blockers
    assert {blocker.body_a, blocker.body_b} == set(sticks)
    assert blocker.cause is vb.SceneBlockerCause.COLLISION and 0.0 < blocker.lost_time < 1e-3
    assert vb.SceneEventKind.BLOCKED in [event.kind for event in scene.take_events()]


def test_a_heavy_needle_goes_through_a_wall(context):
    scene = vb.Scene(context, mode="offline")
    scene.add(vb.Drain(context, puncture_force=0.5))
    quarter = math.sqrt(0.5)
    needle = vb.Needle(context, density=1e5, position=(1.5e-3, 0.0, 7.5e-3), orientation=(quarter, -quarter, 0, 0),
                       velocity=(0, 0, -5.0))
    body, events = scene.add(needle), []
    for _ in range(10):
        scene.step(2e-4)
        events += [event.kind for event in scene.take_events()]
        if scene.holes:
            break
    hole = scene.hole(0)
    assert scene.holes == [hole] and (hole.needle, hole.drain, hole.outward) == (body, 1, 0)
    assert vb.SceneEventKind.PUNCTURE in events and sum(hole.weights) == pytest.approx(1.0)


def test_a_thread_lies_in_a_hole_that_was_made_and_is_pulled_out(context):
    scene = vb.Scene(context, mode="offline")
    drain = vb.Drain(context, thread_force=1e-6)
    wall = scene.add(drain)
    mark = drain.places.marks[0]
    _, y, z = at = drain.positions[mark].tolist()
    across = (0.0, y / math.hypot(y, z), z / math.hypot(y, z))
    thread = vb.Thread(context, positions=[[a + 1e-3 * (i - 5) * n for a, n in zip(at, across)] for i in range(11)],
                       length=0.01)
    body = scene.add(thread)
    number, nodes = next((i, nodes) for i, nodes in enumerate(drain.triangles.tolist()) if mark in nodes)
    weights = [float(node == mark) for node in nodes]
    name = scene.make_hole(body, 5e-3, wall, number, weights)
    hole = scene.hole(0)
    assert (hole.id, hole.thread, hole.needle, hole.drain, hole.triangle) == (name, body, 0, wall, number)
    assert hole.arc_length == pytest.approx(5e-3, abs=1e-4) and hole.position == pytest.approx(at, abs=1e-4)
    for bad in ((body, 5e-3, wall, number, (1.0, 1.0, 0.0)), (body, 1.0, wall, number, weights)):
        with pytest.raises(vb.OutOfRangeError):
            scene.make_hole(*bad)
    with pytest.raises(vb.IncompatibleError):
        scene.make_hole(wall, 0.0, wall, 0, weights)
    end, events = thread.attach("pin", 10), []
    tip = thread.positions[10].tolist()
    for step in range(400):
        thread.set_attachment_target(end, [p + 2e-5 * (step + 1) * n for p, n in zip(tip, across)])
        scene.step()
        events += [event for event in scene.take_events() if event.kind is vb.SceneEventKind.UNTHREADED]
        if events:
            break
    assert [event[1:4] for event in events] == [(body, wall, name)] and scene.holes == []


def test_a_scene_is_loaded_from_its_bytes_alone(lying):
    scene = lying[0] if isinstance(lying, tuple) else lying
    scene.step()
    with vb.Context() as other:
        loaded = vb.Scene.load(scene.save(), other)
        assert loaded.state_hash == scene.state_hash
        loaded.step()
        scene.step()
        assert loaded.state_hash == scene.state_hash
        assert len(loaded.take_events()) >= 0 and loaded.lost_events == 0
        with pytest.raises(vb.TruncatedError):
            vb.Scene.load(b"not a state", other)


def test_scenes_are_saved_and_restored(lying):
    scene, _, _ = lying
    scene.step()
    saved, wanted = scene.save(), scene.state_hash
    scene.step()
    scene.restore(saved)
    assert scene.state_hash == wanted
    with pytest.raises(vb.TruncatedError):
        scene.restore(b"not a state")


def test_bad_bodies_are_refused(context):
    scene = vb.Scene(context)
    with pytest.raises(TypeError):
        scene.add(scene)
    with pytest.raises(vb.OutOfRangeError):
        scene.add_rigid([])
    with pytest.raises(ValueError):
        scene.add_rigid([((0, 0), (0, 0, 0), 1e-3)])
    with pytest.raises(vb.NotFiniteError):
        scene.add_rigid([((math.nan, 0, 0), (0, 0, 0), 1e-3)])
    with pytest.raises(TypeError, match="a rigid body has no setting 'weight'"):
        scene.add_rigid(BALL, weight=1.0)
    thread = vb.Thread(context)
    thread.close()
    with pytest.raises(vb.InvalidHandleError, match="the thread is closed"):
        scene.add(thread)



def test_memory_of_settings_is_that_of_a_scene(context):
    vb.Thread(context, segment_count=2)  # its handle takes the slots that handles of scenes use
    before = context.statistics.bytes_allocated
    wanted = vb.Scene.memory(context, node_capacity=100)
    assert context.statistics.bytes_allocated == before
    scene = vb.Scene(context, node_capacity=100)
    assert context.statistics.bytes_allocated - before == wanted < vb.Scene.memory(context) <= 8e6
    scene.close()


def test_a_prepared_scene_has_the_same_state(lying):
    scene, _, _ = lying
    before = scene.state_hash
    scene.prepare()
    assert scene.state_hash == before
    scene.step()


def test_events_wait_until_they_are_taken_and_lost_ones_are_counted(context):
    scene = vb.Scene(context, mode="offline", event_capacity=2)
    body = scene.add(vb.Thread(context, segment_count=20, cut_capacity=3))
    for cut in (0.08, 0.06, 0.04):
        scene.cut_thread(body, cut)
        scene.step()
    assert [event.arc_length for event in scene.take_events()] == pytest.approx([0.06, 0.04])
    assert scene.lost_events == 1 and scene.take_events() == [] and scene.lost_events == 1


def test_a_static_mesh_bears_a_thread(context):
    scene = vb.Scene(context)
    mesh = scene.add_static_mesh([(-0.05, 0, -0.05), (-0.05, 0, 0.05), (0.05, 0, 0.05), (0.05, 0, -0.05)],
                                 [(0, 1, 2), (0, 2, 3)], friction=0.3, thickness=1e-3)
    assert scene.body_info(mesh).kind is vb.SceneBodyKind.STATIC_MESH
    with pytest.raises(vb.Error):
        scene.add_static_mesh([(0, 0, 0), (0, 0, 1), (1, 0, 0)], [(0, 1, 3)])


def test_a_rigid_mesh_moves_with_its_target(context):
    scene = vb.Scene(context)
    square = [(-0.01, 0, -0.01), (-0.01, 0, 0.01), (0.01, 0, 0.01), (0.01, 0, -0.01)]
    driven = scene.add_rigid_mesh(square, [(0, 1, 2), (0, 2, 3)], thickness=1e-3, friction=0.25)
    free = scene.add_rigid_mesh(square, [(0, 1, 2), (0, 2, 3)], kind="free", mass=2e-3, position=(0.1, 0.05, 0))
    assert scene.body_info(driven).kind is vb.SceneBodyKind.RIGID and scene.body_info(driven).friction == 0.25
    scene.set_rigid_target(driven, (0.002, 0.003, 0))
    scene.step()
    found = scene.find_nearest((0.002, 0.02, 0.001), 0.05)
    assert found.body == driven and found.distance == pytest.approx(0.02 - 0.003 - 0.5e-3, abs=1e-9)
    assert scene.rigid(free).position == pytest.approx((0.1, 0.05, 0))
    with pytest.raises(vb.OutOfRangeError):
        scene.add_rigid_mesh(square, [(0, 1, 4)])
    with pytest.raises(TypeError):
        scene.add_rigid_mesh(square, [(0, 1, 2)], thicknes=1e-3)


def test_sampled_geometry_is_a_static_mesh(context):
    scene = vb.Scene(context)
    ground = scene.add_height_field([[0.0, 1e-3, 0.0], [0.0, 2e-3, 0.0]], spacing=(2e-3, 3e-3), friction=0.2)
    side = [-3e-3 + 1e-3 * i for i in range(7)]
    ball = scene.add_distance_field([math.sqrt(x * x + y * y + z * z) - 2e-3 for z in side for y in side for x in side],
                                    (7, 7, 7), position=(0.05, -3e-3, -3e-3))
    assert scene.body_info(ground).kind is scene.body_info(ball).kind is vb.SceneBodyKind.STATIC_MESH
    found = scene.find_nearest((0.053, 5e-3, 0.0), 0.01)
    assert found.body == ball and found.distance == pytest.approx(3e-3, abs=0.4e-3)
    with pytest.raises(ValueError):
        scene.add_height_field([[0.0, 1.0], [0.0]])
    with pytest.raises(vb.OutOfRangeError):
        scene.add_distance_field([1.0] * 8, (2, 2, 3))


def test_planes_hold_a_thread(context):
    scene = vb.Scene(context)
    planes = [scene.add_plane((side, 1, 0), friction=0.0) for side in (-1.0, 1.0)]
    thread = vb.Thread(context, segment_count=10, start=(0, 2e-3, -5e-3), direction=(0, 0, 1), length=0.01)
    scene.add(thread)
    for _ in range(400):
        scene.step()
    assert scene.body_info(planes[0]).kind is vb.SceneBodyKind.PLANE
    forces = [scene.rigid(plane).contact_force for plane in planes]
    assert forces[0][0] == pytest.approx(-forces[1][0], rel=1e-6) and forces[0][1] < 0
    with pytest.raises(vb.Error):
        scene.add_plane((0, 0, 0))


def test_a_host_surface_lifts_a_thread_and_returns_forces(context):
    scene = vb.Scene(context)
    corners = [(-0.05, 0, -0.05), (-0.05, 0, 0.05), (0.05, 0, 0.05), (0.05, 0, -0.05)]
    surface = scene.add_surface(corners, [(0, 1, 2), (0, 2, 3)], friction=0.3, jump_limit=1e-3)
    thread = vb.Thread(context, length=0.04, segment_count=20, start=(-0.02, 1e-3, 0), gravity=(0, -9.81, 0))
    scene.add(thread)
    for step in range(1, 101):
        corners = [(x, 1e-5 * step, z) for x, _, z in corners]
        scene.move_surface(surface, corners)
        scene.step(1e-3)
    forces = scene.surface(surface)
    assert len(forces) == 4 and sum(force[1] for force in forces) < -1e-5
    assert scene.surface(surface, vb.SceneSurfaceField.POSITIONS)[2][1] == pytest.approx(1e-3)
    assert scene.body_info(surface).kind is vb.SceneBodyKind.SURFACE
    assert all(position[1] > 0.5e-3 for position in thread.positions)
    with pytest.raises(vb.Error):
        scene.move_surface(surface, [(x, 0.1, z) for x, _, z in corners])


def test_a_host_surface_yields_to_forces(context):
    corners = [(-0.05, 0, -0.05), (-0.05, 0, 0.05), (0.05, 0, 0.05), (0.05, 0, -0.05)]
    heights = []
    for compliance in (0.0, 10.0):  # m/N
        scene = vb.Scene(context)
        surface = scene.add_surface(corners, [(0, 1, 2), (0, 2, 3)], compliance_size=1)
        scene.set_surface_compliance(surface, [compliance] * 4)
        thread = vb.Thread(context, length=0.04, segment_count=20, start=(-0.02, 0.3e-3, 0), gravity=(0, -9.81, 0))
        scene.add(thread)
        for _ in range(100):
            scene.step(1e-3)
        heights.append(sum(position[1] for position in scene.surface(surface, vb.SceneSurfaceField.POSITIONS)))
    assert heights[0] == 0.0 and heights[1] < -1e-5, heights
    with pytest.raises(vb.Error):
        scene.set_surface_compliance(surface, [1.0] * 3)


def test_a_stitch_survives_another_mesh_of_a_host_surface(context):
    scene = vb.Scene(context, mode="offline", floor=False)
    corners = [(-0.05, 0, -0.05), (-0.05, 0, 0.05), (0.05, 0, 0.05), (0.05, 0, -0.05)]
    finer, triangles = [*corners, (0, 0, 0)], [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]
    surface = scene.add_surface(corners, [(0, 1, 2), (0, 2, 3)], thread_force=0.5)
    thread = vb.Thread(context, length=0.02, segment_count=20, start=(0.01, 0.01, 0.005), direction=(0, -1, 0))
    suture = scene.add(thread)
    hole = scene.make_hole(suture, 0.01, surface, 1, (0.4, 0.55, 0.05))
    for _ in range(20):
        scene.step(1e-3)
    before, asked = scene.holes[0], []
    with pytest.raises(ValueError):
        scene.remesh_surface(surface, finer, triangles, lambda place: (1, (0.5, 0.5)))
    with pytest.raises(vb.OutOfRangeError):
        scene.remesh_surface(surface, finer, triangles, lambda place: (0, (1, 0, 0)))
    assert scene.holes[0] == before

    def place(old):
        asked.append((old.hole, old.triangle, list(old.position), old.normal[1]))
        return None

    scene.remesh_surface(surface, finer, triangles, place)
    after = scene.holes[0]
    assert asked == [(hole, 1, pytest.approx(list(before.position)), pytest.approx(1.0))]
    assert after.id == hole and list(after.position) == pytest.approx(list(before.position))
    scene.step(1e-3)
    assert list(scene.holes[0].force) == pytest.approx(list(before.force), abs=1e-5)
    assert len(scene.surface(surface)) == 5
    scene.remesh_surface(surface, corners, [(0, 1, 2), (0, 2, 3)])
    assert scene.holes[0].triangle == before.triangle


def tearing_scene(context, wall):
    """A thread through a square sheet in the plane y = 0, with both ends pinned; the sheet is a host surface or a drain."""
    scene = vb.Scene(context, mode="offline", floor=False)
    corners = [(-0.01, 0, -0.01), (-0.01, 0, 0.01), (0.01, 0, 0.01), (0.01, 0, -0.01)]
    triangles, settings = [(0, 1, 2), (0, 2, 3)], {"thickness": 1e-3, "tear_energy": 500.0}
    if wall == "host":
        body = scene.add_surface(corners, triangles, **settings)
    else:
        sheet = {"positions": corners, "triangles": triangles, "anchors": [0, 1]}
        body = scene.add(vb.Drain(context, surface=sheet, young_modulus=5e7, **settings))
    thread = vb.Thread(context, length=0.02, segment_count=40, start=(0.005, 0.01, -0.002), direction=(0, -1, 0))
    suture = scene.add(thread)
    hole = scene.make_hole(suture, 0.01, body, 1, (0.25, 0.4, 0.35))
    return scene, thread, body, suture, hole, [thread.attach("pin", node) for node in (0, 40)]


def pull(scene, thread, pins, steps, begin=0):
    events = []
    for step in range(begin, begin + steps):
        for pin, y in zip(pins, (0.01, -0.01)):
            thread.set_attachment_target(pin, (0.005 + 5e-5 * (step + 1), y, -0.002))
        scene.step(1e-3)
        events += scene.take_events()
    return events


@pytest.mark.parametrize("wall", ["host", "drain"])
def test_a_thread_tears_out_of_a_sheet(context, wall):
    scene, thread, body, suture, hole, pins = tearing_scene(context, wall)
    at = scene.holes[0].position[0]
    events = pull(scene, thread, pins, 60)
    torn = scene.holes[0]
    assert [event[1:4] for event in events if event.kind is vb.SceneEventKind.TEARING] == [(suture, body, hole)]
    assert 1e-3 < torn.torn_length < 3e-3 and torn.tear_work == pytest.approx(0.5 * torn.torn_length, rel=0.01)
    assert scene.statistics.torn_length == torn.torn_length and scene.statistics.tear_work == torn.tear_work
    with vb.Context() as other:
        loaded = vb.Scene.load(scene.save(), other)
        assert loaded.state_hash == scene.state_hash and loaded.holes == scene.holes
        scene.step(1e-3)
        loaded.step(1e-3)
        assert loaded.state_hash == scene.state_hash
        loaded.close()
    events = pull(scene, thread, pins, 200, 60)
    out = [event for event in events if event.kind is vb.SceneEventKind.TORN_OUT]
    assert [event[1:4] for event in out] == [(suture, body, hole)] and scene.holes == []
    assert out[0].value == scene.statistics.torn_length == pytest.approx(0.01 - at, abs=1e-4)


def test_only_method_vblast_has_baseline_statistics():
    with vb.Scene(method="vblast") as scene:
        thread = vb.Thread(scene.context, method="vblast", length=0.1, segment_count=20)
        scene.add(thread)
        scene.step(1e-3)
        assert scene.baseline_statistics.passes == 1
        assert scene.statistics.attempts == 0
        assert thread.baseline_statistics.projection_iterations > 0
        assert thread.statistics.iterations == 0
    with vb.Collision(method="vblast") as collision:
        assert collision.baseline_statistics.sign_tests_ended == 0
    with vb.Scene() as scene:
        with pytest.raises(vb.IncompatibleError):
            scene.baseline_statistics
