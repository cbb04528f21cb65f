/* A session log as text: what the commands of vbss-log print. */
#ifndef VBSS_EXAMPLES_SESSION_LOG_EXPORT_H
#define VBSS_EXAMPLES_SESSION_LOG_EXPORT_H

#include <stdio.h>

#include <vblast_ss/vblast_ss.h>

typedef struct log_file {
    uint8_t *bytes;
    uint64_t count;
} log_file;

/* Each returns what reading ended with: VBSS_OK for a log that is whole, VBSS_ERROR_TRUNCATED for one that is cut off,
 * of which all complete steps are printed. */
vbss_result print_info(FILE *out, vbss_context *context, const log_file *log);
vbss_result print_faults(FILE *out, vbss_context *context, const log_file *log);
vbss_result print_csv(FILE *out, vbss_context *context, const log_file *log);
vbss_result print_json(FILE *out, vbss_context *context, const log_file *log);

const char *input_name(vbss_record_input_kind kind);
const char *event_name(uint32_t kind);

#endif
