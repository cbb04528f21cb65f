/* Compliance of host surfaces in the linear system. A vertex that a contact or hole touches gets a block: its
 * unknown is the displacement from the position that the host has prescribed, against which the stiffness
 * of the vertex, the inverse of its compliance, acts. Without contact a vertex is where the host says, and has
 * no block. */
#include "base/error.h"
#include "scene/solve/solve.h"
#include "scene/world/world.h"

#include <string.h>

static void mark_vertices(const scene_object *s, const contact_key *key, bool is_b)
{
    const scene_body *b = vbss_scene_body(s, is_b ? key->body_b : key->body_a);
    scene_host_surface *h = scene_host_surface_of(b);
    uint32_t nodes[3];
    if (!scene_is_compliant(h)) {
        return;
    }
    const uint32_t count = vbss_scene_surface_feature_nodes(
        s, b, key->kind, is_b, is_b ? key->feature_b : key->feature_a, nodes);
    for (uint32_t k = 0; k < count; k++) {
        h->touched_index[nodes[k]] = 1;
    }
}

/* The corners of the triangle in which a hole is. */
static void mark_hole(const scene_object *s, const contact_key *key)
{
    const scene_body *b = vbss_scene_body(s, key->body_b);
    scene_host_surface *h = scene_host_surface_of(b);
    for (uint32_t k = 0; scene_is_compliant(h) && k < 3; k++) {
        h->touched_index[h->shape->triangles[s->holes[key->feature_a].triangle][k]] = 1;
    }
}

/* Numbers the marked vertices. */
static void list_touched(scene_host_surface *h)
{
    for (uint32_t i = 0; i < h->vertex_count; i++) {
        if (h->touched_index[i] != 0) {
            h->touched_index[i] = h->touched_count;
            h->touched[h->touched_count++] = i;
        }
    }
}

void vbss_scene_list_touched_vertices(scene_object *s)
{
    bool is_any_compliant = false;
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_host_surface *h = scene_host_surface_of(&s->bodies[i]);
        if (scene_is_compliant(h)) {
            memset(h->touched_index, 0, h->vertex_count * sizeof *h->touched_index);
            h->touched_count = 0;
            is_any_compliant = true;
        }
    }
    if (!is_any_compliant) {
        return;
    }
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        const contact_key *key = &s->contacts->constraints[i].key;
        if (scene_is_surface_contact(key->kind)) {
            mark_vertices(s, key, false);
            mark_vertices(s, key, true);
        } else if (key->kind == VBSS_SCENE_CONTACT_HOLE) {
            mark_hole(s, key);
        }
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_host_surface *h = scene_host_surface_of(&s->bodies[i]);
        if (scene_is_compliant(h)) {
            list_touched(h);
        }
    }
}

static bool is_touched(const scene_host_surface *h, uint32_t vertex)
{
    const uint32_t index = h->touched_index[vertex];
    return index < h->touched_count && h->touched[index] == vertex;
}

void vbss_scene_release_untouched_vertices(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_host_surface *h = scene_host_surface_of(&s->bodies[i]);
        for (uint32_t k = 0;
             scene_is_compliant(h) && !s->bodies[i].is_frozen && k < h->vertex_count; k++) {
            if (scene_has_compliance(h, k) && !is_touched(h, k)) {
                h->trial[k] = h->free_positions[k];
            }
        }
    }
}

vbss_result vbss_scene_register_touched_vertices(scene_object *s, const scene_rigid *r)
{
    const scene_host_surface *h = r->surface;
    uint32_t first;
    if (!scene_is_compliant(h) || h->touched_count == 0) {
        return VBSS_OK;
    }
    VBSS_TRY(vbss_system_add_chain(s->system, h->touched_count, &first));
    for (uint32_t i = 0; i < h->touched_count; i++) {
        vbss_system_set_role(s->system, first + i,
                             scene_has_compliance(h, h->touched[i]) ? VBSS_ROLE_SEPARATOR
                                                                    : VBSS_ROLE_PRESCRIBED);
    }
    return VBSS_OK;
}

void vbss_scene_assemble_surface(const scene_object *s, const scene_rigid *r)
{
    const scene_host_surface *h = r->surface;
    const uint32_t first = scene_first_vertex_block(r);
    for (uint32_t i = 0; scene_is_compliant(h) && i < h->touched_count; i++) {
        const uint32_t vertex = h->touched[i];
        const vec3 deflection = vec3_sub(h->trial[vertex], h->free_positions[vertex]);
        if (scene_has_compliance(h, vertex)) {
            block_set(&s->system->diagonal[first + i], h->stiffness[vertex]);
            s->system->rhs[first + i] = vec3_neg(mat3_mul_vec3(h->stiffness[vertex], deflection));
        }
    }
}

void vbss_scene_advance_surface(const scene_object *s, const scene_rigid *r)
{
    scene_host_surface *h = r->surface;
    const uint32_t first = scene_first_vertex_block(r);
    for (uint32_t i = 0; scene_is_compliant(h) && i < h->touched_count; i++) {
        if (scene_has_compliance(h, h->touched[i])) {
            h->trial[h->touched[i]] =
                vec3_add(h->trial[h->touched[i]], s->system->solution[first + i]);
        }
    }
}
