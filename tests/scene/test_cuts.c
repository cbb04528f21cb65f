/* Cutting a thread where it lies: what becomes of its nodes and of what holds them, and how the ends move. */
#include "scene/cut_rig.h"
#include "scene/topology/topology.h"
#include "scene/world/world.h"

/* A straight thread of 20 segments of 1 mm. */
static uint32_t line(small *s, uint32_t cuts, vbss_thread **thread)
{
    s->thread.cut_capacity = cuts;
    return small_thread(s, vec3_zero(), vec3_make(0.02, 0.0, 0.0), 20, thread);
}

static void part_beyond_cut_is_a_new_body(void **state)
{
    (void)state;
    static const struct {
        double arc;
        uint32_t kept, gone;
    } cases[] = {{3.4e-3, 5, 18},    {3e-3, 4, 18},     {3.005e-3, 4, 18}, {2.995e-3, 4, 18},
                 {0.5e-3, 2, 21},    {1e-3, 2, 20},     {19.5e-3, 21, 2},  {19e-3, 20, 2},
                 {10.02e-3, 12, 11}, {0.011e-3, 2, 21}, {19.985e-3, 21, 2}};
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        for (int method = 0; method < 2; method++) {
            small s;
            vbss_thread *thread, *piece;
            vbss_scene_event event;
            small_begin(&s);
            s.config.method = s.thread.method = method;
            small_create(&s);
            uint32_t body = line(&s, 1, &thread);
            small_steps(&s, 2, 1e-3);
            uint64_t generation = small_view(&s, VBSS_SCENE_VIEW_CONTACTS).generation;
            uint32_t number = cut_at(&s, body, cases[k].arc, &piece);
            assert_int_equal(number, body + 1);
            assert_int_equal(cut_nodes(thread), cases[k].kept);
            assert_int_equal(cut_nodes(piece), cases[k].gone);
            const thread_object *t = cut_thread(small_object(&s), body);
            const thread_object *u = cut_thread(small_object(&s), number);
            expect_near(0.02, cut_length(t) + cut_length(u), 1e-15);
            expect_near(cases[k].arc, cut_length(t), 0.011e-3);
            assert_true(vec3_distance(t->now.x[t->node_count - 1], u->now.x[0]) == 0.0);
            expect_near(0.02, small_node(piece, u->node_count - 1).x, 1e-12);
            assert_int_equal(small_events(&s, VBSS_SCENE_EVENT_CUT, &event), 1);
            assert_int_equal(event.body_a, body);
            assert_int_equal(event.body_b, number);
            expect_near(cases[k].arc, event.arc_length, 1e-12);
            assert_true(small_view(&s, VBSS_SCENE_VIEW_CONTACTS).generation > generation);
            expect_result(VBSS_ERROR_IN_SCENE, vbss_thread_step(piece, 1e-3));
            expect_result(VBSS_ERROR_IN_SCENE, vbss_thread_destroy(piece));
            cut_expect_sound(small_object(&s));
            small_steps(&s, 5, 1e-3);
            cut_expect_sound(small_object(&s));
            small_end(&s);
        }
    }
}

static void cut_at_end_does_nothing(void **state)
{
    (void)state;
    const double refused[] = {0.0, 1e-9, 0.009e-3, 0.02, 0.02 - 0.009e-3};
    const double outside[] = {-1e-9, 0.0201, 1e300};
    small s;
    uint32_t piece = 77;
    small_begin_scene(&s);
    uint32_t body = line(&s, 3, NULL);
    uint64_t hash = small_hash(&s);
    scene_body *b = vbss_scene_body(small_object(&s), body), *made;
    for (int k = 0; k < 5; k++) {
        expect_result(VBSS_ERROR_OUT_OF_RANGE,
                      vbss_scene_cut_thread(s.scene, body, refused[k], &piece));
        assert_int_equal(vbss_scene_apply_cut(small_object(&s), b, refused[k], &made),
                         VBSS_ERROR_OUT_OF_RANGE);
        assert_null(made);
    }
    for (int k = 0; k < 3; k++) {
        expect_result(VBSS_ERROR_OUT_OF_RANGE,
                      vbss_scene_cut_thread(s.scene, body, outside[k], &piece));
        expect_result(VBSS_ERROR_NOT_FINITE,
                      vbss_scene_cut_thread(s.scene, body, harness_bad_numbers[k], &piece));
        assert_int_equal(vbss_scene_apply_cut(small_object(&s), b, outside[k], &made),
                         VBSS_ERROR_OUT_OF_RANGE);
        assert_int_equal(vbss_scene_apply_cut(small_object(&s), b, harness_bad_numbers[k], &made),
                         VBSS_ERROR_OUT_OF_RANGE);
    }
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_scene_cut_thread(s.scene, 0, 5e-3, &piece));
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_scene_cut_thread(s.scene, body + 1, 5e-3, &piece));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_scene_cut_thread(s.scene, body, 5e-3, NULL));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_scene_cut_thread(NULL, body, 5e-3, &piece));
    vbss_thread *thread = (vbss_thread *)&s;
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_scene_get_thread(s.scene, body + 1, &thread));
    assert_null(thread);
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_scene_get_thread(s.scene, body, NULL));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_scene_get_thread(NULL, body, &thread));
    assert_int_equal(piece, 77);
    assert_true(small_hash(&s) == hash);
    assert_int_equal(step_events_of(s.scene).count, 0);
    small_end(&s);
}

