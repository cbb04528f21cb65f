/* A needle that leaves a hole, the way it came or through it, and comes again; tremor at the wall. */
#include "scene/contacts/contacts.h"
#include "scene/tissue/tissue.h"
#include "scene/world/world.h"
#include "scene/needle_case.h"

static needle_case c;

#define BEFORE 1.0e-3
#define SPEED 20e-3

/* Friction of the only hole, with what the needle is pressed across it. */
static double bound_of(const needle_case *n)
{
    vbss_scene_hole holes[NEEDLE_CASE_HOLES];
    if (needle_case_holes(n, holes) == 0) {
        return n->d.config.hole_force;
    }
    vec3 force = vec3_load(holes[0].force);
    double along = vec3_dot(force, vec3_load(holes[0].direction));
    double across = sqrt(fmax(vec3_norm_squared(force) - along * along, 0.0));
    return n->d.config.hole_force + n->d.config.hole_friction * across +
           n->d.config.hole_damping * SPEED;
}

static void withdrawn_tip_leaves_and_reenters(void **state)
{
    (void)state;
    vbss_scene_hole holes[NEEDLE_CASE_HOLES];
    needle_case_begin_at_mark(&c, VBSS_DRAIN_MESH_137, BEFORE);
    assert_true(needle_case_drive(&c, 9e-3, SPEED, VBSS_SCENE_EVENT_PUNCTURE));
    assert_false(needle_case_drive(&c, 3e-3, SPEED, VBSS_SCENE_EVENT_PUNCTURE));
    /* Back, friction turns over first. */
    double pull = 0.0, bound = 0.0, over = 0.0;
    while (c.counts[VBSS_SCENE_EVENT_WITHDRAWN] == 0 && c.d.steps < 3000) {
        needle_case_turn(&c, -SPEED * c.d.h);
        needle_case_step(&c);
        if (needle_case_holes(&c, holes) > 0) {
            bound = bound_of(&c);
            over = fmax(over, fabs(holes[0].friction) - bound);
        }
        pull = fmax(pull, -c.push);
    }
    expect_near(bound, pull, 0.05);
    assert_true(over < 1e-3 && pull < 2.0 * c.d.config.hole_force);
    assert_int_equal(needle_case_holes(&c, holes), 0);
    assert_int_equal(c.crossings, 0);
    needle_case_shift(&c, vec3_make(0.8e-3, 0.0, 0.0));
    assert_false(needle_case_drive(&c, -5e-3, SPEED, VBSS_SCENE_EVENT_PUNCTURE));
    assert_int_equal(c.counts[VBSS_SCENE_EVENT_WITHDRAWN], 1);
    /* What it has left is whole again. */
    c.at_tip = 0.0;
    assert_true(needle_case_drive(&c, 14e-3, SPEED, VBSS_SCENE_EVENT_PUNCTURE));
    expect_near(c.d.config.puncture_force, c.at_tip, 0.02);
    assert_int_equal(needle_case_holes(&c, holes), 1);
    assert_int_equal(holes[0].id, 2);
    assert_true(fabs(holes[0].rest_position[0]) > 0.4e-3);
    assert_int_equal(c.counts[VBSS_SCENE_EVENT_PUNCTURE], 2);
    needle_case_expect_kept(&c, "out and in", 0);
    needle_case_end(&c);
}

/* A short needle with little friction goes through one wall altogether. */
static void needle_end_passes_through(void **state)
{
    (void)state;
    vbss_scene_hole holes[NEEDLE_CASE_HOLES];
    needle_case_begin(&c);
    c.config.arc = 0.7;
    needle_case_make(&c);
    needle_case_at_mark(&c, BEFORE);
    assert_true(needle_case_drive(&c, 9e-3, SPEED, VBSS_SCENE_EVENT_PUNCTURE));
    assert_true(needle_case_drive(&c, 14e-3, SPEED, VBSS_SCENE_EVENT_PASSED));
    needle_case_wait(&c, 300);
    assert_int_equal(c.counts[VBSS_SCENE_EVENT_PASSED], 1);
    assert_int_equal(c.counts[VBSS_SCENE_EVENT_WITHDRAWN], 0);
    uint32_t left = needle_case_holes(&c, holes);
    assert_int_equal(left + 1, c.counts[VBSS_SCENE_EVENT_PUNCTURE]);
    assert_int_equal(c.crossings, left);
    needle_case_expect_kept(&c, "through", 0);
    needle_case_end(&c);
}

