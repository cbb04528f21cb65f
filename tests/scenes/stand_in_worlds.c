#include "scenes/stand_in_worlds.h"

#include "device/platform.h"

static void find(const char *library, const device_symbol *symbol)
{
    char text[DEVICE_TEXT_BYTES];
    void *handle = vbss_device_load_library(library, text, sizeof text);
    if (handle != NULL) {
        (void)vbss_device_find_symbols(handle, symbol, 1);
    }
}

const stand_in_hd_table *stand_in_arms_of(const char *library)
{
    const stand_in_hd_table *(*world)(void) = NULL;
    const device_symbol symbol = {"stand_in_hd", &world};
    find(library, &symbol);
    return world != NULL ? world() : NULL;
}

const stand_in_daq_table *stand_in_lines_of(const char *library)
{
    const stand_in_daq_table *(*world)(void) = NULL;
    const device_symbol symbol = {"stand_in_daq", &world};
    find(library, &symbol);
    return world != NULL ? world() : NULL;
}
