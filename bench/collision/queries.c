/* Batches: every method answers all questions of a set, over and over; times are per question. Beside
 * the time stand
 *   fp, fn: wrong hits and wrong misses, of `queries` questions with `positives` true hits;
 *   undecided: hits that the method knows to be guesses;
 *   fp_clearance: how far a wrong hit stayed from contact at most, in D;
 *   passes, exact: directions tried per question, share that needed exact arithmetic (conservative);
 *   sign_ended: share that the sign test ended (paper).
 * A proved method has no fn: one is an error. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/simd_dispatch.h"
#include "collision/bench_collision.h"
#include "collision/query_method.h"
#include "collision/query_sets.h"

enum { METHODS = 16, MAX_SETS = 40 };

static const struct {
    const char *name;
    const query_method *method; /* NULL: not here */
    bool edges, points, thin;   /* for those that are not here */
    bool never_misses;
} methods[METHODS] = {
    {.method = &query_conservative, .never_misses = true},
    {.method = &query_conservative_fine, .never_misses = true},
    {.method = &query_conservative_call, .never_misses = true},
    {.method = &query_conservative_batch, .never_misses = true},
    {.method = &query_conservative_batch_plain, .never_misses = true},
    {.method = &query_batch_call, .never_misses = true},
    {.method = &query_paper},
    {.method = &query_paper_call},
    {.method = &query_paper_metres},
    {.method = &query_cubic},
    {.method = &query_accd_coarse},
    {.method = &query_accd_fine},
#if defined(VBSS_HAVE_FCL)
    {.method = &query_fcl_end},
    {.method = &query_fcl_intersect},
#else
    {.name = "fcl-end", .edges = true},
    {.name = "fcl-intersect", .thin = true},
#endif
#if defined(VBSS_HAVE_LIBCCD)
    {.method = &query_libccd_end},
    {.method = &query_libccd_swept},
#else
    {.name = "libccd-end", .edges = true, .points = true},
    {.name = "libccd-swept", .edges = true, .points = true, .thin = true},
#endif
};

typedef struct query_case {
    char name[128];
    query_set *set;
    size_t method;
    query_answers answers;
} query_case;

static query_case cases[MAX_SETS][METHODS];
static bool measured[METHODS];

static void end_case(void *user)
{
    query_case *c = user;
    const query_method *method = methods[c->method].method;
    if (method->end != NULL) {
        method->end();
    }
    free(c->answers.hit);
    c->answers.hit = NULL;
}

static int begin_case(void *user)
{
    query_case *c = user;
    const query_method *method = methods[c->method].method;
    if (!query_set_make(c->set)) {
        return 1;
    }
    c->answers.hit = calloc(c->set->rows.count, sizeof *c->answers.hit);
    if (c->answers.hit == NULL || (method->begin != NULL && !method->begin(&c->set->rows))) {
        free(c->answers.hit);
        c->answers.hit = NULL;
        return 1;
    }
    return 0;
}

static uint32_t count_case(void *user)
{
    return ((query_case *)user)->set->rows.count;
}

static void run_case(void *user)
{
    query_case *c = user;
    methods[c->method].method->run(&c->set->rows, &c->answers);
    bench_keep_memory(c->answers.hit);
}

static void judge_case(void *user, bench_result *result)
{
    const query_case *c = user;
    const query_set *set = c->set;
    const query_method *method = methods[c->method].method;
    uint32_t fp = 0, fn = 0;
    double farthest = 0.0;
    for (uint32_t i = 0; i < set->rows.count; i++) {
        bool hit = c->answers.hit[i] != 0;
        fn += set->truth[i] && !hit;
        if (hit && !set->truth[i]) {
            fp++;
            farthest = fmax(farthest, set->clearance[i]); /* NAN where nobody worked it out */
        }
    }
    bench_counter(result, "fp", fp);
    bench_counter(result, "fn", fn);
    bench_counter(result, "undecided", c->answers.undecided);
    bench_counter(result, "positives", set->positives);
    bench_counter(result, "queries", set->rows.count);
    if (set->sort != THIN) {
        bench_counter(result, "fp_clearance", farthest / set->rows.millimetres[0].thickness);
    }
    if (method->finish != NULL) {
        method->finish(&set->rows, &c->answers, result);
    }
    if (fn > 0 && methods[c->method].never_misses) {
        bench_fail(result, "%u missed, and it never misses", fn);
    }
    measured[c->method] = true;
}

static void add_case(bench *b, query_case *c)
{
    const query_method *method = methods[c->method].method;
    const char *missing = query_set_missing(c->set);
    query_set_sort sort = c->set->sort;
    bool fits;
    if (method != NULL) {
        fits = sort == THIN ? method->thin : sort == POINTS ? method->points : method->edges;
    } else {
        fits = sort == THIN     ? methods[c->method].thin
               : sort == POINTS ? methods[c->method].points
                                : methods[c->method].edges;
    }
    if (!fits) {
        return;
    }
    snprintf(c->name, sizeof c->name, "collision/%s/%s", c->set->name,
             method != NULL ? method->name : methods[c->method].name);
    if (missing == NULL && method == NULL) {
        missing = "not installed";
    } else if (missing == NULL && method == &query_conservative_batch &&
               !vbss_wide_is_available()) {
        missing = "no AVX2: there is the plain one only";
    }
    if (missing != NULL) {
        bench_add_skipped(b, c->name, missing);
        return;
    }
    bench_add_batch(b, &(bench_batch){.name = c->name,
                                      .user = c,
                                      .setup = begin_case,
                                      .count = count_case,
                                      .run = run_case,
                                      .finish = judge_case,
                                      .teardown = end_case});
}

void add_query_cases(bench *b)
{
    query_set *set;
    for (size_t s = 0; s < MAX_SETS && (set = query_set_at(s)) != NULL; s++) {
        set->quick = bench_is_quick(b);
        for (size_t m = 0; m < METHODS; m++) {
            cases[s][m].set = set;
            cases[s][m].method = m;
            add_case(b, &cases[s][m]);
        }
    }
}

void end_query_cases(void)
{
    query_sets_release();
}

void print_query_notes(void)
{
    for (size_t m = 0; m < METHODS; m++) {
        if (measured[m]) {
            printf("%s: %s\n", methods[m].method->name, methods[m].method->note);
        }
    }
}
