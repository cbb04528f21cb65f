/**
 * @file scene_query.h
 * @brief Bodies of a scene by number, data of the host for them, rays and nearest bodies.
 *
 * No function here changes the state of a scene. Rays and nearest bodies use the surfaces where
 * they are after the last step: rounded segments of threads, capsules, walls of drains with their
 * thickness, and the floor. They compare with every feature of every body, so their time grows with
 * the number of features.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_SCENE_QUERY_H
#define VBLAST_SS_SCENE_QUERY_H

#include <vblast_ss/base.h>
#include <vblast_ss/scene.h>

/** Kind of a body: a VBSS_SCENE_BODY_ constant. */
typedef int32_t vbss_scene_body_kind;

/** The constants of #vbss_scene_body_kind. */
enum {
    VBSS_SCENE_BODY_THREAD = 1,      /**< A thread. */
    VBSS_SCENE_BODY_DRAIN = 2,       /**< A drain. */
    VBSS_SCENE_BODY_RIGID = 3,       /**< A rigid body that is neither a needle nor a grasper. */
    VBSS_SCENE_BODY_NEEDLE = 4,      /**< A needle. */
    VBSS_SCENE_BODY_GRASPER = 5,     /**< A grasper. */
    VBSS_SCENE_BODY_FLOOR = 6,       /**< The floor, body 0. */
    VBSS_SCENE_BODY_STATIC_MESH = 7, /**< A static mesh. */
    VBSS_SCENE_BODY_SURFACE = 8,     /**< A host surface (scene_surface.h). */
    VBSS_SCENE_BODY_PLANE = 9        /**< A plane that the host added. */
};

/** Properties of a body in a scene. */
typedef struct vbss_scene_body_info {
    uint32_t struct_size;      /**< Bytes of this struct that the library filled. */
    uint32_t body;             /**< Number of the body. */
    vbss_scene_body_kind kind; /**< Kind of the body. */
    /** Kind of motion of rigid bodies, needles and graspers; 0 for other bodies. */
    vbss_scene_rigid_kind motion;
    uint32_t category; /**< Categories of its contact filter (#vbss_scene_set_filter). */
    uint32_t mask;     /**< Mask of its contact filter. */
    double friction;   /**< Coefficient of friction. For a thread, the one between threads. */
    double gravity[3]; /**< Gravitational acceleration, m/s^2; 0 for the floor. */
} vbss_scene_body_info;

/** First surface that a ray hits. */
typedef struct vbss_scene_ray_hit {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t is_hit;      /**< 1: the ray hits something; 0: all other fields are 0. */
    uint32_t body;        /**< Number of the body; 0: the floor. */
    uint32_t feature;     /**< Segment, capsule or triangle of the body; 0 for the floor. */
    double fraction;      /**< Place on the ray, 0 at its origin to 1 at its end. */
    double point[3];      /**< Point on the surface, m. */
    double normal[3];     /**< Outward unit normal of the surface there. */
} vbss_scene_ray_hit;

/** Body nearest to a point. */
typedef struct vbss_scene_nearest {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t is_found;    /**< 1: a surface is within the radius; 0: all other fields are 0. */
    uint32_t body;        /**< Number of the body; 0: the floor. */
    uint32_t feature;     /**< Segment, capsule or triangle of the body; 0 for the floor. */
    double distance;      /**< Distance of its surface, m; negative inside the body. */
    double point[3];      /**< Nearest point of that surface, m. */
    double normal[3];     /**< Outward unit normal of the surface there. */
} vbss_scene_nearest;

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Lists the numbers of all bodies of a scene in ascending order.
 *
 * @param scene         the scene
 * @param[out] numbers  receives the numbers; NULL with capacity 0 asks for their count
 * @param capacity      room in `numbers`
 * @param[out] count    number of bodies, also when they do not fit
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_get_bodies(vbss_scene *scene, uint32_t *numbers, uint32_t capacity,
                                           uint32_t *count);

