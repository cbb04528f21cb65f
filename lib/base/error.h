/* Reporting a failure, and the brackets around calls of the host. */
#ifndef VBSS_BASE_ERROR_H
#define VBSS_BASE_ERROR_H

#include <stdbool.h>
#include <stddef.h>

#include <vblast_ss/base.h>

#include "base/compiler.h"

/* Returns a failure to the caller at once. */
#define VBSS_TRY(call)                \
    do {                              \
        vbss_result result_ = (call); \
        if (result_ != VBSS_OK) {     \
            return result_;           \
        }                             \
    } while (0)

/* Keeps the code and a text that names argument and value, returns the
 * code. A NULL context is allowed: then there is nobody to keep the text. */
vbss_result vbss_fail(vbss_context *context, vbss_result result, const char *format, ...)
    VBSS_PRINTF(3, 4);
void vbss_message(vbss_context *context, vbss_log_level level, const char *format, ...)
    VBSS_PRINTF(3, 4);
/* Around every call of a function of the host: until the end, calls that would change the context
 * are VBSS_ERROR_BUSY. Callbacks nest; `end` takes what `begin` returned. */
bool vbss_callback_begin(vbss_context *context);
void vbss_callback_end(vbss_context *context, bool outer);

#endif
