#include <math.h>

#include "harness/harness.h"

/* Some roundings of numbers of size one: eight units in the last place. */
#define ROUNDING 1.8e-15

#define expect_vec3(wanted, got, tolerance) near_vec3((wanted), (got), (tolerance), #got, __LINE__)
static void near_vec3(vec3 wanted, vec3 got, double tolerance, const char *what, int line)
{
    harness_near(wanted.x, got.x, tolerance, what, __FILE__, line);
    harness_near(wanted.y, got.y, tolerance, what, __FILE__, line);
    harness_near(wanted.z, got.z, tolerance, what, __FILE__, line);
}

static void expect_mat3(mat3 wanted, mat3 got, double tolerance)
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            expect_near(wanted.m[i][j], got.m[i][j], tolerance);
        }
    }
}

static mat3 draw_mat3(harness_source *source)
{
    vec3 a = harness_draw_vec3(source, -1, 1);
    vec3 b = harness_draw_vec3(source, -1, 1);
    vec3 c = harness_draw_vec3(source, -1, 1);
    return mat3_rows(a, b, c);
}

static void vectors(harness_source *source, void *user)
{
    (void)user;
    vec3 a = harness_draw_vec3(source, -2, 2), b = harness_draw_vec3(source, -2, 2);
    vec3 c = harness_draw_vec3(source, -2, 2);
    double s = harness_draw_real(source, -2, 2);
    expect_near(0.0, vec3_dot(a, vec3_cross(a, b)), 1e-14);
    /* Lagrange: |a x b|^2 = |a|^2 |b|^2 - (a.b)^2 */
    expect_near(vec3_norm_squared(a) * vec3_norm_squared(b) - vec3_dot(a, b) * vec3_dot(a, b),
                vec3_norm_squared(vec3_cross(a, b)), 1e-13);
    expect_near(vec3_dot(a, vec3_cross(b, c)), mat3_determinant(mat3_rows(a, b, c)), 1e-13);
    expect_vec3(vec3_add(a, vec3_scale(b, s)), vec3_add_scaled(a, s, b), 0.0);
    expect_vec3(a, vec3_lerp(a, b, 0.0), 0.0);
    expect_vec3(b, vec3_lerp(a, b, 1.0), 0.0);
    expect_vec3(vec3_neg(a), vec3_sub(vec3_zero(), a), 0.0);
    expect_near(vec3_norm(vec3_sub(a, b)), vec3_distance(a, b), 0.0);
    vec3 u = vec3_unit_or(a, c);
    vec3 n = vec3_any_normal(u);
    expect_near(0.0, vec3_dot(u, n), ROUNDING);
    expect_near(1.0, vec3_norm(n), ROUNDING);
    double stored[3];
    vec3_store(stored, a);
    expect_vec3(a, vec3_load(stored), 0.0);
}

static void vector_identities(void **state)
{
    (void)state;
    harness_property("vectors", 2000, vectors, NULL);
    vec3 fallback = vec3_make(0, 1, 0);
    /* Exact at the end even where the difference of the two is not. */
    expect_vec3(fallback, vec3_lerp(vec3_make(1e17, 1e17, 1e17), fallback, 1.0), 0.0);
    expect_vec3(fallback, vec3_unit_or(vec3_zero(), fallback), 0.0);
    expect_vec3(vec3_make(0, 0, 1), vec3_unit_or(vec3_make(0, 0, 1e-149), fallback), ROUNDING);
    expect_vec3(fallback, vec3_unit_or(vec3_make(0, 0, 1e-151), fallback), 0.0);
    /* What is broken must stay visible: neither a direction nor the fallback. */
    const vec3 broken[] = {vec3_make(0, 0, harness_bad_numbers[0]),
                           vec3_make(harness_bad_numbers[1], 0, 0), vec3_make(1e200, 1e200, 0)};
    for (int i = 0; i < 3; i++) {
        assert_false(vec3_is_finite(vec3_unit_or(broken[i], fallback)));
        assert_false(
            quat_is_finite(quat_unit(quat_make(0, broken[i].x, broken[i].y, broken[i].z))));
    }
    for (int i = 0; i < 3; i++) {
        assert_false(vec3_is_finite(vec3_make(0, 0, harness_bad_numbers[i])));
        assert_false(vec3_is_finite(vec3_make(harness_bad_numbers[i], 0, 0)));
    }
    assert_true(vec3_is_finite(vec3_make(1, 2, 3)));
    /* The normal's formula divides by sign + z: both poles, and either zero. */
    const vec3 poles[] = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0.0}, {1, 0, -0.0}};
    for (int i = 0; i < 4; i++) {
        expect_near(1.0, vec3_norm(vec3_any_normal(poles[i])), 0.0);
        expect_near(0.0, vec3_dot(poles[i], vec3_any_normal(poles[i])), 0.0);
    }
}

