/* What a hole bears, what row it lays, what it keeps; that it is saved. */
#include "base/elementary.h"
#include "fixture.h"

static suture_hole some_hole(void)
{
    return (suture_hole){.id = 7,
                         .needle = 2,
                         .wall = 1,
                         .triangle = 20,
                         .barycentric = {0.25, 0.5, 0.25},
                         .is_outward = true,
                         .entry_arc = -0.9e-3,
                         .arc = -0.9e-3,
                         .max_arc = -0.9e-3,
                         .friction_force = -0.75,
                         .transverse_force = {0.1, -0.2, 0.2}};
}

/* ---- the bound */

static hole_yield_limit limit_at(const suture_hole *hole, const vbss_drain_config *c,
                                 const suture_curve *line)
{
    const suture_curve_point place = {.arc = hole->arc, .span = SUTURE_ON_NEEDLE};
    return vbss_hole_yield_limit(hole, c, line, &place);
}

/* Against a tip that advances the puncture force is left over; against one that is drawn back, friction alone. */
static void needle_is_held_by_what_its_tip_has_passed(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    vbss_drain_config c = f.d->config;
    const suture_curve line = {.needle = f.n, .needle_pose = pose_identity()};
    suture_hole hole = some_hole();
    for (int i = 0; i <= 20; i++) {
        double gone = c.tip_length * i / 10.0;
        hole.max_arc = hole.entry_arc + gone;
        double share = fmax(0.0, 1.0 - gone / c.tip_length);
        double forward = c.hole_force + share * (c.puncture_force - c.hole_force);
        for (int j = 0; j <= 4; j++) { /* drawn back, the force against advance stays */
            hole.arc = hole.entry_arc + 0.25 * j * gone;
            const double back = c.hole_force * fmin(1.0, 0.25 * j * gone / c.tip_length);
            const hole_yield_limit b = limit_at(&hole, &c, &line);
            expect_near(forward, b.force[0], 1e-12);
            expect_near(back, b.force[1], 1e-12);
            expect_near(c.hole_friction, b.friction[0], 0.0);
            expect_near(c.hole_friction, b.friction[1], 0.0);
        }
    }
    hole = some_hole();
    hole.arc -= 0.1e-3; /* farther out than it entered */
    expect_near(0.0, limit_at(&hole, &c, &line).force[1], 0.0);
    hole = some_hole();
    c.tip_length = 0.0;
    for (int k = 0; k < 2; k++) {
        expect_near(c.hole_force, limit_at(&hole, &c, &line).force[k], 1e-15);
    }
    c.tip_length = 1e-3;
    c.hole_force = 3.0; /* more than it takes to enter */
    expect_near(3.0, limit_at(&hole, &c, &line).force[0], 1e-15);
    end(&f);
}

/* Straight on behind the needle, then at a right angle: a bend at node 12. */
enum { NODES = 24 };
typedef struct tail {
    vec3 x[NODES];
    double rest[NODES - 1];
    thread_object thread;
    suture_curve line;
} tail;

static void begin_tail(tail *t, const needle_object *n)
{
    const double length = 0.25e-3, swage = vbss_needle_length(n);
    const vec3 on = vec3_neg(vbss_needle_direction(n, swage));
    *t = (tail){.thread = {.node_count = NODES}};
    t->x[0] = vbss_needle_point(n, swage);
    for (int i = 1; i < NODES; i++) {
        t->rest[i - 1] = length;
        t->x[i] = vec3_add_scaled(t->x[i - 1], length, i <= 12 ? on : vec3_make(0.0, 0.0, 1.0));
    }
    t->thread.rest = t->rest;
    t->line = (suture_curve){.needle = n,
                             .needle_pose = pose_identity(),
                             .thread = &t->thread,
                             .node_positions = t->x,
                             .swage_arc = swage};
}

