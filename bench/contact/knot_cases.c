/* Knots that are pulled until they bear 2 N, and then held: ours on the mesh that a tight knot needs, the
 * paper's on its own 30 segments and steps of 1/150 s, and on ours. */
#include <stdio.h>

#include "fixtures/baseline_of.h"
#include "contact/bench_contact.h"
#include "contact/pulled_knot.h"

typedef struct kind_case {
    const char *scene;
    knot_kind kind;
    vbss_method method;
    uint32_t max_steps; /* while the load is not reached */
    bool cylinder, pinned;
    double finest, coarsest; /* m */
    double h;                /* s */
} kind_case;

#define FINE 0.3e-3
/* With this the knot of three throws has some 300 nodes. */
#define FINE_FLS 0.37e-3
/* With this the double overhand has 213 nodes. */
#define COARSE 1.8e-3
/* Of a mesh of 120 segments: five diameters, too coarse for the length that a knot takes up. */
#define UNIFORM 1.25e-3
#define PAPER_SEGMENT 5e-3
#define PAPER_STEP (1.0 / 150.0)
#define OUR_STEP 1e-3

/* The paper's method has lost a fine knot after some ms; its own is pulled for two
 * seconds, whatever it bears: its explicit springs never show the load. */
enum { OURS_STEPS = 4000, LOST_STEPS = 20, PAPER_STEPS = 300 };
/* A size at which the polyline of 5 mm is the knot. */
#define PAPER_SIZE 3.1e-3

static const kind_case cases[] = {
    {"overhand", KNOT_OVERHAND, VBSS_METHOD_IMPLICIT, OURS_STEPS, false, false, FINE, COARSE,
     OUR_STEP},
    {"double-overhand", KNOT_DOUBLE_OVERHAND, VBSS_METHOD_IMPLICIT, OURS_STEPS, false, false, FINE,
     COARSE, OUR_STEP},
    {"double-overhand-uniform", KNOT_DOUBLE_OVERHAND, VBSS_METHOD_IMPLICIT, OURS_STEPS, false,
     false, UNIFORM, UNIFORM, OUR_STEP},
    {"square", KNOT_SQUARE, VBSS_METHOD_IMPLICIT, OURS_STEPS, true, false, FINE, COARSE, OUR_STEP},
    {"granny", KNOT_GRANNY, VBSS_METHOD_IMPLICIT, OURS_STEPS, true, false, FINE, COARSE, OUR_STEP},
    {"surgeon", KNOT_SURGEON, VBSS_METHOD_IMPLICIT, OURS_STEPS, true, false, FINE, COARSE,
     OUR_STEP},
    {"fls-knot", KNOT_FLS, VBSS_METHOD_IMPLICIT, OURS_STEPS, true, false, FINE, COARSE, OUR_STEP},
    {"fls-knot-300", KNOT_FLS, VBSS_METHOD_IMPLICIT, OURS_STEPS, true, false, FINE_FLS, COARSE,
     OUR_STEP},
    {"overhand", KNOT_OVERHAND, VBSS_METHOD_VBLAST, LOST_STEPS, false, false, FINE, COARSE,
     OUR_STEP},
    {"double-overhand", KNOT_DOUBLE_OVERHAND, VBSS_METHOD_VBLAST, LOST_STEPS, false, false, FINE,
     COARSE, OUR_STEP},
    {"fls-knot", KNOT_FLS, VBSS_METHOD_VBLAST, LOST_STEPS, true, false, FINE, COARSE, OUR_STEP},
    {"paper-throw", KNOT_DOUBLE_OVERHAND, VBSS_METHOD_VBLAST, PAPER_STEPS, false, false,
     PAPER_SEGMENT, PAPER_SEGMENT, PAPER_STEP},
    {"paper-throw-pinned", KNOT_DOUBLE_OVERHAND, VBSS_METHOD_VBLAST, PAPER_STEPS, false, true,
     PAPER_SEGMENT, PAPER_SEGMENT, PAPER_STEP},
};
enum { CASES = sizeof cases / sizeof cases[0] };

/* A knot is timed while it is pulled, while it bears its load, and pulled with all the work it takes. */
typedef enum phase { PULLED, HELD, PULLED_OFFLINE, PHASES } phase;
static const char *const methods[PHASES] = {"ours", "ours", "ours-offline"};

static pulled_knot knots[CASES][PHASES];

/* How many nodes the mesh has. */
static uint32_t count_nodes(const pulled_knot *k)
{
    static vec3 positions[KNOT_NODES];
    static double rest[KNOT_NODES];
    knot_line line;
    return knot_make(&k->options.knot, KNOT_NODES, positions, rest, &line) == VBSS_OK
               ? line.node_count
               : 0;
}

static void set(pulled_knot *k, const kind_case *c, phase when)
{
    bool held = when == HELD;
    pulled_knot_init(k, c->kind, c->method);
    k->options.knot.cylinder = c->cylinder;
    k->options.knot.finest = c->finest;
    k->options.knot.coarsest = c->coarsest;
    k->options.knot.size = c->finest == PAPER_SEGMENT ? PAPER_SIZE : k->options.knot.size;
    baseline_of(&k->options.thread.baseline)->thread_damping =
        c->finest == PAPER_SEGMENT ? 0.01 : 0.0; /* or it shakes to pieces */
    k->max_steps = c->max_steps;
    k->pinned = c->pinned;
    k->h = c->h;
    k->held = held;
    k->options.scene.mode =
        when == PULLED_OFFLINE ? VBSS_SCENE_MODE_OFFLINE : VBSS_SCENE_MODE_REAL_TIME;
    snprintf(k->name, sizeof k->name, "contact/%s%s/%s/%u", c->scene, held ? "-held" : "",
             c->method == VBSS_METHOD_IMPLICIT ? methods[when] : "paper", (unsigned)count_nodes(k));
}

void add_knot_cases(bench *b)
{
    for (int when = PULLED; when < PHASES; when++) {
        for (size_t i = 0; i < CASES; i++) {
            if (when == PULLED || cases[i].method == VBSS_METHOD_IMPLICIT) {
                set(&knots[i][when], &cases[i], (phase)when);
                pulled_knot_add(b, &knots[i][when]);
            }
        }
    }
}
