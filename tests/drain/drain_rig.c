#include "drain/drain_rig.h"

#include <math.h>
#include <string.h>

/* ---- life */

void drain_rig_begin(drain_rig *r)
{
    memset(r, 0, sizeof *r);
    r->context = harness_context(&r->memory);
    expect_ok(vbss_drain_config_init(&r->config, sizeof r->config));
}

void drain_rig_make(drain_rig *r)
{
    expect_ok(vbss_drain_create(r->context, &r->config, &r->drain));
    expect_ok(vbss_drain_get_places(r->drain, &r->places, sizeof r->places));
}

void drain_rig_end(drain_rig *r)
{
    expect_ok(vbss_drain_destroy(r->drain));
    harness_context_end(r->context, &r->memory);
}

/* ---- attachments */

static uint32_t attach(drain_rig *r, vbss_drain_attachment_kind kind, uint32_t node, vec3 position,
                       vec3 force, double stiffness)
{
    vbss_drain_attachment a;
    uint32_t id = 0;
    expect_ok(vbss_drain_attachment_init(&a, sizeof a));
    a.kind = kind;
    a.node = node;
    vec3_store(a.position, position);
    vec3_store(a.force, force);
    a.stiffness = stiffness;
    expect_ok(vbss_drain_attach(r->drain, &a, &id));
    return id;
}

uint32_t drain_rig_pin(drain_rig *r, uint32_t node, vec3 position)
{
    return attach(r, VBSS_DRAIN_ATTACHMENT_PIN, node, position, vec3_zero(), 0.0);
}

uint32_t drain_rig_pin_here(drain_rig *r, uint32_t node)
{
    return drain_rig_pin(r, node, drain_rig_position(r, node));
}

uint32_t drain_rig_force(drain_rig *r, uint32_t node, vec3 force)
{
    return attach(r, VBSS_DRAIN_ATTACHMENT_FORCE, node, vec3_zero(), force, 0.0);
}

uint32_t drain_rig_spring(drain_rig *r, uint32_t node, vec3 position, double stiffness)
{
    return attach(r, VBSS_DRAIN_ATTACHMENT_SPRING, node, position, vec3_zero(), stiffness);
}

void drain_rig_move(drain_rig *r, uint32_t id, vec3 target)
{
    double to[3];
    vec3_store(to, target);
    expect_ok(vbss_drain_set_attachment_target(r->drain, id, to));
}

void drain_rig_detach(drain_rig *r, uint32_t id)
{
    expect_ok(vbss_drain_detach(r->drain, id));
}

void drain_rig_pull_marks(drain_rig *r, double force)
{
    const double *q = r->config.orientation;
    quat turned = quat_unit(quat_make(q[0], q[1], q[2], q[3]));
    vec3 pull = quat_rotate(turned, vec3_make(0.0, 0.0, force));
    drain_rig_force(r, r->places.marks[0], pull);
    drain_rig_force(r, r->places.marks[1], vec3_neg(pull));
}

/* ---- time */

void drain_rig_run(drain_rig *r, double h, uint32_t steps)
{
    for (uint32_t i = 0; i < steps; i++) {
        expect_ok(vbss_drain_step(r->drain, h));
    }
}

void drain_rig_statics(drain_rig *r)
{
    r->config.iteration_limit = 20;
    r->config.position_tolerance = 1e-12;
    r->config.move_limit = 1.0;
    r->config.halving_limit = 0;
    r->config.tear_stress = 1e12;
}

void drain_rig_relax(drain_rig *r, double speed, uint32_t limit)
{
    uint32_t steps = 0;
    do {
        assert_true(steps++ < limit);
        drain_rig_run(r, 0.1, 1);
    } while (drain_rig_fastest(r) > speed);
}

/* ---- looks */

static vbss_view view_of(drain_rig *r, vbss_drain_field field)
{
    vbss_view view;
    expect_ok(vbss_drain_get_view(r->drain, field, &view, sizeof view));
    return view;
}

uint32_t drain_rig_count(drain_rig *r, vbss_drain_field field)
{
    return (uint32_t)view_of(r, field).count;
}

const vec3 *drain_rig_vectors(drain_rig *r, vbss_drain_field field)
{
    vbss_view view = view_of(r, field);
    assert_int_equal(view.type, VBSS_VIEW_TYPE_F64);
    assert_int_equal(view.stride_bytes, sizeof(vec3));
    return view.data;
}

const uint32_t *drain_rig_numbers(drain_rig *r, vbss_drain_field field)
{
    vbss_view view = view_of(r, field);
    assert_int_equal(view.type, VBSS_VIEW_TYPE_U32);
    assert_int_equal(view.stride_bytes, view.components * sizeof(uint32_t));
    return view.data;
}

vec3 drain_rig_position(drain_rig *r, uint32_t node)
{
    assert_true(node < r->places.node_count);
    return drain_rig_vectors(r, VBSS_DRAIN_VIEW_POSITIONS)[node];
}

