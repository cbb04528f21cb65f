/* Trouble stays local: an island that cannot move holds back nothing else. */
#include <stdlib.h>

#include "fixtures/solver_of.h"
#include "scene/small.h"

#define STEP 1e-3
#define GRAVITY 9.81

static const vec3 half_z = {0.0, 0.0, 5e-3};

/* A thread that falls freely, 100 mm away from everything else. */
static vbss_thread *add_falling_thread(small *s)
{
    vbss_thread *thread;
    s->thread.gravity[1] = -GRAVITY;
    small_thread(s, vec3_make(0.1, 0.0, 0.0), vec3_make(0.11, 0.0, 0.0), 8, &thread);
    s->thread.gravity[1] = 0.0;
    return thread;
}

/* Height after `steps` of free fall. Integration by steps of `STEP` is exact to one of them. */
static double free_fall(uint32_t steps)
{
    double t = STEP * steps;
    return -0.5 * GRAVITY * t * t;
}

static double fall_tolerance(uint32_t lost_steps, uint32_t steps)
{
    return (1.0 + lost_steps) * GRAVITY * STEP * steps * STEP;
}

/* A thread between two driven sticks, which a host then drives into each other. */
typedef struct press {
    uint32_t below, above;
    vbss_thread *squeezed, *falls;
} press;

static press add_press(small *s)
{
    press p;
    small_thread(s, vec3_make(-6e-3, 0.0, 0.0), vec3_make(6e-3, 0.0, 0.0), 24, &p.squeezed);
    p.below = small_stick(s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, -1.5e-3, 0.0), half_z, 1e-3);
    p.above = small_stick(s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, 1.5e-3, 0.0), half_z, 1e-3);
    p.falls = add_falling_thread(s);
    return p;
}

static void close_press(small *s, const press *p, uint32_t step)
{
    double y = vbss_max(1.5e-3 - 1e-4 * step, 0.0);
    small_move(s, p->below, vec3_make(0.0, -y, 0.0));
    small_move(s, p->above, vec3_make(0.0, y, 0.0));
}

/* Two driven bodies whose capsules share a point, as pieces of a mesh do, at rest and moving. */
static void touching_driven_bodies_stop_nothing(void **state)
{
    (void)state;
    for (int mode = 0; mode < 2; mode++) {
        small s;
        small_begin(&s);
        s.config.mode = mode == 0 ? VBSS_SCENE_MODE_OFFLINE : VBSS_SCENE_MODE_REAL_TIME;
        small_create(&s);
        vec3 corner = vec3_zero();
        small_capsule(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(-5e-3, 0.0, 0.0), corner, 1e-3);
        uint32_t other =
            small_capsule(&s, VBSS_SCENE_RIGID_DRIVEN, corner, vec3_make(0.0, 0.0, 5e-3), 1e-3);
        vbss_thread *falls = add_falling_thread(&s);
        for (uint32_t i = 1; i <= 100; i++) {
            if (i > 50) {
                small_move(&s, other, vec3_make(1e-5 * (i - 50), 0.0, 0.0));
            }
            small_steps(&s, 1, STEP);
            expect_near(free_fall(i), small_node(falls, 4).y, fall_tolerance(0, i));
        }
        expect_near(5e-4, small_position(&s, other).x, 1e-16);
        assert_int_equal(small_statistics(&s).paused, 0);
        assert_int_equal(small_statistics(&s).clamped, 0);
        small_end(&s);
    }
}

static void squeezed_thread_holds_back_nothing_else(void **state)
{
    (void)state;
    for (int mode = 0; mode < 2; mode++) {
        small s;
        small_begin(&s);
        s.config.mode = mode == 0 ? VBSS_SCENE_MODE_OFFLINE : VBSS_SCENE_MODE_REAL_TIME;
        small_create(&s);
        press p = add_press(&s);
        for (uint32_t i = 1; i <= 150; i++) {
            close_press(&s, &p, i);
            small_steps(&s, 1, STEP);
            expect_near(free_fall(i), small_node(p.falls, 4).y,
                        fall_tolerance(mode == 0 ? 0 : 3, i));
        }
        /* The press is held, and has let nothing through. */
        vbss_scene_statistics found = small_statistics(&s);
        assert_true(found.clamped + found.paused > 0);
        double below = small_position(&s, p.below).y, above = small_position(&s, p.above).y;
        vec3 middle = small_node(p.squeezed, 12);
        assert_true(below < middle.y && middle.y < above);
        small_end(&s);
    }
}

