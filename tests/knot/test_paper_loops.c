/* Method PROJECTION, criterion 1, on small threads by hand. The search goes from the last segment to the
 * first; first and last of a loop are numbers from the tail's end. */
#include "knot/paper_rig.h"

/* A square about the tool, its ends crossing at (8, 8), the tail's end above by 2 mm. */
#define SQUARE                                           \
    {30, 8, 12}, {-8, 8, 12}, {-8, -8, 11}, {8, -8, 10}, \
    {                                                    \
        8, 30, 10                                        \
    }

static void expect_loop(const paper_rig *rig, uint32_t number, uint32_t first, uint32_t last,
                        uint32_t inside)
{
    assert_true(number < rig->paper.loop_count);
    const baseline_loop *loop = &rig->paper.loops[number];
    assert_int_equal(0, loop->tool);
    assert_int_equal(first, loop->first);
    assert_int_equal(last, loop->last);
    assert_int_equal(inside, loop->inside);
}

static void expect_point(double x, double y, double z, vec3 got)
{
    expect_near(1e-3 * x, got.x, 1e-17);
    expect_near(1e-3 * y, got.y, 1e-17);
    expect_near(1e-3 * z, got.z, 1e-17);
}

static void loop_is_found_with_its_pair(void **state)
{
    (void)state;
    paper_rig rig;
    paper_rig_begin(&rig);
    PAPER_SHOW(&rig, SQUARE);
    assert_int_equal(1, paper_rig_loops(&rig, 1));
    expect_loop(&rig, 0, 0, 3, 1);
    expect_point(8, 8, 12, rig.paper.loops[0].meeting[0]);
    expect_point(8, 8, 10, rig.paper.loops[0].meeting[1]);
    assert_true(rig.paper.loops[0].first_is_above);
    paper_rig_end(&rig);
}

static void non_crossing_curve_has_no_loop(void **state)
{
    (void)state;
    paper_rig rig;
    paper_rig_begin(&rig);
    PAPER_SHOW(&rig, {0, 0, 0}, {1, 0, 0});
    assert_int_equal(0, paper_rig_loops(&rig, 1));
    PAPER_SHOW(&rig, {30, 8, 12}, {-8, 8, 12}, {-8, -8, 11}, {8, -8, 10}, {8, 7, 10});
    assert_int_equal(0, paper_rig_loops(&rig, 1)); /* not quite round */
    PAPER_SHOW(&rig, {0, 5, 1}, {9, 5, 1}, {2, 5, 2}, {7, 5, 3});
    assert_int_equal(0, paper_rig_loops(&rig, 1)); /* neighbours on each other; parallels */
    paper_rig_end(&rig);
}

static void first_crossing_from_long_limb_closes_loop(void **state)
{
    (void)state;
    paper_rig rig;
    paper_rig_begin(&rig);
    /* The last segment crosses 4, then 2, then 0; segment 5 would cross 1. */
    PAPER_SHOW(&rig, {-9, -6, 1}, {9, -6, 1}, {9, 6, 1}, {-9, 6, 1}, {-9, 9, 1}, {9, 9, 1},
               {5, -9, 1}, {-5, -9, 1}, {-5, 20, 1});
    assert_int_equal(1, paper_rig_loops(&rig, 1));
    expect_loop(&rig, 0, 4, 7, 1);
    paper_rig_end(&rig);
}

static void search_continues_behind_loop(void **state)
{
    (void)state;
    paper_rig rig;
    paper_rig_begin(&rig);
    /* Twice round, outward, over a strand that comes in radially. From the outer end the whole is found first;
     * from the strand's end the first turn is, and the second has nothing left to cross. */
    PAPER_SHOW(&rig, {30, 1, 9}, {4, 1, 9}, {4, 4, 8}, {-4, 4, 8}, {-4, -4, 8}, {6, -4, 8},
               {6, 6, 7}, {-6, 6, 7}, {-6, -6, 7}, {8, -6, 7}, {8, 30, 6});
    assert_int_equal(1, paper_rig_loops(&rig, 1));
    expect_loop(&rig, 0, 0, 9, 0); /* even: see below */
    paper_rig_reverse(&rig);
    assert_int_equal(1, paper_rig_loops(&rig, 1));
    expect_loop(&rig, 0, 4, 9, 1);

    /* One square after another. */
    PAPER_SHOW(&rig, SQUARE, {70, 30, 9}, {70, 7, 9}, {-7, 7, 9}, {-7, -7, 9}, {7, -7, 8},
               {7, 40, 8});
    assert_int_equal(2, paper_rig_loops(&rig, 1));
    expect_loop(&rig, 0, 6, 9, 1); /* the long limb's first */
    expect_loop(&rig, 1, 0, 3, 1);
    paper_rig_end(&rig);
}

