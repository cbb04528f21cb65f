/* Each limb is read together with the ray away from the tissue, wherever that goes: right through the knot, too. An
 * oracle that shares nothing with the detector says which knot the two are. And ends that lie inside are told. */
#include <string.h>

#include "harness/harness.h"
#include "knot/derive.h"
#include "knot/knot.h"
#include "oracle/knot_type.h"

/* ---- a limb and the ray */

/* From far beyond the limb's end, where it is outermost, to the tissue, and far along the ray. */
static bool type_of_limb(const thread_line *line, vec3 out, bool tail, knot_type *type)
{
    static thread_line limb;
    const double far = 2.0; /* m: twenty times the thread */
    limb = *line;
    if (!tail) {
        thread_line_reverse(&limb);
    }
    uint32_t last = (uint32_t)limb.tissue_place, n = 0;
    static vec3 x[STACK_POINTS + 3];
    x[n++] = vec3_add_scaled(limb.x[0], far, out);
    for (uint32_t i = 0; i <= last; i++) {
        x[n++] = limb.x[i];
    }
    vec3 tissue = thread_line_at(&limb, limb.tissue_place);
    if (vec3_distance(tissue, x[n - 1]) > 0.0) {
        x[n++] = tissue;
    }
    x[n++] = vec3_add_scaled(tissue, far, limb.away);
    return knot_type_of(x, n, type);
}

static knot_type type_read(const knot_reading *r)
{
    const knot_invariants *v = &r->invariants;
    assert_int_equal(r->reason, VBSS_KNOT_REASON_NONE);
    return (knot_type){v->determinant, v->v2, v->v3};
}

typedef struct limbs {
    uint32_t compared, knotted, unknown;
} limbs;

static void compare_limbs(judge *j, family_case *c, const vec3 out[2], limbs *counts)
{
    judge_saying said;
    knot_detector *inside;
    vbss_knot_input in = judge_input_of(&c->line);
    expect_ok(judge_hear(j, &in, &said));
    expect_ok(vbss_knot_open(j->detector, &inside));
    const knot_reading *read[2] = {&inside->job.tail, &inside->job.long_limb};
    for (int k = 0; k < 2; k++) {
        knot_type wanted, got;
        if (!type_of_limb(&c->line, out[k], k == 0, &wanted) ||
            read[k]->reason != VBSS_KNOT_REASON_NONE) {
            counts->unknown++;
            continue;
        }
        got = type_read(read[k]);
        counts->compared++;
        counts->knotted += wanted.determinant != 1 || wanted.v2 != 0;
        assert_true(knot_type_same(wanted, got));
    }
}

/* Tissue anywhere along the thread, its ray near another point of that. */
static void move_tissue(thread_line *line, vbss_random *random)
{
    uint32_t at = vbss_random_below(random, line->count);
    double aside = 2e-3 * vbss_random_uniform(random);
    vec3 to = vec3_add_scaled(line->x[at], aside, vbss_random_direction(random));
    line->tissue_place = 1.0 + (line->count - 3.0) * vbss_random_uniform(random);
    line->hole_places[0] = line->hole_places[1] = line->tissue_place;
    vec3 tissue = thread_line_at(line, line->tissue_place);
    line->away = vec3_unit_or(vec3_sub(to, tissue), vec3_make(0.0, 0.0, -1.0));
    line->holes[0] = line->holes[1] = tissue;
}

static void limbs_are_read_along_any_ray(void **state)
{
    (void)state;
    static const char *const names[] = {"three throws", "high stacks", "crumpled", "torus knots",
                                        "other knots"};
    static family_case made;
    static derivation d;
    judge j;
    vbss_random random;
    limbs counts = {0, 0, 0};
    judge_begin(&j);
    assert_true(judge_make(&j));
    vbss_random_seed(&random, 1, 17);
    for (size_t f = 0; f < sizeof names / sizeof names[0]; f++) {
        for (uint64_t seed = 0; seed < 12; seed++) {
            assert_true(family_named(names[f])->make(70 + seed, 160, &made));
            assert_true(derive_begin(&d, &made));
            for (int k = 0; k < 16; k++) {
                move_tissue(&made.line, &random);
                compare_limbs(&j, &made, d.out, &counts);
            }
        }
    }
    judge_end(&j);
    print_message("%u limbs compared, %u of them knotted; %u unknown\n", counts.compared,
                  counts.knotted, counts.unknown);
    assert_true(counts.compared >= 1800 && counts.knotted >= 500);
}

