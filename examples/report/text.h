/* A page that is being written. Whatever comes from outside goes through put_text. */
#ifndef VBSS_EXAMPLES_REPORT_TEXT_H
#define VBSS_EXAMPLES_REPORT_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct page page;

page *page_create(void); /* NULL: no memory */
void page_destroy(page *p);
/* False: the file cannot be written, or memory was short meanwhile. */
bool page_write(const page *p, const char *path);

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
/* Markup, as it stands: never with words from outside in its %s. */
void put(page *p, const char *format, ...);
/* Markup of any length, as it stands. */
void put_markup(page *p, const char *markup, size_t count);
/* Words: escaped; what is not UTF-8, and control characters, become U+FFFD. */
void put_text(page *p, const char *text);
/* The same of bytes that need not end with a zero. */
void put_bytes(page *p, const void *bytes, size_t count);
void put_base64(page *p, const uint8_t *bytes, size_t count);

#endif
