/* The state of the session as a text: what the page shows beside the picture. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "exercise/places.h"
#include "knots/words.h"
#include "page.h"
#include "session.h"
#include "viewer/barrel.h"

enum { ROOM = 32768, MAX_REPORTED = 32 };
#define MILLI 1e3

static struct {
    char text[ROOM];
    size_t at;
} out;

__attribute__((format(printf, 1, 2))) static void put(const char *format, ...)
{
    va_list list;
    va_start(list, format);
    const int count = vsnprintf(out.text + out.at, ROOM - out.at, format, list);
    va_end(list);
    out.at += count > 0 ? (size_t)count : 0;
    out.at = out.at < ROOM ? out.at : ROOM - 1;
}

/* ---- the task */

static void put_mark(const vbss_session_status *s, int mark)
{
    if ((s->punctured & (1U << mark)) != 0) {
        put("%s%.4f", mark > 0 ? "," : "", s->deviation_mm[mark]);
    } else {
        put("%snull", mark > 0 ? "," : "");
    }
}

static void put_report(const task *k)
{
    vbss_metrics_report m;
    if (vbss_metrics_get_report(k->metrics, &m, sizeof m) == VBSS_OK) {
        put(",\"score\":%.1f,\"penalties\":%.1f,\"drops\":%u,\"lost\":%.3f", m.score, m.penalties,
            (unsigned)m.drops, m.time_lost);
    }
}

static void put_task(const task *k)
{
    vbss_session_status s;
    if (k->session == NULL || vbss_session_get_status(k->session, &s, sizeof s) != VBSS_OK) {
        return;
    }
    put(",\"task\":{\"time\":%.3f,\"phase\":\"%s\",\"number\":%d,\"stage\":\"%s\",\"failure\":\"%"
        "s\"",
        s.time, task_phase_name(s.phase), (int)s.phase,
        s.stage != VBSS_SESSION_STAGE_NONE ? task_stage_name(s.stage) : "",
        s.failure != VBSS_SESSION_FAILURE_NONE ? task_failure_name(s.failure) : "");
    put(",\"marks\":[");
    put_mark(&s, 0);
    put_mark(&s, 1);
    put("],\"gap\":%.4f,\"tail\":%.3f,\"tailSet\":%u,\"throws\":%u,\"seated\":%u,\"transfers\":%u,"
        "\"cut\":%u",
        MILLI * s.gap, MILLI * s.tail, (unsigned)s.tail_set, (unsigned)s.throws, (unsigned)s.seated,
        (unsigned)s.transfers, (unsigned)((s.cut & 1U) + (s.cut >> 1U)));
    put_report(k);
    put("}");
}

/* ---- the coach */

static void put_coaching(const task *k)
{
    vbss_session_coaching c;
    if (k->session == NULL || vbss_session_get_coaching(k->session, &c, sizeof c) != VBSS_OK) {
        return;
    }
    put(",\"coach\":{\"goal\":\"%s\",\"distance\":%.5f,\"turns\":%.2f", c.sentence, c.distance,
        c.turns);
    if ((c.geometry & (uint32_t)VBSS_SESSION_GEOMETRY_POINT) != 0) {
        put(",\"point\":[%.6f,%.6f,%.6f]", c.point[0], c.point[1], c.point[2]);
    }
    put(",\"mistake\":\"%s\",\"remedy\":\"%s\"}", c.mistake_sentence, c.remedy);
}

/* ---- an exercise, and aids */

static void put_exercise(const task *k)
{
    vbss_session_exercise_state e;
    vbss_session_measure m;
    char words[PRACTICE_LINE];
    if (k->session == NULL || vbss_session_get_exercise(k->session, &e, sizeof e) != VBSS_OK ||
        e.exercise == VBSS_SESSION_EXERCISE_NONE) {
        return;
    }
    put(",\"exercise\":{\"name\":\"%s\",\"goal\":\"%s\",\"outcome\":%d,\"time\":%.3f,\"measures\":"
        "[",
        e.name, e.sentence, (int)e.outcome, e.time);
    for (uint32_t i = 0; i < e.measure_count; i++) {
        if (vbss_session_get_measure(k->session, i, &m, sizeof m) == VBSS_OK) {
            practice_words(&m, words);
            put("%s{\"words\":\"%s\",\"met\":%s}", i > 0 ? "," : "", words,
                m.is_met != 0 ? "true" : "false");
        }
    }
    put("]}");
}

static void put_aids(const task *k)
{
    vbss_session_status s;
    if (k->session != NULL && vbss_session_get_status(k->session, &s, sizeof s) == VBSS_OK) {
        put(",\"aids\":%u,\"aidsUsed\":%u", (unsigned)s.aids, (unsigned)s.aids_used);
    }
}

