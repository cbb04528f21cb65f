/* What an adaptive mesh costs and gains: knots that begin loose and coarse, pulled to 2 N, on a mesh graded about the
 * knot, on one that is fine all over, on one that adapts, and on the coarse one that it begins with. The error is
 * that of the length taken up, against a mesh finer than all. */
#include <math.h>
#include <stdio.h>

#include "contact/bench_contact.h"
#include "contact/pulled_knot.h"

#define FINE 0.3e-3
#define GRADED_TO 2e-3
#define REFERENCE 0.2e-3

typedef enum mesh_case { GRADED, UNIFORM, ADAPTIVE, COARSE_MESH, MESHES } mesh_case;
static const char *const mesh_names[MESHES] = {"graded", "fine", "adaptive", "coarse"};
/* As loose as the coarse mesh can follow. */
typedef struct knot_case {
    knot_kind kind;
    const char *name;
    double size, coarse; /* m */
} knot_case;
static const knot_case kinds[] = {{KNOT_DOUBLE_OVERHAND, "double-overhand", 2e-3, 1.2e-3},
                                  {KNOT_FLS, "fls", 1e-3, 0.6e-3}};
enum { KINDS = sizeof kinds / sizeof kinds[0] };

static pulled_knot knots[KINDS][MESHES];

static void set(pulled_knot *k, const knot_case *c, double finest, double coarsest)
{
    pulled_knot_init(k, c->kind, VBSS_METHOD_IMPLICIT);
    k->options.scene.mode = VBSS_SCENE_MODE_OFFLINE;
    k->options.knot.size = c->size;
    k->options.knot.length = 0.2;
    k->options.knot.finest = finest;
    k->options.knot.coarsest = coarsest;
    k->options.pull.speed = 0.05;
    k->hold_steps = 300;
}

static void set_mesh(pulled_knot *k, const knot_case *c, mesh_case mesh)
{
    const double lengths[MESHES][2] = {
        {FINE, GRADED_TO}, {FINE, FINE}, {c->coarse, c->coarse}, {c->coarse, c->coarse}};
    set(k, c, lengths[mesh][0], lengths[mesh][1]);
    if (mesh == ADAPTIVE) {
        k->options.thread.mesh = VBSS_THREAD_MESH_ADAPTIVE;
        k->options.thread.node_capacity = 900;
        k->options.thread.coarsest_length = GRADED_TO;
    }
}

/* Once for all meshes of a kind. */
static double reference_mm(int kind)
{
    static double known[KINDS];
    if (known[kind] == 0.0) {
        static pulled_knot k;
        set(&k, &kinds[kind], REFERENCE, GRADED_TO);
        known[kind] = pulled_knot_make(&k) && pulled_knot_run(&k) ? 1e3 * k.taken_up : (double)NAN;
        pulled_knot_end(&k);
    }
    return known[kind];
}

static void add_error(bench_result *result, int kind)
{
    double reference = reference_mm(kind);
    bench_counter(result, "reference_mm", reference);
    bench_counter(result, "taken_up_error_mm",
                  fabs(bench_counter_value(result, "taken_up_mm") - reference));
}

static void add_error_of_double(bench_result *result)
{
    add_error(result, 0);
}

static void add_error_of_fls(bench_result *result)
{
    add_error(result, 1);
}

void add_adaptive_cases(bench *b)
{
    int count = bench_is_quick(b) ? 1 : KINDS; /* the other's reference takes long */
    for (int kind = 0; kind < count; kind++) {
        for (int mesh = 0; mesh < MESHES; mesh++) {
            pulled_knot *k = &knots[kind][mesh];
            set_mesh(k, &kinds[kind], (mesh_case)mesh);
            k->more = kind == 0 ? add_error_of_double : add_error_of_fls;
            snprintf(k->name, sizeof k->name, "contact/mesh/%s/%s", kinds[kind].name,
                     mesh_names[mesh]);
            pulled_knot_add(b, k);
        }
    }
}
