/**
 * @file replica.h
 * @brief A replica passes the newest state of a scene from the stepping thread to one reader thread.
 *
 * A host often steps a scene in one thread and draws it in another. All other functions need both
 * threads to take turns (see the @threads line of each function). A replica removes that need for
 * the state that is drawn:
 *
 * - The *stepping thread* creates the replica and calls #vbss_replica_publish between steps. The
 *   call copies the state into one of three buffers. It allocates nothing and never waits.
 * - The *reader thread* calls #vbss_replica_take. Views then show the newest published state, and do
 *   not change until its next take. That call never waits either. A slow reader misses states, but
 *   never sees a state in part.
 *
 * A visual in the reader's own context makes the meshes (#vbss_visual_add_replica). Functions with
 * the note *reader thread* enter no context, so they store no error text. One thread at a time may be
 * the reader. docs/guides/threads.md shows the whole pattern.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_REPLICA_H
#define VBLAST_SS_REPLICA_H

#include <vblast_ss/base.h>
#include <vblast_ss/scene.h>

/** A copy of a scene for another thread. */
typedef struct vbss_replica vbss_replica;

/** Configuration of a replica. Fill it with #vbss_replica_config_init, then change fields. */
typedef struct vbss_replica_config {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    /** Largest number of nodes of all drains, 0 to 2^20. Default 0: the nodes of the drains that the
     * scene has when the replica is created. All other capacities are those of the scene. */
    uint32_t drain_node_capacity;
} vbss_replica_config;

/** Kind of a body in a replica: a VBSS_REPLICA_ constant, with the numbers of #vbss_visual_kind. */
typedef int32_t vbss_replica_kind;

/** The constants of #vbss_replica_kind. */
enum {
    VBSS_REPLICA_KIND_THREAD = 1, /**< A thread, or a piece of one. */
    VBSS_REPLICA_KIND_DRAIN = 2,  /**< A drain. */
    VBSS_REPLICA_KIND_NEEDLE = 3, /**< A needle. */
    VBSS_REPLICA_KIND_DRIVER = 4, /**< A grasper that is a needle driver. */
    VBSS_REPLICA_KIND_SHEARS = 5, /**< A grasper that is shears. */
    VBSS_REPLICA_KIND_RIGID = 6   /**< Another rigid body. */
};

/** An array of the state that was taken last: a VBSS_REPLICA_VIEW_ constant. */
typedef int32_t vbss_replica_field;

/** The constants of #vbss_replica_field. Bodies have the order of the scene's table of bodies. */
enum {
    /** x 8 uint32_t: #vbss_replica_kind, number of the body in its scene, first node, number of nodes,
     * first triangle, number of triangles, first capsule, number of capsules. */
    VBSS_REPLICA_VIEW_BODIES = 0,
    /** x 7, one row per body: position of the frame that #vbss_scene_get_rigid reports, m, and
     * orientation w, x, y, z. Threads and drains have 0, 0, 0 and 1, 0, 0, 0. */
    VBSS_REPLICA_VIEW_POSES = 1,
    /** x 2, one row per body: radius of a thread or of a needle's wire, or half the thickness of a
     * drain's wall, m, otherwise 0; angle of each jaw of a grasper from the middle, rad, otherwise
     * 0. */
    VBSS_REPLICA_VIEW_SIZES = 2,
    VBSS_REPLICA_VIEW_NODES = 3, /**< x 3: positions of the nodes of threads and drains, m. */
    /** x 1, one row per node: tension of the segment of a thread that begins at this node, N, without the
     * part of bending, as visuals show it. It is 0 at the last node of a thread and at nodes of
     * drains. */
    VBSS_REPLICA_VIEW_TENSIONS = 4,
    /** x 3 uint32_t: nodes of the triangles of drains, counted from the drain's first node,
     * counter-clockwise seen from outside. */
    VBSS_REPLICA_VIEW_TRIANGLES = 5,
    /** x 7: both ends of the axis and the radius of the capsules of rigid bodies, needles and graspers,
     * m. */
    VBSS_REPLICA_VIEW_CAPSULES = 6,
    /** x 4 uint32_t, one row per hole: its id, number of the needle in it or 0, number of the thread in
     * it or 0, number of the drain. */
    VBSS_REPLICA_VIEW_HOLES = 7,
    /** x 8, one row per hole: position, position on the drain at rest, radius of the suture in it, arc
     * length of the suture there, m. */
    VBSS_REPLICA_VIEW_HOLE_PLACES = 8,
    VBSS_REPLICA_VIEW_CONTACTS = 9,         /**< x 5 uint32_t: as VBSS_SCENE_VIEW_CONTACTS. */
    VBSS_REPLICA_VIEW_CONTACT_POINTS = 10,  /**< x 3: point between the two surfaces, m. */
    VBSS_REPLICA_VIEW_CONTACT_NORMALS = 11, /**< x 3: unit normal from b to a. */
    VBSS_REPLICA_VIEW_CONTACT_FORCES = 12,  /**< x 3: force of b on a, N. */
    VBSS_REPLICA_VIEW_CONTACT_GAPS = 13     /**< x 1: distance of the surfaces, m. */
};

