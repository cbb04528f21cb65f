/* What a scene shows of its contacts, and that it adds up to what bodies feel. */
#include "scene/small.h"

/* ---- sizes */

static void expect_shape(const small *s, vbss_scene_field field, vbss_view_type type,
                         uint32_t components)
{
    vbss_view v = small_view(s, field);
    size_t item = components * (type == VBSS_VIEW_TYPE_F64 ? sizeof(double) : sizeof(uint32_t));
    assert_int_equal(v.struct_size, sizeof v);
    assert_int_equal(v.type, type);
    assert_int_equal(v.components, components);
    assert_true(v.stride_bytes >= item);
    assert_non_null(v.data);
    assert_int_equal(v.count, small_statistics(s).contacts);
}

static void expect_shapes(const small *s)
{
    expect_shape(s, VBSS_SCENE_VIEW_CONTACTS, VBSS_VIEW_TYPE_U32, 5);
    expect_shape(s, VBSS_SCENE_VIEW_CONTACT_POINTS, VBSS_VIEW_TYPE_F64, 3);
    expect_shape(s, VBSS_SCENE_VIEW_CONTACT_NORMALS, VBSS_VIEW_TYPE_F64, 3);
    expect_shape(s, VBSS_SCENE_VIEW_CONTACT_FORCES, VBSS_VIEW_TYPE_F64, 3);
    expect_shape(s, VBSS_SCENE_VIEW_CONTACT_GAPS, VBSS_VIEW_TYPE_F64, 1);
}

/* ---- one scene with a contact of each kind */

enum { FINE = 1, STICK, COARSE, BALL, OTHER, CROSSING };

/* A fine thread lies over a free stick and on the floor, a coarse one over the fine one and a thin stick;
 * a ball lies on the stick. */
static void begin_all_kinds(small *s)
{
    small_begin(s);
    s->config.floor = 1;
    s->config.node_capacity = 300;
    small_create(s);
    s->thread.gravity[1] = s->rigid.gravity[1] = -9.81;
    s->rigid.mass = 1e-4;
    const double r = 0.125e-3, y = 1e-3;
    small_thread(s, vec3_make(-9e-3, 2.0 * y + 1.02 * r, 0.0),
                 vec3_make(9e-3, 2.0 * y + 1.02 * r, 0.0), 60, NULL);
    small_stick(s, VBSS_SCENE_RIGID_FREE, vec3_make(0.0, y, 0.0), vec3_make(0.0, 0.0, 6e-3), y);
    small_thread(s, vec3_make(4e-3, 2.0 * y + 3.3 * r, -6e-3),
                 vec3_make(4e-3, 2.0 * y + 3.3 * r, 6e-3), 4, NULL);
    small_stick(s, VBSS_SCENE_RIGID_FREE, vec3_make(1e-4, 2.0 * y + y, 4e-3), vec3_zero(), y);
    small_stick(s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(4e-3, y, -5e-3), vec3_make(2e-3, 0.0, 0.0),
                5e-4);
}

static void every_contact_kind_is_shown(void **state)
{
    (void)state;
    small s;
    uint32_t seen[6] = {0};
    begin_all_kinds(&s);
    expect_shapes(&s);
    assert_int_equal(small_view(&s, VBSS_SCENE_VIEW_CONTACTS).count, 0);
    for (int i = 0; i < 60; i++) {
        small_steps(&s, 1, 1e-3);
        expect_shapes(&s);
        vbss_view v = small_view(&s, VBSS_SCENE_VIEW_CONTACTS);
        for (uint64_t k = 0; k < v.count; k++) {
            uint32_t f[5];
            memcpy(f, (const char *)v.data + k * v.stride_bytes, sizeof f);
            assert_true(f[0] <= VBSS_SCENE_CONTACT_CAPSULE_FLOOR);
            seen[f[0]]++;
        }
    }
    for (int kind = 0; kind < 6; kind++) {
        if (seen[kind] == 0) {
            fail_msg("no contact of kind %d", kind);
        }
    }
    assert_int_equal(small_statistics(&s).clamped, 0);
    small_end(&s);
}

/* ---- what is shown is sound */

static bool is_thread(uint32_t body)
{
    return body == FINE || body == COARSE;
}

static void check_features(const uint32_t f[5], const scene_object *object)
{
    const uint32_t segments[6] = {0, 60, 0, 4, 0, 0};
    bool floor = f[0] == VBSS_SCENE_CONTACT_NODE_FLOOR || f[0] == VBSS_SCENE_CONTACT_CAPSULE_FLOOR;
    assert_int_equal(is_thread(f[1]), f[0] != VBSS_SCENE_CONTACT_CAPSULES &&
                                          f[0] != VBSS_SCENE_CONTACT_CAPSULE_FLOOR);
    assert_int_equal(f[3] == 0, floor);
    assert_true(!floor || f[4] == 0);
    if (f[0] == VBSS_SCENE_CONTACT_SEGMENTS) {
        assert_true(f[2] < segments[f[1]] && f[4] < segments[f[3]]);
    } else if (is_thread(f[1])) {
        assert_true(f[2] <= segments[f[1]]);
    } else {
        assert_true(f[2] <= 1 && f[4] <= 1);
    }
    assert_non_null(vbss_scene_body(object, f[1]));
}

