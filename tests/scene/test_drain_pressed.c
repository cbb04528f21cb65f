/* A drain is pinched flat, poked inside out, stirred: what it touches goes nowhere that it should not, and what lets go
 * of it leaves it as it was. */
#include "scene/drain_case.h"

static drain_case c;

/* Middle surface 6.5 mm from the axis, wall 1 mm. */
#define TOP 7.0e-3

static void begin(void)
{
    drain_case_begin(&c);
    drain_case_make(&c);
}

/* A rod across, down to where the top lies on the bottom. */
static void transverse_rod_pinches_drain_flat_and_leaves(void **state)
{
    (void)state;
    begin();
    uint32_t rod = drain_case_tool(&c, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.0, TOP + 3e-3, 0.0),
                                   vec3_make(0.0, 0.0, 20e-3), 1.5e-3);
    drain_case_move_to(&c, rod, vec3_make(0.0, -5e-3, 0.0), 400);
    drain_case_wait(&c, 300);
    drain_case_report(&c, "flat");
    drain_case_move_to(&c, rod, vec3_make(0.0, TOP + 5e-3, 0.0), 300);
    drain_case_wait(&c, 500);
    drain_case_expect_rest(&c, 0.1e-3);
    drain_case_finish(&c, "pinched across", 0.05);
}

/* A rod along it, as wide as the slit: the top stays folded down on the bottom when the rod has gone, as a tube that is
 * stiffer against being bent back than against being folded; the lips lie on each other. */
static void axial_rod_leaves_fold(void **state)
{
    (void)state;
    begin();
    uint32_t rod = drain_case_tool(&c, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.0, TOP + 4e-3, 0.0),
                                   vec3_make(20e-3, 0.0, 0.0), 2.5e-3);
    drain_case_move_to(&c, rod, vec3_make(0.0, -3e-3, 0.0), 400);
    drain_case_wait(&c, 300);
    drain_case_report(&c, "flat");
    drain_case_move_to(&c, rod, vec3_make(0.0, TOP + 5e-3, 0.0), 300);
    drain_case_wait(&c, 1000);
    drain_case_report(&c, "pinched along");
    /* Lips that tilt are pressed into each other for a moment, which the ledger takes for energy. */
    small_watch_expect_nothing(&c.watch);
    assert_true(drain_case_energies(&c).total < c.max_work);
    assert_true(drain_case_fastest(&c) < 1e-3);
    drain_case_end(&c);
}

/* Beside the slit the wall dents until its dome is turned in. */
static void tip_pokes_wall_inside_out(void **state)
{
    (void)state;
    begin();
    uint32_t tip =
        drain_case_tool(&c, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.3e-3, TOP + 10e-3, 4e-3),
                        vec3_make(0.0, 8e-3, 0.0), 1.0e-3);
    drain_case_move_to(&c, tip, vec3_make(0.3e-3, TOP - 3e-3, 4e-3), 400);
    drain_case_wait(&c, 300);
    drain_case_report(&c, "in");
    drain_case_move_to(&c, tip, vec3_make(0.3e-3, TOP + 12e-3, 4e-3), 300);
    drain_case_wait(&c, 500);
    drain_case_expect_rest(&c, 0.1e-3);
    drain_case_finish(&c, "poked", 0.05);
}

int test_drain_pressed(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(transverse_rod_pinches_drain_flat_and_leaves),
        cmocka_unit_test(axial_rod_leaves_fold),
        cmocka_unit_test(tip_pokes_wall_inside_out),
    };
    return cmocka_run_group_tests_name("drain pressed", tests, NULL, NULL);
}
