/* What the detector said of a knot, in words: once loose, once tight. */
#include <stdio.h>

#include "knots/gallery.h"
#include "knots/words.h"

static void print_places(const double places[2])
{
    printf("  %6.1f to %5.1f", places[0], places[1]);
}

static void print_throw(const vbss_knot_throw *t, uint32_t number)
{
    char text[WORD_TAGS];
    words_of_throw(t, text);
    printf("    throw %u: %-50s", (unsigned)number + 1, text);
    if ((t->flags & VBSS_KNOT_THROW_LOCATED) != 0) {
        print_places(t->tail_places);
        print_places(t->long_places);
        printf("%7.2f%8.1f", t->slip, 1e3 * t->tail_length);
    }
    printf("\n");
}

static void print_reading(const gallery_reading *r, const char *when)
{
    const vbss_knot_state *s = &r->state;
    char faults[WORD_TAGS];
    words_of_faults(s->faults, faults);
    printf("  %-5s  %s, %s, %s, %s, %.0f us\n", when, r->notation, words_of_name(s->name),
           words_of_result(s->verdict), faults, r->us);
    printf("    closed: %u crossings, det %lld, signature %d and %d at 0.27 pi, v2 %lld, v3 %lld; "
           "ends %s\n",
           (unsigned)s->crossings, (long long)s->determinant, (int)s->signature,
           (int)s->signature_tristram, (long long)s->v2, (long long)s->v3,
           s->ends_free != 0 ? "free" : "compared");
    printf("    %-59s%17s%17s%7s%8s\n", "", "tail limb, from", "long limb, from", "slip",
           "tail mm");
    for (uint32_t i = 0; i < s->throw_count; i++) {
        print_throw(&r->throws[i], i);
    }
}

static bool is_certified(const gallery_reading *r)
{
    return r->state.verdict == VBSS_KNOT_VERDICT_CERTIFIED;
}

bool gallery_report(const gallery_knot *g)
{
    bool right = g->frames_right == g->frames_judged && is_certified(&g->loose_reading) &&
                 is_certified(&g->tight_reading);
    printf("\n%s: told as %s in %u of %u frames, certified in %u%s\n", g->title, g->notation,
           (unsigned)g->frames_right, (unsigned)g->frames_judged, (unsigned)g->frames_certified,
           right ? "" : ": NOT AS IT SHOULD BE");
    print_reading(&g->loose_reading, "loose");
    print_reading(&g->tight_reading, "tight");
    fflush(stdout);
    return right;
}
