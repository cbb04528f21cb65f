/* The contract of needles. */
#include "base/error.h"
#include "contract/contract.h"
#include "needle/needle.h"

/* ---- scripted runs: a needle that was thrown, with gravity and drag */

static vbss_result thrown_create(vbss_context *context, void *user, void **handle)
{
    vbss_needle_config config;
    (void)user;
    VBSS_TRY(vbss_needle_config_init(&config, sizeof config));
    config.drag = 0.5;
    vec3_store(config.gravity, vec3_make(0.3, -0.2, -9.81));
    vec3_store(config.position, vec3_make(0.1, 0.2, 0.3));
    vec3_store(config.velocity, vec3_make(0.5, -1.0, 2.0));
    vec3_store(config.angular_velocity, vec3_make(40.0, -20.0, 3.0));
    return vbss_needle_create(context, &config, (vbss_needle **)handle);
}

static vbss_result put(void *handle)
{
    const double p[3] = {0.3, 0.2, -0.1}, q[4] = {0.0, 3.0, 0.0, 4.0}, v[3] = {-1.0, 0.5, 2.0},
                 w[3] = {5.0, 60.0, -7.0};
    return vbss_needle_set_state(handle, p, q, v, w);
}

static vbss_result call_step(void *handle)
{
    return vbss_needle_step(handle, 1e-3);
}

static vbss_result destroy(void *handle)
{
    return vbss_needle_destroy(handle);
}

static void spoil(void *handle, uint32_t which)
{
    needle_object *n = NULL;
    expect_ok(vbss_needle_open(handle, &n));
    vbss_rigid_motion *now = &n->body.now;
    double *numbers[] = {&now->pose.orientation.w, &now->pose.position.y, &now->v.x, &now->w.z};
    *numbers[which] = which == 0 ? 0.5 : (double)INFINITY;
}

/* ---- the object */

static vbss_result config_init(void *config, uint32_t struct_size)
{
    return vbss_needle_config_init(config, struct_size);
}

static vbss_result create_and_destroy(vbss_context *context, const void *config)
{
    vbss_needle *needle = NULL;
    VBSS_TRY(vbss_needle_create(context, config, &needle));
    return vbss_needle_destroy(needle);
}

static const void *good_config(void)
{
    static vbss_needle_config config;
    expect_ok(vbss_needle_config_init(&config, sizeof config));
    return &config;
}

static vbss_result create_from(vbss_context *context, const void *config, void **handle)
{
    return vbss_needle_create(context, config, (vbss_needle **)handle);
}

static vbss_result create(vbss_context *context, void **handle)
{
    return create_from(context, NULL, handle);
}

static vbss_result reject(void *handle)
{
    return vbss_needle_step(handle, 1.0);
}

static vbss_result get_hash(void *handle, uint64_t *hash)
{
    return vbss_needle_get_hash(handle, hash);
}

static vbss_result write_state(void *handle, void *out, uint32_t size)
{
    return vbss_needle_get_state(handle, out, size);
}
static vbss_result write_mass(void *handle, void *out, uint32_t size)
{
    return vbss_needle_get_mass(handle, out, size);
}
static vbss_result write_energies(void *handle, void *out, uint32_t size)
{
    return vbss_needle_get_energies(handle, out, size);
}
static vbss_result write_view(void *handle, void *out, uint32_t size)
{
    return vbss_needle_get_view(handle, VBSS_NEEDLE_VIEW_POINTS, out, size);
}

static vbss_result call_set_state(void *n)
{
    static const double zero[3];
    return vbss_needle_set_state(n, zero, NULL, NULL, NULL);
}
static vbss_result call_restore(void *n)
{
    uint8_t bytes[64] = {0};
    return vbss_needle_restore(n, bytes, sizeof bytes);
}
static vbss_result call_place(void *n)
{
    double position[3];
    return vbss_needle_get_place(n, 0.0, position, NULL);
}
static vbss_result call_save(void *n)
{
    uint64_t written;
    vbss_result result = vbss_needle_save(n, NULL, 0, &written);
    return result == VBSS_ERROR_CAPACITY ? VBSS_OK : result;
}
static vbss_result call_hash(void *n)
{
    uint64_t hash;
    return vbss_needle_get_hash(n, &hash);
}
static vbss_result call_state(void *n)
{
    vbss_needle_state out;
    return write_state(n, &out, sizeof out);
}
static vbss_result call_mass(void *n)
{
    vbss_needle_mass out;
    return write_mass(n, &out, sizeof out);
}
static vbss_result call_energies(void *n)
{
    vbss_needle_energies out;
    return write_energies(n, &out, sizeof out);
}
static vbss_result call_view(void *n)
{
    vbss_view out;
    return write_view(n, &out, sizeof out);
}

