/* CONSERVATIVE with thickness: no hit is missed, none is invented beyond the tolerance, and no contact
 * comes before the time that is told. */
#include "base/check.h"
#include "query.h"

/* Queries of a family; the thread has its own number. */
enum { COUNT = 300 };

static void expect_score(const char *name, const score *s)
{
    print_message("%-24s %5llu queries, %4llu hits: missed %llu, invented %llu (by %.2g D at "
                  "most), undecided %llu, wrong %llu\n",
                  name, (unsigned long long)s->queries, (unsigned long long)s->hits,
                  (unsigned long long)s->missed, (unsigned long long)s->invented, s->worst,
                  (unsigned long long)s->undecided, (unsigned long long)s->wrong);
    assert_int_equal(s->missed, 0);
    assert_int_equal(s->wrong, 0);
    assert_int_equal(s->undecided, 0);
}

/* Largest coordinate, for what rounding may do. */
static double size_of(const collision_query *query)
{
    return fmax(vbss_max_abs(query->start, 12), vbss_max_abs(query->end, 12));
}

/* What is wrong with a hit that was told: a contact before its time, among some earlier times; no contact
 * at its time, or another distance. NULL: nothing. */
static const char *wrong_time(const collision_query *query, const vbss_collision_impact *impact,
                              double tolerance)
{
    double rounding = 1e-14 * size_of(query);
    for (int i = 0; i < 16 && impact->time > 0.0; i++) {
        long double t = (long double)impact->time * i / 16.0L;
        if ((double)collision_distance(query, t) <= query->thickness - rounding) {
            return "contact before the time told";
        }
    }
    double then = (double)collision_distance(query, (long double)impact->time);
    if (then > query->thickness * (1.0 + tolerance) + rounding) {
        return "no contact at the time told";
    }
    return fabs(then - impact->distance) > rounding ? "another distance at the time told" : NULL;
}

/* Whether the smallest distance is above D (1 + tolerance): then a hit is wrong. */
static bool is_clear(const collision_query *query, double tolerance)
{
    collision_query wider = *query;
    wider.thickness *= 1.0 + tolerance;
    return collision_truth(&wider) && !wider.hit;
}

static score score_set(const collision_set *set, double tolerance, bool times)
{
    score s = {0};
    for (uint32_t i = 0; i < set->count; i++) {
        const collision_query *query = &set->queries[i];
        vbss_collision_config config = config_of(query);
        config.tolerance = tolerance;
        vbss_collision_impact impact = ask(&config, query);
        score_add(&s, query, &impact);
        const char *wrong = query->hit && !impact.hit ? "missed" : NULL;
        if (impact.hit && !query->hit && is_clear(query, tolerance)) {
            wrong = "invented";
        } else if (impact.hit && times) {
            wrong = wrong_time(query, &impact, tolerance);
        }
        if (wrong != NULL && s.wrong++ < 3) { /* enough to go on with */
            print_query(wrong, query);
        }
    }
    return s;
}

static void no_false_negative_in_any_family(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < thick_set_count(); i++) {
        collision_set set;
        make_thick_set(i, COUNT, 11, &set);
        score s = score_set(&set, 1e-3, true);
        expect_score(set.name, &s);
        collision_set_release(&set);
    }
}

static void no_false_negative_at_any_tolerance(void **state)
{
    (void)state;
    const double tolerances[] = {1.0, 1e-2, 1e-4, 1e-6};
    for (int k = 0; k < 4; k++) {
        score all = {0};
        for (uint32_t i = 0; i + 1 < thick_set_count(); i++) {
            collision_set set;
            make_thick_set(i, COUNT / 3, 12, &set);
            bool far = strstr(set.name, "far origin") != NULL; /* where 1e-6 D is rounding */
            score s = score_set(&set, tolerances[k], !far || tolerances[k] > 1e-5);
            all.queries += s.queries;
            all.hits += s.hits;
            all.missed += s.missed;
            all.invented += s.invented;
            all.undecided += far ? 0 : s.undecided;
            all.wrong += far ? 0 : s.wrong;
            all.worst = vbss_max_or_nan(all.worst, s.worst);
            collision_set_release(&set);
        }
        char name[40];
        snprintf(name, sizeof name, "tolerance %g", tolerances[k]);
        expect_score(name, &all);
    }
}

/* Giving up is telling a hit. */
static void no_false_negative_with_few_passes(void **state)
{
    (void)state;
    uint64_t undecided = 0;
    for (uint32_t i = 0; i < thick_set_count(); i++) {
        collision_set set;
        make_thick_set(i, COUNT / 3, 13, &set);
        for (uint32_t k = 0; k < set.count; k++) {
            const collision_query *query = &set.queries[k];
            vbss_collision_config config = config_of(query);
            config.pass_limit = 1 + k % 3;
            vbss_collision_impact impact = ask(&config, query);
            assert_true(impact.hit || !query->hit);
            assert_true(impact.passes <= config.pass_limit);
            undecided += impact.decision == VBSS_COLLISION_DECISION_UNDECIDED ? 1 : 0;
        }
        collision_set_release(&set);
    }
    assert_true(undecided > 100);
}

int test_conservative(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_false_negative_in_any_family),
        cmocka_unit_test(no_false_negative_at_any_tolerance),
        cmocka_unit_test(no_false_negative_with_few_passes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
