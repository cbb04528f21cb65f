/* Mouse, keyboard and gamepad as devices: pure functions that add a motion to a sample. */
#include <string.h>

#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "base/rotation.h"
#include "device/device.h"

_Static_assert(sizeof(vbss_mapping_config) == 192, "published size");

static const vbss_mapping_config defaults = {
    .struct_size = sizeof(vbss_mapping_config),
    .pad_curve = 2,
    .right = {1.0, 0.0, 0.0},
    .up = {0.0, 1.0, 0.0},
    .low = {-0.1, -0.1, -0.1},
    .high = {0.1, 0.1, 0.1},
    .mouse_metres = 1e-4,
    .mouse_depth = 2e-3,
    .mouse_radians = 5e-3,
    .mouse_roll = 0.1,
    .jaw_rate = 4.0,
    .key_metres = 1e-3,
    .key_radians = 0.05,
    .key_jaw = 0.1,
    .pad_speed = 0.1,
    .pad_turning = 1.0,
    .pad_dead = 0.15,
};
static const uint32_t sizes[] = {192, 0};
static const vbss_layout layout = {"vbss_mapping_config", &defaults, sizes};

vbss_result vbss_mapping_config_init(vbss_mapping_config *config, uint32_t struct_size)
{
    return vbss_config_init(&layout, config, struct_size);
}

/* ---- checks */

static vbss_result check_axes(const vbss_mapping_config *c)
{
    VBSS_TRY(vbss_check_finite(NULL, c->right, 3, "right"));
    VBSS_TRY(vbss_check_finite(NULL, c->up, 3, "up"));
    vec3 right = vec3_load(c->right), up = vec3_load(c->up);
    double deviations[] = {vec3_dot(right, right) - 1.0, vec3_dot(up, up) - 1.0,
                           vec3_dot(right, up)};
    return vbss_max_abs(deviations, 3) <= 2e-6 ? VBSS_OK : VBSS_ERROR_OUT_OF_RANGE;
}

static vbss_result check_config(const vbss_mapping_config *c)
{
    const double rates[] = {c->mouse_metres, c->mouse_depth, c->mouse_radians,
                            c->mouse_roll,   c->key_metres,  c->key_radians,
                            c->key_jaw,      c->pad_speed,   c->pad_turning};
    VBSS_TRY(check_axes(c));
    VBSS_TRY(vbss_check_range(NULL, c->pad_curve, 1.0, 4.0, "pad_curve"));
    VBSS_TRY(vbss_check_range(NULL, c->pad_dead, 0.0, 0.9, "pad_dead"));
    VBSS_TRY(vbss_check_range(NULL, c->jaw_rate, 0.0, 1e3, "jaw_rate"));
    for (size_t i = 0; i < sizeof rates / sizeof rates[0]; i++) {
        VBSS_TRY(vbss_check_range(NULL, rates[i], -1e3, 1e3, "a rate"));
    }
    for (int i = 0; i < 3; i++) {
        VBSS_TRY(vbss_check_range(NULL, c->low[i], -1e3, 1e3, "low"));
        VBSS_TRY(vbss_check_range(NULL, c->high[i], c->low[i], 1e3, "high"));
    }
    return VBSS_OK;
}

static vbss_result check_sample(const vbss_device_sample *s)
{
    const double *q = s->orientation;
    double square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    VBSS_TRY(vbss_check_finite(NULL, q, 4, "orientation"));
    VBSS_TRY(vbss_check_range(NULL, square, 0.25, 4.0, "orientation"));
    VBSS_TRY(vbss_check_finite(NULL, s->position, 3, "position"));
    VBSS_TRY(vbss_check_range(NULL, vbss_max_abs(s->position, 3), 0.0, 1e3, "position"));
    VBSS_TRY(vbss_check_range(NULL, s->jaw, 0.0, 1.0, "jaw"));
    return vbss_check_range(NULL, s->time, -1e9, 1e9, "time");
}

/* Reads and checks the arguments that all mappings have. */
static vbss_result begin_mapping(const vbss_mapping_config *config, const double *motion, int count,
                                 double limit, double h, const vbss_device_sample *sample,
                                 vbss_mapping_config *c, vbss_device_sample *s)
{
    VBSS_TRY(vbss_config_init(&layout, c, sizeof *c));
    if (config != NULL) {
        VBSS_TRY(vbss_config_read(NULL, &layout, config, c));
    }
    VBSS_TRY(check_config(c));
    VBSS_TRY(vbss_check_pointer(NULL, motion, "motion"));
    VBSS_TRY(vbss_check_finite(NULL, motion, (size_t)count, "motion"));
    VBSS_TRY(vbss_check_range(NULL, vbss_max_abs(motion, (size_t)count), 0.0, limit, "motion"));
    VBSS_TRY(vbss_check_range(NULL, h, 0.0, 10.0, "h"));
    VBSS_TRY(vbss_config_read(NULL, &vbss_device_sample_layout, sample, s));
    return check_sample(s);
}

/* ---- moving a sample */

