/* Rigid bodies whose shape is a mesh: they push and bear as bodies of capsules do, a cylinder that turns under a thread keeps
 * the law of the rope, momentum is kept and no energy appears; a saved scene has them; refused input changes nothing;
 * one that is far away costs nothing. */
#include <stdlib.h>
#include <string.h>

#include "base/rotation.h"
#include "scene/box_mesh.h"
#include "scene/capstan_rig.h"
#include "scene/small.h"

#define THICKNESS 0.5e-3
#define GRAVITY 9.81

/* ---- meshes */

static uint32_t add_box(small *s, vbss_scene_rigid_kind kind, vec3 half, double thickness,
                        vec3 position)
{
    box_mesh b;
    uint32_t body = 0;
    box_mesh_make(&b, half, thickness);
    b.config.friction = s->rigid.friction;
    s->rigid.kind = kind;
    s->rigid.capsules = NULL;
    s->rigid.capsule_count = 0;
    vec3_store(s->rigid.position, position);
    expect_ok(vbss_scene_add_rigid_mesh(s->scene, &s->rigid, &b.config, &body));
    return body;
}

static void begin(small *s)
{
    small_begin(s);
    s->config.floor = 0;
    s->config.node_capacity = 400;
    s->config.contact_capacity = 4096;
    s->config.candidate_capacity = 65536;
}

static vec3 force_on(const small *s, uint32_t body)
{
    return vec3_load(small_rigid(s, body).contact_force);
}

static double mass_of(vbss_thread *thread)
{
    const thread_object *t = ((vbss_slot *)thread)->object;
    double mass = 0.0;
    for (uint32_t i = 0; i < t->node_count; i++) {
        mass += t->mass[i];
    }
    return mass;
}

/* ---- forces */

/* A box lifts a thread at constant speed: it bears its weight, and the torque about its frame is that of the
 * weight at the middle of the thread. */
static void box_that_rises_bears_the_weight_of_a_thread(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    begin(&s);
    s.thread.gravity[1] = -GRAVITY;
    small_create(&s);
    const vec3 middle = vec3_make(30e-3, 20e-3, -10e-3); /* of the box */
    const uint32_t body =
        add_box(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(20e-3, 3e-3, 20e-3), THICKNESS, middle);
    const double top = middle.y + 3e-3 + 0.5 * THICKNESS + s.thread.radius;
    small_thread(&s, vec3_make(27e-3, top, -18e-3), vec3_make(27e-3, top, 2e-3), 20, &thread);
    for (int i = 1; i <= 300; i++) {
        small_move(&s, body, vec3_add_scaled(middle, i * 1e-3, vec3_make(0.0, 0.02, 0.0)));
        small_steps(&s, 1, 1e-3);
    }
    const vbss_scene_rigid_state state_of = small_rigid(&s, body);
    const double weight = mass_of(thread) * GRAVITY;
    expect_near(-weight, state_of.contact_force[1], 0.01 * weight);
    expect_near(0.0,
                vec3_norm(vec3_make(state_of.contact_force[0], 0.0, state_of.contact_force[2])),
                0.01 * weight);
    /* (-3, ., 2) mm from the origin of its frame: r x F */
    const vec3 arm = vec3_sub(small_node(thread, 10), small_position(&s, body));
    const vec3 torque = vec3_cross(arm, vec3_make(0.0, -weight, 0.0));
    expect_near(0.0, vec3_distance(torque, vec3_load(state_of.contact_torque)),
                0.02 * vec3_norm(torque));
    expect_near(middle.y + 0.02 * 0.3 + 3e-3 + 0.5 * THICKNESS + s.thread.radius,
                small_node(thread, 10).y, 0.01e-3);
    small_end(&s);
}

typedef struct pushed {
    double hand, contact; /* N, along y */
    double depth;         /* of the thread's middle, m */
} pushed;

enum { FINE = 120 }; /* segments of a thread of 30 mm */

/* A body without friction rises 2 mm into a taut thread, and turns about the axis of the thread by a quarter of a
 * radian. `is_mesh`: a box as thin as nothing, whose wall has the shape of the capsule; otherwise the capsule. */
