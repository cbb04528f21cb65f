/* The contract of threads. */
#include <stdlib.h>
#include <string.h>

#include "base/error.h"
#include "contract/contract.h"
#include "fixtures/thread_body.h"

/* ---- scripted runs */

#define TUGGED(kind, method, bending, segments)                             \
    &(thread_body_options)                                                  \
    {                                                                       \
        kind, VBSS_METHOD_##method, VBSS_THREAD_BENDING_##bending, segments \
    }
#define PULLED_RUN(title, stepped, options)                                              \
    {                                                                                    \
        .name = (title), .body = {"thread", &vbss_thread_kind, thread_body_create,       \
                                  NULL,     stepped,           thread_body_destroy,      \
                                  options},                                              \
        .saves = {1, 7, 9, THREAD_SCENE_CUT_STEP, 70}, .save_count = 5, .continued = 40, \
        .damages = {30, THREAD_SCENE_CUT_STEP + 5}, .damage_count = 2, .quiet = 100,     \
        .repeated = 100                                                                  \
    }

/* Its mesh changes while it swings. */
static vbss_result adaptive_create(vbss_context *context, void *user, void **handle)
{
    vbss_thread_config c;
    vbss_thread_attachment a;
    vbss_thread *thread;
    uint32_t id;
    VBSS_TRY(vbss_thread_config_init(&c, sizeof c));
    VBSS_TRY(vbss_thread_attachment_init(&a, sizeof a));
    c.mesh = VBSS_THREAD_MESH_ADAPTIVE;
    c.bending = *(const vbss_thread_bending *)user;
    c.segment_count = 40;
    c.length = 0.08;
    c.node_capacity = 90;
    c.refine_angle = 0.06;
    c.coarsen_angle = 0.03;
    c.coarsest_length = 4e-3;
    a.kind = VBSS_THREAD_ATTACHMENT_CLAMP;
    VBSS_TRY(vbss_thread_create(context, &c, &thread));
    VBSS_TRY(vbss_thread_attach(thread, &a, &id));
    *handle = thread;
    return VBSS_OK;
}

static vbss_result call_step(void *handle)
{
    return vbss_thread_step(handle, 1e-3);
}

#define ADAPTIVE_RUN(title, bending)                                             \
    {                                                                            \
        .name = (title),                                                         \
        .body = {"adaptive thread",                                              \
                 &vbss_thread_kind,                                              \
                 adaptive_create,                                                \
                 NULL,                                                           \
                 call_step,                                                      \
                 thread_body_destroy,                                            \
                 &(vbss_thread_bending){bending}},                               \
        .saves = {0, 25, 90}, .save_count = 3, .continued = 60, .damages = {40}, \
        .damage_count = 1, .quiet = 150, .repeated = 100                         \
    }

/* The published method, clamped by the host and moved. */
static vbss_result paper_create(vbss_context *context, void *user, void **handle)
{
    (void)user;
    vbss_thread_config config;
    VBSS_TRY(vbss_thread_config_init(&config, sizeof config));
    config.method = VBSS_METHOD_VBLAST;
    config.segment_count = 20;
    return vbss_thread_create(context, &config, (vbss_thread **)handle);
}

static vbss_result paper_clamp(void *handle)
{
    uint32_t id;
    vbss_thread_attachment clamp;
    VBSS_TRY(vbss_thread_attachment_init(&clamp, sizeof clamp));
    clamp.kind = VBSS_THREAD_ATTACHMENT_CLAMP;
    VBSS_TRY(vbss_thread_attach(handle, &clamp, &id));
    return vbss_thread_set_attachment_target(handle, id, (const double[3]){0.001, 0.0, 0.0}, NULL);
}

/* ---- the object */

static vbss_result config_init(void *config, uint32_t struct_size)
{
    return vbss_thread_config_init(config, struct_size);
}

static vbss_result create_and_destroy(vbss_context *context, const void *config)
{
    vbss_thread *thread;
    VBSS_TRY(vbss_thread_create(context, config, &thread));
    return vbss_thread_destroy(thread);
}

static vbss_result attachment_init(void *attachment, uint32_t struct_size)
{
    return vbss_thread_attachment_init(attachment, struct_size);
}

