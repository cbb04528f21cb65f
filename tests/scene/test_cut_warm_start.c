/* What contacts remember when a thread is cut: all of it, under the numbers of where it lies. */
#include "scene/cut_contacts.h"

static remembered_list before, after;

typedef struct stage {
    harness_memory memory;
    vbss_context *context;
    contact_scene scene;
    scene_object *object;
    vbss_random random;
} stage;

static void begin(stage *g, contact_scene_kind kind, knot_kind knot, bool cylinder, uint32_t steps)
{
    contact_scene_options o;
    g->context = harness_context(&g->memory);
    expect_ok(contact_scene_init(&o, kind));
    o.knot.kind = knot;
    o.knot.cylinder = cylinder;
    o.knot.length = kind == CONTACT_SCENE_DROPPED ? 0.08 : 0.1;
    o.thread.cut_capacity = 7;
    o.scene.thread_capacity = 16;
    expect_ok(contact_scene_create(g->context, &o, &g->scene));
    expect_ok(vbss_scene_open(g->scene.scene, &g->object));
    vbss_random_seed(&g->random, 1, 7);
    for (uint32_t i = 0; i < steps || g->object->contacts->warm_start_count < 4; i++) {
        expect_ok(contact_scene_step(&g->scene, 1e-3));
        assert_true(i < 2000);
    }
}

/* A segment that is in contact, or any arc. */
static uint32_t cut_somewhere(stage *g, bool in_contact)
{
    scene_object *s = g->object;
    uint32_t body = 0, piece = 0;
    double arc = 0.0;
    while (body == 0) {
        uint32_t place = vbss_random_below(&g->random, s->body_count);
        body = s->bodies[place].kind == SCENE_BODY_THREAD ? s->bodies[place].number : 0;
    }
    double share = vbss_random_uniform(&g->random);
    uint32_t drawn = vbss_random_below(&g->random, 1u << 30);
    if (in_contact) {
        const contact_key *key =
            &s->contacts->warm_start[drawn % s->contacts->warm_start_count].key;
        body = key->body_a;
        const thread_object *t = cut_thread(s, body);
        for (uint32_t k = 0; k < key->feature_a; k++) {
            arc += t->rest[k];
        }
        arc += key->feature_a + 1 < t->node_count ? share * t->rest[key->feature_a] : 0.0;
    } else {
        arc = share * cut_length(cut_thread(s, body));
    }
    vbss_result result = vbss_scene_cut_thread(g->scene.scene, body, arc, &piece);
    if (result == VBSS_ERROR_OUT_OF_RANGE) {
        return 0;
    }
    expect_ok(result);
    return piece;
}

static uint32_t cut_often(stage *g, uint32_t cuts, uint32_t steps)
{
    uint32_t turned = 0;
    for (uint32_t done = 0, refused = 0; done < cuts;) {
        cut_remember(g->object, &before);
        if (before.count == 0) { /* all has come apart */
            assert_true(steps > 0 && done > 0);
            return turned;
        }
        uint32_t piece = cut_somewhere(g, done % 2 == 0 && refused < 20);
        if (piece == 0) { /* what touches may be pieces too short to cut */
            refused++;
            assert_true(refused < 1000);
            continue;
        }
        refused = 0;
        done++;
        cut_remember(g->object, &after);
        cut_expect_sound(g->object);
        turned += cut_expect_same(&before, &after);
        cut_follow(&g->scene, g->object, piece);
        for (uint32_t i = 0; i < steps; i++) {
            expect_ok(contact_scene_step(&g->scene, 1e-3));
        }
    }
    return turned;
}

static void warm_start_survives_cut(void **state)
{
    (void)state;
    static const struct {
        contact_scene_kind kind;
        knot_kind knot;
        bool cylinder;
        uint32_t steps;
    } cases[] = {{CONTACT_SCENE_PULLED, KNOT_OVERHAND, false, 290},
                 {CONTACT_SCENE_PULLED, KNOT_SQUARE, true, 250},
                 {CONTACT_SCENE_INTERLOCKED, KNOT_OVERHAND, false, 200},
                 {CONTACT_SCENE_DROPPED, KNOT_OVERHAND, false, 120}};
    uint32_t turned = 0;
    for (int k = 0; k < 4; k++) {
        for (int at_once = 0; at_once < 2; at_once++) {
            stage g;
            begin(&g, cases[k].kind, cases[k].knot, cases[k].cylinder, cases[k].steps);
            turned += cut_often(&g, 7, at_once != 0 ? 0 : 1);
            harness_context_end(g.context, &g.memory);
        }
    }
    assert_true(turned > 0); /* pieces of pieces */
}

/* The first step after it finds them again: a rope round a post goes on to hold. */
static void distant_cut_does_not_disturb_resting_thread(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    small_begin_scene(&s);
    s.thread.cut_capacity = 1;
    s.thread.gravity[1] = -9.81;
    s.thread.drag = 1e-3;
    uint32_t body =
        small_thread(&s, vec3_make(0.0, 1.13e-3, 0.0), vec3_make(0.06, 1.13e-3, 0.0), 60, &thread);
    small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.01, 0.0, 0.0), vec3_make(0.0, 0.0, 5e-3),
                1e-3);
    small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.02, 0.0, 0.0), vec3_make(0.0, 0.0, 5e-3),
                1e-3);
    small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.05, 0.0, 0.0), vec3_make(0.0, 0.0, 5e-3),
                1e-3);
    (void)small_pin(&s, body, 0, 0);
    (void)small_pin(&s, body, 60, 0);
    small_steps(&s, 400, 1e-3);
    vec3 rested = small_node(thread, 5);
    (void)cut_at(&s, body, 0.035, NULL);
    small_steps(&s, 1, 1e-3);
    vbss_scene_event event;
    assert_int_equal(small_events(&s, VBSS_SCENE_EVENT_TOUCH, &event),
                     1); /* the piece and its tool */
    assert_int_equal(small_events(&s, VBSS_SCENE_EVENT_PART, &event), 1);
    small_steps(&s, 100, 1e-3);
    assert_true(vec3_distance(rested, small_node(thread, 5)) < 2e-5);
    small_end(&s);
}

int test_cut_warm_start(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(warm_start_survives_cut),
        cmocka_unit_test(distant_cut_does_not_disturb_resting_thread),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
