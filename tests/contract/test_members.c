/* Threads, drains and needles in scenes. */
#include <string.h>

#include "base/error.h"
#include "contract/contract.h"

#define APART 0.1 /* m, between places */

/* ---- threads, of five segments */

static vbss_result thread_create(vbss_context *context, uint32_t place, vbss_method method,
                                 void **handle)
{
    vbss_thread_config config;
    VBSS_TRY(vbss_thread_config_init(&config, sizeof config));
    config.method = method;
    config.segment_count = 5;
    config.length = 0.01;
    config.start[1] = APART * place;
    config.cut_capacity = 1;
    return vbss_thread_create(context, &config, (vbss_thread **)handle);
}

static vbss_result thread_destroy(void *handle)
{
    return vbss_thread_destroy(handle);
}

static vbss_result thread_discard(void *handle)
{
    return vbss_thread_discard(handle);
}

static vbss_result thread_step(void *handle)
{
    return vbss_thread_step(handle, 1e-3);
}

static vbss_result thread_save(void *handle, void *bytes, uint64_t capacity, uint64_t *written)
{
    return vbss_thread_save(handle, bytes, capacity, written);
}

static vbss_result thread_restore(void *handle, const void *bytes, uint64_t count)
{
    return vbss_thread_restore(handle, bytes, count);
}

static vbss_result thread_hash(void *handle, uint64_t *hash)
{
    return vbss_thread_get_hash(handle, hash);
}

static vbss_result thread_add(vbss_scene *scene, void *handle, uint32_t *body)
{
    return vbss_scene_add_thread(scene, handle, body);
}

static vbss_result thread_cut(void *handle)
{
    vbss_thread *piece = handle;
    vbss_result result = vbss_thread_cut(handle, 5e-3, &piece);
    assert_true((result == VBSS_OK) == (piece != NULL));
    return result;
}

static void thread_use(void *thread, bool owned)
{
    (void)owned;
    vbss_thread_attachment a;
    vbss_thread_statistics statistics;
    uint32_t id;
    const double there[3] = {0.0, 1e-4, 0.0}, velocities[18] = {0.0};
    expect_ok(vbss_thread_attachment_init(&a, sizeof a));
    expect_ok(vbss_thread_attach(thread, &a, &id));
    expect_ok(vbss_thread_set_attachment_target(thread, id, there, NULL));
    expect_ok(vbss_thread_detach(thread, id));
    expect_ok(vbss_thread_set_state(thread, NULL, velocities, 6));
    expect_ok(vbss_thread_get_statistics(thread, &statistics, sizeof statistics));
    assert_int_equal(statistics.struct_size, sizeof statistics);
}

/* By threads, or by nodes: a thread reserves a thread and the nodes of the cut that it may have. */
static void thread_limit(vbss_scene_config *config, uint32_t count, uint32_t kind)
{
    config->thread_capacity = kind == 0 ? 2 * count : 8;
    config->node_capacity = kind == 0 ? 200 : 8 * count;
}

static const contract_member thread = {
    .name = "thread",
    .create = thread_create,
    .destroy = thread_destroy,
    .discard = thread_discard,
    .step = thread_step,
    .save = thread_save,
    .restore = thread_restore,
    .hash = thread_hash,
    .add = thread_add,
    .edit = thread_cut,
    .use = thread_use,
    .limit = thread_limit,
    .limit_kinds = 2,
    .add_allocations = 1,
};

/* ---- drains */

static vbss_result drain_create(vbss_context *context, uint32_t place, vbss_method method,
                                void **handle)
{
    vbss_drain_config config;
    VBSS_TRY(vbss_drain_config_init(&config, sizeof config));
    config.method = method;
    config.position[1] = APART * place;
    return vbss_drain_create(context, &config, (vbss_drain **)handle);
}

static vbss_result drain_destroy(void *handle)
{
    return vbss_drain_destroy(handle);
}

static vbss_result drain_discard(void *handle)
{
    return vbss_drain_discard(handle);
}

static vbss_result drain_step(void *handle)
{
    return vbss_drain_step(handle, 1e-3);
}

static vbss_result drain_save(void *handle, void *bytes, uint64_t capacity, uint64_t *written)
{
    return vbss_drain_save(handle, bytes, capacity, written);
}

static vbss_result drain_restore(void *handle, const void *bytes, uint64_t count)
{
    return vbss_drain_restore(handle, bytes, count);
}

static vbss_result drain_hash(void *handle, uint64_t *hash)
{
    return vbss_drain_get_hash(handle, hash);
}

static vbss_result drain_add(vbss_scene *scene, void *handle, uint32_t *body)
{
    return vbss_scene_add_drain(scene, handle, body);
}

