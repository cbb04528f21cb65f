/* Threads with friction torque: contacts that hold twist up to their friction, and threads that roll. */
#include <stdlib.h>

#include "scene/small.h"
#include "thread/twist.h"

enum { SEGMENTS = 31, MIDDLE = 15 };
static const double torsion = 0.7e-8, length = 0.031; /* N m^2, m */
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

static double torque(const squeezed *w, int end)
{
    vbss_thread_reaction reaction;
    expect_ok(vbss_thread_get_reaction(w->thread, w->clamps[end], &reaction, sizeof reaction));
    return reaction.torque[0];
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

double twist_energy(const squeezed *w);
double twist_energy(const squeezed *w)
{
    vbss_thread_energies e;
    expect_ok(vbss_thread_get_energies(w->thread, &e, sizeof e));
    return e.twisting;
}

/* Rolled at one end, the thread bears no torque beyond the rods until the friction of both is used up, and then
 * that much less than before them. Rolled back, it keeps what they hold. */
static void far_torque_is_near_torque_less_friction(void **state)
{
    (void)state;
    squeezed w;
    squeezed_begin(&w, 1);
    const double bound = 2.0 * friction * press(&w) * w.s.thread.radius, half = 0.5 * length;
    assert_true(press(&w) > 5e-3);
    const double sticks = bound * half / torsion; /* rad, until both rods slip */
    for (int k = 1; k <= 200; k++) {
        const double angle = 2.5 * sticks * k / 200.0;
        roll_to(&w, angle);
        const double near = -torque(&w, 0), far = torque(&w, 1);
        printf("%g near %g far %g bound %g\n", angle/sticks, near, far, bound);
    }
    small_end(&w.s);
}

int test_friction_torque(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(far_torque_is_near_torque_less_friction),
    };
    return cmocka_run_group_tests_name("scene.friction_torque", tests, NULL, NULL);
}
