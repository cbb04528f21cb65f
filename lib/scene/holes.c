/* Holes in a scene: tips that enter walls, rows of what is in a hole, what does not touch there. */
#include "scene/scene.h"

/* A tip touches within so many radii of the wire from its end. */
#define TIP 1.0
/* The tip's line is followed so far for the wall that it presses on, in distances of touching. */
#define REACH 4.0

/* ---- who is in it */

typedef struct pierced {
    const scene_rigid *needle;
    const scene_drain *drain;
} pierced;

static pierced who_is_in(const scene_object *s, const suture_hole *hole)
{
    return (pierced){&vbss_scene_body(s, hole->needle)->rigid,
                     &vbss_scene_body(s, hole->drain)->drain};
}

static hole_lie look_now(const scene_object *s, const suture_hole *hole)
{
    const pierced in = who_is_in(s, hole);
    const drain_object *d = in.drain->drain;
    pose needle = vbss_scene_needle_at(in.needle, in.needle->body.now.at);
    return vbss_hole_look(hole, d, d->x, in.needle->needle, needle);
}

static hole_lie look_at_trial(const scene_object *s, const suture_hole *hole)
{
    const pierced in = who_is_in(s, hole);
    const drain_object *d = in.drain->drain;
    pose needle = vbss_scene_needle_at(in.needle, in.needle->trial);
    return vbss_hole_look(hole, d, d->trial, in.needle->needle, needle);
}

/* ---- rows */

bool vbss_scene_add_hole_rows(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *hole = &s->holes[i];
        for (uint32_t k = 0; hole->id != 0 && k < HOLE_ROWS; k++) {
            const contact_key key = {VBSS_CONTACT_HOLE, hole->needle, HOLE_ROWS * i + k,
                                     hole->drain, 0};
            if (!vbss_scene_add_tie(s, &key)) {
                return false;
            }
        }
    }
    return true;
}

static const suture_hole *hole_of(const scene_object *s, const contact_row *row)
{
    return &s->holes[row->key.a / HOLE_ROWS];
}

void vbss_scene_lay_hole_row(scene_object *s, contact_row *row)
{
    const suture_hole *hole = hole_of(s, row);
    const pierced in = who_is_in(s, hole);
    const drain_object *d = in.drain->drain;
    const hole_lie now = look_at_trial(s, hole), before = look_now(s, hole);
    vbss_hole_lay_row(hole, &d->config, &now, &before, s->part_length, row);
    row->term_count = 0;
    vbss_scene_add_rigid_terms(row, in.needle, now.needle, 1.0);
    for (uint32_t k = 0; k < 3; k++) {
        uint32_t node = d->mesh.triangles[hole->triangle][k];
        row->terms[row->term_count++] = (contact_term){
            .block = in.drain->first_block + d->order.place[node], .weight = -hole->weights[k]};
    }
}

void vbss_scene_mark_hole(const scene_object *s, const contact_row *row)
{
    const suture_hole *hole = hole_of(s, row);
    const scene_drain *b = &vbss_scene_body(s, hole->drain)->drain;
    for (uint32_t k = 0; k < 3; k++) {
        b->marks[b->drain->mesh.triangles[hole->triangle][k]] = 1;
    }
}

void vbss_scene_keep_holes(scene_object *s)
{
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        const contact_row *row = &s->contacts->rows[i];
        if (row->key.kind == VBSS_CONTACT_HOLE) {
            suture_hole *hole = &s->holes[row->key.a / HOLE_ROWS];
            vbss_hole_keep(hole, &who_is_in(s, hole).drain->drain->config, row);
        }
    }
}

void vbss_scene_move_holes(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        if (s->holes[i].id != 0) {
            vbss_hole_move(&s->holes[i], look_now(s, &s->holes[i]).arc);
        }
    }
}

/* ---- what does not touch */

/* Who enters aslant still has, beside its tip, the wall that it has pressed on. */
static double reach_of(const suture_hole *hole, const needle_object *n, double arc, double reach)
{
    bool at_mouth = hole->arc < 0.0 && arc <= TIP * n->config.wire_radius;
    return at_mouth ? greater(reach, -SCENE_PIN_ARC * hole->entry) : reach;
}

