#include "still.h"

#include "painter/picture.h"

bool still_write(const char *path, const uint8_t *pixels, int width, int height)
{
    bytes file = {NULL, 0, 0, false};
    png_encode(&file, pixels, width, height);
    bool good = !file.failed && bytes_write(&file, path) == 0;
    bytes_free(&file);
    return good;
}
