/* Fields of a public struct as a table, so that one visitor saves and reads them all. */
#ifndef VBSS_BASE_FIELDS_H
#define VBSS_BASE_FIELDS_H

#include <stddef.h>

#include "base/stream.h"

typedef enum vbss_field_type { VBSS_FIELD_U32, VBSS_FIELD_F64 } vbss_field_type;

typedef struct vbss_field {
    const char *name;
    size_t offset;
    vbss_field_type type; /* enums and signed words count as U32 */
    uint32_t count;
    uint16_t since; /* first version of the section that has the field */
} vbss_field;

#define VBSS_WORD_SINCE(type, name, since)                    \
    {                                                         \
#name, offsetof(type, name), VBSS_FIELD_U32, 1, since \
    }
#define VBSS_WORD(type, name) VBSS_WORD_SINCE(type, name, 1)
#define VBSS_NUMBERS_SINCE(type, name, count, since)              \
    {                                                             \
#name, offsetof(type, name), VBSS_FIELD_F64, count, since \
    }
#define VBSS_NUMBERS(type, name, count) VBSS_NUMBERS_SINCE(type, name, count, 1)
#define VBSS_NUMBER(type, name) VBSS_NUMBERS_SINCE(type, name, 1, 1)

/* Visits the values of a field if the version of the open section has it. */
void vbss_stream_field(vbss_stream *stream, uint16_t tag, const vbss_field *field, void *values);

/* Visits the fields that the version of the open section has. The index in the table is the tag, so
 * new fields are appended. */
void vbss_stream_fields(vbss_stream *stream, const vbss_field *fields, size_t count, void *object);

#endif
