/* The state of a scene and all its bodies: saved, hashed and restored. */
#include "base/snapshot.h"
#include "base/stream.h"
#include "scene/cuts.h"
#include "scene/meshes.h"
#include "scene/pins.h"
#include "scene/scene.h"
#include "scene/step.h"

#include <string.h>

static void visit_config(vbss_stream *stream, const scene_object *s)
{
    const vbss_scene_config *c = &s->config;
    const double numbers[] = {c->floor_normal[0],       c->floor_normal[1], c->floor_normal[2],
                              c->floor_height,          c->floor_friction,  c->thread_friction,
                              c->contact_stiffness,     c->contact_margin,  c->stretch_tolerance,
                              c->penetration_tolerance, c->paper_thickness};
    const uint32_t choices[] = {(uint32_t)c->method,    (uint32_t)c->mode,   (uint32_t)c->floor,
                                c->linearisation_limit, c->state_limit,      c->halving_limit,
                                c->attempt_limit,       c->paper_pass_limit, c->pin_capacity};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_expect_f64(stream, 1, numbers[i]);
    }
    for (size_t i = 0; i < sizeof choices / sizeof choices[0]; i++) {
        vbss_stream_expect(stream, 2, choices[i]);
    }
    if (stream->version >= 2) {
        vbss_stream_expect(stream, 4, c->grasp_capacity);
    }
    if (stream->version >= 3) {
        vbss_stream_expect(stream, 5, c->work_limit);
    }
    if (stream->version >= 4) {
        vbss_stream_expect(stream, 6, c->hole_capacity);
    }
    if (stream->version >= 6) {
        vbss_stream_expect(stream, 7, c->slot_limit);
    }
}

static void visit_hold(vbss_stream *stream, scene_hold *hold)
{
    uint32_t words[] = {hold->needle, hold->sliding, hold->let_go, hold->torn};
    double *numbers[] = {&hold->arc,  &hold->angle,  &hold->age,
                         &hold->slid, &hold->turned, &hold->limit};
    vbss_stream_u32(stream, 130, words, sizeof words / sizeof words[0]);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_f64(stream, 131, numbers[i], 1);
    }
    vbss_stream_f64(stream, 132, &hold->at.position.x, 3);
    vbss_stream_f64(stream, 133, &hold->at.orientation.w, 4);
    vbss_stream_f64(stream, 134, &hold->force.x, 3);
    vbss_stream_f64(stream, 135, &hold->torque.x, 3);
    if (words[1] > 1 || words[2] > 1 || words[3] > 1) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such flag");
    }
    hold->needle = words[0];
    hold->sliding = words[1] != 0;
    hold->let_go = words[2] != 0;
    hold->torn = words[3] != 0;
}

static bool is_hold(const scene_object *s, const scene_hold *hold)
{
    const scene_body *b = vbss_scene_body(s, hold->needle);
    if (hold->needle == 0) {
        return true;
    }
    if (b == NULL || b->kind != BODY_RIGID || b->rigid.needle == NULL) {
        return false;
    }
    quat q = hold->at.orientation;
    bool closed = s->config.method == VBSS_METHOD_PAPER; /* whatever is between them */
    return hold->arc >= 0.0 && hold->arc <= vbss_needle_length(b->rigid.needle) &&
           (closed ? hold->angle == 0.0 : hold->angle > 0.0) && hold->angle <= 1.6 &&
           hold->age >= 0.0 && isfinite(hold->age) && isfinite(hold->slid) &&
           isfinite(hold->turned) && isfinite(hold->limit) &&
           vec3_norm(hold->at.position) <= 2.0 && /* jaws are at most 1 m long */
           fabs(quat_dot(q, q) - 1.0) < 1e-6 && vec3_is_finite(hold->force) &&
           vec3_is_finite(hold->torque);
}

