/* What a step tells: events.c, contact_forces.c. */
#ifndef VBSS_SCENE_EVENTS_H
#define VBSS_SCENE_EVENTS_H

#include "scene/scene.h"

/* events.c: at the end of a step. */
void vbss_scene_clear_events(scene_object *s);
void vbss_scene_add_event(scene_object *s, vbss_event_kind kind, uint32_t a, uint32_t b,
                          uint32_t number);
void vbss_scene_update_touching_pairs(scene_object *s);
void vbss_scene_write_lost_event(scene_object *s);
/* contact_forces.c: the force of a row on its first side, N, with which all balances, and whether it bears any; what contacts and pins do to
 * the rigid bodies; views of contacts. */
bool vbss_scene_find_contact_force(const contact_set *set, uint32_t i, vec3 *force);
void vbss_scene_collect_forces(scene_object *s);

#endif
