#include "scene/needle_case.h"

#include "base/rotation.h"

/* The exact arc and the chain of capsules are that far apart, and walls bend: in distances of touching. */
#define AT_HOLE 1.5

const vbss_rigid_coupling needle_case_coupling = {2e4, 20.0, 5.0, 0.02};

/* ---- life */

void needle_case_begin(needle_case *c)
{
    memset(c, 0, sizeof *c);
    c->at_hole = AT_HOLE;
    drain_case_begin(&c->d);
    expect_ok(vbss_needle_config_init(&c->config, sizeof c->config));
}

void needle_case_make(needle_case *c)
{
    drain_case_make(&c->d);
    small_object(&c->d.s)->on_substep = NULL; /* it would take every hole for a defect */
}

void needle_case_end(needle_case *c)
{
    drain_case_end(&c->d);
}

static scene_rigid *rigid_of(const needle_case *c)
{
    return &vbss_scene_body(small_object(&c->d.s), c->body)->rigid;
}

pose needle_case_pose(double radius, vec3 tip, vec3 direction, vec3 aside)
{
    direction = vec3_unit_or(direction, vec3_zero());
    aside =
        vec3_unit_or(vec3_add_scaled(aside, -vec3_dot(aside, direction), direction), vec3_zero());
    quat first = quat_between(vec3_make(0.0, 1.0, 0.0), direction);
    vec3 now = quat_rotate(first, vec3_make(1.0, 0.0, 0.0));
    double angle = atan2(vec3_dot(vec3_cross(now, aside), direction), vec3_dot(now, aside));
    quat turned = quat_mul(vbss_quat_from_rotation_vector(vec3_scale(direction, angle)), first);
    return pose_make(vec3_add_scaled(tip, -radius, aside), turned);
}

void needle_case_put(needle_case *c, vec3 tip, vec3 direction, vec3 aside)
{
    c->hand = needle_case_pose(c->config.radius, tip, direction, aside);
    const quat q = c->hand.orientation;
    const double parts[4] = {q.w, q.x, q.y, q.z};
    memcpy(c->config.orientation, parts, sizeof parts);
    vec3_store(c->config.position, c->hand.position);
    if (c->needle == NULL) {
        expect_ok(vbss_needle_create(c->d.s.context, &c->config, &c->needle));
    } else {
        expect_ok(vbss_needle_set_state(c->needle, c->config.position, c->config.orientation,
                                        c->config.velocity, c->config.angular_velocity));
    }
    expect_ok(vbss_scene_add_needle(c->d.s.scene, c->needle, &c->body));
    scene_rigid *r = rigid_of(c);
    r->kind = VBSS_SCENE_RIGID_COUPLED;
    r->body.coupling = needle_case_coupling;
}

void needle_case_take_out(needle_case *c)
{
    expect_ok(vbss_scene_remove(c->d.s.scene, c->body));
    c->body = 0;
}

void needle_case_let_go(needle_case *c)
{
    scene_rigid *r = rigid_of(c);
    r->kind = VBSS_SCENE_RIGID_FREE;
    r->body.coupling = (vbss_rigid_coupling){0};
}

void needle_case_hold_edge(needle_case *c)
{
    drain_object *d;
    expect_ok(vbss_drain_open(c->d.drain, &d));
    (void)drain_case_pin(&c->d, d->mesh.slit_middle[DRAIN_RIGHT]);
}

void needle_case_at_mark(needle_case *c, double before)
{
    vec3 mark = drain_case_node(&c->d, c->d.places.marks[DRAIN_RIGHT]);
    double angle = atan2(mark.z, mark.y);
    vec3 into = vec3_make(0.0, -cos(angle), -sin(angle));
    vec3 aside = vec3_make(0.0, -sin(angle), cos(angle));
    double back = before / c->config.radius;
    vec3 centre = vec3_add_scaled(mark, -c->config.radius, aside);
    vec3 out = vec3_add_scaled(vec3_scale(aside, cos(back)), -sin(back), into);
    vec3 direction = vec3_add_scaled(vec3_scale(into, cos(back)), sin(back), aside);
    needle_case_hold_edge(c);
    needle_case_put(c, vec3_add_scaled(centre, c->config.radius, out), direction, out);
}

void needle_case_begin_at_mark(needle_case *c, vbss_drain_mesh mesh, double before)
{
    needle_case_begin(c);
    c->d.config.mesh = mesh;
    needle_case_make(c);
    needle_case_at_mark(c, before);
}

/* ---- looks */

