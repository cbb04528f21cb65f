/* The configuration of a thread as fields, for descriptions of scenes. */
#include "base/baseline_fields.h"
#include "base/config.h"
#include "thread/thread.h"

_Static_assert(sizeof(vbss_thread_config) == VBSS_SIZE_WITH_POINTERS(vbss_thread_config, 304u, 3u),
               "new fields must be listed, with a new version");

typedef struct values {
    vbss_thread_config config;
    vbss_baseline_config baseline;
} values;

#define WORD(name) VBSS_WORD(values, config.name)
#define NUMBER(name) VBSS_NUMBER(values, config.name)
#define NUMBER_SINCE(name, since) VBSS_NUMBERS_SINCE(values, config.name, 1, since)
#define WORD_SINCE(name, since) VBSS_WORD_SINCE(values, config.name, since)
#define BASELINE_WORD(name) VBSS_WORD(values, baseline.name)
#define BASELINE_NUMBER(name) VBSS_NUMBER(values, baseline.name)

/* Without the initial shape, which is part of the state. */
static const vbss_field fields[] = {
    WORD(method),
    WORD(bending),
    WORD(segment_count),
    WORD(attachment_capacity),
    WORD(cut_capacity),
    NUMBER(radius),
    NUMBER(linear_density),
    NUMBER(axial_stiffness),
    NUMBER(bending_stiffness),
    NUMBER(rest_curvature),
    VBSS_NUMBERS(values, config.gravity, 3),
    NUMBER(drag),
    NUMBER(damping),
    NUMBER(spectral_radius),
    NUMBER(stretch_tolerance),
    NUMBER(position_tolerance),
    WORD(iteration_limit),
    WORD(halving_limit),
    BASELINE_NUMBER(thread_stiffness),
    BASELINE_NUMBER(thread_damping),
    BASELINE_WORD(thread_substeps),
    BASELINE_WORD(thread_iteration_limit),
    BASELINE_NUMBER(thread_tolerance),
    WORD(mesh),
    WORD(node_capacity),
    NUMBER(finest_length),
    NUMBER(coarsest_length),
    NUMBER(refine_angle),
    NUMBER(coarsen_angle),
    NUMBER(near_distance),
    NUMBER(clear_distance),
    WORD(mesh_operations),
    NUMBER_SINCE(yield_curvature, 2),
    NUMBER_SINCE(yield_hardening, 2),
    NUMBER_SINCE(relaxation_ratio, 2),
    NUMBER_SINCE(relaxation_time, 2),
    NUMBER_SINCE(torsional_stiffness, 3),
    NUMBER_SINCE(rest_twist, 3),
    WORD_SINCE(friction_torque, 4),
};

void vbss_thread_visit_config(vbss_stream *stream, vbss_thread_config *config,
                              vbss_baseline_config *baseline)
{
    static const vbss_baseline_fields table = {fields, sizeof fields / sizeof fields[0],
                                               offsetof(values, baseline),
                                               VBSS_CODE('T', 'C', 'F', 'G'), 4};
    if (stream->mode == VBSS_STREAM_READ) {
        config->relaxation_time = 1.0; /* the default, in descriptions of version 1 */
    }
    vbss_baseline_visit_config(stream, &table, config, baseline);
    config->baseline = baseline;
}
