/* One mesh of the drain in a watched context, and what tests ask of it. */
#ifndef VBSS_TESTS_MESH_RIG_H
#define VBSS_TESTS_MESH_RIG_H

#include "harness/harness.h"

#include "drain/mesh.h"

#define RIG_DEGREE (VBSS_PI / 180.0)

typedef struct mesh_rig {
    harness_memory memory;
    vbss_context *context;
    drain_mesh mesh;
} mesh_rig;

/* The default drain with that mesh. */
drain_mesh_options mesh_rig_options(drain_mesh_kind kind);
/* A tube of equal cells without slit. */
drain_mesh_options mesh_rig_tube(uint32_t axial_cells, uint32_t round_cells);
/* Any options that are allowed, of any kind; divided ones only when asked for. */
drain_mesh_options mesh_rig_draw(harness_source *source, bool divided);
void mesh_rig_begin(mesh_rig *rig, const drain_mesh_options *options);
void mesh_rig_end(mesh_rig *rig);

/* The node that the plane of the slit mirrors. */
uint32_t mesh_rig_mirrored(const drain_mesh *m, uint32_t node);
/* Normal of a triangle, as long as twice its area. */
vec3 mesh_rig_normal(const drain_mesh *m, uint32_t triangle);
double mesh_rig_area(const drain_mesh *m);
/* Degrees. */
double mesh_rig_min_angle(const drain_mesh *m);
bool mesh_rig_is_tip(const drain_mesh *m, uint32_t node);

#endif
