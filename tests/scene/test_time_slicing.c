/* Steps that are made in several calls: the same bits, saved and restored in their midst, whatever hosts look at and tell
 * meanwhile; and no more work in a call than there is room for. */
#include <stdlib.h>
#include <string.h>

#include "fixtures/baseline_of.h"
#include "fixtures/solver_of.h"
#include "scene/drains_rig.h"
#include "scene/pulled_surgeons.h"
#include "scene/small.h"
#include "scene/api/api.h"
#include "scene/world/world.h"
#include "fixtures/needle_scenes.h"
#include "fixtures/puncture_scenes.h"
#include "fixtures/scene_body.h"

#define STEP 1e-3

static scene_object *object_of(void *scene)
{
    return ((vbss_slot *)scene)->object;
}

static vbss_scene_statistics statistics_of(vbss_scene *scene)
{
    vbss_scene_statistics c;
    expect_ok(vbss_scene_get_statistics(scene, &c, sizeof c));
    return c;
}

static uint64_t hash_of(vbss_scene *scene)
{
    uint64_t hash;
    expect_ok(vbss_scene_get_hash(scene, &hash));
    return hash;
}

/* ---- a knot whose ends are pulled, then held */

typedef struct pulled {
    vbss_context *context;
    contact_scene scene;
} pulled;

static void begin(pulled *p, uint32_t slot)
{
    contact_scene_options o;
    *p = (pulled){0};
    pulled_surgeons_init(&o);
    set_call_operations(&o.scene, slot);
    expect_ok(vbss_context_create(NULL, &p->context));
    expect_ok(contact_scene_create(p->context, &o, &p->scene));
}

static void end(pulled *p)
{
    expect_ok(contact_scene_destroy(&p->scene));
    expect_ok(vbss_context_destroy(p->context));
}

static const thread_object *thread_of(const pulled *p)
{
    return ((const vbss_slot *)p->scene.threads[0])->object;
}

/* Steps of which the thread has come to the end. */
static uint64_t finished(const pulled *p)
{
    return thread_of(p)->statistics.steps;
}

static void expect_same_state(const pulled *one, const pulled *other)
{
    const thread_object *a = thread_of(one), *b = thread_of(other);
    const size_t bytes = a->node_count * sizeof(vec3);
    assert_memory_equal(a->now.x, b->now.x, bytes);
    assert_memory_equal(a->now.v, b->now.v, bytes);
    assert_memory_equal(a->now.tension, b->now.tension, (a->node_count - 1) * sizeof(double));
    const contact_set *c = object_of(one->scene.scene)->contacts,
                      *d = object_of(other->scene.scene)->contacts;
    assert_int_equal(c->warm_start_count, d->warm_start_count);
}

/* Hands are drawn to and fro, and what one host tells by the number of the step, the other does by the steps that it sees begun. */
static void report(pulled *p, uint64_t step)
{
    for (uint32_t i = 0; i < p->scene.hand_count; i++) {
        const contact_hand *hand = &p->scene.hands[i];
        thread_object *t = ((vbss_slot *)hand->thread)->object;
        thread_attachment *a;
        double target[3];
        expect_ok(vbss_thread_find_attachment(t, hand->id, &a));
        const double travel = step % 80 < 40 ? 2e-5 : -2e-5;
        vec3_store(target, vec3_add(a->target, vec3_make(i == 0 ? -travel : travel, 0.0, 0.0)));
        expect_ok(vbss_thread_set_attachment_target(hand->thread, hand->id, target, NULL));
    }
}

enum { PULLED = 250, COMPARED = 300 };

