/* Where the time of a verdict goes, stage by stage. Each is timed alone; all before it are run again untimed. */
#include <stdio.h>

#include "knots/bench_knots.h"
#include "knots/shown_set.h"
#include "knots/wound.h"

#include "knot/knot.h"

enum { CONFIGURATIONS = 256, QUICK_CONFIGURATIONS = 8, SIZES = 5, MAX_STAGES = 32 };
static const uint32_t sizes[SIZES] = {30, 60, 120, 240, 300};

typedef struct stage_row stage_row;
typedef struct stage {
    const char *name;
    const char
        *family; /* whose threads are shown; NULL: threads wound about a tool, with two tools */
    void (*run)(stage_row *r);
    bool first;       /* of a chain: needs only what is shown */
    const char *mean; /* what its mean result is; NULL: nothing that is worth telling */
} stage;

struct stage_row {
    char name[64];
    const stage *stage;
    uint32_t segments, wanted;
    const vbss_knot_input *inputs;
    vbss_context *context;
    vbss_knot_detector *detector;
    knot_detector *inside;
    uint32_t at;
    uint64_t result;   /* what the stage made of it: how many are left, or a number found */
    uint32_t observed; /* configurations whose results are added up */
    double sum;
};

/* ---- one closure */

static void copy_input(stage_row *r)
{
    (void)vbss_knot_read_input(r->inside, &r->inputs[r->at], &r->inside->job.input);
    r->result = r->inside->job.input.point_count;
}

static void close_thread(stage_row *r)
{
    knot_detector *d = r->inside;
    const knot_input *scene = &d->job.input;
    knot_closure *closing = &d->job.closure;
    knot_polygon *polygon = &d->job.reader.polygon;
    const uint32_t last = scene->point_count - 1;
    vbss_knot_closure_init(closing, &d->config, scene);
    knot_extension tail =
        vbss_knot_straight_extension(scene->points[0], closing->tail_directions[0]);
    knot_extension end =
        vbss_knot_straight_extension(scene->points[last], closing->long_directions[0]);
    vbss_knot_close_begin(closing, polygon, &tail);
    vbss_knot_polygon_add_thread(polygon, scene, 0.0, last);
    vbss_knot_close_end(closing, polygon, &tail, &end);
    r->result = polygon->count;
}

static void reduce(stage_row *r)
{
    knot_curve *curve = &r->inside->job.reader;
    knot_ops work = INT64_MAX;
    vbss_knot_reduction_begin(&curve->reduction, &curve->polygon, NULL, 0);
    (void)vbss_knot_reduction_resume(&curve->reduction, &work);
    r->result = curve->polygon.count;
}

/* The first direction without a crossing that is not certain. */
static void project(stage_row *r)
{
    knot_curve *curve = &r->inside->job.reader;
    knot_ops work = INT64_MAX;
    for (uint32_t k = 0; k < r->inside->config.direction_limit; k++) {
        if (vbss_knot_project(&curve->projector, &curve->polygon, vbss_knot_direction(k),
                              &curve->codes[0], &work) == KNOT_DIAGRAM_REGULAR) {
            break;
        }
    }
    r->result = curve->codes[0].n;
}

static void simplify(stage_row *r)
{
    knot_ops work = INT64_MAX;
    vbss_knot_gauss_code_simplify(&r->inside->job.reader.codes[0], &work);
    r->result = r->inside->job.reader.codes[0].n;
}

static void take_apart(stage_row *r)
{
    knot_reading *reading = &r->inside->job.reader.reading;
    reading->certified = vbss_knot_decompose(&r->inside->job.reader.codes[0], &reading->factors);
    r->result = reading->certified;
}

/* Of a diagram that does not come apart. */
static void untangle(stage_row *r)
{
    knot_curve *curve = &r->inside->job.reader;
    knot_ops work = INT64_MAX;
    if (!curve->reading.certified && curve->codes[0].n <= curve->algebra.capacity) {
        uint32_t tries = KNOT_TRIES;
        while (vbss_knot_gauss_code_untangle(&curve->codes[0], &curve->codes[2], &tries, &work)) {
        }
    }
    r->result = curve->codes[0].n;
}

static void determinant(stage_row *r)
{
    knot_curve *curve = &r->inside->job.reader;
    knot_ops work = INT64_MAX;
    curve->reading.invariants.determinant =
        vbss_knot_determinant(&curve->algebra, &curve->codes[curve->best], &work);
    r->result = (uint64_t)curve->reading.invariants.determinant;
}