static pushed push_taut_thread(vbss_scene_rigid_kind kind, bool is_mesh)
{
    small s;
    vbss_thread *thread;
    uint32_t body;
    const double radius = 1e-3, half = 6e-3;
    begin(&s);
    small_create(&s);
    s.rigid.friction = 0.0;
    const uint32_t number =
        small_thread(&s, vec3_make(-15e-3, 0.0, 0.0), vec3_make(15e-3, 0.0, 0.0), FINE, &thread);
    small_pin_ends(&s, number, FINE + 1);
    const vec3 below = vec3_make(0.31e-3, -radius - s.thread.radius - 0.2e-3, 0.0);
    body = is_mesh ? add_box(&s, kind, vec3_make(1e-8, 1e-8, half), 2.0 * radius, below)
                   : small_stick(&s, kind, below, vec3_make(0.0, 0.0, half), radius);
    for (int i = 1; i <= 200; i++) {
        const double part = fmin(1.0, i / 100.0), angle = 0.25 * part;
        const double orientation[4] = {cos(0.5 * angle), sin(0.5 * angle), 0.0, 0.0};
        double at[3];
        vec3_store(at, vec3_add(below, vec3_make(0.0, 2e-3 * part, 0.0)));
        expect_ok(vbss_scene_set_rigid_target(s.scene, body, at, orientation));
        small_steps(&s, 1, 1e-3);
    }
    const vbss_scene_rigid_state got = small_rigid(&s, body);
    const pushed p = {got.hand_force[1], got.contact_force[1], small_node(thread, FINE / 2).y};
    small_end(&s);
    return p;
}

/* The edges of the mesh touch segments, the capsule smoothed nodes: both converge to one force with the first power of the
 * segments, from 12 % between them at 30. */
static void mesh_pushes_a_thread_as_the_capsule_of_its_shape(void **state)
{
    (void)state;
    const vbss_scene_rigid_kind kinds[] = {VBSS_SCENE_RIGID_DRIVEN, VBSS_SCENE_RIGID_COUPLED};
    for (int i = 0; i < 2; i++) {
        const pushed capsule = push_taut_thread(kinds[i], false),
                     mesh = push_taut_thread(kinds[i], true);
        assert_true(capsule.contact < -0.4);
        expect_near(capsule.contact, mesh.contact, 0.015 * fabs(capsule.contact));
        expect_near(capsule.hand, mesh.hand, 0.015 * fabs(capsule.hand));
        expect_near(capsule.depth, mesh.depth, 0.01e-3);
    }
}

/* A box moves against a thread between two pins, up and along it, or the pins against the box, which then is a static
 * mesh. Returns the force on the box at rest, friction included. */
static vec3 press_box(bool moves)
{
    small s;
    box_mesh b;
    uint32_t body;
    begin(&s);
    small_create(&s);
    const uint32_t thread =
        small_thread(&s, vec3_make(-15e-3, 0.0, 0.0), vec3_make(15e-3, 0.0, 1e-3), 30, NULL);
    const uint32_t carrier = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, 90e-3, 0.0),
                                         vec3_make(1e-3, 0.0, 0.0), 1e-3);
    small_pin(&s, thread, 0, carrier);
    small_pin(&s, thread, 30, carrier);
    const vec3 below = vec3_make(1e-3, -3.5e-3, 0.0);
    box_mesh_make(&b, vec3_make(4e-3, 3e-3, 5e-3), THICKNESS);
    b.config.friction = 0.25;
    if (moves) {
        vec3_store(s.rigid.position, below);
        s.rigid.capsules = NULL;
        s.rigid.capsule_count = 0;
        expect_ok(vbss_scene_add_rigid_mesh(s.scene, &s.rigid, &b.config, &body));
    } else {
        for (int i = 0; i < 8; i++) {
            vec3_store(b.vertices[i], vec3_add(vec3_load(b.vertices[i]), below));
        }
        expect_ok(vbss_scene_add_static_mesh(s.scene, &b.config, &body));
    }
    for (int i = 1; i <= 400; i++) {
        const double part = fmin(1.0, i / 200.0);
        const vec3 path = vec3_make(1.5e-3 * part * part, 2e-3 * part, 0.5e-3 * part);
        if (moves) {
            small_move(&s, body, vec3_add(below, path));
        } else {
            small_move(&s, carrier, vec3_sub(vec3_make(0.0, 90e-3, 0.0), path));
        }
        small_steps(&s, 1, 1e-3);
    }
    const vec3 force = force_on(&s, body);
    small_end(&s);
    return force;
}

