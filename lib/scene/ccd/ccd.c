/* CCD: tests whether any two features pass through each other between start and trial state of a
 * substep. The public statistics call it the guard.
 *
 * One-sided continuous tests keep axes at half the contact distance: a miss is a proof. Contacts
 * rest near the whole distance, so CCD finds nothing unless something goes wrong. Pairs that start
 * nearer than half the distance must not come much nearer, so that a bad state can be left. */
#include "scene/ccd/ccd.h"
#include "scene/ccd/pair.h"
#include "scene/tissue/tissue.h"
#include "scene/tools/tools.h"
#include "scene/topology/topology.h"
#include "scene/world/world.h"

/* ---- pairs, in batches */

static double min_radius(const scene_object *s, const scene_body *b, uint32_t shape)
{
    /* The radius of a rigid shape is that of its thickest capsule. */
    double smallest = s->collision->shapes[shape]->radius;
    if (b->kind == SCENE_BODY_DRAIN) {
        return 2.0 * SCENE_LIP_RADIUS_RATIO * smallest;
    }
    for (uint32_t i = 0; b->kind == SCENE_BODY_RIGID && i < b->rigid.capsule_count; i++) {
        smallest = vbss_min(s->capsules[b->rigid.first_capsule + i].radius, smallest);
    }
    return smallest;
}

/* Whether the features of a pair move too little to pass through each other. This needs all pairs
 * to start apart. */
static bool is_slow_pair(const scene_object *s, const collision_candidate *q)
{
    const scene_body *a = &s->bodies[s->body_of_shape[q->shape_a]];
    const scene_body *b = &s->bodies[s->body_of_shape[q->shape_b]];
    return s->step.can_skip_slow_pairs &&
           a->max_displacement + b->max_displacement <=
               SCENE_CCD_SLOW_MOTION_RATIO * scene_ccd_contact_distance(s, q);
}

/* Skips all pairs of the same two shapes if none of them moves enough, or if nothing could keep
 * them apart. Returns the index of the first pair of other shapes. */
static uint32_t skip_slow_pairs(const scene_object *s, uint32_t first)
{
    const collision_object *c = s->collision;
    const collision_candidate *q = &c->candidates[first];
    const scene_body *a = &s->bodies[s->body_of_shape[q->shape_a]];
    const scene_body *b = &s->bodies[s->body_of_shape[q->shape_b]];
    double contact_distance = min_radius(s, a, q->shape_a) + min_radius(s, b, q->shape_b);
    uint32_t next = first;
    double displacement = a->max_displacement + b->max_displacement;
    bool is_slow = s->step.can_skip_slow_pairs &&
                   displacement <= SCENE_CCD_SLOW_MOTION_RATIO * contact_distance;
    bool is_ignored = scene_is_prescribed(a) && scene_is_prescribed(b) &&
                      (displacement == 0.0 || vbss_scene_is_overlap(s, a, b));
    if (is_slow || is_ignored) {
        while (next < c->candidate_count && c->candidates[next].shape_a == q->shape_a &&
               c->candidates[next].shape_b == q->shape_b) {
            next++;
        }
    }
    return next;
}

/* Gathers the next candidates of one kind that need a test, from `*next` on. Returns their number,
 * and their indices. */
static uint32_t gather_batch(scene_object *s, uint32_t *next,
                             uint32_t indices[COLLISION_BLOCK_SIZE])
{
    const collision_object *c = s->collision;
    uint32_t count = 0;
    for (; *next < c->candidate_count && count < COLLISION_BLOCK_SIZE; ++*next) {
        const collision_candidate *q = &c->candidates[*next];
        bool is_other_shape_pair =
            *next == 0 || q->shape_a != q[-1].shape_a || q->shape_b != q[-1].shape_b;
        uint32_t first_of_others = is_other_shape_pair ? skip_slow_pairs(s, *next) : *next;
        if (first_of_others > *next || is_slow_pair(s, q)) {
            *next = first_of_others > *next ? first_of_others - 1 : *next;
            continue;
        }
        if (count > 0 && q->kind != c->candidates[indices[0]].kind) {
            break;
        }
        s->report.statistics.guard_pairs++;
        if (scene_is_known_apart(s, q, 0.0)) {
            continue;
        }
        vbss_scene_set_batch_query(s, &(ccd_query){q, NULL, 0.0}, count);
        indices[count++] = *next;
    }
    return count;
}

