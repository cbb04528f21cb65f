/* Events are kept until a host takes them: none is missed, doubled or left by a step that was not made. */
#include <stdlib.h>

#include "fixtures/needle_scenes.h"
#include "fixtures/puncture_scenes.h"
#include "fixtures/scene_scenes.h"
#include "fixtures/solver_of.h"
#include "scene/pulled_surgeons.h"
#include "scene/small.h"

#define STEP 1e-3
enum { MAX_EVENTS = 4096 };

/* ---- takers */

typedef struct taken {
    vbss_scene_event of[MAX_EVENTS];
    uint32_t count;
    uint64_t lost;
} taken;

/* Takes all, a few at a time. */
static void take_all(vbss_scene *scene, taken *t, uint32_t at_a_time)
{
    uint32_t count;
    do {
        uint64_t lost;
        assert_true(t->count + at_a_time <= MAX_EVENTS);
        expect_ok(vbss_scene_take_events(scene, t->of + t->count, sizeof t->of[0], at_a_time,
                                         &count, &lost));
        t->count += count;
        t->lost += lost;
    } while (count == at_a_time);
}

static uint32_t waiting(vbss_scene *scene)
{
    uint32_t count;
    expect_ok(vbss_scene_take_events(scene, NULL, sizeof(vbss_scene_event), 0, &count, NULL));
    return count;
}

static uint32_t count_kind(const taken *t, vbss_scene_event_kind kind)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < t->count; i++) {
        count += t->of[i].kind == kind;
    }
    return count;
}

static void expect_same_events(const taken *a, const taken *b)
{
    assert_int_equal(a->count, b->count);
    assert_memory_equal(a->of, b->of, a->count * sizeof a->of[0]);
}

/* ---- a host that draws 60 frames a second */

static uint32_t expect_none_missed(scene_scene_kind kind)
{
    static taken each, frames;
    small one, other;
    each = frames = (taken){.count = 0};
    small_begin(&one);
    small_begin(&other);
    expect_ok(scene_scene_create(one.context, kind, &one.scene));
    expect_ok(scene_scene_create(other.context, kind, &other.scene));
    for (uint32_t step = 1, frame = 1; step <= 400; step++) {
        expect_ok(scene_scene_step(one.scene, kind));
        expect_ok(scene_scene_step(other.scene, kind));
        const uint32_t before = each.count;
        take_all(one.scene, &each, 16);
        for (uint32_t i = before; i < each.count; i++) {
            /* a cut by the host is between two steps */
            const bool is_edit = each.of[i].kind == VBSS_SCENE_EVENT_CUT;
            assert_int_equal(each.of[i].step, is_edit ? step - 1 : step);
            expect_near((double)each.of[i].step * STEP, each.of[i].time, 1e-12);
        }
        if (60 * step >= 1000 * frame) { /* 16 or 17 steps */
            take_all(other.scene, &frames, 3);
            frame++;
        }
    }
    take_all(other.scene, &frames, 3);
    assert_int_equal(each.lost + frames.lost, 0);
    expect_same_events(&each, &frames);
    assert_true(small_hash(&one) == small_hash(&other));
    small_end(&other);
    small_end(&one);
    return each.count;
}

static void host_at_60_hz_misses_no_event(void **state)
{
    (void)state;
    uint32_t count = 0;
    for (scene_scene_kind kind = SCENE_SCENE_KNOT; kind <= SCENE_SCENE_MESH; kind++) {
        count += expect_none_missed(kind);
    }
    assert_true(count > 10);
}

/* ---- room */

/* A thread in which many cuts can be made: each is an event, with its number as arc length. */
static uint32_t begin_cuts(small *s, uint32_t capacity, vbss_thread **thread)
{
    small_begin(s);
    s->config.event_capacity = capacity;
    s->config.thread_capacity = 16;
    s->config.node_capacity = 200;
    small_create(s);
    s->thread.cut_capacity = 10;
    return small_thread(s, vec3_zero(), vec3_make(0.04, 0.0, 0.0), 40, thread);
}

static void cut(small *s, uint32_t body, uint32_t number)
{
    uint32_t piece;
    expect_ok(vbss_scene_cut_thread(s->scene, body, 0.0375 - 2e-3 * number, &piece));
}

