/* Saves, hashes and restores a scene with all its bodies. One visitor does all three; it checks
 * what it reads. */
#include "base/stream.h"
#include "scene/snapshot/snapshot.h"
#include "scene/step/groups.h"
#include "scene/step/step.h"
#include "scene/topology/topology.h"
#include "scene/world/method.h"
#include "scene/world/world.h"

#include <string.h>

static void visit_config(vbss_stream *stream, const scene_object *s)
{
    const vbss_scene_config *c = &s->config;
    const vbss_solver_options *solver = &s->solver;
    const scene_settings created = vbss_scene_created_settings(s);
    const double numbers[] = {c->floor_normal[0],          c->floor_normal[1],
                              c->floor_normal[2],          c->floor_height,
                              c->floor_friction,           c->thread_friction,
                              c->contact_stiffness,        solver->contact_margin,
                              solver->stretch_tolerance,   solver->penetration_tolerance,
                              c->baseline->scene_thickness};
    const uint32_t choices[] = {(uint32_t)c->method,      (uint32_t)c->mode,
                                (uint32_t)c->floor,       solver->iteration_limit,
                                solver->active_set_limit, solver->halving_limit,
                                solver->attempt_limit,    c->baseline->scene_pass_limit,
                                c->pin_capacity};
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
        vbss_stream_expect(stream, 5, created.step_budget);
    }
    if (stream->version >= 4) {
        vbss_stream_expect(stream, 6, c->hole_capacity);
    }
    if (stream->version >= 6) {
        vbss_stream_expect(stream, 7, created.call_budget);
    }
}

static void visit_needle_grasp(vbss_stream *stream, scene_needle_grasp *grasp)
{
    uint32_t words[] = {grasp->needle, grasp->is_sliding, grasp->is_released,
                        grasp->needs_reopening};
    double *numbers[] = {&grasp->arc,  &grasp->angle,  &grasp->age,
                         &grasp->slid, &grasp->turned, &grasp->limit};
    vbss_stream_u32(stream, 130, words, sizeof words / sizeof words[0]);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_f64(stream, 131, numbers[i], 1);
    }
    vbss_stream_f64(stream, 132, &grasp->pose_in_jaws.position.x, 3);
    vbss_stream_f64(stream, 133, &grasp->pose_in_jaws.orientation.w, 4);
    vbss_stream_f64(stream, 134, &grasp->force.x, 3);
    vbss_stream_f64(stream, 135, &grasp->torque.x, 3);
    if (words[1] > 1 || words[2] > 1 || words[3] > 1) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such flag");
    }
    grasp->needle = words[0];
    grasp->is_sliding = words[1] != 0;
    grasp->is_released = words[2] != 0;
    grasp->needs_reopening = words[3] != 0;
}

static bool is_valid_needle_grasp(const scene_object *s, const scene_needle_grasp *grasp)
{
    const scene_body *b = vbss_scene_body(s, grasp->needle);
    if (grasp->needle == 0) {
        return true;
    }
    if (b == NULL || b->kind != SCENE_BODY_RIGID || b->rigid.needle == NULL) {
        return false;
    }
    quat q = grasp->pose_in_jaws.orientation;
    return grasp->arc >= 0.0 && grasp->arc <= vbss_needle_length(b->rigid.needle) &&
           (s->method->grasps_when_closed ? grasp->angle == 0.0 : grasp->angle > 0.0) &&
           grasp->angle <= 1.6 && grasp->age >= 0.0 && isfinite(grasp->age) &&
           isfinite(grasp->slid) && isfinite(grasp->turned) && isfinite(grasp->limit) &&
           vec3_norm(grasp->pose_in_jaws.position) <= 2.0 && /* jaws are at most 1 m long */
           fabs(quat_dot(q, q) - 1.0) < 1e-6 && vec3_is_finite(grasp->force) &&
           vec3_is_finite(grasp->torque);
}

