/* Bodies of a scene that hold the section of a thread with twist: pins on rigid bodies, and jaws. */
#include <stdlib.h>

#include "base/pi.h"
#include "base/rotation.h"
#include "scene/tools_rig.h"

static const double torsion = 0.7e-8, length = 0.03; /* N m^2, m */

enum { SEGMENTS = 30 };

/* A thread along x, clamped at the origin and pinned to the middle of a stick at its other end. */
typedef struct twisted {
    small s;
    vbss_thread *thread;
    uint32_t body, stick, pin;
} twisted;

static void clamp_node(vbss_thread *thread, uint32_t node, vec3 position, vec3 direction)
{
    vbss_thread_attachment a;
    uint32_t id;
    expect_ok(vbss_thread_attachment_init(&a, sizeof a));
    a.kind = VBSS_THREAD_ATTACHMENT_CLAMP;
    a.node = node;
    vec3_store(a.position, position);
    vec3_store(a.direction, direction);
    expect_ok(vbss_thread_attach(thread, &a, &id));
}

static void twisted_begin(twisted *w, vbss_scene_rigid_kind kind, double spin)
{
    const vec3 along = vec3_make(1.0, 0.0, 0.0), end = vec3_make(length, 0.0, 0.0);
    small_begin_scene(&w->s);
    w->s.thread.torsional_stiffness = torsion;
    w->s.rigid.mass = 1e-5;
    w->s.rigid.angular_velocity[0] = spin;
    w->body = small_thread(&w->s, vec3_zero(), end, SEGMENTS, &w->thread);
    clamp_node(w->thread, 0, vec3_zero(), along);
    w->stick = small_stick(&w->s, kind, end, vec3_make(0.0, 0.0, 2e-3), 3e-4);
    w->pin = small_pin(&w->s, w->body, SEGMENTS, w->stick);
}

static double twist_of(vbss_thread *thread, uint32_t segment)
{
    vbss_view view;
    expect_ok(vbss_thread_get_view(thread, VBSS_THREAD_VIEW_TWISTS, &view, sizeof view));
    assert_true(segment < view.count);
    return ((const double *)view.data)[segment];
}

static double stick_angle(const twisted *w)
{
    const vbss_scene_rigid_state state = small_rigid(&w->s, w->stick);
    return 2.0 * atan2(state.orientation[1], state.orientation[0]);
}

static void turn_stick(const twisted *w, double angle)
{
    const quat q = vbss_quat_from_rotation_vector(vec3_make(angle, 0.0, 0.0));
    const double target[3] = {length, 0.0, 0.0}, turned[4] = {q.w, q.x, q.y, q.z};
    expect_ok(vbss_scene_set_rigid_target(w->s.scene, w->stick, target, turned));
}

/* Two turns of a driven body are two turns of the thread, and the body feels the torque. Unpinned, the
 * thread unwinds. */
static void driven_body_twists_its_thread(void **state)
{
    (void)state;
    twisted w;
    twisted_begin(&w, VBSS_SCENE_RIGID_DRIVEN, 0.0);
    for (int k = 1; k <= 400; k++) {
        turn_stick(&w, 2.0 * VBSS_TWO_PI * k / 400.0);
        small_steps(&w.s, 1, 1e-3);
    }
    small_steps(&w.s, 3, 1e-3);
    const double wanted = 2.0 * VBSS_TWO_PI / length;
    expect_near(wanted, twist_of(w.thread, 3), 1e-6 * wanted);
    const vbss_scene_rigid_state stick = small_rigid(&w.s, w.stick);
    expect_near(-torsion * wanted, stick.contact_torque[0], 1e-3 * torsion * wanted);
    expect_near(-torsion * wanted, stick.hand_torque[0], 1e-3 * torsion * wanted);
    expect_ok(vbss_scene_unpin_thread(w.s.scene, w.pin));
    small_steps(&w.s, 1, 1e-3);
    expect_near(0.0, twist_of(w.thread, 3), 1e-20);
    small_end(&w.s);
}

/* A free body on the end of a thread is a torsion pendulum of frequency sqrt(GJ / (L I)), which loses
 * energy and never gains it. */