/* 1 mm at 10 Hz, while the mean goes on at 2 mm/s. */
static void tremor_makes_one_hole(void **state)
{
    (void)state;
    needle_case_begin_at_mark(&c, VBSS_DRAIN_MESH_137, BEFORE);
    assert_false(needle_case_drive(&c, BEFORE + 3.5e-3, SPEED, VBSS_SCENE_EVENT_PUNCTURE));
    double before = 0.0;
    for (uint32_t i = 1; i <= 2000; i++) {
        double at = 1e-3 * sin(2.0 * VBSS_PI * 10.0 * i * c.d.h) + 2e-3 * i * c.d.h;
        needle_case_turn(&c, at - before);
        before = at;
        needle_case_step(&c);
        uint32_t in = c.counts[VBSS_SCENE_EVENT_PUNCTURE],
                 out = c.counts[VBSS_SCENE_EVENT_WITHDRAWN];
        assert_true(in <= out + 1);
        assert_true(
            c.happened[VBSS_SCENE_EVENT_PUNCTURE] + c.happened[VBSS_SCENE_EVENT_WITHDRAWN] <= 1);
    }
    assert_true(c.counts[VBSS_SCENE_EVENT_PUNCTURE] >= 1);
    assert_true(c.counts[VBSS_SCENE_EVENT_PUNCTURE] <= 2);
    needle_case_expect_kept(&c, "tremor", 0);
    needle_case_end(&c);
}

/* As it enters: the tip goes to and fro by less than the hysteresis. */
static void tremor_at_entry_keeps_hole(void **state)
{
    (void)state;
    needle_case_begin_at_mark(&c, VBSS_DRAIN_MESH_137, BEFORE);
    assert_true(needle_case_drive(&c, 9e-3, SPEED, VBSS_SCENE_EVENT_PUNCTURE));
    double before = 0.0;
    for (uint32_t i = 1; i <= 500; i++) {
        double at = 0.1e-3 * sin(2.0 * VBSS_PI * 10.0 * i * c.d.h);
        needle_case_turn(&c, at - before);
        before = at;
        needle_case_step(&c);
    }
    assert_int_equal(c.counts[VBSS_SCENE_EVENT_PUNCTURE], 1);
    assert_int_equal(c.counts[VBSS_SCENE_EVENT_WITHDRAWN], 0);
    needle_case_expect_kept(&c, "trembles", 0);
    needle_case_end(&c);
}

/* Along the wall it slides. */
static void tip_drawn_along_wall_slides(void **state)
{
    (void)state;
    needle_case_begin(&c);
    needle_case_make(&c);
    needle_case_hold_edge(&c);
    /* Along x over the side, a little into it, its arc bent outward. */
    vec3 mark = drain_case_node(&c.d, c.d.places.marks[DRAIN_RIGHT]);
    vec3 out = vec3_unit_or(vec3_make(0.0, mark.y, mark.z), vec3_zero());
    vec3 tip = vec3_add(vec3_scale(out, 6.5e-3 + 0.8e-3), vec3_make(-8e-3, 0.0, 0.0));
    needle_case_put(&c, tip, vec3_make(1.0, 0.0, 0.0), vec3_neg(out));
    for (uint32_t i = 0; i < 400; i++) {
        needle_case_shift(&c, vec3_make(40e-6, -2e-6 * out.y, -2e-6 * out.z));
        needle_case_step(&c);
    }
    assert_int_equal(c.counts[VBSS_SCENE_EVENT_PUNCTURE], 0);
    assert_true(vec3_norm(needle_case_hand_force(&c)) > 0.0);
    needle_case_expect_kept(&c, "slides", 0);
    needle_case_end(&c);
}

