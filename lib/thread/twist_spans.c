/* Spans of twist: parallel transport along the chords between two holders, and the twist of a span.
 *
 * A holder has a roll, the angle by which it has turned the section about the thread, and a director, which
 * moves without spin as the direction there changes. The twist of a span is the roll of its high holder
 * minus that of its low one, plus a part that depends on the shape alone. This part changes as the angle
 * between both directors does; the state has it, with its full turns. */
#include "base/elementary.h"
#include "base/pi.h"
#include "thread/tuning.h"
#include "thread/twist.h"

/* ---- parallel transport */

static thread_turn make_turn(vec3 before, vec3 after)
{
    const double inverse_fold =
        1.0 / vbss_max(1.0 + vec3_dot(before, after), THREAD_TWIST_MIN_FOLD);
    return (thread_turn){
        .before = before,
        .after = after,
        .inverse_fold = inverse_fold,
        .half_binormal = vec3_scale(vec3_cross(before, after), inverse_fold),
        .mean = vec3_scale(vec3_add(before, after), inverse_fold),
    };
}

/* Unit; `*inverse` gets 1 / length of the chord. */
static vec3 chord_direction(const vec3 *x, uint32_t segment, double *inverse)
{
    const vec3 chord = vec3_sub(x[segment + 1], x[segment]);
    const double length = vec3_norm(chord);
    *inverse = length > 0.0 ? 1.0 / length : 0.0;
    return vec3_scale(chord, *inverse);
}

vec3 vbss_thread_chord_direction(const vec3 *x, uint32_t segment)
{
    double ignored;
    return chord_direction(x, segment, &ignored);
}

thread_turn vbss_thread_turn(const vec3 *x, const thread_twist_span *span, uint32_t node)
{
    double inverse_before = 0.0, inverse_after = 0.0;
    const vec3 before =
        node == span->low ? span->direction[0] : chord_direction(x, node - 1, &inverse_before);
    const vec3 after =
        node == span->high ? span->direction[1] : chord_direction(x, node, &inverse_after);
    thread_turn turn = make_turn(before, after);
    turn.inverse_before = inverse_before;
    turn.inverse_after = inverse_after;
    return turn;
}

/* The director stays across the thread, which turns by the shortest rotation. */
static vec3 transport(vec3 director, const thread_turn *turn)
{
    return vec3_add_scaled(director, -vec3_dot(director, turn->after), turn->mean);
}

static vec3 transport_along(const vec3 *x, const thread_twist_span *span, vec3 director)
{
    for (uint32_t i = thread_first_turn(span); i <= thread_last_turn(span); i++) {
        const thread_turn turn = vbss_thread_turn(x, span, i);
        director = transport(director, &turn);
    }
    return director;
}

/* From one direction to another; unit, as rounding would add up. */
static vec3 transport_between(vec3 director, vec3 before, vec3 after)
{
    const thread_turn turn = make_turn(before, after);
    const vec3 moved = transport(director, &turn);
    const vec3 across = vec3_add_scaled(moved, -vec3_dot(moved, after), after);
    return vec3_unit_or(across, vec3_any_normal(after));
}

static vec3 roll_director(vec3 director, vec3 axis, double angle)
{
    double sine, cosine;
    vbss_sincos(angle, &sine, &cosine);
    return vec3_add_scaled(vec3_scale(director, cosine), sine, vec3_cross(axis, director));
}

/* Direction of the thread at an end of a span, with the nodes at `x`. */
static vec3 end_direction(const vec3 *x, const thread_twist_span *span, int end)
{
    return span->is_clamped[end]
               ? span->direction[end]
               : vbss_thread_chord_direction(x, end == 0 ? span->low : span->high - 1);
}

