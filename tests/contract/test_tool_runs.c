/* Scripted runs of scenes with graspers, needles and shears. */
#include <float.h>

#include "base/error.h"
#include "contract/contract.h"
#include "contract/events.h"
#include "fixtures/cutting_scene.h"
#include "fixtures/needle_scenes.h"
#include "fixtures/puncture_scenes.h"
#include "fixtures/tool_scenes.h"
#include "scene/api/api.h"
#include "scene/small.h"
#include "scene/tools/tools.h"
#include "scene/world/world.h"

static vbss_result destroy(void *handle)
{
    return vbss_scene_destroy(handle);
}

/* ---- a needle that is taken, lifted, handed over and dropped */

static vbss_result needle_create(vbss_context *context, void *user, void **handle)
{
    (void)user;
    return needle_scene_create(context, (vbss_scene **)handle);
}

static vbss_result needle_step(void *handle)
{
    return needle_scene_step(handle);
}

/* One moment of the script: whether each tool holds the needle, and the height of its ends. */
typedef struct needle_moment {
    size_t step;
    bool first, second;
    double height, speed_limit;
} needle_moment;

#define WIRE 0.35e-3

static const needle_moment needle_moments[] = {
    {NEEDLE_SCENE_LYING, false, false, WIRE, 1e-5},
    {NEEDLE_SCENE_TAKEN, true, false, WIRE, 1e-5},
    {NEEDLE_SCENE_LIFTED, true, false, WIRE + NEEDLE_SCENE_LIFT, 1e-5},
    {NEEDLE_SCENE_BOTH, true, true, WIRE + NEEDLE_SCENE_LIFT, 1e-5},
    {NEEDLE_SCENE_HANDED, false, true, WIRE + NEEDLE_SCENE_LIFT, 1e-2},
    {NEEDLE_SCENE_DROPPED, false, false, WIRE, 1e-5},
};
enum { NEEDLE_MOMENTS = sizeof needle_moments / sizeof needle_moments[0] };

static vec3 check_needle_moment(const small *s, const needle_moment *m)
{
    const scene_object *scene = small_object(s);
    const scene_rigid *r = &vbss_scene_body(scene, NEEDLE_SCENE_NEEDLE)->rigid;
    vbss_needle_state needle;
    expect_ok(vbss_needle_get_state((vbss_needle *)r->slot, &needle, sizeof needle));
    assert_int_equal(vbss_scene_has_needle_grasp(scene, NEEDLE_SCENE_FIRST), m->first);
    assert_int_equal(vbss_scene_has_needle_grasp(scene, NEEDLE_SCENE_SECOND), m->second);
    assert_true(vec3_norm(r->body.now.v) + 0.03 * vec3_norm(r->body.now.w) < m->speed_limit);
    expect_near(m->height, needle.tip[2], 1e-4);
    expect_near(m->height, needle.swage[2], 1e-4);
    return vec3_load(needle.position);
}

static void needle_is_handed_over(const contract_run *run)
{
    small s;
    void *scene = NULL;
    size_t next = 0;
    vec3 at[NEEDLE_MOMENTS];
    event_counts counts = {{0}};
    small_begin(&s);
    expect_ok(run->body.create(s.context, run->body.user, &scene));
    s.scene = scene;
    for (size_t i = 0; i < NEEDLE_SCENE_STEPS; i++) {
        if (next < NEEDLE_MOMENTS && i == needle_moments[next].step) {
            at[next] = check_needle_moment(&s, &needle_moments[next]);
            next++;
        }
        expect_ok(run->body.step(scene));
        count_events(scene, &counts);
    }
    assert_int_equal(next, NEEDLE_MOMENTS);
    assert_int_equal(counts.of[VBSS_SCENE_EVENT_GRASP], 2);
    assert_int_equal(counts.of[VBSS_SCENE_EVENT_RELEASE], 2);
    assert_int_equal(counts.of[VBSS_SCENE_EVENT_TORN], 0);
    assert_true(vec3_distance(at[NEEDLE_MOMENTS - 1], at[0]) > 0.5 * NEEDLE_SCENE_CARRY);
    assert_int_equal(small_statistics(&s).clamped, 0);
    assert_int_equal(small_statistics(&s).paused, 0);
    small_end(&s);
}

/* Grasps that cannot be. */
static void spoil_needle_grasp(void *handle, uint32_t which)
{
    scene_object *s = NULL;
    expect_ok(vbss_scene_open(handle, &s));
    scene_needle_grasp *hold = &vbss_scene_body(s, NEEDLE_SCENE_FIRST)->rigid.needle_grasp;
    double *numbers[] = {&hold->age,   &hold->slid,    &hold->turned,
                         &hold->limit, &hold->force.x, &hold->torque.z};
    const uint32_t no_needles[] = {NEEDLE_SCENE_THREAD, NEEDLE_SCENE_SECOND, 77};
    if (which < 3) {
        hold->needle = no_needles[which];
    } else if (which < 9) {
        *numbers[which - 3] = DBL_MAX * 10.0;
    } else if (which == 9) {
        hold->arc = -1e-3;
    } else if (which == 10) {
        hold->arc = 0.04;
    } else if (which == 11) {
        hold->angle = 0.0;
    } else if (which == 12) {
        hold->pose_in_jaws.position.y = 3.0;
    } else {
        hold->pose_in_jaws.orientation.w += 0.1;
    }
}