static void divided_steps_are_bit_equal(void **state)
{
    (void)state;
    const uint32_t slots[] = {1, 20000, 60000, 150000};
    for (int k = 0; k < 4; k++) {
        pulled whole, divided;
        begin(&whole, 0);
        begin(&divided, 0);
        for (int i = 0; i < PULLED; i++) {
            expect_ok(contact_scene_step(&whole.scene, STEP));
            expect_ok(contact_scene_step(&divided.scene, STEP));
        }
        scene_object *s = object_of(divided.scene.scene);
        s->settings.call_budget = slots[k];
        uint64_t reported = 0, calls = 0;
        while (finished(&divided) < PULLED + COMPARED) {
            const uint64_t before = finished(&divided),
                           begun = before + s->cursor.is_suspended - PULLED;
            s->cursor.steps_behind =
                0; /* a call begins one step at most, of which is known what it was told */
            if (reported == begun) {
                report(&divided, reported++);
            }
            expect_ok(vbss_scene_step(divided.scene.scene, STEP));
            calls++;
            assert_in_range(finished(&divided), before,
                            before + 2); /* and the next, that is light */
            for (uint64_t i = before; i < finished(&divided); i++) {
                report(&whole, i - PULLED);
                expect_ok(vbss_scene_step(whole.scene.scene, STEP));
            }
            if (finished(&divided) > before &&
                (!s->cursor.is_suspended ||
                 s->cursor.substep.start_fraction ==
                     0.0)) { /* the next may have gone a part of its way */
                expect_same_state(&whole, &divided);
            }
        }
        assert_true(k == 3 || calls > COMPARED * 3 / 2);
        assert_true(statistics_of(divided.scene.scene).deferred > (k < 3 ? COMPARED / 2 : 10));
        end(&whole);
        end(&divided);
    }
}

/* Of all work, also of the step that waits. */
static uint64_t work_of(const scene_object *s)
{
    return s->report.statistics.operations + (s->cursor.is_suspended ? s->cursor.operations : 0);
}

static void call_stays_within_budget(void **state)
{
    (void)state;
    const uint32_t slots[] = {20000, 60000, 100000, 200000};
    for (int k = 0; k < 4; k++) {
        pulled p;
        uint32_t whole = 0, calls = 0, overdue = 0;
        uint64_t largest = 0, beside = 0;
        begin(&p, slots[k]);
        expect_ok(contact_scene_step(&p.scene, STEP)); /* the first is made at once */
        scene_object *s = object_of(p.scene.scene);
        for (int i = 0; i < 800; i++) {
            const uint64_t before = work_of(s), refused = s->report.statistics.rejected_guard;
            expect_ok(contact_scene_step(&p.scene, STEP));
            assert_in_range(s->cursor.steps_behind + s->cursor.is_suspended, 0, 2);
            assert_int_equal(s->report.statistics.behind,
                             s->cursor.steps_behind + s->cursor.is_suspended);
            assert_false(
                s->cursor.is_suspended &&
                s->cursor.substep.uses_trial_motion); /* no saved state could tell its ways */
            if (s->report.statistics.rejected_guard >
                refused) { /* what follows one that the guard refused is not divided */
                whole++;
                continue;
            }
            if (s->report.statistics.overdue > overdue) { /* the fourth call completes a step */
                overdue = s->report.statistics.overdue;
                calls++;
                continue;
            }
            const uint64_t work = work_of(s) - before;
            largest = work > largest ? work : largest;
            beside = vbss_scene_attempt_cost(s);
            calls++;
        }
        /* An attempt that begins is prepared, whatever room there is; and what is about to wait has been prepared. */
        assert_in_range(largest, slots[k] / 2, slots[k] + 2 * beside);
        assert_true(whole > 0 && whole < calls / 20);
        assert_in_range(overdue, slots[k] == 20000, calls / 2);
        vbss_scene_statistics c = statistics_of(p.scene.scene);
        assert_true(c.deferred > 30);
        /* Each call has made its step, or it is counted where that is. */
        assert_true(finished(&p) + c.behind + c.paused >= c.steps);
        assert_true(finished(&p) + c.behind <= c.steps);
        end(&p);
    }
}

/* ---- saved and restored, as bodies of the harness with calls that have little room */

static const harness_body *inside;
static uint32_t inside_slot;

static vbss_result create_divided(vbss_context *context, void *user, void **handle)
{
    VBSS_TRY(inside->create(context, user, handle));
    object_of(*handle)->settings.call_budget = inside_slot;
    return VBSS_OK;
}

static harness_body divide(const harness_body *body, uint32_t slot)
{
    harness_body divided = *body;
    inside = body;
    inside_slot = slot;
    divided.create = create_divided;
    return divided;
}

