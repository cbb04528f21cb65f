/* The guard asks the pairs that the search for rows has listed, if nothing left the boxes in which that looked; else it
 * searches itself. Either way it finds the same. */
#include "base/elementary.h"
#include "scene/ccd/ccd.h"
#include "scene/contacts/contacts.h"
#include "scene/small.h"

enum { CASES = 400, NODES = 25 };

typedef struct tally {
    uint32_t listed, searched, hits;
} tally;

static double between(vbss_random *r, double low, double high)
{
    return low + (high - low) * vbss_random_uniform(r);
}

static vec3 random_vector(vbss_random *r, double limit)
{
    double x = between(r, -limit, limit), y = between(r, -limit, limit),
           z = between(r, -limit, limit);
    return vec3_make(x, y, z);
}

/* By powers of ten: nothing for most cases is everything for some. */
static double random_size(vbss_random *r, double low, double high)
{
    return low * vbss_exp(vbss_random_uniform(r) * vbss_log(high / low));
}

static void ask(scene_object *s, tally *t, double *earliest)
{
    uint64_t searches = s->collision->searches;
    scene_substep_outcome outcome = vbss_scene_run_ccd(s);
    assert_true(outcome == SCENE_SUBSTEP_ACCEPTED || outcome == SCENE_SUBSTEP_CCD_HIT);
    *earliest = s->step.time_of_impact;
    t->searched += s->collision->searches > searches;
    t->listed += s->collision->searches == searches;
    t->hits += outcome == SCENE_SUBSTEP_CCD_HIT;
}

/* A thread among sticks is expected to go one way, and goes nearly that. */
static void compare_listed_and_searched(vbss_random *r, tally *t)
{
    small g;
    vbss_thread *thread;
    thread_object *object;
    double listed, searched;
    small_begin_scene(&g);
    small_thread(&g, vec3_make(-12e-3, 0.0, 0.0), vec3_make(12e-3, 0.0, 0.0), NODES - 1, &thread);
    for (int i = 0; i < 3; i++) {
        vec3 at = random_vector(r, 8e-3), half = random_vector(r, 5e-3);
        at.y = between(r, 1.3e-3, 3e-3);
        half.y = 0.0;
        small_stick(&g, VBSS_SCENE_RIGID_DRIVEN, at, half, 1e-3);
    }
    small_steps(&g, 1, 1e-3);
    scene_object *s = small_object(&g);
    expect_ok(vbss_thread_open(thread, &object));
    double expected = random_size(r, 1e-5, 3e-3), other = random_size(r, 1e-6, 3e-3);
    for (uint32_t i = 0; i < NODES; i++) {
        object->trial[i] = vec3_add(object->now.x[i], random_vector(r, expected));
    }
    const scene_substep part = {
        .step_length = 1e-3, .h = 1e-3, .end_fraction = 1.0, .uses_trial_motion = true};
    assert_true(vbss_scene_create_contacts(s, &part));
    for (uint32_t i = 0; i < NODES; i++) {
        object->trial[i] = vec3_add(object->trial[i], random_vector(r, other));
    }
    ask(s, t, &listed);
    s->step.expected_displacements[0].x = (double)NAN; /* nothing is expected of that */
    tally second = {0, 0, 0};
    ask(s, &second, &searched);
    assert_int_equal(second.searched, 1);
    assert_true(listed == searched);
    small_end(&g);
}

static void listed_pairs_equal_search(void **state)
{
    (void)state;
    vbss_random random;
    tally t = {0, 0, 0};
    vbss_random_seed(&random, 8, 1);
    for (int i = 0; i < CASES; i++) {
        compare_listed_and_searched(&random, &t);
    }
    assert_true(t.listed > CASES / 10 && t.searched > CASES / 10 && t.hits > CASES / 10);
}

static void resting_bodies_are_searched_once_a_step(void **state)
{
    (void)state;
    small g;
    small_begin_scene(&g);
    uint32_t line = small_thread(&g, vec3_make(-12e-3, 1.2e-3, 0.0), vec3_make(12e-3, 1.2e-3, 0.0),
                                 NODES - 1, NULL);
    small_pin_ends(&g, line, NODES);
    small_stick(&g, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), vec3_make(0.0, 0.0, 5e-3), 1e-3);
    small_steps(&g, 10, 1e-3);
    uint64_t searches = small_object(&g)->collision->searches;
    small_steps(&g, 10, 1e-3);
    assert_int_equal(small_object(&g)->collision->searches - searches, 10);
    small_end(&g);
}

int test_ccd_pairs(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(listed_pairs_equal_search),
        cmocka_unit_test(resting_bodies_are_searched_once_a_step),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
