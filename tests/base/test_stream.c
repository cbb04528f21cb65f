#include <math.h>
#include <string.h>

#include "harness/harness.h"

/* A state with every type of field, in a second version that added `added` at the end. */
typedef struct sample {
    double numbers[130]; /* more than one chunk of conversion */
    uint64_t words[2];
    uint32_t count;
    int32_t signs[3];
    uint8_t bytes[5];
    double added;
} sample;
#define SAMPLE_CODE VBSS_CODE('S', 'M', 'P', 'L')

static void visit(vbss_stream *stream, sample *s, uint16_t version)
{
    vbss_section outer = vbss_stream_open(stream, SAMPLE_CODE, version);
    vbss_stream_f64(stream, 1, s->numbers, 130);
    vbss_stream_u64(stream, 2, s->words, 2);
    vbss_stream_count(stream, 3, &s->count, 10);
    vbss_section inner = vbss_stream_open(stream, VBSS_CODE('I', 'N', 'N', 'R'), 1);
    vbss_stream_i32(stream, 1, s->signs, 3);
    vbss_stream_close(stream, inner);
    vbss_stream_u8(stream, 4, s->bytes, 5);
    if (stream->version >= 2) {
        vbss_stream_f64(stream, 5, &s->added, 1);
    } else {
        s->added = 0.25; /* the default of a field that version 1 did not have */
    }
    vbss_stream_close(stream, outer);
}

static sample make_sample(void)
{
    sample s = {.words = {1, UINT64_MAX},
                .count = 10,
                .signs = {-1, INT32_MIN, INT32_MAX},
                .bytes = {0, 1, 128, 255, 7},
                .added = -0.0};
    for (int i = 0; i < 130; i++) {
        s.numbers[i] = (i - 60) * 0x1.23456789abcdep-300;
    }
    s.numbers[129] = -0x1p-1074;
    return s;
}

static size_t write(sample *s, uint16_t version, uint8_t *bytes, size_t capacity)
{
    vbss_stream stream;
    vbss_stream_begin_write(&stream, bytes, capacity);
    visit(&stream, s, version);
    expect_ok(stream.result);
    return stream.position;
}

static void round_trip_is_bit_exact(void **state)
{
    (void)state;
    uint8_t bytes[2048];
    sample s = make_sample(), back = {.count = 3};
    size_t count = write(&s, 2, bytes, sizeof bytes);
    vbss_stream stream;
    vbss_stream_begin_read(&stream, bytes, count);
    visit(&stream, &back, 2);
    expect_ok(stream.result);
    assert_int_equal(stream.position, count);
    assert_memory_equal(s.numbers, back.numbers, sizeof s.numbers);
    assert_memory_equal(s.words, back.words, sizeof s.words);
    assert_int_equal(back.count, 10);
    assert_memory_equal(s.signs, back.signs, sizeof s.signs);
    assert_memory_equal(s.bytes, back.bytes, sizeof s.bytes);
    expect_same_bits(-0.0, back.added);
}

static void measure_and_hash_see_written_bytes(void **state)
{
    (void)state;
    uint8_t bytes[2048];
    sample s = make_sample();
    size_t count = write(&s, 2, bytes, sizeof bytes);
    vbss_stream measure, hash;
    vbss_stream_begin_measure(&measure);
    visit(&measure, &s, 2);
    assert_int_equal(measure.position, count);
    vbss_stream_begin_hash(&hash);
    visit(&hash, &s, 2);
    vbss_hash direct;
    vbss_hash_begin(&direct);
    vbss_hash_add(&direct, bytes, count);
    assert_true(vbss_hash_end(&hash.hash) == vbss_hash_end(&direct));
}

/* The format is for files that outlive the machine: spelled out byte by byte. */
static void bytes_are_little_endian_and_tagged(void **state)
{
    (void)state;
    uint8_t bytes[64];
    double number = -2.0;
    uint32_t word = 0x01020304;
    vbss_stream stream;
    vbss_stream_begin_write(&stream, bytes, sizeof bytes);
    vbss_section outer = vbss_stream_open(&stream, VBSS_CODE('A', 'B', 'C', 'D'), 0x0102);
    vbss_stream_f64(&stream, 0x1234, &number, 1);
    vbss_stream_u32(&stream, 2, &word, 1);
    vbss_stream_close(&stream, outer);
    expect_ok(stream.result);
    const uint8_t wanted[] = {
        0xfe, 0xff, 0x02, 0x01, 'A', 'B', 'C', 'D',                            /* section */
        0x34, 0x12, 1,    0,    1,   0,   0,   0,   0, 0, 0, 0, 0, 0, 0, 0xc0, /* -2.0 */
        2,    0,    3,    0,    1,   0,   0,   0,   4, 3, 2, 1,                /* word */
        0xff, 0xff, 0,    0,    0,   0,   0,   0,                              /* end */
    };
    assert_int_equal(stream.position, sizeof wanted);
    assert_memory_equal(bytes, wanted, sizeof wanted);
}

