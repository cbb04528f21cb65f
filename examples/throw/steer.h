/* Where things are about W, and how C keeps the limb taut. */
#ifndef VBSS_EXAMPLES_THROW_STEER_H
#define VBSS_EXAMPLES_THROW_STEER_H

#include "throw/throw.h"

#define PI 3.14159265358979324

/* Across W's jaws, at some distance from the tip. */
typedef struct steer_frame {
    vec origin, u, over, away; /* u: from the tip to the handle */
} steer_frame;

steer_frame steer_about_w(const throw_run *t, double s);
vec steer_on_orbit(const steer_frame *f, double phi, double rho);
/* Where limb and tail come out. */
vec steer_limb_root(const throw_run *t);
vec steer_tail_root(const throw_run *t);
/* Where C's tip is when its jaws are at a place; where jaws are. */
vec steer_tip_of(const throw_run *t, vec jaws);
vec steer_jaws_of(const hand_pose *p);

/* C on its orbit, at its angle. */
void steer_keep_taut(throw_run *t, double speed, double dt);
/* C while W goes for the tail. */
void steer_keep(throw_run *t, double dt);
/* C stays, and gives way when the limb is taut. */
void steer_yield(throw_run *t);

#endif
