/* The two copies of the hot loops give the same bits: docs/explanation/solver.md. */
#include "harness/harness.h"
#include "fixtures/thread_scenes.h"
#include "thread/thread.h"

static void use(vbss_thread *handle, bool wide)
{
    thread_object *t = NULL;
    if (handle != NULL) {
        expect_ok(vbss_thread_edit(handle, &t));
        t->system->wide = wide;
    }
}

static void dispatch_follows_cpu_features(void **state)
{
    (void)state;
    bool wanted = false;
#if defined(__GNUC__) && defined(__x86_64__)
    wanted = __builtin_cpu_supports("avx2") != 0;
#endif
    assert_int_equal(wanted, vbss_wide_is_available());
    vbss_context *context;
    vbss_thread_config config;
    vbss_thread *handle;
    thread_object *t;
    expect_ok(vbss_context_create(NULL, &context));
    expect_ok(vbss_thread_config_init(&config, sizeof config));
    expect_ok(vbss_thread_create(context, &config, &handle));
    expect_ok(vbss_thread_open(handle, &t));
    assert_int_equal(wanted, t->system->wide);
    expect_ok(vbss_context_destroy(context));
}

/* Where there is no wide copy, the plain one goes twice: the scenes repeat. */
static void scalar_and_simd_bits_are_equal(void **state)
{
    (void)state;
    for (int bending = 0; bending < 2; bending++) {
        for (int kind = THREAD_SCENE_RELEASE; kind <= THREAD_SCENE_CUT; kind++) {
            thread_scene scenes[2];
            vbss_context *contexts[2];
            for (int wide = 0; wide < 2; wide++) {
                vbss_thread_config config;
                expect_ok(vbss_context_create(NULL, &contexts[wide]));
                expect_ok(thread_scene_config((thread_scene_kind)kind, &config));
                config.bending = bending;
                expect_ok(thread_scene_create(contexts[wide], (thread_scene_kind)kind, &config,
                                              &scenes[wide]));
            }
            for (int step = 0; step < 200; step++) {
                uint64_t hashes[2];
                for (int wide = 0; wide < 2; wide++) {
                    use(scenes[wide].thread, wide != 0 && vbss_wide_is_available());
                    use(scenes[wide].piece, wide != 0 && vbss_wide_is_available());
                    expect_ok(thread_scene_step(&scenes[wide], 1e-3));
                    expect_ok(thread_scene_hash(&scenes[wide], &hashes[wide]));
                }
                assert_true(hashes[0] == hashes[1]);
            }
            expect_ok(vbss_context_destroy(contexts[0]));
            expect_ok(vbss_context_destroy(contexts[1]));
        }
    }
}

int test_simd(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dispatch_follows_cpu_features),
        cmocka_unit_test(scalar_and_simd_bits_are_equal),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