/* Over the length of a tip from the needle's bound to the thread's. */
static void friction_behind_swage_is_of_thread(void **state)
{
    (void)state;
    fixture f;
    tail t;
    begin(&f);
    begin_tail(&t, f.n);
    const vbss_drain_config c = f.d->config;
    suture_hole hole = some_hole();
    hole.arc = hole.max_arc = t.line.swage_arc;
    for (int i = -4; i <= 40; i++) {
        double behind = 0.05 * i * c.tip_length,
               share = fmin(fmax(behind / c.tip_length, 0.0), 1.0);
        vec3 at = vec3_add_scaled(
            t.x[0], -behind, vbss_needle_direction(f.n, t.line.swage_arc)); /* straight so far */
        suture_curve_point place =
            vbss_suture_nearest_point(&t.line, t.line.swage_arc + behind, at);
        place.arc = t.line.swage_arc + behind;
        const hole_yield_limit b = vbss_hole_yield_limit(&hole, &c, &t.line, &place);
        for (int k = 0; k < 2; k++) {
            expect_near(c.hole_force + share * (c.thread_force - c.hole_force), b.force[k], 1e-12);
            expect_near(c.hole_friction, b.friction[k], 1e-6);
        }
    }
    /* A tip of no length: one or the other. */
    vbss_drain_config blunt = c;
    blunt.tip_length = 0.0;
    for (int i = -1; i <= 1; i++) {
        suture_curve_point place = vbss_suture_nearest_point(&t.line, t.line.swage_arc, t.x[0]);
        place.arc = t.line.swage_arc + 1e-9 * i;
        const hole_yield_limit b = vbss_hole_yield_limit(&hole, &blunt, &t.line, &place);
        expect_near(i > 0 ? c.thread_force : c.hole_force, b.force[0], 1e-15);
        expect_near(b.force[0], b.force[1], 0.0);
        expect_near(c.hole_friction, b.friction[0], 0.0);
    }
    /* In the bend, and without a needle: that of a rope round a post. */
    const suture_curve_point bend =
        vbss_suture_nearest_point(&t.line, t.line.swage_arc + 3e-3, t.x[12]);
    suture_curve alone = t.line;
    alone.needle = NULL;
    for (int i = 0; i < 2; i++) {
        double grip[2];
        const hole_yield_limit b =
            vbss_hole_yield_limit(&hole, &c, i == 0 ? &t.line : &alone, &bend);
        vbss_suture_capstan_friction(&t.line, &bend, c.hole_friction, grip);
        assert_true(grip[0] < 0.9 * c.hole_friction);
        expect_near(c.thread_force, b.force[0], 1e-15);
        expect_near(c.thread_force, b.force[1], 1e-15);
        expect_near(grip[0], b.friction[0], 1e-15);
        expect_near(grip[1], b.friction[1], 1e-15);
    }
    end(&f);
}

/* ---- its row */

static suture_curve_point some_place(void)
{
    return (suture_curve_point){.arc = 2e-3,
                                .position = {1.3e-3, 2e-3, 3e-3},
                                .tangent = {0.6, 0.0, 0.8},
                                .curvature = {80.0, 10.0, -60.0}};
}

/* A thread that leaves the needle's end askew, or back along it, is no rope there: over two segments it grips as the needle does,
 * and then goes over to the rope's without a jump. */
