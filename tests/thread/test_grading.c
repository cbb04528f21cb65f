/* Rest lengths that are fine at one place. */
#include "fixture.h"

enum { ROOM = 4096 };

typedef struct graded {
    double length, centre, finest, coarsest, ratio;
    double lengths[ROOM];
    uint32_t count;
} graded;

static vbss_result grade(graded *g, uint32_t capacity)
{
    return vbss_thread_grade_lengths(g->length, g->centre, g->finest, g->coarsest, g->ratio,
                                     g->lengths, capacity, &g->count);
}

static void draw(harness_source *source, graded *g)
{
    const double places[] = {0.0, 1.0, 0.5, 1e-9, 1.0 - 1e-9};
    g->length = harness_draw_real(source, 0.01, 1.0);
    uint32_t special = harness_draw_below(source, 8);
    double share = harness_draw_real(source, 0.0, 1.0);
    g->centre = g->length * (special < 5 ? places[special] : share);
    g->coarsest = g->length * harness_draw_real(source, 0.002, 1.0);
    g->finest = g->coarsest * harness_draw_real(source, 0.05, 1.0);
    g->ratio = harness_draw_below(source, 4) == 0 ? 1.0 : harness_draw_real(source, 1.0, 2.0);
}

static void any_grading_keeps_its_promises(harness_source *source, void *user)
{
    (void)user;
    static graded g;
    draw(source, &g);
    vbss_result result = grade(&g, ROOM);
    expect_result(g.count > ROOM ? VBSS_ERROR_CAPACITY : VBSS_OK, result);
    if (g.count > ROOM) {
        return;
    }
    assert_true(g.count >= 1);
    double sum = 0.0;
    for (uint32_t i = 0; i < g.count; i++) {
        /* Scaled down to fit, to no less than half, never up. */
        assert_true(g.lengths[i] >= 0.5 * g.finest * (1.0 - 1e-12));
        assert_true(g.lengths[i] <= g.coarsest * (1.0 + 1e-12));
        if (i > 0) {
            /* Each side is scaled by itself: where they meet, one may be half of the other. */
            double a = g.lengths[i - 1], b = g.lengths[i];
            bool meet = fabs(sum - g.centre) <= 1e-9 * g.length;
            assert_true(fmax(a / b, b / a) <= (meet ? 2.0 : g.ratio) * (1.0 + 1e-9));
        }
        sum += g.lengths[i];
    }
    expect_near(g.length, sum, 1e-12 * g.length);
}

static void grading_bounds_hold(void **state)
{
    (void)state;
    harness_property("grading", 3000, any_grading_keeps_its_promises, NULL);
}

/* What is graded makes a thread. */
static void graded_lengths_make_thread(void **state)
{
    (void)state;
    static graded g = {
        .length = 0.15, .centre = 0.1, .finest = 2e-4, .coarsest = 5e-3, .ratio = 1.2};
    fixture f;
    begin(&f);
    expect_ok(grade(&g, ROOM));
    f.config.rest_lengths = g.lengths;
    f.config.segment_count = g.count;
    vbss_thread *thread = make(&f);
    double finest = 1.0, at = 0.0, place = 0.0;
    for (uint32_t i = 0; i < g.count; i++) {
        double l = number_at(thread, VBSS_THREAD_VIEW_REST_LENGTHS, i);
        expect_same_bits(g.lengths[i], l);
        place = l < finest ? at : place;
        finest = l < finest ? l : finest;
        at += l;
    }
    expect_near(0.1, place, 1e-3);
    hold(thread, VBSS_THREAD_ATTACHMENT_CLAMP, 0, vec3_zero());
    steps(thread, 100, 1e-3);
    assert_true(statistics_of(thread).stretch_error <= 5e-6);
    end(&f);
}

static void excess_count_is_reported(void **state)
{
    (void)state;
    static graded g = {
        .length = 1.0, .centre = 0.4, .finest = 0.01, .coarsest = 0.05, .ratio = 1.1};
    expect_ok(grade(&g, ROOM));
    uint32_t count = g.count;
    for (uint32_t capacity = 0; capacity < count; capacity++) {
        g.count = 0;
        g.lengths[capacity] = -1.0;
        expect_result(VBSS_ERROR_CAPACITY, grade(&g, capacity));
        assert_int_equal(g.count, count);
        expect_same_bits(-1.0, g.lengths[capacity]);
    }
    expect_ok(grade(&g, count));
    expect_result(VBSS_ERROR_CAPACITY,
                  vbss_thread_grade_lengths(1.0, 0.4, 0.01, 0.05, 1.1, NULL, 0, &count));
    assert_int_equal(count, g.count);
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_thread_grade_lengths(1.0, 0.4, 0.01, 0.05, 1.1, NULL, count, &count));
    expect_result(VBSS_ERROR_CAPACITY,
                  vbss_thread_grade_lengths(1.0, 0.5, 1e-6, 1e-6, 1.0, NULL, 0, &count));
    expect_result(VBSS_ERROR_CAPACITY,
                  vbss_thread_grade_lengths(1e3, 0.5, 2e-7, 2e-7, 1.0, NULL, 0, &count));
}

static void bad_numbers_are_rejected(void **state)
{
    (void)state;
    double lengths[256];
    uint32_t count;
    const double good[5] = {1.0, 0.4, 0.01, 0.05, 1.1};
    const double low[5] = {0.9e-6, -1e-9, 0.9e-7, 0.009, 0.999};
    const double high[5] = {1.1e3, 1.001, 0.0501, 1.001, 2.001};
    for (int k = 0; k < 5; k++) {
        for (int bad = 0; bad < 5; bad++) {
            double a[5];
            memcpy(a, good, sizeof a);
            a[k] = bad < 3 ? harness_bad_numbers[bad] : bad == 3 ? low[k] : high[k];
            expect_result(
                bad < 3 ? VBSS_ERROR_NOT_FINITE : VBSS_ERROR_OUT_OF_RANGE,
                vbss_thread_grade_lengths(a[0], a[1], a[2], a[3], a[4], lengths, 256, &count));
        }
    }
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_thread_grade_lengths(1.0, 0.4, 0.01, 0.05, 1.1, lengths, 256, NULL));
}

int test_grading(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(grading_bounds_hold),
        cmocka_unit_test(graded_lengths_make_thread),
        cmocka_unit_test(excess_count_is_reported),
        cmocka_unit_test(bad_numbers_are_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
