/* What a search that was stopped has led to is taken only if nobody gains by it what nothing has done. */
#include "scene/solve/solve.h"
#include "scene/step/step.h"
#include "scene/world/world.h"
#include "scene/stitch_case.h"

static stitch_case c;
static const scene_substep part = {.step_length = 1e-3, .end_fraction = 1.0, .h = 1e-3};

/* A stitch at rest as its own trial state, with the forces of the law. */
static scene_object *begin(uint32_t crossings)
{
    stitch_case_open(&c, crossings);
    stitch_case_wait(&c, 20);
    scene_object *s = small_object(&c.s);
    for (uint32_t i = 0; i < s->body_count; i++) {
        thread_object *t = s->bodies[i].thread.thread;
        if (s->bodies[i].kind == SCENE_BODY_THREAD) {
            memcpy(t->trial, t->now.x, t->node_count * sizeof *t->trial);
            memcpy(t->trial_tension, t->now.tension,
                   (t->node_count - 1) * sizeof *t->trial_tension);
        }
    }
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        contact_constraint *row = &s->contacts->constraints[i];
        row->relative_displacement = vec3_zero();
        s->contacts->current[i].force = vbss_contact_force(row, vec3_zero());
    }
    s->contacts->is_stopped_early = true;
    assert_true(vbss_scene_passes_energy_check(s, &part));
    return s;
}

static uint32_t row_in_hole(const scene_object *s)
{
    uint32_t i = 0;
    while (i < s->contacts->count && !s->contacts->constraints[i].is_sleeve) {
        i++;
    }
    assert_true(i < s->contacts->count);
    return i;
}

/* What is in the hole has slid by 0.1 mm, with so much more force along its direction than the law says. */
static void slide_in_hole(scene_object *s, double more)
{
    const uint32_t i = row_in_hole(s);
    contact_constraint *row = &s->contacts->constraints[i];
    row->relative_displacement = vec3_scale(row->normal, 0.1e-3);
    const vec3 law = vbss_contact_force(row, vec3_zero());
    s->contacts->current[i].force = vec3_add_scaled(law, more, row->normal);
}

/* A hand does twice the work in a step of twice the length. */
static void energy_tolerance_grows_with_step(void **state)
{
    (void)state;
    scene_object *s = begin(0);
    const scene_substep half = {.step_length = 2e-3, .end_fraction = 0.5, .h = 1e-3};
    slide_in_hole(s, 0.3); /* 30 uJ */
    assert_false(vbss_scene_passes_energy_check(s, &part));
    assert_true(vbss_scene_passes_energy_check(s, &half));
    slide_in_hole(s, 0.6); /* 60 uJ */
    assert_false(vbss_scene_passes_energy_check(s, &half));
    stitch_case_end(&c);
}

static void hole_dissipation_above_friction_law_is_counted(void **state)
{
    (void)state;
    scene_object *s = begin(0);
    slide_in_hole(s, 0.1); /* 10 uJ */
    assert_true(vbss_scene_passes_energy_check(s, &part));
    slide_in_hole(s, 0.3); /* 30 uJ */
    assert_false(vbss_scene_passes_energy_check(s, &part));
    slide_in_hole(s, -0.3);
    assert_true(vbss_scene_passes_energy_check(s, &part));
    stitch_case_end(&c);
}

/* The wall about it is displaced by that along the force on it; the law has nothing against that. */
static bool accepts_a_hole(scene_object *s, double force, double displacement)
{
    drain_object *d;
    const uint32_t i = row_in_hole(s);
    contact_constraint *row = &s->contacts->constraints[i];
    const uint32_t *node = NULL;
    expect_ok(vbss_drain_open(c.stitch.drain, &d));
    node = d->mesh.triangles[s->holes[row->key.feature_a].triangle];
    memcpy(d->trial, d->x, d->mesh.node_count * sizeof *d->trial);
    for (int k = 0; k < 3; k++) {
        d->trial[node[k]] = vec3_add_scaled(d->x[node[k]], -displacement, row->normal);
    }
    s->contacts->current[i].force = vec3_scale(row->normal, force);
    return vbss_scene_passes_energy_check(s, &part);
}

