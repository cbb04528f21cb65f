/* What a mesh leaves out because it is near along the surface, against all pairs and their shortest paths. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "collision/near_rig.h"

/* Finds, and checks against all pairs; returns how many. */
static uint32_t find(const near_rig *f)
{
    uint32_t count;
    shapes_find(f->collision, &count);
    model_check(&f->m, f->collision, 0);
    return count;
}

/* ---- against all pairs */

/* No path is as long as a distance that is drawn, give or take the rounding. */
static bool is_clear(const model_shape *s)
{
    bool clear = true;
    for (size_t i = 0; i < (size_t)s->node_count * s->node_count; i++) {
        clear = clear && !(fabs(s->arcs[i] - s->near) < 1e-12 * s->near);
    }
    return clear;
}

static void draw_distances(near_rig *f, harness_source *source)
{
    for (uint32_t i = 0; i < f->m.count; i++) {
        model_shape *s = &f->m.shapes[i];
        double distance = MODEL_UNIT * harness_draw_real(source, 0.0, 20.0);
        bool last = i + 1 == f->m.count;
        if (s->kind != MODEL_MESH || (harness_draw_below(source, 4) == 0 && !last)) {
            continue;
        }
        do {
            distance *= 1.0 + 1e-6;
            model_leave_out_near(s, s->end, distance);
        } while (!is_clear(s));
        near_leave_out(f, i, s->end, distance);
    }
}

/* Shapes of all kinds, meshes among them, and a sheet with a slit; distances are drawn twice. */
static void all_pairs(harness_source *source, void *user)
{
    uint32_t *near = user;
    near_rig f;
    near_begin(&f);
    model_draw(&f.m, source);
    f.m.config.pair_capacity = 200000;
    uint32_t columns = 4 + harness_draw_below(source, 5);
    uint32_t rows = 3 + harness_draw_below(source, 4);
    uint32_t slit = 1 + harness_draw_below(source, rows - 2);
    model_slit_sheet(&f.m, columns, rows, slit, MODEL_UNIT);
    near_make(&f);
    for (int i = 0; i < 6; i++) {
        uint32_t motion = harness_draw_below(source, MODEL_MOTIONS);
        model_draw_motion(&f.m, (model_motion)motion, source);
        model_move(&f.m, f.collision);
        f.object->wide = i % 2 == 0 && vbss_wide_is_available();
        uint32_t before = find(&f);
        if (i % 3 == 0) {
            draw_distances(&f, source);
            assert_int_equal(shapes_statistics(f.collision).candidates, 0); /* forgotten */
            *near += find(&f) < before;
        }
    }
    near_end(&f);
}

static void near_pairs_are_complete_sorted_and_exact(void **state)
{
    (void)state;
    uint32_t near = 0;
    harness_property("near pairs", 200, all_pairs, &near);
    assert_true(near > 150 || getenv("VBSS_PROPERTY_CASE") != NULL); /* enough is left out */
}

/* ---- a slit, where the arcs are known */

static uint32_t edge_of(const model_shape *s, uint32_t p, uint32_t q)
{
    uint32_t e = 0;
    while (e < s->edge_count && (s->edges[e][0] != p || s->edges[e][1] != q)) {
        e++;
    }
    assert_true(e < s->edge_count);
    return e;
}

static bool lists(const near_rig *f, candidate pair)
{
    vbss_view view = shapes_view(f->collision, VBSS_COLLISION_VIEW_CANDIDATES);
    const candidate *listed = view.data;
    for (uint64_t i = 0; i < view.count; i++) {
        if (memcmp(&listed[i], &pair, sizeof pair) == 0) {
            return true;
        }
    }
    return false;
}

/* Lips between columns k and k + 1 lie on each other, and so do the point of the upper one at column k and
 * the triangle that the lower one is a side of. The paths round the tips are the shorter ones. */
static void lips_touch_except_near_tips(void **state)
{
    (void)state;
    const double distances[] = {0.0, 1.0, 2.0, 2.5, 4.0, 6.0, 8.0, 8.0 * (1.0 + DBL_EPSILON), 20.0};
    near_rig f;
    near_begin(&f);
    f.m.exact = true;
    model_shape *s = near_add_slit_sheet(&f);
    near_make(&f);
    model_move(&f.m, f.collision);
    for (size_t i = 0; i < sizeof distances / sizeof distances[0]; i++) {
        near_leave_out(&f, 0, s->end, distances[i]);
        model_leave_out_near(s, s->end, distances[i]);
        find(&f);
        for (uint32_t k = 1; k < 8; k++) {
            uint32_t around = k < 8 - k ? 2 * k : 16 - 2 * k, across = k < 5 ? 2 * k : 17 - 2 * k;
            const candidate edges = {VBSS_COLLISION_PAIR_EDGE_EDGE, 0, edge_of(s, 20 + k, 21 + k),
                                     0, edge_of(s, 39 + k, 40 + k)};
            const candidate point = {VBSS_COLLISION_PAIR_POINT_TRIANGLE, 0, 39 + k, 0, 19 + 2 * k};
            assert_int_equal(lists(&f, edges), around >= distances[i]);
            assert_int_equal(lists(&f, point), across >= distances[i]);
        }
    }
    near_end(&f);
}

