/* The list of rows, and what is remembered of them from part to part. */
#include "base/error.h"
#include "few_blocks.h"

typedef struct list {
    harness_memory memory;
    vbss_context *context;
    contact_set *set;
} list;

static void list_begin(list *l, uint32_t capacity)
{
    l->context = harness_context(&l->memory);
    expect_ok(vbss_contact_create(l->context, capacity, &l->set));
}

static void list_end(list *l)
{
    vbss_contact_destroy(l->context, l->set);
    harness_context_end(l->context, &l->memory);
}

static contact_constraint *add(list *l, uint32_t a, uint32_t b)
{
    const contact_key key = {0, 1, a, 1, b};
    contact_constraint *row = vbss_contact_add(l->set, &key);
    assert_non_null(row);
    row->normal = vec3_make(0.0, 1.0, 0.0);
    return row;
}

static void close_with(contact_constraint *row, double pressure)
{
    row->solution.status = CONTACT_STICK;
    row->solution.normal_force = pressure;
    row->solution.tangential_force = vec3_make(0.1 * pressure, 0.0, 0.0);
}

/* ---- the list */

static int sign(int x)
{
    return (x > 0) - (x < 0);
}

static void keys_compare_lexicographically(void **state)
{
    (void)state;
    const contact_key low = {1, 2, 3, 4, 5};
    for (int word = 0; word < 5; word++) {
        for (int later = word; later < 5; later++) {
            contact_key high = low;
            uint32_t *words = &high.kind;
            words[word]++;
            words[later] = later > word ? 0 : words[later]; /* earlier words count first */
            assert_int_equal(sign(vbss_contact_compare_keys(&low, &high)), -1);
            assert_int_equal(sign(vbss_contact_compare_keys(&high, &low)), 1);
        }
    }
    const contact_key largest = {UINT32_MAX, UINT32_MAX, UINT32_MAX, UINT32_MAX, UINT32_MAX};
    assert_int_equal(vbss_contact_compare_keys(&low, &low), 0);
    assert_int_equal(sign(vbss_contact_compare_keys(&largest, &low)), 1);
}

static void constraints_fill_to_capacity(void **state)
{
    (void)state;
    for (uint32_t capacity = 0; capacity <= 5; capacity++) {
        list l;
        list_begin(&l, capacity);
        for (int again = 0; again < 2; again++) {
            const contact_key key = {0, 1, 99, 1, 99};
            for (uint32_t i = 0; i < capacity; i++) {
                contact_constraint *row = add(&l, i, 7);
                assert_int_equal(row->key.feature_a, i);
                assert_int_equal(row->geometry, i); /* differs, and is below the capacity */
                assert_int_equal(row->jacobian_block_count,
                                 0); /* nothing is left of who was there before */
                assert_int_equal(row->solution.status, CONTACT_OPEN);
                assert_false(row->is_bilateral);
                row->jacobian_block_count = 3;
                row->is_bilateral = true;
                close_with(row, 1.0);
            }
            assert_null(vbss_contact_add(l.set, &key));
            assert_int_equal(l.set->count, capacity);
            vbss_contact_clear(l.set);
            assert_int_equal(l.set->count, 0);
        }
        list_end(&l);
    }
}

static void rows_are_sorted(harness_source *source, void *user)
{
    (void)user;
    list l;
    uint32_t count = harness_draw_below(source, 40), sum = 0, geometries[40];
    list_begin(&l, 40);
    for (uint32_t i = 0; i < count; i++) {
        uint32_t a = harness_draw_below(source, 6);
        contact_constraint *row = add(&l, a, 100 + i); /* each but once */
        row->key.kind = harness_draw_below(source, 3);
        row->gap = row->key.feature_b;
        geometries[i] = row->geometry;
        sum += row->key.feature_b;
    }
    vbss_contact_sort(l.set);
    assert_int_equal(l.set->count, count);
    for (uint32_t i = 0; i < count; i++) {
        const contact_constraint *row = &l.set->constraints[i];
        assert_true(i == 0 || vbss_contact_compare_keys(&row[-1].key, &row->key) < 0);
        expect_near(row->key.feature_b, row->gap, 0.0); /* all of it moved */
        assert_int_equal(geometries[row->key.feature_b - 100], row->geometry);
        sum -= row->key.feature_b;
    }
    assert_int_equal(sum, 0);
    list_end(&l);
}

static void sorting_is_a_permutation(void **state)
{
    (void)state;
    harness_property("sort", 200, rows_are_sorted, NULL);
}

