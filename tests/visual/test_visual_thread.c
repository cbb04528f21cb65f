/* The tube of a thread: where it goes, how round it is, how it is turned. */
#include "base/elementary.h"
#include "base/rotation.h"
#include "fixture.h"
#include "thread/thread.h"

static thread_object *inside(const vbss_thread *thread)
{
    thread_object *t = NULL;
    expect_ok(vbss_thread_open(thread, &t));
    return t;
}

/* The middle of the ring that begins with this vertex, of so many sides. */
static vec3 middle_of(const drawn *d, uint32_t first, uint32_t sides)
{
    vec3 sum = vec3_zero();
    for (uint32_t i = 0; i < sides; i++) {
        sum = vec3_add(sum, position_of(d, first + i));
    }
    return vec3_scale(sum, 1.0 / (double)sides);
}

/* Rings have their first point twice: sides are counted up to there. */
static uint32_t sides_of(const drawn *d)
{
    uint32_t first = d->parts[0].first_vertex + 1, n = 1; /* behind the pole */
    while (vec3_distance(position_of(d, first), position_of(d, first + n)) > 0.0) {
        n++;
    }
    return n;
}

static void tube_is_closed_and_faces_outward(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    make(&f);
    vbss_thread *thread = helix(&f, 60, 5e-3, 2e-3, 1.25e-4);
    expect_ok(vbss_visual_add_thread(f.visual, thread, NULL));
    expect_ok(vbss_visual_add_thread(f.visual, helix(&f, 2, 5e-3, 2e-3, 1.25e-4), NULL));
    expect_ok(vbss_visual_add_thread(f.visual, helix(&f, 3, 1e-3, 0.0, 5e-4), NULL));
    const drawn d = draw(&f);
    assert_int_equal(d.part_count, 3);
    for (uint32_t i = 0; i < d.part_count; i++) {
        assert_int_equal(d.parts[i].kind, VBSS_VISUAL_KIND_THREAD);
        assert_int_equal(d.parts[i].source, i + 1);
        expect_sound(&d, &d.parts[i]);
    }
    /* That of a bent cylinder is that of a straight one; the polygon in the circle and chords take some. */
    double length = 59.0 * inside(thread)->rest[0], area = VBSS_PI * 1.25e-4 * 1.25e-4;
    expect_near(1.0, volume_of(&d, &d.parts[0]) / (length * area), 0.06);
    end(&f);
}

static void tube_passes_through_nodes(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config.division_limit = 1; /* a ring a node */
    make(&f);
    vbss_thread *thread = helix(&f, 40, 5e-3, 2e-3, 1.25e-4);
    expect_ok(vbss_visual_add_thread(f.visual, thread, NULL));
    const drawn d = draw(&f);
    const uint32_t sides = sides_of(&d), dome = 1 + ((sides + 3) / 4 - 1) * (sides + 1);
    assert_int_equal(d.vertex_count, 2 * dome + 40 * (sides + 1));
    for (uint32_t i = 0; i < 40; i++) {
        vec3 middle = middle_of(&d, dome + i * (sides + 1), sides);
        assert_true(vec3_distance(middle, inside(thread)->now.x[i]) < 2e-9); /* floats */
    }
    end(&f);
}

/* Of a point from the helix, by Newton's method from a good start. */
static double from_helix(vec3 p, double radius, double rise)
{
    double angle = p.y / rise * 2.0 * VBSS_PI, up = rise / (2.0 * VBSS_PI);
    for (int i = 0; i < 20; i++) {
        double c = vbss_cos(angle), s = vbss_sin(angle);
        double slope = radius * (p.x * s - p.z * c) - up * (p.y - up * angle);
        double second = radius * (p.x * c + p.z * s) + up * up;
        angle -= slope / second;
    }
    return vec3_distance(p,
                         vec3_make(radius * vbss_cos(angle), up * angle, radius * vbss_sin(angle)));
}

/* Chords between rings keep the tolerance, and no better than they need. */
static void line_tolerance_holds(void **state)
{
    (void)state;
    const double radius = 5e-3, rise = 2e-3;
    for (int halved = 0; halved < 8; halved++) {
        const double tolerance = 2e-4 / (double)(1 << halved);
        fixture f;
        begin(&f);
        f.config.tube_tolerance = tolerance;
        f.config.division_limit = 32;
        make(&f);
        expect_ok(vbss_visual_add_thread(f.visual, helix(&f, 61, radius, rise, 1.25e-4), NULL));
        const drawn d = draw(&f);
        const uint32_t sides = sides_of(&d), stride = sides + 1;
        uint32_t quarter = (sides + 3) / 4 < 2 ? 2 : (sides + 3) / 4;
        const uint32_t dome = 1 + (quarter - 1) * stride;
        const uint32_t rings = (d.vertex_count - 2 * dome) / stride;
        double worst = 0.0;
        for (uint32_t i = rings / 4; i < rings * 3 / 4; i++) { /* where its ends are not felt */
            vec3 a = middle_of(&d, dome + i * stride, sides);
            vec3 b = middle_of(&d, dome + (i + 1) * stride, sides);
            worst = vbss_max(worst, from_helix(vec3_lerp(a, b, 0.5), radius, rise));
        }
        /* The spline itself is off the helix by r angle^4 / 384. */
        assert_true(worst < tolerance + 1e-6);
        if (rings > 240) { /* finer than the nodes ask for */
            assert_true(worst > 0.2 * tolerance);
        }
        end(&f);
    }
}

