/* One step of a session:
 *   devices, aids -> scene step -> knots -> metrics -> forces out -> record
 * Once the scene has been stepped, the step counts: a later failure is returned, but undoes
 * nothing. */
#include "base/error.h"
#include "session/session.h"

static vbss_result check_scene_step(const session_object *s)
{
    scene_info scene;
    VBSS_TRY(vbss_scene_inspect(s->scene, &scene));
    return scene.steps == s->scene_steps
               ? VBSS_OK
               : vbss_fail(s->context, VBSS_ERROR_WRONG_STATE,
                           "the scene was stepped or restored past the session: it is after step "
                           "%llu, not %llu",
                           (unsigned long long)scene.steps, (unsigned long long)s->scene_steps);
}

static vbss_result observe_and_update(session_object *s)
{
    vbss_session_observe(s, &s->observation);
    vbss_result result = vbss_session_observe_knot(s, &s->observation);
    vbss_session_update_progress(s, &s->observation);
    vbss_session_update_aids(s);
    vbss_session_update_coach(s, &s->observation);
    return result;
}

static void keep_first_error(vbss_result *first, vbss_result result)
{
    *first = *first == VBSS_OK ? result : *first;
}

vbss_result vbss_session_advance(const vbss_slot *slot, session_object *s, double now, double h)
{
    VBSS_TRY(check_scene_step(s));
    VBSS_TRY(vbss_session_read_hands(s, now, h));
    VBSS_TRY(vbss_session_step_scene(s, h));
    VBSS_TRY(vbss_session_count_step(s));
    vbss_result result = observe_and_update(s);
    keep_first_error(&result, vbss_session_feed_metrics(s, &s->observation));
    keep_first_error(&result, vbss_session_write_devices(s, now));
    keep_first_error(&result, vbss_session_sync_log(slot, s));
    return result;
}
