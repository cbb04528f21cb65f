/* A block on a slope, part after part by backward Euler, against what is known of it. */
#include "base/elementary.h"
#include "few_blocks.h"

static const double g = 9.81, mass = 0.01, h = 1e-3;

typedef struct slope {
    few_blocks f;
    double angle, mu;
    vec3 normal, down;
    vec3 at, v;
} slope;

/* At rest, as deep as it will be; held by what friction it has, or starting without any. */
static void slope_begin(slope *s, double angle, double mu, bool held)
{
    few_begin(&s->f, 1);
    s->angle = angle;
    s->mu = mu;
    s->normal = vec3_make(-vbss_sin(angle), vbss_cos(angle), 0.0);
    s->down = vec3_make(-vbss_cos(angle), -vbss_sin(angle), 0.0);
    s->v = vec3_zero();
    double weight = mass * g * vbss_cos(angle), pull = mass * g * vbss_sin(angle);
    s->at = vec3_scale(s->normal, -weight / 2e5);
    vec3 holding = vec3_scale(s->down, held ? -vbss_min(pull, mu * weight) : 0.0);
    s->f.set->warm_start[0] = (contact_warm_start_entry){.key = {3, 1, 0, 0, 0},
                                                         .status = CONTACT_STICK,
                                                         .normal_force = weight,
                                                         .tangential_force = holding};
    s->f.set->warm_start_count = 1;
    double inertia = mass / (h * h);
    s->f.stiffness[0] = mat3_diagonal(inertia, inertia, inertia);
}

static contact_outcome slope_part(slope *s, double augmentation)
{
    contact_set *set = s->f.set;
    vbss_contact_clear(set);
    contact_constraint *row = few_plane(&s->f, 0, 0, s->normal);
    row->friction = s->mu;
    row->augmentation = augmentation;
    row->gap = vec3_dot(s->at, s->normal);
    vbss_contact_warm_start(set);
    s->f.force[0] = vec3_add_scaled(vec3_make(0.0, -mass * g, 0.0), mass / h, s->v);
    contact_outcome found = few_solve(&s->f);
    vec3 u = s->f.system->solution[0];
    s->at = vec3_add(s->at, u);
    s->v = vec3_scale(u, 1.0 / h);
    vbss_contact_store_warm_start(set);
    return found;
}

static void block_sticks_below_and_slides_above_friction_angle(void **state)
{
    (void)state;
    const double augmentations[] = {3.0, 1e-2 * mass / (h * h), mass / (h * h)};
    for (int degrees = 0; degrees <= 85; degrees += 5) {
        for (int m = 0; m <= 20; m++) {
            slope s;
            slope_begin(&s, degrees * 0.017453292519943295, 0.1 * m, true);
            double cosine = vbss_cos(s.angle), sine = vbss_sin(s.angle),
                   over = sine - s.mu * cosine;
            if (fabs(over) > 1e-6) {
                vec3 begin = s.at;
                for (int i = 0; i < 50; i++) {
                    assert_int_equal(slope_part(&s, augmentations[m % 3]), CONTACT_CONVERGED);
                }
                const contact_solution *is = &s.f.set->constraints[0].solution;
                double weight = mass * g * cosine;
                expect_near(weight, is->normal_force, 1e-8 * mass * g);
                if (over > 0.0) {
                    expect_near(50.0 * h * g * over, vec3_dot(s.v, s.down), 1e-9);
                    expect_near(s.mu * weight, vec3_norm(is->tangential_force), 1e-8 * mass * g);
                } else {
                    expect_near(0.0, vec3_distance(s.at, begin), 1e-15);
                    expect_near(mass * g * sine, vec3_norm(is->tangential_force), 1e-8 * mass * g);
                }
            }
            few_end(&s.f);
        }
    }
}

static void friction_threshold_is_cone_to_five_digits(void **state)
{
    (void)state;
    for (int side = -1; side <= 1; side += 2) {
        slope s;
        slope_begin(&s, 0.3, vbss_sin(0.3) / vbss_cos(0.3) * (1.0 + 1e-5 * side), true);
        for (int i = 0; i < 400; i++) {
            assert_int_equal(slope_part(&s, 3.0), CONTACT_CONVERGED);
        }
        contact_status wanted = side > 0 ? CONTACT_STICK : CONTACT_SLIP;
        assert_int_equal(s.f.set->constraints[0].solution.status, wanted);
        expect_near(side > 0 ? 0.0 : 0.4 * g * 1e-5 * vbss_sin(0.3), vec3_dot(s.v, s.down), 1e-9);
        few_end(&s.f);
    }
}

/* It goes down as far as the contact is elastic, and then no more. */
static void sticking_does_not_creep(void **state)
{
    (void)state;
    slope s;
    slope_begin(&s, 0.25, 0.6, false);
    vec3 begin = s.at;
    for (int i = 0; i < 50; i++) {
        slope_part(&s, 3.0);
    }
    double elastic = mass * g * vbss_sin(s.angle) / 2e5;
    expect_near(elastic, vec3_dot(vec3_sub(s.at, begin), s.down), 1e-13);
    begin = s.at;
    uint64_t solves = s.f.set->counters.solves;
    for (int i = 0; i < 5000; i++) {
        assert_int_equal(slope_part(&s, 3.0), CONTACT_CONVERGED);
    }
    expect_near(0.0, vec3_distance(begin, s.at), 1e-15);
    assert_int_equal(s.f.set->counters.solves - solves,
                     5000); /* what is remembered holds at once */
    few_end(&s.f);
}

int test_block_on_slope(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(block_sticks_below_and_slides_above_friction_angle),
        cmocka_unit_test(friction_threshold_is_cone_to_five_digits),
        cmocka_unit_test(sticking_does_not_creep),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
