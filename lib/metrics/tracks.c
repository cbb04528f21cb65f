/* Ticks of one tool from its samples.
 *
 * A run is an interval in which the tool was seen without a gap. Fine samples of its curve pass
 * through a ring buffer; a tick is computed as soon as the filter has enough samples after it. When
 * the run ends, the ticks that wait are computed from the samples that are there (run_ends.c). */
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

static bool is_full(const metrics_object *m, const metrics_hand *h)
{
    return h->tick_count >= m->tick_capacity;
}

/* Fine sample at the next tick. */
static uint64_t next_centre(const metrics_hand *h)
{
    return (uint64_t)h->tick_count * METRICS_FINE_PER_TICK;
}

static void add_unseen_tick(metrics_hand *h)
{
    uint32_t tick = h->tick_count++;
    h->seen[tick] = 0;
    h->speed[tick] = h->jerk[tick] = 0.0;
}

static void add_seen_tick(metrics_object *m, metrics_hand *h)
{
    uint64_t centre = next_centre(h);
    uint32_t tick = h->tick_count++;
    bool has_before = centre >= h->run_start + METRICS_KERNEL_HALF_WIDTH;
    bool has_after = h->next_fine > centre + METRICS_KERNEL_HALF_WIDTH;
    h->seen[tick] = 1;
    h->speed[tick] = h->jerk[tick] = 0.0;
    if (h->still_count > 2 * METRICS_KERNEL_HALF_WIDTH) {
        return;
    }
    if (has_before && has_after) {
        vbss_metrics_differentiate(m->kernel, h->ring, centre, &h->speed[tick], &h->jerk[tick]);
    } else {
        vbss_metrics_differentiate_end(h, centre, &h->speed[tick], &h->jerk[tick]);
    }
}

static void push_fine_sample(metrics_object *m, metrics_hand *h, vec3 position)
{
    vec3 last = h->ring[(h->next_fine + METRICS_RING_SIZE - 1) % METRICS_RING_SIZE];
    h->still_count = !is_same_position(position, last)    ? 1u
                     : h->still_count < METRICS_RING_SIZE ? h->still_count + 1u
                                                          : h->still_count;
    h->ring[h->next_fine % METRICS_RING_SIZE] = position;
    h->next_fine++;
    if (h->next_fine > next_centre(h) + METRICS_KERNEL_HALF_WIDTH) {
        add_seen_tick(m, h);
    }
}

/* ---- curve */

static void sample_segment(metrics_object *m, metrics_hand *h, const metrics_segment *segment)
{
    for (;;) {
        double time = fine_time(m, h->next_fine);
        if (is_full(m, h) || time >= segment->end_time) {
            return;
        }
        push_fine_sample(m, h,
                         vbss_metrics_segment_at(segment, vbss_max(time, segment->start_time)));
    }
}

/* Velocity at one end of a parabola, given that of its chord and that at the other end. */
static vec3 opposite_velocity(vec3 chord_velocity, vec3 velocity)
{
    return vec3_sub(vec3_scale(chord_velocity, 2.0), velocity);
}

/* Samples the segment between the last two points. Its end velocity is the given one, or follows
 * from the parabola through the last three points. */
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
    segment.start_velocity = a > 0 ? vbss_metrics_middle_velocity(h->time, h->position)
                             : end_velocity != NULL
                                 ? opposite_velocity(chord_velocity, *end_velocity)
                                 : chord_velocity;
    segment.end_velocity = end_velocity != NULL
                               ? *end_velocity
                               : opposite_velocity(chord_velocity, segment.start_velocity);
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

/* ---- runs */

/* The tool was not seen since the last run. */
static void begin_run(metrics_object *m, metrics_hand *h, double time, vec3 position)
{
    uint64_t limit = m->tick_capacity * METRICS_FINE_PER_TICK;
    h->run_start = h->next_fine = first_not_before(m, time, METRICS_FINE_RATE, limit);
    h->still_count = 0;
    while (!is_full(m, h) && next_centre(h) < h->run_start) {
        add_unseen_tick(h);
    }
    h->point_count = 0;
    h->has_outlier = 0;
    push_point(h, time, position);
}

static void end_run(metrics_object *m, metrics_hand *h)
{
    double end = h->time[h->point_count - 1];
    sample_last_segment(m, h, NULL);
    if (!is_full(m, h) && fine_time(m, h->next_fine) <= end) {
        push_fine_sample(m, h, h->position[h->point_count - 1]);
    }
    while (!is_full(m, h) && next_centre(h) < h->next_fine) {
        add_seen_tick(m, h);
    }
}

void vbss_metrics_track_position(metrics_object *m, uint32_t hand, double time, vec3 position)
{
    metrics_hand *h = &m->hands[hand];
    if (h->point_count == 0) {
        begin_run(m, h, time, position);
        return;
    }
    uint32_t last = h->point_count - 1;
    bool is_outlier = vbss_metrics_is_outlier(&m->config, h, time, position);
    if (time - h->time[last] > METRICS_MAX_SAMPLE_GAP) {
        h->jump_count += is_outlier && h->has_outlier != 0;
        end_run(m, h);
        begin_run(m, h, time, position);
        return;
    }
    if (is_outlier) {
        vbss_metrics_keep_outlier(h, time, position);
        return;
    }
    h->has_outlier = 0;
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
    if (m->hands[hand].point_count > 0) {
        end_run(m, &m->hands[hand]);
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
