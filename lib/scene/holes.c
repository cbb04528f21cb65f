/* Holes in a scene, and the suture that slides through. */
#include "base/check.h"
#include "base/error.h"
#include "scene/hole_exclusion.h"
#include "scene/events.h"
#include "scene/holes.h"
#include "scene/contacts.h"
#include "scene/tools.h"

#include <string.h>

/* A tip that is so much further out than when it entered has left: tremor does not make a hole twice; so does an end of the
 * suture, and the swage changes sides. m. */
#define EXIT_DISTANCE 0.2e-3
/* Where the swage may pass in a part, nodes of both sides take part; m. */
#define NEAR_SWAGE 2e-3
/* Of the sum of weights. */
#define WEIGHT_ROUNDING 1e-9

/* ---- who is in it */

/* The weld of a thread's begin to the end of a needle. */
static bool is_swage(const scene_object *s, const scene_pin *p)
{
    if (p->id == 0 || p->attachment != 0 || p->node != 0) {
        return false;
    }
    const scene_rigid *r = &vbss_scene_body(s, p->body)->rigid;
    if (r->needle == NULL || !suture_is_curve(vbss_scene_body(s, p->thread)->thread.thread)) {
        return false;
    }
    return vec3_distance(pose_apply(r->frame, p->point), r->needle->swage) <=
           r->needle->config.wire_radius;
}

const scene_body *vbss_scene_swaged_thread(const scene_object *s, const scene_body *needle)
{
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        if (s->pins[i].body == needle->number && is_swage(s, &s->pins[i])) {
            return vbss_scene_body(s, s->pins[i].thread);
        }
    }
    return NULL;
}

const scene_body *vbss_scene_swaged_needle(const scene_object *s, const scene_body *thread)
{
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        if (s->pins[i].thread == thread->number && is_swage(s, &s->pins[i])) {
            return vbss_scene_body(s, s->pins[i].body);
        }
    }
    return NULL;
}

typedef struct hole_context {
    const scene_body *needle, *thread; /* NULL: none */
    const scene_drain *drain;
    suture_curve now, trial;
    double arc; /* of the hole, along the line */
} hole_context;

static hole_context get_hole_context(const scene_object *s, const suture_hole *hole)
{
    hole_context p = {.drain = &vbss_scene_body(s, hole->drain)->drain, .arc = hole->arc};
    if (hole->needle != 0) {
        p.needle = vbss_scene_body(s, hole->needle);
        p.thread = vbss_scene_swaged_thread(s, p.needle);
    } else {
        p.thread = vbss_scene_body(s, hole->thread);
        p.needle = vbss_scene_swaged_needle(s, p.thread);
    }
    if (p.needle != NULL) {
        const scene_rigid *r = &p.needle->rigid;
        p.now.needle = r->needle;
        p.now.needle_pose = vbss_scene_needle_frame(r, r->body.now.pose);
        p.now.swage_arc = vbss_needle_length(r->needle);
        p.trial.needle_pose = vbss_scene_needle_frame(r, r->trial);
    }
    if (p.thread != NULL) {
        p.now.thread = p.thread->thread.thread;
        p.now.node_positions = p.now.thread->now.x;
        p.trial.node_positions = p.now.thread->trial;
    }
    p.trial.needle = p.now.needle;
    p.trial.thread = p.now.thread;
    p.trial.swage_arc = p.now.swage_arc;
    p.arc += hole->thread != 0 ? p.now.swage_arc : 0.0;
    return p;
}

static suture_curve_point current_curve_point(const hole_context *p, const suture_hole *hole)
{
    const drain_object *d = p->drain->drain;
    return vbss_suture_nearest_point(&p->now, p->arc, vbss_hole_point(hole, d, d->x));
}

/* ---- rows */

bool vbss_scene_add_hole_constraints(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *hole = &s->holes[i];
        if (hole->id == 0) {
            continue;
        }
        const contact_key key = {VBSS_CONTACT_HOLE, hole->needle != 0 ? hole->needle : hole->thread,
                                 i, hole->drain, 0};
        contact_constraint *constraint = vbss_scene_add_bilateral_constraint(s, &key);
        if (constraint == NULL) {
            return false;
        }
        constraint->is_sleeve = true;
    }
    return true;
}

