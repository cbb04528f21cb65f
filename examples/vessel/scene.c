/* The bodies of the scene, and the hands that pull. */
#include "vessel.h"

#include <math.h>
#include <string.h>

#include "base/error.h"
#include "base/pi.h"
#include "fixtures/knots.h"

/* A soft vessel of 5 mm. Sizes and stiffness are chosen: they come from no measurement. */
static const double radius = 2.5e-3, length = 40e-3, wall = 0.4e-3, young = 0.5e6;
/* The surface bears the vessel near its ends. Between them it is a little lower, so that the loop fits below; beyond them, and
 * to the sides, it rises as the walls of a pelvis do. */
static const double pelvis_wall = 0.5e-3, extent[2] = {60e-3, 76e-3}, clearance = 0.15e-3,
                    hollow = 2e-3, hollow_width = 9e-3, side_rise = 3.0 /* 1/m */,
                    end_rise = 45.0 /* 1/m */;
static const double speed = 15e-3 /* m/s, of each hand */, arm = 400.0 /* N/m */, arm_damping = 0.5;

/* ---- bodies */

static double height_at(double x, double y, double axis)
{
    const double under = axis - radius - 0.5 * (wall + pelvis_wall) - clearance;
    const double side = x * x / (x * x + 16.0 * radius * radius);
    const double beyond = fmax(0.0, fabs(y) - 0.5 * length - 0.5e-3);
    const double share = y * y / (hollow_width * hollow_width);
    return under - hollow / (1.0 + share * share) + side_rise * side * x * x +
           end_rise * beyond * beyond;
}

static vbss_result add_pelvis(vessel_scene *s)
{
    const uint32_t row = PELVIS_CELLS + 1;
    for (uint32_t i = 0; i < PELVIS_VERTICES; i++) {
        double *v = s->vertices[i];
        const uint32_t column = i / row;
        v[0] = extent[0] * ((double)column / PELVIS_CELLS - 0.5);
        v[1] = extent[1] * ((double)(i % row) / PELVIS_CELLS - 0.5);
        v[2] = height_at(v[0], v[1], s->axis);
    }
    for (uint32_t i = 0; i < PELVIS_CELLS * PELVIS_CELLS; i++) {
        const uint32_t a = i / PELVIS_CELLS * row + i % PELVIS_CELLS, b = a + row;
        const uint32_t cell[2][3] = {{a, b, b + 1}, {a, b + 1, a + 1}};
        memcpy(s->triangles[2 * (size_t)i], cell, sizeof cell);
    }
    vbss_scene_static_mesh_config config = vbss_scene_static_mesh_config_default();
    config.vertex_count = PELVIS_VERTICES;
    config.triangle_count = PELVIS_TRIANGLES;
    config.vertices = s->vertices[0];
    config.triangles = s->triangles[0];
    config.thickness = pelvis_wall;
    return vbss_scene_add_static_mesh(s->scene, &config, &s->pelvis_body);
}

/* The ends are held by the tissue that the vessel comes out of. */
static vbss_result add_vessel(vessel_scene *s)
{
    static double positions[VESSEL_NODES][3];
    static uint32_t triangles[VESSEL_TRIANGLES][3], anchors[2 * VESSEL_AROUND];
    for (uint32_t i = 0; i < VESSEL_NODES; i++) {
        const double angle = 2.0 * VBSS_PI * (i % VESSEL_AROUND) / VESSEL_AROUND;
        const uint32_t ring = i / VESSEL_AROUND;
        positions[i][0] = radius * vbss_cos(angle);
        positions[i][1] = length * ((double)ring / VESSEL_CELLS - 0.5);
        positions[i][2] = radius * vbss_sin(angle);
    }
    for (uint32_t i = 0; i < VESSEL_AROUND * VESSEL_CELLS; i++) {
        const uint32_t ring = i / VESSEL_AROUND * VESSEL_AROUND, a = i % VESSEL_AROUND,
                       b = (a + 1) % VESSEL_AROUND, next = ring + VESSEL_AROUND;
        const uint32_t cell[2][3] = {{ring + a, next + a, next + b},
                                     {ring + a, next + b, ring + b}};
        memcpy(triangles[2 * (size_t)i], cell, sizeof cell);
    }
    for (uint32_t i = 0; i < VESSEL_AROUND; i++) {
        anchors[i] = i;
        anchors[VESSEL_AROUND + i] = VESSEL_NODES - VESSEL_AROUND + i;
    }
    vbss_drain_surface surface = vbss_drain_surface_default();
    surface.node_count = VESSEL_NODES;
    surface.triangle_count = VESSEL_TRIANGLES;
    surface.anchor_count = 2 * VESSEL_AROUND;
    surface.positions = positions[0];
    surface.triangles = triangles[0];
    surface.anchors = anchors;
    vbss_drain_config config = vbss_drain_config_default();
    config.surface = &surface;
    config.thickness = wall;
    config.young_modulus = young;
    config.density = 1050.0;
    config.friction = 0.15; /* wet */
    config.tear_stress = 1e9;
    config.position[2] = s->axis;
    VBSS_TRY(vbss_drain_create(s->context, &config, &s->vessel));
    return vbss_scene_add_drain(s->scene, s->vessel, &s->vessel_body);
}

