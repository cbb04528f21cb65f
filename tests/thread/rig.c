#include "thread/rig.h"

#include <stdlib.h>
#include <string.h>

vbss_thread_config rig_config(double length, uint32_t segments)
{
    vbss_thread_config config;
    expect_ok(vbss_thread_config_init(&config, sizeof config));
    config.length = length;
    config.segment_count = segments;
    return config;
}

void rig_begin(rig *r, const vbss_thread_config *config)
{
    memset(r, 0, sizeof *r);
    r->context = harness_context(&r->memory);
    r->nodes = config->segment_count + 1;
    expect_ok(vbss_thread_create(r->context, config, &r->thread));
}

void rig_end(rig *r)
{
    expect_ok(vbss_thread_destroy(r->thread));
    harness_context_end(r->context, &r->memory);
}

/* ---- attachments */

static vbss_thread_attachment at_node(vbss_thread_attachment_kind kind, uint32_t node)
{
    vbss_thread_attachment a;
    expect_ok(vbss_thread_attachment_init(&a, sizeof a));
    a.kind = kind;
    a.node = node;
    return a;
}

static uint32_t attach(rig *r, const vbss_thread_attachment *a)
{
    uint32_t id = 0;
    expect_ok(vbss_thread_attach(r->thread, a, &id));
    return id;
}

uint32_t rig_pin(rig *r, uint32_t node, vec3 position)
{
    vbss_thread_attachment a = at_node(VBSS_THREAD_ATTACHMENT_PIN, node);
    vec3_store(a.position, position);
    return attach(r, &a);
}

uint32_t rig_clamp(rig *r, uint32_t node, vec3 position, vec3 direction)
{
    vbss_thread_attachment a = at_node(VBSS_THREAD_ATTACHMENT_CLAMP, node);
    vec3_store(a.position, position);
    vec3_store(a.direction, direction);
    return attach(r, &a);
}

uint32_t rig_force(rig *r, uint32_t node, vec3 force)
{
    vbss_thread_attachment a = at_node(VBSS_THREAD_ATTACHMENT_FORCE, node);
    vec3_store(a.force, force);
    return attach(r, &a);
}

uint32_t rig_spring(rig *r, uint32_t node, vec3 position, double stiffness, double damping)
{
    vbss_thread_attachment a = at_node(VBSS_THREAD_ATTACHMENT_SPRING, node);
    vec3_store(a.position, position);
    a.stiffness = stiffness;
    a.damping = damping;
    return attach(r, &a);
}

uint32_t rig_mass(rig *r, uint32_t node, double mass)
{
    vbss_thread_attachment a = at_node(VBSS_THREAD_ATTACHMENT_MASS, node);
    a.mass = mass;
    return attach(r, &a);
}

uint32_t rig_clamp_here(rig *r, uint32_t node, vec3 direction)
{
    return rig_clamp(r, node, rig_position(r, node), direction);
}

uint32_t rig_pin_here(rig *r, uint32_t node)
{
    return rig_pin(r, node, rig_position(r, node));
}

void rig_move(rig *r, uint32_t id, vec3 target)
{
    double to[3];
    vec3_store(to, target);
    expect_ok(vbss_thread_set_attachment_target(r->thread, id, to, NULL));
}

/* ---- time */

void rig_run(rig *r, double h, uint32_t steps)
{
    for (uint32_t k = 0; k < steps; k++) {
        expect_ok(vbss_thread_step(r->thread, h));
    }
}

uint32_t rig_relax(rig *r, double h, double speed, uint32_t limit)
{
    /* Still at a turning point is not still: twice in a row. */
    uint32_t still = 0, steps = 0;
    while (still < 2 && steps < limit) {
        rig_run(r, h, 1);
        steps++;
        still = rig_fastest(r) <= speed ? still + 1 : 0;
    }
    if (still < 2) {
        fail_msg("not still after %u steps: %g m/s", steps, rig_fastest(r));
    }
    return steps;
}

/* ---- reading */

static vbss_view view_of(rig *r, vbss_thread_field field)
{
    vbss_view view;
    expect_ok(vbss_thread_get_view(r->thread, field, &view, sizeof view));
    return view;
}

static const double *item(const vbss_view *view, uint64_t i)
{
    assert_true(i < view->count);
    return (const double *)(const void *)((const char *)view->data + i * view->stride_bytes);
}

static vec3 vector_at(rig *r, vbss_thread_field field, uint32_t node)
{
    vbss_view view = view_of(r, field);
    return vec3_load(item(&view, node));
}

vec3 rig_position(rig *r, uint32_t node)
{
    return vector_at(r, VBSS_THREAD_VIEW_POSITIONS, node);
}

