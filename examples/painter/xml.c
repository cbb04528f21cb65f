/* Numbers, colours and text in XML, without printf, which knows locales. */
#include "xml.h"

#include <string.h>

void xml_put(bytes *to, const char *text)
{
    bytes_add(to, text, strlen(text));
}

void xml_number(bytes *to, double value)
{
    char digits[16];
    size_t at = sizeof digits;
    /* In hundredths; a picture has no place for more than the clamp leaves. */
    uint64_t rest = (uint64_t)floor(clamp(fabs(value), 0.0, 1e9) * 100.0 + 0.5);
    if (rest % 100 != 0) {
        if (rest % 10 != 0) {
            digits[--at] = (char)('0' + rest % 10);
        }
        digits[--at] = (char)('0' + rest / 10 % 10);
        digits[--at] = '.';
    }
    bool negative = value < 0.0 && rest > 0;
    rest /= 100;
    do {
        digits[--at] = (char)('0' + rest % 10);
        rest /= 10;
    } while (rest > 0);
    if (negative) {
        digits[--at] = '-';
    }
    bytes_add(to, digits + at, sizeof digits - at);
}

void xml_attribute(bytes *to, const char *name, double value)
{
    xml_put(to, " ");
    xml_put(to, name);
    xml_put(to, "=\"");
    xml_number(to, value);
    xml_put(to, "\"");
}

void xml_colour(bytes *to, const char *name, painter_colour colour)
{
    char code[] = "=\"#000000\"";
    for (int i = 0; i < 6; i++) {
        code[3 + i] = "0123456789abcdef"[colour >> (20 - 4 * i) & 15];
    }
    xml_put(to, " ");
    xml_put(to, name);
    xml_put(to, code);
}

/* ---- text */

/* Bytes of the character at s if XML may hold it, else 0. */
static size_t character_length(const unsigned char *s)
{
    if (s[0] < 0x80) {
        return s[0] >= 0x20 && s[0] != 0x7f ? 1 : 0;
    }
    size_t length = s[0] >= 0xf0 ? 4 : s[0] >= 0xe0 ? 3 : 2;
    if (s[0] < 0xc2 || s[0] > 0xf4) {
        return 0;
    }
    uint32_t code = s[0] & (0xffu >> (length + 1));
    for (size_t i = 1; i < length; i++) {
        if ((s[i] & 0xc0) != 0x80) {
            return 0;
        }
        code = code << 6 | (s[i] & 0x3fu);
    }
    bool too_long = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
    bool no_character = (code >= 0xd800 && code < 0xe000) || code > 0x10ffff || code == 0xfffe ||
                        code == 0xffff || code < 0xa0;
    return too_long || no_character ? 0 : length;
}

void xml_text(bytes *to, const char *text)
{
    const unsigned char *s = (const unsigned char *)text;
    while (*s != '\0') {
        size_t length = character_length(s);
        if (length == 0) {
            xml_put(to, "\xef\xbf\xbd");
            s++;
        } else if (*s == '<' || *s == '&' || *s == '>' || *s == '"') {
            xml_put(to, *s == '<' ? "&lt;" : *s == '&' ? "&amp;" : *s == '>' ? "&gt;" : "&quot;");
            s++;
        } else {
            bytes_add(to, s, length);
            s += length;
        }
    }
}
