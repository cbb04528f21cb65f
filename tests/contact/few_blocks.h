/* A few blocks with masses, pushed, and rows between them: lib/contact on a system that fits on a page. */
#ifndef VBSS_TESTS_FEW_BLOCKS_H
#define VBSS_TESTS_FEW_BLOCKS_H

#include <math.h>
#include <string.h>

#include "contact/contact.h"
#include "harness/harness.h"

enum { FEW_BLOCKS = 8, FEW_ROWS = 64 };

typedef struct few_blocks {
    harness_memory memory;
    vbss_context *context;
    vbss_system *system;
    contact_set *set;
    contact_active_set_options search; /* as a scene has it, but strict: nothing is loose */
    uint32_t count;
    vbss_role roles[FEW_BLOCKS];
    mat3 stiffness[FEW_BLOCKS]; /* inertia included */
    vec3 force[FEW_BLOCKS];
} few_blocks;

static inline void few_begin(few_blocks *f, uint32_t count)
{
    memset(f, 0, sizeof *f);
    f->context = harness_context(&f->memory);
    f->count = count;
    expect_ok(vbss_system_create(f->context, FEW_BLOCKS, 1, FEW_BLOCKS, FEW_BLOCKS * FEW_BLOCKS,
                                 &f->system));
    expect_ok(vbss_contact_create(f->context, FEW_ROWS, &f->set));
    f->search = (contact_active_set_options){.system = f->system,
                                             .max_solves = 24,
                                             .relative_force_tolerance = 1e-9,
                                             .absolute_force_tolerance = 1e-12,
                                             .overlap_tolerance = 0.0,
                                             .max_stalled_solves = 1000};
    for (uint32_t i = 0; i < FEW_BLOCKS; i++) {
        f->roles[i] = VBSS_ROLE_SEPARATOR;
        f->stiffness[i] = mat3_identity();
    }
}

static inline void few_end(few_blocks *f)
{
    vbss_contact_destroy(f->context, f->set);
    vbss_system_destroy(f->context, f->system);
    harness_context_end(f->context, &f->memory);
}

/* A row of a block against the world. */
static inline contact_constraint *few_plane(few_blocks *f, uint32_t feature, uint32_t b,
                                            vec3 normal)
{
    const contact_key key = {3, 1, feature, 0, 0};
    contact_constraint *row = vbss_contact_add(f->set, &key);
    assert_non_null(row);
    row->normal = normal;
    row->stiffness = 2e5;
    row->augmentation = 3.0;
    row->thickness = 1e-3;
    row->jacobian_block_count = 1;
    row->jacobian[0] = (contact_jacobian_block){.block = b, .weight = 1.0};
    return row;
}

/* Bears 0.05 N along and a share of what it bears across: less against the normal than along it. */
#define FEW_SLEEVE_STIFFNESS 2e4
#define FEW_SLEEVE_MIN 0.05
#define FEW_SLEEVE_GRIP \
    {                   \
        0.2, 0.5        \
    }
static inline contact_constraint few_sleeve(vec3 normal)
{
    contact_constraint row = {.normal = normal,
                              .stiffness = FEW_SLEEVE_STIFFNESS,
                              .is_bilateral = true,
                              .is_sleeve = true,
                              .yield_force = {FEW_SLEEVE_MIN, FEW_SLEEVE_MIN},
                              .yield_friction = FEW_SLEEVE_GRIP,
                              .viscous_stiffness = 500.0};
    row.solution.status = CONTACT_STICK;
    return row;
}

static inline void few_register(few_blocks *f)
{
    uint32_t first;
    vbss_system_begin_pattern(f->system);
    expect_ok(vbss_system_add_chain(f->system, f->count, &first));
    for (uint32_t i = 0; i < f->count; i++) {
        vbss_system_set_role(f->system, i, f->roles[i]);
    }
    expect_ok(vbss_contact_register(f->set, f->system));
    expect_ok(vbss_system_analyse(f->system));
    vbss_contact_find_schur_indices(f->set, f->system);
}

static inline contact_outcome few_solve(few_blocks *f)
{
    few_register(f);
    vbss_system_clear(f->system);
    memset(f->system->off_diagonal, 0,
           (f->system->coupling_count + 1) * sizeof *f->system->off_diagonal);
    for (uint32_t i = 0; i < f->count; i++) {
        block_set(&f->system->diagonal[i], f->stiffness[i]);
        f->system->rhs[i] = f->force[i];
    }
    assert_true(vbss_system_condense(f->system));
    contact_outcome found = vbss_contact_solve_active_set(f->set, &f->search);
    if (found != CONTACT_SINGULAR) {
        vbss_system_back_substitute(f->system);
    }
    return found;
}

/* How far side a of a row has come against side b. */
static inline vec3 few_moved(const few_blocks *f, const contact_constraint *row)
{
    vec3 u = vec3_zero();
    for (uint32_t p = 0; p < row->jacobian_block_count; p++) {
        const contact_jacobian_block *t = &row->jacobian[p];
        vec3 d = f->system->solution[t->block];
        u = vec3_add_scaled(u, t->weight, t->is_rotation ? vec3_cross(d, t->arm) : d);
    }
    return u;
}

static inline vec3 across(vec3 v, vec3 normal)
{
    return vec3_add_scaled(v, -vec3_dot(v, normal), normal);
}

/* In the plane it may be softer. */
static inline double few_stiffness_along(const contact_constraint *row)
{
    return row->stiffness *
           (row->tangential_stiffness_ratio > 0.0 ? row->tangential_stiffness_ratio : 1.0);
}

/* The law itself, in closed form: elastic, then cut back to the cone. */
static inline vec3 few_law(const contact_constraint *row, vec3 u)
{
    vec3 n = row->normal;
    double pressure = -row->stiffness * (row->gap + vec3_dot(n, u));
    if (!row->is_bilateral && pressure <= 0.0) {
        return vec3_zero();
    }
    if (!row->is_bilateral && row->friction == 0.0) {
        return vec3_scale(n, pressure);
    }
    vec3 moved = across(vec3_add(row->relative_displacement, u), n);
    vec3 rubbing = vec3_add_scaled(row->previous_force, -few_stiffness_along(row), moved);
    double size = vec3_norm(rubbing), largest = row->friction * pressure;
    if (!row->is_bilateral && size > largest) {
        rubbing = vec3_scale(rubbing, largest / size);
    }
    return vec3_add_scaled(rubbing, pressure, n);
}

/* The force after a displacement u, by the tangent of the law. */
static inline vec3 few_force_by_tangent(const contact_linearisation *t, vec3 u)
{
    vec3 force = t->force;
    for (uint32_t d = 0; d < t->count; d++) {
        force = vec3_add_scaled(force, -t->stiffness[d] * vec3_dot(t->right[d], u), t->left[d]);
    }
    return force;
}

/* Largest distance of the tangent from central differences of the force along the three axes, N/m. */
static inline double few_slope_error(const contact_constraint *row, const contact_linearisation *t,
                                     double step)
{
    double largest = 0.0;
    for (int i = 0; i < 3; i++) {
        const vec3 u = vec3_make(i == 0 ? step : 0.0, i == 1 ? step : 0.0, i == 2 ? step : 0.0);
        const vec3 slope =
            vec3_sub(vbss_contact_force(row, u), vbss_contact_force(row, vec3_neg(u)));
        const vec3 by_tangent =
            vec3_sub(few_force_by_tangent(t, u), few_force_by_tangent(t, vec3_neg(u)));
        largest = fmax(largest, vec3_distance(slope, by_tangent) / (2.0 * step));
    }
    return largest;
}

#endif
