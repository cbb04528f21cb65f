/* The answer of CONSERVATIVE does not depend on units, origin, order of vertices, order of the pair, or
 * the direction of time: for D = 0 exactly, else outside the tolerance. */
#include "query.h"
#include "fixtures/collision_integers.h"

/* ---- changes that keep the truth, all exact */

typedef struct change {
    const char *name;
    void (*apply)(collision_query *query, double amount);
    double amount;
} change;

static void scale(collision_query *query, double amount)
{
    scale_all(query, amount);
}

static void each_coordinate(collision_query *query, double (*f)(double x, int k, double amount),
                            double amount)
{
    for (int i = 0; i < 12; i++) {
        query->start[i] = f(query->start[i], i % 3, amount);
        query->end[i] = f(query->end[i], i % 3, amount);
    }
}

static double moved(double x, int k, double amount)
{
    return x + (k == 0 ? amount : k == 1 ? -0.75 * amount : 0.25 * amount);
}

static void translate(collision_query *query, double amount)
{
    each_coordinate(query, moved, amount);
}

/* The ends of a, of b, or of both; of a triangle the corners in turn, or two of them. */
static void reorder(collision_query *query, double amount)
{
    bool edges = query->kind == VBSS_COLLISION_PAIR_EDGE_EDGE;
    if (amount != 2.0) {
        exchange_vertices(query, edges ? 0 : 1, edges ? 1 : 2);
    }
    if (amount != 1.0) {
        exchange_vertices(query, 2, 3);
    }
}

static void swap_pair(collision_query *query, double amount)
{
    (void)amount;
    if (query->kind == VBSS_COLLISION_PAIR_EDGE_EDGE) {
        exchange_pair(query);
    }
}

static void reverse(collision_query *query, double amount)
{
    (void)amount;
    reverse_time(query);
}

/* Axes in turn, and mirrored: the same sums in another order. */
static void turn_axes(collision_query *query, double amount)
{
    for (int i = 0; i < 12; i += 3) {
        for (int end = 0; end < 2; end++) {
            double *x = end == 0 ? &query->start[i] : &query->end[i];
            exchange_numbers(&x[0], &x[1]);
            exchange_numbers(&x[1], &x[2]);
            x[2] *= amount;
        }
    }
}

static const change changes[] = {
    {"scaled by 2^-10", scale, 0x1p-10},    {"scaled by 2^-60", scale, 0x1p-60},
    {"scaled by 2^60", scale, 0x1p60},      {"moved by 1e4", translate, 1e4},
    {"moved by -3e-3", translate, -0x1p-8}, {"ends of a swapped", reorder, 1.0},
    {"ends of b swapped", reorder, 2.0},    {"all ends swapped", reorder, 3.0},
    {"a and b swapped", swap_pair, 0.0},    {"time reversed", reverse, 0.0},
    {"axes in turn", turn_axes, 1.0},       {"axes mirrored", turn_axes, -1.0},
};

/* ---- coordinates that all changes keep exact: multiples of 2^-34 */

static double rounded(double x, int k, double amount)
{
    (void)k;
    return rint(x / amount) * amount;
}

static bool same_numbers(const double *a, const double *b, int count)
{
    bool same = true;
    for (int i = 0; i < count; i++) {
        same = same && a[i] == b[i];
    }
    return same;
}

/* Whether the change can be undone, so nothing was rounded. */
static bool is_exact(const collision_query *query, const change *c)
{
    if (c->apply != translate && c->apply != scale) {
        return true;
    }
    collision_query there = *query;
    c->apply(&there, c->amount);
    c->apply(&there, c->apply == scale ? 1.0 / c->amount : -c->amount);
    return same_numbers(there.start, query->start, 12) && same_numbers(there.end, query->end, 12);
}

/* Whether the answer may be either: a miss within the tolerance of D, give and take rounding. */
static bool is_open(const collision_query *query, double tolerance)
{
    collision_query narrow = *query, wide = *query;
    wide.thickness *= 1.0 + 1.001 * tolerance;
    narrow.thickness *= 1.0 - 1e-9;
    return !(collision_truth(&narrow) && narrow.hit) && !(collision_truth(&wide) && !wide.hit);
}

static void expect_unchanged(const collision_query *query)
{
    vbss_collision_config config = config_of(query);
    vbss_collision_impact first = ask(&config, query);
    if (query->thickness > 0.0 && is_open(query, config.tolerance)) {
        return;
    }
    for (size_t i = 0; i < sizeof changes / sizeof changes[0]; i++) {
        if (!is_exact(query, &changes[i])) {
            continue;
        }
        collision_query other = *query;
        changes[i].apply(&other, changes[i].amount);
        config.thickness = other.thickness;
        vbss_collision_impact impact = ask(&config, &other);
        if (impact.hit != first.hit) {
            print_query(changes[i].name, query);
            fail_msg("%s: %d became %d", changes[i].name, first.hit, impact.hit);
        }
    }
}

static void invariance_with_thickness(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < thick_set_count(); i++) {
        collision_set set;
        make_thick_set(i, 200, 21, &set);
        for (uint32_t k = 0; k < set.count; k += i + 1 == thick_set_count() ? 20 : 1) {
            each_coordinate(&set.queries[k], rounded, 0x1p-34);
            expect_unchanged(&set.queries[k]);
        }
        collision_set_release(&set);
    }
}

static void invariance_without_thickness(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 2 * collision_degenerate_count; i++) {
        collision_set set;
        assert_true(collision_set_degenerate(i / 2, (vbss_collision_pair_kind)(i % 2), 200, 22,
                                             NULL, &set));
        for (uint32_t k = 0; k < set.count; k++) {
            expect_unchanged(&set.queries[k]); /* as they are: moved only where that is exact */
            each_coordinate(&set.queries[k], rounded, 0x1p-34);
            expect_unchanged(&set.queries[k]);
        }
        collision_set_release(&set);
    }
}

int test_invariance(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(invariance_with_thickness),
        cmocka_unit_test(invariance_without_thickness),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