/* What a place has of a node. */
static double node_value(const suture_curve_point *curve_point,
                         const double values[SUTURE_SPAN_NODES], uint32_t node)
{
    bool own = curve_point->span != SUTURE_ON_NEEDLE && node >= curve_point->first_node &&
               node < curve_point->first_node + SUTURE_SPAN_NODES;
    return own ? values[node - curve_point->first_node] : 0.0;
}

/* Needle and the node that is the swage's move as one: weights and points add up. What nodes behind it lose as the place
 * slides on, the needle gains. */
static void add_needle_jacobian(contact_constraint *constraint, const hole_context *p,
                                const suture_curve_point *curve_point)
{
    const suture_curve *line = &p->trial;
    const double of_end = node_value(curve_point, curve_point->weights, 0);
    const double weight = curve_point->needle_weight + of_end;
    const vec3 end = line->needle->swage;
    vec3 point = vec3_scale(curve_point->needle_point, curve_point->needle_weight);
    point = vec3_add_scaled(point, of_end, end);
    point = weight > 0.0 ? vec3_scale(point, 1.0 / weight) : end;
    vbss_scene_add_rigid_jacobian(constraint, &p->needle->rigid,
                                  pose_apply(line->needle_pose, point), weight);
    contact_jacobian_block *translation =
                               &constraint->jacobian[constraint->jacobian_block_count - 2],
                           *rotation = translation + 1;
    if (curve_point->span == SUTURE_ON_NEEDLE) {
        rotation->weighted_arm_derivative =
            vec3_neg(curve_point->tangent); /* toward the tip, from which the arc is counted */
    } else if (curve_point->first_node == 0) {
        const vec3 centre = p->needle->rigid.trial.position;
        const double end_gains = curve_point->weight_derivatives[0];
        for (uint32_t i = 1; i < SUTURE_SPAN_NODES; i++) {
            translation->weight_derivative -= curve_point->weight_derivatives[i];
        }
        rotation->weighted_arm_derivative =
            vec3_scale(vec3_sub(pose_apply(line->needle_pose, end), centre), end_gains);
        rotation->weighted_arm_derivative = vec3_add_scaled(
            rotation->weighted_arm_derivative, translation->weight_derivative - end_gains,
            vec3_sub(pose_apply(line->needle_pose, curve_point->needle_point), centre));
    }
}

/* The nodes of a span and of those beside it, with what the place weighs them: it may slide on to those. */
static void add_thread_jacobian(const scene_object *s, contact_constraint *constraint,
                                const hole_context *p, const suture_curve_point *curve_point,
                                uint32_t span)
{
    const thread_object *t = p->thread->thread.thread;
    uint32_t first = span > 2 ? span - 2 : 0, last = t->node_count - 1;
    last = span + 3 < last ? span + 3 : last;
    first = p->needle != NULL && first == 0 ? 1 : first; /* the swage is the needle's */
    for (uint32_t i = first; i <= last; i++) {
        uint32_t needed = t->welded[i] != 0 ? 2 : 1;
        if (constraint->jacobian_block_count + needed >
            CONTACT_MAX_JACOBIAN_BLOCKS - 3) { /* welds beside each other */
            break;
        }
        const uint32_t from = constraint->jacobian_block_count;
        vbss_scene_add_node_jacobian(s, constraint, p->thread, i,
                                     node_value(curve_point, curve_point->weights, i));
        for (uint32_t k = from; k < constraint->jacobian_block_count; k++) {
            contact_jacobian_block *term = &constraint->jacobian[k];
            term->weight_derivative = node_value(curve_point, curve_point->weight_derivatives, i);
            term->weighted_arm_derivative = vec3_scale(term->arm, term->weight_derivative);
        }
    }
}

/* Which span it may slide on from in this part: its pattern is made once. */
static uint32_t choose_span(const hole_context *p, double arc)
{
    bool far = p->thread == NULL || (p->needle != NULL && arc < p->now.swage_arc - NEAR_SWAGE);
    return far ? SUTURE_ON_NEEDLE : vbss_suture_span_at(&p->trial, arc);
}

