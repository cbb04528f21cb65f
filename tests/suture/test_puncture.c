/* When a tip enters a wall, and where: thresholds; triangles, their sides and nodes; edges; what is anchored. */
#include "fixture.h"
/* The wall of a drain. */
#define WALL(drain) ((const suture_wall[]){suture_wall_of_drain(drain)})

/* ---- when */

static void entry_at_wall_force(void **state)
{
    (void)state;
    vbss_drain_config c;
    expect_ok(vbss_drain_config_init(&c, sizeof c));
    suture_tip tip = {.direction = {0.0, -1.0, 0.0}, .normal = {0.0, 1.0, 0.0}};
    const double forces[] = {0.0, 0.5, 0.999999, 1.0, 1.5};
    for (int i = 0; i < 5; i++) {
        tip.force = vec3_make(0.7, forces[i], -3.0); /* what is borne across does not count */
        assert_int_equal(vbss_suture_tip_punctures(&c, &tip), forces[i] >= 1.0);
        tip.force = vec3_neg(tip.force); /* nor what pulls */
        assert_false(vbss_suture_tip_punctures(&c, &tip));
    }
}

static void oblique_push_slides(void **state)
{
    (void)state;
    vbss_drain_config c;
    expect_ok(vbss_drain_config_init(&c, sizeof c));
    for (int i = 0; i <= 100; i++) {
        double cosine = i / 100.0;
        vec3 direction = vec3_make(sqrt(1.0 - cosine * cosine), -cosine, 0.0);
        suture_tip tip = {.direction = direction,
                          .normal = {0.0, 1.0, 0.0},
                          .force = vec3_scale(direction, -5.0)};
        if (i != 30) {
            assert_int_equal(vbss_suture_tip_punctures(&c, &tip), cosine > 0.3);
        }
    }
}

/* ---- where */

static void expect_hole_at(const fixture *f, const suture_hole *hole, vec3 point, bool outward)
{
    double sum = hole->barycentric[0] + hole->barycentric[1] + hole->barycentric[2];
    expect_near(1.0, sum, 1e-15);
    expect_near(
        0.0,
        vec3_distance(vbss_drain_point(f->d, f->d->x, hole->triangle, hole->barycentric), point),
        1e-12);
    expect_near(-TOUCHING, hole->entry_arc, 1e-12);
    expect_near(hole->entry_arc, hole->arc, 0.0);
    expect_near(hole->entry_arc, hole->max_arc, 0.0);
    assert_int_equal(hole->is_outward, outward);
    suture_hole own = *hole;
    own.needle = 1; /* whoever asks for it knows which */
    assert_true(vbss_hole_is_valid(&own));
}

static void hole_in_triangle_is_at_tip_ray(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    for (uint32_t t = 0; t < f.d->mesh.triangle_count; t++) {
        vec3 point = place_in(&f, t, 0.35, 0.4);
        suture_tip tip = tip_before(&f, t, point, 1.2);
        suture_hole hole;
        bool made = vbss_suture_make_hole(WALL(f.d), &tip, REACH, WIRE, &hole);
        if (to_free_side(&f, point) < WIRE || is_anchored(&f, t)) {
            assert_false(made);
            continue;
        }
        assert_true(made);
        assert_int_equal(hole.triangle, t);
        expect_hole_at(&f, &hole, point, false);
        expect_near(-1.2, hole.friction_force, 1e-12);
        expect_near(0.0, vec3_norm(hole.transverse_force), 1e-12);
        /* And from inside. */
        tip.position = vec3_add_scaled(point, TOUCHING, tip.direction);
        tip.direction = vec3_neg(tip.direction);
        tip.force = vec3_neg(tip.force);
        assert_true(vbss_suture_make_hole(WALL(f.d), &tip, REACH, WIRE, &hole));
        expect_hole_at(&f, &hole, point, true);
        /* Not beyond the reach. */
        assert_false(vbss_suture_make_hole(WALL(f.d), &tip, 0.99 * TOUCHING, WIRE, &hole));
    }
    end(&f);
}

/* However rounding goes: each side from a hundred directions. */
static void shared_edge_has_exactly_one_hole(void **state)
{
    (void)state;
    fixture f;
    uint32_t tried = 0;
    begin(&f);
    for (uint32_t i = 0; i < f.d->mesh.edge_count; i++) {
        const drain_edge *side = &f.d->mesh.edges[i];
        if (side->triangles[1] == DRAIN_NONE || is_anchored(&f, side->triangles[0]) ||
            is_anchored(&f, side->triangles[1])) {
            continue;
        }
        for (int k = 1; k < 100; k++) {
            vec3 point = vec3_lerp(f.d->x[side->nodes[0]], f.d->x[side->nodes[1]], 0.01 * k);
            suture_hole hole;
            suture_tip tip = tip_before(&f, side->triangles[k % 2], point, 1.0);
            if (to_free_side(&f, point) > WIRE) {
                assert_true(vbss_suture_make_hole(WALL(f.d), &tip, REACH, WIRE, &hole));
                expect_hole_at(&f, &hole, point, false);
                tried++;
            }
        }
    }
    assert_true(tried > 20000);
    end(&f);
}

