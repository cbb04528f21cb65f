/* Inputs: applies a recorded call of the host to a scene, both live and in a replay. */
#include "base/error.h"
#include "record/record.h"

#include <vblast_ss/drain.h>
#include <vblast_ss/scene_query.h>
#include <vblast_ss/scene_settings.h>

_Static_assert(sizeof(vbss_thread_attachment) == 112, "new fields must be inputs too");
_Static_assert(sizeof(vbss_drain_attachment) == 72, "new fields must be inputs too");

const log_input_shape vbss_log_input_shapes[LOG_INPUT_KINDS] = {
    [VBSS_RECORD_INPUT_RIGID_TARGET] = {2, 7},
    [VBSS_RECORD_INPUT_PIN] = {4, 3},
    [VBSS_RECORD_INPUT_UNPIN] = {1, 0},
    [VBSS_RECORD_INPUT_ATTACH] = {3, 12},
    [VBSS_RECORD_INPUT_ATTACHMENT_TARGET] = {3, 6},
    [VBSS_RECORD_INPUT_DETACH] = {2, 0},
    [VBSS_RECORD_INPUT_GRASPER_TARGET] = {2, 7},
    [VBSS_RECORD_INPUT_SET_OPENING] = {1, 1},
    [VBSS_RECORD_INPUT_EXCHANGE] = {2, 0},
    [VBSS_RECORD_INPUT_CUT] = {1, 1},
    [VBSS_RECORD_INPUT_SETTING] = {4, 9},
    [VBSS_RECORD_INPUT_HOLE] = {3, 4},
    [VBSS_RECORD_INPUT_REMOVE] = {1, 0},
    [VBSS_RECORD_INPUT_DRAIN_ATTACH] = {3, 7},
    [VBSS_RECORD_INPUT_DRAIN_TARGET] = {2, 3},
    [VBSS_RECORD_INPUT_DRAIN_DETACH] = {2, 0},
    [VBSS_RECORD_INPUT_ROLL] = {2, 1},
};

static vbss_result attach(vbss_thread *thread, const vbss_record_input *input, uint32_t *id)
{
    const double *n = input->numbers;
    vbss_thread_attachment a;
    VBSS_TRY(vbss_thread_attachment_init(&a, sizeof a));
    a.kind = (vbss_thread_attachment_kind)input->words[1];
    a.node = input->words[2];
    vec3_store(a.position, vec3_load(n));
    vec3_store(a.direction, vec3_load(n + 3));
    vec3_store(a.force, vec3_load(n + 6));
    a.stiffness = n[9];
    a.damping = n[10];
    a.mass = n[11];
    return vbss_thread_attach(thread, &a, id);
}

static vbss_result attach_drain(vbss_drain *drain, const vbss_record_input *input, uint32_t *id)
{
    const double *n = input->numbers;
    vbss_drain_attachment a;
    VBSS_TRY(vbss_drain_attachment_init(&a, sizeof a));
    a.kind = (vbss_drain_attachment_kind)input->words[1];
    a.node = input->words[2];
    vec3_store(a.position, vec3_load(n));
    vec3_store(a.force, vec3_load(n + 3));
    a.stiffness = n[6];
    return vbss_drain_attach(drain, &a, id);
}

static vbss_result apply_setting(vbss_scene *scene, const vbss_record_input *input)
{
    scene_info info;
    const uint32_t *w = input->words, body = w[1];
    const double *n = input->numbers;
    switch ((vbss_scene_setting)w[0]) {
    case VBSS_SCENE_SETTING_GRAVITY:
        return vbss_scene_set_gravity(scene, body, n);
    case VBSS_SCENE_SETTING_FRICTION:
        return vbss_scene_set_friction(scene, body, n[0]);
    case VBSS_SCENE_SETTING_THREAD_FRICTION:
        return vbss_scene_set_thread_friction(scene, n[0]);
    case VBSS_SCENE_SETTING_COUPLING:
        return vbss_scene_set_coupling(scene, body, n[0], n[1], n[2], n[3]);
    case VBSS_SCENE_SETTING_SPEED_LIMIT:
        return vbss_scene_set_speed_limit(scene, n[0]);
    case VBSS_SCENE_SETTING_FILTER:
        return vbss_scene_set_filter(scene, body, w[2], w[3]);
    case VBSS_SCENE_SETTING_FORCE:
        return vbss_scene_apply_force(scene, body, n, w[2] != 0 ? n + 3 : NULL,
                                      w[3] != 0 ? n + 6 : NULL);
    case VBSS_SCENE_SETTING_VELOCITY:
        return vbss_scene_set_rigid_velocity(scene, body, n, w[2] != 0 ? n + 3 : NULL);
    case VBSS_SCENE_SETTING_POSE:
        return vbss_scene_set_rigid_pose(scene, body, n, w[2] != 0 ? n + 3 : NULL);
    case VBSS_SCENE_SETTING_BUDGETS:
        return vbss_scene_set_budgets(scene, n[0], n[1], n[2]);
    default:
        VBSS_TRY(vbss_scene_inspect(scene, &info));
        return vbss_fail(info.context, VBSS_ERROR_OUT_OF_RANGE, "no setting has the number %u",
                         w[0]);
    }
}