static void visit_wall_grasp(vbss_stream *stream, scene_wall_grasp *p)
{
    uint32_t words[] = {p->drain, p->point_count, p->is_sliding, p->is_released,
                        p->needs_reopening};
    double *numbers[] = {&p->angle, &p->age, &p->slid, &p->limit};
    vbss_stream_u32(stream, 136, words, sizeof words / sizeof words[0]);
    vbss_stream_u32(stream, 137, p->triangle, SCENE_WALL_GRASP_POINTS);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_f64(stream, 138, numbers[i], 1);
    }
    for (uint32_t k = 0; k < SCENE_WALL_GRASP_POINTS; k++) {
        vbss_stream_f64(stream, 139, p->weights[k], 3);
        vbss_stream_f64(stream, 139, &p->points_in_jaws[k].x, 3);
    }
    vbss_stream_f64(stream, 139, &p->force.x, 3);
    if (words[2] > 1 || words[3] > 1 || words[4] > 1) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such flag");
    }
    p->drain = words[0];
    p->point_count = words[1];
    p->is_sliding = words[2] != 0;
    p->is_released = words[3] != 0;
    p->needs_reopening = words[4] != 0;
}

static bool is_valid_wall_grasp(const scene_object *s, const scene_wall_grasp *p)
{
    const scene_body *b = vbss_scene_body(s, p->drain);
    if (p->drain == 0) {
        return true;
    }
    if (b == NULL || b->kind != SCENE_BODY_DRAIN || p->point_count == 0 ||
        p->point_count > SCENE_WALL_GRASP_POINTS) {
        return false;
    }
    bool is_valid = p->angle > 0.0 && p->angle <= 1.6 && p->age >= 0.0 && isfinite(p->age) &&
                    isfinite(p->slid) && isfinite(p->limit) && vec3_is_finite(p->force);
    for (uint32_t k = 0; k < p->point_count; k++) {
        const double *w = p->weights[k];
        is_valid = is_valid && p->triangle[k] < b->drain.drain->mesh.triangle_count &&
                   w[0] >= 0.0 && w[1] >= 0.0 && w[2] >= 0.0 &&
                   fabs(w[0] + w[1] + w[2] - 1.0) < 1e-9 &&
                   vec3_norm(p->points_in_jaws[k]) <= 2.0; /* jaws are at most 1 m long */
    }
    return is_valid;
}

/* Baseline method: whether the needle follows a tool that has closed on it, and its tip passes
 * through walls that exist. */
static void check_jaw_grasps(vbss_stream *stream, const scene_object *s)
{
    for (uint32_t i = 0; stream->mode == VBSS_STREAM_READ && i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_RIGID && !stream->trusted &&
            (!is_valid_needle_grasp(s, &b->rigid.needle_grasp) ||
             !is_valid_wall_grasp(s, &b->rigid.wall_grasp) || !s->method->is_valid_body(s, b))) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such needle or wall in jaws");
        }
    }
}

/* The positions of jaws are part of the state, because jaws may lag behind their target. */
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
        visit_needle_grasp(stream, &r->needle_grasp);
        visit_wall_grasp(stream, &r->wall_grasp);
    } else {
        r->needle_grasp = (scene_needle_grasp){0};
        r->wall_grasp = (scene_wall_grasp){0};
    }
}

/* State of a needle in the baseline method. Needles need no version check: older versions of
 * such scenes had none. */
static void visit_needle(vbss_stream *stream, scene_object *s, const scene_body *b)
{
    vbss_section outer = vbss_stream_open(stream, vbss_needle_kind.code, vbss_needle_kind.version);
    vbss_needle_serialise(stream, b->rigid.needle);
    vbss_stream_close(stream, outer);
    s->method->serialise_needle(stream, s, b);
}

static void visit_pending_target(vbss_stream *stream, scene_rigid *r)
{
    uint32_t has_pending_target = r->has_pending_target;
    if (stream->version >= 6) {
        vbss_stream_u32(stream, 54, &has_pending_target, 1);
        r->has_pending_target = has_pending_target == 1;
    } else {
        r->has_pending_target = false;
    }
    if (r->has_pending_target) {
        const quat *q = &r->pending_target.orientation;
        vbss_stream_f64(stream, 55, &r->pending_target.position.x, 3);
        vbss_stream_f64(stream, 56, &r->pending_target.orientation.w, 4);
        r->has_pending_target =
            vec3_is_finite(r->pending_target.position) && fabs(quat_dot(*q, *q) - 1.0) < 1e-6;
    }
    if (has_pending_target > 1 || (has_pending_target == 1 && !r->has_pending_target)) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such pose");
    }
}

