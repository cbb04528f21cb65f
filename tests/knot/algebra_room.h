/* Memory for invariants, in tests of these. */
#ifndef VBSS_TESTS_KNOT_ALGEBRA_ROOM_H
#define VBSS_TESTS_KNOT_ALGEBRA_ROOM_H

#include "harness/harness.h"
#include "knot/codes.h"

typedef struct algebra_room {
    harness_memory memory;
    vbss_context *context;
    knot_algebra algebra;
    knot_bracket bracket;
    vbss_array arrays[KNOT_ALGEBRA_ARRAYS + KNOT_BRACKET_ARRAYS];
} algebra_room;

static inline algebra_room *algebra_room_make(uint32_t capacity)
{
    algebra_room *room = test_calloc(1, sizeof *room);
    room->context = harness_context(&room->memory);
    vbss_knot_algebra_arrays(&room->algebra, capacity, room->arrays);
    vbss_knot_bracket_arrays(&room->bracket, capacity, room->arrays + KNOT_ALGEBRA_ARRAYS);
    expect_ok(vbss_allocate_arrays(room->context, room->arrays,
                                   KNOT_ALGEBRA_ARRAYS + KNOT_BRACKET_ARRAYS, "algebra"));
    return room;
}

static inline void algebra_room_end(algebra_room *room)
{
    vbss_release_arrays(room->context, room->arrays, KNOT_ALGEBRA_ARRAYS + KNOT_BRACKET_ARRAYS);
    harness_context_end(room->context, &room->memory);
    test_free(room);
}

#endif
