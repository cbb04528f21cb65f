/* What every test stands on: cmocka, and fixtures for the promises each module must keep.
 *
 * A test file tests/<module>/test_<subject>.c defines `int test_<subject>(void)` that runs one
 * cmocka group; tests/CMakeLists.txt makes one executable a module out of them. Wrap tests that use
 * properties in harness_test, so that a failure prints the line that replays it. */
#ifndef VBSS_TESTS_HARNESS_H
#define VBSS_TESTS_HARNESS_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include <vblast_ss/vblast_ss.h>

#include "base/compiler.h"
#include "base/linear.h"
#include "base/random.h"
#include "base/slot.h"

#define harness_test(function) cmocka_unit_test_teardown(function, harness_after)
int harness_after(void **state);

/* ---- results and numbers (expect.c) */
#define expect_result(wanted, call) harness_expect((wanted), (call), #call, __FILE__, __LINE__)
#define expect_ok(call) expect_result(VBSS_OK, call)
void harness_expect(vbss_result wanted, vbss_result got, const char *call, const char *file,
                    int line);
#define expect_near(wanted, got, tolerance) \
    harness_near((wanted), (got), (tolerance), #got, __FILE__, __LINE__)
void harness_near(double wanted, double got, double tolerance, const char *what, const char *file,
                  int line);
/* The distance of both is at most the tolerance. */
#define expect_near_vec3(wanted, got, tolerance) \
    harness_near_vec3((wanted), (got), (tolerance), #got, __FILE__, __LINE__)
void harness_near_vec3(vec3 wanted, vec3 got, double tolerance, const char *what, const char *file,
                       int line);
/* Equal to the bit. */
#define expect_same_bits(wanted, got) harness_same_bits((wanted), (got), #got, __FILE__, __LINE__)
void harness_same_bits(double wanted, double got, const char *what, const char *file, int line);
uint64_t harness_bits(double value);
/* A figure that is known to be worse (larger) than wanted: docs/explanation/known-limits.md. Fails when it is worse than it is today,
 * and when it is as good as wanted: then what is wanted becomes the rule of the test. */
#define expect_known_limit(wanted, today, got) \
    harness_known_limit((wanted), (today), (got), #got, __FILE__, __LINE__)
void harness_known_limit(double wanted, double today, double got, const char *what,
                         const char *file, int line);

/* ---- memory that is watched, and fails when told to (memory.c) */
typedef struct harness_memory {
    uint64_t calls;          /* so far */
    uint64_t fail_call;      /* this call fails, counted from 1; 0: none */
    bool fail_ever_after;    /* and all later ones */
    uint64_t failures;       /* calls that were failed */
    uint64_t blocks;         /* alive */
    uint64_t wrong_releases; /* of what is not alive, or with another size or alignment */
    struct harness_block *alive;
} harness_memory;
/* A config whose allocator is `memory`, which must outlive the context. */
vbss_context_config harness_watched_config(harness_memory *memory);
vbss_context *harness_context(harness_memory *memory);
/* Destroys the context and asserts that every block came back as it was handed out. */
void harness_context_end(vbss_context *context, const harness_memory *memory);

/* Runs `attempt` in a fresh context with the first allocation failing, then the second, ... until
 * it succeeds; once with only that one failing, once with all after it. The attempt makes and
 * destroys what it tests and returns the first failure. Asserts that each failure is told as
 * VBSS_ERROR_OUT_OF_MEMORY, loses no block, and that there was something to fail. */
typedef vbss_result (*harness_attempt)(vbss_context *context, void *user);
void harness_fail_every_allocation(harness_attempt attempt, void *user);

/* ---- seeded properties (property.c) */
/* Where a property draws from: random numbers, or given bytes (then zeros) under a fuzzer. */
typedef struct harness_source {
    vbss_random random;
    const uint8_t *bytes;
    size_t count, position;
} harness_source;
void harness_source_from_bytes(harness_source *source, const uint8_t *bytes, size_t count);
uint64_t harness_draw_u64(harness_source *source);
uint32_t harness_draw_below(harness_source *source, uint32_t bound);
double harness_draw_real(harness_source *source, double low, double high);
/* Any bit pattern, with the special ones more often than by chance. */
double harness_draw_any_double(harness_source *source);
vec3 harness_draw_vec3(harness_source *source, double low, double high);
quat harness_draw_unit_quat(harness_source *source);
/* Runs the property on cases 0 .. cases-1 of the seed (1, or VBSS_PROPERTY_SEED); with
 * VBSS_PROPERTY_CASE=k on case k alone. */
typedef void (*harness_property_fn)(harness_source *source, void *user);
void harness_property(const char *name, uint32_t cases, harness_property_fn property, void *user);

/* ---- golden hashes (golden.c): tests/golden/<name>.txt, one "index hash" a line.
 * With VBSS_UPDATE_GOLDEN=1 the file is written instead, which needs a CHANGELOG line "numerics
 * changed". */
void harness_golden(const char *name, const uint64_t *hashes, size_t count);
/* The first index where the two differ, or count. */
size_t harness_first_difference(const uint64_t *a, const uint64_t *b, size_t count);

/* ---- a body that is stepped (body.c) */
typedef struct harness_body {
    const char *name;
    const vbss_kind *kind;
    vbss_result (*create)(vbss_context *context, void *user, void **handle);
    vbss_result (*edit)(void *handle); /* what a host may change between steps; NULL: nothing */
    vbss_result (*step)(void *handle);
    vbss_result (*destroy)(void *handle);
    void *user;
} harness_body;
/* The body is edited, stepped and saved at step `before`; its next `after` states are the wanted
 * ones. Restored (never edited again) into a new body, into one that has lived differently, and
 * into the first itself, it must go through the same states. Returns the first step (from 0) after
 * the restore that differs in any of these, or `after`. */
size_t harness_restored_divergence(const harness_body *body, size_t before, size_t after);
/* Asserts that none does. */
void harness_save_restore_continue(const harness_body *body, size_t before, size_t after);
/* The same at several steps, in ascending order, of one run. */
void harness_save_restore_continue_at(const harness_body *body, const size_t *before, size_t count,
                                      size_t after);
/* Calls of the allocator in that many steps: a body of the house makes none. */
uint64_t harness_step_allocations(const harness_body *body, size_t steps);
/* Cut, damaged and foreign snapshots: each is told and leaves the body as it was. Damage that only
 * the visitor can see is either told like this, or taken and saved again to the same bytes. */
void harness_refuses_bad_snapshots(const harness_body *body, size_t steps);
/* Writes the checksum of a changed snapshot anew, so that only the visitor can see the change. */
void harness_seal_snapshot(uint8_t *bytes, size_t count);
/* Byte of a snapshot just after its state; a description may follow. */
size_t harness_state_end(const uint8_t *bytes, size_t count);

/* ---- bad input (bad_input.c) */
extern const double harness_bad_numbers[3]; /* NaN, +infinity, -infinity */
/* A config's functions behind one signature; create_and_destroy makes an object from it. */
typedef struct harness_config {
    const uint32_t *sizes; /* of all published versions, ascending, the last is today's; then 0 */
    vbss_result (*init)(void *config, uint32_t struct_size);
    vbss_result (*create_and_destroy)(vbss_context *context, const void *config);
} harness_config;
/* Asserts the size protocol in all directions: every published size, every other one, larger with
 * and without an unknown field, and what was never initialised. */
void harness_config_protocol(const harness_config *config);
/* A call on a handle, all other arguments good. */
typedef vbss_result (*harness_handle_call)(void *handle);
/* Asserts that NULL, a context, a handle of another type and a destroyed handle of this type are
 * each VBSS_ERROR_INVALID_HANDLE, with a text where there is a context to keep it. */
void harness_refuses_bad_handles(vbss_context *context, void *destroyed,
                                 const harness_handle_call *calls, size_t count);

/* ---- fixtures that must fail (must_fail.c): asserts that an assertion of the test fails. It runs
 * in a process of its own that says nothing. A test that passes on a faulty body tests nothing. */
#define expect_failure(test) harness_must_fail((test), #test, __FILE__, __LINE__)
void harness_must_fail(CMUnitTestFunction test, const char *name, const char *file, int line);

/* ---- a long run, split into seeds (soak.c); one executable each, driven by tests/soak.py */
typedef struct harness_soak {
    uint64_t seed;
    uint64_t failures;  /* of this seed */
    char figures[1024]; /* JSON members with a leading comma, such as ", \"worst\": 1.5" */
} harness_soak;
void harness_soak_fail(harness_soak *soak, const char *format, ...) VBSS_PRINTF(2, 3);
void harness_soak_figure(harness_soak *soak, const char *name, double value);
/* main of a soak: `--seed S`, prints one JSON line, exits 1 when the seed failed. */
int harness_soak_main(int argc, char **argv, void (*run)(harness_soak *soak));

#endif
