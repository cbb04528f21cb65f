/* Loads libraries of vendors at run time. */
#include <string.h>

#include "device/platform.h"

#ifdef _WIN32

#include <stdio.h>
#include <windows.h>

void *vbss_device_load_library(const char *name, char *text, size_t room)
{
    HMODULE library = LoadLibraryA(name);
    if (library == NULL) {
        snprintf(text, room, "system error %lu", GetLastError());
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

#else

#include <dlfcn.h>

void *vbss_device_load_library(const char *name, char *text, size_t room)
{
    /* RTLD_NODELETE: threads of the vendor may still run its code after dlclose */
    void *library = dlopen(name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (library == NULL) {
        const char *reason = dlerror();
        vbss_device_copy_text(text, room, reason != NULL ? reason : "no reason is given");
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

const char *vbss_device_find_symbols(void *library, const device_symbol *symbols, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (!find(library, &symbols[i])) {
            return symbols[i].name;
        }
    }
    return NULL;
}
