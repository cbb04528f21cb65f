/* The scene of a log, made once more. Which one it is, is what the note of the log says: a scene that was not made by a
 * program known here cannot be. */
#ifndef VBSS_EXAMPLES_REPORT_STAGE_H
#define VBSS_EXAMPLES_REPORT_STAGE_H

#include "report/facts.h"
#include "surgeon/task.h"

typedef struct stage {
    const char *name;
    throw_rig *rig; /* whose context all is in; NULL: the scene is loaded from its log */
    vbss_context *context;
    vbss_scene *scene;
    vbss_grasper *graspers[SIDES];
    vbss_drain *drain; /* may be NULL */
    double tube;       /* its middle radius, m */
    double spacing;    /* of the thread's nodes, from the needle on, m */
    uint32_t needle;   /* body; 0: none */
    vbss_knot_detector *detector;
    const stitch *tasked; /* of which there is a session; may be NULL */
    int32_t exercise;     /* of that session: a VBSS_SESSION_EXERCISE_ constant */
    task task;
} stage;

/* False: the note names no scene that is known. */
bool stage_knows(const void *note, size_t count);
vbss_result stage_create(stage *s, const void *note, size_t count);
/* The scene before the first step of a log: one that stage_create has made, or else the log's own, with its tools. */
vbss_result stage_begin(stage *s, vbss_replay *replay, const uint32_t tools[SIDES]);
/* Of a surgeon at work: what it is of stays the surgeon's, who ends it. */
void stage_watch(stage *s, stitch *t, const task *k);
/* After a step: which thread it is now, if it was cut. */
vbss_result stage_follow(stage *s);
vbss_result stage_judge(stage *s, reading *r);
/* Its session, if it has one, follows the replay. */
vbss_result stage_follow_task(stage *s, vbss_replay *replay);
/* Makes the step after `report->step`, its session's too; a session that is not the recorded one is left out from there on, and
 * `agrees` is false then. */
vbss_result stage_step(stage *s, vbss_replay *replay, vbss_replay_report *report, bool *agrees);
void stage_destroy(stage *s);

#endif
