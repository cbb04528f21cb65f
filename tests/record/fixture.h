/* What the tests of records share: a scene in which much is told, and logs taken apart by the page's word. */
#ifndef VBSS_TESTS_RECORD_FIXTURE_H
#define VBSS_TESTS_RECORD_FIXTURE_H

#include <stdlib.h>
#include <string.h>

#include "harness/harness.h"

/* A thread between the world and a tool, a second tool that rubs along it, a coupled ball on a floor. */
typedef struct stage {
    harness_memory memory;
    vbss_context *context;
    vbss_thread *thread;
    vbss_scene *scene;
    uint32_t body, tools[2], ball; /* numbers in the scene */
    uint32_t force, clamp, pin;    /* attachments and a pin that come and go */
    uint32_t step;                 /* made so far */
} stage;

typedef struct stage_options {
    double thread_friction, tool_friction, bending_stiffness;
    uint32_t contact_capacity;
    vbss_method method; /* PAPER: the ball is driven */
    vbss_scene_mode mode;
    double speed_limit; /* of targets, m/s */
} stage_options;

stage_options stage_defaults(void);
void stage_begin(stage *s, const stage_options *options);
/* The same inside a context that may run out of memory. */
vbss_result stage_make(stage *s, const stage_options *options);
vbss_result stage_leave(stage *s);
void stage_end(stage *s);
/* The edits of the host before the next step, and the step. A record is attached first; NULL changes
 * nothing. */
void stage_report(stage *s, vbss_record *record);
void stage_step(stage *s, vbss_record *record);
uint64_t stage_hash(stage *s);
/* A scene of nothing, made quickly. */
vbss_result empty_scene(vbss_context *context, vbss_scene **scene);

/* ---- logs */

typedef struct log_bytes {
    uint8_t *bytes;
    size_t count;
} log_bytes;
/* Appends what the record has grown by. */
void log_take(log_bytes *log, vbss_record *record);
/* A log of that many steps from the stage's present on; NULL: the defaults. */
log_bytes log_of(stage *s, const vbss_record_config *config, uint32_t steps);
log_bytes log_copy(const log_bytes *log);
void log_free(log_bytes *log);

/* Where the record at a place begins, and where the one after it does. */
typedef struct log_place {
    size_t at, next;
    uint32_t code;
    bool coded; /* a step as bits */
} log_place;
bool log_next_place(const log_bytes *log, log_place *place); /* from place->next on; 0: the first */
/* Of the n-th record of that code, from 1 on. */
log_place log_find(const log_bytes *log, uint32_t code, uint32_t n);
/* Writes the checksums of a changed log once more. */
void log_seal(log_bytes *log);
/* The same log as a library of format 2 wrote it: its steps are fields at fixed places. */
void log_to_format_2(log_bytes *log);

/* ---- replays */

vbss_replay *replay_of(stage *s, const log_bytes *log);
/* Until it does not step any more; its last result. */
vbss_result replay_all(vbss_replay *replay, vbss_replay_report *report);
const char *last_text(vbss_context *context);

#endif