static void moving_mesh_gets_the_force_of_a_static_one_that_the_thread_moves_to(void **state)
{
    (void)state;
    const vec3 moving = press_box(true), resting = press_box(false);
    assert_true(resting.y < -0.1 && fabs(resting.x) > 0.01);
    expect_near(0.0, vec3_distance(moving, resting), 2e-3 * vec3_norm(resting));
}

/* ---- the law of the rope over a cylinder that turns */

#define WIDTH 3e-3
#define ASIDE 0.13e-3 /* the thread runs along no line of the mesh */
enum { AXIAL_CELLS = 4, MAX_ROUND = 90, CYLINDER_VERTICES = (AXIAL_CELLS + 1) * MAX_ROUND };
static uint32_t round_cells, cylinder;
static double turned;

static void add_cylinder(capstan *c)
{
    double x[CYLINDER_VERTICES][3];
    uint32_t triangles[2 * AXIAL_CELLS * MAX_ROUND][3], count = 0;
    for (uint32_t i = 0; i < round_cells * (AXIAL_CELLS + 1); i++) {
        const uint32_t row = i / (AXIAL_CELLS + 1);
        const double angle = 2.0 * CAPSTAN_PI * (row + 0.5) / round_cells;
        x[i][0] = -(CAPSTAN_RADIUS - 0.5 * THICKNESS) * cos(angle);
        x[i][1] = (CAPSTAN_RADIUS - 0.5 * THICKNESS) * sin(angle);
        x[i][2] = WIDTH * ((double)(i % (AXIAL_CELLS + 1)) / AXIAL_CELLS - 0.5) + ASIDE;
    }
    for (uint32_t i = 0; i < round_cells * AXIAL_CELLS; i++, count += 2) {
        const uint32_t column = i / AXIAL_CELLS, row = i % AXIAL_CELLS;
        const uint32_t a = column * (AXIAL_CELLS + 1) + row;
        const uint32_t b = (column + 1) % round_cells * (AXIAL_CELLS + 1) + row;
        const uint32_t cell[2][3] = {{a, a + 1, b + 1}, {a, b + 1, b}};
        memcpy(triangles[count], cell, sizeof cell);
    }
    vbss_scene_static_mesh_config mesh = vbss_scene_static_mesh_config_default();
    mesh.vertex_count = round_cells * (AXIAL_CELLS + 1);
    mesh.triangle_count = count;
    mesh.vertices = x[0];
    mesh.triangles = triangles[0];
    mesh.thickness = THICKNESS;
    mesh.friction = c->friction;
    turned = 0.0;
    expect_ok(vbss_scene_add_rigid_mesh(c->rig.scene, NULL, &mesh, &cylinder));
}

static void turn_cylinder(capstan *c, double distance)
{
    turned += distance / CAPSTAN_RADIUS;
    const double at[3] = {0.0, 0.0, 0.0};
    const double orientation[4] = {cos(0.5 * turned), 0.0, 0.0, sin(0.5 * turned)};
    expect_ok(vbss_scene_set_rigid_target(c->rig.scene, cylinder, at, orientation));
}

static void tension_over_a_turning_mesh_follows_capstan_equation(void **state)
{
    (void)state;
    const uint32_t cells[] = {18, 24, 60, MAX_ROUND};
    for (int i = 0; i < 4; i++) {
        capstan c = capstan_half_turn(0.3);
        round_cells = cells[i];
        c.fineness = 0.2;
        c.speed = i % 2 == 0 ? 2e-3 : 10e-3;
        c.add_cylinder = add_cylinder;
        c.turn_cylinder = turn_cylinder;
        const double got = capstan_pulled_over(&c);
        if (getenv("VBSS_PRINT") != NULL) {
            printf("cells %u speed %g: exponent %.5f of the law\n", cells[i], c.speed,
                   got / (0.3 * c.angle));
        }
        expect_near(1.0, got / (0.3 * c.angle), 0.0125);
    }
}

/* ---- tissue */

