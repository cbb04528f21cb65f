/* Every bad number and NULL of the configurations of scenes and rigid bodies: its status, and that nothing has
 * changed. */
#include "scene/small_subject.h"

/* ---- configurations */

typedef struct number {
    size_t offset;
    double low, high;
} number;

#define SCENE(field, low, high)                           \
    {                                                     \
        offsetof(vbss_scene_config, field), (low), (high) \
    }
#define RIGID(field, low, high)                                 \
    {                                                           \
        offsetof(vbss_scene_rigid_config, field), (low), (high) \
    }

static const number scene_numbers[] = {
    SCENE(floor_height, -1e3, 1e3),
    SCENE(floor_friction, 0.0, 10.0),
    SCENE(thread_friction, 0.0, 10.0),
    SCENE(contact_stiffness, 1e3, 1e9),
};

static const number rigid_numbers[] = {
    RIGID(position[0], -1e3, 1e3),    RIGID(position[2], -1e3, 1e3),
    RIGID(velocity[1], -1e5, 1e5),    RIGID(angular_velocity[2], -1e6, 1e6),
    RIGID(gravity[1], -1e6, 1e6),     RIGID(mass, 1e-9, 1e3),
    RIGID(friction, 0.0, 10.0),       RIGID(stiffness, 0.0, 1e9),
    RIGID(damping, 0.0, 1e6),         RIGID(turning_stiffness, 0.0, 1e9),
    RIGID(turning_damping, 0.0, 1e6),
};

typedef struct choice {
    size_t offset;
    uint32_t high, bad; /* the highest that is good: 0 if it is not tried */
} choice;

static const choice scene_choices[] = {
    {offsetof(vbss_scene_config, method), 1, 2},
    {offsetof(vbss_scene_config, method), 1, UINT32_MAX},
    {offsetof(vbss_scene_config, mode), 1, 2},
    {offsetof(vbss_scene_config, mode), 1, UINT32_MAX},
    {offsetof(vbss_scene_config, thread_capacity), 64, 65},
    {offsetof(vbss_scene_config, node_capacity), 0, 8193},
    {offsetof(vbss_scene_config, node_capacity), 0, UINT32_MAX},
    {offsetof(vbss_scene_config, rigid_capacity), 256, 257},
    {offsetof(vbss_scene_config, capsule_capacity), 4096, 4097},
    {offsetof(vbss_scene_config, pin_capacity), 256, 257},
    {offsetof(vbss_scene_config, contact_capacity), 65536, 65537},
    {offsetof(vbss_scene_config, candidate_capacity), 0, 10000001},
    {offsetof(vbss_scene_config, event_capacity), 65536, 65537},
    {offsetof(vbss_scene_config, floor), 1, 2},
    {offsetof(vbss_scene_config, grasp_capacity), 256, 257},
    {offsetof(vbss_scene_config, drain_capacity), 16, 17},
    {offsetof(vbss_scene_config, hole_capacity), 256, 257},
};

static void expect_scene(small *s, vbss_result wanted)
{
    vbss_scene *scene = (vbss_scene *)s->context;
    vbss_context_statistics before, after;
    expect_ok(vbss_context_get_statistics(s->context, &before, sizeof before));
    vbss_result result = vbss_scene_create(s->context, &s->config, &scene);
    expect_result(wanted, result);
    if (result == VBSS_OK) { /* what can be made can be stepped */
        expect_ok(vbss_scene_step(scene, 1e-3));
        expect_ok(vbss_scene_destroy(scene));
        return;
    }
    assert_null(scene);
    expect_ok(vbss_context_get_statistics(s->context, &after, sizeof after));
    assert_int_equal(before.bytes_allocated, after.bytes_allocated);
    assert_int_equal(before.objects_created, after.objects_created);
}

typedef void (*expect_config)(small *s, vbss_result wanted);

static void with_number(small *s, void *config, size_t offset, double value, expect_config expect,
                        vbss_result wanted)
{
    double kept;
    memcpy(&kept, (char *)config + offset, sizeof kept);
    memcpy((char *)config + offset, &value, sizeof value);
    expect(s, wanted);
    memcpy((char *)config + offset, &kept, sizeof kept);
}

