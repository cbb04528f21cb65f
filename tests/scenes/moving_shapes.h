/* A coiling thread, capsules that tumble along it, and a sheet that waves beneath: shapes for the search,
 * the same for tests, bench and the determinism table. Positions are worked out from the number of the
 * step alone, so that a restored object goes on as the saved one. Longer coils have more turns, so that
 * each segment has as many neighbours whatever their number. */
#ifndef VBSS_TESTS_SCENES_MOVING_SHAPES_H
#define VBSS_TESTS_SCENES_MOVING_SHAPES_H

#include <stdbool.h>

#include <vblast_ss/collision.h>

#define MOVING_SHAPES_RADIUS 0.125e-3 /* of all, m */

typedef struct moving_shapes_options {
    uint32_t segment_count; /* of the thread, from 1 on */
    bool capsules, sheet;   /* whether there are any */
} moving_shapes_options;

typedef struct moving_shapes {
    moving_shapes_options options;
    vbss_collision *collision;
    double *positions; /* of any one shape */
} moving_shapes;

typedef enum moving_shape { MOVING_THREAD, MOVING_CAPSULES, MOVING_SHEET } moving_shape;

/* The configuration that suits: capacities for the size, everything else the defaults. */
vbss_result moving_shapes_config(const moving_shapes_options *options,
                                 vbss_collision_config *config);
/* The shapes in the order of moving_shape, those that there are; at rest in their places of step 0. */
vbss_result moving_shapes_create(vbss_context *context, const moving_shapes_options *options,
                                 const vbss_collision_config *config, moving_shapes *scene);
/* Destroys the object too. */
vbss_result moving_shapes_destroy(moving_shapes *scene);

uint32_t moving_shapes_nodes(const moving_shapes_options *options, moving_shape shape);
void moving_shapes_place(const moving_shapes_options *options, moving_shape shape, uint64_t step,
                         double *positions);
/* Moves all shapes from where they are to their places in a step. */
vbss_result moving_shapes_move(moving_shapes *scene, uint64_t step);
/* The next step: moves, searches, tests. Steps are counted by the object's searches. */
vbss_result moving_shapes_step(moving_shapes *scene);
/* Of the object's state and of all that was found last. */
vbss_result moving_shapes_hash(const moving_shapes *scene, uint64_t *hash);

#endif
