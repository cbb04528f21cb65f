/* What the tests of the drain share: one drain in a watched context, held, loaded, stepped and read through the
 * public interface only. Every call that fails, fails the test. */
#ifndef VBSS_TESTS_DRAIN_RIG_H
#define VBSS_TESTS_DRAIN_RIG_H

#include "harness/harness.h"

typedef struct drain_rig {
    harness_memory memory;
    vbss_context *context;
    vbss_drain_config config; /* the defaults; change it before making the drain */
    vbss_drain *drain;
    vbss_drain_places places;
} drain_rig;

/* The rig must stay where it is until its end. */
void drain_rig_begin(drain_rig *r);
void drain_rig_make(drain_rig *r);
void drain_rig_end(drain_rig *r);

/* Each returns the attachment's id. */
uint32_t drain_rig_pin(drain_rig *r, uint32_t node, vec3 position);
uint32_t drain_rig_pin_here(drain_rig *r, uint32_t node);
uint32_t drain_rig_force(drain_rig *r, uint32_t node, vec3 force);
uint32_t drain_rig_spring(drain_rig *r, uint32_t node, vec3 position, double stiffness);
void drain_rig_move(drain_rig *r, uint32_t id, vec3 target);
void drain_rig_detach(drain_rig *r, uint32_t id);
/* Both marks are pulled towards each other by so much, along the frame's z. */
void drain_rig_pull_marks(drain_rig *r, double force);

void drain_rig_run(drain_rig *r, double h, uint32_t steps);
/* Each step is a Newton iteration to rest: big steps, nothing halved, tangent and forces until they agree. */
void drain_rig_statics(drain_rig *r);
/* Long steps until no node is faster than `speed`, at most `limit` steps; then the test fails. */
void drain_rig_relax(drain_rig *r, double speed, uint32_t limit);

uint32_t drain_rig_count(drain_rig *r, vbss_drain_field field);
const vec3 *drain_rig_vectors(drain_rig *r, vbss_drain_field field);
const uint32_t *drain_rig_numbers(drain_rig *r, vbss_drain_field field);
vec3 drain_rig_position(drain_rig *r, uint32_t node);
vec3 drain_rig_reaction(drain_rig *r, uint32_t id);
double drain_rig_fastest(drain_rig *r);
vec3 drain_rig_anchor_sum(drain_rig *r);
vbss_drain_gap drain_rig_gap(drain_rig *r);
vbss_drain_energies drain_rig_energies(drain_rig *r);
vbss_drain_statistics drain_rig_statistics(drain_rig *r);
uint64_t drain_rig_hash(drain_rig *r);

/* Tears a drain off that was made with a tear_stress of 1 Pa, and puts it back to rest. */
void drain_rig_tear_off(drain_rig *r);

/* A third of the triangles around each node at rest, m^2, and what that weighs, kg: worked out from the views. */
void drain_rig_areas(drain_rig *r, double *areas);
void drain_rig_masses(drain_rig *r, double *masses);
/* Most nodes of the drains whose nodes tests list. */
enum { DRAIN_RIG_NODES = 1024 };
/* Largest distance of a node from its place in `positions`. */
double drain_rig_distance(drain_rig *r, const vec3 *positions);
void drain_rig_copy(drain_rig *r, vec3 *positions);
bool drain_rig_is_anchor(drain_rig *r, uint32_t node);

#endif
