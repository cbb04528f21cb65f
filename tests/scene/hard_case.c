#include "scene/hard_case.h"

#include <math.h>
#include <stdlib.h>
#include <time.h>

#include "collision/closest.h"
#include "fixtures/solver_of.h"
#include "scene/small.h"

/* ---- looking */

vbss_scene_statistics hard_statistics(const hard_case *c)
{
    vbss_scene_statistics s;
    expect_ok(vbss_scene_get_statistics(c->scene.scene, &s, sizeof s));
    return s;
}

static const void *values_of(vbss_thread *thread, vbss_thread_field field)
{
    vbss_view view;
    expect_ok(vbss_thread_get_view(thread, field, &view, sizeof view));
    return view.data;
}

const vec3 *hard_nodes(const hard_case *c, uint32_t thread)
{
    return values_of(c->scene.threads[thread], VBSS_THREAD_VIEW_POSITIONS);
}

knot_type hard_knot(const hard_case *c, uint32_t thread)
{
    knot_type type = {0, 0, 0};
    (void)knot_type_of(hard_nodes(c, thread), c->scene.nodes[thread], &type);
    return type;
}

double hard_fastest(const hard_case *c)
{
    double fastest = 0.0;
    for (uint32_t t = 0; t < c->scene.thread_count; t++) {
        const vec3 *v = values_of(c->scene.threads[t], VBSS_THREAD_VIEW_VELOCITIES);
        for (uint32_t i = 0; i < c->scene.nodes[t]; i++) {
            fastest = vbss_max_or_nan(vec3_norm(v[i]), fastest);
        }
    }
    return fastest;
}

static double energy_of_contacts(const hard_case *c)
{
    double energy = 0.0;
    vbss_view view;
    expect_ok(
        vbss_scene_get_view(c->scene.scene, VBSS_SCENE_VIEW_CONTACT_FORCES, &view, sizeof view));
    for (uint64_t i = 0; i < view.count; i++) {
        energy += vec3_norm_squared(((const vec3 *)view.data)[i]);
    }
    return 0.5 * energy / c->scene.options.scene.contact_stiffness;
}

double hard_energy(const hard_case *c)
{
    double energy = energy_of_contacts(c);
    for (uint32_t t = 0; t < c->scene.thread_count; t++) {
        energy += small_thread_energy(c->scene.threads[t], c->scene.options.thread.axial_stiffness);
    }
    for (uint32_t i = 0; i < c->scene.hand_count; i++) {
        const contact_hand *hand = &c->scene.hands[i];
        if (hand->id != 0 && hand->pull.stiffness > 0.0) {
            const vec3 *x = values_of(hand->thread, VBSS_THREAD_VIEW_POSITIONS);
            vec3 stretch = vec3_sub(hand->at, x[hand->node]);
            energy += 0.5 * hand->pull.stiffness * vec3_norm_squared(stretch);
        }
    }
    return energy;
}

/* ---- overlap, from positions alone */

typedef struct strand {
    const vec3 *x;
    const double *rest;
    double radius;
    uint32_t segments;
} strand;

static double overlap(const vec3 *a, const vec3 *b, double touching)
{
    double at[2];
    for (int k = 0; k < 3; k++) { /* most are far apart */
        const double *p = &a->x + k, *q = &b->x + k;
        if (vbss_min(p[0], p[3]) - vbss_max(q[0], q[3]) > touching ||
            vbss_min(q[0], q[3]) - vbss_max(p[0], p[3]) > touching) {
            return 0.0;
        }
    }
    vec3 apart = closest_between_edges(vec3_sub(a[1], a[0]), vec3_sub(b[1], b[0]),
                                       vec3_sub(b[0], a[0]), &at[0], &at[1]);
    return vbss_max(1.0 - vec3_norm(apart) / touching, 0.0);
}

/* Beyond half a turn of a tube that is bent as far as it goes. */
static double overlap_with_itself(const strand *s)
{
    double largest = 0.0;
    for (uint32_t i = 0; i < s->segments; i++) {
        double arc = 0.0;
        for (uint32_t k = i + 2; k < s->segments; k++) {
            arc += s->rest[k - 1];
            if (arc > 1.6 * 2.0 * s->radius) {
                largest = vbss_max(overlap(s->x + i, s->x + k, 2.0 * s->radius), largest);
            }
        }
    }
    return largest;
}

