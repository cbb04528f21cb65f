/* What the hands do in each state of a throw. */
#ifndef VBSS_EXAMPLES_THROW_STATES_H
#define VBSS_EXAMPLES_THROW_STATES_H

#include "throw/steer.h"

/* To where the handle's end of W's jaws points when they hold the drawn tail. */
#define OUTWARD v3(-1.0, 0.0, 0.3)

/* Of W about the tail's root while it draws, rad; of a tail that stays raised. */
#define DRAWN_ROUND (PI * 160.0 / 180.0)
#define RAISED (PI * 110.0 / 180.0)

/* m: a drain that has gone so far, with the limb about W's jaws or as both pull, would go on as far as the hand does. */
#define THROW_DRAGGED 12e-3

void throw_enter(throw_run *t, throw_state state);

/* ---- wind.c: the limb round W's jaws */
vbss_result throw_pick(throw_run *t, double dt);
void throw_near(throw_run *t);
void throw_place(throw_run *t);
void throw_orbit(throw_run *t, double dt);
void throw_check(throw_run *t, double dt);
void throw_unwind(throw_run *t);

/* ---- pass.c: the tail through the turns */
/* W opens its jaws, and takes the tail at a node, for another time. */
void throw_take_tail(throw_run *t, uint32_t node);
void throw_tail(throw_run *t, double dt);
void throw_take_again(throw_run *t, double dt);
vbss_result throw_close(throw_run *t, double dt);
vbss_result throw_draw(throw_run *t, double dt);

/* ---- seat.c: down on the drain, and tight */
/* A loose throw, whose tail is not raised: it holds then, and none of its ends becomes straight. */
void throw_pull_evenly(throw_run *t);
void throw_lower(throw_run *t, double dt);
void throw_seat(throw_run *t, double dt);
void throw_square(throw_run *t, double dt);
void throw_part(throw_run *t, double dt);
/* C follows the tail, and gives way toward W to more than that. */
void throw_follow(throw_run *t, double smallest, double dt);
/* W where the tail, or what is left of it, lets it be. */
void throw_on_leash(throw_run *t, double limit, double dt);

#endif
