/* Compliance of host surfaces: vertices give way by compliance times force, and the coupling with a host of masses and
 * springs is stable where the closed solution says so. */
#include <stdlib.h>

#include "scene/ball_rig.h"

/* ---- statics */

static void vertices_are_deflected_by_compliance_times_force(void **state)
{
    (void)state;
    ball_rig r;
    const double compliance = 5e-3, mass = 5e-3;
    ball_begin(&r, 1, mass);
    ball_set_compliance(&r, compliance);
    small_steps(&r.s, 400, BALL_STEP);
    expect_near(-mass * GRAVITY, ball_force(&r), 1e-6 * mass * GRAVITY);
    const vec3 *f = ball_view(&r, VBSS_SCENE_SURFACE_VIEW_FORCES);
    const vec3 *now = ball_view(&r, VBSS_SCENE_SURFACE_VIEW_POSITIONS);
    const vec3 *targets = ball_view(&r, VBSS_SCENE_SURFACE_VIEW_TARGETS);
    for (int i = 0; i < 3; i++) {
        const vec3 deflection = vec3_sub(now[i], targets[i]);
        expect_near(0.0, vec3_distance(deflection, vec3_scale(f[i], compliance)),
                    1e-9 * vec3_norm(deflection));
        expect_near(-compliance * mass * GRAVITY / 3.0, deflection.y, 1e-3 * 80e-6);
    }
    small_end(&r.s);
}

/* A vertical force moves each vertex aside, too. */
static void matrix_of_compliance_couples_directions(void **state)
{
    (void)state;
    ball_rig r;
    const double mass = 5e-3;
    const double one[9] = {4e-3, 1e-3, 0.0, 1e-3, 5e-3, -2e-3, 0.0, -2e-3, 6e-3};
    double all[3][9];
    ball_begin(&r, 9, mass);
    for (int i = 0; i < 3; i++) {
        memcpy(all[i], one, sizeof one);
    }
    expect_ok(vbss_scene_set_surface_compliance(r.s.scene, r.surface, all[0], 27));
    small_steps(&r.s, 400, BALL_STEP);
    for (int i = 0; i < 3; i++) {
        const vec3 deflection = vec3_sub(ball_view(&r, VBSS_SCENE_SURFACE_VIEW_POSITIONS)[i],
                                         ball_view(&r, VBSS_SCENE_SURFACE_VIEW_TARGETS)[i]);
        const vec3 f = ball_view(&r, VBSS_SCENE_SURFACE_VIEW_FORCES)[i];
        const vec3 expected = vec3_make(one[0] * f.x + one[1] * f.y + one[2] * f.z,
                                        one[3] * f.x + one[4] * f.y + one[5] * f.z,
                                        one[6] * f.x + one[7] * f.y + one[8] * f.z);
        expect_near(0.0, vec3_distance(deflection, expected), 1e-9 * vec3_norm(expected));
        assert_true(fabs(deflection.x) > 1e-6 && fabs(deflection.z) > 1e-6);
    }
    small_end(&r.s);
}

/* The tool goes 1 mm below the plane; a vertex has a third of its force. */
static void driven_tool_presses_on_a_compliant_surface(void **state)
{
    (void)state;
    ball_rig r;
    const double compliance = 10e-3;
    ball_begin(&r, 1, 1e-3);
    ball_set_compliance(&r, compliance);
    expect_ok(vbss_scene_remove(r.s.scene, r.ball));
    const double start = -(BALL_RADIUS + 0.25e-3);
    const uint32_t tool =
        small_stick(&r.s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, start - 0.1e-3, 0.0), vec3_zero(),
                    BALL_RADIUS);
    for (int i = 1; i <= 40; i++) {
        small_move(&r.s, tool, vec3_make(0.0, start + 25e-6 * i, 0.0));
        small_steps(&r.s, 1, BALL_STEP);
    }
    assert_int_equal(small_statistics(&r.s).clamped, 0);
    expect_near(1e-3 / (compliance / 3.0), ball_force(&r),
                0.003 * 0.3); /* the contact gives way, too */
    expect_near(-ball_force(&r), small_rigid(&r.s, tool).contact_force[1], 1e-9);
    small_end(&r.s);
}

