/* Configurations and memory of threads. */
#include "base/api_call.h"
#include "base/baseline_config.h"
#include "base/check.h"
#include "base/config.h"
#include "base/error.h"
#include "base/memory.h"
#include "thread/thread.h"

#include <string.h>

_Static_assert(sizeof(vbss_thread_config) == VBSS_SIZE_WITH_POINTERS(vbss_thread_config, 304u, 3u),
               "published size");

/* ---- configurations */

/* The thread of VBLaST-SS, published. */
#define VBLAST_RADIUS 0.125e-3
#define VBLAST_LINEAR_DENSITY 6.4e-5
#define VBLAST_AXIAL_STIFFNESS 427.0
#define VBLAST_BENDING_STIFFNESS 1e-8

static const vbss_thread_config defaults = {
    .struct_size = sizeof(vbss_thread_config),
    .method = VBSS_METHOD_IMPLICIT,
    .bending = VBSS_THREAD_BENDING_SPLINE,
    .segment_count = 120,
    .attachment_capacity = 8,
    .length = 0.15,
    .radius = VBLAST_RADIUS,
    .linear_density = VBLAST_LINEAR_DENSITY,
    .axial_stiffness = VBLAST_AXIAL_STIFFNESS,
    .bending_stiffness = VBLAST_BENDING_STIFFNESS,
    .gravity = {0.0, -9.81, 0.0},
    .direction = {1.0, 0.0, 0.0},
    .spectral_radius = 0.3,
    .stretch_tolerance = 1e-6,
    .position_tolerance = 1e-6,
    .iteration_limit = 40,
    .halving_limit = 5,
    .mesh = VBSS_THREAD_MESH_FIXED,
    .finest_length = 3e-4,
    .coarsest_length = 2e-3,
    .refine_angle = 0.25,
    .coarsen_angle = 0.05,
    .near_distance = 1e-3,
    .clear_distance = 3e-3,
    .mesh_operations = 4,
    .relaxation_time = 1.0,
};
static const uint32_t config_sizes[] = {VBSS_SIZE_WITH_POINTERS(vbss_thread_config, 256u, 3u),
                                        VBSS_SIZE_WITH_POINTERS(vbss_thread_config, 288u, 3u),
                                        VBSS_SIZE_WITH_POINTERS(vbss_thread_config, 304u, 3u), 0};
static const vbss_layout config_layout = {"vbss_thread_config", &defaults, config_sizes};

vbss_result vbss_thread_config_init(vbss_thread_config *config, uint32_t struct_size)
{
    return vbss_config_init(&config_layout, config, struct_size);
}

vbss_result vbss_thread_check_config_size(const vbss_thread_config *config)
{
    vbss_thread_config own;
    return vbss_config_read(NULL, &config_layout, config, &own);
}

vbss_result vbss_thread_config_preset(vbss_thread_config *config, vbss_thread_preset preset)
{
    VBSS_ENTER(NULL);
    VBSS_TRY(vbss_thread_check_config_size(config));
    switch (preset) {
    case VBSS_THREAD_PRESET_SILK_2_0:
        config->radius = 0.16e-3;
        config->linear_density = 1.05e-4;
        config->axial_stiffness = 700.0;
        config->bending_stiffness = 2.7e-8;
        return VBSS_OK;
    case VBSS_THREAD_PRESET_VBLAST:
        config->radius = VBLAST_RADIUS;
        config->linear_density = VBLAST_LINEAR_DENSITY;
        config->axial_stiffness = VBLAST_AXIAL_STIFFNESS;
        config->bending_stiffness = VBLAST_BENDING_STIFFNESS;
        return VBSS_OK;
    default:
        return VBSS_ERROR_OUT_OF_RANGE;
    }
}

typedef struct range {
    const char *name;
    double value, low, high;
} range;

static vbss_result check_ranges(vbss_context *context, const range *ranges, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const range *r = &ranges[i];
        VBSS_TRY(vbss_check_range(context, r->value, r->low, r->high, r->name));
    }
    return VBSS_OK;
}

