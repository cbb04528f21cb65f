/* The guard beside holes: what slides through its hole goes on, what begins near it and goes through the wall elsewhere does
 * not, however fast both are. */
#include "scene/ccd/ccd.h"
#include "scene/contacts/contacts.h"
#include "scene/solve/solve.h"
#include "scene/world/world.h"
#include "scene/stitch_case.h"

#include "drain/drain.h"

static stitch_case c;

/* From its hole along the thread, m: more than within which nothing touches, less than it is thrown. */
#define AWAY 2.5e-3
/* Beyond the wall, m. */
#define BEYOND 0.5e-3

typedef struct stage {
    scene_object *s;
    thread_object *thread;
    drain_object *drain;
    const suture_hole *hole;
} stage;

/* A part in which nothing moves as yet. */
static stage open_part(void)
{
    stitch_case_begin(&c);
    stitch_case_make(&c);
    stage g = {.s = small_object(&c.s)};
    g.hole = &g.s->holes[0];
    g.thread = vbss_scene_body(g.s, g.hole->thread)->thread.thread;
    g.drain = vbss_scene_body(g.s, g.hole->wall)->drain.drain;
    const scene_substep part = {.step_length = 1e-3, .h = 1e-3, .end_fraction = 1.0};
    assert_true(vbss_scene_create_contacts(g.s, &part));
    vbss_scene_predict(g.s, &part);
    memcpy(g.thread->trial, g.thread->now.x, g.thread->node_count * sizeof(vec3));
    memcpy(g.drain->trial, g.drain->x, g.drain->mesh.node_count * sizeof(vec3));
    assert_int_equal(vbss_scene_run_ccd(g.s), SCENE_SUBSTEP_ACCEPTED);
    return g;
}

static uint32_t node_at(const thread_object *t, double arc)
{
    uint32_t k = 0;
    while (k + 2 < t->node_count && vbss_thread_arc_length(t, k) < arc) {
        k++;
    }
    return k;
}

/* The middle of the wall that is nearest to it and no nearer to the hole than it is. */
static vec3 wall_beside(const stage *g, vec3 node)
{
    const vec3 hole =
        vbss_drain_point(g->drain, g->drain->x, g->hole->triangle, g->hole->barycentric);
    vec3 best = vec3_zero();
    double smallest = HUGE_VAL;
    for (uint32_t i = 0; i < g->drain->mesh.triangle_count; i++) {
        const double middle[3] = {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0};
        vec3 there = vbss_drain_point(g->drain, g->drain->x, i, middle);
        double far = vec3_distance(there, node);
        if (vec3_distance(there, hole) > AWAY && far < smallest) {
            smallest = far;
            best = there;
        }
    }
    return best;
}

static void thread_near_hole_is_not_pushed_through_wall(void **state)
{
    (void)state;
    for (int side = -1; side <= 1; side += 2) {
        stage g = open_part();
        uint32_t k = node_at(g.thread, g.hole->arc + side * AWAY);
        vec3 from = g.thread->now.x[k], wall = wall_beside(&g, from);
        vec3 offset = vec3_sub(wall, from);
        g.thread->trial[k] = vec3_add_scaled(wall, BEYOND / vec3_norm(offset), offset);
        assert_int_equal(vbss_scene_run_ccd(g.s), SCENE_SUBSTEP_CCD_HIT);
        assert_true(g.s->step.time_of_impact > 0.0 && g.s->step.time_of_impact < 1.0);
        stitch_case_end(&c);
    }
}

/* By a whole segment, either way. */
static void thread_slides_through_its_holes(void **state)
{
    (void)state;
    for (int sign = -1; sign <= 1; sign += 2) {
        stage g = open_part();
        const uint32_t last = g.thread->node_count - 1;
        const vec3 *x = g.thread->now.x;
        for (uint32_t k = 0; k < last; k++) {
            g.thread->trial[sign > 0 ? k : k + 1] = x[sign > 0 ? k + 1 : k];
        }
        const uint32_t end = sign > 0 ? last : 0, before = sign > 0 ? last - 1 : 1;
        g.thread->trial[end] = vec3_sub(vec3_scale(x[end], 2.0), x[before]);
        assert_int_equal(vbss_scene_run_ccd(g.s), SCENE_SUBSTEP_ACCEPTED);
        stitch_case_end(&c);
    }
}

int test_ccd_holes(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(thread_near_hole_is_not_pushed_through_wall),
        cmocka_unit_test(thread_slides_through_its_holes),
    };
    return cmocka_run_group_tests_name("scene.ccd_holes", tests, NULL, NULL);
}
