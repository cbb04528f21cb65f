#include <stdlib.h>
#include <string.h>

#include "solver/twin.h"

static twin subject;

/* ---- memory that is watched behind its last byte, which alignment would hide from sanitizers */

enum { BEHIND = 256 };
static unsigned char *behind(void *memory, uint64_t size)
{
    return (unsigned char *)memory + size;
}

static void *fenced_allocate(void *user, uint64_t size, uint64_t alignment)
{
    (void)user;
    uint64_t bytes = (size + BEHIND + alignment - 1) / alignment * alignment;
    void *memory = aligned_alloc((size_t)alignment, (size_t)bytes);
    memset(behind(memory, size), 0x7e, BEHIND);
    return memory;
}

static void fenced_release(void *user, void *memory, uint64_t size, uint64_t alignment)
{
    (void)alignment;
    uint64_t *broken = user;
    for (int i = 0; i < BEHIND; i++) {
        *broken += behind(memory, size)[i] != 0x7e;
    }
    free(memory);
}

static vbss_context *fenced_context(uint64_t *broken)
{
    vbss_context_config config;
    vbss_context *context;
    *broken = 0;
    expect_ok(vbss_context_config_init(&config, sizeof config));
    config.allocate = fenced_allocate;
    config.deallocate = fenced_release;
    config.allocator_user = broken;
    expect_ok(vbss_context_create(&config, &context));
    return context;
}

/* Patterns of any size into rooms of any size: told or solved, and nothing beside the room. */
static void any_room(harness_source *source, void *user)
{
    uint32_t *outcomes = user;
    twin *t = &subject;
    uint64_t broken;
    twin_draw_chains(t, source, 40);
    twin_draw_roles(t, source, TWIN_MIXED);
    twin_draw_numbers(t, source);
    uint32_t blocks = t->blocks - harness_draw_below(source, 1 + t->blocks / 4);
    uint32_t reach = harness_draw_below(source, 2 + t->reach);
    uint32_t separators = harness_draw_below(source, 2 * twin_separators(t) + 1);
    t->context = fenced_context(&broken);
    expect_ok(vbss_system_create(t->context, blocks, reach, separators,
                                 separators * (separators + 1) / 2, &t->system));
    vbss_result result = twin_register(t);
    if (result == VBSS_OK) {
        twin_compare(t);
    } else {
        expect_result(VBSS_ERROR_CAPACITY, result);
    }
    outcomes[result == VBSS_OK]++;
    vbss_system_destroy(t->context, t->system);
    expect_ok(vbss_context_destroy(t->context));
    assert_int_equal(broken, 0);
}

static void overflow_is_reported_and_nothing_is_written_outside(void **state)
{
    (void)state;
    uint32_t outcomes[2] = {0, 0};
    harness_property("any room", 400, any_room, outcomes);
    assert_true(getenv("VBSS_PROPERTY_CASE") != NULL || (outcomes[0] > 50 && outcomes[1] > 50));
}

static void expect_text(vbss_context *context, const char *wanted)
{
    vbss_result result;
    const char *text;
    expect_ok(vbss_context_get_last_error(context, &result, &text));
    expect_result(VBSS_ERROR_CAPACITY, result);
    assert_non_null(strstr(text, wanted));
}

static void block_overflow_is_reported(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_system *system;
    uint32_t first = 77;
    expect_ok(vbss_system_create(context, 10, 2, 3, 6, &system));
    vbss_system_begin_pattern(system);
    expect_result(VBSS_ERROR_CAPACITY, vbss_system_add_chain(system, 11, &first));
    expect_text(context, "more than 10 blocks");
    expect_result(VBSS_ERROR_CAPACITY, vbss_system_add_chain(system, UINT32_MAX, &first));
    expect_ok(vbss_system_add_chain(system, 6, &first));
    assert_int_equal(first, 0);
    expect_result(VBSS_ERROR_CAPACITY, vbss_system_add_chain(system, 5, &first));
    expect_result(VBSS_ERROR_CAPACITY, vbss_system_add_chain(system, UINT32_MAX - 5, &first));
    assert_int_equal(first, 0); /* untouched */
    expect_ok(vbss_system_add_chain(system, 4, &first));
    assert_int_equal(first, 6);
    expect_result(VBSS_ERROR_CAPACITY, vbss_system_add_chain(system, 1, &first));
    vbss_system_begin_pattern(system); /* and all the room is there again */
    expect_ok(vbss_system_add_chain(system, 10, &first));
    vbss_system_destroy(context, system);
    harness_context_end(context, &memory);
}

