/* Targets of tools: around a thread or a needle, and the motion from call to call. */
#include "fuzz/scenes/fuzzed_scene.h"

#include "base/rotation.h"

/* No tool goes to the witness, m. */
#define CEILING 1.0

static bool find_place_on_thread(fuzz_scene *f, uint32_t body, vec3 *place, vec3 *tangent)
{
    vbss_thread *thread;
    vbss_view x;
    if (vbss_scene_get_thread(f->sides[0].scene, body, &thread) != VBSS_OK ||
        vbss_thread_get_view(thread, VBSS_THREAD_VIEW_POSITIONS, &x, sizeof x) != VBSS_OK) {
        return false;
    }
    const uint32_t i = fuzz_below(f, (uint32_t)x.count - 1);
    const char *first = (const char *)x.data + (size_t)i * x.stride_bytes;
    const vec3 a = vec3_load((const double *)(const void *)first);
    const vec3 b = vec3_load((const double *)(const void *)(first + x.stride_bytes));
    *place = vec3_lerp(a, b, 0.5);
    *tangent = vec3_unit_or(vec3_sub(b, a), vec3_make(1.0, 0.0, 0.0));
    return true;
}

static bool find_place_on_needle(fuzz_scene *f, uint32_t body, vec3 *place, vec3 *tangent)
{
    vbss_needle *needle = f->sides[0].handles[body];
    vbss_needle_mass mass;
    double position[3], direction[3];
    if (vbss_needle_get_mass(needle, &mass, sizeof mass) != VBSS_OK ||
        vbss_needle_get_place(needle, fuzz_real(f, 0.1, 0.9) * mass.length, position, direction) !=
            VBSS_OK) {
        return false;
    }
    *place = vec3_load(position);
    *tangent = vec3_unit_or(vec3_load(direction), vec3_make(1.0, 0.0, 0.0));
    return true;
}

/* The jaws open along x, and reach from the tip along z: y is along the thread. */
bool fuzz_set_target(fuzz_scene *f, uint32_t body, pose *at)
{
    vec3 place = vec3_zero(), tangent = vec3_zero();
    const fuzz_kind kind = body < FUZZ_MAX_BODIES ? f->bodies[body].kind : FUZZ_NONE;
    const double turn = fuzz_real(f, -3.1, 3.1), depth = fuzz_real(f, 5e-4, 8e-3);
    const bool is_found = kind == FUZZ_NEEDLE ? find_place_on_needle(f, body, &place, &tangent)
                                              : kind == FUZZ_THREAD &&
                                                    find_place_on_thread(f, body, &place, &tangent);
    if (!is_found) {
        return false;
    }
    const quat about = vbss_quat_from_rotation_vector(vec3_scale(tangent, turn));
    at->orientation = quat_unit(quat_mul(about, quat_between(vec3_make(0.0, 1.0, 0.0), tangent)));
    const vec3 along = quat_rotate(at->orientation, vec3_make(0.0, 0.0, 1.0));
    at->position = vec3_add_scaled(place, -depth, along);
    return true;
}

static void turn_velocity(fuzz_scene *f, fuzz_body *body)
{
    const double speed = fuzz_small(f, 0.0, 0.5);
    const vec3 direction = fuzz_direction(f);
    const vec3 turn = fuzz_vector(f, 0.05);
    if (fuzz_chance(f, 0.1)) {
        body->velocity = vec3_scale(direction, speed);
    }
    if (fuzz_chance(f, 0.3)) {
        body->turn = quat_unit(quat_mul(vbss_quat_from_rotation_vector(turn), body->turn));
    }
    if (vec3_norm(body->tip) > 0.05) { /* back to the middle */
        body->velocity = vec3_scale(vec3_unit_or(body->tip, direction), -speed);
    }
}

static void spoil_one(fuzz_scene *f, double *numbers, uint32_t count)
{
    const uint32_t i = fuzz_below(f, count);
    numbers[i] = fuzz_spoil(f, numbers[i]);
}

void fuzz_move_tool(fuzz_scene *f, uint32_t number)
{
    fuzz_body *body = &f->bodies[number];
    double tip[3], turn[4];
    turn_velocity(f, body);
    body->tip = vec3_add_scaled(body->tip, f->h, body->velocity);
    pose_store(pose_make(body->tip, body->turn), tip, turn);
    spoil_one(f, tip, 3);
    spoil_one(f, turn, 4);
    tip[1] = tip[1] > CEILING ? -tip[1] : tip[1];
    if (body->kind == FUZZ_GRASPER) {
        FUZZ_CALL(f, vbss_grasper_set_target(side->handles[number], tip, turn));
    } else {
        FUZZ_CALL(f, vbss_scene_set_rigid_target(side->scene, number, tip, turn));
    }
}
