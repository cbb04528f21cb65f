/* What slides along a curve: what rows add to the system is the slope of the forces on its blocks, found anew on the curve with
 * each of them shifted. */
#include "few_blocks.h"
#include "suture/suture.h"

/* Nodes of a thread, then the point of the wall. */
enum { NODES = 6, WALL = NODES, BLOCKS };

typedef struct sliding {
    vec3 x[NODES], wall;
    double rest[NODES - 1];
    thread_object thread;
    suture_hole hole;
    vbss_drain_config config;
    double from; /* arc length from which on it has slid */
} sliding;

static suture_curve_point place_of(const sliding *s)
{
    const suture_curve line = {.thread = &s->thread, .node_positions = s->x};
    return vbss_suture_nearest_point(&line, s->from, s->wall);
}

/* As a scene sets it: the nodes that it may slide on to are terms too. */
static void set_geometry(const sliding *s, contact_constraint *row)
{
    const suture_curve_point now = place_of(s);
    vbss_hole_set_constraint(&s->hole, &s->config, s->from, &now, s->wall, 1e-3, row);
    row->jacobian_block_count = 0;
    for (uint32_t i = 0; i < NODES; i++) {
        uint32_t k = i - now.first_node;
        bool own = i >= now.first_node && k < SUTURE_SPAN_NODES;
        row->jacobian[row->jacobian_block_count++] =
            (contact_jacobian_block){.block = i,
                                     .weight = own ? now.weights[k] : 0.0,
                                     .weight_derivative = own ? now.weight_derivatives[k] : 0.0};
    }
    row->jacobian[row->jacobian_block_count++] =
        (contact_jacobian_block){.block = WALL, .weight = -1.0};
}

/* ---- any row, with the state that it has there */

static void draw_thread(harness_source *source, sliding *s)
{
    *s = (sliding){.thread = {.node_count = NODES}};
    s->thread.rest = s->rest;
    for (int i = 1; i < NODES; i++) {
        s->rest[i - 1] = harness_draw_real(source, 0.7e-3, 1.3e-3);
        vec3 direction =
            vec3_add(vec3_make(1.0, 0.3 * i, 0.0), harness_draw_vec3(source, -0.3, 0.3));
        s->x[i] = vec3_add_scaled(s->x[i - 1], s->rest[i - 1], vec3_unit_or(direction, direction));
    }
}

static contact_constraint draw_row(harness_source *source, sliding *s)
{
    contact_constraint row = {.is_bilateral = true, .is_sleeve = true};
    s->config.hole_stiffness = 2e5;
    s->config.hole_damping = harness_draw_real(source, 0.01, 20.0);
    s->hole.friction_force = harness_draw_real(source, -1.0, 1.0);
    s->from = harness_draw_real(source, 1.5e-3, 3.5e-3);
    s->wall = vec3_lerp(s->x[0], s->x[NODES - 1], harness_draw_real(source, 0.1, 0.9));
    s->wall = vec3_add(place_of(s).position, harness_draw_vec3(source, -4e-6, 4e-6));
    s->from = place_of(s).arc + harness_draw_real(source, -8e-6, 8e-6);
    row.yield_force[0] = harness_draw_real(source, 0.1, 1.0);
    row.yield_force[1] = harness_draw_real(source, 0.1, 1.0);
    row.yield_friction[0] = harness_draw_real(source, 0.1, 1.0);
    row.yield_friction[1] = harness_draw_real(source, 0.1, 1.0);
    return row;
}

static void find_state(const sliding *s, contact_constraint *row)
{
    set_geometry(s, row);
    (void)vbss_contact_update_solution(row, vec3_zero(), &row->solution);
}

/* ---- what it adds */

static void begin_system(few_blocks *f, const contact_constraint *row)
{
    few_begin(f, BLOCKS);
    contact_constraint *added = few_plane(f, 0, 0, row->normal);
    const contact_key key = added->key;
    *added = *row;
    added->key = key;
    few_register(f);
    vbss_system_clear(f->system);
    for (uint32_t i = 0; i < BLOCKS; i++) {
        block_set(&f->system->diagonal[i], mat3_zero());
        f->system->rhs[i] = vec3_zero();
    }
    assert_true(vbss_system_condense(f->system));
    vbss_system_load_schur_complement(f->system);
    vbss_contact_assemble(f->set, f->system);
}