static void visit_pinch(vbss_stream *stream, scene_pinch *p)
{
    uint32_t words[] = {p->drain, p->count, p->sliding, p->let_go, p->torn};
    double *numbers[] = {&p->angle, &p->age, &p->slid, &p->limit};
    vbss_stream_u32(stream, 136, words, sizeof words / sizeof words[0]);
    vbss_stream_u32(stream, 137, p->triangle, PINCH_POINTS);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_f64(stream, 138, numbers[i], 1);
    }
    for (uint32_t k = 0; k < PINCH_POINTS; k++) {
        vbss_stream_f64(stream, 139, p->weights[k], 3);
        vbss_stream_f64(stream, 139, &p->at[k].x, 3);
    }
    vbss_stream_f64(stream, 139, &p->force.x, 3);
    if (words[2] > 1 || words[3] > 1 || words[4] > 1) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such flag");
    }
    p->drain = words[0];
    p->count = words[1];
    p->sliding = words[2] != 0;
    p->let_go = words[3] != 0;
    p->torn = words[4] != 0;
}

static bool is_pinch(const scene_object *s, const scene_pinch *p)
{
    const scene_body *b = vbss_scene_body(s, p->drain);
    if (p->drain == 0) {
        return true;
    }
    if (b == NULL || b->kind != BODY_DRAIN || p->count == 0 || p->count > PINCH_POINTS) {
        return false;
    }
    bool sound = p->angle > 0.0 && p->angle <= 1.6 && p->age >= 0.0 && isfinite(p->age) &&
                 isfinite(p->slid) && isfinite(p->limit) && vec3_is_finite(p->force);
    for (uint32_t k = 0; k < p->count; k++) {
        const double *w = p->weights[k];
        sound = sound && p->triangle[k] < b->drain.drain->mesh.triangle_count && w[0] >= 0.0 &&
                w[1] >= 0.0 && w[2] >= 0.0 && fabs(w[0] + w[1] + w[2] - 1.0) < 1e-9 &&
                vec3_norm(p->at[k]) <= 2.0; /* jaws are at most 1 m long */
    }
    return sound;
}

/* PAPER: it follows a tool that has closed on it; its tip is in walls that there are. */
static bool is_led(const scene_object *s, const scene_body *needle)
{
    const scene_rigid *r = &needle->rigid;
    const scene_body *tool = vbss_scene_body(s, r->leader);
    bool sound = r->leader == 0 || (tool != NULL && tool->kind == BODY_RIGID &&
                                    tool->rigid.hold.needle == needle->number);
    for (int k = 0; k < SUTURE_TOGGLES; k++) {
        const suture_toggle *toggle = &r->toggles[k];
        const scene_body *d = vbss_scene_body(s, toggle->drain);
        bool none = toggle->drain == 0 && toggle->triangle == 0 && !toggle->outward;
        sound = sound && (none || (d != NULL && d->kind == BODY_DRAIN &&
                                   toggle->triangle < d->drain.drain->mesh.triangle_count));
    }
    return sound;
}

/* When all bodies are read. */
static void check_holds(vbss_stream *stream, const scene_object *s)
{
    for (uint32_t i = 0; stream->mode == VBSS_STREAM_READ && i < s->place_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind == BODY_RIGID && !stream->trusted &&
            (!is_hold(s, &b->rigid.hold) || !is_pinch(s, &b->rigid.pinch) || !is_led(s, b))) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such needle or wall in jaws");
        }
    }
}

/* Its jaws may lag behind where they shall be. */
static void visit_grasper(vbss_stream *stream, const scene_object *s, scene_rigid *r)
{
    vbss_section outer =
        vbss_stream_open(stream, vbss_grasper_kind_of_slot.code, vbss_grasper_kind_of_slot.version);
    vbss_grasper_serialise(stream, r->grasper);
    vbss_stream_close(stream, outer);
    for (uint32_t i = 0; i < r->capsule_count; i++) {
        scene_capsule *c = &s->capsules[r->first_capsule + i];
        vbss_stream_f64(stream, 24, &c->local[0].x, 3);
        vbss_stream_f64(stream, 25, &c->local[1].x, 3);
        vbss_stream_f64(stream, 26, &c->local_end[0].x, 3);
        vbss_stream_f64(stream, 27, &c->local_end[1].x, 3);
        vbss_stream_f64(stream, 28, &c->radius, 1);
        if (stream->mode == VBSS_STREAM_READ && !(c->radius > 0.0)) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such jaws");
        }
    }
    if (stream->version >= 4) {
        visit_hold(stream, &r->hold);
        visit_pinch(stream, &r->pinch);
    } else {
        r->hold = (scene_hold){0};
        r->pinch = (scene_pinch){0};
    }
}

