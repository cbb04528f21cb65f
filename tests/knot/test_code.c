/* Gauss codes: which can be drawn in the plane, and what Reidemeister's first two moves leave. */
#include "knot/diagram.h"

#include <string.h>

static diagram d;

static int begin(void **state)
{
    (void)state;
    diagram_begin(&d, DIAGRAM_CROSSINGS);
    return 0;
}

static int end(void **state)
{
    (void)state;
    diagram_end(&d);
    return 0;
}

static void simplify(knot_gauss_code *code)
{
    knot_ops work = 0;
    vbss_knot_gauss_code_simplify(code, &work);
    assert_true(work <= 0);
    assert_true(vbss_knot_gauss_code_is_planar(code));
}

static const char trefoil[] = "AbCaBc", eight[] = "AbCaDcBd", eight_signs[] = "+--+";

/* ---- planarity */

static bool is_planar(const char *entries, const char *signs)
{
    diagram_set_code(&d.code, entries, signs);
    return vbss_knot_gauss_code_is_planar(&d.code);
}

static void known_diagrams_are_planar(void **state)
{
    (void)state;
    assert_true(is_planar("", ""));
    assert_true(is_planar("Aa", "+"));
    assert_true(is_planar("aA", "-"));
    assert_true(is_planar(trefoil, "+++"));
    assert_true(is_planar(trefoil, "---"));
    assert_true(is_planar(eight, eight_signs));
}

static void damaged_code_is_not_planar(void **state)
{
    (void)state;
    assert_false(is_planar(trefoil, "++-"));
    assert_false(is_planar(trefoil, "-++"));
    assert_false(is_planar(eight, "-+++"));
    assert_false(is_planar("AbaB", "++"));    /* two that no curve in the plane has */
    assert_false(is_planar("AbCacB", "+++")); /* passages exchanged */
    assert_false(is_planar("ABCaBc", "+++")); /* twice over */
    d.code.crossing[1] = 7;
    assert_false(vbss_knot_gauss_code_is_planar(&d.code));
    diagram_set_code(&d.code, trefoil, "+++");
    d.code.crossing[1] = 0; /* three passages of one */
    assert_false(vbss_knot_gauss_code_is_planar(&d.code));
}

static void crossing_change_keeps_planarity(void **state)
{
    (void)state;
    assert_true(is_planar("abCABc", "-++"));
    assert_false(is_planar("abCABc", "--+"));
}

static void copy_is_equal(void **state)
{
    (void)state;
    diagram_set_code(&d.code, eight, eight_signs);
    vbss_knot_gauss_code_copy(&d.spare, &d.code);
    diagram_expect_code(eight, eight_signs, &d.spare);
    assert_memory_equal(d.code.position, d.spare.position, 8 * sizeof d.code.position[0]);
}

/* ---- moves put into a trefoil, wherever that can be drawn, and undone */

enum { PLACES = 8 }; /* five arcs, and three ways about the beginning */

/* Text before each entry of the trefoil, the last behind all. */
typedef char insertions[7][8];

static void append(char *text, char letter)
{
    size_t length = strlen(text);
    text[length] = letter;
    text[length + 1] = '\0';
}

static void insert(insertions into, int place, char first, char second)
{
    int at = place < 7 ? place : 6, at_second = place < 7 ? place : 0;
    append(into[at], first);
    append(into[at_second], second);
}

/* With signs for crossings d and e. */
static void set_trefoil_with(insertions into, char sign_d, char sign_e)
{
    char entries[32] = "", signs[8] = "", order[8] = "";
    for (size_t k = 0; k <= 6; k++) {
        for (const char *letter = into[k]; *letter != '\0'; letter++) {
            append(entries, *letter);
        }
        if (k < 6) {
            append(entries, trefoil[k]);
        }
    }
    for (const char *e = entries; *e != '\0'; e++) {
        char letter = (char)(*e <= 'Z' ? *e - 'A' + 'a' : *e);
        if (strchr(order, letter) == NULL) {
            append(order, letter);
            append(signs, (char)(letter == 'd' ? sign_d : letter == 'e' ? sign_e : '+'));
        }
    }
    diagram_set_code(&d.code, entries, signs);
    vbss_knot_gauss_code_copy(&d.spare, &d.code);
}

/* What is left is the trefoil, and where it was. A crossing of it may have gone instead of an alike one beside. */
static void expect_trefoil(void)
{
    double last = -1.0;
    simplify(&d.code);
    diagram_expect_code(d.code.over[0] != 0 ? trefoil : "aBcAbC", "+++", &d.code);
    for (uint32_t e = 0; e < 6; e++) {
        assert_true(d.code.position[e] > last);
        last = d.code.position[e];
        uint32_t before = (uint32_t)last; /* entry k was at k + 0.5 */
        assert_int_equal(d.code.over[e], d.spare.over[before]);
        expect_same_bits(before + 0.5, last);
    }
}

static void every_loop_is_reduced(void **state)
{
    (void)state;
    for (int variant = 0; variant < 4 * PLACES; variant++) {
        insertions into = {""};
        insert(into, variant / 4, variant % 2 == 0 ? 'd' : 'D', variant % 2 == 0 ? 'D' : 'd');
        set_trefoil_with(into, variant / 2 % 2 == 0 ? '+' : '-', ' ');
        assert_int_equal(4, d.code.n);
        assert_true(vbss_knot_gauss_code_is_planar(&d.code));
        expect_trefoil();
    }
}

