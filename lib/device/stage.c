/* What may go out: each part makes forces smaller or leaves them, and says what it did.
 *
 *     finite? -> magnitude -> continuous load -> temperature -> rise -> watchdog -> emergency stop
 *
 * docs/devices.md has the formulas. Nothing here knows a device or a context: adapters use it on threads of their
 * own. */
#include <string.h>

#include "base/check.h"
#include "device/device.h"

/* The load at which forces begin to be lowered, as a part of what may go on for ever. */
#define KNEE 0.75
/* Of a part that has nothing to say. */
#define NO_LIMIT DBL_MAX

/* ---- one vector */

/* Limits of a force or a torque. */
typedef struct limits {
    double most, lasting, rise;
} limits;

/* No longer than the limit, in its own direction. */
static vec3 shortened(vec3 v, double limit, uint32_t flag, uint32_t *flags)
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

/* From the peak down to what lasts, as the mean square comes near to the square of that. */
static double lasting_limit(const limits *l, double load)
{
    double full = l->lasting * l->lasting;
    if (l->lasting >= l->most) {
        return NO_LIMIT;
    }
    if (full < 1e-100 || load >= full) {
        return l->lasting;
    }
    double part = (full - load) / ((1.0 - KNEE) * full);
    return part < 1.0 ? sqrt(full + part * (l->most * l->most - full)) : NO_LIMIT;
}

static double warm_limit(const vbss_output_config *c, const limits *l, double temperature)
{
    double part = (c->hot - temperature) / (c->hot - c->warm);
    return part < 1.0 ? l->most * vbss_max(part, 0.0) : NO_LIMIT;
}

/* Falling along the last force is free; from there, towards what is wanted, only so far. What comes out is never
 * longer than what is wanted. */
static vec3 risen(vec3 last, vec3 wanted, double reach, uint32_t *flags)
{
    double square = vec3_norm_squared(last);
    double part = square > 0.0 ? vec3_dot(wanted, last) / square : 0.0;
    vec3 from = vec3_scale(last, vbss_min(vbss_max(part, 0.0), 1.0));
    vec3 way = vec3_sub(wanted, from);
    double n = vec3_norm(way);
    if (!(n > reach)) {
        return wanted;
    }
    *flags |= VBSS_OUTPUT_SLEWED;
    return vec3_add_scaled(from, reach / n, way);
}

static vec3 limited(const vbss_output_config *c, const limits *l, vec3 last, vec3 wanted,
                    double load, double temperature, double h, uint32_t *flags)
{
    vec3 v = shortened(wanted, l->most, VBSS_OUTPUT_CLAMPED, flags);
    v = shortened(v, lasting_limit(l, load), VBSS_OUTPUT_CONTINUOUS, flags);
    v = shortened(v, warm_limit(c, l, temperature), VBSS_OUTPUT_WARM, flags);
    return risen(last, v, l->rise * vbss_min(h, OUTPUT_LONGEST), flags);
}

/* Mean square after h seconds of a constant v: (1 - exp(-h/T)) v^2 + exp(-h/T) of what it was. */
static double loaded(double load, vec3 v, double share)
{
    return load + share * (vec3_norm_squared(v) - load);
}

/* ---- ages */

/* NaN and infinity are old, too. */
static double age_of(double age)
{
    return age <= OUTPUT_NEVER ? vbss_max(age, 0.0) : OUTPUT_NEVER;
}

static bool is_finite(const output_demand *d)
{
    return vec3_is_finite(d->force) && vec3_is_finite(d->torque) && isfinite(d->temperature) &&
           d->age == d->age && d->input_age == d->input_age;
}

/* With nothing in it that cannot be computed with. */
static output_demand made_finite(const output_demand *d)
{
    output_demand k = *d;
    k.age = age_of(d->age);
    k.input_age = age_of(d->input_age);
    if (!is_finite(d)) {
        k.force = k.torque = vec3_zero();
        k.temperature = 0.0;
    }
    return k;
}

/* ---- the watchdog: how much of the force at which it began is left */

static double left_of_ramp(const vbss_output_config *c, const output_demand *d, uint32_t *flags)
{
    double input = d->input_age - c->input_timeout, command = d->age - c->command_timeout;
    *flags |= input > 0.0 ? VBSS_OUTPUT_INPUT_STALE : 0u;
    *flags |= command > 0.0 ? VBSS_OUTPUT_COMMAND_STALE : 0u;
    double elapsed = vbss_max(input, command);
    return c->ramp_time > 0.0 ? vbss_max(1.0 - elapsed / c->ramp_time, 0.0) : 0.0;
}

static void watch(const vbss_output_config *c, output_state *s, const output_demand *d,
                  const double before[2], uint32_t *flags)
{
    const uint32_t stale = VBSS_OUTPUT_INPUT_STALE | VBSS_OUTPUT_COMMAND_STALE;
    uint32_t shorter = 0;
    double part = left_of_ramp(c, d, flags);
    if ((*flags & stale) == 0) {
        s->ramping = false;
        return;
    }
    if (!s->ramping) {
        s->ramping = true;
        s->ramp_force = before[0];
        s->ramp_torque = before[1];
        s->statistics.watchdogs++;
    }
    s->force = shortened(s->force, part * s->ramp_force, 0, &shorter);
    s->torque = shortened(s->torque, part * s->ramp_torque, 0, &shorter);
}