/* A box presses the wall of a drain from above: it is pushed up, and no node of the wall gets into it. */
static void box_presses_a_drain(void **state)
{
    (void)state;
    small s;
    vbss_drain *drain;
    begin(&s);
    s.config.drain_capacity = 1;
    small_create(&s);
    const uint32_t wall = small_drain(&s, &drain);
    const drain_object *d = vbss_scene_body(small_object(&s), wall)->drain.drain;
    vec3 highest = d->x[0];
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        highest = d->x[i].y > highest.y ? d->x[i] : highest;
    }
    const double half = 2e-3, outside = half + 0.5 * THICKNESS + 0.5 * d->config.thickness;
    const vec3 above = vec3_add(highest, vec3_make(0.0, outside + 0.2e-3, 0.0));
    const uint32_t body =
        add_box(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(3e-3, half, 3e-3), THICKNESS, above);
    double force = 0.0;
    for (int i = 1; i <= 60; i++) {
        small_move(&s, body, vec3_add(above, vec3_make(0.0, -0.02e-3 * i, 0.0)));
        small_steps(&s, 1, 1e-3);
        force = fmax(force, force_on(&s, body).y);
        const vec3 middle = small_position(&s, body);
        for (uint32_t k = 0; k < d->mesh.node_count; k++) {
            const vec3 at = vec3_sub(d->x[k], middle);
            assert_true(fabs(at.x) > 3e-3 || fabs(at.z) > 3e-3 || at.y < -half);
        }
    }
    assert_true(force > 1e-3);
    expect_near(0.0, small_position(&s, body).y - (above.y - 1.2e-3), 1e-6);
    small_end(&s);
}

/* ---- momentum and energy */

/* A thread flies against a free box, off its centre. */
static void collision_with_a_free_mesh_keeps_momentum_and_adds_no_energy(void **state)
{
    (void)state;
    for (int trial = 0; trial < 4; trial++) {
        small s;
        vbss_thread *thread;
        begin(&s);
        small_create(&s);
        s.rigid.mass = 1e-3;
        const uint32_t body =
            add_box(&s, VBSS_SCENE_RIGID_FREE, vec3_make(6e-3, 2e-3, 4e-3), THICKNESS, vec3_zero());
        const double y = 4e-3, aside = 2e-3 * trial, speed = 2.0 + trial;
        small_thread(&s, vec3_make(-6e-3 + aside, y, 0.0), vec3_make(5e-3 + aside, y, 2e-3), 20,
                     &thread);
        double velocities[21][3];
        for (int i = 0; i < 21; i++) {
            vec3_store(velocities[i], vec3_make(0.0, -speed, 0.1 * trial));
        }
        expect_ok(vbss_thread_set_state(thread, NULL, velocities[0], 21));
        const thread_object *t = ((vbss_slot *)thread)->object;
        double touched = 0.0;
        for (int step = 0; step < 40; step++) {
            small_steps(&s, 1, 0.25e-3);
            touched = fmax(touched, vec3_norm(force_on(&s, body)));
        }
        const double mass = mass_of(thread), before = mass * speed,
                     first = 0.5 * mass * (speed * speed + 0.01 * trial * trial);
        vec3 momentum = vec3_zero();
        double energy = 0.0;
        for (uint32_t i = 0; i < t->node_count; i++) {
            momentum = vec3_add_scaled(momentum, t->mass[i], t->now.v[i]);
            energy += 0.5 * t->mass[i] * vec3_norm_squared(t->now.v[i]);
        }
        const vbss_rigid *r = &vbss_scene_body(small_object(&s), body)->rigid.body;
        momentum = vec3_add_scaled(momentum, r->mass, r->now.v);
        const vec3 spin = quat_rotate_back(r->now.pose.orientation, r->now.w);
        energy += 0.5 * (r->mass * vec3_norm_squared(r->now.v) + r->inertia.x * spin.x * spin.x +
                         r->inertia.y * spin.y * spin.y + r->inertia.z * spin.z * spin.z);
        assert_true(touched > 0.0 && vec3_norm(r->now.w) > 0.1);
        expect_near(-before, momentum.y, 1e-3 * before);
        assert_true(energy < first);
        small_end(&s);
    }
}

/* Moments of a thin square plate: m a^2 / 12 and m a^2 / 6. */
static void mass_is_spread_over_the_triangles(void **state)
{
    (void)state;
    const double side = 0.1,
                 vertices[4][3] = {
                     {0.0, 0.0, 0.0}, {side, 0.0, 0.0}, {side, side, 0.0}, {0.0, side, 0.0}};
    const uint32_t triangles[2][3] = {{0, 1, 2}, {0, 2, 3}};
    const vbss_rigid_triangles plate = {vertices[0], triangles[0], 2};
    vbss_rigid_mass mass;
    assert_true(vbss_rigid_mass_of_triangles(&plate, 0.3, &mass));
    const double moment = 0.3 * side * side / 12.0;
    expect_near(0.3, mass.mass, 0.0);
    expect_near(0.0, vec3_distance(mass.frame.position, vec3_make(0.05, 0.05, 0.0)), 1e-15);
    expect_near(moment, mass.inertia.x, 1e-12 * moment);
    expect_near(moment, mass.inertia.y, 1e-12 * moment);
    expect_near(2.0 * moment, mass.inertia.z, 1e-12 * moment);
}