/* ---- graspers that hold a thread */

static vbss_result tools_create(vbss_context *context, void *user, void **handle)
{
    return tool_scene_create(context, *(const vbss_method *)user, (vbss_scene **)handle);
}

static vbss_result tools_step(void *handle)
{
    return tool_scene_step(handle);
}

/* One moment of the script: the threads that each tool holds, which the published method gives to the first alone. */
typedef struct tool_moment {
    size_t step;
    uint32_t first, second;
    bool second_slides;
} tool_moment;

static const tool_moment tool_moments[] = {
    {TOOL_SCENE_CLOSING, 0, 0, false}, {TOOL_SCENE_TAKEN, 1, 0, false},
    {TOOL_SCENE_DRAWN, 1, 0, false},   {TOOL_SCENE_SLIDING, 1, 1, true},
    {TOOL_SCENE_LET_GO, 1, 0, false},
};
enum { TOOL_MOMENTS = sizeof tool_moments / sizeof tool_moments[0] };

static void check_tool_moment(const scene_object *scene, const tool_moment *m, vbss_method method)
{
    const bool ours = method == VBSS_METHOD_IMPLICIT;
    const double angle = vbss_scene_body(scene, 2)->rigid.grasper->jaw_angle;
    assert_int_equal(vbss_scene_count_grasps(scene, 2), m->first);
    assert_int_equal(vbss_scene_count_grasps(scene, 3), ours ? m->second : 0);
    assert_true(m->first > 0 || (angle > 0.05 && angle < 0.34));
    if (ours && m->second_slides) {
        assert_true(scene->thread_grasps[1].is_sliding);
        assert_true(scene->thread_grasps[1].slid > 1e-4);
    }
}

static void tools_take_and_let_go(const contract_run *run)
{
    small s;
    void *scene = NULL;
    size_t next = 0;
    event_counts counts = {{0}};
    small_begin(&s);
    expect_ok(run->body.create(s.context, run->body.user, &scene));
    s.scene = scene;
    for (size_t i = 0; i < TOOL_SCENE_ROUND; i++) {
        if (next < TOOL_MOMENTS && i == tool_moments[next].step) {
            check_tool_moment(small_object(&s), &tool_moments[next++],
                              *(const vbss_method *)run->body.user);
        }
        expect_ok(run->body.step(scene));
        count_events(scene, &counts);
    }
    assert_int_equal(next, TOOL_MOMENTS);
    assert_int_equal(counts.of[VBSS_SCENE_EVENT_GRASP], counts.of[VBSS_SCENE_EVENT_RELEASE]);
    assert_true(counts.of[VBSS_SCENE_EVENT_GRASP] >= 1);
    assert_int_equal(counts.of[VBSS_SCENE_EVENT_EXCHANGED], 2);
    assert_int_equal(counts.of[VBSS_SCENE_EVENT_NOT_EXCHANGED], 1);
    assert_int_equal(small_statistics(&s).clamped, 0);
    small_end(&s);
}

/* ---- a needle that turns into both walls of a drain and back */

static vbss_result pricked_create(vbss_context *context, void *user, void **handle)
{
    vbss_scene_config config;
    vbss_drain_config wall;
    puncture_scene made;
    VBSS_TRY(puncture_scene_configs(&config, &wall));
    config.hole_capacity = *(const uint32_t *)user;
    VBSS_TRY(puncture_scene_create(context, &config, &wall, &made));
    *handle = made.scene;
    return VBSS_OK;
}

static vbss_result pricked_step(void *handle)
{
    return puncture_scene_step_of(handle, 0.1, 1e-3);
}

/* Saves 63 to 73 are about the first entry, 170 to 185 about the second. */
static void needle_goes_in_and_out(const contract_run *run)
{
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    void *scene = NULL;
    event_counts counts = {{0}};
    expect_ok(run->body.create(context, run->body.user, &scene));
    for (int i = 0; i < 420; i++) {
        expect_ok(run->body.step(scene));
        count_events(scene, &counts);
    }
    assert_int_equal(counts.of[VBSS_SCENE_EVENT_PUNCTURE], 2);
    assert_int_equal(counts.of[VBSS_SCENE_EVENT_WITHDRAWN], 2);
    harness_context_end(context, &memory);
}

/* ---- shears that cut a held thread */

static vbss_result cutting_create(vbss_context *context, void *user, void **handle)
{
    return cutting_scene_create(context, *(const vbss_method *)user, (vbss_scene **)handle);
}

static vbss_result cutting_step(void *handle)
{
    return cutting_scene_step(handle);
}

