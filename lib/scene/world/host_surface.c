/* Host surfaces: motion in a step, forces on vertices, checkpoint and rollback. */
#include "scene/world/host_surface.h"
#include "base/memory.h"
#include "base/stream.h"
#include "scene/world/world.h"

#include <string.h>

enum { SURFACE_ARRAYS = 18 };

static void list_arrays(scene_host_surface *h, vbss_array arrays[SURFACE_ARRAYS])
{
    const size_t n = h->vertex_count, compliant = scene_is_compliant(h) ? n : 0;
    const vbss_array all[SURFACE_ARRAYS] = {
        {&h->now, n, sizeof(vec3)},
        {&h->start, n, sizeof(vec3)},
        {&h->end, n, sizeof(vec3)},
        {&h->pending, n, sizeof(vec3)},
        {&h->trial, n, sizeof(vec3)},
        {&h->expected_displacements, n, sizeof(vec3)},
        {&h->swept, 2 * n, sizeof(vec3)},
        {&h->forces, n, sizeof(vec3)},
        {&h->checkpoint.now, n, sizeof(vec3)},
        {&h->checkpoint.start, n, sizeof(vec3)},
        {&h->checkpoint.end, n, sizeof(vec3)},
        {&h->compliance, compliant, sizeof(mat3)},
        {&h->stiffness, compliant, sizeof(mat3)},
        {&h->deflections, compliant, sizeof(vec3)},
        {&h->checkpoint.deflections, compliant, sizeof(vec3)},
        {&h->free_positions, compliant, sizeof(vec3)},
        {&h->touched, compliant, sizeof(uint32_t)},
        {&h->touched_index, compliant, sizeof(uint32_t)},
    };
    memcpy(arrays, all, sizeof all);
}

static uint32_t compliant_count(const scene_host_surface *h)
{
    return scene_is_compliant(h) ? h->vertex_count : 0;
}

static void copy(const scene_host_surface *h, vec3 *to, const vec3 *from)
{
    memcpy(to, from, h->vertex_count * sizeof *to);
}

static vbss_drain_config law_of(const vbss_scene_surface_config *config)
{
    return (vbss_drain_config){.thickness = config->thickness,
                               .puncture_force = config->puncture_force,
                               .hole_force = config->hole_force,
                               .hole_friction = config->hole_friction,
                               .hole_stiffness = config->hole_stiffness,
                               .hole_damping = config->hole_damping,
                               .tip_length = config->tip_length,
                               .thread_force = config->thread_force,
                               .tear_energy = config->tear_energy};
}

vbss_result vbss_scene_create_host_surface(scene_object *s, scene_rigid *r,
                                           const vbss_scene_surface_config *config)
{
    vbss_array arrays[SURFACE_ARRAYS];
    scene_host_surface *h = vbss_allocate(s->context, 1, sizeof *h, "host surface");
    if (h == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    *h = (scene_host_surface){.vertex_count = config->vertex_count,
                              .jump_limit = config->jump_limit,
                              .compliance_size = config->compliance_size,
                              .law = law_of(config)};
    list_arrays(h, arrays);
    const vbss_result result =
        vbss_allocate_arrays(s->context, arrays, SURFACE_ARRAYS, "host surface");
    if (result != VBSS_OK) {
        vbss_release_arrays(s->context, arrays, SURFACE_ARRAYS);
        vbss_release(s->context, h, 1, sizeof *h);
        return result;
    }
    for (uint32_t i = 0; i < h->vertex_count; i++) {
        h->now[i] = vec3_load(config->vertices + 3 * (size_t)i);
    }
    const mat3 none = mat3_zero();
    for (uint32_t i = 0; i < compliant_count(h); i++) {
        vbss_scene_set_vertex_compliance(h, i, &none);
        h->deflections[i] = vec3_zero();
        h->free_positions[i] = h->now[i];
    }
    copy(h, h->start, h->now);
    copy(h, h->end, h->now);
    copy(h, h->pending, h->now);
    vbss_scene_hold_host_surface(h);
    vbss_scene_clear_surface_forces(h);
    vbss_scene_checkpoint_host_surface(h);
    r->surface = h;
    return VBSS_OK;
}

void vbss_scene_release_host_surface(scene_object *s, scene_rigid *r)
{
    vbss_array arrays[SURFACE_ARRAYS];
    list_arrays(r->surface, arrays);
    vbss_release_arrays(s->context, arrays, SURFACE_ARRAYS);
    vbss_release(s->context, r->surface, 1, sizeof *r->surface);
    r->surface = NULL;
}

/* ---- motion */

const vec3 *vbss_scene_host_surface_targets(const scene_host_surface *h)
{
    return h->has_pending ? h->pending : h->end;
}

void vbss_scene_update_host_surface(scene_host_surface *h)
{
    h->is_moving = false;
    for (uint32_t i = 0; i < h->vertex_count && !h->is_moving; i++) {
        h->is_moving = vec3_distance(h->start[i], h->end[i]) != 0.0;
    }
}

void vbss_scene_apply_host_surfaces(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_host_surface *h = scene_host_surface_of(&s->bodies[i]);
        if (h != NULL && h->has_pending) {
            copy(h, h->end, h->pending);
            h->has_pending = false;
            vbss_scene_update_host_surface(h);
        }
    }
}

