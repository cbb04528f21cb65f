/* Views after a restore, whose a snapshot is, and the hash of a scene; other snapshots: contract.scene and contract.scene_runs. */
#include <stdlib.h>

#include "scene/small.h"
#include "fixtures/scene_body.h"

static scene_scene_kind kinds[] = {SCENE_SCENE_KNOT, SCENE_SCENE_TOOLS};

/* What hosts see comes back too, and what has happened does not happen again. */
static void expect_alike(const small *x, const small *y)
{
    const scene_object *a = small_object(x), *b = small_object(y);
    for (uint32_t i = 0; i < a->body_count; i++) {
        if (a->bodies[i].kind == SCENE_BODY_RIGID) {
            vbss_scene_rigid_state p = small_rigid(x, a->bodies[i].number);
            vbss_scene_rigid_state q = small_rigid(y, b->bodies[i].number);
            assert_memory_equal(&p, &q, sizeof p);
        }
    }
    vbss_scene_statistics p = small_statistics(x), q = small_statistics(y);
    q.patterns = p.patterns; /* what is still known of the last one is nobody's state */
    assert_memory_equal(&p, &q, sizeof p);
}

static void expect_events_alike(const small *x, const small *y)
{
    const step_events a = step_events_of(x->scene), b = step_events_of(y->scene);
    assert_int_equal(a.count, b.count);
    if (a.count > 0) {
        assert_memory_equal(a.of, b.of, a.count * sizeof a.of[0]);
    }
}

static void views_are_restored(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        small s, other;
        small_begin(&s);
        small_begin(&other);
        expect_ok(scene_scene_create(s.context, kinds[k], &s.scene));
        expect_ok(scene_scene_create(other.context, kinds[k], &other.scene));
        for (int i = 0; i < 30; i++) {
            expect_ok(scene_scene_step(s.scene, kinds[k]));
        }
        small_state kept = small_save(&s);
        expect_ok(vbss_scene_restore(other.scene, kept.bytes, kept.count));
        expect_alike(&s, &other);
        for (int i = 0; i < 20; i++) {
            expect_ok(scene_scene_step(s.scene, kinds[k]));
            expect_ok(scene_scene_step(other.scene, kinds[k]));
            expect_alike(&s, &other);
            expect_events_alike(&s, &other);
        }
        free(kept.bytes);
        small_end(&other);
        small_end(&s);
    }
}

/* ---- what a state belongs to */

static void make_pair(small *s, uint32_t segments, double radius)
{
    small_thread(s, vec3_zero(), vec3_make(0.01, 0.0, 0.0), segments, NULL);
    small_capsule(s, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.0, 0.01, 0.0),
                  vec3_make(0.01, 0.01, 0.0), radius);
}

/* Of other bodies; of another configuration: contract.scene. */
static void snapshot_of_other_scene_is_rejected(void **state)
{
    (void)state;
    small s;
    small_begin_scene(&s);
    make_pair(&s, 5, 1e-3);
    small_state kept = small_save(&s);
    const uint64_t first = small_hash(&s);
    for (int k = 0; k < 5; k++) {
        small_create(&s);
        make_pair(&s, k == 1 ? 6 : 5, k == 2 ? 1.1e-3 : 1e-3);
        if (k == 3) { /* one more, one less */
            small_capsule(&s, VBSS_SCENE_RIGID_FREE, vec3_zero(), vec3_zero(), 1e-3);
        } else if (k == 4) {
            expect_ok(vbss_scene_remove(s.scene, 2));
        }
        uint64_t hash = small_hash(&s);
        assert_true((hash == first) == (k == 0));
        vbss_result result = vbss_scene_restore(s.scene, kept.bytes, kept.count);
        assert_true((result == VBSS_OK) == (k == 0));
        assert_true(small_hash(&s) == hash);
        small_steps(&s, 1, 1e-3);
        expect_ok(vbss_scene_destroy(s.scene));
    }
    free(kept.bytes);
    small_end(&s);
}

/* ---- hashes */

static uint32_t note(uint64_t seen[], uint32_t count, const small *s)
{
    uint64_t hash = small_hash(s);
    for (uint32_t i = 0; i < count; i++) {
        assert_true(seen[i] != hash);
    }
    assert_true(hash == small_hash(s)); /* looking changes nothing */
    seen[count] = hash;
    return count + 1;
}

static void hash_covers_all_state(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    uint64_t seen[64];
    uint32_t count = 0, pins[2];
    const double turned[4] = {1.0, 1e-9, 0.0, 0.0}, place[3] = {0.0, 0.01, 0.0};
    small_begin_scene(&s);
    count = note(seen, count, &s);
    uint32_t line = small_thread(&s, vec3_zero(), vec3_make(0.01, 0.0, 0.0), 5, &thread);
    count = note(seen, count, &s);
    vec3 here = vec3_make(0.0, 0.01, 0.0);
    uint32_t tool =
        small_stick(&s, VBSS_SCENE_RIGID_COUPLED, here, vec3_make(1e-3, 0.0, 0.0), 1e-3);
    count = note(seen, count, &s);
    s.rigid.friction *= 1.001;
    small_stick(&s, VBSS_SCENE_RIGID_FREE, vec3_make(0.0, 0.05, 0.0), vec3_make(1e-3, 0.0, 0.0),
                1e-3);
    count = note(seen, count, &s);
    small_move(&s, tool, vec3_make(1e-9, 0.01, 0.0));
    count = note(seen, count, &s);
    expect_ok(vbss_scene_set_rigid_target(s.scene, tool, place, turned));
    count = note(seen, count, &s);
    pins[0] = small_pin(&s, line, 0, tool);
    count = note(seen, count, &s);
    pins[1] = small_pin(&s, line, 5, 0);
    count = note(seen, count, &s);
    small_steps(&s, 1, 1e-3);
    count = note(seen, count, &s);
    for (int k = 0; k < 2; k++) {
        expect_ok(vbss_scene_unpin_thread(s.scene, pins[k]));
        count = note(seen, count, &s);
    }
    double v[18] = {0.0};
    for (int i = 0; i < 18; i++) {
        v[i] = 1e-9;
        expect_ok(vbss_thread_set_state(thread, NULL, v, 6));
        count = note(seen, count, &s);
    }
    expect_ok(vbss_scene_remove(s.scene, line));
    (void)note(seen, count, &s);
    small_end(&s);
}

int test_scene_state(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(views_are_restored),
        cmocka_unit_test(snapshot_of_other_scene_is_rejected),
        cmocka_unit_test(hash_covers_all_state),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