/* The centre line of a double throw round the vessel, of which the thread's middle surface also keeps clear by half its wall. */
static vbss_result make_line(vec3 *x, double *rest, knot_line *line)
{
    knot_shape shape;
    knot_shape_init(&shape, KNOT_DOUBLE_OVERHAND);
    shape.cylinder = true;
    shape.cylinder_radius = radius + 0.5 * wall + 0.3e-3;
    shape.length = 130e-3;
    return knot_make(&shape, KNOT_NODES, x, rest, line);
}

static vbss_result add_thread(vessel_scene *s, const vec3 *x, const double *rest,
                              const knot_line *line)
{
    vbss_thread_config config = vbss_thread_config_default();
    vbss_thread_attachment hand;
    config.segment_count = line->node_count - 1;
    config.rest_lengths = rest;
    config.positions = &x[0].x;
    config.length = 0.0;
    for (uint32_t i = 0; i < config.segment_count; i++) {
        config.length += rest[i];
    }
    config.radius = VESSEL_THREAD_RADIUS;
    config.gravity[0] = config.gravity[1] = 0.0;
    config.gravity[2] = -9.81;
    VBSS_TRY(vbss_thread_create(s->context, &config, &s->thread));
    VBSS_TRY(vbss_scene_add_thread(s->scene, s->thread, &s->thread_body));
    s->node_count = line->node_count;
    VBSS_TRY(vbss_thread_attachment_init(&hand, sizeof hand));
    hand.kind = VBSS_THREAD_ATTACHMENT_SPRING;
    hand.stiffness = arm;
    hand.damping = arm_damping;
    for (int k = 0; k < 2; k++) {
        hand.node = k == 0 ? 0 : config.segment_count;
        memcpy(s->at[k], &x[hand.node].x, sizeof s->at[k]);
        memcpy(hand.position, s->at[k], sizeof hand.position);
        VBSS_TRY(vbss_thread_attach(s->thread, &hand, &s->hands[k]));
    }
    return VBSS_OK;
}

vbss_result vessel_create(vbss_context *context, vessel_scene *s)
{
    vec3 x[KNOT_NODES];
    double rest[KNOT_NODES];
    knot_line line;
    memset(s, 0, sizeof *s);
    s->context = context;
    VBSS_TRY(make_line(x, rest, &line));
    vbss_scene_config config = vbss_scene_config_default();
    config.mode = VBSS_SCENE_MODE_OFFLINE; /* each call finishes its step */
    config.contact_capacity = 4096;
    config.candidate_capacity = 65536;
    VBSS_TRY(vbss_scene_create(context, &config, &s->scene));
    s->axis = line.cylinder_begin.z;
    VBSS_TRY(add_vessel(s));
    VBSS_TRY(add_pelvis(s));
    VBSS_TRY(add_thread(s, x, rest, &line));
    s->initial_area = vessel_narrowest(s);
    return VBSS_OK;
}

/* ---- hands */

/* Pulls level and a little up, away from the knot. */
static vbss_result move_hand(vessel_scene *s, int k, double force)
{
    vbss_thread_reaction reaction;
    VBSS_TRY(vbss_thread_get_reaction(s->thread, s->hands[k], &reaction, sizeof reaction));
    const double *f = reaction.force;
    s->force[k] = sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
    const double lacking = (force - s->force[k]) / force; /* slower as it comes near */
    const double displacement = speed * VESSEL_STEP * fmax(-1.0, fmin(1.0, 5.0 * lacking));
    s->at[k][0] += k == 0 ? -displacement : displacement;
    return vbss_thread_set_attachment_target(s->thread, s->hands[k], s->at[k], NULL);
}

vbss_result vessel_pull(vessel_scene *s, double force)
{
    VBSS_TRY(move_hand(s, 0, force));
    VBSS_TRY(move_hand(s, 1, force));
    return vbss_scene_step(s->scene, VESSEL_STEP);
}

/* ---- measures */

double vessel_clearance(const vessel_scene *s)
{
    vbss_view view;
    double smallest = (double)INFINITY;
    if (vbss_thread_get_view(s->thread, VBSS_THREAD_VIEW_POSITIONS, &view, sizeof view) !=
        VBSS_OK) {
        return -(double)INFINITY;
    }
    const double(*x)[3] = (const double(*)[3])view.data;
    for (uint64_t i = 0; i < view.count; i++) {
        if (fabs(x[i][0]) <= 0.5 * extent[0]) {
            const double touching =
                height_at(x[i][0], x[i][1], s->axis) + 0.5 * pelvis_wall + VESSEL_THREAD_RADIUS;
            smallest = fmin(smallest, x[i][2] - touching);
        }
    }
    return smallest;
}

double vessel_narrowest(const vessel_scene *s)
{
    vbss_view view;
    double narrowest = (double)INFINITY;
    if (vbss_drain_get_view(s->vessel, VBSS_DRAIN_VIEW_POSITIONS, &view, sizeof view) != VBSS_OK) {
        return 0.0;
    }
    const double(*x)[3] = (const double(*)[3])view.data;
    for (uint32_t ring = 0; ring <= VESSEL_CELLS; ring++) {
        double twice = 0.0;
        for (uint32_t i = 0; i < VESSEL_AROUND; i++) {
            const double *a = x[ring * VESSEL_AROUND + i],
                         *b = x[ring * VESSEL_AROUND + (i + 1) % VESSEL_AROUND];
            twice += a[0] * b[2] - a[2] * b[0];
        }
        narrowest = fmin(narrowest, 0.5 * fabs(twice));
    }
    return narrowest;
}