static vbss_result check_choices(vbss_context *context, const vbss_thread_config *c)
{
    const range ranges[] = {
        {"method", c->method, VBSS_METHOD_IMPLICIT, VBSS_METHOD_VBLAST},
        {"bending", c->bending, VBSS_THREAD_BENDING_SPLINE, VBSS_THREAD_BENDING_LOCAL},
        {"segment_count", c->segment_count, 1.0, 65536.0},
        {"attachment_capacity", c->attachment_capacity, 0.0, 256.0},
        {"cut_capacity", c->cut_capacity, 0.0, 64.0},
        {"iteration_limit", c->iteration_limit, 1.0, 100.0},
        {"halving_limit", c->halving_limit, 0.0, 10.0},
        {"radius", c->radius, 1e-7, 0.1},
        {"linear_density", c->linear_density, 1e-9, 1e3},
        {"axial_stiffness", c->axial_stiffness, 1e-6, 1e9},
        {"bending_stiffness", c->bending_stiffness, 0.0, 1e3},
        {"rest_curvature", c->rest_curvature, 0.0, 1e4},
        {"drag", c->drag, 0.0, 1e6},
        {"damping", c->damping, 0.0, 1e6},
        {"spectral_radius", c->spectral_radius, 0.0, 1.0},
        {"stretch_tolerance", c->stretch_tolerance, 1e-12, 1e-2},
        {"position_tolerance", c->position_tolerance, 1e-12, 1.0},
        {"mesh", c->mesh, VBSS_THREAD_MESH_FIXED, VBSS_THREAD_MESH_ADAPTIVE},
        {"friction_torque", c->friction_torque, 0.0, 1.0},
        {"yield_curvature", c->yield_curvature, 0.0, 1e6},
        {"yield_hardening", c->yield_hardening, 0.0, 0.999},
        {"relaxation_ratio", c->relaxation_ratio, 0.0, 1e3},
        {"relaxation_time", c->relaxation_time, 1e-6, 1e9},
        {"torsional_stiffness", c->torsional_stiffness, 0.0, 1e3},
        {"rest_twist", c->rest_twist, -1e5, 1e5},
    };
    return check_ranges(context, ranges, sizeof ranges / sizeof ranges[0]);
}

/* A fixed mesh needs valid ranges, too. */
static vbss_result check_mesh(vbss_context *context, const vbss_thread_config *c)
{
    const double nodes = c->segment_count + 1.0;
    const range ranges[] = {
        {"coarsest_length", c->coarsest_length, 1e-7, 1e2},
        {"finest_length", c->finest_length, 1e-7, c->coarsest_length},
        {"refine_angle", c->refine_angle, 0.01, 1.0},
        {"coarsen_angle", c->coarsen_angle, 0.0, 0.5 * c->refine_angle},
        {"near_distance", c->near_distance, 0.0, 0.1},
        {"clear_distance", c->clear_distance, c->near_distance, 0.1},
        {"mesh_operations", c->mesh_operations, 0.0, 64.0},
        {"node_capacity", c->node_capacity, c->node_capacity == 0 ? 0.0 : nodes, 65537.0},
    };
    VBSS_TRY(check_ranges(context, ranges, sizeof ranges / sizeof ranges[0]));
    if (c->mesh == VBSS_THREAD_MESH_ADAPTIVE && c->method != VBSS_METHOD_IMPLICIT) {
        return vbss_fail(context, VBSS_ERROR_INCOMPATIBLE,
                         "VBSS_METHOD_VBLAST has no adaptive mesh");
    }
    return VBSS_OK;
}

static vbss_result check_memory(vbss_context *context, const vbss_thread_config *c)
{
    if (c->yield_curvature == 0.0 && c->relaxation_ratio == 0.0) {
        return VBSS_OK;
    }
    const char *other = c->method != VBSS_METHOD_IMPLICIT   ? "VBSS_METHOD_VBLAST"
                        : c->mesh != VBSS_THREAD_MESH_FIXED ? "an adaptive mesh"
                        : c->rest_curvature != 0.0          ? "a rest curvature"
                                                            : NULL;
    if (other != NULL) {
        return vbss_fail(context, VBSS_ERROR_INCOMPATIBLE,
                         "yield_curvature and relaxation_ratio do not work with %s", other);
    }
    return VBSS_OK;
}

