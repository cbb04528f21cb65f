/* Asking the library what a set knows. */
#ifndef VBSS_TESTS_COLLISION_QUERY_H
#define VBSS_TESTS_COLLISION_QUERY_H

#include <string.h>

#include "harness/harness.h"
#include "fixtures/collision_build.h"

static inline vbss_collision_config config_of(const collision_query *query)
{
    vbss_collision_config config;
    expect_ok(vbss_collision_config_init(&config, sizeof config));
    config.thickness = query->thickness;
    return config;
}

static inline vbss_collision_impact ask(const vbss_collision_config *config,
                                        const collision_query *query)
{
    vbss_collision_impact impact;
    memset(&impact, 0, sizeof impact);
    expect_ok((query->kind == VBSS_COLLISION_PAIR_EDGE_EDGE ? vbss_collision_test_edges
                                                            : vbss_collision_test_point_triangle)(
        config, query->start, query->end, &impact, sizeof impact));
    return impact;
}

static inline vec3 vertex_of(const collision_query *query, bool end, int i)
{
    const double *x = end ? query->end : query->start;
    return vec3_load(x + (size_t)i * 3);
}

/* ---- changes that keep the truth */

static inline void exchange_numbers(double *a, double *b)
{
    double kept = *a;
    *a = *b;
    *b = kept;
}

static inline void exchange_vertices(collision_query *query, int i, int j)
{
    for (int k = 0; k < 3; k++) {
        exchange_numbers(&query->start[3 * i + k], &query->start[3 * j + k]);
        exchange_numbers(&query->end[3 * i + k], &query->end[3 * j + k]);
    }
}

/* Of edges. */
static inline void exchange_pair(collision_query *query)
{
    exchange_vertices(query, 0, 2);
    exchange_vertices(query, 1, 3);
}

static inline void reverse_time(collision_query *query)
{
    for (int i = 0; i < 12; i++) {
        exchange_numbers(&query->start[i], &query->end[i]);
    }
}

static inline void scale_all(collision_query *query, double by)
{
    for (int i = 0; i < 12; i++) {
        query->start[i] *= by;
        query->end[i] *= by;
    }
    query->thickness *= by;
}

/* ---- telling */

/* The query as C, to be pasted where it can be looked at alone. */
static inline void print_query(const char *why, const collision_query *query)
{
    char text[1200];
    int used = 0;
    for (int i = 0; i < 24; i++) {
        double x = i < 12 ? query->start[i] : query->end[i - 12];
        const char *after = i == 11 ? "}, .end = {" : i == 23 ? "}" : ", ";
        used += snprintf(text + used, sizeof text - (size_t)used, "%a%s", x, after);
    }
    print_error(
        "%s:\n    {.kind = %d, .thickness = %a, .hit = %d, .clearance = %g,\n     .start = {%s}\n",
        why, query->kind, query->thickness, query->hit, query->clearance, text);
}

/* Counts of answers against the truth. */
typedef struct score {
    uint64_t queries, hits, missed, invented, undecided, wrong;
    double worst; /* clearance of an invented hit, as a share of D, where the set knows it */
} score;

static inline void score_add(score *s, const collision_query *query,
                             const vbss_collision_impact *impact)
{
    s->queries++;
    s->hits += query->hit ? 1 : 0;
    s->missed += query->hit && !impact->hit ? 1 : 0;
    s->undecided += impact->decision == VBSS_COLLISION_DECISION_UNDECIDED ? 1 : 0;
    if (impact->hit && !query->hit) {
        s->invented++;
        if (query->clearance < 0.01 * query->thickness) {
            s->worst = fmax(s->worst, query->clearance / query->thickness);
        }
    }
}

/* The sets with thickness, by one number: capsules, then triangles, then the thread. */
static inline uint32_t thick_set_count(void)
{
    return collision_family_count + collision_sheet_count + 1;
}

static inline void make_thick_set(uint32_t which, uint32_t count, uint64_t seed, collision_set *set)
{
    uint32_t families = collision_family_count, sheets = collision_sheet_count;
    if (which < families) {
        assert_true(collision_set_family(which, count, seed, set));
    } else if (which < families + sheets) {
        assert_true(collision_set_sheet(which - families, count, seed, set));
    } else {
        assert_true(collision_set_thread(seed, set));
    }
}

#endif
