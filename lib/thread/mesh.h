/* A mesh that adapts itself, shared by mesh.c (what is wanted where), remesh.c (a node comes or goes),
 * window.c (what its neighbours do then) and by scenes, which know what is near. docs/adaptive.md. */
#ifndef VBSS_THREAD_MESH_H
#define VBSS_THREAD_MESH_H

#include "thread/thread.h"

static inline bool thread_is_adaptive(const thread_object *t)
{
    return t->config.mesh == VBSS_MESH_ADAPTIVE;
}

/* ---- what is wanted (mesh.c) */

/* Segments that are looked at after a step. */
enum { MESH_LOOKS = 32 };
/* Neighbouring lengths differ by this at most; and rounding. */
#define MESH_RATIO (2.0 * (1.0 + 1e-9))
/* Up to so much longer than wanted is good enough: halves of what is a little too long would be twice too fine. */
#define MESH_LENIENCE 1.25

/* |curvature| at a node; 0 at free ends. */
double vbss_thread_node_curvature(const thread_object *t, uint32_t node);
double vbss_thread_sagitta(const thread_object *t, uint32_t segment);
/* Whether the thread is too bent for the length of the segment, and it may be divided; straight enough for
 * the node to go. */
bool vbss_thread_is_too_bent(const thread_object *t, uint32_t segment);
bool vbss_thread_is_straight(const thread_object *t, uint32_t node);
/* The segment to divide so that this one can be later: that itself, or a longer one beside it. */
uint32_t vbss_thread_first_to_divide(const thread_object *t, uint32_t segment);
/* Whether lengths allow it: the longest, and the ratio of neighbours. */
bool vbss_thread_may_join(const thread_object *t, uint32_t node);
/* Whether a node among these is attached or welded. */
bool vbss_thread_holds_among(const thread_object *t, uint32_t low, uint32_t high);
/* The next segment to look at; they come round. */
uint32_t vbss_thread_next_look(thread_object *t);
void vbss_thread_note_mesh(thread_object *t);
/* After a step of a thread alone. */
void vbss_thread_adapt(thread_object *t);

/* ---- what is done (remesh.c). Numbers of nodes, segments and attachments change; the layout is unknown then.
 *
 * Kept: rest lengths and mass, momentum, the strain of each segment; angular momentum but for its part along the
 * segment; what else there is at nodes and segments goes to the new ones. */

/* Nodes around the change that may be looked at, on either side. */
enum { MESH_SIDE = 6, MESH_WINDOW = 2 * MESH_SIDE + 2 };

/* The new node is `segment` + 1. `room`: how far nodes may be moved, m; without it the new one lies on the
 * chord and all others stay. */
void vbss_thread_divide_segment(thread_object *t, uint32_t segment, double room);
/* The segments at the node become one. False: it takes more room. */
bool vbss_thread_remove_node(thread_object *t, uint32_t node, double room);

/* ---- a window (window.c): nodes around a change, as they are and shall be */

typedef struct mesh_window {
    bool arcs;         /* lengths are those of arcs */
    uint32_t first;    /* the thread's node that is the first here */
    uint32_t count;    /* nodes */
    bool begins, ends; /* the thread does, with the window */
    vec3 x[MESH_WINDOW];
    bool moves[MESH_WINDOW]; /* it may be moved */
    double rest[MESH_WINDOW];
    double excess
        [MESH_WINDOW]; /* length - rest length that a segment shall have; NAN where that is not known */
} mesh_window;

/* Around a node. */
void vbss_mesh_look(const thread_object *t, uint32_t node, mesh_window *w);
/* Sets the excess of each segment to what it is. */
void vbss_mesh_measure(mesh_window *w);
/* Moves nodes until segments have the excess that they shall have; returns the longest way, m. */
double vbss_mesh_settle(mesh_window *w);

#endif
