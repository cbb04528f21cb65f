/* Pins and cuts the threads of a scene. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "base/number_text.h"
#include "scene/api/api.h"
#include "scene/step/step.h"
#include "scene/topology/topology.h"
#include "scene/world/world.h"

vbss_result vbss_scene_pin_thread(vbss_scene *scene, uint32_t thread, uint32_t node, uint32_t body,
                                  const double *point, uint32_t *pin)
{
    VBSS_ENTER(scene);
    scene_object *s;
    scene_edit edit;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, pin, "pin"));
    VBSS_TRY(vbss_scene_check_pin(s, thread, node, body, point));
    vbss_edit input = {.kind = VBSS_EDIT_PIN, .words = {thread, node, body, point != NULL}};
    vbss_edit_set_numbers(&input, 0, point, 3);
    VBSS_TRY(vbss_scene_begin_edit(scene, &input, &edit));
    return vbss_scene_end_edit(&edit, vbss_scene_pin_node(s, thread, node, body, point, pin));
}

vbss_result vbss_scene_unpin_thread(vbss_scene *scene, uint32_t pin)
{
    VBSS_ENTER(scene);
    scene_object *s;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    if (!vbss_scene_has_pin(s, pin)) {
        return vbss_fail(s->context, VBSS_ERROR_NOT_FOUND, "the scene has no pin %u", pin);
    }
    vbss_edit input = {.kind = VBSS_EDIT_UNPIN, .words = {pin}};
    VBSS_TRY(vbss_edit_begin(scene, &input));
    const vbss_result result = vbss_scene_abandon_suspended_step(s); /* which removes no pin */
    if (result == VBSS_OK) {
        (void)vbss_scene_unpin_node(s, pin);
    }
    return vbss_edit_end(scene, &input, result);
}

static vbss_result check_cut(scene_object *s, uint32_t thread, double arc_length, scene_body **body)
{
    VBSS_TRY(vbss_scene_require_body(s, thread, SCENE_BODY_THREAD, body));
    const thread_object *t = (*body)->thread.thread;
    return vbss_check_range(s->context, arc_length, 0.0,
                            vbss_thread_arc_length(t, t->node_count - 1), "arc_length");
}

static vbss_result report_cut(const scene_object *s, vbss_result result, uint32_t thread,
                              double arc_length)
{
    if (result == VBSS_ERROR_CAPACITY) {
        return vbss_fail(s->context, result, "all cuts of body %u are made", thread);
    }
    return result == VBSS_OK ? VBSS_OK
                             : vbss_fail(s->context, result, "a cut at %s m is at an end",
                                         VBSS_NUMBER(arc_length));
}

static vbss_result cut(scene_object *s, uint32_t thread, double arc_length, uint32_t *piece)
{
    scene_body *b, *new_piece;
    VBSS_TRY(check_cut(s, thread, arc_length, &b));
    VBSS_TRY(report_cut(s, vbss_scene_apply_cut(s, b, arc_length, &new_piece), thread, arc_length));
    *piece = new_piece->number;
    return VBSS_OK;
}

vbss_result vbss_scene_cut_thread(vbss_scene *scene, uint32_t thread, double arc_length,
                                  uint32_t *piece)
{
    VBSS_ENTER(scene);
    scene_object *s;
    scene_body *b;
    scene_edit edit;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, piece, "piece"));
    VBSS_TRY(check_cut(s, thread, arc_length, &b));
    const uint32_t pending_before = s->events.pending_count;
    vbss_result result = report_cut(s, vbss_scene_check_cut(s, b, arc_length), thread, arc_length);
    if (result == VBSS_OK) {
        vbss_edit input = {.kind = VBSS_EDIT_CUT, .words = {thread}, .numbers = {arc_length}};
        VBSS_TRY(vbss_scene_begin_edit(scene, &input, &edit));
        result = vbss_scene_end_edit(&edit, cut(s, thread, arc_length, piece));
    }
    /* A refused cut is an event, too. If the step stays suspended, its events stay pending. */
    vbss_scene_publish_events(s, s->cursor.is_suspended ? pending_before : 0, 0.0);
    return result;
}

vbss_result vbss_scene_get_thread(vbss_scene *scene, uint32_t body, vbss_thread **thread)
{
    VBSS_ENTER_WITH_RESULT(scene, thread);
    scene_object *s;
    VBSS_TRY(vbss_scene_open(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, thread, "thread"));
    scene_body *b;
    VBSS_TRY(vbss_scene_require_body(s, body, SCENE_BODY_THREAD, &b));
    *thread = (vbss_thread *)b->thread.slot;
    return VBSS_OK;
}