/* ---- the step */

static void count(vbss_output_statistics *f, uint32_t flags)
{
    const struct {
        uint32_t flag;
        uint64_t *times;
    } all[] = {{VBSS_OUTPUT_NOT_FINITE, &f->not_finite},
               {VBSS_OUTPUT_FAULT, &f->faults},
               {VBSS_OUTPUT_CLAMPED, &f->clamped},
               {VBSS_OUTPUT_CONTINUOUS, &f->continuous},
               {VBSS_OUTPUT_WARM, &f->warm},
               {VBSS_OUTPUT_SLEWED, &f->slewed},
               {VBSS_OUTPUT_INPUT_STALE, &f->input_stale},
               {VBSS_OUTPUT_COMMAND_STALE, &f->command_stale},
               {VBSS_OUTPUT_STOPPED, &f->stopped},
               {VBSS_OUTPUT_LATE, &f->late},
               {VBSS_OUTPUT_SOLENOID_OFF, &f->solenoid_off},
               {VBSS_OUTPUT_SOLENOID_SPENT, &f->solenoid_spent}};
    f->steps++;
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        *all[i].times += (flags & all[i].flag) != 0 ? 1 : 0;
    }
}

static void move_force(const vbss_output_config *c, output_state *s, double h,
                       const output_demand *d, uint32_t *flags)
{
    const limits force = {c->max_force, c->continuous_force, c->force_rise};
    const limits torque = {c->max_torque, c->continuous_torque, c->torque_rise};
    const double before[2] = {vec3_norm(s->force), vec3_norm(s->torque)};
    double share = device_share(h, c->load_time);
    s->force_load = loaded(s->force_load, s->force, share);
    s->torque_load = loaded(s->torque_load, s->torque, share);
    s->force = limited(c, &force, s->force, d->force, s->force_load, d->temperature, h, flags);
    s->torque = limited(c, &torque, s->torque, d->torque, s->torque_load, d->temperature, h, flags);
    watch(c, s, d, before, flags);
}

uint32_t vbss_output_advance(const vbss_output_config *c, output_state *s, double h,
                             const output_demand *demand)
{
    const uint32_t off = VBSS_OUTPUT_NOT_FINITE | VBSS_OUTPUT_FAULT | VBSS_OUTPUT_STOPPED;
    const output_demand d = made_finite(demand);
    uint32_t flags = is_finite(demand) ? 0 : VBSS_OUTPUT_NOT_FINITE;
    flags |= demand->fault ? VBSS_OUTPUT_FAULT : 0u;
    flags |= s->stopped ? VBSS_OUTPUT_STOPPED : 0u;
    flags |= h > c->command_timeout ? VBSS_OUTPUT_LATE : 0u;
    move_force(c, s, h, &d, &flags);
    if ((flags & off) != 0) {
        s->force = s->torque = vec3_zero();
    }
    const uint32_t reasons = off | VBSS_OUTPUT_INPUT_STALE | VBSS_OUTPUT_COMMAND_STALE;
    bool blocked = (flags & reasons) != 0 || demand->held_off;
    flags |= vbss_output_switch(c, &s->solenoid, h, demand->solenoid, blocked, &s->statistics);
    count(&s->statistics, flags);
    s->statistics.largest_force = vbss_max(s->statistics.largest_force, vec3_norm(s->force));
    s->statistics.largest_torque = vbss_max(s->statistics.largest_torque, vec3_norm(s->torque));
    return flags;
}

void vbss_output_begin(const vbss_output_config *c, output_state *s)
{
    memset(s, 0, sizeof *s);
    s->last.age = s->last.input_age = OUTPUT_NEVER; /* nothing was wanted yet */
    s->solenoid.left = c->solenoid_time;
}

output_demand vbss_output_again(const output_state *s, double h)
{
    output_demand d = s->last;
    d.age += h;
    d.input_age += h;
    return d;
}

void vbss_output_keep(output_state *s, const output_demand *demand)
{
    s->last = made_finite(demand);
}

void vbss_output_latch(output_state *s)
{
    s->statistics.stops += s->stopped ? 0 : 1;
    s->stopped = true;
    s->force = s->torque = vec3_zero();
    s->solenoid.on = false;
}

/* ---- what goes in and out of it */

output_demand vbss_output_demand_of(const vbss_output_command *command)
{
    output_demand d = {.force = vec3_load(command->force),
                       .torque = vec3_load(command->torque),
                       .age = command->age,
                       .input_age = command->input_age,
                       .temperature = command->temperature,
                       .solenoid = command->solenoid != 0,
                       .fault = command->fault != 0};
    return d;
}

static double part_of(double load, double lasting)
{
    double full = lasting * lasting;
    return full < 1e-100 ? (double)(load > 0.0) : vbss_min(load / full, 1e100);
}

void vbss_output_tell(const vbss_output_config *c, const output_state *s, uint32_t flags,
                      vbss_output_result *result)
{
    *result = (vbss_output_result){
        .struct_size = sizeof *result,
        .flags = flags,
        .solenoid = s->solenoid.on,
        .force_load = part_of(s->force_load, c->continuous_force),
        .torque_load = part_of(s->torque_load, c->continuous_torque),
        .solenoid_left = s->solenoid.left,
        .expires = c->command_timeout + c->ramp_time,
    };
    vec3_store(result->force, s->force);
    vec3_store(result->torque, s->torque);
}
