/* Random choices. Numbers of bodies are mostly those of bodies in the scene. */
#include "fuzz/scenes/fuzzed_scene.h"

uint32_t fuzz_below(fuzz_scene *f, uint32_t bound)
{
    return harness_draw_below(&f->source, bound);
}

bool fuzz_chance(fuzz_scene *f, double probability)
{
    return harness_draw_real(&f->source, 0.0, 1.0) < probability;
}

double fuzz_real(fuzz_scene *f, double low, double high)
{
    return harness_draw_real(&f->source, low, high);
}

double fuzz_small(fuzz_scene *f, double low, double high)
{
    const double u = harness_draw_real(&f->source, 0.0, 1.0);
    return low + (high - low) * u * u * u;
}

vec3 fuzz_direction(fuzz_scene *f)
{
    return quat_rotate(fuzz_turn(f), vec3_make(1.0, 0.0, 0.0));
}

vec3 fuzz_vector(fuzz_scene *f, double length)
{
    const vec3 direction = fuzz_direction(f);
    return vec3_scale(direction, fuzz_small(f, 0.0, length));
}

pose fuzz_pose(fuzz_scene *f)
{
    const vec3 position = fuzz_point(f);
    return pose_make(position, fuzz_turn(f));
}

vec3 fuzz_point(fuzz_scene *f)
{
    vec3 at = harness_draw_vec3(&f->source, -0.012, 0.012);
    at.y += 0.01;
    return at;
}

quat fuzz_turn(fuzz_scene *f)
{
    return harness_draw_unit_quat(&f->source);
}

double fuzz_spoil(fuzz_scene *f, double value)
{
    const bool is_spoilt = fuzz_chance(f, 0.01);
    return is_spoilt ? harness_draw_any_double(&f->source) : value;
}

uint32_t fuzz_spoil_number(fuzz_scene *f, uint32_t number)
{
    const bool is_spoilt = fuzz_chance(f, 0.04);
    uint32_t other =
        FUZZ_PICK(f, 0, 1, number + 1, f->last_number + 1, f->last_number, 1000, UINT32_MAX);
    /* The witness stays alone. */
    return is_spoilt && (other == 0 || other != f->witness.number) ? other : number;
}

uint32_t fuzz_choose(fuzz_scene *f, fuzz_kind kind)
{
    uint32_t found[FUZZ_MAX_BODIES], count = 0;
    for (uint32_t i = 1; i <= f->last_number; i++) {
        if (f->bodies[i].kind == kind && !f->bodies[i].is_removed && i != f->witness.number) {
            found[count++] = i;
        }
    }
    return count == 0 ? 0 : found[fuzz_below(f, count)];
}

uint32_t fuzz_pick(fuzz_scene *f, const uint32_t *values, uint32_t count)
{
    return values[fuzz_below(f, count)];
}
