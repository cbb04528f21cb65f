/* The contract of graspers. They have no snapshots of their own; the scene saves them with the functions below. */
#include "base/error.h"
#include "base/rotation.h"
#include "base/snapshot.h"
#include "contract/contract.h"
#include "grasper/grasper.h"

/* ---- scripted runs: new commands in every step, and what a scene would write */

static vbss_result led_create(vbss_context *context, void *user, void **handle)
{
    vbss_grasper_config config;
    (void)user;
    VBSS_TRY(vbss_grasper_config_init(&config, sizeof config));
    config.has_trocar = 1;
    config.trocar[1] = 0.2;
    config.driver_bend = 0.3;
    return vbss_grasper_create(context, &config, (vbss_grasper **)handle);
}

static vbss_result command(vbss_grasper *grasper, const grasper_object *g)
{
    const vec3 p = g->commanded_pose.position;
    const quat turn = quat_mul(vbss_quat_from_rotation_vector(vec3_make(0.1, 0.0, 0.2)),
                               g->commanded_pose.orientation);
    const double to[3] = {0.01 + 0.9 * p.x, 0.5 * p.y, 0.1 - p.z};
    const double q[4] = {turn.w, turn.x, turn.y, turn.z};
    VBSS_TRY(vbss_grasper_set_target(grasper, to, q));
    VBSS_TRY(vbss_grasper_set_opening(grasper, 1.0 - 0.7 * g->opening));
    return vbss_grasper_exchange(grasper, 3 - g->commanded_kind);
}

static vbss_result led_step(void *handle)
{
    grasper_object *g;
    VBSS_TRY(vbss_grasper_open(handle, &g));
    VBSS_TRY(command(handle, g));
    g->jaw_angle = vbss_grasper_next_angle(g, 1e-2, 0.0);
    g->jaw_force = vbss_grasper_jaw_force_at(g, g->jaw_angle);
    g->kind = g->jaw_force > 0.0 ? g->kind : g->commanded_kind;
    g->velocity = vec3_sub(g->tool_pose.position, vec3_scale(g->velocity, 0.5));
    g->angular_velocity = vec3_add(g->velocity, vec3_scale(g->angular_velocity, 0.5));
    g->hand_force = vec3_cross(g->velocity, g->angular_velocity);
    g->hand_torque = vec3_add(g->hand_force, vec3_scale(g->hand_torque, 0.5));
    vbss_grasper_update_view(g);
    return VBSS_OK;
}

static vbss_result destroy(void *handle)
{
    return vbss_grasper_destroy(handle);
}

static vbss_result plain_create(vbss_context *context, void *user, void **handle)
{
    (void)user;
    return vbss_grasper_create(context, NULL, (vbss_grasper **)handle);
}

static void spoil(void *handle, uint32_t which)
{
    grasper_object *g = NULL;
    expect_ok(vbss_grasper_open(handle, &g));
    const struct {
        double *number;
        double value;
    } numbers[] = {
        {&g->commanded_pose.position.z, -1e3 * (1.0 + 1e-12)}, /* outside the world */
        {&g->commanded_pose.orientation.w, 0.5},
        {&g->tool_pose.orientation.x, 1e-2},
        {&g->opening, 1.1},
        {&g->opening, -1e-9},
        {&g->jaw_angle, -1e-9},
        {&g->jaw_angle, 2.0},
        {&g->jaw_force, -1.0},
        {&g->jaw_force, 8.5},
        {&g->hand_torque.y, (double)INFINITY},
    };
    enum { COUNT = sizeof numbers / sizeof numbers[0] };
    if (which < COUNT) {
        *numbers[which].number = numbers[which].value;
    } else if (which == COUNT) {
        g->kind = 0;
    } else if (which == COUNT + 1) {
        g->commanded_kind = 3;
    } else {
        g->grasp_count = 1; /* outside a scene */
    }
}

/* ---- the object */

static vbss_result config_init(void *config, uint32_t struct_size)
{
    return vbss_grasper_config_init(config, struct_size);
}

static vbss_result create_and_destroy(vbss_context *context, const void *config)
{
    vbss_grasper *grasper = NULL;
    VBSS_TRY(vbss_grasper_create(context, config, &grasper));
    return vbss_grasper_destroy(grasper);
}

static const void *good_config(void)
{
    static vbss_grasper_config config;
    expect_ok(vbss_grasper_config_init(&config, sizeof config));
    return &config;
}

static vbss_result create_from(vbss_context *context, const void *config, void **handle)
{
    return vbss_grasper_create(context, config, (vbss_grasper **)handle);
}

static vbss_result create(vbss_context *context, void **handle)
{
    return create_from(context, NULL, handle);
}

