/* How much one knot holds: ties it, lets go of it, grows what it is tied round, and prints what came of it as one
 * line of JSON. run.py runs many of them. The protocol is told in docs/explanation/knot-holding.md.
 *
 *     knots_hold <knot> <seating force, N> <friction> <seed> [name=value ...] [friction_torque] [limited] [trace=file]
 *
 * Names: material (silk, polyglactin, polypropylene or nylon, each of size 3-0), bending (EI, N m^2), yield (1/m), hardening,
 * relaxation (ratio), relaxation_time (s), torsion (GJ, N m^2), finest (m, of the mesh), step (s), stiffness (of contacts, N/m), growth (m/s),
 * limit (N). Later ones change what a material sets. Seed 0 is the knot as it is laid out, others are disturbed. The trace has a line a step: growth, tension, slip, line in the knot. */
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/error.h"
#include "fixtures/solver_of.h"
#include "oracle/knot_type.h"
#include "fixtures/held_knot.h"

static int find_kind(const char *name)
{
    int kind = 0;
    while (kind < KNOT_KINDS && strcmp(knot_names[kind], name) != 0) {
        kind++;
    }
    return kind;
}

/* Shapes and mesh follow the thread's radius. */
static bool set_material(held_knot_options *o, const char *name)
{
    static const char *const names[] = {"silk", "polyglactin", "polypropylene", "nylon"};
    vbss_thread_config *thread = &o->tied.thread;
    const double before = thread->radius;
    for (int32_t i = 0; i < 4; i++) {
        if (strcmp(names[i], name) == 0) {
            bool good = vbss_thread_config_suture(thread, VBSS_THREAD_MATERIAL_SILK + i,
                                                  VBSS_THREAD_USP_3_0) == VBSS_OK;
            o->tied.knot.size *= thread->radius / before;
            o->tied.knot.finest *= thread->radius / before;
            return good;
        }
    }
    return false;
}

/* False when there is no such option. */
static bool set_option(held_knot_options *o, const char *text)
{
    const struct {
        const char *name;
        double *value;
    } options[] = {{"bending", &o->tied.thread.bending_stiffness},
                   {"yield", &o->tied.thread.yield_curvature},
                   {"hardening", &o->tied.thread.yield_hardening},
                   {"relaxation", &o->tied.thread.relaxation_ratio},
                   {"relaxation_time", &o->tied.thread.relaxation_time},
                   {"torsion", &o->tied.thread.torsional_stiffness},
                   {"finest", &o->tied.knot.finest},
                   {"step", &o->step},
                   {"stiffness", &o->tied.scene.contact_stiffness},
                   {"growth", &o->growth},
                   {"limit", &o->limit}};
    if (strncmp(text, "material=", 9) == 0) {
        return set_material(o, text + 9);
    }
    if (strcmp(text, "friction_torque") == 0) {
        o->tied.thread.friction_torque = 1;
        return true;
    }
    if (strcmp(text, "limited") == 0) { /* as scenes are by default */
        vbss_scene_config scene;
        (void)vbss_scene_config_init(&scene, sizeof scene);
        set_step_operations(&o->tied.scene, step_operations(&scene));
        solver_of(&o->tied.scene)->attempt_limit = solver_values(&scene).attempt_limit;
        return true;
    }
    const char *equals = strchr(text, '=');
    size_t length = equals != NULL ? (size_t)(equals - text) : 0;
    for (size_t i = 0; i < sizeof options / sizeof options[0]; i++) {
        if (strlen(options[i].name) == length && strncmp(options[i].name, text, length) == 0) {
            *options[i].value = strtod(equals + 1, NULL);
            return true;
        }
    }
    return false;
}

static vbss_result run(held_knot *k, FILE *trace)
{
    VBSS_TRY(held_knot_tie(k));
    bool goes_on = k->end == HELD_KNOT_GREW;
    while (goes_on) {
        VBSS_TRY(held_knot_grow(k, &goes_on));
        if (trace != NULL) {
            fprintf(trace, "%.6g %.6g %.6g %.6g\n", 1e3 * k->grown, k->tension,
                    1e3 * held_knot_drawn_in(&k->resting, &k->edges),
                    1e3 * held_knot_inside(&k->edges));
        }
    }
    return VBSS_OK;
}

