/* Method PROJECTION counts what it counts in the eight cases in which it was first seen to fail, and what
 * there is to count is worked out here. */
#include "base/elementary.h"
#include "knot/paper_rig.h"
#include "fixtures/paper_knot_cases.h"

static void show(paper_rig *rig, paper_knot_kind kind)
{
    rig->scene.point_count = paper_knot_make(kind, rig->points);
    vbss_knot_tool tool = paper_knot_tool();
    rig->tools[0].axis[0] = vec3_load(tool.axis[0]);
    rig->tools[0].axis[1] = vec3_load(tool.axis[1]);
}

static double swept_turns(const paper_rig *rig)
{
    double angle = 0.0;
    for (uint32_t k = 0; k + 1 < rig->scene.point_count; k++) {
        vec3 a = rig->points[k], b = rig->points[k + 1];
        angle += vbss_atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
    }
    return angle / 6.283185307179586;
}

static void cases_match_paper_counts(void **state)
{
    (void)state;
    paper_rig rig;
    paper_rig_begin(&rig);
    for (paper_knot_kind kind = 0; kind < PAPER_KNOT_KINDS; kind++) {
        const paper_knot_case *c = &paper_knot_cases[kind];
        show(&rig, kind);
        for (uint64_t seed = 1; seed <= 100; seed++) {
            uint32_t loops = paper_rig_loops(&rig, seed), inside = paper_rig_inside(&rig);
            if (inside != c->loops || loops - inside != c->rejected) {
                fail_msg("%s: %u inside, %u rejected", c->name, inside, loops - inside);
            }
        }
    }
    paper_rig_end(&rig);
}

static void paper_counts_differ_from_truth(void **state)
{
    (void)state;
    paper_rig rig;
    paper_rig_begin(&rig);
    uint32_t right = 0;
    for (paper_knot_kind kind = 0; kind < PAPER_KNOT_KINDS; kind++) {
        const paper_knot_case *c = &paper_knot_cases[kind];
        show(&rig, kind);
        double turns = swept_turns(&rig), highest = -1.0, lowest = 1.0;
        expect_near(c->turns, turns, 0.005);
        for (uint32_t k = 0; k < rig.scene.point_count; k++) {
            highest = vbss_max(highest, rig.points[k].z);
            lowest = vbss_min(lowest, rig.points[k].z);
        }
        assert_true(c->beside_tool ? lowest > 0.0 : highest < 0.0);
        /* Whole turns about the tool that there is. */
        double wraps = c->beside_tool ? floor(fabs(turns) + 0.5) : 0.0;
        right += wraps == c->loops ? 1 : 0;
    }
    assert_int_equal(2, right); /* A, and of E the number though not the pair */
    paper_rig_end(&rig);
}

/* E: of three crossings of the end with the standing part the outermost is taken for the pair; the one next to
 * the tool, on which the throw depends, has above and below the other way round. */
static void curled_long_limb_pairs_wrongly(void **state)
{
    (void)state;
    paper_rig rig;
    paper_rig_begin(&rig);
    show(&rig, PAPER_KNOT_E);
    assert_int_equal(1, paper_rig_loops(&rig, 1));
    baseline_loop found = rig.paper.loops[0];
    assert_false(found.first_is_above);
    /* Without what is farther out than 10 mm there is one crossing left. */
    uint32_t n = 0;
    for (uint32_t k = 0; k < rig.scene.point_count; k++) {
        vec3 x = rig.points[k];
        if (x.x * x.x + x.y * x.y < 1e-4) {
            rig.points[n++] = x;
        }
    }
    rig.scene.point_count = n;
    assert_int_equal(1, paper_rig_loops(&rig, 1));
    assert_true(rig.paper.loops[0].first_is_above);
    paper_rig_end(&rig);
}

/* C: turns that coincide in the projection cross by the last bit, or by where points happen to lie. */
static void exact_helix_closes_by_accident(void **state)
{
    (void)state;
    paper_rig rig;
    paper_rig_begin(&rig);
    for (paper_knot_kind kind = PAPER_KNOT_C; kind <= PAPER_KNOT_C2; kind++) {
        show(&rig, kind);
        paper_rig_loops(&rig, 1);
        baseline_loop first = rig.paper.loops[0], spurious = rig.paper.loops[1];
        assert_int_equal(1, first.inside);
        assert_int_equal(0, spurious.inside);
        /* At the very first segment, where nothing crosses but the turns lie on each other. */
        assert_int_equal(rig.scene.point_count - 3, first.last);
        assert_true(spurious.last < first.first);
    }
    paper_rig_end(&rig);
}

int test_paper_cases(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cases_match_paper_counts),
        cmocka_unit_test(paper_counts_differ_from_truth),
        cmocka_unit_test(curled_long_limb_pairs_wrongly),
        cmocka_unit_test(exact_helix_closes_by_accident),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
