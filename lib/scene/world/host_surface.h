/* Host surfaces: meshes whose vertices the host moves. A host surface is a driven rigid body without
 * capsules; its collision shape has the triangles, this file its motion. */
#ifndef VBSS_SCENE_HOST_SURFACE_H
#define VBSS_SCENE_HOST_SURFACE_H

#include <vblast_ss/scene_surface.h>

#include "scene/world/scene_data.h"

/* The motion of a host surface. Arrays hold one entry for each vertex. */
struct scene_host_surface {
    /* Persistent. */
    uint32_t vertex_count;
    const collision_shape *shape; /* of its body */
    vbss_drain_config law;        /* only thickness, punctures and holes */
    double
        jump_limit; /* largest distance between positions that the host gives one after the other, m */
    vec3 *now;      /* positions, m */
    vec3 *start, *end; /* prescribed at the start and end of the step, m */
    bool is_moving;    /* some vertex has another position in `end` than in `start` */
    vec3 *pending;     /* for the next step that begins, if has_pending, m */
    bool has_pending;
    /* Numbers of compliance for each vertex that the host states: 0, 1 or 9. 0: all vertices are
     * prescribed, and the arrays of compliance are empty. */
    uint32_t compliance_size;
    mat3 *compliance;  /* displacement by a force, m/N; zero for a prescribed vertex */
    mat3 *stiffness;   /* its inverse, N/m; zero for a prescribed vertex */
    vec3 *deflections; /* by forces in the last accepted substep, m */
    /* Substep: positions without forces at its end, m; vertices that contacts touch, in ascending order; per
     * vertex, its index among them. */
    vec3 *free_positions;
    uint32_t *touched, *touched_index;
    uint32_t touched_count;
    /* Substep. */
    vec3 *trial;                  /* positions at its end, m */
    vec3 *expected_displacements; /* from `now` to its end, m */
    /* Scratch of the broad phase: two per vertex, positions at the start and end of the substep, m. */
    vec3 *swept;
    /* Report; snapshots save it: contact forces, N. */
    vec3 *forces;
    /* Checkpoint. */
    struct scene_host_surface_checkpoint {
        vec3 *now, *start, *end, *deflections;
        bool is_moving, has_pending;
    } checkpoint;
};

/* Allocates the motion of a surface at rest at the positions of the configuration, without compliance, and
 * gives it to the rigid body. VBSS_ERROR_OUT_OF_MEMORY. */
vbss_result vbss_scene_create_host_surface(scene_object *s, scene_rigid *r,
                                           const vbss_scene_surface_config *config);

/* Releases it. */
void vbss_scene_release_host_surface(scene_object *s, scene_rigid *r);

/* Positions that the host gave last, m. */
const vec3 *vbss_scene_host_surface_targets(const scene_host_surface *h);

/* Makes the pending positions of all surfaces those of the step that begins. */
void vbss_scene_apply_host_surfaces(scene_object *s);

/* Sets trial positions and expected displacements for a substep. */
void vbss_scene_advance_host_surface(scene_host_surface *h, const scene_substep *substep);

/* Keeps a surface where it is: the trial positions are the present ones. */
void vbss_scene_hold_host_surface(scene_host_surface *h);

/* Shortens the motion up to the trial positions to a fraction of it. */
void vbss_scene_truncate_host_surface(scene_host_surface *h, double fraction);

/* Makes the trial positions of all surfaces the present ones. `is_accepted`: they are those of a solution, not
 * of a truncated motion. */
void vbss_scene_commit_host_surfaces(scene_object *s, bool is_accepted);

/* Ends the motion of a step. A surface that lags behind starts the next step from where it is. */
void vbss_scene_finish_host_surface(scene_host_surface *h, bool is_behind);

/* Sets the contact forces to zero. */
void vbss_scene_clear_surface_forces(scene_host_surface *h);

/* Whether vertices of a surface give way to forces. */
static inline bool scene_is_compliant(const scene_host_surface *h)
{
    return h != NULL && h->compliance_size > 0;
}

/* Whether a vertex does. */
static inline bool scene_has_compliance(const scene_host_surface *h, uint32_t vertex)
{
    return scene_is_compliant(h) && h->compliance[vertex].m[0][0] > 0.0;
}

/* First system block of the touched vertices, behind the two blocks of the rigid body. */
static inline uint32_t scene_first_vertex_block(const scene_rigid *r)
{
    return r->blocks.first + 2;
}

/* Whether a system block belongs to a touched vertex of a compliant surface. */
static inline bool scene_is_vertex_block(const scene_rigid *r, uint32_t block_index)
{
    return scene_is_compliant(r->surface) && block_index >= scene_first_vertex_block(r) &&
           block_index - scene_first_vertex_block(r) < r->surface->touched_count;
}

/* Whether numbers are a compliance: all zero, or symmetric and positive definite within the limits of the
 * public header. */
bool vbss_scene_is_compliance(const mat3 *compliance);

/* Sets the compliance of a vertex, which is zero or positive definite, and its inverse. */
void vbss_scene_set_vertex_compliance(scene_host_surface *h, uint32_t vertex,
                                      const mat3 *compliance);

/* Distributes a contact force on the vertices of its host surface, if one of its bodies is one. `force`: on body
 * a, N. */
void vbss_scene_add_surface_forces(scene_object *s, const contact_constraint *constraint,
                                   vec3 force);

/* Whether a move leaves every triangle its area and turns no normal by 90 degrees or more. `from`:
 * positions before; equal to `to`: whether every triangle has an area. Stores the first other
 * triangle. */
bool vbss_scene_keeps_triangles(const uint32_t (*triangles)[3], uint32_t count, const vec3 *from,
                                const vec3 *to, uint32_t *triangle);

/* Visits the parameters of punctures and holes. */
void vbss_scene_visit_hole_parameters(vbss_stream *stream, uint16_t field, vbss_drain_config *law);

void vbss_scene_checkpoint_host_surface(scene_host_surface *h);
void vbss_scene_rollback_host_surface(scene_host_surface *h);

/* Sets what follows from the persistent arrays, after they were read from a snapshot. */
void vbss_scene_update_host_surface(scene_host_surface *h);

#endif