/* ---- what holds a node goes with it */

static void pins_and_attachments_move_with_nodes(void **state)
{
    (void)state;
    for (int k = 0; k < 3; k++) { /* within a segment; at a free node; at the node of the weld */
        const double arcs[] = {9.4e-3, 10e-3, 12e-3};
        small s;
        vbss_thread *thread, *piece;
        vbss_thread_attachment a;
        uint32_t spring, mass;
        small_begin_scene(&s);
        uint32_t body = line(&s, 1, &thread);
        uint32_t ball =
            small_stick(&s, VBSS_SCENE_RIGID_FREE, vec3_make(0.012, 2e-3, 0.0), vec3_zero(), 1e-3);
        uint32_t pins[3] = {small_pin(&s, body, 2, 0), small_pin(&s, body, 12, ball),
                            small_pin(&s, body, 19, 0)};
        expect_ok(vbss_thread_attachment_init(&a, sizeof a));
        a.kind = VBSS_THREAD_ATTACHMENT_SPRING;
        a.node = 16;
        a.stiffness = 5.0;
        a.position[0] = 0.016;
        a.position[1] = 1e-3;
        expect_ok(vbss_thread_attach(thread, &a, &spring));
        a.kind = VBSS_THREAD_ATTACHMENT_MASS;
        a.node = 5;
        a.mass = 1e-5;
        expect_ok(vbss_thread_attach(thread, &a, &mass));
        small_steps(&s, 5, 1e-3);
        uint32_t number = cut_at(&s, body, arcs[k], &piece);
        scene_object *o = small_object(&s);
        cut_expect_sound(o);
        uint32_t shift = k == 0 ? 9 : k == 1 ? 10 : 12;
        const scene_pin *p = o->pins;
        assert_true(p[0].id == pins[0] && p[0].thread == body && p[0].node == 2);
        bool stays = k == 2;
        assert_true(p[1].id == pins[1] && p[1].thread == (stays ? body : number) &&
                    p[1].node == (stays ? 12 : 12 - shift));
        assert_true(p[2].id == pins[2] && p[2].thread == number && p[2].node == 19 - shift);
        vec3 held = small_node(piece, 19 - shift);
        small_steps(&s, 50, 1e-3);
        cut_expect_sound(o);
        assert_true(vec3_distance(held, small_node(piece, 19 - shift)) < 1e-12);
        const double there[3] = {0.016, -1e-3, 0.0};
        expect_ok(vbss_thread_set_attachment_target(piece, spring, there, NULL));
        expect_result(VBSS_ERROR_NOT_FOUND,
                      vbss_thread_set_attachment_target(thread, spring, there, NULL));
        expect_ok(vbss_thread_detach(thread, mass));
        for (int i = 0; i < 3; i++) {
            expect_ok(vbss_scene_unpin_thread(s.scene, pins[i]));
        }
        small_steps(&s, 5, 1e-3);
        cut_expect_sound(o);
        small_end(&s);
    }
}

/* ---- the ends */

