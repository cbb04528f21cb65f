/* Cutting a thread in two. */
#include <stdlib.h>

#include "fixture.h"

/* Largest relative changes by a cut, by the number of segments; just above what was measured. Method
 * OURS gives the masses near an end other weights (layout.c), so that new ends move some; method VBLAST
 * halves each segment, which keeps linear momentum and centre in row 0. */
typedef struct change {
    double linear, centre, angular;
} change;
static const change bounds[] = {{1e-14, 1e-14, 0.0}, {1e-14, 1e-14, 0.26},  {0.11, 0.045, 0.09},
                                {0.05, 0.02, 0.04},  {0.035, 0.011, 0.023}, {0.027, 0.007, 0.015}};

static void expect_changed(vec3 before, vec3 after, double limit)
{
    expect_near(0.0, vec3_distance(before, after) / vec3_norm(before), limit);
}

/* The positions of both parts, for what must not move. */
static void expect_parts(fixture *f, vbss_thread *a, vbss_thread *b, vbss_thread_momentum before,
                         double s)
{
    vbss_thread_momentum m = momentum_of(a), n = momentum_of(b);
    double mass = f->config.linear_density * f->config.length;
    vec3 linear = vec3_add(vec3_load(m.linear), vec3_load(n.linear));
    expect_near(mass, m.mass + n.mass, 1e-13 * mass);
    expect_near(s, rest_length_of(a), 1e-12);
    expect_near(f->config.length - s, rest_length_of(b), 1e-12);
    expect_near(f->config.linear_density * s, m.mass, 1e-12 * mass);
    const change *largest =
        &bounds[f->config.method == VBSS_METHOD_VBLAST ? 0 : f->config.segment_count];
    vec3 centre = vec3_add(vec3_scale(vec3_load(m.centre), m.mass / mass),
                           vec3_scale(vec3_load(n.centre), n.mass / mass));
    expect_changed(vec3_load(before.linear), linear, largest->linear);
    expect_near(0.0, vec3_distance(vec3_load(before.centre), centre) / f->config.length,
                largest->centre);
    vec3 angular = vec3_add(vec3_load(m.angular), vec3_load(n.angular));
    /* A new node has the speed of the chord but not what its halves turn with. */
    expect_changed(vec3_load(before.angular), angular, bounds[f->config.segment_count].angular);
    vec3 end = place_of(a, nodes_of(a) - 1), front = place_of(b, 0);
    assert_memory_equal(&end, &front, sizeof end);
    end = vector_at(a, VBSS_THREAD_VIEW_VELOCITIES, nodes_of(a) - 1);
    front = vector_at(b, VBSS_THREAD_VIEW_VELOCITIES, 0);
    assert_memory_equal(&end, &front, sizeof end);
}

/* Everywhere: in the segments, at nodes, and just beside them. */
static void cut_everywhere(vbss_method method)
{
    const double shares[] = {0.0, 0.005, 0.00999, 0.01001, 0.3, 0.5, 0.98999, 0.99001, 0.995};
    for (uint32_t segments = 1; segments <= 5; segments++) {
        for (uint32_t segment = 0; segment < segments; segment++) {
            for (int k = 0; k < 9; k++) {
                fixture f;
                begin(&f);
                f.config.method = method;
                f.config.segment_count = segments;
                f.config.cut_capacity = 1;
                vbss_thread *thread = make(&f), *piece = NULL;
                hold(thread, VBSS_THREAD_ATTACHMENT_PIN, 0, vec3_zero());
                steps(thread, 20, 1e-3);
                double l = f.config.length / segments, share = shares[k];
                bool low = share<0.01, high = share> 0.99;
                bool at_end = (low && segment == 0) || (high && segment + 1 == segments);
                vbss_thread_momentum before = momentum_of(thread);
                vbss_result result = vbss_thread_cut(thread, (segment + share) * l, &piece);
                expect_result(at_end ? VBSS_ERROR_OUT_OF_RANGE : VBSS_OK, result);
                if (result == VBSS_OK) {
                    double s = low ? segment * l : high ? (segment + 1) * l : (segment + share) * l;
                    assert_int_equal(nodes_of(thread), low ? segment + 1 : segment + 2);
                    assert_int_equal(nodes_of(thread) + nodes_of(piece),
                                     segments + (low || high ? 2 : 3));
                    expect_parts(&f, thread, piece, before, s);
                    steps(thread, 3, 1e-3);
                    steps(piece, 3, 1e-3);
                    assert_true(all_finite(thread) && all_finite(piece));
                }
                end(&f);
            }
        }
    }
}

