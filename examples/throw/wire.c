#include "throw/wire.h"

#include <string.h>

/* ---- made */

/* What the device sees of the hand. */
static void measure(void *user, double time, vbss_device_sample *s)
{
    const hand *h = user;
    (void)time; /* of the last sample, which is now */
    s->valid = VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_ORIENTATION | VBSS_DEVICE_HAS_JAW |
               VBSS_DEVICE_HAS_TOOL;
    v_store(s->position, mirror_vec(h->rig->mirrored, h->shown));
    mirror_tool(h->rig->mirrored, h->shown_orientation, s->orientation);
    s->jaw = h->opening;
    s->tool = h->tool;
}

static vbss_result make_device(hand *h)
{
    vbss_device_adapter adapter;
    vbss_device_config c;
    vbss_mock_config m;
    TRY(vbss_mock_config_init(&m, sizeof m));
    m.measure = measure;
    m.user = h;
    m.row_capacity = 0;
    TRY(vbss_mock_create(h->rig->context, &m, &h->mock));
    TRY(vbss_device_adapter_init(&adapter, sizeof adapter));
    TRY(vbss_mock_get_adapter(h->mock, &adapter));
    TRY(vbss_device_config_init(&c, sizeof c));
    c.clock = VBSS_DEVICE_CLOCK_SHARED;
    return vbss_device_create(h->rig->context, &adapter, NULL, &c, &h->device);
}

vbss_result wire_create(hand *h)
{
    const bool mirrored = h->rig->mirrored;
    vbss_grasper_config shape = h->shape;
    double position[3], orientation[4];
    v_store(shape.trocar, mirror_vec(mirrored, v_load(h->shape.trocar)));
    v_store(position, mirror_vec(mirrored, h->shown));
    mirror_tool(mirrored, h->shown_orientation, orientation);
    TRY(vbss_grasper_create(h->rig->context, &shape, &h->grasper));
    TRY(vbss_grasper_set_target(h->grasper, position, orientation));
    TRY(vbss_grasper_set_opening(h->grasper, h->opening));
    TRY(vbss_scene_add_grasper(h->rig->scene, h->grasper, &h->body));
    return make_device(h);
}

/* ---- out of the hand */

vbss_result wire_report(hand *h)
{
    vbss_device_input in;
    if (h->rig->host != NULL) {
        return VBSS_OK;
    }
    TRY(vbss_device_read(h->device, h->time, &in, sizeof in));
    TRY(vbss_grasper_set_target(h->grasper, in.position, in.orientation));
    TRY(vbss_grasper_set_opening(h->grasper, in.jaw));
    return (in.events & VBSS_DEVICE_EVENT_TOOL) != 0
               ? vbss_grasper_exchange(h->grasper, in.tool == VBSS_DEVICE_TOOL_SHEARS
                                                       ? VBSS_GRASPER_KIND_SHEARS
                                                       : VBSS_GRASPER_KIND_NEEDLE_DRIVER)
               : VBSS_OK;
}

/* ---- back to it */

vbss_result wire_feel(hand *h, const vbss_grasper_state *state)
{
    vbss_output_command command;
    if (h->rig->host != NULL) {
        return VBSS_OK;
    }
    TRY(vbss_output_command_init(&command, sizeof command));
    memcpy(command.force, state->hand_force, sizeof command.force);
    return vbss_device_write(h->device, h->time, &command, NULL, 0);
}