/* Two walls that lie on each other are near, but not along the wall. */
bool vbss_scene_is_in_hole(const scene_object *s, const scene_body *needle, double arc,
                           const scene_body *drain, const scene_spot *spot, double reach)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *hole = &s->holes[i];
        const drain_object *d = drain->drain.drain;
        double far = reach_of(hole, needle->rigid.needle, arc, reach);
        if (hole->id != 0 && hole->needle == needle->number && hole->drain == drain->number &&
            fabs(hole->arc - arc) < far &&
            vec3_distance(spot->now, vbss_hole_point(hole, d, d->x)) < far &&
            vec3_distance(spot->rest, vbss_hole_point(hole, d, d->mesh.rest)) < far) {
            return true;
        }
    }
    return false;
}

scene_spot vbss_scene_spot(const scene_body *drain, uint32_t triangle, const double weights[3])
{
    const drain_object *d = drain->drain.drain;
    return (scene_spot){vbss_drain_point(d, d->x, triangle, weights),
                        vbss_drain_point(d, d->mesh.rest, triangle, weights)};
}

scene_spot vbss_scene_spot_on_side(const scene_body *drain, const uint32_t node[2], double share)
{
    const drain_object *d = drain->drain.drain;
    const vec3 *rest = d->mesh.rest;
    return (scene_spot){vec3_lerp(d->x[node[0]], d->x[node[1]], share),
                        vec3_lerp(rest[node[0]], rest[node[1]], share)};
}

double vbss_scene_arc_of(const scene_body *needle, uint32_t segment, double share)
{
    const needle_object *n = needle->rigid.needle;
    double begin = vbss_needle_corner(n, segment);
    return begin + share * (vbss_needle_corner(n, segment + 1) - begin);
}

/* Where on the needle a row is about. */
static double arc_of_row(const scene_body *needle, const contact_row *row)
{
    bool point = row->key.kind == VBSS_CONTACT_POINT_FACE;
    return point ? vbss_scene_arc_of(needle, row->key.a / 2, row->key.a % 2)
                 : vbss_scene_arc_of(needle, row->key.a, row->at[0]);
}

static scene_spot spot_of_row(const scene_object *s, const scene_body *drain,
                              const contact_row *row)
{
    const double weights[3] = {1.0 - row->at[0] - row->at[1], row->at[0], row->at[1]};
    if (row->key.kind == VBSS_CONTACT_POINT_FACE) {
        return vbss_scene_spot(drain, row->key.b, weights);
    }
    const uint32_t *side = s->collision->shapes[drain->shape]->edges[row->key.b];
    return vbss_scene_spot_on_side(drain, side, row->at[1]);
}

bool vbss_scene_is_row_left_out(const scene_object *s, const contact_row *row)
{
    const scene_body *a = vbss_scene_body(s, row->key.body_a);
    const scene_body *b = vbss_scene_body(s, row->key.body_b);
    if (a->kind != BODY_RIGID || b == NULL || b->kind != BODY_DRAIN) {
        return false;
    }
    const scene_spot spot = spot_of_row(s, b, row);
    bool point = row->key.kind == VBSS_CONTACT_POINT_FACE;
    uint32_t capsule = point ? row->key.a / 2 : row->key.a;
    bool in_hole =
        a->rigid.needle != NULL &&
        vbss_scene_is_in_hole(s, a, arc_of_row(a, row), b, &spot, SCENE_PIN_ARC * row->touching);
    return in_hole || vbss_scene_is_pinched(s, b, spot.now, a, capsule);
}

/* ---- after a step */

static void tell(scene_object *s, vbss_event_kind kind, const suture_hole *hole)
{
    vbss_scene_add_event(s, kind, hole->needle, hole->drain, hole->id);
}

void vbss_scene_leave_holes(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        suture_hole *hole = &s->holes[i];
        if (hole->id == 0) {
            continue;
        }
        if (vbss_hole_is_left(hole, who_is_in(s, hole).needle->needle)) {
            tell(s, hole->arc < 0.0 ? VBSS_EVENT_WITHDRAWN : VBSS_EVENT_PASSED, hole);
            *hole = (suture_hole){0};
        }
    }
}

