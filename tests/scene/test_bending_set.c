/* Threads that remember their bends, in scenes. */
#include "scene/small.h"

#include <stdlib.h>

static const double yield = 90.0, hardening = 0.2, shaft = 2.5e-3;

static void choose_thread(small *s)
{
    s->thread.radius = 0.125e-3;
    s->thread.yield_curvature = yield;
    s->thread.yield_hardening = hardening;
    s->thread.drag = 20.0;
}

/* Half round a shaft of 2.5 mm, drawn by its ends. */
static uint32_t wind(small *s, vbss_thread **thread, uint32_t ends[2])
{
    const double top = shaft + 0.125e-3 + 1e-6;
    uint32_t body =
        small_thread(s, vec3_make(-0.02, top, 0.0), vec3_make(0.02, top, 0.0), 100, thread);
    small_capsule(s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, 0.0, -0.02), vec3_make(0.0, 0.0, 0.02),
                  shaft);
    for (uint32_t k = 0; k < 2; k++) {
        vbss_thread_attachment a;
        expect_ok(vbss_thread_attachment_init(&a, sizeof a));
        a.kind = VBSS_THREAD_ATTACHMENT_FORCE;
        a.node = k == 0 ? 0 : 100;
        a.force[1] = -0.05;
        expect_ok(vbss_thread_attach(*thread, &a, &ends[k]));
        a.kind = VBSS_THREAD_ATTACHMENT_MASS;
        a.mass = 1e-4;
        uint32_t id;
        expect_ok(vbss_thread_attach(*thread, &a, &id));
    }
    return body;
}

static double norm_at(vbss_thread *thread, vbss_thread_field field, uint32_t node)
{
    vbss_view view;
    double v[3];
    expect_ok(vbss_thread_get_view(thread, field, &view, sizeof view));
    memcpy(v, (const char *)view.data + (size_t)node * view.stride_bytes, sizeof v);
    return vec3_norm(vec3_load(v));
}

/* Let go, it springs back to (1 - hardening) (k - yield), with k of the shaft. */
static void wound_thread_springs_back_to_set(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    uint32_t ends[2];
    small_begin_scene(&s);
    choose_thread(&s);
    (void)wind(&s, &thread, ends);
    small_steps(&s, 400, 1e-3);
    const double curvature = 1.0 / (shaft + 0.125e-3),
                 kept = (1.0 - hardening) * (curvature - yield);
    double bent = 0.0, plastic = 0.0, free_bend = 0.0;
    for (uint32_t i = 46; i <= 54; i++) {
        bent += norm_at(thread, VBSS_THREAD_VIEW_CURVATURES, i) / 9.0;
        plastic += norm_at(thread, VBSS_THREAD_VIEW_PLASTIC_CURVATURES, i) / 9.0;
    }
    expect_near(curvature, bent, 0.02 * curvature);
    expect_near(kept, plastic, 0.04 * kept);
    const double nothing[3] = {0.0, 0.0, 0.0};
    for (uint32_t k = 0; k < 2; k++) {
        expect_ok(vbss_thread_set_attachment_target(thread, ends[k], nothing, NULL));
    }
    small_steps(&s, 1000, 1e-3);
    for (uint32_t i = 46; i <= 54; i++) {
        free_bend += norm_at(thread, VBSS_THREAD_VIEW_CURVATURES, i) / 9.0;
    }
    expect_near(kept, free_bend, 0.06 * kept);
    vbss_thread_energies e;
    expect_ok(vbss_thread_get_energies(thread, &e, sizeof e));
    assert_true(e.dissipated > 0.0);
    small_end(&s);
}

/* A scene that is loaded from its bytes, or restored, goes on with the same bits. */
static void scene_with_bent_thread_continues_with_same_bits(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    uint32_t ends[2];
    small_begin_scene(&s);
    choose_thread(&s);
    s.thread.relaxation_ratio = 0.5;
    s.thread.relaxation_time = 0.1;
    (void)wind(&s, &thread, ends);
    small_steps(&s, 100, 1e-3);
    small_state saved = small_save(&s);
    small_steps(&s, 50, 1e-3);
    const uint64_t wanted = small_hash(&s);
    expect_ok(vbss_scene_restore(s.scene, saved.bytes, saved.count));
    small_steps(&s, 50, 1e-3);
    assert_true(wanted == small_hash(&s));
    vbss_scene *loaded = NULL;
    expect_ok(vbss_scene_load(s.context, saved.bytes, saved.count, &loaded));
    for (uint32_t k = 0; k < 50; k++) {
        expect_ok(vbss_scene_step(loaded, 1e-3));
    }
    uint64_t hash = 0;
    expect_ok(vbss_scene_get_hash(loaded, &hash));
    assert_true(wanted == hash);
    expect_ok(vbss_scene_destroy(loaded));
    free(saved.bytes);
    small_end(&s);
}

