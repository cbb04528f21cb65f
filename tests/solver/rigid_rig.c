#include "solver/rigid_rig.h"

#include "base/rotation.h"

void rigid_rig_begin(rigid_rig *rig, vbss_role role)
{
    *rig = (rigid_rig){.h = 1e-3, .rounds = 1, .parts = 1};
    rig->body.mass = 0.05;
    rig->body.inertia = vec3_make(2e-5, 5e-5, 4e-5);
    rigid_rig_place(rig, pose_identity());
    rig->context = harness_context(&rig->memory);
    expect_ok(vbss_system_create(rig->context, 2, 1, 2, 1, &rig->system));
    vbss_system_begin_pattern(rig->system);
    expect_ok(vbss_rigid_register(rig->system, role, &rig->blocks));
    expect_ok(vbss_system_analyse(rig->system));
}

void rigid_rig_end(rigid_rig *rig)
{
    vbss_system_destroy(rig->context, rig->system);
    harness_context_end(rig->context, &rig->memory);
}

void rigid_rig_place(rigid_rig *rig, pose at)
{
    rig->body.now = (vbss_rigid_motion){at, vec3_zero(), vec3_zero()};
    rig->body.target_start = rig->body.target_end = at;
}

void rigid_rig_solve(vbss_system *system)
{
    assert_true(vbss_system_condense(system));
    vbss_system_load_schur_complement(system);
    assert_true(vbss_system_solve(system));
}

void rigid_rig_step(rigid_rig *rig, pose end)
{
    vbss_system *s = rig->system;
    vec3 *rhs = &s->rhs[rig->blocks.first], *u = &s->solution[rig->blocks.first];
    assert_true(vbss_rigid_is_valid(&rig->body));
    vbss_rigid_set_target(&rig->body, end);
    for (uint32_t p = 0; p < rig->parts; p++) {
        rig->part = (vbss_rigid_substep){rig->h, (double)p / rig->parts, (p + 1.0) / rig->parts};
        vbss_rigid_predict(&rig->body, &rig->part, &rig->predicted);
        pose trial = rig->predicted.pose;
        for (uint32_t k = 0; k < rig->rounds; k++) {
            vbss_system_clear(s);
            vbss_rigid_assemble(&rig->body, &rig->part, &rig->predicted, &trial, s, &rig->blocks);
            rhs[0] = vec3_add(rhs[0], rig->force);
            rhs[1] = vec3_add(rhs[1], rig->torque);
            rigid_rig_solve(s);
            vbss_rigid_apply_increment(&trial, u[0], u[1]);
        }
        vbss_rigid_commit(&rig->body, &rig->part, &rig->predicted, &trial);
    }
}

void rigid_rig_steps(rigid_rig *rig, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        rigid_rig_step(rig, rig->body.target_end);
    }
}

double rigid_energy(const vbss_rigid *body)
{
    vec3 l = vbss_rigid_angular_momentum(body, &body->now);
    return 0.5 * (body->mass * vec3_norm_squared(body->now.v) + vec3_dot(l, body->now.w));
}

double rigid_turn(quat from, quat to)
{
    quat turn = quat_mul(to, quat_conjugate(from));
    return 2.0 * vec3_norm(vec3_make(turn.x, turn.y, turn.z)); /* small ones */
}

pose rigid_draw_pose(harness_source *source, double size)
{
    vec3 position = harness_draw_vec3(source, -size, size);
    return pose_make(position, harness_draw_unit_quat(source));
}

void rigid_draw_mass(harness_source *source, vbss_rigid *body)
{
    vec3 p = harness_draw_vec3(source, -2.0, 2.0);
    double size = harness_draw_real(source, -3.0, -1.0);
    double x = pow(10.0, p.x + 2.0 * size), y = pow(10.0, p.y + 2.0 * size);
    double z = pow(10.0, p.z + 2.0 * size);
    body->mass = pow(10.0, harness_draw_real(source, -5.0, 1.0));
    body->inertia = vec3_scale(vec3_make(y + z, z + x, x + y), body->mass);
}

/* ---- Runge and Kutta's method of fourth order */

typedef struct turning {
    quat q;
    vec3 w; /* in the body's own axes */
} turning;

static vec3 times(vec3 a, vec3 b)
{
    return vec3_make(a.x * b.x, a.y * b.y, a.z * b.z);
}

static turning derivative(const vbss_rigid *body, const turning *s, vec3 torque)
{
    const vbss_rigid_coupling *c = &body->coupling;
    vec3 j = body->inertia;
    quat turn = quat_mul(body->target_end.orientation, quat_conjugate(quat_unit(s->q)));
    vec3 pull = vec3_scale(vbss_quat_to_rotation_vector(turn), c->turning_stiffness);
    vec3 t = quat_rotate_back(s->q, vec3_add(torque, pull));
    t = vec3_add_scaled(t, -c->turning_damping, s->w);
    t = vec3_sub(t, vec3_cross(s->w, times(j, s->w)));
    quat rate = quat_mul(s->q, quat_make(0.0, s->w.x, s->w.y, s->w.z));
    return (turning){quat_make(0.5 * rate.w, 0.5 * rate.x, 0.5 * rate.y, 0.5 * rate.z),
                     vec3_make(t.x / j.x, t.y / j.y, t.z / j.z)};
}

static turning moved(const turning *s, double h, const turning *d)
{
    return (turning){quat_make(s->q.w + h * d->q.w, s->q.x + h * d->q.x, s->q.y + h * d->q.y,
                               s->q.z + h * d->q.z),
                     vec3_add_scaled(s->w, h, d->w)};
}

vbss_rigid_motion rigid_fine(const vbss_rigid *body, vec3 torque, double time, uint32_t count)
{
    double h = time / count;
    quat q = body->now.pose.orientation;
    turning s = {q, quat_rotate_back(q, body->now.w)};
    for (uint32_t i = 0; i < count; i++) {
        turning k1 = derivative(body, &s, torque), at = moved(&s, 0.5 * h, &k1);
        turning k2 = derivative(body, &at, torque);
        at = moved(&s, 0.5 * h, &k2);
        turning k3 = derivative(body, &at, torque);
        at = moved(&s, h, &k3);
        turning k4 = derivative(body, &at, torque);
        s = moved(&s, h / 6.0, &k1);
        s = moved(&s, h / 3.0, &k2);
        s = moved(&s, h / 3.0, &k3);
        s = moved(&s, h / 6.0, &k4);
        s.q = quat_unit(s.q);
    }
    return (vbss_rigid_motion){pose_make(body->now.pose.position, s.q), body->now.v,
                               quat_rotate(s.q, s.w)};
}
