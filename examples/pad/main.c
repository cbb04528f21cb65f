/* A pad of skin with an incision: an interrupted stitch and a running suture of three bites.
 *
 *     pad [-s seed] [folder for pictures and log [s between frames of a film]]
 *
 * The pad is a shell of the library with triangles of its own (vbss_drain_surface), held by clamps at its border and by springs below.
 * Two scripted hands drive a needle through both lips and draw the thread after it. They tie the interrupted stitch with a double throw and two
 * single ones; an assistant holds the knot between the throws. Then its ends are cut. The running suture has a thread of its own, whose
 * tail is held as by a clamp. Prints what happens; exits 0 if all eight holes are there, the knot is certified as 2=1=1 in the end, the
 * lips touch at each bite that is drawn tight, and at the stitch in the end, and nothing passed through the skin but by the holes.
 *
 * A seed varies the performance: the hands' places are up to 0.1 mm off, along each axis. 0, the default, is without. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/elementary.h"
#include "decimal_point.h"
#include "pad.h"

/* Lips that touch are 0.40 mm apart, a fifth of their thickness (docs/explanation/drain-contact.md). A tenth more is left to
 * the height of one over the other. */
static const double shut = 0.5e-3 /* m */;
static const double slack = 0.03 /* N, of a hole without load */;

/* ---- report */

static void print_holes(const pad_report *r)
{
    printf(
        "hole  thread   x       z     turn   needle's side  tail's side  ratio  capstan bound\n");
    for (uint32_t i = 0; i < r->hole_count; i++) {
        const pad_hole *h = &r->holes[i];
        const double high = fmax(h->tension[0], h->tension[1]),
                     low = fmin(h->tension[0], h->tension[1]);
        printf("%4u  %-7s %+5.1f mm %+6.1f mm %4.0f deg     %6.3f N     %6.3f N   %5.2f  %5.2f\n",
               i + 1, h->suture == 0 ? "stitch" : "running", 1e3 * h->place.x, 1e3 * h->place.z,
               h->angle / SCRIPTED_DEGREE, h->tension[0], h->tension[1], high / low,
               vbss_exp(PAD_SKIN_FRICTION * h->angle));
    }
}

static void print_outcome(const pad *p, const pad_outcome *out)
{
    const pad_report *r = &out->end;
    print_holes(r);
    for (uint32_t i = 0; i < PAD_BITES; i++) {
        printf("bite %u: gap %.2f mm at first, %.2f mm before it was drawn, %.2f mm tight, %.2f mm "
               "in the end\n",
               i + 1, 1e3 * out->begin.gap[i], 1e3 * out->widest[i], 1e3 * out->tightened[i],
               1e3 * r->gap[i]);
    }
    printf("lips: largest gap %.2f mm, then %.2f mm; skin %+.2f to %+.2f mm\n",
           1e3 * out->begin.largest_gap, 1e3 * r->largest_gap, 1e3 * r->lowest, 1e3 * r->highest);
    for (int side = 0; side < 2; side++) {
        const vec3 f = r->side_force[side];
        printf("threads on the %s lip: (%+.3f, %+.3f, %+.3f) N\n", side == 0 ? "left" : "right",
               f.x, f.y, f.z);
    }
    printf("running suture: tail %.3f N, needle %.3f N\n", r->end_force[0], r->end_force[1]);
    const bool is_certified = p->tie.knot.state.verdict == VBSS_KNOT_VERDICT_CERTIFIED;
    printf("knot of the stitch: %s, %s\n", p->tie.knot.notation,
           p->tie.why != NULL ? p->tie.why
           : is_certified     ? "certified"
                              : "not certified");
    printf("%u punctures, %u holes in the end, %u withdrawn, unthreaded or torn; crossings beside "
           "the holes: %u\n",
           p->punctures, r->hole_count, p->others, out->crossings);
    printf("%" PRIu64 " steps; hash %016" PRIx64 "\n", out->steps, out->hash);
}

/* ---- judgement */

static bool check(bool good, const char *what)
{
    if (!good) {
        fprintf(stderr, "pad: %s\n", what);
    }
    return good;
}

/* A hole and the skin beside it hold back no more than a post would, and what a slack thread has. Not beside the knot, which
 * lies on one. */
static bool is_within_capstan(const pad_hole *h)
{
    const double high = fmax(h->tension[0], h->tension[1]),
                 low = fmin(h->tension[0], h->tension[1]);
    return high <= 1.05 * vbss_exp(PAD_SKIN_FRICTION * h->angle) * low + slack;
}

static bool judge(const pad *p, const pad_outcome *out)
{
    const pad_report *r = &out->end;
    bool good = check(p->punctures == PAD_MAX_HOLES && r->hole_count == PAD_MAX_HOLES,
                      "not every bite has its two holes");
    good = check(p->others == 0, "something left its hole") && good;
    good = check(out->crossings == 0, "something passed through the skin beside the holes") && good;
    good =
        check(p->tie.knot.state.verdict == VBSS_KNOT_VERDICT_CERTIFIED &&
                  strcmp(p->tie.knot.notation, "2=1=1") == 0,
              "the stitch has another knot than a double throw and two single ones, all square") &&
        good;
    for (uint32_t i = 0; i < PAD_BITES; i++) {
        good =
            check(out->tightened[i] < shut, "the lips do not touch at a bite drawn tight") && good;
    }
    good = check(r->gap[0] < shut, "the lips do not touch at the stitch in the end") && good;
    good =
        check(r->largest_gap < out->begin.largest_gap, "the incision gapes more than at first") &&
        good;
    for (uint32_t i = 0; i < r->hole_count; i++) {
        good = check(r->holes[i].suture == 0 || is_within_capstan(&r->holes[i]),
                     "friction of a hole beyond the capstan's bound") &&
               good;
    }
    return check(out->painted, "no pictures") && good;
}

/* ---- program */

static int fail(vbss_context *context, vbss_result result)
{
    const char *text = "";
    (void)vbss_context_get_last_error(context, NULL, &text);
    fprintf(stderr, "%s: %s\n", vbss_result_name(result), text);
    (void)vbss_context_destroy(context);
    return 1;
}

int main(int count, char **words)
{
    use_decimal_point();
    static pad p;
    static pad_outcome out;
    char path[512] = "";
    vbss_context *context;
    if (count > 2 && strcmp(words[1], "-s") == 0) {
        p.seed = strtoull(words[2], NULL, 10);
        words += 2;
        count -= 2;
    }
    pad_options options = {count > 1 ? words[1] : NULL, count > 2 ? strtod(words[2], NULL) : 0.0};
    if (count > 3 || vbss_context_create(NULL, &context) != VBSS_OK) {
        fprintf(
            stderr,
            "usage: pad [-s seed] [folder for pictures and log [s between frames of a film]]\n");
        return 2;
    }
    if (options.folder != NULL) {
        snprintf(path, sizeof path, "%s/pad.vbss", options.folder);
        p.log = fopen(path, "wb");
        if (p.log == NULL) {
            perror(path);
            return 2;
        }
    }
    vbss_result result = pad_create(context, &p);
    result = result == VBSS_OK ? pad_run(&p, &options, &out) : result;
    const bool is_written = p.log == NULL || fclose(p.log) == 0;
    if (result != VBSS_OK) {
        return fail(context, result);
    }
    print_outcome(&p, &out);
    const bool good = check(is_written, "the log cannot be written") && judge(&p, &out);
    (void)vbss_context_destroy(context);
    return good ? 0 : 1;
}