/* PAPER, whose scenes of older versions had no needles. */
static void visit_lead(vbss_stream *stream, scene_rigid *r)
{
    vbss_stream_u32(stream, 142, &r->leader, 1);
    for (int k = 0; k < SUTURE_TOGGLES; k++) {
        suture_toggle *toggle = &r->toggles[k];
        uint32_t words[] = {toggle->drain, toggle->triangle, toggle->outward};
        vbss_stream_u32(stream, 143, words, sizeof words / sizeof words[0]);
        if (words[2] > 1) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such flag");
        }
        *toggle = (suture_toggle){words[0], words[1], words[2] != 0};
    }
}

static void visit_needle(vbss_stream *stream, const scene_object *s, scene_rigid *r)
{
    vbss_section outer = vbss_stream_open(stream, vbss_needle_kind.code, vbss_needle_kind.version);
    vbss_needle_serialise(stream, r->needle);
    vbss_stream_close(stream, outer);
    if (s->config.method == VBSS_METHOD_PAPER) {
        visit_lead(stream, r);
    }
}

static void visit_told(vbss_stream *stream, scene_rigid *r)
{
    uint32_t is_told = r->is_told;
    if (stream->version >= 6) {
        vbss_stream_u32(stream, 54, &is_told, 1);
        r->is_told = is_told == 1;
    } else {
        r->is_told = false;
    }
    if (r->is_told) {
        const quat *q = &r->told.orientation;
        vbss_stream_f64(stream, 55, &r->told.position.x, 3);
        vbss_stream_f64(stream, 56, &r->told.orientation.w, 4);
        r->is_told = vec3_is_finite(r->told.position) && fabs(quat_dot(*q, *q) - 1.0) < 1e-6;
    }
    if (is_told > 1 || (is_told == 1 && !r->is_told)) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such pose");
    }
}

static void visit_rigid(vbss_stream *stream, const scene_object *s, scene_rigid *r)
{
    vbss_stream_expect(stream, 20, (uint64_t)r->kind);
    vbss_stream_expect(stream, 21, r->capsule_count);
    if (stream->version >= 2 || r->grasper != NULL) { /* before there were none */
        vbss_stream_expect(stream, 29, r->grasper != NULL);
    }
    if (stream->version >= 4 || r->needle != NULL) {
        vbss_stream_expect(stream, 19, r->needle != NULL);
    }
    vbss_stream_expect_f64(stream, 22, r->friction);
    for (uint32_t i = 0; r->grasper == NULL && i < r->capsule_count; i++) {
        const scene_capsule *c = &s->capsules[r->first_capsule + i];
        const double numbers[] = {c->local[0].x, c->local[0].y, c->local[0].z, c->local[1].x,
                                  c->local[1].y, c->local[1].z, c->radius};
        for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++) {
            vbss_stream_expect_f64(stream, 23, numbers[k]);
        }
    }
    if (r->grasper != NULL) {
        visit_grasper(stream, s, r);
    }
    if (r->needle != NULL) {
        visit_needle(stream, s, r);
    }
    vbss_rigid_serialise(stream, 30, &r->body);
    visit_told(stream, r);
    vbss_stream_f64(stream, 50, &r->force.x, 3);
    vbss_stream_f64(stream, 51, &r->torque.x, 3);
    vbss_stream_f64(stream, 52, &r->pull.force.x, 3);
    vbss_stream_f64(stream, 53, &r->pull.torque.x, 3);
}

static void visit_thread(vbss_stream *stream, scene_thread *b)
{
    const uint32_t nodes = b->thread->node_count;
    vbss_stream_u32(stream, 60, &b->calm, 1);
    vbss_section outer = vbss_stream_open(stream, vbss_thread_kind.code, vbss_thread_kind.version);
    vbss_thread_serialise(stream, b->thread);
    vbss_stream_close(stream, outer);
    if (!scene_thread_resizes(b->thread) &&
        b->thread->node_count != nodes) { /* the scene's arrays are numbered for these */
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "another number of nodes");
    }
}

