/* How sessions begin and end, and what they say of themselves. */
#include "base/check.h"
#include "base/error.h"
#include "base/snapshot.h"
#include "device/device.h"
#include "knot/knot.h"
#include "metrics/metrics.h"
#include "session/session.h"

_Static_assert(sizeof(vbss_session_status) == 136, "published size");

static const uint32_t status_sizes[] = {136, 0};
static const vbss_layout status_layout = {"vbss_session_status", NULL, status_sizes};

/* ---- memory */

static vbss_array event_array(session_object *s)
{
    return (vbss_array){&s->events, s->config.event_capacity, sizeof *s->events};
}

static void free_session(vbss_context *context, void *object)
{
    session_object *s = object;
    const vbss_array events = event_array(s);
    vbss_release_arrays(context, &events, 1);
    vbss_release(context, s, 1, sizeof *s);
}

const vbss_kind vbss_session_kind = {"session", VBSS_CODE('S', 'E', 'S', 'S'), 1, free_session,
                                     vbss_session_serialise};

vbss_result vbss_session_open(const vbss_session *handle, session_object **session)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(handle, &vbss_session_kind, &slot));
    *session = slot->object;
    return VBSS_OK;
}

vbss_result vbss_session_edit(vbss_session *handle, session_object **session)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit(handle, &vbss_session_kind, &slot));
    *session = slot->object;
    return VBSS_OK;
}

/* ---- what it is made over */

static vbss_result require_body(const scene_object *scene, uint32_t number, bool is_valid,
                                const char *name)
{
    return is_valid ? VBSS_OK
                    : vbss_fail(scene->context, VBSS_ERROR_OUT_OF_RANGE, "%s: body %u is none",
                                name, number);
}

static vbss_result check_tool(const scene_object *scene, uint32_t number, const char *name)
{
    const scene_body *b = number > 0 ? vbss_scene_body(scene, number) : NULL;
    return require_body(scene, number,
                        b != NULL && b->kind == SCENE_BODY_RIGID && b->rigid.grasper != NULL, name);
}

static vbss_result check_bodies(const scene_object *scene, const vbss_session_config *c)
{
    const scene_body *thread = c->thread > 0 ? vbss_scene_body(scene, c->thread) : NULL;
    const scene_body *needle = c->needle > 0 ? vbss_scene_body(scene, c->needle) : NULL;
    const scene_body *drain = c->drain > 0 ? vbss_scene_body(scene, c->drain) : NULL;
    VBSS_TRY(require_body(scene, c->thread, thread != NULL && thread->kind == SCENE_BODY_THREAD,
                          "thread"));
    VBSS_TRY(require_body(scene, c->needle,
                          needle != NULL && needle->kind == SCENE_BODY_RIGID &&
                              needle->rigid.needle != NULL,
                          "needle"));
    VBSS_TRY(
        require_body(scene, c->drain, drain != NULL && drain->kind == SCENE_BODY_DRAIN, "drain"));
    VBSS_TRY(check_tool(scene, c->tools[0], "left tool"));
    VBSS_TRY(check_tool(scene, c->tools[1], "right tool"));
    VBSS_TRY(c->shears == 0 ? VBSS_OK : check_tool(scene, c->shears, "shears"));
    bool is_repeated =
        c->tools[0] == c->tools[1] || c->shears == c->tools[0] || c->shears == c->tools[1];
    return is_repeated ? vbss_fail(scene->context, VBSS_ERROR_OUT_OF_RANGE, "a tool is given twice")
                       : VBSS_OK;
}

static vbss_result check_context(const session_object *s, const void *handle, const char *name)
{
    return handle == NULL || ((const vbss_slot *)handle)->context == s->context
               ? VBSS_OK
               : vbss_fail(s->context, VBSS_ERROR_INVALID_HANDLE, "%s of another context", name);
}

static vbss_result check_detector(const session_object *s, const scene_object *scene)
{
    const thread_object *t = vbss_scene_body(scene, s->config.thread)->thread.thread;
    knot_detector *d;
    VBSS_TRY(vbss_knot_open(s->config.knots, &d));
    uint32_t tools = s->config.shears != 0 ? 3 : 2;
    return t->node_capacity <= d->config.point_capacity && tools <= d->config.tool_capacity
               ? VBSS_OK
               : vbss_fail(s->context, VBSS_ERROR_CAPACITY,
                           "the detector has room for %u points and %u tools, not for %u and %u",
                           d->config.point_capacity, d->config.tool_capacity, t->node_capacity,
                           tools);
}

static vbss_result check_replay(const session_object *s)
{
    replay_object *p;
    VBSS_TRY(vbss_replay_edit(s->config.replay, &p));
    if (s->config.record != NULL) {
        return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE, "both a record and a replay");
    }
    return p->scene == s->scene
               ? VBSS_OK
               : vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE, "the replay is of another scene");
}

static vbss_result check_components(const session_object *s, const scene_object *scene)
{
    const vbss_session_config *c = &s->config;
    for (int i = 0; i < SESSION_HANDS; i++) {
        device_object *d;
        VBSS_TRY(c->devices[i] == NULL ? VBSS_OK : vbss_device_open(c->devices[i], &d));
        VBSS_TRY(check_context(s, c->devices[i], "a device"));
    }
    metrics_object *m;
    VBSS_TRY(c->knots == NULL ? VBSS_OK : check_detector(s, scene));
    VBSS_TRY(check_context(s, c->knots, "a detector"));
    VBSS_TRY(c->metrics == NULL ? VBSS_OK : vbss_metrics_open(c->metrics, &m));
    VBSS_TRY(check_context(s, c->metrics, "a measurement"));
    VBSS_TRY(vbss_session_check_record(s, c->record));
    return c->replay == NULL ? VBSS_OK : check_replay(s);
}

