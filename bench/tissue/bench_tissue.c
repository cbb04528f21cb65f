/* Suite tissue: what a step of the drain costs beside what it gets wrong. Cases tissue/<scene>/<method>/<mesh>:
 *   error_um      ours: farthest that a node is from where converged linearisations of the same steps have it, at any step
 *   gap_mm, pull_N  at the end; pull: of the hand on the right mark, where there is one
 *   dropped       second looks at the forces that were not believed
 * and of the scenes that only pull at the marks, by a millinewton, until all is at rest:
 *   k_marks, k_gap  N/mm, with their difference in percent from a mesh of 851 nodes
 * scenes.c adds those in which something touches the drain. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/error.h"
#include "drain/drain.h"
#include "harness/bench.h"
#include "fixtures/drain_scenes.h"
#include "tissue/scenes.h"

enum { MESHES = 4, REFERENCE_DIVISIONS = 2, RELAX_STEPS = 1500 };
static const unsigned nodes[MESHES] = {137, 159, 181, 225};
#define STEP_S 1e-3

typedef struct drain_case {
    char name[64];
    drain_scene_kind kind;
    vbss_method method;
    vbss_drain_mesh mesh;
    vbss_context *context;
    drain_scene scene;
} drain_case;

static drain_case cases[DRAIN_SCENE_KINDS][MESHES + 1]; /* the last by the paper's method */

/* ---- stepping */

static void end_drain(void *user)
{
    drain_case *c = user;
    (void)vbss_context_destroy(c->context);
    c->context = NULL;
}

static vbss_result make(vbss_context *context, const drain_case *c, bool converged,
                        drain_scene *scene)
{
    vbss_drain_config config;
    VBSS_TRY(drain_scene_config(c->kind, &config));
    config.method = c->method;
    config.mesh = c->mesh;
    if (converged) {
        config.iteration_limit = 50;
        config.position_tolerance = 1e-12;
    }
    return drain_scene_create(context, c->kind, &config, scene);
}

static int begin_drain(void *user)
{
    drain_case *c = user;
    end_drain(c);
    vbss_result result = vbss_context_create(NULL, &c->context);
    return (int)(result == VBSS_OK ? make(c->context, c, false, &c->scene) : result);
}

static uint32_t count_steps(void *user)
{
    return drain_scene_steps[((const drain_case *)user)->kind];
}

static int step_drain(void *user, uint32_t index)
{
    drain_case *c = user;
    (void)index;
    return (int)drain_scene_step(&c->scene, STEP_S);
}

static uint64_t hash_drain(void *user)
{
    drain_case *c = user;
    uint64_t hash = 0;
    (void)vbss_drain_get_hash(c->scene.drain, &hash);
    return hash;
}

/* ---- what it gets wrong */

static double farthest(vbss_drain *a, vbss_drain *b)
{
    vbss_view x, y;
    double largest = 0.0;
    if (vbss_drain_get_view(a, VBSS_DRAIN_VIEW_POSITIONS, &x, sizeof x) != VBSS_OK ||
        vbss_drain_get_view(b, VBSS_DRAIN_VIEW_POSITIONS, &y, sizeof y) != VBSS_OK) {
        return (double)NAN;
    }
    for (uint64_t i = 0; i < x.count; i++) {
        largest =
            vbss_max(vec3_distance(((const vec3 *)x.data)[i], ((const vec3 *)y.data)[i]), largest);
    }
    return largest;
}

/* Both from the begin, side by side. */
static double largest_error_um(const drain_case *c)
{
    vbss_context *context;
    drain_scene ours, right;
    double error = (double)NAN;
    if (vbss_context_create(NULL, &context) != VBSS_OK) {
        return error;
    }
    bool fine =
        make(context, c, false, &ours) == VBSS_OK && make(context, c, true, &right) == VBSS_OK;
    error = fine ? 0.0 : error;
    for (uint32_t i = 0; fine && i < drain_scene_steps[c->kind]; i++) {
        fine = drain_scene_step(&ours, STEP_S) == VBSS_OK &&
               drain_scene_step(&right, STEP_S) == VBSS_OK;
        error = vbss_max(farthest(ours.drain, right.drain), error);
    }
    (void)vbss_context_destroy(context);
    return fine ? 1e6 * error : (double)NAN;
}

