/* Spans of twist: parallel transport along the chords, and the twist between two clamps.
 *
 * Clamps carry a director, which moves without spin as their direction changes, and a roll, the angle by
 * which the host has turned them about it. The twist of a span is the roll of its high clamp minus that
 * of its low clamp, plus a part that depends on the shape alone. This part is known up to full turns
 * from the directors, and the state has the turns. */
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

thread_turn vbss_thread_turn(const vec3 *x, const thread_twist_span *span, uint32_t node)
{
    double inverse_before = 0.0, inverse_after = 0.0;
    const vec3 before = node == span->low ? span->direction[0]
                                          : chord_direction(x, node - 1, &inverse_before);
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

vec3 vbss_thread_transport(const vec3 *x, const thread_twist_span *span, vec3 director)
{
    for (uint32_t i = span->low; i <= span->high; i++) {
        const thread_turn turn = vbss_thread_turn(x, span, i);
        director = transport(director, &turn);
    }
    return director;
}

/* Unit, as rounding would add up. */
static vec3 transport_by_clamp(vec3 director, vec3 before, vec3 after)
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

/* Angle from the director of the low clamp, moved along the span, to that of the high clamp. */
static double angle_between_directors(const vec3 *x, const thread_twist_span *span)
{
    const vec3 moved = vbss_thread_transport(x, span, span->director[0]);
    return vbss_arc_tangent(vec3_dot(span->direction[1], vec3_cross(moved, span->director[1])),
                            vec3_dot(moved, span->director[1]));
}

/* ---- spans */

static void set_torque(const thread_object *t, thread_twist_span *span)
{
    span->twist = span->shape_twist + span->roll_difference;
    span->torque =
        t->config.torsional_stiffness * (span->twist / span->length - t->config.rest_twist);
}

thread_twist_span vbss_thread_twist_span(const thread_object *t, uint32_t index)
{
    const thread_clamp *clamps = &t->clamps[index];
    thread_twist_span span = {.low = clamps[0].node, .high = clamps[1].node};
    for (int end = 0; end < 2; end++) {
        const thread_clamp_frame *frame = &t->now.clamp_frames[clamps[end].attachment_index];
        span.direction[end] = frame->direction;
        span.director[end] = frame->director;
    }
    span.length =
        vbss_thread_arc_length(t, clamps[1].node) - vbss_thread_arc_length(t, clamps[0].node);
    span.shape_twist = t->now.clamp_frames[clamps[0].attachment_index].shape_twist;
    span.roll_difference = clamps[1].roll - clamps[0].roll;
    set_torque(t, &span);
    return span;
}

/* ---- clamps that come and go */

/* The nearest clamp on either side of a node; NULL: there is none. */
static const thread_attachment *find_clamp_beside(const thread_object *t, uint32_t node, bool after)
{
    const thread_attachment *found = NULL;
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        const thread_attachment *a = &t->attachments[i];
        const bool is_beside = after ? a->node > node : a->node < node;
        if (a->id != 0 && a->kind == VBSS_THREAD_ATTACHMENT_CLAMP && is_beside &&
            (found == NULL || (after ? a->node < found->node : a->node > found->node))) {
            found = a;
        }
    }
    return found;
}

void vbss_thread_add_twist_clamp(thread_object *t, uint32_t attachment)
{
    const thread_attachment *new = &t->attachments[attachment];
    const thread_attachment *low = find_clamp_beside(t, new->node, false),
                            *high = find_clamp_beside(t, new->node, true);
    thread_clamp_frame *frames = t->now.clamp_frames;
    thread_clamp_frame *frame = &frames[attachment];
    *frame = (thread_clamp_frame){.direction = new->direction,
                                  .director = vec3_any_normal(new->direction)};
    const double here = vbss_thread_arc_length(t, new->node);
    thread_clamp_frame *low_frame = low != NULL ? &frames[low - t->attachments] : NULL;
    double before = 0.0, after = 0.0;
    if (low != NULL && high != NULL) {
        const double from = vbss_thread_arc_length(t, low->node),
                     to = vbss_thread_arc_length(t, high->node);
        const double whole = low_frame->shape_twist + high->roll - low->roll;
        before = whole * ((here - from) / (to - from));
        after = whole - before;
    }
    if (low != NULL) {
        low_frame->shape_twist = before - (new->roll - low->roll);
        const thread_twist_span span = {.low = low->node,
                                        .high = new->node,
                                        .direction = {low_frame->direction, new->direction}};
        const vec3 moved = vbss_thread_transport(t->now.x, &span, low_frame->director);
        frame->director = roll_director(vec3_unit_or(moved, frame->director), new->direction,
                                        low_frame->shape_twist);
    }
    if (high != NULL) {
        frame->shape_twist = after - (high->roll - new->roll);
    }
}

