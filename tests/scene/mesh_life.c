#include "scene/mesh_life.h"

#include "base/rotation.h"

#include <vblast_ss/scene_surface.h>

enum {
    CELLS = 4,
    ROW = CELLS + 1,
    MAX_VERTICES = 2 * ROW * ROW,
    MAX_TRIANGLES = 128,
    SEGMENTS = 20
};

typedef struct life {
    small s;
    vbss_random *random;
    double vertices[MAX_VERTICES][3];
    uint32_t triangles[MAX_TRIANGLES][3];
    vbss_scene_static_mesh_config config;
    vbss_thread *thread;
    uint32_t tool;
    uint32_t mesh;
    mesh_life_kind kind;
    vec3 travel, turn, bend; /* velocity, m/s; angular velocity, rad/s; amplitude of a wave, m */
    double x[MAX_VERTICES][3];
    vec3 place; /* of a rigid mesh, m */
    quat orientation;
    vec3 start[MAX_VERTICES], end[MAX_VERTICES]; /* in the part of a step, m */
    mesh_life_result *result;
} life;

static double draw(life *l, double low, double high)
{
    return low + (high - low) * vbss_random_uniform(l->random);
}

static vec3 draw_vec3(life *l, double low, double high)
{
    const double x = draw(l, low, high), y = draw(l, low, high), z = draw(l, low, high);
    return vec3_make(x, y, z);
}

/* ---- meshes */

static void add_vertex(life *l, double x, double y, double z)
{
    vec3_store(l->vertices[l->config.vertex_count++], vec3_make(x, y, z));
}

static void add_triangle(life *l, uint32_t a, uint32_t b, uint32_t c)
{
    const uint32_t corners[3] = {a, b, c};
    memcpy(l->triangles[l->config.triangle_count++], corners, sizeof corners);
}

/* A thin sheet, folded along its middle by an angle between nothing and nearly all. */
static void make_folded_sheet(life *l)
{
    const double fold = vbss_random_below(l->random, 2) == 0 ? 0.0 : draw(l, 0.0, 1.5);
    const double side = 4e-3;
    for (int i = 0; i < ROW * ROW; i++) {
        const int column = i / ROW - CELLS / 2, row = i % ROW - CELLS / 2;
        const double along = side * column, across = side * row;
        add_vertex(l, along * cos(fold), -fabs(along) * sin(fold), across);
    }
    for (uint32_t i = 0; i < CELLS * CELLS; i++) {
        const uint32_t a = i / CELLS * ROW + i % CELLS, b = a + ROW;
        add_triangle(l, a, a + 1, b + 1);
        add_triangle(l, a, b + 1, b);
    }
}

/* A closed double cone over a polygon: from a thin disc with a sharp rim to a long needle. */
static void make_spindle(life *l)
{
    const uint32_t sides = 3 + vbss_random_below(l->random, 10);
    const double radius = draw(l, 1e-3, 8e-3), height = draw(l, 0.1e-3, 6e-3);
    add_vertex(l, 0.0, height, 0.0);
    add_vertex(l, 0.0, -height, 0.0);
    for (uint32_t i = 0; i < sides; i++) {
        const double angle = 6.283185307179586 * i / sides;
        add_vertex(l, radius * cos(angle), 0.0, -radius * sin(angle));
    }
    for (uint32_t i = 0; i < sides; i++) {
        const uint32_t a = 2 + i, b = 2 + (i + 1) % sides;
        add_triangle(l, 0, a, b);
        add_triangle(l, 1, b, a);
    }
}

static void add_rigid_mesh(life *l)
{
    vbss_scene_rigid_config motion = vbss_scene_rigid_config_default();
    motion.kind =
        vbss_random_below(l->random, 3) == 0 ? VBSS_SCENE_RIGID_COUPLED : VBSS_SCENE_RIGID_DRIVEN;
    motion.stiffness = draw(l, 200.0, 4000.0);
    l->config.one_sided = 0;
    l->place = vec3_zero();
    l->orientation = quat_identity();
    expect_ok(vbss_scene_add_rigid_mesh(l->s.scene, &motion, &l->config, &l->mesh));
}