static void matrices(harness_source *source, void *user)
{
    (void)user;
    mat3 a = draw_mat3(source), b = draw_mat3(source), inverse;
    vec3 v = harness_draw_vec3(source, -1, 1), w = harness_draw_vec3(source, -1, 1);
    expect_vec3(mat3_mul_vec3(a, mat3_mul_vec3(b, v)), mat3_mul_vec3(mat3_mul(a, b), v), 1e-14);
    expect_vec3(mat3_mul_vec3(mat3_transpose(a), v), mat3_transpose_mul_vec3(a, v), 0.0);
    expect_vec3(vec3_cross(v, w), mat3_mul_vec3(mat3_cross(v), w), ROUNDING);
    expect_vec3(vec3_scale(v, vec3_dot(w, v)), mat3_mul_vec3(mat3_outer(v, w), v), ROUNDING);
    expect_mat3(mat3_zero(), mat3_sub(a, a), 0.0);
    expect_mat3(mat3_scale(a, 2.0), mat3_add(a, a), 0.0);
    expect_near(mat3_determinant(a) * mat3_determinant(b), mat3_determinant(mat3_mul(a, b)), 1e-14);
    if (fabs(mat3_determinant(a)) > 1e-3) {
        assert_true(mat3_invert(a, &inverse));
        expect_mat3(mat3_identity(), mat3_mul(a, inverse), 1e-11);
        expect_mat3(mat3_identity(), mat3_mul(inverse, a), 1e-11);
    }
}

static void matrix_identities(void **state)
{
    (void)state;
    harness_property("matrices", 2000, matrices, NULL);
}

static void singular_matrix_inverse_is_rejected(void **state)
{
    (void)state;
    mat3 kept = mat3_diagonal(7, 8, 9), inverse = kept;
    assert_false(mat3_invert(mat3_zero(), &inverse));
    assert_false(mat3_invert(mat3_diagonal(1, 0, 1), &inverse));
    assert_false(mat3_invert(mat3_diagonal(1e-110, 1e-110, 1e-110), &inverse)); /* underflows */
    assert_false(mat3_invert(mat3_diagonal(1, 1, harness_bad_numbers[0]), &inverse));
    assert_false(mat3_invert(mat3_diagonal(1, 1, harness_bad_numbers[1]), &inverse));
    assert_false(mat3_invert(mat3_diagonal(1e200, 1e200, 1e-300), &inverse)); /* overflows inside */
    /* Dependent rows whose determinant is not zero after rounding. */
    mat3 dependent =
        mat3_rows(vec3_make(0.1, 0.2, 0.3), vec3_make(0.2, 0.4, 0.6), vec3_make(0.7, 0.8, 0.9));
    assert_false(mat3_invert(dependent, &inverse));
    expect_mat3(kept, inverse, 0.0);
    assert_false(mat3_invert(mat3_diagonal(1e-105, 1e-105, 1e-105), &inverse)); /* 1/d overflows */
    expect_mat3(kept, inverse, 0.0);
    /* The border of what counts as dependent. */
    mat3 nearly = mat3_rows(vec3_make(1, 0, 0), vec3_make(0, 1, 0), vec3_make(0, 1, 1e-15));
    assert_false(mat3_invert(nearly, &inverse));
    nearly.m[2][2] = 1e-13;
    assert_true(mat3_invert(nearly, &inverse));
    expect_near(1e13, inverse.m[2][2], 1.0);
    /* Small is not singular. */
    assert_true(mat3_invert(mat3_diagonal(1e-90, 2e-90, 4e-90), &inverse));
    expect_near(1.0, inverse.m[0][0] * 1e-90, 1e-15);
}

