#include "player.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool reported(const char *path, const char *what, const char *why)
{
    fprintf(stderr, "viewer: %s %s%s%s\n", path, what, *why != '\0' ? ": " : "", why);
    return false;
}

/* ---- opened */

/* The states in a log are only for a session that coaches as the log's did: then there is nothing of the coach to show. */
static vbss_result follow_task(player *p)
{
    const task_plan silent = {.coaching = false};
    stage *s = &p->stage;
    TRY(stage_follow_task(s, p->replay));
    if (s->task.session == NULL || vbss_session_seek(s->task.session, 0) != VBSS_ERROR_CORRUPT) {
        return VBSS_OK;
    }
    TRY(task_destroy(&s->task));
    TRY(vbss_replay_begin(p->replay, s->scene));
    return task_create_as(&s->task, s->tasked, NULL, p->replay, &silent);
}

static vbss_result read_scene_time(const player *p, double *time)
{
    vbss_scene_statistics now;
    TRY(vbss_scene_get_statistics(p->stage.scene, &now, sizeof now));
    *time = now.time;
    return VBSS_OK;
}

static vbss_result begin(player *p, vbss_context *reader)
{
    vbss_replay_info info;
    vbss_record_log_report report;
    vbss_replay *first;
    TRY(vbss_replay_create(reader, p->log.data, p->log.count, &first));
    TRY(vbss_replay_get_info(first, &info, sizeof info));
    TRY(vbss_record_check_log(reader, p->log.data, p->log.count, &report, sizeof report));
    p->steps = report.steps;
    p->length = report.time;
    p->whole = report.fault_count == 0;
    TRY(stage_create(&p->stage, info.note, info.note_bytes));
    TRY(vbss_replay_create(p->stage.context, p->log.data, p->log.count, &p->replay));
    TRY(vbss_replay_begin(p->replay, p->stage.scene));
    TRY(follow_task(p));
    return read_scene_time(p, &p->begin);
}

bool player_take(player *p, replay_log log, const char *path)
{
    vbss_context *reader;
    memset(p, 0, sizeof *p);
    p->log = log;
    if (p->log.count == 0) {
        return reported(path, "cannot be read", "");
    }
    if (vbss_context_create(NULL, &reader) != VBSS_OK) {
        return reported(path, "cannot be read", "no memory");
    }
    vbss_result result = begin(p, reader);
    (void)vbss_context_destroy(reader);
    return result == VBSS_OK ||
           reported(path, "is no log of a scene that can be made here", vbss_result_string(result));
}

bool player_open(player *p, const char *path)
{
    return player_take(p, replay_read(path), path);
}

void player_close(player *p)
{
    stage_destroy(&p->stage);
    free(p->log.data);
}

/* ---- played */

static bool differ(player *p, vbss_result result)
{
    p->differs = true;
    fprintf(stderr, "viewer: step %llu is not as it was recorded%s%s\n",
            (unsigned long long)p->step + 1, result != VBSS_OK ? ": " : "",
            result != VBSS_OK ? vbss_result_string(result) : "");
    return false;
}

static vbss_result read_time(player *p)
{
    TRY(read_scene_time(p, &p->time));
    p->time -= p->begin;
    return VBSS_OK;
}

bool player_step(player *p)
{
    vbss_replay_report report = {.outcome = VBSS_REPLAY_OUTCOME_STEPPED, .step = p->step};
    bool agrees;
    if (p->step >= p->steps || p->differs) {
        return false;
    }
    vbss_result result = stage_step(&p->stage, p->replay, &report, &agrees);
    if (result != VBSS_OK || report.outcome != VBSS_REPLAY_OUTCOME_STEPPED) {
        return differ(p, result);
    }
    p->step++;
    result = stage_follow(&p->stage);
    return (result == VBSS_OK && read_time(p) == VBSS_OK) || differ(p, result);
}

bool player_seek(player *p, uint64_t step)
{
    vbss_replay_report report;
    if (step > p->steps || p->differs) {
        return false;
    }
    vbss_result result = p->stage.task.session != NULL
                             ? vbss_session_seek(p->stage.task.session, step)
                             : vbss_replay_seek(p->replay, step, &report, sizeof report);
    if (result != VBSS_OK) {
        return differ(p, result);
    }
    p->step = step;
    p->jumped = true;
    return read_time(p) == VBSS_OK;
}