static double twist_of(const drawn *d, uint32_t first, uint32_t stride)
{
    /* Between the first normals of two rings, about the line between them: what bending does not explain. */
    vec3 a = normal_of(d, first), b = normal_of(d, first + stride);
    vec3 tangent = vec3_unit_or(
        vec3_sub(middle_of(d, first + stride, stride - 1), middle_of(d, first, stride - 1)), a);
    a = vec3_unit_or(vec3_add_scaled(a, -vec3_dot(a, tangent), tangent), a);
    b = vec3_unit_or(vec3_add_scaled(b, -vec3_dot(b, tangent), tangent), b);
    return vbss_atan2(vec3_dot(vec3_cross(a, b), tangent), vec3_dot(a, b));
}

/* A frame that does not turn about a helix turns in its Frenet frame by the torsion, back (Bishop 1975). */
static void frames_are_twist_free(void **state)
{
    (void)state;
    fixture f;
    const double radius = 5e-3, rise = 8e-3, up = rise / (2.0 * VBSS_PI);
    begin(&f);
    make(&f);
    expect_ok(vbss_visual_add_thread(f.visual, helix(&f, 121, radius, rise, 1.25e-4), NULL));
    const drawn d = draw(&f);
    const uint32_t sides = sides_of(&d), stride = sides + 1;
    const uint32_t dome = 1 + ((sides + 3) / 4 - 1) * stride;
    const uint32_t rings = (d.vertex_count - 2 * dome) / stride;
    double before = 0.0, turned = 0.0, arc = 0.0;
    for (uint32_t i = 0; i < rings; i++) {
        uint32_t first = dome + i * stride;
        if (i + 1 < rings) {
            assert_true(fabs(twist_of(&d, first, stride)) < 0.02);
        }
        if (i < rings / 4 || i > rings * 3 / 4) {
            continue; /* at free ends the spline is not the helix */
        }
        vec3 p = middle_of(&d, first, sides), n = normal_of(&d, first);
        double along = material_of(&d, first).x;
        vec3 inward = vec3_unit_or(vec3_make(-p.x, 0.0, -p.z), n);
        vec3 tangent =
            vec3_unit_or(vec3_make(-radius * p.z / radius, up, radius * p.x / radius), n);
        double angle = vbss_atan2(vec3_dot(n, vec3_cross(tangent, inward)), vec3_dot(n, inward));
        if (i > rings / 4) {
            double step = angle - before;
            step -= 2.0 * VBSS_PI * floor(step / (2.0 * VBSS_PI) + 0.5);
            turned += step;
        } else {
            arc = along;
        }
        before = angle;
        if (i == rings * 3 / 4) {
            double torsion = -up / (radius * radius + up * up); /* left-handed about y */
            expect_near(1.0, turned / (-torsion * (along - arc)), 2e-3);
        }
    }
    end(&f);
}

/* Over one turn of a helix, in so many steps: how far the frame is turned from where it should be, rad. */
static double error_of_carrying(int steps)
{
    const double radius = 5e-3, up = 3e-3, speed = sqrt(radius * radius + up * up);
    const double turned = 2.0 * VBSS_PI * up / speed; /* torsion times length, the other way */
    vec3 before = vec3_zero(), along = vec3_zero(), normal = vec3_zero();
    double angle = 0.0;
    for (int i = 0; i <= steps; i++) {
        double sine, cosine;
        vbss_sincos(2.0 * VBSS_PI * i / steps, &sine, &cosine);
        vec3 at = vec3_make(radius * cosine, radius * sine, up * 2.0 * VBSS_PI * i / steps);
        vec3 tangent = vec3_scale(vec3_make(-radius * sine, radius * cosine, up), 1.0 / speed);
        vec3 inward = vec3_make(-cosine, -sine, 0.0);
        normal = i == 0 ? inward : vbss_visual_transport_normal(before, along, normal, at, tangent);
        angle = vbss_atan2(vec3_dot(normal, vec3_cross(tangent, inward)), vec3_dot(normal, inward));
        before = at;
        along = tangent;
    }
    double off = angle + turned;
    return fabs(off - 2.0 * VBSS_PI * floor(off / (2.0 * VBSS_PI) + 0.5));
}

static void frame_transport_is_fourth_order(void **state)
{
    (void)state;
    double coarse = error_of_carrying(16), fine = error_of_carrying(32);
    assert_true(coarse < 2e-3);
    assert_in_range((uint64_t)(coarse / fine + 0.5), 14, 18);
}