static void drain_use(void *drain, bool owned)
{
    (void)owned;
    vbss_drain_attachment a;
    vbss_drain_places places;
    vbss_drain_gap gap;
    vbss_drain_energies energies;
    vbss_drain_statistics statistics;
    vbss_view view;
    uint32_t id;
    double there[3], force[3];
    expect_ok(vbss_drain_get_places(drain, &places, sizeof places));
    for (int32_t field = VBSS_DRAIN_VIEW_POSITIONS; field <= VBSS_DRAIN_VIEW_CURVATURES; field++) {
        expect_ok(vbss_drain_get_view(drain, field, &view, sizeof view));
    }
    expect_ok(vbss_drain_get_view(drain, VBSS_DRAIN_VIEW_POSITIONS, &view, sizeof view));
    expect_ok(vbss_drain_attachment_init(&a, sizeof a));
    a.node = places.marks[0];
    memcpy(there, (const char *)view.data + (size_t)a.node * view.stride_bytes, sizeof there);
    memcpy(a.position, there, sizeof there);
    expect_ok(vbss_drain_attach(drain, &a, &id));
    expect_ok(vbss_drain_set_attachment_target(drain, id, there));
    expect_ok(vbss_drain_get_reaction(drain, id, force));
    expect_ok(vbss_drain_detach(drain, id));
    expect_ok(vbss_drain_set_state(drain, (const double *)view.data, NULL, places.node_count));
    expect_ok(vbss_drain_get_gap(drain, &gap, sizeof gap));
    expect_ok(vbss_drain_get_energies(drain, &energies, sizeof energies));
    expect_ok(vbss_drain_get_statistics(drain, &statistics, sizeof statistics));
    assert_int_equal(statistics.struct_size, sizeof statistics);
}

static void drain_limit(vbss_scene_config *config, uint32_t count, uint32_t kind)
{
    (void)kind;
    config->drain_capacity = count;
}

static const contract_member drain = {
    .name = "drain",
    .create = drain_create,
    .destroy = drain_destroy,
    .discard = drain_discard,
    .step = drain_step,
    .save = drain_save,
    .restore = drain_restore,
    .hash = drain_hash,
    .add = drain_add,
    .use = drain_use,
    .limit = drain_limit,
    .limit_kinds = 1,
    .add_allocations = 3,
};

/* ---- needles */

/* Falling, unless gravity acts on it in a scene: it keeps its own motion. */
static vbss_result needle_create(vbss_context *context, uint32_t place, vbss_method method,
                                 void **handle)
{
    vbss_needle_config config;
    VBSS_TRY(vbss_needle_config_init(&config, sizeof config));
    config.method = method;
    config.position[0] = APART * place;
    config.gravity[2] = -9.81;
    config.velocity[0] = 0.1;
    return vbss_needle_create(context, &config, (vbss_needle **)handle);
}

static vbss_result needle_destroy(void *handle)
{
    return vbss_needle_destroy(handle);
}

static vbss_result needle_discard(void *handle)
{
    return vbss_needle_discard(handle);
}

static vbss_result needle_step(void *handle)
{
    return vbss_needle_step(handle, 1e-3);
}

static vbss_result needle_save(void *handle, void *bytes, uint64_t capacity, uint64_t *written)
{
    return vbss_needle_save(handle, bytes, capacity, written);
}

static vbss_result needle_restore(void *handle, const void *bytes, uint64_t count)
{
    return vbss_needle_restore(handle, bytes, count);
}

static vbss_result needle_hash(void *handle, uint64_t *hash)
{
    return vbss_needle_get_hash(handle, hash);
}

static vbss_result needle_add(vbss_scene *scene, void *handle, uint32_t *body)
{
    return vbss_scene_add_needle(scene, handle, body);
}

static vbss_result needle_put(void *handle)
{
    const double there[3] = {0.0, 0.0, 0.1};
    return vbss_needle_set_state(handle, there, NULL, NULL, NULL);
}

/* Its state names its body in the scene. */
static void needle_use(void *needle, bool owned)
{
    vbss_needle_state state;
    expect_ok(vbss_needle_get_state(needle, &state, sizeof state));
    assert_int_equal(state.body != 0, owned);
}

/* By bodies, or by capsules. */
static void needle_limit(vbss_scene_config *config, uint32_t count, uint32_t kind)
{
    vbss_needle_config own;
    expect_ok(vbss_needle_config_init(&own, sizeof own));
    config->rigid_capacity = kind == 0 ? count : 8;
    config->capsule_capacity = kind == 0   ? 64
                               : count < 1 ? own.segment_count - 1
                                           : (count + 1) * own.segment_count - 1;
}

static const contract_member needle = {
    .name = "needle",
    .create = needle_create,
    .destroy = needle_destroy,
    .discard = needle_discard,
    .step = needle_step,
    .save = needle_save,
    .restore = needle_restore,
    .hash = needle_hash,
    .add = needle_add,
    .edit = needle_put,
    .use = needle_use,
    .limit = needle_limit,
    .limit_kinds = 2,
    .add_allocations = 1,
};

int test_members(void)
{
    return contract_check_member("contract.members", &thread) +
           contract_check_member("contract.members", &drain) +
           contract_check_member("contract.members", &needle);
}
