/* Threads with friction torque: contacts that hold twist up to their friction, and threads that roll. */
#include <stdlib.h>

#include "scene/small.h"
#include "thread/twist.h"

enum { SEGMENTS = 31, MIDDLE = 15 };
static const double torsion = 0.7e-8, length = 0.031;                       /* N m^2, m */
static const double friction = 0.3, rod_radius = 0.5e-3, squeeze = 0.05e-6; /* 1, m, m */

/* ---- a thread between two rods across it, clamped at both ends */

typedef struct squeezed {
    small s;
    vbss_thread *thread;
    uint32_t body, rods[2], clamps[2];
} squeezed;

static uint32_t clamp_node(vbss_thread *thread, uint32_t node, vec3 position)
{
    vbss_thread_attachment a;
    uint32_t id;
    expect_ok(vbss_thread_attachment_init(&a, sizeof a));
    a.kind = VBSS_THREAD_ATTACHMENT_CLAMP;
    a.node = node;
    vec3_store(a.position, position);
    expect_ok(vbss_thread_attach(thread, &a, &id));
    return id;
}

static double rod_height(const squeezed *w, double overlap)
{
    return rod_radius + w->s.thread.radius - overlap;
}

static void move_rods(squeezed *w, double overlap)
{
    const double x = 0.5 * length, y = rod_height(w, overlap);
    small_move(&w->s, w->rods[0], vec3_make(x, y, 0.0));
    small_move(&w->s, w->rods[1], vec3_make(x, -y, 0.0));
}

/* The rods are apart from the thread at first, and press it after some steps. */
static void squeezed_begin(squeezed *w, uint32_t friction_torque)
{
    const vec3 half = vec3_make(0.0, 0.0, 2e-3);
    small_begin_scene(&w->s);
    w->s.thread.torsional_stiffness = torsion;
    w->s.thread.friction_torque = friction_torque;
    w->s.rigid.friction = friction;
    w->body = small_thread(&w->s, vec3_zero(), vec3_make(length, 0.0, 0.0), SEGMENTS, &w->thread);
    w->clamps[0] = clamp_node(w->thread, 0, vec3_zero());
    w->clamps[1] = clamp_node(w->thread, SEGMENTS, vec3_make(length, 0.0, 0.0));
    for (int k = 0; k < 2; k++) {
        const double y = rod_height(w, -1e-4);
        w->rods[k] = small_stick(&w->s, VBSS_SCENE_RIGID_DRIVEN,
                                 vec3_make(0.5 * length, k == 0 ? y : -y, 0.0), half, rod_radius);
    }
    move_rods(w, 0.0);
    small_steps(&w->s, 1, 1e-3);
    move_rods(w, squeeze);
    small_steps(&w->s, 20, 1e-3);
}

/* Torque that the thread transmits, N m, positive for a positive roll of the first end: at either clamp. */
static double torque(const squeezed *w, int end)
{
    vbss_thread_reaction reaction;
    expect_ok(vbss_thread_get_reaction(w->thread, w->clamps[end], &reaction, sizeof reaction));
    return end == 0 ? reaction.torque[0] : -reaction.torque[0];
}

static double press(const squeezed *w)
{
    return -vec3_load(small_rigid(&w->s, w->rods[1]).contact_force).y;
}

static void roll_to(squeezed *w, double angle)
{
    expect_ok(vbss_thread_set_roll(w->thread, w->clamps[0], angle));
    small_steps(&w->s, 1, 1e-3);
}

static double twist_energy(const squeezed *w)
{
    vbss_thread_energies e;
    expect_ok(vbss_thread_get_energies(w->thread, &e, sizeof e));
    return e.twisting;
}

/* Largest torque of both rods about the thread, N m. */
static double bound_of(const squeezed *w)
{
    return 2.0 * friction * press(w) * w->s.thread.radius;
}

/* Roll of the clamp at which the rods slip, rad. */
static double slip_roll(const squeezed *w)
{
    return bound_of(w) * 0.5 * length / torsion;
}

/* A contact that slips notices that its motion has reversed after a step: this much of the bound is lost. */
static const double reversal = 0.02;

/* Rolled at one end, the thread bears no torque beyond the rods until the friction of both is used up, and then
 * that much less than before them. Rolled back, the rods slip again after twice that torque. */
