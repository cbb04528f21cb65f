/* A mesh that adapts itself, shared by remesh_criteria.c (what is wanted where), remesh.c (a node comes or goes),
 * remesh_window.c (what its neighbours do then) and by scenes, which know what is near. docs/adaptive.md. */
#ifndef VBSS_THREAD_REMESH_H
#define VBSS_THREAD_REMESH_H

#include "thread/thread.h"

static inline bool thread_is_adaptive(const thread_object *t)
{
    return t->config.mesh == VBSS_MESH_ADAPTIVE;
}

/* ---- what is wanted (remesh_criteria.c) */

/* Segments that are looked at after a step. */
enum { REMESH_CHECKS_PER_STEP = 32 };
/* Neighbouring lengths differ by this at most; and rounding. */
#define REMESH_MAX_LENGTH_RATIO (2.0 * (1.0 + 1e-9))
/* Up to so much longer than wanted is good enough: halves of what is a little too long would be twice too fine. */
#define REMESH_LENGTH_TOLERANCE 1.25

/* |curvature| at a node; 0 at free ends. */
double vbss_thread_node_curvature(const thread_object *t, uint32_t node);
double vbss_thread_sagitta(const thread_object *t, uint32_t segment);
/* Whether the thread is too bent for the length of the segment, and it may be divided; straight enough for
 * the node to go. */
bool vbss_thread_needs_refinement(const thread_object *t, uint32_t segment);
bool vbss_thread_is_straight(const thread_object *t, uint32_t node);
/* The segment to divide so that this one can be later: that itself, or a longer one beside it. */
uint32_t vbss_thread_first_segment_to_split(const thread_object *t, uint32_t segment);
/* Whether lengths allow it: the longest, and the ratio of neighbours. */
bool vbss_thread_can_coarsen(const thread_object *t, uint32_t node);
/* Whether a node among these is attached or welded. */
bool vbss_thread_has_attached_node(const thread_object *t, uint32_t low, uint32_t high);
/* The next segment to look at; they come round. */
uint32_t vbss_thread_next_segment_to_check(thread_object *t);
void vbss_thread_record_node_count(thread_object *t);
/* After a step of a thread alone. */
void vbss_thread_adapt_mesh(thread_object *t);

/* ---- what is done (remesh.c). Numbers of nodes, segments and attachments change; the layout is unknown then.
 *
 * Kept: rest lengths and mass, momentum, the strain of each segment; angular momentum but for its part along the
 * segment; what else there is at nodes and segments goes to the new ones. */

/* Nodes around the change that may be looked at, on either side. */
enum { REMESH_WINDOW_SIDE = 6, REMESH_WINDOW_NODES = 2 * REMESH_WINDOW_SIDE + 2 };

/* The new node is `segment` + 1. `room`: how far nodes may be moved, m; without it the new one lies on the
 * chord and all others stay. */
void vbss_thread_split_segment(thread_object *t, uint32_t segment, double max_displacement);
/* The segments at the node become one. False: it takes more room. */
bool vbss_thread_remove_node(thread_object *t, uint32_t node, double max_displacement);

/* ---- a window (remesh_window.c): nodes around a change, as they are and shall be */

typedef struct remesh_window {
    bool has_arcs;                         /* lengths are those of arcs */
    uint32_t first_node;                   /* the thread's node that is the first here */
    uint32_t count;                        /* nodes */
    bool has_thread_start, has_thread_end; /* the thread does, with the window */
    vec3 x[REMESH_WINDOW_NODES];
    bool is_movable[REMESH_WINDOW_NODES]; /* it may be moved */
    double rest[REMESH_WINDOW_NODES];
    double elongation
        [REMESH_WINDOW_NODES]; /* length - rest length that a segment shall have; NAN where that is not known */
} remesh_window;

/* Around a node. */
void vbss_remesh_extract_window(const thread_object *t, uint32_t node, remesh_window *w);
/* Sets the excess of each segment to what it is. */
void vbss_remesh_measure_window(remesh_window *w);
/* Moves nodes until segments have the excess that they shall have; returns the longest way, m. */
double vbss_remesh_project_window(remesh_window *w);

#endif
