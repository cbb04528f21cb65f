/* Whether what a search has led to may be taken. Where it was stopped, its forces are not those of the law, and lengths were put
 * right before shapes: both may put energy into threads and drains that nothing has done the work for. */
#include "scene/attempt.h"
#include "scene/scene.h"

/* Of each in a part, J. A knot alone rubs away what it was given: it may have what a quick hand does in a millisecond, with
 * 2 N at 0.5 m/s, or it waits too often. A wall keeps it: slits were drawn shut, and opened, by what nobody had done. */
#define MOST_OF_THREADS 1e-3
#define MOST_AT_WALLS 2e-5
/* What is above so many times that, further linearisations do not make good: 120 of 683, with 4.4 of them each (docs/contact.md). */
#define BEYOND_HOPE 3.0

static vec3 way_of(const thread_object *t, uint32_t node)
{
    return vec3_sub(t->trial[node], t->now.x[node]);
}

body_kind vbss_scene_find_way(const scene_object *s, uint32_t number, vec3 *way)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        const scene_body *b = &s->bodies[i];
        const drain_object *d = b->drain.drain;
        if (b->kind == BODY_THREAD && number >= b->thread.first_block &&
            number - b->thread.first_block < b->thread.thread->node_count) {
            *way = way_of(b->thread.thread, number - b->thread.first_block);
            return BODY_THREAD;
        }
        if (b->kind == BODY_DRAIN && number >= b->drain.first_block &&
            number - b->drain.first_block < d->mesh.node_count) {
            uint32_t node = d->order.node[number - b->drain.first_block];
            *way = vec3_sub(d->trial[node], d->x[node]);
            return BODY_DRAIN;
        }
    }
    return BODY_GONE;
}

/* Of each in a part, J: what nobody has done the work for, if it is above 0. */
typedef struct gains {
    double threads, drains, beyond_law;
} gains;

/* What a hole gives to both, and stores, above what it had stored. Its law is no measure: where a search was stopped that may
 * itself say 2.7 N along the way that both have gone. */
static double given_by_hole(const scene_object *s, const contact_constraint *row, vec3 force,
                            double done)
{
    const suture_hole *hole = &s->holes[row->key.feature_a];
    double before =
        hole->friction_force * hole->friction_force + vec3_norm_squared(hole->transverse_force);
    double more = 0.5 * (vec3_norm_squared(force) - before) / row->stiffness;
    return vbss_max(done + more, 0.0);
}

/* What a contact does to threads and drains: with the force of which the blocks balance. */
static void take_work_of_row(const scene_object *s, const contact_constraint *row, vec3 force,
                             gains *g)
{
    double on_threads = 0.0, on_drains = 0.0;
    bool known = true; /* what a needle was done is not */
    for (uint32_t k = 0; k < row->jacobian_block_count; k++) {
        const contact_jacobian_block *term = &row->jacobian[k];
        vec3 way;
        body_kind kind = term->is_rotation ? BODY_GONE : vbss_scene_find_way(s, term->block, &way);
        known = known && kind != BODY_GONE;
        if (kind == BODY_THREAD) {
            on_threads += term->weight * vec3_dot(force, way);
        } else if (kind == BODY_DRAIN) {
            on_drains += term->weight * vec3_dot(force, way);
        }
    }
    g->threads -= on_threads;
    g->drains -= on_drains;
    if (row->is_sleeve && known) {
        g->beyond_law += given_by_hole(s, row, force, on_threads + on_drains);
    }
}

/* ---- forces that the law does not know */

static double stored(const contact_constraint *row, double gap)
{
    return gap < 0.0 ? 0.5 * row->stiffness * gap * gap : 0.0;
}

/* More than the law would have put in. */
static double gain(double done, double by_law)
{
    return vbss_max(done - vbss_max(by_law, 0.0), 0.0);
}

/* What a force has put in, up to the trial state, that the law would not have; what others have taken out does not make up for
 * it. What threads gain is known; what drains do is not, so at a wall counts what the law would have taken out, too. */
