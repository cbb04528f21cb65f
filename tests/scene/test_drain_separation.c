/* Rows of a drain of which pairs are known to be apart, against those of which nothing is known. */
#include <stdlib.h>
#include <string.h>

#include "scene/api/api.h"
#include "scene/contacts/contacts.h"
#include "scene/drains_rig.h"

enum { CASES = 30, MOVES = 3 };

typedef struct counts {
    uint64_t near, known;
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

/* From there, some of it goes on a little; a search then knows what is still apart. */
static void go_on(drain_object *d, harness_source *source)
{
    double largest = harness_draw_real(source, 0.0, 1e-3);
    uint32_t first = harness_draw_below(source, d->mesh.node_count);
    for (uint32_t i = first; i < d->mesh.node_count; i++) {
        d->x[i] = vec3_add(d->x[i], harness_draw_vec3(source, -largest, largest));
    }
}

/* Candidates that have no row because they are known to stay apart. */
static uint32_t count_known(const scene_object *s)
{
    const collision_object *c = s->collision;
    uint32_t known = 0;
    for (uint32_t i = 0; i < c->candidate_count; i++) {
        known += scene_is_known_apart(s, &c->candidates[i], s->solver.contact_margin);
    }
    return known;
}

typedef struct row_copy {
    contact_constraint row;
    scene_contact_geometry geometry;
} row_copy;

static row_copy *copy_rows(const scene_object *s)
{
    row_copy *copy = malloc((s->contacts->count + 1) * sizeof *copy);
    assert_non_null(copy);
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        const contact_constraint *row = &s->contacts->constraints[i];
        copy[i] = (row_copy){*row, *scene_geometry_of(s, row)};
    }
    return copy;
}

static void expect_same_rows(const scene_object *s, const row_copy *rows, uint32_t count)
{
    assert_int_equal(count, s->contacts->count);
    for (uint32_t i = 0; i < count; i++) {
        const contact_constraint *row = &s->contacts->constraints[i], *before = &rows[i].row;
        const scene_contact_geometry *g = scene_geometry_of(s, row), *old = &rows[i].geometry;
        assert_memory_equal(&before->key, &row->key, sizeof row->key);
        assert_memory_equal(old->barycentric, g->barycentric, sizeof g->barycentric);
        assert_true(old->start_gap == g->start_gap && old->lip_thickness == g->lip_thickness);
        assert_memory_equal(&before->normal, &row->normal, sizeof row->normal);
    }
}

static void with_and_without_what_is_known(harness_source *source, void *user)
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
    const scene_substep part = {.step_length = 1e-3, .h = 1e-3, .end_fraction = 1.0};
    draw_state(d, source);
    if (harness_draw_below(source, 2) == 0) {
        draw_lips(&b->drain, o->collision->shapes[b->shape], source);
    }
    assert_true(vbss_scene_create_contacts(o, &part));
    for (int move = 0; move < MOVES; move++) {
        go_on(d, source);
        assert_true(vbss_scene_create_contacts(o, &part));
        uint32_t count = o->contacts->count;
        row_copy *rows = copy_rows(o);
        c->known += count_known(o);
        c->near += count;
        o->collision->near_valid = false; /* nothing is known any more */
        o->collision->near_count = 0;
        assert_true(vbss_scene_create_contacts(o, &part));
        expect_same_rows(o, rows, count);
        free(rows);
    }
    small_end(&s);
}

static void separated_pairs_have_no_contact(void **state)
{
    (void)state;
    counts c = {0};
    harness_property("far pairs of a drain", CASES, with_and_without_what_is_known, &c);
    assert_true(getenv("VBSS_PROPERTY_CASE") != NULL || (c.near > 4000 && c.known > 10000));
}

int test_drain_separation(void)
{
    const struct CMUnitTest tests[] = {harness_test(separated_pairs_have_no_contact)};
    return cmocka_run_group_tests_name("scene.drain_separation", tests, NULL, NULL);
}
