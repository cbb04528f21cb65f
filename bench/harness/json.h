/* A small JSON writer: right commas, right escapes, numbers that do not depend on the locale. */
#ifndef VBSS_BENCH_HARNESS_JSON_H
#define VBSS_BENCH_HARNESS_JSON_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

typedef struct bench_json {
    FILE *file;
    int depth;
    bool empty; /* nothing written yet in the innermost object or array */
} bench_json;

bench_json bench_json_to(FILE *file);
/* key is NULL inside an array and at the top. */
void bench_json_open(bench_json *json, const char *key, char bracket); /* '{' or '[' */
void bench_json_close(bench_json *json, char bracket);                 /* '}' or ']' */
void bench_json_string(bench_json *json, const char *key, const char *text);
void bench_json_number(bench_json *json, const char *key, double value); /* not finite: null */
void bench_json_integer(bench_json *json, const char *key, uint64_t value);
void bench_json_boolean(bench_json *json, const char *key, bool value);

enum { BENCH_NUMBER_SIZE = 32 };
/* The shortest of 15, 16, 17 digits that reads back as the same double; "null" if not finite. */
void bench_json_format(char text[BENCH_NUMBER_SIZE], double value);
/* Makes whatever the locale uses as decimal point a '.'. */
void bench_json_plain_point(char *text);

#endif
