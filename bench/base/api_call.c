/* The entry and exit of a public call, beside a call of an empty function. The promise is 50 ns; the empty call makes it a ratio
 * that holds on other machines. */
#include <vblast_ss/base.h>

#include "base/api_call.h"
#include "bench_base.h"

enum { CALLS = 1000 };

static vbss_context *context;

static int create_context(void *user)
{
    (void)user;
    return vbss_context_create(NULL, &context) == VBSS_OK ? 0 : 1;
}

static void destroy_context(void *user)
{
    (void)user;
    vbss_context_destroy(context);
}

VBSS_NEVER_INLINE vbss_result empty(const void *handle)
{
    bench_keep_memory((void *)handle);
    return VBSS_OK;
}

VBSS_NEVER_INLINE vbss_result entered(const void *handle)
{
    VBSS_ENTER(handle);
    bench_keep_memory((void *)handle);
    return VBSS_OK;
}

static void run_empty(void *user)
{
    (void)user;
    for (int i = 0; i < CALLS; i++) {
        (void)empty(context);
    }
}

static void run_entered(void *user)
{
    (void)user;
    for (int i = 0; i < CALLS; i++) {
        (void)entered(context);
    }
}

/* A public function that calls another one. */
static void run_nested(void *user)
{
    vbss_call call;
    vbss_call_enter(&call, context);
    run_entered(user);
    vbss_call_leave(&call);
}

/* A host that rounds upward, so that each entry and exit changes the mode. */
static void run_other_mode(void *user)
{
#if defined(__SSE2__)
    float_mode_set(0x5f80);
#endif
    run_entered(user);
    float_mode_set(FLOAT_MODE_NEEDED);
}

static void run_getter(void *user)
{
    vbss_context_statistics statistics;
    (void)user;
    for (int i = 0; i < CALLS; i++) {
        (void)vbss_context_get_statistics(context, &statistics, sizeof statistics);
    }
    bench_keep_memory(&statistics);
}

void add_api_call_cases(bench *b)
{
    static const struct {
        const char *name;
        void (*run)(void *user);
    } rows[] = {{"base/call/empty", run_empty},
                {"base/call/entry", run_entered},
                {"base/call/nested", run_nested},
                {"base/call/other-mode", run_other_mode},
                {"base/call/get-statistics", run_getter}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const bench_batch batch = {.name = rows[i].name,
                                   .items = CALLS,
                                   .setup = create_context,
                                   .run = rows[i].run,
                                   .teardown = destroy_context};
        bench_add_batch(b, &batch);
    }
}