static vec3 added(const few_blocks *f, uint32_t p, uint32_t q, vec3 displacement)
{
    uint32_t place = vbss_system_schur_index(f->system, p, q);
    assert_true(place != VBSS_NO_INDEX);
    return mat3_mul_vec3(block_mat3(&f->system->separator_blocks[place]), displacement);
}

/* ---- what forces do */

typedef struct shifted {
    vec3 force[BLOCKS];
    double arc;
    contact_status state;
} shifted;

/* With a block moved on. */
static shifted shift(const sliding *s, const contact_constraint *like, uint32_t q,
                     vec3 displacement)
{
    sliding there = *s;
    contact_constraint row = *like;
    vec3 *moved = q == WALL ? &there.wall : &there.x[q];
    *moved = vec3_add(*moved, displacement);
    there.thread.rest = there.rest;
    find_state(&there, &row);
    const vec3 f = vbss_contact_force(&row, vec3_zero());
    shifted found = {.arc = place_of(&there).arc, .state = row.solution.status};
    for (uint32_t p = 0; p < BLOCKS; p++) {
        found.force[p] = vec3_scale(f, row.jacobian[p].weight);
    }
    return found;
}

/* By how much arc length at rest grows with the curve's own at the place: more than 1 where it cuts corners. */
static double rate_at(const sliding *s)
{
    const double step = 1e-8;
    sliding on = *s, back = *s;
    const suture_curve_point here = place_of(s);
    on.thread.rest = on.rest;
    back.thread.rest = back.rest;
    on.wall = vec3_add_scaled(here.position, -step, here.tangent);
    back.wall = vec3_add_scaled(here.position, step, here.tangent);
    return 0.5 * (place_of(&on).arc - place_of(&back).arc) / step;
}

/* It can be: the curve's direction is a mean of its segments', none longer than what that has along the tangent, over this cosine. */
static double max_rate(const sliding *s)
{
    const suture_curve_point here = place_of(s);
    double smallest = 1.0;
    for (uint32_t i = here.first_node; i < here.first_node + 3 && i + 1 < NODES; i++) {
        vec3 back = vec3_unit_or(vec3_sub(s->x[i], s->x[i + 1]), vec3_zero());
        smallest = fmin(smallest, vec3_dot(back, here.tangent));
    }
    return 1.0 / smallest;
}

/* What the equations leave out, so that a row need not know more of its curve. They say that
 *   - the place slides on by what its two sides move along the normal: really by `slid`, as nodes that turn the tangent shift
 *     what is square to it, and a bend runs ahead of what is inside it: by shares of the order of |aside| over segment or radius;
 *   - arc length at rest grows as the place slides: really `rate` times as much, in a bend percents more, which the spring along
 *     the normal feels.
 * Exact where the hole is on the curve, and the curve is as long there as the thread at rest; but for this:
 *   - what bears along the normal turns where a node turns that (without friction nothing does). */
static vec3 left_out(const contact_constraint *row, uint32_t p, double moved, double slid,
                     double rate)
{
    const contact_jacobian_block *of = &row->jacobian[p];
    const vec3 n = row->normal, f = vbss_contact_force(row, vec3_zero());
    const double k = row->stiffness, b = row->viscous_stiffness, along = vec3_dot(f, n);
    const double spring = row->solution.status == CONTACT_SLIP ? k * b / (k + b) : k;
    vec3 more = vec3_scale(f, -of->weight_derivative);
    more = vec3_add_scaled(more, -of->weight * along, row->curvature);
    more = vec3_add_scaled(more, of->weight * (1.0 - spring / k) * vec3_dot(f, row->curvature), n);
    return vec3_add_scaled(vec3_scale(more, slid - moved),
                           of->weight * spring * (rate - 1.0) * slid, n);
}

