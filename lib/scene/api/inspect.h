/* Reads scenes and their bodies for the folders after scene: record, visual and session.
 *
 * Except for base, they include no other private header of scene or of the modules below it;
 * gate.layers checks that. Each function fills a plain struct and changes nothing. Arrays are not
 * copied: a pointer in a struct is valid until the next step or edit of the scene or body. A handle
 * must be valid unless the function returns a vbss_result.
 *
 * Units are SI. Points and vectors are in world coordinates unless the comment names another frame.
 * A body number is the number that hosts use; 0 means no body. */
#ifndef VBSS_SCENE_INSPECT_H
#define VBSS_SCENE_INSPECT_H

#include <vblast_ss/scene.h>

#include "base/edit_hook.h"
#include "base/linear.h"
#include "base/slot.h"

/* No node, triangle or edge of a drain. */
#define SCENE_INSPECT_NONE UINT32_MAX
/* Kinds of logged events: lost time; more events than there is room for. Chosen with the format of logs. */
enum { SCENE_INSPECT_TIME_LOST = 3, SCENE_INSPECT_LOST = 4 };

/* ---- handles */

typedef enum scene_handle_type {
    SCENE_HANDLE_SCENE,
    SCENE_HANDLE_THREAD,
    SCENE_HANDLE_DRAIN,
    SCENE_HANDLE_NEEDLE,
    SCENE_HANDLE_GRASPER
} scene_handle_type;

/* Finds the slot of a handle. VBSS_ERROR_INVALID_HANDLE if no living object of the type has it. */
vbss_result vbss_scene_inspect_handle(scene_handle_type type, const void *handle, vbss_slot **slot);

/* ---- a scene */

typedef struct scene_info {
    vbss_context *context;
    const vbss_scene_config *config;
    vec3 floor_normal;    /* unit */
    uint64_t steps;       /* calls of vbss_scene_step that succeeded */
    double time;          /* simulated time, s */
    uint32_t entry_count; /* entries in the table of bodies, for vbss_scene_inspect_entry */
    uint32_t event_count; /* events of the last call, as logs store them */
    /* Kind, two bodies, and a number that depends on the kind (record.h). Callers must not change
     * them; they are not const because streams take no const pointers. */
    uint32_t (*events)[4];
} scene_info;

/* Reads a scene. VBSS_ERROR_INVALID_HANDLE if it was destroyed. */
vbss_result vbss_scene_inspect(const vbss_scene *scene, scene_info *info);
/* Reads a scene that the caller will change. VBSS_ERROR_INVALID_HANDLE, or VBSS_ERROR_BUSY inside a
 * callback of the context. */
vbss_result vbss_scene_inspect_for_edit(vbss_scene *scene, scene_info *info);

/* Visits the configuration of a scene, its parameters of the baseline and its options of the solver;
 * scene/snapshot/config_fields.c has the versions. */
void vbss_scene_inspect_visit_config(vbss_stream *stream, vbss_scene_config *config,
                                     vbss_baseline_config *baseline, vbss_solver_options *solver);
/* Name of a field that keeps two scenes from accepting each other's states, or NULL. Both configurations
 * point to their parameters of the baseline and options of the solver. */
const char *vbss_scene_inspect_config_difference(const vbss_scene_config *a,
                                                 const vbss_scene_config *b);

/* Simulated time that a step of length `h` lost, by its events, s: truncated and paused parts have kind 3
 * and a share in 65536ths. The events are not const for the reason given above. */
static inline double vbss_scene_inspect_lost_time(uint32_t (*events)[4], uint32_t count, double h)
{
    double lost = 0.0;
    for (uint32_t i = 0; i < count; i++) {
        lost += events[i][0] == SCENE_INSPECT_TIME_LOST ? h * events[i][3] / 65536.0 : 0.0;
    }
    return lost;
}

/* Edit counts of a scene and of all its bodies, summed per kind. Any change of the scene or of a
 * body in it increases at least one of them. */