static vbss_result attach_and_destroy(vbss_context *context, const void *attachment)
{
    vbss_thread_config config;
    vbss_thread *thread;
    uint32_t id;
    VBSS_TRY(vbss_thread_config_init(&config, sizeof config));
    config.segment_count = 1;
    VBSS_TRY(vbss_thread_create(context, &config, &thread));
    vbss_result result = vbss_thread_attach(thread, attachment, &id);
    VBSS_TRY(vbss_thread_destroy(thread));
    return result;
}

static const void *good_config(void)
{
    static vbss_thread_config config;
    expect_ok(vbss_thread_config_init(&config, sizeof config));
    return &config;
}

static vbss_result create_from(vbss_context *context, const void *config, void **handle)
{
    return vbss_thread_create(context, config, (vbss_thread **)handle);
}

static vbss_result pin_first_node(vbss_thread *thread)
{
    vbss_thread_attachment a;
    uint32_t id;
    VBSS_TRY(vbss_thread_attachment_init(&a, sizeof a));
    return vbss_thread_attach(thread, &a, &id);
}

/* Of one segment, pinned at its first node. */
static vbss_result create(vbss_context *context, void **handle)
{
    vbss_thread_config config;
    vbss_thread *thread;
    VBSS_TRY(vbss_thread_config_init(&config, sizeof config));
    config.segment_count = 1;
    config.cut_capacity = 1;
    VBSS_TRY(vbss_thread_create(context, &config, &thread));
    *handle = thread;
    return pin_first_node(thread);
}

static vbss_result reject(void *handle)
{
    return vbss_thread_step(handle, 1.0);
}

static vbss_result get_hash(void *handle, uint64_t *hash)
{
    return vbss_thread_get_hash(handle, hash);
}

/* ---- structs that go out */

static vbss_result write_reaction(void *handle, void *out, uint32_t size)
{
    return vbss_thread_get_reaction(handle, 1, out, size);
}
static vbss_result write_view(void *handle, void *out, uint32_t size)
{
    return vbss_thread_get_view(handle, VBSS_THREAD_VIEW_POSITIONS, out, size);
}
static vbss_result write_energies(void *handle, void *out, uint32_t size)
{
    return vbss_thread_get_energies(handle, out, size);
}
static vbss_result write_momentum(void *handle, void *out, uint32_t size)
{
    return vbss_thread_get_momentum(handle, out, size);
}
static vbss_result write_statistics(void *handle, void *out, uint32_t size)
{
    return vbss_thread_get_statistics(handle, out, size);
}

/* ---- calls */

static vbss_result call_set_state(void *t)
{
    static const double state_of_two[6];
    return vbss_thread_set_state(t, state_of_two, NULL, 2);
}
static vbss_result call_attach(void *t)
{
    vbss_thread_attachment a;
    uint32_t id;
    VBSS_TRY(vbss_thread_attachment_init(&a, sizeof a));
    a.node = 1;
    return vbss_thread_attach(t, &a, &id);
}
static vbss_result call_move(void *t)
{
    static const double zero[3];
    return vbss_thread_set_attachment_target(t, 1, zero, NULL);
}
/* Without twist. */
static vbss_result call_set_roll(void *t)
{
    return vbss_thread_set_roll(t, 1, 0.5);
}

static vbss_result call_detach(void *t)
{
    return vbss_thread_detach(t, 1);
}
static vbss_result call_cut(void *t)
{
    vbss_thread *piece;
    return vbss_thread_cut(t, 0.04, &piece);
}
static vbss_result call_restore(void *t)
{
    uint8_t bytes[64] = {0};
    return vbss_thread_restore(t, bytes, sizeof bytes);
}
static vbss_result call_save(void *t)
{
    uint64_t written;
    vbss_result result = vbss_thread_save(t, NULL, 0, &written);
    return result == VBSS_ERROR_CAPACITY ? VBSS_OK : result;
}
static vbss_result call_hash(void *t)
{
    uint64_t hash;
    return vbss_thread_get_hash(t, &hash);
}
static vbss_result call_reaction(void *t)
{
    vbss_thread_reaction out;
    return write_reaction(t, &out, sizeof out);
}
static vbss_result call_view(void *t)
{
    vbss_view out;
    return write_view(t, &out, sizeof out);
}
static vbss_result call_energies(void *t)
{
    vbss_thread_energies out;
    return write_energies(t, &out, sizeof out);
}
static vbss_result call_momentum(void *t)
{
    vbss_thread_momentum out;
    return write_momentum(t, &out, sizeof out);
}
static vbss_result call_statistics(void *t)
{
    vbss_thread_statistics out;
    return write_statistics(t, &out, sizeof out);
}