/* What a drain does to the tip of a needle. */
static bool look_at_tip(const scene_object *s, const scene_body *needle, const scene_body *drain,
                        suture_tip *tip)
{
    const scene_rigid *r = &needle->rigid;
    pose at = vbss_scene_needle_at(r, r->body.now.at);
    vec3 normal = vec3_zero();
    *tip = (suture_tip){.position = pose_apply(at, vbss_needle_point(r->needle, 0.0)),
                        .direction =
                            quat_rotate(at.orientation, vbss_needle_direction(r->needle, 0.0))};
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        const contact_row *row = &s->contacts->rows[i];
        if (row->key.body_a == needle->number && row->key.body_b == drain->number &&
            row->key.kind != VBSS_CONTACT_HOLE && row->is.state != CONTACT_OPEN &&
            arc_of_row(needle, row) <= TIP * r->needle->config.wire_radius) {
            normal = vec3_add_scaled(normal, row->is.pressure, row->normal);
            tip->force = vec3_add(tip->force, row->is.rubbing);
        }
    }
    tip->force = vec3_add(tip->force, normal);
    tip->normal = vec3_unit_or(normal, vec3_zero());
    return vec3_norm_squared(normal) > 0.0;
}

static suture_hole *free_hole(scene_object *s)
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
    suture_hole *hole = free_hole(s);
    if (hole == NULL) {
        tell(s, VBSS_EVENT_HOLE_LOST, made);
        return;
    }
    made->id = ++s->last_hole;
    *hole = *made;
    tell(s, VBSS_EVENT_PUNCTURE, hole);
}

/* A tip that is on its way into a wall enters no other place of it: what presses on it there is the wall round the hole. */
static bool is_entering(const scene_object *s, const scene_body *needle, const scene_body *drain)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *hole = &s->holes[i];
        if (hole->id != 0 && hole->needle == needle->number && hole->drain == drain->number &&
            hole->arc < 0.0) {
            return true;
        }
    }
    return false;
}

static void enter(scene_object *s, const scene_body *needle, const scene_body *drain)
{
    suture_tip tip;
    suture_hole made;
    const drain_object *d = drain->drain.drain;
    double wire = needle->rigid.needle->config.wire_radius;
    double reach = REACH * (wire + 0.5 * d->config.thickness);
    if (is_entering(s, needle, drain) || !look_at_tip(s, needle, drain, &tip) ||
        !vbss_suture_enters(&d->config, &tip) ||
        !vbss_suture_make_hole(d, &tip, reach, wire, &made)) {
        return;
    }
    made.needle = needle->number;
    made.drain = drain->number;
    vbss_scene_add_hole(s, &made);
}

void vbss_scene_settle_holes(scene_object *s)
{
    vbss_scene_leave_holes(s);
    /* What presses where a part was thrown away says nothing of what the wall bears. */
    for (uint32_t i = 0; s->taken && i < s->place_count; i++) {
        const scene_body *needle = &s->bodies[i];
        for (uint32_t k = 0;
             needle->kind == BODY_RIGID && needle->rigid.needle != NULL && k < s->place_count;
             k++) {
            if (s->bodies[k].kind == BODY_DRAIN) {
                enter(s, needle, &s->bodies[k]);
            }
        }
    }
}

void vbss_scene_forget_holes_of(scene_object *s, uint32_t number)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        if (s->holes[i].needle == number || s->holes[i].drain == number) {
            s->holes[i] = (suture_hole){0};
        }
    }
}

/* ---- looking */

vbss_result vbss_scene_get_hole(vbss_scene *scene, uint32_t index, vbss_hole *hole,
                                uint32_t struct_size)
{
    static const uint32_t sizes[] = {sizeof(vbss_hole), 0};
    static const vbss_layout layout = {"vbss_hole", NULL, sizes};
    scene_object *s;
    VBSS_TRY(vbss_scene_open(scene, &s));
    uint32_t left = index;
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *h = &s->holes[i];
        if (h->id == 0 || left-- > 0) {
            continue;
        }
        const drain_object *d = who_is_in(s, h).drain->drain;
        const hole_lie lie = look_now(s, h);
        vbss_hole own = {.struct_size = sizeof own,
                         .id = h->id,
                         .needle = h->needle,
                         .drain = h->drain,
                         .triangle = h->triangle,
                         .outward = h->outward,
                         .arc_length = h->arc,
                         .friction = h->held};
        for (int k = 0; k < 3; k++) {
            own.weights[k] = h->weights[k];
        }
        vec3_store(own.position, lie.drain);
        vec3_store(own.rest_position, vbss_hole_point(h, d, d->mesh.rest));
        vec3_store(own.direction, lie.tangent);
        vec3_store(own.force, vec3_add_scaled(h->across, h->held, lie.tangent));
        return vbss_struct_write(s->context, &layout, &own, hole, struct_size);
    }
    return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE, "the scene has no %u holes", index + 1);
}
