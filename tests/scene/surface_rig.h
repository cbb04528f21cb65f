/* A sheet of triangles about the origin, with its normal along y, as a host surface: what the tests of host
 * surfaces share. */
#ifndef VBSS_TESTS_SCENE_SURFACE_RIG_H
#define VBSS_TESTS_SCENE_SURFACE_RIG_H

#include <vblast_ss/scene_surface.h>

#include "scene/small.h"

#define SURFACE_THICKNESS 0.5e-3
enum {
    SURFACE_MAX_CELLS = 16,
    SURFACE_MAX_VERTICES = (SURFACE_MAX_CELLS + 1) * (SURFACE_MAX_CELLS + 1)
};

typedef struct surface_sheet {
    uint32_t body;
    double rest[SURFACE_MAX_VERTICES][3], x[SURFACE_MAX_VERTICES][3];
    uint32_t triangles[2 * SURFACE_MAX_CELLS * SURFACE_MAX_CELLS][3];
    vbss_scene_surface_config config;
} surface_sheet;

static inline void surface_make(surface_sheet *sheet, uint32_t cells, double side)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < (cells + 1) * (cells + 1); i++) {
        const uint32_t row = i / (cells + 1), column = i % (cells + 1);
        vec3_store(sheet->rest[i], vec3_make(side * ((double)row / cells - 0.5), 0.0,
                                             side * ((double)column / cells - 0.5)));
    }
    for (uint32_t i = 0; i < cells * cells; i++, count += 2) {
        const uint32_t a = i / cells * (cells + 1) + i % cells, b = a + cells + 1;
        const uint32_t cell[2][3] = {{a, a + 1, b + 1}, {a, b + 1, b}};
        memcpy(sheet->triangles[count], cell, sizeof cell);
    }
    memcpy(sheet->x, sheet->rest, sizeof sheet->x);
    sheet->config = vbss_scene_surface_config_default();
    sheet->config.vertex_count = (cells + 1) * (cells + 1);
    sheet->config.triangle_count = count;
    sheet->config.vertices = sheet->x[0];
    sheet->config.triangles = sheet->triangles[0];
    sheet->config.thickness = SURFACE_THICKNESS;
}

static inline void surface_add(small *s, surface_sheet *sheet)
{
    expect_ok(vbss_scene_add_surface(s->scene, &sheet->config, &sheet->body));
}

/* Gives the positions x to the scene. */
static inline void surface_move(small *s, surface_sheet *sheet)
{
    expect_ok(
        vbss_scene_move_surface(s->scene, sheet->body, sheet->x[0], sheet->config.vertex_count));
}

/* Moves all vertices by the same vector from where they were at rest. */
static inline void surface_shift(small *s, surface_sheet *sheet, vec3 by)
{
    for (uint32_t i = 0; i < sheet->config.vertex_count; i++) {
        vec3_store(sheet->x[i], vec3_add(vec3_load(sheet->rest[i]), by));
    }
    surface_move(s, sheet);
}

/* A wave along x, tilted about z: every vertex moves, and triangles turn. */
static inline void surface_wave(surface_sheet *sheet, double time)
{
    for (uint32_t i = 0; i < sheet->config.vertex_count; i++) {
        const double *r = sheet->rest[i];
        const double height = 1.5e-3 * sin(60.0 * time) * cos(150.0 * r[0] + 20.0 * time) +
                              0.05 * sin(25.0 * time) * r[0];
        vec3_store(sheet->x[i], vec3_make(r[0] + 1e-3 * sin(40.0 * time), r[1] + height, r[2]));
    }
}

static inline const vec3 *surface_view(const small *s, const surface_sheet *sheet,
                                       vbss_scene_surface_field field)
{
    vbss_view view;
    expect_ok(vbss_scene_get_surface_view(s->scene, sheet->body, field, &view, sizeof view));
    assert_int_equal(view.count, sheet->config.vertex_count);
    return view.data;
}

/* Sum of the forces on the vertices, and of their torques about the origin. */
typedef struct surface_wrench {
    vec3 force, torque;
} surface_wrench;

static inline surface_wrench surface_total(const small *s, const surface_sheet *sheet)
{
    surface_wrench sum = {vec3_zero(), vec3_zero()};
    const vec3 *f = surface_view(s, sheet, VBSS_SCENE_SURFACE_VIEW_FORCES);
    const vec3 *x = surface_view(s, sheet, VBSS_SCENE_SURFACE_VIEW_POSITIONS);
    for (uint32_t i = 0; i < sheet->config.vertex_count; i++) {
        sum.force = vec3_add(sum.force, f[i]);
        sum.torque = vec3_add(sum.torque, vec3_cross(x[i], f[i]));
    }
    return sum;
}

#endif