static void visit_rigid(vbss_stream *stream, scene_object *s, scene_body *b)
{
    scene_rigid *r = &b->rigid;
    vbss_stream_expect(stream, 20, (uint64_t)r->kind);
    vbss_stream_expect(stream, 21, r->capsule_count);
    if (stream->version >= 2 || r->grasper != NULL) { /* older versions had no graspers */
        vbss_stream_expect(stream, 29, r->grasper != NULL);
    }
    if (stream->version >= 4 || r->needle != NULL) {
        vbss_stream_expect(stream, 19, r->needle != NULL);
    }
    vbss_stream_expect_f64(stream, 22, r->created_friction);
    for (uint32_t i = 0; r->grasper == NULL && i < r->capsule_count; i++) {
        const scene_capsule *c = &s->capsules[r->first_capsule + i];
        const double numbers[] = {c->local[0].x, c->local[0].y, c->local[0].z, c->local[1].x,
                                  c->local[1].y, c->local[1].z, c->radius};
        for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++) {
            vbss_stream_expect_f64(stream, 23, numbers[k]);
        }
    }
    if (r->is_static_mesh || r->is_rigid_mesh) {
        vbss_stream_expect(stream, 24, r->mesh.geometry_hash);
    }
    if (r->is_plane) {
        const double numbers[] = {r->plane.normal.x, r->plane.normal.y, r->plane.normal.z,
                                  r->plane.height};
        for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++) {
            vbss_stream_expect_f64(stream, 25, numbers[k]);
        }
    }
    if (r->surface != NULL) {
        vbss_scene_serialise_host_surface(stream, r);
    }
    if (r->grasper != NULL) {
        visit_grasper(stream, s, r);
    }
    if (r->needle != NULL) {
        visit_needle(stream, s, b);
    }
    vbss_rigid_serialise(stream, 30, &r->body);
    visit_pending_target(stream, r);
    vbss_stream_f64(stream, 50, &r->force.x, 3);
    vbss_stream_f64(stream, 51, &r->torque.x, 3);
    vbss_stream_f64(stream, 52, &r->coupling_wrench.force.x, 3);
    vbss_stream_f64(stream, 53, &r->coupling_wrench.torque.x, 3);
}

static void visit_thread(vbss_stream *stream, scene_thread *b)
{
    const uint32_t nodes = b->thread->node_count;
    vbss_stream_u32(stream, 60, &b->contact_free_steps, 1);
    vbss_section outer = vbss_stream_open(stream, vbss_thread_kind.code, vbss_thread_kind.version);
    vbss_thread_serialise(stream, b->thread);
    vbss_stream_close(stream, outer);
    if (!scene_thread_resizes(b->thread) &&
        b->thread->node_count != nodes) { /* the scene has numbered its nodes for this count */
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
    if (b->drain->config.tear_energy > 0.0) {
        vbss_stream_expect_f64(stream, 65, b->drain->config.tear_energy);
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
    vbss_stream_expect(stream, 10, s->body_count);
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->is_reserved) {
            vbss_scene_serialise_piece(stream, s, b);
        } else {
            vbss_stream_expect(stream, 11, (uint64_t)b->kind);
        }
        if (b->kind == SCENE_BODY_NONE) {
            continue;
        }
        if (!b->is_reserved) {
            vbss_stream_expect(stream, 12, b->number);
        }
        if (b->kind == SCENE_BODY_THREAD) {
            if (!scene_thread_resizes(b->thread.thread)) {
                vbss_stream_expect(stream, 13, b->thread.thread->node_count);
            }
            visit_thread(stream, &b->thread);
        } else if (b->kind == SCENE_BODY_DRAIN) {
            vbss_stream_expect(stream, 14, b->drain.drain->mesh.node_count);
            visit_drain(stream, &b->drain);
        } else {
            visit_rigid(stream, s, b);
        }
    }
    vbss_scene_restore_pieces(stream, s);
    check_jaw_grasps(stream, s);
}

/* Whether a pin is an attachment or a valid weld. A weld fixes a node that nothing else holds to
 * a body that is not driven. */
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
    return s->method->welds_pins && body != NULL && body->rigid.kind != VBSS_SCENE_RIGID_DRIVEN &&
           vbss_scene_find_weld(s, p->thread, p->node) == p; /* all earlier pins have been read */
}

