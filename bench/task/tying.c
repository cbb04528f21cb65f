/* Cases task/tying/<last part>: a double throw that is drawn tight over the slit and held (tests/fixtures/session_scenes.h), with
 * one part more in each case beside the same scene: the scene goes through the same states in all of them, which is checked.
 *   throws    that the session has seen tied
 *   gap_mm    of the slit at the end */
#include "base/error.h"
#include "fixtures/session_scenes.h"
#include "task/bench_task.h"

enum { CROSSINGS = 5 /* of the limbs: a double throw */, HASH_INTERVAL = 100 };

typedef enum part { PART_SESSION, PART_KNOTS, PART_METRICS, PART_RECORD, PART_HASHES, PARTS } part;

typedef struct tying_case {
    const char *name;
    part last;
    vbss_context *context;
    session_scene scene;
    vbss_session *session;
    vbss_record *record;
} tying_case;

static tying_case cases[PARTS] = {{.name = "task/tying/5-session"},
                                  {.name = "task/tying/6-knots"},
                                  {.name = "task/tying/7-metrics"},
                                  {.name = "task/tying/8-recorded"},
                                  {.name = "task/tying/9-hashed"}};
static uint64_t last_hash; /* of the first case, 0: not run */

static vbss_result make(tying_case *c)
{
    VBSS_TRY(vbss_context_create(NULL, &c->context));
    VBSS_TRY(session_scene_tying(c->context, CROSSINGS, &c->scene));
    if (c->last < PART_KNOTS) {
        c->scene.config.knots = NULL;
    }
    if (c->last < PART_METRICS) {
        c->scene.config.metrics = NULL;
    }
    if (c->last >= PART_RECORD) {
        vbss_record_config record;
        VBSS_TRY(vbss_record_config_init(&record, sizeof record));
        record.hash_interval = c->last >= PART_HASHES ? 1 : HASH_INTERVAL;
        VBSS_TRY(vbss_record_create(c->scene.scene, &record, &c->record));
        c->scene.config.record = c->record;
    }
    return vbss_session_create(c->scene.scene, &c->scene.config, &c->session);
}

static void tear_down(void *user)
{
    tying_case *c = user;
    if (c->context != NULL) {
        (void)vbss_context_destroy(c->context);
    }
    c->context = NULL;
    c->record = NULL;
}

static int restore(void *user)
{
    tear_down(user);
    return (int)make(user);
}

static int step(void *user, uint32_t index)
{
    tying_case *c = user;
    const uint8_t *bytes;
    uint64_t count;
    (void)index;
    VBSS_TRY(session_scene_tie(&c->scene, c->session, c->record));
    return c->record != NULL ? (int)vbss_record_take(c->record, &bytes, &count) : VBSS_OK;
}

static uint64_t hash(void *user)
{
    uint64_t value = 0;
    (void)vbss_scene_get_hash(((tying_case *)user)->scene.scene, &value);
    return value;
}

static void finish(void *user, bench_result *result)
{
    tying_case *c = user;
    vbss_session_status status;
    vbss_drain_gap gap;
    if (vbss_session_get_status(c->session, &status, sizeof status) != VBSS_OK ||
        vbss_drain_get_gap(c->scene.drain, &gap, sizeof gap) != VBSS_OK) {
        bench_fail(result, "no status");
        return;
    }
    if (last_hash != 0 && hash(c) != last_hash) {
        bench_fail(result, "what was added has changed the scene");
    }
    last_hash = hash(c);
    bench_counter(result, "throws", status.throws);
    bench_counter(result, "gap_mm", 1e3 * gap.gap);
    bench_counter(result, "nodes", c->scene.stitch.node_count);
}

void add_tying_cases(bench *b)
{
    for (int i = 0; i < PARTS; i++) {
        tying_case *c = &cases[i];
        c->last = (part)i;
        bench_add_stepped(b, &(bench_stepped){.name = c->name,
                                              .user = c,
                                              .steps = STITCH_TIE_STEPS,
                                              .dt_us = 1e6 * SESSION_SCENE_STEP,
                                              .deadline_us = 1e6 * SESSION_SCENE_STEP,
                                              .restore = restore,
                                              .step = step,
                                              .hash = hash,
                                              .finish = finish,
                                              .teardown = tear_down});
    }
}
