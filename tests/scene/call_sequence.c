#include "scene/call_sequence.h"

#include <stdlib.h>

#include "base/error.h"
#include "fixtures/scene_build.h"
#include "fixtures/solver_of.h"

enum { CALLS = 70, MAX_GRASPERS = 3 };

typedef enum call_kind {
    CALL_STEP,
    CALL_RESTORE, /* of its own state: this scene only */
    CALL_RESTORE_FOREIGN,
    CALL_MOVE_RIGID,
    CALL_MOVE_GRASPER,
    CALL_OPEN,
    CALL_EXCHANGE,
    CALL_CUT,
    CALL_PIN,
    CALL_UNPIN,
    CALL_HOLE,
    CALL_REMOVE,
    CALL_ADD_RIGID,
    CALL_ADD_THREAD,
    CALL_ADD_NEEDLE,
    CALL_ADD_GRASPER,
    CALL_ADD_DRAIN,
    CALL_ATTACH,
    CALL_MOVE_ATTACHMENT,
    CALL_DETACH,
    CALL_SET_STATE,
    CALL_SLICE, /* the steps after an edit may be suspended at once */
    CALL_KINDS
} call_kind;

/* How often each kind is drawn, of their sum. */
static const uint32_t shares[CALL_KINDS] = {
    [CALL_STEP] = 60,           [CALL_RESTORE] = 6,      [CALL_RESTORE_FOREIGN] = 1,
    [CALL_MOVE_RIGID] = 8,      [CALL_MOVE_GRASPER] = 8, [CALL_OPEN] = 4,
    [CALL_EXCHANGE] = 1,        [CALL_CUT] = 4,          [CALL_PIN] = 3,
    [CALL_UNPIN] = 2,           [CALL_HOLE] = 2,         [CALL_REMOVE] = 2,
    [CALL_ADD_RIGID] = 3,       [CALL_ADD_THREAD] = 2,   [CALL_ADD_NEEDLE] = 1,
    [CALL_ADD_GRASPER] = 1,     [CALL_ADD_DRAIN] = 1,    [CALL_ATTACH] = 2,
    [CALL_MOVE_ATTACHMENT] = 2, [CALL_DETACH] = 2,       [CALL_SET_STATE] = 1,
    [CALL_SLICE] = 8,
};

typedef struct call {
    call_kind kind;
    uint32_t body, other, small; /* numbers of bodies, and another small number */
    bool has_point;
    double length; /* m, or the length of a step, s; or an opening */
    double point[3], weights[3];
    uint32_t failing; /* this allocation of the call fails, counted from 1; 0: none */
} call;

typedef struct world {
    small s;
    vbss_grasper *graspers[MAX_GRASPERS];
    uint32_t grasper_count;
    void *made; /* the object that a call adds */
} world;

/* ---- draws */

static double draw_length(harness_source *source, double low, double high)
{
    return harness_draw_below(source, 12) == 0 ? harness_draw_any_double(source)
                                               : harness_draw_real(source, low, high);
}

static call_kind draw_kind(harness_source *source)
{
    uint32_t sum = 0, kind = 0;
    for (uint32_t i = 0; i < CALL_KINDS; i++) {
        sum += shares[i];
    }
    uint32_t at = harness_draw_below(source, sum);
    while (at >= shares[kind]) {
        at -= shares[kind++];
    }
    return (call_kind)kind;
}

static call draw_call(harness_source *source)
{
    static const double step_lengths[] = {1e-3, 1e-3, 1e-3, 1e-3, 2e-3, 5e-4, 1e-2, -1.0};
    call c = {.kind = draw_kind(source),
              .body = harness_draw_below(source, 9),
              .other = harness_draw_below(source, 9),
              .small = harness_draw_below(source, 24),
              .has_point = harness_draw_below(source, 2) == 0};
    c.length = c.kind == CALL_STEP   ? step_lengths[harness_draw_below(source, 8)]
               : c.kind == CALL_OPEN ? draw_length(source, -0.1, 1.1)
                                     : draw_length(source, -2e-3, 4e-2);
    for (int k = 0; k < 3; k++) {
        c.point[k] = draw_length(source, -0.015, 0.015);
        c.weights[k] = 1.0 / 3.0;
    }
    c.failing = harness_draw_below(source, 4) == 0 ? 1 + harness_draw_below(source, 6) : 0;
    return c;
}

