/* Method PAPER: the thread of VBLaST-SS (Qi et al. 2017), shared by paper_step.c, paper_forces.c
 * and paper_projection.c. docs/paper-thread.md tells what the paper leaves open and how it was
 * chosen.
 *
 * What its figures mean:
 *   tension: of the projection's multipliers in the last explicit step, plus the spring's; bending
 *     pulls across a segment only, so this is the whole force along it;
 *   stretch error: max |length / rest length - 1|. The thread is inextensible: EA bounds the
 *     springs but sets no stretch;
 *   now.q: acceleration over the last explicit step; now.a: force of what holds the node in it. */
#ifndef VBSS_THREAD_PAPER_H
#define VBSS_THREAD_PAPER_H

#include "thread/thread.h"

/* paper_forces.c: springs and bending of x, whose geometry stands in t->strains, added to forces;
 * clamps point as after that part of the step. */
void vbss_paper_add_internal_forces(const thread_object *t, double part, vec3 *forces);
/* Explicit parts are stable up to dt = 1 / sqrt(rate), at the tensions and turns of this moment;
 * sharp for a straight thread of many equal segments: EI alone gives 4 EI / (density l^4). */
double vbss_paper_rate(thread_object *t);

/* paper_projection.c: moves the nodes of a section until its segments have their rest lengths, and
 * adds to forces what this took at its ends where they are held. False: it did not converge; nodes
 * and forces are as they were. */
bool vbss_paper_project(thread_object *t, uint32_t first, uint32_t last, double dt, vec3 *forces);

#endif