static void rotations(harness_source *source, void *user)
{
    (void)user;
    quat p = harness_draw_unit_quat(source), q = harness_draw_unit_quat(source);
    vec3 v = harness_draw_vec3(source, -1, 1);
    expect_vec3(mat3_mul_vec3(quat_to_mat3(q), v), quat_rotate(q, v), ROUNDING);
    expect_vec3(quat_rotate(p, quat_rotate(q, v)), quat_rotate(quat_mul(p, q), v), 2 * ROUNDING);
    expect_vec3(v, quat_rotate_back(q, quat_rotate(q, v)), 2 * ROUNDING);
    expect_near(vec3_norm(v), vec3_norm(quat_rotate(q, v)), ROUNDING);
    expect_near(1.0, mat3_determinant(quat_to_mat3(q)), 2 * ROUNDING);

    vec3 a = vec3_unit_or(v, vec3_make(1, 0, 0));
    vec3 b = vec3_unit_or(harness_draw_vec3(source, -1, 1), vec3_make(0, 1, 0));
    quat turn = quat_between(a, b);
    /* The half-way vector of nearly opposite ones is short and so less well known. */
    expect_vec3(b, quat_rotate(turn, a), ROUNDING + 1e-15 / vec3_norm(vec3_add(a, b)));
    expect_near(0.0, vec3_dot(vec3_make(turn.x, turn.y, turn.z), vec3_add(a, b)), 1e-14);
    /* Nearly opposite, as close as makes the half-way vector short. */
    vec3 c = vec3_unit_or(
        vec3_add_scaled(vec3_neg(a), harness_draw_real(source, 1e-9, 1e-6), vec3_any_normal(a)), a);
    expect_vec3(c, quat_rotate(quat_between(a, c), a), 1e-7);
}

static void rotation_identities(void **state)
{
    (void)state;
    harness_property("rotations", 2000, rotations, NULL);
    vec3 x = vec3_make(1, 0, 0);
    expect_vec3(vec3_neg(x), quat_rotate(quat_between(x, vec3_neg(x)), x), 0.0);
    quat none = quat_unit(quat_make(0, 0, 0, 0));
    expect_near(1.0, none.w, 0.0);
    expect_near(1.0, quat_unit(quat_make(0, 1e-149, 0, 0)).x, ROUNDING);
    expect_near(1.0, quat_unit(quat_make(0, 1e-151, 0, 0)).w, 0.0);
    assert_true(quat_is_finite(none));
    assert_false(quat_is_finite(quat_make(0, 0, harness_bad_numbers[0], 0)));
    /* Right-handed: a quarter turn about z takes x to y. */
    double r = sqrt(0.5);
    expect_vec3(vec3_make(0, 1, 0), quat_rotate(quat_make(r, 0, 0, r), x), ROUNDING);
}

static pose draw_pose(harness_source *source)
{
    vec3 position = harness_draw_vec3(source, -1, 1); /* before the other draw, on every compiler */
    return pose_make(position, harness_draw_unit_quat(source));
}

static void poses(harness_source *source, void *user)
{
    (void)user;
    pose a = draw_pose(source), b = draw_pose(source);
    vec3 v = harness_draw_vec3(source, -1, 1);
    expect_vec3(pose_apply(a, pose_apply(b, v)), pose_apply(pose_mul(a, b), v), 2 * ROUNDING);
    expect_vec3(v, pose_apply_inverse(a, pose_apply(a, v)), 2 * ROUNDING);
    expect_vec3(pose_apply_inverse(a, v), pose_apply(pose_inverse(a), v), 2 * ROUNDING);
    expect_vec3(v, pose_apply(pose_mul(pose_inverse(a), a), v), 2 * ROUNDING);
    expect_vec3(v, pose_apply(pose_identity(), v), 0.0);
}

static void pose_identities(void **state)
{
    (void)state;
    harness_property("poses", 2000, poses, NULL);
}

int test_linear(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(vector_identities),
        harness_test(matrix_identities),
        harness_test(singular_matrix_inverse_is_rejected),
        harness_test(rotation_identities),
        harness_test(pose_identities),
    };
    return cmocka_run_group_tests_name("base.linear", tests, NULL, NULL);
}
