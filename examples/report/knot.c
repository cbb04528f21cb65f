/* The knot: what the detector says of the thread at the end, and when it said what. */
#include "knots/words.h"

#include "report/page.h"

static const char *hand_of(int32_t handedness)
{
    return handedness > 0 ? "right-handed" : handedness < 0 ? "left-handed" : "not known";
}

static const char *lies(const vbss_knot_throw *t, uint32_t number)
{
    if ((t->flags & VBSS_KNOT_THROW_STRAY) != 0) {
        return "in one limb alone";
    }
    if (number == 0) {
        return "the first";
    }
    return (t->flags & VBSS_KNOT_THROW_GRANNY) != 0 ? "granny to the one before"
                                                    : "square to the one before";
}

static void put_throws(page *p, const reading *r, const again *a)
{
    if (r->state.throw_count == 0) {
        return;
    }
    put(p,
        "<table><caption>Throws at %.2f s, from the tissue outward</caption><thead><tr><th "
        "scope=\"col\" class=\"n\">No.</th><th scope=\"col\">Type</th><th "
        "scope=\"col\">Chirality</th><th scope=\"col\">Order</th><th scope=\"col\">How "
        "sure</th><th scope=\"col\" class=\"n\">first tied at, s</th></tr></thead><tbody>\n",
        r->time);
    for (uint32_t i = 0; i < r->state.throw_count && i < MAX_THROWS; i++) {
        const vbss_knot_throw *t = &r->throws[i];
        const reading *first = a->readings;
        while (first->state.throw_count <= i) {
            first++; /* `r` is one of them */
        }
        put(p, "<tr><td class=\"n\">%u</td><th scope=\"row\">", (unsigned)i + 1);
        if (t->wraps == 1 || t->wraps == 2) {
            put(p, t->wraps == 1 ? "single" : "double");
        } else {
            put(p, "%d wraps", (int)t->wraps);
        }
        put(p, "</th><td>%s</td><td>%s%s%s</td><td>%s</td><td class=\"n\">%.2f</td></tr>\n",
            hand_of(t->handedness), lies(t, i),
            (t->flags & VBSS_KNOT_THROW_ORDERED) != 0 ? "" : "; place in the stack not proved",
            (t->flags & VBSS_KNOT_THROW_HITCH) != 0 ? "; a half hitch, which slides" : "",
            words_of_result(t->verdict), first->time);
    }
    put(p, "</tbody></table>\n");
}

static void put_result(page *p, const char *when, const reading *r)
{
    char faults[WORD_TAGS];
    if (r->notation[0] == '\0') {
        put(p, "<p class=\"verdict\">%s, %.2f s: <strong>no knot</strong>%s</p>\n", when, r->time,
            r->state.verdict == VBSS_KNOT_VERDICT_UNCERTAIN ? ", uncertain" : "");
        return;
    }
    words_of_faults(r->state.faults, faults);
    put(p, "<p class=\"verdict\">%s, %.2f s: <strong>", when, r->time);
    put_text(p, r->notation);
    put(p, "</strong> %s, %s. Against the knot of the task, 2=1=1: ", words_of_name(r->state.name),
        words_of_result(r->state.verdict));
    put_text(p, faults);
    put(p, ".</p>\n");
}

static void put_history(page *p, const again *a)
{
    put(p,
        "<details><summary>All changes of the verdict (%u)</summary><table><caption>What the "
        "detector said</caption><thead><tr><th "
        "scope=\"col\" class=\"n\">at s</th><th scope=\"col\" class=\"n\">step</th><th "
        "scope=\"col\">Knot</th><th scope=\"col\">Verdict</th><th scope=\"col\">Faults against "
        "2=1=1</th></tr></thead><tbody>\n",
        (unsigned)a->reading_count);
    for (size_t i = 0; i < a->reading_count; i++) {
        const reading *r = &a->readings[i];
        char faults[WORD_TAGS];
        words_of_faults(r->state.faults, faults);
        put(p, "<tr><td class=\"n\">%.2f</td><td class=\"n\">%llu</td><td>", r->time,
            (unsigned long long)r->step);
        put_text(p, r->notation[0] != '\0' ? r->notation : "no knot");
        put(p, "</td><td>%s</td><td>", words_of_result(r->state.verdict));
        put_text(p, faults);
        put(p, "</td></tr>\n");
    }
    put(p, "</tbody></table></details>\n");
}

void page_knot(page *p, const facts *f)
{
    const again *a = &f->again;
    put(p, "<section aria-labelledby=\"knot\"><h2 id=\"knot\">Knot</h2>\n");
    if (a->reading_count == 0) {
        put(p, "<p class=\"absent\">%s</p></section>\n",
            a->count > 0
                ? "No knot is judged in this scene."
                : "Not known: the log does not hold the thread, and it was not played back.");
        return;
    }
    const reading *last = &a->readings[a->reading_count - 1], *proved = facts_certified(f);
    if (proved != NULL && proved != last) {
        put_result(p, "Last certified", proved);
        put_throws(p, proved, a);
    }
    put_result(p, "At the end", last);
    put_throws(p, last, a);
    put_history(p, a);
    const vbss_metrics_report *m = &f->measured.report;
    if (m->tightness_pull == VBSS_METRICS_TIGHTNESS_UNKNOWN &&
        m->tightness_strain == VBSS_METRICS_TIGHTNESS_UNKNOWN) {
        put(p, "<p class=\"absent\">Tightness: not known, as no pull test is in the log.</p>\n");
    }
    put(p,
        "<p class=\"note\">=: the throw is of the other handedness than the one before (square); "
        "x: of the same (granny). Certified: the type of the knot is proved. The "
        "thread alone is judged, every 50 steps and at the end, whatever the tools "
        "hold.</p></section>\n");
}
