/* A thread that cuts through the wall at its hole: when, how far, at what cost of energy, and that it comes out at an
 * edge. */
#include <stdlib.h>

#include <vblast_ss/scene_surface.h>

#include "scene/tear_rig.h"

#define SLOW 10e-3                                 /* m/s */
#define CONTACT (0.5 * TEAR_THICK + THREAD_RADIUS) /* m */
#define THREAD_RADIUS 0.125e-3

static const vec3 still = {0.0, 0.0, 0.0};

static vec3 along_x(double speed)
{
    return vec3_make(speed, 0.0, 0.0);
}

static vbss_scene_hole hole_of(const tear_rig *r)
{
    vbss_scene_hole hole;
    assert_true(tear_rig_hole(r, &hole));
    return hole;
}

static void steps(tear_rig *r, uint32_t count, vec3 velocity)
{
    for (uint32_t i = 0; i < count; i++) {
        tear_rig_step(r, velocity);
    }
}

/* ---- the criterion */

static void hole_moves_only_at_energy_times_thickness(void **state)
{
    (void)state;
    tear_rig r;
    tear_rig_begin(&r, false);
    tear_rig_create(&r, 6, 6);
    double before = 0.0;
    for (int i = 0; i < 300; i++) {
        tear_rig_step(&r, along_x(SLOW));
        const vbss_scene_hole hole = hole_of(&r);
        const double force = tear_rig_force(&hole);
        if (hole.torn_length > before) {
            assert_true(force > TEAR_FORCE - 1e-6 && force < 1.001 * TEAR_FORCE);
        } else {
            assert_true(force < TEAR_FORCE + 1e-6);
        }
        before = hole.torn_length;
    }
    assert_true(before > 1.5e-3 && before < 1.7e-3);
    tear_rig_end(&r);
}

static void hole_holds_just_below(void **state)
{
    (void)state;
    tear_rig r;
    tear_rig_begin(&r, false);
    tear_rig_create(&r, 6, 6);
    vbss_scene_hole hole = hole_of(&r);
    for (uint32_t i = 0; i < 2000 && tear_rig_force(&hole) < 0.98 * TEAR_FORCE; i++) {
        tear_rig_step(&r, along_x(1e-3));
        hole = hole_of(&r);
    }
    steps(&r, 500, still);
    hole = hole_of(&r);
    assert_true(tear_rig_force(&hole) > 0.97 * TEAR_FORCE);
    assert_true(hole.torn_length == 0.0 && hole.tear_work == 0.0);
    tear_rig_end(&r);
}

/* With the damper c in series a hole that tears at v has the force G t + c v, whatever the step. */
static void fast_tear_has_the_force_of_its_damper(void **state)
{
    (void)state;
    tear_rig r;
    tear_rig_begin(&r, true);
    tear_rig_create(&r, 8, 6);
    steps(&r, 8, along_x(1.0));
    const vbss_scene_hole hole = hole_of(&r);
    assert_true(hole.torn_length > 5e-3);
    expect_near(TEAR_FORCE + r.s.drain.hole_damping * 1.0, tear_rig_force(&hole), 2e-3);
    tear_rig_end(&r);
}

static void thickness_of_a_triangle_counts(void **state)
{
    (void)state;
    tear_rig r;
    static double thickness[PAD_TRIANGLES];
    tear_rig_begin(&r, false);
    for (uint32_t i = 0; i < PAD_TRIANGLES; i++) {
        thickness[i] = 2.0 * TEAR_THICK;
    }
    vbss_drain_surface surface = *r.s.drain.surface;
    surface.thickness = thickness;
    r.s.drain.surface = &surface;
    tear_rig_create(&r, 6, 6);
    steps(&r, 300, along_x(SLOW));
    const vbss_scene_hole hole = hole_of(&r);
    assert_true(hole.torn_length > 0.5e-3);
    expect_near(2.0 * TEAR_FORCE, tear_rig_force(&hole), 2e-3);
    tear_rig_end(&r);
}

