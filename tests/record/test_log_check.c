/* What a right checksum does not make right, and logs of other versions. */
#include "base/little_endian.h"
#include "damage.h"

/* ---- nonsense */

static void invalid_step_content_is_rejected(void **state)
{
    (void)state;
    damage d;
    damage_begin(&d, 5);
    log_to_format_2(&d.good);
    const size_t step = log_find(&d.good, STEP, 3).at, inside = step + 16;
    const size_t flag = inside + 8 + 8, h = inside + 32 + 8, count = inside + 32 + 16 + 8;
    const struct {
        size_t at;
        uint8_t value;
    } nonsense[] = {
        {inside, 7},          /* another tag */
        {inside + 2, 1},      /* another type */
        {inside + 4, 200},    /* more values than the record has */
        {inside + 8, 9},      /* another step */
        {flag, 2},            /* neither hashed nor not */
        {h + 7, 0x7f},        /* no number, with the next */
        {count, 65},          /* more inputs than ever */
        {count + 4 + 8, 0},   /* no such input */
        {count + 4 + 8, 200}, /* likewise */
    };
    for (size_t i = 0; i < sizeof nonsense / sizeof nonsense[0]; i++) {
        log_bytes log = log_copy(&d.good);
        log.bytes[nonsense[i].at] = nonsense[i].value;
        log.bytes[h + 6] = nonsense[i].at == h + 7 ? 0xf0 : log.bytes[h + 6];
        log_seal(&log);
        damage_expect(&d, &log, VBSS_ERROR_CORRUPT, 2);
        log_free(&log);
    }
    damage_end(&d);
}

/* A last record that says of itself to be `length` bytes long, of which `zeros` follow. */
static void expect_tail(damage *d, uint64_t length, size_t zeros)
{
    log_bytes log = log_copy(&d->good);
    log_place last = log_find(&log, ENDS, 1);
    log.bytes = realloc(log.bytes, log.count + zeros + 8);
    assert_non_null(log.bytes);
    memset(log.bytes + log.count - 8, 0, zeros + 8);
    log.count = last.at + 8 + (size_t)length + 8;
    store_little_endian(log.bytes + last.at, length, 4);
    store_little_endian(log.bytes + last.at + 4, ~length, 4);
    log_seal(&log);
    damage_expect(d, &log, VBSS_ERROR_CORRUPT, d->steps);
    log_free(&log);
}

static void wrong_section_lengths_are_rejected(void **state)
{
    (void)state;
    damage d;
    damage_begin(&d, 5);
    log_place last = log_find(&d.good, ENDS, 1);
    size_t length = last.next - last.at - 16;
    for (size_t shorter = 1; shorter <= length; shorter++) {
        expect_tail(&d, length - shorter, 0);
    }
    for (size_t longer = 1; longer < 20; longer++) {
        expect_tail(&d, length + longer, longer);
    }
    damage_end(&d);
}

/* No memory is asked for that the log itself does not have. */
static void absurd_sizes_are_rejected(void **state)
{
    (void)state;
    damage d;
    vbss_context_statistics before, after;
    damage_begin(&d, 2);
    expect_ok(vbss_context_get_statistics(d.s.context, &before, sizeof before));
    /* the count of the build text, behind the section and the version */
    store_little_endian(d.good.bytes + log_find(&d.good, HEAD, 1).at + 8 + 8 + 12 + 8, 0x3fffffff,
                        4);
    log_seal(&d.good);
    damage_expect(&d, &d.good, VBSS_ERROR_CORRUPT, 0);
    expect_ok(vbss_context_get_statistics(d.s.context, &after, sizeof after));
    assert_true(after.bytes_peak < before.bytes_peak + d.good.count);
    damage_end(&d);
}

/* ---- other versions */

static void newer_version_is_rejected(void **state)
{
    (void)state;
    damage d;
    damage_begin(&d, 5);
    const size_t versions[] = {4, log_find(&d.good, HEAD, 1).at + 10,
                               log_find(&d.good, SNAP, 1).at + 10,
                               log_find(&d.good, ENDS, 1).at + 10};
    const uint64_t steps[] = {0, 0, 0, 5};
    for (int i = 0; i < 4; i++) {
        log_bytes log = log_copy(&d.good);
        log.bytes[versions[i]]++;
        log_seal(&log);
        damage_expect(&d, &log, VBSS_ERROR_DATA_VERSION, steps[i]);
        log_free(&log);
    }
    log_to_format_2(&d.good);
    d.good.bytes[log_find(&d.good, STEP, 4).at + 10] += 2; /* the next one knows more inputs */
    log_seal(&d.good);
    damage_expect(&d, &d.good, VBSS_ERROR_DATA_VERSION, 3);
    damage_end(&d);
}

/* Records that a reader does not know: it passes over those with a small letter, and no others. */
static void optional_unknown_records_are_skipped(void **state)
{
    (void)state;
    damage d;
    damage_begin(&d, 5);
    const log_place one = log_find(&d.good, STEP, 1), no = {.next = 0};
    const log_place order[] = {log_find(&d.good, HEAD, 1),
                               log_find(&d.good, SNAP, 1),
                               one,
                               log_find(&d.good, SNAP, 1),
                               log_find(&d.good, STEP, 2),
                               log_find(&d.good, STEP, 3),
                               log_find(&d.good, STEP, 4),
                               log_find(&d.good, STEP, 5),
                               log_find(&d.good, ENDS, 1),
                               no};
    log_bytes log = damage_shuffled(&d.good, order);
    memcpy(log.bytes + one.next + 12, "mark", 4);
    log_seal(&log);
    damage_expect(&d, &log, VBSS_OK, 5);
    memcpy(log.bytes + one.next + 12, "MARK", 4);
    log_seal(&log);
    damage_expect(&d, &log, VBSS_ERROR_DATA_VERSION, 1);
    log_free(&log);
    damage_end(&d);
}

/* ---- anything */

static void change_and_read(harness_source *source, void *user)
{
    damage *d = user;
    log_bytes log = log_copy(&d->good);
    uint64_t steps;
    size_t first = harness_draw_below(source, 4) == 0 ? 0 : log_find(&log, STEP, 1).at;
    for (uint32_t n = 1 + harness_draw_below(source, 4); n > 0; n--) {
        /* not the lengths, without which nothing can be sealed */
        log_place place = {.next = 0};
        size_t at = first + harness_draw_below(source, (uint32_t)(log.count - first));
        while (log_next_place(&log, &place) && place.next <= at) {
        }
        if (at >= place.at + (place.coded ? 4 : 8)) {
            log.bytes[at] = (uint8_t)harness_draw_below(source, 256);
        }
    }
    if (harness_draw_below(source, 8) != 0) {
        log_seal(&log);
    }
    (void)damage_read(d, &log, &steps);
    log_free(&log);
}

static void any_change_is_handled(void **state)
{
    (void)state;
    damage d;
    damage_begin(&d, 45);
    harness_property("a changed log", 300, change_and_read, &d);
    damage_expect(&d, &d.good, VBSS_OK, 45); /* the scene has come to no harm */
    damage_end(&d);
}

int test_log_check(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(invalid_step_content_is_rejected),
        cmocka_unit_test(wrong_section_lengths_are_rejected),
        cmocka_unit_test(absurd_sizes_are_rejected),
        cmocka_unit_test(newer_version_is_rejected),
        cmocka_unit_test(optional_unknown_records_are_skipped),
        harness_test(any_change_is_handled),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
