#include "demo/performance.h"

#define MILLI 1e3

static const char *name_of_knot(const performance *p)
{
    const reading *r = facts_certified(&p->facts);
    return r != NULL ? r->notation : "none that is certified";
}

static void put_measures(FILE *to, const performance *p)
{
    const surgeon *s = &p->surgeon;
    const vbss_metrics_report *r = &p->facts.measured.report;
    fprintf(to, "  time          %.1f s, simulated, in %.0f s by the clock\n",
            s->stitch.site.rig.time, p->watch.wall);
    fprintf(to, "  knot          %s; %u throws tied, %u seated\n", name_of_knot(p),
            (unsigned)p->watch.status.throws, (unsigned)p->watch.status.seated);
    fprintf(to, "  needle        %.2f and %.2f mm beside the marks; dropped %u times\n",
            r->deviation_mm[0], r->deviation_mm[1], (unsigned)r->drops);
    fprintf(to, "  slit          %.2f mm open in the end\n", MILLI * s->gap);
    fprintf(to, "  score         %.0f of 600%s\n", r->score,
            (r->flags & VBSS_METRICS_FLAG_FINAL) != 0 ? "" : ", provisional");
}

static void put_place(FILE *to, const char *what, const char *path, bool there)
{
    fprintf(to, "  %-13s %s%s\n", what, there ? path : "MISSING: ", there ? "" : path);
}

void summary_put(FILE *to, const performance *p, bool whole, bool completed)
{
    const bool asked = p->watch.options.until == SURGEON_DONE;
    const char *why = p->surgeon.why != NULL ? p->surgeon.why : "";
    fprintf(to, "The scripted surgeon, seed %lu: %s%s%s\n", (unsigned long)p->watch.options.seed,
            !asked      ? "a part of the task was performed"
            : completed ? "the task was completed"
                        : "THE TASK WAS NOT COMPLETED",
            *why != '\0' ? ": " : ".", why);
    put_measures(to, p);
    fprintf(to, "All of it is of this one performance:\n");
    for (size_t i = 0; i < p->count; i++) {
        const observer *o = &p->observers[i];
        put_place(to, o->what, o->path, !o->failed);
    }
    put_place(to, "report", p->at.report, p->reported);
    put_place(to, "key stages", p->at.stages, !p->watch.unpainted);
    put_place(to, "log", p->at.log, p->steps > 0);
    put_place(to, "details", p->at.details, true);
    if (!whole) {
        fprintf(to, "Not all files could be made: the messages above say why.\n");
    }
}
