/* The configuration of a scene as fields, for descriptions of scenes and for logs. */
#include "base/config.h"
#include "base/fields.h"
#include "scene/snapshot/snapshot.h"
#include "scene/tuning.h"
#include "scene/world/world.h"

#include <string.h>

_Static_assert(sizeof(vbss_scene_config) == VBSS_SIZE_WITH_POINTERS(vbss_scene_config, 136u, 2u) &&
                   sizeof(vbss_solver_options) == 72,
               "new fields must be listed, with a new version");

typedef struct values {
    vbss_scene_config config;
    vbss_baseline_config baseline;
    vbss_solver_options solver;
    /* The budgets in operations. Older versions have only these, and they decide whether scenes accept
     * each other's states. */
    struct values_operations {
        uint32_t step_budget, call_budget;
    } operations;
} values;

#define WORD(name, since) VBSS_WORD_SINCE(values, config.name, since)
#define NUMBER(name) VBSS_NUMBER(values, config.name)
#define BUDGET(name) VBSS_NUMBERS_SINCE(values, solver.name, 1, 8)

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
    VBSS_NUMBER(values, solver.contact_margin),
    VBSS_NUMBER(values, solver.stretch_tolerance),
    VBSS_NUMBER(values, solver.penetration_tolerance),
    VBSS_WORD(values, solver.iteration_limit),
    VBSS_WORD(values, solver.active_set_limit),
    VBSS_WORD(values, solver.halving_limit),
    VBSS_WORD(values, solver.attempt_limit),
    VBSS_WORD(values, baseline.scene_pass_limit),
    VBSS_NUMBER(values, baseline.scene_thickness),
    WORD(grasp_capacity, 2),
    VBSS_WORD_SINCE(values, operations.step_budget, 3),
    WORD(drain_capacity, 4),
    WORD(hole_capacity, 4),
    VBSS_WORD_SINCE(values, operations.call_budget, 5),
    VBSS_NUMBERS_SINCE(values, config.speed_limit, 1, 6),
    WORD(overlap, 7),
    WORD(matrix_capacity, 7),
    BUDGET(step_budget_us),
    BUDGET(call_budget_us),
    BUDGET(operations_per_us),
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

/* Whether a field may differ between scenes that accept each other's states: it sizes memory,
 * applies to bodies that are added, or counts only through the budgets in operations. Pins, grasps and holes are part of the state. */
static bool may_differ(const vbss_field *field)
{
    static const size_t offsets[] = {
        offsetof(values, config.thread_capacity),   offsetof(values, config.node_capacity),
        offsetof(values, config.rigid_capacity),    offsetof(values, config.capsule_capacity),
        offsetof(values, config.contact_capacity),  offsetof(values, config.candidate_capacity),
        offsetof(values, config.event_capacity),    offsetof(values, config.drain_capacity),
        offsetof(values, config.overlap),           offsetof(values, config.matrix_capacity),
        offsetof(values, solver.step_budget_us),    offsetof(values, solver.call_budget_us),
        offsetof(values, solver.operations_per_us),
    };
    bool found = false;
    for (size_t i = 0; i < sizeof offsets / sizeof offsets[0]; i++) {
        found = found || offsets[i] == field->offset;
    }
    return found;
}

/* Scenes of older versions had no graspers (1), no limit of work (2), no drains and holes (3), no
 * limit of calls (4), and no limit of speed (5). */
static void set_missing_fields(values *v, uint32_t version)
{
    vbss_scene_config *config = &v->config;
    config->grasp_capacity = version >= 2 ? config->grasp_capacity : 8;
    v->operations.step_budget = version >= 3 ? v->operations.step_budget : 0;
    config->drain_capacity = version >= 4 ? config->drain_capacity : 1;
    config->hole_capacity = version >= 4 ? config->hole_capacity : 16;
    v->operations.call_budget = version >= 5 ? v->operations.call_budget : 0;
    config->speed_limit = version >= 6 ? config->speed_limit : 0.0;
    config->overlap = version >= 7 ? config->overlap : VBSS_SCENE_OVERLAP_WARN;
    config->matrix_capacity = version >= 7 ? config->matrix_capacity : 0;
}

static values values_of(const vbss_scene_config *config, const vbss_baseline_config *baseline,
                        const vbss_solver_options *solver)
{
    const double speed = solver->operations_per_us;
    return (values){
        .config = *config,
        .baseline = *baseline,
        .solver = *solver,
        .operations = {(uint32_t)vbss_scene_count_operations(solver->step_budget_us, speed),
                       (uint32_t)vbss_scene_count_operations(solver->call_budget_us, speed)}};
}

/* Older versions have budgets in operations: the same ones at the default speed. */
static void set_microseconds(vbss_solver_options *solver, struct values_operations operations)
{
    solver->operations_per_us = SCENE_DEFAULT_OPERATIONS_PER_US;
    solver->step_budget_us = operations.step_budget / solver->operations_per_us;
    solver->call_budget_us = operations.call_budget / solver->operations_per_us;
}

/* Compares numbers, because damaged bytes may be any number. */
static bool are_budgets_consistent(const values *v)
{
    const double speed = v->solver.operations_per_us;
    return vbss_scene_count_operations(v->solver.step_budget_us, speed) ==
               v->operations.step_budget &&
           vbss_scene_count_operations(v->solver.call_budget_us, speed) ==
               v->operations.call_budget;
}

void vbss_scene_visit_config(vbss_stream *stream, vbss_scene_config *config,
                             vbss_baseline_config *baseline, vbss_solver_options *solver)
{
    values v = values_of(config, baseline, solver);
    vbss_section outer = vbss_stream_open(stream, VBSS_CODE('C', 'O', 'N', 'F'), 8);
    set_missing_fields(&v, stream->version);
    vbss_stream_fields(stream, fields, FIELD_COUNT, &v);
    if (stream->version < 8) {
        set_microseconds(&v.solver, v.operations);
    } else if (!are_budgets_consistent(&v)) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such budgets");
        v.solver = *solver;
    }
    vbss_stream_close(stream, outer);
    *config = v.config;
    *baseline = v.baseline;
    *solver = v.solver;
    config->baseline = baseline;
    config->solver = solver;
}

const char *vbss_scene_find_config_difference(const vbss_scene_config *a,
                                              const vbss_scene_config *b)
{
    const values of_a = values_of(a, a->baseline, a->solver);
    const values of_b = values_of(b, b->baseline, b->solver);
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