static void contacts_are_consistent(void **state)
{
    (void)state;
    small s;
    begin_all_kinds(&s);
    for (int i = 0; i < 60; i++) {
        small_steps(&s, 1, 1e-3);
        vbss_view v = small_view(&s, VBSS_SCENE_VIEW_CONTACTS);
        uint32_t before[5] = {0};
        double largest = 0.0;
        for (uint64_t k = 0; k < v.count; k++) {
            vec3 force = small_vector(&s, VBSS_SCENE_VIEW_CONTACT_FORCES, k);
            largest = vbss_max(vec3_norm(force), largest);
        }
        for (uint64_t k = 0; k < v.count; k++) {
            uint32_t f[5];
            memcpy(f, (const char *)v.data + k * v.stride_bytes, sizeof f);
            vec3 normal = small_vector(&s, VBSS_SCENE_VIEW_CONTACT_NORMALS, k);
            vec3 force = small_vector(&s, VBSS_SCENE_VIEW_CONTACT_FORCES, k);
            double pressure = vec3_dot(force, normal);
            double rubbing = vec3_norm(vec3_add_scaled(force, -pressure, normal));
            const double *gap =
                (const double *)small_view(&s, VBSS_SCENE_VIEW_CONTACT_GAPS).data + k;
            check_features(f, small_object(&s));
            expect_near(1.0, vec3_norm(normal), 1e-12);
            assert_true(pressure > 0.0);
            assert_true(rubbing <= 0.3 * pressure + 0.05 * largest); /* as much may be loose */
            expect_near(-pressure / 2e5, *gap, 2e-7);
            assert_true(k == 0 || memcmp(before, f, sizeof f) != 0);
            memcpy(before, f, sizeof f);
            if (f[0] == VBSS_SCENE_CONTACT_CAPSULE_FLOOR || f[0] == VBSS_SCENE_CONTACT_NODE_FLOOR) {
                vec3 point = small_vector(&s, VBSS_SCENE_VIEW_CONTACT_POINTS, k);
                expect_near(0.5 * *gap, point.y, 1e-9); /* between the surfaces */
                expect_near(1.0, normal.y, 0.0);
            }
        }
    }
    small_end(&s);
}

static void contact_forces_sum_to_body_forces(void **state)
{
    (void)state;
    small s;
    begin_all_kinds(&s);
    for (int i = 0; i < 60; i++) {
        small_steps(&s, 1, 1e-3);
        vbss_view v = small_view(&s, VBSS_SCENE_VIEW_CONTACTS);
        for (uint32_t body = STICK; body <= OTHER; body++) {
            vec3 sum = vec3_zero(), moment = vec3_zero();
            if (is_thread(body)) {
                continue;
            }
            vbss_scene_rigid_state r = small_rigid(&s, body);
            for (uint64_t k = 0; k < v.count; k++) {
                uint32_t f[5];
                memcpy(f, (const char *)v.data + k * v.stride_bytes, sizeof f);
                double sign = f[1] == body ? 1.0 : f[3] == body ? -1.0 : 0.0;
                vec3 force = small_vector(&s, VBSS_SCENE_VIEW_CONTACT_FORCES, k);
                vec3 arm = vec3_sub(small_vector(&s, VBSS_SCENE_VIEW_CONTACT_POINTS, k),
                                    vec3_load(r.position));
                sum = vec3_add_scaled(sum, sign, force);
                moment = vec3_add_scaled(moment, sign, vec3_cross(arm, force));
            }
            double scale = 1e-12 + vec3_norm(sum);
            expect_near(0.0, vec3_distance(sum, vec3_load(r.contact_force)), 1e-9 * scale);
            expect_near(0.0, vec3_distance(moment, vec3_load(r.contact_torque)), 1e-9 * scale);
            vec3 hand = body == OTHER ? sum : vec3_zero();
            expect_near(0.0, vec3_distance(hand, vec3_load(r.hand_force)), 1e-9 * scale);
        }
    }
    small_end(&s);
}

/* Newton: what the floor bears is the weight, once all is at rest. */
static void floor_carries_weight(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    s.config.floor = 1;
    small_create(&s);
    s.thread.gravity[1] = s.rigid.gravity[1] = -9.81;
    s.thread.drag = 50.0;
    small_thread(&s, vec3_make(-9e-3, 2e-4, 0.0), vec3_make(9e-3, 2e-4, 0.0), 20, NULL);
    small_stick(&s, VBSS_SCENE_RIGID_FREE, vec3_make(0.0, 2e-3, 8e-3), vec3_make(4e-3, 0.0, 0.0),
                1e-3);
    small_steps(&s, 400, 1e-3);
    double weight = (0.02 + 6.4e-5 * 0.018) * 9.81, borne = 0.0;
    vbss_view v = small_view(&s, VBSS_SCENE_VIEW_CONTACT_FORCES);
    for (uint64_t k = 0; k < v.count; k++) {
        borne += small_vector(&s, VBSS_SCENE_VIEW_CONTACT_FORCES, k).y;
    }
    expect_near(weight, borne, 1e-4 * weight);
    small_end(&s);
}

