/* What the bench harness writes is JSON, of the promised shape. */
#include "harness/harness.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "harness/json.h"
#include "harness/report.h"

/* ---- a strict reader that only says yes or no */

static bool read_value(const char **s);

static void skip_blanks(const char **s)
{
    *s += strspn(*s, " \n\t\r");
}

static bool read_exactly(const char **s, const char *text)
{
    size_t length = strlen(text);
    bool same = strncmp(*s, text, length) == 0;
    *s += same ? length : 0;
    return same;
}

static bool read_string(const char **s)
{
    if (*(*s)++ != '"') {
        return false;
    }
    for (; **s != '"'; (*s)++) {
        if ((unsigned char)**s < 0x20) {
            return false;
        }
        if (**s != '\\') {
            continue;
        }
        (*s)++;
        if (**s == 'u') {
            if (strspn(*s + 1, "0123456789abcdefABCDEF") < 4) {
                return false;
            }
            *s += 4;
        } else if (**s == '\0' || strchr("\"\\/bfnrt", **s) == NULL) {
            return false;
        }
    }
    (*s)++;
    return true;
}

static bool read_digits(const char **s)
{
    size_t digits = strspn(*s, "0123456789");
    *s += digits;
    return digits > 0;
}

static bool read_number(const char **s)
{
    read_exactly(s, "-");
    const char *first = *s;
    if (!read_digits(s) || (first[0] == '0' && *s - first > 1)) {
        return false;
    }
    if (read_exactly(s, ".") && !read_digits(s)) {
        return false;
    }
    if (**s == 'e' || **s == 'E') {
        *s += (*s)[1] == '+' || (*s)[1] == '-' ? 2 : 1;
        return read_digits(s);
    }
    return true;
}

static bool read_members(const char **s, bool named, char close)
{
    (*s)++;
    skip_blanks(s);
    if (**s == close) {
        (*s)++;
        return true;
    }
    for (;;) {
        skip_blanks(s);
        if (named && !(read_string(s) && read_exactly(s, ":"))) {
            return false;
        }
        if (!read_value(s)) {
            return false;
        }
        if (**s == close) {
            (*s)++;
            return true;
        }
        if (*(*s)++ != ',') {
            return false;
        }
    }
}

static bool read_value(const char **s)
{
    skip_blanks(s);
    bool good = **s == '{'   ? read_members(s, true, '}')
                : **s == '[' ? read_members(s, false, ']')
                : **s == '"' ? read_string(s)
                             : read_exactly(s, "true") || read_exactly(s, "false") ||
                                   read_exactly(s, "null") || read_number(s);
    skip_blanks(s);
    return good;
}

static bool is_json(const char *text)
{
    return read_value(&text) && *text == '\0';
}

/* What was written to the temporary file, which is closed. */
static char *take_text(FILE *file)
{
    static char text[1 << 16];
    rewind(file);
    size_t length = fread(text, 1, sizeof text - 1, file);
    assert_true(length < sizeof text - 1);
    text[length] = '\0';
    fclose(file);
    return text;
}

/* ---- the writer */

static void parser_reads_json(void **state)
{
    (void)state;
    assert_true(is_json("{\"a\": [1, -2.5e+3, 0.1], \"b\": {}, \"c\": [null, true]}"));
    assert_true(is_json("\"\\u001f\\n\""));
    assert_false(is_json("{\"a\": nan}"));
    assert_false(is_json("[1,]"));
    assert_false(is_json("[1 2]"));
    assert_false(is_json("{\"a\" 1}"));
    assert_false(is_json("\"a\nb\""));
    assert_false(is_json("[1,5e]"));
    assert_false(is_json("01"));
    assert_false(is_json("[1]]"));
}

static void nesting_and_commas(void **state)
{
    (void)state;
    FILE *file = tmpfile();
    assert_non_null(file);
    bench_json json = bench_json_to(file);
    bench_json_open(&json, NULL, '{');
    bench_json_open(&json, "empty", '[');
    bench_json_close(&json, ']');
    bench_json_open(&json, "list", '[');
    bench_json_number(&json, NULL, 1.5);
    bench_json_open(&json, NULL, '{');
    bench_json_close(&json, '}');
    bench_json_integer(&json, NULL, UINT64_MAX);
    bench_json_close(&json, ']');
    bench_json_boolean(&json, "last", true);
    bench_json_close(&json, '}');
    assert_string_equal(take_text(file), "{\n  \"empty\": [],\n  \"list\": [\n    1.5,\n    {},\n"
                                         "    18446744073709551615\n  ],\n  \"last\": true\n}\n");
}

