/* An object with a shape of each kind, and every call that takes one. */
#ifndef VBSS_TESTS_COLLISION_SHAPES_OBJECT_H
#define VBSS_TESTS_COLLISION_SHAPES_OBJECT_H

#include "harness/harness.h"

enum { OBJECT_CHAIN, OBJECT_CAPSULES, OBJECT_MESH, OBJECT_SHAPES };

typedef struct object_fixture {
    harness_memory memory;
    vbss_context *context;
    vbss_collision *collision;
} object_fixture;

void object_begin(object_fixture *f);
void object_end(object_fixture *f);
/* config: NULL for the defaults. Its shapes have moved, been searched and tested. */
vbss_collision *object_make(vbss_context *context, const vbss_collision_config *config);
vbss_collision *object_make_unsearched(vbss_context *context, const vbss_collision_config *config);
/* Moves all shapes: another `time`, another place. */
void object_move(vbss_collision *collision, double time);
uint64_t object_hash(vbss_collision *collision);

/* 0: a view; 1: the statistics. */
vbss_result object_write_out(vbss_collision *collision, int which, void *out, uint32_t size);

/* All other arguments are good. Those that change something come first, those that add a shape before
 * all; a restore has nothing good to read and is VBSS_ERROR_CORRUPT. */
enum { OBJECT_EDITS = 11, OBJECT_CALLS = 16 };
extern const harness_handle_call object_calls[OBJECT_CALLS];
vbss_result object_call_restore(void *collision);

#endif
