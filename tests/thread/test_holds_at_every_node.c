/* Holds and springs wherever they can stand: next to each other, at every distance, on all nodes. */
#include "fixture.h"
#include "reference.h"

/* Nodes on a circle, arcs of the rest length apart. */
static vbss_thread *make_arc(fixture *f, vbss_thread_bending bending, uint32_t segments,
                             double radius)
{
    double x[3 * 65];
    assert_true(segments <= 64);
    begin(f);
    f->config.bending = bending;
    f->config.segment_count = segments;
    f->config.length = 1e-3 * segments;
    f->config.gravity[1] = 0.0;
    f->config.attachment_capacity = 256;
    for (uint32_t i = 0; i <= segments; i++) {
        vec3_store(x + 3 * (size_t)i, on_circle(1.0 / radius, 1e-3 * i));
    }
    f->config.positions = x;
    vbss_thread *thread = make(f);
    f->config.positions = NULL;
    return thread;
}

static uint32_t clamp_on_arc(vbss_thread *thread, double radius, uint32_t node)
{
    vbss_thread_attachment a = plain(VBSS_THREAD_ATTACHMENT_CLAMP, node);
    vec3_store(a.position, on_circle(1.0 / radius, 1e-3 * node));
    vec3_store(a.direction, along_circle(1.0 / radius, 1e-3 * node));
    return attach(thread, &a);
}

/* Stretches between clamps of a circle have the circle's energy, however short they are and wherever
 * they stand; the clamps' torques hold each other. */
static void clamped_arc_energy_at_every_length(void **state)
{
    (void)state;
    const double radius = 0.02, one = 0.5 * 1e-8 / (radius * radius) * 1e-3; /* of a segment */
    for (int bending = 0; bending < 2; bending++) {
        for (uint32_t before = 0; before <= 8; before += before < 2 ? 1 : 3) {
            for (uint32_t length = 1; length <= 9; length++) {
                for (uint32_t behind = 0; behind <= 4; behind += behind < 1 ? 1 : 3) {
                    fixture f;
                    uint32_t segments = before + length + behind;
                    vbss_thread *thread = make_arc(&f, bending, segments, radius);
                    clamp_on_arc(thread, radius, before);
                    clamp_on_arc(thread, radius, before + length);
                    if (before > 0) {
                        clamp_on_arc(thread, radius, 0);
                    }
                    if (behind > 0) {
                        clamp_on_arc(thread, radius, segments);
                    }
                    expect_near(one * segments, energies_of(thread).bending, 1e-3 * one * segments);
                    steps(thread, 3, 1e-3);
                    assert_true(all_finite(thread));
                    end(&f);
                }
            }
        }
    }
}

/* The same stretches in a thread that hangs free on both sides, tugged about. */
static void clamps_at_any_spacing_in_moving_thread(void **state)
{
    (void)state;
    for (int bending = 0; bending < 2; bending++) {
        for (uint32_t first = 0; first <= 12; first += 4) {
            for (uint32_t distance = 1; distance <= 8; distance++) {
                fixture f;
                vbss_thread *thread = make_arc(&f, bending, 24, 0.1);
                uint32_t low = clamp_on_arc(thread, 0.1, first);
                uint32_t high = clamp_on_arc(thread, 0.1, first + distance);
                for (uint32_t i = 0; i < 40; i++) {
                    double direction[3] = {1.0, 0.02 * i, 0.01 * i}, target[3];
                    vec3_store(target, vec3_add(on_circle(10.0, 1e-3 * first),
                                                vec3_make(0.0, 0.0, 5e-5 * i)));
                    expect_ok(vbss_thread_set_attachment_target(thread, low, target, direction));
                    expect_ok(vbss_thread_step(thread, 1e-3));
                }
                assert_true(all_finite(thread));
                assert_true(statistics_of(thread).stretch_error <= 5e-6);
                expect_ok(vbss_thread_detach(thread, high));
                expect_ok(vbss_thread_detach(thread, low));
                double whole = energies_of(thread).total;
                steps(thread, 40, 1e-3);
                assert_true(energies_of(thread).total <= whole * (1.0 + 1e-9));
                end(&f);
            }
        }
    }
}

