/* The thread of VBLaST-SS (Qi et al. 2017): state, forces and projection. docs/explanation/paper-thread.md
 * lists the points that the paper leaves open, and the choices here.
 *
 * Some fields of thread_object have another meaning here:
 *   now.tension: sum of the projection's multipliers in the last explicit substep and of the spring
 *     force; bending acts across a segment only, so this is the whole force along it;
 *   now.q: acceleration over the last explicit substep;
 *   now.a: force that holds a prescribed node during that substep.
 * The stretch error is max |length / rest length - 1|. The thread is inextensible: EA limits the
 * stiffness of the springs but causes no stretch. */
#ifndef VBSS_BASELINE_THREAD_H
#define VBSS_BASELINE_THREAD_H

#include "thread/thread.h"

/* Quantities of node i and of segment i within a step. */
typedef struct baseline_thread_row {
    double inverse_mass; /* node: resistance times dt counts as mass; 0: prescribed */
    double resistance;   /* node: force per velocity of drag and attached springs, N s/m */
    double inverse_rest; /* segment: 1 / rest length, 1/m */
    double stiffness;    /* segment: stiffness of its spring, N/m */
    double multiplier;   /* segment: multiplier in this substep, tension times dt^2 */
    vec3 edge;           /* segment: vector over rest length; its square */
    double square;
    /* Tridiagonal system: right-hand side, then solution; elimination factor. */
    double right, ratio;
} baseline_thread_row;

/* Counts of the current step; the statistics receive them at its end. */
typedef struct baseline_thread_counts {
    uint32_t iterations;         /* sum over all projections */
    uint32_t failed_projections; /* sections whose projection did not converge */
} baseline_thread_counts;

typedef struct baseline_thread {
    baseline_thread_row *rows; /* one per node */
    baseline_thread_counts counts;
    /* Counters of all steps, and those before the current step of the scene. */
    vbss_baseline_statistics statistics, saved_statistics;
} baseline_thread;

/* thread_step.c: step_thread of thread_method, a step of h seconds. */
vbss_result vbss_baseline_thread_step(thread_object *t, double h);
/* Returns the force that holds a prescribed node at the end of the last step, N. */
vec3 vbss_baseline_constraint_force(const thread_object *t, uint32_t node);
/* Measures the strains of now.x, and their maxima for the statistics of the last step. */
void vbss_baseline_record_stretch(thread_object *t);

/* thread_forces.c: adds the forces of springs and bending at now.x to `forces`. t->strains must
 * hold the geometry of now.x. Clamps have their direction at that fraction of the step. */
void vbss_baseline_add_internal_forces(const thread_object *t, double fraction, vec3 *forces);
/* Returns the rate, 1/s^2, for which explicit substeps are stable up to dt = 1 / sqrt(rate) at
 * the present tensions and turns. It is sharp for a straight thread of many equal segments,
 * where EI alone gives 4 EI / (density l^4). */
double vbss_baseline_thread_rate(thread_object *t);
/* bending_energy and reaction_torque of thread_method. */
double vbss_baseline_bending_energy(const thread_object *t);
vec3 vbss_baseline_reaction_torque(const thread_object *t, uint32_t node);

/* thread_projection.c: moves the nodes of a section until its segments have their rest lengths,
 * and adds the reactions at prescribed ends to `forces`. Returns false, with nodes and forces
 * unchanged, if it does not converge. */
bool vbss_baseline_project_section(thread_object *t, uint32_t first, uint32_t last, double dt,
                                   vec3 *forces);

#endif
