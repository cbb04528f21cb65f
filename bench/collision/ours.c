/* The library's methods. One question at a time by vbss_collision_run_ccd, which is what searches and public
 * calls come down to, for all three alike; conservative-call is the public call itself, with its checks
 * of arguments and its points of contact. Batches hand out all that a contact needs: time, distance,
 * normal and weights. */
#include <stdlib.h>
#include <string.h>

#include "fixtures/baseline_of.h"
#include "base/simd_dispatch.h"
#include "collision/collision.h"
#include "collision/query_method.h"

static collision_ccd_options rules;
static collision_counters counters;
static uint32_t limbs[COLLISION_LIMBS]; /* for exact decisions, as an object has them */

/* ---- one at a time */

static collision_ccd_query *questions;

static void end_questions(void)
{
    free(questions);
    questions = NULL;
}

static bool begin_questions(const query_rows *rows, vbss_collision_method method, double unit)
{
    vbss_collision_config config;
    questions = calloc(rows->count, sizeof *questions);
    if (questions == NULL || vbss_collision_config_init(&config, sizeof config) != VBSS_OK) {
        end_questions();
        return false;
    }
    config.method = method;
    baseline_of(&config.baseline)->collision_unit = unit;
    rules = vbss_collision_ccd_options_of(&config);
    rules.limbs = limbs;
    rules.limb_count = COLLISION_LIMBS;
    for (uint32_t i = 0; i < rows->count; i++) {
        const query *q = &rows->metres[i];
        questions[i].kind = q->kind;
        questions[i].thickness = q->thickness;
        vbss_collision_set_vertices(&questions[i], q->start, q->end);
    }
    return true;
}

static void run_questions(const query_rows *rows, query_answers *answers)
{
    memset(&counters, 0, sizeof counters);
    for (uint32_t i = 0; i < rows->count; i++) {
        collision_ccd_result answer;
        vbss_collision_run_ccd(&rules, &questions[i], &answer, &counters);
        answers->hit[i] = answer.hit;
        bench_keep_memory(&answer);
    }
    answers->undecided = (uint32_t)counters.undecided;
}

static void count_passes(const query_rows *rows, const query_answers *answers, bench_result *result)
{
    (void)answers;
    bench_counter(result, "passes", (double)counters.passes / rows->count);
    bench_counter(result, "exact", (double)counters.exact / rows->count);
}

static void count_sign_tests(const query_rows *rows, const query_answers *answers,
                             bench_result *result)
{
    (void)answers;
    bench_counter(result, "sign_ended", (double)counters.sign_tests_ended / rows->count);
}

static bool begin_conservative(const query_rows *rows)
{
    return begin_questions(rows, VBSS_COLLISION_METHOD_CONSERVATIVE, QUERY_MM);
}

static bool begin_conservative_fine(const query_rows *rows)
{
    bool good = begin_conservative(rows);
    rules.tolerance = 1e-6;
    return good;
}

static bool begin_cubic(const query_rows *rows)
{
    return begin_questions(rows, VBSS_COLLISION_METHOD_CUBIC, QUERY_MM);
}

static bool begin_paper(const query_rows *rows)
{
    return begin_questions(rows, VBSS_COLLISION_METHOD_VBLAST, QUERY_MM);
}

static bool begin_paper_metres(const query_rows *rows)
{
    return begin_questions(rows, VBSS_COLLISION_METHOD_VBLAST, 1.0);
}

/* ---- the public call */

static vbss_context *context;
static vbss_collision *object;

static void end_calls(void)
{
    vbss_context_destroy(context);
    context = NULL;
}

static bool begin_method(const query_rows *rows, vbss_collision_method method)
{
    vbss_collision_config config;
    if (vbss_context_create(NULL, &context) == VBSS_OK &&
        vbss_collision_config_init(&config, sizeof config) == VBSS_OK) {
        config.method = method;
        config.thickness = rows->thickness;
        if (vbss_collision_create(context, &config, &object) == VBSS_OK) {
            return true;
        }
    }
    end_calls();
    return false;
}

