/* Walls of drains in the jaws of graspers: taken by jaws that would touch them from both sides, held at up to three points
 * along the jaws, let go as they were. Between two steps what was pulled too hard slides. */
#include "scene/events.h"
#include "scene/rows.h"
#include "scene/scene.h"
#include "scene/tools.h"

#include "collision/closest.h"

/* The jaws are looked at in so many places along their length. */
enum { PLACES = 16 };
/* As a share of touching: what was let go is still between the jaws. */
#define STILL_BETWEEN 0.5

/* ---- where walls are between jaws */

typedef struct crossing {
    uint32_t triangle;
    double weights[3], x; /* along the way the jaws open, from their middle */
} crossing;

/* A place of the jaws, so far from the pivot, from one jaw to the other; the walls across it, of which the nearest to the
 * middle is kept. */
typedef struct gap {
    double depth, wide;
    uint32_t layers;
    crossing nearest;
} gap;

/* Where a straight line from one jaw to the other meets a triangle, all in the jaws' frame, y = 0, z = -depth. */
static bool meets(const vec3 corner[3], double depth, crossing *found)
{
    /* Seen along x: weights of the corners by areas. */
    double area[3], sum = 0.0;
    for (int k = 0; k < 3; k++) {
        vec3 p = corner[(k + 1) % 3], q = corner[(k + 2) % 3];
        area[k] = p.y * (q.z + depth) - q.y * (p.z + depth);
        sum += area[k];
    }
    if (sum == 0.0) { /* it is seen as a line */
        return false;
    }
    found->x = 0.0;
    for (int k = 0; k < 3; k++) {
        found->weights[k] = area[k] / sum;
        found->x += found->weights[k] * corner[k].x;
    }
    return found->weights[0] >= 0.0 && found->weights[1] >= 0.0 && found->weights[2] >= 0.0;
}

/* The jaws' middle plane goes through it. */
static bool is_across(const vec3 corner[3])
{
    bool one = corner[0].y > 0.0 || corner[1].y > 0.0 || corner[2].y > 0.0;
    bool other = corner[0].y < 0.0 || corner[1].y < 0.0 || corner[2].y < 0.0;
    return one && other;
}

static void cross_all(const scene_drain *b, pose jaws, gap gaps[PLACES])
{
    const drain_mesh *m = &b->drain->mesh;
    vec3 *x = b->vertices; /* room that a search has left */
    for (uint32_t i = 0; i < m->node_count; i++) {
        x[i] = pose_apply_inverse(jaws, b->drain->x[i]);
    }
    for (uint32_t t = 0; t < m->triangle_count; t++) {
        crossing found = {.triangle = t};
        const vec3 corner[3] = {x[m->triangles[t][0]], x[m->triangles[t][1]],
                                x[m->triangles[t][2]]};
        for (uint32_t i = 0; is_across(corner) && i < PLACES; i++) {
            gap *g = &gaps[i];
            if (meets(corner, g->depth, &found) && fabs(found.x) <= 0.5 * g->wide) {
                bool nearer = g->layers == 0 || fabs(found.x) < fabs(g->nearest.x);
                g->nearest = nearer ? found : g->nearest;
                g->layers++;
            }
        }
    }
}

static bool is_near(const drain_object *d, pose jaws, double length)
{
    const double reach = 1.5 * length;
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        if (vec3_norm_squared(vec3_sub(d->x[i], jaws.position)) < reach * reach) {
            return true;
        }
    }
    return false;
}

static void take_point(scene_pinch *p, uint32_t k, const gap *at)
{
    p->triangle[k] = at->nearest.triangle;
    p->at[k] = vec3_make(at->nearest.x, 0.0, -at->depth);
    for (int i = 0; i < 3; i++) {
        p->weights[k][i] = at->nearest.weights[i];
    }
}

/* The first, the last and the middle of the places that have wall between the jaws. */
static void look_along(const scene_body *tool, const scene_body *b, scene_pinch *found)
{
    const grasper_object *g = tool->rigid.grasper;
    pose jaws = vbss_scene_jaws_of(&tool->rigid, tool->rigid.body.now.pose);
    double length = vbss_grasper_current_jaws(g)->length, wall = b->drain.drain->config.thickness;
    gap gaps[PLACES];
    uint32_t count = 0;
    *found = (scene_pinch){0};
    if (!is_near(b->drain.drain, jaws, length)) {
        return;
    }
    for (uint32_t i = 0; i < PLACES; i++) {
        double depth = length * (i + 1) / PLACES;
        gaps[i] = (gap){.depth = depth, .wide = vbss_grasper_jaw_distance(g->jaw_angle, depth)};
    }
    cross_all(&b->drain, jaws, gaps);
    for (uint32_t i = 0; i < PLACES; i++) {
        double thick = gaps[i].layers * wall;
        /* Nearer to the pivot than it is thick it stands in the corner of the mouth, and stops nothing. */
        if (gaps[i].layers > 0 && gaps[i].depth > thick) {
            found->angle =
                vbss_max(vbss_grasper_touching_angle(thick, gaps[i].depth), found->angle);
            gaps[count++] = gaps[i];
        }
    }
    if (count > 0) {
        found->drain = b->number;
        found->count = count < PINCH_POINTS ? count : PINCH_POINTS;
        for (uint32_t k = 0; k < found->count; k++) {
            take_point(found, k,
                       &gaps[found->count > 1 ? k * (count - 1) / (found->count - 1) : 0]);
        }
    }
}

