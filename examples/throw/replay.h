/* Repeats a trial from its log: creates the same rig and gives it the recorded commands. */
#ifndef VBSS_EXAMPLES_THROW_REPLAY_H
#define VBSS_EXAMPLES_THROW_REPLAY_H

#include <stddef.h>

#include "throw/trial.h"

typedef struct replay_log {
    uint8_t *data; /* NULL: the file cannot be read; else to be freed */
    size_t count;
} replay_log;

typedef struct replay_finding {
    vbss_result result;
    vbss_replay_report report;
    uint32_t interval; /* steps from hash to hash */
    bool equal;        /* to the end, with all hashes */
    char text[256];    /* why not */
} replay_finding;

replay_log replay_read(const char *path);
/* On that scene, made anew; tells no text. */
replay_finding replay_on(throw_rig *s, const replay_log *log);
/* With `changed` a node of the thread is let go that the recorded scene held. */
replay_finding replay_run(const trial_options *o, const replay_log *log, bool changed);
/* Of the file that the options name. */
replay_finding replay_file(const trial_options *o);

#endif
