/* Coding of a step as bits. Inputs that resemble those of the step before take few bits. The format
 * is in docs/reference/session-log.md. */
#ifndef VBSS_RECORD_STEP_CODEC_H
#define VBSS_RECORD_STEP_CODEC_H

#include "record/predictive_coding.h"
#include "record/record.h"

/* History of the steps so far. It follows from the coded steps since the last standalone one. */
typedef struct log_coder log_coder;

/* Returns VBSS_OK or VBSS_ERROR_OUT_OF_MEMORY; in both cases vbss_log_free_coder frees the
 * coder. */
vbss_result vbss_log_make_coder(vbss_context *context, uint32_t input_capacity, log_coder **coder);
void vbss_log_free_coder(vbss_context *context, log_coder *coder); /* NULL does nothing */
/* Clears the history. The next step is written standalone; when reading, any other step is
 * refused. */
void vbss_log_reset_coder(log_coder *coder);
/* Bytes of an event in either form, at most. */
enum { LOG_MAX_EVENT_BYTES = 4 * LOG_MAX_VARINT_BITS / 8 };
/* Whether all kinds of inputs fit into their bits. */
bool vbss_log_can_encode(const log_step *step);
/* Largest size of the coded step with this number of events, bytes. */
size_t vbss_log_max_coded_bytes(const log_step *step, uint32_t event_count);
/* Codes a step and adds it to the history. Returns the number of bytes. */
size_t vbss_log_encode(log_coder *coder, const log_step *step, uint8_t *bytes, size_t capacity);
/* Decodes a step and adds it to the history. `steps_before` is the number of steps so far. Returns
 * NULL, or a string literal that names the problem; the step is then not in the history. */
const char *vbss_log_decode(log_coder *coder, uint64_t steps_before, const uint8_t *bytes,
                            size_t count, log_step *step);

#endif