/* 0.8 N store 16 uJ. */
static void hole_energy_balance(void **state)
{
    (void)state;
    scene_object *s = begin(0);
    assert_true(accepts_a_hole(s, 0.8, 0.0));
    assert_false(accepts_a_hole(s, 0.8, 10e-6 / 0.8));
    assert_true(accepts_a_hole(s, 0.8, 2e-6 / 0.8));
    assert_false(accepts_a_hole(s, 1.2, 0.0));
    stitch_case_end(&c);
}

/* What one takes out does not make up for what another puts in. */
static void energy_losses_do_not_offset_gains(void **state)
{
    (void)state;
    scene_object *s = begin(0);
    uint32_t first = row_in_hole(s), second = first + 1;
    while (second < s->contacts->count && !s->contacts->constraints[second].is_sleeve) {
        second++;
    }
    assert_true(second < s->contacts->count);
    for (int k = 0; k < 2; k++) {
        uint32_t i = k == 0 ? first : second;
        contact_constraint *row = &s->contacts->constraints[i];
        row->relative_displacement = vec3_scale(row->normal, 0.1e-3);
        s->contacts->current[i].force =
            vec3_add_scaled(vbss_contact_force(row, vec3_zero()), k == 0 ? 0.3 : -1.0, row->normal);
    }
    assert_false(vbss_scene_passes_energy_check(s, &part));
    stitch_case_end(&c);
}

/* 50 uJ in the last segment: of which the hand that holds its end has done 35, or none. */
static void thread_energy_gain_needs_external_work(void **state)
{
    (void)state;
    scene_object *s = begin(0);
    thread_object *t = vbss_scene_body(s, c.stitch.thread_body)->thread.thread;
    const uint32_t last = t->node_count - 1;
    assert_true(c.hands[1].thread != NULL); /* it holds the last node */
    const double stretched = 0.5 * t->rest[last - 1] / t->config.axial_stiffness;
    double before = t->now.tension[last - 1], after = sqrt(before * before + 50e-6 / stretched);
    t->trial_tension[last - 1] = after;
    assert_false(vbss_scene_passes_energy_check(s, &part));
    t->trial[last] = vec3_add(t->trial[last], vec3_make(0.0, 0.0, 35e-6 / after)); /* by the hand */
    assert_true(vbss_scene_passes_energy_check(s, &part));
    stitch_case_end(&c);
}

/* A node pressed in until its drain has gained that much, J; how far that is, m. */
static double press_in(drain_object *d, uint32_t node, double gain)
{
    double depth = 0.0;
    const vec3 in = vec3_unit_or(vec3_make(0.0, -d->x[node].y, -d->x[node].z), vec3_zero());
    memcpy(d->trial, d->x, d->mesh.node_count * sizeof *d->trial);
    while (vbss_drain_energy_change(d, part.h) < gain) {
        depth += 1e-6;
        d->trial[node] = vec3_add_scaled(d->x[node], depth, in);
    }
    return depth;
}

static uint32_t free_node(const scene_object *s, const drain_object *d)
{
    uint32_t node = 0;
    while (d->anchored[node] || vec3_norm(d->contact_forces[node]) > 0.0) {
        node++;
    }
    assert_true(node < d->mesh.node_count && s->contacts->count > 0);
    return node;
}

static void drain_energy_gain_needs_external_work(void **state)
{
    (void)state;
    scene_object *s = begin(0);
    drain_object *d;
    vbss_drain_attachment a;
    uint32_t id;
    expect_ok(vbss_drain_open(c.stitch.drain, &d));
    const uint32_t node = free_node(s, d);
    (void)press_in(d, node, 15e-6);
    assert_true(vbss_scene_passes_energy_check(s, &part));
    double depth = press_in(d, node, 40e-6);
    assert_false(vbss_scene_passes_energy_check(s, &part));
    expect_ok(vbss_drain_attachment_init(&a, sizeof a));
    a.kind = VBSS_DRAIN_ATTACHMENT_FORCE;
    a.node = node;
    a.force[1] = 30e-6 / depth;
    expect_ok(vbss_drain_attach(c.stitch.drain, &a, &id));
    assert_true(vbss_scene_passes_energy_check(s, &part));
    stitch_case_end(&c);
}

