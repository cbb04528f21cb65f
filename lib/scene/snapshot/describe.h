/* The description of a scene in its snapshots: enough to create an equal scene, whose state is then
 * restored. It is no part of the hash of the state. api/load.c creates scenes from it. */
#ifndef VBSS_SCENE_DESCRIBE_H
#define VBSS_SCENE_DESCRIBE_H

#include "scene/world/scene_data.h"

#define SCENE_DESCRIPTION VBSS_CODE('D', 'E', 'S', 'C')
enum { SCENE_DESCRIPTION_VERSION = 1 };

/* What a record describes. Snapshots have these numbers. Chosen. */
enum {
    SCENE_DESCRIBED_THREAD = 1,
    SCENE_DESCRIBED_PIECE = 2, /* an entry for a piece of the thread before it, cut off or spare */
    SCENE_DESCRIBED_DRAIN = 3,
    SCENE_DESCRIBED_RIGID = 4,
    SCENE_DESCRIBED_NEEDLE = 5,
    SCENE_DESCRIBED_GRASPER = 6,
    SCENE_DESCRIBED_GONE_THREAD = 7, /* a thread that has left the scene, but not its pieces */
    SCENE_DESCRIBED_SURFACE = 8,     /* a drain with a surface */
    SCENE_DESCRIBED_STATIC_MESH = 9,
    SCENE_DESCRIBED_HOST_SURFACE = 10, /* its holes have the default parameters */
    SCENE_DESCRIBED_PLANE = 11,
    SCENE_DESCRIBED_WALL = 12, /* a host surface, with the parameters of its holes */
    SCENE_DESCRIBED_RIGID_MESH = 13,
    SCENE_DESCRIBED_TEARING_WALL = 14 /* a wall, with its tear energy */
};

/* A rigid body that is neither a needle nor a grasper. */
typedef struct scene_rigid_description {
    vbss_scene_rigid_kind kind;
    uint32_t capsule_count;
    double friction, mass; /* the mass in kg */
    vec3 inertia;          /* principal moments, kg m^2 */
    pose frame;            /* principal frame in the frame that hosts see */
} scene_rigid_description;

typedef struct scene_static_mesh_description {
    uint32_t vertex_count, triangle_count, one_sided;
    double friction, thickness; /* the thickness in m */
} scene_static_mesh_description;

/* A rigid body whose shape is a mesh. Its vertices in the description are in its principal frame. */
typedef struct scene_rigid_mesh_description {
    scene_rigid_description rigid;
    scene_static_mesh_description mesh;
} scene_rigid_mesh_description;

typedef struct scene_plane_description {
    scene_plane plane;
    double friction;
} scene_plane_description;

/* A host surface. Its vertices in the description are where it was when the snapshot was saved. */
typedef struct scene_host_surface_description {
    scene_static_mesh_description mesh;
    double jump_limit; /* m */
    uint32_t compliance_size;
    vbss_drain_config law; /* parameters of punctures and holes */
} scene_host_surface_description;

/* Numbers of entries of a surface's arrays. */
typedef struct scene_surface_counts {
    uint32_t nodes, triangles, anchors;
    uint32_t thicknesses, moduli; /* as many as triangles, or 0 */
} scene_surface_counts;

typedef struct scene_body_description {
    uint32_t type;                 /* SCENE_DESCRIBED_ */
    uint32_t entry, shape, number; /* of the body, in their tables; number 0: a spare piece */
    uint32_t rest_count; /* threads: rest lengths in the record; 0: only the state has them */
    scene_surface_counts surface; /* drains with a surface */
    vbss_baseline_config
        baseline; /* threads, drains, graspers: to which their configuration points */
    union {       /* `type` says which one is in use */
        vbss_thread_config thread;
        vbss_drain_config drain;
        vbss_needle_config needle;
        vbss_grasper_config grasper;
        scene_rigid_description rigid;
        scene_static_mesh_description static_mesh;
        scene_plane_description plane;
        scene_host_surface_description host_surface;
        scene_rigid_mesh_description rigid_mesh;
    };
} scene_body_description;

/* Sizes of the tables, and the number of records that follow, in ascending order of their shapes. */
typedef struct scene_table_description {
    uint32_t entry_count, shape_count, record_count;
} scene_table_description;

void vbss_scene_visit_table(vbss_stream *stream, scene_table_description *table);

/* Visits a record without its arrays. The configurations that a reading stream fills must hold the
 * defaults. */
void vbss_scene_visit_body_description(vbss_stream *stream, scene_body_description *d);

/* Arrays of a surface. An array of a read-only surface is only written. */
typedef struct scene_surface_arrays {
    double *positions, *thickness, *young_modulus;
    uint32_t *triangles, *anchors;
} scene_surface_arrays;

/* The arrays after it: of a surface its numbers, of a thread `rest_count` rest lengths, of a rigid body
 * its capsules, of a mesh or host surface its vertices and triangles. */
void vbss_scene_visit_described_surface(vbss_stream *stream, const scene_surface_counts *counts,
                                        const scene_surface_arrays *arrays);
void vbss_scene_visit_described_rest(vbss_stream *stream, double *rest_lengths, uint32_t count);
void vbss_scene_visit_described_static_mesh(vbss_stream *stream,
                                            const scene_static_mesh_description *d,
                                            double *vertices, uint32_t *triangles);
void vbss_scene_visit_described_capsule(vbss_stream *stream, scene_capsule *capsule);

/* Visits the whole record of a body that is no piece. The stream does not read. */
void vbss_scene_visit_body(vbss_stream *stream, scene_object *s, uint32_t entry);

/* Visits the description of a scene, a scene_object. The stream does not read. */
void vbss_scene_describe(vbss_stream *stream, void *object);

#endif