static void visit_pins(vbss_stream *stream, scene_object *s)
{
    vbss_stream_u32(stream, 70, &s->last_pin_id, 1);
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
        bool thread =
            t != NULL && t->kind == SCENE_BODY_THREAD && p->node < t->thread.thread->node_count;
        bool body = p->body == 0 ? p->attachment != 0 : b != NULL && b->kind == SCENE_BODY_RIGID;
        if (!thread || !body || p->id > s->last_pin_id ||
            !is_weld_or_attached(s, p, b, t->thread.thread)) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such pin");
        }
    }
}

/* The format has no flag for an uncuttable strand: it is a released one that was never held, and so
 * has no anchors. */
static bool was_held(const scene_thread_grasp *g)
{
    double sum = 0.0;
    for (uint32_t k = 0; k < GRASPER_THREAD_POINTS; k++) {
        sum += vec3_norm_squared(g->grip.anchor[k]);
    }
    return sum != 0.0;
}

static void visit_thread_grasp(vbss_stream *stream, scene_thread_grasp *g, uint32_t *pin)
{
    uint32_t excluded = g->is_released || g->is_uncuttable;
    uint32_t words[] = {g->thread, g->tool, g->segment,        g->is_sliding,
                        excluded,  *pin,    g->needs_reopening};
    double *numbers[] = {&g->segment_offset, &g->angle, &g->point_spacing,
                         &g->grip.age,       &g->slid,  &g->limit};
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
    g->is_sliding = words[3] != 0;
    if (stream->mode == VBSS_STREAM_READ) {
        g->is_uncuttable = words[4] != 0 && !was_held(g);
        g->is_released = words[4] != 0 && !g->is_uncuttable;
    }
    *pin = words[5];
    g->needs_reopening = words[6] != 0;
}

static bool is_valid_thread_grasp(const scene_object *s, const scene_thread_grasp *g)
{
    const scene_body *t = vbss_scene_body(s, g->thread), *b = vbss_scene_body(s, g->tool);
    if (t == NULL || t->kind != SCENE_BODY_THREAD || b == NULL || b->kind != SCENE_BODY_RIGID ||
        b->rigid.grasper == NULL || g->id > s->last_grasp_id) {
        return false;
    }
    const thread_object *thread = t->thread.thread;
    /* the grasp holds a node by a pin */
    bool is_of_node = s->method->grasps_when_closed && scene_holds_strand(g);
    bool is_valid = g->segment + (is_of_node ? 0 : 1) < thread->node_count &&
                    isfinite(g->segment_offset) && fabs(g->segment_offset) <= 1e3 &&
                    isfinite(g->angle) && isfinite(g->slid) && isfinite(g->limit) &&
                    vec3_is_finite(g->force) &&
                    (is_of_node ? g->point_spacing == 0.0 : g->point_spacing > 0.0) &&
                    g->point_spacing <= 0.1 && g->grip.age >= 0.0 && isfinite(g->grip.age);
    for (uint32_t k = 0; k < GRASPER_THREAD_POINTS; k++) {
        is_valid = is_valid && vec3_is_finite(g->grip.anchor[k]);
    }
    return is_valid;
}

static void visit_grasp_place(vbss_stream *stream, scene_object *s, uint32_t i)
{
    scene_thread_grasp *g = &s->thread_grasps[i];
    uint32_t *own_pin = s->method->grasp_pin(s, i), pin = own_pin != NULL ? *own_pin : 0;
    vbss_stream_u32(stream, 125, &g->id, 1);
    if (g->id != 0) {
        visit_thread_grasp(stream, g, &pin);
    } else if (stream->mode == VBSS_STREAM_READ) {
        *g = (scene_thread_grasp){0};
        pin = 0;
    }
    if (own_pin != NULL) {
        *own_pin = pin;
    }
    if (g->id != 0 && stream->mode == VBSS_STREAM_READ && !stream->trusted &&
        (!is_valid_thread_grasp(s, g) || (own_pin == NULL && pin != 0))) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such grasp");
    }
}