void vbss_scene_update_hole_constraint(scene_object *s, contact_constraint *constraint)
{
    const suture_hole *hole = &s->holes[constraint->key.feature_a];
    const hole_context p = get_hole_context(s, hole);
    const drain_object *d = p.drain->drain;
    const vec3 point = vbss_hole_point(hole, d, d->trial);
    if (constraint->jacobian_block_count == 0) {
        const suture_curve_point before = current_curve_point(&p, hole);
        constraint->start_arc_length = before.arc;
        constraint->span = choose_span(&p, vbss_suture_nearest_point(&p.trial, p.arc, point).arc);
        constraint->solution.status = CONTACT_STICK;
        const hole_yield_limit bound = vbss_hole_yield_limit(hole, &d->config, &p.now, &before);
        constraint->yield_force = bound.force;
        constraint->yield_friction[0] = bound.friction[0];
        constraint->yield_friction[1] = bound.friction[1];
    }
    uint32_t span = constraint->span;
    suture_curve line = p.trial;
    line.thread = span == SUTURE_ON_NEEDLE ? NULL : line.thread;
    const suture_curve_point now =
        span == SUTURE_ON_NEEDLE ? vbss_suture_nearest_point(&line, p.arc, point)
                                 : vbss_suture_nearest_point_around_span(&line, span, p.arc, point);
    vbss_hole_set_constraint(hole, &d->config, &now, point, s->substep_length, constraint);
    constraint->jacobian_block_count = 0;
    if (p.needle != NULL && (span == SUTURE_ON_NEEDLE || span <= 2)) {
        add_needle_jacobian(constraint, &p, &now);
    }
    if (span != SUTURE_ON_NEEDLE) {
        add_thread_jacobian(s, constraint, &p, &now, span);
    }
    for (uint32_t k = 0; k < 3; k++) {
        uint32_t node = d->mesh.triangles[hole->triangle][k];
        constraint->jacobian[constraint->jacobian_block_count++] =
            (contact_jacobian_block){.block = p.drain->first_block + d->order.block_index[node],
                                     .weight = -hole->barycentric[k]};
    }
}

void vbss_scene_add_hole_separators(const scene_object *s, const contact_constraint *constraint)
{
    const suture_hole *hole = &s->holes[constraint->key.feature_a];
    const hole_context p = get_hole_context(s, hole);
    for (uint32_t k = 0; k < 3; k++) {
        p.drain->is_separator[p.drain->drain->mesh.triangles[hole->triangle][k]] = 1;
    }
    for (uint32_t k = 0; p.thread != NULL && k < constraint->jacobian_block_count; k++) {
        uint32_t node = constraint->jacobian[k].block - p.thread->thread.first_block;
        if (constraint->jacobian[k].block >= p.thread->thread.first_block &&
            node < p.now.thread->node_count) {
            s->is_separator[p.thread->thread.first_node + node] = 1;
        }
    }
}

void vbss_scene_commit_holes(scene_object *s)
{
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        const contact_constraint *constraint = &s->contacts->constraints[i];
        if (constraint->key.kind == VBSS_CONTACT_HOLE) {
            vbss_hole_store_forces(&s->holes[constraint->key.feature_a], constraint);
        }
    }
}

/* Its place along the line, of the needle or of the thread behind: that which is in it stays so for a while beyond the
 * swage. */
static void move_hole_to(suture_hole *hole, const hole_context *p, double arc)
{
    double swage = p->now.swage_arc + (hole->thread != 0 ? -EXIT_DISTANCE : EXIT_DISTANCE);
    if (p->thread != NULL && (p->needle == NULL || arc > swage)) {
        hole->needle = 0;
        hole->thread = p->thread->number;
        hole->arc = arc - p->now.swage_arc;
    } else if (p->needle != NULL) {
        hole->needle = p->needle->number;
        hole->thread = 0;
        vbss_hole_set_arc(hole, arc);
    }
}

void vbss_scene_advance_holes(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        if (s->holes[i].id != 0) {
            const hole_context p = get_hole_context(s, &s->holes[i]);
            move_hole_to(&s->holes[i], &p, current_curve_point(&p, &s->holes[i]).arc);
        }
    }
}

void vbss_scene_find_trial_slides(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        suture_hole *hole = &s->holes[i];
        if (hole->id != 0) {
            const hole_context p = get_hole_context(s, hole);
            const vec3 point = vbss_hole_point(hole, p.drain->drain, p.drain->drain->trial);
            hole->trial_slide = vbss_suture_nearest_point(&p.trial, p.arc, point).arc - p.arc;
        }
    }
}

/* ---- after a step */

