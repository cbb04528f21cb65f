/* Loads the NI-DAQmx library and interprets its errors. */
#include "base/error.h"
#include "device/nidaqmx.h"

#ifdef _WIN32
#define USUAL_NAME "nicaiu.dll"
#else
#define USUAL_NAME "libnidaqmx.so.1"
#endif

vbss_result vbss_nidaqmx_load(vbss_context *context, const char *name, daq_functions *daq)
{
    const device_symbol symbols[] = {
        {"DAQmxCreateTask", &daq->create_task},
        {"DAQmxStartTask", &daq->start_task},
        {"DAQmxStopTask", &daq->stop_task},
        {"DAQmxClearTask", &daq->clear_task},
        {"DAQmxCreateAIVoltageChan", &daq->create_voltage_input},
        {"DAQmxCreateDOChan", &daq->create_digital_output},
        {"DAQmxReadAnalogF64", &daq->read_analog},
        {"DAQmxWriteDigitalLines", &daq->write_digital},
        {"DAQmxGetExtendedErrorInfo", &daq->get_extended_error},
        {"DAQmxGetSysDevNames", &daq->get_device_names},
        {"DAQmxGetDevProductType", &daq->get_product},
    };
    char text[DEVICE_TEXT_BYTES] = "";
    name = name != NULL ? name : USUAL_NAME;
    daq->library = vbss_device_load_library(name, text, sizeof text);
    if (daq->library == NULL) {
        return vbss_fail(context, VBSS_ERROR_DEVICE, "NI-DAQmx: no library %s: %s", name, text);
    }
    const char *missing =
        vbss_device_find_symbols(daq->library, symbols, sizeof symbols / sizeof symbols[0]);
    if (missing != NULL) {
        return vbss_fail(context, VBSS_ERROR_DEVICE, "NI-DAQmx: %s has no %s", name, missing);
    }
    return VBSS_OK;
}

/* ---- errors */

static const struct {
    int32_t code;
    bool lost;
    const char *name;
} errors[] = {
    {-200221, false, "timeout"},
    {-200284, false, "no sample in time"},
    {-200279, false, "samples were overwritten"},
    {-200220, true, "no such device"},
    {-200170, true, "no such channel"},
    {-200088, true, "no such task"},
    {-200045, true, "device removed"},
    {-50103, true, "in use by another program"},
    {-200846, true, "written to while it is stopped"},
    {-200077, true, "a setting it does not have"},
    {-200562, true, "neither 0 nor 1 to a line"},
};

const char *vbss_nidaqmx_error_name(int32_t code)
{
    for (size_t i = 0; i < sizeof errors / sizeof errors[0]; i++) {
        if (errors[i].code == code) {
            return errors[i].name;
        }
    }
    return code == 0 ? "no error" : code > 0 ? "a warning" : "an error without a name";
}

/* After an unknown error the hardware counts as lost. */
bool vbss_nidaqmx_is_lost(int32_t code)
{
    for (size_t i = 0; i < sizeof errors / sizeof errors[0]; i++) {
        if (errors[i].code == code) {
            return errors[i].lost;
        }
    }
    return code < 0;
}

vbss_result vbss_nidaqmx_check(vbss_context *context, const daq_functions *daq, int32_t code,
                               const char *what)
{
    if (code >= 0) {
        return VBSS_OK;
    }
    char text[256] = "";
    if (daq->get_extended_error(text, sizeof text) < 0) {
        text[0] = '\0';
    }
    text[sizeof text - 1] = '\0';
    for (char *c = text; *c != '\0'; c++) { /* the message must be one line */
        if (*c == '\n' || *c == '\r') {
            *c = ' ';
        }
    }
    return vbss_fail(context, VBSS_ERROR_DEVICE, "NI-DAQmx: %s: %s (%d) %s", what,
                     vbss_nidaqmx_error_name(code), code, text);
}
