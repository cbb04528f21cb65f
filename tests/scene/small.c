#include "scene/small.h"
#include "fixtures/scene_build.h"

#include <stdlib.h>

void small_begin(small *s)
{
    memset(s, 0, sizeof *s);
    s->context = harness_context(&s->memory);
    expect_ok(vbss_scene_config_init(&s->config, sizeof s->config));
    expect_ok(vbss_thread_config_init(&s->thread, sizeof s->thread));
    expect_ok(vbss_scene_rigid_config_init(&s->rigid, sizeof s->rigid));
    expect_ok(vbss_drain_config_init(&s->drain, sizeof s->drain));
    s->config.thread_capacity = s->config.rigid_capacity = 8;
    s->config.node_capacity = 200;
    s->config.contact_capacity = 256;
    s->config.candidate_capacity = 4096;
    s->thread.gravity[1] = 0.0;
}

void small_create(small *s)
{
    expect_ok(vbss_scene_create(s->context, &s->config, &s->scene));
}

void small_begin_scene(small *s)
{
    small_begin(s);
    small_create(s);
}

void small_end(small *s)
{
    harness_context_end(s->context, &s->memory);
}

/* ---- bodies */

uint32_t small_thread(small *s, vec3 begin, vec3 end, uint32_t segments, vbss_thread **thread)
{
    uint32_t body = 0;
    s->thread.segment_count = segments;
    s->thread.length = vec3_distance(begin, end);
    vec3_store(s->thread.start, begin);
    vec3_store(s->thread.direction, vec3_sub(end, begin));
    expect_ok(scene_build_thread(s->context, s->scene, &s->thread, thread, &body));
    return body;
}

uint32_t small_drain(small *s, vbss_drain **drain)
{
    uint32_t body = 0;
    expect_ok(scene_build_drain(s->context, s->scene, &s->drain, drain, &body));
    return body;
}

uint32_t small_capsule(small *s, vbss_scene_rigid_kind kind, vec3 begin, vec3 end, double radius)
{
    uint32_t body = 0;
    s->rigid.kind = kind;
    expect_ok(scene_build_capsule(s->scene, &s->rigid, scene_build_rod(begin, end, radius), &body));
    return body;
}

uint32_t small_stick(small *s, vbss_scene_rigid_kind kind, vec3 middle, vec3 half, double radius)
{
    vec3_store(s->rigid.position, middle);
    uint32_t body = small_capsule(s, kind, vec3_neg(half), half, radius);
    vec3_store(s->rigid.position, vec3_zero());
    return body;
}

void small_move(small *s, uint32_t body, vec3 position)
{
    double p[3];
    vec3_store(p, position);
    expect_ok(vbss_scene_set_rigid_target(s->scene, body, p, NULL));
}

uint32_t small_pin(small *s, uint32_t thread, uint32_t node, uint32_t body)
{
    uint32_t pin = 0;
    expect_ok(vbss_scene_pin_thread(s->scene, thread, node, body, NULL, &pin));
    return pin;
}

void small_pin_ends(small *s, uint32_t thread, uint32_t nodes)
{
    (void)small_pin(s, thread, 0, 0);
    (void)small_pin(s, thread, nodes - 1, 0);
}

void small_steps(small *s, uint32_t count, double h)
{
    for (uint32_t i = 0; i < count; i++) {
        expect_ok(vbss_scene_step(s->scene, h));
    }
}

/* ---- looks */

uint64_t small_hash(const small *s)
{
    uint64_t hash = 0;
    expect_ok(vbss_scene_get_hash(s->scene, &hash));
    return hash;
}

vbss_scene_statistics small_statistics(const small *s)
{
    vbss_scene_statistics statistics;
    expect_ok(vbss_scene_get_statistics(s->scene, &statistics, sizeof statistics));
    return statistics;
}

vbss_scene_rigid_state small_rigid(const small *s, uint32_t body)
{
    vbss_scene_rigid_state state;
    expect_ok(vbss_scene_get_rigid(s->scene, body, &state, sizeof state));
    return state;
}

vec3 small_position(const small *s, uint32_t body)
{
    vbss_scene_rigid_state state = small_rigid(s, body);
    return vec3_load(state.position);
}

vbss_view small_view(const small *s, vbss_scene_field field)
{
    vbss_view view;
    expect_ok(vbss_scene_get_view(s->scene, field, &view, sizeof view));
    return view;
}

static vec3 vector_of(vbss_view view, uint64_t i)
{
    double v[3];
    assert_true(i < view.count);
    memcpy(v, (const char *)view.data + i * view.stride_bytes, sizeof v);
    return vec3_load(v);
}

vec3 small_vector(const small *s, vbss_scene_field field, uint64_t i)
{
    return vector_of(small_view(s, field), i);
}

void small_draw(vbss_thread *thread, uint32_t node, vec3 force)
{
    uint32_t id;
    vbss_thread_attachment a;
    expect_ok(vbss_thread_attachment_init(&a, sizeof a));
    a.kind = VBSS_THREAD_ATTACHMENT_FORCE;
    a.node = node;
    vec3_store(a.force, force);
    expect_ok(vbss_thread_attach(thread, &a, &id));
    a.kind = VBSS_THREAD_ATTACHMENT_MASS;
    a.mass = 1e-3;
    memset(a.force, 0, sizeof a.force);
    expect_ok(vbss_thread_attach(thread, &a, &id));
}

vec3 small_node(vbss_thread *thread, uint32_t node)
{
    vbss_view view;
    expect_ok(vbss_thread_get_view(thread, VBSS_THREAD_VIEW_POSITIONS, &view, sizeof view));
    return vector_of(view, node);
}

double small_tension(vbss_thread *thread, uint32_t segment)
{
    vbss_view view;
    double tension;
    expect_ok(vbss_thread_get_view(thread, VBSS_THREAD_VIEW_TENSIONS, &view, sizeof view));
    assert_true(segment < view.count);
    memcpy(&tension, (const char *)view.data + (size_t)segment * view.stride_bytes, sizeof tension);
    return tension;
}

double small_thread_energy(vbss_thread *thread, double axial_stiffness)
{
    vbss_thread_energies e;
    vbss_view rest;
    thread_object *t;
    expect_ok(vbss_thread_open(thread, &t));
    expect_ok(vbss_thread_get_energies(thread, &e, sizeof e));
    expect_ok(vbss_thread_get_view(thread, VBSS_THREAD_VIEW_REST_LENGTHS, &rest, sizeof rest));
    double energy = e.kinetic + e.bending + e.gravity;
    for (uint64_t i = 0; i < rest.count; i++) {
        double tension = t->now.tension[i]; /* the part that stretches the segment */
        energy += 0.5 * tension * tension * ((const double *)rest.data)[i] / axial_stiffness;
    }
    return energy;
}

small_state small_save(const small *s)
{
    small_state state = {NULL, 0};
    uint64_t need;
    expect_result(VBSS_ERROR_CAPACITY, vbss_scene_save(s->scene, NULL, 0, &need));
    state.bytes = malloc(need);
    assert_non_null(state.bytes);
    expect_ok(vbss_scene_save(s->scene, state.bytes, need, &state.count));
    assert_int_equal(state.count, need);
    return state;
}

scene_object *small_object(const small *s)
{
    scene_object *object;
    expect_ok(vbss_scene_open(s->scene, &object));
    return object;
}

uint32_t small_events(const small *s, vbss_scene_event_kind kind, vbss_scene_event *event)
{
    return step_events_find(s->scene, kind, event);
}
