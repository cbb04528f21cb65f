/* How much of a limb a cut has left is seen by what touches what, as the detector may find a crossing far out. */
#include "scene/small.h"
#include "session/session.h"
#include "thread/thread.h"

enum { LEFT_SEGMENTS = 30, PIECE_SEGMENTS = 20 };
#define SEGMENT 1e-3

/* What is left: from the cut at the origin along x for 20 mm, then back beside itself, at a diameter, to x = 11 mm. */
static vec3 hairpin(double arc, double beside)
{
    return arc <= 0.02 ? vec3_make(arc, 0.0, 0.0) : vec3_make(0.041 - arc, beside, 0.0);
}

static void set_node(vbss_thread *thread, uint32_t node, vec3 position)
{
    thread_object *t;
    expect_ok(vbss_thread_open(thread, &t));
    t->now.x[node] = position;
}

/* Both pieces with their ends at the origin; the one that was cut off comes from x = -20 mm, or from where `past` says. */
static double free_length(uint32_t limb, bool with_piece, const vec3 *past)
{
    small s;
    vbss_thread *left, *piece;
    session_object session = {.steps = 0};
    scene_info info;
    const bool reversed = limb == SESSION_ENTRY;
    small_begin_scene(&s);
    uint32_t number =
        small_thread(&s, vec3_zero(), vec3_make(0.03, 0.0, 0.0), LEFT_SEGMENTS, &left);
    const double beside = 2.0 * s.thread.radius;
    for (uint32_t i = 0; i <= LEFT_SEGMENTS; i++) {
        set_node(left, reversed ? LEFT_SEGMENTS - i : i, hairpin(i * SEGMENT, beside));
    }
    if (with_piece) {
        (void)small_thread(&s, vec3_make(0.0, 0.1, 0.0), vec3_make(0.02, 0.1, 0.0), PIECE_SEGMENTS,
                           &piece);
        for (uint32_t i = 0; i <= PIECE_SEGMENTS; i++) {
            vec3 at = vec3_make(-SEGMENT * i, 0.0, 0.0);
            set_node(piece, reversed ? i : PIECE_SEGMENTS - i,
                     i == PIECE_SEGMENTS && past != NULL ? *past : at);
        }
    }
    session.scene = s.scene;
    expect_ok(vbss_scene_inspect(s.scene, &info));
    double length = vbss_session_find_free_length(&session, info.entry_count, number, limb);
    small_end(&s);
    return length;
}

static void limb_is_free_up_to_first_strand_that_touches(void **state)
{
    (void)state;
    for (uint32_t limb = 0; limb < SESSION_SIDES; limb++) {
        expect_near(11e-3, free_length(limb, true, NULL), 1.01 * SEGMENT);
    }
}

static void cut_is_in_knot_if_severed_piece_touches_it(void **state)
{
    (void)state;
    const vec3 touching = vec3_make(0.008, 0.0, 0.3e-3), clear = vec3_make(0.008, 0.0, 3e-3);
    for (uint32_t limb = 0; limb < SESSION_SIDES; limb++) {
        expect_same_bits(0.0, free_length(limb, true, &touching));
        assert_true(free_length(limb, true, &clear) > 9e-3);
    }
}

static void without_severed_piece_nothing_is_known_to_be_free(void **state)
{
    (void)state;
    for (uint32_t limb = 0; limb < SESSION_SIDES; limb++) {
        expect_same_bits(0.0, free_length(limb, false, NULL));
    }
}

int test_cut(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(limb_is_free_up_to_first_strand_that_touches),
        cmocka_unit_test(cut_is_in_knot_if_severed_piece_touches_it),
        cmocka_unit_test(without_severed_piece_nothing_is_known_to_be_free),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
