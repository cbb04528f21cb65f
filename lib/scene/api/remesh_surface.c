/* Gives a host surface another mesh. Body, parameters and holes stay; the host says where on the new mesh each
 * hole is. All that may fail comes before the first change. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "collision/closest.h"
#include "scene/api/api.h"
#include "scene/api/overlap.h"
#include "scene/api/place.h"
#include "scene/solve/solve.h"
#include "scene/tissue/tissue.h"
#include "scene/world/world.h"

#include <string.h>

_Static_assert(sizeof(vbss_scene_hole_place) == 88, "published size");

/* Input of the host. */
typedef struct remesh_input {
    vbss_scene_surface_config config; /* parameters of the body, and the new mesh */
    vbss_scene_place_hole_fn place;
    void *user;
} remesh_input;

/* A mesh that is about to replace that of a body. */
typedef struct new_mesh {
    collision_shape *shape;
    scene_static_mesh mesh;
    scene_rigid motion;  /* only `surface` */
    suture_hole *places; /* per entry of the list of holes: where the hole goes */
} new_mesh;

static vbss_scene_surface_config config_of(const scene_body *b)
{
    const scene_host_surface *h = b->rigid.surface;
    vbss_scene_surface_config c = vbss_scene_surface_config_default();
    c.one_sided = b->rigid.mesh.is_one_sided;
    c.friction = b->rigid.friction;
    c.thickness = h->law.thickness;
    c.jump_limit = h->jump_limit;
    c.compliance_size = h->compliance_size;
    return c;
}

/* ---- the new mesh */

static vbss_result create_mesh(scene_object *s, const vbss_scene_surface_config *c, new_mesh *m)
{
    VBSS_TRY(vbss_collision_create_mesh(s->collision, c->vertex_count, c->triangles,
                                        c->triangle_count, 0.5 * c->thickness, &m->shape));
    vbss_result result = vbss_scene_set_up_mesh(s, c->vertices, m->shape, &m->mesh);
    if (result == VBSS_OK) {
        result = vbss_scene_create_host_surface(s, &m->motion, c);
        if (result != VBSS_OK) {
            vbss_scene_release_mesh_arrays(s, &m->mesh, m->shape);
        }
    }
    if (result != VBSS_OK) {
        vbss_collision_shape_free(s->context, m->shape);
        return result;
    }
    m->shape->is_static = false;
    m->motion.surface->shape = m->shape;
    return VBSS_OK;
}

static void release_mesh(scene_object *s, new_mesh *m)
{
    vbss_scene_release_host_surface(s, &m->motion);
    vbss_scene_release_mesh_arrays(s, &m->mesh, m->shape);
    vbss_collision_shape_free(s->context, m->shape);
}

/* ---- holes */

static vec3 unit_normal(const uint32_t *n, const vec3 *x)
{
    return vec3_unit_or(vec3_cross(vec3_sub(x[n[1]], x[n[0]]), vec3_sub(x[n[2]], x[n[0]])),
                        vec3_zero());
}

/* The place of the new mesh that is nearest to a point. Of equal ones, that of the first triangle. */
static void find_nearest_place(const collision_shape *shape, const vec3 *x, vec3 point,
                               suture_hole *place)
{
    double nearest = (double)INFINITY;
    for (uint32_t i = 0; i < shape->triangle_count; i++) {
        vec3 corners[3];
        double weights[3];
        for (int k = 0; k < 3; k++) {
            corners[k] = vec3_sub(x[shape->triangles[i][k]], point);
        }
        const double distance = vec3_norm(closest_on_triangle(corners, weights));
        if (distance < nearest) {
            nearest = distance;
            place->triangle = i;
            memcpy(place->barycentric, weights, sizeof weights);
        }
    }
    vbss_suture_normalise_barycentric(place->barycentric);
}