static uint64_t waited_in(const harness_body *body, size_t steps)
{
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    void *scene = NULL;
    uint64_t waited = 0;
    expect_ok(body->create(context, body->user, &scene));
    for (size_t i = 0; i < steps; i++) {
        expect_ok(body->step(scene));
        waited += object_of(scene)->cursor.is_attempt_suspended;
    }
    harness_context_end(context, &memory);
    return waited;
}

static vbss_result needle_create(vbss_context *context, void *user, void **handle)
{
    vbss_scene *scene = NULL;
    (void)user;
    VBSS_TRY(needle_scene_create(context, &scene));
    *handle = scene;
    return VBSS_OK;
}

static vbss_result needle_step(void *handle)
{
    return needle_scene_step(handle);
}

static vbss_result puncture_create(vbss_context *context, void *user, void **handle)
{
    vbss_scene_config config;
    vbss_drain_config wall;
    puncture_scene made;
    (void)user;
    VBSS_TRY(puncture_scene_configs(&config, &wall));
    vbss_result result = puncture_scene_create(context, &config, &wall, &made);
    *handle = made.scene;
    return result;
}

static vbss_result puncture_step(void *handle)
{
    return puncture_scene_step_of(handle, 0.1, STEP);
}

static const harness_body needle = {"divided needle", &vbss_scene_kind,    needle_create, NULL,
                                    needle_step,      drains_body_destroy, NULL};
static const harness_body pricked = {"divided pricked drain",
                                     &vbss_scene_kind,
                                     puncture_create,
                                     NULL,
                                     puncture_step,
                                     drains_body_destroy,
                                     NULL};

static void expect_going_on(const harness_body *plain, uint32_t slot, const size_t *moments,
                            int count)
{
    const harness_body body = divide(plain, slot);
    assert_true(waited_in(&body, moments[count - 1] + 30) > 20);
    harness_save_restore_continue_at(&body, moments, (size_t)count, 30);
}

static void restored_suspended_step_continues_bit_equal(void **state)
{
    (void)state;
    const size_t drains[] = {12, 60, 61, 62, 63, 150, 151, 152, 205};
    const size_t leaps[] = {LEAP_AT,     LEAP_AT + 1, LEAP_AT + 2, LEAP_AT + 3,
                            LEAP_AT + 5, LEAP_AT + 8, 40};
    const size_t needles[] = {NEEDLE_SCENE_TAKEN, NEEDLE_SCENE_TAKEN + 1, NEEDLE_SCENE_TAKEN + 2,
                              NEEDLE_SCENE_BOTH};
    const size_t pricks[] = {66, 67, 68, 69, 70, 71, 180, 181, 182, 183};
    const size_t scenes[] = {12, 40, 41, 42, 250};
    drain_hands hands;
    vbss_scene_config config;
    expect_ok(drain_hands_init(&hands));
    expect_ok(vbss_scene_config_init(&config, sizeof config));
    const harness_body drain = drains_as_body(&hands), leap = leap_as_body(&config);
    for (uint32_t slot = 1; slot <= 30001; slot += 15000) {
        expect_going_on(&drain, slot, drains, 9);
        expect_going_on(&leap, slot, leaps, 7);
        expect_going_on(&pricked, slot, pricks, 10);
    }
    expect_going_on(&needle, 1, needles, 4);
    expect_going_on(&needle, 10000, needles, 4);
    for (int k = 0; k < 2; k++) {
        scene_scene_kind kind = k == 0 ? SCENE_SCENE_KNOT : SCENE_SCENE_TOOLS;
        const harness_body scene = scene_as_body(&kind);
        expect_going_on(&scene, 1, scenes, 5);
        expect_going_on(&scene, 4000, scenes, 5);
    }
}

static void damaged_suspended_snapshots_are_rejected(void **state)
{
    (void)state;
    vbss_scene_config config;
    expect_ok(vbss_scene_config_init(&config, sizeof config));
    const harness_body leap = leap_as_body(&config);
    const harness_body body = divide(&leap, 1);
    harness_refuses_bad_snapshots(&body, LEAP_AT + 2);
}

