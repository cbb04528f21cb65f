/* From the samples of one tool to its ticks: fine samples of its curve pass through a ring, and whenever the filter has
 * what it needs on both sides, a tick is known. */
#include "metrics/metrics.h"

/* Comparing to the bit is meant: a tool that was held still has no motion at all. */
static bool same_place(vec3 a, vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static double fine_time(const metrics_object *m, uint64_t fine)
{
    return m->origin + (double)fine / METRICS_FINE_RATE;
}

/* The first sample of a grid not before a time, at most `most`. */
static uint64_t first_not_before(const metrics_object *m, double time, double rate, uint64_t most)
{
    double place = ceil((time - m->origin) * rate);
    return place <= 0.0 ? 0 : place >= (double)most ? most : (uint64_t)place;
}

uint64_t vbss_metrics_tick_of(const metrics_object *m, double time)
{
    return first_not_before(m, time, METRICS_TICK_RATE, m->tick_capacity);
}

uint64_t vbss_metrics_ticks_lost(const metrics_object *m)
{
    double all = floor((m->sample_time - m->origin) * METRICS_TICK_RATE) + 1.0;
    double room = (double)m->tick_capacity;
    return m->sampled && all > room ? (uint64_t)(all - room) : 0;
}

/* ---- ticks */

static void add_tick(metrics_object *m, metrics_hand *h)
{
    uint32_t tick = h->tick_count++;
    uint64_t centre = (uint64_t)tick * METRICS_FINE_PER_TICK;
    h->seen[tick] = h->was_seen[centre % METRICS_RING];
    h->speed[tick] = h->jerk[tick] = 0.0;
    if (h->seen[tick] != 0 && h->still <= 2 * METRICS_REACH) {
        vbss_metrics_differentiate(m->kernel, h->ring, centre, &h->speed[tick], &h->jerk[tick]);
    }
}

static bool is_full(const metrics_object *m, const metrics_hand *h)
{
    return h->tick_count >= m->tick_capacity;
}

static void push(metrics_object *m, metrics_hand *h, vec3 place, bool seen)
{
    vec3 last = h->ring[(h->fine + METRICS_RING - 1) % METRICS_RING];
    h->still = !same_place(place, last) ? 1u : h->still < METRICS_RING ? h->still + 1u : h->still;
    h->ring[h->fine % METRICS_RING] = place;
    h->was_seen[h->fine % METRICS_RING] = seen;
    h->fine++;
    if (h->fine > (uint64_t)h->tick_count * METRICS_FINE_PER_TICK + METRICS_REACH) {
        add_tick(m, h);
    }
}

/* ---- the curve */

/* Fine samples from where it stands until before a time, in a place where it is not seen. */
static void hold(metrics_object *m, metrics_hand *h, double until)
{
    vec3 place = h->at[h->points - 1];
    while (!is_full(m, h) && fine_time(m, h->fine) < until) {
        push(m, h, place, false);
    }
}

static void follow(metrics_object *m, metrics_hand *h, const metrics_cell *cell)
{
    for (;;) {
        double time = fine_time(m, h->fine);
        if (is_full(m, h) || time >= cell->end) {
            return;
        }
        push(m, h, vbss_metrics_cell_at(cell, vbss_max(time, cell->begin)), true);
    }
}

/* The stretch between the last two samples; the slope at its end is that to what comes next, or its own. */
static void follow_last(metrics_object *m, metrics_hand *h, const vec3 *end_slope)
{
    uint32_t b = h->points - 1, a = b - 1;
    if (h->points < 2) {
        return;
    }
    metrics_cell cell = {h->time[a], h->time[b], h->at[a], h->at[b], vec3_zero(), vec3_zero()};
    vec3 chord = vec3_scale(vec3_sub(cell.to, cell.from), 1.0 / (cell.end - cell.begin));
    cell.from_slope = a == 0 ? chord : vbss_metrics_slope(h->time, h->at);
    cell.to_slope = end_slope != NULL ? *end_slope : chord;
    follow(m, h, &cell);
}

static void keep(metrics_hand *h, double time, vec3 place)
{
    if (h->points == 3) {
        for (int i = 0; i < 2; i++) {
            h->time[i] = h->time[i + 1];
            h->at[i] = h->at[i + 1];
        }
        h->points = 2;
    }
    h->time[h->points] = time;
    h->at[h->points++] = place;
}

/* Before it is seen first it stands where it will be seen. */
static void begin_track(metrics_object *m, metrics_hand *h, double time, vec3 place)
{
    uint64_t most = m->tick_capacity * METRICS_FINE_PER_TICK;
    h->fine = first_not_before(m, time, METRICS_FINE_RATE, most);
    h->still = METRICS_RING;
    for (int i = 0; i < METRICS_RING; i++) {
        h->ring[i] = place;
        h->was_seen[i] = 0;
    }
    uint64_t ticks = (h->fine + METRICS_FINE_PER_TICK - 1) / METRICS_FINE_PER_TICK;
    while (h->tick_count < ticks) {
        uint32_t tick = h->tick_count++;
        h->seen[tick] = 0;
        h->speed[tick] = h->jerk[tick] = 0.0;
    }
    keep(h, time, place);
}

void vbss_metrics_move_hand(metrics_object *m, uint32_t which, double time, vec3 place)
{
    metrics_hand *h = &m->hands[which];
    if (h->points == 0) {
        begin_track(m, h, time, place);
        return;
    }
    uint32_t last = h->points - 1;
    if (time - h->time[last] > METRICS_UNSEEN) {
        vec3 stood = h->at[last];
        follow_last(m, h, NULL);
        hold(m, h, time);
        h->shift = vec3_sub(stood, place);
        h->points = 0;
        keep(h, time, stood);
        return;
    }
    place = vec3_add(place, h->shift);
    if (h->points > 1) {
        const double times[3] = {h->time[last - 1], h->time[last], time};
        const vec3 places[3] = {h->at[last - 1], h->at[last], place};
        vec3 slope = vbss_metrics_slope(times, places);
        follow_last(m, h, &slope);
    }
    keep(h, time, place);
}

void vbss_metrics_end_hand(metrics_object *m, uint32_t which)
{
    metrics_hand *h = &m->hands[which];
    if (h->points == 0) {
        return;
    }
    double end = h->time[h->points - 1];
    vec3 place = h->at[h->points - 1];
    follow_last(m, h, NULL);
    if (!is_full(m, h) && fine_time(m, h->fine) <= end) {
        push(m, h, place, true);
    }
    uint64_t known = h->fine;
    while (!is_full(m, h) && (uint64_t)h->tick_count * METRICS_FINE_PER_TICK < known) {
        push(m, h, place, false);
    }
}

/* ---- forces: the magnitude is straight between two samples, and is shared out to the ticks it goes through */

static void add_force(metrics_hand *h, uint32_t tick, double impulse, double peak)
{
    while (h->force_count <= tick) {
        h->impulse[h->force_count] = h->peak[h->force_count] = 0.0;
        h->force_count++;
    }
    h->impulse[tick] += impulse;
    h->peak[tick] = vbss_max(h->peak[tick], peak);
}

/* The tick that a time lies after, or false: there is no room. */
static bool find_tick(const metrics_object *m, double time, uint32_t *tick)
{
    double place = floor((time - m->origin) * METRICS_TICK_RATE);
    if (place >= (double)m->tick_capacity) {
        return false;
    }
    *tick = place > 0.0 ? (uint32_t)place : 0u;
    return true;
}

static void share_out(metrics_object *m, metrics_hand *h, double time, double force)
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
        double next = m->origin + (tick + 1.0) / METRICS_TICK_RATE;
        double end = tick == to ? vbss_min(time, vbss_max(next, begin)) : vbss_min(next, time);
        double width = vbss_max(end - begin, 0.0);
        double middle = h->force + rise * (0.5 * (begin + end) - h->force_time);
        add_force(h, tick, width * vbss_max(middle, 0.0), 0.0);
        begin = vbss_max(end, begin);
    }
}

void vbss_metrics_load_hand(metrics_object *m, uint32_t which, double time, double force)
{
    metrics_hand *h = &m->hands[which];
    uint32_t tick = 0;
    if (h->force_known && time - h->force_time <= METRICS_UNSEEN) {
        share_out(m, h, time, force);
    }
    if (find_tick(m, time, &tick)) {
        add_force(h, tick, 0.0, force);
    }
    h->force_known = 1;
    h->force_time = time;
    h->force = force;
}
