#include "drain/mesh_rig.h"

#include "base/elementary.h"

/* ---- options */

drain_mesh_options mesh_rig_options(drain_mesh_kind kind)
{
    drain_mesh_options o;
    vbss_drain_mesh_defaults(&o);
    o.kind = kind;
    return o;
}

drain_mesh_options mesh_rig_tube(uint32_t axial_cells, uint32_t round_cells)
{
    drain_mesh_options o = mesh_rig_options(DRAIN_MESH_UNIFORM);
    o.axial_cells = axial_cells;
    o.round_cells = round_cells;
    o.slit_length = 0.0;
    return o;
}

/* The ends of the range, more often than by chance. */
static double draw(harness_source *source, double low, double high)
{
    uint32_t which = harness_draw_below(source, 8);
    double inside = harness_draw_real(source, low, high);
    return which == 0 ? low : which == 1 ? high : inside;
}

/* Tips and marks on lines. */
static void draw_uniform(harness_source *source, drain_mesh_options *o)
{
    o->axial_cells = 12 + 2 * harness_draw_below(source, 20);
    o->round_cells = 18 + 2 * harness_draw_below(source, 20);
    double cell = o->length / o->axial_cells;
    o->slit_length = 2.0 * floor(0.34 * o->length / cell) * cell;
    double columns = floor(0.24 * o->round_cells);
    o->mark_arc = columns * 2.0 * VBSS_PI / o->round_cells * o->radius;
    o->opening = draw(source, 0.0, fmin(fmin(0.4 * o->slit_length, o->radius), 2.0 * o->mark_arc));
}

drain_mesh_options mesh_rig_draw(harness_source *source, bool divided)
{
    drain_mesh_options o = mesh_rig_options(harness_draw_below(source, DRAIN_MESH_KINDS));
    o.divisions = divided ? 1 + harness_draw_below(source, 4) : 1;
    double r = o.radius = 1e-3 * draw(source, 0.5, 50.0);
    o.length = r * draw(source, 2.0, 7.0);
    if (o.kind == DRAIN_MESH_UNIFORM) {
        draw_uniform(source, &o);
        return o;
    }
    o.slit_length = draw(source, r, 0.7 * o.length);
    o.opening = draw(source, 0.0, fmin(0.4 * o.slit_length, r));
    o.mark_arc = draw(source, fmax(0.5 * o.opening, VBSS_PI / 9.0 * r), 0.5 * VBSS_PI * r);
    return o;
}

/* ---- making */

void mesh_rig_begin(mesh_rig *rig, const drain_mesh_options *options)
{
    vbss_array parts[DRAIN_MESH_ARRAYS];
    rig->context = harness_context(&rig->memory);
    expect_ok(vbss_drain_mesh_plan(rig->context, options, &rig->mesh));
    vbss_drain_mesh_arrays(&rig->mesh, parts);
    expect_ok(vbss_allocate_arrays(rig->context, parts, DRAIN_MESH_ARRAYS, "mesh"));
    uint64_t calls = rig->memory.calls;
    vbss_drain_mesh_fill(&rig->mesh);
    assert_int_equal(calls, rig->memory.calls);
}

void mesh_rig_end(mesh_rig *rig)
{
    vbss_array parts[DRAIN_MESH_ARRAYS];
    vbss_drain_mesh_arrays(&rig->mesh, parts);
    vbss_release_arrays(rig->context, parts, DRAIN_MESH_ARRAYS);
    harness_context_end(rig->context, &rig->memory);
}

/* ---- asking */

bool mesh_rig_is_tip(const drain_mesh *m, uint32_t node)
{
    return m->slit_count > 0 && (node == m->slit_nodes[DRAIN_LEFT][0] ||
                                 node == m->slit_nodes[DRAIN_LEFT][m->slit_count - 1]);
}

uint32_t mesh_rig_mirrored(const drain_mesh *m, uint32_t node)
{
    for (uint32_t k = 0; k < m->slit_count; k++) {
        for (int side = DRAIN_LEFT; side <= DRAIN_RIGHT; side++) {
            if (m->slit_nodes[side][k] == node) {
                return m->slit_nodes[1 - side][k];
            }
        }
    }
    uint32_t columns = m->grid.round_cells, row = node / columns, column = node % columns;
    return row * columns + (columns - column) % columns;
}

vec3 mesh_rig_normal(const drain_mesh *m, uint32_t triangle)
{
    const uint32_t *n = m->triangles[triangle];
    vec3 u = vec3_sub(m->rest[n[1]], m->rest[n[0]]), v = vec3_sub(m->rest[n[2]], m->rest[n[0]]);
    return vec3_cross(u, v);
}

double mesh_rig_area(const drain_mesh *m)
{
    double sum = 0.0;
    for (uint32_t t = 0; t < m->triangle_count; t++) {
        sum += 0.5 * vec3_norm(mesh_rig_normal(m, t));
    }
    return sum;
}

double mesh_rig_min_angle(const drain_mesh *m)
{
    double smallest = VBSS_PI;
    for (uint32_t t = 0; t < m->triangle_count; t++) {
        for (int k = 0; k < 3; k++) {
            const uint32_t *n = m->triangles[t];
            vec3 u = vec3_sub(m->rest[n[(k + 1) % 3]], m->rest[n[k]]);
            vec3 v = vec3_sub(m->rest[n[(k + 2) % 3]], m->rest[n[k]]);
            smallest = fmin(smallest, vbss_atan2(vec3_norm(vec3_cross(u, v)), vec3_dot(u, v)));
        }
    }
    return smallest / RIG_DEGREE;
}