static void suspended_steps_do_not_allocate(void **state)
{
    (void)state;
    vbss_scene_config config;
    expect_ok(vbss_scene_config_init(&config, sizeof config));
    const harness_body leap = leap_as_body(&config);
    const harness_body body = divide(&leap, 20000);
    assert_int_equal(harness_step_allocations(&body, 60), 0);
}

/* ---- hosts between two calls */

static void read_all_views(const pulled *p)
{
    vbss_view v;
    vbss_thread_statistics t;
    for (vbss_thread_field field = 0; field <= VBSS_THREAD_VIEW_CURVATURES; field++) {
        expect_ok(vbss_thread_get_view(p->scene.threads[0], field, &v, sizeof v));
    }
    for (vbss_scene_field field = 0; field <= VBSS_SCENE_VIEW_CONTACT_GAPS; field++) {
        expect_ok(vbss_scene_get_view(p->scene.scene, field, &v, sizeof v));
    }
    expect_ok(vbss_thread_get_statistics(p->scene.threads[0], &t, sizeof t));
    (void)hash_of(p->scene.scene);
}

/* Views are worked out in rooms that a step uses, too. */
static void queries_during_suspension_change_nothing(void **state)
{
    (void)state;
    pulled seen, unseen;
    begin(&seen, 30000);
    begin(&unseen, 30000);
    uint32_t waited = 0;
    for (int i = 0; i < 300; i++) {
        expect_ok(contact_scene_step(&seen.scene, STEP));
        expect_ok(contact_scene_step(&unseen.scene, STEP));
        waited += object_of(seen.scene.scene)->cursor.is_attempt_suspended;
        read_all_views(&seen);
        assert_true(hash_of(seen.scene.scene) == hash_of(unseen.scene.scene));
    }
    assert_true(waited > 100);
    end(&seen);
    end(&unseen);
}

/* A thread whose clamp is turned, in steps of a few operations, the last of which an edit ends. With `is_viewed`, a
 * host queries the thread after each call. */
static uint64_t hash_of_turned_clamp(bool is_viewed)
{
    small s;
    vbss_thread *thread;
    vbss_view v;
    uint32_t id, suspended = 0;
    vbss_thread_attachment a;
    small_begin(&s);
    set_call_operations(&s.config, 500);
    small_create(&s);
    small_thread(&s, vec3_zero(), vec3_make(0.02, 0.0, 0.0), 10, &thread);
    expect_ok(vbss_thread_attachment_init(&a, sizeof a));
    a.kind = VBSS_THREAD_ATTACHMENT_CLAMP;
    a.node = 4;
    vec3_store(a.position, vec3_make(8e-3, 0.0, 0.0));
    expect_ok(vbss_thread_attach(thread, &a, &id));
    for (uint32_t i = 0; i < 62; i++) {
        const double direction[3] = {1.0, 0.02 * i, 0.0};
        expect_ok(vbss_thread_set_attachment_target(thread, id, a.position, direction));
        small_steps(&s, 1, STEP);
        suspended += small_statistics(&s).behind > 0;
        if (is_viewed) {
            expect_ok(vbss_thread_get_view(thread, VBSS_THREAD_VIEW_CURVATURES, &v, sizeof v));
        }
    }
    assert_true(suspended > 10 && small_object(&s)->cursor.is_attempt_in_memory);
    small_stick(&s, VBSS_SCENE_RIGID_FREE, vec3_make(0.1, 0.0, 0.0), vec3_make(1e-3, 0.0, 0.0),
                1e-3);
    const uint64_t hash = small_hash(&s);
    small_end(&s);
    return hash;
}

static void query_of_suspended_clamp_changes_nothing(void **state)
{
    (void)state;
    assert_true(hash_of_turned_clamp(true) == hash_of_turned_clamp(false));
}

