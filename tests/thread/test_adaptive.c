/* A mesh that adapts itself: what a node that comes or goes keeps, exactly or within a stated bound. */
#include <math.h>
#include <string.h>

#include "thread/remesh.h"
#include "thread/rig.h"

#define FREE 1e-3 /* more room than any change takes */

static thread_object *inside(const rig *r)
{
    thread_object *t = NULL;
    expect_ok(vbss_thread_open(r->thread, &t));
    return t;
}

static vbss_thread_config adaptive(double length, uint32_t segments)
{
    vbss_thread_config c = rig_config(length, segments);
    c.mesh = VBSS_THREAD_MESH_ADAPTIVE;
    c.mesh_operations = 0; /* only what the test does */
    return c;
}

static double length_of(const thread_object *t)
{
    return vbss_thread_arc_length(t, t->node_count - 1);
}

static double mass_of(const thread_object *t)
{
    double sum = 0.0;
    for (uint32_t i = 0; i < t->node_count; i++) {
        sum += t->mass[i];
    }
    return sum;
}

static vec3 unit_x(void)
{
    return vec3_make(1.0, 0.0, 0.0);
}

/* Held at both ends, the far one brought near: bends in one plane. Settled if it has drag. */
static void bend(rig *r, const vbss_thread_config *config, double near, uint32_t relax_steps)
{
    rig_begin(r, config);
    (void)rig_clamp_here(r, 0, unit_x());
    uint32_t id = rig_pin_here(r, r->nodes - 1);
    vec3 far = rig_tip(r);
    for (uint32_t i = 1; i <= 300; i++) {
        rig_move(r, id, vec3_make(far.x + (near - far.x) * i / 300.0, 0.0, 0.0));
        rig_run(r, 1e-3, 1);
    }
    rig_run(r, 1e-3, relax_steps);
}

/* ---- kept exactly */

static void random_change(harness_source *source, thread_object *t, bool divide)
{
    uint32_t at = 3 + harness_draw_below(source, t->node_count - 7);
    if (divide && t->node_count < t->node_capacity) {
        bool free = harness_draw_below(source, 4) > 0;
        vbss_thread_split_segment(t, at, free ? FREE : 0.0);
    } else {
        (void)vbss_thread_remove_node(t, at, FREE);
    }
}

static void changes_keep_sums(harness_source *source, void *user)
{
    (void)user;
    rig r;
    vec3 x[25], v[25];
    vbss_thread_config c = adaptive(0.024, 24);
    c.bending = (vbss_thread_bending)harness_draw_below(source, 2);
    c.node_capacity = 60;
    rig_begin(&r, &c);
    thread_object *t = inside(&r);
    for (uint32_t i = 0; i < 25; i++) {
        vec3 aside = harness_draw_vec3(source, -2e-4, 2e-4);
        x[i] = vec3_add(vec3_make(1e-3 * i, 1e-2, 0.0), aside);
        v[i] = harness_draw_vec3(source, -1.0, 1.0);
    }
    rig_place(&r, x, v);
    for (int k = 0; k < 40; k++) {
        bool divide = t->node_count < 12 || harness_draw_below(source, 2) == 0;
        expect_ok(vbss_thread_prepare_query(t));
        double mass = mass_of(t), length = length_of(t);
        vbss_thread_momentum p = rig_momentum(&r), q;
        random_change(source, t, divide);
        q = rig_momentum(&r);
        expect_near(length, length_of(t), 1e-17);
        expect_near(mass, mass_of(t), 1e-20);
        expect_near_vec3(vec3_load(p.linear), vec3_load(q.linear), 1e-13 * mass);
        for (uint32_t i = 0; i + 1 < t->node_count; i++) {
            assert_true(t->rest[i] > 0.0 && isfinite(t->now.tension[i]));
        }
    }
    rig_end(&r);
}

static void mesh_changes_conserve_length_mass_and_momentum(void **state)
{
    (void)state;
    harness_property("changes of a mesh", 60, changes_keep_sums, NULL);
}