static vbss_result check_twist(vbss_context *context, const vbss_thread_config *c)
{
    if (c->torsional_stiffness == 0.0) {
        const char *field = c->rest_twist != 0.0      ? "rest_twist"
                            : c->friction_torque != 0 ? "friction_torque"
                                                      : NULL;
        return field == NULL ? VBSS_OK
                             : vbss_fail(context, VBSS_ERROR_INCOMPATIBLE,
                                         "%s needs a torsional_stiffness above 0", field);
    }
    const char *other = c->method != VBSS_METHOD_IMPLICIT   ? "VBSS_METHOD_VBLAST"
                        : c->mesh != VBSS_THREAD_MESH_FIXED ? "an adaptive mesh"
                        : c->rest_curvature != 0.0          ? "a rest curvature"
                        : c->yield_curvature != 0.0 || c->relaxation_ratio != 0.0
                            ? "memory of bends"
                            : NULL;
    if (other != NULL) {
        return vbss_fail(context, VBSS_ERROR_INCOMPATIBLE,
                         "torsional_stiffness does not work with %s", other);
    }
    return VBSS_OK;
}

static vbss_result check_shape(vbss_context *context, const vbss_thread_config *c)
{
    VBSS_TRY(vbss_check_finite(context, c->gravity, 3, "gravity"));
    VBSS_TRY(vbss_check_range(context, vbss_max_abs(c->gravity, 3), 0.0, 1e6, "gravity"));
    if (c->positions == NULL) {
        VBSS_TRY(vbss_check_finite(context, c->start, 3, "start"));
        VBSS_TRY(vbss_check_finite(context, c->direction, 3, "direction"));
        VBSS_TRY(vbss_check_range(context, vbss_max_abs(c->start, 3), 0.0, 1e3, "start"));
        VBSS_TRY(vbss_check_range(context, vec3_norm(vec3_load(c->direction)), 1e-100, 1e100,
                                  "length of direction"));
    }
    for (uint32_t i = 0; c->rest_lengths != NULL && i < c->segment_count; i++) {
        VBSS_TRY(vbss_check_range(context, c->rest_lengths[i], 1e-7, 1e2, "a rest length"));
    }
    if (c->rest_lengths == NULL) {
        VBSS_TRY(vbss_check_range(context, c->length, 1e-6, 1e3, "length"));
        VBSS_TRY(
            vbss_check_range(context, c->length / c->segment_count, 1e-7, 1e3, "segment length"));
    }
    size_t numbers = 3u * ((size_t)c->segment_count + 1);
    for (size_t i = 0; c->positions != NULL && i < numbers; i++) {
        VBSS_TRY(vbss_check_range(context, c->positions[i], -1e3, 1e3, "a position"));
    }
    return VBSS_OK;
}

vbss_result vbss_thread_read_config(vbss_context *context, const vbss_thread_config *config,
                                    vbss_thread_config *own, vbss_baseline_config *baseline)
{
    *own = defaults;
    if (config != NULL) {
        VBSS_TRY(vbss_config_read(context, &config_layout, config, own));
    }
    VBSS_TRY(vbss_baseline_read_config(context, &own->baseline, baseline));
    VBSS_TRY(check_choices(context, own));
    VBSS_TRY(check_mesh(context, own));
    VBSS_TRY(check_memory(context, own));
    VBSS_TRY(check_twist(context, own));
    return check_shape(context, own);
}

/* ---- memory: the table of arrays */

enum { ARRAY_COUNT = 29 };

