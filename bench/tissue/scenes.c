/* Cases tissue/scene-<scene>/<method>/<nodes>: a drain and what touches it, in one scene (tests/fixtures/tissue_scenes.h).
 *   force_N       largest force of the first tool
 *   overlap_um    deepest penetration
 *   gap_mm        at the end
 *   pull_N, alone_N  shut: what the marks are held with at the end; the same of a drain that nothing touches, not even itself
 *   parts, paused, clamped, dropped, inverted  how it went */
#include "tissue/scenes.h"

#include <stdio.h>

#include "fixtures/tissue_scenes.h"

#define STEP_S 1e-3

typedef struct scene_case {
    char name[64];
    tissue_scene_kind kind;
    vbss_method method;
    vbss_context *context;
    tissue_scene scene;
    double force;
} scene_case;

static scene_case cases[TISSUE_SCENE_KINDS][2]; /* by method */

static void end_scene(void *user)
{
    scene_case *c = user;
    (void)vbss_context_destroy(c->context);
    c->context = NULL;
}

static int begin_scene(void *user)
{
    scene_case *c = user;
    vbss_scene_config scene;
    vbss_drain_config drain;
    end_scene(c);
    c->force = 0.0;
    vbss_result result = vbss_context_create(NULL, &c->context);
    if (result == VBSS_OK) {
        result = tissue_scene_configs(c->kind, c->method, &scene, &drain);
    }
    if (result == VBSS_OK) {
        result = tissue_scene_create(c->context, c->kind, &scene, &drain, &c->scene);
    }
    return (int)result;
}

static uint32_t count_steps(void *user)
{
    return tissue_scene_steps[((const scene_case *)user)->kind];
}

static int step_scene(void *user, uint32_t index)
{
    scene_case *c = user;
    (void)index;
    return (int)tissue_scene_step(&c->scene, STEP_S);
}

/* Not timed: what the step has left is looked at as well. */
static uint64_t hash_scene(void *user)
{
    scene_case *c = user;
    vbss_scene_rigid_state tool;
    uint64_t hash = 0;
    if (c->scene.tools[0] != 0 &&
        vbss_scene_get_rigid(c->scene.scene, c->scene.tools[0], &tool, sizeof tool) == VBSS_OK) {
        c->force = vbss_max(vec3_norm(vec3_load(tool.contact_force)), c->force);
    }
    (void)vbss_scene_get_hash(c->scene.scene, &hash);
    return hash;
}

/* ---- what the lips add */

static double pull_of(vbss_drain *drain)
{
    double pull[3];
    bool known = vbss_drain_get_reaction(drain, 2, pull) == VBSS_OK;
    return known ? vec3_norm(vec3_load(pull)) : (double)NAN;
}

/* The same drain with the same hands, taken out of its scene. */
static double pull_alone(void)
{
    vbss_context *context;
    vbss_scene_config scene;
    vbss_drain_config drain;
    tissue_scene t;
    double pull = (double)NAN;
    if (vbss_context_create(NULL, &context) != VBSS_OK) {
        return pull;
    }
    bool fine =
        tissue_scene_configs(TISSUE_SCENE_SHUT, VBSS_METHOD_IMPLICIT, &scene, &drain) == VBSS_OK &&
        tissue_scene_create(context, TISSUE_SCENE_SHUT, &scene, &drain, &t) == VBSS_OK &&
        vbss_scene_remove(t.scene, t.drain_body) == VBSS_OK;
    for (uint32_t i = 0; fine && i < tissue_scene_steps[TISSUE_SCENE_SHUT]; i++) {
        fine = tissue_scene_shut(&t, STEP_S * (i + 1.0)) == VBSS_OK &&
               vbss_drain_step(t.drain, STEP_S) == VBSS_OK;
    }
    pull = fine ? pull_of(t.drain) : pull;
    (void)vbss_context_destroy(context);
    return pull;
}

static void finish_scene(void *user, bench_result *result)
{
    scene_case *c = user;
    vbss_scene_statistics s;
    vbss_drain_statistics d;
    vbss_drain_gap gap;
    (void)vbss_scene_get_statistics(c->scene.scene, &s, sizeof s);
    (void)vbss_drain_get_statistics(c->scene.drain, &d, sizeof d);
    (void)vbss_drain_get_gap(c->scene.drain, &gap, sizeof gap);
    if (c->scene.tools[0] != 0) {
        bench_counter(result, "force_N", c->force);
    }
    bench_counter(result, "overlap_um", 1e6 * s.penetration);
    bench_counter(result, "gap_mm", 1e3 * gap.gap);
    if (c->kind == TISSUE_SCENE_SHUT) {
        bench_counter(result, "pull_N", pull_of(c->scene.drain));
        if (c->method == VBSS_METHOD_IMPLICIT) {
            bench_counter(result, "alone_N", pull_alone());
        }
    }
    bench_counter(result, "parts", (double)s.parts);
    bench_counter(result, "paused", (double)s.paused);
    bench_counter(result, "clamped", (double)s.clamped);
    bench_counter(result, "dropped", (double)d.corrections_dropped);
    bench_counter(result, "inverted", (double)d.inverted);
}

static void add_scene(bench *b, tissue_scene_kind kind, vbss_method method)
{
    bool paper = method == VBSS_METHOD_VBLAST;
    scene_case *c = &cases[kind][method];
    c->kind = kind;
    c->method = method;
    snprintf(c->name, sizeof c->name, "tissue/scene-%s/%s", tissue_scene_names[kind],
             paper ? "paper/85" : "ours/137");
    bench_add_stepped(b, &(bench_stepped){.name = c->name,
                                          .user = c,
                                          .count = count_steps,
                                          .dt_us = STEP_S * 1e6,
                                          .deadline_us = 1000.0,
                                          .restore = begin_scene,
                                          .step = step_scene,
                                          .hash = hash_scene,
                                          .finish = finish_scene,
                                          .teardown = end_scene});
}

void add_scenes(bench *b)
{
    for (int kind = 0; kind < TISSUE_SCENE_KINDS; kind++) {
        add_scene(b, (tissue_scene_kind)kind, VBSS_METHOD_IMPLICIT);
        /* The paper's drain has no block to be torn from, and its thread none to pass its load on to. */
        if (kind != TISSUE_SCENE_LIFTED && kind != TISSUE_SCENE_LADEN) {
            add_scene(b, (tissue_scene_kind)kind, VBSS_METHOD_VBLAST);
        }
    }
}
