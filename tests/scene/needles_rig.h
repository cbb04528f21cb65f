/* What the tests of needles in scenes share: tools_rig with needles. */
#ifndef VBSS_TESTS_SCENE_NEEDLES_RIG_H
#define VBSS_TESTS_SCENE_NEEDLES_RIG_H

#include "scene/tools_rig.h"

typedef struct needles_rig {
    tools_rig tools;
    vbss_needle_config config; /* change it before what it makes */
    vbss_needle *needle;
    uint32_t body;
} needles_rig;

void needles_begin(needles_rig *r); /* no scene yet: change tools.s.config, then small_create */
void needles_begin_scene(needles_rig *r);
void needles_end(needles_rig *r);
/* Where config says. */
void needles_add(needles_rig *r);
/* So that the place at that arc length is there, its way to the tip along y, its arc in the plane x y, bent toward -x. */
void needles_add_across(needles_rig *r, double arc, vec3 there);
/* A tool at the origin with jaws along z that open along x holds it 2 mm up from its tip, by the middle of its arc. */
void needles_hold(needles_rig *r);

vbss_needle_state needles_state(const needles_rig *r);
vbss_needle_mass needles_mass(const needles_rig *r);
vec3 needles_place(const needles_rig *r, double arc, vec3 *direction);
pose needles_pose(const needles_rig *r);
/* Of the jaws, in the world. */
pose needles_jaws(const needles_rig *r, uint32_t tool);
/* Kinetic and of gravity. */
double needles_energy(const needles_rig *r);

#endif
