/* Bilateral constraints of holes: the suture is held across its curve and slides along it. */
#include "scene/contacts/contacts.h"
#include "scene/tissue/tissue.h"
#include "scene/tuning.h"

bool vbss_scene_add_hole_constraints(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *hole = &s->holes[i];
        if (!vbss_scene_is_hole_active(s, hole) || vbss_scene_is_hole_torn_open(s, hole)) {
            continue;
        }
        const contact_key key = {VBSS_SCENE_CONTACT_HOLE,
                                 hole->needle != 0 ? hole->needle : hole->thread, i, hole->wall, 0};
        contact_constraint *constraint = vbss_scene_add_bilateral_constraint(s, &key);
        if (constraint == NULL) {
            return false;
        }
        constraint->is_sleeve = true;
        /* In a drain one thread of 28 gained energy with the lag (docs/notebook/stitch.md). */
        constraint->may_lag = scene_host_surface_of(vbss_scene_body(s, hole->wall)) != NULL;
    }
    return true;
}

/* Value of a node at a point of the curve; 0 outside its span. */
static double node_value(const suture_curve_point *curve_point,
                         const double values[SUTURE_SPAN_NODES], uint32_t node)
{
    bool own = curve_point->span != SUTURE_ON_NEEDLE && node >= curve_point->first_node &&
               node < curve_point->first_node + SUTURE_SPAN_NODES;
    return own ? values[node - curve_point->first_node] : 0.0;
}

/* The swage's node moves with the needle, so their weights add up. The weight that nodes behind it
 * lose as the hole slides on goes to the needle. */
static void add_needle_jacobian(contact_constraint *constraint, const scene_hole_context *p,
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
        /* The arc length counts from the tip, and the tangent points to the tip. */
        rotation->weighted_arm_derivative = vec3_neg(curve_point->tangent);
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

/* Adds nodes of a span and of the spans beside it, as the hole may slide on to these. The
 * Jacobian's blocks stay the same for the whole substep. */
static void add_thread_jacobian(const scene_object *s, contact_constraint *constraint,
                                const scene_hole_context *p, const suture_curve_point *curve_point,
                                uint32_t span)
{
    const thread_object *t = p->thread->thread.thread;
    uint32_t first = span > 2 ? span - 2 : 0, last = t->node_count - 1;
    last = span + 3 < last ? span + 3 : last;
    /* The swage's node counts with the needle. */
    first = p->needle != NULL && first == 0 ? 1 : first;
    for (uint32_t i = first; i <= last; i++) {
        uint32_t needed = t->welded[i] != 0 ? 2 : 1;
        /* A welded node takes two blocks. The wall needs the last three. */
        if (constraint->jacobian_block_count + needed > CONTACT_MAX_JACOBIAN_BLOCKS - 3) {
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

/* The wall of a host surface without compliance follows the host: its blocks are prescribed. */
static void add_wall_jacobian(contact_constraint *constraint, const scene_hole_context *p,
                              const suture_hole *hole, vec3 point)
{
    const scene_body *b = p->wall_body;
    const scene_host_surface *h = scene_host_surface_of(b);
    const uint32_t *nodes = p->wall.triangles[hole->triangle];
    if (h != NULL && !scene_is_compliant(h)) {
        vbss_scene_add_rigid_jacobian(constraint, &b->rigid, point, -1.0);
        return;
    }
    for (uint32_t k = 0; k < 3; k++) {
        const uint32_t block_index =
            h != NULL ? scene_first_vertex_block(&b->rigid) + h->touched_index[nodes[k]]
                      : b->drain.first_block + b->drain.drain->order.block_index[nodes[k]];
        vbss_scene_add_jacobian_block(constraint, block_index, -hole->barycentric[k]);
    }
}

/* The span from which the hole may slide to either side in this substep. It is chosen once, as the
 * sparsity pattern is fixed. */
static uint32_t choose_span(const scene_hole_context *p, double arc, double step_length)
{
    double reach = SCENE_MAX_SLIDING_SPEED * step_length;
    bool far = p->thread == NULL || (p->needle != NULL && arc < p->now.swage_arc - reach);
    return far ? SUTURE_ON_NEEDLE : vbss_suture_span_at(&p->trial, arc);
}

static void set_tear(contact_constraint *constraint, const scene_hole_context *p,
                     const suture_hole *hole)
{
    if (!vbss_scene_can_tear(p, hole)) {
        return;
    }
    constraint->tear_force = vbss_suture_tear_force(&p->wall, hole->triangle);
    constraint->max_tear_slip =
        SUTURE_MAX_TEAR_RATIO * (p->now.thread->config.radius + 0.5 * p->wall.law->thickness);
    constraint->wall_normal = vbss_suture_wall_normal(&p->wall, p->wall.trial, hole->triangle);
}

void vbss_scene_update_hole_constraint(scene_object *s, contact_constraint *constraint)
{
    const suture_hole *hole = &s->holes[constraint->key.feature_a];
    const scene_hole_context p = vbss_scene_get_hole_context(s, hole);
    scene_contact_geometry *geometry = scene_geometry_of(s, constraint);
    const vec3 point = vbss_hole_point(hole, &p.wall, p.wall.trial);
    if (constraint->jacobian_block_count == 0) {
        const suture_curve_point before = vbss_scene_hole_curve_point(&p, hole);
        geometry->start_arc_length = before.arc;
        geometry->span = choose_span(&p, vbss_suture_nearest_point(&p.trial, p.arc, point).arc,
                                     s->cursor.substep.step_length);
        constraint->solution.status = CONTACT_STICK;
        const hole_yield_limit bound = vbss_hole_yield_limit(hole, p.wall.law, &p.now, &before);
        for (int k = 0; k < 2; k++) {
            constraint->yield_force[k] = bound.force[k];
            constraint->yield_friction[k] = bound.friction[k];
        }
    }
    uint32_t span = geometry->span;
    suture_curve line = p.trial;
    line.thread = span == SUTURE_ON_NEEDLE ? NULL : line.thread;
    const suture_curve_point now =
        span == SUTURE_ON_NEEDLE ? vbss_suture_nearest_point(&line, p.arc, point)
                                 : vbss_suture_nearest_point_around_span(&line, span, p.arc, point);
    geometry->point = point;
    vbss_hole_set_constraint(hole, p.wall.law, geometry->start_arc_length, &now, point,
                             s->step.substep_length, constraint);
    set_tear(constraint, &p, hole);
    constraint->jacobian_block_count = 0;
    if (p.needle != NULL && (span == SUTURE_ON_NEEDLE || span <= 2)) {
        add_needle_jacobian(constraint, &p, &now);
    }
    if (span != SUTURE_ON_NEEDLE) {
        add_thread_jacobian(s, constraint, &p, &now, span);
    }
    add_wall_jacobian(constraint, &p, hole, point);
}
