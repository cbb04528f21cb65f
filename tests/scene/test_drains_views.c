/* What a scene shows of a drain's contacts: which features, where, and that it adds up to what tools feel. */
#include "scene/drains_rig.h"
#include "scene/drains_surface.h"
#include "fixtures/drain_scenes.h"

/* Contacts lie as they were when the part of the step began, and things slide on past each other. */
#define SLID 2e-4

static feature feature_of_thread(const small *s, uint32_t body, uint32_t kind, uint32_t number)
{
    feature g = {.corners = kind == VBSS_SCENE_CONTACT_SIDES ? 2 : 1};
    const scene_body *b = vbss_scene_body(small_object(s), body);
    g.radius = b->thread.thread->config.radius;
    assert_true(number + g.corners <= DRAIN_HANDS_NODES);
    for (uint32_t k = 0; k < g.corners; k++) {
        g.x[k] = b->thread.thread->now.x[number + k];
    }
    return g;
}

static feature feature_of_tool(const small *s, uint32_t body, uint32_t kind, uint32_t number)
{
    feature g = {.corners = kind == VBSS_SCENE_CONTACT_SIDES ? 2 : 1};
    const scene_object *o = small_object(s);
    const scene_rigid *r = &vbss_scene_body(o, body)->rigid;
    const scene_capsule *c = &o->capsules[r->first_capsule];
    g.radius = c->radius;
    assert_true(number < (g.corners == 1 ? 2u : 1u)); /* its ends, or the only capsule */
    for (uint32_t k = 0; k < g.corners; k++) {
        g.x[k] = pose_apply(r->body.now.pose, c->local[number + k]);
    }
    return g;
}

/* ---- all contacts of a step */

typedef struct seen {
    uint32_t tool[2], thread[2], itself[2], floor; /* points and faces; sides */
} seen;

static void note_kind(const small *s, const uint32_t f[5], const surface *drain, seen *was)
{
    uint32_t side = f[0] == VBSS_SCENE_CONTACT_SIDES;
    if (f[0] == VBSS_SCENE_CONTACT_DRAIN_FLOOR) {
        assert_int_equal(f[1], drain->body);
        assert_true(f[3] == 0 && f[4] == 0);
        was->floor++;
        return;
    }
    assert_true(side || f[0] == VBSS_SCENE_CONTACT_POINT_FACE);
    assert_int_equal(f[3], drain->body);
    scene_body_kind kind = vbss_scene_body(small_object(s), f[1])->kind;
    uint32_t *of = kind == SCENE_BODY_RIGID    ? was->tool
                   : kind == SCENE_BODY_THREAD ? was->thread
                                               : was->itself;
    of[side]++;
}

static feature first_feature(const small *s, const uint32_t f[5], const surface *drain)
{
    scene_body_kind kind = vbss_scene_body(small_object(s), f[1])->kind;
    return kind == SCENE_BODY_RIGID    ? feature_of_tool(s, f[1], f[0], f[2])
           : kind == SCENE_BODY_THREAD ? feature_of_thread(s, f[1], f[0], f[2])
                                       : feature_of_drain(drain, f[0], false, f[2]);
}

static bool are_lips(const surface *drain, const uint32_t f[5])
{
    return f[0] == VBSS_SCENE_CONTACT_SIDES && f[1] == drain->body && drain->faces[f[2]] == 1 &&
           drain->faces[f[4]] == 1;
}

/* From the point the normal leads into a, and back into b. */
static void check_contact(const small *s, uint64_t k, const uint32_t f[5], const surface *drain)
{
    vec3 normal = small_vector(s, VBSS_SCENE_VIEW_CONTACT_NORMALS, k);
    vec3 force = small_vector(s, VBSS_SCENE_VIEW_CONTACT_FORCES, k);
    vec3 point = small_vector(s, VBSS_SCENE_VIEW_CONTACT_POINTS, k);
    double gap = ((const double *)small_view(s, VBSS_SCENE_VIEW_CONTACT_GAPS).data)[k];
    double pressure = vec3_dot(force, normal);
    feature a = first_feature(s, f, drain);
    expect_near(1.0, vec3_norm(normal), 1e-12);
    assert_true(pressure > 0.0);
    if (are_lips(drain, f)) { /* which are flat, and as high as the wall */
        feature other = feature_of_drain(drain, f[0], true, f[4]);
        assert_true(fabs(gap) < 2e-4);
        assert_true(distance_of(&a, &other) < 2.5 * drain->radius);
        assert_true(distance_to(&a, point) < 2.0 * drain->radius);
        assert_true(distance_to(&other, point) < 2.0 * drain->radius);
        return;
    }
    vec3 in_a = vec3_add_scaled(point, a.radius + 0.5 * gap, normal);
    expect_near(0.0, distance_to(&a, in_a), SLID);
    if (f[3] == 0) {
        expect_near(1.0, normal.y, 0.0);
        return;
    }
    feature b = feature_of_drain(drain, f[0], true, f[4]);
    vec3 in_b = vec3_add_scaled(point, -b.radius - 0.5 * gap, normal);
    expect_near(0.0, distance_to(&b, in_b), SLID);
    expect_near(distance_of(&a, &b) - a.radius - b.radius, gap, 1e-9);
}

