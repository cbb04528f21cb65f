/* Metrics beside published figures. Bands come from other set-ups than this one; each says which, and what of it is not
 * verified. */
#include <math.h>

#include "report/page.h"
#include "report/plot.h"

enum { WIDE = 200, TALL = 26 };

typedef struct source {
    const char *mark, *text;
} source;

static const source sources[] = {
    {"a", "Proficiency on the FLS suturing task, 112 s, accuracy error of 1 mm at most, no "
          "slippage: SAGES abstract; Surgeons as Educators, p. 59. Box trainer."},
    {"b", "PMID 29920136, n = 19: forces at a real Penrose drain, puncture (two walls) and "
          "tightening of three throws."},
    {"c", "Published robot-assisted recordings, 30 Hz, knot tying by self-rated experts, n = 10, "
          "median [least, most], computed by us. Robotic, not laparoscopic: a sanity band only."},
    {"d", "The same, suturing by self-rated experts, n = 9: median only."},
    {"e", "VBLaST-SS in a trial of 25 users, 421 \xc2\xb1 168 s: Fu 2018, doi "
          "10.1007/s00464-018-6531-3."},
    {"f",
     "Korndorffer et al., J Am Coll Surg 2005;201:23: proficiency 512, trained 389 \xc2\xb1 70, "
     "control 217 \xc2\xb1 140. Box trainer, weights of their own."},
    {"g", "Ours: what the scripted hands seat to; no published figure was found."},
    {"h", "FLS: 0 secure, 10 slips, 20 comes apart: Surgeons as Educators, pp. 58-59."},
};

typedef struct row {
    const char *name, *unit;
    bool known;
    double value;
    double low, high, typical, end; /* of the band, a tick, the scale; high below low: no band */
    int digits;
    const char *band, *mark;
    bool uncertain;
} row;

static const row no_band = {.low = 0.0, .high = -1.0, .typical = -1.0};

/* ---- a row */

static void put_bar(page *p, const row *r)
{
    double end = fmax(r->end, r->known ? 1.05 * r->value : 0.0), scale = (WIDE - 8.0) / end;
    plot_open(p, WIDE, TALL, r->name, r->band != NULL ? r->band : "no band");
    put(p, "<line class=\"scale\" x1=\"4\" x2=\"%d\" y1=\"13\" y2=\"13\"/>", WIDE - 4);
    if (r->high >= r->low) {
        put(p, "<rect class=\"band%s\" x=\"%.1f\" y=\"5\" width=\"%.1f\" height=\"16\" rx=\"2\"/>",
            r->uncertain ? " unsure" : "", 4.0 + scale * r->low,
            fmax(scale * (fmin(r->high, end) - r->low), 2.0));
    }
    if (r->typical >= 0.0) {
        put(p, "<line class=\"typical\" x1=\"%.1f\" x2=\"%.1f\" y1=\"3\" y2=\"23\"/>",
            4.0 + scale * r->typical, 4.0 + scale * r->typical);
    }
    if (r->known) {
        put(p, "<circle class=\"value\" cx=\"%.1f\" cy=\"13\" r=\"5\"/>",
            4.0 + scale * fmax(r->value, 0.0));
    }
    plot_close(p);
}

static void put_row(page *p, const row *r)
{
    put(p, "<tr><th scope=\"row\">");
    put_text(p, r->name);
    put(p, "</th>");
    if (r->known) {
        put(p, "<td class=\"n\">%.*f</td>", r->digits, r->value);
    } else {
        put(p, "<td class=\"n absent\">not known</td>");
    }
    put(p, "<td>%s</td><td class=\"bar\">", r->unit);
    if (r->end > 0.0) {
        put_bar(p, r);
    }
    put(p, "</td><td>");
    put_text(p, r->band != NULL ? r->band : "no reference band");
    if (r->mark != NULL) {
        put(p, " <sup><a href=\"#source-%s\">%s</a></sup>", r->mark, r->mark);
    }
    put(p, "%s</td></tr>\n", r->uncertain ? " <em class=\"unsure\">uncertain</em>" : "");
}

static void put_banded(page *p, row r, double low, double high, double typical, const char *band,
                       const char *mark, bool uncertain)
{
    r.low = low;
    r.high = high;
    r.typical = typical;
    r.band = band;
    r.mark = mark;
    r.uncertain = uncertain;
    put_row(p, &r);
}

static row row_of(const char *name, const char *unit, bool known, double value, int digits,
                  double end)
{
    row r = no_band;
    r.name = name;
    r.unit = unit;
    r.known = known;
    r.value = value;
    r.digits = digits;
    r.end = end;
    return r;
}

/* ---- groups of rows */

static void put_group(page *p, const char *name)
{
    put(p, "</tbody><tbody><tr class=\"group\"><th colspan=\"5\" scope=\"rowgroup\">%s</th></tr>\n",
        name);
}