static void old_version_is_read_and_newer_rejected(void **state)
{
    (void)state;
    uint8_t bytes[2048];
    sample s = make_sample(), back = {.added = 3.0};
    size_t count = write(&s, 1, bytes, sizeof bytes);
    vbss_stream stream;
    vbss_stream_begin_read(&stream, bytes, count);
    visit(&stream, &back, 2);
    expect_ok(stream.result);
    expect_same_bits(0.25, back.added);
    assert_memory_equal(s.bytes, back.bytes, sizeof s.bytes);

    count = write(&s, 3, bytes, sizeof bytes);
    vbss_stream_begin_read(&stream, bytes, count);
    visit(&stream, &back, 2);
    expect_result(VBSS_ERROR_DATA_VERSION, stream.result);
}

static void section_bounds_its_content(void **state)
{
    (void)state;
    uint8_t bytes[256];
    double a = 1.5, more = 2.5;
    vbss_stream stream;
    vbss_stream_begin_write(&stream, bytes, sizeof bytes);
    vbss_section outer = vbss_stream_open(&stream, 1, 1);
    vbss_stream_f64(&stream, 1, &a, 1);
    vbss_stream_f64(&stream, 2, &more, 1);
    vbss_stream_close(&stream, outer);
    size_t count = stream.position;
    vbss_stream_begin_read(&stream, bytes, count);
    outer = vbss_stream_open(&stream, 1, 1);
    vbss_stream_f64(&stream, 1, &a, 1);
    vbss_stream_close(&stream, outer);
    expect_result(VBSS_ERROR_CORRUPT, stream.result);
    /* Nor is there anything in the end itself, or in a header's spare byte, or a version 0. */
    const size_t spare[] = {2, 8 + 3, count - 8 + 2, count - 8 + 7};
    for (int i = 0; i < 4; i++) {
        uint8_t kept = bytes[spare[i]];
        bytes[spare[i]] = i == 0 ? 0 : 9;
        vbss_stream_begin_read(&stream, bytes, count);
        outer = vbss_stream_open(&stream, 1, 1);
        vbss_stream_f64(&stream, 1, &a, 1);
        vbss_stream_f64(&stream, 2, &more, 1);
        vbss_stream_close(&stream, outer);
        expect_result(VBSS_ERROR_CORRUPT, stream.result);
        bytes[spare[i]] = kept;
    }
}

static void outer_section_resumes_after_inner(void **state)
{
    (void)state;
    uint8_t bytes[256];
    for (int reading = 0; reading < 2; reading++) {
        vbss_stream stream;
        if (reading) {
            vbss_stream_begin_read(&stream, bytes, sizeof bytes);
        } else {
            vbss_stream_begin_write(&stream, bytes, sizeof bytes);
        }
        vbss_section top = vbss_stream_open(&stream, 11, 3);
        vbss_section inner = vbss_stream_open(&stream, 22, 5);
        assert_int_equal(stream.section, 22);
        assert_int_equal(stream.version, 5);
        vbss_stream_close(&stream, inner);
        assert_int_equal(stream.section, 11);
        assert_int_equal(stream.version, 3);
        vbss_stream_close(&stream, top);
        expect_ok(stream.result);
        assert_int_equal(stream.section, 0);
    }
}