static void visit_drain(vbss_stream *stream, scene_drain *b)
{
    vbss_stream_expect_f64(stream, 61, b->drain->config.friction);
    if (stream->version >= 4) {
        const vbss_drain_config *c = &b->drain->config;
        const double numbers[] = {c->puncture_force, c->hole_force,   c->hole_friction,
                                  c->hole_stiffness, c->hole_damping, c->tip_length};
        for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
            vbss_stream_expect_f64(stream, 63, numbers[i]);
        }
    }
    if (stream->version >= 5) {
        vbss_stream_expect_f64(stream, 64, b->drain->config.thread_force);
    }
    vbss_section outer = vbss_stream_open(stream, vbss_drain_kind.code, vbss_drain_kind.version);
    vbss_drain_serialise(stream, b->drain);
    vbss_stream_close(stream, outer);
    vbss_stream_f64(stream, 62, &b->drain->contact_forces[0].x,
                    3 * (size_t)b->drain->mesh.node_count);
    for (uint32_t i = 0; stream->mode == VBSS_STREAM_READ && i < b->drain->mesh.node_count; i++) {
        if (!vec3_is_finite(b->drain->contact_forces[i])) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such contacts of a drain");
            b->drain->contact_forces[i] = vec3_zero();
        }
    }
}

static void visit_bodies(vbss_stream *stream, scene_object *s)
{
    vbss_stream_expect(stream, 10, s->place_count);
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->reserved) {
            vbss_scene_visit_piece(stream, s, b);
        } else {
            vbss_stream_expect(stream, 11, (uint64_t)b->kind);
        }
        if (b->kind == BODY_GONE) {
            continue;
        }
        if (!b->reserved) {
            vbss_stream_expect(stream, 12, b->number);
        }
        if (b->kind == BODY_THREAD) {
            if (!scene_thread_resizes(b->thread.thread)) {
                vbss_stream_expect(stream, 13, b->thread.thread->node_count);
            }
            visit_thread(stream, &b->thread);
        } else if (b->kind == BODY_DRAIN) {
            vbss_stream_expect(stream, 14, b->drain.drain->mesh.node_count);
            visit_drain(stream, &b->drain);
        } else {
            visit_rigid(stream, s, &b->rigid);
        }
    }
    vbss_scene_finish_pieces(stream, s);
    check_holds(stream, s);
}

/* A weld is to a body that moves as forces say, of a node that nothing else holds. */
static bool is_weld_or_attached(const scene_object *s, const scene_pin *p, const scene_body *body,
                                const thread_object *t)
{
    if (p->attachment != 0) {
        return true;
    }
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        const thread_attachment *a = &t->attachments[i];
        if (a->id != 0 && a->node == p->node && vbss_thread_prescribes_motion(a->kind)) {
            return false;
        }
    }
    return s->config.method == VBSS_METHOD_OURS && body != NULL &&
           body->rigid.kind != VBSS_RIGID_DRIVEN &&
           vbss_scene_weld_of(s, p->thread, p->node) == p; /* those before it are read */
}

static void visit_pins(vbss_stream *stream, scene_object *s)
{
    vbss_stream_u32(stream, 70, &s->last_pin, 1);
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        scene_pin *p = &s->pins[i];
        uint32_t words[5] = {p->id, p->thread, p->node, p->body, p->attachment};
        vbss_stream_u32(stream, 71, words, 5);
        vbss_stream_f64(stream, 72, &p->point.x, 3);
        const scene_pin read = {.id = words[0],
                                .thread = words[1],
                                .node = words[2],
                                .body = words[3],
                                .attachment = words[4],
                                .point = p->point};
        *p = read;
        if (stream->mode != VBSS_STREAM_READ || stream->trusted) {
            continue;
        }
        if (p->id == 0) {
            if (p->thread != 0 || p->node != 0 || p->body != 0 || p->attachment != 0) {
                vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such pin");
            }
            continue;
        }
        const scene_body *t = vbss_scene_body(s, p->thread), *b = vbss_scene_body(s, p->body);
        bool thread = t != NULL && t->kind == BODY_THREAD && p->node < t->thread.thread->node_count;
        bool body = p->body == 0 ? p->attachment != 0 : b != NULL && b->kind == BODY_RIGID;
        if (!thread || !body || p->id > s->last_pin ||
            !is_weld_or_attached(s, p, b, t->thread.thread)) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such pin");
        }
    }
}

