/* Pairs of a drain that are proved to be too far from each other for a row, against all of them asked. */
#include <stdlib.h>

#include "scene/drains_rig.h"

enum { CASES = 60 };

typedef struct counts {
    uint64_t near, far, given;
} counts;

/* Somewhere between round and pressed flat, with dents, on its way to somewhere. */
static void draw_state(drain_object *d, harness_source *source)
{
    double flat = harness_draw_real(source, 0.05, 1.0), dent = harness_draw_real(source, 0.0, 5e-4);
    double speed = harness_draw_below(source, 2) * harness_draw_real(source, 0.0, 0.3);
    vec3 middle = vec3_zero();
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        middle = vec3_add_scaled(middle, 1.0 / d->mesh.node_count, d->mesh.rest[i]);
    }
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        vec3 x = d->mesh.rest[i];
        x.y = middle.y + flat * (x.y - middle.y);
        x = vec3_add(x, harness_draw_vec3(source, -dent, dent));
        d->x[i] = pose_apply(d->frame, x);
        d->v[i] = harness_draw_vec3(source, -speed, speed);
    }
}

/* More lips than the slit has, so that some of them lie face to face. */
static void draw_lips(scene_drain *b, const collision_shape *shape, harness_source *source)
{
    for (uint32_t e = 0; e < shape->edge_count; e++) {
        uint32_t face = 0;
        for (uint32_t t = 0; t < shape->triangle_count; t++) {
            uint32_t common = 0;
            for (int k = 0; k < 3; k++) {
                uint32_t node = shape->triangles[t][k];
                common += node == shape->edges[e][0] || node == shape->edges[e][1];
            }
            face = common == 2 ? t : face;
        }
        if (harness_draw_below(source, 8) == 0) {
            b->lip_of_side[e] = face;
            b->lip_of_node[shape->edges[e][0]] = b->lip_of_node[shape->edges[e][1]] = face;
        }
    }
}

/* As if nobody had looked at how far they are. */
static bool ask(scene_object *s, const collision_candidate *q, const scene_body *b)
{
    uint32_t kind = q->kind == VBSS_PAIR_EDGE_EDGE ? VBSS_CONTACT_SIDES : VBSS_CONTACT_POINT_FACE;
    const contact_key key = {kind, b->number, q->a, b->number, q->b};
    uint32_t nodes_a[3], nodes_b[3];
    vec3 ways_a[3], ways_b[3];
    scene_meeting m = {.a = b, .b = b, .ways_a = ways_a, .ways_b = ways_b};
    m.count_a = vbss_scene_nodes_of(s, b, kind, false, q->a, nodes_a);
    m.count_b = vbss_scene_nodes_of(s, b, kind, true, q->b, nodes_b);
    for (uint32_t k = 0; k < m.count_a; k++) {
        ways_a[k] = b->drain.ways[nodes_a[k]];
    }
    for (uint32_t k = 0; k < m.count_b; k++) {
        ways_b[k] = b->drain.ways[nodes_b[k]];
    }
    return vbss_scene_add_row(s, &key, &m);
}

static void compare(scene_object *s, const collision_candidate *q, const scene_body *b, counts *c)
{
    contact_set *set = s->contacts;
    uint32_t before = set->count;
    s->unlisted = false;
    assert_true(vbss_scene_add_surface_row(s, q));
    bool row = set->count > before, unlisted = s->unlisted;
    set->count = before;
    s->unlisted = false;
    assert_true(ask(s, q, b));
    assert_int_equal(row, set->count > before);
    assert_int_equal(unlisted, s->unlisted);
    set->count = before;
    c->near += row;
    c->far += !row;
    c->given += unlisted;
}

static void all_pairs(harness_source *source, void *user)
{
    counts *c = user;
    small s;
    drain_hands hands;
    scene_object *o = NULL;
    expect_ok(drain_hands_init(&hands));
    hands.config.contact_capacity = 20000;
    hands.config.candidate_capacity = 200000;
    drain_object *d = drains_rig_object(drains_rig_begin(&s, &hands));
    expect_ok(vbss_scene_open(s.scene, &o));
    scene_body *b = &o->bodies[0];
    const scene_part part = {.step = 1e-3, .h = 1e-3, .end = 1.0};
    draw_state(d, source);
    if (harness_draw_below(source, 2) == 0) {
        draw_lips(&b->drain, o->collision->shapes[b->shape], source);
    }
    assert_true(vbss_scene_find_rows(o, &part));
    vbss_contact_begin(o->contacts);
    for (uint32_t i = 0; i < o->collision->candidate_count; i++) {
        const collision_candidate *q = &o->collision->candidates[i];
        if (q->shape_a == b->shape && q->shape_b == b->shape) {
            compare(o, q, b, c);
        }
    }
    small_end(&s);
}

static void pairs_that_planes_part_have_no_row(void **state)
{
    (void)state;
    counts c = {0};
    harness_property("far pairs of a drain", CASES, all_pairs, &c);
    assert_true(getenv("VBSS_PROPERTY_CASE") != NULL ||
                (c.near > 4000 && c.far > 10000 && c.given > 50));
}

int test_drains_far(void)
{
    const struct CMUnitTest tests[] = {harness_test(pairs_that_planes_part_have_no_row)};
    return cmocka_run_group_tests_name("scene.drains_far", tests, NULL, NULL);
}
