/* CCD of a trial state, and truncation of a substep to its safe fraction. */
#ifndef VBSS_SCENE_CCD_H
#define VBSS_SCENE_CCD_H

#include "scene/world/scene_data.h"

/* ---- ccd.c */

/* Tests the motion from start to trial state, and sets `s->time_of_impact` to the fraction of the
 * substep after which the first pair comes too near. Returns ACCEPTED, CCD_HIT, OUT_OF_CAPACITY if
 * the candidates do not fit, or SINGULAR if positions are not finite. */
scene_substep_outcome vbss_scene_run_ccd(scene_object *s);

/* ---- truncate_substep.c */

/* Truncates a substep that no attempt could solve: makes the safe fraction of the trial state the
 * state. Returns that fraction, 0..1. */
double vbss_scene_truncate_substep(scene_object *s, scene_substep_outcome outcome,
                                   const scene_substep *substep);

/* Resets the trial state to the start of the substep after a rejected attempt. Contacts, which
 * views show, get the forces of that state. */
void vbss_scene_reject_substep(scene_object *s);

#endif