static void every_nonalternating_bigon_is_reduced(void **state)
{
    (void)state;
    int undone[2] = {0, 0};
    for (int variant = 0; variant < 4 * PLACES * PLACES; variant++) {
        int over = variant / 4 / PLACES, under = variant / 4 % PLACES;
        bool is_parallel = variant % 2 == 0;
        insertions into = {""};
        insert(into, over, 'D', 'E');
        insert(into, under, is_parallel ? 'd' : 'e', is_parallel ? 'e' : 'd');
        set_trefoil_with(into, variant / 2 % 2 == 0 ? '+' : '-', variant / 2 % 2 == 0 ? '-' : '+');
        if (vbss_knot_gauss_code_is_planar(&d.code)) {
            undone[is_parallel ? 0 : 1]++;
            expect_trefoil();
        }
    }
    assert_int_equal(16, undone[0]); /* as many as faces of the trefoil allow */
    assert_int_equal(44, undone[1]);
}

static void alternating_bigons_stay(void **state)
{
    (void)state;
    diagram_set_code(&d.code, trefoil, "---");
    simplify(&d.code);
    diagram_expect_code(trefoil, "---", &d.code);
    diagram_set_code(&d.code, eight, eight_signs);
    simplify(&d.code);
    diagram_expect_code(eight, eight_signs, &d.code);
}

static void same_side_double_crossings_stay(void **state)
{
    (void)state;
    knot_ops work = 0;
    diagram_set_code(&d.code, "ABab", "++"); /* on a torus */
    vbss_knot_gauss_code_simplify(&d.code, &work);
    diagram_expect_code("ABab", "++", &d.code);
    diagram_set_code(&d.code, "ABab", "+-");
    simplify(&d.code);
    assert_int_equal(0, d.code.n);
}

static void one_move_enables_next(void **state)
{
    (void)state;
    diagram_set_code(&d.code, "AbCDdcBa", "+-+-"); /* loops inside loops */
    simplify(&d.code);
    assert_int_equal(0, d.code.n);
    diagram_set_code(&d.code, "dcBaAbCD", "+-+-"); /* about the beginning */
    simplify(&d.code);
    assert_int_equal(0, d.code.n);
    /* A knot whose every crossing is the same way over: it falls apart from both ends. */
    diagram_set_code(&d.code, "ABCabc", "+-+");
    simplify(&d.code);
    assert_int_equal(0, d.code.n);
}

/* ---- anything */

static bool has_move(const knot_gauss_code *code)
{
    uint32_t count = 2 * code->n;
    for (uint32_t e = 0; e < count; e++) {
        uint32_t f = (e + 1) % count, a = code->crossing[e], b = code->crossing[f];
        uint32_t mates[2] = {count, count};
        for (uint32_t k = 0; k < count; k++) {
            mates[0] = k != e && code->crossing[k] == a ? k : mates[0];
            mates[1] = k != f && code->crossing[k] == b ? k : mates[1];
        }
        bool beside = (mates[0] + 1) % count == mates[1] || (mates[1] + 1) % count == mates[0];
        if (a == b || (beside && code->over[e] == code->over[f])) {
            return true;
        }
    }
    return false;
}

static void expect_well_numbered(const knot_gauss_code *code)
{
    uint32_t visited = 0;
    for (uint32_t e = 0; e < 2 * code->n; e++) {
        assert_true(code->crossing[e] <= visited && visited <= code->n);
        visited += code->crossing[e] == visited ? 1 : 0;
        assert_true(e == 0 || code->position[e] > code->position[e - 1]);
    }
    assert_int_equal(code->n, visited);
}

static void any_code_becomes_one_of_the_same_knot_without_moves(harness_source *source, void *user)
{
    (void)user;
    diagram_random(&d, source, 5 + harness_draw_below(source, 26));
    diagram_project_plain(&d, harness_draw_below(source, 20));
    expect_well_numbered(&d.code);
    int64_t determinant = diagram_determinant(&d.code), v2 = diagram_v2(&d.code);
    vbss_knot_gauss_code_copy(&d.spare, &d.code);
    memset(d.spare.scratch, (int)harness_draw_below(source, 256),
           4 * (size_t)d.spare.capacity * sizeof d.spare.scratch[0]);
    simplify(&d.code);
    simplify(&d.spare);
    expect_well_numbered(&d.code);
    assert_false(has_move(&d.code));
    assert_int_equal(determinant, diagram_determinant(&d.code));
    assert_int_equal(v2, diagram_v2(&d.code));
    assert_int_equal(d.code.n, d.spare.n);
    uint32_t entries = 2 * d.code.n;
    assert_memory_equal(d.code.crossing, d.spare.crossing, entries * sizeof d.code.crossing[0]);
    assert_memory_equal(d.code.position, d.spare.position, entries * sizeof d.code.position[0]);
}

static void reduction_keeps_knot_type(void **state)
{
    (void)state;
    harness_property("codes keep their knot", 400,
                     any_code_becomes_one_of_the_same_knot_without_moves, NULL);
}

int test_code(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(known_diagrams_are_planar),
        harness_test(damaged_code_is_not_planar),
        harness_test(crossing_change_keeps_planarity),
        harness_test(copy_is_equal),
        harness_test(every_loop_is_reduced),
        harness_test(every_nonalternating_bigon_is_reduced),
        harness_test(alternating_bigons_stay),
        harness_test(same_side_double_crossings_stay),
        harness_test(one_move_enables_next),
        harness_test(reduction_keeps_knot_type),
    };
    return cmocka_run_group_tests_name("code", tests, begin, end);
}
