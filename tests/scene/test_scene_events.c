/* What happened in a step: who touches whom, who parts, what was cut short, what was lost. */
#include "base/elementary.h"
#include "scene/small.h"

static const vec3 half = {0.0, 0.0, 3e-3};

/* Bodies that begin to touch press on each other at a place; those that part do not. */
static void expect_place(const small *s, const vbss_scene_event *event, bool is_touch)
{
    const vbss_scene_statistics now = small_statistics(s);
    assert_int_equal(event->struct_size, sizeof *event);
    assert_int_equal(event->step, now.steps);
    assert_true(event->time == now.time);
    assert_int_equal(event->flags, is_touch ? VBSS_SCENE_EVENT_FLAG_POSITION : 0);
    assert_int_equal(event->value > 0.0, is_touch);
    assert_int_equal(event->position[1] != 0.0, is_touch);
}

static void expect_event(const small *s, vbss_scene_event_kind kind, uint32_t count, uint32_t a,
                         uint32_t b)
{
    vbss_scene_event event = {0};
    assert_int_equal(small_events(s, kind, &event), count);
    if (count > 0) {
        assert_int_equal(event.body_a, a);
        assert_int_equal(event.body_b, b);
        assert_int_equal(event.id, 0);
        expect_place(s, &event, kind == VBSS_SCENE_EVENT_TOUCH);
    }
}

/* A coupled tool goes down to a driven one and up again. */
static void touch_and_separate_events_pair(void **state)
{
    (void)state;
    small s;
    uint32_t touched = 0, parted = 0;
    small_begin_scene(&s);
    uint32_t below = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), half, 1e-3);
    uint32_t tool = small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.0, 2.3e-3, 0.0),
                                vec3_make(3e-3, 0.0, 0.0), 1e-3);
    for (int i = 0; i < 200; i++) {
        double down = i < 60 ? 1e-5 * i : i < 100 ? 6e-4 : 6e-4 - 1e-5 * (i - 100);
        vbss_scene_event event;
        uint32_t contacts = small_statistics(&s).contacts;
        small_move(&s, tool, vec3_make(0.0, 2.3e-3 - down, 0.0));
        small_steps(&s, 1, 1e-3);
        bool now = small_statistics(&s).contacts > 0, before = contacts > 0;
        expect_event(&s, VBSS_SCENE_EVENT_TOUCH, now && !before, below, tool);
        expect_event(&s, VBSS_SCENE_EVENT_PART, before && !now, below, tool);
        touched += small_events(&s, VBSS_SCENE_EVENT_TOUCH, &event);
        parted += small_events(&s, VBSS_SCENE_EVENT_PART, &event);
    }
    assert_int_equal(touched, 1);
    assert_int_equal(parted, 1);
    small_end(&s);
}

/* A figure of eight above the floor, whose end crosses over its begin. */
static uint32_t drop_eight(small *s)
{
    enum { SEGMENTS = 60 };
    double positions[3 * (SEGMENTS + 1)], rest[SEGMENTS];
    vbss_thread *thread;
    uint32_t body;
    for (int i = 0; i <= SEGMENTS; i++) {
        double a = -0.6 + 4.34 * i / SEGMENTS; /* 0 and pi are in one place */
        vec3 here =
            vec3_make(6e-3 * vbss_sin(a), 2e-4 + 1e-4 * (a + 0.6), 4e-3 * vbss_sin(2.0 * a));
        vec3_store(positions + 3 * (size_t)i, here);
        if (i > 0) {
            rest[i - 1] = vec3_distance(here, vec3_load(positions + 3 * (size_t)(i - 1)));
        }
    }
    s->thread.gravity[1] = -9.81;
    s->thread.segment_count = SEGMENTS;
    s->thread.bending = VBSS_THREAD_BENDING_LOCAL;
    s->thread.bending_stiffness = 1e-13; /* else it springs open */
    s->thread.positions = positions;
    s->thread.rest_lengths = rest;
    expect_ok(vbss_thread_create(s->context, &s->thread, &thread));
    expect_ok(vbss_scene_add_thread(s->scene, thread, &body));
    return body;
}

/* Many contacts of two bodies are one touch; the floor is body 0, and a thread may touch itself. */
static void contact_event_is_per_body_pair(void **state)
{
    (void)state;
    small s;
    bool floor = false, itself = false;
    small_begin(&s);
    s.config.floor = 1;
    small_create(&s);
    uint32_t body = drop_eight(&s);
    for (int i = 0; i < 100; i++) {
        small_steps(&s, 1, 1e-3);
        const step_events events = step_events_of(s.scene);
        for (uint32_t k = 0; k < events.count; k++) {
            const vbss_scene_event *e = &events.of[k];
            if (e->kind == VBSS_SCENE_EVENT_TOUCH) {
                assert_int_equal(e->body_a, body);
                floor = floor || e->body_b == 0;
                itself = itself || e->body_b == body;
            }
        }
        assert_true(events.count <= 2);
    }
    assert_true(floor && itself);
    assert_true(small_statistics(&s).contacts > 10);
    small_end(&s);
}

