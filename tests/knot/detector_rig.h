/* What the tests of knot detectors share: a detector with what it is shown, made in a few lines, looked at in one. */
#ifndef VBSS_TESTS_KNOT_DETECTOR_RIG_H
#define VBSS_TESTS_KNOT_DETECTOR_RIG_H

#include <math.h>
#include <string.h>

#include "harness/harness.h"
#include "knot/knot.h"
#include "fixtures/throw_stack.h"

enum { RIG_TOOLS = 3, RIG_POINTS = 401 };

typedef struct detector_rig {
    harness_memory memory;
    vbss_context *context;
    vbss_knot_detector *detector;
    vbss_knot_detector_config config; /* change it before it is made */
    /* What is shown: change it before it is. */
    thread_line line;
    double points[RIG_POINTS][3];
    vbss_knot_tool tools[RIG_TOOLS];
    vbss_knot_input input;
} detector_rig;

/* A context, the configuration and an input of a straight thread; room for RIG_POINTS points and RIG_TOOLS
 * tools. The rig must stay where it is. */
void detector_rig_begin(detector_rig *r);
void detector_rig_create(detector_rig *r);
/* Asserts that all memory came back. */
void detector_rig_end(detector_rig *r);

/* Shows a knot tied over tissue, told in notation, such as "2=1x1", in so many segments; the first throw is
 * right-handed. */
void detector_rig_tie(detector_rig *r, const char *notation, uint32_t segments);
/* Shows a knot that is no stack of throws: the figure eight, 4_1. */
void detector_rig_figure_eight(detector_rig *r);
/* Adds tools that the thread does not go round: [0] holds the tail near its end, [1] the needle, [2] nothing. */
void detector_rig_add_tools(detector_rig *r, uint32_t count);
/* Adds a straight tool along z near the origin and a thread that winds about it: signed turns towards the tip. */
void detector_rig_wind(detector_rig *r, double turns);

void detector_rig_steps(detector_rig *r, uint32_t count);
void detector_rig_judge(detector_rig *r);
/* Steps until the reading that is under way, or the next, has ended; returns how many. */
uint32_t detector_rig_read(detector_rig *r);

vbss_knot_state detector_rig_state(const detector_rig *r);
vbss_knot_throw detector_rig_throw(const detector_rig *r, uint32_t number);
vbss_knot_winding detector_rig_winding(const detector_rig *r, uint32_t tool);
vbss_knot_detector_statistics detector_rig_statistics(const detector_rig *r);
vbss_view detector_rig_view(const detector_rig *r, vbss_knot_field field);
uint64_t detector_rig_hash(const detector_rig *r);
/* How many events of that kind the last step had, and the last of them if `event` is not NULL. */
uint32_t detector_rig_events(const detector_rig *r, vbss_knot_event kind, uint32_t event[4]);
void detector_rig_expect_notation(const detector_rig *r, const char *wanted);
/* Asserts that all that hosts see of two detectors is the same; events, too, or none of them. */
void detectors_are_alike(vbss_knot_detector *a, vbss_knot_detector *b, bool events);
/* The inside. */
knot_detector *detector_rig_object(const detector_rig *r);

/* Every function that takes a detector, all other arguments good: those that change something come first; a restore
 * has nothing good to read and is VBSS_ERROR_CORRUPT. The input is that of the last rig that was begun. */
enum { DETECTOR_EDITS = 4, DETECTOR_CALLS = 12 };
extern const harness_handle_call detector_calls[DETECTOR_CALLS];
vbss_result detector_call_restore(void *detector);
/* 0 to 4: state, first throw, winding about the first tool, statistics, a view. */
enum { DETECTOR_STRUCTS = 5 };
extern const uint32_t detector_struct_sizes[DETECTOR_STRUCTS];
vbss_result detector_write_out(vbss_knot_detector *detector, int which, void *out, uint32_t size);

#endif
