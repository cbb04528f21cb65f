/* Maps poses from the device's frame to the world, and forces from the world to the device. */
#include "base/check.h"
#include "base/error.h"
#include "device/device.h"

_Static_assert(sizeof(vbss_device_calibration) == 264, "published size");

static const vbss_device_calibration defaults = {
    .struct_size = sizeof(vbss_device_calibration),
    .axes = {1, 2, 3},
    .rotation = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
    .scale = 1.0,
    .mount = {1.0, 0.0, 0.0, 0.0},
    .workspace_low = {-1.0, -1.0, -1.0},
    .workspace_high = {1.0, 1.0, 1.0},
    .force_scale = 1.0,
    .jaw_closed = 0.0,
    .jaw_open = 1.0,
    .jaw_margin = 0.25,
    .jaw_play = 0.02,
    .jaw_time = 0.01,
    .jaw_close_at = 0.05,
    .jaw_open_at = 0.1,
};
static const uint32_t sizes[] = {264, 0};
const vbss_layout vbss_device_calibration_layout = {"vbss_device_calibration", &defaults, sizes};

vbss_result vbss_device_calibration_init(vbss_device_calibration *calibration, uint32_t struct_size)
{
    return vbss_config_init(&vbss_device_calibration_layout, calibration, struct_size);
}

/* ---- checks */

static vbss_result check_axes(vbss_context *context, const int32_t axes[3])
{
    uint32_t seen = 0;
    for (int i = 0; i < 3; i++) {
        VBSS_TRY(vbss_check_range(context, axes[i], -3.0, 3.0, "axes"));
        seen |= 1u << (axes[i] < 0 ? -axes[i] : axes[i]);
    }
    return seen == 14 ? VBSS_OK
                      : vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE,
                                  "axes %d, %d, %d are not all three", axes[0], axes[1], axes[2]);
}

static mat3 rotation_of(const vbss_device_calibration *c)
{
    return mat3_rows(vec3_load(c->rotation), vec3_load(c->rotation + 3),
                     vec3_load(c->rotation + 6));
}

static vbss_result check_rotation(vbss_context *context, const vbss_device_calibration *c)
{
    VBSS_TRY(vbss_check_finite(context, c->rotation, 9, "rotation"));
    VBSS_TRY(vbss_check_range(context, vbss_max_abs(c->rotation, 9), 0.0, 1.000001, "rotation"));
    mat3 r = rotation_of(c);
    mat3 deviation = mat3_sub(mat3_mul(r, mat3_transpose(r)), mat3_identity());
    return vbss_max_abs(&deviation.m[0][0], 9) <= 1e-6 && mat3_determinant(r) > 0.0
               ? VBSS_OK
               : vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE, "rotation is none");
}

static vbss_result check_workspace(vbss_context *context, const double low[3], const double high[3])
{
    for (int i = 0; i < 3; i++) {
        VBSS_TRY(vbss_check_range(context, low[i], -1e3, 1e3, "workspace_low"));
        VBSS_TRY(vbss_check_range(context, high[i], low[i], 1e3, "workspace_high"));
    }
    return VBSS_OK;
}

static vbss_result check_jaw(vbss_context *context, const vbss_device_calibration *c)
{
    VBSS_TRY(vbss_check_range(context, c->jaw_closed, -1e6, 1e6, "jaw_closed"));
    VBSS_TRY(vbss_check_range(context, c->jaw_open, -1e6, 1e6, "jaw_open"));
    VBSS_TRY(vbss_check_range(context, fabs(c->jaw_open - c->jaw_closed), 1e-9, 2e6,
                              "jaw_open - jaw_closed"));
    VBSS_TRY(vbss_check_range(context, c->jaw_margin, 0.0, 10.0, "jaw_margin"));
    VBSS_TRY(vbss_check_range(context, c->jaw_play, 0.0, 0.5, "jaw_play"));
    VBSS_TRY(vbss_check_range(context, c->jaw_time, 0.0, 10.0, "jaw_time"));
    VBSS_TRY(vbss_check_range(context, c->jaw_close_at, 0.0, 1.0, "jaw_close_at"));
    return vbss_check_range(context, c->jaw_open_at, c->jaw_close_at, 1.0, "jaw_open_at");
}

