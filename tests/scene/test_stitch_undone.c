/* A needle with its thread in the drain, the needle in the second hole, the thread in the first, is turned back: its end goes back
 * into the first hole. */
#include "scene/needle_case.h"
#include "scene/stitch_watch.h"

#define SPEED 0.05

static needle_case c;
static stitch_watch watch;
static uint32_t thread_body;

/* When an event came first and last: steps, from 1 on; 0: never. */
static uint32_t first[NEEDLE_CASE_EVENTS], last[NEEDLE_CASE_EVENTS], steps;

static void begin(void)
{
    memset(&watch, 0, sizeof watch);
    memset(first, 0, sizeof first);
    memset(last, 0, sizeof last);
    steps = 0;
    needle_case_begin_at_mark(&c, VBSS_DRAIN_MESH_137, 1e-3);
    vbss_needle_state n = needle_case_state(&c);
    vec3 swage = vec3_load(n.swage), way = vec3_load(n.swage_direction);
    uint32_t pin;
    thread_body =
        small_thread(&c.d.s, swage, vec3_add_scaled(swage, 50e-3, way), 100, &c.d.threads[0]);
    expect_ok(vbss_scene_pin_thread(c.d.s.scene, thread_body, 0, c.body, NULL, &pin));
}

static void look(void)
{
    steps++;
    for (int k = 0; k < NEEDLE_CASE_EVENTS; k++) {
        last[k] = c.happened[k] > 0 ? steps : last[k];
        first[k] = first[k] == 0 ? last[k] : first[k];
    }
    stitch_watch_look(&watch, c.d.s.scene, c.d.drain);
}

/* Up to so many events of that kind in all; 0: none is waited for. */
static void turn(double way, double speed, vbss_event_kind until, uint32_t count)
{
    uint32_t most = (uint32_t)ceil(fabs(way) / (speed * c.d.h));
    for (uint32_t i = 0; i < most && (until == 0 || c.counts[until] < count); i++) {
        needle_case_turn(&c, way / most);
        needle_case_step(&c);
        look();
    }
}

static void expect_in(uint32_t holes, uint32_t threads)
{
    vbss_hole in[NEEDLE_CASE_HOLES];
    uint32_t found = 0;
    assert_int_equal(needle_case_holes(&c, in), holes);
    for (uint32_t i = 0; i < holes; i++) {
        assert_true(in[i].thread == 0 || in[i].thread == thread_body);
        found += in[i].thread != 0;
    }
    assert_int_equal(found, threads);
}

static void finish(const char *name)
{
    vbss_scene_statistics s = small_statistics(&c.d.s);
    print_message("%s: from hole %.2f, from suture %.2f; %llu away, %llu missed; %llu paused, %llu "
                  "clamped, stretch %.1e\n",
                  name, watch.farthest, watch.loosest, (unsigned long long)watch.away,
                  (unsigned long long)watch.missed, (unsigned long long)s.paused,
                  (unsigned long long)s.clamped, s.stretch_error);
    assert_int_equal(watch.away, 0);
    assert_int_equal(watch.missed, 0);
    needle_case_expect_kept(&c, name, 0);
    needle_case_end(&c);
}

/* Into both walls, and on until the thread is in the first hole. */
static void into_the_second_hole(double speed)
{
    turn(60e-3, speed, VBSS_EVENT_PASSED, 1);
    assert_int_equal(c.counts[VBSS_EVENT_PUNCTURE], 2);
    expect_in(2, 1);
    turn(2e-3, speed, 0, 0);
    expect_in(2, 1);
    assert_int_equal(watch.crossings, 1);
}

static void drawn_back_the_needle_undoes_the_stitch(void **state)
{
    (void)state;
    static const double speeds[] = {0.05, 0.2};
    for (int i = 0; i < 2; i++) {
        begin();
        into_the_second_hole(speeds[i]);
        turn(-80e-3, speeds[i], VBSS_EVENT_WITHDRAWN, 2);
        assert_int_equal(c.counts[VBSS_EVENT_RETURNED], 1);
        assert_int_equal(c.counts[VBSS_EVENT_WITHDRAWN], 2);
        assert_int_equal(c.counts[VBSS_EVENT_UNTHREADED], 0);
        assert_true(first[VBSS_EVENT_PASSED] < first[VBSS_EVENT_RETURNED]);
        assert_true(first[VBSS_EVENT_RETURNED] < last[VBSS_EVENT_WITHDRAWN]);
        turn(-2e-3, speeds[i], 0, 0);
        expect_in(0, 0);
        assert_int_equal(watch.crossings, 0);
        finish("undone");
    }
}

int test_stitch_undone(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(drawn_back_the_needle_undoes_the_stitch),
    };
    return cmocka_run_group_tests_name("scene.stitch_undone", tests, NULL, NULL);
}
