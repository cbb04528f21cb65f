/* What a hole bears, how it slides, when it is left; that it is saved. */
#include "fixture.h"

static suture_hole some_hole(void)
{
    return (suture_hole){.id = 7,
                         .needle = 2,
                         .drain = 1,
                         .triangle = 20,
                         .weights = {0.25, 0.5, 0.25},
                         .outward = true,
                         .entry = -0.9e-3,
                         .arc = -0.9e-3,
                         .deepest = -0.9e-3,
                         .held = -0.75,
                         .across = {0.1, -0.2, 0.2}};
}

/* ---- the bound */

static void what_it_bears_falls_over_the_tip_to_friction(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    vbss_drain_config c = f.d->config;
    suture_hole hole = some_hole();
    hole.across = vec3_zero();
    for (int i = 0; i <= 20; i++) {
        double gone = c.tip_length * i / 10.0;
        vbss_hole_move(&hole, hole.entry + gone);
        double share = fmax(0.0, 1.0 - gone / c.tip_length);
        double wanted = c.hole_force + share * (c.puncture_force - c.hole_force);
        expect_near(wanted, vbss_hole_bound(&hole, &c), 1e-12);
        /* What was cut stays cut. */
        vbss_hole_move(&hole, hole.entry);
        expect_near(wanted, vbss_hole_bound(&hole, &c), 1e-12);
    }
    hole.across = vec3_make(0.3, 0.4, 0.0);
    expect_near(c.hole_force + 0.5 * c.hole_friction, vbss_hole_bound(&hole, &c), 1e-12);
    hole = some_hole();
    hole.across = vec3_zero();
    c.tip_length = 0.0;
    expect_near(c.hole_force, vbss_hole_bound(&hole, &c), 1e-15);
    c.tip_length = 1e-3;
    c.hole_force = 3.0; /* more than it takes to enter */
    expect_near(3.0, vbss_hole_bound(&hole, &c), 1e-15);
    end(&f);
}

/* ---- rows */

static contact_row row_of(const fixture *f, const suture_hole *hole, uint32_t which,
                          const hole_lie *now, const hole_lie *before)
{
    contact_row row = {.key = {.a = 3 * 5 + which}, .bilateral = true};
    vbss_hole_lay_row(hole, &f->d->config, now, before, 1e-3, &row);
    return row;
}

static void rows_are_square_and_one_is_along(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    suture_hole hole = some_hole();
    hole_lie now = {.needle = {1e-5, 2e-5, 3e-5}, .tangent = {0.6, 0.0, 0.8}, .arc = 2e-3};
    hole_lie before = now;
    before.arc = 1.999e-3; /* the tip has gone on by 1 um */
    contact_row row[HOLE_ROWS];
    for (uint32_t k = 0; k < HOLE_ROWS; k++) {
        row[k] = row_of(&f, &hole, k, &now, &before);
        expect_near(1.0, vec3_norm(row[k].normal), 1e-12);
        for (uint32_t j = 0; j < k; j++) {
            expect_near(0.0, vec3_dot(row[j].normal, row[k].normal), 1e-12);
        }
    }
    double k = f.d->config.hole_stiffness;
    vec3 along = row[HOLE_ALONG].normal;
    expect_near(0.0, vec3_distance(along, now.tangent), 0.0);
    expect_near(f.d->config.hole_damping / 1e-3, row[HOLE_ALONG].beyond, 1e-9);
    expect_near(hole.held - k * 1e-6,
                vec3_dot(along, vbss_contact_force(&row[HOLE_ALONG], vec3_zero())), 1e-9);
    vec3 across = vec3_add(vbss_contact_force(&row[0], vec3_zero()),
                           vbss_contact_force(&row[1], vec3_zero()));
    vec3 aside = vec3_add_scaled(now.needle, -vec3_dot(now.needle, along), along);
    expect_near(0.0, vec3_distance(across, vec3_scale(aside, -k)), 1e-12);
    end(&f);
}

