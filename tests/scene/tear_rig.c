#include "scene/tear_rig.h"

#include <vblast_ss/scene_surface.h>

#include "scene/line_crossing.h"

static pad sheet;

void tear_rig_begin(tear_rig *r, bool has_free_edge)
{
    memset(r, 0, sizeof *r);
    small_begin(&r->s);
    pad_make(&sheet, TEAR_CELLS, TEAR_CELLS, TEAR_SIDE, TEAR_SIDE);
    if (has_free_edge) {
        pad_clamp_columns(&sheet, 3);
    } else {
        pad_clamp_frame(&sheet);
    }
    r->s.config.mode = VBSS_SCENE_MODE_OFFLINE;
    r->s.config.floor = 0;
    r->s.drain.surface = &sheet.surface;
    r->s.drain.thickness = TEAR_THICK;
    r->s.drain.young_modulus = 20e6;
    r->s.drain.tear_stress = 1e9;
    r->s.drain.tear_energy = TEAR_ENERGY;
}

static void add_hands(tear_rig *r)
{
    for (uint32_t end = 0; end < 2; end++) {
        vbss_thread_attachment hand = vbss_thread_attachment_default();
        hand.node = end * TEAR_SEGMENTS;
        r->hand_positions[end] = small_node(r->thread, hand.node);
        vec3_store(hand.position, r->hand_positions[end]);
        expect_ok(vbss_thread_attach(r->thread, &hand, &r->hands[end]));
    }
}

static void add_host_sheet(tear_rig *r)
{
    vbss_scene_surface_config config = vbss_scene_surface_config_default();
    config.vertex_count = sheet.surface.node_count;
    config.triangle_count = sheet.surface.triangle_count;
    config.vertices = sheet.positions[0];
    config.triangles = sheet.triangles[0];
    config.thickness = TEAR_THICK;
    config.tear_energy = r->s.drain.tear_energy;
    expect_ok(vbss_scene_add_surface(r->s.scene, &config, &r->sheet));
}

/* The hole is in the middle of the thread, which is straight along `half`. */
static void add_thread(tear_rig *r, vec3 hole, vec3 half, uint32_t triangle,
                       const double weights[3])
{
    const double arc = vec3_norm(half);
    r->suture =
        small_thread(&r->s, vec3_add(hole, half), vec3_sub(hole, half), TEAR_SEGMENTS, &r->thread);
    expect_ok(vbss_scene_make_hole(r->s.scene, r->suture, arc, r->sheet, triangle, weights, NULL));
    add_hands(r);
}

void tear_rig_create(tear_rig *r, uint32_t column, uint32_t row)
{
    const double weights[3] = {0.3, 0.3, 0.4};
    const uint32_t triangle = 2 * (column * TEAR_CELLS + row);
    small_create(&r->s);
    if (r->is_of_host) {
        add_host_sheet(r);
    } else {
        r->sheet = small_drain(&r->s, &r->drain);
    }
    vec3 hole = vec3_zero();
    for (int k = 0; k < 3; k++) {
        hole = vec3_add_scaled(hole, weights[k],
                               vec3_load(sheet.positions[sheet.triangles[triangle][k]]));
    }
    add_thread(r, hole, vec3_make(0.0, TEAR_REACH, 0.0), triangle, weights);
}

static uint32_t triangle_of(const uint32_t *corners, uint32_t node)
{
    uint32_t i = 0;
    while (corners[i] != node) {
        i++;
    }
    return i / 3;
}

