/* Creation, commands and queries of graspers. */
#include "grasper/grasper.h"

#include "base/api_call.h"
#include "base/check.h"
#include "base/config.h"
#include "base/edit_hook.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/stream.h"

_Static_assert(sizeof(vbss_grasper_state) == 264, "published size");

static const uint32_t state_sizes[] = {248, 264, 0};
static const vbss_layout state_layout = {"vbss_grasper_state", NULL, state_sizes};

/* ---- creation and destruction */

static void free_grasper(vbss_context *context, void *object)
{
    vbss_release(context, object, 1, sizeof(grasper_object));
}

const vbss_kind vbss_grasper_kind_of_slot = {"grasper",    VBSS_CODE('G', 'R', 'S', 'P'), 2,
                                             free_grasper, vbss_grasper_serialise,        NULL};

/* Target pose of the tool. Falls back to the commanded pose if no shaft through the trocar can
 * reach it. */
static pose target_pose(const grasper_object *g)
{
    pose target = g->commanded_pose;
    return vbss_grasper_apply_trocar(g, g->commanded_pose, &target) ? target : g->commanded_pose;
}

/* Outside a scene the tool moves to its target at once. */
static void move_to_target(grasper_object *g)
{
    if (g->body_id == 0) {
        g->tool_pose = target_pose(g);
        vbss_grasper_update_view(g);
    }
    g->generation++;
}

void vbss_grasper_detach(grasper_object *g)
{
    g->body_id = g->grasp_count = g->needle = g->drain = g->solenoid = 0;
    g->jaw_force = 0.0;
    g->velocity = g->angular_velocity = g->hand_force = g->hand_torque = vec3_zero();
    move_to_target(g);
}

static void init_grasper(grasper_object *g, const vbss_grasper_config *c)
{
    const grasper_jaws driver = {c->driver_length, c->driver_radius, c->driver_bend,
                                 c->driver_opening, c->driver_neck};
    const grasper_jaws shears = {c->shears_length, c->shears_radius, c->shears_bend,
                                 c->shears_opening, c->shears_neck};
    g->config = *c;
    g->baseline_config = *c->baseline;
    g->config.baseline = &g->baseline_config;
    g->driver = driver;
    g->shears = shears;
    g->kind = g->commanded_kind = c->kind;
    g->commanded_pose = pose_identity();
    g->opening = 1.0;
    g->jaw_angle = vbss_grasper_current_jaws(g)->opening;
    move_to_target(g);
}

vbss_result vbss_grasper_create(vbss_context *context, const vbss_grasper_config *config,
                                vbss_grasper **grasper)
{
    VBSS_ENTER_WITH_RESULT(context, grasper);
    if (grasper == NULL) {
        VBSS_TRY(vbss_context_open(context));
        return vbss_check_pointer(context, grasper, "grasper");
    }
    VBSS_TRY(vbss_context_open(context));
    VBSS_TRY(vbss_context_edit(context));
    vbss_grasper_config own;
    vbss_baseline_config baseline;
    VBSS_TRY(vbss_grasper_read_config(context, config, &own, &baseline));
    grasper_object *g = vbss_allocate(context, 1, sizeof *g, "grasper");
    if (g == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    vbss_slot *slot;
    vbss_result result = vbss_slot_create(context, &vbss_grasper_kind_of_slot, g, &slot);
    if (result != VBSS_OK) {
        free_grasper(context, g);
        return result;
    }
    g->context = context;
    init_grasper(g, &own);
    *grasper = (vbss_grasper *)slot;
    return VBSS_OK;
}

vbss_result vbss_grasper_destroy(vbss_grasper *grasper)
{
    VBSS_ENTER(grasper);
    return vbss_slot_destroy(grasper, &vbss_grasper_kind_of_slot);
}

vbss_result vbss_grasper_discard(vbss_grasper *grasper)
{
    VBSS_ENTER(grasper);
    return vbss_slot_discard(grasper, &vbss_grasper_kind_of_slot);
}

vbss_result vbss_grasper_open(const vbss_grasper *handle, grasper_object **grasper)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(handle, &vbss_grasper_kind_of_slot, &slot));
    *grasper = slot->object;
    return VBSS_OK;
}

/* The host also commands a grasper that is in a scene, between the steps. */
static vbss_result edit(vbss_grasper *handle, grasper_object **grasper)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit(handle, &vbss_grasper_kind_of_slot, &slot));
    *grasper = slot->object;
    return VBSS_OK;
}

/* ---- commands */

