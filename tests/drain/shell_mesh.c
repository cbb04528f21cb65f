/* Structured meshes: grids, planes of symmetry, and which blocks of the tangent there are. */
#include <stdlib.h>
#include <string.h>

#include "drain/shell_rig.h"

#include "harness/harness.h"

static void *take(size_t count, size_t size)
{
    size_t bytes = (count * size + 63) / 64 * 64 + 64;
    void *memory = aligned_alloc(64, bytes);
    assert_non_null(memory);
    return memset(memory, 0, bytes);
}

/* ---- triangles and what lies beyond their sides */

/* Runs along the side from `from` to `to`, and has this corner opposite. */
static uint32_t beyond(const shell_rig *r, uint32_t from, uint32_t to)
{
    for (uint32_t i = 0; i < r->triangle_count; i++) {
        const uint32_t *t = r->triangles[i];
        for (int k = 0; k < 3; k++) {
            if (t[(k + 1) % 3] == from && t[(k + 2) % 3] == to) {
                return t[k];
            }
        }
    }
    return SHELL_NONE;
}

static void add_cell(shell_rig *r, const uint32_t node[4], bool flipped)
{
    static const int corner[2][2][3] = {{{0, 1, 2}, {0, 2, 3}}, {{0, 1, 3}, {1, 2, 3}}};
    for (int half = 0; half < 2; half++) {
        for (int k = 0; k < 3; k++) {
            r->triangles[r->triangle_count][k] = node[corner[flipped][half][k]];
        }
        r->triangle_count++;
    }
}

void shell_rig_mesh(shell_rig *r, uint32_t columns, uint32_t rows, bool wraps, bool flipped,
                    shell_rig_shape shape, const void *user)
{
    memset(r, 0, sizeof *r);
    uint32_t lines = wraps ? columns : columns + 1,
             room = lines * (rows + 1) + 4 * (columns + rows);
    r->node_count = r->own_count = lines * (rows + 1);
    r->rest = take(room, sizeof *r->rest);
    r->x = take(room, sizeof *r->x);
    r->load = take(room, sizeof *r->load);
    r->forces = take(room, sizeof *r->forces);
    r->master = take(room, sizeof *r->master);
    r->sign = take(room, sizeof *r->sign);
    r->held = take(room, sizeof *r->held);
    r->diagonal = take(room, sizeof *r->diagonal);
    uint32_t triangles = 2 * columns * rows;
    r->triangles = take(triangles, sizeof *r->triangles);
    r->opposite = take(triangles, sizeof *r->opposite);
    r->widths = take(triangles, sizeof *r->widths);
    r->states = take(triangles, sizeof *r->states);
    for (uint32_t c = 0; c < lines; c++) {
        for (uint32_t k = 0; k <= rows; k++) {
            uint32_t i = c * (rows + 1) + k;
            r->rest[i] = r->x[i] = shape((double)c / columns, (double)k / rows, user);
            r->master[i] = i;
            r->sign[i] = vec3_make(1.0, 1.0, 1.0);
        }
    }
    for (uint32_t c = 0; c < columns; c++) {
        for (uint32_t k = 0; k < rows; k++) {
            uint32_t after = c + 1 < lines ? c + 1 : 0;
            uint32_t here = c * (rows + 1) + k, next = after * (rows + 1) + k;
            const uint32_t cell[4] = {here, next, next + 1, here + 1};
            add_cell(r, cell, flipped);
        }
    }
    for (uint32_t i = 0; i < r->triangle_count; i++) {
        const uint32_t *t = r->triangles[i];
        for (int s = 0; s < 3; s++) {
            r->opposite[i][s] = beyond(r, t[(s + 2) % 3], t[(s + 1) % 3]);
        }
    }
}

/* ---- symmetry */

static double *coordinate(vec3 *v, int axis)
{
    return axis == 0 ? &v->x : axis == 1 ? &v->y : &v->z;
}

static bool in_plane(shell_rig *r, uint32_t node, int axis, double value)
{
    return fabs(*coordinate(&r->rest[node], axis) - value) < 1e-9;
}

