/* Twist of the implicit method: quasi-static, with one torque between two holders.
 * docs/explanation/twist.md has the model.
 *
 * A holder is an attachment that holds the section: a CLAMP or a ROLL. A span is the thread between two
 * holders that follow each other. Its twist is the angle by which the
 * section turns along it, in excess of parallel transport along the chords.
 *
 * A step:
 *
 *   predict -> begin_twist -> [update_twist -> assemble -> solve -> apply increment] until converged
 *   -> commit_twist
 *
 * Each function may be called only if thread_has_twist. */
#ifndef VBSS_THREAD_TWIST_H
#define VBSS_THREAD_TWIST_H

#include "thread/thread.h"

/* Whether the thread resists twist. */
static inline bool thread_has_twist(const thread_object *t)
{
    return t->config.torsional_stiffness > 0.0;
}

/* Whether contacts in a scene resist roll of the thread. */
static inline bool thread_has_friction_torque(const thread_object *t)
{
    return t->config.friction_torque != 0;
}

/* Whether an attachment holds the section of a thread with twist. */
static inline bool thread_holds_section(const thread_attachment *a)
{
    return a->kind == VBSS_THREAD_ATTACHMENT_CLAMP || a->kind == VBSS_THREAD_ATTACHMENT_ROLL;
}

/* ---- twist_spans.c */

/* Place where the thread turns, inside a span or at one of its ends. */
typedef struct thread_turn {
    vec3 before, after; /* unit: of the chords, or of the clamp at an end */
    /* 1 / length of these chords, 1/m; 0 at a clamp, whose direction no node changes */
    double inverse_before, inverse_after;
    double inverse_fold; /* 1 / (1 + their product) */
    vec3 half_binormal;  /* before x after / (1 + their product): half the curvature binormal */
    vec3 mean; /* (before + after) / (1 + their product): unit if the thread is straight */
} thread_turn;

/* First and last node at which a span turns. Without a clamp the end is in its chord. */
static inline uint32_t thread_first_turn(const thread_twist_span *span)
{
    return span->low + (span->is_clamped[0] ? 0 : 1);
}

static inline uint32_t thread_last_turn(const thread_twist_span *span)
{
    return span->high - (span->is_clamped[1] ? 0 : 1);
}

/* The turn of a span at one of these nodes, with the nodes at `x`. */
thread_turn vbss_thread_turn(const vec3 *x, const thread_twist_span *span, uint32_t node);

/* Number of spans in the current state, and one of them, without directors. With friction torque each
 * segment's middle ends a span, else only holders do. */
uint32_t vbss_thread_count_spans(const thread_object *t);
thread_twist_span vbss_thread_twist_span(const thread_object *t, uint32_t index);

/* Sets twist and torque of a span from shape_twist and roll_difference. */
void vbss_thread_set_span_torque(const thread_object *t, thread_twist_span *span);

/* Prepares a substep: spans with their holders at its end. A function of the state and of the holders. */
void vbss_thread_begin_twist(thread_object *t);

/* Sets the twist of a span with the nodes at `x`, which is the one nearest to that of the state. */
void vbss_thread_set_twist(const thread_object *t, const vec3 *x, thread_twist_span *span);

/* Makes the twist of the trial state the state. Before the trial positions become the positions. */
void vbss_thread_commit_twist(thread_object *t);

/* Twist per length of each segment, 1/m, and a unit vector across it that is fixed to the material. */
void vbss_thread_fill_twist_views(thread_object *t);

/* Unit vector along a segment; zero if its nodes coincide. */
vec3 vbss_thread_chord_direction(const vec3 *x, uint32_t segment);

/* Direction of the thread at a holder: that of its chord towards higher nodes, or of the clamp. */
vec3 vbss_thread_holder_direction(const vec3 *x, uint32_t node_count,
                                  const thread_section_holder *holder);

/* ---- contact_rolls.c: friction torque */

/* Forgets the rolls of contacts; then chooses a segment whose roll is an unknown of the next substep. */
void vbss_thread_clear_contact_rolls(thread_object *t);
void vbss_thread_add_contact_roll(thread_object *t, uint32_t segment);

/* The same as vbss_thread_count_spans and vbss_thread_twist_span, with friction torque. */
uint32_t vbss_thread_count_fine_spans(const thread_object *t);
thread_twist_span vbss_thread_fine_span(const thread_object *t, uint32_t index);

/* Lists the spans of a substep in twist_spans, without directors. */
void vbss_thread_list_roll_spans(thread_object *t);

/* Part of a span's roll_difference from rolls of contacts in the trial state, rad. */
double vbss_thread_contact_roll_difference(const thread_object *t, const thread_twist_span *span);

/* Stores the twist of all spans in the trial state as that of their segments. */
void vbss_thread_commit_contact_rolls(thread_object *t);

/* Distance from a node, towards higher nodes if `after`, to where the torque changed in the last substep, m;
 * `largest` if it did not within it (0: no limit). */
double vbss_thread_distance_to_torque(const thread_object *t, uint32_t node, bool after,
                                      double largest);

/* ---- attachments.c: holders of the section */

/* Lists the holders of the section in the order of their nodes. */
void vbss_thread_list_section_holders(thread_object *t);

/* Sets directions and rolls of holders at a fraction 0..1 of the step. */
void vbss_thread_set_section_holders(thread_object *t, double fraction);

/* ---- section_holders.c */

/* Adds a holder to the state, or takes it out: its attachment is in, or still in, the list of attachments.
 * The twist per length of the thread around it does not change. */
void vbss_thread_add_section_holder(thread_object *t, uint32_t attachment);
void vbss_thread_remove_section_holder(thread_object *t, uint32_t attachment);

/* The attachment by which a body of the scene holds the section at a node: it is added, or moved there with
 * the thread's twist. NULL: another one holds the section there, or there is no room. `owner` is not 0;
 * `*is_new`: it did not exist. */
thread_attachment *vbss_thread_hold_section(thread_object *t, uint32_t owner, uint32_t node,
                                            bool *is_new);

/* That attachment, or NULL. */
thread_attachment *vbss_thread_find_section_owner(thread_object *t, uint32_t owner);

/* Derivative of a holder's torque with its roll, N m. */
double vbss_thread_section_stiffness(const thread_object *t, const thread_attachment *a);

/* Removes an attachment that holds the section, by its index; all that belong to bodies of a scene. */
void vbss_thread_release_section(thread_object *t, uint32_t attachment);
void vbss_thread_release_owned_sections(thread_object *t);

/* ---- twist.c */

/* Computes twist_forces, twist_couplings and twist_stiffness from the trial state. */
void vbss_thread_update_twist(thread_object *t, const thread_substep *substep);

/* Largest distance, m, by which forces that the last update did not foresee would move a node of the trial
 * state. It was reached by the increments `u`. */
double vbss_thread_twist_residual(thread_object *t, const vbss_integration *in, const vec3 *u);

/* Energy of twist in the current state, J. */
double vbss_thread_twist_energy(const thread_object *t);

/* Force of twist on one node in the current state, N. */
vec3 vbss_thread_twist_force(const thread_object *t, uint32_t node);

/* Torque with which the holder at a node balances twist in the current state, N m. */
vec3 vbss_thread_twist_torque(const thread_object *t, uint32_t node);

#endif
