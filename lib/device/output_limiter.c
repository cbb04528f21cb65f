/* Limits forces and torques. Each stage reduces them or leaves them, and sets a flag if it acts:
 *
 *     finite? -> magnitude -> continuous load -> temperature -> rise -> watchdog -> emergency stop
 *
 * docs/reference/device-layer.md has the formulas. The code uses no device and no context, because adapters call
 * it from threads of their own. */
#include <string.h>

#include "base/check.h"
#include "device/device.h"
#include "device/tuning.h"

/* Limit of a stage that does not reduce the output. */
#define NO_LIMIT DBL_MAX

/* ---- one vector */

/* Limits of a force or torque: peak, root mean square, and rise per second. */
typedef struct vector_limits {
    double max, continuous, rise_rate;
} vector_limits;

/* Shortens a vector to the limit, and sets the flag if it was longer. */
static vec3 clamp_length(vec3 v, double limit, uint32_t flag, uint32_t *flags)
{
    double x[3];
    vec3_store(x, v);
    double largest = vbss_max_abs(x, 3);
    if (largest > 1e100) { /* its square would overflow */
        v = vec3_scale(vec3_make(v.x / largest, v.y / largest, v.z / largest), 1e100);
    }
    double n = vec3_norm(v);
    if (!(n > limit)) {
        return v;
    }
    *flags |= flag;
    return vec3_scale(v, limit / n);
}

/* Falls from the peak to the continuous limit while the mean square approaches the square of the
 * continuous limit. */
static double continuous_limit(const vector_limits *l, double load)
{
    double limit_squared = l->continuous * l->continuous;
    if (l->continuous >= l->max) {
        return NO_LIMIT;
    }
    if (limit_squared < 1e-100 || load >= limit_squared) {
        return l->continuous;
    }
    double fraction = (limit_squared - load) / ((1.0 - DEVICE_LOAD_KNEE) * limit_squared);
    return fraction < 1.0 ? sqrt(limit_squared + fraction * (l->max * l->max - limit_squared))
                          : NO_LIMIT;
}

static double thermal_limit(const vbss_output_config *c, const vector_limits *l, double temperature)
{
    double fraction = (c->hot - temperature) / (c->hot - c->warm);
    return fraction < 1.0 ? l->max * vbss_max(fraction, 0.0) : NO_LIMIT;
}

/* Limits the change from the last output, except where it shrinks along its own direction. The
 * result is never longer than `wanted`. */
static vec3 limit_rise(vec3 last, vec3 wanted, double max_change, uint32_t *flags)
{
    double square = vec3_norm_squared(last);
    double fraction = square > 0.0 ? vec3_dot(wanted, last) / square : 0.0;
    vec3 from = vec3_scale(last, vbss_min(vbss_max(fraction, 0.0), 1.0));
    vec3 change = vec3_sub(wanted, from);
    double n = vec3_norm(change);
    if (!(n > max_change)) {
        return wanted;
    }
    *flags |= VBSS_OUTPUT_FLAG_SLEWED;
    return vec3_add_scaled(from, max_change / n, change);
}

static vec3 apply_limits(const vbss_output_config *c, const vector_limits *l, vec3 last,
                         vec3 wanted, double load, double temperature, double h, uint32_t *flags)
{
    vec3 v = clamp_length(wanted, l->max, VBSS_OUTPUT_FLAG_CLAMPED, flags);
    v = clamp_length(v, continuous_limit(l, load), VBSS_OUTPUT_FLAG_CONTINUOUS, flags);
    v = clamp_length(v, thermal_limit(c, l, temperature), VBSS_OUTPUT_FLAG_WARM, flags);
    return limit_rise(last, v, l->rise_rate * vbss_min(h, DEVICE_MAX_RISE_TIME), flags);
}

/* Mean square after h seconds of a constant v: exp(-h/T) load + (1 - exp(-h/T)) v^2. `factor` is
 * 1 - exp(-h/T). */
static double update_load(double load, vec3 v, double factor)
{
    return load + factor * (vec3_norm_squared(v) - load);
}

/* ---- ages */