static void bend_at_swage_grips_as_needle(void **state)
{
    (void)state;
    fixture f;
    tail t;
    begin(&f);
    double largest = 0.0;
    for (int askew = 1; askew <= 5; askew++) {
        double sine, cosine;
        begin_tail(&t, f.n);
        vbss_sincos(0.5 * askew, &sine, &cosine); /* up to 143 degrees */
        const vec3 on = vec3_neg(vbss_needle_direction(f.n, t.line.swage_arc));
        for (int i = 1; i < NODES; i++) {
            vec3 direction =
                vec3_add_scaled(vec3_scale(on, cosine), sine, vec3_make(0.0, 0.0, 1.0));
            t.x[i] = vec3_add_scaled(t.x[i - 1], t.rest[i - 1], direction);
        }
        const vbss_drain_config c = f.d->config;
        const suture_hole hole = some_hole();
        const double bent = 2.0 * t.rest[0];
        for (int i = 1; i <= 60; i++) {
            const double behind = 0.05 * i * c.tip_length;
            const uint32_t k = (uint32_t)(behind / t.rest[0]);
            vec3 at = vec3_lerp(t.x[k], t.x[k + 1], behind / t.rest[0] - k);
            const suture_curve_point place =
                vbss_suture_nearest_point(&t.line, t.line.swage_arc + behind, at);
            if (place.span == SUTURE_ON_NEEDLE) {
                continue; /* bent back beside it */
            }
            const hole_yield_limit b = vbss_hole_yield_limit(&hole, &c, &t.line, &place);
            const double far = (place.arc - t.line.swage_arc - bent) / c.tip_length;
            const double share = fmin(fmax(far, 0.0), 1.0);
            double grip[2];
            vbss_suture_capstan_friction(&t.line, &place, c.hole_friction, grip);
            for (int side = 0; side < 2; side++) {
                double wanted = c.hole_friction + share * (grip[side] - c.hole_friction);
                expect_near(wanted, b.friction[side], 1e-12);
                largest = fmax(largest, fabs(grip[side] - b.friction[side]));
            }
        }
    }
    assert_true(largest > 1.0); /* what a rope would grip with there */
    end(&f);
}

static void hole_constraint_is_stiff_across_and_frictional_along(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    const suture_hole hole = some_hole();
    const suture_curve_point now = some_place();
    const vec3 off = vec3_make(0.8e-5, 2e-5, -0.6e-5); /* across */
    contact_constraint row = {.is_bilateral = true,
                              .is_sleeve = true,
                              .yield_force = {1e3, 1e3},
                              .gap = 5.0,
                              .friction = 5.0}; /* the coefficient is for contacts only */
    const double from = now.arc - 1e-6;         /* the tip has gone on by 1 um */
    vbss_hole_set_constraint(&hole, &f.d->config, from, &now, vec3_sub(now.position, off), 2e-3,
                             &row);
    double k = f.d->config.hole_stiffness;
    expect_near(0.0, vec3_distance(row.normal, now.tangent), 0.0);
    expect_near(0.0, vec3_distance(row.curvature, now.curvature), 0.0);
    expect_near(0.0, row.gap, 0.0);
    expect_near(k, row.stiffness, 0.0);
    expect_near(f.d->config.hole_damping / 2e-3, row.viscous_stiffness, 1e-9);
    const vec3 force = vbss_contact_force(&row, vec3_zero());
    expect_near(hole.friction_force - k * 1e-6, vec3_dot(row.normal, force), 1e-9);
    expect_near(0.0,
                vec3_distance(vec3_add_scaled(force, -vec3_dot(force, row.normal), row.normal),
                              vec3_scale(off, -k)),
                1e-9);
    end(&f);
}

/* All of it, what yields too: nothing is cut off. */
static void solution_is_stored_unclipped(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    for (int sign = -1; sign <= 1; sign += 2) {
        suture_hole hole = some_hole();
        const suture_curve_point now = some_place();
        const vec3 off = vec3_make(0.8e-5, 2e-5, -0.6e-5);
        contact_constraint row = {.is_bilateral = true,
                                  .is_sleeve = true,
                                  .yield_force = {0.1, 0.1},
                                  .yield_friction = {0.2, 0.5}};
        vbss_hole_set_constraint(&hole, &f.d->config, now.arc - sign * 1e-3, &now,
                                 vec3_sub(now.position, off), 1e-3, &row);
        vbss_hole_store_forces(&hole, &row);
        double k = row.stiffness, largest = 0.1 + (sign > 0 ? 0.2 : 0.5) * k * vec3_norm(off);
        double trial = fabs(-0.75 - sign * k * 1e-3);
        double wanted =
            largest + row.viscous_stiffness * (trial - largest) / (k + row.viscous_stiffness);
        assert_true(wanted > largest + 0.01);
        expect_near(-sign * wanted, hole.friction_force, 1e-9);
        expect_near(0.0, vec3_distance(hole.transverse_force, vec3_scale(off, -k)), 1e-9);
    }
    end(&f);
}

/* ---- saving */

