/* Hands that ease: they follow a thread that draws, and none that pushes. Senses are made up; nothing is simulated. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "throw/ease.h"

#define STEP 1e-3
#define TAIL 20e-3 /* m, of W from the knot */
#define LIMB 80e-3 /* m, of C, on the other side */

typedef struct rig {
    hand w, c;
    senses see;
    ease_run easing;
    double took;
} rig;

static void begin(rig *r)
{
    memset(r, 0, sizeof *r);
    r->w.side = r->c.side = r->w.nature.speed = r->c.nature.speed = 1.0;
    r->see.w = &r->w;
    r->see.c = &r->c;
    r->see.tail_root = 1;
    r->see.limb_root = 2; /* both where the knot is: at 0 */
    r->see.tool_w.tip = v3(TAIL, 0.0, 0.0);
    r->see.tool_c.tip = r->see.held_c = v3(-LIMB, 0.0, 0.0);
    r->w.goal = r->see.tool_w.tip;
    r->c.goal = r->see.tool_c.tip;
    ease_begin(&r->easing, &r->see);
}

/* Tools are where they are told to be. W feels `pull` away from the knot until it is `until` from it. */
static bool ease(rig *r, double pull, double until)
{
    r->w.pull = v3(r->see.tool_w.tip.x > until ? pull : 0.0, 0.0, 0.0);
    senses_feel(&r->see);
    bool done = ease_step(&r->easing, &r->see, STEP);
    r->see.tool_w.tip = r->w.goal;
    r->see.tool_c.tip = r->see.held_c = r->c.goal;
    r->took += STEP;
    return done;
}

static void ease_all(rig *r, double pull, double until)
{
    begin(r);
    while (!ease(r, pull, until)) {
        assert_true(r->took < 10.0);
    }
}

/* A bent tail pushes the harder, the nearer W comes to the knot: followed, it would be a loop. */
static void pushing_tail_is_not_followed(void **state)
{
    static rig r;
    (void)state;
    ease_all(&r, 0.12, 0.0);
    assert_true(r.took < 0.5);
    assert_true(r.see.tool_w.tip.x > TAIL - 1e-3);
}

static void drawing_end_is_followed_until_it_stops(void **state)
{
    static rig r;
    (void)state;
    ease_all(&r, -0.3, TAIL - 6e-3);
    assert_true(r.took < 2.5);
    assert_true(r.see.tool_w.tip.x < TAIL - 6e-3);
    assert_true(r.see.tool_w.tip.x > TAIL - 8e-3);
}

static void endlessly_drawing_end_is_released_after_3_s(void **state)
{
    static rig r;
    (void)state;
    ease_all(&r, -0.3, -1.0);
    assert_true(fabs(r.took - 3.0) < 2.0 * STEP);
}

static void slack_end_stays(void **state)
{
    static rig r;
    (void)state;
    ease_all(&r, -0.3, TAIL - 6e-3);
    assert_true(r.see.tool_c.tip.x < -LIMB + 1e-3);
}

int test_end_release(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pushing_tail_is_not_followed),
        cmocka_unit_test(drawing_end_is_followed_until_it_stops),
        cmocka_unit_test(endlessly_drawing_end_is_released_after_3_s),
        cmocka_unit_test(slack_end_stays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