static void every_place_can_be_cut(void **state)
{
    (void)state;
    cut_everywhere(VBSS_METHOD_IMPLICIT);
    cut_everywhere(VBSS_METHOD_VBLAST);
}

static void attachments_move_with_nodes(void **state)
{
    (void)state;
    for (int doubled = 0; doubled < 2; doubled++) {
        fixture f;
        begin(&f);
        f.config.attachment_capacity = 13;
        f.config.cut_capacity = 1;
        vbss_thread *thread = make(&f), *piece;
        for (uint32_t i = 0; i <= 12; i++) {
            assert_int_equal(hold(thread, VBSS_THREAD_ATTACHMENT_FORCE, i, vec3_zero()), i + 1);
        }
        double l = 0.15 / 12;
        expect_ok(vbss_thread_cut(thread, (doubled ? 6.0 : 5.5) * l, &piece));
        for (uint32_t id = 1; id <= 13; id++) {
            vbss_thread_reaction r;
            uint32_t node = id - 1, shift = doubled ? 6 : 5;
            bool near_part = doubled ? node <= 6 : node <= 5;
            vbss_thread *owner = near_part ? thread : piece, *other = near_part ? piece : thread;
            assert_int_equal(reaction_of(owner, id).node, near_part ? node : node - shift);
            expect_result(VBSS_ERROR_NOT_FOUND, vbss_thread_get_reaction(other, id, &r, sizeof r));
        }
        /* Ids of the past are used by neither part. */
        assert_int_equal(hold(piece, VBSS_THREAD_ATTACHMENT_MASS, 1, vec3_zero()), 14);
        assert_int_equal(hold(thread, VBSS_THREAD_ATTACHMENT_MASS, 1, vec3_zero()), 14);
        end(&f);
    }
}

static void parts_are_cut_up_to_shared_capacity(void **state)
{
    (void)state;
    fixture f;
    vbss_thread *parts[65] = {NULL}, *none;
    vbss_random random;
    vbss_random_seed(&random, 4, 2);
    begin(&f);
    f.config.cut_capacity = 64;
    f.config.segment_count = 40;
    parts[0] = make(&f);
    uint64_t calls = f.memory.calls;
    uint32_t count = 1;
    while (count < 65) {
        uint32_t taken = vbss_random_below(&random, count);
        double share = vbss_random_uniform(&random), length = rest_length_of(parts[taken]);
        if (vbss_thread_cut(parts[taken], share * length, &parts[count]) == VBSS_OK) {
            count++;
        }
    }
    for (uint32_t i = 0; i < count; i++) {
        double half = 0.5 * rest_length_of(parts[i]);
        expect_result(VBSS_ERROR_CAPACITY, vbss_thread_cut(parts[i], half, &none));
        assert_null(none);
        steps(parts[i], 20, 1e-3);
        /* All fall freely, however short they are. */
        vbss_thread_momentum m = momentum_of(parts[i]);
        expect_near(-9.81 * 0.02 * m.mass, m.linear[1], 1e-6 * m.mass);
    }
    assert_int_equal(f.memory.calls, calls);
    end(&f);
}

/* Slivers: the first segment cut again and again, as close to its end as a cut may come. */
static void repeated_end_cuts_stay_finite(void **state)
{
    (void)state;
    for (int bending = 0; bending < 2; bending++) {
        fixture f;
        begin(&f);
        f.config.bending = bending;
        f.config.cut_capacity = 64;
        vbss_thread *thread = make(&f), *piece = NULL;
        for (int i = 0; i < 64; i++) {
            double l = number_at(thread, VBSS_THREAD_VIEW_REST_LENGTHS, 0);
            vbss_result result = vbss_thread_cut(thread, 0.02 * l, &piece);
            assert_true(result == VBSS_OK || result == VBSS_ERROR_OUT_OF_RANGE);
            if (result == VBSS_OK) {
                steps(piece, 1, 1e-3);
                assert_true(all_finite(piece));
            }
            steps(thread, 2, 1e-3);
            assert_true(all_finite(thread));
        }
        end(&f);
    }
}

