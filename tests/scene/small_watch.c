#include "scene/small_watch.h"

#include "oracle/passing.h"

enum { MAX_CHAINS = 40 };

static void check_below(small_watch *w, const scene_object *s, vec3 x)
{
    double above = vec3_dot(x, s->floor_normal) - s->config.floor_height;
    if (s->config.floor != 0) {
        w->below += above > 0.0 ? 0 : 1;
        w->nearest_floor = vbss_min(above, w->nearest_floor);
    }
}

static void watch(void *watcher, const scene_object *s)
{
    small_watch *w = watcher;
    passing_chain chains[MAX_CHAINS];
    size_t count = 0;
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        const thread_object *t = b->thread.thread;
        const scene_rigid *r = &b->rigid;
        if (b->kind == SCENE_BODY_THREAD) {
            chains[count++] = (passing_chain){t->now.x, t->trial, t->node_count, false};
        }
        for (uint32_t k = 0; b->kind == SCENE_BODY_THREAD && k < t->node_count; k++) {
            check_below(w, s, t->trial[k]);
        }
        for (uint32_t k = 0; b->kind == SCENE_BODY_RIGID && k < r->capsule_count; k++) {
            const scene_capsule *c = &s->capsules[r->first_capsule + k];
            chains[count++] = (passing_chain){c->now, c->trial, 2, false};
            check_below(w, s, c->trial[0]);
            check_below(w, s, c->trial[1]);
        }
        const drain_object *d = b->drain.drain;
        for (uint32_t k = 0; b->kind == SCENE_BODY_DRAIN && k < d->mesh.node_count; k++) {
            check_below(w, s, d->trial[k]);
        }
        assert_true(count < MAX_CHAINS);
    }
    w->parts++;
    w->passed += passing_count(chains, count, NULL);
    passing_surface_report report;
    uint64_t passed = drain_watch_passed(&w->drains, s, chains, count, &report);
    if (w->passed_drain == 0 && passed > 0) {
        w->report = report;
    }
    w->passed_drain += passed;
}

void small_watch_begin(small *s, small_watch *w)
{
    scene_object *object = small_object(s);
    *w = (small_watch){.nearest_floor = 1e9};
    object->on_substep = watch;
    object->on_substep_data = w;
}

void small_watch_expect_nothing(const small_watch *w)
{
    assert_true(w->parts > 0);
    assert_int_equal(w->passed, 0);
    assert_int_equal(w->passed_drain, 0);
    assert_int_equal(w->below, 0);
}