static void finish_drain(void *user, bench_result *result)
{
    drain_case *c = user;
    vbss_drain_statistics statistics;
    vbss_drain_gap gap;
    double pull[3];
    (void)vbss_drain_get_statistics(c->scene.drain, &statistics, sizeof statistics);
    (void)vbss_drain_get_gap(c->scene.drain, &gap, sizeof gap);
    if (c->kind != DRAIN_SCENE_TUGGED &&
        c->method == VBSS_METHOD_IMPLICIT) { /* what snaps ends up elsewhere by any other steps */
        bench_counter(result, "error_um", largest_error_um(c));
    }
    bench_counter(result, "gap_mm", 1e3 * gap.gap);
    if (c->kind == DRAIN_SCENE_CLOSED &&
        vbss_drain_get_reaction(c->scene.drain, 2, pull) == VBSS_OK) {
        bench_counter(result, "pull_N", vec3_norm(vec3_load(pull)));
    }
    bench_counter(result, "parts", (double)statistics.parts);
    bench_counter(result, "dropped", (double)statistics.corrections_dropped);
    bench_counter(result, "inverted", (double)statistics.inverted);
}

/* ---- stiffness of the slit */

typedef struct stiffness {
    char name[64];
    vbss_drain_mesh mesh;
    uint32_t divisions;
    vbss_context *context;
    vbss_drain *drain;
    double marks_at_rest, gap_at_rest;
} stiffness;

static stiffness slits[MESHES];
#define SMALL_PULL 1e-3

static double marks_apart(vbss_drain *drain)
{
    vbss_drain_places places;
    vbss_view x;
    (void)vbss_drain_get_places(drain, &places, sizeof places);
    (void)vbss_drain_get_view(drain, VBSS_DRAIN_VIEW_POSITIONS, &x, sizeof x);
    const vec3 *p = x.data;
    return vec3_distance(p[places.marks[0]], p[places.marks[1]]);
}

static double gap_of(vbss_drain *drain)
{
    vbss_drain_gap gap = {0};
    (void)vbss_drain_get_gap(drain, &gap, sizeof gap);
    return gap.gap;
}

static vbss_result pull_marks(stiffness *s)
{
    vbss_drain_config config;
    vbss_drain_places places;
    VBSS_TRY(vbss_drain_config_init(&config, sizeof config));
    config.mesh = s->mesh;
    config.mesh_divisions = s->divisions;
    VBSS_TRY(vbss_drain_create(s->context, &config, &s->drain));
    VBSS_TRY(vbss_drain_get_places(s->drain, &places, sizeof places));
    s->marks_at_rest = marks_apart(s->drain);
    s->gap_at_rest = gap_of(s->drain);
    for (int side = 0; side < 2; side++) {
        vbss_drain_attachment a;
        uint32_t id;
        VBSS_TRY(vbss_drain_attachment_init(&a, sizeof a));
        a.kind = VBSS_DRAIN_ATTACHMENT_FORCE;
        a.node = places.marks[side];
        a.force[2] = side == 0 ? SMALL_PULL : -SMALL_PULL;
        VBSS_TRY(vbss_drain_attach(s->drain, &a, &id));
    }
    return VBSS_OK;
}

static void end_slit(void *user)
{
    stiffness *s = user;
    (void)vbss_context_destroy(s->context);
    s->context = NULL;
}

static int begin_slit(void *user)
{
    stiffness *s = user;
    end_slit(s);
    vbss_result result = vbss_context_create(NULL, &s->context);
    return (int)(result == VBSS_OK ? pull_marks(s) : result);
}

static int step_slit(void *user, uint32_t index)
{
    (void)index;
    return (int)vbss_drain_step(((stiffness *)user)->drain, STEP_S);
}