static void free_body_is_torsion_pendulum(void **state)
{
    (void)state;
    twisted w;
    twisted_begin(&w, VBSS_SCENE_RIGID_FREE, 20.0);
    const scene_rigid *r = &vbss_scene_body(small_object(&w.s), w.stick)->rigid;
    const double inertia = vbss_rigid_world_inertia(&r->body, r->body.now.pose.orientation).m[0][0];
    const double frequency = sqrt(torsion / (length * inertia)) / VBSS_TWO_PI, h = 2e-4;
    double before = 0.0, first = 0.0, last = 0.0, peak = 0.0, first_peak = 0.0;
    int crossings = 0;
    for (int k = 1; k <= 2500; k++) {
        small_steps(&w.s, 1, h);
        const double now = stick_angle(&w);
        peak = fmax(peak, fabs(now));
        if (before < 0.0 && now >= 0.0) {
            last = h * (k - now / (now - before));
            first = crossings == 0 ? last : first;
            first_peak = crossings == 0 ? peak : first_peak;
            assert_true(peak <= first_peak * (1.0 + 1e-6));
            peak = 0.0;
            crossings++;
        }
        before = now;
    }
    assert_true(crossings > 5);
    expect_near(1.0, (crossings - 1) / (last - first) / frequency, 0.01);
    expect_near(20.0 / (VBSS_TWO_PI * frequency), first_peak, 0.05 * first_peak);
    small_end(&w.s);
}

static void restored_scene_continues_with_same_bits(void **state)
{
    (void)state;
    twisted w;
    twisted_begin(&w, VBSS_SCENE_RIGID_FREE, 20.0);
    small_steps(&w.s, 100, 1e-3);
    small_state saved = small_save(&w.s);
    small_steps(&w.s, 50, 1e-3);
    const uint64_t wanted = small_hash(&w.s);
    expect_ok(vbss_scene_restore(w.s.scene, saved.bytes, saved.count));
    small_steps(&w.s, 50, 1e-3);
    assert_true(wanted == small_hash(&w.s));
    vbss_scene *loaded = NULL;
    expect_ok(vbss_scene_load(w.s.context, saved.bytes, saved.count, &loaded));
    for (int k = 0; k < 50; k++) {
        expect_ok(vbss_scene_step(loaded, 1e-3));
    }
    uint64_t hash = 0;
    expect_ok(vbss_scene_get_hash(loaded, &hash));
    assert_true(wanted == hash);
    expect_ok(vbss_scene_destroy(loaded));
    free(saved.bytes);
    small_end(&w.s);
}

/* Jaws that turn about a thread twist it between themselves and a clamp; the hand feels the torque. */
static void jaws_twist_the_thread_that_they_grasp(void **state)
{
    (void)state;
    const vec3 home = vec3_make(0.0, 0.0, -2e-3);
    tools_rig r;
    tools_begin(&r);
    r.s.thread.torsional_stiffness = torsion;
    small_create(&r.s);
    tools_thread(&r, TOOLS_NEITHER, 0.0);
    clamp_node(r.thread, 0, tools_node(&r, 0), vec3_make(0.0, 1.0, 0.0));
    tools_add(&r, home);
    tools_close(&r, 0);
    assert_int_equal(tools_state(&r, 0).grasp_count, 1);
    const double before = twist_of(r.thread, 3), angle = 1.0;
    for (int k = 1; k <= 400; k++) {
        const quat q = vbss_quat_from_rotation_vector(vec3_make(0.0, angle * k / 400.0, 0.0));
        double position[3];
        const double orientation[4] = {q.w, q.x, q.y, q.z};
        vec3_store(position, quat_rotate(q, home));
        expect_ok(vbss_grasper_set_target(r.tools[0], position, orientation));
        tools_steps(&r, 1);
    }
    tools_steps(&r, 300);
    assert_int_equal(tools_state(&r, 0).grasp_count, 1);
    const double arc = tools_grasp(&r, 0, 0).arc_length;
    expect_near(angle / arc, twist_of(r.thread, 3) - before, 0.05 * angle / arc);
    tools_end(&r);
}

int test_twist_holders(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(driven_body_twists_its_thread),
        cmocka_unit_test(free_body_is_torsion_pendulum),
        cmocka_unit_test(restored_scene_continues_with_same_bits),
        cmocka_unit_test(jaws_twist_the_thread_that_they_grasp),
    };
    return cmocka_run_group_tests_name("scene.twist_holders", tests, NULL, NULL);
}