static void loop_segments_are_consumed(void **state)
{
    (void)state;
    paper_rig rig;
    paper_rig_begin(&rig);
    /* Segment 5 crosses 2; 4 would cross 0, but 2 to 5 are used, and 0 and 1 are too few. */
    PAPER_SHOW(&rig, {-20, -4, 5}, {20, -4, 5}, {20, 8, 5}, {-8, 8, 5}, {-8, -8, 5}, {4, -8, 5},
               {4, 30, 5});
    assert_int_equal(1, paper_rig_loops(&rig, 1));
    expect_loop(&rig, 0, 2, 5, 1);
    paper_rig_end(&rig);
}

static void tool_crosses_loop_odd_times(void **state)
{
    (void)state;
    paper_rig rig;
    paper_rig_begin(&rig);
    for (uint64_t seed = 1; seed <= 300; seed++) { /* whatever the ray */
        PAPER_SHOW(&rig, SQUARE);
        paper_rig_loops(&rig, seed);
        expect_loop(&rig, 0, 0, 3, 1);
        for (uint32_t k = 0; k < rig.scene.point_count; k++) {
            rig.points[k].x += 9e-3;
        }
        paper_rig_loops(&rig, seed);
        expect_loop(&rig, 0, 0, 3, 0); /* beside it */
        PAPER_SHOW(&rig, {30, 8, 9}, {-8, 8, 9}, {-8, -8, 9}, {4, -8, 9}, {4, 4, 9}, {-4, 4, 9},
                   {-4, -4, 9}, {8, -4, 9}, {8, 30, 9});
        paper_rig_loops(&rig, seed);
        expect_loop(&rig, 0, 0, 7, 0); /* round it twice, by one polygon */
    }
    paper_rig_end(&rig);
}

static void point_on_segment_is_one_crossing(void **state)
{
    (void)state;
    paper_rig rig;
    paper_rig_begin(&rig);
    PAPER_SHOW(&rig, {30, 8, 12}, {-8, 8, 12}, {-8, -8, 11}, {8, -8, 10}, {8, 8, 10}, {8, 30, 10});
    assert_int_equal(1, paper_rig_loops(&rig, 1));
    assert_int_equal(0, rig.paper.loops[0].first);
    assert_int_equal(1, rig.paper.loops[0].inside);
    PAPER_SHOW(&rig, {30, 8, 12}, {8, 8, 12}, {-8, 8, 12}, {-8, -8, 11}, {8, -8, 10}, {8, 30, 10});
    assert_int_equal(1, paper_rig_loops(&rig, 1));
    assert_int_equal(1, rig.paper.loops[0].inside);
    paper_rig_end(&rig);
}

static void above_is_nearer_to_handle(void **state)
{
    (void)state;
    paper_rig rig;
    paper_rig_begin(&rig);
    for (int offset = -40; offset <= 40; offset += 10) { /* wherever P is: heights have signs */
        rig.config.plane_offset = 1e-3 * offset + 1e-3;
        PAPER_SHOW(&rig, SQUARE);
        paper_rig_loops(&rig, 1);
        assert_true(rig.paper.loops[0].first_is_above);
        paper_rig_reverse(&rig);
        paper_rig_loops(&rig, 1);
        assert_false(rig.paper.loops[0].first_is_above);
    }
    paper_rig_end(&rig);
}

static void reversed_tool_swaps_above_and_below(void **state)
{
    (void)state;
    paper_rig rig;
    paper_rig_begin(&rig);
    PAPER_SHOW(&rig, SQUARE);
    rig.tools[0].axis[0] = vec3_make(0.0, 0.0, -0.15);
    assert_int_equal(1, paper_rig_loops(&rig, 1));
    assert_false(rig.paper.loops[0].first_is_above);
    paper_rig_end(&rig);
}