/* ---- stability */

/* A host of three masses, each on a spring to where it was, that carry the weight of the ball. */
typedef struct host {
    double mass, stiffness, load; /* of each vertex; load: a constant force upward, N */
    double y, v;                  /* all vertices move alike */
} host;

/* The host predicts, the scene steps, the host applies the force. */
static void step_host(ball_rig *r, host *own)
{
    own->v += BALL_STEP * (own->load - own->stiffness * own->y) / own->mass;
    const double free_y = own->y + BALL_STEP * own->v;
    for (int i = 0; i < 3; i++) {
        r->x[i][1] = free_y;
    }
    expect_ok(vbss_scene_move_surface(r->s.scene, r->surface, r->x[0], 3));
    small_steps(&r->s, 1, BALL_STEP);
    own->v += BALL_STEP * (ball_force(r) / 3.0) / own->mass;
    own->y = free_y + BALL_STEP * BALL_STEP * (ball_force(r) / 3.0) / own->mass;
}

/* How much the deviation of the contact force from the weight grows in a step. `stated`: compliance that the host
 * states, relative to that of its masses; mass_ratio: of the ball to all vertices. */
static double growth(double stated, double mass_ratio)
{
    ball_rig r;
    const double ball = 1e-3;
    host own = {.mass = ball / (3.0 * mass_ratio), .load = ball * GRAVITY / 3.0};
    /* In balance: the vertices go up without contact, and the ball rests above where they end. */
    ball_begin(&r, 1, ball);
    expect_ok(vbss_scene_remove(r.s.scene, r.ball));
    const double rise = (1.0 - stated) * BALL_STEP * BALL_STEP * own.load / own.mass,
                 sag = ball * GRAVITY / r.s.config.contact_stiffness;
    ball_add(&r, rise - sag);
    ball_set_compliance(&r, stated * BALL_STEP * BALL_STEP / own.mass);
    double first = 0.0, last = 0.0;
    own.v = 1e-7;
    for (int i = 0; i < 30; i++) {
        step_host(&r, &own);
        const double deviation = fabs(ball_force(&r) + ball * GRAVITY);
        first = i == 9 ? deviation : first;
        last = i == 19 ? deviation : last;
    }
    small_end(&r.s);
    return pow(last / first, 0.1);
}

static void weak_coupling_is_stable_where_the_closed_solution_is(void **state)
{
    (void)state;
    const double cases[][2] = {{0.0, 0.2}, {0.0, 0.3}, {0.0, 0.4}, {0.5, 0.8},
                               {0.5, 1.3}, {0.7, 3.0}, {0.7, 7.0}, {0.8, 30.0}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const double expected = ball_closed_growth(cases[i][0], cases[i][1]);
        const double got = growth(cases[i][0], cases[i][1]);
        assert_true((got < 1.0) == (expected < 1.0));
        expect_near(expected, got, 0.03 * expected);
    }
}

/* A ball that weighs a hundred times as much as the surface falls on it, soft and stiff; the stiff springs are just below
 * the limit of the host's own explicit steps. No energy appears, and the vertices end where the scene said. */
static void stated_compliance_keeps_a_light_surface_stable(void **state)
{
    (void)state;
    const double ratios[] = {1e-3, 0.5, 3.6}; /* h^2 k / m */
    for (int k = 0; k < 3; k++) {
        ball_rig r;
        const double ball = 3e-3;
        host own = {.mass = ball / 300.0};
        own.stiffness = ratios[k] * own.mass / (BALL_STEP * BALL_STEP);
        ball_begin(&r, 1, ball);
        ball_set_compliance(&r, BALL_STEP * BALL_STEP / own.mass);
        double top = 0.0, lowest = 0.0;
        for (int i = 0; i < 1000; i++) {
            step_host(&r, &own);
            expect_near(own.y, ball_height(&r), 1e-9);
            const double y = small_position(&r.s, r.ball).y - BALL_RADIUS - 0.25e-3;
            top = fmax(top, y);
            lowest = fmin(lowest, y);
        }
        assert_true(top < 5e-6);
        const double sag = ball * GRAVITY / (3.0 * own.stiffness);
        assert_true(lowest > -2.01 * sag - 2e-6 && lowest < -0.99 * fmin(sag, 1e-3));
        small_end(&r.s);
    }
}

