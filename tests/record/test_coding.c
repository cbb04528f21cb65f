/* Numbers, steps and snapshots come back from their coded form to the bit, and damaged forms are refused. */
#include <float.h>
#include <math.h>

#include "base/elementary.h"
#include "fixture.h"
#include "harness/float_modes.h"
#include "record/step_codec.h"
#include "record/compression.h"

/* Kinds of inputs that coded steps can have. */
enum { CODED_KINDS = 15 };

enum { ROOM = 1 << 16, INPUTS = 40 };

/* ---- numbers */

static void expect_numbers_back(const double *numbers, uint32_t count, size_t max_bytes)
{
    static uint8_t bytes[ROOM];
    log_predictor written = {.order_count = 0}, read = {.order_count = 0};
    log_bits out = {.out = bytes, .count = sizeof bytes};
    for (uint32_t i = 0; i < count; i++) {
        vbss_log_put_number(&out, &written, numbers[i]);
        vbss_log_update_predictor(&written, numbers[i]);
    }
    assert_false(out.overrun);
    assert_true(log_bits_bytes(&out) <= max_bytes);
    log_bits in = {.in = bytes, .count = log_bits_bytes(&out)};
    for (uint32_t i = 0; i < count; i++) {
        double x = vbss_log_get_number(&in, &read);
        assert_memory_equal(&x, &numbers[i], sizeof x);
        vbss_log_update_predictor(&read, x);
    }
    assert_true(vbss_log_bits_are_complete(&in));
}

static void hard_numbers_round_trip_bit_exact(void **state)
{
    (void)state;
    const double hard[] = {
        0.0,       -0.0,       0.0,         -0.0,     DBL_MAX, -DBL_MAX,
        DBL_MAX,   DBL_MAX,    DBL_MAX,     -DBL_MAX, DBL_MIN, -DBL_MIN,
        0x1p-1074, -0x1p-1074, 0x1.8p-1060, 1.0,      -1.0,    0x1.fffffffffffffp0,
        2.0,       1e300,      -1e-300,     1e300,    5e-324,  0.1};
    const uint32_t count = sizeof hard / sizeof hard[0];
    expect_numbers_back(hard, count, (size_t)count * LOG_MAX_NUMBER_BITS / 8 + 1);
}

static void smooth_numbers_take_below_three_bytes(void **state)
{
    (void)state;
    enum { COUNT = 2000 };
    static double numbers[COUNT];
    for (int i = 0; i < COUNT; i++) {
        numbers[i] = 0.05 + 0.01 * vbss_sin(8e-3 * i) + 1e-4 * vbss_cos(0.05 * i);
    }
    expect_numbers_back(numbers, COUNT, (size_t)3 * COUNT);
    for (int i = 0; i < COUNT; i++) {
        numbers[i] = 0.56;
    }
    expect_numbers_back(numbers, COUNT, COUNT / 8 + 16); /* a bit, where nothing moves */
}

/* ---- steps */

typedef struct book {
    harness_memory memory;
    vbss_context *context;
    log_coder *writer, *reader;
    log_step step, found; /* found: as it was read */
} book;

static void make_step(vbss_context *context, log_step *step)
{
    step->input_capacity = INPUTS;
    expect_ok(vbss_log_allocate_inputs(context, step));
    expect_ok(vbss_log_allocate_events(context, step, INPUTS));
}

static void book_begin(book *b)
{
    memset(b, 0, sizeof *b);
    b->context = harness_context(&b->memory);
    expect_ok(vbss_log_make_coder(b->context, INPUTS, &b->writer));
    expect_ok(vbss_log_make_coder(b->context, INPUTS, &b->reader));
    make_step(b->context, &b->step);
    make_step(b->context, &b->found);
}

static void book_end(book *b)
{
    for (log_step *step = &b->step; step != NULL; step = step == &b->step ? &b->found : NULL) {
        vbss_log_free_inputs(b->context, step);
        vbss_log_free_events(b->context, step);
    }
    vbss_log_free_coder(b->context, b->writer);
    vbss_log_free_coder(b->context, b->reader);
    harness_context_end(b->context, &b->memory);
}

static double draw_number(harness_source *source)
{
    const double some[] = {0.0, -0.0, 1.0, DBL_MAX, -DBL_MAX, 5e-324};
    return harness_draw_below(source, 4) == 0 ? some[harness_draw_below(source, 6)]
                                              : harness_draw_real(source, -1.0, 1.0);
}

