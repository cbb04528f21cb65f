/* Continuous collision detection of a trial state, and its truncation. */
#ifndef VBSS_SCENE_CCD_H
#define VBSS_SCENE_CCD_H

#include "scene/world/scene_data.h"

/* ---- ccd.c */

scene_substep_outcome vbss_scene_run_ccd(scene_object *s);

/* ---- truncate_substep.c */

/* As much of the trial state as does no harm becomes the state. Returns the share. */
double vbss_scene_truncate_substep(scene_object *s, scene_substep_outcome outcome,
                                   const scene_substep *substep);

/* Nothing moves after an attempt that was not accepted: rows, which are shown, say what contact does where things are. */
void vbss_scene_reject_substep(scene_object *s);

#endif