static void far_torque_is_near_torque_less_friction(void **state)
{
    (void)state;
    squeezed w;
    squeezed_begin(&w, 1);
    const double bound = bound_of(&w), slips = slip_roll(&w);
    assert_true(bound > 5e-7);
    for (int k = 1; k <= 100; k++) {
        const double angle = 2.5 * slips * k / 100.0;
        roll_to(&w, angle);
        const double alone = torsion * angle / (0.5 * length), near = torque(&w, 0),
                     far = torque(&w, 1);
        expect_near(angle < slips ? alone : 0.5 * (alone + bound), near, 2e-3 * bound);
        expect_near(angle < slips ? 0.0 : near - bound, far, 2e-3 * bound);
    }
    const double far = torque(&w, 1);
    for (int k = 1; k <= 100; k++) {
        const double angle = (2.5 - 1.9 * k / 100.0) * slips;
        roll_to(&w, angle);
        expect_near(far, torque(&w, 1), reversal * bound);
    }
    roll_to(&w, 0.0);
    expect_near(torque(&w, 0) + bound, torque(&w, 1), reversal * bound);
    small_end(&w.s);
}

static void contacts_let_thread_roll_unless_asked(void **state)
{
    (void)state;
    squeezed w;
    squeezed_begin(&w, 0);
    roll_to(&w, 2.0);
    const double wanted = torsion * 2.0 / length;
    expect_near(wanted, torque(&w, 0), 1e-9 * wanted);
    expect_near(wanted, torque(&w, 1), 1e-9 * wanted);
    small_end(&w.s);
}

/* The work of rolling is stored as twist, or is that of friction: its torque times the roll at the rods. */
static void work_of_rolling_is_stored_or_dissipated(void **state)
{
    (void)state;
    squeezed w;
    squeezed_begin(&w, 1);
    const double bound = bound_of(&w), slips = slip_roll(&w);
    double work = 0.0, friction_work = 0.0, before = torque(&w, 0), slipped = 0.0;
    for (int k = 1; k <= 600; k++) {
        const double roll = slips * (k <= 300 ? k / 100.0 : 3.0 - (k - 300) / 60.0);
        roll_to(&w, roll);
        const double near = torque(&w, 0), step = slips * (k <= 300 ? 0.01 : -1.0 / 60.0);
        const double at_rods = torque(&w, 1) * 0.5 * length / torsion;
        work += 0.5 * (before + near) * step;
        friction_work += (near - torque(&w, 1)) * (at_rods - slipped);
        assert_true((near - torque(&w, 1)) * (at_rods - slipped) > -reversal * bound * slips);
        before = near;
        slipped = at_rods;
    }
    assert_true(friction_work > 2.0 * bound * slips);
    expect_near(work, twist_energy(&w) + friction_work, 0.01 * work);
    small_end(&w.s);
}

/* Let go at the rolled end, the thread loses its twist up to the rods, which hold that beyond them. */
static void contact_holds_twist_beyond_it(void **state)
{
    (void)state;
    squeezed w;
    squeezed_begin(&w, 1);
    for (int k = 1; k <= 50; k++) {
        roll_to(&w, 1.8 * slip_roll(&w) * k / 50.0);
    }
    const double held = torque(&w, 1);
    assert_true(held > 0.3 * bound_of(&w));
    expect_ok(vbss_thread_detach(w.thread, w.clamps[0]));
    small_steps(&w.s, 20, 1e-3);
    expect_near(held, torque(&w, 1), 0.01 * held);
    vbss_view twists;
    expect_ok(vbss_thread_get_view(w.thread, VBSS_THREAD_VIEW_TWISTS, &twists, sizeof twists));
    expect_near(0.0, ((const double *)twists.data)[MIDDLE - 2], 1e-9);
    expect_near(-held / torsion, ((const double *)twists.data)[MIDDLE + 2], 1e-3 * held / torsion);
    small_end(&w.s);
}

/* The friction of a thread that slides along itself while it turns has the direction of its surface's
 * motion: force and torque share one cone. */
static void sliding_and_rolling_share_one_cone(void **state)
{
    (void)state;
    squeezed w;
    squeezed_begin(&w, 1);
    const double speed = 2e-3, spin = 10.0, radius = w.s.thread.radius; /* m/s, rad/s */
    const double surface = spin * radius, size = sqrt(speed * speed + surface * surface);
    for (int k = 1; k <= 400; k++) {
        for (int end = 0; end < 2; end++) {
            const double target[3] = {(end == 0 ? 0.0 : length) + speed * 1e-3 * k, 0.0, 0.0};
            expect_ok(vbss_thread_set_attachment_target(w.thread, w.clamps[end], target, NULL));
            expect_ok(vbss_thread_set_roll(w.thread, w.clamps[end], spin * 1e-3 * k));
        }
        small_steps(&w.s, 1, 1e-3);
    }
    const double bound = 2.0 * friction * press(&w), got = torque(&w, 0) - torque(&w, 1);
    const double along = -2.0 * vec3_load(small_rigid(&w.s, w.rods[0]).contact_force).x;
    expect_near(bound * speed / size, fabs(along), 0.01 * bound);
    expect_near(bound * radius * surface / size, got, 0.01 * bound * radius);
    small_end(&w.s);
}