/* Angle from the director of the low holder, moved along the span, to that of the high one. */
static double angle_between_directors(const vec3 *x, const thread_twist_span *span)
{
    vec3 director[2], direction = vec3_zero();
    for (int end = 0; end < 2; end++) {
        direction = end_direction(x, span, end);
        director[end] = span->is_clamped[end] ? span->director[end]
                                              : transport_between(span->director[end],
                                                                  span->direction[end], direction);
    }
    const vec3 moved = transport_along(x, span, director[0]);
    return vbss_arc_tangent(vec3_dot(direction, vec3_cross(moved, director[1])),
                            vec3_dot(moved, director[1]));
}

/* ---- spans */

void vbss_thread_set_span_torque(const thread_object *t, thread_twist_span *span)
{
    span->twist = span->shape_twist + span->roll_difference;
    span->torque =
        t->config.torsional_stiffness * (span->twist / span->length - t->config.rest_twist);
}

uint32_t vbss_thread_count_spans(const thread_object *t)
{
    const uint32_t between_holders = t->holder_count > 0 ? t->holder_count - 1 : 0;
    return thread_has_friction_torque(t) ? vbss_thread_count_fine_spans(t) : between_holders;
}

static thread_twist_span span_between_holders(const thread_object *t, uint32_t index)
{
    const thread_section_holder *holders = &t->holders[index];
    const thread_section_frame *low_frame = &t->now.frames[holders[0].attachment_index];
    thread_twist_span span = {.low = holders[0].node,
                              .high = holders[1].node,
                              .holder_index = {index, index + 1},
                              .roll_segment = {THREAD_NO_ROLL, THREAD_NO_ROLL}};
    for (int end = 0; end < 2; end++) {
        span.is_clamped[end] = holders[end].is_clamp;
        span.direction[end] =
            holders[end].is_clamp
                ? t->now.frames[holders[end].attachment_index].direction
                : vbss_thread_chord_direction(t->now.x, end == 0 ? span.low : span.high - 1);
    }
    span.length = vbss_thread_arc_length(t, span.high) - vbss_thread_arc_length(t, span.low);
    span.roll_difference = holders[1].roll - holders[0].roll;
    span.shape_twist = low_frame->shape_twist;
    vbss_thread_set_span_torque(t, &span);
    return span;
}

thread_twist_span vbss_thread_twist_span(const thread_object *t, uint32_t index)
{
    return thread_has_friction_torque(t) ? vbss_thread_fine_span(t, index)
                                         : span_between_holders(t, index);
}

vec3 vbss_thread_holder_direction(const vec3 *x, uint32_t node_count,
                                  const thread_section_holder *holder)
{
    const uint32_t segment = holder->node + 1 < node_count ? holder->node : holder->node - 1;
    return holder->is_clamp ? holder->direction : vbss_thread_chord_direction(x, segment);
}

/* ---- a substep */

void vbss_thread_begin_twist(thread_object *t)
{
    if (thread_has_friction_torque(t)) {
        vbss_thread_list_roll_spans(t);
    } else {
        t->twist_span_count = vbss_thread_count_spans(t);
        for (uint32_t k = 0; k < t->twist_span_count; k++) {
            t->twist_spans[k] = span_between_holders(t, k);
        }
    }
    for (uint32_t k = 0; k < t->twist_span_count; k++) {
        thread_twist_span *span = &t->twist_spans[k];
        for (int end = 0; end < 2; end++) {
            span->director[end] = vec3_any_normal(span->direction[end]);
        }
        span->start_twist = span->shape_twist;
        span->start_angle = angle_between_directors(t->now.x, span);
        for (int end = 0; end < 2; end++) {
            if (span->is_clamped[end]) {
                const vec3 direction = t->holders[span->holder_index[end]].direction;
                span->director[end] =
                    transport_between(span->director[end], span->direction[end], direction);
                span->direction[end] = direction;
            }
        }
    }
}

