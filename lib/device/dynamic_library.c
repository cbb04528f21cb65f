/* Loads libraries of vendors at run time. */
#include <stdio.h>
#include <string.h>

#include "device/platform.h"

#if defined(_WIN32)

#include <windows.h>

/* Loads one library. On failure `absent` tells whether there is no such file, or else `text` says
 * what is wrong. */
static void *load(const char *name, bool *absent, char *text, size_t room)
{
    HMODULE library = LoadLibraryA(name);
    const unsigned long code = library == NULL ? GetLastError() : 0;
    *absent = code == ERROR_MOD_NOT_FOUND && GetFileAttributesA(name) == INVALID_FILE_ATTRIBUTES;
    if (code == ERROR_MOD_NOT_FOUND) {
        snprintf(text, room, "%s needs a library that is missing", name);
    } else if (code != 0) {
        snprintf(text, room, "%s cannot be loaded: system error %lu", name, code);
    }
    return (void *)library;
}

/* Keeps the library loaded: threads of the vendor may still run its code. */
void vbss_device_unload_library(void *library)
{
    (void)library;
}

static bool find(void *library, const device_symbol *symbol)
{
    FARPROC found = GetProcAddress((HMODULE)library, symbol->name);
    memcpy(symbol->address, &found, sizeof found);
    return found != NULL;
}

#elif defined(__wasi__)

static void *load(const char *name, bool *absent, char *text, size_t room)
{
    *absent = false;
    snprintf(text, room, "%s cannot be loaded: WebAssembly loads no libraries at run time", name);
    return NULL;
}

void vbss_device_unload_library(void *library)
{
    (void)library;
}

static bool find(void *library, const device_symbol *symbol)
{
    (void)library;
    (void)symbol;
    return false;
}

#else

#include <dlfcn.h>

static bool has_text(const char *text, const char *part)
{
    const size_t length = strlen(text), part_length = strlen(part);
    for (size_t i = 0; i + part_length <= length; i++) {
        if (memcmp(text + i, part, part_length) == 0) {
            return true;
        }
    }
    return false;
}

/* Length of the text before the first colon. */
static size_t name_length(const char *reason)
{
    size_t length = 0;
    while (reason[length] != '\0' && reason[length] != ':') {
        length++;
    }
    return length;
}

/* The loader's message starts with a file name: that of the library, or of another one that it
 * needs. */
static bool is_about(const char *reason, const char *name)
{
    const size_t length = strlen(name);
    return name_length(reason) == length && memcmp(reason, name, length) == 0;
}

/* Loads one library. On failure `absent` tells whether there is no such file, or else `text` says
 * what is wrong. */
static void *load(const char *name, bool *absent, char *text, size_t room)
{
    /* RTLD_NODELETE: threads of the vendor may still run its code after dlclose */
    void *library = dlopen(name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    const char *reason = library == NULL ? dlerror() : "";
    reason = reason != NULL ? reason : "no reason is given";
    const bool is_missing =
        has_text(reason, "cannot open shared object file") || has_text(reason, "No such file");
    *absent = is_missing && is_about(reason, name);
    if (is_missing) {
        snprintf(text, room, "%s needs %.*s, which is missing", name, (int)name_length(reason),
                 reason);
    } else {
        snprintf(text, room, "%s cannot be loaded: %s", name, reason);
    }
    return library;
}

void vbss_device_unload_library(void *library)
{
    if (library != NULL) {
        dlclose(library);
    }
}

static bool find(void *library, const device_symbol *symbol)
{
    void *found = dlsym(library, symbol->name);
    memcpy(symbol->address, &found, sizeof found); /* C cannot cast a data pointer to a function */
    return found != NULL;
}

#endif

static void append(char *text, size_t room, const char *before, const char *more)
{
    const size_t used = strlen(text);
    snprintf(text + used, room - used, "%s%s", before, more);
}

void *vbss_device_load_any(const char *const *names, size_t count, const char **loaded, char *text,
                           size_t room)
{
    char all[DEVICE_LOAD_TEXT_BYTES] = "no library";
    for (size_t i = 0; i < count; i++) {
        bool is_absent;
        void *library = load(names[i], &is_absent, text, room);
        *loaded = names[i];
        if (library != NULL || !is_absent) {
            return library;
        }
        append(all, sizeof all, i == 0 ? " " : ", ", names[i]);
    }
    vbss_device_copy_text(text, room, all);
    return NULL;
}

const char *vbss_device_find_symbols(void *library, const device_symbol *symbols, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (!find(library, &symbols[i])) {
            return symbols[i].name;
        }
    }
    return NULL;
}