/* Asks the host. `to` has the nearest place, which a host may leave. */
static vbss_result ask_host(const scene_object *s, const remesh_input *input,
                            const suture_hole *hole, const suture_wall *wall, suture_hole *to)
{
    vbss_scene_hole_place from = {
        .struct_size = sizeof from, .hole = hole->id, .triangle = hole->triangle};
    memcpy(from.weights, hole->barycentric, sizeof from.weights);
    vec3_store(from.position, vbss_hole_point(hole, wall, wall->now));
    vec3_store(from.normal, unit_normal(wall->triangles[hole->triangle], wall->now));
    const bool outer = vbss_callback_begin(s->context);
    const vbss_result result = input->place(input->user, &from, &to->triangle, to->barycentric);
    vbss_callback_end(s->context, outer);
    if (result != VBSS_OK) {
        return vbss_fail(s->context, VBSS_ERROR_NOT_FOUND, "the host has no place for hole %u",
                         hole->id);
    }
    if (to->triangle >= input->config.triangle_count) {
        return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE,
                         "hole %u is placed in triangle %u of %u", hole->id, to->triangle,
                         input->config.triangle_count);
    }
    return vbss_scene_check_weights(s->context, to->barycentric);
}

/* A hole that jumped farther would pull its suture through the wall. */
static vbss_result check_distance(const scene_object *s, const suture_hole *hole, double moved,
                                  double thickness)
{
    const scene_body *suture = vbss_scene_body(s, hole->needle != 0 ? hole->needle : hole->thread);
    const double limit = vbss_scene_suture_radius(suture) + 0.5 * thickness;
    return moved <= limit
               ? VBSS_OK
               : vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE,
                           "hole %u would move by %g m, at most by %g m", hole->id, moved, limit);
}

static vbss_result place_hole(const scene_object *s, const scene_body *b, const remesh_input *input,
                              const new_mesh *m, suture_hole *hole)
{
    const suture_wall wall = vbss_scene_wall_of(b);
    const vec3 *x = m->motion.surface->now;
    const vec3 before = vbss_hole_point(hole, &wall, wall.now);
    const vec3 normal = unit_normal(wall.triangles[hole->triangle], wall.now);
    suture_hole to = *hole;
    find_nearest_place(m->shape, x, before, &to);
    if (input->place != NULL) {
        VBSS_TRY(ask_host(s, input, hole, &wall, &to));
    }
    const uint32_t *corners = m->shape->triangles[to.triangle];
    vec3 after = vec3_zero();
    for (int k = 0; k < 3; k++) {
        after = vec3_add_scaled(after, to.barycentric[k], x[corners[k]]);
    }
    VBSS_TRY(check_distance(s, hole, vec3_distance(before, after), wall.law->thickness));
    /* Triangles of the new mesh may be wound the other way. */
    to.is_outward = hole->is_outward == (vec3_dot(normal, unit_normal(corners, x)) >= 0.0);
    *hole = to;
    return VBSS_OK;
}

static vbss_result place_holes(const scene_object *s, const scene_body *b,
                               const remesh_input *input, const new_mesh *m)
{
    memcpy(m->places, s->holes, s->config.hole_capacity * sizeof *m->places);
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        if (m->places[i].id != 0 && m->places[i].wall == b->number) {
            VBSS_TRY(place_hole(s, b, input, m, &m->places[i]));
        }
    }
    return VBSS_OK;
}

/* A hole that its thread has torn up to a free edge is at the free edge of the new mesh, too. */
static void restore_free_sides(scene_object *s, const scene_body *b)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        suture_hole *hole = &s->holes[i];
        if (hole->id == 0 || hole->wall != b->number || hole->free_side == 0) {
            continue;
        }
        const scene_hole_context p = vbss_scene_get_hole_context(s, hole);
        const vec3 thread = vbss_scene_hole_curve_point(&p, hole).position;
        const vec3 out = vec3_sub(thread, vbss_hole_point(hole, &p.wall, p.wall.now));
        (void)vbss_suture_move_hole(&p.wall, hole, out, p.wall.law->thickness);
    }
}

/* ---- replacement */

static bool is_of_mesh(const contact_key *key, uint32_t number)
{
    return key->kind != VBSS_SCENE_CONTACT_HOLE && (key->body_a == number || key->body_b == number);
}