/* ---- input and state */

static void refused_compliances_change_nothing(void **state)
{
    (void)state;
    ball_rig r;
    double good[3][9] = {{0.0}};
    ball_begin(&r, 9, 1e-3);
    for (int i = 0; i < 3; i++) {
        good[i][0] = good[i][4] = good[i][8] = 2e-3;
    }
    expect_ok(vbss_scene_set_surface_compliance(r.s.scene, r.surface, good[0], 27));
    const uint64_t hash = small_hash(&r.s);
    const struct {
        int number;
        double value;
    } bad[] = {{0, -1e-3}, {1, 1e-3}, {4, 0.0}, {8, 1e-10}, {0, 2e6}};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        double c[3][9];
        memcpy(c, good, sizeof c);
        c[1][bad[i].number] = bad[i].value;
        expect_result(VBSS_ERROR_OUT_OF_RANGE,
                      vbss_scene_set_surface_compliance(r.s.scene, r.surface, c[0], 27));
    }
    good[2][8] = (double)NAN;
    expect_result(VBSS_ERROR_NOT_FINITE,
                  vbss_scene_set_surface_compliance(r.s.scene, r.surface, good[0], 27));
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_scene_set_surface_compliance(r.s.scene, r.surface, good[0], 3));
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_scene_set_surface_compliance(r.s.scene, r.surface, NULL, 27));
    expect_result(VBSS_ERROR_INCOMPATIBLE,
                  vbss_scene_set_surface_compliance(r.s.scene, r.ball, good[0], 27));
    assert_true(small_hash(&r.s) == hash);
    small_end(&r.s);
    ball_begin(&r, 0, 1e-3);
    expect_result(VBSS_ERROR_INCOMPATIBLE,
                  vbss_scene_set_surface_compliance(r.s.scene, r.surface, good[0], 3));
    small_end(&r.s);
}

static void saved_compliance_goes_on_to_the_same_bits(void **state)
{
    (void)state;
    ball_rig r;
    harness_memory memory;
    vbss_scene *loaded = NULL;
    ball_begin(&r, 1, 5e-3);
    ball_set_compliance(&r, 5e-3);
    small_steps(&r.s, 20, BALL_STEP);
    const small_state saved = small_save(&r.s);
    vbss_context *context = harness_context(&memory);
    expect_ok(vbss_scene_load(context, saved.bytes, saved.count, &loaded));
    for (int i = 0; i < 30; i++) {
        uint64_t hash = 0;
        expect_ok(vbss_scene_get_hash(loaded, &hash));
        assert_true(hash == small_hash(&r.s));
        expect_ok(vbss_scene_step(loaded, BALL_STEP));
        small_steps(&r.s, 1, BALL_STEP);
    }
    free(saved.bytes);
    expect_ok(vbss_scene_destroy(loaded));
    harness_context_end(context, &memory);
    small_end(&r.s);
}

int test_host_surface_compliance(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(vertices_are_deflected_by_compliance_times_force),
        harness_test(matrix_of_compliance_couples_directions),
        harness_test(driven_tool_presses_on_a_compliant_surface),
        harness_test(weak_coupling_is_stable_where_the_closed_solution_is),
        harness_test(stated_compliance_keeps_a_light_surface_stable),
        harness_test(refused_compliances_change_nothing),
        harness_test(saved_compliance_goes_on_to_the_same_bits),
    };
    return cmocka_run_group_tests_name("scene.host_surface_compliance", tests, NULL, NULL);
}