static void shared_node_has_exactly_one_hole(void **state)
{
    (void)state;
    fixture f;
    uint32_t tried = 0;
    begin(&f);
    for (uint32_t t = 0; t < f.d->mesh.triangle_count; t++) {
        for (int k = 0; k < 3; k++) {
            suture_hole hole;
            vec3 point = corner(&f, t, k);
            suture_tip tip = tip_before(&f, t, point, 1.0);
            if (f.d->anchored[f.d->mesh.triangles[t][k]] || to_free_side(&f, point) < WIRE) {
                continue;
            }
            assert_true(vbss_suture_make_hole(WALL(f.d), &tip, REACH, WIRE, &hole));
            expect_hole_at(&f, &hole, point, false);
            tried++;
        }
    }
    assert_true(tried > 300);
    end(&f);
}

/* At the lips, their ends and the ends of the tube, also where a triangle only ends there with a corner. */
static void no_hole_is_within_a_wire_of_an_edge(harness_source *source, void *user)
{
    const fixture *f = user;
    uint32_t t = harness_draw_below(source, f->d->mesh.triangle_count);
    double a = harness_draw_real(source, 0.0, 1.0), b = harness_draw_real(source, 0.0, 1.0);
    bool over = a + b > 1.0;
    vec3 point = place_in(f, t, over ? 1.0 - a : a, over ? 1.0 - b : b);
    suture_tip tip = tip_before(f, t, point, 1.0);
    suture_hole hole;
    double far = to_free_side(f, point), wire = 2.0 * WIRE; /* more of them are near */
    if (!is_anchored(f, t) && fabs(far - wire) > 1e-9) {
        assert_int_equal(vbss_suture_make_hole(WALL(f->d), &tip, REACH, wire, &hole), far > wire);
    }
}

static void hole_needs_wall_all_round(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    harness_property("edges", 20000, no_hole_is_within_a_wire_of_an_edge, &f);
    end(&f);
}

static void anchored_wall_is_not_pierced(void **state)
{
    (void)state;
    fixture f;
    uint32_t tried = 0;
    begin(&f);
    for (uint32_t t = 0; t < f.d->mesh.triangle_count; t++) {
        suture_hole hole;
        suture_tip tip = tip_before(&f, t, place_in(&f, t, 0.3, 0.3), 5.0);
        if (is_anchored(&f, t)) {
            assert_false(vbss_suture_make_hole(WALL(f.d), &tip, REACH, WIRE, &hole));
            tried++;
        }
    }
    assert_true(tried > 10);
    end(&f);
}

/* ---- what it bore before it bears after */

static pose needle_with_tip(const fixture *f, const suture_tip *tip)
{
    quat turn = quat_between(vec3_make(0.0, 1.0, 0.0), tip->direction);
    vec3 arm = quat_rotate(turn, vec3_make(f->n->config.radius, 0.0, 0.0));
    return pose_make(vec3_sub(tip->position, arm), turn);
}

static void forces_go_on_evenly(harness_source *source, void *user)
{
    const fixture *f = user;
    uint32_t t = harness_draw_below(source, f->d->mesh.triangle_count);
    suture_tip tip = tip_before(f, t, place_in(f, t, 0.3, 0.4), 0.0);
    suture_hole hole;
    vec3 lean = harness_draw_vec3(source, -0.3, 0.3);
    tip.direction = vec3_unit_or(vec3_add(tip.direction, lean), vec3_zero());
    double largest = f->d->config.puncture_force;
    vec3 aside = harness_draw_vec3(source, -0.5, 0.5);
    aside = vec3_add_scaled(aside, -vec3_dot(aside, tip.direction), tip.direction);
    tip.force = vec3_add_scaled(aside, -largest, tip.direction);
    if (!vbss_suture_make_hole(WALL(f->d), &tip, REACH, WIRE, &hole)) {
        return;
    }
    pose at = needle_with_tip(f, &tip);
    const suture_curve line = {.needle = f->n, .needle_pose = at};
    const vec3 point = vbss_drain_point(f->d, f->d->x, hole.triangle, hole.barycentric);
    const suture_curve_point now = vbss_suture_nearest_point(&line, hole.arc, point);
    const hole_yield_limit bound = vbss_hole_yield_limit(&hole, &f->d->config, &line, &now);
    contact_constraint row = {.is_bilateral = true, .is_sleeve = true};
    vbss_hole_set_constraint(&hole, &f->d->config, now.arc, &now, point, 1e-3, &row);
    memcpy(row.yield_force, bound.force, sizeof row.yield_force);
    vec3 force = vbss_contact_force(&row, vec3_zero());
    expect_near(0.0, vec3_distance(force, tip.force), 1e-9);
    expect_near(0.0, vec3_distance(hole.transverse_force, aside), 1e-12);
    expect_near(hole.arc, now.arc, 1e-12);
}

static void hole_takes_over_tip_force(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    harness_property("forces", 500, forces_go_on_evenly, &f);
    end(&f);
}

int test_puncture(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(entry_at_wall_force),
        cmocka_unit_test(oblique_push_slides),
        cmocka_unit_test(hole_in_triangle_is_at_tip_ray),
        cmocka_unit_test(shared_edge_has_exactly_one_hole),
        cmocka_unit_test(shared_node_has_exactly_one_hole),
        harness_test(hole_needs_wall_all_round),
        cmocka_unit_test(anchored_wall_is_not_pierced),
        harness_test(hole_takes_over_tip_force),
    };
    return cmocka_run_group_tests_name("suture.puncture", tests, NULL, NULL);
}
