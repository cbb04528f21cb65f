/* Steps, queries, and the life of a fuzzed scene. */
#include "fixtures/solver_of.h"
#include "fuzz/scenes/fuzzed_scene.h"

#include <stdlib.h>
#include <string.h>

static void move_tools(fuzz_scene *f)
{
    for (uint32_t i = 1; i <= f->last_number; i++) {
        if (f->bodies[i].has_target && !f->bodies[i].is_removed && fuzz_chance(f, 0.7)) {
            fuzz_move_tool(f, i);
        }
    }
}

static void trace_statistics(const fuzz_scene *f, const vbss_scene_statistics *s)
{
    fuzz_trace(f,
               "attempts %llu, substeps %llu, rejected: states %llu stretch %llu depth %llu CCD "
               "%llu singular %llu "
               "full %llu; clamped %llu paused %llu behind %u",
               (unsigned long long)s->attempts, (unsigned long long)s->parts,
               (unsigned long long)s->rejected_states, (unsigned long long)s->rejected_stretch,
               (unsigned long long)s->rejected_depth, (unsigned long long)s->rejected_guard,
               (unsigned long long)s->rejected_singular, (unsigned long long)s->rejected_full,
               (unsigned long long)s->clamped, (unsigned long long)s->paused, s->behind);
}

static void trace_blockers(const fuzz_scene *f)
{
    vbss_scene_blocker b;
    for (uint32_t i = 0; f->findings->is_traced &&
                         vbss_scene_get_blocker(f->sides[0].scene, i, &b, sizeof b) == VBSS_OK;
         i++) {
        fuzz_trace(f, "held back since %g s: bodies %u and %u, cause %d, lost %g s, depth %g m",
                   b.since, b.body_a, b.body_b, b.cause, b.lost_time, b.depth);
    }
}

static void count_what_happens(fuzz_scene *f)
{
    vbss_scene_statistics statistics;
    vbss_scene_hole hole;
    vbss_scene_grasp grasp;
    bool has_grasp = false;
    vbss_scene *scene = f->sides[0].scene;
    (void)vbss_scene_get_statistics(scene, &statistics, sizeof statistics);
    f->findings->suspended += statistics.behind > 0;
    trace_statistics(f, &statistics);
    trace_blockers(f);
    f->findings->holes += vbss_scene_get_hole(scene, 0, &hole, sizeof hole) == VBSS_OK;
    for (uint32_t i = 1; i <= f->last_number; i++) {
        has_grasp =
            has_grasp || (f->bodies[i].kind == FUZZ_GRASPER &&
                          vbss_scene_get_grasp(scene, i, 0, &grasp, sizeof grasp) == VBSS_OK);
    }
    f->findings->grasps += has_grasp;
}

void fuzz_step(fuzz_scene *f)
{
    const double rare = 1e-4 * FUZZ_PICK(f, 1, 10, 100, 1000), now_and_then = fuzz_spoil(f, rare);
    const double h = fuzz_chance(f, 0.03) ? now_and_then : f->h;
    fuzz_trace(f, "%g s", h);
    FUZZ_CALL(f, vbss_scene_step(side->scene, h));
    if (f->results[0] == VBSS_OK) {
        fuzz_check_after_step(f);
        count_what_happens(f);
    } else if (f->results[0] == VBSS_ERROR_CAPACITY) {
        f->witness.stationary_steps = 0; /* the status says why nothing moves */
    }
}

void fuzz_query_at_random(fuzz_scene *f)
{
    const uint32_t body = fuzz_below(f, f->last_number + 3), index = fuzz_below(f, 3);
    vbss_scene_statistics statistics;
    vbss_scene_rigid_state rigid;
    vbss_view view;
    vbss_scene_grasp grasp;
    vbss_scene_hole hole;
    vbss_scene_blocker blocker;
    uint64_t hash;
    switch (fuzz_below(f, 7)) {
    case 0:
        FUZZ_QUERY(f, vbss_scene_get_statistics(side->scene, &statistics, sizeof statistics));
        break;
    case 1:
        FUZZ_QUERY(f, vbss_scene_get_rigid(side->scene, body, &rigid, sizeof rigid));
        break;
    case 2:
        FUZZ_QUERY(f, vbss_scene_get_view(side->scene, (vbss_scene_field)fuzz_below(f, 8), &view,
                                          sizeof view));
        break;
    case 3:
        FUZZ_QUERY(f, vbss_scene_get_grasp(side->scene, body, index, &grasp, sizeof grasp));
        break;
    case 4:
        FUZZ_QUERY(f, vbss_scene_get_hole(side->scene, index, &hole, sizeof hole));
        break;
    case 5:
        FUZZ_QUERY(f, vbss_scene_get_blocker(side->scene, index, &blocker, sizeof blocker));
        break;
    default:
        FUZZ_QUERY(f, vbss_scene_get_hash(side->scene, &hash));
        break;
    }
}