static void strings_are_escaped(void **state)
{
    (void)state;
    static const char *const texts[][2] = {
        {"plain", "\"plain\"\n"},
        {"\"quoted\" back\\slash", "\"\\\"quoted\\\" back\\\\slash\"\n"},
        {"line\nbreak\ttab\x01\x7f", "\"line\\nbreak\\ttab\\u0001\\u007f\"\n"},
        {"\xc2\xb5s \xe2\x80\xa6 \xf0\x9f\xa7\xb5",
         "\"\xc2\xb5s \xe2\x80\xa6 \xf0\x9f\xa7\xb5\"\n"},
        {"cut \xe2\x80", "\"cut \\ufffd\\ufffd\"\n"},
        {"long \xc0\xaf, surrogate \xed\xa0\x80",
         "\"long \\ufffd\\ufffd, surrogate \\ufffd\\ufffd\\ufffd\"\n"},
    };
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        FILE *file = tmpfile();
        assert_non_null(file);
        bench_json json = bench_json_to(file);
        bench_json_string(&json, NULL, texts[i][0]);
        fputc('\n', file);
        const char *written = take_text(file);
        assert_string_equal(written, texts[i][1]);
        assert_true(is_json(written));
    }
}

static void numbers_round_trip(void **state)
{
    (void)state;
    static const double values[] = {0.0,        -0.0,      1.0,
                                    0.1,        1.0 / 3.0, -2.5e-308,
                                    5e-324,     1e22,      1.7976931348623157e308,
                                    123456.789, 0.3,       9007199254740993.0};
    char text[BENCH_NUMBER_SIZE];
    for (size_t i = 0; i < sizeof values / sizeof values[0]; i++) {
        bench_json_format(text, values[i]);
        assert_true(is_json(text));
        expect_same_bits(values[i], strtod(text, NULL));
    }
    bench_json_format(text, 0.1);
    assert_string_equal(text, "0.1");
    bench_json_format(text, (double)NAN);
    assert_string_equal(text, "null");
    bench_json_format(text, -(double)INFINITY);
    assert_string_equal(text, "null");
}

static void output_ignores_locale(void **state)
{
    (void)state;
    char comma[] = "-1,5e-07",
         wide[] = "3\xd9\xab"
                  "25",
         whole[] = "12";
    bench_json_plain_point(comma);
    assert_string_equal(comma, "-1.5e-07");
    bench_json_plain_point(wide); /* the Arabic decimal separator has two bytes */
    assert_string_equal(wide, "3.25");
    bench_json_plain_point(whole);
    assert_string_equal(whole, "12");
}

static void paths_are_omitted(void **state)
{
    (void)state;
    char text[64];
    bench_copy_without_paths(text, sizeof text,
                             "  -O3 -I/home/me/include -ffp-contract=off\t-fmap=/a=b ../x -g");
    assert_string_equal(text, "-O3 -ffp-contract=off -g");
    bench_copy_without_paths(text, 8, "-O3 -DNDEBUG -g");
    assert_string_equal(text, "-O3 -g");
}

/* ---- a whole file */

static uint64_t ticks;

static uint64_t tick(void *user)
{
    (void)user;
    return ++ticks;
}

static int step_nothing(void *user, uint32_t index)
{
    (void)index;
    return user != NULL ? -3 : 0;
}

static void finish_badly(void *user, bench_result *result)
{
    (void)user;
    bench_counter(result, "good_error_mm", 0.125);
    bench_counter(result, "stretch_max", (double)INFINITY);
}

static void run_a_millisecond(void *user)
{
    (void)user;
    ticks += 1000000;
}

