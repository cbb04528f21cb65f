/* What names nodes and segments goes on to mean the same places when a mesh changes: contacts, pins, welds, grasps,
 * the ends at a cut. */
#include <math.h>
#include <stdlib.h>

#include "fixtures/solver_of.h"
#include "scene/cut_contacts.h"
#include "scene/mesh_rig.h"
#include "scene/topology/topology.h"
#include "scene/world/world.h"
#include "thread/remesh.h"
#include "scene/tools_rig.h"

/* ---- contacts */

/* A tight knot of a mesh that does what it is told only. */
static void tight(vbss_context *context, contact_scene *scene)
{
    contact_scene_options o;
    expect_ok(contact_scene_init(&o, CONTACT_SCENE_PULLED));
    o.knot.kind = KNOT_DOUBLE_OVERHAND;
    o.knot.length = 0.08;
    o.thread.mesh = VBSS_THREAD_MESH_ADAPTIVE;
    o.thread.mesh_operations = 0;
    o.thread.node_capacity = 700;
    set_call_operations(&o.scene, 0); /* tight after 250 calls */
    expect_ok(contact_scene_create(context, &o, scene));
    for (int i = 0; i < 250; i++) {
        expect_ok(contact_scene_step(scene, 1e-3));
    }
}

static void finish(scene_object *s, const scene_body *b)
{
    const thread_object *t = b->thread.thread;
    vbss_collision_resize_chain(s->collision, b->shape, t->node_count, t->rest);
    vbss_scene_sort_warm_start(s);
    vbss_scene_number_nodes(s);
    s->step.pattern_hash = 0;
}

static void split_segment_contacts_move_to_halves(void **state)
{
    (void)state;
    static remembered_list before, now;
    vbss_context *context;
    contact_scene scene;
    expect_ok(vbss_context_create(NULL, &context));
    tight(context, &scene);
    scene_object *s = mesh_scene(scene.scene);
    scene_body *b = vbss_scene_body(s, scene.thread_bodies[0]);
    thread_object *t = b->thread.thread;
    uint32_t seen = s->report.contact_count;
    assert_true(s->contacts->warm_start_count > 10 && seen > 10);
    static uint32_t features[1024][5];
    memcpy(features, s->report.contact_features, seen * sizeof *features);
    cut_remember(s, &before);
    for (uint32_t k = t->node_count - 5; k > 4; k--) {
        const mesh_change change = {k, false, 0.0};
        assert_true(vbss_scene_apply_mesh_change(s, b, &change));
    }
    finish(s, b);
    cut_remember(s, &now);
    (void)cut_expect_same(&before, &now);
    cut_expect_sound(s);
    /* And the views: each names the half that it is nearest to. */
    for (uint32_t i = 0; i < seen; i++) {
        const uint32_t *f = s->report.contact_features[i];
        for (int side = 2; side <= 4; side += 2) {
            uint32_t whole = features[i][side], half = f[side];
            assert_true(half == 2 * (whole - 5) + 5 || half == 2 * (whole - 5) + 6);
            const vec3 *x = t->now.x + half;
            vec3 e = vec3_sub(x[1], x[0]);
            double at =
                vec3_dot(vec3_sub(s->report.contact_points[i], x[0]), e) / vec3_norm_squared(e);
            assert_true(at > -1.0 && at < 2.0);
        }
    }
    /* It goes on as it did: friction remembers. */
    for (int i = 0; i < 30; i++) {
        expect_ok(contact_scene_step(&scene, 1e-3));
    }
    assert_true(contact_scene_pull_felt(&scene) > 0.5);
    assert_int_equal(small_statistics(&(small){.scene = scene.scene}).clamped, 0);
    vbss_context_destroy(context);
}