bool vbss_scene_find_wall(const scene_object *s, const scene_body *tool, scene_pinch *found)
{
    const scene_pinch *before = &tool->rigid.pinch;
    *found = (scene_pinch){0};
    for (uint32_t i = 0; i < s->place_count && found->drain == 0; i++) {
        const scene_body *b = &s->bodies[i];
        bool torn = before->drain == b->number && before->torn; /* not before they have opened */
        if (b->kind == BODY_DRAIN && !torn) {
            look_along(tool, b, found);
        }
    }
    return found->drain != 0;
}

/* ---- taking and letting go */

static void tell(scene_object *s, vbss_event_kind kind, const scene_body *tool)
{
    const scene_pinch *p = &tool->rigid.pinch;
    vbss_scene_add_event(s, kind, p->drain, tool->number, p->triangle[p->count / 2]);
}

bool vbss_scene_pinches(const scene_object *s, uint32_t tool)
{
    const scene_body *b = vbss_scene_body(s, tool);
    return b != NULL && b->kind == BODY_RIGID && b->rigid.pinch.drain != 0 &&
           !b->rigid.pinch.let_go;
}

void vbss_scene_take_wall(scene_object *s, scene_body *tool, const scene_pinch *found)
{
    tool->rigid.pinch = *found;
    tell(s, VBSS_EVENT_GRASP, tool);
}

static vec3 point_of(const scene_pinch *p, const drain_object *d, const vec3 *x, uint32_t k)
{
    return vbss_drain_point(d, x, p->triangle[k], p->weights[k]);
}

static const drain_object *drain_of(const scene_object *s, const scene_pinch *p)
{
    return vbss_scene_body(s, p->drain)->drain.drain;
}

/* Whether the axes of both jaws are that share of touching away from what was held. */
static bool is_clear(const scene_object *s, const scene_body *tool, double share)
{
    const scene_pinch *p = &tool->rigid.pinch;
    const drain_object *d = drain_of(s, p);
    for (uint32_t j = GRASPER_JAW; j < GRASPER_NECK; j++) {
        const scene_capsule *jaw = &s->capsules[tool->rigid.first_capsule + j];
        double least = share * (jaw->radius + 0.5 * d->config.thickness);
        vec3 axis[2];
        vbss_scene_place_capsule(jaw, tool->rigid.body.now.pose, axis);
        for (uint32_t k = 0; k < p->count; k++) {
            vec3 along = vec3_sub(axis[1], axis[0]);
            vec3 to = vec3_sub(point_of(p, d, d->x, k), axis[0]);
            if (vec3_norm(vec3_add_scaled(to, -closest_on_edge(along, to), along)) < least) {
                return false;
            }
        }
    }
    return true;
}

void vbss_scene_let_wall_go(scene_object *s, scene_body *tool)
{
    scene_pinch *p = &tool->rigid.pinch;
    if (p->drain == 0 || !(vbss_grasper_commanded_angle(tool->rigid.grasper) > p->angle)) {
        return;
    }
    p->torn = false;
    if (!p->let_go) {
        tell(s, VBSS_EVENT_RELEASE, tool);
        p->let_go = true;
        p->force = vec3_zero();
        if (is_clear(s, tool, STILL_BETWEEN)) {
            *p = (scene_pinch){0};
        }
    }
}

void vbss_scene_forget_pinches_of(scene_object *s, uint32_t number)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_pinch *p = &s->bodies[i].rigid.pinch;
        if (s->bodies[i].kind == BODY_RIGID &&
            (s->bodies[i].number == number || p->drain == number)) {
            *p = (scene_pinch){0};
        }
    }
}

/* ---- what does not touch */

bool vbss_scene_is_pinched(const scene_object *s, const scene_body *drain, vec3 point,
                           const scene_body *tool, uint32_t capsule)
{
    const scene_pinch *p = &tool->rigid.pinch;
    bool jaw = capsule != GRASPER_SHAFT && capsule != GRASPER_NECK;
    if (tool->rigid.grasper == NULL || !jaw || p->drain != drain->number) {
        return false;
    }
    const drain_object *d = drain->drain.drain;
    double touching =
        s->capsules[tool->rigid.first_capsule + capsule].radius + 0.5 * d->config.thickness;
    double spacing = vbss_grasper_current_jaws(tool->rigid.grasper)->length / PLACES;
    for (uint32_t k = 0; k < p->count; k++) {
        vec3 here = point_of(p, d, d->x, k);
        vec3 next = point_of(p, d, d->x, k + 1 < p->count ? k + 1 : k);
        vec3 along = vec3_sub(next, here), to = vec3_sub(point, here);
        vec3 apart = vec3_add_scaled(to, -closest_on_edge(along, to), along);
        if (vec3_norm(apart) < SCENE_PIN_ARC * touching + spacing) {
            return true;
        }
    }
    return false;
}