/** The state that was taken last. */
typedef struct vbss_replica_state {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    /** 1: this call took a state; 0: none was published since the last take, so it is the same as
     * before. */
    int32_t is_new;
    /** Number of the state: 1 for the first that was published; 0: none was published yet, and all
     * arrays are empty. */
    uint64_t number;
    uint64_t missed;   /**< Published states that the reader has never taken, up to this one. */
    uint64_t steps;    /**< Steps of the scene: vbss_scene_statistics::steps. */
    double time;       /**< Simulated time of the scene, s: vbss_scene_statistics::time. */
    uint64_t bytes;    /**< Bytes that the call copied that published this state. */
    int32_t floor;     /**< 1: the scene has a floor; otherwise 0. */
    uint32_t reserved; /**< Zero. */
    double floor_normal[3]; /**< Direction up of the floor, unit. */
    double floor_height;    /**< Height of the floor along its normal, m. */
} vbss_replica_state;

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Fills a configuration with the defaults.
 *
 * @param[out] config  the configuration to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_replica_config_init(vbss_replica_config *config, uint32_t struct_size);

/**
 * Creates a replica in the context of a scene, with the scene's capacities. Only this call allocates
 * memory. Add drains to the scene first, or state drain_node_capacity.
 *
 * @param scene         the scene whose capacities the replica gets
 * @param config        the configuration; NULL for the defaults
 * @param[out] replica  the new replica, without a state; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_OUT_OF_MEMORY or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_replica_create(vbss_scene *scene, const vbss_replica_config *config,
                                         vbss_replica **replica);

/**
 * Destroys a replica. Its views become invalid, so the reader must have finished with it. A visual
 * does not show it any more. Destroying the context destroys the replica too; the reader must have
 * finished before that, and visuals of other contexts must have removed it.
 *
 * @param replica  the replica; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY (also: the reader is in a call)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_replica_destroy(vbss_replica *replica);

/**
 * Publishes the state of a scene as it is after the last step or edit. The call copies the state,
 * allocates nothing and never waits for the reader. The constant mesh of a drain is copied only into
 * buffers that do not have it yet. On failure the reader keeps the state that was published before.
 *
 * @param replica  the replica
 * @param scene    a scene of the same context
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: a scene of another context), VBSS_ERROR_CAPACITY
 *         (the scene has more of something than the replica has room for) or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_replica_publish(vbss_replica *replica, vbss_scene *scene);

/**
 * Takes the newest published state. Earlier views become invalid if there is a new one. The call
 * stores no error text, and never waits for the stepping thread.
 *
 * @param replica      the replica
 * @param[out] state   receives what describes the state; may be NULL
 * @param struct_size  `sizeof *state` as the caller was compiled; not used if state is NULL
 * @return VBSS_OK (also: nothing is new), VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_BUSY (a second thread reads at the same time)
 * @threads the reader thread, at the same time as any call on the context
 * @since 1.0
 */
VBSS_API vbss_result vbss_replica_take(vbss_replica *replica, vbss_replica_state *state,
                                       uint32_t struct_size);

/**
 * Returns a view of one of the arrays of the state that was taken last. It is valid until the next
 * take, or until the replica is destroyed. The call stores no error text.
 *
 * @param replica      the replica
 * @param field        the array
 * @param[out] view    receives the address and the shape of the array; its generation is the number
 *                     of the state
 * @param struct_size  `sizeof *view` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_OUT_OF_RANGE (no such field) or VBSS_ERROR_BUSY (a second thread reads at the
 *         same time)
 * @threads the reader thread, at the same time as any call on the context
 * @since 1.0
 */
VBSS_API vbss_result vbss_replica_get_view(vbss_replica *replica, vbss_replica_field field,
                                           vbss_view *view, uint32_t struct_size);

#ifdef __cplusplus
}
#endif

#endif
