/* What the tests of tied knots share: a knot in a watched context, tied, looked at after every throw. */
#ifndef VBSS_TESTS_SCENE_TIED_H
#define VBSS_TESTS_SCENE_TIED_H

#include "collision/closest.h"
#include "fixtures/solver_of.h"
#include "harness/harness.h"
#include "oracle/knot_type.h"
#include "fixtures/tied_knot.h"

#define TIED_STEP 1e-3
#define TIED_LOAD 2.0 /* N, of all hands */

/* A knot that has just been tightened gives way a little more before it rests. */
enum { TIED_MAX_STEPS = 4000, TIED_DAMPING_STEPS = 150, TIED_HELD_STEPS = 150 };

typedef struct tied {
    harness_memory memory;
    vbss_context *context;
    tied_knot_options options;
    tied_knot knot;
} tied;

static inline void tied_init(tied *t, knot_kind kind)
{
    *t = (tied){0};
    expect_ok(tied_knot_init(&t->options, kind));
}

static inline void tied_begin(tied *t)
{
    t->context = harness_context(&t->memory);
    expect_ok(tied_knot_create(t->context, &t->options, &t->knot));
}

static inline void tied_end(tied *t)
{
    expect_ok(tied_knot_destroy(&t->knot));
    harness_context_end(t->context, &t->memory);
}

/* ---- looking */

static inline const vec3 *tied_nodes(const tied *t)
{
    vbss_view view;
    expect_ok(vbss_thread_get_view(t->knot.thread, VBSS_THREAD_VIEW_POSITIONS, &view, sizeof view));
    return view.data;
}

static inline bool tied_type_kept(const tied *t)
{
    knot_type found, right = knot_type_of_kind(t->options.knot.kind, t->options.knot.mirrored);
    return knot_type_of(tied_nodes(t), t->knot.node_count, &found) && knot_type_same(found, right);
}

/* Least distance of strands, not nearer along the thread than touching ones can be, m. */
static inline double tied_min_distance(const tied *t)
{
    const vec3 *x = tied_nodes(t);
    double smallest = 1.0, apart = 3.2 * t->options.thread.radius;
    for (uint32_t a = 0; a + 1 < t->knot.node_count; a++) {
        double arc = 0.0;
        for (uint32_t b = a + 2; b + 1 < t->knot.node_count; b++) {
            double s, u;
            arc += vec3_distance(x[b - 1], x[b]);
            if (arc >= apart) {
                vec3 separation =
                    closest_between_edges(vec3_sub(x[a + 1], x[a]), vec3_sub(x[b + 1], x[b]),
                                          vec3_sub(x[b], x[a]), &s, &u);
                smallest = vbss_min(vec3_norm(separation), smallest);
            }
        }
    }
    return smallest;
}

/* Line that is in the knot and round the cylinder, m. */
static inline double tied_taken_up(const tied *t)
{
    const vec3 *x = tied_nodes(t);
    return t->knot.length - vec3_distance(x[0], x[t->knot.node_count - 1]);
}

/* How far from their middle strands touch each other, m. */
static inline double tied_extent(const tied *t)
{
    vbss_view features, points;
    vec3 middle = vec3_zero();
    double furthest = 0.0, count = 0.0;
    expect_ok(
        vbss_scene_get_view(t->knot.scene, VBSS_SCENE_VIEW_CONTACTS, &features, sizeof features));
    expect_ok(
        vbss_scene_get_view(t->knot.scene, VBSS_SCENE_VIEW_CONTACT_POINTS, &points, sizeof points));
    const uint32_t *kinds = features.data;
    const vec3 *at = points.data;
    for (uint64_t i = 0; i < features.count; i++) {
        bool strands = kinds[5 * i] == VBSS_SCENE_CONTACT_SEGMENTS;
        middle = strands ? vec3_add(middle, at[i]) : middle;
        count += strands;
    }
    assert_true(count > 0.0);
    for (uint64_t i = 0; i < features.count; i++) {
        double far = vec3_distance(vec3_scale(middle, 1.0 / count), at[i]);
        furthest = kinds[5 * i] == VBSS_SCENE_CONTACT_SEGMENTS ? vbss_max(far, furthest) : furthest;
    }
    return furthest;
}

/* ---- tying */

/* Until all throws bear their load; the type is looked at whenever one does. */
static inline void tied_tie(tied *t)
{
    uint32_t stage = 0;
    while (!tied_knot_done(&t->knot)) {
        expect_ok(tied_knot_step(&t->knot, TIED_STEP));
        assert_true(t->knot.steps < TIED_MAX_STEPS);
        if (tied_knot_stage(&t->knot) != stage) {
            stage = tied_knot_stage(&t->knot);
            assert_true(tied_type_kept(t));
        }
    }
}

/* Nothing gives way any more, nothing went wrong on the way; `extent` and `taken_up`: at most, m. */
static inline void tied_expect_tight(tied *t, double extent, double taken_up)
{
    vbss_scene_statistics s;
    double deepest =
        solver_values(&t->options.scene).penetration_tolerance * 2.0 * t->options.thread.radius;
    for (int i = 0; i < TIED_DAMPING_STEPS; i++) {
        expect_ok(tied_knot_step(&t->knot, TIED_STEP));
    }
    double before = tied_taken_up(t);
    for (int i = 0; i < TIED_HELD_STEPS; i++) {
        expect_ok(tied_knot_step(&t->knot, TIED_STEP));
        expect_near(TIED_LOAD, tied_knot_felt(&t->knot), 0.02);
    }
    expect_near(before, tied_taken_up(t), 1e-5);
    assert_true(tied_type_kept(t));
    assert_true(tied_min_distance(t) >= 2.0 * t->options.thread.radius - deepest);
    expect_ok(vbss_scene_get_statistics(t->knot.scene, &s, sizeof s));
    assert_int_equal(0, s.clamped);
    assert_int_equal(0, s.loose_stretch);
    assert_true(s.penetration <= deepest);
    assert_true(tied_extent(t) <= extent);
    assert_true(tied_taken_up(t) <= taken_up);
}

/* All throws at once, by the ends alone. */
static inline void tied_pull_at_once(tied *t)
{
    tied_knot *k = &t->knot;
    k->stage = k->throws - 1;
    for (int i = 0; i < 2; i++) {
        vec3 direction = vec3_make(i == 0 ? -1.0 : 1.0, 0.0, 0.0);
        expect_ok(contact_hand_release(&k->hands[i]));
        expect_ok(vbss_thread_detach(k->thread, k->ends[i]));
        k->ends[i] = 0;
        expect_ok(contact_hand_take(&k->hands[i], k->thread, k->nodes[k->stage][i], direction,
                                    &t->options.pull, t->options.thread.axial_stiffness / k->length,
                                    contact_hand_scene_waits(&t->options.scene)));
    }
}

#endif
