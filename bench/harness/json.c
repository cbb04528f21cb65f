#include "harness/json.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bench_json bench_json_to(FILE *file)
{
    bench_json json = {file, 0, true};
    return json;
}

/* Length of the UTF-8 sequence at s, 0 if it is none. */
static size_t utf8_length(const unsigned char *s)
{
    size_t length = s[0] < 0x80 ? 1 : s[0] >= 0xf0 ? 4 : s[0] >= 0xe0 ? 3 : 2;
    if (length == 1) {
        return 1;
    }
    if (s[0] < 0xc2 || s[0] > 0xf4) {
        return 0;
    }
    for (size_t i = 1; i < length; i++) {
        if ((s[i] & 0xc0) != 0x80) {
            return 0;
        }
    }
    /* Longer than needed, surrogates, and beyond the last code point. */
    bool bad = (s[0] == 0xe0 && s[1] < 0xa0) || (s[0] == 0xed && s[1] > 0x9f) ||
               (s[0] == 0xf0 && s[1] < 0x90) || (s[0] == 0xf4 && s[1] > 0x8f);
    return bad ? 0 : length;
}

static void put_string(FILE *file, const char *text)
{
    const unsigned char *s = (const unsigned char *)text;
    putc('"', file);
    while (*s != '\0') {
        size_t length = utf8_length(s);
        if (length == 0) {
            fputs("\\ufffd", file);
            s++;
        } else if (*s == '"' || *s == '\\') {
            putc('\\', file);
            putc(*s++, file);
        } else if (*s == '\n') {
            fputs("\\n", file);
            s++;
        } else if (*s == '\t') {
            fputs("\\t", file);
            s++;
        } else if (*s < 0x20 || *s == 0x7f) {
            fprintf(file, "\\u%04x", (unsigned)*s++);
        } else {
            fwrite(s, 1, length, file);
            s += length;
        }
    }
    putc('"', file);
}

static void new_line(bench_json *json)
{
    putc('\n', json->file);
    for (int i = 0; i < json->depth; i++) {
        fputs("  ", json->file);
    }
}

static void begin_value(bench_json *json, const char *key)
{
    if (json->depth > 0) {
        if (!json->empty) {
            putc(',', json->file);
        }
        new_line(json);
    }
    json->empty = false;
    if (key != NULL) {
        put_string(json->file, key);
        fputs(": ", json->file);
    }
}

void bench_json_open(bench_json *json, const char *key, char bracket)
{
    begin_value(json, key);
    putc(bracket, json->file);
    json->depth++;
    json->empty = true;
}

void bench_json_close(bench_json *json, char bracket)
{
    json->depth--;
    if (!json->empty) {
        new_line(json);
    }
    putc(bracket, json->file);
    json->empty = false;
    if (json->depth == 0) {
        putc('\n', json->file);
    }
}

void bench_json_string(bench_json *json, const char *key, const char *text)
{
    begin_value(json, key);
    put_string(json->file, text);
}

void bench_json_number(bench_json *json, const char *key, double value)
{
    char text[BENCH_NUMBER_SIZE];
    bench_json_format(text, value);
    begin_value(json, key);
    fputs(text, json->file);
}

void bench_json_integer(bench_json *json, const char *key, uint64_t value)
{
    begin_value(json, key);
    fprintf(json->file, "%llu", (unsigned long long)value);
}

void bench_json_boolean(bench_json *json, const char *key, bool value)
{
    begin_value(json, key);
    fputs(value ? "true" : "false", json->file);
}

void bench_json_plain_point(char *text)
{
    /* The point may have several bytes; everything else in a number is one of these. */
    static const char number_characters[] = "0123456789+-eE";
    char *to = text;
    bool in_point = false;
    for (const char *from = text; *from != '\0'; from++) {
        bool plain = strchr(number_characters, *from) != NULL;
        if (plain) {
            *to++ = *from;
        } else if (!in_point) {
            *to++ = '.';
        }
        in_point = !plain;
    }
    *to = '\0';
}

void bench_json_format(char text[BENCH_NUMBER_SIZE], double value)
{
    if (!isfinite(value)) {
        memcpy(text, "null", sizeof "null");
        return;
    }
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(text, BENCH_NUMBER_SIZE, "%.*g", digits, value);
        double back = strtod(text, NULL);
        if (!(back < value) && !(back > value)) {
            break;
        }
    }
    bench_json_plain_point(text);
}