static void try_number(small *s, void *config, const number *n, expect_config expect)
{
    double step = 1e-6 * (fabs(n->low) > 0.0 ? fabs(n->low) : 1.0);
    for (int k = 0; k < 3; k++) {
        with_number(s, config, n->offset, harness_bad_numbers[k], expect, VBSS_ERROR_NOT_FINITE);
    }
    with_number(s, config, n->offset, n->low - step, expect, VBSS_ERROR_OUT_OF_RANGE);
    with_number(s, config, n->offset, n->high * (1.0 + 1e-6), expect, VBSS_ERROR_OUT_OF_RANGE);
    with_number(s, config, n->offset, -DBL_MAX, expect, VBSS_ERROR_OUT_OF_RANGE);
    with_number(s, config, n->offset, DBL_MAX, expect, VBSS_ERROR_OUT_OF_RANGE);
    with_number(s, config, n->offset, n->low, expect, VBSS_OK);
    with_number(s, config, n->offset, n->high, expect, VBSS_OK);
}

static void bad_scene_numbers_are_rejected(void **state)
{
    (void)state;
    small s;
    tiny_scene(&s);
    for (size_t i = 0; i < sizeof scene_numbers / sizeof scene_numbers[0]; i++) {
        try_number(&s, &s.config, &scene_numbers[i], expect_scene);
    }
    for (size_t c = 0; c < 3; c++) {
        size_t offset = offsetof(vbss_scene_config, floor_normal) + c * sizeof(double);
        for (int k = 0; k < 3; k++) {
            with_number(&s, &s.config, offset, harness_bad_numbers[k], expect_scene,
                        VBSS_ERROR_NOT_FINITE);
        }
        with_number(&s, &s.config, offset, 1e101, expect_scene, VBSS_ERROR_OUT_OF_RANGE);
        with_number(&s, &s.config, offset, 1e99, expect_scene, VBSS_OK);
        with_number(&s, &s.config, offset, c == 1 ? 0.0 : 1.0, expect_scene,
                    c == 1 ? VBSS_ERROR_OUT_OF_RANGE : VBSS_OK);
    }
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_scene_create(s.context, &s.config, NULL));
    small_end(&s);
}

static void bad_scene_choices_are_rejected(void **state)
{
    (void)state;
    small s;
    tiny_scene(&s);
    for (size_t i = 0; i < sizeof scene_choices / sizeof scene_choices[0]; i++) {
        const choice *c = &scene_choices[i];
        vbss_scene_config kept = s.config;
        memcpy((char *)&s.config + c->offset, &c->bad, sizeof c->bad);
        expect_scene(&s, VBSS_ERROR_OUT_OF_RANGE);
        s.config = kept;
        memcpy((char *)&s.config + c->offset, &c->high, sizeof c->high);
        expect_scene(&s, VBSS_OK);
        s.config = kept;
    }
    /* Room for nothing is a scene too. */
    s.config.thread_capacity = s.config.rigid_capacity = s.config.node_capacity = 0;
    s.config.capsule_capacity = s.config.pin_capacity = s.config.event_capacity = 0;
    s.config.contact_capacity = s.config.candidate_capacity = 0;
    s.config.floor = 1;
    expect_scene(&s, VBSS_OK);
    small_end(&s);
}

/* The most that is documented can be had. */
static void maximum_node_count_is_accepted(void **state)
{
    (void)state;
    small s;
    tiny_scene(&s);
    s.config.node_capacity = 8192;
    vbss_result result = vbss_scene_create(s.context, &s.config, &s.scene);
    assert_true(result == VBSS_OK || result == VBSS_ERROR_OUT_OF_MEMORY);
    small_end(&s);
}

/* ---- rigid bodies; the scene stays as it was to the bit */

static void expect_rigid(small *s, vbss_result wanted)
{
    uint32_t body = 77;
    subject *t = (subject *)(void *)s; /* its first member */
    vbss_result result = vbss_scene_add_rigid(s->scene, &s->rigid, &body);
    if (wanted != VBSS_OK) {
        unchanged(t, wanted, result);
        assert_int_equal(body, 77);
        return;
    }
    expect_ok(result);
    expect_ok(vbss_scene_remove(s->scene, body));
    t->hash = small_hash(s);
    t->generation = small_view(s, VBSS_SCENE_VIEW_CONTACTS).generation;
}

