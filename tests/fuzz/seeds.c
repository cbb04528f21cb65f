#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz/fuzz.h"

/* ---- logs and snapshots */

typedef struct growing {
    uint8_t *bytes;
    size_t count;
} growing;

static void append(growing *g, const uint8_t *bytes, size_t count)
{
    g->bytes = realloc(g->bytes, g->count + count + 1);
    MUST(g->bytes != NULL);
    memcpy(g->bytes + g->count, bytes, count);
    g->count += count;
}

static void append_log(growing *g, vbss_record *record)
{
    const uint8_t *bytes;
    uint64_t count;
    MUST(vbss_record_take(record, &bytes, &count) == VBSS_OK);
    append(g, bytes, (size_t)count);
}

/* The first byte says how the fuzzer reads it. */
static growing snapshot_of(vbss_scene *scene, uint8_t how)
{
    growing g = {NULL, 0};
    uint64_t count = 0;
    append(&g, &how, 1);
    (void)vbss_scene_save(scene, NULL, 0, &count);
    g.bytes = realloc(g.bytes, (size_t)count + 1);
    MUST(g.bytes != NULL);
    MUST(vbss_scene_save(scene, g.bytes + 1, count, &count) == VBSS_OK);
    g.count = (size_t)count + 1;
    return g;
}

static void take_states(vbss_scene *scene, uint8_t first, const char *of, uint32_t number,
                        seed_taker take, void *user)
{
    char name[32];
    for (uint8_t how = first; how < first + 2; how++) {
        growing state = snapshot_of(scene, how);
        snprintf(name, sizeof name, "%s-%u-%u", of, number, how);
        take(user, name, state.bytes, state.count);
        free(state.bytes);
    }
}

/* Logs of a few steps from a scene that has made `before`. */
static void make_log(uint32_t before, uint32_t steps, bool ends, seed_taker take, void *user)
{
    vbss_context *context;
    vbss_scene *scene;
    vbss_record *record;
    vbss_record_config config;
    char name[32];
    MUST(vbss_context_create(NULL, &context) == VBSS_OK);
    MUST(small_scene_create(context, &scene) == VBSS_OK);
    for (uint32_t i = 0; i < before; i++) {
        MUST(small_scene_drive(scene, i) == VBSS_OK);
        MUST(vbss_scene_step(scene, 1e-3) == VBSS_OK);
    }
    take_states(scene, 2, "state", before, take, user);
    MUST(vbss_record_config_init(&config, sizeof config) == VBSS_OK);
    config.snapshot_interval = 4;
    config.input_capacity = 8;
    config.note = "note";
    config.note_bytes = 4;
    MUST(vbss_record_create(scene, &config, &record) == VBSS_OK);
    MUST(vbss_scene_set_recorder(scene, record) == VBSS_OK);
    growing log = {NULL, 0};
    append(&log, (const uint8_t *)"", 1);
    append_log(&log, record);
    for (uint32_t i = 0; i < steps; i++) {
        MUST(small_scene_drive(scene, before + i) == VBSS_OK);
        MUST(vbss_scene_step(scene, 1e-3) == VBSS_OK);
        append_log(&log, record);
    }
    if (ends) {
        MUST(vbss_record_end(record) == VBSS_OK);
        append_log(&log, record);
    }
    for (uint8_t how = 0; how < 2; how++) { /* 1: to be sealed when it has been changed */
        log.bytes[0] = how;
        snprintf(name, sizeof name, "log-%u-%u", before, how);
        take(user, name, log.bytes, log.count);
    }
    free(log.bytes);
    MUST(vbss_context_destroy(context) == VBSS_OK);
}

static void make_drain_states(seed_taker take, void *user)
{
    vbss_context *context;
    vbss_scene *scene;
    MUST(vbss_context_create(NULL, &context) == VBSS_OK);
    MUST(drain_scene_create(context, &scene) == VBSS_OK);
    MUST(vbss_scene_step(scene, 1e-3) == VBSS_OK);
    take_states(scene, 6, "drain", 1, take, user);
    MUST(vbss_context_destroy(context) == VBSS_OK);
}

/* With states of a session: behind each second step, as the log grows by more than four times one of them meanwhile. */
static void make_followed_log(seed_taker take, void *user)
{
    vbss_context *context;
    vbss_scene *scene;
    vbss_session *session;
    vbss_session_config config;
    vbss_record_config c;
    MUST(vbss_context_create(NULL, &context) == VBSS_OK);
    MUST(session_scene_create(context, &scene, &config) == VBSS_OK);
    MUST(vbss_record_config_init(&c, sizeof c) == VBSS_OK);
    c.snapshot_interval = 2;
    c.input_capacity = 4;
    MUST(vbss_record_create(scene, &c, &config.record) == VBSS_OK);
    MUST(vbss_session_create(scene, &config, &session) == VBSS_OK);
    growing log = {NULL, 0};
    append(&log, (const uint8_t *)"", 1);
    for (int i = 0; i < 5; i++) {
        append_log(&log, config.record);
        MUST(vbss_session_step(session, 0.0, 1e-3) == VBSS_OK);
    }
    MUST(vbss_record_end(config.record) == VBSS_OK);
    append_log(&log, config.record);
    for (uint8_t how = 8; how < 10; how++) {
        log.bytes[0] = how;
        take(user, how == 8 ? "followed-0" : "followed-1", log.bytes, log.count);
    }
    free(log.bytes);
    MUST(vbss_context_destroy(context) == VBSS_OK);
}

void make_log_seeds(seed_taker take, void *user)
{
    make_log(0, 6, true, take, user);
    make_log(12, 10, false, take, user); /* jaws hold the thread */
    make_log(29, 6, true, take, user);   /* pinned, exchanged, cut */
    make_drain_states(take, user);
    make_followed_log(take, user);
}

/* ---- configurations: as they are initialised */

void make_config_seeds(seed_taker take, void *user)
{
    for (uint32_t i = 0; i < CONFIG_KINDS; i++) {
        const uint8_t kind = (uint8_t)i;
        uint8_t seed[CONFIG_ROOM] = {0};
        char name[32];
        uint32_t size = init_config(kind, seed + 1);
        seed[0] = kind;
        snprintf(name, sizeof name, "config-%u", kind);
        take(user, name, seed, 1 + size);
    }
}