/* Offline, a step has no budget. A press that is held would take 3,091 attempts in each step. */
static void offline_step_that_gains_nothing_ends_early(void **state)
{
    (void)state;
    enum { HALVINGS = 10, STEPS = 60, MAX_ATTEMPTS = 200 };
    small s;
    small_begin(&s);
    s.config.mode = VBSS_SCENE_MODE_OFFLINE;
    solver_of(&s.config)->halving_limit = HALVINGS;
    small_create(&s);
    press p = add_press(&s);
    uint64_t attempts = 0, max_attempts = 0;
    for (uint32_t i = 1; i <= STEPS; i++) {
        close_press(&s, &p, i);
        small_steps(&s, 1, STEP);
        uint64_t of_step = small_statistics(&s).attempts - attempts;
        attempts += of_step;
        max_attempts = of_step > max_attempts ? of_step : max_attempts;
        expect_near(free_fall(i), small_node(p.falls, 4).y, fall_tolerance(0, i));
    }
    assert_true(max_attempts <= MAX_ATTEMPTS);
    assert_true(small_statistics(&s).paused > 0);
    assert_true(small_statistics(&s).time_paused > 0.0);
    /* Once the press opens, its sticks go where the host puts them. */
    small_move(&s, p.below, vec3_make(0.0, -1.5e-3, 0.0));
    small_move(&s, p.above, vec3_make(0.0, 1.5e-3, 0.0));
    small_steps(&s, 10, STEP);
    expect_near(-1.5e-3, small_position(&s, p.below).y, 1e-9);
    expect_near(1.5e-3, small_position(&s, p.above).y, 1e-9);
    small_end(&s);
}

/* A pin takes a node of a thread through a stick. The thread waits; where its node was to go holds back nothing. */
static void node_pinned_beyond_a_stick_holds_back_nothing_else(void **state)
{
    (void)state;
    enum { STEPS = 50 };
    small s;
    uint32_t pin;
    const double beyond[3] = {0.0, -8e-3, 0.0};
    small_begin(&s);
    s.config.mode = VBSS_SCENE_MODE_OFFLINE;
    small_create(&s);
    uint32_t line =
        small_thread(&s, vec3_make(-6e-3, 0.0, 0.0), vec3_make(6e-3, 0.0, 0.0), 24, NULL);
    small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, -1.5e-3, 0.0), half_z, 1e-3);
    vbss_thread *falls = add_falling_thread(&s);
    expect_ok(vbss_scene_pin_thread(s.scene, line, 12, 0, beyond, &pin));
    small_steps(&s, STEPS, STEP);
    assert_true(small_statistics(&s).clamped > 0);
    expect_near(free_fall(STEPS), small_node(falls, 4).y, fall_tolerance(0, STEPS));
    small_end(&s);
}

/* The most consecutive steps in which a thread stands still. */
static uint32_t count_longest_stationary(small *s, vbss_thread *falls, uint32_t steps)
{
    uint32_t stationary_steps = 0, longest = 0;
    for (uint32_t i = 0; i < steps; i++) {
        double before = small_node(falls, 4).y;
        small_steps(s, 1, STEP);
        stationary_steps = small_node(falls, 4).y < before ? 0 : stationary_steps + 1;
        longest = stationary_steps > longest ? stationary_steps : longest;
    }
    return longest;
}

/* A coupled stick is pressed into the floor, and its attempts are exhausted. The next step lets it wait, so all others
 * lose one step. */
static void pair_that_exhausts_its_attempts_is_known_in_the_next_step(void **state)
{
    (void)state;
    enum { STEPS = 40 };
    small s;
    small_begin(&s);
    solver_of(&s.config)->attempt_limit = 2;
    solver_of(&s.config)->penetration_tolerance = 1e-3;
    s.config.floor = 1;
    s.config.floor_height = -0.05;
    small_create(&s);
    uint32_t stick =
        small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.0, -0.04899, 0.0), half_z, 1e-3);
    vbss_thread *falls = add_falling_thread(&s);
    small_move(&s, stick, vec3_make(0.0, -0.052, 0.0));
    assert_true(count_longest_stationary(&s, falls, STEPS) <= 1);

    small_end(&s);
}

/* A pin takes a node of a thread through a stick, so far that there is no room for all pairs on its way. Where the
 * thread fails with a smaller substep, it waits in the next step, although its whole way has no room there either. */
static void thread_without_room_for_its_pairs_waits_alone(void **state)
{
    (void)state;
    enum { STEPS = 40 };
    const double beyond[3] = {0.0, -8e-3, 0.0};
    small s;
    uint32_t pin;
    small_begin(&s);
    solver_of(&s.config)->attempt_limit = 3;
    s.config.candidate_capacity = 12;
    small_create(&s);
    uint32_t line =
        small_thread(&s, vec3_make(-6e-3, 0.0, 0.0), vec3_make(6e-3, 0.0, 0.0), 24, NULL);
    small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, -1.5e-3, 0.0), half_z, 1e-3);
    vbss_thread *falls = add_falling_thread(&s);
    small_steps(&s, 1, STEP);
    expect_ok(vbss_scene_pin_thread(s.scene, line, 12, 0, beyond, &pin));
    assert_true(count_longest_stationary(&s, falls, STEPS) <= 1);

    small_end(&s);
}

