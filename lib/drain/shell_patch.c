/* Constants of patches, computed once from the rest positions. */
#include "base/check.h"
#include "base/elementary.h"
#include "base/error.h"
#include "drain/shell.h"

#include <string.h>

#include "drain/shell_strain.h"

/* Vector in the triangle's plane: the origin is corner 0, axis 1 points to corner 1. */
typedef struct plane_vector {
    double x, y;
} plane_vector;

static plane_vector plane_sub(plane_vector a, plane_vector b)
{
    plane_vector r = {a.x - b.x, a.y - b.y};
    return r;
}

static double plane_cross(plane_vector a, plane_vector b)
{
    return a.x * b.y - a.y * b.x;
}

/* A triangle whose neighbours are unfolded into its plane. */
typedef struct flat_patch {
    plane_vector position[SHELL_NODES];
    plane_vector gradient[3]; /* gradients of the barycentric coordinates */
    double area;
    bool is_free[3];
} flat_patch;

static bool flatten_triangle(const vec3 corner[3], flat_patch *p)
{
    vec3 along = vec3_sub(corner[1], corner[0]), arm = vec3_sub(corner[2], corner[0]);
    vec3 other = vec3_sub(corner[2], corner[1]);
    vec3 normal = vec3_cross(along, arm);
    double twice = vec3_norm(normal), length = vec3_norm(along);
    double sides = vec3_dot(along, along) + vec3_dot(arm, arm) + vec3_dot(other, other);
    if (!(twice > 1e-9 * sides)) {
        return false;
    }
    p->area = 0.5 * twice;
    p->position[0] = (plane_vector){0.0, 0.0};
    p->position[1] = (plane_vector){length, 0.0};
    p->position[2] = (plane_vector){vec3_dot(arm, along) / length, twice / length};
    for (int i = 0; i < 3; i++) {
        plane_vector side = plane_sub(p->position[(i + 2) % 3], p->position[(i + 1) % 3]);
        p->gradient[i] = (plane_vector){-side.y / twice, side.x / twice};
    }
    return true;
}

/* Turns a neighbour about the shared edge into the plane. */
static void flatten_neighbour(const vec3 corner[3], vec3 node, int side, flat_patch *p)
{
    int j = (side + 1) % 3, k = (side + 2) % 3;
    vec3 edge = vec3_sub(corner[k], corner[j]);
    double length = vec3_norm(edge);
    vec3 unit = vec3_scale(edge, 1.0 / length);
    vec3 arm = vec3_sub(node, corner[j]);
    double along = vec3_dot(arm, unit);
    double out = vec3_norm(vec3_add_scaled(arm, -along, unit));
    plane_vector flat = plane_sub(p->position[k], p->position[j]);
    double x = flat.x / length, y = flat.y / length;
    p->position[3 + side].x = p->position[j].x + along * x + out * y;
    p->position[3 + side].y = p->position[j].y + along * y - out * x;
}

/* Gradient at the middle of an edge, as coefficients of corners 0 1 2 and the opposite node: that
 * of the quadratic through six nodes (Flores, Onate 2005). All its derivatives there are +-1/2. So
 * it depends only on the differences across the edge, p = far - near, and along it, q = j - k, and
 * is the linear map that reproduces both. */
static void set_gradient(const flat_patch *f, int side, plane_vector gradient[4])
{
    if (f->is_free[side]) {
        memcpy(gradient, f->gradient, sizeof f->gradient);
        gradient[3] = (plane_vector){0.0, 0.0};
        return;
    }
    int j = (side + 1) % 3, k = (side + 2) % 3;
    plane_vector p = plane_sub(f->position[3 + side], f->position[side]),
                 q = plane_sub(f->position[j], f->position[k]);
    double scale = 1.0 / plane_cross(p, q);
    plane_vector of_p = {q.y * scale, -q.x * scale}, of_q = {-p.y * scale, p.x * scale};
    gradient[3] = of_p;
    gradient[side] = (plane_vector){-of_p.x, -of_p.y};
    gradient[j] = of_q;
    gradient[k] = (plane_vector){-of_q.x, -of_q.y};
}

/* ---- bending stiffness */

/* r = C v, with C stored as 11 22 33 12 13 23 */
static void plate_times(const double c[6], const double v[3], double r[3])
{
    r[0] = c[0] * v[0] + c[3] * v[1] + c[4] * v[2];
    r[1] = c[3] * v[0] + c[1] * v[1] + c[5] * v[2];
    r[2] = c[4] * v[0] + c[5] * v[1] + c[2] * v[2];
}

