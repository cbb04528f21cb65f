/* How each of the contact scenes begins. For contact_scenes.c. */
#ifndef VBSS_TESTS_SCENES_CONTACT_BUILD_H
#define VBSS_TESTS_SCENES_CONTACT_BUILD_H

#include "scenes/contact_scenes.h"

/* m: from where the rod comes that strikes; how far a tool is drawn out. */
#define CONTACT_STRIKE_AWAY 0.01
#define CONTACT_DRAWN_OUT 0.1

vbss_result contact_build_knot(vbss_context *context, contact_scene *scene);
vbss_result contact_build_pulled_open(vbss_context *context, contact_scene *scene);
vbss_result contact_build_many_knots(vbss_context *context, contact_scene *scene);
vbss_result contact_build_interlocked(vbss_context *context, contact_scene *scene);
vbss_result contact_build_sliding_off(vbss_context *context, contact_scene *scene);
vbss_result contact_build_dropped(vbss_context *context, contact_scene *scene);
vbss_result contact_build_beside(vbss_context *context, contact_scene *scene);
vbss_result contact_build_tools(contact_scene *scene);

#endif