/* In a call with little work a step is suspended while an island waits. A state that is saved then goes
 * on to the same bits. */
static void state_saved_while_an_island_waits_continues_equally(void **state)
{
    (void)state;
    uint32_t divided = 0;
    for (uint32_t limit = 200; limit < 20000; limit = limit * 5 / 4) {
        small s;
        small_begin(&s);
        s.config.drain_capacity = 0;
        set_call_operations(&s.config, limit);
        small_create(&s);
        press p = add_press(&s);
        for (uint32_t i = 1; i <= 60; i++) {
            close_press(&s, &p, i);
            small_steps(&s, 1, STEP);
            const scene_step_cursor *cursor = &small_object(&s)->cursor;
            if (!cursor->is_suspended || cursor->group_count == 1) {
                continue;
            }
            divided++;
            small_state saved = small_save(&s);
            uint64_t hashes[2];
            for (int k = 0; k < 2; k++) {
                for (uint32_t n = 1; n <= 4; n++) {
                    close_press(&s, &p, i + n);
                    small_steps(&s, 1, STEP);
                }
                hashes[k] = small_hash(&s);
                expect_ok(vbss_scene_restore(s.scene, saved.bytes, saved.count));
            }
            assert_int_equal(hashes[0], hashes[1]);
            free(saved.bytes);
        }
        small_end(&s);
    }
    print_message("%u states were saved while an island waited\n", divided);
    assert_true(divided > 10);
}

/* A scene that is restored to its own state before each call has the same state as one that is not, also while an
 * island waits. */
static void restore_before_each_call_changes_no_state(void **state)
{
    (void)state;
    uint32_t divided = 0;
    for (uint32_t limit = 200; limit < 20000; limit = limit * 5 / 4) {
        small s[2];
        press p[2];
        for (int k = 0; k < 2; k++) {
            small_begin(&s[k]);
            set_call_operations(&s[k].config, limit);
            small_create(&s[k]);
            p[k] = add_press(&s[k]);
        }
        for (uint32_t i = 1; i <= 60; i++) {
            small_state saved = small_save(&s[0]);
            expect_ok(vbss_scene_restore(s[0].scene, saved.bytes, saved.count));
            free(saved.bytes);
            for (int k = 0; k < 2; k++) {
                close_press(&s[k], &p[k], i);
                small_steps(&s[k], 1, STEP);
            }
            divided += small_object(&s[0])->cursor.group_count > 1;
            assert_true(small_hash(&s[0]) == small_hash(&s[1]));
        }
        small_end(&s[0]);
        small_end(&s[1]);
    }
    assert_true(divided > 10);
}

/* An edit ends a step of which several islands wait. The lost step is counted, whatever island was in progress. */
static void edit_while_islands_wait_counts_the_lost_step(void **state)
{
    (void)state;
    uint32_t checked = 0;
    for (uint32_t limit = 200; limit < 20000; limit = limit * 5 / 4) {
        small s;
        small_begin(&s);
        set_call_operations(&s.config, limit);
        small_create(&s);
        press p = add_press(&s);
        for (uint32_t i = 1; i <= 60; i++) {
            close_press(&s, &p, i);
            small_steps(&s, 1, STEP);
            const scene_step_cursor *cursor = &small_object(&s)->cursor;
            if (!cursor->is_suspended || cursor->group + 1 >= cursor->group_count) {
                continue;
            }
            const uint64_t paused = small_statistics(&s).paused;
            checked++;
            small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(-0.1, 0.0, 0.0), half_z, 1e-3);
            assert_int_equal(small_statistics(&s).paused, paused + 1);
            break;
        }
        small_end(&s);
    }
    assert_true(checked > 0);
}