/* ---- cost */

static void far_mesh_that_moves_adds_no_pairs_and_one_box_test(void **state)
{
    (void)state;
    vbss_scene_statistics got[2];
    uint64_t tested[2];
    for (int with = 0; with < 2; with++) {
        small s;
        begin(&s);
        small_create(&s);
        small_thread(&s, vec3_make(0.0, 20e-3, -10e-3), vec3_make(0.0, 20e-3, 10e-3), 20, NULL);
        const uint32_t body = with == 0
                                  ? 0
                                  : add_box(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.1, 0.1, 0.1),
                                            THICKNESS, vec3_make(0.5, 0.0, 0.0));
        for (int i = 1; i <= 20; i++) {
            if (with == 1) {
                small_move(&s, body, vec3_make(0.5 + 1e-3 * i, 0.0, 0.0));
            }
            small_steps(&s, 1, 1e-3);
        }
        got[with] = small_statistics(&s);
        tested[with] = small_object(&s)->collision->boxes_tested;
        small_end(&s);
    }
    assert_int_equal(got[0].guard_pairs, got[1].guard_pairs);
    assert_true(tested[1] < tested[0] + UINT64_C(80) * COLLISION_BVH_WIDTH);
}

/* ---- what a host may ask */

static void queries_find_a_mesh_where_it_is(void **state)
{
    (void)state;
    small s;
    vbss_scene_body_info info;
    vbss_scene_ray_hit hit;
    begin(&s);
    small_create(&s);
    const uint32_t body =
        add_box(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(20e-3, 3e-3, 20e-3), THICKNESS, vec3_zero());
    const double quarter = 0.70710678118654757, turned_up[4] = {quarter, 0.0, 0.0, quarter};
    const double there[3] = {0.2, 0.0, 0.0}, from[3] = {0.2, 60e-3, 1e-3},
                 down[3] = {0.0, -0.1, 0.0};
    expect_ok(vbss_scene_cast_ray(s.scene, from, down, UINT32_MAX, &hit, sizeof hit));
    assert_int_equal(hit.is_hit, 0);
    for (int i = 0; i < 20; i++) { /* no faster than the limit of speed */
        expect_ok(vbss_scene_set_rigid_target(s.scene, body, there, turned_up));
        small_steps(&s, 1, 1e-3);
    }
    expect_ok(vbss_scene_cast_ray(s.scene, from, down, UINT32_MAX, &hit, sizeof hit));
    assert_true(hit.is_hit == 1 && hit.body == body);
    expect_near(20e-3 + 0.5 * THICKNESS, hit.point[1], 1e-9);
    expect_ok(vbss_scene_get_body(s.scene, body, &info, sizeof info));
    assert_int_equal(info.kind, VBSS_SCENE_BODY_RIGID);
    assert_int_equal(info.motion, VBSS_SCENE_RIGID_DRIVEN);
    small_end(&s);
}

/* A free mesh that the host puts elsewhere is there at once. */
static void free_mesh_can_be_put_elsewhere(void **state)
{
    (void)state;
    small s;
    vbss_scene_ray_hit hit;
    begin(&s);
    small_create(&s);
    const uint32_t body =
        add_box(&s, VBSS_SCENE_RIGID_FREE, vec3_make(5e-3, 5e-3, 5e-3), THICKNESS, vec3_zero());
    const double there[3] = {0.1, 0.02, 0.0}, from[3] = {0.1, 60e-3, 1e-3},
                 down[3] = {0.0, -0.1, 0.0};
    expect_ok(vbss_scene_set_rigid_pose(s.scene, body, there, NULL));
    expect_ok(vbss_scene_cast_ray(s.scene, from, down, UINT32_MAX, &hit, sizeof hit));
    assert_true(hit.is_hit == 1 && hit.body == body);
    expect_near(25e-3 + 0.5 * THICKNESS, hit.point[1], 1e-9);
    small_end(&s);
}

/* ---- state */

