/* What the tests of the thread share: one thread in a watched context, held, loaded, stepped and
 * read through the public interface only. Every call that fails, fails the test. */
#ifndef VBSS_TESTS_THREAD_RIG_H
#define VBSS_TESTS_THREAD_RIG_H

#include "harness/harness.h"

#include <vblast_ss/thread.h>

typedef struct rig {
    harness_memory memory;
    vbss_context *context;
    vbss_thread *thread;
    uint32_t nodes;
} rig;

/* The defaults (the paper's thread along +x from the origin, gravity down -y) with that length. */
vbss_thread_config rig_config(double length, uint32_t segments);
/* The rig must stay where it is until its end. */
void rig_begin(rig *r, const vbss_thread_config *config);
void rig_end(rig *r);

/* Each returns the attachment's id. */
uint32_t rig_pin(rig *r, uint32_t node, vec3 position);
uint32_t rig_clamp(rig *r, uint32_t node, vec3 position, vec3 direction);
uint32_t rig_force(rig *r, uint32_t node, vec3 force);
uint32_t rig_spring(rig *r, uint32_t node, vec3 position, double stiffness, double damping);
uint32_t rig_mass(rig *r, uint32_t node, double mass);
/* Clamps or pins the node where it is now. */
uint32_t rig_clamp_here(rig *r, uint32_t node, vec3 direction);
uint32_t rig_pin_here(rig *r, uint32_t node);
void rig_move(rig *r, uint32_t id, vec3 target); /* directions stay */

void rig_run(rig *r, double h, uint32_t steps);
/* Steps until no node is faster than `speed` (m/s), at most `limit` steps; then the test fails.
 * Give the thread drag. Returns the steps made. */
uint32_t rig_relax(rig *r, double h, double speed, uint32_t limit);

vec3 rig_position(rig *r, uint32_t node);
vec3 rig_velocity(rig *r, uint32_t node);
vec3 rig_curvature(rig *r, uint32_t node);
vec3 rig_tip(rig *r);
double rig_tension(rig *r, uint32_t segment);
double rig_fastest(rig *r); /* largest speed of a node */
/* All nodes at once, of a field of vectors. */
void rig_read(rig *r, vbss_thread_field field, vec3 *values);
/* NULL leaves what is there. */
void rig_place(rig *r, const vec3 *positions, const vec3 *velocities);

/* All that moves, of a thread of at most RIG_SHAPE_NODES nodes. */
enum { RIG_SHAPE_NODES = 16 };
typedef struct rig_shape {
    uint32_t nodes;
    vec3 x[RIG_SHAPE_NODES], v[RIG_SHAPE_NODES];
    double tension[RIG_SHAPE_NODES];
} rig_shape;
rig_shape rig_shape_of(rig *r);
/* Largest differences of position, velocity, tension. */
vec3 rig_difference(const rig_shape *a, const rig_shape *b);

vec3 rig_reaction_force(rig *r, uint32_t id);
vec3 rig_reaction_torque(rig *r, uint32_t id);
vbss_thread_energies rig_energies(rig *r);
vbss_thread_momentum rig_momentum(rig *r);
vbss_thread_statistics rig_statistics(rig *r);
vbss_baseline_statistics rig_baseline_statistics(rig *r);

#endif
