/* What a log says of each step without a scene: what was told, what happened, when, and how it ends. */
#include "base/elementary.h"
#include "base/little_endian.h"
#include "damage.h"

enum { STEPS = 80, EVENTS = 512 };

/* What a host saw while it recorded. */
typedef struct seen {
    vbss_scene_event events[EVENTS];
    uint32_t event_count, events_after[STEPS + 1];
    uint64_t hashes[STEPS + 1];
} seen;

static void note_step(seen *v, stage *s, uint32_t step)
{
    uint32_t count;
    expect_ok(vbss_scene_take_events(s->scene, v->events + v->event_count, sizeof v->events[0],
                                     EVENTS - v->event_count, &count, NULL));
    v->event_count += count;
    assert_true(v->event_count < EVENTS);
    v->events_after[step] = v->event_count;
    v->hashes[step] = stage_hash(s);
}

static log_bytes log_seen(stage *s, const vbss_record_config *config, seen *v)
{
    log_bytes log = {NULL, 0};
    vbss_record *record;
    expect_ok(vbss_record_create(s->scene, config, &record));
    memset(v, 0, sizeof *v);
    for (uint32_t i = 1; i <= STEPS; i++) {
        stage_step(s, record);
        note_step(v, s, i);
        log_take(&log, record);
    }
    expect_ok(vbss_record_end(record));
    log_take(&log, record);
    return log;
}

static vbss_replay_logged_step read_step(vbss_replay *replay, uint64_t number)
{
    vbss_replay_logged_step step;
    expect_ok(vbss_replay_read(replay, number, &step, sizeof step));
    assert_int_equal(step.number, number);
    return step;
}

/* Four words: the kind, two bodies, and the id or the arc length in um. */
static void expect_logged(const vbss_scene_event *event, const uint32_t words[4], double h)
{
    const bool has_lost_time =
        event->kind == VBSS_SCENE_EVENT_TRUNCATED || event->kind == VBSS_SCENE_EVENT_PAUSED;
    assert_int_equal(words[0], has_lost_time ? VBSS_RECORD_EVENT_TIME_LOST : event->kind);
    assert_int_equal(words[1], has_lost_time ? 0 : event->body_a);
    assert_int_equal(words[2], has_lost_time ? 0 : event->body_b);
    if (has_lost_time) {
        expect_near(event->value, h * words[3] / 65536.0, h / 65536.0);
    } else if (event->arc_length != 0.0 && event->id == 0) {
        expect_near(1e6 * event->arc_length, words[3], 1.0);
    } else {
        assert_int_equal(words[3], event->id);
    }
}

static void scene_events_are_in_log(void **state)
{
    (void)state;
    static seen v;
    stage s;
    stage_begin(&s, NULL);
    log_bytes log = log_seen(&s, NULL, &v);
    assert_true(v.event_count > 10); /* a scene in which little happens would show little */
    vbss_replay *replay = replay_of(&s, &log);
    uint32_t found = 0;
    for (uint32_t i = 1; i <= STEPS; i++) {
        const vbss_replay_logged_step step = read_step(replay, i);
        assert_int_equal(step.event_count, v.events_after[i] - v.events_after[i - 1]);
        for (uint32_t k = 0; k < step.event_count; k++) {
            expect_logged(&v.events[found++], &step.events[4 * (size_t)k], step.h);
        }
    }
    assert_int_equal(found, v.event_count);
    stage_end(&s);
    log_free(&log);
}

static void hashes_times_and_positions_are_in_log(void **state)
{
    (void)state;
    static seen v;
    stage s;
    vbss_record_config config;
    vbss_replay_logged_step last = {.time = 0.0};
    expect_ok(vbss_record_config_init(&config, sizeof config));
    config.hash_interval = 3;
    config.snapshot_interval = 7; /* over which reading goes */
    stage_begin(&s, NULL);
    log_bytes log = log_seen(&s, &config, &v);
    vbss_replay *replay = replay_of(&s, &log);
    for (uint32_t i = 1; i <= STEPS; i++) {
        const vbss_replay_logged_step step = read_step(replay, i);
        assert_int_equal(step.hashed, i % 3 == 0);
        assert_true(step.hash == (i % 3 == 0 ? v.hashes[i] : 0));
        expect_same_bits(1e-3, step.h);
        expect_same_bits(last.time + step.h, step.time);
        assert_int_equal(step.position, log_find(&log, STEP, i).next);
        last = step;
    }
    stage_end(&s);
    log_free(&log);
}