typedef struct scene_edit_counts {
    uint64_t scene, threads, graspers, drains;
} scene_edit_counts;
scene_edit_counts vbss_scene_inspect_edits(const vbss_scene *scene);

/* Loads a scene from its bytes into an existing handle. The bodies of before leave the scene, as when
 * it is destroyed. Returns the errors of vbss_scene_load; the scene is then unchanged. */
vbss_result vbss_scene_inspect_reload(vbss_scene *scene, const uint8_t *bytes, uint64_t count);

/* Who hears of the edits of the scene; NULL if the scene was destroyed. Callers change the data and
 * the functions, but not the depth. */
vbss_edit_hook *vbss_scene_inspect_hook(const vbss_scene *scene);

/* ---- bodies of a scene */

/* A body of a scene. At most one of its handles is not NULL. All are NULL for a rigid body that is
 * neither a needle nor a grasper. */
typedef struct scene_body_info {
    uint32_t number; /* 0: there is no such body, and all other fields are zero */
    vbss_thread *thread;
    vbss_drain *drain;
    vbss_needle *needle;
    vbss_grasper *grasper;
    uint32_t first_capsule, capsule_count; /* rigid bodies: its range of capsules */
    pose pose;                             /* rigid bodies: principal frame, body to world */
    pose host_pose;                        /* rigid bodies: the frame that hosts see, to world */
} scene_body_info;
/* Reads the body with a number; the number may be one that no body has. */
scene_body_info vbss_scene_inspect_body(const vbss_scene *scene, uint32_t number);
/* Number of the body that has a handle; 0: no body has it. */
uint32_t vbss_scene_inspect_number(const vbss_scene *scene, const void *handle);
/* Reads the body at an entry of the table of bodies, 0 to entry_count - 1. */
scene_body_info vbss_scene_inspect_entry(const vbss_scene *scene, uint32_t entry);

typedef struct scene_capsule_info {
    vec3 axis[2];  /* ends of the axis, m */
    double radius; /* m */
} scene_capsule_info;
/* Reads a capsule of a rigid body, 0 to capsule_count - 1, in world coordinates. */
scene_capsule_info vbss_scene_inspect_capsule(const vbss_scene *scene, const scene_body_info *body,
                                              uint32_t index);

/* ---- contacts, holes and grasps of a scene */

/* The arrays of the contact views. */
typedef struct scene_contacts_info {
    uint32_t count;
    const uint32_t (*features)[5];
    const vec3 *points, *normals, *forces; /* m; unit; N */
    const double *gaps;                    /* m */
} scene_contacts_info;
scene_contacts_info vbss_scene_inspect_contacts(const vbss_scene *scene);

typedef struct scene_hole_info {
    uint32_t id;             /* ascending in the order of creation; 0: the entry is free */
    uint32_t needle, thread; /* number of the body in the hole; the other one is 0 */
    uint32_t drain;          /* number of the drain */
    double arc_length;       /* from the needle's tip or the thread's first node to the hole, m */
    double radius;           /* of the body in the hole, m; 0: that body has left the scene */
    vec3 position;           /* on the middle surface of the drain, m */
    vec3 rest_position;      /* the same material point at rest, in the drain's frame, m */
} scene_hole_info;
/* Reads the hole at an entry of the table of holes, 0 to hole_capacity - 1. */
scene_hole_info vbss_scene_inspect_hole(const vbss_scene *scene, uint32_t entry);

typedef struct scene_grasp_info {
    uint32_t tool, thread; /* body numbers; tool 0: the entry is free or released */
    double arc_length;     /* from the first node to the middle of the grasp, at rest, m */
} scene_grasp_info;
/* Reads the thread grasp at an entry of the table of grasps, 0 to grasp_capacity - 1. */
scene_grasp_info vbss_scene_inspect_grasp(const vbss_scene *scene, uint32_t entry);

/* ---- bodies by their handles; they may be in a scene or not */

