/* However a closed thread is projected, its diagram has the same invariants; a detector that looks along one direction
 * only is less sure, and not wrong; and a tail that is drawn back only loses throws. */
#include <stdlib.h>
#include <string.h>

#include "harness/harness.h"
#include "knot/derive.h"
#include "knot/knot.h"

/* ---- the diagrams of one polygon */

enum { VERTICES = 400, CROSSINGS = 512, DIRECTIONS = 64 };

typedef struct eye {
    harness_memory memory;
    vbss_context *context;
    knot_projector projector;
    knot_gauss_code code, spare;
    knot_algebra algebra;
    knot_polygon polygon;
    vec3 x[VERTICES];
    double place[VERTICES];
    uint8_t stays[VERTICES];
    vbss_array arrays[KNOT_PROJECTOR_ARRAYS + 2 * KNOT_GAUSS_CODE_ARRAYS + KNOT_ALGEBRA_ARRAYS];
    uint32_t count;
} eye;

static void open_eye(eye *e)
{
    memset(e, 0, sizeof *e);
    e->context = harness_context(&e->memory);
    e->polygon = (knot_polygon){
        .x = e->x, .place = e->place, .is_fixed = e->stays, .capacity = VERTICES, .closed = true};
    vbss_array *at = e->arrays;
    vbss_knot_projector_arrays(&e->projector, VERTICES, at);
    vbss_knot_gauss_code_arrays(&e->code, CROSSINGS, at += KNOT_PROJECTOR_ARRAYS);
    vbss_knot_gauss_code_arrays(&e->spare, CROSSINGS, at += KNOT_GAUSS_CODE_ARRAYS);
    vbss_knot_algebra_arrays(&e->algebra, CROSSINGS, at += KNOT_GAUSS_CODE_ARRAYS);
    e->count = (uint32_t)(at - e->arrays) + KNOT_ALGEBRA_ARRAYS;
    expect_ok(vbss_allocate_arrays(e->context, e->arrays, e->count, "eye"));
}

static void close_eye(eye *e)
{
    vbss_release_arrays(e->context, e->arrays, e->count);
    harness_context_end(e->context, &e->memory);
}

/* Both ends go far out where they are outermost, and are joined there. */
static void close_line(eye *e, const thread_line *line, const vec3 out[2])
{
    const double far = 2.0; /* m: twenty times the thread */
    uint32_t last = line->count - 1;
    vec3 between = vec3_add(out[0], out[1]);
    vec3 aside = vec3_norm(between) > 0.1 ? between : vec3_any_normal(out[0]);
    e->polygon.count = 0;
    vbss_knot_polygon_add(&e->polygon, vec3_add_scaled(line->x[0], far, out[0]), -1.0, false);
    for (uint32_t i = 0; i <= last; i++) {
        vbss_knot_polygon_add(&e->polygon, line->x[i], i, false);
    }
    vbss_knot_polygon_add(&e->polygon, vec3_add_scaled(line->x[last], far, out[1]), -1.0, false);
    vec3 round = vec3_add_scaled(line->x[0], 2.0 * far, vec3_unit_or(aside, out[0]));
    vbss_knot_polygon_add(&e->polygon, round, -1.0, false);
}

static void expect_invariants(eye *e, knot_gauss_code *code, knot_invariants wanted)
{
    knot_ops work = INT64_MAX;
    knot_invariants v = {.known = true};
    v.determinant = vbss_knot_determinant(&e->algebra, code, &work);
    vbss_knot_vassiliev(code, &v.v2, &v.v3, &work);
    assert_true(vbss_knot_signature(&e->algebra, code, KNOT_X_ORDINARY_10000, &v.signature, &work));
    assert_true(vbss_knot_signature(&e->algebra, code, KNOT_X_TRISTRAM_10000, &v.signature_tristram,
                                    &work));
    assert_true(vbss_knot_invariants_same(v, wanted));
}

static knot_invariants truth_of(const family_case *c)
{
    knot_factors f = {.count = 0};
    for (uint32_t i = 0; i < c->throws; i++) {
        f.factors[f.count++] = (knot_factor){.wraps = c->wraps[i], .handedness = c->signs[i]};
    }
    if (c->stray_wraps > 0) {
        f.factors[f.count++] = (knot_factor){.wraps = c->stray_wraps, .handedness = c->stray_sign};
    }
    return vbss_knot_invariants_of(&f);
}

/* As it is seen, simplified, and untangled. */
static void count_diagrams(eye *e, const family_case *c, uint32_t counts[3])
{
    for (uint32_t k = 0; k < DIRECTIONS; k++) {
        knot_ops work = INT64_MAX;
        knot_diagram_status diagram =
            vbss_knot_project(&e->projector, &e->polygon, vbss_knot_direction(k), &e->code, &work);
        counts[diagram]++;
        if (diagram != KNOT_DIAGRAM_REGULAR) {
            continue;
        }
        assert_true(vbss_knot_gauss_code_is_planar(&e->code));
        if (e->code.n < 70) {
            expect_invariants(e, &e->code, truth_of(c));
        }
        vbss_knot_gauss_code_simplify(&e->code, &work);
        expect_invariants(e, &e->code, truth_of(c));
        uint32_t tries = 1000;
        while (vbss_knot_gauss_code_untangle(&e->code, &e->spare, &tries, &work)) {
            expect_invariants(e, &e->code, truth_of(c));
        }
    }
}

