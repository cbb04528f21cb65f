/* The whole performance, with its log, its pictures, and its measures. */
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "pad.h"

enum {
    TESTED_EVERY = 10,
    PRINTED_EVERY = 500,
    READING = 1000 /* steps, for the knot detector to finish what it has begun */
};

/* A picture at the end of these phases. */
static bool is_shown(pad_phase phase)
{
    return phase == PAD_LOWER || phase == PAD_LET_GO || phase == PAD_TURN || phase == PAD_TIGHTEN;
}

static void describe(const pad *p, char *text, size_t size)
{
    if (p->is_tying) {
        snprintf(text, size, "%5.2f s, throw %u: %s", p->time, tie_present_throw(&p->tie),
                 tie_state_name(p->tie.state));
    } else {
        snprintf(text, size, "%5.2f s, bite %u: %s", p->time, (unsigned)p->bite + 1,
                 pad_phase_name(p->phase));
    }
}

static bool save(pad *p, const char *folder, const char *name, bool from_above)
{
    char path[512], text[96];
    snprintf(path, sizeof path, "%s/%s.png", folder, name);
    describe(p, text, sizeof text);
    return pad_save_picture(p, path, text, from_above);
}

static bool show(pad *p, const pad_options *o, double *next_frame)
{
    char name[64];
    bool good = true;
    if (o->folder == NULL) {
        return true;
    }
    if (o->frames > 0.0 && p->time >= *next_frame) {
        snprintf(name, sizeof name, "frame-%04d", (int)(*next_frame / o->frames + 0.5));
        good = save(p, o->folder, name, false);
        *next_frame += o->frames;
    }
    const double left = pad_phase_time(p->bite, p->phase) - p->since;
    if (!p->is_tying && is_shown(p->phase) && left < 0.5 * PAD_STEP) {
        snprintf(name, sizeof name, "bite-%u-%02u", (unsigned)p->bite + 1, (unsigned)p->phase);
        good = save(p, o->folder, name, false) && good;
    }
    return good;
}

static void print_tie(const pad *p, const pad_report *r)
{
    const pad_tie *t = &p->tie;
    printf("%5.2f s  throw %u, %-30s  turns %+.2f  limb %.3f N, tail %.3f N  knot %-5s  gap %.2f "
           "mm  crossings %u\n",
           p->time, tie_present_throw(t), tie_state_name(t->state), t->turns, t->c.tension,
           t->w.tension, t->knot.notation, 1e3 * r->gap[0], r->crossings);
    fflush(stdout);
}

static void print_line(const pad *p, const pad_report *r)
{
    if (p->is_tying) {
        print_tie(p, r);
        return;
    }
    printf("%5.2f s  bite %u, %-35s  %u+%u holes  gap %4.2f mm  skin %+.2f to %+.2f mm  thread "
           "%5.3f N  crossings %u\n",
           p->time, (unsigned)p->bite + 1, pad_phase_name(p->phase), r->needle_holes, r->hole_count,
           1e3 * r->gap[p->bite], 1e3 * r->lowest, 1e3 * r->highest, p->tension, r->crossings);
    fflush(stdout);
}

static vbss_result watch(pad *p, const pad_options *o, pad_outcome *out, double *next_frame)
{
    pad_report r;
    const uint32_t bite = p->bite;
    if (p->is_tying) {
        out->tightened[0] = pad_opening(p, pad_place(0));
    } else if (p->phase == PAD_TURN || p->phase == PAD_TIGHTEN) {
        const double gap = pad_opening(p, pad_place(bite));
        *(p->phase == PAD_TURN ? &out->widest[bite] : &out->tightened[bite]) = gap;
    }
    if (out->steps % TESTED_EVERY == 0) {
        VBSS_TRY(pad_measure(p, &r));
        out->crossings += r.crossings;
        if (out->steps % PRINTED_EVERY == 0) {
            print_line(p, &r);
        }
    }
    out->painted = show(p, o, next_frame) && out->painted;
    return VBSS_OK;
}

vbss_result pad_run(pad *p, const pad_options *o, pad_outcome *out)
{
    bool is_done = false;
    double next_frame = 0.0;
    memset(out, 0, sizeof *out);
    VBSS_TRY(pad_measure(p, &out->begin));
    out->painted = o->folder == NULL || save(p, o->folder, "begin", false);
    while (!is_done) {
        VBSS_TRY(pad_step(p, &is_done));
        if (!is_done) {
            out->steps++;
            VBSS_TRY(watch(p, o, out, &next_frame));
        }
    }
    VBSS_TRY(pad_measure(p, &out->end));
    for (uint32_t i = 0; i < READING && p->tie.state == TIE_DONE; i++) {
        VBSS_TRY(pad_follow_knot(p));
    }
    VBSS_TRY(pad_end_log(p));
    out->painted = out->painted && (o->folder == NULL || (save(p, o->folder, "end", false) &&
                                                          save(p, o->folder, "above", true)));
    return vbss_scene_get_hash(p->scene, &out->hash);
}