/* Where two segments of each thread meet in a node there are four pairs, and one contact. */
static void node_contact_is_single(void **state)
{
    (void)state;
    small s;
    small_begin_scene(&s);
    const double y = 0.2499e-3;
    small_thread(&s, vec3_make(-8e-3, y, 0.0), vec3_make(8e-3, y, 0.0), 16, NULL);
    small_thread(&s, vec3_make(0.0, 0.0, -8e-3), vec3_make(0.0, 0.0, 8e-3), 16, NULL);
    small_steps(&s, 1, 1e-3);
    assert_int_equal(small_statistics(&s).contacts, 1);
    vec3 normal = small_vector(&s, VBSS_SCENE_VIEW_CONTACT_NORMALS, 0);
    expect_near(1.0, normal.y, 1e-9);
    small_end(&s);
}

/* Near other things, and a few steps after, motion is damped; and only then. */
static void near_thread_is_damped(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    vbss_thread_statistics last, now;
    small_begin(&s);
    s.config.floor = 1;
    small_create(&s);
    uint32_t line =
        small_thread(&s, vec3_make(-9e-3, 1.3e-4, 0.0), vec3_make(9e-3, 1.3e-4, 0.0), 20, &thread);
    uint32_t stick =
        small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(-9e-3, 1.3e-4, 0.0), vec3_zero(), 1e-4);
    small_pin(&s, line, 0, stick);
    uint32_t other =
        small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(9e-3, 1.3e-4, 0.0), vec3_zero(), 1e-4);
    small_pin(&s, line, 20, other);
    uint64_t damped = 0;
    for (int i = 0; i < 60; i++) {
        expect_ok(vbss_thread_get_statistics(thread, &last, sizeof last));
        double y = 1.3e-4 + 2e-5 * vbss_max(i - 20, 0.0); /* it is lifted off */
        small_move(&s, stick, vec3_make(-9e-3, y, 0.0));
        small_move(&s, other, vec3_make(9e-3, y, 0.0));
        small_steps(&s, 1, 1e-3);
        expect_ok(vbss_thread_get_statistics(thread, &now, sizeof now));
        bool first_order = now.first_order > last.first_order, near = small_statistics(&s).rows > 0;
        assert_true(first_order || !near);
        damped += first_order && !near;
    }
    assert_int_equal(damped, 3);
    small_end(&s);
}

/* ---- generations */

static uint64_t generation(const small *s)
{
    uint64_t g = small_view(s, VBSS_SCENE_VIEW_CONTACTS).generation;
    for (vbss_scene_field k = VBSS_SCENE_VIEW_CONTACT_POINTS; k <= VBSS_SCENE_VIEW_CONTACT_GAPS;
         k++) {
        assert_true(small_view(s, k).generation == g);
    }
    return g;
}

static void generation_changes_with_every_step_and_edit(void **state)
{
    (void)state;
    small s;
    uint8_t bytes[16384];
    uint64_t written;
    uint32_t line = 0, tool = 0, pin = 0;
    small_begin_scene(&s);
    uint64_t g = generation(&s);
    for (int k = 0; k < 9; k++) {
        uint64_t before = g;
        switch (k) {
        case 0:
            line = small_thread(&s, vec3_zero(), vec3_make(0.01, 0.0, 0.0), 5, NULL);
            break;
        case 1:
            tool = small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.0, 0.01, 0.0), vec3_zero(),
                               1e-3);
            break;
        case 2:
            small_move(&s, tool, vec3_make(0.0, 0.011, 0.0));
            break;
        case 3:
            pin = small_pin(&s, line, 0, tool);
            break;
        case 4:
            small_steps(&s, 1, 1e-3);
            break;
        case 5:
            expect_ok(vbss_scene_save(s.scene, bytes, sizeof bytes, &written));
            assert_true(generation(&s) == g);
            expect_ok(vbss_scene_restore(s.scene, bytes, written));
            break;
        case 6:
            expect_ok(vbss_scene_unpin_thread(s.scene, pin));
            break;
        case 7:
            expect_ok(vbss_scene_remove(s.scene, tool));
            break;
        default:
            expect_ok(vbss_scene_remove(s.scene, line));
        }
        g = generation(&s);
        assert_true(g != before);
        (void)small_hash(&s);
        (void)small_statistics(&s);
        expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_step(s.scene, 1.0));
        assert_true(generation(&s) == g);
    }
    small_end(&s);
}

int test_scene_views(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_contact_kind_is_shown),
        cmocka_unit_test(contacts_are_consistent),
        cmocka_unit_test(contact_forces_sum_to_body_forces),
        cmocka_unit_test(floor_carries_weight),
        cmocka_unit_test(node_contact_is_single),
        cmocka_unit_test(near_thread_is_damped),
        cmocka_unit_test(generation_changes_with_every_step_and_edit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