/* A point on the way; exactly the start if the end is the same. */
static vec3 partway(vec3 start, vec3 end, double fraction)
{
    return vec3_add_scaled(start, fraction, vec3_sub(end, start));
}

void vbss_scene_advance_host_surface(scene_host_surface *h, const scene_substep *substep)
{
    const double end_fraction = substep->end_fraction;
    for (uint32_t i = 0; i < h->vertex_count; i++) {
        const vec3 prescribed =
            end_fraction < 1.0 ? partway(h->start[i], h->end[i], end_fraction) : h->end[i];
        const vec3 rejected = h->trial[i];
        h->trial[i] = prescribed;
        if (scene_has_compliance(h, i)) {
            /* The forces of the last substep are the best guess. */
            h->free_positions[i] = prescribed;
            h->trial[i] = vec3_add(prescribed, h->deflections[i]);
        }
        h->expected_displacements[i] =
            vec3_sub(substep->uses_trial_motion ? rejected : h->trial[i], h->now[i]);
    }
}

void vbss_scene_hold_host_surface(scene_host_surface *h)
{
    copy(h, h->trial, h->now);
    memset(h->expected_displacements, 0, h->vertex_count * sizeof *h->expected_displacements);
}

void vbss_scene_truncate_host_surface(scene_host_surface *h, double fraction)
{
    for (uint32_t i = 0; i < h->vertex_count; i++) {
        h->trial[i] = partway(h->now[i], h->trial[i], fraction);
    }
}

static void record_deflections(scene_host_surface *h)
{
    for (uint32_t i = 0; i < compliant_count(h); i++) {
        h->deflections[i] =
            scene_has_compliance(h, i) ? vec3_sub(h->trial[i], h->free_positions[i]) : vec3_zero();
    }
}

void vbss_scene_commit_host_surfaces(scene_object *s, bool is_accepted)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_host_surface *h = scene_host_surface_of(&s->bodies[i]);
        if (h == NULL || s->bodies[i].is_frozen) {
            continue;
        }
        copy(h, h->now, h->trial);
        if (is_accepted) {
            record_deflections(h);
        }
    }
}

void vbss_scene_finish_host_surface(scene_host_surface *h, bool is_behind)
{
    copy(h, h->start, is_behind || scene_is_compliant(h) ? h->now : h->end);
    vbss_scene_update_host_surface(h);
}

/* ---- compliance */

/* Inverse of a positive definite matrix, by its cofactors. */
static mat3 inverse_of(const mat3 *a)
{
    const vec3 x = vec3_make(a->m[0][0], a->m[0][1], a->m[0][2]),
               y = vec3_make(a->m[1][0], a->m[1][1], a->m[1][2]),
               z = vec3_make(a->m[2][0], a->m[2][1], a->m[2][2]);
    const vec3 yz = vec3_cross(y, z), zx = vec3_cross(z, x), xy = vec3_cross(x, y);
    return mat3_transpose(mat3_scale(mat3_rows(yz, zx, xy), 1.0 / vec3_dot(x, yz)));
}

bool vbss_scene_is_compliance(const mat3 *c)
{
    double largest = 0.0;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            if (!(fabs(c->m[i][k]) <= SCENE_MAX_COMPLIANCE) || c->m[i][k] != c->m[k][i]) {
                return false;
            }
            largest = vbss_max(fabs(c->m[i][k]), largest);
        }
    }
    /* Pivots of its factor: the smallest is not below the smallest eigenvalue. */
    const double smallest = SCENE_MIN_COMPLIANCE_RATIO * largest, first = c->m[0][0];
    if (largest < SCENE_MIN_COMPLIANCE || first < smallest) {
        return largest == 0.0;
    }
    const double second = c->m[1][1] - c->m[1][0] * c->m[1][0] / first;
    const double row = c->m[2][1] - c->m[2][0] * c->m[1][0] / first;
    return second >= smallest &&
           c->m[2][2] - c->m[2][0] * c->m[2][0] / first - row * row / second >= smallest;
}

void vbss_scene_set_vertex_compliance(scene_host_surface *h, uint32_t vertex,
                                      const mat3 *compliance)
{
    h->compliance[vertex] = *compliance;
    h->stiffness[vertex] = compliance->m[0][0] > 0.0 ? inverse_of(compliance) : mat3_zero();
}