static void full_list_keeps_newest_and_counts_lost(void **state)
{
    (void)state;
    for (uint32_t capacity = 0; capacity <= 5; capacity++) {
        static taken t;
        small s;
        uint64_t lost;
        uint32_t count, number = 0, body = begin_cuts(&s, capacity, NULL);
        for (uint32_t round = 0; round < 2; round++) {
            t = (taken){.count = 0};
            for (uint32_t k = 0; k < 4; k++) {
                cut(&s, body, number++);
            }
            const uint32_t kept = capacity < 4 ? capacity : 4;
            assert_int_equal(waiting(s.scene), kept);
            expect_ok(vbss_scene_take_events(s.scene, NULL, sizeof t.of[0], 0, &count, &lost));
            assert_int_equal(lost, 4 - kept); /* asking does not reset it */
            take_all(s.scene, &t, 2);
            assert_int_equal(t.count, kept);
            assert_int_equal(t.lost, 4 - kept);
            for (uint32_t i = 0; i < kept; i++) {
                expect_near(0.0375 - 2e-3 * (number - kept + i), t.of[i].arc_length, 1e-12);
                assert_int_equal(t.of[i].kind, VBSS_SCENE_EVENT_CUT);
            }
        }
        small_end(&s);
    }
}

/* ---- what adds no event */

static void failed_step_adds_no_event(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    s.config.floor = 1;
    small_create(&s);
    s.rigid.gravity[1] = -9.81;
    small_stick(&s, VBSS_SCENE_RIGID_FREE, vec3_make(0.0, 1e-3 + 1e-6, 0.0), vec3_zero(), 1e-3);
    const double away[3] = {0.0, 0.3, 0.0};
    vbss_grasper *tool;
    uint32_t body;
    expect_ok(vbss_grasper_create(s.context, NULL, &tool));
    expect_ok(vbss_grasper_set_target(tool, away, NULL));
    expect_ok(vbss_scene_add_grasper(s.scene, tool, &body));
    expect_ok(vbss_grasper_exchange(tool, VBSS_GRASPER_KIND_SHEARS)); /* as the step begins */
    const uint32_t capacity = small_object(&s)->contacts->capacity;
    small_object(&s)->contacts->capacity = 0;
    for (int i = 0; i < 3; i++) {
        expect_result(VBSS_ERROR_CAPACITY, vbss_scene_step(s.scene, STEP));
        assert_int_equal(waiting(s.scene), 0);
        assert_int_equal(small_object(&s)->events.pending_count, 0);
    }
    small_object(&s)->contacts->capacity = capacity;
    small_steps(&s, 1, STEP);
    assert_int_equal(waiting(s.scene), 2); /* the exchange, and a contact */
    small_end(&s);
}

static void restore_empties_list(void **state)
{
    (void)state;
    static taken t;
    small s;
    t = (taken){.count = 0};
    uint32_t body = begin_cuts(&s, 8, NULL);
    small_state whole = small_save(&s);
    cut(&s, body, 0);
    small_state after = small_save(&s);
    const uint64_t hash = small_hash(&s);
    take_all(s.scene, &t, 4);
    assert_int_equal(t.count, 1);
    small_state taken_since = small_save(&s); /* whether they are taken is no part of the state */
    assert_true(small_hash(&s) == hash);
    assert_int_equal(after.count, taken_since.count);
    assert_memory_equal(after.bytes, taken_since.bytes, after.count);
    cut(&s, body, 1);
    assert_int_equal(waiting(s.scene), 1);
    whole.bytes[whole.count / 2] ^= 1; /* a refused restore keeps it */
    expect_result(VBSS_ERROR_CORRUPT, vbss_scene_restore(s.scene, whole.bytes, whole.count));
    assert_int_equal(waiting(s.scene), 1);
    whole.bytes[whole.count / 2] ^= 1;
    expect_ok(vbss_scene_restore(s.scene, whole.bytes, whole.count));
    assert_int_equal(waiting(s.scene), 0);
    free(whole.bytes);
    free(after.bytes);
    free(taken_since.bytes);
    small_end(&s);
}

static void refused_calls_take_nothing(void **state)
{
    (void)state;
    small s;
    vbss_scene_event e[2] = {{0}};
    uint32_t count = 77, body = begin_cuts(&s, 8, NULL);
    uint64_t lost = 77;
    cut(&s, body, 0);
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_scene_take_events(s.scene, e, sizeof *e, 2, NULL, &lost));
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_scene_take_events(s.scene, NULL, sizeof *e, 2, &count, &lost));
    expect_result(VBSS_ERROR_STRUCT_SIZE,
                  vbss_scene_take_events(s.scene, e, sizeof *e - 4, 2, &count, &lost));
    expect_result(VBSS_ERROR_INVALID_HANDLE,
                  vbss_scene_take_events(NULL, e, sizeof *e, 2, &count, &lost));
    assert_true(count == 77 && lost == 77 && e[0].kind == 0);
    assert_int_equal(waiting(s.scene), 1);
    expect_ok(vbss_scene_take_events(s.scene, e, sizeof *e, 0, &count, &lost));
    assert_true(count == 0 && lost == 0);
    assert_int_equal(waiting(s.scene), 1);
    small_end(&s);
}