/* ---- rows */

bool vbss_scene_add_pinch_rows(scene_object *s)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (!vbss_scene_pinches(s, b->number)) {
            continue;
        }
        for (uint32_t k = 0; k < b->rigid.pinch.count; k++) {
            const contact_key key = {VBSS_CONTACT_GRASP, b->rigid.pinch.drain, k, b->number, 0};
            if (vbss_scene_add_tie(s, &key) == NULL) {
                return false;
            }
        }
    }
    return true;
}

/* Springs share the stiffness of a clamp, the same in all directions. */
static double stiffness_of(const grasper_object *g, const scene_pinch *p)
{
    return g->config.needle_stiffness / p->count;
}

void vbss_scene_lay_pinch_row(scene_object *s, contact_constraint *row)
{
    const scene_drain *b = &vbss_scene_body(s, row->key.body_a)->drain;
    const scene_rigid *tool = &vbss_scene_body(s, row->key.body_b)->rigid;
    const scene_pinch *p = &tool->pinch;
    const drain_object *d = b->drain;
    uint32_t k = row->key.feature_a;
    vec3 there = pose_apply(vbss_scene_jaws_of(tool, tool->trial), p->at[k]);
    vbss_scene_lay_spring(row, tool, point_of(p, d, d->trial, k), there);
    row->stiffness = stiffness_of(tool->grasper, p);
    row->tangential_stiffness_ratio = 0.0; /* the same in all directions */
    for (uint32_t i = 0; i < 3; i++) {
        uint32_t place = d->order.block_index[d->mesh.triangles[p->triangle[k]][i]];
        row->jacobian[row->jacobian_block_count++] =
            (contact_jacobian_block){.block = b->first_block + place, .weight = p->weights[k][i]};
    }
    vbss_scene_add_rigid_terms(row, tool, there, -1.0);
}

void vbss_scene_mark_pinched(const scene_object *s, const contact_constraint *row)
{
    const scene_drain *b = &vbss_scene_body(s, row->key.body_a)->drain;
    const scene_pinch *p = &vbss_scene_body(s, row->key.body_b)->rigid.pinch;
    for (uint32_t i = 0; i < 3; i++) {
        b->marks[b->drain->mesh.triangles[p->triangle[row->key.feature_a]][i]] = 1;
    }
}

/* ---- after a step */

static void settle(scene_object *s, scene_body *tool, double h)
{
    scene_rigid *r = &tool->rigid;
    scene_pinch *p = &r->pinch;
    const drain_object *d = drain_of(s, p);
    pose jaws = vbss_scene_jaws_of(r, r->body.now.pose);
    grasper_needle_load load = {.h = h};
    vec3 middle = vec3_zero();
    for (uint32_t k = 0; k < p->count; k++) {
        vec3 here = pose_apply_inverse(jaws, point_of(p, d, d->x, k));
        load.force =
            vec3_add_scaled(load.force, stiffness_of(r->grasper, p), vec3_sub(p->at[k], here));
        middle = vec3_add_scaled(middle, 1.0 / p->count, p->at[k]);
    }
    load.jaw_force = r->grasper->jaw_force / vbss_scene_count_grasps(s, tool->number);
    p->force = quat_rotate(jaws.orientation, load.force);
    p->limit = vbss_grasper_friction_limit(r->grasper, load.jaw_force);
    pose held = pose_make(middle, quat_identity());
    grasper_needle_slip change = vbss_grasper_yield_needle(r->grasper, &held, &p->age, &load);
    for (uint32_t k = 0; k < p->count; k++) {
        p->at[k] = vec3_add(p->at[k], vec3_sub(held.position, middle));
    }
    if (change.slip > 0.0 && !p->sliding) {
        tell(s, VBSS_EVENT_SLIP, tool);
    }
    p->sliding = change.slip > 0.0;
    p->slid += change.slip;
    if (change.has_escaped) {
        tell(s, VBSS_EVENT_TORN, tool);
        p->let_go = p->torn = true;
        p->force = vec3_zero();
    }
}

void vbss_scene_settle_pinches(scene_object *s, double h)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind != BODY_RIGID || b->rigid.pinch.drain == 0) {
            continue;
        }
        if (!b->rigid.pinch.let_go) {
            settle(s, b, h);
        } else if (is_clear(s, b, 1.0)) {
            b->rigid.pinch = (scene_pinch){0};
        }
    }
}

/* ---- looking */

void vbss_scene_show_pinch(const scene_object *s, const scene_body *tool, vbss_grasp *grasp)
{
    const scene_pinch *p = &tool->rigid.pinch;
    const drain_object *d = drain_of(s, p);
    grasp->thread = p->drain;
    grasp->limit = p->limit;
    grasp->slid = p->slid;
    vec3_store(grasp->position, point_of(p, d, d->x, p->count / 2));
    vec3_store(grasp->force, p->force);
}