/* ---- energy */

/* While the tear is steady nothing but the cut takes energy, and the damper c v^2 of it: 0.05 %. */
static void work_of_the_hands_is_that_of_the_cut(void **state)
{
    (void)state;
    tear_rig r;
    tear_rig_begin(&r, false);
    tear_rig_create(&r, 6, 6);
    steps(&r, 200, along_x(SLOW));
    const vbss_scene_hole start = hole_of(&r);
    const double hands = r.work;
    steps(&r, 600, along_x(SLOW));
    const vbss_scene_hole end = hole_of(&r);
    const double work = end.tear_work - start.tear_work,
                 cut = TEAR_FORCE * (end.torn_length - start.torn_length);
    assert_true(cut > 5e-3 * TEAR_FORCE);
    assert_true(work >= cut && work < 1.001 * cut);
    expect_near(r.work - hands, work, 0.005 * work);
    const vbss_scene_statistics statistics = small_statistics(&r.s);
    assert_true(statistics.torn_length == end.torn_length);
    assert_true(statistics.tear_work == end.tear_work);
    tear_rig_end(&r);
}

/* ---- edges */

/* Draws the thread until it has come out, and 100 steps more. No crossing of the sheet is farther from the hole than
 * contact is without effect, and none is left at the end. Returns the torn length. */
static double tear_out(tear_rig *r, uint32_t limit, vec3 velocity)
{
    uint32_t events = 0, left = limit;
    double torn = 0.0;
    vbss_scene_hole hole;
    for (bool is_in = true; is_in && left > 0; left--) {
        vbss_scene_event event;
        tear_rig_step(r, velocity);
        is_in = tear_rig_hole(r, &hole);
        if (is_in) {
            const vec3 at = vec3_load(hole.position);
            assert_int_equal(0, tear_rig_crossings(r, at, 1.5 * CONTACT));
        }
        if (small_events(&r->s, VBSS_SCENE_EVENT_TORN_OUT, &event) > 0) {
            events++;
            torn = event.value;
            assert_int_equal(r->suture, event.body_a);
            assert_int_equal(r->sheet, event.body_b);
        }
    }
    assert_true(left > 0);
    assert_int_equal(1, events);
    assert_int_equal(0, tear_rig_crossings(r, vec3_zero(), 0.0));
    for (int i = 0; i < 100; i++) {
        tear_rig_step(r, velocity);
        assert_int_equal(0, tear_rig_crossings(r, vec3_zero(), 0.0));
    }
    const vbss_scene_statistics statistics = small_statistics(&r->s);
    assert_true(statistics.paused == 0 && statistics.torn_length == torn);
    return torn;
}

static void thread_comes_out_at_the_edge_of_a_sheet(void **state)
{
    (void)state;
    tear_rig r;
    tear_rig_begin(&r, true);
    tear_rig_create(&r, 10, 6);
    const vbss_scene_hole hole = hole_of(&r);
    const double torn = tear_out(&r, 800, along_x(SLOW));
    expect_near(0.5 * TEAR_SIDE - hole.position[0], torn, 0.05e-3);
    assert_true(small_tension(r.thread, 0) < 0.1);
    tear_rig_end(&r);
}

static void fast_pull_is_stable(void **state)
{
    (void)state;
    static const double speeds[] = {0.3, 1.0, 5.0};
    for (int i = 0; i < 3; i++) {
        tear_rig r;
        tear_rig_begin(&r, true);
        tear_rig_create(&r, 8, 6);
        const double torn = tear_out(&r, 200, along_x(speeds[i]));
        expect_near(9e-3, torn, 0.05e-3);
        tear_rig_end(&r);
    }
}

/* A thread that leaves a soft sheet presses on nothing when contact begins again. */
static void thread_comes_out_of_a_weak_sheet_without_a_paused_step(void **state)
{
    (void)state;
    tear_rig r;
    tear_rig_begin(&r, true);
    r.s.drain.tear_energy = 50.0;
    tear_rig_create(&r, 8, 6);
    expect_near(9e-3, tear_out(&r, 400, along_x(50e-3)), 0.05e-3);
    tear_rig_end(&r);
}