/* What gives a little more than it may is gone on with, and what gives three times as much is not; where nothing was stopped, or the part is the
 * smallest, there is nothing else. */
static void hopeless_energy_error_is_abandoned_at_once(void **state)
{
    (void)state;
    scene_object *s = begin(0);
    const scene_substep smallest = {
        .step_length = 1e-3, .end_fraction = 1.0, .h = 1e-3, .is_min_size = true};
    slide_in_hole(s, 0.5); /* 50 uJ */
    assert_false(vbss_scene_passes_energy_check(s, &part));
    assert_true(vbss_scene_may_pass_energy_check(s, &part));
    slide_in_hole(s, 0.7); /* 70 uJ */
    assert_false(vbss_scene_may_pass_energy_check(s, &part));
    assert_true(vbss_scene_may_pass_energy_check(s, &smallest));
    s->contacts->is_stopped_early = false;
    assert_true(vbss_scene_may_pass_energy_check(s, &part));
    stitch_case_end(&c);
}

/* ---- what is shown of it */

/* Of a contact in the view, N; -1: it is not there. */
static double force_shown(const contact_key *key)
{
    vbss_view names = small_view(&c.s, VBSS_SCENE_VIEW_CONTACTS);
    vbss_view forces = small_view(&c.s, VBSS_SCENE_VIEW_CONTACT_FORCES);
    for (uint64_t i = 0; i < names.count; i++) {
        const uint32_t *n = (const uint32_t *)names.data + 5 * i;
        const contact_key shown = {n[0], n[1], n[2], n[3], n[4]};
        if (vbss_contact_compare_keys(&shown, key) == 0) {
            return vec3_norm(((const vec3 *)forces.data)[i]);
        }
    }
    return -1.0;
}

/* The law may say 10 N of where such a search stands, when what touches has felt 0.2 or nothing. */
static void reported_forces_match_solved_forces(void **state)
{
    (void)state;
    scene_object *s = begin(1);
    uint32_t i = 0;
    while (i < s->contacts->count && s->contacts->constraints[i].is_bilateral) {
        i++;
    }
    assert_true(i < s->contacts->count);
    contact_constraint *row = &s->contacts->constraints[i];
    row->solution = (contact_solution){.status = CONTACT_STICK, .normal_force = 10.0};
    s->contacts->is_stopped_early = false;
    vbss_scene_collect_forces(s);
    expect_near(10.0, force_shown(&row->key), 1e-12);
    s->contacts->is_stopped_early = true;
    s->contacts->current[i].force = vec3_scale(row->normal, 0.2);
    vbss_scene_collect_forces(s);
    expect_near(0.2, force_shown(&row->key), 1e-12);
    s->contacts->current[i].force = vec3_zero();
    vbss_scene_collect_forces(s);
    expect_near(-1.0, force_shown(&row->key), 0.0);
    stitch_case_end(&c);
}

int test_energy_check(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hole_dissipation_above_friction_law_is_counted),
        cmocka_unit_test(energy_tolerance_grows_with_step),
        cmocka_unit_test(hole_energy_balance),
        cmocka_unit_test(energy_losses_do_not_offset_gains),
        cmocka_unit_test(thread_energy_gain_needs_external_work),
        cmocka_unit_test(drain_energy_gain_needs_external_work),
        cmocka_unit_test(hopeless_energy_error_is_abandoned_at_once),
        cmocka_unit_test(reported_forces_match_solved_forces),
    };
    return cmocka_run_group_tests_name("scene.energy_check", tests, NULL, NULL);
}
