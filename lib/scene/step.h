/* A step (step.c), how much of it a call makes (time_slice.c), and how everything is taken down, to go back there (checkpoint.c) or for a saved
 * state (snapshot.c, snapshot_suspended.c). */
#ifndef VBSS_SCENE_STEP_H
#define VBSS_SCENE_STEP_H

#include "scene/scene.h"

/* step.c: begins a step; goes through its parts, to the end or until the rest waits (scene_step_cursor::waits); what follows at the end. */
void vbss_scene_begin_step(scene_object *s, double h);
vbss_result vbss_scene_run_substeps(scene_object *s);
void vbss_scene_finish_step(scene_object *s);
/* The rest of a step that waits is left out: its end may follow. */
void vbss_scene_abandon_step(scene_object *s);
/* How small parts of its steps may be. */
void vbss_scene_set_substep_limits(scene_object *s);
/* What an attempt costs before it is solved, as the last one did; whether steps have a limit of work. */
uint32_t vbss_scene_attempt_cost(const scene_object *s);
bool vbss_scene_has_step_budget(const scene_object *s);
/* Whether a step may be made of parts of that size. */
bool vbss_scene_is_substep_size(const scene_object *s, double size);
/* step.c: work that is done, in products of blocks; whether no more may be. */
void vbss_scene_charge_budget(scene_object *s, uint32_t operations);
bool vbss_scene_is_over_budget(const scene_object *s);
/* snapshot.c */
void vbss_scene_serialise(vbss_stream *stream, void *object);
/* snapshot_suspended.c */
void vbss_scene_visit_cursor(vbss_stream *stream, scene_object *s);

/* checkpoint.c: takes down how everything is, goes back there; counters alone. */
vbss_result vbss_scene_checkpoint(scene_object *s);
void vbss_scene_rollback(scene_object *s);
void vbss_scene_rollback_statistics(scene_object *s);

/* time_slice.c. Ends the step that waits, if one does, without what is left of it. */
vbss_result vbss_scene_abandon_suspended_step(scene_object *s);
/* Tells one state of the threads and drains from what hosts make of it. */
uint64_t vbss_scene_count_edits(const scene_object *s);
vbss_result vbss_scene_ours_step(scene_object *s, double h);
vbss_result vbss_scene_paper_step(scene_object *s, double h); /* paper_step.c */

#endif