static void undone_split_is_identity(void **state)
{
    (void)state;
    rig r;
    vbss_thread_config c = adaptive(0.15, 60);
    c.drag = 20.0;
    bend(&r, &c, 0.06, 1500);
    uint32_t id = rig_pin_here(&r, 40);
    thread_object *t = inside(&r);
    rig_run(&r, 1e-3, 5);
    double rest[60];
    vec3 x[61];
    memcpy(rest, t->rest, sizeof rest);
    memcpy(x, t->now.x, sizeof x);
    vbss_thread_split_segment(t, 20, FREE);
    assert_int_equal(t->node_count, 62);
    expect_same_bits(0.5 * rest[20], t->rest[20]);
    expect_same_bits(0.5 * rest[20], t->rest[21]);
    expect_same_bits(rest[21], t->rest[22]);
    expect_same_bits(x[41].x, t->now.x[42].x);
    vbss_thread_reaction reaction;
    expect_ok(vbss_thread_get_reaction(r.thread, id, &reaction, sizeof reaction));
    assert_int_equal(reaction.node, 41);
    assert_true(vbss_thread_remove_node(t, 21, FREE));
    assert_int_equal(t->node_count, 61);
    assert_memory_equal(rest, t->rest, sizeof rest);
    for (uint32_t i = 0; i < 61; i++) {
        expect_near_vec3(x[i], t->now.x[i], 2e-8);
    }
    expect_ok(vbss_thread_get_reaction(r.thread, id, &reaction, sizeof reaction));
    assert_int_equal(reaction.node, 40);
    rig_end(&r);
}

/* ---- kept nearly */

typedef struct jump {
    double bending, stretching,
        tension;    /* energies as shares of the segment's own bending energy; N */
    double angular; /* relative */
} jump;

static double tension_error(thread_object *t)
{
    double worst = 0.0;
    expect_ok(vbss_thread_prepare_query(t));
    vbss_thread_compute_strains(t, t->now.x, t->strains);
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        double pull = t->config.axial_stiffness * t->strains[i].elongation / t->rest[i];
        worst = fmax(worst, fabs(pull - t->now.tension[i]));
    }
    return worst;
}

static jump jump_of(rig *r, uint32_t segment, bool divide, double room)
{
    thread_object *t = inside(r);
    uint64_t size;
    static uint8_t bytes[65536];
    expect_ok(vbss_thread_save(r->thread, bytes, sizeof bytes, &size));
    expect_ok(vbss_thread_prepare_query(t));
    double k = vbss_thread_node_curvature(t, segment + 1);
    double own = 0.5 * t->config.bending_stiffness * k * k * t->rest[segment];
    vbss_thread_energies before = rig_energies(r), after;
    vbss_thread_momentum p = rig_momentum(r), q;
    if (divide) {
        vbss_thread_split_segment(t, segment, room);
    } else {
        assert_true(vbss_thread_remove_node(t, segment + 1, room));
    }
    after = rig_energies(r);
    q = rig_momentum(r);
    double turned = vec3_distance(vec3_load(p.angular), vec3_load(q.angular));
    jump j = {fabs(after.bending - before.bending) / own,
              fabs(after.stretching - before.stretching) / own, tension_error(t),
              turned / vec3_norm(vec3_load(p.angular))};
    expect_ok(vbss_thread_restore(r->thread, bytes, size));
    return j;
}

/* At rest and under way, in both discretisations: a segment that turns by 0.1 to 0.2 rad. */
static void mesh_change_keeps_energy_and_tension(void **state)
{
    (void)state;
    static const jump bounds[2][2] = {
        /* SPLINE, LOCAL: of a node that goes, that comes */
        {{8e-3, 1e-4, 1e-3, 1e-6}, {2e-3, 1e-4, 2e-4, 1e-6}},
        {{3e-2, 2e-3, 4e-3, 1e-6}, {1e-2, 2e-3, 4e-3, 1e-6}},
    };
    for (int bending = 0; bending < 2; bending++) {
        for (int divide = 0; divide < 2; divide++) {
            rig r;
            vbss_thread_config c = adaptive(0.15, 75);
            c.bending = bending;
            c.drag = 5.0;
            bend(&r, &c, 0.04, 20);
            const jump *b = &bounds[bending][divide];
            for (uint32_t segment = 32; segment < 44; segment += 2) {
                jump j = jump_of(&r, segment, divide == 1, FREE);
                expect_near(0.0, j.bending, b->bending);
                expect_near(0.0, j.stretching, b->stretching);
                expect_near(0.0, j.tension, b->tension);
                expect_near(0.0, j.angular, b->angular);
            }
            rig_end(&r);
        }
    }
}