/* The curvature across a free edge follows from zero moment: C - C N N^T C / (N^T C N). */
static void release_edge(const flat_patch *f, int side, double c[6])
{
    plane_vector g = f->gradient[side];
    double scale = 1.0 / (g.x * g.x + g.y * g.y);
    const double across[3] = {g.x * g.x * scale, g.y * g.y * scale, 2.0 * g.x * g.y * scale};
    double moment[3];
    plate_times(c, across, moment);
    double own = across[0] * moment[0] + across[1] * moment[1] + across[2] * moment[2];
    c[0] -= moment[0] * moment[0] / own;
    c[1] -= moment[1] * moment[1] / own;
    c[2] -= moment[2] * moment[2] / own;
    c[3] -= moment[0] * moment[1] / own;
    c[4] -= moment[0] * moment[2] / own;
    c[5] -= moment[1] * moment[2] / own;
}

/* Second differences along an arc of three nodes `width` apart give 4 (sin width / width)^2 - 1 for
 * cos 2 theta instead of 3: w'' + w of an ovalling ring, docs/explanation/drain-shell.md. */
static double ovalling_ratio(double width)
{
    double ratio = width > 0.0 ? vbss_sine(width) / width : 1.0;
    return (4.0 * ratio * ratio - 1.0) / 3.0;
}

static double young_of(const vbss_shell_input *in, uint32_t triangle)
{
    return in->triangle_young != NULL ? in->triangle_young[triangle] : in->young;
}

static double thickness_of(const vbss_shell_input *in, uint32_t triangle)
{
    return in->triangle_thickness != NULL ? in->triangle_thickness[triangle] : in->thickness;
}

static void set_plate(const vbss_shell_input *in, uint32_t triangle, const flat_patch *f,
                      double plate[6])
{
    double t = thickness_of(in, triangle), nu = in->poisson;
    double seen = ovalling_ratio(in->angular_widths != NULL ? in->angular_widths[triangle] : 0.0);
    double d = young_of(in, triangle) * t * t * t / (12.0 * (1.0 - nu * nu)) / (seen * seen);
    plate[0] = plate[1] = d;
    plate[2] = 0.5 * (1.0 - nu) * d;
    plate[3] = nu * d;
    plate[4] = plate[5] = 0.0;
    /* with three free edges there are no heights, and nothing to release */
    bool has_bending = !f->is_free[0] || !f->is_free[1] || !f->is_free[2];
    for (int s = 0; s < 3 && in->moment_free_edges && has_bending; s++) {
        if (f->is_free[s]) {
            release_edge(f, s, plate);
        }
    }
}

/* ---- lanes */

static void set_lane(lanes *to, int lane, double value)
{
    double all[LANES];
    lanes_store(all, *to);
    all[lane] = value;
    *to = lanes_load(all);
}

static void set_curvature_operators(const vbss_shell_input *in, uint32_t triangle,
                                    const flat_patch *f, plane_vector across[3],
                                    vbss_shell_group *g, int lane)
{
    double plate[6], curve[3][3], moment[3];
    set_plate(in, triangle, f, plate);
    for (int k = 0; k < 6; k++) {
        set_lane(&g->plate_stiffness[k], lane, plate[k]);
    }
    for (int m = 0; m < 3; m++) {
        plane_vector l = f->gradient[m], far = across[m];
        curve[m][0] = -2.0 * l.x * far.x;
        curve[m][1] = -2.0 * l.y * far.y;
        curve[m][2] = -2.0 * (l.x * far.y + l.y * far.x);
        for (int k = 0; k < 3; k++) {
            set_lane(&g->curvature_per_height[m][k], lane, curve[m][k]);
        }
    }
    static const int pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
    for (int k = 0; k < 6; k++) {
        const double *a = curve[pairs[k][0]], *b = curve[pairs[k][1]];
        plate_times(plate, b, moment);
        double product = a[0] * moment[0] + a[1] * moment[1] + a[2] * moment[2];
        set_lane(&g->bending_stiffness[k], lane, f->area * product);
    }
}

