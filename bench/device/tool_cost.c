/* What tools cost beside a thread with fixed ends: none, one far away, one that holds it, two that do; and what it
 * costs alone to look for strands while jaws close. */
#include <stdio.h>

#include "base/elementary.h"
#include "base/error.h"
#include "bench_device.h"
#include "scene/api/api.h"
#include "scene/tools/tools.h"
#include "scene/world/world.h"
#include "tool_rig.h"

enum { STEPS = 600, AT_REST = 300 };

typedef enum tool_cost_kind { ALONE, FAR_AWAY, HELD, HELD_TWICE, KINDS } tool_cost_kind;

typedef struct tool_cost {
    char name[64];
    tool_cost_kind kind;
    uint32_t nodes;
    tool_rig rig;
    vec3 tips[TOOL_RIG_TOOLS];
} tool_cost;

static vbss_result make(tool_cost *c)
{
    tool_rig *r = &c->rig;
    bool twice = c->kind == HELD_TWICE;
    VBSS_TRY(tool_rig_begin(r));
    VBSS_TRY(tool_rig_thread(r, c->nodes - 1, TOOL_RIG_BOTH));
    if (c->kind != ALONE) {
        c->tips[0] = vec3_make(c->kind == FAR_AWAY ? 0.1 : 0.0, twice ? -6e-3 : 0.0, -2e-3);
        VBSS_TRY(tool_rig_add(r, c->tips[0]));
    }
    if (twice) {
        c->tips[1] = vec3_make(0.0, 6e-3, -2e-3);
        VBSS_TRY(tool_rig_add(r, c->tips[1]));
    }
    VBSS_TRY(tool_rig_close(r));
    VBSS_TRY(tool_rig_steps(r, AT_REST));
    return tool_rig_save(r);
}

static int setup(void *user)
{
    tool_cost *c = user;
    vbss_result result = make(c);
    if (result != VBSS_OK) {
        tool_rig_end(&c->rig);
    }
    return result;
}

static int restore(void *user)
{
    tool_cost *c = user;
    return tool_rig_restore(&c->rig);
}

/* Hands draw aside, by 1 mm/s. */
static int step(void *user, uint32_t index)
{
    tool_cost *c = user;
    for (uint32_t i = 0; i < c->rig.count; i++) {
        vec3 aside = vec3_make(1e-6 * (index + 1), 0.0, 0.0);
        VBSS_TRY(tool_rig_move(&c->rig, i, vec3_add(c->tips[i], aside)));
    }
    return tool_rig_steps(&c->rig, 1);
}

static uint64_t hash(void *user)
{
    const tool_cost *c = user;
    return tool_rig_hash(&c->rig);
}

static void finish(void *user, bench_result *result)
{
    const tool_cost *c = user;
    uint32_t holding = 0;
    for (uint32_t i = 0; i < c->rig.count; i++) {
        holding += tool_rig_holds(&c->rig, i) ? 1 : 0;
    }
    bench_counter(result, "tools_holding", holding);
    if (holding != (c->kind < HELD ? 0u : (uint32_t)c->kind - HELD + 1u)) {
        bench_fail(result, "%u tools hold the thread", holding);
    }
}

static void teardown(void *user)
{
    tool_cost *c = user;
    tool_rig_end(&c->rig);
}

/* ---- looking for strands */

enum { SEARCHES = 100, MAX_NODES = 301 };

typedef struct strand_search {
    char name[64];
    uint32_t nodes;
    bool coiled; /* round the jaws, 6 mm from their middle */
    tool_rig rig;
} strand_search;

static vbss_result coil(strand_search *l)
{
    static double x[MAX_NODES][3];
    for (uint32_t i = 0; i < l->nodes; i++) {
        vbss_sincos(i / 12.0, &x[i][1], &x[i][0]);
        x[i][0] *= 6e-3;
        x[i][1] *= 6e-3;
        x[i][2] = 0.04e-3 * i - 2e-3;
    }
    return vbss_thread_set_state(l->rig.thread, x[0], NULL, l->nodes);
}

static vbss_result make_search(strand_search *l)
{
    VBSS_TRY(tool_rig_begin(&l->rig));
    VBSS_TRY(tool_rig_thread(&l->rig, l->nodes - 1, TOOL_RIG_NEITHER));
    if (l->coiled) {
        VBSS_TRY(coil(l));
    }
    VBSS_TRY(tool_rig_add(&l->rig, vec3_make(0.0, 0.0, -2e-3)));
    return vbss_grasper_set_opening(l->rig.tools[0], 0.0);
}

static int setup_search(void *user)
{
    strand_search *l = user;
    vbss_result result = make_search(l);
    if (result != VBSS_OK) {
        tool_rig_end(&l->rig);
    }
    return result;
}

/* The first step of closing jaws, again and again: they are still too far open to take anything. */
static void run_search(void *user)
{
    strand_search *l = user;
    scene_object *s;
    if (vbss_scene_open(l->rig.scene, &s) == VBSS_OK) {
        scene_body *tool = vbss_scene_body(s, l->rig.bodies[0]);
        for (int i = 0; i < SEARCHES; i++) {
            bench_keep(vbss_scene_close_jaws(s, tool, 1e-3));
        }
    }
}

static void teardown_search(void *user)
{
    strand_search *l = user;
    tool_rig_end(&l->rig);
}

static void add_search_cases(bench *b)
{
    static strand_search cases[] = {
        {.nodes = 61}, {.nodes = MAX_NODES}, {.nodes = MAX_NODES, .coiled = true}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        strand_search *l = &cases[i];
        snprintf(l->name, sizeof l->name, "device/tool-looking/%s/%u",
                 l->coiled ? "coiled" : "straight", (unsigned)l->nodes);
        const bench_batch batch = {.name = l->name,
                                   .user = l,
                                   .items = SEARCHES,
                                   .setup = setup_search,
                                   .run = run_search,
                                   .teardown = teardown_search};
        bench_add_batch(b, &batch);
    }
}

void add_tool_cost_cases(bench *b)
{
    static const char *const names[KINDS] = {"thread-alone", "tool-far-away", "held", "held-twice"};
    static const uint32_t nodes[] = {61, 301};
    static tool_cost cases[KINDS][2];
    for (int kind = 0; kind < KINDS; kind++) {
        for (int n = 0; n < 2; n++) {
            tool_cost *c = &cases[kind][n];
            c->kind = (tool_cost_kind)kind;
            c->nodes = nodes[n];
            snprintf(c->name, sizeof c->name, "device/tool-step/%s/%u", names[kind],
                     (unsigned)c->nodes);
            const bench_stepped stepped = {.name = c->name,
                                           .user = c,
                                           .steps = STEPS,
                                           .dt_us = 1e3,
                                           .setup = setup,
                                           .restore = restore,
                                           .step = step,
                                           .hash = hash,
                                           .finish = finish,
                                           .teardown = teardown};
            bench_add_stepped(b, &stepped);
        }
    }
    add_search_cases(b);
}
