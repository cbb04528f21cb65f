/* Prime knots that have the determinant, signatures, v2 and v3 of stacked throws, or of the unknot.
 *
 * Each file of polygons/ holds a closed polygon: x y z of a vertex on a line, in units of 1e-4 of
 * an edge. */
#include <string.h>

#include "harness/harness.h"
#include "knot/judge.h"

typedef struct prime_knot {
    const char *name;
    const char *resembles;
    int64_t determinant;
} prime_knot;

static const prime_knot knots[] = {
    {"10_99", "1+1+1+1", 81},
    {"K11n106", "1+1+1", 27},
    {"K13n2803", "2", 5},
    {"K16n203049", "no knot", 1},
};
enum { KNOTS = sizeof knots / sizeof knots[0], VERTICES = 16 };

static uint32_t read_polygon(const char *name, vec3 x[VERTICES])
{
    char path[512];
    int xyz[3];
    uint32_t count = 0;
    snprintf(path, sizeof path, "%s/%s.txt", VBSS_KNOT_POLYGONS_DIR, name);
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    while (count < VERTICES && fscanf(file, "%d %d %d", &xyz[0], &xyz[1], &xyz[2]) == 3) {
        x[count++] = vec3_scale(vec3_make(xyz[0], xyz[1], xyz[2]), 1e-6);
    }
    (void)fclose(file);
    return count;
}

static uint32_t farthest_vertex(const vec3 *x, uint32_t count, vec3 *outward)
{
    vec3 centre = vec3_zero();
    uint32_t farthest = 0;
    for (uint32_t i = 0; i < count; i++) {
        centre = vec3_add_scaled(centre, 1.0 / count, x[i]);
    }
    for (uint32_t i = 1; i < count; i++) {
        farthest = vec3_distance(x[i], centre) > vec3_distance(x[farthest], centre) ? i : farthest;
    }
    *outward = vec3_sub(x[farthest], centre);
    return farthest;
}

/* The polygon opened at its outermost vertex, from which both ends lead straight out. */
static void open_polygon(const char *name, thread_line *line)
{
    vec3 x[VERTICES], outward;
    uint32_t count = read_polygon(name, x), first = farthest_vertex(x, count, &outward);
    assert_true(count >= 10);
    memset(line, 0, sizeof *line);
    line->tissue_place = -1.0;
    for (uint32_t i = 0; i < count; i++) {
        line->x[i + 1] = x[(first + i) % count];
    }
    vec3 last = vec3_lerp(line->x[1], line->x[count], 1e-3); /* beside the first vertex */
    line->x[0] = vec3_add_scaled(line->x[1], 3.0, outward);
    line->x[count + 1] = last;
    line->x[count + 2] = vec3_add_scaled(last, 3.0, outward);
    line->count = count + 3;
}

static void hear(judge *j, thread_line *line, judge_saying *saying)
{
    vbss_knot_input input = judge_input_of(line);
    expect_ok(judge_hear(j, &input, saying));
}

static void expect_other(const prime_knot *k, const judge_saying *saying)
{
    if (saying->state.name != VBSS_KNOT_NAME_OTHER) {
        fail_msg("%s, which looks like %s, is reported as \"%s\"", k->name, k->resembles,
                 saying->notation);
    }
    assert_int_equal(saying->state.verdict, VBSS_KNOT_VERDICT_FORMED);
    assert_string_equal(saying->notation, "?");
    assert_int_equal(saying->state.throw_count, 0);
    assert_int_equal(saying->state.determinant, k->determinant);
}

/* As it is, and as its mirror image from the other end on. */
static void prime_knot_is_no_stack_of_throws(void **state)
{
    (void)state;
    static thread_line line;
    judge j;
    judge_saying saying;
    judge_begin(&j);
    assert_true(judge_make(&j));
    for (int i = 0; i < KNOTS; i++) {
        open_polygon(knots[i].name, &line);
        hear(&j, &line, &saying);
        expect_other(&knots[i], &saying);
        thread_line_reverse(&line);
        thread_line_mirror(&line);
        hear(&j, &line, &saying);
        expect_other(&knots[i], &saying);
    }
    judge_end(&j);
}

int test_prime_knots(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(prime_knot_is_no_stack_of_throws),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
