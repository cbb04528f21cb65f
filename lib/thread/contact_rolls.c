/* Friction torque: contacts of a scene resist roll of the thread.
 *
 * The roll of each segment that a contact touches is an unknown of the substep. The middle of such a
 * segment ends a span, as a holder does at its node, so the torque may differ on either side of it.
 * Rolls count from the start of the substep; what stays is the twist of both halves of each segment,
 * from which the next substep sums up the twist of its own spans. A half belongs to one span only, as the
 * middle and the ends of a segment are the only places where a span can end. */
#include "thread/tuning.h"
#include "thread/twist.h"

#include <string.h>

/* ---- ends of spans */

/* A holder at its node, or the middle of a segment. */
typedef struct span_end {
    bool is_holder;
    uint32_t index; /* of the holder or the segment */
} span_end;

/* Number of the halves of segments before an end. */
static size_t halves_before(const thread_object *t, span_end end)
{
    return end.is_holder ? 2 * (size_t)t->holders[end.index].node : 2 * (size_t)end.index + 1;
}

static double arc_length_of(const thread_object *t, span_end end)
{
    return end.is_holder ? vbss_thread_arc_length(t, t->holders[end.index].node)
                         : vbss_thread_arc_length(t, end.index) + 0.5 * t->rest[end.index];
}

static thread_twist_span make_span(const thread_object *t, span_end low, span_end high)
{
    const span_end ends[2] = {low, high};
    thread_twist_span span = {.low = low.index, .high = high.index + 1};
    for (int k = 0; k < 2; k++) {
        span.roll_segment[k] = ends[k].is_holder ? THREAD_NO_ROLL : ends[k].index;
        if (ends[k].is_holder) {
            const thread_section_holder *holder = &t->holders[ends[k].index];
            *(k == 0 ? &span.low : &span.high) = holder->node;
            span.holder_index[k] = ends[k].index;
            span.is_clamped[k] = holder->is_clamp;
        }
    }
    for (int k = 0; k < 2; k++) {
        span.direction[k] =
            span.is_clamped[k]
                ? t->now.frames[t->holders[ends[k].index].attachment_index].direction
                : vbss_thread_chord_direction(t->now.x, k == 0 ? span.low : span.high - 1);
    }
    span.length = arc_length_of(t, high) - arc_length_of(t, low);
    for (size_t i = halves_before(t, low); i < halves_before(t, high); i++) {
        span.shape_twist += t->now.half_twists[i];
    }
    return span;
}

/* ---- spans of the current state */

uint32_t vbss_thread_count_fine_spans(const thread_object *t)
{
    return t->holder_count + t->node_count - 2;
}

static span_end end_at(const thread_object *t, uint32_t index)
{
    uint32_t holders = 0;
    for (; holders < t->holder_count && t->holders[holders].node + holders <= index; holders++) {
        if (t->holders[holders].node + holders == index) {
            return (span_end){true, holders};
        }
    }
    return (span_end){false, index - holders};
}

thread_twist_span vbss_thread_fine_span(const thread_object *t, uint32_t index)
{
    thread_twist_span span = make_span(t, end_at(t, index), end_at(t, index + 1));
    vbss_thread_set_span_torque(t, &span);
    return span;
}

double vbss_thread_distance_to_torque(const thread_object *t, uint32_t node, bool after,
                                      double largest)
{
    const double *halves = t->now.half_twists;
    const uint32_t segments = t->node_count - 1;
    double distance = 0.0, before = 0.0;
    for (uint32_t k = 0; after ? node + k < segments : k < node; k++) {
        const uint32_t i = after ? node + k : node - 1 - k;
        const double near = halves[2 * (size_t)i + (after ? 0 : 1)] / t->rest[i],
                     far = halves[2 * (size_t)i + (after ? 1 : 0)] / t->rest[i];
        const double tolerance = THREAD_TORQUE_CHANGE * (fabs(near) + fabs(far));
        if (k > 0 && fabs(near - before) > tolerance) {
            return distance;
        }
        distance += 0.5 * t->rest[i];
        if (fabs(far - near) > tolerance) {
            return distance;
        }
        distance += 0.5 * t->rest[i];
        before = far;
        if (largest > 0.0 && distance >= largest) {
            return largest;
        }
    }
    return largest;
}

