#include "scene/needle_stitch.h"

enum { SEGMENTS = 100 };

void needle_stitch_begin(needle_stitch *n)
{
    uint32_t pin;
    needle_case *c = &n->c;
    memset(&n->watch, 0, sizeof n->watch);
    memset(n->first, 0, sizeof n->first);
    memset(n->last, 0, sizeof n->last);
    n->steps = 0;
    needle_case_begin_at_mark(c, VBSS_DRAIN_MESH_137, 1e-3);
    vbss_needle_state s = needle_case_state(c);
    vec3 swage = vec3_load(s.swage), direction = vec3_load(s.swage_direction);
    n->thread_body = small_thread(&c->d.s, swage, vec3_add_scaled(swage, 50e-3, direction),
                                  SEGMENTS, &c->d.threads[0]);
    expect_ok(vbss_scene_pin_thread(c->d.s.scene, n->thread_body, 0, c->body, NULL, &pin));
}

void needle_stitch_wait(needle_stitch *n, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        needle_case_step(&n->c);
        n->steps++;
        for (int k = 0; k < NEEDLE_CASE_EVENTS; k++) {
            n->last[k] = n->c.happened[k] > 0 ? n->steps : n->last[k];
            n->first[k] = n->first[k] == 0 ? n->last[k] : n->first[k];
        }
        stitch_watch_observe(&n->watch, n->c.d.s.scene, n->c.d.drain);
    }
}

void needle_stitch_turn(needle_stitch *n, double distance, double speed,
                        vbss_scene_event_kind until, uint32_t count)
{
    uint32_t largest = (uint32_t)ceil(fabs(distance) / (speed * n->c.d.h));
    for (uint32_t i = 0; i < largest && (until == 0 || n->c.counts[until] < count); i++) {
        needle_case_turn(&n->c, distance / largest);
        needle_stitch_wait(n, 1);
    }
}

void needle_stitch_draw(needle_stitch *n, double force)
{
    const drain_case *d = &n->c.d;
    vec3 mark = drain_case_node(d, d->places.marks[DRAIN_RIGHT]);
    vec3 outward = vec3_unit_or(vec3_make(0.0, mark.y, mark.z), vec3_zero());
    small_draw(d->threads[0], SEGMENTS, vec3_scale(outward, force));
}

void needle_stitch_expect_in(const needle_stitch *n, uint32_t holes, uint32_t threads)
{
    vbss_scene_hole in[NEEDLE_CASE_HOLES];
    uint32_t found = 0;
    assert_int_equal(needle_case_holes(&n->c, in), holes);
    for (uint32_t i = 0; i < holes; i++) {
        assert_true(in[i].thread == 0 || in[i].thread == n->thread_body);
        found += in[i].thread != 0;
    }
    assert_int_equal(found, threads);
}

void needle_stitch_into_second(needle_stitch *n, double speed)
{
    needle_stitch_turn(n, 60e-3, speed, VBSS_SCENE_EVENT_PASSED, 1);
    assert_int_equal(n->c.counts[VBSS_SCENE_EVENT_PUNCTURE], 2);
    needle_stitch_expect_in(n, 2, 1);
    needle_stitch_turn(n, 2e-3, speed, 0, 0);
    needle_stitch_expect_in(n, 2, 1);
    assert_int_equal(n->watch.crossings, 1);
}

void needle_stitch_expect_undone(needle_stitch *n, double force, double speed)
{
    needle_stitch_draw(n, force);
    needle_stitch_turn(n, -80e-3, speed, VBSS_SCENE_EVENT_WITHDRAWN, 2);
    assert_int_equal(n->c.counts[VBSS_SCENE_EVENT_RETURNED], 1);
    assert_int_equal(n->c.counts[VBSS_SCENE_EVENT_WITHDRAWN], 2);
    assert_int_equal(n->c.counts[VBSS_SCENE_EVENT_UNTHREADED], 0);
    assert_true(n->first[VBSS_SCENE_EVENT_PASSED] < n->first[VBSS_SCENE_EVENT_RETURNED]);
    assert_true(n->first[VBSS_SCENE_EVENT_RETURNED] < n->last[VBSS_SCENE_EVENT_WITHDRAWN]);
    needle_stitch_turn(n, -2e-3, speed, 0, 0);
    needle_stitch_expect_in(n, 0, 0);
    assert_int_equal(n->watch.crossings, 0);
}

void needle_stitch_finish(needle_stitch *n, const char *name)
{
    needle_stitch_finish_clamped(n, name, 0);
}

void needle_stitch_finish_clamped(needle_stitch *n, const char *name, uint32_t max_clamped)
{
    vbss_scene_statistics s = small_statistics(&n->c.d.s);
    print_message("%s: from hole %.2f, from suture %.2f; %llu away, %llu missed; %llu paused, %llu "
                  "clamped, stretch %.1e\n",
                  name, n->watch.farthest, n->watch.loosest, (unsigned long long)n->watch.away,
                  (unsigned long long)n->watch.missed, (unsigned long long)s.paused,
                  (unsigned long long)s.clamped, s.stretch_error);
    assert_int_equal(n->watch.away, 0);
    assert_int_equal(n->watch.missed, 0);
    needle_case_expect_kept(&n->c, name, max_clamped);
    needle_case_end(&n->c);
}
