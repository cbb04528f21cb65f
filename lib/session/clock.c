/* The clocks of the task.
 *
 * The clock of a session runs with the hands: it adds up the lengths of the steps. A scene in real
 * time leaves out what it cannot finish, and a truncated substep moves all bodies by a fraction.
 * Both are lost time; the rest is simulated time. */
#include "base/error.h"
#include "metrics/metrics.h"
#include "session/session.h"
#include "session/tuning.h"

vbss_result vbss_session_start_clock(session_object *s)
{
    vbss_scene_statistics statistics;
    VBSS_TRY(vbss_scene_get_statistics(s->scene, &statistics, sizeof statistics));
    s->scene_steps = statistics.steps;
    s->scene_time_paused = statistics.time_paused;
    s->scene_clamped = statistics.clamped;
    return VBSS_OK;
}

/* The statistics have the time of paused steps only, but to the bit. Events have truncated substeps,
 * too, in 1/65536 of a step. */
static double lost_time_of_step(const session_object *s, const scene_info *scene,
                                const vbss_scene_statistics *statistics)
{
    double paused = statistics->time_paused - s->scene_time_paused;
    if (statistics->clamped == s->scene_clamped) {
        return paused;
    }
    return vbss_max(paused, vbss_scene_inspect_lost_time(scene->events, scene->event_count, s->h));
}

vbss_result vbss_session_count_step(session_object *s)
{
    scene_info scene;
    vbss_scene_statistics statistics;
    VBSS_TRY(vbss_scene_inspect(s->scene, &scene));
    VBSS_TRY(vbss_scene_get_statistics(s->scene, &statistics, sizeof statistics));
    if (s->steps > 0) { /* the needle appears at the end of the first step */
        s->time += s->h;
        s->time_lost += lost_time_of_step(s, &scene, &statistics);
    }
    s->scene_steps = statistics.steps;
    s->scene_time_paused = statistics.time_paused;
    s->scene_clamped = statistics.clamped;
    s->steps++;
    s->events_before_step = s->event_count;
    return VBSS_OK;
}

void vbss_session_update_lost_time(session_object *s)
{
    double share = s->config.lost_share;
    share *= s->is_lossy != 0 ? SESSION_LOST_SHARE_HYSTERESIS : 1.0;
    uint32_t is_lossy = vbss_metrics_is_time_lost(s->time_lost, s->time, share);
    if (is_lossy != s->is_lossy) {
        s->is_lossy = is_lossy;
        vbss_session_event *e = vbss_session_emit_event(s, VBSS_SESSION_EVENT_TIME_LOST, 0,
                                                        !is_lossy, VBSS_METRICS_TOOL_NONE);
        e->amount = s->time_lost;
    }
}
