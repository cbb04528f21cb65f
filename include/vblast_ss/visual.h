/**
 * @file visual.h
 * @brief Meshes to draw: smooth surfaces of the threads, drains, needles, graspers and other bodies of a scene.
 *
 * The host adds to a visual a scene with all its bodies, or single bodies. Once a frame, the visual writes
 * their vertices and triangles into buffers that a renderer can use directly. It needs no graphics library,
 * and changes no object that it shows.
 *
 * - A thread becomes a round tube about the interpolating cubic spline through its nodes, with
 *   rotation-minimising frames (Wang, Juettler, Zheng and Liu 2008) and rounded ends. Pieces of a thread
 *   that was cut in a scene are parts of their own.
 * - A drain becomes a wall with two faces and rims, also at the lips of its slit. The faces lie half its
 *   thickness to either side of curved patches through its nodes (Vlachos et al. 2001). Marks and holes of
 *   a drain are *spots*: points of the drain at rest, which a renderer finds in the `material` of vertices.
 * - A needle becomes a wire with a tip, a grasper a shaft, a neck and two jaws, and a floor a square.
 *
 * Tolerances determine the resolution of the meshes. Surfaces of bodies are closed: if vertices at one
 * position count as one, each side belongs to two triangles, which traverse it in opposite directions.
 * docs/explanation/visual.md has the formulas and figures.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_VISUAL_H
#define VBLAST_SS_VISUAL_H

#include <vblast_ss/base.h>
#include <vblast_ss/drain.h>
#include <vblast_ss/grasper.h>
#include <vblast_ss/needle.h>
#include <vblast_ss/replica.h>
#include <vblast_ss/scene.h>
#include <vblast_ss/thread.h>

/** Meshes of scenes and bodies. */
typedef struct vbss_visual vbss_visual;

/** Configuration of a visual. Fill it with #vbss_visual_config_init, then change fields. */
typedef struct vbss_visual_config {
    uint32_t struct_size;     /**< Size of this struct in bytes, set by the init function. */
    uint32_t source_capacity; /**< Largest number of scenes and bodies, 1 to 256; default 8. */
    uint32_t part_capacity;   /**< Largest number of drawn bodies, 1 to 4096; default 32. */
    /** Largest number of vertices, 16 to 2^24; default 65536. The visual allocates two such meshes. */
    uint32_t vertex_capacity;
    uint32_t triangle_capacity; /**< Largest number of triangles, 16 to 2^24; default 131072. */
    uint32_t spot_capacity;     /**< Largest number of spots, 0 to 4096; default 32. */
    /** Largest number of nodes of a thread or a drain, 2 to 65537; default 4096. */
    uint32_t node_capacity;
    /** Largest number of sides of a tube's section, 6 to 64; default 32. The smallest number is 6. */
    uint32_t side_limit;
    /** Largest number of parts of a segment, or of a side of a triangle, 1 to 32; default 12. */
    uint32_t division_limit;
    uint32_t reserved; /**< Zero. */
    /** Tubes, tools and needles: largest deviation of chords from the centre line, and of polygons from
     * sections, m, 1e-8 to 1; default 5e-6. */
    double tube_tolerance;
    /** Drains: largest deviation of chords from curved sides of patches, m, 1e-8 to 1; default 2e-5. */
    double surface_tolerance;
    double mark_radius; /**< Radius of the marks of drains, m, 0 to 0.1; default 1e-3. */
    /** Length over which a needle tapers to its tip, m, 0 to 1; default 4e-3. At most half the needle's
     * length is used. */
    double tip_length;
    double floor_size; /**< Side of the square that shows a floor, m, 1e-3 to 1e3; default 0.3. */
    /** Point in the world that vertices are relative to, m, each at most 1e3; default 0. Choose it near the
     * bodies, because vertices have single precision (24 bits). The square of the floor is centred on it
     * too. */
    double origin[3];
} vbss_visual_config;

/** Kind of a part: a VBSS_VISUAL_KIND_ constant. */
typedef int32_t vbss_visual_kind;