/* Why nodes are laid on the arc, and settled: on the chord a segment's bending energy nearly doubles, and with
 * lengths of arcs its tension goes by a tenth of a newton. */
static void chord_split_keeps_shape_and_raises_energy(void **state)
{
    (void)state;
    rig r;
    vbss_thread_config c = adaptive(0.15, 75);
    c.drag = 5.0;
    bend(&r, &c, 0.04, 20);
    thread_object *t = inside(&r);
    jump j = jump_of(&r, 38, true, 0.0);
    assert_true(j.bending > 0.5 && j.tension > 0.1);
    vec3 x[76];
    memcpy(x, t->now.x, sizeof x);
    vbss_thread_split_segment(t, 38, 0.0);
    assert_int_equal(t->statistics.laid_on_chord, 1);
    expect_near_vec3(vec3_lerp(x[38], x[39], 0.5), t->now.x[39], 1e-18);
    assert_memory_equal(x, t->now.x, 39 * sizeof *x);
    assert_memory_equal(x + 39, t->now.x + 40, 37 * sizeof *x);
    /* A node that has no room stays. */
    assert_false(vbss_thread_remove_node(t, 20, 1e-9));
    assert_int_equal(t->node_count, 77);
    rig_end(&r);
}

/* ---- in motion */

/* As a scene would make it: lengths of neighbours differ by the ratio at most. */
static void graded_change(harness_source *source, thread_object *t, bool divide)
{
    uint32_t at = 3 + harness_draw_below(source, t->node_count - 7);
    if (divide) {
        at = vbss_thread_first_segment_to_split(t, at);
        if (at >= 3 && at + 4 < t->node_count && t->rest[at] > 0.6e-3) {
            vbss_thread_split_segment(t, at, FREE);
        }
    } else if (vbss_thread_can_coarsen(t, at)) {
        assert_true(vbss_thread_remove_node(t, at, FREE));
    }
}

/* A pendulum of a bent thread, without drag: energy after a while, per energy that it swings with. */
static double energy_left(bool change, uint32_t every)
{
    rig r;
    vbss_thread_config c = adaptive(0.1, 50);
    c.node_capacity = 120;
    c.coarsest_length = 4e-3;
    c.spectral_radius = 0.5;
    rig_begin(&r, &c);
    (void)rig_pin_here(&r, 0);
    harness_source source = {.random = {0}};
    vbss_random_seed(&source.random, 7, 1);
    thread_object *t = inside(&r);
    vbss_thread_energies begin = rig_energies(&r);
    for (uint32_t i = 0; i < 400; i++) {
        rig_run(&r, 1e-3, 1);
        if (change && i % every == 0) {
            graded_change(&source, t, t->node_count < 70 && harness_draw_below(&source, 2) == 0);
        }
    }
    vbss_thread_energies end = rig_energies(&r);
    double swing = end.kinetic;
    rig_end(&r);
    return (end.total - begin.total) / fmax(swing, 1e-9);
}

static void adaptive_pendulum_conserves_energy(void **state)
{
    (void)state;
    double fixed = energy_left(false, 1);
    expect_near(fixed, energy_left(true, 5), 2e-3);
    expect_near(fixed, energy_left(true, 1), 2e-3);
}

/* ---- by itself */

static void mesh_refines_at_bends_and_coarsens_elsewhere(void **state)
{
    (void)state;
    rig r;
    vbss_thread_config c = adaptive(0.15, 150);
    c.mesh_operations = 4;
    c.drag = 20.0;
    c.refine_angle = 0.1;
    bend(&r, &c, 0.03, 2000);
    thread_object *t = inside(&r);
    expect_ok(vbss_thread_prepare_query(t));
    assert_true(t->statistics.refined > 0 && t->statistics.coarsened > 20);
    assert_int_equal(t->statistics.refused_capacity, 0);
    for (uint32_t i = 4; i + 5 < t->node_count; i++) {
        bool bent = vbss_thread_node_curvature(t, i) * t->rest[i] > 1.1 * c.refine_angle;
        assert_true(!bent || t->rest[i] <= c.finest_length);
        double ratio = t->rest[i] / t->rest[i - 1];
        assert_true(ratio <= REMESH_MAX_LENGTH_RATIO && ratio >= 1.0 / REMESH_MAX_LENGTH_RATIO);
        assert_true(t->rest[i] <= c.coarsest_length);
    }
    expect_near(0.15, length_of(t), 1e-15);
    /* It has come to rest: nothing flickers. */
    uint64_t made = t->statistics.refined + t->statistics.coarsened;
    rig_run(&r, 1e-3, 300);
    assert_int_equal(t->statistics.refined + t->statistics.coarsened, made);
    vbss_thread_statistics s = rig_statistics(&r);
    assert_int_equal(s.nodes, t->node_count);
    rig_end(&r);
}