vbss_needle_state needle_case_state(const needle_case *c)
{
    vbss_needle_state state;
    expect_ok(vbss_needle_get_state(c->needle, &state, sizeof state));
    return state;
}

/* What turns it about its arc's centre works along the arc, whatever its holes bear across. */
static double push_of(const needle_case *c)
{
    const scene_rigid *r = rigid_of(c);
    vbss_needle_state state = needle_case_state(c);
    const double *q = state.orientation;
    vec3 axis = quat_rotate(quat_make(q[0], q[1], q[2], q[3]), vec3_make(0.0, 0.0, 1.0));
    vec3 arm = vec3_sub(r->body.now.pose.position, vec3_load(state.position));
    vec3 torque = vec3_add(r->coupling_wrench.torque, vec3_cross(arm, r->coupling_wrench.force));
    return vec3_dot(axis, torque) / c->config.radius;
}

vec3 needle_case_hand_force(const needle_case *c)
{
    return rigid_of(c)->coupling_wrench.force;
}

uint32_t needle_case_holes(const needle_case *c, vbss_scene_hole holes[NEEDLE_CASE_HOLES])
{
    uint32_t count = 0;
    while (count < NEEDLE_CASE_HOLES &&
           vbss_scene_get_hole(c->d.s.scene, count, &holes[count], sizeof *holes) == VBSS_OK) {
        count++;
    }
    return count;
}

double needle_case_energy(const needle_case *c)
{
    vbss_needle_energies e;
    expect_ok(vbss_needle_get_energies(c->needle, &e, sizeof e));
    return e.kinetic + drain_case_energies(&c->d).total;
}

/* ---- the oracle */

bool needle_case_crosses(const vec3 axis[2], const vec3 corner[3], vec3 *there)
{
    vec3 normal = vec3_cross(vec3_sub(corner[1], corner[0]), vec3_sub(corner[2], corner[0]));
    double from = vec3_dot(normal, vec3_sub(axis[0], corner[0]));
    double to = vec3_dot(normal, vec3_sub(axis[1], corner[0]));
    if (from * to > 0.0 || from == to) {
        return false;
    }
    *there = vec3_lerp(axis[0], axis[1], from / (from - to));
    for (int k = 0; k < 3; k++) {
        vec3 side = vec3_sub(corner[(k + 1) % 3], corner[k]);
        if (vec3_dot(normal, vec3_cross(side, vec3_sub(*there, corner[k]))) < 0.0) {
            return false;
        }
    }
    return true;
}

/* Where the wall is stretched, what is near at rest is far. */
static bool is_at_hole(needle_case *c, vec3 there, vec3 at_rest)
{
    vbss_scene_hole holes[NEEDLE_CASE_HOLES];
    double touching = c->at_hole * (c->config.wire_radius + 0.5 * c->d.config.thickness);
    double nearest = HUGE_VAL;
    bool at = false;
    uint32_t count = needle_case_holes(c, holes);
    for (uint32_t i = 0; i < count; i++) {
        double far = fmin(vec3_distance(there, vec3_load(holes[i].position)),
                          vec3_distance(at_rest, vec3_load(holes[i].rest_position)));
        vec3 force = vec3_load(holes[i].force), direction = vec3_load(holes[i].direction);
        vec3 across = vec3_add_scaled(force, -vec3_dot(force, direction), direction);
        at = at || far < touching + c->give * vec3_norm(across);
        nearest = fmin(nearest, far);
    }
    c->farthest = count > 0 ? fmax(c->farthest, nearest) : c->farthest;
    return at;
}

/* The same point of a triangle in another state of it. */
static vec3 carried(const vec3 corner[3], const vec3 other[3], vec3 there)
{
    vec3 e1 = vec3_sub(corner[1], corner[0]), e2 = vec3_sub(corner[2], corner[0]);
    vec3 normal = vec3_cross(e1, e2), to = vec3_sub(there, corner[0]);
    double size = vec3_norm_squared(normal);
    double a = vec3_dot(normal, vec3_cross(to, e2)) / size;
    double b = vec3_dot(normal, vec3_cross(e1, to)) / size;
    vec3 p = vec3_add_scaled(other[0], a, vec3_sub(other[1], other[0]));
    return vec3_add_scaled(p, b, vec3_sub(other[2], other[0]));
}