static void visit_grasp(vbss_stream *stream, scene_grasp *g)
{
    uint32_t words[] = {g->thread, g->tool, g->segment, g->sliding, g->let_go, g->pin, g->torn};
    double *numbers[] = {&g->into, &g->angle, &g->spacing, &g->grip.age, &g->slid, &g->limit};
    vbss_stream_u32(stream, 121, words, sizeof words / sizeof words[0]);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_f64(stream, 122, numbers[i], 1);
    }
    vbss_stream_f64(stream, 123, &g->force.x, 3);
    for (uint32_t k = 0; k < GRASPER_THREAD_POINTS; k++) {
        vbss_stream_f64(stream, 124, &g->grip.anchor[k].x, 3);
    }
    if (words[3] > 1 || words[4] > 1 || words[6] > 1) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such flag");
    }
    g->thread = words[0];
    g->tool = words[1];
    g->segment = words[2];
    g->sliding = words[3] != 0;
    g->let_go = words[4] != 0;
    g->pin = words[5];
    g->torn = words[6] != 0;
}

static bool is_grasp(const scene_object *s, const scene_grasp *g)
{
    const scene_body *t = vbss_scene_body(s, g->thread), *b = vbss_scene_body(s, g->tool);
    if (t == NULL || t->kind != BODY_THREAD || b == NULL || b->kind != BODY_RIGID ||
        b->rigid.grasper == NULL || g->id > s->last_grasp) {
        return false;
    }
    const thread_object *thread = t->thread.thread;
    bool paper = s->config.method == VBSS_METHOD_PAPER && !g->let_go; /* holds a node, by a pin */
    bool placed = g->segment + (paper ? 0 : 1) < thread->node_count && isfinite(g->into) &&
                  fabs(g->into) <= 1e3 && isfinite(g->angle) && isfinite(g->slid) &&
                  isfinite(g->limit) && vec3_is_finite(g->force) &&
                  (paper ? g->spacing == 0.0 : g->spacing > 0.0) && g->spacing <= 0.1 &&
                  g->grip.age >= 0.0 && isfinite(g->grip.age);
    for (uint32_t k = 0; k < GRASPER_THREAD_POINTS; k++) {
        placed = placed && vec3_is_finite(g->grip.anchor[k]);
    }
    return placed;
}

static void visit_grasps(vbss_stream *stream, scene_object *s)
{
    if (stream->version < 2) {
        memset(s->grasps, 0, s->config.grasp_capacity * sizeof *s->grasps);
        return;
    }
    vbss_stream_u32(stream, 120, &s->last_grasp, 1);
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        scene_grasp *g = &s->grasps[i];
        vbss_stream_u32(stream, 125, &g->id, 1);
        if (g->id != 0) {
            visit_grasp(stream, g);
        } else if (stream->mode == VBSS_STREAM_READ) {
            *g = (scene_grasp){0};
        }
        if (g->id != 0 && stream->mode == VBSS_STREAM_READ && !stream->trusted && !is_grasp(s, g)) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such grasp");
        }
    }
}

static bool is_hole(const scene_object *s, const suture_hole *hole)
{
    const scene_body *n = vbss_scene_body(s, hole->needle), *t = vbss_scene_body(s, hole->thread);
    const scene_body *d = vbss_scene_body(s, hole->drain);
    bool needle = n != NULL && n->kind == BODY_RIGID && n->rigid.needle != NULL;
    bool thread = t != NULL && t->kind == BODY_THREAD && suture_is_curve(t->thread.thread);
    return hole->id <= s->last_hole && (hole->needle != 0 ? needle : thread) && d != NULL &&
           d->kind == BODY_DRAIN && hole->triangle < d->drain.drain->mesh.triangle_count &&
           vbss_hole_is_valid(hole);
}

