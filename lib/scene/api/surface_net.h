/* The surface on which a sampled field has a given value, as triangles.
 *
 * Method: surface nets. Each cell of the grid that the surface passes gets a vertex on it, and each edge of the
 * grid that it crosses two triangles of the vertices of the four cells around the edge. */
#ifndef VBSS_SCENE_SURFACE_NET_H
#define VBSS_SCENE_SURFACE_NET_H

#include "base/linear.h"
#include <vblast_ss/base.h>

typedef struct scene_sampled_field {
    const double *values; /* the first index is fastest */
    uint32_t counts[3];   /* samples along x, y and z, 2 or more */
    vec3 spacing;         /* m */
    double level;         /* the surface is where the field has this value */
} scene_sampled_field;

typedef struct scene_surface_net {
    uint32_t vertex_count, triangle_count;
    double *vertices;    /* 3 each, in the frame of the field; NULL: only count */
    uint32_t *triangles; /* 3 each, counter-clockwise from the side of larger values */
} scene_surface_net;

/* Finds the surface, or counts its parts if the arrays are NULL. `layers` has room for two numbers for each sample
 * of a layer of constant z. Fails with VBSS_ERROR_OUT_OF_RANGE if the surface passes a cell more than once. */
vbss_result vbss_scene_find_surface_net(vbss_context *context, const scene_sampled_field *field,
                                        uint32_t *layers, scene_surface_net *net);

#endif
