/* The holes beside their marks, to scale, and the slit over time. */
#include <math.h>
#include <stdlib.h>

#include "report/page.h"
#include "report/plot.h"

enum { BOX = 300 };

/* Unrolled wall: along the drain to the right, around it upward; 5 mm to the edge, or more where a hole is farther. */
static void put_mark(page *p, const again *a, int mark)
{
    double reach = 3.0;
    for (size_t i = 0; i < a->puncture_count; i++) {
        const puncture *h = &a->punctures[i];
        double off = 1e3 * fmax(fabs(h->axial), fabs(h->tube * h->angle));
        reach = h->mark == mark && off > reach - 0.5 ? ceil(off + 0.5) : reach;
    }
    double mm = 0.5 * (BOX - 40) / reach, c = 0.5 * BOX;
    put(p, "<figure class=\"mark\"><figcaption>%s mark</figcaption>",
        mark == LEFT ? "Left" : "Right");
    plot_open(p, BOX, BOX + 24,
              mark == LEFT ? "Holes near the left mark" : "Holes near the right mark",
              "The wall unrolled and to scale: along the drain to the right, around it upward; "
              "rings at whole millimetres from the mark.");
    for (int ring = 1; ring <= (int)reach && ring <= 12; ring++) {
        put(p, "<circle class=\"%s\" cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\"/>",
            ring == 1 ? "ring first" : "ring", c, c, ring * mm);
        put(p, "<text class=\"tick\" x=\"%.1f\" y=\"%.1f\">%d</text>\n", c + 3.0,
            c - ring * mm - 2.0, ring);
    }
    put(p, "<path class=\"cross\" d=\"M%.1f %.1fh16m-8-8v16\"/>\n", c - 8.0, c);
    for (size_t i = 0; i < a->puncture_count; i++) {
        const puncture *h = &a->punctures[i];
        if (h->mark != mark) {
            continue;
        }
        double x = c + 1e3 * mm * h->axial, y = c - 1e3 * mm * h->tube * h->angle;
        put(p,
            "<circle class=\"hole%s\" cx=\"%.1f\" cy=\"%.1f\" r=\"6\"><title>%.2f mm along, %.2f "
            "mm "
            "around, %.2f s%s</title></circle>\n",
            h->withdrawn ? " back" : "", x, y, 1e3 * h->axial, 1e3 * h->tube * h->angle, h->time,
            h->withdrawn ? ", withdrawn" : "");
    }
    put(p,
        "<text class=\"tick\" x=\"%d\" y=\"%d\" text-anchor=\"middle\">rings: mm from the mark; "
        "dot: hole</text>\n",
        BOX / 2, BOX + 18);
    plot_close(p);
    put(p, "</figure>\n");
}

static void put_slit(page *p, const facts *f)
{
    const again *a = &f->again;
    double *t = calloc((size_t)a->count + 1, sizeof *t),
           *gap = calloc((size_t)a->count + 1, sizeof *t),
           *widest = calloc((size_t)a->count + 1, sizeof *t), largest = 0.0;
    for (uint64_t i = 0; t != NULL && gap != NULL && widest != NULL && i < a->count; i++) {
        t[i] = f->moments[i].time;
        gap[i] = 1e3 * a->steps[i].gap;
        widest[i] = 1e3 * a->steps[i].widest;
        largest = fmax(largest, fmax(gap[i], widest[i]));
    }
    if (t != NULL && gap != NULL && widest != NULL) {
        put(p, "<figure><figcaption>Gap of the slit</figcaption>");
        plot d = plot_of_time(p, "Gap of the slit over time",
                              "Between its middles, and where it is widest.", facts_end(f), largest,
                              "gap, mm");
        plot_phases(&d, f);
        plot_curve(&d, t, gap, (size_t)a->count, "gap");
        plot_curve(&d, t, widest, (size_t)a->count, "widest");
        plot_close(p);
        put(p,
            "</figure>\n<p class=\"legend\"><span class=\"key gap\">between the two points in its "
            "middle</span> <span class=\"key widest\">where it is widest (dashed)</span></p>\n");
    }
    free(t);
    free(gap);
    free(widest);
}

void page_accuracy(page *p, const facts *f)
{
    const again *a = &f->again;
    put(p, "<section aria-labelledby=\"accuracy\"><h2 id=\"accuracy\">Accuracy</h2>\n");
    if (a->puncture_count > 0) {
        put(p, "<div class=\"pair\">\n");
        put_mark(p, a, LEFT);
        put_mark(p, a, RIGHT);
        put(p,
            "</div>\n<table><caption>Holes, beside the nearer mark</caption><thead><tr><th "
            "scope=\"col\">Mark</th><th scope=\"col\" class=\"n\">at s</th><th scope=\"col\" "
            "class=\"n\">along, mm</th><th scope=\"col\" class=\"n\">around, mm</th><th "
            "scope=\"col\" class=\"n\">distance, mm</th><th scope=\"col\">stands</th></tr></thead>"
            "<tbody>\n");
        for (size_t i = 0; i < a->puncture_count; i++) {
            const puncture *h = &a->punctures[i];
            double around = h->tube * h->angle;
            put(p,
                "<tr><th scope=\"row\">%s</th><td class=\"n\">%.3f</td><td "
                "class=\"n\">%.2f</td><td "
                "class=\"n\">%.2f</td><td class=\"n\">%.2f</td><td>%s</td></tr>\n",
                page_side(h->mark), h->time, 1e3 * h->axial, 1e3 * around,
                1e3 * hypot(around, h->axial), h->withdrawn ? "no, withdrawn" : "yes");
        }
        put(p,
            "</tbody></table>\n<p class=\"note\">Distance along the cylinder of the wall's middle, "
            "sqrt((R &#952;)&#178; + x&#178;), in the drain at rest (Qi et al. 2017, section 6)."
            "</p>\n");
    } else {
        put(p, "<p class=\"absent\">Deviations from the marks: not known, as %s.</p>\n",
            a->count > 0 && f->counts[VBSS_SCENE_EVENT_PUNCTURE] > 0
                ? "the walls of this scene have no marks"
            : a->count > 0 ? "no wall was entered"
            : f->counts[VBSS_SCENE_EVENT_PUNCTURE] > 0
                ? "the log holds when walls were entered and not where, and was not played back"
                : "no wall was entered in this log");
    }
    if (a->count > 0 && a->drain) {
        put_slit(p, f);
    } else {
        put(p, "<p class=\"absent\">Gap of the slit: not known, as %s.</p>\n",
            a->count > 0 ? "there is no drain with a slit in this scene"
                         : "the log does not hold it and was not played back");
    }
    put(p, "</section>\n");
}
