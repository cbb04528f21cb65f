/* Last error, log messages, and the guard around callbacks. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/context.h"
#include "base/error.h"

bool vbss_callback_begin(vbss_context *context)
{
    bool outer = context->in_callback;
    context->in_callback = true;
    if (context->in_library) {
        context->in_library = false;
        float_mode_set(context->host_mode);
    }
    return outer;
}

void vbss_callback_end(vbss_context *context, bool outer)
{
    context->in_callback = outer;
    if (atomic_load_explicit(&context->owner, memory_order_relaxed) != 0) {
        context->in_library = true;
        context->host_mode = float_mode_get();
        float_mode_set(FLOAT_MODE_NEEDED);
    }
}

static void send_to_log(vbss_context *context, vbss_log_level level, const char *message)
{
    if (context->log == NULL || level > context->log_level || context->in_callback) {
        return; /* logging a call made inside a callback could recurse without end */
    }
    bool outer = vbss_callback_begin(context);
    context->log(context->log_user, level, message);
    vbss_callback_end(context, outer);
}

void vbss_message(vbss_context *context, vbss_log_level level, const char *format, ...)
{
    char message[VBSS_TEXT_BYTES];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    send_to_log(context, level, message);
}

static void store_error(vbss_context *context, vbss_result result, const char *text)
{
    context->last_result = result;
    memcpy(context->last_error, text, VBSS_TEXT_BYTES);
}

vbss_result vbss_fail(vbss_context *context, vbss_result result, const char *format, ...)
{
    if (context != NULL) {
        char text[VBSS_TEXT_BYTES] = {0};
        va_list arguments;
        va_start(arguments, format);
        vsnprintf(text, sizeof text, format, arguments);
        va_end(arguments);
        /* A call refused inside a callback must not overwrite the error that the callback
         * reports. */
        if (!context->in_callback) {
            store_error(context, result, text);
        }
        send_to_log(context, VBSS_LOG_ERROR, text);
    }
    return result;
}
