/* Where the phases on the page come from. They are those of the session, if there is one; otherwise they are told apart by what
 * happened: each ends with the first time that something is done. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "report/facts.h"
#include "surgeon/task.h"

enum { MAX_ENDS = 8 + MAX_THROWS };

typedef struct phase_end {
    char name[MAX_NAME]; /* of what ends here */
    double time;
    uint64_t step;
    bool tying;
} phase_end;

typedef struct ends {
    phase_end all[MAX_ENDS];
    size_t count;
} ends;

static void add(ends *e, const char *name, double time, uint64_t step, bool tying)
{
    if (e->count < MAX_ENDS) {
        phase_end *p = &e->all[e->count++];
        snprintf(p->name, sizeof p->name, "%s", name);
        p->time = time;
        p->step = step;
        p->tying = tying;
    }
}

/* The n-th of a kind, counted from 1 on; NULL: there are fewer. */
static const happening *nth(const facts *f, uint32_t kind, int n)
{
    for (size_t i = 0; i < f->event_count; i++) {
        const happening *e = &f->events[i];
        bool counts = kind != VBSS_SCENE_EVENT_CUT || e->second != 0; /* a cut that was made */
        if (e->kind == kind && counts && --n == 0) {
            return e;
        }
    }
    return NULL;
}

static void add_nth(const facts *f, ends *e, uint32_t kind, int n, const char *name)
{
    const happening *h = nth(f, kind, n);
    if (h != NULL) {
        add(e, name, h->time, h->step, false);
    }
}

static void add_needle(const facts *f, ends *e)
{
    const happening *entry = nth(f, VBSS_SCENE_EVENT_PUNCTURE, 1);
    uint32_t needle = entry != NULL ? entry->first : f->again.needle;
    for (size_t i = 0; needle != 0 && i < f->event_count; i++) {
        if (f->events[i].kind == VBSS_SCENE_EVENT_GRASP && f->events[i].first == needle) {
            add(e, "taking the needle", f->events[i].time, f->events[i].step, false);
            break;
        }
    }
    add_nth(f, e, VBSS_SCENE_EVENT_PUNCTURE, 1, "to the first wall");
    add_nth(f, e, VBSS_SCENE_EVENT_PUNCTURE, 2, "inside the drain");
    add_nth(f, e, VBSS_SCENE_EVENT_PASSED, 2, "drawing through");
}

static void add_throws(const facts *f, ends *e)
{
    uint32_t tied = 0;
    for (size_t i = 0; i < f->again.reading_count; i++) {
        const reading *r = &f->again.readings[i];
        for (; tied < r->state.throw_count && tied < MAX_THROWS; tied++) {
            char name[MAX_NAME];
            snprintf(name, sizeof name, "throw %u", (unsigned)tied + 1);
            add(e, name, r->time, r->step, true);
        }
    }
}

static int by_time(const void *a, const void *b)
{
    const phase_end *x = a, *y = b;
    int later = (x->step > y->step) - (x->step < y->step);
    return later != 0 ? later : strcmp(x->name, y->name);
}

/* From the last one on, which ends there. */
static vbss_result add_phase(facts *f, const char *name, double from, uint64_t step, double to,
                             bool tying)
{
    if (!(to > from)) {
        return VBSS_OK;
    }
    if (!facts_room((void **)&f->phases, &f->phase_room, f->phase_count, sizeof *f->phases)) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    phase *p = &f->phases[f->phase_count++];
    snprintf(p->name, sizeof p->name, "%s", name);
    p->from = from;
    p->to = to;
    p->step = step;
    p->tying = tying;
    return VBSS_OK;
}

/* ---- of the session */

static bool is_tying(vbss_session_phase p)
{
    return p == VBSS_SESSION_PHASE_THROW_1 || p == VBSS_SESSION_PHASE_THROW_2 ||
           p == VBSS_SESSION_PHASE_THROW_3;
}

/* After the first step that has events: an exercise begins within the task. */
static vbss_session_phase first_phase(const followed *t)
{
    size_t i = 0;
    while (i + 1 < t->count && t->events[i + 1].step == t->events[0].step) {
        i++;
    }
    return t->status.first_event > 0 ? VBSS_SESSION_PHASE_LOADING : t->events[i].phase;
}

static vbss_result take_phases(facts *f)
{
    const followed *t = &f->again.session;
    vbss_session_phase now = first_phase(t);
    double from = 0.0;
    uint64_t step = 0;
    f->phase_source =
        "The phases are those of the session that ran beside the scene: each waits for a fact, "
        "such "
        "as a hole at a mark or a throw that is seated, and comes back when that is undone.";
    for (size_t i = 0; i < t->count; i++) {
        const vbss_session_event *e = &t->events[i];
        if (e->kind != VBSS_SESSION_EVENT_PHASE || e->step == 0 || e->step > f->steps) {
            continue;
        }
        double to = e->step > 1 ? f->moments[e->step - 1].time : 0.0;
        TRY(add_phase(f, task_phase_name(now), from, step, to, is_tying(now)));
        now = (vbss_session_phase)e->number;
        from = to;
        step = e->step - 1;
    }
    return add_phase(f, task_phase_name(now), from, step, facts_end(f), is_tying(now));
}

/* ---- from what happened */

static vbss_result report_apart(facts *f)
{
    ends e = {.count = 0};
    double from = 0.0;
    uint64_t step = 0;
    add_needle(f, &e);
    add_throws(f, &e);
    bool throws = f->again.reading_count > 0 && e.count > 0 && e.all[e.count - 1].tying;
    const happening *exchange = nth(f, VBSS_SCENE_EVENT_EXCHANGED, 1);
    if (exchange != NULL) {
        add(&e, throws ? "seating, new tool" : "until a new tool", exchange->time, exchange->step,
            throws);
    }
    add_nth(f, &e, VBSS_SCENE_EVENT_CUT, 2, "cutting");
    f->phase_source =
        "No session was followed. The phases were told apart by what happened: each ends when the "
        "needle is held for the first time, when a wall is entered, when needle and thread are "
        "through, when another throw is tied, when a tool is exchanged, with the second cut.";
    qsort(e.all, e.count, sizeof e.all[0], by_time);
    bool seating = e.count > 0 && strncmp(e.all[e.count - 1].name, "throw", 5) == 0;
    add(&e,
        e.count == 0 ? "the whole log"
        : seating    ? "seating"
                     : "until the end",
        facts_end(f), f->steps, seating);
    for (size_t i = 0; i < e.count; i++) {
        if (e.all[i].step <= step) {
            continue;
        }
        TRY(add_phase(f, e.all[i].name, from, step, e.all[i].time, e.all[i].tying));
        from = e.all[i].time;
        step = e.all[i].step;
    }
    return VBSS_OK;
}

vbss_result facts_phases(facts *f)
{
    return f->again.session.count > 0 ? take_phases(f) : report_apart(f);
}