static void what_was_found_is_kept_up_to_the_bound(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    for (int sign = -1; sign <= 1; sign += 2) {
        suture_hole hole = some_hole();
        vbss_hole_move(&hole, 5e-3);
        hole_lie before = {.tangent = {0.0, 0.0, 1.0}, .arc = 5e-3}, now = before;
        now.needle = vec3_make(2e-5, 1e-5, 0.0);
        now.arc += sign * 1e-3;
        for (uint32_t k = 0; k < HOLE_ROWS; k++) {
            contact_row row = row_of(&f, &hole, k, &now, &before);
            vbss_hole_keep(&hole, &f.d->config, &row);
        }
        vec3 across = vec3_scale(now.needle, -f.d->config.hole_stiffness);
        expect_near(0.0, vec3_distance(across, hole.across), 1e-12);
        double bound = f.d->config.hole_force + f.d->config.hole_friction * vec3_norm(across);
        expect_near(-sign * bound, hole.held, 1e-12);
    }
    end(&f);
}

/* ---- leaving */

static void it_is_left_a_little_beyond_where_it_was_entered(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    suture_hole hole = some_hole();
    double length = vbss_needle_length(f.n);
    const struct {
        double arc;
        bool left;
    } cases[] = {{hole.entry, false},
                 {hole.entry - 0.199e-3, false},
                 {hole.entry - 0.201e-3, true},
                 {0.5 * length, false},
                 {length, false},
                 {length - hole.entry + 0.199e-3, false},
                 {length - hole.entry + 0.201e-3, true}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        vbss_hole_move(&hole, cases[i].arc);
        assert_int_equal(vbss_hole_is_left(&hole, f.n), cases[i].left);
    }
    end(&f);
}

/* ---- saving */

static void it_is_read_as_it_was_written(void **state)
{
    (void)state;
    uint8_t bytes[512];
    vbss_stream stream;
    suture_hole hole = some_hole(), back;
    memset(&back, 0xa5, sizeof back);
    back.outward = false;
    vbss_stream_begin_write(&stream, bytes, sizeof bytes);
    vbss_hole_serialise(&stream, 9, &hole);
    expect_ok(stream.result);
    size_t count = stream.position;
    vbss_stream_begin_read(&stream, bytes, count);
    vbss_hole_serialise(&stream, 9, &back);
    expect_ok(stream.result);
    assert_int_equal(stream.position, count);
    assert_int_equal(hole.id, back.id);
    assert_int_equal(hole.needle, back.needle);
    assert_int_equal(hole.drain, back.drain);
    assert_int_equal(hole.triangle, back.triangle);
    assert_int_equal(hole.outward, back.outward);
    assert_memory_equal(hole.weights, back.weights, sizeof hole.weights);
    expect_same_bits(hole.entry, back.entry);
    expect_same_bits(hole.arc, back.arc);
    expect_same_bits(hole.deepest, back.deepest);
    expect_same_bits(hole.held, back.held);
    assert_memory_equal(&hole.across, &back.across, sizeof hole.across);
}

static void what_no_hole_is_like_is_told(void **state)
{
    (void)state;
    suture_hole hole = some_hole();
    assert_true(vbss_hole_is_sound(&hole));
    for (int i = 0; i < 9; i++) {
        hole = some_hole();
        hole.weights[0] = i == 0 ? -0.25 : hole.weights[0];
        hole.weights[1] = i == 0 ? 1.0 : i == 1 ? 0.6 : hole.weights[1];
        hole.entry = i == 2 ? 1e-3 : i == 3 ? -2.0 : hole.entry;
        hole.deepest = i == 4 ? hole.entry - 1e-6 : i == 5 ? HUGE_VAL : hole.deepest;
        hole.arc = i == 6 ? (double)NAN : hole.arc;
        hole.held = i == 7 ? (double)NAN : hole.held;
        hole.across.y = i == 8 ? (double)NAN : hole.across.y;
        assert_false(vbss_hole_is_sound(&hole));
    }
}

int test_hole(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_it_bears_falls_over_the_tip_to_friction),
        cmocka_unit_test(rows_are_square_and_one_is_along),
        cmocka_unit_test(what_was_found_is_kept_up_to_the_bound),
        cmocka_unit_test(it_is_left_a_little_beyond_where_it_was_entered),
        cmocka_unit_test(it_is_read_as_it_was_written),
        cmocka_unit_test(what_no_hole_is_like_is_told),
    };
    return cmocka_run_group_tests_name("suture.hole", tests, NULL, NULL);
}