/* All nodes in one place: what is left is the rule. As much room as that, and not one pair less. */
static void excluded_pairs_need_no_capacity(void **state)
{
    (void)state;
    uint32_t counts[2];
    for (int round = 0; round < 4; round++) {
        near_rig f;
        near_begin(&f);
        vec3 at[NEAR_COLUMNS * NEAR_ROWS + NEAR_COLUMNS - 2];
        model_shape *s = near_add_slit_sheet(&f);
        memcpy(at, s->end, sizeof at);
        memset(s->start, 0, sizeof at);
        memset(s->end, 0, sizeof at);
        f.m.config.pair_capacity = round == 0 ? 200000 : round == 1 ? counts[0] : counts[1];
        f.m.config.pair_capacity -= round == 3;
        near_make(&f);
        if (round == 0) {
            counts[0] = find(&f);
        }
        near_leave_out(&f, 0, at, 3.0);
        model_leave_out_near(s, at, 3.0);
        if (round == 3) {
            expect_result(VBSS_ERROR_CAPACITY, vbss_collision_find_candidates(f.collision));
            assert_int_equal(shapes_statistics(f.collision).candidates, 0);
        } else {
            counts[1] = find(&f);
            assert_in_range(counts[1], counts[0] / 4, counts[0] - counts[0] / 4);
        }
        near_end(&f);
    }
}

/* Two sheets in one place: pairs of both stay, and each has a rule of its own. */
static void other_shapes_are_not_tested(void **state)
{
    (void)state;
    near_rig f;
    near_begin(&f);
    f.m.exact = true;
    for (int i = 0; i < 2; i++) {
        near_add_slit_sheet(&f);
    }
    near_make(&f);
    model_move(&f.m, f.collision);
    uint32_t before = find(&f), count = before;
    for (uint32_t i = 0; i < 2; i++) {
        model_shape *s = &f.m.shapes[1 - i];
        near_leave_out(&f, 1 - i, s->end, 2.5);
        model_leave_out_near(s, s->end, 2.5);
        uint32_t left = find(&f);
        assert_true(left < count);
        assert_true(i == 0 || before - left == 2 * (before - count));
        count = left;
    }
    near_end(&f);
}

/* From node 0 over 1 and 2 the path to node 3 is the distance, and back it is rounded to less: then they are near
 * each other, whichever is asked about. */
static void path_distance_is_symmetric(void **state)
{
    (void)state;
    const uint32_t triangles[5][3] = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 5, 6}, {0, 7, 8}};
    vec3 at[9] = {{0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, {0.1, 0.2, 0.0}, {0.1, 0.2, 0.3}};
    near_rig f;
    near_begin(&f);
    model_shape *s = model_mesh(&f.m, 9, triangles, 5, 0.1);
    near_make(&f);
    for (uint32_t i = 4; i < 9; i++) {
        at[i].x = i * 10.0;
    }
    double there = (0.1 + 0.2) + 0.3, back = (0.3 + 0.2) + 0.1;
    assert_true(back < there);
    for (int near = 0; near < 2; near++) {
        near_leave_out(&f, 0, at, near != 0 ? there : back);
        expect_ok(vbss_collision_find_candidates(f.collision));
        const candidate from_first = {VBSS_COLLISION_PAIR_POINT_TRIANGLE, 0, 0, 0, 3};
        const candidate from_last = {VBSS_COLLISION_PAIR_POINT_TRIANGLE, 0, 3, 0, 4};
        const candidate edges = {VBSS_COLLISION_PAIR_EDGE_EDGE, 0, edge_of(s, 0, 7), 0,
                                 edge_of(s, 3, 5)};
        assert_int_equal(lists(&f, from_first), near == 0);
        assert_int_equal(lists(&f, from_last), near == 0);
        assert_int_equal(lists(&f, edges), near == 0);
    }
    near_end(&f);
}

int test_near_pairs(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(near_pairs_are_complete_sorted_and_exact),
        cmocka_unit_test(lips_touch_except_near_tips),
        cmocka_unit_test(excluded_pairs_need_no_capacity),
        cmocka_unit_test(other_shapes_are_not_tested),
        cmocka_unit_test(path_distance_is_symmetric),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
