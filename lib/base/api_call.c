/* Entry and exit of public calls: one thread in a context at a time, in the library's
 * floating-point mode. */
#include <errno.h>

#include "base/api_call.h"
#include "base/context.h"

/* Differs between threads that run at the same time: C11 gives each an errno of its own. */
static uintptr_t calling_thread(void)
{
    return (uintptr_t)&errno;
}

/* The context behind a handle from the host; NULL if there is none. */
static vbss_context *context_of(const void *handle)
{
    if (handle == NULL) {
        return NULL;
    }
    const uint32_t tag = *(const uint32_t *)handle;
    if (tag == VBSS_TAG_CONTEXT) {
        return (vbss_context *)handle; /* writable; const only promises that no state changes */
    }
    return tag == VBSS_TAG_SLOT ? ((const vbss_slot *)handle)->context : NULL;
}

static vbss_result check_host_mode(vbss_context *context)
{
#if defined(FLOAT_MODE_UNKNOWN)
    vbss_result result = vbss_arithmetic_check();
    return result == VBSS_OK
               ? VBSS_OK
               : vbss_fail(context, result, "%s in the calling thread", vbss_result_string(result));
#else
    (void)context;
    return VBSS_OK;
#endif
}

vbss_result vbss_call_enter(vbss_call *call, const void *handle)
{
    vbss_context *context = context_of(handle);
    call->context = NULL;
    call->host_mode = float_mode_get();
    float_mode_set(FLOAT_MODE_NEEDED);
    if (context == NULL) {
        return check_host_mode(NULL);
    }
    const uintptr_t thread = calling_thread();
    uintptr_t owner = atomic_load_explicit(&context->owner, memory_order_relaxed);
    if (owner == thread && context->in_library) {
        return VBSS_OK;
    }
    call->is_outermost = owner != thread;
    if (call->is_outermost) {
        owner = 0;
        if (!atomic_compare_exchange_strong_explicit(&context->owner, &owner, thread,
                                                     memory_order_acquire, memory_order_relaxed)) {
            return VBSS_ERROR_BUSY; /* the error text belongs to the thread inside */
        }
    }
    call->context = context;
    call->outer_mode = context->host_mode;
    context->host_mode = call->host_mode;
    context->in_library = true;
    return check_host_mode(context);
}

void vbss_call_leave(vbss_call *call)
{
    vbss_context *context = call->context;
    float_mode mode = call->host_mode;
    if (context != NULL) {
        mode = context->host_mode; /* a callback may have changed it */
        context->host_mode = call->outer_mode;
        context->in_library = false;
        if (call->is_outermost) {
            atomic_store_explicit(&context->owner, 0, memory_order_release);
        }
    }
    if (mode != FLOAT_MODE_NEEDED) {
        float_mode_set(mode);
    }
}
