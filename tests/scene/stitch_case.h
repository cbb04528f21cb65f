/* A stitch that two hands pull, drop, cut and take again: after every step the oracle looks where threads cross the wall, and a
 * ledger says whether there is more energy than hands have put in. Every call that fails, fails the test. */
#ifndef VBSS_TESTS_SCENE_STITCH_CASE_H
#define VBSS_TESTS_SCENE_STITCH_CASE_H

#include "scene/stitch_watch.h"
#include "fixtures/stitch_scenes.h"

enum { STITCH_CASE_EVENTS = VBSS_SCENE_EVENT_OVERDUE + 1 };

typedef struct stitch_case_hand {
    vbss_thread *thread; /* NULL: it holds nothing */
    uint32_t id;         /* of the attachment */
    vec3 at, to;         /* the node, after the last step; where it shall go */
    vec3 force;          /* on the thread, N */
} stitch_case_hand;

typedef struct stitch_case {
    small s;                      /* its scene is the stitch's */
    stitch_scene_options options; /* change them before making */
    stitch_scene stitch;
    stitch_case_hand hands[2]; /* left, right */
    stitch_watch watch;
    double h;
    uint32_t counts[STITCH_CASE_EVENTS],
        happened[STITCH_CASE_EVENTS]; /* so far; in the last step */
    uint32_t steps;
    /* the ledger, J */
    double first, work, max_work, excess;
    /* Most energy that a step has beyond what hands could have put into it, in whatever direction they pulled, with the larger force of
     * its begin and its end: those of thin threads are noisy. Of whole steps. `shown`: of one step. `jump`: as far as it is still
     * there in the next, beyond the larger of the two steps before. */
    double jump, shown;
    /* The law of a hole takes out what a polygon's corners do to tensions (docs/explanation/stitch.md, "Capstan"), and pushes where they hold
     * back. What it has given in all, less what it took; the most of that; and in the step that is made. */
    double given, max_given, giving;
    double beyond
        [4]; /* energies after the last steps, newest first, and what hands could have put in since */
    uint32_t booked; /* whole steps one after the other */
    uint64_t broken; /* steps of which something was */
} stitch_case;

void stitch_case_begin(stitch_case *c); /* a context and options */
void stitch_case_make(stitch_case *c);
void stitch_case_end(stitch_case *c); /* asserts that all memory came back */
/* All of it, with so many crossings above the slit. */
void stitch_case_open(stitch_case *c, uint32_t crossings);

void stitch_case_target(stitch_case *c, int hand, vec3 to);
void stitch_case_shift(stitch_case *c, int hand, vec3 displacement);
void stitch_case_drop(stitch_case *c, int hand);
/* A node of a thread, where it is; false: it is held already. */
bool stitch_case_take(stitch_case *c, int hand, uint32_t body, uint32_t node);
/* The piece, or 0: it is refused. */
uint32_t stitch_case_cut(stitch_case *c, uint32_t body, double arc);
uint32_t stitch_case_nodes(const stitch_case *c, uint32_t body); /* 0: no such thread */
double stitch_case_length(const stitch_case *c, uint32_t body);
vec3 stitch_case_node(const stitch_case *c, uint32_t body, uint32_t node);

void stitch_case_step(stitch_case *c);
void stitch_case_wait(stitch_case *c, uint32_t steps);
/* A hand goes on by that displacement at that speed. */
void stitch_case_pull(stitch_case *c, int hand, vec3 displacement, double speed);
double stitch_case_energy(const stitch_case *c);
void stitch_case_reckon(stitch_case *c); /* the ledger begins anew */
bool stitch_case_hole(const stitch_case *c, int side, vbss_scene_hole *hole);
double stitch_case_fastest(const stitch_case *c); /* node of all threads, m/s */

/* Nothing crosses but in holes, none is lost; no more energy than was put in but for that share; then ends. */
void stitch_case_finish(stitch_case *c, const char *name, double share);

#endif
