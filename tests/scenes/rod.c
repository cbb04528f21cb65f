#include "scenes/rod.h"

#include "base/check.h"
#include "base/config.h"
#include "base/error.h"
#include "base/linear.h"
#include "base/memory.h"
#include "base/random.h"
#include "base/rotation.h"
#include "base/stream.h"

#include <string.h>

_Static_assert(sizeof(rod_config) == 32, "no hidden padding");

struct rod_object {
    vbss_context *context;
    uint32_t node_count;
    double segment_length, gust;
    vec3 *positions, *velocities;
    quat orientation;
    vec3 spin;
    uint64_t steps;
    vbss_random random;
    vec3 *before; /* positions when a substep began; of one step */
};
typedef struct rod_object rod_object;

enum { SUBSTEPS = 4 };

static void free_object(vbss_context *context, void *object)
{
    rod_object *r = object;
    vbss_release(context, r->positions, r->node_count, sizeof(vec3));
    vbss_release(context, r->velocities, r->node_count, sizeof(vec3));
    vbss_release(context, r->before, r->node_count, sizeof(vec3));
    vbss_release(context, r, 1, sizeof *r);
}

static void serialise(vbss_stream *stream, void *object)
{
    rod_object *r = object;
    size_t numbers = 3u * (size_t)r->node_count;
    vbss_stream_expect(stream, 1, r->node_count);
    vbss_stream_expect_f64(stream, 2, r->segment_length);
    vbss_stream_expect_f64(stream, 3, r->gust);
    vbss_stream_f64(stream, 4, &r->positions[0].x, numbers);
    vbss_stream_f64(stream, 5, &r->velocities[0].x, numbers);
    vbss_stream_f64(stream, 6, &r->orientation.w, 4);
    vbss_stream_f64(stream, 7, &r->spin.x, 3);
    vbss_stream_u64(stream, 8, &r->steps, 1);
    vbss_random_serialise(stream, 9, &r->random);
}

const vbss_kind rod_kind = {"rod", VBSS_CODE('R', 'O', 'D', ' '), 1, free_object, serialise};

static const rod_config defaults = {
    .struct_size = sizeof(rod_config), .node_count = 64, .length = 0.15, .gust = 0.01, .seed = 1};
const uint32_t rod_config_sizes[3] = {24, 32, 0};
static const vbss_layout config_layout = {"rod_config", &defaults, rod_config_sizes};

vbss_result rod_config_init(rod_config *config, uint32_t struct_size)
{
    return vbss_config_init(&config_layout, config, struct_size);
}

static vbss_result check(vbss_context *context, const rod_config *config)
{
    VBSS_TRY(vbss_check_range(context, config->node_count, 2.0, 4096.0, "node_count"));
    VBSS_TRY(vbss_check_range(context, config->length, 1e-6, 1e3, "length"));
    return vbss_check_range(context, config->gust, 0.0, 1.0, "gust");
}

/* The memory of a rod; what failed is left for free_object. */
static vbss_result allocate_parts(rod_object *r)
{
    r->positions = vbss_allocate(r->context, r->node_count, sizeof(vec3), "rod positions");
    r->velocities = vbss_allocate(r->context, r->node_count, sizeof(vec3), "rod velocities");
    r->before = vbss_allocate(r->context, r->node_count, sizeof(vec3), "rod previous positions");
    if (r->positions == NULL || r->velocities == NULL || r->before == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    return VBSS_OK;
}

vbss_result rod_create(vbss_context *context, const rod_config *config, rod **handle)
{
    VBSS_TRY(vbss_context_open(context));
    VBSS_TRY(vbss_check_pointer(context, handle, "handle"));
    *handle = NULL;
    VBSS_TRY(vbss_context_edit(context));
    rod_config own;
    VBSS_TRY(vbss_config_read(context, &config_layout, config, &own));
    VBSS_TRY(check(context, &own));

    rod_object *r = vbss_allocate(context, 1, sizeof *r, "rod");
    if (r == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    r->context = context;
    r->node_count = own.node_count;
    r->segment_length = own.length / (own.node_count - 1.0);
    r->gust = own.gust;
    r->orientation = quat_identity();
    r->spin = vec3_make(1.0, 2.0, 3.0);
    vbss_random_seed(&r->random, own.seed, 0);
    vbss_slot *slot = NULL;
    vbss_result result = allocate_parts(r);
    if (result == VBSS_OK) {
        result = vbss_slot_create(context, &rod_kind, r, &slot);
    }
    if (result != VBSS_OK) {
        free_object(context, r);
        return result;
    }
    for (uint32_t i = 0; i < own.node_count; i++) {
        r->positions[i] = vec3_make(i * r->segment_length, 0.0, 0.0);
    }
    *handle = (rod *)slot;
    return VBSS_OK;
}

vbss_result rod_destroy(rod *handle)
{
    return vbss_slot_destroy(handle, &rod_kind);
}

/* Moves both ends of every segment, the first node excepted, to its rest length: one sweep. */
static void restore_lengths(rod_object *r)
{
    for (uint32_t i = 0; i + 1 < r->node_count; i++) {
        vec3 e = vec3_sub(r->positions[i + 1], r->positions[i]);
        double length = vec3_norm(e);
        double share = i == 0 ? 0.0 : 0.5; /* of the correction that the inner end takes */
        vec3 correction = vec3_scale(e, (length - r->segment_length) / length);
        r->positions[i] = vec3_add_scaled(r->positions[i], share, correction);
        r->positions[i + 1] = vec3_add_scaled(r->positions[i + 1], share - 1.0, correction);
    }
}

vbss_result rod_step(rod *handle, double h)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit(handle, &rod_kind, &slot));
    rod_object *r = slot->object;
    VBSS_TRY(vbss_check_range(r->context, h, 1e-9, 0.1, "h"));
    VBSS_TRY(vbss_check_arithmetic(r->context));

    vec3 *before = r->before;
    uint32_t gusty = vbss_random_below(&r->random, r->node_count - 1) + 1;
    r->velocities[gusty] =
        vec3_add_scaled(r->velocities[gusty], r->gust, vbss_random_direction(&r->random));
    double dt = h / SUBSTEPS;
    for (int substep = 0; substep < SUBSTEPS; substep++) {
        memcpy(before, r->positions, r->node_count * sizeof *before);
        for (uint32_t i = 1; i < r->node_count; i++) {
            r->velocities[i].z -= 9.81 * dt;
            r->positions[i] = vec3_add_scaled(r->positions[i], dt, r->velocities[i]);
        }
        restore_lengths(r);
        for (uint32_t i = 1; i < r->node_count; i++) {
            r->velocities[i] = vec3_scale(vec3_sub(r->positions[i], before[i]), 1.0 / dt);
        }
    }
    vec3 tip = r->positions[r->node_count - 1];
    r->spin = vec3_add_scaled(r->spin, h, vec3_cross(tip, r->spin));
    r->orientation = vbss_quat_integrate(r->orientation, r->spin, h);
    r->steps++;
    return VBSS_OK;
}

vbss_result rod_get_tip(const rod *handle, double tip[3])
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(handle, &rod_kind, &slot));
    const rod_object *r = slot->object;
    VBSS_TRY(vbss_check_pointer(r->context, tip, "tip"));
    vec3_store(tip, r->positions[r->node_count - 1]);
    return VBSS_OK;
}
