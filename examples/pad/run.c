/* The whole performance, with its log, its pictures, and its measures. */
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "pad.h"

enum { TESTED_EVERY = 10, PRINTED_EVERY = 500 };

/* A picture at the end of these phases. */
static bool is_shown(pad_phase phase)
{
    return phase == PAD_LOWER || phase == PAD_LET_GO || phase == PAD_TURN || phase == PAD_TIGHTEN;
}

static bool save(pad *p, const char *folder, const char *name, bool from_above)
{
    char path[512], text[96];
    snprintf(path, sizeof path, "%s/%s.png", folder, name);
    snprintf(text, sizeof text, "%5.2f s, bite %u: %s", p->time, (unsigned)p->bite + 1,
             pad_phase_name(p->phase));
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
    if (is_shown(p->phase) && left < 0.5 * PAD_STEP) {
        snprintf(name, sizeof name, "bite-%u-%02u", (unsigned)p->bite + 1, (unsigned)p->phase);
        good = save(p, o->folder, name, false) && good;
    }
    return good;
}

static void print_line(const pad *p, const pad_report *r)
{
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
    if (p->phase == PAD_TURN || p->phase == PAD_TIGHTEN) {
        const double gap = pad_gap(p, pad_place(bite));
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
    VBSS_TRY(pad_end_log(p));
    out->painted = out->painted && (o->folder == NULL || (save(p, o->folder, "end", false) &&
                                                          save(p, o->folder, "above", true)));
    return vbss_scene_get_hash(p->scene, &out->hash);
}