void tear_rig_create_drain(tear_rig *r, vec3 *direction)
{
    const double third = 1.0 / 3.0, weights[3] = {third, third, 1.0 - 2.0 * third};
    vbss_drain_places places;
    vbss_view x, triangles;
    vec3 corner[3], hole = vec3_zero();
    r->s.drain.surface = NULL;
    r->s.drain.young_modulus = 1.2e6;
    small_create(&r->s);
    r->sheet = small_drain(&r->s, &r->drain);
    expect_ok(vbss_drain_get_places(r->drain, &places, sizeof places));
    expect_ok(vbss_drain_get_view(r->drain, VBSS_DRAIN_VIEW_POSITIONS, &x, sizeof x));
    expect_ok(
        vbss_drain_get_view(r->drain, VBSS_DRAIN_VIEW_TRIANGLES, &triangles, sizeof triangles));
    const uint32_t t = triangle_of(triangles.data, places.marks[1]);
    for (int k = 0; k < 3; k++) {
        corner[k] = ((const vec3 *)x.data)[((const uint32_t *)triangles.data)[3 * t + (uint32_t)k]];
        hole = vec3_add_scaled(hole, weights[k], corner[k]);
    }
    const vec3 normal = vec3_unit_or(
        vec3_cross(vec3_sub(corner[1], corner[0]), vec3_sub(corner[2], corner[0])), vec3_zero());
    const vec3 inward = vec3_make(0.0, 0.0, -1.0);
    *direction =
        vec3_unit_or(vec3_add_scaled(inward, -vec3_dot(inward, normal), normal), vec3_zero());
    add_thread(r, hole, vec3_scale(normal, 4e-3), t, weights);
}

/* Force of a hand on the thread: the tension of its segment. */
static vec3 hand_force(const tear_rig *r, uint32_t end)
{
    const uint32_t node = end * TEAR_SEGMENTS, next = end == 0 ? 1 : TEAR_SEGMENTS - 1;
    const vec3 along = vec3_sub(small_node(r->thread, node), small_node(r->thread, next));
    return vec3_scale(vec3_unit_or(along, vec3_zero()),
                      small_tension(r->thread, end == 0 ? 0 : TEAR_SEGMENTS - 1));
}

void tear_rig_step(tear_rig *r, vec3 velocity)
{
    const vec3 moved = vec3_scale(velocity, TEAR_STEP);
    for (uint32_t end = 0; end < 2; end++) {
        double to[3];
        r->hand_positions[end] = vec3_add(r->hand_positions[end], moved);
        vec3_store(to, r->hand_positions[end]);
        expect_ok(vbss_thread_set_attachment_target(r->thread, r->hands[end], to, NULL));
    }
    small_steps(&r->s, 1, TEAR_STEP);
    for (uint32_t end = 0; end < 2; end++) {
        r->work += vec3_dot(hand_force(r, end), moved);
    }
}

bool tear_rig_hole(const tear_rig *r, vbss_scene_hole *hole)
{
    return vbss_scene_get_hole(r->s.scene, 0, hole, sizeof *hole) == VBSS_OK;
}

double tear_rig_force(const vbss_scene_hole *hole)
{
    return sqrt(hole->force[0] * hole->force[0] + hole->force[2] * hole->force[2]);
}

static void get_surface(const tear_rig *r, vbss_view *x, vbss_view *triangles)
{
    if (r->is_of_host) {
        expect_ok(vbss_scene_get_surface_view(r->s.scene, r->sheet,
                                              VBSS_SCENE_SURFACE_VIEW_POSITIONS, x, sizeof *x));
        triangles->data = sheet.triangles;
        triangles->count = sheet.surface.triangle_count;
        return;
    }
    expect_ok(vbss_drain_get_view(r->drain, VBSS_DRAIN_VIEW_POSITIONS, x, sizeof *x));
    expect_ok(
        vbss_drain_get_view(r->drain, VBSS_DRAIN_VIEW_TRIANGLES, triangles, sizeof *triangles));
}

uint32_t tear_rig_crossings(const tear_rig *r, vec3 point, double distance)
{
    vbss_view x, triangles;
    uint32_t count = 0;
    get_surface(r, &x, &triangles);
    for (uint32_t i = 0; i < TEAR_SEGMENTS; i++) {
        const vec3 from = small_node(r->thread, i), to = small_node(r->thread, i + 1);
        for (uint64_t t = 0; t < triangles.count; t++) {
            vec3 corner[3], at = vec3_zero();
            double weights[3];
            for (int k = 0; k < 3; k++) {
                corner[k] =
                    ((const vec3 *)x.data)[((const uint32_t *)triangles.data)[3 * t + (uint32_t)k]];
            }
            if (!line_crosses_triangle(from, to, corner, weights)) {
                continue;
            }
            for (int k = 0; k < 3; k++) {
                at = vec3_add_scaled(at, weights[k], corner[k]);
            }
            count += vec3_distance(at, point) > distance;
        }
    }
    return count;
}

void tear_rig_end(tear_rig *r)
{
    small_end(&r->s);
}