static void all_directions_agree(void **state)
{
    (void)state;
    static const char *const names[] = {"three throws", "crumpled",       "cluttered",
                                        "stray",        "tangled unknot", "torus knots"};
    static family_case made;
    static derivation d;
    static eye e;
    uint32_t counts[3] = {0, 0, 0};
    open_eye(&e);
    for (size_t f = 0; f < sizeof names / sizeof names[0]; f++) {
        for (uint64_t seed = 0; seed < 4; seed++) {
            assert_true(family_named(names[f])->make(40 + seed, 120, &made));
            assert_true(derive_begin(&d, &made));
            close_line(&e, &made.line, d.out);
            count_diagrams(&e, &made, counts);
        }
    }
    close_eye(&e);
    print_message("%u diagrams plain, %u degenerate, %u full\n", counts[KNOT_DIAGRAM_REGULAR],
                  counts[KNOT_DIAGRAM_DEGENERATE], counts[KNOT_DIAGRAM_FULL]);
    assert_true(counts[KNOT_DIAGRAM_REGULAR] >= 1500 && counts[KNOT_DIAGRAM_DEGENERATE] <= 15);
}

/* ---- one direction, and few crossings */

static void judge_with(uint32_t directions, uint32_t crossings, judge_counts *all)
{
    judge j;
    judge_begin(&j);
    j.config.direction_limit = directions;
    j.config.crossing_capacity = crossings;
    assert_true(judge_make(&j));
    for (int f = 0; f < FAMILIES; f++) {
        for (uint64_t seed = 0; seed < 3; seed++) {
            (void)derive_and_judge(&j, &families[f], 500 + seed, 120, 8, all);
        }
    }
    judge_end(&j);
    print_message("%u directions, room for %u crossings: %llu heard, %llu uncertain, %llu wrong\n",
                  directions, crossings, (unsigned long long)all->heard,
                  (unsigned long long)all->uncertain, (unsigned long long)all->wrong);
    if (all->wrong > 0) {
        fail_msg("the first: %s", all->first);
    }
}

static void single_direction_is_never_wrong(void **state)
{
    (void)state;
    judge_counts one = {0}, few = {0}, none = {0};
    judge_with(1, 256, &one);
    assert_true(50 * one.uncertain <= one.heard);
    judge_with(12, 64, &few);
    judge_with(12, 8, &none);
    assert_true(one.uncertain <= few.uncertain && few.uncertain < none.uncertain);
}

/* ---- the tail is drawn back */

static uint32_t throws_left(judge *j, const thread_line *line, uint32_t from, bool *uncertain)
{
    static thread_line rest;
    judge_saying said;
    rest = *line;
    rest.count = line->count - from;
    memmove(rest.x, line->x + from, rest.count * sizeof rest.x[0]);
    rest.hole_places[0] -= from;
    rest.hole_places[1] -= from;
    rest.tissue_place -= from;
    vbss_knot_input in = judge_input_of(&rest);
    expect_ok(judge_hear(j, &in, &said));
    *uncertain = judge_is_uncertain(&said) || said.state.name == VBSS_KNOT_NAME_OTHER;
    return said.state.throw_count;
}

static void drawn_back_tail_loses_throws(void **state)
{
    (void)state;
    static const int throws[][3] = {{2, -1, 1}, {1, 1, -1}, {3, 2, 1}, {-2, -2, 2}};
    static thread_line line;
    judge j;
    judge_begin(&j);
    assert_true(judge_make(&j));
    for (size_t k = 0; k < sizeof throws / sizeof throws[0]; k++) {
        throw_stack stack;
        throw_stack_init(&stack);
        for (int i = 0; i < 3; i++) {
            throw_stack_add(&stack, abs(throws[k][i]), throws[k][i] > 0 ? 1 : -1);
        }
        assert_true(throw_stack_make(&stack, &line));
        uint32_t left = 3, doubted = 0, seen[4] = {0, 0, 0, 0};
        for (uint32_t from = 0; from + 1 < line.hole_places[0]; from++) {
            bool uncertain;
            uint32_t now = throws_left(&j, &line, from, &uncertain);
            doubted += uncertain;
            if (!uncertain) {
                assert_true(now <= left);
                left = now;
                seen[now]++;
            }
        }
        print_message("3 throws %u times, 2 %u, 1 %u, 0 %u; uncertain %u\n", seen[3], seen[2],
                      seen[1], seen[0], doubted);
        assert_true(seen[3] > 0 && seen[2] > 0 && seen[1] > 0 && seen[0] > 0);
    }
    judge_end(&j);
}

int test_detector_directions(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(all_directions_agree),
        harness_test(single_direction_is_never_wrong),
        harness_test(drawn_back_tail_loses_throws),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