static void add_mesh(life *l)
{
    const bool is_closed = vbss_random_below(l->random, 2) == 0;
    l->config = vbss_scene_static_mesh_config_default();
    if (is_closed) {
        make_spindle(l);
    } else {
        make_folded_sheet(l);
    }
    l->config.vertices = l->vertices[0];
    l->config.triangles = l->triangles[0];
    l->config.thickness = pow(10.0, draw(l, -5.0, -3.0));
    l->config.friction = draw(l, 0.0, 0.6);
    /* Bodies may go round the edge of a sheet and come from behind; so only closed meshes have one side. */
    l->config.one_sided = is_closed ? vbss_random_below(l->random, 2) : 0;
    if (l->kind == MESH_LIFE_STATIC) {
        expect_ok(vbss_scene_add_static_mesh(l->s.scene, &l->config, &l->mesh));
        return;
    }
    if (l->kind == MESH_LIFE_RIGID) {
        add_rigid_mesh(l);
        return;
    }
    vbss_scene_surface_config surface = vbss_scene_surface_config_default();
    surface.vertex_count = l->config.vertex_count;
    surface.triangle_count = l->config.triangle_count;
    surface.vertices = l->config.vertices;
    surface.triangles = l->config.triangles;
    surface.thickness = l->config.thickness;
    surface.friction = l->config.friction;
    expect_ok(vbss_scene_add_surface(l->s.scene, &surface, &l->mesh));
    memcpy(l->x, l->vertices, sizeof l->x);
}

/* The scene refuses a move that inverts a triangle; then the surface rests in this step. */
static void move_mesh(life *l, uint32_t step)
{
    double x[MAX_VERTICES][3], fastest = 0.0;
    const double h = 1e-3, phase = 40.0 * h * step;
    if (step % 15 == 0) { /* back and forth about the origin */
        const vec3 to = vec3_sub(draw_vec3(l, -5e-3, 5e-3), vec3_load(l->x[0]));
        l->travel = vec3_scale(vec3_unit_or(to, vec3_zero()), pow(10.0, draw(l, -1.0, 1.0)));
        l->turn = draw_vec3(l, -120.0, 120.0);
        l->bend = draw_vec3(l, -0.3e-3, 0.3e-3);
    }
    for (uint32_t i = 0; i < l->config.vertex_count; i++) {
        const vec3 at = vec3_load(l->x[i]), arm = vec3_sub(at, vec3_load(l->x[0]));
        const vec3 velocity = vec3_add(l->travel, vec3_cross(l->turn, arm));
        const vec3 wave = vec3_scale(l->bend, cos(phase + (double)i));
        const vec3 step_of = vec3_add_scaled(wave, h, velocity);
        vec3_store(x[i], vec3_add(at, step_of));
        fastest = fmax(fastest, vec3_norm(step_of) / h);
    }
    const vbss_result moved =
        vbss_scene_move_surface(l->s.scene, l->mesh, x[0], l->config.vertex_count);
    if (moved == VBSS_OK) {
        memcpy(l->x, x, sizeof l->x);
        l->result->moves++;
        l->result->fastest_vertex = fmax(l->result->fastest_vertex, fastest);
    } else {
        assert_int_equal(moved, VBSS_ERROR_OUT_OF_RANGE);
    }
}

/* Back and forth about the origin, as fast as 20 m/s. */
static void move_rigid_mesh(life *l, uint32_t step)
{
    const double h = 1e-3;
    double position[3], orientation[4];
    if (step % 15 == 0) {
        const vec3 to = vec3_sub(draw_vec3(l, -5e-3, 5e-3), l->place);
        l->travel = vec3_scale(vec3_unit_or(to, vec3_zero()), pow(10.0, draw(l, -1.0, 1.25)));
        l->turn = draw_vec3(l, -400.0, 400.0);
    }
    const pose now = pose_make(l->place, l->orientation);
    l->place = vec3_add_scaled(l->place, h, l->travel);
    l->orientation =
        quat_mul(vbss_quat_from_rotation_vector(vec3_scale(l->turn, h)), l->orientation);
    const pose then = pose_make(l->place, l->orientation);
    for (uint32_t i = 0; i < l->config.vertex_count; i++) {
        const vec3 x = vec3_load(l->vertices[i]);
        const double distance = vec3_distance(pose_apply(now, x), pose_apply(then, x));
        l->result->fastest_vertex = fmax(l->result->fastest_vertex, distance / h);
    }
    pose_store(then, position, orientation);
    expect_ok(vbss_scene_set_rigid_target(l->s.scene, l->mesh, position, orientation));
    l->result->moves++;
}

/* ---- what passes */

static const vec3 *place_vertices(scene_vertices from, uint32_t count, vec3 *to)
{
    for (uint32_t i = 0; i < count; i++) {
        to[i] = scene_vertex(from, i);
    }
    return to;
}

