/* What collision objects refuse, and that they stay as they are. */
#include <math.h>
#include <string.h>

#include "base/little_endian.h"
#include "collision/shapes_model.h"
#include "collision/shapes_object.h"

/* ---- configurations */

static vbss_result create_with(vbss_context *context, size_t offset, const void *value, size_t size)
{
    vbss_collision_config config;
    vbss_collision *collision = NULL;
    expect_ok(vbss_collision_config_init(&config, sizeof config));
    memcpy((char *)&config + offset, value, size);
    vbss_result result = vbss_collision_create(context, &config, &collision);
    assert_true((collision != NULL) == (result == VBSS_OK));
    expect_ok(vbss_collision_destroy(collision));
    return result;
}

static vbss_result create_with_number(vbss_context *context, size_t offset, double value)
{
    return create_with(context, offset, &value, sizeof value);
}

static vbss_result create_with_choice(vbss_context *context, size_t offset, uint32_t value)
{
    return create_with(context, offset, &value, sizeof value);
}

static void bad_config_is_rejected(void **state)
{
    (void)state;
    static const struct {
        size_t offset;
        double low, high;
    } numbers[] = {
        {offsetof(vbss_collision_config, thickness), 1e-30, 1e30},
        {offsetof(vbss_collision_config, thickness), 0.0, 1.0},
        {offsetof(vbss_collision_config, tolerance), 1e-12, 1.0},
        {offsetof(vbss_collision_config, exclusion), 0.0, 1e3},
        {offsetof(vbss_collision_config, margin), 0.0, 1e3},
    };
    static const struct {
        size_t offset;
        uint32_t low, high, above;
    } choices[] = {
        {offsetof(vbss_collision_config, method), 0, 2, 3},
        {offsetof(vbss_collision_config, method), 0, 2, UINT32_MAX},
        {offsetof(vbss_collision_config, pass_limit), 1, 10000, UINT32_MAX},
        {offsetof(vbss_collision_config, shape_capacity), 0, 65536, 65537},
        {offsetof(vbss_collision_config, pair_capacity), 0, 1000, 100000001},
        {offsetof(vbss_collision_config, impact_capacity), 0, 1000, UINT32_MAX},
    };
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        size_t at = numbers[i].offset;
        for (int k = 0; k < 3; k++) {
            expect_result(VBSS_ERROR_NOT_FINITE,
                          create_with_number(context, at, harness_bad_numbers[k]));
        }
        expect_ok(create_with_number(context, at, numbers[i].low));
        expect_ok(create_with_number(context, at, numbers[i].high));
        expect_result(VBSS_ERROR_OUT_OF_RANGE,
                      create_with_number(context, at, -1e-3 * numbers[i].high));
        if (numbers[i].low > 0.0) {
            expect_result(VBSS_ERROR_OUT_OF_RANGE,
                          create_with_number(context, at, 0.999 * numbers[i].low));
            expect_result(VBSS_ERROR_OUT_OF_RANGE,
                          create_with_number(context, at, 1.001 * numbers[i].high));
        }
    }
    for (size_t i = 0; i < sizeof choices / sizeof choices[0]; i++) {
        size_t at = choices[i].offset;
        expect_ok(create_with_choice(context, at, choices[i].low));
        expect_ok(create_with_choice(context, at, choices[i].high));
        expect_result(VBSS_ERROR_OUT_OF_RANGE, create_with_choice(context, at, choices[i].above));
    }
    harness_context_end(context, &memory);
}

/* ---- shapes */

/* The object as it was, its list and its memory too. */
static void unchanged(object_fixture *f, vbss_result wanted, vbss_result got, uint64_t hash)
{
    const char *text;
    expect_result(wanted, got);
    expect_ok(vbss_context_get_last_error(f->context, NULL, &text));
    assert_true(strlen(text) > 0);
    assert_true(object_hash(f->collision) == hash);
    assert_true(shapes_view(f->collision, VBSS_COLLISION_VIEW_CANDIDATES).count > 0);
}

