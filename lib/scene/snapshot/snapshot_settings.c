/* Saves and restores what hosts set at run time: settings of the scene, and filter, friction,
 * gravity and loads of bodies. The gravity and the coupling of rigid bodies are in
 * vbss_rigid_serialise. */
#include "base/stream.h"
#include "scene/snapshot/snapshot.h"
#include "scene/world/world.h"

#include <string.h>

/* What a host can set of a body, and where it is. */
typedef struct body_settings {
    double *friction, created_friction;     /* NULL: the body has none of its own */
    vec3 *gravity;                          /* NULL: saved elsewhere */
    const double *created_gravity;          /* three numbers */
    vbss_rigid_wrench *load, *pending_load; /* NULL: the body takes none */
} body_settings;

static body_settings settings_of(scene_body *b)
{
    if (b->kind == SCENE_BODY_THREAD) {
        thread_object *t = b->thread.thread;
        return (body_settings){.gravity = &t->gravity, .created_gravity = t->config.gravity};
    }
    if (b->kind == SCENE_BODY_DRAIN) {
        drain_object *d = b->drain.drain;
        return (body_settings){.friction = &b->drain.friction,
                               .created_friction = d->config.friction,
                               .gravity = &d->gravity,
                               .created_gravity = d->config.gravity};
    }
    scene_rigid *r = &b->rigid;
    return (body_settings){.friction = &r->friction,
                           .created_friction = r->created_friction,
                           .load = &r->body.load,
                           .pending_load = &r->pending_load};
}

static bool is_same(double a, double b)
{
    /* NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): to the bit */
    return memcmp(&a, &b, sizeof a) == 0;
}

static bool is_same_filter(scene_filter a, scene_filter b)
{
    return a.category == b.category && a.mask == b.mask;
}

static bool has_wrench(const vbss_rigid_wrench *w)
{
    return w != NULL && (vec3_norm_squared(w->force) > 0.0 || vec3_norm_squared(w->torque) > 0.0);
}

static bool has_body_settings(scene_body *b)
{
    const body_settings p = settings_of(b);
    bool has = !is_same_filter(b->filter, vbss_scene_default_filter()) || has_wrench(p.load) ||
               has_wrench(p.pending_load) ||
               (p.friction != NULL && !is_same(*p.friction, p.created_friction));
    if (p.gravity != NULL) {
        /* NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): to the bit */
        has = has || memcmp(&p.gravity->x, p.created_gravity, 3 * sizeof(double)) != 0;
    }
    return has;
}

bool vbss_scene_has_settings(const scene_object *s)
{
    const scene_settings now = s->settings, created = vbss_scene_created_settings(s);
    bool has = !is_same(now.floor_friction, created.floor_friction) ||
               !is_same(now.thread_friction, created.thread_friction) ||
               !is_same(now.speed_limit, created.speed_limit) ||
               !is_same_filter(now.floor_filter, created.floor_filter);
    for (uint32_t i = 0; !has && i < s->body_count; i++) {
        has = s->bodies[i].kind != SCENE_BODY_NONE && has_body_settings(&s->bodies[i]);
    }
    return has;
}

static void reset_settings(scene_object *s)
{
    s->settings = vbss_scene_created_settings(s);
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_NONE) {
            continue;
        }
        const body_settings p = settings_of(b);
        b->filter = vbss_scene_default_filter();
        if (p.friction != NULL) {
            *p.friction = p.created_friction;
        }
        if (p.gravity != NULL) {
            *p.gravity = vec3_load(p.created_gravity);
        }
        if (p.load != NULL) {
            *p.load = *p.pending_load = (vbss_rigid_wrench){0};
        }
    }
}

static void visit_filter(vbss_stream *stream, scene_filter *filter)
{
    uint32_t words[2] = {filter->category, filter->mask};
    vbss_stream_u32(stream, 201, words, 2);
    *filter = (scene_filter){words[0], words[1]};
}

/* Refuses a number that no setter accepts, and uses another one instead. */
static void visit_limited(vbss_stream *stream, double *value, double limit, double instead)
{
    vbss_stream_f64(stream, 202, value, 1);
    if (stream->mode == VBSS_STREAM_READ && !(*value >= 0.0 && *value <= limit)) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such setting");
        *value = instead;
    }
}

static void visit_wrench(vbss_stream *stream, vbss_rigid_wrench *w)
{
    vbss_stream_f64(stream, 204, &w->force.x, 3);
    vbss_stream_f64(stream, 205, &w->torque.x, 3);
}

static void visit_body(vbss_stream *stream, scene_body *b)
{
    const body_settings p = settings_of(b);
    visit_filter(stream, &b->filter);
    if (p.friction != NULL) {
        visit_limited(stream, p.friction, 10.0, p.created_friction);
    }
    if (p.gravity != NULL) {
        vbss_stream_f64(stream, 203, &p.gravity->x, 3);
    }
    if (p.load != NULL) {
        visit_wrench(stream, p.load);
        visit_wrench(stream, p.pending_load);
    }
}

bool vbss_scene_has_budgets(const scene_object *s)
{
    const scene_settings created = vbss_scene_created_settings(s);
    return s->settings.step_budget != created.step_budget ||
           s->settings.call_budget != created.call_budget;
}

void vbss_scene_visit_budgets(vbss_stream *stream, scene_object *s, bool has_budgets)
{
    if (has_budgets) {
        vbss_stream_u32(stream, 206, &s->settings.step_budget, 1);
        vbss_stream_u32(stream, 206, &s->settings.call_budget, 1);
    } else if (stream->mode == VBSS_STREAM_READ) {
        const scene_settings created = vbss_scene_created_settings(s);
        s->settings.step_budget = created.step_budget;
        s->settings.call_budget = created.call_budget;
    }
}

void vbss_scene_visit_settings(vbss_stream *stream, scene_object *s, bool has_settings)
{
    if (stream->mode == VBSS_STREAM_READ) {
        reset_settings(s);
    }
    if (!has_settings) {
        return;
    }
    visit_limited(stream, &s->settings.floor_friction, 10.0, 0.0);
    visit_limited(stream, &s->settings.thread_friction, 10.0, 0.0);
    visit_limited(stream, &s->settings.speed_limit, 1e6, 0.0);
    visit_filter(stream, &s->settings.floor_filter);
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind != SCENE_BODY_NONE) {
            visit_body(stream, &s->bodies[i]);
        }
    }
}