/* A driven and a coupled mesh stir a thread. */
static void stir(vbss_scene *scene, int step)
{
    double at[3], orientation[4];
    const vec3 turn = vec3_make(0.02 * step, 0.03 * step, 0.05 * step);
    const quat q = vbss_quat_from_rotation_vector(turn);
    pose_store(pose_make(vec3_make(0.0, 0.05e-3 * step, 0.0), q), at, orientation);
    expect_ok(vbss_scene_set_rigid_target(scene, 2, at, orientation));
    at[1] = 12e-3 - 0.04e-3 * step;
    expect_ok(vbss_scene_set_rigid_target(scene, 3, at, orientation));
}

static void begin_stirred(small *s, double width)
{
    begin(s);
    s->thread.gravity[1] = -GRAVITY;
    small_create(s);
    small_thread(s, vec3_make(-9e-3, 6e-3, -1e-3), vec3_make(8e-3, 5.5e-3, 1e-3), 20, NULL);
    assert_int_equal(
        add_box(s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(width, 2e-3, 5e-3), THICKNESS, vec3_zero()),
        2);
    assert_int_equal(add_box(s, VBSS_SCENE_RIGID_COUPLED, vec3_make(3e-3, 2e-3, 4e-3), THICKNESS,
                             vec3_make(0.0, 12e-3, 0.0)),
                     3);
}

static void loaded_scene_has_the_meshes_and_goes_on_to_the_same_bits(void **state)
{
    (void)state;
    small s, other;
    harness_memory memory;
    vbss_scene *loaded = NULL;
    double touched = 0.0;
    begin_stirred(&s, 7e-3);
    begin_stirred(&other, 7e-3);
    for (int i = 1; i <= 60; i++) {
        stir(s.scene, i);
        small_steps(&s, 1, 1e-3);
    }
    const small_state saved = small_save(&s);
    vbss_context *context = harness_context(&memory);
    expect_ok(vbss_scene_load(context, saved.bytes, saved.count, &loaded));
    expect_ok(vbss_scene_restore(other.scene, saved.bytes, saved.count));
    for (int i = 61; i <= 120; i++) {
        uint64_t hash = 0;
        expect_ok(vbss_scene_get_hash(loaded, &hash));
        assert_true(hash == small_hash(&s) && hash == small_hash(&other));
        stir(loaded, i);
        stir(s.scene, i);
        stir(other.scene, i);
        expect_ok(vbss_scene_step(loaded, 1e-3));
        small_steps(&s, 1, 1e-3);
        small_steps(&other, 1, 1e-3);
        touched = fmax(touched, vec3_norm(force_on(&s, 2)) + vec3_norm(force_on(&s, 3)));
    }
    assert_true(touched > 0.0);
    small_end(&other);
    begin_stirred(&other, 7.1e-3); /* another mesh is another scene */
    assert_int_not_equal(vbss_scene_restore(other.scene, saved.bytes, saved.count), VBSS_OK);
    small_end(&other);
    free(saved.bytes);
    expect_ok(vbss_scene_destroy(loaded));
    harness_context_end(context, &memory);
    small_end(&s);
}

static vbss_result try_box(small *s, const vbss_scene_static_mesh_config *config, uint32_t *body)
{
    return vbss_scene_add_rigid_mesh(s->scene, &s->rigid, config, body);
}

/* Adds a box to a scene of its own. */
static vbss_result add_to_new_scene(vbss_context *context, void *user)
{
    const box_mesh *b = user;
    vbss_scene *scene = NULL;
    uint32_t body = 0;
    const vbss_scene_config config = vbss_scene_config_default();
    const vbss_result created = vbss_scene_create(context, &config, &scene);
    if (created != VBSS_OK) {
        return created;
    }
    const vbss_result result = vbss_scene_add_rigid_mesh(scene, NULL, &b->config, &body);
    expect_ok(vbss_scene_destroy(scene));
    return result;
}

static void mesh_without_memory_leaves_no_block(void **state)
{
    (void)state;
    box_mesh b;
    box_mesh_make(&b, vec3_make(5e-3, 5e-3, 5e-3), THICKNESS);
    harness_fail_every_allocation(add_to_new_scene, &b);
}

static void expect_text(const small *s, const char *part)
{
    vbss_result result;
    const char *text = NULL;
    expect_ok(vbss_context_get_last_error(s->context, &result, &text));
    assert_non_null(strstr(text, part));
}

