/* Anchors tear off at their strength, one a step, for ever. */
#include <math.h>
#include <string.h>

#include "drain/drain_rig.h"

enum { ANCHORS = 33 };

/* A drain at rest under a pull at a mark that nothing tears, and which anchor is loaded most, in Pa. */
typedef struct loaded {
    vec3 x[DRAIN_RIG_NODES];
    double largest, next;
    uint32_t worst;
} loaded;

static const vec3 load = {0.0, 0.08, 0.02};

static void find_load(loaded *l)
{
    drain_rig r;
    double areas[DRAIN_RIG_NODES];
    drain_rig_begin(&r);
    drain_rig_statics(&r);
    drain_rig_make(&r);
    assert_int_equal(drain_rig_count(&r, VBSS_DRAIN_VIEW_ANCHORS), ANCHORS);
    drain_rig_force(&r, r.places.marks[0], load);
    drain_rig_relax(&r, 1e-13, 500);
    drain_rig_copy(&r, l->x);
    drain_rig_areas(&r, areas);
    const vec3 *forces = drain_rig_vectors(&r, VBSS_DRAIN_VIEW_ANCHOR_FORCES);
    const uint32_t *anchors = drain_rig_numbers(&r, VBSS_DRAIN_VIEW_ANCHORS);
    l->largest = l->next = 0.0;
    for (uint32_t i = 0; i < ANCHORS; i++) {
        double stress = vec3_norm(forces[i]) / areas[anchors[i]];
        if (stress > l->largest) {
            l->next = l->largest;
            l->largest = stress;
            l->worst = i;
        } else {
            l->next = fmax(l->next, stress);
        }
    }
    drain_rig_end(&r);
}

/* That drain with an end to its strength. */
static void begin_at(drain_rig *r, const loaded *l, double tear_stress)
{
    drain_rig_begin(r);
    drain_rig_statics(r);
    r->config.tear_stress = tear_stress;
    drain_rig_make(r);
    drain_rig_force(r, r->places.marks[0], load);
    expect_ok(vbss_drain_set_state(r->drain, &l->x[0].x, NULL, r->places.node_count));
}

static void anchor_tears_at_strength(void **state)
{
    (void)state;
    static loaded l;
    drain_rig r;
    find_load(&l);
    assert_true(l.next < 0.999 * l.largest);
    begin_at(&r, &l, l.largest * (1.0 + 1e-6));
    drain_rig_run(&r, 1e-3, 100);
    assert_int_equal(drain_rig_statistics(&r).torn, 0);
    drain_rig_end(&r);

    begin_at(&r, &l, l.largest * (1.0 - 1e-6));
    drain_rig_run(&r, 1e-3, 1);
    assert_int_equal(drain_rig_statistics(&r).torn, 1);
    const vec3 *forces = drain_rig_vectors(&r, VBSS_DRAIN_VIEW_ANCHOR_FORCES);
    for (uint32_t i = 0; i < ANCHORS; i++) {
        assert_true((vec3_norm(forces[i]) > 0.0) == (i != l.worst));
    }
    drain_rig_end(&r);
}

/* Far above what most of them bear, still the one that bears most, and its neighbours when they have taken over. */
static void one_anchor_tears_per_step(void **state)
{
    (void)state;
    static loaded l;
    drain_rig r;
    find_load(&l);
    begin_at(&r, &l, 0.01 * l.largest);
    for (uint32_t step = 1; step <= ANCHORS; step++) {
        drain_rig_run(&r, 1e-3, 1);
        assert_int_equal(drain_rig_statistics(&r).torn, step);
        if (step == 1) {
            const vec3 *forces = drain_rig_vectors(&r, VBSS_DRAIN_VIEW_ANCHOR_FORCES);
            expect_near_vec3(vec3_zero(), forces[l.worst], 0.0);
        }
    }
    drain_rig_run(&r, 1e-3, 5);
    assert_int_equal(drain_rig_statistics(&r).torn, ANCHORS);
    drain_rig_end(&r);
}