static double work_beyond_law(const scene_object *s, const contact_constraint *row, vec3 force)
{
    const scene_body *b = vbss_scene_body(s, row->key.body_b);
    bool at_wall = b != NULL && b->kind == BODY_DRAIN;
    vec3 law = vbss_contact_force(row, vec3_zero()), way = row->relative_displacement;
    if (row->is_sleeve) {
        return vbss_max(vec3_dot(vec3_sub(force, law), way), 0.0);
    }
    double along = vec3_dot(row->normal, way), done = along * vec3_dot(force, row->normal);
    double let_go = stored(row, row->start_gap) - stored(row, row->gap);
    vec3 beside = vec3_add_scaled(way, -along, row->normal);
    double rubbed = vec3_dot(force, beside), by_law = vec3_dot(law, beside);
    return at_wall ? vbss_max(done - let_go, 0.0) + vbss_max(rubbed - by_law, 0.0)
                   : gain(done, let_go) + gain(rubbed, by_law);
}

/* ---- what threads gain */

/* At most: what is held is drawn by the tension beside it. */
static double work_at_node(const thread_object *t, uint32_t node)
{
    double pull = 0.0;
    for (uint32_t k = node > 0 ? node - 1 : 0; k <= node && k + 1 < t->node_count; k++) {
        pull = vbss_max(pull, vbss_max(fabs(t->trial_tension[k]), fabs(t->now.tension[k])));
    }
    return pull * vec3_norm(way_of(t, node));
}

static double work_of_holders(const thread_object *t)
{
    double sum = 0.0;
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        const thread_attachment *a = &t->attachments[i];
        sum += a->id != 0 ? work_at_node(t, a->node) : 0.0;
    }
    return sum;
}

static double work_of_welds(const scene_object *s)
{
    double sum = 0.0;
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        const scene_pin *p = &s->pins[i];
        if (p->id != 0 && p->attachment == 0) {
            sum += work_at_node(vbss_scene_body(s, p->thread)->thread.thread, p->node);
        }
    }
    return sum;
}

/* Of a thread only: a wall that is pressed alone comes to rest whatever it was given, and trembles if its parts wait. And
 * what was found is asked about only where walls are and smaller parts cost no deadline: they fold, and what presses in a fold
 * changes its direction at once. */
static bool is_asked(const scene_object *s, const scene_part *part)
{
    bool has_time = s->most_work == 0 && !part->smallest;
    return vbss_scene_has(s, BODY_THREAD) &&
           (s->contacts->is_stopped_early || (has_time && vbss_scene_has(s, BODY_DRAIN)));
}

static gains find_gains(const scene_object *s, const scene_part *part)
{
    const contact_set *set = s->contacts;
    gains g = {.threads = -work_of_welds(s)};
    for (uint32_t i = 0; i < s->place_count; i++) {
        if (s->bodies[i].kind == BODY_THREAD) {
            const thread_object *t = s->bodies[i].thread.thread;
            g.threads += vbss_thread_energy_change(t, part->h) - work_of_holders(t);
        } else if (s->bodies[i].kind == BODY_DRAIN) {
            g.drains += vbss_drain_energy_change(s->bodies[i].drain.drain, part->h);
        }
    }
    for (uint32_t i = 0; i < set->count; i++) {
        const contact_constraint *row = &set->constraints[i];
        take_work_of_row(s, row, set->current[i].force, &g);
        if (!row->is_bilateral ||
            row->is_sleeve) { /* the others' law is linear: they miss nothing */
            g.beyond_law += work_beyond_law(s, row, set->current[i].force);
        }
    }
    return g;
}

static bool are_at_most(const gains *g, double most)
{
    return g->threads <= most && g->drains <= most && g->beyond_law <= most;
}

bool vbss_scene_believes(const scene_object *s, const scene_part *part)
{
    if (!is_asked(s, part)) {
        return true;
    }
    const gains g = find_gains(s, part);
    return are_at_most(&g, vbss_scene_has(s, BODY_DRAIN) ? MOST_AT_WALLS : MOST_OF_THREADS);
}

bool vbss_scene_may_yet_believe(const scene_object *s, const scene_part *part)
{
    bool asks = s->contacts->is_stopped_early && !part->smallest;
    if (!asks || !vbss_scene_has(s, BODY_THREAD) || !vbss_scene_has(s, BODY_DRAIN)) {
        return true;
    }
    const gains g = find_gains(s, part);
    return are_at_most(&g, BEYOND_HOPE * MOST_AT_WALLS);
}
