/* Families of threads with their truth: the whole reading of the topology, as judge() makes it at once, and one closure
 * of it, from the thread to names and handedness. */
#include <ctype.h>
#include <stdio.h>

#include "knots/bench_knots.h"
#include "knots/shown_set.h"
#include "knots/reported.h"

/* Configurations of a family at one N: of all 10^5. */
enum { CONFIGURATIONS = 1280, QUICK_CONFIGURATIONS = 16, SIZES = 5 };
static const uint32_t sizes[SIZES] = {30, 60, 120, 240, 300};

typedef struct row {
    char name[64];
    const family *family;
    uint32_t segments, wanted;
    bool closure; /* one, instead of the whole reading */

    /* of a run */
    const shown_set *set;
    vbss_context *context;
    vbss_knot_detector *detector;
    knot_detector *inside;
    bool counted;
    uint32_t at;
    reported_counts counts;
} row;

static row rows[FAMILIES][SIZES][2];

static int set_up(void *user)
{
    row *r = user;
    r->set = shown_set_of(r->family, r->segments, r->wanted);
    r->counts = (reported_counts){0};
    r->counted = false;
    r->at = 0;
    if (r->set == NULL || vbss_context_create(NULL, &r->context) != VBSS_OK) {
        return 1;
    }
    if (vbss_knot_detector_create(r->context, NULL, &r->detector) != VBSS_OK ||
        vbss_knot_open(r->detector, &r->inside) != VBSS_OK) {
        vbss_context_destroy(r->context);
        return 1;
    }
    return 0;
}

static int restore(void *user)
{
    row *r = user;
    r->counted = r->counts.configurations > 0;
    r->at = 0;
    return vbss_knot_detector_reset(r->detector) == VBSS_OK ? 0 : 1;
}

static int judge(void *user, uint32_t index)
{
    row *r = user;
    return vbss_knot_detector_judge(r->detector, &r->set->inputs[index]) == VBSS_OK ? 0 : 1;
}

/* As a reading does for its outward closure, from the thread itself. */
static int close_once(void *user, uint32_t index)
{
    row *r = user;
    knot_detector *d = r->inside;
    knot_input *scene = &d->job.input;
    knot_curve *curve = &d->job.reader;
    knot_closure *closing = &d->job.closure;
    knot_ops work = INT64_MAX;
    if (vbss_knot_read_input(d, &r->set->inputs[index], scene) != VBSS_OK) {
        return 1;
    }
    const uint32_t last = scene->point_count - 1;
    vbss_knot_closure_init(closing, &d->config, scene);
    knot_extension tail =
        vbss_knot_straight_extension(scene->points[0], closing->tail_directions[0]);
    knot_extension end =
        vbss_knot_straight_extension(scene->points[last], closing->long_directions[0]);
    vbss_knot_close_begin(closing, &curve->polygon, &tail);
    vbss_knot_polygon_add_thread(&curve->polygon, scene, 0.0, last);
    vbss_knot_close_end(closing, &curve->polygon, &tail, &end);
    curve->direction_limit = d->config.direction_limit;
    vbss_knot_curve_begin(curve, true);
    return vbss_knot_curve_resume(curve, &work) ? 0 : 1;
}

static uint64_t hash(void *user)
{
    row *r = user;
    const family_case *truth = &r->set->cases[r->at++];
    reported t = r->closure ? reported_by_closure(&r->inside->job.reader.reading, truth)
                            : reported_by_judge(r->detector, truth);
    if (!r->counted) {
        reported_add(&r->counts, &t);
    }
    (void)vbss_knot_detector_reset(r->detector); /* each is the first that it sees */
    return t.hash;
}

static void finish(void *user, bench_result *result)
{
    row *r = user;
    reported_report(&r->counts, result);
    bench_counter(result, "truth", r->set->cases[0].truth == FAMILY_OPEN ? 0.0 : 1.0);
}

static void tear_down(void *user)
{
    row *r = user;
    vbss_context_destroy(r->context);
    r->context = NULL;
}

/* The family's name without spaces. */
static void name_row(row *r)
{
    int n = snprintf(r->name, sizeof r->name, "knots/%s/%s/%u", r->family->name,
                     r->closure ? "closure" : "topology", (unsigned)r->segments);
    for (int i = 0; i < n && i < (int)sizeof r->name; i++) {
        r->name[i] = isspace((unsigned char)r->name[i]) ? '-' : r->name[i];
    }
}

void add_family_cases(bench *b)
{
    bool quick = bench_is_quick(b);
    for (int f = 0; f < FAMILIES; f++) {
        for (int i = 0; i < 2 * SIZES; i++) {
            row *r = &rows[f][i / 2][i % 2];
            *r = (row){.family = &families[f],
                       .segments = sizes[i / 2],
                       .wanted = quick ? QUICK_CONFIGURATIONS : CONFIGURATIONS,
                       .closure = i % 2 == 1};
            name_row(r);
            if (quick && r->segments != 60 && r->segments != 240) {
                continue;
            }
            /* Of so few segments hardly one can be made. */
            if (2 * r->segments < r->family->min_segments) {
                bench_add_skipped(b, r->name, "too few segments for such knots");
                continue;
            }
            bench_add_stepped(b, &(bench_stepped){.name = r->name,
                                                  .user = r,
                                                  .steps = r->wanted,
                                                  .setup = set_up,
                                                  .restore = restore,
                                                  .step = r->closure ? close_once : judge,
                                                  .hash = hash,
                                                  .finish = finish,
                                                  .teardown = tear_down});
        }
    }
}
