/* The re-test of chains with a wall finds what each pair alone tells, whether the wall is asked with itself or not. */
#include "oracle/surface.h"

#include <string.h>

#include "harness/harness.h"
#include "oracle/sweep.h"

/* A wall of SIDE squares a side, 1 wide each, cut into two triangles; chains that go about it. */
enum {
    SIDE = 6,
    ROW = SIDE + 1,
    WALL_NODES = ROW * ROW,
    WORDS = 1,
    TRIANGLES = 2 * SIDE * SIDE,
    SIDES = 2 * SIDE * ROW + SIDE * SIDE,
    CHAINS = 3,
    CHAIN_NODES = 6
};

typedef struct vertex_motion {
    vec3 start[WALL_NODES], end[WALL_NODES];
    uint32_t triangles[TRIANGLES][3], sides[SIDES][2];
    size_t side_count;
    uint64_t all_near[WALL_NODES][WORDS];
    vec3 chain_start[CHAINS][CHAIN_NODES], chain_end[CHAINS][CHAIN_NODES];
    passing_chain chains[CHAINS];
} motion;

static void add_side(motion *m, uint32_t from, uint32_t to)
{
    m->sides[m->side_count][0] = from;
    m->sides[m->side_count++][1] = to;
}

static void make_wall(motion *m)
{
    size_t triangle = 0;
    m->side_count = 0;
    for (uint32_t i = 0; i < ROW; i++) {
        for (uint32_t k = 0; k < ROW; k++) {
            const uint32_t at = i * ROW + k;
            if (i < SIDE) {
                add_side(m, at, at + ROW);
            }
            if (k < SIDE) {
                add_side(m, at, at + 1);
            }
            if (i < SIDE && k < SIDE) {
                add_side(m, at, at + ROW + 1);
                const uint32_t two[2][3] = {{at, at + ROW, at + ROW + 1},
                                            {at, at + ROW + 1, at + 1}};
                memcpy(m->triangles[triangle], two, sizeof two);
                triangle += 2;
            }
        }
    }
}

static vec3 shaken(harness_source *source, vec3 x, double by)
{
    return vec3_add(x, harness_draw_vec3(source, -by, by));
}

static void draw_motion(harness_source *source, motion *m)
{
    make_wall(m);
    memset(m->all_near, 0xff, sizeof m->all_near);
    for (uint32_t i = 0; i < WALL_NODES; i++) {
        const uint32_t column = i / ROW, row = i % ROW;
        vec3 flat = vec3_make(column, row, 0.0);
        m->start[i] = shaken(source, flat, 0.3);
        m->end[i] = shaken(source, m->start[i], 0.2);
    }
    for (size_t c = 0; c < CHAINS; c++) {
        vec3 x = vec3_make(harness_draw_real(source, -2.0, SIDE + 2.0),
                           harness_draw_real(source, -2.0, SIDE + 2.0),
                           harness_draw_real(source, -1.0, 1.0));
        for (size_t i = 0; i < CHAIN_NODES; i++) {
            m->chain_start[c][i] = x;
            m->chain_end[c][i] = shaken(source, x, 0.5);
            x = shaken(source, x, 1.0);
        }
        m->chains[c] = (passing_chain){m->chain_start[c], m->chain_end[c], CHAIN_NODES, false};
    }
}

/* Each segment with each side, each node with each triangle. */
static uint64_t count_pairs(const motion *m)
{
    uint64_t met = 0;
    bool asked;
    for (size_t c = 0; c < CHAINS; c++) {
        for (uint32_t i = 0; i < CHAIN_NODES; i++) {
            const uint32_t nodes[2] = {i, i + 1};
            const sweep node = sweep_make(m->chain_start[c], m->chain_end[c], nodes, 1);
            for (size_t k = 0; k < TRIANGLES; k++) {
                const sweep of = sweep_make(m->start, m->end, m->triangles[k], 3);
                met += sweep_meets(&node, &of, &asked);
            }
            for (size_t k = 0; k < m->side_count && i + 1 < CHAIN_NODES; k++) {
                const sweep segment = sweep_make(m->chain_start[c], m->chain_end[c], nodes, 2);
                const sweep of = sweep_make(m->start, m->end, m->sides[k], 2);
                met += sweep_meets(&segment, &of, &asked);
            }
        }
    }
    return met;
}

static passing_surface_report report_of(const motion *m, bool with_itself)
{
    const passing_surface wall = {.start = m->start,
                                  .end = m->end,
                                  .nodes = WALL_NODES,
                                  .triangles = m->triangles[0],
                                  .triangle_count = TRIANGLES,
                                  .sides = m->sides[0],
                                  .side_count = m->side_count,
                                  .near = with_itself ? m->all_near[0] : NULL,
                                  .words = WORDS};
    passing_surface_report report;
    const uint64_t passed = passing_surfaces(&wall, 1, m->chains, CHAINS, &report);
    assert_int_equal(passed, report.passed);
    return report;
}

typedef struct seen {
    unsigned met, clean;
} seen;

static void wall_is_asked_as_its_pairs(harness_source *source, void *user)
{
    static motion m;
    seen *s = user;
    draw_motion(source, &m);
    const uint64_t met = count_pairs(&m);
    const passing_surface_report alone = report_of(&m, false), all = report_of(&m, true);
    assert_int_equal(met, alone.passed);
    assert_int_equal(met, all.passed);
    assert_int_equal(all.asked, alone.asked);
    for (int i = 0; i < 2; i++) {
        assert_int_equal(all.first[i].of, alone.first[i].of);
        assert_int_equal(all.first[i].number, alone.first[i].number);
        assert_int_equal(all.first[i].corners, alone.first[i].corners);
    }
    s->met += met > 0;
    s->clean += met == 0;
}

static void chains_and_wall_are_tested_pairwise(void **state)
{
    (void)state;
    seen s = {0, 0};
    harness_property("wall", 60, wall_is_asked_as_its_pairs, &s);
    assert_true(s.met > 10 && s.clean > 3);
}

static void wall_without_chains_has_no_crossing(void **state)
{
    (void)state;
    static motion m;
    make_wall(&m);
    const passing_surface wall = {.start = m.start,
                                  .end = m.end,
                                  .nodes = WALL_NODES,
                                  .triangles = m.triangles[0],
                                  .triangle_count = TRIANGLES};
    passing_surface_report report;
    assert_int_equal(0, passing_surfaces(&wall, 1, NULL, 0, &report));
    assert_int_equal(0, report.asked);
}

static void single_point_crosses_wall(void **state)
{
    (void)state;
    static const vec3 corners[3] = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
    static const uint32_t triangle[3] = {0, 1, 2};
    const vec3 above = vec3_make(0.25, 0.25, 1.0), below = vec3_make(0.25, 0.25, -1.0);
    const passing_chain point = {&above, &below, 1, false};
    const passing_surface wall = {
        .start = corners, .end = corners, .nodes = 3, .triangles = triangle, .triangle_count = 1};
    passing_surface_report report;
    assert_int_equal(1, passing_surfaces(&wall, 1, &point, 1, &report));
    assert_int_equal(1, report.first[0].corners);
    assert_int_equal(3, report.first[1].corners);
}

int test_passage_surface(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(chains_and_wall_are_tested_pairwise),
        cmocka_unit_test(wall_without_chains_has_no_crossing),
        cmocka_unit_test(single_point_crosses_wall),
    };
    return cmocka_run_group_tests_name("contact.passage_surface", tests, NULL, NULL);
}