static void set_patch(const vbss_shell_input *in, uint32_t triangle, const flat_patch *f,
                      vbss_shell_group *g, int lane)
{
    const double root_third = 1.0 / sqrt(3.0);
    plane_vector across[3];
    for (int s = 0; s < 3; s++) {
        plane_vector gradient[4];
        set_gradient(f, s, gradient);
        across[s] = gradient[3];
        for (int k = 0; k < 3; k++) {
            set_lane(&g->gradient[s][k][0], lane, root_third * gradient[1 + k].x);
            set_lane(&g->gradient[s][k][1], lane, root_third * gradient[1 + k].y);
        }
    }
    double nu = in->poisson;
    double thickness = thickness_of(in, triangle);
    double stiffness = f->area * young_of(in, triangle) * thickness / (1.0 - nu * nu);
    set_lane(&g->root_sum, lane, sqrt(0.5 * (1.0 + nu) * stiffness));
    set_lane(&g->root_shear, lane, sqrt(0.5 * (1.0 - nu) * stiffness));
    set_lane(&g->area, lane, f->area);
    set_lane(&g->mass, lane, in->density * thickness * f->area / 3.0);
    set_curvature_operators(in, triangle, f, across, g, lane);
}

/* ---- checks */

static vbss_result check_input(vbss_context *c, const vbss_shell_input *in)
{
    VBSS_TRY(vbss_check_range(c, in->young, 1e-3, 1e15, "young"));
    VBSS_TRY(vbss_check_range(c, in->poisson, 0.0, 0.5, "poisson"));
    VBSS_TRY(vbss_check_range(c, in->thickness, 1e-9, 1e3, "thickness"));
    VBSS_TRY(vbss_check_range(c, in->density, 0.0, 1e9, "density"));
    for (uint32_t i = 0; i < in->node_count; i++) {
        double at[3];
        vec3_store(at, in->rest[i]);
        VBSS_TRY(vbss_check_finite(c, at, 3, "rest"));
    }
    return VBSS_OK;
}

static vbss_result check_nodes(vbss_context *c, const vbss_shell_input *in, uint32_t triangle)
{
    const uint32_t *corner = in->triangles[triangle], *far = in->opposite_node[triangle];
    for (int i = 0; i < 3; i++) {
        bool exists = far[i] != SHELL_NONE;
        if (corner[i] >= in->node_count || (exists && far[i] >= in->node_count)) {
            return vbss_fail(c, VBSS_ERROR_OUT_OF_RANGE, "triangle %u: no such node", triangle);
        }
        /* If only three triangles meet at a node, two neighbours share their opposite node. */
        if (exists && far[i] == far[(i + 1) % 3]) {
            return vbss_fail(c, VBSS_ERROR_OUT_OF_RANGE,
                             "triangle %u has two neighbours with the same far node", triangle);
        }
        for (int k = 0; k < 3; k++) {
            if (far[i] == corner[k]) {
                return vbss_fail(c, VBSS_ERROR_OUT_OF_RANGE, "triangle %u is its own neighbour",
                                 triangle);
            }
        }
    }
    if (in->angular_widths != NULL) {
        /* beyond this w'' + w of an ovalling ring vanishes */
        VBSS_TRY(vbss_check_range(c, in->angular_widths[triangle], 0.0, 1.6, "width"));
    }
    return VBSS_OK;
}

static vbss_result add_patch(vbss_context *c, const vbss_shell_input *in, uint32_t triangle,
                             vbss_shell_group *g, int lane)
{
    VBSS_TRY(check_nodes(c, in, triangle));
    flat_patch flat = {.area = 0.0};
    vec3 corner[3];
    for (int i = 0; i < 3; i++) {
        corner[i] = in->rest[in->triangles[triangle][i]];
    }
    if (!flatten_triangle(corner, &flat)) {
        return vbss_fail(c, VBSS_ERROR_OUT_OF_RANGE, "triangle %u has no area", triangle);
    }
    g->free_edges[lane] = 0;
    for (int s = 0; s < 3; s++) {
        uint32_t far = in->opposite_node[triangle][s];
        flat.is_free[s] = far == SHELL_NONE;
        g->node[s][lane] = in->triangles[triangle][s];
        g->node[3 + s][lane] = flat.is_free[s] ? in->triangles[triangle][0] : far;
        g->free_edges[lane] |= flat.is_free[s] ? 1u << s : 0u;
        if (!flat.is_free[s]) {
            flatten_neighbour(corner, in->rest[far], s, &flat);
        }
    }
    set_patch(in, triangle, &flat, g, lane);
    return VBSS_OK;
}

