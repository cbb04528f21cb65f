/* Meshes that leave out what is near along their surface, in an object of their own. */
#ifndef VBSS_TESTS_COLLISION_NEAR_RIG_H
#define VBSS_TESTS_COLLISION_NEAR_RIG_H

#include "collision/shapes.h"
#include "collision/shapes_model.h"

typedef struct near_rig {
    harness_memory memory;
    vbss_context *context;
    model m;
    vbss_collision *collision;
    collision_object *object;
} near_rig;

void near_begin(near_rig *f);
void near_make(near_rig *f); /* the object with the model's shapes */
void near_end(near_rig *f);
uint64_t near_hash(const near_rig *f);
void near_leave_out(const near_rig *f, uint32_t name, const vec3 *at, double distance);

enum { NEAR_COLUMNS = 10, NEAR_ROWS = 4, NEAR_SLIT = 2 };

/* A flat sheet at rest, a unit from node to node, with a closed slit: nodes 21 to 28 are doubled as 40 to 47. */
model_shape *near_add_slit_sheet(near_rig *f);

#endif
