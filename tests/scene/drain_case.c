#include "scene/drain_case.h"

#include "base/rotation.h"
#include "scene/folded.h"
#include "fixtures/scene_build.h"

/* Below this no gain is looked at, J: of the drain's energy when the slit is closed a thousandth. */
#define MIN_GAIN 1e-6

/* ---- life */

void drain_case_begin(drain_case *c)
{
    memset(c, 0, sizeof *c);
    small_begin(&c->s);
    expect_ok(vbss_drain_config_init(&c->config, sizeof c->config));
    c->s.config.contact_capacity = 4096;
    c->s.config.candidate_capacity = 65536;
    c->h = 1e-3;
}

void drain_case_make(drain_case *c)
{
    small_create(&c->s);
    expect_ok(scene_build_drain(c->s.context, c->s.scene, &c->config, &c->drain, &c->body));
    expect_ok(vbss_drain_get_places(c->drain, &c->places, sizeof c->places));
    small_watch_begin(&c->s, &c->watch);
    drain_case_reckon(c);
}

void drain_case_end(drain_case *c)
{
    small_end(&c->s);
}

/* ---- what is there */

uint32_t drain_case_tool(drain_case *c, vbss_scene_rigid_kind kind, vec3 middle, vec3 half,
                         double radius)
{
    assert_true(c->tool_count < DRAIN_CASE_TOOLS);
    drain_case_hand *hand = &c->tools[c->tool_count];
    *hand = (drain_case_hand){small_stick(&c->s, kind, middle, half, radius), middle, middle};
    drain_case_reckon(c);
    return c->tool_count++;
}

static uint32_t attach(drain_case *c, vbss_drain_attachment_kind kind, uint32_t node, vec3 position,
                       vec3 force)
{
    vbss_drain_attachment a;
    uint32_t id = 0;
    expect_ok(vbss_drain_attachment_init(&a, sizeof a));
    a.kind = kind;
    a.node = node;
    vec3_store(a.position, position);
    vec3_store(a.force, force);
    expect_ok(vbss_drain_attach(c->drain, &a, &id));
    return id;
}

uint32_t drain_case_pin(drain_case *c, uint32_t node)
{
    assert_true(c->pin_count < DRAIN_CASE_PINS);
    vec3 at = drain_case_node(c, node);
    uint32_t id = attach(c, VBSS_DRAIN_ATTACHMENT_PIN, node, at, vec3_zero());
    c->pins[c->pin_count] = (drain_case_hand){id, at, at};
    return c->pin_count++;
}

void drain_case_unpin(drain_case *c, uint32_t pin)
{
    expect_ok(vbss_drain_detach(c->drain, c->pins[pin].id));
    c->pins[pin].id = 0;
}

void drain_case_force(drain_case *c, uint32_t node, vec3 force)
{
    (void)attach(c, VBSS_DRAIN_ATTACHMENT_FORCE, node, vec3_zero(), force);
}

void drain_case_thread(drain_case *c, vec3 begin, vec3 end, uint32_t segments)
{
    assert_true(c->thread_count < DRAIN_CASE_THREADS);
    (void)small_thread(&c->s, begin, end, segments, &c->threads[c->thread_count++]);
    drain_case_reckon(c);
}

/* ---- looks */

static vec3 vector_of(const drain_case *c, vbss_drain_field field, uint64_t i)
{
    vbss_view view;
    double v[3];
    expect_ok(vbss_drain_get_view(c->drain, field, &view, sizeof view));
    assert_true(i < view.count);
    memcpy(v, (const char *)view.data + i * view.stride_bytes, sizeof v);
    return vec3_load(v);
}

vec3 drain_case_node(const drain_case *c, uint32_t node)
{
    return vector_of(c, VBSS_DRAIN_VIEW_POSITIONS, node);
}

vec3 drain_case_at(const drain_case *c, uint32_t tool)
{
    return small_position(&c->s, c->tools[tool].id);
}

vec3 drain_case_contact_force(const drain_case *c, uint32_t tool)
{
    vbss_scene_rigid_state state = small_rigid(&c->s, c->tools[tool].id);
    return vec3_load(state.contact_force);
}

