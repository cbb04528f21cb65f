/* Cases task/at-rest/<last part>: the scene of examples/needle, in which the task begins, with one part more in each case.
 * The thread of 300 segments and the needle lie on the floor, the drain stands on it, both tools are moved in the air: what the
 * parts cost by being there. An absent part costs nothing if a case costs what its own parts do.
 *   contacts   at the end
 *   log_bytes  a step, of the record */
#include <math.h>

#include "base/elementary.h"
#include "needle/site.h"
#include "task/bench_task.h"

#define STEP_S 1e-3
enum { STEPS = 1000, SEGMENTS = 300, TOOLS = 2, HASH_INTERVAL = 100 };

/* In the order in which they are added. */
typedef enum part {
    PART_NOTHING,
    PART_THREAD,
    PART_TOOLS,
    PART_DRAIN,
    PART_NEEDLE,
    PART_SESSION, /* that looks at bodies alone */
    PART_KNOTS,
    PART_METRICS,
    PART_RECORD, /* with a hash every HASH_INTERVAL steps */
    PART_HASHES, /* in every step, as is the default */
    PARTS
} part;

typedef struct parts_case {
    const char *name;
    part last;
    site site;
    vbss_grasper *tools[TOOLS];
    uint32_t bodies[TOOLS];
    vbss_session *session; /* and its parts; NULL: none */
    vbss_record *record;
    uint64_t log_bytes;
} parts_case;

static parts_case cases[PARTS] = {
    {.name = "task/at-rest/0-empty"},    {.name = "task/at-rest/1-thread"},
    {.name = "task/at-rest/2-tools"},    {.name = "task/at-rest/3-drain"},
    {.name = "task/at-rest/4-needle"},   {.name = "task/at-rest/5-session"},
    {.name = "task/at-rest/6-knots"},    {.name = "task/at-rest/7-metrics"},
    {.name = "task/at-rest/8-recorded"}, {.name = "task/at-rest/9-hashed"},
};

/* ---- made anew for each repetition */

static bool has(const parts_case *c, part p)
{
    return c->last >= p;
}

static void tool_place(int tool, double time, double at[3])
{
    const double turn = 2.0 * 3.141592653589793 * time;
    at[0] = (tool == 0 ? -0.03 : 0.03) + 0.01 * vbss_cos(turn);
    at[1] = 0.01 * vbss_sin(turn);
    at[2] = 0.03;
}

static vbss_result add_tool(parts_case *c, int tool)
{
    vbss_grasper_config config;
    double at[3];
    tool_place(tool, 0.0, at);
    TRY(vbss_grasper_config_init(&config, sizeof config));
    TRY(vbss_grasper_create(c->site.rig.context, &config, &c->tools[tool]));
    TRY(vbss_grasper_set_target(c->tools[tool], at, NULL));
    return vbss_scene_add_grasper(c->site.rig.scene, c->tools[tool], &c->bodies[tool]);
}

static vbss_result add_session(parts_case *c)
{
    const site *s = &c->site;
    vbss_session_config config;
    TRY(vbss_session_config_init(&config, sizeof config));
    config.thread = s->rig.thread_body;
    config.needle = s->needle_body;
    config.drain = s->drain_body;
    config.tools[0] = c->bodies[0];
    config.tools[1] = c->bodies[1];
    if (has(c, PART_KNOTS)) {
        TRY(vbss_knot_detector_create(s->rig.context, NULL, &config.knots));
    }
    if (has(c, PART_METRICS)) {
        TRY(vbss_metrics_create(s->rig.context, NULL, &config.metrics));
    }
    if (has(c, PART_RECORD)) {
        vbss_record_config record;
        TRY(vbss_record_config_init(&record, sizeof record));
        record.hash_interval = has(c, PART_HASHES) ? 1 : HASH_INTERVAL;
        TRY(vbss_record_create(s->rig.scene, &record, &c->record));
        TRY(vbss_scene_set_recorder(s->rig.scene, c->record));
        config.record = c->record;
    }
    return vbss_session_create(s->rig.scene, &config, &c->session);
}

static vbss_result make(parts_case *c)
{
    const site_plan plan = {.segments = SEGMENTS,
                            .without = (has(c, PART_THREAD) ? 0u : SITE_NO_THREAD) |
                                       (has(c, PART_DRAIN) ? 0u : SITE_NO_DRAIN) |
                                       (has(c, PART_NEEDLE) ? 0u : SITE_NO_NEEDLE)};
    TRY(site_create(&c->site, v3(0.035, -0.005, 0.0), 3.141592653589793, &plan));
    for (int tool = 0; tool < TOOLS && has(c, PART_TOOLS); tool++) {
        TRY(add_tool(c, tool));
    }
    return has(c, PART_SESSION) ? add_session(c) : VBSS_OK;
}

static void tear_down(void *user)
{
    parts_case *c = user;
    if (c->site.rig.context != NULL) {
        (void)vbss_context_destroy(c->site.rig.context);
    }
    *c = (parts_case){.name = c->name, .last = c->last};
}

static int restore(void *user)
{
    tear_down(user);
    return (int)make(user);
}

/* ---- stepped */

static vbss_result move_tool(const parts_case *c, int tool, double time)
{
    double at[3];
    tool_place(tool, time, at);
    return vbss_grasper_set_target(c->tools[tool], at, NULL);
}

/* As a host would that keeps the log in memory. */
static vbss_result take_log(parts_case *c)
{
    const uint8_t *bytes;
    uint64_t count;
    TRY(vbss_record_take(c->record, &bytes, &count));
    c->log_bytes += count;
    return VBSS_OK;
}

static int step(void *user, uint32_t index)
{
    parts_case *c = user;
    for (int tool = 0; tool < TOOLS && has(c, PART_TOOLS); tool++) {
        TRY(move_tool(c, tool, STEP_S * (index + 1)));
    }
    TRY(c->session != NULL ? vbss_session_step(c->session, STEP_S * index, STEP_S)
                           : vbss_scene_step(c->site.rig.scene, STEP_S));
    return c->record != NULL ? take_log(c) : VBSS_OK;
}

static uint64_t hash(void *user)
{
    uint64_t value = 0;
    (void)vbss_scene_get_hash(((parts_case *)user)->site.rig.scene, &value);
    return value;
}

static void finish(void *user, bench_result *result)
{
    const parts_case *c = user;
    vbss_scene_statistics s;
    if (vbss_scene_get_statistics(c->site.rig.scene, &s, sizeof s) != VBSS_OK) {
        bench_fail(result, "no statistics");
        return;
    }
    bench_counter(result, "contacts", s.contacts);
    bench_counter(result, "log_bytes", (double)c->log_bytes / STEPS);
}

void add_part_cases(bench *b)
{
    for (int i = 0; i < PARTS; i++) {
        parts_case *c = &cases[i];
        c->last = (part)i;
        bench_add_stepped(b, &(bench_stepped){.name = c->name,
                                              .user = c,
                                              .steps = STEPS,
                                              .dt_us = 1e6 * STEP_S,
                                              .deadline_us = 1e6 * STEP_S,
                                              .restore = restore,
                                              .step = step,
                                              .hash = hash,
                                              .finish = finish,
                                              .teardown = tear_down});
    }
}
