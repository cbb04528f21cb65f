/* Remeshing: inserts and removes nodes. This file renumbers and keeps momentum; remesh_window.c
 * moves the neighbours. */
#include "thread/remesh.h"
#include "thread/tuning.h"

#include <string.h>

/* ---- momentum */

typedef struct momentum_sum {
    vec3 linear, angular; /* about a given point */
} momentum_sum;

static momentum_sum sum_momentum(const thread_object *t, vec3 about)
{
    momentum_sum s = {vec3_zero(), vec3_zero()};
    for (uint32_t i = 0; i < t->node_count; i++) {
        vec3 p = vec3_scale(t->now.v[i], t->mass[i]);
        s.linear = vec3_add(s.linear, p);
        s.angular = vec3_add(s.angular, vec3_cross(vec3_sub(t->now.x[i], about), p));
    }
    return s;
}

static void apply_impulse(thread_object *t, uint32_t node, vec3 impulse)
{
    t->now.v[node] = vec3_add_scaled(t->now.v[node], 1.0 / t->mass[node], impulse);
}

/* Restores the angular momentum by a couple on two nodes, except along the line through them. */
static void restore_angular_momentum(thread_object *t, uint32_t a, uint32_t b,
                                     const momentum_sum *before, vec3 about)
{
    momentum_sum after = sum_momentum(t, about);
    vec3 e = vec3_sub(t->now.x[b], t->now.x[a]);
    double square = vec3_norm_squared(e);
    if (square > 0.0) {
        vec3 deficit = vec3_sub(before->angular, after.angular);
        vec3 impulse = vec3_scale(vec3_cross(deficit, e), 1.0 / square);
        apply_impulse(t, a, vec3_neg(impulse));
        apply_impulse(t, b, impulse);
    }
}

/* ---- renumbering */

static void shift(void *array, size_t size, uint32_t from, uint32_t to, uint32_t count)
{
    char *bytes = array;
    memmove(bytes + to * size, bytes + from * size, count * size);
}

/* Moves nodes from `from` on to `to`, with the segments that start at them. */
static void shift_nodes(thread_object *t, uint32_t from, uint32_t to)
{
    uint32_t count = t->node_count - from;
    shift(t->now.x, sizeof(vec3), from, to, count);
    shift(t->now.v, sizeof(vec3), from, to, count);
    shift(t->now.a, sizeof(vec3), from, to, count);
    shift(t->now.q, sizeof(vec3), from, to, count);
    shift(t->now.tension, sizeof(double), from, to, count - 1);
    shift(t->rest, sizeof(double), from, to, count - 1);
    shift(t->welded, sizeof *t->welded, from, to, count);
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        thread_attachment *a = &t->attachments[i];
        if (a->id != 0 && a->node >= from) {
            a->node += to - from;
        }
    }
    t->node_count = t->node_count + to - from;
}

static void finish_remesh(thread_object *t)
{
    t->is_derived_valid = t->is_sparsity_valid = false;
    t->generation++;
}

/* ---- window */

static void store_positions(thread_object *t, const remesh_window *w)
{
    memcpy(t->now.x + w->first_node, w->x, w->count * sizeof *w->x);
}

/* Marks nodes low .. high as movable, except the two at each end of the window that is not an end
 * of the thread. */
static void set_movable(remesh_window *w, uint32_t low, uint32_t high)
{
    for (uint32_t k = low; k <= high && k < w->count; k++) {
        w->is_movable[k] =
            (k > 1 || w->has_thread_start) && (k + 2 < w->count || w->has_thread_end);
    }
}

/* Vector from the middle of a segment's arc to that of its chord, from the curvatures at
 * both ends. */
static vec3 sagitta_vector(const thread_object *t, uint32_t segment)
{
    double l = t->rest[segment];
    vec3 curvature_sum = vec3_add(vbss_thread_curvature(t, t->now.x, segment),
                                  vbss_thread_curvature(t, t->now.x, segment + 1));
    return vec3_scale(curvature_sum, l * l / 16.0);
}

/* ---- insertion */

static void insert_window_node(remesh_window *w, uint32_t at, vec3 x)
{
    for (uint32_t k = w->count; k > at; k--) {
        w->x[k] = w->x[k - 1];
    }
    for (uint32_t k = w->count - 1; k >= at; k--) {
        w->rest[k] = w->rest[k - 1];
        w->elongation[k] = w->elongation[k - 1];
    }
    w->x[at] = x;
    w->rest[at] = w->rest[at - 1] *= 0.5;
    w->elongation[at] = w->elongation[at - 1] *= 0.5;
    w->count++;
}

