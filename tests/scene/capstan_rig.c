#include "scene/capstan_rig.h"

enum { MAX_NODES = 400 };

static const double bending_stiffness = 1e-8,
                    pull_length = 10e-3; /* N m^2; m, straight, at the start */

/* ---- making */

/* Touching with its smooth points, as long as it is. */
static void wind(const capstan *c, uint32_t segments, double slope, vec3 *x, double *rest)
{
    double middle = CAPSTAN_RADIUS + CAPSTAN_THREAD_RADIUS, turn = c->segment * c->cosine / middle;
    double outside = middle / (11.0 / 12.0 + cos(turn) / 12.0);
    for (uint32_t i = 0; i <= segments; i++) {
        double s = i * c->segment - CAPSTAN_LOAD_LENGTH, on = fmin(fmax(s, 0.0), c->contact_length);
        double angle = on * c->cosine / middle;
        vec3 tangent = vec3_make(sin(angle) * c->cosine, cos(angle) * c->cosine, slope * c->cosine);
        vec3 point = vec3_make(-outside * cos(angle), outside * sin(angle), slope * middle * angle);
        x[i] = vec3_add_scaled(point, s - on, tangent);
    }
    for (uint32_t i = 0; i < segments; i++) {
        double s = (i + 0.5) * c->segment - CAPSTAN_LOAD_LENGTH;
        rest[i] = vec3_distance(x[i], x[i + 1]);
        if (c->bending == VBSS_THREAD_BENDING_SPLINE && s > 0.0 && s < c->contact_length) {
            rest[i] *= 1.0 + turn * turn * c->cosine * c->cosine / 24.0; /* of the arc */
        }
    }
}

void capstan_begin(capstan *c)
{
    double whole = 2.0 * CAPSTAN_PI * c->turns, middle = CAPSTAN_RADIUS + CAPSTAN_THREAD_RADIUS;
    double slope = c->turns > 0.5 ? 1e-3 / (2.0 * CAPSTAN_PI * middle) : 0.0; /* 1 mm a turn */
    c->cosine = 1.0 / sqrt(1.0 + slope * slope);
    c->contact_length = whole * middle / c->cosine;
    c->angle = whole * c->cosine;
    c->loaded = vec3_make(0.0, -c->cosine, -slope * c->cosine);
    c->pulled = vec3_make(sin(whole) * c->cosine, cos(whole) * c->cosine, slope * c->cosine);
    double length = CAPSTAN_LOAD_LENGTH + c->contact_length + pull_length;
    uint32_t segments = (uint32_t)ceil(length / (c->fineness * CAPSTAN_RADIUS));
    c->segment = length / segments;
    vec3 x[MAX_NODES];
    double rest[MAX_NODES];
    assert_true(segments < MAX_NODES);
    wind(c, segments, slope, x, rest);

    vbss_scene_config scene = scene_rig_config();
    vbss_thread_config thread = rig_config(1.0, segments);
    thread.rest_lengths = rest;
    thread.positions = &x[0].x;
    thread.bending = c->bending;
    thread.axial_stiffness = c->axial_stiffness;
    thread.gravity[1] = 0.0;
    thread.drag = 100.0; /* of the straight part: 2e-6 N */
    scene.drain_capacity = 1;
    scene_rig_begin(&c->rig, &scene, &thread);
    c->add_cylinder(c);
    c->weight = rig_force(&c->rig.thread, 0, vec3_zero());
    c->end = rig_pin_here(&c->rig.thread, segments);
    c->at = x[segments];
    for (int i = 1; i <= 50; i++) {
        rig_move(&c->rig.thread, c->weight, vec3_scale(c->loaded, CAPSTAN_LOAD * i / 50.0));
        scene_rig_run(&c->rig, 1e-3, 1);
    }
}

/* ---- pulling */

static double ratio(capstan *c)
{
    double bent = c->cosine * c->cosine / (CAPSTAN_RADIUS + CAPSTAN_THREAD_RADIUS);
    double less = 0.5 * bending_stiffness * bent * bent;
    double pull = vec3_dot(rig_reaction_force(&c->rig.thread, c->end), c->pulled);
    return log((pull - less) / (CAPSTAN_LOAD - less));
}

capstan_ratios capstan_pull(capstan *c, double segments)
{
    const double h = 1e-3;
    uint32_t steps = (uint32_t)(segments * c->segment / (fabs(c->speed) * h) + 0.5);
    capstan_ratios r = {0.0, 1e3, -1e3};
    for (uint32_t i = 0; i < steps; i++) {
        if (c->turn_cylinder != NULL) {
            c->turn_cylinder(c, c->speed * h);
        } else {
            c->at = vec3_add_scaled(c->at, c->speed * h, c->pulled);
        }
        rig_move(&c->rig.thread, c->end, c->at);
        scene_rig_run(&c->rig, h, 1);
        double now = ratio(c);
        r.mean += now / steps;
        r.smallest = fmin(r.smallest, now);
        r.largest = fmax(r.largest, now);
    }
    return r;
}

static void add_capsule(capstan *c)
{
    vbss_scene_capsule capsule;
    vbss_scene_rigid_config body =
        scene_rig_capsule(VBSS_SCENE_RIGID_DRIVEN, &capsule, vec3_make(0.0, 0.0, -0.02),
                          vec3_make(0.0, 0.0, 0.02), CAPSTAN_RADIUS);
    body.friction = c->friction;
    scene_rig_add(&c->rig, &body);
}

capstan capstan_half_turn(double friction)
{
    capstan c = {.turns = 0.5,
                 .fineness = 0.25,
                 .friction = friction,
                 .axial_stiffness = 4000.0,
                 .speed = 0.01,
                 .bending = VBSS_THREAD_BENDING_SPLINE,
                 .add_cylinder = add_capsule};
    return c;
}

/* The elastic thread slides everywhere after one or two millimetres. */
double capstan_start_segments(const capstan *c)
{
    return ceil(2e-3 / c->segment);
}

double capstan_pulled_over(capstan *c)
{
    capstan_begin(c);
    (void)capstan_pull(c, capstan_start_segments(c));
    capstan_ratios r = capstan_pull(c, 4.0);
    scene_rig_end(&c->rig);
    return r.mean;
}
