/* Cases that break threads: too much, at once, of nothing. Each ends with lengths kept to 5e-6 of
 * EA's own stretch, all numbers finite, and no more energy than was put in. */
#include "fixture.h"

enum { LONGEST = 240 };

/* Linearisations of the worst step since the thread was made: what a frame may have to wait for. */
static uint32_t worst;

static void step(vbss_thread *thread, double h)
{
    expect_ok(vbss_thread_step(thread, h));
    uint32_t made = statistics_of(thread).last_iterations;
    worst = made > worst ? made : worst;
}

static void run(vbss_thread *thread, uint32_t count, double h)
{
    for (uint32_t i = 0; i < count; i++) {
        step(thread, h);
    }
}

/* Says what was measured, and asserts what every case has to keep: `most` linearisations in a step,
 * twice what was measured. */
static void expect_kept(const char *name, vbss_thread *thread, uint32_t limit)
{
    vbss_thread_statistics s = statistics_of(thread);
    print_message("%s: stretch error %.2g, forced %llu, rejected %llu, substeps %llu, steps %llu, "
                  "iterations a substep %.2f, at most %u a step\n",
                  name, s.stretch_error, (unsigned long long)s.forced,
                  (unsigned long long)s.rejections, (unsigned long long)s.substeps,
                  (unsigned long long)s.steps, (double)s.iterations / (double)s.substeps, worst);
    assert_true(all_finite(thread));
    assert_true(s.stretch_error <= 5e-6);
    assert_int_equal(s.forced, 0);
    assert_in_range(worst, 1, limit);
}

/* Nothing moves what holds the thread: there is never much more energy than at first, and not more at
 * last. Not less in each step: high frequencies are damped, not balanced. */
static void expect_at_rest(vbss_thread *thread, uint32_t count, double h)
{
    vbss_thread_energies e = energies_of(thread);
    double moving = e.kinetic + e.stretching + e.bending;
    double lifted = 1e-3 * momentum_of(thread).mass * 9.81 * rest_length_of(thread);
    for (uint32_t i = 0; i < count; i++) {
        step(thread, h);
        double now = energies_of(thread).total;
        if (!(now <= e.total + 0.5 * moving + lifted)) {
            fail_msg("step %u: energy grew from %g to %g J", i, e.total, now);
        }
    }
    assert_true(energies_of(thread).total <= e.total + 0.01 * moving + lifted);
}

static vbss_thread *make_of(fixture *f, vbss_thread_bending bending, uint32_t segments)
{
    begin(f);
    worst = 0;
    f->config.bending = bending;
    f->config.segment_count = segments;
    return make(f);
}

static void both_ends_clamped_and_pulled(void **state)
{
    (void)state;
    for (int bending = 0; bending < 2; bending++) {
        for (uint32_t segments = 30; segments <= LONGEST; segments *= 2) {
            fixture f;
            vbss_thread *thread = make_of(&f, bending, segments);
            double stretched = 0.15 * (1.0 + 20.0 / 427.0);
            hold(thread, VBSS_THREAD_ATTACHMENT_CLAMP, 0, vec3_zero());
            uint32_t far_end =
                hold(thread, VBSS_THREAD_ATTACHMENT_CLAMP, segments, vec3_make(0.15, 0.0, 0.0));
            run(thread, 10, 1e-3);
            move(thread, far_end, vec3_make(stretched, 0.0, 0.0));
            run(thread, 1, 1e-3);
            expect_at_rest(thread, 200, 1e-3);
            for (uint32_t i = 0; i < segments; i++) {
                expect_near(20.0, number_at(thread, VBSS_THREAD_VIEW_TENSIONS, i), 0.2);
            }
            expect_near(20.0, reaction_of(thread, far_end).force[0], 0.05);
            move(thread, far_end, vec3_make(0.15, 0.0, 0.0)); /* and let go as fast */
            run(thread, 1, 1e-3);
            expect_at_rest(thread, 100, 1e-3);
            expect_kept("pulled to 20 N and back", thread, 110);
            end(&f);
        }
    }
}

static void teleported_end(void **state)
{
    (void)state;
    const vec3 displacements[] = {
        {0.0, 0.02, 0.0}, {-0.02, 0.0, 0.0}, {0.0, -0.02, 0.0}, {0.0, 0.0, 0.02}};
    for (int bending = 0; bending < 2; bending++) {
        for (int hanging = 0; hanging < 2; hanging++) {
            for (int k = 0; k < 4; k++) {
                fixture f;
                vbss_thread *thread = make_of(&f, bending, 60);
                uint32_t hand = hold(thread, k % 2, 0, vec3_zero());
                if (hanging == 0) {
                    hold(thread, VBSS_THREAD_ATTACHMENT_PIN, 60, vec3_make(0.14, 0.0, 0.0));
                }
                run(thread, 200, 1e-3);
                move(thread, hand, displacements[k]);
                run(thread, 1, 1e-3);
                expect_at_rest(thread, 200, 1e-3);
                expect_kept("teleported by 20 mm", thread, 420);
                end(&f);
            }
        }
    }
}

static void stiff_and_fine_thread(void **state)
{
    (void)state;
    for (int stiff = 0; stiff < 2; stiff++) {
        for (int bending = 0; bending < 2; bending++) {
            fixture f;
            begin(&f);
            worst = 0;
            f.config.bending = bending;
            f.config.segment_count = LONGEST;
            f.config.axial_stiffness = stiff == 0 ? 427.0 : 4000.0;
            vbss_thread *thread = make(&f);
            hold(thread, VBSS_THREAD_ATTACHMENT_CLAMP, 0, vec3_zero());
            expect_at_rest(thread, 200, 1e-3);
            expect_kept(stiff == 0 ? "N = 240, EA = 427 N" : "N = 240, EA = 4000 N", thread, 6);
            end(&f);
        }
    }
}

