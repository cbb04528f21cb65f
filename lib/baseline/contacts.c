/* One pass over all candidate pairs. The pass tests each pair between the start and the end of
 * the step (algorithm 1), and moves a pair that hits at once (algorithm 2). Each test uses the
 * end positions that earlier responses have left. docs/explanation/paper-scene.md lists the points that the
 * paper leaves open, and the choices here. */
#include "base/error.h"
#include "baseline/drain.h"
#include "baseline/scene.h"
#include "scene/contacts/contacts.h"
#include "scene/step/step.h"
#include "scene/topology/topology.h"

#include "collision/closest.h"
#include "scene/tuning.h"

#include <string.h>

/* ---- features */

/* A segment of a thread, an edge of a drain, or the axis of a capsule, given by its two ends.
 * Against the floor only the first end is set: a node. */
typedef struct feature {
    const vec3 *start[2];
    vec3 *end[2], *speed[2]; /* speed: NULL if no response moves the end */
    double radius;
    double mass[2], mobility[2]; /* mobility: 1/kg, 0 if the node is prescribed */
} feature;

static void set_thread_node(feature *f, int k, const thread_object *t, uint32_t node)
{
    f->radius = t->config.radius;
    f->start[k] = &t->saved.x[node];
    f->end[k] = &t->now.x[node];
    f->speed[k] = &t->now.v[node];
    f->mass[k] = t->mass[node];
    f->mobility[k] = t->prescribed_by[node] != 0 ? 0.0 : 1.0 / t->mass[node];
}

static void set_drain_node(feature *f, int k, const drain_object *d, uint32_t node)
{
    f->radius = 0.5 * d->config.thickness;
    f->start[k] = &d->saved_x[node];
    f->end[k] = &d->x[node];
    f->speed[k] = &d->v[node];
    f->mass[k] = d->mass[node];
    f->mobility[k] = d->baseline->free_mass[node] > 0.0 ? 1.0 / d->mass[node] : 0.0;
}

/* Sets end k of a feature to a node of a thread or a drain. */
static void set_node(feature *f, int k, const scene_body *b, uint32_t node)
{
    if (b->kind == SCENE_BODY_THREAD) {
        set_thread_node(f, k, b->thread.thread, node);
    } else {
        set_drain_node(f, k, b->drain.drain, node);
    }
}

static feature feature_of(const scene_object *s, const scene_body *b, uint32_t i)
{
    const uint32_t *side = s->collision->shapes[b->shape]->edges[i];
    feature f = {.radius = 0.0};
    for (int k = 0; b->kind != SCENE_BODY_RIGID && k < 2; k++) {
        set_node(&f, k, b, side[k]);
    }
    for (int k = 0; b->kind == SCENE_BODY_RIGID && k < 2; k++) {
        scene_capsule *c = &s->capsules[b->rigid.first_capsule + i];
        f.radius = c->radius;
        f.start[k] = &c->now[k];
        f.end[k] = &c->trial[k];
    }
    return f;
}

static bool moves(const feature *f)
{
    return f->mobility[0] > 0.0 || f->mobility[1] > 0.0;
}

/* Returns the shortest vector from b to a at the end of the step; `at` gets the fractions of its
 * feet. */
static vec3 apart_at_end(const feature *a, const feature *b, double at[2])
{
    return vec3_neg(closest_between_edges(vec3_sub(*a->end[1], *a->end[0]),
                                          vec3_sub(*b->end[1], *b->end[0]),
                                          vec3_sub(*b->end[0], *a->end[0]), &at[0], &at[1]));
}

/* ---- pairs of features */

typedef struct pair {
    contact_key key;
    feature a, b;
} pair;

static uint32_t kind_of(const scene_body *a, const scene_body *b)
{
    bool rigid = b->kind == SCENE_BODY_RIGID;
    return b->kind == SCENE_BODY_DRAIN            ? VBSS_SCENE_CONTACT_SIDES
           : rigid && a->kind == SCENE_BODY_RIGID ? VBSS_SCENE_CONTACT_CAPSULES
           : rigid                                ? VBSS_SCENE_CONTACT_SEGMENT_CAPSULE
                                                  : VBSS_SCENE_CONTACT_SEGMENTS;
}

/* Sets up a pair in the order of the body kinds, threads first and drains last, so that the
 * order in which bodies were added does not matter. Returns false if the two features never
 * collide. */