vbss_result vbss_grasper_set_target(vbss_grasper *grasper, const double position[3],
                                    const double *orientation)
{
    VBSS_ENTER(grasper);
    grasper_object *g;
    VBSS_TRY(edit(grasper, &g));
    VBSS_TRY(vbss_check_pointer(g->context, position, "position"));
    VBSS_TRY(vbss_check_finite(g->context, position, 3, "position"));
    VBSS_TRY(vbss_check_range(g->context, vbss_max_abs(position, 3), 0.0, 1e3, "position"));
    pose commanded = pose_make(vec3_load(position), g->commanded_pose.orientation), target;
    if (orientation != NULL) {
        VBSS_TRY(vbss_read_orientation(g->context, orientation, &commanded.orientation));
    }
    if (!vbss_grasper_apply_trocar(g, commanded, &target)) {
        return vbss_fail(g->context, VBSS_ERROR_OUT_OF_RANGE,
                         "the tip is too near to its trocar for the shaft to go through it");
    }
    vbss_edit input = {.kind = VBSS_EDIT_GRASPER_TARGET, .words = {0, orientation != NULL}};
    vbss_edit_set_numbers(&input, 0, position, 3);
    vbss_edit_set_numbers(&input, 3, orientation, 4);
    VBSS_TRY(vbss_edit_begin(grasper, &input));
    const double jump = vec3_distance(commanded.position, g->commanded_pose.position);
    if (((const vbss_slot *)grasper)->owner != NULL && !g->has_jumped && jump > VBSS_LIKELY_JUMP) {
        g->has_jumped = true; /* a host with the wrong unit is warned once, not each step */
        vbss_warn_if_unlikely(g->context, jump, VBSS_LIKELY_JUMP, "the way to position", "m", "mm");
    }
    g->commanded_pose = commanded;
    move_to_target(g);
    return vbss_edit_end(grasper, &input, VBSS_OK);
}

vbss_result vbss_grasper_set_opening(vbss_grasper *grasper, double opening)
{
    VBSS_ENTER(grasper);
    grasper_object *g;
    VBSS_TRY(edit(grasper, &g));
    VBSS_TRY(vbss_check_range(g->context, opening, 0.0, 1.0, "opening"));
    vbss_edit input = {.kind = VBSS_EDIT_OPENING, .numbers = {opening}};
    VBSS_TRY(vbss_edit_begin(grasper, &input));
    g->opening = opening;
    g->generation++;
    return vbss_edit_end(grasper, &input, VBSS_OK);
}

vbss_result vbss_grasper_exchange(vbss_grasper *grasper, vbss_grasper_kind kind)
{
    VBSS_ENTER(grasper);
    grasper_object *g;
    VBSS_TRY(edit(grasper, &g));
    VBSS_TRY(vbss_check_range(g->context, kind, VBSS_GRASPER_KIND_NEEDLE_DRIVER,
                              VBSS_GRASPER_KIND_SHEARS, "kind"));
    vbss_edit input = {.kind = VBSS_EDIT_EXCHANGE, .words = {0, (uint32_t)kind}};
    VBSS_TRY(vbss_edit_begin(grasper, &input));
    g->commanded_kind = kind;
    g->generation++;
    return vbss_edit_end(grasper, &input, VBSS_OK);
}

/* ---- queries */

vbss_result vbss_grasper_get_state(vbss_grasper *grasper, vbss_grasper_state *state,
                                   uint32_t struct_size)
{
    VBSS_ENTER(grasper);
    grasper_object *g;
    VBSS_TRY(vbss_grasper_open(grasper, &g));
    vbss_grasper_state own = {.struct_size = sizeof own,
                              .kind = g->kind,
                              .body = g->body_id,
                              .grasp_count = g->grasp_count,
                              .opening = g->opening,
                              .jaw_angle = g->jaw_angle,
                              .pressure = g->jaw_force,
                              .needle = g->needle,
                              .drain = g->drain,
                              .solenoid = g->solenoid};
    pose_store(g->tool_pose, own.position, own.orientation);
    pose_store(target_pose(g), own.target_position, own.target_orientation);
    vec3_store(own.velocity, g->velocity);
    vec3_store(own.angular_velocity, g->angular_velocity);
    vec3_store(own.hand_force, g->hand_force);
    vec3_store(own.hand_torque, g->hand_torque);
    return vbss_struct_write(g->context, &state_layout, &own, state, struct_size);
}

vbss_result vbss_grasper_get_view(vbss_grasper *grasper, vbss_grasper_field field, vbss_view *view,
                                  uint32_t struct_size)
{
    VBSS_ENTER(grasper);
    grasper_object *g;
    VBSS_TRY(vbss_grasper_open(grasper, &g));
    if (field != VBSS_GRASPER_VIEW_CAPSULES) {
        return vbss_fail(g->context, VBSS_ERROR_OUT_OF_RANGE, "a grasper has no field %d", field);
    }
    const vbss_view own = {.type = VBSS_VIEW_TYPE_F64,
                           .components = sizeof g->view_capsules[0] / sizeof(double),
                           .stride_bytes = sizeof g->view_capsules[0],
                           .count = GRASPER_CAPSULES,
                           .data = g->view_capsules,
                           .generation = g->generation};
    return vbss_struct_write(g->context, &vbss_view_layout, &own, view, struct_size);
}
