/* What distinguishes the hands of an expert from those of a resident and a novice, as their devices delivered it. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "needle/stitch.h" /* whose pose is another than the library's: so no harness here */

#define STEP 1e-3
#define ROOM (8u << 20) /* bytes of a log */
#define expect_ok(call) assert_int_equal(VBSS_OK, (call))
enum { SECOND = 1000, SEEDS = 3 };

static const char *const names[] = {"expert", "resident", "novice"};

/* ---- two hands that were told nothing yet, for a second */

typedef struct rest {
    stitch hands;
    uint8_t *log;
    uint64_t size;
    uint64_t hash; /* of the scene in the end */
} rest;

static void take(rest *r)
{
    const uint8_t *bytes;
    uint64_t count;
    expect_ok(vbss_record_take(r->hands.site.rig.record, &bytes, &count));
    assert_true(r->size + count <= ROOM);
    memcpy(r->log + r->size, bytes, count);
    r->size += count;
}

static void begin(rest *r, const hand_skill *skill, uint64_t seed)
{
    stitch_plan plan;
    throw_rig *s = &r->hands.site.rig;
    memset(r, 0, sizeof *r);
    r->log = malloc(ROOM);
    assert_non_null(r->log);
    stitch_plan_usual(&plan);
    plan.skill = skill;
    expect_ok(stitch_create(&r->hands, seed, &plan));
    expect_ok(vbss_record_create(s->scene, NULL, &s->record));
    expect_ok(vbss_scene_set_recorder(s->scene, s->record));
    take(r);
    for (int i = 0; i < SECOND; i++) {
        expect_ok(hand_step(&r->hands.right, STEP));
        expect_ok(hand_step(&r->hands.left, STEP));
        expect_ok(vbss_scene_step(s->scene, STEP));
        take(r);
    }
    expect_ok(vbss_record_end(s->record));
    take(r);
    expect_ok(vbss_scene_get_hash(s->scene, &r->hash));
}

static void end(rest *r)
{
    free(r->log);
    throw_rig_destroy(&r->hands.site.rig);
}

/* From what the log says that the tool was told. */
static double recorded_tremor(const rest *r, const hand *h)
{
    static vec at[SECOND];
    vbss_replay *replay;
    vec mean = v3(0.0, 0.0, 0.0);
    double sum = 0.0;
    expect_ok(vbss_replay_create(r->hands.site.rig.context, r->log, r->size, &replay));
    for (uint64_t i = 0; i < SECOND; i++) {
        vbss_replay_logged_step step;
        uint32_t found = 0;
        expect_ok(vbss_replay_read(replay, i + 1, &step, sizeof step));
        for (uint32_t k = 0; k < step.input_count; k++) {
            const vbss_record_input *in = &step.inputs[k];
            if (in->kind == VBSS_RECORD_INPUT_GRASPER_TARGET && in->words[0] == h->body) {
                at[i] = v_load(in->numbers);
                found++;
            }
        }
        assert_int_equal(found, 1);
        mean = v_along(mean, 1.0 / SECOND, at[i]);
    }
    for (int i = 0; i < SECOND; i++) {
        double off = v_distance(at[i], mean);
        sum += off * off / SECOND;
    }
    expect_ok(vbss_replay_destroy(replay));
    return sqrt(2.0 * sum); /* two sines across each other, each of tremor / sqrt(2) */
}

/* ---- what is asked of them */

static void devices_deliver_requested_tremor(void **state)
{
    (void)state;
    static rest r;
    for (uint64_t seed = 1; seed <= SEEDS; seed++) {
        double expert = 0.0;
        for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
            const hand_skill *skill = skill_named(names[i]);
            assert_non_null(skill);
            begin(&r, skill, seed);
            double right = recorded_tremor(&r, &r.hands.right);
            double left = recorded_tremor(&r, &r.hands.left);
            expert = i == 0 ? right : expert;
            assert_true(fabs(right - r.hands.right.nature.tremor) < 1e-9);
            assert_true(fabs(left - r.hands.left.nature.tremor) < 1e-9);
            assert_true(fabs(right - skill->tremor * expert) < 1e-9);
            printf("  seed %u, %s: %.3f mm\n", (unsigned)seed, skill->name, 1e3 * right);
            end(&r);
        }
        assert_true(expert > 0.1e-3 && expert < 0.4e-3);
    }
}

static void default_skill_is_expert(void **state)
{
    (void)state;
    static rest none, expert, novice, again;
    begin(&none, NULL, 1);
    begin(&expert, skill_named("expert"), 1);
    begin(&novice, skill_named("novice"), 1);
    begin(&again, skill_named("novice"), 1);
    assert_int_equal(none.hash, expert.hash);
    assert_int_not_equal(none.hash, novice.hash);
    assert_int_equal(novice.hash, again.hash);
    assert_null(skill_named("surgeon"));
    end(&none);
    end(&expert);
    end(&novice);
    end(&again);
}

static void low_skill_is_slower_less_accurate_and_hesitates(void **state)
{
    (void)state;
    for (size_t i = 1; i < sizeof names / sizeof names[0]; i++) {
        const hand_skill *better = skill_named(names[i - 1]), *worse = skill_named(names[i]);
        assert_true(worse->speed < better->speed);
        assert_true(worse->tremor > better->tremor);
        assert_true(worse->target_at > better->target_at);
        assert_true(worse->hesitation > better->hesitation);
    }
}

static void hesitation_has_requested_length(void **state)
{
    (void)state;
    enum { THINGS = 2000 };
    hesitation h;
    uint64_t steps = 0;
    const hand_skill *skill = skill_named("novice");
    hesitation_begin(&h, skill, 1);
    for (int i = 0; i < THINGS; i++) {
        const char *doing = i % 2 == 0 ? "this" : "that";
        uint64_t before = steps;
        while (hesitates(&h, doing, STEP)) {
            steps++;
        }
        assert_true((double)(steps - before) * STEP <= 2.0 * skill->hesitation);
        assert_false(hesitates(&h, doing, STEP));
    }
    assert_true(fabs(STEP * (double)steps / THINGS - skill->hesitation) < 0.05 * skill->hesitation);
    hesitation_begin(&h, skill_named("expert"), 1);
    assert_false(hesitates(&h, "this", STEP));
}

int test_skill(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(devices_deliver_requested_tremor),
        cmocka_unit_test(default_skill_is_expert),
        cmocka_unit_test(low_skill_is_slower_less_accurate_and_hesitates),
        cmocka_unit_test(hesitation_has_requested_length),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
