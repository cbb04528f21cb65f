/* Memory: zeroed arrays, aligned for the wide lanes, given back with their size.
 * NULL always means failure, and the context holds the error; an empty array is a block too.
 * Releasing NULL is nothing. */
#ifndef VBSS_BASE_MEMORY_H
#define VBSS_BASE_MEMORY_H

#include <stddef.h>

#include <vblast_ss/base.h>

#define VBSS_ALIGNMENT 64u
void *vbss_allocate(vbss_context *context, size_t count, size_t size, const char *what);
void vbss_release(vbss_context *context, void *block, size_t count, size_t size);
/* Many arrays of one object, from a table that says what there is. Those that could not be had are NULL
 * if the object was zeroed; release them all the same. */
typedef struct vbss_array {
    void *pointer; /* address of the object's pointer to the array */
    size_t count, size;
} vbss_array;
vbss_result vbss_allocate_arrays(vbss_context *context, const vbss_array *arrays, size_t count,
                                 const char *what);
void vbss_release_arrays(vbss_context *context, const vbss_array *arrays, size_t count);

#endif
