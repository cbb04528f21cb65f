#include "scene/stitch_watch.h"

#include "drain/drain.h"
#include "scene/line_crossing.h"
#include "thread/thread.h"

/* A crossing is at a hole when it is so near, in distances of touching. */
#define AT_HOLE 1.5
/* Bodies of a test. */
enum { BODIES = 24 };

typedef struct seen {
    stitch_watch *watch;
    const drain_object *drain;
    vbss_scene_hole holes[STITCH_WATCH_HOLES];
    uint32_t body;   /* of the thread that is looked at */
    double touching; /* of it */
} seen;

uint32_t stitch_watch_holes(vbss_scene *scene, vbss_scene_hole holes[STITCH_WATCH_HOLES])
{
    uint32_t count = 0;
    while (count < STITCH_WATCH_HOLES &&
           vbss_scene_get_hole(scene, count, &holes[count], sizeof *holes) == VBSS_OK) {
        count++;
    }
    return count;
}

vbss_thread *stitch_watch_thread(vbss_scene *scene, uint32_t body)
{
    vbss_thread *thread = NULL;
    return vbss_scene_get_thread(scene, body, &thread) == VBSS_OK ? thread : NULL;
}

static vec3 weighed(const vec3 *x, const uint32_t node[3], const double weights[3])
{
    vec3 point = vec3_scale(x[node[0]], weights[0]);
    point = vec3_add_scaled(point, weights[1], x[node[1]]);
    return vec3_add_scaled(point, weights[2], x[node[2]]);
}

/* At the swage a hole may still be the needle's. */
static void judge(seen *s, const uint32_t node[3], const double weights[3])
{
    vec3 now = weighed(s->drain->x, node, weights);
    vec3 rest = weighed(s->drain->mesh.rest, node, weights);
    double nearest = HUGE_VAL;
    for (uint32_t i = 0; i < s->watch->holes; i++) {
        const vbss_scene_hole *hole = &s->holes[i];
        if (hole->thread == s->body || hole->needle != 0) {
            double far = fmin(vec3_distance(now, vec3_load(hole->position)),
                              vec3_distance(rest, vec3_load(hole->rest_position)));
            nearest = fmin(nearest, far / s->touching);
        }
    }
    s->watch->crossings++;
    s->watch->away += nearest < AT_HOLE ? 0 : 1;
    s->watch->farthest = fmax(s->watch->farthest, nearest);
}

static double distance_to(const vec3 *x, uint32_t count, vec3 point)
{
    double smallest = HUGE_VAL;
    for (uint32_t i = 0; i + 1 < count; i++) {
        vec3 along = vec3_sub(x[i + 1], x[i]), to = vec3_sub(point, x[i]);
        double share = vec3_dot(to, along) / vec3_norm_squared(along);
        vec3 off = vec3_add_scaled(to, -fmin(fmax(share, 0.0), 1.0), along);
        smallest = fmin(smallest, vec3_norm(off));
    }
    return smallest;
}

static void observe(seen *s, const thread_object *t)
{
    const vec3 *x = t->now.x;
    s->touching = t->config.radius + 0.5 * s->drain->config.thickness;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        for (uint32_t k = 0; k < s->drain->mesh.triangle_count; k++) {
            const uint32_t *node = s->drain->mesh.triangles[k];
            const vec3 corner[3] = {s->drain->x[node[0]], s->drain->x[node[1]],
                                    s->drain->x[node[2]]};
            double weights[3];
            if (line_crosses_triangle(x[i], x[i + 1], corner, weights)) {
                judge(s, node, weights);
            }
        }
    }
    for (uint32_t i = 0; i < s->watch->holes; i++) {
        if (s->holes[i].thread == s->body) {
            double off = distance_to(x, t->node_count, vec3_load(s->holes[i].position));
            s->watch->missed += off < s->touching ? 0 : 1;
            s->watch->loosest = fmax(s->watch->loosest, off / s->touching);
        }
    }
}

void stitch_watch_observe(stitch_watch *w, vbss_scene *scene, vbss_drain *drain)
{
    seen s = {.watch = w};
    drain_object *d;
    expect_ok(vbss_drain_open(drain, &d));
    s.drain = d;
    w->crossings = 0;
    w->holes = stitch_watch_holes(scene, s.holes);
    for (s.body = 1; s.body < BODIES; s.body++) {
        thread_object *t;
        vbss_thread *thread = stitch_watch_thread(scene, s.body);
        if (thread != NULL) {
            expect_ok(vbss_thread_open(thread, &t));
            observe(&s, t);
        }
    }
}
