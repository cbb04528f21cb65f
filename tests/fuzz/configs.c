#include <stdlib.h>
#include <string.h>

#include "fuzz/fuzz.h"

enum { SCENE, THREAD, RIGID, GRASPER, NEEDLE, DRAIN, RECORD, KNOT };

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
    c->mesh_divisions &= 1; /* finer ones take seconds under sanitizers */
    if (vbss_drain_create(context, c, &drain) == VBSS_OK) {
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

void try_config(vbss_context *context, uint8_t kind, void *config)
{
    vbss_scene *scene;
    vbss_knot_detector *detector;
    switch (kind) {
    case SCENE:
        ((vbss_scene_config *)config)->baseline = NULL;
        ((vbss_scene_config *)config)->solver = NULL;
        if (vbss_scene_create(context, config, &scene) == VBSS_OK) {
            (void)vbss_scene_step(scene, 1e-3);
        }
        MUST(vbss_scene_destroy(scene) == VBSS_OK);
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