/* An older or newer caller has a struct of another size, and so another distance from event to event. */
static void events_are_struct_size_apart(void **state)
{
    (void)state;
    struct newer {
        vbss_scene_event event;
        uint64_t more;
    } e[3];
    small s;
    uint32_t count, body = begin_cuts(&s, 8, NULL);
    memset(e, 0xff, sizeof e);
    cut(&s, body, 0);
    cut(&s, body, 1);
    expect_ok(vbss_scene_take_events(s.scene, &e[0].event, sizeof e[0], 2, &count, NULL));
    assert_int_equal(count, 2);
    for (uint32_t i = 0; i < 2; i++) {
        assert_int_equal(e[i].event.struct_size, sizeof(vbss_scene_event));
        assert_int_equal(e[i].event.kind, VBSS_SCENE_EVENT_CUT);
        assert_int_equal(e[i].more, 0);
    }
    assert_int_equal(e[2].more, UINT64_MAX);
    small_end(&s);
}

/* ---- steps in several calls */

/* Pulls a knot tight with room for so many operations in a call. */
static void pull(contact_scene *scene, vbss_context **context, uint32_t call_budget)
{
    contact_scene_options o;
    pulled_surgeons_init(&o);
    set_call_operations(&o.scene, call_budget);
    o.scene.event_capacity = MAX_EVENTS;
    expect_ok(vbss_context_create(NULL, context));
    expect_ok(contact_scene_create(*context, &o, scene));
}

static vbss_scene_statistics statistics_of(vbss_scene *scene)
{
    vbss_scene_statistics c;
    expect_ok(vbss_scene_get_statistics(scene, &c, sizeof c));
    return c;
}

/* Deferred work is reported when it grows and when it is done, and apart from time that is left out. */
static void deferred_truncated_and_paused_match_statistics(void **state)
{
    (void)state;
    static taken t;
    t = (taken){.count = 0};
    contact_scene scene;
    vbss_context *context;
    uint32_t behind = 0, grown = 0, done = 0;
    pull(&scene, &context, 30000);
    for (uint32_t i = 0; i < 300; i++) {
        const uint32_t before = t.count;
        ((scene_object *)((vbss_slot *)scene.scene)->object)->settings.call_budget =
            i % 20 < 10 ? 30000 : 10000000; /* falls behind, and catches up */
        expect_ok(contact_scene_step(&scene, STEP));
        const vbss_scene_statistics now = statistics_of(scene.scene);
        grown += now.behind > behind;
        done += now.behind == 0 && behind > 0;
        take_all(scene.scene, &t, 32);
        for (uint32_t k = before; k < t.count; k++) {
            if (t.of[k].kind == VBSS_SCENE_EVENT_DEFERRED) {
                assert_int_equal(t.of[k].id, now.behind);
                expect_near(now.behind * STEP, t.of[k].value, 1e-15);
            }
        }
        behind = now.behind;
    }
    const vbss_scene_statistics all = statistics_of(scene.scene);
    assert_true(grown > 5 && done > 5);
    assert_int_equal(count_kind(&t, VBSS_SCENE_EVENT_DEFERRED), grown);
    assert_int_equal(count_kind(&t, VBSS_SCENE_EVENT_CAUGHT_UP), done);
    assert_int_equal(count_kind(&t, VBSS_SCENE_EVENT_TRUNCATED), all.clamped);
    assert_int_equal(count_kind(&t, VBSS_SCENE_EVENT_OVERDUE), all.overdue);
    double paused = 0.0;
    for (uint32_t i = 0; i < t.count; i++) {
        paused += t.of[i].kind == VBSS_SCENE_EVENT_PAUSED ? t.of[i].value : 0.0;
    }
    assert_true(all.paused > 0 && count_kind(&t, VBSS_SCENE_EVENT_PAUSED) >= all.paused);
    assert_true(paused >= all.time_paused - 1e-12);
    expect_ok(contact_scene_destroy(&scene));
    expect_ok(vbss_context_destroy(context));
}