static bool pair_of(const scene_object *s, const collision_candidate *q, pair *p)
{
    const scene_body *a = &s->bodies[s->body_of_shape[q->shape_a]];
    const scene_body *b = &s->bodies[s->body_of_shape[q->shape_b]];
    bool swapped = a->kind > b->kind;
    uint32_t i = swapped ? q->b : q->a, k = swapped ? q->a : q->b;
    if (swapped) {
        const scene_body *first = b;
        b = a;
        a = first;
    }
    uint32_t kind = kind_of(a, b);
    if (kind == VBSS_SCENE_CONTACT_CAPSULES) {
        return false;
    }
    const pair own = {{kind, a->number, i, b->number, k}, feature_of(s, a, i), feature_of(s, b, k)};
    *p = own;
    if (kind == VBSS_SCENE_CONTACT_SEGMENT_CAPSULE) {
        return !vbss_scene_is_excluded_at_pin(s, a, i, b, k, p->a.radius + p->b.radius);
    }
    if (kind == VBSS_SCENE_CONTACT_SIDES) {
        return a->rigid.needle == NULL || !vbss_baseline_is_in_hole(s, a, i, b, k);
    }
    return !vbss_scene_is_excluded_across_cut(s, a, i, b, k);
}

/* ---- contact records, in ascending order of keys */

static uint32_t place_of(const scene_object *s, const contact_key *key)
{
    uint32_t low = 0, high = s->baseline->contact_count;
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        bool below = vbss_contact_compare_keys(&s->baseline->contacts[middle].key, key) < 0;
        low = below ? middle + 1 : low;
        high = below ? high : middle;
    }
    return low;
}

vbss_result vbss_baseline_record_contact(scene_object *s, const contact_key *key, vec3 normal,
                                         vec3 push)
{
    baseline_scene *own = s->baseline;
    uint32_t i = place_of(s, key);
    if (i == own->contact_count || vbss_contact_compare_keys(&own->contacts[i].key, key) != 0) {
        if (own->contact_count == s->config.contact_capacity) {
            return vbss_fail(s->context, VBSS_ERROR_CAPACITY,
                             "there are more contacts than contact_capacity, %u",
                             own->contact_count);
        }
        memmove(&own->contacts[i + 1], &own->contacts[i],
                (own->contact_count - i) * sizeof *own->contacts);
        own->contacts[i] = (scene_contact_record){.key = *key};
        own->contact_count++;
    }
    own->contacts[i].normal = normal;
    own->contacts[i].force = vec3_add(own->contacts[i].force, push);
    return VBSS_OK;
}

/* ---- a pair of segments or axes */

static vbss_collision_impact ask(scene_object *s, const feature *a, const feature *b,
                                 double thickness)
{
    collision_ccd_query question = {.kind = VBSS_COLLISION_PAIR_EDGE_EDGE, .thickness = thickness};
    collision_ccd_result answer = vbss_collision_ccd_miss(VBSS_COLLISION_DECISION_CLAIMED);
    for (int k = 0; k < 2; k++) {
        question.start[k] = *a->start[k];
        question.end[k] = *a->end[k];
        question.start[2 + k] = *b->start[k];
        question.end[2 + k] = *b->end[k];
    }
    vbss_collision_run_ccd(&s->collision->ccd_options, &question, &answer, &s->collision->counters);
    vbss_collision_impact impact = {
        .struct_size = sizeof impact, .hit = answer.hit, .time = answer.time};
    vec3_store(impact.normal, answer.normal);
    memcpy(impact.weights, answer.weights, sizeof impact.weights);
    return impact;
}

static vbss_result respond(const feature *a, const feature *b, double thickness,
                           const vbss_collision_impact *impact, vbss_collision_response *response)
{
    double start[12], end[12];
    const double mobility[4] = {a->mobility[0], a->mobility[1], b->mobility[0], b->mobility[1]};
    for (size_t k = 0; k < 2; k++) {
        vec3_store(start + 3 * k, *a->start[k]);
        vec3_store(end + 3 * k, *a->end[k]);
        vec3_store(start + 6 + 3 * k, *b->start[k]);
        vec3_store(end + 6 + 3 * k, *b->end[k]);
    }
    return vbss_collision_get_vblast_response(VBSS_COLLISION_PAIR_EDGE_EDGE,
                                              VBSS_COLLISION_RESPONSE_END_OF_STEP, impact, start,
                                              end, thickness, mobility, response, sizeof *response);
}

static void limit_side(double displacement[6], double share, double wanted, double depth)
{
    double factor = share != 0.0 ? wanted / share : 0.0,
           max_displacement = BASELINE_MAX_LEVER * wanted * depth;
    double largest = factor * vbss_max(vec3_norm(vec3_load(displacement)),
                                       vec3_norm(vec3_load(displacement + 3)));
    factor *= largest > max_displacement ? max_displacement / largest : 1.0;
    for (int k = 0; k < 6; k++) {
        displacement[k] *= factor;
    }
}