/* The drain's forces are such a room. */
static void drain_queries_during_suspension_change_nothing(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    void *seen = NULL, *unseen = NULL;
    uint32_t waited = 0;
    inside_slot = 1;
    inside = &pricked;
    expect_ok(create_divided(context, NULL, &seen));
    expect_ok(create_divided(context, NULL, &unseen));
    for (int i = 0; i < 600; i++) {
        expect_ok(puncture_step(seen));
        expect_ok(puncture_step(unseen));
        waited += object_of(seen)->cursor.is_attempt_suspended;
        for (vbss_drain_field field = 0; field <= VBSS_DRAIN_VIEW_CURVATURES; field++) {
            vbss_view v;
            expect_ok(vbss_drain_get_view(drains_rig_of(seen), field, &v, sizeof v));
        }
        assert_true(hash_of(seen) == hash_of(unseen));
    }
    assert_true(waited > 300);
    harness_context_end(context, &memory);
}

static void step_until_it_waits(pulled *p)
{
    for (int i = 0; i < 400 || !object_of(p->scene.scene)->cursor.is_attempt_suspended; i++) {
        assert_true(i < 2000);
        expect_ok(contact_scene_step(&p->scene, STEP));
    }
}

/* A ball far from everything. */
static vbss_result add_ball(vbss_scene *scene, uint32_t *body)
{
    vbss_scene_rigid_config ball;
    const vbss_scene_capsule capsule = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 1e-3};
    expect_ok(vbss_scene_rigid_config_init(&ball, sizeof ball));
    ball.capsules = &capsule;
    ball.capsule_count = 1;
    ball.position[1] = 0.5;
    return vbss_scene_add_rigid(scene, &ball, body);
}

/* Whoever changes more than where things go has the rest of the step left out, and it is counted; for a while no step
 * waits then. */
static void edits_end_suspended_step(void **state)
{
    (void)state;
    for (int how = 0; how < 2; how++) {
        pulled p;
        begin(&p, 30000);
        step_until_it_waits(&p);
        const uint64_t done = finished(&p), paused = statistics_of(p.scene.scene).paused;
        const thread_object *t = thread_of(&p);
        const vec3 there = t->now.x[t->node_count / 2];
        vbss_thread_attachment mass;
        uint32_t id;
        if (how == 0) { /* by the thread's own handle: seen by the next call */
            expect_ok(vbss_thread_attachment_init(&mass, sizeof mass));
            mass.kind = VBSS_THREAD_ATTACHMENT_MASS;
            mass.node = 5;
            mass.mass = 1e-6;
            expect_ok(vbss_thread_attach(p.scene.threads[0], &mass, &id));
            assert_true(object_of(p.scene.scene)->cursor.is_suspended);
            expect_ok(contact_scene_step(&p.scene, STEP));
            assert_true(finished(&p) > done);
        } else { /* by the scene's: at once, where everything is */
            const uint64_t hash = hash_of(p.scene.scene);
            expect_result(VBSS_ERROR_NULL_ARGUMENT, add_ball(p.scene.scene, NULL));
            assert_true(object_of(p.scene.scene)->cursor.is_suspended);
            assert_true(hash_of(p.scene.scene) == hash); /* a refused edit does nothing */
            expect_ok(add_ball(p.scene.scene, &id));
            assert_false(object_of(p.scene.scene)->cursor.is_suspended);
            assert_int_equal(finished(&p), done + 1);
            assert_memory_equal(&there, &t->now.x[t->node_count / 2], sizeof there);
        }
        assert_true(statistics_of(p.scene.scene).paused > paused);
        const uint64_t deferred = statistics_of(p.scene.scene).deferred;
        for (int i = 0; i < 20; i++) {
            expect_ok(contact_scene_step(&p.scene, STEP));
            assert_false(object_of(p.scene.scene)->cursor.is_suspended);
        }
        assert_in_range(statistics_of(p.scene.scene).deferred, deferred, deferred + 20);
        end(&p);
    }
}