/* A thread alone in a scene bends as it does without a scene. */
static void bend_in_scene_is_that_of_thread_alone(void **state)
{
    (void)state;
    double plastic[2];
    for (int k = 0; k < 2; k++) {
        small s;
        vbss_thread *thread = NULL;
        small_begin_scene(&s);
        choose_thread(&s);
        if (k == 0) {
            small_thread(&s, vec3_zero(), vec3_make(0.03, 0.0, 0.0), 30, &thread);
        } else {
            s.thread.segment_count = 30;
            s.thread.length = 0.03;
            expect_ok(vbss_thread_create(s.context, &s.thread, &thread));
        }
        vbss_thread_attachment a;
        uint32_t id;
        expect_ok(vbss_thread_attachment_init(&a, sizeof a));
        a.kind = VBSS_THREAD_ATTACHMENT_CLAMP;
        expect_ok(vbss_thread_attach(thread, &a, &id));
        a.kind = VBSS_THREAD_ATTACHMENT_FORCE;
        a.node = 30;
        a.force[1] = 8e-5;
        expect_ok(vbss_thread_attach(thread, &a, &id));
        for (int i = 0; i < 300; i++) {
            expect_ok(k == 0 ? vbss_scene_step(s.scene, 1e-3) : vbss_thread_step(thread, 1e-3));
        }
        plastic[k] = norm_at(thread, VBSS_THREAD_VIEW_PLASTIC_CURVATURES, 0);
        small_end(&s);
    }
    assert_true(plastic[1] > 10.0);
    expect_near(plastic[1], plastic[0], 1e-3 * plastic[1]);
}

/* ---- descriptions of earlier versions */

/* Bytes of a field in a description: a number, or a word. */
enum { NUMBER_BYTES = 16, WORD_BYTES = 12 };

/* Reads the description of `config` without its last bytes, as an older version had it. */
static vbss_thread_config read_without(const vbss_thread_config *config,
                                       vbss_baseline_config *baseline, uint8_t version,
                                       size_t removed)
{
    const size_t section_end = 8;
    vbss_thread_config read;
    uint8_t bytes[4096];
    vbss_stream stream;
    vbss_thread_config copy = *config;
    memset(&read, 0, sizeof read);
    vbss_stream_begin_write(&stream, bytes, sizeof bytes);
    vbss_thread_visit_config(&stream, &copy, baseline);
    expect_ok(stream.result);
    size_t count = stream.position;
    assert_int_equal(4, bytes[2]);
    bytes[2] = version;
    memmove(bytes + count - section_end - removed, bytes + count - section_end, section_end);
    vbss_baseline_config read_baseline;
    memset(&read_baseline, 0, sizeof read_baseline);
    vbss_stream_begin_read(&stream, bytes, count - removed);
    vbss_thread_visit_config(&stream, &read, &read_baseline);
    expect_ok(stream.result);
    return read;
}

static void descriptions_of_older_versions_have_no_memory_and_no_twist(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    vbss_thread_config config;
    vbss_baseline_config baseline;
    s.thread.length = 0.1;
    s.thread.yield_curvature = 300.0;
    expect_ok(vbss_thread_read_config(s.context, &s.thread, &config, &baseline));
    config.torsional_stiffness = 1e-8;
    config.friction_torque = 1;
    const vbss_thread_config first =
        read_without(&config, &baseline, 1, 6 * NUMBER_BYTES + WORD_BYTES);
    const vbss_thread_config second =
        read_without(&config, &baseline, 2, 2 * NUMBER_BYTES + WORD_BYTES);
    const vbss_thread_config third = read_without(&config, &baseline, 3, WORD_BYTES);
    assert_int_equal(config.segment_count, first.segment_count);
    expect_near(config.finest_length, first.finest_length, 0.0);
    expect_near(0.0, first.yield_curvature, 0.0);
    expect_near(0.0, first.relaxation_ratio, 0.0);
    expect_near(1.0, first.relaxation_time, 0.0);
    expect_near(300.0, second.yield_curvature, 0.0);
    expect_near(0.0, second.torsional_stiffness, 0.0);
    expect_near(0.0, second.rest_twist, 0.0);
    expect_near(1e-8, third.torsional_stiffness, 0.0);
    assert_int_equal(0, third.friction_torque);
    small_end(&s);
}

int test_bending_set(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(wound_thread_springs_back_to_set),
        cmocka_unit_test(scene_with_bent_thread_continues_with_same_bits),
        cmocka_unit_test(bend_in_scene_is_that_of_thread_alone),
        cmocka_unit_test(descriptions_of_older_versions_have_no_memory_and_no_twist),
    };
    return cmocka_run_group_tests_name("scene.bending_set", tests, NULL, NULL);
}
