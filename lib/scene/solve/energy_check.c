/* Energy check: decides whether a substep adds energy that no work accounts for.
 *
 * A search that was stopped early leaves forces that do not obey the contact law, and Newton
 * iterations correct lengths before shapes. Both may put energy into threads and drains. Such a
 * substep is rejected. */
#include "scene/solve/solve.h"
#include "scene/tuning.h"
#include "scene/world/world.h"

static vec3 node_displacement(const thread_object *t, uint32_t node)
{
    return vec3_sub(t->trial[node], t->now.x[node]);
}

scene_body_kind vbss_scene_find_block_displacement(const scene_object *s, uint32_t block_index,
                                                   vec3 *displacement)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        const drain_object *d = b->drain.drain;
        if (b->kind == SCENE_BODY_THREAD && block_index >= b->thread.first_block &&
            block_index - b->thread.first_block < b->thread.thread->node_count) {
            *displacement =
                node_displacement(b->thread.thread, block_index - b->thread.first_block);
            return SCENE_BODY_THREAD;
        }
        if (b->kind == SCENE_BODY_DRAIN && block_index >= b->drain.first_block &&
            block_index - b->drain.first_block < d->mesh.node_count) {
            uint32_t node = d->order.node[block_index - b->drain.first_block];
            *displacement = vec3_sub(d->trial[node], d->x[node]);
            return SCENE_BODY_DRAIN;
        }
    }
    return SCENE_BODY_NONE;
}

/* Energy gained in a substep without work that accounts for it, J; `beyond_law` is the work of
 * contact forces beyond the contact law. */
typedef struct energy_gains {
    double threads, drains, beyond_law;
} energy_gains;

/* Energy that a hole gives to suture and drain, plus the increase of the energy that it stores, J.
 * The law of the hole cannot be the measure: after a search that was stopped, it may give 2.7 N
 * along their displacement. */
static double energy_from_hole(const scene_object *s, const contact_constraint *constraint,
                               vec3 force, double work)
{
    const suture_hole *hole = &s->holes[constraint->key.feature_a];
    double stored_before =
        hole->friction_force * hole->friction_force + vec3_norm_squared(hole->transverse_force);
    double stored_increase =
        0.5 * (vec3_norm_squared(force) - stored_before) / constraint->stiffness;
    return vbss_max(work + stored_increase, 0.0);
}

/* Subtracts the work of a contact on threads and drains, with the force for which the system
 * is balanced. */
static void subtract_work_of_constraint(const scene_object *s, const contact_constraint *constraint,
                                        vec3 force, energy_gains *g)
{
    double on_threads = 0.0, on_drains = 0.0;
    bool is_known = true; /* false if the work on a needle is missing */
    for (uint32_t k = 0; k < constraint->jacobian_block_count; k++) {
        const contact_jacobian_block *jacobian_block = &constraint->jacobian[k];
        vec3 displacement;
        scene_body_kind kind =
            jacobian_block->is_rotation
                ? SCENE_BODY_NONE
                : vbss_scene_find_block_displacement(s, jacobian_block->block, &displacement);
        is_known = is_known && kind != SCENE_BODY_NONE;
        if (kind == SCENE_BODY_THREAD) {
            on_threads += jacobian_block->weight * vec3_dot(force, displacement);
        } else if (kind == SCENE_BODY_DRAIN) {
            on_drains += jacobian_block->weight * vec3_dot(force, displacement);
        }
    }
    g->threads -= on_threads;
    g->drains -= on_drains;
    if (constraint->is_sleeve && is_known) {
        g->beyond_law += energy_from_hole(s, constraint, force, on_threads + on_drains);
    }
}

/* ---- work of forces that differ from the contact law */

/* Elastic energy of a contact at a gap, J. */
static double stored_energy(const contact_constraint *constraint, double gap)
{
    return gap < 0.0 ? 0.5 * constraint->stiffness * gap * gap : 0.0;
}

/* Work beyond that of the law, J. A law that takes out energy counts as 0. */
static double excess_work(double work, double law_work)
{
    return vbss_max(work - vbss_max(law_work, 0.0), 0.0);
}

/* Work of a constraint's force up to the trial state that its law would not do, J. Normal and
 * tangential parts are counted apart, so that one cannot make up for the other. The energy change
 * of threads is known exactly, that of drains is not. So at a wall the energy that the law would
 * take out counts, too. */