void shell_rig_mirror(shell_rig *r, int axis, double value)
{
    for (uint32_t i = 0; i < r->own_count; i++) {
        r->held[i][axis] = r->held[i][axis] || in_plane(r, i, axis, value);
    }
    for (uint32_t i = 0; i < r->triangle_count; i++) {
        const uint32_t *t = r->triangles[i];
        for (int s = 0; s < 3; s++) {
            bool on = in_plane(r, t[(s + 1) % 3], axis, value) &&
                      in_plane(r, t[(s + 2) % 3], axis, value);
            if (on && r->opposite[i][s] == SHELL_NONE) {
                uint32_t image = r->node_count++;
                r->master[image] = t[s];
                r->rest[image] = r->rest[t[s]];
                *coordinate(&r->rest[image], axis) *= -1.0;
                *coordinate(&r->rest[image], axis) += 2.0 * value;
                r->x[image] = r->rest[image];
                r->sign[image] = vec3_make(1.0, 1.0, 1.0);
                *coordinate(&r->sign[image], axis) = -1.0;
                r->opposite[i][s] = image;
            }
        }
    }
}

/* ---- the shell */

vbss_shell_input shell_rig_input(const shell_rig *r)
{
    vbss_shell_input in = {.node_count = r->node_count, .triangle_count = r->triangle_count};
    in.rest = r->rest;
    in.triangles = (const uint32_t(*)[3])r->triangles;
    in.opposite_node = (const uint32_t(*)[3])r->opposite;
    in.angular_widths = r->widths;
    in.young = in.density = 1.0;
    in.thickness = 0.1;
    in.moment_free_edges = true;
    return in;
}

/* The pair's place, found again by the lists of its lower node. */
static uint32_t pair_place(shell_rig *r, uint32_t *newest, uint32_t *older, uint32_t low,
                           uint32_t high)
{
    for (uint32_t p = newest[low]; p != 0; p = older[p]) {
        if (r->pairs[p][1] == high) {
            return p;
        }
    }
    uint32_t p = ++r->pair_count;
    r->pairs[p][0] = low;
    r->pairs[p][1] = high;
    older[p] = newest[low];
    newest[low] = p;
    return p;
}

void shell_rig_start(shell_rig *r, const vbss_shell_input *input)
{
    size_t room = (size_t)SHELL_PAIRS * r->triangle_count + 1;
    uint32_t *newest = take(r->node_count, sizeof *newest), *older = take(room, sizeof *older);
    r->groups = take(vbss_shell_group_count(r->triangle_count), sizeof *r->groups);
    r->pairs = take(room, sizeof *r->pairs);
    uint32_t(*numbers)[SHELL_PAIRS] = take(r->triangle_count, sizeof *numbers);
    uint32_t *targets = take(room, sizeof *targets);
    expect_ok(vbss_shell_init(NULL, input, r->groups, &r->shell));
    for (uint32_t i = 0; i < r->triangle_count; i++) {
        for (uint32_t k = 0; k < SHELL_PAIRS; k++) {
            uint32_t a, b;
            if (vbss_shell_pair_nodes(&r->shell, i, k, &a, &b)) {
                uint32_t place = pair_place(r, newest, older, a < b ? a : b, a < b ? b : a);
                /* every third target is the other way round, and so are those of its pairs */
                targets[place] = 2 * place + (place % 3 == 0);
                numbers[i][k] = 2 * place + ((a > b) != (place % 3 == 0));
            }
        }
    }
    vbss_shell_set_assembly_map(&r->shell, (const uint32_t(*)[SHELL_PAIRS])numbers, targets);
    free(numbers);
    free(targets);
    r->blocks = take(r->pair_count + 1, sizeof *r->blocks);
    free(newest);
    free(older);
}

void shell_rig_end(shell_rig *r)
{
    void *all[] = {r->rest,   r->x,      r->load,     r->forces,    r->master,
                   r->sign,   r->held,   r->diagonal, r->triangles, r->opposite,
                   r->widths, r->states, r->groups,   r->pairs,     r->blocks};
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        free(all[i]);
    }
}