/* Also between two parts, and by a scene that was restored there. */
static void restored_abandoned_step_is_bit_equal(void **state)
{
    (void)state;
    for (int attempted = 0; attempted < 2; attempted++) {
        pulled p, other;
        begin(&p, 100000);
        begin(&other, 100000);
        for (int i = 0; i < 37; i++) {
            expect_ok(contact_scene_step(&other.scene, STEP));
        }
        scene_object *s = object_of(p.scene.scene);
        for (int i = 0; i < 150 || !s->cursor.is_suspended ||
                        s->cursor.is_attempt_suspended != (attempted != 0);
             i++) {
            assert_true(i < 3000);
            expect_ok(contact_scene_step(&p.scene, STEP));
        }
        const small saved = {.scene = p.scene.scene};
        small_state kept = small_save(&saved);
        expect_ok(vbss_scene_restore(other.scene.scene, kept.bytes, kept.count));
        for (int k = 0; k < 2; k++) {
            uint32_t ball;
            expect_ok(add_ball(k == 0 ? p.scene.scene : other.scene.scene, &ball));
        }
        assert_false(s->cursor.is_suspended);
        assert_true(hash_of(p.scene.scene) == hash_of(other.scene.scene));
        for (int i = 0; i < 20; i++) {
            expect_ok(vbss_scene_step(p.scene.scene, STEP));
            expect_ok(vbss_scene_step(other.scene.scene, STEP));
            assert_true(hash_of(p.scene.scene) == hash_of(other.scene.scene));
        }
        free(kept.bytes);
        end(&p);
        end(&other);
    }
}

/* Where driven bodies shall go is told for the next step while one waits. */
static void commands_during_suspension_apply_to_next_step(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    set_call_operations(&s.config, 1);
    s.config.drain_capacity = 0;
    small_create(&s);
    (void)small_thread(&s, vec3_make(0.0, 1e-3, 0.0), vec3_make(8e-3, 1e-3, 0.0), 8, NULL);
    uint32_t rod = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(4e-3, 2e-3, 0.0),
                               vec3_make(0.0, 0.0, 2e-3), 5e-4);
    small_steps(&s, 3, STEP);
    scene_object *o = small_object(&s);
    assert_true(o->cursor.is_suspended);
    const pose goes = o->bodies[1].rigid.body.target_end;
    const double reported[3] = {4e-3, 2.1e-3, 1e-4};
    expect_ok(vbss_scene_set_rigid_target(s.scene, rod, reported, NULL));
    assert_memory_equal(&goes, &o->bodies[1].rigid.body.target_end, sizeof goes);
    vbss_scene_rigid_state seen = small_rigid(&s, rod);
    for (int k = 0; k < 3; k++) {
        expect_near(reported[k], seen.target_position[k], 1e-12);
    }
    small_state kept = small_save(&s); /* a saved state knows it */
    for (int variant = 0; variant < 2; variant++) {
        for (int i = 0; i < 60; i++) {
            small_steps(&s, 1, STEP);
        }
        vbss_scene_rigid_state there = small_rigid(&s, rod);
        for (int k = 0; k < 3; k++) {
            expect_near(reported[k], there.position[k], 1e-12);
        }
        expect_ok(vbss_scene_restore(s.scene, kept.bytes, kept.count));
        assert_memory_equal(&goes, &o->bodies[1].rigid.body.target_end, sizeof goes);
    }
    free(kept.bytes);
    small_end(&s);
}

/* What is damaged under a right checksum is refused, or is a step that goes on, or is told not to. */
static void damaged_suspended_states_are_rejected_or_continue(void **state)
{
    (void)state;
    enum { LAST = 700 }; /* bytes: the step that waits is at the end */
    small s;
    small_begin(&s);
    set_call_operations(&s.config, 1);
    s.config.drain_capacity = 0;
    small_create(&s);
    uint32_t line =
        small_thread(&s, vec3_make(0.0, 1e-3, 0.0), vec3_make(8e-3, 1e-3, 0.0), 8, NULL);
    (void)small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(4e-3, 2e-3, 0.0),
                      vec3_make(0.0, 0.0, 2e-3), 5e-4);
    small_pin(&s, line, 0, 0);
    small_steps(&s, 3, STEP);
    assert_true(small_object(&s)->cursor.is_attempt_suspended);
    small_state good = small_save(&s);
    uint8_t *bad = malloc(good.count);
    assert_non_null(bad);
    uint32_t taken = 0, refused = 0;
    const size_t end = harness_state_end(good.bytes, good.count);
    for (size_t at = end - LAST; at < end; at++) {
        for (int bit = 0; bit < 8; bit++) {
            memcpy(bad, good.bytes, good.count);
            bad[at] ^= (uint8_t)(1u << bit);
            harness_seal_snapshot(bad, good.count);
            if (vbss_scene_restore(s.scene, bad, good.count) != VBSS_OK) {
                refused++;
                continue;
            }
            taken++;
            for (int i = 0; i < 6; i++) {
                vbss_result result = vbss_scene_step(s.scene, STEP);
                assert_true(result == VBSS_OK || result == VBSS_ERROR_CAPACITY ||
                            result == VBSS_ERROR_NOT_FINITE || result == VBSS_ERROR_OUT_OF_RANGE);
            }
        }
    }
    assert_true(taken > 500 && refused > 500);
    expect_ok(vbss_scene_restore(s.scene, good.bytes, good.count));
    small_steps(&s, 3, STEP);
    free(bad);
    free(good.bytes);
    small_end(&s);
}