static void cut_ends_do_not_repel_until_separated(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        small s;
        vbss_thread *thread, *piece;
        small_begin_scene(&s);
        uint32_t body = line(&s, 1, &thread);
        small_steps(&s, 1, 1e-3);
        uint32_t number = cut_at(&s, body, k == 0 ? 10.3e-3 : 10e-3, &piece);
        small_steps(&s, 50, 1e-3);
        scene_object *o = small_object(&s);
        const thread_object *t = cut_thread(o, body), *u = cut_thread(o, number);
        assert_int_equal(vbss_scene_body(o, number)->thread.cut_from, body);
        for (uint32_t i = 0; i < t->node_count; i++) {
            assert_true(vec3_norm(t->now.v[i]) < 1e-9);
        }
        assert_true(vec3_norm(vec3_sub(t->now.x[t->node_count - 1], u->now.x[0])) < 1e-9);
        assert_int_equal(small_statistics(&s).contacts, 0);
        assert_int_equal(small_statistics(&s).clamped, 0);

        /* The piece goes up, and comes down again: now it stops. */
        uint32_t tool =
            small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.03, 0.0, 0.0), vec3_zero(), 1e-3);
        (void)small_pin(&s, number, u->node_count - 1, tool);
        (void)small_pin(&s, number, u->node_count - 2, tool);
        (void)small_pin(&s, body, 0, 0);
        (void)small_pin(&s, body, 1, 0);
        for (int i = 1; i <= 60; i++) {
            small_move(&s, tool, vec3_make(0.03, 2e-5 * i, 0.0));
            small_steps(&s, 1, 1e-3);
        }
        assert_int_equal(vbss_scene_body(o, number)->thread.cut_from, 0);
        for (int i = 1; i <= 40; i++) {
            small_move(&s, tool, vec3_make(0.03 - 1e-4 * i, 1.2e-3, 0.0));
            small_steps(&s, 1, 1e-3);
        }
        for (int i = 1; i <= 90; i++) {
            small_move(&s, tool, vec3_make(0.026, 1.2e-3 - 2e-5 * i, 0.0));
            small_steps(&s, 1, 1e-3);
        }
        small_steps(&s, 50, 1e-3);
        double end = t->now.x[t->node_count - 1].y;
        assert_true(small_statistics(&s).contacts > 0);
        assert_true(u->now.x[0].y > end); /* and did not pass */
        cut_expect_sound(o);
        small_end(&s);
    }
}

/* Exactly the pairs that did not touch before do not now. */
static void contact_exclusion_survives_cut(void **state)
{
    (void)state;
    double lengths[60];
    for (int i = 0; i < 60; i++) {
        lengths[i] = 0.97e-4 * (1 + i * 7 % 5); /* exclusion is 4e-4 */
    }
    for (int k = 0; k < 40; k++) {
        small s;
        uint8_t excluded[60][60];
        vbss_thread *thread;
        uint32_t body;
        thread_cut cut;
        small_begin_scene(&s);
        s.thread.cut_capacity = 1;
        s.thread.rest_lengths = lengths;
        s.thread.segment_count = 60;
        expect_ok(vbss_thread_create(s.context, &s.thread, &thread));
        expect_ok(vbss_scene_add_thread(s.scene, thread, &body));
        scene_object *o = small_object(&s);
        const scene_body *b = vbss_scene_body(o, body);
        const collision_shape *shape = o->collision->shapes[b->shape];
        for (uint32_t i = 0; i < 60; i++) {
            for (uint32_t j = i + 1; j < 60; j++) {
                excluded[i][j] = i >= shape->far_before[j];
            }
        }
        double arc = 3e-4 + 4.37e-4 * k;
        arc = k % 4 == 0 ? 1e-4 * floor(1e4 * arc) : arc;
        assert_true(vbss_thread_locate_cut(b->thread.thread, arc, &cut));
        const scene_body *piece = vbss_scene_body(o, cut_at(&s, body, arc, NULL));
        uint32_t old = b->thread.thread->node_count - 1;
        for (uint32_t i = 0; i < old; i++) {
            for (uint32_t j = 0; j + 1 < piece->thread.thread->node_count; j++) {
                bool same = i == j + cut.node_shift; /* both are of the divided one */
                bool wanted = same || excluded[i][j + cut.node_shift];
                assert_int_equal(vbss_scene_is_excluded_across_cut(o, b, i, piece, j), wanted);
                assert_int_equal(vbss_scene_is_excluded_across_cut(o, piece, j, b, i), wanted);
            }
        }
        small_end(&s);
    }
}

static void cut_ends_do_not_repel_in_paper_scene(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        small s;
        small_begin(&s);
        s.config.method = s.thread.method = VBSS_METHOD_VBLAST;
        small_create(&s);
        uint32_t body = line(&s, 1, NULL);
        small_steps(&s, 1, 1e-3);
        uint32_t number = cut_at(&s, body, k == 0 ? 10.3e-3 : 10e-3, NULL);
        small_steps(&s, 20, 1e-3);
        const thread_object *t = cut_thread(small_object(&s), body);
        const thread_object *u = cut_thread(small_object(&s), number);
        assert_true(vec3_distance(t->now.x[t->node_count - 1], u->now.x[0]) < 1e-9);
        assert_int_equal(small_statistics(&s).contacts, 0);
        small_end(&s);
    }
}

