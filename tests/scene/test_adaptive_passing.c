/* Threads whose meshes change while strands touch: decided exactly, nothing passes in the steps, nor in what the
 * changes do between them. */
#include <math.h>

#include "collision/closest.h"
#include "fixtures/solver_of.h"
#include "oracle/passing.h"
#include "oracle/knot_type.h"
#include "scene/mesh_rig.h"
#include "scene/topology/topology.h"
#include "scene/world/world.h"
#include "thread/remesh.h"
#include "scene/watch.h"
#include "fixtures/contact_scenes.h"

#define LENGTH 0.2

static mesh_line before, after;
static vec3 from[2 * MESH_NODES], to[2 * MESH_NODES];
static watch w;

/* What the last change of the mesh, if there was one, moved; returns how many pairs met. `last` is where the last part
 * of the step ended, on the mesh that it had. */
static uint64_t met_in_change(const mesh_line *last, const thread_object *t)
{
    mesh_keep(&after, t);
    uint32_t count = mesh_join(last, &after, from, to);
    passing_chain chain = {from, to, count, false};
    return passing_count(&chain, 1, NULL);
}

/* Least distance of segments that are further along the thread than it may touch itself. */
static double min_distance(const mesh_line *l, double apart)
{
    double smallest = 1.0;
    for (uint32_t a = 0; a + 1 < l->count; a++) {
        for (uint32_t b = a + 2; b + 1 < l->count; b++) {
            const vec3 *x = l->x + a, *y = l->x + b;
            double at[2];
            if (l->arc[b] - l->arc[a + 1] >= apart &&
                fabs(x[0].x - y[0].x) + fabs(x[0].y - y[0].y) + fabs(x[0].z - y[0].z) < 6e-3) {
                vec3 separation = closest_between_edges(vec3_sub(x[1], x[0]), vec3_sub(y[1], y[0]),
                                                        vec3_sub(y[0], x[0]), &at[0], &at[1]);
                smallest = fmin(smallest, vec3_norm(separation));
            }
        }
    }
    return smallest;
}

/* What did not touch does not, and what did comes no nearer. */
static void expect_kept_apart(const thread_object *t)
{
    double touching = 2.0 * t->config.radius, apart = 4.0 * t->config.radius;
    double now = min_distance(&after, apart), then = min_distance(&before, apart);
    assert_true(now >= fmin(then, touching) - 1e-9);
}

/* ---- at random: any segment, any node, whatever is near */

static uint32_t change_at_random(scene_object *s, scene_body *b, vbss_random *random)
{
    thread_object *t = b->thread.thread;
    uint32_t made = 0;
    for (int k = 0; k < 3; k++) {
        uint32_t at = 4 + vbss_random_below(random, t->node_count - 8);
        bool divide = vbss_random_below(random, 2) == 0 && t->node_count < 600;
        double gap = 1.0; /* to what is not beside it along the thread */
        for (uint32_t i = at > 6 ? at - 6 : 0; i < at + 6 && i + 1 < t->node_count; i++) {
            for (uint32_t j = 0; j + 1 < t->node_count; j++) {
                double arc = fabs(vbss_thread_arc_length(t, j) - vbss_thread_arc_length(t, i));
                if (arc > 2.0 * (t->rest[i] + t->rest[j])) {
                    double at2[2];
                    const vec3 *x = t->now.x;
                    vec3 separation =
                        closest_between_edges(vec3_sub(x[i + 1], x[i]), vec3_sub(x[j + 1], x[j]),
                                              vec3_sub(x[j], x[i]), &at2[0], &at2[1]);
                    gap = fmin(gap, vec3_norm(separation) - 2.0 * t->config.radius);
                }
            }
        }
        const mesh_change change = {at, !divide, fmax(0.25 * gap, 0.0)};
        if (divide && t->rest[at] < 0.3e-3) {
            continue;
        }
        if (!divide && !vbss_thread_can_coarsen(t, at)) {
            continue;
        }
        made += vbss_scene_apply_mesh_change(s, b, &change);
    }
    vbss_collision_resize_chain(s->collision, b->shape, t->node_count, t->rest);
    vbss_scene_sort_warm_start(s);
    vbss_scene_number_nodes(s);
    s->step.pattern_hash = 0;
    return made;
}