/* A body that leaves while it touches has parted, which shows in the next step. */
static void removed_body_emits_separate(void **state)
{
    (void)state;
    small s;
    small_begin_scene(&s);
    s.rigid.gravity[1] = -9.81;
    uint32_t below = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), half, 1e-3);
    uint32_t top = small_stick(&s, VBSS_SCENE_RIGID_FREE, vec3_make(0.0, 2e-3, 0.0),
                               vec3_make(3e-3, 0.0, 0.0), 1e-3);
    small_steps(&s, 10, 1e-3);
    assert_true(small_statistics(&s).contacts > 0);
    expect_ok(vbss_scene_remove(s.scene, top));
    small_steps(&s, 1, 1e-3);
    expect_event(&s, VBSS_SCENE_EVENT_PART, 1, below, top);
    small_steps(&s, 1, 1e-3);
    assert_int_equal(step_events_of(s.scene).count, 0);
    small_end(&s);
}

static void truncated_and_paused_parts_report_their_time(void **state)
{
    (void)state;
    small s;
    vbss_scene_event event;
    small_begin_scene(&s);
    uint32_t wall = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), half, 1e-3);
    uint32_t tool = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, 5e-3, 0.0),
                                vec3_make(3e-3, 0.0, 0.0), 1e-3);
    small_move(&s, tool, vec3_make(0.0, -5e-3, 0.0)); /* through the other in one step */
    small_steps(&s, 1, 1e-3);
    const vbss_scene_statistics found = small_statistics(&s);
    assert_int_equal(small_events(&s, VBSS_SCENE_EVENT_PAUSED, &event), found.paused);
    assert_true(found.paused == 0 || event.value == found.time_paused);
    const uint32_t truncated = small_events(&s, VBSS_SCENE_EVENT_TRUNCATED, &event);
    assert_true(truncated > 0);
    assert_int_equal(found.clamped, truncated);
    assert_true(event.body_a == wall && event.body_b == tool);
    const double lost = step_events_lost_time(s.scene);
    assert_true(lost > 0.1e-3 && lost < 1e-3);
    assert_true(small_position(&s, tool).y > 0.0);
    small_end(&s);
}

/* ---- more than there is room for */

static uint32_t drop(small *s, uint32_t capacity)
{
    small_begin(s);
    s->config.floor = 1;
    s->config.event_capacity = capacity;
    small_create(s);
    s->rigid.gravity[1] = -9.81;
    for (uint32_t i = 0; i < 6; i++) { /* six balls that meet the floor in one step */
        vec3 at = vec3_make(0.01 * i, 1e-3 + 1e-6, 0.0);
        small_stick(s, VBSS_SCENE_RIGID_FREE, at, vec3_zero(), 1e-3);
    }
    small_steps(s, 1, 1e-3);
    return (uint32_t)step_events_of(s->scene).count;
}

static void events_above_capacity_are_counted(void **state)
{
    (void)state;
    for (uint32_t capacity = 0; capacity <= 8; capacity++) {
        small s;
        vbss_scene_event event = {0};
        assert_int_equal(drop(&s, capacity), capacity < 6 ? capacity : 6);
        assert_int_equal(small_events(&s, VBSS_SCENE_EVENT_TOUCH, &event),
                         capacity < 6 ? capacity : 6);
        assert_int_equal(small_object(&s)->events.lost, capacity < 6 ? 6 - capacity : 0);
        small_steps(&s, 1, 1e-3); /* and there is no other */
        assert_int_equal(step_events_of(s.scene).count, 0);
        small_end(&s);
    }
}

/* What is told does not depend on whether somebody has room to hear it. */
static void event_capacity_changes_nothing_else(void **state)
{
    (void)state;
    small none, some;
    drop(&none, 0);
    drop(&some, 100);
    assert_true(small_hash(&none) == small_hash(&some));
    small_steps(&none, 5, 1e-3);
    small_steps(&some, 5, 1e-3);
    assert_true(small_hash(&none) == small_hash(&some));
    small_end(&some);
    small_end(&none);
}

int test_scene_events(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(touch_and_separate_events_pair),
        cmocka_unit_test(contact_event_is_per_body_pair),
        cmocka_unit_test(removed_body_emits_separate),
        cmocka_unit_test(truncated_and_paused_parts_report_their_time),
        cmocka_unit_test(events_above_capacity_are_counted),
        cmocka_unit_test(event_capacity_changes_nothing_else),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