/* ---- a thread on the floor, which slopes down to +z */

typedef struct laid {
    small s;
    vbss_thread *thread;
} laid;

static const double slope = 0.15; /* rad, less than the angle of friction */

static void laid_begin(laid *w, uint32_t friction_torque)
{
    small_begin(&w->s);
    w->s.config.floor = 1;
    w->s.config.floor_friction = friction;
    small_create(&w->s);
    w->s.thread.torsional_stiffness = torsion;
    w->s.thread.friction_torque = friction_torque;
    w->s.thread.gravity[1] = -9.81 * cos(slope);
    w->s.thread.gravity[2] = 9.81 * sin(slope);
    const double y = w->s.thread.radius;
    (void)small_thread(&w->s, vec3_make(0.0, y, 0.0), vec3_make(0.02, y, 0.0), 20, &w->thread);
}

/* Nothing resists its roll, so it rolls without slipping, and as it has no spin inertia it is as fast as
 * without friction. */
static void laid_thread_rolls_without_slipping(void **state)
{
    (void)state;
    laid w;
    laid_begin(&w, 1);
    small_steps(&w.s, 100, 1e-3);
    const double drop = 0.5 * 9.81 * sin(slope) * 0.1 * 0.1;
    for (uint32_t i = 0; i <= 20; i += 5) {
        expect_near(drop, small_node(w.thread, i).z, 0.02 * drop);
    }
    const double before = small_node(w.thread, 10).z;
    small_steps(&w.s, 1, 1e-3);
    const thread_object *t = vbss_scene_body(small_object(&w.s), 1)->thread.thread;
    const double rolled = t->roll_angles[10] * t->config.radius;
    expect_near(small_node(w.thread, 10).z - before, rolled, 1e-3 * rolled);
    small_end(&w.s);
}

/* Without friction torque it sticks, and so it does if both ends keep it from rolling. */
static void laid_thread_sticks_if_it_cannot_roll(void **state)
{
    (void)state;
    for (uint32_t on = 0; on < 2; on++) {
        laid w;
        laid_begin(&w, on);
        for (uint32_t node = 0; on != 0 && node <= 20; node++) {
            vbss_thread_attachment a;
            uint32_t id;
            expect_ok(vbss_thread_attachment_init(&a, sizeof a));
            a.kind = VBSS_THREAD_ATTACHMENT_ROLL;
            a.node = node;
            if (node % 4 == 0) {
                expect_ok(vbss_thread_attach(w.thread, &a, &id));
            }
        }
        small_steps(&w.s, 100, 1e-3);
        expect_near(0.0, small_node(w.thread, 10).z, 2e-5);
        small_end(&w.s);
    }
}

/* ---- state */

static void restored_scene_continues_with_same_bits(void **state)
{
    (void)state;
    squeezed w;
    squeezed_begin(&w, 1);
    const double slips = slip_roll(&w);
    roll_to(&w, 1.5 * slips);
    small_state saved = small_save(&w.s);
    roll_to(&w, 2.0 * slips);
    small_steps(&w.s, 20, 1e-3);
    const uint64_t wanted = small_hash(&w.s);
    expect_ok(vbss_scene_restore(w.s.scene, saved.bytes, saved.count));
    roll_to(&w, 2.0 * slips);
    small_steps(&w.s, 20, 1e-3);
    assert_true(wanted == small_hash(&w.s));
    vbss_scene *loaded = NULL;
    vbss_thread *thread = NULL;
    expect_ok(vbss_scene_load(w.s.context, saved.bytes, saved.count, &loaded));
    expect_ok(vbss_scene_get_thread(loaded, w.body, &thread));
    expect_ok(vbss_thread_set_roll(thread, w.clamps[0], 2.0 * slips));
    for (int k = 0; k < 21; k++) {
        expect_ok(vbss_scene_step(loaded, 1e-3));
    }
    uint64_t hash = 0;
    expect_ok(vbss_scene_get_hash(loaded, &hash));
    assert_true(wanted == hash);
    expect_ok(vbss_scene_destroy(loaded));
    free(saved.bytes);
    small_end(&w.s);
}

int test_friction_torque(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(far_torque_is_near_torque_less_friction),
        cmocka_unit_test(contacts_let_thread_roll_unless_asked),
        cmocka_unit_test(work_of_rolling_is_stored_or_dissipated),
        cmocka_unit_test(contact_holds_twist_beyond_it),
        cmocka_unit_test(sliding_and_rolling_share_one_cone),
        cmocka_unit_test(laid_thread_rolls_without_slipping),
        cmocka_unit_test(laid_thread_sticks_if_it_cannot_roll),
        cmocka_unit_test(restored_scene_continues_with_same_bits),
    };
    return cmocka_run_group_tests_name("scene.friction_torque", tests, NULL, NULL);
}