vec3 drain_case_anchor_sum(const drain_case *c)
{
    vbss_view view;
    vec3 sum = vec3_zero();
    expect_ok(vbss_drain_get_view(c->drain, VBSS_DRAIN_VIEW_ANCHOR_FORCES, &view, sizeof view));
    for (uint64_t i = 0; i < view.count; i++) {
        sum = vec3_add(sum, ((const vec3 *)view.data)[i]);
    }
    return sum;
}

vbss_drain_statistics drain_case_statistics(const drain_case *c)
{
    vbss_drain_statistics statistics;
    expect_ok(vbss_drain_get_statistics(c->drain, &statistics, sizeof statistics));
    return statistics;
}

vbss_drain_energies drain_case_energies(const drain_case *c)
{
    vbss_drain_energies energies;
    expect_ok(vbss_drain_get_energies(c->drain, &energies, sizeof energies));
    return energies;
}

double drain_case_distance(const drain_case *c)
{
    double farthest = 0.0;
    for (uint32_t i = 0; i < c->places.node_count; i++) {
        vec3 rest = vector_of(c, VBSS_DRAIN_VIEW_REST_POSITIONS, i);
        farthest = fmax(farthest, vec3_distance(drain_case_node(c, i), rest));
    }
    return farthest;
}

double drain_case_fastest(const drain_case *c)
{
    double fastest = 0.0;
    for (uint32_t i = 0; i < c->places.node_count; i++) {
        fastest = vbss_max_or_nan(vec3_norm(vector_of(c, VBSS_DRAIN_VIEW_VELOCITIES, i)), fastest);
    }
    return fastest;
}

/* ---- the ledger */

static double energy_of_contacts(const drain_case *c)
{
    double energy = 0.0;
    vbss_view view = small_view(&c->s, VBSS_SCENE_VIEW_CONTACT_FORCES);
    for (uint64_t i = 0; i < view.count; i++) {
        energy += vec3_norm_squared(((const vec3 *)view.data)[i]);
    }
    return 0.5 * energy / c->s.config.contact_stiffness;
}

static double energy_of_tool(const drain_case *c, const drain_case_hand *hand)
{
    const scene_rigid *r = &vbss_scene_body(small_object(&c->s), hand->id)->rigid;
    if (r->kind == VBSS_SCENE_RIGID_DRIVEN) {
        return 0.0;
    }
    const vbss_rigid *b = &r->body;
    vec3 turning = vbss_rigid_angular_momentum(b, &b->now);
    double kinetic =
        0.5 * b->mass * vec3_norm_squared(b->now.v) + 0.5 * vec3_dot(turning, b->now.w);
    vec3 turn = vbss_quat_to_rotation_vector(
        quat_mul(b->target_end.orientation, quat_conjugate(b->now.pose.orientation)));
    double spring = b->coupling.stiffness *
                        vec3_norm_squared(vec3_sub(b->target_end.position, b->now.pose.position)) +
                    b->coupling.turning_stiffness * vec3_norm_squared(turn);
    return kinetic + 0.5 * spring - b->mass * vec3_dot(b->gravity, b->now.pose.position);
}

double drain_case_energy(const drain_case *c)
{
    double energy = drain_case_energies(c).total + energy_of_contacts(c);
    for (uint32_t i = 0; i < c->tool_count; i++) {
        energy += energy_of_tool(c, &c->tools[i]);
    }
    for (uint32_t i = 0; i < c->thread_count; i++) {
        energy += small_thread_energy(c->threads[i], c->s.thread.axial_stiffness);
    }
    return energy;
}

void drain_case_reckon(drain_case *c)
{
    c->first = drain_case_energy(c);
    c->work = c->max_work = c->excess = 0.0;
}

/* Of implicit steps the force at the end counts, which is rather more than less. */
static double work_of(drain_case_hand *hand, vec3 force)
{
    double work = vec3_dot(force, vec3_sub(hand->to, hand->at));
    hand->at = hand->to;
    return work;
}