/* N/mm. */
static void get_stiffness(const stiffness *s, double *marks, double *gap)
{
    *marks = 1e-3 * SMALL_PULL / (s->marks_at_rest - marks_apart(s->drain));
    *gap = 1e-3 * SMALL_PULL / (s->gap_at_rest - gap_of(s->drain));
}

/* Once for all cases. */
static bool know_reference(double *marks, double *gap)
{
    static double known[2] = {-1.0, -1.0};
    static stiffness fine = {.mesh = VBSS_DRAIN_MESH_225, .divisions = REFERENCE_DIVISIONS};
    bool good = known[0] > 0.0;
    if (!good && begin_slit(&fine) == 0) {
        good = true;
        for (int i = 0; good && i < RELAX_STEPS; i++) {
            good = step_slit(&fine, 0) == 0;
        }
        get_stiffness(&fine, &known[0], &known[1]);
        end_slit(&fine);
    }
    *marks = known[0];
    *gap = known[1];
    return good;
}

static void finish_slit(void *user, bench_result *result)
{
    const stiffness *s = user;
    double marks, gap, right_marks, right_gap;
    get_stiffness(s, &marks, &gap);
    bench_counter(result, "k_marks", marks);
    bench_counter(result, "k_gap", gap);
    if (know_reference(&right_marks, &right_gap)) {
        bench_counter(result, "k_marks_error_percent", 100.0 * (marks / right_marks - 1.0));
        bench_counter(result, "k_gap_error_percent", 100.0 * (gap / right_gap - 1.0));
    } else {
        bench_fail(result, "no reference");
    }
}

/* ---- the suite */

static void add_drain(bench *b, drain_case *c)
{
    bench_add_stepped(b, &(bench_stepped){.name = c->name,
                                          .user = c,
                                          .count = count_steps,
                                          .dt_us = STEP_S * 1e6,
                                          .deadline_us = 1000.0,
                                          .restore = begin_drain,
                                          .step = step_drain,
                                          .hash = hash_drain,
                                          .finish = finish_drain,
                                          .teardown = end_drain});
}

static void add_cases(bench *b)
{
    add_scenes(b);
    add_pierced(b);
    add_stitched(b);
    for (int kind = 0; kind < DRAIN_SCENE_KINDS; kind++) {
        /* What snaps again and again takes long, and says nothing of meshes. */
        int meshes = kind == DRAIN_SCENE_TUGGED ? 1 : MESHES;
        for (int mesh = 0; mesh < meshes; mesh++) {
            drain_case *c = &cases[kind][mesh];
            c->kind = (drain_scene_kind)kind;
            c->mesh = mesh;
            snprintf(c->name, sizeof c->name, "tissue/%s/ours/%u", drain_scene_names[kind],
                     nodes[mesh]);
            add_drain(b, c);
        }
        drain_case *paper = &cases[kind][MESHES];
        paper->kind = (drain_scene_kind)kind;
        paper->method = VBSS_METHOD_VBLAST;
        snprintf(paper->name, sizeof paper->name, "tissue/%s/paper/85", drain_scene_names[kind]);
        add_drain(b, paper);
    }
    for (int mesh = 0; mesh < MESHES; mesh++) {
        stiffness *s = &slits[mesh];
        s->mesh = mesh;
        s->divisions = 1;
        snprintf(s->name, sizeof s->name, "tissue/slit/ours/%u", nodes[mesh]);
        bench_add_stepped(b, &(bench_stepped){.name = s->name,
                                              .user = s,
                                              .steps = RELAX_STEPS,
                                              .dt_us = STEP_S * 1e6,
                                              .deadline_us = 1000.0,
                                              .restore = begin_slit,
                                              .step = step_slit,
                                              .finish = finish_slit,
                                              .teardown = end_slit});
    }
}

int main(int argc, char **argv)
{
    const bench_suite suite = {"tissue", vbss_build_info(), add_cases};
    return bench_main(argc, argv, &suite);
}