static vbss_result attempt(vbss_context *context, void *user)
{
    uint8_t bytes[1024];
    uint64_t written;
    vbss_needle *needle = NULL;
    (void)user;
    VBSS_TRY(vbss_needle_create(context, NULL, &needle));
    vbss_result result = vbss_needle_step(needle, 1e-3);
    result = result == VBSS_OK ? vbss_needle_save(needle, bytes, sizeof bytes, &written) : result;
    result = result == VBSS_OK ? vbss_needle_restore(needle, bytes, written) : result;
    VBSS_TRY(vbss_needle_destroy(needle));
    return result;
}

static vbss_result cycle(vbss_context *context, uint32_t i)
{
    (void)i;
    return create_and_destroy(context, NULL);
}

static const uint32_t config_sizes[] = {192, 0};

static const contract_object object = {
    .name = "needle",
    .configs = {{config_sizes, config_init, create_and_destroy}},
    .create = create,
    .create_from = create_from,
    .config = good_config,
    .null_config = VBSS_OK,
    .destroy = destroy,
    .reject = reject,
    .hash = get_hash,
    .outputs = {{208, {0}, write_state},
                {144, {0}, write_mass},
                {32, {0}, write_energies},
                {sizeof(vbss_view), {0}, write_view}},
    .calls = {{.call = call_step, .edits = true},
              {.call = call_set_state, .edits = true},
              {.call = call_restore, .edits = true, .result = VBSS_ERROR_CORRUPT},
              {.call = call_place},
              {.call = call_save},
              {.call = call_hash},
              {.call = call_state},
              {.call = call_mass},
              {.call = call_energies},
              {.call = call_view}},
    .owned_kind = &vbss_needle_kind,
    .attempts = {{attempt, NULL}},
    .cycle = cycle,
    .cycles = 8,
};

/* ---- snapshots */

static void usual_config(void *config)
{
    expect_ok(vbss_needle_config_init(config, sizeof(vbss_needle_config)));
}

static vbss_result save(void *handle, void *bytes, uint64_t capacity, uint64_t *written)
{
    return vbss_needle_save(handle, bytes, capacity, written);
}

static vbss_result restore(void *handle, const void *bytes, uint64_t count)
{
    return vbss_needle_restore(handle, bytes, count);
}

enum {
    FIRST_NUMBER = offsetof(vbss_needle_config, radius),
    NUMBERS = (offsetof(vbss_needle_config, position) - FIRST_NUMBER) / sizeof(double)
};

/* All numbers but the initial motion, to the last bit. */
static const contract_snapshot snapshot = {
    .name = "needle",
    .kind = &vbss_needle_kind,
    .config = usual_config,
    .config_size = sizeof(vbss_needle_config),
    .create = create_from,
    .destroy = destroy,
    .save = save,
    .restore = restore,
    .fields = {{FIRST_NUMBER, NUMBERS, 1.0 + DBL_EPSILON},
               {offsetof(vbss_needle_config, method), 0, 1},
               {offsetof(vbss_needle_config, segment_count), 0, 1}},
};

int test_needle(void)
{
    const contract_run runs[] = {
        {.name = "thrown needle",
         .body = {"needle", &vbss_needle_kind, thrown_create, put, call_step, destroy, NULL},
         .saves = {0, 1, 2, 3, 4, 5, 6, 7},
         .save_count = 8,
         .continued = 50,
         .damages = {0, 5},
         .damage_count = 2,
         .quiet = 100,
         .repeated = 1000,
         .spoil = spoil,
         .spoil_count = 4},
    };
    return contract_check_runs("contract.needle", runs, sizeof runs / sizeof runs[0]) +
           contract_check_object("contract.needle", &object) +
           contract_check_snapshot("contract.needle", &snapshot);
}