static bool type_kept(const held_knot *k)
{
    const vec3 *x;
    uint32_t count;
    const knot_shape *shape = &k->options.tied.knot;
    knot_type found, right = knot_type_of_kind(shape->kind, shape->mirrored);
    return held_knot_strand(k, &x, &count) == VBSS_OK && knot_type_of(x, count, &found) &&
           knot_type_same(found, right);
}

static vbss_result print(const held_knot *k, double asked)
{
    vbss_scene_statistics s;
    const held_knot_options *o = &k->options;
    VBSS_TRY(vbss_scene_get_statistics(k->tied.scene, &s, sizeof s));
    printf("{\"knot\": \"%s\", \"force\": %g, \"friction\": %g, \"seed\": %llu, \"seated_N\": %.6g",
           knot_names[o->tied.knot.kind], asked, o->tied.scene.thread_friction,
           (unsigned long long)o->seed, o->tied.pull.force);
    printf(", \"end\": \"%s\", \"holds_N\": %.6g, \"through_N\": %.6g, \"limit_N\": %g, "
           "\"growth_mm\": %.4g",
           held_knot_ends[k->end], k->holds, k->holds_through, o->limit, 1e3 * k->grown);
    printf(
        ", \"seated_mm\": %.5g, \"resting_mm\": %.5g, \"let_go_slip_mm\": %.5g, \"slip_mm\": %.5g",
        1e3 * held_knot_inside(&k->seated), 1e3 * held_knot_inside(&k->resting),
        1e3 * held_knot_drawn_in(&k->seated, &k->resting),
        1e3 * held_knot_drawn_in(&k->resting, &k->edges));
    printf(", \"type_kept\": %d, \"clamped\": %llu, \"recovering\": %llu", type_kept(k),
           (unsigned long long)s.clamped, (unsigned long long)s.recovering);
    printf(", \"penetration_um\": %.4g, \"steps\": %llu, \"cpu_s\": %.3f}\n", 1e6 * s.penetration,
           (unsigned long long)s.steps, (double)clock() / CLOCKS_PER_SEC);
    return VBSS_OK;
}

static vbss_result measure(const held_knot_options *o, double asked, FILE *trace)
{
    static held_knot k;
    vbss_context *context;
    VBSS_TRY(vbss_context_create(NULL, &context));
    VBSS_TRY(held_knot_create(context, o, &k));
    VBSS_TRY(run(&k, trace));
    VBSS_TRY(print(&k, asked));
    return vbss_context_destroy(context);
}

int main(int argc, char **argv)
{
    (void)setlocale(LC_NUMERIC, "C"); /* numbers with a decimal point */
    held_knot_options o;
    FILE *trace = NULL;
    int kind = argc < 5 ? KNOT_KINDS : find_kind(argv[1]);
    bool good = kind < KNOT_KINDS && held_knot_init(&o, (knot_kind)kind, strtod(argv[2], NULL),
                                                    strtod(argv[3], NULL)) == VBSS_OK;
    if (good && strtoull(argv[4], NULL, 10) != 0) {
        held_knot_vary(&o, strtoull(argv[4], NULL, 10));
    }
    for (int i = 5; good && i < argc; i++) {
        bool traces = strncmp(argv[i], "trace=", 6) == 0;
        trace = traces ? fopen(argv[i] + 6, "w") : trace;
        good = traces ? trace != NULL : set_option(&o, argv[i]);
    }
    if (!good) {
        fprintf(stderr, "usage: knots_hold <knot> <force> <friction> <seed> [name=value ...]\n");
        return 2;
    }
    vbss_result result = measure(&o, strtod(argv[2], NULL), trace);
    if (result != VBSS_OK) {
        fprintf(stderr, "%s\n", vbss_result_name(result));
    }
    if (trace != NULL) {
        fclose(trace);
    }
    return result != VBSS_OK;
}