static double overlap_of(const strand *a, const strand *b)
{
    double largest = 0.0;
    for (uint32_t i = 0; i < a->segments; i++) {
        for (uint32_t k = 0; k < b->segments; k++) {
            largest = vbss_max(overlap(a->x + i, b->x + k, a->radius + b->radius), largest);
        }
    }
    return largest;
}

static double overlap_with_body(const scene_object *s, const scene_body *b, const strand *thread)
{
    double largest = 0.0;
    for (uint32_t k = 0; b->kind == SCENE_BODY_RIGID && k < b->rigid.capsule_count; k++) {
        vec3 axis[2];
        const scene_capsule *capsule = &s->capsules[b->rigid.first_capsule + k];
        vbss_scene_transform_capsule(capsule, b->rigid.body.now.pose, axis);
        strand tool = {axis, NULL, capsule->radius, 1};
        largest = vbss_max(overlap_of(thread, &tool), largest);
    }
    return largest;
}

static double deepest(const hard_case *c)
{
    const scene_object *s = c->watch.scene;
    strand strands[CONTACT_SCENE_THREADS];
    double largest = 0.0;
    for (uint32_t t = 0; t < c->scene.thread_count; t++) {
        vbss_thread *thread = c->scene.threads[t];
        strands[t] = (strand){.x = values_of(thread, VBSS_THREAD_VIEW_POSITIONS),
                              .rest = values_of(thread, VBSS_THREAD_VIEW_REST_LENGTHS),
                              .radius = c->scene.options.thread.radius,
                              .segments = c->scene.nodes[t] - 1};
        largest = vbss_max(overlap_with_itself(&strands[t]), largest);
        for (uint32_t k = 0; k < s->body_count; k++) {
            largest = vbss_max(overlap_with_body(s, &s->bodies[k], &strands[t]), largest);
        }
    }
    if (c->scene.thread_count == 2) {
        largest = vbss_max(overlap_of(&strands[0], &strands[1]), largest);
    }
    return largest;
}

/* ---- running */

void hard_begin(hard_case *c, const char *name, const contact_scene_options *options, double h)
{
    c->name = name;
    c->context = harness_context(&c->memory);
    c->h = h;
    c->steps = 0;
    c->deepest = 0.0;
    c->watch = (watch){0};
    expect_ok(contact_scene_create(c->context, options, &c->scene));
    watch_begin(&c->watch, c->scene.scene);
    c->typed =
        c->scene.thread_count > 0 && knot_type_of(hard_nodes(c, 0), c->scene.nodes[0], &c->type);
}

static double now(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e6 * (double)t.tv_sec + 1e-3 * (double)t.tv_nsec;
}

void hard_run(hard_case *c, uint32_t steps)
{
    for (uint32_t i = 0; i < steps; i++) {
        double begin = now(), watch_cost = c->watch.cost;
        vbss_result result = contact_scene_step(&c->scene, c->h);
        double cost = now() - begin - (c->watch.cost - watch_cost);
        if (result != VBSS_OK) {
            const char *text = "";
            (void)vbss_context_get_last_error(c->context, NULL, &text);
            fail_msg("%s: step %u: %s: %s", c->name, c->steps, vbss_result_name(result), text);
        }
        c->cost[c->steps++ % HARD_CASE_STEPS] = (float)cost;
        c->deepest = vbss_max(deepest(c), c->deepest);
    }
}

bool hard_pull(hard_case *c, uint32_t limit)
{
    for (uint32_t i = 0; i < limit; i++) {
        hard_run(c, 1);
        if (contact_scene_pull_felt(&c->scene) > 0.95 * c->scene.options.pull.force) {
            return true;
        }
    }
    return false;
}