static void bad_shapes_are_rejected(void **state)
{
    (void)state;
    object_fixture f;
    uint32_t name = 55;
    double rest[5] = {1.0, 1.0, 1.0, 1.0, 1.0};
    const double bad_radii[] = {-1e-3, -0.0 - 1e-300, 1e-31, 1.01e29, 1e300};
    const uint32_t good[] = {0, 1, 2}, outside[] = {0, 1, 2, 1, 3, 4}, twice[] = {0, 1, 0};
    object_begin(&f);
    vbss_collision *c = f.collision;
    const uint64_t hash = object_hash(c), blocks = f.memory.blocks;
    for (int i = 0; i < 8; i++) {
        double radius = i < 5 ? bad_radii[i] : harness_bad_numbers[i - 5];
        vbss_result wanted = i < 5 ? VBSS_ERROR_OUT_OF_RANGE : VBSS_ERROR_NOT_FINITE;
        unchanged(&f, wanted, vbss_collision_add_chain(c, 6, rest, radius, &name), hash);
        unchanged(&f, wanted, vbss_collision_add_capsules(c, 6, radius, &name), hash);
        unchanged(&f, wanted, vbss_collision_add_mesh(c, 3, good, 1, radius, &name), hash);
    }
    const uint32_t chain_nodes[] = {0, 1, 65538, UINT32_MAX};
    const uint32_t capsules[] = {0, 32769, 0x80000000u, UINT32_MAX};
    const uint32_t mesh_nodes[] = {0, 2, 65537, UINT32_MAX}, counts[] = {0, 131073, UINT32_MAX};
    const vbss_result range = VBSS_ERROR_OUT_OF_RANGE;
    for (int i = 0; i < 4; i++) {
        unchanged(&f, range, vbss_collision_add_chain(c, chain_nodes[i], NULL, 0.1, &name), hash);
        unchanged(&f, range, vbss_collision_add_capsules(c, capsules[i], 0.1, &name), hash);
        unchanged(&f, range, vbss_collision_add_mesh(c, mesh_nodes[i], good, 1, 0.1, &name), hash);
        unchanged(&f, range, vbss_collision_add_mesh(c, 3, good, counts[i % 3], 0.1, &name), hash);
    }
    for (int i = 0; i < 5; i++) {
        double kept = rest[i];
        rest[i] = i == 0 ? -1e-9 : 1.1e30;
        unchanged(&f, range, vbss_collision_add_chain(c, 6, rest, 0.1, &name), hash);
        rest[i] = harness_bad_numbers[i % 3];
        unchanged(&f, VBSS_ERROR_NOT_FINITE, vbss_collision_add_chain(c, 6, rest, 0.1, &name),
                  hash);
        rest[i] = kept;
    }
    unchanged(&f, range, vbss_collision_add_mesh(c, 4, outside, 2, 0.1, &name), hash);
    unchanged(&f, range, vbss_collision_add_mesh(c, 4, twice, 1, 0.1, &name), hash);
    const vbss_result null = VBSS_ERROR_NULL_ARGUMENT;
    unchanged(&f, null, vbss_collision_add_mesh(c, 4, NULL, 1, 0.1, &name), hash);
    unchanged(&f, null, vbss_collision_add_mesh(c, 4, good, 1, 0.1, NULL), hash);
    unchanged(&f, null, vbss_collision_add_chain(c, 4, NULL, 0.1, NULL), hash);
    unchanged(&f, null, vbss_collision_add_capsules(c, 4, 0.1, NULL), hash);
    assert_int_equal(name, 55);
    assert_int_equal(f.memory.blocks, blocks);
    /* The borders are good; a radius of zero is, too. */
    expect_ok(vbss_collision_add_chain(c, 2, rest, 0.0, &name));
    expect_ok(vbss_collision_add_capsules(c, 32768, 1e29, &name));
    expect_ok(vbss_collision_add_mesh(c, 65536, good, 1, 1e-30, &name));
    object_end(&f);
}

static void bad_moves_are_rejected(void **state)
{
    (void)state;
    object_fixture f;
    double x[18] = {0.0};
    object_begin(&f);
    vbss_collision *c = f.collision;
    const uint64_t hash = object_hash(c);
    for (int i = 0; i < 18; i++) {
        for (int k = 0; k < 5; k++) {
            double good[18] = {0.0};
            vbss_result wanted = k < 3 ? VBSS_ERROR_NOT_FINITE : VBSS_ERROR_OUT_OF_RANGE;
            x[i] = k < 3 ? harness_bad_numbers[k] : k == 3 ? 1.01e30 : -DBL_MAX;
            unchanged(&f, wanted, vbss_collision_set_motion(c, OBJECT_CHAIN, NULL, x, 6), hash);
            unchanged(&f, wanted, vbss_collision_set_motion(c, OBJECT_CHAIN, x, good, 6), hash);
            unchanged(&f, wanted, vbss_collision_set_motion(c, OBJECT_CHAIN, good, x, 6), hash);
        }
        x[i] = i % 2 == 0 ? 1e30 : -1e30;
    }
    const uint32_t none[] = {OBJECT_SHAPES, 77, UINT32_MAX}, nodes[] = {0, 5, 7, UINT32_MAX};
    for (int i = 0; i < 3; i++) {
        unchanged(&f, VBSS_ERROR_NOT_FOUND, vbss_collision_set_motion(c, none[i], NULL, x, 6),
                  hash);
        unchanged(&f, VBSS_ERROR_NOT_FOUND, vbss_collision_remove(c, none[i]), hash);
        unchanged(&f, VBSS_ERROR_NOT_FOUND, vbss_collision_get_edge(c, none[i], 0, NULL), hash);
    }
    for (int i = 0; i < 4; i++) {
        unchanged(&f, VBSS_ERROR_OUT_OF_RANGE, vbss_collision_set_motion(c, 0, NULL, x, nodes[i]),
                  hash);
    }
    unchanged(&f, VBSS_ERROR_NULL_ARGUMENT, vbss_collision_set_motion(c, 0, x, NULL, 6), hash);
    expect_ok(vbss_collision_set_motion(c, OBJECT_CHAIN, x, x, 6)); /* the largest there are */
    assert_true(object_hash(c) != hash);
    uint32_t count;
    shapes_find(c, &count);
    object_end(&f);
}