static void shears_cut_twice(const contract_run *run)
{
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    void *scene = NULL;
    scene_object *s = NULL;
    vbss_grasper_state driver;
    uint32_t cuts = 0;
    expect_ok(run->body.create(context, run->body.user, &scene));
    for (uint32_t i = 1; i <= CUTTING_SCENE_STEPS; i++) {
        expect_ok(run->body.step(scene));
        const uint32_t now = count_cuts(scene);
        cuts += now;
        assert_true(now == 0 || i == CUTTING_SCENE_CUT || i > CUTTING_SCENE_CLOSED_AGAIN);
        assert_true(i >= CUTTING_SCENE_CUT || cuts == 0);
        assert_true(i < CUTTING_SCENE_CUT || i >= CUTTING_SCENE_CLOSED_AGAIN + 40 || cuts == 1);
    }
    assert_int_equal(cuts, 2);
    expect_ok(vbss_scene_open(scene, &s));
    expect_ok(vbss_grasper_get_state((vbss_grasper *)vbss_scene_body(s, 2)->rigid.slot, &driver,
                                     sizeof driver));
    assert_int_equal(driver.grasp_count, 1);
    harness_context_end(context, &memory);
}

/* Before the step that cuts, after it, while the blades close through the ends, and later. */
#define CUTTING_RUN(title, method)                                                               \
    {                                                                                            \
        .name = (title),                                                                         \
        .body = {"shears that cut", &vbss_scene_kind, cutting_create,        NULL,               \
                 cutting_step,      destroy,          &(vbss_method){method}},                   \
        .saves =                                                                                 \
            {CUTTING_SCENE_EXCHANGED,   CUTTING_SCENE_CUT - 2,          CUTTING_SCENE_CUT - 1,   \
             CUTTING_SCENE_CUT,         CUTTING_SCENE_CUT + 1,          CUTTING_SCENE_CUT + 2,   \
             CUTTING_SCENE_OPENED + 10, CUTTING_SCENE_CLOSED_AGAIN + 42},                        \
        .save_count = 8, .continued = 30, .damages = {CUTTING_SCENE_CUT + 1}, .damage_count = 1, \
        .quiet = CUTTING_SCENE_STEPS, .covers = shears_cut_twice                                 \
    }

/* ---- */

int test_tool_runs(void)
{
    vbss_method ours = VBSS_METHOD_IMPLICIT, paper = VBSS_METHOD_VBLAST;
    uint32_t holes = 16, two_holes = 2;
    const contract_run runs[] = {
        /* Also as it is taken (300), settles in the jaws (320), and is let go (1099). */
        {.name = "needle in two hands",
         .body = {"needle", &vbss_scene_kind, needle_create, NULL, needle_step, destroy, NULL},
         .saves = {NEEDLE_SCENE_LYING, 300, 320, NEEDLE_SCENE_TAKEN, NEEDLE_SCENE_LIFTED,
                   NEEDLE_SCENE_BOTH, 1099, NEEDLE_SCENE_HANDED, NEEDLE_SCENE_DROPPED},
         .save_count = 9,
         .continued = 60,
         .damages = {NEEDLE_SCENE_BOTH},
         .damage_count = 1,
         .quiet = NEEDLE_SCENE_STEPS,
         .repeated = NEEDLE_SCENE_STEPS,
         .covers = needle_is_handed_over,
         .spoil = spoil_needle_grasp,
         .spoil_count = 14,
         .spoil_at = NEEDLE_SCENE_BOTH},
        {.name = "graspers",
         .body = {"tools", &vbss_scene_kind, tools_create, NULL, tools_step, destroy, &ours},
         .saves = {TOOL_SCENE_CLOSING, TOOL_SCENE_TAKEN, TOOL_SCENE_DRAWN, TOOL_SCENE_SLIDING,
                   TOOL_SCENE_LET_GO},
         .save_count = 5,
         .continued = 20,
         .damages = {TOOL_SCENE_DRAWN},
         .damage_count = 1,
         .quiet = TOOL_SCENE_ROUND,
         .covers = tools_take_and_let_go},
        {.name = "graspers, baseline",
         .body = {"tools", &vbss_scene_kind, tools_create, NULL, tools_step, destroy, &paper},
         .saves = {TOOL_SCENE_TAKEN},
         .save_count = 1,
         .continued = 10,
         .quiet = TOOL_SCENE_ROUND,
         .covers = tools_take_and_let_go},
        {.name = "needle in a drain",
         .body = {"pricked drain", &vbss_scene_kind, pricked_create, NULL, pricked_step, destroy,
                  &holes},
         .saves = {20, 55, 66, 70, 90, 120, 160, 176, 190, 220, 300},
         .save_count = 11,
         .continued = 25,
         .quiet = 400,
         .covers = needle_goes_in_and_out},
        {.name = "needle in a drain of two holes",
         .body = {"pricked drain", &vbss_scene_kind, pricked_create, NULL, pricked_step, destroy,
                  &two_holes},
         .damages = {190},
         .damage_count = 1},
        CUTTING_RUN("shears", VBSS_METHOD_IMPLICIT),
        CUTTING_RUN("shears, baseline", VBSS_METHOD_VBLAST),
    };
    return contract_check_runs("contract.tool_runs", runs, sizeof runs / sizeof runs[0]);
}