static void coupling_overflow_is_reported(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_system *system;
    uint32_t first, coupling;
    expect_ok(vbss_system_create(context, 4, 1, 4, 0, &system));
    vbss_system_begin_pattern(system);
    expect_ok(vbss_system_add_chain(system, 4, &first));
    for (uint32_t b = 0; b < 4; b++) { /* a ring */
        expect_ok(vbss_system_couple(system, b, (b + 1) % 4, &coupling));
        assert_int_not_equal(coupling, VBSS_NO_COUPLING);
    }
    expect_result(VBSS_ERROR_CAPACITY, vbss_system_couple(system, 0, 2, &coupling));
    expect_text(context, "more than 4 couplings");
    assert_int_equal(coupling, VBSS_NO_COUPLING);          /* what is added to it is swallowed */
    vbss_system_set_role(system, 2, VBSS_ROLE_PRESCRIBED); /* needs no room */
    expect_ok(vbss_system_couple(system, 0, 2, &coupling));
    assert_int_equal(coupling, VBSS_NO_COUPLING);
    vbss_system_destroy(context, system);
    harness_context_end(context, &memory);
}

/* A chain whose numbers are drawn; roles are the test's. */
static void draw_chain(twin *t, uint32_t blocks, uint32_t reach)
{
    harness_source source = {0};
    vbss_random_seed(&source.random, 1, 0);
    t->blocks = t->chain_end[0] = blocks;
    t->reach = reach;
    t->chains = 1;
    for (uint32_t b = 0; b < blocks; b++) {
        t->roles[b] = VBSS_ROLE_INTERIOR;
    }
    twin_draw_numbers(t, &source);
}

static void separator_overflow_is_reported_and_recoverable(void **state)
{
    (void)state;
    twin *t = &subject;
    draw_chain(t, 10, 2);
    twin_begin_with(t, 10, 2, 3);
    for (uint32_t b = 3; b < 7; b++) {
        t->roles[b] = VBSS_ROLE_SEPARATOR;
    }
    expect_result(VBSS_ERROR_CAPACITY, twin_register(t));
    expect_text(t->context, "more than 3 separators");
    t->roles[6] = VBSS_ROLE_INTERIOR;
    expect_ok(twin_register(t));
    twin_compare(t);
    twin_end(t);
}

static void separator_limit_is_16384(void **state)
{
    (void)state;
    enum { MANY = 16385 };
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_system *system;
    uint32_t first;
    expect_ok(vbss_system_create(context, MANY, 0, MANY, 0, &system));
    vbss_system_begin_pattern(system);
    expect_ok(vbss_system_add_chain(system, MANY, &first));
    for (uint32_t b = 1; b < MANY; b++) {
        vbss_system_set_role(system, b, VBSS_ROLE_SEPARATOR);
    }
    expect_ok(vbss_system_analyse(system));
    vbss_system_set_role(system, 0, VBSS_ROLE_SEPARATOR);
    expect_result(VBSS_ERROR_CAPACITY, vbss_system_analyse(system));
    expect_text(context, "more than 16384 separators");
    vbss_system_destroy(context, system);
    harness_context_end(context, &memory);
}

/* One separator does not part runs that are coupled past it: their columns meet all separators
 * behind, for which there is no room in general. */
static void coupled_runs_past_narrow_separators_are_reported(void **state)
{
    (void)state;
    twin *t = &subject;
    draw_chain(t, 300, 2);
    for (uint32_t b = 20; b < 300; b += 20) {
        t->roles[b] = VBSS_ROLE_SEPARATOR;
    }
    assert_true(twin_is_narrow(t));
    twin_begin_with(t, 300, 2, twin_separators(t));
    expect_result(VBSS_ERROR_CAPACITY, twin_register(t));
    for (uint32_t b = 21; b < 300; b += 20) { /* two do part them */
        t->roles[b] = VBSS_ROLE_SEPARATOR;
    }
    assert_false(twin_is_narrow(t));
    twin_end(t);
    twin_begin(t);
    expect_ok(twin_register(t));
    twin_compare(t);
    twin_end(t);
}

static vbss_result create_and_destroy(vbss_context *context, void *user)
{
    (void)user;
    vbss_system *system = (vbss_system *)context; /* anything but NULL */
    vbss_result result = vbss_system_create(context, 20, 2, 4, 10, &system);
    assert_true((result == VBSS_OK) == (system != NULL));
    vbss_system_destroy(context, system);
    return result;
}

static void each_failed_allocation_is_reported_without_leak(void **state)
{
    (void)state;
    harness_fail_every_allocation(create_and_destroy, NULL);
}

int test_capacity(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(overflow_is_reported_and_nothing_is_written_outside),
        harness_test(block_overflow_is_reported),
        harness_test(coupling_overflow_is_reported),
        harness_test(separator_overflow_is_reported_and_recoverable),
        harness_test(separator_limit_is_16384),
        harness_test(coupled_runs_past_narrow_separators_are_reported),
        harness_test(each_failed_allocation_is_reported_without_leak),
    };
    return cmocka_run_group_tests_name("solver.capacity", tests, NULL, NULL);
}
