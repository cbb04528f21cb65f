/* Walls of drains in the jaws of graspers: found, grasped, released and sliding.
 *
 * Jaws grasp a wall that they would touch from both sides, at up to three points along their
 * length. Bilateral constraints hold these points (contacts/grasp_constraints.c). After a step
 * the wall slides in the jaws if the load exceeds their friction limit. */
#include "collision/closest.h"
#include "scene/tools/tools.h"
#include "scene/tuning.h"
#include "scene/world/world.h"

/* Number of sections along the jaws in which a wall is searched. */
enum { JAW_SECTIONS = 16 };

/* ---- walls between the jaws */

typedef struct crossing {
    uint32_t triangle;
    double weights[3], x; /* barycentric coordinates; x: in the jaws' frame, m */
} crossing;

/* A line across the jaws, from one to the other: its depth below the pivot, the distance of the
 * jaws there, the number of walls between them, and the crossing nearest to the middle. */
typedef struct jaw_section {
    double depth, width;
    uint32_t layers;
    crossing nearest;
} jaw_section;

/* Finds the point at which a line across the jaws meets a triangle. The corners are in the jaws'
 * frame; the line is at y = 0 and z = -depth. */
static bool crosses_triangle(const vec3 corner[3], double depth, crossing *found)
{
    /* In the projection along x, areas give the barycentric coordinates. */
    double area[3], sum = 0.0;
    for (int k = 0; k < 3; k++) {
        vec3 p = corner[(k + 1) % 3], q = corner[(k + 2) % 3];
        area[k] = p.y * (q.z + depth) - q.y * (p.z + depth);
        sum += area[k];
    }
    if (sum == 0.0) { /* the projection is a line */
        return false;
    }
    found->x = 0.0;
    for (int k = 0; k < 3; k++) {
        found->weights[k] = area[k] / sum;
        found->x += found->weights[k] * corner[k].x;
    }
    return found->weights[0] >= 0.0 && found->weights[1] >= 0.0 && found->weights[2] >= 0.0;
}

/* Whether a triangle crosses the middle plane of the jaws, y = 0. */
static bool crosses_middle_plane(const vec3 corner[3])
{
    bool one = corner[0].y > 0.0 || corner[1].y > 0.0 || corner[2].y > 0.0;
    bool other = corner[0].y < 0.0 || corner[1].y < 0.0 || corner[2].y < 0.0;
    return one && other;
}

static void find_crossings(const scene_drain *b, pose jaws, jaw_section sections[JAW_SECTIONS])
{
    const drain_mesh *m = &b->drain->mesh;
    vec3 *x = b->vertices; /* scratch */
    for (uint32_t i = 0; i < m->node_count; i++) {
        x[i] = pose_apply_inverse(jaws, b->drain->x[i]);
    }
    for (uint32_t t = 0; t < m->triangle_count; t++) {
        crossing found = {.triangle = t};
        const vec3 corner[3] = {x[m->triangles[t][0]], x[m->triangles[t][1]],
                                x[m->triangles[t][2]]};
        for (uint32_t i = 0; crosses_middle_plane(corner) && i < JAW_SECTIONS; i++) {
            jaw_section *g = &sections[i];
            if (crosses_triangle(corner, g->depth, &found) && fabs(found.x) <= 0.5 * g->width) {
                bool nearer = g->layers == 0 || fabs(found.x) < fabs(g->nearest.x);
                g->nearest = nearer ? found : g->nearest;
                g->layers++;
            }
        }
    }
}

static bool is_near(const drain_object *d, pose jaws, double length)
{
    const double reach = SCENE_WALL_SEARCH_RATIO * length;
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        if (vec3_norm_squared(vec3_sub(d->x[i], jaws.position)) < reach * reach) {
            return true;
        }
    }
    return false;
}

