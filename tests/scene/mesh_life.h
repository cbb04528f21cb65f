/* A thread and a tool that are thrown at a random mesh, thin or sharp, at up to 20 m/s: a static mesh, a host surface
 * that travels, turns and bends, or a rigid mesh that travels and turns. Every part of every step is asked of the exact oracle. */
#ifndef VBSS_TESTS_SCENE_MESH_LIFE_H
#define VBSS_TESTS_SCENE_MESH_LIFE_H

#include "base/random.h"
#include "oracle/surface.h"
#include "scene/small.h"

typedef enum mesh_life_kind {
    MESH_LIFE_STATIC,
    MESH_LIFE_SURFACE,
    MESH_LIFE_RIGID /* driven, or in every third life coupled */
} mesh_life_kind;

typedef struct mesh_life_result {
    uint64_t steps, parts, asked, touched, clamped;
    uint64_t passed; /* pairs of an axis and a feature of the mesh that had a point in common */
    double fastest;  /* of a node, m/s */
    double fastest_vertex; /* of a mesh that moves, m/s */
    uint64_t moves;        /* that the scene accepted */
} mesh_life_result;

/* Lives that number of steps and adds to the result. Stops at the first that passes. */
vbss_result mesh_life_run(vbss_random *random, uint32_t steps, mesh_life_kind kind,
                          mesh_life_result *result);

#endif
