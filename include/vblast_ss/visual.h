/**
 * @file visual.h
 * @brief Meshes to draw: smooth surfaces that follow threads, drains, needles, graspers and what else is in a scene.
 *
 * A visual is told what to show (a scene with all that is in it, or bodies that are alone), and writes, once a frame,
 * vertices and triangles of it into buffers that a renderer can take as they are. It needs no graphics library and changes
 * nothing of what it shows.
 *
 * - A thread becomes a round tube about the interpolating cubic spline through its nodes, with frames that do not turn about
 *   it (Wang, Juettler, Zheng and Liu 2008) and rounded ends. Pieces of a thread that was cut in a scene are parts of their own.
 * - A drain becomes a wall with two faces and rims, also at the lips of its slit, half its thickness to either side of
 *   curved patches through its nodes (Vlachos et al. 2001). Its marks and holes are *spots*: places of the drain at rest, which a
 *   renderer finds again in each vertex's `material`.
 * - A needle becomes a wire with a tip, a grasper a shaft, a neck and two jaws, a floor a square.
 *
 * How fine they are follows from tolerances. Surfaces of bodies are closed: each side belongs to two triangles, which run
 * along it in opposite directions, where vertices at the same place count as one. docs/visual.md has formulas and figures.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_VISUAL_H
#define VBLAST_SS_VISUAL_H

#include <vblast_ss/base.h>
#include <vblast_ss/drain.h>
#include <vblast_ss/grasper.h>
#include <vblast_ss/needle.h>
#include <vblast_ss/scene.h>
#include <vblast_ss/thread.h>

/** Meshes of what is shown. */
typedef struct vbss_visual vbss_visual;

/** How to make a visual. Fill it with #vbss_visual_config_init, then change what you need. */
typedef struct vbss_visual_config {
    uint32_t struct_size;     /**< Size of this struct in bytes, set by the init function. */
    uint32_t source_capacity; /**< Scenes and bodies that are shown, 1 to 256; default 8. */
    uint32_t part_capacity;   /**< Bodies that are drawn, 1 to 4096; default 32. */
    uint32_t
        vertex_capacity; /**< Vertices, 16 to 2^24; default 65536. Room for two such meshes is taken. */
    uint32_t triangle_capacity; /**< Triangles, 16 to 2^24; default 131072. */
    uint32_t spot_capacity;     /**< Marks and holes, 0 to 4096; default 32. */
    uint32_t
        node_capacity; /**< Nodes of the longest thread or the largest drain, 2 to 65537; default 4096. */
    uint32_t side_limit; /**< Sides of a tube's section are 6 to this many; 6 to 64; default 32. */
    uint32_t
        division_limit; /**< A segment, or a side of a triangle, is divided into so many at most, 1 to 32; default 12. */
    uint32_t reserved; /**< Zero. */
    /** Of tubes, tools and needles: between middle line and chords, and between sections and their polygons, m, 1e-8 to 1;
     * default 5e-6. */
    double tube_tolerance;
    double
        surface_tolerance; /**< Of drains: between curved sides of patches and chords, m, 1e-8 to 1; default 2e-5. */
    double mark_radius; /**< Of the marks of drains, m, 0 to 0.1; default 1e-3. */
    double
        tip_length; /**< Over which a needle becomes thin, m, 0 to 1; default 4e-3. Half its length at most. */
    double floor_size; /**< Side of the square that shows a floor, m, 1e-3 to 1e3; default 0.3. */
    /** Place in the world, m, each at most 1e3, from which vertices count: choose it where things happen, as they are
     * single numbers of 24 bits. The floor's square is round it too. Default 0. */
    double origin[3];
} vbss_visual_config;

/** What a part shows: a VBSS_VISUAL_ constant. */
typedef int32_t vbss_visual_kind;

/** The constants of #vbss_visual_kind. */
enum {
    VBSS_VISUAL_THREAD = 1, /**< A thread, or a piece of one. */
    VBSS_VISUAL_DRAIN = 2,  /**< A drain. */
    VBSS_VISUAL_NEEDLE = 3, /**< A needle. */
    VBSS_VISUAL_DRIVER = 4, /**< A grasper that is a needle driver. */
    VBSS_VISUAL_SHEARS = 5, /**< A grasper that is shears. */
    VBSS_VISUAL_RIGID = 6,  /**< Another rigid body of a scene: its capsules. */
    VBSS_VISUAL_FLOOR = 7   /**< The floor of a scene. */
};

/** What a spot is: a VBSS_SPOT_ constant. */
typedef int32_t vbss_spot_kind;

/** The constants of #vbss_spot_kind. */
enum {
    VBSS_SPOT_MARK = 1, /**< One of the two marks, on the outer face. */
    VBSS_SPOT_HOLE = 2  /**< A hole with a needle or a thread in it, through the wall. */
};

/** Arrays to look at: a VBSS_VISUAL_VIEW_ constant. */
typedef int32_t vbss_visual_field;