static void removed_node_takes_no_foreign_contact(void **state)
{
    (void)state;
    static remembered_list before, now;
    vbss_context *context;
    contact_scene scene;
    expect_ok(vbss_context_create(NULL, &context));
    tight(context, &scene);
    scene_object *s = mesh_scene(scene.scene);
    scene_body *b = vbss_scene_body(s, scene.thread_bodies[0]);
    thread_object *t = b->thread.thread;
    cut_remember(s, &before);
    uint32_t nodes = t->node_count, gone = 0;
    for (uint32_t k = 8; k < 14; k += 2) { /* far from the knot, before all that touches */
        const mesh_change change = {k, true, 1e-3};
        gone += vbss_scene_apply_mesh_change(s, b, &change);
    }
    assert_int_equal(gone, 3);
    assert_int_equal(t->node_count, nodes - 3);
    finish(s, b);
    cut_remember(s, &now);
    (void)cut_expect_same(&before, &now);
    cut_expect_sound(s);
    vbss_context_destroy(context);
}

static void coarse_tool_contact_becomes_node_contact(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    small_begin(&s);
    small_create(&s);
    s.thread.mesh = VBSS_THREAD_MESH_ADAPTIVE;
    s.thread.mesh_operations = 0;
    s.thread.node_capacity = 40;
    s.thread.gravity[1] = -9.81;
    uint32_t body = small_thread(&s, vec3_make(-9e-3, 1.625e-3, 0.0),
                                 vec3_make(9e-3, 1.625e-3, 0.0), 9, &thread);
    (void)small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), vec3_make(0.0, 0.0, 0.01), 1.5e-3);
    small_steps(&s, 5, 1e-3);
    scene_object *o = small_object(&s);
    assert_int_equal(o->contacts->warm_start_count, 1);
    const contact_warm_start_entry was = o->contacts->warm_start[0];
    assert_int_equal(was.key.kind, VBSS_SCENE_CONTACT_SEGMENT_CAPSULE);
    assert_int_equal(was.key.feature_a, 4);
    scene_body *b = vbss_scene_body(o, body);
    const mesh_change change = {4, false, 0.0};
    assert_true(vbss_scene_apply_mesh_change(o, b, &change));
    finish(o, b);
    assert_int_equal(o->contacts->warm_start[0].key.kind, VBSS_SCENE_CONTACT_NODE_CAPSULE);
    assert_int_equal(o->contacts->warm_start[0].key.feature_a, 5);
    expect_same_bits(was.normal_force, o->contacts->warm_start[0].normal_force);
    small_steps(&s, 2, 1e-3);
    assert_int_equal(o->contacts->warm_start[0].key.kind, VBSS_SCENE_CONTACT_NODE_CAPSULE);
    small_end(&s);
}

/* ---- pins and welds */

static void pins_and_welds_keep_their_places(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    small_begin(&s);
    s.config.node_capacity = 500;
    small_create(&s);
    s.thread.mesh = VBSS_THREAD_MESH_ADAPTIVE;
    s.thread.node_capacity = 300;
    s.thread.refine_angle = 0.02;
    s.thread.coarsen_angle = 0.0;
    s.thread.gravity[1] = -9.81;
    uint32_t body = small_thread(&s, vec3_zero(), vec3_make(0.08, 0.0, 0.0), 40, &thread);
    uint32_t ball = small_stick(&s, VBSS_SCENE_RIGID_FREE, vec3_make(0.04, -3e-3, 0.0),
                                vec3_make(1e-3, 0.0, 0.0), 1e-3);
    uint32_t hand = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.08, 5e-3, 0.0),
                                vec3_make(0.0, 1e-3, 0.0), 1e-3);
    (void)small_pin(&s, body, 0, 0);
    (void)small_pin(&s, body, 40, hand);
    (void)small_pin(&s, body, 20, ball);
    for (int i = 0; i < 400; i++) { /* the far end comes nearer, and the thread bends */
        small_move(&s, hand, vec3_make(0.08 - 1e-4 * i, 5e-3, 0.0));
        small_steps(&s, 1, 1e-3);
        cut_expect_sound(small_object(&s));
    }
    const scene_object *o = small_object(&s);
    const thread_object *t = mesh_thread(thread);
    static const double arcs[3] = {0.0, 0.08, 0.04};
    assert_true(t->statistics.refined > 20 && t->statistics.refused_held > 0);
    for (int i = 0; i < 3; i++) {
        expect_near(arcs[i], vbss_thread_arc_length(t, o->pins[i].node), 1e-15);
    }
    vec3 ends[2] = {t->now.x[0], t->now.x[t->node_count - 1]};
    expect_near(0.0, vec3_norm(ends[0]), 1e-15);
    expect_near(0.08 - 0.0399, ends[1].x, 1e-12);
    small_end(&s);
}