/* ---- life */

static vbss_result allocate_session(vbss_context *context, const vbss_session_config *config,
                                    session_object **session)
{
    session_object *s = vbss_allocate(context, 1, sizeof *s, "session");
    if (s == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    s->context = context;
    s->config = *config;
    s->thread = config->thread;
    s->last_holder = VBSS_METRICS_NO_TOOL;
    const vbss_array events = event_array(s);
    vbss_result result = vbss_allocate_arrays(context, &events, 1, "events of a session");
    if (result != VBSS_OK) {
        free_session(context, s);
        return result;
    }
    *session = s;
    return VBSS_OK;
}

vbss_result vbss_session_create(vbss_scene *scene, const vbss_session_config *config,
                                vbss_session **session)
{
    scene_object *opened;
    session_object *s = NULL;
    vbss_session_config own;
    vbss_slot *slot = NULL;
    if (session == NULL) {
        VBSS_TRY(vbss_scene_open(scene, &opened));
        return vbss_check_pointer(opened->context, session, "session");
    }
    *session = NULL;
    VBSS_TRY(vbss_scene_open_mutable(scene, &opened));
    VBSS_TRY(vbss_session_read_config(opened->context, config, &own));
    VBSS_TRY(check_bodies(opened, &own));
    VBSS_TRY(allocate_session(opened->context, &own, &s));
    s->scene = scene;
    s->scene_steps = opened->statistics.steps;
    vbss_result result = check_components(s, opened);
    if (result == VBSS_OK) {
        result = vbss_slot_create(s->context, &vbss_session_kind, s, &slot);
    }
    if (result != VBSS_OK) {
        free_session(s->context, s);
        return result;
    }
    result = vbss_session_record_snapshot(slot, own.record);
    if (result != VBSS_OK) {
        (void)vbss_session_destroy((vbss_session *)slot);
        return result;
    }
    *session = (vbss_session *)slot;
    return VBSS_OK;
}

vbss_result vbss_session_destroy(vbss_session *session)
{
    return vbss_slot_destroy(session, &vbss_session_kind);
}

vbss_result vbss_session_set_record(vbss_session *session, vbss_record *record)
{
    session_object *s;
    VBSS_TRY(vbss_session_edit(session, &s));
    VBSS_TRY(vbss_session_check_record(s, record));
    VBSS_TRY(vbss_session_record_snapshot((const vbss_slot *)session, record));
    s->config.record = record;
    s->config.replay = NULL;
    return VBSS_OK;
}

/* ---- how far it is */

static uint32_t count_bits(uint32_t bits)
{
    return (bits & 1u) + (bits >> 1 & 1u);
}

vbss_result vbss_session_get_status(vbss_session *session, vbss_session_status *status,
                                    uint32_t struct_size)
{
    session_object *s;
    VBSS_TRY(vbss_session_open(session, &s));
    uint64_t capacity = s->config.event_capacity;
    vbss_session_status own = {
        .struct_size = sizeof own,
        .phase = s->phase,
        .stage = (vbss_session_stage)(s->throw_stage.value % 8),
        .failure = s->failure,
        .holder = s->holding_tools.value == 0          ? VBSS_METRICS_NO_TOOL
                  : (s->holding_tools.value & 1u) != 0 ? VBSS_METRICS_LEFT
                                                       : VBSS_METRICS_RIGHT,
        .tail_set = s->tail_set.value,
        .throws = s->throw_count,
        .seated = s->seated_count,
        .transfers = count_bits(s->transferred),
        .cut = s->cut_limbs,
        .faults = s->knot_faults.value,
        .metrics_lost = s->metrics_lost,
        .steps = s->steps,
        .first_event = s->event_count > capacity ? s->event_count - capacity : 0,
        .event_count = s->event_count,
        .time = vbss_session_is_over(s) ? s->end_time : s->time,
        .tail = s->tail_length,
        .gap = s->gap,
    };
    for (uint32_t k = 0; k < SESSION_SIDES; k++) {
        const session_hole *hole = &s->holes[k];
        own.punctured |= (uint32_t)(hole->id != 0) << k;
        own.threaded |= hole->threaded << k;
        own.tension[k] = s->tension[k];
        own.deviation_mm[k] = hole->deviation_mm;
    }
    return vbss_struct_write(s->context, &status_layout, &own, status, struct_size);
}

/* ---- saving from outside */

vbss_result vbss_session_save(vbss_session *session, uint8_t *bytes, uint64_t capacity,
                              uint64_t *written)
{
    return vbss_object_save(session, &vbss_session_kind, bytes, capacity, written);
}

vbss_result vbss_session_restore(vbss_session *session, const uint8_t *bytes, uint64_t count)
{
    session_object *s;
    VBSS_TRY(vbss_session_open(session, &s));
    VBSS_TRY(vbss_check_arithmetic(s->context)); /* a reading of the detector is done again */
    return vbss_object_restore(session, &vbss_session_kind, bytes, count);
}

vbss_result vbss_session_get_hash(vbss_session *session, uint64_t *hash)
{
    return vbss_object_hash(session, &vbss_session_kind, hash);
}
