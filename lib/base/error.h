/* Error reporting, and the guard around calls into the host. */
#ifndef VBSS_BASE_ERROR_H
#define VBSS_BASE_ERROR_H

#include <stdbool.h>
#include <stddef.h>

#include <vblast_ss/base.h>

#include "base/compiler.h"

/* Returns a failure of `call` to the caller at once. */
#define VBSS_TRY(call)                \
    do {                              \
        vbss_result result_ = (call); \
        if (result_ != VBSS_OK) {     \
            return result_;           \
        }                             \
    } while (0)

/* Stores the status and the formatted text as the context's last error, logs the text, and returns
 * the status. The text should name the argument and its value. A NULL context stores nothing. */
vbss_result vbss_fail(vbss_context *context, vbss_result result, const char *format, ...)
    VBSS_PRINTF(3, 4);
/* Sends a formatted message to the host's log if the log's level admits it. Inside a callback the
 * message is dropped. */
void vbss_message(vbss_context *context, vbss_log_level level, const char *format, ...)
    VBSS_PRINTF(3, 4);
/* Brackets around every call of a host function. In between, calls that would change the context
 * return VBSS_ERROR_BUSY, and the host's floating-point mode is in force. Brackets nest: `outer` is
 * the value that vbss_callback_begin returned. */
bool vbss_callback_begin(vbss_context *context);
void vbss_callback_end(vbss_context *context, bool outer);

#endif