static void put_outcome(page *p, const facts *f)
{
    const measured *m = &f->measured;
    uint32_t flags = m->report.flags;
    bool final = (flags & VBSS_METRICS_FLAG_FINAL) != 0 && !page_may_go_on(f) &&
                 (flags & VBSS_METRICS_FLAG_ASSISTED) == 0;
    bool own = f->again.session.measured; /* its first hole is that in, whichever side */
    put_group(p, "Outcome");
    put_banded(p, row_of("time", "s", f->steps > 0, m->report.time, 1, 600.0), 0.0, 112.0, 421.0,
               "at most 112; the tick: 421, mean of a trial of VBLaST-SS (source e)", "a", false);
    put_banded(p, row_of("score", "points", final, m->report.score, 1, 600.0), 319.0, 459.0, 512.0,
               "389 \xc2\xb1 70 trained; the tick: 512, proficiency", "f", true);
    put_banded(p,
               row_of(own ? "hole in off its mark" : "left hole off its mark", "mm",
                      (flags & VBSS_METRICS_FLAG_PUNCTURE_0) != 0, m->report.deviation_mm[0], 2,
                      4.0),
               0.0, 1.0, -1.0, "at most 1", "a", false);
    put_banded(p,
               row_of(own ? "hole out off its mark" : "right hole off its mark", "mm",
                      (flags & VBSS_METRICS_FLAG_PUNCTURE_1) != 0, m->report.deviation_mm[1], 2,
                      4.0),
               0.0, 1.0, -1.0, "at most 1", "a", false);
    put_banded(p,
               row_of(own ? "gap of the slit, middle, at the last seat"
                          : "gap of the slit, middle, at the end",
                      "mm", (flags & VBSS_METRICS_FLAG_GAP) != 0, m->report.gap_mm, 2, 5.0),
               0.0, 0.5, -1.0, "below 0.5", "g", true);
    put_banded(p,
               row_of("tightness by pull test", "points",
                      m->report.tightness_pull != VBSS_METRICS_TIGHTNESS_UNKNOWN,
                      m->report.tightness_pull, 0, 20.0),
               0.0, 0.0, -1.0, "0, secure", "h", false);
    if (own) {
        put_banded(p,
                   row_of("short tail, hole to end", "mm", (flags & VBSS_METRICS_FLAG_TAIL_0) != 0,
                          m->report.tail_mm[0], 1, 40.0),
                   15.0, 20.0, -1.0, "15 to 20, before the knot draws it in", "g", true);
    }
}

/* Largest while throws were tied and pulled down; below 0: nothing is known of when. */
static double peak_tying(const facts *f, int side)
{
    const measured *m = &f->measured;
    double largest = -1.0;
    for (size_t k = 0; k < f->phase_count; k++) {
        const phase *h = &f->phases[k];
        for (size_t i = 0; h->tying && i < m->force_rows[side]; i++) {
            double t = m->begin + 0.01 * (double)i;
            largest = t >= h->from && t < h->to ? fmax(largest, m->force[side][i]) : largest;
        }
    }
    return largest;
}

static void put_forces(page *p, const facts *f)
{
    static const char *const tying[SIDES] = {"largest while tying, left",
                                             "largest while tying, right"};
    static const char *const all[SIDES] = {"largest of all, left", "largest of all, right"};
    static const char *const holes[SIDES] = {"of the left hole on the needle, as it enters",
                                             "of the right hole on the needle, as it enters"};
    const again *a = &f->again;
    put_group(p, "Forces");
    for (int side = 0; side < SIDES; side++) {
        bool known = a->count > 0 && f->tools[side] != 0;
        double peak = peak_tying(f, side);
        put_banded(p, row_of(tying[side], "N", known && peak >= 0.0, peak, 2, 8.0), 0.586, 6.089,
                   -1.0, "0.59 to 6.09, tightening three throws", "b", false);
    }
    for (int side = 0; side < SIDES; side++) {
        bool known = a->count > 0 && f->tools[side] != 0;
        row r = row_of(all[side], "N", known, f->measured.motion[side].force_peak, 2, 8.0);
        put_row(p, &r);
    }
    for (size_t i = 0; i < a->puncture_count && i < 4; i++) {
        const double *v = a->punctures[i].force;
        put_banded(p,
                   row_of(holes[a->punctures[i].mark], "N", true,
                          sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]), 2, 8.0),
                   0.852, 2.915, -1.0, "0.85 to 2.92 for two walls; this is one", "b", true);
    }
}

static bool has_moved(const facts *f, int side)
{
    return f->tools[side] != 0 && f->measured.motion[side].time > 0.0;
}

/* Of the recordings only the right hand's are published. */
static void put_peaks(page *p, const facts *f, bool sews, const char *mark)
{
    const vbss_metrics_motion *v = f->measured.motion;
    row left = row_of("peak speed, left", "m/s", has_moved(f, LEFT), v[LEFT].peak_speed, 3, 0.4);
    put_row(p, &left);
    put_banded(p,
               row_of("peak speed, right", "m/s", has_moved(f, RIGHT), v[RIGHT].peak_speed, 3, 0.4),
               0.0, -1.0, sews ? 0.10 : 0.111, sews ? "0.10, suturing" : "0.111, knot", mark, true);
}