/* The next list has other rows in the same places. */
static void new_constraint_is_reset(void **state)
{
    (void)state;
    list l;
    list_begin(&l, 1);
    contact_constraint *row = add(&l, 0, 0);
    row->is_bilateral = true;
    row->tangential_stiffness_ratio = row->recovery_allowance = 0.25;
    row->is_sleeve = true;
    row->previous_force = vec3_make(1.0, 2.0, 3.0);
    close_with(row, 1.0);
    vbss_contact_clear(l.set);
    row = add(&l, 1, 0);
    assert_false(row->is_bilateral);
    expect_near(0.0, row->tangential_stiffness_ratio + row->recovery_allowance, 0.0);
    assert_false(row->is_sleeve);
    expect_near(0.0, vec3_norm(row->previous_force), 0.0);
    assert_int_equal(row->solution.status, CONTACT_OPEN);
    list_end(&l);
}

static void penetration_counts_unilateral_only(void **state)
{
    (void)state;
    list l;
    list_begin(&l, 3);
    expect_near(0.0, vbss_contact_max_penetration(l.set), 0.0);
    assert_true(vbss_contact_penetration_is_allowed(l.set));
    add(&l, 0, 0)->gap = 1.0;
    expect_near(0.0, vbss_contact_max_penetration(l.set), 0.0);
    contact_constraint *deep = add(&l, 1, 0), *tied = add(&l, 2, 0);
    deep->gap = -2e-5;
    tied->gap = -1.0;
    tied->is_bilateral = true;
    expect_near(2e-5, vbss_contact_max_penetration(l.set), 0.0);
    assert_false(vbss_contact_penetration_is_allowed(l.set));
    deep->allowed_penetration = 2e-5;
    assert_true(vbss_contact_penetration_is_allowed(l.set));
    deep->gap = (double)NAN; /* never a good depth */
    assert_false(vbss_contact_penetration_is_allowed(l.set));
    list_end(&l);
}

/* ---- memory */

/* Where little presses, the stiffness along is what spends friction within a given way; where much does, all. */
static void light_pressure_softens_tangential_stiffness(void **state)
{
    (void)state;
    const double pressures[3] = {1e-6, 1e-3, 1.0};
    for (int i = 0; i < 3; i++) {
        list l;
        list_begin(&l, 1);
        close_with(add(&l, 1, 1), pressures[i]);
        vbss_contact_store_warm_start(l.set);
        vbss_contact_clear(l.set);
        contact_constraint *row = add(&l, 1, 1);
        row->stiffness = 2e5;
        row->friction = 0.3;
        row->elastic_slip_limit = 1e-7;
        vbss_contact_warm_start(l.set);
        double along = row->tangential_stiffness_ratio > 0.0
                           ? row->tangential_stiffness_ratio * row->stiffness
                           : row->stiffness;
        expect_near(vbss_min(0.3 * pressures[i] / 1e-7, 2e5), along, 1e-9 * along);
        list_end(&l);
    }
}

static void warm_start_restores_closed_constraints(void **state)
{
    (void)state;
    list l;
    list_begin(&l, 8);
    close_with(add(&l, 1, 1), 1.0);
    add(&l, 2, 2); /* open: nothing to remember */
    contact_constraint *slips = add(&l, 3, 3);
    close_with(slips, 3.0);
    slips->solution.status = CONTACT_SLIP;
    slips->solution.friction_ratio = 0.25;
    contact_constraint *resting = add(&l, 9, 9); /* SLIP without a force has no way */
    resting->solution =
        (contact_solution){.status = CONTACT_SLIP, .normal_force = 1.0, .friction_ratio = 0.5};
    vbss_contact_store_warm_start(l.set);
    assert_int_equal(l.set->warm_start_count, 3);

    vbss_contact_clear(l.set);
    contact_constraint *one = add(&l, 1, 1), *two = add(&l, 2, 5), *three = add(&l, 3, 3);
    contact_constraint *tied = add(&l, 5, 5), *nine = add(&l, 9, 9);
    tied->is_bilateral = true;
    three->normal = vec3_make(0.0, 0.6, 0.8);
    vbss_contact_warm_start(l.set);
    assert_int_equal(one->solution.status, CONTACT_STICK);
    expect_near(1.0, one->solution.normal_force, 0.0);
    expect_near(0.1, one->previous_force.x, 1e-16);
    expect_near(0.1, one->solution.tangential_force.x, 1e-16);
    assert_int_equal(two->solution.status, CONTACT_OPEN);
    assert_int_equal(tied->solution.status, CONTACT_STICK);
    assert_int_equal(three->solution.status, CONTACT_SLIP);
    expect_near(0.25, three->solution.friction_ratio, 0.0);
    expect_near(1.0, three->solution.slip_direction.x, 1e-15);
    expect_near(0.3, vec3_norm(three->previous_force), 1e-15);
    expect_near(0.0, vec3_dot(three->previous_force, three->normal), 1e-16);
    expect_near(0.0, one->tangential_stiffness_ratio, 0.0);
    assert_int_equal(nine->solution.status, CONTACT_STICK);
    l.set->warm_start_count = 0;
    vbss_contact_warm_start(l.set);
    assert_int_equal(one->solution.status, CONTACT_OPEN);
    expect_near(0.0, vec3_norm(one->previous_force), 0.0);
    list_end(&l);
}