static void only_last_capsule_is_tested_without_ends(void **state)
{
    (void)state;
    paper_rig rig;
    paper_rig_begin(&rig);
    PAPER_SHOW(&rig, SQUARE);
    rig.tools[0].point_count = 3;
    rig.tools[0].axis[0] = vec3_make(0.2, 0.1, 0.15);
    rig.tools[0].axis[1] = vec3_make(0.0, 0.0, 0.5);
    rig.tools[0].axis[2] = vec3_make(0.0, 0.0, 0.4); /* 39 cm above the loop */
    assert_int_equal(1, paper_rig_loops(&rig, 1));
    expect_loop(&rig, 0, 0, 3, 1);
    paper_rig_end(&rig);
}

static void rays_follow_seed_and_loops_append(void **state)
{
    (void)state;
    paper_rig rig;
    paper_rig_begin(&rig);
    PAPER_SHOW(&rig, SQUARE);
    paper_rig_loops(&rig, 5);
    vbss_random after = rig.random;
    baseline_loop loop = rig.paper.loops[0];
    paper_rig_loops(&rig, 5);
    assert_memory_equal(&after, &rig.random, sizeof after);
    assert_memory_equal(&loop.meeting, &rig.paper.loops[0].meeting, sizeof loop.meeting);
    vbss_baseline_find_loops(&rig.paper, &rig.config, &rig.scene, 1);
    assert_int_equal(2, rig.paper.loop_count);
    assert_int_equal(1, rig.paper.loops[1].tool);
    assert_true(after.state != rig.random.state); /* a ray a loop */
    paper_rig_end(&rig);
}

/* Against the algorithm as it reads, two loops over all pairs. */
static void simd_search_equals_plain_search(void **state)
{
    (void)state;
    paper_rig rig;
    paper_rig_begin(&rig);
    vbss_random random;
    vbss_random_seed(&random, 3, 3);
    for (uint32_t round = 0; round < 400; round++) {
        uint32_t n = 2 + vbss_random_below(&random, 40);
        vec3 x = vec3_zero();
        for (uint32_t k = 0; k < n; k++) {
            x = vec3_add_scaled(vec3_scale(x, 0.9), 3e-3, vbss_random_direction(&random));
            rig.points[k] = x;
        }
        rig.scene.point_count = n;
        paper_rig_loops(&rig, 1);
        uint32_t number = 0;
        for (int64_t i = (int64_t)n - 2; i >= 2; i--) {
            for (int64_t j = i - 2; j >= 0; j--) {
                vec3 a = rig.points[i], b = rig.points[i + 1], c = rig.points[j],
                     d = rig.points[j + 1];
                double c0 = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
                double c1 = (b.x - a.x) * (d.y - a.y) - (b.y - a.y) * (d.x - a.x);
                double a0 = (d.x - c.x) * (a.y - c.y) - (d.y - c.y) * (a.x - c.x);
                double a1 = (d.x - c.x) * (b.y - c.y) - (d.y - c.y) * (b.x - c.x);
                if ((c0 < 0) != (c1 < 0) && (a0 < 0) != (a1 < 0)) {
                    assert_true(number < rig.paper.loop_count);
                    assert_int_equal(j, rig.paper.loops[number].first);
                    assert_int_equal(i, rig.paper.loops[number].last);
                    number++;
                    i = j;
                    break;
                }
            }
        }
        assert_int_equal(number, rig.paper.loop_count);
    }
    paper_rig_end(&rig);
}

int test_paper_loops(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(loop_is_found_with_its_pair),
        cmocka_unit_test(non_crossing_curve_has_no_loop),
        cmocka_unit_test(first_crossing_from_long_limb_closes_loop),
        cmocka_unit_test(search_continues_behind_loop),
        cmocka_unit_test(loop_segments_are_consumed),
        cmocka_unit_test(tool_crosses_loop_odd_times),
        cmocka_unit_test(point_on_segment_is_one_crossing),
        cmocka_unit_test(above_is_nearer_to_handle),
        cmocka_unit_test(reversed_tool_swaps_above_and_below),
        cmocka_unit_test(only_last_capsule_is_tested_without_ends),
        cmocka_unit_test(rays_follow_seed_and_loops_append),
        cmocka_unit_test(simd_search_equals_plain_search),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