/* ---- memory */

static vbss_result save_restore_step(vbss_thread *thread)
{
    uint64_t count = 0, need = 0;
    (void)vbss_thread_save(thread, NULL, 0, &need);
    uint8_t *bytes = malloc(need);
    assert_non_null(bytes);
    vbss_result result = vbss_thread_save(thread, bytes, need, &count);
    result = result == VBSS_OK ? vbss_thread_restore(thread, bytes, count) : result;
    free(bytes);
    return result == VBSS_OK ? vbss_thread_step(thread, 1e-3) : result;
}

/* The parent ends first: its piece still owns the rest of the reserve. */
static vbss_result attempt(vbss_context *context, void *user)
{
    const vbss_thread_config *config = user;
    vbss_thread *thread, *piece = NULL;
    VBSS_TRY(vbss_thread_create(context, config, &thread));
    vbss_result result = VBSS_OK;
    if (config->cut_capacity > 0) {
        result = vbss_thread_cut(thread, 0.4 * config->length, &piece);
    }
    result = result == VBSS_OK ? save_restore_step(thread) : result;
    VBSS_TRY(vbss_thread_destroy(thread));
    VBSS_TRY(vbss_thread_destroy(piece));
    return result;
}

static void *small_config(uint32_t cuts, uint32_t attachments, vbss_thread_bending bending)
{
    static vbss_thread_config config;
    expect_ok(vbss_thread_config_init(&config, sizeof config));
    config.segment_count = 5;
    config.cut_capacity = cuts;
    config.attachment_capacity = attachments;
    config.bending = bending;
    return &config;
}
static void *plain(void)
{
    return small_config(0, 0, VBSS_THREAD_BENDING_SPLINE);
}
static void *attached(void)
{
    return small_config(0, 3, VBSS_THREAD_BENDING_SPLINE);
}
static void *cut_once(void)
{
    return small_config(1, 0, VBSS_THREAD_BENDING_SPLINE);
}
static void *cut_once_attached(void)
{
    return small_config(1, 3, VBSS_THREAD_BENDING_SPLINE);
}
static void *cut_twice(void)
{
    return small_config(2, 0, VBSS_THREAD_BENDING_SPLINE);
}
static void *cut_twice_attached(void)
{
    return small_config(2, 3, VBSS_THREAD_BENDING_SPLINE);
}
static void *local_bending(void)
{
    return small_config(2, 3, VBSS_THREAD_BENDING_LOCAL);
}

static vbss_result cycle(vbss_context *context, uint32_t i)
{
    vbss_thread_config config;
    vbss_thread *piece, *thread;
    (void)i;
    VBSS_TRY(vbss_thread_config_init(&config, sizeof config));
    config.cut_capacity = 1;
    VBSS_TRY(vbss_thread_create(context, &config, &thread));
    VBSS_TRY(vbss_thread_cut(thread, 0.07, &piece));
    VBSS_TRY(vbss_thread_destroy(thread));
    return vbss_thread_destroy(piece);
}

static const uint32_t config_sizes[] = {280, 312, 328, 0}, attachment_sizes[] = {112, 0};

static const contract_object object = {
    .name = "thread",
    .configs = {{config_sizes, config_init, create_and_destroy},
                {attachment_sizes, attachment_init, attach_and_destroy}},
    .create = create,
    .create_from = create_from,
    .config = good_config,
    .null_config = VBSS_OK,
    .destroy = thread_body_destroy,
    .reject = reject,
    .hash = get_hash,
    .outputs = {{56, {0}, write_reaction},
                {sizeof(vbss_view), {0}, write_view},
                {64, {48, 56}, write_energies},
                {88, {0}, write_momentum},
                {160, {0}, write_statistics}},
    .calls = {{.call = call_step, .edits = true},
              {.call = call_set_state, .edits = true},
              {.call = call_attach, .edits = true},
              {.call = call_move, .edits = true},
              {.call = call_set_roll, .edits = true, .result = VBSS_ERROR_INCOMPATIBLE},
              {.call = call_detach, .edits = true},
              {.call = call_cut, .edits = true},
              {.call = call_restore, .edits = true, .result = VBSS_ERROR_CORRUPT},
              {.call = call_save},
              {.call = call_hash},
              {.call = call_reaction, .is_one_time = true}, /* it is detached by then */
              {.call = call_view},
              {.call = call_energies},
              {.call = call_momentum},
              {.call = call_statistics}},
    .attempts = {{attempt, plain},
                 {attempt, attached},
                 {attempt, cut_once},
                 {attempt, cut_once_attached},
                 {attempt, cut_twice},
                 {attempt, cut_twice_attached},
                 {attempt, local_bending}},
    .cycle = cycle,
    .cycles = 20,
};