/* NaN and infinity count as old. */
static double clamp_age(double age)
{
    return age <= OUTPUT_NEVER ? vbss_max(age, 0.0) : OUTPUT_NEVER;
}

static bool is_finite(const output_demand *d)
{
    return vec3_is_finite(d->force) && vec3_is_finite(d->torque) && isfinite(d->temperature) &&
           d->age == d->age && d->input_age == d->input_age;
}

/* The demand with bounded ages, and without forces and temperature if a number is not finite. */
static output_demand sanitise_demand(const output_demand *d)
{
    output_demand k = *d;
    k.age = clamp_age(d->age);
    k.input_age = clamp_age(d->input_age);
    if (!is_finite(d)) {
        k.force = k.torque = vec3_zero();
        k.temperature = 0.0;
    }
    return k;
}

/* ---- watchdog */

/* Fraction of the outputs at the start of the ramp that is still allowed. Sets flags for a stale
 * pose or command. */
static double ramp_fraction(const vbss_output_config *c, const output_demand *d, uint32_t *flags)
{
    double input = d->input_age - c->input_timeout, command = d->age - c->command_timeout;
    *flags |= input > 0.0 ? VBSS_OUTPUT_FLAG_INPUT_STALE : 0u;
    *flags |= command > 0.0 ? VBSS_OUTPUT_FLAG_COMMAND_STALE : 0u;
    double elapsed = vbss_max(input, command);
    return c->ramp_time > 0.0 ? vbss_max(1.0 - elapsed / c->ramp_time, 0.0) : 0.0;
}

static void run_watchdog(const vbss_output_config *c, output_state *s, const output_demand *d,
                         const double before[2], uint32_t *flags)
{
    const uint32_t stale = VBSS_OUTPUT_FLAG_INPUT_STALE | VBSS_OUTPUT_FLAG_COMMAND_STALE;
    uint32_t shorter = 0;
    double fraction = ramp_fraction(c, d, flags);
    if ((*flags & stale) == 0) {
        s->is_ramping = false;
        return;
    }
    if (!s->is_ramping) {
        s->is_ramping = true;
        s->ramp_force = before[0];
        s->ramp_torque = before[1];
        s->statistics.watchdogs++;
    }
    s->force = clamp_length(s->force, fraction * s->ramp_force, 0, &shorter);
    s->torque = clamp_length(s->torque, fraction * s->ramp_torque, 0, &shorter);
}

/* ---- step */

static void count_flags(vbss_output_statistics *f, uint32_t flags)
{
    const struct {
        uint32_t flag;
        uint64_t *times;
    } all[] = {{VBSS_OUTPUT_FLAG_NOT_FINITE, &f->not_finite},
               {VBSS_OUTPUT_FLAG_FAULT, &f->faults},
               {VBSS_OUTPUT_FLAG_CLAMPED, &f->clamped},
               {VBSS_OUTPUT_FLAG_CONTINUOUS, &f->continuous},
               {VBSS_OUTPUT_FLAG_WARM, &f->warm},
               {VBSS_OUTPUT_FLAG_SLEWED, &f->slewed},
               {VBSS_OUTPUT_FLAG_INPUT_STALE, &f->input_stale},
               {VBSS_OUTPUT_FLAG_COMMAND_STALE, &f->command_stale},
               {VBSS_OUTPUT_FLAG_STOPPED, &f->stopped},
               {VBSS_OUTPUT_FLAG_LATE, &f->late},
               {VBSS_OUTPUT_FLAG_SOLENOID_OFF, &f->solenoid_off},
               {VBSS_OUTPUT_FLAG_SOLENOID_SPENT, &f->solenoid_spent}};
    f->steps++;
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        *all[i].times += (flags & all[i].flag) != 0 ? 1 : 0;
    }
}

static void update_force(const vbss_output_config *c, output_state *s, double h,
                         const output_demand *d, uint32_t *flags)
{
    const vector_limits force = {c->max_force, c->continuous_force, c->force_rise};
    const vector_limits torque = {c->max_torque, c->continuous_torque, c->torque_rise};
    const double before[2] = {vec3_norm(s->force), vec3_norm(s->torque)};
    double factor = device_smoothing_factor(h, c->load_time);
    s->force_load = update_load(s->force_load, s->force, factor);
    s->torque_load = update_load(s->torque_load, s->torque, factor);
    s->force = apply_limits(c, &force, s->force, d->force, s->force_load, d->temperature, h, flags);
    s->torque =
        apply_limits(c, &torque, s->torque, d->torque, s->torque_load, d->temperature, h, flags);
    run_watchdog(c, s, d, before, flags);
}

