#include "scene/rig.h"

#include <math.h>
#include <string.h>

vbss_scene_config scene_rig_config(void)
{
    vbss_scene_config config;
    expect_ok(vbss_scene_config_init(&config, sizeof config));
    config.mode = VBSS_SCENE_MODE_OFFLINE; /* physics, with all the work it takes */
    return config;
}

vbss_scene_config scene_rig_incline(double angle, double friction)
{
    vbss_scene_config config = scene_rig_config();
    config.floor = 1;
    config.floor_normal[0] = sin(angle);
    config.floor_normal[1] = cos(angle);
    config.floor_friction = friction;
    return config;
}

void scene_rig_begin(scene_rig *r, const vbss_scene_config *config,
                     const vbss_thread_config *thread)
{
    memset(r, 0, sizeof *r);
    if (thread != NULL) {
        rig_begin(&r->thread, thread);
    } else {
        r->thread.context = harness_context(&r->thread.memory);
    }
    expect_ok(vbss_scene_create(r->thread.context, config, &r->scene));
    if (thread != NULL) {
        expect_ok(vbss_scene_add_thread(r->scene, r->thread.thread, &r->body));
    }
}

void scene_rig_end(scene_rig *r)
{
    expect_ok(vbss_scene_destroy(r->scene));
    if (r->thread.thread != NULL) {
        rig_end(&r->thread);
    } else {
        harness_context_end(r->thread.context, &r->thread.memory);
    }
}

/* ---- rigid bodies */

vbss_scene_rigid_config scene_rig_capsule(vbss_scene_rigid_kind kind, vbss_scene_capsule *capsule,
                                          vec3 begin, vec3 end, double radius)
{
    vbss_scene_rigid_config config;
    expect_ok(vbss_scene_rigid_config_init(&config, sizeof config));
    vec3 middle = vec3_lerp(begin, end, 0.5);
    vec3_store(capsule->begin, vec3_sub(begin, middle));
    vec3_store(capsule->end, vec3_sub(end, middle));
    vec3_store(config.position, middle);
    capsule->radius = radius;
    config.kind = kind;
    config.capsule_count = 1;
    config.capsules = capsule;
    config.gravity[1] = -9.81;
    return config;
}

uint32_t scene_rig_add(scene_rig *r, const vbss_scene_rigid_config *config)
{
    uint32_t body = 0;
    expect_ok(vbss_scene_add_rigid(r->scene, config, &body));
    return body;
}

/* The balls' share of a capsule's mass. */
static double ball_share(double length, double radius)
{
    return 4.0 * radius / (4.0 * radius + 3.0 * length);
}

double scene_rig_inertia_along(double mass, double length, double radius)
{
    double ball = mass * ball_share(length, radius);
    return radius * radius * (0.5 * (mass - ball) + 0.4 * ball);
}

double scene_rig_inertia_across(double mass, double length, double radius)
{
    double ball = mass * ball_share(length, radius), r2 = radius * radius, l2 = length * length;
    return (mass - ball) * (l2 / 12.0 + 0.25 * r2) +
           ball * (0.4 * r2 + 0.25 * l2 + 0.375 * radius * length);
}

/* ---- time, reading */

void scene_rig_run(scene_rig *r, double h, uint32_t steps)
{
    for (uint32_t k = 0; k < steps; k++) {
        expect_ok(vbss_scene_step(r->scene, h));
    }
}

vbss_scene_rigid_state scene_rig_state(scene_rig *r, uint32_t body)
{
    vbss_scene_rigid_state state;
    expect_ok(vbss_scene_get_rigid(r->scene, body, &state, sizeof state));
    return state;
}

vec3 scene_rig_position(scene_rig *r, uint32_t body)
{
    vbss_scene_rigid_state state = scene_rig_state(r, body);
    return vec3_load(state.position);
}

vec3 scene_rig_velocity(scene_rig *r, uint32_t body)
{
    vbss_scene_rigid_state state = scene_rig_state(r, body);
    return vec3_load(state.velocity);
}

static vbss_view view_of(scene_rig *r, vbss_scene_field field)
{
    vbss_view view;
    expect_ok(vbss_scene_get_view(r->scene, field, &view, sizeof view));
    return view;
}

static const char *item_of(const vbss_view *view, uint64_t i)
{
    return (const char *)view->data + i * view->stride_bytes;
}

static vec3 vector_of(const vbss_view *view, uint64_t i)
{
    return vec3_load((const double *)(const void *)item_of(view, i));
}

vec3 scene_rig_floor_force(scene_rig *r)
{
    vbss_view features = view_of(r, VBSS_SCENE_VIEW_CONTACTS);
    vbss_view forces = view_of(r, VBSS_SCENE_VIEW_CONTACT_FORCES);
    vec3 sum = vec3_zero();
    for (uint64_t i = 0; i < forces.count; i++) {
        uint32_t kind = *(const uint32_t *)(const void *)item_of(&features, i);
        if (kind == VBSS_SCENE_CONTACT_NODE_FLOOR || kind == VBSS_SCENE_CONTACT_CAPSULE_FLOOR) {
            sum = vec3_add(sum, vector_of(&forces, i));
        }
    }
    return sum;
}