/* A swinging thread: the held part goes on swinging, the other flies as a free body does. */
static void both_parts_have_correct_forces(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        fixture f;
        begin(&f);
        f.config.segment_count = 40;
        f.config.cut_capacity = 1;
        vbss_thread *thread = make(&f), *piece;
        uint32_t pin = hold(thread, VBSS_THREAD_ATTACHMENT_PIN, 0, vec3_zero());
        steps(thread, 120, 1e-3);
        double whole = energies_of(thread).total, moving = energies_of(thread).kinetic;
        vec3 linear = vec3_load(momentum_of(thread).linear);
        expect_ok(vbss_thread_cut(thread, k == 0 ? 0.06 : 0.0612, &piece));
        double parts = energies_of(thread).total + energies_of(piece).total;
        assert_true(fabs(parts - whole) <= 1e-3 * moving);
        vbss_thread_momentum before = momentum_of(piece), near_part = momentum_of(thread);
        expect_near_vec3(linear, vec3_add(vec3_load(before.linear), vec3_load(near_part.linear)),
                         1e-4 * vec3_norm(linear));
        steps(thread, 40, 1e-3);
        steps(piece, 40, 1e-3);
        vbss_thread_momentum after = momentum_of(piece);
        vec3 impulse = vec3_make(0.0, -9.81 * 0.04 * before.mass, 0.0);
        linear = vec3_add(vec3_load(before.linear), impulse);
        expect_near_vec3(linear, vec3_load(after.linear), 1e-9 * before.mass);
        /* The centre falls by a parabola; each step of backward Euler is wrong by g h^2 / 2. */
        vec3 centre =
            vec3_add_scaled(vec3_load(before.centre), 0.04 / before.mass, vec3_load(before.linear));
        centre.y -= 0.5 * 9.81 * 0.04 * 0.04;
        expect_near_vec3(centre, vec3_load(after.centre), 2e-5);
        expect_near_vec3(vec3_zero(), place_of(thread, 0), 0.0);
        assert_true(reaction_of(thread, pin).force[1] > 0.0);
        expect_near(0.160, statistics_of(thread).time, 1e-12);
        expect_near(0.160, statistics_of(piece).time, 1e-12);
        assert_int_equal(statistics_of(piece).steps, 40);
        end(&f);
    }
}

/* ---- saved before, restored after: the thread is whole again, the piece a thread of its own */

static void snapshot_before_cut_is_restored(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config.cut_capacity = 3;
    vbss_thread *thread = make(&f), *piece, *second;
    uint32_t pin = hold(thread, VBSS_THREAD_ATTACHMENT_PIN, 0, vec3_zero());
    uint32_t far_pin = hold(thread, VBSS_THREAD_ATTACHMENT_CLAMP, 12, vec3_make(0.14, 0.0, 0.0));
    steps(thread, 10, 1e-3);
    uint64_t whole = hash_of(thread), need, part;
    expect_result(VBSS_ERROR_CAPACITY, vbss_thread_save(thread, NULL, 0, &need));
    uint8_t *bytes = malloc(2 * need), *parts = bytes + need;
    expect_ok(vbss_thread_save(thread, bytes, need, &need));
    expect_ok(vbss_thread_cut(thread, 0.07, &piece));
    steps(thread, 5, 1e-3);
    expect_ok(vbss_thread_save(thread, parts, need, &part));
    uint64_t cut = hash_of(thread), far_part = hash_of(piece);
    /* Back, with what held the nodes that had been cut off. */
    expect_ok(vbss_thread_restore(thread, bytes, need));
    assert_true(hash_of(thread) == whole);
    assert_true(hash_of(piece) == far_part);
    assert_int_equal(reaction_of(thread, far_pin).node, 12);
    steps(thread, 5, 1e-3);
    expect_near_vec3(vec3_make(0.14, 0.0, 0.0), place_of(thread, 12), 0.0);
    /* Forward, and into each other; each then does what the saved one did. */
    expect_ok(vbss_thread_restore(thread, parts, part));
    assert_true(hash_of(thread) == cut);
    expect_ok(vbss_thread_restore(piece, bytes, need));
    assert_true(hash_of(piece) == whole);
    steps(thread, 5, 1e-3);
    uint64_t later = hash_of(thread);
    expect_ok(vbss_thread_restore(piece, parts, part));
    steps(piece, 5, 1e-3);
    assert_true(hash_of(piece) == later);
    expect_ok(vbss_thread_detach(piece, pin));
    expect_ok(vbss_thread_cut(piece, 0.03, &second));
    steps(second, 5, 1e-3);
    free(bytes);
    end(&f);
}