static void visit_holes(vbss_stream *stream, scene_object *s)
{
    if (stream->version < 4) {
        memset(s->holes, 0, s->config.hole_capacity * sizeof *s->holes);
        s->last_hole = 0;
        return;
    }
    vbss_stream_u32(stream, 140, &s->last_hole, 1);
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        suture_hole *hole = &s->holes[i];
        vbss_hole_serialise(stream, 141, hole);
        bool check = stream->mode == VBSS_STREAM_READ && !stream->trusted && hole->id != 0;
        if (check && !is_hole(s, hole)) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such hole");
            *hole = (suture_hole){0};
        }
    }
}

static void visit_statistics(vbss_stream *stream, vbss_scene_statistics *s)
{
    vbss_stream_u32(stream, 80, &s->contacts, 3); /* contacts, rows, separators */
    vbss_stream_u64(stream, 81, &s->steps, 5);    /* steps .. state_solves */
    /* Not patterns, which depends on what is still known of the last one. */
    vbss_stream_u64(stream, 83, &s->rejected_states, 11); /* .. guard_pairs */
    vbss_stream_f64(stream, 82, &s->last_penetration, 6); /* .. time */
    if (stream->version >= 3) {
        vbss_stream_u64(stream, 84, &s->operations, 3); /* .. paused */
        vbss_stream_f64(stream, 85, &s->time_paused, 1);
    }
    if (stream->version >= 6) {
        vbss_stream_u64(stream, 87, &s->deferred, 1);
        vbss_stream_u32(stream, 88, &s->behind, 1);
    }
}

/* With which the next step begins; none was ever left unfinished before version 3. */
static void visit_pace(vbss_stream *stream, scene_object *s)
{
    if (stream->version >= 3) {
        vbss_stream_f64(stream, 86, &s->pace, 1);
    } else {
        s->pace = 1.0;
    }
    if (stream->mode == VBSS_STREAM_READ && !stream->trusted && !vbss_scene_is_part(s, s->pace)) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such part of a step");
        s->pace = 1.0;
    }
}

/* So that nobody else holds those nodes. */
static void note_welds(scene_object *s)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        if (s->bodies[i].kind == BODY_THREAD) {
            thread_object *t = s->bodies[i].thread.thread;
            memset(t->welded, 0, t->node_count * sizeof *t->welded);
        }
    }
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        const scene_pin *p = &s->pins[i];
        const scene_body *t = vbss_scene_body(s, p->thread);
        if (p->id != 0 && p->attachment == 0 && t != NULL && t->kind == BODY_THREAD &&
            p->node < t->thread.thread->node_count) { /* it may be refused yet */
            t->thread.thread->welded[p->node] = 1;
        }
    }
}

void vbss_scene_serialise(vbss_stream *stream, void *object)
{
    scene_object *s = object;
    visit_config(stream, s);
    vbss_stream_u32(stream, 3, &s->last_number, 1);
    visit_bodies(stream, s);
    visit_pins(stream, s);
    visit_grasps(stream, s);
    visit_holes(stream, s);
    if (s->contacts != NULL) {
        vbss_contact_serialise(stream, 90, s->contacts);
    }
    vbss_stream_count(stream, 110, &s->touch_count, s->config.contact_capacity);
    vbss_stream_u32(stream, 111, &s->touches->body_a, 2 * (size_t)s->touch_count);
    visit_statistics(stream, &s->statistics);
    visit_pace(stream, s);
    vbss_scene_visit_way(stream, s);
    if (stream->mode == VBSS_STREAM_READ) {
        note_welds(s);
        s->pattern = 0;
        s->contact_count = s->event_count = 0;
        s->generation++;
    }
}

vbss_result vbss_scene_save(vbss_scene *scene, uint8_t *bytes, uint64_t capacity, uint64_t *written)
{
    return vbss_object_save(scene, &vbss_scene_kind, bytes, capacity, written);
}

vbss_result vbss_scene_restore(vbss_scene *scene, const uint8_t *bytes, uint64_t count)
{
    return vbss_object_restore(scene, &vbss_scene_kind, bytes, count);
}

vbss_result vbss_scene_get_hash(vbss_scene *scene, uint64_t *hash)
{
    return vbss_object_hash(scene, &vbss_scene_kind, hash);
}
