#include <stdlib.h>
#include <string.h>

#include "fuzz/fuzz.h"

enum { SCENE, THREAD, RIGID, GRASPER, NEEDLE, DRAIN, RECORD, KNOT, SOLVER, SURFACE };

/* A surface of a drain: any numbers in arrays that are long enough. */
enum { SURFACE_NODES = 6, SURFACE_TRIANGLES = 5 };
typedef struct any_surface {
    uint32_t struct_size, node_count, triangle_count, anchor_count;
    uint32_t triangles[SURFACE_TRIANGLES][3], anchors[SURFACE_NODES], has_values;
    double positions[SURFACE_NODES][3], thickness[SURFACE_TRIANGLES], young[SURFACE_TRIANGLES];
} any_surface;

/* A fan of five triangles about node 0, which is a little raised. */
static vbss_result any_surface_init(any_surface *c, uint32_t struct_size)
{
    static const double corners[SURFACE_NODES][2] = {{0.0, 0.0},         {2e-3, 0.0},
                                                     {0.6e-3, 1.9e-3},   {-1.6e-3, 1.2e-3},
                                                     {-1.6e-3, -1.2e-3}, {0.6e-3, -1.9e-3}};
    *c = (any_surface){.struct_size = struct_size,
                       .node_count = SURFACE_NODES,
                       .triangle_count = SURFACE_TRIANGLES,
                       .anchor_count = 2,
                       .anchors = {1, 2}};
    for (uint32_t i = 0; i < SURFACE_NODES; i++) {
        c->positions[i][0] = corners[i][0];
        c->positions[i][1] = i == 0 ? 0.2e-3 : 0.0;
        c->positions[i][2] = -corners[i][1];
    }
    for (uint32_t i = 0; i < SURFACE_TRIANGLES; i++) {
        c->triangles[i][1] = 1 + i;
        c->triangles[i][2] = 1 + (i + 1) % SURFACE_TRIANGLES;
        c->thickness[i] = 1e-3;
        c->young[i] = 1e6;
    }
    return VBSS_OK;
}

/* The structs are published ones, so their size is what their init function is told. */
uint32_t init_config(uint8_t kind, uint8_t *config)
{
    switch (kind) {
#define INIT(KIND, type, init)                         \
    case KIND: {                                       \
        type c;                                        \
        MUST(init(&c, (uint32_t)sizeof c) == VBSS_OK); \
        memcpy(config, &c, sizeof c);                  \
        return (uint32_t)sizeof c;                     \
    }
        INIT(SCENE, vbss_scene_config, vbss_scene_config_init)
        INIT(THREAD, vbss_thread_config, vbss_thread_config_init)
        INIT(RIGID, vbss_scene_rigid_config, vbss_scene_rigid_config_init)
        INIT(GRASPER, vbss_grasper_config, vbss_grasper_config_init)
        INIT(NEEDLE, vbss_needle_config, vbss_needle_config_init)
        INIT(DRAIN, vbss_drain_config, vbss_drain_config_init)
        INIT(RECORD, vbss_record_config, vbss_record_config_init)
        INIT(KNOT, vbss_knot_detector_config, vbss_knot_detector_config_init)
        INIT(SOLVER, vbss_solver_options, vbss_solver_options_init)
        INIT(SURFACE, any_surface, any_surface_init)
#undef INIT
    default:
        return 0;
    }
}

static void try_thread(vbss_context *context, vbss_thread_config *c)
{
    vbss_thread *thread;
    c->rest_lengths = c->positions = NULL;
    c->baseline = NULL;
    if (vbss_thread_create(context, c, &thread) == VBSS_OK) {
        uint64_t hash;
        for (int i = 0; i < 3; i++) {
            (void)vbss_thread_step(thread, 1e-3);
        }
        MUST(vbss_thread_get_hash(thread, &hash) == VBSS_OK);
    }
    MUST(vbss_thread_destroy(thread) == VBSS_OK);
}

static void try_needle(vbss_context *context, const vbss_needle_config *c)
{
    vbss_needle *needle;
    if (vbss_needle_create(context, c, &needle) == VBSS_OK) {
        for (int i = 0; i < 3; i++) {
            (void)vbss_needle_step(needle, 1e-3);
        }
    }
    MUST(vbss_needle_destroy(needle) == VBSS_OK);
}

static void try_drain(vbss_context *context, vbss_drain_config *c)
{
    vbss_drain *drain;
    c->baseline = NULL;
    c->surface = NULL;
    c->mesh_divisions &= 1; /* finer ones take seconds under sanitizers */
    if (vbss_drain_create(context, c, &drain) == VBSS_OK) {
        (void)vbss_drain_step(drain, 1e-3);
    }
    MUST(vbss_drain_destroy(drain) == VBSS_OK);
}