/* Removes the warm start of contacts whose features no longer exist. Holes keep theirs. */
static void drop_warm_start(scene_object *s, uint32_t number)
{
    contact_set *set = s->contacts;
    uint32_t count = 0;
    for (uint32_t i = 0; i < set->warm_start_count; i++) {
        if (!is_of_mesh(&set->warm_start[i].key, number)) {
            set->warm_start[count++] = set->warm_start[i];
        }
    }
    set->warm_start_count = count;
}

/* The system has as much room for touched vertices as in a scene that was created with this mesh. Only that
 * may fail. On success `m` has the mesh from before. */
static vbss_result exchange_mesh(scene_object *s, scene_body *b, new_mesh *m)
{
    scene_host_surface *before = b->rigid.surface;
    b->rigid.surface = m->motion.surface;
    if (vbss_scene_surface_blocks(before) != vbss_scene_surface_blocks(b->rigid.surface)) {
        const vbss_result result = vbss_scene_create_system(s, NULL, 0);
        if (result != VBSS_OK) {
            b->rigid.surface = before;
            return result;
        }
    }
    b->rigid.surface->law = before->law;
    m->motion.surface = before;
    const scene_static_mesh mesh = b->rigid.mesh;
    b->rigid.mesh = m->mesh;
    m->mesh = mesh;
    m->shape = vbss_collision_exchange_shape(s->collision, b->shape, m->shape);
    b->rigid.mesh.geometry_hash = vbss_scene_hash_host_surface(b->rigid.surface, &b->rigid.mesh);
    return VBSS_OK;
}

static vbss_result remesh(scene_object *s, scene_body *b, const remesh_input *input, new_mesh *m)
{
    const vbss_scene_surface_config *c = &input->config;
    const scene_outline outline = {.surface = {m->motion.surface->now,
                                               (const uint32_t(*)[3])m->shape->triangles,
                                               c->triangle_count, 0.5 * c->thickness, false},
                                   .number = b->number,
                                   .is_prescribed = true,
                                   .ignores_holes = true};
    VBSS_TRY(place_holes(s, b, input, m));
    VBSS_TRY(vbss_scene_check_overlap(s, &outline, "new mesh of the host surface"));
    VBSS_TRY(exchange_mesh(s, b, m));
    memcpy(s->holes, m->places, s->config.hole_capacity * sizeof *m->places);
    restore_free_sides(s, b);
    drop_warm_start(s, b->number);
    s->step.pattern_hash = 0;
    s->report.generation++;
    return VBSS_OK;
}

static vbss_result create_and_remesh(scene_object *s, scene_body *b, const remesh_input *input)
{
    new_mesh m = {.mesh = {.is_one_sided = b->rigid.mesh.is_one_sided}};
    m.places = vbss_allocate(s->context, s->config.hole_capacity, sizeof *m.places, "holes");
    if (m.places == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    vbss_result result = create_mesh(s, &input->config, &m);
    if (result == VBSS_OK) {
        result = remesh(s, b, input, &m);
        release_mesh(s, &m);
    }
    vbss_release(s->context, m.places, s->config.hole_capacity, sizeof *m.places);
    return result;
}

vbss_result vbss_scene_remesh_surface(vbss_scene *scene, uint32_t body, const double *vertices,
                                      uint32_t vertex_count, const uint32_t *triangles,
                                      uint32_t triangle_count, vbss_scene_place_hole_fn place,
                                      void *user)
{
    VBSS_ENTER(scene);
    scene_object *s;
    scene_body *b;
    scene_edit edit;
    vbss_edit hook = {.kind = VBSS_EDIT_OTHER};
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(vbss_scene_require_surface(s, body, &b));
    remesh_input input = {.config = config_of(b), .place = place, .user = user};
    input.config.vertices = vertices;
    input.config.vertex_count = vertex_count;
    input.config.triangles = triangles;
    input.config.triangle_count = triangle_count;
    VBSS_TRY(vbss_scene_check_host_surface(s->context, &input.config));
    VBSS_TRY(vbss_scene_begin_edit(scene, &hook, &edit));
    return vbss_scene_end_edit(&edit, create_and_remesh(s, b, &input));
}