/* More bodies than a coder has room to remember, lists that stay and lists that change. */
static void draw_step(harness_source *source, log_step *step)
{
    step->number++;
    step->h = harness_draw_below(source, 3) == 0 ? draw_number(source) : step->h;
    step->has_hash = harness_draw_below(source, 2);
    step->hash = step->has_hash != 0 ? 0x123456789abcdef0u * step->number : 0;
    if (harness_draw_below(source, 3) == 0) {
        step->input_count = harness_draw_below(source, INPUTS + 1);
        for (uint32_t i = 0; i < step->input_count; i++) {
            step->kinds[i] = (uint8_t)(1 + harness_draw_below(source, CODED_KINDS));
            step->inputs[i] = (vbss_record_input){.kind = step->kinds[i]};
            for (uint32_t n = 0; n < vbss_log_input_shapes[step->kinds[i]].words; n++) {
                step->inputs[i].words[n] = harness_draw_below(source, 8) == 0
                                               ? UINT32_MAX
                                               : harness_draw_below(source, 50);
            }
        }
    }
    for (uint32_t i = 0; i < step->input_count; i++) {
        for (uint32_t n = 0; n < vbss_log_input_shapes[step->kinds[i]].numbers; n++) {
            step->inputs[i].numbers[n] = draw_number(source);
        }
    }
    step->event_count = harness_draw_below(source, 4) == 0 ? harness_draw_below(source, INPUTS) : 0;
    for (uint32_t i = 0; i < step->event_count; i++) {
        step->events[i][0] = harness_draw_below(source, 9);
        step->events[i][3] = UINT32_MAX - step->events[i][0];
    }
}

static void expect_same_step(const log_step *a, const log_step *b)
{
    assert_int_equal(a->number, b->number);
    assert_int_equal(a->has_hash, b->has_hash);
    assert_true(a->hash == b->hash);
    assert_memory_equal(&a->h, &b->h, sizeof a->h);
    assert_int_equal(a->input_count, b->input_count);
    assert_int_equal(a->event_count, b->event_count);
    for (uint32_t i = 0; i < a->input_count; i++) {
        const log_input_shape shape = vbss_log_input_shapes[a->kinds[i]];
        assert_int_equal(a->kinds[i], b->kinds[i]);
        assert_int_equal(b->inputs[i].kind, a->kinds[i]);
        assert_int_equal(b->inputs[i].word_count, shape.words);
        assert_int_equal(b->inputs[i].number_count, shape.numbers);
        assert_memory_equal(a->inputs[i].words, b->inputs[i].words, 4 * (size_t)shape.words);
        assert_memory_equal(a->inputs[i].numbers, b->inputs[i].numbers, 8 * (size_t)shape.numbers);
    }
    assert_memory_equal(a->events, b->events, 16 * (size_t)a->event_count);
}

static void code_steps(harness_source *source, void *user)
{
    static uint8_t bytes[ROOM];
    book b;
    (void)user;
    book_begin(&b);
    for (uint32_t i = 0; i < 12; i++) {
        draw_step(source, &b.step);
        const size_t largest = vbss_log_max_coded_bytes(&b.step, b.step.event_count);
        if (harness_draw_below(source, 5) == 0) {
            vbss_log_reset_coder(b.writer);
        }
        const size_t count = vbss_log_encode(b.writer, &b.step, bytes, sizeof bytes);
        assert_true(count > 0 && count <= largest);
        /* What is refused is not remembered: the step can be read afterwards. */
        if (count > 1) {
            const size_t cut = harness_draw_below(source, (uint32_t)count);
            assert_non_null(vbss_log_decode(b.reader, i, bytes, cut, &b.found));
        }
        assert_non_null(vbss_log_decode(b.reader, i + 1, bytes, count, &b.found));
        bytes[count] = 0;
        assert_non_null(vbss_log_decode(b.reader, i, bytes, count + 1, &b.found));
        assert_null(vbss_log_decode(b.reader, i, bytes, count, &b.found));
        expect_same_step(&b.step, &b.found);
    }
    book_end(&b);
}

static void steps_round_trip(void **state)
{
    (void)state;
    harness_property("steps", 300, code_steps, NULL);
}

static void dependent_step_is_rejected_as_keyframe(void **state)
{
    (void)state;
    uint8_t bytes[64];
    book b;
    book_begin(&b);
    b.step.h = 1e-3;
    for (b.step.number = 1; b.step.number <= 2; b.step.number++) {
        const size_t count = vbss_log_encode(b.writer, &b.step, bytes, sizeof bytes);
        const char *problem = vbss_log_decode(b.reader, b.step.number - 1, bytes, count, &b.found);
        if (b.step.number == 1) {
            assert_null(problem);
            vbss_log_reset_coder(b.reader);
        } else {
            assert_non_null(strstr(problem, "alone"));
        }
    }
    book_end(&b);
}

