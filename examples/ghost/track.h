/* The hands of an expert through the phases of the task, taken from a recorded log: the poses of both tools, 25 a second.
 *
 * The file: a line of text; for each phase of the task its first row, its number of rows, both marks and the pose of the needle
 * as the phase began; then the rows. Numbers have the lower byte first. A row takes 32 bytes: positions in steps of 10 um. */
#ifndef VBSS_EXAMPLES_GHOST_TRACK_H
#define VBSS_EXAMPLES_GHOST_TRACK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <vblast_ss/session.h>

#define GHOST_INTERVAL 0.04 /* s, from row to row */

enum { GHOST_PHASES = VBSS_SESSION_PHASE_DONE, GHOST_SIDES = 2 };

/* A tool. */
typedef struct ghost_pose {
    double position[3];    /* of the tip, m */
    double orientation[4]; /* w, x, y, z */
    double opening;        /* of its handle, 0 to 1 */
    int32_t kind;          /* a VBSS_GRASPER_KIND_ constant */
} ghost_pose;

/* What the scene was like as a phase began. */
typedef struct ghost_scene {
    double marks[2][3]; /* m */
    double needle[7];   /* origin of its frame, m; quaternion w, x, y, z */
} ghost_scene;

typedef struct ghost_phase {
    uint32_t first, count; /* rows; no rows: the log does not have the phase */
    ghost_scene scene;
} ghost_phase;

typedef struct ghost_track {
    ghost_phase phases[GHOST_PHASES];
    ghost_pose (*rows)[GHOST_SIDES];
    uint32_t count;
} ghost_track;

/* Room for one row more, which is zero; NULL: no memory. */
ghost_pose *ghost_track_add(ghost_track *t);
void ghost_track_free(ghost_track *t);
/* False: they are no track. The bytes stay the caller's. */
bool ghost_track_parse(ghost_track *t, const uint8_t *bytes, size_t count);
/* False: the file is wrong, or cannot be made; `why` names the fault. */
bool ghost_track_read(ghost_track *t, const char *path, char *why, size_t why_bytes);
bool ghost_track_write(const ghost_track *t, const char *path, char *why, size_t why_bytes);

#endif