static void long_arrays_stream_in_chunks(void **state)
{
    (void)state;
    enum { COUNT = 150 };
    uint64_t words[COUNT], words_back[COUNT];
    int32_t signs[COUNT], signs_back[COUNT];
    uint8_t bytes[COUNT], bytes_back[COUNT], buffer[4096];
    for (int i = 0; i < COUNT; i++) {
        words[i] = (uint64_t)i * 0x0123456789abcdefu;
        signs[i] = (i - 70) * 12345678;
        bytes[i] = (uint8_t)(i * 7);
    }
    vbss_stream stream;
    vbss_stream_begin_write(&stream, buffer, sizeof buffer);
    vbss_stream_u64(&stream, 1, words, COUNT);
    vbss_stream_i32(&stream, 2, signs, COUNT);
    vbss_stream_u8(&stream, 3, bytes, COUNT);
    expect_ok(stream.result);
    vbss_stream_begin_read(&stream, buffer, stream.position);
    vbss_stream_u64(&stream, 1, words_back, COUNT);
    vbss_stream_i32(&stream, 2, signs_back, COUNT);
    vbss_stream_u8(&stream, 3, bytes_back, COUNT);
    expect_ok(stream.result);
    assert_memory_equal(words, words_back, sizeof words);
    assert_memory_equal(signs, signs_back, sizeof signs);
    assert_memory_equal(bytes, bytes_back, sizeof bytes);
    /* A buffer that is too small takes no part of the array. */
    double numbers[130] = {0};
    memset(buffer, 7, sizeof buffer);
    vbss_stream_begin_write(&stream, buffer, 8 + 512 + 16);
    vbss_stream_f64(&stream, 1, numbers, 130);
    expect_result(VBSS_ERROR_CAPACITY, stream.result);
    assert_int_equal(stream.position, 8);
    assert_int_equal(buffer[8], 7);
}

/* Bytes that are found and placed where they lie are a field like another. */
static void byte_arrays_are_read_in_place(void **state)
{
    (void)state;
    const uint8_t bytes[5] = {3, 1, 4, 1, 5};
    uint8_t copied[64], placed[64], read[5];
    vbss_stream stream;
    vbss_stream_begin_write(&stream, copied, sizeof copied);
    memcpy(read, bytes, 5);
    vbss_stream_u8(&stream, 7, read, 5);
    size_t written = stream.position;
    vbss_stream_begin_write(&stream, placed, written);
    uint8_t *place = vbss_stream_reserve_u8(&stream, 7, 5);
    expect_ok(stream.result);
    memcpy(place, bytes, 5);
    assert_int_equal(stream.position, written);
    assert_memory_equal(placed, copied, written);
    vbss_stream_begin_measure(&stream);
    assert_null(vbss_stream_reserve_u8(&stream, 7, 5));
    assert_int_equal(stream.position, written);
    vbss_stream_begin_write(&stream, placed, written - 1);
    assert_null(vbss_stream_reserve_u8(&stream, 7, 5));
    expect_result(VBSS_ERROR_CAPACITY, stream.result);
    vbss_stream_begin_read(&stream, copied, written);
    assert_ptr_equal(vbss_stream_view_u8(&stream, 7, 5), copied + written - 5);
    expect_ok(stream.result);
    vbss_stream_begin_read(&stream, copied, written - 1);
    assert_null(vbss_stream_view_u8(&stream, 7, 5));
    expect_result(VBSS_ERROR_TRUNCATED, stream.result);
}

static void format_tags_are_reserved(void **state)
{
    (void)state;
    const uint16_t reserved[] = {0xfffe, 0xffff};
    for (int i = 0; i < 2; i++) {
        double value = 1.0;
        vbss_stream stream;
        vbss_stream_begin_measure(&stream);
        vbss_stream_f64(&stream, reserved[i], &value, 1);
        expect_result(VBSS_ERROR_CAPACITY, stream.result);
    }
}

static void trusted_read_ignores_visitor_checks(void **state)
{
    (void)state;
    uint8_t bytes[64];
    double value = harness_bad_numbers[1], back = 0.0;
    uint32_t count = 5;
    vbss_stream stream;
    vbss_stream_begin_write(&stream, bytes, sizeof bytes);
    stream.trusted = true;
    vbss_stream_f64(&stream, 1, &value, 1);
    vbss_stream_count(&stream, 2, &count, 5);
    vbss_stream_refuse(&stream, VBSS_ERROR_CORRUPT, "the visitor does not like it");
    expect_ok(stream.result);
    size_t written = stream.position;
    count = 0;
    vbss_stream_begin_read(&stream, bytes, written - 1);
    stream.trusted = true;
    vbss_stream_f64(&stream, 1, &back, 1);
    expect_same_bits(value, back);
    vbss_stream_refuse(&stream, VBSS_ERROR_CORRUPT, "the visitor does not like it");
    vbss_stream_count(&stream, 2, &count, 5);
    expect_result(VBSS_ERROR_TRUNCATED, stream.result); /* the format still counts */
}