/* Limits the shares to 0 ... 1 and the displacement of each node to a multiple of the shift. The
 * paper allows larger shares, where one side moves away from the other, and long levers. Both
 * make knots explode. */
static void limit_response(vbss_collision_response *r)
{
    double share = clamp_unit(r->share_a);
    limit_side(r->displacement, r->share_a, share, r->depth);
    limit_side(r->displacement + 6, 1.0 - r->share_a, 1.0 - share, r->depth);
}

/* Moves the ends at once, and changes their velocities by the displacement over h. Returns mass
 * times displacement. */
static vec3 displace(const feature *f, const double displacement[6], double h)
{
    vec3 push = vec3_zero();
    for (size_t k = 0; k < 2; k++) {
        vec3 node_displacement = vec3_load(displacement + 3 * k);
        if (f->speed[k] != NULL && f->mobility[k] > 0.0) {
            *f->end[k] = vec3_add(*f->end[k], node_displacement);
            *f->speed[k] = vec3_add_scaled(*f->speed[k], 1.0 / h, node_displacement);
            push = vec3_add_scaled(push, f->mass[k], node_displacement);
        }
    }
    return push;
}

static vbss_result meet(scene_object *s, const contact_key *key, const feature *a, const feature *b,
                        double h)
{
    double thickness = a->radius + b->radius + s->config.baseline->scene_thickness;
    vbss_collision_response response;
    vbss_collision_impact impact = ask(s, a, b, thickness);
    s->baseline->counts.tested_pairs++;
    if (impact.hit == 0) {
        return VBSS_OK;
    }
    if (respond(a, b, thickness, &impact, &response) != VBSS_OK) {
        return VBSS_ERROR_NOT_FINITE; /* a coordinate exceeds the range of the response */
    }
    limit_response(&response);
    vec3 push = displace(a, response.displacement, h);
    vec3 back = vec3_neg(displace(b, response.displacement + 6, h));
    if (vec3_norm_squared(back) > vec3_norm_squared(push)) { /* the paper's shares do not balance */
        push = back;
    }
    if (response.depth < BASELINE_MIN_DEPTH_RATIO * thickness || vec3_norm_squared(push) == 0.0) {
        return VBSS_OK;
    }
    s->baseline->counts.responses++;
    return vbss_baseline_record_contact(s, key, vec3_load(response.direction), push);
}

static vbss_result meet_candidate(scene_object *s, const collision_candidate *q, double h)
{
    pair p;
    bool meets = pair_of(s, q, &p) && (moves(&p.a) || moves(&p.b));
    return meets ? meet(s, &p.key, &p.a, &p.b, h) : VBSS_OK;
}

/* ---- the floor: nodes below it are moved to its surface */

static double height_of(const scene_object *s, vec3 x)
{
    return vec3_dot(x, s->floor_normal) - s->config.floor_height;
}

static vbss_result meet_floor(scene_object *s, const scene_body *b, double h)
{
    bool thread = b->kind == SCENE_BODY_THREAD;
    uint32_t kind = thread ? VBSS_SCENE_CONTACT_NODE_FLOOR : VBSS_SCENE_CONTACT_DRAIN_FLOOR;
    uint32_t count = thread ? b->thread.thread->node_count : b->drain.drain->mesh.node_count;
    for (uint32_t i = 0; i < count; i++) {
        feature f = {.radius = 0.0};
        set_node(&f, 0, b, i);
        double thickness = f.radius + s->config.baseline->scene_thickness;
        double depth = thickness - height_of(s, *f.end[0]);
        if (depth <= BASELINE_MIN_DEPTH_RATIO * thickness || f.mobility[0] == 0.0) {
            continue;
        }
        double displacement[6] = {0.0};
        vec3_store(displacement, vec3_scale(s->floor_normal, depth));
        const contact_key key = {kind, b->number, i, 0, 0};
        s->baseline->counts.responses++;
        VBSS_TRY(
            vbss_baseline_record_contact(s, &key, s->floor_normal, displace(&f, displacement, h)));
    }
    return VBSS_OK;
}

/* ---- a pass */

