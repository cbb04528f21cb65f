/* Pulled knots that are cut anywhere, again and again, while hands go on to pull what they hold. Nothing passes
 * through anything in any part of any step, decided exactly; but for the two ends at a cut until they are apart. */
#include "oracle/passing.h"
#include "scene/cut_contacts.h"
#include "scene/api/api.h"
#include "scene/topology/topology.h"

enum { THREADS = 8, CUTS = 7 };

typedef struct cut_watch {
    uint64_t parts, passed, joined;
    double fastest;
} cut_watch;

static uint64_t count(const thread_object *t, uint32_t first, uint32_t nodes,
                      const thread_object *u, uint32_t first_u, uint32_t nodes_u)
{
    const passing_chain both[2] = {{t->now.x + first, t->trial + first, nodes, false},
                                   {u->now.x + first_u, u->trial + first_u, nodes_u, false}};
    return nodes < 2 || nodes_u < 2 ? 0 : passing_count(both, 2, NULL);
}

static bool goes_on_in(const scene_object *s, const scene_body *a, const scene_body *b)
{
    return vbss_scene_is_excluded_across_cut(s, a, a->thread.thread->node_count - 2, b, 0);
}

/* The end of a adjoins the begin of b: as many segments of each as adjoin the other's first. */
static void ask_across(cut_watch *w, const scene_object *s, const scene_body *a,
                       const scene_body *b)
{
    const thread_object *t = a->thread.thread, *u = b->thread.thread;
    uint32_t end = t->node_count - 1, begin = 0;
    while (end > 0 && vbss_scene_is_excluded_across_cut(s, a, end - 1, b, 0)) {
        end--;
    }
    while (begin + 1 < u->node_count &&
           vbss_scene_is_excluded_across_cut(s, a, t->node_count - 2, b, begin)) {
        begin++;
    }
    w->joined++;
    w->passed += count(t, 0, end + 1, u, 0, u->node_count);
    w->passed += count(t, 0, t->node_count, u, begin, u->node_count - begin);
}

static void ask(cut_watch *w, const scene_object *s, const scene_body *a, const scene_body *b)
{
    const thread_object *t = a->thread.thread, *u = b->thread.thread;
    if (goes_on_in(s, a, b)) {
        ask_across(w, s, a, b);
    } else if (goes_on_in(s, b, a)) {
        ask_across(w, s, b, a);
    } else {
        w->passed += count(t, 0, t->node_count, u, 0, u->node_count);
    }
}

static void see(void *watcher, const scene_object *s)
{
    cut_watch *w = watcher;
    w->parts++;
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *a = &s->bodies[i];
        if (a->kind != SCENE_BODY_THREAD) {
            continue;
        }
        const thread_object *t = a->thread.thread;
        const passing_chain alone = {t->now.x, t->trial, t->node_count, false};
        w->passed += passing_count(&alone, 1, NULL);
        for (uint32_t n = 0; n < t->node_count; n++) {
            w->fastest = vbss_max(vec3_norm(t->now.v[n]), w->fastest);
        }
        for (uint32_t k = 0; k < s->body_count; k++) {
            const scene_body *b = &s->bodies[k];
            if (k > i && b->kind == SCENE_BODY_THREAD) {
                ask(w, s, a, b);
            }
        }
    }
}

/* ---- a life */

typedef struct life {
    harness_memory memory;
    vbss_context *context;
    contact_scene scene;
    scene_object *object;
    cut_watch watch;
} life;

static void begin(life *l, harness_source *source)
{
    static const knot_kind kinds[] = {KNOT_OVERHAND, KNOT_DOUBLE_OVERHAND, KNOT_SQUARE};
    contact_scene_options o;
    *l = (life){.context = NULL};
    l->context = harness_context(&l->memory);
    expect_ok(contact_scene_init(&o, CONTACT_SCENE_PULLED));
    o.knot.kind = kinds[harness_draw_below(source, 3)];
    o.knot.length = o.knot.kind == KNOT_SQUARE ? 0.09 : 0.06;
    o.thread.cut_capacity = CUTS;
    o.thread.axial_stiffness = harness_draw_below(source, 2) == 0 ? 427.0 : 4000.0;
    o.pull.force = harness_draw_below(source, 2) == 0 ? 5.0 : 1.0;
    o.scene.thread_capacity = THREADS;
    expect_ok(contact_scene_create(l->context, &o, &l->scene));
    expect_ok(vbss_scene_open(l->scene.scene, &l->object));
    l->object->on_substep = see;
    l->object->on_substep_data = &l->watch;
}

static void cut(life *l, harness_source *source)
{
    scene_object *s = l->object;
    uint32_t piece, threads = 0, bodies[THREADS];
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind == SCENE_BODY_THREAD) {
            bodies[threads++] = s->bodies[i].number;
        }
    }
    uint32_t body = bodies[harness_draw_below(source, threads)];
    double length = cut_length(cut_thread(s, body));
    double arc = harness_draw_real(source, 0.1, 0.9) * length, energy = cut_energy(s);
    expect_ok(vbss_scene_cut_thread(l->scene.scene, body, arc, &piece));
    cut_follow(&l->scene, s, piece);
    cut_expect_sound(s);
    /* A bent segment has its ends on its chord now. */
    assert_true(cut_energy(s) <= 1.05 * energy);
}

static void nothing_passes_when_knots_are_cut(harness_source *source, void *user)
{
    cut_watch *sum = user;
    life l;
    begin(&l, source);
    uint32_t steps = 200 + harness_draw_below(source, 150);
    for (uint32_t i = 0; i < steps; i++) {
        expect_ok(contact_scene_step(&l.scene, 1e-3));
    }
    for (uint32_t k = 0; k < CUTS; k++) {
        cut(&l, source);
        uint32_t more = harness_draw_below(source, 25);
        for (uint32_t i = 0; i < more; i++) {
            expect_ok(contact_scene_step(&l.scene, 1e-3));
            cut_expect_sound(l.object);
        }
    }
    for (uint32_t i = 0; i < 30; i++) {
        expect_ok(contact_scene_step(&l.scene, 1e-3));
    }
    assert_int_equal(l.watch.passed, 0);
    sum->parts += l.watch.parts;
    sum->joined += l.watch.joined;
    sum->fastest = vbss_max(l.watch.fastest, sum->fastest);
    assert_true(l.watch.fastest < 100.0);
    harness_context_end(l.context, &l.memory);
}

static void knot_can_be_cut_anywhere(void **state)
{
    (void)state;
    cut_watch sum = {.parts = 0};
    harness_property("knots that are cut", 30, nothing_passes_when_knots_are_cut, &sum);
    assert_true(sum.joined > 0);
}

int test_cut_knots(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(knot_can_be_cut_anywhere),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