/* ---- the scenes */

/* Bodies that wait while others take their substeps stay where they are, their prescribed nodes as well. */
static void expect_frozen_bodies_at_rest(void *user, const scene_object *s)
{
    call_counts *counts = user;
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->is_frozen && b->kind == SCENE_BODY_THREAD) {
            const thread_object *t = b->thread.thread;
            assert_memory_equal(t->trial, t->now.x, t->node_count * sizeof *t->trial);
            counts->frozen++;
        } else if (b->is_frozen && b->kind == SCENE_BODY_DRAIN) {
            const drain_object *d = b->drain.drain;
            assert_memory_equal(d->trial, d->x, d->mesh.node_count * sizeof *d->trial);
        } else if (b->is_frozen && b->kind == SCENE_BODY_RIGID) {
            const scene_rigid *r = &b->rigid;
            assert_memory_equal(&r->trial, &r->body.now.pose, sizeof r->trial);
        }
    }
}

static void watch(world *w, call_counts *counts)
{
    scene_object *s = small_object(&w->s);
    s->on_substep = expect_frozen_bodies_at_rest;
    s->on_substep_data = counts;
}

static void draw_config(harness_source *source, vbss_scene_config *c)
{
    static const uint32_t slots[] = {0, 1, 1, 300, 1000, 3000, 210000};
    static const uint32_t works[] = {0, 2000, 20000, 250000};
    c->mode =
        harness_draw_below(source, 6) == 0 ? VBSS_SCENE_MODE_OFFLINE : VBSS_SCENE_MODE_REAL_TIME;
    set_call_operations(c, slots[harness_draw_below(source, 7)]);
    set_step_operations(c, works[harness_draw_below(source, 4)]);
    solver_of(c)->halving_limit = harness_draw_below(source, 6);
    solver_of(c)->attempt_limit = 1 + harness_draw_below(source, 5);
    c->contact_capacity = 12 + harness_draw_below(source, 80);
    c->candidate_capacity = 40 + harness_draw_below(source, 1500);
    c->event_capacity = 1 + harness_draw_below(source, 12);
    c->node_capacity = 70 + harness_draw_below(source, 80);
    c->rigid_capacity = 4 + harness_draw_below(source, 4);
    c->capsule_capacity = 20 + harness_draw_below(source, 20);
    c->pin_capacity = 2 + harness_draw_below(source, 3);
    c->thread_capacity = 2 + harness_draw_below(source, 6);
    c->floor = harness_draw_below(source, 2) == 0;
    c->floor_height = -0.012;
}

static void draw_thread(harness_source *source, vbss_thread_config *c)
{
    c->gravity[1] = -9.81;
    c->segment_count = 8 + harness_draw_below(source, 20);
    c->length = 0.03;
    c->start[0] = -0.015;
    c->start[1] = harness_draw_real(source, 1e-3, 4e-3);
    c->cut_capacity = harness_draw_below(source, 3);
    c->attachment_capacity = 1 + harness_draw_below(source, 3);
    c->mesh =
        harness_draw_below(source, 3) == 0 ? VBSS_THREAD_MESH_ADAPTIVE : VBSS_THREAD_MESH_FIXED;
}

static void add_stick(world *w, vbss_scene_rigid_kind kind, vec3 middle, vec3 half)
{
    (void)small_stick(&w->s, kind, middle, half, 1e-3);
}

static void add_grasper(world *w, vec3 tip)
{
    scene_build_hand hand = scene_build_upright(tip);
    expect_ok(scene_build_grasper(w->s.context, w->s.scene, NULL, &hand,
                                  &w->graspers[w->grasper_count++], NULL));
}