static void thread_comes_out_at_the_slit(void **state)
{
    (void)state;
    tear_rig r;
    vec3 direction;
    tear_rig_begin(&r, false);
    r.s.drain.tear_energy = 100.0;
    tear_rig_create_drain(&r, &direction);
    const double torn = tear_out(&r, 1500, vec3_scale(direction, SLOW));
    assert_true(torn > 1e-3 && torn < 6e-3);
    tear_rig_end(&r);
}

static void anchored_triangles_stop_a_tear(void **state)
{
    (void)state;
    tear_rig r;
    tear_rig_begin(&r, true);
    tear_rig_create(&r, 3, 6);
    const vbss_scene_hole start = hole_of(&r);
    steps(&r, 700, along_x(-SLOW));
    const vbss_scene_hole hole = hole_of(&r);
    expect_near(start.position[0] + 10e-3, hole.torn_length, 0.05e-3);
    assert_true(tear_rig_force(&hole) > 2.0 * TEAR_FORCE);
    tear_rig_end(&r);
}

/* ---- events */

static void each_tear_is_reported_once(void **state)
{
    (void)state;
    tear_rig r;
    tear_rig_begin(&r, false);
    tear_rig_create(&r, 6, 6);
    uint32_t begun[3] = {0, 0, 0};
    vbss_scene_event event = {0};
    for (int phase = 0; phase < 3; phase++) { /* there, back, there */
        for (int i = 0; i < 200; i++) {
            tear_rig_step(&r, along_x(phase == 1 ? -SLOW : SLOW));
            begun[phase] += small_events(&r.s, VBSS_SCENE_EVENT_TEARING, &event);
        }
    }
    assert_int_equal(1, begun[0]);
    assert_int_equal(0, begun[1]);
    assert_int_equal(1, begun[2]);
    assert_int_equal(r.suture, event.body_a);
    assert_int_equal(r.sheet, event.body_b);
    assert_int_equal(hole_of(&r).id, event.id);
    expect_near(TEAR_FORCE, event.value, 1e-3);
    tear_rig_end(&r);
}

/* ---- off */

/* A tear energy that is never reached leaves every bit as it is without one, which is the default. */
static void without_tears_the_bits_are_the_same(void **state)
{
    (void)state;
    tear_rig r[2];
    assert_true(vbss_drain_config_default().tear_energy == 0.0);
    assert_true(vbss_scene_surface_config_default().tear_energy == 0.0);
    for (int k = 0; k < 2; k++) {
        tear_rig_begin(&r[k], false);
        r[k].s.drain.tear_energy = k == 0 ? 0.0 : 1e7;
        tear_rig_create(&r[k], 6, 6);
        steps(&r[k], 200, along_x(SLOW));
    }
    for (uint32_t i = 0; i <= TEAR_SEGMENTS; i++) {
        const vec3 a = small_node(r[0].thread, i), b = small_node(r[1].thread, i);
        assert_memory_equal(&a, &b, sizeof a);
    }
    assert_true(hole_of(&r[0]).torn_length == 0.0);
    for (int k = 2; k-- > 0;) {
        tear_rig_end(&r[k]);
    }
}

static void host_surfaces_tear_alike(void **state)
{
    (void)state;
    tear_rig r;
    tear_rig_begin(&r, true);
    r.is_of_host = true;
    tear_rig_create(&r, 10, 6);
    steps(&r, 200, along_x(SLOW));
    const vbss_scene_hole hole = hole_of(&r);
    expect_near(TEAR_FORCE, tear_rig_force(&hole), 1e-3);
    const double torn = tear_out(&r, 800, along_x(SLOW));
    expect_near(4e-3, torn, 0.01e-3);
    tear_rig_end(&r);
}

/* ---- state */