/* ---- a log that is played */

static void put_replay(const page_session *p)
{
    const player *r = &p->player;
    if (p->plays) {
        put(",\"replay\":{\"steps\":%llu,\"time\":%.3f,\"length\":%.3f,\"whole\":%s,\"differs\":%"
            "s}",
            (unsigned long long)r->steps, r->time, r->length, r->whole ? "true" : "false",
            r->differs ? "true" : "false");
    }
}

/* ---- what has happened */

static void put_events(page_session *p)
{
    vbss_session_status s;
    const char *comma = "";
    put(",\"events\":[");
    vbss_session *session = page_stage(p)->task.session;
    if (session != NULL && vbss_session_get_status(session, &s, sizeof s) == VBSS_OK) {
        uint64_t next = p->reported > s.first_event ? p->reported : s.first_event;
        for (int i = 0; next < s.event_count && i < MAX_REPORTED; i++, next++) {
            vbss_session_event e;
            char words[TASK_WORDS];
            if (vbss_session_get_event(session, next, &e, sizeof e) == VBSS_OK) {
                task_words(&e, words);
                put("%s{\"time\":%.3f,\"kind\":%d,\"words\":\"%s\"}", comma, e.time, (int)e.kind,
                    words);
                comma = ",";
            }
        }
        p->reported = next;
    }
    put("]");
}

/* ---- the knot of the scene that has nothing else to do */

static void put_knot(page_session *p)
{
    reading r;
    memset(&r, 0, sizeof r);
    if (page_stage(p)->drain != NULL || stage_judge(page_stage(p), &r) != VBSS_OK) {
        return;
    }
    put(",\"knot\":\"%s%s%s\",\"throws\":%u", r.state.throw_count > 0 ? r.notation : "",
        r.state.throw_count > 0 ? " " : "", words_of_result(r.state.verdict),
        (unsigned)r.state.throw_count);
}

/* ---- tools */

static void put_place(const char *name, const page_session *p, const matrix4 *seen,
                      const double at[3])
{
    float place[2];
    if (barrel_place(seen, p->aspect, at, place)) {
        put(",\"%s\":[%.4f,%.4f]", name, (double)place[0], (double)place[1]);
    }
}

static void put_tool(page_session *p, int side, const matrix4 *seen)
{
    vbss_grasper_state t;
    const mouse_hand *m = &p->live.hands[side];
    if (vbss_grasper_get_state(page_stage(p)->graspers[side], &t, sizeof t) != VBSS_OK) {
        return;
    }
    const double foot[3] = {t.position[0], t.position[1], FLOOR_HEIGHT};
    const double *x = t.position, *to = t.target_position, *q = t.orientation, *f = t.hand_force;
    put("{\"position\":[%.6f,%.6f,%.6f],\"target\":[%.6f,%.6f,%.6f]", x[0], x[1], x[2], to[0],
        to[1], to[2]);
    put(",\"orientation\":[%.6f,%.6f,%.6f,%.6f],\"opening\":%.3f", q[0], q[1], q[2], q[3],
        t.opening);
    put(",\"holds\":\"%s\"", t.needle != 0       ? "the needle"
                             : t.drain != 0      ? "the drain"
                             : t.grasp_count > 0 ? "the thread"
                                                 : "");
    put(",\"shears\":%s,\"closes\":%s,\"clutched\":%s,\"tracked\":%s",
        t.kind == VBSS_GRASPER_KIND_SHEARS ? "true" : "false", m->closes ? "true" : "false",
        m->clutched ? "true" : "false", live_by_device(&p->live, side) ? "true" : "false");
    put(",\"force\":%.4f,\"felt\":%.4f", sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]),
        tracked_force(side));
    put_place("place", p, seen, x);
    put_place("foot", p, seen, foot);
    put("}");
}

const char *page_state(void)
{
    page_session *p = page_get();
    out.at = 0;
    if (!p->there) {
        return "{}";
    }
    const camera_view view = camera_get_view(&p->camera, p->aspect);
    put("{\"scene\":\"%s\",\"steps\":%llu", p->live.scene->name,
        (unsigned long long)(p->plays ? p->player.step : p->live.steps));
    put_replay(p);
    put_task(&page_stage(p)->task);
    put_coaching(&page_stage(p)->task);
    put_exercise(&page_stage(p)->task);
    put_aids(&page_stage(p)->task);
    put_knot(p);
    put_events(p);
    put(",\"tools\":[");
    put_tool(p, LEFT, &view.seen);
    put(",");
    put_tool(p, RIGHT, &view.seen);
    put("]}");
    return out.text;
}
