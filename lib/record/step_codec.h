/* A step as bits, in which inputs like those of the step before take little room. The page
 * docs/session-log.md has the format. */
#ifndef VBSS_RECORD_STEP_CODEC_H
#define VBSS_RECORD_STEP_CODEC_H

#include "record/predictive_coding.h"
#include "record/record.h"

/* What a coder remembers of the steps before: all of it follows from the bits since the last step that
 * stands alone. */
typedef struct log_coder log_coder;
vbss_result vbss_log_make_coder(vbss_context *context, uint32_t input_capacity, log_coder **coder);
void vbss_log_free_coder(vbss_context *context, log_coder *coder); /* NULL does nothing */
/* The next step must stand alone: it is written so, and refused when it is read and does not. */
void vbss_log_reset_coder(log_coder *coder);
/* Bytes of an event in either form, at most. */
enum { LOG_MAX_EVENT_BYTES = 4 * LOG_MAX_VARINT_BITS / 8 };
/* Bytes that the step takes at most with that many events. */
size_t vbss_log_max_coded_bytes(const log_step *step, uint32_t event_count);
/* Writes the step and remembers it; the bytes that it took. */
size_t vbss_log_encode(log_coder *coder, const log_step *step, uint8_t *bytes, size_t capacity);
/* Reads the step behind so many and remembers it; NULL, or what is wrong, and then nothing is remembered. */
const char *vbss_log_decode(log_coder *coder, uint64_t steps_before, const uint8_t *bytes,
                            size_t count, log_step *step);

#endif