static void check_contacts(const small *s, const surface *drain, seen *was)
{
    vbss_view v = small_view(s, VBSS_SCENE_VIEW_CONTACTS);
    uint32_t last[5] = {0};
    assert_int_equal(v.count, small_statistics(s).contacts);
    for (uint64_t k = 0; k < v.count; k++) {
        uint32_t f[5];
        memcpy(f, (const char *)v.data + k * v.stride_bytes, sizeof f);
        note_kind(s, f, drain, was);
        check_contact(s, k, f, drain);
        assert_true(k == 0 || memcmp(last, f, sizeof f) != 0);
        memcpy(last, f, sizeof f);
    }
}

static void expect_felt(const small *s, uint32_t tool)
{
    vbss_view v = small_view(s, VBSS_SCENE_VIEW_CONTACTS);
    vbss_scene_rigid_state r = small_rigid(s, tool);
    vec3 sum = vec3_zero(), moment = vec3_zero();
    for (uint64_t k = 0; k < v.count; k++) {
        uint32_t f[5];
        memcpy(f, (const char *)v.data + k * v.stride_bytes, sizeof f);
        if (f[1] == tool) {
            vec3 force = small_vector(s, VBSS_SCENE_VIEW_CONTACT_FORCES, k);
            vec3 arm =
                vec3_sub(small_vector(s, VBSS_SCENE_VIEW_CONTACT_POINTS, k), vec3_load(r.position));
            sum = vec3_add(sum, force);
            moment = vec3_add(moment, vec3_cross(arm, force));
        }
    }
    double scale = 1e-12 + vec3_norm(sum);
    expect_near(0.0, vec3_distance(sum, vec3_load(r.contact_force)), 1e-9 * scale);
    expect_near(0.0, vec3_distance(moment, vec3_load(r.contact_torque)), 1e-9 * scale);
}

/* ---- the scenes */

static void tool_and_thread_contacts_are_consistent(void **state)
{
    (void)state;
    small s;
    drain_hands hands;
    seen was = {{0}, {0}, {0}, 0};
    expect_ok(drain_hands_init(&hands));
    vbss_drain *drain = drains_rig_begin(&s, &hands);
    for (int i = 0; i < 300; i++) {
        drains_rig_steps(&s, 1);
        const surface f = surface_view(DRAIN_HANDS_DRAIN, drain, hands.drain_config.thickness);
        check_contacts(&s, &f, &was);
        expect_felt(&s, DRAIN_HANDS_TOOL);
    }
    assert_true(was.tool[0] > 0 && was.tool[1] > 0);
    assert_true(was.thread[0] + was.thread[1] > 0);
    small_end(&s);
}

/* Both marks are drawn together until the edges of the slit press on each other. */
static void self_contacts_are_consistent(void **state)
{
    (void)state;
    small s;
    drain_scene closing;
    uint32_t body;
    seen was = {{0}, {0}, {0}, 0};
    small_begin_scene(&s);
    expect_ok(drain_scene_config(DRAIN_SCENE_CLOSED, &s.drain));
    expect_ok(drain_scene_create(s.context, DRAIN_SCENE_CLOSED, &s.drain, &closing));
    expect_ok(vbss_scene_add_drain(s.scene, closing.drain, &body));
    for (int i = 0; i < 200; i++) {
        expect_ok(drain_scene_drive(&closing, 1e-3));
        small_steps(&s, 1, 1e-3);
        const surface f = surface_view(body, closing.drain, s.drain.thickness);
        check_contacts(&s, &f, &was);
    }
    assert_true(was.itself[0] + was.itself[1] > 0);
    small_end(&s);
}

/* Off its block and on the floor. */
static void floor_contacts_are_consistent(void **state)
{
    (void)state;
    small s;
    vbss_drain *drain;
    seen was = {{0}, {0}, {0}, 0};
    small_begin(&s);
    s.config.floor = 1;
    s.config.floor_height = -7.2e-3;
    s.drain.tear_stress = 1.0;
    s.drain.gravity[1] = -9.81;
    small_create(&s);
    uint32_t body = small_drain(&s, &drain);
    for (int i = 0; i < 150; i++) {
        small_steps(&s, 1, 1e-3);
        const surface f = surface_view(body, drain, s.drain.thickness);
        check_contacts(&s, &f, &was);
    }
    assert_true(was.floor > 0);
    small_end(&s);
}

int test_drains_views(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tool_and_thread_contacts_are_consistent),
        cmocka_unit_test(self_contacts_are_consistent),
        cmocka_unit_test(floor_contacts_are_consistent),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