/* Stretched by hands to 5 N and cut: the ends fly back, lose what they had, and nothing blows up. */
static void taut_ends_recoil_and_come_to_rest(void **state)
{
    (void)state;
    for (int k = 0; k < 8; k++) {
        const double arcs[] = {10.4e-3, 10e-3, 0.3e-3, 19e-3};
        small s;
        vbss_thread *thread, *piece;
        small_begin(&s);
        s.config.mode = k < 4 ? VBSS_SCENE_MODE_REAL_TIME : VBSS_SCENE_MODE_OFFLINE;
        small_create(&s);
        uint32_t body = line(&s, 1, &thread);
        /* beside it, so that something may be hit */
        small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.006, 1.2e-3, 0.0),
                    vec3_make(0.0, 0.0, 3e-3), 1e-3);
        uint32_t hand =
            small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.03, 0.0, 0.0), vec3_zero(), 1e-3);
        (void)small_pin(&s, body, 0, 0);
        (void)small_pin(&s, body, 20, hand);
        double stretch = 0.02 * 5.0 / s.thread.axial_stiffness;
        for (int i = 1; i <= 100; i++) {
            small_move(&s, hand, vec3_make(0.03 + 0.01 * stretch * i, 0.0, 0.0));
            small_steps(&s, 1, 1e-3);
        }
        expect_near(5.0, small_tension(thread, 10), 0.01);
        scene_object *o = small_object(&s);
        double energy = cut_energy(o), first = energy;
        (void)cut_at(&s, body, arcs[k % 4], &piece);
        cut_expect_sound(o);
        assert_true(cut_energy(o) <= energy * (1.0 + 1e-12));
        for (int i = 0; i < 300; i++) {
            small_steps(&s, 1, 1e-3);
            cut_expect_sound(o);
            double now = cut_energy(o);
            assert_true(now <= 1.001 * energy + 1e-12);
            energy = vbss_min(now, energy);
        }
        assert_true(energy < 0.01 * first);
        assert_true(fabs(small_tension(thread, 0)) < 1e-3);
        assert_true(fabs(small_tension(piece, 0)) < 1e-3);
        small_end(&s);
    }
}

/* ---- again and again */

static void pieces_can_be_cut_again(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    small_begin(&s);
    s.config.thread_capacity = 9;
    small_create(&s);
    uint32_t body = line(&s, 8, &thread), bodies[9] = {body};
    for (uint32_t k = 1; k <= 8; k++) { /* the longest of them, near its middle */
        uint32_t longest = 0;
        for (uint32_t i = 1; i < k; i++) {
            longest = cut_length(cut_thread(small_object(&s), bodies[i])) >
                              cut_length(cut_thread(small_object(&s), bodies[longest]))
                          ? i
                          : longest;
        }
        double length = cut_length(cut_thread(small_object(&s), bodies[longest]));
        bodies[k] = cut_at(&s, bodies[longest], 0.48 * length, NULL);
        assert_int_equal(bodies[k], body + k);
        cut_expect_sound(small_object(&s));
        small_steps(&s, 3, 1e-3);
        assert_int_equal(small_statistics(&s).contacts, 0);
    }
    double sum = 0.0;
    for (uint32_t i = 0; i < 9; i++) {
        sum += cut_length(cut_thread(small_object(&s), bodies[i]));
    }
    expect_near(0.02, sum, 1e-15);
    small_end(&s);
}

/* Nearer to each other than what does not touch: the middle piece is all within. */
static void close_cuts_do_not_repel(void **state)
{
    (void)state;
    const double arcs[][2] = {
        {10e-3, 10.3e-3}, {10.3e-3, 10e-3}, {10.1e-3, 10.2e-3}, {10.2e-3, 10.1e-3}};
    for (int k = 0; k < 4; k++) {
        small s;
        small_begin_scene(&s);
        uint32_t body = line(&s, 2, NULL), first = cut_at(&s, body, arcs[k][0], NULL);
        bool beyond = arcs[k][1] > arcs[k][0];
        (void)cut_at(&s, beyond ? first : body, arcs[k][1] - (beyond ? arcs[k][0] : 0.0), NULL);
        small_steps(&s, 20, 1e-3);
        assert_int_equal(small_statistics(&s).contacts, 0);
        scene_object *o = small_object(&s);
        for (uint32_t i = 0; i < o->body_count; i++) {
            assert_true(vec3_norm(o->bodies[i].thread.thread->now.v[0]) < 1e-9);
        }
        small_end(&s);
    }
}

int test_cuts(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(part_beyond_cut_is_a_new_body),
        cmocka_unit_test(cut_at_end_does_nothing),
        cmocka_unit_test(pins_and_attachments_move_with_nodes),
        cmocka_unit_test(cut_ends_do_not_repel_until_separated),
        cmocka_unit_test(contact_exclusion_survives_cut),
        cmocka_unit_test(cut_ends_do_not_repel_in_paper_scene),
        cmocka_unit_test(taut_ends_recoil_and_come_to_rest),
        cmocka_unit_test(pieces_can_be_cut_again),
        cmocka_unit_test(close_cuts_do_not_repel),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