static void set_grasp_point(scene_wall_grasp *p, uint32_t k, const jaw_section *at)
{
    p->triangle[k] = at->nearest.triangle;
    p->points_in_jaws[k] = vec3_make(at->nearest.x, 0.0, -at->depth);
    for (int i = 0; i < 3; i++) {
        p->weights[k][i] = at->nearest.weights[i];
    }
}

/* Finds a grasp at the first, the middle and the last section that has a wall between the jaws. */
static void find_wall_grasp(const scene_body *tool, const scene_body *b, scene_wall_grasp *found)
{
    const grasper_object *g = tool->rigid.grasper;
    pose jaws = vbss_scene_jaw_frame(&tool->rigid, tool->rigid.body.now.pose);
    double length = vbss_grasper_current_jaws(g)->length, wall = b->drain.drain->config.thickness;
    jaw_section sections[JAW_SECTIONS];
    uint32_t count = 0;
    *found = (scene_wall_grasp){0};
    if (!is_near(b->drain.drain, jaws, length)) {
        return;
    }
    for (uint32_t i = 0; i < JAW_SECTIONS; i++) {
        double depth = length * (i + 1) / JAW_SECTIONS;
        sections[i] =
            (jaw_section){.depth = depth, .width = vbss_grasper_jaw_distance(g->jaw_angle, depth)};
    }
    find_crossings(&b->drain, jaws, sections);
    for (uint32_t i = 0; i < JAW_SECTIONS; i++) {
        double thick = sections[i].layers * wall;
        /* A wall nearer to the pivot than its thickness lies in the corner of the jaws and does
         * not stop them. */
        if (sections[i].layers > 0 && sections[i].depth > thick) {
            found->angle =
                vbss_max(vbss_grasper_touching_angle(thick, sections[i].depth), found->angle);
            sections[count++] = sections[i];
        }
    }
    if (count > 0) {
        found->drain = b->number;
        found->point_count = count < SCENE_WALL_GRASP_POINTS ? count : SCENE_WALL_GRASP_POINTS;
        for (uint32_t k = 0; k < found->point_count; k++) {
            set_grasp_point(
                found, k,
                &sections[found->point_count > 1 ? k * (count - 1) / (found->point_count - 1) : 0]);
        }
    }
}

bool vbss_scene_find_wall_in_jaws(const scene_object *s, const scene_body *tool,
                                  scene_wall_grasp *found)
{
    const scene_wall_grasp *before = &tool->rigid.wall_grasp;
    *found = (scene_wall_grasp){0};
    for (uint32_t i = 0; i < s->body_count && found->drain == 0; i++) {
        const scene_body *b = &s->bodies[i];
        /* not before the jaws have opened */
        bool torn = before->drain == b->number && before->needs_reopening;
        if (b->kind == SCENE_BODY_DRAIN && !torn && vbss_scene_do_collide(s, tool, b)) {
            find_wall_grasp(tool, b, found);
        }
    }
    return found->drain != 0;
}

/* ---- grasping and releasing */

static void emit_wall_grasp_event(scene_object *s, vbss_scene_event_kind kind,
                                  const scene_body *tool)
{
    const scene_wall_grasp *p = &tool->rigid.wall_grasp;
    scene_grasp_event of = {.tool = tool->number, .triangle = p->triangle[p->point_count / 2]};
    vbss_scene_describe_wall_grasp(s, tool, &of.grasp);
    of.logged_number = of.triangle;
    vbss_scene_emit_grasp_event(s, kind, &of);
}

void vbss_scene_grasp_wall(scene_object *s, scene_body *tool, const scene_wall_grasp *found)
{
    tool->rigid.wall_grasp = *found;
    emit_wall_grasp_event(s, VBSS_SCENE_EVENT_GRASP, tool);
}

vec3 vbss_scene_wall_grasp_point(const scene_wall_grasp *p, const drain_object *d, const vec3 *x,
                                 uint32_t k)
{
    return vbss_drain_point(d, x, p->triangle[k], p->weights[k]);
}