/* Contacts of the islands that do not fail are in the views after the step, too. */
static void contacts_of_all_islands_are_published(void **state)
{
    (void)state;
    small s;
    small_begin_scene(&s);
    press p = add_press(&s);
    s.rigid.gravity[1] = -GRAVITY;
    uint32_t table =
        small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(-0.1, 0.0, 0.0), half_z, 1e-3);
    uint32_t rests = small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_make(-0.1, 2.1e-3, 0.0),
                                 vec3_make(3e-3, 0.0, 0.0), 1e-3);
    small_move(&s, rests, vec3_make(-0.1, 1e-3, 0.0));
    uint32_t checked = 0;
    for (uint32_t i = 1; i <= 100; i++) {
        close_press(&s, &p, i);
        uint64_t clamped = small_statistics(&s).clamped;
        small_steps(&s, 1, STEP);
        if (i < 20 || small_statistics(&s).clamped == clamped) {
            continue;
        }
        checked++;
        bool is_listed[2] = {false, false};
        vbss_view v = small_view(&s, VBSS_SCENE_VIEW_CONTACTS);
        for (uint64_t k = 0; k < v.count; k++) {
            uint32_t words[5];
            memcpy(words, (const char *)v.data + k * v.stride_bytes, sizeof words);
            is_listed[0] = is_listed[0] || (words[1] == table && words[3] == rests) ||
                           (words[1] == rests && words[3] == table);
            is_listed[1] = is_listed[1] || words[3] == p.above;
        }
        assert_true(is_listed[0] && is_listed[1]);
        assert_true(small_rigid(&s, rests).contact_force[1] > 0.0);
    }
    assert_true(checked > 0);
    small_end(&s);
}

static uint32_t count_blockers(small *s)
{
    uint32_t count = 0;
    vbss_scene_blocker found;
    while (vbss_scene_get_blocker(s->scene, count, &found, sizeof found) == VBSS_OK) {
        count++;
    }
    expect_result(VBSS_ERROR_NOT_FOUND,
                  vbss_scene_get_blocker(s->scene, count, &found, sizeof found));
    return count;
}

/* The thread and a stick are reported while the press is shut, with one event at the start and one at the
 * end. */
static void blocked_pair_is_reported_once_until_it_is_free(void **state)
{
    (void)state;
    enum { SHUT = 60, FREE_AFTER = 100 };
    small s;
    small_begin(&s);
    s.config.mode = VBSS_SCENE_MODE_OFFLINE;
    small_create(&s);
    press p = add_press(&s);
    vbss_scene_event event;
    uint32_t begun = 0, ended = 0;
    double lost = 0.0;
    assert_int_equal(count_blockers(&s), 0);
    for (uint32_t i = 1; i <= SHUT + 2 * FREE_AFTER; i++) {
        close_press(&s, &p, i <= SHUT ? i : 0);
        small_steps(&s, 1, STEP);
        begun += small_events(&s, VBSS_SCENE_EVENT_BLOCKED, &event);
        ended += small_events(&s, VBSS_SCENE_EVENT_UNBLOCKED, &event);
        if (i != SHUT) {
            continue;
        }
        assert_true(count_blockers(&s) > 0 && begun == count_blockers(&s));
        for (uint32_t k = 0; k < begun; k++) {
            vbss_scene_blocker found;
            expect_ok(vbss_scene_get_blocker(s.scene, k, &found, sizeof found));
            bool is_of_press =
                (found.body_a == 1 && found.body_b >= p.below && found.body_b <= p.above) ||
                (found.body_a == p.below && found.body_b == p.above);
            assert_true(is_of_press);
            assert_true(found.cause == VBSS_SCENE_BLOCKER_COLLISION ||
                        found.cause == VBSS_SCENE_BLOCKER_PENETRATION ||
                        found.cause == VBSS_SCENE_BLOCKER_CONTACT);
            assert_true(found.since >= 3e-3 && found.since <= STEP * SHUT);
            assert_true(found.depth >= 0.0 && found.depth < 1.125e-3);
            lost += found.lost_time;
        }
        assert_true(lost > 0.0 && lost < STEP * SHUT);
        /* A restored scene has the same blockers. */
        small_state saved = small_save(&s);
        uint64_t hash = small_hash(&s);
        expect_ok(vbss_scene_restore(s.scene, saved.bytes, saved.count));
        assert_int_equal(count_blockers(&s), begun);
        assert_true(small_hash(&s) == hash);
        free(saved.bytes);
    }
    assert_int_equal(begun, ended);
    assert_int_equal(count_blockers(&s), 0);
    small_end(&s);
}

int test_islands(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(touching_driven_bodies_stop_nothing),
        cmocka_unit_test(squeezed_thread_holds_back_nothing_else),
        cmocka_unit_test(offline_step_that_gains_nothing_ends_early),
        cmocka_unit_test(node_pinned_beyond_a_stick_holds_back_nothing_else),
        cmocka_unit_test(pair_that_exhausts_its_attempts_is_known_in_the_next_step),
        cmocka_unit_test(thread_without_room_for_its_pairs_waits_alone),
        cmocka_unit_test(state_saved_while_an_island_waits_continues_equally),
        cmocka_unit_test(restore_before_each_call_changes_no_state),
        cmocka_unit_test(edit_while_islands_wait_counts_the_lost_step),
        cmocka_unit_test(contacts_of_all_islands_are_published),
        cmocka_unit_test(blocked_pair_is_reported_once_until_it_is_free),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
