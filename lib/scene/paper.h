/* Method PAPER: what is near and moved apart (paper_contacts.c), holes, needles, grasps. Its step is paper_step.c. */
#ifndef VBSS_SCENE_PAPER_H
#define VBSS_SCENE_PAPER_H

#include "scene/api/api.h"
#include "scene/world/world.h"

/* paper_holes.c: particles at holes follow their needle at the end of a pass; whether a needle's capsule and a side of a drain
 * are so near to a hole that they do not touch; where a contact of a hole is shown; after a step, who leaves a hole and who
 * makes one. */
vbss_result vbss_scene_paper_carry(scene_object *s, double h);
bool vbss_scene_paper_is_in_hole(const scene_object *s, const scene_body *needle, uint32_t capsule,
                                 const scene_body *drain, uint32_t side);
void vbss_scene_paper_lay_hole(const scene_object *s, scene_contact_record *hit);
void vbss_scene_paper_settle_holes(scene_object *s);
void vbss_scene_paper_forget_toggles_of(scene_object *s, uint32_t number);

/* paper_needles.c: where needles, and what is pinned to them, will be after the step; back, if it fails; then, who has let one
 * go, whom it follows, who has closed on one. */
void vbss_scene_paper_aim_needles(scene_object *s, double h);
void vbss_scene_paper_return_needles(scene_object *s);
void vbss_scene_paper_settle_needles(scene_object *s, double h);

/* paper_grasps.c: what jaws have taken and let go, after a step; what the hand feels of it. */
void vbss_scene_paper_settle_grasps(scene_object *s);
vec3 vbss_scene_paper_hand_force(const scene_object *s, const scene_body *tool);

/* paper_contacts.c: what is near; all of it once, tested and moved apart. At the end, before anything arrives:
 * where the surfaces of what was moved are, and its forces; the deepest overlap of what is near. */
vbss_result vbss_scene_paper_search(scene_object *s);
vbss_result vbss_scene_paper_pass(scene_object *s, double h);
double vbss_scene_paper_measure(scene_object *s, double h);
/* One more, or one more time, was responded to: mass times displacement of its first side. */
vbss_result vbss_scene_paper_note_hit(scene_object *s, const contact_key *key, vec3 normal,
                                      vec3 push);
/* A response of less than this share of D is rounding. */
#define SCENE_NO_DEPTH 1e-9

/* A step of the baseline method. */
vbss_result vbss_scene_paper_step(scene_object *s, double h);

#endif