vbss_result vbss_device_check_calibration(vbss_context *context, const vbss_device_calibration *c)
{
    VBSS_TRY(check_axes(context, c->axes));
    VBSS_TRY(check_rotation(context, c));
    VBSS_TRY(vbss_check_range(context, c->scale, 1e-3, 1e3, "scale"));
    VBSS_TRY(vbss_check_finite(context, c->offset, 3, "offset"));
    VBSS_TRY(vbss_check_range(context, vbss_max_abs(c->offset, 3), 0.0, 1e3, "offset"));
    VBSS_TRY(vbss_check_finite(context, c->mount, 4, "mount"));
    VBSS_TRY(vbss_check_range(context, vbss_max_abs(c->mount, 4), 1e-100, 1e100, "mount"));
    VBSS_TRY(check_workspace(context, c->workspace_low, c->workspace_high));
    VBSS_TRY(vbss_check_range(context, c->force_scale, 1e-3, 1e3, "force_scale"));
    return check_jaw(context, c);
}

/* ---- the frame */

/* Removes the error that a rotation may have (1e-6). The transpose, which maps forces, is then the
 * inverse to rounding. */
static mat3 orthonormalise(mat3 r)
{
    vec3 x = vec3_unit_or(vec3_load(r.m[0]), vec3_make(1.0, 0.0, 0.0)), y = vec3_load(r.m[1]);
    y = vec3_unit_or(vec3_add_scaled(y, -vec3_dot(x, y), x), vec3_make(0.0, 1.0, 0.0));
    return mat3_rows(x, y, vec3_cross(x, y));
}

device_frame vbss_device_make_frame(const vbss_device_calibration *c)
{
    mat3 axes = mat3_zero();
    for (int i = 0; i < 3; i++) {
        axes.m[i][c->axes[i] < 0 ? -c->axes[i] - 1 : c->axes[i] - 1] = c->axes[i] < 0 ? -1.0 : 1.0;
    }
    device_frame f = {mat3_mul(orthonormalise(rotation_of(c)), axes), mat3_determinant(axes),
                      quat_unit(quat_make(c->mount[0], c->mount[1], c->mount[2], c->mount[3]))};
    return f;
}

vec3 vbss_device_position_to_world(const vbss_device_calibration *c, const device_frame *f, vec3 p)
{
    return vec3_add(vec3_load(c->offset), mat3_mul_vec3(f->rotation, vec3_scale(p, c->scale)));
}

vec3 vbss_device_velocity_to_world(const vbss_device_calibration *c, const device_frame *f, vec3 v)
{
    return mat3_mul_vec3(f->rotation, vec3_scale(v, c->scale));
}

/* An angular velocity is an axial vector: a mirrored frame reverses it. */
vec3 vbss_device_spin_to_world(const device_frame *f, vec3 omega)
{
    return vec3_scale(mat3_mul_vec3(f->rotation, omega), f->parity);
}

quat vbss_device_orientation_to_world(const device_frame *f, quat q)
{
    vec3 axis = vbss_device_spin_to_world(f, vec3_make(q.x, q.y, q.z));
    return quat_unit(quat_mul(quat_make(q.w, axis.x, axis.y, axis.z), f->mount));
}

vec3 vbss_device_force_to_device(const vbss_device_calibration *c, const device_frame *f, vec3 v)
{
    return vec3_scale(mat3_transpose_mul_vec3(f->rotation, v), c->force_scale);
}

vec3 vbss_device_torque_to_device(const vbss_device_calibration *c, const device_frame *f, vec3 v)
{
    return vec3_scale(mat3_transpose_mul_vec3(f->rotation, v), f->parity * c->force_scale);
}

vec3 vbss_device_displacement_to_device(const vbss_device_calibration *c, const device_frame *f,
                                        vec3 v)
{
    return vec3_scale(mat3_transpose_mul_vec3(f->rotation, v), 1.0 / c->scale);
}

/* ---- the workspace */

uint32_t vbss_device_clamp_to_workspace(const vbss_device_calibration *c, vec3 *p)
{
    double x[3];
    uint32_t outside = 0;
    vec3_store(x, *p);
    for (int i = 0; i < 3; i++) {
        double inside = vbss_min(vbss_max(x[i], c->workspace_low[i]), c->workspace_high[i]);
        outside |= inside == x[i] ? 0u : 1u << i;
        x[i] = inside;
    }
    *p = vec3_load(x);
    return outside;
}