static void nan_is_canonical(void **state)
{
    (void)state;
    const uint64_t patterns[] = {0x7ff8000000000000u, 0xfff8000000000000u, 0x7ff0000000000001u,
                                 0xffffffffffffffffu};
    uint64_t hashes[4];
    for (int i = 0; i < 4; i++) {
        double value;
        memcpy(&value, &patterns[i], sizeof value);
        vbss_stream stream;
        vbss_stream_begin_hash(&stream);
        vbss_stream_f64(&stream, 1, &value, 1);
        hashes[i] = vbss_hash_end(&stream.hash);
        assert_true(hashes[i] == hashes[0]);
    }
    double zeros[2] = {0.0, -0.0};
    vbss_stream plus, minus;
    vbss_stream_begin_hash(&plus);
    vbss_stream_f64(&plus, 1, &zeros[0], 1);
    vbss_stream_begin_hash(&minus);
    vbss_stream_f64(&minus, 1, &zeros[1], 1);
    assert_true(vbss_hash_end(&plus.hash) != vbss_hash_end(&minus.hash));
}

static void nan_is_canonical_anywhere_in_an_array(void **state)
{
    (void)state;
    enum { COUNT = 150 };
    const uint64_t odd = 0xfff8000000000001u, canonical = 0x7ff8000000000000u;
    const int places[] = {0, 1, 63, 64, 70, 149};
    for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
        double values[2][COUNT];
        uint8_t bytes[2][8 + 8 * COUNT];
        vbss_stream hashes[2], written[2];
        for (int i = 0; i < COUNT; i++) {
            values[0][i] = values[1][i] = 0.1 * i;
        }
        memcpy(&values[0][places[k]], &odd, sizeof odd);
        memcpy(&values[1][places[k]], &canonical, sizeof canonical);
        for (int i = 0; i < 2; i++) {
            vbss_stream_begin_hash(&hashes[i]);
            vbss_stream_f64(&hashes[i], 1, values[i], COUNT);
            vbss_stream_begin_write(&written[i], bytes[i], sizeof bytes[i]);
            vbss_stream_f64(&written[i], 1, values[i], COUNT);
            expect_ok(written[i].result);
        }
        assert_true(vbss_hash_end(&hashes[0].hash) == vbss_hash_end(&hashes[1].hash));
        assert_memory_equal(bytes[0], bytes[1], sizeof bytes[0]);
    }
}

static void non_finite_numbers_are_rejected_on_read(void **state)
{
    (void)state;
    for (int i = 0; i < 3; i++) {
        uint8_t bytes[64];
        double values[2] = {1.0, harness_bad_numbers[i]}, back[2] = {5.0, 6.0};
        vbss_stream stream;
        vbss_stream_begin_write(&stream, bytes, sizeof bytes);
        vbss_stream_f64(&stream, 1, values, 2);
        size_t count = stream.position;
        vbss_stream_begin_read(&stream, bytes, count);
        vbss_stream_f64(&stream, 1, back, 2);
        expect_result(VBSS_ERROR_CORRUPT, stream.result);
        expect_same_bits(6.0, back[1]);
    }
}

static void first_error_is_sticky(void **state)
{
    (void)state;
    uint8_t bytes[20];
    sample s = make_sample();
    double value = 1.0;
    vbss_stream stream;
    vbss_stream_begin_write(&stream, bytes, sizeof bytes);
    vbss_stream_f64(&stream, 1, &value, 1);
    expect_ok(stream.result);
    visit(&stream, &s, 2);
    expect_result(VBSS_ERROR_CAPACITY, stream.result);
    assert_int_equal(stream.position, 16);
    vbss_stream_refuse(&stream, VBSS_ERROR_CORRUPT, "later");
    vbss_stream_u32(&stream, 9, &s.count, 1);
    expect_result(VBSS_ERROR_CAPACITY, stream.result);
    assert_string_equal(stream.problem, "the buffer is too small");
}

static void field_order_is_checked(void **state)
{
    (void)state;
    uint8_t bytes[64];
    double values[2] = {1, 2};
    vbss_stream stream;
    vbss_stream_begin_write(&stream, bytes, sizeof bytes);
    vbss_stream_f64(&stream, 1, values, 2);
    size_t count = stream.position;
    uint64_t words[2] = {3, 4};
    double other[2] = {5, 6};

    vbss_stream_begin_read(&stream, bytes, count);
    vbss_stream_u64(&stream, 1, words, 2); /* another type */
    expect_result(VBSS_ERROR_CORRUPT, stream.result);
    vbss_stream_begin_read(&stream, bytes, count);
    vbss_stream_f64(&stream, 2, other, 2); /* another tag */
    expect_result(VBSS_ERROR_CORRUPT, stream.result);
    vbss_stream_begin_read(&stream, bytes, count);
    vbss_stream_f64(&stream, 1, other, 1); /* another count */
    expect_result(VBSS_ERROR_CORRUPT, stream.result);
    vbss_stream_begin_read(&stream, bytes, count);
    vbss_stream_open(&stream, SAMPLE_CODE, 1); /* a section */
    expect_result(VBSS_ERROR_CORRUPT, stream.result);
    vbss_stream_begin_read(&stream, bytes, count - 1);
    vbss_stream_f64(&stream, 1, other, 2);
    expect_result(VBSS_ERROR_TRUNCATED, stream.result);
    assert_int_equal(words[0], 3);
    expect_same_bits(5.0, other[0]);
}

