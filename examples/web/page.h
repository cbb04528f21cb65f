/* One session behind the calls of a page: in WebAssembly a worker makes them, natively a test. Sides are 0 left, 1 right; results
 * are those of the library. Texts and arrays stay valid until the next call of the same function. */
#ifndef VBSS_EXAMPLES_WEB_PAGE_H
#define VBSS_EXAMPLES_WEB_PAGE_H

#include <stdint.h>

/* By its name among the exports of the module. */
#ifdef __wasm__
#define PAGE_CALL(type, name) __attribute__((export_name(#name))) type name
#else
#define PAGE_CALL(type, name) type name
#endif

/* ---- page.c: the session */

/* Ends the one before. Scenes are numbered as live_at has them; the log goes to the file "log.vbss" of the working folder, or of
 * the page. */
PAGE_CALL(int32_t, page_begin)(int32_t scene, uint32_t seed);
/* Steps of a millisecond, as many as succeed. */
PAGE_CALL(int32_t, page_step)(int32_t count);
/* Ends the log. */
PAGE_CALL(int32_t, page_end)(void);
/* Why the last call failed. */
PAGE_CALL(const char *, page_problem)(void);
/* Of the scene; of the session, 0 if the scene has none. */
PAGE_CALL(uint64_t, page_scene_hash)(void);
PAGE_CALL(uint64_t, page_session_hash)(void);

/* ---- page.c: hands by mouse and keys, as mouse_hand.h has them */

PAGE_CALL(void, page_move)(int32_t side, int32_t turns, double right, double up, double away);
PAGE_CALL(void, page_close)(int32_t side, int32_t closes);
PAGE_CALL(int32_t, page_clutch)(int32_t side, int32_t held);
/* Deflections of a gamepad's sticks, -1 to 1: three translations in the picture (right, up, away) and three rotations about these
 * axes, the last one about the tool's own. They hold until the next call. A smaller grain is slower. */
PAGE_CALL(void, page_pull)
(int32_t side, double right, double up, double away, double nod, double turn, double roll,
 double grain);
/* The other kind of tool: needle driver or shears. */
PAGE_CALL(int32_t, page_exchange)(int32_t side);

/* ---- tracked.c: hands by controllers */

/* From now on a controller has that hand, or the mouse again. */
PAGE_CALL(int32_t, page_track)(int32_t side, int32_t is_tracked);
/* Where a controller holds its tool's tip, m, quaternion w, x, y, z, of the world; jaws 0 closed to 1 open. The tool goes
 * there within `seconds`; while clutched its place stays, and it is turned. */
PAGE_CALL(void, page_pose)
(int32_t side, double x, double y, double z, double qw, double qx, double qy, double qz, double jaw,
 int32_t clutched, double seconds);

/* ---- replayed.c: a saved log in place of hands */

/* Room for so many bytes of a log; 0: there is none. It stays until page_replay takes it. */
PAGE_CALL(uint8_t *, page_room)(uint32_t bytes);
/* Ends the session before, and begins the log that was put there: its scene before the first step. Its steps are made by page_step,
 * and none follows its last one. */
PAGE_CALL(int32_t, page_replay)(void);
/* To after that step. */
PAGE_CALL(int32_t, page_seek)(uint32_t step);

/* ---- practised.c: exercises and aids */

/* As page_begin: an exercise of session_exercise.h. The states at which exercises start were put in the room of page_room; the
 * first exercise needs none. */
PAGE_CALL(int32_t, page_exercise)(int32_t exercise);
/* VBSS_SESSION_AID_ bits of the aids that are on from the next step on. */
PAGE_CALL(int32_t, page_set_aids)(uint32_t aids);

/* ---- ghosts.c: an expert's tools beside the person's */

/* The file of a track of ghost hands, which was put in the room of page_room; it stays for all sessions. */
PAGE_CALL(int32_t, page_take_ghost)(void);
/* Shows or hides them in this session, from the beginning of the phase. */
PAGE_CALL(int32_t, page_show_ghost)(int32_t is_shown);
/* The source of their parts in the meshes; 0: they are hidden. */
PAGE_CALL(uint32_t, page_ghost)(void);

/* ---- picture.c */

/* The camera: turned to the right about the vertical, looking down by so much, that far away; width over height. */
PAGE_CALL(void, page_set_camera)(double aside, double down, double away, double aspect);
/* Of the scene: aside and away to begin with; down. */
PAGE_CALL(const double *, page_first_camera)(void);
/* Floats: matrices of view and lamp (16, 16), eye, lamp, target (3, 3, 3), clear distance, light, share of the clear distance
 * within which a tool is not seen, barrel of the lens and its spread. */
PAGE_CALL(const float *, page_view)(void);
/* Meshes of the scene as it is: for each array of vbss_visual_field the address and the number of rows. NULL: it failed. */
PAGE_CALL(const uint32_t *, page_draw)(void);
/* The programs of the desktop viewer: 0, 1 materials, 2, 3 lens, 4, 5 shadow, each vertex, then fragment. */
PAGE_CALL(const char *, page_program)(int32_t number);

/* ---- state.c */

/* Task, measures, tools and what has happened since the last call, as JSON. */
PAGE_CALL(const char *, page_state)(void);

#endif