static void signature(stage_row *r)
{
    knot_curve *curve = &r->inside->job.reader;
    knot_ops work = INT64_MAX;
    (void)vbss_knot_signature(&curve->algebra, &curve->codes[curve->best], KNOT_X_ORDINARY_10000,
                              &curve->reading.invariants.signature, &work);
    r->result = (uint64_t)curve->reading.invariants.signature;
}

static void tristram(stage_row *r)
{
    knot_curve *curve = &r->inside->job.reader;
    knot_ops work = INT64_MAX;
    (void)vbss_knot_signature(&curve->algebra, &curve->codes[curve->best], KNOT_X_TRISTRAM_10000,
                              &curve->reading.invariants.signature_tristram, &work);
    r->result = (uint64_t)curve->reading.invariants.signature_tristram;
}

static void vassiliev(stage_row *r)
{
    knot_curve *curve = &r->inside->job.reader;
    knot_invariants *v = &curve->reading.invariants;
    knot_ops work = INT64_MAX;
    vbss_knot_vassiliev(&curve->codes[curve->best], &v->v2, &v->v3, &work);
    r->result = (uint64_t)v->v3;
}

static void close_and_read(stage_row *r)
{
    knot_curve *curve = &r->inside->job.reader;
    knot_ops work = INT64_MAX;
    copy_input(r);
    close_thread(r);
    curve->direction_limit = r->inside->config.direction_limit;
    vbss_knot_curve_begin(curve, true);
    (void)vbss_knot_curve_resume(curve, &work);
    r->result = curve->reading.crossings;
}

/* ---- the whole reading, by its own job in the smallest pieces */

static void begin_reading(stage_row *r)
{
    copy_input(r);
    vbss_knot_job_begin(&r->inside->job, &r->inside->config, 1);
    r->result = r->inside->job.core.polygon.count;
}

/* How far a reading is: one more with each stage that follows. */
static uint32_t progress(const knot_job *job)
{
    switch (job->stage) {
    case KNOT_JOB_CORE:
        return 0;
    case KNOT_JOB_CURVES:
        return job->curve <= KNOT_CURVE_OUTWARD ? 1 : job->curve <= KNOT_CURVE_LONG ? 2 : 3;
    case KNOT_JOB_LOCATE:
        return job->locator.stage < KNOT_LOCATE_CHECK ? 4 : 5;
    default:
        return 6;
    }
}

static void read_beyond(stage_row *r, uint32_t done)
{
    knot_job *job = &r->inside->job;
    while (progress(job) <= done && vbss_knot_job_is_active(job)) {
        knot_ops work = 1;
        (void)vbss_knot_job_resume(job, &r->inside->config, &work);
    }
    r->result = (uint64_t)job->ops_used;
}

static void read_core(stage_row *r)
{
    read_beyond(r, 0);
}

static void read_outward(stage_row *r)
{
    read_beyond(r, 1);
}

static void read_limbs(stage_row *r)
{
    read_beyond(r, 2);
}

static void read_others(stage_row *r)
{
    read_beyond(r, 3);
}

static void locate(stage_row *r)
{
    read_beyond(r, 4);
}

static void confirm_order(stage_row *r)
{
    read_beyond(r, 5);
}

static void read_whole(stage_row *r)
{
    knot_ops work = INT64_MAX;
    begin_reading(r);
    (void)vbss_knot_job_resume(&r->inside->job, &r->inside->config, &work);
    r->result = (uint64_t)r->inside->job.ops_used;
}

/* ---- what is done in every step */

static void wind_both(stage_row *r)
{
    for (uint32_t i = 0; i < r->inside->job.input.tool_count; i++) {
        knot_winding winding;
        vbss_knot_measure_winding(&r->inside->job.input, i, &winding);
        r->result = winding.runs;
        bench_keep_memory(&winding);
    }
}

/* Readings only when something is wrapped or no longer: never here. */
static void step_alone(stage_row *r)
{
    (void)vbss_knot_detector_step(r->detector, &r->inputs[r->at]);
    r->result = r->inside->statistics.readings;
}

/* ---- the stages */

#define THROWS "three throws"
#define OPEN "ends inside" /* so that other closures are read too */