/* Behind a right checksum, one coordinate at a time. */
static void snapshot_with_bad_coordinates_is_rejected(void **state)
{
    (void)state;
    object_fixture f;
    uint8_t bytes[4096];
    uint64_t count, hash;
    object_begin(&f);
    for (int i = 0; i < 36; i++) {
        const double mark = 0.123456789, bad = i % 2 == 0 ? 1.01e30 : -DBL_MAX;
        double x[2][18] = {{0.0}};
        uint64_t at = 0;
        x[i / 18][i % 18] = mark;
        expect_ok(vbss_collision_set_motion(f.collision, OBJECT_CAPSULES, x[0], x[1], 6));
        expect_ok(vbss_collision_find_candidates(f.collision));
        hash = object_hash(f.collision);
        expect_ok(vbss_collision_save(f.collision, bytes, sizeof bytes, &count));
        while (at + 8 < count && load_little_endian(bytes + at, 8) != harness_bits(mark)) {
            at++;
        }
        store_little_endian(bytes + at, harness_bits(bad), 8);
        harness_seal_snapshot(bytes, count);
        unchanged(&f, VBSS_ERROR_CORRUPT, vbss_collision_restore(f.collision, bytes, count), hash);
    }
    object_end(&f);
}

/* ---- capacity */

static void candidates_above_capacity_are_reported(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_collision *wide = object_make(context, NULL);
    uint32_t largest = shapes_statistics(wide).candidates;
    assert_in_range(largest, 10, 1000);
    for (uint32_t room = largest; room + 6 > largest; room--) {
        vbss_collision_config config;
        vbss_collision *tight;
        uint32_t count;
        expect_ok(vbss_collision_config_init(&config, sizeof config));
        config.pair_capacity = room;
        tight = object_make_unsearched(context, &config);
        object_move(tight, 1.0); /* rests: less to find */
        shapes_find(tight, &count);
        assert_in_range(count, 1, largest - 6);
        object_move(tight, 0.0); /* back: as much as there was on the way */
        uint64_t hash = object_hash(tight);
        for (int again = 0; again < 2 && room < largest; again++) {
            expect_result(VBSS_ERROR_CAPACITY, vbss_collision_find_candidates(tight));
            assert_int_equal(shapes_view(tight, VBSS_COLLISION_VIEW_CANDIDATES).count, 0);
            assert_int_equal(shapes_statistics(tight).candidates, 0);
            assert_true(object_hash(tight) == hash);
            expect_ok(vbss_collision_find_impacts(tight)); /* of none */
        }
        if (room < largest) {
            expect_ok(vbss_collision_remove(tight, OBJECT_CAPSULES));
            expect_ok(vbss_collision_remove(wide, OBJECT_CAPSULES));
            shapes_find(wide, &count);
        }
        shapes_find(tight, &count);
        shapes_expect_same_list(tight, wide);
        expect_ok(vbss_collision_destroy(wide));
        wide = object_make(context, NULL);
    }
    harness_context_end(context, &memory);
}

static void object_without_capacity_finds_nothing(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_collision_config config;
    vbss_collision *collision;
    uint32_t count, name;
    expect_ok(vbss_collision_config_init(&config, sizeof config));
    config.shape_capacity = config.pair_capacity = config.impact_capacity = 0;
    expect_ok(vbss_collision_create(context, &config, &collision));
    shapes_find(collision, &count);
    assert_int_equal(count, 0);
    expect_ok(vbss_collision_find_impacts(collision));
    expect_result(VBSS_ERROR_CAPACITY, vbss_collision_add_capsules(collision, 1, 0.1, &name));
    config.shape_capacity = 1;
    expect_ok(vbss_collision_create(context, &config, &collision));
    expect_ok(vbss_collision_add_capsules(collision, 1, 0.1, &name));
    shapes_find(collision, &count);
    assert_int_equal(count, 0);
    harness_context_end(context, &memory);
}

int test_object_refusals(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_config_is_rejected),
        cmocka_unit_test(bad_shapes_are_rejected),
        cmocka_unit_test(bad_moves_are_rejected),
        cmocka_unit_test(snapshot_with_bad_coordinates_is_rejected),
        cmocka_unit_test(candidates_above_capacity_are_reported),
        cmocka_unit_test(object_without_capacity_finds_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