static void emit_hole_event(scene_object *s, vbss_event_kind kind, const suture_hole *hole)
{
    uint32_t body = hole->needle != 0 ? hole->needle : hole->thread;
    vbss_scene_add_event(s, kind, body, hole->drain, hole->id);
}

void vbss_scene_record_holes_before_step(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        s->previous_holes[i] = (scene_previous_hole){s->holes[i].id, s->holes[i].needle};
    }
}

static void emit_swage_event(scene_object *s, const scene_previous_hole *before,
                             const suture_hole *hole)
{
    if (before->id == hole->id && (before->needle == 0) != (hole->needle == 0)) {
        vbss_event_kind kind = hole->needle == 0 ? VBSS_EVENT_PASSED : VBSS_EVENT_RETURNED;
        uint32_t needle = hole->needle == 0 ? before->needle : hole->needle;
        vbss_scene_add_event(s, kind, needle, hole->drain, hole->id);
    }
}

/* How it is left, or 0. */
static vbss_event_kind exit_event(const hole_context *p, const suture_hole *hole)
{
    const thread_object *t = p->now.thread;
    if (hole->needle == 0 && t != NULL) {
        double end = vbss_thread_arc_length(t, t->node_count - 1);
        bool out =
            hole->arc > end + EXIT_DISTANCE || (p->needle == NULL && hole->arc < -EXIT_DISTANCE);
        return out ? VBSS_EVENT_UNTHREADED : 0;
    }
    double end = vbss_needle_length(p->now.needle) - hole->entry_arc + EXIT_DISTANCE;
    return hole->arc < hole->entry_arc - EXIT_DISTANCE ? VBSS_EVENT_WITHDRAWN
           : t == NULL && hole->arc > end              ? VBSS_EVENT_PASSED
                                                       : 0;
}

bool vbss_scene_is_in_other_hole(const scene_object *s, const suture_hole *hole, double arc)
{
    const needle_object *n = vbss_scene_body(s, hole->needle)->rigid.needle;
    const drain_object *d = vbss_scene_body(s, hole->drain)->drain.drain;
    const double contact_distance = n->config.wire_radius + 0.5 * d->config.thickness;
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *other = &s->holes[i];
        if (other != hole && other->id != 0 && other->needle == hole->needle &&
            other->drain == hole->drain &&
            fabs(other->arc - arc) < SCENE_EXCLUSION_ARC_RATIO * contact_distance) {
            return true;
        }
    }
    return false;
}

/* A tip that has entered aslant may go through beside its hole and be withdrawn from that only: the hole is then where the
 * needle is in the wall. */
static bool relocate_hole(const scene_object *s, const hole_context *p, suture_hole *hole)
{
    if (s->config.method != VBSS_METHOD_OURS || hole->needle == 0) {
        return false;
    }
    const needle_object *n = p->needle->rigid.needle;
    for (uint32_t i = 0; i < n->config.segment_count; i++) {
        const double start = vbss_needle_vertex_arc(n, i), end = vbss_needle_vertex_arc(n, i + 1);
        const vec3 axis[2] = {pose_apply(p->now.needle_pose, vbss_needle_point(n, start)),
                              pose_apply(p->now.needle_pose, vbss_needle_point(n, end))};
        suture_hole relocated = *hole;
        double fraction;
        if (vbss_suture_find_wall_crossing(p->drain->drain, axis, &relocated, &fraction) &&
            !vbss_scene_is_in_other_hole(s, hole, start + fraction * (end - start))) {
            *hole = relocated;
            hole->friction_force = 0.0;
            hole->transverse_force = vec3_zero();
            vbss_hole_set_arc(hole, start + fraction * (end - start));
            return true;
        }
    }
    return false;
}

void vbss_scene_close_exited_holes(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        suture_hole *hole = &s->holes[i];
        if (hole->id == 0) {
            continue;
        }
        const hole_context p = get_hole_context(s, hole);
        vbss_event_kind out = exit_event(&p, hole);
        emit_swage_event(s, &s->previous_holes[i], hole);
        bool stays = out == VBSS_EVENT_WITHDRAWN && relocate_hole(s, &p, hole);
        if (out != 0 && !stays) {
            emit_hole_event(s, out, hole);
            *hole = (suture_hole){0};
        }
    }
}