/**
 * Returns the properties of a body.
 *
 * @param scene        the scene
 * @param body         its number; 0: the floor
 * @param[out] info    receives the properties
 * @param struct_size  `sizeof *info` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_NOT_FOUND (no such body)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_get_body(vbss_scene *scene, uint32_t body,
                                         vbss_scene_body_info *info, uint32_t struct_size);

/**
 * Returns the handle of a drain in the scene.
 *
 * @param scene       the scene
 * @param body        number of the drain in the scene
 * @param[out] drain  its handle; NULL when there is no such drain
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
 *         such body) or VBSS_ERROR_INCOMPATIBLE (no drain)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_get_drain(vbss_scene *scene, uint32_t body, vbss_drain **drain);

/**
 * Returns the handle of a needle in the scene.
 *
 * @param scene        the scene
 * @param body         number of the needle in the scene
 * @param[out] needle  its handle; NULL when there is no such needle
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
 *         such body) or VBSS_ERROR_INCOMPATIBLE (no needle)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_get_needle(vbss_scene *scene, uint32_t body, vbss_needle **needle);

/**
 * Returns the handle of a grasper in the scene.
 *
 * @param scene         the scene
 * @param body          number of the grasper in the scene
 * @param[out] grasper  its handle; NULL when there is no such grasper
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
 *         such body) or VBSS_ERROR_INCOMPATIBLE (no grasper)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_get_grasper(vbss_scene *scene, uint32_t body,
                                            vbss_grasper **grasper);

/**
 * Stores a pointer of the host with a body. The library never follows it. It is no part of the
 * state: snapshots and logs do not contain it, and #vbss_scene_restore leaves it. A new body and a
 * piece that is cut from a thread have NULL.
 *
 * @param scene  the scene
 * @param body   number of a body, not 0
 * @param data   the pointer, or an integer of its size; may be NULL
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FOUND (no such body) or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_set_user_data(vbss_scene *scene, uint32_t body, void *data);

/**
 * Returns the pointer that the host has stored with a body.
 *
 * @param scene      the scene
 * @param body       number of a body, not 0
 * @param[out] data  receives the pointer; NULL if none was stored, and on failure
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_NOT_FOUND
 *         (no such body)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_get_user_data(vbss_scene *scene, uint32_t body, void **data);

/**
 * Finds the first surface that a ray hits. A ray that begins inside a body hits it at fraction 0.
 *
 * @param scene        the scene
 * @param origin       where the ray begins, m, each coordinate at most 1e3 in magnitude
 * @param translation  vector from there to its end, m, each component at most 1e4 in magnitude, not
 *         zero
 * @param mask         categories of bodies that count (#vbss_scene_set_filter); 0xffffffff: all
 * @param[out] hit     receives the hit
 * @param struct_size  `sizeof *hit` as the caller was compiled
 * @return VBSS_OK (also without a hit), VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT,
 *         VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_NOT_FINITE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_cast_ray(vbss_scene *scene, const double origin[3],
                                         const double translation[3], uint32_t mask,
                                         vbss_scene_ray_hit *hit, uint32_t struct_size);

/**
 * Finds the body whose surface is nearest to a point, within a radius. Inside several bodies it is
 * the one with the deepest surface.
 *
 * @param scene         the scene
 * @param point         the point, m, each coordinate at most 1e3 in magnitude
 * @param radius        largest distance, m, 0 to 1e4
 * @param mask          categories of bodies that count (#vbss_scene_set_filter); 0xffffffff: all
 * @param[out] nearest  receives the body
 * @param struct_size   `sizeof *nearest` as the caller was compiled
 * @return VBSS_OK (also without such a body), VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT,
 *         VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_NOT_FINITE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_find_nearest(vbss_scene *scene, const double point[3],
                                             double radius, uint32_t mask,
                                             vbss_scene_nearest *nearest, uint32_t struct_size);

#ifdef __cplusplus
}
#endif

#endif
