/* Public functions that apply an input to the scene and record it. */
#include <string.h>

#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "record/record.h"

/* Applies an input while the record is attached. */
static vbss_result apply_and_record(record_object *r, uint8_t kind, const vbss_record_input *input,
                                    uint32_t *id)
{
    VBSS_TRY(vbss_record_check_ready(r));
    const vbss_edit_hook before = vbss_record_attach_hook(r);
    const vbss_result result = vbss_log_apply_input(r->scene, kind, input, id);
    vbss_record_restore_hook(r, &before);
    return result;
}

vbss_result vbss_record_step(vbss_record *record, double h)
{
    VBSS_ENTER(record);
    record_object *r;
    VBSS_TRY(vbss_record_edit(record, &r));
    VBSS_TRY(vbss_record_check_ready(r));
    const vbss_edit_hook before = vbss_record_attach_hook(r);
    const vbss_result result = vbss_scene_step(r->scene, h);
    vbss_record_restore_hook(r, &before);
    return result;
}

static vbss_result move_body(vbss_record *record, uint8_t kind, uint32_t body,
                             const double position[3], const double *orientation)
{
    record_object *r;
    VBSS_TRY(vbss_record_edit(record, &r));
    VBSS_TRY(vbss_check_pointer(r->context, position, "position"));
    vbss_record_input input = {.words = {body, orientation != NULL}};
    memcpy(input.numbers, position, 3 * sizeof(double));
    if (orientation != NULL) {
        memcpy(input.numbers + 3, orientation, 4 * sizeof(double));
    }
    return apply_and_record(r, kind, &input, NULL);
}

vbss_result vbss_record_set_rigid_target(vbss_record *record, uint32_t body,
                                         const double position[3], const double *orientation)
{
    VBSS_ENTER(record);
    return move_body(record, VBSS_RECORD_INPUT_RIGID_TARGET, body, position, orientation);
}

vbss_result vbss_record_apply_input(vbss_record *record, const vbss_record_input *input,
                                    uint32_t *id)
{
    VBSS_ENTER(record);
    record_object *r;
    VBSS_TRY(vbss_record_edit(record, &r));
    VBSS_TRY(vbss_check_pointer(r->context, input, "input"));
    VBSS_TRY(vbss_check_range(r->context, input->kind, VBSS_RECORD_INPUT_RIGID_TARGET,
                              VBSS_RECORD_INPUT_DRAIN_DETACH, "kind of the input"));
    const uint32_t numbers = vbss_log_input_shapes[input->kind].numbers;
    VBSS_TRY(vbss_check_finite(r->context, input->numbers, numbers, "numbers of the input"));
    return apply_and_record(r, (uint8_t)input->kind, input, id);
}

vbss_result vbss_record_pin_thread(vbss_record *record, uint32_t thread, uint32_t node,
                                   uint32_t body, const double *point, uint32_t *pin)
{
    VBSS_ENTER(record);
    record_object *r;
    VBSS_TRY(vbss_record_edit(record, &r));
    VBSS_TRY(vbss_check_pointer(r->context, pin, "pin"));
    vbss_record_input input = {.words = {thread, node, body, point != NULL}};
    if (point != NULL) {
        memcpy(input.numbers, point, 3 * sizeof(double));
    }
    return apply_and_record(r, VBSS_RECORD_INPUT_PIN, &input, pin);
}

vbss_result vbss_record_unpin_thread(vbss_record *record, uint32_t pin)
{
    VBSS_ENTER(record);
    record_object *r;
    VBSS_TRY(vbss_record_edit(record, &r));
    const vbss_record_input input = {.words = {pin}};
    return apply_and_record(r, VBSS_RECORD_INPUT_UNPIN, &input, NULL);
}

vbss_result vbss_record_cut_thread(vbss_record *record, uint32_t thread, double arc_length,
                                   uint32_t *piece)
{
    VBSS_ENTER(record);
    record_object *r;
    VBSS_TRY(vbss_record_edit(record, &r));
    VBSS_TRY(vbss_check_pointer(r->context, piece, "piece"));
    const vbss_record_input input = {.words = {thread}, .numbers = {arc_length}};
    return apply_and_record(r, VBSS_RECORD_INPUT_CUT, &input, piece);
}

vbss_result vbss_record_attach(vbss_record *record, uint32_t thread,
                               const vbss_thread_attachment *attachment, uint32_t *id)
{
    VBSS_ENTER(record);
    record_object *r;
    vbss_thread *handle;
    VBSS_TRY(vbss_record_edit(record, &r));
    VBSS_TRY(vbss_record_check_ready(r));
    VBSS_TRY(vbss_scene_get_thread(r->scene, thread, &handle));
    const vbss_edit_hook before = vbss_record_attach_hook(r);
    const vbss_result result = vbss_thread_attach(handle, attachment, id);
    vbss_record_restore_hook(r, &before);
    return result;
}

vbss_result vbss_record_set_attachment_target(vbss_record *record, uint32_t thread, uint32_t id,
                                              const double target[3], const double *direction)
{
    VBSS_ENTER(record);
    record_object *r;
    VBSS_TRY(vbss_record_edit(record, &r));
    VBSS_TRY(vbss_check_pointer(r->context, target, "target"));
    vbss_record_input input = {.words = {thread, id, direction != NULL}};
    memcpy(input.numbers, target, 3 * sizeof(double));
    if (direction != NULL) {
        memcpy(input.numbers + 3, direction, 3 * sizeof(double));
    }
    return apply_and_record(r, VBSS_RECORD_INPUT_ATTACHMENT_TARGET, &input, NULL);
}

vbss_result vbss_record_detach(vbss_record *record, uint32_t thread, uint32_t id)
{
    VBSS_ENTER(record);
    record_object *r;
    VBSS_TRY(vbss_record_edit(record, &r));
    const vbss_record_input input = {.words = {thread, id}};
    return apply_and_record(r, VBSS_RECORD_INPUT_DETACH, &input, NULL);
}

vbss_result vbss_record_set_grasper_target(vbss_record *record, uint32_t body,
                                           const double position[3], const double *orientation)
{
    VBSS_ENTER(record);
    return move_body(record, VBSS_RECORD_INPUT_GRASPER_TARGET, body, position, orientation);
}

vbss_result vbss_record_set_opening(vbss_record *record, uint32_t body, double opening)
{
    VBSS_ENTER(record);
    record_object *r;
    VBSS_TRY(vbss_record_edit(record, &r));
    const vbss_record_input input = {.words = {body}, .numbers = {opening}};
    return apply_and_record(r, VBSS_RECORD_INPUT_SET_OPENING, &input, NULL);
}

vbss_result vbss_record_exchange(vbss_record *record, uint32_t body, vbss_grasper_kind kind)
{
    VBSS_ENTER(record);
    record_object *r;
    VBSS_TRY(vbss_record_edit(record, &r));
    const vbss_record_input input = {.words = {body, (uint32_t)kind}};
    return apply_and_record(r, VBSS_RECORD_INPUT_EXCHANGE, &input, NULL);
}
