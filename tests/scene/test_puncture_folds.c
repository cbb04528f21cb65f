/* A needle that goes through both sides of a fold beside the hole that it enters: here two triangles that meet at an angle. */
#include "scene/tissue/tissue.h"
#include "scene/world/world.h"
#include "scene/needle_case.h"

static needle_case c;

/* From the tip to the first side; the weight of the corner off the fold: near it. */
#define TIP_OUT 1e-3
#define OFF_FOLD 0.2
#define ASLANT (-2e-3)
#define SQUARE (-0.5e-3)

typedef struct fold {
    suture_hole sides[2]; /* triangle, weights */
    vec3 at[2];
} fold;

static void place_side(const drain_object *d, const drain_edge *side, int k, fold *f)
{
    const uint32_t *node = d->mesh.triangles[side->triangles[k]];
    f->sides[k].triangle = side->triangles[k];
    for (int i = 0; i < 3; i++) {
        bool on = node[i] == side->nodes[0] || node[i] == side->nodes[1];
        f->sides[k].barycentric[i] = on ? 0.5 * (1.0 - OFF_FOLD) : OFF_FOLD;
    }
    f->at[k] = vbss_drain_point(d, d->x, f->sides[k].triangle, f->sides[k].barycentric);
}

/* Two triangles of the tube above its middle that meet at an angle. */
static fold find_fold(const drain_object *d)
{
    fold f = {0};
    for (uint32_t i = 0; i < d->mesh.edge_count; i++) {
        const drain_edge *side = &d->mesh.edges[i];
        if (side->triangles[1] == DRAIN_NONE) {
            continue;
        }
        place_side(d, side, 0, &f);
        place_side(d, side, 1, &f);
        vec3 fold_at = vec3_lerp(d->x[side->nodes[0]], d->x[side->nodes[1]], 0.5);
        vec3 chord_at = vec3_lerp(f.at[0], f.at[1], 0.5);
        if (fold_at.y > 0.0 && vec3_distance(fold_at, chord_at) > 0.1e-3) {
            return f;
        }
    }
    fail();
    return f;
}

/* The axis of the first capsule goes through both, the tip is behind the first. */
static void place_needle(const fold *f)
{
    scene_rigid *r = &vbss_scene_body(small_object(&c.d.s), c.body)->rigid;
    const vec3 tip = vbss_needle_point(r->needle, 0.0);
    const vec3 next = vbss_needle_point(r->needle, vbss_needle_vertex_arc(r->needle, 1));
    const vec3 direction = vec3_unit_or(vec3_sub(f->at[1], f->at[0]), vec3_zero());
    const quat turned = quat_between(vec3_unit_or(vec3_sub(next, tip), vec3_zero()), direction);
    const vec3 there = vec3_add_scaled(f->at[0], -TIP_OUT, direction);
    const pose frame = pose_make(vec3_sub(there, quat_rotate(turned, tip)), turned);
    r->body.now.pose = pose_mul(frame, r->frame);
}

static suture_hole *begin(double entry, fold *f)
{
    needle_case_begin(&c);
    needle_case_make(&c);
    needle_case_put(&c, vec3_make(0.0, 0.0, 0.1), vec3_make(0.0, 1.0, 0.0),
                    vec3_make(0.0, 0.0, 1.0));
    drain_object *d;
    expect_ok(vbss_drain_open(c.d.drain, &d));
    *f = find_fold(d);
    place_needle(f);
    scene_object *s = small_object(&c.d.s);
    s->holes[0] = f->sides[0];
    s->holes[0].id = ++s->last_hole_id;
    s->holes[0].needle = c.body;
    s->holes[0].wall = c.d.body;
    s->holes[0].arc = s->holes[0].max_arc = TIP_OUT;
    s->holes[0].entry_arc = entry;
    return s->holes;
}

static void far_side_of_fold_has_its_own_hole(void **state)
{
    (void)state;
    fold f;
    suture_hole *holes = begin(ASLANT, &f);
    for (int again = 0; again < 2; again++) {
        vbss_scene_find_fold_punctures(small_object(&c.d.s));
        assert_int_equal(holes[1].triangle, f.sides[1].triangle);
        for (int k = 0; k < 3; k++) {
            expect_near(f.sides[1].barycentric[k], holes[1].barycentric[k], 1e-9);
        }
        expect_near(TIP_OUT + vec3_distance(f.at[0], f.at[1]), holes[1].arc, 0.05e-3);
        assert_int_equal(holes[1].needle, c.body);
        assert_int_equal(holes[1].wall, c.d.body);
        assert_int_equal(holes[2].id, 0);
    }
    assert_int_not_equal(holes[1].id, 0);
    needle_case_end(&c);
}

static void square_entry_pierces_only_one_side(void **state)
{
    (void)state;
    fold f;
    suture_hole *holes = begin(SQUARE, &f);
    vbss_scene_find_fold_punctures(small_object(&c.d.s));
    assert_int_equal(holes[1].id, 0);
    needle_case_end(&c);
}

int test_puncture_folds(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(far_side_of_fold_has_its_own_hole),
        cmocka_unit_test(square_entry_pierces_only_one_side),
    };
    return cmocka_run_group_tests_name("scene.puncture_folds", tests, NULL, NULL);
}
