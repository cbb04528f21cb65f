/* Records the edits of a scene: the functions behind its hook. */
#include <string.h>

#include "base/api_call.h"
#include "base/check.h"
#include "base/edit_hook.h"
#include "base/error.h"
#include "record/record.h"

_Static_assert((int)VBSS_EDIT_RIGID_TARGET == (int)VBSS_RECORD_INPUT_RIGID_TARGET &&
                   (int)VBSS_EDIT_PIN == (int)VBSS_RECORD_INPUT_PIN &&
                   (int)VBSS_EDIT_UNPIN == (int)VBSS_RECORD_INPUT_UNPIN &&
                   (int)VBSS_EDIT_ATTACH == (int)VBSS_RECORD_INPUT_ATTACH &&
                   (int)VBSS_EDIT_ATTACHMENT_TARGET == (int)VBSS_RECORD_INPUT_ATTACHMENT_TARGET &&
                   (int)VBSS_EDIT_DETACH == (int)VBSS_RECORD_INPUT_DETACH &&
                   (int)VBSS_EDIT_CUT == (int)VBSS_RECORD_INPUT_CUT &&
                   (int)VBSS_EDIT_GRASPER_TARGET == (int)VBSS_RECORD_INPUT_GRASPER_TARGET &&
                   (int)VBSS_EDIT_OPENING == (int)VBSS_RECORD_INPUT_SET_OPENING &&
                   (int)VBSS_EDIT_EXCHANGE == (int)VBSS_RECORD_INPUT_EXCHANGE &&
                   (int)VBSS_EDIT_SETTING == (int)VBSS_RECORD_INPUT_SETTING &&
                   (int)VBSS_EDIT_HOLE == (int)VBSS_RECORD_INPUT_HOLE &&
                   (int)VBSS_EDIT_REMOVE == (int)VBSS_RECORD_INPUT_REMOVE &&
                   (int)VBSS_EDIT_DRAIN_ATTACH == (int)VBSS_RECORD_INPUT_DRAIN_ATTACH &&
                   (int)VBSS_EDIT_DRAIN_TARGET == (int)VBSS_RECORD_INPUT_DRAIN_TARGET &&
                   (int)VBSS_EDIT_DRAIN_DETACH == (int)VBSS_RECORD_INPUT_DRAIN_DETACH &&
                   (int)VBSS_EDIT_ROLL == (int)VBSS_RECORD_INPUT_ROLL,
               "logs have the numbers of edits");

/* ---- the hook */

/* Numbers of edits of bodies are those of the bodies in the scene. */
static bool is_of_body(uint32_t kind)
{
    return (kind >= VBSS_EDIT_ATTACH && kind <= VBSS_EDIT_DETACH) || kind == VBSS_EDIT_ROLL ||
           (kind >= VBSS_EDIT_GRASPER_TARGET && kind <= VBSS_EDIT_EXCHANGE) ||
           (kind >= VBSS_EDIT_DRAIN_ATTACH && kind <= VBSS_EDIT_DRAIN_DETACH);
}

static vbss_result check_input_capacity(const record_object *r)
{
    return r->step.input_count < r->step.input_capacity
               ? VBSS_OK
               : vbss_fail(r->context, VBSS_ERROR_CAPACITY, "more than %u inputs before a step",
                           r->step.input_capacity);
}

static void append_input(record_object *r, const vbss_edit *edit)
{
    const uint32_t next = r->step.input_count++;
    vbss_record_input *input = &r->step.inputs[next];
    *input = (vbss_record_input){.kind = (vbss_record_input_kind)edit->kind};
    memcpy(input->words, edit->words, sizeof input->words);
    memcpy(input->numbers, edit->numbers, sizeof input->numbers);
    if (is_of_body(edit->kind)) {
        input->words[0] = vbss_scene_inspect_number(r->scene, edit->edited);
    }
    r->step.kinds[next] = (uint8_t)edit->kind;
}

static vbss_result begin_edit(void *data, const vbss_edit *edit)
{
    record_object *r = data;
    VBSS_TRY(vbss_record_check_ready(r));
    if (edit->kind == VBSS_EDIT_OTHER) {
        return vbss_record_reserve_replacement(r);
    }
    return edit->kind == VBSS_EDIT_STEP ? vbss_record_check_step(r, edit->numbers[0])
                                        : check_input_capacity(r);
}

static vbss_result end_edit(void *data, const vbss_edit *edit, vbss_result result)
{
    record_object *r = data;
    const scene_edit_counts known = r->known_edits;
    /* A step that was undone may have left its mark. */
    r->known_edits = vbss_scene_inspect_edits(r->scene);
    if (result != VBSS_OK) {
        return result;
    }
    if (edit->kind == VBSS_EDIT_STEP) {
        return vbss_record_append_step(r, edit->numbers[0]);
    }
    if (edit->kind == VBSS_EDIT_OTHER) {
        result = vbss_record_append_replacement(r);
        if (result != VBSS_OK) { /* the edit was made: the record refuses all that follows */
            r->known_edits = known;
        }
        return result;
    }
    append_input(r, edit);
    return VBSS_OK;
}

/* ---- attaching */

vbss_edit_hook vbss_record_attach_hook(record_object *r)
{
    vbss_edit_hook *hook = vbss_scene_inspect_hook(r->scene);
    const vbss_edit_hook before = *hook;
    hook->data = r;
    hook->begin_edit = begin_edit;
    hook->end_edit = end_edit;
    return before;
}

void vbss_record_restore_hook(record_object *r, const vbss_edit_hook *before)
{
    *vbss_scene_inspect_hook(r->scene) = *before;
}

void vbss_record_detach_hook(record_object *r)
{
    vbss_edit_hook *hook = vbss_scene_inspect_hook(r->scene);
    if (hook != NULL && hook->data == r) {
        hook->data = NULL;
    }
}

vbss_result vbss_scene_set_recorder(vbss_scene *scene, vbss_record *record)
{
    VBSS_ENTER(scene);
    scene_info info;
    record_object *r;
    VBSS_TRY(vbss_scene_inspect_for_edit(scene, &info));
    if (record == NULL) {
        vbss_scene_inspect_hook(scene)->data = NULL;
        return VBSS_OK;
    }
    VBSS_TRY(vbss_slot_check_other(info.context, record, "record"));
    VBSS_TRY(vbss_record_edit(record, &r));
    if (r->scene != scene) {
        return vbss_fail(info.context, VBSS_ERROR_INCOMPATIBLE, "the record is of another scene");
    }
    VBSS_TRY(vbss_record_check_ready(r));
    (void)vbss_record_attach_hook(r);
    return VBSS_OK;
}

/* ---- inputs from another log */

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
    VBSS_TRY(vbss_record_check_ready(r));
    const vbss_edit_hook before = vbss_record_attach_hook(r);
    const vbss_result result = vbss_log_apply_input(r->scene, (uint8_t)input->kind, input, id);
    vbss_record_restore_hook(r, &before);
    return result;
}