/** The constants of #vbss_visual_kind. */
enum {
    VBSS_VISUAL_KIND_THREAD = 1, /**< A thread, or a piece of one. */
    VBSS_VISUAL_KIND_DRAIN = 2,  /**< A drain. */
    VBSS_VISUAL_KIND_NEEDLE = 3, /**< A needle. */
    VBSS_VISUAL_KIND_DRIVER = 4, /**< A grasper that is a needle driver. */
    VBSS_VISUAL_KIND_SHEARS = 5, /**< A grasper that is shears. */
    VBSS_VISUAL_KIND_RIGID = 6,  /**< Another rigid body of a scene: its capsules. */
    VBSS_VISUAL_KIND_FLOOR = 7   /**< The floor of a scene. */
};

/** Kind of a spot: a VBSS_VISUAL_SPOT_ constant. */
typedef int32_t vbss_visual_spot_kind;

/** The constants of #vbss_visual_spot_kind. */
enum {
    VBSS_VISUAL_SPOT_MARK = 1, /**< One of the two marks, on the outer face. */
    VBSS_VISUAL_SPOT_HOLE = 2  /**< A hole with a needle or a thread in it, through the wall. */
};

/** An array: a VBSS_VISUAL_VIEW_ constant. */
typedef int32_t vbss_visual_field;

/** The constants of #vbss_visual_field. */
enum {
    /** x 12 float: position, m from `origin`; unit normal, outward; texture; material; value.
     * *Texture*: on tubes and tools, 0 to 1 around the section, and m along; on drains, m along the tube, and
     * m around it from the middle of the slit before it was opened; on floors, m in the plane.
     * *Material*, x 3, m: position in the undeformed body. On drains it is the position at rest in the drain's
     * frame (VBSS_DRAIN_VIEW_REST_POSITIONS); on tubes and tools, along and across the axis; on floors, the texture
     * and 0.
     * *Value*: on threads, the tension, N; on drains, 1 on the outer face, -1 on the inner face, 0 on rims; on
     * graspers, 0 shaft, 1 neck, 2 jaws; else 0. */
    VBSS_VISUAL_VIEW_VERTICES = 0,
    VBSS_VISUAL_VIEW_TRIANGLES =
        1, /**< x 3 uint32_t: vertices, counter-clockwise seen from outside. */
    /** x 8 uint32_t: #vbss_visual_kind, source, number of the body in its scene or 0, first vertex, number of
     * vertices, first triangle, number of triangles, 0. Parts have the order of their sources, and within a
     * scene that of its bodies. */
    VBSS_VISUAL_VIEW_PARTS = 2,
    /** x 6 float: index of the drain in VBSS_VISUAL_VIEW_PARTS, #vbss_visual_spot_kind, material x 3, radius in m. */
    VBSS_VISUAL_VIEW_SPOTS = 3
};

/** Counts of the last update. */
typedef struct vbss_visual_statistics {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t sources;     /**< Scenes and bodies that the host has added. */
    uint32_t parts;       /**< Bodies drawn. */
    uint32_t vertices;    /**< Vertices of all parts. */
    uint32_t triangles;   /**< Triangles of all parts. */
    uint32_t spots;       /**< Marks and holes. */
    uint64_t updates;     /**< Calls of #vbss_visual_update that succeeded. */
} vbss_visual_statistics;

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
VBSS_API vbss_result vbss_visual_config_init(vbss_visual_config *config, uint32_t struct_size);