static void count_crossings(needle_case *c)
{
    vbss_view x, rest, triangles, axis;
    expect_ok(vbss_drain_get_view(c->d.drain, VBSS_DRAIN_VIEW_POSITIONS, &x, sizeof x));
    expect_ok(vbss_drain_get_view(c->d.drain, VBSS_DRAIN_VIEW_REST_POSITIONS, &rest, sizeof rest));
    expect_ok(
        vbss_drain_get_view(c->d.drain, VBSS_DRAIN_VIEW_TRIANGLES, &triangles, sizeof triangles));
    expect_ok(vbss_needle_get_view(c->needle, VBSS_NEEDLE_VIEW_POINTS, &axis, sizeof axis));
    const vec3 *nodes = x.data, *at_rest = rest.data, *points = axis.data;
    const uint32_t *node = triangles.data;
    c->crossings = 0;
    for (uint64_t i = 0; i + 1 < axis.count; i++) {
        for (uint64_t t = 0; t < triangles.count; t++) {
            const vec3 corner[3] = {nodes[node[3 * t]], nodes[node[3 * t + 1]],
                                    nodes[node[3 * t + 2]]};
            vec3 there;
            if (needle_case_crosses(points + i, corner, &there)) {
                c->crossings++;
                const vec3 other[3] = {at_rest[node[3 * t]], at_rest[node[3 * t + 1]],
                                       at_rest[node[3 * t + 2]]};
                c->away += is_at_hole(c, there, carried(corner, other, there)) ? 0 : 1;
            }
        }
    }
}

/* ---- steps */

void needle_case_turn(needle_case *c, double distance)
{
    vec3 turn = vec3_make(0.0, 0.0, distance / c->config.radius);
    c->hand.orientation = quat_mul(c->hand.orientation, vbss_quat_from_rotation_vector(turn));
}

void needle_case_shift(needle_case *c, vec3 displacement)
{
    c->hand.position = vec3_add(c->hand.position, displacement);
}

void needle_case_step(needle_case *c)
{
    scene_rigid *r = rigid_of(c);
    if (r->kind == VBSS_SCENE_RIGID_COUPLED) {
        vbss_scene_set_tool_target(small_object(&c->d.s), r, pose_mul(c->hand, r->frame));
    }
    drain_case_step(&c->d);
    const step_events events = step_events_of(c->d.s.scene);
    memset(c->happened, 0, sizeof c->happened);
    for (uint32_t i = 0; i < events.count; i++) {
        const uint32_t kind = (uint32_t)events.of[i].kind;
        assert_true(kind < NEEDLE_CASE_EVENTS);
        c->happened[kind]++;
        c->counts[kind]++;
    }
    vec3 force = needle_case_hand_force(c);
    vbss_needle_state state = needle_case_state(c);
    c->push = push_of(c);
    c->peak = fmax(c->peak, c->push);
    c->at_tip = fmax(c->at_tip, vec3_dot(force, vec3_load(state.tip_direction)));
    assert_true(isfinite(needle_case_energy(c)));
    count_crossings(c);
}

void needle_case_wait(needle_case *c, uint32_t steps)
{
    for (uint32_t i = 0; i < steps; i++) {
        needle_case_step(c);
    }
}

bool needle_case_drive(needle_case *c, double distance, double speed, vbss_scene_event_kind until)
{
    uint32_t steps = (uint32_t)ceil(fabs(distance) / (speed * c->d.h));
    for (uint32_t i = 0; i < steps; i++) {
        needle_case_turn(c, distance / steps);
        needle_case_step(c);
        if (until != 0 && c->happened[until] > 0) {
            return true;
        }
    }
    return false;
}

void needle_case_expect_kept(const needle_case *c, const char *name, uint32_t max_clamped)
{
    vbss_scene_statistics s = small_statistics(&c->d.s);
    vbss_drain_statistics d = drain_case_statistics(&c->d);
    print_message("%s: %llu steps, %llu parts; rejected %llu states %llu depth %llu guard; clamped "
                  "%llu, paused %llu; %u in, %u back, %u through, %u lost; inverted %u; overlap "
                  "%.0f um; %u crossings away\n",
                  name, (unsigned long long)s.steps, (unsigned long long)s.parts,
                  (unsigned long long)s.rejected_states, (unsigned long long)s.rejected_depth,
                  (unsigned long long)s.rejected_guard, (unsigned long long)s.clamped,
                  (unsigned long long)s.paused, c->counts[VBSS_SCENE_EVENT_PUNCTURE],
                  c->counts[VBSS_SCENE_EVENT_WITHDRAWN], c->counts[VBSS_SCENE_EVENT_PASSED],
                  c->counts[VBSS_SCENE_EVENT_HOLE_LOST], d.inverted, 1e6 * s.penetration, c->away);
    assert_int_equal(c->away, 0);
    assert_true(s.clamped <= max_clamped);
}