/* A suspended step keeps its events until it is complete; a refused edit, for which it ended and came back,
 * leaves none. */
static void suspended_step_reports_when_complete(void **state)
{
    (void)state;
    contact_scene scene;
    vbss_context *context;
    uint32_t refused = 0, piece;
    pull(&scene, &context, 30000);
    scene_object *s = ((vbss_slot *)scene.scene)->object;
    for (uint32_t i = 0; i < 300; i++) {
        expect_ok(contact_scene_step(&scene, STEP));
        if (!s->cursor.is_suspended) {
            assert_int_equal(s->events.pending_count, 0);
            continue;
        }
        const uint32_t count = waiting(scene.scene), pending = s->events.pending_count;
        const step_events old = step_events_of(scene.scene);
        expect_result(VBSS_ERROR_CAPACITY,
                      vbss_scene_cut_thread(scene.scene, 1, 0.011, &piece)); /* no cut is left */
        const step_events now = step_events_of(scene.scene);
        assert_int_equal(s->events.pending_count, pending);
        assert_true(s->cursor.is_suspended);
        assert_int_equal(waiting(scene.scene), count + 1); /* the cut that was refused */
        assert_memory_equal(old.of, now.of, old.count * sizeof old.of[0]);
        refused++;
    }
    assert_true(refused > 20);
    expect_ok(contact_scene_destroy(&scene));
    expect_ok(vbss_context_destroy(context));
}

/* A tool is exchanged as a step begins. The event is there when that step is complete, and not before. */
static void event_of_suspended_step_waits(void **state)
{
    (void)state;
    static taken t;
    t = (taken){.count = 0};
    contact_scene scene;
    vbss_context *context;
    vbss_grasper *tool;
    const double away[3] = {0.0, 0.3, 0.0};
    uint32_t body, waits = 0;
    pull(&scene, &context, 30000);
    scene_object *s = ((vbss_slot *)scene.scene)->object;
    expect_ok(vbss_grasper_create(context, NULL, &tool));
    expect_ok(vbss_grasper_set_target(tool, away, NULL));
    expect_ok(vbss_scene_add_grasper(scene.scene, tool, &body));
    for (uint32_t i = 0; i < 100; i++) {
        const bool is_driver = i % 2 == 0;
        expect_ok(vbss_grasper_exchange(tool, is_driver ? VBSS_GRASPER_KIND_SHEARS
                                                        : VBSS_GRASPER_KIND_NEEDLE_DRIVER));
        expect_ok(contact_scene_step(&scene, STEP));
        take_all(scene.scene, &t, 32);
        const uint64_t complete =
            ((thread_object *)((vbss_slot *)scene.threads[0])->object)->statistics.steps;
        assert_true(count_kind(&t, VBSS_SCENE_EVENT_EXCHANGED) <= complete);
        waits += s->cursor.is_suspended && s->events.pending_count > 0 &&
                 count_kind(&t, VBSS_SCENE_EVENT_EXCHANGED) == complete;
    }
    assert_true(waits > 5);
    expect_ok(contact_scene_destroy(&scene));
    expect_ok(vbss_context_destroy(context));
}

/* An edit ends a suspended step: what it left out is an event, once. */
static void abandoned_step_is_one_pause(void **state)
{
    (void)state;
    static taken t;
    t = (taken){.count = 0};
    contact_scene scene;
    vbss_context *context;
    pull(&scene, &context, 30000);
    scene_object *s = ((vbss_slot *)scene.scene)->object;
    for (uint32_t i = 0; i < 300 && !s->cursor.is_suspended; i++) {
        expect_ok(contact_scene_step(&scene, STEP));
    }
    assert_true(s->cursor.is_suspended);
    take_all(scene.scene, &t, 32);
    t = (taken){.count = 0};
    const vbss_scene_statistics before = statistics_of(scene.scene);
    expect_ok(vbss_scene_set_thread_friction(scene.scene, 0.25));
    assert_false(s->cursor.is_suspended);
    take_all(scene.scene, &t, 32);
    const vbss_scene_statistics now = statistics_of(scene.scene);
    assert_int_equal(now.paused, before.paused + 1);
    assert_int_equal(count_kind(&t, VBSS_SCENE_EVENT_PAUSED), 1);
    for (uint32_t i = 0; i < t.count; i++) {
        assert_int_equal(t.of[i].step, now.steps); /* between two calls */
        assert_true(t.of[i].time == now.time);
    }
    expect_ok(vbss_scene_step(scene.scene, STEP));
    t = (taken){.count = 0};
    take_all(scene.scene, &t, 32);
    assert_int_equal(count_kind(&t, VBSS_SCENE_EVENT_PAUSED),
                     statistics_of(scene.scene).paused - now.paused);
    expect_ok(contact_scene_destroy(&scene));
    expect_ok(vbss_context_destroy(context));
}

