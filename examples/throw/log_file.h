/* The file of a log. One program at a time writes it, which Windows and WebAssembly do not check. It has each piece of a record
 * as a whole or not at all. An error is printed once, with the path and the reason. */
#ifndef VBSS_EXAMPLES_THROW_LOG_FILE_H
#define VBSS_EXAMPLES_THROW_LOG_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct log_file {
    const char *path; /* NULL: no log is written; must outlive the file */
    int descriptor;
    int64_t size;    /* bytes of all complete pieces */
    bool has_failed; /* the error is printed; nothing is written any more */
} log_file;

/* Creates or empties the file at `path`; NULL: writes no log. A file that another program is writing stays as it is.
 * Returns false if it cannot be written. */
bool log_file_open(log_file *f, const char *path);
/* Appends a piece of the log. It is with the system when the call returns, so a killed program loses none of it. On failure,
 * as with a full disk or quota, the file ends after the piece before. */
bool log_file_write(log_file *f, const uint8_t *bytes, size_t count);
void log_file_close(log_file *f);

#endif