static void heavy_end(void **state)
{
    (void)state;
    for (int bending = 0; bending < 2; bending++) {
        fixture f;
        vbss_thread *thread = make_of(&f, bending, 60);
        vbss_thread_attachment a = plain(VBSS_THREAD_ATTACHMENT_MASS, 60);
        a.mass = 1000.0 * 6.4e-5 * 0.15 / 60;
        attach(thread, &a);
        hold(thread, VBSS_THREAD_ATTACHMENT_CLAMP, 0, vec3_zero());
        expect_at_rest(thread, 1000, 1e-3);
        expect_kept("a mass of 1000 segments", thread, 10);
        end(&f);
    }
}

/* ---- starts that are no thread's shape */

typedef vec3 (*shape)(uint32_t i, uint32_t segments, double l);

static vec3 folded(uint32_t i, uint32_t segments, double l)
{
    return vec3_make(i <= segments / 2 ? l * i : l * (segments - i), 0.0, 0.0);
}

static vec3 zigzag(uint32_t i, uint32_t segments, double l)
{
    (void)segments;
    return vec3_make(i % 2 == 0 ? 0.0 : l, 0.0, 0.0);
}

static vec3 one_point(uint32_t i, uint32_t segments, double l)
{
    (void)i;
    (void)segments;
    (void)l;
    return vec3_zero();
}

static vec3 far_apart(uint32_t i, uint32_t segments, double l)
{
    (void)segments;
    return vec3_make(2.0 * l * i, 0.0, i % 3 == 0 ? l : 0.0);
}

static void any_start_comes_to_rest(void **state)
{
    (void)state;
    static const shape shapes[] = {folded, zigzag, one_point, far_apart};
    static const char *const names[] = {"folded", "a zigzag of folds", "all in one point",
                                        "stretched to twice"};
    for (int bending = 0; bending < 2; bending++) {
        for (int which = 0; which < 4; which++) {
            fixture f;
            vec3 x[61];
            begin(&f);
            worst = 0;
            f.config.bending = bending;
            f.config.segment_count = 60;
            f.config.drag = 5.0;
            f.config.damping = 50.0;
            for (uint32_t i = 0; i <= 60; i++) {
                x[i] = shapes[which](i, 60, 0.0025);
            }
            f.config.positions = &x[0].x;
            vbss_thread *thread = make(&f);
            hold(thread, VBSS_THREAD_ATTACHMENT_PIN, 0, vec3_zero());
            run(thread, 3, 1e-3); /* half a joule to 30 J go off at once */
            expect_at_rest(thread, 300, 1e-3);
            vbss_thread_statistics s = statistics_of(thread);
            print_message(
                "%s: forced %llu of %llu substeps, error %.2g, at last %.2g; at most %u a step\n",
                names[which], (unsigned long long)s.forced, (unsigned long long)s.substeps,
                s.stretch_error, s.last_stretch_error, worst);
            assert_true(all_finite(thread));
            assert_true(s.last_stretch_error <= 5e-6);
            /* Metres a millisecond: the first step may not converge at its last halving. */
            assert_true(s.forced <= (which >= 2 ? 1 : 0));
            assert_in_range(worst, 1, 730);
            end(&f);
        }
    }
}

/* ---- hands that do anything, in steps of any size */

static void tug(uint32_t segments, vbss_thread_bending bending, double h, uint32_t count,
                double speed)
{
    fixture f;
    vbss_random random;
    vbss_random_seed(&random, segments, 31);
    vbss_thread *thread = make_of(&f, bending, segments);
    vec3 at[2] = {vec3_zero(), vec3_make(0.15, 0.0, 0.0)};
    uint32_t hands[2] = {hold(thread, VBSS_THREAD_ATTACHMENT_CLAMP, 0, at[0]),
                         hold(thread, VBSS_THREAD_ATTACHMENT_PIN, segments, at[1])};
    for (uint32_t i = 0; i < count; i++) {
        for (int k = 0; k < 2; k++) {
            vec3 direction = vbss_random_direction(&random);
            at[k] = vec3_add_scaled(at[k], speed * h, direction);
        }
        vec3 apart = vec3_sub(at[1], at[0]);
        if (vec3_norm(apart) > 0.1502) { /* taut, up to 0.6 N */
            at[1] = vec3_add_scaled(at[0], 0.1502 / vec3_norm(apart), apart);
        }
        move(thread, hands[0], at[0]);
        move(thread, hands[1], at[1]);
        step(thread, h);
    }
    char name[64];
    (void)snprintf(name, sizeof name, "tugged, N %u, h %g", segments, h);
    expect_kept(name, thread, 360);
    expect_at_rest(thread, 100, h);
    end(&f);
}

static void random_pulls_keep_thread_intact(void **state)
{
    (void)state;
    for (int bending = 0; bending < 2; bending++) {
        tug(20, bending, 1e-3, 3000, 2.0);
        tug(60, bending, 1e-3, 700, 2.0);
    }
}

static void steps_of_any_size(void **state)
{
    (void)state;
    const double sizes[] = {1e-4, 3e-4, 1e-3, 3e-3, 1e-2};
    for (int bending = 0; bending < 2; bending++) {
        for (int k = 0; k < 5; k++) {
            tug(40, bending, sizes[k], 400, 0.5);
        }
    }
}

int test_stress(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_ends_clamped_and_pulled),
        cmocka_unit_test(teleported_end),
        cmocka_unit_test(stiff_and_fine_thread),
        cmocka_unit_test(heavy_end),
        cmocka_unit_test(any_start_comes_to_rest),
        cmocka_unit_test(random_pulls_keep_thread_intact),
        cmocka_unit_test(steps_of_any_size),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
