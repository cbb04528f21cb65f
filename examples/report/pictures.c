/* Pictures beside the log, taken into the page. */
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "report/page.h"

enum { MAX_BYTES = 4 << 20, MAX_FILES = 1024, MAX_PATH = 1024 };

static bool is_named_png(const char *name)
{
    size_t length = strlen(name);
    return length > 4 && length < sizeof((picture *)0)->name &&
           strcmp(name + length - 4, ".png") == 0;
}

/* What does not begin as a PNG is none, whatever it is called. */
static bool read_png(const char *folder, picture *into)
{
    static const uint8_t signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    char path[MAX_PATH];
    int length = snprintf(path, sizeof path, "%s/%s", folder, into->name);
    FILE *file = length > 0 && length < MAX_PATH ? fopen(path, "rb") : NULL;
    if (file == NULL) {
        return false;
    }
    into->bytes = malloc(MAX_BYTES);
    into->count = into->bytes != NULL ? fread(into->bytes, 1, MAX_BYTES, file) : 0;
    bool whole = fgetc(file) == EOF && ferror(file) == 0;
    (void)fclose(file);
    if (whole && into->count > sizeof signature &&
        memcmp(into->bytes, signature, sizeof signature) == 0) {
        return true;
    }
    free(into->bytes);
    into->bytes = NULL;
    return false;
}

static int by_name(const void *a, const void *b)
{
    return strcmp(a, b);
}

bool pictures_read(pictures *p, const char *folder)
{
    static char names[MAX_FILES][sizeof p->all[0].name];
    size_t found = 0;
    DIR *open = opendir(folder);
    if (open == NULL) {
        return false;
    }
    p->folder = folder;
    for (const struct dirent *e = readdir(open); e != NULL; e = readdir(open)) {
        if (is_named_png(e->d_name) && found < MAX_FILES) {
            snprintf(names[found++], sizeof names[0], "%s", e->d_name);
        }
    }
    (void)closedir(open);
    qsort(names, found, sizeof names[0], by_name);
    for (size_t i = 0; i < found; i++) {
        picture *one = &p->all[p->count < MAX_PICTURES ? p->count : MAX_PICTURES - 1];
        bool room = p->count < MAX_PICTURES;
        if (room) {
            memcpy(one->name, names[i], sizeof one->name);
        }
        if (room && read_png(folder, one)) {
            p->count++;
        } else {
            p->left_out++;
        }
    }
    return true;
}

void pictures_free(pictures *p)
{
    for (size_t i = 0; i < p->count; i++) {
        free(p->all[i].bytes);
    }
}

void page_pictures(page *p, const pictures *s)
{
    if (s->folder == NULL) {
        return;
    }
    put(p, "<section aria-labelledby=\"pictures\"><h2 id=\"pictures\">Pictures</h2>\n");
    if (s->count == 0) {
        put(p, "<p class=\"absent\">There is no PNG in the folder that was named.</p>\n");
    }
    put(p, "<div class=\"pictures\">\n");
    for (size_t i = 0; i < s->count; i++) {
        put(p, "<figure><img alt=\"picture ");
        put_text(p, s->all[i].name);
        put(p, "\" src=\"data:image/png;base64,");
        put_base64(p, s->all[i].bytes, s->all[i].count);
        put(p, "\"/><figcaption>");
        put_text(p, s->all[i].name);
        put(p, "</figcaption></figure>\n");
    }
    put(p, "</div>\n");
    if (s->left_out > 0) {
        put(p,
            "<p class=\"note\">%u more were left out: beyond %d, larger than %d MB, or no "
            "PNG.</p>\n",
            (unsigned)s->left_out, MAX_PICTURES, MAX_BYTES >> 20);
    }
    put(p, "</section>\n");
}
