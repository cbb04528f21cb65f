/* Ticks of one tool from its samples. Fine samples of its curve pass through a ring buffer; a tick
 * is computed as soon as the filter has enough samples on both sides. */
#include "metrics/metrics.h"

/* Compares the bits on purpose: a tool that is held still has exactly no motion. */
static bool is_same_position(vec3 a, vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static double fine_time(const metrics_object *m, uint64_t fine)
{
    return m->origin_time + (double)fine / METRICS_FINE_RATE;
}

/* First index of a grid at or after a time, at most `limit`. */
static uint64_t first_not_before(const metrics_object *m, double time, double rate, uint64_t limit)
{
    double grid_index = ceil((time - m->origin_time) * rate);
    return grid_index <= 0.0 ? 0 : grid_index >= (double)limit ? limit : (uint64_t)grid_index;
}

uint64_t vbss_metrics_tick_from(const metrics_object *m, double time)
{
    return first_not_before(m, time, METRICS_TICK_RATE, m->tick_capacity);
}

uint64_t vbss_metrics_ticks_lost(const metrics_object *m)
{
    double all = floor((m->sample_time - m->origin_time) * METRICS_TICK_RATE) + 1.0;
    double capacity = (double)m->tick_capacity;
    return m->has_sample && all > capacity ? (uint64_t)(all - capacity) : 0;
}

/* ---- ticks */

static void add_tick(metrics_object *m, metrics_hand *h)
{
    uint32_t tick = h->tick_count++;
    uint64_t centre = (uint64_t)tick * METRICS_FINE_PER_TICK;
    h->seen[tick] = h->ring_seen[centre % METRICS_RING_SIZE];
    h->speed[tick] = h->jerk[tick] = 0.0;
    if (h->seen[tick] != 0 && h->still_count <= 2 * METRICS_KERNEL_HALF_WIDTH) {
        vbss_metrics_differentiate(m->kernel, h->ring, centre, &h->speed[tick], &h->jerk[tick]);
    }
}

static bool is_full(const metrics_object *m, const metrics_hand *h)
{
    return h->tick_count >= m->tick_capacity;
}

static void push_fine_sample(metrics_object *m, metrics_hand *h, vec3 position, bool seen)
{
    vec3 last = h->ring[(h->next_fine + METRICS_RING_SIZE - 1) % METRICS_RING_SIZE];
    h->still_count = !is_same_position(position, last)    ? 1u
                     : h->still_count < METRICS_RING_SIZE ? h->still_count + 1u
                                                          : h->still_count;
    h->ring[h->next_fine % METRICS_RING_SIZE] = position;
    h->ring_seen[h->next_fine % METRICS_RING_SIZE] = seen;
    h->next_fine++;
    if (h->next_fine >
        (uint64_t)h->tick_count * METRICS_FINE_PER_TICK + METRICS_KERNEL_HALF_WIDTH) {
        add_tick(m, h);
    }
}

/* ---- curve */

/* Adds fine samples up to a time at the last position, marked as not seen. */
static void extend_unseen(metrics_object *m, metrics_hand *h, double until)
{
    vec3 position = h->position[h->point_count - 1];
    while (!is_full(m, h) && fine_time(m, h->next_fine) < until) {
        push_fine_sample(m, h, position, false);
    }
}

static void sample_segment(metrics_object *m, metrics_hand *h, const metrics_segment *segment)
{
    for (;;) {
        double time = fine_time(m, h->next_fine);
        if (is_full(m, h) || time >= segment->end_time) {
            return;
        }
        push_fine_sample(
            m, h, vbss_metrics_segment_at(segment, vbss_max(time, segment->start_time)), true);
    }
}

/* Samples the segment between the last two points. Its end velocity is the given one, or that of
 * the chord. */
static void sample_last_segment(metrics_object *m, metrics_hand *h, const vec3 *end_velocity)
{
    uint32_t b = h->point_count - 1, a = b - 1;
    if (h->point_count < 2) {
        return;
    }
    metrics_segment segment = {h->time[a],     h->time[b],  h->position[a],
                               h->position[b], vec3_zero(), vec3_zero()};
    vec3 chord_velocity = vec3_scale(vec3_sub(segment.end, segment.start),
                                     1.0 / (segment.end_time - segment.start_time));
    segment.start_velocity =
        a == 0 ? chord_velocity : vbss_metrics_middle_velocity(h->time, h->position);
    segment.end_velocity = end_velocity != NULL ? *end_velocity : chord_velocity;
    sample_segment(m, h, &segment);
}

static void push_point(metrics_hand *h, double time, vec3 position)
{
    if (h->point_count == 3) {
        for (int i = 0; i < 2; i++) {
            h->time[i] = h->time[i + 1];
            h->position[i] = h->position[i + 1];
        }
        h->point_count = 2;
    }
    h->time[h->point_count] = time;
    h->position[h->point_count++] = position;
}

/* Before its first sample, a tool rests at that position and is not seen. */
static void begin_track(metrics_object *m, metrics_hand *h, double time, vec3 position)
{
    uint64_t limit = m->tick_capacity * METRICS_FINE_PER_TICK;
    h->next_fine = first_not_before(m, time, METRICS_FINE_RATE, limit);
    h->still_count = METRICS_RING_SIZE;
    for (int i = 0; i < METRICS_RING_SIZE; i++) {
        h->ring[i] = position;
        h->ring_seen[i] = 0;
    }
    uint64_t ticks = (h->next_fine + METRICS_FINE_PER_TICK - 1) / METRICS_FINE_PER_TICK;
    while (h->tick_count < ticks) {
        uint32_t tick = h->tick_count++;
        h->seen[tick] = 0;
        h->speed[tick] = h->jerk[tick] = 0.0;
    }
    push_point(h, time, position);
}

void vbss_metrics_track_position(metrics_object *m, uint32_t hand, double time, vec3 position)
{
    metrics_hand *h = &m->hands[hand];
    if (h->point_count == 0) {
        begin_track(m, h, time, position);
        return;
    }
    uint32_t last = h->point_count - 1;
    if (time - h->time[last] > METRICS_MAX_SAMPLE_GAP) {
        vec3 last_position = h->position[last];
        sample_last_segment(m, h, NULL);
        extend_unseen(m, h, time);
        h->offset = vec3_sub(last_position, position);
        h->point_count = 0;
        push_point(h, time, last_position);
        return;
    }
    position = vec3_add(position, h->offset);
    if (h->point_count > 1) {
        const double times[3] = {h->time[last - 1], h->time[last], time};
        const vec3 positions[3] = {h->position[last - 1], h->position[last], position};
        vec3 velocity = vbss_metrics_middle_velocity(times, positions);
        sample_last_segment(m, h, &velocity);
    }
    push_point(h, time, position);
}

void vbss_metrics_finish_track(metrics_object *m, uint32_t hand)
{
    metrics_hand *h = &m->hands[hand];
    if (h->point_count == 0) {
        return;
    }
    double end = h->time[h->point_count - 1];
    vec3 position = h->position[h->point_count - 1];
    sample_last_segment(m, h, NULL);
    if (!is_full(m, h) && fine_time(m, h->next_fine) <= end) {
        push_fine_sample(m, h, position, true);
    }
    uint64_t known = h->next_fine;
    while (!is_full(m, h) && (uint64_t)h->tick_count * METRICS_FINE_PER_TICK < known) {
        push_fine_sample(m, h, position, false);
    }
}

/* ---- forces: the magnitude is linear between two samples, and its integral is distributed to the
 * ticks */

static void add_force(metrics_hand *h, uint32_t tick, double impulse, double peak)
{
    while (h->force_count <= tick) {
        h->impulse[h->force_count] = h->peak[h->force_count] = 0.0;
        h->force_count++;
    }
    h->impulse[tick] += impulse;
    h->peak[tick] = vbss_max(h->peak[tick], peak);
}

/* The last tick at or before a time. Returns false if it is beyond the capacity. */
static bool find_tick(const metrics_object *m, double time, uint32_t *tick)
{
    double grid_index = floor((time - m->origin_time) * METRICS_TICK_RATE);
    if (grid_index >= (double)m->tick_capacity) {
        return false;
    }
    *tick = grid_index > 0.0 ? (uint32_t)grid_index : 0u;
    return true;
}

static void distribute_impulse(metrics_object *m, metrics_hand *h, double time, double force)
{
    uint32_t from = 0, to = 0;
    double begin = h->force_time, rise = (force - h->force) / (time - begin);
    if (!find_tick(m, begin, &from)) {
        return;
    }
    if (!find_tick(m, time, &to)) {
        to = (uint32_t)m->tick_capacity - 1u;
    }
    for (uint32_t tick = from; tick <= to; tick++) {
        double next = m->origin_time + (tick + 1.0) / METRICS_TICK_RATE;
        double end = tick == to ? vbss_min(time, vbss_max(next, begin)) : vbss_min(next, time);
        double width = vbss_max(end - begin, 0.0);
        double middle = h->force + rise * (0.5 * (begin + end) - h->force_time);
        add_force(h, tick, width * vbss_max(middle, 0.0), 0.0);
        begin = vbss_max(end, begin);
    }
}

void vbss_metrics_track_force(metrics_object *m, uint32_t hand, double time, double force)
{
    metrics_hand *h = &m->hands[hand];
    uint32_t tick = 0;
    if (h->has_force && time - h->force_time <= METRICS_MAX_SAMPLE_GAP) {
        distribute_impulse(m, h, time, force);
    }
    if (find_tick(m, time, &tick)) {
        add_force(h, tick, 0.0, force);
    }
    h->has_force = 1;
    h->force_time = time;
    h->force = force;
}
