/* The rig: a rigid drain on a floor, and a thread that stands up from two fixed points on it. */
#ifndef VBSS_EXAMPLES_THROW_RIG_H
#define VBSS_EXAMPLES_THROW_RIG_H

#include <stdbool.h>
#include <stdio.h>

#include <vblast_ss/vblast_ss.h>

#include "throw/log_file.h"
#include "throw/mirror.h"
#include "throw/vec.h"

#define DRAIN_RADIUS 6.5e-3
#define FLOOR_HEIGHT (-13e-3)
#define MARK_ARC 4.5e-3 /* from the top of the drain to either mark */
#define SEGMENT 0.5e-3
#define THREAD_RADIUS 0.125e-3
#define EXCHANGE_DISTANCE 0.05 /* from the middle of the drain's top */

enum { MAX_STEP_EVENTS = 64 };
enum { MAX_THREAD_NODES = 1024 };

#define TRY(call)                     \
    do {                              \
        vbss_result result_ = (call); \
        if (result_ != VBSS_OK) {     \
            return result_;           \
        }                             \
    } while (0)

/* Who makes the steps and moves the tools, where scripted hands only tell where they want them. */
typedef struct throw_rig_host {
    vbss_result (*step)(void *user, double dt);
    void *user;
} throw_rig_host;

typedef struct throw_rig {
    const throw_rig_host *host; /* NULL: hands move their tools themselves */
    bool mirrored;              /* the hands are left-handed (mirror.h) */
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
    vec turned[MAX_THREAD_NODES]; /* its nodes then */
    /* Events of the scene that throw_rig_follow has taken: those of the last step. */
    vbss_scene_event events[MAX_STEP_EVENTS];
    uint32_t event_count;
} throw_rig;

/* Above the drain's round, m. */
static inline double height_above_drain(vec x)
{
    return v_hypotenuse(x.x, x.z + DRAIN_RADIUS) - DRAIN_RADIUS;
}

vbss_result throw_rig_create(throw_rig *s, double tail, double limb);
/* Begins the log, when all is there. The note says what the scene is made from. */
vbss_result throw_rig_begin(throw_rig *s, const char *log, const char *note);
/* Holds the limb up beside a node, until a hand has it; lets it go. */
vbss_result throw_rig_hold_limb(throw_rig *s, uint32_t node);
vbss_result throw_rig_release_limb(throw_rig *s);
/* The host's step, or else throw_rig_advance: scene, session, log, and what came of it. */
vbss_result throw_rig_step(throw_rig *s, double dt);
vbss_result throw_rig_advance(throw_rig *s, double dt);
/* After a step that was made otherwise: takes the events; where its nodes are; `thread` is what is left of it on the drain, if it was cut. */
vbss_result throw_rig_follow(throw_rig *s);
/* Ends the log. */
vbss_result throw_rig_end(throw_rig *s);
void throw_rig_destroy(throw_rig *s);
/* From the tail's end on. */
const vec *throw_rig_nodes(const throw_rig *s);
/* Of the scene's arc length of the thread, in segments from the tail's end; of its segments. */
double throw_rig_place(const throw_rig *s, double arc_length);
uint32_t throw_rig_segment(const throw_rig *s, uint32_t segment);

#endif
