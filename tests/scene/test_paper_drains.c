/* Method VBLAST of scenes: tools and a drain, which yields where its edges are touched, and lets through what they miss. */
#include "fixtures/step_events.h"
#include "scene/paper_drains.h"

/* ---- what collides */

/* Those of the grid along, round and across, as tests/drain/test_paper_drain.c counts them. */
static void collision_edges_are_grid_segments(void **state)
{
    (void)state;
    stage s;
    scene_object *scene;
    stage_drain d = begin_with_drain(&s);
    expect_ok(vbss_scene_open(s.scene, &scene));
    const collision_shape *shape = scene->collision->shapes[vbss_scene_body(scene, d.body)->shape];
    const drain_mesh *m = &d.object->mesh;
    assert_int_equal(m->edge_count, shape->edge_count);
    for (uint32_t e = 0; e < shape->edge_count; e++) {
        uint32_t found = 0;
        for (uint32_t k = 0; k < m->edge_count; k++) {
            const uint32_t *n = m->edges[k].nodes, *own = shape->edges[e];
            found += (n[0] == own[0] && n[1] == own[1]) || (n[0] == own[1] && n[1] == own[0]);
        }
        assert_int_equal(1, found);
    }
    end(&s);
}

#define POKER 2.5e-3

/* Along z. */
static uint32_t add_poker(stage *s)
{
    return add_tool(s, over_side(POKER, 0.5e-3), vec3_make(0, 0, 0.06), POKER);
}

static void expect_poked(stage *s, const stage_drain *d, uint32_t tool)
{
    scene_object *scene;
    expect_ok(vbss_scene_open(s->scene, &scene));
    for (uint32_t i = 0; i < scene->collision->candidate_count; i++) { /* triangles are not asked */
        assert_int_equal(VBSS_COLLISION_PAIR_EDGE_EDGE, scene->collision->candidates[i].kind);
    }
    vbss_view v = view_of(s, VBSS_SCENE_VIEW_CONTACTS);
    const uint32_t *features = v.data;
    vec3 sum = vec3_zero();
    const vec3 *forces = view_of(s, VBSS_SCENE_VIEW_CONTACT_FORCES).data;
    assert_true(v.count > 0);
    for (uint64_t i = 0; i < v.count; i++) {
        assert_int_equal(VBSS_SCENE_CONTACT_SIDES, features[5 * i]);
        assert_int_equal(tool, features[5 * i + 1]);
        assert_int_equal(d->body, features[5 * i + 3]);
        sum = vec3_add(sum, forces[i]);
    }
    vec3 hand = vec3_load(rigid_of(s, tool).hand_force);
    expect_near(0.0, vec3_distance(sum, hand), 1e-15);
    assert_true(hand.z > 0.02 && hand.z < 0.05); /* not the 0.3 N of the spring: docs */
}

static uint32_t count_events(stage *s, vbss_scene_event_kind kind, uint32_t a, uint32_t b)
{
    const step_events events = step_events_of(s->scene);
    uint32_t count = 0;
    for (uint32_t i = 0; i < events.count; i++) {
        const vbss_scene_event *e = &events.of[i];
        count += e->kind == kind && e->body_a == a && e->body_b == b;
    }
    return count;
}

static void poked_drain_yields_and_springs_back(void **state)
{
    (void)state;
    stage s;
    stage_drain d = begin_with_drain(&s);
    uint32_t tool = add_poker(&s), touched = 0, parted = 0;
    double gap = gap_of(&d).gap;
    vec3 away = over_side(POKER, 0.5e-3), in = over_side(POKER, -2e-3);
    for (int i = 1; i <= 300; i++) {
        double progress = i <= 100 ? 0.01 * i : i <= 200 ? 1.0 : 0.01 * (300 - i);
        go(&s, tool, vec3_lerp(away, in, progress));
        touched += count_events(&s, VBSS_SCENE_EVENT_TOUCH, tool, d.body);
        parted += count_events(&s, VBSS_SCENE_EVENT_PART, tool, d.body);
        expect_near(gap, gap_of(&d).gap, 1e-6); /* it is far from there */
        if (i == 200) {
            expect_poked(&s, &d, tool);
            assert_true(moved(&d, SIDE_NODE).z < -2e-3 && moved(&d, SIDE_NODE).z > -3e-3);
            assert_true(farthest(&d, SIDE_NODE) < 0.4e-3);
            expect_near(0.0, statistics_of(&s).last_penetration, 1e-12);
        }
    }
    wait_for(&s, 100);
    expect_near(0.0, farthest(&d, DRAIN_NODES), 1e-9);
    expect_near(gap, gap_of(&d).gap, 1e-9);
    assert_int_equal(1, touched);
    assert_int_equal(1, parted);
    end(&s);
}

/* As side a, whichever came first. */
static void creation_order_does_not_change_reports(void **state)
{
    (void)state;
    stage s;
    vbss_drain_config c = paper_drain();
    begin(&s);
    make(&s);
    uint32_t tool = add_poker(&s);
    stage_drain d = add_drain(&s, &c);
    travel(&s, tool, over_side(POKER, 0.5e-3), over_side(POKER, -2e-3), 100);
    wait_for(&s, 100);
    expect_poked(&s, &d, tool);
    end(&s);
}

/* ---- what does not move */

