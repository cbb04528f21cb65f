/* contact/double-overhand-held: a double overhand knot bears 2 N, and its ends stand still.
 * contact/fls-300-tightening: the knot of three throws of the FLS task, about 300 nodes, is pulled tight round a cylinder until
 * it bears 2 N. */
#include "base/error.h"
#include "fixtures/contact_scenes.h"
#include "against/subject.h"

#define LOAD 2.0           /* N */
#define LOAD_REACHED 1.99  /* N */
#define SPEED 0.025        /* m/s */
#define LENGTH 0.15        /* m */
#define COARSEST 1.8e-3    /* m */
#define FINEST 0.3e-3      /* m */
#define FINEST_FLS 0.37e-3 /* m; the knot then has some 300 nodes */

/* The first steps part strands that overlap a little in the formula of the knot. */
enum { PARTING_STEPS = 4, LONGEST = 4000, HELD_STEPS = 1000 };

static struct {
    vbss_context *context;
    contact_scene scene;
    uint32_t steps;
} own;

static bool is_loaded(void)
{
    return contact_scene_pull_felt(&own.scene) >= LOAD_REACHED;
}

static vbss_result step(void)
{
    own.steps++;
    return contact_scene_step(&own.scene, SUBJECT_STEP);
}

static vbss_result create(knot_kind kind, double finest, bool cylinder)
{
    contact_scene_options options;
    VBSS_TRY(vbss_context_create(NULL, &own.context));
    VBSS_TRY(contact_scene_init(&options, CONTACT_SCENE_PULLED));
    options.knot.kind = kind;
    options.knot.length = LENGTH;
    options.knot.finest = finest;
    options.knot.coarsest = COARSEST;
    options.knot.cylinder = cylinder;
    options.pull = (contact_pull){SPEED, LOAD, 0.0};
    VBSS_TRY(contact_scene_create(own.context, &options, &own.scene));
    for (int i = 0; i < PARTING_STEPS; i++) {
        VBSS_TRY(step());
    }
    return VBSS_OK;
}

static vbss_result hash(uint64_t *value)
{
    return contact_scene_hash(&own.scene, value);
}

static vbss_scene *scene(void)
{
    return own.scene.scene;
}

static void end(void)
{
    (void)vbss_context_destroy(own.context);
}

/* ---- held */

static vbss_result begin_held(uint64_t seed)
{
    (void)seed;
    VBSS_TRY(create(KNOT_DOUBLE_OVERHAND, FINEST, false));
    while (!is_loaded() && own.steps < LONGEST) {
        VBSS_TRY(step());
    }
    own.steps = 0;
    return is_loaded() ? VBSS_OK : VBSS_ERROR_OUT_OF_RANGE;
}

static bool held_goes_on(void)
{
    return own.steps < HELD_STEPS;
}

const subject held_double_overhand = {.name = "contact/double-overhand-held",
                                      .begin = begin_held,
                                      .goes_on = held_goes_on,
                                      .step = step,
                                      .hash = hash,
                                      .scene = scene,
                                      .end = end};

/* ---- tightened */

static vbss_result begin_tightened(uint64_t seed)
{
    (void)seed;
    return create(KNOT_FLS, FINEST_FLS, true);
}

static bool tightening_goes_on(void)
{
    return !is_loaded() && own.steps < LONGEST;
}

const subject tightened_fls = {.name = "contact/fls-300-tightening",
                               .begin = begin_tightened,
                               .goes_on = tightening_goes_on,
                               .step = step,
                               .is_done = is_loaded,
                               .hash = hash,
                               .scene = scene,
                               .end = end};
