/* The session of a stitch: which phase of the task it is in, what happened, and the measures of it. The same for who makes the
 * stitch and who plays its log back. */
#ifndef VBSS_EXAMPLES_SURGEON_TASK_H
#define VBSS_EXAMPLES_SURGEON_TASK_H

#include <vblast_ss/session_coaching.h>
#include <vblast_ss/session_exercise.h>

#include "needle/stitch.h"

typedef struct task {
    vbss_knot_detector *knots;
    vbss_metrics *metrics;
    vbss_session *session;
} task;

/* With a record the session writes to it; with a replay it follows that. */
vbss_result task_create(task *k, const stitch *t, vbss_record *record, vbss_replay *replay);
typedef struct task_plan {
    double time_limit; /* s; 0: the usual one */
    bool coaching;
    vbss_session_exercise exercise; /* NONE: the whole task */
} task_plan;

vbss_result task_create_as(task *k, const stitch *t, vbss_record *record, vbss_replay *replay,
                           const task_plan *plan);
/* In the context of the stitch, which ends them otherwise. */
vbss_result task_destroy(task *k);

const char *task_phase_name(vbss_session_phase phase);
const char *task_stage_name(vbss_session_stage stage);
/* Why it has failed; "no failure". */
const char *task_failure_name(vbss_session_failure failure);
enum { TASK_WORDS = 256 };
/* What happened, in words, with its number and amount. */
void task_words(const vbss_session_event *e, char words[TASK_WORDS]);
/* The same of an event of the coach. (words_of_coach.c) */
void task_words_of_coach(const vbss_session_event *e, char words[TASK_WORDS]);
/* What the coach says, on standard output. */
void task_print_coaching(double time, const vbss_session_coaching *c);

#endif