/* 66 degrees off the normal of a wall that gives way: the hole is far before the wall that it presses on. */
static void oblique_entry_makes_one_hole(void **state)
{
    (void)state;
    vbss_scene_hole holes[NEEDLE_CASE_HOLES];
    needle_case_begin(&c);
    c.at_hole = 4.0;
    c.d.config.puncture_force = 0.15; /* before it slides off */
    needle_case_make(&c);
    needle_case_hold_edge(&c);
    vec3 mark = drain_case_node(&c.d, c.d.places.marks[DRAIN_RIGHT]);
    vec3 out = vec3_unit_or(vec3_make(0.0, mark.y, mark.z), vec3_zero());
    vec3 along = vec3_make(1.0, 0.0, 0.0);
    vec3 direction = vec3_add_scaled(vec3_scale(out, -0.4), sqrt(0.84), along);
    needle_case_put(&c, vec3_add_scaled(mark, -2e-3, direction), direction, vec3_neg(out));
    for (uint32_t i = 0; i < 1000 && c.counts[VBSS_SCENE_EVENT_PUNCTURE] == 0; i++) {
        needle_case_shift(&c, vec3_scale(direction, 20e-6));
        needle_case_step(&c);
    }
    assert_int_equal(needle_case_holes(&c, holes), 1);
    assert_true(holes[0].arc_length < -1.3e-3);
    for (uint32_t i = 0; i < 200; i++) {
        needle_case_shift(&c, vec3_scale(direction, 20e-6));
        needle_case_step(&c);
    }
    assert_int_equal(c.counts[VBSS_SCENE_EVENT_PUNCTURE], 1);
    needle_case_expect_kept(&c, "aslant", 0);
    needle_case_end(&c);
}

/* Folded, another wall may lie where a hole is: that is not pierced. */
static void hole_is_in_one_wall(void **state)
{
    (void)state;
    needle_case_begin_at_mark(&c, VBSS_DRAIN_MESH_137, BEFORE);
    assert_true(needle_case_drive(&c, 9e-3, SPEED, VBSS_SCENE_EVENT_PUNCTURE));
    const scene_object *s = small_object(&c.d.s);
    const scene_body *drain = vbss_scene_body(s, c.d.body);
    const suture_hole *hole = &s->holes[0];
    scene_wall_point point = vbss_scene_wall_point(drain, hole->triangle, hole->barycentric);
    const scene_body *needle = vbss_scene_body(s, c.body);
    assert_true(vbss_scene_contact_scale_at(s, needle, true, 0, 0.0, drain, &point, 1e-3) == 0.0);
    point.rest.z = -point.rest.z;
    assert_true(vbss_scene_contact_scale_at(s, needle, true, 0, 0.0, drain, &point, 1e-3) == 1.0);
    needle_case_end(&c);
}

/* A side along the capsule's axis, a millimetre beside it, so that its shares are the same. */
static void place_side_along(scene_object *s, const scene_body *needle, uint32_t capsule,
                             uint32_t side)
{
    drain_object *d = vbss_scene_body(s, c.d.body)->drain.drain;
    const scene_body *drain = vbss_scene_body(s, c.d.body);
    const uint32_t *node = s->collision->shapes[drain->shape]->edges[side];
    const vec3 *axis = s->capsules[needle->rigid.first_capsule + capsule].now;
    vec3 aside = vec3_cross(vec3_sub(axis[1], axis[0]), vec3_make(1.0, 0.0, 0.0));
    for (int k = 0; k < 2; k++) {
        d->x[node[k]] = vec3_add_scaled(axis[k], 1e-3, vec3_unit_or(aside, vec3_zero()));
    }
}

static void expect_piece(scene_object *s, uint32_t capsule, double from, double to,
                         scene_axis_interval *piece)
{
    const scene_body *needle = vbss_scene_body(s, c.body), *drain = vbss_scene_body(s, c.d.body);
    const needle_object *n = needle->rigid.needle;
    double begin = vbss_needle_vertex_arc(n, capsule), end = vbss_needle_vertex_arc(n, capsule + 1);
    assert_true(vbss_scene_next_axis_interval(s, needle, capsule, drain, 0, 0.5e-3, piece));
    const double expected[2] = {(from - begin) / (end - begin), (to - begin) / (end - begin)};
    for (int k = 0; k < 2; k++) {
        assert_true(fabs(piece->bounds[0][k] - expected[k]) < 1e-12);
        assert_true(fabs(piece->bounds[1][k] - expected[k]) < 1e-9);
    }
}

static void expect_no_piece(scene_object *s, uint32_t capsule, scene_axis_interval *piece)
{
    const scene_body *needle = vbss_scene_body(s, c.body), *drain = vbss_scene_body(s, c.d.body);
    assert_false(vbss_scene_next_axis_interval(s, needle, capsule, drain, 0, 0.5e-3, piece));
}

