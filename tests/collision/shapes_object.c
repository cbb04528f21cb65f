#include "collision/shapes_object.h"

#include "base/error.h"

static const uint32_t triangles[] = {0, 1, 2, 2, 1, 3};
static const double rest_lengths[] = {1.0, 1.0, 1.0, 1.0, 1.0};

/* ---- the object */

static void place(double *positions, uint32_t count, double time, double height)
{
    for (uint32_t i = 0; i < count; i++) {
        uint32_t row = i / 3;
        vec3 at = vec3_make(0.5 * (i % 3) + 0.1 * time, height + 0.03 * i * time,
                            0.7 * row + 0.2 * time * i);
        vec3_store(positions + 3 * (size_t)i, at);
    }
}

void object_move(vbss_collision *collision, double time)
{
    const uint32_t nodes[OBJECT_SHAPES] = {6, 6, 4};
    double x[18];
    for (uint32_t shape = 0; shape < OBJECT_SHAPES; shape++) {
        place(x, nodes[shape], time, 0.3 * shape);
        expect_ok(vbss_collision_set_motion(collision, shape, NULL, x, nodes[shape]));
    }
}

vbss_collision *object_make_unsearched(vbss_context *context, const vbss_collision_config *config)
{
    vbss_collision *collision;
    uint32_t name;
    expect_ok(vbss_collision_create(context, config, &collision));
    expect_ok(vbss_collision_add_chain(collision, 6, rest_lengths, 0.1, &name));
    expect_ok(vbss_collision_add_capsules(collision, 3, 0.1, &name));
    expect_ok(vbss_collision_add_mesh(collision, 4, triangles, 2, 0.1, &name));
    object_move(collision, 0.0);
    object_move(collision, 1.0);
    return collision;
}

vbss_collision *object_make(vbss_context *context, const vbss_collision_config *config)
{
    vbss_collision *collision = object_make_unsearched(context, config);
    expect_ok(vbss_collision_find_candidates(collision));
    expect_ok(vbss_collision_find_impacts(collision));
    return collision;
}

void object_begin(object_fixture *f)
{
    f->context = harness_context(&f->memory);
    f->collision = object_make(f->context, NULL);
}

void object_end(object_fixture *f)
{
    harness_context_end(f->context, &f->memory);
}

uint64_t object_hash(vbss_collision *collision)
{
    uint64_t hash;
    expect_ok(vbss_collision_get_hash(collision, &hash));
    return hash;
}

/* ---- calls */

static vbss_result call_chain(void *c)
{
    uint32_t name;
    return vbss_collision_add_chain(c, 30, NULL, 0.1, &name);
}
static vbss_result call_capsules(void *c)
{
    uint32_t name;
    return vbss_collision_add_capsules(c, 20, 0.1, &name);
}
static vbss_result call_mesh(void *c)
{
    uint32_t name;
    return vbss_collision_add_mesh(c, 4, triangles, 2, 0.1, &name);
}
static vbss_result call_move(void *c)
{
    const double x[18] = {0.0};
    return vbss_collision_set_motion(c, OBJECT_CHAIN, NULL, x, 6);
}
static vbss_result call_candidates(void *c)
{
    return vbss_collision_find_candidates(c);
}
static vbss_result call_impacts(void *c)
{
    return vbss_collision_find_impacts(c);
}
static vbss_result call_filter(void *c)
{
    return vbss_collision_set_filter(c, OBJECT_CAPSULES, 2, 3);
}
static vbss_result call_remove(void *c)
{
    return vbss_collision_remove(c, OBJECT_CAPSULES);
}
vbss_result object_call_restore(void *c)
{
    const uint8_t bytes[64] = {0};
    return vbss_collision_restore(c, bytes, sizeof bytes);
}
static vbss_result call_test(void *c)
{
    const double x[12] = {0.0};
    vbss_collision_impact impact;
    return vbss_collision_test(c, VBSS_COLLISION_PAIR_EDGE_EDGE, x, x, &impact, sizeof impact);
}
static vbss_result call_batch(void *c)
{
    vbss_collision_batch batch;
    VBSS_TRY(vbss_collision_batch_init(&batch, sizeof batch));
    return vbss_collision_test_batch(c, &batch);
}
static vbss_result call_edge(void *c)
{
    uint32_t nodes[2];
    return vbss_collision_get_edge(c, OBJECT_MESH, 0, nodes);
}
static vbss_result call_save(void *c)
{
    uint64_t written;
    vbss_result result = vbss_collision_save(c, NULL, 0, &written);
    return result == VBSS_ERROR_CAPACITY ? VBSS_OK : result;
}
static vbss_result call_hash(void *c)
{
    uint64_t hash;
    return vbss_collision_get_hash(c, &hash);
}
static vbss_result call_view(void *c)
{
    vbss_view view;
    return object_write_out(c, 0, &view, sizeof view);
}
static vbss_result call_statistics(void *c)
{
    vbss_collision_statistics statistics;
    return object_write_out(c, 1, &statistics, sizeof statistics);
}

const harness_handle_call object_calls[OBJECT_CALLS] = {
    call_chain,  call_capsules, call_mesh,           call_move,      call_candidates, call_impacts,
    call_filter, call_remove,   object_call_restore, call_test,      call_batch,      call_edge,
    call_save,   call_hash,     call_view,           call_statistics};

vbss_result object_write_out(vbss_collision *collision, int which, void *out, uint32_t size)
{
    return which == 0
               ? vbss_collision_get_view(collision, VBSS_COLLISION_VIEW_CANDIDATES, out, size)
               : vbss_collision_get_statistics(collision, out, size);
}
