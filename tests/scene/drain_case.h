/* A drain among tools, threads and attachments that do to it what they can: every part is watched, and a ledger says
 * whether there is more energy than hands have put in. Every call that fails, fails the test. */
#ifndef VBSS_TESTS_SCENE_DRAIN_CASE_H
#define VBSS_TESTS_SCENE_DRAIN_CASE_H

#include "scene/small_watch.h"

enum { DRAIN_CASE_TOOLS = 4, DRAIN_CASE_PINS = 8, DRAIN_CASE_THREADS = 1 };

/* What a hand moves: a tool's pose, or where a pin takes a node. */
typedef struct drain_case_hand {
    uint32_t id; /* the body; the attachment */
    vec3 at, to; /* begin and end of the next step */
} drain_case_hand;

typedef struct drain_case {
    small s; /* change its configurations, and that of the drain, before what they make */
    vbss_drain_config config;
    vbss_drain *drain;
    uint32_t body;
    vbss_drain_places places;
    drain_case_hand tools[DRAIN_CASE_TOOLS], pins[DRAIN_CASE_PINS];
    uint32_t tool_count, pin_count;
    vbss_thread *threads[DRAIN_CASE_THREADS];
    uint32_t thread_count;
    small_watch watch;
    double h;
    /* the ledger, J */
    double first, work, max_work; /* energy at the begin; put in since; the most of that so far */
    double excess;                /* most energy beyond both */
    uint32_t steps, inverted;     /* most triangles at a time */
} drain_case;

void drain_case_begin(drain_case *c);
/* The scene and the drain in it. The case must stay where it is until its end. */
void drain_case_make(drain_case *c);
void drain_case_end(drain_case *c); /* asserts that all memory came back */

/* A stick about its middle; returns its place among the tools. */
uint32_t drain_case_tool(drain_case *c, vbss_scene_rigid_kind kind, vec3 middle, vec3 half,
                         double radius);
/* A node of the drain, where it is; its place among the pins. */
uint32_t drain_case_pin(drain_case *c, uint32_t node);
void drain_case_unpin(drain_case *c, uint32_t pin);
void drain_case_force(drain_case *c, uint32_t node, vec3 force); /* its work is not in the ledger */
void drain_case_thread(drain_case *c, vec3 begin, vec3 end, uint32_t segments);

/* Steps in which a tool goes to a place, evenly. */
void drain_case_move_to(drain_case *c, uint32_t tool, vec3 to, uint32_t steps);
/* The next step's. */
void drain_case_target(drain_case *c, uint32_t tool, vec3 to);
void drain_case_target_pin(drain_case *c, uint32_t pin, vec3 to);
/* One step, and what every step must keep: all is finite, triangles are counted as inverted that are. */
void drain_case_step(drain_case *c);
void drain_case_wait(drain_case *c, uint32_t steps);
/* The ledger begins anew: something was let go, or acts that is not in it. */
void drain_case_reckon(drain_case *c);

vec3 drain_case_node(const drain_case *c, uint32_t node);
vec3 drain_case_at(const drain_case *c, uint32_t tool);
vec3 drain_case_contact_force(const drain_case *c, uint32_t tool);
vec3 drain_case_anchor_sum(const drain_case *c);
vbss_drain_statistics drain_case_statistics(const drain_case *c);
vbss_drain_energies drain_case_energies(const drain_case *c);
/* Farthest that a node is from where it was made. */
double drain_case_distance(const drain_case *c);
double drain_case_fastest(const drain_case *c);
double drain_case_energy(const drain_case *c);

/* One line of what it was like. */
void drain_case_report(const drain_case *c, const char *name);
/* Nothing passed; and no more energy than was put in, but for that share of it. */
void drain_case_expect_kept(const drain_case *c, double share);
/* Lips apart, nothing moves, no node is that far from where it was made. */
void drain_case_expect_rest(const drain_case *c, double distance);
/* Tells, expects what is kept, and ends. */
void drain_case_finish(drain_case *c, const char *name, double share);

#endif