/**
 * Returns the default configuration that #vbss_visual_config_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_visual_config vbss_visual_config_default(void)
{
    vbss_visual_config vbss_filled;
    (void)vbss_visual_config_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Creates a visual without sources. Only this call allocates memory.
 *
 * @param context      owner
 * @param config       the configuration; NULL for the defaults
 * @param[out] visual  the new visual; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_visual_create(vbss_context *context, const vbss_visual_config *config,
                                        vbss_visual **visual);

/**
 * Destroys a visual. Scenes and bodies that it showed do not change.
 *
 * @param visual  the visual; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_visual_destroy(vbss_visual *visual);

/**
 * Shows a scene from the next update on: all its bodies, also bodies and pieces of threads added later, its
 * floor and its holes. A destroyed scene is no longer shown.
 *
 * @param visual       the visual
 * @param scene        a scene of the same context
 * @param[out] source  its number, from 1 on, never reused; may be NULL
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: a scene of another context),
 *         VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_visual_add_scene(vbss_visual *visual, vbss_scene *scene,
                                           uint32_t *source);

/**
 * Shows a replica (replica.h): the scene as it was when the state that the reader took last was
 * published. The replica belongs to the context of its scene, which may be another one than the
 * visual's. The thread that updates the visual must be the reader of the replica. A destroyed replica
 * is no longer shown; remove it before its context is destroyed.
 *
 * @param visual       the visual
 * @param replica      a replica of any context
 * @param[out] source  its number, from 1 on, never reused; may be NULL
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context of the visual, at the same time as any call on the context
 *          of the replica
 * @since 1.0
 */
VBSS_API vbss_result vbss_visual_add_replica(vbss_visual *visual, vbss_replica *replica,
                                             uint32_t *source);

/**
 * Shows a thread from the next update on, until it is removed from the visual or destroyed.
 *
 * @param visual       the visual
 * @param thread       a thread of the same context
 * @param[out] source  its number, from 1 on, never reused; may be NULL
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: a thread of another context),
 *         VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_visual_add_thread(vbss_visual *visual, vbss_thread *thread,
                                            uint32_t *source);

/**
 * Shows a drain from the next update on, without holes, until it is removed from the visual or destroyed.
 *
 * @param visual       the visual
 * @param drain        a drain of the same context
 * @param[out] source  its number, from 1 on, never reused; may be NULL
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: a drain of another context),
 *         VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_visual_add_drain(vbss_visual *visual, vbss_drain *drain,
                                           uint32_t *source);

/**
 * Shows a needle from the next update on, until it is removed from the visual or destroyed.
 *
 * @param visual       the visual
 * @param needle       a needle of the same context
 * @param[out] source  its number, from 1 on, never reused; may be NULL
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: a needle of another context),
 *         VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_visual_add_needle(vbss_visual *visual, vbss_needle *needle,
                                            uint32_t *source);

/**
 * Shows a grasper from the next update on, until it is removed from the visual or destroyed.
 *
 * @param visual       the visual
 * @param grasper      a grasper of the same context
 * @param[out] source  its number, from 1 on, never reused; may be NULL
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: a grasper of another context),
 *         VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_visual_add_grasper(vbss_visual *visual, vbss_grasper *grasper,
                                             uint32_t *source);

/**
 * Removes a scene or a body. It is not shown from the next update on.
 *
 * @param visual  the visual
 * @param source  number of the scene or the body in the visual
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FOUND (no such source) or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_visual_remove(vbss_visual *visual, uint32_t source);

/**
 * Computes the meshes of all sources in their current state. The call allocates nothing. Earlier
 * views keep their content until the update after this one. On failure the meshes do not change.
 *
 * @param visual  the visual
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_CAPACITY (the error text names it),
 *         VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY (also: another thread reads a replica that is
 *         shown)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_visual_update(vbss_visual *visual);

/**
 * Returns a view of one of the arrays of the last update.
 *
 * @param visual       the visual
 * @param field        the array
 * @param[out] view    receives the address and the shape of the array
 * @param struct_size  `sizeof *view` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such field)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_visual_get_view(vbss_visual *visual, vbss_visual_field field,
                                          vbss_view *view, uint32_t struct_size);

/**
 * Returns the counts of the last update.
 *
 * @param visual           the visual
 * @param[out] statistics  receives the numbers
 * @param struct_size      `sizeof *statistics` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_visual_get_statistics(vbss_visual *visual,
                                                vbss_visual_statistics *statistics,
                                                uint32_t struct_size);

#ifdef __cplusplus
}
#endif

#endif