static void bad_rigid_bodies_are_rejected(void **state)
{
    (void)state;
    subject t;
    begin_subject(&t);
    vbss_scene_rigid_config *c = &t.s.rigid, kept = *c;
    for (size_t i = 0; i < sizeof rigid_numbers / sizeof rigid_numbers[0]; i++) {
        try_number(&t.s, c, &rigid_numbers[i], expect_rigid);
    }
    for (size_t k = 0; k < 4; k++) {
        size_t offset = offsetof(vbss_scene_rigid_config, orientation) + k * sizeof(double);
        with_number(&t.s, c, offset, (double)NAN, expect_rigid, VBSS_ERROR_NOT_FINITE);
        with_number(&t.s, c, offset, 1e101, expect_rigid, VBSS_ERROR_OUT_OF_RANGE);
        with_number(&t.s, c, offset, 1e99, expect_rigid, VBSS_OK);
    }
    with_number(&t.s, c, offsetof(vbss_scene_rigid_config, orientation), 0.0, expect_rigid,
                VBSS_ERROR_OUT_OF_RANGE);
    const int32_t kinds[] = {-1, 3, INT32_MAX, INT32_MIN};
    const uint32_t counts[] = {0, 2, 257, UINT32_MAX}; /* 2: more than the scene has room for */
    for (int k = 0; k < 4; k++) {
        c->kind = kinds[k];
        expect_rigid(&t.s, VBSS_ERROR_OUT_OF_RANGE);
        *c = kept;
        vbss_scene_capsule two[2] = {subject_ball, subject_ball};
        c->capsules = two;
        c->capsule_count = counts[k];
        expect_rigid(&t.s, k == 1 ? VBSS_ERROR_CAPACITY : VBSS_ERROR_OUT_OF_RANGE);
        *c = kept;
    }
    c->reserved = 1;
    expect_rigid(&t.s, VBSS_ERROR_OUT_OF_RANGE);
    *c = kept;
    c->capsules = NULL;
    expect_rigid(&t.s, VBSS_ERROR_NULL_ARGUMENT);
    for (size_t k = 0; k < 7; k++) {
        vbss_scene_capsule bad = subject_ball;
        double *field = &bad.begin[0] + k, good = *field;
        c->capsules = &bad;
        for (int n = 0; n < 3; n++) {
            *field = harness_bad_numbers[n];
            expect_rigid(&t.s, VBSS_ERROR_NOT_FINITE);
        }
        *field = k < 6 ? -1.001e3 : 0.99e-6;
        expect_rigid(&t.s, VBSS_ERROR_OUT_OF_RANGE);
        *field = k < 6 ? 1e3 : 1.0;
        expect_rigid(&t.s, VBSS_OK);
        *field = k < 6 ? good : 1.001;
        expect_rigid(&t.s, k < 6 ? VBSS_OK : VBSS_ERROR_OUT_OF_RANGE);
    }
    *c = kept;
    uint32_t body;
    unchanged(&t, VBSS_ERROR_NULL_ARGUMENT, vbss_scene_add_rigid(t.s.scene, c, NULL));
    unchanged(&t, VBSS_ERROR_NULL_ARGUMENT, vbss_scene_add_rigid(t.s.scene, NULL, &body));
    small_end(&t.s);
}

static const vbss_scene_capsule point = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 1e-3};

static void default_scene(void **state)
{
    (void)state;
    small s;
    uint32_t body = 77;
    small_begin(&s);
    expect_ok(vbss_scene_create(s.context, NULL, &s.scene));
    small_steps(&s, 3, 1e-3); /* of nothing */
    assert_int_equal(small_statistics(&s).steps, 3);
    expect_near(3e-3, small_statistics(&s).time, 1e-18);
    s.rigid.capsules = &point;
    s.rigid.capsule_count = 1;
    for (uint32_t i = 1; i <= 4; i++) {
        expect_ok(vbss_scene_add_rigid(s.scene, &s.rigid, &body));
        assert_int_equal(body, i);
    }
    expect_result(VBSS_ERROR_CAPACITY, vbss_scene_add_rigid(s.scene, &s.rigid, &body));
    assert_int_equal(body, 4);
    small_end(&s);
}

int test_scene_refusals(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_scene_numbers_are_rejected),
        cmocka_unit_test(bad_scene_choices_are_rejected),
        cmocka_unit_test(maximum_node_count_is_accepted),
        cmocka_unit_test(bad_rigid_bodies_are_rejected),
        cmocka_unit_test(default_scene),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
