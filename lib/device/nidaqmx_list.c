/* Lists the devices that the NI-DAQmx driver knows. */
#include <string.h>

#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "device/nidaqmx.h"

/* Appends a text, truncated to the room that is left. */
static void append(char *text, uint32_t bytes, const char *more)
{
    size_t used = strlen(text);
    vbss_device_copy_text(text + used, bytes - used, more);
}

static vbss_result list_devices(vbss_context *context, const daq_functions *daq, char *text,
                                uint32_t bytes)
{
    char names[1024] = "", product[DAQ_NAME_BYTES];
    if (daq->is_base) {
        return vbss_fail(context, VBSS_ERROR_DEVICE,
                         "NI-DAQmx Base has no list of devices: run its program lsdaq");
    }
    int32_t code = daq->get_device_names(names, sizeof names);
    VBSS_TRY(vbss_nidaqmx_check(context, daq, code, "devices"));
    names[sizeof names - 1] = '\0';
    if (names[0] == '\0') {
        return vbss_nidaqmx_check(context, daq, DAQ_NO_DEVICE, "the driver knows no device");
    }
    for (char *name = names; *name != '\0';) { /* separated by a comma and a space */
        char *end = name;
        while (*end != '\0' && *end != ',') {
            end++;
        }
        char *next = *end == ',' ? end + 1 : end;
        *end = '\0';
        product[0] = '\0';
        if (daq->get_product(name, product, sizeof product) < 0) {
            product[0] = '\0';
        }
        product[sizeof product - 1] = '\0';
        append(text, bytes, name);
        append(text, bytes, "  ");
        append(text, bytes, product);
        append(text, bytes, "\n");
        while (*next == ' ') {
            next++;
        }
        name = next;
    }
    return VBSS_OK;
}

vbss_result vbss_nidaqmx_list_devices(vbss_context *context, const char *library, char *text,
                                      uint32_t bytes)
{
    VBSS_ENTER(context);
    daq_functions daq = {.library = NULL};
    VBSS_TRY(vbss_context_edit(context));
    VBSS_TRY(vbss_check_pointer(context, text, "text"));
    VBSS_TRY(vbss_check_range(context, bytes, 1.0, 4294967295.0, "bytes"));
    text[0] = '\0';
    vbss_result result = vbss_nidaqmx_load(context, library, &daq);
    result = result == VBSS_OK ? list_devices(context, &daq, text, bytes) : result;
    vbss_device_unload_library(daq.library);
    return result;
}