/* A thread that swings goes on with the frame it had, also where a frame made anew would jump. */
static void frames_are_continuous_in_time(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    make(&f);
    vbss_thread *thread = helix(&f, 30, 5e-3, 2e-3, 1.25e-4);
    thread_object *t = inside(thread);
    vec3 rest[30];
    memcpy(rest, t->now.x, sizeof rest);
    expect_ok(vbss_visual_add_thread(f.visual, thread, NULL));
    vec3 before[3] = {vec3_zero(), vec3_zero(), vec3_zero()};
    for (int i = 0; i < 400; i++) { /* twice round an axis that no coordinate is special for */
        double positions[90];
        quat turn = vbss_quat_from_rotation_vector(
            vec3_scale(vec3_make(0.6, 0.0, 0.8), (double)i * 4.0 * VBSS_PI / 400.0));
        for (int k = 0; k < 30; k++) {
            vec3_store(positions + 3 * (ptrdiff_t)k, quat_rotate(turn, rest[k]));
        }
        expect_ok(vbss_thread_set_state(thread, positions, NULL, 30));
        const drawn d = draw(&f);
        const uint32_t vertices[3] = {1, d.vertex_count / 2, d.vertex_count - 3};
        for (int k = 0; k < 3; k++) {
            vec3 n = normal_of(&d, vertices[k]);
            if (i > 0) { /* it turns by 0.0314 rad */
                assert_true(vec3_distance(n, before[k]) < 0.05);
            }
            before[k] = n;
        }
    }
    end(&f);
}

/* Short segments between long ones neither swing out nor fold the tube. */
static void short_segments_are_handled(void **state)
{
    (void)state;
    fixture f;
    vbss_thread_config c;
    vbss_thread *thread;
    double x[3 * 41], rest[40], angle = 0.0;
    begin(&f);
    make(&f);
    expect_ok(vbss_thread_config_init(&c, sizeof c));
    for (int i = 0; i < 41; i++) {
        vec3_store(x + 3 * (ptrdiff_t)i,
                   vec3_make(4e-3 * vbss_cos(angle), 4e-3 * vbss_sin(angle), 0.0));
        double length = i % 4 == 0 ? 2e-3 : i % 4 == 1 ? 2e-6 : 2e-4;
        angle += length / 4e-3;
        if (i < 40) {
            rest[i] = length;
        }
    }
    c.segment_count = 40;
    c.positions = x;
    c.rest_lengths = rest;
    expect_ok(vbss_thread_create(f.context, &c, &thread));
    expect_ok(vbss_visual_add_thread(f.visual, thread, NULL));
    const drawn d = draw(&f);
    assert_int_equal(open_sides(&d, &d.parts[0]), 0);
    assert_int_equal(inverted_triangles(&d, &d.parts[0]), 0);
    double length = 0.0;
    for (int i = 0; i < 40; i++) {
        length += rest[i];
    }
    for (uint32_t i = 0; i < d.vertex_count; i++) {
        vec3 p = position_of(&d, i);
        double off = sqrt(p.x * p.x + p.y * p.y) - 4e-3, along = material_of(&d, i).x;
        if (along > 5e-3 && along < length - 5e-3) { /* free ends are straight */
            assert_true(sqrt(off * off + p.z * p.z) < 1.25e-4 + 8e-6);
        }
    }
    end(&f);
}

static void vertices_carry_arc_length(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    make(&f);
    vbss_thread *thread = helix(&f, 20, 5e-3, 2e-3, 1.25e-4);
    const double length = 19.0 * inside(thread)->rest[0];
    inside(thread)->now.tension[7] = 3.0;
    expect_ok(vbss_visual_add_thread(f.visual, thread, NULL));
    const drawn d = draw(&f);
    double smallest = 1.0, largest = -1.0, pulled = 0.0;
    for (uint32_t i = 0; i < d.vertex_count; i++) {
        vec3 m = material_of(&d, i);
        smallest = vbss_min(smallest, m.x);
        largest = vbss_max(largest, m.x);
        expect_near(m.x, (double)d.vertices[i].texture[1], 1e-9);
        assert_true(sqrt(m.y * m.y + m.z * m.z) < 1.2501e-4);
        assert_true(d.vertices[i].texture[0] >= 0.0F && d.vertices[i].texture[0] <= 1.0F);
        pulled = vbss_max(pulled, (double)d.vertices[i].value);
    }
    expect_near(-1.25e-4, smallest, 1e-9);
    expect_near(length + 1.25e-4, largest, 1e-8);
    expect_near(1.5, pulled, 1e-6); /* at nodes the mean of both sides */
    end(&f);
}

int test_visual_thread(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(tube_is_closed_and_faces_outward),
        harness_test(tube_passes_through_nodes),
        harness_test(line_tolerance_holds),
        harness_test(frames_are_twist_free),
        harness_test(frame_transport_is_fourth_order),
        harness_test(frames_are_continuous_in_time),
        harness_test(short_segments_are_handled),
        harness_test(vertices_carry_arc_length),
    };
    return cmocka_run_group_tests_name("visual.visual_thread", tests, NULL, NULL);
}