static int by_size(const void *a, const void *b)
{
    float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

void hard_report(hard_case *c)
{
    vbss_scene_statistics s = hard_statistics(c);
    uint32_t count = c->steps < HARD_CASE_STEPS ? c->steps : HARD_CASE_STEPS;
    count = count > 0 ? count : 1;
    static float cost[HARD_CASE_STEPS];
    for (uint32_t i = 0; i < count; i++) {
        cost[i] = c->cost[i];
    }
    qsort(cost, count, sizeof *cost, by_size);
    knot_type type = c->scene.thread_count > 0 ? hard_knot(c, 0) : (knot_type){0, 0, 0};
    print_message(
        "%s: %llu steps, %llu parts, felt %.2g N; rejected %llu states %llu stretch %llu depth "
        "%llu "
        "guard %llu singular; loose %llu states %llu stretch; clamped %llu, recovering %llu; "
        "stretch "
        "error %.1e, overlap %.3f; knot %lld (%lld) to %lld (%lld); %llu pairs, %llu asked, %llu "
        "passed, %llu below, %llu jumps; contacts %u separators %u; us: median %.0f p99 %.0f worst "
        "%.0f\n",
        c->name, (unsigned long long)s.steps, (unsigned long long)s.parts,
        contact_scene_pull_felt(&c->scene), (unsigned long long)s.rejected_states,
        (unsigned long long)s.rejected_stretch, (unsigned long long)s.rejected_depth,
        (unsigned long long)s.rejected_guard, (unsigned long long)s.rejected_singular,
        (unsigned long long)s.loose_states, (unsigned long long)s.loose_stretch,
        (unsigned long long)s.clamped, (unsigned long long)s.recovering, s.stretch_error,
        c->deepest, (long long)c->type.determinant, (long long)c->type.v3,
        (long long)type.determinant, (long long)type.v3, (unsigned long long)c->watch.pairs,
        (unsigned long long)c->watch.asked, (unsigned long long)c->watch.passed,
        (unsigned long long)c->watch.below, (unsigned long long)c->watch.jumps, s.contacts,
        s.separators, (double)cost[count / 2], (double)cost[(uint64_t)count * 99 / 100],
        (double)cost[count - 1]);
}

void hard_end(hard_case *c)
{
    expect_ok(contact_scene_destroy(&c->scene));
    harness_context_end(c->context, &c->memory);
}

/* ---- what must hold */

void hard_expect_kept(hard_case *c)
{
    vbss_scene_statistics s = hard_statistics(c);
    if (watch_faults(&c->watch) > 0) {
        fail_msg("%s: part %llu: %llu pairs passed, %llu below the floor, %llu jumps", c->name,
                 (unsigned long long)c->watch.first, (unsigned long long)c->watch.passed,
                 (unsigned long long)c->watch.below, (unsigned long long)c->watch.jumps);
    }
    assert_int_equal(c->watch.parts, s.parts);
    for (uint32_t t = 0; t < c->scene.thread_count; t++) {
        for (uint32_t i = 0; i < c->scene.nodes[t]; i++) {
            assert_true(vec3_is_finite(hard_nodes(c, t)[i]));
        }
    }
    double stretch = solver_values(&c->scene.options.scene).stretch_tolerance;
    assert_true(s.stretch_error <= stretch || s.loose_stretch > 0 || s.clamped > 0);
    assert_true(s.last_stretch_error <= stretch);
    double allowed = solver_values(&c->scene.options.scene).penetration_tolerance;
    assert_true(c->deepest <= allowed + 1e-6 || s.recovering > 0 || s.clamped > 0);
    assert_true(c->deepest < 0.6);
}

void hard_expect_same_knot(const hard_case *c)
{
    knot_type type = hard_knot(c, 0);
    assert_true(c->typed);
    if (!knot_type_same(type, c->type)) {
        fail_msg("%s: a knot of determinant %lld became one of %lld", c->name,
                 (long long)c->type.determinant, (long long)type.determinant);
    }
}

/* Polygons without friction may go to and fro between two states: neither is more than the other by much. */
enum { FIRST_STEPS = 4 };

void hard_expect_at_rest(hard_case *c, uint32_t steps)
{
    double first = hard_energy(c);
    uint64_t clamped = hard_statistics(c).clamped;
    for (uint32_t i = 0; i < steps; i++) {
        expect_ok(vbss_scene_step(c->scene.scene, c->h)); /* hands and tools rest */
        double energy = hard_energy(c);
        first = i < FIRST_STEPS && energy < 2.0 * first ? vbss_max(energy, first) : first;
        if (!(energy <= 1.01 * first + 1e-9)) {
            fail_msg("%s: at rest, step %u: %g J became %g J", c->name, i, first, energy);
        }
    }
    assert_int_equal(hard_statistics(c).clamped, clamped); /* what rests costs little */
}
