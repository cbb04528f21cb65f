/* A surface that a host gives in place of the tube with a slit (surface.c). */
#ifndef VBSS_DRAIN_SURFACE_H
#define VBSS_DRAIN_SURFACE_H

#include "drain/drain.h"

/* Largest number of nodes. Unit: 1. Origin: chosen; the graph for the elimination order has a bit for
 * each pair of nodes, 512 KiB. Test: drain.drain_surface. */
enum { DRAIN_MAX_SURFACE_NODES = 2048 };

/* Reads a surface of any known size and checks all that needs no memory. */
vbss_result vbss_drain_read_surface(vbss_context *context, const vbss_drain_surface *surface,
                                    vbss_drain_surface *own);

/* Checks edges and anchors of the mesh's surface, and sets the mesh's counts. */
vbss_result vbss_drain_plan_surface(vbss_context *context, drain_mesh *mesh);

/* Copies nodes, triangles and anchors of the mesh's surface. */
void vbss_drain_fill_surface(drain_mesh *mesh);

/* Lets the drain's configuration point to its own copy of the surface, once the mesh is filled. */
vbss_result vbss_drain_copy_surface(drain_object *d);

void vbss_drain_free_surface(vbss_context *context, drain_object *d);

#endif