static void rejected_refinements_are_counted(void **state)
{
    (void)state;
    rig r;
    vbss_thread_config c = adaptive(0.15, 40);
    c.mesh_operations = 64;
    c.node_capacity = 44;
    c.drag = 20.0;
    c.refine_angle = 0.05;
    c.coarsen_angle = 0.0;
    bend(&r, &c, 0.03, 300);
    vbss_thread_statistics s = rig_statistics(&r);
    assert_int_equal(s.nodes, 44);
    assert_int_equal(s.most_nodes, 44);
    assert_int_equal(s.refined, 3);
    assert_true(s.refused_capacity > 10);
    rig_end(&r);
}

static void no_change_beside_held_nodes(void **state)
{
    (void)state;
    rig r;
    vbss_thread_config c = adaptive(0.15, 75);
    c.mesh_operations = 8;
    c.drag = 20.0;
    c.refine_angle = 0.02;
    c.coarsen_angle = 0.0;
    c.attachment_capacity = 8;
    rig_begin(&r, &c);
    thread_object *t = inside(&r);
    (void)rig_clamp_here(&r, 0, unit_x());
    (void)rig_mass(&r, 20, 1e-6);
    (void)rig_spring(&r, 30, vec3_make(0.06, 0.0, 0.0), 1.0, 1e-3);
    (void)rig_force(&r, 40, vec3_make(0.0, 1e-5, 0.0));
    (void)rig_pin_here(&r, 50);
    rig_run(&r, 1e-3, 500);
    assert_true(t->statistics.refined > 30 && t->statistics.refused_held > 0);
    for (uint32_t k = 0; k < c.attachment_capacity; k++) {
        const thread_attachment *a = &t->attachments[k];
        if (a->id != 0) {
            uint32_t low = a->node > 1 ? a->node - 2 : 0;
            for (uint32_t i = low; i < a->node + 2; i++) {
                expect_near(2e-3, t->rest[i], 1e-15);
            }
            double arc = vbss_thread_arc_length(t, a->node);
            static const double at[] = {0.0, 0.04, 0.06, 0.08, 0.1};
            expect_near(at[k], arc, 1e-15);
        }
    }
    rig_end(&r);
}

static void segment_sagitta_is_reported(void **state)
{
    (void)state;
    rig r;
    vec3 x[33];
    vbss_thread_config c = rig_config(0.032, 32);
    rig_begin(&r, &c);
    for (uint32_t i = 0; i < 33; i++) {
        x[i] = vec3_make(0.02 * cos(0.05 * i), 0.02 * sin(0.05 * i), 0.0);
    }
    rig_place(&r, x, NULL);
    vbss_view v;
    expect_ok(vbss_thread_get_view(r.thread, VBSS_THREAD_VIEW_SAGITTAS, &v, sizeof v));
    assert_int_equal(v.count, 32);
    for (uint32_t i = 1; i < 31; i++) {
        expect_near(0.125 * 1e-6 / 0.02, ((const double *)v.data)[i], 2e-9);
    }
    vbss_thread_statistics s = rig_statistics(&r);
    assert_int_equal(s.nodes, 33);
    assert_int_equal(s.most_nodes, 0);
    expect_near(0.125 * 1e-6 / 0.02, s.sagitta, 2e-9);
    rig_end(&r);
}

int test_adaptive(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mesh_changes_conserve_length_mass_and_momentum),
        cmocka_unit_test(undone_split_is_identity),
        cmocka_unit_test(mesh_change_keeps_energy_and_tension),
        cmocka_unit_test(chord_split_keeps_shape_and_raises_energy),
        cmocka_unit_test(adaptive_pendulum_conserves_energy),
        cmocka_unit_test(mesh_refines_at_bends_and_coarsens_elsewhere),
        cmocka_unit_test(rejected_refinements_are_counted),
        cmocka_unit_test(no_change_beside_held_nodes),
        cmocka_unit_test(segment_sagitta_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