void vbss_thread_remove_twist_clamp(thread_object *t, uint32_t attachment)
{
    const uint32_t node = t->attachments[attachment].node;
    const thread_attachment *low = find_clamp_beside(t, node, false);
    if (low != NULL && find_clamp_beside(t, node, true) != NULL) {
        t->now.clamp_frames[low - t->attachments].shape_twist +=
            t->now.clamp_frames[attachment].shape_twist;
    }
}

/* ---- a substep */

static vec3 trial_director(const thread_object *t, const thread_clamp *clamp)
{
    const thread_clamp_frame *frame = &t->now.clamp_frames[clamp->attachment_index];
    return transport_by_clamp(frame->director, frame->direction, clamp->direction);
}

void vbss_thread_begin_twist(thread_object *t)
{
    for (uint32_t k = 0; k + 1 < t->clamp_count; k++) {
        thread_twist_span *span = &t->twist_spans[k];
        *span = vbss_thread_twist_span(t, k);
        span->start_angle = angle_between_directors(t->now.x, span);
        for (uint32_t end = 0; end < 2; end++) {
            span->director[end] = trial_director(t, &t->clamps[k + end]);
            span->direction[end] = t->clamps[k + end].direction;
        }
        span->start_twist = span->shape_twist;
    }
}

void vbss_thread_set_twist(const thread_object *t, const vec3 *x, thread_twist_span *span)
{
    const double change = angle_between_directors(x, span) - span->start_angle;
    span->shape_twist =
        span->start_twist + (change - VBSS_TWO_PI * floor(change / VBSS_TWO_PI + 0.5));
    set_torque(t, span);
}

void vbss_thread_commit_twist(thread_object *t)
{
    for (uint32_t k = 0; k < t->clamp_count; k++) {
        const thread_clamp *clamp = &t->clamps[k];
        thread_clamp_frame *frame = &t->now.clamp_frames[clamp->attachment_index];
        if (k + 1 < t->clamp_count) {
            vbss_thread_set_twist(t, t->trial, &t->twist_spans[k]);
            frame->shape_twist = t->twist_spans[k].shape_twist;
        }
        frame->director = trial_director(t, clamp);
        frame->direction = clamp->direction;
    }
}

/* ---- views */

/* Index of the span that has a segment; clamp_count if none has. */
static uint32_t span_of(const thread_object *t, uint32_t segment)
{
    for (uint32_t k = 0; k + 1 < t->clamp_count; k++) {
        if (t->clamps[k].node <= segment && segment < t->clamps[k + 1].node) {
            return k;
        }
    }
    return t->clamp_count;
}

static void fill_twists(thread_object *t)
{
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        const uint32_t k = span_of(t, i);
        t->twists[i] = 0.0;
        if (k < t->clamp_count) {
            const thread_twist_span span = vbss_thread_twist_span(t, k);
            t->twists[i] = span.twist / span.length;
        }
    }
}

/* Moves a director from one segment to a neighbour, and turns it by the twist between their middles. */
static vec3 next_director(const thread_object *t, uint32_t from, uint32_t to, vec3 director)
{
    double ignored;
    const vec3 before = chord_direction(t->now.x, from, &ignored),
               after = chord_direction(t->now.x, to, &ignored);
    const double twist = 0.5 * (t->twists[from] * t->rest[from] + t->twists[to] * t->rest[to]);
    return roll_director(transport_by_clamp(director, before, after), after,
                         to > from ? twist : -twist);
}

/* From the first clamp on in both directions; without a clamp from an arbitrary director. */
void vbss_thread_fill_twist_views(thread_object *t)
{
    fill_twists(t);
    const uint32_t segments = t->node_count - 1;
    const bool has_clamp = t->clamp_count > 0;
    const uint32_t node = has_clamp ? t->clamps[0].node : 0;
    const uint32_t first = node < segments ? node : segments - 1;
    double ignored;
    const vec3 tangent = chord_direction(t->now.x, first, &ignored);
    vec3 director = vec3_any_normal(vec3_unit_or(tangent, vec3_make(1.0, 0.0, 0.0)));
    if (has_clamp) {
        const thread_clamp_frame *frame = &t->now.clamp_frames[t->clamps[0].attachment_index];
        const double half = 0.5 * t->twists[first] * t->rest[first];
        director = roll_director(transport_by_clamp(frame->director, frame->direction, tangent),
                                 tangent, t->clamps[0].roll + half);
    }
    t->material_directors[first] = director;
    for (uint32_t i = first + 1; i < segments; i++) {
        t->material_directors[i] = next_director(t, i - 1, i, t->material_directors[i - 1]);
    }
    for (uint32_t i = first; i-- > 0;) {
        t->material_directors[i] = next_director(t, i + 1, i, t->material_directors[i + 1]);
    }
}