/* A thread falls on sticks beside open jaws; some scenes have a drain below. */
static void create_world(harness_source *source, world *w)
{
    memset(w, 0, sizeof *w);
    small_begin(&w->s);
    draw_config(source, &w->s.config);
    draw_thread(source, &w->s.thread);
    small_create(&w->s);
    w->s.rigid.gravity[1] = -9.81;
    vbss_thread *thread;
    uint32_t body;
    expect_ok(vbss_thread_create(w->s.context, &w->s.thread, &thread));
    if (vbss_scene_add_thread(w->s.scene, thread, &body) != VBSS_OK) {
        expect_ok(vbss_thread_destroy(thread)); /* without the room for all its pieces */
    }
    const vec3 across = vec3_make(0.0, 0.0, 5e-3);
    const double x = harness_draw_real(source, -5e-3, 5e-3);
    add_stick(w, VBSS_SCENE_RIGID_DRIVEN, vec3_make(x, 0.0, 0.0), across);
    add_stick(w, VBSS_SCENE_RIGID_FREE, vec3_make(x + 4e-3, 5e-3, 0.0), across);
    add_stick(w, VBSS_SCENE_RIGID_COUPLED, vec3_make(x - 6e-3, -1e-3, 0.0), across);
    add_grasper(w, vec3_make(0.01, w->s.thread.start[1], 0.0));
    if (harness_draw_below(source, 8) == 0) {
        w->s.drain.position[1] = -0.011;
        (void)small_drain(&w->s, NULL);
    }
}

/* ---- the calls */

/* Creates the object that a call adds, in both scenes alike, or takes one that is in the scene. */
static void make_object(world *w, const call *c)
{
    vbss_needle_config needle;
    w->made = NULL;
    switch (c->kind) {
    case CALL_ADD_THREAD:
        w->s.thread.segment_count = 2 + 2 * c->small;
        w->s.thread.start[1] = 6e-3;
        expect_ok(vbss_thread_create(w->s.context, &w->s.thread, (vbss_thread **)&w->made));
        break;
    case CALL_ADD_NEEDLE:
        expect_ok(vbss_needle_config_init(&needle, sizeof needle));
        needle.position[1] = 0.015;
        needle.gravity[1] = -9.81;
        expect_ok(vbss_needle_create(w->s.context, &needle, (vbss_needle **)&w->made));
        break;
    case CALL_ADD_GRASPER:
        if (c->has_point && w->grasper_count < MAX_GRASPERS) {
            const double away[3] = {0.0, 0.01, 0.01 * w->grasper_count};
            expect_ok(vbss_grasper_create(w->s.context, NULL, (vbss_grasper **)&w->made));
            expect_ok(vbss_grasper_set_target(w->made, away, NULL));
            w->graspers[w->grasper_count++] = w->made;
        } else {
            w->made = w->graspers[0];
        }
        break;
    case CALL_ADD_DRAIN:
        expect_ok(vbss_drain_create(w->s.context, &w->s.drain, (vbss_drain **)&w->made));
        break;
    default:
        break;
    }
}

static vbss_result add(world *w, const call *c, uint32_t *id)
{
    vbss_scene *scene = w->s.scene;
    vbss_scene_rigid_config rigid = w->s.rigid;
    const vbss_scene_capsule capsule = {{0.0, 0.0, -3e-3}, {0.0, 0.0, 3e-3}, 1e-3};
    switch (c->kind) {
    case CALL_ADD_RIGID:
        rigid.kind = (vbss_scene_rigid_kind)(c->small % 3);
        rigid.capsules = &capsule;
        rigid.capsule_count = 1;
        rigid.mass = c->length;
        memcpy(rigid.position, c->point, sizeof rigid.position);
        return vbss_scene_add_rigid(scene, &rigid, id);
    case CALL_ADD_THREAD:
        return vbss_scene_add_thread(scene, w->made, id);
    case CALL_ADD_NEEDLE:
        return vbss_scene_add_needle(scene, w->made, id);
    case CALL_ADD_GRASPER:
        return vbss_scene_add_grasper(scene, w->made, id);
    default:
        return vbss_scene_add_drain(scene, w->made, id);
    }
}