static void every_node_takes_spring_pin_or_clamp(void **state)
{
    (void)state;
    for (int bending = 0; bending < 2; bending++) {
        for (int kind = VBSS_THREAD_ATTACHMENT_PIN; kind <= VBSS_THREAD_ATTACHMENT_MASS; kind++) {
            for (uint32_t segments = 1; segments <= 64; segments = 2 * segments + segments / 8) {
                fixture f;
                vbss_thread *thread = make_arc(&f, bending, segments, 0.1);
                for (uint32_t i = 0; i <= segments; i++) {
                    vbss_thread_attachment a = plain(kind, i);
                    vec3_store(a.position, on_circle(10.0, 1e-3 * i));
                    vec3_store(a.direction, along_circle(10.0, 1e-3 * i));
                    a.stiffness = 100.0;
                    a.damping = 1e-3;
                    a.mass = 1e-4;
                    attach(thread, &a);
                }
                steps(thread, 10, 1e-3);
                for (uint32_t i = 0; i <= segments; i++) {
                    if (kind != VBSS_THREAD_ATTACHMENT_MASS &&
                        kind != VBSS_THREAD_ATTACHMENT_FORCE) {
                        expect_near_vec3(on_circle(10.0, 1e-3 * i), place_of(thread, i), 1e-5);
                    }
                    (void)reaction_of(thread, i + 1);
                }
                assert_true(all_finite(thread));
                for (uint32_t i = 0; i <= segments; i++) { /* from the middle outward */
                    uint32_t k = (segments + 1) / 2;
                    uint32_t node = i % 2 == 0 ? k + i / 2 : k - (i + 1) / 2;
                    node = node > segments ? 0 : node;
                    (void)vbss_thread_detach(thread, node + 1);
                    expect_ok(vbss_thread_step(thread, 1e-3));
                }
                assert_true(all_finite(thread));
                end(&f);
            }
        }
    }
}

/* 256 springs, the most there can be, on different nodes. */
static void maximum_spring_count(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config.segment_count = 300;
    f.config.attachment_capacity = 256;
    vbss_thread *thread = make(&f);
    for (uint32_t i = 0; i < 256; i++) {
        vbss_thread_attachment a = plain(VBSS_THREAD_ATTACHMENT_SPRING, 7 * i % 301);
        vec3_store(a.position, place_of(thread, a.node));
        a.stiffness = 1e3;
        attach(thread, &a);
    }
    steps(thread, 3, 1e-3);
    assert_true(all_finite(thread));
    assert_true(statistics_of(thread).stretch_error <= 5e-6);
    end(&f);
}

/* A clamp where springs, a mass and a force are, and the other way round: the same thread. */
static void attachment_order_does_not_matter(void **state)
{
    (void)state;
    vec3 found[2][25];
    for (int order = 0; order < 2; order++) {
        fixture f;
        vbss_thread *thread = make_arc(&f, VBSS_THREAD_BENDING_SPLINE, 24, 0.1);
        for (int k = 0; k < 5; k++) {
            int kind = order == 0 ? k : 4 - k;
            vbss_thread_attachment a = plain(kind, 11);
            if (kind == VBSS_THREAD_ATTACHMENT_PIN) {
                continue; /* one hold only */
            }
            a.stiffness = 50.0;
            a.mass = 1e-4;
            a.force[2] = 1e-3;
            vec3_store(a.position, on_circle(10.0, 0.012));
            vec3_store(a.direction, along_circle(10.0, 0.015));
            attach(thread, &a);
        }
        steps(thread, 30, 1e-3);
        for (uint32_t i = 0; i < 25; i++) {
            found[order][i] = place_of(thread, i);
        }
        end(&f);
    }
    for (uint32_t i = 0; i < 25; i++) {
        expect_near_vec3(found[0][i], found[1][i], 1e-12);
    }
}

/* A zigzag clamped at one end, and the same described from its other end. */
static double zigzag_energy(uint32_t segments, bool from_far, int clamps)
{
    fixture f;
    double x[3 * 10];
    begin(&f);
    for (uint32_t i = 0; i <= segments; i++) {
        uint32_t k = from_far ? segments - i : i;
        vec3_store(x + 3 * (size_t)i,
                   vec3_make(0.9e-3 * k, k % 2 == 0 ? 0.0 : 0.2e-3, 1e-5 * k * k));
    }
    f.config.segment_count = segments;
    f.config.length = 1e-3 * segments;
    f.config.positions = x;
    vbss_thread *thread = make(&f);
    for (int c = 0; c < clamps; c++) {
        uint32_t near = c == 0 ? 0 : segments, node = from_far ? segments - near : near;
        vbss_thread_attachment a = plain(VBSS_THREAD_ATTACHMENT_CLAMP, node);
        vec3_store(a.position, place_of(thread, node));
        vec3 direction = c == 0 ? vec3_make(1.0, 0.3, 0.1) : vec3_make(1.0, -0.2, 0.4);
        vec3_store(a.direction, from_far ? vec3_neg(direction) : direction);
        attach(thread, &a);
    }
    double bending = energies_of(thread).bending;
    end(&f);
    return bending;
}

static void ends_are_equivalent(void **state)
{
    (void)state;
    for (int clamps = 1; clamps <= 2; clamps++) {
        for (uint32_t segments = 1; segments <= 9; segments++) {
            double near = zigzag_energy(segments, false, clamps);
            expect_near(near, zigzag_energy(segments, true, clamps), 1e-9 * near);
        }
    }
}

int test_holds_at_every_node(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ends_are_equivalent),
        cmocka_unit_test(clamped_arc_energy_at_every_length),
        cmocka_unit_test(clamps_at_any_spacing_in_moving_thread),
        cmocka_unit_test(every_node_takes_spring_pin_or_clamp),
        cmocka_unit_test(maximum_spring_count),
        cmocka_unit_test(attachment_order_does_not_matter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