/* Moves a cut to where an end has left; true: it was in the hole. */
static bool move_cut_out_of_hole(const suture_hole *hole, double *arc_length)
{
    double beyond = *arc_length - hole->arc;
    bool is_inside = fabs(beyond) < EXIT_DISTANCE;
    *arc_length =
        is_inside ? hole->arc + (beyond < 0.0 ? -EXIT_DISTANCE : EXIT_DISTANCE) : *arc_length;
    return is_inside;
}

double vbss_scene_move_cut_out_of_holes(const scene_object *s, uint32_t thread, double arc_length)
{
    bool moved = true;
    for (uint32_t times = 0; moved && times < s->config.hole_capacity; times++) {
        moved = false; /* beside one hole may be another that was looked at before */
        for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
            const suture_hole *hole = &s->holes[i];
            bool own = hole->id != 0 && hole->thread == thread;
            moved = (own && move_cut_out_of_hole(hole, &arc_length)) || moved;
        }
    }
    return arc_length;
}

static suture_hole *find_free_hole(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        if (s->holes[i].id == 0) {
            return &s->holes[i];
        }
    }
    return NULL;
}

void vbss_scene_add_hole(scene_object *s, suture_hole *made)
{
    suture_hole *hole = find_free_hole(s);
    if (hole == NULL) {
        emit_hole_event(s, VBSS_EVENT_HOLE_LOST, made);
        return;
    }
    made->id = ++s->last_hole_id;
    *hole = *made;
    emit_hole_event(s, VBSS_EVENT_PUNCTURE, hole);
}

void vbss_scene_remove_holes_of(scene_object *s, uint32_t number)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *hole = &s->holes[i];
        if (hole->needle == number || hole->thread == number || hole->drain == number) {
            s->holes[i] = (suture_hole){0};
        }
    }
}

void vbss_scene_divide_holes(scene_object *s, uint32_t thread, uint32_t piece, double arc_length)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        suture_hole *hole = &s->holes[i];
        if (hole->id != 0 && hole->thread == thread && hole->arc > arc_length) {
            hole->thread = piece;
            hole->arc -= arc_length;
        }
    }
}

void vbss_scene_close_holes_of_short_threads(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        suture_hole *hole = &s->holes[i];
        if (hole->id != 0 && hole->thread != 0 &&
            !suture_is_curve(vbss_scene_body(s, hole->thread)->thread.thread)) {
            emit_hole_event(s, VBSS_EVENT_UNTHREADED, hole);
            *hole = (suture_hole){0};
        }
    }
}

/* ---- made by the host */

static vbss_result check_weights(vbss_context *context, const double *weights)
{
    double sum = 0.0;
    VBSS_TRY(vbss_check_pointer(context, weights, "weights"));
    VBSS_TRY(vbss_check_finite(context, weights, 3, "weights"));
    for (int k = 0; k < 3; k++) {
        VBSS_TRY(vbss_check_range(context, weights[k], 0.0, 1.0, "weights"));
        sum += weights[k];
    }
    return vbss_check_range(context, sum, 1.0 - WEIGHT_ROUNDING, 1.0 + WEIGHT_ROUNDING,
                            "the sum of weights");
}

static vbss_result check_suture(const scene_object *s, const scene_body *suture, uint32_t body,
                                double arc_length)
{
    if (suture == NULL || !vbss_scene_is_suture(suture)) {
        return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE, "body %u is no needle or thread",
                         body);
    }
    bool thread = suture->kind == SCENE_BODY_THREAD;
    const thread_object *t = suture->thread.thread;
    if (thread && !suture_is_curve(t)) {
        return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE, "a thread of two nodes has no curve");
    }
    double length = thread ? vbss_thread_arc_length(t, t->node_count - 1)
                           : vbss_needle_length(suture->rigid.needle);
    VBSS_TRY(vbss_check_finite(s->context, &arc_length, 1, "arc_length"));
    return vbss_check_range(s->context, arc_length, 0.0, length, "arc_length");
}

static double suture_radius(const scene_body *suture)
{
    return suture->kind == SCENE_BODY_THREAD ? suture->thread.thread->config.radius
                                             : suture->rigid.needle->config.wire_radius;
}