static void counts_and_constants_are_checked(void **state)
{
    (void)state;
    uint8_t bytes[64];
    uint32_t n = 11;
    vbss_stream stream;
    vbss_stream_begin_write(&stream, bytes, sizeof bytes);
    vbss_stream_count(&stream, 1, &n, 20);
    vbss_stream_expect(&stream, 2, 77);
    vbss_stream_expect_f64(&stream, 3, 0.0);
    size_t count = stream.position;
    vbss_stream_begin_measure(&stream);
    vbss_stream_count(&stream, 1, &n, 10); /* refused when written, too */
    expect_result(VBSS_ERROR_CAPACITY, stream.result);

    uint32_t m = 5;
    vbss_stream_begin_read(&stream, bytes, count);
    vbss_stream_count(&stream, 1, &m, 10);
    expect_result(VBSS_ERROR_CAPACITY, stream.result);
    assert_int_equal(m, 5);
    vbss_stream_begin_read(&stream, bytes, count);
    vbss_stream_count(&stream, 1, &m, 11);
    vbss_stream_expect(&stream, 2, 78);
    assert_int_equal(m, 11);
    expect_result(VBSS_ERROR_CORRUPT, stream.result);
    vbss_stream_begin_read(&stream, bytes, count);
    vbss_stream_count(&stream, 1, &m, 11);
    vbss_stream_expect(&stream, 2, 77);
    expect_ok(stream.result);
    vbss_stream_expect_f64(&stream, 3, -0.0); /* to the bit */
    expect_result(VBSS_ERROR_CORRUPT, stream.result);
}

/* Arbitrary bytes never crash a reader, and never leave a count above its capacity. */
static void read_anything(harness_source *source, void *user)
{
    (void)user;
    uint8_t bytes[2048];
    sample s = make_sample();
    size_t count = write(&s, 2, bytes, sizeof bytes);
    for (uint32_t hits = 1 + harness_draw_below(source, 4); hits > 0; hits--) {
        /* Half of the damage in the headers, which lie at the ends. */
        size_t at = harness_draw_below(source, 2) != 0
                        ? harness_draw_below(source, 24)
                        : harness_draw_below(source, (uint32_t)count);
        bytes[harness_draw_below(source, 2) != 0 ? at : count - 1 - at] =
            (uint8_t)harness_draw_u64(source);
    }
    if (harness_draw_below(source, 3) == 0) {
        count = harness_draw_below(source, (uint32_t)count);
    }
    vbss_stream stream;
    vbss_stream_begin_read(&stream, bytes, count);
    visit(&stream, &s, 2);
    assert_true(stream.position <= count);
    assert_true(s.count <= 10);
    for (int i = 0; i < 130; i++) {
        assert_true(isfinite(s.numbers[i]));
    }
}

static void damaged_bytes_are_rejected_safely(void **state)
{
    (void)state;
    harness_property("read anything", 20000, read_anything, NULL);
}

int test_stream(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(round_trip_is_bit_exact),
        harness_test(measure_and_hash_see_written_bytes),
        harness_test(bytes_are_little_endian_and_tagged),
        harness_test(old_version_is_read_and_newer_rejected),
        harness_test(section_bounds_its_content),
        harness_test(outer_section_resumes_after_inner),
        harness_test(long_arrays_stream_in_chunks),
        cmocka_unit_test(byte_arrays_are_read_in_place),
        harness_test(format_tags_are_reserved),
        harness_test(trusted_read_ignores_visitor_checks),
        harness_test(nan_is_canonical),
        harness_test(nan_is_canonical_anywhere_in_an_array),
        harness_test(non_finite_numbers_are_rejected_on_read),
        harness_test(first_error_is_sticky),
        harness_test(field_order_is_checked),
        harness_test(counts_and_constants_are_checked),
        harness_test(damaged_bytes_are_rejected_safely),
    };
    return cmocka_run_group_tests_name("base.stream", tests, NULL, NULL);
}
