/* A session of which a throw is tied is recorded, with what it was after each step, and followed. */
#ifndef VBSS_TESTS_SESSION_FOLLOWED_H
#define VBSS_TESTS_SESSION_FOLLOWED_H

#include "log_bytes.h"
#include "rig.h"

enum { TRIAL_STEPS = 260, TRIAL_SNAPSHOTS = 20 };

typedef struct session_trial {
    harness_memory memory;
    vbss_context *context;
    session_scene scene;
    vbss_session *session;
} session_trial;

typedef struct trial_log {
    log_bytes log;
    size_t ends[TRIAL_STEPS + 1];                                /* of the log, by steps */
    uint64_t scenes[TRIAL_STEPS + 1], sessions[TRIAL_STEPS + 1]; /* their hashes */
} trial_log;

/* Scene and configuration, to be changed; then the session; then all of it goes. */
void trial_begin(session_trial *t);
void trial_start(session_trial *t);
void trial_end(session_trial *t);
/* Into the configuration: a record with a snapshot each TRIAL_SNAPSHOTS steps. */
void trial_begin_record(session_trial *t);
/* All of it, the log to be freed. */
void trial_record(trial_log *was);
/* With steps as fields and states that are not packed, as a log of format 2 that goes on has them. */
void trial_record_plain(trial_log *was);
/* Begins and starts a session that follows the log. */
void trial_follow(session_trial *t, const log_bytes *log);
/* Scene and session are as they were after that step. */
void trial_expect_at(const session_trial *t, const trial_log *was, uint32_t step);

/* A session's state in the log. */
typedef struct state_place {
    size_t at, length; /* of the section */
    uint32_t step;
} state_place;
/* So many; the last of them in `last`. */
uint32_t trial_find_states(const log_bytes *log, state_place *last);

#endif