/* A straight fine thread: all of it may be coarse but what is held. */
static void no_coarsening_beside_held_nodes(void **state)
{
    (void)state;
    tools_rig r;
    tools_begin(&r);
    r.s.config.node_capacity = 300;
    r.s.thread.mesh = VBSS_THREAD_MESH_ADAPTIVE;
    r.s.thread.clear_distance = r.s.thread.near_distance = 0.0;
    small_create(&r.s);
    tools_thread(&r, TOOLS_BOTH, 0.0);
    const thread_object *t = mesh_thread(r.thread);
    uint32_t ball = small_stick(&r.s, VBSS_SCENE_RIGID_FREE, vec3_make(0.0, 8e-3, -4e-3),
                                vec3_make(1e-4, 0.0, 0.0), 1e-3);
    (void)small_pin(&r.s, r.body, 45, ball);
    tools_steps(&r, 100);
    assert_true(t->statistics.coarsened > 10 && t->statistics.refused_held > 0);
    const scene_object *o = small_object(&r.s);
    uint32_t held[3] = {0, t->node_count - 1, 0};
    for (uint32_t i = 0; i < o->config.pin_capacity; i++) {
        held[2] = o->pins[i].body == ball ? o->pins[i].node : held[2];
    }
    for (int k = 0; k < 3; k++) {
        for (uint32_t i = held[k] > 1 ? held[k] - 1 : 0; i <= held[k] && i + 1 < t->node_count;
             i++) {
            expect_near(0.5e-3, t->rest[i], 1e-15);
        }
    }
    tools_end(&r);
}

/* The host detaches what a pin has attached; the pin's node goes, and the state is one that can be restored. */
static void pin_without_attachment_outlives_its_node(void **state)
{
    (void)state;
    tools_rig r;
    tools_begin(&r);
    r.s.config.node_capacity = 300;
    r.s.thread.mesh = VBSS_THREAD_MESH_ADAPTIVE;
    r.s.thread.clear_distance = r.s.thread.near_distance = 0.0;
    small_create(&r.s);
    tools_thread(&r, TOOLS_BOTH, 0.0);
    const thread_object *t = mesh_thread(r.thread);
    const scene_object *o = small_object(&r.s);
    const uint32_t pin = small_pin(&r.s, r.body, 45, 0);
    const scene_pin *p = o->pins;
    while (p->id != pin) {
        p++;
    }
    expect_ok(vbss_thread_detach(r.thread, p->attachment));
    tools_steps(&r, 100);
    assert_true(t->statistics.coarsened > 30 && p->node < t->node_count);
    const small_state saved = small_save(&r.s);
    expect_ok(vbss_scene_restore(r.s.scene, saved.bytes, saved.count));
    free(saved.bytes);
    expect_ok(vbss_scene_unpin_thread(r.s.scene, pin));
    tools_end(&r);
}

/* ---- grasps */