double scene_rig_contact_pressure(scene_rig *r)
{
    vbss_view forces = view_of(r, VBSS_SCENE_VIEW_CONTACT_FORCES);
    vbss_view normals = view_of(r, VBSS_SCENE_VIEW_CONTACT_NORMALS);
    double sum = 0.0;
    for (uint64_t i = 0; i < forces.count; i++) {
        sum += vec3_dot(vector_of(&forces, i), vector_of(&normals, i));
    }
    return sum;
}

vbss_scene_statistics scene_rig_statistics(scene_rig *r)
{
    vbss_scene_statistics statistics;
    expect_ok(vbss_scene_get_statistics(r->scene, &statistics, sizeof statistics));
    return statistics;
}

/* ---- pulling */

scene_pull scene_pull_begin(scene_rig *r)
{
    uint32_t nodes[2] = {0, r->thread.nodes - 1};
    scene_pull p;
    for (int k = 0; k < 2; k++) {
        p.ends[k] = rig_position(&r->thread, nodes[k]);
        p.pins[k] = rig_pin_here(&r->thread, nodes[k]);
    }
    p.along = vec3_unit_or(vec3_sub(p.ends[1], p.ends[0]), vec3_make(1.0, 0.0, 0.0));
    return p;
}

void scene_pull_run(scene_rig *r, scene_pull *p, double h, double speed, uint32_t steps)
{
    for (uint32_t i = 0; i < steps; i++) {
        p->ends[0] = vec3_add_scaled(p->ends[0], -speed * h, p->along);
        p->ends[1] = vec3_add_scaled(p->ends[1], speed * h, p->along);
        for (int k = 0; k < 2; k++) {
            rig_move(&r->thread, p->pins[k], p->ends[k]);
        }
        scene_rig_run(r, h, 1);
    }
}

double scene_pull_distance(const scene_pull *p)
{
    return vec3_dot(vec3_sub(p->ends[1], p->ends[0]), p->along);
}

double scene_pull_force(scene_rig *r, const scene_pull *p)
{
    vec3 difference = vec3_sub(rig_reaction_force(&r->thread, p->pins[1]),
                               rig_reaction_force(&r->thread, p->pins[0]));
    return 0.5 * vec3_dot(difference, p->along);
}

static double elastic_energy(scene_rig *r)
{
    vbss_thread_energies energies = rig_energies(&r->thread);
    return energies.bending + energies.stretching;
}

static vbss_view thread_view(scene_rig *r, vbss_thread_field field)
{
    vbss_view view;
    expect_ok(vbss_thread_get_view(r->thread.thread, field, &view, sizeof view));
    return view;
}

static double largest_curvature(scene_rig *r)
{
    vbss_view curvatures = thread_view(r, VBSS_THREAD_VIEW_CURVATURES);
    double largest = 0.0;
    for (uint64_t i = 0; i < curvatures.count; i++) {
        largest = fmax(largest, vec3_norm(vector_of(&curvatures, i)));
    }
    return largest;
}

static double rest_length(scene_rig *r)
{
    vbss_view lengths = thread_view(r, VBSS_THREAD_VIEW_REST_LENGTHS);
    double sum = 0.0;
    for (uint64_t i = 0; i < lengths.count; i++) {
        sum += *(const double *)(const void *)item_of(&lengths, i);
    }
    return sum;
}

scene_pull_means scene_pull_observe(scene_rig *r, scene_pull *p, double h, double speed,
                                    uint32_t steps)
{
    double before = scene_pull_distance(p), energy = elastic_energy(r), share = 1.0 / steps;
    scene_pull_means m = {0};
    for (uint32_t i = 0; i < steps; i++) {
        scene_pull_run(r, p, h, speed, 1);
        m.force += share * scene_pull_force(r, p);
        m.pressure += share * scene_rig_contact_pressure(r);
        m.curvature += share * largest_curvature(r);
    }
    double after = scene_pull_distance(p);
    m.energy_slope = (elastic_energy(r) - energy) / (after - before);
    m.shortening = rest_length(r) - 0.5 * (before + after);
    return m;
}

double scene_pull_tight(scene_rig *r, const knot_shape *shape, double force)
{
    vec3 x[KNOT_NODES];
    double rest[KNOT_NODES], pulled = 0.0;
    knot_line line;
    expect_ok(knot_make(shape, KNOT_NODES, x, rest, &line));
    vbss_scene_config scene = scene_rig_config();
    vbss_thread_config thread = rig_config(1.0, line.node_count - 1);
    thread.rest_lengths = rest;
    thread.positions = &x[0].x;
    thread.axial_stiffness = 4000.0;
    thread.gravity[1] = 0.0;
    scene_rig_begin(r, &scene, &thread);
    scene_pull p = scene_pull_begin(r);
    for (uint32_t k = 0; pulled < force && k < 4000; k++) {
        scene_pull_run(r, &p, 1e-3, pulled < 0.05 ? 25e-3 : 2.5e-3, 1);
        pulled = scene_pull_force(r, &p);
    }
    assert_true(pulled >= force);
    return rest_length(r) * (1.0 + pulled / thread.axial_stiffness) - scene_pull_distance(&p);
}