static void put_idle(page *p, const facts *f, bool sews, const char *mark)
{
    const vbss_metrics_motion *v = f->measured.motion;
    row left = row_of("idle, left", "%", has_moved(f, LEFT), 100.0 * v[LEFT].idle_share, 0, 100.0);
    put_row(p, &left);
    put_banded(
        p, row_of("idle, right", "%", has_moved(f, RIGHT), 100.0 * v[RIGHT].idle_share, 0, 100.0),
        0.0, -1.0, sews ? 52.0 : 49.0, sews ? "52, suturing" : "49, knot", mark, true);
}

/* Left out of all figures of motion. */
static void put_outliers(page *p, const facts *f)
{
    const vbss_metrics_report *r = &f->measured.report;
    static const char *const names[SIDES] = {"implausible samples left out, left",
                                             "implausible samples left out, right"};
    for (int side = 0; side < SIDES; side++) {
        row o = row_of(names[side], "", has_moved(f, side), (double)r->outliers[side], 0, 0.0);
        put_row(p, &o);
    }
}

static void put_motion(page *p, const facts *f)
{
    const measured *m = &f->measured;
    bool sews = f->counts[VBSS_SCENE_EVENT_PUNCTURE] > 0;
    const char *mark = sews ? "d" : "c";
    static const struct {
        double low, high, typical;
        const char *text;
    } path[SIDES] = {{0.52, 0.83, 0.68, "0.68 [0.52, 0.83], knot"},
                     {0.40, 0.65, 0.51, "0.51 [0.40, 0.65], knot"}};
    put_group(p, "Motion, as the tools were told to be");
    for (int side = 0; side < SIDES; side++) {
        const vbss_metrics_motion *v = &m->motion[side];
        row r = row_of(side == LEFT ? "path, left" : "path, right", "m", has_moved(f, side),
                       v->path_length, 3, 1.5);
        if (sews) {
            put_banded(p, r, 0.0, -1.0, side == LEFT ? 0.98 : 0.83,
                       side == LEFT ? "0.98, suturing" : "0.83, suturing", mark, true);
        } else {
            put_banded(p, r, path[side].low, path[side].high, path[side].typical, path[side].text,
                       mark, true);
        }
    }
    put_peaks(p, f, sews, mark);
    put_idle(p, f, sews, mark);
    put_outliers(p, f);
}

static void put_smoothness(page *p, const facts *f)
{
    const measured *m = &f->measured;
    put_group(p, "Smoothness and both hands together");
    for (int side = 0; side < SIDES; side++) {
        const vbss_metrics_motion *v = &m->motion[side];
        row ldj =
            row_of(side == LEFT ? "log dimensionless jerk, left" : "log dimensionless jerk, right",
                   "", (v->valid & VBSS_METRICS_HAS_LDJ) != 0, v->ldj_speed, 2, 0.0);
        row sparc = row_of(
            side == LEFT ? "mean SPARC of movements, left" : "mean SPARC of movements, right", "",
            (v->valid & VBSS_METRICS_HAS_MOVEMENTS) != 0, v->movement_sparc, 2, 0.0);
        put_row(p, &ldj);
        put_row(p, &sparc);
    }
    row both = row_of("both tools move, share of time", "%", m->bimanual.time > 0.0,
                      100.0 * m->bimanual.both_moving_share, 0, 100.0);
    row alike = row_of("correlation of the speeds", "",
                       (m->bimanual.valid & VBSS_METRICS_HAS_CORRELATION) != 0,
                       m->bimanual.correlation, 2, 0.0);
    put_row(p, &both);
    put_row(p, &alike);
}

void page_bands(page *p, const facts *f)
{
    put(p,
        "<section aria-labelledby=\"metrics\"><h2 id=\"metrics\">Metrics beside published figures"
        "</h2>\n<table class=\"bands\"><caption>The dot is this session, the green bar the band, "
        "dashed where it is uncertain, the tick a mean or median</caption>"
        "<thead><tr><th scope=\"col\">Metric</th><th scope=\"col\" class=\"n\">Here</th><th "
        "scope=\"col\">Unit</th><th scope=\"col\">On its scale</th><th "
        "scope=\"col\">Reference</th></tr></thead>\n<tbody>");
    put_outcome(p, f);
    put_forces(p, f);
    put_motion(p, f);
    put_smoothness(p, f);
    put(p, "</tbody></table>\n<ul class=\"sources\">\n");
    for (size_t i = 0; i < sizeof sources / sizeof sources[0]; i++) {
        put(p, "<li id=\"source-%s\"><b>%s</b> ", sources[i].mark, sources[i].mark);
        put_text(p, sources[i].text);
        put(p, "</li>\n");
    }
    put(p, "</ul>\n<p class=\"note\">Uncertain: from another set-up, or not verified. A value in a "
           "band proves no skill, and one outside of it no lack of it.</p></section>\n");
}
