#include "report/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "painter/xml.h"

enum { PIECE = 1024 };

struct page {
    bytes held;
};

page *page_create(void)
{
    return calloc(1, sizeof(page));
}

void page_destroy(page *p)
{
    if (p != NULL) {
        bytes_free(&p->held);
        free(p);
    }
}

bool page_write(const page *p, const char *path)
{
    return !p->held.failed && bytes_write(&p->held, path) == 0;
}

void put(page *p, const char *format, ...)
{
    char piece[PIECE];
    va_list values;
    va_start(values, format);
    int length = vsnprintf(piece, sizeof piece, format, values);
    va_end(values);
    if (length < 0 || length >= PIECE) {
        p->held.failed = true; /* half a tag would be worse than no page */
        return;
    }
    bytes_add(&p->held, piece, (size_t)length);
}

void put_markup(page *p, const char *markup, size_t count)
{
    bytes_add(&p->held, markup, count);
}

void put_text(page *p, const char *text)
{
    xml_text(&p->held, text);
}

void put_bytes(page *p, const void *data, size_t count)
{
    char *text = malloc(count + 1);
    if (text == NULL) {
        p->held.failed = true;
        return;
    }
    memcpy(text, data, count);
    text[count] = '\0';
    for (size_t i = 0; i < count; i++) {
        text[i] = (char)(text[i] == '\0' ? 1 : text[i]); /* seen, and not the end */
    }
    put_text(p, text);
    free(text);
}

void put_base64(page *p, const uint8_t *data, size_t count)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < count; i += 3) {
        uint32_t three = (uint32_t)data[i] << 16;
        three |= i + 1 < count ? (uint32_t)data[i + 1] << 8 : 0;
        three |= i + 2 < count ? data[i + 2] : 0;
        char four[4] = {digits[three >> 18], digits[three >> 12 & 63], digits[three >> 6 & 63],
                        digits[three & 63]};
        if (i + 1 >= count) {
            four[2] = '=';
        }
        if (i + 2 >= count) {
            four[3] = '=';
        }
        bytes_add(&p->held, four, sizeof four);
    }
}