/* ---- before the first step */

static double bending_across(vbss_thread *thread, uint32_t node)
{
    vbss_thread_attachment a = plain(VBSS_THREAD_ATTACHMENT_CLAMP, node);
    vec3_store(a.position, place_of(thread, node));
    vec3_store(a.direction, vec3_make(0.0, 1.0, 0.0));
    attach(thread, &a);
    return energies_of(thread).bending;
}

/* A clamp's direction is taken at once by what has made no step, and in the next step else: the parts
 * of a cut know which they are. */
static void piece_takes_clamp_like_thread(void **state)
{
    (void)state;
    for (int moved = 0; moved < 2; moved++) {
        for (int bending = 0; bending < 2; bending++) {
            fixture f;
            begin(&f);
            f.config.bending = bending;
            f.config.gravity[1] = 0.0; /* straight in both cases */
            f.config.cut_capacity = 1;
            vbss_thread *thread = make(&f), *piece;
            steps(thread, moved == 0 ? 0 : 2, 1e-3);
            expect_ok(vbss_thread_cut(thread, 0.075, &piece));
            double near_part = bending_across(thread, 3), far_part = bending_across(piece, 3);
            /* Two half segments turned by a right angle, and what their neighbours turn. */
            double turned = moved == 0 ? 4.0 * 1e-8 / (0.15 / 12) : 0.0;
            assert_true(near_part >= turned - 1e-18 && near_part <= 2.0 * turned + 1e-18);
            expect_near(near_part, far_part, 1e-12 * turned + 1e-18);
            steps(piece, 1, 1e-3);
            assert_true(energies_of(piece).bending > 0.0);
            end(&f);
        }
    }
}

/* A thread that is larger in all its lengths is cut at the same fractions of its segments. */
static void place_of_cut_does_not_depend_on_scale(void **state)
{
    (void)state;
    const double fractions[] = {0.005, 0.012, 0.11, 0.5, 0.89, 0.988, 0.995};
    const double lengths[] = {1e-6, 5e-6, 1e-3}; /* the shortest part is 1e-7 m, or a hundredth */
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 7; i++) {
            thread_cut cut[2];
            for (int large = 0; large < 2; large++) {
                const double scale = large ? 1024.0 : 1.0, l = scale * lengths[k];
                double rest[3] = {l, l, l};
                thread_object t = {.node_count = 4, .rest = rest};
                t.config.radius = scale * 0.125e-3;
                assert_true(vbss_thread_locate_cut(&t, (1.0 + fractions[i]) * l, &cut[large]));
            }
            const double min_fraction = vbss_max(0.01, 1e-7 / lengths[k]);
            const double nearest = vbss_min(fractions[i], 1.0 - fractions[i]);
            assert_int_equal(cut[0].fraction == 1.0, nearest < min_fraction);
            assert_int_equal(cut[0].segment, cut[1].segment);
            expect_near(cut[0].fraction, cut[1].fraction, 0.0);
        }
    }
}

int test_cutting(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_place_can_be_cut),
        cmocka_unit_test(attachments_move_with_nodes),
        cmocka_unit_test(parts_are_cut_up_to_shared_capacity),
        cmocka_unit_test(repeated_end_cuts_stay_finite),
        cmocka_unit_test(both_parts_have_correct_forces),
        cmocka_unit_test(snapshot_before_cut_is_restored),
        cmocka_unit_test(piece_takes_clamp_like_thread),
        cmocka_unit_test(place_of_cut_does_not_depend_on_scale),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
