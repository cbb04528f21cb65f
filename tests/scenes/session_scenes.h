/* Scenes with all that a session wants: a thread, a needle, a drain and two tools. The same for tests and the determinism
 * table. */
#ifndef VBSS_TESTS_SCENES_SESSION_SCENES_H
#define VBSS_TESTS_SCENES_SESSION_SCENES_H

#include <vblast_ss/session.h>

#include "scenes/stitch_scenes.h"

typedef struct session_scene {
    vbss_scene *scene;
    vbss_drain *drain;
    vbss_needle *needle;
    vbss_thread *thread;
    vbss_grasper *tools[2];
    vbss_session_config config; /* with the numbers of its bodies */
    stitch_scene stitch;        /* of a tying one */
} session_scene;

/* Nothing touches anything, and nothing moves. */
vbss_result session_scene_still(vbss_context *context, session_scene *made);
/* The thread lies through both marks, with so many crossings above the slit (stitch_scenes.h); needle and tools stand aside.
 * The configuration has a detector and a measurement. */
vbss_result session_scene_tying(vbss_context *context, uint32_t crossings, session_scene *made);

/* A hand turns the needle through both walls and back (puncture_scenes.h), without a tool; the thread lies aside. */
vbss_result session_scene_piercing(vbss_context *context, session_scene *made);
/* Two tools hand a needle over and drop it (needle_scenes.h), far from the drain; who moves them is up to the caller. */
vbss_result session_scene_floor(vbss_context *context, session_scene *made);
/* All of it but detector and measurement, also of one that was made in part. */
vbss_result session_scene_end(session_scene *s);

#define SESSION_SCENE_STEP 1e-3 /* s */
/* Hands draw the throw tight (stitch_scene_tie), through the session's record if it has one; then the session is stepped. What
 * hands do follows from the scene alone. */
vbss_result session_scene_tie(session_scene *s, vbss_session *session, vbss_record *record);

#endif
