"""Changes of a running scene, bodies by number, and queries."""
import pytest

import vblast_ss as vb

BALL = [((0, 0, 0), (0, 0, 0), 5e-3)]


@pytest.fixture
def stage(context):
    scene = vb.Scene(context, floor=True, floor_height=-1.0)
    return scene, scene.add_rigid(BALL, kind="free"), scene.add_rigid(BALL, kind="coupled", position=(0.1, 0, 0))


def test_a_changed_gravity_accelerates(stage):
    scene, ball, tool = stage
    scene.set_gravity((0, -2.0, 0))
    for _ in range(10):
        scene.step()
    assert scene.rigid(ball).velocity[1] == pytest.approx(-0.02)
    assert scene.body_info(ball).gravity[1] == -2.0 and scene.body_info(tool).gravity[1] == 0.0


def test_settings_are_those_that_were_set(stage):
    scene, ball, tool = stage
    before = scene.state_hash
    scene.set_friction(ball, 0.7)
    scene.set_friction(0, 0.2)
    scene.set_thread_friction(0.05)
    scene.set_coupling(tool, 100.0, 1.0, 0.1, 0.001)
    scene.set_speed_limit(3.0)
    scene.set_filter(ball, 2, 0xfffffffe)
    assert scene.state_hash != before
    info = scene.body_info(ball)
    assert (info.friction, info.category, info.mask) == (0.7, 2, 0xfffffffe)
    assert scene.body_info(0).kind == vb.SceneBodyKind.FLOOR and scene.body_info(0).friction == 0.2
    with pytest.raises(vb.IncompatibleError):
        scene.set_coupling(ball, 1.0, 1.0, 1.0, 1.0)


def test_forces_and_poses_of_free_bodies(stage):
    scene, ball, _ = stage
    scene.set_rigid_pose(ball, (0, 0.2, 0), (1, 0, 0, 0))
    scene.set_rigid_velocity(ball, (1, 0, 0), (0, 0, 2))
    state = scene.rigid(ball)
    assert tuple(state.position) == (0, 0.2, 0) and tuple(state.velocity) == (1, 0, 0)
    scene.apply_force(ball, (0, 0.02, 0), point=(0, 0.2, 0), torque=(0, 0, 0))
    scene.step()
    assert scene.rigid(ball).velocity[1] == pytest.approx(1e-3)


def test_bodies_are_found_by_number(context):
    scene = vb.Scene(context)
    ball = scene.add_rigid(BALL)
    drain, needle, grasper = (scene.add(one(context)) for one in (vb.Drain, vb.Needle, vb.Grasper))
    assert scene.bodies == [ball, drain, needle, grasper]
    kinds = [scene.body_info(body).kind for body in scene.bodies]
    assert kinds == [vb.SceneBodyKind.RIGID, vb.SceneBodyKind.DRAIN, vb.SceneBodyKind.NEEDLE, vb.SceneBodyKind.GRASPER]
    assert len({scene.drain_handle(drain), scene.needle_handle(needle), scene.grasper_handle(grasper)}) == 3
    with pytest.raises(vb.IncompatibleError):
        scene.needle_handle(ball)
    assert scene.user_data(ball) == 0
    scene.set_user_data(ball, 12345)
    assert scene.user_data(ball) == 12345


def test_rays_and_nearest_bodies(stage):
    scene, ball, tool = stage
    hit = scene.cast_ray((-0.1, 0, 0), (1, 0, 0))
    assert hit.is_hit and hit.body == ball and hit.point[0] == pytest.approx(-5e-3) and hit.normal[0] == -1
    assert not scene.cast_ray((-0.1, 0, 0), (1, 0, 0), mask=2).is_hit
    near = scene.find_nearest((0.12, 0, 0), 0.05)
    assert near.is_found and near.body == tool and near.distance == pytest.approx(0.015)
    assert not scene.find_nearest((0.12, 0, 0), 0.01).is_found


def test_changes_are_in_the_log(stage):
    scene, ball, _ = stage
    record = vb.Record(scene, hash_interval=1)
    record.apply_input("setting", (vb.SceneSetting.GRAVITY, ball), (0, -2.0, 0))
    record.attach_to_scene()
    scene.step()
    record.end()
    log = record.take()
    other = vb.Scene(scene.context, floor=True, floor_height=-1.0)
    other.add_rigid(BALL, kind="free")
    other.add_rigid(BALL, kind="coupled", position=(0.1, 0, 0))
    replay = vb.Replay(log, context=scene.context)
    replay.begin(other)
    replay.step()
    assert other.state_hash == scene.state_hash
