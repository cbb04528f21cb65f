/* Each bend gives the same verdict at every step and mesh, and slips at the same force: docs/contact.md, "Bends". */
#include <math.h>

#include "scene/bend_case.h"

enum { FRICTIONS = 4, STEPS = 3, MESHES = 2, SETTINGS = STEPS * MESHES };
static const double steps[STEPS] = {1e-3, 0.5e-3, 0.2e-3}, meshes[MESHES] = {0.3e-3, 0.2e-3};

/* Clear of the critical friction of each bend by at least 0.03. */
static const double frictions[BEND_KINDS][FRICTIONS] = {
    {0.2, 0.35, 0.4, 0.5}, {0.2, 0.35, 0.4, 0.5}, {0.2, 0.3, 0.4, 0.5}, {0.2, 0.3, 0.4, 0.5}};

static void verdicts_and_forces_do_not_depend_on_step(void **state)
{
    (void)state;
    for (int at = 0; at < BEND_KINDS * FRICTIONS; at++) {
        const bend_kind kind = (bend_kind)(at / FRICTIONS);
        const double friction = frictions[kind][at % FRICTIONS];
        double smallest = 1e3, largest = 0.0, deepest = 0.0;
        bend_verdict verdict = BEND_PULLED;
        for (int k = 0; k < SETTINGS; k++) {
            const bend_outcome outcome = bend_case_run(kind, friction, steps[k / MESHES],
                                                       meshes[k % MESHES], VBSS_SCENE_MODE_OFFLINE);
            verdict = k == 0 ? outcome.verdict : verdict;
            assert_int_equal(verdict, outcome.verdict);
            smallest = fmin(outcome.force, smallest);
            largest = fmax(outcome.force, largest);
            deepest = fmax(outcome.overlap, deepest);
        }
        print_message("%s %.2f: %s, %.3f to %.3f N, overlap %.3f D\n", bend_names[kind], friction,
                      verdict == BEND_HOLDS ? "holds" : "slips", smallest, largest, deepest);
        assert_true(deepest < 0.1);
        if (verdict == BEND_SLIPS) { /* within 20 % of their middle */
            assert_true(largest - smallest < 0.4 * 0.5 * (largest + smallest));
        }
    }
}

static void real_time_verdicts_are_those_of_offline(void **state)
{
    (void)state;
    for (int at = 0; at < BEND_KINDS * FRICTIONS; at++) {
        const bend_kind kind = (bend_kind)(at / FRICTIONS);
        const double friction = frictions[kind][at % FRICTIONS];
        const bend_verdict wanted =
            bend_case_run(kind, friction, 1e-3, 0.3e-3, VBSS_SCENE_MODE_OFFLINE).verdict;
        assert_int_equal(
            wanted, bend_case_run(kind, friction, 1e-3, 0.3e-3, VBSS_SCENE_MODE_REAL_TIME).verdict);
    }
}

int test_bends_table(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(verdicts_and_forces_do_not_depend_on_step),
        cmocka_unit_test(real_time_verdicts_are_those_of_offline),
    };
    return cmocka_run_group_tests_name("scene.bends_table", tests, NULL, NULL);
}