static scene_touching_pair bodies_of(const scene_object *s, const collision_candidate *q)
{
    return (scene_touching_pair){s->bodies[s->body_of_shape[q->shape_a]].number,
                                 s->bodies[s->body_of_shape[q->shape_b]].number};
}

/* Notes an impact if it is the first. */
static void record_impact(scene_object *s, double time, scene_touching_pair bodies)
{
    if (time < s->step.time_of_impact) {
        s->step.time_of_impact = time;
        s->step.first_impact = bodies;
    }
}

static void find_first_impact(scene_object *s)
{
    const collision_object *c = s->collision;
    uint32_t indices[COLLISION_BLOCK_SIZE], count, next = 0;
    while ((count = gather_batch(s, &next, indices)) > 0) {
        double time[COLLISION_BLOCK_SIZE];
        bool hit[COLLISION_BLOCK_SIZE];
        vbss_scene_run_ccd_batch(s, c->candidates[indices[0]].kind, count);
        for (uint32_t i = 0; i < count; i++) { /* the tests below overwrite the batch */
            hit[i] = s->scratch.ccd_batch->hit[i] != 0;
            time[i] = s->scratch.ccd_batch->time[i];
        }
        for (uint32_t i = 0; i < count; i++) {
            const collision_candidate *q = &c->candidates[indices[i]];
            if (hit[i]) {
                record_impact(s, vbss_scene_refine_time_of_impact(s, q, time[i]), bodies_of(s, q));
            }
        }
    }
}

/* ---- planes */

static double time_of_plane_impact(scene_plane plane, vec3 start, vec3 end, double radius)
{
    double start_height = scene_height_over(plane, start);
    double end_height = scene_height_over(plane, end);
    double min_height = SCENE_CCD_FLOOR_RATIO * radius;
    if (start_height < min_height) { /* started too low already */
        min_height = start_height - (1.0 - SCENE_CCD_RATIO_WHEN_NEARER) * fabs(start_height);
    }
    return end_height >= min_height ? 1.0
                                    : (start_height - min_height) / (start_height - end_height);
}

/* `number`: of the plane's body; 0: the floor. */
static void find_first_impact_on(scene_object *s, const scene_body *on, uint32_t number)
{
    const scene_plane plane = scene_plane_of(s, on);
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        const thread_object *t = b->thread.thread;
        const scene_rigid *r = &b->rigid;
        double earliest = 1.0;
        if (!vbss_scene_do_collide(s, b, on)) {
            continue;
        }
        for (uint32_t k = 0; scene_active_kind(b) == SCENE_BODY_THREAD && k < t->node_count; k++) {
            double impact_time =
                time_of_plane_impact(plane, t->now.x[k], t->trial[k], t->config.radius);
            earliest = vbss_min(impact_time, earliest);
        }
        for (uint32_t k = 0; scene_active_kind(b) == SCENE_BODY_RIGID && k < 2 * r->capsule_count;
             k++) {
            const scene_capsule *c = &s->capsules[r->first_capsule + k / 2];
            double impact_time =
                time_of_plane_impact(plane, c->now[k % 2], c->trial[k % 2], c->radius);
            earliest = vbss_min(impact_time, earliest);
        }
        const drain_object *d = b->drain.drain;
        for (uint32_t k = 0; scene_active_kind(b) == SCENE_BODY_DRAIN && k < d->mesh.node_count;
             k++) {
            double impact_time =
                time_of_plane_impact(plane, d->x[k], d->trial[k], 0.5 * d->config.thickness);
            earliest = vbss_min(impact_time, earliest);
        }
        record_impact(s, earliest, (scene_touching_pair){b->number, number});
    }
}

static void find_first_impact_on_planes(scene_object *s)
{
    if (s->config.floor != 0) {
        find_first_impact_on(s, NULL, 0);
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (scene_is_plane(&s->bodies[i])) {
            find_first_impact_on(s, &s->bodies[i], s->bodies[i].number);
        }
    }
}

scene_substep_outcome vbss_scene_run_ccd(scene_object *s)
{
    scene_substep_outcome outcome = vbss_scene_list_ccd_pairs(s);
    if (outcome != SCENE_SUBSTEP_ACCEPTED) {
        return outcome;
    }
    vbss_scene_find_trial_slides(s);
    s->step.time_of_impact = 1.0;
    find_first_impact(s);
    find_first_impact_on_planes(s);
    return s->step.time_of_impact < 1.0 ? SCENE_SUBSTEP_CCD_HIT : SCENE_SUBSTEP_ACCEPTED;
}