static void book(drain_case *c)
{
    for (uint32_t i = 0; i < c->tool_count; i++) {
        vbss_scene_rigid_state state = small_rigid(&c->s, c->tools[i].id);
        double sign = state.kind == VBSS_SCENE_RIGID_FREE ? 0.0 : -1.0;
        c->work += work_of(&c->tools[i], vec3_scale(vec3_load(state.hand_force), sign));
    }
    for (uint32_t i = 0; i < c->pin_count; i++) {
        double force[3];
        if (c->pins[i].id != 0) {
            expect_ok(vbss_drain_get_reaction(c->drain, c->pins[i].id, force));
            c->work += work_of(&c->pins[i], vec3_load(force));
        }
    }
    c->max_work = fmax(c->max_work, fabs(c->work));
    double energy = drain_case_energy(c);
    assert_true(isfinite(energy));
    c->excess = fmax(c->excess, energy - c->first - c->work);
}

/* ---- steps */

void drain_case_target(drain_case *c, uint32_t tool, vec3 to)
{
    c->tools[tool].to = to;
    small_move(&c->s, c->tools[tool].id, to);
}

void drain_case_target_pin(drain_case *c, uint32_t pin, vec3 to)
{
    double p[3];
    c->pins[pin].to = to;
    vec3_store(p, to);
    expect_ok(vbss_drain_set_attachment_target(c->drain, c->pins[pin].id, p));
}

void drain_case_step(drain_case *c)
{
    small_steps(&c->s, 1, c->h);
    c->steps++;
    uint32_t inverted = drain_case_statistics(c).inverted;
    assert_int_equal(folded_triangles(c->drain), inverted);
    c->inverted = inverted > c->inverted ? inverted : c->inverted;
    assert_true(isfinite(drain_case_fastest(c)));
    book(c);
}

void drain_case_wait(drain_case *c, uint32_t steps)
{
    for (uint32_t i = 0; i < steps; i++) {
        drain_case_step(c);
    }
}

void drain_case_move_to(drain_case *c, uint32_t tool, vec3 to, uint32_t steps)
{
    vec3 from = c->tools[tool].to;
    for (uint32_t i = 1; i <= steps; i++) {
        drain_case_target(c, tool, vec3_lerp(from, to, (double)i / steps));
        drain_case_step(c);
    }
}

/* ---- what it was like */

void drain_case_report(const drain_case *c, const char *name)
{
    vbss_scene_statistics s = small_statistics(&c->s);
    vbss_drain_statistics d = drain_case_statistics(c);
    print_message(
        "%s: %llu steps, %llu parts; rejected %llu states %llu stretch %llu depth %llu guard %llu "
        "singular; clamped %llu, paused %llu (%.3g s), recovering %llu, loose %llu; overlap %.0f "
        "um; "
        "forced %llu, dropped %llu, inverted %u at most, %u now, torn %u; work %.3g mJ at most, "
        "excess %.3g mJ; %.3g mJ, %.3g m/s, %.3g mm from rest; %llu and %llu passed, %llu below\n",
        name, (unsigned long long)s.steps, (unsigned long long)s.parts,
        (unsigned long long)s.rejected_states, (unsigned long long)s.rejected_stretch,
        (unsigned long long)s.rejected_depth, (unsigned long long)s.rejected_guard,
        (unsigned long long)s.rejected_singular, (unsigned long long)s.clamped,
        (unsigned long long)s.paused, s.time_paused, (unsigned long long)s.recovering,
        (unsigned long long)s.loose_states, 1e6 * s.penetration, (unsigned long long)d.forced,
        (unsigned long long)d.corrections_dropped, c->inverted, d.inverted, d.torn,
        1e3 * c->max_work, 1e3 * c->excess, 1e3 * drain_case_energy(c), drain_case_fastest(c),
        1e3 * drain_case_distance(c), (unsigned long long)c->watch.passed,
        (unsigned long long)c->watch.passed_drain, (unsigned long long)c->watch.below);
}

void drain_case_expect_kept(const drain_case *c, double share)
{
    small_watch_expect_nothing(&c->watch);
    assert_true(c->excess <= share * c->max_work + MIN_GAIN);
}

void drain_case_expect_rest(const drain_case *c, double distance)
{
    assert_int_equal(drain_case_statistics(c).inverted, 0);
    assert_true(drain_case_fastest(c) < 1e-3);
    assert_true(drain_case_distance(c) < distance);
}

void drain_case_finish(drain_case *c, const char *name, double share)
{
    drain_case_report(c, name);
    drain_case_expect_kept(c, share);
    drain_case_end(c);
}
