/* The stand: a rigid drain on a floor, and a thread that stands up from two fixed points on it. */
#ifndef VBSS_EXAMPLES_THROW_STAND_H
#define VBSS_EXAMPLES_THROW_STAND_H

#include <stdbool.h>
#include <stdio.h>

#include <vblast_ss/vblast_ss.h>

#include "throw/log_file.h"
#include "throw/vec.h"

#define DRAIN_RADIUS 6.5e-3
#define FLOOR_HEIGHT (-13e-3)
#define MARK_ARC 4.5e-3 /* from the top of the drain to either mark */
#define SEGMENT 0.5e-3
#define THREAD_RADIUS 0.125e-3
#define EXCHANGE_DISTANCE 0.05 /* from the middle of the drain's top */

enum { STAND_NODES = 1024 };

#define TRY(call)                     \
    do {                              \
        vbss_result result_ = (call); \
        if (result_ != VBSS_OK) {     \
            return result_;           \
        }                             \
    } while (0)

typedef struct stand {
    vbss_context *context;
    vbss_scene *scene;
    vbss_thread *thread;
    vbss_record *record;   /* steps are made through it, */
    vbss_session *session; /* or through that, which writes to it; may be NULL */
    log_file log;          /* receives its bytes */
    uint32_t thread_body, drain;
    uint32_t nodes;
    uint32_t marks[2]; /* nodes at the right mark (the tail's) and the left one (the long limb's) */
    uint32_t shift;    /* nodes that were cut off before node 0 */
    uint32_t cuts;     /* so many */
    uint32_t support;  /* pin that holds the limb up until a hand has it */
    double tail, limb; /* m */
    double time;
    double
        took; /* of the last step, CPU time of this thread: devices, scene, session, log; no hand's thoughts */
    bool
        reversed; /* the scene's thread begins at the limb's end; here all counts from the tail's */
    vec turned[STAND_NODES]; /* its nodes then */
} stand;

/* Above the drain's round, m. */
static inline double stand_height(vec x)
{
    return v_hypotenuse(x.x, x.z + DRAIN_RADIUS) - DRAIN_RADIUS;
}

vbss_result stand_create(stand *s, double tail, double limb);
/* Begins the log, when all is there. The note says what the scene is made from. */
vbss_result stand_begin(stand *s, const char *log, const char *note);
/* Holds the limb up beside a node, until a hand has it; lets it go. */
vbss_result stand_offer(stand *s, uint32_t node);
vbss_result stand_let_go(stand *s);
vbss_result stand_step(stand *s, double dt);
/* After a step that was made otherwise: where its nodes are; `thread` is what is left of it on the drain, if it was cut. */
vbss_result stand_follow(stand *s);
/* Ends the log. */
vbss_result stand_end(stand *s);
void stand_destroy(stand *s);
/* From the tail's end on. */
const vec *stand_nodes(const stand *s);
/* Of the scene's arc length of the thread, in segments from the tail's end; of its segments. */
double stand_place(const stand *s, double arc_length);
uint32_t stand_segment(const stand *s, uint32_t segment);

#endif