/* ---- spans of a substep */

void vbss_thread_clear_contact_rolls(thread_object *t)
{
    memset(t->has_roll, 0, t->node_capacity * sizeof *t->has_roll);
    memset(t->roll_angles, 0, t->node_capacity * sizeof *t->roll_angles);
    memset(t->is_span_exact, 0,
           ((size_t)t->node_capacity + t->config.attachment_capacity) * sizeof *t->is_span_exact);
    t->roll_count = 0;
}

void vbss_thread_add_contact_roll(thread_object *t, uint32_t segment)
{
    t->roll_count += t->has_roll[segment] == 0;
    t->has_roll[segment] = 1;
}

/* How far the holder rolls in the substep, rad. */
static double held_roll(const thread_object *t, const thread_twist_span *span, int end)
{
    if (span->roll_segment[end] != THREAD_NO_ROLL) {
        return 0.0;
    }
    const thread_section_holder *holder = &t->holders[span->holder_index[end]];
    return holder->roll - t->now.held_rolls[holder->attachment_index];
}

/* Adds the span from the last end to this one. */
static void end_span(thread_object *t, span_end *last, bool *has_last, span_end end)
{
    if (*has_last) {
        thread_twist_span *span = &t->twist_spans[t->twist_span_count++];
        *span = make_span(t, *last, end);
        span->held_difference = held_roll(t, span, 1) - held_roll(t, span, 0);
        span->roll_difference =
            span->held_difference + vbss_thread_contact_roll_difference(t, span);
        vbss_thread_set_span_torque(t, span);
    }
    *last = end;
    *has_last = true;
}

void vbss_thread_list_roll_spans(thread_object *t)
{
    span_end last = {false, 0};
    bool has_last = false;
    uint32_t holder = 0;
    t->twist_span_count = 0;
    for (uint32_t i = 0; i < t->node_count; i++) {
        if (holder < t->holder_count && t->holders[holder].node == i) {
            end_span(t, &last, &has_last, (span_end){true, holder++});
        }
        if (i + 1 < t->node_count && t->has_roll[i] != 0) {
            end_span(t, &last, &has_last, (span_end){false, i});
        }
    }
}

double vbss_thread_contact_roll_difference(const thread_object *t, const thread_twist_span *span)
{
    const uint32_t low = span->roll_segment[0], high = span->roll_segment[1];
    return (high != THREAD_NO_ROLL ? t->roll_angles[high] : 0.0) -
           (low != THREAD_NO_ROLL ? t->roll_angles[low] : 0.0);
}

/* ---- commit */

static void set_halves(thread_object *t, size_t first, size_t end, double twist_per_length)
{
    for (size_t i = first; i < end; i++) {
        t->now.half_twists[i] = twist_per_length * 0.5 * t->rest[i / 2];
    }
}

/* Halves of segments before an end of a span. */
static size_t halves_before_end(const thread_twist_span *span, int end)
{
    return span->roll_segment[end] != THREAD_NO_ROLL
               ? 2 * (size_t)span->roll_segment[end] + 1
               : 2 * (size_t)(end == 0 ? span->low : span->high);
}

void vbss_thread_commit_contact_rolls(thread_object *t)
{
    const size_t all = 2 * (size_t)(t->node_count - 1);
    size_t done = 0;
    for (uint32_t k = 0; k < t->twist_span_count; k++) {
        thread_twist_span *span = &t->twist_spans[k];
        const size_t first = halves_before_end(span, 0), end = halves_before_end(span, 1);
        vbss_thread_set_twist(t, t->trial, span);
        /* No torque acts before the first end, and after the last. */
        set_halves(t, done, first, t->config.rest_twist);
        set_halves(t, first, end, span->twist / span->length);
        done = end;
    }
    set_halves(t, done, all, t->config.rest_twist);
    for (uint32_t k = 0; k < t->holder_count; k++) {
        t->now.held_rolls[t->holders[k].attachment_index] = t->holders[k].roll;
    }
}
