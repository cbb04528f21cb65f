#include "throw/rig.h"

#include <string.h>

#include "throw/core_speed.h"

#define DRAIN_HALF 16e-3

enum { CUTS = 4, HASH_INTERVAL = 100 };

/* ---- the line of the thread */

/* Radially out of the drain on both sides; between the marks along the circle that does so smoothly. */
static vec place(double s, const throw_rig *st, double inside, double bend, double angle)
{
    vec centre = v3(0.0, 0.0, -DRAIN_RADIUS), outward = v3(vbss_sin(angle), 0.0, vbss_cos(angle));
    vec mark = v_along(centre, DRAIN_RADIUS, outward);
    if (s <= st->tail) {
        return v_along(mark, st->tail - s, outward);
    }
    if (s >= st->tail + inside) {
        mark.x = -mark.x;
        outward.x = -outward.x;
        return v_along(mark, s - st->tail - inside, outward);
    }
    double turn = (s - st->tail) / bend; /* from the right mark, below the middle, to the left */
    double from = angle;
    vec middle = v3(0.0, 0.0, -DRAIN_RADIUS + DRAIN_RADIUS / vbss_cos(angle));
    return v_add(middle, v3(bend * vbss_cos(from + turn), 0.0, -bend * vbss_sin(from + turn)));
}

static vbss_result make_thread(throw_rig *s)
{
    static vec x[MAX_THREAD_NODES];
    double angle = MARK_ARC / DRAIN_RADIUS,
           bend = DRAIN_RADIUS * (vbss_sin(angle) / vbss_cos(angle));
    double inside = bend * (3.14159265358979 - 2.0 * angle);
    uint32_t tail = (uint32_t)(s->tail / SEGMENT + 0.5), in = (uint32_t)(inside / SEGMENT + 0.5),
             limb = (uint32_t)(s->limb / SEGMENT + 0.5);
    vbss_thread_config c;
    TRY(vbss_thread_config_init(&c, sizeof c));
    TRY(vbss_thread_config_preset(&c, VBSS_THREAD_PRESET_VBLAST));
    s->nodes = tail + in + limb + 1;
    s->marks[0] = tail;
    s->marks[1] = tail + in;
    for (uint32_t i = 0; i < s->nodes; i++) {
        double at = i <= tail        ? SEGMENT * i
                    : i >= tail + in ? s->tail + inside + SEGMENT * (i - tail - in)
                                     : s->tail + inside * (i - tail) / in;
        x[i] = place(at, s, inside, bend, angle);
    }
    c.segment_count = s->nodes - 1;
    c.length = SEGMENT * c.segment_count;
    c.positions = &x[0].x;
    c.attachment_capacity = 64;
    c.gravity[1] = 0.0;
    c.gravity[2] = -9.81;
    c.damping = 2.0;
    c.drag = 1.0;
    c.cut_capacity = CUTS;
    return vbss_thread_create(s->context, &c, &s->thread);
}

/* ---- the scene */

static vbss_result make_scene(throw_rig *s)
{
    vbss_scene_config c;
    TRY(vbss_scene_config_init(&c, sizeof c));
    c.thread_capacity = 1 + CUTS;
    c.node_capacity = 2048;
    c.rigid_capacity = 3;
    c.capsule_capacity = 16;
    c.pin_capacity = 64;
    c.floor = 1;
    c.floor_normal[1] = 0.0;
    c.floor_normal[2] = 1.0;
    c.floor_height = FLOOR_HEIGHT;
    return vbss_scene_create(s->context, &c, &s->scene);
}

static vbss_result add_drain(throw_rig *s)
{
    vbss_scene_rigid_config c;
    vbss_scene_capsule rod = {
        .begin = {0.0, -DRAIN_HALF, 0.0}, .end = {0.0, DRAIN_HALF, 0.0}, .radius = DRAIN_RADIUS};
    TRY(vbss_scene_rigid_config_init(&c, sizeof c));
    c.capsules = &rod;
    c.capsule_count = 1;
    c.friction = 0.3;
    c.position[2] = -DRAIN_RADIUS;
    return vbss_scene_add_rigid(s->scene, &c, &s->drain);
}

/* What is inside, and a node on either side, so that it stands. In the world and not on the drain, which would not
 * touch the thread within 1.6 times its own radius of a pin, and let the knot sink in. */
static vbss_result fix_thread(throw_rig *s)
{
    uint32_t pin;
    for (uint32_t i = s->marks[0] - 1; i <= s->marks[1] + 1; i++) {
        TRY(vbss_scene_pin_thread(s->scene, s->thread_body, i, 0, NULL, &pin));
    }
    return VBSS_OK;
}

vbss_result throw_rig_create(throw_rig *s, double tail, double limb)
{
    memset(s, 0, sizeof *s);
    s->tail = tail;
    s->limb = limb;
    TRY(vbss_context_create(NULL, &s->context));
    TRY(make_thread(s));
    TRY(make_scene(s));
    TRY(vbss_scene_add_thread(s->scene, s->thread, &s->thread_body));
    TRY(add_drain(s));
    return fix_thread(s);
}

/* ---- views */

static const void *view_of(const throw_rig *s, vbss_thread_field field)
{
    vbss_view view;
    return vbss_thread_get_view(s->thread, field, &view, sizeof view) == VBSS_OK ? view.data : NULL;
}