/* The vector with these components along right, up and towards the user. */
static vec3 view_vector(const vbss_mapping_config *c, double right, double up, double towards)
{
    vec3 x = vec3_load(c->right), y = vec3_load(c->up);
    return vec3_add_scaled(vec3_add(vec3_scale(x, right), vec3_scale(y, up)), towards,
                           vec3_cross(x, y));
}

static void translate_sample(const vbss_mapping_config *c, vec3 by, vbss_device_sample *s)
{
    double x[3];
    vec3_store(x, vec3_add(vec3_load(s->position), by));
    for (int i = 0; i < 3; i++) {
        s->position[i] = vbss_min(vbss_max(x[i], c->low[i]), c->high[i]);
    }
}

static void rotate_sample(vec3 by, vbss_device_sample *s)
{
    quat q = quat_make(s->orientation[0], s->orientation[1], s->orientation[2], s->orientation[3]);
    q = quat_unit(quat_mul(vbss_quat_from_rotation_vector(by), q));
    s->orientation[0] = q.w;
    vec3_store(s->orientation + 1, vec3_make(q.x, q.y, q.z));
}

static void open_jaw(double by, vbss_device_sample *s)
{
    s->jaw = vbss_min(vbss_max(s->jaw + by, 0.0), 1.0);
}

/* Copies the sample back, as many bytes as the caller's struct has. */
static void finish_mapping(double h, const vbss_device_sample *s, vbss_device_sample *sample)
{
    vbss_device_sample own = *s;
    own.struct_size = sample->struct_size;
    own.time += h;
    own.valid |= DEVICE_POSE_SIGNALS | VBSS_DEVICE_HAS_JAW;
    memcpy(sample, &own, sizeof own < own.struct_size ? sizeof own : own.struct_size);
}

/* ---- mappings */

vbss_result vbss_mapping_mouse(const vbss_mapping_config *config, const double motion[3],
                               uint32_t buttons, double h, vbss_device_sample *sample)
{
    VBSS_ENTER(NULL);
    vbss_mapping_config c;
    vbss_device_sample s;
    VBSS_TRY(begin_mapping(config, motion, 3, 1e6, h, sample, &c, &s));
    VBSS_TRY(vbss_check_range(NULL, buttons, 0.0, 3.0, "buttons"));
    if ((buttons & VBSS_MAPPING_MOUSE_TURN) != 0) {
        rotate_sample(view_vector(&c, -c.mouse_radians * motion[1], c.mouse_radians * motion[0],
                                  c.mouse_roll * motion[2]),
                      &s);
    } else {
        translate_sample(&c,
                         view_vector(&c, c.mouse_metres * motion[0], c.mouse_metres * motion[1],
                                     -c.mouse_depth * motion[2]),
                         &s);
    }
    open_jaw((buttons & VBSS_MAPPING_MOUSE_CLOSE) != 0 ? -c.jaw_rate * h : c.jaw_rate * h, &s);
    finish_mapping(h, &s, sample);
    return VBSS_OK;
}

vbss_result vbss_mapping_keyboard(const vbss_mapping_config *config, const double presses[7],
                                  double h, vbss_device_sample *sample)
{
    VBSS_ENTER(NULL);
    vbss_mapping_config c;
    vbss_device_sample s;
    VBSS_TRY(begin_mapping(config, presses, 7, 1e6, h, sample, &c, &s));
    translate_sample(
        &c, vec3_scale(view_vector(&c, presses[0], presses[1], presses[2]), c.key_metres), &s);
    rotate_sample(vec3_scale(view_vector(&c, presses[3], presses[4], presses[5]), c.key_radians),
                  &s);
    open_jaw(c.key_jaw * presses[6], &s);
    finish_mapping(h, &s, sample);
    return VBSS_OK;
}

/* 0 in the dead zone and 1 at full deflection; in between, a power of the deflection beyond the
 * dead zone. */
static double shape_deflection(const vbss_mapping_config *c, double axis)
{
    double fraction = (vbss_min(fabs(axis), 1.0) - c->pad_dead) / (1.0 - c->pad_dead);
    double rate = fraction > 0.0 ? fraction : 0.0;
    for (uint32_t i = 1; i < c->pad_curve && rate > 0.0; i++) {
        rate *= fraction;
    }
    return axis < 0.0 ? -rate : rate;
}

vbss_result vbss_mapping_gamepad(const vbss_mapping_config *config, const double axes[6],
                                 double opening, double h, vbss_device_sample *sample)
{
    VBSS_ENTER(NULL);
    vbss_mapping_config c;
    vbss_device_sample s;
    double rate[6];
    VBSS_TRY(begin_mapping(config, axes, 6, 1e6, h, sample, &c, &s));
    VBSS_TRY(vbss_check_range(NULL, opening, 0.0, 1.0, "opening"));
    for (int i = 0; i < 6; i++) {
        rate[i] = shape_deflection(&c, axes[i]);
    }
    translate_sample(&c, vec3_scale(view_vector(&c, rate[0], rate[1], rate[2]), c.pad_speed * h),
                     &s);
    rotate_sample(vec3_scale(view_vector(&c, rate[3], rate[4], rate[5]), c.pad_turning * h), &s);
    s.jaw = opening;
    finish_mapping(h, &s, sample);
    return VBSS_OK;
}