/* The forces on all blocks when a single one moves: a node turns the tangent too, each in its own way. */
static bool check_column(const sliding *s, const few_blocks *f, const contact_constraint *row,
                         uint32_t q, vec3 direction)
{
    const double step = 2e-10, rate = rate_at(s);
    const shifted on = shift(s, row, q, vec3_scale(direction, step));
    const shifted back = shift(s, row, q, vec3_scale(direction, -step));
    const contact_jacobian_block *term = &row->jacobian[q];
    if (on.state != row->solution.status || back.state != row->solution.status) {
        return false; /* between two states there is no slope */
    }
    const vec3 targets = vec3_scale(
        across(direction, row->normal),
        term->weight_derivative * vec3_dot(vbss_contact_force(row, vec3_zero()), row->normal));
    const double slid = 0.5 * (on.arc - back.arc) / step / rate;
    const double moved = term->weight * vec3_dot(row->normal, direction);
    const double aside = vec3_norm(row->solution.tangential_force) / row->stiffness;
    const double order =
        fabs(term->weight_derivative) + vec3_norm(row->curvature) * fabs(term->weight);
    assert_true(rate > 1.0 - 1e-7 && rate < max_rate(s) + 1e-7);
    assert_true(fabs(slid - moved) <= 1.1 * aside * order + 1e-6);
    for (uint32_t p = 0; p < BLOCKS; p++) {
        vec3 slope = vec3_scale(vec3_sub(back.force[p], on.force[p]), 0.5 / step);
        vec3 own = vec3_add(added(f, p, q, direction), left_out(row, p, moved, slid, rate));
        own = vec3_add_scaled(own, row->jacobian[p].weight, targets);
        expect_near(0.0, vec3_distance(slope, own), 0.01);
    }
    return true;
}

static const vec3 axes[3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};

/* Whether it has been checked: not where nothing across has a direction. */
static bool check_row(sliding *s, contact_constraint *row)
{
    few_blocks f;
    bool smooth = true;
    find_state(s, row);
    if (vec3_norm(row->solution.tangential_force) < 0.1) {
        return false;
    }
    begin_system(&f, row);
    const shifted now = shift(s, row, WALL, vec3_zero());
    for (uint32_t p = 0; p < BLOCKS; p++) {
        vec3 rhs = f.system->separator_rhs[vbss_system_schur_rhs_index(f.system, p)];
        expect_near(0.0, vec3_distance(now.force[p], rhs), 1e-12);
    }
    for (uint32_t q = 0; q < BLOCKS; q++) {
        for (int i = 0; i < 3; i++) {
            smooth = check_column(s, &f, row, q, axes[i]) && smooth;
        }
    }
    few_end(&f);
    return smooth;
}

static void any_row_that_slides_has_its_slope(harness_source *source, void *user)
{
    int *seen = user;
    sliding s;
    draw_thread(source, &s);
    contact_constraint row = draw_row(source, &s);
    bool is_smooth = check_row(&s, &row);
    seen[row.solution.status == CONTACT_SLIP] += is_smooth;
}

static void sliding_tangent_is_derivative_of_force(void **state)
{
    (void)state;
    int seen[2] = {0};
    harness_property("slope", 300, any_row_that_slides_has_its_slope, seen);
    assert_true(seen[0] > 30 && seen[1] > 30);
}

/* ---- without friction: forces have an energy, and its second derivative is symmetric */

static void any_row_without_friction_is_symmetric(harness_source *source, void *user)
{
    int *seen = user;
    sliding s;
    few_blocks f;
    draw_thread(source, &s);
    contact_constraint row = draw_row(source, &s);
    s.config.hole_damping = s.hole.friction_force = 0.0;
    row.yield_force[0] = row.yield_force[1] = row.yield_friction[0] = row.yield_friction[1] = 0.0;
    *seen += check_row(&s, &row);
    expect_near(0.0, row.solution.normal_force, 0.0);
    begin_system(&f, &row);
    for (uint32_t p = 0; p < BLOCKS; p++) {
        for (uint32_t q = 0; q < p; q++) {
            for (int i = 0; i < 9; i++) {
                const vec3 left = axes[i / 3], right = axes[i % 3];
                double one = vec3_dot(left, added(&f, p, q, right));
                double other = vec3_dot(right, added(&f, q, p, left));
                expect_near(one, other, 1e-9);
            }
        }
    }
    few_end(&f);
}

static void tangent_is_symmetric_without_friction(void **state)
{
    (void)state;
    int seen = 0;
    harness_property("symmetric", 100, any_row_without_friction_is_symmetric, &seen);
    assert_true(seen > 50);
}

int test_sliding_tangent(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(sliding_tangent_is_derivative_of_force),
        harness_test(tangent_is_symmetric_without_friction),
    };
    return cmocka_run_group_tests_name("contact.sliding_tangent", tests, NULL, NULL);
}