/* Moves the new node to the arc and projects the window. False: nodes would move farther
 * than `max_displacement`. */
static bool move_to_arc(const thread_object *t, uint32_t segment, double max_displacement,
                        remesh_window *w)
{
    uint32_t at = segment + 1 - w->first_node;
    vec3 middle = w->x[at];
    w->x[at] = vec3_sub(middle, sagitta_vector(t, segment));
    set_movable(w, at > REMESH_MOVABLE_SIDE ? at - REMESH_MOVABLE_SIDE : 0,
                at + REMESH_MOVABLE_SIDE);
    double displacement = vbss_remesh_project_window(w);
    displacement = vbss_max_or_nan(vec3_distance(middle, w->x[at]), displacement);
    return displacement <= max_displacement;
}

void vbss_thread_split_segment(thread_object *t, uint32_t segment, double max_displacement)
{
    remesh_window w, chord_window;
    uint32_t node = segment + 1;
    vec3 middle = vec3_lerp(t->now.x[segment], t->now.x[node], 0.5);
    vbss_thread_compute_masses(t);
    const momentum_sum before = sum_momentum(t, middle);
    vbss_remesh_extract_window(t, segment, &w);
    vbss_remesh_measure_window(&w);
    insert_window_node(&w, node - w.first_node, middle);
    chord_window = w;
    bool is_on_arc = max_displacement > 0.0 && move_to_arc(t, segment, max_displacement, &w);
    if (!is_on_arc) {
        t->statistics.laid_on_chord++;
    }
    vec3 a = vec3_lerp(t->now.a[segment], t->now.a[node], 0.5);
    vec3 q = vec3_lerp(t->now.q[segment], t->now.q[node], 0.5);
    shift_nodes(t, node, node + 1);
    store_positions(t, is_on_arc ? &w : &chord_window);
    t->rest[node] = t->rest[segment] *= 0.5;
    t->now.tension[node] = t->now.tension[segment];
    t->now.a[node] = a;
    t->now.q[node] = q;
    t->now.v[node] = vec3_zero();
    t->welded[node] = 0;
    vbss_thread_compute_masses(t);
    apply_impulse(t, node, vec3_sub(before.linear, sum_momentum(t, middle).linear));
    restore_angular_momentum(t, segment, node + 1, &before, middle);
    t->statistics.refined++;
    finish_remesh(t);
}

/* ---- removal */

static void remove_window_node(remesh_window *w, uint32_t at)
{
    w->rest[at - 1] += w->rest[at];
    w->elongation[at - 1] += w->elongation[at];
    for (uint32_t k = at; k + 1 < w->count; k++) {
        w->x[k] = w->x[k + 1];
        if (k + 2 < w->count) {
            w->rest[k] = w->rest[k + 1];
            w->elongation[k] = w->elongation[k + 1];
        }
    }
    w->count--;
}

bool vbss_thread_remove_node(thread_object *t, uint32_t node, double max_displacement)
{
    remesh_window w;
    vec3 removed = t->now.x[node];
    double length_before = t->rest[node - 1], length = length_before + t->rest[node];
    double fraction = length_before / length;
    vbss_remesh_extract_window(t, node, &w);
    vbss_remesh_measure_window(&w);
    uint32_t at = node - w.first_node;
    remove_window_node(&w, at);
    set_movable(&w, at > REMESH_MOVABLE_SIDE ? at - REMESH_MOVABLE_SIDE : 0,
                at + REMESH_MOVABLE_SIDE - 1);
    double displacement = vbss_remesh_project_window(&w);
    displacement = vbss_max_or_nan(
        vec3_distance(removed, vec3_lerp(w.x[at - 1], w.x[at], fraction)), displacement);
    if (!(displacement <= max_displacement)) {
        return false;
    }
    vbss_thread_compute_masses(t);
    const momentum_sum before = sum_momentum(t, removed);
    double tension = t->now.tension[node - 1] +
                     (1.0 - fraction) * (t->now.tension[node] - t->now.tension[node - 1]);
    shift_nodes(t, node + 1, node);
    store_positions(t, &w);
    t->rest[node - 1] = length;
    t->now.tension[node - 1] = tension;
    t->welded[t->node_count] = 0;
    vbss_thread_compute_masses(t);
    vec3 deficit = vec3_sub(before.linear, sum_momentum(t, removed).linear);
    apply_impulse(t, node - 1, vec3_scale(deficit, 1.0 - fraction));
    apply_impulse(t, node, vec3_scale(deficit, fraction));
    restore_angular_momentum(t, node - 1, node, &before, removed);
    t->statistics.coarsened++;
    finish_remesh(t);
    return true;
}
