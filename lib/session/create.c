/* Creates and destroys sessions. Creation checks the bodies and components of the configuration. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "device/device.h"
#include "knot/knot.h"
#include "metrics/metrics.h"
#include "session/session.h"

/* ---- checks */

/* `handle` is the one that the body has if it is of the right kind. */
static vbss_result require_body(vbss_context *context, uint32_t number, const scene_body_info *body,
                                const void *handle, const char *name)
{
    if (body->number == 0) {
        return vbss_fail(context, VBSS_ERROR_NOT_FOUND, "%s: the scene has no body %u", name,
                         number);
    }
    return handle != NULL
               ? VBSS_OK
               : vbss_fail(context, VBSS_ERROR_INCOMPATIBLE, "%s: body %u is none", name, number);
}

static vbss_result check_tool(vbss_context *context, const vbss_scene *scene, uint32_t number,
                              const char *name)
{
    const scene_body_info b = vbss_scene_inspect_body(scene, number);
    return require_body(context, number, &b, b.grasper, name);
}

static vbss_result check_bodies(vbss_context *context, const vbss_scene *scene,
                                const vbss_session_config *c)
{
    const scene_body_info thread = vbss_scene_inspect_body(scene, c->thread);
    const scene_body_info needle = vbss_scene_inspect_body(scene, c->needle);
    const scene_body_info drain = vbss_scene_inspect_body(scene, c->drain);
    VBSS_TRY(require_body(context, c->thread, &thread, thread.thread, "thread"));
    VBSS_TRY(require_body(context, c->needle, &needle, needle.needle, "needle"));
    VBSS_TRY(require_body(context, c->drain, &drain, drain.drain, "drain"));
    if (vbss_scene_inspect_drain(drain.drain).marks[0] == SCENE_INSPECT_NONE) {
        return vbss_fail(context, VBSS_ERROR_INCOMPATIBLE,
                         "the drain has a surface, and the task needs marks and a slit");
    }
    VBSS_TRY(check_tool(context, scene, c->tools[0], "left tool"));
    VBSS_TRY(check_tool(context, scene, c->tools[1], "right tool"));
    VBSS_TRY(c->shears == 0 ? VBSS_OK : check_tool(context, scene, c->shears, "shears"));
    bool is_repeated =
        c->tools[0] == c->tools[1] || c->shears == c->tools[0] || c->shears == c->tools[1];
    return is_repeated ? vbss_fail(context, VBSS_ERROR_IN_USE, "a tool is given twice") : VBSS_OK;
}

/* A component that the session does not have is NULL. */
static vbss_result check_context(const session_object *s, const void *handle, const char *name)
{
    return handle == NULL ? VBSS_OK : vbss_slot_check_other(s->context, handle, name);
}

static vbss_result check_detector(const session_object *s)
{
    const vbss_thread *thread = vbss_scene_inspect_body(s->scene, s->config.thread).thread;
    uint32_t points = vbss_scene_inspect_thread(thread).node_capacity;
    knot_detector *d;
    VBSS_TRY(vbss_knot_open(s->config.knots, &d));
    uint32_t tools = s->config.shears != 0 ? 3 : 2;
    return points <= d->config.point_capacity && tools <= d->config.tool_capacity
               ? VBSS_OK
               : vbss_fail(s->context, VBSS_ERROR_CAPACITY,
                           "the detector has room for %u points and %u tools, not for %u and %u",
                           d->config.point_capacity, d->config.tool_capacity, points, tools);
}

static vbss_result check_replay(const session_object *s)
{
    replay_object *p;
    VBSS_TRY(vbss_replay_edit(s->config.replay, &p));
    if (s->config.record != NULL) {
        return vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE, "both a record and a replay");
    }
    return p->scene == s->scene
               ? VBSS_OK
               : vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE, "the replay is of another scene");
}

static vbss_result check_components(const session_object *s)
{
    const vbss_session_config *c = &s->config;
    for (int i = 0; i < SESSION_HANDS; i++) {
        device_object *d;
        VBSS_TRY(check_context(s, c->devices[i], "a device"));
        VBSS_TRY(c->devices[i] == NULL ? VBSS_OK : vbss_device_open(c->devices[i], &d));
    }
    metrics_object *m;
    VBSS_TRY(check_context(s, c->knots, "knots"));
    VBSS_TRY(c->knots == NULL ? VBSS_OK : check_detector(s));
    VBSS_TRY(check_context(s, c->metrics, "metrics"));
    VBSS_TRY(c->metrics == NULL ? VBSS_OK : vbss_metrics_open(c->metrics, &m));
    VBSS_TRY(vbss_session_check_record(s, c->record));
    VBSS_TRY(check_context(s, c->replay, "replay"));
    return c->replay == NULL ? VBSS_OK : check_replay(s);
}

/* ---- creation and destruction */

vbss_result vbss_session_create(vbss_scene *scene, const vbss_session_config *config,
                                vbss_session **session)
{
    VBSS_ENTER_WITH_RESULT(scene, session);
    scene_info info;
    session_object *s = NULL;
    vbss_session_config own;
    vbss_slot *slot = NULL;
    if (session == NULL) {
        VBSS_TRY(vbss_scene_inspect(scene, &info));
        return vbss_check_pointer(info.context, session, "session");
    }
    VBSS_TRY(vbss_scene_inspect_for_edit(scene, &info));
    VBSS_TRY(vbss_session_read_config(info.context, config, &own));
    VBSS_TRY(check_bodies(info.context, scene, &own));
    VBSS_TRY(vbss_session_allocate(info.context, &own, &s));
    s->scene = scene;
    s->takes_over = true;
    vbss_result result = vbss_session_start_clock(s);
    if (result == VBSS_OK) {
        result = check_components(s);
    }
    if (result == VBSS_OK) {
        result = vbss_slot_create(s->context, &vbss_session_kind, s, &slot);
    }
    if (result != VBSS_OK) {
        vbss_session_free(s->context, s);
        return result;
    }
    result = vbss_session_record_snapshot(slot, own.record);
    if (result == VBSS_OK && own.exercise != VBSS_SESSION_EXERCISE_NONE && own.replay != NULL) {
        result = vbss_session_seek_step(slot, s, 0); /* the log has the start of the exercise */
    }
    if (result != VBSS_OK) {
        (void)vbss_session_destroy((vbss_session *)slot);
        return result;
    }
    *session = (vbss_session *)slot;
    return VBSS_OK;
}

vbss_result vbss_session_destroy(vbss_session *session)
{
    VBSS_ENTER(session);
    return vbss_slot_destroy(session, &vbss_session_kind);
}
