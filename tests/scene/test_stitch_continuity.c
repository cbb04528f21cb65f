/* What must not jump in a stitch: what a segment feels as it comes out of a hole, and where a hole is when the mesh changes. */
#include "scene/contacts/contacts.h"
#include "scene/world/world.h"
#include "scene/stitch_case.h"

static stitch_case c;

/* More energy than was put in, as a share of that. */
#define SHARE 0.05
/* Within which of a hole a needle touches nothing, and a thread, m: 1.5 distances of touching of its 1.6. */
#define REACH 1e-3
#define THREAD_REACH (1.5 / SCENE_EXCLUSION_ARC_RATIO * REACH)

/* ---- beside a hole */

/* At which share of the distance of touching a place of the thread touches that is so far from the first hole, along it. */
static double share_at(const suture_hole *hole, double away)
{
    const scene_object *s = small_object(&c.s);
    const scene_body *thread = vbss_scene_body(s, hole->thread);
    const scene_body *drain = vbss_scene_body(s, hole->wall);
    const thread_object *t = thread->thread.thread;
    const scene_wall_point point = vbss_scene_wall_point(drain, hole->triangle, hole->barycentric);
    double arc = hole->arc + away;
    uint32_t segment = 0;
    while (vbss_thread_arc_length(t, segment + 1) < arc) {
        segment++;
    }
    double share = (arc - vbss_thread_arc_length(t, segment)) / t->rest[segment];
    return vbss_scene_contact_scale_at(s, thread, false, segment, share, drain, &point, REACH);
}

static void contact_grows_gradually_outside_hole(void **state)
{
    (void)state;
    stitch_case_begin(&c);
    stitch_case_make(&c);
    const suture_hole *hole = &small_object(&c.s)->holes[0];
    assert_true(hole->thread == c.stitch.thread_body);
    double last = 0.0;
    for (uint32_t i = 0; i <= 100; i++) {
        double away = 0.03 * i * THREAD_REACH, share = share_at(hole, away);
        assert_true(share >= last && share - last < 0.031);
        assert_true(away >= 0.999 * THREAD_REACH || share == 0.0);
        assert_true(away <= 2.001 * THREAD_REACH || share == 1.0);
        last = share;
    }
    assert_true(last == 1.0);
    stitch_case_end(&c);
}

/* ---- torn off */

static void torn_off_drain_keeps_thread(void **state)
{
    (void)state;
    stitch_case_begin(&c);
    c.options.rise = 1.5;
    c.options.drain.tear_stress = 5e3;
    stitch_case_make(&c);
    for (uint32_t i = 0; i < 300; i++) {
        stitch_case_shift(&c, 0, vec3_make(0.0, 0.1e-3, 0.0));
        stitch_case_shift(&c, 1, vec3_make(0.0, 0.1e-3, 0.0));
        stitch_case_step(&c);
    }
    vbss_drain_statistics d;
    expect_ok(vbss_drain_get_statistics(c.stitch.drain, &d, sizeof d));
    assert_true(d.torn > 0);
    assert_int_equal(c.watch.holes, 2);
    stitch_case_drop(&c, 0);
    stitch_case_drop(&c, 1);
    stitch_case_wait(&c, 300);
    assert_int_equal(c.watch.holes, 2);
    assert_int_equal(c.watch.crossings, 2);
    stitch_case_finish(&c, "torn off", SHARE);
}

/* ---- a mesh that adapts */

/* What has slid by less in a step is still, m. */
#define STILL 1e-6
/* Steps in which hands pull limbs apart, in which they rest, and all; and their speeds as they slacken them, m/s. */
enum { PULLED = 200, RESTED = 500, ALL = 1200 };
static const double slackens[] = {5e-3, 8e-3};

/* A change of the mesh is made at the end of a step and shows in the next. */
typedef struct hole_sample {
    vbss_scene_hole hole;
    bool still;   /* it has slid so little in the last step */
    bool changed; /* the mesh has changed at its end, while it was still */
} hole_sample;

typedef struct jumps {
    uint32_t changes, still, waited;
    double moved, jump;
} jumps;

/* Where the scene has waited nothing is still, and what comes next is what hands have done meanwhile. */
static void sample_hole(hole_sample *l, int side, bool changed, jumps *found)
{
    vbss_scene_hole now;
    assert_true(stitch_case_hole(&c, side, &now));
    const double change = fabs(now.arc_length - l->hole.arc_length);
    if (c.booked > 0 && l->changed) {
        vec3 before = vec3_load(l->hole.force);
        found->still++;
        found->moved = fmax(found->moved, change);
        found->jump = fmax(found->jump, vec3_distance(vec3_load(now.force), before));
    }
    l->still = c.booked > 0 && change < STILL;
    l->changed = changed && l->still;
    l->hole = now;
}

static void move_hands(uint32_t step, double slow)
{
    const double travel = step < PULLED ? 0.05 * c.h : step < RESTED ? 0.0 : -slow * c.h;
    for (int k = 0; k < 2 && travel != 0.0; k++) {
        stitch_case_shift(&c, k, vec3_make(0.0, 0.0, k == 0 ? -travel : travel));
    }
}

/* A change of the mesh is no slip: friction and arc length stay. Looked at is what happens when hands no longer pull: slack
 * limbs get nodes where they bend. */
static uint32_t change_meshes(double slow)
{
    jumps found = {0};
    hole_sample holes[2];
    stitch_case_begin(&c);
    c.options.crossings = 1;
    c.options.scene.node_capacity = 2048;
    c.options.thread.mesh = VBSS_THREAD_MESH_ADAPTIVE;
    c.options.segment = 1.2e-3;
    stitch_case_make(&c);
    for (int k = 0; k < 2; k++) {
        holes[k] = (hole_sample){.still = false};
        assert_true(stitch_case_hole(&c, k, &holes[k].hole));
    }
    for (uint32_t i = 0; i < ALL; i++) {
        uint32_t nodes = stitch_case_nodes(&c, c.stitch.thread_body);
        move_hands(i, slow);
        stitch_case_step(&c);
        bool changed = nodes != stitch_case_nodes(&c, c.stitch.thread_body);
        found.changes += changed;
        found.waited += c.booked == 0;
        for (int k = 0; k < 2; k++) {
            sample_hole(&holes[k], k, changed && i >= PULLED, &found);
        }
    }
    print_message("mesh: %u changes, %u steps waited, beside holes at rest %u: arc %.1f um, "
                  "force %.4f N at most\n",
                  found.changes, found.waited, found.still, 1e6 * found.moved, found.jump);
    assert_true(found.moved < 5e-6 && found.jump < 0.06);
    assert_int_equal(c.watch.holes, 2);
    assert_int_equal(c.watch.crossings, 2);
    stitch_case_finish(&c, "adaptive", SHARE);
    return found.still;
}

static void remeshing_keeps_hole_positions(void **state)
{
    (void)state;
    uint32_t still = 0;
    for (int i = 0; i < 2; i++) {
        still += change_meshes(slackens[i]);
    }
    assert_true(still > 0);
}

int test_stitch_continuity(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(contact_grows_gradually_outside_hole),
        cmocka_unit_test(torn_off_drain_keeps_thread),
        cmocka_unit_test(remeshing_keeps_hole_positions),
    };
    return cmocka_run_group_tests_name("scene.stitch_continuity", tests, NULL, NULL);
}
