/* Entry and exit of every public function.
 *
 * VBSS_ENTER takes the context for the calling thread and sets the floating-point mode that the
 * library needs. Both end with the function, on every return. gate.entry checks that each exported
 * function enters. */
#ifndef VBSS_BASE_API_CALL_H
#define VBSS_BASE_API_CALL_H

#include <stdbool.h>

#include <vblast_ss/base.h>

#include "base/error.h"
#include "base/float_mode.h"

typedef struct vbss_call {
    vbss_context *context; /* NULL if the call has none, or is inside another call */
    float_mode host_mode;  /* the mode to restore */
    float_mode outer_mode; /* host_mode of the call whose callback made this one */
    bool is_outermost;     /* gives the context up at its end */
} vbss_call;

/* `handle` is a context, any handle, or NULL for a function without either. Calls nest: a public
 * function may call another, and a callback may call the library. VBSS_ERROR_BUSY, without an error
 * text, if another thread is inside the context. VBSS_ERROR_ARITHMETIC_MODE if the host's mode is
 * wrong and the library cannot set it on this processor. */
vbss_result vbss_call_enter(vbss_call *call, const void *handle);
/* Must follow vbss_call_enter, whatever that returned. */
void vbss_call_leave(vbss_call *call);

/* The first statement of a public function that returns a status. */
#define VBSS_ENTER(handle)                                     \
    __attribute__((cleanup(vbss_call_leave))) vbss_call call_; \
    VBSS_TRY(vbss_call_enter(&call_, handle))
/* VBSS_ENTER for a function that returns a pointer in *out, which is NULL on every failure. */
#define VBSS_ENTER_WITH_RESULT(handle, out) \
    if ((out) != NULL) {                    \
        *(out) = NULL;                      \
    }                                       \
    VBSS_ENTER(handle)

#endif
