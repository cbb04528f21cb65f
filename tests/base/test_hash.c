#include <string.h>

#include "harness/harness.h"

static uint64_t hash_of(const void *bytes, size_t count)
{
    vbss_hash hash;
    vbss_hash_begin(&hash);
    vbss_hash_add(&hash, bytes, count);
    return vbss_hash_end(&hash);
}

/* From the xxhsum tool, `printf ... | xxhsum -H64`. */
static void hash_matches_published_function(void **state)
{
    (void)state;
    const struct {
        const char *text;
        uint64_t hash;
    } known[] = {
        {"", 0xef46db3751d8e999u},
        {"a", 0xd24ec4f1a98c6e5bu},
        {"abcd", 0xde0327b0d25d92ccu},
        {"abc", 0x44bc2cf5ad770999u},
        {"message digest", 0x066ed728fceeb3beu},
        {"abcdefghijklmnopqrstuvwxyz", 0xcfe1f278fa89835cu},
        {"0123456789abcdef0123456789abcde", 0x1fdfc63febacfde7u},
        {"0123456789abcdef0123456789abcdef", 0x642a94958e71e6c5u},
        {"The thread is 150 mm long and tied with a double throw, then two single ones.",
         0x994f0225f0eaad01u},
    };
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        assert_true(hash_of(known[i].text, strlen(known[i].text)) == known[i].hash);
    }
}

static void pieces_hash_like_the_whole(harness_source *source, void *user)
{
    (void)user;
    uint8_t bytes[257];
    size_t count = harness_draw_below(source, sizeof bytes + 1);
    for (size_t i = 0; i < count; i++) {
        bytes[i] = (uint8_t)harness_draw_u64(source);
    }
    vbss_hash hash;
    vbss_hash_begin(&hash);
    for (size_t done = 0; done < count;) {
        size_t piece = 1 + harness_draw_below(source, (uint32_t)(count - done));
        vbss_hash_add(&hash, bytes + done, piece);
        done += piece;
    }
    assert_true(vbss_hash_end(&hash) == hash_of(bytes, count));
    assert_true(vbss_hash_end(&hash) == vbss_hash_end(&hash)); /* ending does not change it */
    if (count > 0) {
        uint64_t before = hash_of(bytes, count);
        bytes[harness_draw_below(source, (uint32_t)count)] ^=
            (uint8_t)(1u << harness_draw_below(source, 8));
        assert_true(hash_of(bytes, count) != before);
    }
}

static void empty_input_leaves_hash_unchanged(void **state)
{
    (void)state;
    vbss_hash hash;
    vbss_hash_begin(&hash);
    vbss_hash_add(&hash, "a", 1);
    vbss_hash_add(&hash, NULL, 0);
    assert_true(vbss_hash_end(&hash) == hash_of("a", 1));
}

static void hash_depends_on_bits_not_on_splits(void **state)
{
    (void)state;
    harness_property("pieces hash like the whole", 2000, pieces_hash_like_the_whole, NULL);
}

int test_hash(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(hash_matches_published_function),
        harness_test(empty_input_leaves_hash_unchanged),
        harness_test(hash_depends_on_bits_not_on_splits),
    };
    return cmocka_run_group_tests_name("base.hash", tests, NULL, NULL);
}