static void visit_thread_grasps(vbss_stream *stream, scene_object *s)
{
    if (stream->version < 2) {
        memset(s->thread_grasps, 0, s->config.grasp_capacity * sizeof *s->thread_grasps);
        return;
    }
    vbss_stream_u32(stream, 120, &s->last_grasp_id, 1);
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        visit_grasp_place(stream, s, i);
    }
}

static bool is_valid_hole(const scene_object *s, const suture_hole *hole)
{
    const scene_body *n = vbss_scene_body(s, hole->needle), *t = vbss_scene_body(s, hole->thread);
    const scene_body *d = vbss_scene_body(s, hole->wall);
    bool needle = n != NULL && n->kind == SCENE_BODY_RIGID && n->rigid.needle != NULL;
    bool thread = t != NULL && t->kind == SCENE_BODY_THREAD && suture_is_curve(t->thread.thread);
    return hole->id <= s->last_hole_id && (hole->needle != 0 ? needle : thread) &&
           scene_is_wall(d) && hole->triangle < vbss_scene_wall_of(d).triangle_count &&
           vbss_hole_is_valid(hole);
}

static void visit_holes(vbss_stream *stream, scene_object *s)
{
    if (stream->version < 4) {
        memset(s->holes, 0, s->config.hole_capacity * sizeof *s->holes);
        s->last_hole_id = 0;
        return;
    }
    vbss_stream_u32(stream, 140, &s->last_hole_id, 1);
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        suture_hole *hole = &s->holes[i];
        vbss_hole_serialise(stream, 141, hole);
        bool check = stream->mode == VBSS_STREAM_READ && !stream->trusted && hole->id != 0;
        if (check && !is_valid_hole(s, hole)) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such hole");
            *hole = (suture_hole){0};
        }
    }
}

/* Removes all that is known of tears. */
static void forget_tears(scene_object *s)
{
    s->report.statistics.torn_length = s->report.statistics.tear_work = 0.0;
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        suture_hole *hole = &s->holes[i];
        hole->tear = SUTURE_HOLDS;
        hole->free_side = 0;
        hole->torn_length = hole->tear_work = 0.0;
    }
}

/* Scenes in which nothing has torn do not have this section: their states are those of versions without
 * tears. */
static void visit_tears(vbss_stream *stream, scene_object *s)
{
    const uint32_t code = VBSS_CODE('T', 'E', 'A', 'R');
    vbss_scene_statistics *c = &s->report.statistics;
    const bool is_reading = stream->mode == VBSS_STREAM_READ;
    if (is_reading) {
        forget_tears(s);
    }
    if (is_reading ? !vbss_stream_has_section(stream, code) : c->torn_length == 0.0) {
        return;
    }
    vbss_section outer = vbss_stream_open(stream, code, 1);
    vbss_stream_f64(stream, 1, &c->torn_length, 1);
    vbss_stream_f64(stream, 2, &c->tear_work, 1);
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        if (s->holes[i].id != 0) {
            vbss_suture_serialise_tear(stream, 3, &s->holes[i]);
        }
    }
    vbss_stream_close(stream, outer);
    if (is_reading && (!(c->torn_length > 0.0) || !(c->tear_work > 0.0))) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such tears");
        forget_tears(s);
    }
}

static void visit_common_statistics(vbss_stream *stream, vbss_scene_statistics *s)
{
    vbss_stream_u32(stream, 80, &s->contacts, 3); /* contacts, rows, separators */
    vbss_stream_u64(stream, 81, &s->steps, 5);    /* steps .. state_solves */
    /* `patterns` is left out, because it depends on whether a sparsity pattern is in memory. */
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

/* Counters of method VBLAST have the places in the stream that its snapshots have always used. They
 * are counters of method IMPLICIT that are 0 in its scenes. */
static void visit_statistics(vbss_stream *stream, scene_object *s)
{
    vbss_scene_statistics *c = &s->report.statistics;
    vbss_baseline_statistics *own = s->method->baseline_statistics(s);
    if (own == NULL) {
        visit_common_statistics(stream, c);
        return;
    }
    c->rows = own->last_candidates;
    c->attempts = own->passes;
    c->guard_pairs = own->tested_pairs;
    c->loose_states = own->unconverged_steps;
    visit_common_statistics(stream, c);
    own->last_candidates = c->rows;
    own->passes = c->attempts;
    own->tested_pairs = c->guard_pairs;
    own->unconverged_steps = c->loose_states;
    c->rows = 0;
    c->attempts = c->guard_pairs = c->loose_states = 0;
}

/* Replaces a size in the snapshot if bodies begin with different sizes, which follow.
 * Unit: 1. Origin: chosen: no size is negative. Test: scene.islands. */
#define SIZE_PER_BODY (-1.0)

/* Whether all bodies begin the next step with substeps of one size, a fraction of a step. */
static bool have_bodies_one_size(const scene_object *s, double *size)
{
    const scene_body *first = NULL;
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        first = first == NULL && b->kind != SCENE_BODY_NONE ? b : first;
        if (b->kind != SCENE_BODY_NONE && b->next_halvings != first->next_halvings) {
            return false;
        }
    }
    *size = first == NULL ? 1.0 : vbss_scene_substep_size(first->next_halvings);
    return true;
}