/* Continues from a saved state in the middle of a tear, in the same scene and in another one. */
static void saved_tear_goes_on_to_the_bit(void **state)
{
    (void)state;
    for (int host = 0; host < 2; host++) {
        tear_rig r, twin;
        tear_rig_begin(&r, true);
        r.is_of_host = host != 0;
        tear_rig_create(&r, 8, 6);
        steps(&r, 300, along_x(SLOW));
        const small_state saved = small_save(&r.s);
        const vec3 hands[2] = {r.hand_positions[0], r.hand_positions[1]};
        steps(&r, 300, along_x(SLOW));
        const uint64_t hash = small_hash(&r.s);
        const vbss_scene_hole after = hole_of(&r);
        tear_rig_begin(&twin, true);
        twin.is_of_host = host != 0;
        tear_rig_create(&twin, 8, 6);
        for (int k = 0; k < 2; k++) {
            tear_rig *other = k == 0 ? &r : &twin;
            expect_ok(vbss_scene_restore(other->s.scene, saved.bytes, saved.count));
            memcpy(other->hand_positions, hands, sizeof hands);
            assert_true(hole_of(other).torn_length > 0.0);
            steps(other, 300, along_x(SLOW));
            assert_true(small_hash(&other->s) == hash);
            assert_true(hole_of(other).torn_length == after.torn_length);
            assert_true(hole_of(other).tear_work == after.tear_work);
            assert_true(small_statistics(&other->s).tear_work == after.tear_work);
        }
        free(saved.bytes);
        tear_rig_end(&twin);
        tear_rig_end(&r);
    }
}

/* The tear energy belongs to the scene, not to its state. */
static void state_of_another_tear_energy_is_refused(void **state)
{
    (void)state;
    static const double energies[2][2] = {{TEAR_ENERGY, 0.0}, {0.0, TEAR_ENERGY}};
    for (int host = 0; host < 2; host++) {
        for (int i = 0; i < 2; i++) {
            tear_rig r[2];
            for (int k = 0; k < 2; k++) {
                tear_rig_begin(&r[k], false);
                r[k].is_of_host = host != 0;
                r[k].s.drain.tear_energy = energies[i][k];
                tear_rig_create(&r[k], 6, 6);
            }
            const small_state saved = small_save(&r[0].s);
            assert_int_equal(VBSS_ERROR_CORRUPT,
                             vbss_scene_restore(r[1].s.scene, saved.bytes, saved.count));
            free(saved.bytes);
            tear_rig_end(&r[1]);
            tear_rig_end(&r[0]);
        }
    }
}

static void other_tear_energies_are_refused(void **state)
{
    (void)state;
    static const double wrong[] = {-1.0, 0.5, 2e7};
    small s;
    small_begin(&s);
    for (int i = 0; i < 3; i++) {
        vbss_drain *drain = NULL;
        s.drain.tear_energy = wrong[i];
        assert_int_equal(VBSS_ERROR_OUT_OF_RANGE, vbss_drain_create(s.context, &s.drain, &drain));
    }
    small_end(&s);
}

int test_tearing(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(hole_moves_only_at_energy_times_thickness),
        harness_test(hole_holds_just_below),
        harness_test(fast_tear_has_the_force_of_its_damper),
        harness_test(thickness_of_a_triangle_counts),
        harness_test(work_of_the_hands_is_that_of_the_cut),
        harness_test(thread_comes_out_at_the_edge_of_a_sheet),
        harness_test(fast_pull_is_stable),
        harness_test(thread_comes_out_of_a_weak_sheet_without_a_paused_step),
        harness_test(thread_comes_out_at_the_slit),
        harness_test(anchored_triangles_stop_a_tear),
        harness_test(each_tear_is_reported_once),
        harness_test(without_tears_the_bits_are_the_same),
        harness_test(host_surfaces_tear_alike),
        harness_test(saved_tear_goes_on_to_the_bit),
        harness_test(state_of_another_tear_energy_is_refused),
        harness_test(other_tear_energies_are_refused),
    };
    return cmocka_run_group_tests_name("scene.tearing", tests, NULL, NULL);
}