static void add_cases(bench *b)
{
    static int fails;
    bench_add_batch(b,
                    &(bench_batch){.name = "fake/fine/ours", .items = 1, .run = run_a_millisecond});
    bench_add_stepped(b, &(bench_stepped){.name = "fake/infinite/ours/8",
                                          .steps = 3,
                                          .step = step_nothing,
                                          .finish = finish_badly});
    bench_add_stepped(
        b, &(bench_stepped){
               .name = "fake/failing/ours/8", .user = &fails, .steps = 3, .step = step_nothing});
    bench_add_skipped(b, "fake/fine/peer", "a \"peer\" is missing");
}

/* The object of that name inside `text`, cut off behind its end. */
static char *cut_case(char *text, const char *name)
{
    char key[64];
    snprintf(key, sizeof key, "\"name\": \"%s\"", name);
    char *from = strstr(text, key);
    assert_non_null(from);
    char *end = strchr(from, '}');
    assert_non_null(end);
    *end = '\0';
    return from;
}

static char *write_file(void)
{
    static const bench_suite suite = {"fake", "libvblast_ss 0 /usr/lib/x", add_cases};
    bench_options options = bench_default_options();
    options.quick = true;
    options.git = "abc1234";
    const bench_clock clock = {tick, tick, NULL};
    bench b;
    bench_environment environment;
    bench_read_environment(&environment);
    assert_true(bench_begin(&b, &suite, &options, &clock));
    bench_run_cases(&b, NULL);
    /* The counter that is not finite, and the step that fails. */
    assert_int_equal(bench_failures(&b), 2);
    FILE *file = tmpfile();
    assert_non_null(file);
    bench_write_json(&b, &environment, file);
    bench_end(&b);
    return take_text(file);
}

static void file_matches_schema(void **state)
{
    (void)state;
    char *text = write_file();
    assert_true(is_json(text));
    assert_non_null(strstr(text, "\"context\": {"));
    assert_non_null(strstr(text, "\"benchmarks\": ["));
    assert_non_null(strstr(text, "\"quick\": true"));
    assert_non_null(strstr(text, "\"git\": \"abc1234\""));
    assert_non_null(strstr(text, "\"library\": \"libvblast_ss 0\""));
    assert_non_null(strstr(text, "\"reason\": \"a \\\"peer\\\" is missing\""));
    assert_null(strstr(text, "/usr"));
    char *fine = cut_case(strstr(text, "\"benchmarks\""), "fake/fine/ours");
    assert_non_null(strstr(fine, "\"run_name\": \"fake/fine/ours\""));
    assert_non_null(strstr(fine, "\"run_type\": \"iteration\""));
    assert_non_null(strstr(fine, "\"repetitions\": 7"));
    assert_non_null(strstr(fine, "\"iterations\": "));
    assert_non_null(strstr(fine, "\"real_time\": "));
    assert_non_null(strstr(fine, "\"cpu_time\": "));
    assert_non_null(strstr(fine, "\"time_unit\": \"ns\""));
    assert_null(strstr(fine, "error_occurred"));
}

static void non_finite_is_null_and_an_error(void **state)
{
    (void)state;
    char *infinite = cut_case(write_file(), "fake/infinite/ours/8");
    assert_non_null(strstr(infinite, "\"stretch_max\": null"));
    assert_non_null(strstr(infinite, "\"good_error_mm\": 0.125"));
    assert_non_null(strstr(infinite, "\"error_occurred\": true"));
    assert_non_null(strstr(infinite, "counter stretch_max is not finite"));
    assert_non_null(strstr(infinite, "\"real_time\": "));
    /* No time at all, rather than zero, when there was none. */
    char *failing = cut_case(write_file(), "fake/failing/ours/8");
    assert_non_null(strstr(failing, "step 0 returned -3"));
    assert_null(strstr(failing, "_time\""));
}

int test_bench_json(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parser_reads_json),     cmocka_unit_test(nesting_and_commas),
        cmocka_unit_test(strings_are_escaped),   cmocka_unit_test(numbers_round_trip),
        cmocka_unit_test(output_ignores_locale), cmocka_unit_test(paths_are_omitted),
        cmocka_unit_test(file_matches_schema),   cmocka_unit_test(non_finite_is_null_and_an_error),
    };
    return cmocka_run_group_tests_name("bench.json", tests, NULL, NULL);
}
