/* Adaptive remeshing of a thread. remesh_criteria.c decides where nodes are inserted or removed,
 * remesh.c does it, and remesh_window.c moves the neighbours of the node. Scenes use it with
 * criteria of their own. See docs/explanation/adaptive.md. */
#ifndef VBSS_THREAD_REMESH_H
#define VBSS_THREAD_REMESH_H

#include "thread/thread.h"
#include "thread/tuning.h"

static inline bool thread_is_adaptive(const thread_object *t)
{
    return t->config.mesh == VBSS_THREAD_MESH_ADAPTIVE;
}

/* ---- criteria (remesh_criteria.c) */

/* |curvature| at a node; 0 at free ends. */
double vbss_thread_node_curvature(const thread_object *t, uint32_t node);

/* Largest distance of a segment's arc from its chord, m. */
double vbss_thread_sagitta(const thread_object *t, uint32_t segment);

/* Whether a segment may be split and is too long for its curvature. */
bool vbss_thread_needs_refinement(const thread_object *t, uint32_t segment);

/* Whether the thread is straight enough for the node to be removed. */
bool vbss_thread_is_straight(const thread_object *t, uint32_t node);

/* The segment to split so that `segment` can be split later: `segment` itself, or a
 * longer neighbour. */
uint32_t vbss_thread_first_segment_to_split(const thread_object *t, uint32_t segment);

/* Whether the lengths allow removal of the node: neither maximum length nor the ratio of neighbours
 * is exceeded. */
bool vbss_thread_can_coarsen(const thread_object *t, uint32_t node);

/* Whether a node from `low` to `high` is attached or welded. */
bool vbss_thread_has_attached_node(const thread_object *t, uint32_t low, uint32_t high);

/* The next segment to check; after the last comes segment 0. */
uint32_t vbss_thread_next_segment_to_check(thread_object *t);

/* Records the largest number of nodes in the statistics. */
void vbss_thread_record_node_count(thread_object *t);

/* Remeshes a thread that is stepped on its own, after a step. */
void vbss_thread_adapt_mesh(thread_object *t);

/* ---- changes (remesh.c) */

/* A change renumbers nodes, segments and attachments, and invalidates derived data. It keeps
 * rest lengths, mass, momentum, the strain of each segment, and angular momentum except along
 * the segment.
 *
 * Nodes that a window has on either side of the change. */

/* Nodes around the change that may be looked at, on either side. Capacity, chosen. */
enum { REMESH_WINDOW_SIDE = 6, REMESH_WINDOW_NODES = 2 * REMESH_WINDOW_SIDE + 2 };

/* Splits a segment at its middle; the new node is `segment` + 1. `max_displacement`: how far nodes
 * may move, m. If that is too little, the new node lies on the chord and all others stay. */
void vbss_thread_split_segment(thread_object *t, uint32_t segment, double max_displacement);

/* Removes a node. False: that would move nodes farther than `max_displacement` (m);
 * nothing changes. */
bool vbss_thread_remove_node(thread_object *t, uint32_t node, double max_displacement);

/* ---- window (remesh_window.c): a copy of the nodes around a change */

typedef struct remesh_window {
    bool has_arcs;                         /* segments are arcs, not chords */
    uint32_t first_node;                   /* the thread's number of the first node */
    uint32_t count;                        /* number of nodes */
    bool has_thread_start, has_thread_end; /* the window contains that end of the thread */
    vec3 x[REMESH_WINDOW_NODES];
    bool is_movable[REMESH_WINDOW_NODES];
    double rest[REMESH_WINDOW_NODES];
    /* target elongation of each segment, m; NAN: unknown */
    double elongation[REMESH_WINDOW_NODES];
} remesh_window;

/* Copies the nodes around a node to a window. */
void vbss_remesh_extract_window(const thread_object *t, uint32_t node, remesh_window *w);

/* Sets the target elongations to the current ones. */
void vbss_remesh_measure_window(remesh_window *w);

/* Moves nodes until segments have their target elongations. Returns the largest displacement, m. */
double vbss_remesh_project_window(remesh_window *w);

#endif