/* A capsule is longer than what a hole exempts: what is left of it before and behind the hole touches what is beside that. */
static void needle_collides_before_and_behind_hole(void **state)
{
    (void)state;
    needle_case_begin_at_mark(&c, VBSS_DRAIN_MESH_137, BEFORE);
    assert_true(needle_case_drive(&c, 9e-3, SPEED, VBSS_SCENE_EVENT_PUNCTURE));
    scene_object *s = small_object(&c.d.s);
    const scene_body *needle = vbss_scene_body(s, c.body);
    const needle_object *n = needle->rigid.needle;
    const double first = vbss_needle_vertex_arc(n, 1), second = vbss_needle_vertex_arc(n, 2);
    scene_axis_interval piece = {.started = false};
    place_side_along(s, needle, 1, 0);
    s->holes[0].arc = first + 1e-3;
    expect_piece(s, 1, first, first + 0.5e-3, &piece);
    expect_piece(s, 1, first + 1.5e-3, second, &piece);
    expect_no_piece(s, 1, &piece);
    /* A second one overlaps the first, and reaches over the end. */
    s->holes[1] = s->holes[0];
    s->holes[1].arc = first + 0.2e-3;
    piece = (scene_axis_interval){.started = false};
    expect_piece(s, 1, first + 1.5e-3, second, &piece);
    expect_no_piece(s, 1, &piece);
    /* On its way in, the tip alone is at the mouth. */
    s->holes[1] = (suture_hole){0};
    s->holes[0].arc = s->holes[0].entry_arc = -2e-3;
    place_side_along(s, needle, 0, 0);
    piece = (scene_axis_interval){.started = false};
    expect_piece(s, 0, n->config.wire_radius, first, &piece);
    needle_case_end(&c);
}

/* Whichever place of the table the other hole has. */
static void arc_near_another_hole_is_in_it(void **state)
{
    (void)state;
    needle_case_begin_at_mark(&c, VBSS_DRAIN_MESH_137, BEFORE);
    assert_true(needle_case_drive(&c, 9e-3, SPEED, VBSS_SCENE_EVENT_PUNCTURE));
    scene_object *s = small_object(&c.d.s);
    s->holes[1] = s->holes[0];
    s->holes[1].arc = s->holes[0].arc + 6e-3;
    for (int k = 0; k < 2; k++) {
        const suture_hole *hole = &s->holes[k];
        assert_true(vbss_scene_is_in_other_hole(s, hole, s->holes[1 - k].arc + 1e-4));
        assert_false(vbss_scene_is_in_other_hole(s, hole, hole->arc));
        assert_false(vbss_scene_is_in_other_hole(s, hole, s->holes[1 - k].arc + 3e-3));
    }
    s->holes[1] = (suture_hole){0};
    needle_case_end(&c);
}

/* Forces that balance nothing pierce nothing: those of a search that its limit of work has stopped. */
static void stopped_search_pierces_nothing(void **state)
{
    (void)state;
    needle_case_begin_at_mark(&c, VBSS_DRAIN_MESH_137, BEFORE);
    scene_object *s = small_object(&c.d.s);
    drain_object *d = vbss_scene_body(s, c.d.body)->drain.drain;
    for (uint32_t i = 0; i < 1000 && c.at_tip < 0.5; i++) {
        needle_case_turn(&c, 10e-6);
        needle_case_step(&c);
    }
    assert_int_equal(c.counts[VBSS_SCENE_EVENT_PUNCTURE], 0);
    d->config.puncture_force = 0.25;
    s->contacts->is_stopped_early = true;
    vbss_scene_update_holes(s);
    assert_true(s->holes[0].id == 0);
    s->contacts->is_stopped_early = false;
    vbss_scene_update_holes(s);
    assert_true(s->holes[0].id != 0);
    needle_case_end(&c);
}

int test_puncture_exit(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(withdrawn_tip_leaves_and_reenters),
        cmocka_unit_test(needle_end_passes_through),
        cmocka_unit_test(tremor_makes_one_hole),
        cmocka_unit_test(tremor_at_entry_keeps_hole),
        cmocka_unit_test(tip_drawn_along_wall_slides),
        cmocka_unit_test(oblique_entry_makes_one_hole),
        cmocka_unit_test(hole_is_in_one_wall),
        cmocka_unit_test(needle_collides_before_and_behind_hole),
        cmocka_unit_test(arc_near_another_hole_is_in_it),
        cmocka_unit_test(stopped_search_pierces_nothing),
    };
    return cmocka_run_group_tests_name("scene.puncture_exit", tests, NULL, NULL);
}
