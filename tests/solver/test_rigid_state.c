#include <math.h>
#include <string.h>

#include "base/rotation.h"
#include "solver/rigid_rig.h"

enum { ROOM = 1024, TAG = 50 };

typedef struct saved {
    uint8_t bytes[ROOM];
    size_t count;
} saved;

static saved save(vbss_rigid *body)
{
    saved s;
    vbss_stream stream;
    vbss_stream_begin_measure(&stream);
    vbss_rigid_serialise(&stream, TAG, body);
    size_t measured = stream.position;
    vbss_stream_begin_write(&stream, s.bytes, sizeof s.bytes);
    vbss_rigid_serialise(&stream, TAG, body);
    expect_ok(stream.result);
    assert_int_equal(stream.tag, TAG + VBSS_SCENE_RIGID_TAGS - 1);
    s.count = stream.position;
    assert_int_equal(measured, s.count);
    return s;
}

static vbss_result load(vbss_rigid *body, const saved *s, bool trusted)
{
    vbss_stream stream;
    vbss_stream_begin_read(&stream, s->bytes, s->count);
    stream.trusted = trusted;
    vbss_rigid_serialise(&stream, TAG, body);
    return stream.result;
}

static void begin_moving(rigid_rig *rig)
{
    rigid_rig_begin(rig, VBSS_ROLE_INTERIOR);
    rig->rounds = 2;
    rig->body.gravity = vec3_make(1.0, 2.0, -9.0);
    rig->body.drag = 0.5;
    rig->body.coupling = (vbss_rigid_coupling){200.0, 0.3, 0.1, 1e-4};
    rig->body.now.v = vec3_make(0.1, 0.2, 0.3);
    rig->body.now.w = vec3_make(5.0, -6.0, 7.0);
    rig->body.target_end = pose_make(vec3_make(0.01, 0.02, 0.03),
                                     vbss_quat_from_rotation_vector(vec3_make(0.1, 0.2, 0.3)));
    rig->body.target_start = rig->body.target_end;
    rigid_rig_steps(rig, 20);
}

static void restored_body_continues_bit_equal(void **state)
{
    (void)state;
    rigid_rig rig;
    begin_moving(&rig);
    saved s = save(&rig.body);
    rigid_rig_steps(&rig, 20);
    vbss_rigid wanted = rig.body;
    /* Everything but mass and moments comes from the bytes. */
    vbss_rigid other = {.mass = wanted.mass, .inertia = wanted.inertia};
    expect_ok(load(&other, &s, false));
    rig.body = other;
    rigid_rig_steps(&rig, 20);
    assert_memory_equal(&wanted, &rig.body, sizeof wanted);
    rigid_rig_end(&rig);
}

static void body_of_other_mass_or_moments_is_rejected(void **state)
{
    (void)state;
    rigid_rig rig;
    begin_moving(&rig);
    saved s = save(&rig.body);
    double *const numbers[] = {&rig.body.mass, &rig.body.inertia.x, &rig.body.inertia.y,
                               &rig.body.inertia.z};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        double kept = *numbers[i];
        *numbers[i] *= 1.0 + DBL_EPSILON;
        expect_result(VBSS_ERROR_CORRUPT, load(&rig.body, &s, false));
        *numbers[i] = kept;
    }
    expect_ok(load(&rig.body, &s, false));
    rigid_rig_end(&rig);
}

/* Nonsense in each of the numbers: told on reading, unless the bytes are our own. */
static void expect_nonsense(vbss_rigid *body, double *number, double nonsense)
{
    double kept = *number;
    *number = nonsense;
    assert_false(vbss_rigid_is_valid(body));
    saved s = save(body);
    *number = kept;
    assert_true(vbss_rigid_is_valid(body));
    vbss_rigid other = *body;
    expect_result(VBSS_ERROR_CORRUPT, load(&other, &s, false));
    expect_ok(load(&other, &s, true));
}

static void impossible_state_is_rejected_on_read(void **state)
{
    (void)state;
    rigid_rig rig;
    begin_moving(&rig);
    vbss_rigid *b = &rig.body;
    pose *const poses[] = {&b->now.pose, &b->target_start, &b->target_end};
    vec3 *const vectors[] = {&b->gravity,         &b->now.v,           &b->now.w,
                             &poses[0]->position, &poses[1]->position, &poses[2]->position};
    double *const positive[] = {&b->drag, &b->coupling.stiffness, &b->coupling.damping,
                                &b->coupling.turning_stiffness, &b->coupling.turning_damping};
    for (int i = 0; i < 3; i++) {
        expect_nonsense(b, &poses[i]->orientation.w, 1.1);
        expect_nonsense(b, &poses[i]->orientation.z, 2.0);
        expect_nonsense(b, &poses[i]->orientation.x, harness_bad_numbers[i]);
    }
    for (int i = 0; i < 6; i++) {
        expect_nonsense(b, &vectors[i]->x, harness_bad_numbers[i % 3]);
        expect_nonsense(b, &vectors[i]->y, harness_bad_numbers[(i + 1) % 3]);
        expect_nonsense(b, &vectors[i]->z, harness_bad_numbers[(i + 2) % 3]);
    }
    for (int i = 0; i < 5; i++) {
        expect_nonsense(b, positive[i], -1e-300);
        expect_nonsense(b, positive[i], harness_bad_numbers[0]);
        expect_nonsense(b, positive[i], harness_bad_numbers[1]);
    }
    rigid_rig_end(&rig);
}

static void impossible_masses_are_invalid(void **state)
{
    (void)state;
    rigid_rig rig;
    begin_moving(&rig);
    double *const numbers[] = {&rig.body.mass, &rig.body.inertia.x, &rig.body.inertia.y,
                               &rig.body.inertia.z};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        const double bad[] = {0.0, -1e-5, 1e-310, harness_bad_numbers[0], harness_bad_numbers[1]};
        double kept = *numbers[i];
        for (size_t k = 0; k < sizeof bad / sizeof bad[0]; k++) {
            *numbers[i] = bad[k];
            assert_false(vbss_rigid_is_valid(&rig.body));
        }
        *numbers[i] = kept;
        assert_true(vbss_rigid_is_valid(&rig.body));
    }
    rig.body.inertia = vec3_make(1.0, 2.0, 3.0); /* flat: as far as it goes */
    assert_true(vbss_rigid_is_valid(&rig.body));
    rig.body.inertia.z = 3.001;
    assert_false(vbss_rigid_is_valid(&rig.body));
    rigid_rig_end(&rig);
}

int test_rigid_state(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(restored_body_continues_bit_equal),
        harness_test(body_of_other_mass_or_moments_is_rejected),
        harness_test(impossible_state_is_rejected_on_read),
        harness_test(impossible_masses_are_invalid),
    };
    return cmocka_run_group_tests_name("solver.rigid_state", tests, NULL, NULL);
}