static vbss_result visit(vbss_stream *stream, uint16_t version, suture_hole *hole)
{
    vbss_section outer = vbss_stream_open(stream, 0x74736574, version);
    stream->version = stream->mode == VBSS_STREAM_READ ? stream->version : version;
    vbss_hole_serialise(stream, 9, hole);
    vbss_stream_close(stream, outer);
    return stream->result;
}

/* Version 4 knows no threads: what is read into forgets its own. */
static void snapshot_round_trip(void **state)
{
    (void)state;
    size_t sizes[2];
    for (int i = 0; i < 3; i++) {
        uint8_t bytes[512];
        vbss_stream stream;
        suture_hole hole = some_hole(), back;
        const uint16_t version = i == 0 ? 4 : 5;
        hole.needle = i == 2 ? 0 : 2;
        hole.thread = i == 2 ? 3 : 0;
        memset(&back, 0xa5, sizeof back);
        back.is_outward = false;
        vbss_stream_begin_write(&stream, bytes, sizeof bytes);
        expect_ok(visit(&stream, version, &hole));
        size_t count = stream.position;
        sizes[version - 4] = count;
        vbss_stream_begin_read(&stream, bytes, count);
        expect_ok(visit(&stream, 5, &back));
        assert_int_equal(stream.position, count);
        assert_int_equal(hole.id, back.id);
        assert_int_equal(hole.needle, back.needle);
        assert_int_equal(hole.thread, back.thread);
        assert_int_equal(hole.wall, back.wall);
        assert_int_equal(hole.triangle, back.triangle);
        assert_int_equal(hole.is_outward, back.is_outward);
        assert_memory_equal(hole.barycentric, back.barycentric, sizeof hole.barycentric);
        expect_same_bits(hole.entry_arc, back.entry_arc);
        expect_same_bits(hole.arc, back.arc);
        expect_same_bits(hole.max_arc, back.max_arc);
        expect_same_bits(hole.friction_force, back.friction_force);
        assert_memory_equal(&hole.transverse_force, &back.transverse_force,
                            sizeof hole.transverse_force);
        assert_true(vbss_hole_is_valid(&back));
    }
    assert_int_equal(sizes[1], sizes[0] + sizeof(uint32_t));
}

static void invalid_holes_are_rejected(void **state)
{
    (void)state;
    suture_hole hole = some_hole();
    assert_true(vbss_hole_is_valid(&hole));
    hole.needle = 0;
    hole.thread = 3;
    assert_true(vbss_hole_is_valid(&hole));
    for (int i = 0; i < 11; i++) {
        hole = some_hole();
        hole.barycentric[0] = i == 0 ? -0.25 : hole.barycentric[0];
        hole.barycentric[1] = i == 0 ? 1.0 : i == 1 ? 0.6 : hole.barycentric[1];
        hole.entry_arc = i == 2 ? 1e-3 : i == 3 ? -2.0 : hole.entry_arc;
        hole.max_arc = i == 4 ? hole.entry_arc - 1e-6 : i == 5 ? HUGE_VAL : hole.max_arc;
        hole.arc = i == 6 ? (double)NAN : hole.arc;
        hole.friction_force = i == 7 ? (double)NAN : hole.friction_force;
        hole.transverse_force.y = i == 8 ? (double)NAN : hole.transverse_force.y;
        hole.needle = i == 9 ? 0 : hole.needle;  /* nothing in it */
        hole.thread = i == 10 ? 3 : hole.thread; /* both */
        assert_false(vbss_hole_is_valid(&hole));
    }
}

int test_hole(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(needle_is_held_by_what_its_tip_has_passed),
        cmocka_unit_test(friction_behind_swage_is_of_thread),
        cmocka_unit_test(bend_at_swage_grips_as_needle),
        cmocka_unit_test(hole_constraint_is_stiff_across_and_frictional_along),
        cmocka_unit_test(solution_is_stored_unclipped),
        cmocka_unit_test(snapshot_round_trip),
        cmocka_unit_test(invalid_holes_are_rejected),
    };
    return cmocka_run_group_tests_name("suture.hole", tests, NULL, NULL);
}