static vbss_result reject(void *handle)
{
    return vbss_grasper_set_opening(handle, 2.0);
}

static vbss_result get_hash(void *handle, uint64_t *hash)
{
    return vbss_object_hash(handle, &vbss_grasper_kind_of_slot, hash);
}

static vbss_result write_state(void *handle, void *out, uint32_t size)
{
    return vbss_grasper_get_state(handle, out, size);
}
static vbss_result write_view(void *handle, void *out, uint32_t size)
{
    return vbss_grasper_get_view(handle, VBSS_GRASPER_VIEW_CAPSULES, out, size);
}

static vbss_result call_move(void *handle)
{
    static const double zero[3];
    return vbss_grasper_set_target(handle, zero, NULL);
}
static vbss_result call_opening(void *handle)
{
    return vbss_grasper_set_opening(handle, 0.5);
}
static vbss_result call_exchange(void *handle)
{
    return vbss_grasper_exchange(handle, VBSS_GRASPER_KIND_SHEARS);
}
static vbss_result call_state(void *handle)
{
    vbss_grasper_state out;
    return write_state(handle, &out, sizeof out);
}
static vbss_result call_view(void *handle)
{
    vbss_view out;
    return write_view(handle, &out, sizeof out);
}

static vbss_result attempt(vbss_context *context, void *user)
{
    (void)user;
    return create_and_destroy(context, NULL);
}

static vbss_result cycle(vbss_context *context, uint32_t i)
{
    (void)i;
    return create_and_destroy(context, NULL);
}

static const uint32_t config_sizes[] = {312, 0};

static const contract_object object = {
    .name = "grasper",
    .configs = {{config_sizes, config_init, create_and_destroy}},
    .create = create,
    .create_from = create_from,
    .config = good_config,
    .null_config = VBSS_OK,
    .destroy = destroy,
    .reject = reject,
    .hash = get_hash,
    .outputs = {{264, {248}, write_state}, {sizeof(vbss_view), {0}, write_view}},
    .calls = {{.call = call_move, .edits = true},
              {.call = call_opening, .edits = true},
              {.call = call_exchange, .edits = true},
              {.call = call_state},
              {.call = call_view}},
    .attempts = {{attempt, NULL}},
    .cycle = cycle,
    .cycles = 8,
};

/* ---- snapshots */

static void usual_config(void *config)
{
    expect_ok(vbss_grasper_config_init(config, sizeof(vbss_grasper_config)));
}

enum {
    /* Before and after the parameters of the baseline. */
    FIRST_NUMBER = offsetof(vbss_grasper_config, trocar),
    SECOND_NUMBER = offsetof(vbss_grasper_config, needle_stiffness),
    NUMBERS = (offsetof(vbss_grasper_config, baseline) - FIRST_NUMBER) / sizeof(double),
    LAST_NUMBERS = (sizeof(vbss_grasper_config) - SECOND_NUMBER) / sizeof(double)
};

/* All numbers, to the last bit. */
static const contract_snapshot snapshot = {
    .name = "grasper",
    .kind = &vbss_grasper_kind_of_slot,
    .config = usual_config,
    .config_size = sizeof(vbss_grasper_config),
    .create = create_from,
    .destroy = destroy,
    .fields = {{FIRST_NUMBER, NUMBERS, 1.0 + DBL_EPSILON},
               {SECOND_NUMBER, LAST_NUMBERS, 1.0 + DBL_EPSILON},
               {offsetof(vbss_grasper_config, method), 0, 1},
               {offsetof(vbss_grasper_config, kind), 0,
                VBSS_GRASPER_KIND_SHEARS - VBSS_GRASPER_KIND_NEEDLE_DRIVER},
               {offsetof(vbss_grasper_config, has_trocar), 0, 1}},
};

int test_grasper(void)
{
    const contract_run runs[] = {
        {.name = "led grasper",
         .body = {"grasper", &vbss_grasper_kind_of_slot, led_create, NULL, led_step, destroy, NULL},
         .saves = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11},
         .save_count = 11,
         .continued = 20,
         .damages = {4, 5},
         .damage_count = 2,
         .quiet = 100,
         .repeated = 30},
        {.name = "grasper at rest",
         .body = {"grasper", &vbss_grasper_kind_of_slot, plain_create, NULL, led_step, destroy,
                  NULL},
         .spoil = spoil,
         .spoil_count = 13},
    };
    return contract_check_runs("contract.grasper", runs, sizeof runs / sizeof runs[0]) +
           contract_check_object("contract.grasper", &object) +
           contract_check_snapshot("contract.grasper", &snapshot);
}
