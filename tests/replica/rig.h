/* What the tests of replicas share: the same numbers from a scene by its own functions, and from a replica of it. */
#ifndef VBSS_TESTS_REPLICA_RIG_H
#define VBSS_TESTS_REPLICA_RIG_H

#include "base/hash.h"
#include "harness/harness.h"

/* Hash of all bodies, nodes, poses, jaws, capsules, holes and contacts, of the number of steps and the time. */
uint64_t rig_hash_scene(vbss_scene *scene);
/* The same of the state that the replica's reader took last. */
uint64_t rig_hash_replica(vbss_replica *replica, const vbss_replica_state *state);
/* Takes a state, which must be a new one. */
vbss_replica_state rig_take(vbss_replica *replica);
vbss_view rig_view(vbss_replica *replica, vbss_replica_field field);
/* Publishes, takes, and asserts that both hashes are the same. */
void rig_expect_equal(vbss_replica *replica, vbss_scene *scene);

#endif