static void watch(void *watcher, const scene_object *s)
{
    life *l = watcher;
    passing_chain chains[4];
    size_t count = 0;
    passing_surface surface = {0};
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_THREAD) {
            const thread_object *t = b->thread.thread;
            chains[count++] = (passing_chain){t->now.x, t->trial, t->node_count, false};
        } else if (scene_is_mesh(b)) {
            const collision_shape *shape = s->collision->shapes[b->shape];
            surface = (passing_surface){
                .start = place_vertices(scene_mesh_vertices(s, b), shape->node_count, l->start),
                .end = place_vertices(scene_mesh_trial_vertices(s, b), shape->node_count, l->end),
                .nodes = shape->node_count,
                .triangles = shape->triangles[0],
                .sides = shape->edges[0],
                .triangle_count = shape->triangle_count,
                .side_count = shape->edge_count};
        } else if (b->kind == SCENE_BODY_RIGID) {
            const scene_capsule *c = &s->capsules[b->rigid.first_capsule];
            chains[count++] = (passing_chain){c->now, c->trial, 2, false};
        }
    }
    assert_true(count == 2 && surface.nodes > 0);
    passing_surface_report report;
    l->result->parts++;
    l->result->passed += passing_surfaces(&surface, 1, chains, count, &report);
    l->result->asked += report.asked;
}

/* ---- a life */

static void begin(life *l)
{
    small_begin(&l->s);
    l->s.config.floor = 0;
    l->s.config.contact_capacity = 4096;
    l->s.config.candidate_capacity = 65536;
    l->s.config.mode =
        vbss_random_below(l->random, 4) == 0 ? VBSS_SCENE_MODE_OFFLINE : VBSS_SCENE_MODE_REAL_TIME;
    l->s.thread.radius = draw(l, 0.05e-3, 0.2e-3);
    small_create(&l->s);
    add_mesh(l);
    const double y = draw(l, 12e-3, 15e-3), aside = draw(l, -3e-3, 3e-3);
    small_thread(&l->s, vec3_make(-9e-3, y, aside), vec3_make(9e-3, y, -aside), SEGMENTS,
                 &l->thread);
    l->s.rigid.stiffness = draw(l, 200.0, 2000.0);
    l->tool = small_stick(&l->s, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.0, 25e-3, 0.0),
                          draw_vec3(l, -4e-3, 4e-3), draw(l, 0.1e-3, 2e-3));
    scene_object *object = small_object(&l->s);
    object->on_substep = watch;
    object->on_substep_data = l;
}

/* Toward the mesh, at up to 20 m/s and turning. */
static void throw_thread(life *l)
{
    double velocities[SEGMENTS + 1][3];
    const vec3 middle = small_node(l->thread, SEGMENTS / 2);
    const vec3 at = vec3_add(vec3_neg(middle), draw_vec3(l, -4e-3, 4e-3));
    const vec3 velocity = vec3_scale(vec3_unit_or(at, vec3_zero()), draw(l, 0.1, 18.0));
    const vec3 turn = draw_vec3(l, -100.0, 100.0);
    for (uint32_t i = 0; i <= SEGMENTS; i++) {
        const vec3 arm = vec3_sub(small_node(l->thread, i), middle);
        vec3_store(velocities[i], vec3_add(velocity, vec3_cross(turn, arm)));
        l->result->fastest = fmax(l->result->fastest, vec3_norm(vec3_load(velocities[i])));
    }
    expect_ok(vbss_thread_set_state(l->thread, NULL, velocities[0], SEGMENTS + 1));
}

vbss_result mesh_life_run(vbss_random *random, uint32_t steps, mesh_life_kind kind,
                          mesh_life_result *result)
{
    static life l;
    memset(&l, 0, sizeof l);
    l.random = random;
    l.result = result;
    l.kind = kind;
    begin(&l);
    vec3 target = vec3_make(0.0, 25e-3, 0.0), place = target;
    double speed = 0.0;
    vbss_result done = VBSS_OK;
    for (uint32_t i = 0; i < steps && done == VBSS_OK && result->passed == 0; i++) {
        if (i % 20 == 0) {
            throw_thread(&l);
        }
        if (vec3_distance(place, target) <= speed * 1e-3) {
            target = draw_vec3(&l, -15e-3, 15e-3);
            speed = pow(10.0, draw(&l, -2.0, 1.3));
        }
        const vec3 to_target = vec3_sub(target, place);
        place = vec3_add_scaled(place, fmin(speed * 1e-3, vec3_norm(to_target)),
                                vec3_unit_or(to_target, vec3_zero()));
        small_move(&l.s, l.tool, place);
        if (kind == MESH_LIFE_SURFACE) {
            move_mesh(&l, i);
        } else if (kind == MESH_LIFE_RIGID) {
            move_rigid_mesh(&l, i);
        }
        done = vbss_scene_step(l.s.scene, 1e-3);
        result->steps++;
        result->touched += vec3_norm(vec3_load(small_rigid(&l.s, l.mesh).contact_force)) > 0.0;
    }
    result->clamped += small_statistics(&l.s).clamped;
    small_end(&l.s);
    return done;
}