void vbss_thread_set_twist(const thread_object *t, const vec3 *x, thread_twist_span *span)
{
    const double change = angle_between_directors(x, span) - span->start_angle;
    if (thread_has_friction_torque(t)) {
        span->roll_difference =
            span->held_difference + vbss_thread_contact_roll_difference(t, span);
    }
    span->shape_twist =
        span->start_twist + (change - VBSS_TWO_PI * floor(change / VBSS_TWO_PI + 0.5));
    vbss_thread_set_span_torque(t, span);
}

void vbss_thread_commit_twist(thread_object *t)
{
    const bool has_friction_torque = thread_has_friction_torque(t);
    if (has_friction_torque) {
        vbss_thread_commit_contact_rolls(t);
    }
    for (uint32_t k = 0; k < t->holder_count; k++) {
        const thread_section_holder *holder = &t->holders[k];
        thread_section_frame *frame = &t->now.frames[holder->attachment_index];
        if (k + 1 < t->holder_count && !has_friction_torque) {
            vbss_thread_set_twist(t, t->trial, &t->twist_spans[k]);
            frame->shape_twist = t->twist_spans[k].shape_twist;
        }
        const vec3 direction = vbss_thread_holder_direction(t->trial, t->node_count, holder);
        frame->director = transport_between(frame->director, frame->direction, direction);
        frame->direction = direction;
    }
}

/* ---- views */

static void fill_twists(thread_object *t)
{
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        t->twists[i] = 0.0;
    }
    for (uint32_t i = 0; thread_has_friction_torque(t) && i + 1 < t->node_count; i++) {
        const double *halves = t->now.half_twists + 2 * (size_t)i;
        t->twists[i] = (halves[0] + halves[1]) / t->rest[i];
    }
    for (uint32_t k = 0; !thread_has_friction_torque(t) && k + 1 < t->holder_count; k++) {
        const thread_twist_span span = vbss_thread_twist_span(t, k);
        for (uint32_t i = span.low; i < span.high; i++) {
            t->twists[i] = span.twist / span.length;
        }
    }
}

/* Moves a director from one segment to a neighbour, and turns it by the twist between their middles. */
static vec3 next_director(const thread_object *t, uint32_t from, uint32_t to, vec3 director)
{
    const vec3 before = vbss_thread_chord_direction(t->now.x, from),
               after = vbss_thread_chord_direction(t->now.x, to);
    const uint32_t low = to > from ? from : to;
    const double twist =
        thread_has_friction_torque(t)
            ? t->now.half_twists[2 * (size_t)low + 1] + t->now.half_twists[2 * (size_t)low + 2]
            : 0.5 * (t->twists[from] * t->rest[from] + t->twists[to] * t->rest[to]);
    return roll_director(transport_between(director, before, after), after,
                         to > from ? twist : -twist);
}

/* From the first holder on in both directions; without one from an arbitrary director. */
void vbss_thread_fill_twist_views(thread_object *t)
{
    fill_twists(t);
    const uint32_t segments = t->node_count - 1;
    const uint32_t node = t->holder_count > 0 ? t->holders[0].node : 0;
    const uint32_t first = node < segments ? node : segments - 1;
    const vec3 tangent = vbss_thread_chord_direction(t->now.x, first);
    vec3 director = vec3_any_normal(vec3_unit_or(tangent, vec3_make(1.0, 0.0, 0.0)));
    if (t->holder_count > 0) {
        const thread_section_frame *frame = &t->now.frames[t->holders[0].attachment_index];
        const double half = 0.5 * t->twists[first] * t->rest[first];
        director = roll_director(transport_between(frame->director, frame->direction, tangent),
                                 tangent, t->holders[0].roll + half);
    }
    t->material_directors[first] = director;
    for (uint32_t i = first + 1; i < segments; i++) {
        t->material_directors[i] = next_director(t, i - 1, i, t->material_directors[i - 1]);
    }
    for (uint32_t i = first; i-- > 0;) {
        t->material_directors[i] = next_director(t, i + 1, i, t->material_directors[i + 1]);
    }
}
