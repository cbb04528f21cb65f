/* The configuration of a grasper as fields, for descriptions of scenes. */
#include "base/baseline_fields.h"
#include "base/config.h"
#include "grasper/grasper.h"

_Static_assert(sizeof(vbss_grasper_config) ==
                   VBSS_SIZE_WITH_POINTERS(vbss_grasper_config, 304u, 1u),
               "new fields must be listed, with a new version");

typedef struct values {
    vbss_grasper_config config;
    vbss_baseline_config baseline;
} values;

#define WORD(name) VBSS_WORD(values, config.name)
#define NUMBER(name) VBSS_NUMBER(values, config.name)
#define BASELINE_WORD(name) VBSS_WORD(values, baseline.name)
#define BASELINE_NUMBER(name) VBSS_NUMBER(values, baseline.name)

static const vbss_field fields[] = {
    WORD(method),
    WORD(kind),
    WORD(has_trocar),
    VBSS_NUMBERS(values, config.trocar, 3),
    NUMBER(driver_length),
    NUMBER(driver_radius),
    NUMBER(driver_bend),
    NUMBER(driver_opening),
    NUMBER(shears_length),
    NUMBER(shears_radius),
    NUMBER(shears_bend),
    NUMBER(shears_opening),
    NUMBER(driver_neck),
    NUMBER(shears_neck),
    NUMBER(neck_radius),
    NUMBER(shaft_length),
    NUMBER(shaft_radius),
    NUMBER(friction),
    NUMBER(closing_force),
    NUMBER(closing_angle),
    NUMBER(jaw_speed),
    NUMBER(grip_friction),
    NUMBER(grip_length),
    NUMBER(grip_stiffness),
    NUMBER(mass),
    NUMBER(stiffness),
    NUMBER(damping),
    NUMBER(turning_stiffness),
    NUMBER(turning_damping),
    VBSS_NUMBERS(values, config.exchange_centre, 3),
    NUMBER(exchange_distance),
    BASELINE_NUMBER(grasper_stiffness),
    BASELINE_NUMBER(grasper_distance),
    NUMBER(needle_stiffness),
    NUMBER(needle_turning_stiffness),
    NUMBER(needle_torque),
    NUMBER(solenoid_opening),
};

void vbss_grasper_visit_config(vbss_stream *stream, vbss_grasper_config *config,
                               vbss_baseline_config *baseline)
{
    static const vbss_baseline_fields table = {fields, sizeof fields / sizeof fields[0],
                                               offsetof(values, baseline),
                                               VBSS_CODE('G', 'C', 'F', 'G')};
    vbss_baseline_visit_config(stream, &table, config, baseline);
    config->baseline = baseline;
}