/* Calls on the handle of a thread. */
static vbss_result edit_thread(world *w, const call *c, uint32_t *id)
{
    vbss_thread *thread;
    vbss_thread_attachment a;
    static const double at_rest[3 * 256];
    VBSS_TRY(vbss_scene_get_thread(w->s.scene, c->body, &thread));
    switch (c->kind) {
    case CALL_ATTACH:
        expect_ok(vbss_thread_attachment_init(&a, sizeof a));
        a.kind = (vbss_thread_attachment_kind)(c->other % 4);
        a.node = c->small;
        a.stiffness = 10.0;
        memcpy(a.position, c->point, sizeof a.position);
        return vbss_thread_attach(thread, &a, id);
    case CALL_MOVE_ATTACHMENT:
        return vbss_thread_set_attachment_target(thread, c->other, c->point,
                                                 c->has_point ? c->weights : NULL);
    case CALL_DETACH:
        return vbss_thread_detach(thread, c->other);
    default:
        return vbss_thread_set_state(thread, NULL, at_rest, 9 + c->small);
    }
}

static vbss_result apply(world *w, const call *c, uint32_t *id)
{
    vbss_scene *scene = w->s.scene;
    vbss_grasper *grasper = w->graspers[c->other % w->grasper_count];
    *id = 77;
    switch (c->kind) {
    case CALL_STEP:
        return vbss_scene_step(scene, c->length);
    case CALL_SLICE:
        small_object(&w->s)->cursor.unsliced_steps_left = 0;
        return VBSS_OK;
    case CALL_MOVE_RIGID:
        return vbss_scene_set_rigid_target(scene, c->body, c->point, NULL);
    case CALL_MOVE_GRASPER:
        return vbss_grasper_set_target(grasper, c->point, NULL);
    case CALL_OPEN:
        return vbss_grasper_set_opening(grasper, c->length);
    case CALL_EXCHANGE:
        return vbss_grasper_exchange(grasper, (vbss_grasper_kind)(c->small % 3));
    case CALL_CUT:
        return vbss_scene_cut_thread(scene, c->body, c->length, id);
    case CALL_PIN:
        return vbss_scene_pin_thread(scene, c->body, c->small, c->other,
                                     c->has_point ? c->point : NULL, id);
    case CALL_UNPIN:
        return vbss_scene_unpin_thread(scene, c->other);
    case CALL_HOLE:
        return vbss_scene_make_hole(scene, c->body, c->length, c->other, c->small, c->weights, id);
    case CALL_REMOVE:
        return vbss_scene_remove(scene, c->body);
    case CALL_ATTACH:
    case CALL_MOVE_ATTACHMENT:
    case CALL_DETACH:
    case CALL_SET_STATE:
        return edit_thread(w, c, id);
    default:
        return add(w, c, id);
    }
}

/* ---- what must not change */

typedef struct record_of_state {
    small_state state;
    uint64_t generation, contact_count;
    step_events events;
    uint64_t events_waiting, events_lost;
    double forces[3 * 256];
} record_of_state;

static record_of_state record_state(const world *w)
{
    record_of_state r = {.state = small_save(&w->s)};
    const vbss_view forces = small_view(&w->s, VBSS_SCENE_VIEW_CONTACT_FORCES);
    assert_true(forces.count <= 256);
    r.generation = forces.generation;
    r.events = step_events_of(w->s.scene);
    r.events_waiting = small_object(&w->s)->events.count;
    r.events_lost = small_object(&w->s)->events.lost;
    r.contact_count = forces.count;
    for (uint64_t i = 0; i < forces.count; i++) {
        vec3_store(r.forces + 3 * i, small_vector(&w->s, VBSS_SCENE_VIEW_CONTACT_FORCES, i));
    }
    return r;
}