/** The constants of #vbss_visual_field. */
enum {
    /** x 12 float: position, m from `origin`; unit normal, outward; texture; material; value.
     * *Texture*: of tubes and tools 0 to 1 once round, and m along; of drains m along the tube, and m from the middle of the slit
     * round it, before the slit was opened; of floors m in its plane.
     * *Material*, x 3, m: where this matter is in the body as it was made: of drains at rest in the drain's frame
     * (VBSS_DRAIN_REST_POSITIONS); of tubes and tools along their axis and across it; of floors as texture, and 0.
     * *Value*: of threads the tension, N; of drains 1 on the outer face, -1 on the inner one, 0 on rims; of graspers 0 shaft,
     * 1 neck, 2 jaws; else 0. */
    VBSS_VISUAL_VIEW_VERTICES = 0,
    VBSS_VISUAL_VIEW_TRIANGLES =
        1, /**< x 3 uint32_t: vertices, counter-clockwise seen from outside. */
    /** x 8 uint32_t: #vbss_visual_kind, source, number of the body in its scene or 0, first vertex, number of vertices, first
     * triangle, number of triangles, 0. In the order of sources, in a scene in that of places of bodies. */
    VBSS_VISUAL_VIEW_PARTS = 2,
    /** x 6 float: place in VBSS_VISUAL_VIEW_PARTS of the drain, #vbss_spot_kind, material x 3, radius in m. */
    VBSS_VISUAL_VIEW_SPOTS = 3
};

/** What the last update made. */
typedef struct vbss_visual_statistics {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t sources;     /**< Scenes and bodies that it was told to show. */
    uint32_t parts;       /**< Bodies drawn. */
    uint32_t vertices;    /**< Of all parts. */
    uint32_t triangles;   /**< Of all parts. */
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
 * @since 0.1
 */
VBSS_API vbss_result vbss_visual_config_init(vbss_visual_config *config, uint32_t struct_size);

/**
 * Creates a visual that shows nothing yet. All memory is taken here.
 *
 * @param context      owner
 * @param config       how; NULL for the defaults
 * @param[out] visual  the new visual; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_visual_create(vbss_context *context, const vbss_visual_config *config,
                                        vbss_visual **visual);

/**
 * Destroys a visual. What it showed stays as it is.
 *
 * @param visual  the visual; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_visual_destroy(vbss_visual *visual);

/**
 * Shows a scene from the next update on: all bodies that are in it then, pieces cut from threads and bodies added later too, its
 * floor and its holes. Once it is destroyed, nothing of it is shown.
 *
 * @param visual       the visual
 * @param scene        a scene of the same context
 * @param[out] source  its number, from 1 on, never used again; may be NULL
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: of another context), VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_visual_add_scene(vbss_visual *visual, vbss_scene *scene,
                                           uint32_t *source);

/**
 * Shows a thread from the next update on, until it is removed from the visual or destroyed.
 *
 * @param visual       the visual
 * @param thread       a thread of the same context
 * @param[out] source  its number, from 1 on, never used again; may be NULL
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: of another context), VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_visual_add_thread(vbss_visual *visual, vbss_thread *thread,
                                            uint32_t *source);

/**
 * Shows a drain from the next update on, without holes, until it is removed from the visual or destroyed.
 *
 * @param visual       the visual
 * @param drain        a drain of the same context
 * @param[out] source  its number, from 1 on, never used again; may be NULL
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: of another context), VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_visual_add_drain(vbss_visual *visual, vbss_drain *drain,
                                           uint32_t *source);

/**
 * Shows a needle from the next update on, until it is removed from the visual or destroyed.
 *
 * @param visual       the visual
 * @param needle       a needle of the same context
 * @param[out] source  its number, from 1 on, never used again; may be NULL
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: of another context), VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_visual_add_needle(vbss_visual *visual, vbss_needle *needle,
                                            uint32_t *source);

/**
 * Shows a grasper from the next update on, until it is removed from the visual or destroyed.
 *
 * @param visual       the visual
 * @param grasper      a grasper of the same context
 * @param[out] source  its number, from 1 on, never used again; may be NULL
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: of another context), VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_visual_add_grasper(vbss_visual *visual, vbss_grasper *grasper,
                                             uint32_t *source);

/**
 * Shows it no more from the next update on.
 *
 * @param visual  the visual
 * @param source  number of a scene or body that it was told to show
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE (no such source) or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_visual_remove(vbss_visual *visual, uint32_t source);

/**
 * Makes the meshes of all that is shown as it is now. Nothing is allocated. Views of before stay as they are until the update
 * after this one. On failure the meshes are those of before.
 *
 * @param visual  the visual
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_CAPACITY (which, says the error text), VBSS_ERROR_ARITHMETIC_MODE or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_visual_update(vbss_visual *visual);

/**
 * A look at one of the arrays of the last update.
 *
 * @param visual       the visual
 * @param field        which
 * @param[out] view    receives where the array is
 * @param struct_size  `sizeof *view` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such field)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_visual_get_view(vbss_visual *visual, vbss_visual_field field,
                                          vbss_view *view, uint32_t struct_size);

/**
 * What the last update made.
 *
 * @param visual           the visual
 * @param[out] statistics  receives the numbers
 * @param struct_size      `sizeof *statistics` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_visual_get_statistics(vbss_visual *visual,
                                                vbss_visual_statistics *statistics,
                                                uint32_t struct_size);

#ifdef __cplusplus
}
#endif

#endif
