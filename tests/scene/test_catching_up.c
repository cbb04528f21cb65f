/* A scene that has fallen behind catches up, if the budget of a call has room for a step and for the largest part
 * of a step that is not divided. */
#include "scene/small.h"
#include "scene/solve/solve.h"
#include "scene/tuning.h"

#define STEP 1e-3
/* Calls by which the scene has caught up. Chosen: each gains a part of a step. */
enum { STEPS_BEFORE = 200, MAX_CALLS = 20 };

static scene_object *object_of(const small *s)
{
    return ((vbss_slot *)s->scene)->object;
}

/* A thread that rests on the floor, so that all steps cost the same. */
static void begin(small *s)
{
    small_begin(s);
    s->config.floor = 1;
    s->thread.gravity[1] = -9.81;
    small_create(s);
    const double y = s->thread.radius;
    small_thread(s, vec3_make(-0.05, y, 0.0), vec3_make(0.05, y, 0.0), 100, NULL);
    object_of(s)->settings.call_budget = 0;
    small_steps(s, STEPS_BEFORE, STEP);
}

/* What a call needs beyond a step: room for the contacts, or for a linearisation. */
static uint64_t largest_part(const scene_object *s)
{
    const uint64_t attempt = vbss_scene_attempt_cost(s),
                   linearisation = vbss_scene_linearisation_cost(s);
    return attempt > linearisation ? attempt : linearisation;
}

/* Operations of a step as a call counts them. */
static uint64_t step_cost(const small *s)
{
    const uint64_t before = small_statistics(s).operations;
    small_steps((small *)s, 1, STEP);
    return small_statistics(s).operations - before +
           vbss_scene_attempt_cost(object_of(s)) / SCENE_STEP_END_DIVISOR;
}

static void scene_behind_catches_up_if_calls_have_room(void **state)
{
    (void)state;
    for (uint32_t k = 0; k <= 8; k++) {
        small s;
        begin(&s);
        scene_object *own = object_of(&s);
        const uint64_t cost = step_cost(&s), smallest = cost + largest_part(own);
        assert_true(smallest < 2 * cost);
        own->settings.call_budget = 1;
        small_steps(&s, 3, STEP);
        assert_true(small_statistics(&s).behind > 0);
        own->settings.call_budget = (uint32_t)(smallest + k * (2 * cost - smallest) / 8 + 1);
        uint32_t calls = 0;
        for (; calls < MAX_CALLS && small_statistics(&s).behind > 0; calls++) {
            small_steps(&s, 1, STEP);
        }
        assert_int_equal(0, small_statistics(&s).behind);
        small_end(&s);
    }
}

int test_catching_up(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scene_behind_catches_up_if_calls_have_room),
    };
    return cmocka_run_group_tests_name("scene.catching_up", tests, NULL, NULL);
}