/* ---- what events say */

static void puncture_event_has_force_hole_and_position(void **state)
{
    (void)state;
    static taken t;
    t = (taken){.count = 0};
    harness_memory memory;
    puncture_scene p;
    vbss_scene_config config;
    vbss_drain_config wall;
    vbss_context *context = harness_context(&memory);
    expect_ok(puncture_scene_configs(&config, &wall));
    expect_ok(puncture_scene_create(context, &config, &wall, &p));
    uint32_t found = 0;
    for (uint32_t i = 0; i < 300; i++) {
        const uint32_t before = t.count;
        expect_ok(puncture_scene_step_of(p.scene, 0.1, STEP));
        take_all(p.scene, &t, 32);
        for (uint32_t k = before; k < t.count; k++) {
            const vbss_scene_event *e = &t.of[k];
            vbss_scene_hole hole;
            if (e->kind != VBSS_SCENE_EVENT_PUNCTURE) {
                continue;
            }
            assert_true(e->value >= wall.puncture_force && e->value < 10.0 * wall.puncture_force);
            assert_true(e->body_a == p.needle_body && e->body_b == p.drain_body);
            assert_int_equal(e->flags, VBSS_SCENE_EVENT_FLAG_POSITION);
            for (uint32_t h = 0; vbss_scene_get_hole(p.scene, h, &hole, sizeof hole) == VBSS_OK;
                 h++) {
                if (hole.id == e->id) {
                    found++;
                    expect_near(
                        0.0, vec3_distance(vec3_load(hole.position), vec3_load(e->position)), 1e-9);
                    expect_near(hole.arc_length, e->arc_length, 1e-9);
                }
            }
        }
    }
    assert_true(found >= 1);
    harness_context_end(context, &memory);
}

static void grasp_event_is_where_jaws_hold(void **state)
{
    (void)state;
    static taken t;
    t = (taken){.count = 0};
    harness_memory memory;
    vbss_scene *scene;
    uint32_t grasps = 0;
    vbss_context *context = harness_context(&memory);
    expect_ok(needle_scene_create(context, &scene));
    for (uint32_t i = 0; i < 400; i++) {
        const uint32_t before = t.count;
        expect_ok(needle_scene_step(scene));
        take_all(scene, &t, 32);
        for (uint32_t k = before; k < t.count; k++) {
            const vbss_scene_event *e = &t.of[k];
            vbss_scene_grasp grasp;
            if (e->kind == VBSS_SCENE_EVENT_GRASP) {
                expect_ok(vbss_scene_get_grasp(scene, e->body_b, 0, &grasp, sizeof grasp));
                assert_int_equal(grasp.body, e->body_a);
                expect_near(grasp.arc_length, e->arc_length, 1e-4);
                assert_int_equal(e->flags, VBSS_SCENE_EVENT_FLAG_POSITION);
                expect_near(0.0, vec3_distance(vec3_load(grasp.position), vec3_load(e->position)),
                            1e-3);
                grasps++;
            }
            if (e->kind == VBSS_SCENE_EVENT_SLIP || e->kind == VBSS_SCENE_EVENT_TORN) {
                assert_true(e->value > 0.0);
            }
        }
    }
    assert_true(grasps >= 1);
    harness_context_end(context, &memory);
}

int test_take_events(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(host_at_60_hz_misses_no_event),
        cmocka_unit_test(full_list_keeps_newest_and_counts_lost),
        cmocka_unit_test(failed_step_adds_no_event),
        cmocka_unit_test(restore_empties_list),
        cmocka_unit_test(refused_calls_take_nothing),
        cmocka_unit_test(events_are_struct_size_apart),
        cmocka_unit_test(deferred_truncated_and_paused_match_statistics),
        cmocka_unit_test(suspended_step_reports_when_complete),
        cmocka_unit_test(event_of_suspended_step_waits),
        cmocka_unit_test(abandoned_step_is_one_pause),
        cmocka_unit_test(puncture_event_has_force_hole_and_position),
        cmocka_unit_test(grasp_event_is_where_jaws_hold),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