/* ---- ends that lie inside */

static bool is_in_tetrahedron(const vec3 corners[4], vec3 p)
{
    bool inside = true;
    for (int i = 0; i < 4; i++) {
        vec3 a = corners[(i + 1) % 4], b = corners[(i + 2) % 4], c = corners[(i + 3) % 4];
        vec3 n = vec3_cross(vec3_sub(b, a), vec3_sub(c, a));
        double height = vec3_dot(n, vec3_sub(corners[i], a)), at = vec3_dot(n, vec3_sub(p, a));
        inside = inside && height * height > 0.0 && at / height > 1e-3;
    }
    return inside;
}

static bool is_inside(const thread_line *line, uint32_t end, vbss_random *random)
{
    bool inside = false;
    for (int k = 0; k < 5000 && !inside; k++) {
        vec3 corners[4];
        for (int i = 0; i < 4; i++) {
            corners[i] = line->x[vbss_random_below(random, line->count)];
        }
        inside = is_in_tetrahedron(corners, line->x[end]);
    }
    return inside;
}

/* The thread closed in the k-th of the detector's directions. */
static bool type_closed(const thread_line *line, const knot_closure *closing, uint32_t k,
                        knot_type *type)
{
    static vec3 x[STACK_POINTS + 2];
    const double far = 2.0;
    uint32_t n = line->count;
    memcpy(x + 1, line->x, n * sizeof *x);
    x[0] = vec3_add_scaled(line->x[0], far, closing->tail_directions[k]);
    x[n + 1] = vec3_add_scaled(line->x[n - 1], far, closing->long_directions[k]);
    return knot_type_of(x, n + 2, type);
}

/* The oracle finds as many closures that agree, and the same knot. */
static void compare_closures(judge *j, const thread_line *line)
{
    knot_detector *inside;
    knot_type first, other;
    expect_ok(vbss_knot_open(j->detector, &inside));
    const knot_job *job = &inside->job;
    assert_true(type_closed(line, &job->closure, 0, &first));
    assert_true(knot_type_same(first, type_read(&job->outward)));
    uint32_t agreeing = 0;
    for (uint32_t k = 1; k <= job->closure.alternative_count; k++) {
        assert_true(type_closed(line, &job->closure, k, &other));
        agreeing += knot_type_same(first, other);
    }
    assert_int_equal(agreeing, job->agreeing);
}

static void ends_inside_knot_are_reported(void **state)
{
    (void)state;
    static family_case made;
    judge j;
    judge_saying said;
    vbss_random random;
    uint32_t inside = 0, doubted = 0;
    judge_begin(&j);
    assert_true(judge_make(&j));
    vbss_random_seed(&random, 2, 17);
    for (uint64_t seed = 0; seed < 60; seed++) {
        if (!family_named("ends inside")->make(seed, 150, &made)) {
            continue;
        }
        vbss_knot_input in = judge_input_of(&made.line);
        expect_ok(judge_hear(&j, &in, &said));
        bool first = is_inside(&made.line, 0, &random);
        if (!first && !is_inside(&made.line, made.line.count - 1, &random)) {
            continue;
        }
        inside++;
        doubted += said.state.reason == VBSS_KNOT_REASON_ENDS;
        compare_closures(&j, &made.line);
        assert_int_equal(said.state.ends_free, 0);
        assert_int_equal(said.state.closures, j.config.closure_count);
        uint32_t differing = said.state.closures - said.state.closures_agreeing;
        assert_int_equal(differing > j.config.closure_tolerance, judge_is_uncertain(&said));
        for (uint32_t i = 0; i < said.state.throw_count && differing > 0; i++) {
            assert_int_not_equal(said.throws[i].verdict, VBSS_KNOT_VERDICT_CERTIFIED);
        }
    }
    judge_end(&j);
    print_message("%u with an end inside, %u of them uncertain\n", inside, doubted);
    assert_true(inside >= 30 && doubted >= 2);
}

int test_detector_limbs(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(limbs_are_read_along_any_ray),
        harness_test(ends_inside_knot_are_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
