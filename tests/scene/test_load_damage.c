/* Damaged snapshots are refused with a status when a scene is loaded from them. */
#include <stdlib.h>
#include <string.h>

#include "base/hash.h"
#include "base/little_endian.h"
#include "fixtures/needle_scenes.h"
#include "scene/small.h"

enum { HEADER_BYTES = 24, CHECKSUM_BYTES = 8 };

typedef struct subject {
    harness_memory memory;
    vbss_context *context;
    uint8_t *saved, *damaged;
    size_t count, description; /* where the description begins */
} subject;

static void begin(subject *s)
{
    vbss_scene *scene;
    uint64_t count = 0;
    s->context = harness_context(&s->memory);
    expect_ok(needle_scene_create(s->context, &scene));
    expect_result(VBSS_ERROR_CAPACITY, vbss_scene_save(scene, NULL, 0, &count));
    s->count = (size_t)count;
    s->saved = malloc(s->count);
    s->damaged = malloc(s->count);
    assert_non_null(s->saved);
    assert_non_null(s->damaged);
    expect_ok(vbss_scene_save(scene, s->saved, count, &count));
    s->description = HEADER_BYTES + (size_t)load_little_endian(s->saved + 8, 8);
}

static void end(subject *s)
{
    free(s->saved);
    free(s->damaged);
    harness_context_end(s->context, &s->memory);
}

static void seal(uint8_t *bytes, size_t count)
{
    vbss_hash hash;
    vbss_hash_begin(&hash);
    vbss_hash_add(&hash, bytes, count - CHECKSUM_BYTES);
    store_little_endian(bytes + count - CHECKSUM_BYTES, vbss_hash_end(&hash), CHECKSUM_BYTES);
}

static vbss_result load(const subject *s, const uint8_t *bytes, size_t count)
{
    vbss_scene *scene;
    vbss_result result = vbss_scene_load(s->context, bytes, count, &scene);
    if (result == VBSS_OK) {
        expect_ok(vbss_scene_destroy(scene));
    } else {
        assert_null(scene);
    }
    return result;
}

static void truncated_snapshot_is_refused(void **state)
{
    (void)state;
    subject s;
    begin(&s);
    for (size_t n = 0; n < s.count; n += 1 + n / 64) {
        expect_result(VBSS_ERROR_TRUNCATED, load(&s, s.saved, n));
    }
    expect_ok(load(&s, s.saved, s.count));
    end(&s);
}

static void changed_byte_is_refused(void **state)
{
    (void)state;
    subject s;
    begin(&s);
    for (size_t i = 0; i < s.count; i += 1 + i / 64) {
        memcpy(s.damaged, s.saved, s.count);
        s.damaged[i] ^= 0x10;
        assert_int_not_equal(VBSS_OK, load(&s, s.damaged, s.count));
    }
    end(&s);
}

/* With a right checksum, so that the reader of the description sees the bytes. */
static void sealed_damage_of_the_description_gives_a_status(void **state)
{
    (void)state;
    subject s;
    begin(&s);
    static const uint8_t masks[] = {0x01, 0x80, 0xff};
    for (size_t i = s.description; i < s.count - CHECKSUM_BYTES; i++) {
        memcpy(s.damaged, s.saved, s.count);
        s.damaged[i] ^= masks[i % sizeof masks];
        seal(s.damaged, s.count);
        const vbss_result result = load(&s, s.damaged, s.count);
        assert_true(result == VBSS_OK || result == VBSS_ERROR_CORRUPT ||
                    result == VBSS_ERROR_DATA_VERSION || result == VBSS_ERROR_CAPACITY);
    }
    end(&s);
}

static void snapshot_without_description_is_refused(void **state)
{
    (void)state;
    subject s;
    begin(&s);
    const size_t cut = s.description + CHECKSUM_BYTES;
    memcpy(s.damaged, s.saved, s.description);
    store_little_endian(s.damaged + 16, 0, 8);
    seal(s.damaged, cut);
    expect_result(VBSS_ERROR_DATA_VERSION, load(&s, s.damaged, cut));
    end(&s);
}

/* As libraries before 1.0 saved it. */
static void snapshot_of_format_1_restores(void **state)
{
    (void)state;
    subject s;
    begin(&s);
    vbss_scene *scene;
    uint64_t before = 0, after = 0;
    const size_t state_bytes = s.description - HEADER_BYTES;
    const size_t count = 16 + state_bytes + CHECKSUM_BYTES;
    memcpy(s.damaged, s.saved, 16);
    store_little_endian(s.damaged + 4, 1, 4);
    memcpy(s.damaged + 16, s.saved + HEADER_BYTES, state_bytes);
    seal(s.damaged, count);
    expect_ok(vbss_scene_load(s.context, s.saved, s.count, &scene));
    expect_ok(vbss_scene_get_hash(scene, &before));
    expect_ok(needle_scene_step(scene));
    expect_ok(vbss_scene_restore(scene, s.damaged, count));
    expect_ok(vbss_scene_get_hash(scene, &after));
    assert_int_equal(before, after);
    expect_result(VBSS_ERROR_DATA_VERSION, load(&s, s.damaged, count));
    end(&s);
}

int test_load_damage(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(truncated_snapshot_is_refused),
        harness_test(changed_byte_is_refused),
        harness_test(sealed_damage_of_the_description_gives_a_status),
        harness_test(snapshot_without_description_is_refused),
        harness_test(snapshot_of_format_1_restores),
    };
    return cmocka_run_group_tests_name("scene.load_damage", tests, NULL, NULL);
}
