#include "demo/performance.h"

#include <stdlib.h>

#include "report/page.h"
#include "throw/replay.h"

/* s simulated that the stages take usually: how much of the work is done when they begin. */
static const double usual[SURGEON_DONE] = {6.5, 9.3, 12.1, 9.5, 29.2, 7.3, 18.0, 4.3};
static const char *const words[SURGEON_DONE] = {
    "needle through both marks",
    "drawing the thread through",
    "first throw, a double one",
    "needle to the left hand",
    "second throw",
    "needle to the right hand",
    "third throw",
    "cutting the tails",
};

#define PAGES 3.0 /* s: to write the pages, beside those of the stages */

/* ---- how far */

static void show_progress(performance *p, const surgeon *s)
{
    double whole = PAGES, done = 0.0;
    for (int i = 0; i < (int)p->watch.options.until && i < SURGEON_DONE; i++) {
        whole += usual[i];
        done += i < (int)s->stage ? usual[i] : 0.0;
    }
    if (s->stage < SURGEON_DONE) {
        const double within = s->stitch.site.rig.time - p->watch.begin[s->stage];
        done += within < usual[s->stage] ? within : usual[s->stage];
        bar_show(&p->bar, words[s->stage], done / whole);
    }
}

/* ---- observed */

static vbss_result begin(performance *p, surgeon *s)
{
    stage_watch(&p->stage, &s->stitch, &p->watch.task);
    p->facts.tools[LEFT] = s->stitch.left.body;
    p->facts.tools[RIGHT] = s->stitch.right.body;
    p->facts.again.asked = p->facts.again.performed = true;
    for (size_t i = 0; i < p->count; i++) {
        observer *o = &p->observers[i];
        o->failed = !o->begin(o->user, &p->stage);
    }
    return facts_observe_begin(&p->facts, &p->stage);
}

static void show_observers(performance *p, double time)
{
    for (size_t i = 0; i < p->count; i++) {
        observer *o = &p->observers[i];
        o->failed = o->failed || !o->step(o->user, &p->stage, p->steps, time);
    }
}

/* Before the first step, and after each one. */
static vbss_result observe(void *user, const watch *w, surgeon *s)
{
    performance *p = user;
    const throw_rig *of = &s->stitch.site.rig;
    (void)w;
    if (p->stage.scene == NULL) {
        TRY(begin(p, s));
    } else {
        vbss_scene_statistics now;
        TRY(vbss_scene_get_statistics(of->scene, &now, sizeof now));
        p->steps++;
        TRY(facts_observe(&p->facts, &p->stage, now.time, of->took));
    }
    show_observers(p, of->time);
    show_progress(p, s);
    return VBSS_OK;
}

/* ---- written */

static vbss_result find_out(performance *p)
{
    facts *f = &p->facts;
    const uint32_t left = f->tools[LEFT], right = f->tools[RIGHT];
    replay_log log = replay_read(p->at.log);
    f->path = p->at.log;
    f->bytes = log.data;
    f->count = log.count;
    memset(f->tools, 0, sizeof f->tools);
    TRY(facts_observe_end(f, &p->stage));
    TRY(facts_read(f));
    if (f->steps != p->steps || f->tools[LEFT] != left || f->tools[RIGHT] != right) {
        return VBSS_ERROR_CORRUPT;
    }
    TRY(facts_observe_session(f, &p->stage));
    TRY(facts_phases(f));
    return facts_measure(f);
}

static bool write_report(const performance *p)
{
    static pictures shown;
    bool good = pictures_read(&shown, p->at.stages) && page_report(&p->facts, &shown, p->at.report);
    pictures_free(&shown);
    return good;
}

static void end_observers(performance *p)
{
    for (size_t i = 0; i < p->count; i++) {
        observer *o = &p->observers[i];
        o->failed = !o->end(o->user, p->steps) || o->failed;
    }
}

static void write_pages(performance *p)
{
    for (size_t i = 0; i < p->count; i++) {
        observer *o = &p->observers[i];
        if (o->write != NULL && !o->failed) {
            o->failed = !o->write(o->user, &p->facts, o->path);
        }
    }
    p->reported = write_report(p);
}

bool perform(performance *p)
{
    static watch_step steps[WATCH_STEPS];
    p->watch.guest = observe;
    p->watch.user = p;
    p->watch.options.log = p->at.log;
    p->watch.options.coaching = true; /* for the debrief of the report */
    p->watch.album = p->at.stages;
    p->result = watch_run(&p->watch, &p->surgeon, steps);
    bar_show(&p->bar, "writing the pages", 1.0);
    watch_report(&p->watch, &p->surgeon, p->result);
    watch_report_events(&p->watch);
    end_observers(p);
    const vbss_result known = p->steps > 0 ? find_out(p) : p->result;
    if (known == VBSS_OK) {
        write_pages(p);
    } else {
        fprintf(stderr, "No pages: %s\n", vbss_result_string(known));
    }
    bool good = p->result == VBSS_OK && known == VBSS_OK && p->reported && !p->watch.unpainted;
    for (size_t i = 0; i < p->count; i++) {
        good = good && !p->observers[i].failed;
    }
    return good;
}