typedef struct pulled {
    knot_kind kind;
    bool at_random;
    vbss_thread_bending bending;
} pulled;

static void pull(const pulled *p)
{
    vbss_context *context;
    contact_scene_options o;
    contact_scene scene;
    vbss_random random;
    expect_ok(vbss_context_create(NULL, &context));
    expect_ok(contact_scene_init(&o, CONTACT_SCENE_PULLED));
    o.knot.kind = p->kind;
    o.knot.size = 2e-3;
    o.knot.length = LENGTH;
    o.knot.finest = o.knot.coarsest = 0.6e-3;
    o.pull = (contact_pull){0.1, 1.0, 0.0};
    o.thread.bending = p->bending;
    o.thread.mesh = VBSS_THREAD_MESH_ADAPTIVE;
    o.thread.mesh_operations = p->at_random ? 0 : 8;
    o.thread.node_capacity = 900;
    set_call_operations(&o.scene, 0); /* no mesh changes between two steps of a call */
    expect_ok(contact_scene_create(context, &o, &scene));
    vbss_random_seed(&random, 3, (uint64_t)p->kind);
    scene_object *s = mesh_scene(scene.scene);
    thread_object *t = mesh_thread(scene.threads[0]);
    scene_body *b = vbss_scene_body(s, scene.thread_bodies[0]);
    watch_begin(&w, scene.scene);
    uint64_t met = 0, changes = 0, passed = 0;
    for (int i = 0; i < 500; i++) {
        uint32_t nodes = t->node_count;
        double arcs[MESH_NODES];
        for (uint32_t k = 0; k < nodes; k++) {
            arcs[k] = vbss_thread_arc_length(t, k);
        }
        uint64_t made = t->statistics.refined + t->statistics.coarsened,
                 parts = s->report.statistics.parts;
        before.count = nodes;
        memcpy(before.x, t->now.x, nodes * sizeof(vec3));
        expect_ok(contact_scene_step(&scene, 1e-3));
        if (s->report.statistics.parts > parts) { /* the watch has seen where the last one ended */
            memcpy(before.x, w.last, nodes * sizeof(vec3));
        }
        memcpy(before.arc, arcs, nodes * sizeof *arcs);
        if (p->at_random) {
            (void)change_at_random(s, b, &random);
        }
        made = t->statistics.refined + t->statistics.coarsened - made;
        changes += made;
        if (made > 0) {
            met += met_in_change(&before, t);
            expect_kept_apart(t);
            watch_again(&w);
        }
        expect_ok(vbss_thread_prepare_query(t));
        cut_expect_sound(s);
        passed += w.passed;
    }
    assert_true(changes > 100);
    assert_int_equal(met, 0);
    assert_int_equal(passed, 0);
    assert_int_equal(w.below + w.jumps, 0);
    knot_type found, right = knot_type_of_kind(p->kind, false);
    assert_true(knot_type_of(t->now.x, t->node_count, &found) && knot_type_same(found, right));
    expect_near(LENGTH, vbss_thread_arc_length(t, t->node_count - 1), 1e-3);
    vbss_context_destroy(context);
}

static void adaptive_knot_has_no_passage(void **state)
{
    (void)state;
    static const pulled cases[] = {{KNOT_OVERHAND, false, VBSS_THREAD_BENDING_SPLINE},
                                   {KNOT_DOUBLE_OVERHAND, false, VBSS_THREAD_BENDING_LOCAL},
                                   {KNOT_SQUARE, false, VBSS_THREAD_BENDING_SPLINE}};
    for (int k = 0; k < 3; k++) {
        pull(&cases[k]);
    }
}

static void random_mesh_changes_have_no_passage(void **state)
{
    (void)state;
    static const pulled cases[] = {{KNOT_OVERHAND, true, VBSS_THREAD_BENDING_SPLINE},
                                   {KNOT_SURGEON, true, VBSS_THREAD_BENDING_LOCAL}};
    for (int k = 0; k < 2; k++) {
        pull(&cases[k]);
    }
}

int test_adaptive_passing(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(adaptive_knot_has_no_passage),
        cmocka_unit_test(random_mesh_changes_have_no_passage),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
