/* A node comes or goes. What is not smooth about it stands here: numbers, momentum; window.c moves its neighbours. */
#include "thread/mesh.h"

#include <string.h>

/* Nodes on either side of the change that are moved with it. */
enum { MOVED_SIDE = 2 };

/* ---- momentum */

typedef struct motion_sum {
    vec3 linear, angular; /* about a point */
} motion_sum;

static motion_sum sum_up(const thread_object *t, vec3 about)
{
    motion_sum s = {vec3_zero(), vec3_zero()};
    for (uint32_t i = 0; i < t->node_count; i++) {
        vec3 p = vec3_scale(t->now.v[i], t->mass[i]);
        s.linear = vec3_add(s.linear, p);
        s.angular = vec3_add(s.angular, vec3_cross(vec3_sub(t->now.x[i], about), p));
    }
    return s;
}

static void push(thread_object *t, uint32_t node, vec3 momentum)
{
    t->now.v[node] = vec3_add_scaled(t->now.v[node], 1.0 / t->mass[node], momentum);
}

/* A couple at two nodes that gives the thread the angular momentum it had, but for what is along the line through
 * them. */
static void turn_back(thread_object *t, uint32_t a, uint32_t b, const motion_sum *before,
                      vec3 about)
{
    motion_sum after = sum_up(t, about);
    vec3 e = vec3_sub(t->now.x[b], t->now.x[a]);
    double square = vec3_norm_squared(e);
    if (square > 0.0) {
        vec3 lost = vec3_sub(before->angular, after.angular);
        vec3 kick = vec3_scale(vec3_cross(lost, e), 1.0 / square);
        push(t, a, vec3_neg(kick));
        push(t, b, kick);
    }
}

/* ---- numbers */

static void shift(void *array, size_t size, uint32_t from, uint32_t to, uint32_t count)
{
    char *begin = array;
    memmove(begin + to * size, begin + from * size, count * size);
}

/* Nodes from there on move up or down, with the segments that begin at them. */
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

static void finish(thread_object *t)
{
    t->layout_known = t->pattern_known = false;
    t->generation++;
}

/* ---- the window */

static void take_positions(thread_object *t, const mesh_window *w)
{
    memcpy(t->now.x + w->first, w->x, w->count * sizeof *w->x);
}

/* Nodes low .. high of the window, but not the ends that it was cut out at. */
static void let_move(mesh_window *w, uint32_t low, uint32_t high)
{
    for (uint32_t k = low; k <= high && k < w->count; k++) {
        w->moves[k] = (k > 1 || w->begins) && (k + 2 < w->count || w->ends);
    }
}

/* On the arc between two nodes: from its middle to that of the chord, by the curvatures at both ends. */
static vec3 sagitta_at(const thread_object *t, uint32_t segment)
{
    double l = t->rest[segment];
    vec3 both = vec3_add(vbss_thread_curvature(t, t->now.x, segment),
                         vbss_thread_curvature(t, t->now.x, segment + 1));
    return vec3_scale(both, l * l / 16.0);
}

/* ---- a node comes */

static void open_window(mesh_window *w, uint32_t at, vec3 x)
{
    for (uint32_t k = w->count; k > at; k--) {
        w->x[k] = w->x[k - 1];
    }
    for (uint32_t k = w->count - 1; k >= at; k--) {
        w->rest[k] = w->rest[k - 1];
        w->excess[k] = w->excess[k - 1];
    }
    w->x[at] = x;
    w->rest[at] = w->rest[at - 1] *= 0.5;
    w->excess[at] = w->excess[at - 1] *= 0.5;
    w->count++;
}

/* Lays the new node on the arc and settles it; false: that takes more than the room. */
static bool lay_on_arc(const thread_object *t, uint32_t segment, double room, mesh_window *w)
{
    uint32_t at = segment + 1 - w->first;
    vec3 middle = w->x[at];
    w->x[at] = vec3_sub(middle, sagitta_at(t, segment));
    let_move(w, at > MOVED_SIDE ? at - MOVED_SIDE : 0, at + MOVED_SIDE);
    double moved = vbss_mesh_settle(w);
    moved = vbss_max_or_nan(vec3_distance(middle, w->x[at]), moved);
    return moved <= room;
}

void vbss_thread_divide_segment(thread_object *t, uint32_t segment, double room)
{
    mesh_window w, flat;
    uint32_t node = segment + 1;
    vec3 middle = vec3_lerp(t->now.x[segment], t->now.x[node], 0.5);
    vbss_thread_weigh(t);
    const motion_sum before = sum_up(t, middle);
    vbss_mesh_look(t, segment, &w);
    vbss_mesh_measure(&w);
    open_window(&w, node - w.first, middle);
    flat = w;
    bool laid = room > 0.0 && lay_on_arc(t, segment, room, &w);
    if (!laid) {
        t->statistics.laid_on_chord++;
    }
    vec3 a = vec3_lerp(t->now.a[segment], t->now.a[node], 0.5);
    vec3 q = vec3_lerp(t->now.q[segment], t->now.q[node], 0.5);
    shift_nodes(t, node, node + 1);
    take_positions(t, laid ? &w : &flat);
    t->rest[node] = t->rest[segment] *= 0.5;
    t->now.tension[node] = t->now.tension[segment];
    t->now.a[node] = a;
    t->now.q[node] = q;
    t->now.v[node] = vec3_zero();
    t->welded[node] = 0;
    vbss_thread_weigh(t);
    push(t, node, vec3_sub(before.linear, sum_up(t, middle).linear));
    turn_back(t, segment, node + 1, &before, middle);
    t->statistics.refined++;
    finish(t);
}

/* ---- a node goes */

static void close_window(mesh_window *w, uint32_t at)
{
    w->rest[at - 1] += w->rest[at];
    w->excess[at - 1] += w->excess[at];
    for (uint32_t k = at; k + 1 < w->count; k++) {
        w->x[k] = w->x[k + 1];
        if (k + 2 < w->count) {
            w->rest[k] = w->rest[k + 1];
            w->excess[k] = w->excess[k + 1];
        }
    }
    w->count--;
}

bool vbss_thread_remove_node(thread_object *t, uint32_t node, double room)
{
    mesh_window w;
    vec3 gone = t->now.x[node];
    double before_it = t->rest[node - 1], both = before_it + t->rest[node];
    double share = before_it / both;
    vbss_mesh_look(t, node, &w);
    vbss_mesh_measure(&w);
    uint32_t at = node - w.first;
    close_window(&w, at);
    let_move(&w, at > MOVED_SIDE ? at - MOVED_SIDE : 0, at + MOVED_SIDE - 1);
    double moved = vbss_mesh_settle(&w);
    moved = vbss_max_or_nan(vec3_distance(gone, vec3_lerp(w.x[at - 1], w.x[at], share)), moved);
    if (!(moved <= room)) {
        return false;
    }
    vbss_thread_weigh(t);
    const motion_sum before = sum_up(t, gone);
    double tension = t->now.tension[node - 1] +
                     (1.0 - share) * (t->now.tension[node] - t->now.tension[node - 1]);
    shift_nodes(t, node + 1, node);
    take_positions(t, &w);
    t->rest[node - 1] = both;
    t->now.tension[node - 1] = tension;
    t->welded[t->node_count] = 0;
    vbss_thread_weigh(t);
    vec3 lost = vec3_sub(before.linear, sum_up(t, gone).linear);
    push(t, node - 1, vec3_scale(lost, 1.0 - share));
    push(t, node, vec3_scale(lost, share));
    turn_back(t, node - 1, node, &before, gone);
    t->statistics.coarsened++;
    finish(t);
    return true;
}
