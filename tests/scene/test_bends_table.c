/* Each bend gives the same result at every step and mesh, and slips at the same force: docs/explanation/contact.md. */
#include <math.h>

#include "scene/bend_case.h"

enum { FRICTIONS = 2, STEPS = 3, MESHES = 2, SETTINGS = STEPS * MESHES };
static const double steps[STEPS] = {1e-3, 0.5e-3, 0.2e-3}, meshes[MESHES] = {0.3e-3, 0.2e-3};

/* Clear of the critical friction of each bend. */
static const double frictions[FRICTIONS] = {0.2, 0.4};

static void results_and_forces_do_not_depend_on_step(void **state)
{
    (void)state;
    double deepest_of_all = 0.0;
    uint64_t truncated = 0;
    for (int at = 0; at < BEND_KINDS * FRICTIONS; at++) {
        const bend_kind kind = (bend_kind)(at / FRICTIONS);
        const double friction = frictions[at % FRICTIONS];
        double smallest = 1e3, largest = 0.0, deepest = 0.0;
        bend_result result = BEND_PULLED;
        for (int k = 0; k < SETTINGS; k++) {
            const bend_outcome outcome = bend_case_run(kind, friction, steps[k / MESHES],
                                                       meshes[k % MESHES], VBSS_SCENE_MODE_OFFLINE);
            result = k == 0 ? outcome.result : result;
            assert_int_equal(result, outcome.result);
            smallest = fmin(outcome.force, smallest);
            largest = fmax(outcome.force, largest);
            deepest = fmax(outcome.overlap, deepest);
            truncated += outcome.clamped;
        }
        print_message("%s %.2f: %s, %.3f to %.3f N, overlap %.3f D\n", bend_names[kind], friction,
                      result == BEND_HOLDS ? "holds" : "slips", smallest, largest, deepest);
        deepest_of_all = fmax(deepest, deepest_of_all);
        if (result == BEND_SLIPS) { /* within 20 % of their middle */
            assert_true(largest - smallest < 0.4 * 0.5 * (largest + smallest));
        }
    }
    assert_true(deepest_of_all < 0.1);
    assert_int_equal(truncated, 0);
}

static void real_time_results_are_those_of_offline(void **state)
{
    (void)state;
    for (int at = 0; at < BEND_KINDS * FRICTIONS; at++) {
        const bend_kind kind = (bend_kind)(at / FRICTIONS);
        const double friction = frictions[at % FRICTIONS];
        const bend_result wanted =
            bend_case_run(kind, friction, 1e-3, 0.3e-3, VBSS_SCENE_MODE_OFFLINE).result;
        assert_int_equal(
            wanted, bend_case_run(kind, friction, 1e-3, 0.3e-3, VBSS_SCENE_MODE_REAL_TIME).result);
    }
}

int test_bends_table(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(results_and_forces_do_not_depend_on_step),
        cmocka_unit_test(real_time_results_are_those_of_offline),
    };
    return cmocka_run_group_tests_name("scene.bends_table", tests, NULL, NULL);
}