/* As who knows no more of the features than their numbers. */
static void warm_start_and_pass_on(contact_set *set)
{
    vbss_contact_warm_start(set);
    for (uint32_t m = 0; m < set->warm_start_count; m++) {
        if (!set->warm_start[m].has_constraint) {
            vbss_contact_warm_start_neighbour(set, m);
        }
    }
}

/* A contact that has moved on by one feature on either side, or on both. */
static void neighbour_inherits_warm_start(void **state)
{
    (void)state;
    for (uint32_t da = 0; da < 4; da++) {
        for (uint32_t db = 0; db < 4; db++) {
            list l;
            list_begin(&l, 4);
            close_with(add(&l, 10, 20), 1.0);
            vbss_contact_store_warm_start(l.set);
            vbss_contact_clear(l.set);
            contact_constraint *row = add(&l, 8 + da, 18 + db);
            row->solution.status = CONTACT_SLIP; /* forgotten */
            warm_start_and_pass_on(l.set);
            bool near = da > 0 && db > 0; /* 9 .. 11; 8 is two away */
            assert_int_equal(row->solution.status, near ? CONTACT_STICK : CONTACT_OPEN);
            expect_near(near ? 0.1 : 0.0, row->previous_force.x, 1e-16);
            list_end(&l);
        }
    }
}

static void warm_start_entry_is_used_once(void **state)
{
    (void)state;
    list l;
    list_begin(&l, 8);
    close_with(add(&l, 10, 20), 1.0);
    vbss_contact_store_warm_start(l.set);
    vbss_contact_clear(l.set);
    contact_constraint *before = add(&l, 9, 20), *itself = add(&l, 10, 20),
                       *after = add(&l, 11, 20);
    warm_start_and_pass_on(l.set); /* by its own row first, although a neighbour comes before */
    assert_int_equal(before->solution.status, CONTACT_OPEN);
    assert_int_equal(itself->solution.status, CONTACT_STICK);
    assert_int_equal(after->solution.status, CONTACT_OPEN);
    vbss_contact_clear(l.set);
    before = add(&l, 9, 20);
    after = add(&l, 11, 20);
    warm_start_and_pass_on(l.set); /* by one of two neighbours */
    assert_int_equal(before->solution.status + after->solution.status, CONTACT_STICK);
    /* Others are no neighbours: of another kind, another body, or round the end of the numbers. */
    vbss_contact_clear(l.set);
    add(&l, 9, 20)->key.kind = 1;
    add(&l, 9, 20)->key.body_a = 2;
    add(&l, 9, 20)->key.body_b = 2;
    vbss_contact_sort(l.set);
    warm_start_and_pass_on(l.set);
    for (int i = 0; i < 3; i++) {
        assert_int_equal(l.set->constraints[i].solution.status, CONTACT_OPEN);
    }
    list_end(&l);
}

static void failed_attempt_is_discarded(void **state)
{
    (void)state;
    list l;
    list_begin(&l, 8);
    close_with(add(&l, 1, 1), 1.0);
    close_with(add(&l, 2, 2), 2.0);
    vbss_contact_store_warm_start(l.set);
    vbss_contact_checkpoint(l.set);
    for (int k = 0; k < 2; k++) {
        vbss_contact_clear(l.set);
        close_with(add(&l, 1, 1), 5.0);
        vbss_contact_store_warm_start(l.set);
        assert_int_equal(l.set->warm_start_count, 1);
        vbss_contact_rollback(l.set); /* as often as wanted */
        assert_int_equal(l.set->warm_start_count, 2);
        expect_near(1.0, l.set->warm_start[0].normal_force, 0.0);
        expect_near(2.0, l.set->warm_start[1].normal_force, 0.0);
    }
    vbss_contact_clear(l.set);
    vbss_contact_store_warm_start(l.set);
    vbss_contact_checkpoint(l.set); /* of nothing */
    close_with(add(&l, 1, 1), 5.0);
    vbss_contact_store_warm_start(l.set);
    vbss_contact_rollback(l.set);
    assert_int_equal(l.set->warm_start_count, 0);
    list_end(&l);
}

/* ---- saved */

static vbss_result read(list *l, const uint8_t *bytes, size_t count)
{
    vbss_stream stream;
    vbss_stream_begin_read(&stream, bytes, count);
    vbss_contact_serialise(&stream, 90, l->set);
    return stream.result;
}

static size_t write(list *l, uint8_t *bytes, size_t capacity)
{
    vbss_stream stream;
    vbss_stream_begin_write(&stream, bytes, capacity);
    vbss_contact_serialise(&stream, 90, l->set);
    expect_ok(stream.result);
    return stream.position;
}