static const drain_object *held_drain(const scene_object *s, const scene_wall_grasp *p)
{
    return vbss_scene_body(s, p->drain)->drain.drain;
}

/* Whether an axis is at least this far from all edges and triangles of a drain. */
static bool is_axis_clear(const vec3 axis[2], const drain_object *d, double distance)
{
    const drain_mesh *m = &d->mesh;
    const vec3 along = vec3_sub(axis[1], axis[0]);
    double weights[3], at[2];
    for (uint32_t i = 0; i < m->edge_count; i++) {
        vec3 start = d->x[m->edges[i].nodes[0]], end = d->x[m->edges[i].nodes[1]];
        vec3 separation = closest_between_edges(along, vec3_sub(end, start),
                                                vec3_sub(start, axis[0]), &at[0], &at[1]);
        if (vec3_norm(separation) < distance) {
            return false;
        }
    }
    for (uint32_t i = 0; i < 2 * m->triangle_count; i++) {
        vec3 corners[3];
        for (int k = 0; k < 3; k++) {
            corners[k] = vec3_sub(d->x[m->triangles[i / 2][k]], axis[i % 2]);
        }
        if (vec3_norm(closest_on_triangle(corners, weights)) < distance) {
            return false;
        }
    }
    return true;
}

/* Whether both jaws are clear of the wall that they have released: of all of it, as jaws and wall
 * that still overlap anywhere would be thrown apart. */
static bool is_wall_clear(const scene_object *s, const scene_body *tool)
{
    const drain_object *d = held_drain(s, &tool->rigid.wall_grasp);
    for (uint32_t j = GRASPER_JAW; j < GRASPER_NECK; j++) {
        const scene_capsule *jaw = &s->capsules[tool->rigid.first_capsule + j];
        vec3 axis[2];
        vbss_scene_transform_capsule(jaw, tool->rigid.body.now.pose, axis);
        double contact_distance = jaw->radius + 0.5 * d->config.thickness;
        if (!is_axis_clear(axis, d, SCENE_WALL_CLEARANCE_RATIO * contact_distance)) {
            return false;
        }
    }
    return true;
}

void vbss_scene_release_wall_grasp(scene_object *s, scene_body *tool)
{
    scene_wall_grasp *p = &tool->rigid.wall_grasp;
    if (p->drain == 0 || !(vbss_grasper_commanded_angle(tool->rigid.grasper) > p->angle)) {
        return;
    }
    p->needs_reopening = false;
    if (!p->is_released) {
        emit_wall_grasp_event(s, VBSS_SCENE_EVENT_RELEASE, tool);
        p->is_released = true;
        p->force = vec3_zero();
        if (is_wall_clear(s, tool)) {
            *p = (scene_wall_grasp){0};
        }
    }
}

void vbss_scene_remove_wall_grasps_of(scene_object *s, uint32_t number)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_wall_grasp *p = &s->bodies[i].rigid.wall_grasp;
        if (s->bodies[i].kind == SCENE_BODY_RIGID &&
            (s->bodies[i].number == number || p->drain == number)) {
            *p = (scene_wall_grasp){0};
        }
    }
}

/* ---- exclusion from contact */

