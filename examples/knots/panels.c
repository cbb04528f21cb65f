/* Strips of pixels, and drawings within a drawing. */
#include "knots/panels.h"

#include <stdio.h>
#include <string.h>

enum { SEAM = 2 }; /* pixels */

void panels_put(const uint8_t *panel, int width, int height, size_t index, size_t count,
                uint8_t *strip)
{
    const size_t row_bytes = (size_t)3 * (size_t)width;
    for (size_t row = 0; row < (size_t)height; row++) {
        uint8_t *to = strip + row_bytes * (row * count + index);
        memcpy(to, panel + row_bytes * row, row_bytes);
        memset(to, 0xff, index > 0 ? (size_t)3 * SEAM : 0);
    }
}

/* An element <svg> within another stands at x, and is cut off at its borders. */
static bool append(FILE *to, const char *path, int x)
{
    static const char head[] = "<svg";
    char piece[4096];
    FILE *from = fopen(path, "rb");
    if (from == NULL) {
        return false;
    }
    size_t bytes = fread(piece, 1, sizeof head - 1, from);
    bool good = bytes == sizeof head - 1 && memcmp(piece, head, bytes) == 0 &&
                fprintf(to, "%s x=\"%d\"", head, x) > 0;
    while (good && (bytes = fread(piece, 1, sizeof piece, from)) > 0) {
        good = fwrite(piece, 1, bytes, to) == bytes;
    }
    good = good && ferror(from) == 0;
    fclose(from);
    return good;
}

bool panels_join(const char *path, int width, int height, size_t count)
{
    FILE *to = fopen(path, "wb");
    if (to == NULL) {
        return false;
    }
    int all = (int)count * width;
    bool good = fprintf(to,
                        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" "
                        "viewBox=\"0 0 %d %d\">\n",
                        all, height, all, height) > 0;
    for (size_t i = 0; i < count; i++) {
        char part[1100];
        snprintf(part, sizeof part, "%s.%u", path, (unsigned)i);
        good = good && append(to, part, (int)i * width);
        (void)remove(part);
    }
    good = fprintf(to, "</svg>\n") > 0 && good;
    return fclose(to) == 0 && good;
}