uint32_t vbss_output_advance(const vbss_output_config *c, output_state *s, double h,
                             const output_demand *demand)
{
    const uint32_t off =
        VBSS_OUTPUT_FLAG_NOT_FINITE | VBSS_OUTPUT_FLAG_FAULT | VBSS_OUTPUT_FLAG_STOPPED;
    const output_demand d = sanitise_demand(demand);
    uint32_t flags = is_finite(demand) ? 0 : VBSS_OUTPUT_FLAG_NOT_FINITE;
    flags |= demand->has_fault ? VBSS_OUTPUT_FLAG_FAULT : 0u;
    flags |= s->is_stopped ? VBSS_OUTPUT_FLAG_STOPPED : 0u;
    flags |= h > c->command_timeout ? VBSS_OUTPUT_FLAG_LATE : 0u;
    update_force(c, s, h, &d, &flags);
    if ((flags & off) != 0) {
        s->force = s->torque = vec3_zero();
    }
    const uint32_t reasons = off | VBSS_OUTPUT_FLAG_INPUT_STALE | VBSS_OUTPUT_FLAG_COMMAND_STALE;
    bool blocked = (flags & reasons) != 0 || demand->block_solenoid;
    flags |=
        vbss_output_switch_solenoid(c, &s->solenoid, h, demand->solenoid, blocked, &s->statistics);
    count_flags(&s->statistics, flags);
    s->statistics.largest_force = vbss_max(s->statistics.largest_force, vec3_norm(s->force));
    s->statistics.largest_torque = vbss_max(s->statistics.largest_torque, vec3_norm(s->torque));
    return flags;
}

void vbss_output_init_state(const vbss_output_config *c, output_state *s)
{
    memset(s, 0, sizeof *s);
    s->last_demand.age = s->last_demand.input_age = OUTPUT_NEVER; /* no command yet */
    s->solenoid.time_left = c->solenoid_time;
}

output_demand vbss_output_repeat_demand(const output_state *s, double h)
{
    output_demand d = s->last_demand;
    d.age += h;
    d.input_age += h;
    return d;
}

void vbss_output_store_demand(output_state *s, const output_demand *demand)
{
    s->last_demand = sanitise_demand(demand);
}

void vbss_output_set_zero(output_state *s)
{
    s->force = s->torque = vec3_zero();
    s->solenoid.is_on = false;
}

void vbss_output_latch_stop(output_state *s)
{
    s->statistics.stops += s->is_stopped ? 0 : 1;
    s->is_stopped = true;
    vbss_output_set_zero(s);
}

/* ---- commands and results */

output_demand vbss_output_make_demand(const vbss_output_command *command)
{
    output_demand d = {.force = vec3_load(command->force),
                       .torque = vec3_load(command->torque),
                       .age = command->age,
                       .input_age = command->input_age,
                       .temperature = command->temperature,
                       .solenoid = command->solenoid != 0,
                       .has_fault = command->fault != 0};
    return d;
}

static double load_fraction(double load, double continuous)
{
    double limit_squared = continuous * continuous;
    return limit_squared < 1e-100 ? (double)(load > 0.0) : vbss_min(load / limit_squared, 1e100);
}

void vbss_output_fill_result(const vbss_output_config *c, const output_state *s, uint32_t flags,
                             vbss_output_result *result)
{
    *result = (vbss_output_result){
        .struct_size = sizeof *result,
        .flags = flags,
        .solenoid = s->solenoid.is_on,
        .force_load = load_fraction(s->force_load, c->continuous_force),
        .torque_load = load_fraction(s->torque_load, c->continuous_torque),
        .solenoid_left = s->solenoid.time_left,
        .expires = c->command_timeout + c->ramp_time,
    };
    vec3_store(result->force, s->force);
    vec3_store(result->torque, s->torque);
}
