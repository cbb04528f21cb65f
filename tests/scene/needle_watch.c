#include "scene/needle_watch.h"

#include "collision/closest.h"

typedef struct box {
    vec3 low, high;
} box;

/* A drain and holes in it, at the begin and the end of a part. */
typedef struct wall {
    const drain_object *drain;
    uint32_t hole_count;
    vec3 holes[NEEDLE_CASE_HOLES][2], at_rest[NEEDLE_CASE_HOLES];
    double reach[NEEDLE_CASE_HOLES];
} wall;

typedef struct capsules {
    passing_chain all[NEEDLE_WATCH_CAPSULES], away[NEEDLE_WATCH_CAPSULES];
    size_t count, away_count;
    box swept;
    uint32_t away_names[NEEDLE_WATCH_CAPSULES];
} capsules;

/* ---- boxes */

static box box_of(const vec3 *x, const uint32_t *nodes, uint32_t corners)
{
    box b = {x[nodes[0]], x[nodes[0]]};
    for (uint32_t k = 1; k < corners; k++) {
        vec3 p = x[nodes[k]];
        b.low = vec3_make(fmin(b.low.x, p.x), fmin(b.low.y, p.y), fmin(b.low.z, p.z));
        b.high = vec3_make(fmax(b.high.x, p.x), fmax(b.high.y, p.y), fmax(b.high.z, p.z));
    }
    return b;
}

static box joined(box a, box b)
{
    return (box){
        vec3_make(fmin(a.low.x, b.low.x), fmin(a.low.y, b.low.y), fmin(a.low.z, b.low.z)),
        vec3_make(fmax(a.high.x, b.high.x), fmax(a.high.y, b.high.y), fmax(a.high.z, b.high.z))};
}

/* What is not finite is not apart. */
static bool apart(box a, box b)
{
    return a.high.x < b.low.x || b.high.x < a.low.x || a.high.y < b.low.y || b.high.y < a.low.y ||
           a.high.z < b.low.z || b.high.z < a.low.z;
}

static double distance(box b, vec3 p)
{
    double x = fmax(0.0, fmax(b.low.x - p.x, p.x - b.high.x));
    double y = fmax(0.0, fmax(b.low.y - p.y, p.y - b.high.y));
    double z = fmax(0.0, fmax(b.low.z - p.z, p.z - b.high.z));
    return vec3_norm(vec3_make(x, y, z));
}

/* ---- holes */

/* What it bears across, at the begin or the end of the part. */
static double force_across(const scene_object *s, uint32_t hole)
{
    double largest = vec3_norm(s->holes[hole].transverse_force);
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        const contact_constraint *row = &s->contacts->constraints[i];
        bool own = row->key.kind == VBSS_SCENE_CONTACT_HOLE && row->key.feature_a == hole;
        largest = own ? fmax(largest, vec3_norm(row->solution.tangential_force)) : largest;
    }
    return largest;
}

static void find_holes(const scene_object *s, const needle_watch *n, wall *w)
{
    w->hole_count = 0;
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *hole = &s->holes[i];
        if (hole->id != 0) {
            const drain_object *d = w->drain;
            assert_true(w->hole_count < NEEDLE_CASE_HOLES);
            w->reach[w->hole_count] = n->touching + n->give * force_across(s, i);
            w->holes[w->hole_count][0] =
                vbss_drain_point(d, d->x, hole->triangle, hole->barycentric);
            w->holes[w->hole_count][1] =
                vbss_drain_point(d, d->trial, hole->triangle, hole->barycentric);
            w->at_rest[w->hole_count++] =
                vbss_drain_point(d, d->mesh.rest, hole->triangle, hole->barycentric);
        }
    }
}

static double distance_to_axis(const vec3 axis[2], vec3 p)
{
    vec3 e = vec3_sub(axis[1], axis[0]), to = vec3_sub(p, axis[0]);
    return vec3_norm(vec3_add_scaled(to, -closest_on_edge(e, to), e));
}

static bool is_axis_at_hole(const wall *w, const vec3 now[2], const vec3 trial[2])
{
    for (uint32_t i = 0; i < w->hole_count; i++) {
        if (distance_to_axis(now, w->holes[i][0]) < w->reach[i] ||
            distance_to_axis(trial, w->holes[i][1]) < w->reach[i]) {
            return true;
        }
    }
    return false;
}

static bool is_feature_at_hole(const wall *w, const uint32_t *nodes, uint32_t corners)
{
    for (uint32_t i = 0; i < w->hole_count; i++) {
        const drain_object *d = w->drain;
        if (distance(box_of(d->x, nodes, corners), w->holes[i][0]) < w->reach[i] ||
            distance(box_of(d->trial, nodes, corners), w->holes[i][1]) < w->reach[i] ||
            distance(box_of(d->mesh.rest, nodes, corners), w->at_rest[i]) < w->reach[i]) {
            return true;
        }
    }
    return false;
}

/* ---- a part */