/* Method VBLAST has no attempts that could wait: a state that says so is refused. */
static void paper_steps_are_never_suspended(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    s.config.method = s.thread.method = VBSS_METHOD_VBLAST;
    baseline_of(&s.thread.baseline)->thread_substeps = 20;
    small_create(&s);
    (void)small_thread(&s, vec3_make(0.0, 1e-3, 0.0), vec3_make(8e-3, 1e-3, 0.0), 8, NULL);
    small_steps(&s, 2, STEP);
    scene_step_cursor *cursor = &small_object(&s)->cursor;
    for (int how = 0; how < 2; how++) {
        *cursor =
            (scene_step_cursor){.substep = {.step_length = STEP}, .initial_size = 1.0, .size = 1.0};
        cursor->is_suspended = how == 0;
        cursor->steps_behind = how == 0 ? 0 : 1;
        small_state bad = small_save(&s);
        *cursor = (scene_step_cursor){0};
        expect_result(VBSS_ERROR_CORRUPT, vbss_scene_restore(s.scene, bad.bytes, bad.count));
        free(bad.bytes);
    }
    small_end(&s);
}

static void unlimited_calls_complete_their_step(void **state)
{
    (void)state;
    for (int how = 0; how < 3; how++) {
        pulled p;
        begin(&p, how == 2 ? 0 : 1);
        scene_object *s = object_of(p.scene.scene);
        s->config.mode = how == 0 ? VBSS_SCENE_MODE_OFFLINE : VBSS_SCENE_MODE_REAL_TIME;
        s->settings.step_budget = how == 1 ? 0 : s->settings.step_budget;
        for (int i = 0; i < 60; i++) {
            expect_ok(contact_scene_step(&p.scene, STEP));
            assert_false(s->cursor.is_suspended);
        }
        assert_int_equal(finished(&p), 60);
        assert_int_equal(statistics_of(p.scene.scene).deferred, 0);
        end(&p);
    }
}

/* ---- the test */

int test_time_slicing(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(divided_steps_are_bit_equal),
        cmocka_unit_test(call_stays_within_budget),
        cmocka_unit_test(restored_suspended_step_continues_bit_equal),
        cmocka_unit_test(damaged_suspended_snapshots_are_rejected),
        cmocka_unit_test(suspended_steps_do_not_allocate),
        cmocka_unit_test(queries_during_suspension_change_nothing),
        cmocka_unit_test(query_of_suspended_clamp_changes_nothing),
        cmocka_unit_test(drain_queries_during_suspension_change_nothing),
        cmocka_unit_test(edits_end_suspended_step),
        cmocka_unit_test(restored_abandoned_step_is_bit_equal),
        cmocka_unit_test(commands_during_suspension_apply_to_next_step),
        cmocka_unit_test(damaged_suspended_states_are_rejected_or_continue),
        cmocka_unit_test(paper_steps_are_never_suspended),
        cmocka_unit_test(unlimited_calls_complete_their_step),
    };
    return cmocka_run_group_tests_name("scene.time_slicing", tests, NULL, NULL);
}