static void pinned_particle_stays_under_tool(void **state)
{
    (void)state;
    stage s;
    stage_drain d = begin_with_drain(&s);
    vec3 place = d.object->x[SIDE_NODE], aside = vec3_make(2e-3, 0, 0);
    attach(&d, VBSS_DRAIN_ATTACHMENT_PIN, SIDE_NODE, place);
    uint32_t tool = add_poker(&s);
    travel(&s, tool, vec3_add(over_side(POKER, 0.5e-3), aside),
           vec3_add(over_side(POKER, -0.5e-3), aside), 100);
    assert_memory_equal(&place, &d.object->x[SIDE_NODE], sizeof place);
    assert_true(statistics_of(&s).contacts > 0);
    assert_true(farthest(&d, SIDE_NODE) > 1e-4); /* free ends of the same edges do move */
    end(&s);
}

/* Lips may cross: edges of a drain are not tested against each other. */
static void drain_ignores_self_contact_and_opens_again(void **state)
{
    (void)state;
    stage s;
    stage_drain d = begin_with_drain(&s);
    vbss_drain_places p;
    uint32_t ids[2];
    double wide = gap_of(&d).gap;
    expect_ok(vbss_drain_get_places(d.drain, &p, sizeof p));
    for (int k = 0; k < 2; k++) {
        vec3 to = d.object->x[p.gap_points[k]];
        to.z = k == 0 ? 1e-3 : -1e-3; /* the left one beyond the right one */
        ids[k] = attach(&d, VBSS_DRAIN_ATTACHMENT_PIN, p.gap_points[k], to);
    }
    wait_for(&s, 50);
    expect_near(-2e-3, gap_of(&d).signed_gap, 1e-12);
    assert_int_equal(0, statistics_of(&s).contacts);
    assert_int_equal(0, baseline_statistics_of(&s).tested_pairs);
    for (int k = 0; k < 2; k++) {
        expect_ok(vbss_drain_detach(d.drain, ids[k]));
    }
    wait_for(&s, 100);
    expect_near(wide, gap_of(&d).signed_gap, 1e-9);
    end(&s);
}

/* ---- what is let through: known weaknesses, as measured */

/* Along itself the axis stays where it is as seen from an edge: no sign changes, and at the end it is far away. */
static void axial_tool_passage_within_step_is_missed(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        stage s;
        stage_drain d = begin_with_drain(&s);
        vec3 outside = over_side(1e-3, 0.1e-3), inside = vec3_make(0, 0, -4e-3);
        uint32_t tool = add_tool(&s, outside, vec3_make(0, 0, 4e-3), 1e-3);
        double largest = 0.0;
        for (int i = 1, n = k == 0 ? 1 : 100; i <= n; i++) {
            go(&s, tool, vec3_lerp(outside, inside, (double)i / n));
            largest = vbss_max(farthest(&d, DRAIN_NODES), largest);
        }
        if (k == 0) { /* at 12 m/s */
            expect_near(0.0, largest, 0.0);
            assert_int_equal(0, statistics_of(&s).contacts);
            assert_true(baseline_statistics_of(&s).tested_pairs > 0);
        } else {
            assert_true(largest > 2e-3);
        }
        end(&s);
    }
}

/* Across itself it is. */
static void lateral_tool_passage_takes_edges_along(void **state)
{
    (void)state;
    stage s;
    stage_drain d = begin_with_drain(&s);
    vec3 tip = vec3_add(over_side(1e-3, 0.1e-3), vec3_make(-5e-3, 0, 0));
    uint32_t tool = add_tool(&s, tip, vec3_make(10e-3, 0, 0), 1e-3);
    go(&s, tool, vec3_make(-5e-3, 0, 0));
    assert_true(moved(&d, SIDE_NODE).z < -RING_RADIUS);
    end(&s);
}

/* Of no triangle, only its sides: the largest circle in one is 1.2 mm. */
static void slim_tip_enters_between_edges(void **state)
{
    (void)state;
    stage s;
    stage_drain d = begin_with_drain(&s);
    vec3 corner[3], centre = vec3_zero();
    double length[3], sum = 0.0;
    for (int k = 0; k < 3; k++) {
        corner[k] = d.object->x[d.object->mesh.triangles[40][k]];
    }
    for (int k = 0; k < 3; k++) {
        length[k] = vec3_distance(corner[(k + 1) % 3], corner[(k + 2) % 3]);
        sum += length[k];
    }
    for (int k = 0; k < 3; k++) {
        centre = vec3_add_scaled(centre, length[k] / sum, corner[k]);
    }
    vec3 out = vec3_unit_or(
        vec3_cross(vec3_sub(corner[1], corner[0]), vec3_sub(corner[2], corner[0])), vec3_zero());
    vec3 from = vec3_add_scaled(centre, 3e-3, out), to = vec3_add_scaled(centre, -3e-3, out);
    uint32_t tool = add_tool(&s, from, vec3_scale(out, 0.02), 0.3e-3);
    travel(&s, tool, from, to, 100);
    expect_near(0.0, farthest(&d, DRAIN_NODES), 0.0);
    assert_true(baseline_statistics_of(&s).tested_pairs > 0);
    end(&s);
}

int test_paper_drains(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(collision_edges_are_grid_segments),
        harness_test(poked_drain_yields_and_springs_back),
        harness_test(creation_order_does_not_change_reports),
        harness_test(pinned_particle_stays_under_tool),
        harness_test(drain_ignores_self_contact_and_opens_again),
        harness_test(axial_tool_passage_within_step_is_missed),
        harness_test(lateral_tool_passage_takes_edges_along),
        harness_test(slim_tip_enters_between_edges),
    };
    return cmocka_run_group_tests_name("scene.paper_drains", tests, NULL, NULL);
}