vec3 drain_rig_reaction(drain_rig *r, uint32_t id)
{
    double force[3];
    expect_ok(vbss_drain_get_reaction(r->drain, id, force));
    return vec3_load(force);
}

double drain_rig_fastest(drain_rig *r)
{
    const vec3 *v = drain_rig_vectors(r, VBSS_DRAIN_VIEW_VELOCITIES);
    double fastest = 0.0;
    for (uint32_t i = 0; i < r->places.node_count; i++) {
        assert_true(vec3_is_finite(v[i]));
        fastest = fmax(fastest, vec3_norm(v[i]));
    }
    return fastest;
}

vec3 drain_rig_anchor_sum(drain_rig *r)
{
    const vec3 *forces = drain_rig_vectors(r, VBSS_DRAIN_VIEW_ANCHOR_FORCES);
    vec3 sum = vec3_zero();
    for (uint32_t i = 0; i < drain_rig_count(r, VBSS_DRAIN_VIEW_ANCHORS); i++) {
        sum = vec3_add(sum, forces[i]);
    }
    return sum;
}

vbss_drain_gap drain_rig_gap(drain_rig *r)
{
    vbss_drain_gap gap;
    expect_ok(vbss_drain_get_gap(r->drain, &gap, sizeof gap));
    return gap;
}

vbss_drain_energies drain_rig_energies(drain_rig *r)
{
    vbss_drain_energies energies;
    expect_ok(vbss_drain_get_energies(r->drain, &energies, sizeof energies));
    return energies;
}

vbss_drain_statistics drain_rig_statistics(drain_rig *r)
{
    vbss_drain_statistics statistics;
    expect_ok(vbss_drain_get_statistics(r->drain, &statistics, sizeof statistics));
    return statistics;
}

uint64_t drain_rig_hash(drain_rig *r)
{
    uint64_t hash;
    expect_ok(vbss_drain_get_hash(r->drain, &hash));
    return hash;
}

void drain_rig_tear_off(drain_rig *r)
{
    static vec3 rest[DRAIN_RIG_NODES], still[DRAIN_RIG_NODES];
    uint32_t anchors = drain_rig_count(r, VBSS_DRAIN_VIEW_ANCHORS);
    drain_rig_copy(r, rest);
    uint32_t pull = drain_rig_force(r, r->places.marks[0], vec3_make(0.0, 0.2, 0.0));
    for (uint32_t k = 0; k < 1000 && drain_rig_statistics(r).torn < anchors; k++) {
        drain_rig_run(r, 1e-3, 1);
    }
    assert_int_equal(drain_rig_statistics(r).torn, anchors);
    drain_rig_detach(r, pull);
    expect_ok(vbss_drain_set_state(r->drain, &rest[0].x, &still[0].x, r->places.node_count));
}

/* ---- by node */

void drain_rig_areas(drain_rig *r, double *areas)
{
    const vec3 *rest = drain_rig_vectors(r, VBSS_DRAIN_VIEW_REST_POSITIONS);
    const uint32_t *corners = drain_rig_numbers(r, VBSS_DRAIN_VIEW_TRIANGLES);
    assert_true(r->places.node_count <= DRAIN_RIG_NODES);
    memset(areas, 0, r->places.node_count * sizeof *areas);
    for (uint32_t t = 0; t < r->places.triangle_count; t++) {
        const uint32_t *c = corners + (size_t)3 * t;
        vec3 u = vec3_sub(rest[c[1]], rest[c[0]]), v = vec3_sub(rest[c[2]], rest[c[0]]);
        for (int k = 0; k < 3; k++) {
            areas[c[k]] += vec3_norm(vec3_cross(u, v)) / 6.0;
        }
    }
}

void drain_rig_masses(drain_rig *r, double *masses)
{
    drain_rig_areas(r, masses);
    for (uint32_t i = 0; i < r->places.node_count; i++) {
        masses[i] *= r->config.density * r->config.thickness;
    }
}

double drain_rig_distance(drain_rig *r, const vec3 *positions)
{
    const vec3 *x = drain_rig_vectors(r, VBSS_DRAIN_VIEW_POSITIONS);
    double largest = 0.0;
    for (uint32_t i = 0; i < r->places.node_count; i++) {
        largest = fmax(largest, vec3_distance(x[i], positions[i]));
    }
    return largest;
}

void drain_rig_copy(drain_rig *r, vec3 *positions)
{
    assert_true(r->places.node_count <= DRAIN_RIG_NODES);
    memcpy(positions, drain_rig_vectors(r, VBSS_DRAIN_VIEW_POSITIONS),
           r->places.node_count * sizeof *positions);
}

bool drain_rig_is_anchor(drain_rig *r, uint32_t node)
{
    const uint32_t *anchors = drain_rig_numbers(r, VBSS_DRAIN_VIEW_ANCHORS);
    for (uint32_t i = 0; i < drain_rig_count(r, VBSS_DRAIN_VIEW_ANCHORS); i++) {
        if (anchors[i] == node) {
            return true;
        }
    }
    return false;
}
