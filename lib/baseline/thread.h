/* The thread of VBLaST-SS (Qi et al. 2017): state, forces and projection. docs/paper-thread.md tells what the paper leaves
 * open and how it was chosen.
 *
 * Fields of thread_object that mean something else here:
 *   now.tension: of the projection's multipliers in the last explicit step, plus the spring's; bending
 *     pulls across a segment only, so this is the whole force along it;
 *   now.q: acceleration over the last explicit step; now.a: force that holds a prescribed node in it.
 * The stretch error is max |length / rest length - 1|. The thread is inextensible: EA bounds the springs but sets no
 * stretch. */
#ifndef VBSS_BASELINE_THREAD_H
#define VBSS_BASELINE_THREAD_H

#include "thread/thread.h"

/* Of node i and of segment i, within a step. */
typedef struct baseline_thread_row {
    double inverse_mass; /* of the node, resistance times dt counted as mass; 0: held */
    double resistance;   /* of the node to its velocity: drag and attached springs, N s/m */
    double inverse_rest; /* of the segment */
    double stiffness;    /* of the segment's spring, N/m */
    double multiplier;   /* of its constraint in the explicit step under way: tension times dt^2 */
    vec3 edge;           /* over its rest length, with its square */
    double square;
    double right,
        ratio; /* of the tridiagonal system: right-hand side, then solution; elimination */
} baseline_thread_row;

/* Counts of the step under way; vbss_thread_statistics gets them at its end. */
typedef struct baseline_thread_counts {
    uint32_t iterations;         /* of all projections */
    uint32_t failed_projections; /* sections whose projection did not converge */
} baseline_thread_counts;

typedef struct baseline_thread {
    baseline_thread_row *rows; /* one per node */
    baseline_thread_counts counts;
} baseline_thread;

/* thread_step.c: one step of h seconds, as thread_method asks for it; the force that holds a node whose motion is
 * prescribed, at the end of the last step, N. */
vbss_result vbss_baseline_thread_step(thread_object *t, double h);
vec3 vbss_baseline_constraint_force(const thread_object *t, uint32_t node);
/* Measures the strains of now.x, and their largest for the statistics of the last step. */
void vbss_baseline_record_stretch(thread_object *t);

/* thread_forces.c: springs and bending of now.x, whose geometry stands in t->strains, added to forces;
 * clamps point as after that fraction of the step. */
void vbss_baseline_add_internal_forces(const thread_object *t, double fraction, vec3 *forces);
/* Explicit steps are stable up to dt = 1 / sqrt(rate), at the present tensions and turns;
 * sharp for a straight thread of many equal segments: EI alone gives 4 EI / (density l^4). */
double vbss_baseline_thread_rate(thread_object *t);
/* As thread_method asks for them. */
double vbss_baseline_bending_energy(const thread_object *t);
vec3 vbss_baseline_reaction_torque(const thread_object *t, uint32_t node);

/* thread_projection.c: moves the nodes of a section until its segments have their rest lengths, and
 * adds to forces what this took at its ends where they are held. False: it did not converge; nodes
 * and forces are as they were. */
bool vbss_baseline_project_section(thread_object *t, uint32_t first, uint32_t last, double dt,
                                   vec3 *forces);

#endif