static void try_surface(vbss_context *context, const any_surface *c)
{
    vbss_drain *drain;
    vbss_drain_surface surface = vbss_drain_surface_default();
    vbss_drain_config config = vbss_drain_config_default();
    surface.node_count = c->node_count % (SURFACE_NODES + 1);
    surface.triangle_count = c->triangle_count % (SURFACE_TRIANGLES + 1);
    surface.anchor_count = c->anchor_count % (SURFACE_NODES + 1);
    surface.positions = c->positions[0];
    surface.triangles = c->triangles[0];
    surface.anchors = c->anchors;
    surface.thickness = (c->has_values & 1) != 0 ? c->thickness : NULL;
    surface.young_modulus = (c->has_values & 2) != 0 ? c->young : NULL;
    config.surface = &surface;
    if (vbss_drain_create(context, &config, &drain) == VBSS_OK) {
        (void)vbss_drain_step(drain, 1e-3);
    }
    MUST(vbss_drain_destroy(drain) == VBSS_OK);
}

static vbss_scene *plain_scene(vbss_context *context)
{
    vbss_scene_config config;
    vbss_scene *scene;
    MUST(vbss_scene_config_init(&config, sizeof config) == VBSS_OK);
    config.node_capacity = 32;
    config.contact_capacity = config.candidate_capacity = 64;
    return vbss_scene_create(context, &config, &scene) == VBSS_OK ? scene : NULL;
}

static void try_in_scene(vbss_context *context, uint8_t kind, void *config)
{
    const vbss_scene_capsule capsules[4] = {{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.01}, 1e-3}};
    vbss_scene *scene = plain_scene(context);
    uint32_t body;
    vbss_grasper *grasper = NULL;
    vbss_scene_rigid_config *rigid = config;
    vbss_result result = scene == NULL ? VBSS_ERROR_OUT_OF_MEMORY : VBSS_OK;
    if (result == VBSS_OK && kind == RIGID) {
        rigid->capsules = capsules;
        rigid->capsule_count %= 5;
        result = vbss_scene_add_rigid(scene, rigid, &body);
    } else if (result == VBSS_OK) {
        ((vbss_grasper_config *)config)->baseline = NULL;
        result = vbss_grasper_create(context, config, &grasper);
        result = result == VBSS_OK ? vbss_scene_add_grasper(scene, grasper, &body) : result;
    }
    for (int i = 0; result == VBSS_OK && i < 3; i++) {
        result = vbss_scene_step(scene, 1e-3);
    }
    MUST(vbss_scene_destroy(scene) == VBSS_OK);
    MUST(vbss_grasper_destroy(grasper) == VBSS_OK);
}

static void try_record(vbss_context *context, vbss_record_config *c)
{
    vbss_scene *scene = plain_scene(context);
    vbss_record *record = NULL;
    char note[64] = "note";
    c->note = c->note_bytes <= sizeof note ? note : NULL;
    if (scene != NULL && vbss_record_create(scene, c, &record) == VBSS_OK) {
        MUST(vbss_scene_set_recorder(scene, record) == VBSS_OK);
        (void)vbss_scene_step(scene, 1e-3);
        MUST(vbss_record_end(record) == VBSS_OK);
    }
    MUST(vbss_record_destroy(record) == VBSS_OK);
    MUST(vbss_scene_destroy(scene) == VBSS_OK);
}

static void try_scene(vbss_context *context, vbss_scene_config *c,
                      const vbss_solver_options *solver)
{
    vbss_scene *scene;
    c->baseline = NULL;
    c->solver = solver;
    if (vbss_scene_create(context, c, &scene) == VBSS_OK) {
        (void)vbss_scene_step(scene, 1e-3);
    }
    MUST(vbss_scene_destroy(scene) == VBSS_OK);
}

void try_config(vbss_context *context, uint8_t kind, void *config)
{
    vbss_scene_config plain;
    vbss_knot_detector *detector;
    switch (kind) {
    case SCENE:
        try_scene(context, config, NULL);
        return;
    case SOLVER:
        MUST(vbss_scene_config_init(&plain, sizeof plain) == VBSS_OK);
        plain.node_capacity = 32;
        plain.contact_capacity = plain.candidate_capacity = 64;
        try_scene(context, &plain, config);
        return;
    case SURFACE:
        try_surface(context, config);
        return;
    case THREAD:
        try_thread(context, config);
        return;
    case NEEDLE:
        try_needle(context, config);
        return;
    case DRAIN:
        try_drain(context, config);
        return;
    case RECORD:
        try_record(context, config);
        return;
    case KNOT:
        (void)vbss_knot_detector_create(context, config, &detector);
        MUST(vbss_knot_detector_destroy(detector) == VBSS_OK);
        return;
    default: /* RIGID, GRASPER */
        try_in_scene(context, kind, config);
    }
}