/* The suture shall be at the place already: no nearer to the wall than where it would touch. */
static vbss_result init_hole(const scene_object *s, suture_hole *hole, const scene_body *suture)
{
    const hole_context p = get_hole_context(s, hole);
    const drain_object *d = p.drain->drain;
    const vec3 point = vbss_hole_point(hole, d, d->x);
    const suture_curve_point curve_point = vbss_suture_nearest_point(&p.now, p.arc, point);
    double offset = vec3_distance(curve_point.position, point);
    double max_offset = suture_radius(suture) + 0.5 * d->config.thickness;
    if (!(offset <= max_offset)) {
        return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE,
                         "the hole is %g m from what shall be in it: at most %g", offset,
                         max_offset);
    }
    hole->is_outward = vbss_suture_is_outward(d, hole->triangle, curve_point.tangent);
    move_hole_to(hole, &p, curve_point.arc);
    return VBSS_OK;
}

vbss_result vbss_scene_make_hole(vbss_scene *scene, uint32_t body, double arc_length,
                                 uint32_t drain, uint32_t triangle, const double *weights,
                                 uint32_t *id)
{
    scene_object *s;
    VBSS_TRY(vbss_scene_open_for_edit(scene, &s));
    const scene_body *suture = vbss_scene_body(s, body);
    const scene_body *d = vbss_scene_require_body(s, drain, SCENE_BODY_DRAIN);
    if (s->config.method == VBSS_METHOD_PAPER) {
        return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE,
                         "holes are made by hosts in scenes of method OURS");
    }
    VBSS_TRY(check_suture(s, suture, body, arc_length));
    if (d == NULL) {
        return VBSS_ERROR_OUT_OF_RANGE;
    }
    VBSS_TRY(vbss_check_range(s->context, triangle, 0.0, d->drain.drain->mesh.triangle_count - 1.0,
                              "triangle"));
    VBSS_TRY(check_weights(s->context, weights));
    suture_hole *hole = find_free_hole(s);
    if (hole == NULL) {
        return vbss_fail(s->context, VBSS_ERROR_CAPACITY, "more than %u holes",
                         s->config.hole_capacity);
    }
    suture_hole made = {
        .id = s->last_hole_id + 1, .drain = drain, .triangle = triangle, .arc = arc_length};
    made.needle = suture->kind == SCENE_BODY_RIGID ? body : 0;
    made.thread = suture->kind == SCENE_BODY_THREAD ? body : 0;
    memcpy(made.barycentric, weights, sizeof made.barycentric);
    VBSS_TRY(init_hole(s, &made, suture));
    made.max_arc = vbss_max(made.max_arc, d->drain.drain->config.tip_length); /* it is open */
    *hole = made;
    s->last_hole_id = made.id;
    s->generation++;
    if (id != NULL) {
        *id = made.id;
    }
    return VBSS_OK;
}

/* ---- looking */

vbss_result vbss_scene_get_hole(vbss_scene *scene, uint32_t index, vbss_hole *hole,
                                uint32_t struct_size)
{
    static const uint32_t sizes[] = {168, sizeof(vbss_hole), 0};
    static const vbss_layout layout = {"vbss_hole", NULL, sizes};
    scene_object *s;
    VBSS_TRY(vbss_scene_open(scene, &s));
    uint32_t left = index;
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *h = &s->holes[i];
        if (h->id == 0 || left-- > 0) {
            continue;
        }
        const hole_context p = get_hole_context(s, h);
        const drain_object *d = p.drain->drain;
        const suture_curve_point curve_point = current_curve_point(&p, h);
        vbss_hole own = {.struct_size = sizeof own,
                         .id = h->id,
                         .needle = h->needle,
                         .drain = h->drain,
                         .triangle = h->triangle,
                         .outward = h->is_outward,
                         .arc_length = h->arc,
                         .friction = h->friction_force,
                         .thread = h->thread};
        for (int k = 0; k < 3; k++) {
            own.weights[k] = h->barycentric[k];
        }
        vec3_store(own.position, vbss_hole_point(h, d, d->x));
        vec3_store(own.rest_position, vbss_hole_point(h, d, d->mesh.rest));
        vec3_store(own.direction, curve_point.tangent);
        vec3_store(own.force,
                   vec3_add_scaled(h->transverse_force, h->friction_force, curve_point.tangent));
        return vbss_struct_write(s->context, &layout, &own, hole, struct_size);
    }
    return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE, "the scene has no %u holes", index + 1);
}