static void inputs_are_read_as_given(void **state)
{
    (void)state;
    stage s;
    stage_begin(&s, NULL);
    log_bytes log = log_of(&s, NULL, 45);
    vbss_replay *replay = replay_of(&s, &log);
    uint32_t kinds[VBSS_RECORD_INPUT_EXCHANGE + 1] = {0};
    for (uint32_t i = 1; i <= 45; i++) {
        const vbss_replay_logged_step step = read_step(replay, i);
        assert_true(step.input_count >= 2);
        const vbss_record_input *first = step.inputs, *second = step.inputs + 1;
        double t = 1e-3 * (i - 1);
        assert_int_equal(first->kind, VBSS_RECORD_INPUT_RIGID_TARGET);
        assert_int_equal(first->words[0], s.tools[0]);
        assert_int_equal(first->words[1], 0); /* not turned */
        expect_same_bits(0.093 + -0.01 * (1.0 - vbss_cos(20.0 * t)), first->numbers[0]);
        assert_int_equal(second->words[0], s.tools[1]);
        assert_int_equal(second->words[1], 1);
        expect_same_bits(0.2 * vbss_sin(40.0 * t), second->numbers[5]);
        for (uint32_t k = 0; k < step.input_count; k++) {
            const vbss_record_input *input = &step.inputs[k];
            assert_true(input->kind > 0 && input->kind <= VBSS_RECORD_INPUT_EXCHANGE);
            assert_true(input->word_count <= 4 && input->number_count <= 12 && !input->reserved);
            kinds[input->kind]++;
        }
    }
    for (int kind = VBSS_RECORD_INPUT_RIGID_TARGET; kind <= VBSS_RECORD_INPUT_DETACH; kind++) {
        assert_true(kinds[kind] > 0); /* the stage tells all of these */
    }
    stage_end(&s);
    log_free(&log);
}

static void steps_are_read_in_any_order_beside_replay(void **state)
{
    (void)state;
    stage s;
    vbss_replay_logged_step step;
    vbss_replay_report report;
    stage_begin(&s, NULL);
    log_bytes log = log_of(&s, NULL, 12);
    vbss_replay *replay = replay_of(&s, &log);
    expect_ok(vbss_replay_begin(replay, s.scene));
    const uint64_t order[] = {5, 6, 1, 12, 12, 2, 11};
    for (size_t i = 0; i < sizeof order / sizeof order[0]; i++) {
        step = read_step(replay, order[i]);
        assert_int_equal(step.position, log_find(&log, STEP, (uint32_t)order[i]).next);
        expect_near(1e-3 * (double)order[i], step.time, 1e-12);
        expect_ok(vbss_replay_step(replay, &report, sizeof report));
        assert_int_equal(report.agreed_step, i + 1);
        expect_result(VBSS_ERROR_NOT_FOUND, vbss_replay_read(replay, 13, &step, sizeof step));
        expect_result(VBSS_ERROR_NOT_FOUND, vbss_replay_read(replay, 0, &step, sizeof step));
    }
    stage_end(&s);
    log_free(&log);
}

static void readable_part_of_damaged_log_is_read(void **state)
{
    (void)state;
    damage d;
    vbss_replay_logged_step step;
    damage_begin(&d, 8);
    log_bytes cut = {d.good.bytes, log_find(&d.good, STEP, 6).next - 1};
    vbss_replay *replay = replay_of(&d.s, &cut);
    expect_result(VBSS_ERROR_TRUNCATED, vbss_replay_read(replay, 6, &step, sizeof step));
    (void)read_step(replay, 5);
    d.good.bytes[log_find(&d.good, STEP, 4).at + 30] ^= 1;
    expect_result(VBSS_ERROR_CORRUPT, vbss_replay_read(replay, 4, &step, sizeof step));
    (void)read_step(replay, 3);
    damage_end(&d);
}

/* Of an older library: the same begin but for the format. */
static void older_format_is_rejected_by_name(void **state)
{
    (void)state;
    damage d;
    vbss_replay *replay;
    damage_begin(&d, 2);
    store_little_endian(d.good.bytes + 4, 1, 4);
    log_seal(&d.good);
    expect_result(VBSS_ERROR_DATA_VERSION,
                  vbss_replay_create(d.s.context, d.good.bytes, d.good.count, &replay));
    assert_non_null(strstr(last_text(d.s.context), "older library"));
    damage_end(&d);
}

int test_reading(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scene_events_are_in_log),
        cmocka_unit_test(hashes_times_and_positions_are_in_log),
        cmocka_unit_test(inputs_are_read_as_given),
        cmocka_unit_test(steps_are_read_in_any_order_beside_replay),
        cmocka_unit_test(readable_part_of_damaged_log_is_read),
        cmocka_unit_test(older_format_is_rejected_by_name),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
