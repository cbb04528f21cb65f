/* Groups: when an island fails, it waits while all others take their substeps, and then takes its
 * own.
 *
 * A step begins with one group of all bodies. A group whose substep fails is divided: the island
 * that failed becomes a group of its own, which waits. The bodies of all groups but the present one
 * are frozen, and are obstacles where they are. Each motion is therefore tested against bodies at
 * rest, and nothing passes through anything. islands.c finds what failed. */
#ifndef VBSS_SCENE_GROUPS_H
#define VBSS_SCENE_GROUPS_H

#include "scene/world/scene_data.h"

/* ---- islands.c */

/* Whether a body takes part in the present substep and moves, or can be moved. */
bool vbss_scene_is_mobile(const scene_object *s, const scene_body *b);

/* Finds the islands of the bodies that take part in the present substep, from the candidates and
 * constraints of the last attempt. Without `has_all_pairs`, there was no room for these, and only
 * grasps, holes and pins connect bodies. */
void vbss_scene_find_islands(scene_object *s, bool has_all_pairs);

/* Whether a body is in the island of another. False if one of them is in none. */
bool vbss_scene_is_in_island(const scene_object *s, const scene_body *b, const scene_body *of);

/* The bodies to which an attempt owes its failure, by number: the pair that collided first, the
 * worst contact, or the worst thread or drain. 0: unknown, or the floor. */
scene_touching_pair vbss_scene_find_blamed_pair(const scene_object *s,
                                                scene_substep_outcome outcome);

/* ---- groups.c */

/* The size of a substep that is halved so often, and the reverse; a fraction of a step. */
double vbss_scene_substep_size(uint32_t halvings);
uint32_t vbss_scene_halvings_of(double size);

/* Puts all bodies in one group at the start of a step, and sets the size of its first substep. */
void vbss_scene_begin_first_group(scene_object *s);

/* Begins with the next group that waits. False: there is none. */
bool vbss_scene_begin_next_group(scene_object *s);

/* Ends the freezing of all bodies at the end of a step. */
void vbss_scene_release_groups(scene_object *s);

/* At the start of a group's first substep: lets islands that begin with smaller substeps wait, also
 * where their motion leaves no room for all pairs (vbss_scene_find_islands). True: the group or the
 * size of its substep has changed, and the attempt begins again. */
bool vbss_scene_split_slow_islands(scene_object *s, bool has_all_pairs);

/* Whether other bodies wait for the island whose attempt is suspended. Between two attempts, or in a
 * divided step, true. */
bool vbss_scene_do_others_wait(scene_object *s);

/* In the step after an overdue one: lets all wait but bodies that nothing touches and that cost
 * little. True: the group is now one of free bodies, and the attempt begins again. */
bool vbss_scene_put_free_bodies_first(scene_object *s);

/* Divides the group after a failed attempt: the island that failed waits and begins with substeps
 * of `size`. False: the group has no other island. */
bool vbss_scene_split_failed_island(scene_object *s, scene_substep_outcome outcome, double size);

/* Divides the group before the island that failed leaves out the rest of the step: all others go
 * on next, with attempts and operations of their own. Does nothing if the group has no other island. */
void vbss_scene_let_others_wait(scene_object *s, scene_touching_pair blamed);

/* Sets the size of the next step's first substep, for the island of the bodies that failed. If
 * they are unknown, for the whole group. */
void vbss_scene_set_next_size(scene_object *s, scene_touching_pair blamed, double size);

#endif
