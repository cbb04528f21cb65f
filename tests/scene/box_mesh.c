#include "scene/box_mesh.h"

const uint32_t box_mesh_triangles[BOX_TRIANGLES][3] = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5},
                                                       {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},
                                                       {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};

void box_mesh_make(box_mesh *b, vec3 half, double thickness)
{
    for (int i = 0; i < BOX_VERTICES; i++) {
        vec3_store(b->vertices[i],
                   vec3_make((i & 4) != 0 ? half.x : -half.x, (i & 2) != 0 ? half.y : -half.y,
                             (i & 1) != 0 ? half.z : -half.z));
    }
    b->config = vbss_scene_static_mesh_config_default();
    b->config.vertex_count = BOX_VERTICES;
    b->config.triangle_count = BOX_TRIANGLES;
    b->config.vertices = b->vertices[0];
    b->config.triangles = box_mesh_triangles[0];
    b->config.thickness = thickness;
}