static void refused_meshes_change_nothing(void **state)
{
    (void)state;
    small s;
    box_mesh b;
    uint32_t body = 77, triangle[3] = {0, 1, 9};
    begin(&s);
    small_create(&s);
    box_mesh_make(&b, vec3_make(5e-3, 5e-3, 5e-3), THICKNESS);
    const vbss_scene_static_mesh_config good = b.config;
    vbss_scene_static_mesh_config bad = good;
    const uint64_t hash = small_hash(&s);
    vbss_scene_capsule capsule = {{0.0, 0.0, 0.0}, {0.0, 0.0, 1e-3}, 1e-3};
    s.rigid.capsules = &capsule;
    s.rigid.capsule_count = 1;
    assert_int_equal(try_box(&s, &good, &body), VBSS_ERROR_OUT_OF_RANGE);
    expect_text(&s, "capsules");
    s.rigid.capsules = NULL;
    s.rigid.capsule_count = 0;
    bad.one_sided = 1;
    assert_int_equal(try_box(&s, &bad, &body), VBSS_ERROR_OUT_OF_RANGE);
    expect_text(&s, "one_sided");
    bad = good;
    bad.triangles = triangle;
    bad.triangle_count = 1;
    assert_int_equal(try_box(&s, &bad, &body), VBSS_ERROR_OUT_OF_RANGE);
    expect_text(&s, "vertex 9");
    bad = good;
    bad.vertices = NULL;
    assert_int_equal(try_box(&s, &bad, &body), VBSS_ERROR_NULL_ARGUMENT);
    s.rigid.kind = 9;
    assert_int_equal(try_box(&s, &good, &body), VBSS_ERROR_OUT_OF_RANGE);
    s.rigid.kind = VBSS_SCENE_RIGID_DRIVEN;
    s.rigid.mass = (double)NAN;
    assert_int_equal(try_box(&s, &good, &body), VBSS_ERROR_NOT_FINITE);
    s.rigid.mass = 0.02;
    memset(b.vertices, 0, sizeof b.vertices);
    assert_int_equal(try_box(&s, &good, &body), VBSS_ERROR_OUT_OF_RANGE);
    expect_text(&s, "no area");
    box_mesh_make(&b, vec3_make(5e-3, 5e-3, 5e-3), THICKNESS);
    b.vertices[3][1] = (double)INFINITY;
    assert_int_equal(try_box(&s, &good, &body), VBSS_ERROR_NOT_FINITE);
    box_mesh_make(&b, vec3_make(5e-3, 5e-3, 5e-3), THICKNESS);
    assert_true(small_hash(&s) == hash && body == 77);
    expect_ok(try_box(&s, &good, &body));
    uint32_t pin;
    const uint32_t thread =
        small_thread(&s, vec3_make(0.0, 0.1, 0.0), vec3_make(0.0, 0.1, 0.01), 10, NULL);
    assert_int_equal(vbss_scene_pin_thread(s.scene, thread, 0, body, NULL, &pin),
                     VBSS_ERROR_INCOMPATIBLE);
    expect_text(&s, "rigid mesh");
    small_steps(&s, 1, 1e-3);
    expect_ok(vbss_scene_remove(s.scene, body));
    small_steps(&s, 1, 1e-3);
    small_end(&s);
}

int test_rigid_mesh(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(box_that_rises_bears_the_weight_of_a_thread),
        harness_test(mesh_pushes_a_thread_as_the_capsule_of_its_shape),
        harness_test(moving_mesh_gets_the_force_of_a_static_one_that_the_thread_moves_to),
        harness_test(tension_over_a_turning_mesh_follows_capstan_equation),
        harness_test(box_presses_a_drain),
        harness_test(collision_with_a_free_mesh_keeps_momentum_and_adds_no_energy),
        harness_test(mass_is_spread_over_the_triangles),
        harness_test(far_mesh_that_moves_adds_no_pairs_and_one_box_test),
        harness_test(queries_find_a_mesh_where_it_is),
        harness_test(free_mesh_can_be_put_elsewhere),
        harness_test(loaded_scene_has_the_meshes_and_goes_on_to_the_same_bits),
        harness_test(mesh_without_memory_leaves_no_block),
        harness_test(refused_meshes_change_nothing),
    };
    return cmocka_run_group_tests_name("scene.rigid_mesh", tests, NULL, NULL);
}