vbss_result vbss_log_apply_input(vbss_scene *scene, uint8_t kind, const vbss_record_input *input,
                                 uint32_t *id)
{
    const uint32_t *w = input->words;
    const double *n = input->numbers;
    vbss_thread *thread = NULL;
    vbss_grasper *grasper = NULL;
    vbss_drain *drain = NULL;
    uint32_t ignored, *new_id = id != NULL ? id : &ignored;
    if ((kind >= VBSS_RECORD_INPUT_ATTACH && kind <= VBSS_RECORD_INPUT_DETACH) ||
        kind == VBSS_RECORD_INPUT_ROLL) {
        VBSS_TRY(vbss_scene_get_thread(scene, w[0], &thread));
    }
    if (kind >= VBSS_RECORD_INPUT_GRASPER_TARGET && kind <= VBSS_RECORD_INPUT_EXCHANGE) {
        VBSS_TRY(vbss_scene_get_grasper(scene, w[0], &grasper));
    }
    if (kind >= VBSS_RECORD_INPUT_DRAIN_ATTACH && kind <= VBSS_RECORD_INPUT_DRAIN_DETACH) {
        VBSS_TRY(vbss_scene_get_drain(scene, w[0], &drain));
    }
    switch (kind) {
    case VBSS_RECORD_INPUT_RIGID_TARGET:
        return vbss_scene_set_rigid_target(scene, w[0], n, w[1] != 0 ? n + 3 : NULL);
    case VBSS_RECORD_INPUT_PIN:
        return vbss_scene_pin_thread(scene, w[0], w[1], w[2], w[3] != 0 ? n : NULL, new_id);
    case VBSS_RECORD_INPUT_UNPIN:
        return vbss_scene_unpin_thread(scene, w[0]);
    case VBSS_RECORD_INPUT_ATTACH:
        return attach(thread, input, new_id);
    case VBSS_RECORD_INPUT_ATTACHMENT_TARGET:
        return vbss_thread_set_attachment_target(thread, w[1], n, w[2] != 0 ? n + 3 : NULL);
    case VBSS_RECORD_INPUT_DETACH:
        return vbss_thread_detach(thread, w[1]);
    case VBSS_RECORD_INPUT_ROLL:
        return vbss_thread_set_roll(thread, w[1], n[0]);
    case VBSS_RECORD_INPUT_CUT:
        return vbss_scene_cut_thread(scene, w[0], n[0], new_id);
    case VBSS_RECORD_INPUT_GRASPER_TARGET:
        return vbss_grasper_set_target(grasper, n, w[1] != 0 ? n + 3 : NULL);
    case VBSS_RECORD_INPUT_SET_OPENING:
        return vbss_grasper_set_opening(grasper, n[0]);
    case VBSS_RECORD_INPUT_EXCHANGE:
        return vbss_grasper_exchange(grasper, (vbss_grasper_kind)w[1]);
    case VBSS_RECORD_INPUT_HOLE:
        return vbss_scene_make_hole(scene, w[0], n[0], w[1], w[2], n + 1, new_id);
    case VBSS_RECORD_INPUT_REMOVE:
        return vbss_scene_remove(scene, w[0]);
    case VBSS_RECORD_INPUT_DRAIN_ATTACH:
        return attach_drain(drain, input, new_id);
    case VBSS_RECORD_INPUT_DRAIN_TARGET:
        return vbss_drain_set_attachment_target(drain, w[1], n);
    case VBSS_RECORD_INPUT_DRAIN_DETACH:
        return vbss_drain_detach(drain, w[1]);
    default: /* VBSS_RECORD_INPUT_SETTING */
        return apply_setting(scene, input);
    }
}
