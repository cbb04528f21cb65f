/* Public CCD of one query: configuration, argument checks, and results. */
#include "base/api_call.h"
#include "base/baseline_config.h"
#include "base/check.h"
#include "base/compiler.h"
#include "base/error.h"
#include "base/number_text.h"
#include "collision/collision.h"

#include <string.h>

_Static_assert(sizeof(vbss_collision_config) ==
                   VBSS_SIZE_WITH_POINTERS(vbss_collision_config, 56u, 1u),
               "published size");
_Static_assert(sizeof(vbss_collision_impact) == 136, "published size");

static const vbss_collision_config defaults = {
    .struct_size = sizeof(vbss_collision_config),
    .method = VBSS_COLLISION_METHOD_CONSERVATIVE,
    .tolerance = 1e-3,
    .pass_limit = 10000,
    .shape_capacity = 16,
    .pair_capacity = 16384,
    .impact_capacity = 4096,
    .exclusion = 1.6,
};
static const uint32_t config_sizes[] = {VBSS_SIZE_WITH_POINTERS(vbss_collision_config, 56u, 1u), 0};
const vbss_layout vbss_collision_config_layout = {"vbss_collision_config", &defaults, config_sizes};
static const uint32_t impact_sizes[] = {136, 0};
static const vbss_layout impact_layout = {"vbss_collision_impact", NULL, impact_sizes};

vbss_result vbss_collision_config_init(vbss_collision_config *config, uint32_t struct_size)
{
    return vbss_config_init(&vbss_collision_config_layout, config, struct_size);
}

vbss_result vbss_collision_check_thickness(vbss_context *context, double thickness)
{
    if (thickness == 0.0) {
        return VBSS_OK;
    }
    return vbss_check_range(context, thickness, COLLISION_MIN_THICKNESS, COLLISION_MAX_COORDINATE,
                            "thickness");
}

vbss_result vbss_collision_check_ccd_options(vbss_context *context, const vbss_collision_config *c)
{
    VBSS_TRY(vbss_check_range(context, c->method, VBSS_COLLISION_METHOD_CONSERVATIVE,
                              VBSS_COLLISION_METHOD_VBLAST, "method"));
    VBSS_TRY(vbss_collision_check_thickness(context, c->thickness));
    VBSS_TRY(vbss_check_range(context, c->tolerance, 1e-12, 1.0, "tolerance"));
    return vbss_check_range(context, c->pass_limit, 1.0, 1000000.0, "pass_limit");
}

static const collision_ccd_method *method_of(const vbss_collision_config *config)
{
    static const collision_ccd_method conservative = {vbss_collision_run_conservative,
                                                      VBSS_COLLISION_DECISION_PROVED, true};
    static const collision_ccd_method cubic = {vbss_collision_run_cubic,
                                               VBSS_COLLISION_DECISION_CLAIMED, false};
    return config->method == VBSS_COLLISION_METHOD_VBLAST  ? &vbss_baseline_ccd
           : config->method == VBSS_COLLISION_METHOD_CUBIC ? &cubic
                                                           : &conservative;
}

collision_ccd_options vbss_collision_ccd_options_of(const vbss_collision_config *config)
{
    collision_ccd_options options = {method_of(config),
                                     config->pass_limit,
                                     config->tolerance,
                                     config->baseline->collision_parallel,
                                     config->baseline->collision_unit,
                                     NULL,
                                     0};
    return options;
}

void vbss_collision_run_ccd(const collision_ccd_options *options, const collision_ccd_query *query,
                            collision_ccd_result *result, collision_counters *counters)
{
    *result = vbss_collision_ccd_miss(options->method->miss_decision);
    options->method->test_pair(options, query, result, counters);
    vbss_collision_count_result(counters, result);
}

vbss_result vbss_collision_check_coordinates(vbss_context *context, const double *values,
                                             size_t count, const char *name)
{
    VBSS_TRY(vbss_check_pointer(context, values, name));
    bool sound = true;
    for (size_t i = 0; i < count; i++) {
        sound &= fabs(values[i]) <= COLLISION_MAX_COORDINATE;
    }
    if (sound) {
        return VBSS_OK;
    }
    VBSS_TRY(vbss_check_finite(context, values, count, name));
    size_t i = 0;
    while (fabs(values[i]) <= COLLISION_MAX_COORDINATE) {
        i++;
    }
    return vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE, "%s[%llu] is %s, outside [-%s, %s]", name,
                     (unsigned long long)i, VBSS_NUMBER(values[i]),
                     VBSS_NUMBER(COLLISION_MAX_COORDINATE), VBSS_NUMBER(COLLISION_MAX_COORDINATE));
}