static bool begin_calls(const query_rows *rows)
{
    return begin_method(rows, VBSS_COLLISION_METHOD_CONSERVATIVE);
}

static bool begin_paper_calls(const query_rows *rows)
{
    return begin_method(rows, VBSS_COLLISION_METHOD_VBLAST);
}

static void run_calls(const query_rows *rows, query_answers *answers)
{
    answers->undecided = 0;
    for (uint32_t i = 0; i < rows->count; i++) {
        const query *q = &rows->metres[i];
        vbss_collision_impact impact;
        vbss_result reported =
            vbss_collision_test(object, q->kind, q->start, q->end, &impact, sizeof impact);
        answers->hit[i] = reported == VBSS_OK ? impact.hit : -1;
        answers->undecided +=
            reported == VBSS_OK && impact.decision == VBSS_COLLISION_DECISION_UNDECIDED;
    }
}

/* ---- in rows */

static double *numbers; /* time, distance, normal, weights: 9 rows */
static int32_t *decisions;

static void end_rows(void)
{
    free(numbers);
    free(decisions);
    numbers = NULL;
    decisions = NULL;
    end_questions();
}

static bool begin_rows(const query_rows *rows)
{
    numbers = calloc(9 * (size_t)rows->count, sizeof *numbers);
    decisions = calloc(rows->count, sizeof *decisions);
    if (numbers == NULL || decisions == NULL || !begin_conservative(rows)) {
        end_rows();
        return false;
    }
    return true;
}

static void run_rows(const query_rows *rows, query_answers *answers, bool wide)
{
    const size_t n = rows->count;
    const collision_ccd_batch asked = {.kind = rows->kind,
                                       .count = rows->count,
                                       .stride = n,
                                       .start = rows->start,
                                       .end = rows->end,
                                       .same_thickness = rows->thickness,
                                       .hit = answers->hit,
                                       .decision = decisions,
                                       .time = numbers,
                                       .distance = numbers + n,
                                       .normal = numbers + 2 * n,
                                       .weights = numbers + 5 * n};
    memset(&counters, 0, sizeof counters);
    vbss_collision_run_ccd_batch(&rules, wide, &asked, &counters);
    bench_keep_memory(numbers);
    answers->undecided = (uint32_t)counters.undecided;
}

static void run_wide_rows(const query_rows *rows, query_answers *answers)
{
    run_rows(rows, answers, vbss_wide_is_available());
}

static void run_plain_rows(const query_rows *rows, query_answers *answers)
{
    run_rows(rows, answers, false);
}

/* ---- the public batch */

static void end_batch(void)
{
    end_rows();
    end_calls();
}

static bool begin_batch(const query_rows *rows)
{
    if (!begin_rows(rows)) {
        return false;
    }
    if (!begin_calls(rows)) {
        end_rows();
        return false;
    }
    return true;
}

static void run_batch(const query_rows *rows, query_answers *answers)
{
    const size_t n = rows->count;
    vbss_collision_batch batch;
    bool reported = vbss_collision_batch_init(&batch, sizeof batch) == VBSS_OK;
    batch.kind = rows->kind;
    batch.count = batch.stride = rows->count;
    batch.start = rows->start;
    batch.end = rows->end;
    batch.hit = answers->hit;
    batch.decision = decisions;
    batch.time = numbers;
    batch.normal = numbers + 2 * n;
    batch.weights = numbers + 5 * n;
    reported = reported && vbss_collision_test_batch(object, &batch) == VBSS_OK;
    answers->undecided = 0;
    for (uint32_t i = 0; i < rows->count; i++) {
        answers->hit[i] = reported ? answers->hit[i] : -1;
        answers->undecided += decisions[i] == VBSS_COLLISION_DECISION_UNDECIDED;
    }
    bench_keep_memory(numbers);
}

static bool same_bits(double a, double b)
{
    uint64_t x, y;
    memcpy(&x, &a, sizeof x);
    memcpy(&y, &b, sizeof y);
    return x == y;
}