static void follow_script(fuzz_scene *f)
{
    const fuzz_scripted_call *call = &f->script[f->script_position++];
    if (call->action == FUZZ_STEP) {
        fuzz_step(f);
    } else {
        const double opening = call->action == FUZZ_CLOSE ? 0.0 : 1.0;
        FUZZ_CALL(f, vbss_grasper_set_opening(side->handles[call->tool], opening));
    }
}

void fuzz_make_random_call(fuzz_scene *f)
{
    if (f->script_position < f->script_length && fuzz_chance(f, 0.8)) {
        follow_script(f);
        return;
    }
    const uint32_t choice = fuzz_below(f, 100);
    if (choice < 65) {
        if (fuzz_chance(f, 0.7)) {
            move_tools(f);
        }
        fuzz_step(f);
    } else if (choice < 85) {
        fuzz_edit_at_random(f);
    } else if (choice < 95) {
        fuzz_restore_at_random(f);
    } else {
        fuzz_query_at_random(f);
    }
}

/* A scene is destroyed before its bodies, or with them by the context. */
static void destroy(fuzz_scene *f, bool scene_first)
{
    for (uint32_t k = 0; k < FUZZ_SIDES; k++) {
        fuzz_side *side = &f->sides[k];
        if (scene_first) {
            (void)vbss_scene_destroy(side->scene);
            for (uint32_t i = 1; i <= f->last_number; i++) {
                if (f->bodies[i].kind == FUZZ_NEEDLE) {
                    (void)vbss_needle_step(side->handles[i], 1e-3);
                }
            }
        }
        (void)vbss_context_destroy(side->context);
        free(side->snapshot.data);
    }
    free(f->scratch.data);
    free(f->earlier.data);
}

static void print_config(const fuzz_scene *f)
{
    const vbss_scene_config *c = &f->config;
    printf("  %s, method %d, step_budget %u, call_budget %u, attempt_limit %u, halving_limit %u, "
           "contacts %u, "
           "candidates %u, drains %u, floor %d, h %g s\n",
           c->mode == VBSS_SCENE_MODE_OFFLINE ? "offline" : "real time", c->method,
           step_operations(c), call_operations(c), solver_values(c).attempt_limit,
           solver_values(c).halving_limit, c->contact_capacity, c->candidate_capacity,
           c->drain_capacity, c->floor, f->h);
    for (uint32_t i = 1; i <= f->last_number; i++) {
        static const char *const names[] = {"none",   "thread",  "drain",
                                            "needle", "grasper", "rigid"};
        printf("  body %u: %s%s\n", i, names[f->bodies[i].kind],
               i == f->witness.number ? ", the witness" : "");
    }
}

void fuzz_run_scene(fuzz_findings *findings, uint64_t seed, uint64_t scene, uint32_t calls)
{
    fuzz_scene *f = calloc(1, sizeof *f);
    f->findings = findings;
    vbss_random_seed(&f->source.random, seed, scene);
    findings->scene = scene;
    findings->call = 0;
    const bool is_built = fuzz_build_scene(f);
    if (is_built && findings->is_traced) {
        print_config(f);
    }
    for (uint32_t i = 0; is_built && i < calls && !f->has_failed; i++) {
        findings->call = i + 1;
        findings->calls++;
        fuzz_make_random_call(f);
    }
    fuzz_begin_call(f, "vbss_context_destroy");
    destroy(f, fuzz_chance(f, 0.5));
    findings->scenes++;
    free(f);
}
