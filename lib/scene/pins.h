/* Nodes of threads that are pinned or welded to bodies (pins.c). */
#ifndef VBSS_SCENE_PINS_H
#define VBSS_SCENE_PINS_H

#include "scene/scene.h"

/* pins.c: what the public functions do. */
vbss_result vbss_scene_pin_in_step(scene_object *s, uint32_t thread, uint32_t node, uint32_t body,
                                   uint32_t *pin);
void vbss_scene_unpin_in_step(scene_object *s, uint32_t pin);
void vbss_scene_remove_pins_of(scene_object *s, uint32_t number);
/* Whether it still holds its node: the host may have detached the attachment. */
bool vbss_scene_pin_holds(const scene_object *s, const scene_pin *pin);
/* The weld of a node, or NULL. */
const scene_pin *vbss_scene_find_weld(const scene_object *s, uint32_t thread, uint32_t node);
/* Whether a segment is so near to a pin on the body, or to the jaws' grasp, along the thread, that it does not
 * touch that capsule of it. */
bool vbss_scene_is_excluded_at_pin(const scene_object *s, const scene_body *thread,
                                   uint32_t segment, const scene_body *rigid, uint32_t capsule,
                                   double contact_distance);
/* Attached nodes shall be where their driven bodies will be. */
void vbss_scene_set_pin_targets(scene_object *s);

#endif