/* Uses the operators themselves, so that any rest shape is free of stress to the bit. */
static void set_rest(const vec3 *rest, vbss_shell_group *g)
{
    shell_shape shape;
    shell_set_shape(g, rest, &shape);
    for (int k = 0; k < 3; k++) {
        g->metric[k] = shape.metric[k];
        g->height[k] = shape.height[k];
    }
}

static vbss_result check_rest(vbss_context *c, const vbss_shell_input *in, const vbss_shell *shell)
{
    for (uint32_t i = 0; i < shell->triangle_count; i++) {
        if (vbss_shell_is_inverted(shell, i, in->rest)) {
            return vbss_fail(c, VBSS_ERROR_OUT_OF_RANGE, "triangle %u is folded over at rest", i);
        }
    }
    return VBSS_OK;
}

uint32_t vbss_shell_group_count(uint32_t triangle_count)
{
    return triangle_count / LANES + (triangle_count % LANES != 0);
}

vbss_result vbss_shell_init(vbss_context *context, const vbss_shell_input *input,
                            vbss_shell_group *groups, vbss_shell *shell)
{
    VBSS_TRY(check_input(context, input));
    shell->triangle_count = input->triangle_count;
    shell->group_count = vbss_shell_group_count(input->triangle_count);
    shell->groups = groups;
    shell->wide = vbss_wide_is_available();
    memset(groups, 0, shell->group_count * sizeof *groups);
    for (uint32_t i = 0; i < input->triangle_count; i++) {
        VBSS_TRY(add_patch(context, input, i, &groups[i / LANES], (int)(i % LANES)));
    }
    for (uint32_t k = 0; k < shell->group_count; k++) {
        set_rest(input->rest, &groups[k]);
    }
    return check_rest(context, input, shell);
}

void vbss_shell_add_masses(const vbss_shell *shell, double *masses)
{
    for (uint32_t i = 0; i < shell->triangle_count; i++) {
        const vbss_shell_group *g = &shell->groups[i / LANES];
        int lane = (int)(i % LANES);
        for (int n = 0; n < 3; n++) {
            masses[g->node[n][lane]] += lanes_at(g->mass, lane);
        }
    }
}

/* ---- pairs of nodes */

static const uint8_t pair_nodes[SHELL_PAIRS][2] = {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5},
                                                   {1, 2}, {1, 3}, {1, 4}, {1, 5}, {2, 3},
                                                   {2, 4}, {2, 5}, {3, 4}, {3, 5}, {4, 5}};

bool vbss_shell_pair_nodes(const vbss_shell *shell, uint32_t triangle, uint32_t pair, uint32_t *row,
                           uint32_t *column)
{
    const vbss_shell_group *g = &shell->groups[triangle / LANES];
    uint32_t lane = triangle % LANES, i = pair_nodes[pair][0], j = pair_nodes[pair][1];
    *row = g->node[i][lane];
    *column = g->node[j][lane];
    uint32_t missing_nodes = g->free_edges[lane] << 3; /* bit per node of the patch */
    return ((missing_nodes >> i | missing_nodes >> j) & 1u) == 0;
}

/* The lanes that are set in a number of LANES bits. */
static const double lanes_of_bits[1 << LANES][LANES] = {
    {0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {1, 1, 0, 0}, {0, 0, 1, 0}, {1, 0, 1, 0},
    {0, 1, 1, 0}, {1, 1, 1, 0}, {0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}, {1, 1, 0, 1},
    {0, 0, 1, 1}, {1, 0, 1, 1}, {0, 1, 1, 1}, {1, 1, 1, 1}};

void vbss_shell_set_assembly_map(vbss_shell *shell, const uint32_t (*pair_codes)[SHELL_PAIRS],
                                 const uint32_t *block_codes)
{
    for (uint32_t first = 0; first < shell->triangle_count; first += LANES) {
        vbss_shell_group *g = &shell->groups[first / LANES];
        uint32_t left = shell->triangle_count - first, count = left < LANES ? left : LANES;
        for (uint32_t pair = 0; pair < SHELL_PAIRS; pair++) {
            uint32_t transposed = 0;
            for (uint32_t lane = 0; lane < count; lane++) {
                uint32_t pair_code = pair_codes[first + lane][pair];
                uint32_t block_code = block_codes[pair_code / 2] ^ (pair_code & 1u);
                g->block_index[pair][lane] = block_code / 2;
                transposed |= (block_code & 1u) << lane;
            }
            g->transposed[pair] = lanes_load(lanes_of_bits[transposed]);
        }
    }
}