static const stage stages[] = {
    {"closure", THROWS, close_and_read, true, "crossings"},
    {"determinant", THROWS, determinant, false, NULL},
    {"signature", THROWS, signature, false, NULL},
    {"signature-tristram", THROWS, tristram, false, NULL},
    {"vassiliev", THROWS, vassiliev, false, NULL},
    {"input", THROWS, copy_input, true, NULL},
    {"close", THROWS, close_thread, false, "vertices"},
    {"reduction", THROWS, reduce, false, "vertices"},
    {"projection", THROWS, project, false, "crossings"},
    {"simplify", THROWS, simplify, false, "crossings"},
    {"twists", THROWS, take_apart, false, "certified"},
    {"untangle", THROWS, untangle, false, "crossings"},
    {"reading", THROWS, read_whole, true, "work"},
    {"begin", THROWS, begin_reading, true, NULL},
    {"core", THROWS, read_core, false, NULL},
    {"outward", THROWS, read_outward, false, NULL},
    {"limbs", THROWS, read_limbs, false, NULL},
    {"others", THROWS, read_others, false, NULL},
    {"locate", THROWS, locate, false, NULL},
    {"order", THROWS, confirm_order, false, NULL},
    {"open-reading", OPEN, read_whole, true, "work"},
    {"open-begin", OPEN, begin_reading, true, NULL},
    {"open-core", OPEN, read_core, false, NULL},
    {"open-outward", OPEN, read_outward, false, NULL},
    {"open-limbs", OPEN, read_limbs, false, NULL},
    {"open-others", OPEN, read_others, false, NULL},
    {"open-locate", OPEN, locate, false, NULL},
    {"open-order", OPEN, confirm_order, false, NULL},
    {"step-input", NULL, copy_input, true, NULL},
    {"winding", NULL, wind_both, false, NULL},
    {"step", NULL, step_alone, true, "readings"},
};
enum { STAGES = sizeof stages / sizeof stages[0] };
_Static_assert((int)STAGES <= (int)MAX_STAGES, "room for all");

/* ---- rows */

static stage_row rows[SIZES][MAX_STAGES];

static void run_those_before(stage_row *r)
{
    const stage *first = r->stage;
    while (!first->first) {
        first--;
    }
    for (const stage *s = first; s < r->stage; s++) {
        s->run(r);
    }
}

static int set_up(void *user)
{
    stage_row *r = user;
    vbss_knot_detector_config config;
    r->observed = 0;
    r->sum = 0.0;
    if (r->stage->family == NULL) {
        r->inputs = wound_inputs(r->segments, r->wanted);
    } else {
        const shown_set *set = shown_set_of(family_named(r->stage->family), r->segments, r->wanted);
        r->inputs = set != NULL ? set->inputs : NULL;
    }
    if (r->inputs == NULL || vbss_knot_detector_config_init(&config, sizeof config) != VBSS_OK ||
        vbss_context_create(NULL, &r->context) != VBSS_OK) {
        return 1;
    }
    config.interval = r->stage->family == NULL ? UINT32_MAX : config.interval;
    if (vbss_knot_detector_create(r->context, &config, &r->detector) != VBSS_OK ||
        vbss_knot_open(r->detector, &r->inside) != VBSS_OK ||
        vbss_knot_detector_judge(r->detector, &r->inputs[0]) != VBSS_OK) {
        vbss_context_destroy(r->context);
        return 1;
    }
    return 0;
}

static int restore(void *user)
{
    stage_row *r = user;
    r->at = 0;
    run_those_before(r);
    return 0;
}

static int step(void *user, uint32_t index)
{
    stage_row *r = user;
    (void)index;
    r->stage->run(r);
    return 0;
}

/* Adds up, then makes ready what the next configuration needs. */
static uint64_t hash(void *user)
{
    stage_row *r = user;
    uint64_t result = r->result;
    if (r->observed < r->wanted) {
        r->observed++;
        r->sum += (double)result;
    }
    if (++r->at < r->wanted) {
        run_those_before(r);
    }
    return result;
}

static void finish(void *user, bench_result *result)
{
    stage_row *r = user;
    if (r->stage->mean != NULL) {
        bench_counter(result, r->stage->mean, r->sum / r->wanted);
    }
}

static void tear_down(void *user)
{
    stage_row *r = user;
    vbss_context_destroy(r->context);
    r->context = NULL;
    wound_end();
}

void add_stage_cases(bench *b)
{
    bool quick = bench_is_quick(b);
    for (int k = 0; k < SIZES; k++) {
        if (quick && sizes[k] != 240) {
            continue;
        }
        for (int i = 0; i < STAGES; i++) {
            stage_row *r = &rows[k][i];
            *r = (stage_row){.stage = &stages[i],
                             .segments = sizes[k],
                             .wanted = quick ? QUICK_CONFIGURATIONS : CONFIGURATIONS};
            snprintf(r->name, sizeof r->name, "knots/stages/%s/%u", stages[i].name,
                     (unsigned)sizes[k]);
            bench_add_stepped(b, &(bench_stepped){.name = r->name,
                                                  .user = r,
                                                  .steps = r->wanted,
                                                  .setup = set_up,
                                                  .restore = restore,
                                                  .step = step,
                                                  .hash = hash,
                                                  .finish = finish,
                                                  .teardown = tear_down});
        }
    }
}