static void warm_start_snapshot_rejects_invalid_data(void **state)
{
    (void)state;
    list l, other;
    uint8_t bytes[2048], again[2048];
    list_begin(&l, 4);
    list_begin(&other, 2);
    close_with(add(&l, 1, 1), 1.0);
    close_with(add(&l, 2, 2), 2.0);
    l.set->constraints[1].solution.status = CONTACT_SLIP;
    l.set->residual = 0.125;
    l.set->counters = (contact_counters){7, 3, 0};
    vbss_contact_store_warm_start(l.set);
    size_t count = write(&l, bytes, sizeof bytes);
    expect_ok(read(&other, bytes, count));
    assert_int_equal(other.set->warm_start_count, 2);
    assert_int_equal(other.set->counters.solves, 7);
    assert_int_equal(write(&other, again, sizeof again), count);
    assert_memory_equal(bytes, again, count);

    contact_warm_start_entry *m = l.set->warm_start, good = m[1];
    for (int k = 0; k < 4; k++) {
        m[1] = good;
        m[1].status = k == 0 ? CONTACT_OPEN : k == 1 ? CONTACT_SLIP + 1u : m[1].status;
        m[1].key = k == 2 ? m[0].key : m[1].key;              /* twice */
        m[1].key.feature_a = k == 3 ? 0 : m[1].key.feature_a; /* in disorder */
        count = write(&l, bytes, sizeof bytes);
        expect_result(VBSS_ERROR_CORRUPT, read(&other, bytes, count));
    }
    m[1] = m[2] = good; /* more than there is room for */
    m[2].key.feature_a = 3;
    l.set->warm_start_count = 3;
    count = write(&l, bytes, sizeof bytes);
    assert_true(read(&other, bytes, count) < 0);
    assert_true(other.set->warm_start_count <= 2);
    list_end(&other);
    list_end(&l);
}

/* Snapshots of all versions have 1 for a sleeve that slides forward, 0 for one that slides backward,
 * and the ratio of a contact that slips, in one number. */
static void sleeve_direction_is_saved_as_one_or_zero(void **state)
{
    (void)state;
    list l, other;
    uint8_t bytes[2048], old[2048];
    list_begin(&l, 3);
    list_begin(&other, 3);
    for (uint32_t i = 0; i < 3; i++) {
        contact_constraint *row = add(&l, i, i);
        close_with(row, 1.0);
        row->is_bilateral = row->is_sleeve = i < 2;
        row->solution.status = CONTACT_SLIP;
        row->solution.is_forward = i == 1;
        row->solution.friction_ratio = i == 2 ? 0.25 : 0.0;
    }
    vbss_contact_store_warm_start(l.set);
    size_t count = write(&l, bytes, sizeof bytes);
    contact_warm_start_entry *m = l.set->warm_start;
    m[1].is_forward = false; /* as they were written before the direction had a field */
    m[1].friction_ratio = 1.0;
    assert_int_equal(write(&l, old, sizeof old), count);
    assert_memory_equal(old, bytes, count);
    expect_ok(read(&other, bytes, count));
    m = other.set->warm_start;
    assert_true(!m[0].is_forward && m[1].is_forward && !m[2].is_forward);
    expect_near(0.0, m[0].friction_ratio + m[1].friction_ratio, 0.0);
    expect_near(0.25, m[2].friction_ratio, 0.0);
    assert_int_equal(write(&other, old, sizeof old), count);
    assert_memory_equal(old, bytes, count);
    list_end(&other);
    list_end(&l);
}

static vbss_result attempt(vbss_context *context, void *user)
{
    contact_set *set;
    (void)user;
    VBSS_TRY(vbss_contact_create(context, 16, &set));
    vbss_contact_destroy(context, set);
    return VBSS_OK;
}

static void each_failed_allocation_is_reported(void **state)
{
    (void)state;
    harness_fail_every_allocation(attempt, NULL);
}

int test_constraints(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(keys_compare_lexicographically),
        cmocka_unit_test(constraints_fill_to_capacity),
        harness_test(sorting_is_a_permutation),
        cmocka_unit_test(new_constraint_is_reset),
        cmocka_unit_test(penetration_counts_unilateral_only),
        cmocka_unit_test(warm_start_restores_closed_constraints),
        cmocka_unit_test(light_pressure_softens_tangential_stiffness),
        cmocka_unit_test(neighbour_inherits_warm_start),
        cmocka_unit_test(warm_start_entry_is_used_once),
        cmocka_unit_test(failed_attempt_is_discarded),
        cmocka_unit_test(warm_start_snapshot_rejects_invalid_data),
        cmocka_unit_test(sleeve_direction_is_saved_as_one_or_zero),
        cmocka_unit_test(each_failed_allocation_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
