/* A box as a mesh. */
#ifndef VBSS_TESTS_SCENE_BOX_MESH_H
#define VBSS_TESTS_SCENE_BOX_MESH_H

#include <vblast_ss/scene_geometry.h>

#include "base/linear.h"

enum { BOX_VERTICES = 8, BOX_TRIANGLES = 12 };

/* A closed box about the origin, or a flat one: its triangles are the middle of its wall. */
typedef struct box_mesh {
    double vertices[BOX_VERTICES][3];
    vbss_scene_static_mesh_config config;
} box_mesh;

extern const uint32_t box_mesh_triangles[BOX_TRIANGLES][3];

void box_mesh_make(box_mesh *b, vec3 half, double thickness);

#endif