static void decode_anything(harness_source *source, void *user)
{
    uint8_t bytes[80];
    book *b = user;
    const uint32_t count = harness_draw_below(source, sizeof bytes);
    for (uint32_t i = 0; i < count; i++) {
        bytes[i] = (uint8_t)harness_draw_below(source, 256);
    }
    if (count > 0 && harness_draw_below(source, 2) == 0) {
        bytes[0] = (uint8_t)(bytes[0] & 0x1eu) | 0x21u; /* the first step, alone */
    }
    if (vbss_log_decode(b->reader, 0, bytes, count, &b->found) == NULL) {
        assert_true(isfinite(b->found.h) && b->found.input_count <= INPUTS);
        for (uint32_t i = 0; i < b->found.input_count; i++) {
            for (uint32_t n = 0; n < b->found.inputs[i].number_count; n++) {
                assert_true(isfinite(b->found.inputs[i].numbers[n]));
            }
        }
    }
}

static void any_bits_decode_or_are_rejected(void **state)
{
    (void)state;
    book b;
    book_begin(&b);
    harness_property("any bits", 2000, decode_anything, &b);
    book_end(&b);
}

/* ---- packed bytes */

static void pack_and_unpack(harness_source *source, void *user)
{
    enum { MAX_COUNT = 3000 };
    static uint32_t table[LOG_HASH_TABLE_SIZE];
    uint8_t raw[MAX_COUNT], packed[2 * MAX_COUNT], back[MAX_COUNT];
    const uint32_t count = harness_draw_below(source, MAX_COUNT),
                   kinds = 1 + harness_draw_below(source, 4);
    (void)user;
    for (uint32_t i = 0; i < count; i++) { /* of few different bytes, so that much repeats */
        raw[i] = (uint8_t)(harness_draw_below(source, 8) == 0 ? harness_draw_below(source, 256)
                                                              : i / 4 % kinds);
    }
    const size_t size = vbss_log_compress(table, raw, count, packed, sizeof packed);
    assert_true(count == 0 || size > 0);
    assert_true(vbss_log_decompress(packed, size, NULL, count));
    assert_true(vbss_log_decompress(packed, size, back, count));
    assert_memory_equal(raw, back, count);
    if (size > 0) {
        assert_int_equal(vbss_log_compress(table, raw, count, packed, size - 1), 0);
        assert_int_equal(vbss_log_compress(table, raw, count, packed, size), size);
        assert_false(vbss_log_decompress(packed, size - 1, back, count));
        assert_false(vbss_log_decompress(packed, size, back, count + 4));
        packed[harness_draw_below(source, (uint32_t)size)] ^=
            (uint8_t)(1 + harness_draw_below(source, 255));
        (void)vbss_log_decompress(packed, size, back, count); /* any bytes do no harm */
    }
}

static void packed_bytes_round_trip(void **state)
{
    (void)state;
    harness_property("packed bytes", 400, pack_and_unpack, NULL);
}

static void long_runs_compress(void **state)
{
    (void)state;
    static uint32_t table[LOG_HASH_TABLE_SIZE];
    static uint8_t raw[400000], packed[8000], back[400000];
    const size_t size = vbss_log_compress(table, raw, sizeof raw, packed, sizeof packed);
    assert_true(size > 0 && size < 500);
    assert_true(vbss_log_decompress(packed, size, back, sizeof back));
    assert_memory_equal(raw, back, sizeof back);
}

/* ---- the floating-point mode of the host */

static void host_mode_does_not_change_a_log(void **state)
{
    (void)state;
    stage s;
    stage_begin(&s, NULL);
    log_bytes log = log_of(&s, NULL, 40);
    stage_end(&s);
    for (size_t k = 0; k < harness_mode_count; k++) {
        vbss_replay_report found;
        vbss_record *record;
        uint64_t steps, position;
        stage_begin(&s, NULL);
        vbss_replay *replay = replay_of(&s, &log);
        harness_mode_set(k);
        const vbss_result results[] = {
            vbss_replay_begin(replay, s.scene),
            vbss_replay_check(replay, &steps),
            vbss_replay_seek(replay, 25, &found, sizeof found),
            vbss_record_resume(replay, NULL, &record, &position),
        };
        harness_mode_end(k);
        for (size_t n = 0; n < sizeof results / sizeof results[0]; n++) {
            expect_ok(results[n]);
        }
        assert_int_equal(steps, 40);
        assert_int_equal(found.agreed_step, 25);
        stage_end(&s);
    }
    log_free(&log);
}

int test_coding(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hard_numbers_round_trip_bit_exact),
        cmocka_unit_test(smooth_numbers_take_below_three_bytes),
        harness_test(steps_round_trip),
        cmocka_unit_test(dependent_step_is_rejected_as_keyframe),
        harness_test(any_bits_decode_or_are_rejected),
        harness_test(packed_bytes_round_trip),
        cmocka_unit_test(long_runs_compress),
        cmocka_unit_test(host_mode_does_not_change_a_log),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