vec3 rig_velocity(rig *r, uint32_t node)
{
    return vector_at(r, VBSS_THREAD_VIEW_VELOCITIES, node);
}

vec3 rig_curvature(rig *r, uint32_t node)
{
    return vector_at(r, VBSS_THREAD_VIEW_CURVATURES, node);
}

vec3 rig_tip(rig *r)
{
    return rig_position(r, r->nodes - 1);
}

double rig_tension(rig *r, uint32_t segment)
{
    vbss_view view = view_of(r, VBSS_THREAD_VIEW_TENSIONS);
    return *item(&view, segment);
}

double rig_fastest(rig *r)
{
    vbss_view view = view_of(r, VBSS_THREAD_VIEW_VELOCITIES);
    double fastest = 0.0;
    for (uint64_t i = 0; i < view.count; i++) {
        fastest = fmax(fastest, vec3_norm(vec3_load(item(&view, i))));
    }
    return fastest;
}

void rig_read(rig *r, vbss_thread_field field, vec3 *values)
{
    vbss_view view = view_of(r, field);
    for (uint64_t i = 0; i < view.count; i++) {
        values[i] = vec3_load(item(&view, i));
    }
}

static double *numbers_of(const rig *r, const vec3 *vectors)
{
    double *numbers = calloc(3 * (size_t)r->nodes, sizeof *numbers);
    assert_non_null(numbers);
    for (uint32_t i = 0; vectors != NULL && i < r->nodes; i++) {
        vec3_store(&numbers[3 * (size_t)i], vectors[i]);
    }
    return numbers;
}

void rig_place(rig *r, const vec3 *positions, const vec3 *velocities)
{
    double *x = numbers_of(r, positions), *v = numbers_of(r, velocities);
    expect_ok(vbss_thread_set_state(r->thread, positions != NULL ? x : NULL,
                                    velocities != NULL ? v : NULL, r->nodes));
    free(x);
    free(v);
}

rig_shape rig_shape_of(rig *r)
{
    rig_shape s = {.nodes = r->nodes};
    assert_true(r->nodes <= RIG_SHAPE_NODES);
    rig_read(r, VBSS_THREAD_VIEW_POSITIONS, s.x);
    rig_read(r, VBSS_THREAD_VIEW_VELOCITIES, s.v);
    for (uint32_t i = 0; i + 1 < r->nodes; i++) {
        s.tension[i] = rig_tension(r, i);
    }
    return s;
}

vec3 rig_difference(const rig_shape *a, const rig_shape *b)
{
    vec3 largest = vec3_zero();
    assert_int_equal(a->nodes, b->nodes);
    for (uint32_t i = 0; i < a->nodes; i++) {
        largest.x = fmax(largest.x, vec3_distance(a->x[i], b->x[i]));
        largest.y = fmax(largest.y, vec3_distance(a->v[i], b->v[i]));
        if (i + 1 < a->nodes) {
            largest.z = fmax(largest.z, fabs(a->tension[i] - b->tension[i]));
        }
    }
    return largest;
}

static vbss_thread_reaction reaction_of(rig *r, uint32_t id)
{
    vbss_thread_reaction reaction;
    expect_ok(vbss_thread_get_reaction(r->thread, id, &reaction, sizeof reaction));
    return reaction;
}

vec3 rig_reaction_force(rig *r, uint32_t id)
{
    vbss_thread_reaction reaction = reaction_of(r, id);
    return vec3_load(reaction.force);
}

vec3 rig_reaction_torque(rig *r, uint32_t id)
{
    vbss_thread_reaction reaction = reaction_of(r, id);
    return vec3_load(reaction.torque);
}

vbss_thread_energies rig_energies(rig *r)
{
    vbss_thread_energies energies;
    expect_ok(vbss_thread_get_energies(r->thread, &energies, sizeof energies));
    return energies;
}

vbss_thread_momentum rig_momentum(rig *r)
{
    vbss_thread_momentum momentum;
    expect_ok(vbss_thread_get_momentum(r->thread, &momentum, sizeof momentum));
    return momentum;
}

vbss_baseline_statistics rig_baseline_statistics(rig *r)
{
    vbss_baseline_statistics statistics;
    expect_ok(vbss_thread_get_baseline_statistics(r->thread, &statistics, sizeof statistics));
    return statistics;
}

vbss_thread_statistics rig_statistics(rig *r)
{
    vbss_thread_statistics statistics;
    expect_ok(vbss_thread_get_statistics(r->thread, &statistics, sizeof statistics));
    return statistics;
}
