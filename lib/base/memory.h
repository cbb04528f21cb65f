/* Zeroed arrays from the context's allocator, aligned for wide SIMD registers.
 *
 * The caller frees an array with its size. An allocation returns NULL only on failure, and the
 * context then holds the error. An empty array has a block too. Releasing NULL does nothing. */
#ifndef VBSS_BASE_MEMORY_H
#define VBSS_BASE_MEMORY_H

#include <stddef.h>

#include <vblast_ss/base.h>

#define VBSS_ALIGNMENT 64u
/* Allocates `count` elements of `size` bytes; `what` names them in an error text. */
void *vbss_allocate(vbss_context *context, size_t count, size_t size, const char *what);
/* Frees a block that was allocated with this count and size. */
void vbss_release(vbss_context *context, void *block, size_t count, size_t size);
/* Bytes of the context that are allocated now. */
uint64_t vbss_bytes_allocated(const vbss_context *context);
/* Several arrays of one object, described by a table. The object must be zeroed first: after a
 * failure the arrays not allocated are NULL, and the caller releases the whole table. */
typedef struct vbss_array {
    void *pointer;      /* address of the object's pointer to the array */
    size_t count, size; /* elements, and bytes per element */
} vbss_array;
/* VBSS_ERROR_OUT_OF_MEMORY if one of the arrays cannot be allocated. */
vbss_result vbss_allocate_arrays(vbss_context *context, const vbss_array *arrays, size_t count,
                                 const char *what);
void vbss_release_arrays(vbss_context *context, const vbss_array *arrays, size_t count);

#endif
