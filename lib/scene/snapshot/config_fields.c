/* The configuration of a scene as fields, for descriptions of scenes and for logs. */
#include "base/config.h"
#include "base/fields.h"
#include "scene/snapshot/snapshot.h"

#include <string.h>

_Static_assert(sizeof(vbss_scene_config) == VBSS_SIZE_WITH_POINTERS(vbss_scene_config, 184u, 1u),
               "new fields must be listed, with a new version");

typedef struct values {
    vbss_scene_config config;
    vbss_baseline_config baseline;
} values;

#define WORD(name, since) VBSS_WORD_SINCE(values, config.name, since)
#define NUMBER(name) VBSS_NUMBER(values, config.name)

static const vbss_field fields[] = {
    WORD(method, 1),
    WORD(mode, 1),
    WORD(thread_capacity, 1),
    WORD(node_capacity, 1),
    WORD(rigid_capacity, 1),
    WORD(capsule_capacity, 1),
    WORD(pin_capacity, 1),
    WORD(contact_capacity, 1),
    WORD(candidate_capacity, 1),
    WORD(event_capacity, 1),
    WORD(floor, 1),
    VBSS_NUMBERS(values, config.floor_normal, 3),
    NUMBER(floor_height),
    NUMBER(floor_friction),
    NUMBER(thread_friction),
    NUMBER(contact_stiffness),
    NUMBER(contact_margin),
    NUMBER(stretch_tolerance),
    NUMBER(penetration_tolerance),
    WORD(iteration_limit, 1),
    WORD(active_set_limit, 1),
    WORD(halving_limit, 1),
    WORD(attempt_limit, 1),
    VBSS_WORD(values, baseline.scene_pass_limit),
    VBSS_NUMBER(values, baseline.scene_thickness),
    WORD(grasp_capacity, 2),
    WORD(step_budget, 3),
    WORD(drain_capacity, 4),
    WORD(hole_capacity, 4),
    WORD(call_budget, 5),
    VBSS_NUMBERS_SINCE(values, config.speed_limit, 1, 6),
    WORD(overlap, 7),
    WORD(matrix_capacity, 7),
};
enum { FIELD_COUNT = sizeof fields / sizeof fields[0] };

/* The name without the member of `values` that has the field. */
static const char *name_of(const vbss_field *field)
{
    const char *name = field->name;
    while (*name++ != '.') {
    }
    return name;
}

/* Whether a field may differ between scenes that accept each other's states: it sizes memory, or
 * applies to bodies that are added. Pins, grasps and holes are part of the state. */
static bool may_differ(const vbss_field *field)
{
    static const size_t offsets[] = {
        offsetof(values, config.thread_capacity),  offsetof(values, config.node_capacity),
        offsetof(values, config.rigid_capacity),   offsetof(values, config.capsule_capacity),
        offsetof(values, config.contact_capacity), offsetof(values, config.candidate_capacity),
        offsetof(values, config.event_capacity),   offsetof(values, config.drain_capacity),
        offsetof(values, config.overlap),          offsetof(values, config.matrix_capacity),
    };
    bool found = false;
    for (size_t i = 0; i < sizeof offsets / sizeof offsets[0]; i++) {
        found = found || offsets[i] == field->offset;
    }
    return found;
}

/* Scenes of older versions had no graspers (1), no limit of work (2), no drains and holes (3), no
 * limit of calls (4), and no limit of speed (5). */
static void set_missing_fields(vbss_scene_config *config, uint32_t version)
{
    config->grasp_capacity = version >= 2 ? config->grasp_capacity : 8;
    config->step_budget = version >= 3 ? config->step_budget : 0;
    config->drain_capacity = version >= 4 ? config->drain_capacity : 1;
    config->hole_capacity = version >= 4 ? config->hole_capacity : 16;
    config->call_budget = version >= 5 ? config->call_budget : 0;
    config->speed_limit = version >= 6 ? config->speed_limit : 0.0;
    config->overlap = version >= 7 ? config->overlap : VBSS_SCENE_OVERLAP_WARN;
    config->matrix_capacity = version >= 7 ? config->matrix_capacity : 0;
}

void vbss_scene_visit_config(vbss_stream *stream, vbss_scene_config *config,
                             vbss_baseline_config *baseline)
{
    values v = {*config, *baseline};
    vbss_section outer = vbss_stream_open(stream, VBSS_CODE('C', 'O', 'N', 'F'), 7);
    set_missing_fields(&v.config, stream->version);
    vbss_stream_fields(stream, fields, FIELD_COUNT, &v);
    vbss_stream_close(stream, outer);
    *config = v.config;
    *baseline = v.baseline;
    config->baseline = baseline;
}

const char *vbss_scene_find_config_difference(const vbss_scene_config *a,
                                              const vbss_scene_config *b)
{
    const values of_a = {*a, *a->baseline}, of_b = {*b, *b->baseline};
    for (size_t i = 0; i < FIELD_COUNT; i++) {
        const char *value_a = (const char *)&of_a + fields[i].offset;
        const char *value_b = (const char *)&of_b + fields[i].offset;
        size_t size = fields[i].type == VBSS_FIELD_U32 ? sizeof(uint32_t) : sizeof(double);
        if (!may_differ(&fields[i]) && memcmp(value_a, value_b, size * fields[i].count) != 0) {
            return name_of(&fields[i]);
        }
    }
    return NULL;
}
