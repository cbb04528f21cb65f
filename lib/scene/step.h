/* A step (step.c), how much of it a call makes (call.c), and how everything is taken down, to go back there (kept.c) or for a saved
 * state (state.c, way_state.c). */
#ifndef VBSS_SCENE_STEP_H
#define VBSS_SCENE_STEP_H

#include "scene/scene.h"

/* step.c: begins a step; goes through its parts, to the end or until the rest waits (scene_way::waits); what follows at the end. */
void vbss_scene_begin_step(scene_object *s, double h);
vbss_result vbss_scene_go_through(scene_object *s);
void vbss_scene_finish_step(scene_object *s);
/* The rest of a step that waits is left out: its end may follow. */
void vbss_scene_give_up(scene_object *s);
/* How small parts of its steps may be. */
void vbss_scene_take_parts(scene_object *s);
/* What an attempt costs before it is solved, as the last one did; whether steps have a limit of work. */
uint32_t vbss_scene_attempt_cost(const scene_object *s);
bool vbss_scene_is_limited(const scene_object *s);
/* Whether a step may be made of parts of that size. */
bool vbss_scene_is_part(const scene_object *s, double size);
/* step.c: work that is done, in products of blocks; whether no more may be. */
void vbss_scene_spend(scene_object *s, uint32_t work);
bool vbss_scene_is_spent(const scene_object *s);
/* state.c */
void vbss_scene_serialise(vbss_stream *stream, void *object);
/* way_state.c */
void vbss_scene_visit_way(vbss_stream *stream, scene_object *s);

/* kept.c: takes down how everything is, goes back there; counters alone. */
vbss_result vbss_scene_keep(scene_object *s);
void vbss_scene_go_back(scene_object *s);
void vbss_scene_return_statistics(scene_object *s);

/* call.c. Ends the step that waits, if one does, without what is left of it. */
vbss_result vbss_scene_end_waiting(scene_object *s);
/* Tells one state of the threads and drains from what hosts make of it. */
uint64_t vbss_scene_count_changes(const scene_object *s);
vbss_result vbss_scene_ours_step(scene_object *s, double h);
vbss_result vbss_scene_paper_step(scene_object *s, double h); /* paper_step.c */

#endif