vbss_result vbss_baseline_find_candidates(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_THREAD) {
            const thread_object *t = b->thread.thread;
            VBSS_TRY(vbss_collision_set_motion(scene_collision(s), b->shape, &t->saved.x->x,
                                               &t->now.x->x, t->node_count));
        } else if (b->kind == SCENE_BODY_DRAIN) {
            const drain_object *d = b->drain.drain;
            VBSS_TRY(vbss_collision_set_motion(scene_collision(s), b->shape, &d->saved_x->x,
                                               &d->x->x, d->mesh.node_count));
        }
    }
    return vbss_collision_find_candidates(scene_collision(s));
}

vbss_result vbss_baseline_run_pass(scene_object *s, double h)
{
    s->baseline->counts.responses = 0;
    for (uint32_t i = 0; i < s->collision->candidate_count; i++) {
        VBSS_TRY(meet_candidate(s, &s->collision->candidates[i], h));
    }
    for (uint32_t i = 0; s->config.floor != 0 && i < s->body_count; i++) {
        if (s->bodies[i].kind == SCENE_BODY_THREAD || s->bodies[i].kind == SCENE_BODY_DRAIN) {
            VBSS_TRY(meet_floor(s, &s->bodies[i], h));
        }
    }
    return vbss_baseline_carry_holes(s, h);
}

/* ---- after the passes */

/* Sets normal, gap and point of a contact. The sign follows the side that the last response
 * chose. */
static void update_contact_geometry(const scene_object *s, scene_contact_record *hit)
{
    const scene_body *a = vbss_scene_body(s, hit->key.body_a);
    const scene_body *b = vbss_scene_body(s, hit->key.body_b);
    if (b == NULL) {
        feature f = {.radius = 0.0};
        set_node(&f, 0, a, hit->key.feature_a);
        hit->gap = height_of(s, *f.end[0]) - f.radius;
        hit->point = vec3_add_scaled(*f.end[0], -f.radius - 0.5 * hit->gap, hit->normal);
        return;
    }
    const feature f = feature_of(s, a, hit->key.feature_a),
                  g = feature_of(s, b, hit->key.feature_b);
    double at[2];
    vec3 apart = apart_at_end(&f, &g, at), here = vec3_lerp(*f.end[0], *f.end[1], at[0]);
    double distance = vec3_norm(apart), side = vec3_dot(apart, hit->normal) < 0.0 ? -1.0 : 1.0;
    if (distance > SCENE_MIN_DISTANCE_RATIO * (f.radius + g.radius)) {
        hit->normal = vec3_scale(apart, side / distance);
    }
    hit->gap = side * distance - f.radius - g.radius;
    hit->point = vec3_add_scaled(here, -f.radius - 0.5 * hit->gap, hit->normal);
}

/* Returns the overlap of a pair of the last broad phase, m; negative if the surfaces are apart. */
static double depth_of(const scene_object *s, const collision_candidate *q)
{
    double at[2];
    pair p;
    return pair_of(s, q, &p) ? p.a.radius + p.b.radius - vec3_norm(apart_at_end(&p.a, &p.b, at))
                             : 0.0;
}

double vbss_baseline_measure_contacts(scene_object *s, double h)
{
    double depth = 0.0;
    for (uint32_t i = 0; i < s->baseline->contact_count; i++) {
        scene_contact_record *hit = &s->baseline->contacts[i];
        hit->force = vec3_scale(hit->force, 1.0 / (h * h));
        if (hit->key.kind == VBSS_SCENE_CONTACT_HOLE) {
            vbss_baseline_locate_hole_contact(s, hit);
        } else {
            update_contact_geometry(s, hit);
        }
        depth = vbss_max(-hit->gap, depth);
    }
    for (uint32_t i = 0; i < s->collision->candidate_count; i++) {
        depth = vbss_max(depth, depth_of(s, &s->collision->candidates[i]));
    }
    return depth;
}

void vbss_baseline_publish_contacts(scene_object *s)
{
    for (uint32_t i = 0; i < s->baseline->contact_count; i++) {
        const scene_contact_record *contact = &s->baseline->contacts[i];
        vbss_scene_publish_contact(s, contact);
        vbss_scene_add_force(vbss_scene_body(s, contact->key.body_a), contact->point,
                             contact->force);
        vbss_scene_add_force(vbss_scene_body(s, contact->key.body_b), contact->point,
                             vec3_neg(contact->force));
    }
}

void vbss_baseline_list_touching_pairs(scene_object *s)
{
    for (uint32_t i = 0; i < s->baseline->contact_count; i++) {
        const contact_key *key = &s->baseline->contacts[i].key;
        vbss_scene_insert_touching_pair(s, (scene_touching_pair){key->body_a, key->body_b});
    }
}
