/* A scene of VBLaST-SS (Qi et al. 2017): state that scene_object points to, and the stages of a step. docs/paper-scene.md and
 * docs/paper-needle.md tell what the paper leaves open. */
#ifndef VBSS_BASELINE_SCENE_H
#define VBSS_BASELINE_SCENE_H

#include "baseline/puncture.h"
#include "scene/tuning.h"
#include "scene/world/world.h"

typedef struct baseline_body {
    /* of a needle */
    uint32_t leader; /* number of the tool that it follows; 0: it is free */
    baseline_toggle toggles[BASELINE_TOGGLES];
    /* of a tool */
    bool has_closed_jaws; /* in this step, on nothing yet */
} baseline_body;

/* Counts of the step under way; vbss_scene_statistics gets them at its end. */
typedef struct baseline_scene_counts {
    uint32_t passes;
    uint32_t responses; /* of the pass under way */
    uint64_t tested_pairs;
    bool has_converged; /* the last pass had no responses */
} baseline_scene_counts;

typedef struct baseline_scene {
    baseline_body *bodies; /* in the order of scene_object.bodies */
    /* In the order of scene_object.thread_grasps: the pin of the held node; 0: another tool leads. */
    uint32_t *grasp_pins;
    /* Of the step, in ascending order of keys. During the passes `force` is mass times displacement, kg m. */
    scene_contact_record *contacts;
    uint32_t contact_count;
    baseline_scene_counts counts;
} baseline_scene;

static inline baseline_body *baseline_body_of(const scene_object *s, const scene_body *b)
{
    return &s->baseline->bodies[b - s->bodies];
}

/* ---- scene_step.c: a step of h seconds, as scene_method asks for it */
vbss_result vbss_baseline_scene_step(scene_object *s, double h);

/* ---- contacts.c */

/* Finds the pairs that are near. */
vbss_result vbss_baseline_find_candidates(scene_object *s);

/* Tests each pair once, and moves apart those that hit. */
vbss_result vbss_baseline_run_pass(scene_object *s, double h);

/* Adds to the contact of these features one response: mass times displacement of the first side. */
vbss_result vbss_baseline_record_contact(scene_object *s, const contact_key *key, vec3 normal,
                                         vec3 push);

/* After the passes: forces of the contacts, and where their surfaces are. Returns the deepest overlap of near pairs, m. */
double vbss_baseline_measure_contacts(scene_object *s, double h);

/* As scene_method asks for them. */
void vbss_baseline_publish_contacts(scene_object *s);
void vbss_baseline_list_touching_pairs(scene_object *s);

/* ---- holes.c */

/* Particles at holes follow their needle at the end of a pass. */
vbss_result vbss_baseline_carry_holes(scene_object *s, double h);

/* Whether a capsule of a needle and a side of a drain are so near to a hole that they do not touch. */
bool vbss_baseline_is_in_hole(const scene_object *s, const scene_body *needle, uint32_t capsule,
                              const scene_body *drain, uint32_t side);

/* Sets point and gap of a contact of a hole. */
void vbss_baseline_locate_hole_contact(const scene_object *s, scene_contact_record *hit);

/* After a step: closes the holes that needles have left, and makes those that they have made. */
void vbss_baseline_update_holes(scene_object *s);

/* Forgets the toggles of a drain that leaves the scene. */
void vbss_baseline_forget_toggles(scene_object *s, uint32_t number);

/* ---- needles.c */

/* Sets where needles, and what is pinned to them, will be after the step. */
void vbss_baseline_set_needle_targets(scene_object *s, double h);

/* After a step that failed: the targets are where the needles are. */
void vbss_baseline_reset_needle_targets(scene_object *s);

/* After a step: tools release needles, take them, and lead those that are free. */
void vbss_baseline_update_needles(scene_object *s, double h);

/* The needles that a tool leads are free again. */
void vbss_baseline_forget_leader(scene_object *s, uint32_t number);

/* ---- grasps.c */

/* Moves the targets of the nodes that graspers carry. */
void vbss_baseline_set_carried_targets(scene_object *s);

/* After a step: jaws release nodes and take them. */
void vbss_baseline_update_grasps(scene_object *s);

/* The force of what a tool carries on its hand, N. */
vec3 vbss_baseline_hand_force(const scene_object *s, const scene_body *tool);

#endif