static size_t list_arrays(thread_object *t, vbss_array arrays[ARRAY_COUNT])
{
    size_t n = t->node_capacity;
    const vbss_array all[] = {
        {&t->rest, n, sizeof *t->rest},
        {&t->now.x, n, sizeof(vec3)},
        {&t->now.v, n, sizeof(vec3)},
        {&t->now.a, n, sizeof(vec3)},
        {&t->now.q, n, sizeof(vec3)},
        {&t->now.tension, n, sizeof(double)},
        {&t->saved.x, n, sizeof(vec3)},
        {&t->saved.v, n, sizeof(vec3)},
        {&t->saved.a, n, sizeof(vec3)},
        {&t->saved.q, n, sizeof(vec3)},
        {&t->saved.tension, n, sizeof(double)},
        {&t->attachments, t->config.attachment_capacity, sizeof *t->attachments},
        {&t->prescribed_by, n, sizeof *t->prescribed_by},
        {&t->welded, n, sizeof *t->welded},
        {&t->mass, n, sizeof *t->mass},
        {&t->inverse_rest, n, sizeof *t->inverse_rest},
        {&t->rest_arc_length, n, sizeof *t->rest_arc_length},
        {&t->sections, n, sizeof *t->sections},
        {&t->trial, n, sizeof(vec3)},
        {&t->trial_tension, n, sizeof(double)},
        {&t->lengths, n, sizeof *t->lengths},
        {&t->sagittas, n, sizeof *t->sagittas},
        {&t->curvatures, n, sizeof(vec3)},
        {&t->x_predicted, n, sizeof(vec3)},
        {&t->v_predicted, n, sizeof(vec3)},
        {&t->a_predicted, n, sizeof(vec3)},
        {&t->strains, n, sizeof *t->strains},
        {&t->clamps, t->config.attachment_capacity, sizeof *t->clamps},
    };
    _Static_assert(sizeof all <= ARRAY_COUNT * sizeof(vbss_array), "the table is long enough");
    memcpy(arrays, all, sizeof all);
    return sizeof all / sizeof all[0];
}

vbss_result vbss_thread_allocate(vbss_context *context, const vbss_thread_config *config,
                                 uint32_t node_capacity, thread_object **thread)
{
    *thread = NULL;
    thread_object *t = vbss_allocate(context, 1, sizeof *t, "thread");
    if (t == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    t->method =
        config->method == VBSS_METHOD_VBLAST ? &vbss_baseline_thread : &vbss_thread_implicit;
    t->context = context;
    t->config = *config;
    t->config.rest_lengths = t->config.positions = NULL;
    t->baseline_config = *config->baseline;
    t->config.baseline = &t->baseline_config;
    t->node_capacity = node_capacity;
    t->gravity = vec3_load(config->gravity);
    vbss_array arrays[ARRAY_COUNT];
    size_t count = list_arrays(t, arrays);
    vbss_result result = vbss_allocate_arrays(context, arrays, count, "thread");
    if (result == VBSS_OK) {
        result = t->method->create_thread(t);
    }
    if (result != VBSS_OK) {
        vbss_thread_free(context, t);
        return result;
    }
    *thread = t;
    return VBSS_OK;
}

static void free_thread(vbss_context *context, thread_object *t)
{
    vbss_array arrays[ARRAY_COUNT];
    size_t count = list_arrays(t, arrays);
    vbss_release_arrays(context, arrays, count);
    t->method->destroy_thread(context, t);
    vbss_release(context, t, 1, sizeof *t);
}

void vbss_thread_release_piece_pool(vbss_context *context, thread_piece_pool *pool)
{
    if (pool == NULL || --pool->reference_count > 0) {
        return;
    }
    for (uint32_t i = 0; pool->pieces != NULL && i < pool->available; i++) {
        if (pool->pieces[i] != NULL) {
            free_thread(context, pool->pieces[i]);
        }
    }
    vbss_release(context, pool->pieces, pool->capacity, sizeof *pool->pieces);
    vbss_release(context, pool->slots, pool->capacity, sizeof(vbss_slot *));
    vbss_release(context, pool, 1, sizeof *pool);
}

void vbss_thread_free(vbss_context *context, void *object)
{
    thread_object *t = object;
    vbss_thread_release_piece_pool(context, t->piece_pool);
    free_thread(context, t);
}