typedef struct scene_thread_info {
    bool is_guarded; /* CCD keeps the thread from passing through bodies */
    uint32_t node_count, node_capacity;
    double radius, length;      /* radius; length at rest; m */
    const vec3 *positions;      /* one per node, m */
    const double *rest_lengths; /* one per segment, m */
    const double *tensions;     /* one per segment, N */
} scene_thread_info;
scene_thread_info vbss_scene_inspect_thread(const vbss_thread *thread);

typedef struct scene_drain_info {
    bool is_surface;          /* the walls have no thickness; a gap is measured between edges */
    double radius, thickness; /* of the tube's middle surface; of its wall; m */
    vec3 centre;              /* of the tube, m */
    quat orientation;         /* of the drain's frame, body to world */
    uint32_t node_count, triangle_count, edge_count;
    uint32_t anchor_count, torn_anchor_count;
    double anchor_load; /* the largest in the last step, relative to the strength of its anchor */
    uint32_t marks[2];  /* nodes, left and right, or SCENE_INSPECT_NONE */
    uint32_t slit_middle[2];    /* nodes in the middle of the edges of the slit, left and right */
    const vec3 *positions;      /* one per node, m */
    const vec3 *rest_positions; /* one per node, in the drain's frame, m */
    const double (*material_coordinates)[2]; /* per node: arc length from the top, and x; m */
    const uint32_t (*triangles)[3];          /* nodes, counter-clockwise as seen from outside */
    /* Two nodes and two triangles. The first triangle has the edge in the direction from the first
     * node to the second. The second one is SCENE_INSPECT_NONE at a free edge. */
    const uint32_t (*edges)[4];
    /* Linked lists of the edges of which a node is the lower one. Per node: the first edge. Per
     * edge: the next one. SCENE_INSPECT_NONE ends a list. */
    const uint32_t *first_edge, *next_edge;
} scene_drain_info;
scene_drain_info vbss_scene_inspect_drain(const vbss_drain *drain);

typedef struct scene_needle_info {
    double wire_radius, arc_radius, length; /* m; the length is that of the middle line */
    double arc;                             /* angle from tip to swage, rad */
    pose pose;                              /* frame of the needle, body to world */
} scene_needle_info;
scene_needle_info vbss_scene_inspect_needle(const vbss_needle *needle);

typedef struct scene_line_point {
    vec3 position, direction; /* m; unit, toward the tip */
} scene_line_point;
/* Computes the point of the middle line at an arc length from the tip, m, in the needle's frame. */
scene_line_point vbss_scene_inspect_needle_point(const scene_needle_info *needle,
                                                 double arc_length);

typedef struct scene_grasper_info {
    vbss_grasper_kind kind;
    double jaw_angle;                        /* of each jaw from the middle, rad */
    pose pose;                               /* frame of the tool, tool to world */
    vec3 forward;                            /* direction of the jaws in the tool's frame, unit */
    scene_capsule_info shaft, jaws[2], neck; /* in the tool's frame; the first jaw is that at +x */
} scene_grasper_info;
/* Reads a grasper and computes its capsules from the jaw angle. */
scene_grasper_info vbss_scene_inspect_grasper(const vbss_grasper *grasper);

/* ---- the geometry of a body: all that is drawn of it */

typedef enum scene_geometry_type {
    SCENE_GEOMETRY_CAPSULES = 0, /* another rigid body: its capsules, which are not part of this */
    SCENE_GEOMETRY_THREAD,
    SCENE_GEOMETRY_DRAIN,
    SCENE_GEOMETRY_NEEDLE,
    SCENE_GEOMETRY_GRASPER
} scene_geometry_type;

typedef struct scene_geometry {
    scene_geometry_type type;
    /* The handle of the body, which no other body of the context ever has. It is compared only, so
     * the body need not exist any more. */
    const void *identity;
    union { /* `type` says which one is in use */
        scene_thread_info thread;
        scene_drain_info drain;
        scene_needle_info needle;
        scene_grasper_info grasper;
    };
} scene_geometry;
/* Reads the geometry of a body by its handle. */
scene_geometry vbss_scene_inspect_geometry(const scene_body_info *body);

#endif
