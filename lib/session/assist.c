/* Assistance: what hosts set, the hands' input before a step, and the events of aids after it. */
#include "base/check.h"
#include "base/config.h"
#include "base/error.h"
#include "base/pi.h"
#include "session/session.h"
#include "session/tuning.h"

_Static_assert(sizeof(vbss_session_assistance) == 72, "published size");
_Static_assert(sizeof(vbss_session_hand) == 72, "published size");

static const vbss_session_assistance defaults = {
    .struct_size = sizeof(vbss_session_assistance),
    .time_scale = 0.5,
    .roll_step = 0.25 * VBSS_PI,
    .sink_speed = 4e-3,
    .hold_distance = 2e-3,
    .hold_time = 0.7,
};
static const uint32_t sizes[] = {72, 0};
static const vbss_layout layout = {"vbss_session_assistance", &defaults, sizes};

static const vbss_session_hand hand_defaults = {.struct_size = sizeof(vbss_session_hand),
                                                .orientation = {1.0}};
static const uint32_t hand_sizes[] = {72, 0};
static const vbss_layout hand_layout = {"vbss_session_hand", &hand_defaults, hand_sizes};

vbss_result vbss_session_assistance_init(vbss_session_assistance *assistance, uint32_t struct_size)
{
    return vbss_config_init(&layout, assistance, struct_size);
}

vbss_result vbss_session_hand_init(vbss_session_hand *hand, uint32_t struct_size)
{
    return vbss_config_init(&hand_layout, hand, struct_size);
}

vbss_session_assistance vbss_session_default_assistance(void)
{
    return defaults;
}

/* ---- what hosts set */

static vbss_result check_direction(vbss_context *context, const double direction[3])
{
    VBSS_TRY(vbss_check_vector(context, direction, 1e3, "direction"));
    double norm = vec3_norm(vec3_load(direction));
    return norm == 0.0 ? VBSS_OK : vbss_check_range(context, norm, 1e-9, 1e3, "direction");
}

vbss_result vbss_session_read_assistance(vbss_context *context,
                                         const vbss_session_assistance *assistance,
                                         vbss_session_assistance *own)
{
    VBSS_TRY(vbss_config_read(context, &layout, assistance, own));
    const struct {
        const char *name;
        double value, low, high;
    } ranges[] = {
        {"aids", own->aids, 0.0, VBSS_SESSION_AID_ALL},  {"time_scale", own->time_scale, 0.25, 1.0},
        {"roll_step", own->roll_step, 0.01, 3.2},        {"sink_speed", own->sink_speed, 0.0, 1.0},
        {"hold_distance", own->hold_distance, 0.0, 1.0}, {"hold_time", own->hold_time, 0.0, 10.0},
    };
    for (size_t i = 0; i < sizeof ranges / sizeof ranges[0]; i++) {
        VBSS_TRY(vbss_check_range(context, ranges[i].value, ranges[i].low, ranges[i].high,
                                  ranges[i].name));
    }
    return check_direction(context, own->direction);
}

vbss_result vbss_session_write_assistance(const session_object *s, vbss_session_assistance *out,
                                          uint32_t struct_size)
{
    vbss_session_assistance own = s->config.replay != NULL ? defaults : s->assistance.set;
    own.aids = s->config.replay != NULL ? s->assistance.aids : own.aids;
    return vbss_struct_write(s->context, &layout, &own, out, struct_size);
}

/* ---- the input of a host */

/* What the hand has moved since it began to rest stays. */
static void move_origin(session_aided_hand *hand, pose input)
{
    if (hand->is_relative == 0) {
        return;
    }
    const quat back = quat_conjugate(hand->input.orientation);
    const quat turn = quat_unit(quat_mul(input.orientation, back));
    const vec3 shift = vec3_sub(input.position, hand->input.position);
    hand->rest.position = vec3_add(hand->rest.position, shift);
    hand->rest.orientation = quat_unit(quat_mul(turn, hand->rest.orientation));
    hand->input = input;
}

vbss_result vbss_session_give_input(session_object *s, uint32_t hand,
                                    const vbss_session_hand *given)
{
    vbss_session_hand own;
    quat orientation;
    VBSS_TRY(vbss_config_read(s->context, &hand_layout, given, &own));
    VBSS_TRY(vbss_check_range(s->context, own.is_origin, 0.0, 1.0, "is_origin"));
    VBSS_TRY(vbss_check_vector(s->context, own.position, 1e3, "position"));
    VBSS_TRY(vbss_read_orientation(s->context, own.orientation, &orientation));
    VBSS_TRY(vbss_check_range(s->context, own.opening, 0.0, 1.0, "opening"));
    const pose input = pose_make(vec3_load(own.position), orientation);
    if (own.is_origin == 0) {
        s->given[hand] = (session_given_input){true, {input, own.opening}};
    } else {
        move_origin(&s->assistance.hands[hand], input);
    }
    return VBSS_OK;
}

/* ---- a step */

