/* What follows a needle of method VBLAST that has gone through a wall, and what does not touch it there. */
#include "scene/paper_prick.h"

/* No force enters: a tip within a triangle touches nothing and moves nothing. */
static void wall_ignores_tip(void **state)
{
    (void)state;
    prick p;
    begin(&p);
    drive(&p, 0.9e-3);
    assert_int_equal(small_statistics(&p.r.tools.s).contacts, 0);
    assert_true(moved_max(&p) < 1e-12);
    needles_end(&p.r);
}

static void particles_follow_needle_by_weight(void **state)
{
    (void)state;
    prick p;
    begin(&p);
    drive(&p, 6e-3);
    assert_int_equal(p.in, 1);
    for (int i = 1; i <= 100; i++) {
        p.aside = vec3_make(2e-5 * i, 1e-5 * i, 0.0);
        go(&p, 6e-3);
        vbss_scene_hole hole = hole_of(&p, 0);
        vec3 there = needles_place(&p.r, hole.arc_length, NULL);
        expect_near(0.0, vec3_distance(there, vec3_load(hole.position)), 1e-9);
    }
    for (int i = 0; i < 300; i++) {
        go(&p, 6e-3);
    }
    /* Springs alike, each particle is as far from its rest as the others by weight over mass. */
    vbss_scene_hole hole = hole_of(&p, 0);
    const uint32_t *node = p.drain->mesh.triangles[hole.triangle];
    vec3 moved = vec3_sub(vec3_load(hole.position), vec3_load(hole.rest_position));
    double share[3], sum = 0.0;
    for (int k = 0; k < 3; k++) {
        share[k] = hole.weights[k] / p.drain->mass[node[k]];
        sum += hole.weights[k] * share[k];
    }
    assert_true(moved.x > 1.9e-3);
    for (int k = 0; k < 3; k++) {
        vec3 own = vec3_sub(p.drain->x[node[k]], p.drain->baseline->rest[node[k]]);
        expect_near(share[k] / sum * moved.x, own.x, 0.05 * moved.x);
    }
    assert_true(vec3_dot(vec3_load(hole.force), moved) < 0.0); /* it pulls the needle back */
    expect_near(0.0, vec3_dot(vec3_load(hole.force), vec3_load(hole.direction)), 1e-4);
    needles_end(&p.r);
}

/* Contacts of the needle with sides of the drain. */
static uint32_t sides(const prick *p)
{
    vbss_view keys = small_view(&p->r.tools.s, VBSS_SCENE_VIEW_CONTACTS);
    uint32_t count = 0;
    for (uint64_t i = 0; i < keys.count; i++) {
        uint32_t key[5];
        memcpy(key, (const char *)keys.data + i * keys.stride_bytes, sizeof key);
        count += key[0] == VBSS_SCENE_CONTACT_SIDES && key[1] == p->r.body;
    }
    return count;
}

/* Beside an edge it presses that aside, until it is in the hole. */
static void wall_near_hole_has_no_contact(void **state)
{
    (void)state;
    static const double beside[3] = {0.46, 0.46, 0.08};
    prick p;
    begin_with(&p, beside, 4);
    go(&p, START);
    tools_open(&p.r.tools, 0, 0.0);
    go(&p, START);
    uint32_t before = 0, after = 0;
    while (p.depth < 8e-3) {
        go(&p, p.depth + 2e-5);
        before += p.in == 0 ? sides(&p) : 0;
        after += p.in > 0 && p.depth > 1.1e-3 ? sides(&p) : 0;
    }
    assert_int_equal(p.in, 1);
    assert_true(before > 0);
    assert_int_equal(after, 0);
    needles_end(&p.r);
}

/* The springs of the particles would have to be pulled along: it stays where it was let go. */
static void free_needle_stays_in_wall(void **state)
{
    (void)state;
    prick p;
    begin(&p);
    vbss_scene_body(small_object(&p.r.tools.s), p.r.body)->rigid.body.gravity.y = -9.81;
    drive(&p, 5e-3);
    tools_open(&p.r.tools, 0, 1.0);
    go(&p, 5e-3);
    pose before = needles_pose(&p.r);
    for (int i = 0; i < 200; i++) {
        go(&p, 5e-3);
    }
    assert_int_equal(tools_state(&p.r.tools, 0).needle, 0);
    expect_near(0.0, vec3_distance(before.position, needles_pose(&p.r).position), 0.0);
    assert_int_equal(p.in, 1);
    expect_ok(vbss_scene_remove(p.r.tools.s.scene, p.wall)); /* and falls with it */
    for (int i = 0; i < 10; i++) {
        go(&p, 5e-3);
    }
    expect_near(-0.5 * 9.81e-6 * 10 * 11, needles_pose(&p.r).position.y - before.position.y, 1e-12);
    needles_end(&p.r);
}

int test_paper_holes(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(wall_ignores_tip),
        harness_test(particles_follow_needle_by_weight),
        harness_test(wall_near_hole_has_no_contact),
        harness_test(free_needle_stays_in_wall),
    };
    return cmocka_run_group_tests_name("scene.paper_holes", tests, NULL, NULL);
}