/* ---- snapshots */

static void twelve_segments(void *config)
{
    expect_ok(vbss_thread_config_init(config, sizeof(vbss_thread_config)));
    ((vbss_thread_config *)config)->segment_count = 12;
}

static void reserve_cuts(void *config)
{
    ((vbss_thread_config *)config)->cut_capacity = 2;
}

static vbss_result save(void *handle, void *bytes, uint64_t capacity, uint64_t *written)
{
    return vbss_thread_save(handle, bytes, capacity, written);
}

static vbss_result restore(void *handle, const void *bytes, uint64_t count)
{
    return vbss_thread_restore(handle, bytes, count);
}

#define NUMBER(field)                                 \
    {                                                 \
        offsetof(vbss_thread_config, field), 1, 0.999 \
    }
#define CHOICE(field, change)                          \
    {                                                  \
        offsetof(vbss_thread_config, field), 0, change \
    }

/* The numbers that the motion depends on. */
static const contract_snapshot snapshot = {
    .name = "thread",
    .kind = &vbss_thread_kind,
    .config = twelve_segments,
    .config_size = sizeof(vbss_thread_config),
    .create = create_from,
    .destroy = thread_body_destroy,
    .save = save,
    .restore = restore,
    .fields = {NUMBER(radius), NUMBER(linear_density), NUMBER(axial_stiffness),
               NUMBER(bending_stiffness), NUMBER(rest_curvature), NUMBER(yield_curvature),
               NUMBER(relaxation_ratio), NUMBER(torsional_stiffness), NUMBER(gravity[2]),
               NUMBER(drag), NUMBER(damping), NUMBER(spectral_radius), NUMBER(stretch_tolerance),
               NUMBER(position_tolerance), CHOICE(bending, 1), CHOICE(segment_count, -1),
               CHOICE(iteration_limit, -1), CHOICE(halving_limit, -1),
               CHOICE(attachment_capacity, -1)},
    .reserve_more = reserve_cuts,
    .step = call_step,
};

int test_thread(void)
{
    const contract_run runs[] = {
        PULLED_RUN("released thread", thread_body_step_released,
                   TUGGED(THREAD_SCENE_RELEASE, IMPLICIT, SPLINE, 16)),
        PULLED_RUN("pulled thread", thread_body_step,
                   TUGGED(THREAD_SCENE_TUGGED, IMPLICIT, SPLINE, 16)),
        PULLED_RUN("pulled thread, local bending", thread_body_step,
                   TUGGED(THREAD_SCENE_TUGGED, IMPLICIT, LOCAL, 13)),
        PULLED_RUN("cut thread", thread_body_step_and_cut,
                   TUGGED(THREAD_SCENE_CUT, IMPLICIT, SPLINE, 16)),
        PULLED_RUN("cut thread, local bending", thread_body_step_and_cut,
                   TUGGED(THREAD_SCENE_CUT, IMPLICIT, LOCAL, 24)),
        PULLED_RUN("pulled thread, baseline", thread_body_step,
                   TUGGED(THREAD_SCENE_TUGGED, VBLAST, SPLINE, 16)),
        PULLED_RUN("cut thread, baseline", thread_body_step_and_cut,
                   TUGGED(THREAD_SCENE_CUT, VBLAST, SPLINE, 16)),
        ADAPTIVE_RUN("adaptive thread", VBSS_THREAD_BENDING_SPLINE),
        ADAPTIVE_RUN("adaptive thread, local bending", VBSS_THREAD_BENDING_LOCAL),
        {.name = "clamped thread, baseline",
         .body = {"paper thread", &vbss_thread_kind, paper_create, paper_clamp, call_step,
                  thread_body_destroy, NULL},
         .saves = {20},
         .save_count = 1,
         .continued = 20,
         .quiet = 5},
    };
    return contract_check_runs("contract.thread", runs, sizeof runs / sizeof runs[0]) +
           contract_check_object("contract.thread", &object) +
           contract_check_snapshot("contract.thread", &snapshot);
}