/* Sizes with which the next step begins. Before version 3 a step was never left incomplete. */
static void visit_next_sizes(vbss_stream *stream, scene_object *s)
{
    double size = SIZE_PER_BODY;
    (void)have_bodies_one_size(s, &size);
    if (stream->version >= 3) {
        vbss_stream_f64(stream, 86, &size, 1);
    } else {
        size = 1.0;
    }
    const bool reads = stream->mode == VBSS_STREAM_READ, is_per_body = size == SIZE_PER_BODY;
    if (reads && !is_per_body && !vbss_scene_is_substep_size(s, size)) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such part of a step");
        size = 1.0;
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (is_per_body && b->kind != SCENE_BODY_NONE) {
            vbss_stream_u32(stream, 89, &b->next_halvings, 1);
        } else if (reads) {
            b->next_halvings = b->kind != SCENE_BODY_NONE ? vbss_scene_halvings_of(size) : 0;
        }
        if (reads && (b->next_halvings > SCENE_MAX_HALVINGS ||
                      !vbss_scene_is_substep_size(s, vbss_scene_substep_size(b->next_halvings)))) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such part of a step");
            b->next_halvings = 0;
        }
    }
}

/* Marks welded nodes in their threads, so that hosts cannot attach them. */
static void set_welded_flags(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind == SCENE_BODY_THREAD) {
            thread_object *t = s->bodies[i].thread.thread;
            memset(t->welded, 0, t->node_count * sizeof *t->welded);
        }
    }
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        const scene_pin *p = &s->pins[i];
        const scene_body *t = vbss_scene_body(s, p->thread);
        if (p->id != 0 && p->attachment == 0 && t != NULL && t->kind == SCENE_BODY_THREAD &&
            p->node < t->thread.thread->node_count) { /* the stream may be refused for it later */
            t->thread.thread->welded[p->node] = 1;
        }
    }
}

void vbss_scene_serialise(vbss_stream *stream, void *object)
{
    scene_object *s = object;
    visit_config(stream, s);
    vbss_stream_u32(stream, 3, &s->last_body_number, 1);
    if (s->last_body_number > SCENE_MAX_SHAPES) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "more bodies than a scene can have had");
        s->last_body_number = SCENE_MAX_SHAPES;
    }
    visit_bodies(stream, s);
    visit_pins(stream, s);
    visit_thread_grasps(stream, s);
    visit_holes(stream, s);
    visit_tears(stream, s);
    if (s->contacts != NULL) {
        vbss_contact_serialise(stream, 90, s->contacts);
    }
    vbss_stream_count(stream, 110, &s->report.touching_pair_count, s->config.contact_capacity);
    vbss_stream_u32(stream, 111, &s->report.touching_pairs->body_a,
                    2 * (size_t)s->report.touching_pair_count);
    visit_statistics(stream, s);
    visit_next_sizes(stream, s);
    vbss_scene_visit_cursor(stream, s);
    if (stream->mode == VBSS_STREAM_READ) {
        set_welded_flags(s);
        s->step.pattern_hash = 0;
        s->report.logged_event_count = 0;
        s->events = (scene_events){.ring = s->events.ring, .pending = s->events.pending};
        s->report.generation++;
    }
    if (stream->trusted) {
        vbss_scene_visit_report(stream, s);
    }
}