/* Rows promise the bits of one question at a time. */
static void compare_rows(const query_rows *rows, const query_answers *answers, bench_result *result)
{
    count_passes(rows, answers, result);
    const double *normals = numbers + 2 * (size_t)rows->count;
    uint32_t others = 0;
    for (uint32_t i = 0; i < rows->count; i++) {
        collision_ccd_result one;
        vbss_collision_run_ccd(&rules, &questions[i], &one, &counters);
        others += one.hit != answers->hit[i] || !same_bits(one.time, numbers[i]) ||
                  !same_bits(one.normal.x, normals[i]);
    }
    if (others != 0) {
        bench_fail(result, "%u answers differ from those to one question at a time", others);
    }
}

/* ---- the methods */

#define IN_ROWS "the same in rows, time, normal and weights handed out"

const query_method query_conservative = {
    .name = "conservative",
    .note = "directional conservative advancement, ours; tolerance 1e-3 D",
    .edges = true,
    .points = true,
    .thin = true,
    .begin = begin_conservative,
    .run = run_questions,
    .finish = count_passes,
    .end = end_questions};
const query_method query_conservative_fine = {.name = "conservative-1e-6",
                                              .note = "the same with a tolerance of 1e-6 D",
                                              .edges = true,
                                              .points = true,
                                              .begin = begin_conservative_fine,
                                              .run = run_questions,
                                              .finish = count_passes,
                                              .end = end_questions};
const query_method query_conservative_call = {.name = "conservative-call",
                                              .note = "the same by vbss_collision_test",
                                              .edges = true,
                                              .points = true,
                                              .thin = true,
                                              .begin = begin_calls,
                                              .run = run_calls,
                                              .end = end_calls};
const query_method query_conservative_batch = {.name = "conservative-batch",
                                               .note = IN_ROWS "; with AVX2",
                                               .edges = true,
                                               .points = true,
                                               .thin = true,
                                               .begin = begin_rows,
                                               .run = run_wide_rows,
                                               .finish = compare_rows,
                                               .end = end_rows};
const query_method query_conservative_batch_plain = {.name = "conservative-batch-plain",
                                                     .note = IN_ROWS "; for any processor",
                                                     .edges = true,
                                                     .points = true,
                                                     .thin = true,
                                                     .begin = begin_rows,
                                                     .run = run_plain_rows,
                                                     .finish = compare_rows,
                                                     .end = end_rows};
const query_method query_batch_call = {.name = "conservative-batch-call",
                                       .note = "the same by vbss_collision_test_batch",
                                       .edges = true,
                                       .points = true,
                                       .thin = true,
                                       .begin = begin_batch,
                                       .run = run_batch,
                                       .end = end_batch};
const query_method query_paper_call = {.name = "paper-call",
                                       .note = "paper by vbss_collision_test",
                                       .edges = true,
                                       .points = true,
                                       .thin = true,
                                       .begin = begin_paper_calls,
                                       .run = run_calls,
                                       .end = end_calls};
const query_method query_cubic = {.name = "cubic",
                                  .note = "roots of the coplanarity cubic, distance at the end",
                                  .edges = true,
                                  .points = true,
                                  .thin = true,
                                  .begin = begin_cubic,
                                  .run = run_questions,
                                  .end = end_questions};
const query_method query_paper = {.name = "paper",
                                  .note = "VBLaST-SS, algorithm 1; its unit is the mm",
                                  .edges = true,
                                  .points = true,
                                  .thin = true,
                                  .begin = begin_paper,
                                  .run = run_questions,
                                  .finish = count_sign_tests,
                                  .end = end_questions};
const query_method query_paper_metres = {.name = "paper-metres",
                                         .note = "the same with the unit of the data, the metre",
                                         .edges = true,
                                         .points = true,
                                         .thin = true,
                                         .begin = begin_paper_metres,
                                         .run = run_questions,
                                         .finish = count_sign_tests,
                                         .end = end_questions};
