/* What the files of the stitch share. */
#ifndef VBSS_EXAMPLES_NEEDLE_STITCH_PARTS_H
#define VBSS_EXAMPLES_NEEDLE_STITCH_PARTS_H

#include "needle/stitch.h"

#define STITCH_CARRY 0.1         /* m/s */
#define STITCH_CAREFUL 0.03      /* m/s, near the drain and the floor */
#define STITCH_DRIVE 12e-3       /* m/s, of the tip in the drain, at the speed of an expert */
#define STITCH_IN_LUMEN 5e-3     /* m, of the tip, until the left hand is ready */
#define STITCH_FOLLOW 4e-3       /* m, at most, after a mark or a hole that moves */
#define STITCH_BORNE 1.5         /* s: after that time on the fork the right wall is at rest */
#define STITCH_FORK_LOWER 0.7e-3 /* m, than the left mark the fork bears it */

/* ---- stitch.c */
void stitch_enter_state(stitch *t, stitch_state state);
void stitch_fail(stitch *t, const char *why);
/* N, of all that the hand's tool touches. */
double stitch_felt(const hand *h);
/* But for what it misses its aim by. */
bool stitch_is_there(const hand *h);
/* Back out of the first wall. */
bool stitch_is_out(const stitch *t);

/* ---- stitch_path.c */
/* The mark as it is seen, with the hand's error. */
vec stitch_targeted(const stitch *t, int side);
/* The needle straight through the right wall, as far as it has gone. */
pose stitch_entering(const stitch *t);
/* On the circle through both walls, likewise. */
pose stitch_crossing(const stitch *t);
/* From the circle on which the needle really lies to the left mark. */
vec stitch_miss(const stitch *t);

/* ---- stitch_left_hand.c */
void stitch_lead_left(stitch *t);
void stitch_enter_support(stitch *t, stitch_support support);
bool stitch_is_under_wall(const stitch *t);
void stitch_set_fork_again(stitch *t);

/* ---- stitch_left_wall.c */
void stitch_retry_if_wall_yields(stitch *t);
void stitch_restart(stitch *t);
/* After so many tries at the left wall. */
void stitch_restart_if_often_tried(stitch *t);

#endif
