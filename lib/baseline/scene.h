/* A scene of VBLaST-SS (Qi et al. 2017): the state in scene_object.baseline, and the stages of a
 * step. docs/explanation/paper-scene.md and docs/explanation/paper-needle.md list the points that the paper leaves open. */
#ifndef VBSS_BASELINE_SCENE_H
#define VBSS_BASELINE_SCENE_H

#include "baseline/puncture.h"
#include "scene/tuning.h"
#include "scene/world/world.h"

typedef struct baseline_body {
    /* needles */
    uint32_t leader; /* body number of the tool that leads it; 0: none */
    baseline_toggle toggles[BASELINE_TOGGLES];
    /* tools */
    bool has_closed_jaws; /* closed in this step, and nothing taken yet */
} baseline_body;

/* Counts of the current step; the statistics receive them at its end. */
typedef struct baseline_scene_counts {
    uint32_t passes;
    uint32_t responses; /* in the current pass */
    uint64_t tested_pairs;
    bool has_converged; /* the last pass had no responses */
} baseline_scene_counts;

typedef struct baseline_scene {
    baseline_body *bodies; /* in the order of scene_object.bodies */
    /* Per entry of scene_object.thread_grasps: the pin of the held node; 0: another tool leads. */
    uint32_t *grasp_pins;
    /* Contacts of the step, in ascending order of keys. During the passes `force` is mass times
     * displacement, kg m. */
    scene_contact_record *contacts;
    uint32_t contact_count;
    baseline_scene_counts counts;
    vbss_baseline_statistics statistics; /* sign_tests_ended is in the collision object */
} baseline_scene;

static inline baseline_body *baseline_body_of(const scene_object *s, const scene_body *b)
{
    return &s->baseline->bodies[b - s->bodies];
}

/* ---- scene_step.c: step_scene of scene_method, a step of h seconds */
vbss_result vbss_baseline_scene_step(scene_object *s, double h);

/* ---- contacts.c */

/* Broad phase: finds the candidate pairs. */
vbss_result vbss_baseline_find_candidates(scene_object *s);

/* Tests each candidate pair once, and moves apart the pairs that hit. */
vbss_result vbss_baseline_run_pass(scene_object *s, double h);

/* Adds one response to the contact of these features. `push` is mass times displacement of the
 * first side, kg m. */
vbss_result vbss_baseline_record_contact(scene_object *s, const contact_key *key, vec3 normal,
                                         vec3 push);

/* After the passes: computes forces and geometry of the contacts. Returns the largest overlap of
 * contacts and candidates, m. */
double vbss_baseline_measure_contacts(scene_object *s, double h);

/* publish_contacts and list_touching_pairs of scene_method. */
void vbss_baseline_publish_contacts(scene_object *s);
void vbss_baseline_list_touching_pairs(scene_object *s);

/* ---- holes.c */

/* Moves the particles at holes with their needles, at the end of a pass. */
vbss_result vbss_baseline_carry_holes(scene_object *s, double h);

/* Returns whether an edge of a drain is so near to a hole that a capsule of the needle does not
 * collide with it. */
bool vbss_baseline_is_in_hole(const scene_object *s, const scene_body *needle, uint32_t capsule,
                              const scene_body *drain, uint32_t side);

/* Sets point and gap of a contact at a hole. */
void vbss_baseline_locate_hole_contact(const scene_object *s, scene_contact_record *hit);

/* After a step: closes the holes that needles have left, and adds those of new punctures. */
void vbss_baseline_update_holes(scene_object *s);

/* Clears the toggles of a drain that leaves the scene. */
void vbss_baseline_forget_toggles(scene_object *s, uint32_t number);

/* ---- needles.c */

/* Sets the targets of needles, and of nodes pinned to them, for the end of the step. */
void vbss_baseline_set_needle_targets(scene_object *s, double h);

/* After a step: tools release needles, grasp them, and take the lead of free ones. */
void vbss_baseline_update_needles(scene_object *s, double h);

/* Frees the needles that a tool leads. */
void vbss_baseline_forget_leader(scene_object *s, uint32_t number);

/* ---- grasps.c */

/* Sets the targets of the nodes that graspers carry. */
void vbss_baseline_set_carried_targets(scene_object *s);

/* After a step: jaws release nodes and grasp them. */
void vbss_baseline_update_grasps(scene_object *s);

/* Returns the force on the hand from the nodes that a tool carries, N. */
vec3 vbss_baseline_hand_force(const scene_object *s, const scene_body *tool);

#endif
