/* Internal interface of replicas: the state of a scene for a reader in another thread.
 *
 * replica.c has the public object, publish.c the copy that the stepping thread makes, and read.c all
 * that the reader thread calls. Both threads use an object at the same time: the fields of
 * replica_object say which thread may touch them. */
#ifndef VBSS_REPLICA_REPLICA_H
#define VBSS_REPLICA_REPLICA_H

#include <vblast_ss/replica.h>

#include "base/linear.h"
#include "base/slot.h"
#include "base/triple_buffer.h"
#include "scene/api/inspect.h"

/* ---- one state */

typedef struct replica_body {
    uint32_t number; /* in the scene */
    uint32_t first_capsule, capsule_count;
    quat orientation;        /* of rigid bodies: principal frame, body to world */
    scene_geometry geometry; /* with arrays of the state */
} replica_body;

/* A row of VBSS_REPLICA_VIEW_BODIES. */
typedef struct replica_body_row {
    uint32_t kind, number, first_node, node_count, first_triangle, triangle_count, first_capsule,
        capsule_count;
} replica_body_row;

/* A row of VBSS_REPLICA_VIEW_HOLE_PLACES. */
typedef struct replica_hole_row {
    double position[3], rest_position[3], radius, arc_length;
} replica_hole_row;

typedef struct replica_state {
    uint64_t number, steps, bytes; /* as in vbss_replica_state */
    double time;
    bool has_floor;
    vec3 floor_normal;
    double floor_height;

    uint32_t body_count, node_count, capsule_count, hole_count, contact_count;
    uint32_t drain_count, drain_node_count, triangle_count, edge_count;
    /* Per body. */
    replica_body *bodies;
    replica_body_row *body_rows;
    double (*poses)[7];
    double (*sizes)[2];
    /* Per node of threads and drains. */
    vec3 *nodes;
    double *tensions, *rest_lengths;
    /* The meshes of drains, which do not change while a drain exists. The state keeps them for the
     * next publication of the same drains. Per drain: the identity of the one whose mesh is there,
     * NULL: none. Then per node of drains, per triangle and per edge. */
    const void **mesh_identities;
    vec3 *rest_positions;
    double (*material_coordinates)[2];
    uint32_t *first_edge;
    uint32_t (*triangles)[3];
    uint32_t (*edges)[4];
    uint32_t *next_edge;
    scene_capsule_info *capsules;
    /* Per hole. */
    scene_hole_info *holes;
    uint32_t (*hole_bodies)[4];
    replica_hole_row *hole_rows;
    /* Per contact. */
    uint32_t (*contact_features)[5];
    vec3 *contact_points, *contact_normals, *contact_forces;
    double *contact_gaps;
} replica_state;

/* ---- the object */

typedef struct replica_capacities {
    uint32_t bodies, thread_nodes, drains, drain_nodes, capsules, holes, contacts;
} replica_capacities;

/* Largest numbers of triangles and edges per node of a drain. Derived from Euler's formula for a
 * surface with a free edge. */
enum { REPLICA_TRIANGLES_PER_NODE = 2, REPLICA_EDGES_PER_NODE = 3 };

/* NOLINTNEXTLINE(clang-analyzer-optin.performance.Padding): each thread writes to cache lines of its own */
typedef struct replica_object {
    /* Constant. */
    vbss_context *context;
    replica_capacities capacities;
    /* The thread that owns a copy may touch that state; only the stepping thread touches
     * buffer.writer, and only the reader buffer.reader. */
    vbss_triple_buffer buffer;
    replica_state states[3];
    /* Stepping thread. */
    _Alignas(64) uint64_t published;
    /* 1 while a thread is in a function for the reader. */
    _Alignas(64) atomic_uint is_reading;
    /* Reader. */
    uint64_t missed;
} replica_object;

/* ---- replica.c */
extern const vbss_kind vbss_replica_kind_of_slot;

/* ---- publish.c */

/* Copies the state of a scene. VBSS_ERROR_CAPACITY, or VBSS_ERROR_INVALID_HANDLE if the scene was
 * destroyed. */
vbss_result vbss_replica_copy_scene(const replica_object *r, replica_state *state,
                                    const vbss_scene *scene);

/* ---- read.c */

/* Begins a call of the reader, and finds the state that it took last. VBSS_ERROR_INVALID_HANDLE, or
 * VBSS_ERROR_BUSY if another thread is in such a call. There is no error text. */
vbss_result vbss_replica_begin_reading(const void *replica, const replica_state **state);
/* Ends it. The handle must be one that began. */
void vbss_replica_end_reading(const void *replica);

#endif
