/* A knot tied as a surgeon ties it: round a driven cylinder, throw by throw from the bottom, each laid down
 * on the one below. (Pulling both ends of all throws at once locks the top one first and leaves loops below.)
 * The same for tests, bench and examples; what the hands do follows from the options and from what they feel.
 *
 * All throws are there from the beginning, loose, on top of each other. For each but the last two hands take
 * the line where it turns above it and go apart until they feel the load. Then fingers keep it lightly, or it
 * would spring open, and let the line slip when the next throw is laid. The last is tightened by the ends. Pegs
 * hold the turns further up open, or the throws above would lock while line is drawn through them; they are
 * withdrawn along y when their turn is taken. */
#ifndef VBSS_TESTS_SCENES_TIED_KNOT_H
#define VBSS_TESTS_SCENES_TIED_KNOT_H

#include <vblast_ss/scene.h>

#include "base/linear.h"
#include "scenes/contact_hands.h"
#include "scenes/knots.h"

enum { TIED_KNOT_THROWS = 3, TIED_KNOT_PEGS = 2 };

typedef struct tied_knot_options {
    vbss_scene_config scene;
    vbss_thread_config thread; /* material; its shape is set by create */
    /* Of any kind, with or without cylinder; half hitches are tightened by their ends. The loop is laid
     * nearer to the cylinder than knot_make alone does. */
    knot_shape knot;
    double cylinder_friction, peg_friction;
    contact_pull lay;  /* of the hands that lay a throw down */
    contact_pull pull; /* of those at the ends, for the last throw */
    double keep;       /* N, on each limb of a throw that is laid, until the next one lies on it */
    double slack;      /* N, outward on both ends until they are taken */
    uint32_t rest;     /* steps that a load is held before the next throw */
} tied_knot_options;

/* Fingers on a limb of a throw that is laid. */
typedef struct tied_knot_grip {
    uint32_t node, id; /* of the attachment; 0: none */
} tied_knot_grip;

typedef struct tied_knot {
    tied_knot_options options;
    vbss_scene *scene;
    vbss_thread *thread;
    uint32_t thread_body, cylinder_body, peg_bodies[TIED_KNOT_PEGS]; /* numbers; 0: none */
    uint32_t node_count;
    knot_line line;
    double length;     /* of the thread, m */
    double peg_radius; /* m; 0: none are needed */
    vec3 peg_homes[TIED_KNOT_PEGS];
    double withdrawn; /* of the pegs, m */
    /* The nodes that hands take for each, from the bottom, or will take if nothing slides. */
    uint32_t throws;
    uint32_t nodes[TIED_KNOT_THROWS][2];
    uint32_t stage;  /* throw that is tightened; throws: all are */
    uint32_t rested; /* steps under load */
    contact_hand hands[2];
    tied_knot_grip grips[2];
    uint32_t ends[2]; /* attachments that take the slack of the ends; 0: none */
    uint64_t steps;
} tied_knot;

/* The defaults of a kind, with the cylinder; change what you need. */
vbss_result tied_knot_init(tied_knot_options *options, knot_kind kind);
/* On failure what was made so far goes with the context. */
vbss_result tied_knot_create(vbss_context *context, const tied_knot_options *options,
                             tied_knot *knot);
vbss_result tied_knot_destroy(tied_knot *knot);

/* Hands and pegs are moved, then all of it by h seconds. When all is tight the hands go on holding the ends. */
vbss_result tied_knot_step(tied_knot *knot, double h);
/* To go back, restore the scene's snapshot and a copy of the struct. */
vbss_result tied_knot_hash(const tied_knot *knot, uint64_t *hash);

/* The throw that is being tightened, from 0; and whether all of them bear their load. */
uint32_t tied_knot_stage(const tied_knot *knot);
bool tied_knot_done(const tied_knot *knot);
/* The smaller pull of the two hands that tighten, or hold in the end, N. */
double tied_knot_felt(const tied_knot *knot);

#endif