/* The point of a feature at the time of the result; its vertices are first to last. */
static vec3 point_at(const collision_ccd_query *q, const collision_ccd_result *result, int first,
                     int last)
{
    vec3 point = vec3_zero();
    for (int k = first; k <= last; k++) {
        vec3 now = vec3_lerp(q->start[k], q->end[k], result->time);
        point = vec3_add_scaled(point, result->weights[k], now);
    }
    return point;
}

vbss_result vbss_collision_write_impact(vbss_context *context, const collision_ccd_query *query,
                                        const collision_ccd_result *result,
                                        vbss_collision_impact *impact, uint32_t struct_size)
{
    vbss_collision_impact own = {
        .struct_size = sizeof own,
        .hit = result->hit,
        .decision = result->decision,
        .passes = result->passes,
        .time = result->time,
        .distance = result->distance,
    };
    if (result->hit != 0) {
        int last_of_a = query->kind == VBSS_COLLISION_PAIR_EDGE_EDGE ? 1 : 0;
        vec3_store(own.normal, result->normal);
        memcpy(own.weights, result->weights, sizeof own.weights);
        vec3_store(own.point_a, point_at(query, result, 0, last_of_a));
        vec3_store(own.point_b, point_at(query, result, last_of_a + 1, 3));
    }
    return vbss_struct_write(context, &impact_layout, &own, impact, struct_size);
}

void vbss_collision_set_vertices(collision_ccd_query *query, const double start[12],
                                 const double end[12])
{
    for (int k = 0; k < 4; k++) {
        query->start[k] = vec3_load(start + 3 * (size_t)k);
        query->end[k] = vec3_load(end + 3 * (size_t)k);
    }
}

/* Provides the workspace of the exact predicate on the stack. Not inlined, so that no other call
 * runs with that stack. */
VBSS_NEVER_INLINE void run_on_stack(const collision_ccd_options *options,
                                    const collision_ccd_query *query, collision_ccd_result *result)
{
    uint32_t limbs[COLLISION_STACK_LIMBS];
    collision_counters counters = {0};
    collision_ccd_options own = *options;
    own.limbs = limbs;
    own.limb_count = COLLISION_STACK_LIMBS;
    vbss_collision_run_ccd(&own, query, result, &counters);
}

/* Reads the options of a test. Not inlined, so that no other call runs with the configurations on the
 * stack. Without an object there is no context that could store an error text. */
VBSS_NEVER_INLINE vbss_result read_options(const vbss_collision_config *config,
                                           collision_ccd_options *options, double *thickness)
{
    vbss_collision_config own = defaults;
    vbss_baseline_config baseline;
    if (config != NULL) {
        VBSS_TRY(vbss_config_read(NULL, &vbss_collision_config_layout, config, &own));
        VBSS_TRY(vbss_collision_check_ccd_options(NULL, &own));
    }
    VBSS_TRY(vbss_baseline_read_config(NULL, &own.baseline, &baseline));
    *options = vbss_collision_ccd_options_of(&own);
    *thickness = own.thickness;
    return VBSS_OK;
}

static vbss_result run_test(const vbss_collision_config *config, vbss_collision_pair_kind kind,
                            const double *start, const double *end, vbss_collision_impact *impact,
                            uint32_t struct_size)
{
    collision_ccd_options options;
    collision_ccd_query query = {.kind = kind};
    VBSS_TRY(read_options(config, &options, &query.thickness));
    VBSS_TRY(vbss_collision_check_coordinates(NULL, start, 12, "start"));
    VBSS_TRY(vbss_collision_check_coordinates(NULL, end, 12, "end"));
    vbss_collision_set_vertices(&query, start, end);
    collision_ccd_result result;
    run_on_stack(&options, &query, &result);
    return vbss_collision_write_impact(NULL, &query, &result, impact, struct_size);
}

vbss_result vbss_collision_test_edges(const vbss_collision_config *config, const double start[12],
                                      const double end[12], vbss_collision_impact *impact,
                                      uint32_t struct_size)
{
    VBSS_ENTER(NULL);
    return run_test(config, VBSS_COLLISION_PAIR_EDGE_EDGE, start, end, impact, struct_size);
}

vbss_result vbss_collision_test_point_triangle(const vbss_collision_config *config,
                                               const double start[12], const double end[12],
                                               vbss_collision_impact *impact, uint32_t struct_size)
{
    VBSS_ENTER(NULL);
    return run_test(config, VBSS_COLLISION_PAIR_POINT_TRIANGLE, start, end, impact, struct_size);
}