static double work_beyond_law(const scene_object *s, const contact_constraint *constraint,
                              vec3 force)
{
    const scene_body *b = vbss_scene_body(s, constraint->key.body_b);
    bool at_wall = b != NULL && b->kind == SCENE_BODY_DRAIN;
    vec3 law_force = vbss_contact_force(constraint, vec3_zero()),
         displacement = constraint->relative_displacement;
    if (constraint->is_sleeve) {
        return vbss_max(vec3_dot(vec3_sub(force, law_force), displacement), 0.0);
    }
    double normal_displacement = vec3_dot(constraint->normal, displacement),
           normal_work = normal_displacement * vec3_dot(force, constraint->normal);
    double released_energy =
        stored_energy(constraint, scene_geometry_of(s, constraint)->start_gap) -
        stored_energy(constraint, constraint->gap);
    vec3 tangential_displacement =
        vec3_add_scaled(displacement, -normal_displacement, constraint->normal);
    double friction_work = vec3_dot(force, tangential_displacement),
           law_friction_work = vec3_dot(law_force, tangential_displacement);
    return at_wall ? vbss_max(normal_work - released_energy, 0.0) +
                         vbss_max(friction_work - law_friction_work, 0.0)
                   : excess_work(normal_work, released_energy) +
                         excess_work(friction_work, law_friction_work);
}

/* ---- energy change of threads */

/* Upper bound of the work on a held node, J: the largest tension beside it pulls along
 * its displacement. */
static double max_work_at_node(const thread_object *t, uint32_t node)
{
    double tension = 0.0;
    for (uint32_t k = node > 0 ? node - 1 : 0; k <= node && k + 1 < t->node_count; k++) {
        tension = vbss_max(tension, vbss_max(fabs(t->trial_tension[k]), fabs(t->now.tension[k])));
    }
    return tension * vec3_norm(node_displacement(t, node));
}

static double max_work_of_attachments(const thread_object *t)
{
    double sum = 0.0;
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        const thread_attachment *a = &t->attachments[i];
        sum += a->id != 0 ? max_work_at_node(t, a->node) : 0.0;
    }
    return sum;
}

static double max_work_of_welds(const scene_object *s)
{
    double sum = 0.0;
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        const scene_pin *p = &s->pins[i];
        if (p->id != 0 && p->attachment == 0) {
            sum += max_work_at_node(vbss_scene_body(s, p->thread)->thread.thread, p->node);
        }
    }
    return sum;
}

/* Whether a substep is checked. A wall without threads settles whatever energy it gains, and
 * trembles if its substeps are rejected. A converged active set is checked only with drains and
 * while there is time for smaller substeps: the contact force in a fold may change its direction
 * at once. */
static bool needs_energy_check(const scene_object *s, const scene_substep *substep)
{
    bool has_time = s->step.budget == 0 && !substep->is_min_size;
    return vbss_scene_has_body_kind(s, SCENE_BODY_THREAD) &&
           (s->contacts->is_stopped_early ||
            (has_time && vbss_scene_has_body_kind(s, SCENE_BODY_DRAIN)));
}

static energy_gains compute_energy_gains(const scene_object *s, const scene_substep *substep)
{
    const contact_set *set = s->contacts;
    energy_gains g = {.threads = -max_work_of_welds(s)};
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_THREAD) {
            const thread_object *t = s->bodies[i].thread.thread;
            g.threads += vbss_thread_energy_change(t, substep->h) - max_work_of_attachments(t);
        } else if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_DRAIN) {
            g.drains += vbss_drain_energy_change(s->bodies[i].drain.drain, substep->h);
        }
    }
    for (uint32_t i = 0; i < set->count; i++) {
        const contact_constraint *constraint = &set->constraints[i];
        subtract_work_of_constraint(s, constraint, set->current[i].force, &g);
        /* Other bilateral constraints are linear and miss nothing. */
        if (!constraint->is_bilateral || constraint->is_sleeve) {
            g.beyond_law += work_beyond_law(s, constraint, set->current[i].force);
        }
    }
    return g;
}

static bool are_within_tolerance(const energy_gains *g, double tolerance)
{
    return g->threads <= tolerance && g->drains <= tolerance && g->beyond_law <= tolerance;
}

bool vbss_scene_passes_energy_check(const scene_object *s, const scene_substep *substep)
{
    if (!needs_energy_check(s, substep)) {
        return true;
    }
    const energy_gains g = compute_energy_gains(s, substep);
    double power = vbss_scene_has_body_kind(s, SCENE_BODY_DRAIN) ? SCENE_POWER_WITH_WALLS
                                                                 : SCENE_POWER_WITHOUT_WALLS;
    return are_within_tolerance(&g, power * substep->step_length);
}

bool vbss_scene_may_pass_energy_check(const scene_object *s, const scene_substep *substep)
{
    bool is_stopped_early = s->contacts->is_stopped_early && !substep->is_min_size;
    if (!is_stopped_early || !vbss_scene_has_body_kind(s, SCENE_BODY_THREAD) ||
        !vbss_scene_has_body_kind(s, SCENE_BODY_DRAIN)) {
        return true;
    }
    const energy_gains g = compute_energy_gains(s, substep);
    return are_within_tolerance(&g, SCENE_HOPELESS_ENERGY_RATIO *
                                        (SCENE_POWER_WITH_WALLS * substep->step_length));
}