static void turn_round(throw_rig *s)
{
    const vec *x = view_of(s, VBSS_THREAD_VIEW_POSITIONS);
    for (uint32_t i = 0; s->reversed && i < s->nodes; i++) {
        s->turned[i] = x[s->nodes - 1 - i];
    }
}

const vec *throw_rig_nodes(const throw_rig *s)
{
    return s->reversed ? s->turned : view_of(s, VBSS_THREAD_VIEW_POSITIONS);
}

double throw_rig_place(const throw_rig *s, double arc_length)
{
    double place = arc_length / SEGMENT;
    return s->reversed ? s->nodes - 1 - place : place;
}

uint32_t throw_rig_segment(const throw_rig *s, uint32_t segment)
{
    return s->reversed ? s->nodes - 2 - segment : segment;
}

/* ---- the log */

static vbss_result write_log(throw_rig *s)
{
    const uint8_t *bytes;
    uint64_t count;
    TRY(vbss_record_take(s->record, &bytes, &count));
    return log_file_write(&s->log, bytes, (size_t)count) ? VBSS_OK : VBSS_ERROR_CAPACITY;
}

vbss_result throw_rig_begin(throw_rig *s, const char *log, const char *note)
{
    vbss_record_config c;
    turn_round(s);
    TRY(vbss_record_config_init(&c, sizeof c));
    c.hash_interval = HASH_INTERVAL;
    c.note = note;
    c.note_bytes = (uint32_t)strlen(note);
    TRY(vbss_record_create(s->scene, &c, &s->record));
    TRY(vbss_scene_set_recorder(s->scene, s->record));
    return log_file_open(&s->log, log) ? write_log(s) : VBSS_ERROR_CAPACITY;
}

vbss_result throw_rig_hold_limb(throw_rig *s, uint32_t node)
{
    return vbss_scene_pin_thread(s->scene, s->thread_body, node + 8, 0, NULL, &s->support);
}

vbss_result throw_rig_release_limb(throw_rig *s)
{
    uint32_t pin = s->support;
    s->support = 0;
    return pin != 0 ? vbss_scene_unpin_thread(s->scene, pin) : VBSS_OK;
}

/* Off the tail's end, so many nodes. */
static vbss_result shorten(throw_rig *s, uint32_t nodes)
{
    if (nodes > s->marks[0]) {
        return VBSS_ERROR_OUT_OF_RANGE; /* through the knot */
    }
    s->nodes -= nodes;
    s->marks[0] -= nodes;
    s->marks[1] -= nodes;
    s->shift += nodes;
    return VBSS_OK;
}

/* The thread is from now on what is left of it on the drain: the piece before the cut, as the scene counts, or the new one. */
static vbss_result follow_cut(throw_rig *s, uint32_t piece)
{
    vbss_thread *beyond;
    vbss_view before, after;
    TRY(vbss_scene_get_thread(s->scene, piece, &beyond));
    TRY(vbss_thread_get_view(s->thread, VBSS_THREAD_VIEW_POSITIONS, &before, sizeof before));
    TRY(vbss_thread_get_view(beyond, VBSS_THREAD_VIEW_POSITIONS, &after, sizeof after));
    s->cuts++;
    uint32_t first = (uint32_t)before.count, other = (uint32_t)after.count;
    if (first > (s->reversed ? s->nodes - 1 - s->marks[0] : s->marks[1])) { /* on it still */
        if (s->reversed) {
            return shorten(s, s->nodes - first);
        }
        s->nodes = first;
        return VBSS_OK;
    }
    s->thread = beyond;
    s->thread_body = piece;
    if (!s->reversed) {
        return shorten(s, s->nodes - other);
    }
    s->nodes = other;
    return VBSS_OK;
}

vbss_result throw_rig_follow(throw_rig *s)
{
    TRY(vbss_scene_take_events(s->scene, s->events, sizeof *s->events, MAX_STEP_EVENTS,
                               &s->event_count, NULL));
    for (uint32_t i = 0; i < s->event_count; i++) {
        const vbss_scene_event *e = &s->events[i];
        if (e->kind == VBSS_SCENE_EVENT_CUT && e->body_a == s->thread_body && e->body_b != 0) {
            TRY(follow_cut(s, e->body_b));
        }
    }
    turn_round(s);
    return VBSS_OK;
}

vbss_result throw_rig_step(throw_rig *s, double dt)
{
    return s->host != NULL ? s->host->step(s->host->user, dt) : throw_rig_advance(s, dt);
}

vbss_result throw_rig_advance(throw_rig *s, double dt)
{
    const double begin = cpu_clock(NULL);
    TRY(s->session != NULL ? vbss_session_step(s->session, s->time, dt)
                           : vbss_scene_step(s->scene, dt));
    TRY(throw_rig_follow(s));
    s->time += dt;
    vbss_result result = write_log(s);
    s->took = cpu_clock(NULL) - begin;
    return result;
}

vbss_result throw_rig_end(throw_rig *s)
{
    TRY(vbss_record_end(s->record));
    return write_log(s);
}

void throw_rig_destroy(throw_rig *s)
{
    log_file_close(&s->log);
    vbss_context_destroy(s->context);
    s->context = NULL;
}
