/* Input and output of devices: hands move the tools before the step, and feel forces after it. */
#include "base/error.h"
#include "device/device.h"
#include "session/session.h"
#include "session/tuning.h"

_Static_assert((int)VBSS_DEVICE_TOOL_NEEDLE_DRIVER == (int)VBSS_GRASPER_KIND_NEEDLE_DRIVER &&
                   (int)VBSS_DEVICE_TOOL_SHEARS == (int)VBSS_GRASPER_KIND_SHEARS,
               "tools of devices and of scenes have the same numbers");

static vbss_grasper *tool_of_hand(const session_object *s, uint32_t hand)
{
    return vbss_scene_inspect_body(s->scene, s->config.tools[hand]).grasper;
}

static vbss_result move_tool(const session_object *s, uint32_t hand, const vbss_device_input *input)
{
    const double *orientation =
        (input->valid & (uint32_t)VBSS_DEVICE_HAS_ORIENTATION) != 0 ? input->orientation : NULL;
    return (input->valid & (uint32_t)VBSS_DEVICE_HAS_POSITION) != 0
               ? vbss_grasper_set_target(tool_of_hand(s, hand), input->position, orientation)
               : VBSS_OK;
}

static vbss_result set_tool_opening(const session_object *s, uint32_t hand,
                                    const vbss_device_input *input)
{
    uint32_t jaw_signals = (uint32_t)(VBSS_DEVICE_HAS_JAW | VBSS_DEVICE_HAS_JAW_RAW);
    return (input->valid & jaw_signals) != 0
               ? vbss_grasper_set_opening(tool_of_hand(s, hand), input->jaw)
               : VBSS_OK;
}

/* Exchanges the tool if the hand has taken another one. An exchange that failed is retried. */
static vbss_result exchange_tool(const session_object *s, uint32_t hand,
                                 const vbss_device_input *input)
{
    vbss_grasper *grasper = tool_of_hand(s, hand);
    vbss_grasper_state state;
    bool is_due = (input->events & (uint32_t)VBSS_DEVICE_EVENT_TOOL) != 0 ||
                  s->steps % SESSION_EXCHANGE_RETRY_STEPS == 0;
    if (!is_due || input->tool == VBSS_DEVICE_TOOL_NONE) {
        return VBSS_OK;
    }
    VBSS_TRY(vbss_grasper_get_state(grasper, &state, sizeof state));
    return state.kind == input->tool ? VBSS_OK : vbss_grasper_exchange(grasper, input->tool);
}

static bool has_device(const session_object *s, uint32_t hand)
{
    return s->config.devices[hand] != NULL && s->config.replay == NULL &&
           tool_of_hand(s, hand) != NULL;
}

/* The jaws of a session that begins or was restored stay as they are until the handle has passed
 * them. */
static vbss_result hold_jaws(const session_object *s, uint32_t hand)
{
    device_object *d;
    vbss_grasper_state state;
    VBSS_TRY(vbss_device_open(s->config.devices[hand], &d));
    if (!s->takes_over || d->config.jaw_takeover == 0) {
        return VBSS_OK;
    }
    VBSS_TRY(vbss_grasper_get_state(tool_of_hand(s, hand), &state, sizeof state));
    return vbss_device_hold_jaw(s->config.devices[hand], state.opening);
}

/* ---- assistance */

static vbss_result apply_input(const session_object *s, uint32_t hand, const session_input *input)
{
    double position[3], orientation[4];
    pose_store(input->pose, position, orientation);
    VBSS_TRY(vbss_grasper_set_target(tool_of_hand(s, hand), position, orientation));
    return vbss_grasper_set_opening(tool_of_hand(s, hand), input->opening);
}

/* What a device does not report stays as it is. */
static vbss_result assist_device(session_object *s, uint32_t hand, double h,
                                 const vbss_device_input *device)
{
    vbss_grasper_state state;
    VBSS_TRY(vbss_grasper_get_state(tool_of_hand(s, hand), &state, sizeof state));
    uint32_t jaw_signals = (uint32_t)(VBSS_DEVICE_HAS_JAW | VBSS_DEVICE_HAS_JAW_RAW);
    bool has_position = (device->valid & (uint32_t)VBSS_DEVICE_HAS_POSITION) != 0;
    bool is_turned = (device->valid & (uint32_t)VBSS_DEVICE_HAS_ORIENTATION) != 0;
    const double *q = is_turned ? device->orientation : state.target_orientation;
    session_input input = {
        pose_make(vec3_load(has_position ? device->position : state.target_position),
                  quat_unit(quat_make(q[0], q[1], q[2], q[3]))),
        (device->valid & jaw_signals) != 0 ? device->jaw : state.opening};
    vbss_session_assist(s, hand, h, &input);
    return apply_input(s, hand, &input);
}

static vbss_result follow_host(session_object *s, uint32_t hand, double h)
{
    session_input input = s->given[hand].input;
    if (!s->given[hand].is_given || s->config.replay != NULL || tool_of_hand(s, hand) == NULL) {
        return VBSS_OK;
    }
    s->given[hand].is_given = false;
    if (vbss_session_is_hand_assisted(s, hand)) {
        vbss_session_assist(s, hand, h, &input);
    }
    return apply_input(s, hand, &input);
}

static vbss_result follow_device(session_object *s, uint32_t hand, double h,
                                 const vbss_device_input *input)
{
    if (input->status == VBSS_DEVICE_STATUS_WAITING) {
        return VBSS_OK;
    }
    if (vbss_session_is_hand_assisted(s, hand)) {
        VBSS_TRY(assist_device(s, hand, h, input));
    } else {
        VBSS_TRY(move_tool(s, hand, input));
        VBSS_TRY(set_tool_opening(s, hand, input));
    }
    return exchange_tool(s, hand, input);
}

/* ---- all hands */

/* Reads all devices even if one fails: a device whose clock is wrong switches its outputs off. */
vbss_result vbss_session_read_hands(session_object *s, double now, double h)
{
    vbss_device_input inputs[SESSION_HANDS] = {{.struct_size = 0}};
    vbss_result result = VBSS_OK;
    for (uint32_t i = 0; i < SESSION_HANDS; i++) {
        if (has_device(s, i)) {
            vbss_result read = hold_jaws(s, i);
            read = read == VBSS_OK
                       ? vbss_device_read(s->config.devices[i], now, &inputs[i], sizeof inputs[i])
                       : read;
            result = result == VBSS_OK ? read : result;
        }
    }
    VBSS_TRY(result);
    VBSS_TRY(vbss_session_attach_record(s));
    s->takes_over = false;
    for (uint32_t i = 0; i < SESSION_HANDS; i++) {
        VBSS_TRY(has_device(s, i) ? follow_device(s, i, h, &inputs[i]) : follow_host(s, i, h));
    }
    return VBSS_OK;
}

vbss_result vbss_session_write_devices(const session_object *s, double now)
{
    for (uint32_t i = 0; i < SESSION_HANDS; i++) {
        vbss_output_command command;
        if (!has_device(s, i)) {
            continue;
        }
        vbss_grasper_state state;
        VBSS_TRY(vbss_grasper_get_state(tool_of_hand(s, i), &state, sizeof state));
        VBSS_TRY(vbss_output_command_init(&command, sizeof command));
        vec3_store(command.force, vec3_load(state.hand_force));
        vec3_store(command.torque, vec3_load(state.hand_torque));
        command.solenoid = state.solenoid;
        VBSS_TRY(vbss_device_write(s->config.devices[i], now, &command, NULL,
                                   sizeof(vbss_output_result)));
    }
    return VBSS_OK;
}