bool vbss_scene_is_wall_in_grasp(const scene_object *s, const scene_body *drain, vec3 point,
                                 const scene_body *tool, uint32_t capsule)
{
    const scene_wall_grasp *p = &tool->rigid.wall_grasp;
    bool jaw = capsule != GRASPER_SHAFT && capsule != GRASPER_NECK;
    if (tool->rigid.grasper == NULL || !jaw || p->drain != drain->number) {
        return false;
    }
    const drain_object *d = drain->drain.drain;
    double contact_distance =
        s->capsules[tool->rigid.first_capsule + capsule].radius + 0.5 * d->config.thickness;
    double spacing = vbss_grasper_current_jaws(tool->rigid.grasper)->length / JAW_SECTIONS;
    for (uint32_t k = 0; k < p->point_count; k++) {
        vec3 current = vbss_scene_wall_grasp_point(p, d, d->x, k);
        vec3 next = vbss_scene_wall_grasp_point(p, d, d->x, k + 1 < p->point_count ? k + 1 : k);
        vec3 along = vec3_sub(next, current), to = vec3_sub(point, current);
        vec3 separation_vector = vec3_add_scaled(to, -closest_on_edge(along, to), along);
        if (vec3_norm(separation_vector) < SCENE_EXCLUSION_ARC_RATIO * contact_distance + spacing) {
            return true;
        }
    }
    return false;
}

/* ---- the clamp */

double vbss_scene_wall_grasp_stiffness(const grasper_object *g, const scene_wall_grasp *p)
{
    return g->config.needle_stiffness / p->point_count;
}

/* ---- after a step */

static void update_wall_grasp(scene_object *s, scene_body *tool, double h)
{
    scene_rigid *r = &tool->rigid;
    scene_wall_grasp *p = &r->wall_grasp;
    const drain_object *d = held_drain(s, p);
    pose jaws = vbss_scene_jaw_frame(r, r->body.now.pose);
    grasper_needle_load load = {.h = h};
    vec3 middle = vec3_zero();
    for (uint32_t k = 0; k < p->point_count; k++) {
        vec3 current = pose_apply_inverse(jaws, vbss_scene_wall_grasp_point(p, d, d->x, k));
        load.force = vec3_add_scaled(load.force, vbss_scene_wall_grasp_stiffness(r->grasper, p),
                                     vec3_sub(p->points_in_jaws[k], current));
        middle = vec3_add_scaled(middle, 1.0 / p->point_count, p->points_in_jaws[k]);
    }
    load.jaw_force = r->grasper->jaw_force / vbss_scene_count_grasps(s, tool->number);
    p->force = quat_rotate(jaws.orientation, load.force);
    p->limit = vbss_grasper_friction_limit(r->grasper, load.jaw_force);
    pose held = pose_make(middle, quat_identity());
    grasper_needle_slip change = vbss_grasper_yield_needle(r->grasper, &held, &p->age, &load);
    for (uint32_t k = 0; k < p->point_count; k++) {
        p->points_in_jaws[k] = vec3_add(p->points_in_jaws[k], vec3_sub(held.position, middle));
    }
    if (change.slip > 0.0 && !p->is_sliding) {
        emit_wall_grasp_event(s, VBSS_SCENE_EVENT_SLIP, tool);
    }
    p->is_sliding = change.slip > 0.0;
    p->slid += change.slip;
    if (change.has_escaped) {
        emit_wall_grasp_event(s, VBSS_SCENE_EVENT_TORN, tool);
        p->is_released = p->needs_reopening = true;
        p->force = vec3_zero();
    }
}

void vbss_scene_update_wall_grasps(scene_object *s, double h)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind != SCENE_BODY_RIGID || b->rigid.wall_grasp.drain == 0) {
            continue;
        }
        if (!b->rigid.wall_grasp.is_released) {
            update_wall_grasp(s, b, h);
        } else if (is_wall_clear(s, b)) {
            b->rigid.wall_grasp = (scene_wall_grasp){0};
        }
    }
}

/* ---- description for hosts */

void vbss_scene_describe_wall_grasp(const scene_object *s, const scene_body *tool,
                                    vbss_scene_grasp *grasp)
{
    const scene_wall_grasp *p = &tool->rigid.wall_grasp;
    const drain_object *d = held_drain(s, p);
    grasp->body = p->drain;
    grasp->limit = p->limit;
    grasp->slid = p->slid;
    vec3_store(grasp->position, vbss_scene_wall_grasp_point(p, d, d->x, p->point_count / 2));
    vec3_store(grasp->force, p->force);
}