static void torn_node_stays_free(void **state)
{
    (void)state;
    static loaded l;
    drain_rig r;
    vbss_drain_attachment a;
    uint32_t id;
    find_load(&l);
    begin_at(&r, &l, 0.999 * l.largest);
    uint32_t node = drain_rig_numbers(&r, VBSS_DRAIN_VIEW_ANCHORS)[l.worst];
    vec3 rest = drain_rig_position(&r, node);
    expect_ok(vbss_drain_attachment_init(&a, sizeof a));
    vec3_store(a.position, vec3_add(rest, vec3_make(0.0, 1e-3, 0.0)));
    a.node = node;
    expect_result(VBSS_ERROR_IN_USE, vbss_drain_attach(r.drain, &a, &id));
    drain_rig_run(&r, 1e-3, 1);
    expect_near_vec3(rest, drain_rig_position(&r, node), 0.0);
    /* It moves, unlike those that are left. */
    drain_rig_run(&r, 1e-3, 1);
    assert_true(vec3_distance(rest, drain_rig_position(&r, node)) > 1e-8);
    const vec3 *x = drain_rig_vectors(&r, VBSS_DRAIN_VIEW_POSITIONS);
    const vec3 *forces = drain_rig_vectors(&r, VBSS_DRAIN_VIEW_ANCHOR_FORCES);
    const vec3 *at_rest = drain_rig_vectors(&r, VBSS_DRAIN_VIEW_REST_POSITIONS);
    const uint32_t *anchors = drain_rig_numbers(&r, VBSS_DRAIN_VIEW_ANCHORS);
    for (uint32_t i = 0; i < ANCHORS; i++) {
        bool holds = vec3_norm(forces[i]) > 0.0;
        double moved = vec3_distance(x[anchors[i]], at_rest[anchors[i]]);
        assert_true(holds ? moved == 0.0 : i == l.worst || drain_rig_statistics(&r).torn > 1);
    }
    /* Without the load the drain goes back to its shape, but nothing holds the node there. */
    uint32_t torn = drain_rig_statistics(&r).torn;
    drain_rig_detach(&r, 1);
    drain_rig_relax(&r, 1e-12, 200);
    expect_near_vec3(rest, drain_rig_position(&r, node), 1e-9);
    assert_int_equal(drain_rig_statistics(&r).torn, torn);
    expect_ok(vbss_drain_attach(r.drain, &a, &id));
    drain_rig_run(&r, 1e-3, 1);
    expect_near_vec3(vec3_load(a.position), drain_rig_position(&r, node), 0.0);
    drain_rig_end(&r);
}

/* At the marks, as a hand would. */
static void strong_pull_detaches_whole_drain(void **state)
{
    (void)state;
    const double speeds[] = {0.05, 0.2};
    for (int k = 0; k < 2; k++) {
        drain_rig r;
        uint32_t ids[2];
        vec3 from[2];
        double before_first = 0.0;
        drain_rig_begin(&r);
        drain_rig_make(&r);
        for (int side = 0; side < 2; side++) {
            from[side] = drain_rig_position(&r, r.places.marks[side]);
            ids[side] = drain_rig_pin_here(&r, r.places.marks[side]);
        }
        uint32_t torn = 0;
        for (int step = 1; step <= 400; step++) {
            double gone = fmin(0.03, 1e-3 * speeds[k] * step);
            for (int side = 0; side < 2; side++) {
                vec3 to = vec3_add(from[side], vec3_make(0.0, gone, 0.0));
                drain_rig_move(&r, ids[side], to);
            }
            drain_rig_run(&r, 1e-3, 1);
            uint32_t now = drain_rig_statistics(&r).torn;
            assert_in_range(now, torn, torn + 1);
            torn = now;
            before_first = torn == 0 ? gone : before_first;
            assert_true(drain_rig_energies(&r).total < 0.1);
        }
        /* Some millimetres are borne; then it peels. */
        assert_true(before_first > 4e-3);
        assert_int_equal(torn, ANCHORS);
        drain_rig_detach(&r, ids[0]);
        drain_rig_run(&r, 1e-3, 500);
        assert_true(drain_rig_energies(&r).kinetic < 1e-9);
        drain_rig_end(&r);
    }
}

int test_drain_tearing(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(anchor_tears_at_strength),
        cmocka_unit_test(one_anchor_tears_per_step),
        cmocka_unit_test(torn_node_stays_free),
        cmocka_unit_test(strong_pull_detaches_whole_drain),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
