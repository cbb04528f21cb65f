/* The configuration of a drain as fields, for descriptions of scenes. */
#include "base/baseline_fields.h"
#include "base/config.h"
#include "drain/drain.h"

_Static_assert(sizeof(vbss_drain_config) ==
                   VBSS_SIZE_WITH_SPLIT_POINTERS(vbss_drain_config, 280u) + sizeof(double),
               "new fields must be listed, with a new version");

typedef struct values {
    vbss_drain_config config;
    vbss_baseline_config baseline;
} values;

#define WORD(name) VBSS_WORD(values, config.name)
#define NUMBER(name) VBSS_NUMBER(values, config.name)
#define BASELINE_WORD(name) VBSS_WORD(values, baseline.name)
#define BASELINE_NUMBER(name) VBSS_NUMBER(values, baseline.name)

static const vbss_field fields[] = {
    WORD(method),
    WORD(mesh),
    WORD(mesh_divisions),
    WORD(attachment_capacity),
    WORD(iteration_limit),
    WORD(halving_limit),
    NUMBER(radius),
    NUMBER(length),
    NUMBER(thickness),
    NUMBER(slit_length),
    NUMBER(slit_opening),
    NUMBER(mark_arc),
    NUMBER(young_modulus),
    NUMBER(poisson_ratio),
    NUMBER(density),
    NUMBER(drag),
    VBSS_NUMBERS(values, config.gravity, 3),
    VBSS_NUMBERS(values, config.position, 3),
    VBSS_NUMBERS(values, config.orientation, 4),
    NUMBER(tear_stress),
    NUMBER(position_tolerance),
    NUMBER(move_limit),
    BASELINE_NUMBER(drain_stiffness),
    BASELINE_NUMBER(drain_damping),
    BASELINE_WORD(drain_substeps),
    NUMBER(friction),
    NUMBER(puncture_force),
    NUMBER(hole_force),
    NUMBER(hole_friction),
    NUMBER(hole_stiffness),
    NUMBER(hole_damping),
    NUMBER(tip_length),
    NUMBER(thread_force),
    VBSS_NUMBERS_SINCE(values, config.tear_energy, 1, 2),
};

void vbss_drain_visit_config(vbss_stream *stream, vbss_drain_config *config,
                             vbss_baseline_config *baseline)
{
    static const vbss_baseline_fields table = {fields, sizeof fields / sizeof fields[0],
                                               offsetof(values, baseline),
                                               VBSS_CODE('D', 'C', 'F', 'G'), 2};
    config->tear_energy = stream->mode == VBSS_STREAM_READ ? 0.0 : config->tear_energy;
    vbss_baseline_visit_config(stream, &table, config, baseline);
    config->baseline = baseline;
}