bool vbss_session_is_hand_assisted(const session_object *s, uint32_t hand)
{
    return s->assistance.set.aids != 0 || s->assistance.hands[hand].is_relative != 0;
}

double vbss_session_scaled_step(const session_object *s, double h)
{
    bool is_slow = (s->assistance.set.aids & (uint32_t)VBSS_SESSION_AID_SLOW_MOTION) != 0;
    return is_slow ? s->assistance.set.time_scale * h : h;
}

/* In a replay the log has the aids of each step in which one was switched. */
static uint32_t present_aids(const session_object *s)
{
    return s->config.replay != NULL ? vbss_session_logged_aids(s) : s->assistance.set.aids;
}

void vbss_session_update_aids(session_object *s)
{
    session_assistance *a = &s->assistance;
    uint32_t now = present_aids(s), changed = now ^ a->aids;
    if (changed == 0 || vbss_session_is_over(s)) {
        return;
    }
    for (uint32_t aid = 1; aid <= (uint32_t)VBSS_SESSION_AID_ALL; aid <<= 1) {
        if ((changed & aid) != 0) {
            vbss_session_event *e = vbss_session_emit_event(
                s, VBSS_SESSION_EVENT_AID, aid, (now & aid) == 0, VBSS_METRICS_TOOL_NONE);
            e->amount = (now & ~a->used & aid) != 0 ? 1.0 : 0.0;
        }
    }
    a->aids = now;
    a->used |= now;
}

/* ---- state */

bool vbss_session_was_assisted(const session_object *s)
{
    return (s->assistance.aids | s->assistance.used) != 0;
}

bool vbss_session_has_assistance(const session_object *s)
{
    const session_assistance *a = &s->assistance;
    return (a->set.aids | a->hands[0].is_relative | a->hands[1].is_relative) != 0 ||
           vbss_session_was_assisted(s);
}

static void visit_pose(vbss_stream *stream, pose *p)
{
    vbss_stream_f64(stream, 94, &p->position.x, 3);
    vbss_stream_f64(stream, 95, &p->orientation.w, 4);
}

static void visit_hand(vbss_stream *stream, session_aided_hand *hand)
{
    vbss_stream_u32(stream, 93, &hand->is_relative, 1);
    vbss_stream_u32(stream, 93, &hand->is_on_arc, 1);
    visit_pose(stream, &hand->input);
    visit_pose(stream, &hand->free);
    visit_pose(stream, &hand->rest);
    double *const numbers[] = {&hand->roll, &hand->snapped, &hand->climb, &hand->rest_time,
                               &hand->opening};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_f64(stream, 96, numbers[i], 1);
    }
    vbss_stream_f64(stream, 97, &hand->arc_centre.x, 3);
    vbss_stream_f64(stream, 97, &hand->arc_axis.x, 3);
    vbss_stream_u32(stream, 98, &hand->knows_other, 1);
    vbss_stream_f64(stream, 99, &hand->still_time, 1);
    vbss_stream_f64(stream, 99, &hand->limb_length, 1);
    visit_pose(stream, &hand->other);
    vbss_stream_f64(stream, 99, &hand->arm.x, 3);
}

static bool is_unit(quat q)
{
    return fabs(quat_dot(q, q) - 1.0) < 1e-6;
}

static bool is_hand_wrong(const session_aided_hand *hand)
{
    bool is_placed = is_unit(hand->input.orientation) && is_unit(hand->free.orientation) &&
                     (hand->knows_other == 0 || is_unit(hand->other.orientation));
    return hand->is_relative > 1 || hand->is_on_arc > 1 || hand->knows_other > 1 ||
           (hand->is_relative != 0 && !is_placed);
}

void vbss_session_visit_assistance(vbss_stream *stream, session_object *s)
{
    session_assistance *a = &s->assistance;
    vbss_session_assistance own, *set = &a->set;
    vbss_stream_u32(stream, 90, &a->aids, 1);
    vbss_stream_u32(stream, 90, &a->used, 1);
    if (stream->mode == VBSS_STREAM_HASH) {
        return;
    }
    vbss_stream_u32(stream, 90, &set->aids, 1);
    double *const numbers[] = {&set->time_scale, &set->roll_step, &set->sink_speed,
                               &set->hold_distance, &set->hold_time};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_f64(stream, 91, numbers[i], 1);
    }
    vbss_stream_f64(stream, 92, set->direction, 3);
    visit_hand(stream, &a->hands[0]);
    visit_hand(stream, &a->hands[1]);
    bool is_wrong = a->aids > (uint32_t)VBSS_SESSION_AID_ALL ||
                    a->used > (uint32_t)VBSS_SESSION_AID_ALL || is_hand_wrong(&a->hands[0]) ||
                    is_hand_wrong(&a->hands[1]) ||
                    vbss_session_read_assistance(s->context, set, &own) != VBSS_OK;
    if (is_wrong && !stream->trusted) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no assistance is like this");
    }
}