/* ---- forces */

void vbss_scene_clear_surface_forces(scene_host_surface *h)
{
    memset(h->forces, 0, h->vertex_count * sizeof *h->forces);
}

/* Barycentric weights of the vertices of a feature at the contact point. */
static void weights_of(const contact_constraint *constraint, const double barycentric[2], bool is_b,
                       double weights[3])
{
    weights[0] = 1.0;
    weights[1] = weights[2] = 0.0;
    if (constraint->key.kind == VBSS_SCENE_CONTACT_SIDES) {
        weights[1] = barycentric[is_b ? 1 : 0];
        weights[0] = 1.0 - weights[1];
    } else if (is_b) {
        weights[1] = barycentric[0];
        weights[2] = barycentric[1];
        weights[0] = 1.0 - weights[1] - weights[2];
    }
}

/* The corners of a hole's triangle share the force on its wall. */
static void add_hole_forces(scene_object *s, const contact_key *key, vec3 force)
{
    scene_host_surface *h = scene_host_surface_of(vbss_scene_body(s, key->body_b));
    const suture_hole *hole = &s->holes[key->feature_a];
    for (uint32_t k = 0; h != NULL && k < 3; k++) {
        vec3 *on_vertex = &h->forces[h->shape->triangles[hole->triangle][k]];
        *on_vertex = vec3_add_scaled(*on_vertex, -hole->barycentric[k], force);
    }
}

void vbss_scene_add_surface_forces(scene_object *s, const contact_constraint *constraint,
                                   vec3 force)
{
    const contact_key *key = &constraint->key;
    if (key->kind == VBSS_SCENE_CONTACT_HOLE) {
        add_hole_forces(s, key, force);
        return;
    }
    for (int k = 0; k < 2 && scene_is_surface_contact(key->kind); k++) {
        const bool is_b = k == 1;
        const scene_body *b = vbss_scene_body(s, is_b ? key->body_b : key->body_a);
        scene_host_surface *h = b != NULL ? scene_host_surface_of(b) : NULL;
        if (h == NULL) {
            continue;
        }
        uint32_t nodes[3] = {0};
        double weights[3];
        const uint32_t count = vbss_scene_surface_feature_nodes(
            s, b, key->kind, is_b, is_b ? key->feature_b : key->feature_a, nodes);
        weights_of(constraint, scene_geometry_of(s, constraint)->barycentric, is_b, weights);
        for (uint32_t i = 0; i < count && i < 3; i++) {
            h->forces[nodes[i]] =
                vec3_add_scaled(h->forces[nodes[i]], is_b ? -weights[i] : weights[i], force);
        }
    }
}

void vbss_scene_visit_hole_parameters(vbss_stream *stream, uint16_t field, vbss_drain_config *law)
{
    double *numbers[] = {&law->puncture_force, &law->hole_force,   &law->hole_friction,
                         &law->hole_stiffness, &law->hole_damping, &law->tip_length,
                         &law->thread_force};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_f64(stream, field, numbers[i], 1);
    }
}

/* ---- triangles */

static vec3 area_normal(const vec3 *x, const uint32_t *n)
{
    return vec3_cross(vec3_sub(x[n[1]], x[n[0]]), vec3_sub(x[n[2]], x[n[0]]));
}

bool vbss_scene_keeps_triangles(const uint32_t (*triangles)[3], uint32_t count, const vec3 *from,
                                const vec3 *to, uint32_t *triangle)
{
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t *n = triangles[i];
        if (!(vec3_dot(area_normal(from, n), area_normal(to, n)) > 0.0)) {
            *triangle = i;
            return false;
        }
    }
    return true;
}

/* ---- checkpoint */

void vbss_scene_checkpoint_host_surface(scene_host_surface *h)
{
    copy(h, h->checkpoint.now, h->now);
    copy(h, h->checkpoint.start, h->start);
    copy(h, h->checkpoint.end, h->end);
    memcpy(h->checkpoint.deflections, h->deflections, compliant_count(h) * sizeof *h->deflections);
    h->checkpoint.is_moving = h->is_moving;
    h->checkpoint.has_pending = h->has_pending;
}

void vbss_scene_rollback_host_surface(scene_host_surface *h)
{
    copy(h, h->now, h->checkpoint.now);
    copy(h, h->start, h->checkpoint.start);
    copy(h, h->end, h->checkpoint.end);
    memcpy(h->deflections, h->checkpoint.deflections, compliant_count(h) * sizeof *h->deflections);
    h->is_moving = h->checkpoint.is_moving;
    h->has_pending = h->checkpoint.has_pending;
}