static void grasped_thread_stays_at_its_arc(void **state)
{
    (void)state;
    tools_rig r;
    tools_begin(&r);
    r.s.config.node_capacity = 300;
    r.s.thread.mesh = VBSS_THREAD_MESH_ADAPTIVE;
    r.s.thread.node_capacity = 200;
    r.s.thread.coarsest_length = 4e-3;
    small_create(&r.s);
    tools_thread(&r, TOOLS_BOTH, 0.0);
    tools_add(&r, vec3_make(0.0, 0.0, -2e-3));
    tools_close(&r, 0);
    vbss_scene_grasp before = tools_grasp(&r, 0, 0);
    scene_object *o = small_object(&r.s);
    const thread_object *t = mesh_thread(r.thread);
    uint64_t made = t->statistics.refined + t->statistics.coarsened;
    tools_move_along(&r, 0, vec3_make(0.0, 0.0, -2e-3), vec3_make(2e-3, 0.0, -1e-3), 200);
    tools_move_along(&r, 0, vec3_make(2e-3, 0.0, -1e-3), vec3_make(0.0, 0.0, -2e-3), 200);
    cut_expect_sound(o);
    assert_true(made > 20);
    vbss_scene_grasp after = tools_grasp(&r, 0, 0);
    expect_near(before.arc_length, after.arc_length, after.slid + 1e-15);
    assert_true(after.slid < 1e-4);
    /* Changes before and behind it rename it: the place is the same to rounding. */
    scene_body *b = vbss_scene_body(o, r.body);
    for (uint32_t k = 0; k < 2; k++) {
        uint32_t at = k == 0 ? t->node_count - 4 : 2;
        vec3 position = vec3_load(tools_grasp(&r, 0, 0).position);
        double arc = tools_grasp(&r, 0, 0).arc_length;
        const mesh_change change = {at, false, 0.0};
        assert_true(vbss_scene_apply_mesh_change(o, b, &change));
        finish(o, b);
        expect_near(arc, tools_grasp(&r, 0, 0).arc_length, 1e-15);
        vec3 moved = vec3_load(tools_grasp(&r, 0, 0).position);
        expect_near(0.0, vec3_distance(position, moved), 1e-15);
    }
    /* Even of the segment that is held, which scenes leave alone. */
    uint32_t held = o->thread_grasps[0].segment;
    vec3 position = vec3_load(tools_grasp(&r, 0, 0).position);
    const mesh_change inside = {held, false, 0.0}, joined = {held + 1, true, 1.0};
    assert_true(vbss_scene_apply_mesh_change(o, b, &inside));
    finish(o, b);
    expect_near(0.0, vec3_distance(position, vec3_load(tools_grasp(&r, 0, 0).position)), 1e-12);
    assert_true(vbss_scene_apply_mesh_change(o, b, &joined));
    finish(o, b);
    assert_int_equal(o->thread_grasps[0].segment, held);
    tools_end(&r);
}

/* ---- cuts */

static void both_cut_ends_adapt_after_separating(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread, *piece;
    small_begin(&s);
    s.config.node_capacity = 400;
    small_create(&s);
    s.thread.mesh = VBSS_THREAD_MESH_ADAPTIVE;
    s.thread.node_capacity = 300;
    s.thread.cut_capacity = 2;
    uint32_t body = small_thread(&s, vec3_zero(), vec3_make(0.06, 0.0, 0.0), 200, &thread);
    (void)small_pin(&s, body, 0, 0);
    (void)small_pin(&s, body, 200, 0);
    small_steps(&s, 3, 1e-3);
    uint32_t number = cut_at(&s, body, 0.0301, &piece);
    const scene_object *o = small_object(&s);
    for (int i = 0; i < 120; i++) {
        small_steps(&s, 1, 1e-3);
        cut_expect_sound(o);
        const scene_body *b = vbss_scene_body(o, number);
        if (b->thread.cut_from != 0) { /* side by side: nothing is known of them but their names */
            expect_near(0.3e-3, b->thread.thread->rest[1], 1e-15);
        }
    }
    const thread_object *t = mesh_thread(thread), *u = mesh_thread(piece);
    assert_true(t->statistics.coarsened > 20 && u->statistics.coarsened > 20);
    expect_near(0.06, cut_length(t) + cut_length(u), 1e-15);
    (void)cut_at(&s, number, 0.01, &piece);
    small_steps(&s, 60, 1e-3);
    cut_expect_sound(o);
    small_end(&s);
}

int test_adaptive_holders(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(split_segment_contacts_move_to_halves),
        cmocka_unit_test(removed_node_takes_no_foreign_contact),
        cmocka_unit_test(coarse_tool_contact_becomes_node_contact),
        cmocka_unit_test(pins_and_welds_keep_their_places),
        cmocka_unit_test(no_coarsening_beside_held_nodes),
        cmocka_unit_test(pin_without_attachment_outlives_its_node),
        cmocka_unit_test(grasped_thread_stays_at_its_arc),
        cmocka_unit_test(both_cut_ends_adapt_after_separating),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