static void expect_unchanged(const world *w, const record_of_state *before, const call *c)
{
    record_of_state now = record_state(w);
    const bool is_step = c->kind == CALL_STEP;
    assert_int_equal(now.state.count, before->state.count);
    assert_memory_equal(now.state.bytes, before->state.bytes, now.state.count);
    if (!is_step) {
        assert_true(now.generation == before->generation);
    }
    if (c->kind != CALL_CUT) { /* a cut for which there is no piece is an event */
        assert_int_equal(now.events_waiting, before->events_waiting);
        assert_int_equal(now.events_lost, before->events_lost);
        assert_memory_equal(&now.events, &before->events, sizeof now.events);
    }
    assert_int_equal(now.contact_count, before->contact_count);
    assert_memory_equal(now.forces, before->forces, sizeof *now.forces * 3 * now.contact_count);
    free(now.state.bytes);
}

/* ---- a sequence */

static bool is_suspended(const world *w)
{
    return small_object(&w->s)->cursor.is_suspended;
}

static void restore(world *w, call_counts *counts)
{
    small_state saved = small_save(&w->s);
    counts->restores++;
    counts->restores_suspended += is_suspended(w);
    expect_ok(vbss_scene_restore(w->s.scene, saved.bytes, saved.count));
    free(saved.bytes);
}

/* A valid envelope with the state of another scene, which is refused halfway. */
static vbss_result restore_foreign(world *w)
{
    small other;
    small_begin(&other);
    other.config = w->s.config;
    small_create(&other);
    small_state saved = small_save(&other);
    const vbss_result result = vbss_scene_restore(w->s.scene, saved.bytes, saved.count);
    free(saved.bytes);
    small_end(&other);
    return result;
}

static vbss_result call_first(world *w, const call *c, uint32_t *id, call_counts *counts)
{
    const record_of_state before = record_state(w);
    harness_memory *memory = &w->s.memory;
    const bool suspended = is_suspended(w);
    const uint64_t failures = memory->failures;
    memory->fail_call = c->failing > 0 ? memory->calls + c->failing : 0;
    const vbss_result result =
        c->kind == CALL_RESTORE_FOREIGN ? restore_foreign(w) : apply(w, c, id);
    memory->fail_call = 0;
    counts->calls++;
    counts->failed_allocations += memory->failures - failures;
    if (result != VBSS_OK) {
        counts->refused++;
        counts->refused_suspended += suspended;
        counts->failed_steps += c->kind == CALL_STEP && result == VBSS_ERROR_CAPACITY;
        assert_int_equal(*id, 77);
        expect_unchanged(w, &before, c);
    }
    free(before.state.bytes);
    return result;
}

void call_sequence(harness_source *source, void *user)
{
    call_counts *counts = user;
    harness_source again = *source;
    world one, other;
    create_world(source, &one);
    create_world(&again, &other);
    watch(&one, counts);
    watch(&other, counts);
    for (int i = 0; i < CALLS; i++) {
        const call c = draw_call(source);
        uint32_t id = 77, same;
        if (c.kind == CALL_RESTORE) {
            restore(&one, counts);
        } else {
            make_object(&one, &c);
            make_object(&other, &c);
            if (call_first(&one, &c, &id, counts) == VBSS_OK) {
                expect_ok(apply(&other, &c, &same));
                assert_int_equal(same, id);
            }
        }
        counts->grouped += is_suspended(&one) && small_object(&one.s)->cursor.group_count > 1;
        if (small_hash(&one.s) != small_hash(&other.s)) {
            fail_msg("call %d of kind %d: the scenes differ", i, (int)c.kind);
        }
    }
    small_end(&one.s);
    small_end(&other.s);
}

void call_sequence_expect_variety(const call_counts *counts)
{
    if (counts->calls > (size_t)10 * CALLS) {
        assert_true(counts->refused > counts->calls / 5);
        assert_true(counts->refused_suspended > counts->calls / 100);
        assert_true(counts->failed_steps > counts->calls / 100);
        assert_true(counts->failed_allocations > counts->calls / 500);
        assert_true(counts->restores_suspended > counts->calls / 500);
        assert_true(counts->grouped > counts->calls / 200);
        assert_true(counts->frozen > counts->calls / 200);
    }
}