static void gather_axis(const vec3 now[2], const vec3 trial[2], const wall *w, capsules *to)
{
    static const uint32_t both[2] = {0, 1};
    uint32_t name = (uint32_t)to->count;
    assert_true(name < NEEDLE_WATCH_CAPSULES);
    box swept = joined(box_of(now, both, 2), box_of(trial, both, 2));
    to->swept = name == 0 ? swept : joined(to->swept, swept);
    to->all[to->count++] = (passing_chain){now, trial, 2, false};
    if (!is_axis_at_hole(w, now, trial)) {
        to->away_names[to->away_count] = name;
        to->away[to->away_count++] = (passing_chain){now, trial, 2, false};
    }
}

static void gather_axes(const scene_object *s, const needle_watch *n, const wall *w, capsules *to)
{
    const scene_body *needle = vbss_scene_body(s, n->needle);
    to->count = to->away_count = 0;
    for (uint32_t i = 0; needle != NULL && i < needle->rigid.capsule_count; i++) {
        const scene_capsule *c = &s->capsules[needle->rigid.first_capsule + i];
        gather_axis(c->now, c->trial, w, to);
    }
    for (uint32_t i = 0; n->threads && i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        const thread_object *t = b->thread.thread;
        for (uint32_t k = 0; b->kind == SCENE_BODY_THREAD && k + 1 < t->node_count; k++) {
            gather_axis(t->now.x + k, t->trial + k, w, to);
        }
    }
}

static bool concerns(const wall *w, box needle, bool away, const uint32_t *nodes, uint32_t corners)
{
    box swept =
        joined(box_of(w->drain->x, nodes, corners), box_of(w->drain->trial, nodes, corners));
    return !apart(needle, swept) && !(away && is_feature_at_hole(w, nodes, corners));
}

/* Of a drain, what the needle's box meets: all, or that away from holes. */
static passing_surface gather_features(needle_watch *n, const wall *w, box needle, bool away)
{
    const drain_mesh *m = &w->drain->mesh;
    passing_surface f = {
        .start = w->drain->x, .end = w->drain->trial, .triangles = n->triangles, .sides = n->sides};
    assert_true(m->triangle_count <= NEEDLE_WATCH_TRIANGLES && m->edge_count <= NEEDLE_WATCH_SIDES);
    for (uint32_t i = 0; i < m->triangle_count; i++) {
        if (concerns(w, needle, away, m->triangles[i], 3)) {
            memcpy(n->triangles + 3 * f.triangle_count, m->triangles[i], sizeof m->triangles[i]);
            n->triangle_names[f.triangle_count++] = i;
        }
    }
    for (uint32_t i = 0; i < m->edge_count; i++) {
        if (concerns(w, needle, away, m->edges[i].nodes, 2)) {
            memcpy(n->sides + 2 * f.side_count, m->edges[i].nodes, sizeof m->edges[i].nodes);
            n->side_names[f.side_count++] = i;
        }
    }
    return f;
}

static void ask(needle_watch *n, const wall *w, box needle, bool away, const passing_chain *chains,
                size_t count, const uint32_t *names)
{
    passing_surface surface = gather_features(n, w, needle, away);
    passing_surface_report report;
    if (surface.triangle_count + surface.side_count == 0 || count == 0) {
        return;
    }
    (void)passing_surfaces(&surface, 1, chains, count, &report);
    n->asked += report.asked;
    if (report.passed > 0 && n->passed == 0) {
        n->report = report;
        for (int k = 0; k < 2; k++) {
            passing_feature *f = &n->report.first[k];
            bool drain = f->of == count;
            f->number = !drain            ? (names != NULL ? names[f->of] : f->of)
                        : f->corners == 3 ? n->triangle_names[f->number]
                                          : n->side_names[f->number];
            f->of = drain;
        }
    }
    n->passed += report.passed;
}

void needle_watch_observe(needle_watch *n, const scene_object *s)
{
    const scene_body *drain = vbss_scene_body(s, n->drain);
    static capsules of;
    if (drain == NULL) {
        return;
    }
    wall w = {.drain = drain->drain.drain};
    find_holes(s, n, &w);
    gather_axes(s, n, &w, &of);
    n->parts++;
    /* Pairs of which one or the other is away from holes; without holes these are all. */
    ask(n, &w, of.swept, true, of.all, of.count, NULL);
    if (w.hole_count > 0) {
        ask(n, &w, of.swept, false, of.away, of.away_count, of.away_names);
    }
}

static void watch(void *watcher, const scene_object *s)
{
    needle_watch *n = watcher;
    n->needle = n->of->body;
    if (vbss_scene_body(s, n->needle) != NULL) {
        needle_watch_observe(n, s);
    }
}

void needle_watch_begin(needle_watch *w, const needle_case *c)
{
    scene_object *s = small_object(&c->d.s);
    *w = (needle_watch){.of = c,
                        .drain = c->d.body,
                        .touching =
                            c->at_hole * (c->config.wire_radius + 0.5 * c->d.config.thickness),
                        .give = c->give};
    s->on_substep = watch;
    s->on_substep_data = w;
}
