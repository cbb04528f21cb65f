/* What the folders after scene (record, visual, session) read of a scene and its bodies. It is the only private header of scene
 * and of the modules below it that they include; gate.layers checks that.
 *
 * Each function fills a plain struct. Arrays are not copied: a pointer in a struct is valid until the next step or edit of the
 * scene or the body. No function changes anything. A handle must be valid unless the function returns a vbss_result. */
#ifndef VBSS_SCENE_INSPECT_H
#define VBSS_SCENE_INSPECT_H

#include <vblast_ss/scene.h>

#include "base/linear.h"
#include "base/slot.h"

/* No node, triangle or edge of a drain. */
#define SCENE_INSPECT_NONE UINT32_MAX

/* ---- handles */

typedef enum scene_handle_type {
    SCENE_HANDLE_SCENE,
    SCENE_HANDLE_THREAD,
    SCENE_HANDLE_DRAIN,
    SCENE_HANDLE_NEEDLE,
    SCENE_HANDLE_GRASPER
} scene_handle_type;

/* Finds the slot of a valid handle of that type; otherwise VBSS_ERROR_INVALID_HANDLE. */
vbss_result vbss_scene_inspect_handle(scene_handle_type type, const void *handle, vbss_slot **slot);

/* ---- a scene */

typedef struct scene_info {
    vbss_context *context;
    const vbss_scene_config *config;
    vec3 floor_normal;    /* unit */
    uint64_t steps;       /* calls of vbss_scene_step that succeeded */
    uint32_t entry_count; /* for vbss_scene_inspect_entry */
    uint32_t event_count; /* events that the last step emitted */
    /* The items of VBSS_SCENE_VIEW_EVENTS. They are not const because streams take none; callers only read them. */
    uint32_t (*events)[4];
} scene_info;

/* VBSS_ERROR_INVALID_HANDLE if the scene was destroyed. */
vbss_result vbss_scene_inspect(const vbss_scene *scene, scene_info *info);
/* For a caller that will change the scene: also VBSS_ERROR_BUSY inside a callback of the context. */
vbss_result vbss_scene_inspect_for_edit(vbss_scene *scene, scene_info *info);

/* Any change of a scene or of a body in it raises one of these sums. */
typedef struct scene_edit_counts {
    uint64_t scene, threads, graspers, drains;
} scene_edit_counts;
scene_edit_counts vbss_scene_inspect_edits(const vbss_scene *scene);

/* ---- bodies of a scene */

/* At most one handle is not NULL; all four are NULL for a body that consists of capsules only. */
typedef struct scene_body_info {
    uint32_t number; /* 0: there is no such body, and all other fields are zero */
    vbss_thread *thread;
    vbss_drain *drain;
    vbss_needle *needle;
    vbss_grasper *grasper;
    uint32_t first_capsule, capsule_count; /* only if the body is rigid */
    pose pose; /* rigid bodies: centre of mass and principal axes, body to world */
} scene_body_info;
scene_body_info vbss_scene_inspect_body(const vbss_scene *scene, uint32_t number);
/* The body at an entry of the scene's table, 0 to entry_count - 1. */
scene_body_info vbss_scene_inspect_entry(const vbss_scene *scene, uint32_t entry);

typedef struct scene_capsule_info {
    vec3 axis[2]; /* ends of the axis */
    double radius;
} scene_capsule_info;
/* A capsule of a rigid body, 0 to capsule_count - 1, in the world. */
scene_capsule_info vbss_scene_inspect_capsule(const vbss_scene *scene, const scene_body_info *body,
                                              uint32_t index);

/* ---- holes and grasps of a scene */

typedef struct scene_hole_info {
    uint32_t id;             /* ascending in the order of creation; 0: the entry is free */
    uint32_t needle, thread; /* number of the body in the hole; the other is 0 */
    uint32_t drain;          /* number */
    double arc_length; /* position of the hole along that body, from the tip or the first node, m */
    double radius;     /* half the thickness of that body, m; 0: it has left the scene */
    vec3 position;     /* on the middle surface of the drain */
    vec3 rest_position; /* the same point of the drain at rest */
} scene_hole_info;
/* The hole at an entry of the scene's table, 0 to hole_capacity - 1. */
scene_hole_info vbss_scene_inspect_hole(const vbss_scene *scene, uint32_t entry);

typedef struct scene_grasp_info {
    uint32_t tool, thread; /* numbers; tool 0: no tool holds a thread here */
    double arc_length;     /* middle of the grasp along the thread, from the first node, m */
} scene_grasp_info;
/* The grasp of a thread at an entry of the scene's table, 0 to grasp_capacity - 1. */
scene_grasp_info vbss_scene_inspect_grasp(const vbss_scene *scene, uint32_t entry);

/* ---- bodies by their handles, in a scene or alone */

typedef struct scene_thread_info {
    vbss_method method;
    uint32_t node_count, node_capacity;
    double radius, length;      /* m; the length is that at rest */
    const vec3 *positions;      /* one per node */
    const double *rest_lengths; /* one per segment, m */
    const double *tensions;     /* one per segment, N */
} scene_thread_info;
scene_thread_info vbss_scene_inspect_thread(const vbss_thread *thread);

typedef struct scene_drain_info {
    vbss_method method;
    double radius, thickness; /* radius: the tube's middle surface; thickness: its wall, m */
    vec3 centre;              /* the tube's centre in the world */
    uint32_t node_count, triangle_count, edge_count;
    uint32_t anchor_count, torn_anchor_count;
    uint32_t marks[2];          /* nodes, left and right, or SCENE_INSPECT_NONE */
    uint32_t slit_middle[2];    /* nodes at the middle of the slit's edges, left and right */
    const vec3 *positions;      /* one per node, in the world */
    const vec3 *rest_positions; /* one per node, in the drain's frame */
    const double (*material_coordinates)[2]; /* per node: arc from the top, and x, m */
    const uint32_t (*triangles)[3];          /* nodes, counter-clockwise seen from outside */
    /* Two nodes and two triangles; the first triangle runs from the first node to the second. The second triangle is
     * SCENE_INSPECT_NONE at a free edge. */
    const uint32_t (*edges)[4];
    /* The edges of which a node is the lower one: the first per node, the next per edge. */
    const uint32_t *first_edge, *next_edge;
} scene_drain_info;
scene_drain_info vbss_scene_inspect_drain(const vbss_drain *drain);

typedef struct scene_needle_info {
    double wire_radius, arc_radius, length; /* the length is that of the middle line, m */
    pose pose;                              /* the needle's frame, body to world */
} scene_needle_info;
scene_needle_info vbss_scene_inspect_needle(const vbss_needle *needle);

typedef struct scene_line_point {
    vec3 position, direction; /* direction: unit, toward the tip */
} scene_line_point;
/* Computes a point of the needle's middle line, in the needle's frame, from the arc length behind the tip, m. */
scene_line_point vbss_scene_inspect_needle_point(const vbss_needle *needle, double arc_length);

typedef struct scene_grasper_info {
    vbss_grasper_kind kind;
    pose pose;    /* the tool's frame, tool to world */
    vec3 forward; /* unit: where the jaws point, in the tool's frame */
    scene_capsule_info shaft, jaws[2],
        neck; /* in the tool's frame; the first jaw is the one at +x */
} scene_grasper_info;
/* Computes the capsules from the angle of the jaws. */
scene_grasper_info vbss_scene_inspect_grasper(const vbss_grasper *grasper);

#endif
