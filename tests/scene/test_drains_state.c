/* Scenes with a drain: views after a restore, whose a snapshot is, and the hash. */
#include <stdlib.h>

#include "scene/drains_rig.h"

/* ---- what hosts see */

static void expect_views_alike(const small *x, const small *y)
{
    for (vbss_scene_field field = 0; field <= VBSS_SCENE_VIEW_CONTACT_GAPS; field++) {
        vbss_view a = small_view(x, field), b = small_view(y, field);
        assert_int_equal(a.count, b.count);
        if (a.count > 0) {
            assert_memory_equal(a.data, b.data, a.count * a.stride_bytes);
        }
    }
}

static void expect_drains_alike(vbss_drain *x, vbss_drain *y)
{
    for (vbss_drain_field field = 0; field <= VBSS_DRAIN_VIEW_CURVATURES; field++) {
        vbss_view a, b;
        expect_ok(vbss_drain_get_view(x, field, &a, sizeof a));
        expect_ok(vbss_drain_get_view(y, field, &b, sizeof b));
        assert_int_equal(a.count, b.count);
        assert_memory_equal(a.data, b.data, a.count * a.stride_bytes);
    }
    vbss_drain_statistics p, q;
    expect_ok(vbss_drain_get_statistics(x, &p, sizeof p));
    expect_ok(vbss_drain_get_statistics(y, &q, sizeof q));
    assert_memory_equal(&p, &q, sizeof p);
}

static void views_are_restored(void **state)
{
    (void)state;
    small s, other;
    drain_hands one, two;
    expect_ok(drain_hands_init(&one));
    two = one;
    (void)drains_rig_begin(&s, &one);
    (void)drains_rig_begin(&other, &two);
    drains_rig_steps(&s, 140);
    small_state kept = small_save(&s);
    expect_ok(vbss_scene_restore(other.scene, kept.bytes, kept.count));
    expect_drains_alike(one.drain, two.drain);
    for (int i = 0; i < 20; i++) {
        drains_rig_steps(&s, 1);
        drains_rig_steps(&other, 1);
        expect_drains_alike(one.drain, two.drain);
        expect_views_alike(&s, &other);
    }
    free(kept.bytes);
    small_end(&other);
    small_end(&s);
}

/* ---- what a state belongs to */

static void snapshot_of_other_drain_is_rejected(void **state)
{
    enum { DIFFERENT = 9 };
    (void)state;
    small s;
    small_begin_scene(&s);
    small_drain(&s, NULL);
    small_steps(&s, 3, 1e-3);
    small_state kept = small_save(&s);
    const vbss_drain_config config = s.drain;
    const uint64_t first = small_hash(&s);
    for (int k = 0; k <= DIFFERENT; k++) {
        s.drain = config;
        s.drain.friction *= k == 1 ? 1.001 : 1.0;
        s.drain.mesh = k == 2 ? VBSS_DRAIN_MESH_159 : config.mesh;
        s.drain.thickness *= k == 3 ? 1.001 : 1.0;
        s.drain.young_modulus *= k == 4 ? 1.001 : 1.0;
        s.drain.position[2] += k == 5 ? 1e-6 : 0.0;
        s.drain.attachment_capacity += k == 6;
        s.drain.mesh_divisions = k == 7 ? 2 : 1;
        small_create(&s);
        uint32_t body = k == 8 ? 0 : small_drain(&s, NULL);
        if (k == 9) {
            expect_ok(vbss_scene_remove(s.scene, body));
        }
        uint64_t hash = small_hash(&s);
        vbss_result result = vbss_scene_restore(s.scene, kept.bytes, kept.count);
        if (k == 0) { /* made alike */
            expect_ok(result);
            assert_true(small_hash(&s) == first);
        } else {
            assert_true(result < 0);
            assert_true(small_hash(&s) == hash);
        }
        small_steps(&s, 2, 1e-3);
        expect_ok(vbss_scene_destroy(s.scene));
    }
    free(kept.bytes);
    small_end(&s);
}

static void hash_covers_drain(void **state)
{
    (void)state;
    small s;
    vbss_drain *drain;
    vbss_drain_places places;
    vbss_drain_attachment a;
    uint64_t seen[8];
    uint32_t id, count = 0;
    small_begin_scene(&s);
    seen[count++] = small_hash(&s);
    uint32_t body = small_drain(&s, &drain);
    seen[count++] = small_hash(&s);
    expect_ok(vbss_drain_get_places(drain, &places, sizeof places));
    expect_ok(vbss_drain_attachment_init(&a, sizeof a));
    a.kind = VBSS_DRAIN_ATTACHMENT_FORCE;
    a.node = places.marks[0];
    a.force[1] = 1e-9;
    expect_ok(vbss_drain_attach(drain, &a, &id));
    seen[count++] = small_hash(&s);
    small_steps(&s, 1, 1e-3);
    seen[count++] = small_hash(&s);
    expect_ok(vbss_drain_detach(drain, id));
    seen[count++] = small_hash(&s);
    expect_ok(vbss_scene_remove(s.scene, body));
    seen[count++] = small_hash(&s);
    for (uint32_t i = 0; i < count; i++) {
        for (uint32_t k = 0; k < i; k++) {
            assert_true(seen[i] != seen[k]);
        }
    }
    small_end(&s);
}

int test_drains_state(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(views_are_restored),
        cmocka_unit_test(snapshot_of_other_drain_is_rejected),
        cmocka_unit_test(hash_covers_drain),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
